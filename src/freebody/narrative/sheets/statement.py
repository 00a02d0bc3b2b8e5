"""An exercise as it is set: what the model is, its numbers, its picture, and what is asked."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, cast

from freebody.errors import ExpressionError, FreebodyError
from freebody.language.expression import Call, Expr, Symbol, free_symbols
from freebody.language.parser import parse
from freebody.language.raising import raised, typeset
from freebody.language.sentences import Argument, Sentence
from freebody.language.units import DIMENSIONLESS, TIME, quantities_within
from freebody.measures.geometry import ZERO
from freebody.model.elements import RigidBody
from freebody.model.phrases import phrase_text
from freebody.model.states import as_told
from freebody.narrative.lines.script import ready
from freebody.narrative.sheets.asking import asking
from freebody.narrative.sheets.authored import authored, with_symbols
from freebody.narrative.sheets.options import shown
from freebody.narrative.sheets.unseen import not_rebounding, unseen_numbers, unseen_symbols
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.pictures import told_picture
from freebody.present.report.blocks import (
    Block,
    Choices,
    Emphasis,
    Figure,
    Formula,
    Paragraph,
    Piece,
    Room,
    Text,
    Unbroken,
)
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.study.mobility.gruebler import gruebler
from freebody.system.system import System


class ExerciseStatement:
    """The statement of one exercise in one language. number: of the exercise; figure: of its picture."""

    def __init__(
        self,
        system: System,
        catalogue: Catalogue,
        number: int,
        figure: int,
        *,
        room: float = 0.0,
        numbers: Mapping[str, Text] | None = None,
    ) -> None:
        """room: [cm] to write in under a question; numbers: options that are shown in numbers."""
        self.system = system
        self.room, self.numbers = room, numbers or {}
        self.catalogue = catalogue
        self.number = number
        self.figure = figure

    def blocks(self) -> tuple[Block, ...]:
        """Everything but the title."""
        return tuple(self._blocks())

    def _blocks(self) -> Iterator[Block]:
        """What is said of the model stays together with its picture, and each question with its options."""
        system = self.system
        yield Unbroken(self.model())
        for k, question in enumerate(system.questions, 1):
            asked: list[Block] = [*self._question(question, k)]
            if self.room:
                asked.append(Room(self.room / 2 if question.options else self.room))
            yield Unbroken(tuple(asked))

    def model(self, *, is_bare: bool = False) -> tuple[Block, ...]:
        """What is said of the model. is_bare: without its picture and its numbers, which differ by variant."""
        system = self.system
        told: list[Block] = []
        if system.about:
            told.append(Paragraph(authored(system.about, system)))
        told += [] if is_bare else self.picture()
        told += self._bodies()
        if not system.about:
            told += self._connections()
        told += [Paragraph(self._say("system.assumed", text=ready(text))) for text in system.assumptions]
        told += [
            *self._symbols(),
            *self._states(),
            *self._start(),
            *self._impacts(),
            *(() if is_bare else self._given()),
        ]
        return tuple(told)

    def prompt(self, question: Question) -> Text:
        """What is asked, in the words of the author where there are any."""
        return authored(question.words, self.system) if question.words else self._asking(question)

    def option(self, text: str) -> Text:
        """An option as it is shown."""
        return self.numbers.get(text) or shown(text, self.catalogue.option(text))

    def _say(self, key: str, **args: Any) -> Text:
        return self.catalogue.tell(Sentence(key, args))

    def picture(self) -> Iterator[Block]:
        """The figure, where one can be drawn."""
        from freebody.study.pictures.picture import picture

        try:
            drawn = picture(self.system)
        except (FreebodyError, NotImplementedError):  # an exercise without its picture is better than none
            return
        drawn = told_picture(drawn, self.catalogue)
        yield Figure(drawn, self._say("sheet.figure", title=f"@{title_of(self.system, self.catalogue)}"), self.figure)

    # -- the model ----------------------------------------------------------------------------
    def _bodies(self) -> Iterator[Block]:
        """The bodies with shape, mass, size and moment of inertia, in one sentence; those alike together."""
        given = cast("dict[str, Any]", self.system.document.data.get("bodies") or {})
        alike: dict[Text, list[Piece]] = {}
        first = {copy: body.name for body in self.system.bodies.values() for copy in body.copies}
        for body in self.system.moving:
            entry = given.get(first.get(body.name, body.name))  # copies are as the one that is written
            alike.setdefault(self._described(body, entry), []).append(self.catalogue.name(body.name))
        told = [(*_in_turn([(name,) for name in names]), " (", *what, ")") for what, names in alike.items()]
        if told:
            yield Paragraph((*self._say("sheet.bodies"), " ", *_in_turn(told, "; "), "."))

    def _described(self, body: RigidBody, entry: object) -> Text:
        """What a body is. entry: as the file has it."""
        given = cast("dict[str, Any]", entry) if isinstance(entry, dict) else {}
        shape = next(iter(given), "")
        of_shape: object = given.get(shape)
        own = cast("dict[str, Any]", of_shape) if isinstance(of_shape, dict) else {}
        sizes = self._sizes(shape, own)
        # that of a homogeneous body follows from its mass and its size
        inertia = _inertia(body) if body.turns and ("inertia" in own or not sizes) else ()
        is_massless = body.mass == ZERO and not inertia
        shape = shape.replace("_", " ")
        bare = f"massless.{shape}" if is_massless and self.catalogue.has(f"massless.{shape}") else f"shape.{shape}"
        parts: list[Text] = [self._say("sheet.shape_of", shape=f"@{bare}")]
        if body.mass != ZERO:
            parts.append((self.catalogue.word("sheet.mass"), " ", *_with_unit(body.mass, "kg")))
        parts += sizes
        if inertia:
            parts.append((self.catalogue.word("sheet.inertia"), " ", *inertia))
        elif is_massless and bare.startswith("shape."):
            parts.append(self._say("sheet.massless"))
        return _in_turn(parts)

    def _sizes(self, shape: str, given: Mapping[str, Any]) -> list[Text]:
        """Radius, length and so on, as the file has them."""
        found: list[Text] = []
        for key, value in given.items():
            word = next((w for w in (f"size.{shape}.{key}", f"size.{key}") if self.catalogue.has(w)), None)
            if word is None or value is None:
                continue
            values = cast("list[object]", value) if isinstance(value, list) else [value]
            sizes = [self._size(str(x)) for x in values]
            found.append((self.catalogue.word(word), " ", *_in_turn(sizes)))
        return found

    def _size(self, text: str) -> Text:
        """As the file has it: a formula, or numbers with their units."""
        _rest, quantities = quantities_within(text, self.system.parameters)
        try:
            return (raised(text) if quantities else Formula((parse(text),)),)
        except ExpressionError:
            return (raised(text),)

    def _connections(self) -> Iterator[Block]:
        """Connections and loads, in a sentence each."""
        told = [self._acting(c.connection, c.kind, c.between) for c in gruebler(self.system).connections if c.n]
        if told:
            yield Paragraph((*self._say("sheet.connections"), " ", *_in_turn(told, "; "), "."))
        told = list[Text]()
        for name, load in self.system.loads.items():
            pushed = (*self.system.applied_loads, *self.system.impulses)
            on = dict.fromkeys(b for p in pushed if p.load == name for b in p.measure.bodies())
            bodies = tuple(b for b in on if not self.system.bodies[b].fixed)
            everywhere = len(bodies) == len(self.system.moving) > 1
            told.append(self._acting(name, load.kind, () if everywhere else bodies))
        if told:
            yield Paragraph((*self._say("sheet.loads"), " ", *_in_turn(told, "; "), "."))

    def _acting(self, name: str, kind: str, bodies: tuple[str, ...]) -> Text:
        where = self._say("sheet.names", names=bodies) if bodies else self._say("sheet.all_bodies")
        what = self._say("sheet.kind_of", kind=f"@kind.{kind.replace('_', ' ')}")
        return (self.catalogue.name(name), " (", *what, ", ", *where, ")")

    def _states(self) -> Iterator[Block]:
        """What a controller integrates: the rate of each of its states."""
        states = self.system.states
        laws = [
            Formula((Call("rate", Symbol(name)), as_told(state.rate, states)), ("=",)) for name, state in states.items()
        ]
        if laws:
            yield Paragraph((*self._say("sheet.states"), " ", *_listed(laws), "."))

    # -- symbols and numbers ------------------------------------------------------------------
    def _symbols(self) -> Iterator[Block]:
        given = cast("dict[str, Any]", self.system.document.data.get("measures") or {})
        told: list[Text] = []
        for name in self.system.measures:
            phrase = phrase_text(given.get(name))
            if phrase is not None:
                told.append((Formula((Symbol(name),)), " (", *self._say("sheet.phrase", phrase=f"@{phrase}"), ")"))
        if told:
            yield Paragraph((*self._say("sheet.symbols"), " ", *_in_turn(told), "."))

    def _start(self) -> Iterator[Block]:
        formulas: list[Formula] = []
        for order, values in enumerate((self.system.start, self.system.start_rates)):
            for name, value in values.items():
                dimension = self.system.measures[name].dimension
                unit = ("rad", "rad/s")[order] if dimension == DIMENSIONLESS else str(dimension / TIME**order)
                shown_unit = "" if free_symbols(value) or value == ZERO else unit
                formulas.append(Formula((rates_of(name, order), value), ("=",), shown_unit))
        for name, state in self.system.states.items():
            shown_unit = "" if free_symbols(state.start) or state.start == ZERO else str(state.dimension)
            formulas.append(Formula((Symbol(name), state.start), ("=",), shown_unit))
        closing = tuple(dict.fromkeys(row.connection for row in self.system.constraint_rows if row.closes))
        if closing:
            yield Paragraph(self._say("sheet.closes", names=closing))
        if formulas:
            when = "sheet.start_struck" if self.system.is_struck else "sheet.start"
            yield Paragraph((*self._say(when), " ", *_listed(formulas), "."))

    def _given(self) -> Iterator[Block]:
        """Parameters with values as the file writes them."""
        data = cast("dict[str, Any]", self.system.document.data.get("parameters") or {})
        known: list[Text] = []
        is_open = False
        for p in self.system.parameters.values():
            if p.form is not None:
                known.append((Formula((Symbol(p.name), p.form), ("=",)),))
                continue
            entry = data.get(p.name)
            text = cast("dict[str, Any]", entry).get("value") if isinstance(entry, dict) else entry
            if p.value is None or text is None:
                is_open = True
                continue
            known.append((*_value(p.name, str(text)), *self._meant(p.name)))
        known += self._unnamed()
        if known:
            joined = [piece for k, text in enumerate(known) for piece in ((", ", *text) if k else text)]
            yield Paragraph((*self._say("sheet.given"), " ", *joined, "."))
        if is_open:
            yield Paragraph(self._say("sheet.in_symbols"))

    def _meant(self, name: str) -> Text:
        """What a parameter is that no figure shows, in brackets."""
        field, of = unseen_symbols(self.system).get(name, ("", ""))
        if not field:
            return ()
        what = self._say(f"unseen.{field}", name=of) if of else self._say(f"unseen_alone.{field}")
        return (" (", *what, ")")

    def _unnamed(self) -> Iterator[Text]:
        """What no figure shows and no parameter names: the number for the length of a spring, or for a friction."""
        for field, name, value in unseen_numbers(self.system):
            yield (*self._say(f"unseen.{field}", name=name), " ", raised(value).replace(" deg", "°"))

    def _impacts(self) -> Iterator[Block]:
        """What does not rebound, where nobody has said how it does."""
        if names := not_rebounding(self.system):
            yield Paragraph(self._say("sheet.plastic", names=names))

    # -- questions ----------------------------------------------------------------------------
    def _question(self, question: Question, k: int) -> Iterator[Block]:
        label = Emphasis(label_of(self.number, k, len(self.system.questions)))
        worth = () if question.points is None else (" ", Emphasis(self._worth(question.points), "soft"))
        yield Paragraph((label, " ", *self.prompt(question), *worth))
        if question.options:
            yield Choices(tuple((f"({letter})", self.option(text)) for letter, text in question.options.items()))

    def _asking(self, question: Question) -> Text:
        return with_symbols(self.catalogue.tell(asking(self.system, question)), question, self.system)

    def _worth(self, points: float) -> str:
        args: dict[str, Argument] = {"n": 1} if points == 1 else {"points": f"@{points:g}"}
        return self.catalogue.plain(Sentence("sheet.points", args))


def _in_turn(texts: Sequence[Text], between: str = ", ") -> Text:
    return tuple(piece for k, text in enumerate(texts) for piece in ((between, *text) if k else text))


def _value(name: str, text: str) -> Text:
    """name = value unit, as the file writes it."""
    digits, _space, unit = text.strip().partition(" ")
    shown = "°" if unit == "deg" else f" {raised(unit)}" if unit else ""
    try:
        float(digits)
    except ValueError:
        return Formula((Symbol(name),)), f" = {raised(text)}"
    return Formula((Symbol(name),)), f" = {typeset(digits)}{shown}"


def _with_unit(value: Expr, unit: str) -> Text:
    """A formula; a plain number with its unit in SI."""
    return (Formula((value,), (), "" if free_symbols(value) else unit),)


def _inertia(body: RigidBody) -> Text:
    """The moment of inertia about the mass centre; in space those about the axes of the body."""
    diagonal = body.tensor[:3] if body.tensor else (body.inertia,)
    distinct = tuple(dict.fromkeys(diagonal))
    if distinct == (ZERO,):
        return ()
    shown = distinct if len(distinct) == 1 else diagonal
    return tuple(piece for k, e in enumerate(shown) for piece in ((", ",) * bool(k) + _with_unit(e, "kg m^2")))


def title_of(system: System, catalogue: Catalogue) -> str:
    return system.title or catalogue.word("sheet.untitled")


def label_of(number: int, k: int, n_questions: int) -> str:
    """2, or 2.1 where an exercise asks several things."""
    return f"{number}.{k}" if n_questions > 1 else f"{number}"


def _listed(formulas: list[Formula]) -> Text:
    return tuple(piece for k, f in enumerate(formulas) for piece in ((", ", f) if k else (f,)))
