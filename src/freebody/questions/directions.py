"""Which way a vector points: its direction in the plane, and the angle between two vectors or from a direction.

    direction of (x, y):  atan2(y, x), counter-clockwise from the x axis        between a and b:  acos(a.b/(|a| |b|))

To the horizontal or the vertical, above and below the horizontal it is an angle without a sense of turning to the left
or to the right: atan(|y|/|x|), and with the sign of y above it. A vector that is zero has no direction.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.measures.geometry import Direction
from freebody.model.state import State, no_direction
from freebody.questions.arithmetic import Functions, Joined
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import Found, asked
from freebody.questions.grammar import read_quantity
from freebody.questions.vectors import axes_of, components_of, dot

if TYPE_CHECKING:
    from freebody.model.names import Names

_RANK = 64


@dataclass(frozen=True)
class Along(Quantity):
    """A direction as a vector of unit length."""

    direction: Direction

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS

    @property
    def kinematic_order(self) -> int:
        return 0

    def value(self, system: Described, state: State[Any]) -> Any:
        return components_of(self.direction, state, len(axes_of(system)))

    def sentence(self, system: Described) -> Sentence | None:
        name = self.direction.name
        return Sentence("what.direction_named", {"direction": name}) if name else None


class Angular(Joined):
    """An angle that vectors make."""

    measured_in = DIMENSIONLESS

    @property
    def unit(self) -> str:
        return "rad"

    @property
    def letter(self) -> str:
        return "phi"


@dataclass(frozen=True)
class DirectionOf(Angular, kind="direction"):
    """The angle of a vector in the plane, counter-clockwise from the x axis; or above, below or to the horizontal, or
    from the vertical."""

    of: Quantity
    side: str = ""

    example = """
parameters: {v: 5 m/s, h: 2 m, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 2 kg}, at: [0, h], velocity: [v, 0]}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
questions: {it: direction of velocity of ball when y = 0}
"""

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        x, y = values[0]
        if not self.side:
            return of.direction(y, x)
        if self.side == "from":
            return of.direction(of.absolute(x), of.absolute(y))
        rise = of.absolute(y) if self.side == "to" else -y if self.side == "below" else y
        return of.direction(rise, of.absolute(x))

    def sentence(self, system: Described) -> Sentence | None:
        of = self.of.sentence(system)
        return None if of is None else Sentence(f"what.direction_{self.side or 'of'}", {"of": of})


@dataclass(frozen=True)
class AngleBetween(Angular, kind="angle between vectors"):
    """The angle between two vectors, or a vector and a direction, from 0 to 180 degrees."""

    first: Quantity
    second: Quantity

    example = """
bodies: {ball: {particle: {mass: 2 kg}, velocity: [3 m/s, 4 m/s]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: angle between velocity of ball and acceleration of ball at start}
"""

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return self.first, self.second

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        a, b = values
        size = of.sqrt(dot(a, a)) * of.sqrt(dot(b, b))
        if size == 0:
            raise no_direction()
        return of.function("acos", dot(a, b) / size)

    def sentence(self, system: Described) -> Sentence | None:
        first, second = self.first.sentence(system), self.second.sentence(system)
        return (
            None if first is None or second is None else Sentence("what.angle_between", {"one": first, "other": second})
        )


# -- words ------------------------------------------------------------------------------------
def _vector(names: Names, text: str, path: Path) -> Quantity | None:
    """A vector that is asked for with both its components; None where the words mean none."""
    with names.quietly():
        n_before = len(names.problems)
        found = read_quantity(names, text, path)
        is_read = found is not None and len(names.problems) == n_before
    if not is_read or found is None or found.scope != "instant":
        return None
    return (
        found if getattr(found.sized(space=names.space), "size", False) and not getattr(found, "size", False) else None
    )


def _is_of_vector(names: Names, found: Found) -> bool:
    return _vector(names, str(found["of"]), ()) is not None


def _side(names: Names, text: str, path: Path) -> Quantity | None:
    """A vector, or a direction."""
    if (vector := _vector(names, text, path)) is not None:
        return vector
    with names.quietly():
        n_before = len(names.problems)
        direction = names.direction(text, *path)
        return Along(direction) if len(names.problems) == n_before else None


def _are_vectors(names: Names, found: Found) -> bool:
    sides = [_side(names, str(found[key]), ()) for key in ("one", "other")]
    return all(side is not None for side in sides) and not all(isinstance(side, Along) for side in sides)


@asked("direction of VECTOR", r"direction of (?:the )?(?P<of>.+)", rank=_RANK, fits=_is_of_vector)
def _direction(names: Names, found: Found, path: Path) -> Quantity | None:
    return _in_plane(names, _vector(names, str(found["of"]), path), "", path)


@asked(
    "angle of VECTOR [above | below | to the horizontal | from the vertical]",
    r"(?:angle|inclination) of (?:the )?(?P<of>.+?)"
    r"(?: (?P<side>above|below|to|with) (?:the )?horizontal| (?P<upright>from|to|with) (?:the )?vertical)?",
    rank=_RANK,
    example="""
bodies: {ball: {particle: {mass: 2 kg}, velocity: [3 m/s, -4 m/s]}}
questions: {it: angle of velocity of ball below the horizontal at start}
""",
    fits=_is_of_vector,
)
def _angle(names: Names, found: Found, path: Path) -> Quantity | None:
    side = "from" if found["upright"] else {"with": "to"}.get(str(found["side"]), found["side"] or "")
    return _in_plane(names, _vector(names, str(found["of"]), path), side, path)


def _in_plane(names: Names, of: Quantity | None, side: str, path: Path) -> Quantity | None:
    if names.space:
        told = Message("in space a vector has no one angle; ask for the angle between it and a direction")
        names.problem(told, *path)
        return None
    return None if of is None else DirectionOf(of, side)


@asked(
    "angle between VECTOR and VECTOR | DIRECTION",
    r"angle between (?:the )?(?P<one>.+?) and (?:the )?(?P<other>.+)",
    rank=_RANK,
    fits=_are_vectors,
)
def _between(names: Names, found: Found, path: Path) -> Quantity | None:
    one, other = (_side(names, str(found[key]), path) for key in ("one", "other"))
    return None if one is None or other is None else AngleBetween(one, other)
