"""An item of the bank as a STACK question.

A formula is typed and, where the variants have numbers, the number as well; a statement is chosen among options. What
differs between the variants, figures and numbers, follows the variable of the variant, which the seed sets.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import zip_longest

from freebody.exercises.asked import left_out
from freebody.exercises.bank import Bank, Item
from freebody.exercises.markup import Markup
from freebody.exercises.stack.castext import DIALECT, VARIANT, by_variant, words
from freebody.exercises.stack.choice import ChoicePart
from freebody.exercises.stack.formula import FormulaPart
from freebody.exercises.stack.number import NumberPart
from freebody.exercises.stack.part import Part
from freebody.exercises.stack.question import QuestionTest, StackQuestion
from freebody.exercises.stack.seeds import seeds
from freebody.language.sentences import Message
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Figure

PLATFORM = "STACK"


class ItemWriter:
    """Writes one item. told: what STACK cannot express of it."""

    def __init__(self, bank: Bank, item: Item, catalogue: Catalogue) -> None:
        self.bank, self.item, self.catalogue = bank, item, catalogue
        self.files: dict[str, bytes] = {}
        self.solution_files: dict[str, bytes] = {}
        self.markup = Markup(bank.language, bank.words, DIALECT, lambda figure: _image(figure, self.files))
        self.told: list[str] = []

    def question(self) -> StackQuestion | None:
        """None where it cannot be asked."""
        item, parts = self.item, self._parts()
        if not parts:
            self.told.append(left_out(item, PLATFORM))
            return None
        solved = Markup(
            self.bank.language, self.bank.words, DIALECT, lambda figure: _image(figure, self.solution_files)
        )
        solution = by_variant([solved.blocks(v.solution) for v in item.variants])
        return StackQuestion(
            item.name,
            self._text(parts),
            solution,
            "\n".join([self._variant(), *(line for part in parts for line in part.variables)]),
            f"{{@{VARIANT}@}}" if len(item.variants) > 1 else "",
            tuple(part.input for part in parts),
            tuple(part.tree for part in parts),
            seeds(len(item.variants)),
            tuple(_together([part.tests for part in parts])),
            self.files,
            self.solution_files,
            item.points,
            item.id,
        )

    def _parts(self) -> list[Part]:
        item = self.item
        if item.reason:
            return []
        if item.answer == "words":
            return [ChoicePart(item, self.markup).part()] if any(o.is_right for o in item.variants[0].options) else []
        parts: list[Part] = []
        if item.expression is not None and item.answer != "number":
            parts.append(FormulaPart(item, self.markup, self.catalogue).part())
        n = len(parts) + 1
        number = NumberPart(item, self.markup, f"ans{n}", f"prt{n}")
        if number.is_asked:
            parts.append(number.part())
        elif number.is_sometimes_zero:
            told = Message(
                "{item}: the number is not asked for, as it is 0 in a variant and a share of it is no tolerance",
                item=item.name,
            )
            self.told.append(told)
        if not parts and item.has_options:
            told = Message("{item}: {platform} can only ask for it with options", item=item.name, platform=PLATFORM)
            self.told.append(told)
            parts.append(ChoicePart(item, self.markup).part())
        return parts

    def _variant(self) -> str:
        n = len(self.item.variants)
        return f"{VARIANT}:rand({n})+1;" if n > 1 else f"{VARIANT}:1;"

    def _text(self, parts: list[Part]) -> str:
        item, markup = self.item, self.markup
        own = [[block for block in v.statement if block not in item.told] for v in item.variants]
        told = markup.blocks(item.told) + by_variant([markup.blocks(blocks) for blocks in own])
        return f"{told}<p><strong>{markup.text(item.prompt)}</strong></p>{''.join(part.asked for part in parts)}"


def _image(figure: Figure, files: dict[str, bytes]) -> str:
    """The drawing is a file of the text in which it stands; the same one is kept once."""
    drawing = figure.picture.svg(dark=False).encode()
    known = next((name for name, content in files.items() if content == drawing), None)
    name = known or f"figure_{len(files) + 1}.svg"
    files[name] = drawing
    said = words(f"{figure.picture.title}. {figure.picture.description}")
    return f'<img src="@@PLUGINFILE@@/{name}" alt="{said}" />'


def _together(tests: Sequence[tuple[QuestionTest, ...]]) -> Iterator[QuestionTest]:
    """The tests of the parts side by side."""
    for row in zip_longest(*tests):
        given = [test for test in row if test is not None]
        first = given[0]
        for other in given[1:]:
            first = first.and_also(other)
        yield first
