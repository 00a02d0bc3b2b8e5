"""Heavy rope: a rope or chain with mass that runs over edges, pegs and wheels, or off a drum.

Its last lead has the length x, the way of its last end. All of it runs with x', so it has the kinetic energy
rho L x'^2/2 and the momentum rho L x' along its way. Its weight drives a lead of length l along d by rho l g . d:

    rho L x'' = sum over leads of rho l g . d + (pull at the last end) - (pull at the first end),

with l = x on the last lead, what is left of L on the first, and a constant between two wheels. Over an edge that is
smooth x'' = g x/L and x = x_0 cosh(sqrt(g/L) t). The tension at a cut is what accelerates the part behind it. A wheel
is turned by the friction on it. What is wound on a drum runs as fast, and is balanced about its axis.
Source: Timoshenko & Young, Advanced Dynamics, 1948, art. 20; Beer & Johnston, Dynamics, sec. 14.12 (variable systems).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar, Literal

from pydantic import ConfigDict, Field

from freebody.connections.base import Connection
from freebody.connections.rope_run import RopePlace, RopeRun, aside_of_leads, place_on_way, sense_of_drum
from freebody.connections.standing import is_zero, moves_out_of_plane, number_of
from freebody.connections.standing_in_space import StandingInSpace
from freebody.language.expression import ONE, ZERO, Call, Expr, Symbol, add, multiply, negate
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import VALUE, ConstraintRow, DryFriction, UnilateralConstraint, Validity
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.rotations import dot, perpendiculars
from freebody.model.solids import ROPE
from freebody.model.spec import Formula, Heading
from freebody.model.transmitted import CutTension

if TYPE_CHECKING:
    from freebody.model.names import Names

_WAY = "@way"  # in laws of the friction; no user can type it


class HeavyRope(Connection, kind="heavy_rope"):
    """`heavy_rope: {rope: chain, over: [ground.edge], leads: [right, down]}`: a body `rope: {mass: m, length: L}` runs
    over points of the ground, and over wheels that are pinned to the ground, which it grips and turns. `leads` are the
    directions in which it runs, from its first end to its last, one more than places; the body is the last end. Without
    slack: its first lead becomes shorter as the last one grows. `from: block`, `to: load` are bodies tied to its ends,
    without these the ends are free. `wound_on: drum` in place of a free first lead: it unwinds from a drum, on the
    `side` of it, and there are as many leads as places. `friction: mu` is that of what its first lead lies on.
    Gravity drives every part along its own lead. Ask for the tension at a body, or in the rope at a place.
    `counterclockwise: true` where it comes back over a wheel from the right. In space leads run any way over points,
    and perpendicular to the axis over a wheel; `counterclockwise` is as seen against that axis."""

    rope: str
    over: list[str] = Field(default_factory=list[str])
    leads: list[Heading]
    start: str | None = Field(default=None, alias="from")
    to: str | None = None
    wound_on: str | None = None
    side: Literal["left", "right", "top", "bottom"] = "right"
    friction: Formula | dict[str, Formula] = 0
    counterclockwise: bool = False

    model_config = ConfigDict(populate_by_name=True)

    in_plane = True
    lets_hang: ClassVar[bool] = True
    path: ClassVar[list[str]] = []  # its way is written by its ends and what it runs over
    under: ClassVar[list[str]] = []
    example = """
bodies: {chain: {rope: {mass: 1 kg, length: 2 m}}}
connections: {it: {heavy_rope: {rope: chain, over: [ground.edge], leads: [right, down]}}}
measures: {x: drop of chain}
start: {x: 0.4 m, rate(x): 0}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        run = self._run(names)
        if run is None:
            return []
        last, in_space = run.places[-1], not self.is_in_plane(names)
        found = [
            ConstraintRow(
                name, "sideways force", Displacement(run.rope.center, last.center, across), far, ends=(run.rope.name,)
            )
            for name, (across, far) in zip(("way", "way across"), last.aside(last.out, in_space=in_space), strict=False)
        ]
        return [*found, *self._grips(run), *self._tied(names, run)]

    def _grips(self, run: RopeRun) -> Iterable[ConstraintRow]:
        """What turns with it: a drum holds it back by its tension, a wheel is turned by the friction on it."""
        for k, place in enumerate(run.places):
            if place.turns_with:
                wound = ((negate(multiply(place.arm, share)), angle) for share, angle in place.turned)
                terms = ((ONE, run.way), *wound)
                is_drum = k == 0 and self.wound_on is not None
                yield ConstraintRow(
                    f"{'wound on' if is_drum else 'grip on'} {place.body}",
                    "tension" if is_drum else "friction force",
                    Combination(terms, LENGTH),
                    sign=-1 if is_drum else 1,
                    ends=(place.body,),
                    unilateral=is_drum,
                )

    def _tied(self, names: Names, run: RopeRun) -> Iterable[ConstraintRow]:
        """The bodies at its ends: as fast as the rope along their leads, and on the lines of these if free aside."""
        first, last = run.places[0], run.places[-1]
        if self.start is not None and first.into is not None:
            point = names.point(self.start, "from")
            led = Combination(((ONE, Displacement(point, first.center, first.into)), (negate(ONE), run.way)), LENGTH)
            yield ConstraintRow("first end", "tension", led, ends=(point.body,), unilateral=True)
            yield from self._kept_aside(names, point, first, first.into)
        if self.to is not None:
            point = names.point(self.to, "to")
            met = Displacement(point, run.rope.center, last.out)
            yield ConstraintRow("last end", "tension", met, sign=-1, ends=(point.body,), unilateral=True)
            yield from self._kept_aside(names, point, last, last.out)

    def _kept_aside(self, names: Names, point: Point, place: RopePlace, along: Direction) -> Iterable[ConstraintRow]:
        others = (c for c in names.connections.values() if c is not self and not c.keeps_flat(names))
        if not any(point.body in other.mentions(names) for other in others):
            sides = place.aside(along, in_space=not self.is_in_plane(names))
            for name, (across, far) in zip(("hangs", "hangs across"), sides, strict=False):
                held = Displacement(point, place.center, across)
                yield ConstraintRow(f"{point.body} {name}", "sideways force", held, far, ends=(point.body,))

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        with names.quietly():
            run = self._run(names)
        if friction.is_none or run is None:
            return [], []
        into = run.places[0].into
        if into is None or self.start is not None:
            names.problem(Message("friction is that of a free first lead, which lies on a table"), "friction")
            return [], []
        pressed = self._pressed(names, into)
        weight = multiply(run.density, pressed, run.first_length(Symbol(_WAY)))
        row = ConstraintRow("friction", "friction force", run.way, connection=connection)
        static, kinetic = (multiply(mu, weight) for mu in (friction.static, friction.kinetic))
        return [], [DryFriction(row, static, kinetic, measures=((_WAY, run.way),))]

    def _pressed(self, names: Names, lead: Direction) -> Expr:
        """What the fields press a unit of mass with, across a lead: on what bears it, which in space lies below it."""
        fields = sorted(names.fields, key=repr)
        if self.is_in_plane(names):
            normal = lead.normal()
            pressed = add(ZERO, *(multiply(strength, _dot(along, normal)) for along, strength in fields))
            return negate(pressed) if number_of(names, pressed) < 0 else pressed
        across = perpendiculars(lead.components)
        parts = [add(ZERO, *(multiply(s, dot(g.components, v)) for g, s in fields)) for v in across]
        known = [part for part in parts if not is_zero(names, part)]
        if len(known) == 1:
            return negate(known[0]) if number_of(names, known[0]) < 0 else known[0]
        return Call("sqrt", add(ZERO, *(multiply(part, part) for part in known)))

    def weighs(self, names: Names, body: str, along: Direction) -> tuple[Measure, Expr] | None:
        if body != self.rope:
            return None
        with names.quietly():
            run = self._run(names)
        if run is None:
            return None
        constant, by_way = run.drop(along)
        return run.way, multiply(run.density, add(constant, multiply(by_way, VALUE)))

    def valid_where(self, names: Names) -> list[Validity]:
        """Some of it lies before its first place, or on the drum, and some behind the last one."""
        run = self._run(names)
        if run is None:
            return []
        rope, first, last = run.rope.name, run.places[0].called, run.places[-1].called
        hangs = Message("{rope} reaches beyond {place}", rope=rope, place=last)
        left = Message("{rope} has not yet run off {place}", rope=rope, place=first)
        most = run.first_length(ZERO)
        return [Validity(run.way, ZERO, 1, hangs), Validity(run.way, most, -1, left)]

    def loads_bearings(self, names: Names) -> Mapping[str, str]:
        with names.quietly():
            run = self._run(names)
        wheels = [] if run is None else [place.body for place in run.places if place.turns_with]
        return {
            wheel: Message(
                "a rope with mass runs over {wheel}, and its weight and the change of its momentum act on this bearing "
                "as well",
                wheel=wheel,
            )
            for wheel in wheels
        }

    def tensions(self, names: Names) -> Mapping[str, CutTension]:
        """At a point that it runs over; of a wheel before and behind it."""
        with names.quietly():
            run = self._run(names)
        if run is None or run.length == ZERO:
            return {}  # a length of 0 is told where it is read
        me, fields = self.own_name(names), sorted(names.fields, key=repr)
        found: dict[str, CutTension] = {}
        behind: tuple[str, ...] = () if self.to is None else (f"{me}.last end",)
        for k in reversed(range(len(run.places))):
            place, is_drum = run.places[k], k == 0 and self.wound_on is not None
            if is_drum:
                break  # its reaction is that tension
            side = "at" if place.arm == ZERO else "behind"
            found[f"{side} {place.called}"] = run.cut(k, fields, behind, with_arc=False)
            if place.turns_with:
                behind = (*behind, f"{me}.grip on {place.body}")
            if place.arm != ZERO:
                found[f"before {place.called}"] = run.cut(k, fields, behind, with_arc=True)
        return found

    def _run(self, names: Names) -> RopeRun | None:
        """How it lies; None with problems noted."""
        n_before = len(names.problems)
        rope = names.body(self.rope, "rope")
        if not rope.is_placeholder and rope.solid != ROPE:
            told = Message("{body} is no rope: give it the shape rope: {{mass: m, length: L}}", body=rope.name)
            names.problem(told, "rope")
        in_space = not self.is_in_plane(names)
        headings = [names.direction(heading, "leads", k) for k, heading in enumerate(self.leads)]
        if in_space:
            headings = [replace(along, components=(*along.components, ZERO)[:3]) for along in headings]
        n_places = len(self.over) + (self.wound_on is not None)
        needed = n_places if self.wound_on is not None else n_places + 1
        if n_places == 0:
            names.problem(Message("say over what the rope runs, e.g. over: [ground.edge], or what it is wound on"))
        elif len(headings) != needed:
            told = Message("leads are {needed} directions, one for each straight part, found {n}", needed=needed,
                           n=len(headings))  # fmt: skip
            names.problem(told, "leads")
        for k, along in enumerate(headings):
            if along.body != GROUND:
                told = Message("a rope with mass runs along directions of the ground, and {name} is one of {body}",
                               name=str(self.leads[k]), body=along.body)  # fmt: skip
                names.problem(told, "leads", k)
        if self.wound_on is not None and self.start is not None:
            names.problem(Message("the first end is wound on a drum, so nothing else is tied to it"), "from")
        if len(names.problems) > n_before:
            return None
        run = RopeRun(rope, tuple(self._places(names, headings, StandingInSpace(names) if in_space else None)))
        if in_space and len(names.problems) == n_before:
            for here, there, far in aside_of_leads(names, run):
                told = Message(
                    "{there} is {far:.6g} m aside of the lead from {here}: put it on that, or name another direction",
                    there=there, far=far, here=here)  # fmt: skip
                names.problem(told, "leads")
        return run if len(names.problems) == n_before else None

    def is_in_plane(self, names: Names) -> bool:
        with names.quietly():
            bodies = self.mentions(names) - {GROUND}
        return not names.space or not moves_out_of_plane(names, bodies)

    def _places(self, names: Names, headings: list[Direction], still: StandingInSpace | None) -> list[RopePlace]:
        found: list[RopePlace] = []
        if self.wound_on is not None:
            sense = sense_of_drum(names, self.wound_on.partition(".")[0], headings[0], self.side, still)
            if sense == 0:
                told = Message(
                    "its first lead does not come off {drum} at its {side}: name another side", drum=self.wound_on,
                    side=self.side)  # fmt: skip
                names.problem(told, "side")
                return found
            place = place_on_way(names, self.wound_on, ("wound_on",), None, headings[0], sense, still)
            found += [] if place is None else [place]
        usual = 1 if self.counterclockwise else -1
        for k, text in enumerate(self.over):
            place = place_on_way(names, text, ("over", k), headings[k], headings[k + 1], usual, still)
            found += [] if place is None else [place]
        return found

    def mentions(self, names: Names) -> set[str]:
        texts = (self.rope, self.start, self.to, self.wound_on, *self.over)
        owners = {text.partition(".")[0] for text in texts if text is not None}
        return {owner for owner in owners if owner in names.bodies}

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        run = self._run(names)
        if run is not None:
            yield "way", run.way

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        run = self._run(names)
        if run is None:
            return
        nodes: list[glyphs.Node[Point, Direction, Expr]] = [
            glyphs.Node(
                p.center,
                p.arm,
                k == 0 and self.wound_on is not None,
                None if p.plane is None else p.plane.normal,
                None if p.plane is None else p.plane.carrier,
            )
            for k, p in enumerate(run.places)
        ]
        leads: list[glyphs.Lead[Direction]] = [glyphs.Lead(p.out) for p in run.places]
        nodes.append(glyphs.Node(run.rope.center if self.to is None else names.point(self.to), ZERO))
        first = run.places[0]
        if first.into is not None and self.start is not None:
            nodes.insert(0, glyphs.Node(names.point(self.start), ZERO))
            leads.insert(0, glyphs.Lead(first.into))
        is_free = self.start is None and first.into is not None
        yield glyphs.Rope(
            tuple(nodes), tuple(leads), comes=first.into if is_free else None, whole=run.length if is_free else None
        )


def _dot(a: Direction, b: Direction) -> Expr:
    return add(*(multiply(x, y) for x, y in zip(a.components, b.components, strict=False)))
