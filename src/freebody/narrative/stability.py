"""Whether small disturbances grow: Euler's equations beside a spin, and the linearised equations of a steady motion."""

from __future__ import annotations

from collections.abc import Callable

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, add, multiply, number
from freebody.model.question import Question
from freebody.model.spins import body_axes
from freebody.model.steady_questions import SpinStability
from freebody.narrative.context import Context
from freebody.narrative.glossary import Meaning, World
from freebody.narrative.motion_equations import balanced, motion_equations, readable
from freebody.narrative.naming import asked_as, asked_entry, fresh, named
from freebody.narrative.script import Argument, Script, Sentence, Stage
from freebody.study.answer import Answer
from freebody.study.draws import Draw
from freebody.study.steady.spin import slopes_beside
from freebody.study.steady.stability import Linear, linear_at_start
from freebody.study.steady.motion import Steady
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy

_SPIN = 3.7  # rad/s, at which lines are looked at
_PRODUCTS = {frozenset((0, 1)): 3, frozenset((0, 2)): 4, frozenset((1, 2)): 5}


def tell_spin(context: Context, question: Question, answer: Answer, q: SpinStability) -> list[Stage]:
    """Euler's equations with small components beside a spin."""
    expression = answer.expression
    assert expression is not None
    assert not isinstance(expression, tuple)
    model = context.setup.model
    k = "xyz".index(q.axis)
    i, j = (k + 1) % 3, (k + 2) % 3
    tensor = model.inertias[q.body][3:]
    if not tensor[_PRODUCTS[frozenset((i, j))]].is_zero():
        raise CannotAnswer("the axes across the spin are no principal axes; the answer is that of the general equations")
    script = context.script()
    spin = next(s for s in _names_in(expression) if s not in context.system.parameters)
    with script.stage("steady.euler", "steady.euler_hint"):
        line, exponent = _euler(context, script, q, (i, j, k), tensor, Symbol(spin))
    with script.stage("stage.value"):
        symbol = asked_as(context, question, context.glossary.meanings[exponent.name].read)  # type: ignore[arg-type]
        script.add(asked_entry(symbol, question, "1/s^2"))
        args: dict[str, Argument] = {"line": line}
        script.line(symbol, expression, why="steady.solved_for", args=args, uses=(line,), when="never")
        script.say("steady.stable")
    return script.stages


def _names_in(e: Expr) -> list[str]:
    from freebody.language.expression import free_symbols

    return sorted(free_symbols(e))


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
    square = Symbol(fresh(context, "lambda_2", "exponent_2"))
    named(context, script, Meaning(square, Sentence("steady.exponent_symbol"), slopes.square, "1/s^2"))
    given: dict[str, Argument] = {"lines": (first, second)}
    right = multiply(tidy(f.lowest_terms((c - b) * (a - c))), spin, spin)
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
        self._known: dict[int, tuple[Draw, object]] = {}

    def of(self, draw: Draw):  # noqa: ANN201
        if id(draw) not in self._known:
            self._known[id(draw)] = draw, slopes_beside(draw, self.body, self.k, _SPIN)
        return self._known[id(draw)][1]

    def rate(self, n: int) -> Callable[[World], float]:
        return lambda world: float(self.of(world.draw)[n][0] * 1.0 + self.of(world.draw)[n][1] * 0.6)

    def square(self, world: World) -> float:
        """lambda^2 = -det of the slopes, whose trace vanishes."""
        s = self.of(world.draw)
        return float(s[0][1] * s[1][0] - s[0][0] * s[1][1])


def tell_stability(context: Context, question: Question, answer: Answer) -> list[Stage]:
    """The linearised equations about the steady motion of the start, and their characteristic polynomial."""
    expression = answer.expression
    assert expression is not None
    script = context.script()
    steady = Steady(context.setup.model)
    linear = linear_at_start(context.setup, steady)
    lines: list[int] = []
    with script.stage("unclosed.equations", "unclosed.equations_hint"):
        lines += [row.number for row in motion_equations(context, script)]
    with script.stage("steady.condition", "steady.condition_hint"):
        cyclic, others = (tuple(Symbol(c.name) for c in group) for group in (steady.cyclic, steady.others))
        if cyclic:
            script.say("steady.cyclic", names=cyclic)
        script.say("steady.others", names=others)
    raise CannotAnswer(_not_told(linear))


def _not_told(linear: Linear) -> str:
    for c in linear.coefficients:
        readable(c)
    return "the stability of this steady motion is decided by Routh's criterion in numbers and formulas, but not told"


__all__ = ["body_axes", "balanced", "tell_spin", "tell_stability"]
