"""Questions about one instant: accelerations and reactions by momentum and moments, and what follows from a state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Sum
from freebody.language.sentences import Argument, Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import TrueWhen
from freebody.narrative.lines.naming import asked_entry, asked_symbol, own_symbols, side_of, written
from freebody.narrative.lines.script import DerivationStage, Script
from freebody.narrative.principles.formal import elements
from freebody.narrative.principles.momentum import by_method, parts_of
from freebody.narrative.principles.newton import Solved, same_answer
from freebody.narrative.questions.initial import tell_start
from freebody.narrative.questions.state import AnswerParts, PlanarTelling, StateTelling
from freebody.narrative.space.spatial import SpatialTelling
from freebody.questions.reading import Question
from freebody.study.answering import loops
from freebody.study.answering.answer import Answer
from freebody.symbolic.closure import Closure
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of a quantity at an instant. Raises CannotAnswer where the solver has no formula, or
    where there is no derivation by this method."""
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    parts, unknowns = parts_of(context, question.quantity)
    script = context.script()
    telling = telling_of(context, script, at_start=question.at_start)
    found: Solved = {}
    if not unknowns:
        refuse(method, (), Message("what follows from the state alone"))
        before = telling.parts(question.quantity)
    elif telling.tells_all(question, method):
        return script.stages
    else:
        before = telling.before(question.quantity, method)
        found = by_method(context, script, unknowns, method, telling.kinematics)
    if question.at_start and not found and before.total is not None and telling.is_formal:
        _finish_at_start(context, script, question, parts, before)
    else:
        finish(context, script, question, parts, found, before)
    return script.stages


def telling_of(context: Context, script: Script, *, at_start: bool = False) -> StateTelling:
    """What tells of pose and velocities, in the plane or in space."""
    if context.system.space:
        return SpatialTelling(context, script, at_start=at_start)
    return PlanarTelling(context, script)


def _finish_at_start(
    context: Context, script: Script, question: Question, parts: Sequence[Ratio], before: AnswerParts
) -> None:
    """What is asked at the start, from symbols whose values there are told."""
    here, f = context.setup.start_for(question.quantity), context.setup.model.field
    name = asked_symbol(context, question, len(parts))
    values = tuple(f.lowest_terms(here.here(part)) for part in parts)
    total = before.total
    assert total is not None
    with script.stage(*_last_stage(total)):
        script.add(asked_entry(name, question, n=len(parts)))
        left = side_of(name, len(parts))
        args: dict[str, Argument] = {"lines": before.lines}
        script.line(left, total, written(values), why="value.follows", args=args, uses=before.lines, when="start")


def _last_stage(total: Expr | tuple[Expr, ...] | None) -> tuple[str, str]:
    """Its title and hint: what bodies contribute is added where there are several."""
    kind = "sum" if isinstance(total, Sum) else "value"
    return f"stage.{kind}", f"hint.{kind}"


def finish(
    context: Context,
    script: Script,
    question: Question,
    parts: Sequence[Ratio],
    found: Mapping[int, tuple[Ratio, int]],
    before: AnswerParts | None = None,
) -> None:
    """From the unknowns to what is asked, at the start where that is meant; ends in the solver's answer."""
    model, setup = context.setup.model, context.setup
    f = model.field
    values = {unknown: value for unknown, (value, _line) in found.items()}
    general = tuple(f.lowest_terms(f.follow(part, values)) for part in parts)
    own = own_symbols(parts, found) if len(parts) > 1 else None
    name = asked_symbol(context, question, len(parts))
    called = side_of(name, len(parts)) if own is None else own
    lines = (*(before.lines if before else ()), *(line for _value, line in found.values()))
    is_there = len(parts) == 1 and any((parts[0] - f.variable(u)).is_zero() for u in found)
    if kept := _kept_from_start(context, script, general):
        general, is_there = tuple(f.lowest_terms(f.follow(part, kept.values)) for part in general), False
        lines = (*lines, *kept.lines)
    last = lines[-1] if lines else 0
    if is_there and not script.stages and not question.at_start:  # an earlier derivation has found it
        with script.stage("stage.value"):
            script.say("result.found", line=last)
    is_rate = question.at_start and not found and _is_own_rate(context, parts)  # the start says it
    is_there |= is_rate
    drawn_back = next((u for u in found if len(parts) == 1 and (parts[0] + f.variable(u)).is_zero()), None)
    if not is_there:
        stage = _last_stage(None if before is None else before.total) if drawn_back is None else ("stage.counted", "")
        with script.stage(*stage):
            if (reason := question.quantity.reason) is not None:
                script.say(reason.key, **reason.args)
            if own is None:
                script.add(asked_entry(name, question, n=len(parts)))
            shown = written(general)
            sides: list[Expr | tuple[Expr, ...]] = [called]
            unsolved = written(parts)
            if before is not None and before.total is not None:
                sides.append(before.total)
            elif found and unsolved not in (shown, called):
                sides.append(unsolved)
            is_of_given = not model.coordinates and not model.dependent
            why, args = "value.is_given" if is_of_given else "value.is", dict[str, Argument](lines=lines)
            why = "value.follows" if lines else why
            if not lines and question.quantity.is_of_parameters and question.quantity.is_by_law:
                why = "answer.by_law"
            if drawn_back is not None:
                why, args = "value.counted", {"lines": lines, "force": tidy(f.variable(drawn_back))}
            last = script.line(*sides, shown, why=why, args=args, uses=lines)
    wanted = tuple(general)
    if question.at_start:
        with script.stage("stage.start", "hint.start"):
            here = setup.start_for(question.quantity)
            is_told = not is_rate and tell_start(
                context, script, set[int]().union(*(f.ingredients(part) for part in general))
            )
            wanted = tuple(f.lowest_terms(here.here(part)) for part in general)
            shown = written(wanted)
            left = called if not is_there else tidy(parts[0])
            after = context.after_blow if setup.system.is_struck else ()
            args = {"lines": (last,), "given": after}
            why = "value.after_blow" if after else "value.start_with" if is_told else "value.start"
            if is_rate:
                why = "value.just_after" if after else "value.at_start"
            uses = after if is_rate else (last, *after)
            last = script.line(left, shown, why=why, args=args, uses=uses, when="start")
    left = called if not is_there else tidy(parts[0])
    tell_loops(context, script, wanted, left, last, "start" if question.at_start else "always")
    _ends_in_answer(context, question, wanted)


def _is_own_rate(context: Context, parts: Sequence[Ratio]) -> bool:
    """Whether what is asked is the rate of a coordinate, which has its own symbol."""
    f = context.setup.model.field
    return len(parts) == 1 and any((parts[0] - f.variable(c.speed)).is_zero() for c in context.setup.model.coordinates)


@dataclass(frozen=True)
class KeptFromStart:
    """Constants of integration that the start gives, by generator, and the lines that say so."""

    values: dict[int, Ratio]
    lines: tuple[int, ...]

    def __bool__(self) -> bool:
        return bool(self.values)


def _kept_from_start(context: Context, script: Script, found: Sequence[Ratio]) -> KeptFromStart:
    """What rows keep, as far as it stands in an answer and the start gives it: the length of a string, say."""
    model = context.setup.model
    standing = frozenset[int]().union(*(model.field.ingredients(part) for part in found))
    values = {index: given for index, given in model.given_constants.items() if index in standing}
    lines: list[int] = []
    if values:
        with script.stage("stage.start", "hint.start"):
            for index, given in values.items():
                lines.append(script.line(tidy(model.field.variable(index)), tidy(given), why="value.kept"))
    return KeptFromStart(values, tuple(lines))


def tell_loops(
    context: Context,
    script: Script,
    found: Sequence[Ratio],
    left: Expr | tuple[Expr, ...],
    last: int,
    when: TrueWhen,
) -> None:
    """The angles that closed loops bind, and what is asked with them, where the answer has them put in."""
    setup, element = context.setup, found[0] if len(found) == 1 else tuple(found)
    state = setup.start_instant if when == "start" else setup.state
    solved = loops.solved(setup, element, state)
    if solved is None:
        return
    values, f, told = loops.angles(setup, element, state, Closure(setup.model)), setup.model.field, [last]
    with script.stage("stage.solved_loops", "hint.solved_loops"):
        for index, value in (values or {}).items():
            told.append(script.line(tidy(f.variable(index)), tidy(value), why="loops.solved", when=when))
        parts = solved[0] if isinstance(solved[0], tuple) else (solved[0],)
        uses = tuple(told)
        script.line(left, written(parts), why="value.follows", args={"lines": uses}, uses=uses, when=when)


def _ends_in_answer(context: Context, question: Question, found: Sequence[Ratio]) -> None:
    setup = context.setup
    state = setup.start_for(question.quantity) if question.at_start else setup.state
    wanted = elements(setup.model.field, question.quantity.value(setup.system, state))
    if any(not setup.model.samples.vanishes(a - b) for a, b in zip(found, wanted, strict=True)):
        same_answer(found, wanted)
