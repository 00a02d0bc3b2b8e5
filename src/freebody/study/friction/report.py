"""A system at rest in numbers: whether it holds, what every contact transmits, and what fails first."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, further
from freebody.language.units import ENERGY
from freebody.model.elements import ConstraintRow
from freebody.numeric.friction_branches import margin, spread
from freebody.numeric.friction_limits import unresisted
from freebody.numeric.rest_problem import FrictionCone, RestProblem, rest_problem
from freebody.present.lines import number_text, system_line
from freebody.present.report.blocks import Block, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, line, notes, summary, table
from freebody.study.answering.draws import Draw
from freebody.study.friction.answers import prepared
from freebody.study.friction.failures import how_it_fails, seen
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.worded import in_words
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, ROUNDED

_LARGEST = 1e6  # times the friction that there is
_UNIQUE = 1e-8  # of the largest load
_FRICTIONLESS = 1e-7  # a share of the friction that is none: it holds without
_N_STEPS = 60
_SHARP = ROUNDED  # a margin that is none, of the largest load


@dataclass(frozen=True)
class Reaction:
    """What one row transmits: between low and high (SI), equal where it is unique, infinite where there is no limit;
    `used`: the share of what friction can carry, where that is unique."""

    name: str
    connection: str
    place: str
    reaction: str
    unit: str
    low: float
    high: float
    used: float | None = None

    @property
    def is_unique(self) -> bool:
        return self.low == self.high

    @property
    def told(self) -> str:
        """Its value, or between what it may be."""
        low, high = number_text(self.low), number_text(self.high)
        if self.is_unique:
            return low
        if math.isinf(self.low):
            return Message("any") if math.isinf(self.high) else Message("at most {x}", x=high)
        if math.isinf(self.high):
            return Message("at least {x}", x=low)
        return Message("{low} to {high}", low=low, high=high)

    @property
    def where(self) -> str:
        if not self.place:
            return self.connection
        return Message("{connection} at {place}", connection=self.connection, place=self.place)

    @property
    def told_reaction(self) -> str:
        """What it is, with its component."""
        name, _space, axis = self.reaction.rpartition(" ")
        if axis in ("x", "y", "z"):
            return Message("{reaction} {axis}", reaction=name, axis=axis)
        return Message("{reaction}", reaction=self.reaction)

    def to_plain(self) -> dict[str, Any]:
        """The reaction as plain data; without a limit None."""
        return {
            "name": self.name,
            "connection": self.connection,
            "place": self.place,
            "reaction": self.reaction,
            "unit": self.unit,
            "low": None if math.isinf(self.low) else self.low,
            "high": None if math.isinf(self.high) else self.high,
            "unique": self.is_unique,
            "used": self.used,
        }


@dataclass(frozen=True)
class Statics(Result):
    """The outcome at the model's own values. `reserve`: how many times what is needed friction can carry, infinite
    where none is needed, 0 where none is enough; `fails`: what happens, or what happens first with less friction."""

    system: System
    holds: bool
    fails: str
    reserve: float
    reactions: tuple[Reaction, ...]
    notes: tuple[str, ...] = ()

    def __getitem__(self, name: str) -> Reaction:
        """The reaction of a row by its name, or the only one of a connection."""
        found = [r for r in self.reactions if name in (r.name, r.connection)]
        if len(found) != 1:
            raise KeyError(f"{name} is not one of {', '.join(r.name for r in self.reactions)}")
        return found[0]

    def to_plain(self) -> dict[str, Any]:
        """The JSON document of the command line."""
        return {
            "title": self.system.title,
            "holds": self.holds,
            "fails": self.fails,
            "friction_reserve": None if math.isinf(self.reserve) else self.reserve,
            "friction_needed": not math.isinf(self.reserve),
            "reactions": [r.to_plain() for r in self.reactions],
            "notes": list(self.notes),
        }

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        yield line(further(system_line(self.system, None), Message("at rest in the start pose")))
        verdict = Message("It holds.") if self.holds else Message("It does not hold: {fails}.", fails=self.fails)
        yield Section((verdict,), (line(self._told_reserve()),))
        if self.reactions:
            yield Section((Message("Reactions"),), tuple(table(*self._table())))
        yield from entries(*notes(self.notes))

    def _table(self) -> tuple[list[list[str]], list[str]]:
        """Its rows and its header; what is used of friction where that is known of one."""
        header: list[str] = [Message("where"), Message("what"), Message("force")]
        rows: list[list[str]] = [
            [r.where, r.told_reaction, Message("{force} {unit}", force=r.told, unit=r.unit)] for r in self.reactions
        ]
        if any(r.used is not None for r in self.reactions):
            header.append(Message("used of friction"))
            for row, r in zip(rows, self.reactions, strict=True):
                row.append("" if r.used is None else f"{100 * r.used:.3g} %")
        return rows, header

    def _told_reserve(self) -> str:
        if math.isinf(self.reserve) and not self.fails:
            return Message("no friction is needed")
        if math.isinf(self.reserve):
            return Message("a millionth of the friction is enough; without it {fails}", fails=self.fails)
        if self.holds:
            return Message(
                "friction can carry {x} times what is needed; with less {fails}",
                x=number_text(self.reserve),
                fails=self.fails,
            )
        if self.reserve > 0.0:
            return Message("friction would have to be {x} times as large", x=number_text(1 / self.reserve))
        return Message("not even a million times the friction is enough")


@in_words
def statics(system: System) -> Statics:
    """Whether the system stays at rest in its start pose, and the reactions that hold it.

    Raises CannotAnswer where parameters have no values, something moves at the start, or nothing can be assembled."""
    missing = [p.name for p in system.parameters.values() if p.value is None and p.form is None]
    if missing:
        raise CannotAnswer(
            Message("numbers need a value for {names}; or ask a question: does it hold", names=", ".join(missing))
        )
    rest = prepared(system)
    touching, setup = rest.touching, rest.setup
    draw = setup.draws[0]
    touching.insist(draw.reference, draw.q)
    problem = rest_problem(draw.reference, draw.q, touching.dry_friction)
    if unresisted(problem) is not None:
        return Statics(system, False, how_it_fails(touching, problem, draw), 0.0, ())
    found = margin(problem)
    if found is None:
        raise CannotAnswer(Message("no reactions balance the loads"))
    is_held = found.value >= -ROUND_OFF
    reserve, words = _reserve(touching, problem, draw)
    fails = words if is_held else seen(touching, problem, found, draw).words
    reactions = tuple(_reactions(touching, problem)) if is_held else ()
    notes: list[str] = []
    if any(not r.is_unique for r in reactions):
        notes.append(Message("where an interval is shown, rigid-body mechanics leaves the reaction open"))
    return Statics(system, is_held, fails, reserve, reactions, tuple(notes))


def _reactions(touching: TouchingAtRest, problem: RestProblem) -> Iterator[Reaction]:
    tiny = _UNIQUE * problem.force
    cones = {cone.name: cone for cone in problem.cones}
    for k, row in enumerate(touching.rows):
        ends = spread(problem, k)
        if ends is None:
            continue
        low, high = sorted((row.sign * ends[0].value, row.sign * ends[1].value))
        low, high = (0.0 if abs(x) <= tiny else x for x in (low, high))
        if high - low <= tiny:
            low = high = (low + high) / 2
        used = None
        if low == high and row.name in cones:
            used = _used(problem, cones[row.name], row.sign * low)
        place = row.ends[0] if row.ends and "." in row.ends[0] else ""
        what = f"{row.reaction} {row.component}" if row.component in ("x", "y") else row.reaction
        yield Reaction(row.name, row.connection, place, what, unit_of(row), low + 0.0, high + 0.0, used)


def _used(problem: RestProblem, cone: FrictionCone, force: float) -> float | None:
    """The share of the cone that a friction force uses, where its load is unique."""
    load = 0.0
    parts: list[float] = []
    for row in cone.size or [j for j, _sign in cone.load]:
        ends = spread(problem, row)
        if ends is None or abs(ends[1].value - ends[0].value) > _UNIQUE * problem.force:
            return None
        parts.append(ends[0].value)
    if cone.size:
        load = math.hypot(*parts)
    else:
        load = sum(sign * part for (_j, sign), part in zip(cone.load, parts, strict=True))
    if cone.across >= 0:
        ends = spread(problem, cone.across)
        if ends is None or abs(ends[1].value - ends[0].value) > _UNIQUE * problem.force:
            return None
        force = math.hypot(force, ends[0].value)
    can = cone.forward * load + cone.limits[0] if force < 0 else cone.backward * load + cone.limits[1]
    return None if can <= _UNIQUE * problem.force else abs(force) / can


def _reserve(touching: TouchingAtRest, problem: RestProblem, draw: Draw) -> tuple[float, str]:
    """1/x for the least share x of all friction with which the system holds, and how it fails with less."""

    def with_share(x: float) -> RestProblem:
        cones = tuple(
            replace(c, forward=x * c.forward, backward=x * c.backward, limits=(x * c.limits[0], x * c.limits[1]))
            for c in problem.cones
        )
        return replace(problem, cones=cones)

    def is_held(x: float) -> bool:
        found = margin(with_share(x))
        return found is not None and found.value >= -_SHARP

    if is_held(0.0):
        return math.inf, ""
    inside = next((x for x in (1.0, 4.0, 64.0, 4096.0, _LARGEST) if is_held(x)), None)
    if inside is None:
        return 0.0, how_it_fails(touching, with_share(_LARGEST), draw)
    outside = 0.0
    for _ in range(_N_STEPS):
        middle = (inside + outside) / 2
        if is_held(middle):
            inside = middle
        else:
            outside = middle
        if inside - outside <= ROUNDED * inside:
            break
    words = how_it_fails(touching, with_share(outside), draw)
    return (math.inf if inside < _FRICTIONLESS else 1.0 / inside), words


def unit_of(row: ConstraintRow) -> str:
    """The unit of a reaction."""
    return str(ENERGY / row.measure.dimension)
