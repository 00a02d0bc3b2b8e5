"""Small oscillations and equilibria step by step: the equations of motion, the equilibrium, what is linear beside it.

With q = q_e + x and F(q) the generalized forces at rest,

    F(q_e) = 0,    M x'' + K x = 0,    K = -dF/dq,    det(K - w^2 M) = 0.

Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, ch. 6.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from freebody.errors import FormulaTooLong
from freebody.language.expression import Expr, Symbol, add, divide, multiply, n_operations, number, power, substitute
from freebody.language.sentences import Argument, Message, Sentence
from freebody.model.elements import NonholonomicForm
from freebody.narrative.context import Context, Method
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import fresh, named
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.analytic import by_lagrange
from freebody.narrative.principles.elimination import EliminationRow
from freebody.narrative.principles.motion_equations import motion_equations
from freebody.narrative.principles.sides import balanced
from freebody.narrative.questions.small_readers import SmallMotions
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.eom import primitive_part
from freebody.symbolic.equilibrium import find_equilibrium
from freebody.symbolic.linear import determinant
from freebody.symbolic.linearised import Linearised, Matrix, stand_still, swing_of
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import FreeOscillations, free_oscillations
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate

_LONG = 80  # operations of an acceleration that is written out
Reader = Callable[[int, int], Callable[[World], float]]


@dataclass(frozen=True)
class _Equation:
    """M q'' = F of one coordinate, and the line it stands in."""

    force: Ratio
    line: int


class SmallTelling:
    """Writes one derivation."""

    def __init__(self, context: Context, question: Question, answer: Answer, method: Method) -> None:
        self.context, self.question, self.answer, self.method = context, question, answer, method
        self.model, self.field = context.setup.model, context.setup.model.field
        self.script: Script = context.script()
        start = context.setup.start
        if question.quantity.is_about_stable:
            self.free = free_oscillations(self.model, start)
        else:
            self.free = FreeOscillations(self.model, find_equilibrium(self.model, start, stable_first=False))
        self.values: Mapping[int, Ratio] = self.free.equilibrium
        self.readers = SmallMotions(context.setup, self.values, lambda: self.squares)
        self.at_rest: dict[str, Expr] = {}  # coordinates by their symbols at the equilibrium
        self.found: list[_Equation] = []
        self.places: list[int] = []  # lines of the equilibrium

    # -- equations ----------------------------------------------------------------------------
    def equations(self) -> None:
        """M q'' = F, by momentum where one coordinate in the plane is enough."""
        rows = self._rows()
        f = self.field
        is_long = len(rows) == 1 and n_operations(tidy(rows[0].rest)) > _LONG
        if is_long and self.may_be_told_by_principles:
            raise FormulaTooLong(Message("the equation of motion is too long to be read"))
        still = {c.speed: f.zero for c in self.model.coordinates} | stand_still(self.model)
        for row in rows:
            self.found.append(_Equation(f.lowest_terms(f.follow(row.rest, still)), row.number))

    @property
    def may_be_told_by_principles(self) -> bool:
        """Whether what is linear at rest is enough: for frequencies, and for the damping of one coordinate."""
        quantity = self.question.quantity
        return quantity.is_told_by_principles or (
            quantity.is_told_by_principles_of_one and len(self.model.coordinates) == 1
        )

    def principles(self) -> None:
        """Where the equations of motion are too long to write: why those of first order are enough, and what holds."""
        self.script, self.found = self.context.script(), []
        with self.script.stage("small.principle", "small.principle_hint"):
            self.script.say("small.unwritten", n=len(self.model.coordinates))
            for connection in self._rolling():
                self.script.say("small.rolls", connection=connection)

    def _rolling(self) -> list[str]:
        """The connections in whose contact the bodies have one velocity, in both directions across the normal."""
        rows = [row for row in self.context.setup.system.constraint_rows if isinstance(row.measure, NonholonomicForm)]
        held = [row.connection for row in rows if row.reaction.startswith("friction force")]
        return [name for name in dict.fromkeys(held) if held.count(name) == 2]

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
        """Speeds and accelerations vanish; what is left determines the coordinates. Where nothing can rest the constant
        forces drop out of linear equations."""
        script = self.script
        if self.free.rest.moves_evenly:
            with script.stage("small.even", "small.even_hint"):
                script.say("small.deviations")
            return
        with script.stage("small.equilibrium", "small.equilibrium_hint"):
            meanings: list[Meaning] = []
            readers = [(c, self.readers.value(k)) for k, c in enumerate(self.model.coordinates)]
            readers += [(d, self.readers.follower(d)) for d in self._followers]
            for c, read in readers:
                symbol = Symbol(fresh(self.context, *_rest_names(c.name)))
                self.at_rest[c.name] = symbol
                what = Sentence("small.at_rest", {"name": Symbol(c.name)})
                meanings.append(Meaning(symbol, what, read))
            named(self.context, script, *meanings)
            script.say("small.rest" if swing_of(self.model) is None else "small.mean")
            lines: list[int] = []
            for e in self.found:
                if not e.force.is_zero():
                    sides = balanced(substitute(tidy(primitive_part(e.force)), self.at_rest))
                    args: dict[str, Argument] = {"line": e.line}
                    lines.append(script.line(*sides, why="small.balance", args=args, uses=(e.line,), when="never"))
            for (c, _read), meaning in zip(readers, meanings, strict=True):
                value = tidy(self.values[c.index])
                given: dict[str, Argument] = {"lines": tuple(lines)}
                key = "small.solved" if lines else "small.indifferent" if self.found else "small.balanced"
                self.places.append(
                    script.line(meaning.symbol, value, why=key, args=given, uses=tuple(lines), when="never")
                )

    @property
    def _followers(self) -> list[Coordinate]:
        """Coordinates that follow the others through closed loops, and stand in the forces."""
        inside = {g for e in self.found for g in self.field.ingredients(e.force)}
        return [d for d in self.model.dependent if d.index in inside & self.values.keys()]

    # -- beside it ----------------------------------------------------------------------------
    @property
    def squares(self) -> tuple[Ratio, ...]:
        """Of the frequencies. Raises CannotAnswer where they have no closed form."""
        return self.free.squares

    def beside(self) -> tuple[list[Symbol], tuple[int, ...]]:
        """What is linear beside the equilibrium, and the squares of the frequencies: their symbols and lines."""
        names = [f"omega_{k + 1}" for k in range(len(self.squares))] if len(self.squares) > 1 else ["omega_0"]
        symbols = [Symbol(fresh(self.context, name, f"{name}_n")) for name in names]
        if len(self.model.coordinates) == 1:
            return symbols, (self._one if self.found else self._one_at_rest)(symbols[0])
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
            self._say_undamped()
            script.say("small.beside_one", **args)
            line = script.line(slope, value, why="small.slope_is", args={"lines": uses}, uses=uses, when="never")
        with script.stage("small.characteristic", "small.characteristic_hint"):
            named(self.context, script, self._frequency(0, symbol))
            square = power(symbol, number(2))
            return (
                script.line(
                    *(square, slope, value),
                    why="small.harmonic",
                    args={"line": line, "slope": slope},
                    uses=(line,),
                    when="never",
                ),
            )

    def _one_at_rest(self, symbol: Symbol) -> tuple[int, ...]:
        """M x'' + K x = 0, so that w^2 = K/M."""
        lines, script = self.matrices(undamped=True), self.script
        with script.stage("small.characteristic", "small.characteristic_hint"):
            named(self.context, script, self._frequency(0, symbol))
            ratio = divide(self.entries("K")[0][0], self.entries("M")[0][0])
            value = tidy(self.field.lowest_terms(self.squares[0]))
            sides, args = (power(symbol, number(2)), ratio, value), dict[str, Argument](lines=lines)
            return (script.line(*sides, why="small.harmonic_free", args=args, uses=lines, when="never"),)

    def _say_undamped(self) -> None:
        """That frequencies are those without damping, where there is any."""
        if any(not x.is_zero() for row in self.linear.damping for x in row):
            self.script.say("small.undamped")

    def _several(self, symbols: list[Symbol]) -> tuple[int, ...]:
        """det(K - w^2 M) = 0"""
        M, K = self.linear.mass, self.linear.stiffness
        lines = self.matrices(undamped=True) if self.found else ()
        script, from_what = self.script, "small.polynomial" if self.found else "small.polynomial_at_rest"
        with script.stage("small.characteristic", "small.characteristic_hint"):
            named(self.context, script, *(self._frequency(k, s) for k, s in enumerate(symbols)))
            script.say("small.determinant")
            sides = balanced(self._polynomial(M, K, power(symbols[0], number(2))))
            line = script.line(*sides, why=from_what, args={"lines": lines}, uses=lines, when="never")
            roots: list[int] = []
            for symbol, value in zip(symbols, self.squares, strict=True):
                shown, square = tidy(self.field.lowest_terms(value)), power(symbol, number(2))
                args: dict[str, Argument] = {"line": line}
                roots.append(script.line(square, shown, why="small.root", args=args, uses=(line,), when="never"))
            return tuple(roots)

    @property
    def linear(self) -> Linearised:
        return self.free.linear

    def matrices(self, *, with_damping: bool = False, undamped: bool = False) -> tuple[int, ...]:
        """M and K, and C where damping is asked for, row by row. undamped: where there is any, that it is
        left out is said."""
        script, n, f = self.script, len(self.model.coordinates), self.field
        uses, lines = (*(e.line for e in self.found), *self.places), list[int]()
        linear, read = self.linear, self.readers
        shown: list[tuple[str, Matrix, Reader]] = [
            ("M", linear.mass, read.mass),
            ("K", linear.stiffness, read.stiffness),
        ]
        if with_damping:
            shown.insert(1, ("C", linear.damping, read.damping))
        with script.stage("small.linear", "small.linear_hint"):
            one, many = ("beside_damped_one", "beside_damped") if with_damping else ("beside_one_free", "beside")
            key = f"small.{one if n == 1 else many}"
            if undamped:
                self._say_undamped()
            script.say(key, names=tuple(Symbol(c.name) for c in self.model.coordinates))
            for letter, values, reader in shown:
                entries = self.entries(letter)
                what = Sentence(f"small.entry_{letter}")
                meanings = [Meaning(entries[j][k], what, reader(j, k)) for j in range(n) for k in range(n)]
                named(self.context, script, *meanings)
                for j in range(n):
                    row = tuple(tidy(f.lowest_terms(x)) for x in values[j])
                    left: Expr | tuple[Expr, ...] = entries[0][0] if n == 1 else tuple(entries[j])
                    right: Expr | tuple[Expr, ...] = row[0] if n == 1 else row
                    args: dict[str, Argument] = {"k": j + 1}
                    why = f"small.row_{letter}" if n > 1 else f"small.one_{letter}"
                    lines.append(script.line(left, right, why=why, args=args, uses=uses, when="never"))
        return tuple(lines)

    def entries(self, letter: str) -> list[list[Symbol]]:
        """Names of the entries of a matrix; of one coordinate's, one name."""
        n = len(self.model.coordinates)
        if n == 1:
            system = self.context.system
            taken = system.parameters.keys() | system.measures.keys() | system.states.keys()
            plain = () if taken & {*"MCK"} else (letter,)  # all three, or none
            return [[Symbol(fresh(self.context, *plain, f"{letter}_x", f"{letter}_11"))]]
        return [[Symbol(fresh(self.context, f"{letter}_{j + 1}{k + 1}")) for k in range(n)] for j in range(n)]

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


def _rest_names(name: str) -> tuple[str, str]:
    """y_e of y, x_1e of x1."""
    letters, digits = re.fullmatch(r"(.*?)_?(\d*)", name).groups()  # pyrefly: ignore[missing-attribute]
    first = f"{letters}_{digits}e" if digits else f"{name}_e"
    return first, f"{name}_eq"
