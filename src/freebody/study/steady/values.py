"""The value of a quantity in a steady motion, or during one, in closed form."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message, further
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.model.elements import Parameter
from freebody.questions.reading import Question
from freebody.questions.steady import SteadyValue, is_steady_place
from freebody.study.answering.finding import Finding
from freebody.study.answering.solved_in_numbers import Side, solved_in_numbers
from freebody.study.setup import Setup
from freebody.study.steady.evidence import during_steady_motion, in_steady_motion
from freebody.study.steady.motion import Solutions, SteadyMotion, rate_among, unknown_of
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reduced import odd_part, without_square_roots
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.tolerances import ROUND_OFF

_THERE_IS = Message("there is such a motion")


def steady_value(setup: Setup, question: Question, q: SteadyValue) -> Finding:
    """A rate or a place by the conditions of steady motion, or any other quantity during one."""
    steady = SteadyMotion.asked(setup.model, question.event)
    unknown = unknown_of(steady, q)
    if unknown is None:
        return _during(setup, question, q, steady)
    is_place = is_steady_place(q)
    solutions = _places(setup, question, steady, unknown) if is_place else steady.solved_for(unknown.speed)
    if not solutions.roots:
        raise CannotAnswer(further(*solutions.notes) or Message("there is no such motion"))
    evidence = in_steady_motion(setup, question.text, steady, solutions)
    always = [compared(ZERO, "=", tidy(x)) for x in steady.always]
    notes = solutions.notes + [
        reworded(Message("every rate is steady where {zero}", zero=zero), zero) for zero in always
    ]
    roots = tuple(_at_start(setup, question, x, solutions) for x in solutions.roots)
    needed = setup.holding(steady.state) + setup.clearances(steady.state, ">=")
    conditions = [replace(c, element=steady.put_in(c.element)) for c in needed]
    element = roots[0] if len(roots) == 1 else roots
    return Finding(element, evidence, conditions, notes=notes, of_root=_ranges(roots))


def _places(setup: Setup, question: Question, steady: SteadyMotion, c: Coordinate) -> Solutions:
    """The values of a coordinate in closed form. Where there is none, those at the model's own numbers, with a proof of
    how many there are, come with the reason."""
    try:
        return steady.at_position(c)
    except CannotAnswer as error:
        if question.at_start or not setup.has_values or len(steady.equations) != 1:
            raise
        f, equation = setup.model.field, steady.equations[0]
        sides = [Side(base, ()) for base, _n in f.factor(equation.num)[1] if c.index in f.ingredients(base)]
        is_angle = f.pair_of(c.index) is not None
        start = setup.model.samples.start_numbers(c.index)
        dimension = DIMENSIONLESS if is_angle else LENGTH
        place = Parameter(c.name, dimension, start[0] if start else None, "any", is_angle=is_angle)
        found = solved_in_numbers(setup, place, c.index, sides)
        if found is None:
            raise
        raise found.told(str(error), "rad" if is_angle else question.quantity.unit) from None


def _at_start(setup: Setup, question: Question, x: Ratio, solutions: Solutions | None) -> Ratio:
    if not question.at_start:
        return x
    given = setup.start.values
    return setup.model.field.follow(x, {k: v for k, v in given.items() if solutions is None or k != solutions.index})


def _ranges(roots: Sequence[Ratio]) -> list[list[Condition]]:
    """What each of the values needs to be one."""
    purposes = [_THERE_IS] if len(roots) == 1 else [Message("for [{k}]", k=k + 1) for k in range(len(roots))]
    return [range_of(x, purpose) for x, purpose in zip(roots, purposes, strict=True)]


def range_of(x: Ratio, purpose: str) -> list[Condition]:
    """-1 <= u <= 1 for the arcs in an answer."""
    f, found = x.field, list[Condition]()
    for index in sorted(x.generators()):
        name, argument = f.arguments.get(index, ("", x))
        if name in ("acos", "asin"):
            rooms = (odd_part(1 - argument), odd_part(1 + argument))
            none = CannotAnswer(Message("there is no such motion for any admissible values"))
            found += insisted((Condition(room, ">=", purpose) for room in rooms), none)
    return found


def _during(setup: Setup, question: Question, q: SteadyValue, steady: SteadyMotion) -> Finding:
    """Another quantity: by what stays open, or, where what is given determines the motion, by the parameters alone."""
    f, solutions = setup.model.field, steady.eliminated(even_if_open=is_steady_place(q))
    among = None if solutions is not None or steady.given else rate_among(steady, q.of.inner)
    if among is not None:
        solutions = steady.solved_for(among.speed)
    value = q.of.value(setup.system, steady.state)
    parts = cast("tuple[Any, ...]", value if isinstance(value, tuple) else (value,))
    elements = tuple(steady.put_in(without_square_roots(setup.model, f.lowest_terms(f.element(v)))) for v in parts)
    roots = [] if solutions is None else solutions.roots
    if not roots or (len(roots) > 1 and len(parts) > 1):
        solutions, by_root = None, [elements]
    else:
        assert solutions is not None
        found = [{solutions.index: x, **solutions.with_them} for x in roots]
        by_root = [tuple(f.lowest_terms(f.follow(x, values)) for x in elements) for values in found]
    texts = [] if solutions is not None else steady.texts()
    motion = solutions or (steady.any_solution() if steady.equations else None)
    evidence = during_steady_motion(setup, question.text, steady, motion, q.of, by_root)
    notes = [] if solutions is None else solutions.notes if not steady.given else []
    notes = notes if texts or solutions is not None else [Message("every such motion is steady")]
    says: list[str] = [Message("steady while {conditions}", conditions=further(*texts))] if texts else []
    needed = setup.holding(steady.state) + setup.clearances(steady.state, ">=")
    ranges = _ranges(roots) if solutions is not None else []
    held = [replace(c, element=_with(steady, solutions, c.element)) for c in needed]
    shown = tuple(_at_start(setup, question, x, None) for xs in by_root for x in xs)
    has_value = (
        among is not None
        or all(_is_given(setup, x) for x in shown)
        or (not steady.given and _starts_steadily(setup, steady))
    )
    if not has_value and setup.has_values:
        notes.append(Message("no value: the given start is not in steady motion"))
    element = shown[0] if len(shown) == 1 and not isinstance(value, tuple) else shown
    return Finding(element, evidence, held, notes=notes, says=says, has_value=has_value, of_root=ranges)


def _with(steady: SteadyMotion, solutions: Solutions | None, x: Ratio) -> Ratio:
    """An element of a condition with what is given, and with what follows from it where that is one value."""
    x = steady.put_in(x)
    if solutions is None or len(solutions.roots) > 1:
        return x
    return x.field.lowest_terms(x.field.follow(x, {solutions.index: solutions.roots[0], **solutions.with_them}))


def _is_given(setup: Setup, x: Ratio) -> bool:
    """Whether nothing stands in it that moves."""
    return not x.field.ingredients(x) & setup.model.moving


def _starts_steadily(setup: Setup, steady: SteadyMotion) -> bool:
    """Whether the start of the first draw is a steady motion: what the equations contain does not change there."""
    draw = setup.draws[0]
    snapshot = draw.start()
    numbers = setup.model.samples.numbers(draw.sample(snapshot), draw.sample())
    f = setup.model.field
    try:
        still = all(abs(float(numbers[c.speed])) < ROUND_OFF for c in steady.others)
        return still and all(_vanishes_at(f, x, numbers) for x in steady.equations)
    except (KeyError, ValueError, ArithmeticError):
        return False


def _vanishes_at(f: Field, x: Ratio, numbers: dict[int, Any]) -> bool:
    """Zero beside the sum of the sizes of its terms."""
    parts = [float(f.evaluate(f.polynomial({m: c}), numbers)) for m, c in f.terms(x.num).items()]
    return abs(sum(parts)) <= ROUND_OFF * sum(map(abs, parts))
