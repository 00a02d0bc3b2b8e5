"""Questions about how one point moves seen from another: v_B - v_A and a_B - a_A, along axes that do not turn.

Source: the composition of velocities, as in Hibbeler, Dynamics, ch. 12.10: v_B = v_A + v_(B/A). Relative to a body that
turns is seen from it (`seen_from_body`); relative to a point of it, along axes that do not turn.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

from freebody.language.sentences import Argument, Message, Sentence
from freebody.language.units import LENGTH, TIME, Dimension
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import POINT, Found, asked
from freebody.questions.seen_from_body import seen_from
from freebody.questions.vectors import IN_BASIS, ORIGIN, Basis, component, has_name, place, read_basis, said_along

if TYPE_CHECKING:
    from freebody.model.names import Names

RANK = 62  # rather than what moves seen from the ground


@dataclass(frozen=True)
class RelativeMotion(Quantity, kind="relative motion"):
    """Velocity or acceleration of a point less that of another: a vector, a component, or its size."""

    point: Point
    other: Point
    order: Literal[1, 2]
    along: Direction | None = None
    size: bool = False
    basis: Basis | None = None

    example = """
bodies:
  car: {particle: {mass: 900 kg}, velocity: [20 m/s, 0]}
  truck: {particle: {mass: 8000 kg}, at: [0, 5 m], velocity: [5 m/s, 8 m/s]}
questions: {it: velocity of car relative to truck at start}
"""

    @property
    def dimension(self) -> Dimension:
        return LENGTH / TIME**self.order

    @property
    def sign_is_conventional(self) -> bool:
        return self.along is not None and not self.size

    @property
    def kinematic_order(self) -> int:
        return self.order

    @property
    def may_jump(self) -> bool:
        return self.order == 2

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        return replace(self, size=True) if self.along is None and self.basis is None else self

    @property
    def bodies_in_motion(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(p.body for p in (self.point, self.other) if p.body != GROUND))

    def value(self, system: Described, state: State[Any]) -> Any:
        own, other = (place(system, state, p, self.order) for p in (self.point, self.other))
        vector = tuple(a - b for a, b in zip(own, other, strict=True))
        return component(vector, self.along, self.size, state, self.basis)

    def sentence(self, system: Described) -> Sentence | None:
        if not has_name(self.along, self.basis):
            return None
        size = "size_" if self.size else ""
        args: dict[str, Argument] = {
            "point": str(self.point),
            "other": str(self.other),
            "along": said_along(self.along, self.basis),
        }
        return Sentence(f"what.{size}relative_{self.order}", args)


# -- words ------------------------------------------------------------------------------------
_ORDERS: dict[str, Literal[1, 2]] = {"velocity": 1, "speed": 1, "acceleration": 2}


@asked(
    "[size of] velocity | acceleration, or speed of POINT relative to POINT [along DIRECTION] [in BASIS]",
    rf"(?P<size>size of |magnitude of )?(?:the )?(?P<what>velocity|speed|acceleration) of (?P<of>{POINT})"
    rf" relative to (?P<rel>{POINT})(?: along (?P<along>.+?))?{IN_BASIS}",
    rank=RANK,
)
def _relative(names: Names, found: Found, path: Path) -> Quantity | None:
    point, other = names.point(str(found["of"]), *path), _seen_from(names, str(found["rel"]), path)
    if other is not None and (point.body, point.offset) == (other.body, other.offset):
        names.problem(Message("{point} has no motion relative to itself; name another point", point=str(point)), *path)
    what = str(found["what"])
    if what == "speed" and (found["along"] or found["basis"] or found["size"]):
        names.problem(Message("a speed has no direction; ask for the velocity along one"), *path)
    along = None if found["along"] is None else names.direction(found["along"], *path)
    is_size = found["size"] is not None or what == "speed"
    if other is None:
        basis = found["basis"]
        return seen_from(names, point, str(found["rel"]), _ORDERS[what], along, path, size=is_size, basis=basis)
    return RelativeMotion(point, other, _ORDERS[what], along, is_size, read_basis(names, found["basis"], path))


def _carries_a_string(names: Names, body: str) -> bool:
    """Whether a string runs over a wheel."""
    pulls = [row for row in names.constraint_rows if row.reaction == "tension"]
    wheel = names.bodies[body].is_wheel or bool(names.bodies[body].round)
    return wheel and any(body in row.measure.bodies() for row in pulls)


def _seen_from(names: Names, text: str, path: Path) -> Point | None:
    """A point, or a body that does not turn as a whole; None for one that turns."""
    if text == GROUND:
        return ORIGIN
    body, _, place_on_it = text.partition(".")
    if body in names.bodies and body != GROUND and not place_on_it and names.bodies[body].turns:
        if any(spec.guide_of(names, body, turning=False) is not None for spec in names.connections.values()):
            return names.point(body, *path)  # a cart on its track
        if _carries_a_string(names, body):  # what hangs on a pulley is seen from its axle
            return names.point(f"{body}.center", *path)
        return None
    return names.point(text, *path)
