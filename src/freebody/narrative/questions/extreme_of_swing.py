"""The greatest or least value of what one mode of coupled coordinates swings: its mean, and the amplitude about it."""

from __future__ import annotations

from collections.abc import Callable

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.expression import Call, Symbol, multiply
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import asked_as, asked_entry, fresh, named
from freebody.narrative.lines.script import DerivationStage, Script
from freebody.narrative.principles.momentum import by_method, parts_of
from freebody.narrative.questions.course_by_law import sum_of
from freebody.narrative.questions.event_way import TIME
from freebody.questions.clock import Clock
from freebody.questions.extent import ExtremeOfMotion
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.study.answering.crosscheck import holds
from freebody.study.answering.modal_extremes import Swing, in_numbers, value_of
from freebody.study.answering.repeated import held_throughout
from freebody.symbolic.coupled import CoupledMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def tell_swing(
    context: Context, question: Question, q: ExtremeOfMotion, swing: Swing, method: Method
) -> list[DerivationStage]:
    """The equations of the coupled coordinates, the mode that is in the quantity, its law in the time, its bounds."""
    refuse(method, ("newton", "lagrange"), Message("what is greatest over a motion"))
    setup, model = context.setup, context.setup.model
    f, script = model.field, context.script()
    of = q.of.with_sign if swing.is_size else q.of  # the size of what swings is told by what swings
    parts, unknowns = parts_of(context, of)
    moved = [c for c in model.coordinates if {c.index, c.speed} & f.ingredients(f.element(_value(context, q)))]
    coupled = setup.motion.coupled(moved[0])
    if coupled is None or (swing.is_size and (of is q.of or q.side < 0)):
        raise CannotAnswer(
            Message("the greatest speed of what swings with others is not derived; ask for the greatest velocity")
        )
    accelerations = [model.accelerations[model.coordinates.index(c)] for c in coupled.coordinates]
    found = by_method(context, script, [*unknowns, *(a for a in accelerations if a not in unknowns)], method)
    with script.stage("steady.motion", "steady.mode_hint"):
        symbol = Symbol(fresh(context, "y", "y_motion"))
        what = Sentence("steady.followed_all", {"name": Symbol(moved[0].name)})
        named(context, script, Meaning(symbol, what, of))
        general = f.lowest_terms(f.follow(parts[0], {u: found[u][0] for u in unknowns}))
        uses = tuple(found[u][1] for u in unknowns)
        first = script.line(symbol, tidy(general), why="steady.quantity", args={"lines": uses}, uses=uses)
        by = tuple(found[a][1] for a in accelerations)
        law = _law(context, question, script, swing, _Told(symbol, general, first, by, coupled))
    with script.stage("stage.value"):
        conditions = list(held_throughout(setup))
        value = value_of(setup, swing, q.side, conditions)

        def read(world: World) -> float:
            if not all(holds(setup, c, world.draw, world.draw.start()) for c in conditions):
                raise SaysNothing(Message("the motion is another one there"))
            return in_numbers(setup, world.draw, q.of, swing)[q.side > 0]

        name = asked_as(context, question, read)
        script.add(asked_entry(name, question))
        args: dict[str, Argument] = {"line": law}
        why = "steady.mean_and_amplitude" if q.side > 0 else "steady.mean_less_amplitude"
        why = "steady.size_and_amplitude" if swing.is_size else why
        script.line(name, tidy(value), why=why, args=args, uses=(law,), when="never")
    return script.stages


class _Told:
    """What has been told of a quantity: its symbol, its formula, the lines of both and of the accelerations."""

    def __init__(self, symbol: Symbol, value: Ratio, line: int, by: tuple[int, ...], coupled: CoupledMotion) -> None:
        self.symbol, self.value, self.line, self.by, self.coupled = symbol, value, line, by, coupled


def _value(context: Context, q: ExtremeOfMotion) -> Ratio:
    model = context.setup.model
    return model.in_independent_speeds(model.field.element(q.of.value(context.system, context.setup.state)))


def _law(context: Context, question: Question, script: Script, swing: Swing, told: _Told) -> int:
    """y'' = w^2 (m - y), where every motion has that, or the one mode with which it starts; its law in the time."""
    setup, wave = context.setup, swing.wave
    f = wave.square.field
    w = f.sqrt(wave.square, setup.model.samples.is_negative)
    args: dict[str, Argument] = {"line": told.line, "lines": told.by, "square": tidy(wave.square)}
    if _is_harmonic(setup.motion.acceleration, swing, told):
        right = multiply(tidy(wave.square), sum_of(wave.mean, (-f.one, told.symbol)))
        args |= {"second": rates_of(told.symbol.name, 2), "right": right}
        script.say("steady.harmonic_sum", **args)
    else:
        script.say("steady.one_mode", names=tuple(Symbol(c.name) for c in told.coupled.coordinates), **args)
    context.glossary.at_event(Clock(tidy(f.one / w), question.text))
    angle = multiply(tidy(w), TIME)
    right = sum_of(
        wave.mean,
        (wave.cosine, Call("cos", angle)),
        (f.lowest_terms(wave.sine / w), Call("sin", angle)),
    )
    uses = (told.line, *told.by)
    return script.line(told.symbol, right, why="steady.swings_as_it_starts", uses=uses, when="event")


def _is_harmonic(acceleration: Callable[[Coordinate], Ratio], swing: Swing, told: _Told) -> bool:
    """Whether y'' = w^2 (m - y) in every motion: with u' = a put into both derivatives."""
    f, wave = told.value.field, swing.wave
    x = told.value
    for _order in range(2):
        rate = f.zero
        for c in told.coupled.coordinates:
            rate = rate + f.derivative(x, c.index) * f.variable(c.speed)
            rate = rate + f.derivative(x, c.speed) * acceleration(c)
        x = f.lowest_terms(rate)
    return f.lowest_terms(x + wave.square * (told.value - wave.mean)).is_zero()
