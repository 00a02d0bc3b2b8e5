"""The base of all shapes: mass, moment of inertia about the mass centre, mass centre and named points.

A shape is a `Spec` with a `kind` in a file of this folder, which is found by itself. A mass that is left out is zero: a
massless link or pulley.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import PI, Call, Expr, divide, number, power
from freebody.language.sentences import Message
from freebody.measures.geometry import ZERO, Components
from freebody.model.elements import BodyPart, Edge, SolidPart, Teeth
from freebody.model.kinds import Kinds
from freebody.model.solids import NO_SOLID, SolidKind
from freebody.model.spec import Spec

if TYPE_CHECKING:
    from freebody.model.names import Names

N_SIDES = 64  # of a drawn circle


@dataclass(frozen=True)
class Build:
    """What a shape comes to. Points are components in the body's own frame, from its reference point."""

    mass: Expr
    inertia: Expr
    center_of_mass: Components = (ZERO, ZERO)
    points: dict[str, Components] = field(default_factory=dict[str, Components])
    radius: Expr | None = None
    turns: bool = True
    default_point: str = "center"
    corners: tuple[str, ...] = ()  # points of a straight-edged rim, in order
    # of these edges, from the first corner on, the names of the middles, and directions with the body on their right
    sides: Mapping[str, Components] = field(default_factory=dict[str, Components])
    is_ring: bool = False
    teeth: Teeth | None = None
    has_inner_teeth: bool = False
    edges: tuple[Edge[Components], ...] = ()  # what is drawn of it, where that is no full circle and not straight
    # in space
    circles: Mapping[str, Expr] = field(default_factory=dict[str, Expr])  # radii of round parts, by their points
    parts: tuple[BodyPart, ...] = ()  # in the plane: of which it is composed
    solid_parts: tuple[SolidPart, ...] = ()  # in space: what is drawn of these
    tensor: Components = ()  # about the mass centre: xx, yy, zz, xy, xz, yz
    round: str = ""
    axis: Components = ()
    solid: SolidKind = NO_SOLID
    sizes: Components = ()
    inner: Expr | None = None  # radius of what is hollow in it
    faces: tuple[tuple[str, tuple[str, ...]], ...] = ()  # of a convex body: names, and corners as seen from outside


class Shape(Spec):
    """Base of the shapes; a subclass is found by its `kind`."""

    beside: ClassVar[str] = " What is no field of a shape stands beside it: model.body(name, {kind}(...), {field}=...)."
    elsewhere: ClassVar[Mapping[str, str]] = {
        "weight": Message("a weight is a force, and what has the weight W has the mass W/g: {{mass: W/g}}")
    }
    kinds: ClassVar[Kinds[type[Shape]]] = Kinds("freebody.model.shapes")
    # points between which it lies, where a file may say `from: A, to: B`
    ends: ClassVar[tuple[str, ...]] = ()
    # lengths that may be left open, with the points that depend on them; () where the whole body does
    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {}
    # its fields with values, as a file has them: for documentation and for random models
    example: ClassVar[str] = ""
    # the example names a file, which stands beside a model
    needs_file: ClassVar[bool] = False

    def __init_subclass__(cls, kind: str = "", **rest: Any) -> None:
        super().__init_subclass__(**rest)
        if kind:
            cls.kind = kind
            cls.elsewhere = {**Shape.elsewhere, **cls.elsewhere}
            Shape.kinds.register(kind, cls)

    def lengths_left_open(self) -> Mapping[str, tuple[str, ...]]:
        """The lengths that may be left open, as far as no other field says them."""
        return self.open_lengths

    def build(self, names: Names) -> Build:
        """What it comes to; problems are noted."""
        raise NotImplementedError


def half(e: Expr) -> Expr:
    """e/2."""
    return divide(e, number(2))


def square(e: Expr) -> Expr:
    """e^2."""
    return power(e, number(2))


def circle(radius: Expr) -> tuple[Components, ...]:
    """Places on a full circle about the reference point, from its x axis to there again."""
    angles = [divide(2 * k * PI, number(N_SIDES)) for k in range(N_SIDES + 1)]
    return tuple((radius * Call("cos", angle), radius * Call("sin", angle)) for angle in angles)


def plate_tensor(Ix: Expr, Iy: Expr, xy: Expr = ZERO) -> Components:
    """The tensor of a plate in the plane of x and y: I_z = I_x + I_y."""
    return Ix, Iy, Ix + Iy, xy, ZERO, ZERO
