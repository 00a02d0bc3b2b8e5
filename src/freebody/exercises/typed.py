"""Formulas as they are typed on platforms whose languages are close to our own, and back.

Names are kept where the platform has no other meaning for them; the rate of x is x_dot, as in freebody's own answers,
and that of its rate x_ddot.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from freebody.assess.names import named_in
from freebody.errors import ExpressionError
from freebody.language.expression import ELLIPTIC, FRESNEL, LAMBERT, Call, Expr, Number, Symbol, replace_rates
from freebody.language.notation.one_line import OneLineWriter
from freebody.language.parser import parse
from freebody.messages import Message

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


@dataclass(frozen=True)
class Language:
    """taken: words that are no names there; functions: its names for ours, where they differ; exact: it takes no
    decimals in formulas."""

    taken: frozenset[str]
    functions: Mapping[str, str]
    is_exact: bool = False


@dataclass(frozen=True)
class Typing:
    """The names of one question in a language. theirs: by ours, "rate(x)" for a rate."""

    language: Language
    theirs: Mapping[str, str]

    @classmethod
    def of(cls, language: Language, names: Iterable[str]) -> Typing:
        """Each name gets another one, as nearly the same as may be."""
        found: dict[str, str] = {}
        taken = {*language.taken, *language.functions.values()}
        for name in names:
            n, inner = name.count("rate("), name.rpartition("(")[2].rstrip(")")
            wanted = f"{inner}_{'d' * n}ot" if n else name
            found[name] = next(made for made in _tries(wanted) if made not in taken)
            taken.add(found[name])
        return cls(language, found)

    def written(self, expr: Expr) -> str:
        """Raises ExpressionError for what the language has no word for."""
        decimal = _fraction if self.language.is_exact else None
        return OneLineWriter("*", self._name, self._call, _power, decimal=decimal).write(self._flat(expr))[0]

    def _flat(self, expr: Expr) -> Expr:
        """With names for rates, from the innermost one outwards."""
        rated = [key for key in self.theirs if key.startswith("rate(")]
        for n in range(1, 1 + max((key.count("rate(") for key in rated), default=0)):
            inner = {key.split("rate(")[-1].rstrip(")") for key in rated}
            inside = {f"{'rate(' * (n - 1)}{name}{')' * (n - 1)}" for name in inner}
            expr = replace_rates(expr, {key: Symbol(f"rate({key})") for key in inside})
        return expr

    def read(self, text: str) -> Expr:
        """What was written, with our functions and its own names. Raises ExpressionError."""
        ours = {theirs: own for own, theirs in self.language.functions.items()}
        return parse(_NAME.sub(lambda found: ours.get(found[0], found[0]), text))

    def values(self, point: Mapping[str, float]) -> dict[str, float]:
        """The values of a point by its own names."""
        return {theirs: point[ours] for ours, theirs in self.theirs.items() if ours in point}

    def renamed(self) -> list[tuple[str, str]]:
        """Names that are typed differently: (the quantity, what is typed)."""
        return [(ours, theirs) for ours, theirs in self.theirs.items() if ours != theirs]

    def _name(self, name: str) -> str:
        if name == "pi":
            return name
        if name not in self.theirs:
            raise ExpressionError(Message("the exercise does not know '{name}'", name=name))
        return self.theirs[name]

    def _call(self, call: Call, argument: str) -> str:
        if call.function == "rate":
            raise ExpressionError(Message("it has the rate of more than a name"))
        if call.function in ELLIPTIC:
            raise ExpressionError(Message("it has an elliptic integral"))
        if call.function in FRESNEL:
            raise ExpressionError(Message("it has a Fresnel integral"))
        if call.function in LAMBERT:
            raise ExpressionError(Message("it has Lambert's W function"))
        return f"{self.language.functions.get(call.function, call.function)}({argument})"


def parts_of(text: str) -> tuple[Expr, ...]:
    """A formula in the notation of models, or those of a vector in brackets. Raises ExpressionError."""
    inside = text.strip()
    if not (inside.startswith("[") and inside.endswith("]")):
        return (parse(inside),)
    return tuple(map(parse, _split(inside[1:-1])))


def _split(text: str) -> Iterator[str]:
    """At commas outside of brackets."""
    depth, start = 0, 0
    for k, sign in enumerate(text):
        depth += (sign in "([") - (sign in ")]")
        if sign == "," and depth == 0:
            yield text[start:k]
            start = k + 1
    yield text[start:]


def _tries(name: str) -> Iterator[str]:
    yield name
    yield from (f"{name}_{n}" for n in range(1, 10**4))


def _power(base: str, _exponent: Expr, written: str) -> str:
    return f"{base}^{written}"


def _fraction(decimal: str) -> str:
    value = parse(decimal)
    assert isinstance(value, Number)
    return f"({value.value})"


def named(parts: Sequence[Expr]) -> tuple[str, ...]:
    """What has to have a value, "rate(x)" for a rate, in the order in which it stands there."""
    return tuple(dict.fromkeys(key for part in parts for key in named_in(part)))
