"""What the constraint doctor found out about a system."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from freebody.assess.verdict import Judgement
from freebody.language.sentences import Message, in_turn
from freebody.numeric.mobility.kinds import Dependence
from freebody.numeric.mobility.rank import Rank
from freebody.present.report.blocks import Block, Entry, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, line, notes, options, question_title, summary
from freebody.questions.reading import Question
from freebody.study.mobility.conflicts import Conflict
from freebody.study.mobility.gruebler import Gruebler
from freebody.study.mobility.mechanism import Motions
from freebody.study.mobility.told import count_section, motion_sections
from freebody.system.system import System

Basis = Literal["pose", "symbols", "topology"]


@dataclass(frozen=True)
class Mobility(Result):
    """What the doctor found.

    `degrees_of_freedom` is coordinates minus `rank.rank`, at this pose; `nearby` those of the motions that start here
    (None without a pose)."""

    system: System
    gruebler: Gruebler
    basis: Basis
    rank: Rank
    nearby: int | None
    dependences: tuple[Dependence, ...]
    idle: Mapping[str, str]
    independent_coordinates: tuple[str, ...]
    contradiction: Conflict | None
    motions: Motions | None
    n_idle: int = 0  # freedoms that are idle: one body moves, and nothing else
    reachable: int | None = None  # dimensions of the poses that can be reached, where connections hold velocities
    answers: Mapping[str, Judgement] = field(default_factory=dict[str, Judgement])
    notes: tuple[str, ...] = ()
    is_over_driven: bool = False  # drivers lead the same freedom at different rates

    @property
    def degrees_of_freedom(self) -> int:
        return self.rank.n_coordinates - self.rank.rank

    @property
    def _n_defining(self) -> int:
        """Rows that say no more than what coordinates of their own are, the feet on curves: as many as these."""
        return sum(not row.transmits for row in self.system.constraint_rows)

    @property
    def finite_freedom(self) -> int:
        """Freedoms of the motion that starts here: those nearby where the pose is singular."""
        return self.degrees_of_freedom if self.nearby is None else self.nearby

    @property
    def useful_freedom(self) -> int:
        """Freedoms of the motion that starts here, without idle ones."""
        return self.finite_freedom - self.n_idle

    @property
    def redundant(self) -> tuple[tuple[str, ...], ...]:
        """The minimal dependent sets of rows."""
        return tuple(d.rows for d in self.dependences) or self.rank.circuits

    @property
    def kind(self) -> str | None:
        """Why rank and count differ: the most particular kind of the dependences."""
        kinds = {d.kind for d in self.dependences}
        for kind in ("momentary", "special geometry", "not decided", "generic"):
            if kind in kinds:
                return kind
        return "generic" if self.rank.circuits else None

    @property
    def is_singular(self) -> bool:
        """Whether the rank is smaller at this pose than nearby; dead points of the input are told apart from it, in
        `motions.singular`."""
        return any(d.kind == "momentary" for d in self.dependences)

    @property
    def indeterminate(self) -> tuple[str, ...]:
        """The reactions that rigid bodies leave open."""
        return tuple(dict.fromkeys(name for rows in self.redundant for name in rows))

    @property
    def advice(self) -> str:
        """One sentence on what to do."""
        return _advice(self)

    def to_plain(self) -> dict[str, Any]:
        """The JSON document of the command line."""
        motions = {} if self.motions is None else self.motions.to_plain()
        return {
            "title": self.system.title,
            "basis": self.basis,
            "degrees_of_freedom": self.degrees_of_freedom,
            "nearby_degrees_of_freedom": self.nearby,
            "gruebler": self.gruebler.to_plain(),
            "coordinates": self.rank.n_coordinates - self._n_defining,
            "rank": self.rank.rank - self._n_defining,
            "rank_by": self.rank.how,
            "rank_is_exact": self.rank.is_exact,
            "redundant": [list(rows) for rows in self.redundant],
            "kind": self.kind,
            "dependences": [
                {
                    "constraints": list(d.rows),
                    "connections": list(d.connections),
                    "kind": d.kind,
                    "why": d.why,
                    "shaky": d.is_shaky,
                }
                for d in self.dependences
            ],
            "indeterminate_reactions": list(self.indeterminate),
            "singular": self.is_singular,
            "idle": dict(self.idle),
            "useful_degrees_of_freedom": self.useful_freedom,
            "reachable_dimensions": self.reachable,
            "independent_coordinates": list(self.independent_coordinates),
            "contradictory": None if self.contradiction is None else self.contradiction.to_plain(),
            "advice": self.advice,
            "notes": list(self.notes),
            **motions,
            "answers": [
                {
                    "id": q.id,
                    "question": q.text,
                    "value": self.finite_freedom,
                    "choice": self.answers[q.id].choice,
                    "options": {
                        k: {"verdict": v.verdict, "reason": v.reason} for k, v in self.answers[q.id].options.items()
                    },
                    "author_notes": list(self.answers[q.id].notes),
                }
                for q in asked(self.system)
            ],
        }

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        yield count_section(self.gruebler)
        independent = Message(
            "{k} of {n} constraints are independent",
            k=self.rank.rank - self._n_defining,
            n=self.gruebler.n_constraints,
        )
        yield Section((Message("Rank"),), (line(independent), *entries(*self._rank())))
        if self.motions is not None:
            yield from motion_sections(self.motions)
            at_pose = (
                []
                if self.motions.input is None
                else [
                    entry(
                        Message("this pose"),
                        Message("is a {singular} of {name}", singular=what, name=self.motions.input.name),
                    )
                    for what in self.motions.singular
                ]
            )
            yield from entries(*at_pose, *notes(self.motions.notes), entry(Message("advice"), self.advice))
        else:
            yield from entries(entry(Message("advice"), self.advice))
        for question in self.system.questions:
            if question.id in self.answers:
                judged = self.answers[question.id]
                said = [*options(judged.choice, judged.options), *notes(judged.notes, Message("to author"))]
                title = question_title(question.id, question.text)
                yield Section((*title, f": {self.finite_freedom}"), tuple(entries(*said)))

    def _rank(self) -> Iterator[Entry]:
        n, held = self.rank.n_coordinates - self._n_defining, self.rank.rank - self._n_defining
        yield entry(Message("found by"), self.rank.how)
        yield entry(Message("mobility"), f"{n} - {held} = {self.degrees_of_freedom}")
        if self.nearby is not None and self.nearby < self.degrees_of_freedom:
            shaky = Message("motions that start here {n}: the rest gives way to first order only", n=self.nearby)
            branching = Message(
                "at nearby poses {n}: the pose is singular, motions branch (bifurcation)", n=self.nearby
            )
            yield entry("", shaky if any(d.is_shaky for d in self.dependences) else branching)
        if self.contradiction is not None:
            what = Message(
                "cannot be assembled: {names}"
                if self.contradiction.is_geometric
                else "cannot be assembled at its start: {names}",
                names=in_turn(self.contradiction.names),
            )
            yield entry(Message("conflict"), what, Message("at best {gap}", gap=self.contradiction.gap))
        for d in self.dependences:
            rows = ", ".join(d.rows)
            told = Message("{rows} depend on each other ({dependence})", rows=rows, dependence=d.kind)
            yield entry(Message("redundant"), told, d.why)
        if self.dependences:
            names = ", ".join(self.indeterminate)
            yield entry(Message("not unique"), Message("the reactions {names}", names=names))
        for body, what in self.idle.items():
            yield entry(Message("idle"), Message("{body} {does}, and nothing else moves", body=body, does=what))
        if self.n_idle:
            useful = f"{self.finite_freedom} - {self.n_idle} = {self.useful_freedom}"
            yield entry(Message("useful"), Message("{count} without what is idle", count=useful))
        if self.reachable is not None:
            yield entry(Message("velocities"), self._reachable())
        if self.independent_coordinates:
            yield entry(Message("coordinates"), Message("{names}", names=", ".join(self.independent_coordinates)))
        yield from notes(self.notes)

    def _reachable(self) -> str:
        n, m = self.degrees_of_freedom, self.reachable
        held = [c.connection for c in self.gruebler.connections if c.is_nonholonomic]
        freedoms = Message("1 freedom") if n == 1 else Message("{n} freedoms", n=n)
        what = Message(
            "{names} holds velocities: {freedoms} at a pose"
            if len(held) == 1
            else "{names} hold velocities: {freedoms} at a pose",
            names=", ".join(held),
            freedoms=freedoms,
        )
        if m == n:
            return Message(
                "{what}, and poses in {dimensions} are reached, so they can be integrated (holonomic)",
                what=what,
                dimensions=Message("1 dimension") if n == 1 else Message("{n} dimensions", n=n),
            )
        return Message("{what}, but poses in {m} dimensions are reached (nonholonomic)", what=what, m=m)


def asked(system: System) -> list[Question]:
    return [q for q in system.questions if q.quantity.scope == "structure"]


def _advice(found: Mobility) -> str:
    """One sentence on what to do about it."""
    kinds = {d.kind for d in found.dependences}
    if found.contradiction is not None:
        return found.contradiction.message
    drivers = in_turn([*found.gruebler.drivers])
    if found.is_over_driven:
        return Message("Leave out one of {drivers}: they lead the same freedom at different rates.", drivers=drivers)
    if any(d.is_shaky for d in found.dependences) and drivers:
        return Message("The drivers ({drivers}) are at a dead point: lead another measure.", drivers=drivers)
    if any(d.is_shaky for d in found.dependences):
        return Message(
            "It gives way to first order only, so small errors of the lengths become large displacements: change "
            "the shape."
        )
    if "momentary" in kinds:
        return Message(
            "The pose is singular: the motion may go on along more than one branch. Start from another pose, or guide "
            "the mechanism through it."
        )
    if found.redundant:
        rows = in_turn(list(dict.fromkeys(dependent[-1] for dependent in found.redundant)))
        if "special geometry" in kinds and found.degrees_of_freedom:
            return Message(
                "It moves only as long as the dimensions are exactly so: free {rows} (a joint that holds less, "
                "clearance, a flexible part) to make the reactions unique.",
                rows=rows,
            )
        return Message(
            "Free {rows} (a joint that holds less, clearance, a flexible part) to make the reactions unique.", rows=rows
        )
    n = found.degrees_of_freedom
    if n == 0 and drivers:
        return Message("The motion is prescribed by {drivers}; all reactions are unique.", drivers=drivers)
    if n == 0:
        return Message("Nothing can move, and all reactions are unique.")
    lead = in_turn([*found.independent_coordinates]) or (
        Message("1 coordinate") if n == 1 else Message("{n} coordinates", n=n)
    )
    return Message("Lead {lead} to determine the motion; all reactions are unique.", lead=lead)
