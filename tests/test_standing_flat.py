"""Cylinders and disks that stand flat: the supporting circle, beside point contacts on the rim and closed forms.

A cylinder of radius r and height h on a slope slides where tan(alpha) > mu and tips where tan(alpha) > 2 r/h; pushed at
the height c it tips at P = m g r/c: Meriam & Kraige, Statics, sec. 6/3. What presses on a circle presses on its rim:
a force in a place between two points of the rim is shared by these, so a ring of feet on the rim holds as much where
one of them is where the body tips.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.engine.course import Status

G = 9.81
ON_SLOPE = """
space: true
parameters: {m: 2 kg, r: 0.1 m, h: 0.3 m, alpha: 10 deg, mu: MU, g: 9.81 m/s^2, P: {value: PUSH N, sign: any}}
ground: {planes: {slope: {normal: [sin(alpha), cos(alpha), 0]}}}
bodies: {can: {SHAPE, turned: -alpha about z}}
connections: {it: {contact: {between: [can, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}, push: {force: {at: can, along: [0, 0, 1], magnitude: P}}}
"""
CAN = "cylinder: {mass: m, radius: r, length: h, axis: y}"
PIPE = "hollow_cylinder: {mass: m, radius: r, inner_radius: r/2, length: h, axis: y}"
ON_BOX = """
space: true
parameters: {m: 2 kg, r: 0.1 m, h: 0.3 m, c: 0.25 m, mu: MU, g: 9.81 m/s^2, P: {value: 1 N, sign: any}}
bodies:
  table: {box: {mass: 1, size: [1, 0.4, 0.8]}, fixed: true, at: [0, -0.2, 0]}
  can: {cylinder: {mass: m, radius: r, length: h, axis: y}, at: [AT, h/2, 0], points: {top: [0, c - h/2, 0]}}
connections: {it: {contact: {between: [can, table], friction: mu}}}
loads: {weight: {gravity: g}, push: {force: {at: can.top, along: [0.6, 0, 0.8], magnitude: P}}}
"""


def slope(mu: float, shape: str = CAN, push: float = 0.0) -> str:
    return ON_SLOPE.replace("MU", str(mu)).replace("SHAPE", shape).replace("PUSH", str(push))


def asked(model: str, question: str) -> fb.Answer:
    [answer] = fb.System.from_text(model).solve(question).answers
    return answer


@pytest.mark.parametrize("shape", [CAN, PIPE])
@pytest.mark.parametrize(("mu", "words"), [(0.5, "can slips on slope"), (0.8, "can tips about its rim on slope")])
def test_can_on_a_slope_slides_or_tips(mu: float, words: str, shape: str) -> None:
    answer = asked(slope(mu, shape), "largest alpha so that it stays at rest")
    assert answer.expression is not None
    assert answer.value == pytest.approx(math.atan(min(mu, 2 / 3)), rel=1e-9)
    assert any(words in note for note in answer.notes)


def test_it_tips_first_where_the_circle_is_small_beside_friction() -> None:
    alone = slope(0.5).replace(", push: {force: {at: can, along: [0, 0, 1], magnitude: P}}", "")
    answer = asked(alone, "range of mu for which it tips before it slides as alpha grows")
    assert answer.value == pytest.approx(2 / 3)


def test_push_across_the_slope_adds_to_the_weight_in_the_supporting_circle() -> None:
    """|c| = h/2 sqrt((m g sin)^2 + P^2)/(m g cos) = r."""
    answer = asked(slope(0.8, push=1.0), "largest P so that it stays at rest")
    s, c = math.sin(math.radians(10)), math.cos(math.radians(10))
    assert answer.value == pytest.approx(2 * G * math.sqrt((2 * 0.1 * c / 0.3) ** 2 - s * s), rel=1e-9)


def test_can_that_is_pushed_high_tips_as_three_feet_on_its_rim_do() -> None:
    """P = m g r/c along a foot, of a body on points of the rim one of which is where it tips."""
    model = ON_BOX.replace("MU", "0.8").replace("AT", "0")
    answer = asked(model, "largest P so that it stays at rest")
    assert answer.value == pytest.approx(2 * G * 0.1 / 0.25, rel=1e-9)
    feet = [(0.6, 0.8), (-0.8, 0.6), (-0.6, -0.8), (0.8, -0.6)]
    points = ", ".join(f"p{k}: [{x}*r, -h/2, {z}*r]" for k, (x, z) in enumerate(feet))
    contacts = "".join(
        f"  c{k}: {{contact: {{between: [can.p{k}, ground.floor], friction: mu, touching: true}}}}\n" for k in range(4)
    )
    standing = f"""
space: true
parameters: {{m: 2 kg, r: 0.1 m, h: 0.3 m, c: 0.25 m, mu: 0.8, g: 9.81 m/s^2, P: 1 N}}
ground: {{planes: {{floor: {{normal: up}}}}}}
bodies: {{can: {{{CAN}, at: [0, h/2, 0], points: {{top: [0, c - h/2, 0], {points}}}}}}}
connections:
{contacts}loads: {{weight: {{gravity: g}}, push: {{force: {{at: can.top, along: [0.6, 0, 0.8], magnitude: P}}}}}}
"""
    assert asked(standing, "largest P so that it stays at rest").value == pytest.approx(answer.value, rel=1e-7)


def test_where_friction_had_to_turn_it_about_the_normal_nothing_is_said() -> None:
    """Weight along the slope at h/2, a push across it at the top: M . T is not zero."""
    model = slope(0.5, push=2.0).replace("SHAPE", CAN).replace("at: can,", "at: can.end,")
    answer = asked(model, "least mu so that it stays at rest")
    assert answer.expression is None
    assert "a moment about the normal as well" in answer.reason


def test_two_cans_on_one_floor_tip_each_for_itself() -> None:
    two = """
space: true
parameters: {m: 2 kg, r: 0.1 m, h: 0.3 m, mu: 0.9, g: 9.81 m/s^2, P: {value: 1 N, sign: any}}
ground: {planes: {floor: {normal: up}}}
bodies:
  one: {cylinder: {mass: m, radius: r, length: h, axis: y}, at: [0, h/2, 0]}
  two: {cylinder: {mass: m, radius: r, length: h, axis: y}, at: [1 m, h/2, 0]}
connections: {it: {contact: {among: [one, two, ground.floor], friction: mu}}}
loads:
  weight: {gravity: g}
  push: {force: {at: one, along: [0, 0, 1], magnitude: P}}
  other: {force: {at: two, along: [1, 0, 0], magnitude: P}}
""".replace("{among: [one, two, ground.floor], friction: mu}", "{between: [one, ground.floor], friction: mu}")
    two = two.replace("loads:", "  that: {contact: {between: [two, ground.floor], friction: mu}}\nloads:")
    two = two.replace("connections: {it:", "connections:\n  it:").replace(
        "friction: mu}}}\n  that", "friction: mu}}\n  that"
    )
    answer = asked(two, "largest P so that it stays at rest")
    assert answer.value == pytest.approx(2 * G * 0.2 / 0.3, rel=1e-9)


# -- in motion ------------------------------------------------------------------------------------
FLOOR = """
space: true
ground: {planes: {floor: {normal: up}}}
bodies: {can: {cylinder: {mass: 2 kg, radius: 0.1 m, length: 0.3 m, axis: y}, at: [0, HEIGHT, 0]MORE}}
connections: {contact: {contact: {between: [can, ground.floor], friction: MU}}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""


def moved(height: float, mu: float, more: str = "", until: float = 0.5) -> fb.Simulation:
    model = FLOOR.replace("HEIGHT", str(height)).replace("MU", str(mu)).replace("MORE", more)
    return fb.System.from_text(model).simulate(until)


@pytest.mark.parametrize("model", ["floor", pytest.param("box", marks=pytest.mark.slow)])
def test_upright_can_slides_to_rest_by_mu_g_without_tipping(model: str) -> None:
    more = ", velocity: [0.6, 0, -0.8]"
    if model == "floor":
        found = moved(0.15, 0.3, more)
    else:
        text = (
            ON_BOX.replace("MU", "0.3").replace("AT, h/2, 0]", "0, h/2, 0]" + more).replace("value: 1 N", "value: 0 N")
        )
        found = fb.System.from_text(text).simulate(0.5)
    assert found.course.status is Status.FINISHED, found.course.message
    assert {e.kind: e.time for e in found.course.events} == {"stops slipping": pytest.approx(1 / (0.3 * G), rel=1e-9)}
    way = found.course.poses[-1, 0, :3] - found.course.poses[0, 0, :3]
    assert way == pytest.approx(np.array((0.6, 0, -0.8)) / (0.6 * G), abs=1e-8)


def test_upright_can_falls_flat_and_stands() -> None:
    found = moved(0.2, 0.3)
    assert found.course.status is Status.FINISHED, found.course.message
    assert [e.time for e in found.course.events] == [pytest.approx(math.sqrt(0.1 / G), rel=1e-9)]
    assert found.course.poses[-1, 0, :3] == pytest.approx((0, 0.15, 0), abs=1e-9)


def test_across_the_edge_of_a_box_it_is_refused_where_it_gets_there() -> None:
    text = ON_BOX.replace("MU", "0.2").replace("AT, h/2, 0]", "0, h/2, 0], velocity: [3, 0, 0]")
    found = fb.System.from_text(text.replace("value: 1 N", "value: 0 N")).simulate(0.5)
    assert found.course.status is Status.INCONSISTENT
    assert "can.start lies flat across an edge of table.top" in found.course.message
    assert found.course.poses[-1, 0, 0] == pytest.approx(0.4, abs=1e-5)
    answer = asked(ON_BOX.replace("MU", "0.2").replace("AT", "0.45"), "does it hold")
    assert "lies flat across an edge of table.top" in str(answer)


def test_a_pipe_stands_on_a_box_as_a_can_does_and_says_that_its_bore_is_left_out() -> None:
    pipe = ON_BOX.replace(
        "cylinder: {mass: m, radius: r, ", "hollow_cylinder: {mass: m, radius: r, inner_radius: r/2, "
    )
    system = fb.System.from_text(pipe.replace("MU", "0.8").replace("AT", "0"))
    [answer] = system.solve("largest P so that it stays at rest").answers
    assert answer.value == pytest.approx(2 * G * 0.1 / 0.25, rel=1e-9)
    assert "can is not convex: in contacts its convex hull touches" in map(str, system.assumptions)


def test_rough_end_that_spins_is_refused_unless_its_resistance_is_given() -> None:
    """Even pressure: the integral of mu p s dA = 2/3 mu N r, so that omega falls by 4 mu g/(3 r)."""
    spun = ", angular_velocity: [0, 10, 0]"
    refused = moved(0.15, 0.3, spun)
    assert refused.course.status is Status.INCONSISTENT
    assert "can.start spins on floor at t = 0 s" in refused.course.message
    even = FLOOR.replace("friction: MU", "friction: 0.3, spinning_resistance: 0.02 m")
    found = fb.System.from_text(even.replace("HEIGHT", "0.15").replace("MORE", spun)).simulate(0.5)
    assert found.course.status is Status.FINISHED, found.course.message
    assert [e.time for e in found.course.events] == [pytest.approx(10 * 3 * 0.1 / (4 * 0.3 * G), rel=1e-9)]


def test_moment_about_the_normal_sets_it_spinning_and_without_friction_nothing_resists() -> None:
    """Of a moment C t, J omega = C t^2/2 and the work J omega^2/2."""
    twisted = "parameters: {C: 0.1 N m/s}" + FLOOR.replace("HEIGHT", "0.15").replace("MORE", "").replace(
        "weight: {", "twist: {torque: {on: can, about: y, magnitude: C*t}}, weight: {"
    )
    rough = fb.System.from_text(twisted.replace("MU", "0.3")).simulate(0.5)
    assert rough.course.status is Status.INCONSISTENT
    assert "can.start spins on floor at t = " in rough.course.message
    assert rough.course.t_end < 0.001
    smooth = fb.System.from_text(twisted.replace("MU", "0")).simulate(0.5)
    assert smooth.course.status is Status.FINISHED, smooth.course.message
    assert smooth.course.work[-1].sum() == pytest.approx((0.05 * 0.5**2) ** 2 / (2 * 0.5 * 2 * 0.1**2), rel=1e-8)
