"""What is typed as an answer: an expression with its label, a vector, an interval, a number with its unit.

answer   = [label ("=" | "≈" | ":=")] value          label = a name with indices and dots, as v_1, T(s), x''
value    = expression | number unit | "[" expression ("," | ";") ... "]"
         | value relation label relation value        0 <= F <= 2 m g
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from freebody.errors import ExpressionError, UnitError
from freebody.language.expression import Expr, evaluate, free_symbols
from freebody.language.sentences import Message
from freebody.language.typed.characters import normalized
from freebody.language.typed.grammar import readings
from freebody.language.typed.latex import is_latex, plain_of_latex
from freebody.language.typed.words import Vocabulary
from freebody.language.units import DIMENSIONLESS, Dimension, Unit, parse_unit

MAX_CHARACTERS = 1000
MOST_EQUATIONS = 12
_MOST_READINGS = 8
_RELATION = re.compile(r"<=|>=|=<|=>|:=|==|=|≈|<|>")
_LABEL = re.compile(r"(?=.*[A-Za-z\u0370-\u03ff])[A-Za-z0-9\u0370-\u03ff_'{}(),. ₀-₉→|\[\]]{1,60}")
_IN = re.compile(r"(?P<label>[^∈]{1,40}?)(?:∈| in (?=[\[(\]]))(?P<value>.*)", re.S)
_LIST = re.compile(r"^[\[({\]](?P<inside>.*)[\])}\[]$", re.S)
_AND = re.compile(r"\s(?:and|und|&|∧)\s|\s*;\s*")
_DECIMAL_COMMA = re.compile(r"(?<=[0-9]),(?=[0-9])")
_DERIVATIVE = re.compile(
    r"\(?\(?\s*d(?:\^?\(?(?P<n>[23])\)?|(?P<sup>[²³]))?\s?(?P<of>[^\W\d]\w{0,20})\)?"
    r"\s?/\s?\(?\s?d ?t(?:\^?\(?[23]\)?|[²³])?\)?\)?"
)
_NUMBER = r"[+-]?\s*(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?"
_POWER_OF_TEN = r"\s*\*\s*10\s*\^\s*\(?[+-]?[0-9]{1,2}\)?"
_UNIT = r"[A-Za-zµμ°Ω%\[(].*|(?<=\s)1\s*/.*"
_QUANTITY = re.compile(rf"(?P<number>{_NUMBER}(?:{_POWER_OF_TEN})?)\s*(?P<unit>{_UNIT})?", re.S)
_PERCENT = Unit(DIMENSIONLESS, Fraction(1, 100))
_SPELT_UNITS = (
    (re.compile(r"\b(k?)N\*?m(m?)\b"), r"\1N m\2"),
    (re.compile(r"\bkg\*?m\b"), "kg m"),
    (re.compile(r"\bkg\*?m([²^])"), r"kg m\1"),
    (re.compile(r"\b(k?)Ns\b"), r"\1N s"),
    (re.compile(r"\bms\^?\(?-(\d)\)?"), r"m/s^\1"),
    (re.compile(r"\b(?:Grad|grad|degrees?)\b"), "deg"),
    (re.compile(r"\b(?:radians?|Radiant)\b"), "rad"),
    (re.compile(r"\b(?:sec|Sek|seconds?|Sekunden?)\b"), "s"),
)


@dataclass(frozen=True)
class TypedNumber:
    """A number as it is typed, in SI. n_digits: those that are significant; has_unit: whether a unit stands there."""

    value: float
    dimension: Dimension
    has_unit: bool
    n_digits: int | None
    text: str
    unit: str = ""


@dataclass(frozen=True)
class TypedAnswer:
    """One way to read an answer: its components, as expressions or numbers; what stands before it."""

    parts: tuple[Expr | TypedNumber, ...]
    label: str = ""
    relations: tuple[str, ...] = ()  # of an inequality, in the order of the parts

    @property
    def is_number(self) -> bool:
        return any(isinstance(part, TypedNumber) for part in self.parts)


def read_typed(text: str, vocabulary: Vocabulary, n_parts: int = 1) -> list[TypedAnswer]:
    """All ways to read an answer with so many components, the most natural first. Raises ExpressionError saying what
    cannot be read."""
    if len(text) > MAX_CHARACTERS:
        raise ExpressionError(
            Message("an answer may have {most} characters, this one has {n}", most=MAX_CHARACTERS, n=len(text))
        )
    plain = normalized(plain_of_latex(text) if is_latex(text) else text).strip().rstrip(".;,!? ")
    if "±" in plain:
        raise ExpressionError(Message("± stands for two values: give one"))
    if not plain:
        raise ExpressionError(Message("the answer is empty"))
    label, relations, texts = _apart(_with_rates(plain), n_parts)
    found = list(_together([_part(part, vocabulary) for part in texts]))
    return [TypedAnswer(parts, label, relations) for parts in found[:_MOST_READINGS]]


def _with_rates(text: str) -> str:
    """dx/dt as x', d^2x/dt^2 as x''."""

    def primed(found: re.Match[str]) -> str:
        n = {"²": 2, "³": 3}.get(found["sup"] or "", int(found["n"] or 1))
        return f"({found['of']}{chr(39) * n})"

    return _DERIVATIVE.sub(primed, text) if "dt" in text.replace(" ", "") else text


def _together(parts: list[_Part]) -> Iterator[tuple[Expr | TypedNumber, ...]]:
    """One reading of each component, the same way for all where they have as many; numbers first where all are."""
    quantities = [part.quantity for part in parts]
    numbers = tuple(q for q in quantities if q is not None)
    are_numbers = len(numbers) == len(parts)
    if are_numbers and all(part.is_number for part in parts):
        yield numbers
    if all(part.exprs for part in parts):
        for k in range(max(len(part.exprs) for part in parts)):
            yield tuple(part.exprs[min(k, len(part.exprs) - 1)] for part in parts)
    if are_numbers and not all(part.is_number for part in parts):
        yield numbers


# -- label, relation, components --------------------------------------------------------------
def _apart(text: str, n_parts: int) -> tuple[str, tuple[str, ...], list[str]]:
    """Label, relations and the texts of the components."""
    if (found := _IN.fullmatch(text)) is not None and _LABEL.fullmatch(found["label"].strip()):
        return found["label"].strip(), ("<=", "<="), _components(found["value"].strip(), n_parts)
    sides, signs = _RELATION.split(text), [_same(s) for s in _RELATION.findall(text)]
    sides = [side.strip() for side in sides]
    if not signs:
        return "", (), _components(text, n_parts)
    if any(not side for side in sides):
        raise ExpressionError(Message("a side of the relation is empty"))
    if signs == ["="] * n_parts and n_parts > 1 and (parts := _each_labelled(text, n_parts)):
        return "", ("=",) * n_parts, parts
    if signs == ["="]:
        return _labelled(sides, n_parts)
    if len(signs) == 2 and "=" not in signs and signs[0][0] == signs[1][0] and _is_label(sides[1]):
        low_first = signs[0][0] == "<"
        ends = [sides[0], sides[2]] if low_first else [sides[2], sides[0]]
        return sides[1], tuple(signs if low_first else (_turned(s) for s in reversed(signs))), ends
    if len(signs) == 1:
        if _is_label(sides[0]):
            return sides[0], (signs[0],), [sides[1]]
        if _is_label(sides[1]):
            return sides[1], (_turned(signs[0]),), [sides[0]]
    return _two_bounds(text)


def _labelled(sides: list[str], n_parts: int) -> tuple[str, tuple[str, ...], list[str]]:
    if not _is_label(sides[0]):
        raise ExpressionError(Message("write the answer alone, or after a name and =, as v = ..."))
    return sides[0], ("=",), _components(sides[1], n_parts)


def _each_labelled(text: str, n_parts: int) -> list[str]:
    """The components of a list in which each has its name: w1 = ..., w2 = ...; nothing for any other text."""
    for parts in (_split(text, ";", keeps_decimals=True), _split(text, ",", keeps_decimals=True), _AND.split(text)):
        sides = [part.split("=") for part in parts]
        if len(parts) == n_parts and all(len(s) == 2 and _is_label(s[0].strip()) for s in sides):
            return [s[1].strip() for s in sides]
    return []


def _two_bounds(text: str) -> tuple[str, tuple[str, ...], list[str]]:
    """F >= a and F <= b."""
    halves = _AND.split(text)
    if len(halves) == 2 and all(len(_RELATION.findall(half)) == 1 for half in halves):
        bounds: dict[str, tuple[str, str]] = {}
        label = ""
        for half in halves:
            label, (sign,), (bound,) = _apart(half.strip(), 1)
            bounds[sign[0]] = sign, bound
        if bounds.keys() == {"<", ">"}:
            return label, (_turned(bounds[">"][0]), bounds["<"][0]), [bounds[">"][1], bounds["<"][1]]
    raise ExpressionError(Message("write one answer, as v = ..., or an interval, as a <= F <= b"))


def _same(sign: str) -> str:
    return {":=": "=", "==": "=", "≈": "=", "=<": "<=", "=>": ">="}.get(sign, sign)


def _turned(sign: str) -> str:
    return {"<": ">", ">": "<", "<=": ">=", ">=": "<="}[sign]


def _is_label(text: str) -> bool:
    return _LABEL.fullmatch(text) is not None and not re.match(r"[\d(\[|]", text) and len(text.split()) <= 4


def _components(text: str, n_parts: int) -> list[str]:
    """The texts of the components: between brackets, or beside each other where several are asked for."""
    found = _LIST.fullmatch(text)
    inside = found["inside"] if found is not None and _is_one_bracket(text) else None
    if inside is None:
        if n_parts == 1:
            return [text]
        inside = text
    for sign, is_decimal in ((";", True), (",", False), (", ", True)):
        parts = _split(inside, sign, keeps_decimals=is_decimal)
        if len(parts) == max(n_parts, 2):
            return parts
    if n_parts > 1 and len(parts := _AND.split(inside)) == n_parts:
        return parts
    parts = _split(inside, ";", keeps_decimals=True)
    parts = _split(inside, ",", keeps_decimals=True) if len(parts) == 1 else parts
    return parts if len(parts) > 1 else [text]


def _is_one_bracket(text: str) -> bool:
    """Whether the first bracket closes at the end."""
    level = 0
    is_open_interval = text[0] == "]" or text[-1] == "["
    for k, letter in enumerate(text):
        level += (letter in "([{") - (letter in ")]}")
        if level == 0 and not is_open_interval:
            return k == len(text) - 1
    return is_open_interval


def _split(text: str, sign: str, *, keeps_decimals: bool) -> list[str]:
    """At a sign that stands in no bracket."""
    if sign == "," and keeps_decimals:
        text = _DECIMAL_COMMA.sub("\0", text)
    parts, level, k = [""], 0, 0
    while k < len(text):
        level += (text[k] in "([{") - (text[k] in ")]}")
        if level == 0 and text.startswith(sign, k):
            parts.append("")
            k += len(sign)
            continue
        parts[-1] += text[k]
        k += 1
    return [part.replace("\0", ",").strip() for part in parts]


# -- one component ----------------------------------------------------------------------------
@dataclass(frozen=True)
class _Part:
    """A component: the expressions that it may be, and the number with a unit. is_number: whether only that makes
    sense."""

    exprs: tuple[Expr, ...]
    quantity: TypedNumber | None
    is_number: bool


def _part(text: str, vocabulary: Vocabulary) -> _Part:
    """Raises ExpressionError for what is neither."""
    quantity = _quantity(text, vocabulary)
    try:
        exprs = tuple(readings(text, vocabulary))
    except ExpressionError:
        if quantity is None:
            raise
        return _Part((), quantity, is_number=True)
    named = free_symbols(exprs[0])
    return _Part(exprs, quantity, is_number=quantity is not None and not (named and named <= vocabulary.names))


def _quantity(text: str, vocabulary: Vocabulary) -> TypedNumber | None:
    """A number with or without a unit: 24.1 N, 1,78 m/s², 2*pi s, 3*10^2."""
    for head, unit in _cuts(text):
        try:
            expr = readings(head, vocabulary)[0]
            if free_symbols(expr):
                continue
            value = float(evaluate(expr, {}))
            known = _PERCENT if unit == "%" else parse_unit(_spelt(unit), with_rare=False)
        except (ExpressionError, UnitError, ArithmeticError, ValueError, TypeError):
            continue
        si = value * float(known.factor) * 3.141592653589793**known.pi_power
        return TypedNumber(si, known.dimension, bool(unit), _n_digits(head), text, unit)
    return None


def _cuts(text: str) -> Iterator[tuple[str, str]]:
    """Head and unit: after a plain number, else before each of the last words."""
    found = _QUANTITY.fullmatch(text)
    if found is not None:
        yield found["number"], (found["unit"] or "").strip().removeprefix("[").removesuffix("]")
        return
    yield text, ""
    places = [m.start() for m in re.finditer(r"(?<![A-Za-z_])[A-Za-zµ°]", text)]
    for place in places[:6]:
        if place and text[place - 1] in " )0123456789°":
            yield text[:place].strip(), text[place:].strip()


def _spelt(unit: str) -> str:
    for pattern, replacement in _SPELT_UNITS:
        unit = pattern.sub(replacement, unit)
    unit = re.sub(r"(?<=[A-Za-z])(?=[2-4]\b)", "^", unit)  # m/s2
    return unit.replace("'", "")


def _n_digits(head: str) -> int | None:
    """Significant digits of a plain decimal number; None for what is exact."""
    found = re.fullmatch(r"[+-]?\s*0*([.,]?)0*([0-9]*)[.,]?([0-9]*)(?:[eE*].*)?", head.strip())
    if found is None:
        return None
    digits = re.sub(r"[eE*].*", "", head)
    plain = re.sub(r"[^0-9]", "", digits).lstrip("0")
    return max(len(plain), 1)


# -- equations --------------------------------------------------------------------------------
def read_equations(text: str, vocabulary: Vocabulary) -> list[tuple[Expr, Expr]]:
    """The equations of a text, one a line or between semicolons, as left and right sides. Raises ExpressionError."""
    if len(text) > MAX_CHARACTERS:
        raise ExpressionError(
            Message("an answer may have {most} characters, this one has {n}", most=MAX_CHARACTERS, n=len(text))
        )
    lines = [line for line in re.split(r"[;\n]|\\\\", text) if line.strip()]
    found = [read_equation(line, vocabulary) for line in lines[:MOST_EQUATIONS]]
    if not found:
        raise ExpressionError(Message("the answer is empty"))
    return found


def read_equation(line: str, vocabulary: Vocabulary) -> tuple[Expr, Expr]:
    """One equation, as its sides. Raises ExpressionError."""
    if len(line) > MAX_CHARACTERS:
        raise ExpressionError(
            Message("an answer may have {most} characters, this one has {n}", most=MAX_CHARACTERS, n=len(line))
        )
    plain = _with_rates(normalized(plain_of_latex(line) if is_latex(line) else line).strip().rstrip(".,"))
    sides = re.split(r":=|==|=", plain)
    if len(sides) != 2 or not all(side.strip() for side in sides):
        raise ExpressionError(Message("'{line}' is not one equation: write left = right", line=plain[:60]))
    left, right = (readings(side.strip(), vocabulary)[0] for side in sides)
    return left, right
