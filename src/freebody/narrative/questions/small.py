"""What is asked of small motions, step by step: rest, frequencies, modes, damping, stability, forced oscillations.

    free        (K - w^2 M) v = 0
    damped      M x'' + C x' + K x = 0:    zeta = C/(2 sqrt(K M)),  w_d^2 = K/M - (C/2M)^2,  delta = pi C/(M w_d)
    disturbed   x = a e^(lambda t):        lambda^2 = -w^2
    forced      (K - W^2 M + i W C) X = f_c - i f_s

Sources: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, ch. 6; Rao, Mechanical Vibrations, 5th ed. 2011,
ch. 2 and 3.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial, singledispatch

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.expression import Call, Expr, Symbol, add, divide, multiply, number, power, substitute
from freebody.language.sentences import Argument, Message, Sentence
from freebody.measures.base import Measure
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import asked_as, asked_entry, asked_symbol, fresh, named, names_of, side_of
from freebody.narrative.lines.script import DerivationStage
from freebody.narrative.questions.small_telling import SmallTelling
from freebody.narrative.questions.wanted import answer_holds
from freebody.questions.amplitude_ratio import AmplitudeRatio
from freebody.questions.base import Quantity
from freebody.questions.forced_motion import Forced, SteadyAmplitude
from freebody.questions.node_of_mode import NodeOfMode
from freebody.questions.reading import Question
from freebody.questions.small_motion import (
    Damping,
    Equilibrium,
    EquilibriumStability,
    ModeShapes,
    RestValue,
    SmallOscillations,
)
from freebody.study.answering.answer import Answer
from freebody.study.small_motion.forced import forced_number
from freebody.symbolic.forced import forced_oscillation
from freebody.symbolic.linearised import swing_of
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import place_of_mode
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy

Shown = Expr | tuple[Expr, ...]


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """Equations of motion, the equilibrium, what is linear beside it, and what is asked of it. Raises CannotAnswer
    where the solver has no formula."""
    refuse(method, ("newton", "lagrange"), Message("small motion"))
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    if context.system.states and question.quantity.is_verdict:
        from freebody.narrative.steady.stability import tell_stability

        return tell_stability(context, question, answer)  # what a controller adds up has a rate as well
    telling = SmallTelling(context, question, answer, method)
    try:
        telling.equations()
    except FormulaTooLong:
        if not telling.may_be_told_by_principles:
            raise
        telling.principles()
    telling.equilibrium()
    _tell(question.quantity, telling)
    return telling.script.stages


@singledispatch
def _tell(q: Quantity, telling: SmallTelling) -> None:
    """By the kind of question."""
    raise CannotAnswer(Message("this is no question about small motion"))


def _expression(telling: SmallTelling) -> Shown:
    found = telling.answer.expression
    assert found is not None
    return found


@_tell.register(Equilibrium)
def _place(q: Equilibrium, telling: SmallTelling) -> None:
    """What was asked of the equilibrium."""
    script = telling.script
    c = next((c for c in telling.model.coordinates if telling.model.measure_of(c) == q.measure), None)
    if c is not None:
        k = telling.model.coordinates.index(c)
        if tidy(telling.values[c.index]) == telling.answer.expression:
            asked_as(telling.context, telling.question, telling.readers.value(k))
            return
    with script.stage("stage.value"):
        value = telling.model.value_of(q.measure)
        shown = substitute(tidy(value), telling.at_rest)
        measure = q.measure

        def read(world: World) -> float:
            pose = telling.readers.pose(world.draw)
            return world.draw.reference.snapshot(pose, 0 * pose).value(measure)

        symbol = asked_as(telling.context, telling.question, read)
        script.add(asked_entry(symbol, telling.question))
        lines = tuple(telling.places)
        expression = _expression(telling)
        script.line(symbol, shown, expression, why="value.follows", args={"lines": lines}, uses=lines, when="never")


@_tell.register(RestValue)
def _value_at_rest(q: RestValue, telling: SmallTelling) -> None:
    """What was asked, where everything rests."""
    script, model = telling.script, telling.model
    still = SymbolicState(model, {c.speed: model.field.zero for c in (*model.coordinates, *model.dependent)})
    value = q.of.value(telling.context.system, still)
    if isinstance(value, tuple):
        raise CannotAnswer(Message("the derivation has one quantity: ask for a component"))

    def read(world: World) -> float:
        pose = telling.readers.pose(world.draw)
        there = world.draw.seen(world.draw.reference.snapshot(pose, 0 * pose))
        return float(q.of.value(telling.context.system, there))

    with script.stage("stage.value"):
        symbol = asked_as(telling.context, telling.question, read)
        script.add(asked_entry(symbol, telling.question))
        lines = tuple(telling.places)
        shown, expression = substitute(tidy(value), telling.at_rest), _expression(telling)
        script.line(symbol, shown, expression, why="value.follows", args={"lines": lines}, uses=lines, when="never")


@_tell.register(SmallOscillations)
def _frequencies(q: SmallOscillations, telling: SmallTelling) -> None:
    """Frequency, frequencies or period from their squares."""
    symbols, roots = telling.beside()
    script = telling.script
    expression = _expression(telling)
    swinging = telling.free.swinging
    if q.measure is not None:
        swinging = telling.free.swinging_with(telling.free.slopes(q.measure))
    k = next(iter(swinging), 0)
    if q.number is not None:
        k = place_of_mode(len(telling.free.squares), q.number)
    if q.what != "frequencies":  # the one that is not zero
        symbols, roots = [symbols[k]], roots if len(roots) == 1 else (roots[k],)
    args: dict[str, Argument] = {"lines": roots}
    with script.stage("stage.value"):
        if q.what == "period":
            omega = telling.readers.frequency(k)

            def period(world: World) -> float:
                return 2 * math.pi / omega(world)

            symbol = asked_as(telling.context, telling.question, period)
            script.add(asked_entry(symbol, telling.question, "s"))
            turn = 2 * Symbol("pi") / symbols[0]
            script.line(symbol, turn, expression, why="small.period", args=args, uses=roots, when="never")
            return
        left: Expr | tuple[Expr, ...] = symbols[0] if len(symbols) == 1 else tuple(symbols)
        if isinstance(expression, tuple) != isinstance(left, tuple):
            raise CannotAnswer(Message("the solver shows another number of frequencies"))
        script.line(left, expression, why="small.take_root", args=args, uses=roots, when="never")


@_tell.register(ModeShapes)
def _shapes(q: ModeShapes, telling: SmallTelling) -> None:
    """The ratios of the parts of each mode."""
    if len(telling.model.coordinates) == 1:
        raise CannotAnswer(Message("one coordinate has no mode shape: it swings as it is"))
    symbols, roots = telling.beside()
    script, n = telling.script, len(telling.model.coordinates)
    parts = _expression(telling)
    assert isinstance(parts, tuple)
    wanted = range(len(symbols)) if q.number is None else (q.number - 1,)
    with script.stage("small.shape", "small.shape_hint"):
        script.say("small.ratios")
        for row, k in enumerate(wanted):
            names = [Symbol(fresh(telling.context, f"v_{j + 1}{k + 1}")) for j in range(n)]
            what = Sentence("small.part", {"k": k + 1})
            named(telling.context, script, *(Meaning(v, what, telling.readers.part(k, j)) for j, v in enumerate(names)))
            uses = (roots[k],)
            args: dict[str, Argument] = {"k": k + 1, "line": roots[k]}
            shown = parts[row * n : (row + 1) * n]
            script.line(tuple(names), shown, why="small.shape_is", args=args, uses=uses, when="never")


@_tell.register(AmplitudeRatio)
def _amplitudes(q: AmplitudeRatio, telling: SmallTelling) -> None:
    """The ratio of two parts of one mode."""
    places = [c.name for c in telling.model.coordinates]
    if not {q.top, q.bottom} <= {*places}:
        raise CannotAnswer(Message("only of coordinates the ratio in a mode is derived here"))
    _symbols, roots = telling.beside()
    k, script = q.number - 1, telling.script
    top, bottom = (telling.readers.part(k, places.index(name)) for name in (q.top, q.bottom))
    ratio = Symbol(fresh(telling.context, f"r_{q.number}"))
    what = Sentence("small.amplitudes", {"k": q.number, "top": Symbol(q.top), "bottom": Symbol(q.bottom)})
    with script.stage("small.shape", "small.shape_hint"):
        script.say("small.ratios")
        named(telling.context, script, Meaning(ratio, what, lambda world: top(world) / bottom(world)))
        args: dict[str, Argument] = {"k": q.number, "line": roots[k]}
        shown = _expression(telling)
        script.line(ratio, shown, why="small.shape_is", args=args, uses=(roots[k],), when="never")


@_tell.register(NodeOfMode)
def _node(q: NodeOfMode, telling: SmallTelling) -> None:
    """The parts of the mode, how the body moves in it, and the point that it turns about."""
    symbols, roots = telling.beside()
    script, context, readers, k = telling.script, telling.context, telling.readers, q.number - 1
    short, args = telling.field.lowest_terms, dict[str, Argument](k=q.number, line=roots[k])
    parts = [Symbol(fresh(context, f"v_{j + 1}{q.number}")) for j in range(len(symbols))]
    with script.stage("small.shape", "small.shape_hint"):
        script.say("small.ratios")
        what = Sentence("small.part", {"k": q.number})
        named(context, script, *(Meaning(v, what, readers.part(k, j)) for j, v in enumerate(parts)))
        shape = tuple(tidy(short(x)) for x in telling.free.parts(k))
        line = script.line(tuple(parts), shape, why="small.shape_is", args=args, uses=(roots[k],), when="never")
    motion = q.motion(context.system)
    moved = [readers.amplitude(k, measure) for measure in motion]
    names = [Symbol(fresh(context, f"{letter}_{q.number}", f"{letter}_m{q.number}")) for letter in ("u", "w", "psi")]
    with script.stage("small.node", "small.node_hint"):
        about: dict[str, Argument] = {"k": q.number, "body": q.body, "point": q.point.name, "line": line}
        keys = ("small.node_right", "small.node_up", "small.node_turn")
        named(
            context,
            script,
            *(Meaning(x, Sentence(key, about), r) for x, key, r in zip(names, keys, moved, strict=True)),
        )
        slopes = [telling.free.slopes(measure) for measure in motion]
        sums = tuple(add(*(multiply(tidy(short(c)), v) for c, v in zip(row, parts, strict=True))) for row in slopes)
        last = script.line(tuple(names), sums, why="small.node_moves", args=about, uses=(line,), when="never")
        _asked_of_node(telling, q, names, moved, last)


def _asked_of_node(
    telling: SmallTelling,
    q: NodeOfMode,
    names: Sequence[Symbol],
    moved: Sequence[Callable[[World], float]],
    last: int,
) -> None:
    """The node as it is asked for, from how the body moves: to the right, up, and by turning."""
    script, context, question = telling.script, telling.context, telling.question
    right, up, turn = names
    sides: list[Expr] = [multiply(number(-1), divide(up, turn)), divide(right, turn)]
    if q.is_distance:
        sides = [divide(_root(add(power(right, number(2)), power(up, number(2)))), Call("abs", turn))]

    def read(world: World, k: int) -> float:
        x, y, angle = (reader(world) for reader in moved)
        return math.hypot(x, y) / abs(angle) if q.is_distance else (-y, x)[k] / angle

    n = len(sides)
    symbol = asked_symbol(context, question, n)
    for k, name in enumerate(names_of(symbol, n) if n > 1 else (symbol,)):
        what = context.glossary.meanings[name.name].what
        script.glossary.redefine(Meaning(name, what, partial(read, k=k), "m"))
    script.add(asked_entry(symbol, question, "m", n))
    args: dict[str, Argument] = {"line": last}
    shown = sides[0] if n == 1 else tuple(sides)
    left, found = side_of(symbol, n), _expression(telling)
    script.glossary = script.glossary.where(lambda world: answer_holds(world, telling.answer))
    script.line(left, shown, found, why="small.node_is", args=args, uses=(last,), when="never")


@_tell.register(Damping)
def _damping(q: Damping, telling: SmallTelling) -> None:
    """How one coordinate dies away; of several, each mode by itself."""
    script, what = telling.script, q.what.removesuffix("s") if q.what != "frequencies" else "frequency"
    lines = telling.matrices(with_damping=True)
    n = len(telling.model.coordinates)
    expression = _expression(telling)
    with script.stage("small.damping", "small.damping_hint"):
        if n > 1:
            script.say("small.proportional")
            asked = expression if isinstance(expression, tuple) else (expression,)
            names = [Symbol(fresh(telling.context, f"d_{k + 1}")) for k in range(len(asked))]
            read = [telling.readers.damped(what, k) for k in range(len(asked))]
            meanings = [Meaning(x, Sentence(f"small.each_{what}"), r) for x, r in zip(names, read, strict=True)]
            named(telling.context, script, *meanings)
            left: Shown = names[0] if len(names) == 1 else tuple(names)
            script.line(left, expression, why="small.each", args={"lines": lines}, uses=lines, when="never")
            return
        M, C, K = (telling.entries(letter)[0][0] for letter in "MCK")
        script.say("small.dies_away")
        symbol = asked_as(telling.context, telling.question, telling.readers.damped(what, 0))
        script.add(asked_entry(symbol, telling.question, q.unit if q.unit != "1" else ""))
        swing = _root(add(divide(K, M), multiply(number(-1), power(divide(C, multiply(number(2), M)), number(2)))))
        told: dict[str, Expr] = {
            "ratio": divide(C, multiply(number(2), _root(multiply(K, M)))),
            "frequency": swing,
            "period": divide(multiply(number(2), Symbol("pi")), swing),
            "quality": divide(_root(multiply(K, M)), C),
            "decrement": divide(multiply(Symbol("pi"), C), multiply(M, swing)),
        }
        args: dict[str, Argument] = {"lines": lines}
        script.line(symbol, told[what], expression, why=f"small.damped_{what}", args=args, uses=lines, when="never")


def _root(x: Expr) -> Expr:
    return Call("sqrt", x)


@_tell.register(EquilibriumStability)
def _stability(q: EquilibriumStability, telling: SmallTelling) -> None:
    """The squares of the exponents."""
    squares = [s for s in telling.squares[::-1] if not s.is_zero()]
    expression = _expression(telling)
    asked = expression if isinstance(expression, tuple) else (expression,)
    if not squares and len(telling.model.coordinates) == 1:
        _stiffness_alone(telling)
        return
    if len(asked) != len(squares):
        raise CannotAnswer(Message("the solver shows another number of frequencies"))
    lines, script = telling.matrices(), telling.script
    with script.stage("small.stability", "small.stability_hint"):
        names = [Symbol(fresh(telling.context, f"Lambda_{k + 1}")) for k in range(len(asked))]
        meanings = [
            Meaning(x, Sentence("small.exponent"), telling.readers.exponent(k, len(asked)), "1/s²")
            for k, x in enumerate(names)
        ]
        named(telling.context, script, *meanings)
        script.say("small.disturbed")
        left: Shown = names[0] if len(names) == 1 else tuple(names)
        script.line(left, expression, why="small.exponents", args={"lines": lines}, uses=lines, when="never")
        script.say("small.stable_if")


@singledispatch
def _amplitude_of(q: Quantity) -> tuple[Measure, int] | None:
    """The measure whose amplitude is asked for, and the order of its derivative."""
    return None


@_amplitude_of.register(SteadyAmplitude)
def _(q: SteadyAmplitude) -> tuple[Measure, int] | None:
    return q.of.watched


@_tell.register(Forced)
def _forced(q: Forced, telling: SmallTelling) -> None:
    """The steady motion under harmonic loads."""
    script, context = telling.script, telling.context
    if swing_of(telling.model) is None:  # answered as of drives of small amplitude
        raise CannotAnswer(Message("of drives to which the forces are not proportional no derivation is written yet"))
    lines: tuple[int, ...] = telling.matrices(with_damping=True)
    forced = forced_oscillation(telling.model, telling.linear)
    w = tidy(forced.swing.frequency)
    n, expression = len(forced.force), _expression(telling)
    with script.stage("small.forced", "small.forced_hint"):
        forces: list[Symbol] = []
        for j, f in enumerate(forced.force):
            swings: tuple[tuple[str, Ratio, int], ...] = (("c", f.re, 0), ("s", -f.im, 1))
            for letter, value, phase in swings:
                if value.is_zero():
                    continue
                name = Symbol(fresh(context, f"f_{letter}" if n == 1 else f"f_{letter}{j + 1}"))
                named(
                    context, script, Meaning(name, Sentence(f"small.force_{letter}"), telling.readers.swing(j, phase))
                )
                lines += (script.line(name, tidy(value), why=f"small.force_{letter}_is", when="never"),)
                forces.append(name)
        script.say("small.complex" if n == 1 else "small.complex_many")
    with script.stage("stage.value"):
        setup, question = context.setup, telling.question

        def read(world: World) -> float:
            return forced_number(setup, question, world.draw)

        symbol = asked_as(context, question, read)
        script.add(asked_entry(symbol, question, "" if question.quantity.unit == "1" else question.quantity.unit))
        sides: list[Expr] = [symbol]
        c = telling.model.coordinates[0]
        if n == 1 and _amplitude_of(q) == (telling.model.measure_of(c), 0):
            M, C, K = (telling.entries(letter)[0][0] for letter in "MCK")
            stiff = add(K, multiply(number(-1), power(w, number(2)), M))
            below = add(power(stiff, number(2)), power(multiply(w, C), number(2)))
            size = Call("abs", forces[0]) if len(forces) == 1 else _root(add(*(power(x, number(2)) for x in forces)))
            sides.append(divide(size, _root(below)))
        args: dict[str, Argument] = {"lines": lines}
        assert not isinstance(expression, tuple)
        script.glossary = script.glossary.where(lambda world: answer_holds(world, telling.answer))
        why = f"small.forced_{q.kind.replace(' ', '_')}"
        script.line(*sides, expression, why=why, args=args, uses=lines, when="never")


def _stiffness_alone(telling: SmallTelling) -> None:
    """Of one coordinate whose rate moves no mass at first."""
    lines, script = telling.matrices(), telling.script
    with script.stage("small.stability", "small.stability_hint"):
        symbol = asked_as(telling.context, telling.question, telling.readers.stiffness(0, 0))
        script.add(asked_entry(symbol, telling.question, ""))
        left = telling.entries("K")[0][0]
        script.line(symbol, left, _expression(telling), why="small.stiffness_alone", uses=lines, when="never")
