"""Linkages to given positions, functions and paths: what was built comes back, and what is wrong is said."""

from __future__ import annotations

import json
import math
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import freebody as fb
from command import freebody
from freebody.errors import CannotAnswer, InputError, ModelError
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import snapshot_of
from freebody.study.synthesis.certificate import certified, model_text, seen_alike
from freebody.study.synthesis.curves import centre_point_curve, circle_point_curve, opposite_poles
from freebody.study.synthesis.fewer import by_pivot, curve, on_lines, pole, slides
from freebody.study.synthesis.five import five_positions
from freebody.study.synthesis.linkage import Linkage, cognates, driven_at_other_end
from freebody.study.synthesis.loop import LOOPS, TracedPath
from freebody.study.synthesis.picture import coupler_curve
from freebody.study.synthesis.positions import Position, inverted, places, rows_of
from freebody.study.synthesis.result import Synthesis

Array = NDArray[np.float64]
ANGLES = (0.2, 0.7, 1.3, 1.9, 2.8)


class FourBar:
    """A drawn by hand: lengths a, b, c, pivots A, D, a point P of the coupler in its own axes."""

    def __init__(self, a: float = 1.0, b: float = 3.0, c: float = 2.5, D: tuple[float, float] = (3.0, 0.5)) -> None:
        self.a, self.b, self.c = a, b, c
        self.A, self.D, self.P = np.zeros(2), np.array(D), np.array((0.4, 0.7))

    def at(self, theta: float, side: int = 1) -> tuple[Array, Array, float, Array]:
        """B, C, the coupler's angle, and where P is; by the law of cosines."""
        B = self.A + self.a * np.array((math.cos(theta), math.sin(theta)))
        d = self.D - B
        L = float(np.hypot(*d))
        inner = math.acos((self.b**2 + L**2 - self.c**2) / (2 * self.b * L))
        phi = math.atan2(d[1], d[0]) + side * inner
        turn = np.array(((math.cos(phi), -math.sin(phi)), (math.sin(phi), math.cos(phi))))
        return B, B + self.b * turn[:, 0], phi, B + turn @ self.P

    def positions(self, angles: tuple[float, ...] = ANGLES) -> list[Position]:
        found: list[Position] = []
        for theta in angles:
            _B, _C, phi, P = self.at(theta)
            found.append(Position(float(P[0]), float(P[1]), phi))
        return found

    def linkage(self, angles: tuple[float, ...] = ANGLES, sides: tuple[int, ...] = (1,) * 5) -> Linkage:
        every = [self.at(theta, side) for theta, side in zip(angles, sides, strict=True)]
        B, C, P = (np.array([x[k] for x in every]) for k in (0, 1, 3))
        return Linkage(self.A, B, C, self.D, P=P)


# -- five positions ---------------------------------------------------------------------------
@pytest.mark.parametrize("seed", range(6))
def test_both_dyads_of_a_four_bar_come_back_from_five_of_its_positions(seed: int) -> None:
    rng = np.random.default_rng(seed)
    bar = FourBar(*(float(x) for x in (1.0, *rng.uniform(2.5, 3.5, 2))), D=(float(rng.uniform(2.0, 3.0)), 0.5))
    found = five_positions(bar.positions())
    assert found.is_proved
    assert len(found.dyads) + found.n_complex + found.n_infinite == 4
    B, C, _phi, _P = bar.at(ANGLES[0])
    for moving, fixed in ((B, bar.A), (C, bar.D)):
        near = min(found.dyads, key=lambda d: float(np.abs(d.moving - moving).max()))
        assert near.moving == pytest.approx(moving, abs=1e-9)
        assert near.fixed == pytest.approx(fixed, abs=1e-9)
    for d in found.dyads:
        at = np.linalg.norm(places(bar.positions(), d.moving) - d.fixed, axis=1)
        assert float(np.ptp(at)) <= 1e-11 * (1 + d.length)


def test_newton_from_many_places_finds_no_dyad_that_is_not_among_them() -> None:
    """The four bilinear equations in (W, G), solved from 400 random starts (seed 5)."""
    positions = FourBar().positions()
    found = five_positions(positions)
    optimize: Any = import_module("scipy.optimize")
    rng = np.random.default_rng(5)
    known = np.array([np.append(d.moving, d.fixed) for d in found.dyads])
    seen: set[int] = set()

    def equations(x: Array) -> Array:
        return rows_of(positions, x[:2]) @ np.append(x[2:], 1.0)

    for _ in range(400):
        solution = optimize.root(equations, rng.normal(0.0, 10.0, 4), tol=1e-13)
        if not solution.success or np.abs(equations(solution.x)).max() > 1e-9:
            continue
        distances = np.abs(known - solution.x).max(axis=1)
        assert distances.min() < 1e-5 * (1 + np.abs(solution.x).max())
        seen.add(int(distances.argmin()))
    assert seen == set(range(len(known)))


def test_positions_as_written_are_taken_exactly() -> None:
    """cos 60 deg is 1/2, not its float; a plane that turns about a point is led by a whole curve of dyads."""
    task = {"task": "motion", "positions": [{"at": [0, 0], "angle": f"{k} deg"} for k in (0, 30, 60, 100, 200)]}
    with pytest.raises(CannotAnswer, match="whole curve"):
        fb.synthesise(task)


# -- fewer ------------------------------------------------------------------------------------
def test_the_curves_of_four_positions_pass_through_the_pivots_of_the_four_bar() -> None:
    bar = FourBar()
    positions = bar.positions(ANGLES[:4])
    for d in curve(positions, 24):
        at = np.linalg.norm(places(positions, d.moving) - d.fixed, axis=1)
        assert float(np.ptp(at)) <= 1e-9 * (1 + d.length)
    B, C, _phi, _P = bar.at(ANGLES[0])
    P12 = pole(positions)
    for moving, fixed in ((B, bar.A), (C, bar.D)):
        r = moving - P12
        (found,) = on_lines(positions, P12, [math.atan2(r[1], r[0])])
        near = min(found, key=lambda d: float(np.abs(d.moving - moving).max()))
        assert near.fixed == pytest.approx(fixed, abs=1e-8)


def pole_by_hand(a: Position, b: Position) -> Array:
    """The centre of the rotation from one position to another: half way, and by half the chord over tan(angle/2)
    across it."""
    p, q = np.array((a.x, a.y)), np.array((b.x, b.y))
    across = np.array((p[1] - q[1], q[0] - p[0]))
    return 0.5 * (p + q) + 0.5 * across / math.tan(0.5 * (b.angle - a.angle))


def seen_under(G: Array, a: Array, b: Array) -> float:
    """The directed angle at which G sees the line from a to b."""
    z = complex(*(b - G)) / complex(*(a - G))
    return math.atan2(z.imag, z.real)


CURVED = {
    "of a four-bar": FourBar().positions(ANGLES[:4]),
    "with an angle beyond half a turn": [
        Position(*x) for x in ((0, 0, 0.1), (1, 0.4, -0.5), (1.7, 0.1, 2.0), (2, -1, 3.6))
    ],
    # poles at the corners of a kite: a straight line and a circle
    "that fall apart": [Position(*x) for x in ((-1, 0, -0.6), (-0.3, 0.5, -0.2), (0.3, 0.5, 0.2), (1, 0, 0.6))],
}


@pytest.mark.parametrize("positions", list(CURVED.values()), ids=list(CURVED))
def test_a_centre_point_sees_opposite_sides_of_the_pole_quadrilateral_under_equal_angles(
    positions: list[Position],
) -> None:
    """Up to half a turn (Burmester), with poles by the formula of a rotation; in the picture's square and beyond."""
    P12, P23, P34, P14 = (pole_by_hand(positions[i], positions[j]) for i, j in ((0, 1), (1, 2), (2, 3), (0, 3)))
    found = opposite_poles(positions)
    assert [name for name, _place in found] == ["12", "23", "34", "14"]
    assert np.array([place for _name, place in found]) == pytest.approx(np.array((P12, P23, P34, P14)))
    runs = centre_point_curve(positions, np.array((-4.0, -4.0)), 8.0)
    points = np.vstack(runs)
    assert len(points) > 200
    for G in points:
        if min(float(np.linalg.norm(G - p)) for p in (P12, P23, P34, P14)) > 0.02:
            between = seen_under(G, P12, P23) - seen_under(G, P14, P34)
            assert abs(math.sin(between)) < 1e-6


@pytest.mark.parametrize("positions", list(CURVED.values()), ids=list(CURVED))
def test_the_four_places_of_a_circle_point_have_one_centre_on_the_centre_point_curve(positions: list[Position]) -> None:
    """The centre of the circle through three of the places is as far from the fourth, and back from the fixed plane:
    the places of a centre point, as the moving plane sees it, are on a circle too."""
    for curve_of, seen in ((circle_point_curve, positions), (centre_point_curve, inverted(positions))):
        for W in np.vstack(curve_of(positions, np.array((-4.0, -4.0)), 8.0)):
            at = places(seen, W)
            sides = at[1:3] - at[0]
            if abs(np.linalg.det(sides)) < 1e-3:  # nearly on a line
                continue
            centre = at[0] + np.asarray(np.linalg.solve(sides, 0.5 * (sides * sides).sum(axis=1)), dtype=np.float64)
            r = np.linalg.norm(at - centre, axis=1)
            assert float(np.ptp(r)) < 1e-6 * (1 + float(r[0]))


def test_the_curves_pass_through_the_pivots_and_are_drawn_with_them(tmp_path: Path) -> None:
    bar = FourBar()
    positions = bar.positions(ANGLES[:4])
    B, C, _phi, _P = bar.at(ANGLES[0])
    low = np.array((-4.0, -4.0))
    for curve_of, pivots in ((centre_point_curve, (bar.A, bar.D)), (circle_point_curve, (B, C))):
        points = np.vstack(curve_of(positions, low, 8.0))
        for pivot in pivots:
            assert float(np.linalg.norm(points - pivot, axis=1).min()) < 8.0 / 240
    rows = [{"at": [p.x, p.y], "angle": f"{p.angle!r} rad"} for p in positions]
    found = fb.synthesise({"task": "motion", "positions": rows}, most=1)
    svg = found.curves().svg()
    assert "centre-point curve" in svg
    assert "opposite poles" in svg
    assert any("Burmester" in str(block) for block in found.report.blocks)
    with pytest.raises(InputError, match="four positions"):
        fb.synthesise({"task": "motion", "positions": rows[:3]}, most=1).curves()


def test_a_fixed_pivot_tells_the_moving_one_of_three_positions() -> None:
    bar = FourBar()
    found = by_pivot(bar.positions(ANGLES[:3]), bar.D)
    assert found is not None
    assert found.moving == pytest.approx(bar.at(ANGLES[0])[1], abs=1e-10)


def test_the_slider_of_four_positions_is_the_wrist_pin_of_a_slider_crank() -> None:
    """Crank 1, rod 3, the pin on the line y = 0.4; positions of the rod."""
    found: list[Position] = []
    for theta in ANGLES[:4]:
        B = np.array((math.cos(theta), math.sin(theta)))
        phi = math.asin((0.4 - B[1]) / 3.0)
        found.append(Position(float(B[0]), float(B[1]), phi))
    (d,) = slides(found, [])
    pin = np.array((found[0].x, found[0].y))
    assert d.moving == pytest.approx(
        pin + 3.0 * np.array((math.cos(found[0].angle), math.sin(found[0].angle))), abs=1e-9
    )
    assert d.fixed == pytest.approx((1.0, 0.0), abs=1e-9)
    for one in slides(found[:3], [0.3, 1.0, 2.0]):
        assert one.residual < 1e-9


# -- at infinity ------------------------------------------------------------------------------
def positions_of_a_rod_on_a_slide() -> list[Position]:
    """Crank 1, rod 3, its pin on the line y = 0.4."""
    made: list[Position] = []
    for theta in ANGLES:
        B = np.array((math.cos(theta), math.sin(theta)))
        made.append(Position(float(B[0]), float(B[1]), math.asin((0.4 - B[1]) / 3.0)))
    return made


def positions_of_a_rod_in_a_swivel() -> list[Position]:
    """Crank 1; the rod's axis, 0.4 to the left of which the swivel (3, 0.2) is: the triangle of both and the foot."""
    made: list[Position] = []
    for theta in ANGLES:
        x, y = 3.0 - math.cos(theta), 0.2 - math.sin(theta)
        turned = math.atan2(y, x) - math.asin(0.4 / math.hypot(x, y))
        made.append(Position(math.cos(theta), math.sin(theta), turned))
    return made


def motion(linkage: str, positions: list[Position]) -> Synthesis:
    rows = [{"at": [p.x, p.y], "angle": f"{p.angle!r} rad"} for p in positions]
    return fb.synthesise({"task": "motion", "linkage": linkage, "positions": rows}, most=3)


def test_five_positions_of_a_rod_on_a_slide_have_their_slide_and_no_line_through_a_pivot() -> None:
    found = motion("slider-crank", positions_of_a_rod_on_a_slide())
    assert "1 of them with the fixed pivot at infinity" in found.about
    lengths = [list(c.linkage.lengths.values()) for c in found.certified]
    assert min(np.abs(np.array(x) - (1.0, 3.0, 0.4)).max() for x in lengths) < 1e-8
    none = motion("inverted-slider-crank", positions_of_a_rod_on_a_slide())
    assert not none.candidates
    assert "no line of the coupler goes through a fixed pivot" in none.about


def test_five_positions_of_a_rod_in_a_swivel_have_their_line_and_no_slide() -> None:
    """Mirror images of each other: the fixed plane, seen from the rod, is on a slide."""
    found = motion("inverted-slider-crank", positions_of_a_rod_in_a_swivel())
    assert "1 with the moving pivot at infinity" in found.about
    lengths = [list(c.linkage.lengths.values()) for c in found.certified]
    assert min(np.abs(np.array(x) - (1.0, math.hypot(3, 0.2), 0.4)).max() for x in lengths) < 1e-8
    none = motion("slider-crank", positions_of_a_rod_in_a_swivel())
    assert not none.candidates
    assert "no point of the coupler stays on a straight line" in none.about


def test_most_five_positions_have_nothing_at_infinity() -> None:
    found = motion("four-bar", FourBar().positions())
    assert "none at infinity, so that no slide can take the place of a pin" in found.about


@pytest.mark.parametrize("n", [3, 4, 5])
def test_the_coupler_of_an_inverted_slider_crank_goes_through_its_swivel_in_every_position(n: int) -> None:
    """The line through the places of two points of the coupler's line is 0 from D; B is at its crank's end."""
    positions = positions_of_a_rod_in_a_swivel()[:n]
    found = motion("inverted-slider-crank", positions)
    assert found.certified
    for c in found.certified:
        linkage = c.linkage
        assert linkage.D is not None
        assert linkage.along is not None
        first, second = (places(positions, linkage.C[0] + r * linkage.along) for r in (0.0, 1.0))
        for a, b in zip(first, second, strict=True):
            (x, y), (u, v) = b - a, linkage.D - a
            assert abs(x * v - y * u) < 1e-8 * linkage.size
        assert float(np.ptp(np.linalg.norm(linkage.B - linkage.A, axis=1))) < 1e-8 * linkage.size
        assert fb.System.from_text(model_text(linkage, "swivel")).mobility().degrees_of_freedom == 1
        curve = coupler_curve(linkage)
        assert linkage.P is not None
        step = float(np.linalg.norm(np.diff(curve, axis=0), axis=1).max())
        for P in linkage.P:
            assert float(np.linalg.norm(curve - P, axis=1).min()) < step


def test_a_short_swivel_stops_the_crank_at_the_angle_where_the_slot_is_across() -> None:
    """BD = 0.4: cos theta = (1 + d^2 - 0.16)/(2 d) for D = (1.2, 0)."""
    D = np.array((1.2, 0.0))
    B = np.array([(math.cos(t), math.sin(t)) for t in (1.0, 1.6, 2.4)])
    e: list[tuple[float, float]] = []
    for b in B:
        x, y = D - b
        turned = math.atan2(y, x) - math.asin(0.4 / math.hypot(x, y))
        e.append((math.cos(turned), math.sin(turned)))
    lines = np.array(e)
    s = float((D - B[0]) @ lines[0])
    C = np.array([b + s * t + 0.4 * np.array((-t[1], t[0])) for b, t in zip(B, lines, strict=True)])
    linkage = Linkage(np.zeros(2), B, C, D, lines[0])
    assert linkage.lines == pytest.approx(lines)
    assert linkage.limits[1] == pytest.approx((1 + 1.44 - 0.16) / 2.4)
    assert {d.name for d in linkage.defects(full_turn=True)} == {"no full turn"}
    certificate = certified(linkage, "swivel", full_turn=False)
    assert not certificate.defects
    assert not certificate.turns_fully
    assert seen_alike(linkage, certificate) is None


def test_the_slide_is_found_where_the_first_two_positions_are_turned_alike() -> None:
    """At crank angles 0.7 and pi - 0.7 the crank's end is as high, so that the rod is parallel to itself."""
    made: list[Position] = []
    for theta in (0.7, math.pi - 0.7, 1.3, 0.2):
        x, y = math.cos(theta), math.sin(theta)
        made.append(Position(x, y, math.asin((0.4 - y) / 3.0)))
    (d,) = slides(made, [])
    first = made[0]
    pin = np.array((first.x + 3.0 * math.cos(first.angle), first.y + 3.0 * math.sin(first.angle)))
    assert d.moving == pytest.approx(pin, abs=1e-9)
    assert np.ptp(places(made, d.moving)[:, 1]) < 1e-9
    for one in slides(made[:3], [0.3, 1.0, 2.0]):
        assert one.residual < 1e-9


# -- functions --------------------------------------------------------------------------------
def function_pairs(angles: tuple[float, ...]) -> list[list[str]]:
    """Crank 0.4, coupler 0.9, rocker 0.7 on a frame of 1 m."""
    bar = FourBar(0.4, 0.9, 0.7, (1.0, 0.0))
    out: list[list[str]] = []
    for theta in angles:
        _B, C, _phi, _P = bar.at(theta)
        psi = math.atan2(C[1], C[0] - 1.0)
        out.append([f"{theta!r} rad", f"{psi!r} rad"])
    return out


@pytest.mark.parametrize("n", [3, 4, 5])
def test_a_function_generator_comes_back_from_its_pairs(n: int) -> None:
    found = fb.synthesise({"task": "function", "frame": "1 m", "pairs": function_pairs(ANGLES[:n])})
    lengths = [list(c.linkage.lengths.values()) for c in found.candidates]
    assert min(np.abs(np.array(x) - (0.4, 0.9, 0.7, 1.0)).max() for x in lengths) < 1e-8
    assert found.candidates[0].is_good


def test_three_pairs_are_led_by_the_linkage_of_freudensteins_equation() -> None:
    """K1 cos psi - K2 cos phi + K3 = cos(phi - psi), K1 = d/a, K2 = d/c, K3 = (a^2 - b^2 + c^2 + d^2)/(2 a c), for
    y = x^2 on 1..2 with Chebyshev's spacing, phi = 90..150 deg and psi = 90..180 deg (Freudenstein, Trans.
    ASME 77, 1955)."""
    x = np.array([1.5 - 0.5 * math.cos(math.pi * k / 6) for k in (1, 3, 5)])
    phi, psi = np.radians(90 + 60 * (x - 1)), np.radians(90 + 30 * (x**2 - 1))
    K = np.linalg.solve(np.column_stack((np.cos(psi), -np.cos(phi), np.ones(3))), np.cos(phi - psi))
    a, c = 1 / K[0], 1 / K[1]
    b = math.sqrt(a * a + c * c + 1 - 2 * a * c * K[2])
    pairs = [[f"{p!r} rad", f"{q!r} rad"] for p, q in zip(phi.tolist(), psi.tolist(), strict=True)]
    found = fb.synthesise({"task": "function", "full_turn": False, "pairs": pairs})
    (one,) = found.candidates
    assert one.linkage.lengths == pytest.approx(
        {"crank": abs(a), "coupler": b, "rocker": abs(c), "frame": 1.0}, rel=1e-9
    )


@pytest.mark.parametrize("n", [3, 4, 5])
def test_a_slider_crank_comes_back_from_its_pairs(n: int) -> None:
    """Crank 0.1, rod 0.3, offset 0.02: s = r cos phi + sqrt(l^2 - (e - r sin phi)^2)."""
    pairs = [
        [f"{t!r} rad", f"{0.1 * math.cos(t) + math.sqrt(0.09 - (0.02 - 0.1 * math.sin(t)) ** 2)!r} m"]
        for t in ANGLES[:n]
    ]
    found = fb.synthesise({"task": "function", "linkage": "slider-crank", "pairs": pairs})
    lengths = [list(c.linkage.lengths.values()) for c in found.candidates]
    assert min(np.abs(np.array(x) - (0.1, 0.3, 0.02)).max() for x in lengths) < 1e-8
    assert found.certified


# -- paths ------------------------------------------------------------------------------------
def test_cognates_trace_the_same_points_and_the_crank_turns_as_the_coupler_did() -> None:
    bar = FourBar()
    for other in cognates(bar.linkage()):
        assert other.residual < 1e-12
        assert other.P is not None
        a1 = np.linalg.norm(other.P - other.B, axis=1)
        assert float(np.ptp(a1)) < 1e-12
        turned = [math.atan2(*(x - other.A)[::-1]) for x in other.B]
        coupler = [bar.at(theta)[2] for theta in ANGLES]
        gone = np.mod(np.diff(turned) - np.diff(coupler) + math.pi, math.tau) - math.pi
        assert np.abs(gone).max() < 1e-12


def test_a_four_bar_driven_at_its_other_end_traces_the_same_points() -> None:
    bar = FourBar().linkage()
    other = driven_at_other_end(bar)
    assert other.residual < 1e-12
    assert other.lengths == pytest.approx(
        {"crank": 2.5, "coupler": 3.0, "rocker": 1.0, "frame": bar.lengths["frame"]}, rel=1e-12
    )
    assert "no full turn" in {d.name for d in other.defects(full_turn=True)}
    assert other.P is bar.P


def test_a_four_bar_comes_back_from_five_points_of_its_path_and_crank_angles() -> None:
    bar = FourBar()
    points = [{"at": [float(x) for x in bar.at(theta)[3]], "crank": f"{theta!r} rad"} for theta in ANGLES]
    found = fb.synthesise({"task": "path", "points": points})
    lengths = [list(c.linkage.lengths.values()) for c in found.candidates]
    assert min(np.abs(np.array(x) - (1.0, 3.0, 2.5, math.hypot(3, 0.5))).max() for x in lengths) < 1e-7
    assert found.candidates[0].is_good


def test_a_closed_path_of_many_points_leads_back_to_its_four_bar() -> None:
    bar = FourBar(0.7, 2.2, 2.0, (2.5, 0.4))
    angles = np.linspace(0.0, math.tau, 24, endpoint=False)
    points = np.array([bar.at(float(theta))[3] for theta in angles])
    found = fb.synthesise({"task": "path", "points": points.tolist()}, most=1)
    best = found.candidates[0]
    assert best.is_good
    assert best.linkage.missed < 1e-9
    assert list(best.linkage.lengths.values()) == pytest.approx((0.7, 2.2, 2.0, math.hypot(2.5, 0.4)), rel=1e-6)
    assert "not proved" in found.about


@pytest.mark.parametrize("is_timed", [False, True], ids=["untimed", "timed"])
@pytest.mark.parametrize(
    ("linkage", "lengths"),
    [
        ("four-bar", (0.5, 1.3, 1.1, 1.2)),
        ("slider-crank", (0.5, 1.3, -0.2)),
        ("inverted-slider-crank", (0.5, 1.2, -0.2)),
    ],
)
def test_slopes_of_the_fitted_curve_are_those_of_differences(
    linkage: str, lengths: tuple[float, ...], is_timed: bool
) -> None:
    rng = np.random.default_rng(3)
    target = rng.normal(size=7) + 1j * rng.normal(size=7)
    theta = rng.uniform(0, math.tau, 7)
    path = TracedPath(LOOPS[linkage], target, theta - theta[0] if is_timed else None)
    x = np.concatenate(([0.1, -0.2, 0.3, *lengths, 0.4, 0.6], theta[:1] if is_timed else theta))
    for side in (-1, 1):
        h = 1e-6
        steps = [(path.residuals(x + h * e, side) - path.residuals(x - h * e, side)) / (2 * h) for e in np.eye(len(x))]
        assert path.slopes(x, side) == pytest.approx(np.column_stack(steps), abs=1e-7)


def off_the_sextic(linkage: Linkage, points: Array) -> float:
    """The coupler curve's equation at points, without any angle: with b, c from P to B and C in axes of the coupler,
    |P - A + b e^(i phi)|^2 = AB^2 and the same for D are linear in cos phi and sin phi; by Cramer's rule
    (n1^2 + n2^2 - delta^2) = 0. Source: Wampler, Morgan & Sommese 1992, eq. 3 to 5."""
    assert linkage.D is not None
    assert linkage.P is not None
    unit = (1.0, 1j)
    B, C, P0, A, D = (x @ unit for x in (linkage.B[0], linkage.C[0], linkage.P[0], linkage.A, linkage.D))
    worst = 0.0
    for P in points @ unit:
        rows = [
            (
                (P - pivot).conjugate() * (end - P0),
                (abs(end - pivot) ** 2 - abs(P - pivot) ** 2 - abs(end - P0) ** 2) / 2,
            )
            for pivot, end in ((A, B), (D, C))
        ]
        (w1, k1), (w2, k2) = rows
        delta = -w1.real * w2.imag + w1.imag * w2.real
        n1, n2 = -k1 * w2.imag + k2 * w1.imag, w1.real * k2 - w2.real * k1
        terms = (n1 * n1, n2 * n2, -delta * delta)
        worst = max(worst, abs(sum(terms)) / sum(abs(x) for x in terms))
    return worst


def is_rigid(linkage: Linkage) -> bool:
    """Whether links and the traced point keep their distances over all points."""
    assert linkage.D is not None
    assert linkage.P is not None
    pairs = ((linkage.A, linkage.B), (linkage.B, linkage.C), (linkage.C, linkage.D), (linkage.P, linkage.B))
    kept = [np.linalg.norm(a - b, axis=1) for a, b in (*pairs, (linkage.P, linkage.C))]
    return max(float(np.ptp(x)) for x in kept) < 1e-9 * linkage.size


WIPER = [[0.0, 0.0], [0.01, 0.015], [0.03, 0.022], [0.05, 0.016], [0.062, 0.003]]


def test_five_points_without_crank_angles_lie_on_the_coupler_curves_of_certified_linkages() -> None:
    found = fb.synthesise({"task": "path", "closed": False, "points": WIPER}, most=3)
    assert len(found.certified) == 3
    assert "not complete" in found.about
    for c in found.certified:
        assert c.linkage.P is not None
        assert np.abs(c.linkage.P - np.array(WIPER)).max() < 1e-10
        assert is_rigid(c.linkage)
        assert off_the_sextic(c.linkage, np.array(WIPER)) < 1e-8
        turned = np.unwrap(c.linkage.crank_angles)
        assert (np.diff(turned) > 0).all() or (np.diff(turned) < 0).all()
        assert c.certificate is not None
        assert c.certificate.turns_fully
    least = [round(c.transmission, 6) for c in found.certified]  # cognates have the same
    assert least == sorted(least, reverse=True)


def test_an_arc_is_led_through_by_a_crank_that_swings() -> None:
    """Six points of the double rocker with lengths 2, 1, 2, 2.5."""
    bar = FourBar(2.0, 1.0, 2.0, (2.5, 0.0))
    points = np.array([bar.at(float(theta))[3] for theta in np.linspace(0.8, 1.2, 6)])
    task = {"task": "path", "closed": False, "full_turn": False, "points": points.tolist()}
    found = fb.synthesise(task, most=2)
    assert found.certified
    for c in found.certified:
        assert is_rigid(c.linkage)
        assert c.linkage.P is not None
        assert np.abs(c.linkage.P - points).max() < 1e-9
        assert off_the_sextic(c.linkage, points) < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize(("n", "last", "off"), [(9, 6.0, 1e-8), (14, 3.0, 1e-4)], ids=["nine points", "an arc of many"])
def test_a_four_bar_comes_back_from_points_of_its_path_alone(n: int, last: float, off: float) -> None:
    bar = FourBar()
    points = np.array([bar.at(float(theta))[3] for theta in np.linspace(0.2, last, n)])
    found = fb.synthesise({"task": "path", "closed": False, "points": points.tolist()}, most=3)
    assert all(is_rigid(c.linkage) for c in found.candidates)
    lengths = [list(c.linkage.lengths.values()) for c in found.certified]
    assert min(np.abs(np.array(x) - (1.0, 3.0, 2.5, math.hypot(3, 0.5))).max() for x in lengths) < off


@pytest.mark.slow
def test_nine_points_that_no_search_comes_through_are_only_approached() -> None:
    rng = np.random.default_rng(1)
    points = [[math.cos(t) + 0.1 * rng.normal(), math.sin(t) / 2 + 0.1 * rng.normal()] for t in np.linspace(0, 5.7, 9)]
    found = fb.synthesise({"task": "path", "points": points}, most=1)
    assert "none of 64 local searches" in found.about
    assert min(c.linkage.missed for c in found.candidates) > 1e-3


# -- defects ----------------------------------------------------------------------------------
def names_of(linkage: Linkage, *, full_turn: bool = True) -> set[str]:
    return {d.name for d in linkage.defects(full_turn=full_turn)}


def test_positions_on_the_other_circuit_are_a_circuit_defect_by_formula_and_by_motion() -> None:
    linkage = FourBar().linkage(sides=(1, 1, -1, 1, 1))
    assert names_of(linkage) == {"circuit"}
    certificate = certified(linkage, "both sides", full_turn=True)
    assert {d.name for d in certificate.defects} == {"circuit"}
    assert seen_alike(linkage, certificate) is None
    (told,) = linkage.defects(full_turn=True)
    assert "1, 2, 4, 5 and 3 are on different circuits" in told.why


def test_a_dead_point_between_positions_is_a_branch_defect() -> None:
    """Lengths 2, 1, 2, 2.5: no link turns fully, so that both sides are one circuit."""
    bar = FourBar(2.0, 1.0, 2.0, (2.5, 0.0))
    linkage = bar.linkage((0.9, 1.0, 0.95), (1, 1, -1))
    assert names_of(linkage, full_turn=False) == {"branch"}
    certificate = certified(linkage, "through a dead point", full_turn=False)
    assert not certificate.defects
    assert not certificate.turns_fully
    assert seen_alike(linkage, certificate) is None


def test_positions_out_of_order_are_told() -> None:
    linkage = FourBar().linkage((0.2, 1.3, 0.7, 1.9, 2.8))
    (told,) = linkage.defects(full_turn=True)
    assert (told.name, "1, 3, 2, 4, 5" in told.why) == ("order", True)


def test_a_crank_that_swings_does_not_turn_fully() -> None:
    linkage = FourBar(2.0, 1.0, 2.0, (2.5, 0.0)).linkage((0.9, 0.95, 1.0), (1, 1, 1))
    assert names_of(linkage) == {"no full turn"}
    assert not names_of(linkage, full_turn=False)


@pytest.mark.slow
def test_formulas_and_followed_motion_agree_about_every_candidate() -> None:
    for seed in range(3):
        rng = np.random.default_rng(seed)
        rows = [{"at": [float(x) for x in rng.uniform(0, 1, 2)], "angle": f"{a} deg"} for a in (0, 15, 40, 70, 95)]
        found = fb.synthesise({"task": "motion", "full_turn": False, "positions": rows}, most=40)
        for c in found.candidates:
            assert "not certified" not in {d.name for d in c.defects}, (seed, c.defects)


# -- the whole --------------------------------------------------------------------------------
LOADER = """
title: Loader arm
task: motion
positions:
  - {at: [0.9 m, 0.9 m], angle: 20 deg}
  - {at: [1.3 m, 1.0 m], angle: 5 deg}
  - {at: [1.6 m, 0.9 m], angle: -10 deg}
  - {at: [1.9 m, 0.6 m], angle: -28 deg}
"""


def test_certified_candidates_are_models_that_are_at_the_positions(tmp_path: Path) -> None:
    """Each written model, assembled at the crank angle of every position, has the traced point there."""
    (tmp_path / "task.yaml").write_text(LOADER, encoding="utf-8")
    found = fb.synthesise(tmp_path / "task.yaml", most=2, out=tmp_path / "out")
    assert len(found.certified) == len(found.files) == 2
    for candidate, file in zip(found.certified, found.files, strict=True):
        linkage = candidate.linkage
        assert candidate.certificate is not None
        assert candidate.certificate.case in ("crank-rocker", "double-crank (drag link)")
        assert linkage.P is not None
        system = fb.System.load(file)
        assert system.mobility().degrees_of_freedom == 1
        text = file.read_text(encoding="utf-8")
        text = text.replace("measures:", "measures:\n  px: x of coupler.P\n  py: y of coupler.P")
        for k in range(4):
            r = linkage.B[k] - linkage.A
            start = f"start: {{theta: {math.atan2(r[1], r[0])!r} rad}}\n"
            coupler = linkage.C[k] - linkage.B[k]
            near = f"near: {{angle: {math.atan2(coupler[1], coupler[0])!r} rad}}"
            model = text[: text.index("start:")] + start
            at = model.index("near:")
            moved = model[:at] + near + model[model.index("}", at) + 1 :]
            reference = Reference(fb.System.from_text(moved))
            q = reference.assemble()
            place = [
                snapshot_of(reference, q, np.zeros_like(q)).value(reference.system.measures[n]) for n in ("px", "py")
            ]
            assert place == pytest.approx(linkage.P[k], abs=1e-8)


def test_the_command_prints_writes_and_ends_with_whether_something_was_found(tmp_path: Path) -> None:
    (tmp_path / "task.yaml").write_text(LOADER, encoding="utf-8")
    args = ("synthesise", str(tmp_path / "task.yaml"), "--most", "1", "--json")
    ran = freebody(
        *args, "-o", str(tmp_path / "out"), "--plot", str(tmp_path / "it.svg"), "--curves", str(tmp_path / "c.svg")
    )
    assert ran.returncode == 0, ran.stderr
    told = json.loads(ran.stdout)
    assert told["certified"] == 1
    assert told["candidates"][0]["verdict"] == "certified"
    assert (tmp_path / "out" / "candidate_1.yaml").exists()
    assert all("<svg" in (tmp_path / name).read_text(encoding="utf-8") for name in ("it.svg", "c.svg"))
    assert freebody("synthesise", str(tmp_path / "none.yaml")).returncode == 2


MOVED = [{"at": [f"{k} m", f"{k * k} m"], "angle": f"{10 * k} deg"} for k in range(4)]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("task: motoin\npositions: []", "task is one of motion, function, path"),
        ("task: motion\npositions: [{at: [0, 0], angle: 0}]", "at least 2"),
        ("task: motion\npositions: [{at: [0, 0]}, {at: [1 kg, 0], angle: 0}]", "kg"),
        ("task: motion\nposition: []\npositions: []", "a task has no position. Did you mean positions"),
        (
            "task: function\nlinkage: inverted-slider-crank\npairs: [[1, 1], [2, 1], [3, 1]]",
            "by four-bars and slider-cranks only",
        ),
        ("task: path\npoints: [[0, 0]]", "at least 2"),
        ("task: path\npoints: [[0, 0], [1, 0], [1, 0]]", "points 2 and 3 are the same"),
        ("task: path\npoints: [[0, 0], [1, 0], [1, 1], [0, 0]]", "comes back to its first point by itself"),
        ("task: motion\npositions: [{at: [0, 0], angle: 0}, {at: [0, 0], angle: 0}]", "positions 1 and 2 are the same"),
        ("task: function\npairs: [[1 rad, 1 rad], [1 rad, 2 rad]]", "pairs 1 and 2 have the same input"),
        ("task: path\npivots: [[0, 0]]\npoints: [[0, 0], [1, 0]]", "pivots belongs to motion generation"),
        (f"task: motion\nslide: 0 deg\npositions: {MOVED[:2]}", "a four-bar has no slide"),
        (f"task: motion\nlinkage: slider-crank\nslide: 0 deg\npositions: {MOVED}", "cannot be chosen with 4 positions"),
        (f"task: motion\nwithin: [[0, 0]]\npositions: {MOVED}", "within has two corners"),
        (f"task: motion\nwithin: 3\npositions: {MOVED}", "within is a list of points"),
        ("task: path\nclosed: perhaps\npoints: [[0, 0], [1, 0]]", "closed is true or false"),
        ("task: function\nframe: 0 m\npairs: [[1, 1], [1.1, 1], [1.2, 1]]", "length greater than 0"),
        ("task: function\npairs: [[40, 1], [1.1, 1], [1.2, 1]]", "has no unit"),
        ("task: motion\npositions: [" + ", ".join("{at: [0, 0], angle: 0}" for _ in range(6)) + "]", "at most 5"),
    ],
)
def test_tasks_that_cannot_be_read_are_told_with_their_place(text: str, words: str, tmp_path: Path) -> None:
    path = tmp_path / "task.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ModelError) as told:
        fb.synthesise(path)
    assert words in str(told.value)
    assert "task.yaml" in str(told.value)


def test_no_candidate_is_looked_at_is_refused() -> None:
    with pytest.raises(InputError, match="at least one candidate"):
        fb.synthesise({"task": "motion", "positions": [{"at": [0, 0], "angle": 0}, {"at": [1, 0], "angle": 1}]}, most=0)
