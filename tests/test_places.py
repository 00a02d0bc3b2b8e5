"""Where things stand: what hangs on strings, what guides go through, and what the start of a model gives.

Angular momenta are counter-clockwise, r x m v of every mass and I w of what turns; drops are positive downwards.
"""

from __future__ import annotations

import functools
from collections.abc import Callable

import pytest

import freebody as fb

Agree = Callable[[fb.Solution, str, str | list[str]], None]
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


def test_teeth_across_the_guide_of_their_rack_are_refused() -> None:
    with pytest.raises(fb.ModelError, match=r"teeth of rack run along right, but the guide of rack runs along up"):
        fb.System.from_text(RACK.replace("rack: rack}", "rack: rack, along: right}"))


def test_what_is_deduced_about_teeth_and_placed_ends_is_an_assumption() -> None:
    rack = fb.System.from_text(RACK)
    assert rack.assumptions == ("teeth: the teeth of rack run along its guide",)
    hung = fb.System.from_text(PROBLEMS["masses put straight below the rim hang there"][0])
    assert all("hangs straight down" in said for said in hung.assumptions)
