"""What a connection or a load looks like: a small closed vocabulary of signs.

A connection declares its glyphs (`Connection.glyphs`), a load its own (`Load.glyphs`): nothing that draws looks at the
rows that are held. They are written over points, directions and expressions of the model; a scene has the same ones
over places and headings in numbers (`in_numbers`), in the plane and in space alike.

    joints      Pin, Weld, Ball, Cross, Rail, Face, Groove, Roller
    rolling     Track, Wheels, Belt, Toothed
    tension     Rod, Rope
    contact     Surface, Touch, Halt, TurnHalt, Shoe
    relations   Relation, Equation
    loads       Spring, Tether, Coil, ForceArrow, Spread, MomentArrow, Field
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any, Generic, Literal, TypeVar, cast

from freebody.language.expression import Call, Expr, Number, PowerOf, ProductOf, Sum, Symbol
from freebody.measures.geometry import Direction, Point

P = TypeVar("P")  # a point fixed in a body
D = TypeVar("D")  # a direction fixed in a body
N = TypeVar("N")  # a number
Q = TypeVar("Q")
E = TypeVar("E")
M = TypeVar("M")

# how a body turns against what it runs on: not at all, about its axis (in the plane about its own point), freely, or as
# it rolls
Turning = Literal["not", "about", "freely", "rolls"]


# -- joints -------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Pin(Generic[P, D]):
    """Two bodies turn about each other where two points coincide, about an axis of the first; in the plane about z."""

    first: P
    second: P
    axis: D | None = None


@dataclass(frozen=True)
class Weld(Generic[P]):
    """Two points coincide and the bodies do not turn against each other."""

    first: P
    second: P


@dataclass(frozen=True)
class Ball(Generic[P]):
    """A ball and its socket: two points coincide. One that passes a turn on (a constant-velocity joint) is larger."""

    first: P
    second: P
    passes_turn: bool = False


@dataclass(frozen=True)
class Cross(Generic[P, D]):
    """A cross with an arm in each of two yokes, where two points coincide."""

    first: P
    second: P
    arms: tuple[D, D]


@dataclass(frozen=True)
class Rail(Generic[P, D]):
    """A point runs along a straight line of another body: through a point of it, or where the point is at the start."""

    through: P | None
    point: P
    along: D
    turning: Turning = "not"
    has_thread: bool = False
    is_support: bool = False  # on rollers, of what cannot move


@dataclass(frozen=True)
class Face(Generic[P, D]):
    """A point stays in a plane; `turning` as for a rail, about the normal."""

    through: P
    point: P
    normal: D
    turning: Turning = "freely"


@dataclass(frozen=True)
class Groove(Generic[P, N]):
    """A point runs in a circular groove of another body."""

    center: P
    point: P
    radius: N


@dataclass(frozen=True)
class Roller(Generic[P, N]):
    """A roller turns about a point of a body, which does not count as a body of its own."""

    center: P
    radius: N


# -- rolling ------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Track(Generic[P, D, N]):
    """A circle rolls on a straight line on its right, as the line's direction goes; on its left for a negative
    radius."""

    center: P
    along: D
    radius: N
    is_toothed: bool = False


@dataclass(frozen=True)
class Wheels(Generic[P, N]):
    """Two circles roll on each other; the radius of the second is negative where it lies inside the first. Toothed
    ones are gears, whose pitch circles these are."""

    first: P
    second: P
    radii: tuple[N, N]
    is_toothed: bool = False


@dataclass(frozen=True)
class Belt(Generic[P, N]):
    """A belt round two circles."""

    first: P
    second: P
    radii: tuple[N, N]
    is_crossed: bool = False


@dataclass(frozen=True)
class Toothed(Generic[P, N]):
    """Gear wheels whose axes are not parallel, by their centres. radii: of the pitch circles of two cones that roll on
    each other."""

    wheels: tuple[P, ...]
    radii: tuple[N, ...] = ()


# -- tension ------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Rod(Generic[P, N]):
    """A massless rod between two points; length: where the model states it."""

    first: P
    second: P
    length: N | None = None


@dataclass(frozen=True)
class Node(Generic[P, D, N]):
    """A place on a rope's way: it runs round a circle counter-clockwise (arm = +R), clockwise (-R), or through a point
    (0). On a drum it is wound up. In space: about which axis, and a point of what carries that."""

    place: P
    arm: N
    is_drum: bool = False
    axis: D | None = None
    carrier: P | None = None


@dataclass(frozen=True)
class Lead(Generic[D]):
    """A straight part of a rope: its constant direction, or None along the common tangent of the circles at its ends;
    row: the component of the connection whose reaction is its tension."""

    along: D | None
    row: str = ""


@dataclass(frozen=True)
class Rope(Generic[P, D, N]):
    """A string on its way, with one lead less than nodes. hanging: bodies that hang on it, whose place aside nothing
    else states. With a free first end it comes to the first node along `comes`, as long as is left of the `whole`. An
    elastic one is slack where it is shorter than `relaxed`. One more fall of a tackle has its place, and no circle."""

    nodes: tuple[Node[P, D, N], ...]
    leads: tuple[Lead[D], ...]
    hanging: tuple[str, ...] = ()
    is_closed: bool = False
    comes: D | None = None
    whole: N | None = None
    relaxed: N | None = None
    is_fall: bool = False


# -- contact ------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Tip(Generic[P, N]):
    """What of a body may touch a surface: a circle, or a point of radius 0."""

    place: P
    radius: N
    body: str


@dataclass(frozen=True)
class Surface(Generic[P, D, N]):
    """A straight line that others may touch, solid on the right of its direction."""

    through: P
    along: D
    tips: tuple[Tip[P, N], ...]
    body: str
    is_rough: bool = False


@dataclass(frozen=True)
class Touch:
    """Two bodies may touch each other; within: the second the inside of the first, which is a ring."""

    first: str
    second: str
    within: bool = False


@dataclass(frozen=True)
class Halt(Generic[P, D, N]):
    """A stop of a point: at `limit` from `origin` along a direction it goes no farther; `side` +1 where it stays
    ahead of that."""

    point: P
    origin: P
    along: D
    limit: N
    side: int


@dataclass(frozen=True)
class TurnHalt(Generic[D, N]):
    """A stop of a turning body: the angle of a direction of it from one of its base goes no farther than `limit`;
    `side` +1 where it stays counter-clockwise of that."""

    of: D
    origin: D
    limit: N
    side: int


@dataclass(frozen=True)
class Shoe(Generic[P]):
    """A brake or a clutch: the second body rubs on the first, each by its centre."""

    first: P
    second: P


# -- relations ----------------------------------------------------------------------------------
@dataclass(frozen=True)
class Relation(Generic[P]):
    """Something joins bodies that has no sign of its own: a thin line through points of theirs; through points of one
    body, a line that is fixed in it, or the edge of that body, round it once. is_of_net: one of the many lines that
    show a surface."""

    points: tuple[P, ...]
    is_edge: bool = False
    is_of_net: bool = False


@dataclass(frozen=True)
class Center(Generic[P]):
    """A point that attracts: a dot."""

    at: P


@dataclass(frozen=True)
class Equation(Generic[P]):
    """An equation or an inequality in the model's own notation, beside the point that it is about."""

    at: P
    text: str


# -- loads --------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Spring(Generic[P, N]):
    """A load along the line between two points: of their distance (a spring), of its rate (a damper), or both; neither
    is a pull of a given size. One that only pushes ends free where the points are farther apart than its length
    `longest`."""

    first: P
    second: P
    is_spring: bool = True
    is_damper: bool = False
    longest: N | None = None


@dataclass(frozen=True)
class Tether(Generic[P, D]):
    """A load along a direction that holds a point back: by how far it has come (a spring), by its rate (a damper), or
    by both. It names no second end: a picture sets up a wall for it in what the direction is fixed in."""

    point: P
    along: D
    is_spring: bool = True
    is_damper: bool = False


@dataclass(frozen=True)
class Coil(Generic[P, D]):
    """A torsional spring or damper of a body, by its centre, about an axis of the one that it is on; in the plane
    about z."""

    body: P
    base: P
    axis: D | None = None
    is_spring: bool = True


@dataclass(frozen=True)
class ForceArrow(Generic[P, D]):
    """A force at a point along a direction."""

    at: P
    along: D


@dataclass(frozen=True)
class Spread(Generic[P, D, N]):
    """A load along a straight line of a body, and how large it is at its two ends."""

    first: P
    second: P
    along: D
    sizes: tuple[N, N]


@dataclass(frozen=True)
class MomentArrow(Generic[P, D]):
    """A couple on a body, by its centre, about an axis; in the plane about z."""

    body: P
    axis: D | None = None


@dataclass(frozen=True)
class Field(Generic[D]):
    """A field such as gravity, which pushes every body."""

    along: D


Joint = Pin[P, D] | Weld[P] | Ball[P] | Cross[P, D] | Rail[P, D] | Face[P, D] | Groove[P, N] | Roller[P, N]
Rolling = Track[P, D, N] | Wheels[P, N] | Belt[P, N] | Toothed[P, N]
Touching = Surface[P, D, N] | Touch | Halt[P, D, N] | TurnHalt[D, N] | Shoe[P]
Pushing = Coil[P, D] | ForceArrow[P, D] | MomentArrow[P, D] | Spread[P, D, N] | Field[D] | Spring[P, N] | Tether[P, D]
Sign = (
    Joint[P, D, N]
    | Rolling[P, D, N]
    | Rod[P, N]
    | Rope[P, D, N]
    | Touching[P, D, N]
    | Relation[P]
    | Center[P]
    | Equation[P]
    | Pushing[P, D, N]
)

Glyph = Sign[Point, Direction, Expr]


@dataclass(frozen=True)
class ShownGlyph(Generic[P, D, N]):
    """A glyph with the connection or load whose it is."""

    owner: str
    sign: Sign[P, D, N]
    is_load: bool = False


def in_numbers(
    shown: ShownGlyph[Point, Direction, Expr],
    place: Callable[[Point], Q],
    heading: Callable[[Direction], E],
    number: Callable[[Expr], M],
) -> ShownGlyph[Q, E, M]:
    """The same glyph with places, headings and numbers in it."""

    def changed(value: Any) -> Any:
        match value:
            case Point():
                return place(value)
            case Direction():
                return heading(value)
            case Number() | Symbol() | Sum() | ProductOf() | PowerOf() | Call():
                return number(value)
            case tuple():
                return tuple(map(changed, cast("tuple[Any, ...]", value)))
            case _ if is_dataclass(value) and not isinstance(value, type):
                return replace(value, **{f.name: changed(getattr(value, f.name)) for f in fields(value)})
            case _:
                return value

    return cast("ShownGlyph[Q, E, M]", changed(shown))
