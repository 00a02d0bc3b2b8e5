"""What is conserved in a system, as a result that says itself in blocks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from freebody.language.expression import Expr, n_operations
from freebody.language.sentences import Message, in_turn
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Entry, Formula, Paragraph, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, line, notes, options, question_title, remark, summary
from freebody.study.conservation.constancy import Confirmation, CounterMotion
from freebody.study.conservation.verdicts import Verdicts
from freebody.system.system import System
from freebody.tolerances import ROUNDED

_LONGEST = 60  # operations of a formula that stands in one line


@dataclass(frozen=True)
class Conservation(Result):
    """What `conserved` found out about one system."""

    system: System
    quantities: tuple[Verdicts, ...]
    is_search: bool

    def __getitem__(self, id: str) -> Verdicts:
        """The verdict with an id, or on a question in words."""
        for verdict in self.quantities:
            if id in (verdict.id, verdict.question):
                return verdict
        raise KeyError(f"there is no {id}; there are {', '.join(v.id for v in self.quantities)}")

    @property
    def is_complete(self) -> bool:
        return self.is_search or all(v.is_answered for v in self.quantities)

    def to_plain(self) -> dict[str, Any]:
        """The JSON document of the command line."""
        return {
            "title": self.system.title,
            "search": self.is_search,
            "quantities": [v.to_plain() for v in self.quantities],
        }

    @property
    def report(self) -> Report:
        blocks = _search(self.quantities) if self.is_search else map(_section, self.quantities)
        return summary(self.system.title, blocks)


# -- a search ---------------------------------------------------------------------------------
def _search(quantities: tuple[Verdicts, ...]) -> Iterator[Block]:
    different = [v for v in quantities if not v.same_as]
    groups: list[tuple[str, list[Verdicts]]] = [
        (Message("Conserved for every motion"), [v for v in different if v.is_conserved and v.is_proved]),
        (Message("Conserved under a condition"), [v for v in different if v.is_answered and v.is_conserved is None]),
    ]
    if seen := [v for v in different if v.is_conserved and not v.is_proved]:
        groups.append((Message("Constant in every simulated motion, without a proof"), seen))
    for heading, verdicts in groups:
        lines = [each for verdict in verdicts for each in _found(verdict, quantities)]
        yield Section((heading,), tuple(lines or [line(Message("nothing that was looked for"))]))
    others = [v for v in different if v.is_answered and v.is_conserved is False]
    if others:
        yield Section((Message("Not conserved"),), tuple(_with_formula(v, Message(": rate "), v.rate) for v in others))
    open_ = [v for v in quantities if not v.is_answered]
    if open_:
        yield Section((Message("Not told"),), tuple(line(v.question, ": ", v.reason) for v in open_))
    checked = [v.confirmation for v in quantities if v.confirmation is not None]
    if checked:
        drift = max((c.largest_drift for c in checked if c.largest_drift is not None), default=0.0)
        told = Message(
            "Compared with {n} simulated motions: what is conserved drifts by at most {drift:.1g} of its size, the "
            "rest changes.",
            n=sum(c.motions for c in checked),
            drift=drift,
        )
        yield line(told)


def _found(verdict: Verdicts, quantities: tuple[Verdicts, ...]) -> Iterator[Paragraph]:
    """What is conserved, with what else is the same, and notes."""
    condition = in_turn(verdict.conditions, "{first} or {second}")
    if condition:
        proved = Message(": if {condition}", condition=condition)
        seen = Message(": in every simulated motion if {condition}", condition=condition)
        yield line(verdict.question, proved if verdict.is_proved else seen)
    else:
        yield _with_formula(verdict, " = ", verdict.value)
    yield from (
        remark(Message("it is the {quantity} as well", quantity=v.question))
        for v in quantities
        if v.same_as == verdict.question
    )
    yield from map(remark, verdict.notes)


def _with_formula(verdict: Verdicts, between: str, formula: Expr | None) -> Paragraph:
    """A quantity with a formula, unless that is long."""
    if formula is None or n_operations(formula) > _LONGEST:
        return line(verdict.question)
    return line(verdict.question, between, Formula((formula,)))


# -- an answer --------------------------------------------------------------------------------
def _section(verdict: Verdicts) -> Section:
    title = question_title(verdict.id, verdict.question)
    if verdict.reason:
        return Section(title, (line(Message("not told: {reason}", reason=verdict.reason)),))
    return Section(title, tuple(entries(*_said(verdict))))


def _said(verdict: Verdicts) -> Iterator[Entry]:
    if verdict.value is not None:
        yield entry(Message("quantity"), (Formula((verdict.value,)),))
    if verdict.principle:
        parts = ((name, ": ", Formula((part,))) for name, part in verdict.parts)
        yield entry(Message("principle"), verdict.principle, *parts)
    if verdict.rate is not None:
        yield entry(Message("rate"), (Formula((verdict.rate,)),))
    yield entry(Message("conserved"), verdict.when)
    yield from notes(verdict.notes)
    yield from options(verdict.choice, verdict.options)
    yield from notes(verdict.author_notes, Message("to author"))
    if verdict.counter is not None:
        yield entry(Message("changes"), _change(verdict.counter))
    if verdict.confirmation is not None:
        yield entry(Message("evidence"), _evidence(verdict.confirmation))


def _change(counter: CounterMotion) -> str:
    start = ", ".join(f"{name} = {number_text(value, ROUNDED)}" for name, value in counter.start.items())
    change = Message(
        "from {before} to {after} within {time} s",
        before=number_text(counter.before),
        after=number_text(counter.after),
        time=number_text(counter.time),
    )
    return Message("{change}, started with {start} (SI)", change=change, start=start) if start else change


def _evidence(confirmation: Confirmation) -> str:
    told: list[str] = []
    if confirmation.largest_drift is not None:
        told.append(Message("drift where conserved at most {x:.1g} of its size", x=confirmation.largest_drift))
    if confirmation.smallest_change is not None:
        told.append(Message("change where not at least {x:.1g}", x=confirmation.smallest_change))
    return Message("{n} motions, {route}: {seen}", n=confirmation.motions, route=confirmation.route, seen=in_turn(told))
