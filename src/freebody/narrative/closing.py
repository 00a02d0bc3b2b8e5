"""The end of every derivation: the result with its conditions, what it says in special cases, its unit, its value at
the numbers of the file, and a verdict on each option."""

from __future__ import annotations

import math
from contextlib import suppress
from typing import Literal

from freebody.errors import CannotAnswer, ExpressionError, UnitError
from freebody.language.expression import Expr, Number, Symbol
from freebody.language.notation import Stated, compared
from freebody.language.raising import raised
from freebody.language.sentences import Argument, Sentence
from freebody.language.units import TIME, dimension_of
from freebody.narrative.bounds import with_unit
from freebody.narrative.contact.settings import has_phases
from freebody.narrative.context import Context
from freebody.narrative.limits import limiting_cases
from freebody.narrative.lines.glossary import TrueWhen
from freebody.narrative.lines.naming import asked_symbol, own_symbols, side_of
from freebody.narrative.lines.script import DerivationStage, FormulaTable, Graph, Listing, OptionText, Script, ready
from freebody.narrative.mistakes.mistakes import found_mistakes
from freebody.narrative.principles.momentum import parts_of
from freebody.narrative.questions.of_place import at_its_place
from freebody.narrative.questions.wanted import answer_holds
from freebody.narrative.sheets.asking import headline
from freebody.questions.reading import Question
from freebody.questions.steady import is_steady_place
from freebody.study.answering.answer import ITS_RATE, Answer, point_moves
from freebody.study.answering.named_formulas import Chain


def closing(context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    """Result and options."""
    there = at_its_place(context, question)
    script = Script(there.glossary, context.next_number)
    with script.stage("stage.result", "hint.result"):
        _result(there, script, question, answer)
    if answer.options:
        with script.stage("stage.options", "hint.options"):
            _options(context, script, question, answer)
    context.next_number = script.next_number
    return script.stages


def _result(context: Context, script: Script, question: Question, answer: Answer) -> None:
    scope = question.quantity.scope
    is_told = scope in ("rest", "linkage") or question.quantity.wanted is not None
    # what is given, or where a motion that is looked at as a whole ends: no event at which it is meant
    is_told |= scope in ("steady motion", "whole motion") and question.event is not None
    is_told |= question.quantity.is_verdict and scope == "course"  # the verdict says it
    # the start need not be in steady motion
    is_told |= is_steady_place(question.quantity) or (scope == "steady motion" and question.at_start)
    if answer.expression is not None and not is_told:
        if scope == "small motion":  # of which other parameters may have another case: in phase, in opposite phase
            script.glossary = script.glossary.where(lambda world: answer_holds(world, answer))
        n = len(answer.expression) if isinstance(answer.expression, tuple) else 1
        own = _own_symbols(context, question)
        left = side_of(asked_symbol(context, question, n), n) if own is None else own
        sides: tuple[Expr | tuple[Expr, ...], ...] = (left, answer.expression)
        if answer.form:
            sides = (*sides, answer.form if n > 1 else answer.form[0])
        with suppress(CannotAnswer, ExpressionError):
            script.line(*sides, when=_when(question))
    if answer.verdict:
        script.say("result.verdict", text=ready(answer.verdict))
    if answer.chain is not None:
        _chain(script, answer.chain)
    if answer.conditions and scope != "every motion":  # that is what was derived
        key = question.quantity.verdict if question.quantity.is_verdict else "result.holds"
        script.say(key, conditions=tuple(with_unit(context, c) for c in answer.conditions))
        _other_cases(context, script, answer)
    script.add_all(limiting_cases(context, question, answer))
    says_number = _is_whole(answer)  # its unit and value stand there already
    if answer.unit not in ("", "1") and not answer.verdict and not says_number:
        key = "result.dimensions" if _dimensions_fit(context, question, answer) else "result.unit"
        script.say(key, unit=f"@{raised(answer.unit)}")
    if answer.value is not None and not answer.verdict and not says_number:
        values = answer.value if isinstance(answer.value, tuple) else (answer.value,)
        shown = ", ".join(f"{v:.5g}" for v in values)
        unit = "" if answer.unit in ("", "1") else f" {raised(answer.unit)}"
        if answer.unit == "rad":
            unit += f" ({', '.join(f'{math.degrees(v):.5g}°' for v in values)})"
        if (wanted := answer.value_in_unit) is not None and answer.in_unit != answer.unit:
            parts = wanted if isinstance(wanted, tuple) else (wanted,)
            unit += f" = {', '.join(f'{v:.5g}' for v in parts)} {raised(answer.in_unit)}"
        script.say("result.value", value=f"@{shown}{unit}")
    if question.runs_over:
        script.add(Graph(question, answer, Sentence("figure.graph", {"what": headline(context.system, question)})))
    notes = [note for note in answer.notes if not _is_derived(note)]
    if notes:
        script.add(Listing(tuple(Sentence("result.note", {"text": ready(note)}) for note in notes)))


def _other_cases(context: Context, script: Script, answer: Answer) -> None:
    """What it is where the parameters, or the time, are out of the range of the case that is derived."""
    others = [case for case in answer.cases if case.conditions and case.expression != answer.expression]
    if not others:
        return
    script.say("result.other_cases")
    items: list[Sentence] = []
    for case in others:
        where: tuple[Argument, ...] = tuple(with_unit(context, c) for c in case.conditions)
        items.append(Sentence("result.case", {"value": case.expression, "conditions": where}))
    script.add(Listing(tuple(items)))


def _is_derived(note: str) -> bool:
    """Whether a note says what the derivation has said: that a rate is one, and what a moving point adds to it."""
    words = note.words if isinstance(note, Stated) else note
    return words == ITS_RATE or getattr(words, "template", "") == point_moves("").template


def _is_whole(answer: Answer) -> bool:
    """Whether the answer is a whole number, or a count."""
    if answer.expression is None:
        return answer.unit in ("", "1") and isinstance(answer.value, (int, float)) and float(answer.value).is_integer()
    return isinstance(answer.expression, Number) and answer.expression.value.denominator == 1


def _chain(script: Script, chain: Chain) -> None:
    """A long result in its named steps."""
    script.say("result.chain")
    steps = [compared(step.name, "=", step.formula) for step in chain.named]
    items = [Sentence("result.note", {"text": ready(step)}) for step in steps]
    items += [Sentence("result.last", {"formula": part}) for part in chain.result]
    script.add(Listing(tuple(items)))


def _own_symbols(context: Context, question: Question) -> Expr | tuple[Expr, ...] | None:
    """The symbols that formulas have for what is asked, where there are any: x'', a tension, the components of a
    reaction, the time of an event."""
    q = question.quantity
    if context.own is not None:
        return context.own
    if question.transition is not None or has_phases(context.system):
        return None
    if q.is_of_event:
        return Symbol("t") if question.event is not None and q.dimension == TIME else None
    if q.scope != "instant":
        return None
    try:
        parts, unknowns = parts_of(context, q)
    except CannotAnswer:
        return None
    own = own_symbols(parts, unknowns if len(parts) > 1 else parts[0].generators())
    # what is a parameter itself (a length, a basic efficiency) has no other symbol: p = p says nothing
    return None if isinstance(own, Symbol) and own.name in context.system.parameters else own


def _dimensions_fit(context: Context, question: Question, answer: Answer) -> bool:
    """Whether the terms of a formula have like dimensions, and the formula that of the quantity."""
    if answer.expression is None or isinstance(answer.expression, tuple):
        return False
    names = {p.name: p.dimension for p in context.system.parameters.values()}
    names |= {name: measure.dimension for name, measure in context.glossary.measures.items()} | {"t": TIME}
    try:
        return dimension_of(answer.expression, names) == question.quantity.dimension
    except UnitError:  # a symbol of a start value, of which no dimension is kept
        return False


def _when(question: Question) -> TrueWhen:
    if question.event is not None or question.transition is not None:
        return "event"
    return "start" if question.at_start else "always"


def _options(context: Context, script: Script, question: Question, answer: Answer) -> None:
    header = (Sentence("options.letter"), Sentence("options.formula"), Sentence("options.reason"))
    mistakes = found_mistakes(context, question, answer)

    def reason(letter: str, told: str) -> Sentence | str:
        if letter not in mistakes:
            return told
        return Sentence("options.reason_and_mistake", {"reason": ready(told), "mistake": mistakes[letter]})

    rows = tuple((f"({k})", OptionText(question.options[k]), reason(k, v.reason)) for k, v in answer.options.items())
    marks: tuple[Literal["", "right", "wrong"], ...] = tuple(
        "right" if v.verdict == "right" else "wrong" for v in answer.options.values()
    )
    script.add(FormulaTable(header, rows, marks))
    for note in answer.author_notes:
        script.say("result.note", text=ready(note))
