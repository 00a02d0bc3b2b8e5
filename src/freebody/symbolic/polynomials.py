"""Polynomials with integer coefficients in numbered generators, modulo quadratic relations g^2 = r.

Later generators are larger in the lexicographic order, so dividing by g^2 - r, where r is made of earlier ones, is the
reduction to the normal form. FLINT does the arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, TypeAlias

import flint

from freebody.errors import FormulaTooDear, FormulaTooLong
from freebody.language.sentences import Message

_flint: Any = flint
Poly: TypeAlias = Any  # fmpz_mpoly: FLINT ships no type information
Monomial: TypeAlias = tuple[tuple[int, int], ...]  # (generator, exponent), ...
Terms: TypeAlias = Mapping[Monomial, int]

# Above this many terms an element is no longer something that anybody reads or that factors quickly.
TERM_LIMIT = 60_000
PRODUCT_LIMIT = 4_000_000  # terms that a product has before like ones are added
_QUICK_TERMS = 40
_FEW_TERMS = 4  # that are read faster as they stand


def _too_long(kind: type[FormulaTooLong] = FormulaTooLong) -> FormulaTooLong:
    return kind(
        Message(
            "the closed form would have more than {n} terms; ask for numbers or for the equations of motion instead",
            n=TERM_LIMIT,
        )
    )


class PolynomialRing:
    """The generators by number, and what their squares are. The pool of generators grows when it is used up, which
    leaves old polynomials in an older context; `current` brings them into the present one."""

    def __init__(self, capacity: int) -> None:
        self._relations: dict[int, Poly] = {}  # g^2 - r, by number of g
        self._left: int | None = None  # pairs of terms that quotients may still compare, where that is limited
        self._open(capacity)

    def _open(self, capacity: int) -> None:
        """Indices count down from the end of the pool: generator k of the pool is named g<k>, and later
        generators are larger in the lexicographic order. Names are stable when the pool grows."""
        self._capacity = capacity
        self._brought: dict[int, tuple[Poly, Poly]] = {}  # by identity, with what it belongs to, so that this stays
        names = [f"g{k}" for k in range(capacity - 1, -1, -1)]
        self._names = names
        self._context = _flint.fmpz_mpoly_ctx.get(names, _flint.Ordering.lex)
        self.variables: list[Poly] = list(reversed(self._context.gens()))

    def reserve(self, n: int) -> None:
        """Room for n generators, and a quarter more when it grows: what is not used is carried by every term."""
        if n > self._capacity:
            self._open(n + n // 4)
            self._relations = {k: self.current(p) for k, p in self._relations.items()}

    def bind(self, index: int, square: Poly) -> None:
        """From here on the square of a generator is a polynomial in earlier ones."""
        self._relations[index] = self.variables[index] ** 2 - self.current(square)

    def square_of(self, index: int) -> Poly:
        """The square of a generator that is bound."""
        return self.variables[index] ** 2 - self._relations[index]

    # -- making them --------------------------------------------------------------------------
    def constant(self, value: int) -> Poly:
        return self._context.constant(value)

    def current(self, poly: Poly) -> Poly:
        """A polynomial in the present context (the pool may have grown since). FLINT matches generators by their names,
        so each polynomial is brought there once."""
        if self.is_current(poly):
            return poly
        known = self._brought.get(id(poly))
        if known is None:
            known = self._brought[id(poly)] = poly, poly.project_to_context(self._context)
        return known[1]

    def is_current(self, poly: Poly) -> bool:
        return poly.context() is self._context

    def as_written(self, terms: Terms) -> Poly:
        """A polynomial of which no relation is used."""
        data: dict[tuple[int, ...], int] = {}
        for monomial, coefficient in terms.items():
            exponents = [0] * self._capacity
            for index, exponent in monomial:
                exponents[self._capacity - 1 - index] += exponent
            key = tuple(exponents)
            data[key] = data.get(key, 0) + coefficient
        return self._context.from_dict(data)

    def product(self, a: Poly, b: Poly) -> Poly:
        """Raises CannotAnswer where it would be too long to be made: FLINT ends the process where memory does."""
        if len(a) * len(b) > PRODUCT_LIMIT:
            raise _too_long()
        return a * b

    @contextmanager
    def within(self, pairs: int | None) -> Generator[None]:
        """Quotients inside compare no more pairs of terms, of numerator and denominator, and squares that are put in
        multiply no more, than so many: beyond that, as where a product is too long, FormulaTooDear is raised. None: as
        many as it takes."""
        before, self._left = self._left, pairs
        try:
            yield
        finally:
            self._left = before

    def common_divisor(self, a: Poly, b: Poly) -> Poly:
        """The greatest one."""
        self._spend(len(a) * len(b))
        return a.gcd(b)

    def _spend(self, pairs: int) -> None:
        if self._left is not None:
            self._left -= pairs
            if self._left < 0:
                raise _too_long(FormulaTooDear)

    def reduce(self, poly: Poly) -> Poly:
        """Normal form modulo the relations g^2 = r."""
        if len(poly) > TERM_LIMIT:
            raise _too_long()
        if not self._relations or poly.is_constant():
            return poly
        last = self._capacity - 1
        degrees = poly.degrees()
        if max([degrees[last - index] for index in self._relations]) < 2:
            return poly
        for index in sorted(self._relations, reverse=True):
            if poly.degrees()[last - index] >= 2:
                self._check_work(poly, index)
                self._spend(len(poly) * len(self._relations[index]))
                poly = divmod(poly, self._relations[index])[1]
        return poly

    def _check_work(self, poly: Poly, index: int) -> None:
        """Raises CannotAnswer where to put a square in would take too many products of terms."""
        most, n = PRODUCT_LIMIT, len(self._relations[index])
        if len(poly) * n <= most:
            return
        k = self._capacity - 1 - index
        if n * sum(m[k] // 2 for m in poly.monoms() if m[k] >= 2) > most:
            raise _too_long()

    # -- reading them -------------------------------------------------------------------------
    def used(self, poly: Poly) -> set[int]:
        """The generators that occur."""
        last = poly.context().nvars() - 1
        return {last - k for k, degree in enumerate(poly.degrees()) if degree > 0}

    def terms(self, poly: Poly) -> dict[Monomial, int]:
        """The polynomial as {((generator, exponent), ...): coefficient}."""
        last = poly.context().nvars() - 1
        if len(poly) > _FEW_TERMS:
            poly, used = _in_own_ring(poly)
            places = [(n, last - k) for n, k in enumerate(used)]
        else:
            places = [(k, last - k) for k, degree in enumerate(poly.degrees()) if degree > 0]
        return {tuple((g, int(m[k])) for k, g in places if m[k]): int(c) for m, c in poly.to_dict().items()}

    def split(self, poly: Poly, generator: int) -> list[Poly]:
        """Coefficients of the powers of one generator, lowest first."""
        parts = self._parts(poly, (generator,))
        highest = max(parts, default=(0,))[0]
        zero = self.constant(0)
        return [parts.get((k,), zero) for k in range(highest + 1)]

    def split_by_pair(self, poly: Poly, pair: tuple[int, int]) -> dict[tuple[int, int], Poly]:
        """Coefficients of the products of powers of two generators, by their exponents; those that are not zero."""
        return {(i, j): rest for (i, j), rest in sorted(self._parts(poly, pair).items(), key=lambda part: part[0])}

    def _parts(self, poly: Poly, generators: Sequence[int]) -> dict[tuple[int, ...], Poly]:
        """Coefficients of the products of powers of some generators, by their exponents."""
        small, used = _in_own_ring(self.current(poly))
        place_of = {self._capacity - 1 - k: n for n, k in enumerate(used)}
        places = [place_of.get(g) for g in generators]
        parts: dict[tuple[int, ...], dict[tuple[int, ...], int]] = {}
        for monomial, coefficient in small.to_dict().items():
            exponents = tuple(0 if n is None else int(monomial[n]) for n in places)
            rest = list(monomial)
            for n in places:
                if n is not None:
                    rest[n] = 0
            parts.setdefault(exponents, {})[tuple(rest)] = coefficient
        here, back = small.context(), dict(enumerate(used))
        return {e: here.from_dict(part).project_to_context(self._context, back) for e, part in parts.items()}

    # -- factors ------------------------------------------------------------------------------
    def irreducible(self, poly: Poly) -> tuple[int, list[tuple[Poly, int]]]:
        """Unit and irreducible factors with exponents, no relation used. Raises OverflowError for some coefficients
        beyond machine integers, by which FLINT's Python orders factors."""
        # in a ring of its own generators alone, as FLINT's time grows with those of the ring
        poly = self.current(poly)
        names = [name for name, degree in zip(self._names, poly.degrees(), strict=True) if degree > 0]
        small = _flint.fmpz_mpoly_ctx.get(names, _flint.Ordering.lex)
        unit, factors = poly.project_to_context(small).factor()
        return int(unit), [(factor.project_to_context(self._context), int(e)) for factor, e in factors]

    def factors(self, poly: Poly, *, is_quick: bool = False) -> tuple[int, list[tuple[Poly, int]]]:
        """Integer content and irreducible factors with exponents; a quick one leaves a long rest whole.

        Common symbols and the content come out first. If then a symbol occurs in one term only, and there to
        the first power, the rest is linear in it with coprime parts, hence irreducible; FLINT factors the others."""
        terms = self.terms(poly)
        if not terms:
            return 0, []
        content, common, rest = primitive(terms)
        found = [(self.variables[g], e) for g, e in common.items()]
        if len(terms) == 1:
            return content, found
        remaining = self.reduce(self.as_written(rest))
        if has_lonely_symbol(rest) or (is_quick and len(rest) > _QUICK_TERMS):
            return content, [*found, (remaining, 1)]
        try:
            unit, factors = self.irreducible(remaining)
        except OverflowError:  # without factors it is as true
            return content, [*found, (remaining, 1)]
        for (
            factor,
            exponent,
        ) in factors:  # what relations bring forth of the rest may be one of the common symbols again
            k = next((k for k, (known, _exponent) in enumerate(found) if known == factor), None)
            if k is None:
                found.append((factor, exponent))
            else:
                found[k] = factor, found[k][1] + exponent
        return content * unit, found

    def homogeneous(self, poly: Poly, pair: tuple[int, int]) -> Poly | None:
        """The polynomial with all terms of one degree in the cosine and sine of an angle, by 1 = c^2 + s^2, so that
        4 c^2 - 4 + ... is a square where it is one. None where it is so already or odd and even degrees mix."""
        parts = self.split_by_pair(poly, pair)
        degrees = {i + j for i, j in parts}
        if len(degrees) < 2 or len({degree % 2 for degree in degrees}) > 1:
            return None
        c, s = (self.variables[k] for k in pair)
        total = self.constant(0)
        for (i, j), rest in parts.items():
            total = total + rest * c**i * s**j * (c**2 + s**2) ** ((max(degrees) - i - j) // 2)
        return total

    def square_root(self, poly: Poly) -> Poly | None:
        """Of a perfect square, no relation used; else None."""
        try:
            return poly.sqrt()
        except (_flint.utils.flint_exceptions.DomainError, ValueError):
            return None


def _in_own_ring(poly: Poly) -> tuple[Poly, list[int]]:
    """The polynomial in a ring of as many generators as it has, and their places in its own ring: with others, too,
    every monomial is read with all their exponents."""
    used = [k for k, degree in enumerate(poly.degrees()) if degree > 0]
    small = _flint.fmpz_mpoly_ctx.get([f"g{n}" for n in range(len(used))], _flint.Ordering.lex)
    return poly.project_to_context(small, {k: n for n, k in enumerate(used)}), used


# -- terms ------------------------------------------------------------------------------------


def primitive(terms: Mapping[Monomial, int]) -> tuple[int, dict[int, int], dict[Monomial, int]]:
    """(content, common symbols with exponents, the rest) of a polynomial that is not zero; the content of a single
    term is its coefficient."""
    content = math.gcd(*terms.values()) if len(terms) > 1 else next(iter(terms.values()))
    common = dict(next(iter(terms)))
    for monomial in terms:
        powers = dict(monomial)
        common = {g: min(e, powers[g]) for g, e in common.items() if g in powers}
    rest = {
        tuple((g, e - common.get(g, 0)) for g, e in monomial if e > common.get(g, 0)): c // content
        for monomial, c in terms.items()
    }
    return content, common, rest


def has_lonely_symbol(terms: Mapping[Monomial, int]) -> bool:
    """True if a symbol occurs in one term only, and there to the first power."""
    count: dict[int, int] = {}
    degree: dict[int, int] = {}
    for monomial in terms:
        for g, e in monomial:
            count[g] = count.get(g, 0) + 1
            degree[g] = e
    return any(n == 1 and degree[g] == 1 for g, n in count.items())


def declaration_order(monomial: tuple[tuple[int, int], ...]) -> tuple[Any, ...]:
    """Sorts terms by the order in which symbols were declared, high powers of early symbols first."""
    return (*((g, -e) for g, e in sorted(monomial)), (10**6, 0))


def square_part(value: int) -> tuple[int, int]:
    """value = square^2 * free, by trial division (numbers here are small; a big rest stays inside)."""
    square, free, prime = 1, 1, 2
    while prime * prime <= value and prime < 10_000:
        count = 0
        while value % prime == 0:
            value //= prime
            count += 1
        square *= prime ** (count // 2)
        free *= prime ** (count % 2)
        prime += 1
    root = math.isqrt(value)
    return (square * root, free) if root * root == value else (square, free * value)
