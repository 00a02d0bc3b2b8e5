"""A question bank, free of any platform: what is asked, what is right, what is wrong and why, in some variants.

Texts and blocks are those of reports, so that each platform writes them in its own markup.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from freebody.assess.numbers import Tolerance
from freebody.exercises.sampling import Sampling
from freebody.language.expression import Expr, free_symbols
from freebody.model.elements import Sign
from freebody.narrative.sheets.answer_key import KeyEntry
from freebody.present.report.blocks import Block, Figure, Text

Value = float | tuple[float, ...] | None
Kind = Literal["formula", "number", "vector", "words"]


@dataclass(frozen=True)
class SymbolUsed:
    """A symbol that an answer may contain. unit: in SI, empty for none; is_moving: a measure, which changes with time,
    as its rate does."""

    name: str
    unit: str
    sign: Sign
    is_angle: bool = False
    is_moving: bool = False


@dataclass(frozen=True)
class WrongAnswer:
    """A formula that is not the answer. text: in the notation of models; mistake: the key of the mistake that leads to
    it, empty where none is known; feedback: what is said about it; is_option: the author offers it."""

    text: str
    mistake: str
    feedback: Text
    is_option: bool = False


@dataclass(frozen=True)
class ShownOption:
    """An option of a variant. text: in the notation of models; shown: as it is printed; feedback: why it is right or
    wrong."""

    letter: str
    text: str
    shown: Text
    is_right: bool
    feedback: Text


@dataclass(frozen=True)
class Given:
    """A parameter with its value. text: as the file has it; value: in SI."""

    name: str
    text: str
    value: float


@dataclass(frozen=True)
class ItemVariant:
    """An item with numbers of its own. n: counted from 1; statement: all that is said before the question, with figure
    and numbers; value: of the answer in SI; wrong_values: those of the wrong answers, None where one has none;
    solution: worked, with the hints of its steps."""

    n: int
    given: tuple[Given, ...]
    statement: tuple[Block, ...]
    figure: Figure | None
    options: tuple[ShownOption, ...]
    value: Value
    wrong_values: tuple[Value, ...]
    key: KeyEntry
    solution: tuple[Block, ...]
    hints: tuple[Text, ...]


@dataclass(frozen=True)
class Item:
    """One question of a system.

    id: letters, digits and underscores, unique in the bank; name: unique as well, for people; told: the statement
    without figure and numbers; answer: what is to be found, whether or not there are options; expression, unit: of the
    right answer; equivalent: other ways to write it; conditions: where it holds, in words; tolerance: for numbers;
    number_prompt: which number is to be given, in which unit, how exactly; labels: of the parts of an answer that has
    several, x and y of a vector, 1, 2 ... of values whose order is that of their size; sampling: where formulas can be
    compared with the answer."""

    id: str
    name: str
    title: str
    language: str
    told: tuple[Block, ...]
    prompt: Text
    answer: Kind
    expression: Expr | tuple[Expr, ...] | None
    unit: str
    equivalent: tuple[str, ...]
    wrong: tuple[WrongAnswer, ...]
    symbols: tuple[SymbolUsed, ...]
    conditions: tuple[Text, ...]
    reason: str  # why there is no answer; empty where there is one
    tolerance: Tolerance
    number_prompt: Text
    points: float
    sampling: Sampling | None
    variants: tuple[ItemVariant, ...]
    labels: tuple[str, ...] = ()

    @property
    def has_symbols(self) -> bool:
        """Whether the answer is a formula in symbols, or several."""
        parts = self.expression if isinstance(self.expression, tuple) else (self.expression,)
        return any(part is not None and free_symbols(part) for part in parts)

    @property
    def has_options(self) -> bool:
        return bool(self.variants[0].options)

    @property
    def has_one_right_option(self) -> bool:
        return sum(option.is_right for option in self.variants[0].options) == 1


@dataclass(frozen=True)
class Bank:
    """Items in the order of their systems. words: what writers of blocks say themselves; seed: of the variants."""

    title: str
    language: str
    items: tuple[Item, ...]
    words: dict[str, str]
    n_variants: int
    seed: int
