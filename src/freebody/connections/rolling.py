"""Rolling without slip of a circle on a line or a circle, or inside a ring; in space on planes, spheres, cylinders."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection
from freebody.connections.circles import look_at_fit, touching
from freebody.connections.places_on_bodies import place_of_rim
from freebody.connections.rolling_in_space import (
    parallel_cylinders,
    place_of_crossed,
    rolling_rows,
    rows_of_crossed,
    rows_of_cylinders,
    rows_of_rim,
    rows_on_cylinder,
    rows_on_sphere,
)
from freebody.connections.standing import (
    along_of,
    arm_on_ground,
    ground_guide_of,
    is_parallel,
    moves_out_of_plane,
    same_way,
    stands_at,
)
from freebody.language.expression import ZERO, Expr, add, divide, negate, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import Attitude, ConstraintRow, Line, RigidBody, Validity
from freebody.model.glyphs import Glyph
from freebody.model.noting import did_you_mean
from freebody.model.solids import CYLINDER, DISK, RING
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names

_RIMS = (DISK, RING)


_ROLLS = ("wheel", "disk", "ball", "cylinder", "roller", "sphere")  # what people call the body that rolls
_PURE = ("without_slipping", "without_slip", "no_slip", "no_slipping", "pure", "pure_rolling")
_BELOW = ("ground", "floor", "surface", "line", "road", "incline")


class Rolling(Connection, kind="rolling"):
    """`rolling: {body: disk, on: ground.incline}`; `on` a line or a round body, or `inside` a ring. Holds the
    gap and the slip (2 rows). The circle lies on the left of the line as its direction points, which is above it
    for a line that points to the right; `below: true` puts it on the other side. `radius` where it rolls on another
    circle than its rim (the hub of a spool on a rail).

    On a line, with s the travel of the centre along it: slip = d(s + R theta)/dt.

    In space: `on` a plane, of the rim of a disk, a sphere, an ellipsoid or a cone (3 rows; a cone 5); and of a
    sphere `on` or `inside` another one or a cylinder, fixed or moving (3 rows); on a cylinder between its ends. The
    rim of a disk or a ring rolls on a sphere or `inside` a hollow one as well (3 rows). A cylinder on or inside
    another one touches it along a line and stays parallel to it (5 rows); `crossed: true` where it lies across the
    other one and touches it in a point (3 rows), on the side on which both are put. On a curve see
    rolling_on_curve, on a surface z = f(x, y) rolling_on_surface."""

    also: ClassVar[tuple[str, ...]] = (
        "rolls",
        "roll",
        "rolls_on",
        "rolling_contact",
        "rolls_without_slipping",
        "rollt",
    )

    body: str
    on: str | None = None
    inside: str | None = None
    below: bool = False
    radius: Formula | None = None
    crossed: bool = False

    has_contact_point = True
    in_space_take: ClassVar[Message | None] = Message(
        "a sphere rolls on planes, spheres and cylinders, a cylinder on planes and along or across a cylinder, the rim "
        "of a disk or a ring on planes and spheres, a cone on planes only"
    )
    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {
        **dict.fromkeys(_PURE, ()),
        **dict.fromkeys(_ROLLS, ("body",)),
        **dict.fromkeys(_BELOW, ("on",)),
    }

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`{wheel: w, ground: floor}` as what rolls and on what."""
        given = {key: each for key, each in super().from_plain(value).items() if key not in _PURE or each is not True}
        for field, words in (("body", _ROLLS), ("on", _BELOW)):
            word = next((word for word in words if isinstance(given.get(word), str)), None)
            if word is not None and field not in given:
                given[field] = given.pop(word)
        return given

    elsewhere: ClassVar[Mapping[str, str]] = {
        "friction": Message(
            "what rolls here never slips; where friction may be too little write contact: {{between: [wheel, floor], "
            "friction: mu}}"
        ),
        "rolling_resistance": Message(
            "a contact takes it: contact: {{between: [wheel, floor], friction: mu, rolling_resistance: f, touching: "
            "true}}"
        ),
        "z": Message("on a surface z = f(x, y) it is rolling_on_surface: {{body: ball, z: k*rho^2}}"),
        "y": Message("on a curve y = f(x) it is rolling_on_curve: {{body: ball, y: a*x^2}}"),
    }
    example = """
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: 1 kg, radius: 1 m}}}
connections: {it: {rolling: {body: wheel, on: floor}}}
"""
    more_examples: ClassVar[dict[str, str]] = {
        name: f"""
space: true
bodies:
  hub: {{rod: {{mass: 1 kg, length: 0.1 m}}, at: [0, 0, 0]}}
  slide: {{box: {{mass: 2 kg, size: [0.1 m, 0.2 m, 0.3 m]}}, at: [{at}, 0, 0]}}
  ball: {{sphere: {{mass: 3 kg, radius: 0.1 m}}, at: [{at}, 0, 0]}}
  other: {{{other}, at: [0, 0, 0]}}
connections:
  axle: {{revolute: {{first: ground.origin, second: hub.center, about: y}}}}
  pivot: {{revolute: {{first: ground.origin, second: other.center, about: y}}}}
  guide: {{prismatic: {{first: hub.center, second: slide.center, along: x}}}}
  cross: {{universal: {{first: slide.center, second: ball.center, arm: y, second_arm: z}}}}
  it: {{rolling: {{body: ball, {where}: other}}}}
"""
        for name, where, at, other in (
            ("on a ball in space", "on", "0.3 m", "sphere: {mass: 2 kg, radius: 0.2 m}"),
            ("in a bowl in space", "inside", "0.4 m", "spherical_shell: {mass: 2 kg, radius: 0.5 m}"),
            ("on a roller in space", "on", "0.3 m", "cylinder: {mass: 2 kg, radius: 0.2 m, length: 1 m, axis: y}"),
            ("in a pipe in space", "inside", "0.4 m", "cylinder: {mass: 2 kg, radius: 0.5 m, length: 1 m, axis: y}"),
        )
    }

    def is_in_plane(self, names: Names) -> bool:
        if self.on is None or self.on in names.bodies:
            return self._round_in_space(names) is None
        return names.edge(self.on) is not None

    def _round_in_space(self, names: Names) -> RigidBody | None:
        """The sphere or cylinder on or in which a sphere rolls, the cylinder on or in which another one does, or the
        sphere on or in which a rim does, unless all that moves stays in the plane of x and y."""
        body, other = (names.bodies.get(name) for name in (self.body, str(self.on or self.inside)))
        if body is None or other is None or not names.space:
            return None
        if body.round == "sphere" or body.solid == CYLINDER:
            is_known = other.solid == CYLINDER or (body.round == other.round == "sphere")
        else:
            is_known = body.solid in _RIMS and other.round == "sphere"
        return other if is_known and moves_out_of_plane(names, (body.name, other.name)) else None

    def rows(self, names: Names) -> list[ConstraintRow]:
        body = names.body(self.body, "body")
        own = names.optional(self, "radius", LENGTH)
        plane = names.plane(self.on, "on") if names.space else None
        if plane is not None:
            return rolling_rows(names, body, body.radius if own is None else own, plane)
        other = self._round_in_space(names)
        if other is not None:
            return self._on_body_in_space(names, body, other)
        radius = names.radius(body.name, "body") if own is None else own
        if body.is_part_of_a_circle and own is None:
            told = Message(
                "{connection}: {body} touches with its round side", connection=self.own_name(names), body=body.name
            )
            names.assumptions.append(told)
        if (self.on is None) == (self.inside is None):
            names.problem(Message("say what it rolls on: on: ground.floor (a line), on: drum, or inside: ring"))
            return []
        line = None if self.on is None else names.edge(self.on)
        if line is not None:
            return self._on_line(body, radius, line)
        if self.on is not None and self.on not in names.bodies:
            return self._nothing_there(names)
        other = names.body(str(self.on or self.inside), "on" if self.on else "inside")
        if other.name == body.name:
            names.problem(Message("{body} cannot roll on itself", body=body.name))
            return []
        if not other.is_wheel:
            return self._nothing_there(names)
        inside = self.inside is not None
        rim = names.radius(other.name, inside=inside)
        if inside:
            look_at_fit(names, body.name, radius, other.name, rim, "inside")
        distance, total, rolled = touching(other.center, rim, body.center, radius, internal=inside)
        return [
            ConstraintRow("contact", "normal force", distance, total, sign=-1 if self.inside else 1, unilateral=True),
            ConstraintRow("no slip", "friction force", rolled, sign=-1, needs="contact"),
        ]

    def _on_body_in_space(self, names: Names, body: RigidBody, other: RigidBody) -> list[ConstraintRow]:
        if other.name == body.name:
            names.problem(Message("{body} cannot roll on itself", body=body.name))
            return []
        if self.radius is not None:
            told = Message("on another body in space it rolls on its own radius")
            names.problem(told, "radius")
            return []
        inside = self.inside is not None
        radii = names.radius(body.name, "body"), names.radius(other.name, inside=inside)
        if inside:
            look_at_fit(names, body.name, radii[0], other.name, radii[1], "inside")
        if self._is_crossed(body, other):
            return rows_of_crossed(names, body, other)
        if body.solid in _RIMS:
            return rows_of_rim(names, body, other, inside=inside)
        if body.solid == CYLINDER:
            return rows_of_cylinders(names, body, other, inside=inside)
        rows = rows_on_sphere if other.round == "sphere" else rows_on_cylinder
        return rows(names, body, other, inside=inside)

    def _is_crossed(self, body: RigidBody, other: RigidBody) -> bool:
        return self.crossed and self.inside is None and body.solid == other.solid == CYLINDER

    def attitude(self, names: Names) -> Attitude | None:
        with names.quietly():
            body, other = names.bodies.get(self.body), self._round_in_space(names)
        if body is None or other is None or body.name == other.name or not body.solid == other.solid == CYLINDER:
            return None
        if self._is_crossed(body, other):
            return None
        return parallel_cylinders(body, other)

    def valid_where(self, names: Names) -> list[Validity]:
        """On a cylinder it rolls between the ends, on a sphere a disk with its rim."""
        other = self._round_in_space(names)
        if other is None:
            return []
        if other.solid != CYLINDER:
            return self._touches_with_rim(names, names.known(self.body), other)
        if self._is_crossed(names.known(self.body), other):
            return self._lies_across(names, other)
        far = Displacement(names.known(self.body).center, other.center, Direction(other.name, other.axis))
        half = divide(other.sizes[1], number(2))
        purpose = Message("{body} is between the ends of {cylinder}", body=self.body, cylinder=other.name)
        return [Validity(far, negate(half), 1, purpose), Validity(far, half, -1, purpose)]

    def _touches_with_rim(self, names: Names, body: RigidBody, other: RigidBody) -> list[Validity]:
        if body.solid not in _RIMS or body.radius is None or self.inside is not None or other.radius is None:
            return []
        spans = place_of_rim(names, body, other, inside=False).within
        purpose = Message("{body} touches {other} with its rim", body=body.name, other=other.name)
        return [Validity(span.measure, span.low, 1, purpose) for span in spans if span.low is not None]

    def _lies_across(self, names: Names, other: RigidBody) -> list[Validity]:
        """Both touch between their ends, and their axes cross."""
        with names.quietly():
            place = place_of_crossed(names, names.known(self.body), other)
        if place is None:
            return []
        crossed, *feet = place.within
        told = Message("the axes of {body} and {other} cross", body=self.body, other=other.name)
        found = [Validity(crossed.measure, ZERO, 1, told)]
        for name, foot in zip((self.body, other.name), feet, strict=True):
            purpose = Message("it touches {cylinder} between its ends", cylinder=name)
            if foot.low is not None and foot.high is not None:
                found += [Validity(foot.measure, foot.low, 1, purpose), Validity(foot.measure, foot.high, -1, purpose)]
        return found

    def _nothing_there(self, names: Names) -> list[ConstraintRow]:
        body = names.bodies.get(str(self.on))
        if body is not None and body.sides:
            sides = ", ".join(f"{body.name}.{side}" for side in body.sides)
            names.problem(
                Message("{body} has straight sides, name the one: {sides}", body=body.name, sides=sides), "on"
            )
            return []
        known = [f"{b.name}.{name}" for b in names.bodies.values() for name in (*b.lines, *b.planes, *b.sides)]
        if body is not None and not names.space:
            flat = Message(
                "{name} has no line to roll on. Give it one, e.g. {name}: {{lines: {{face: {{through: [0, 0], along: "
                "right}}}}}}, and write on: {name}.face",
                name=body.name,
            )
            names.problem(flat, "on")
            return []
        told = Message(
            "{name} is neither a plane, a line nor a round body.{hint} For a plane: ground: {{planes: {{floor: "
            "{{normal: up}}}}}}"
            if names.space
            else "{name} is neither a line nor a round body.{hint} A line: ground: {{lines: {{{line}: {{along: "
            "right}}}}}}",
            name=self.on,
            line=self.on if str(self.on).isidentifier() else "floor",
            hint=did_you_mean(str(self.on), known),
        )
        names.unknown(str(self.on), told, "on")
        return []

    def _on_line(self, body: RigidBody, radius: Expr, line: Line) -> list[ConstraintRow]:
        arm = negate(radius) if self.below else radius
        gap = Displacement(body.center, line.through, line.direction.normal())
        along = Displacement(body.center, line.through, line.direction)
        slip = Combination(((ONE, along), (arm, Angle(body.name, line.direction.body))), LENGTH)
        return [
            ConstraintRow("contact", "normal force", gap, arm, sign=-1 if self.below else 1, unilateral=True),
            ConstraintRow("no slip", "friction force", slip, needs="contact"),
        ]

    def lies_along(self, names: Names, body: str) -> Direction | None:
        line = None if names.space or self.on is None or body != self.body else self._line(names)
        return line.direction if line is not None and line.direction.body == GROUND else None

    def keeps_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        """Its centre is a radius away from the line, and so is a guided body whose line it rolls on."""
        direction = self.lies_along(names, point.body)
        if direction is None and point.body != self.body:
            return self._carrier_at(names, point, along, seen)
        if direction is None or not is_parallel(names, direction.normal(), along):
            return None
        with names.quietly():
            line, body, own = self._line(names), names.body(self.body), names.optional(self, "radius", LENGTH)
            radius = body.radius if own is None else own
        if line is None or radius is None or point.offset != body.center.offset:
            return None
        base = stands_at(names, line.through, along, seen)
        is_up = same_way(names, direction.normal(), along) != self.below
        return None if base is None else add(base, radius if is_up else negate(radius))

    def _carrier_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        """Where the body is that has the line, which does not turn from its axes: by where what rolls on it is."""
        with names.quietly():
            line, body, own = self._line(names), names.body(self.body), names.optional(self, "radius", LENGTH)
            is_level = ground_guide_of(names, point.body, turning=False) is not None
        radius = body.radius if own is None else own
        if line is None or radius is None or names.space or line.direction.body != point.body or not is_level:
            return None
        normal = Direction(GROUND, line.direction.components, "").normal()
        if names.known(point.body).start.angle is not None or not is_parallel(names, normal, along):
            return None
        center = stands_at(names, body.center, along, seen)
        is_up = same_way(names, normal, along) != self.below
        arm = along_of(arm_on_ground(names.known(point.body), line.through.offset, point.offset), along)
        return None if center is None else add(center, negate(radius) if is_up else radius, arm)

    def _line(self, names: Names) -> Line | None:
        with names.quietly():
            return names.edge(str(self.on))

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        line = None if self.on is None else names.edge(self.on)
        if line is not None:
            yield "travel", Displacement(names.body(self.body).center, line.through, line.direction)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        body = names.body(self.body)
        own = names.optional(self, "radius", LENGTH)
        plane = names.plane(self.on) if names.space else None
        if plane is not None:
            yield glyphs.Face(plane.through, body.center, plane.normal, "rolls")
            return
        round_body = self._round_in_space(names)
        if round_body is not None:
            yield glyphs.Touch(round_body.name, body.name, within=self.inside is not None)
            return
        radius = names.radius(body.name) if own is None else own
        line = None if self.on is None else names.edge(self.on)
        if line is not None:
            yield glyphs.Track(body.center, line.direction, negate(radius) if self.below else radius)
            return
        other = names.body(str(self.on or self.inside))
        inside = self.inside is not None
        radii = names.radius(other.name, inside=inside), negate(radius) if inside else radius
        yield glyphs.Wheels(other.center, body.center, radii)
