"""What is conserved, as text for a terminal."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from freebody.language.expression import n_operations
from freebody.language.notation import to_text
from freebody.present.lines import number_text, option_lines, wrapped

if TYPE_CHECKING:
    from freebody.study.conservation.verdicts import Conservation, Verdicts

_RULE = "─"
_ROUND_OFF = 1e-12
_LONGEST = 60  # operations of a formula that stands in one line


def conservation_lines(found: Conservation) -> Iterator[str]:
    """The whole sheet."""
    title = found.system.title
    yield title
    yield _RULE * min(len(title), 78)
    if found.is_search:
        yield from _search(found.quantities)
        return
    for k, verdict in enumerate(found.quantities):
        if k:
            yield ""
        yield from _verdict(verdict)


def _search(quantities: tuple[Verdicts, ...]) -> Iterator[str]:
    different = [v for v in quantities if not v.same_as]
    groups = {
        "Conserved for every motion": [v for v in different if v.is_conserved],
        "Conserved under a condition": [v for v in different if v.is_answered and v.is_conserved is None],
    }
    for heading, verdicts in groups.items():
        yield heading
        for verdict in verdicts:
            condition = " or ".join(verdict.conditions)
            yield f"    {verdict.question}{f': if {condition}' if condition else _formula(verdict)}"
            same = [v.question for v in quantities if v.same_as == verdict.question]
            notes = [f"it is the {other} as well" for other in same] + list(verdict.notes)
            yield from (f"        {note}" for note in notes)
        if not verdicts:
            yield "    nothing that was looked for"
        yield ""
    others = [v for v in different if v.is_answered and v.is_conserved is False]
    if others:
        yield "Not conserved"
        for verdict in others:
            yield f"    {verdict.question}{_rate(verdict)}"
    open_ = [v for v in quantities if not v.is_answered]
    if open_:
        yield "Not told"
        for verdict in open_:
            yield f"    {verdict.question}: {verdict.reason}"
    checked = [v.confirmation for v in quantities if v.confirmation is not None]
    if checked:
        drift = max((c.largest_drift for c in checked if c.largest_drift is not None), default=0.0)
        yield ""
        yield (
            f"Compared with {sum(c.motions for c in checked)} simulated motions: what is conserved drifts by at most "
            f"{drift:.1g} of its size, the rest changes."
        )


def _formula(verdict: Verdicts) -> str:
    if verdict.value is None or n_operations(verdict.value) > _LONGEST:
        return ""
    return f" = {to_text(verdict.value)}"


def _rate(verdict: Verdicts) -> str:
    if verdict.rate is None or n_operations(verdict.rate) > _LONGEST:
        return ""
    return f": rate {to_text(verdict.rate)}"


def _verdict(verdict: Verdicts) -> Iterator[str]:
    yield f"{verdict.id}  {verdict.question}"
    if verdict.reason:
        yield f"    not told: {verdict.reason}"
        return
    if verdict.value is not None:
        yield from wrapped("quantity", to_text(verdict.value))
    if verdict.principle:
        yield from wrapped("principle", verdict.principle)
        for name, part in verdict.parts:
            yield from wrapped("", f"{name}: {to_text(part)}")
    if verdict.rate is not None:
        yield from wrapped("rate", to_text(verdict.rate))
    yield from wrapped("conserved", _answer(verdict))
    for note in verdict.notes:
        yield from wrapped("note", note)
    yield from option_lines(verdict.choice, verdict.options)
    for note in verdict.author_notes:
        yield from wrapped("to author", note)
    if verdict.counter is not None:
        c = verdict.counter
        start = ", ".join(
            f"{name} = {number_text(0.0 if abs(value) < 1e-12 else value)}" for name, value in c.start.items()
        )
        yield from wrapped(
            "changes",
            f"from {number_text(c.before)} to {number_text(c.after)} within {number_text(c.time)} s"
            + (f", started with {start} (SI)" if start else ""),
        )
    if verdict.confirmation is not None:
        c2 = verdict.confirmation
        told: list[str] = []
        if c2.largest_drift is not None:
            told.append(f"drift where conserved at most {c2.largest_drift:.1g} of its size")
        if c2.smallest_change is not None:
            told.append(f"change where not at least {c2.smallest_change:.1g}")
        yield from wrapped("evidence", f"{c2.motions} motions, {c2.route}: {', '.join(told)}")


def _answer(verdict: Verdicts) -> str:
    if verdict.is_conserved is True:
        return "for every motion"
    if verdict.is_conserved is False:
        return "no"
    return verdict.when
