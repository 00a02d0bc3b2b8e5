"""Contact: outlines that may touch, slide or roll on each other, bounce and part."""

from __future__ import annotations

import difflib
import itertools
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, cast

from freebody.connections.base import Connection
from freebody.connections.circles import look_at_fit
from freebody.connections.contact_in_space import PairInSpace, SurfaceInSpace
from freebody.connections.outlines import KINDS, Outline, read_outline
from freebody.connections.pairs import ContactSurface, OutlinePair
from freebody.connections.places_on_bodies import INSIDE
from freebody.connections.polyhedra import is_polyhedron
from freebody.connections.sites import sites
from freebody.connections.standing import (
    along_of,
    begins_at,
    ground_guide_of,
    is_parallel,
    moves_out_of_plane,
    number_of,
    place_of,
    same_way,
    stands_at,
)
from freebody.language.expression import Expr, add, divide, negate
from freebody.language.natural import natural
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, RIGHT, ZERO, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, RigidBody, UnilateralConstraint, Validity
from freebody.model.friction import read_friction, read_restitution
from freebody.model.glyphs import Glyph
from freebody.model.noting import did_you_mean
from freebody.model.spec import Formula
from freebody.tolerances import SAME_PLACE

if TYPE_CHECKING:
    from freebody.model.names import Names


_WHAT_TOUCHES = (
    "body",
    "first",
    "from",
    "point",
    "at",
    "on",
    "with",
    "surface",
    "second",
    "to",
)  # the first, the second
_IN_SPACE = """
space: true
ground: {{planes: {{floor: {{normal: up}}}}}}
bodies: {{stone: {{{body}}}}}
connections: {{it: {{contact: {{between: [{touching}, ground.floor], friction: 0.3, restitution: 0.5}}}}}}
"""
_SLIDING = """
space: true
bodies: {{ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: {at}}}, other: {{{body}}}}}
connections:
  slide: {{prismatic: {{first: ground.A, second: other.center, along: z}}}}
  it: {{contact: {{between: [ball, other], friction: {friction}, restitution: 0.5, touching: true}}}}
"""
_ON_A_BODY = """
space: true
bodies: {{ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}}}, other: {{{body}}}}}
connections: {{it: {{contact: {{between: [ball, {touching}], restitution: 0.5}}}}}}
"""


class Contact(Connection, kind="contact"):
    """`contact: {between: [ball, ground.floor], friction: mu, restitution: e}`; `among: [a, b, floor]` for every pair
    of several, `among: all` for all bodies and lines of the ground.

    What touches is named by a body (its circle, its straight edges and corners, or, on lines, the round side of a half
    disk, a sector or an arc, while this faces the line), a point, a line (solid on the
    right of its direction, so below one that points to the right; `below: true` for the other side), or
    `inside bowl` for the inside of a ring. In space: a body on a plane of another one (see `planes`), a sphere on a
    sphere, inside one, on a box, a convex body, a cylinder, a disk, a ring, a rod or a point, a point on a sphere, a
    box or a convex body, a cylinder or a disk on a box or a convex body, cylinders across or along each other,
    and boxes and convex bodies on each other. friction: one coefficient, or {static: 0.5, kinetic: 0.4};
    restitution between 0 (default) and 1; rolling_resistance: the arm of the normal force [m]. A contact whose
    bodies have no place (`at`)
    starts touching, and `touching: true` moves the bodies there, or out of each other, by the least;
    `touching: false` leaves them where they are. Of two bodies with plane faces only `touching: true` does. A cylinder,
    or a disk, may stand flat on a plane or a face: it tips about its rim, and where it falls back without rebound the
    angular momentum about the other edge stays. Where it spins with friction there, a motion needs its
    spinning_resistance (2/3 of the coefficient of friction times the radius where the pressure is even and it only
    spins); else it ends, saying so."""

    also: ClassVar[tuple[str, ...]] = ("collision", "impact", "Stoß", "Kontakt")
    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("body", "with", "on", "surface", "first", "second", "from", "to"),
            Message("what touches stands together: between: [ball, ground.floor]"),
        ),
        **dict.fromkeys(
            ("mu_s", "mu_k", "static", "kinetic"),
            Message("two coefficients are friction: {{static: mu_s, kinetic: mu_k}}"),
        ),
    }

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`{body: ball, on: floor}` and the like, as of what rolls: two that touch."""
        given = super().from_plain(value)
        named = [(key, on) for key, on in given.items() if "." in key and isinstance(on, str)]
        if len(named) == 1 and "between" not in given:  # {rod.end: floor}
            ((first, second),) = named
            given = {"between": [first, second], **{key: each for key, each in given.items() if key != first}}
        alone = [key for key, each in given.items() if each is None and ("." in key or key not in cls.model_fields)]
        if len(alone) == 1:  # {rod.end, on: floor}
            given = {"body": alone[0], **{key: each for key, each in given.items() if key != alone[0]}}
        first = given.get("between")
        is_one = isinstance(first, str) or (isinstance(first, list) and len(cast("list[Any]", first)) == 1)
        if is_one and any(word in given for word in _WHAT_TOUCHES):
            one = first if isinstance(first, str) else cast("list[Any]", first)[0]  # {contact: wheel, on: floor}
            given = {"body": one, **{key: each for key, each in given.items() if key != "between"}}
        two = [given[word] for word in _WHAT_TOUCHES if isinstance(given.get(word), str)]
        if len(two) != 2 or "between" in given or "among" in given:
            return given
        return {"between": two, **{key: each for key, each in given.items() if key not in _WHAT_TOUCHES}}

    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = dict.fromkeys(_WHAT_TOUCHES, ("between",))

    between: list[str] | None = None
    among: list[str] | str | None = None
    friction: Formula | dict[str, Any] = 0
    restitution: Formula = 0
    rolling_resistance: Formula = 0
    spinning_resistance: Formula = 0
    touching: bool | None = None
    below: bool = False

    @property
    def is_one_force(self) -> bool:
        return self.between is not None

    spread = ("between",)
    in_plane = True
    has_contact_point = True
    example = """
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}}
connections: {it: {contact: {between: [ball, floor], friction: 0.3, restitution: 0.5}}}
"""
    more_examples: ClassVar[dict[str, str]] = (
        {
            name: _IN_SPACE.format(body=body, touching=touching)
            for name, touching, body in (
                ("ball in space", "stone", "sphere: {mass: 1 kg, radius: 0.1 m}"),
                (
                    "rim in space",
                    "stone",
                    "disk: {mass: 1 kg, radius: 0.1 m}, turned: [p about y, l about x, s about z]",
                ),
                (
                    "ellipsoid in space",
                    "stone",
                    "ellipsoid: {mass: 1 kg, semi_axes: [0.1 m, 0.1 m, 0.2 m]}, "
                    "turned: [p about z, l about x, s about z]",
                ),
                (
                    "point in space",
                    "stone.tip",
                    "box: {mass: 1 kg, size: [1 m, 2 m, 3 m]}, points: {tip: [1 m, -1 m, 0]}",
                ),
            )
        }
        | {
            name: _ON_A_BODY.format(body=body, touching=touching)
            for name, touching, body in (
                ("ball on a ball in space", "other", "sphere: {mass: 2 kg, radius: 0.2 m}, at: [0.1 m, -0.2 m, 0.3 m]"),
                (
                    "ball in a bowl in space",
                    "inside other",
                    "spherical_shell: {mass: 2 kg, radius: 0.5 m}, at: [0, 0.3 m, 0]",
                ),
            )
        }
        | {
            f"ball on a {name} in space": _SLIDING.format(body=body, at=at, friction=friction)
            for name, body, at, friction in (
                ("box", "box: {mass: 2 kg, size: [1 m, 0.8 m, 1 m]}", "[0.1 m, 0.5 m, 0.05 m]", 0.3),
                ("cylinder", "cylinder: {mass: 2 kg, radius: 0.4 m, length: 2 m, axis: y}", "[0.1 m, 0.1 m, 0.5 m]", 0),
                ("rod", "rod: {mass: 2 kg, length: 1 m}", "[0.1 m, 0.06 m, 0.08 m]", 0),
            )
        }
    )

    def is_in_plane(self, names: Names) -> bool:
        return not self._planes(names) and not self._misnamed(names) and not self._bodies_in_space(names)

    def _bodies_in_space(self, names: Names) -> list[str]:
        """In space: the bodies, points and insides that may touch each other, unless all that move stay in a plane."""
        if not names.space or (texts := self._texts()) is None:
            return []
        solids = [text for text in texts if names.plane(text) is None and names.line(text) is None]
        owners = {_owner(text) for text in solids}
        if len(solids) < 2 or not owners <= names.bodies.keys():
            return []
        return solids if moves_out_of_plane(names, owners) else []

    def _texts(self) -> list[str] | None:
        """What may touch, with `inside` written in one way."""
        texts = self.between if self.between is not None else self.among
        return [" ".join(t.split()).replace("inside of ", INSIDE) for t in texts] if isinstance(texts, list) else None

    def _misnamed(self, names: Names) -> list[str]:
        """In space: what is called like a plane of a body that has some, and is nothing of it."""
        found: list[str] = []
        for text in (self.between or (self.among if isinstance(self.among, list) else [])) if names.space else ():
            owner, _, name = text.rpartition(".")
            body = names.bodies.get(owner or GROUND)
            known = () if body is None else (*body.points, *body.lines, *body.planes)
            if body is not None and body.planes and name not in known and text not in names.bodies:
                found.append(text)
        return found

    def _planes(self, names: Names) -> list[str]:
        """In space: the planes among what may touch."""
        texts = self.between or (self.among if isinstance(self.among, list) else [])
        return [text for text in texts if names.space and names.plane(text) is not None]

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        """Of contacts in space, and of particles that meet on one line."""
        if (line := self._on_one_line(names)) is not None:
            row = ConstraintRow(
                "n", "normal force", Displacement(*line), ZERO, 1, unilateral=True, connection=connection
            )
            return [UnilateralConstraint(row, read_restitution(names, self.restitution))], []
        for text in self._misnamed(names):
            body = names.bodies[text.rpartition(".")[0] or GROUND]
            hint = did_you_mean(text, [f"{body.name}.{plane}" for plane in body.planes])
            told = Message("there is no plane {text}.{hint}", text=text, hint=hint)
            names.problem(told, "between" if self.among is None else "among")
        found: tuple[list[UnilateralConstraint], list[DryFriction]] = [], []
        for pair in self._in_space(names, connection):
            for whole, part in zip(found, pair.elements(names), strict=True):
                whole.extend(part)  # pyrefly: ignore[bad-argument-type]
        return found

    def _on_one_line(self, names: Names) -> tuple[Point, Point, Direction] | None:
        """Of two particles that are guided along one line of the ground: the one that is ahead, the other one, and the
        direction; which of them is ahead their places tell, or else that they come nearer. None for anything else."""
        bodies = [names.bodies[text] for text in self.between or () if text in names.bodies]
        if names.space or len(bodies) != 2 or self.friction not in (0, "0") or any(b.turns or b.fixed for b in bodies):
            return None
        behind, ahead = (body.point() for body in bodies)
        along, other = (ground_guide_of(names, body.name, turning=True) for body in bodies)
        if along is None or other is None or not is_parallel(names, along, other):
            return None
        across, between = (_apart(names, behind, ahead, way) for way in (along.normal(), along))
        sense = 0.0 if between is None else number_of(names, between)
        if sense == 0.0:  # they touch: then they come nearer
            speeds = [ZERO if b.start.velocity is None else along_of(b.start.velocity, along) for b in bodies]
            sense = number_of(names, add(speeds[0], negate(speeds[1])))
        if sense == 0.0 or (across is not None and abs(number_of(names, across)) > SAME_PLACE):
            return None
        return (ahead, behind, along) if sense > 0.0 else (behind, ahead, along)

    def _in_space(self, names: Names, connection: str) -> list[PairInSpace]:
        """Bodies on planes, and bodies on bodies."""
        planes, bodies = self._planes(names), self._bodies_in_space(names)
        if not planes and not bodies:
            return []
        field, texts = "between" if self.among is None else "among", self._texts()
        assert texts is not None
        solids = [t for t in texts if t not in planes and names.body(_owner(t), field)]
        if (self.between is not None and len(texts) != 2) or not solids:
            told = Message("between takes two: a body, or a point of one, and a plane or a body; write among for more")
            names.problem(told, field)
            return []
        surface = SurfaceInSpace(
            read_friction(names, self.friction, DIMENSIONLESS),
            read_restitution(names, self.restitution),
            names.positive(self, "rolling_resistance", LENGTH),
            names.positive(self, "spinning_resistance", LENGTH),
        )
        joined = [*itertools.product(solids, planes), *itertools.combinations(bodies, 2)]
        found: list[PairInSpace] = []
        for one, other in joined:
            plane = names.plane(other)
            second = _owner(other) if plane is None else plane.normal.body
            owners = _owner(one), second
            if owners[0] == owners[1] or all(names.known(body).fixed for body in owners):
                continue
            starts = self._start_closed(names, *owners)
            if self.touching is None and is_polyhedron(names, one) and is_polyhedron(names, other):
                starts = False  # of two bodies with faces nobody knows which of them would
            found.append(PairInSpace(connection, one, other, plane, surface, starts, len(joined) == 1))
        return found

    def pairs(self, names: Names, connection: str) -> list[OutlinePair]:
        """The pairs of outlines that may touch."""
        if not self.is_in_plane(names) or self._on_one_line(names) is not None:
            return []
        if self.spinning_resistance not in (0, "0"):
            told = Message("spinning_resistance is for contacts in space")
            names.problem(told, "spinning_resistance")
        surface = ContactSurface(
            read_friction(names, self.friction, DIMENSIONLESS),
            read_restitution(names, self.restitution),
            names.positive(self, "rolling_resistance", LENGTH),
        )
        outlines = self._outlines(names)
        joined = [(a, b) for a, b in itertools.combinations(outlines, 2) if _may_touch(names, a, b)]
        if self.between is not None and len(outlines) == 2 and not joined:
            names.problem(Message("both are fixed and never move apart; one of them must be a moving body"), "between")
        found: list[OutlinePair] = []
        for a, b in joined:
            if a.body == b.body:
                if self.between is not None:
                    names.problem(
                        Message("{a} and {b} are parts of the same body", a=a.label, b=b.label),
                        "between",
                    )
                continue
            if (arc := _arc_beside(names, a, b)) is not None:
                told = Message(
                    "the edge of {body} is part of a circle, and a contact of it is one with lines: let it roll with "
                    "its rim (rolling), or name a point of it, such as {body}.start",
                    body=arc,
                )
                names.problem(told, "between" if self.among is None else "among")
                continue
            if not sites(a, b):
                particles = GROUND not in (a.body, b.body) and not any(names.known(x.body).turns for x in (a, b))
                if particles and names.problems:
                    continue  # what guides them may be among what could not be read
                if self.between is not None and particles and not names.space:
                    told = Message(
                        "{a} and {b} are points, and two points do not touch: give one of them a size (a disk, a "
                        "rectangle), or guide both along one line, each by a slider: {{body: {a}, along: right}}",
                        a=a.label,
                        b=b.label,
                    )
                    names.problem(told, "between")
                elif self.between is not None and not _is_misspelt(names, a, b):
                    names.problem(
                        Message(
                            "there is no contact of {a} with {b}: both are points, or straight lines, or hollow, "
                            "or one a line and one hollow. A contact takes two of {kinds}; one must be a circle, "
                            "a point or a polygon",
                            a=a.label,
                            b=b.label,
                            kinds=KINDS,
                        ),
                        "between",
                    )
                continue
            _look_at_hollows(names, a, b)
            starts = self._start_closed(names, a.body, b.body)
            found.append(OutlinePair(connection, a, b, surface, starts, len(joined) == 1))
        return found

    def valid_where(self, names: Names) -> list[Validity]:
        """A part of a circle touches a line with its round side: where the one that faces it is between its ends."""
        with names.quietly():
            pairs = self.pairs(names, self.own_name(names))
        found: list[Validity] = []
        for pair in pairs:
            for round_, line in ((pair.first, pair.second), (pair.second, pair.first)):
                body = names.bodies.get(round_.label)
                if body is None or not body.is_part_of_a_circle or not line.is_line:
                    continue
                normal = line.straights[0].line.direction.normal()
                turned = Displacement(body.point("middle"), body.center, normal)
                touches = Message("{body} touches with its round side", body=body.name)
                end = Message("{body} gets to the end of its round side", body=body.name)
                found.append(Validity(turned, negate(_reach(body)), -1, touches, end))
        return found

    def _outlines(self, names: Names) -> list[Outline]:
        if (self.between is None) == (self.among is None):
            names.problem(Message("say what touches: between: [ball, ground.floor], or among: [a, b, c] for all pairs"))
            return []
        field = "between" if self.among is None else "among"
        texts = self.between if self.among is None else self.among
        if texts == "all":
            moving = sorted(
                (b.name for b in names.bodies.values() if b.name != GROUND and _has_outline(b)), key=natural
            )
            lines = sorted(names.bodies[GROUND].lines, key=natural)
            texts = [*moving, *(f"{GROUND}.{line}" for line in lines)]
        elif isinstance(texts, str):
            names.problem(Message("among is a list of bodies, points and lines, or all"), "among")
            return []
        assert isinstance(texts, list)
        if self.between is not None and len(texts) != 2:
            names.problem(Message("between takes two, found {n}; write among for more", n=len(texts)), "between")
            return []
        found = [read_outline(names, text, field, k, below=self.below) for k, text in enumerate(texts)]
        return [outline for outline in found if outline is not None]

    def _start_closed(self, names: Names, *bodies: str) -> bool:
        if self.touching is not None:
            return self.touching
        moving = [names.known(body) for body in bodies if not names.known(body).fixed]
        return self.between is not None and all(body.start.at is None for body in moving)

    def lies_along(self, names: Names, body: str) -> Direction | None:
        if names.space or body not in self.mentions(names):
            return None
        with names.quietly():
            pairs = self.pairs(names, "")
        for solid, other in [*((p.first, p.second) for p in pairs), *((p.second, p.first) for p in pairs)]:
            if other.body == body and solid.body == GROUND and len(solid.straights) == 1:
                return solid.straights[0].line.direction
        return None

    def bears_at(self, names: Names, point: Point, normal: Direction) -> Expr | None:
        """What is put nowhere touches at the start: by the lowest of its corners, or of its circle."""
        along, known = self.lies_along(names, point.body), names.known(point.body)
        if along is None or not is_parallel(names, along.normal(), normal) or known.start.angle is not None:
            return None
        with names.quietly():
            pairs = self.pairs(names, "")
        for pair in pairs:
            line, lying = (pair.first, pair.second) if pair.first.body == GROUND else (pair.second, pair.first)
            if pair.starts_closed and lying.rounds and len(line.straights) == 1:
                outward, through = along.normal(), line.straights[0].line.through
                reaches = [add(along_of(part.center.offset, outward), negate(part.radius)) for part in lying.rounds]
                lowest = min(reaches, key=lambda reach: number_of(names, reach))
                above = add(along_of(through.offset, outward), along_of(point.offset, outward), negate(lowest))
                return above if same_way(names, outward, normal) else negate(above)
        return None

    def is_floor_below(self, names: Names, body: str) -> bool:
        known = names.known(body)
        along = self.lies_along(names, body) if self.between is not None and known.start.at is not None else None
        if along is None or known.corners or not is_parallel(names, along, RIGHT):
            return False
        with names.quietly():
            sides = [side for pair in self.pairs(names, "") for side in (pair.first, pair.second)]
        floors = [straight.line for side in sides for straight in side.straights]
        place = place_of(names, known.center)
        if place is None or len(floors) != 1:
            return False
        height = place[1] - number_of(names, floors[0].through.offset[1])
        return height > (1.0 + SAME_PLACE) * (0.0 if known.radius is None else number_of(names, known.radius))

    def mentions(self, names: Names) -> set[str]:
        texts = self.between or (self.among if isinstance(self.among, list) else list(names.bodies))
        return {_owner(t.replace("inside of ", INSIDE)) for t in texts} & set(names.bodies)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        for pair in self._in_space(names, ""):
            first, second = (_owner(t) for t in (pair.first, pair.second))
            if pair.plane is not None:
                yield glyphs.Face(pair.plane.through, names.known(first).center, pair.plane.normal, "rolls")
            else:
                yield glyphs.Touch(first, second, within=pair.first.startswith(INSIDE))
                yield glyphs.Touch(second, first, within=pair.second.startswith(INSIDE))
        pairs = self.pairs(names, "")
        is_rough = self.friction not in (0, "0")
        ordered = [*((p.first, p.second) for p in pairs), *((p.second, p.first) for p in pairs)]
        for solid, other in ordered:
            yield glyphs.Touch(solid.body, other.body, within=bool(solid.hollows))
            tips = tuple(glyphs.Tip(r.center, r.radius, r.body) for r in other.rounds)
            for straight in solid.straights:
                if straight.length is None:
                    yield glyphs.Surface(straight.line.through, straight.line.direction, tips, straight.body, is_rough)


def _has_outline(body: Any) -> bool:
    return (body.radius is not None and not body.edges) or bool(body.corners) or not body.turns


def _is_misspelt(names: Names, *outlines: Outline) -> bool:
    """Whether a point of a body that there is not is told already, or one of the ground that is declared nowhere is
    called almost as a line of it; says so."""
    lines = names.bodies[GROUND].lines
    for outline in outlines:
        body, _, point = outline.label.partition(".")
        own = names.bodies.get(body)
        if own is not None and body != GROUND and point and point not in own.points and point not in own.lines:
            return True
        close = difflib.get_close_matches(point, lines, n=1) if body == GROUND else []
        if close and point in names.free_ground_points:
            told = Message(
                "there is no line {name} on the ground. Did you mean {x}?", name=point, x=f"{GROUND}.{close[0]}"
            )
            names.problem(told, "between")
            return True
    return False


def _arc_beside(names: Names, first: Outline, second: Outline) -> str | None:
    """The body of which a part of a circle is to touch what is no line."""
    for own, other in ((first, second), (second, first)):
        body = names.bodies.get(own.label)
        if body is not None and body.is_part_of_a_circle and not other.is_line:
            return body.name
    return None


def _reach(body: RigidBody) -> Expr:
    """How far the ends of its round side are from the centre, along the middle."""
    (cx, cy), (mx, my), (sx, sy) = (body.point(name).offset[:2] for name in ("center", "middle", "start"))
    return divide((mx - cx) * (sx - cx) + (my - cy) * (sy - cy), body.radius or ONE)


def _look_at_hollows(names: Names, a: Outline, b: Outline) -> None:
    """A circle inside a ring is the smaller one."""
    for outer, inner in ((a, b), (b, a)):
        for hollow in outer.hollows:
            for part in inner.rounds:
                look_at_fit(names, inner.body, part.radius, hollow.body, hollow.radius, "between")


def _apart(names: Names, first: Point, second: Point, along: Direction) -> Expr | None:
    """How far a particle is from another one along a direction of the ground at the start, where the file says so."""
    places: list[Expr | None] = []
    for point in (first, second):
        at = names.known(point.body).start.at
        place = None if at is None else along_of(at[1], along)
        places.append(place or begins_at(names, point, along) or stands_at(names, point, along))
    start, end = places
    return None if start is None or end is None else add(end, negate(start))


def _may_touch(names: Names, a: Outline, b: Outline) -> bool:
    return not (names.known(a.body).fixed and names.known(b.body).fixed)


def _owner(text: str) -> str:
    """The body of which `inside bowl`, `rod.end` or `ball` speaks."""
    return text.removeprefix(INSIDE).partition(".")[0]
