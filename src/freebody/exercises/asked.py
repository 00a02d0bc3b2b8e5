"""What is asked on platforms that know options and numbers but no formulas: the form that loses least of an item.

Options where the author has some; else the number, where there is one; else options that mistakes lead to. What can be
asked in none of these ways is left out, and said.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from freebody.exercises.bank import Bank, Item, ItemVariant, ShownOption
from freebody.exercises.making import as_text
from freebody.exercises.selftests import SelfTest, What
from freebody.language.expression import free_symbols
from freebody.language.parser import parse
from freebody.language.sentences import Message
from freebody.present.report.blocks import Formula, Text

FEWEST_WRONG = 2  # options that mistakes lead to, of a question that is asked with them alone
MOST_WRONG = 4


@dataclass(frozen=True)
class ChoiceAsked:
    """One option of these is right."""

    options: tuple[ShownOption, ...]


@dataclass(frozen=True)
class WrongNumber:
    """A number that a mistake leads to. room: by how much one that is given may differ from it."""

    value: float
    room: float
    feedback: Text


@dataclass(frozen=True)
class NumberAsked:
    """A number is to be given. room: by how much it may be off; prompt: in which unit and how exactly."""

    value: float
    room: float
    unit: str
    prompt: Text
    wrong: tuple[WrongNumber, ...]


@dataclass(frozen=True)
class NumbersAsked:
    """Several numbers are to be given, each with its label. room: by how much each may be off."""

    labels: tuple[str, ...]
    values: tuple[float, ...]
    room: float
    unit: str
    prompt: Text


Form = ChoiceAsked | NumberAsked | NumbersAsked


@dataclass(frozen=True)
class Asked:
    """A variant of an item as it is asked. name: unique in the package."""

    name: str
    item: Item
    variant: ItemVariant
    form: Form


def asked_of(bank: Bank, platform: str, *, takes_several: bool = False) -> tuple[tuple[Asked, ...], tuple[str, ...]]:
    """All variants of all items that can be asked, and what is to be said about the others. takes_several: the platform
    can ask for several numbers in one question."""
    found: list[Asked] = []
    told: list[str] = []
    for item in bank.items:
        forms = [(variant, _form(item, variant, takes_several)) for variant in item.variants]
        told += _told(item, forms[0][1], platform)
        for variant, form in forms:
            if form is not None:
                name = item.name if bank.n_variants == 1 else f"{item.name} [{variant.n}]"
                found.append(Asked(name, item, variant, form))
    return tuple(found), tuple(told)


def _told(item: Item, form: Form | None, platform: str) -> Iterator[str]:
    if form is None:
        yield left_out(item, platform)
    elif isinstance(form, NumberAsked | NumbersAsked) and item.has_symbols:
        yield Message(
            "{item}: {platform} takes no formulas, so the number is asked for", item=item.id, platform=platform
        )
    elif isinstance(form, ChoiceAsked) and not item.has_options:
        yield Message(
            "{item}: {platform} takes no formulas, so it is asked with options that mistakes lead to",
            item=item.id,
            platform=platform,
        )


def left_out(item: Item, platform: str) -> str:
    """Why an item cannot be asked."""
    why = {
        "vector": Message("several values at once cannot be marked there; give options"),
        "words": Message("its answer is a condition or a statement, which {platform} cannot mark", platform=platform),
        "formula": Message("{platform} takes no formulas, and too few wrong ones are known", platform=platform),
        "number": Message("it has no value", platform=platform),
    }[item.answer]
    if item.reason:
        why = Message("it has no answer here")
    elif item.answer == "vector" and is_moving(item):
        why = Message("its answer changes in the motion, and {platform} takes no formulas", platform=platform)
    return Message("{item} is left out: {why}", item=item.id, why=why)


def _form(item: Item, variant: ItemVariant, takes_several: bool) -> Form | None:
    if item.has_one_right_option and len(variant.options) > 1:
        return ChoiceAsked(variant.options)
    values = variant.value
    if takes_several and item.answer == "vector" and isinstance(values, tuple) and item.labels and not is_moving(item):
        return _numbers(item, tuple(sorted(values)) if "1" in item.labels else values)
    if item.answer in ("formula", "number") and isinstance(variant.value, float) and not is_moving(item):
        return number_of(item, variant, variant.value)
    if item.answer == "formula":
        return _from_mistakes(item, variant)
    return None


def is_moving(item: Item) -> bool:
    """Whether the answer changes in the motion, so that one number is none: it has symbols that are no parameters."""
    given = {symbol.name for symbol in item.symbols if not symbol.is_moving}
    parts = item.expression if isinstance(item.expression, tuple) else (item.expression,)
    return any(part is not None and not free_symbols(part) <= given for part in parts)


def number_of(item: Item, variant: ItemVariant, value: float) -> NumberAsked | None:
    if not math.isfinite(value):
        return None
    room = item.tolerance.room(value)
    wrong: list[WrongNumber] = []
    for answer, number in zip(item.wrong, variant.wrong_values, strict=True):
        if not isinstance(number, float):
            continue
        own = item.tolerance.room(number)
        others = [(value, room), *((w.value, w.room) for w in wrong)]
        if all(abs(number - x) > 2 * (own + r) for x, r in others):  # else it says nothing
            wrong.append(WrongNumber(number, own, answer.feedback))
    return NumberAsked(value, room, item.unit, item.number_prompt, tuple(wrong))


def _numbers(item: Item, values: tuple[float, ...]) -> NumbersAsked | None:
    if not all(map(math.isfinite, values)):
        return None
    room = item.tolerance.room(max(map(abs, values)))
    return NumbersAsked(item.labels, values, room, item.unit, item.number_prompt)


def _from_mistakes(item: Item, variant: ItemVariant) -> ChoiceAsked | None:
    """The answer among wrong ones, in an order that is the same each time."""
    wrong = [w for w in item.wrong if not w.is_option][:MOST_WRONG]
    if len(wrong) < FEWEST_WRONG or item.expression is None:
        return None
    side = item.expression
    shown: list[tuple[Text, str, bool, Text]] = [((Formula((side,)),), as_text(side), True, ())]
    shown += [((Formula((parse(w.text),)),), w.text, False, w.feedback) for w in wrong]
    random.Random(f"{item.id}/{variant.n}").shuffle(shown)
    return ChoiceAsked(
        tuple(
            ShownOption(chr(ord("a") + k), text, words, is_right, feedback)
            for k, (words, text, is_right, feedback) in enumerate(shown)
        )
    )


# -- numbers as they are written --------------------------------------------------------------
def digits(x: float) -> str:
    """A number of a package."""
    return f"{x:.10g}"


def number_tests(name: str, form: NumberAsked, feedback: Sequence[str]) -> Iterator[SelfTest]:
    """The value, values at both edges of what is allowed, values beyond them, and those that mistakes lead to with what
    is said about them."""

    def test(what: What, x: float, is_right: bool, said: str = "") -> SelfTest:
        return SelfTest(name, what, digits(x), "correct" if is_right else "incorrect", said)

    value, room = form.value, form.room
    yield test("key", value, True)
    step = room or max(1.0, abs(value))
    if room:
        yield from (test("equivalent", value + share * room, True) for share in (-0.9, 0.9))
    beyond = [value + share * step for share in (-1.1, 1.1)]
    for x in beyond:
        if all(abs(x - w.value) > w.room for w in form.wrong):
            yield test("distractor", x, False)
    yield from (test("distractor", w.value, False, said) for w, said in zip(form.wrong, feedback, strict=True))


def numbers_tests(name: str, form: NumbersAsked) -> Iterator[SelfTest]:
    """The values, and each of them wrong alone."""

    def written(values: Sequence[float]) -> str:
        return "; ".join(map(digits, values))

    yield SelfTest(name, "key", written(form.values), "correct")
    step = form.room or max(1.0, *map(abs, form.values))
    for k in range(len(form.values)):
        near = [x + 0.9 * form.room * (j == k) for j, x in enumerate(form.values)]
        yield SelfTest(name, "equivalent", written(near), "correct")
        off = [x + 1.1 * step * (j == k) for j, x in enumerate(form.values)]
        yield SelfTest(name, "distractor", written(off), "incorrect")


__all__ = [
    "Asked",
    "ChoiceAsked",
    "Form",
    "NumberAsked",
    "NumbersAsked",
    "WrongNumber",
    "asked_of",
    "digits",
    "is_moving",
    "left_out",
    "number_tests",
    "numbers_tests",
]
