"""Where both routes were of different opinions on random models: what each of them took wrongly, by hand.

Every model here is the smallest that shows one cause: an angle counted without its turns, a root of the wrong sign, a
coordinate that is singular where the motion starts, round-off beside a fast rotation, principal axes that change.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.errors import CannotAnswer, ModelError
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrix, rotation_vector
from freebody.study.setup import Setup

ROD_ON_SHAFT = """
space: true
parameters: {{W: {W} rad/s, m: 1 kg, L: 1 m}}
bodies:
  shaft: {{body: {{mass: 1 kg, inertia: 1 kg m^2}}}}
  rod: {{rod: {{mass: m, length: L}}, near: {{at: [0.3 m, -0.4 m, 0]}}}}
connections:
  bearing: {{revolute: {{first: ground.origin, second: shaft.origin, about: up}}}}
  drive: {{driver: {{measure: psi, follows: W*t}}}}
  hinge: {{revolute: {{first: shaft.origin, second: rod.start, about: z}}}}
measures: {{psi: angle of shaft about up, th: angle of rod about z relative to shaft}}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
start: {{th: {th} deg, rate(th): 0}}
"""


def test_a_spring_feels_the_turns_of_an_angle_that_a_loop_binds() -> None:
    """sin(b) = sin(a)/2 with b about half a turn: b = pi - asin(sin(a)/2), not b - 2 pi. At rest at a = -30 deg the
    spring c b on the second wheel gives a the acceleration -c b s/(I + I s^2) with s = db/da = cos(a)/(2 cos(b))."""
    system = fb.System.from_text("""
parameters: {c: 2 N m, I: 3 kg m^2}
bodies:
  first: {body: {mass: 1 kg, inertia: I}}
  second: {body: {mass: 1 kg, inertia: I}, near: {angle: 200 deg}}
connections:
  p: {pin: [ground.O, first]}
  q: {pin: [ground.O, second]}
  loop: {constraint: {expression: sin(a) - 2*sin(b)}}
measures: {a: angle of first, b: angle of second}
loads: {twist: {torsional_spring: {body: second, stiffness: c}}}
start: {a: -30 deg, rate(a): 0}
questions: [{find: acceleration of a}]
""")
    (answer,) = system.solve().answers
    b = math.pi + math.asin(0.25)
    slope = math.cos(math.radians(-30.0)) / (2.0 * math.cos(b))
    assert answer.reason == ""
    assert answer.value == pytest.approx(-2.0 * b * slope / (3.0 * (1.0 + slope**2)), rel=1e-9)


def test_a_root_keeps_the_side_on_which_the_model_starts() -> None:
    """A box hangs by its centre; where its end is in the plane of x and y does not tell on which side of that plane it
    is. What is told of it holds on one side, and says so."""
    system = fb.System.from_text("""
space: true
ground: {points: {B: [0.5 m, 2 m, 0.3 m]}, planes: {floor: {normal: [1, 1, 0]}}}
bodies: {p: {box: {mass: 0.2 kg, size: [1 m, 0.2 m, 0.125 m]}}}
connections: {c: {universal: {first: p.mass_center, second: ground.B, arm: down, second_arm: floor}}}
measures: {u: angle of line from p.right to ground.B clockwise}
start: {u: 0, rate(u): 0}
questions: [{find: z of p.right}]
""")
    (answer,) = system.solve().answers
    assert "defect" not in answer.reason
    if answer.expression is not None:
        assert answer.conditions


def test_a_free_particle_does_not_rest_in_the_origin_of_its_polar_coordinates() -> None:
    """In d and u the forces are -m g sin(u) and -m g d cos(u): both vanish at d = u = 0, where u is no coordinate."""
    (answer,) = (
        fb.System.from_text("""
bodies: {p: {particle: {mass: 2 kg}, at: [1 m, 0.5 m]}}
measures: {u: angle of line from ground.O to p, d: distance from ground.O to p}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: [{find: equilibrium of u}]
""")
        .solve()
        .answers
    )
    assert "no equilibrium" in answer.reason


def test_loops_bind_what_they_can_bind_at_the_start() -> None:
    """A rack that lies level beside its pinion, on a link as level as it: the slope of the loop by the angle of the
    link vanishes there, so the loop binds the angle of the rack."""
    solution = fb.System.from_text("""
bodies:
  p: {rod: {mass: 10 kg, length: 0.125 m}, near: {at: [0.3 m, 0]}}
  q: {particle: {mass: 2 kg}}
connections:
  teeth: {rack_and_pinion: {pinion: ground, rack: p, radius: 0.5 m}}
  guide: {slider: {body: q, along: down}}
  rod: {link: {first: p.center, second: q}}
questions: [{find: reaction of rod along right}]
""").solve()
    assert "defect" not in solution.answers[0].reason
    assert "theta_p" not in solution.coordinates


@pytest.mark.parametrize(
    ("W", "th", "turns"),
    [
        (5.0, 30.0, -7.0 * math.pi / 6.0),
        (5.0, 0.0, -math.pi),
        (7.5, -30.0, math.asin(0.5 - 3.0 * 9.81 / 7.5**2)),
        (10.0, -30.0, math.asin(0.5 - 3.0 * 9.81 / 10.0**2)),
    ],
)
def test_a_rod_on_a_turning_shaft_starts_from_rest_and_rests_next_elsewhere(W: float, th: float, turns: float) -> None:
    """With s = sin(th), th'^2 = W^2 (s_0^2 - s^2) + 3 g/L (s_0 - s): it rests next where s = -s_0 - 3 g/(L W^2), or, if
    there is no such angle, at the mirror image of the start. It starts at rest though the shaft turns with it."""
    text = ROD_ON_SHAFT.format(W=W, th=th) + "questions: [{find: th when rate(th) = 0}]"
    (answer,) = fb.System.from_text(text).solve().answers
    assert answer.reason == ""
    assert answer.value == pytest.approx(turns, rel=1e-9)


def test_what_depends_on_the_time_of_an_event_is_not_told_without_it() -> None:
    """Along the ground the angular velocity of the rod depends on where the shaft is by then; its size does not:
    w^2 = W^2 + th'^2 with th'^2 = W^2/4 + 3 g/(2 L) at th = 0."""
    text = ROD_ON_SHAFT.format(W=3.0, th=30.0) + "questions: [{find: angular velocity of rod when th = 0}]"
    (answer,) = fb.System.from_text(text).solve().answers
    assert answer.expression is None
    assert "time of the event" in answer.reason
    assert np.linalg.norm(np.array(answer.value)) ** 2 == pytest.approx(9.0 + 9.0 / 4.0 + 1.5 * 9.81, rel=1e-8)


TRIANGLE = """
space: true
parameters: {k: 0.2 m}
bodies:
  p: {polygon: {mass: 0.125 kg, corners: [[0, 0], [0.2 m, 0], [0, k]]}, turned: [90 deg about z]}
loads: {kick: {impulse: {at: p, along: right, magnitude: 0.125 N s}}}
questions: [{find: angular velocity of p at start}]
"""


def test_draws_keep_a_body_turned_though_its_principal_axes_change_places() -> None:
    """A right triangle of legs a and k, kicked at its corner by S across the leg a: w = S a/3/(m (a^2 + k^2)/18). With
    k above and below a its principal axes change places, and the triangle stays where it is."""
    system = fb.System.from_text(TRIANGLE)
    for draw in Setup(system).draws:
        k = draw.values["k"]
        omega = 0.125 * (0.2 / 3.0) / (0.125 * (0.04 + k * k) / 18.0)
        axes = matrix(draw.q[3:]) @ draw.reference.frame.principal["p"].T
        assert axes @ np.array([1.0, 0.0, 0.0]) == pytest.approx(np.array([0.0, 1.0, 0.0]), abs=1e-9)
        assert draw.start().v[5] == pytest.approx(omega, rel=1e-9)
    assert "p" in system.explain().to_text()


def test_a_body_turned_at_the_start_is_not_found_half_a_turn_off() -> None:
    reference = Reference(fb.System.from_text(TRIANGLE))
    q = reference.assemble()
    off = q.copy()
    off[3:] = rotation_vector(matrix(q[3:]) @ matrix(np.array([0.0, 0.0, math.pi - 1e-3])))
    again = reference.assemble(guess=off)
    assert matrix(again[3:]) == pytest.approx(matrix(q[3:]), abs=1e-9)


def test_sliding_begins_at_once_beside_what_slides_already() -> None:
    """p slides and is braked; q is pushed from rest by more than its friction holds: 5 N against 3 N."""
    (answer,) = (
        fb.System.from_text("""
parameters: {T: 5 N, F: 3 N}
bodies: {p: {particle: {mass: 1 kg}, at: [0, 0]}, q: {particle: {mass: 2 kg}, at: [1 m, 0]}}
measures: {s: x of p, r: x of q}
connections:
  a: {slider: {body: p, along: right}}
  b: {slider: {body: q, along: right}}
  c: {dry_friction: {measure: s, force: 1 N}}
  d: {dry_friction: {measure: r, force: F}}
loads:
  push: {force: {at: q, along: right, magnitude: T}}
  tie: {spring: {first: p, second: q, stiffness: 1 N/m, length: 1 m}}
start: {rate(s): 1 m/s, rate(r): 0}
questions: [{find: time when sliding begins}]
""")
        .solve()
        .answers
    )
    assert answer.reason == ""
    assert answer.value == 0.0


def test_a_side_that_touches_lies_flat() -> None:
    """Its block slides at once: mu is less than tan(alpha)."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, mu: 0.1, alpha: 30 deg}
ground: {lines: {incline: {along: -alpha}}}
bodies: {p: {rectangle: {mass: m, width: 0.2 m, height: 0.1 m}}}
connections: {c: {contact: {between: [p.bottom, incline], friction: mu}}}
loads: {g: {gravity: 9.81 m/s^2}}
questions: [{find: time when sliding begins}]
""")
    (answer,) = system.solve().answers
    assert answer.value == 0.0
    assert system.warnings == ()  # the side that is named says how it lies


@pytest.mark.parametrize(
    ("connections", "named"),
    [("c: {weld: {first: p, second: q}}, d: {belt: {first: p, second: q}}", "d"), ("c: {link: [p, q]}", "c")],
)
def test_a_line_without_length_holds_nothing_and_is_refused(connections: str, named: str) -> None:
    system = fb.System.from_text(f"""
bodies: {{p: {{disk: {{mass: 1 kg, radius: 1 m}}}}, q: {{disk: {{mass: 1 kg, radius: 2 m}}}}}}
connections: {{{connections}}}
measures: {{w: distance from p to q}}
start: {{w: 0}}
questions: [{{find: kinetic energy}}]
""")
    with pytest.raises((ModelError, CannotAnswer), match=f"in one place, and {named} needs a line"):
        system.solve()


def test_a_wheel_without_radius_is_no_wheel() -> None:
    """k theta = const binds theta for every k but zero, which the model says: formulas in k are not told for it."""
    system = fb.System.from_text("""
parameters: {k: {value: 0 m, sign: any}}
bodies: {p: {ring: {mass: 0.5 kg, radius: k}, near: {at: [0.5 m, -1 m]}}}
connections: {c: {string: {from: p, over: [p], to: p}}}
questions: [{find: degrees of freedom}]
""")
    [answer] = system.solve().answers
    assert answer.value == 3.0  # by rank
    with pytest.raises(CannotAnswer, match="leave 3 degrees of freedom, and in the formulas 2"):
        _ = Setup(system).model


def test_angles_without_a_value_at_the_start_stop_no_derivation() -> None:
    """Turned by 90 deg about y a free body has no yaw and roll of its own; what flies tells without them."""
    system = fb.System.from_text("""
space: true
bodies: {p: {box: {mass: 2 kg, size: [1 m, 2 m, 3 m]}, near: {turned: [90 deg about y]}, velocity: [0, 1 m/s, 1 m/s]}}
loads: {weight: {gravity: 10 m/s^2}, kick: {angular_impulse: {on: ground, magnitude: 1 N m s, about: right}}}
questions: [{find: height of p when t = 1 s}]
""")
    assert system.solve().answers[0].value == pytest.approx(1.0 - 5.0, rel=1e-12)
    assert "defect" not in system.explain().to_text()


def test_a_sum_that_cancels_in_a_product_is_judged_by_its_terms() -> None:
    """A kick of a body in a slot: m (s' + d w)/24 = 0 is zero to the round-off of its addends, each of about one."""
    system = fb.System.from_text("""
parameters: {k1: 1 kg, k2: 0.5 m, k3: 1 kg, S: 0.5 N m s}
bodies:
  p:
    composite:
      parts: {hub: {disk: {mass: k1/3, radius: k2}}, tip: {particle: {mass: k3/3}, at: [0.125 m, 0.5 m]}}
    at: [-1 m, 0]
connections: {c: {slot: {pin: p.hub, along: up}}}
loads: {kick: {angular_impulse: {on: p, magnitude: S}}}
questions: [{find: angular velocity of p at start}]
""")
    assert "defect" not in system.explain().to_text()


def test_a_bead_is_on_the_side_of_the_axle_on_which_it_starts() -> None:
    """N = 2 m r' phi' - m r phi'' phi by phi = -2 m r r' phi'/(J + m r^2): the distance r says nothing of the side."""
    answer = (
        fb.System.from_text("""
parameters: {m: 1 kg, J: 0.5 kg m^2, r0: 0.2 m, w0: 10 rad/s}
bodies: {tube: {body: {inertia: J}, points: {O: [0, 0]}}, bead: {particle: {mass: m}}}
connections: {axle: {pin: [ground.O, tube.O]}, guide: {slider: {body: bead, along: tube.x, through: tube.O}}}
measures: {r: distance from ground.O to bead, phi: angle of tube}
start: {r: r0, phi: 0, rate(r): 0, rate(phi): w0}
""")
        .solve("normal force of guide")
        .answers[0]
    )
    assert answer.evidence is not None, answer.reason
    assert answer.evidence.worst_relative_difference < 1e-8
