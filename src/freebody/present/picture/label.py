"""Labels: words, or symbols with an index, as runs of letters and as LaTeX."""

from __future__ import annotations

import re
from dataclasses import dataclass

from freebody.errors import ExpressionError
from freebody.language.expression import Expr, Symbol
from freebody.language.notation import to_latex
from freebody.language.notation.one_line import IN_FIGURES
from freebody.language.notation.parts import spaced_index
from freebody.language.parser import parse

_PART = re.compile(
    r"(?P<name>[^\W\d_₀-₉⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)(?P<index>(?:_\w+|[₀-₉]+)?)(?P<dots>'*)|(?P<power>[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)|(?P<rest>.)"
)
_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789-0123456789")
_LOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_RELATIONS = {"<=": "\u2264", ">=": "\u2265", "=": "="}
_WORDS = re.compile(r"[^\W\d]\w* [^\W\d]|^[\d.]+ [^\W\d]")  # `angle of rod`, `2 N`
_FUNCTIONS = frozenset(("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "log", "abs", "sign"))
_GLYPHS = {"·": "\u2009", "-": "\u2212", "'": "\u2032"}
_DOTS = {1: "\u0307", 2: "\u0308"}  # above one letter, as on paper; primes behind several
_SMALL = 0.72  # of an index
_SIGNS = frozenset("=+\u2212<>\u2264\u2265")
_NARROW, _WIDE = frozenset("ijltfrI.,:;'|()[]/ "), frozenset("mwMW")


@dataclass(frozen=True)
class Run:
    """Letters of one kind; level -1 is an index, +1 an exponent."""

    text: str
    is_italic: bool = False
    level: int = 0

    @property
    def width(self) -> float:
        """In heights of letters, roughly."""
        return (1.0 if self.level == 0 else _SMALL) * sum(map(_width, self.text))


@dataclass(frozen=True)
class Label:
    """latex: mathematics, without dollars; empty for words."""

    runs: tuple[Run, ...]
    latex: str = ""

    @property
    def width(self) -> float:
        """In heights of letters, roughly."""
        return sum(run.width for run in self.runs)

    @property
    def text(self) -> str:
        """For those who read it aloud."""
        return "".join(("_" if run.level < 0 else "") + run.text for run in self.runs)

    @property
    def on_one_line(self) -> str:
        """Where nothing stands lower than the rest: an index of digits has letters of its own, m₁ g."""
        return "".join(run.text.translate(_LOW) if _is_number(run) else Label((run,)).text for run in self.runs)


def _is_number(run: Run) -> bool:
    return run.level < 0 and run.text.isascii() and run.text.isdigit()


def words(text: str) -> Label:
    """Plain words, such as the name of a body."""
    return Label((Run(text),))


def formula(expr: Expr) -> Label:
    """An expression on one line."""
    return Label(tuple(_runs(IN_FIGURES.write(expr)[0])), to_latex(expr))


def name(text: str) -> Label:
    """A symbol by its name: F_t, theta1."""
    return formula(Symbol(text))


def equation(text: str) -> Label:
    """An equation or an inequality in the notation of a model; sides that are no formula are words."""
    left, sign, right = next((parts for s in _RELATIONS if (parts := text.partition(f" {s} "))[1]), (text, "", ""))
    if not sign:
        return _side(text)
    return beside(_side(left), _side(right), f" {_RELATIONS[sign.strip()]} ")


def _side(text: str) -> Label:
    try:
        return words(text) if _WORDS.search(text) else formula(parse(text))
    except ExpressionError:
        return words(text)


def beside(first: Label, second: Label, between: str = "") -> Label:
    """Two labels in one, as in `2 T`, `F = 3 N`."""
    parts = (first.latex or _as_text(first.text), _as_text(between), second.latex or _as_text(second.text))
    joint = (Run(between),) if between else ()
    return Label((*first.runs, *joint, *second.runs), " ".join(part for part in parts if part))


def _as_text(text: str) -> str:
    text = text.replace("\u2264", r"\leq").replace("\u2265", r"\geq")
    return rf"\text{{{text}}}" if text.strip(" =\u2009") and "\\" not in text else text.strip()


def _runs(text: str) -> list[Run]:
    found: list[Run] = []
    for part in _PART.finditer(text):
        letters, index, dots = part["name"], part["index"], part["dots"]
        if letters:
            above = _DOTS.get(len(dots), "") if len(letters) == 1 else ""
            found.append(Run(letters + above, is_italic=letters not in _FUNCTIONS))
            found.extend([Run("\u2032" * len(dots))] if dots and not above else [])
            if index:
                inner = spaced_index(index.removeprefix("_").translate(_DIGITS))
                found.append(Run(inner, is_italic=len(inner) == 1 and inner.isalpha(), level=-1))
        elif part["power"]:
            found.append(Run(part["power"].translate(_DIGITS).replace("-", "\u2212"), level=1))
        else:
            found.append(Run(_GLYPHS.get(part["rest"], part["rest"])))
    return _joined(found)


def _joined(runs: list[Run]) -> list[Run]:
    """Neighbours of one kind in one run."""
    joined: list[Run] = []
    for run in runs:
        if joined and (joined[-1].is_italic, joined[-1].level) == (run.is_italic, run.level):
            joined[-1] = Run(joined[-1].text + run.text, run.is_italic, run.level)
        else:
            joined.append(run)
    return joined


def _width(letter: str) -> float:
    if letter == "\u2009":
        return 0.17
    if letter in _DOTS.values():
        return 0.0
    if letter in _NARROW:
        return 0.33
    if letter in _SIGNS:
        return 0.78
    return 0.88 if letter in _WIDE else 0.7 if letter.isupper() else 0.54
