"""Parts that do not act on each other, in a phase or in smooth motion: each has the energy that it has alone.

What strikes a hanging rod at the depth a gives it the angular velocity w = 3 m v a (1 + e)/(3 m a^2 + M L^2), and the
rod swings on by

    w^2 + (3 g/L) cos(angle from below) = const.,

until what struck it is in its way again."""

from __future__ import annotations

import pytest

from freebody.api import System
from freebody.study.phases.tree import tree_of
from freebody.study.setup import Setup
from freebody.symbolic.blocks import apart_from
from freebody.symbolic.first_integrals import staying_of
from freebody.symbolic.phases.energy_motion import EnergyMotion
from posed import is_derived, is_formula, posed

CART = """
parameters: {m: 1 kg, M: 2 kg, L: 1 m, v: 2 m/s, e: 0.8, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  rod: {rod: {mass: M, length: L}, angle: -90 deg}
  cart: {particle: m, at: [0, -L], velocity: [v, 0]}
measures: {gap: x of rod.end from cart}
connections:
  hinge: {pin: [ground.O, rod.start]}
  rail: {slider: {body: cart, along: 0 deg}}
  hit: {stop: {measure: gap, min: 0, restitution: e}}
loads: {w: {gravity: g}}
"""
BALL = """
parameters: {m: 0.2 kg, M: 2 kg, L: 1 m, v: 8 m/s, e: 0.6, g: 9.81 m/s^2, a: 0.8 m}
ground: {points: {O: [0, 0]}}
bodies:
  rod: {rod: {mass: M, length: L}, angle: -90 deg}
  ball: {sphere: {mass: m, radius: 3 cm}, at: [-3 cm, -a], velocity: [v, 0]}
connections:
  hinge: {pin: [ground.O, rod.start]}
  hit: {contact: {between: [ball, rod], restitution: e}}
loads: {w: {gravity: g}}
"""
W_BALL = "(3*m*v*a*(1 + e)/(3*m*a^2 + M*L^2))"
W_CART = "(3*m*v*(1 + e)/((3*m + M)*L))"


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("maximum angle of rod", f"asin(L*{W_BALL}^2/(3*g) - 1)"),
        ("angular velocity of rod when angle of rod = -80 deg", f"sqrt({W_BALL}^2 - 3*g/L*(1 - sin(4*pi/9)))"),
        ("angular velocity of rod when angle of rod = -95 deg", f"-sqrt({W_BALL}^2 - 3*g/L*(1 - sin(17*pi/36)))"),
    ],
)
def test_a_rod_swings_on_by_its_own_energy_while_the_ball_flies(question: str, formula: str) -> None:
    found = is_formula(BALL, question, formula)
    assert any("nothing else comes before" in note for note in found.notes)


def test_a_pendulum_swings_on_beside_a_cart() -> None:
    is_formula(CART, "maximum angle of rod", f"asin(L*{W_CART}^2/(3*g) - 1)")


def test_what_comes_in_its_way_again_is_seen() -> None:
    """The cart goes on at 0.56 m/s, and the rod meets it before it is back; a heavy cart catches up with the rod."""
    assert posed(CART, "angular velocity of rod when angle of rod = -91 deg").expression is None
    heavy = CART.replace("m: 1 kg", "m: 5 kg").replace("e: 0.8", "e: 0.1")
    assert posed(heavy, "maximum angle of rod").expression is None


def test_blocks_are_told_by_masses_and_forces() -> None:
    phase = tree_of(System.from_text(BALL)).roots[0].phase
    rod, *ball = phase.model.coordinates
    assert list(apart_from(phase.model, rod)) == ball
    assert rod in apart_from(phase.model, ball[0])
    assert isinstance(phase.course, EnergyMotion)
    assert set(phase.course.beside) == set(ball)


def test_what_a_spring_joins_is_one_block() -> None:
    joined = BALL.replace("loads: {", "loads: {s: {spring: {from: ball, to: rod.end, stiffness: 5 N/m, length: 1 m}}, ")
    phase = tree_of(System.from_text(joined)).roots[0].phase
    rod, _turn, x, y = phase.model.coordinates
    assert not {rod, x, y} & {*apart_from(phase.model, rod), *apart_from(phase.model, x)}


APART = """
parameters: {m: 2 kg, M: 1 kg, L: 1 m, g: 9.81 m/s^2, alpha: 60 deg, k: 5 N/m^3, a: 0.3 m, m3: 2 kg, L3: 2 m}
ground: {points: {P: [10 m, 0], O: [0, 0]}}
bodies: {bob: {particle: {mass: m}}, block: {particle: {mass: M}}, third: {rod: {mass: m3, length: L3}}}
connections:
  rod: {link: [ground.O, bob, L]}
  rail: {guide: {body: block, along: right}}
  hinge: {pin: [ground.P, third.start]}
loads: {weight: {gravity: g}, spring: {law: {measure: x, force: -k*x^3}}}
measures: {theta: {angle of line from ground.O to bob from down}, phi: {angle of third from right}, x: x of block}
start: {theta: alpha, rate(theta): 0, x: a, rate(x): 0, phi: 0, rate(phi): 0}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("velocity of theta when theta = 0", "-sqrt(2*g*(1 - cos(alpha))/L)"),
        ("tension of rod when theta = 0", "m*g*(3 - 2*cos(alpha))"),
        ("greatest tension of rod", "m*g*(3 - 2*cos(alpha))"),
        ("velocity of x when x = 0", "-a^2*sqrt(k/(2*M))"),
        ("least x", "-a"),
        ("velocity of phi when phi = -90 deg", "-sqrt(3*g/L3)"),
    ],
)
def test_parts_that_move_smoothly_have_their_own_energies(question: str, formula: str) -> None:
    is_formula(APART, question, formula)


def test_the_energy_of_a_part_is_derived() -> None:
    assert "do not act on each other" in is_derived(APART, "velocity of theta when theta = 0")["en"]


TWO_PENDULUMS = """
parameters: {m: 1 kg, M: 2 kg, L: 1 m, a: 40 deg, g: 9.81 m/s^2}
bodies: {upper: {rod: {mass: M, length: L}}, lower: {rod: {mass: m, length: L}}}
connections: {O: {pin: [ground.O, upper.start]}, P: {pin: [upper.end, lower.start]}}
loads: {w: {gravity: g}}
measures: {phi: angle of upper from down, psi: angle of lower from down}
start: {phi: PHI, rate(phi): 0, psi: PSI, rate(psi): 0}
"""


def test_what_balls_show_to_be_accelerated_is_not_looked_at_in_formulas(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let go at an angle, both rods are accelerated at once; hanging straight down, both stay."""
    let_go = Setup(System.from_text(TWO_PENDULUMS.replace("PHI", "a").replace("PSI", "a")))
    start = let_go.start
    monkeypatch.setattr(type(let_go.model.field), "follow", lambda *_any: pytest.fail("the start was put in"))
    assert staying_of(let_go.model, start) == {}
    monkeypatch.undo()
    hanging = Setup(System.from_text(TWO_PENDULUMS.replace("PHI", "0").replace("PSI", "0")))
    assert {c.index for c in hanging.model.coordinates} <= staying_of(hanging.model, hanging.start).keys()
