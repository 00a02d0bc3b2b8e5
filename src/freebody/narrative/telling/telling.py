"""A derivation told: stages and lines as the blocks of a report, in the words of a catalogue."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby

from freebody.language.expression import Expr
from freebody.language.raising import raised
from freebody.language.sentences import Argument, Sentence
from freebody.narrative.lines.script import (
    Cell,
    DerivationStage,
    Drawn,
    FormulaTable,
    Item,
    Legend,
    Listing,
    NumberedFormula,
    OptionText,
)
from freebody.narrative.sheets.options import shown
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.pictures import told_picture
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
    Piece,
    Step,
    Table,
    Text,
)
from freebody.present.report.formulas.rows import formula_width

_IN_A_LINE = 36  # characters of a formula that stands within a text
Entry = tuple[Expr, Sentence, str]  # a symbol, what it means, its unit
Draw = Callable[[Drawn], Picture | None]


class Telling:
    """Tells stages in one language. draw: makes the picture of a diagram."""

    def __init__(self, catalogue: Catalogue, draw: Draw) -> None:
        self.catalogue = catalogue
        self.draw = draw
        self.n_figures = 0
        self.shown: dict[tuple[tuple[str, ...], ...], int] = {}  # figures by what they show

    def stages(self, stages: Sequence[DerivationStage]) -> tuple[Block, ...]:
        """Every stage as a step that can be revealed."""
        return tuple(self._step(stage) for stage in stages)

    def _step(self, stage: DerivationStage) -> Step:
        hint: Text = () if stage.hint is None else self.catalogue.tell(stage.hint)
        return Step(self.catalogue.tell(stage.title), hint, tuple(self.blocks(stage.items)))

    def blocks(self, items: Sequence[Item]) -> Iterator[Block]:
        """Sentences that follow each other are one paragraph, diagrams stand side by side, and formulas that need no
        words between stand under each other."""
        lines: list[Equation] = []
        for block in self._blocks(items):
            if isinstance(block, Equations):
                lines += block.lines
                continue
            if lines:
                yield Equations(tuple(lines))
                lines = []
            yield block
        if lines:
            yield Equations(tuple(lines))

    def _blocks(self, items: Sequence[Item]) -> Iterator[Block]:
        words: list[Text] = []
        figures: list[Figure] = []
        again: list[int] = []
        for item in items:
            if not isinstance(item, Drawn) and figures:
                yield _side_by_side(figures)
                figures = []
            if not isinstance(item, Drawn) and again:
                words.append(self.catalogue.tell(Sentence("figure.again", {"figure": tuple(again)})))
                again = []
            if isinstance(item, Sentence):
                words.append(self.catalogue.tell(item))
                continue
            if isinstance(item, Drawn):
                found = self._figure(item)
                if isinstance(found, int):
                    again.append(found)
                elif found is not None:
                    if words and not figures:
                        yield from _paragraphs(_joined(words))
                        words = []
                    figures.append(found)
                continue
            if isinstance(item, NumberedFormula) and item.why is not None:
                words.append(self.catalogue.tell(item.why))
            if words:
                yield from _paragraphs(_joined(words))
                words = []
            yield from self._block(item)
        if again:
            words.append(self.catalogue.tell(Sentence("figure.again", {"figure": tuple(again)})))
        if words:
            yield from _paragraphs(_joined(words))
        if figures:
            yield _side_by_side(figures)

    def _block(self, item: Item) -> Iterator[Block]:
        match item:
            case NumberedFormula():
                yield Equations((self._equation(item),))
            case Listing(items):
                yield Bullets(tuple(self.catalogue.tell(s) for s in items))
            case Legend(entries):
                shown = [entry for entry in entries if entry[1].key != "symbol.asked"]  # the heading says that
                if shown:
                    yield Bullets(tuple(self._meanings(shown)))
            case FormulaTable(header, rows, marks):
                cells = tuple(tuple(self._cell(c) for c in row) for row in rows)
                yield Table(tuple(self.catalogue.tell(h) for h in header), cells, marks)
            case _:
                pass

    def _meanings(self, entries: Sequence[Entry]) -> Iterator[Text]:
        """What symbols mean; those of which the same is said stand together, each with its unit."""
        said = [(self.catalogue.tell(s), symbol, unit) for symbol, s, unit in self._components(entries)]
        for what, own in groupby(said, key=lambda entry: entry[0]):
            members = list(own)
            if len(members) == 1:
                yield (Formula((members[0][1],)), " — ", *what, *_unit(members[0][2]))
                continue
            units = {unit for _what, _symbol, unit in members}
            behind = _unit(units.pop()) if len(units) == 1 else ()
            shown = [(Formula((symbol,)), *(() if behind else _unit(unit))) for _what, symbol, unit in members]
            names = (piece for k, text in enumerate(shown) for piece in ((", ", *text) if k else text))
            yield (*names, " — ", *what, *behind)

    def _components(self, entries: Sequence[Entry]) -> Iterator[Entry]:
        """Components of one vector along all axes, of which the same is said."""
        for _same, own in groupby(entries, key=lambda entry: (entry[1].key, repr(_without_axis(entry[1])))):
            members = list(own)
            every = f"{members[0][1].key}_all"
            if len(members) < 2 or "axis" not in members[0][1].args or not self.catalogue.has(every):
                yield from members
            else:
                yield from ((symbol, Sentence(every, _without_axis(s)), unit) for symbol, s, unit in members)

    def _cell(self, cell: Cell) -> Text:
        if isinstance(cell, Sentence):
            return self.catalogue.tell(cell)
        if isinstance(cell, str):
            return tuple(self.catalogue.pieces(cell)) if cell else ()
        if isinstance(cell, OptionText):
            return shown(cell.text, self.catalogue.option(cell.text))
        return (Formula((cell,)),)

    def _equation(self, line: NumberedFormula) -> Equation:
        label = "" if line.label is None else self._label(line.label)
        formula = Formula(line.sides, line.relations, line.unit)
        return Equation(formula, line.number if line.number > 0 else None, label, is_result=line.is_result)

    def _label(self, label: Sentence) -> str:
        """What stands before an equation, with points and directions in their short form, without an article."""
        args = {k: f"@{self.catalogue.short(v)}" if isinstance(v, Sentence) else v for k, v in label.args.items()}
        return self.catalogue.plain(Sentence(label.key, args)).replace("the ", "", 1) + ":"

    def _figure(self, diagram: Drawn) -> Figure | int | None:
        """The figure of a diagram; the number of the one that shows the same already."""
        picture = self.draw(diagram)
        if picture is None:
            return None
        if diagram.shown in self.shown:
            return self.shown[diagram.shown]
        self.n_figures += 1
        self.shown[diagram.shown] = self.n_figures
        return Figure(told_picture(picture, self.catalogue), self.catalogue.tell(diagram.caption), self.n_figures)


def _without_axis(sentence: Sentence) -> dict[str, Argument]:
    return {name: value for name, value in sentence.args.items() if name != "axis"}


def _side_by_side(figures: list[Figure]) -> Block:
    return figures[0] if len(figures) == 1 else Figures(tuple(figures))


def _paragraphs(text: Text) -> Iterator[Block]:
    """A text as a paragraph; a fraction too wide for a line of text is displayed between its words, without the stop
    or comma behind it."""
    waiting: list[Piece] = []
    is_behind = False
    for piece in text:
        if isinstance(piece, Formula) and formula_width(piece) > _IN_A_LINE:
            if waiting:
                yield Paragraph(tuple(waiting))
            yield Equations((Equation(piece),))
            waiting, is_behind = [], True
            continue
        if not isinstance(piece, str) or waiting:
            waiting.append(piece)
        elif begun := piece.lstrip(" .,;" if is_behind else None):
            waiting.append(begun)
    if waiting:
        yield Paragraph(tuple(waiting))


def _joined(words: Sequence[Text]) -> Text:
    pieces: list[object] = []
    for k, text in enumerate(words):
        pieces += [" ", *text] if k else list(text)
    return tuple(pieces)  # pyrefly: ignore[bad-return]


def _unit(unit: str) -> Text:
    return (f" [{raised(unit)}]",) if unit else ()
