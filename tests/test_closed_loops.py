"""Closed loops solved for the angles that they bind: slider-crank, four-bar, slotted lever, driven or free.

Formulas by hand from the triangle of the linkage and its derivatives. Problem families: Meriam & Kraige, Engineering
Mechanics: Dynamics, sec. 5/4 to 5/6; Hibbeler, Dynamics, ch. 16; Norton, Design of Machinery, ch. 4, 6 and 13;
Wittenburg, Kinematics, ch. 17 (Freudenstein's equation).
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.api import System
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.language.notation import to_python, to_text
from freebody.language.parser import parse
from posed import is_derived, is_formula, posed
from thinned import thinned

SLIDER_CRANK = """
parameters: {{r: 0.05 m, l: 0.2 m, m: 0.8 kg, F: 200 N, w: 30 1/s, alpha: 40 deg}}
ground: {{lines: {{rail: {{along: right}}}}}}
bodies:
  crank: {{rod: {{mass: 0, length: r}}}}
  rod: {{rod: {{mass: 0, length: l}}}}
  piston: {{particle: {{mass: m}}}}
connections:
  O: {{pin: [ground.O, crank.start]}}
  A: {{pin: [crank.end, rod.start]}}
  B: {{pin: [rod.end, piston]}}
  guide: {{slider: [piston, ground.rail]}}
  {more}
loads: {{gas: {{force: {{at: piston, along: left, magnitude: F}}}}}}
measures: {{psi: angle of crank, phi: angle of rod clockwise, x: x of piston}}
start: {{psi: {psi}{rate}}}
"""
FREE = SLIDER_CRANK.format(more="", psi="alpha", rate=", rate(psi): w")
DRIVEN = SLIDER_CRANK.format(more="motor: {driver: {measure: psi, follows: w*t}}", psi="0", rate="")
FOUR_BAR = """
parameters: {a: 0.1 m, b: 0.3 m, c: 0.25 m, d: 0.3 m, w: 5 1/s, alpha: 60 deg}
ground: {points: {O: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: a}}
  coupler: {rod: {mass: 1 kg, length: b}}
  rocker: {rod: {mass: 1 kg, length: c}, near: {angle: 60 deg}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, coupler.start]}
  B: {pin: [coupler.end, rocker.end]}
  C: {pin: [ground.D, rocker.start]}
measures: {psi: angle of crank, phi: angle of rocker, beta: angle of coupler}
start: {psi: alpha, rate(psi): w}
"""
LADDER = """
parameters: {m: 5 kg, L: 4 m, v: 1 m/s, alpha: 50 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up}}}
bodies: {ladder: {rod: {mass: m, length: L}, near: {angle: 130 deg}}}
connections:
  foot: {slot: [ladder.start, ground.floor]}
  top: {slot: [ladder.end, ground.wall]}
  pull: {driver: {measure: x, follows: L*cos(alpha) + v*t}}
measures: {x: x of ladder.start, y: y of ladder.end}
"""
OFFSET = """
parameters: {r: 0.05 m, l: 0.2 m, e: 0.03 m}
ground: {points: {O: [0, 0], P: [0, e]}, lines: {rail: {along: right, through: ground.P}}}
bodies: {crank: {rod: {mass: 1 kg, length: r}}, rod: {rod: {mass: 1 kg, length: l}}, piston: {particle: {mass: 1 kg}}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  guide: {slider: [piston, ground.rail]}
measures: {psi: angle of crank, x: x of piston}
start: {psi: 30 deg}
"""
SHAPER = """
parameters: {r: 0.1 m, d: 0.25 m}
ground: {points: {O: [0, 0], A: [0, -d]}}
bodies: {crank: {rod: {mass: 1 kg, length: r}}, lever: {rod: {mass: 1 kg, length: 0.5 m}, near: {angle: 70 deg}}}
connections:
  main: {pin: [ground.O, crank.start]}
  pivot: {pin: [ground.A, lever.start]}
  block: {slot: {pin: crank.end, along: right, on: lever}}
measures: {psi: angle of crank, phi: angle of lever}
start: {psi: 30 deg}
"""
S, C = "sqrt(l^2 - r^2*sin(alpha)^2)", "r*cos(alpha)"

FORMULAS = {
    # x = r cos psi + sqrt(l^2 - r^2 sin^2 psi)
    "piston": (FREE, "x at start", f"{C} + {S}"),
    "rod": (FREE, "phi at start", "asin(r*sin(alpha)/l)"),
    "piston, velocity": (FREE, "velocity of x at start", f"-r*w*sin(alpha)*(1 + {C}/{S})"),
    "rod, turning": (FREE, "angular velocity of rod at start", f"-w*{C}/{S}"),
    "piston, driven": (DRIVEN, "x when psi = 90 deg", "sqrt(l^2 - r^2)"),
    "velocity, driven": (DRIVEN, "velocity of x when psi = 90 deg", "-r*w"),
    "velocity at 60 deg": (
        DRIVEN,
        "velocity of x when psi = 60 deg",
        "-r*w*sqrt(3)/2*(1 + r/2/sqrt(l^2 - 3*r^2/4))",
    ),
    "outer dead point": (DRIVEN, "acceleration of x at start", "-r*w^2*(1 + r/l)"),
    "inner dead point": (DRIVEN, "acceleration of x when psi = 180 deg", "r*w^2*(1 - r/l)"),
    "acceleration at 90 deg": (DRIVEN, "acceleration of x when psi = 90 deg", "r^2*w^2/sqrt(l^2 - r^2)"),
    # gas force and inertia through the rod; on the crank r/cos(phi) sin(psi + phi)
    "side force": (
        DRIVEN,
        "vertical reaction of guide when psi = 90 deg",
        "r/sqrt(l^2 - r^2)*(F + m*r^2*w^2/sqrt(l^2 - r^2))",
    ),
    "torque": (DRIVEN, "driving torque of motor when psi = 90 deg", "-r*(F + m*r^2*w^2/sqrt(l^2 - r^2))"),
    "time": (DRIVEN, "time when psi = 60 deg", "pi/(3*w)"),
    "by the clock": (DRIVEN, "velocity of x at t = pi/(2*w)", "-r*w"),
    # energy: m v^2/2 changes by the work of F
    "free motion": (
        FREE,
        "velocity of x when psi = 90 deg",
        f"-sqrt((r*w*sin(alpha)*(1 + {C}/{S}))^2 + 2*F/m*({C} + {S} - sqrt(l^2 - r^2)))",
    ),
    # dead points where crank and rod are in line: sqrt((l +- r)^2 - e^2), and the angles of these lines
    "stroke": (FREE, "stroke of x over a turn of psi", "2*r"),
    "stroke, offset": (
        OFFSET,
        "stroke of x over a turn of psi",
        "sqrt((l + r)^2 - e^2) - sqrt((l - r)^2 - e^2)",
    ),
    "time ratio, offset": (
        OFFSET,
        "time ratio of x over a turn of psi",
        "(pi + asin(e/(l - r)) - asin(e/(l + r)))/(pi - asin(e/(l - r)) + asin(e/(l + r)))",
    ),
    # the lever is a tangent of the crank circle
    "swing of a shaper": (SHAPER, "stroke of phi over a turn of psi", "2*asin(r/d)"),
    "time ratio of a shaper": (
        SHAPER,
        "time ratio of phi over a turn of psi",
        "(pi + 2*asin(r/d))/(pi - 2*asin(r/d))",
    ),
    # x^2 + y^2 = L^2
    "ladder": (LADDER, "velocity of y at start", "-v*cos(alpha)/sin(alpha)"),
    "ladder, later": (LADDER, "y when x = 3 m", "sqrt(L^2 - 9)"),
}


@pytest.mark.parametrize("name", FORMULAS)
def test_a_loop_is_solved(name: str) -> None:
    is_formula(*FORMULAS[name], factors=(1.0, 1.02, 0.99))


def test_the_rocker_of_a_four_bar() -> None:
    """By the triangles O D A and D A B: the angle at D, seen from the diagonal e."""
    a, b, c, d, alpha = 0.1, 0.3, 0.25, 0.3, math.radians(60)
    e = math.hypot(a * math.cos(alpha) - d, a * math.sin(alpha))
    at_d = math.acos((c * c + e * e - b * b) / (2 * c * e))
    phi = math.atan2(a * math.sin(alpha), a * math.cos(alpha) - d) - at_d
    for words in ("phi at start", "phi"):
        found = posed(FOUR_BAR, words)
        assert found.value == pytest.approx(phi, rel=1e-12)
        assert "beta" not in str(found.expression)
        assert any("as it is assembled" in note for note in found.notes)


def test_a_formula_that_stays_long_has_its_angles_beside_it() -> None:
    found = posed(FOUR_BAR, "angular velocity of rocker")
    assert found.chain is not None
    told = {to_text(step.name): to_text(step.formula) for step in found.chain.named}
    assert "atan" in told["β"]
    assert "atan" in told["φ"]
    assert sum(note.startswith("with 0 = ") for note in found.notes) == 2
    assert found.evidence is not None


def test_a_loop_has_the_branch_on_which_it_is_assembled() -> None:
    """The same slider-crank with the piston on the other side."""
    text = FREE.replace("piston: {particle: {mass: m}}", "piston: {particle: {mass: m}, near: {at: [-0.1 m, 0]}}")
    text = text.replace("rod: {rod: {mass: 0, length: l}}", "rod: {rod: {mass: 0, length: l}, near: {angle: 170 deg}}")
    found = posed(text, "x at start")
    assert found.value == pytest.approx(
        0.05 * math.cos(math.radians(40)) - math.sqrt(0.2**2 - (0.05 * math.sin(math.radians(40))) ** 2)
    )
    assert any("cos(φ) < 0" in note for note in found.notes)


TOLD = {
    "place": (FREE, "x at start"),
    "any pose": (FREE, "angular velocity of rod"),
    "driven": (DRIVEN, "driving torque of motor when psi = 60 deg"),
    "clock": (DRIVEN, "velocity of x at t = 0.02 s"),
    "rocker": (FOUR_BAR, "phi at start"),
    "stroke": (FOUR_BAR, "stroke of phi over a turn of psi"),
    "time ratio": (FOUR_BAR, "time ratio of phi over a turn of psi"),
}


@pytest.mark.parametrize("name", thinned(TOLD, lambda name: name != "time ratio"))
def test_the_solution_of_the_loop_is_told(name: str) -> None:
    is_derived(*TOLD[name])


def test_a_crank_rocker_turns_between_its_dead_points() -> None:
    """Crank and coupler in one line: the triangle of (b -+ a), c and d by the law of cosines. The crank goes all round
    where it is the shortest bar, and it with any other is shorter than the two that are left (Grashof)."""
    found = posed(FOUR_BAR, "extremes of phi over a turn of psi")
    assert isinstance(found.expression, tuple)
    values = {"a": 0.11, "b": 0.32, "c": 0.27, "d": 0.3}
    formulas = [f"acos((({way})^2 - c^2 - d^2)/(2*c*d))" for way in ("b + a", "b - a")]
    for end, formula in zip(found.expression, formulas, strict=True):
        wanted = evaluate(parse(formula), values, FLOAT_FUNCTIONS)
        assert evaluate(end, values, FLOAT_FUNCTIONS) == pytest.approx(wanted, rel=1e-12)
    told = {condition.partition(" (")[0] for condition in found.conditions}
    assert told == {"b + d > a + c", "b + c > a + d", "c + d > a + b"}


def test_a_speed_in_a_loop_has_no_sign() -> None:
    # sqrt(n/d^2) is sqrt(n)/|d|, and d = cos(..) - 1 is not positive
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "four_bar.yaml")
    for question in ("speed of coupler", "speed of rocker"):
        answer = system.solve(question).answers[0]
        assert answer.expression is not None, answer.reason
        assert answer.evidence is not None


SLIDER_CRANK = """
parameters: {r: 0.05 m, l: 0.18 m, w: 100 rad/s}
bodies:
  crank: {rod: {length: r}}
  rod: {rod: {length: l}}
  piston: {particle: {mass: 1 kg}, near: {at: [0.2 m, 0]}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  bore: {slider: {body: piston, along: right}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: angle of crank, x: x of piston}
"""


@pytest.mark.parametrize(
    ("question", "expected", "needed"),
    [  # beyond theta = 90 deg the loop must close there, where r sin(theta) is largest
        ("acceleration of x when theta = 180 deg", "r*w**2*(l - r)/l", "l > r"),
        ("velocity of x when theta = 120 deg", "-r*w*sqrt(3)/2 + r**2*w*sqrt(3)/(2*sqrt(4*l**2 - 3*r**2))", "l > r"),
        ("velocity of x when theta = 30 deg", "-r*w/2 - r**2*w*sqrt(3)/(2*sqrt(4*l**2 - r**2))", "2·l > r"),
    ],
)
def test_loops_must_close_all_the_way_to_an_event(question: str, expected: str, needed: str) -> None:
    answer = fb.System.from_text(SLIDER_CRANK).solve(question).answers[0]
    assert answer.expression is not None, answer.reason
    assert_same_function(to_python(answer.expression), expected, {"r": 0.05, "l": 0.18, "w": 100.0})
    assert any(c.startswith(needed) for c in answer.conditions), answer.conditions


QUICK_RETURN = """
parameters: {r: 0.1 m, d: 0.25 m, w: 6 rad/s}
ground: {points: {O: [0, d], A: [0, 0]}}
bodies: {crank: {rod: {length: r}}, lever: {rod: {length: 0.6 m}}, block: {particle: {}}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [ground.A, lever.start]}
  P: {pin: [crank.end, block]}
  slot: {slot: {pin: block, along: lever.x, on: lever}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: angle of crank, beta: {angle of lever from up clockwise}}
start: {theta: 0}
"""


@pytest.mark.parametrize(
    ("question", "expected"),
    [  # in line with the frame, where the tangent of half the lever's angle has no value
        ("angular velocity of lever when theta = 90 deg", "r*w/(d + r)"),
        ("angular velocity of lever when theta = 270 deg", "-r*w/(d - r)"),
        ("angular acceleration of lever when theta = 90 deg", "0"),
        ("beta when theta = 90 deg", "0"),
    ],
)
def test_a_lever_in_line_with_its_frame_has_a_formula(question: str, expected: str) -> None:
    answer = fb.System.from_text(QUICK_RETURN).solve(question).answers[0]
    assert answer.expression is not None, answer.reason
    assert_same_function(to_python(answer.expression), expected, {"r": 0.1, "d": 0.25, "w": 6.0})


def test_a_root_of_a_number_below_a_bar_brings_in_no_new_pole() -> None:
    """tan(phi) = (d + r sqrt(3)/2)/(r/2) when the crank of a quick return is at 60 degrees: it has a value for 2 d =
    sqrt(3) r as well, where a bar with 4 d^2 - 3 r^2 below would have none."""
    system = System.from_text(SHAPER.replace("psi: 30 deg", "psi: 60 deg"))
    answer = system.solve("phi at start").answers[0]
    assert answer.expression is not None, answer.reason
    assert [str(c) for c in answer.conditions] == ["for all positive parameters"]
    for r, d in ((2.0, math.sqrt(3.0)), (0.1, 0.25), (0.3, 0.1)):
        value = evaluate(answer.expression, {"r": r, "d": d}, FLOAT_FUNCTIONS)
        assert value == pytest.approx(math.atan2(d + r * math.sqrt(3.0) / 2, r / 2), rel=1e-12)


MASSLESS = """
parameters: {{r: 0.05 m, l: 0.2 m, m: 2 kg, F: 10 N}}
ground: {{lines: {{rail: {{along: right}}}}}}
bodies:
  crank: {{rod: {{mass: 0, length: r}}}}
  rod: {{rod: {{mass: 0, length: l}}}}
  piston: {{particle: {{mass: m}}}}
connections:
  O: {{pin: [ground.origin, crank.start]}}
  A: {{pin: [crank.end, rod.start]}}
  B: {{pin: [rod.end, piston]}}
  guide: {{slider: {{body: piston, along: rail}}}}
loads: {{push: {{force: {{at: piston, along: left, magnitude: F}}}}}}
measures: {{psi: angle of crank, x: x of piston}}
start: {{psi: {psi} deg}}
"""


def test_no_mass_moves_with_a_massless_crank_in_its_dead_point() -> None:
    """m x'' = -F elsewhere; there the links carry F: sin(rod - psi) was cancelled."""
    found = posed(MASSLESS.format(psi=40), "acceleration of x")
    assert found.value == pytest.approx(-5.0)
    assert any("sin(θ_rod - ψ) ≠ 0" in text for text in found.conditions)
    dead = posed(MASSLESS.format(psi=0), "acceleration of x")
    assert dead.value is None
    assert any(note.startswith("Not valid for the given numbers") for note in dead.notes)
    heavy = MASSLESS.format(psi=40).replace("crank: {rod: {mass: 0", "crank: {rod: {mass: 1 kg")
    assert not any("some mass moves" in text for text in posed(heavy, "acceleration of x").conditions)


GENEVA = """
parameters: {r: m, d: m, w: 1/s, J: kg m^2}
ground: {points: {O: [0, 0], P: [d, 0]}}
bodies:
  driver: {rod: {length: r}, near: {angle: 0 deg}}
  wheel: {body: {inertia: J}, near: {at: [d, 0], angle: 180 deg}}
connections:
  O: {pin: [ground.O, driver.start]}
  P: {pin: [ground.P, wheel]}
  slot: {slot: {pin: driver.end, along: wheel.x}}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of driver, psi: angle of wheel}
"""
SHAPER_WITH_RAM = """
parameters: {r: 120 mm, d: 250 mm, L: 520 mm, l: 160 mm, h: 500 mm, w: 4 rad/s, F: 900 N}
ground: {points: {O: [0, 0], P: [0, -d]}, lines: {way: {along: right, through: [0, h - d]}}}
bodies:
  crank: {rod: {length: r}}
  lever: {rod: {length: L}, near: {angle: 90 deg}}
  link: {rod: {length: l}, near: {angle: 180 deg}}
  ram: {particle: {}, near: {at: [-0.2 m, h - d]}}
connections:
  O: {pin: [ground.O, crank.start]}
  P: {pin: [ground.P, lever.start]}
  block: {slot: {pin: crank.end, along: lever}}
  B: {pin: [lever.end, link.start]}
  C: {pin: [link.end, ram]}
  way: {slider: {body: ram, along: way}}
  motor: {driver: {measure: phi, follows: w*t}}
loads: {cut: {force: {at: ram, along: left, magnitude: F}}}
measures: {phi: angle of crank, psi: angle of lever, s: x of ram}
"""


def test_a_loop_whose_branch_hangs_on_unknown_lengths_has_that_of_its_start() -> None:
    """tan psi = r sin phi/(r cos phi - d), so that psi' = r w (r - d cos phi)/(r^2 + d^2 - 2 r d cos phi)."""
    found = posed(GENEVA, "angular velocity of wheel")
    assert found.expression is not None, found.reason
    wanted = parse("r*w*(r - d*cos(w*t))/(r^2 + d^2 - 2*r*d*cos(w*t))")
    for values in ({"r": 0.3, "d": 0.5, "w": 2.0, "t": 0.3}, {"r": 0.7, "d": 0.4, "w": 3.0, "t": 0.2}):
        a, b = (evaluate(e, values, FLOAT_FUNCTIONS) for e in (found.expression, wanted))
        assert math.isclose(a, b, rel_tol=1e-9)


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("angular velocity of lever when phi = 30 deg", "r*w*(r + d/2)/(r^2 + r*d + d^2)"),
        ("normal force of block when phi = 90 deg", "L*F/(r + d)"),
        ("time ratio of psi", "(pi - acos(r/d))/acos(r/d)"),
    ],
)
def test_an_angle_of_a_loop_may_point_to_the_left_on_either_side(question: str, formula: str) -> None:
    """The link of a shaper points to its ram on the left, a little up or down."""
    is_formula(SHAPER_WITH_RAM, question, formula, factors=(1.0,))


WHITWORTH_WITH_RAM = """
parameters: {r: 90 mm, d: 50 mm, L: 110 mm, q: 300 mm, w: 6 rad/s}
ground: {points: {O: [0, 0], P: [0, -d]}, lines: {way: {along: right, through: [0, -d]}}}
bodies:
  crank: {rod: {length: r}}
  lever: {body: {}, at: [0, -d], points: {Q: [L, 0]}}
  link: {rod: {length: q}, near: {angle: 0 deg}}
  ram: {particle: {mass: 6 kg}, near: {at: [0.4 m, -d]}}
connections:
  O: {pin: [ground.O, crank.start]}
  P: {pin: [ground.P, lever]}
  block: {slot: {pin: crank.end, along: lever.x}}
  Q: {pin: [lever.Q, link.start]}
  C: {pin: [link.end, ram]}
  way: {slider: {body: ram, along: way}}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of crank, psi: angle of lever, s: x of ram}
"""
DRAG_LINK_WITH_RAM = """
parameters: {a: 70 mm, b: 60 mm, c: 75 mm, d: 30 mm, l: 250 mm, w: 8 rad/s}
ground: {points: {A: [0, 0], D: [d, 0]}, lines: {way: {along: right}}}
bodies:
  crank: {rod: {length: a}}
  link: {rod: {length: b}, near: {angle: -40 deg}}
  wheel: {rod: {length: c}, near: {angle: 20 deg}}
  rod: {rod: {length: l}, near: {angle: 0 deg}}
  ram: {particle: {mass: 5 kg}, near: {at: [0.35 m, 0]}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, link.start]}
  C: {pin: [link.end, wheel.end]}
  D: {pin: [ground.D, wheel.start]}
  E: {pin: [wheel.end, rod.start]}
  G: {pin: [rod.end, ram]}
  way: {slider: {body: ram, along: way}}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of crank, psi: angle of wheel, s: x of ram}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (WHITWORTH_WITH_RAM, "stroke of s", "2*L"),
        # the lever lies along the guide where the crank is level with P: sin(phi) = -d/r
        (WHITWORTH_WITH_RAM, "time ratio of s", "(pi - acos(d/r))/acos(d/r)"),
        (DRAG_LINK_WITH_RAM, "stroke of s", "2*c"),
    ],
)
def test_what_a_link_drives_that_turns_fully_has_its_extremes_by_that_links_angle(
    model: str, question: str, formula: str
) -> None:
    is_formula(model, question, formula, factors=(1.0,))


def test_the_time_ratio_of_a_drag_link_is_that_of_the_crank_where_the_wheel_lies_along_the_guide() -> None:
    """By the triangle of crank, link and the way from the pivot to the end of the wheel, d + c or c - d."""
    a, b, c, d = 0.07, 0.06, 0.075, 0.03
    right = math.acos((a * a + (d + c) ** 2 - b * b) / (2 * a * (d + c)))
    left = math.acos((a * a + (c - d) ** 2 - b * b) / (2 * a * (c - d)))
    way = right + math.pi - left  # the one above the guide, and the one below it
    found = posed(DRAG_LINK_WITH_RAM, "time ratio of s")
    assert found.expression is not None, found.reason
    assert found.value == pytest.approx(max(way, math.tau - way) / min(way, math.tau - way), rel=1e-9)


@pytest.mark.parametrize("link", ["lever", "crank"])
def test_a_full_turn_before_a_ram_takes_what_each_loop_needs(link: str) -> None:
    found = posed(WHITWORTH_WITH_RAM, f"does the {link} turn fully")
    assert isinstance(found.expression, tuple)
    assert {to_text(x) for x in found.expression} == {"r - d", "q - L"}
    assert found.verdict == f"with the given numbers {link} turns fully"


CRATE_DRAWN_UP = """
parameters: {m: 60 kg, h: 6 m, v: 2 m/s, g: 9.81 m/s^2, d: 4 m}
ground: {points: {P: [0, h]}}
bodies: {crate: {particle: {mass: m}, at: [0, 0]}, car: {particle: {mass: 1 kg}, at: [0, 0]}}
connections:
  shaft: {slider: {body: crate, along: up}}
  road: {slider: {body: car, along: right}}
  rope: {string: {path: [crate, ground.P, car]}}
  drive: {driver: {measure: x, follows: v*t}}
loads: {weight: {gravity: g}}
measures: {x: x of car, y: y of crate}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        # h + y is the length of the rope behind the pulley, sqrt(h^2 + x^2)
        ("velocity of y when x = d", "v*d/sqrt(d**2 + h**2)"),
        ("tension of rope when x = d", "m*(g + v**2*h**2/(d**2 + h**2)**(3/2))"),
        ("time when y = d", "sqrt(d**2 + 2*h*d)/v"),
    ],
)
def test_a_length_and_its_direction_are_solved_for_where_a_rope_leads_to_what_drives_off(
    question: str, formula: str
) -> None:
    is_formula(CRATE_DRAWN_UP, question, formula)


def test_a_rope_that_stands_still_is_no_equation_of_a_loop() -> None:
    """By moments of the beam about A: 2 T a = C_y a, and the strut bears C_y sqrt(a^2 + b^2)/b of it."""
    system = fb.System.from_text("""
parameters: {m: 40 kg, a: 1 m, b: 0.8 m, r: 0.1 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], D: [0, -b], E: [-1 m, 0.1 m]}}
bodies:
  beam: {rod: {length: 2*a}, at: {start: [0, 0]}, angle: 0}
  strut: {rod: {length: sqrt(a^2 + b^2)}, at: {start: ground.D}}
  pulley: {disk: {radius: r}}
  load: {particle: {mass: m}}
connections:
  A: {pin: [ground.A, beam.start]}
  D: {pin: [ground.D, strut.start]}
  C: {pin: [strut.end, beam.center]}
  B: {pin: [beam.end, pulley]}
  rope: {string: {from: ground.E, over: pulley, to: load}}
loads: {weight: {gravity: g}}
""")
    (found,) = system.solve("reaction of A").answers
    assert found.value == pytest.approx((-40 * 9.81 * 1.5, -40 * 9.81), rel=1e-9)
    assert sum(note.startswith("with 0 = ") for note in found.notes) == 2
    assert not any("0 = 1" in note for note in found.notes)
