"""Where things stand: what hangs on strings, what guides go through, and what the start of a model gives.

Angular momenta are counter-clockwise, r x m v of every mass and I w of what turns; drops are positive downwards.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from declared import undeclared
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate

Agree = Callable[[fb.Solution, str, str | list[str]], None]
EXAMPLES = Path(__file__).parent.parent / "examples"
G = "g: 9.81 m/s^2"
WEIGHT = "loads: {weight: {gravity: g}}\n"
ATWOOD = f"""
parameters: {{m1: 3 kg, m2: 2 kg, M: 1 kg, R: 0.1 m, {G}}}
bodies: {{pulley: {{disk: {{mass: M, radius: R}}}}, a: {{particle: {{mass: m1}}}}, b: {{particle: {{mass: m2}}}}}}
connections: {{axle: {{pin: [ground.O, pulley]}}, rope: {{string: {{from: a, over: [pulley], to: b}}}}}}
measures: {{x: drop of a, y: drop of b}}
"""

# name: model, formula by question
PROBLEMS: dict[str, tuple[str, dict[str, str | list[str]]]] = {
    # the masses hang at -R and R: (-R)(-m1 x') + R m2 x' + M R^2/2 x'/R; level with each other at the start, y = -x
    "masses hang beside the axle": (
        ATWOOD + WEIGHT,
        {
            "angular momentum about ground.O": "(m1 + m2 + M/2)*R*rate(x)",
            "x of a": "-R",
            "x of b": "R",
            "distance from a to b": "2*sqrt(R**2 + x**2)",
        },
    ),
    # the other sense, by where the ends are put
    "masses put straight below the rim hang there": (
        ATWOOD.replace("m1}}", "m1}, at: [R, -1 m]}")
        .replace("m2}}", "m2}, at: [-R, -2 m]}")
        .replace("x: drop of a, y", "y")
        + WEIGHT,
        {
            "position of a at start": ["R", "-1"],
            "position of b at start": ["-R", "-2"],
            "acceleration of y": "(m2 - m1)*g/(m1 + m2 + M/2)",
        },
    ),
    # equal masses balance; the spring hangs straight below a: k/(2 m + M/2)
    "a spring below a hanging hook": (
        ATWOOD.replace("m1}", "m2}")
        + "ground: {points: {O: [0, 0], P: [-R, -2 m]}}\n"
        + "loads: {weight: {gravity: g}, s: {spring: {first: ground.P, second: a, stiffness: 5 N/m, length: 1 m}}}\n",
        {"natural frequencies": "sqrt(5/(2*m2 + M/2))"},
    ),
    # each lead is tangent to both of its circles: at 2 + 3 R behind the third pulley
    "pulleys of different radius in a row": (
        f"""
parameters: {{m1: 5 kg, m2: 2 kg, R: 0.1 m, {G}}}
ground: {{points: {{A: [0, 0], B: [1 m, 0], C: [2 m, 0]}}}}
bodies:
  left: {{particle: {{mass: m1}}}}
  p1: {{disk: {{radius: R}}}}
  p2: {{disk: {{radius: 2*R}}}}
  p3: {{disk: {{radius: 3*R}}}}
  right_weight: {{particle: {{mass: m2}}}}
connections:
  a1: {{pin: [ground.A, p1]}}
  a2: {{pin: [ground.B, p2]}}
  a3: {{pin: [ground.C, p3]}}
  it: {{string: {{path: [left, over p1, over p2, over p3, right_weight]}}}}
{WEIGHT}
""",
        {"x of left": "-R", "x of right_weight": "2 + 3*R"},
    ),
    # the block rises by y' at -(R + r), the weight sinks by 2 y' at R
    "a movable pulley": (
        f"""
parameters: {{m1: 2 kg, m2: 3 kg, R: 0.1 m, r: 0.2 m, {G}}}
ground: {{points: {{O: [0, 0], C: [-R - 2*r, 0]}}}}
bodies:
  fixed_pulley: {{disk: {{radius: R}}}}
  moving: {{disk: {{mass: m2, radius: r}}}}
  weight: {{particle: {{mass: m1}}}}
connections:
  axle: {{pin: [ground.O, fixed_pulley]}}
  it: {{string: {{path: [ground.C, under moving, over fixed_pulley, weight], grips: []}}}}
loads: {{gravity: {{gravity: g}}}}
measures: {{y: height of moving}}
""",
        {
            "x of moving": "-R - r",
            "acceleration of y": "(2*m1 - m2)*g/(4*m1 + m2)",
        },
    ),
    # the lower pulley hangs at R, its masses at R - r and R + r; 2 x1 + x2 + x3 is constant
    "a pulley that hangs": (
        f"""
parameters: {{m1: 4 kg, m2: 2 kg, m3: 1 kg, R: 0.1 m, r: 0.05 m, {G}}}
bodies:
  upper: {{disk: {{radius: R}}}}
  lower: {{disk: {{radius: r}}}}
  A: {{particle: {{mass: m1}}}}
  B: {{particle: {{mass: m2}}}}
  C: {{particle: {{mass: m3}}}}
connections:
  axle: {{pin: [ground.O, upper]}}
  rope1: {{string: {{from: A, over: [upper], to: lower}}}}
  rope2: {{string: {{from: B, over: [lower], to: C}}}}
{WEIGHT}
measures: {{x2: drop of B, x3: drop of C, x1: drop of A}}
start: {{x2: 1 m, x3: 1 m}}
""",
        {
            "x of B": "R - r",
            "x of C": "R + r",
            "angular momentum about ground.O": "-(R*m1*(rate(x2) + rate(x3))/2 + (R - r)*m2*rate(x2)"
            " + (R + r)*m3*rate(x3))",
        },
    ),
    # the string leaves the pulley at its top along the incline: the block moves at R above the axle's parallel
    "a block on an incline below a pulley": (
        f"""
parameters: {{m1: 3 kg, m2: 2.5 kg, M: 1 kg, R: 0.1 m, alpha: 30 deg, {G}}}
bodies:
  block: {{particle: {{mass: m1}}}}
  pulley: {{disk: {{mass: M, radius: R}}}}
  weight: {{particle: {{mass: m2}}}}
connections:
  incline: {{slider: {{body: block, along: alpha}}}}
  axle: {{pin: [ground.top, pulley]}}
  rope: {{string: {{from: block, over: [pulley], to: weight}}}}
loads: {{gravity: {{gravity: g}}}}
measures: {{s: travel of block along alpha}}
""",
        {
            "angular momentum about ground.top": "-(m1 + m2 + M/2)*R*rate(s)",
            "position of block": ["s*cos(alpha) - R*sin(alpha)", "s*sin(alpha) + R*cos(alpha)"],
        },
    ),
    # an elevator's cabin on its rails hangs at one side of the wheel, the counterweight at the other
    "an elevator": (
        f"""
parameters: {{m1: 800 kg, m2: 600 kg, M: 100 kg, R: 0.5 m, {G}}}
bodies:
  cabin: {{particle: {{mass: m1}}}}
  wheel: {{disk: {{mass: M, radius: R}}}}
  counter: {{particle: {{mass: m2}}}}
connections:
  rails: {{slider: {{body: cabin, along: up}}}}
  axle: {{pin: [ground.O, wheel]}}
  rope: {{string: {{from: counter, over: [wheel], to: cabin}}}}
{WEIGHT}
measures: {{h: height of cabin}}
""",
        {"x of cabin": "R", "x of counter": "-R", "angular momentum about ground.O": "(m1 + m2 + M/2)*R*rate(h)"},
    ),
    # stepped drum: w (J + m1 R1^2 + m2 R2^2)
    "a stepped drum": (
        f"""
parameters: {{m1: 6 kg, m2: 2 kg, J: 0.5 kg m^2, R1: 0.2 m, R2: 0.3 m, {G}}}
bodies: {{drum: {{body: {{inertia: J}}}}, a: {{particle: {{mass: m1}}}}, b: {{particle: {{mass: m2}}}}}}
connections:
  axle: {{pin: [ground.O, drum]}}
  left: {{string: {{from: wound on drum radius R1 at left, to: a}}}}
  right_cord: {{string: {{from: wound on drum radius R2 at right, to: b}}}}
{WEIGHT}
measures: {{phi: angle of drum}}
""",
        {"angular momentum about ground.O": "(J + m1*R1**2 + m2*R2**2)*rate(phi)"},
    ),
    # Weston's differential hoist: the block of radius (R + r)/2 hangs at (r - R)/2 and rises by (R - r)/2 a radian
    "a differential hoist": (
        f"""
parameters: {{m: 50 kg, J: 0.5 kg m^2, R: 0.3 m, r: 0.2 m, {G}}}
bodies: {{drum: {{body: {{inertia: J}}}}, block: {{disk: {{mass: m, radius: (R + r)/2}}}}}}
connections:
  axle: {{pin: [ground.O, drum]}}
  chain: {{string: {{path: [wound on drum radius R at left, under block, wound on drum radius r at right], grips: []}}}}
{WEIGHT}
measures: {{phi: angle of drum clockwise, y: height of block}}
start: {{phi: 0}}
""",
        {"x of block": "(r - R)/2", "rate of y": "(R - r)*rate(phi)/2"},
    ),
    # a bucket that a cart carries along moves as fast sideways as down: (M + 2 m) a = m g
    "a bucket beside a cart": (
        f"""
parameters: {{M: 5 kg, m: 1 kg, l: 0.4 m, {G}}}
ground: {{points: {{wall: [-3 m, 0]}}}}
bodies:
  cart: {{rectangle: {{mass: M, width: 2*l, height: 0.2 m}}, points: {{P: [l, 0]}}}}
  bucket: {{particle: {{mass: m}}}}
connections:
  rail: {{slider: {{body: cart, along: right}}}}
  rope: {{string: {{path: [ground.wall, over cart.P, bucket]}}}}
{WEIGHT}
measures: {{x: x of cart}}
""",
        {"acceleration of x": "-m*g/(M + 2*m)", "x of bucket": "x + l"},
    ),
    # a guide goes through where its body is put, also where it is named by a line beside
    "a carriage beside a line": (
        """
parameters: {m: 1 kg, r: 0.1 m, al: 0.15 rad}
ground: {lines: {rack: {along: al}}}
bodies: {car: {body: {mass: m}, at: [-r*sin(al), r*cos(al)]}}
connections: {guide: {slider: {body: car, along: rack}}}
measures: {s: travel of car along rack}
""",
        {
            "position of car": ["s*cos(al) - r*sin(al)", "s*sin(al) + r*cos(al)"],
            "angular momentum about ground.origin": "-m*r*rate(s)",
        },
    ),
    # else through the line
    "a carriage on a line": (
        """
parameters: {m: 1 kg, h: 0.1 m}
ground: {lines: {rail: {along: right, through: [0, h]}}}
bodies: {car: {particle: {mass: m}, near: {at: [1 m, 1 m]}}}
connections: {guide: {slider: {body: car, along: rail}}}
""",
        {"y of car": "h"},
    ),
    # the angle that a guide keeps is the one of the start: m a = F sin(90 deg) - m g, and no moment is needed
    "a bar that keeps the angle it is given": (
        f"""
parameters: {{m: 5 kg, F: 10 N, L: 1 m, be: 50 deg, {G}}}
bodies: {{bar: {{rectangle: {{mass: m, width: L, height: 0.05 m}}, angle: be}}}}
connections: {{guide: {{slider: {{body: bar, along: up}}}}}}
loads: {{push: {{force: {{at: bar.right, along: bar.x, magnitude: F}}}}, weight: {{gravity: g}}}}
measures: {{y: height of bar}}
""",
        {
            "acceleration of y": "F*sin(be)/m - g",
            "normal force of guide": "F*cos(be)",
            "moment of guide on bar about bar": "0",
        },
    ),
    # x = v t at x = 0, so the wheel turns from th by v t/r
    "a rolling wheel whose centre is driven": (
        """
parameters: {m: 1 kg, r: 1 m, v: 1 m/s, th: 0.5 rad}
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: m, radius: r}}}
connections: {contact: {rolling: {body: wheel, on: floor}}, pull: {driver: {measure: x of wheel, follows: v*t}}}
measures: {phi: angle of wheel clockwise}
start: {phi: th}
""",
        {"position of phi": "th + v*t/r", "angular velocity of wheel": "-v/r"},
    ),
    "a rolling wheel whose centre is driven from an angle of its body": (
        """
parameters: {m: 1 kg, r: 1 m, v: 1 m/s}
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: m, radius: r}, angle: 30 deg}}
connections: {contact: {rolling: {body: wheel, on: floor}}, pull: {driver: {measure: x of wheel, follows: v*t}}}
""",
        {"angular velocity of wheel": "-v/r", "angle of wheel": "pi/6 - v*t/r"},
    ),
}

RACK = f"""
parameters: {{J: 0.02 kg m^2, r: 0.05 m, M: 4 N m, m: 5 kg, {G}}}
bodies:
  pinion: {{body: {{inertia: J, radius: r}}}}
  rack: {{rectangle: {{mass: m, width: 0.04 m, height: 1 m}}}}
connections:
  axle: {{pin: [ground.O, pinion]}}
  guide: {{slider: {{body: rack, along: up}}}}
  teeth: {{rack_and_pinion: {{pinion: pinion, rack: rack}}}}
loads: {{drive: {{torque: {{on: pinion, magnitude: M}}}}, weight: {{gravity: g}}}}
measures: {{y: height of rack}}
"""
# a counter-clockwise pinion lifts the rack on its right, M r - m g r^2 = (J + m r^2) y'', lowers the one on its left
PROBLEMS |= {
    "a rack that is lifted": (RACK, {"acceleration of y": "(M*r - m*g*r**2)/(J + m*r**2)"}),
    "a rack put on the left": (
        RACK.replace("height: 1 m}", "height: 1 m}, at: [-r, 0]"),
        {"acceleration of y": "-(M*r + m*g*r**2)/(J + m*r**2)"},
    ),
    "a rack that lies on its side": (
        RACK.replace("height: 1 m}", "height: 1 m}, angle: 90 deg"),
        {"acceleration of y": "(M*r - m*g*r**2)/(J + m*r**2)"},
    ),
    # a pinion that climbs a fixed rack on its right: J y''/r^2 + m y'' = M/r - m g, turning clockwise to go up
    "a pinion that climbs": (
        f"""
parameters: {{J: 0.02 kg m^2, r: 0.05 m, M: 4 N m, m: 5 kg, {G}}}
bodies:
  pinion: {{body: {{mass: m, inertia: J, radius: r}}}}
  rack: {{rectangle: {{width: 0.04 m, height: 1 m}}, fixed: true}}
connections:
  track: {{slot: {{pin: pinion, along: up}}}}
  teeth: {{rack_and_pinion: {{pinion: pinion, rack: rack}}}}
loads: {{drive: {{torque: {{on: pinion, magnitude: -M}}}}, weight: {{gravity: g}}}}
measures: {{y: height of pinion}}
""",
        {"acceleration of y": "(M*r - m*g*r**2)/(J + m*r**2)"},
    ),
}


@functools.cache
def solved(name: str) -> fb.Solution:
    model, known = PROBLEMS[name]
    return fb.solve(fb.System.from_text(model + "questions:\n" + "".join(f"  - {{find: '{q}'}}\n" for q in known)))


@pytest.mark.parametrize("name", PROBLEMS)
def test_things_stand_where_the_model_puts_them(name: str, agrees: Agree) -> None:
    known = PROBLEMS[name][1]
    for k, (question, formula) in enumerate(known.items()):
        assert question
        agrees(solved(name), f"q{k + 1}", formula)
    assert not undeclared(solved(name))


def test_teeth_across_the_guide_of_their_rack_are_refused() -> None:
    with pytest.raises(fb.ModelError, match=r"teeth of rack run along right, but the guide of rack runs along up"):
        fb.System.from_text(RACK.replace("rack: rack}", "rack: rack, along: right}"))


def test_what_is_deduced_about_teeth_and_placed_ends_is_an_assumption() -> None:
    rack = fb.System.from_text(RACK)
    assert rack.assumptions == ("teeth: the teeth of rack run along its guide",)
    hung = fb.System.from_text(PROBLEMS["masses put straight below the rim hang there"][0])
    assert all("hangs straight down" in said for said in hung.assumptions)


# -- what nobody gave -------------------------------------------------------------------------
CART = f"""
parameters: {{M: 2 kg, m: 1 kg, L: 1 m, v: 1 m/s, th: 30 deg, {G}}}
bodies: {{cart: {{particle: {{mass: M}}}}, rod: {{rod: {{mass: m, length: L}}}}}}
connections: {{rail: {{slider: {{body: cart, along: right}}}}, hinge: {{pin: [cart, rod.start]}}DRIVE}}
{WEIGHT}
measures: {{x: x of cart, theta: angle of rod from down}}
"""
GIVEN = CART.replace("DRIVE", "") + "start: {theta: th, rate(x): v}\n"
DRIVEN = CART.replace("DRIVE", ", drive: {driver: {measure: x, follows: v*t}}") + "start: {theta: th}\n"
LEAST = "rate(theta) at the start is not given; it is taken to be that of the least kinetic energy"


@pytest.mark.parametrize("model", [GIVEN, DRIVEN], ids=["given", "driven"])
def test_a_rate_that_nobody_gives_has_the_least_energy_and_is_an_assumption(model: str, agrees: Agree) -> None:
    """d/dw of m/2 ((v + L/2 w cos th)^2 + (L/2 w sin th)^2) + m L^2/24 w^2 vanishes at w = -3 v cos(th)/(2 L)."""
    system = fb.System.from_text(model)
    solution = fb.solve(system, "velocity of theta at start")
    agrees(solution, "q1", "-3*v*cos(th)/(2*L)")
    assert solution.assumptions == (LEAST,)
    assert solution.to_plain()["assumptions"] == [LEAST]
    assert fb.simulate(system, 0.01).summary()["assumptions"] == [LEAST]


def test_rates_that_are_given_are_no_assumption() -> None:
    given = fb.System.from_text(GIVEN.replace("rate(x): v", "rate(x): v, rate(theta): 0"))
    assert fb.solve(given, "velocity of theta at start").assumptions == ()
    assert fb.simulate(given, 0.01).summary()["assumptions"] == []


BOOM = """
space: true
parameters: {L: 6 m, be: 0.7 rad, bd: 0.2 rad/s, W: 0.4 rad/s, J: 1 kg m^2}
bodies:
  boom:
    body: {mass: 1 kg, inertia: [J, J, J]}
    turned: [psi about y, beta about z, rho about x]
    points: {tip: [L, 0, 0]}
connections:
  hinge: {spherical: [ground.O, boom]}
  slew: {driver: {measure: psi, follows: W*t}}
  luff: {driver: {measure: beta, follows: be + bd*t}}
questions: [velocity of beta, speed of boom.tip, velocity of rho at start]
"""


def test_the_third_angle_of_a_driven_boom_is_an_assumption(agrees: Agree) -> None:
    """With equal moments |omega|^2 is least: omega has no component along the boom, which W gives sin(beta) of."""
    solution = fb.solve(fb.System.from_text(BOOM))
    agrees(solution, "q1", "bd")
    agrees(solution, "q2", "L*sqrt(bd**2 + W**2*cos(be + bd*t)**2)")
    agrees(solution, "q3", "-W*sin(be)")
    assert [text.split()[0] for text in solution.assumptions] == ["rate(rho)"]
    assert not undeclared(solution)


TOP = """
space: {up: z}
parameters: {m: 0.5 kg, l: 0.05 m, I1: 0.002 kg m^2, I3: 6e-4 kg m^2, w3: 170 rad/s}
bodies:
  top: {body: {mass: m, inertia: [I1, I1, I3], about: [0, 0, -l]}, points: {tip: [0, 0, -l]}, turned: TURNED}
connections: {tip: {spherical: [ground.O, top.tip]}}
start: {psi: 0, theta: MIDDLE, phi: 0, rate(phi): w3}
questions: [degrees of freedom]
"""


@pytest.mark.parametrize(
    ("turned", "middle", "instead"),
    [
        ("[psi about z, theta about x, phi about z]", "0", "psi about x, theta about y, phi about z"),
        ("[psi about x, theta about y, phi about z]", "90 deg", "psi about y, theta about x, phi about z"),
    ],
)
def test_a_start_where_angles_are_not_determined_is_refused_by_name(turned: str, middle: str, instead: str) -> None:
    text = TOP.replace("TURNED", turned).replace("MIDDLE", middle)
    with pytest.raises(fb.ModelError, match=r"psi and phi turn top about the same axis") as refused:
        fb.solve(fb.System.from_text(text))
    assert f"turned: [{instead}]" in str(refused.value)
    other = fb.System.from_text(TOP.replace("TURNED", f"[{instead}]").replace("MIDDLE", "0"))
    assert fb.solve(other).degrees_of_freedom == 3


TRUCK = f"""
parameters: {{M: 5 kg, m: 1 kg, r: 0.1 m, al: 0.2 rad, {G}}}
bodies:
  truck:
    {{rectangle: {{mass: M, width: 3 m, height: 1 m}}, TURNED lines: {{road: {{along: ROAD, through: [0, 0.5 m]}}}}}}
  pipe: {{ring: {{mass: m, radius: r}}}}
connections: {{road: {{slider: {{body: truck, along: right}}}}, contact: {{rolling: {{body: pipe, on: truck.road}}}}}}
{WEIGHT}
measures: {{x: x of truck, s: travel of pipe along truck.road}}
questions: [acceleration of x, angle of pipe]
"""


@pytest.mark.parametrize(("turned", "road"), [("angle: al,", "x"), ("near: {angle: al},", "x"), ("", "al")])
def test_a_slider_keeps_the_angle_that_is_given_or_none(turned: str, road: str, agrees: Agree) -> None:
    """(M + m) x'' + m cos(al) s'' = 0, m cos(al) x'' + 2 m s'' = -m g sin(al): the guide keeps the truck's angle, which
    nothing tilts to bring the pipe on its bed; where along it the pipe begins is an assumption."""
    solution = fb.solve(fb.System.from_text(TRUCK.replace("TURNED", turned).replace("ROAD", road)))
    agrees(solution, "q1", "m*g*sin(al)*cos(al)/(2*M + m + m*sin(al)**2)")
    *open_places, kept = solution.assumptions  # for which places the angle of the pipe is told, and what it keeps there
    assert kept.startswith("contact_no_slip_0")
    assert all(text.startswith("nothing says what") and "e-" not in text for text in open_places)
    assert not undeclared(solution)


# -- what is nothing, and what is equal -------------------------------------------------------
def test_a_spring_beside_a_bar_of_its_length_pulls_nothing() -> None:
    """It joins the ends of a rigid bar, whose length does not change: a zero of cancelled parts."""
    answer = fb.solve(fb.System.load(EXAMPLES / "multi_bar_platform.yaml"), "force in spring")["q1"]
    assert answer.to_plain()["expression"] == "0"
    assert answer.value == 0.0


def test_bars_of_a_parallelogram_turn_alike(agrees: Agree) -> None:
    """Three bars of m L^2/3 and the coupler, which m L^2 carries round: T = 2 m L^2 alpha."""
    system = fb.System.load(EXAMPLES / "parallelogram_with_extra_bar.yaml")
    agrees(fb.solve(system, "ratio of angular velocity of right to angular velocity of left"), "q1", "1")
    agrees(fb.solve(system, "acceleration of theta"), "q1", "T/(2*m*L**2)")


# -- ends that coincide, sizes out of all bounds ----------------------------------------------
BALL = f"""
parameters: {{m: 1 kg, R: 0.2 m, {G}}}
ground: {{points: {{A: [1 m, 0], B: [2 m, 0]}}}}
bodies: {{p: {{disk: {{mass: m, radius: R}}}}, b: {{particle: {{mass: m}}, at: [1 m, 0]}}}}
{WEIGHT}
"""


@pytest.mark.parametrize(
    ("connection", "message"),
    [
        ("{string: {from: ground.A, to: b}}", "at the start ground.A and b are 0 m from each other"),
        ("{link: [ground.A, b]}", "at the start ground.A and b are in one place"),
        ("{weld: [ground.A, ground.B]}", "welds ground to itself"),
        ("{link: [ground.A, ground.B]}", "links ground to itself"),
        ("{link: [ground.B, b, 1e300 m]}", "1e300 m is too large or too small"),
    ],
)
def test_ends_that_coincide_and_sizes_without_bounds_are_refused(connection: str, message: str) -> None:
    with pytest.raises(fb.ModelError, match=message):
        fb.System.from_text(BALL + f"connections: {{it: {connection}}}\n")


def test_a_string_that_ends_inside_its_pulley_is_refused() -> None:
    inside = BALL + "connections: {axle: {pin: [ground.B, p]}, it: {string: {from: b, over: [p], to: ground.A}}}\n"
    with pytest.raises(fb.ModelError, match=r"put them more than 0.2 m apart"):
        fb.System.from_text(inside.replace("at: [1 m, 0]", "at: [1.9 m, 0]"))


def test_an_angle_of_a_line_without_length_is_refused_in_words() -> None:
    system = fb.System.from_text(BALL + "measures: {phi: angle of line from ground.A to b}\n")
    assert "two points coincide" in fb.solve(system, "phi at start")["q1"].reason
    with pytest.raises(fb.FreebodyError, match="two points coincide"):
        fb.simulate(system, 0.1)


def test_a_stop_on_what_never_changes_is_open_for_ever() -> None:
    measure = "measures: {d: distance from ground.A to ground.B}\n"
    system = fb.System.from_text(BALL + measure + "connections: {it: {stop: {measure: d, min: 0.5 m}}}\n")
    assert fb.solve(system, "d")["q1"].value == 1.0
    assert fb.simulate(system, 0.1).status.name == "FINISHED"


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (("{pin: [ground.O, pulley]}", "{slot: {pin: pulley, along: right}}"), "a is kept straight below pulley"),
        (("to: b}", "to: b, leads: [right, down]}"), "a stays on the line of its lead"),
    ],
)
def test_what_is_taken_for_granted_of_hanging_bodies_is_an_assumption(changed: tuple[str, str], said: str) -> None:
    system = fb.System.from_text(ATWOOD.replace(*changed))
    assert any(said in text for text in system.assumptions)
    assert fb.System.from_text(ATWOOD).assumptions == ()


def test_a_lead_that_cannot_be_vertical_is_an_assumption() -> None:
    """A movable pulley of radius r between two leads that are not 2 r apart."""
    model = PROBLEMS["a movable pulley"][0]
    assert fb.System.from_text(model).assumptions == ()
    askew = fb.System.from_text(model.replace("C: [-R - 2*r, 0]", "C: [-R - 3*r, 0]"))
    assert len(askew.assumptions) == 1
    assert "would be at an angle to that" in askew.assumptions[0]


# -- ground points that are not declared ------------------------------------------------------------
FRAME = """
parameters: {a: 2 m, F: 3 kN}
bodies:
  left: {rod: {length: a*sqrt(2)}, angle: 45 deg, at: {start: [0, 0]}}
  right: {rod: {length: a*sqrt(2)}, angle: -45 deg, at: {start: [a, a]}}
connections:
  A: {pin: [ground.A, left.start]}
  G: {pin: [left.end, right.start]}
  B: {JOINT}
loads: {push: {force: {at: left.center, along: right, magnitude: F}}}
"""


@pytest.mark.parametrize(
    "joint", ["pin: [ground.B, right.end]", "pin: {first: right.end, second: ground.B}", "weld: [ground.B, right.end]"]
)
def test_a_joint_on_the_ground_is_where_the_body_is_put_that_it_holds(joint: str) -> None:
    system = fb.System.from_text(FRAME.replace("JOINT", joint))
    places = [system.bodies["ground"].points[name] for name in ("A", "B")]
    numbers = {name: p.value for name, p in system.parameters.items() if p.value is not None}
    found = [[float(evaluate(c, numbers, FLOAT_FUNCTIONS)) for c in place] for place in places]
    assert np.asarray(found) == pytest.approx(np.array([(0.0, 0.0), (4.0, 0.0)]), abs=1e-12)


def test_a_three_hinged_frame_needs_no_points_of_the_ground() -> None:
    # B and G on a line of 45 deg: about A, F a/2 = 2 a B_y
    answers = fb.System.from_text(FRAME.replace("JOINT", "pin: [ground.B, right.end]")).solve("reaction of B").answers
    assert answers[0].value == pytest.approx((-750.0, 750.0))


def test_in_space_a_joint_is_where_the_body_is_put_as_well() -> None:
    system = fb.System.from_text("""
space: true
parameters: {L: 2 m}
bodies: {mast: {rod: {length: L}, turned: [-90 deg about y], at: {start: [1 m, 0, 0]}}, bob: {particle: {mass: 1 kg}}}
connections:
  foot: {spherical: [ground.A, mast.start]}
  head: {spherical: [ground.B, mast.end]}
  bob: {spherical: [mast.center, bob]}
""")
    place = system.bodies["ground"].points["B"]
    assert [float(evaluate(c, {"L": 2.0}, FLOAT_FUNCTIONS)) for c in place] == pytest.approx([1.0, 0.0, 2.0])


def test_where_nothing_puts_a_body_its_joint_has_no_place() -> None:
    with pytest.raises(fb.ModelError, match=r"ground.B has no position"):
        fb.System.from_text(FRAME.replace(", at: {start: [a, a]}", "").replace("JOINT", "pin: [ground.B, right.end]"))
