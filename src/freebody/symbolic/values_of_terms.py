"""Numbers for generators and for the polynomials in them: floats, mpmath's numbers or arrays; see `field`."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any, Protocol

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.symbolic.polynomials import Terms
from freebody.tolerances import ROUND_OFF


class Computed(Protocol):
    """What is known of a generator: how it is shown, of which kind it is, how it follows from others."""

    @property
    def display(self) -> Expr: ...

    @property
    def kind(self) -> str: ...

    @property
    def compute(self) -> Callable[[Mapping[int, Any], Any], Any] | None: ...


Generators = Mapping[int, Computed]


class NoValue(CannotAnswer, KeyError):
    """A part of a formula has no real value at the numbers that are put in."""

    def __init__(self, name: str) -> None:
        super().__init__(Message("{x} has no real value here", x=name))

    __str__ = Exception.__str__


class WhenAsked(dict[int, Any]):
    """Values of generators; those that are computed are so when they are first asked for."""

    def __init__(self, generators: Generators, values: Mapping[int, Any], functions: Any) -> None:
        super().__init__(values)
        self._generators, self._functions = generators, functions

    def __missing__(self, index: int) -> Any:
        compute = self._generators[index].compute
        if compute is not None:
            with suppress(KeyError, ValueError, ArithmeticError):
                value = self[index] = compute(self, self._functions)
                return value
        raise KeyError(index)


def with_computed(generators: Generators, values: Mapping[int, Any], functions: Any) -> dict[int, Any]:
    """The values, and those of all computed generators whose ingredients are known."""
    full = dict(values)
    for index, generator in generators.items():
        if index not in full and generator.compute is not None:
            # what is not real here, or made of what is not, has no value
            with suppress(KeyError, ValueError, ArithmeticError):
                full[index] = generator.compute(full, functions)
    return full


def value_of(generators: Generators, terms: Terms, values: Mapping[int, Any]) -> Any:
    """The sum of the terms. `NoValue` where a generator has none."""
    total: Any = 0
    for monomial, coefficient in terms.items():
        term: Any = coefficient
        try:
            for index, exponent in monomial:
                value = values[index]
                term = term * (value if exponent == 1 else value**exponent)
        except KeyError as error:
            raise NoValue(to_text(generators[error.args[0]].display)) from None
        total = total + term
    return total


def sum_and_size(generators: Generators, terms: Terms, values: Mapping[int, float]) -> tuple[float, float]:
    """The sum of the terms and that of their sizes, whatever they are measured in.
    A sine or cosine that vanishes counts as one in a size, so that a single term with it is small beside its size;
    others count as what they are, so that a product of small ones is not taken for zero."""

    def size(k: int) -> float:
        is_zero = generators[k].kind in ("cos", "sin") and abs(values[k]) <= ROUND_OFF
        return 1.0 if is_zero else abs(values[k])

    items = terms.items()
    parts = (math.prod((values[k] ** e for k, e in monomial), start=float(c)) for monomial, c in items)
    sizes = (math.prod((size(k) ** e for k, e in monomial), start=abs(float(c))) for monomial, c in items)
    return math.fsum(parts), math.fsum(sizes)
