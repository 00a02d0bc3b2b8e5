"""The equations of motion of one copy, from the symbolic route.

    q' = u,     q'_d = B u + b,     M(q) u' = F(q, u, t)

with independent coordinates q and speeds u, and the coordinates q_d that closed loops and rolling bind, which are
integrated beside them. M is factored as L D L^T, entry by entry. Where the start of a coordinate has no formula in the
parameters (the loops of a four-bar), it is a parameter of its own, and the numeric route assembles each case for it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from threading import Lock

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, free_symbols
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.ensemble.copies import Copies, CopyGraph, Extreme
from freebody.study.answering.draws import Draw
from freebody.study.setup import Setup
from freebody.study.sweeps.ensembles.nodes import Known, NodesOfField
from freebody.study.sweeps.records.base import Seen, rate_of
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate
from freebody.system.system import System

_SINGULAR = 1e-9  # the least eigenvalue of a scaled matrix
_ARCS = ("asin", "acos", "atan")


@dataclass(frozen=True)
class SeriesOfCopies:
    """What a series of a motion is: a measure, differentiated as often as `order` says."""

    measure: str
    order: int


def series_of(system: System, name: str) -> SeriesOfCopies | None:
    """The measure of a series, if it is one."""
    for suffix, order in (("_acceleration", 2), ("_rate", 1), ("", 0)):
        measure = name.removesuffix(suffix) if suffix else name
        if name.endswith(suffix) and measure in system.measures:
            return SeriesOfCopies(measure, order)
    return None


class EquationsOfCopies:
    """What is the same for all copies of a model. Raises CannotAnswer where the symbolic route has no equations, or
    something in them is not smooth."""

    def __init__(self, system: System, varied: Sequence[str]) -> None:
        self.system, self.varied = system, tuple(varied)
        self.setup, self._one_by_one = Setup(system, 3), Lock()
        self.model = self.setup.model
        self.field = self.model.field
        self.places: tuple[Coordinate, ...] = (*self.model.coordinates, *self.model.dependent)
        if not self.places:
            raise CannotAnswer(Message("there are no degrees of freedom, hence no equations of motion to integrate"))
        self.states = [c.index for c in self.places] + [c.speed for c in self.model.coordinates]
        self._started = self._start_formulas()
        self.open = [k for k in self.states if k not in self._started]
        constants = [self.field.index(g) for g in self.model.constants.values()]
        self.open += [k for k in constants if not self._is_told(self.model.given_constants.get(k))]
        self.graph = CopyGraph(len(self.states), len(self.varied) + len(self.open))
        at = len(self.varied)
        self._open_nodes = {k: self.graph.parameters[at + i] for i, k in enumerate(self.open)}
        clock = self.field.index(self.field.time)
        self._nodes = NodesOfField(self.field, self.graph, self._still() | self._moving())
        self._at_start = NodesOfField(self.field, self.graph, self._still())
        zero = self.graph.constant(0.0)
        self._at_start.add({clock: lambda: zero} | self._in_time(self._at_start, zero))
        self._nodes.add({clock: lambda: self.graph.time} | self._in_time(self._nodes, self.graph.time))

    # -- the start ----------------------------------------------------------------------------
    def _start_formulas(self) -> dict[int, Ratio]:
        """The entries of the state whose start has a formula in the parameters."""
        with suppress(CannotAnswer, ZeroDivisionError):
            values = self.setup.start.values
            return {k: values[k] for k in self.states if self._is_told(values.get(k))}
        return {}

    def _is_told(self, x: Ratio | None) -> bool:
        """Whether an element is made of parameters of the model alone."""
        if x is None:
            return False
        f = self.field
        own = {f.index(g) for g in self.model.parameters.values()} | set(self.model.functions_of_time)
        return all(k in own or f.generators[k].compute is not None for k in f.ingredients(x))

    def given(self, values: Mapping[str, float]) -> list[float]:
        """What stands for the starts without a formula in one case. Raises CannotAnswer where it does not assemble."""
        everything = {p.name: p.value for p in self.system.parameters.values() if p.value is not None}
        draw = Draw.of(self.system, {**everything, **values})
        sample = draw.sample(draw.start())
        with self._one_by_one:  # elements keep their terms in the field
            numbers = self.model.samples.numbers(sample)
        return [float(numbers[k]) for k in self.open]

    # -- nodes of generators ------------------------------------------------------------------
    def _still(self) -> dict[int, Known]:
        """Those that do not move: parameters, start values without a formula, what incremental measures count from."""
        found: dict[int, Known] = {}
        for name, g in self.model.parameters.items():
            if name != "t" and self.field.index(g) not in self.model.functions_of_time:
                found[self.field.index(g)] = self._parameter(name)
        for k in self.model.given_constants:
            found[k] = lambda k=k: self._at_start.of(self.model.given_constants[k])
        return found | {k: lambda k=k: self._open_nodes[k] for k in self.open if k not in self.states}

    def _in_time(self, nodes: NodesOfField, time: ProgramNode) -> dict[int, Known]:
        """Given functions of time and their rates, at a time."""

        def node(form: Expr) -> ProgramNode:
            names = free_symbols(form) - {"pi", "t"}
            return nodes.expression(form, {"t": time} | {name: self._parameter(name)() for name in names})

        return {k: lambda form=form: node(form) for k, form in self.model.functions_of_time.items()}

    def _parameter(self, name: str) -> Known:
        def node() -> ProgramNode:
            if name in self.varied:
                return self.graph.parameters[self.varied.index(name)]
            value = self.system.parameters[name].value
            if value is None:
                raise CannotAnswer(Message("{name} has no value; give it one, or vary it", name=name))
            return self.graph.constant(value)

        return node

    def _moving(self) -> dict[int, Known]:
        """Coordinates, speeds and accelerations."""
        found: dict[int, Known] = {k: lambda i=i: self.graph.states[i] for i, k in enumerate(self.states)}
        bound = {c.speed: c for c in self.model.dependent}
        found |= {k: lambda c=c: self._nodes.of(self.model.dependent_speed(c)) for k, c in bound.items()}
        return found | {k: lambda i=i: self._accelerations[i] for i, k in enumerate(self.model.accelerations)}

    @cached_property
    def _accelerations(self) -> list[ProgramNode]:
        """M u' = F by L D L^T."""
        dynamics, n = self.model.dynamics, len(self.model.coordinates)
        self._check_inertia(dynamics.mass_matrix)
        self._check_smooth([x for row in dynamics.mass_matrix for x in row] + list(dynamics.forcing))
        M = [[self._nodes.of(x) for x in row] for row in dynamics.mass_matrix]
        L = [[self.graph.constant(0.0)] * n for _ in range(n)]
        D, x = list[ProgramNode](), [self._nodes.of(force) for force in dynamics.forcing]
        for j in range(n):
            d = M[j][j]
            for k in range(j):
                d = d - L[j][k] * L[j][k] * D[k]
            D.append(d)
            per = 1.0 / d
            for i in range(j + 1, n):
                rest = M[i][j]
                for k in range(j):
                    rest = rest - L[i][k] * (L[j][k] * D[k])
                L[i][j] = rest * per
                x[i] = x[i] - L[i][j] * x[j]
        for i in reversed(range(n)):
            x[i] = x[i] * (1.0 / D[i])
            for k in range(i + 1, n):
                x[i] = x[i] - L[k][i] * x[k]
        return x

    def _check_inertia(self, mass_matrix: Sequence[Sequence[Ratio]]) -> None:
        """Raises CannotAnswer where something moves without inertia: M is singular at all samples then. It is scaled to
        ones on its diagonal, so that it is so in any units."""
        n, samples = len(mass_matrix), self.model.samples
        if n == 0:
            return
        at = np.array([[samples.everywhere(x) for x in row] for row in mass_matrix]).reshape(n, n, -1)
        for k in range(at.shape[2]):
            M = at[:, :, k]
            if np.isfinite(M).all() and (np.diag(M) > 0.0).all():
                unit = 1.0 / np.sqrt(np.diag(M))
                if np.linalg.eigvalsh(M * np.outer(unit, unit))[0] > _SINGULAR:
                    return
        raise CannotAnswer(Message("something moves without inertia, so its acceleration is not determined"))

    # -- what is looked at --------------------------------------------------------------------
    def series(self, name: str) -> SeriesOfCopies:
        """A series, which must be one of a measure."""
        found = series_of(self.system, name)
        assert found is not None
        return found

    def size_of(self, name: str) -> float:
        """That of the system in the unit of the measure of a series."""
        dimension = self.system.measures[self.series(name).measure].dimension
        return float(self.setup.draws[0].reference.sizes.length ** float(dimension.length))

    def element(self, name: str) -> Ratio:
        """A series as an element. Raises CannotAnswer for an angle that turns are counted of."""
        series = self.series(name)
        x = self.model.value_of(self.system.measures[series.measure])
        for _ in range(series.order):
            x = self.model.rate(x)
        self._check_smooth([x])
        return x

    def _check_smooth(self, elements: Iterable[Ratio]) -> None:
        """Raises CannotAnswer for what jumps, and for angles of which turns would have to be counted."""
        f = self.field
        for k in sorted(set[int]().union(*(f.ingredients(x) for x in elements))):
            if f.is_constant_generator(k):
                continue
            name, shown = f.arguments[k][0] if k in f.arguments else "", to_text(f.generators[k].display)
            if name == "sign":
                raise CannotAnswer(Message("{x} is discontinuous", x=shown))
            if k in f.known_pairs or name in _ARCS:
                raise CannotAnswer(
                    Message("{x} is an angle but not a coordinate, so its full turns cannot be counted", x=shown)
                )

    # -- all of it ----------------------------------------------------------------------------
    def copies(self, watched: Sequence[str], extremes: Sequence[Seen]) -> Copies:
        """Copies of which some series are looked at, and extremes of others."""
        length = float(self.setup.draws[0].reference.sizes.length)
        units = [1.0 if c.is_angle else length for c in self.places]
        units += [1.0 if c.is_angle else length for c in self.model.coordinates]
        speeds = [self._nodes[c.speed] for c in self.places]
        assumed = [self.model.express(x) for x in self.model.samples.assumed]
        loops = [loop.value for loop in self.model.loops]
        self._check_smooth([*assumed, *loops, *(self.model.dependent_speed(c) for c in self.model.dependent)])
        of = self._nodes.of
        return Copies(
            self.graph,
            [self._at_start.of(self._started[k]) if k in self._started else self._open_nodes[k] for k in self.states],
            [*speeds, *self._accelerations],
            units,
            [False] * len(self.places) + [True] * len(self.model.coordinates),
            [of(self.element(name)) for name in watched],
            [Extreme(of(self.element(e.series)), of(self.element(rate_of(e.series))), e.side) for e in extremes],
            [of(x) for x in assumed],
            [of(loop.value) * (1.0 / self._size_of(loop.name, length)) for loop in self.model.loops],
        )

    def _size_of(self, row: str, length: float) -> float:
        for one in self.model.system.constraint_rows:
            if one.name == row and one.measure.dimension != LENGTH:
                return 1.0
        return length
