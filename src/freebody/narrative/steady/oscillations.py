"""Frequencies of small oscillations about a steady motion: exponents ±i ω of the linearised equations."""

from __future__ import annotations

import math
from collections.abc import Sequence

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol, add, divide, multiply, number, power
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning
from freebody.narrative.lines.naming import fresh, named
from freebody.narrative.lines.script import DerivationStage, Script
from freebody.narrative.principles.sides import balanced, readable
from freebody.narrative.steady.stability import Beside, disturbances
from freebody.questions.reading import Question
from freebody.questions.steady import SteadyOscillations
from freebody.study.answering.answer import Answer
from freebody.study.steady.linear import linear_at_start
from freebody.study.steady.motion import SteadyMotion
from freebody.study.steady.oscillations import frequencies_of, meant, squared_with_damping
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

_PI = Symbol("pi")


def tell_oscillations(
    context: Context, question: Question, answer: Answer, q: SteadyOscillations
) -> list[DerivationStage]:
    """The equations of motion, the steady motion, the polynomial of the exponents, and its roots ±i ω."""
    expression = answer.expression
    if expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    linear = linear_at_start(context.setup, SteadyMotion.asked(context.setup.model, question.event))
    stages, script, glossary, _lines = disturbances(context, linear)
    values = expression if isinstance(expression, tuple) else (expression,)
    bases = meant(linear, q)
    frequencies, _positive = frequencies_of(linear, bases)
    with script.stage("stage.value"):
        names = _named(context, script, glossary, frequencies)
        lines: list[int] = []
        for base in bases:
            own, _needed = frequencies_of(linear, [base], may_be_none=True)
            if own:
                c = base.coefficients(linear.steady.model.field.index(linear.exponent))
                lines.append(_equation(script, names[frequencies.index(own[0])], c))
        args: dict[str, Argument] = {"lines": tuple(lines)}
        if q.what == "period":
            (omega,) = names
            period = Symbol(fresh(context, "T", "T_n", "period"))
            reader = glossary.nearest(values[0], lambda x: complex(math.tau / x.imag) if x.imag else complex(math.inf))
            named(context, script, Meaning(period, Sentence("symbol.asked"), reader, "s"))
            sides = (period, divide(multiply(number(2), _PI), omega), values[0])
            script.line(*sides, why="steady.solved", args=args, uses=lines, when="event")
            return [*stages, *script.stages]
        left: Expr | tuple[Expr, ...] = names[0] if len(names) == 1 else tuple(names)
        script.line(left, expression, why="steady.solved", args=args, uses=lines, when="event")
    return [*stages, *script.stages]


def _named(context: Context, script: Script, glossary: Beside, frequencies: Sequence[Ratio]) -> list[Symbol]:
    """Symbols of the frequencies, in their order."""
    several = len(frequencies) > 1
    names = [
        Symbol(fresh(context, f"omega_{k}", f"omega_n{k}") if several else fresh(context, "omega", "omega_n"))
        for k in range(1, len(frequencies) + 1)
    ]
    what = Sentence("steady.frequency_symbol")
    meanings = [
        Meaning(name, what, glossary.nearest(tidy(w), lambda x: complex(x.imag)), "rad/s")
        for name, w in zip(names, frequencies, strict=True)
    ]
    for meaning in meanings:
        glossary.redefine(meaning)
    named(context, script, *meanings)
    return names


def _equation(script: Script, omega: Symbol, c: Sequence[Ratio]) -> int:
    """What a factor of the polynomial becomes with λ = i ω; c: its coefficients, from the constant term up."""
    squared = power(omega, number(2))
    if any(not x.is_zero() for x in c[1::2]):
        right = tidy(readable(squared_with_damping(c)))
        return script.line(squared, right, why="steady.with_damping", when="event")
    terms = [
        multiply(tidy(readable((-1) ** k * x)), power(omega, number(2 * k)) if k else number(1))
        for k, x in enumerate(c[::2])
    ]
    return script.line(*balanced(add(*terms)), why="steady.imaginary", when="event")
