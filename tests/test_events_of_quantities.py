"""Events at which a force, a speed or an energy has a value, told by the place at which it does.

A rod let go at the angle a from the vertical: w^2 = 3 g (cos a - cos t)/L, so that the horizontal force of its hinge,
3 m g sin t (3 cos t - 2 cos a)/4, vanishes at cos t = 2 cos a/3. A pendulum let go at a: S = m g (3 cos t - 2 cos a).
A particle that leaves rest on a slope reaches the speed v after v^2/(2 g sin b).
Problem families: Meriam & Kraige, Dynamics, 6/4 and 3/6; Beer & Johnston, Dynamics, 13.4 and 17.1.
"""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.api import System
from freebody.errors import ModelError
from freebody.language.expression import Expr
from freebody.language.notation import to_text
from freebody.narrative.sheets.asking import asking
from freebody.narrative.telling.catalogue import Catalogue
from posed import is_derived, is_formula, posed

ROD = """
parameters: {m: 3 kg, L: 1.2 m, a: 20 deg, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {th: {angle of rod from up clockwise}}
start: {th: a}
"""
STONE = """
parameters: {m: 2 kg, d: 1 m, h: 3 m, g: 9.81 m/s^2}
bodies: {stone: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {y: y of stone}
start: {y: h, rate(y): 0}
"""
PENDULUM = """
parameters: {m: 1.5 kg, L: 0.9 m, a: 60 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rope: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: a}
"""
SLOPE = """
parameters: {m: 2 kg, b: 30 deg, v: 3 m/s, g: 9.81 m/s^2}
ground: {lines: {slope: {along: -b}}}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: slope}}}
loads: {weight: {gravity: g}}
measures: {s: {travel of block along slope}}
start: {s: 0}
"""
TRAMMEL = """
parameters: {m: 2 kg, L: 0.5 m, a: 30 deg, g: 9.81 m/s^2}
bodies: {bar: {rod: {mass: m, length: L}}}
connections:
  A: {slot: {pin: bar.start, along: up, through: ground.O}}
  B: {slot: {pin: bar.end, along: right, through: ground.O}}
loads: {weight: {gravity: g}}
measures: {theta: angle of bar clockwise}
start: {theta: a, rate(theta): 0}
"""
LEVEL = """
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {th: angle of rod clockwise}
start: {th: 0, rate(th): 0}
"""
THROWN = """
parameters: {v0: 15 m/s, theta: 70 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(theta), rate(y): v0*sin(theta)}
"""
CASES = {
    "where a hinge pushes no longer sideways": (ROD, "th when horizontal reaction of hinge = 0", "acos(2*cos(a)/3)"),
    "how fast it is there": (
        ROD,
        "velocity of th when horizontal reaction of hinge = 0",
        "sqrt(g*cos(a)/L)",
    ),
    # F = 9 m g sin(2 a)/8 from the horizontal a = 0: sin(2 a) = 8/9, a counted from there
    "at a size": (LEVEL, "th when |horizontal reaction of hinge| = m*g", "asin(8/9)/2"),
    "at a size in words": (LEVEL, "th when size of horizontal reaction of hinge = m*g", "asin(8/9)/2"),
    # against V = m g (1 + 9 sin(a)^2)/4: 10 tan(a)^2 - 9 tan(a) + 1 = 0
    "at a sum": (
        LEVEL,
        "th when horizontal reaction of hinge + vertical reaction of hinge = 0",
        "atan((9 - sqrt(41))/20)",
    ),
    "at an equation between two": (
        LEVEL,
        "th when horizontal reaction of hinge = -vertical reaction of hinge",
        "atan((9 - sqrt(41))/20)",
    ),
    "where energies are as one to two": (THROWN, "y when kinetic energy = 2*potential energy", "v0^2/(6*g)"),
    "how fast it is when energies are alike": (
        THROWN,
        "speed of ball when kinetic energy = potential energy",
        "v0/sqrt(2)",
    ),
    "at an energy": (ROD, "th when kinetic energy = m*g*L/4", "acos(cos(a) - 1/2)"),
    "where a string pulls with the weight": (PENDULUM, "theta when tension of rope = m*g", "acos((1 + 2*cos(a))/3)"),
    "speed there": (PENDULUM, "speed of bob when tension of rope = m*g", "sqrt(2*g*L*(1 - cos(a))/3)"),
    # sin(q) from the wall: 3 m g cos(q) (2 sin(a) - 3 sin(q))/4, from which it is not told which place comes first
    "where a bar leaves the wall": (TRAMMEL, "theta when normal force of A = 0", "asin(2*sin(a)/3)"),
    "way to a speed": (SLOPE, "s when speed of block = v", "v^2/(2*g*sin(b))"),
    "time to a speed": (SLOPE, "time when speed of block = v", "v/(g*sin(b))"),
    "power at a speed": (SLOPE, "power of weight when kinetic energy = 5 J", "g*sin(b)*sqrt(2*m*5)"),
}


@pytest.mark.parametrize("name", CASES)
def test_an_event_of_a_quantity_has_the_place_of_a_textbook(name: str) -> None:
    model, question, formula = CASES[name]
    is_formula(model, question, formula, factors=(1.0, 1.02, 0.98))


def test_the_place_is_said() -> None:
    found = posed(PENDULUM, "speed of bob when tension of rope = m*g")
    assert any("acos((2·cos(a) + 1)/3)" in str(note) for note in found.notes)


def test_what_is_never_so_is_refused() -> None:
    found = posed(PENDULUM, "theta when tension of rope = 5*m*g")
    assert found.expression is None
    assert "does not come in a whole period of the motion" in str(found.reason)


def test_the_first_of_several_places_is_meant() -> None:
    # S = m g comes on the way down first, at the side of the start, and then on the other side
    found = posed(PENDULUM, "theta when tension of rope = m*g")
    assert isinstance(found.value, float)
    assert found.value > 0


def test_a_value_that_is_only_touched_is_reached() -> None:
    # the tension is largest at the lowest point, m g (3 - 2 cos a), and no more than that
    found = posed(PENDULUM, "theta when tension of rope = m*g*(3 - 2*cos(a))")
    assert found.value == pytest.approx(0.0, abs=1e-9)
    assert found.evidence is not None


def test_what_nothing_joins_changes_no_event() -> None:
    text = PENDULUM.replace("bodies: {", "bodies: {other: {particle: {mass: 7 kg}, at: [50 m, 60 m]}, ")
    is_formula(text, "theta when tension of rope = m*g", "acos((1 + 2*cos(a))/3)", factors=(1.0, 1.02))


def test_what_holds_at_the_start_is_meant_the_next_time() -> None:
    # at the start S = m g cos a, and again where the pendulum turns on the other side
    found = posed(PENDULUM, "theta when tension of rope = m*g*cos(a)")
    assert found.value is None or found.value == pytest.approx(-1.0471975512)


def test_a_motion_of_several_freedoms_is_refused() -> None:
    text = ROD.replace("connections: {hinge: {pin: [ground.O, rod.start]}}", "").replace("start: {th: a}", "")
    found = posed(text, "th when kinetic energy = 2 J")
    assert found.expression is None
    assert "one coordinate" in str(found.reason)


def test_the_unit_of_the_value_is_checked() -> None:
    with pytest.raises(ModelError, match="m/s"):
        posed(PENDULUM, "theta when tension of rope = 2 m/s")


def test_it_is_derived() -> None:
    system = System.from_text(PENDULUM + "questions: [speed of bob when tension of rope = m*g]\n")
    (derivation,) = fb.explain(system).derivations
    assert derivation.stages
    assert not derivation.reason
    told = fb.explain(system, language="de").to_text()
    assert "Zu diesem Zeitpunkt gilt: Zugkraft von rope = m·g" in told
    assert "place_0" not in told  # a name that stood for the place on the way


def test_a_change_since_the_start_counts_from_where_the_motion_starts() -> None:
    """A stone that leaves rest at the height h has v^2 = 2 g d when it has fallen by d, wherever it started."""
    is_formula(STONE, "speed of stone when y has changed by -d", "sqrt(2*g*d)")
    is_formula(STONE, "How fast is the stone after it has fallen 1 m?", "sqrt(2*g)")


PRESS = """
parameters: {J: 15 kg m^2, n: 20 rad/s, F: 50 kN, d: 12 mm, R: 0.1 m}
bodies: {wheel: {flywheel: {inertia: J}}, punch: {particle: {mass: 0}}}
ground: {points: {O: [0, 0]}}
connections:
  axle: {pin: [ground.O, wheel]}
  press: {rack_and_pinion: {pinion: wheel, rack: punch, radius: R, along: down}}
  guide: {slider: {body: punch, along: down}}
loads: {work: {force: {at: punch, along: up, magnitude: F}}}
measures: {phi: angle of wheel, y: MEASURE}
start: {phi: 0, rate(phi): RATE}
"""


@pytest.mark.parametrize("measure", ["height of punch", "{position of punch along down}"])
@pytest.mark.parametrize("asked", ["after the punch has moved d", "when y has moved d"])
def test_a_distance_is_gone_whichever_way_the_motion_begins(measure: str, asked: str) -> None:
    """J (n^2 - w^2)/2 = F d on the way down, whichever way its measure counts."""
    model = PRESS.replace("MEASURE", measure).replace("RATE", "n")
    is_formula(model, f"angular velocity of wheel {asked}", "sqrt(n^2 - 2*F*d/J)")


def test_a_distance_may_be_calculated_and_its_measure_need_no_name() -> None:
    """Two times d is no distance d of which the speed is doubled."""
    model = PRESS.replace("MEASURE", "height of punch").replace("RATE", "n")
    is_formula(model, "angular velocity of wheel when y has moved d*2", "sqrt(n^2 - 4*F*d/J)")
    is_formula(model, "angular velocity of wheel when angle of wheel has moved d/R", "sqrt(n^2 - 2*F*d/J)")


def test_the_side_on_which_a_distance_is_gone_is_said() -> None:
    model = PRESS.replace("MEASURE", "height of punch").replace("RATE", "n")
    found = posed(model, "speed of punch when y has moved d")
    assert "y decreases at first" in [str(note) for note in found.notes]


def test_a_wheel_that_turns_backwards_has_turned_so_far() -> None:
    """It is driven back against its motion by F R: J (n^2 - w^2)/2 = -F R th."""
    model = PRESS.replace("MEASURE", "height of punch").replace("RATE", "-n")
    is_formula(model, "time when y has moved d", "(sqrt(n^2 + 2*F*d/J) - n)/(F*R/J)")
    found = posed(model, "angular velocity of wheel after the wheel has turned 0.1 rad")
    assert found.value == pytest.approx(-((400 + 2 * 5000 * 0.1 / 15) ** 0.5))


def test_a_distance_from_where_nothing_moves_is_refused() -> None:
    model = PRESS.replace("MEASURE", "height of punch").replace("RATE", "0")
    found = posed(model.replace("magnitude: F", "magnitude: 0 N"), "time when y has moved d")
    assert found.expression is None


@pytest.mark.parametrize(
    ("language", "said"), [("en", "when y has changed by -d"), ("de", "sich y um -d geändert hat")]
)
def test_an_exercise_asks_for_a_change_by_its_value(language: str, said: str) -> None:
    system = System.from_text(f"{STONE}questions: {{it: speed of stone when y has changed by -d}}\n")
    [question] = system.questions
    assert said in Catalogue(language).plain(asking(system, question)).replace("\u2212", "-")


def test_the_greatest_size_of_a_force_that_pushes_either_way_is_where_its_square_is() -> None:
    """F = 9 m g sin(2 a)/8 of a rod from the horizontal, to either side."""
    is_formula(LEVEL, "greatest size of horizontal reaction of hinge", "9*m*g/8")
    is_formula(LEVEL, "greatest |horizontal reaction of hinge|", "9*m*g/8")


BOAT = """
parameters: {m: 900 kg, c: 60 kg/s, v0: 6 m/s, F: 500 N}
bodies: {boat: {particle: {mass: m}, at: [0, 0], velocity: [v0, 0]}}
connections: {rail: {guide: {body: boat, along: right}}}
loads: {drag: {law: {measure: x, force: -c*rate(x)}}, thrust: {force: {on: boat, along: right, value: F}}}
measures: {x: x of boat}
"""


def test_a_speed_is_reached_where_the_rate_is_so_whatever_the_place() -> None:
    """v = F/c + (v0 - F/c) exp(-c t/m); half way between v0 and F/c after m log(2)/c, and x = (m (v0 - v) + F t)/c."""
    is_formula(BOAT, "time when speed of boat = (v0 + F/c)/2", "m*log(2)/c")
    is_formula(BOAT, "x when speed of boat = (v0 + F/c)/2", "(m*(v0 - F/c)/2 + F*m*log(2)/c)/c")
    is_derived(BOAT, "time when speed of boat = (v0 + F/c)/2")


BELT = """
parameters: {J1: 0.2 kg m^2, J2: 1.5 kg m^2, r1: 0.1 m, r2: 0.3 m, M: 20 N m, ML: 30 N m, w: 100 rad/s}
bodies:
  motor: {disk: {inertia: J1, radius: r1}, at: [0, 0]}
  fan: {disk: {inertia: J2, radius: r2}, at: [1 m, 0]}
connections:
  bearing: {pin: [ground.A, motor.center]}
  axle: {pin: [ground.B, fan.center]}
  belt: {belt: [motor, fan]}
loads: {drive: {torque: {on: motor, magnitude: M}}, load: {torque: {on: fan, magnitude: -ML}}}
"""


def test_a_speed_is_reached_in_a_machine_whose_angles_nobody_named() -> None:
    """(J1 + J2 i^2) phi'' = M - i ML with i = r1/r2; the drive runs with w after w/phi''."""
    run_up = "(J1 + J2*r1^2/r2^2)*w/(M - r1/r2*ML)"
    is_formula(BELT, "time when angular velocity of motor = w", run_up)
    is_formula(BELT, "turns of motor until angular velocity of motor = w", f"w*{run_up}/(4*pi)")
    is_derived(BELT, "time when angular velocity of motor = w")


def test_revolutions_in_a_minute_stay_a_multiple_of_pi() -> None:
    found = posed(BELT, "time when angular velocity of motor = 300 rpm")
    assert isinstance(found.expression, Expr)
    assert to_text(found.expression).startswith("10·π·")
