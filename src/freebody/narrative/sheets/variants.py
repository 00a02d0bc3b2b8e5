"""The same exercise with other numbers and shuffled options.

Every parameter that has a value gets another one, as a person would write it: two or three significant digits, angles
in steps of 5 degrees where the model has such. A set of numbers is taken if the model can be assembled with it and
every question keeps its formula, its conditions and its right option, and no two options get the same value; else
numbers closer to the file are tried.
"""

from __future__ import annotations

import math
import random
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, cast

from freebody.errors import FreebodyError
from freebody.language.units import ACCELERATION
from freebody.model.elements import Parameter
from freebody.narrative.sheets.in_numbers import options_in_numbers, rounded
from freebody.study.answering.answer import NOT_VALID, Answer
from freebody.study.answering.solution import Solution
from freebody.study.answering.solve import solve
from freebody.system.system import System

_SPREADS = (0.5, 0.5, 0.4, 0.3, 0.2, 0.2, 0.1, 0.1)  # about the values of the file, as fractions
_DEGREES = 5


@dataclass(frozen=True)
class Variant:
    """A system with its own numbers and letters, and its answers. is_as_in_file: no other numbers were admissible."""

    system: System
    solution: Solution
    is_as_in_file: bool = False


def as_given(system: System) -> Variant:
    """The exercise as its file has it."""
    return Variant(system, solve(system))


def variant_of(system: System, original: Solution, seed: str) -> Variant:
    """Another variant; the same for the same seed."""
    rng = random.Random(seed)
    letters = [_shuffled(list(q.options), rng) for q in system.questions]
    for spread in _SPREADS:
        numbers = _numbers(system, rng, spread)
        if not numbers:
            break
        found = _admissible(system, original, numbers, letters)
        if found is not None:
            return found
    same = _written(system, {}, letters)
    return Variant(same, solve(same), is_as_in_file=True)


def _admissible(
    system: System, original: Solution, numbers: Mapping[str, str], letters: list[dict[str, str]]
) -> Variant | None:
    """The variant with these numbers, if it asks the same."""
    try:
        made = _written(system, numbers, letters)
        solution = solve(made)
    except FreebodyError:
        return None
    pairs = zip(original.answers, solution.answers, letters, strict=True)
    is_same = all(_is_alike(a, b, new) for a, b, new in pairs)
    return Variant(made, solution) if is_same and not _is_degenerate(system, original, made, solution) else None


def _is_degenerate(system: System, original: Solution, made: System, solution: Solution) -> bool:
    """Whether a question has lost its point: two equal masses do not move, and options that differ give the same."""
    both = zip(
        zip(system.questions, original.answers, strict=True),
        zip(made.questions, solution.answers, strict=True),
        strict=True,
    )
    return any(
        (options_in_numbers(system, *before) and not options_in_numbers(made, *after))
        or (before[1].value == 0) != (after[1].value == 0)
        for before, after in both
    )


def _is_alike(before: Answer, after: Answer, letters: Mapping[str, str]) -> bool:
    """Whether an answer is the same but for its numbers and letters."""
    if before.expression != after.expression or before.conditions != after.conditions or before.unit != after.unit:
        return False
    if any(note.startswith(NOT_VALID) for note in after.notes) or (before.value is None) != (after.value is None):
        return False
    values = after.value if isinstance(after.value, tuple) else (after.value,)
    if not all(v is None or math.isfinite(v) for v in values):
        return False
    renamed = {letters.get(k, k): v.verdict for k, v in before.options.items()}
    return renamed == {k: v.verdict for k, v in after.options.items()}


# -- numbers ----------------------------------------------------------------------------------
def _numbers(system: System, rng: random.Random, spread: float) -> dict[str, str]:
    """Other values, as texts with units."""
    given = cast("dict[str, Any]", system.document.data.get("parameters") or {})
    found: dict[str, str] = {}
    for p in system.parameters.values():
        factor = 1 + spread * rng.uniform(-1, 1)
        if p.name in given and _may_vary(p):
            found[p.name] = _value(p, str(_text_of(given[p.name])), factor)
    return found


def _text_of(entry: Any) -> Any:
    return cast("dict[str, Any]", entry).get("value") if isinstance(entry, dict) else entry


def _may_vary(p: Parameter) -> bool:
    """Gravity and what is zero stay as they are."""
    return (
        p.value is not None and p.form is None and p.value != 0 and not (p.name == "g" and p.dimension == ACCELERATION)
    )


def _value(p: Parameter, text: str, factor: float) -> str:
    """A value near the one in a text, in the same unit."""
    digits, _space, unit = text.strip().partition(" ")
    try:
        number = float(digits)
    except ValueError:
        return text
    wanted = number * factor
    if p.is_angle and unit in ("deg", "°") and number % _DEGREES == 0:
        steps = max(1, round(wanted / _DEGREES))
        wanted = float(min(steps, 80 // _DEGREES) if p.acute and number < 90 else steps) * _DEGREES
        return f"{wanted:g} {unit}"
    shown = rounded(wanted, 3 if _significant(digits) >= 3 else 2)
    return f"{shown} {unit}" if unit else shown


def _significant(digits: str) -> int:
    """How many digits somebody has written."""
    mantissa = digits.lower().partition("e")[0].lstrip("+-").replace(".", "").lstrip("0")
    return len(mantissa if "." in digits else mantissa.rstrip("0"))


# -- letters ----------------------------------------------------------------------------------
def _shuffled(letters: list[str], rng: random.Random) -> dict[str, str]:
    """New letters by old ones."""
    new = list(letters)
    rng.shuffle(new)
    return dict(zip(letters, new, strict=True))


def _written(system: System, numbers: Mapping[str, str], letters: list[dict[str, str]]) -> System:
    """The model read again with other numbers and letters."""
    data = system.document.data
    parameters = cast("dict[str, Any]", data.get("parameters") or {})
    for name, value in numbers.items():
        entry = parameters[name]
        parameters[name] = {**cast("dict[str, Any]", entry), "value": value} if isinstance(entry, dict) else value
    given: Any = data.get("questions") or []
    questions = list(cast("dict[str, Any]", given).values()) if isinstance(given, dict) else cast("list[Any]", given)
    for entry, new in zip(questions, letters, strict=True):
        if isinstance(entry, dict):  # else it is a text, without options
            _rename(cast("dict[str, Any]", entry), new)
    return replace(System.from_data(data), file=system.file)


def _rename(question: dict[str, Any], new: Mapping[str, str]) -> None:
    """Gives the options of a question other letters; options in a list have the first ones."""
    given: Any = question.get("options")
    texts: Any = cast("dict[str, Any]", given).values() if isinstance(given, dict) else given or ()
    renamed = dict(zip(new.values(), texts, strict=False))
    if renamed:
        question["options"] = dict(sorted(renamed.items()))
        if question.get("key") is not None:
            question["key"] = new[str(question["key"])]


__all__ = ["Variant", "as_given", "rounded", "variant_of"]
