"""For which value of a parameter something is so: the quantity is derived, equated, and solved for the parameter."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction

from freebody.errors import CannotAnswer, ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, Symbol, evaluate, number, substitute
from freebody.language.sentences import Message, Sentence
from freebody.narrative.contact.settings import has_phases
from freebody.narrative.context import Context, Method
from freebody.narrative.first_turn import at_first_turn
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import DerivationStage, Legend, NumberedFormula, Script, ready
from freebody.narrative.principles.sides import parted
from freebody.narrative.questions.wanted import answer_holds, has_values, introduced
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity, Wanted
from freebody.questions.happening import Happening
from freebody.questions.reading import Question
from freebody.questions.turned_round import EXTREMAL, TENDS
from freebody.study.answering.answer import Answer
from freebody.study.answering.draws import Draw
from freebody.study.answering.numbers import LONGEST, at_event, number_at
from freebody.study.answering.simulated_numbers import number_with_changes
from freebody.study.answering.solve import solve
from freebody.study.answering.turned_round import with_others
from freebody.study.answering.witness import patience
from freebody.symbolic.limits import derivative_by
from freebody.symbolic.relations import readable
from freebody.system.system import System

_ROOT = 1e-6  # of what the quantity changes by nearby: it has the wanted value
_BESIDE = 1e-4  # of its own value: a parameter that is near its limit
_ALIKE = 0.1  # relative: two cases differ by more where one of them is near its limit
_STEP = 1e-4  # of the value: by so much it is changed to see how the quantity changes


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of the quantity, then the value. Raises CannotAnswer where the quantity has none with the number
    that the file gives for the parameter."""
    quantity = question.quantity.wanted
    assert quantity is not None
    if answer.expression is None and answer.value is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    if isinstance(quantity.of, Happening):
        from freebody.narrative.questions.happening import derive as derive_happening

        return derive_happening(context, question, answer, method)
    own, text = _as_asked_before(context.system, question, quantity)
    asked = replace(question, id=own, text=text, quantity=quantity.of, options={}, key=None)
    if quantity.of.scope == "linkage":
        (given,) = solve(replace(context.system, questions=(asked,)), setup=context.setup).answers
        return derivation_of(context.system, asked)(context, asked, given, method)
    values = _values_of(answer)
    there, given, formula = _reached(context, asked, quantity, values)
    asked = at_first_turn(there.system, asked, given) or asked
    stages = derivation_of(there.system, asked)(there, asked, given, method)
    numbers = [item.number for stage in stages for item in stage.items if isinstance(item, NumberedFormula)]
    if answer.expression is None:
        script = Script(there.glossary, max([context.next_number - 1, *numbers]) + 1)
        with script.stage("stage.turned", "hint.turned", name=quantity.parameter):
            script.say("unclosed.why", reason=ready(answer.reason))
        return [*stages, *script.stages]
    if quantity.relation == TENDS:
        script = Script(there.glossary, max([context.next_number - 1, *numbers]) + 1)
        with script.stage("stage.limit", "hint.limit", name=quantity.parameter):
            _tends(there, script, question, formula, values[0])
        return [*stages, *script.stages]
    if quantity.relation == EXTREMAL:
        script = Script(there.glossary, max([context.next_number - 1, *numbers]) + 1)
        with script.stage("stage.extremal", "hint.extremal", name=quantity.parameter):
            _stationary(there, script, question, quantity, formula, values[0])
        return [*stages, *script.stages]
    if quantity.relation != "=" and not _are_roots(there, quantity, formula, values):
        raise CannotAnswer(Message("the ends of the range are where the formula of the quantity stops to be true"))
    glossary = there.glossary.where(lambda world: has_values(world, values) and answer_holds(world, answer))
    script = Script(glossary, max([context.next_number - 1, *numbers]) + 1)
    with script.stage("stage.turned", "hint.turned", name=quantity.parameter):
        _solved(there, script, question, formula, values)
    return [*stages, *script.stages]


def _as_asked_before(system: System, question: Question, quantity: Wanted) -> tuple[str, str]:
    """The id and the words of the question about the quantity itself, where that is asked before: its derivation is
    told there, and its symbol is the one of it."""
    for q in system.questions:
        if q.id == question.id:
            break
        same = (q.quantity, q.event, q.transition, q.at_start)
        if same == (quantity.of, question.event, question.transition, question.at_start):
            return q.id, q.text
    return "q1", quantity.text


def _values_of(answer: Answer) -> tuple[Expr, ...]:
    """In closed form, else in numbers."""
    if answer.expression is not None:
        return answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    found = answer.value if isinstance(answer.value, tuple) else (answer.value,)
    return tuple(number(Fraction(x)) for x in found if x is not None)


def _stationary(
    context: Context, script: Script, question: Question, quantity: Wanted, formula: Expr, value: Expr
) -> None:
    """The slope of the formula, and where it vanishes."""
    name, place = quantity.parameter, value
    if not quantity.asks_place:
        where = replace(question, quantity=quantity.asking(), options={}, key=None)
        (found,) = solve(replace(context.system, questions=(where,))).answers
        if not isinstance(found.expression, Expr):
            raise CannotAnswer(found.reason or Message("there is no closed form"))
        place = found.expression
    model = context.setup.model
    slope = derivative_by(model, model.geometry.scalar(formula), model.field.index(model.parameters[name]))
    unit = "rad" if context.system.parameters[name].is_angle else str(context.system.parameters[name].dimension)
    symbol, what = context.symbol(f"{name}_req", f"{name}_asked"), Sentence("symbol.asked")
    script.glossary.redefine(Meaning(symbol, what, lambda world: float(world.of(place)[0]), unit))
    script.add(Legend(((symbol, what, unit),)))
    left, right = parted(substitute(readable(slope.numerator()), {name: symbol}))
    when = "event" if question.event is not None else "start" if question.at_start else "always"
    line = script.line(left, right, why="turned.stationary", args={"name": Symbol(name)}, when=when)
    solved = script.line(symbol, place, why="turned.solved", args={"lines": (line,)}, uses=(line,), when=when)
    if not quantity.asks_place:
        there = substitute(formula, {name: symbol})
        script.line(there, value, why="turned.there", args={"lines": (solved,)}, uses=(solved,), when=when)


def _tends(context: Context, script: Script, question: Question, formula: Expr, value: Expr) -> None:
    """The limit of the formula; its second opinion is the formula at two parameters near it, extrapolated."""
    quantity = question.quantity.wanted
    assert quantity is not None
    name, parameter = context.symbol("Q_lim", "Q_limit"), quantity.parameter

    def near(world: World) -> float:
        own = abs(world.draw.values[parameter]) or 1.0
        at = float(world.of(quantity.target)[0])
        found: list[float] = []
        for share in (_BESIDE, _BESIDE / 2):
            way = -1.0 if at and context.system.parameters[parameter].acute else 1.0
            x = own / share if quantity.end == "grows" else at + way * share * own
            found.append(float(world.of(substitute(formula, {parameter: number(Fraction(x))}))[0]))
        return 2.0 * found[1] - found[0]

    what = Sentence("symbol.asked")
    script.glossary.redefine(Meaning(name, what, near, question.quantity.unit))
    script.add(Legend(((name, what, question.quantity.unit),)))
    when = "event" if question.event is not None else "start" if question.at_start else "always"
    key = "turned.limit_grows" if quantity.end == "grows" else "turned.limit"
    script.line(name, value, why=key, args={"name": Symbol(parameter), "target": quantity.target}, when=when)


def _are_roots(context: Context, quantity: Wanted, formula: Expr, values: Sequence[Expr]) -> bool:
    """Whether the formula is what is wanted at all values, at the model's own numbers."""
    own = context.setup.draws[0].values
    with suppress(ArithmeticError, ValueError, KeyError):
        for value in values:
            x = float(evaluate(value, own, FLOAT_FUNCTIONS))
            target = float(evaluate(quantity.target, {**own, quantity.parameter: x}, FLOAT_FUNCTIONS))
            found = float(evaluate(formula, {**own, quantity.parameter: x}, FLOAT_FUNCTIONS))
            near = float(evaluate(formula, {**own, quantity.parameter: 1.1 * x}, FLOAT_FUNCTIONS))
            if near == found or abs(found - target) > _ROOT * max(abs(near - found), abs(target)):
                return False
        return True
    return False


def _reached(
    context: Context, asked: Question, quantity: Wanted, values: Sequence[Expr]
) -> tuple[Context, Answer, Expr]:
    """The quantity as a formula; where it is out of reach with the number that the file gives, with another one. Of
    several values of a steady motion the one that is solved for the answer."""
    why: Message | str = ""
    elsewhere: tuple[Context, Answer, Expr] | None = None  # the formula of another case than the one near a limit
    for system in with_others(context.system, quantity.parameter):
        here = context if system is context.system else Context(system, context.next_number, context.introduced)
        setup = None if has_phases(system) else here.setup
        (given,) = solve(replace(system, questions=(asked,)), setup=setup).answers
        if given.expression is not None and not isinstance(given.expression, tuple):
            if quantity.relation != TENDS or _tends_to(context, quantity, given.expression, values[0]):
                return here, given, given.expression
            elsewhere = elsewhere or (here, given, given.expression)
        if isinstance(given.expression, tuple) and asked.quantity.scope == "steady motion":
            formula = next((x for x in given.expression if _are_roots(here, quantity, x, values)), None)
            if formula is not None:
                return here, given, formula
        why = why or given.reason
    if elsewhere is not None:
        return elsewhere
    raise CannotAnswer(why or Message("there is no closed form"))


def _tends_to(context: Context, quantity: Wanted, formula: Expr, limit: Expr) -> bool:
    """Whether a formula is near its limit where the parameter is, at the model's own numbers; so it is taken to be
    where that is not told by numbers."""
    own = context.setup.draws[0].values
    with suppress(ArithmeticError, ValueError, KeyError):
        beside = abs(own[quantity.parameter]) or 1.0
        at = beside / _BESIDE if quantity.end == "grows" else _BESIDE * beside
        at += float(evaluate(quantity.target, own, FLOAT_FUNCTIONS))
        near, wanted = (float(evaluate(x, {**own, quantity.parameter: at}, FLOAT_FUNCTIONS)) for x in (formula, limit))
        return abs(near - wanted) <= _ALIKE * max(abs(near), abs(wanted)) or wanted == 0.0
    return True


def _solved(context: Context, script: Script, question: Question, formula: Expr, values: Sequence[Expr]) -> None:
    """The equation, and its solutions."""
    quantity = question.quantity.wanted
    assert quantity is not None
    is_steady = quantity.of.scope == "steady motion"  # then an event is what is given, and put in already
    is_at_event = question.event is not None and not is_steady
    when = "event" if is_at_event else "start" if question.at_start else "always"
    names = introduced(context, script, question, values, _Refined(context.system, question, quantity).reader)
    lines: list[int] = []
    for name in names:
        put_in, target = (substitute(x, {quantity.parameter: name}) for x in (formula, quantity.target))
        args = {"name": Symbol(quantity.parameter)}
        why = "" if lines else "turned.equation"
        lines.append(script.line(put_in, target, why=why, args=args, when=when))
    sides = (names[0], values[0]) if len(names) == 1 else (tuple(names), tuple(values))
    script.line(*sides, why="turned.solved", args={"lines": tuple(lines)}, uses=tuple(lines), when=when)


@dataclass(frozen=True)
class _Refined:
    """The value by the numeric route: that of the formula, and one step of Newton's method from there with the quantity
    found in numbers, less what it is to be, which may hang on the parameter too."""

    system: System
    question: Question
    quantity: Wanted

    def reader(self, value: Expr) -> Callable[[World], float]:
        return lambda world: self._number(world, float(world.of(value)[0]))

    def _number(self, world: World, x: float) -> float:
        # a change of contacts, and a steady motion, are found by the numeric route in ways of their own
        if self.question.transition is not None or self.quantity.of.scope == "steady motion":
            return x
        step = _STEP * (abs(x) or 1.0)
        beside = {s: found for s in (step, -step) if (found := self._if_any(world, x + s)) is not None}
        there = self._if_any(world, x)
        if there is None and len(beside) == 1:  # the event just comes there, on one side of it: the tangent from there
            ((s, first),) = beside.items()
            second = self._excess(world, x + 2.0 * s)
            there = 2.0 * first - second
        if there is None or not beside:
            return x - self._excess(world, x)  # which says why there is none
        # behind a contact that opens there the quantity rests: the slope is that of the side where it changes
        change, step = max(((found - there, s) for s, found in beside.items()), key=lambda at: abs(at[0]))
        if change == 0.0:
            raise CannotAnswer(Message("that does not depend on {name}", name=self.quantity.parameter))
        return x - there * step / change

    def _if_any(self, world: World, x: float) -> float | None:
        with suppress(CannotAnswer):
            return self._excess(world, x)
        return None

    def _excess(self, world: World, x: float) -> float:
        target = substitute(self.quantity.target, {self.quantity.parameter: number(Fraction(x))})
        return self._quantity(world, x) - float(world.of(target)[0])

    def _quantity(self, world: World, x: float) -> float:
        values = world.draw.values | {self.quantity.parameter: x}
        of, question, setup = self.quantity.of, self.question, world.glossary.setup
        if has_phases(self.system):
            try:
                system = self.system.with_parameters(**_given(self.system, values))
            except ModelError as error:  # no body is so: a pipe with a bore wider than itself
                raise CannotAnswer(str(error)) from error
            found = number_with_changes(system, _of(question, of))
        else:
            draw = world.draw.with_values(values, setup.system)
            if not of.is_of_state:
                found = number_at(setup, of, question.event, draw)
            elif question.event is not None:
                found = at_event(setup, of, draw, draw.start(), patience(draw.start(), LONGEST), question.event)
            else:
                moved = draw.start() if question.at_start else self._led_along(draw, world)
                found = of.value(setup.system, draw.seen(moved))
        if isinstance(found, (int, float)):
            return float(found)
        raise CannotAnswer(Message("one number must have a value here, and that is none in closed form"))

    def _led_along(self, draw: Draw, world: World) -> Snapshot:
        """The instant of a world with other numbers of the parameters: what is driven is where its drive, which may
        hang on them, has it then, and the coordinates are as they were."""
        here, reference, model = world.snapshot, draw.reference, world.glossary.setup.model
        if not any(row.is_driven for row in self.system.constraint_rows):
            return reference.snapshot(here.q, here.v, here.t)
        measures = [m for c in model.coordinates if (m := model.measure_of(c)) is not None]
        q = reference.pose_near(here.q, [(m, here.value(m)) for m in measures], here.t)
        v = reference.velocities(q, [(m, here.rate(m)) for m in measures], here.t, with_start=False)
        return reference.snapshot(q, v, here.t)


def _of(question: Question, of: Quantity) -> Question:
    return replace(question, quantity=of, options={}, key=None)


def _given(system: System, values: dict[str, float]) -> dict[str, float]:
    return {name: x for name, x in values.items() if name in system.parameters}
