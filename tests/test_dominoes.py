"""A row of dominoes that lean on each other, beside the recursion of Shaw.

Every tile turns about its lower edge on the far side; theta is its angle, w its thickness, d the gap. While tile j
leans on tile j + 1,

    h sin(theta_j - theta_j+1) = (d + w) cos(theta_j+1) - w,

so that all follow the front one. It hits the next at sin(theta) = d/h. Up to that energy is conserved,
I/2 sum c_j^2 omega^2 + V with c_j = d theta_j/d theta_front and I = m (h^2 + w^2)/3; the blow acts on the front tile
and the next one at the same arm, so that I sum c_j^2 omega = (I sum c_j^2 + I) omega' without rebound. Source: Shaw,
Am. J. Phys. 46 (1978) 640-642.
"""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import pytest

import freebody as fb

EXAMPLE = Path(__file__).parents[1] / "examples/dominoes.yaml"
M, H, W, D, OMEGA, G = 0.01, 0.048, 0.008, 0.016, 5.0, 9.81


def leaning(front: float, n: int) -> tuple[list[float], list[float]]:
    """The angles of n tiles, the front one first, and their derivatives by its angle."""
    angles, slopes = [front], [1.0]
    for _ in range(n - 1):
        theta = angles[-1]
        sine = ((D + W) * math.cos(theta) - W) / H
        angles.append(theta + math.asin(sine))
        slopes.append(slopes[-1] * (1.0 - (D + W) * math.sin(theta) / (H * math.sqrt(1.0 - sine**2))))
    return angles, slopes


def potential(angles: list[float]) -> float:
    return sum(M * G / 2 * (H * math.cos(theta) + W * math.sin(theta)) for theta in angles)


def blows(n: int) -> list[tuple[float, float]]:
    """The angular velocity of the front tile before each blow, and the common one after it."""
    inertia, omega, found = M * (H**2 + W**2) / 3, OMEGA, list[tuple[float, float]]()
    for k in range(1, n):
        (start, slopes), (end, later) = leaning(0.0, k), leaning(math.asin(D / H), k)
        energy = inertia / 2 * sum(c**2 for c in slopes) * omega**2 + potential(start) - potential(end)
        moved = inertia * sum(c**2 for c in later)
        before = math.sqrt(2 * energy / moved)
        omega = moved * before / (moved + inertia)
        found.append((before, omega))
    return found


def test_row_of_dominoes_falls_as_the_recursion_says() -> None:
    found = fb.System.load(EXAMPLE).simulate(0.25)
    record = found.course.contact
    assert record is not None
    known = blows(4)
    tiles = ("first", "second", "third", "fourth")
    assert len(record.collisions) == len(known)
    for k, (hit, (before, after)) in enumerate(zip(record.collisions, known, strict=True)):
        name = f"hit{k + 2}.{tiles[k]}.top_right on {tiles[k + 1]} top_left-bottom_left"
        arm = H * math.cos(math.asin(D / H))
        assert hit.before[name] == pytest.approx(-before * arm, rel=1e-8)
        assert hit.impulses[name] == pytest.approx(M * (H**2 + W**2) / 3 * after / arm, rel=1e-8)


def test_row_of_dominoes_goes_on_alike_whatever_the_last_digits_are() -> None:
    """Where two tiles come to lie on each other, one corner comes to the end of an edge at the instant at which another
    one hits: both take part, whichever is noticed first."""
    told: list[list[tuple[str, str, float]]] = []
    for k in (0, 1, 3, 6):
        system = fb.System.load(EXAMPLE).with_parameters(h=H * (1 + 3e-16 * k), Omega=OMEGA * (1 + 2e-16 * k))
        found = system.simulate(0.6)
        told.append(sorted((str(e.name), str(e.kind), round(e.time, 5)) for e in found.events))
    assert len(told[0]) > 10
    assert all(other == told[0] for other in told)


def row(n: int) -> str:
    """The example with n tiles."""
    tiles = range(n)
    measures = "".join(f"  theta{k}: angle of t{k} clockwise\n" for k in tiles)
    bodies = "".join(
        f"  t{k}: {{rectangle: {{mass: m, width: w, height: h}}{'' if k else ', angular_velocity: -Omega'}}}\n"
        for k in tiles
    )
    edges = "".join(f"  edge{k}: {{pin: [ground.e{k}, t{k}.bottom_right]}}\n" for k in tiles)
    hits = "".join(
        f"  stands{k}: {{stop: {{measure: theta{k}, min: 0}}}}\n"
        f"  hit{k}: {{contact: {{between: [t{k - 1}, t{k}], touching: false}}}}\n"
        for k in tiles[1:]
    )
    return f"""
parameters: {{m: {M} kg, h: {H} m, w: {W} m, d: {D} m, Omega: {OMEGA} rad/s, g: {G} m/s^2}}
ground: {{points: {{{", ".join(f"e{k}: [{k}*(d + w), 0]" for k in tiles)}}}}}
bodies:
{bodies}
connections:
{edges}{hits}
loads: {{weight: {{gravity: g}}}}
measures:
{measures}
start: {{{", ".join(f"theta{k}: 0" for k in tiles)}}}
"""


def speeds(n: int) -> list[float]:
    """Of the wave between the blows on tiles k and k + 1: (d + w)/t, t = int dtheta/omega by the energy."""
    integrate = pytest.importorskip("scipy.integrate")
    inertia, found = M * (H**2 + W**2) / 3, list[float]()
    for k, (_before, omega) in enumerate(blows(n)[:-1], start=2):
        angles, slopes = leaning(0.0, k)
        energy = inertia / 2 * sum(c**2 for c in slopes) * omega**2 + potential(angles)

        def slowness(front: float, k: int = k, energy: float = energy) -> float:
            angles, slopes = leaning(front, k)
            return math.sqrt(inertia / 2 * sum(c**2 for c in slopes) / (energy - potential(angles)))

        found.append((D + W) / integrate.quad(slowness, 0.0, math.asin(D / H), epsabs=1e-13)[0])
    return found


def test_wave_through_dominoes_runs_up_to_a_speed_of_its_own() -> None:
    """Its limit is that of the recursion, sqrt(g h) times a number of order one, which for no thickness depends on
    d/h alone (McLachlan, Beaupre, Cox & Gore, SIAM Review 25, 1983)."""
    collisions = fb.System.from_text(row(8)).simulate(0.35, tolerance=1e-10).course.contact
    assert collisions is not None
    times = [hit.time for hit in collisions.collisions]
    assert len(times) == 7
    seen = [(D + W) / (later - earlier) for earlier, later in pairwise(times)]
    assert seen == pytest.approx(speeds(8), rel=1e-7)
    known = speeds(40)
    assert all(a < b for a, b in pairwise(known[:20]))
    assert known[-1] == pytest.approx(known[-2], rel=1e-6)
    assert 1.0 < known[-1] / math.sqrt(G * H) < 2.0
