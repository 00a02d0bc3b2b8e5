"""A derivation told: stages and lines as the blocks of a report, in the words of a catalogue."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from freebody.narrative.lines.script import (
    DerivationStage,
    Diagram,
    FormulaTable,
    Item,
    Legend,
    Listing,
    NumberedFormula,
    Sentence,
)
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import (
    Block,
    Bullets,
    Equation,
    Equations,
    Figure,
    Figures,
    Formula,
    Paragraph,
    Picture,
    Step,
    Table,
    Text,
)

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
Draw = Callable[[tuple[str, ...], tuple[str, ...]], Picture | None]


class Telling:
    """Tells stages in one language. draw: makes the picture of bodies cut free (of the system without any)."""

    def __init__(self, catalogue: Catalogue, draw: Draw) -> None:
        self.catalogue = catalogue
        self.draw = draw
        self.n_figures = 0
        self.shown: dict[tuple[tuple[str, ...], tuple[str, ...]], int] = {}  # figures by the bodies that they show

    def stages(self, stages: Sequence[DerivationStage]) -> tuple[Block, ...]:
        """Every stage as a step that can be revealed."""
        return tuple(self._step(stage) for stage in stages)

    def _step(self, stage: DerivationStage) -> Step:
        hint: Text = () if stage.hint is None else self.catalogue.tell(stage.hint)
        return Step(self.catalogue.tell(stage.title), hint, tuple(self.blocks(stage.items)))

    def blocks(self, items: Sequence[Item]) -> Iterator[Block]:
        """Sentences that follow each other are one paragraph, diagrams stand side by side."""
        words: list[Text] = []
        figures: list[Figure] = []
        again: list[int] = []
        for item in items:
            if not isinstance(item, Diagram) and figures:
                yield _side_by_side(figures)
                figures = []
            if not isinstance(item, Diagram) and again:
                words.append(self.catalogue.tell(Sentence("figure.again", {"figure": tuple(again)})))
                again = []
            if isinstance(item, Sentence):
                words.append(self.catalogue.tell(item))
                continue
            if isinstance(item, Diagram):
                found = self._figure(item)
                if isinstance(found, int):
                    again.append(found)
                elif found is not None:
                    if words and not figures:
                        yield Paragraph(_joined(words))
                        words = []
                    figures.append(found)
                continue
            if isinstance(item, NumberedFormula) and item.why is not None:
                words.append(self.catalogue.tell(item.why))
            if words:
                yield Paragraph(_joined(words))
                words = []
            yield from self._block(item)
        if again:
            words.append(self.catalogue.tell(Sentence("figure.again", {"figure": tuple(again)})))
        if words:
            yield Paragraph(_joined(words))
        if figures:
            yield _side_by_side(figures)

    def _block(self, item: Item) -> Iterator[Block]:
        match item:
            case NumberedFormula():
                yield Equations((self._equation(item),))
            case Listing(items):
                yield Bullets(tuple(self.catalogue.tell(s) for s in items))
            case Legend(entries):
                yield Bullets(
                    tuple((Formula((e,)), " — ", *self.catalogue.tell(s), *(_unit(unit))) for e, s, unit in entries)
                )
            case FormulaTable(header, rows, marks):
                cells = tuple(tuple(self._cell(c) for c in row) for row in rows)
                yield Table(tuple(self.catalogue.tell(h) for h in header), cells, marks)
            case _:
                pass

    def _cell(self, cell: object) -> Text:
        if isinstance(cell, Sentence):
            return self.catalogue.tell(cell)
        if isinstance(cell, str):
            return (self.catalogue.said(cell),) if cell else ()
        return (Formula((cell,)),)  # type: ignore[arg-type]

    def _equation(self, line: NumberedFormula) -> Equation:
        label = "" if line.label is None else self._label(line.label)
        formula = Formula(line.sides, line.relations, line.unit)
        return Equation(formula, line.number, label)

    def _label(self, label: Sentence) -> str:
        """What stands before an equation, with points and directions in their short form."""
        args = {k: f"@{self.catalogue.short(v)}" if isinstance(v, Sentence) else v for k, v in label.args.items()}
        return self.catalogue.plain(Sentence(label.key, args)) + ":"

    def _figure(self, diagram: Diagram) -> Figure | int | None:
        """The figure of a diagram; the number of the one that shows the same already."""
        shown = (diagram.bodies, diagram.told)
        picture = self.draw(*shown)
        if picture is None:
            return None
        if shown in self.shown:
            return self.shown[shown]
        self.n_figures += 1
        self.shown[shown] = self.n_figures
        return Figure(picture, self.catalogue.tell(diagram.caption), self.n_figures)


def _side_by_side(figures: list[Figure]) -> Block:
    return figures[0] if len(figures) == 1 else Figures(tuple(figures))


def _joined(words: Sequence[Text]) -> Text:
    pieces: list[object] = []
    for k, text in enumerate(words):
        pieces += [" ", *text] if k else list(text)
    return tuple(pieces)  # type: ignore[arg-type]


def _unit(unit: str) -> Text:
    return (f" [{raised(unit)}]",) if unit else ()


def raised(unit: str) -> str:
    """kg m^2/s^2 with its exponents raised."""
    return re.sub(r"\^(-?\d+)", lambda found: found[1].translate(_RAISED), unit)
