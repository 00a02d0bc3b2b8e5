"""A motion in phases as blocks: the table of its cases, then the phases of each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

from freebody.language.expression import Expr
from freebody.language.sentences import Message, in_turn
from freebody.present.report.blocks import Block, Entry, Formula, Section, Text
from freebody.present.report.results import entries, entry, line, table
from freebody.study.phases.case import PhaseCase, PhaseResult


def phase_section(cases: Sequence[PhaseCase], missing: str, between: Sequence[str]) -> Section:
    """missing, between: as in `Phases`. A phase that was told in an earlier case is only named."""
    told: list[PhaseResult] = []
    sections: list[Section] = []
    for k, case in enumerate(cases, 1):
        title: Text = (f"{k}", "  ", case.what) if len(cases) > 1 else (case.what,)
        sections.append(Section(title, tuple(_case(case, told)), level=3))
    return Section((Message("Phases"),), (*_table(cases, missing, between), *sections))


def _table(cases: Sequence[PhaseCase], missing: str, between: Sequence[str]) -> Iterator[Block]:
    own: Text = (Message("   <- the model's own values"),) if len(cases) > 1 else ()
    rows = (((f"{k}", "  ", case.what), (_where(case, missing), *own * case.is_own)) for k, case in enumerate(cases, 1))
    yield from table(rows)
    if missing:
        yield from entries(entry("", Message("elsewhere no case was found: {why}", why=missing)))
    for text in between:
        yield line(Message("between them, where {text}, nothing slips at the start", text=text))


def _where(case: PhaseCase, missing: str) -> str:
    """Where a case happens."""
    is_always = not missing and case.is_exact
    where = in_turn(case.conditions) or Message("always" if is_always else "for some values")
    return where if case.is_exact else Message("{where} (necessary, not sufficient)", where=where)


def _case(case: PhaseCase, told: list[PhaseResult]) -> list[Block]:
    said: list[Entry] = []
    for n, phase in enumerate(case.phases, 1):
        said += _phase(phase, told, is_first=n == 1)
        said += _end(phase, is_last=n == len(case.phases))
        told.append(phase)
    return entries(*said)


def _phase(phase: PhaseResult, told: Sequence[PhaseResult], *, is_first: bool) -> Iterator[Entry]:
    states = in_turn([Message("{contact} {state}", contact=name, state=x) for name, x in phase.states.items()])
    yield entry(Message("first") if is_first else Message("then"), states or phase.what, *_formulas(phase, told))


def _formulas(phase: PhaseResult, told: Sequence[PhaseResult]) -> Iterator[Text]:
    """With what it begins, what it needs, and how it moves."""
    yield from ((phase.impact, ": ", name, " = ", Formula((impulse,))) for name, impulse in phase.impulses)
    if phase.requires:
        yield (Message("needs {conditions}", conditions=in_turn(phase.requires)),)
    if phase.equations and any(_motion_of(other) == _motion_of(phase) for other in told):
        yield (Message("moves as above"),)
        return
    yield from (_equal(left, right) for left, right in chain(phase.equations, phase.motion))
    yield from ((name, " = ", Formula((force,))) for name, force in phase.forces)


def _motion_of(phase: PhaseResult) -> object:
    return phase.equations, phase.motion, phase.forces


def _equal(left: Expr, right: Expr) -> Text:
    return (Formula((left, right), ("=",)),)


def _end(phase: PhaseResult, *, is_last: bool) -> Iterator[Entry]:
    """What ends a phase. That nothing else does is said where it is proved, else that nothing was found."""
    if phase.event:
        first: Text = (Message(", if {conditions}", conditions=in_turn(phase.happens_if)),) if phase.happens_if else ()
        other = Message("; no other event comes before" if phase.is_proved else "; no other event was found before")
        yield entry(Message("until"), (phase.event, *_when(phase), *first, other))
    if phase.reason:
        yield entry("", phase.reason)
    elif is_last and not phase.event:
        never = Message("no event ends it" if phase.is_proved else "no event was found that ends it")
        why: Text = (Message(", as {conditions}", conditions=in_turn(phase.happens_if)),) if phase.happens_if else ()
        yield entry(Message("until"), (never, *why))


def _when(phase: PhaseResult) -> Text:
    if phase.duration is not None:
        return (Message(" after t = "), Formula((phase.duration,)))
    if phase.place is not None:
        return (Message(" at "), Formula(phase.place, ("=",)))
    return ()
