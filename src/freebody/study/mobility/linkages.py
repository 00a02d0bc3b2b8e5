"""Four-bar loops and slider-cranks of a system, from what its connections hold.

Pins merge points of bodies to nodes; a node carries the bodies that meet there, and a particle is nothing but a
node. A four-bar is a cycle of four links and four nodes. A node that is held on a straight line of a body slides on
it: the cycle of guide, crank and rod through a sliding node is a slider-crank, whether a block with an angle, a
particle or a pin in a slot slides there.
Source of the kinds: Norton, Design of Machinery, 5th ed. 2012, sec. 2.12 to 2.15.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations, permutations
from typing import Any

from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, RIGHT, UP, Components, Direction, Point
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.system.system import System

Place = tuple[str, Components]  # a point by body and components


@dataclass(frozen=True)
class LoopJoint:
    """A node of a loop: the connections that make it, one of its points, and all of them."""

    name: str
    point: Point
    points: tuple[Point, ...] = ()

    def on(self, body: str) -> Point | None:
        """The node as a point of a body; None where it has none there."""
        return next((p for p in self.points if p.body == body), None)


@dataclass(frozen=True)
class FourBar:
    """frame -A- input -B- coupler -C- output -D- frame. A link is a body, or a `link` by its connection."""

    frame: str
    input: str
    coupler: str
    output: str
    joints: tuple[LoopJoint, LoopJoint, LoopJoint, LoopJoint]  # A, B, C, D

    @property
    def kind(self) -> str:
        return "four-bar"

    @property
    def links(self) -> tuple[str, ...]:
        return self.frame, self.input, self.coupler, self.output

    def to_plain(self) -> dict[str, Any]:
        roles = {"frame": self.frame, "input": self.input, "coupler": self.coupler, "output": self.output}
        return {"kind": self.kind, **roles, "joints": [j.name for j in self.joints]}


@dataclass(frozen=True)
class SliderCrank:
    """guide -O- crank -B- rod -W-, where W slides on the guide along `along`. Inversions have another fixed link
    than the guide: the crank (slotted lever, quick return) or the rod (swinging block)."""

    guide: str
    crank: str
    rod: str
    fixed: str | None
    sliding: str  # the connection that guides
    joints: tuple[LoopJoint, LoopJoint, LoopJoint]  # O, B, W
    along: Direction
    through: Point  # of the guide's line

    @property
    def kind(self) -> str:
        names = {
            self.guide: "slider-crank",
            self.crank: "inverted slider-crank (slotted lever)",
            self.rod: "inverted slider-crank (swinging block)",
        }
        return names.get(self.fixed or "", "slider-crank on moving bodies")

    @property
    def links(self) -> tuple[str, ...]:
        return self.guide, self.crank, self.rod

    def to_plain(self) -> dict[str, Any]:
        roles = {"guide": self.guide, "crank": self.crank, "rod": self.rod, "fixed": self.fixed}
        return {"kind": self.kind, **roles, "sliding": self.sliding, "joints": [j.name for j in self.joints]}


Linkage = FourBar | SliderCrank


def at_ground(loop: Linkage) -> tuple[str, ...]:
    """The links that a pin joins to the fixed one, that of the input first."""
    if isinstance(loop, FourBar):
        return loop.input, loop.output
    return {
        loop.guide: (loop.crank,),
        loop.crank: (loop.rod, loop.guide),
        loop.rod: (loop.crank, loop.guide),
    }[GROUND]


def linkages(system: System, input: str | None = None) -> tuple[Linkage, ...]:
    """All four-bar loops and slider-cranks. The frame is the ground, in a loop of moving bodies alone its first
    body; the input of a four-bar is the link named `input`, else the one whose angle is driven, started or
    loaded, else the first. They are linkages of the plane: none in space."""
    if system.space:
        return ()
    graph = _Graph(system)
    preferred = [input] if input is not None else []
    preferred += [*turned_links(system), *(body.name for body in system.moving)]
    rank = {name: k for k, name in reversed(list(enumerate(preferred)))}
    found: dict[frozenset[int], Linkage] = {}
    for loop in [*_four_bars(graph, rank), *_slider_cranks(graph)]:
        found.setdefault(frozenset(graph.node_of(j.point) for j in loop.joints), loop)
    return tuple(found.values())


# -- links and nodes --------------------------------------------------------------------------
@dataclass
class _Node:
    points: list[Point]
    connections: list[str]
    links: set[str] = field(default_factory=set[str])

    @property
    def joint(self) -> LoopJoint:
        return LoopJoint(
            " and ".join(dict.fromkeys(self.connections)) or str(self.points[0]), self.points[0], tuple(self.points)
        )


@dataclass(frozen=True)
class _Slide:
    node: int
    guide: str
    along: Direction
    connection: str
    through: Point


class _Graph:
    """The links of a system, the nodes where they meet, and the nodes that slide on links."""

    def __init__(self, system: System) -> None:
        self.system = system
        self._rows: dict[str, list[ConstraintRow]] = {}
        for row in system.constraint_rows:
            self._rows.setdefault(row.connection, []).append(row)
        self._group = {b.name: GROUND if b.fixed else b.name for b in system.bodies.values()}
        self.nodes: list[_Node] = []
        for name, rows in self._rows.items():
            ends = coincident(rows)
            if ends is not None:
                self._merge(name, *ends)
                if len(rows) == 3 and any(_angle(row.measure) is not None for row in rows):
                    self._weld(ends[0].body, ends[1].body)
        for name, rows in self._rows.items():
            ends = distance_kept(rows)
            if ends is not None:
                for end in ends:
                    self._node(end).connections.append(name)
                    self._node(end).links.add(name)
        self.slides = [slide for name, rows in self._rows.items() for slide in self._slides(name, rows)]
        for node in self.nodes:
            node.links |= {self._group[p.body] for p in node.points if system.bodies[p.body].turns}

    @property
    def links(self) -> list[str]:
        """Bodies that turn, as far as no weld or fixing makes them one with another; then `link` connections."""
        return list(dict.fromkeys(link for node in self.nodes for link in sorted(node.links)))

    def group_of(self, body: str) -> str:
        """The link that it is part of."""
        return self._group[body]

    def shared(self, one: str, other: str) -> list[int]:
        return [k for k, node in enumerate(self.nodes) if {one, other} <= node.links]

    def node_of(self, point: Point) -> int:
        place = _place(point)
        return next(k for k, node in enumerate(self.nodes) if any(_place(p) == place for p in node.points))

    def neighbours(self, link: str) -> list[str]:
        """The links that meet a link somewhere."""
        met = [other for node in self.nodes if link in node.links for other in sorted(node.links)]
        return [other for other in dict.fromkeys(met) if other != link]

    def _node(self, point: Point) -> _Node:
        place = _place(point)
        for node in self.nodes:
            if any(_place(p) == place for p in node.points):
                return node
        self.nodes.append(_Node([point], []))
        return self.nodes[-1]

    def _merge(self, connection: str, first: Point, second: Point) -> None:
        one, other = self._node(first), self._node(second)
        if one is not other:
            self.nodes.remove(other)
            one.points += other.points
            one.connections += other.connections
        one.connections.append(connection)

    def _weld(self, first: str, second: str) -> None:
        one, other = self._group[first], self._group[second]
        keep, drop = (other, one) if other == GROUND else (one, other)
        self._group = {body: keep if group == drop else group for body, group in self._group.items()}

    def _slides(self, connection: str, rows: Sequence[ConstraintRow]) -> Iterator[_Slide]:
        across = _across(rows)
        if across is None:
            return
        guide = across.along.body
        point = across.of if across.of.body != guide else across.origin
        along, base = across.along.normal().reversed(), across.of if point is across.origin else across.origin
        moved = self._group[point.body]
        keeps_angle = len(rows) == 2
        self._node(point)
        for k, node in enumerate(self.nodes):
            groups = {self._group[p.body] for p in node.points}
            if any(_place(p) == _place(point) for p in node.points) or (keeps_angle and moved in groups):
                yield _Slide(k, self._group[guide], along, connection, base)
            elif keeps_angle and self._group[guide] in groups:
                yield _Slide(k, moved, along, connection, base)


def _place(point: Point) -> Place:
    return point.body, point.offset


def coincident(rows: Sequence[ConstraintRow]) -> tuple[Point, Point] | None:
    """The two points that rows of one connection hold together along both axes of the ground."""
    held = [row.measure for row in rows if row.target is None]
    plain = [m for m in held if isinstance(m, Displacement) and m.along.body == GROUND]
    same = {(m.origin, m.of) for m in plain}
    return next(iter(same)) if {m.along for m in plain} == {RIGHT, UP} and len(same) == 1 else None


def distance_kept(rows: Sequence[ConstraintRow]) -> tuple[Point, Point] | None:
    """The ends of a single row that holds a distance."""
    if len(rows) != 1 or isinstance(rows[0].measure, NonholonomicForm):
        return None
    m = inner_measure(rows[0].measure)
    return (m.start, m.end) if isinstance(m, Distance) else None


def inner_measure(measure: Measure) -> Measure:
    """What an incremental measure keeps at its start value."""
    return measure.terms[0][1] if isinstance(measure, Combination) and len(measure.terms) == 1 else measure


def _angle(measure: Measure | NonholonomicForm) -> Angle | None:
    inner = None if isinstance(measure, NonholonomicForm) else inner_measure(measure)
    return inner if isinstance(inner, Angle) else None


def _across(rows: Sequence[ConstraintRow]) -> Displacement | None:
    """The displacement across a straight guide: a row alone, or with one that holds the angle."""
    measures = [inner_measure(row.measure) for row in rows if not isinstance(row.measure, NonholonomicForm)]
    across = [m for m in measures if isinstance(m, Displacement)]
    others = [m for m in measures if not isinstance(m, Displacement)]
    if len(rows) != len(measures) or len(across) != 1 or not all(isinstance(m, Angle) for m in others):
        return None
    ends = {across[0].of.body, across[0].origin.body}
    return across[0] if len(others) <= 1 and across[0].along.body in ends and len(ends) == 2 else None


# -- loops ------------------------------------------------------------------------------------
def _four_bars(graph: _Graph, rank: Mapping[str, int]) -> Iterator[FourBar]:
    links = sorted(graph.links, key=lambda name: (name != GROUND, rank.get(name, len(rank))))
    order = {name: k for k, name in enumerate(links)}
    near = {name: sorted(graph.neighbours(name), key=order.__getitem__) for name in links}
    for frame in links:
        for first, last in combinations([m for m in near[frame] if order[m] > order[frame]], 2):
            for coupler in near[first]:
                if order[coupler] < order[frame] or coupler in (frame, last):
                    continue
                for nodes in _distinct(graph, (frame, first, coupler, last)):
                    a, b, c, d = (graph.nodes[n].joint for n in nodes)
                    yield FourBar(frame, first, coupler, last, (a, b, c, d))


def _distinct(graph: _Graph, cycle: tuple[str, ...]) -> Iterator[tuple[int, ...]]:
    """Nodes between the links of a cycle, each used once."""

    def walk(k: int, used: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
        if k == len(cycle):
            yield used
            return
        for node in graph.shared(cycle[k], cycle[(k + 1) % len(cycle)]):
            if node not in used:
                yield from walk(k + 1, (*used, node))

    yield from walk(0, ())


def _slider_cranks(graph: _Graph) -> Iterator[SliderCrank]:
    found: list[SliderCrank] = []
    for slide in graph.slides:
        sliding = graph.nodes[slide.node].links
        for crank, rod in permutations([link for link in graph.links if link != slide.guide], 2):
            if rod not in sliding or crank in sliding:
                continue
            for o in graph.shared(slide.guide, crank):
                for b in graph.shared(crank, rod):
                    if len({o, b, slide.node}) == 3:
                        joints = graph.nodes[o].joint, graph.nodes[b].joint, graph.nodes[slide.node].joint
                        fixed = GROUND if GROUND in (slide.guide, crank, rod) else None
                        found.append(
                            SliderCrank(
                                slide.guide, crank, rod, fixed, slide.connection, joints, slide.along, slide.through
                            )
                        )
    # a guide on the ground first, then one whose own axes tell its line: the same loop seen from its slider is one
    yield from sorted(found, key=lambda loop: (loop.guide != GROUND, graph.group_of(loop.along.body) != loop.guide))


def turned_links(system: System) -> list[str]:
    """Bodies whose angle is driven, then those whose angle is in the start, then those that a torque turns."""
    driven = [row.measure for row in system.constraint_rows if row.target is not None]
    started = [system.measures[name] for name in system.start]
    pushed = [push.measure for push in system.applied_loads]
    angles = [_angle(measure) for measure in (*driven, *started, *pushed)]
    return [angle.of for angle in angles if angle is not None and angle.origin == GROUND]
