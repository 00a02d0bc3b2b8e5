"""Small oscillations and equilibria: where the generalized forces vanish at rest, and what is linear beside it.

With q = q_e + x and F(q) the generalized forces at rest,

    F(q_e) = 0,    M x'' + K x = 0,    K = -dF/dq,    det(K - w^2 M) = 0.

Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, ch. 6.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import singledispatchmethod

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol, add, multiply, number, power, substitute
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import asked_as, asked_entry, fresh, named
from freebody.narrative.lines.script import Argument, DerivationStage, Script, Sentence
from freebody.narrative.principles.analytic import by_lagrange
from freebody.narrative.principles.elimination import EliminationRow
from freebody.narrative.principles.motion_equations import motion_equations
from freebody.narrative.principles.sides import balanced
from freebody.narrative.questions.small_readers import SmallMotions
from freebody.questions.base import Quantity
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.questions.small_motion import Equilibrium
from freebody.questions.small_motion import SmallOscillations as SmallQuantity
from freebody.study.answering.answer import Answer
from freebody.study.eom import primitive_part
from freebody.symbolic.equilibrium import find_equilibrium, linearised, small_oscillations
from freebody.symbolic.field import Ratio
from freebody.symbolic.routh import determinant
from freebody.symbolic.tidy import tidy


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """Equations of motion, the equilibrium, what is linear beside it, the frequencies. Raises CannotAnswer where the
    solver has no formula."""
    refuse(method, ("newton", "lagrange"), Message("small motion"))
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    telling = _SmallTelling(context, question, answer, method)
    telling.equations()
    telling.equilibrium()
    telling.asked(question.quantity)
    return telling.script.stages


@dataclass(frozen=True)
class _Equation:
    """M q'' = F of one coordinate, and the line it stands in."""

    force: Ratio
    line: int


class _SmallTelling:
    """Writes one derivation."""

    def __init__(self, context: Context, question: Question, answer: Answer, method: Method) -> None:
        self.context, self.question, self.answer, self.method = context, question, answer, method
        self.model, self.field = context.setup.model, context.setup.model.field
        self.script: Script = context.script()
        is_small = question.quantity.is_about_stable
        self.values: Mapping[int, Ratio]
        self.squares: tuple[Ratio, ...] = ()
        self.swinging: tuple[int, ...] = ()  # which of them are not zero
        if is_small:
            found = small_oscillations(self.model, context.setup.start)
            self.values, self.squares, self.swinging = found.equilibrium, found.squares, found.swinging
        else:
            self.values = find_equilibrium(self.model, context.setup.start, stable_first=False).values
        self.readers = SmallMotions(context.setup, self.values)
        self.at_rest: dict[str, Expr] = {}  # coordinates by their symbols at the equilibrium
        self.found: list[_Equation] = []
        self.places: list[int] = []  # lines of the equilibrium

    # -- equations ----------------------------------------------------------------------------
    def equations(self) -> None:
        """M q'' = F, by momentum where one coordinate in the plane is enough."""
        rows = self._rows()
        f = self.field
        still = {c.speed: f.zero for c in self.model.coordinates} | {f.index(f.time): f.zero}
        for row in rows:
            self.found.append(_Equation(f.lowest_terms(f.follow(row.rest, still)), row.number))

    def _rows(self) -> list[EliminationRow]:
        accelerations = self.model.accelerations
        if self.method == "lagrange":
            values = by_lagrange(self.context, self.script, accelerations)
            return [EliminationRow({a: self.field.one}, *values[a]) for a in accelerations]
        if len(accelerations) == 1 and not self.context.system.space and not self.model.dependent:
            newton = self.context.newton
            values = newton.write(self.script, newton.plan(accelerations), accelerations)
            return [EliminationRow({a: self.field.one}, *values[a]) for a in accelerations]
        with self.script.stage("unclosed.equations", "unclosed.equations_hint"):
            return motion_equations(self.context, self.script)

    # -- the equilibrium ----------------------------------------------------------------------
    def equilibrium(self) -> None:
        """Speeds and accelerations vanish; what is left determines the coordinates."""
        script = self.script
        with script.stage("small.equilibrium", "small.equilibrium_hint"):
            meanings: list[Meaning] = []
            for k, c in enumerate(self.model.coordinates):
                symbol = Symbol(fresh(self.context, *_rest_names(c.name)))
                self.at_rest[c.name] = symbol
                what = Sentence("small.at_rest", {"name": Symbol(c.name)})
                meanings.append(Meaning(symbol, what, self.readers.value(k)))
            named(self.context, script, *meanings)
            script.say("small.rest")
            lines: list[int] = []
            for e in self.found:
                if not e.force.is_zero():
                    sides = balanced(substitute(tidy(primitive_part(e.force)), self.at_rest))
                    args: dict[str, Argument] = {"line": e.line}
                    lines.append(script.line(*sides, why="small.balance", args=args, uses=(e.line,), when="never"))
            for k, c in enumerate(self.model.coordinates):
                value = tidy(self.values[c.index])
                given: dict[str, Argument] = {"lines": tuple(lines)}
                key = "small.solved" if lines else "small.indifferent"
                symbol = meanings[k].symbol
                self.places.append(script.line(symbol, value, why=key, args=given, uses=tuple(lines), when="never"))

    @singledispatchmethod
    def asked(self, q: Quantity) -> None:
        """By the kind of question."""
        raise CannotAnswer(Message("this is no question about small motion"))

    @asked.register(Equilibrium)
    def _place(self, q: Equilibrium) -> None:
        """What was asked of the equilibrium."""
        script = self.script
        c = next((c for c in self.model.coordinates if self.model.measure_of(c) == q.measure), None)
        if c is not None:
            k = self.model.coordinates.index(c)
            if tidy(self.values[c.index]) == self.answer.expression:
                asked_as(self.context, self.question, self.readers.value(k))
                return
        with script.stage("stage.value"):
            value = self.model.value_of(q.measure)
            shown = substitute(tidy(value), self.at_rest)
            measure = q.measure

            def read(world: World) -> float:
                pose = self.readers.pose(world.draw)
                return world.draw.reference.snapshot(pose, 0 * pose).value(measure)

            symbol = asked_as(self.context, self.question, read)
            script.add(asked_entry(symbol, self.question))
            lines = tuple(self.places)
            expression = self.answer.expression
            assert expression is not None
            script.line(symbol, shown, expression, why="value.follows", args={"lines": lines}, uses=lines, when="never")

    # -- beside it ----------------------------------------------------------------------------
    def beside(self) -> tuple[list[Symbol], tuple[int, ...]]:
        """What is linear beside the equilibrium, and the squares of the frequencies: their symbols and lines."""
        names = [f"omega_{k + 1}" for k in range(len(self.squares))] if len(self.squares) > 1 else ["omega_0"]
        symbols = [Symbol(fresh(self.context, name, f"{name}_n")) for name in names]
        if len(self.model.coordinates) == 1:
            return symbols, self._one(symbols[0])
        return symbols, self._several(symbols)

    def _frequency(self, k: int, symbol: Symbol) -> Meaning:
        what = Sentence("small.frequency" if len(self.squares) == 1 else "small.frequency_k", {"k": k + 1})
        return Meaning(symbol, what, self.readers.frequency(k), "rad/s")

    def _one(self, symbol: Symbol) -> tuple[int, ...]:
        """x'' = -c x"""
        script, (c,) = self.script, self.model.coordinates
        slope = Symbol(fresh(self.context, "c_0", "c_x"))
        value = tidy(self.field.lowest_terms(self.squares[0]))
        uses = (*(e.line for e in self.found), *self.places)
        with script.stage("small.linear", "small.linear_hint"):
            what = Sentence("small.slope", {"name": rates_of(c.name, 2)})
            named(self.context, script, Meaning(slope, what, self.readers.slope))
            args: dict[str, Argument] = {"name": Symbol(c.name), "slope": slope, "second": rates_of(c.name, 2)}
            script.say("small.beside_one", **args)
            line = script.line(slope, value, why="small.slope_is", args={"lines": uses}, uses=uses, when="never")
        with script.stage("small.characteristic", "small.characteristic_hint"):
            named(self.context, script, self._frequency(0, symbol))
            square = power(symbol, number(2))
            return (
                script.line(
                    square, slope, value, why="small.harmonic", args={"line": line}, uses=(line,), when="never"
                ),
            )

    def _several(self, symbols: list[Symbol]) -> tuple[int, ...]:
        """det(K - w^2 M) = 0"""
        M, K = linearised(self.model, dict(self.values))
        lines = self._matrices(M, K)
        script = self.script
        with script.stage("small.characteristic", "small.characteristic_hint"):
            named(self.context, script, *(self._frequency(k, s) for k, s in enumerate(symbols)))
            script.say("small.determinant")
            sides = balanced(self._polynomial(M, K, power(symbols[0], number(2))))
            line = script.line(*sides, why="small.polynomial", args={"lines": lines}, uses=lines, when="never")
            roots: list[int] = []
            for symbol, value in zip(symbols, self.squares, strict=True):
                shown, square = tidy(self.field.lowest_terms(value)), power(symbol, number(2))
                args: dict[str, Argument] = {"line": line}
                roots.append(script.line(square, shown, why="small.root", args=args, uses=(line,), when="never"))
            return tuple(roots)

    def _matrices(self, M: list[list[Ratio]], K: list[list[Ratio]]) -> tuple[int, ...]:
        """Both matrices, row by row."""
        script, n, f = self.script, len(M), self.field
        uses, lines = (*(e.line for e in self.found), *self.places), list[int]()
        with script.stage("small.linear", "small.linear_hint"):
            script.say("small.beside", names=tuple(Symbol(c.name) for c in self.model.coordinates))
            for letter, values, read in (("M", M, self.readers.mass), ("K", K, self.readers.stiffness)):
                entries = [
                    [Symbol(fresh(self.context, f"{letter}_{j + 1}{k + 1}")) for k in range(n)] for j in range(n)
                ]
                what = Sentence(f"small.entry_{letter}")
                meanings = [Meaning(entries[j][k], what, read(j, k)) for j in range(n) for k in range(n)]
                named(self.context, script, *meanings)
                for j in range(n):
                    shown = tuple(tidy(f.lowest_terms(x)) for x in values[j])
                    why = f"small.row_{letter}"
                    args: dict[str, Argument] = {"k": j + 1}
                    lines.append(script.line(tuple(entries[j]), shown, why=why, args=args, uses=uses, when="never"))
        return tuple(lines)

    def _polynomial(self, M: list[list[Ratio]], K: list[list[Ratio]], square: Expr) -> Expr:
        """det(K - s M) in s = w^2, without factors that do not contain s."""
        f, n, s = self.field, len(M), self.field.parameter("@s")
        entries = [[K[j][k] - s * M[j][k] for k in range(n)] for j in range(n)]
        plain = f.one
        for base, exponent in f.factor(determinant(entries).num)[1]:
            if f.index(s) in base.generators():
                plain = plain * base**exponent
        coefficients = plain.coefficients(f.index(s))
        terms = [multiply(tidy(c), power(square, number(k))) for k, c in enumerate(coefficients) if not c.is_zero()]
        return add(*reversed(terms))

    # -- what is asked ------------------------------------------------------------------------
    @asked.register(SmallQuantity)
    def _frequencies(self, q: SmallQuantity) -> None:
        """Frequency, frequencies or period from their squares."""
        symbols, roots = self.beside()
        script = self.script
        expression = self.answer.expression
        assert expression is not None
        k = self.swinging[0] if self.swinging else 0
        if q.what != "frequencies":  # the one that is not zero
            symbols, roots = [symbols[k]], roots if len(roots) == 1 else (roots[k],)
        args: dict[str, Argument] = {"lines": roots}
        with script.stage("stage.value"):
            if q.what == "period":
                omega = self.readers.frequency(k)

                def period(world: World) -> float:
                    return 2 * math.pi / omega(world)

                symbol = asked_as(self.context, self.question, period)
                script.add(asked_entry(symbol, self.question, "s"))
                turn = 2 * Symbol("pi") / symbols[0]
                script.line(symbol, turn, expression, why="small.period", args=args, uses=roots, when="never")
                return
            left: Expr | tuple[Expr, ...] = symbols[0] if len(symbols) == 1 else tuple(symbols)
            if isinstance(expression, tuple) != isinstance(left, tuple):
                raise CannotAnswer(Message("the solver shows another number of frequencies"))
            script.line(left, expression, why="small.take_root", args=args, uses=roots, when="never")


def _rest_names(name: str) -> tuple[str, str]:
    """y_e of y, x_1e of x1."""
    letters, digits = re.fullmatch(r"(.*?)_?(\d*)", name).groups()  # type: ignore[union-attr]
    first = f"{letters}_{digits}e" if digits or "_" not in name else f"{name}e"
    return first, f"{name}_eq"
