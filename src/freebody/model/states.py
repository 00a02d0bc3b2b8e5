"""States of controllers: what is integrated beside the motion, z' = f(measures, their rates, states, t).

A state is the rate of a coordinate of its own, its integral Z: with a unit inertia and f as what drives it,
Newton's law of that coordinate is Z'' = z' = f. Nothing depends on Z, which is cyclic; so a system with states is a
system like any other to both routes, and what makes it steady and stable follows as for cyclic coordinates (Routh).
What people see of it is the state: it has no mass, no place, no energy and no degree of freedom. Source: Franklin,
Powell & Emami-Naeini, Feedback Control of Dynamic Systems, ch. 4 and 7 (integral control, state-space form).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from freebody.language.expression import ONE, Call, Expr, Symbol, free_symbols, replace_rates, substitute
from freebody.language.units import TIME, Dimension
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, RIGHT, ZERO, Components, Direction, Point
from freebody.model.elements import AppliedLoad, ConstraintRow, RigidBody

_INTEGRAL = "∫"  # no user can type a name that begins so


def integral_name(state: str) -> str:
    """What the integral of a state is called, and all that carries it."""
    return f"{_INTEGRAL}{state}"


def state_name(name: str) -> str:
    """The state whose integral has this name; nothing for other names."""
    return name.removeprefix(_INTEGRAL) if name.startswith(_INTEGRAL) else ""


def shown_rate(name: str) -> Expr:
    """The rate of a coordinate as people see it: of the integral of a state the state itself."""
    return Symbol(state_name(name)) if state_name(name) else Call("rate", Symbol(name))


@dataclass(frozen=True)
class ControllerState:
    """A state: its dimension, its rate as a law in `measures`, the integrals of states among them, and its value at the
    start. origin: the components of zero. is_place: for statics the state itself is the coordinate."""

    name: str
    dimension: Dimension
    rate: Expr
    origin: Components
    measures: tuple[tuple[str, Measure], ...] = ()  # in its rate
    start: Expr = ZERO
    is_place: bool = False

    @property
    def carrier(self) -> str:
        return integral_name(self.name)

    @property
    def integral(self) -> Measure:
        """The coordinate whose rate it is."""
        return Composed(Symbol("Z"), (("Z", self._along(RIGHT)),), self.dimension * TIME)

    def _along(self, axis: Direction) -> Displacement:
        return Displacement(Point(self.carrier, self.origin), Point(GROUND, self.origin), axis)

    def body(self) -> RigidBody:
        """What carries the coordinate: a unit inertia."""
        points = {"center": self.origin, "mass_center": self.origin}
        return RigidBody(self.carrier, ONE, ZERO, points, "center", turns=False, tensor=(ZERO,) * 6)

    def rows(self) -> list[ConstraintRow]:
        """It moves along one line."""
        across = AXES[1 : len(self.origin)]
        return [
            ConstraintRow(n, "guide", self._along(a), connection=self.carrier)
            for n, a in zip("yz", across, strict=False)
        ]

    def drive(self) -> AppliedLoad:
        """What drives it: Z'' = f."""
        return AppliedLoad("", self.integral, self.rate, self.measures, load=self.carrier)


def as_told(law: Expr, states: Iterable[str]) -> Expr:
    """A law with the states in it by their names."""
    return replace_rates(law, {integral_name(name): Symbol(name) for name in states})


def in_states(
    expr: Expr, states: Mapping[str, ControllerState], measures: Mapping[str, Measure]
) -> tuple[Expr, tuple[tuple[str, Measure], ...]]:
    """An expression in measures and states as a law: a state is the rate of its integral. Returns it and the measures
    that it is written in."""
    used = sorted(free_symbols(expr) & states.keys())
    expr = replace_rates(expr, {name: states[name].rate for name in used})
    used = sorted(free_symbols(expr) & states.keys())
    expr = substitute(expr, {name: Call("rate", Symbol(integral_name(name))) for name in used})
    inside = free_symbols(expr)
    found: Iterable[tuple[str, Measure]] = ((name, measures[name]) for name in sorted(inside & measures.keys()))
    own = ((states[name].carrier, states[name].integral) for name in sorted(states) if integral_name(name) in inside)
    return expr, (*found, *own)
