"""A loop of four links: its diagonal by the law of cosines, from it what can turn, reverse, and how it transmits."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import singledispatch

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.expression import Call, Expr, Symbol, add, multiply, negate, number, power
from freebody.language.sentences import Argument, Message, Sentence
from freebody.measures.geometry import GROUND
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import asked_name, fresh
from freebody.narrative.lines.script import DerivationStage, NumberedFormula, Script, ready
from freebody.narrative.questions.linkage_loop import introduce, tell_diagonal, tell_lengths
from freebody.narrative.steady.extremes import by_the_drive
from freebody.questions.at_dead_points import AtDeadPoints
from freebody.questions.base import Quantity
from freebody.questions.linkages import Assembly, DeadPoints, FullTurn, TransmissionAngle
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes
from freebody.study.answering.answer import Answer
from freebody.study.answering.crosscheck import element_at
from freebody.study.mobility.at_dead_points import by_crank, values_there
from freebody.study.mobility.dead_points import (
    DeadPoint,
    bars_of,
    dead_points,
    needs_of,
    needs_of_reversal,
    transmission_extreme,
)
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.linkages import FourBar, SliderCrank
from freebody.study.mobility.loop_answers import (
    extreme_in_numbers,
    nearest,
    output_of,
    reversing,
    transmission_in_numbers,
)
from freebody.study.mobility.loop_questions import four_links
from freebody.study.steady.drive import followed
from freebody.study.steady.round_turn import DrawnTurn
from freebody.symbolic.closure import explicit
from freebody.symbolic.conditions import Condition
from freebody.symbolic.tidy import tidy

_TWO = number(2)


@dataclass(frozen=True)
class _Told:
    """What the derivation of one question is written with. line: that of the distance between the links, by its
    symbol."""

    context: Context
    question: Question
    answer: Answer
    links: FourLinks
    script: Script
    line: int
    distance: Symbol


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """Raises CannotAnswer where the solver has no formula."""
    refuse(method, (), Message("the geometry of a loop"))
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    return _derived(question.quantity, context, question, answer)


@singledispatch
def _derived(q: Quantity, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    try:
        links = four_links(context.setup)
    except CannotAnswer:
        return _elsewhere(question.quantity, context, question, answer)
    needs = _needs(question.quantity, links)
    script = Script(context.glossary.where(lambda world: _hold(links, needs, world)), context.next_number)
    with script.stage("linkage.loop", "linkage.loop_hint"):
        tell_lengths(script, links)
        line, distance = tell_diagonal(context, script, links)
    with script.stage("linkage.conclusion", "linkage.conclusion_hint"):
        _concluded(question.quantity, _Told(context, question, answer, links, script, line, distance))
    return script.stages


@_derived.register(AtDeadPoints)
def _(q: AtDeadPoints, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    """The angle of the crank at the dead points, and what is asked as a function of it."""
    before, watched = context.script(), q.of.watched
    if watched is not None and not watched[1] and not q.which:
        of_pose = DeadPoints(watched[0], q.of.kind)
        return _derived(of_pose, context, replace(question, quantity=of_pose), answer)
    looked = by_crank(context.setup, q, four_links)
    used = by_the_drive(context, before, q.of) if q.of.kinematic_order != 0 else ()
    turned = Context(looked.system, before.next_number, context.introduced)
    turned.setup = looked
    (c,) = looked.model.coordinates
    measure = looked.model.measure_of(c)
    assert measure is not None
    poses = DeadPoints(measure, c.name)
    named_after = replace(question, quantity=poses, id=c.name)
    stages = _derived(poses, turned, named_after, answer)
    last = max(item.number for stage in stages for item in stage.items if isinstance(item, NumberedFormula))
    turned.next_number = last + 1
    script = turned.script()
    links = four_links(looked)
    with script.stage("stage.value", "hint.value"):
        _at_each(turned, script, question, links, q, used, last)
    return [*before.stages, *stages, *script.stages]


def _at_each(
    context: Context,
    script: Script,
    question: Question,
    links: FourLinks,
    q: AtDeadPoints,
    used: tuple[int, ...],
    last: int,
) -> None:
    """What is asked as a function of the angle, and its values there."""
    setup, f = links.setup, links.field
    (c,) = links.model.coordinates
    symbol = Symbol(fresh(context, "y", "y_crank"))

    def read(world: World) -> float:
        return DrawnTurn(setup, world.draw, c, q.of).value(world.snapshot.q)

    what = Sentence("steady.followed", {"name": Symbol(c.name)})
    introduce(script, Meaning(symbol, what, read, q.unit))
    general = explicit(links.model, f.lowest_terms(f.element(followed(setup, q.of))))
    args: dict[str, Argument] = {"lines": used, "name": Symbol(c.name)}
    why = "steady.driven" if used else "steady.quantity"
    first = script.line(symbol, tidy(general), why=why, args=args, uses=used)
    found = values_there(links, q)
    for k, (point, value) in enumerate(found):

        def there(world: World, point: DeadPoint = point) -> float:
            turn = DrawnTurn(setup, world.draw, c, q.of)
            (angle,) = element_at(setup, point.value, world.draw, turn.start)
            return turn.at(math.remainder(angle - turn.here, math.tau))

        name = _asked(context, question, k, len(found))
        told = Sentence("linkage.dead_symbol", {"name": question.text, "where": ready(point.where)})
        introduce(script, Meaning(name, told, there, q.unit))
        given: dict[str, Argument] = {"lines": (first, last)}
        script.line(name, tidy(value), why="linkage.there", args=given, uses=(first, last), when="never")


@singledispatch
def _elsewhere(q: Quantity, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    """In another mechanism: through its coordinate."""
    script = context.script()
    with script.stage("linkage.conclusion", "linkage.coordinate_hint"):
        names = tuple(Symbol(c.name) for c in context.setup.model.coordinates)
        script.say("linkage.coordinate", names=names)
    return script.stages


@_elsewhere.register(DeadPoints)
def _(q: DeadPoints, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    from freebody.narrative.steady.extremes import tell_extremes

    return tell_extremes(context, question, answer, Extremes(OfMeasure(q.of, 0, q.name), None))


@singledispatch
def _needs(q: Quantity, links: FourLinks) -> list[Condition]:
    """Without what the formulas of the answer are not true."""
    return []


@_needs.register(DeadPoints)
def _(q: DeadPoints, links: FourLinks) -> list[Condition]:
    return needs_of_reversal(links)


@_needs.register(TransmissionAngle)
def _(q: TransmissionAngle, links: FourLinks) -> list[Condition]:
    if not q.end:
        return []
    return [*needs_of(links), *transmission_extreme(links, is_least=q.end == "least")[1]]


@singledispatch
def _concluded(q: Quantity, told: _Told) -> None:
    """What follows from the distance that has to be bridged."""
    raise CannotAnswer(Message("this is no question about a linkage"))


def _hold(links: FourLinks, needs: list[Condition], world: World) -> bool:
    draw = world.draw
    return all(element_at(links.setup, c.element, draw, draw.start())[0] >= 0 for c in needs)


# -- what follows -----------------------------------------------------------------------------
@_concluded.register(Assembly)
def _assembly(q: Assembly, told: _Told) -> None:
    told.script.say("linkage.polygon" if isinstance(told.links.loop, FourBar) else "linkage.reach")


@_concluded.register(FullTurn)
def _turn(q: FullTurn, told: _Told) -> None:
    script, links, line, loop = told.script, told.links, told.line, told.links.loop
    if isinstance(loop, FourBar):
        others = tuple(name for name in loop.links if name not in (q.link, GROUND))
        script.say("linkage.turn_bars", link=q.link, first=others[0], second=others[1])
    elif loop.fixed == loop.guide:
        other = loop.rod if q.link == loop.crank else loop.crank
        script.say("linkage.turn_guide", link=q.link, other=other)
    elif q.link == loop.guide:
        script.say("linkage.turn_lever", link=q.link, line=line)
    else:
        script.say("linkage.turn_driver", link=q.link, guide=loop.guide, line=line)
    script.say("linkage.therefore", condition=ready(links.turning(q.link).says))


@_concluded.register(DeadPoints)
def _dead(q: DeadPoints, told: _Told) -> None:
    script, links, loop = told.script, told.links, told.links.loop
    found = dead_points(links, q.of, q.name)
    is_lever = isinstance(loop, SliderCrank) and loop.fixed != loop.guide
    coupler = loop.coupler if isinstance(loop, FourBar) else loop.rod
    key = "linkage.lever_reverses" if is_lever else "linkage.reverses"
    script.say(key, output=output_of(links), crank=links.crank, coupler=coupler)
    names = [_asked(told.context, told.question, k, len(found)) for k in range(len(found))]
    for name, point in zip(names, found, strict=True):
        what = Sentence("linkage.dead_symbol", {"name": q.name, "where": ready(point.where)})
        introduce(script, Meaning(name, what, _reader(links, q, point), q.unit))
    for name, point in zip(names, found, strict=True):
        _triangle(script, links, point)
        script.line(name, tidy(point.value), why="linkage.from_triangle", when="never")


def _asked(context: Context, question: Question, k: int, n: int) -> Symbol:
    own = asked_name(context, question)
    return Symbol(fresh(context, own if n == 1 else f"{own}_{k + 1}", f"{own}_asked{k + 1}"))


def _reader(links: FourLinks, q: DeadPoints, point: DeadPoint) -> Callable[[World], float]:
    """Where the output reverses in numbers."""

    def read(world: World) -> float:
        try:
            there = reversing(links, world.draw, q.of)
        except SaysNothing as error:
            raise CannotAnswer(str(error)) from None
        (x,) = element_at(links.setup, point.value, world.draw, world.draw.start())
        return nearest(x, there, is_angle=q.unit == "rad")

    return read


def _triangle(script: Script, links: FourLinks, point: DeadPoint) -> None:
    """What the three sides are then."""
    loop = links.loop
    if isinstance(loop, FourBar):
        bars = bars_of(links)
        sides = tuple(tidy(x) for x in (point.reach, bars.d, bars.c))
        script.say("linkage.triangle", where=ready(point.where), sides=sides)
    elif loop.fixed == loop.guide:
        e = tidy(links.lengths[loop.guide])
        script.say("linkage.right_triangle", where=ready(point.where), long=tidy(point.reach), short=e)
    else:
        d = links.lengths[loop.crank if loop.fixed == loop.crank else loop.rod]
        e = links.lengths[loop.guide]
        short = tidy(links.field.lowest_terms(point.reach - e))
        script.say("linkage.right_triangle", where=ready(point.where), long=tidy(d), short=short)


@_concluded.register(TransmissionAngle)
def _transmission(q: TransmissionAngle, told: _Told) -> None:
    script, links, loop, question = told.script, told.links, told.links.loop, told.question
    line, D = told.line, told.distance
    assert isinstance(told.answer.expression, Expr)
    if isinstance(loop, SliderCrank) and loop.fixed != loop.guide:
        script.say("linkage.right_angle", output=loop.guide)
        return
    mu = Symbol(fresh(told.context, "mu", "mu_t", "mu_1"))

    def seen(world: World) -> float:
        return transmission_in_numbers(links, None, world.draw, world.snapshot.q)

    introduce(script, Meaning(mu, Sentence("linkage.transmission_symbol"), seen, "rad"))
    if isinstance(loop, FourBar):
        bars = bars_of(links)
        b, c = tidy(bars.b), tidy(bars.c)
        right = add(power(b, _TWO), power(c, _TWO), negate(multiply(_TWO, b, c, Call("cos", mu))))
        args: dict[str, Argument] = {"coupler": bars.coupler, "output": bars.output}
        second = script.line(power(D, _TWO), right, why="linkage.other_side", args=args)
    else:
        rod = tidy(links.lengths[loop.rod])
        second = script.line(multiply(rod, Call("cos", mu)), D, why="linkage.height_again", args={"rod": loop.rod})
    name = _asked(told.context, question, 0, 1)
    event = question if question.event is not None else None

    def asked(world: World) -> float:
        if q.end:
            return extreme_in_numbers(links, world.draw, is_least=q.end == "least")
        return transmission_in_numbers(links, event, world.draw, world.snapshot.q)

    introduce(script, Meaning(name, Sentence("symbol.asked"), asked, "rad"))
    given: dict[str, Argument] = {"lines": (line, second)}
    why = f"linkage.{q.end}" if q.end else "linkage.solved"
    when = "start" if question.at_start else "never" if q.end or event is not None else "always"
    script.line(name, told.answer.expression, why=why, args=given, uses=(line, second), when=when)
