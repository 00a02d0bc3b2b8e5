"""Formulas in the language of Maxima as STACK reads it, and back.

STACK takes a letter behind a digit for a product (F_1x is F_1*x), and e, i and pi for constants; with its option
`consolidatesubscripts` M_1 and M1 are one name. So names are written with their digits last, constants get a digit, and
rates a name of their own: F_1x is F_x1, e is e0, the rate of x1 is dot_x1.

    elliptic_K(k) = elliptic_kc(k^2)        elliptic_F(phi, k) = elliptic_f(phi, k^2)

Maxima has the parameter m = k^2 where we have the modulus. Source: Maxima manual, "Elliptic Functions".
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from freebody.errors import ExpressionError
from freebody.language.expression import (
    LAMBERT,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    add,
    children,
    multiply,
    power,
    rate_key,
)
from freebody.language.notation import to_latex
from freebody.language.notation.one_line import OneLineWriter
from freebody.language.parser import parse
from freebody.messages import Message

# what these names mean in STACK is not a quantity
_WORDS = """
e i pi inf minf und ind infinity zeroa zerob true false null none nil all and or not nand nor xor implies if then else
elseif for from thru step while unless do in at is ev var del diff int rate rand min max mod sum product limit solve set
list matrix number float simp numer root base lambda ans sub lg ln gcd lcm re im arg abs sign block return go
"""
_TAKEN = frozenset(_WORDS.split())
_FUNCTIONS = {"sign": "signum", "elliptic_K": "elliptic_kc", "elliptic_F": "elliptic_f"}
_OURS = {theirs: ours for ours, theirs in _FUNCTIONS.items()}
_PARTS = re.compile(r"[A-Za-z]+|[0-9]+")
_TOKEN = re.compile(r"%?[A-Za-z][A-Za-z0-9_]*")
_DOT = "dot_"


@dataclass(frozen=True)
class MaximaNames:
    """Names of a model in Maxima, one for one. maxima: by the name of ours, "rate(x)" for a rate."""

    maxima: Mapping[str, str]

    @classmethod
    def of(cls, keys: Iterable[str]) -> MaximaNames:
        """Those of some symbols, and of rates as "rate(x)", "rate(rate(x))"."""
        taken: dict[str, str] = {}
        rates = [key for key in keys if key.startswith("rate(")]
        for name in (*(key for key in keys if not key.startswith("rate(")), *map(_inner, rates)):
            if name not in taken:
                taken[name] = _free(_digits_last(name), taken)
        for rate in rates:
            for n in range(1, rate.count("rate(") + 1):  # those of lower order as well
                key = "rate(" * n + _inner(rate) + ")" * n
                if key not in taken:
                    taken[key] = _free("d" * (n - 1) + _DOT + taken[_inner(rate)], taken)
        return cls(taken)

    @property
    def ours(self) -> Mapping[str, str]:
        return {theirs: ours for ours, theirs in self.maxima.items()}

    def written(self, expr: Expr) -> str:
        """An expression in Maxima. Raises ExpressionError for a name that is not known."""
        return OneLineWriter("*", self._name, self._call, _power, decimal=_fraction).write(expr)[0]

    def read(self, text: str) -> Expr:
        """What was written, as an expression. Raises ExpressionError."""
        names = {**self.ours, **_OURS, "%pi": "pi"}
        return _with_moduli(parse(_TOKEN.sub(lambda found: names.get(found.group(), found.group()), text)))

    def latex(self) -> Iterator[tuple[str, str]]:
        """What STACK shows for a name, where that is not the name itself."""
        for ours, theirs in self.maxima.items():
            if theirs not in (ours, ours.replace("_", "")) or ours == "lam":
                yield theirs, to_latex(parse(ours))

    def _name(self, name: str) -> str:
        if name == "pi":
            return "%pi"
        if name not in self.maxima:
            raise ExpressionError(Message("'{name}' is not known to the exercise", name=name))
        return self.maxima[name]

    def _call(self, call: Call, argument: str) -> str:
        if call.function == "rate":
            return self._name(rate_key(call))
        if call.function in ("elliptic_K", "elliptic_F"):
            modulus = call.modulus or call.argument
            inside = [self.written(x) for x in children(call)[:-1]] + [self.written(modulus**2)]
            return f"{_FUNCTIONS[call.function]}({','.join(inside)})"
        if call.function in LAMBERT:
            raise ExpressionError(Message("it has Lambert's W function"))
        return f"{_FUNCTIONS.get(call.function, call.function)}({argument})"


def _inner(rate: str) -> str:
    return rate.rpartition("(")[2].rstrip(")")


def _power(base: str, _exponent: Expr, written: str) -> str:
    return f"{base}^{written}"


def _fraction(decimal: str) -> str:
    """A decimal exactly: floating-point numbers are not compared as formulas."""
    value = parse(decimal)
    assert isinstance(value, Number)
    return f"({value.value})"


def _digits_last(name: str) -> str:
    """A name that STACK reads as one: the digits in it last, and e0 for e."""
    letters, digits = list[str](), list[str]()
    for part in _PARTS.findall(name):
        (digits if part[0].isdigit() else letters).append(part)
    made = "_".join(letters) + "_".join(digits)
    return f"{made}0" if made in _TAKEN else made


def _free(name: str, taken: Mapping[str, str]) -> str:
    used = set(taken.values())
    return next(made for n in range(10**4) if (made := "q" * n + name) not in used)


def _with_moduli(expr: Expr) -> Expr:
    """Elliptic integrals of the parameter as those of the modulus."""
    match expr:
        case Number() | Symbol():
            return expr
        case Sum(terms):
            return add(*map(_with_moduli, terms))
        case ProductOf(factors):
            return multiply(*map(_with_moduli, factors))
        case PowerOf(base, exponent):
            return power(_with_moduli(base), _with_moduli(exponent))
        case Call("elliptic_K", parameter):
            return Call("elliptic_K", Call("sqrt", _with_moduli(parameter)))
        case Call("elliptic_F", angle, parameter) if parameter is not None:
            return Call("elliptic_F", _with_moduli(angle), Call("sqrt", _with_moduli(parameter)))
        case Call():
            return expr.of(_with_moduli)
