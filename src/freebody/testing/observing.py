"""What a model answers, in a form in which two models can be compared.

Names may differ, units may differ, the axes may be turned: `Reading` says how the second model's answers are read as
the first one's. Formulas are compared as functions, by their values at random points (Schwartz and Zippel: an identity
of elementary functions that holds at random points holds), numbers to round-off.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from freebody.api import System
from freebody.errors import FreebodyError
from freebody.language.expression import Expr, evaluate, free_symbols
from freebody.language.notation import to_python
from freebody.language.units import DIMENSIONLESS, Dimension, parse_unit
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.solution import Solution
from freebody.testing.facts import OF_THE_WHOLE, Fact, fact

ROUND_OFF = 1e-9  # relative, of numbers
_OF_MODES = 1e-7  # relative, of eigenvalues at an equilibrium that was found by iteration
_N_POINTS = 5
_OF_FORMULAS = 1e-6  # relative, of floating-point values of formulas of any length


@dataclass(frozen=True)
class Reading:
    """How the answers of a changed model are read as those of the model before.

    rename: text of the changed model to text of the old one; scale: by what a value of a dimension was multiplied;
    turned: vectors are turned by a quarter counter-clockwise; mirrored: up and down are exchanged, and with them both
    senses of turning; concerns: the questions whose answers must not change;
    freedoms: how many were added; time: by what times were multiplied; same_coordinates: formulas stand in the same
    symbols, else they are compared where they do; same_text: what is printed is the same; formulas: they are the same
    functions, else numbers in them have changed."""

    rename: Callable[[str], str] = lambda text: text
    scale: Callable[[Dimension], float] = lambda dimension: 1.0
    turned: bool = False
    mirrored: bool = False
    concerns: Callable[[Question], bool] = lambda question: True
    freedoms: int = 0
    time: float = 1.0
    same_coordinates: bool = True
    same_text: bool = False
    formulas: bool = True


@dataclass(frozen=True)
class Observed:
    """The answers of one model, or the refusal of the whole; where its measures are after a while; what other studies
    say."""

    system: System
    solution: Solution | None = None
    refusal: str = ""
    numbers: Mapping[str, tuple[Dimension, tuple[float, ...]]] = field(
        default_factory=dict[str, tuple[Dimension, tuple[float, ...]]]
    )
    facts: Mapping[str, Fact] = field(default_factory=dict[str, Fact])


def observed(system: System, *, until: float | None = None, studies: Iterable[str] = ()) -> Observed:
    """The answers of a model; with a time `until` [s], also where its named measures are then; with names of
    `facts.STUDIES`, what these say."""
    try:
        solution = system.solve()
    except FreebodyError as error:
        return Observed(system, None, str(error))
    numbers: dict[str, tuple[Dimension, tuple[float, ...]]] = {}
    if until is not None and system.has_values:
        numbers = _at(system, until)
    return Observed(system, solution, "", numbers, {study: fact(study, system) for study in studies})


def _at(system: System, until: float) -> dict[str, tuple[Dimension, tuple[float, ...]]]:
    try:
        run = system.simulate(until, tolerance=1e-12, max_seconds=20.0)
    except FreebodyError:
        return {}
    if not run.status.is_complete or not system.measures:
        return {}
    final = run.summary()["final"]["measures"]
    return {name: (measure.dimension, (float(final[name]),)) for name, measure in system.measures.items()}


def differences(before: Observed, after: Observed, reading: Reading) -> list[str]:
    """What the changed model says otherwise, one text each; empty if nothing."""
    if before.solution is None or after.solution is None:
        if (before.solution is None) == (after.solution is None):
            return []
        return [f"one is answered, the other refused: {before.refusal or after.refusal}"]
    found: list[str] = []
    first, second = before.solution, after.solution
    if first.degrees_of_freedom + reading.freedoms != second.degrees_of_freedom:
        found.append(f"{first.degrees_of_freedom} degrees of freedom, then {second.degrees_of_freedom}")
    if reading.formulas and first.phases is not None and second.phases is not None:
        n_before, n_after = len(first.phases.cases), len(second.phases.cases)
        if n_before != n_after:
            found.append(f"{n_before} cases of phases, then {n_after}")
    found += _of_coordinates(first, second) if reading.same_text else []
    if set(map(reading.rename, second.coordinates)) != set(first.coordinates):
        # of measures that a loop binds to each other others may be the coordinates under other names: what is said in
        # others is compared by its values
        reading = replace(reading, same_coordinates=False)
    asked = {q.id: q for q in before.system.questions}
    known = {a.id: a for a in second.answers}
    for answer in first.answers:
        if answer.id in known and reading.concerns(asked[answer.id]):
            found += [
                f"{answer.question}: {text}"
                for text in _between(asked[answer.id], before.system, answer, known[answer.id], reading)
            ]
    for name, (dimension, values) in before.numbers.items():
        other = {reading.rename(n): v for n, v in after.numbers.items()}.get(name)
        if other is not None:
            scaled = tuple(v * reading.scale(dimension) for v in values)
            found += [f"{name} after a while: {text}" for text in _of_numbers(scaled, other[1])]
    for study in [s for s in before.facts if s in after.facts]:
        if not (study in OF_THE_WHOLE and reading.freedoms):
            found += [f"{study}: {text}" for text in _of_facts(before.facts[study], after.facts[study], reading)]
    return found


def _of_coordinates(first: Solution, second: Solution) -> list[str]:
    """What is told otherwise of the system itself."""
    told = {
        "coordinates": (first.coordinates, second.coordinates),
        "dependent coordinates": (first.dependent, second.dependent),
        "redundant constraints": (first.redundant, second.redundant),
    }
    return [f"{what} {', '.join(a)}, then {', '.join(b)}" for what, (a, b) in told.items() if a != b]


def _of_facts(first: Fact, second: Fact, reading: Reading) -> list[str]:
    """The differences of what one study says of two models."""
    if first.words != second.words:
        return [f"{'; '.join(first.words)}, then {'; '.join(second.words)}"]
    factor = reading.scale(first.dimension)
    return _of_numbers(tuple(x * factor for x in first.numbers), second.numbers, _OF_MODES)


def _between(question: Question, system: System, first: Answer, second: Answer, reading: Reading) -> list[str]:
    """The differences of two answers to one question."""
    is_turned = reading.turned and question.quantity.scope != "small motion"  # several frequencies are no vector
    parts_1, parts_2 = _parts(first), _parts(second)
    if first.is_answered != second.is_answered:
        return [f"one is answered, the other not: {first.reason or second.reason}"]
    if (parts_1 is None) != (parts_2 is None):
        return [f"one has a closed form, the other not: {first.reason or second.reason}"]
    found: list[str] = []
    values_1, values_2 = _values(first), _values(second)
    if first.unit == "":  # parts of several dimensions: their formulas are compared, and their signs
        values_1, values_2 = (
            None if x is None else tuple(math.copysign(1.0, v) for v in x) for x in (values_1, values_2)
        )
    if values_1 is not None and values_2 is not None:
        if is_turned and len(values_2) == 2:
            values_2 = (values_2[1], -values_2[0])
        sense = _sense(question, values_2, reading)
        values_2 = tuple(s * v for s, v in zip(sense, values_2, strict=True))
        factor = reading.scale(_dimension(first.unit))
        found += _of_numbers(tuple(factor * v for v in values_1), values_2)
    elif (values_1 is None) != (values_2 is None):
        found.append("one has a value, the other not")
    if parts_1 is None or parts_2 is None or not reading.formulas:
        return found
    if reading.same_text:
        texts = [reading.rename(", ".join(map(to_python, parts))) for parts in (parts_1, parts_2)]
        if texts[0] != texts[1]:
            found.append(f"{texts[0]}, then {texts[1]}")
        if sorted(first.conditions) != sorted(map(reading.rename, second.conditions)):
            found.append(f"holds {'; '.join(first.conditions)}, then {'; '.join(second.conditions)}")
        return found
    if is_turned and len(parts_2) == 2:
        parts_2 = (parts_2[1], -parts_2[0])
    sense = _sense(question, parts_2, reading)
    parts_2 = tuple(part if s > 0 else -part for s, part in zip(sense, parts_2, strict=True))
    return found + _of_formulas(system, parts_1, parts_2, reading)


def _sense(question: Question, values: Sequence[Any], reading: Reading) -> tuple[int, ...]:
    """The signs with which the components of a mirrored answer are read: of vectors of the plane the second one, of
    what turns about the third axis the whole."""
    if not reading.mirrored:
        return (1,) * len(values)
    q = question.quantity
    if len(values) == 1:
        return (-1 if q.is_moment else 1,)
    is_vector = len(values) == 2 and q.scope != "small motion"
    return (1, -1) if is_vector else (1,) * len(values)


def _parts(answer: Answer) -> tuple[Expr, ...] | None:
    if answer.expression is None:
        return None
    return answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)


def _values(answer: Answer) -> tuple[float, ...] | None:
    if answer.value is None:
        return None
    return answer.value if isinstance(answer.value, tuple) else (answer.value,)


def _dimension(unit: str) -> Dimension:
    try:
        return DIMENSIONLESS if unit in ("", "1") else parse_unit(unit).dimension
    except FreebodyError:
        return DIMENSIONLESS


def _of_numbers(first: tuple[float, ...], second: tuple[float, ...], share: float = ROUND_OFF) -> list[str]:
    if len(first) != len(second):
        return [f"{len(first)} components, then {len(second)}"]
    size = max((abs(x) for x in (*first, *second)), default=0.0)
    for a, b in zip(first, second, strict=True):
        both_nan = math.isnan(a) and math.isnan(b)
        if not both_nan and not abs(a - b) <= share * size + 1e-11:
            return [f"{a!r}, then {b!r}"]
    return []


def _of_formulas(system: System, first: tuple[Expr, ...], second: tuple[Expr, ...], reading: Reading) -> list[str]:
    """Values of both at random points about the model's own."""
    if len(first) != len(second):
        return [f"{len(first)} components, then {len(second)}"]
    names = {reading.rename(s): s for e in second for s in sorted(free_symbols(e))}
    mine = {s for e in first for s in free_symbols(e)}
    parameters = set(system.parameters) | {"t", "pi"}
    if not (mine | set(names)) <= parameters and (not reading.same_coordinates or mine != set(names)):
        return []  # in other coordinates: the values have been compared
    rng = random.Random(7)
    near = {p.name: p.value for p in system.parameters.values() if p.value}
    for _ in range(_N_POINTS):
        point = {s: near.get(s, 0.6) * rng.uniform(0.9, 1.1) for s in sorted(mine | set(names))}
        rates = {s: rng.uniform(0.3, 1.0) for s in sorted(mine | set(names))}
        values_1 = [_value_of(e, point, rates, lambda s: s) for e in first]
        values_2 = [_value_of(e, point, rates, reading.rename) for e in second]
        size = max((abs(v) for v in (*values_1, *values_2) if v is not None), default=0.0)
        for a, b in zip(values_1, values_2, strict=True):
            if a is not None and b is not None and not abs(a - b) <= _OF_FORMULAS * (size + 1e-6):
                shown = [reading.rename(", ".join(map(to_python, e))) for e in (first, second)]
                return [f"{shown[0]}, then {shown[1]}"]
    return []


def _value_of(
    e: Expr, point: Mapping[str, float], rates: Mapping[str, float], rename: Callable[[str], str]
) -> float | None:
    """The value at a point; None where there is none, as for the root of a negative number."""
    values = {s: point.get(rename(s), 0.5) for s in free_symbols(e)}
    values |= {f"rate({s})": rates.get(rename(s), 0.5) for s in values}
    try:
        value = float(evaluate(e, values))
    except (FreebodyError, ArithmeticError, ValueError, TypeError):
        return None
    return value if math.isfinite(value) else None
