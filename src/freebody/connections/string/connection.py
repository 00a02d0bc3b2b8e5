"""Inextensible, massless string over any number of pulleys."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, ClassVar, cast

from pydantic import ConfigDict, Field

from freebody.connections.base import Connection
from freebody.connections.standing import (
    ground_guide_of,
    ground_line_under,
    is_parallel,
    moves_out_of_plane,
    number_of,
    starts_at,
)
from freebody.connections.string.capstan import DrumPassage, drum_name, frictions, rough_drums, rub
from freebody.connections.string.carried import askew_on_carriers, with_carried_leads
from freebody.connections.string.gripping import is_kept_from_turning, named_grips, wheels_that_turn
from freebody.connections.string.hanging import Hook, askew
from freebody.connections.string.in_space import SpatialRun, lie_in_space
from freebody.connections.string.laying import (
    StringLead,
    StringRun,
    check_ends,
    is_sure,
    leads_of,
    run_over,
)
from freebody.connections.string.node import StringNode
from freebody.connections.string.sections import StringSection, sections_of
from freebody.connections.string.tackle import drawn_falls, lossy_sheaves, with_falls
from freebody.connections.string.way import is_held, is_round, is_way_given, named_on, places_given, read_way
from freebody.language.expression import Expr, add, negate
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, ONE, RIGHT, ZERO, Direction, Point
from freebody.measures.turned import turned_in
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint, Validity
from freebody.model.friction import Friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names


# `slip: false`: it grips every pulley that can turn, as it does anyhow; which truth value says that it slips.
_SLIPS = {"slip": True, "slips": True, "no_slip": False, "slipping": True}


_BOTH_ENDS = ("bodies", "between", "ends", "connects")
_PULLEYS = ("pulley", "pulleys", "around", "via", "passes_over", "runs_over")


def _with_ends(given: dict[str, Any]) -> dict[str, Any]:
    """`{between: [a, b], pulley: p}` as from one end over what is on the way to the other."""
    read = dict(given)
    ends = next((word for word in _BOTH_ENDS if isinstance(given.get(word), list)), None)
    both = cast("list[Any]", given[ends]) if ends is not None else []
    is_free = not given.keys() & {"from", "to", "path"}
    if ends is not None and is_free and len(both) == 2 and all(isinstance(end, str) for end in both):
        read |= {"from": both[0], "to": both[1]}
        del read[ends]
    over = next((word for word in _PULLEYS if isinstance(given.get(word), str | list)), None)
    if over is not None and not given.keys() & {"over", "under", "path"}:
        read["over"] = read.pop(over)
    return {key: [each] if key == "over" and isinstance(each, str) else each for key, each in read.items()}


class String(Connection, kind="string"):
    """`string: {from: left, over: [pulley], to: right}`; longer ways as a list, with hubs and drums:
    `string: {path: [wound on drum radius r at right, under moving, over fixed, ground.A]}`.

    The string does not slip on the pulleys that it `grips` (default: all bodies that can turn); over the others it
    slides without friction. Each stretch between grips keeps its length and has one tension, positive when it pulls.
    Between two points its length may be given; it is taut at the start, and what it carries swings: `{from: ground.O,
    to: ball, length: L}`. A body that nothing else holds hangs on the string and moves up and down, below the point
    where its lead leaves the pulley, if it has no position or is put there; a lead to a body on a straight guide runs
    along the guide if the body has no position, or one from which it does so whatever the parameters are; `leads`
    states the directions instead; otherwise leads are the common tangents of the circles, wherever these move
    (`swings: true` also for hanging bodies); along a guide on a body that turns, as of a trolley on a jib, it keeps
    the direction of that. In space it runs from point to point, through rings and over small pulleys, or over wheels
    in any plane: each turns about the axis of its revolute joint, which has to keep its direction, and what is at an
    end is guided in the plane of the wheel beside it or hangs. Between wheels whose axes are not parallel it runs
    along the line in which their planes meet, and from the ground to wheels on a jib that turns along the axis of
    that turn; a drum is wound `clockwise` or `counterclockwise` as seen against its axis, and `left` is where x is
    negative.
    `friction`: that of the drums and pulleys over which it slides, one coefficient or {drum: mu}. The tensions on both
    sides of a drum differ by up to e^(mu beta), beta the angle of wrap between leads with constant directions, or
    `wrap: {drum: 3*pi}`; ask for the tension at an end, or between two places.
    `falls: n`: of a tackle, whose blocks are the last two places on the way and whose sheaves stand side by side on two
    axles: the string runs n times between them, and all falls are parallel:
    `{from: hand, over: [upper], to: load, falls: 4}`. `efficiency`: by how much each of the n sheaves lets the tension
    fall; that of the falls is their mean."""

    called: ClassVar[tuple[str, ...]] = (
        "rope",
        "cord",
        "cable",
        "thread",
        "wire",
        "line",
        "capstan",
        "rope friction",
        "bollard",
    )
    also: ClassVar[tuple[str, ...]] = ("rope", "cord", "cable", "thread", "Seil", "Faden", "Schnur")
    elsewhere: ClassVar[Mapping[str, str]] = {
        "angle": Message(
            "its direction follows from where its ends are put, e.g. from: [-1 m*cos(alpha), 1 m*sin(alpha)], with at: "
            "[0, 0] in the body to which it leads"
        ),
        "radius": Message("it is wound on a circle of another radius than the rim as: to: wound on yoyo radius r"),
        **dict.fromkeys(
            ("wound_on", "wound", "winds", "unwinds", "unwinds_from"),
            Message("what it is wound on is one of its ends, with its side: to: wound on yoyo at right"),
        ),
        **dict.fromkeys(
            (*_BOTH_ENDS, *_PULLEYS),
            Message("its way is from one end over pulleys to the other: {{from: a, over: [pulley], to: b}}"),
        ),
    }

    instead: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("band_brake", "band", "strap_brake", "Bandbremse"),
            Message(
                "the band is a string with friction: string: {{from: ground.A, over: [drum], to: lever.P, friction: "
                "{{drum: mu}}}}, its angle on the drum, where its leads do not tell, wrap: {{drum: 180 deg}}"
            ),
        ),
        **dict.fromkeys(
            ("capstan", "bollard"),
            Message(
                "the rope is a string with friction: string: {{from: A, over: [drum], to: B, friction: mu, turns: 2}}"
            ),
        ),
    }
    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {
        "turns": ("wrap",),
        **dict.fromkeys(_SLIPS, ("grips",)),
    }

    start: str | None = Field(default=None, alias="from")
    to: str | None = None
    over: list[str] = Field(default_factory=list[str])
    under: list[str] = Field(default_factory=list[str])
    path: list[str] = Field(default_factory=list[str])
    grips: list[str] | None = None
    leads: list[Heading] | None = None
    swings: bool = False
    length: Formula | None = None
    friction: Formula | dict[str, Any] = 0
    wrap: Formula | dict[str, Formula] | None = None
    falls: Formula = 1
    efficiency: Formula | None = None

    model_config = ConfigDict(populate_by_name=True)

    in_plane = True
    lets_hang: ClassVar[bool] = True
    example = """
bodies: {pulley: {disk: {mass: 1 kg, radius: 1 m}}, a: {particle: {mass: 1 kg}}, b: {particle: {mass: 2 kg}}}
connections: {p: {pin: [ground.A, pulley]}, it: {string: {from: a, over: [pulley], to: b}}}
"""

    more_examples: ClassVar[dict[str, str]] = {
        "between wheels with perpendicular axes": """
space: {up: z}
ground: {points: {A: [0, 0, 0], B: [0.5 m, 2 m, -0.3 m], G: [0, -0.5 m, 0]}}
bodies:
  sledge: {box: {mass: 2 kg, size: [0.4 m, 0.2 m, 0.1 m]}, near: {at: [-2 m, -0.5 m, 0]}}
  one: {disk: {mass: 1 kg, radius: 0.5 m, axis: z}}
  other: {disk: {mass: 1 kg, radius: 0.3 m, axis: x}}
  load: {particle: {mass: 1 kg}}
connections:
  rail: {prismatic: {first: ground.G, second: sledge, along: x}}
  p: {revolute: {first: ground.A, second: one, about: z}}
  q: {revolute: {first: ground.B, second: other, about: x}}
  it: {string: {path: [sledge, around one, over other, load]}}
"""
    }

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """A list of places is the way of the string: [a, b] from a to b, [a, pulley, b] over the pulley between, also
        with the way written before some of them, [a, over pulley, under hook, b]; turns: n is the angle of n
        turns."""
        items: list[Any] = cast("list[Any]", value) if isinstance(value, list) else []
        if len(items) > 1 and all(isinstance(item, str) for item in items):
            if not any(" " in item.strip() for item in items):
                return {"from": items[0], "over": items[1:-1], "to": items[-1]}
            between = [item if " " in item.strip() else f"over {item}" for item in items[1:-1]]
            return {"path": [items[0], *between, items[-1]]}
        given = _with_ends(super().from_plain(value))
        if "turns" in given and "wrap" not in given:
            given["wrap"] = f"({given.pop('turns')})*2*pi"
        slips = [given.pop(word) is is_so for word, is_so in _SLIPS.items() if isinstance(given.get(word), bool)]
        if slips and slips[0]:
            given.setdefault("grips", [])
        return given

    def _places(self) -> list[tuple[str, tuple[str | int, ...]]]:
        """The places on its way, and where in the model each is written."""
        return places_given(self)

    def is_in_plane(self, names: Names) -> bool:
        if not names.space or self._is_of_points(names) or self.leads is not None:
            return not self._is_of_points(names)
        way = self._places_read(names)
        return way is None or not self._is_of_space(names, way)

    def _is_of_space(self, names: Names, way: list[StringNode]) -> bool:
        """In space: whether something on its way moves elsewhere than in the plane of x and y."""
        return moves_out_of_plane(names, (node.body for node in way if node.body != GROUND))

    def _places_read(self, names: Names) -> list[StringNode] | None:
        places, fields = zip(*self._places(), strict=True) if self._places() else ((), ())
        with names.quietly():
            return read_way(names, places, fields, swings=True)

    def _is_of_points(self, names: Names) -> bool:
        """In space: whether it runs from point to point, through rings and over small pulleys, and not in the plane."""
        if not names.space or self.leads is not None:
            return False
        way = self._places_read(names)
        flat = {body for c in names.connections.values() if c.keeps_flat(names) for body in c.mentions(names)}
        return way is not None and all(
            node.radius == ZERO and (node.body == GROUND or node.body not in flat) for node in way
        )

    def rows(self, names: Names) -> list[ConstraintRow]:
        run = self._run(names)
        if run is None:
            return []
        grips = self._grips(names, run)
        if not self._is_of_points(names) and not isinstance(run, SpatialRun):
            check_ends(names, run)
        sections = sections_of(run, grips)
        rough = rough_drums(self.friction, _slid_over(sections))
        return [
            *(
                self._as_long_as_given(names, section.row(len(sections), rough | self._lossy(run)))
                for section in sections
            ),
            *self._hanging(names, run),
            *self._idle(names, run.way, grips, rough),
        ]

    def _as_long_as_given(self, names: Names, row: ConstraintRow) -> ConstraintRow:
        """The row of a string between two points with its length; else it is as long as at the start."""
        if self.length is None:
            return row
        if (ends := self.straight_between(names)) is None:
            told = Message(
                "a string over pulleys or on a drum is as long as where its ends and the bodies on its way are put "
                "(at) makes it; a length is that of a string between two points"
            )
            names.problem(told, "length")
            return row
        return replace(row, measure=Distance(*ends), target=names.length_or(self, "length"))

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        if self.friction in (0, None) and self.efficiency is None:
            return [], []
        n_before = len(names.problems)
        run = self._run(names)
        sections = [] if run is None else sections_of(run, self._grips(names, run))
        if len(names.problems) > n_before:
            del names.problems[n_before:]  # told with the rows
            return [], []
        given = frictions(names, self.friction, _slid_over(sections))
        found: list[DryFriction] = []
        for section in sections:
            lossy = set[str]() if run is None else self._lossy(run)
            rough = [p for p in section.passages if drum_name(p.node) in given.keys() | lossy]
            for passage in rough:
                alone = replace(passage, row=section.component(len(sections)), is_only=len(rough) == 1)
                friction = self._rubs(names, alone, given.get(drum_name(passage.node)), connection)
                if friction is not None:
                    found.append(friction)
        return [], found

    def _rubs(
        self, names: Names, passage: DrumPassage, friction: Friction | None, connection: str
    ) -> DryFriction | None:
        """What takes from the tension where it passes a drum, or the sheaves of a tackle; None with a problem noted."""
        if self.efficiency is None:
            return None if friction is None else rub(names, passage, friction, self.wrap, connection)
        if friction is not None or not passage.is_only:
            told = Message("the sheaves of a tackle have an efficiency, or a string slides with friction, not both")
            names.problem(told, "efficiency")
            return None
        return lossy_sheaves(names, passage, self.falls, self.efficiency, connection)

    def _lossy(self, run: StringRun) -> set[str]:
        """Where the sheaves of a tackle take from the tension."""
        return set() if self.efficiency is None else {drum_name(run.way[-2])}

    def _run(self, names: Names) -> StringRun | None:
        """How the string lies; None with problems noted."""
        if not is_way_given(names, self):
            return None
        texts, fields = zip(*self._places(), strict=True)
        way = read_way(names, texts, fields, swings=self.swings or self.length is not None)
        way = None if way is None else with_falls(names, way, self)
        if way is None:
            return None
        if self._is_of_points(names):  # nothing hangs in a direction of its own, and no lead is along a guide
            way = [replace(node, hangs=False, is_put=False, guide=None, track=None) for node in way]
            return StringRun(way, [None] * (len(way) - 1), [0] * len(way), [ZERO] * len(way))
        if names.space and self._is_of_space(names, way):
            return self._run_in_space(names, way)
        names.laying.append(self)
        before, names.standing = names.standing, {} if names.standing is None else names.standing
        run = run_over(names, way, self.leads)
        goes_round = is_sure(names, run, "path" if self.path else "over" if self.over else "under")
        names.standing = before
        found = with_carried_leads(names, run) if goes_round else None
        names.laying.pop()
        return found

    def _run_in_space(self, names: Names, way: list[StringNode]) -> StringRun | None:
        """How it lies over wheels whose planes need not be that of x and y; None with a problem noted."""
        if self.leads is not None:
            names.problem(Message("in space the leads follow from the wheels and guides; leave leads out"), "leads")
            return None
        names.laying.append(self)
        run = lie_in_space(names, way)
        names.laying.pop()
        return run

    def _grips(self, names: Names, run: StringRun) -> set[str]:
        """The pulleys on which it does not slip: all that can turn, or those that the model names."""
        if self.grips is not None:
            return named_grips(names, run, self.grips)
        free = {p for p in wheels_that_turn(names, run) if not is_kept_from_turning(names, p)} - self._lossy(run)
        if self._rubs_on_each(run, free):
            return set()
        return free - set(self.friction if isinstance(self.friction, dict) else ())

    def _rubs_on_each(self, run: StringRun, free: set[str]) -> bool:
        """Whether one coefficient of friction can only be meant of pulleys that turn: the string slides over nothing
        else."""
        is_one = not isinstance(self.friction, dict) or set(self.friction) <= {"static", "kinetic"}
        others = (node for node in run.way[1:-1] if node.radius != ZERO and node.body not in free)
        return is_one and self.friction not in (0, None, {}) and not any(others)

    def _hanging(self, names: Names, run: StringRun) -> list[ConstraintRow]:
        """Holds every body that hangs on this string, and on no other, across its lead."""
        me = self.own_name(names)
        rows: list[ConstraintRow] = [*run.hanging()] if isinstance(run, SpatialRun) else []
        for body, hook in self._own_hooks(names, run):
            rows.append(hook.row(names))
            self._note_guided(names, me, rows[-1], hook)
            if names.known(body).start.at is not None:
                told = Message(
                    "{connection}: {body} is put where it hangs straight down, so it moves up and down only; swings: "
                    "true lets it swing",
                    connection=me,
                    body=body,
                )
                names.assumptions.append(told)
        if isinstance(run, SpatialRun):
            for body, wheel in run.carried():
                told = Message(
                    "{connection}: {body} is kept straight below {other}, which may move sideways",
                    connection=me,
                    body=body,
                    other=wheel,
                )
                names.assumptions.append(told)
            return rows
        for first, second, lead in askew(names, run.way, run.leads, run.arms):
            told = Message(
                "{connection}: from {first} to {second} its direction is taken to be {direction}, although it would be "
                "at an angle to that where these are put"
                if lead.name
                else "{connection}: from {first} to {second} it is taken to keep its direction, although it would turn "
                "where these are put",
                connection=me,
                first=first,
                second=second,
                direction=lead.name,
            )
            names.assumptions.append(told)
        for first, second, carrier in askew_on_carriers(names, run):
            told = Message(
                "{connection}: from {first} to {second} it is taken to run along {carrier}, although it would be at an "
                "angle to that where these are put",
                connection=me,
                first=first,
                second=second,
                carrier=carrier,
            )
            names.assumptions.append(told)
        return rows

    def _own_hooks(self, names: Names, run: StringRun) -> Iterator[tuple[str, Hook]]:
        """The bodies that hang on this string: each on that of its strings which is nearest to what is held, as on the
        rope that carries a pulley rather than on the one below it; of several on the first by name."""
        ranks, strings = _ranks(names), [c for c in names.connections.values() if isinstance(c, String)]
        for body, hook in run.hooks.items():
            rivals = [c for c in strings if c is self or body in c.hanging(names)]
            if hook.hangs and min(rivals, key=lambda c: ranks[id(c)]) is self:
                yield body, hook

    def _note_guided(self, names: Names, me: str, row: ConstraintRow, hook: Hook) -> None:
        """What is taken for granted of a body that hangs on what moves sideways, or beside a level lead."""
        body, lead = hook.point.body, hook.leads[0]
        if not is_parallel(names, lead.normal, RIGHT):
            told = Message(
                "{connection}: {body} stays on the line of its lead, as on a smooth guide", connection=me, body=body
            )
            names.assumptions.append(told)
        elif isinstance(row.measure, Displacement) and row.measure.origin.body != GROUND:
            told = Message(
                "{connection}: {body} is kept straight below {other}, which may move sideways; swings: true lets it "
                "swing",
                connection=me,
                body=body,
                other=lead.other,
            )
            names.assumptions.append(told)

    def hanging(self, names: Names) -> set[str]:
        """The bodies that can hang on it."""
        with names.quietly():
            run = self._run(names)
        return set() if run is None else {body for body, hook in run.hooks.items() if hook.hangs}

    def keeps_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        if point.body not in self.mentions(names) or any(other is self for other in names.laying):
            return None
        with names.quietly():
            run = self._run(names)
        hook = None if run is None else run.hooks.get(point.body)
        if hook is None or (hook.point.offset != point.offset and names.known(point.body).turns):
            return None
        return hook.place(names, along, seen)

    def _idle(self, names: Names, way: list[StringNode], grips: set[str], rough: set[str]) -> list[ConstraintRow]:
        """A pulley without inertia, over which the string slides without friction and which no connection or load
        turns, is taken not to turn: its rotation is no motion that anything decides, and the row carries no moment."""
        rows: list[ConstraintRow] = []
        turned = {name for push in names.applied_loads for name in turned_in(push.measure)}
        for node in (*way[1:-1], *(n for n in way[-1:] if n.falls != ONE)):
            body, unit = names.known(node.body), _welded_to(names, node.body)
            runs_round = node.radius != ZERO or (node is way[-1] and set(node.point.offset) == {ZERO})
            if node.body in grips or not runs_round or not node.turned or not body.turns:
                continue
            welded = [names.known(name) for name in unit - {node.body}]
            if body.inertia != ZERO or any(b.fixed or {b.mass, b.inertia} != {ZERO} for b in welded):
                continue
            if body.fixed or unit & {GROUND, *turned} or drum_name(node) in rough:
                continue
            others = [c for c in names.connections.values() if c is not self and unit & c.mentions(names)]
            if all(c.lets_turn or c.keeps_flat(names) or c.is_rigid for c in others):
                held = Combination(node.turned, DIMENSIONLESS)
                rows.append(
                    ConstraintRow(f"{node.body} does not turn", "moment", held, ends=(node.body,), if_needed=True)
                )
        return rows

    def valid_where(self, names: Names) -> list[Validity]:
        """A lead that runs in a constant direction has a length while what it carries has not got to its other end."""
        run = self._run(names)
        found: list[Validity] = []
        for lead in () if run is None else leads_of(run):
            if lead.length is not None and _is_placed(names, lead):
                purpose = Message("{body} has not reached {place}", body=lead.body, place=lead.place)
                end = Message("{body} reaches {place}", body=lead.body, place=lead.place)
                found.append(Validity(lead.length, ZERO, 1, purpose, end))
                if ground_guide_of(names, lead.body, turning=False) is None and ground_line_under(names, lead.body):
                    off = Message("{body} stays on the line of its lead", body=lead.body)
                    found += [Validity(lead.across, lead.arm, sign, off) for sign in (1, -1) if lead.across is not None]
        return found

    def room_between(self, names: Names, body: str, place: str) -> Measure | Message | None:
        """The straight length of the lead between them."""
        with names.quietly():
            run = self._run(names)
        for lead in () if run is None else leads_of(run):
            if lead.body == body and place in lead.called:
                aside = Message(
                    "{body} does not come to {place}: the lead of {string} between them changes its direction. Ask "
                    "when a measure has a value",
                    body=body,
                    place=lead.place,
                    string=self.own_name(names),
                )
                return aside if lead.length is None else lead.length
        return None

    def straight_between(self, names: Names) -> tuple[Point, Point] | None:
        places = self._places()
        if len(places) != 2 or any(is_round(names, text) for text, _field in places):
            return None
        (first, at_first), (second, at_second) = places
        return names.point(first, *at_first), names.point(second, *at_second)

    def mentions(self, names: Names) -> set[str]:
        return named_on(text for text, _field in self._places())

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        run = self._run(names)
        if run is None:
            return
        sections = sections_of(run, self._grips(names, run))
        falls = drawn_falls(names, run)
        arms = run.arms if falls is None else [*run.arms[:-1], falls[0]]
        nodes = tuple(node.drawn(arm) for node, arm in zip(run.way, arms, strict=True))
        rows = [s.component(len(sections)) for s in sections for _lead in itertools.pairwise(s.nodes)]
        leads = tuple(glyphs.Lead(along, row) for along, row in zip(run.leads, rows, strict=True))
        yield glyphs.Rope(nodes, leads, tuple(body for body, _hook in self._own_hooks(names, run)))
        for arm in falls[1:] if falls else ():
            yield glyphs.Rope(tuple(node.drawn(arm) for node in run.way[-2:]), leads[-1:], is_fall=True)


def _welded_to(names: Names, body: str) -> set[str]:
    """A body and what is welded to it."""
    welds = [c.mentions(names) for c in names.connections.values() if c.is_rigid]
    return {body}.union(*(bodies for bodies in welds if body in bodies))


def _is_placed(names: Names, lead: StringLead) -> bool:
    """Whether what a lead carries is put somewhere: by its own place, or by where a measure of it starts. What starts
    at the other end, or beyond, is counted from there."""
    if names.known(lead.body).start.at is not None:
        return True
    if lead.length is None or lead.length.along.body != GROUND:
        return False
    ends = [starts_at(names, point, lead.length.along) for point in (lead.length.of, lead.length.origin)]
    return ends[0] is not None and ends[1] is not None and number_of(names, add(ends[0], negate(ends[1]))) > ROUND_OFF


def _slid_over(sections: Iterable[StringSection]) -> list[str]:
    """The drums and points on which the string moves."""
    return [drum_name(p.node) for section in sections for p in section.passages]


def _ranks(names: Names) -> dict[int, int]:
    """By the identity of each string: by how many others, at least, it hangs on what is held otherwise."""
    waiting = [c for c in names.connections.values() if isinstance(c, String)]
    ends = {body for c in waiting for body in c.mentions(names)}
    met = {body for body in ends if body == GROUND or is_held(names, body)}
    ranks: dict[int, int] = {}
    rank = 0
    while waiting:
        reached = [c for c in waiting if c.mentions(names) & met] or waiting  # the rest hangs on nothing
        ranks |= {id(c): rank for c in reached}
        met = met.union(*(c.mentions(names) for c in reached))
        waiting = [c for c in waiting if id(c) not in ranks]
        rank += 1
    return ranks
