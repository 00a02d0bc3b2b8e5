"""Accelerations and velocities of bodies in the symbols a person would use.

A mass centre that moves along the direction of a named measure has the acceleration x''; a body whose angle is named w
has w''. What is left gets symbols of its own: a_rod_x, alpha_rod, v_rod_x, omega_rod. Each symbol comes with what it is
in the coordinates, which the derivation states as a line before it is used.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Sentence
from freebody.measures.angle import Angle
from freebody.measures.geometry import RIGHT, UP, Direction
from freebody.narrative.lines.glossary import Glossary, Meaning, World, of_centre
from freebody.narrative.principles.acting import Slot
from freebody.narrative.principles.sides import scaled
from freebody.narrative.principles.slanted import direction_words
from freebody.questions.motion import OfMeasure, OfPoint, rates_of
from freebody.questions.vectors import place
from freebody.symbolic.field import Generator
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

Order = Literal[1, 2]
Pair = tuple[Ratio, Ratio]
_LETTERS = {1: ("v", "omega"), 2: ("a", "alpha")}
_UNITS = {1: ("m/s", "rad/s"), 2: ("m/s^2", "rad/s^2")}


@dataclass(frozen=True)
class Term:
    """coefficient * symbol: a part of an acceleration or velocity. explicit: the symbol in the coordinates; what
    `generator` stands for in the field."""

    coefficient: Ratio
    symbol: Expr
    generator: Ratio
    explicit: Ratio
    body: str
    is_turning: bool

    @property
    def is_plain(self) -> bool:
        """Whether the symbol is the rate of a coordinate itself and needs no explanation."""
        return (self.generator - self.explicit).is_zero()

    @property
    def expression(self) -> Expr:
        return scaled(self.coefficient, self.symbol)


@dataclass(frozen=True)
class _Own:
    """A measure of one body alone: its name and its gradient."""

    name: str
    x: Ratio
    y: Ratio
    angle: Ratio


class Kinematics:
    """Symbols for the motion of the bodies of a system in the plane."""

    def __init__(self, model: SymbolicModel, glossary: Glossary) -> None:
        self.model, self.system = model, model.system
        self.glossary = glossary
        self._own: dict[str, list[_Own]] = {}
        self._slanted: dict[str, list[Pair]] = {}  # directions by body for which there are symbols

    # -- named measures -----------------------------------------------------------------------
    def own(self, body: str) -> list[_Own]:
        """Measures that depend on one body alone, linearly."""
        if body not in self._own:
            f, found = self.model.field, list[_Own]()
            for name, measure in self.glossary.measures.items():
                slopes = self.model.gradient(measure)
                if {b for b, _slot in slopes if not self.system.bodies[b].fixed} == {body}:
                    parts = [slopes.get((body, slot), f.zero) for slot in ("x", "y", "angle")]
                    if all(p.is_constant() for p in parts):
                        found.append(_Own(name, *parts))
            self._own[body] = found
        return self._own[body]

    def _rates(self, order: Order) -> Mapping[str, tuple[Ratio, ...]]:
        return self.model.kinematics.velocities if order == 1 else self.model.kinematics.body_accelerations

    # -- turning ------------------------------------------------------------------------------
    def turning(self, body: str, order: Order) -> Term | None:
        """Angular velocity or acceleration of a body; None where it does not turn."""
        explicit = self._rates(order)[body][2]
        if self.model.samples.vanishes(explicit):
            return None
        for own in self.own(body):
            if own.x.is_zero() and own.y.is_zero() and (own.angle * own.angle - 1).is_zero():
                symbol = rates_of(own.name, order)
                return self._term(own.angle, symbol, own.angle * explicit, body, order, is_turning=True)
        name = f"{_LETTERS[order][1]}_{body}"
        self.glossary.introduce(
            Meaning(
                Symbol(name),
                Sentence(f"symbol.turning_{order}", {"body": body}),
                OfMeasure(Angle(body), order, body),
                _UNITS[order][1],
            )
        )
        return self._term(self.model.field.one, Symbol(name), explicit, body, order, is_turning=True)

    # -- translation --------------------------------------------------------------------------
    def along(self, body: str, vector: Pair, order: Order, label: str = "") -> list[Term]:
        """The component of a mass centre's velocity or acceleration along a vector, as terms; the vector need not be of
        length one."""
        x, y, _w = self._rates(order)[body]
        explicit = vector[0] * x + vector[1] * y
        if self.model.samples.vanishes(explicit):
            return []
        for own in self.own(body):
            # (x, y) = c (own.x, own.y) along the measure, whose rate is own . v
            if own.angle.is_zero() and (own.x * vector[1] - own.y * vector[0]).is_zero():
                square = own.x * own.x + own.y * own.y
                c = (vector[0] * own.x + vector[1] * own.y) / square
                return [self._term(c, rates_of(own.name, order), explicit / c, body, order)]
        straight = self._straight(body, order)
        if straight is not None:
            own, direction = straight
            c = vector[0] * direction[0] + vector[1] * direction[1]
            return [self._term(c, rates_of(own.name, order), explicit / c, body, order)]
        if not (vector[0].is_zero() or vector[1].is_zero()):
            across = self._in_direction(body, vector, explicit, order)
            if across is not None:
                return [across]
        found: list[Term] = []
        for component, axis, direction, part in ((vector[0], "x", RIGHT, x), (vector[1], "y", UP, y)):
            if component.is_zero() or self.model.samples.vanishes(part):
                continue
            same = next((o for o in self.own(body) if o.angle.is_zero() and _is_axis(o, axis)), None)
            if same is not None:
                sign = same.x if axis == "x" else same.y
                found.append(self._term(component * sign, rates_of(same.name, order), sign * part, body, order))
            else:
                found.append(self._component(component, body, axis, direction, part, order))
        return found

    def _in_direction(self, body: str, vector: Pair, explicit: Ratio, order: Order) -> Term | None:
        """A symbol for the component along a slanted direction, the same for both senses of it; None where its length
        is a root."""
        f = self.model.field
        size = f.sqrt(f.lowest_terms(vector[0] * vector[0] + vector[1] * vector[1]), self.model.samples.is_negative)
        if any(f.generators[g].kind == "root" for g in size.generators()) or size.is_zero():
            return None
        unit = f.lowest_terms(vector[0] / size), f.lowest_terms(vector[1] / size)
        mine = self._slanted.setdefault(body, [])
        for k, (x, y) in enumerate(mine):
            if (unit[0] * y - unit[1] * x).is_zero():
                sense = f.lowest_terms(unit[0] * x + unit[1] * y)
                return self._slanted_term(body, k, sense * size, explicit / (sense * size), order)
        mine.append(unit)
        return self._slanted_term(body, len(mine) - 1, size, explicit / size, order)

    def _slanted_term(self, body: str, k: int, coefficient: Ratio, explicit: Ratio, order: Order) -> Term:
        unit, first = self._slanted[body][k], self._slanted[body][0]
        letters = "ntuw" if self._beside_path(body, first) == "normal" else "tnuw"
        name = f"{_LETTERS[order][0]}_{body}_{letters[k % 4]}{k // 4 or ''}"
        model, center = self.model, self.system.bodies[body].mass_center

        def read(world: World) -> float:
            numbers = world.numbers
            along = [float(model.field.evaluate(u, numbers)) for u in unit]
            x, y = place(self.system, world.snapshot, center, order)
            return float(along[0] * x + along[1] * y)

        kind = self._beside_path(body, unit)
        what = Sentence(
            f"symbol.{kind}_{order}",
            {"of": of_centre(self.system.bodies[body]), "along": direction_words(*map(tidy, unit))},
        )
        self.glossary.introduce(Meaning(Symbol(name), what, read, _UNITS[order][0]))
        return self._term(coefficient, Symbol(name), explicit, body, order)

    def _beside_path(self, body: str, unit: Pair) -> str:
        """Whether a direction is that in which a mass centre moves, or normal to it: v x e = 0, v . e = 0."""
        x, y, _w = self.model.kinematics.velocities[body]
        if self.model.samples.vanishes(self.model.field.lowest_terms(x * unit[1] - y * unit[0])):
            return "tangential"
        if self.model.samples.vanishes(self.model.field.lowest_terms(x * unit[0] + y * unit[1])):
            return "normal"
        return "slanted"

    def _straight(self, body: str, order: Order) -> tuple[_Own, Pair] | None:
        """The named measure along which a mass centre moves on a straight line."""
        x, y, _w = self._rates(order)[body]
        for own in self.own(body):
            is_unit = (own.x * own.x + own.y * own.y - 1).is_zero()
            if own.angle.is_zero() and is_unit and self.model.samples.vanishes(own.x * y - own.y * x):
                return own, (own.x, own.y)
        return None

    def _component(
        self, coefficient: Ratio, body: str, axis: str, direction: Direction, explicit: Ratio, order: Order
    ) -> Term:
        name = f"{_LETTERS[order][0]}_{body}_{axis}"
        center = self.system.bodies[body].mass_center
        self.glossary.introduce(
            Meaning(
                Symbol(name),
                Sentence(
                    f"symbol.component_{order}", {"of": of_centre(self.system.bodies[body]), "axis": f"@axis.{axis}"}
                ),
                OfPoint(center, order, direction),
                _UNITS[order][0],
            )
        )
        return self._term(coefficient, Symbol(name), explicit, body, order)

    def _term(
        self, coefficient: Ratio, symbol: Expr, explicit: Ratio, body: str, order: Order, *, is_turning: bool = False
    ) -> Term:
        f = self.model.field
        explicit = f.lowest_terms(explicit)
        for index in explicit.generators():
            if f.generators[index].display == symbol:
                return Term(coefficient, symbol, f.variable(index), explicit, body, is_turning)
        kind = "speed" if order == 1 else "acceleration"
        generator = f.generator(Generator(symbol, kind), key=("told", symbol))
        return Term(coefficient, symbol, generator, explicit, body, is_turning)

    # -- constraints --------------------------------------------------------------------------
    def velocity_form(self, row_slopes: dict[Slot, Ratio]) -> list[Term]:
        """sum of slope * velocity over the bodies of a row, without what is at rest."""
        f, found = self.model.field, list[Term]()
        for body in dict.fromkeys(b for b, _slot in row_slopes):
            if body not in self.model.kinematics.velocities:
                continue
            vector = row_slopes.get((body, "x"), f.zero), row_slopes.get((body, "y"), f.zero)
            if not (vector[0].is_zero() and vector[1].is_zero()):
                found += self.along(body, vector, 1)
            slope = row_slopes.get((body, "angle"), f.zero)
            turning = None if slope.is_zero() else self.turning(body, 1)
            if turning is not None:
                found.append(
                    Term(slope * turning.coefficient, turning.symbol, turning.generator, turning.explicit, body, True)
                )
        return found


def _is_axis(own: _Own, axis: str) -> bool:
    return (own.y if axis == "x" else own.x).is_zero()


def total(terms: Sequence[Term], zero: Ratio) -> Ratio:
    """The sum of terms as an element, in the coordinates."""
    result = zero
    for term in terms:
        result = result + term.coefficient * term.explicit
    return result
