"""Rates and places of steady motion: what the equations of motion become when nothing accelerates.

Coordinates that the equations of motion do not contain are cyclic: they run evenly, the others stay. Then

    M q'' = F(q, q')    becomes    F(x, u) = 0

with the values x of what stays and the rates u of what runs. Source: Routh, Dynamics of a System of Rigid Bodies,
Advanced Part, 1905, ch. III.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, rate_key
from freebody.language.sentences import Argument, Message, Sentence
from freebody.model.states import shown_rate, state_name
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Glossary, Meaning, TrueWhen, World
from freebody.narrative.lines.naming import asked_as, asked_entry, asked_symbol, names_of, side_of
from freebody.narrative.lines.script import DerivationStage, Legend, Script, ready
from freebody.narrative.principles.motion_equations import motion_equations
from freebody.narrative.principles.sides import balanced
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.questions.steady import SteadyValue, is_steady_place
from freebody.study.answering.answer import Answer
from freebody.study.setup import Setup
from freebody.study.steady.evidence import motions
from freebody.study.steady.motion import Solutions, SteadyMotion, unknown_of
from freebody.symbolic.tidy import tidy

N_WORLDS = 3


class SteadyGlossary(Glossary):
    """Symbols whose values at the "event" are those of steady motions of the full system: rates at random, one motion
    for each root."""

    def __init__(self, setup: Setup, steady: SteadyMotion, solutions: Solutions | None) -> None:
        super().__init__(setup)
        self.steady, self.solutions = steady, solutions
        self._found: list[dict[int, World]] | None = None

    def worlds(self, when: TrueWhen) -> Iterator[World]:
        if when == "event":
            yield from self.of_root(0)
        else:
            yield from super().worlds(when)

    def of_root(self, k: int) -> list[World]:
        """Steady motions with the root number k."""
        if self._found is None:
            self._found = []
            for draw, found in motions(self.setup, self.steady, self.solutions):
                if self._found and len(found) < len(self._found[0]):
                    break  # behind those with all roots
                self._found.append({k: World(self, draw, draw.seen(s)) for k, s in found.items()})
                if len(self._found) == N_WORLDS:
                    break
        return [row[k] for row in self._found if k in row]


@dataclass
class _SteadyTelling:
    context: Context
    question: Question
    answer: Answer
    steady: SteadyMotion
    script: Script


def tell_steady(context: Context, question: Question, answer: Answer, q: SteadyValue) -> list[DerivationStage]:
    """The equations of motion, what they become, the roots, and the quantity that is asked for."""
    steady = SteadyMotion.asked(context.setup.model, question.event)
    unknown = unknown_of(steady, q)
    is_place = is_steady_place(q)
    solutions: Solutions | None
    if unknown is None:
        solutions = steady.eliminated(even_if_open=is_place) or steady.any_solution()
        if is_place and solutions is not None and len(solutions.roots) > 1:  # of the coordinate that the measure is of
            unknown = next((c for c in steady.others if c.index == solutions.index), None)
    else:
        solutions = steady.at_position(unknown) if is_place else steady.solved_for(unknown.speed)
    telling = _SteadyTelling(context, question, answer, steady, context.script())
    lines = _equations(telling)
    glossary = SteadyGlossary(context.setup, steady, solutions)
    glossary.meanings.update(context.glossary.meanings)
    script = Script(glossary, telling.script.next_number)
    with script.stage("steady.condition", "steady.condition_hint"):
        conditions = _conditions(telling, script, lines)
    with script.stage("stage.value"):
        if unknown is None:
            _during(telling, script, q, conditions)
        else:
            symbol = Symbol(unknown.name) if is_place else rates_of(unknown.name, 1)
            assert solutions is not None
            _roots(telling, script, glossary, q, symbol, solutions, conditions)
    return [*telling.script.stages, *script.stages]


def _equations(telling: _SteadyTelling) -> list[int]:
    """The equations of motion."""
    context, script = telling.context, telling.script
    try:
        with script.stage("unclosed.equations", "unclosed.equations_hint"):
            return [row.number for row in motion_equations(context, script)]
    except CannotAnswer:
        script.stages.clear()
        return []


def tell_what_runs(script: Script, steady: SteadyMotion) -> None:
    """Which coordinates run evenly, and what stays constant, states of controllers among it."""
    runs = [Symbol(c.name) for c in steady.cyclic if not state_name(c.name)]
    stays = [Symbol(c.name) for c in steady.others] + [shown_rate(c.name) for c in steady.cyclic if state_name(c.name)]
    for key, names in (("cyclic", runs), ("others", stays)):
        if names:
            script.say(f"steady.{key}", names=tuple(names))


def _conditions(telling: _SteadyTelling, script: Script, lines: list[int]) -> list[int]:
    """What is left where all accelerations vanish and only cyclic coordinates run."""
    steady = telling.steady
    tell_what_runs(script, steady)
    found: list[int] = []
    for equation in steady.equations:
        args: dict[str, Argument] = {"lines": tuple(lines)}
        why = "steady.left" if lines else "steady.left_plain"
        found.append(script.line(*balanced(tidy(equation)), why=why, args=args, uses=tuple(lines), when="event"))
    if not steady.equations:
        script.say("steady.every")
    for x in steady.always:
        script.say("steady.always", factor=tidy(x))
    return found


def _roots(
    telling: _SteadyTelling,
    script: Script,
    glossary: SteadyGlossary,
    q: SteadyValue,
    symbol: Expr,
    solutions: Solutions,
    uses: list[int],
) -> None:
    """Each root in the steady motion that belongs to it, then all together."""
    expression = telling.answer.expression
    assert expression is not None
    general = tuple(map(tidy, solutions.roots))
    args: dict[str, Argument] = {"lines": tuple(uses)}
    if len(general) == 1:
        name = asked_as(telling.context, telling.question, lambda world: world[rate_key(symbol)])
        glossary.redefine(telling.context.glossary.meanings[name.name])
        script.add(asked_entry(name, telling.question))
        sides: tuple[Expr | tuple[Expr, ...], ...] = (name, symbol, general[0])
    else:
        script.say("steady.roots", n=len(general))
        sides = (_root_symbols(telling, script, glossary, symbol, general), general)
    for note in solutions.notes:
        if note not in telling.answer.notes:  # which the result tells
            script.say("result.note", text=ready(note))
    line = script.line(*sides, why="steady.solved", args=args, uses=tuple(uses), when="event")
    if unknown_of(telling.steady, q) is None and sides[-1] != expression:
        _measured(telling, script, glossary, q, line)
    elif sides[-1] != expression:
        given: dict[str, Argument] = {"lines": (line,)}
        script.line(sides[-1], expression, why="value.start", args=given, uses=(line,), when="start")


def _measured(telling: _SteadyTelling, script: Script, glossary: SteadyGlossary, q: SteadyValue, line: int) -> None:
    """What is asked by the places of a coordinate, each put into what tells it by that."""
    context, expression = telling.context, telling.answer.expression
    assert isinstance(expression, tuple)
    assert q.of.watched is not None
    measure = q.of.watched[0]
    asked = Symbol(next((name for name, m in context.system.measures.items() if m == measure), "value"))
    names = _names(context, asked, len(expression))
    entries: list[tuple[Expr, Sentence, str]] = []
    for k, name in enumerate(names):

        def read(world: World, k: int = k) -> float:
            own = next(w for w in glossary.of_root(k) if w.draw is world.draw)
            return float(q.of.value(context.system, own.snapshot))

        what = Sentence("steady.root", {"k": k + 1, "name": asked})
        glossary.redefine(Meaning(name, what, read))
        entries.append((name, what, ""))
    script.add(Legend(tuple(entries)))
    value = telling.steady.put_in(context.setup.model.value_of(measure))
    args: dict[str, Argument] = {"lines": (line,), "value": tidy(value)}
    script.line(tuple(names), expression, why="steady.measured", args=args, uses=(line,), when="event")


def _root_symbols(
    telling: _SteadyTelling, script: Script, glossary: SteadyGlossary, symbol: Expr, roots: Sequence[Expr]
) -> tuple[Symbol, ...]:
    """A symbol for each root, with its value in the steady motion of that root with the same numbers; an angle is the
    same after a full turn."""
    names = _names(telling.context, symbol, len(roots))
    turns = any(c.is_angle and Symbol(c.name) == symbol for c in telling.steady.others)
    entries: list[tuple[Expr, Sentence, str]] = []
    for k, name in enumerate(names):
        what = Sentence("steady.root", {"k": k + 1, "name": symbol})

        def read(world: World, k: int = k) -> float:
            own = next(w for w in glossary.of_root(k) if w.draw is world.draw)
            value = float(own[rate_key(symbol)])
            return value - math.tau * round((value - float(own.of(roots[k])[0])) / math.tau) if turns else value

        glossary.redefine(Meaning(name, what, read))
        entries.append((name, what, ""))
    script.add(Legend(tuple(entries)))
    return tuple(names)


def _names(context: Context, symbol: Expr, n: int) -> list[Symbol]:
    """rate_psi_1 of psi', theta_1 of theta."""
    bare = symbol.argument if isinstance(symbol, Call) else symbol
    assert isinstance(bare, Symbol)
    stem = bare.name if bare is symbol else f"rate_{bare.name}"
    return [context.symbol(f"{stem}_{k + 1}", f"{stem}_root{k + 1}") for k in range(n)]


def _during(telling: _SteadyTelling, script: Script, q: SteadyValue, uses: list[int]) -> None:
    """Another quantity while the motion is steady."""
    context, question = telling.context, telling.question
    expression = telling.answer.expression
    assert expression is not None
    if question.at_start:
        raise CannotAnswer(Message("what a steady motion has at the start is derived for rates and places only"))
    n = len(expression) if isinstance(expression, tuple) else 1
    symbol = asked_symbol(context, question, n)
    for k, name in enumerate(names_of(symbol, n) if n > 1 else (symbol,)):
        what = context.glossary.meanings[name.name].what
        script.glossary.redefine(Meaning(name, what, _reader(context, q, k if n > 1 else None)))
    script.add(asked_entry(symbol, question, n=n))
    args: dict[str, Argument] = {"lines": tuple(uses)}
    script.line(side_of(symbol, n), expression, why="steady.during", args=args, uses=tuple(uses), when="event")


def _reader(context: Context, q: SteadyValue, k: int | None) -> Callable[[World], float]:
    """The quantity, or one of its components, at an instant of a steady motion."""

    def read(world: World) -> float:
        value = q.of.value(context.system, world.snapshot)
        return float(value if k is None else value[k])

    return read
