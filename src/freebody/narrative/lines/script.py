"""A derivation as data: lines and sentences in their order. A line is checked in numbers before it is taken.

A sentence is a key of the catalogue with what it names, so a derivation has no language. A line says which earlier
lines it follows from. The formulas of a line hold at every instant of a motion ("always"), at the start, or at the
event that is asked for.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import pairwise, takewhile
from typing import Literal

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.expression import ZERO, Expr, Symbol, free_symbols
from freebody.language.notation import Stated, to_text
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.lines.glossary import Glossary, Meaning, TrueWhen, World
from freebody.present.report.blocks import Derivative, Difference, Relation, Side
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.spread import NO_DERIVATION, disagreement

ROUND_OFF = 1e-6  # of a line, by the size of its terms
BY_DIFFERENCES = 1e-4  # where derivatives are taken by differences
FEWEST = 2  # random motions at which a line must have been looked at


REFERENCES = ("line", "lines", "given")  # places of a sentence that hold numbers of lines


@dataclass(frozen=True)
class NumberedFormula:
    """A formula: sides, the relations between them, why it is true, and from which lines it follows.

    number: by which others refer to it; below zero where a reader needs none, as nothing refers to it. symbols: what
    those of its symbols mean that the derivation introduced; is_result: it is what was asked for."""

    number: int
    sides: tuple[Side, ...]
    relations: tuple[Relation, ...]
    why: Sentence | None = None
    uses: tuple[int, ...] = ()
    label: Sentence | None = None
    when: TrueWhen = "always"
    unit: str = ""
    symbols: frozenset[tuple[str, str]] = frozenset()
    is_result: bool = False


@dataclass(frozen=True)
class Listing:
    """Sentences under each other."""

    items: tuple[Sentence, ...]


@dataclass(frozen=True)
class Legend:
    """Symbols and what they mean, with units: from here on they may be used."""

    entries: tuple[tuple[Expr, Sentence, str], ...]


@dataclass(frozen=True)
class OptionText:
    """An option of a question, as its author wrote it."""

    text: str


Cell = Sentence | Expr | OptionText | str


@dataclass(frozen=True)
class FormulaTable:
    """A table: header and cells are sentences, expressions, options or names."""

    header: tuple[Sentence, ...]
    rows: tuple[tuple[Cell, ...], ...]
    marks: tuple[Literal["", "right", "wrong"], ...] = ()


@dataclass(frozen=True)
class Diagram:
    """A picture: of the system, or of bodies cut free."""

    bodies: tuple[str, ...]  # nothing: the whole system
    caption: Sentence
    told: tuple[str, ...] = ()  # rows that never act, and of which the equations say so
    turning: tuple[str, ...] = ()  # angles whose rates are drawn as vectors along their axes

    @property
    def shown(self) -> tuple[tuple[str, ...], ...]:
        """What tells it from others."""
        return self.bodies, self.told, self.turning


@dataclass(frozen=True)
class Graph:
    """The diagram of an answer that is a function of a place or of the time, at the given numbers."""

    question: Question
    answer: Answer
    caption: Sentence

    @property
    def shown(self) -> tuple[tuple[str, ...], ...]:
        """What tells it from others."""
        return (("graph", self.question.id),)


def _is_number(side: Side) -> bool:
    """Whether it is a number that has a unit if what it is the value of has one: zero needs none."""
    return isinstance(side, Expr) and side != ZERO and not free_symbols(side)


def ready(text: str) -> Argument:
    """A ready-made sentence, as it stands within another one."""
    return text if isinstance(text, Message | Stated) else f"@{text}"


Drawn = Diagram | Graph
Item = Sentence | NumberedFormula | Listing | Legend | FormulaTable | Drawn


@dataclass(frozen=True)
class DerivationStage:
    """A part of a derivation that is revealed at once. hint: what one should try oneself."""

    title: Sentence
    hint: Sentence | None
    items: tuple[Item, ...]


class Script:
    """A derivation that is being written. Every line is evaluated at random motions as it is added."""

    def __init__(self, glossary: Glossary, first: int = 1) -> None:
        self.glossary = glossary
        self.stages: list[DerivationStage] = []
        self._items: list[Item] = []
        self._number = first
        self._constants: set[str] = set()

    @property
    def next_number(self) -> int:
        return self._number

    @contextmanager
    def stage(self, title: str, hint: str = "", **args: Argument) -> Generator[None]:
        """What is added inside belongs to one stage; an empty one is left out."""
        before, self._items = self._items, []
        try:
            yield
            if self._items:
                shown = Sentence(hint, args) if hint else None
                stage = DerivationStage(Sentence(title, args), shown, tuple(self._items))
                last = self.stages[-1] if self.stages else None
                if last is not None and (last.title, last.hint) == (stage.title, stage.hint):  # it goes on
                    self.stages[-1] = replace(last, items=last.items + stage.items)
                else:
                    self.stages.append(stage)
        finally:
            self._items = before

    def take(self, other: Script) -> None:
        """The stages of another one that began where this one stands."""
        self.stages += other.stages
        self._number = other._number

    def say(self, key: str, **args: Argument) -> None:
        self._items.append(Sentence(key, args))

    def has_said(self, key: str) -> bool:
        """Whether a sentence with this key stands in an earlier stage."""
        items = (item for stage in self.stages for item in stage.items)
        return any(isinstance(item, Sentence) and item.key == key for item in items)

    def add(self, item: Item) -> None:
        self._items.append(item)

    def introduce(self, *meanings: Meaning) -> None:
        """Symbols with what they mean; one that is known keeps its meaning."""
        for meaning in meanings:
            self.glossary.introduce(meaning)
        self.add(Legend(tuple((m.symbol, m.what, m.unit) for m in meanings)))

    def add_all(self, items: Sequence[Item]) -> None:
        self._items += items

    def line(
        self,
        *sides: Side,
        why: str = "",
        args: Mapping[str, Argument] | None = None,
        uses: Sequence[int] = (),
        label: Sentence | None = None,
        when: TrueWhen = "always",
        relations: Sequence[Relation] = (),
        unit: str = "",
    ) -> int:
        """Checks a formula and adds it; returns its number. Raises RoutesDisagree where it does not hold."""
        relations = tuple(relations) or ("=",) * (len(sides) - 1)
        self._check(sides, relations, when)
        sides, relations = _said_once(sides, relations)
        self._introduce_constants(sides)
        if not unit and _is_number(sides[-1]):
            unit = self.glossary.unit_of(sides[0])
        number, self._number = self._number, self._number + 1
        reason = Sentence(why, args or {}) if why else None
        known = self.glossary.meanings
        names = sorted(set[str]().union(*map(names_in, sides)) & known.keys())
        symbols = frozenset((name, repr(known[name].what)) for name in names)
        line = NumberedFormula(number, sides, tuple(relations), reason, tuple(uses), label, when, unit, symbols)
        self._items.append(line)
        return number

    def _introduce_constants(self, sides: Sequence[Side]) -> None:
        """Start values that have no formula are explained where they first stand."""
        used = set[str]().union(*(names_in(side) for side in sides))
        known = self.glossary.start_values
        entries = [(Symbol(name), known[name], "") for name in sorted(used & known.keys() - self._constants)]
        self._constants |= used
        if entries:
            self._items.append(Legend(tuple(entries)))

    def _check(self, sides: Sequence[Side], relations: Sequence[Relation], when: TrueWhen) -> None:
        expressions = list(sides)
        room = BY_DIFFERENCES if any(isinstance(s, (Derivative, Difference)) for s in sides) else ROUND_OFF
        n_held, trouble, is_silent = 0, "", False

        def is_open() -> bool:
            return is_silent and n_held < FEWEST

        for world in filter(self.glossary.is_one, self._worlds(when, is_open)):
            try:
                known = [world.of(side) for side in expressions]
                scale = max(world.scale(expressions), world.noise / ROUND_OFF)
            except (CannotAnswer, ArithmeticError, ValueError) as error:
                trouble, is_silent = str(error), isinstance(error, SaysNothing)
                continue
            if not all(math.isfinite(part) for side in known for part in side):  # as angles in a gimbal lock
                trouble = Message("a part of it has no value there")
                continue
            n_held += 1
            for k, (left, right) in enumerate(pairwise(known)):
                for a, b in zip(left, right, strict=True):
                    if not _agrees(a, b, relations[k], scale, room):
                        step = Message(
                            "the step {line} does not hold: {a:.10g} against {b:.10g}",
                            line=_shown(expressions),
                            a=a,
                            b=b,
                        )
                        raise disagreement(step, world.draw.reference, NO_DERIVATION)
        if n_held < FEWEST:
            told = Message(
                "the step {line} could be checked at {n} random motions only, so the derivation is not shown",
                line=_shown(expressions),
                n=n_held,
            )
            raise CannotAnswer(Message("{what}: {why}", what=told, why=trouble) if trouble else told)

    def _worlds(self, when: TrueWhen, is_open: Callable[[], bool]) -> Iterator[World]:
        """Motions at which a line has to hold, and more of them where it says nothing of too many."""
        yield from self.glossary.worlds(when)
        if when == "always" and is_open():
            yield from takewhile(lambda _world: is_open(), self.glossary.further)


def _agrees(a: float, b: float, relation: Relation, scale: float, share: float = ROUND_OFF) -> bool:
    room = share * max(abs(a), abs(b), scale, 1e-9)
    match relation:
        case "=" | "≈":
            return abs(a - b) <= (room if relation == "=" else 1e-2 * max(abs(a), abs(b), scale))
        case ">" | "≥":
            return a >= b - room
        case "<" | "≤":
            return a <= b + room
        case "≠":
            return a != b
        case _:
            return True


def _said_once(sides: Sequence[Side], relations: Sequence[Relation]) -> tuple[tuple[Side, ...], tuple[Relation, ...]]:
    """Without a side that reads as the one before it, made of other parts though it be."""
    kept = [
        0,
        *(
            k
            for k in range(1, len(sides))
            if relations[k - 1] != "=" or _shown(sides[k - 1 : k]) != _shown(sides[k : k + 1])
        ),
    ]
    return tuple(sides[k] for k in kept), tuple(relations[k - 1] for k in kept[1:])


def _shown(sides: Sequence[Side]) -> str:
    return " = ".join(_text(side) for side in sides)


def _text(side: Side) -> str:
    if isinstance(side, tuple):
        return "(" + ", ".join(map(to_text, side)) + ")"
    return "?" if isinstance(side, (Derivative, Difference)) else to_text(side)


def names_in(side: Side) -> set[str]:
    """All symbols of a side of a formula."""
    match side:
        case tuple():
            return {name for part in side for name in free_symbols(part)}
        case Derivative(of, by, _):
            return names_in(of) | free_symbols(by)
        case Difference(first, second):
            return names_in(first) | names_in(second)
        case _:
            return set(free_symbols(side))
