"""What the symbols of a derivation mean, and their values at random motions by the numeric route.

A symbol is a parameter, a coordinate or named measure with its rates, or one that the derivation introduces: then it
stands for a quantity that the numeric route can tell on its own (a reaction, an acceleration of a mass centre).
"""

from __future__ import annotations

import math
from collections import ChainMap
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from typing import Any, Literal, Self, cast

import numpy as np

from freebody.errors import CannotAnswer, ExpressionError
from freebody.language.expression import (
    FLOAT_FUNCTIONS,
    Call,
    Expr,
    ProductOf,
    Sum,
    Symbol,
    VectorSymbol,
    evaluate,
    free_symbols,
    rate_key,
)
from freebody.language.notation.typeset import dotted
from freebody.language.raising import raised
from freebody.language.sentences import Argument, Sentence
from freebody.language.units import DIMENSIONLESS, FORCE, TIME, Dimension
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm, RigidBody
from freebody.narrative.lines.differences import SymbolValues, value_of
from freebody.numeric.snapshot import Snapshot
from freebody.present.report.blocks import Derivative, Difference, Side
from freebody.questions.base import Quantity
from freebody.questions.event import AskedEvent
from freebody.study.answering.draws import Draw
from freebody.study.answering.magnitude import magnitude
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio
from freebody.tolerances import ROUNDED

TrueWhen = Literal["always", "start", "event", "never"]  # "never": an identity of parameters, true by itself
INTEGRATED = 1e-10  # what is left of a speed after a motion in numbers where it vanishes
N_WORLDS = 4  # random motions at which a line is looked at
ASKED = "symbol.asked"  # the key of what is said of a symbol for what is asked


@dataclass(frozen=True)
class Meaning:
    """What a symbol stands for, and how the numeric route finds its value at an instant."""

    symbol: Expr
    what: Sentence
    read: Quantity | Callable[[World], float]
    unit: str = ""

    def is_answer_to_another(self, new: Meaning) -> bool:
        """Whether it was what an earlier question asked for, and the new one is something else."""
        if self.what.key != ASKED:
            return False
        return new.what.key != ASKED or bool(self.what.args and new.what.args and self.what != new.what)


def unit_of_rate(dimension: Dimension, order: int) -> str:
    """The unit in SI of a measure of a dimension, or of its rate of an order; an angle has none."""
    if dimension == DIMENSIONLESS:
        return raised(f"rad/s^{order}".removesuffix("^1")) if order else ""
    return raised(str(dimension / TIME**order))


class World(SymbolValues):
    """All symbols in numbers for one draw of the parameters at one instant."""

    def __init__(self, glossary: Glossary, draw: Draw, snapshot: Snapshot, origin: Snapshot | None = None) -> None:
        self.glossary = glossary
        self.draw = draw
        self.snapshot = snapshot
        self.origin = origin  # the pose and motion that the snapshot is of
        self.is_integrated = False  # at the end of a motion in numbers
        self.way: Sequence[Snapshot] = ()  # the motion to here, along which angles of lines are counted on
        self._known: dict[str, float] = {}

    @property
    def formulas(self) -> Mapping[str, Expr]:
        return self.glossary.formulas

    @property
    def numbers(self) -> Mapping[int, Any]:
        """Values of the generators that the symbolic route has so far."""
        found = self._numbers_at(self.snapshot)
        return self._counted_on(found) if self.way else found

    def _numbers_at(self, snapshot: Snapshot) -> dict[int, Any]:
        return self.glossary.setup.model.samples.numbers(self.draw.sample(snapshot), self.draw.sample())

    def _counted_on(self, numbers: dict[int, Any]) -> dict[int, Any]:
        """The same with the turns that angles of lines have made on the way."""
        if not self._turns:
            return numbers
        field = self.glossary.setup.model.field
        made = {g for g, x in field.generators.items() if x.compute is not None and x.made_of & self._turns.keys()}
        plain = {g: x for g, x in numbers.items() if g not in made}
        return field.complete(plain | {g: numbers[g] + turned for g, turned in self._turns.items()})

    @cached_property
    def _turns(self) -> dict[int, float]:
        """Whole turns of angles of lines, which a pose does not tell: those of a string that winds round something."""
        model = self.glossary.setup.model
        lines = [c for c in model.coordinates if c.is_angle and model.measure_of(c) is None]
        if not lines:
            return {}
        seen = [self._numbers_at(snapshot) for snapshot in (*self.way, self.snapshot)]
        counted = {c.index: np.unwrap([float(one[c.index]) for one in seen]) for c in lines}
        turned = {g: float(angles[-1]) - float(seen[-1][g]) for g, angles in counted.items()}
        return {g: x for g, x in turned.items() if abs(x) > 1.0}

    def of(self, side: Side) -> tuple[float, ...]:
        """The value of a side of a formula; as many numbers as it has components."""
        if isinstance(side, (Derivative, Difference)):
            return (value_of(side, self),)
        parts = side if isinstance(side, tuple) else (side,)
        if not isinstance(side, tuple) and (names := free_symbols(side) & self.glossary.vectors.keys()):
            return self._components(side, names)
        return tuple(float(evaluate(part, self, FLOAT_FUNCTIONS)) for part in parts)

    def _components(self, side: Expr, names: Collection[str]) -> tuple[float, ...]:
        """Of a formula with vectors, along the axes of the ground."""
        vectors = {name: tuple(self.glossary.vectors[name](self)) for name in names}
        n = min(map(len, vectors.values()))
        each = [ChainMap({name: v[k] for name, v in vectors.items()}, cast("Any", self)) for k in range(n)]
        return tuple(float(evaluate(side, values, FLOAT_FUNCTIONS)) for values in each)

    @cached_property
    def noise(self) -> float:
        """What forces in this motion are known to: round-off of the largest of them."""
        masses, v = self.snapshot.reference.masses, self.snapshot.v
        with suppress(CannotAnswer):
            a = self.snapshot.accelerations
            inertia = max(float(f.max(initial=0.0)) for f in (abs(masses * a), abs(masses * v * v)))
            noise = ROUNDED * max(inertia, magnitude(FORCE, self.snapshot))
            if not self.is_integrated:
                return noise
            start = self.draw.start()  # from rest it is the acceleration that says how fast things are
            seen = (abs(v), abs(a), abs(start.v), abs(self.draw.seen(start).accelerations))
            return max(noise, INTEGRATED * max(float(f.max(initial=0.0)) for f in seen))
        return 0.0

    def forget(self, name: str) -> None:
        """A symbol gets another meaning."""
        self._known.pop(name, None)

    def scale(self, sides: Sequence[Side]) -> float:
        """The largest term in some formulas, by which round-off is judged."""
        largest = 0.0
        for side in sides:
            if isinstance(side, (Derivative, Difference)):
                largest = max(largest, *(abs(float(self[name])) for name in formulas_in(side) if name in self), 0.0)
                continue
            parts: tuple[Expr, ...] = side if isinstance(side, tuple) else (side,)
            largest = max(largest, *map(self._largest_term, parts))
        return largest

    def _largest_term(self, e: Expr) -> float:
        """Of a sum, also of one that stands as a factor in a product: multiplied out, these would be its terms."""
        if isinstance(e, Sum):
            return max(map(self._largest_term, e.terms))
        if isinstance(e, ProductOf):
            return math.prod(map(self._largest_term, e.factors))
        return abs(float(evaluate(e, self, FLOAT_FUNCTIONS)))

    def __getitem__(self, name: str) -> float:
        if name not in self._known:
            self._known[name] = self.glossary.number(name, self)
        return self._known[name]

    def __contains__(self, name: object) -> bool:
        if name in self._known:
            return True
        if not isinstance(name, str):
            return False
        try:
            _ = self[name]
        except KeyError:  # a symbol that has a meaning, but no value at this draw, raises CannotAnswer
            return False
        return True

    def __iter__(self) -> Iterator[str]:
        return iter(self._known)

    def __len__(self) -> int:
        return len(self._known)

    @cached_property
    def generators(self) -> dict[str, float]:
        """Values of what the symbolic route made symbols of (start values, hidden coordinates), by name."""
        found, numbers = dict[str, float](), self.numbers
        for index, generator in self.glossary.setup.model.field.generators.items():
            if index in numbers and isinstance(generator.display, (Symbol, Call)):
                with suppress(ExpressionError):
                    found[rate_key(generator.display)] = float(numbers[index])
        return found


def shown_name(generator: Ratio) -> str:
    """The name by which a generator is written."""
    return rate_key(generator.field.generators[generator.field.index(generator)].display)


def of_centre(body: RigidBody) -> Sentence:
    """Of its mass centre; a particle is nothing else."""
    return Sentence("symbol.of_centre" if body.turns else "symbol.of_particle", {"body": body.name})


def formulas_in(side: Side) -> set[str]:
    """The symbols that are differentiated in a side of a formula."""
    match side:
        case Difference(first, second):
            return formulas_in(first) | formulas_in(second)
        case Derivative(of, _by, _is_partial):
            return formulas_in(of)
        case Symbol(name):
            return {name}
        case _:
            return set()


class Glossary:
    """The symbols of a derivation."""

    def __init__(self, setup: Setup) -> None:
        self.setup = setup
        self.meanings: dict[str, Meaning] = {}
        self.vectors: dict[str, Callable[[World], Sequence[float]]] = {}  # by ground components
        self.formulas: dict[str, Expr] = {}  # checked formulas of symbols that are differentiated
        self.event: AskedEvent | None = None
        self._settled: Ratio | None = None  # where the event is none, but the time grows: by when all is settled
        self._decays: Sequence[tuple[Ratio, ...]] = ()  # and characteristic polynomials of what dies out until then
        self._sides: tuple[Condition, ...] = ()  # on which the motion to it is as formulas have it
        self.is_one: Callable[[World], bool] = lambda _world: True

    def where(self, is_one: Callable[[World], bool]) -> Self:
        """The same symbols, with lines that have to hold only where something is so."""
        made = copy(self)
        made.meanings, made.formulas, made.is_one = dict(self.meanings), dict(self.formulas), is_one
        made.vectors = dict(self.vectors)
        for name, value in [*made.__dict__.items()]:
            if isinstance(value, list) and all(isinstance(world, World) for world in cast("list[object]", value)):
                del made.__dict__[name]  # worlds know the symbols that they were made for
        return made

    def introduce(self, meaning: Meaning) -> Expr:
        """Adds a symbol; one that is known keeps its meaning, unless that was the answer to another question."""
        known = self.meanings.get(rate_key(meaning.symbol))
        if known is not None and known.is_answer_to_another(meaning):
            return self.redefine(meaning)
        self.meanings.setdefault(rate_key(meaning.symbol), meaning)
        return meaning.symbol

    def redefine(self, meaning: Meaning) -> Expr:
        """Gives a symbol its meaning in a new derivation; what it was before is forgotten."""
        key = rate_key(meaning.symbol)
        self.meanings[key] = meaning
        self.formulas.pop(key, None)
        for name in ("_anywhere", "further", "_at_start", "_at_event"):
            for world in self.__dict__.get(name, ()):
                world.forget(key)
        return meaning.symbol

    def introduce_vector(self, symbol: VectorSymbol, what: Sentence, read: Callable[[World], Sequence[float]]) -> None:
        """Gives a vector its meaning, by ground components. As a number it is the largest of these."""
        self.vectors[symbol.name] = read
        self.redefine(Meaning(symbol, what, lambda world: max(map(abs, read(world)))))

    def is_known(self, name: str) -> bool:
        system = self.setup.system
        return name == "t" or any(name in of for of in (self.meanings, system.parameters, self.measures, system.states))

    @cached_property
    def measures(self) -> dict[str, Measure]:
        """What has rates: named measures, and coordinates that are measures."""
        found = dict(self.setup.system.all_measures)
        try:
            model = self.setup.model
        except CannotAnswer:
            return found
        for c in (*model.coordinates, *model.dependent):
            measure = model.measure_of(c)
            if measure is not None:
                found.setdefault(c.name, measure)
        return found

    def unit_of(self, symbol: Side) -> str:
        """The unit in SI of what a symbol or its rate stands for, exponents raised; none for an angle, a pure number
        and what has no name."""
        if not isinstance(symbol, Symbol | Call) or (isinstance(symbol, Call) and symbol.function != "rate"):
            return ""
        name, order = dotted(symbol)
        if name in self.measures:
            return unit_of_rate(self.measures[name].dimension, order)
        if order:
            return ""
        if name == "t":
            return "s"
        unit = self.meanings[name].unit if name in self.meanings else ""
        return "" if unit in ("1", "rad") else raised(unit)

    @cached_property
    def turns(self) -> dict[str, NonholonomicForm]:
        """Coordinates of balls that have nothing but rates: their angular velocities about axes of the ground."""
        if not self.setup.system.unfollowed:
            return {}
        model = self.setup.model
        forms = ((c.name, model.form_of(c)) for c in (*model.coordinates, *model.dependent))
        return {name: form for name, form in forms if isinstance(form, NonholonomicForm)}

    @property
    def start_values(self) -> dict[str, Sentence]:
        """Symbols of start values that follow from the assembly only."""
        try:
            model = self.setup.model
        except CannotAnswer:  # no formulas, no such symbols
            return {}
        found: dict[str, Sentence] = {}
        for row, value in model.constants.items():
            connection, _, component = row.partition(".")
            args: dict[str, Argument] = {"connection": connection, "component": f"@{component}"}
            found[shown_name(value)] = Sentence("symbol.start_of_row", args)
        for c in (*model.coordinates, *model.dependent):
            if c.index in model.samples.start_symbols:
                found[shown_name(model.samples.start_symbols[c.index])] = Sentence(
                    "symbol.start_of", {"name": Symbol(c.name)}
                )
        return found

    # -- numbers ------------------------------------------------------------------------------
    def number(self, name: str, world: World) -> float:
        """The value of a symbol. Raises KeyError for one without a meaning."""
        if name in self.meanings:
            read = self.meanings[name].read
            if callable(read):
                return read(world)
            return float(read.value(self.setup.system, world.snapshot))
        if name == "t":
            return world.snapshot.t
        parameter = self.setup.system.parameters.get(name)
        if parameter is not None and parameter.form is None:
            return world.snapshot.scalar(Symbol(name))
        bare = name.replace("rate(", "").replace(")", "")
        if bare in self.setup.system.states:  # the rate of its integral
            name, bare = f"rate({name})", self.setup.system.states[bare].carrier
        order = name.count("rate(")
        if bare in self.measures:
            read_at = (world.snapshot.value, world.snapshot.rate, world.snapshot.acceleration)
            if order < len(read_at):
                return float(read_at[order](self.measures[bare]))
        if bare in self.turns and order in (1, 2):
            seen = world.snapshot.rate if order == 1 else world.snapshot.acceleration
            return float(seen(self.turns[bare]))
        return world.generators[name]

    def worlds(self, when: TrueWhen) -> Iterator[World]:
        """Draws and instants at which a line has to hold. Those at which it has no real value are passed over by
        `Script`; fewer than two leave it unproved."""
        if when == "event":
            yield from self._at_event
        elif when == "start":
            yield from self._at_start
        else:
            worlds = self._anywhere
            if all(world.draw is draw for world, draw in zip(worlds, self.setup.draws, strict=False)):
                self._keep_on_branch(worlds)
            yield from worlds

    def _keep_on_branch(self, worlds: list[World]) -> None:
        """Motions that formulas made since are not made for are replaced by others."""
        with suppress(CannotAnswer):
            for k, snapshot in enumerate(self.setup.anywhere[: len(worlds)]):
                if worlds[k].origin is not snapshot:
                    worlds[k] = World(self, worlds[k].draw, worlds[k].draw.seen(snapshot), snapshot)

    @cached_property
    def _anywhere(self) -> list[World]:
        try:
            general = self.setup.anywhere
        except CannotAnswer:  # without formulas there is no branch to be on
            general = [draw.anywhere(k, 0.3, 0.1) for k, draw in enumerate(self.setup.draws)]
        pairs = zip(self.setup.draws, general, strict=True)
        worlds = (World(self, draw, draw.seen(snapshot), snapshot) for draw, snapshot in pairs)
        return list(islice(filter(self.is_one, worlds), N_WORLDS))

    @cached_property
    def further(self) -> list[World]:
        """More motions, for lines that say nothing of most of them: closer to the file's values."""
        with suppress(CannotAnswer):
            seen = list(islice(self.setup.anywhere_stream(), N_WORLDS, None))
            return [World(self, draw, draw.seen(snapshot), snapshot) for draw, snapshot in seen]
        return []

    @cached_property
    def _at_start(self) -> list[World]:
        worlds = (World(self, draw, draw.seen(draw.start())) for draw in self.setup.draw_stream())
        return list(islice(filter(self.is_one, worlds), N_WORLDS))

    @cached_property
    def _at_event(self) -> list[World]:
        from freebody.study.answering.crosscheck import element_at, holds
        from freebody.study.answering.evidence import died_out
        from freebody.study.answering.witness import motion_to

        assert self.event is not None
        found: list[World] = []
        for draw in self.setup.draw_stream():
            if len(found) >= N_WORLDS - 1:
                break
            with suppress(CannotAnswer, ArithmeticError, ValueError):
                if not all(holds(self.setup, side, draw, draw.start()) for side in self._sides):
                    continue
                late = 60.0 if self._settled is None else element_at(self.setup, self._settled, draw, draw.start())[0]
                late = max([late, *(died_out(element_at(self.setup, c, draw, draw.start())) for c in self._decays)])
                reached = motion_to(draw.reference, draw.start(), late, self.event)
                world = World(self, draw, draw.seen(reached.event))
                world.is_integrated, world.way = True, reached.links
                if self.is_one(world):
                    found.append(world)
        return found

    def at_event(
        self,
        event: AskedEvent | None,
        settled: Ratio | None = None,
        sides: Sequence[Condition] = (),
        decays: Sequence[tuple[Ratio, ...]] = (),
    ) -> None:
        """From now on "event" means this one. settled: of a time that grows, by when all has come to its limit; sides:
        without which the motion to it is another one; decays: characteristic polynomials of what dies out."""
        if event != self.event:
            self.event, self._settled, self._sides, self._decays = event, settled, tuple(sides), tuple(decays)
            self.__dict__.pop("_at_event", None)
