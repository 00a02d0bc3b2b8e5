"""The base of all connections.

A connection is one file in this folder: a `Spec` with a `kind`; `rows`, which says which measures it holds, or
`bounds`, which says which it bounds or rubs along; and `glyphs`, which says what is drawn of it.
It may offer natural coordinates (`offers`), which are used where the user named none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self, cast

from freebody.connections.pairs import OutlinePair
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, Components, Direction, Point
from freebody.model.curves import CurvePlace, LevelPlace
from freebody.model.elements import AppliedLoad, Attitude, ConstraintRow, DryFriction, UnilateralConstraint, Validity
from freebody.model.glyphs import Glyph, Relation
from freebody.model.kinds import Kinds
from freebody.model.spec import Spec
from freebody.model.surfaces import SurfacePlace
from freebody.model.thread import Thread
from freebody.model.transmitted import CutTension, Transmitted

if TYPE_CHECKING:
    from freebody.model.names import Names


class Connection(Spec):
    """Base of the connections; a subclass is found by its `kind`."""

    kinds: ClassVar[Kinds[type[Connection]]] = Kinds("freebody.connections")
    # the smallest model that uses it: the rest of the file, for documentation and the conformance tests
    example: ClassVar[str] = ""
    # further ones for the conformance tests, by name: where the same words state other measures, as in space
    more_examples: ClassVar[dict[str, str]] = {}
    # it keeps its bodies as one; it leaves free how they turn; a body that only such hold hangs on them
    is_rigid: ClassVar[bool] = False
    lets_turn: ClassVar[bool] = False
    lets_hang: ClassVar[bool] = False
    is_chosen = False
    # the fields that name two points which lie on each other, at the start as well
    meeting: ClassVar[tuple[str, str] | None] = None
    # in space what it holds follows from the joints of its bodies, and holds none of them anywhere
    follows_joints: ClassVar[bool] = False
    # of a kind of the plane: what does the same in space
    in_space_take: ClassVar[Message | None] = None
    # its forces act where its bodies touch: people call the place "the contact point"
    has_contact_point: ClassVar[bool] = False

    def as_meant(self, names: Names) -> Self:
        """Itself, or as it is read where the bodies that it joins leave one meaning."""
        del names
        return self

    # of equal bodies on one carrier (`copies`): each has such a connection of its own, or all share one
    with_copies: ClassVar[Literal["", "each", "together"]] = ""

    def __init_subclass__(cls, kind: str = "", **rest: Any) -> None:
        super().__init_subclass__(**rest)
        if kind:
            cls.kind = kind
            Connection.kinds.register(kind, cls)

    @classmethod
    def length_of(cls, entry: Mapping[str, Any], body: str, field: str) -> str | None:
        """What an entry of a file says about a length that a body leaves open, as the radius of a gear by its teeth;
        read before there are bodies."""
        return None

    def keeps_as_one(self, names: Names) -> bool:
        """Whether the places of its bodies are those of one body."""
        return self.is_rigid

    def rows(self, names: Names) -> list[ConstraintRow]:
        """The measures it holds."""
        return []

    @property
    def is_one_force(self) -> bool:
        """Whether people mean one force by what it transmits at several places: the normal force of a block."""
        return False

    def is_in_plane(self, names: Names) -> bool:
        """Whether it is a connection of the plane."""
        return self.in_plane

    def keeps_flat(self, names: Names) -> bool:
        """In space: whether it does no more than to make a body one of the plane of x and y."""
        return False

    def guide_of(self, names: Names, body: str, *, turning: bool) -> Direction | None:
        """The direction of the ground along which it guides a body, which may turn or not (turning: either)."""
        return None

    def lies_along(self, names: Names, body: str) -> Direction | None:
        """The direction of a line of the ground that bears a body, which may leave it."""
        return None

    def carried_by(self, names: Names, point: Point) -> Point | None:
        """The point of a guided body, which does not turn, to which it joins a point."""
        return None

    def is_floor_below(self, names: Names, body: str) -> bool:
        """Whether it is no more to a body than a level floor on which it may land, and above which it is put."""
        return False

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        """The measures that it bounds, and those along which it resists by dry friction."""
        return [], []

    def pairs(self, names: Names, connection: str) -> list[OutlinePair]:
        """The pairs of outlines that it lets touch."""
        return []

    def attitude(self, names: Names) -> Attitude | None:
        """In space: how one of its bodies is turned from the other, where it leaves few angles free."""
        return None

    def bears_at(self, names: Names, point: Point, normal: Direction) -> Expr | None:
        """How far along the normal of a line of the ground, on which its body lies at the start, a point is."""
        return None

    def keeps_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        """How far along a direction of the ground it keeps a point of one of its bodies; see `standing`."""
        return None

    def aside_of_way(self, names: Names) -> Measure | Message:
        """By how much it pushes aside of the way on which what it drives is guided, or why there is no such angle."""
        return Message("{connection} has no pressure angle, which is one of cams", connection=self.own_name(names))

    def room_between(self, names: Names, body: str, place: str) -> Measure | Message | None:
        """What vanishes where a body gets to a place (a body, or a point `body.point`) to which it leads, or why that
        never happens; None where it does not lead from one to the other."""
        return None

    def edge_radius(self, names: Names) -> Measure | Message:
        """The radius of curvature of its edge where it touches, or why there is none."""
        return Message("{connection} has no edge, which is one of cams", connection=self.own_name(names))

    def thread(self, names: Names) -> Thread | Message:
        """The slope and the friction of its thread, or why there is none."""
        return Message("{connection} has no thread, as screws and worms do", connection=self.own_name(names))

    def straight_between(self, names: Names) -> tuple[Point, Point] | None:
        """The ends of what is a straight line between two points, as a link is."""
        return None

    def mentions(self, names: Names) -> set[str]:
        """Names of the bodies that it joins."""
        return {owner for owner, _point in self._named(names)}

    def own_name(self, names: Names) -> str:
        """What the model calls it; empty while it is not read yet."""
        return next((name for name, other in names.connections.items() if other is self), "")

    def _named(self, names: Names) -> Iterator[tuple[str, str]]:
        """What its fields name of bodies: the body, and a point, a line or an axis of it, or nothing."""
        for name, kind in self.field_types().items():
            value = getattr(self, name)
            # `along: right` is a direction, also where a body is called right; `along: rod.x` is one of a body
            is_direction = kind == "direction"
            for text in cast("list[Any]", value) if isinstance(value, list) else [value]:
                owner, dot, point = text.partition(".") if isinstance(text, str) else ("", "", "")
                if owner in names.bodies and (dot or not is_direction):
                    yield owner, point

    def parts(self, names: Names) -> dict[str, Expr]:
        """The parts of the force between its teeth: what the tooth force is multiplied by for each."""
        return {}

    def transmitted(self, names: Names) -> Mapping[str, Transmitted]:
        """What it can be asked for beside its reactions, by the words that ask for it."""
        return {}

    def tensions(self, names: Names) -> Mapping[str, CutTension]:
        """Of what has mass and is laid over places: the tension at each, by the words for it."""
        return {}

    def weighs(self, names: Names, body: str, along: Direction) -> tuple[Measure, Expr] | None:
        """Of a body whose weight does not act at one point: what it pushes, and the law of that for a field of strength
        1 along a direction of the ground. None where gravity acts at the mass centre."""
        return None

    def loads_bearings(self, names: Names) -> Mapping[str, str]:
        """The bodies whose bearings carry forces of it that it does not tell, and why."""
        return {}

    def valid_where(self, names: Names) -> list[Validity]:
        """What it takes for granted of where the bodies are."""
        return []

    def level_places(self, names: Names) -> tuple[LevelPlace, ...]:
        """The lowest and highest places of a curve that it keeps something on."""
        return ()

    def curve_place(self, names: Names) -> CurvePlace | None:
        """Where it keeps a point beside a curve, if its foot there is a coordinate of its own."""
        return None

    def foot(self, names: Names) -> CurvePlace | SurfacePlace | None:
        """Where it keeps a point beside a curve or a surface, if its foot there has coordinates of its own."""
        return self.curve_place(names)

    def brings(self, names: Names) -> dict[str, AppliedLoad]:
        """Loads that belong to it, by their names: the pull of a pretension."""
        return {}

    def bearing(self, names: Names) -> tuple[Point, Point, Direction, Direction] | None:
        """Of a joint of space in which one body does nothing but turn against the other: the points that coincide, and
        the axis on each of both."""
        return None

    def step_of_edge(self, names: Names) -> tuple[float, float, float] | None:
        """Of an edge that goes round a body: by how much its distance from the middle, and the slope of that by the
        angle, change over a turn, and the distance itself [m]. None where there is no such edge, or no numbers."""
        return None

    def for_copy(self, names: Names, carrier: str, turned: Callable[[Components], Components]) -> dict[str, Any]:
        """Of what each copy has of its own (`with_copies`): the fields in which that of a copy differs, which stands on
        the carrier as the first one turned about the axis of the carrier."""
        return {}

    def teeth_with(self, names: Names, body: str) -> tuple[float, float, int] | None:
        """Teeth of what a body meshes with, its own, and the sense in which both turn if their centres stand still: +1
        in a ring gear, else -1. None where they are not known in numbers."""
        return None

    def joined_points(self, names: Names) -> tuple[Point, Point] | None:
        """The two points that it keeps together while both bodies turn, in the plane."""
        return None

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        """What is drawn of it (see `model.glyphs`); a thin line through its points if nothing is said."""
        bodies = [(names.known(owner), point) for owner, point in self._named(names) if owner != GROUND or point]
        points = [body.point(point or None) for body, point in bodies if not point or point in body.points]
        yield Relation(tuple(dict.fromkeys(points)))

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        """Measures that make natural coordinates, by name within the connection."""
        return ()


def as_written(measure: str | dict[str, Any]) -> str:
    """A measure as a model writes it, in words."""
    return measure if isinstance(measure, str) else " ".join(str(kind) for kind in measure)


def coincidence(first: Point, second: Point) -> list[ConstraintRow]:
    """Two points coincide. The multipliers are the force on the second body along x and y."""
    return [
        ConstraintRow("x", "force", Displacement(second, first, RIGHT)),
        ConstraintRow("y", "force", Displacement(second, first, UP)),
    ]
