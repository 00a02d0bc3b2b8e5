"""The questions that platforms with formulas make of an item: its formula, its options, its number."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from freebody.errors import CannotAnswer
from freebody.exercises.asked import ChoiceAsked, NumberAsked, is_moving, left_out, number_of
from freebody.exercises.bank import Bank, Item, ItemVariant
from freebody.exercises.formulas import FormulaAsked, formula_of
from freebody.exercises.typed import Language
from freebody.language.sentences import Message

Form = FormulaAsked | ChoiceAsked | NumberAsked
Kind = Literal["formula", "options", "number"]


@dataclass(frozen=True)
class ItemQuestion:
    """One way to ask an item. forms: by variant; a formula is the same in all of them."""

    item: Item
    kind: Kind
    forms: tuple[tuple[ItemVariant, Form], ...]


def questions_of(bank: Bank, platform: str, language: Language) -> tuple[tuple[ItemQuestion, ...], tuple[str, ...]]:
    """All of a bank, and what is to be said about what cannot be asked."""
    found: list[ItemQuestion] = []
    told: list[str] = []
    for item in bank.items:
        why: CannotAnswer | None = None
        own = list(_others(item))
        if item.answer in ("formula", "vector") and not item.reason:
            try:
                form = formula_of(item, language)
            except CannotAnswer as error:
                why = error
            else:
                own.insert(0, ItemQuestion(item, "formula", tuple((variant, form) for variant in item.variants)))
        told += _told(item, own, why, platform)
        found += own
    n = sum(question.kind == "formula" and bool(question.item.conditions) for question in found)
    if n:
        limit = Message(
            "{platform} does not ask for the conditions under which an answer holds; {n} answers have some",
            platform=platform,
            n=n,
        )
        told.append(limit)
    if language.is_exact and any(question.kind == "formula" for question in found):
        told.append(
            Message("{platform} takes fractions in formulas, no decimals; students are told", platform=platform)
        )
    return tuple(found), tuple(told)


def _others(item: Item) -> Iterator[ItemQuestion]:
    if item.has_one_right_option and len(item.variants[0].options) > 1:
        yield ItemQuestion(item, "options", tuple((v, ChoiceAsked(v.options)) for v in item.variants))
    if item.answer in ("formula", "number") and not is_moving(item):
        numbers = [(v, number_of(item, v, v.value)) for v in item.variants if isinstance(v.value, float)]
        forms = tuple((v, form) for v, form in numbers if form is not None)
        if len(forms) == len(item.variants):
            yield ItemQuestion(item, "number", forms)


def _told(item: Item, own: Sequence[ItemQuestion], why: CannotAnswer | None, platform: str) -> Iterator[str]:
    if not own:
        yield Message("{item} is left out: {why}", item=item.name, why=why) if why else left_out(item, platform)
    elif why:
        yield Message("{item} is not asked for its formula: {why}", item=item.name, why=why)
