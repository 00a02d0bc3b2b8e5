"""What several derivations of one system have in common is told once.

Every derivation is written as if it stood alone. Here it is laid beside those before it: a line that stands there
already is left out, and what led to it and to nothing else with it; the lines that stay refer to the one that was told.
Two lines are the same if their formulas are, and their symbols mean the same; both have been checked, so that a line
told for one question is true for the other.

What stays is put into the order of a lecturer: constraints, free-body diagrams, principles, solution.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from freebody.language.expression import Expr, Number, Symbol
from freebody.language.sentences import Argument, Sentence
from freebody.narrative.lines.glossary import TrueWhen
from freebody.narrative.lines.script import (
    REFERENCES,
    DerivationStage,
    Diagram,
    Drawn,
    FormulaTable,
    Item,
    Legend,
    Listing,
    NumberedFormula,
    names_in,
)

DIAGRAMS, CONDITIONS = "stage.bodies", "stage.conditions"
_MOTION = ("stage.kinematics", "space.motion")
_BETWEEN = (DIAGRAMS, "stage.principles", "stage.friction")  # stages before which constraints are told


# -- references -------------------------------------------------------------------------------
def referred(sentence: Sentence | None) -> Iterator[int]:
    """The numbers of lines that a sentence names."""
    if sentence is not None:
        for name, value in sentence.args.items():
            yield from _numbers(name, value)


def _numbers(name: str, value: Argument) -> Iterator[int]:
    if isinstance(value, tuple):
        for part in value:
            yield from _numbers(name, part)
    elif isinstance(value, Sentence):
        yield from referred(value)
    elif isinstance(value, int) and name in REFERENCES:
        yield value


def referring(sentence: Sentence, numbers: Mapping[int, int]) -> Sentence:
    """The sentence with other numbers for the lines that it names, each once and in their order."""

    def put(name: str, value: Argument) -> Argument:
        if isinstance(value, tuple):
            parts = [put(name, part) for part in value]
            own = {part for part in parts if isinstance(part, int)}
            return tuple(sorted(own)) if own and name in REFERENCES else tuple(parts)
        if isinstance(value, Sentence):
            return referring(value, numbers)
        return numbers.get(value, value) if isinstance(value, int) and name in REFERENCES else value

    return Sentence(sentence.key, {name: put(name, value) for name, value in sentence.args.items()})


def renumbered(line: NumberedFormula, numbers: Mapping[int, int]) -> NumberedFormula:
    """The line with other numbers for itself and for those that it follows from."""
    why = None if line.why is None else referring(line.why, numbers)
    uses = tuple(dict.fromkeys(numbers.get(n, n) for n in line.uses))
    return replace(line, number=numbers.get(line.number, line.number), why=why, uses=uses)


def lines_of(stages: Sequence[DerivationStage]) -> list[NumberedFormula]:
    """All lines, in their order."""
    return [item for stage in stages for item in stage.items if isinstance(item, NumberedFormula)]


def sentences_of(stages: Sequence[DerivationStage]) -> list[Sentence]:
    """All that is said between the lines."""
    return [item for stage in stages for item in stage.items if isinstance(item, Sentence)]


# -- what has been told -----------------------------------------------------------------------
def _key(line: NumberedFormula, when: TrueWhen) -> object:
    return line.sides, line.relations, line.unit, line.symbols, when


@dataclass
class ToldSoFar:
    """What the derivations so far have told: lines, symbols with their meanings, and diagrams."""

    lines: dict[object, int] = field(default_factory=dict[object, int])
    symbols: set[tuple[Expr, str]] = field(default_factory=set[tuple[Expr, str]])
    others: list[Item] = field(default_factory=list[Item])  # diagrams, tables and stages of words alone

    notes: dict[str, list[Argument]] = field(default_factory=dict[str, list[Argument]])  # of results, by their event
    opening: Sequence[DerivationStage] = ()

    @classmethod
    def of(cls, opening: Sequence[DerivationStage]) -> ToldSoFar:
        """Nothing but the opening is told."""
        told = cls(opening=opening)
        told.take(opening)
        return told

    @property
    def sentences(self) -> Iterator[Sentence]:
        """What has been said."""
        yield from (item for item in self.others if isinstance(item, Sentence))

    @property
    def numbers(self) -> set[int]:
        """The lines that a reader sees."""
        return set(self.lines.values())

    def take(self, stages: Sequence[DerivationStage]) -> None:
        """These are told."""
        for stage in stages:
            for item in stage.items:
                if isinstance(item, NumberedFormula):
                    self.lines.setdefault(_key(item, item.when), item.number)
                elif isinstance(item, Legend):
                    self.symbols |= {(symbol, repr(what)) for symbol, what, _unit in item.entries}
                else:
                    self.others.append(item)

    def take_notes(self, stages: Sequence[DerivationStage], event: str) -> None:
        """What is noted of a result at an event."""
        listings = [item for stage in stages for item in stage.items if isinstance(item, Listing)]
        said = [s.args["text"] for listing in listings for s in listing.items if s.key == "result.note"]
        self.notes.setdefault(event, []).extend(said)

    def shared(self, stages: Sequence[DerivationStage]) -> tuple[list[DerivationStage], dict[int, int]]:
        """What is new in a derivation, and by which lines those that it lost stand already."""
        leads_on = _leading_on([piece for k, stage in enumerate(stages) for piece in _pieces(k, stage)])
        stages, conditions = _said_once(stages)
        pieces = [piece for k, stage in enumerate(stages) for piece in _pieces(k, stage)]
        again = {p.line.number: n for p in pieces if p.line is not None and (n := self.line_of(p.line)) is not None}
        again = _repeated(pieces) | again
        needed = _needed(pieces, again, leads_on - conditions)
        kept: list[DerivationStage] = []
        for k, stage in enumerate(stages):
            mine = [p for p in pieces if p.stage == k and self._stays(p, needed)]
            items = [item for p in mine for item in p.items]
            kept += [_with_count(stage, items)] if items else []
        new = [_referring_stage(stage, again) for stage in self._without_diagrams(kept)]
        return self._with_symbols(stages, _in_order(new)), again

    def line_of(self, line: NumberedFormula) -> int | None:
        """The line that says the same, at the same instants or always."""
        return self.lines.get(_key(line, line.when), self.lines.get(_key(line, "always")))

    def _stays(self, piece: _Piece, needed: set[int]) -> bool:
        """Lines that are needed with what is said of them; of the rest what has not been said, and symbols."""
        if piece.line is not None:
            return piece.line.number in needed
        said = [item for item in piece.items if not isinstance(item, Legend)]  # symbols follow their lines
        return any(item not in self.others for item in said or piece.items)

    def _without_diagrams(self, stages: Sequence[DerivationStage]) -> Iterator[DerivationStage]:
        """Of the diagrams those are drawn that are new and of which something is written."""
        told = [s.args.get("bodies") for s in sentences_of(stages)]
        before = [d.bodies for d in self.others if isinstance(d, Diagram)]
        for stage in stages:
            if stage.title.key != DIAGRAMS or not any(isinstance(item, Diagram) for item in stage.items):
                yield stage
                continue
            drawn = [d for d in stage.items if isinstance(d, Diagram) and d.bodies in told and d.bodies not in before]
            before += [d.bodies for d in drawn]
            items = [item for item in stage.items if not isinstance(item, Diagram) or item in drawn]
            if drawn:
                yield replace(stage, items=tuple(items))

    def _with_symbols(
        self, stages: Sequence[DerivationStage], kept: Sequence[DerivationStage]
    ) -> list[DerivationStage]:
        """Every symbol is explained where it first stands, unless it has been before."""
        legends = [item.entries for stage in stages for item in stage.items if isinstance(item, Legend)]
        known = set(self.symbols)
        of_lines = set[str]().union(*(names_in(side) for line in lines_of(stages) for side in line.sides))
        made: list[DerivationStage] = []
        for stage in kept:
            items: list[Item] = []
            for k, item in enumerate(stage.items):
                if isinstance(item, NumberedFormula):
                    group = _of_one_reason(stage.items[k:])
                    due = [e for es in legends for e in es if any(_stands_in(e, line) for line in group)]
                elif isinstance(item, Legend):
                    # in lines it is explained there; a diagram needs it here
                    is_drawn = any(isinstance(other, Diagram) for other in stage.items)
                    due = [e for e in item.entries if is_drawn or not names_in(e[0]) & of_lines]
                elif isinstance(item, Sentence):
                    named = _named_in(item)
                    due = [e for es in legends for e in es if isinstance(e[0], Symbol) and e[0].name in named]
                else:
                    items.append(item)
                    continue
                due = list({(e[0], repr(e[1])): e for e in due if (e[0], repr(e[1])) not in known}.values())
                known |= {(symbol, repr(what)) for symbol, what, _unit in due}
                items += [Legend(tuple(due))] if due else []
                items += [] if isinstance(item, Legend) else [item]
            made += [replace(stage, items=tuple(items))] if items else []
        return made


def _named_in(sentence: Sentence) -> set[str]:
    """Names of the symbols that a sentence says by themselves."""
    said = (v for value in sentence.args.values() for v in (value if isinstance(value, tuple) else (value,)))
    return {str(v.name) for v in said if isinstance(v, Symbol)}


def _of_one_reason(items: Sequence[Item]) -> list[NumberedFormula]:
    """The first of some lines, and those after it of which the same is said."""
    found: list[NumberedFormula] = []
    for item in items:
        if isinstance(item, NumberedFormula) and (not found or _alike(item, found[0])):
            found.append(item)
        elif not isinstance(item, Legend):
            break
    return found


def _alike(a: NumberedFormula, b: NumberedFormula) -> bool:
    return a.why is not None and b.why is not None and a.why.key == b.why.key


def _stands_in(entry: tuple[Expr, Sentence, str], line: NumberedFormula) -> bool:
    """Whether a symbol stands in a line, with this meaning."""
    symbol, what, _unit = entry
    names = names_in(symbol) & set[str]().union(*map(names_in, line.sides))
    told = dict(line.symbols)
    return any(told.get(name, repr(what)) == repr(what) for name in names)


def without_echo(
    stages: Sequence[DerivationStage], again: Mapping[int, int]
) -> tuple[list[DerivationStage], dict[int, int]]:
    """Without a last stage whose only line says what the line before it has said, conditions aside; that line stands
    for it from then on. The name that the question has for it is no reason to write it twice."""
    echo = next((stage for stage in reversed(stages)), None)
    before = _results(stages[:-1])
    if echo is None or not before or not all(isinstance(item, NumberedFormula | Legend) for item in echo.items):
        return list(stages), dict(again)
    own = lines_of([echo])
    if len(own) != 1 or not _echoes(own[0], before[-1]):
        return list(stages), dict(again)
    return list(stages[:-1]), {**again, own[0].number: before[-1].number}


def _results(stages: Sequence[DerivationStage]) -> list[NumberedFormula]:
    """The lines, without what makes them hold."""
    return lines_of([stage for stage in stages if stage.title.key != CONDITIONS])


def result_line(stages: Sequence[DerivationStage]) -> NumberedFormula | None:
    """The last line of a derivation: before the conditions under which it holds, where it ends in them."""
    return next(iter(reversed(_results(stages))), None)


def _echoes(line: NumberedFormula, before: NumberedFormula) -> bool:
    """Whether a line says what the one before it has said; the time of an event also under its own name."""
    if _key(line, line.when) == _key(before, before.when):
        return True
    is_time = line.why is not None and line.why.key == "answer.time"
    is_value = isinstance(before.sides[0], Symbol) and not isinstance(line.sides[-1], Number)
    return is_time and is_value and _value(line) == _value(before)


def _value(line: NumberedFormula) -> object:
    return line.sides[1:], line.relations, line.unit, line.when


def _said_once(stages: Sequence[DerivationStage]) -> tuple[list[DerivationStage], set[int]]:
    """Without conditions that a line before them says already, and the lines that do; a result that stands before is
    taken from there."""
    first: dict[object, NumberedFormula] = {}
    same: dict[int, int] = {}
    result = result_line(stages)
    kept: list[DerivationStage] = []
    for stage in stages:
        items: list[Item] = []
        found: tuple[Item, ...] = ()
        for item in stage.items:
            if not isinstance(item, NumberedFormula):
                items.append(item)
                continue
            before = first.setdefault(_key(item, "always"), item)
            if before is not item and stage.title.key == CONDITIONS:
                same[item.number] = before.number
            elif before is not item and item is result and _stands_for(before, item):
                told = Sentence("value.follows", {"lines": (before.number,)})
                found = (replace(item, why=told, uses=(before.number,), label=None),)
            else:
                items.append(item)
        has_lost = len(items) < len(stage.items)
        if not has_lost or lines_of([replace(stage, items=tuple(items))]):
            kept.append(replace(stage, items=tuple(items)))
        if found:
            kept.append(DerivationStage(Sentence("stage.value"), Sentence("hint.value"), found))
    return [_referring_stage(stage, same) for stage in kept] if same else kept, set(same.values())


def _stands_for(before: NumberedFormula, result: NumberedFormula) -> bool:
    """Whether a result may be taken from a line before it: unless it says itself that it does, in words of its own."""
    own = {*result.uses, *referred(result.why)}
    return before.when in ("always", result.when) and own != {before.number}


# -- what belongs to a line -------------------------------------------------------------------
@dataclass(frozen=True)
class _Piece:
    """A line of a stage with what leads up to it (and, after the last one, what follows it); or what stands in a stage
    without lines."""

    stage: int
    items: tuple[Item, ...]
    line: NumberedFormula | None = None


def _pieces(place: int, stage: DerivationStage) -> list[_Piece]:
    found: list[_Piece] = []
    waiting: list[Item] = []
    for item in stage.items:
        waiting.append(item)
        if isinstance(item, NumberedFormula):
            found.append(_Piece(place, tuple(waiting), item))
            waiting = []
        elif isinstance(item, FormulaTable | Listing | Drawn):  # these say something of their own
            found.append(_Piece(place, tuple(waiting)))
            waiting = []
    if waiting and found and found[-1].line is not None:
        last = found.pop()
        return [*found, replace(last, items=(*last.items, *waiting))]
    return [*found, *([_Piece(place, tuple(waiting))] if waiting else [])]


def _repeated(pieces: Sequence[_Piece]) -> dict[int, int]:
    """Of the lines from which others follow those that stand in the same derivation before, and where: two limits are
    found from the same equations."""
    leads_on = _leading_on(pieces)
    first: dict[object, int] = {}
    found: dict[int, int] = {}
    for line in (p.line for p in pieces if p.line is not None):
        n = first.setdefault(_key(line, line.when), line.number)
        if n != line.number and line.number in leads_on:
            found[line.number] = n
    return found


def _leading_on(pieces: Sequence[_Piece]) -> set[int]:
    """The lines from which others follow."""
    return {n for p in pieces if p.line is not None for n in (*p.line.uses, *referred(p.line.why))}


def _needed(pieces: Sequence[_Piece], again: Mapping[int, int], leads_on: set[int]) -> set[int]:
    """The lines that lead to an end of the derivation without having been told: to its last line, and to those from
    which no other follows. leads_on: the lines from which others followed as the derivation was written, also where
    these stand by what was found before."""
    own = {p.line.number: p for p in pieces if p.line is not None}
    last = max(own, default=0)
    waiting = [n for n, p in own.items() if n not in leads_on and (n == last or not _is_of_state(p))]
    waiting += [n for p in pieces if p.line is None for item in p.items for n in referred_in(item)]
    found = set[int]()
    while waiting:
        n = waiting.pop()
        n = again.get(n, n)
        if n in own and n not in again and n not in found:
            found.add(n)
            line = own[n].line
            waiting += line.uses if line is not None else ()
            waiting += [other for item in own[n].items for other in referred_in(item)]
    return found


def _is_of_state(piece: _Piece) -> bool:
    """Whether a line says one part of the state at an event, which is of use only if another refers to it."""
    return piece.line is not None and piece.line.why is not None and piece.line.why.key == "event.there"


def referred_in(item: Item) -> Iterator[int]:
    """The numbers of lines that an item names in words."""
    match item:
        case Sentence():
            yield from referred(item)
        case NumberedFormula():
            yield from referred(item.why)
        case Listing(items):
            for sentence in items:
                yield from referred(sentence)
        case FormulaTable(_header, rows):
            for cell in (cell for row in rows for cell in row if isinstance(cell, Sentence)):
                yield from referred(cell)
        case _:
            pass


def renumbered_item(item: Item, numbers: Mapping[int, int]) -> Item:
    """The item with other numbers for the lines that it names."""
    match item:
        case Sentence():
            return referring(item, numbers)
        case NumberedFormula():
            return renumbered(item, numbers)
        case Listing(items):
            return Listing(tuple(referring(s, numbers) for s in items))
        case FormulaTable(_header, rows):
            cells = tuple(tuple(referring(c, numbers) if isinstance(c, Sentence) else c for c in row) for row in rows)
            return replace(item, rows=cells)
        case _:
            return item


def _referring_stage(stage: DerivationStage, numbers: Mapping[int, int]) -> DerivationStage:
    hint = None if stage.hint is None else referring(stage.hint, numbers)
    return replace(stage, hint=hint, items=tuple(renumbered_item(item, numbers) for item in stage.items))


# -- stages -----------------------------------------------------------------------------------
def _with_count(stage: DerivationStage, items: Iterable[Item]) -> DerivationStage:
    """The stage with fewer items; a hint that counts equations counts those that are left."""
    made, hint = tuple(items), stage.hint
    before, after = (sum(isinstance(i, NumberedFormula) for i in some) for some in (stage.items, made))
    if hint is not None and hint.args.get("n") == before != after:
        hint = Sentence(hint.key, {**hint.args, "n": after})
    return replace(stage, hint=hint, items=made)


def _in_order(stages: Sequence[DerivationStage]) -> list[DerivationStage]:
    """Constraints and how bodies move before the free-body diagrams to which they belong."""
    ordered: list[DerivationStage] = []
    for stage in stages:
        place = len(ordered)
        if stage.title.key in _MOTION:
            own = {item.number for item in stage.items if isinstance(item, NumberedFormula)}
            uses = {n for item in stage.items if isinstance(item, NumberedFormula) for n in item.uses} - own
            while place and ordered[place - 1].title.key in _BETWEEN and not uses & _numbers_of(ordered[place - 1]):
                place -= 1
        ordered.insert(place, stage)
    return ordered


def _numbers_of(stage: DerivationStage) -> set[int]:
    return {item.number for item in stage.items if isinstance(item, NumberedFormula)}
