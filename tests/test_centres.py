"""Instant centres and velocity ratios: closed forms, Kennedy's theorem, and the points where bodies are joined."""

from __future__ import annotations

import math
from itertools import combinations

import numpy as np
import pytest

import freebody as fb
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, ZERO, Point
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.study.mobility.centres import CentreOfPair, instant_centres, velocity_ratios

FOUR_BAR = """
parameters: {a: 1 m, b: 3 m, c: 2.5 m, d: 3 m}
ground: {points: {A: [0, 0], D: [d, 0]}}
bodies: {crank: {rod: {length: a}}, coupler: {rod: {length: b}}, rocker: {rod: {length: c}, near: {angle: 80 deg}}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.end]}
  D: {pin: [ground.D, rocker.start]}
measures: {theta: angle of crank, psi: angle of rocker}
start: {theta: 60 deg}
"""
SLIDER_CRANK = """
parameters: {r: 1 m, l: 3 m}
ground: {points: {O: [0, 0]}}
bodies: {crank: {rod: {length: r}}, rod: {rod: {length: l}}, block: rectangle}
connections:
  O: {pin: [ground.O, crank.start]}
  B: {pin: [crank.end, rod.start]}
  W: {pin: [rod.end, block]}
  S: {slider: {body: block, along: right, through: ground.O}}
measures: {theta: angle of crank, s: x of block}
start: {theta: 50 deg}
"""
WATT = """
ground: {points: {A: [0, 0], D: [4 m, 0], G: [7 m, 0]}}
bodies:
  b1: {rod: {length: 1.5 m}, angle: 70 deg}
  b2: {rod: {length: 4 m}}
  b3: {rod: {length: 3 m}, near: {angle: 80 deg}}
  b4: {rod: {length: 3.5 m}, near: {angle: -20 deg}}
  b5: {rod: {length: 2.5 m}, near: {angle: 80 deg}}
connections:
  A: {pin: [ground.A, b1.start]}
  B: {pin: [b1.end, b2.start]}
  C: {pin: [b2.end, b3.end]}
  D: {pin: [b3.start, ground.D]}
  E: {pin: [b3.center, b4.start]}
  F: {pin: [b4.end, b5.end]}
  G: {pin: [b5.start, ground.G]}
"""
MECHANISMS = {"four-bar": FOUR_BAR, "slider-crank": SLIDER_CRANK, "six-bar": WATT}


def posed(text: str) -> tuple[fb.System, Snapshot]:
    system = fb.System.from_text(text)
    reference = Reference(system)
    q = reference.assemble()
    return system, reference.snapshot(q, np.zeros_like(q))


def place(snapshot: Snapshot, point: Point) -> tuple[float, float]:
    origin = Point(GROUND, (ZERO, ZERO))
    return snapshot.value(Displacement(point, origin, RIGHT)), snapshot.value(Displacement(point, origin, UP))


def homogeneous(centre: CentreOfPair) -> tuple[float, float, float]:
    """A centre as a point of the projective plane, where points at infinity are points as well."""
    if centre.at is not None:
        return (*centre.at, 1.0)
    assert centre.direction is not None
    return (*centre.direction, 0.0)


@pytest.mark.parametrize("name", MECHANISMS)
def test_kennedy_the_three_centres_of_three_bodies_lie_in_line(name: str) -> None:
    system, snapshot = posed(MECHANISMS[name])
    table = instant_centres(system, snapshot)
    bodies = [GROUND, *(b.name for b in system.moving)]
    assert list(table) == list(combinations(bodies, 2))
    for i, j, k in combinations(bodies, 3):
        points = np.array([homogeneous(table[pair]) for pair in ((i, j), (i, k), (j, k))])
        scale = np.prod(np.linalg.norm(points, axis=1))
        assert abs(np.linalg.det(points)) < 1e-9 * scale, (i, j, k)


@pytest.mark.parametrize("name", MECHANISMS)
def test_a_pin_is_the_centre_of_the_bodies_it_joins(name: str) -> None:
    system, snapshot = posed(MECHANISMS[name])
    table = instant_centres(system, snapshot)
    for row in system.constraint_rows:
        measure = row.measure
        if isinstance(measure, Displacement) and row.component == "x":
            first, second = measure.origin, measure.of
            centre = table.get((first.body, second.body)) or table[second.body, first.body]
            assert centre.at == pytest.approx(place(snapshot, first), abs=1e-9)


def test_a_block_that_slides_has_its_centre_at_infinity_across_the_guide() -> None:
    system, snapshot = posed(SLIDER_CRANK)
    centre = instant_centres(system, snapshot)["ground", "block"]
    assert centre.at is None
    assert centre.direction == pytest.approx((0, 1))
    assert list(centre.to_plain()) == ["pair", "direction"]


def test_centre_of_a_coupler_is_where_crank_and_rocker_meet() -> None:
    solution = fb.solve(fb.System.from_text(FOUR_BAR), "instant centre of coupler")["q1"]
    assert solution.expression is not None, solution.reason
    assert solution.evidence is not None
    assert solution.unit == "m"
    # the line of the crank through A, y = x tan(theta), and the line of the rocker through D
    _system, snapshot = posed(FOUR_BAR)
    theta, psi = math.radians(60), snapshot.reference.pose(snapshot.q, "rocker")[2]
    x = 3 * math.tan(psi) / (math.tan(psi) - math.tan(theta))
    assert solution.value == pytest.approx((x, x * math.tan(theta)))


def test_centre_of_a_connecting_rod_in_closed_form() -> None:
    # on the crank's line, above the block: x = r cos(theta) + l cos(phi), y = x tan(theta)
    answer = fb.solve(fb.System.from_text(SLIDER_CRANK), "instantaneous center of rotation of rod at start")["q1"]
    assert answer.expression is not None, answer.reason
    t = math.radians(50)
    x = math.cos(t) + math.sqrt(9 - math.sin(t) ** 2)
    assert answer.value == pytest.approx((x, x * math.tan(t)))


@pytest.mark.parametrize(
    "words",
    [
        "instant centre of",
        "instant center of",
        "instantaneous centre of",
        "the instantaneous center of rotation of",
        "velocity pole of",
    ],
)
def test_ways_to_ask_for_a_centre(words: str) -> None:
    # a rolling disk turns about its contact
    text = (
        "parameters: {R: 2 m}\nground: {lines: {floor: {along: right}}}\nbodies: {w: {disk: {mass: 1 kg, radius: R}}}"
    )
    text += "\nconnections: {c: {rolling: {body: w, on: floor}}}\nmeasures: {s: x of w}\n"
    answer = fb.solve(fb.System.from_text(text), f"{words} w")["q1"]
    assert answer.to_plain()["expression"] == ["s", "0"], answer.reason


def test_relative_centre_of_meshing_gears_is_their_pitch_point() -> None:
    text = "parameters: {R1: 1 m, R2: 2 m}\nground: {points: {A: [0, 0], B: [R1 + R2, 0]}}\n"
    text += "bodies: {g1: {disk: {mass: 1 kg, radius: R1}}, g2: {disk: {mass: 1 kg, radius: R2}, at: [R1 + R2, 0]}}\n"
    text += "connections: {A: {pin: [ground.A, g1]}, B: {pin: [ground.B, g2]}, m: {gear_mesh: [g1, g2]}}\n"
    answer = fb.solve(fb.System.from_text(text), "instant centre of g1 relative to g2")["q1"]
    assert answer.to_plain()["expression"] == ["R1", "0"], answer.reason


@pytest.mark.parametrize(
    ("guide", "direction"), [("right", "up"), ("up", "right"), ("30 deg", "120 deg|the normal of its velocity")]
)
def test_a_body_in_translation_has_its_centre_at_infinity(guide: str, direction: str) -> None:
    text = (
        f"bodies: {{b: {{rectangle: {{mass: 1 kg}}}}}}\nconnections: {{s: {{slider: {{body: b, along: {guide}}}}}}}\n"
    )
    answer = fb.solve(fb.System.from_text(text), "instant centre of b")["q1"]
    assert answer.expression is None
    assert "in translation: the centre is at infinity along" in answer.reason
    assert any(answer.reason.endswith(d) for d in direction.split("|"))


def test_with_several_freedoms_the_centre_depends_on_the_speeds() -> None:
    text = "bodies: {b: {rod: {mass: 1 kg, length: 1 m}}}\nmeasures: {x: x of b, y: y of b, q: angle of b}\n"
    answer = fb.solve(fb.System.from_text(text), "instant centre of b")["q1"]
    plain = answer.to_plain()["expression"]
    assert plain[0] in ("x - rate(y)/rate(q)", "(x*rate(q) - rate(y))/rate(q)"), plain
    resting = fb.solve(fb.System.from_text(text), "instant centre of b at start")["q1"]
    assert "has no instant centre. Give rates under start" in resting.reason


@pytest.mark.parametrize(
    ("asked", "message"),
    [("p", "p is a particle"), ("a relative to a", "no motion relative to itself"), ("c", "there is no body c")],
)
def test_centres_that_mean_nothing_are_refused(asked: str, message: str) -> None:
    with pytest.raises(fb.ModelError, match=message):
        fb.System.from_text("bodies: {a: {rod: 1 kg}, p: particle}").question(f"instant centre of {asked}")


# -- velocity ratios --------------------------------------------------------------------------
def test_velocity_ratio_is_that_of_the_distances_to_the_relative_centre() -> None:
    # Norton, sec. 6.4: w4/w2 = |I12 I24| / |I14 I24|
    system, snapshot = posed(FOUR_BAR)
    ratios = velocity_ratios(system, snapshot, "theta")
    table = instant_centres(system, snapshot)
    relative = table["crank", "rocker"].at
    assert relative is not None
    expected = relative[0] / (relative[0] - 3)
    assert ratios["rocker"].value == pytest.approx(expected)
    assert ratios["psi"].value == pytest.approx(expected)
    assert ratios["theta"].value == 1
    assert ratios["crank"].unit == "1"


def test_velocity_of_a_piston_per_rate_of_the_crank() -> None:
    system, snapshot = posed(SLIDER_CRANK)
    ratio = velocity_ratios(system, snapshot, "crank")["s"]
    t = math.radians(50)
    expected = -math.sin(t) - math.sin(t) * math.cos(t) / math.sqrt(9 - math.sin(t) ** 2)
    assert ratio.value == pytest.approx(expected)
    assert ratio.unit == "m"


def test_a_dead_point_of_the_input_is_told() -> None:
    system, snapshot = posed(SLIDER_CRANK.replace("50 deg", "0 deg"))
    with pytest.raises(fb.CannotAnswer, match="s stands still in this pose"):
        velocity_ratios(system, snapshot, "s")
    assert velocity_ratios(system, snapshot, "theta")["s"].value == pytest.approx(0, abs=1e-9)


def test_more_than_one_freedom_is_told() -> None:
    system, snapshot = posed("bodies: {a: {rod: {mass: 1 kg, length: 1 m}}}")
    with pytest.raises(fb.CannotAnswer, match="the pose has 3 degrees of freedom"):
        instant_centres(system, snapshot)


def test_a_driven_mechanism_has_the_centres_of_the_free_one() -> None:
    """A driven pose moves in one way only, whatever the rate of the drive: its centres are those of the pose."""
    free = fb.System.from_text(FOUR_BAR)
    driven = fb.System.from_text(
        FOUR_BAR.replace("d: 3 m}", "d: 3 m, n: 7 rad/s}")
        .replace("measures:", "  motor: {driver: {measure: theta, follows: pi/3 - n*t}}\nmeasures:")
        .replace("start: {theta: 60 deg}\n", "")
    )
    tables: list[dict[tuple[str, str], CentreOfPair]] = []
    for system in (free, driven):
        reference = Reference(system)
        q = reference.assemble()
        tables.append(instant_centres(system, reference.snapshot(q, reference.velocities(q))))
    assert tables[0].keys() == tables[1].keys()
    for pair, centre in tables[0].items():
        assert tables[1][pair].at == pytest.approx(centre.at, abs=1e-9)
    assert "<svg" in driven.draw(show=["instant-centres"]).svg()  # type: ignore[union-attr]
