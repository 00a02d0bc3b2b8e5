"""Reading the user's mathematics: the only way from text to an expression tree.

    sum      = product {("+" | "-") product}
    product  = signed {("*" | "/") signed | power}        a power side by side is a product: 2 m g
    signed   = {"+" | "-"} power                           so -x^2 is -(x^2)
    power    = primary {superscript} ["^" signed]          so a^b^c is a^(b^c)
    primary  = number | name {"'"} | function "(" sum ["," sum] ")" | "(" sum ")" | "|" sum "|"

Nothing is ever executed. Every limit is checked before the work it bounds.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from difflib import get_close_matches
from fractions import Fraction
from functools import lru_cache

from freebody.errors import ExpressionError
from freebody.language.descent import Descent
from freebody.language.expression import (
    FUNCTIONS,
    PI,
    Call,
    Expr,
    Number,
    Symbol,
    depth,
    multiply,
    name_problem,
)
from freebody.language.guards import checked_power, exact_number, exponent_too_large, refuse_huge
from freebody.language.sentences import Message

MAX_CHARACTERS = 10_000
MAX_TOKENS = 2_000
MAX_NESTING = 100

_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lam mu nu xi omicron pi rho sigma tau "
    "upsilon phi chi psi omega"
)
_INTEGRALS = ("integral", "integrate", "int")
_LOWERCASE = dict(zip("αβγδεζηθικλμνξοπρστυφχψω", _GREEK_NAMES.split(" "), strict=True))
_UPPERCASE = {letter.upper(): name.capitalize() for letter, name in _LOWERCASE.items()}
GREEK = {**_LOWERCASE, **_UPPERCASE, "Λ": "Lambda"}

# What else people type for the same: final sigma, script forms, the micro and the ohm sign, index digits.
_VARIANTS = {"ς": "sigma", "ϑ": "theta", "ϕ": "phi", "ϵ": "epsilon", "\u00b5": "mu", "\u2126": "Omega"}
_INDICES = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True))
_LETTERS = {**GREEK, **_VARIANTS}
_REST = "A-Za-z0-9_" + "".join(_LETTERS) + "".join(_INDICES)
_TO_ASCII = str.maketrans({**_LETTERS, **_INDICES})


def in_ascii(name: str) -> str:
    """A name as expressions have it: alpha for α, x1 for x₁."""
    return name.translate(_TO_ASCII)


_SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")

_TOKEN = re.compile(
    r"(?P<space>\s+)"
    r"|(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
    rf"|(?P<name>[A-Za-z{''.join(_LETTERS)}][{_REST}]*|√)"
    r"|(?P<operator>\*\*|[-+*/^(),|·⋅×−])"
    r"|(?P<superscript>⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    r"|(?P<prime>['′]+)"
)
_SAME = {"**": "^", "·": "*", "⋅": "*", "×": "*", "−": "-"}

_HINTS = {
    "'\"`": Message("text in quotes is not mathematics"),
    "“”„‟‘’‚«»": Message("quotes that close and open are no quotes of YAML; leave them out, or write plain ones"),
    "[]{}": Message("only round brackets ( ) group"),
    ",": Message("functions take one argument, elliptic_F two, and decimals are written with a point"),
    ".": Message("a point stands only in a decimal number, as in 0.5"),
    "=<>≤≥≠": Message("an expression has no comparison or assignment"),
    "_": Message("names begin with a letter"),
    "!": Message("write the factorial out as a number"),
    "∞": Message("numbers must be finite"),
    "–—": Message("write - for minus"),
    "%": Message("write 0.01* for percent"),
}


@dataclass(frozen=True, slots=True)
class _Token:
    kind: str  # number, name, superscript, prime, end, or the operator itself
    text: str
    column: int
    after_space: bool


@lru_cache(maxsize=2048)  # a model says the same many times
def parse(text: str) -> Expr:
    """The expression a text stands for. Raises ExpressionError with the column of the first fault."""
    return _Parser(_tokens(text)).expression()


def _tokens(text: str) -> list[_Token]:
    if len(text) > MAX_CHARACTERS:
        raise ExpressionError(
            Message("the expression has {n} characters, at most {most} are read", n=len(text), most=MAX_CHARACTERS),
            MAX_CHARACTERS + 1,
        )
    tokens: list[_Token] = []
    place, nesting, after_space = 0, 0, False
    while place < len(text):
        found = _TOKEN.match(text, place)
        column = place + 1
        if found is None or found.lastgroup is None:
            raise ExpressionError(_hint_for(text[place]), column)
        kind, word, place = found.lastgroup, found.group(), found.end()
        if kind == "space":
            after_space = True
            continue
        if kind == "operator":
            kind = word = _SAME.get(word, word)
            nesting += (word == "(") - (word == ")")
        elif kind == "name":
            word = _checked_name(word, column, text[place:].lstrip().startswith("("))
        elif kind == "prime" and (not tokens or tokens[-1].kind != "name" or after_space):
            raise ExpressionError(_hint_for("'"), column)
        if nesting > MAX_NESTING:
            raise ExpressionError(Message("brackets nest more than {most} deep", most=MAX_NESTING), column)
        if len(tokens) >= MAX_TOKENS:
            raise ExpressionError(
                Message("the expression has more than {most} parts; split it up", most=MAX_TOKENS), column
            )
        tokens.append(_Token(kind, word, column, after_space))
        after_space = False
    tokens.append(_Token("end", "", len(text) + 1, after_space))
    return tokens


def _checked_name(word: str, column: int, before_bracket: bool) -> str:
    name = "sqrt" if word == "√" else word.translate(_TO_ASCII)
    if name in FUNCTIONS:
        if not before_bracket:
            message = Message("'{name}' is a function: write {name}(...), and {name}(...)^2 for its square", name=name)
            raise ExpressionError(message, column)
    elif problem := name_problem(name):
        raise ExpressionError(problem, column)
    return name


def _hint_for(character: str) -> Message:
    shown = repr(character)
    for characters, hint in _HINTS.items():
        if character in characters:
            return Message("{x} cannot be used here: {hint}", x=shown, hint=hint)
    if character.isalpha():
        return Message("{x} cannot be used: names have letters a-z or Greek ones, digits and underscores", x=shown)
    return Message("{x} cannot be used in an expression", x=shown)


class _Parser(Descent[_Token]):
    """Recursive descent over the tokens of one text."""

    def __init__(self, tokens: list[_Token]) -> None:
        super().__init__(tokens, MAX_NESTING)
        self._bars = 0  # of sizes that are open

    def expression(self) -> Expr:
        if self._now.kind == "end":
            raise ExpressionError(Message("the expression is empty"))
        result = self._sum()
        if self._now.kind == ")":
            raise ExpressionError(Message("')' closes no bracket"), self._now.column)
        self._refuse_comma()
        if depth(result) > MAX_NESTING:
            raise ExpressionError(Message("the expression nests more than {most} deep", most=MAX_NESTING))
        return result

    def _product(self) -> Expr:
        start = self._now.column
        factors = [self._signed()]
        divided = False
        while True:
            token = self._now
            if token.kind in ("*", "/"):
                self._take()
                divided = token.kind == "/"
                column = self._now.column
                factor = self._signed()
                factors.append(checked_power(factor, Number(Fraction(-1)), column) if divided else factor)
            elif token.kind in ("number", "name", "(") or (token.kind == "|" and not self._bars):
                self._check_side_by_side(token, divided)
                factors.append(self._power())
            elif token.kind in ("superscript", "prime"):
                raise ExpressionError(Message("'{text}' has nothing to stand on", text=token.text), token.column)
            else:
                break
        refuse_huge(factors, start)
        return multiply(*factors)

    def _check_side_by_side(self, token: _Token, divided: bool) -> None:
        before = self._tokens[self._at - 1]
        if token.kind == "number":
            raise ExpressionError(
                Message(
                    "'{text} {following}': write * or an operator before the number",
                    text=before.text,
                    following=token.text,
                ),
                token.column,
            )
        if not token.after_space and before.kind == "prime":
            raise ExpressionError(Message("write * after the prime for a product"), token.column)
        if not token.after_space and re.match("0[xXoObB]", before.text + token.text):
            raise ExpressionError(Message("numbers are decimal"), before.column)
        if divided:
            raise ExpressionError(Message("a/2 b can be read in two ways: write a/(2*b) or (a/2)*b"), token.column)

    def _power(self) -> Expr:
        base = self._primary()
        while self._now.kind == "superscript":
            token = self._take()
            digits = token.text.translate(_SUPERSCRIPTS)
            if len(digits) > 4:
                raise exponent_too_large(token.column)
            base = checked_power(base, Number(Fraction(int(digits))), token.column)
        if self._now.kind != "^":
            return base
        self._take()
        column = self._now.column
        return checked_power(base, self._signed(), column)

    def _primary(self) -> Expr:
        token = self._take()
        column = token.column
        match token.kind:
            case "number":
                return Number(exact_number(token.text, token.column))
            case "name" if token.text in FUNCTIONS:
                return self._call(token)
            case "name":
                return self._symbol(token)
            case "(":
                return self._inside(token)
            case "|":
                return self._size(token)
            case ",":
                raise ExpressionError(_hint_for(","), column)
            case "end":
                raise ExpressionError(Message("the expression ends where a number, name or bracket is needed"), column)
            case _:
                raise ExpressionError(
                    Message("a number, name or bracket is needed before '{text}'", text=token.text), column
                )

    def _inside(self, opening: _Token) -> Expr:
        bars, self._bars = self._bars, 0
        inner = self._sum()
        self._bars = bars
        self._refuse_comma()
        if self._now.kind != ")":
            raise ExpressionError(Message("this bracket is never closed"), opening.column)
        self._take()
        return inner

    def _size(self, opening: _Token) -> Expr:
        """|x|; a bar after a value closes the bar before it."""
        self._bars += 1
        inner = self._sum()
        if self._now.kind != "|":
            raise ExpressionError(Message("this bar is never closed"), opening.column)
        self._take()
        self._bars -= 1
        return Call("abs", inner)

    def _call(self, token: _Token) -> Expr:
        if token.text == "elliptic_F":
            return self._of_two(token)
        argument = self._inside(self._take())
        if token.text == "rate":
            return _rate(argument, token.column)
        return Call(token.text, argument)

    def _of_two(self, token: _Token) -> Expr:
        opening = self._take()
        first = self._sum()
        if self._now.kind != ",":
            raise ExpressionError(Message("write elliptic_F(phi, k), with the modulus k"), token.column)
        self._take()
        return Call(token.text, first, self._inside(opening))

    def _refuse_comma(self) -> None:
        if self._now.kind == ",":
            raise ExpressionError(_hint_for(","), self._now.column)

    def _symbol(self, token: _Token) -> Expr:
        following = self._now
        if following.kind == "(" and not following.after_space:
            raise ExpressionError(_not_a_function(token.text), token.column)
        result: Expr = Symbol(token.text)
        if following.kind == "prime":
            for _ in self._take().text[:MAX_NESTING]:
                result = _rate(result, token.column)
        return result


def _rate(argument: Expr, column: int) -> Expr:
    is_rate = isinstance(argument, Call) and argument.function == "rate"
    if not (is_rate or isinstance(argument, Symbol)) or argument == PI:
        raise ExpressionError(Message("rate(...) takes the name of one measure, as in rate(x)"), column)
    return Call("rate", argument)


def _not_a_function(name: str) -> Message:
    if name.lower() in _INTEGRALS:
        return Message(
            "'{name}' is not a function: an integral is a state of its own, named with its rate, as in states: {{z: x "
            "- x_d}}; write z in the formula",
            name=name[:40],
        )
    close = get_close_matches(name.lower(), FUNCTIONS, n=1)
    if close:
        return Message(
            "'{name}' is not a function: did you mean {other}? Otherwise write {name}*( ... ) for a product",
            name=name[:40],
            other=close[0],
        )
    return Message(
        "'{name}' is not a function: there are {names}; write {name}*( ... ) for a product",
        name=name[:40],
        names=", ".join(sorted(FUNCTIONS)),
    )
