"""Warnings: what is legal in a model but unlikely to be meant, one message for each cause, none where all is well."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import freebody as fb
from freebody.cli import commands
from freebody.examples_folder import templates
from freebody.study.model_warnings import WarningKind

ROOT = Path(__file__).parents[1]
FILES = sorted([*(ROOT / "examples").glob("*.yaml"), *(ROOT / "src" / "freebody" / "templates").glob("*.yaml")])

SLOPE = """
parameters: {m: 1 kg, g: 9.81 m/s^2, alpha: ANGLE}
ground: {lines: {incline: {along: -alpha}}}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: incline}}}
loads: {w: {gravity: g}}
measures: {s: travel of block along incline}
"""
MOVABLE = """
parameters: {m: 2 kg, M: 5 kg, r: 5 cm, g: 9.81 m/s^2}
ground: {points: {E: [0, 0], C: [30 cm, 0]}, lines: {table: {along: right}}}
bodies: {block: {particle: {mass: m}}, edge: {disk: {radius: r}}, lower: {disk: {mass: M, radius: r}}}
connections:
  table: {slider: {body: block, along: table}}
  axle: {pin: [ground.E, edge]}
  rope: {string: {path: [block, over edge, WAY lower, ground.C]}}
loads: {w: {gravity: g}}
"""
ON_A_CART = """
parameters: {m: 3 kg, M: 8 kg, g: 9.81 m/s^2}
bodies:
  cart: {particle: {mass: M}, at: [0, 0]}
  crate: {rectangle: {mass: m, width: 40 cm, height: 60 cm}, at: [0, PLACE]}
connections: {floor: {slider: {body: cart, along: right}}, deck: {contact: {between: [crate, cart], friction: 0.4}}}
loads: {w: {gravity: g}}
"""
BESIDE = """
parameters: {M: 3 kg, m: 2 kg, L: 1 m, alpha: 30 deg, mu: 0.4, g: 9.81 m/s^2}
ground: {points: [A], lines: {slope: {through: A, along: alpha}}}
bodies: {cart: {block: {mass: M, width: L, height: L/5}}, bar: {rod: {mass: m, length: L}}}
connections:
  rail: {slider: {body: cart, along: slope}}
  p: {slot: {pin: cart.right, along: slope, through: PLACE, friction: mu}}
loads: {w: {gravity: g}}
"""
RUBBED = """
parameters: {I: 2 kg m^2, M: 0.3 N m}
bodies: {wheel: {body: {mass: 1 kg, inertia: I}}}
connections: {axle: {pin: [ground.O, wheel.mass_center]}}
loads: {rub: {law: {measure: phi, force: LAW}}}
measures: {phi: angle of wheel}
start: {phi: 0, rate(phi): 5 rad/s}
"""
ON_DECK = """
parameters: {M: 60 kg, m: 80 kg, F: 5 N}
bodies: {boat: {particle: {mass: M}, lines: {deck: {along: right}}}, man: {particle: {mass: m}}}
connections: {water: {slider: {body: boat, along: right}}, deck: {slider: {body: man, along: boat.deck}}}
loads: {push: {force: {at: man, along: right, magnitude: F}}}
measures: {x: x of boat, s: travel of man along boat.deckFROM}
start: {x: 0, s: 0}
"""
TURNED = """
parameters: {W: SPEED}
bodies: {wheel: {disk: {mass: 1 kg, radius: 0.2 m}}}
connections: {axle: {pin: [ground.O, wheel]}, motor: {driver: {measure: phi, follows: WAY}}}
measures: {phi: angle of wheel}
"""
PENDULUM = """
parameters: {m: 1 kg, g: 9.81 m/s^2, L: 1 m}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {w: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down}
start: {theta: ANGLE}
"""
PULLEY = """
parameters: {m: 1 kg, M: 2 kg, g: 9.81 m/s^2}
bodies: {block: {particle: {mass: m}}, weight: {particle: {mass: M}}, pulley: {disk: {radius: 5 cm}}}
connections: {rope: {rope: [block, pulley, weight]}AXLE}
loads: {w: {gravity: g}}
"""
DRUM = """
parameters: {m: 1 kg, M: 2 kg, R: 0.2 m, g: 9.81 m/s^2}
bodies: {drum: {disk: {mass: M, radius: R}}, load: {particle: {mass: m}}}
connections: {axle: {pin: [ground.A, drum]}, rope: {string: {from: END, to: load}}}
loads: {w: {gravity: g}}
"""
SPATIAL_DRUM = """
space: {up: z}
parameters: {m: 1 kg, M: 2 kg, R: 0.2 m, k: 1 kN/m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0, 0]}}
bodies: {drum: {disk: {mass: M, radius: R, axis: y}}, load: {particle: {mass: m}, at: [0, 0, -1 m]}}
connections: {axle: {revolute: {first: ground.A, second: drum, about: y}}}
loads: {w: {gravity: g}, rope: {elastic_string: {path: [load, END], stiffness: k, length: 1 m}}}
"""
HEAVY = """
parameters: {m: 4 kg, L: 10 m, M: 6 kg, R: 0.25 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [1 m, 0]}}
bodies: {drum: {disk: {mass: M, radius: R}}, chain: {rope: {mass: m, length: L}}}
connections:
  axle: {pin: [ground.A, drum]}
  rope: {heavy_rope: {rope: chain, from: drum, over: [ground.B], leads: [right, down]}}
loads: {w: {gravity: g}}
"""
BLOCK = """
parameters: {m: 1 kg, M: 2 kg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [0.05 m, 0]}}
bodies:
  load: {particle: {mass: M}}
  one: {disk: {mass: m, radius: 5 cm}}
  other: {disk: {mass: m, radius: 5 cm}, at: [0, -1 m]}
  weight: {particle: {mass: m}}
connections:
  axle: {pin: [ground.A, one]}
  hook: {pin: [other, load]}
  rope: {string: {path: [other, over one, under other, ground.B]}}
  second: {string: {path: [one, weight]}}
loads: {w: {gravity: g}}
"""
CAM = """
parameters: {h: 8 mm, r: 60 mm}
bodies:
  disk: {body: {mass: 1 kg, inertia: 0.01 kg m^2}}
  valve: {particle: {mass: 0.3 kg}, near: {at: [0, 70 mm]}}
connections:
  axle: {pin: [ground.O, disk]}
  guide: {slider: {body: valve, along: up}}
  cam: {cam: {cam: disk, follower: valve, base_radius: r, form: edge, lift: LIFT}}
measures: {phi: angle of disk from up}
start: {phi: 0}
"""
WALL = """
parameters: {m: 1 kg, R: 0.1 m}
ground: {points: {P: [0.5 m, 0]}, lines: {floor: {along: right}, wall: {through: ground.P, along: up}}}
bodies: {ball: {disk: {mass: m, radius: R}, at: [PLACE, 0.1 m]}, other: {particle: {mass: m}, at: [0.1 m, 1 m]}}
connections: {c: {rolling: {body: ball, on: floor}}, d: {contact: {between: [other, wall]}}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
LADDER = """
parameters: {m: 1 kg, L: 4 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: WAY}}}
bodies: {ladder: {rod: {mass: m, length: L}, angle: 120 deg}}
connections: {foot: {contact: {between: [ladder.start, floor], friction: 0.5}},
  head: {contact: {between: [ladder.end, wall]}}}
loads: {w: {gravity: g}}
"""
SPRING = """
bodies: {bob: {particle: {mass: 1 kg}, at: PLACE}}
loads: {w: {gravity: 9.81 m/s^2}, s: {spring: {first: ground.O, second: bob, stiffness: 9 N/m, length: 1 m}}}
"""
MAN = """
parameters: {L: 5 m, s: PLACE}
bodies: {ladder: {rod: {mass: 1 kg, length: L}, points: {S: [s - L/2, 0]}}, man: {particle: {mass: 80 kg}}}
connections: {A: {pin: [ground.A, ladder.start]}, stands: {weld: [man, ladder.S]}}
"""
CEILING = """
parameters: {m: 1 kg, R: 0.1 m}
ground: {points: {P: [0, 1 m]}, lines: {ceiling: {through: ground.P, along: left}}}
bodies: {block: {disk: {mass: m, radius: R}, at: [0, 0]}}
connections: {guide: {slider: {body: block, along: WAY}}, top: {contact: {between: [block, ceiling]}}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
CRANK = """
parameters: {r: 0.1 m, l: 0.4 m, m: 1 kg}
bodies: {crank: {rod: {length: r}}, rod: {rod: {length: l, mass: m}}}
connections: {main: {pin: [ground.O, crank.start]}, pin: {pin: [crank.end, rod.start]}, guide: {GUIDE}}
measures: {theta: angle of crank from right}
start: {theta: 60 deg}
"""
WHEEL = """
parameters: {m: 1 kg, R: 0.1 m, T: 1 N m}
bodies: {wheel: {disk: {mass: m, radius: R}}}
connections: {axle: {GUIDE}}
loads: {motor: {torque: {on: wheel, magnitude: T}}}
measures: {x: x of wheel}
"""
RACK = """
parameters: {m: 1 kg, R: 0.1 m}
bodies: {gear: {disk: {mass: m, radius: R}}, bar: {rod: {mass: m, length: 1 m}, at: [0, -0.1 m], angle: 0}}
connections: {axle: {pin: [ground.O, gear]}, GUIDES, teeth: {rack_and_pinion: {pinion: gear, rack: bar, along: right}}}
"""
PUSH = """
parameters: {m: 1 kg, F: 2 N}
bodies: {bob: {particle: {mass: m}}}
loads: {push: {force: {at: PLACE, along: right, magnitude: F}}}
"""
WEDGE = """
parameters: {m: 2 kg, M: 5 kg, a: 35 deg, h: 0.6 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {wedge: {body: {mass: M}, lines: {face: {along: a}}}, block: {particle: {mass: m}NEAR}}
connections:
  f: {slider: {body: wedge, along: floor}}
  s: {slot: {pin: block, along: wedge.face, on: wedge, through: wedge.origin}}
loads: {weight: {gravity: g}}
measures: {x: x of wedge, s: {distance from wedge.origin to block}}
start: {x: 0, s: h/sin(a)}
"""
ON_RAIL = "slider: {body: wheel, along: right}"
SLIDE, SLOT = "slider: {body: rod.end, along: right}", "slot: {pin: rod.end, along: right}"


TOGGLE = """
parameters: {a: 0.5 m, F: 400 N}
ground: {points: {A: [0, 0.9 m], D: [0, 0]}}
bodies: {upper: {rod: {length: a}NEAR}, lower: {rod: {length: a}}}
connections: {A: {pin: [ground.A, upper.start]}, B: {pin: [upper.end, lower.start]}, C: {pin: [lower.end, ground.D]}}
loads: {push: {force: {at: upper.end, along: left, magnitude: F}}}
"""

FOLDED = """
parameters: {P: 50 N, l: 0.5 m, k: 400 N/m, m: 1 kg}
bodies: {lower: {rod: {length: l}}, upper: {rod: {length: l}NEAR}, knee: {particle: {mass: m}}}
connections:
  A: {pin: [ground.A, lower.start]}
  B: {pin: [lower.end, upper.start]}
  n: {pin: [lower.end, knee]}
  guide: {slot: {pin: upper.end, along: up, through: ground.A}}
loads:
  push: {force: {at: upper.end, along: down, magnitude: P}}
  stay: {law: {measure: y, force: -k*y}}
measures: {theta: angle of lower from up, y: x of knee}
start: {theta: 0}
"""


SLEEVE = """
parameters: {L: 0.3 m, m: 0.5 kg, M: 1 kg, W: 12 rad/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {arm: {rod: {length: L}}, link: {rod: {length: L}}, ball: {particle: {mass: m}}, sleeve: {particle: {mass: M}}}
connections:
  O: {pin: [ground.O, arm.start]}
  ball: {pin: [arm.end, ball]}
  joint: {pin: [arm.end, link.start]}
  foot: {pin: [link.end, sleeve]}
  spindle: {slider: {body: sleeve, along: down, through: ground.O}}
measures: {theta: angle of arm from down, y: drop of sleeve below ground.O}
loads: {weight: {gravity: g}}
start: {theta: 30 deg, rate(theta): 0}
"""


@pytest.mark.parametrize(
    ("text", "y", "there"), [(FOLDED, "height of upper.end", 1.0), (SLEEVE, "y", 0.6 * 3**0.5 / 2)]
)
def test_bars_of_one_length_start_stretched_where_nobody_folds_them(text: str, y: str, there: float) -> None:
    """The end of two bars of the length l is 2 l cos(theta) from the first pin, or at that pin itself."""
    system = fb.System.from_text(text.replace("NEAR", ""))
    assert not [w for w in system.warnings if w.kind == "elbow open"]
    [answer] = system.solve(f"{y} at start").answers
    assert answer.value == pytest.approx(there)


def test_bars_that_are_said_to_be_folded_are() -> None:
    system = fb.System.from_text(
        SLEEVE.replace("link: {rod: {length: L}}", "link: {rod: {length: L}, near: {angle: 120 deg}}")
    )
    [answer] = system.solve("y at start").answers
    assert answer.value == pytest.approx(0.0, abs=1e-9)


def warned(text: str) -> list[tuple[str, str]]:
    return [(w.kind, w.text()) for w in fb.System.from_text(text).warnings]


BRACKET = """
parameters: {h: 0.15 m, b: 0.06 m, mu: 0.25, x: 0.4 m, P: 200 N}
ground:
  points: {L: [0, 0], R: [b, 0]}
  lines: {left: {along: up, through: L}, right: {along: WAY, through: R}}
bodies:
  bracket: {body: {mass: 0}, points: {upper: [0, h], lower: [b, 0], end: [b/2 + x, 0]}, at: [0, 0]}
connections:
  A: {contact: {between: [bracket.upper, left], friction: mu}}
  B: {contact: {between: [bracket.lower, right], friction: mu}}
loads: {load: {force: {at: bracket.end, along: down, magnitude: P}}}
"""


def test_a_bracket_round_a_post_is_not_inside_it() -> None:
    # its two points touch the post from either side; N h = P x and 2 mu N >= P, so that x >= h/(2 mu)
    system = fb.System.from_text(BRACKET.replace("WAY", "down"))
    assert not system.warnings
    assert float(system.solve("least x so that it stays at rest")["q1"].value) == pytest.approx(0.3)


STRUCK_LATER = """
parameters: {M: 2 kg, L: 1 m, m: 0.5 kg, b: 0.9 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {rod: {rod: {mass: M, length: L}, at: {start: O}, angle: 0 deg}, ball: {particle: {mass: m}, at: [0, -b]}}
connections:
  O: {pin: [ground.O, rod.start]}
  table: {slider: {body: ball, along: right}}
  hit: {contact: {body: ball, on: rod, restitution: 0.6}}
loads: {weight: {gravity: g}}
"""
ON_A_TABLE = """
space: {up: z}
parameters: {J: 2 kg m^2, m: 5 kg, L: 0.8 m, g: 9.81 m/s^2}
bodies: {table: {body: {inertia: [J, J, J]}}, arm: {rod: {mass: m, length: L}}}
connections:
  axle: {revolute: {first: ground.O, second: table, about: z}}
  shoulder: {revolute: {first: table, second: arm.start, about: y}}
loads: {weight: {gravity: g}}
measures: {psi: angle of table about z, theta: angle of arm about y AGAINST}
"""


@pytest.mark.parametrize(
    ("text", "kind", "says"),
    [
        (SLOPE.replace("ANGLE", "60 rad"), "many turns", "60 rad is 9.5 turns. If degrees are meant, write 60 deg"),
        (PENDULUM.replace("ANGLE", "30 rad"), "many turns", "write 30 deg"),
        (TURNED.replace("SPEED", "2 Hz").replace("WAY", "W*t"), "hertz", "taken as 2 rad/s. Write 2 rev/s if"),
        (TURNED.replace("SPEED", "1 rad").replace("WAY", "W*sin(0.5 kHz*t)"), "hertz", "Write 500 rev/s"),
        (RUBBED.replace("LAW", "-M*phi").replace("5 rad/s", "-5 Hz"), "hertz", "-5 Hz is a frequency in hertz where"),
        # n = 300 1/min counts turns: omega = 2 pi n = 10 pi rad/s
        (TURNED.replace("SPEED", "300 1/min").replace("WAY", "W*t"), "hertz", "taken as 5 rad/s. Write 300 rpm if"),
        (TURNED.replace("SPEED", "300 min^-1").replace("WAY", "W*t"), "hertz", "Write 300 rpm if"),
        (TURNED.replace("SPEED", "{value: 30, unit: 1/min}").replace("WAY", "W*t"), "hertz", "Write 30 rpm if"),
        (RUBBED.replace("LAW", "-M*phi").replace("5 rad/s", "-30 1/min"), "hertz", "-30 1/min is a speed in turns"),
        (SLOPE.replace("ANGLE", "20 deg, mu: 0.1"), "unused", "mu is used nowhere in the model"),
        (
            PULLEY.replace("AXLE", "")
            .replace("[block", "[ground.A")
            .replace("block: {particle: {mass: m}}, ", "")
            .replace("m: 1 kg, ", ""),
            "loose pulley",
            "hold it, e.g. axle: {pin: [ground.A, pulley]}",
        ),
        (
            ON_A_CART.replace("PLACE", "30 cm"),
            "on a point",
            "cart is a particle, so crate balances on a point and tips about it",
        ),
        (
            DRUM.replace("from: END, to: load", "path: [drum, load]"),
            "tied at the axle",
            "write wound on drum in place of drum; else drum.center",
        ),
        (SPATIAL_DRUM.replace("END", "drum"), "tied at the axle", "write wound on drum in place of drum"),
        (HEAVY, "tied at the axle", "write wound_on: drum in place of drum"),
        (WALL.replace("PLACE", "0.45 m"), "inside a wall", "{contact: {between: [ball, wall]}}"),
        (LADDER.replace("WAY", "up"), "inside a wall", "ladder starts inside wall, which is solid on the right"),
        (CEILING.replace("WAY", "right"), "out of reach", "top never touches: the gap is 0.9 m at the start"),
        (
            CRANK.replace("GUIDE", SLIDE),
            "locked rotation",
            "nothing can move. If a point of rod is guided, write slot: {",
        ),
        (WEDGE.replace("NEAR", ""), "side open", "how far block is from wedge.origin, but not on which side"),
        (PUSH.replace("PLACE", "ground"), "no effect", "push acts on ground, which cannot move"),
        (WHEEL.replace("GUIDE", ON_RAIL), "locked rotation", "so that motor has no effect"),
        (
            SPRING.replace("PLACE", "[0, 0]"),
            "ends meet",
            "s acts between ground.O and bob, which start at the",
        ),
        (TOGGLE.replace("NEAR", ""), "elbow open", "fit with upper.end on either side"),
        # z = phi/pi runs to 2: h (10 z^3 - 15 z^4 + 6 z^5) is 32 h there, h z (2 - z) has the slopes +-2 h/pi
        (
            CAM.replace("LIFT", "h*(10*(phi/pi)^3 - 15*(phi/pi)^4 + 6*(phi/pi)^5)"),
            "cam open",
            "changes by 0.256 m over",
        ),
        (CAM.replace("LIFT", "h*phi/pi*(2 - phi/pi)"), "cam open", "changes by -0.01019 m per rad over"),
        (MAN.replace("PLACE", "6 m"), "off the rod", "S lies 1 m beyond the end of ladder"),
        (ON_DECK.replace("FROM", ""), "counted from the ground", "the way of boat is in it"),
        (MOVABLE.replace("WAY", "over"), "loose pulley", "path: [..., under lower, ...]"),
        (BESIDE.replace("PLACE", "bar.end"), "guide goes along", "act between cart and bar"),
        (RUBBED.replace("LAW", "-M*sign(rate(phi))"), "friction as a law", "{dry_friction: {measure: phi, force: M}}"),
        (ON_A_TABLE.replace("AGAINST", ""), "hinge turned away", "angle of arm about ... relative to table"),
    ],
)
def test_what_is_unlikely_is_told_once_with_its_cure(text: str, kind: str, says: str) -> None:
    ((found, told),) = warned(text)
    assert found == kind
    assert says in told


@pytest.mark.parametrize(
    "text",
    [
        RUBBED.replace("LAW", "-M*sign(phi)"),
        MOVABLE.replace("WAY", "under"),
        BESIDE.replace("PLACE", "bar.end, on: bar").replace("along: slope, th", "along: bar.x, th"),
        BESIDE.replace("pin: cart.right", "pin: bar.end").replace("PLACE", "ground.A"),
        TURNED.replace("SPEED", "2 Hz").replace("WAY", "2*pi*W*t"),
        TURNED.replace("SPEED", "2 Hz").replace("WAY", "sin(t/(3/W))"),
        TURNED.replace("SPEED", "120 rpm").replace("WAY", "W*t"),
        TURNED.replace("SPEED", "120 1/min").replace("WAY", "2*pi*W*t"),
        ON_A_CART.replace("PLACE", "-30 cm"),  # the particle lies on the crate
        SLOPE.replace("ANGLE", "60 deg"),
        SLOPE.replace("ANGLE", "0.5 rad"),
        PENDULUM.replace("ANGLE", "720 deg"),
        WALL.replace("PLACE", "0.3 m"),
        PULLEY.replace("AXLE", ", axle: {pin: [ground.A, pulley]}"),
        DRUM.replace("END", "drum.center"),
        DRUM.replace("END", "wound on drum"),
        BLOCK,
        LADDER.replace("WAY", "down"),
        CEILING.replace("WAY", "up"),
        CRANK.replace("GUIDE", SLOT),
        WHEEL.replace("GUIDE", "slot: {pin: wheel, along: right}"),
        PUSH.replace("PLACE", "bob"),
        SPRING.replace("PLACE", "[0, -1 m]"),
        SPRING.replace("PLACE", "[0, 0]").replace("length: 1 m", "length: 0"),
        FOLDED.replace("NEAR", ", near: {angle: 90 deg}"),
        MAN.replace("PLACE", "4 m"),
        CAM.replace("LIFT", "h/2*(1 - cos(phi))"),
        WEDGE.replace("NEAR", ", near: {at: [1 m, 1 m]}"),
        RACK.replace("GUIDES", "guide: {slider: {body: bar, along: right}}"),
        ON_A_TABLE.replace("AGAINST", "relative to table"),
        STRUCK_LATER,
    ],
)
def test_what_is_meant_has_no_warning(text: str) -> None:
    assert warned(text) == []


def test_a_rack_that_moves_across_its_teeth() -> None:
    """A slider or a slot across the teeth is refused when it is read; constraints of the user's own are not."""
    guides = "one: {constraint: u}, two: {constraint: b}"
    text = RACK.replace("GUIDES", guides) + "measures: {u: x of bar, b: angle of bar, v: y of bar}\n"
    ((kind, told),) = warned(text)
    assert kind == "teeth apart"
    assert "slot: {pin: bar, along: ...}" in told


def test_a_planet_that_does_not_fit_between_sun_and_ring() -> None:
    """z_R = z_S + 2 z_P: with 24, 17 and 60 teeth of 2 mm the carrier holds 41 mm, and the ring needs 43."""
    path = Path(__file__).parents[1] / "examples" / "planetary_gear_by_teeth.yaml"
    text = path.read_text("utf-8").replace("z_P: 18", "z_P: 17")
    ((kind, told),) = warned(text)
    assert kind == "gears apart"
    assert "ring and planet are 0.041 m apart" in told
    assert "touch at 0.043 m" in told


PLANETARY = """
parameters: {rS: 80 mm, rP: 40 mm, wS: 5 rad/s}
bodies:
  sun: {gear: {radius: rS}}
  planet: {gear: {radius: rP}}
  ring: {RING: {radius: rS + 2*rP}}
  carrier: {rod: {length: rS + rP}}
connections:
  s: {pin: [ground, sun]}
  c: {pin: [ground, carrier.start]}
  p: {pin: [carrier.end, planet]}
  inner: {gear_mesh: [sun, planet]}
  outer: {gear_mesh: [planet, ring]}
  fix: {weld: [ground, ring]}
  drive: {driver: {measure: angle of sun, speed: wS}}
"""


@pytest.mark.parametrize("ring", ["ring_gear", "internal_gear", "Hohlrad"])
def test_a_ring_gear_by_its_radius_has_its_teeth_inside(ring: str) -> None:
    """Willis: wC (rS + rR) = rS wS with the ring at rest, and the carrier may stand anywhere."""
    text = PLANETARY.replace("RING", ring)
    assert warned(text) == []
    found = fb.System.from_text(text).solve("angular velocity of carrier").answers[0]
    assert found.value == pytest.approx(80 * 5 / (80 + 160))


def test_a_ring_that_is_taken_for_a_wheel_is_told_with_its_cure() -> None:
    ((kind, told),) = warned(PLANETARY.replace("RING", "ring"))
    assert kind == "gears apart"
    assert "write gear_mesh: {first: ring, second: planet, internal: true}" in told


def test_a_wrong_angle_explains_what_stands_elsewhere_because_of_it() -> None:
    tilted = WALL.replace("along: right}", "along: 20 rad}").replace("PLACE", "0.45 m")
    assert [kind for kind, _told in warned(tilted)] == ["many turns"]


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_no_bundled_model_has_a_warning(path: Path) -> None:
    assert fb.System.load(path).warnings == ()


def test_every_kind_is_a_file_of_its_own_and_names_kinds_that_there_are() -> None:
    names = {kind.name for kind in WarningKind.kinds}
    assert len({kind.__module__ for kind in WarningKind.kinds}) == len(WarningKind.kinds)
    assert {name for kind in WarningKind.kinds for name in kind.explains} <= names
    assert templates()


def test_the_program_tells_warnings_on_stderr_and_in_json(tmp_path: Path) -> None:
    file = tmp_path / "slope.yaml"
    file.write_text(SLOPE.replace("ANGLE", "60 rad").strip() + "\nquestions: [acceleration of s]\n")
    told = CliRunner().invoke(commands(), ["solve", str(file), "--json"])
    assert f"warning: {file}:1:45: parameters.alpha: 60 rad is 9.5 turns" in told.stderr
    (warning,) = json.loads(told.stdout)["warnings"]
    assert (warning["kind"], warning["where"], warning["line"]) == ("many turns", "parameters.alpha", 1)
    german = CliRunner().invoke(commands(), ["explain", str(file), "--language", "de"])
    assert "Warnung:" in german.stderr
    assert "60 deg schreiben" in german.stderr


@pytest.mark.parametrize(("side", "sign"), [("240 deg", 1), ("300 deg", -1)])
def test_the_side_of_an_elbow_is_taken_as_it_is_said_and_decides_between_tension_and_compression(
    side: str, sign: int
) -> None:
    system = fb.System.from_text(TOGGLE.replace("NEAR", f", near: {{angle: {side}}}"))
    assert not system.warnings
    # 2 N sin(t) = F, cos(t) = 0.9 m/(2 a)
    (answer,) = system.solve("tension in upper").answers
    assert answer.value == pytest.approx(sign * 400 / (2 * (1 - 0.81) ** 0.5), rel=1e-9)


SLIDER_CRANK = """
parameters: {r: 0.1 m, l: 0.4 m, w: 3 rad/s}
bodies: {crank: {rod: {length: r}}, rod: {rod: {length: l} NEAR}, piston: {PISTON}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  guide: {slider: {body: piston, along: right, through: ground.O}}
START
measures: {phi: angle of crank, x: x of piston}
"""
DRIVEN = "  motor: {driver: {measure: phi, follows: 90 deg + w*t}}"


@pytest.mark.parametrize(
    "piston", ["particle: {mass: 1 kg}", "rectangle: {mass: 1 kg, width: 9 cm, height: 5 cm}"], ids=["point", "block"]
)
@pytest.mark.parametrize("start", [DRIVEN, "start: {phi: 90 deg, rate(phi): w}"], ids=["driven", "started"])
def test_a_piston_stands_on_either_side_of_its_crank_unless_that_is_said(piston: str, start: str) -> None:
    """At 90 deg the piston is sqrt(l^2 - r^2) from the shaft, and the rod falls by asin(r/l) on either side."""
    text = SLIDER_CRANK.replace("PISTON", piston).replace("START", start)
    ((kind, told),) = warned(text.replace(" NEAR", ""))
    assert kind == "elbow open"
    assert "taken to be at [0.3873, 0] m, not at [-0.3873, 0] m" in told
    assert "{angle: -14 deg} in rod, or with -166 deg" in told
    for angle, sign in ((-14, 1), (-166, -1)):
        system = fb.System.from_text(text.replace(" NEAR", f", near: {{angle: {angle} deg}}"))
        assert not system.warnings
        assert system.solve("x at start").answers[0].value == pytest.approx(sign * 0.15**0.5)


def test_the_way_on_a_body_counted_from_a_point_of_it_or_about_a_fixed_axle_is_left_alone() -> None:
    turning = """
parameters: {m: 1 kg, I: 2 kg m^2}
bodies: {rod: {body: {mass: m, inertia: I}, lines: {axis: {along: right}}}, bead: {particle: {mass: m}, at: [1 m, 0]}}
connections: {pivot: {pin: [ground.O, rod]}, groove: {slider: {body: bead, along: rod.axis}}}
measures: {r: travel of bead along rod.axis}
"""
    assert not warned(ON_DECK.replace("FROM", " from boat"))
    assert not warned(turning)


LEANING = """
space: {up: z}
parameters: {m: 12 kg, a: 1.5 m, b: 0.6 m, h: 4 m, mu: 0.6, g: 9.81 m/s^2}
ground: {planes: {floor: {normal: up}, wall: {normal: [-1, 0, 0]}}}
bodies:
  ladder:
    body: {mass: m, inertia: [1 kg m^2, 1 kg m^2, 1 kg m^2]}
    points: {foot: [-a/2, -b/2, -h/2], top: [a/2, b/2, h/2]}
connections:
  foot: {contact: {between: [ladder.foot, floor], friction: mu}}
  top: {contact: {between: [ladder.top, wall], friction: mu}}
loads: {weight: {gravity: g}}
"""


def test_a_body_that_is_only_touched_and_comes_to_lie_aslant_is_told() -> None:
    (warning,) = fb.System.from_text(LEANING).warnings
    assert warning.kind == "turned open"
    assert "could as well not be turned" in str(warning.problem.message)
    said = LEANING.replace("    points: {foot", "    turned: 0 deg about z\n    points: {foot")
    assert not fb.System.from_text(said).warnings


UNDER = """
parameters: {m: 4 kg, b: 10 deg, mu: 0.2, g: 9.81 m/s^2}
ground: {lines: {ramp: {along: DIRECTION}}}
bodies: {block: {particle: {mass: m}}}
connections: {face: {contact: {between: [block, ramp], friction: mu}}}
loads: {w: {gravity: g}}
"""


@pytest.mark.parametrize(("direction", "n"), [("180 deg - b", 1), ("-b", 0), ("up", 0)])
def test_what_hangs_under_its_line_is_told(direction: str, n: int) -> None:
    """A line is solid on the right: one that points to the left has its open side below."""
    found = [w for w in fb.System.from_text(UNDER.replace("DIRECTION", direction)).warnings if w.kind == "under a line"]
    assert len(found) == n
    assert all("turn ramp round" in w.text() for w in found)
    pressed = UNDER.replace("DIRECTION", direction).replace(
        "loads: {", "loads: {p: {force: {at: block, along: up, magnitude: 2*m*g}}, "
    )
    assert not [w for w in fb.System.from_text(pressed).warnings if w.kind == "under a line"]


STRUCK = """
parameters: {M: 3 kg, L: 1.2 m, m: 0.4 kg, v: 8 m/s, h: 0.9 m, e: 0.6, g: 9.81 m/s^2}
bodies:
  rod: {rod: {mass: M, length: L}, angle: -90 deg, at: {start: [0, 0]}}
  ball: {particle: {mass: m}, at: [0, -h], velocity: [v, 0]}
connections:
  O: {pin: [ground.O, rod.start]}
  hit: {contact: {between: [ball, rod], restitution: e, touching: true}}
loads: {w: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("model", "kinds"),
    [
        (STRUCK, ["struck while touching"]),
        (STRUCK.replace(", touching: true", ""), []),
        (STRUCK.replace(", velocity: [v, 0]", "").replace(" v: 8 m/s,", ""), []),
    ],
)
def test_what_comes_up_to_a_body_that_it_is_said_to_touch_is_told(model: str, kinds: list[str]) -> None:
    """A ball before a hanging rod; the rod is pinned, and does not tip about the ball."""
    assert [w.kind for w in fb.System.from_text(model).warnings] == kinds


def test_a_thin_beam_that_lies_on_a_corner_does_not_hang_under_its_other_side() -> None:
    beam = fb.System.from_text("""
parameters: {L: 4 m, h: 1.5 m, a: 2 m, g: 9.81 m/s^2}
ground: {points: {E: [a, h]}, lines: {floor: {along: right}}}
bodies: {beam: {rod: {mass: 30 kg, length: L}, angle: atan(h/a), at: {start: [0, 0]}}}
connections:
  floor: {contact: {between: [beam.start, ground.floor], friction: 0.3, touching: true}}
  edge: {contact: {between: [beam, ground.E], friction: 0, touching: true}}
loads: {w: {gravity: g}}
""")
    assert not [w for w in beam.warnings if w.kind == "under a line"]


LED = """
parameters: {m: 2 kg, M: 5 kg, a: 3 m/s^2, mu: 0.5, g: 9.81 m/s^2}
bodies:
  truck: {rectangle: {mass: M, width: 3 m, height: 1 m}, at: [0, 0], angle: 0}
  crate: {particle: {mass: m}, at: [0, 0.5 m]}
connections:
  drive: {driver: {measure: x, follows: a*t^2/2}}
  bed: {contact: {between: [crate, truck.top], friction: mu}}
loads: {weight: {gravity: g}}
measures: {x: x of truck}
"""


def test_a_truck_that_is_led_along_x_and_carried_by_nothing_falls() -> None:
    told = [w for w in fb.System.from_text(LED).warnings if w.kind == "led and falling"]
    assert [w.about for w in told] == [frozenset({"truck"})]
    on_a_road = LED.replace("  bed:", "  road: {slider: {body: truck, along: right}}\n  bed:")
    assert not [w for w in fb.System.from_text(on_a_road).warnings if w.kind == "led and falling"]
    upright = LED.replace("x of truck", "y of truck")
    assert not [w for w in fb.System.from_text(upright).warnings if w.kind == "led and falling"]


PITCHING = """
parameters: {m: 200 kg, L: 2 m, k1: 20 kN/m, k2: 30 kN/m}
ground: {points: {O: [0, 0], A: [-L/2, -0.5 m], B: [L/2, -0.5 m]}}
bodies: {beam: {rod: {mass: m, length: L}, at: [0, 0], angle: 0}}
connections: {guide: {slider: {body: GUIDED, along: up, through: ground.O}}}
loads:
  s1: {spring: {from: ground.A, to: beam.start, stiffness: k1, length: 0.5 m}}
  s2: {spring: {from: ground.B, to: beam.end, stiffness: k2, length: 0.5 m}}
"""


def test_what_stands_on_two_springs_may_be_meant_to_pitch_where_a_point_of_it_is_guided() -> None:
    ((kind, told),) = warned(PITCHING.replace("GUIDED", "beam.center"))
    assert kind == "locked rotation"
    assert "although springs pull at several points of it" in told
    assert "slot: {pin: beam.center" in told
    assert not warned(PITCHING.replace("GUIDED", "beam"))


TRAIN = """
bodies:
  sun: {gear: {teeth: 24, module: 2 mm}}
  planet: {gear: {teeth: 18, module: 2 mm, mass: 0.1 kg}}
  ring: {gear: {teeth: 60, module: 2 mm, internal: true}, fixed: true}
  carrier: {body: {mass: 1 kg}, near: {angle: 0}POINTS}
connections:
  bearing: {pin: [ground.O, sun]}
  axis: {pin: [ground.O, carrier]}AXLE
  m1: {gear_mesh: [sun, planet]}
  m2: {gear_mesh: [planet, ring]}
  drive: {driver: {measure: angle of sun, speed: 10 rad/s}}
"""


def test_a_planet_without_an_axle_is_told_with_the_place_of_one() -> None:
    """The axle is r_S + r_P = 24 mm + 18 mm from the middle. With it the carrier turns with w_S z_S/(z_S + z_R)
    (Willis), without it with nothing."""
    ((kind, told),) = warned(TRAIN.replace("POINTS", "").replace("AXLE", ""))
    assert kind == "axle missing"
    axle, point = "axle: {pin: [carrier.P, planet]}", "points: {P: [0.042 m, 0]}"
    assert axle in told
    assert point in told
    mended = TRAIN.replace("POINTS", f", {point}").replace("AXLE", f"\n  {axle}")
    assert warned(mended) == []
    (answer,) = fb.System.from_text(mended).solve("angular velocity of carrier").answers
    assert answer.value == pytest.approx(10 * 24 / (24 + 60))


@pytest.mark.parametrize(("way", "place"), [("right", "[0.3 m, 0]"), ("up", "[0, 0.3 m]")])
def test_a_spring_between_points_that_coincide_is_told_where_its_guide_leaves_room(way: str, place: str) -> None:
    text = (
        f"bodies: {{b: {{particle: {{mass: 2 kg}}, at: PLACE}}}}\nground: {{points: {{A: [0, 0]}}}}\n"
        f"connections: {{guide: {{slider: {{body: b, along: {way}}}}}}}\n"
        "loads: {s: {spring: {between: [ground.A, b], stiffness: 400 N/m, length: 0.3 m}}}\n"
    )
    ((kind, told),) = warned(text.replace("PLACE", "[0, 0]"))
    assert kind == "ends meet"
    assert f"at: {place}" in told
    assert warned(text.replace("PLACE", place)) == []


def test_a_level_spring_does_not_carry_what_is_led_along_it() -> None:
    text = (
        "bodies: {b: {particle: {mass: 2 kg}}}\nground: {points: {A: [PLACE]}}\n"
        "connections: {drive: {driver: {measure: x of b, speed: 2 m/s}}}\n"
        "loads: {w: {gravity: 9.81 m/s^2}, s: {spring: {between: [ground.A, b], stiffness: 400 N/m}}}\n"
    )
    assert [kind for kind, _told in warned(text.replace("PLACE", "-1 m, 0"))] == ["led and falling"]
    assert warned(text.replace("PLACE", "0, 1 m")) == []


def test_a_contact_in_which_nothing_presses_is_told() -> None:
    text = (
        "bodies: {b: {particle: {mass: 2 kg}}}\nground: {lines: {slope: {angle: 30 deg}}}\n"
        "connections: {c: {contact: {between: [b, slope], friction: 0.2}}}\n"
    )
    ((kind, told),) = warned(text)
    assert kind == "nothing acts"
    weight = "loads: {weight: {gravity: 9.81 m/s^2}}"
    assert weight in told
    assert warned(f"{text}{weight}\n") == []
    assert warned(text.replace("2 kg}", "2 kg}, velocity: [1 m/s, 0]")) == []


def test_a_pull_at_a_rim_that_goes_round_is_told() -> None:
    text = (
        "parameters: {m: 8 kg, R: 0.3 m, r: 0.12 m, F: 20 N, g: 9.81 m/s^2}\nground: {lines: {floor: {along: right}}}\n"
        "bodies: {spool: {disk: {mass: m, radius: R}, at: [0, R], points: {rim: [0, -r]}}}\n"
        "connections: {rolls: {rolling: {body: spool, on: floor}}}\n"
        "loads: {w: {gravity: g}, pull: {force: {at: spool.POINT, along: WAY, magnitude: F}}}\n"
    )
    ((kind, told),) = warned(text.replace("POINT", "rim").replace("WAY", "right"))
    assert kind == "pulled at the rim"
    assert "wound on spool radius r at bottom" in told
    assert warned(text.replace("POINT", "center").replace("WAY", "right")) == []
    assert warned(text.replace("POINT", "rim").replace("WAY", "spool.x")) == []


def test_two_sliders_that_keep_both_bodies_from_turning_are_told() -> None:
    """Each holds the angle that the other one holds as well, through the hinge and the floor."""
    text = """
parameters: {m: 4 kg, L: 1 m, alpha: 60 deg, g: 9.81 m/s^2}
bodies: {left: {rod: {mass: m, length: L}, angle: alpha}, right: {rod: {mass: m, length: L}, angle: 180 deg - alpha}}
connections:
  hinge: {pin: [left.end, right.end]}
  f1: {slider: {body: left.start, along: right}}
  f2: {slider: {body: right.start, along: right}}
loads: {w: {gravity: g}}
measures: {theta: angle of left}
"""
    told = [warning.text() for warning in fb.System.from_text(text).warnings]
    assert any("f1 keeps left from turning, so that theta has no effect" in message for message in told)


def test_a_disk_that_hangs_by_its_middle_alone_is_told() -> None:
    text = (
        "bodies: {yoyo: {disk: {mass: 1 kg, radius: 4 cm}}}\nconnections: {cord: {string: {from: ceiling, to: yoyo}}}\n"
    )
    text += "loads: {w: {gravity: 9.81 m/s^2}}\n"
    (told,) = fb.System.from_text(text).warnings
    assert told.kind == "tied at the axle"
    assert "wound on yoyo" in str(told.problem.message)
    for meant in (text.replace("to: yoyo", "to: wound on yoyo"), text.replace("to: yoyo", "to: yoyo.center")):
        assert fb.System.from_text(meant).warnings == ()


def test_what_is_joined_twice_is_told() -> None:
    text = "bodies: {bar: {rod: {mass: 1 kg, length: 1 m}}}\nloads: {w: {gravity: 9.81 m/s^2}}\n"
    text += "connections: {A: {pin: [ground.A, bar.start]}, B: {pin: [bar.start, ground.A]}}\n"
    (told,) = fb.System.from_text(text).warnings
    assert told.kind == "joined twice"
    assert told.problem.path == ("connections", "B")


TRUCK = """
parameters: {m: 50 kg, b: 0.6 m, h: 1 m, mu: 0.45, v0: 5 m/s, a0: 2 m/s^2, g: 9.81 m/s^2}
bodies:
  truck: {rectangle: {mass: m, width: 3 m, height: 1 m}, at: [0, 0], lines: {bed: {through: [0, 0.5], along: right}}}
  crate: {rectangle: {mass: m, width: b, height: h}, near: {at: [0, 1]}SPEED}
connections:
  track: {slider: {body: truck, along: right}}
  motor: {driver: {measure: x of truck, follows: LAW}}
  bed: {contact: {between: [crate, truck.bed], friction: mu, touching: true}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("law", "speed", "is_told"),
    [
        ("v0*t - a0*t^2/2", "", True),  # the bed goes on under it
        ("v0*t - a0*t^2/2", ", velocity: [v0, 0]", False),
        ("v0*t - a0*t^2/2", ", velocity: [0, 0]", False),  # said to stand
        ("a0*t^2/2", "", False),  # both start from rest
    ],
)
def test_a_crate_whose_speed_is_left_open_on_a_truck_that_already_moves_is_told(
    law: str, speed: str, is_told: bool
) -> None:
    """The least motion leaves the crate where it is; that it goes along is its velocity v0."""
    warnings = fb.System.from_text(TRUCK.replace("LAW", law).replace("SPEED", speed)).warnings
    found = [w for w in warnings if w.kind == "left behind"]
    assert len(found) == is_told
    assert all("Give it velocity: [5 m/s, 0 m/s]" in w.text() for w in found)
