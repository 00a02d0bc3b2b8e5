"""Random members of families of models, with numbers written in the file as people write them, against the formulas of
the textbooks (or an independent linear solve written here). Every answer is printed as a value that is right to 1e-9.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import pytest

import freebody as fb

SEED = 20261122
G = 9.81
DIGITS = 1e-9
Found = dict[str, float | list[float]]


@dataclass
class Case:
    """A model, and what its answers must be."""

    model: str
    expected: Found


@dataclass
class Tally:
    """How many answers were closed forms, numbers, or refused."""

    closed: int = 0
    numbers: int = 0
    refused: list[str] = field(default_factory=list[str])
    wrong: list[str] = field(default_factory=list[str])


def _decimal(rng: random.Random, low: float, high: float) -> float:
    """Three digits at most, as in an exercise."""
    return float(f"{rng.uniform(low, high):.3g}")


def _radius(rng: random.Random) -> float:
    return rng.choice([0.125, 0.3, 0.035, 0.25, 0.08, 0.175, 0.0625, _decimal(rng, 0.02, 0.6)])


def atwood(rng: random.Random) -> Case:
    """Two masses over a pulley of mass M that the string grips: a = (m1 - m2) g/(m1 + m2 + M/2)."""
    m1, m2, M, R = (*(_decimal(rng, 0.5, 9) for _ in range(3)), _radius(rng))
    a = (m1 - m2) * G / (m1 + m2 + M / 2)
    model = f"""
bodies:
  pulley: {{disk: {{mass: {M} kg, radius: {R} m}}}}
  left: {{particle: {{mass: {m1} kg}}}}
  right: {{particle: {{mass: {m2} kg}}}}
connections:
  axle: {{pin: [ground.axle, pulley.center]}}
  rope: {{string: {{from: left, over: [pulley], to: right, grips: [pulley]}}}}
loads: {{weight: {{gravity: {G} m/s^2}}}}
measures: {{x1: {{drop of left below ground.axle}}}}
"""
    expected: Found = {
        "acceleration of x1": a,
        "tension of rope at left": m1 * (G - a),
        "tension of rope at right": m2 * (G + a),
        "vertical reaction of axle on pulley": M * G + m1 * (G - a) + m2 * (G + a),
    }
    return Case(model, expected)


def compound_atwood(rng: random.Random) -> Case:
    """A second massless pulley with m2 and m3 hangs on one side: it weighs like 4 m2 m3/(m2 + m3)."""
    m1, m2, m3 = (_decimal(rng, 0.5, 9) for _ in range(3))
    R, r = _radius(rng), _radius(rng)
    m = 4 * m2 * m3 / (m2 + m3)
    a1 = (m1 - m) * G / (m1 + m)
    # the lower pulley rises with a1, so that its masses hang in a field of g + a1
    relative = (m2 - m3) / (m2 + m3) * (G + a1)
    model = f"""
bodies:
  upper: {{disk: {{radius: {R} m}}}}
  lower: {{disk: {{radius: {r} m}}}}
  A: {{particle: {{mass: {m1} kg}}}}
  B: {{particle: {{mass: {m2} kg}}}}
  C: {{particle: {{mass: {m3} kg}}}}
connections:
  axle: {{pin: [ground.O, upper]}}
  rope1: {{string: {{from: A, over: [upper], to: lower}}}}
  rope2: {{string: {{from: B, over: [lower], to: C}}}}
loads: {{weight: {{gravity: {G} m/s^2}}}}
measures: {{x1: {{drop of A below ground.O}}, x2: {{drop of B below ground.O}}, x3: {{drop of C below ground.O}}}}
"""
    expected: Found = {
        "acceleration of x1": a1,
        "acceleration of x2": -a1 + relative,
        "acceleration of x3": -a1 - relative,
        "tension of rope1 at A": m1 * (G - a1),
        "tension of rope2 at B": m1 * (G - a1) / 2,
    }
    return Case(model, expected)


def winch(rng: random.Random) -> Case:
    """A drum pays a string out when it turns counter-clockwise; the string runs under a movable pulley and back. So the
    drum turns by 2 y'/R clockwise as the load rises: (m + 4 I/R^2) y'' = -2 T/R - m g."""
    inertia, m, T = _decimal(rng, 0.05, 2), _decimal(rng, 2, 40), _decimal(rng, 1, 60)
    R = _radius(rng)
    a = (-2 * T / R - m * G) / (m + 4 * inertia / R**2)
    model = f"""
bodies:
  drum: {{body: {{inertia: {inertia} kg m^2, radius: {R} m}}}}
  block: {{disk: {{radius: {R} m}}}}
  load: {{particle: {{mass: {m} kg}}}}
connections:
  axle: {{pin: [ground.O, drum]}}
  rope: {{string: {{path: [wound on drum at left, under block, ground.O]}}}}
  hook: {{string: {{from: block, to: load}}}}
loads: {{weight: {{gravity: {G} m/s^2}}, motor: {{torque: {{on: drum, magnitude: {T} N m}}}}}}
measures: {{y: {{height of load}}}}
"""
    return Case(
        model, {"acceleration of y": a, "tension of hook": m * (G + a), "tension of rope at drum": m * (G + a) / 2}
    )


def tackle(rng: random.Random) -> Case:
    """A counterweight over a fixed pulley and under a movable one: 2 y + x stays, (m1 + 4 m2) y'' = (m1 - 2 m2) g."""
    m1, m2, R = _decimal(rng, 1, 20), _decimal(rng, 0.5, 9), _radius(rng)
    a = (m1 - 2 * m2) * G / (m1 + 4 * m2)
    model = f"""
bodies:
  top: {{disk: {{radius: {R} m}}}}
  block: {{disk: {{radius: {R} m}}}}
  load: {{particle: {{mass: {m1} kg}}}}
  weight: {{particle: {{mass: {m2} kg}}}}
connections:
  axle: {{pin: [ground.O, top]}}
  rope: {{string: {{path: [weight, over top, under block, ground.A]}}}}
  hook: {{string: {{from: block, to: load}}}}
ground: {{points: {{O: [0, 0], A: [{4 * R} m, 0]}}}}
loads: {{gravity: {{gravity: {G} m/s^2}}}}
measures: {{y: {{drop of load below ground.O}}, x: {{drop of weight below ground.O}}}}
"""
    expected: Found = {
        "acceleration of y": a,
        "acceleration of x": -2 * a,
        "tension of rope at weight": m2 * (G + 2 * a),
        "tension of hook": m1 * (G - a),
    }
    return Case(model, expected)


def rolling(rng: random.Random) -> Case:
    """A round body of inertia c m R^2 rolls down: s'' = g sin(alpha)/(1 + c), friction c/(1 + c) m g sin(alpha)."""
    name, c = rng.choice([("disk", 0.5), ("ring", 1.0), ("ball", 0.4), ("body", 0.7)])
    m, R, alpha, d = _decimal(rng, 0.2, 9), _radius(rng), rng.choice([15, 25, 30, 37.5, 52]), _decimal(rng, 0.5, 4)
    v = rng.choice([0.0, _decimal(rng, 0.1, 3)])
    a = G * math.sin(math.radians(alpha)) / (1 + c)
    inertia = f"inertia: {c * m * R * R!r} kg m^2"
    shape = "disk" if name == "disk" else "body"
    model = f"""
ground: {{lines: {{incline: {{along: -{alpha} deg}}}}}}
bodies: {{r: {{{shape}: {{mass: {m} kg, radius: {R} m{"" if name == "disk" else ", " + inertia}}}}}}}
connections: {{contact: {{rolling: {{body: r, on: incline}}}}}}
loads: {{weight: {{gravity: {G} m/s^2}}}}
measures: {{s: {{travel of r along incline}}}}
start: {{s: 0, rate(s): {v} m/s}}
"""
    t = (-v + math.sqrt(v * v + 2 * a * d)) / a
    expected: Found = {
        "acceleration of s": a,
        "normal force of contact": m * G * math.cos(math.radians(alpha)),
        "angular acceleration of r": -a / R,
        f"time when s = {d} m": t,
        f"velocity of s when s = {d} m": v + a * t,
    }
    return Case(model, expected)


def yo_yo(rng: random.Random) -> Case:
    """A body unwinds from a string that is wound on it: y'' = g/(1 + I/(m r^2)) down."""
    m, r, k = _decimal(rng, 0.05, 2), _radius(rng), _decimal(rng, 0.02, 0.5)
    inertia = m * k * k
    a = G / (1 + k * k / (r * r))
    model = f"""
bodies: {{y: {{body: {{mass: {m} kg, inertia: {inertia!r} kg m^2, radius: {r} m}}}}}}
connections: {{cord: {{string: {{path: [wound on y at left, ground.O]}}}}}}
loads: {{weight: {{gravity: {G} m/s^2}}}}
measures: {{h: {{drop of y below ground.O}}}}
"""
    return Case(model, {"acceleration of h": a, "tension of cord": m * (G - a)})


def _chain(m: list[float], L: list[float], angles: list[float]) -> tuple[np.ndarray, np.ndarray]:
    """Mass matrix and forces at rest of point masses on massless rods, in absolute angles."""
    n = len(m)
    below = [sum(m[k:]) for k in range(n)]
    M = np.array(
        [[below[max(i, j)] * L[i] * L[j] * math.cos(angles[i] - angles[j]) for j in range(n)] for i in range(n)]
    )
    return M, np.array([-below[i] * G * L[i] * math.sin(angles[i]) for i in range(n)])


def _chain_model(m: list[float], L: list[float], degrees: list[float]) -> str:
    names = [f"p{k}" for k in range(len(m))]
    before = ["ground.O", *names]
    bodies = ", ".join(f"{b}: {{particle: {{mass: {mass} kg}}}}" for b, mass in zip(names, m, strict=True))
    rods = ", ".join(f"r{k}: {{link: [{before[k]}, {b}, {L[k]} m]}}" for k, b in enumerate(names))
    measures = ", ".join(f"t{k}: {{angle of line from {before[k]} to {b} from down}}" for k, b in enumerate(names))
    start = ", ".join(f"t{k}: {d} deg, rate(t{k}): 0" for k, d in enumerate(degrees))
    return f"""
bodies: {{{bodies}}}
connections: {{{rods}}}
loads: {{weight: {{gravity: {G} m/s^2}}}}
measures: {{{measures}}}
start: {{{start}}}
"""


def chain_let_go(rng: random.Random) -> Case:
    """Accelerations of a chain of pendulums at rest, by M a = F."""
    n = rng.choice([1, 2, 2, 3])
    m, L = ([_decimal(rng, 0.2, 5) for _ in range(n)] for _ in range(2))
    degrees = [float(rng.choice([-70, -40, -15, 10, 30, 55, 80])) for _ in range(n)]
    M, F = _chain(m, L, [math.radians(d) for d in degrees])
    found = np.linalg.solve(M, F)
    return Case(_chain_model(m, L, degrees), {f"acceleration of t{k} at start": float(a) for k, a in enumerate(found)})


def _frequencies(M: np.ndarray, K: np.ndarray) -> list[float]:
    return sorted(float(math.sqrt(s)) for s in np.linalg.eigvals(np.linalg.solve(M, K)).real)


def chain_swinging(rng: random.Random) -> Case:
    """Natural frequencies of a hanging chain: K = diag(sum of the masses below g L)."""
    n = rng.choice([1, 2, 2, 3])
    m, L = ([_decimal(rng, 0.2, 5) for _ in range(n)] for _ in range(2))
    M, _F = _chain(m, L, [0.0] * n)
    K = np.diag([sum(m[k:]) * G * L[k] for k in range(n)])
    return Case(_chain_model(m, L, [0.0] * n), {"natural frequencies": _frequencies(M, K)})


def springs(rng: random.Random) -> Case:
    """Masses on a rail, any two of them and each and the wall joined by springs: M x'' + K x = 0."""
    n = rng.choice([1, 2, 2, 3])
    m = [_decimal(rng, 0.2, 5) for _ in range(n)]
    K = np.zeros((n, n))
    loads: list[str] = []
    stiffnesses: list[float] = []

    def spring(i: int, stretch: str, measure: str) -> float:
        k = _decimal(rng, 20, 400)
        stiffnesses.append(k)
        loads.append(f"s{len(stiffnesses)}: {{law: {{measure: {measure}, force: -k{len(stiffnesses)}*({stretch})}}}}")
        K[i, i] += k
        return k

    for i in range(n):
        for j in range(i):
            if j == i - 1 or rng.random() < 0.4:
                k = spring(i, f"x{i} - x{j}", f"{{expression: x{i} - x{j}}}")
                K[j, j] += k
                K[i, j] -= k
                K[j, i] -= k
        if i == 0 or rng.random() < 0.4:
            spring(i, f"x{i}", f"x{i}")
    parameters = ", ".join(f"k{number}: {k} N/m" for number, k in enumerate(stiffnesses, 1))
    bodies = ", ".join(f"b{i}: {{particle: {{mass: {mass} kg}}}}" for i, mass in enumerate(m))
    rails = ", ".join(f"c{i}: {{slider: {{body: b{i}, along: right}}}}" for i in range(n))
    measures = ", ".join(f"x{i}: {{x of b{i}}}" for i in range(n))
    start = ", ".join(f"x{i}: 0" for i in range(n))
    model = f"""
parameters: {{{parameters}}}
bodies: {{{bodies}}}
connections: {{{rails}}}
measures: {{{measures}}}
loads: {{{", ".join(loads)}}}
start: {{{start}}}
"""
    return Case(model, {"natural frequencies": _frequencies(np.diag(m), K)})


def truss(rng: random.Random) -> Case:
    """A simple truss: each joint is held by bars to two earlier ones. Method of joints: the pulls of the bars on every
    joint balance its load."""
    n = rng.choice([1, 2, 2, 3])
    width = _decimal(rng, 0.8, 3)
    places = {"ground.A": (0.0, 0.0), "ground.B": (0.0, width)}
    bars: list[tuple[str, str]] = []
    for k in range(n):
        ends = list(places)[-2:]
        x, y = _decimal(rng, 0.8, 1.6) * (k + 1), _decimal(rng, 0.1, 0.9) * width
        places[f"j{k}"] = (float(f"{x:.4g}"), float(f"{y:.4g}"))
        bars += [(end, f"j{k}") for end in ends]
    forces = [(float(rng.randint(-900, 900)), float(rng.randint(-900, 900))) for _ in range(n)]
    A, b = np.zeros((2 * n, 2 * n)), np.zeros(2 * n)
    for column, ends in enumerate(bars):
        for end, other in (ends, ends[::-1]):
            if end.startswith("j"):
                d = np.subtract(places[other], places[end])
                A[2 * int(end[1:]) : 2 * int(end[1:]) + 2, column] += d / np.linalg.norm(d)
    for k, force in enumerate(forces):
        b[2 * k : 2 * k + 2] = -np.array(force)
    pulls = np.linalg.solve(A, b)
    bodies = ", ".join(
        f"{name}: {{particle: {{mass: 1 kg}}, at: [{x} m, {y} m]}}"
        for name, (x, y) in places.items()
        if name.startswith("j")
    )
    links = ", ".join(f"bar{k}: {{link: [{one}, {other}]}}" for k, (one, other) in enumerate(bars))
    loads = ", ".join(
        f"f{k}{axis}: {{force: {{at: j{k}, along: {along}, magnitude: {value} N}}}}"
        for k, force in enumerate(forces)
        for axis, along, value in zip("xy", ("right", "up"), force, strict=True)
        if value
    )
    model = f"""
ground: {{points: {{A: [0, 0], B: [0, {width} m]}}}}
bodies: {{{bodies}}}
connections: {{{links}}}
loads: {{{loads}}}
"""
    return Case(model, {f"tension of bar{k}": float(pull) for k, pull in enumerate(pulls)})


FAMILIES: list[tuple[Callable[[random.Random], Case], int, int]] = [
    # family, draws in the normal suite, further ones in the slow run
    (atwood, 6, 34),
    (compound_atwood, 5, 30),
    (winch, 5, 25),
    (tackle, 5, 25),
    (rolling, 7, 43),
    (yo_yo, 5, 25),
    (chain_let_go, 6, 30),
    (chain_swinging, 6, 24),
    (springs, 7, 33),
    (truss, 6, 24),
]


def examined(case: Case, tally: Tally) -> None:
    """Counts the answers of a model, and notes which are refused or wrong."""
    system = fb.System.from_text("freebody: 1\n" + case.model)
    lines = "".join(f"- {{id: q{k}, find: '{find}'}}\n" for k, find in enumerate(case.expected))
    solution = fb.System.from_text(f"freebody: 1\n{case.model}questions:\n{lines}").solve()
    assert system.has_values
    would_push = "string:" in case.model and any(
        question.startswith("tension") and wanted < 0 for question, wanted in case.expected.items()
    )
    for answer, (question, wanted) in zip(solution.answers, case.expected.items(), strict=True):
        if would_push:  # a string goes slack: the formula must not be given out as the truth
            assert answer.value is None, question
            assert any("Not valid for the given numbers" in str(note) for note in answer.notes), question
            continue
        if answer.value is None:
            tally.refused.append(f"{question}: {answer.reason}")
            continue
        tally.closed += answer.expression is not None
        tally.numbers += answer.expression is None
        found = list(answer.value) if isinstance(answer.value, tuple) else [answer.value]
        right = wanted if isinstance(wanted, list) else [wanted]
        scale = max(*(abs(x) for x in right), 1e-6)
        if len(found) != len(right) or any(abs(x - y) > DIGITS * scale for x, y in zip(found, right, strict=False)):
            tally.wrong.append(f"{question}: {found} instead of {right} of {case.model}")


def _checked(family: Callable[[random.Random], Case], numbers: range) -> Tally:
    tally = Tally()
    for k in numbers:
        case = family(random.Random(f"{SEED} {family.__name__} {k}"))
        examined(case, tally)
    print(f"seed {SEED}: {tally.closed} closed forms, {tally.numbers} numbers, {len(tally.refused)} refused")
    return tally


@pytest.mark.parametrize(("family", "few"), [(family, few) for family, few, _many in FAMILIES])
def test_random_members_of_a_family_agree_with_the_textbook(family: Callable[[random.Random], Case], few: int) -> None:
    tally = _checked(family, range(few))
    assert not tally.wrong
    assert not tally.refused


@pytest.mark.slow
@pytest.mark.parametrize(("family", "few", "many"), FAMILIES)
def test_many_members_of_a_family_agree_with_the_textbook(
    family: Callable[[random.Random], Case], few: int, many: int
) -> None:
    tally = _checked(family, range(few, few + many))
    assert not tally.wrong
    assert not tally.refused
