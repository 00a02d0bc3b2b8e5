"""A mass reaches the pulley to which its rope draws it: the straight length of the lead is used up."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from posed import posed

TABLE = """
parameters: {{m1: 4 kg, m2: 3 kg, M: 2 kg, mu: 0.25, L: 1 m, R: 5 cm, h: 0.6 m, g: 9.81 m/s^2}}
ground: {{points: {{edge: [L, 0], axle: [L, -R]}}, lines: {{table: {{along: right}}}}}}
bodies:
  block: {{particle: {{mass: m1}}, at: [0, 0]}}
  hanging: {{particle: {{mass: m2}}}}
{more}
loads: {{weight: {{gravity: g}}}}
measures: {{s: drop of hanging, x: x of block}}
"""
OVER_POINT = """connections:
  {way}
  rope: {{string: {{from: block, over: [ground.edge], to: hanging}}}}
"""
ROUGH = "contact: {contact: {between: [block, table], friction: mu}}"
SMOOTH = "guide: {slider: {body: block, along: right}}"
WHEEL = """  pulley: {disk: {mass: M, radius: R}}
connections:
  guide: {slider: {body: block, along: right}}
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: block, over: [pulley], to: hanging, grips: [pulley]}}
"""
ATWOOD = """
parameters: {m1: 4 kg, m2: 3 kg, h: 1 m, R: 0.1 m, g: 9.81 m/s^2}
ground: {points: {axle: [0, 0]}}
bodies:
  left: {particle: {mass: m1}}
  right: {particle: {mass: m2}, at: [R, -h]}
  pulley: {disk: {radius: R}}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right}}
loads: {weight: {gravity: g}}
measures: {x: drop of right}
"""
BESIDE = """
parameters: {m1: 4 kg, m2: 3 kg, b: 1 m, h: 0.75 m, g: 9.81 m/s^2}
ground: {points: {edge: [b, h]}}
bodies:
  collar: {particle: {mass: m1}, at: [0, 0]}
  hanging: {particle: {mass: m2}}
connections:
  guide: {slider: {body: collar, along: right}}
  rope: {string: {from: collar, over: [ground.edge], to: hanging}}
loads: {weight: {gravity: g}}
measures: {x: x of collar}
"""


def ask(model: fb.System, asked: str) -> fb.Answer:
    return model.solve(asked)["q1"]


def system(more: str) -> fb.System:
    return fb.System.from_text(TABLE.format(more=more))


@pytest.mark.parametrize("way", [ROUGH, SMOOTH])
def test_a_block_on_a_table_arrives_at_the_edge_with_what_the_weight_gives(way: str) -> None:
    # m2 g L - mu m1 g L = (m1 + m2) v^2/2, and uniformly accelerated L = v t/2
    model = system(OVER_POINT.format(way=way))
    m1, m2, mu, g = 4.0, 3.0, 0.25 if way is ROUGH else 0.0, 9.81
    v = math.sqrt(2 * g * (m2 - mu * m1) / (m1 + m2))
    assert ask(model, "speed of block when block reaches edge").value == pytest.approx(v, rel=1e-12)
    assert ask(model, "time when block reaches edge").value == pytest.approx(2 / v, rel=1e-12)
    assert ask(model, "speed of block when x = L").value == pytest.approx(v, rel=1e-12)


def test_a_wheel_takes_its_share_of_the_energy() -> None:
    # m2 g L = (m1 + m2 + M/2) v^2/2
    answer = ask(system(WHEEL), "speed of block when the block reaches the pulley")
    assert answer.value == pytest.approx(math.sqrt(2 * 3.0 * 9.81 / (4.0 + 3.0 + 1.0)), rel=1e-12)


def test_a_hanging_mass_is_drawn_up_to_the_pulley_by_the_heavier_one() -> None:
    model = fb.System.from_text(ATWOOD)
    answer = ask(model, "time when right reaches pulley")
    assert answer.value == pytest.approx(math.sqrt(2 * 1.0 * 7.0 / 9.81), rel=1e-12)
    assert [str(c) for c in answer.conditions] == ["m₁ > m₂ (right reaches pulley)"]
    ends = [end for way in model.phases().tree.roots for end in way.edges]
    assert [end.watch.name for end in ends if end.watch] == ["right reaches pulley"]


def test_a_simulation_says_from_when_on_the_rope_is_used_up() -> None:
    ((purpose, time),) = fb.System.from_text(ATWOOD).simulate(until=2.0).not_valid
    assert str(purpose) == "right has not reached pulley"
    assert time == pytest.approx(math.sqrt(2 * 1.0 * 7.0 / 9.81), rel=1e-6)


def test_a_collar_that_passes_beside_the_pulley_never_reaches_it() -> None:
    with pytest.raises(fb.ModelError, match="changes its direction"):
        fb.System.from_text(BESIDE).solve("speed of collar when collar reaches edge")


WINCH = """
parameters: {m: 40 kg, M: 12 kg, R: 0.15 m, T0: 60 N m, beta: 20 deg, mu: 0.25, g: 9.81 m/s^2, l: 6 m}
ground:
  lines: {ramp: {along: beta, through: [0, 0]}}
  points: {axle: [l*cos(beta) - R*sin(beta), l*sin(beta) + R*cos(beta)]}
bodies: {drum: {disk: {mass: M, radius: R}}, crate: {particle: {mass: m}, at: [0, 0]}}
connections:
  ramp: {contact: {between: [crate, ramp], friction: mu}}
  axle: {pin: [ground.axle, drum.center]}
  rope: {string: {from: crate, to: wound on drum counterclockwise}}
loads: {weight: {gravity: g}, motor: {torque: {on: drum, magnitude: T0}}}
measures: {s: {travel of crate along ramp}}
"""


def test_a_crate_on_the_line_of_its_rope_has_not_left_it_and_beyond_the_drum_nothing_is_told() -> None:
    """The crate is on the line but for round-off. It is at the drum after sqrt(2 l/a); later numbers are of no motion
    that there is. a = (T0/R - m g (sin(beta) + mu cos(beta)))/(m + M/2)."""
    beta, pull = math.radians(20), 60 / 0.15
    a = (pull - 40 * 9.81 * (math.sin(beta) + 0.25 * math.cos(beta))) / (40 + 12 / 2)
    system = fb.System.from_text(WINCH)
    ((purpose, time),) = system.simulate(2.0).not_valid
    assert purpose == "crate has not reached drum"
    assert time == pytest.approx(math.sqrt(2 * 6 / a), rel=1e-8)
    asked = "power of motor after {t} s"
    assert posed(WINCH, asked.format(t=1)).value == pytest.approx(60 * a * 1.0 / 0.15)
    assert posed(WINCH, asked.format(t=2)).value is None


def test_after_a_time_the_crate_has_not_reached_the_drum_while_its_way_is_less_than_the_lead() -> None:
    """s = a t^2/2 < l with R (2 m + M) a = 2 (T0 - mu m R g cos(beta) - m R g sin(beta)), at t = 1 s solved for mu."""
    sliding, reaching = (str(c) for c in posed(WINCH, "power of motor after 1 s").conditions)
    assert sliding == "μ < (T₀ - m·R·g·sin(β))/(m·R·g·cos(β))"
    assert reaching == "μ > (T₀ - m·R·g·sin(β) - 2·m·R·l - M·R·l)/(m·R·g·cos(β))"
