"""Recursive descent over the tokens of one text: what every grammar of sums, products and powers has in common."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Generic, Protocol, TypeVar

from freebody.errors import ExpressionError
from freebody.language.expression import Expr, add, negate
from freebody.language.guards import refuse_huge
from freebody.language.sentences import Message


class Token(Protocol):
    """A piece of a text: its kind, of an operator the operator itself."""

    @property
    def kind(self) -> str: ...
    @property
    def column(self) -> int: ...


T = TypeVar("T", bound=Token)


class Descent(ABC, Generic[T]):
    """sum = product {("+" | "-") product}, signed = {"+" | "-"} power; what a product and a power are, each grammar
    says itself. most_nested: how deep signs and brackets may nest."""

    def __init__(self, tokens: Sequence[T], most_nested: int) -> None:
        self._tokens, self._most_nested = tokens, most_nested
        self._at: int = 0
        self._nesting = 0

    @abstractmethod
    def _product(self) -> Expr: ...

    @abstractmethod
    def _power(self) -> Expr: ...

    @property
    def _now(self) -> T:
        return self._tokens[self._at]

    def _take(self) -> T:
        token = self._now
        self._at += 1
        return token

    def _sum(self) -> Expr:
        start = self._now.column
        terms = [self._product()]
        while self._now.kind in ("+", "-"):
            minus = self._take().kind == "-"
            term = self._product()
            terms.append(negate(term) if minus else term)
        refuse_huge(terms, start)
        return add(*terms)

    def _signed(self) -> Expr:
        self._nesting += 1
        if self._nesting > self._most_nested + 1:  # the whole is no bracket
            told = Message("the expression nests more than {most} deep", most=self._most_nested)
            raise ExpressionError(told, self._now.column)
        if self._now.kind in ("+", "-"):
            minus = self._take().kind == "-"
            operand = self._signed()
            result = negate(operand) if minus else operand
        else:
            result = self._power()
        self._nesting -= 1
        return result
