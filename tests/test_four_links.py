"""Loops of four links asked for what turns fully, dead points, transmission angles and assembly.

Formulas by hand from the triangles of the linkage. Problem families: Norton, Design of Machinery, 5th ed. 2012, sec.
2.13 (Grashof), 3.2 (toggle positions), 3.4 (quick return), 4.10 (transmission angle), 4.11 (slider-crank with offset);
Uicker, Pennock & Shigley, Theory of Machines and Mechanisms, 4th ed. 2011, sec. 1.9, 1.10 and problems of ch. 1 to 3;
Mabie & Reinholtz, Mechanisms and Dynamics of Machinery, 4th ed. 1987, sec. 2.3; own words and numbers.
"""

from __future__ import annotations

import math
import re

import pytest

from posed import is_derived, is_formula, posed
from thinned import thinned

_BARS = """
parameters: {{a: {a} m, b: {b} m, c: {c} m, d: {d} m}}
ground: {{points: {{O: [0, 0], D: [d, 0]}}}}
bodies:
  crank: {{rod: {{mass: 1 kg, length: a}}}}
  coupler: {{rod: {{mass: 1 kg, length: b}}}}
  rocker: {{rod: {{mass: 1 kg, length: c}}, near: {{angle: {near} deg}}}}
connections:
  O: {{pin: [ground.O, crank.start]}}
  A: {{pin: [crank.end, coupler.start]}}
  B: {{pin: [coupler.end, rocker.end]}}
  C: {{pin: [ground.D, rocker.start]}}
measures: {{psi: angle of crank, phi: angle of rocker}}
start: {{psi: 60 deg}}
"""


def bars(a: float, b: float, c: float, d: float, near: float = 80.0) -> str:
    return _BARS.format(a=a, b=b, c=c, d=d, near=near)


CRANK_ROCKER = bars(0.1, 0.32, 0.25, 0.3)
DRAG_LINK = bars(0.3, 0.28, 0.32, 0.1)
TRIPLE_ROCKER = bars(0.3, 0.35, 0.4, 0.6)
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
SLOTTED = """
parameters: {{a: {a} m, d: {d} m}}
ground: {{points: {{O: [0, 0], A: [0, -d]}}}}
bodies:
  crank: {{rod: {{mass: 1 kg, length: a}}}}
  lever: {{rod: {{mass: 1 kg, length: 0.5 m}}, near: {{angle: 70 deg}}}}
connections:
  main: {{pin: [ground.O, crank.start]}}
  pivot: {{pin: [ground.A, lever.start]}}
  block: {{slot: {{pin: crank.end, along: right, on: lever}}}}
measures: {{psi: angle of crank, phi: angle of lever}}
start: {{psi: 30 deg}}
"""
SHAPER = SLOTTED.format(a=0.1, d=0.25)
WHITWORTH = SLOTTED.format(a=0.15, d=0.06)
SWINGING_BLOCK = """
parameters: {r: 0.1 m, d: 0.3 m}
ground: {points: {O: [0, 0], P: [d, 0]}}
bodies: {crank: {rod: {mass: 1 kg, length: r}}, rod: {rod: {mass: 1 kg, length: 0.5 m}, near: {angle: -10 deg}}}
connections:
  main: {pin: [ground.O, crank.start]}
  pin: {pin: [crank.end, rod.start]}
  block: {slot: {pin: ground.P, along: right, on: rod}}
measures: {psi: angle of crank, beta: angle of rod}
start: {psi: 30 deg}
"""
TRAMMEL = """
parameters: {L: 0.5 m}
ground: {lines: {floor: {along: right}, wall: {along: up}}}
bodies: {bar: {rod: {mass: 1 kg, length: L}}}
connections: {foot: {slot: [bar.start, ground.floor]}, top: {slot: [bar.end, ground.wall]}}
measures: {phi: angle of bar, x: x of bar.start}
start: {phi: 130 deg}
"""
SCOTCH_YOKE = """
parameters: {r: 0.1 m}
bodies:
  crank: {rod: {mass: 1 kg, length: r}}
  yoke: {rectangle: {mass: 1 kg, width: 0.5 m, height: 0.1 m}, at: [0, 0]}
connections:
  main: {pin: [ground.origin, crank.start]}
  guide: {slider: {body: yoke, along: right}}
  slot: {slot: {pin: crank.end, along: up, on: yoke}}
measures: {psi: angle of crank, x: x of yoke}
start: {psi: 30 deg}
"""
TURNS = {
    "crank of a crank-rocker": (
        CRANK_ROCKER,
        "does crank turn fully",
        True,
        "a + d ≤ b + c and |a - d| ≥ |b - c|",
    ),
    "its rocker": (CRANK_ROCKER, "does rocker make full turns", False, "c + d ≤ a + b and |c - d| ≥ |a - b|"),
    "its coupler": (CRANK_ROCKER, "does coupler turn fully", False, "b + d ≤ a + c and |b - d| ≥ |a - c|"),
    "a drag link": (DRAG_LINK, "does rocker turn fully", True, "c + d ≤ a + b and |c - d| ≥ |a - b|"),
    "a triple rocker": (TRIPLE_ROCKER, "can crank turn fully", False, "a + d ≤ b + c and |a - d| ≥ |b - c|"),
    "offset slider-crank": (OFFSET, "does crank turn fully", True, "l ≥ r + e"),
    "its rod": (OFFSET, "does rod turn fully", False, "r ≥ l + e"),
    "lever of a Whitworth drive": (WHITWORTH, "does lever turn fully", True, "a ≥ d"),
    "lever of a shaper": (SHAPER, "does lever turn fully", False, "a ≥ d"),
    "crank of a shaper": (SHAPER, "does crank turn fully", True, "for all lengths"),
    "elliptic trammel": (TRAMMEL, "does bar turn fully", True, "for all lengths"),
    "Scotch yoke": (SCOTCH_YOKE, "does crank turn fully", True, "for all lengths"),
    "crank of a swinging block": (SWINGING_BLOCK, "does crank turn fully", True, "for all lengths"),
    "its rod against the ground": (SWINGING_BLOCK, "does rod turn fully", False, "r ≥ d"),
}


@pytest.mark.parametrize("name", TURNS)
def test_a_link_turns_fully(name: str) -> None:
    text, question, so, condition = TURNS[name]
    found = posed(text, question)
    assert found.expression is not None, found.reason
    assert found.evidence is not None
    assert found.conditions[0].endswith(condition)
    values = found.value if isinstance(found.value, tuple) else (found.value,)
    assert all(x >= 0 for x in values if x is not None) is so
    word = "turns fully" if so else "does not turn fully"
    assert found.verdict.startswith("with the given numbers")
    assert found.verdict.endswith(word)


@pytest.mark.parametrize("seed", thinned(range(6), lambda seed: seed < 4))
def test_grashof_and_the_margins_say_the_same(seed: int) -> None:
    """s + l <= p + q with the frame or the crank the shortest link; lengths as they come."""
    a, b, c, d = [(0.2, 0.31, 0.25, 0.3), (0.3, 0.31, 0.25, 0.12), (0.3, 0.2, 0.33, 0.31), (0.3, 0.31, 0.2, 0.33)][
        seed % 4
    ]
    c += 0.01 * seed
    found = posed(bars(a, b, c, d), "does crank turn fully")
    s, p, q, longest = sorted((a, b, c, d))
    so = s + longest <= p + q and s in (a, d)
    assert isinstance(found.value, tuple)
    assert all(x >= 0 for x in found.value) is so


def _acos(x: float) -> float:
    return math.acos(x)


A, B, C, D = 0.1, 0.32, 0.25, 0.3
R, L, E = 0.05, 0.2, 0.03
DEAD = {
    "crank of a crank-rocker": (
        CRANK_ROCKER,
        "dead points of crank",
        (
            _acos(((A + B) ** 2 + D**2 - C**2) / (2 * (A + B) * D)),
            math.pi + _acos(((B - A) ** 2 + D**2 - C**2) / (2 * (B - A) * D)),
        ),
    ),
    "its rocker": (
        CRANK_ROCKER,
        "toggle positions of phi",
        tuple(_acos((rho**2 - C**2 - D**2) / (2 * C * D)) for rho in (A + B, B - A)),
    ),
    "offset slider-crank": (
        OFFSET,
        "dead points of psi",
        (math.asin(E / (L + R)), math.pi + math.asin(E / (L - R))),
    ),
    "its piston": (
        OFFSET,
        "dead points of x",
        (math.sqrt((L + R) ** 2 - E**2), math.sqrt((L - R) ** 2 - E**2)),
    ),
    # the lever is a tangent of the crank circle
    "shaper": (SHAPER, "dead points of phi", (math.pi / 2 + math.asin(0.4), math.pi / 2 - math.asin(0.4))),
    "crank of a shaper": (SHAPER, "dead points of crank", (math.pi + math.asin(0.4), -math.asin(0.4))),
    "swinging block": (SWINGING_BLOCK, "dead points of beta", (math.asin(1 / 3), -math.asin(1 / 3))),
    "trammel": (TRAMMEL, "dead points of x", (-0.5, 0.5)),
}


@pytest.mark.parametrize("name", DEAD)
def test_dead_points(name: str) -> None:
    text, question, wanted = DEAD[name]
    found = posed(text, question)
    assert isinstance(found.value, tuple), found.reason
    assert found.value == pytest.approx(wanted, rel=1e-12)
    assert found.evidence is not None


def test_a_triple_rocker_is_stretched_only() -> None:
    found = posed(TRIPLE_ROCKER, "dead points of phi")
    assert found.value == pytest.approx(_acos((0.65**2 - 0.4**2 - 0.6**2) / (2 * 0.4 * 0.6)))


def test_where_all_links_lie_in_one_line_nothing_reverses_for_certain() -> None:
    """a + d = b + c with the output the shortest: the crank reverses where output and coupler are folded, b - c from
    D to B; stretched, everything is in one line, and two branches cross, along each of which the crank goes on."""
    lettered = bars(0.4, 0.45, 0.3, 0.35)
    text = lettered.replace("parameters: {a: 0.4 m, b: 0.45 m, c: 0.3 m, d: 0.35 m}\n", "").replace(
        "[d, 0]", "[0.35, 0]"
    )
    for name, size in {"a": 0.4, "b": 0.45, "c": 0.3}.items():
        text = text.replace(f"length: {name}}}", f"length: {size} m}}")
    text = text.replace("parameters: {d: 0.35 m}\n", "").replace("[d, 0]", "[0.35, 0]")
    found = posed(text, "dead points of crank")
    assert found.value == pytest.approx(_acos((0.4**2 + 0.35**2 - 0.15**2) / (2 * 0.4 * 0.35)))
    assert any("two branches" in note for note in found.notes)
    # with letters both are told, and that they are there beside these numbers only
    told = posed(lettered, "dead points of crank")
    assert "a + d > b + c (rocker turns fully)" in told.conditions
    assert told.value is None


def test_what_turns_all_round_does_not_reverse() -> None:
    for text in (WHITWORTH, DRAG_LINK):
        assert "neither reverses" in posed(text, "dead points of phi").reason


def _folded(D2: float) -> float:
    mu = _acos((B * B + C * C - D2) / (2 * B * C))
    return min(mu, math.pi - mu)


TRANSMISSION = {
    "pose": (CRANK_ROCKER, "transmission angle at start", _acos((B * B + C * C - A * A - D * D + A * D) / (2 * B * C))),
    "given": (
        CRANK_ROCKER,
        "transmission angle when psi = 90 deg",
        _acos((B * B + C * C - A * A - D * D) / (2 * B * C)),
    ),
    "least": (CRANK_ROCKER, "least transmission angle", min(_folded((D - A) ** 2), _folded((D + A) ** 2))),
    "greatest": (CRANK_ROCKER, "greatest transmission angle over a turn", _folded((D + A) ** 2)),
    "right angle passed": (bars(0.1, 0.3, 0.25, 0.3), "greatest transmission angle", math.pi / 2),
    "slider": (OFFSET, "minimum transmission angle", _acos((R + E) / L)),
    "slot": (SHAPER, "transmission angle", math.pi / 2),
}


@pytest.mark.parametrize("name", TRANSMISSION)
def test_transmission_angle(name: str) -> None:
    text, question, wanted = TRANSMISSION[name]
    found = posed(text, question)
    assert found.value == pytest.approx(wanted, rel=1e-12), found.reason
    assert found.evidence is not None


def test_assembly() -> None:
    """No side of a closed polygon is longer than the others together; crank and rod reach the guide."""
    found = posed(CRANK_ROCKER, "when does the loop assemble")
    assert found.value == pytest.approx((A + B + C - D, B + C + D - A, A + C + D - B, A + B + D - C))
    assert "d ≤ a + b + c" in found.conditions[0]
    assert posed(OFFSET, "condition of assembly").value == pytest.approx(R + L - E)


TOLD = {
    "turn": (CRANK_ROCKER, "does crank turn fully"),
    "turn of a rod": (OFFSET, "does crank turn fully"),
    "turn of a lever": (WHITWORTH, "does lever turn fully"),
    "turn of its crank": (SHAPER, "does crank turn fully"),
    "trammel": (TRAMMEL, "does bar turn fully"),
    "dead points": (CRANK_ROCKER, "dead points of psi"),
    "stroke": (OFFSET, "dead points of x"),
    "lever": (SHAPER, "dead points of phi"),
    "of a trammel": (TRAMMEL, "dead points of x"),
    "transmission": (CRANK_ROCKER, "transmission angle when psi = 20 deg"),
    "least": (CRANK_ROCKER, "least transmission angle"),
    "at a guide": (OFFSET, "least transmission angle"),
    "in a slot": (SHAPER, "transmission angle"),
    "assembly": (OFFSET, "when does the loop assemble"),
}


@pytest.mark.parametrize("name", TOLD)
def test_it_is_told(name: str) -> None:
    is_derived(*TOLD[name])


RANGES = {
    # s + l <= p + q with the crank as the shortest: a + 0.32 <= 0.25 + 0.3; with the frame as the shortest none
    "crank": (CRANK_ROCKER, "largest a so that crank turns fully", C + D - B),
    "rod": (OFFSET, "least l so that the crank turns fully", R + E),
    "offset": (OFFSET, "largest e such that crank makes full turns", L - R),
    "lever": (WHITWORTH, "least a for which lever turns fully", 0.06),
}


@pytest.mark.parametrize("name", RANGES)
def test_values_for_which_a_link_turns_fully(name: str) -> None:
    text, question, wanted = RANGES[name]
    found = posed(text, question)
    assert found.value == pytest.approx(wanted, rel=1e-12), found.reason
    assert found.evidence is not None


LENGTHS = {
    # the ends of |b - c| <= 0.2 and c >= a + d - b, of which the second is the lesser one
    "rocker of a crank-rocker": (CRANK_ROCKER, "c", (0.12, 0.52)),
    "frame of a drag link": (DRAG_LINK, "d", (0.26,)),
    # two links of one length: the ends coincide there
    "crank beside equal links": (bars(0.2, 0.5, 0.4, 0.5), "a", (0.4,)),
    "rocker beside equal links": (bars(0.2, 0.5, 0.4, 0.5), "c", (0.2, 0.8)),
    "frame of a change point": (bars(0.04, 0.12, 0.08, 0.1), "d", (0.08, 0.16)),
}


@pytest.mark.parametrize("name", LENGTHS)
def test_lengths_for_which_the_crank_turns_fully(name: str) -> None:
    """By Grashof's rule with the numbers of the others: a + d <= b + c and |a - d| >= |b - c|."""
    text, length, wanted = LENGTHS[name]
    found = posed(text, f"range of {length} for which the crank turns fully")
    values = found.value if isinstance(found.value, tuple) else (found.value,)
    assert found.evidence is not None, found.reason
    assert values == pytest.approx(wanted, rel=1e-9)
    assert not any(note.startswith("Not valid") for note in found.notes)


ASSEMBLY = {
    "link of a four-bar": (CRANK_ROCKER, "b", 0.65, ("a + c ≥ d", "c + d ≥ a", "a + d ≥ c")),
    "offset of a guide": (OFFSET, "e", 0.25, ()),
}


@pytest.mark.parametrize("name", ASSEMBLY)
def test_lengths_for_which_the_loop_can_be_assembled(name: str) -> None:
    text, length, end, conditions = ASSEMBLY[name]
    found = posed(text, f"range of {length} for which the loop assembles")
    assert found.value == pytest.approx(end), found.reason
    for wanted in conditions:
        assert any(wanted in text for text in found.conditions)


OLDHAM = """
parameters: {e: 0.05 m}
ground: {points: {O: [0, 0], P: [e, 0]}}
bodies:
  left: {disk: {mass: 1 kg, radius: 0.2 m}}
  right: {disk: {mass: 1 kg, radius: 0.2 m}}
  cross: {disk: {mass: 1 kg, radius: 0.2 m}}
connections:
  a: {pin: [ground.O, left]}
  b: {pin: [ground.P, right]}
  one: {slider: {body: cross, along: right, on: left}}
  two: {slider: {body: cross, along: up, on: right}}
measures: {psi: angle of left}
start: {psi: 30 deg}
"""


@pytest.mark.parametrize("text", [OLDHAM, TRAMMEL, SCOTCH_YOKE])
def test_a_loop_with_two_sliders_closes_with_all_lengths(text: str) -> None:
    found = posed(text, "when does the loop assemble")
    assert found.conditions == ("the loop can be assembled with all lengths",)
    assert found.evidence is not None


def test_both_shafts_and_the_cross_of_an_oldham_coupling_turn_alike() -> None:
    for link in ("left", "right", "cross"):
        found = posed(OLDHAM, f"does {link} turn fully")
        assert found.conditions == (f"{link} turns fully for all lengths",)
    assert "for all lengths" in posed(OLDHAM, "range of e for which the left turns fully").reason
    assert "does not turn" in posed(SCOTCH_YOKE, "does yoke turn fully").reason


KITE = _BARS.replace("parameters: {{a: {a} m, b: {b} m, c: {c} m, d: {d} m}}", "parameters: {{a: 0.3 m, b: 0.1 m}}")
KITE = (
    KITE.replace("[d, 0]", "[a, 0]")
    .replace("length: c", "length: b")
    .replace("{near}", "150")
    .replace("60 deg", "20 deg")
)
KITE = KITE.replace("{{", "{").replace("}}", "}")
PARALLELOGRAM = bars(0.1, 0.3, 0.1, 0.3).replace("a: 0.1 m, b: 0.3 m, c: 0.1 m, d: 0.3 m", "a: 0.1 m, b: 0.3 m")
PARALLELOGRAM = PARALLELOGRAM.replace("[d, 0]", "[b, 0]").replace("length: c", "length: a")


def test_change_points_of_a_parallelogram_and_a_kite() -> None:
    """Folded flat the coupler pulls along the output: the transmission angle vanishes."""
    assert posed(PARALLELOGRAM, "least transmission angle").value == pytest.approx(0.0, abs=1e-7)
    found = posed(PARALLELOGRAM, "does crank turn fully")
    assert found.evidence is not None
    assert "abs(0)" not in posed(PARALLELOGRAM, "does coupler turn fully").conditions[0]
    assert posed(PARALLELOGRAM, "range of a for which the crank turns fully").reason.startswith("that is so for every")
    assert posed(PARALLELOGRAM, "does crank turn fully").conditions == ("crank turns fully for all lengths",)


def test_the_transmission_angle_of_a_kite_is_at_the_link_that_its_crank_drives() -> None:
    """The short link at the ground turns fully and drives the long one: the angle between that and the coupler."""
    found = posed(KITE, "transmission angle at start")
    a, b, psi = 0.3, 0.1, math.radians(20)
    diagonal = 2 * a * math.sin(psi / 2)  # between the pin A and the pivot of the short link
    at_a = math.acos(diagonal / (2 * b)), math.acos(diagonal / (2 * a))
    assert found.value is not None, found.reason
    assert found.value in (pytest.approx(at_a[0] + at_a[1]), pytest.approx(abs(at_a[1] - at_a[0])))


def letters(text: str, *names: str) -> str:
    """A model in which lengths have no numbers."""
    for name in names:
        text = re.sub(rf"\b{name}: [0-9.]+ m\b", f"{name}: m", text)
    return text


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("stroke of phi", "acos(((b - a)^2 - c^2 - d^2)/(2*c*d)) - acos(((a + b)^2 - c^2 - d^2)/(2*c*d))"),
        ("least transmission angle", "acos((b^2 + c^2 - (d - a)^2)/(2*b*c))"),
    ],
)
def test_a_four_bar_of_letters_is_taken_as_a_crank_rocker_with_that_as_its_condition(
    question: str, formula: str
) -> None:
    """Random lengths seldom make one: of those tried the first that does is the case that is told."""
    numbers = {"a": 0.1, "b": 0.32, "c": 0.25, "d": 0.3}
    found = is_formula(letters(CRANK_ROCKER, *numbers), question, formula, numbers=numbers)
    assert any("turn" in str(condition) for condition in found.conditions)


def test_both_dead_points_of_a_four_bar_of_letters_are_told() -> None:
    found = posed(letters(CRANK_ROCKER, *"abcd"), "dead points of phi")
    assert isinstance(found.expression, tuple)
    assert len(found.expression) == 2


SIX_BAR = """
parameters: {r: 0.04 m, d: 0.1 m, h: 0.18 m}
ground: {points: {O: [0, d], P: [0, 0]}, lines: {way: {along: right, through: [0, h]}}}
bodies:
  crank: {rod: {length: r}}
  lever: {body: {}, near: {angle: 80 deg}}
  ram: {body: {}, near: {at: [0, h]}}
connections:
  O: {pin: [ground.O, crank.start]}
  P: {pin: [ground.P, lever]}
  block: {slot: {pin: crank.end, along: lever.x}}
  fork: {slot: {pin: ram, along: lever.x}}
  way: {slider: {body: ram, along: way}}
  motor: {driver: {measure: phi, follows: t*3 rad/s}}
measures: {phi: angle of crank, s: x of ram}
"""


def test_a_driven_crank_of_several_loops_is_told_to_turn_fully() -> None:
    assert posed(SIX_BAR, "does the crank turn fully").verdict == "with the given numbers crank turns fully"
    assert posed(letters(SIX_BAR, *"rdh"), "does the crank turn fully").conditions == ("crank turns fully if d > r",)


def test_stroke_and_time_ratio_of_a_shaper_of_letters() -> None:
    numbers = {"r": 0.04, "d": 0.1, "h": 0.18}
    shaper = letters(SIX_BAR, *numbers)
    is_formula(shaper, "stroke of s", "2*r*h/sqrt(d^2 - r^2)", numbers=numbers)
    is_formula(shaper, "time ratio of s", "(pi - acos(r/d))/acos(r/d)", numbers=numbers)


GENEVA = """
parameters: {r: 0.05 m, w: 10 rad/s, J: 0.02 kg m^2}
ground: {points: {O: [0, 0], P: [r*sqrt(2), 0]}}
bodies:
  driver: {rod: {length: r}, near: {angle: 0 deg}}
  wheel: {body: {inertia: J}, near: {at: [r*sqrt(2), 0], angle: 180 deg}}
connections:
  O: {pin: [ground.O, driver.start]}
  P: {pin: [ground.P, wheel]}
  slot: {slot: {pin: driver.end, along: wheel.x}}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of driver, psi: angle of wheel}
"""


def test_stroke_and_time_ratio_by_the_dead_points_where_the_slope_has_no_closed_zeros() -> None:
    assert posed(GENEVA, "time ratio of psi").value == pytest.approx(3.0)
    assert posed(GENEVA, "stroke of psi").value == pytest.approx(math.pi / 2)


def test_roots_of_two_and_three_in_one_pose_cancel_exactly() -> None:
    """By hand w^2 L s (L^2 - 1)/(1 + L^2 - 2 L c)^2 with L = r/d of the wheel, turned the other way."""
    L, angle = 1 / math.sqrt(2), math.radians(30)
    by_hand = 100 * L * math.sin(angle) * (1 - L**2) / (1 + L**2 - 2 * L * math.cos(angle)) ** 2
    assert posed(GENEVA, "angular acceleration of wheel when phi = 30 deg").value == pytest.approx(by_hand)


def test_a_rate_that_a_loop_binds_is_told_beside_the_formula_with_it() -> None:
    found = posed(GENEVA, "angular acceleration of wheel")
    assert any("ψ' =" in str(note) for note in found.notes)


TIPPER = """
parameters: {a: 1 m, b: 0.8 m, s_0: 0.9 m}
ground: {points: {O: [0, 0], C: [a, 0]}}
bodies:
  bed: {body: {mass: 1 kg}, points: {O: [0, 0], K: [b, 0]}}
  barrel: {body: {}}
  piston: {body: {}}
connections:
  O: {pin: [ground.O, bed.O]}
  C: {pin: [ground.C, barrel.origin]}
  K: {pin: [bed.K, piston.origin]}
  ram: {slider: {body: piston, along: barrel.x}}
  pump: {driver: {measure: s, follows: s_0 + t*0.1 m/s}}
measures: {s: distance from ground.C to bed.K}
"""


def test_a_loop_that_a_ram_drives_has_no_transmission_angle_of_a_crank() -> None:
    assert "here pump does" in posed(TIPPER, "transmission angle").reason


RAM_BEHIND_A_ROCKER = """
parameters: {a: 40 mm, b: 130 mm, c: 90 mm, d: 120 mm, L: 150 mm, q: 200 mm, h: 130 mm, w: 8 rad/s, m: 2 kg, F: 300 N}
ground: {points: {A: [0, 0], D: [d, 0]}, lines: {way: {along: right, through: [0, h]}}}
bodies:
  crank: {rod: {length: a}}
  coupler: {rod: {length: b}, near: {angle: 40 deg}}
  rocker: {rod: {length: L}, near: {angle: 80 deg}, points: {C: [c - L/2, 0]}}
  link: {rod: {length: q}, near: {angle: 0 deg}}
  ram: {particle: {mass: m}, near: {at: [0.35 m, h]}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.C]}
  D: {pin: [ground.D, rocker.start]}
  E: {pin: [rocker.end, link.start]}
  G: {pin: [link.end, ram]}
  way: {slider: {body: ram, along: way}}
  motor: {driver: {measure: phi, follows: w*t}}
loads: {work: {force: {at: ram, along: left, magnitude: F}}}
measures: {phi: angle of crank, s: x of ram}
"""


def ram(phi: float) -> float:
    """By the triangle of crank pin, coupler and rocker, then Pythagoras at the link."""
    a, b, c, d, L, q, h = 0.04, 0.13, 0.09, 0.12, 0.15, 0.2, 0.13
    x, y = a * math.cos(phi), a * math.sin(phi)
    far = math.hypot(d - x, y)
    at_pin = math.atan2(-y, d - x) + math.acos((b**2 + far**2 - c**2) / (2 * b * far))
    psi = math.atan2(y + b * math.sin(at_pin), x + b * math.cos(at_pin) - d)
    return d + L * math.cos(psi) + math.sqrt(q**2 - (h - L * math.sin(psi)) ** 2)


def test_the_stroke_of_a_ram_behind_a_rocker_is_that_between_the_dead_points_of_the_rocker() -> None:
    places = [ram(math.tau * k / 3600) for k in range(3600)]
    found = posed(RAM_BEHIND_A_ROCKER, "stroke of s")
    assert found.evidence is not None
    assert found.value == pytest.approx(max(places) - min(places), rel=1e-5)
    assert "between the dead points of rocker it has no extreme" in found.conditions


@pytest.mark.parametrize("question", ["acceleration of s", "driving torque of motor"])
def test_a_six_bar_is_answered_in_names_where_its_drive_has_led_it(question: str) -> None:
    """Power of the drive: T w = F v + m v a."""
    e, w, at = 1e-4, 8.0, math.pi / 3
    slope = (ram(at + e) - ram(at - e)) / (2 * e)
    acceleration = w**2 * (ram(at + e) - 2 * ram(at) + ram(at - e)) / e**2
    torque = 300 * slope + 2 * acceleration * slope
    found = posed(RAM_BEHIND_A_ROCKER, f"{question} when phi = 60 deg")
    assert found.evidence is not None
    assert found.value == pytest.approx(torque if "torque" in question else acceleration, rel=1e-5)


SHAPER_WITH_A_BLOCK = """
parameters: {r: 0.1 m, d: 0.25 m, L: 0.6 m, c: 0.3 m, h: 0.4 m, w: 6 rad/s}
ground: {points: {O: [0, 0], B: [0, -d], H: [0, h]}}
bodies:
  crank: {rod: {length: r}}
  block: particle
  lever: {rod: {length: L}}
  link: {rod: {length: c}, near: {angle: 18 deg}}
  ram: {particle: {mass: 10 kg}}
connections:
  o: {pin: [ground.O, crank.start]}
  b: {pin: [ground.B, lever.start]}
  p: {pin: [crank.end, block]}
  s: {slider: {body: block, along: lever.x, on: lever}}
  l: {pin: [lever.end, link.start]}
  k: {pin: [link.end, ram]}
  way: {slider: {body: ram, along: right, through: ground.H}}
  motor: {driver: {body: crank, speed: w}}
measures: {phi: angle of crank, x: x of ram}
start: {phi: 0 rad}
"""


def test_a_shaper_whose_block_is_a_body_has_the_stroke_of_its_lever() -> None:
    """The crank stands across the lever at both ends: sin(psi) = r/d, and the ram goes as far as the lever's end."""
    found = posed(SHAPER_WITH_A_BLOCK, "stroke of x")
    assert found.expression is not None
    assert found.value == pytest.approx(2 * 0.1 * 0.6 / 0.25)


def test_an_oscillating_cylinder_in_which_a_rod_slides_is_a_loop_of_four_links() -> None:
    """The cylinder turns back where the crank stands across it, at asin(r/d) to either side of half a turn."""
    model = """
parameters: {r: m, d: m, w: 1/s}
ground: {points: {O: [0, 0], P: [d, 0]}}
bodies:
  crank: {rod: {length: r}}
  rod: {body: {}, near: {angle: 180 deg}}
  cylinder: {body: {}, near: {at: [d, 0], angle: 180 deg}}
connections:
  O: {pin: [ground.O, crank.start]}
  P: {pin: [ground.P, cylinder]}
  A: {pin: [crank.end, rod]}
  bore: {slider: {body: rod, along: cylinder.x}}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of crank, psi: angle of cylinder}
"""
    assert posed(model, "does the crank turn fully").conditions == ("crank turns fully for all lengths",)
    is_formula(model, "stroke of psi", "2*asin(r/d)", numbers={"r": 0.4, "d": 1.1, "w": 1.0})


def test_a_ram_that_passes_its_stretched_toggle_has_no_stroke_by_the_dead_points_of_the_rocker() -> None:
    """The toggle is straight between the dead points of its upper bar: the ram has its lowest place there."""
    model = """
parameters: {r: 30 mm, c: 200 mm, l1: 150 mm, l2: 180 mm, w: 10 rad/s}
ground: {points: {O: [210 mm, -120 mm], P: [0, 0]}, lines: {way: {along: up}}}
bodies:
  crank: {rod: {length: r}}
  rod: {rod: {length: c}, near: {angle: 180 deg}}
  upper: {rod: {length: l1}, near: {angle: -80 deg}}
  lower: {rod: {length: l2}, near: {angle: -100 deg}}
  ram: {particle: {}, near: {at: [0, -0.32 m]}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  K: {pin: [rod.end, upper.end]}
  P: {pin: [ground.P, upper.start]}
  B: {pin: [upper.end, lower.start]}
  C: {pin: [lower.end, ram]}
  way: {slider: {body: ram, along: way}}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of crank, psi: angle of upper, s: y of ram}
start: {phi: 0}
"""
    found = posed(model, "stroke of s")
    assert "defect" not in found.reason
    assert found.value == pytest.approx(0.010817, rel=1e-4)
