"""An answer as blocks: its formula, and what is to be said of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Protocol

from freebody.assess.verdict import Verdict
from freebody.language.expression import Expr, Number
from freebody.language.sentences import Message, in_turn
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Entry, Equation, Equations, Formula, Piece, Section, Text
from freebody.present.report.results import entries, entry, line, options, question_title


class _Evidence(Protocol):
    @property
    def draws(self) -> int: ...
    @property
    def worst_relative_difference(self) -> float: ...
    @property
    def route(self) -> str: ...


class _Case(Protocol):
    @property
    def expression(self) -> Expr | tuple[Expr, ...]: ...
    @property
    def conditions(self) -> tuple[str, ...]: ...
    @property
    def what(self) -> str: ...


class _Named(Protocol):
    @property
    def name(self) -> Expr: ...
    @property
    def formula(self) -> Expr: ...


class _Chain(Protocol):
    @property
    def named(self) -> Sequence[_Named]: ...
    @property
    def result(self) -> tuple[Expr, ...]: ...


class ShownAnswer(Protocol):
    """An answer, as far as it is shown."""

    @property
    def id(self) -> str: ...
    @property
    def question(self) -> str: ...
    @property
    def understood(self) -> str: ...
    @property
    def verdict(self) -> str: ...
    @property
    def expression(self) -> Expr | tuple[Expr, ...] | None: ...
    @property
    def unit(self) -> str: ...
    @property
    def value(self) -> float | tuple[float, ...] | None: ...
    @property
    def in_unit(self) -> str: ...
    @property
    def value_in_unit(self) -> float | tuple[float, ...] | None: ...
    @property
    def missing(self) -> tuple[str, ...]: ...
    @property
    def conditions(self) -> tuple[str, ...]: ...
    @property
    def cases(self) -> Sequence[_Case]: ...
    @property
    def notes(self) -> tuple[str, ...]: ...
    @property
    def reason(self) -> str: ...
    @property
    def never(self) -> bool: ...
    @property
    def choice(self) -> str | None: ...
    @property
    def options(self) -> Mapping[str, Verdict]: ...
    @property
    def author_notes(self) -> tuple[str, ...]: ...
    @property
    def chain(self) -> _Chain | None: ...
    @property
    def evidence(self) -> _Evidence | None: ...


def answer_section(answer: ShownAnswer) -> Section:
    return Section(question_title(answer.id, answer.question), tuple(answer_blocks(answer)))


def answer_blocks(answer: ShownAnswer) -> Iterator[Block]:
    if answer.understood not in ("", answer.question):
        yield from entries(entry(Message("understood"), answer.understood))
    yield from map(line, filter(None, (answer.verdict,)))
    if answer.expression is None:
        yield from map(line, _refusal(answer))
        if answer.chain is not None:  # of which a name is known in numbers alone
            yield from _chain(answer.chain)
            yield Equations((Equation(Formula((answer.chain.result[0],))),), on_request=True)
        yield from entries(*_value(answer, Message("by numbers")), _cases(answer))
        if answer.value is not None:
            yield from entries(entry(Message("note"), *answer.notes), _evidence(answer))
        return
    shown = answer.expression
    if answer.verdict and isinstance(shown, Number):  # the verdict is all there is
        yield from entries(*_said(answer))
        return
    if answer.chain is not None:
        yield from _chain(answer.chain)
        shown = answer.chain.result if isinstance(shown, tuple) else answer.chain.result[0]
    if isinstance(shown, tuple):
        lines = [Equation(Formula((part,)), label=f"[{k}]") for k, part in enumerate(shown, 1)]
    else:
        lines = [Equation(Formula((shown,)))]
    yield Equations(tuple(lines))
    yield from entries(*_value(answer, Message("value")), *_said(answer))


def _refusal(answer: ShownAnswer) -> list[str]:
    """Why there is no formula, in lines."""
    first, *others = _lines(answer.reason) or [""]
    if answer.never:
        first = Message("never: {reason}", reason=first)
    elif "no closed form" not in answer.reason:
        first = Message("no closed form: {reason}", reason=first)
    return [first, *others] if first else others


def _lines(text: str) -> list[str]:
    """What `freebody.messages.lines` put together, or the lines of a plain text."""
    if isinstance(text, Message) and text.template == "{first}\n{second}":
        return [*_lines(str(text.arguments["first"])), *_lines(str(text.arguments["second"]))]
    return text.splitlines() if "\n" in text else [text]


def _value(answer: ShownAnswer, label: str) -> Iterator[Entry]:
    if answer.value is not None:
        told = _number(answer.value) + ("" if answer.unit == "1" else f" {answer.unit}")
        if answer.value_in_unit is not None and answer.in_unit != answer.unit:
            told += f" = {_number(answer.value_in_unit)} {answer.in_unit}"
        yield entry(label, told)
    elif answer.missing:
        yield entry(label, Message("open, as no value is given for {names}", names=", ".join(answer.missing)))


def _number(value: float | tuple[float, ...]) -> str:
    return f"({', '.join(map(number_text, value))})" if isinstance(value, tuple) else number_text(value)


def _said(answer: ShownAnswer) -> Iterator[Entry]:
    yield entry(Message("valid"), *answer.conditions)
    yield _cases(answer)
    yield entry(Message("note"), *answer.notes)
    yield from options(answer.choice, answer.options)
    yield entry(Message("to author"), *answer.author_notes)
    yield _evidence(answer)


def _chain(chain: _Chain) -> Iterator[Block]:
    steps = [Equation(Formula((step.name, step.formula), ("=",))) for step in chain.named]
    yield Equations(tuple(steps), on_request=True)


def _evidence(answer: ShownAnswer) -> Entry:
    e = answer.evidence
    if e is None:
        return entry(Message("evidence"))
    checked = Message("checked numerically at {n} random configurations: {route};", n=e.draws, route=e.route)
    return entry(
        Message("evidence"), checked, Message("largest relative difference {gap:.1g}", gap=e.worst_relative_difference)
    )


def _cases(answer: ShownAnswer) -> Entry:
    return entry(Message("cases"), *(_case(case.expression, case.conditions, case.what) for case in answer.cases))


def _case(expression: Expr | tuple[Expr, ...], conditions: tuple[str, ...], what: str) -> Text:
    parts = expression if isinstance(expression, tuple) else (expression,)
    shown: list[Piece] = [Formula((parts[0],))]
    for part in parts[1:]:
        shown += [", ", Formula((part,))]
    where = in_turn(conditions) or Message("else")
    if what:
        return (*shown, Message("   if {case} ({what})", case=where, what=what))
    return (*shown, Message("   if {case}", case=where))
