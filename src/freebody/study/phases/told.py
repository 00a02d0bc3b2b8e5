"""A motion in phases as blocks: the table of its cases, then the phases of each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.present.report.blocks import Block, Entry, Formula, Section, Text
from freebody.present.report.results import entries, entry, line, table
from freebody.study.phases.case import PhaseCase, PhaseResult


def phase_section(cases: Sequence[PhaseCase], missing: str, between: Sequence[str]) -> Section:
    """missing, between: as in `Phases`. A phase that was told in an earlier case is only named."""
    told: list[PhaseResult] = []
    sections: list[Section] = []
    for k, case in enumerate(cases, 1):
        title = f"{k}  {case.what}" if len(cases) > 1 else case.what
        sections.append(Section((title,), tuple(_case(case, told)), level=3))
    return Section(("Phases",), (*_table(cases, missing, between), *sections))


def _table(cases: Sequence[PhaseCase], missing: str, between: Sequence[str]) -> Iterator[Block]:
    own = "   <- the model's own values" if len(cases) > 1 else ""
    rows = ((f"{k}  {case.what}", _where(case, missing) + own * case.is_own) for k, case in enumerate(cases, 1))
    yield from table(rows)
    if missing:
        yield from entries(entry("", f"elsewhere no case was found: {missing}"))
    yield from (line(f"between them, where {text}, nothing slips at the start") for text in between)


def _where(case: PhaseCase, missing: str) -> str:
    """Where a case happens."""
    where = ", ".join(case.conditions) or ("always" if not missing and case.is_exact else "for some values")
    return where if case.is_exact else f"{where} (necessary, not sufficient)"


def _case(case: PhaseCase, told: list[PhaseResult]) -> list[Block]:
    said: list[Entry] = []
    for n, phase in enumerate(case.phases, 1):
        said += _phase(phase, told, is_first=n == 1)
        said += _end(phase, is_last=n == len(case.phases))
        told.append(phase)
    return entries(*said)


def _phase(phase: PhaseResult, told: Sequence[PhaseResult], *, is_first: bool) -> Iterator[Entry]:
    states = ", ".join(f"{name} {state}" for name, state in phase.states.items())
    yield entry("first" if is_first else "then", states or phase.what, *_formulas(phase, told))


def _formulas(phase: PhaseResult, told: Sequence[PhaseResult]) -> Iterator[Text]:
    """With what it begins, what it needs, and how it moves."""
    yield from ((f"{phase.impact}: {name} = ", Formula((impulse,))) for name, impulse in phase.impulses)
    if phase.requires:
        yield (f"needs {', '.join(phase.requires)}",)
    if phase.equations and any(_motion_of(other) == _motion_of(phase) for other in told):
        yield ("moves as above",)
        return
    yield from (_equal(left, right) for left, right in chain(phase.equations, phase.motion))
    yield from ((f"{name} = ", Formula((force,))) for name, force in phase.forces)


def _motion_of(phase: PhaseResult) -> object:
    return phase.equations, phase.motion, phase.forces


def _equal(left: Expr, right: Expr) -> Text:
    return (Formula((left, right), ("=",)),)


def _end(phase: PhaseResult, *, is_last: bool) -> Iterator[Entry]:
    """What ends a phase. That nothing else does is said where it is proved, else that nothing was found."""
    if phase.event:
        other = "no other event comes" if phase.is_proved else "no other event was found"
        first = f", if {', '.join(phase.happens_if)}" if phase.happens_if else ""
        yield entry("until", (phase.event, *_when(phase), f"{first}; {other} before"))
    if phase.reason:
        yield entry("", phase.reason)
    elif is_last and not phase.event:
        never = Message("no event ends it") if phase.is_proved else "no event was found that ends it"
        yield entry("until", never + (f", as {', '.join(phase.happens_if)}" if phase.happens_if else ""))


def _when(phase: PhaseResult) -> Text:
    if phase.duration is not None:
        return (" after t = ", Formula((phase.duration,)))
    if phase.place is not None:
        return (" at ", Formula(phase.place, ("=",)))
    return ()
