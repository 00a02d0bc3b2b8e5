"""Inextensible, massless string over any number of pulleys."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, ClassVar

from pydantic import ConfigDict, Field

from freebody.connections.base import Connection
from freebody.connections.capstan import Passage, drum_name, frictions, rough_drums, rub, slip_of
from freebody.connections.hanging import Hook, askew, hooks_of
from freebody.connections.pin import Pin
from freebody.connections.planar import Planar
from freebody.connections.slider import Slider
from freebody.connections.standing import is_parallel, number_of, place_of, stands_at, vanishes
from freebody.connections.string_node import StringNode
from freebody.connections.weld import Weld
from freebody.language.expression import Expr, add, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import DOWN, GROUND, ONE, RIGHT, UP, ZERO, Direction, Point
from freebody.measures.lead import Lead
from freebody.measures.turned import turned_in
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, StringStretch, UnilateralConstraint
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading
from freebody.tolerances import ROUND_OFF, ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Joining, Names

_NODE = re.compile(
    r"(?:(?P<way>over|under|around) )?(?P<wound>wound on )?(?P<what>[A-Za-z_]\w*(?:\.\w+)?)"
    r"(?: radius (?P<radius>.+?))?"
    r"(?: at (?P<side>left|right|top|bottom))?(?: (?P<turn>clockwise|counterclockwise))?"
)
_SIDES = {"left": (-1.0, 0.0), "right": (1.0, 0.0), "top": (0.0, 1.0), "bottom": (0.0, -1.0)}


@dataclass(frozen=True)
class StringSection:
    """The string between two marks: its length, the bodies along it, and what it slides over."""

    terms: tuple[tuple[Expr, Measure], ...]
    nodes: tuple[StringNode, ...]
    passages: tuple[Passage, ...]

    @property
    def ends(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(node.body for node in self.nodes))

    def component(self, n_sections: int) -> str:
        return "length" if n_sections == 1 else f"{self.ends[0]} to {self.ends[-1]}"

    def row(self, n_sections: int, rough: set[str]) -> ConstraintRow:
        """The row that keeps its length; the multiplier is its tension, after the rough drum if there is one."""
        measure = Combination(self.terms, LENGTH)
        return ConstraintRow(
            self.component(n_sections),
            "tension",
            measure,
            sign=-1,
            ends=self.ends,
            unilateral=True,
            stretches=self._stretches(rough),
        )

    def _stretches(self, rough: set[str]) -> tuple[StringStretch, ...]:
        """The string from one rough drum to the next. With tau the multiplier of the slip on a drum, the tension
        before it is that after it less tau (see `capstan`)."""
        drums = [k for k, node in enumerate(self.nodes[1:-1], 1) if drum_name(node) in rough]
        marks = [0, *drums, len(self.nodes) - 1]
        found: list[StringStretch] = []
        for n, (a, b) in enumerate(itertools.pairwise(marks)):
            places = (name for node in self.nodes[a : b + 1] for name in node.called)
            behind = tuple(slip_of(self.nodes[k]) for k in drums[n:])
            found.append(StringStretch(tuple(dict.fromkeys(places)), behind))
        return tuple(found)


@dataclass(frozen=True)
class Laid:
    """A string on its way: what it grips, and its sections."""

    way: list[StringNode]
    leads: list[Direction | None]  # constant directions
    arms: list[Expr]  # at which it pulls on the circles: s R
    grips: set[str]
    sections: list[StringSection]

    @property
    def hooks(self) -> dict[str, Hook]:
        """The bodies that its leads place."""
        return hooks_of(self.way, self.leads, self.arms)

    @property
    def slid_over(self) -> list[StringNode]:
        """The drums and points on which it moves."""
        return [p.node for section in self.sections for p in section.passages]


class String(Connection, kind="string"):
    """`string: {from: left, over: [pulley], to: right}`; longer ways as a list, with hubs and drums:
    `string: {path: [wound on drum radius r at right, under moving, over fixed, ground.A]}`.

    The string does not slip on the pulleys that it `grips` (default: all that are bodies); over the others it
    slides without friction. Each stretch between grips keeps its length and has one tension, positive when it
    pulls. A body that nothing else holds hangs on the string and moves up and down, below the point where its lead
    leaves the pulley, if it has no position or is put there; a lead to a body on a straight guide runs along the
    guide if the body has no position, or one from which it does so whatever the parameters are; `leads` states the
    directions instead; otherwise leads are the common tangents of the circles, wherever these move (`swings: true`
    also for hanging bodies).
    `friction`: that of the drums and pulleys over which it slides, one coefficient or {drum: mu}. The tensions on both
    sides of a drum differ by up to e^(mu beta), beta the angle of wrap between leads with constant directions, or
    `wrap: {drum: 3*pi}`; ask for the tension at an end, or between two places."""

    called: ClassVar[tuple[str, ...]] = ("rope", "cord", "cable", "thread", "wire", "line")

    start: str | None = Field(default=None, alias="from")
    to: str | None = None
    over: list[str] = Field(default_factory=list[str])
    under: list[str] = Field(default_factory=list[str])
    path: list[str] = Field(default_factory=list[str])
    grips: list[str] | None = None
    leads: list[Heading] | None = None
    swings: bool = False
    friction: Formula | dict[str, Any] = 0
    wrap: Formula | dict[str, Formula] | None = None

    model_config = ConfigDict(populate_by_name=True)

    in_plane = True
    example = """
bodies: {pulley: {disk: {mass: 1 kg, radius: 1 m}}, a: {particle: {mass: 1 kg}}, b: {particle: {mass: 2 kg}}}
connections: {p: {pin: [ground.A, pulley]}, it: {string: {from: a, over: [pulley], to: b}}}
"""

    def _texts(self) -> list[str]:
        if self.path:
            return self.path
        ends = [t for t in (self.start, self.to) if t is not None]
        middle = [f"over {p}" for p in self.over] + [f"under {p}" for p in self.under]
        return [*ends[:1], *middle, *ends[1:]]

    def rows(self, names: Names) -> list[ConstraintRow]:
        laid = self._laid(names)
        if laid is None:
            return []
        self._check_ends(names, laid)
        sections = laid.sections
        rough = rough_drums(self.friction, [drum_name(node) for node in laid.slid_over])
        return [
            *(section.row(len(sections), rough) for section in sections),
            *self._hanging(names, laid),
            *self._idle(names, laid.way, laid.grips, rough),
        ]

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        if self.friction in (0, None):
            return [], []
        n_before = len(names.problems)
        laid = self._laid(names)
        if laid is None or len(names.problems) > n_before:
            del names.problems[n_before:]  # told with the rows
            return [], []
        given = frictions(names, self.friction, [drum_name(node) for node in laid.slid_over])
        found: list[DryFriction] = []
        for section in laid.sections:
            rough = [p for p in section.passages if drum_name(p.node) in given]
            for passage in rough:
                alone = replace(passage, row=section.component(len(laid.sections)), is_only=len(rough) == 1)
                friction = rub(names, alone, given[drum_name(passage.node)], self.wrap, connection)
                if friction is not None:
                    found.append(friction)
        return [], found

    def _laid(self, names: Names) -> Laid | None:
        """How the string lies; None with problems noted."""
        if self.path and (self.start or self.to or self.over or self.under):
            names.problem(Message("give the way either as path, or as from, over, under, to"))
            return None
        texts = self._texts()
        if len(texts) < 2 or not (self.path or (self.start and self.to)):
            names.problem(Message("a string needs two ends: from and to"))
            return None
        nodes = [self._node(names, text, k, len(texts)) for k, text in enumerate(texts)]
        if any(node is None for node in nodes):
            return None
        way = [node for node in nodes if node is not None]
        names.laying.append(self)
        for k in range(len(way)):
            hung = [*way[:k], replace(way[k], hangs=True), *way[k + 1 :]]
            if way[k].is_put and self._is_straight_below(names, hung, k):
                way = hung
            if way[k].track is not None:
                led = [*way[:k], replace(way[k], guide=way[k].track), *way[k + 1 :]]
                if self._runs_along(names, led, k):
                    way = led
        names.laying.pop()
        leads, turns, arms = self._run(names, way)
        grips = self._grips(names, way)
        return Laid(way, leads, arms, grips, _sections(way, leads, turns, arms, grips))

    def _check_ends(self, names: Names, laid: Laid) -> None:
        """A lead along the common tangent of two circles needs them apart at the start."""
        arms = laid.arms
        for k, lead in enumerate(laid.leads):
            first, second = laid.way[k], laid.way[k + 1]
            places = [place_of(names, node.point) for node in (first, second)]
            if lead is not None or places[0] is None or places[1] is None or first.body == second.body:
                continue
            apart = math.dist(places[0], places[1])
            arm = abs(number_of(names, add(arms[k + 1], negate(arms[k]))))
            if apart <= arm + ROUND_OFF:
                wanted = Message("more than {arm:.6g} m apart", arm=arm) if arm else Message("apart")
                names.problem(
                    Message(
                        "at the start {first} and {second} are {apart:.6g} m from each other, where the string between "
                        "them has no direction: put them {wanted} (at)",
                        first=first.point,
                        second=second.point,
                        apart=apart,
                        wanted=wanted,
                    )
                )
                return

    def _run(self, names: Names, way: list[StringNode]) -> tuple[list[Direction | None], list[int], list[Expr]]:
        """The constant directions of the leads, the sense in which the string runs round each node, and its arms."""
        leads = self._directions(names, way)
        turns = self._turns(names, way, leads)
        return leads, turns, [multiply(number(s), n.radius) if s else ZERO for s, n in zip(turns, way, strict=True)]

    def _runs_along(self, names: Names, way: list[StringNode], k: int) -> bool:
        """Whether the leads to a guided body run along its guide from wheels, however long the parameters are. From a
        point the distance tells as much, and on which side of it the body is."""
        leads, _turns, arms = self._run(names, way)
        for j in (j for j in (k - 1, k) if 0 <= j < len(leads)):
            lead, first, second = leads[j], way[j].point, way[j + 1].point
            if lead is None or lead.body != GROUND or way[j if j < k else j + 1].radius == ZERO:
                return False
            across = [stands_at(names, point, lead.normal()) for point in (first, second)]
            ends = [place_of(names, point) for point in (first, second)]
            if across[0] is None or across[1] is None or ends[0] is None or ends[1] is None:
                return False
            if not vanishes(names, add(across[1], negate(across[0]), arms[j], negate(arms[j + 1]))):
                return False
            ex, ey = _numbers(names, lead)
            if (ends[1][0] - ends[0][0]) * ex + (ends[1][1] - ends[0][1]) * ey <= 0.0:
                return False
        return True

    def _is_straight_below(self, names: Names, way: list[StringNode], k: int) -> bool:
        """Whether a body is put where it would hang, below what carries it."""
        leads, _turns, arms = self._run(names, way)
        hook, here = hooks_of(way, leads, arms)[way[k].body], way[k].place
        if here is None:
            return False
        for lead in hook.leads:
            aside, level = lead.place(names, RIGHT, frozenset()), stands_at(names, lead.other, UP)
            if aside is None or abs(number_of(names, aside) - here[0]) > ROUND_OFF:
                return False
            if level is None or number_of(names, level) <= here[1]:
                return False
        return True

    # -- reading the way ----------------------------------------------------------------------
    def _node(self, names: Names, text: str, k: int, n: int) -> StringNode | None:
        field = ("path", k) if self.path else ("from" if k == 0 else "to" if k == n - 1 else "over",)
        found = _NODE.fullmatch(" ".join(text.split()))
        if found is None:
            names.problem(
                Message(
                    "'{text}' is no place on a string; write a point, 'over pulley', 'under pulley' or 'wound on "
                    "drum at right'",
                    text=text,
                ),
                *field,
            )
            return None
        what, is_end = found["what"], k in (0, n - 1)
        n_before = len(names.problems)
        if found["wound"] or (found["way"] and "." not in what):
            body = names.body(what, *field)
            if len(names.problems) > n_before:
                return None
            point = body.center
            if found["radius"]:
                radius = names.formula(found["radius"], LENGTH, *field)
            else:
                radius = names.radius(body.name, *field)
            if len(names.problems) > n_before:
                return None
        else:
            point, radius = names.point(what, *field), ZERO
            body = names.known(point.body)
            if not is_end and body.name == what and body.radius is not None and not body.is_placeholder:
                names.problem(
                    Message(
                        "{wheel} is round, and the string could run over it or through its centre: write "
                        "'over {wheel}', 'under {wheel}' or {wheel}.center",
                        wheel=what,
                    ),
                    *field,
                )
                return None
        way = "drum" if found["wound"] else "end" if is_end else (found["way"] or "over")
        if not is_end and found["wound"]:
            names.problem(Message("only an end can be wound on a drum, '{text}' is in the middle", text=text), *field)
        given = body.start.at is not None
        is_free = not (_is_held(names, body.name) or body.fixed or self.swings or body.name == GROUND)
        return StringNode(
            point,
            radius,
            way,
            found["side"],
            found["turn"],
            is_free and not given,
            is_free and given and body.start.velocity is None,
            None if given else _guide_of(names, body.name),
            _guide_of(names, body.name) if given else None,
            _place(names, point),
        )

    def _grips(self, names: Names, way: list[StringNode]) -> set[str]:
        pulleys = {node.body for node in way[1:-1] if node.radius != ZERO}
        pulleys = {p for p in pulleys if names.known(p).turns and not names.known(p).fixed}
        if self.grips is None:
            return pulleys - set(self.friction if isinstance(self.friction, dict) else ())
        for k, name in enumerate(self.grips):
            if name not in pulleys:
                body = names.body(name, "grips", k)
                if body.fixed:
                    names.problem(
                        Message("{name} is fixed and cannot turn, so the string cannot grip it", name=name),
                        "grips",
                        k,
                    )
                elif body.name == name:
                    names.problem(
                        Message("the string does not run over {name}, so it cannot grip it", name=name),
                        "grips",
                        k,
                    )
        return set(self.grips) & pulleys

    # -- directions of the leads --------------------------------------------------------------
    def _directions(self, names: Names, way: list[StringNode]) -> list[Direction | None]:
        """The constant direction of each lead, or None where it is the common tangent."""
        n = len(way) - 1
        if self.leads is not None:
            if len(self.leads) != n:
                names.problem(
                    Message("there are {n} leads, {given} directions are given", n=n, given=len(self.leads)),
                    "leads",
                )
                return [None] * n
            return [names.direction(d, "leads", k) for k, d in enumerate(self.leads)]
        found: list[Direction | None] = []
        for a, b in itertools.pairwise(way):
            if a.hangs or b.hangs:
                if b.way == "over" or a.way == "under":
                    found.append(UP)
                elif a.way == "over" or b.way == "under":
                    found.append(DOWN)
                else:
                    found.append(DOWN if b.hangs else UP)
                continue
            along = a.guide or b.guide
            if along is None or (a.guide and b.guide and not is_parallel(names, a.guide, b.guide)):
                found.append(None)
                continue
            into_pulley = b.way != "end" if a.way == "end" else False
            ex, ey = _numbers(names, along)
            wanted = ey if abs(ey) > ROUNDED else ex
            upward = (into_pulley and wanted > 0) or (not into_pulley and (-ey if abs(ey) > ROUNDED else ex) > 0)
            found.append(along if upward else along.reversed())
        return found

    def _turns(self, names: Names, way: list[StringNode], leads: list[Direction | None]) -> list[int]:
        """+1 where the string, followed from its start, runs counter-clockwise round the node, else -1."""
        turns: list[int] = []
        for k, node in enumerate(way):
            if node.radius == ZERO:
                turns.append(0)
                continue
            if node.turn is not None:
                turns.append(-1 if node.turn == "clockwise" else 1)
                continue
            before = _heading(names, way, leads, k - 1) if k > 0 else None
            after = _heading(names, way, leads, k) if k < len(way) - 1 else None
            if node.way == "drum":
                heading = before or after or (0.0, -1.0)
                sx, sy = _SIDES[node.side or "right"]
                # the contact point lies at -s R n from the centre, n the heading turned by a quarter turn
                turns.append(-1 if sx * -heading[1] + sy * heading[0] > 0 else 1)
                continue
            turn = 0.0
            if before and after:
                turn = before[0] * after[1] - before[1] * after[0]
            if node.way == "around" and abs(turn) > ROUND_OFF:
                turns.append(1 if turn > 0 else -1)
                continue
            rightward = 1.0
            start, end = way[k - 1].place, way[k + 1].place
            if abs(turn) > ROUND_OFF and leads[k - 1] is not None and leads[k] is not None:
                turns.append(1 if turn > 0 else -1)
                continue
            if start is not None and end is not None and abs(end[0] - start[0]) > ROUNDED:
                rightward = end[0] - start[0]
            over = -1 if rightward > 0 else 1
            turns.append(-over if node.way == "under" else over)
        return turns

    # -- rows ---------------------------------------------------------------------------------
    def _hanging(self, names: Names, laid: Laid) -> list[ConstraintRow]:
        """Holds every body that hangs on this string, and on no other, across its lead."""
        me = next((name for name, other in names.connections.items() if other is self), "")
        rows: list[ConstraintRow] = []
        for body, hook in self._own_hooks(names, laid):
            rows.append(hook.row(names))
            self._note_guided(names, me, rows[-1], hook)
            if names.known(body).start.at is not None:
                names.assumptions.append(
                    f"{me}: {body} is put where it hangs straight down, so it moves up and down only; swings: true "
                    "lets it swing"
                )
        for first, second, lead in askew(names, laid.way, laid.leads, laid.arms):
            names.assumptions.append(
                f"{me}: the lead from {first} to {second} runs {lead.name or 'in a constant direction'}, although it "
                "would be askew where these stand"
            )
        return rows

    def _own_hooks(self, names: Names, laid: Laid) -> Iterator[tuple[str, Hook]]:
        """The bodies that hang on this string: each on that of its strings which is nearest to what is held, as on the
        rope that carries a pulley rather than on the one below it; of several on the first by name."""
        ranks, strings = _ranks(names), [c for c in names.connections.values() if isinstance(c, String)]
        for body, hook in laid.hooks.items():
            rivals = [c for c in strings if c is self or body in c.hanging(names)]
            if hook.hangs and min(rivals, key=lambda c: ranks[id(c)]) is self:
                yield body, hook

    def _note_guided(self, names: Names, me: str, row: ConstraintRow, hook: Hook) -> None:
        """What is taken for granted of a body that hangs on what moves sideways, or beside a level lead."""
        body, lead = hook.point.body, hook.leads[0]
        if not is_parallel(names, lead.normal, RIGHT):
            names.assumptions.append(f"{me}: {body} stays on the line of its lead, as on a smooth guide")
        elif isinstance(row.measure, Displacement) and row.measure.origin.body != GROUND:
            names.assumptions.append(
                f"{me}: {body} is kept straight below {lead.other}, which may move sideways; swings: true lets it swing"
            )

    def hanging(self, names: Names) -> set[str]:
        """The bodies that can hang on it."""
        with names.quietly():
            laid = self._laid(names)
        return set() if laid is None else {body for body, hook in laid.hooks.items() if hook.hangs}

    def keeps_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        if point.body not in self.mentions(names) or any(other is self for other in names.laying):
            return None
        with names.quietly():
            laid = self._laid(names)
        hook = None if laid is None else laid.hooks.get(point.body)
        if hook is None or (hook.point.offset != point.offset and names.known(point.body).turns):
            return None
        return hook.place(names, along, seen)

    def _idle(self, names: Names, way: list[StringNode], grips: set[str], rough: set[str]) -> list[ConstraintRow]:
        """A pulley without inertia, over which the string slides without friction and which no connection or load
        turns, is taken not to turn: its rotation is no motion that anything decides, and the row carries no moment."""
        rows: list[ConstraintRow] = []
        turned = {name for push in names.applied_loads for name in turned_in(push.measure)}
        for node in way[1:-1]:
            body = names.known(node.body)
            if node.body in grips or node.radius == ZERO or body.fixed or body.inertia != ZERO:
                continue
            if node.body in turned or drum_name(node) in rough:
                continue
            others = [c for c in names.connections.values() if c is not self and node.body in c.mentions(names)]
            if all(isinstance(c, Pin) or _keeps_flat(names, c) for c in others):
                held = Combination(((ONE, Angle(node.body)),), DIMENSIONLESS)
                rows.append(
                    ConstraintRow(f"{node.body} does not turn", "moment", held, ends=(node.body,), if_needed=True)
                )
        return rows

    def mentions(self, names: Names) -> set[str]:
        found = (_NODE.fullmatch(" ".join(text.split())) for text in self._texts())
        return {match["what"].partition(".")[0] for match in found if match}

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        laid = self._laid(names)
        if laid is None:
            return
        nodes = tuple(glyphs.Node(n.point, arm, n.way == "drum") for n, arm in zip(laid.way, laid.arms, strict=True))
        rows = [s.component(len(laid.sections)) for s in laid.sections for _lead in itertools.pairwise(s.nodes)]
        leads = tuple(glyphs.Lead(along, row) for along, row in zip(laid.leads, rows, strict=True))
        yield glyphs.Rope(nodes, leads, tuple(body for body, _hook in self._own_hooks(names, laid)))


def _sections(
    way: list[StringNode], leads: list[Direction | None], turns: list[int], arms: list[Expr], grips: set[str]
) -> list[StringSection]:
    """Section between material marks: sum of l - rho a over its leads, plus s R theta at the mark where it
    ends and minus the same where it begins (see `measures.lead`)."""
    sections: list[StringSection] = []
    terms: list[tuple[Expr, Measure]] = []
    passages: list[Passage] = []
    begin = 0
    if way[0].way == "drum":
        terms.append((negate(arms[0]), Angle(way[0].body)))
    for k, direction in enumerate(leads):
        a, b = way[k], way[k + 1]
        if direction is not None:
            terms.append((ONE, Displacement(b.point, a.point, direction)))
        else:
            terms.append((ONE, Lead(a.point, b.point, add(arms[k + 1], negate(arms[k])))))
        last = k + 1 == len(way) - 1
        marked = (not last and b.body in grips and b.radius != ZERO) or (last and b.way == "drum")
        if marked:
            terms.append((arms[k + 1], Angle(b.body)))
        if marked or last:
            sections.append(StringSection(tuple(terms), tuple(way[begin : k + 2]), tuple(passages)))
            terms = [(negate(arms[k + 1]), Angle(b.body))] if marked else []
            begin, passages = k + 1, []
        else:
            passages.append(Passage(b, tuple(terms), arms[k + 1], turns[k + 1], (direction, leads[k + 1])))
    return sections


def _keeps_flat(names: Names, connection: Joining) -> bool:
    """Whether a connection only makes a body of space one of the plane."""
    return isinstance(connection, Planar) and connection.keeps_flat(names)


def _is_held(names: Names, body: str) -> bool:
    """Whether anything but strings holds a body, or one that it is welded to: what is welded to it and free otherwise
    hangs on the string with it."""
    unit, welds = {body}, [c.mentions(names) for c in names.connections.values() if isinstance(c, Weld)]
    while any(joined & unit and joined - unit for joined in welds):
        unit = unit.union(*(joined for joined in welds if joined & unit))
    for other in names.connections.values():
        mentioned = set[str]() if isinstance(other, Weld) or _keeps_flat(names, other) else other.mentions(names)
        if mentioned & (unit - {body} if isinstance(other, String) else unit):
            return True
    others = [names.known(name) for name in sorted(unit - {body})]
    return any(b.fixed or b.name == GROUND or b.start.at is not None for b in others)


def _ranks(names: Names) -> dict[int, int]:
    """By the identity of each string: by how many others, at least, it hangs on what is held otherwise."""
    waiting = [c for c in names.connections.values() if isinstance(c, String)]
    ends = {body for c in waiting for body in c.mentions(names)}
    met = {body for body in ends if body == GROUND or _is_held(names, body)}
    ranks: dict[int, int] = {}
    rank = 0
    while waiting:
        reached = [c for c in waiting if c.mentions(names) & met] or waiting  # the rest hangs on nothing
        ranks |= {id(c): rank for c in reached}
        met = met.union(*(c.mentions(names) for c in reached))
        waiting = [c for c in waiting if id(c) not in ranks]
        rank += 1
    return ranks


def _guide_of(names: Names, body: str) -> Direction | None:
    """The ground direction along which a slider lets the body move, if there is one."""
    for other in names.connections.values():
        if isinstance(other, Slider) and other.body.partition(".")[0] == body and other.on == GROUND:
            direction = names.direction(other.along, "along")
            return direction if direction.body == GROUND else None
    return None


def _place(names: Names, point: Point) -> tuple[float, float] | None:
    """Where a point is at the start, if the model says so."""
    body = names.known(point.body)
    offset = [names.numeric(c) for c in point.offset[:2]]
    base: list[float | None] = [0.0, 0.0]
    if body.name != GROUND:
        if body.start.at is None:
            return None
        base = [names.numeric(c) for c in body.start.at[1][:2]]
    x, y = (None if a is None or b is None else a + b for a, b in zip(base, offset, strict=True))
    return None if x is None or y is None else (x, y)


def _numbers(names: Names, direction: Direction) -> tuple[float, float]:
    """Components of a ground direction; parameters without a value are taken small and positive."""
    from freebody.language.expression import evaluate

    values: dict[str, Any] = {p.name: 0.3 if p.value is None else p.value for p in names.parameters.values()}
    x, y, *_ = (float(evaluate(c, values)) for c in direction.components)
    return x, y


def _heading(names: Names, way: list[StringNode], leads: list[Direction | None], k: int) -> tuple[float, float] | None:
    """Direction of lead k in numbers, from its stated direction or the places of its ends."""
    lead = leads[k]
    if lead is not None:
        return _numbers(names, lead)
    a, b = way[k].place, way[k + 1].place
    if a is None or b is None:
        return None
    return b[0] - a[0], b[1] - a[1]
