"""Rates as symbols of their own: rate(x) replaced by a plain expression."""

from __future__ import annotations

from collections.abc import Mapping

from freebody.language.expression.tree import Call, Expr, PowerOf, ProductOf, Sum, Symbol, add, multiply, power


def replace_rates(expr: Expr, replacements: Mapping[str, Expr]) -> Expr:
    """The expression with rate(name) replaced for every name that is given."""
    match expr:
        case Call("rate", Symbol(name)) if name in replacements:
            return replacements[name]
        case Sum(terms):
            return add(*(replace_rates(t, replacements) for t in terms))
        case ProductOf(factors):
            return multiply(*(replace_rates(f, replacements) for f in factors))
        case PowerOf(base, exponent):
            return power(replace_rates(base, replacements), replace_rates(exponent, replacements))
        case Call():
            return expr.of(lambda x: replace_rates(x, replacements))
        case _:
            return expr
