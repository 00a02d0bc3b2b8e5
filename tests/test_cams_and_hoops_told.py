"""Eccentric cams, beads on hoops and pendulums by their numbers, beside closed forms."""

from __future__ import annotations

import math

import pytest

import freebody as fb

R, E, W, G = 0.04, 0.01, 300 * 2 * math.pi / 60, 9.81
CAM = "cam: {radius: 40 mm, eccentricity: 10 mm, speed: 300 rpm}\nfollower: {mass: 0.5 kg, KIND}\n"
HOOP = "hoop: {radius: 0.3 m, speed: 8 rad/s}\nbead: {mass: 0.1 kg, angle: 20 deg}\n"


def _value(text: str, question: str) -> float:
    (answer,) = fb.System.from_text(text).solve(question).answers
    assert answer.value is not None, answer.reason
    return answer.value


@pytest.mark.parametrize(
    ("kind", "height", "reach"),
    [
        ("type: flat", R + E, math.inf),
        ("flat: true", R + E, math.inf),
        ("type: knife", R + E, R),
        ("type: roller, roller_radius: 10 mm", R + 0.01 + E, R + 0.01),
    ],
    ids=["flat", "flat face", "knife", "roller"],
)
def test_a_follower_is_slowed_at_the_top_of_an_eccentric_cam(kind: str, height: float, reach: float) -> None:
    """y = e cos(phi) + sqrt(L^2 - e^2 sin^2(phi)): y'' = -(e + e^2/L) w^2 at phi = 0; on a flat face L is infinite."""
    text = CAM.replace("KIND", kind)
    assert _value(text, "y at start") == pytest.approx(height)
    assert _value(text, "acceleration of y") == pytest.approx(-(E + E**2 / reach) * W**2)


def test_a_bead_on_a_turning_hoop_stays_where_gravity_and_the_turn_balance() -> None:
    """cos(theta) = g/(R Omega^2) (Goldstein, Poole & Safko, sec. 2.4); gravity is taken for granted, and told."""
    system = fb.System.from_text(HOOP)
    assert any("gravity acts downwards" in told for told in system.assumptions)
    places = system.solve("theta in steady motion").answers[0].value
    assert min(abs(place - math.acos(G / (0.3 * 64))) for place in places) < 1e-9


def test_a_bead_on_a_hoop_at_rest_is_a_pendulum() -> None:
    text = HOOP.replace(", speed: 8 rad/s", "")
    assert _value(text, "acceleration of theta") == pytest.approx(-G / 0.3 * math.sin(math.radians(20)))


def test_a_pendulum_has_a_weight() -> None:
    """It was answered without one: it did not begin to move."""
    text = "pendulum: {length: 2 m, mass: 1 kg, angle: 30 deg}\n"
    assert _value(text, "acceleration of theta") == pytest.approx(-G / 2 * math.sin(math.radians(30)))
    assert _value(f"{text}gravity: 1.62 m/s^2\n", "acceleration of theta") == pytest.approx(-1.62 / 2 * 0.5)
    assert _value(f"{text}parameters: {{g: 3 m/s^2}}\n", "acceleration of theta") == pytest.approx(-3 / 2 * 0.5)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (CAM.replace("eccentricity", "colour: red, e"), "an eccentric cam has no colour; it has radius, eccentricity"),
        (CAM.replace("KIND", "type: square"), "a follower is flat, edge or roller, not square"),
        (CAM.replace("KIND", "type: roller"), "a roller has a radius: {type: roller, roller_radius: 10 mm}"),
        (HOOP.replace("angle", "colour: red, angle"), "a bead on a hoop has no colour; it has mass, angle"),
        ("pendulum: {length: 2 m, mass: 1 m}\n", "mass must be a mass (kg), but is given in m: write mass: 1 kg"),
        ("pendulum: {length: 2 m, damping: 1 N m s}\n", "a pendulum has no damping; it has length, mass, angle"),
    ],
)
def test_what_such_a_figure_does_not_read_is_told_once(text: str, told: str) -> None:
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(text)
    (problem,) = refused.value.problems
    assert told in problem.message
