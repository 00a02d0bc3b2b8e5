"""For which parameters there is a steady motion in a place: where a rate with which it is steady is real.

A top that leans by beta precesses steadily where C^2 w^2 >= 4 m g l (A - C) cos(beta).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import product

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.formula import Formula
from freebody.study.setup import Setup
from freebody.study.steady.evidence import coordinate_accelerations, moving, placed
from freebody.study.steady.motion import Solutions, SteadyMotion, is_quarter
from freebody.study.steady.values import range_of
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate
from freebody.tolerances import ROUND_OFF

_OPPOSITE = {">": ">=", ">=": ">"}  # of the negative element
_SHARES = (0.003, 0.1, 0.3, 0.5, 0.7, 0.9, 0.997)  # of a quarter turn
_SAME = 1e-6  # of its largest term: what a root leaves of another equation


def existence(setup: Setup, question: Question, parameter: str, *, is_so: bool) -> list[Formula]:
    """Where one of the rates is real and everything holds, or where none is: in the place that an event states, else in
    that of the start, with the other rates of the start. Raises CannotAnswer where the rate has no closed form."""
    m, f = setup.model, setup.model.field
    steady = SteadyMotion.asked(m, question.event)
    if not steady.cyclic and question.event is None and (of_place := _of_place(setup, steady, is_so=is_so)):
        return of_place
    steady.given = {**{c.index: setup.start.of(c.index) for c in steady.others if not steady.given}, **steady.given}
    if not any(c.index in steady.given for c in steady.others):
        raise CannotAnswer(Message("say where: the steady motion exists when {x} = ...", x=steady.others[0].name))
    solutions = _rate(setup, steady, parameter)
    start = {c.speed: setup.start.of(c.speed) for c in steady.cyclic if c.speed != solutions.index}
    needed = setup.holding(steady.state) + setup.clearances(steady.state, ">=")

    def at(x: Ratio, root: Ratio) -> Ratio:
        return f.lowest_terms(f.follow(steady.put_in(x), {**solutions.with_them, solutions.index: root, **start}))

    ways: list[list[Condition]] = []
    for x in solutions.roots:
        root = f.lowest_terms(f.follow(x, start))
        roots = [c for c in real(root) if c.relation in _OPPOSITE]
        ways.append([*roots, *(replace(c, element=at(c.element, root)) for c in needed if c.relation in _OPPOSITE)])

    return _one_of(ways, _in_numbers(setup, steady, solutions.index, is_so=is_so), is_so=is_so)


def _one_of(
    ways: Sequence[Sequence[Condition]], seen: Callable[[dict[str, float]], float], *, is_so: bool
) -> list[Formula]:
    """Where one of the ways is open, and where none is."""

    def no_formula() -> Evidence:
        raise CannotAnswer(Message("whether there is such a steady motion was not compared with the numeric route"))

    there = [Formula(Fraction(1), way, no_formula, seen, says=is_so) for way in ways]
    none = product(*([_opposite(c) for c in way] for way in ways))
    return [*there, *(Formula(Fraction(1), each, no_formula, seen, says=not is_so) for each in none)]


def _of_place(setup: Setup, steady: SteadyMotion, *, is_so: bool) -> list[Formula]:
    """Beside a drive: where there is a place on the way of the one angle that is not so whatever the parameters are, as
    hanging down is. Nothing where the place is no such angle or has no closed form."""
    f = setup.model.field
    inside = frozenset[int]().union(*(f.ingredients(x) for x in steady.equations))
    places = [c for c in steady.others if c.index in inside]
    measure = steady.model.measure_of(places[0]) if len(places) == 1 else None
    if len(steady.equations) != 1 or measure is None or not measure.is_angle:
        return []
    try:
        found = steady.at_position(places[0])
    except CannotAnswer:
        return []
    needed = setup.holding(steady.state) + setup.clearances(steady.state, ">=")
    ways: list[list[Condition]] = []
    for x in (x for x in found.roots if not is_quarter(x)):
        way = [*range_of(x, Message("there is such a motion")), *real(x)]
        held = (
            replace(c, element=f.lowest_terms(f.follow(steady.put_in(c.element), {found.index: x}))) for c in needed
        )
        ways.append([c for c in (*way, *held) if c.relation in _OPPOSITE])
    if not ways or not all(ways):
        return []
    return _one_of(ways, _places_in_numbers(setup, steady, places[0], is_so=is_so), is_so=is_so)


def left_out(setup: Setup, question: Question) -> list[str]:
    """A note on the places that are not meant where none is named."""
    if question.event is not None or SteadyMotion(setup.model).cyclic:
        return []
    return [Message("places that are steady whatever the parameters are, as hanging down, are left out")]


def _places_in_numbers(
    setup: Setup, steady: SteadyMotion, place: Coordinate, *, is_so: bool
) -> Callable[[dict[str, float]], float]:
    """Whether the acceleration changes its sign on the way of an angle between two quarter turns."""

    def value(values: dict[str, float]) -> float:
        draw = setup.draws[0].with_values(values, setup.system)
        changes = False
        for quarter in range(-2, 2):
            signs = set[float]()
            for share in _SHARES:
                with suppress(CannotAnswer):
                    q = placed(steady, draw, draw.q, place, (quarter + share) * math.pi / 2)
                    signs |= set(np.sign(coordinate_accelerations(steady, draw, moving(steady, draw, q, {}))))
            changes = changes or {-1.0, 1.0} <= signs
        return float(changes == is_so)

    return value


def _opposite(c: Condition) -> Condition:
    """Where a condition does not hold."""
    return replace(c, element=-c.element, relation=_OPPOSITE[c.relation])


def _place(setup: Setup, steady: SteadyMotion) -> str:
    """What tells the place: a named measure that changes with one of the other coordinates, or that coordinate."""
    f, others = setup.model.field, {c.index for c in steady.others}
    values = ((name, f.element(setup.state.value(m))) for name, m in setup.system.measures.items())
    return next((name for name, x in values if f.ingredients(x) & others), steady.others[0].name)


def _rate(setup: Setup, steady: SteadyMotion, parameter: str) -> Solutions:
    """Of the rates that the conditions contain one that neither the event gives nor, by the parameter that is asked
    for, the start: the one that is zero there, if there is such a one."""
    f = setup.model.field
    inside = frozenset[int]().union(*(f.ingredients(x) for x in steady.equations))
    index = f.index(setup.model.geometry.scalar(Symbol(parameter)))
    free = [c for c in steady.cyclic if c.speed in inside and c.speed not in steady.given]
    free = [c for c in free if index not in f.ingredients(setup.start.of(c.speed))]
    free.sort(key=lambda c: not setup.start.of(c.speed).is_zero())
    if not steady.cyclic and steady.others:
        told = Message(
            "beside a drive no rate is open, and the place is what makes the motion steady: ask for {x} in steady "
            "motion, whose conditions say where there is one, or for the value of {name} for which {x} = ... in steady "
            "motion",
            x=_place(setup, steady),
            name=parameter,
        )
        raise CannotAnswer(told)
    if not free:
        raise CannotAnswer(Message("the start gives all rates, so that none is left to make the motion steady"))
    return steady.solved_for(free[0].speed)


def _in_numbers(setup: Setup, steady: SteadyMotion, index: int, *, is_so: bool) -> Callable[[dict[str, float]], float]:
    """Whether some rate makes all accelerations vanish, which are quadratic in it."""

    def value(values: dict[str, float]) -> float:
        draw = setup.draws[0].with_values(values, setup.system)
        start = draw.start()

        def number(x: Ratio) -> float:
            return element_at(setup, (x,), draw, start)[0]

        q = draw.q
        for c in steady.others:
            if c.index in steady.given:
                q = placed(steady, draw, q, c, number(steady.given[c.index]))
        rates = {c.speed: number(setup.start.of(c.speed)) for c in steady.cyclic}
        rates |= {c.speed: number(steady.given[c.speed]) for c in steady.cyclic if c.speed in steady.given}

        def accelerations(rate: float) -> Array:
            return coordinate_accelerations(steady, draw, moving(steady, draw, q, rates | {index: rate}))

        size = max(1.0, *(abs(x) for x in rates.values()))
        back, here, ahead = (accelerations(k * size) for k in (-1.0, 0.0, 1.0))
        rows = np.transpose([(ahead + back) / 2 - here, (ahead - back) / 2, here])
        return float(_has_common_root(rows) == is_so)

    return value


def _has_common_root(rows: Array) -> bool:
    """Whether a x^2 + b x + c = 0 has a real root that is one of all rows."""
    sizes = [float(np.abs(row).max(initial=0.0)) for row in rows]
    least = ROUND_OFF * max(*sizes, 1.0)
    wanted = [np.where(np.abs(row) < least, 0.0, row) for row, size in zip(rows, sizes, strict=True) if size > least]
    if not wanted:
        return True
    roots = np.roots(wanted[0])
    there = roots.real[np.abs(roots.imag) <= ROUND_OFF * np.maximum(1.0, np.abs(roots))]

    def vanishes(row: Array, x: float) -> bool:
        return abs(float(np.polyval(row, x))) <= _SAME * float(np.abs(row * x ** np.arange(2, -1, -1)).max())

    return any(all(vanishes(row, x) for row in wanted) for x in there)
