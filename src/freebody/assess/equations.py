"""Typed equations of motion: right if they hold on every motion of the model, enough if they determine it.

The difference of the sides becomes an element in coordinates, speeds and accelerations; with the accelerations that the
model has it must vanish, whatever the pose and the speeds are. Names that the problem does not have (tensions, normal
forces) are multipliers: they are eliminated, and what is left must hold. So a set is judged by the span of its
differences, whatever the order, the factors and the multipliers are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from freebody.assess.names import named_in
from freebody.assess.setting import Setting
from freebody.assess.words import is_readable
from freebody.errors import CannotAnswer, UnitError
from freebody.language.expression import (
    Call,
    Expr,
    ProductOf,
    Sum,
    Symbol,
    add,
    children,
    multiply,
    negate,
    number,
)
from freebody.language.notation import to_text
from freebody.language.sentences import Message, listed
from freebody.language.units import dimension_of
from freebody.symbolic.field import Generator
from freebody.symbolic.functions import element
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

Equation = tuple[Expr, Expr]
Left = tuple[tuple[int, ...], Ratio]  # the places of the equations that it is made of, and a difference of sides
MOST_MULTIPLIERS = 12
_CHANGES = ((-1, "sign"), (0, "extra"), (2, "half"), (Fraction(1, 2), "twice"))  # of a term, that make it right


@dataclass(frozen=True)
class EquationsFound:
    """What typed equations are worth. wrong: those that do not hold, by their places; idle: those that follow from the
    others; open: accelerations that are not determined."""

    is_right: bool
    reason: str
    mistake: str = ""
    is_open: bool = False  # neither proved nor refuted


class EquationJudge:
    """Equations beside the motion of a model."""

    def __init__(self, setting: Setting) -> None:
        self.setting = setting
        self.model, self.field = setting.model, setting.field
        self.solved = self.model.dynamics.solved_accelerations

    def judge(self, equations: Sequence[Equation]) -> EquationsFound:
        """The verdict on a set. Raises CannotAnswer for what the field cannot say."""
        multipliers, numbers = self._multipliers(equations), range(1, len(equations) + 1)
        if not multipliers and (fault := self._unit_fault(equations, numbers)):
            return EquationsFound(False, fault)
        left = self._left(equations, multipliers)
        if (found := self._fault(equations, left, numbers)) is not None:
            return found
        return self._complete([(p, r) for p, r in left if not r.is_zero()], has_multipliers=bool(multipliers))

    def fault(self, equations: Sequence[Equation], numbers: Sequence[int]) -> EquationsFound | None:
        """What does not hold, however many there are; None where all does. numbers: by which they are called."""
        multipliers = self._multipliers(equations)
        if not multipliers and (fault := self._unit_fault(equations, numbers)):
            return EquationsFound(False, fault)
        return self._fault(equations, self._left(equations, multipliers), numbers)

    def is_identity(self, equation: Equation) -> bool:
        """Whether it holds for any motion, whatever the forces are."""
        return not self._multipliers([equation]) and self._element(self._difference(equation), {}).is_zero()

    def follows(self, equation: Equation, others: Sequence[Equation]) -> bool:
        """Whether it is a combination of others, forces and accelerations being the unknowns."""
        multipliers = self._multipliers([*others, equation])
        unknowns = [*map(self.field.index, multipliers.values()), *self.model.accelerations]
        rows = [self._row(self._element(self._difference(e), multipliers), unknowns) for e in (*others, equation)]
        return _is_combination(self.field.zero, rows[-1], rows[:-1])

    def _row(self, x: Ratio, unknowns: Sequence[int]) -> dict[int, Ratio]:
        """Coefficients of the unknowns, and what is left in column -1."""
        row: dict[int, Ratio] = {}
        for u in unknowns:
            slope = self.field.partial(x, u)
            if not slope.is_zero():
                row[u] = slope
                x = self.field.lowest_terms(x - slope * self.field.variable(u))
        return {**row, -1: x}

    def _left(self, equations: Sequence[Equation], multipliers: dict[str, Ratio]) -> list[Left]:
        rows = [self._element(self._difference(e), multipliers) for e in equations]
        return self._without(rows, [self.field.index(x) for x in multipliers.values()])

    def _fault(
        self, equations: Sequence[Equation], left: Sequence[Left], numbers: Sequence[int]
    ) -> EquationsFound | None:
        for parts, residual in left:
            on_motion = self._on_motion(residual)
            if self._vanishes(on_motion):
                continue
            if not residual.generators() & set(self.model.accelerations) and self._moves(residual):
                told = Message(
                    "{which} has no acceleration: it can hold for one start only", which=_which(parts, numbers)
                )
                return EquationsFound(False, told, is_open=True)
            return self._wrong(equations, parts, numbers, on_motion)
        return None

    # -- elements -----------------------------------------------------------------------------
    def _multipliers(self, equations: Sequence[Equation]) -> dict[str, Ratio]:
        """Names that the problem does not have, as unknowns of the field."""
        found: dict[str, Ratio] = {}
        for side in (side for equation in equations for side in equation):
            for key, shown in named_in(side).items():
                if self._is_known(key):
                    continue
                if not isinstance(shown, Symbol):
                    raise CannotAnswer(Message("{x} is no rate of a quantity of this problem", x=to_text(shown)))
                made = Generator(Symbol(shown.name), "parameter", compute=lambda _v, _f: 1.0)
                found.setdefault(key, self.field.generator(made, key=("typed", key)))
        if len(found) > MOST_MULTIPLIERS:
            raise CannotAnswer(Message("there are more than {n} unknown names", n=MOST_MULTIPLIERS))
        return found

    def _difference(self, equation: Equation) -> Expr:
        return add(equation[0], negate(equation[1]))

    def _element(self, expr: Expr, multipliers: dict[str, Ratio]) -> Ratio:
        values = {key: multipliers.get(key) or self._known(key) for key in named_in(expr)}
        return self.field.lowest_terms(element(self.field, expr, values, lambda _x: False))

    def _is_known(self, key: str) -> bool:
        """Whether it is a name of the problem or a rate of one, of any order."""
        while key not in self.setting.names and key.startswith("rate("):
            key = key[5:-1]
        return key in self.setting.names

    def _known(self, key: str) -> Ratio:
        return self.setting.names.element(key)

    def _unit_fault(self, equations: Sequence[Equation], numbers: Sequence[int]) -> str:
        for k, equation in zip(numbers, equations, strict=True):
            try:
                dimension_of(self._difference(equation), self.setting.names.dimensions)
            except UnitError as error:
                return Message("equation {k}: {error}", k=k, error=error)
        return ""

    # -- multipliers --------------------------------------------------------------------------
    def _without(self, rows: Sequence[Ratio], unknowns: Sequence[int]) -> list[Left]:
        """What is left of the rows without the unknowns, in which they are linear; with the rows that it is made of."""
        left: list[Left] = [((k,), row) for k, row in enumerate(rows)]
        for u in unknowns:
            slopes = [self.field.partial(row, u) for _parts, row in left]
            if any(u in slope.generators() for slope in slopes):
                raise CannotAnswer(Message("an unknown name does not occur linearly"))
            pivot = next((k for k, slope in enumerate(slopes) if not slope.is_zero()), None)
            if pivot is None:
                continue
            own, base = left[pivot]
            left = [
                (parts, row)
                if slope.is_zero()
                else (tuple(sorted({*parts, *own})), self.field.lowest_terms(row - base * slope / slopes[pivot]))
                for k, ((parts, row), slope) in enumerate(zip(left, slopes, strict=True))
                if k != pivot
            ]
        return left

    # -- on the motion ------------------------------------------------------------------------
    def _on_motion(self, x: Ratio) -> Ratio:
        return self.field.lowest_terms(self.model.in_independent_speeds(self.field.substitute(x, self.solved)))

    def _vanishes(self, x: Ratio) -> bool:
        return x.is_zero() or (bool(self.model.loops) and bool(self.model.samples.vanishes(x)))

    def _moves(self, x: Ratio) -> bool:
        return not x.is_constant()

    def _wrong(
        self, equations: Sequence[Equation], parts: tuple[int, ...], numbers: Sequence[int], rest: Ratio
    ) -> EquationsFound:
        shown = tidy(rest)
        if is_readable(shown):
            reason = Message(
                "{which} does not hold: on the motions of the model the sides differ by {x}",
                which=_which(parts, numbers),
                x=to_text(shown),
            )
        else:
            reason = Message("{which} does not hold on the motions of the model", which=_which(parts, numbers))
        mistake = self._term(equations[parts[0]]) if len(parts) == 1 else ""
        return EquationsFound(False, reason, mistake)

    def _term(self, equation: Equation) -> str:
        """The one term with which the equation is wrong, and how."""
        whole = self._difference(equation)
        terms = sorted(_terms(whole), key=_has_acceleration)
        for term in terms if len(terms) > 1 else ():
            for factor, what in _CHANGES:
                changed = add(whole, multiply(number(factor - 1), term))
                if self._vanishes(self._on_motion(self._element(changed, {}))):
                    return _said(what, to_text(term))
        return ""

    # -- enough of them -----------------------------------------------------------------------
    def _complete(self, rows: list[Left], *, has_multipliers: bool) -> EquationsFound:
        """Whether equations that hold determine all accelerations, and whether some follow from others."""
        left = [(parts, {a: self.field.partial(row, a) for a in self.model.accelerations}) for parts, row in rows]
        undetermined: list[str] = []
        for c, a in zip(self.model.coordinates, self.model.accelerations, strict=True):
            pivot = next((k for k, (_p, row) in enumerate(left) if not self._vanishes(row[a])), None)
            if pivot is None:
                undetermined.append(to_text(Call("rate", Call("rate", Symbol(c.name)))))
                continue
            _own, base = left.pop(pivot)
            left = [
                (parts, {b: self.field.lowest_terms(x - base[b] * row[a] / base[a]) for b, x in row.items()})
                for parts, row in left
            ]
        if undetermined:
            return self._incomplete(undetermined, says_nothing=not rows and not has_multipliers)
        if left:
            idle = listed([str(k + 1) for parts, _row in left for k in parts[:1]])
            told = Message("holds on every motion; equation {idle} follows from the others", idle=idle)
            return EquationsFound(True, told)
        return EquationsFound(True, Message("holds on every motion of the model and determines it"))

    def _incomplete(self, undetermined: Sequence[str], *, says_nothing: bool) -> EquationsFound:
        if says_nothing:
            told = Message("it holds for any motion, whatever the forces are: it says nothing")
        elif len(undetermined) == 1:
            told = Message("it holds, but one more equation is needed: {x} is not determined", x=undetermined[0])
        else:
            told = Message(
                "it holds, but {n} more equations are needed: {names} are not determined",
                n=len(undetermined),
                names=listed(undetermined),
            )
        return EquationsFound(False, told)


def _terms(expr: Expr) -> list[Expr]:
    """The terms of a sum, brackets with factors before them multiplied out."""
    if isinstance(expr, Sum):
        return [term for part in expr.terms for term in _terms(part)]
    if isinstance(expr, ProductOf):
        for k, factor in enumerate(expr.factors):
            if isinstance(factor, Sum):
                others = (*expr.factors[:k], *expr.factors[k + 1 :])
                return [t for term in factor.terms for t in _terms(multiply(*others, term))]
    return [expr]


def _has_acceleration(expr: Expr) -> bool:
    """Whether a second rate stands in it: the other terms are more often the wrong ones."""
    if isinstance(expr, Call) and expr.function == "rate" and isinstance(expr.argument, Call):
        return True
    return any(map(_has_acceleration, children(expr)))


def _which(parts: tuple[int, ...], numbers: Sequence[int]) -> str:
    if len(parts) == 1:
        return Message("equation {k}", k=numbers[parts[0]])
    return Message("what follows from equations {k}", k=listed([str(numbers[p]) for p in parts]))


def _is_combination(zero: Ratio, row: dict[int, Ratio], rows: Sequence[dict[int, Ratio]]) -> bool:
    """Whether a row, with its constant in column -1, is a combination of others."""
    left = [dict(other) for other in rows]
    target = dict(row)
    for column in sorted({c for other in (*left, target) for c in other if c != -1}):
        pivot = next((k for k, other in enumerate(left) if not other.get(column, zero).is_zero()), None)
        if pivot is None:
            continue
        base = left.pop(pivot)
        left = [_less(other, base, column, zero) for other in left]
        target = _less(target, base, column, zero)
    return all(x.is_zero() for x in target.values())


def _less(row: dict[int, Ratio], base: dict[int, Ratio], column: int, zero: Ratio) -> dict[int, Ratio]:
    factor = row.get(column, zero)
    if factor.is_zero():
        return row
    share = factor / base[column]
    return {c: zero.field.lowest_terms(row.get(c, zero) - share * base.get(c, zero)) for c in row.keys() | base.keys()}


def _said(what: str, term: str) -> str:
    match what:
        case "sign":
            return Message("the term {term} has the wrong sign", term=term)
        case "extra":
            return Message("the term {term} does not belong there", term=term)
        case "half":
            return Message("the term {term} lacks a factor 2", term=term)
        case _:
            return Message("the term {term} has a factor 2 too many", term=term)


__all__ = ["Equation", "EquationJudge", "EquationsFound"]
