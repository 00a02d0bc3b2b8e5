"""Writing expressions as tapes; see `tape` for how they are played."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from freebody.errors import CannotAnswer
from freebody.language.expression import (
    ELEMENTARY,
    FRESNEL,
    PLACE,
    Call,
    Expr,
    GivenCall,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    children,
    rate_key,
    substitute,
    whole_exponent,
)
from freebody.language.sentences import Message
from freebody.numeric.kernels import tape

_NAMES = (*ELEMENTARY, "abs", "sign", *FRESNEL)
_OPS: dict[str, int] = {name: getattr(tape, name.upper()) for name in _NAMES}


class Tapes:
    """All tapes of a system, one behind the other."""

    def __init__(self, numbers: Mapping[str, float]) -> None:
        """numbers: the values of the parameters."""
        self._numbers = numbers
        self.ptr = [0]
        self.ops: list[int] = []
        self.left: list[int] = []
        self.right: list[int] = []
        self.constants: list[float] = []
        self._known: dict[tuple[int, int, int, float], int] = {}
        self._given: dict[int, tuple[Expr, bool]] = {}  # by identity; expressions are kept so that none gets its number
        self._placed: dict[int, tuple[Expr, int]] = {}

    def write(self, expr: Expr, inputs: Mapping[str, tuple[int, float]], rates: Mapping[str, int] | None = None) -> int:
        """The number of a new tape for an expression in parameters and time `t`. inputs: for other names the row
        whose value they are and what is added to it; rates: for "rate(name)" the row."""
        self._known, self._given, self._placed = {}, {}, {}
        last = self._place(expr, inputs, rates or {})
        if last != len(self.ops) - 1:  # the result must be the last register
            self._append(tape.ADD, last, self._constant(0.0), 0.0)
        self.ptr.append(len(self.ops))
        return len(self.ptr) - 2

    def _append(self, op: int, left: int, right: int, constant: float) -> int:
        self.ops.append(op)
        self.left.append(left)
        self.right.append(right)
        self.constants.append(constant)
        return len(self.ops) - 1

    def _emit(self, op: int, left: int = 0, right: int = 0, constant: float = 0.0) -> int:
        """The register of an operation, which is done once however often it occurs."""
        key = (op, left, right, constant)
        if key not in self._known:
            self._known[key] = self._append(*key)
        return self._known[key]

    def _constant(self, value: float) -> int:
        return self._emit(tape.CONSTANT, constant=value)

    def _is_given(self, expr: Expr) -> bool:
        """Whether it is made of parameters alone."""
        if id(expr) not in self._given:
            own = not isinstance(expr, Symbol) or expr.name in self._numbers or expr.name == "pi"
            self._given[id(expr)] = expr, own and all(map(self._is_given, children(expr)))
        return self._given[id(expr)][1]

    def _place(self, expr: Expr, inputs: Mapping[str, tuple[int, float]], rates: Mapping[str, int]) -> int:
        """The register of an expression; one that stands in several places is gone through once."""
        if id(expr) not in self._placed:
            self._placed[id(expr)] = expr, self._new_place(expr, inputs, rates)
        return self._placed[id(expr)][1]

    def _new_place(self, expr: Expr, inputs: Mapping[str, tuple[int, float]], rates: Mapping[str, int]) -> int:
        def place(part: Expr) -> int:
            return self._place(part, inputs, rates)

        if self._is_given(expr):
            value = constant_value(expr, self._numbers)
            if value is not None:
                return self._constant(value)
        match expr:
            case Symbol("t"):
                return self._emit(tape.TIME)
            case Symbol(name) if name in inputs:
                row, offset = inputs[name]
                return self._emit(tape.VALUE, row, constant=offset)
            case Symbol(name) if name in rates:
                return self._emit(tape.RATE, rates[name])
            case Call("rate", _) if rate_key(expr) in rates:
                return self._emit(tape.RATE, rates[rate_key(expr)])
            case Sum(terms):
                return self._chain(tape.ADD, [place(term) for term in terms])
            case ProductOf(factors):
                above: list[int] = []
                below: list[int] = []
                for factor in factors:
                    n = whole_exponent(factor) if isinstance(factor, PowerOf) else None
                    if isinstance(factor, PowerOf) and n is not None and n < 0:
                        below.append(self._power(place(factor.base), -n))
                    else:
                        above.append(place(factor))
                top = self._chain(tape.MULTIPLY, above) if above else self._constant(1.0)
                return self._emit(tape.DIVIDE, top, self._chain(tape.MULTIPLY, below)) if below else top
            case PowerOf(base, exponent):
                n = whole_exponent(expr)
                if n is not None and n >= 0:
                    return self._power(place(base), n)
                if n is not None:
                    return self._emit(tape.DIVIDE, self._constant(1.0), self._power(place(base), -n))
                if isinstance(exponent, Number):
                    if exponent.value == Fraction(1, 2):
                        return self._emit(tape.SQRT, place(base))
                    return self._emit(tape.WHOLE_POWER, place(base), constant=float(exponent.value))
                return self._emit(tape.POWER, place(base), place(exponent))
            case GivenCall(argument=argument, forms=forms, place=where):
                return place(substitute(forms[0], {PLACE.name: substitute(where, {PLACE.name: argument})}))
            case Call(function, argument) if function in _OPS:
                return self._emit(_OPS[function], place(argument))
            case _:
                raise CannotAnswer(Message("{x} cannot be evaluated along a motion", x=expr))

    def _power(self, base: int, n: int) -> int:
        return base if n == 1 else self._emit(tape.WHOLE_POWER, base, constant=float(n))

    def _chain(self, op: int, parts: list[int]) -> int:
        first, *rest = parts
        for part in rest:
            first = self._emit(op, first, part)
        return first


def constant_value(expr: Expr, numbers: Mapping[str, float]) -> float | None:
    """The value of an expression in parameters alone, None where it has none."""
    from freebody.language.expression import FLOAT_FUNCTIONS, evaluate

    try:
        return float(evaluate(expr, numbers, FLOAT_FUNCTIONS))
    except (ArithmeticError, ValueError):
        return None
