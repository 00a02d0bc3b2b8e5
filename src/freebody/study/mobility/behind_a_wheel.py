"""Extremes, stroke and time ratio of what a link drives that turns fully: the ram of a drag link or a Whitworth drive.

The four-link loop in front decides how the output turns, the rest how the quantity follows its angle psi. Over a full
turn of psi the extremes are those of the rest alone, whatever the loop does; the crank is at phi(psi) there.
Source: Norton, Design of Machinery, 5th ed. 2012, sec. 3.7.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol, number
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.geometry import GROUND
from freebody.questions.steady import Extremes
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.linkages import Linkage, at_ground, linkages
from freebody.study.mobility.loop_questions import four_links
from freebody.study.setup import Setup
from freebody.study.steady.drive import FreeToTurn
from freebody.study.steady.extremes import ExtremaSearch, where
from freebody.study.steady.turning import TurningAngle, TurnPose
from freebody.symbolic.closure import explicit
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.system.parts import cut_out
from freebody.system.system import System

_ANGLE, _CRANK = "@angle", "@crank"  # of the output and the crank, as measures of a part


def bodies_of(system: System, loop: Linkage) -> frozenset[str]:
    """The bodies of a loop, with the particles that are its joints."""
    at_joints = {point.body for joint in loop.joints for point in joint.points}
    particles = {name for name in at_joints if not system.bodies[name].turns}
    return (frozenset(loop.links) | particles) - {GROUND}


def rest_behind(system: System, own: frozenset[str], output: str) -> System:
    """What a link of a loop drives, with that link. Raises CannotAnswer where it drives nothing."""
    rest = cut_out(system, frozenset(b.name for b in system.moving) - (own - {output}))
    if len(rest.moving) < 2:
        raise CannotAnswer(Message("nothing is driven by {link}", link=output))
    return rest


def loops_round(setup: Setup, link: str) -> Iterator[tuple[FourLinks, FourLinks, str]]:
    """(loop in front, loop behind, the link of both) where a link of the one in front turns fully, and the link of both
    as well, at the model's own numbers."""
    system = setup.system
    for loop in linkages(system):
        ends = at_ground(loop)
        if GROUND not in loop.links or link not in ends:
            continue
        own = bodies_of(system, loop)
        for output in ends:
            with suppress(CannotAnswer):
                front, rest = Setup(cut_out(system, own)), Setup(rest_behind(system, own, output))
                links, behind = four_links(front), four_links(rest)
                if all(links.does_turn(name) for name in {link, output}):
                    yield links, behind, output


class BehindAWheel:
    """own: the bodies of the loop; ends: its links at the ground. Raises CannotAnswer where it is another mechanism, or
    the output does not turn fully."""

    def __init__(self, setup: Setup, q: Extremes, crank: Angle, own: frozenset[str], ends: Sequence[str]) -> None:
        self.setup, self.crank = setup, crank
        system = setup.system
        self.output = next(link for link in ends if link != crank.of)
        self.front = Setup(cut_out(system, own))
        links = four_links(self.front)
        needed = [links.turning(name) for name in (crank.of, self.output)]
        if not all(links.does_turn(turning.link) for turning in needed):
            raise CannotAnswer(Message("{link} does not turn fully", link=self.output))
        back = self._by_output(rest_behind(system, own, self.output))
        model = back.model
        x = explicit(model, model.field.element(q.of.value(back.system, SymbolicState(model))))
        self.turning = TurningAngle(model, model.coordinates[0])
        self.turning.shown = Symbol(self._name_of_angle(setup.driven if isinstance(setup, FreeToTurn) else system))
        search = ExtremaSearch(self.turning)
        _every, least, largest = search.extremes(back, x)
        self.values = [self._here(e.value) for e in (least, largest)]
        self.places = (least, largest)
        self.needs = [replace(c, element=self._here(c.element)) for turning in needed for c in turning.conditions]
        self.needs += [replace(c, element=self._here(c.element)) for c in search.conditions]

    def between(self) -> Ratio:
        """The angle of the crank between the two extremes, less than half a turn. Raises CannotAnswer where one of them
        is reached more than once a turn, or the loop has no formula."""
        if any(len(e.places) != 1 for e in self.places):
            raise CannotAnswer(Message("an extreme is reached more than once a turn"))
        front = self._by_output(self.front.system, {_CRANK: self.crank})
        model = front.model
        pair = model.field.pair_of(model.field.index(model.value_of(self.crank)))
        if pair is None:
            raise CannotAnswer(Message("the angle of {link} has no formula", link=self.crank.of))
        waves = [explicit(model, model.field.variable(g)) for g in pair]
        turning, scalar = TurningAngle(model, model.coordinates[0]), model.geometry.scalar
        found: list[TurnPose] = []
        for e in self.places:
            place = TurnPose(scalar(tidy(e.places[0].cos)), scalar(tidy(e.places[0].sin)))
            cos, sin = (self._here(turning.at(x, place)) for x in waves)
            found.append(TurnPose(cos, sin))
        search = ExtremaSearch(TurningAngle(self.setup.model, self.setup.model.coordinates[0]))
        angle = search.between(*found)
        self.needs += search.conditions
        return angle

    def where(self) -> list[str]:
        """Where the extremes are, by the angle of the output."""
        ends = zip((Message("least"), Message("largest")), self.places, strict=True)
        return [where(which, e, self.turning) for which, e in ends]

    def _name_of_angle(self, system: System) -> str:
        names = (name for name, m in system.measures.items() if m == Angle(self.output))
        return next(names, f"theta_{self.output}")

    def _by_output(self, part: System, more: dict[str, Angle] | None = None) -> Setup:
        """A part of the system with the angle of the output as its coordinate. Raises CannotAnswer where something else
        moves it as well."""
        draw, of = self.setup.draws[0], Angle(self.output)
        here = number(Fraction(draw.reference.snapshot(draw.q, 0.0 * draw.q).value(of)))
        found = Setup(replace(part, measures={_ANGLE: of, **(more or {})}, start={_ANGLE: here}, start_rates={}))
        if [found.model.measure_of(c) for c in found.model.coordinates] != [of]:
            raise CannotAnswer(Message("it does not follow {link} alone", link=self.output))
        return found

    def _here(self, x: Ratio) -> Ratio:
        """An element of a part in the formulas of the whole."""
        return self.setup.model.geometry.scalar(tidy(x))
