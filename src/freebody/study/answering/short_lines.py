"""Long formulas as short ones: repeated parts, numerators and denominators have names, sums are added up in steps."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from freebody.language.expression import (
    ONE,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    add,
    children,
    divide,
    multiply,
    n_operations,
    power,
    rate_key,
)

SHORT = 40  # operations of a line that is read at a glance
_WORTH = 4  # operations of a repeated part that has a name


class Names:
    """Names that nothing else has: N, N_2 ..., or with numbers from one on."""

    def __init__(self, taken: set[str]) -> None:
        self._taken = taken

    def one(self, letter: str) -> Symbol:
        return self._new(letter) if letter not in self._taken else self.numbered(letter)

    def numbered(self, letter: str) -> Symbol:
        k = 1
        while f"{letter}_{k}" in self._taken:
            k += 1
        return self._new(f"{letter}_{k}")

    def _new(self, name: str) -> Symbol:
        self._taken.add(name)
        return Symbol(name)


def keys_in(expr: Expr) -> set[str]:
    """The names in a formula, rates of names as such."""
    if isinstance(expr, Symbol) or (isinstance(expr, Call) and expr.function == "rate"):
        return {rate_key(expr)}
    return set[str]().union(*map(keys_in, children(expr)))


def broken_up(formulas: Sequence[Expr], names: Names, letter: str) -> tuple[list[tuple[Symbol, Expr]], list[Expr]]:
    """Names with what they stand for, in their order, and by them the formulas. letter: of parts of long sums."""
    if all(n_operations(x) <= SHORT for x in formulas):
        return [], list(formulas)
    repeated: list[tuple[Symbol, Expr]] = []
    found = list(formulas)
    for part in _repeated(found):
        for name, known in repeated:
            part = _replaced(part, known, name)
        own = names.numbered("p")
        found = [_replaced(x, part, own) for x in found]
        repeated.append((own, part))
    named: list[tuple[Symbol, Expr]] = []
    for name, part in repeated:
        more, rest = _parted(part, names, letter)
        named += [*more, (name, rest)]
    done: list[Expr] = []
    for x in found:
        more, rest = _parted(x, names, letter)
        named += more
        done.append(rest)
    return named, done


def _repeated(formulas: Sequence[Expr]) -> list[Expr]:
    """Parts that stand in several places, the smallest first."""
    counted: Counter[Expr] = Counter()

    def visit(x: Expr) -> None:
        if isinstance(x, Call) and x.function == "rate":
            return
        is_part = isinstance(x, Sum | PowerOf | Call) and not _is_below(x)
        if is_part and n_operations(x) >= _WORTH:
            counted[x] += 1
            if counted[x] > 1:
                return
        for child in children(x):
            visit(child)

    for x in formulas:
        visit(x)
    return sorted((x for x, n in counted.items() if n > 1), key=lambda x: (n_operations(x), repr(x)))


def _is_below(x: Expr) -> bool:
    """Whether it is one over something."""
    return isinstance(x, PowerOf) and isinstance(x.exponent, Number) and x.exponent.value < 0


def _replaced(x: Expr, part: Expr, name: Symbol) -> Expr:
    if x == part:
        return name
    match x:
        case Sum(terms):
            return add(*(_replaced(t, part, name) for t in terms))
        case ProductOf(factors):
            return multiply(*(_replaced(t, part, name) for t in factors))
        case PowerOf(base, exponent):
            return power(_replaced(base, part, name), exponent)
        case Call():
            return x.of(lambda inner: _replaced(inner, part, name))
        case _:
            return x


def _parted(x: Expr, names: Names, letter: str) -> tuple[list[tuple[Symbol, Expr]], Expr]:
    """A long formula in short lines: of a fraction numerator and denominator, of a sum some of its terms at a time."""
    if n_operations(x) <= SHORT:
        return [], x
    above, below = _fraction(x)
    if below == ONE:
        return _in_steps(x, names, letter)
    named: list[tuple[Symbol, Expr]] = []
    sides: list[Expr] = []
    for part, own in ((above, "N"), (below, "D")):
        if n_operations(part) > SHORT // 3:
            more, short = _in_steps(part, names, own)
            name = names.one(own)
            named += [*more, (name, short)]
            part = name
        sides.append(part)
    return named, divide(*sides)


def _in_steps(x: Expr, names: Names, letter: str) -> tuple[list[tuple[Symbol, Expr]], Expr]:
    """A sum of which no line is long."""
    factors = x.factors if isinstance(x, ProductOf) else (x,)
    long = next((k for k, part in enumerate(factors) if isinstance(part, Sum) and n_operations(part) > SHORT), None)
    if long is None:
        return [], x
    total = factors[long]
    assert isinstance(total, Sum)
    groups: list[list[Expr]] = [[]]
    for term in total.terms:
        if groups[-1] and sum(map(n_operations, groups[-1])) + n_operations(term) > SHORT:
            groups.append([])
        groups[-1].append(term)
    if len(groups) == 1:
        return [], x
    named = [(names.numbered(letter), add(*group)) for group in groups]
    rest = add(*(name for name, _part in named))
    return named, multiply(*factors[:long], rest, *factors[long + 1 :])


def _fraction(x: Expr) -> tuple[Expr, Expr]:
    """Numerator and denominator."""
    factors = x.factors if isinstance(x, ProductOf) else (x,)
    above, below = list[Expr](), list[Expr]()
    for part in factors:
        if _is_below(part):
            assert isinstance(part, PowerOf)
            assert isinstance(part.exponent, Number)
            below.append(power(part.base, Number(-part.exponent.value)))
        else:
            above.append(part)
    return multiply(*above), multiply(*below)
