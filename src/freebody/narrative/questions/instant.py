"""Questions about one instant: accelerations and reactions by momentum and moments, and what follows from a state."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial

from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import DerivationStage, Legend, Script, Sentence
from freebody.narrative.principles.formal import elements
from freebody.narrative.principles.loops import loop_lines
from freebody.narrative.principles.newton import same_answer
from freebody.narrative.questions.state import AnswerParts, parts_of_state
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.numbers import work_until
from freebody.study.answering.passage import NumericPassage
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.symbols import reaction_symbols


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of a quantity at an instant. Raises CannotAnswer where there is none by this method."""
    newton = context.newton
    parts = newton.asked(question.quantity)
    unknowns = newton.unknowns_in(parts)
    script = context.script()
    found: dict[int, tuple[Ratio, int]] = {}
    before = AnswerParts(())
    if unknowns and method in ("lagrange", "energy"):
        from freebody.narrative.principles.analytic import by_energy, by_lagrange

        found = (by_energy if method == "energy" else by_lagrange)(context, script, unknowns)
    elif unknowns:
        loop_lines(context, script)
        found = newton.write(script, newton.plan(unknowns), unknowns)
    else:
        refuse(method, (), Message("what follows from the state alone"))
        before = parts_of_state(context, script, question)
    finish(context, script, question, parts, found, before)
    return script.stages


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
    name = asked_symbol(context, question, len(parts))
    lines = (*(before.lines if before else ()), *(line for _value, line in found.values()))
    is_there = len(parts) == 1 and any((parts[0] - f.variable(u)).is_zero() for u in found)
    last = lines[-1] if lines else 0
    if not is_there:
        with script.stage("stage.value", "hint.value"):
            names = (name,) if len(parts) == 1 else names_of(name, len(parts))
            script.add(Legend(tuple((n, Sentence("symbol.asked", {"question": question.text}), "") for n in names)))
            shown = written(general)
            sides: list[Expr | tuple[Expr, ...]] = [side_of(name, len(general))]
            unsolved = written(parts)
            if before is not None and before.total is not None:
                sides.append(before.total)
            elif found and unsolved != shown:
                sides.append(unsolved)
            last = script.line(
                *sides, shown, why="value.follows" if lines else "value.is", args={"lines": lines}, uses=lines
            )
    wanted = tuple(general)
    if question.at_start:
        with script.stage("stage.start", "hint.start"):
            here = setup.start_instant
            wanted = tuple(f.lowest_terms(here.here(part)) for part in general)
            shown = written(wanted)
            left = side_of(name, len(wanted)) if not is_there else tidy(parts[0])
            script.line(left, shown, why="value.start", args={"lines": (last,)}, uses=(last,), when="start")
    _ends_in_answer(context, question, wanted)


def _ends_in_answer(context: Context, question: Question, found: Sequence[Ratio]) -> None:
    setup = context.setup
    state = setup.start_instant if question.at_start else setup.state
    wanted = elements(setup.model.field, question.quantity.value(setup.system, state))
    if any(not setup.model.samples.vanishes(a - b) for a, b in zip(found, wanted, strict=True)):
        same_answer(found, wanted)


def asked_symbol(context: Context, question: Question, n: int = 1) -> Symbol:
    """A symbol for what is asked, and one for each of n components: the question's id where that is a good name."""
    own = question.id if re.fullmatch(r"[A-Za-z]\w*", question.id) else "result"
    reactions = {r.name for r in reaction_symbols(context.system).values()}
    if n > 1 and any(name.name in reactions for name in names_of(Symbol(own), n)):
        own = f"{own}_asked"
    symbol = context.symbol(own, f"{own}_asked")
    what = Sentence("symbol.asked", {"question": question.text})
    quantity, system = question.quantity, context.system

    def part(k: int) -> Callable[[World], float]:
        return lambda world: float(quantity.value(system, world.snapshot)[k])

    def counted(world: World) -> float:
        assert question.event is not None
        setup, end = context.setup, world.snapshot.t
        work = partial(work_until, setup, draw=world.draw, event=question.event, end=end)
        return float(quantity.counted(NumericPassage(setup, world.draw.start(), world.snapshot, end, work)))

    if symbol.name not in context.glossary.meanings:
        read = counted if quantity.scope == "course" else quantity
        context.glossary.introduce(Meaning(symbol, what, read))
    for k, name in enumerate(names_of(symbol, n) if n > 1 else ()):
        context.glossary.introduce(Meaning(name, what, part(k)))
    return symbol


def written(parts: Sequence[Ratio]) -> Expr | tuple[Expr, ...]:
    """A scalar as it is written, or the components of a vector."""
    shown = tuple(map(tidy, parts))
    return shown[0] if len(shown) == 1 else shown


def names_of(name: Symbol, n: int) -> tuple[Symbol, ...]:
    """The names of the components of a vector."""
    return tuple(Symbol(f"{name.name}_{axis}") for axis in "xyz"[:n])


def side_of(name: Symbol, n: int) -> Expr | tuple[Expr, ...]:
    """The name of a scalar, or of the components of a vector."""
    return name if n == 1 else names_of(name, n)
