"""Many random parameter sets at once: which branch of a case distinction is taken by which of them.

Coefficients of friction are drawn between 0 and 1.2, of restitution between 0 and 1, acute angles over their range,
everything else within a factor of four of the file's value (of 1 where there is none); behind these come sets over
up to five decades, for what is rare. The first set is that of the file where it gives all values.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.language.expression import ELLIPTIC, FLOAT_FUNCTIONS, FRESNEL, LAMBERT, free_symbols
from freebody.language.units import DIMENSIONLESS
from freebody.model.elements import Parameter
from freebody.numeric.jets import Array
from freebody.symbolic.conditions import Condition
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import SolvedRelation
from freebody.system.system import System
from freebody.tolerances import ROUNDED

Chosen = NDArray[np.intp]  # indices of parameter sets
Mask = NDArray[np.bool_]

N_SETS = 400
N_WIDE = 600
_SEED = 11
_SPREAD = 1.4
_MOST_FRICTION = 1.2
_NEXT_TO_BRANCH_POINT = 1e-6  # 1 + W has some ten digits there
_WIDEST = 5.8  # e^5.8: two decades and a half


def _of_floats(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function of arrays that takes whole numbers of any length too, which NumPy would keep as objects."""
    return lambda *arguments: function(*(np.asarray(a, dtype=np.float64) for a in arguments))


def _or_nan(name: str) -> Callable[..., float]:
    """A function of floats, nan where it is not real."""

    def function(*arguments: float) -> float:
        try:
            return float(FLOAT_FUNCTIONS[name](*arguments))
        except (ValueError, OverflowError):
            return math.nan

    return function


_FUNCTIONS = SimpleNamespace(
    pi=math.pi,
    **{name: _of_floats(getattr(np, name)) for name in ("sqrt", "cos", "sin", "exp", "log", "sinh", "cosh", "tanh")},
    acos=_of_floats(np.arccos),
    asin=_of_floats(np.arcsin),
    atan=_of_floats(np.arctan),
    atan2=_of_floats(np.arctan2),
    **{name: _of_floats(np.vectorize(_or_nan(name), otypes=[float])) for name in (*FRESNEL, *ELLIPTIC, *LAMBERT)},
)


def coefficients_of_friction(system: System) -> tuple[str, ...]:
    """Parameters that are coefficients of friction, in order of declaration."""
    used: set[str] = set()
    for rub in system.dry_friction:
        for expr in (rub.static, rub.kinetic, rub.static_back, rub.kinetic_back):
            used |= set() if expr is None else free_symbols(expr)
    return tuple(n for n, p in system.parameters.items() if n in used and p.dimension == DIMENSIONLESS)


def _far(p: Parameter, center: float, share: Array, width: Array) -> Array:
    """Values over up to five decades; angles no farther than they are drawn near. share: from -1 to 1."""
    if p.acute:
        near = 0.5 * math.pi * 10.0 ** (-3.0 * np.abs(share))
        return np.where(share > 0, near, 0.5 * math.pi - near)
    return (center or 1.0) * np.exp(share * (np.minimum(width, _SPREAD) if p.is_angle else width))


def holds(r: SolvedRelation | Condition, numbers: Array) -> Mask:
    """Where a relation is satisfied, by the values of its element. One that was solved is turned where its divisor is
    negative; the element is not."""
    if r.relation in ("=", "!="):
        return (numbers == 0) == (r.relation == "=")
    with np.errstate(invalid="ignore"):
        return numbers >= 0 if r.relation in (">=", "<=") else numbers > 0


class Sets:
    """Parameter sets as arrays, by name. Pairs of static and kinetic coefficients are drawn in their order."""

    def __init__(self, system: System, n: int = N_SETS, n_wide: int = N_WIDE) -> None:
        rng = np.random.default_rng(_SEED)
        friction = set(coefficients_of_friction(system))
        self.values: dict[str, Array] = {}
        width = np.random.default_rng(_SEED + 1).uniform(0.0, _WIDEST, n_wide)
        wide = np.random.default_rng(_SEED + 2)
        for p in system.parameters.values():
            if p.form is not None:
                continue
            center = 1.0 if p.value is None else p.value
            if p.acute:
                drawn = rng.uniform(0.03, math.pi / 2 - 0.03, n)
            elif p.name in friction:
                drawn = rng.uniform(0.0, _MOST_FRICTION, n)
            elif p.is_share:
                drawn = rng.uniform(0.02, 0.98, n)
            else:
                drawn = (center or 1.0) * np.exp(rng.uniform(-_SPREAD, _SPREAD, n))
                if p.sign == "any":
                    drawn = drawn * rng.choice((-1.0, 1.0), n)
            if p.value is not None:
                drawn[0] = p.value
                if p.sign == "any" or p.acute or n < 2:
                    drawn[1 : n // 8] = p.value
            share = wide.uniform(-1.0, 1.0, n_wide)
            if p.name in friction:
                far = 10.0 ** (2.0 * share - 1.0)
            elif p.is_share:
                far = 0.5 + 0.499 * share
            else:
                far = _far(p, center, share, width) * (wide.choice((-1.0, 1.0), n_wide) if p.sign == "any" else 1.0)
            self.values[p.name] = np.concatenate([drawn, far])
        for rub in system.dry_friction:
            pairs = ((rub.static, rub.kinetic), (rub.static_back, rub.kinetic_back))
            for static, kinetic in pairs:
                s, k = str(getattr(static, "name", "")), str(getattr(kinetic, "name", ""))
                if s != k and s in self.values and k in self.values:
                    low, high = np.minimum(self.values[s], self.values[k]), np.maximum(self.values[s], self.values[k])
                    self.values[s], self.values[k] = high, low
        self.n, self.n_near = n + n_wide, n
        self.left_out = np.zeros(self.n, dtype=bool)  # sets whose numbers are too near a border to tell
        self.constants: dict[str, Array] = {}  # start values that a model has symbols for
        self._known: dict[int, tuple[int, dict[int, Any]]] = {}
        self._models: list[SymbolicModel] = []  # keeps the keys above alive

    def at(self, values: dict[str, Array]) -> Sets:
        """Other sets, of which all values are given."""
        other = object.__new__(Sets)
        other.values, other.n = values, len(next(iter(values.values())))
        other.n_near, other.left_out = other.n, np.zeros(other.n, dtype=bool)
        other._known, other._models, other.constants = {}, [], {}
        return other

    def evaluate(self, model: SymbolicModel, x: Ratio, more: dict[int, Any] | None = None) -> Array:
        """An element of the parameters (and of what `more` gives) in all sets; nan where it has no real value."""
        with np.errstate(all="ignore"):
            values: Mapping[int, Any] = self._numbers(model)
            if more is not None:  # what was computed without it does not depend on it
                known = values if more.keys().isdisjoint(values) else self._plain(model)
                values = model.field.when_asked({**known, **more}, _FUNCTIONS)
            try:
                found = np.asarray(model.field.evaluate(x, values), dtype=np.float64)
            except (KeyError, ZeroDivisionError, OverflowError):
                return np.full(self.n, np.nan)
        return found if found.ndim else np.full(self.n, float(found))

    def loses_digits(self, model: SymbolicModel, x: Ratio) -> Mask:
        """Where a branch of Lambert's W stands in an element and its argument is next to -1/e, as without a drag: 1 + W
        has few digits there, and what is left of it none."""
        found, f = np.zeros(self.n, dtype=bool), model.field
        for g in f.ingredients(x) & f.arguments.keys():
            name, argument = f.arguments[g]
            if name in LAMBERT:
                with np.errstate(invalid="ignore", over="ignore"):
                    found |= np.abs(1.0 + math.e * self.evaluate(model, argument)) < _NEXT_TO_BRANCH_POINT
        return found

    def vanishes(self, model: SymbolicModel, x: Ratio, k: int) -> bool:
        """Whether an element is zero in one of the sets, or round-off of its terms."""
        inside = model.field.ingredients(x) | x.generators()
        known = {g: float(np.broadcast_to(v, self.n)[k]) for g, v in self._numbers(model).items() if g in inside}
        return model.field.vanishes_at(x, known, ROUNDED)

    def points_of(self, model: SymbolicModel) -> Points:
        """The sets as points of the field of a model."""
        return Points(self, model)

    def _plain(self, model: SymbolicModel) -> dict[int, Any]:
        values: dict[int, Any] = {}
        for name, drawn in self.values.items():
            if name in model.parameters:
                values[model.field.index(model.parameters[name])] = drawn
        for generator in model.constants.values():
            shown = getattr(model.field.generators[model.field.index(generator)].display, "name", "")
            if shown in self.constants:
                values[model.field.index(generator)] = self.constants[shown]
        return values

    def _numbers(self, model: SymbolicModel) -> dict[int, Any]:
        n_known, values = self._known.get(id(model), (0, {}))
        if n_known != len(model.field.generators):
            if not n_known:
                self._models.append(model)
            values = model.field.complete(values or self._plain(model), _FUNCTIONS)
            self._known[id(model)] = len(model.field.generators), values
        return values

    def one(self, k: int) -> dict[str, float]:
        """One of the sets."""
        return {name: float(v[k]) for name, v in self.values.items()}

    def some(self, indices: Sequence[int] | Chosen, n: int) -> list[dict[str, float]]:
        return [self.one(int(k)) for k in indices[:n]]


@dataclass(frozen=True)
class Points:
    """Parameter sets as points of the field of a model, at which signs are looked at."""

    sets: Sets
    model: SymbolicModel

    def evaluate(self, x: Ratio) -> Array:
        """An element in all sets; nan where it has no real value."""
        return self.sets.evaluate(self.model, x)

    def numbers(self, k: int) -> dict[int, float]:
        """The parameters of one set, by generators."""
        field, known = self.model.field, self.model.parameters
        values = {name: float(v[k]) for name, v in self.sets.values.items() if name in known}
        return {field.index(known[name]): value for name, value in values.items()}
