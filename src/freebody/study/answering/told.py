"""An answer as blocks: its formula, and what is to be said of it."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.expression import Expr
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Entry, Equation, Equations, Formula, Piece, Section, Text
from freebody.present.report.results import entries, entry, line, options, question_title
from freebody.study.answering.answer import Answer


def answer_section(answer: Answer) -> Section:
    return Section(question_title(answer.id, answer.question), tuple(_blocks(answer)))


def _blocks(answer: Answer) -> Iterator[Block]:
    if answer.understood not in ("", answer.question):
        yield from entries(entry("understood", answer.understood))
    if answer.expression is None:
        word = "never: " if answer.never else "" if "no closed form" in answer.reason else "no closed form: "
        yield from map(line, f"{word}{answer.reason}".splitlines())
        yield from entries(*_value(answer, "by numbers"))
        return
    if isinstance(answer.expression, tuple):
        lines = [Equation(Formula((part,)), label=f"[{k}]") for k, part in enumerate(answer.expression, 1)]
    else:
        lines = [Equation(Formula((answer.expression,)))]
    yield Equations(tuple(lines))
    yield from entries(*_value(answer, "value"), *_said(answer))


def _value(answer: Answer, label: str) -> Iterator[Entry]:
    if answer.value is not None:
        values = answer.value if isinstance(answer.value, tuple) else None
        text = number_text(answer.value) if values is None else f"({', '.join(map(number_text, values))})"  # type: ignore[arg-type]
        yield entry(label, text + ("" if answer.unit == "1" else f" {answer.unit}"))


def _said(answer: Answer) -> Iterator[Entry]:
    yield entry("valid", *answer.conditions)
    yield entry("cases", *(_case(case.expression, case.conditions, case.what) for case in answer.cases))
    yield entry("note", *answer.notes)
    yield from options(answer.choice, answer.options)
    yield entry("to author", *answer.author_notes)
    if answer.evidence is not None:
        e = answer.evidence
        checked = f"checked numerically at {e.draws} random configurations: {e.route};"
        yield entry("evidence", checked, f"largest relative difference {e.worst_relative_difference:.1g}")


def _case(expression: Expr | tuple[Expr, ...], conditions: tuple[str, ...], what: str) -> Text:
    parts = expression if isinstance(expression, tuple) else (expression,)
    shown: list[Piece] = [Formula((parts[0],))]
    for part in parts[1:]:
        shown += [", ", Formula((part,))]
    return (*shown, f"   if {', '.join(conditions) or 'else'}" + (f" ({what})" if what else ""))
