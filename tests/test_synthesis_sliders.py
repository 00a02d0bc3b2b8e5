"""Slider-cranks that trace paths, and tasks that leave much free: what was built comes back, what is chosen is kept."""

from __future__ import annotations

import math
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import freebody as fb
from freebody.errors import CannotAnswer, ModelError
from freebody.study.synthesis.linkage import Linkage, cognates
from freebody.study.synthesis.positions import places
from freebody.study.synthesis.result import Synthesis
from test_synthesis import ANGLES, FourBar

Array = NDArray[np.float64]


# -- slider-cranks on a path ------------------------------------------------------------------
class SliderCrank:
    """Drawn by hand: crank a, rod b, the pin's line at the offset e in the direction gamma, P on the rod."""

    def __init__(self, a: float = 1.0, b: float = 3.0, e: float = 0.4) -> None:
        self.a, self.b, self.e, self.gamma = a, b, e, 0.3
        self.A, self.local = 0.2 - 0.5j, 0.9 + 0.8j

    def at(self, theta: float) -> tuple[complex, complex, complex, float]:
        """B, C, P and the rod's angle, by the sine of the angle between rod and slide."""
        turn = np.exp(1j * self.gamma)
        phi = math.asin((self.e - self.a * math.sin(theta)) / self.b)
        B = self.A + turn * self.a * np.exp(1j * theta)
        rod = turn * np.exp(1j * phi)
        return complex(B), complex(B + self.b * rod), complex(B + self.local * rod), phi + self.gamma

    def path(self, angles: Array) -> Array:
        return np.array([(P.real, P.imag) for t in angles.tolist() for P in [self.at(t)[2]]])

    def linkage(self, angles: Array) -> Linkage:
        every = [self.at(t)[:3] for t in angles.tolist()]
        B, C, P = (np.array([(x[k].real, x[k].imag) for x in every]) for k in range(3))
        along = np.array((math.cos(self.gamma), math.sin(self.gamma)))
        return Linkage(np.array((self.A.real, self.A.imag)), B, C, None, along, P)


def is_rigid_slider(linkage: Linkage) -> bool:
    """Whether links and the traced point keep their distances, and C stays on its line, over all points."""
    assert linkage.along is not None
    assert linkage.P is not None
    pairs = ((linkage.A, linkage.B), (linkage.B, linkage.C), (linkage.P, linkage.B), (linkage.P, linkage.C))
    kept = [np.linalg.norm(a - b, axis=1) for a, b in pairs]
    kept.append(linkage.C @ np.array((-linkage.along[1], linkage.along[0])))
    return max(float(np.ptp(x)) for x in kept) < 1e-9 * linkage.size


def off_the_quartic(linkage: Linkage, points: Array) -> float:
    """The curve's equation at points, without any angle: with b, c from P to B and C in axes of the rod and n across
    the slide, |P - A + b e^(i phi)|^2 = AB^2 and n . (P - A + c e^(i phi)) = e are linear in cos phi and sin phi; by
    Cramer's rule n1^2 + n2^2 = delta^2, of degree 4."""
    assert linkage.along is not None
    assert linkage.P is not None
    unit = (1.0, 1j)
    B, C, P0, A = (x @ unit for x in (linkage.B[0], linkage.C[0], linkage.P[0], linkage.A))
    n = 1j * complex(linkage.along @ unit)
    worst = 0.0
    for P in points @ unit:
        r = P - A
        w1, k1 = r.conjugate() * (B - P0), (abs(B - A) ** 2 - abs(r) ** 2 - abs(B - P0) ** 2) / 2
        w2, k2 = n.conjugate() * (C - P0), linkage.offset - (n.conjugate() * r).real
        delta = -w1.real * w2.imag + w1.imag * w2.real
        n1, n2 = -k1 * w2.imag + k2 * w1.imag, w1.real * k2 - w2.real * k1
        terms = (n1 * n1, n2 * n2, -delta * delta)
        worst = max(worst, abs(sum(terms)) / sum(abs(x) for x in terms))
    return worst


def nearest_lengths(found: Synthesis, wanted: tuple[float, ...]) -> float:
    every = [list(c.linkage.lengths.values()) for c in found.candidates]
    return min(float(np.abs(np.abs(x) - np.abs(wanted)).max()) for x in every)


def test_the_cognate_of_a_slider_crank_has_its_own_slide_and_traces_the_same_points() -> None:
    angles = np.array(ANGLES)
    given = SliderCrank()
    (other,) = cognates(given.linkage(angles))
    assert is_rigid_slider(other)
    assert other.residual < 1e-12
    assert other.lengths["crank"] == pytest.approx(abs(given.local))
    turned = np.unwrap(other.crank_angles)
    rod = np.unwrap([given.at(t)[3] for t in ANGLES])
    assert np.diff(turned) == pytest.approx(np.diff(rod), abs=1e-12)
    (back,) = cognates(other)
    assert back.lengths == pytest.approx(given.linkage(angles).lengths)
    beyond = SliderCrank().path(np.linspace(0.0, 6.0, 9))
    assert off_the_quartic(other, beyond) < 1e-10


@pytest.mark.parametrize("n", [3, pytest.param(8, marks=pytest.mark.slow)])
def test_slider_cranks_through_points_without_crank_angles(n: int) -> None:
    """Eight unknowns besides the crank angles, so that eight points are met, fewer leave some free."""
    points = SliderCrank().path(np.linspace(0.2, 5.5, n))
    task = {"task": "path", "linkage": "slider-crank", "closed": False, "points": points.tolist()}
    found = fb.synthesise(task, most=3)
    assert found.certified
    assert "not complete" in found.about
    assert ("numbers that stay free: 5" in found.about) == (n == 3)
    for c in found.candidates:
        assert c.linkage.P is not None
        assert np.abs(c.linkage.P - points).max() < 1e-7
        assert is_rigid_slider(c.linkage)
        assert off_the_quartic(c.linkage, points) < 1e-7
    if n == 8:
        assert nearest_lengths(found, (1.0, 3.0, 0.4)) < 1e-6


def test_a_closed_path_of_many_points_leads_back_to_its_slider_crank() -> None:
    points = SliderCrank().path(np.linspace(0.0, math.tau, 20, endpoint=False))
    found = fb.synthesise({"task": "path", "linkage": "slider-crank", "points": points.tolist()}, most=1)
    assert nearest_lengths(found, (1.0, 3.0, 0.4)) < 1e-6
    assert found.candidates[0].is_good
    assert "not proved" in found.about


def timed(points: Array, angles: Array) -> list[dict[str, Any]]:
    """The crank turns by angles from one that nobody knows."""
    turns = (angles - angles[0]).tolist()
    return [{"at": at, "crank": f"{turn!r} rad"} for at, turn in zip(points.tolist(), turns, strict=True)]


@pytest.mark.parametrize(("n", "is_exact"), [(2, True), (4, True), (5, True), (7, False)])
def test_slider_cranks_through_points_with_crank_angles(n: int, is_exact: bool) -> None:
    """Four points and their angles are met by a curve of linkages (7 unknowns, 6 equations); these five and seven are
    points of a linkage, which comes back, of five by dyads, of seven by searches."""
    angles = np.linspace(0.2, 3.5, n)
    points = SliderCrank().path(angles)
    found = fb.synthesise({"task": "path", "linkage": "slider-crank", "points": timed(points, angles)}, most=3)
    assert found.certified
    assert bool(found.dyads) == is_exact
    for c in found.candidates:
        assert c.linkage.P is not None
        assert np.abs(c.linkage.P - points).max() < 1e-8
        assert is_rigid_slider(c.linkage)
        gone = np.mod(np.diff(c.linkage.crank_angles) - np.diff(angles) + math.pi, math.tau) - math.pi
        assert np.abs(gone).max() < 1e-9
    if n >= 5:
        assert nearest_lengths(found, (1.0, 3.0, 0.4)) < 1e-8


def test_of_four_points_with_crank_angles_newton_finds_the_same_slide_from_everywhere() -> None:
    """A_1 W moves on a straight line: three equations in (W, direction), from 200 random starts (seed 2); W is the
    point of the cognate's rod, whose guide is the one slide of the task."""
    angles = np.linspace(0.2, 3.5, 4)
    points = SliderCrank().path(angles)
    task = {"task": "path", "linkage": "slider-crank", "points": timed(points, angles)}
    found = fb.synthesise(task, most=1)
    (guide,) = [d for d in found.dyads if d.is_slide]
    seen = points @ (1.0, 1j)
    turns = np.exp(1j * (angles - angles[0]))
    optimize: Any = import_module("scipy.optimize")
    rng = np.random.default_rng(2)

    def equations(x: Array) -> Array:
        at = seen + turns * (x[0] + 1j * x[1] - seen[0])
        return ((at[1:] - at[0]) * np.exp(-1j * x[2])).imag

    n = 0
    for _ in range(200):
        solution = optimize.root(equations, np.append(rng.normal(0.0, 5.0, 2), rng.uniform(0, math.pi)), tol=1e-13)
        if solution.success and np.abs(equations(solution.x)).max() < 1e-9:
            assert solution.x[:2] == pytest.approx(guide.moving, abs=1e-6)
            n += 1
    assert n > 20


def test_seven_points_of_a_four_bar_with_crank_angles_lead_back_to_it() -> None:
    """More than dyads meet: searched, the angles given from the first."""
    bar, angles = FourBar(), np.linspace(0.2, 4.0, 7)
    points = np.array([bar.at(t)[3] for t in angles.tolist()])
    found = fb.synthesise({"task": "path", "points": timed(points, angles)}, most=1)
    assert nearest_lengths(found, (1.0, 3.0, 2.5, math.hypot(3, 0.5))) < 1e-6
    assert found.candidates[0].is_good


def test_points_that_no_slider_crank_meets_are_approached_and_told_so() -> None:
    angles = np.linspace(0.0, 3.0, 5)
    points = np.array([(0, 0), (1, 0.4), (1.2, 1.1), (0.5, 1.6), (-0.4, 1.0)], dtype=float)
    found = fb.synthesise({"task": "path", "linkage": "slider-crank", "points": timed(points, angles)}, most=1)
    assert "in general at most 4 points are met; fitted to 5" in found.about
    for c in found.candidates[:5]:
        assert c.linkage.P is not None
        off = np.linalg.norm(c.linkage.P - points, axis=1)
        assert float(off.max()) == pytest.approx(c.linkage.missed)
        assert c.linkage.missed > 1e-3
        assert is_rigid_slider(c.linkage)


# -- two positions ----------------------------------------------------------------------------
TWO = [{"at": [0, 0], "angle": "0 deg"}, {"at": ["1 m", "0.4 m"], "angle": "40 deg"}]


def test_of_two_positions_every_point_can_slide_and_bars_stand_on_the_bisector() -> None:
    found = fb.synthesise({"task": "motion", "linkage": "slider-crank", "positions": TWO}, most=3)
    assert len(found.certified) == 3
    assert "slides of sampled points of the coupler: 24" in found.about
    positions = found.task.positions
    for d in found.dyads:
        a, b = places(positions, d.moving)
        across = abs(np.linalg.det(np.array((b - a, d.fixed)))) if d.is_slide else (0.5 * (a + b) - d.fixed) @ (b - a)
        assert across == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("n", [2, 3])
def test_slides_in_a_chosen_direction_at_chosen_pivots(n: int) -> None:
    """The generating slider-crank's pivot and direction are given: with three positions it is the only candidate."""
    given = SliderCrank()
    rows = [{"at": [P.real, P.imag], "angle": f"{phi!r} rad"} for t in ANGLES[:n] for *_bc, P, phi in [given.at(t)]]
    chosen = {"pivots": [[given.A.real, given.A.imag]], "slide": f"{given.gamma} rad"}
    found = fb.synthesise({"task": "motion", "linkage": "slider-crank", "positions": rows, **chosen}, most=1)
    for c in found.candidates:
        assert list(c.linkage.A) == pytest.approx((given.A.real, given.A.imag))
        assert c.linkage.along is not None
        assert abs(math.sin(math.atan2(*c.linkage.along[::-1]) - given.gamma)) < 1e-9
        assert is_rigid_slider(c.linkage)
    if n == 3:
        assert len(found.candidates) == 1
        assert nearest_lengths(found, (1.0, 3.0, 0.4)) < 1e-9
        assert found.certified


@pytest.mark.parametrize("linkage", ["four-bar", "slider-crank", "inverted-slider-crank"])
def test_fixed_pivots_lie_within_chosen_corners(linkage: str) -> None:
    corners = [["-3 m", "-3 m"], ["0.5 m", "0 m"]]
    found = fb.synthesise({"task": "motion", "linkage": linkage, "positions": TWO, "within": corners}, most=1)
    assert found.candidates
    for c in found.candidates:
        for at in (c.linkage.A, *([] if c.linkage.D is None else [c.linkage.D])):
            assert (at >= (-3.0, -3.0)).all()
            assert (at <= (0.5, 0.0)).all()


def test_a_plane_that_is_carried_round_without_turning_is_led_by_parallelograms() -> None:
    """Four places on a circle of radius 1: every bar has this length and is moved from there."""
    rows = [{"at": [math.cos(t), math.sin(t)], "angle": 0} for t in (0.1, 0.8, 2.0, 3.0)]
    found = fb.synthesise({"task": "motion", "positions": rows}, most=2)
    assert found.certified
    for c in found.candidates:
        assert (c.linkage.lengths["crank"], c.linkage.lengths["rocker"]) == pytest.approx((1.0, 1.0))
    rows[3]["at"] = [0.0, 0.0]
    with pytest.raises(CannotAnswer, match="on no circle"):
        fb.synthesise({"task": "motion", "positions": rows})


@pytest.mark.parametrize("linkage", ["four-bar", "slider-crank"])
def test_two_pairs_leave_the_crank_free_and_every_linkage_keeps_them(linkage: str) -> None:
    """As built by hand: rocker or slider at both crank angles, from lengths and branch alone."""
    pairs = [(0.4, 1.1), (1.0, 1.5)]
    is_slider = linkage == "slider-crank"
    rows = [[f"{a!r} rad", f"{b!r} {'m' if is_slider else 'rad'}"] for a, b in pairs]
    found = fb.synthesise({"task": "function", "linkage": linkage, "full_turn": False, "pairs": rows}, most=2)
    assert "the crank's length is free" in found.about
    assert found.certified
    for c in found.candidates:
        r, b = c.linkage.lengths["crank"], list(c.linkage.lengths.values())[1]
        ends = [r * np.exp(1j * a) for a, _out in pairs]
        if is_slider:
            pins = [out + 1j * c.linkage.offset for _a, out in pairs]
        else:
            C = complex(*c.linkage.C[0]) - 1.0
            s = abs(C) * (1 if (C * np.exp(-1j * pairs[0][1])).real > 0 else -1)
            pins = [1.0 + s * np.exp(1j * out) for _a, out in pairs]
        assert [abs(p - e) for p, e in zip(pins, ends, strict=True)] == pytest.approx([b, b])


# -- the transmission angle -------------------------------------------------------------------
@pytest.mark.parametrize("linkage", ["four-bar", "slider-crank", "inverted-slider-crank"])
def test_the_least_transmission_angle_is_that_of_the_followed_motion(linkage: str) -> None:
    """By formula from lengths; by the mobility study from the model, all round; by pins in a fine sample of a swing."""
    found = fb.synthesise({"task": "motion", "linkage": linkage, "positions": TWO}, most=4)
    for c in found.candidates[:4]:
        assert c.certificate is not None
        if c.certificate.transmission is not None and c.linkage.turns_fully:
            assert c.transmission == pytest.approx(c.certificate.transmission[0], abs=1e-6)


@pytest.mark.parametrize(
    ("bar", "low", "high"),
    [(FourBar(2.0, 1.0, 2.0, (2.5, 0.0)), 0.75, 1.2), (FourBar(2.0, 2.0, 2.0, (2.1, 0.0)), -0.5, 0.6)],
    ids=["beside the frame", "through the line of the frame"],
)
def test_a_crank_that_swings_has_the_least_angle_of_its_swing(bar: FourBar, low: float, high: float) -> None:

    def least(angles: Array) -> float:
        every = [bar.at(t)[:2] for t in angles.tolist()]
        folded = [abs(math.degrees(seen_at(C, B, bar.D))) for B, C in every]
        return min(min(x, 180 - x) for x in folded)

    swing = bar.linkage((low, high), (1, 1))
    assert not swing.turns_fully
    assert swing.transmission == pytest.approx(least(np.linspace(low, high, 1101)), abs=1e-3)


def seen_at(at: Array, a: Array, b: Array) -> float:
    z = complex(*(a - at)) / complex(*(b - at))
    return math.atan2(z.imag, z.real)


def test_a_transmission_angle_that_is_too_small_is_a_defect() -> None:
    task = {"task": "motion", "linkage": "slider-crank", "positions": TWO}
    wanted = {**task, "transmission": "55 deg"}
    free, found = (fb.synthesise(t, most=8) for t in (task, wanted))
    assert len(found.certified) < len(free.certified) or found.certified[-1].transmission >= 55
    assert all(c.transmission >= 55 for c in found.certified)
    bad = [d.why for c in found.candidates for d in c.defects if d.name == "transmission"]
    assert bad
    assert "55.0 deg are asked for" in bad[0]
    with pytest.raises(ModelError, match="from 0 to 90 deg"):
        fb.synthesise({**task, "transmission": "100 deg"})
