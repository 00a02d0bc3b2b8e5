"""What a route knows of a system at one instant: the common ground on which quantities are asked.

Both routes supply a `State[S]`: the symbolic one with field elements, the numeric one with floats. They get
there in different ways and share only the statements of the measures.
"""

from __future__ import annotations

import math
from typing import Any, Protocol, TypeVar

from freebody.errors import CannotAnswer
from freebody.language.expression import FLOAT_FUNCTIONS, Expr
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm

S_co = TypeVar("S_co", covariant=True)


def function_of_number(name: str, x: Any) -> float:
    """An elementary function of a number. Raises CannotAnswer where it has no value."""
    try:
        return float(FLOAT_FUNCTIONS[name](float(x)))
    except (ValueError, OverflowError):
        raise CannotAnswer(Message("{name}({x:.6g}) has no value", name=name, x=float(x))) from None


def direction_of_numbers(y: Any, x: Any) -> float:
    """The angle of a vector of numbers. Raises CannotAnswer where it has no length."""
    if x == 0 and y == 0:
        raise no_direction()
    return math.atan2(float(y), float(x))


def no_direction() -> CannotAnswer:
    """Why there is no angle."""
    return CannotAnswer(Message("the vector is zero and has no direction"))


def not_beside(side: str) -> CannotAnswer:
    """Why a state says nothing of what was so beside the blow of the start."""
    if side == "start":
        return CannotAnswer(Message("the blow is at the start: say 'before the blow' or 'after the blow'"))
    return CannotAnswer(Message("of the instant just before the blow of the start only places and velocities are told"))


def rate_not_given(name: str) -> str:
    """What is assumed about a rate at the start that nobody gave."""
    return Message(
        "rate({name}) at the start is not given; it is taken to be that of the least kinetic energy", name=name
    )


class State(Protocol[S_co]):
    """A system at one instant, its motion and its reactions."""

    def scalar(self, expr: Expr) -> S_co:
        """Value of an expression in the parameters and time."""
        ...

    def value(self, measure: Measure) -> S_co: ...

    def rate(self, measure: Measure | NonholonomicForm) -> S_co: ...

    def acceleration(self, measure: Measure | NonholonomicForm) -> S_co: ...

    def gradient(self, measure: Measure | NonholonomicForm, body: str) -> tuple[S_co, ...]:
        """Derivatives of the measure's rate by the velocity (x, y) and angular velocity of a body: the force
        and the moment about the mass centre that a unit push of the measure exerts on it. In space three of each,
        along the axes of the ground."""
        ...

    def multiplier(self, row: ConstraintRow) -> S_co:
        """The multiplier of a held measure. Raises CannotAnswer naming the connections if it is not unique."""
        ...

    def impulse(self, row: ConstraintRow) -> S_co:
        """The impulse of a held measure in the blow at the start. Raises CannotAnswer if it is not unique."""
        ...

    @property
    def energy_before(self) -> S_co:
        """The kinetic energy just before the blow at the start [J]."""
        ...

    def rate_before(self, measure: Measure | NonholonomicForm) -> S_co:
        """The rate just before the blow at the start."""
        ...

    def beside_blow(self, quantity: Any, side: str) -> S_co:
        """A quantity just `before` the blow that led to this state, or at the `start` of the motion. Raises
        CannotAnswer where that is not told."""
        ...

    def law(self, push: AppliedLoad) -> S_co:
        """The generalized force of a load in the direction in which its measure grows."""
        ...

    def potential(self, push: AppliedLoad) -> S_co:
        """Potential energy of a load. Raises CannotAnswer if it has none."""
        ...

    def sqrt(self, x: Any) -> S_co: ...

    def size(self, vector: tuple[Any, ...]) -> S_co:
        """The length of a vector, by its components."""
        ...

    def absolute(self, x: Any) -> S_co:
        """The size of what may have either sign."""
        ...

    def function(self, name: str, x: Any) -> S_co:
        """An elementary function by its name: atan, cos, log ..."""
        ...

    def direction(self, y: Any, x: Any) -> S_co:
        """The angle of the vector (x, y) from the x axis, counter-clockwise, within a half turn of it. Raises
        CannotAnswer for a vector of no length."""
        ...


class JustBefore:
    """A state just before the blow that led to it: the same places with the rates from before. Raises CannotAnswer for
    what forces decide."""

    def __init__(self, state: State[Any]) -> None:
        self._state = state

    def __getattr__(self, name: str) -> Any:
        return getattr(self._state, name)

    def rate(self, measure: Measure | NonholonomicForm) -> Any:
        return self._state.rate_before(measure)

    def _not_told(self, _asked: object) -> Any:
        raise not_beside("before")

    acceleration = multiplier = impulse = law = _not_told
