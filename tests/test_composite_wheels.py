"""Bodies of several parts that roll, touch and carry strings by their round parts.

A hoop M, r with a lump m on its rim rolls: about the place where it touches I = 2 M r^2 + 2 m r^2 (1 + cos phi), so
with the lump level at the start, alpha = m g/(2 r (M + m)), and at the bottom w^2 = m g/(M r), by energy; small swings
there, 2 M r^2 phi'' + m g r phi = 0. Problem families: Meriam & Kraige, Dynamics, 6/5 and 6/6; Beer & Johnston,
Dynamics, 17.4 and 19.2; Hibbeler, Dynamics, 17.5.
"""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.api import System
from posed import is_formula, posed

HOOP = """
parameters: {M: 2 kg, m: 1 kg, r: 0.4 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  wheel: {composite: {parts: {hoop: {ring: {radius: r, mass: M}}, lump: {particle: {mass: m}, at: [0, r]}}}}
connections: {floor: {rolling: [wheel, ground.floor]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of wheel}}
start: {phi: 90 deg}
"""
# the same by a contact of its circle, rough enough
TOUCHING = HOOP.replace(
    "{rolling: [wheel, ground.floor]}", "{contact: {between: [wheel.hoop, ground.floor], friction: 1}}"
)
DRUM = """
parameters: {M: 8 kg, m: 3 kg, R: 0.3 m, r: 0.2 m, k: 5 kg, g: 9.81 m/s^2}
bodies:
  drum: {composite: {parts: {rim: {disk: {radius: R, mass: M}}, hub: {disk: {radius: r, mass: m}}}}}
  load: {particle: {mass: k}}
connections:
  axle: {pin: [ground.O, drum]}
  rope: {string: {path: [wound on drum radius r, load]}}
loads: {weight: {gravity: g}}
"""
PULLEY = """
parameters: {M: 8 kg, m: 3 kg, R: 0.3 m, g: 9.81 m/s^2}
bodies:
  wheel: {composite: {parts: {rim: {ring: {radius: R, mass: M}}}}}
  A: {particle: {mass: m}}
  B: {particle: {mass: 2*m}}
connections:
  axle: {pin: [ground.O, wheel]}
  rope: {string: {from: A, over: [wheel], to: B}}
loads: {weight: {gravity: g}}
measures: {y: {drop of B}}
"""


START = {
    "angular acceleration of wheel at the start": "m*g/(2*r*(M + m))",
    "normal force of floor at the start": "(M + m)*g - m^2*g/(2*(M + m))",
}
MOTION = {
    "greatest angular velocity of wheel": "sqrt(m*g/(M*r))",
    "period of small oscillations": "2*pi*sqrt(2*M*r/(m*g))",
}


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        *((HOOP, question, formula) for question, formula in (START | MOTION).items()),
        *((TOUCHING, question, formula) for question, formula in START.items()),
    ],
)
def test_a_hoop_with_a_lump(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula, factors=(1.0, 1.02, 0.98))


def test_a_hoop_that_its_lump_lifts_off_has_no_formula() -> None:
    heavy = HOOP.replace("M: 2 kg, m: 1 kg", "M: 0.1 kg, m: 5 kg").replace("phi: 90 deg", "phi: 20 deg")
    found = posed(heavy, "greatest angular velocity of wheel")
    assert found.expression is None
    assert "floor does not hold all the time" in found.reason


def test_a_string_runs_over_the_only_circle() -> None:
    is_formula(PULLEY, "acceleration of y", "m*g/(3*m + M)")


def test_of_several_circles_the_radius_is_said() -> None:
    is_formula(DRUM, "tension of rope", "k*g*(M*R^2 + m*r^2)/(M*R^2 + m*r^2 + 2*k*r^2)")
    with pytest.raises(
        fb.ModelError, match=r"drum has several circles: say which, as its radius: R \(rim\), r \(hub\)"
    ):
        System.from_text(DRUM.replace("drum radius r", "drum"))


def test_a_body_of_parts_touches_by_a_circle_that_is_named() -> None:
    told = r"wheel has no outline as a whole: write the circle that touches, wheel\.hoop"
    with pytest.raises(fb.ModelError, match=told):
        System.from_text(TOUCHING.replace("wheel.hoop", "wheel"))


def test_a_string_tied_to_the_axle_of_a_drum_of_parts_is_told() -> None:
    model = System.from_text(DRUM.replace("path: [wound on drum radius r, load]", "from: load, to: drum"))
    assert any("is tied to the centre of drum" in str(w) for w in model.warnings)


# a spool of its radius of gyration: on a rail by its hub, and down a slope held by a rope that is wound on the hub,
# which slides: with a = r alpha, m a = m g sin b - T - mu N, m k^2 alpha = T r - mu N R, N = m g cos b
# (Hibbeler, Dynamics, 17.5; Meriam & Kraige, Dynamics, 6/5)
SPOOL = """
parameters: {m: 75 kg, k: 0.38 m, r: 0.3 m, R: 0.6 m, b: 30 deg, mu: 0.15, g: 9.81 m/s^2, L: 3 m}
ground:
  points: {top: [(R + r)*sin(b) - L*cos(b), (R + r)*cos(b) + L*sin(b)]}
  lines: {slope: {along: -b}}
bodies: {spool: {disk: {mass: m, radius: R, hub: r, radius_of_gyration: k}}}
connections:
  contact: {contact: {between: [spool, slope], friction: mu}}
  rope: {string: {path: [ground.top, wound on spool.hub at top], leads: [slope]}}
loads: {weight: {gravity: g}}
"""
RAIL = """
parameters: {m: 4 kg, k: 0.2 m, r: 0.1 m, R: 0.3 m, mu: 0.4, F: 5 N, g: 9.81 m/s^2}
ground: {lines: {rail: {along: right}}}
bodies: {spool: {body: {mass: m, radius: R, hub: r, radius_of_gyration: k}}}
connections: {rail: {contact: {between: [spool.hub, rail], friction: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: spool.origin, along: right, magnitude: F}}}
"""
PULLED = """
parameters: {m: 4 kg, M: 2 kg, k: 0.2 m, r: 0.1 m, R: 0.3 m, g: 9.81 m/s^2}
bodies: {drum: {ring: {mass: m, radius: R, hub: r, radius_of_gyration: k}}, load: {particle: {mass: M}}}
connections: {axle: {pin: [ground.O, drum]}, rope: {string: {from: load, to: wound on drum.hub}}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (SPOOL, "angular acceleration of spool", "g*(r*sin(b) - mu*(r + R)*cos(b))/(k^2 + r^2)"),
        (SPOOL, "tension of rope", "m*g*(k^2*sin(b) - mu*cos(b)*(k^2 - r*R))/(k^2 + r^2)"),
        (RAIL, "angular acceleration of spool", "-F*r/(m*(k^2 + r^2))"),
        (PULLED, "tension of rope", "M*m*k^2*g/(M*r^2 + m*k^2)"),
    ],
)
def test_a_hub_is_a_circle_that_carries_ropes_and_touches(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_a_rim_may_hang_beside_the_rail_on_which_the_hub_runs() -> None:
    assert not System.from_text(RAIL).warnings
