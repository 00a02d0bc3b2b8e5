"""How one point moves seen from another, along axes that do not turn."""

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.errors import ModelError
from freebody.language.expression import Expr
from freebody.language.notation import to_python

ATWOOD = """
parameters: {m: 1 kg, M: 2 kg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  pulley: {pulley: {radius: 0.1 m}}
  left: {particle: {mass: m}}
  right: {particle: {mass: M}}
connections:
  O: {pin: [ground.O, pulley]}
  rope: {string: {from: left, over: [pulley], to: right}}
loads: {weight: {gravity: g}}
measures: {s: drop of right below ground.O}
"""
ROAD = """
bodies:
  car: {particle: {mass: 900 kg}, velocity: [20 m/s, 0]}
  truck: {particle: {mass: 8000 kg}, at: [0, 5 m], velocity: [5 m/s, 8 m/s]}
"""
ROD = """
parameters: {L: 2 m, w: 3 rad/s}
ground: {points: {O: [0, 0]}}
bodies:
  rod: {rod: {mass: 1 kg, length: L}, angle: 0}
connections: {O: {pin: [ground.O, rod.start]}}
measures: {phi: angle of rod}
start: {phi: 0, rate(phi): w}
"""


@pytest.mark.parametrize(
    "asked",
    [
        "acceleration of left relative to right along up",
        "acceleration of left along up - acceleration of right along up",
    ],
)
def test_the_masses_of_an_atwood_machine_part_with_twice_their_acceleration(asked: str) -> None:
    """a = g (M - m)/(M + m) of each, one up and one down."""
    found = fb.System.from_text(ATWOOD).solve(asked)["q1"].expression
    assert isinstance(found, Expr)
    assert_same_function(to_python(found), "2*g*(M - m)/(M + m)", {"g": 9.81})


def test_velocities_of_two_vehicles_are_composed_as_vectors() -> None:
    """(20, 0) - (5, 8) = (15, -8), of size 17: a Pythagorean triple."""
    system = fb.System.from_text(ROAD)
    assert system.solve("velocity of car relative to truck at start")["q1"].value == pytest.approx((15.0, -8.0))
    assert system.solve("speed of car relative to truck at start")["q1"].value == pytest.approx(17.0)
    assert system.solve("relative velocity of truck and car at start")["q1"].value == pytest.approx((-15.0, 8.0))


def test_ends_of_a_rod_move_round_each_other() -> None:
    """|v_B - v_A| = L w and a_B - a_A = -w^2 L along the rod, which turns at a constant rate."""
    system = fb.System.from_text(ROD)
    assert system.solve("speed of rod.end relative to rod.center at start")["q1"].value == pytest.approx(3.0)
    along = system.solve("acceleration of rod.end relative to rod.center along right at start")["q1"].value
    assert along == pytest.approx(-9.0)


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ("velocity of left relative to left", "left has no motion relative to itself"),
        ("velocity of pulley relative to pulley.center", "has no motion relative to itself"),
    ],
)
def test_what_is_not_one_motion_is_refused(asked: str, told: str) -> None:
    with pytest.raises(ModelError, match=told):
        fb.System.from_text(ATWOOD).solve(asked)


def test_what_hangs_on_a_pulley_is_seen_from_its_axle() -> None:
    with pytest.raises(ModelError, match="a point of rod, and rests in it"):
        fb.System.from_text(ROD).solve("velocity of rod.end relative to rod")
    solved = fb.System.from_text(ATWOOD).solve(
        ["speed of left relative to pulley at start", "speed of left relative to pulley.center at start"]
    )
    assert solved["q1"].value == solved["q2"].value
