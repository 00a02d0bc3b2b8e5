"""What a worked solution says of the start, and of what is constant on the way; at a clamp, and where nothing moves."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

import freebody as fb
from freebody.language.expression import evaluate
from freebody.language.parser import parse
from freebody.narrative.principles.slanted import direction_words
from freebody.narrative.sharing import lines_of
from freebody.narrative.telling.catalogue import Catalogue

CART = """
parameters: {m: 2 kg, F: 3 N, v0: 1 m/s, d: 1 m, k: 8 N/m}
ground: {points: {O: [0, 0]}}
bodies: {cart: {particle: {mass: m}}}
connections: {rail: {slider: {body: cart, along: right}}}
loads: {pull: {force: {at: cart, along: right, magnitude: F}}}
measures: {x: x of cart}
start: {x: 0.5 m, rate(x): v0}
"""
BEAM = """
parameters: {L: 3 m, F: 250 N, M0: 300 N m}
ground: {points: {A: [0, 0]}}
bodies: {beam: {rod: {length: L}, angle: 0, at: {start: [0, 0]}, points: {S: [0, 0]}}}
connections: {wall: {weld: [ground.A, beam.start]}}
loads:
  tip: {force: {at: beam.end, along: up, magnitude: F}}
  couple: {torque: {on: beam, magnitude: M0}}
"""
HUNG = """
parameters: {m: 1 kg, M: 3 kg, l: 1 m, F: 2 N, d: 1 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}}}
connections:
  rail: {slider: {body: cart, along: up, through: ground.O}}
  rod: {link: {between: [cart, bob], length: l}}
loads: {weight: {gravity: g}, lift: {force: {at: cart, along: up, magnitude: F}}}
measures: {y: y of cart, phi: angle of line from cart to bob from down}
start: {y: 0, rate(y): 0, phi: 0, rate(phi): 0}
"""


def _told(model: str, *asked: str) -> str:
    return " ".join(fb.explain(fb.System.from_text(model), asked).to_text().split())


def test_initial_values_are_told_with_their_units_before_they_are_put_in() -> None:
    text = _told(CART, "time when x = 2*d")
    assert text.index("At the start x = 0.5 m and x' = v₀.") < text.index("Integrating once")
    assert "At the start x' = v₀. With these values" in _told(CART, "momentum of cart along right at start")


def test_energy_from_the_start_tells_what_is_so_there() -> None:
    spring = CART.replace(
        "{pull: {force: {at: cart, along: right, magnitude: F}}}", "{s: {law: {measure: x, force: -k*x}}}"
    )
    text = _told(spring, "greatest x")
    assert text.index("At the start x = 0.5 m and x' = v₀.") < text.index("Conservation of energy between the start")


def test_moments_at_a_clamp_are_about_its_point_and_not_about_a_contact() -> None:
    text = _told(BEAM, "reaction moment of wall")
    assert "about A." in text
    assert "contact point" not in text


def test_of_what_cannot_move_no_motion_is_followed_in_numbers() -> None:
    """The reason stands alone: a beam has no equations of motion, and there is nothing to simulate."""
    text = _told(BEAM, "bending moment of beam at S")
    assert "There is no derivation: where on beam the couple" in text
    assert "simulate" not in text


def test_an_acceleration_is_called_constant_only_where_it_is() -> None:
    """That of the cart depends on the swing of the bob, which hangs at rest and stays so: y'' = F/(m + M) - g."""
    text = _told(HUNG, "acceleration of y", "velocity of y when y = -d")
    assert "string" not in text  # a link is a rod
    assert "φ starts at rest, and nothing accelerates it while it rests: it stays where it is. On this motion" in text


def test_one_planet_stands_for_all_in_the_constraints_and_energy_moves_them() -> None:
    """A gear of three planets: one rolling condition at each mesh, no sum over copies, and few equations."""
    system = fb.System.load(Path(__file__).parent.parent / "examples" / "planetary_gear_with_three_planets.yaml")
    told = fb.explain(system, ["ratio", "acceleration", "tooth"])
    text = " ".join(told.to_text().split())
    assert "ω_planet_2" not in text
    assert "The copies planet 2 and planet 3 move as planet does" in text
    assert sum(len(lines_of(d.stages)) for d in told.derivations) < 20


@pytest.mark.parametrize(
    ("x", "y", "angle"),
    [
        *(("cos(a)", "sin(a)", 0.0), ("-sin(a)", "cos(a)", 90.0), ("-cos(a)", "-sin(a)", 180.0)),
        *(("sin(a)", "-cos(a)", -90.0), ("cos(a)", "-sin(a)", None), ("sin(a)", "cos(a)", None)),
        *(("-cos(a)", "sin(a)", None), ("-sin(a)", "-cos(a)", None)),
    ],
)
def test_a_slanted_direction_is_told_by_its_angle(x: str, y: str, angle: float | None) -> None:
    """The angle that is told has this cosine and sine."""
    told = Catalogue().plain(direction_words(parse(x), parse(y)))
    (said,) = re.findall(r"direction at (.*) from the x axis", told)
    a = 0.3
    degrees = sum(
        (-1 if sign == "−" else 1) * (math.degrees(a) if what == "a" else float(what))
        for sign, what in re.findall(r"(−|\+|^) ?(a|\d+)°?", said)
    )
    if angle is not None:
        assert degrees == pytest.approx(math.degrees(a) + angle)
    for part, of in ((x, math.cos), (y, math.sin)):
        assert of(math.radians(degrees)) == pytest.approx(float(evaluate(parse(part), {"a": a})))
    assert Catalogue().plain(direction_words(parse("3/5"), parse("4/5"))) == "along (3/5, 4/5)"


def test_the_first_phase_tells_the_start_and_the_next_ones_do_not() -> None:
    """A parcel up a rough slope and down again: s = 0 and s' = v0 are said once."""
    ramp = """
parameters: {m: 2 kg, mu: 0.25, alpha: 30 deg, v0: 4 m/s, g: 9.81 m/s^2}
ground: {lines: {ramp: {along: alpha}}}
bodies: {parcel: {particle: {mass: m}}}
connections: {contact: {contact: {between: [parcel, ramp], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: travel of parcel along ramp}
start: {s: 0, rate(s): v0}
"""
    text = _told(ramp, "time when s = 0 again")
    assert text.count("At the start s = 0 and s' = v₀.") == 1
    assert "Time when s = 0 again" in text
    assert "Speed of parcel when s = 1 m" in _told(ramp, "speed of parcel when s = 1 m")


def test_the_angle_of_a_link_is_told_by_its_ends() -> None:
    """A coordinate that a link brings is the angle of the line from one end to the other."""
    swing = """
parameters: {m: 1 kg, l: 1 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: {between: [ground.O, bob], length: l}}}
loads: {weight: {gravity: g}}
"""
    assert "φ_rod — angle of the line from O to bob, from the x axis" in _told(swing, "natural frequencies")
