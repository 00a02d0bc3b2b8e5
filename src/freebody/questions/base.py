"""The base of all kinds of questions.

A kind is a frozen dataclass in a file of this folder: a `Quantity` with a `kind`, by which it is found, and a reader of
the words that ask for it (`asked`). It says its dimension, what it is over a `State` (`value`) or along a motion
(`counted`), and to what part of mechanics it belongs (`scope`). Whoever answers or tells asks the kind and tests on
none.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Protocol, TypeVar

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message, Sentence
from freebody.language.units import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_MOMENTUM,
    ANGULAR_VELOCITY,
    DIMENSIONLESS,
    FORCE,
    IMPULSE,
    LENGTH,
    POWER,
    TIME,
    TORQUE,
    VELOCITY,
    Dimension,
)
from freebody.measures.base import Measure
from freebody.model.elements import AppliedLoad, ConstraintRow, RigidBody
from freebody.model.state import State

if TYPE_CHECKING:
    from freebody.language.expression import Expr
    from freebody.measures.geometry import Point
    from freebody.model.names import Names

Path = tuple[str | int, ...]
Scope = Literal[
    "instant",  # a state has it
    "course",  # counted from the start to an event
    "rest",
    "steady motion",
    "whole motion",  # how far it gets
    "repeated motion",  # a motion that repeats itself, whatever its amplitude
    "small motion",  # equilibrium, and small oscillations about it
    "every motion",  # what all motions have in common: conservation
    "structure",  # whatever moves: degrees of freedom
    "linkage",  # the geometry of a loop, whatever moves it
    "sections",  # of a rod, as a function of the place
]
S_co = TypeVar("S_co", covariant=True)
_LETTERS = {  # as textbooks write them
    LENGTH: "s",
    TIME: "T",
    VELOCITY: "v",
    ACCELERATION: "a",
    ANGULAR_VELOCITY: "omega",
    ANGULAR_ACCELERATION: "alpha",
    FORCE: "F",
    TORQUE: "M",
    POWER: "P",
    IMPULSE: "J",
    ANGULAR_MOMENTUM: "H",
}


class Loaded(Protocol):
    """A load, as far as quantities read it."""

    stores_energy: ClassVar[bool]
    spread_over: ClassVar[str]
    resists: ClassVar[bool]

    def pulls_with(self, laws: Sequence[Any], sqrt: Callable[[Any], Any]) -> Any:
        """The force or torque that people ask for; None where there is no single one."""
        ...


class Described(Protocol):
    """A system, as far as quantities read it."""

    @property
    def space(self) -> bool: ...
    @property
    def bodies(self) -> Mapping[str, RigidBody]: ...
    @property
    def moving(self) -> tuple[RigidBody, ...]: ...
    @property
    def measures(self) -> Mapping[str, Measure]: ...
    @property
    def constraint_rows(self) -> tuple[ConstraintRow, ...]: ...
    @property
    def rows(self) -> tuple[ConstraintRow, ...]: ...
    @property
    def applied_loads(self) -> tuple[AppliedLoad, ...]: ...
    @property
    def loads(self) -> Mapping[str, Loaded]: ...
    @property
    def blows(self) -> Sequence[object]: ...
    @property
    def is_struck(self) -> bool: ...


class Passage(Protocol[S_co]):
    """A motion from the start to an event, as far as quantities count along it. Whoever follows motions supplies it;
    what cannot be told of this one raises CannotAnswer."""

    def time(self) -> S_co:
        """Since the start."""
        ...

    def change(self, measure: Measure) -> S_co:
        """Of a measure, from the start to the event."""
        ...

    def work(self, load: str) -> S_co:
        """What a load has done."""
        ...

    def heat(self, of: str) -> S_co:
        """The energy that dry friction and impacts have taken; of: in one connection, else in all."""
        ...

    def travelled(self, measure: Measure) -> S_co:
        """The way of a measure, counted without sign."""
        ...

    def length(self, point: Point) -> S_co:
        """Of the path of a point."""
        ...

    def half_swings(self) -> S_co:
        """How often it has gone from one rest to the next."""
        ...

    def revolutions(self, body: str) -> S_co:
        """How often a body has turned, counted without sign."""
        ...

    def integral(self, quantity: Quantity) -> Any:
        """Of a quantity over the time."""
        ...

    def there(self, quantity: Quantity) -> Any:
        """A quantity in the state at the event."""
        ...

    def started(self, quantity: Quantity) -> Any:
        """A quantity at the start."""
        ...


class Wanted(Protocol):
    """What is to be so for the value of a parameter that is asked for."""

    @property
    def parameter(self) -> str: ...
    @property
    def of(self) -> Quantity:
        """What is to be equal to `target`."""
        ...

    @property
    def target(self) -> Expr: ...
    @property
    def relation(self) -> str:
        """= or that of an inequality between the two; or that the event comes."""
        ...

    @property
    def end(self) -> str:
        """Of the values for which an inequality holds the one that is asked for: least, largest, or none of them."""
        ...

    @property
    def asks_place(self) -> bool:
        """Of a largest or least value: whether the parameter is asked for, and not the quantity there."""
        ...

    @property
    def text(self) -> str:
        """The quantity in words, with its event."""
        ...

    def asking(self, *, relation: str | None = None, asks_place: bool = True) -> Any:
        """The same quantity asked about in another way: with a relation to zero, or for the place."""
        ...


class Quantity:
    """Base of the kinds of questions; a subclass is found by its `kind`."""

    kinds: ClassVar[dict[str, type[Quantity]]] = {}
    kind: ClassVar[str] = ""
    # the smallest model in which it is asked for, as the question `it`: documentation and the conformance tests read it
    example: ClassVar[str] = ""
    scope: ClassVar[Scope] = "instant"
    # of kinds whose values all have the same dimension
    measured_in: ClassVar[Dimension] = DIMENSIONLESS
    # whether a motion can keep it
    may_be_conserved: ClassVar[bool] = False
    # whether it depends on which coordinates describe the system
    is_of_coordinates: ClassVar[bool] = False

    def __init_subclass__(cls, kind: str = "", **rest: Any) -> None:
        super().__init_subclass__(**rest)
        if kind:
            cls.kind = kind
            Quantity.kinds[kind] = cls

    # whether the event itself is asked for, and nothing of the state there
    is_of_event: ClassVar[bool] = False
    # whether it belongs to the instant of the start alone: to the blow by which a motion begins
    is_of_start: ClassVar[bool] = False
    # whether it is a force or moment that a connection transmits
    is_reaction: ClassVar[bool] = False
    # whether the conditions are the answer: a verdict, and the key of the sentence that gives it
    is_verdict: ClassVar[bool] = False
    verdict: ClassVar[str] = "steady.verdict"
    # whether it is told of a connection by the law of that alone
    is_by_law: ClassVar[bool] = False
    # whether it is asked which of two is greater: the sign of the value is the answer
    compares: ClassVar[bool] = False
    # whether ways to and fro are added up
    adds_up_ways: ClassVar[bool] = False
    # whether its formula is that of earlier impacts, continued
    continues_impacts: ClassVar[bool] = False
    # whether it is told by the principles where the equations of motion are too long
    is_told_by_principles: ClassVar[bool] = False
    # whether it is so where one coordinate alone remains
    is_told_by_principles_of_one: ClassVar[bool] = False
    # whether it is a frequency or a period of small oscillations
    is_frequency: ClassVar[bool] = False
    # whether it is the energy that a blow takes
    is_energy_lost_at_once: ClassVar[bool] = False
    # which derivation it has, of those in a file each, where it has one of its own
    derived_by: ClassVar[str] = ""
    # whether it is where a measure, which it names, comes to rest
    is_place_of_rest: ClassVar[bool] = False
    # whether it asks if something is so of a motion
    asks_whether: ClassVar[bool] = False
    # whether the equilibrium that is meant is a stable one, where there are several
    is_about_stable: ClassVar[bool] = False

    @property
    def dimension(self) -> Dimension:
        return self.measured_in

    @property
    def is_tangential(self) -> bool:
        """Whether it is the tangential force of teeth, which is the same on whichever flank they bear."""
        return False

    def place_of(self, names: Names, value: Expr) -> tuple[Measure, Expr] | None:
        """The measure, and its value, at which the quantity has a value, where a place alone decides it."""
        return None

    @property
    def reason(self) -> Sentence | None:
        """Why it is what it is, said before it is written in the forces that are known by then."""
        return None

    @property
    def function_of(self) -> str:
        """The name of what it is a function of, where it is one."""
        return ""

    @property
    def named_measure(self) -> tuple[str, int] | None:
        """The name of the measure that it is, and whether its value (0), its rate (1) or its acceleration (2)."""
        return None

    @property
    def at_rest(self) -> Quantity | None:
        """What is asked of the system as it rests."""
        return None

    @property
    def of_what_stays(self) -> Quantity | None:
        """What it asks where nothing changes, if it is an extreme of a motion."""
        return None

    @property
    def size_of(self) -> Quantity | None:
        """Of the size of a number, or of the velocity or place of a point, what it is the size of."""
        return None

    def with_operands(self, changed: Callable[[Quantity], Quantity]) -> Quantity:
        """Where it is calculated from others, the same from what these are changed to; else itself."""
        return self

    @property
    def loads_left_out(self) -> tuple[str, ...]:
        """Loads without which it is asked."""
        return ()

    @property
    def asks_no_slip(self) -> bool:
        """Whether it asks that nothing slips, in words that hold of what moves as well as of what rests."""
        return False

    @property
    def is_of_parameters(self) -> bool:
        """Whether it is a number of the parameters alone, whatever touches, slips or moves."""
        return False

    @property
    def is_of_pose_in_motion(self) -> bool:
        """Whether only the sense of the motion matters, not how fast it is: a pose with one freedom has it."""
        return False

    @property
    def is_momentum_of_all(self) -> bool:
        """Whether it is the momentum, or the angular momentum, of all bodies together."""
        return False

    @property
    def is_of_state(self) -> bool:
        """Whether it has a value in the course of a motion, at an instant or from the start up to it."""
        return self.scope in ("instant", "course")

    @property
    def unit(self) -> str:
        """The SI unit, as it is shown."""
        return str(self.dimension)

    @property
    def remarks(self) -> tuple[Message, ...]:
        """What is to be said beside every answer."""
        return ()

    def meant_within(self, system: Described) -> tuple[tuple[Expr, Message], ...]:
        """What is not negative where the quantity is meant, and how that is said: a section lies on its rod."""
        return ()

    def value(self, system: Described, state: State[Any]) -> Any:
        """The quantity at the state's instant: a scalar, or a tuple for a vector, whichever arithmetic the state has.
        Raises CannotAnswer for quantities that are no property of one instant."""
        words = self.kind or re.sub(r"(?<=[a-z])(?=[A-Z])", " ", type(self).__name__).lower()
        raise CannotAnswer(
            Message(
                "what is asked ({words}) has no value at one instant: ask for it alone, without at or when, and where "
                "no contact or friction changes",
                words=words,
            )
        )

    def counted(self, passage: Passage[Any]) -> Any:
        """The quantity at the event that ends a motion, or what has come together on the way there."""
        return passage.there(self)

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        """What can be least or (most) greatest of it: of a vector its size, of a force whose sign says nothing its
        greatest size, else itself."""
        return self

    @property
    def with_sign(self) -> Quantity:
        """Of the size of a force the force; else itself."""
        return self

    @property
    def inner(self) -> tuple[Quantity, ...]:
        """Quantities that this one is about."""
        return ()

    @property
    def struck(self) -> frozenset[str]:
        """The connections whose impulses it is about."""
        return frozenset[str]().union(*(one.struck for one in self.inner))

    @property
    def wanted(self) -> Wanted | None:
        """Where the question is turned round, and asks for the value of a parameter: what is to be so."""
        return None

    @property
    def watched(self) -> tuple[Measure, int] | None:
        """The measure whose value, rate or acceleration it is, and which of these."""
        return None

    def added_to(self, other: Quantity) -> Quantity | None:
        """The sum with another one as a quantity, which may be determined where its parts are not."""
        return None

    @property
    def principle(self) -> str:
        """Which principle governs its change: the part of the catalogues with the sentences about its conservation."""
        return "other"

    @property
    def letter(self) -> str:
        """The symbol that formulas have for it: by its kind or that of what it is about, else by its dimension."""
        about = self.inner
        if len(about) == 1 and about[0].dimension == self.dimension:
            return about[0].letter
        return "E" if self.unit == "J" else _LETTERS.get(self.dimension, "Q")

    @property
    def bodies_in_motion(self) -> tuple[str, ...]:
        """Bodies whose velocities it reads, where it is read off them alone."""
        return ()

    def share(self, body: str) -> Quantity | None:
        """Of a sum over bodies: what one of them adds to it."""
        return None

    def components(self, system: Described) -> tuple[tuple[str, Quantity], ...]:
        """Of a vector: its components by the names of their axes. Nothing for a scalar."""
        return ()

    @property
    def is_of_whole(self) -> bool:
        """Whether it is meant of all bodies together."""
        return False

    @property
    def turn(self) -> tuple[Quantity, Any, int] | None:
        """What is asked for at a turn, the event that the turn is, and from which side it comes there (+1: growing)."""
        return None

    @property
    def sign_is_conventional(self) -> bool:
        """Whether its sign only says which sense is counted as positive: that of a coordinate or a component, not that
        of a tension or an energy."""
        return False

    @property
    def counted_along(self) -> str:
        """The name of the measure whose positive sense is that of the quantity; nothing where it has none."""
        return ""

    @property
    def is_any_of_several(self) -> bool:
        """Whether each of several values that are found is one: the roots of an equation, and no components."""
        return False

    @property
    def is_of_turn(self) -> bool:
        """Whether it is asked of all poses of a full turn."""
        return False

    @property
    def jump(self) -> tuple[Quantity, tuple[str, ...]] | None:
        """Where it is asked what a blow does to a quantity: that quantity, and what strikes (none: any)."""
        return None

    @property
    def has_finder(self) -> bool:
        """Whether its formula is more than its value over a state: which of several it is, numbers tell."""
        return False

    @property
    def is_of_answers(self) -> bool:
        """Whether it is calculated from the answers to questions for its inner quantities, each with an instant of its
        own or none."""
        return False

    @property
    def keeps_what_is_given(self) -> bool:
        """Whether an event is no event of a motion, but says what a steady motion keeps."""
        return False

    @property
    def is_up_to_constant(self) -> bool:
        """Whether a constant may be added to it: a potential energy."""
        return False

    @property
    def may_jump(self) -> bool:
        """Whether a change of the contacts can change its value at once: that of forces and accelerations."""
        return False

    @property
    def is_moment(self) -> bool:
        """Whether it has an axis and a sense about it: in the plane its one number changes sign in a mirror."""
        return False

    @property
    def kinematic_order(self) -> int | None:
        """The order of derivatives from which geometry alone gives it: 0 pose, 1 velocities, 2 accelerations; None for
        what needs masses or forces."""
        return None

    def sentence(self, system: Described) -> Sentence | None:
        """What it is called, for the catalogues of every language; None where the words of the question are quoted."""
        return None

    def remark_on_zero(self, system: Described) -> str:
        """What is to be said where it is zero whatever the motion is: what may have been meant instead."""
        return ""

    def remark_in_motion(self, system: Described) -> str:
        """What is to be said where it changes along the motion, and no instant is meant."""
        return ""

    def remark(self, system: Described) -> str:
        """What is to be said of an answer: of which of two opposite forces it is."""
        return ""


def angular_unit(dimension: Dimension) -> str:
    """The unit of an angle or of its rate, in radians."""
    table = {
        DIMENSIONLESS: "rad",
        DIMENSIONLESS / TIME: "rad/s",
        DIMENSIONLESS / TIME**2: "rad/s^2",
    }
    return table.get(dimension, str(dimension))
