"""What an expression tree is made of: its names, its depth, and how long it is to write."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import fields, is_dataclass

from freebody.language.expression.tree import (
    ELLIPTIC,
    LAMBERT,
    MINUS_ONE,
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
    negate,
    number,
    power,
)


def free_symbols(expr: Expr) -> frozenset[str]:
    """Names of all symbols except pi; those inside rate(...) count."""
    names: set[str] = set()
    waiting: list[Expr] = [expr]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Symbol):
            names.add(part.name)
        waiting.extend(children(part))
    return frozenset(names - {"pi"})


def stands_in(name: str, value: object) -> bool:
    """Whether a symbol stands anywhere in what is described: in dataclasses, tuples and mappings of expressions."""
    waiting, seen = [value], set[int]()
    while waiting:
        part = waiting.pop()
        if isinstance(part, (str, bytes, int, float, type(None))) or id(part) in seen:
            continue
        seen.add(id(part))
        if isinstance(part, Symbol):
            if part.name == name:
                return True
        elif isinstance(part, Mapping):
            waiting.extend(part.values())
        elif isinstance(part, (tuple, list, frozenset, set)):
            waiting.extend(part)
        elif is_dataclass(part):
            waiting.extend(getattr(part, field.name) for field in fields(part))
    return False


def has_jump(expr: Expr, names: Collection[str]) -> bool:
    """True if sign or abs is taken of something in which one of the names occurs: there, derivatives do not tell
    everything."""
    if isinstance(expr, Call) and expr.function in ("sign", "abs") and free_symbols(expr.argument) & set(names):
        return True
    return any(has_jump(part, names) for part in children(expr))


def domain(expr: Expr) -> list[tuple[Expr, str]]:
    """(part, relation to 0) for all that an expression needs to have a real value, as it is written: divisors that do
    not vanish, radicands that are not negative, arguments of logarithms and arcs within their range."""
    found: list[tuple[Expr, str]] = []
    for part in children(expr):
        found += domain(part)
    one = number(1)
    match expr:
        case PowerOf(base, Number(exponent)):
            is_whole = exponent.denominator == 1
            if exponent < 0:
                found.append((base, "!=" if is_whole else ">"))
            elif not is_whole:
                found.append((base, ">="))
        case Call("sqrt", argument):
            found.append((argument, ">="))
        case Call("log", argument):
            found.append((argument, ">"))
        case Call("tan", argument):
            found.append((Call("cos", argument), "!="))
        case Call("asin" | "acos", argument):
            found += [(add(one, negate(argument)), ">="), (add(one, argument), ">=")]
        case Call(function) if function in ELLIPTIC:
            k = children(expr)[-1]
            found += [(add(one, negate(k)), ">"), (add(one, k), ">")]
        case Call(function, argument) if function in LAMBERT:
            found.append((add(one, multiply(argument, Call("exp", one))), ">="))
            if function == "lambert_Wm1":
                found.append((negate(argument), ">"))
        case _:
            pass
    return [(part, relation) for part, relation in dict.fromkeys(found) if free_symbols(part)]


def depth(expr: Expr) -> int:
    """Levels of the tree; a number or a symbol has one."""
    deepest, level = 0, [expr]
    while level:
        deepest += 1
        level = [child for part in level for child in children(part)]
    return deepest


def in_one_order(expr: Expr) -> Expr:
    """The same with factors and terms in an order that does not depend on how it was written."""
    match expr:
        case Sum(terms):
            return Sum(tuple(sorted(map(in_one_order, terms), key=repr)))
        case ProductOf(factors):
            return ProductOf(tuple(sorted(map(in_one_order, factors), key=repr)))
        case PowerOf(base, exponent):
            return PowerOf(in_one_order(base), in_one_order(exponent))
        case Call():
            return expr.of(in_one_order)
        case _:
            return expr


def n_operations(expr: Expr) -> int:
    """How many + - * / ** and function calls it takes to write the expression."""
    match expr:
        case Symbol():
            return 0
        case Number(value):
            return (value < 0) + (value.denominator != 1)
        case Sum(terms):
            # A minus between terms is the subtraction itself; only one in front is an operation more.
            minuses = sum(map(_is_negative, terms[1:]))
            return len(terms) - 1 + sum(map(n_operations, terms)) - minuses
        case ProductOf(factors):
            return _n_operations_of_product(factors)
        case PowerOf(base, exponent):
            inverse = 1 if isinstance(exponent, Number) and exponent.value < 0 else 0
            if inverse and exponent == MINUS_ONE:
                return 1 + n_operations(base)
            return 1 + n_operations(base) + n_operations(exponent)
        case Call():
            return 1 + sum(map(n_operations, children(expr)))


def _n_operations_of_product(factors: tuple[Expr, ...]) -> int:
    count, n_numerators = len(factors) - 1, 0
    for factor in factors:
        match factor:
            case Number(value):
                # -1 costs its sign, 1/2 its division, which stands for the multiplication.
                count += (value < 0) - (abs(value.numerator) == 1)
                count += value.denominator != 1
                n_numerators += abs(value.numerator) != 1
            case PowerOf(base, Number(value)) if value < 0:
                count += n_operations(power(base, Number(-value)))
            case _:
                count += n_operations(factor)
                n_numerators += 1
    return count + (n_numerators == 0)


def _is_negative(expr: Expr) -> bool:
    match expr:
        case Number(value):
            return value < 0
        case ProductOf((Number(value), *_)):
            return value < 0
        case _:
            return False
