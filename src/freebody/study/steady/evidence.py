"""The second opinion on steady motion: poses and rates in numbers, on the numeric route."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import partial

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import CrossCheck, NotReal, as_parts, element_at
from freebody.study.answering.draws import SEED, Draw
from freebody.study.answering.magnitude import magnitude
from freebody.study.setup import SAME_PLACE, Setup, places_of_bodies
from freebody.study.steady.motion import Solutions, SteadyMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate
from freebody.tolerances import ROUND_OFF

_RATES = (1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0)  # rad/s, m/s: slow ones first
_OF_SQUARES = 1e-4  # of the square of the largest rate: an acceleration of that size counts
_TOLERANCE = 1e-7  # relative, of accelerations: rates that formulas give are solved for, with condition numbers to 1e6


def in_steady_motion(setup: Setup, question: str, steady: SteadyMotion, solutions: Solutions) -> Evidence:
    """With the claimed rates, at a general pose, no coordinate may accelerate."""
    witness = CrossCheck(
        question, Message("accelerations of the full system at random poses with these rates"), _TOLERANCE
    )

    def compare(seen: tuple[Draw, dict[int, Snapshot]]) -> None:
        draw, found = seen
        gaps = [unevenness(steady, draw, snapshot) for snapshot in found.values()]
        witness.compare(draw, (1.0,) * len(gaps), tuple(1.0 + gap for gap in gaps))

    return witness.gather(motions(setup, steady, solutions), compare).evidence()


def during_steady_motion(
    setup: Setup,
    question: str,
    steady: SteadyMotion,
    solutions: Solutions | None,
    quantity: Quantity,
    by_root: Sequence[tuple[Ratio, ...]],
) -> Evidence:
    """The quantity in steady motions of the full system. by_root: its elements for each root, or for all alike."""
    witness = CrossCheck(
        question, Message("floating-point solve of all bodies and constraints in steady motion"), _TOLERANCE
    )
    measure, order = quantity.watched or (None, 1)
    is_angle = measure is not None and order == 0 and measure.is_angle
    for draw, found in motions(setup, steady, solutions):
        pairs: list[tuple[tuple[float, ...], tuple[float, ...], Snapshot]] = []
        for k, snapshot in found.items():
            if unevenness(steady, draw, snapshot) > _TOLERANCE:
                raise CannotAnswer(Message("the steady motion by which the answer would be checked is none in numbers"))
            try:
                numeric = quantity.value(setup.system, draw.seen(snapshot))
            except CannotAnswer:
                if len(found) == 1:
                    raise
                continue  # a measure may have no slope at one of several places: the others are compared
            exact = element_at(setup, by_root[min(k, len(by_root) - 1)], draw, snapshot)
            pairs.append((exact, as_parts(numeric), draw.seen(snapshot)))
        if is_angle and pairs:  # side by side: an arc of nearly one has half of the digits only
            sides = tuple(x for exact, _n, _s in pairs for x in exact), tuple(x for _e, n, _s in pairs for x in n)
            witness.compare(draw, *sides)
            continue
        for exact, numeric, seen in pairs:
            witness.compare(draw, exact, numeric, partial(magnitude, quantity.dimension, seen))
    return witness.evidence()


def motions(
    setup: Setup, steady: SteadyMotion, solutions: Solutions | None
) -> Iterator[tuple[Draw, dict[int, Snapshot]]]:
    """Steady motions, one for each root, at the draws at which there are some: first those with all roots, then, where
    there is one of these, those with some, as beside a drive that is too slow for one of the places."""
    fewer: list[tuple[Draw, dict[int, Snapshot]]] = []
    n_all = 1 if solutions is None else len(solutions.roots)
    has_all = False
    for k, draw in enumerate(setup.draw_stream()):
        found = _motion(setup, steady, solutions, draw, k)
        if len(found) == n_all:
            has_all = True
            yield draw, found
        elif found:
            fewer.append((draw, found))
    if has_all:
        yield from fewer


def _motion(setup: Setup, steady: SteadyMotion, solutions: Solutions | None, draw: Draw, k: int) -> dict[int, Snapshot]:
    """Rates at random, larger and larger until there is a steady motion with them."""
    rng = np.random.default_rng(SEED + k)
    q = general_pose(setup, draw, k)
    given = {g: element_at(setup, (x,), draw, draw.start())[0] for g, x in steady.given.items()}
    for c in steady.others:
        if c.index in given:
            q = placed(steady, draw, q, c, given[c.index])
    found: dict[int, Snapshot] = {}
    for size in _RATES if steady.cyclic else _RATES[:1]:
        for _ in range(2 if steady.cyclic else 1):
            rates = {c.speed: size * float(rng.uniform(0.5, 1.5)) for c in steady.cyclic} | given
            with suppress(CannotAnswer):
                found = _with_roots(setup, steady, solutions, draw, q, rates)
                if solutions is None or len(found) == len(solutions.roots):
                    return found
    return found


def _with_roots(
    setup: Setup, steady: SteadyMotion, solutions: Solutions | None, draw: Draw, q: Array, rates: dict[int, float]
) -> dict[int, Snapshot]:
    """By the roots that are real."""
    first = moving(steady, draw, q, rates)
    if solutions is None:
        return {0: first}
    found: dict[int, Snapshot] = {}
    for k, x in enumerate(solutions.roots):
        _insist_divisor(setup, x, draw, first)
        try:
            (value,) = element_at(setup, (x,), draw, first)
        except NotReal:
            continue
        more = {s: element_at(setup, (y,), draw, first)[0] for s, y in solutions.with_them.items()}
        values, there = more | {solutions.index: value}, q
        for c in steady.others:
            if c.index in values:
                there = placed(steady, draw, there, c, values.pop(c.index))
        there = _by_formulas(setup, draw, q, {solutions.index: x, **solutions.with_them}, there)
        found[k] = moving(steady, draw, there, rates | values)
    return found


def _insist_divisor(setup: Setup, x: Ratio, draw: Draw, snapshot: Snapshot) -> None:
    """Raises NotReal where a divisor is zero but for round-off, as the cosine of a right angle is."""
    numbers = setup.model.samples.numbers(draw.sample(snapshot), draw.sample())
    value, size = x.field.numerator_and_size(x.denominator(), numbers)
    if abs(value) <= ROUND_OFF * size:
        raise NotReal(Message("a divisor vanishes there"))


def _by_formulas(setup: Setup, draw: Draw, q: Array, values: dict[int, Ratio], there: Array) -> Array:
    """A pose with what the formulas say of the places of all bodies, where the way to it led over one in which the
    parts could be assembled otherwise: a sleeve stays at the hinge when the arms have passed it."""
    here, found = (draw.reference.snapshot(x, np.zeros_like(x)) for x in (q, there))
    places: list[tuple[Measure, float]] = []
    for measure in places_of_bodies(setup.model):
        x = setup.model.value_of(measure)
        exact = element_at(setup, (x.field.lowest_terms(x.field.follow(x, values)),), draw, here)[0]
        places.append((measure, exact))
    size = draw.reference.sizes.length
    if all(abs(found.value(measure) - exact) <= SAME_PLACE * size for measure, exact in places):
        return there
    return draw.reference.pose_near(q, places)


def placed(steady: SteadyMotion, draw: Draw, q: Array, place: Coordinate, value: float) -> Array:
    measure = steady.model.measure_of(place)
    if measure is None:
        raise NotReal(Message("{place} is no measure", place=place.name))
    kept = [(m, v) for c, m, v in _places(steady, draw, q) if c is not place]
    return draw.reference.pose_near(q, [*kept, (measure, value)])


def _places(steady: SteadyMotion, draw: Draw, q: Array) -> list[tuple[Coordinate, Measure, float]]:
    """The coordinates that are measures, with their values at a pose."""
    here = draw.reference.snapshot(q, np.zeros_like(q))
    measures = [(c, steady.model.measure_of(c)) for c in steady.model.coordinates]
    return [(c, m, here.value(m)) for c, m in measures if m is not None]


def general_pose(setup: Setup, draw: Draw, k: int) -> Array:
    """Near the start, on the branch of the formulas."""
    for size in (0.3, 0.1, 0.03):
        snapshot = draw.anywhere(SEED + k, 0.0, size)
        if setup.is_on_branch(draw, snapshot):
            return snapshot.q
    return draw.q


def moving(steady: SteadyMotion, draw: Draw, q: Array, rates: dict[int, float]) -> Snapshot:
    """Cyclic coordinates with given rates, the others at rest."""
    wanted: list[tuple[Measure | NonholonomicForm, float]] = []
    for c in steady.model.coordinates:
        seen = steady.model.form_of(c)
        if seen is None and c in steady.cyclic:
            raise CannotAnswer(Message("{x} is no measure of the model, so its rate cannot be checked", x=c.name))
        if seen is not None:
            wanted.append((seen, rates.get(c.speed, 0.0)))
    return draw.reference.snapshot(q, draw.reference.velocities(q, wanted, with_start=False))


def coordinate_accelerations(steady: SteadyMotion, draw: Draw, snapshot: Snapshot) -> Array:
    """Of the coordinates that are measures, or turns of balls, by the engine."""
    seen = draw.seen(snapshot)
    forms = [steady.model.form_of(c) for c in steady.model.coordinates]
    return np.array([seen.acceleration(form) for form in forms if form is not None])


def unevenness(steady: SteadyMotion, draw: Draw, snapshot: Snapshot) -> float:
    """The largest acceleration, beside what the coordinate has at rest there and with these rates doubled, and beside
    the squares of the rates, whose round-off it has where it vanishes at any rate."""
    here = coordinate_accelerations(steady, draw, snapshot)
    others = [
        coordinate_accelerations(steady, draw, draw.reference.snapshot(snapshot.q, factor * snapshot.v))
        for factor in (0.0, 2.0)
    ]
    sizes = np.maximum(np.abs(others[0]), np.abs(others[1]))
    least = max(1.0, _OF_SQUARES * float(np.abs(snapshot.v).max(initial=0.0)) ** 2)
    return float(np.max(np.abs(here) / np.maximum(sizes, least), initial=0.0))
