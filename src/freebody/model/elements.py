"""What descriptions come to: parameters, bodies, held measures and pushed measures.

Sign of a multiplier: it pushes in the direction in which its measure grows. With J the gradient of a held
measure, the bodies feel the generalized force J^T lambda. What people name positive (a string's tension, a
normal force) is `sign * lambda`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Generic, Literal, TypeVar

from freebody.language.expression import (
    Expr,
    Symbol,
    add,
    divide,
    free_symbols,
    multiply,
    negate,
    number,
    replace_rates,
    substitute,
)
from freebody.language.sentences import Message
from freebody.language.units import Dimension
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, ZERO, Components, Direction, Geometry, Point, Scalar, Vector, unit
from freebody.model.one_sided import OneSided
from freebody.model.polynomials import polynomial
from freebody.model.pressed_side import Flank
from freebody.model.solids import NO_SOLID, SolidKind

S = TypeVar("S", bound=Scalar)
P = TypeVar("P")  # a place: components of it, or numbers

# In the law of a load: the measure and its rate. No user can type these names.
VALUE = Symbol("@value")
RATE = Symbol("@rate")

Sign = Literal["positive", "nonnegative", "any"]


@dataclass(frozen=True)
class Parameter:
    """A symbol with an optional value in SI units, or a function of time: then `form` is what it is in numbers, and
    formulas keep its symbol."""

    name: str
    dimension: Dimension
    value: float | None
    sign: Sign = "positive"
    acute: bool = False
    unit: str = ""
    is_angle: bool = False
    form: Expr | None = None
    is_share: bool = False  # from 0 to 1: a coefficient of restitution
    is_count: bool = False  # a number of teeth: neither zero nor without bound

    @property
    def is_bare(self) -> bool:
        """Whether neither a number nor a unit is given for it."""
        return self.value is None and self.form is None and not self.unit


@dataclass(frozen=True)
class Teeth:
    """Of a gear: how many, their module and the radius of the pitch circle [m]."""

    count: Expr
    module: Expr
    radius: Expr


@dataclass(frozen=True)
class Line:
    """A straight line fixed in a body: a point on it and its direction."""

    through: Point
    direction: Direction
    name: str = ""


@dataclass(frozen=True)
class BodyPlane:
    """A plane fixed in a body: a point on it and the normal on the side where things are."""

    through: Point
    normal: Direction
    name: str = ""


@dataclass(frozen=True)
class Rotation:
    """A right-handed turn about an axis of what was turned so far: by a known angle, or by one that is named and
    free."""

    axis: Components
    by: Expr
    name: str = ""


@dataclass(frozen=True)
class Attitude:
    """How a joint lets its second body turn against the first, R_2 = R_1 before turns after^T, and which of its rows
    hold that: the formulas of space go from body to body along these."""

    first: str
    second: str
    before: tuple[Components, Components, Components]
    after: tuple[Components, Components, Components]
    turns: tuple[tuple[Components, str, Measure], ...]  # axis, name within the connection, the angle as a measure
    components: tuple[str, ...]  # the rows of the connection that hold by construction
    connection: str = ""


@dataclass(frozen=True)
class Start:
    """The pose and motion of one body at the start, as far as the user said them."""

    at: tuple[str, Components] | None = None  # point of the body, its ground position
    angle: Expr | None = None
    velocity: Components | None = None  # of the mass centre
    angular_velocity: Expr | None = None
    near: Start | None = None  # a guess for what the connections decide
    turned: tuple[Rotation, ...] | None = None  # in space: known rotations from the axes of the ground
    rates: Components | None = None  # in space: the angular velocity
    rates_in_body: bool = False  # `rates` are components along the body's axes, not the ground's

    @property
    def moves(self) -> bool:
        """Whether a velocity or an angular velocity other than zero is stated."""
        stated = (*(self.velocity or ()), *(self.rates or ()), self.angular_velocity or ZERO)
        return any(component != ZERO for component in stated)

    def with_guess(self) -> Start:
        """The start with the guess put in where nothing is stated."""
        if self.near is None:
            return self
        angle = self.near.angle if self.angle is None else self.angle
        return replace(self, at=self.at or self.near.at, angle=angle, turned=self.turned or self.near.turned)


@dataclass(frozen=True)
class Edge(Generic[P]):
    """What is drawn of a flat shape: the edge of an area, of a hole in it, or a bent wire from its first place to its
    last; one place alone is a point mass."""

    places: tuple[P, ...]
    look: Literal["area", "hole", "wire"] = "area"


@dataclass(frozen=True)
class BodyPart:
    """A part of a composite body: its mass, moment of inertia about its own mass centre, and where that is from the
    mass centre of the body. Of a hole both are negative."""

    name: str
    mass: Expr
    inertia: Expr
    center: Components


@dataclass(frozen=True)
class SolidPart:
    """What is drawn of a part of a composite body in space: a solid with its sizes and the axis along which it is
    round, about its reference point, which is at `center`; axes: its own, along those of the body."""

    kind: SolidKind
    sizes: Components
    axis: Components
    center: Components
    axes: tuple[Components, Components, Components]
    is_particle: bool = False


@dataclass(frozen=True)
class RigidBody:
    """A body: mass, moment of inertia about the mass centre, and points by components from the mass centre."""

    name: str
    mass: Expr
    inertia: Expr
    points: dict[str, Components]
    default_point: str
    lines: dict[str, Line] = field(default_factory=dict[str, Line])
    radius: Expr | None = None
    turns: bool = True
    fixed: bool = False
    start: Start = Start()
    is_placeholder: bool = False  # stands in for a body that could not be read
    corners: tuple[str, ...] = ()  # points on its straight-edged rim, in order
    # of the edges from the first corner on, the names of the middles, and directions with the body on their right
    sides: Mapping[str, Components] = field(default_factory=dict[str, Components])
    is_ring: bool = False  # a circle with room inside
    teeth: Teeth | None = None
    has_inner_teeth: bool = False  # as a ring gear
    edges: tuple[
        Edge[Components], ...
    ] = ()  # what is drawn of it, from the mass centre, where that is no full circle or polygon
    circles: Mapping[str, Expr] = field(default_factory=dict[str, Expr])  # radii of round parts, by their points
    parts: tuple[BodyPart, ...] = ()  # in the plane: of which it is composed
    solid_parts: tuple[SolidPart, ...] = ()  # in space: what is drawn of these, from the mass centre
    copies: tuple[str, ...] = ()  # the further ones of equal bodies on one carrier, of which this one is written
    tensor: Components = ()  # in space: of inertia about the mass centre in body axes, xx, yy, zz, xy, xz, yz
    round: str = ""  # what of it can roll: "disk" (its rim), "sphere", "cone"
    axis: Components = ()  # of a round body
    planes: dict[str, BodyPlane] = field(default_factory=dict[str, BodyPlane])
    chain: tuple[Rotation, ...] = ()  # from the axes of `frame` to its own, where the user named angles
    frame: str = GROUND
    solid: SolidKind = NO_SOLID  # what it looks like, and its sizes
    sizes: Components = ()
    inner: Expr | None = None  # radius of what is hollow in it
    faces: tuple[
        tuple[str, tuple[str, ...]], ...
    ] = ()  # of a convex body: names, and points that are the corners, counter-clockwise as seen from outside

    @property
    def inside_radius(self) -> Expr | None:
        """Of the circle that it has on its inside: that of its hole, where it has one, else its own."""
        return self.radius if self.inner is None else self.inner

    def point(self, name: str | None = None) -> Point:
        chosen = name or self.default_point
        label = self.name if name is None else f"{self.name}.{name}"
        return Point(self.name, self.points[chosen], label)

    def side(self, name: str) -> Line | None:
        """The line along an edge that has a name."""
        if name not in self.sides:
            return None
        label = f"{self.name}.{name}"
        return Line(self.point(name), Direction(self.name, self.sides[name], label), label)

    @property
    def center(self) -> Point:
        """The reference point: the centre of a round body's rim."""
        return self.point()

    @property
    def middle_circles(self) -> dict[str, Expr]:
        """Radii of its round parts about its reference point, by their names."""
        middle = self.points[self.default_point]
        return {name: radius for name, radius in self.circles.items() if self.points[name] == middle}

    @property
    def is_wheel(self) -> bool:
        """Whether it, or a part of it about its reference point, is round."""
        return self.radius is not None or bool(self.middle_circles)

    @property
    def is_part_of_a_circle(self) -> bool:
        """Whether its radius is that of an edge which does not go all the way round."""
        return self.radius is not None and bool(self.edges)

    @property
    def mass_center(self) -> Point:
        return Point(self.name, (ZERO, ZERO), self.name)


@dataclass(frozen=True)
class Component:
    """A ground component of a direction, as the coefficient of a velocity."""

    direction: Direction
    axis: Literal["x", "y", "z"]

    def value(self, g: Geometry[S]) -> S:
        vector: Vector[S] = unit(g, self.direction)
        z = g.scalar(ZERO) if vector.z is None else vector.z
        return {"x": vector.x, "y": vector.y, "z": z}[self.axis]

    def bodies(self) -> Iterator[str]:
        yield self.direction.body


@dataclass(frozen=True)
class NonholonomicForm:
    """A scalar linear in the velocities that need not be the rate of anything:
    sum of coefficient(pose) * d(measure)/dt."""

    terms: tuple[tuple[Component | Measure, Measure], ...]
    dimension: Dimension  # of the quasi-coordinate whose rate it is

    def bodies(self) -> Iterator[str]:
        for coefficient, measure in self.terms:
            yield from coefficient.bodies()
            yield from measure.bodies()


@dataclass(frozen=True)
class StringStretch:
    """A part of a string with one tension: the bodies and points along it, and what its tension is less than the
    reaction of the whole row by: components of the connection, the dry friction of the drums between both."""

    places: tuple[str, ...]
    less: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"between {self.places[0]} and {self.places[-1]}"


@dataclass(frozen=True)
class ConstraintRow:
    """A measure held at a target: one row of the constraint Jacobian, and its reaction."""

    component: str  # "x", "tension", "no slip" ...: the name of the row within its connection
    reaction: str  # what its multiplier is called: "tension", "normal force" ...
    measure: Measure | NonholonomicForm
    target: Expr | None = None  # f(t); None: zero, or the start value of an incremental measure
    sign: int = 1
    ends: tuple[str, ...] = ()  # bodies between which a named section runs, for "tension of rope at left"
    if_needed: bool = False  # held only where the other connections leave it free
    unilateral: bool = False  # an ideal string or contact: the reaction must not be negative
    needs: str = ""  # the component of the same connection without which it is not held: no grip where nothing touches
    connection: str = ""
    general: Expr | None = None  # the target with functions of time as symbols; None: it contains none
    stretches: tuple[StringStretch, ...] = ()  # of a string, in order; the reaction is the tension of the last one
    instead: str = ""  # what to take where this is held by others as well, and may have been held by mistake
    closes: bool = False  # held from the start on, and not before: two parts meet and stay together
    pressed: Flank | None = None  # the side on which the row pushes as it does; on the other one otherwise
    stands_for: tuple[str, ...] = ()  # rows that hold the same and are left out: its multiplier is the sum of all

    @property
    def in_symbols(self) -> Expr | None:
        """The target as formulas have it."""
        return self.target if self.general is None else self.general

    @property
    def is_driven(self) -> bool:
        """Whether it is held at a function of the time."""
        return self.target is not None and "t" in free_symbols(self.target)

    @property
    def together(self) -> tuple[str, ...]:
        """The rows whose sum its multiplier is, where it stands for others."""
        return (self.name, *self.stands_for) if self.stands_for else ()

    @property
    def transmits(self) -> bool:
        """Whether it has a reaction at all: a row that only says what a coordinate is has none."""
        return bool(self.reaction)

    @property
    def name(self) -> str:
        return f"{self.connection}.{self.component}"

    @property
    def axis(self) -> str:
        """Of a component of a force or moment its axis, by one letter; nothing where it is all of it."""
        what, _, last = self.component.rpartition(" ")
        is_part = what in ("", self.reaction) or self.reaction.endswith(f" {last}")
        is_along = last in ("", "x", "y", "z") and not what.endswith((" of", " on", " and"))  # and no body of that name
        return last if len(last) <= 1 and (is_part or is_along) else ""


@dataclass(frozen=True)
class Span:
    """Where a contact exists: a measure is between two values (a foot on an edge)."""

    measure: Measure
    low: Expr | None = None
    high: Expr | None = None


def at_least(measure: Measure, sign: int) -> Span:
    """sign * measure >= 0."""
    return Span(measure, low=ZERO) if sign > 0 else Span(measure, high=ZERO)


@dataclass(frozen=True)
class UnilateralConstraint:
    """A measure that may not pass a limit: sign (measure - target) >= 0. While it is closed its row is held, and its
    reaction, sign * multiplier, is not negative."""

    row: ConstraintRow
    restitution: Expr = ZERO
    within: tuple[Span, ...] = ()
    starts_closed: bool = False  # the start pose closes it, or another of its family
    family: str = ""  # places at which the same two outlines touch
    obstacle: str = ""  # sites of the same family and obstacle face one corner or circle with all edges of an outline
    pitfall: Message | None = None  # how the bodies lie where the measure has no value
    is_crossing: bool = False  # of two edges in space, which it parts along their common normal
    is_separating: bool = False  # of polyhedra in space: of its normal and those of the others one parts them
    lost: Measure | None = None  # in `within`, not positive where more than a place touches: the pitfall says how
    spinning: Measure | NonholonomicForm | None = None  # of a rough flat end: how its friction resists it is not known
    pivot: RimPivot | None = None  # of a flat end: about which it tips

    @property
    def name(self) -> str:
        return self.row.name

    @property
    def is_stop(self) -> bool:
        """Whether it limits what a measure may be, and nothing touches."""
        return self.row.reaction.startswith("stop ")


@dataclass(frozen=True)
class RimPivot:
    """The material point of a rim about which a flat end tips, and on which it falls back. It stands on the face in
    place of the rim while the tilt is too small to say where that is lowest.

    With b_1, b_2 two directions of the body across its axis and m the outer normal of the face it is at R (c b_1 +
    s b_2) from the middle of the end; settings: c, s, and the height at which it is kept, numbers that a motion sets
    where it begins to hold. lowest: b_1 . m and b_2 . m; along: b_j . p and b_j . q, p and q the directions of the face
    along which slip and turning count, and sign that of m . (p x q)."""

    rim: str  # the bound of the rim where it is tilted
    bound: UnilateralConstraint
    dry_friction: tuple[DryFriction, ...]
    settings: tuple[Measure, Measure, Measure]
    lowest: tuple[Measure, Measure]
    along: tuple[tuple[Measure, Measure], tuple[Measure, Measure]]
    sign: int
    radius: Expr


TIPPING, ROLLING, SPINNING = "tipping moment", "rolling resistance", "spinning resistance"


@dataclass(frozen=True)
class DryFriction:
    """Dry friction along a measure. While it does not run its row is held, as long as its multiplier stays within
    static * load; while it runs, the force is kinetic * load against the rate.

    The load is the size of the resultant of the multipliers named in `load` (one or two); without any, `static` and
    `kinetic` are the limits themselves, laws of time and of `measures`. `of` is the bound without which there is no
    friction. Where the friction that resists a growing measure differs from the one that resists a falling one, the
    second is given by `static_back` and `kinetic_back`, and `between_tensions` is the law of the tensions before and
    after it: `euler` round a drum, `sheaves` over those of a tackle.

    In space it acts in a plane, with a second row `across` the first, at right angles to it: while it does not run both
    are held, as long as the resultant of their multipliers stays within static * load (a circular cone); while it runs,
    the force is kinetic * load against the slip (rate of `row`, rate of `across`)."""

    row: ConstraintRow
    static: Expr
    kinetic: Expr
    load: tuple[str, ...] = ()
    of: str = ""
    static_back: Expr | None = None
    kinetic_back: Expr | None = None
    between_tensions: str = ""
    measures: tuple[tuple[str, Measure], ...] = ()
    across: ConstraintRow | None = None

    @property
    def name(self) -> str:
        return self.row.name

    @property
    def rows(self) -> tuple[ConstraintRow, ...]:
        """The row that it holds, or both."""
        return (self.row,) if self.across is None else (self.row, self.across)

    @property
    def is_tipping(self) -> bool:
        """Whether it is the moment of a flat end about its middle, which tips about its rim where it gives way."""
        return self.row.reaction.startswith(TIPPING)

    @property
    def resists_rolling(self) -> bool:
        return self.row.reaction.startswith(ROLLING)

    @property
    def resists_spinning(self) -> bool:
        """About the normal of a contact."""
        return self.row.reaction.startswith(SPINNING)

    @property
    def resists_turning(self) -> bool:
        """Whether it says nothing of how surfaces slide on each other."""
        return self.resists_rolling or self.resists_spinning

    def coefficient(self, direction: int, *, at_rest: bool = False) -> Expr:
        """What multiplies the load: direction +1 where the measure grows (or would), -1 where it falls."""
        if direction < 0 and self.static_back is not None and self.kinetic_back is not None:
            return self.static_back if at_rest else self.kinetic_back
        return self.static if at_rest else self.kinetic


@dataclass(frozen=True)
class Validity:
    """What the law of a load, or a connection, takes for granted of where the bodies are: sign (measure - limit) >= 0.
    Nothing stops there; what is found beyond is not true. purpose: what is so, in words; end: what happens where it
    ends, if that has a name."""

    measure: Measure
    limit: Expr
    sign: int
    purpose: str
    end: str = ""

    @property
    def left(self) -> str:
        """The event at which a motion goes beyond it."""
        return Message("limit of validity: {purpose}", purpose=self.purpose)


@dataclass(frozen=True)
class Spread:
    """A straight line of a body along which a load acts: evenly, or rising from zero at its first end."""

    first: Point
    second: Point
    rises: bool = False

    @property
    def middle(self) -> Point:
        """Where its sum acts."""
        share = divide(number(2), number(3)) if self.rises else divide(number(1), number(2))
        ways = zip(self.first.offset, self.second.offset, strict=True)
        offset = tuple(polynomial(add(a, multiply(share, add(b, negate(a))))).expression() for a, b in ways)
        return Point(self.first.body, offset, f"{self.first} to {self.second}")


@dataclass(frozen=True)
class AppliedLoad:
    """A load: a measure pushed by a law of it (`VALUE`), its rate (`RATE`), time and other measures. The law is
    the generalized force in the direction in which the measure grows."""

    component: str
    measure: Measure | NonholonomicForm
    law: Expr
    measures: tuple[tuple[str, Measure], ...] = ()  # named measures in the law
    load: str = ""
    general: Expr | None = None  # the law with functions of time as symbols; None: it contains none
    one_sided: OneSided | None = None  # where it acts on one side of a border only; `law` is that of both sides
    spread: Spread | None = None  # where it is the sum of what acts along a line
    couple_at: Point | None = None  # the point of the body at which a couple acts, where that is said

    @property
    def in_symbols(self) -> Expr:
        """The law as formulas have it."""
        return self.law if self.general is None else self.general

    def in_own_measure(self) -> AppliedLoad:
        """A law in a named measure that is the one it pushes as a law of its own measure."""
        own = [name for name, measure in self.measures if measure == self.measure]
        law = self.law
        for name in own:
            law = substitute(replace_rates(law, {name: RATE}), {name: VALUE})
        return replace(self, law=law, measures=tuple(item for item in self.measures if item[0] not in own))

    @property
    def name(self) -> str:
        return f"{self.load}.{self.component}" if self.component else self.load
