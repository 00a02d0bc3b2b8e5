r"""LaTeX mathematics in plain notation, by a grammar of its own.

    formula = {item}
    item    = "{" formula "}" | command {argument} | "^" argument | "_" argument | character
    command = \frac | \sqrt | \dot | \sin | \theta | \left( ...     a list of known ones: nothing is looked up or run

\frac{a}{b} is ((a)/(b)), \dot{x}_1 is x_1', a matrix of one row or column is [a; b].
"""

from __future__ import annotations

import re

from freebody.errors import ExpressionError
from freebody.language.parser import GREEK
from freebody.language.sentences import Message

MAX_NESTING = 30
_TOKEN = re.compile(r"\\(?:[A-Za-z]+\*?|.)|\{,\}|[{}^_&~$]|\s+|[^\\{}^_&~$\s]", re.S)

_WORDS = {
    **{name: f" {name} " for name in GREEK.values()},
    **{"lambda": " lam ", "varphi": " phi ", "vartheta": " theta ", "varepsilon": " epsilon ", "varrho": " rho "},
    **{name: f" {name} " for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "ln", "cot", "sec")},
    **{"arcsin": " asin ", "arccos": " acos ", "arctan": " atan ", "csc": " csc ", "tg": " tan "},
}
_SIGNS = {
    **dict.fromkeys(("cdot", "times", "ast", "cdotp", "*"), "*"),
    **{"div": "/", "le": "<=", "leq": "<=", "leqslant": "<=", "ge": ">=", "geq": ">=", "geqslant": ">="},
    **{"lt": "<", "gt": ">", "approx": "≈", "pm": "±", "in": "∈", "infty": "∞", "degree": "°", "circ": "°"},
    **{"lvert": "|", "rvert": "|", "vert": "|", "mid": "|", "{": "(", "}": ")", "lbrack": "[", "rbrack": "]"},
    **{"land": " and ", "wedge": " and ", "%": "%", "prime": "'", "langle": "(", "rangle": ")", "to": "→"},
}
_SPACES = frozenset({",", ";", ":", "!", " ", "quad", "qquad", "thinspace", "displaystyle", "textstyle", "limits"})
_SIZES = frozenset(
    {"left", "right", "big", "Big", "bigg", "Bigg", "bigl", "bigr", "Bigl", "Bigr", "middle", "nolimits"}
)
_PLAIN_TEXT = frozenset(
    (
        *("mathrm", "text", "mathit", "mathbf", "boldsymbol", "bm", "vec", "operatorname", "operatorname*", "textrm"),
        *("hat", "bar", "overline", "underline", "mathsf", "unit", "si", "textit"),
    )
)
_DOTS = {"dot": 1, "ddot": 2, "dddot": 3}
_FRACTIONS = frozenset({"frac", "dfrac", "tfrac", "cfrac", "nicefrac", "sfrac"})
_MATRICES = frozenset({"pmatrix", "bmatrix", "matrix", "Bmatrix", "array", "vmatrix", "smallmatrix"})


def is_latex(text: str) -> bool:
    """Whether a text is LaTeX: plain notation has no backslash and no dollar."""
    return "\\" in text or "$" in text


def plain_of_latex(text: str) -> str:
    """LaTeX in the notation of the grammar. Raises ExpressionError for a command that is not known."""
    return _Latex(_TOKEN.findall(text)).whole()


class _Latex:
    def __init__(self, tokens: list[str]) -> None:
        self._tokens = [t for t in tokens if t != "$"]
        self._at = 0
        self._nesting = 0

    @property
    def _now(self) -> str:
        return self._tokens[self._at] if self._at < len(self._tokens) else ""

    def _take(self) -> str:
        token = self._now
        self._at += 1
        return token

    def whole(self) -> str:
        text = self._formula("")
        if self._now:
            raise ExpressionError(Message("'{x}' is not expected here", x=self._now))
        return re.sub(r" +_\{", "_{", text)

    def _formula(self, end: str) -> str:
        """Items up to a token, which is left."""
        self._nesting += 1
        if self._nesting > MAX_NESTING:
            raise ExpressionError(Message("brackets nest more than {most} deep", most=MAX_NESTING))
        parts: list[str] = []
        while self._now and self._now not in (end, "}"):
            parts.append(self._item())
        self._nesting -= 1
        return "".join(parts)

    def _item(self) -> str:
        token = self._take()
        if token == "{":
            return f"({self._closed()})"
        if token == "{,}":
            return ","
        if token == "^":
            return self._superscript()
        if token == "_":
            return f"_{{{self._letters(self._argument())}}}"
        if token == "&":
            return ";"
        if token == "~" or token.isspace():
            return " "
        if token.startswith("\\"):
            return self._command(token[1:])
        return token

    def _closed(self) -> str:
        """What stands up to the brace that closes."""
        inside = self._formula("}")
        if self._take() != "}":
            raise ExpressionError(Message("this bracket is never closed"))
        return inside

    def _argument(self) -> str:
        """One token or a group, without its braces."""
        while self._now.isspace():
            self._take()
        if not self._now:
            raise ExpressionError(Message("the expression ends where a number, name or bracket is needed"))
        if self._now == "{":
            self._take()
            return self._closed()
        return self._item()

    def _superscript(self) -> str:
        raised = self._argument().strip()
        if raised in ("°", "'", "''"):
            return raised
        return f"^({raised})"

    def _letters(self, text: str) -> str:
        """An index: letters and digits, whatever stands between."""
        letters = re.sub(r"[^A-Za-z0-9]", "", text)
        if not letters:
            raise ExpressionError(Message("an index has letters and digits"))
        return letters

    # -- commands -----------------------------------------------------------------------------
    def _command(self, name: str) -> str:
        if name in _WORDS:
            return _WORDS[name]
        if name in _SIGNS:
            return _SIGNS[name]
        if name in _SPACES:
            return " "
        if name in _SIZES:
            if self._now == ".":
                self._take()
            return ""
        if name in "()[]" or name == "\\":
            return "" if name != "\\" else ";"
        if name in _FRACTIONS:
            above = self._argument()
            return f"(({above})/({self._argument()}))"
        if name == "sqrt":
            return self._root()
        if name in _DOTS:
            return self._dotted(_DOTS[name])
        if name in _PLAIN_TEXT:
            return self._argument()
        if name in ("begin", "end"):
            return self._matrix(name)
        raise ExpressionError(Message("\\{name} cannot be read in an answer", name=name[:30]))

    def _root(self) -> str:
        degree = ""
        if self._now == "[":
            self._take()
            degree = self._formula("]")
            self._take()
        radicand = self._argument()
        return f"(({radicand})^(1/({degree})))" if degree else f" sqrt({radicand})"

    def _dotted(self, n: int) -> str:
        name, index = self._argument().strip(), ""
        if self._now == "_":
            self._take()
            index = f"_{{{self._letters(self._argument())}}}"
        return f" {name}{index}{chr(39) * n} "

    def _matrix(self, what: str) -> str:
        kind = self._argument()
        if kind not in _MATRICES:
            raise ExpressionError(Message("\\{name} cannot be read in an answer", name=f"{what}{{{kind[:20]}}}"))
        if kind == "array" and what == "begin" and self._now == "{":
            self._argument()
        return "[" if what == "begin" else "]"
