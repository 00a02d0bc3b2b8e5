"""Plain notation as people type it, by recursive descent.

    sum      = product {("+" | "-") product}
    product  = signed {("*" | "/") signed | power}        2 m g; 1/2 m v^2 is (1/2) m v^2
    signed   = {"+" | "-"} power
    power    = primary {superscript} ["^" signed]
    primary  = number | name {"'"} | function [power of it] argument | "(" sum ")" | "|" sum "|"
    argument = "(" sum ")" | [number] name                 sin θ, cos 2θ

Two ways of typing leave open what is meant: a/2 b is (a/2) b or a/(2 b), and sin a b is sin(a) b or sin(a b). Both are
read (`readings`), and whoever knows the units says which one is meant.
Every limit is checked before the work that it bounds.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from freebody.errors import ExpressionError
from freebody.language.descent import Descent
from freebody.language.expression import (
    MINUS_ONE,
    PI,
    Call,
    Expr,
    Number,
    Symbol,
    depth,
    multiply,
    number,
    power,
)
from freebody.language.expression.tree import ELLIPTIC
from freebody.language.guards import checked_power, exact_number, refuse_huge
from freebody.language.sentences import Message
from freebody.language.typed.words import Vocabulary

MAX_TOKENS = 300
MAX_NESTING = 30
MAX_DEPTH = 60

_GREEK = "\u0370-\u03ff\u00b5\u2126"
_TOKEN = re.compile(
    r"(?P<space>\s+)"
    r"|(?P<number>(?:[0-9]+(?:\.[0-9]*|,[0-9]+)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+(?![A-Za-z0-9]))?)"
    rf"|(?P<word>[A-Za-z{_GREEK}](?:[A-Za-z0-9{_GREEK}₀-₉]|_\{{[A-Za-z0-9{_GREEK}₀-₉ ,]*\}}|_)*|√)"
    r"|(?P<operator>\*\*|[-+*/^()\[\]{}|])"
    r"|(?P<superscript>⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    r"|(?P<prime>'+)"
    r"|(?P<separator>[,;])"
    r"|(?P<degree>°)"
    r"|(?P<percent>%)"
)
_SAME = {"**": "^", "[": "(", "{": "(", "]": ")", "}": ")"}
_SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_ARCS = {"sin": "asin", "cos": "acos", "tan": "atan"}
_ELLIPTIC = {"K": "elliptic_K", "F": "elliptic_F"}
_RECIPROCALS = {"cot": "tan", "sec": "cos", "csc": "sin"}


@dataclass(frozen=True, slots=True)
class _Token:
    kind: str  # number, name, function, superscript, prime, degree, percent, end, or the operator itself
    text: str
    column: int
    after_space: bool = False
    is_glued: bool = False  # belongs to the same run of letters as the one before
    dots: int = 0


def readings(text: str, vocabulary: Vocabulary) -> list[Expr]:
    """What a text may mean, the first the most natural: one expression, or several where it leaves that open. Raises
    ExpressionError with the column of the first fault."""
    tokens = _tokens(text, vocabulary)
    first = _Parser(tokens, vocabulary)
    found = [first.expression()]
    choices = [
        (takes, is_wide)
        for takes in ((0, 1, 2) if first.has_open_divisor else (0,))
        for is_wide in ((False, True) if first.has_open_argument else (False,))
    ]
    for takes, is_wide in choices[1:]:
        other = _Parser(tokens, vocabulary, takes=takes, is_wide=is_wide).expression()
        if other not in found:
            found.append(other)
    return found


def _tokens(text: str, vocabulary: Vocabulary) -> list[_Token]:
    tokens: list[_Token] = []
    place, nesting, after_space = 0, 0, False
    while place < len(text):
        found = _TOKEN.match(text, place)
        column = place + 1
        if found is None or found.lastgroup is None:
            raise ExpressionError(Message("{x} cannot be read here", x=repr(text[place])), column)
        kind, word, place = found.lastgroup, found.group(), found.end()
        if kind == "space":
            after_space = True
            continue
        if kind == "word":
            for k, part in enumerate(vocabulary.words(word.replace(",", "").replace(" ", ""), column)):
                tokens.append(_Token(part.kind, part.name, column, after_space and k == 0, k > 0, part.dots))
        else:
            if kind == "operator":
                kind = word = _SAME.get(word, word)
                nesting += (word == "(") - (word == ")")
            tokens.append(_Token(kind, word, column, after_space))
        after_space = False
        if nesting > MAX_NESTING:
            raise ExpressionError(Message("brackets nest more than {most} deep", most=MAX_NESTING), column)
        if len(tokens) > MAX_TOKENS:
            raise ExpressionError(Message("the answer has more than {most} parts", most=MAX_TOKENS), column)
    tokens.append(_Token("end", "", len(text) + 1, after_space))
    return tokens


class _Parser(Descent[_Token]):
    """One reading. takes: a divisor takes of the factors that stand beside it none (0), the names without a space
    between (1), or all (2); is_wide: an argument without brackets takes all."""

    def __init__(self, tokens: list[_Token], vocabulary: Vocabulary, *, takes: int = 0, is_wide: bool = False) -> None:
        super().__init__(tokens, MAX_DEPTH)
        self._vocabulary = vocabulary
        self._takes, self._is_wide = takes, is_wide
        self._sizes = 0  # open bars of absolute values
        self.has_open_divisor = self.has_open_argument = False

    def _takes_kind(self, kind: str) -> bool:
        """Takes the next token if it is of a kind."""
        is_so = self._now.kind == kind
        self._at += is_so
        return is_so

    def expression(self) -> Expr:
        if self._now.kind == "end":
            raise ExpressionError(Message("the expression is empty"))
        result = self._sum()
        if self._now.kind != "end":
            raise self._unexpected(self._now)
        if depth(result) > MAX_DEPTH:
            raise ExpressionError(Message("the expression nests more than {most} deep", most=MAX_DEPTH))
        return result

    def _unexpected(self, token: _Token) -> ExpressionError:
        if token.kind == ")":
            return ExpressionError(Message("')' closes no bracket"), token.column)
        if token.kind == "end":
            return ExpressionError(
                Message("the expression ends where a number, name or bracket is needed"), token.column
            )
        return ExpressionError(Message("'{x}' is not expected here", x=token.text[:40]), token.column)

    # -- sums and products --------------------------------------------------------------------
    def _product(self) -> Expr:
        start = self._now.column
        factors = [self._signed()]
        while True:
            token = self._now
            if token.kind == "*":
                self._take()
                factors.append(self._signed())
            elif token.kind == "/":
                self._take()
                factors.append(self._divisor(factors))
            elif self._begins_factor():
                factors.append(self._power())
            else:
                break
        refuse_huge(factors, start)
        return multiply(*factors)

    def _begins_factor(self) -> bool:
        """Whether what comes next is a factor without a sign between."""
        kind, before = self._now.kind, self._tokens[self._at - 1].kind if self._at else ""
        if kind == "number":
            return before == ")"
        return kind in ("name", "function", "(") or (kind == "|" and not self._sizes and before in (")", "name"))

    def _divisor(self, above: list[Expr]) -> Expr:
        """What stands behind a bar, to the power -1. Behind a bracket, a function, or a number below a number, the
        fraction is closed: 1/2 m v^2. A function is no part of a divisor: g/L sin(x)."""
        first = self._now
        below = self._signed()
        while self._now.is_glued or (first.kind == "number" and self._is_pi_at_once()):  # T/mg, 1/2π
            below = multiply(below, self._power())
        is_closed = first.kind in ("(", "function", "|")
        is_number = isinstance(below, Number) and all(isinstance(x, Number) for x in above)
        if self._begins_factor() and self._now.kind != "function" and not is_closed and not is_number:
            self.has_open_divisor = True
            while self._begins_factor() and self._is_taken():
                below = multiply(below, self._power())
        return checked_power(below, MINUS_ONE, first.column)

    def _is_pi_at_once(self) -> bool:
        return self._now.text == "pi" and not self._now.after_space

    def _is_taken(self) -> bool:
        """Whether a divisor takes the next factor."""
        if self._takes == 1:
            return self._now.kind == "name" and not self._now.after_space
        return self._takes == 2 and self._now.kind != "function"

    # -- powers -------------------------------------------------------------------------------
    def _power(self) -> Expr:
        token = self._now
        base = self._primary()
        while self._now.kind in ("superscript", "degree", "percent"):
            mark = self._take()
            if mark.kind == "superscript":
                base = checked_power(base, self._raised(mark), mark.column)
            else:
                base = multiply(base, PI, number(Fraction(1, 180))) if mark.kind == "degree" else base / 100
        if self._now.kind != "^":
            return base
        column = self._take().column
        exponent = self._exponent()
        if token.kind == "name" and base == Symbol("e") and self._vocabulary.known("e") is None:
            return Call("exp", exponent)
        return checked_power(base, exponent, column)

    def _raised(self, token: _Token) -> Number:
        digits = token.text.translate(_SUPERSCRIPTS)
        if len(digits) > 4:
            raise ExpressionError(Message("the exponent is too large"), token.column)
        return Number(Fraction(int(digits)))

    def _exponent(self) -> Expr:
        exponent = self._signed()
        if self._now.is_glued:  # e^-kt
            self.has_open_argument = True
            while self._is_wide and self._now.is_glued:
                exponent = multiply(exponent, self._power())
        return exponent

    # -- what a power is made of --------------------------------------------------------------
    def _primary(self) -> Expr:
        token = self._take()
        match token.kind:
            case "number":
                return Number(exact_number(token.text.replace(",", "."), token.column))
            case "name":
                return self._symbol(token)
            case "function":
                return self._call(token)
            case "(":
                return self._inside(token, ")")
            case "|":
                self._sizes += 1
                inside = self._inside(token, "|")
                self._sizes -= 1
                return Call("abs", inside)
            case _:
                self._at -= 1
                raise self._unexpected(token)

    def _inside(self, opening: _Token, closing: str) -> Expr:
        inner = self._sum()
        if self._now.kind != closing:
            if self._now.kind == "end":
                raise ExpressionError(Message("this bracket is never closed"), opening.column)
            raise self._unexpected(self._now)
        self._take()
        return inner

    def _symbol(self, token: _Token) -> Expr:
        dots = token.dots
        if token.text in _ELLIPTIC and self._now.kind == "(" and self._vocabulary.known(token.text) is None:
            return self._elliptic(_ELLIPTIC[token.text])
        if self._now.kind == "prime" and not self._now.after_space:
            dots += len(self._take().text)
        if dots > 3 or (dots and token.text == "pi"):
            raise ExpressionError(Message("this has no rate"), token.column)
        result: Expr = Symbol(token.text)
        for _ in range(dots):
            result = Call("rate", result)
        return result

    # -- functions ----------------------------------------------------------------------------
    def _call(self, token: _Token) -> Expr:
        """sin(x), sin x, sin^2 x, sin²(x), tan^-1(x)."""
        name, exponent = token.text, None
        if name in ELLIPTIC:
            return self._elliptic(name)
        if self._now.kind == "superscript":
            exponent = self._raised(self._take())
        elif self._now.kind == "^":
            self._take()
            sign = -1 if self._takes_kind("-") else 1
            exponent = multiply(number(sign), self._primary())
        is_enclosed = self._now.kind == "("
        argument = self._inside(self._take(), ")") if is_enclosed else self._bare_argument(token)
        if exponent == MINUS_ONE and name in _ARCS:
            return Call(_ARCS[name], argument)
        made = self._made(name, argument, token)
        return made if exponent is None else checked_power(made, exponent, token.column)

    def _made(self, name: str, argument: Expr, token: _Token) -> Expr:
        if name in _RECIPROCALS:
            return power(Call(_RECIPROCALS[name], argument), MINUS_ONE)
        if name == "rate" and not (
            isinstance(argument, Symbol) or (isinstance(argument, Call) and argument.function == "rate")
        ):
            raise ExpressionError(Message("rate(...) takes the name of one measure, as in rate(x)"), token.column)
        return Call(name, argument)

    def _elliptic(self, name: str) -> Expr:
        """K(k), F(phi, k): of a modulus; of an angle and a modulus."""
        if self._now.kind != "(":
            raise self._unexpected(self._now)
        opening = self._take()
        if name == "elliptic_K":
            return Call(name, self._inside(opening, ")"))
        angle = self._sum()
        if not self._takes_kind("separator"):
            raise self._unexpected(self._now)
        return Call(name, angle, self._inside(opening, ")"))

    def _bare_argument(self, token: _Token) -> Expr:
        """What a function without brackets is of: a number, a word, or a number times a word."""
        is_root = token.text in ("sqrt", "abs")
        factors: list[Expr] = []
        if self._now.kind == "-":
            raise self._unclear(token)
        if self._now.kind == "number":
            factors.append(self._primary())
        if self._now.kind == "name" and not (is_root and factors):
            factors.append(self._primary())
            while not is_root and self._now.is_glued and self._now.kind == "name":
                factors.append(self._primary())
        if not factors:
            factors.append(self._primary())
        if self._now.kind == "degree":
            self._take()
            factors += [PI, number(Fraction(1, 180))]
        if self._now.kind in ("name", "(") and not (self._now.kind == "(" and not is_root):
            self.has_open_argument = True
            while self._is_wide and self._now.kind in ("name", "("):
                factors.append(self._power())
        if self._now.kind == "/" and self._is_close():  # sin x/2
            self.has_open_argument = True
            if self._is_wide:
                column = self._take().column
                factors.append(checked_power(self._primary(), MINUS_ONE, column))
        if self._now.kind in ("^", "superscript"):
            raise self._unclear(token)
        return multiply(*factors)

    def _is_close(self) -> bool:
        """Whether a bar has no space around it, and a number or a name below."""
        below = self._tokens[self._at + 1]
        return not self._now.after_space and not below.after_space and below.kind in ("number", "name")

    def _unclear(self, token: _Token) -> ExpressionError:
        told = Message("it is not clear what {f} is of: write {f}( ... ) with brackets", f=token.text)
        return ExpressionError(told, token.column)
