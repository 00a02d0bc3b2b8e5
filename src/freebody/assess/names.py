"""What an option may name: parameters, measures and coordinates, and the rates of what moves."""

from __future__ import annotations

from freebody.assess.words import unit_behind
from freebody.errors import UnitError
from freebody.language.expression import Call, Expr, Symbol, children, free_symbols, rate_key, substitute
from freebody.language.units import DIMENSIONLESS, LENGTH, TIME, dimension_of
from freebody.measures.base import Measure
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System


class NameTable:
    """The elements and the dimensions behind the names of a problem."""

    def __init__(self, model: SymbolicModel, system: System) -> None:
        self._model = model
        self._system = system
        self._elements = dict(model.parameters)
        self._moving: dict[str, Measure | Ratio] = dict(system.offered)
        self.dimensions = {name: m.dimension for name, m in system.offered} | {"t": TIME}
        self._moving |= system.measures
        # a measure that is a coordinate is its generator, not the arc of a sine that the geometry has
        for c in (*model.dependent, *model.coordinates):
            self._moving[c.name] = model.field.variable(c.index)
            self.dimensions[c.name] = DIMENSIONLESS if c.is_angle else LENGTH
        self._functions = {p.name: self._elements[p.name] for p in system.parameters.values() if p.form is not None}
        self.dimensions |= system.dimensions()
        for c in model.coordinates:
            if c.index in model.samples.start_symbols:
                self._elements[f"{c.name}_0"] = model.samples.start_symbols[c.index]
                self.dimensions[f"{c.name}_0"] = self.dimensions[c.name]

    @property
    def all_names(self) -> list[str]:
        """What may stand in an answer: parameters, measures, coordinates and their start values."""
        return list(self.dimensions)

    def __contains__(self, key: str) -> bool:
        if key in self._elements or key in self._moving or _rated(key) in self._moving:
            return True
        while rated := _rated(key):
            key = rated
        return key in self._functions

    def element(self, key: str) -> Ratio:
        """The element of a name or of "rate(name)"."""
        if key not in self._elements:
            if key in self._moving:
                known = self._moving[key]
                own = known if isinstance(known, Ratio) else known.value(self._model.geometry)
            else:
                own = self.rate(self.element(_rated(key)))
            self._elements[key] = own
        return self._elements[key]

    def rate(self, x: Ratio) -> Ratio:
        """Total time derivative in the independent speeds, so that numbers for these fit each other."""
        return self._model.in_independent_speeds(self._model.rate(x))

    def with_rates(self, expr: Expr) -> Expr:
        """x_dot, where nothing is called so, is the rate of x; shorthands are what they are short for."""
        expr = self._system.names.in_parameters(expr)
        dotted = {
            name: Call("rate", Symbol(name[:-4]))
            for name in free_symbols(expr)
            if name.endswith("_dot") and name not in self and name[:-4] in self._moving
        }
        return substitute(expr, dotted) if dotted else expr

    def unit(self, shown: Expr) -> str:
        """The unit behind a number, with the space before it."""
        try:
            dimension = dimension_of(shown, self.dimensions)
        except UnitError:
            return ""
        return unit_behind(dimension)


def _rated(key: str) -> str:
    """x of "rate(x)", else nothing."""
    return key[5:-1] if key.startswith("rate(") else ""


def named_in(expr: Expr) -> dict[str, Expr]:
    """The names for which `evaluate` wants values, and how they were written, in order."""
    match expr:
        case Symbol("pi"):
            return {}
        case Symbol(name):
            return {name: expr}
        case Call("rate", _):
            return {rate_key(expr): expr}
        case _:
            found: dict[str, Expr] = {}
            for part in children(expr):
                found |= named_in(part)
            return found
