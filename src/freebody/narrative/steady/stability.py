"""Whether small disturbances grow: Euler's equations beside a spin, and the linearised equations of a steady motion."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, add, free_symbols, multiply, number, power
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Glossary, Meaning, TrueWhen, World
from freebody.narrative.lines.naming import asked_as, asked_entry, fresh, named
from freebody.narrative.lines.script import DerivationStage, Legend, Script
from freebody.narrative.principles.motion_equations import motion_equations
from freebody.narrative.steady.polynomial import tell_polynomial
from freebody.narrative.steady.steady_motion import tell_what_runs
from freebody.numeric.jets import Array
from freebody.questions.reading import Question
from freebody.questions.steady import SpinStability
from freebody.study.answering.answer import Answer
from freebody.study.answering.draws import Draw
from freebody.study.steady.linear import Linear, linear_at_start
from freebody.study.steady.linearised import About
from freebody.study.steady.motion import SteadyMotion
from freebody.study.steady.spin import slopes_beside
from freebody.study.steady.stability import is_even
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

_ROUND_OFF = 1e-5  # of exponents by differences
_SPIN = 3.7  # rad/s, at which lines are looked at
_PRODUCTS: dict[frozenset[int], int] = {frozenset((0, 1)): 3, frozenset((0, 2)): 4, frozenset((1, 2)): 5}


def tell_spin(context: Context, question: Question, answer: Answer, q: SpinStability) -> list[DerivationStage]:
    """Euler's equations with small components beside a spin."""
    expression = answer.expression
    assert expression is not None
    assert not isinstance(expression, tuple)
    model = context.setup.model
    k = "xyz".index(q.axis)
    i, j = (k + 1) % 3, (k + 2) % 3
    tensor = model.dynamics.inertias[q.body][3:]
    if not tensor[_PRODUCTS[frozenset((i, j))]].is_zero():
        raise CannotAnswer(
            Message("the axes across the spin are no principal axes; the answer is that of the general equations")
        )
    script = context.script()
    spin = next(s for s in sorted(free_symbols(expression)) if s not in context.system.parameters)
    with script.stage("steady.euler", "steady.euler_hint"):
        line, exponent = _euler(context, script, q, (i, j, k), tensor, Symbol(spin))
    with script.stage("stage.value"):
        symbol = asked_as(context, question, context.glossary.meanings[exponent.name].read)  # pyrefly: ignore[bad-argument-type]
        script.add(asked_entry(symbol, question, "1/s^2"))
        args: dict[str, Argument] = {"line": line}
        script.line(symbol, expression, why="steady.solved_for", args=args, uses=(line,), when="never")
        script.say("steady.stable")
    return script.stages


def _euler(
    context: Context,
    script: Script,
    q: SpinStability,
    axes: tuple[int, int, int],
    tensor: tuple[Ratio, ...],
    spin: Symbol,
) -> tuple[int, Symbol]:
    """Both linearised equations, and the exponent that solves them; the line of the latter and its symbol."""
    i, j, k = axes
    u, w = (Symbol(fresh(context, f"u_{'xyz'[n]}", f"u_{'xyz'[n]}_1")) for n in (i, j))
    body = q.body
    slopes = _Slopes(context, body, k)
    meanings = [
        Meaning(spin, Sentence("steady.spin_symbol"), lambda _world: _SPIN, "rad/s"),
        Meaning(u, Sentence("steady.across", {"axis": f"{body}.{'xyz'[i]}"}), lambda _world: 1.0, "rad/s"),
        Meaning(w, Sentence("steady.across", {"axis": f"{body}.{'xyz'[j]}"}), lambda _world: 0.6, "rad/s"),
        Meaning(Call("rate", u), Sentence("steady.across_rate"), slopes.rate(0), "rad/s^2"),
        Meaning(Call("rate", w), Sentence("steady.across_rate"), slopes.rate(1), "rad/s^2"),
    ]
    named(context, script, *meanings)
    a, b, c = tensor[i], tensor[j], tensor[k]
    f = a.field
    args: dict[str, Argument] = {"spin": spin, "axis": f"{body}.{'xyz'[k]}", "first": u, "second": w}
    script.say("steady.small", **args)
    first = _line(script, tidy(a), Call("rate", u), tidy(f.lowest_terms(c - b)), spin, w)
    second = _line(script, tidy(b), Call("rate", w), tidy(f.lowest_terms(a - c)), spin, u)
    square = Symbol(fresh(context, "Lambda", "Lambda_exponent"))
    named(context, script, Meaning(square, Sentence("steady.exponent_symbol"), slopes.square, "1/s^2"))
    given: dict[str, Argument] = {"lines": (first, second)}
    right = multiply(tidy(f.lowest_terms((c - b) * (a - c))), power(spin, number(2)))
    line = script.line(
        multiply(tidy(f.lowest_terms(a * b)), square),
        right,
        why="steady.exponent",
        args=given,
        uses=(first, second),
        when="never",
    )
    return line, square


def _line(script: Script, inertia: Expr, rate: Expr, difference: Expr, spin: Symbol, other: Symbol) -> int:
    left = add(multiply(inertia, rate), multiply(difference, spin, other))
    return script.line(left, number(0), when="never")


class _Slopes:
    """How the small components change in the full system, by finite differences."""

    def __init__(self, context: Context, body: str, k: int) -> None:
        self.body, self.k = body, k
        self._known: dict[int, tuple[Draw, Array]] = {}

    def of(self, draw: Draw) -> Array:
        if id(draw) not in self._known:
            self._known[id(draw)] = draw, slopes_beside(draw, self.body, self.k, _SPIN)
        return self._known[id(draw)][1]

    def rate(self, n: int) -> Callable[[World], float]:
        return lambda world: float(self.of(world.draw)[n][0] * 1.0 + self.of(world.draw)[n][1] * 0.6)

    def square(self, world: World) -> float:
        """lambda^2 = -det of the slopes, whose trace vanishes."""
        s = self.of(world.draw)
        return float(s[0][1] * s[1][0] - s[0][0] * s[1][1])


# -- a steady motion --------------------------------------------------------------------------
class Beside(Glossary):
    """At the "event" symbols have their values in the steady motion of the start."""

    def __init__(self, context: Context, linear: Linear) -> None:
        super().__init__(context.setup)
        self.meanings.update(context.glossary.meanings)
        self.linear = linear
        self._found: list[tuple[World, list[complex]]] = []  # and the exponents there

    def worlds(self, when: TrueWhen) -> Iterator[World]:
        if when != "event":
            yield from super().worlds(when)
            return
        for world, _exponents in self.found():
            yield world

    def found(self) -> list[tuple[World, list[complex]]]:
        """Motions, and the exponents of the full system linearised there in numbers."""
        for draw in () if self._found else self.setup.draws:
            with suppress(CannotAnswer):
                about = About(self.setup, self.linear, draw, 1.0)
                exponents = [complex(x) for x in np.linalg.eigvals(about.matrix())]
                self._found.append((World(self, draw, draw.seen(about.snapshot)), exponents))
        return self._found

    def nearest(self, value: Expr, of: Callable[[complex], complex]) -> Callable[[World], float]:
        """What a function gives of the exponents of the full system, nearest to a claimed value; it must be real."""

        def read(world: World) -> float:
            exponents = next(found for own, found in self.found() if own is world)
            values = [of(x) for x in exponents]
            (claimed,) = world.of(value)
            best = min(values, key=lambda s: abs(s - claimed))
            largest = max(map(abs, values))
            # by differences, so to fewer digits than a line is held to
            return claimed if abs(best - claimed) < _ROUND_OFF * max(abs(claimed), largest) else best.real

        return read

    def routh(self, k: int, n: int) -> Callable[[World], float]:
        """The k-th of the n numbers of the first column, from the exponents of the full system that are not zero."""

        def read(world: World) -> float:
            exponents = next(found for own, found in self.found() if own is world)
            return _first_column(sorted(exponents, key=abs)[-n:])[k]

        return read


def tell_stability(context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    """The equations of motion, the steady motion, and the squares of the exponents of small disturbances."""
    expression = answer.expression
    assert expression is not None
    linear = linear_at_start(context.setup, SteadyMotion.asked(context.setup.model, question.event))
    if answer.unit == "":
        return _by_routh(context, linear, expression)
    stages, more, glossary, lines = disturbances(context, linear)
    values = expression if isinstance(expression, tuple) else (expression,)
    with more.stage("stage.value"):
        own = ["Lambda"] if len(values) == 1 else [f"Lambda_{k + 1}" for k in range(len(values))]
        names = [Symbol(fresh(context, name, f"{name}_exponent")) for name in own]
        meanings = [
            Meaning(name, Sentence("steady.exponent_symbol"), glossary.nearest(value, _square), "1/s^2")
            for name, value in zip(names, values, strict=True)
        ]
        for meaning in meanings:
            glossary.redefine(meaning)
        more.add(Legend(tuple((m.symbol, m.what, m.unit) for m in meanings)))
        left: Expr | tuple[Expr, ...] = tuple(names) if isinstance(expression, tuple) else names[0]
        args: dict[str, Argument] = {"lines": lines}
        more.line(left, expression, why="steady.roots_of", args=args, uses=lines, when="event")
        more.say("steady.stable")
    return [*stages, *more.stages]


def _by_routh(context: Context, linear: Linear, expression: Expr | tuple[Expr, ...]) -> list[DerivationStage]:
    """The polynomial, and the first column of its array."""
    if len(linear.factors) > 1 or is_even(linear.factors[0]):
        raise CannotAnswer(Message("the characteristic polynomial falls apart, and its parts are not told one by one"))
    stages, more, glossary, lines = disturbances(context, linear)
    values = expression if isinstance(expression, tuple) else (expression,)
    with more.stage("stage.value"):
        names = [Symbol(fresh(context, f"r{k + 1}", f"routh{k + 1}")) for k in range(len(values))]
        for k, name in enumerate(names):
            glossary.redefine(Meaning(name, Sentence("steady.routh_symbol"), glossary.routh(k, len(values)), ""))
        more.add(Legend(tuple((name, Sentence("steady.routh_symbol"), "") for name in names)))
        left: Expr | tuple[Expr, ...] = tuple(names) if isinstance(expression, tuple) else names[0]
        more.line(left, expression, why="steady.routh", args={"lines": lines}, uses=lines, when="event")
        more.say("steady.routh_stable")
    return [*stages, *more.stages]


def _first_column(exponents: Sequence[complex]) -> list[float]:
    """Of Routh's array, below the one at its head, of the polynomial with these roots."""
    c = np.poly(np.array(exponents)).real
    above, row = [float(x) for x in c[0::2]], [float(x) for x in c[1::2]]
    column: list[float] = []
    while row:
        column.append(row[0])
        after = [*row[1:], 0.0]
        above, row = row, [x - above[0] * y / row[0] for x, y in zip(above[1:], after, strict=False)]
    return column


def _square(x: complex) -> complex:
    return x * x


def disturbances(context: Context, linear: Linear) -> tuple[list[DerivationStage], Script, Beside, tuple[int, ...]]:
    """The equations of motion, the steady motion and the polynomial of the exponents: stages, the script that goes on
    after them with its glossary, and the numbers of the equations."""
    script, steady = context.script(), linear.steady
    with script.stage("unclosed.equations", "unclosed.equations_hint"):
        lines = tuple(row.number for row in motion_equations(context, script))
    glossary = Beside(context, linear)
    more = Script(glossary, script.next_number)
    with more.stage("steady.linear", "steady.linear_hint"):
        tell_what_runs(more, steady)
        shown = {**linear.rates, **{index: linear.place[index] for index in sorted(linear.moved)}}
        for index, x in shown.items():
            if not x.is_zero():
                name = steady.model.field.generators[index].display
                more.line(name, tidy(x), why="steady.needs", args={"lines": lines}, uses=lines, when="event")
        more.say("steady.linearised")
        tell_polynomial(more, linear.coefficients)
    return script.stages, more, glossary, lines
