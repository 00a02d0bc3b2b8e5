"""An exercise as it is set: what the model is, its numbers, its picture, and what is asked."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any, cast

from freebody.errors import FreebodyError
from freebody.language.expression import Expr, Number, Symbol, free_symbols
from freebody.language.units import DIMENSIONLESS, TIME
from freebody.measures.geometry import ZERO
from freebody.model.elements import RigidBody
from freebody.model.phrases import phrase_text
from freebody.narrative.lines.script import Sentence, ready
from freebody.narrative.sheets.asking import asking
from freebody.narrative.sheets.options import shown
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.raising import raised
from freebody.present.report.blocks import Block, Bullets, Emphasis, Figure, Formula, Paragraph, Table, Text
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.study.mobility.gruebler import gruebler
from freebody.system.system import System


class ExerciseStatement:
    """The statement of one exercise in one language. number: of the exercise; figure: of its picture."""

    def __init__(self, system: System, catalogue: Catalogue, number: int, figure: int) -> None:
        self.system = system
        self.catalogue = catalogue
        self.number = number
        self.figure = figure

    def blocks(self) -> tuple[Block, ...]:
        """Everything but the title."""
        return tuple(self._blocks())

    def _blocks(self) -> Iterator[Block]:
        system = self.system
        if system.about:
            yield Paragraph((" ".join(system.about.split()),))
        yield from self._picture()
        yield from self._bodies()
        yield from self._connections()
        for text in system.assumptions:
            yield Paragraph(self._say("system.assumed", text=ready(text)))
        yield from self._symbols()
        yield from self._start()
        yield from self._given()
        for k, question in enumerate(system.questions, 1):
            yield from self._question(question, k)

    def _say(self, key: str, **args: Any) -> Text:
        return self.catalogue.tell(Sentence(key, args))

    def _picture(self) -> Iterator[Block]:
        from freebody.study.pictures.picture import picture

        try:
            drawn = picture(self.system)
        except (FreebodyError, NotImplementedError):  # an exercise without its picture is better than none
            return
        yield Figure(drawn, self._say("sheet.figure", title=f"@{title_of(self.system, self.catalogue)}"), self.figure)

    # -- the model ----------------------------------------------------------------------------
    def _bodies(self) -> Iterator[Block]:
        given = cast("dict[str, Any]", self.system.document.data.get("bodies") or {})
        rows: list[tuple[Text, ...]] = []
        for body in self.system.moving:
            entry = given.get(body.name)
            shape = next(iter(cast("dict[str, Any]", entry)), "") if isinstance(entry, dict) else ""
            inertia = _inertia(body) if body.turns else ()
            mass: Text = () if body.mass == ZERO else _with_unit(body.mass, "kg")
            if not (mass or inertia):
                mass = self._say("sheet.massless")
            name: Text = (Emphasis(body.name, "code"),)
            rows.append((name, self._say("sheet.shape_of", shape=f"@shape.{shape}"), mass, inertia))
        if rows:
            header = tuple(self._say(f"sheet.{name}") for name in ("body", "shape", "mass", "inertia"))
            yield Table(header, tuple(rows))

    def _connections(self) -> Iterator[Block]:
        rows: list[tuple[Text, ...]] = []
        for c in gruebler(self.system).connections:
            if c.n:
                rows.append(self._acting(c.connection, c.kind, c.between))
        for name, load in self.system.loads.items():
            pushed = (*self.system.applied_loads, *self.system.impulses)
            on = dict.fromkeys(b for p in pushed if p.load == name for b in p.measure.bodies())
            bodies = tuple(b for b in on if not self.system.bodies[b].fixed)
            everywhere = len(bodies) == len(self.system.moving) > 1
            rows.append(self._acting(name, load.kind, () if everywhere else bodies))
        if rows:
            header = tuple(self._say(f"sheet.{name}") for name in ("connection", "kind", "between"))
            yield Table(header, tuple(rows))

    def _acting(self, name: str, kind: str, bodies: tuple[str, ...]) -> tuple[Text, ...]:
        where = self._say("sheet.names", names=bodies) if bodies else self._say("sheet.all_bodies")
        return (Emphasis(name, "code"),), self._say("sheet.kind_of", kind=f"@kind.{kind.replace('_', ' ')}"), where

    # -- symbols and numbers ------------------------------------------------------------------
    def _symbols(self) -> Iterator[Block]:
        given = cast("dict[str, Any]", self.system.document.data.get("measures") or {})
        items: list[Text] = []
        for name in self.system.measures:
            phrase = phrase_text(given.get(name))
            if phrase is not None:
                items.append((Formula((Symbol(name),)), " — ", *self._say("sheet.phrase", phrase=f"@{phrase}")))
        if items:
            yield Paragraph(self._say("sheet.symbols"))
            yield Bullets(tuple(items))

    def _start(self) -> Iterator[Block]:
        formulas: list[Formula] = []
        for order, values in enumerate((self.system.start, self.system.start_rates)):
            for name, value in values.items():
                dimension = self.system.measures[name].dimension
                unit = ("rad", "rad/s")[order] if dimension == DIMENSIONLESS else str(dimension / TIME**order)
                shown_unit = "" if free_symbols(value) or value == ZERO else unit
                formulas.append(Formula((rates_of(name, order), value), ("=",), shown_unit))
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
            known.append(_value(p.name, str(text)))
        if known:
            joined = [piece for k, text in enumerate(known) for piece in ((", ", *text) if k else text)]
            yield Paragraph((*self._say("sheet.given"), " ", *joined, "."))
        if is_open:
            yield Paragraph(self._say("sheet.in_symbols"))

    # -- questions ----------------------------------------------------------------------------
    def _question(self, question: Question, k: int) -> Iterator[Block]:
        label = Emphasis(label_of(self.number, k, len(self.system.questions)))
        yield Paragraph((label, " ", *self.catalogue.tell(asking(self.system, question))))
        if question.options:
            said = ((letter, self.catalogue.option(text)) for letter, text in question.options.items())
            yield Bullets(tuple((f"({letter}) ", *shown(text)) for letter, text in said))


def _value(name: str, text: str) -> Text:
    """name = value unit, as the file writes it."""
    digits, _space, unit = text.strip().partition(" ")
    try:
        value = Number(Fraction(digits))
    except ValueError:
        return Formula((Symbol(name),)), f" = {text}"
    if value.value.denominator > 1:  # as the file has it, not as a fraction
        shown = "°" if unit == "deg" else f" {raised(unit)}" if unit else ""
        return Formula((Symbol(name),)), f" = {digits}{shown}"
    return (Formula((Symbol(name), value), ("=",), "°" if unit == "deg" else unit),)


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
