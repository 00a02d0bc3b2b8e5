"""Questions about the mass centre of the system, or of several bodies."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO
from freebody.language.sentences import Argument, Message, Sentence
from freebody.language.units import LENGTH, TIME, Dimension
from freebody.measures.geometry import GROUND, Direction
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.vectors import (
    Group,
    Vector,
    axes_of,
    component,
    has_name,
    is_among,
    place,
    read_group,
    said_along,
    said_of,
)

if TYPE_CHECKING:
    from freebody.model.names import Names

_ORDERS = {"position": 0, "x": 0, "y": 0, "z": 0, "velocity": 1, "speed": 1, "acceleration": 2}
CENTER = r"(?:common )?(?:mass cent(?:er|re)|cent(?:er|re) of (?:mass|gravity))"


@dataclass(frozen=True)
class OfMassCenter(Quantity, kind="mass center"):
    """Position, velocity or acceleration of the mass centre of the system, or of several bodies: a vector, a component,
    or its size. What is fixed has no part in it."""

    order: int
    body: Group = None
    along: Direction | None = None
    size: bool = False

    example = """
bodies: {left: {particle: {mass: 2 kg}, velocity: [3 m/s, 0]}, right: {particle: {mass: 1 kg}, at: [1 m, 0]}}
questions: {it: velocity of mass center of system at start}
"""
    may_be_conserved = True

    @property
    def dimension(self) -> Dimension:
        return LENGTH / TIME**self.order

    @property
    def kinematic_order(self) -> int:
        return self.order

    @property
    def may_jump(self) -> bool:
        return self.order == 2

    @property
    def sign_is_conventional(self) -> bool:
        return self.along is not None and not self.size

    @property
    def is_of_whole(self) -> bool:
        return self.body is None

    def components(self, system: Described) -> tuple[tuple[str, OfMassCenter], ...]:
        if self.along is not None or self.size:
            return ()
        return tuple((axis.name, replace(self, along=axis)) for axis in axes_of(system))

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        if not self.order or self.along is not None:
            return self
        return replace(self, size=True)

    def value(self, system: Described, state: State[Any]) -> Any:
        center = of_mass_center(system, state, self.body, self.order)
        return component(center, self.along, self.size, state)

    def sentence(self, system: Described) -> Sentence | None:
        if not has_name(self.along):
            return None
        args: dict[str, Argument] = {"of": said_of(self.body), "along": said_along(self.along)}
        return Sentence(f"what.{'size_' if self.size else ''}mass_center_{self.order}", args)


def of_mass_center(system: Described, state: State[Any], group: Group, order: int) -> Vector:
    """r_C = sum m r / sum m and its derivatives, along the axes of the ground. Raises CannotAnswer without a mass."""
    total: Any = 0
    moment: Vector = (0,) * len(axes_of(system))
    for b in system.moving:
        if is_among(b.name, group):
            m, r = state.scalar(b.mass), place(system, state, b.mass_center, order)
            total, moment = total + m, tuple(t + m * c for t, c in zip(moment, r, strict=True))
    try:
        return tuple(c / total for c in moment)
    except ZeroDivisionError:
        raise CannotAnswer(Message("these bodies have no mass, and so no mass centre")) from None


# -- words ------------------------------------------------------------------------------------
@asked(
    "x | y | position | velocity | speed | acceleration of mass center of system | of BODY and BODY [along DIRECTION]",
    rf"(?P<what>x|y|z|position|velocity|speed|acceleration) of (?:the |their |its )?{CENTER}"
    rf"(?: of (?:the )?(?:whole )?(?P<of>system|{NAME}(?:(?:, | and ){NAME})+))?(?: along (?P<along>.+))?",
    rank=65,
)
def _of_center(names: Names, found: Found, path: Path) -> Quantity | None:
    what = str(found["what"])
    if what == "z" and not names.space:
        names.problem(Message("in the plane there is no z"), *path)
        return None
    group = read_group(names, found["of"], path)
    if fixed := next((name for name in group or () if name == GROUND or names.bodies[name].fixed), None):
        names.problem(Message("{body} is fixed: ask for the mass centre of bodies that move", body=fixed), *path)
        return None
    if what in "xyz" and found["along"] is not None:
        names.problem(Message("{what} has its direction already; leave out 'along'", what=what), *path)
        return None
    bodies = [b for b in names.bodies.values() if b.name != GROUND and not b.fixed and b.mass != ZERO]
    if found["of"] is None and len(bodies) > 1 and any(b.turns for b in bodies):
        ways = "; ".join(f"{what} of {name}" for name in ("mass center of system", *(b.name for b in bodies)))
        names.problem(Message("say of what: {ways}", ways=ways), *path)
        return None
    if what in "xyz":
        along = names.direction(what, *path)
    else:
        along = None if found["along"] is None else names.direction(found["along"], *path)
    return OfMassCenter(_ORDERS[what], group, along, size=what == "speed")
