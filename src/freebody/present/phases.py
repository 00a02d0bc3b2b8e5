"""Motion in phases as text, and the regions of its cases as a picture."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.present.lines import wrapped

LONGEST, SHOWN = 500, 120  # characters of a formula

if TYPE_CHECKING:
    from freebody.study.answering.answer import Answer
    from freebody.study.phases.result import PhaseCase, PhaseResult, Phases


def phase_lines(phases: Phases) -> Iterator[str]:
    """The table of cases, then the phases of each; a phase that was told before is only named."""
    yield "Phases"
    width = max((len(c.what) for c in phases.cases), default=0)
    for k, case in enumerate(phases.cases, 1):
        mark = "   <- the model's own values" if case.is_own and len(phases.cases) > 1 else ""
        where = _conditions(case.conditions) or ("always" if not phases.missing and case.is_exact else "")
        if not case.is_exact:
            where = f"{where or 'for some values'} (necessary, not sufficient)"
        yield f"    {k}  {case.what:<{width}}   {where or 'for some values'}{mark}"
    if phases.missing:
        yield from wrapped("", f"elsewhere no case was found: {phases.missing}")
    for text in phases.between:
        yield f"    between them, where {text}, nothing slips at the start"
    told: list[PhaseResult] = []
    for k, case in enumerate(phases.cases, 1):
        yield ""
        yield f"  {k}  {case.what}" if len(phases.cases) > 1 else f"  {case.what}"
        yield from _case(case, told)


def _conditions(texts: tuple[str, ...]) -> str:
    return ", ".join(map(_short, texts))


def _short(text: str) -> str:
    """A formula that nobody would read is left to the JSON document."""
    return text if len(text) <= LONGEST else f"{text[:SHOWN]} ... ({len(text)} characters; --json has all of it)"


def _case(case: PhaseCase, told: list[PhaseResult]) -> Iterator[str]:
    for k, phase in enumerate(case.phases):
        is_known = any(
            (other.equations, other.motion, other.forces) == (phase.equations, phase.motion, phase.forces)
            for other in told
            if phase.equations
        )
        told.append(phase)
        states = ", ".join(f"{name} {state}" for name, state in phase.states.items())
        yield from wrapped("first" if not k else "then", states or phase.what)
        for name, impulse in phase.impulses:
            yield from wrapped("", f"{phase.impact}: {name} = {_short(to_text(impulse))}")
        if phase.requires:
            yield from wrapped("", f"needs {_conditions(phase.requires)}")
        if is_known:
            yield from wrapped("", "moves as above")
        else:
            for left, right in (*phase.equations, *phase.motion):
                yield from wrapped("", f"{to_text(left)} = {_short(to_text(right))}")
            for name, force in phase.forces:
                yield from wrapped("", f"{name} = {_short(to_text(force))}")
        yield from _end(phase, is_last=k + 1 == len(case.phases))


def _end(phase: PhaseResult, *, is_last: bool) -> Iterator[str]:
    """What ends a phase. That nothing else does is said where it is proved, else that nothing was found."""
    if phase.event:
        when = ""
        if phase.duration is not None:
            when = f" after t = {to_text(phase.duration)}"
        elif phase.place is not None:
            when = f" at {to_text(phase.place[0])} = {to_text(phase.place[1])}"
        first = f", if {_conditions(phase.happens_if)}" if phase.happens_if else ""
        yield from wrapped("until", f"{phase.event}{when}{first}; {_other(phase)} before")
    if phase.reason:
        yield from wrapped("", phase.reason)
    elif is_last and not phase.event:
        yield from wrapped(
            "until", _never(phase) + (f", as {_conditions(phase.happens_if)}" if phase.happens_if else "")
        )


def _other(phase: PhaseResult) -> str:
    return "no other event comes" if phase.is_proved else "no other event was found"


def _never(phase: PhaseResult) -> str:
    return Message("no event ends it") if phase.is_proved else "no event was found that ends it"


def case_lines(answer: Answer) -> Iterator[str]:
    """An answer that depends on where the parameters are, as a table."""
    for k, case in enumerate(answer.cases):
        parts = case.expression if isinstance(case.expression, tuple) else (case.expression,)
        shown = ", ".join(map(to_text, parts))
        where = _conditions(case.conditions) or "else"
        yield from wrapped("cases" if not k else "", f"{shown}   if {where}" + (f" ({case.what})" if case.what else ""))
