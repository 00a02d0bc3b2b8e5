"""Resolves what a user wrote of bodies, points and directions to what it means."""

from __future__ import annotations

import difflib
import re
from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from copy import copy
from dataclasses import replace
from pathlib import Path
from typing import Any, ClassVar, Protocol, cast

from freebody.language.expression import (
    Call,
    Expr,
    number,
)
from freebody.language.folded import folded
from freebody.language.natural import natural
from freebody.language.notation import to_text
from freebody.language.sentences import Message, listed
from freebody.language.units import (
    DIMENSIONLESS,
    Dimension,
)
from freebody.measures.base import Measure
from freebody.measures.geometry import COMPASS, GROUND, ONE, ZERO, Components, Direction, Point
from freebody.model.curves import CurvePlace, LevelPlace
from freebody.model.elements import (
    AppliedLoad,
    Attitude,
    BodyPlane,
    ConstraintRow,
    DryFriction,
    Line,
    RigidBody,
    UnilateralConstraint,
)
from freebody.model.formulas import Formulas
from freebody.model.noting import did_you_mean, reads
from freebody.model.rotations import UNIT, Columns, applied, is_one
from freebody.model.states import ControllerState
from freebody.model.surfaces import SurfacePlace
from freebody.model.thread import Thread
from freebody.model.transmitted import CutTension, Transmitted
from freebody.tolerances import LEAST

_WAYS_IN_GERMAN = {"oben": "up", "unten": "down", "rechts": "right", "links": "left"}
ALSO_WAYS = {  # what people call right, left, up and down
    **{f"{way}{end}": way for way in ("right", "left", "up", "down") for end in ("ward", "wards")},
    **{f"to the {way}": way for way in ("right", "left")},
    **{f"{to}{word}": way for to in ("", "nach ") for word, way in _WAYS_IN_GERMAN.items()},
}

# what leaves the sense of a direction open, and the two that it may be
_LEVEL = {
    "horizontal": {"first": "right", "second": "left"},
    "vertical": {"first": "up", "second": "down"},
}


def placeholder(name: str) -> RigidBody:
    """Stands in for a body that could not be read; anything may be asked of it."""
    return RigidBody(
        name,
        ZERO,
        ZERO,
        dict.fromkeys(("center", "mass_center"), (ZERO, ZERO)),
        "center",
        radius=number(1),
        is_placeholder=True,
    )


class Joining(Protocol):
    """What the description asks of connections while it is read."""

    meeting: ClassVar[tuple[str, str] | None]

    # it keeps its bodies as one; it leaves free how they turn; a body that only such hold hangs on them
    is_rigid: ClassVar[bool]
    lets_turn: ClassVar[bool]
    lets_hang: ClassVar[bool]
    follows_joints: ClassVar[bool]
    # its forces act where its bodies touch
    has_contact_point: ClassVar[bool]

    def keeps_as_one(self, names: Names) -> bool:
        """Whether the places of its bodies are those of one body."""
        ...

    def straight_between(self, names: Names) -> tuple[Point, Point] | None:
        """The ends of what is a straight line between two points, as a link is."""
        ...

    def joined_points(self, names: Names) -> tuple[Point, Point] | None:
        """The two points that it keeps together while both bodies turn, in the plane."""
        ...

    def to_plain(self) -> dict[str, Any]:
        """Its fields, as they were given."""
        ...

    @property
    def is_one_force(self) -> bool:
        """Whether what it transmits at several places is one force to people."""
        ...

    def level_places(self, names: Names) -> tuple[LevelPlace, ...]:
        """The lowest and highest places of a curve that it keeps something on."""
        ...

    def keeps_flat(self, names: Names) -> bool:
        """In space: whether it does no more than to make a body one of the plane of x and y."""
        ...

    def guide_of(self, names: Names, body: str, *, turning: bool) -> Direction | None:
        """The direction of the ground along which it guides a body, which may turn or not (turning: either)."""
        ...

    def lies_along(self, names: Names, body: str) -> Direction | None:
        """The direction of a line of the ground that bears a body, which may leave it."""
        ...

    def is_floor_below(self, names: Names, body: str) -> bool:
        """Whether it is no more to a body than a level floor on which it may land, and above which it is put."""
        ...

    def room_between(self, names: Names, body: str, place: str) -> Measure | Message | None:
        """What vanishes where a body gets to the place to which it leads it, or why that never happens."""
        ...

    def rows(self, names: Names) -> list[ConstraintRow]:
        """The measures that it holds."""
        ...

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        """The measures that it bounds, and those along which it resists by dry friction."""
        ...

    def attitude(self, names: Names) -> Attitude | None:
        """In space: how one of its bodies is turned from the other."""
        ...

    def carried_by(self, names: Names, point: Point) -> Point | None:
        """The point of a guided body, which does not turn, to which it joins a point."""
        ...

    def bears_at(self, names: Names, point: Point, normal: Direction) -> Expr | None:
        """How far along the normal of a line of the ground, on which its body lies at the start, a point is."""
        ...

    def keeps_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        """How far along a direction of the ground it keeps a point of one of its bodies."""
        ...

    def parts(self, names: Names) -> dict[str, Expr]:
        """The parts of the force between its teeth: what the tooth force is multiplied by for each."""
        ...

    def bearing(self, names: Names) -> tuple[Point, Point, Direction, Direction] | None:
        """Of a joint of space in which one body does nothing but turn against the other: points and axes of both."""
        ...

    def tensions(self, names: Names) -> Mapping[str, CutTension]:
        """Of what has mass and is laid over places: the tension at each."""
        ...

    def weighs(self, names: Names, body: str, along: Direction) -> tuple[Measure, Expr] | None:
        """Of a body whose weight does not act at one point: what it pushes, and the law for a field of strength 1."""
        ...

    def loads_bearings(self, names: Names) -> Mapping[str, str]:
        """The bodies whose bearings carry forces of it that it does not tell, and why."""
        ...

    def curve_place(self, names: Names) -> CurvePlace | None:
        """Where it keeps a point beside a curve, if its foot there is a coordinate of its own."""
        ...

    def foot(self, names: Names) -> CurvePlace | SurfacePlace | None:
        """Where it keeps a point beside a curve or a surface, if its foot there has coordinates of its own."""
        ...

    def brings(self, names: Names) -> dict[str, AppliedLoad]:
        """Loads that belong to it, by their names."""
        ...

    def transmitted(self, names: Names) -> Mapping[str, Transmitted]:
        """What it can be asked for beside its reactions, by the words that ask for it."""
        ...

    def aside_of_way(self, names: Names) -> Measure | Message:
        """Of a cam: by how much it pushes aside of the way on which its follower is guided."""
        ...

    def edge_radius(self, names: Names) -> Measure | Message:
        """Of a cam: the radius of curvature of its edge where it touches."""
        ...

    def thread(self, names: Names) -> Thread | Message:
        """Of a screw or a worm: the slope and the friction of its thread."""
        ...

    def mentions(self, names: Names) -> set[str]:
        """Names of the bodies that it joins."""
        ...


# What does not move, as people call it: the name of a point of the ground where nothing else is called so.
SURROUNDINGS = frozenset((
    "wall", "ceiling", "support", "frame", "base", "anchor", "hook", "bracket", "foundation", "fixed", "Wand", "Decke",
    "Gestell", "Lager", "Fundament",
))  # fmt: skip


def is_of_surroundings(name: str) -> bool:
    """Whether a name is that of something that does not move: `wall`, also `left_wall` or `wall2`."""
    words = [word.rstrip("0123456789") for word in name.split("_")]
    return name in SURROUNDINGS or any(word in SURROUNDINGS for word in (words[0], words[-1]))


# What people call the ground where no body is called so, and points that bodies have by other names.
_THE_GROUND = frozenset(
    ("world", "gestell", "frame", "base", "fundament", "foundation", "umgebung", "boden", "erdboden")
)
_SAME_POINTS: Mapping[str, str] = {
    **dict.fromkeys(("anfang", "beginning"), "start"),
    **dict.fromkeys(("ende", "tip"), "end"),
    **dict.fromkeys(("centre", "middle", "mitte", "mittelpunkt"), "center"),
    **dict.fromkeys(("com", "cm", "cg", "center_of_mass", "centre_of_mass", "schwerpunkt"), "mass_center"),
}


class Names(Formulas):
    """The names of one model in the making."""

    def __init__(self) -> None:
        super().__init__()
        self.folders: Sequence[Path] = ()  # in which its tables are: that of the model file
        self.taken = self.bodies = dict[str, RigidBody]()
        self.measures: dict[str, Measure] = {}
        self.states: dict[str, ControllerState] = {}
        self.connections: Mapping[str, Joining] = {}
        self.called: dict[str, tuple[str, ...]] = {}  # words for the kind of each body, connection and load
        self.of_fields: list[tuple[str, str]] = []  # parameters that alone are what a field says, and its words
        self.placed_at_start: dict[str, Expr] = {}  # where the file lets named measures start
        self.started_at_zero: set[str] = set()  # named measures that the file lets start at zero
        self.starts_away = False  # a named measure, or its rate, starts away from zero
        self.start_rates: dict[str, Expr] = {}  # of named measures, as the file gives them
        self.constraint_rows: list[ConstraintRow] = []
        self.loads: dict[str, Dimension] = {}  # the dimension of what each load exerts
        self.impulses: frozenset[str] = frozenset()  # the loads that act in no time
        self.strikes: tuple[AppliedLoad, ...] = ()  # what they push, and by which impulse
        self.struck_at_start: frozenset[str] = frozenset()  # what closes and strikes at the start
        self.struck_when: Mapping[str, str] = {}  # what closes and strikes in mid-motion: the words of its event
        self.applied_loads: list[
            AppliedLoad
        ] = []  # what the loads push, known before the connections say what they hold
        self.fields: set[tuple[Direction, Expr]] = set()  # of gravity: along which direction, and how strong
        self.free_ground_points: dict[str, tuple[str | int, ...]] = {}
        self.by_coordinates: set[str] = set()  # points of the ground that coordinates make, which somebody wrote
        self.counted_from_right: set[str] = set()  # angles of bodies that the file does not name
        self.hung: set[str] = set()  # bodies that are taken to hang at the start, since nothing says where they are
        self.laying: list[Joining] = []  # strings whose way is being found, which place nothing yet
        self.standing: dict[tuple[object, ...], Expr | None] | None = None  # where points stand on a way
        self.up: Components = (ZERO, ONE)
        self.unused = frozenset[str]()  # parameters that only questions can name
        self.shares: set[str] = set()  # parameters that are coefficients of restitution
        self.counts: set[str] = set()  # parameters that are numbers of teeth
        self.usual_questions: tuple[str, ...] = ()  # what the file asks, in the words of the grammar
        self.frames: dict[str, tuple[str, Columns]] = {}  # the body each is fixed in, and its axes there
        self.wants_number = False  # a question that needs one number is being read

    @contextmanager
    def one_number(self, *, wanted: bool = True) -> Generator[None]:
        """Inside, the velocity and the acceleration of what is guided along a line of the ground are those along it."""
        before, self.wants_number = self.wants_number, wanted
        try:
            yield
        finally:
            self.wants_number = before

    def for_questions(self) -> Names:
        """The same names for what is asked later, whose problems and points of the ground are its own."""
        names = copy(self)
        names.problems, names.assumptions, names.laying = [], [*self.assumptions], []
        names.standing, names.used = None, {*self.used}
        names.unused = frozenset(names.parameters.keys() - self.used)
        names.broken, names.told_once = {*self.broken}, {*self.told_once}
        names.free_ground_points = {}
        ground = self.bodies[GROUND]
        names.bodies = {**self.bodies, GROUND: replace(ground, points=dict(ground.points))}
        return names

    @property
    def closing_later(self) -> frozenset[str]:
        """The connections that close in mid-motion."""
        return frozenset(self.struck_when.keys() & self.connections.keys())

    @property
    def lets_go_from_rest(self) -> bool:
        """Whether the file gives no velocity, no rate and no blow."""
        moves = any(body.start.moves for body in self.bodies.values())
        moves |= any(rate != ZERO for rate in self.start_rates.values())
        return not (moves or self.impulses or self.struck_at_start)

    @property
    def compass(self) -> dict[str, Direction]:
        """What directions are called, on the ground."""
        if not self.space:
            return COMPASS
        named = {axis: UNIT[k] for k, axis in enumerate("xyz")}
        named |= {"right": UNIT[0], "left": tuple(-c for c in UNIT[0])}
        named |= {"up": self.up, "down": tuple(-c for c in self.up)}
        named |= {f"-{axis}": tuple(-c for c in UNIT[k]) for k, axis in enumerate("xyz")}
        return {name: Direction(GROUND, components, name) for name, components in named.items()}

    @property
    def _example(self) -> str:
        return "[x, y, z]" if self.space else "[x, y]"

    @property
    def ground_origin(self) -> Point:
        return Point(GROUND, self.origin, "ground.origin")

    @reads
    def body(self, name: str, *path: str | int) -> RigidBody:
        found = self.bodies.get(name)
        if found is None:
            hint = did_you_mean(name, self.bodies)
            if GROUND in self.bodies and name in self.bodies[GROUND].points:
                hint = Message(" Did you mean {x}?", x=f"{GROUND}.{name}")
            elif name in self.connections:
                joined = sorted(self.connections[name].mentions(self) - {GROUND}, key=natural)
                hint = Message(" {name} is the connection of {names}: name a body.", name=name, names=listed(joined))
            self.unknown(name, Message("there is no body {name}.{hint}", name=name, hint=hint), *path)
            return placeholder(name)
        return found

    def known(self, name: str) -> RigidBody:
        """A body that was looked up before; a stand-in if that failed."""
        return self.bodies.get(name) or placeholder(name)

    @reads
    def point(self, text: Any, *path: str | int) -> Point:
        """`body.point`, or `body` for its reference point, that of the ground its origin. A ground point that is not
        declared is the origin; one that is declared also has its plain name, as a line has, if no body is called so."""
        if not isinstance(text, str):
            self.problem(Message("expected a point such as rod.end, found {text}", text=repr(text)), *path)
            return self.bodies[GROUND].point("origin")
        if (found := re.fullmatch(r"(\w+) at (.+)", text.strip())) and "end" in self.known(found[1]).points:
            told = Message(
                "{text} is no point: declare it, by its distance from the middle of {body}: {body}: {{points: {{P: "
                "[{x} - ({half}), 0]}}}} where {x} counts from {body}.start, and write {body}.P",
                text=text.strip(),
                body=found[1],
                x=found[2],
                half=to_text(self.known(found[1]).points["end"][0]),
            )
            self.problem(told, *path)
            return self.known(found[1]).point()
        body_name, _, point_name = text.strip().partition(".")
        if body_name not in self.bodies and not point_name and self._is_ground_point(body_name):
            body_name, point_name = GROUND, body_name
        if body_name not in self.bodies and not point_name and is_of_surroundings(body_name):
            body_name, point_name = GROUND, body_name
        if body_name not in self.bodies and point_name and folded(body_name) in _THE_GROUND:
            told = Message("{name} is no body of the model: it is the ground", name=body_name)
            self.assumptions += [] if told in self.assumptions else [told]
            body_name = GROUND
        body = self.body(body_name, *path)
        if body_name not in self.bodies or body.is_placeholder:
            return body.point()
        if point_name not in body.points and (same := _SAME_POINTS.get(folded(point_name))) in body.points:
            point_name = same or point_name
        if not point_name:
            return self.ground_origin if body_name == GROUND else body.point()
        if point_name in body.points:
            return body.point(point_name)
        if body_name == GROUND:
            self.free_ground_points.setdefault(point_name, (*self._path, *path))
            return Point(GROUND, self.origin, text.strip())
        if not re.fullmatch(r"\w+", point_name):
            told = Message(
                "{text} is no point: declare one in {body}, by its place from {middle}: {body}: {{points: {{P: "
                "{example}}}}}, and write {body}.P",
                text=text.strip(),
                body=body_name,
                middle=body.default_point,
                example=self._example,
            )
            self.problem(told, *path)
            return body.point()
        hint = did_you_mean(point_name, body.points)
        if {"start", "end"} <= body.points.keys() and not difflib.get_close_matches(
            point_name, body.points, cutoff=0.6
        ):
            hint = Message(" Its ends are {body}.start and {body}.end, in its middle is {body}.center.", body=body_name)
        self.problem(
            Message(
                "{body_name} has no point {point_name}.{hint} Points of your own: {body_name}: {{points: "
                "{{{point_name}: {example}}}}}",
                body_name=body_name,
                point_name=point_name,
                hint=hint,
                example=self._example,
            ),
            *path,
        )
        return body.point()

    def _is_ground_point(self, name: str) -> bool:
        return GROUND in self.bodies and name in self.bodies[GROUND].points

    def line(self, text: Any, *path: str | int) -> Line | None:
        """`body.line`; of the ground also plain `line`."""
        if not isinstance(text, str):
            return None
        body_name, _, line_name = text.strip().partition(".")
        if not line_name:
            return self.bodies[GROUND].lines.get(body_name)
        body = self.bodies.get(body_name)
        return None if body is None else body.lines.get(line_name)

    def edge(self, text: Any) -> Line | None:
        """A line, or the straight side of a body: `block.top`."""
        if (line := self.line(text)) is not None or not isinstance(text, str):
            return line
        owner, _, name = text.strip().partition(".")
        body = self.bodies.get(owner)
        return None if body is None else body.side(name)

    def edge_along(self, text: Any) -> Line | None:
        """A line, or a side whose name is no word for a direction: `cart.right` is the right of the cart."""
        is_word = isinstance(text, str) and text.strip().rpartition(".")[2] in self.compass
        return self.line(text) if is_word else self.edge(text)

    def plane(self, text: Any, *path: str | int) -> BodyPlane | None:
        """`body.plane`; of the ground also plain `plane`."""
        if not isinstance(text, str):
            return None
        owner, _, name = text.strip().rpartition(".")
        body = self.bodies.get(owner or GROUND)
        return None if body is None else body.planes.get(name)

    @reads
    def direction(self, value: Any, *path: str | int, body: str = GROUND) -> Direction:
        """right, left, up, down; an angle from the x axis; components; a line, or the side of a body; `body.x` for a
        body's axis, `frame.x` for that of a frame."""
        if isinstance(value, (list, tuple)):
            n_before = len(self.problems)
            along = self.components(cast("list[Any]", value), DIMENSIONLESS, *path)
            if len(self.problems) > n_before:
                return self.compass["right"]
            return self.unit_direction(body, along, *path)
        if isinstance(value, str):
            text = value.strip()
            for prefix in ("against ", "opposite to ", "opposite of "):
                if text.startswith(prefix):
                    return self.direction(text.removeprefix(prefix), *path, body=body).reversed()
            for prefix in ("normal to ", "normal of ", "perpendicular to "):
                if text.startswith(prefix):
                    return self.direction(text.removeprefix(prefix), *path, body=body).normal()
            text = text.removeprefix("along ")
            text = ALSO_WAYS.get(text, text)
            if text.startswith("[") and text.endswith("]"):
                parts: list[Any] = [part.strip() for part in text[1:-1].split(",")]
                return self.direction(parts, *path, body=body)
            if text in self.compass and text in self.bodies[GROUND].lines:
                told = Message(
                    "{name} is a direction and a line of the ground; call the line something else", name=text
                )
                self.problem_once(told, *path)
            if (named := self.named_direction(text, body)) is not None:
                return named
            if text.startswith("-") and (named := self.named_direction(text[1:].strip(), body)) is not None:
                return named.reversed()
            if text in _LEVEL:
                told = Message(
                    "{text} leaves two directions open: write {first} or {second}", text=text, **_LEVEL[text]
                )
                self.problem(told, *path)
                return self.compass["right"]
            word = text.removeprefix("-").strip()
            if re.fullmatch(r"[A-Za-z_]+(\.[A-Za-z_]\w*)?", word) and word not in self.parameters and word != "pi":
                if word.partition(".")[2] in self.bodies.get(word.partition(".")[0], placeholder("")).points:
                    told = Message(
                        "{text} is no direction: it is a point. Write right, left, up, down, an angle such as 30 deg, "
                        "components [1, 2], a line, or body.x",
                        text=text,
                    )
                    self.problem(told, *path)
                    return self.compass["right"]
                if self.is_broken_in(text):
                    return self.compass["right"]  # what it is may stand where nothing could be read
                known = [*self.compass, *self.bodies[GROUND].lines, *self.bodies[GROUND].planes]
                known += [f"{b.name}.{line}" for b in self.bodies.values() for line in (*b.lines, *b.sides)]
                self.problem(
                    Message(
                        "{text} is no direction.{hint} Write right, left, up, down, an angle such as 30 deg, "
                        "components [1, 2], a line, or body.x",
                        text=text,
                        hint=did_you_mean(text, known),
                    ),
                    *path,
                )
                return self.compass["right"]
        angle = self.angle(value, *path)
        shown = str(value)
        along = (Call("cos", angle), Call("sin", angle), *self.origin[2:])
        return self.fixed_in(body, along, shown)

    def named_direction(self, text: str, body: str = GROUND) -> Direction | None:
        """One that has a name: of the compass, of a line or a plane, of an axis of a body or a frame."""
        compass = self.compass
        if text in compass:
            return self.fixed_in(body, compass[text].components, text)
        line, plane = self.edge_along(text), self.plane(text)
        if line is not None:
            return line.direction
        if plane is not None:
            return plane.normal
        owner, _, axis = text.partition(".")
        if axis == "axis" and self.axis_of(owner):
            return Direction(owner, self.axis_of(owner), text)
        if axis in compass and (owner in self.bodies or owner in self.frames):
            return self.fixed_in(owner, compass[axis].components, text)
        if text in self.bodies and self.axis_of(text):
            return Direction(text, self.axis_of(text), f"{text}.axis")
        along = getattr(self.connections.get(text), "along", None)  # of a guide
        if along is not None and along != text and text not in self.bodies:
            return self.direction(along)
        if text in self.bodies and self.bodies[text].corners == ("start", "end"):  # along a rod is one direction alone
            return Direction(text, UNIT[0][: len(self.origin)], f"{text}.x")
        return None

    def fixed_in(self, owner: str, along: Components, name: str = "") -> Direction:
        """A direction by components along the axes of a body or of a frame."""
        if owner in self.frames:
            body, axes = self.frames[owner]
            return Direction(body, applied(axes, along), name)
        return Direction(owner, along, name)

    def axis_of(self, name: str) -> Components:
        """The axis of a round body in space; empty where there is none."""
        return self.bodies[name].axis if name in self.bodies else ()

    def unit_direction(self, body: str, along: Components, *path: str | int) -> Direction:
        numbers = [self.numeric(c) for c in along]
        if all(n is not None and abs(n) < LEAST for n in numbers):
            self.problem(Message("a direction must not be {x}; it needs a length", x=[0] * len(along)), *path)
            return self.compass["right"]
        square: Expr = ZERO
        for c in along:
            square = square + c * c
        if sum(c != ZERO for c in along) == 1 and None not in numbers:
            return self.fixed_in(body, tuple(number((n > 0) - (n < 0)) for n in numbers if n is not None))
        size = ONE if is_one(along) else Call("sqrt", square)
        return self.fixed_in(body, tuple(c / size for c in along))

    @reads
    def radius(self, name: str, *path: str | int, inside: bool = False) -> Expr:
        """Of a round body; inside: of what is hollow in it, where something is."""
        body = self.body(name, *path)
        radius = body.inside_radius if inside else body.radius
        if radius is not None:
            return radius
        own = body.middle_circles
        if len(own) == 1:
            return next(iter(own.values()))
        told = Message("{name} has no radius; make it a disk, ring or sphere, or give its body a radius", name=name)
        if not body.turns and not own:
            told = Message(
                "{name} is a point and has no radius; a pulley on it is a body of its own: pulley: {{disk: {{radius: "
                "r}}}} with axle: {{pin: [{name}, pulley]}}",
                name=name,
            )
        if own:
            known = ", ".join(f"{to_text(r)} ({part})" for part, r in own.items())
            told = Message("{name} has several circles: say which, as its radius: {known}", name=name, known=known)
        self.problem(told, *path)
        return number(1)
