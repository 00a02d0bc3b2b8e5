"""Written formulas read back, each format by the rules of its own language: what is printed, as a number.

Nothing here knows how the writers work. Every reader turns a text into one of Python's and evaluates that; `known` are
the written names with their values.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from xml.etree import ElementTree

from scipy.special import ellipk, ellipkinc, fresnel

Known = Mapping[str, float]
_FUNCTIONS = {
    **{
        name: getattr(math, name)
        for name in ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "log")
    },
    **{"arcsin": math.asin, "arccos": math.acos, "arctan": math.atan, "exp": math.exp, "sqrt": math.sqrt, "abs": abs},
    **{"sign": lambda x: math.copysign(1.0, x)},
    **dict.fromkeys(("elliptic_K", "K"), lambda k: ellipk(k * k)),
    **dict.fromkeys(("fresnel_c", "C"), lambda x: float(fresnel(x)[1])),
    **dict.fromkeys(("fresnel_s", "S"), lambda x: float(fresnel(x)[0])),
    **dict.fromkeys(("elliptic_F", "F"), lambda *given: _first_kind(*(given if len(given) == 2 else given[0]))),
}
_RAISED = {c: str(k) for k, c in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")} | {"⁻": "-"}


def _first_kind(phi: float, k: float) -> float:
    return float(ellipkinc(phi, k * k))


class Unreadable(AssertionError):
    """The text is no formula of its format."""


def value_of(python: str, names: Mapping[str, float]) -> float:
    return float(eval(python, {"__builtins__": {}}, {**_FUNCTIONS, "pi": math.pi, "e": math.e, **names}))


class _Names:
    """Names of a format as identifiers of Python's."""

    def __init__(self, known: Known) -> None:
        self.texts = sorted(known, key=len, reverse=True)
        self.values = {f"v{k}": known[text] for k, text in enumerate(self.texts)}

    def at(self, text: str, place: int) -> tuple[str, int] | None:
        """The longest name that stands there, and where it ends."""
        for k, name in enumerate(self.texts):
            if not text.startswith(name, place):
                continue
            following = text[place + len(name) : place + len(name) + 1]
            goes_on = following == "_" or (following.isalnum() and following not in _RAISED)
            if not (name[-1].isalpha() and goes_on):
                return f"v{k}", place + len(name)
        return None


def _closing_bar(row: str, opening: int) -> int:
    """Where the bar at a column is closed: a bar opens where a value is due, and closes behind one."""
    n_open, is_due = 0, True
    for column in range(opening, len(row)):
        character = row[column]
        if character == "|":
            n_open += 1 if is_due else -1
            if n_open == 0:
                return column
        elif character != " ":
            is_due = character in "+-*/^·⋅(,"
    raise Unreadable(f"a bar is not closed in {row!r}")


# -- one line and stacked lines ---------------------------------------------------------------
def line(text: str, known: Known) -> float:
    """A formula on one line of Unicode."""
    return stacked([text], known, 0)


def stacked(lines: list[str], known: Known, baseline: int) -> float:
    """A formula drawn over several lines, of which one stands beside other text."""
    width = max(map(len, lines))
    names = _Names(known)
    return value_of(_Drawing([row.ljust(width) for row in lines], names).read(baseline), names.values)


class _Drawing:
    """A rectangle of characters: fractions over bars, exponents above what they raise, tall brackets, drawn roots."""

    def __init__(self, rows: list[str], names: _Names) -> None:
        self.rows = rows
        self.names = names

    def part(self, top: int, bottom: int, left: int, right: int) -> _Drawing:
        rows = [row[left:right] for row in self.rows[top:bottom]]
        while rows and not rows[0].strip():
            rows = rows[1:]
        while rows and not rows[-1].strip():
            rows = rows[:-1]
        if not rows:
            raise Unreadable("there is nothing where a part of a formula should be")
        blank = min(len(row) - len(row.lstrip()) for row in rows if row.strip())
        return _Drawing([row[blank:] for row in rows], self.names)

    def inside(self) -> str:
        return self.read(self.baseline())

    def baseline(self) -> int:
        """The line on which the first piece stands."""
        first = [row[:1] for row in self.rows]
        bars = [len(row) - len(row.lstrip("─")) for row in self.rows]
        if any(bars):
            longest = [k for k, n in enumerate(bars) if n == max(bars)]
            if len(longest) > 1:
                raise Unreadable("two bars of one length: which fraction is the outer one?")
            return longest[0]
        if "╲" in first:
            bottom = first.index("╲")
            height = self._root_height(bottom, 0)
            argument = self.part(
                bottom - height + 1, bottom + 1, height + 1, self._overline(bottom - height, height + 1)
            )
            top = next(k for k in range(bottom - height + 1, bottom + 1) if self.rows[k][height + 1 :].strip())
            return top + argument.baseline()
        for opening in "⎛│":
            if opening in first:
                top, bottom = self._tall(0, first.index(opening))
                return top + self.part(top, bottom, 1, self._closing(0, top, bottom)).baseline()
        return next(k for k, c in enumerate(first) if c.strip())

    def read(self, baseline: int) -> str:
        """Python's text, piece by piece from the left."""
        text, column, width = "", 0, len(self.rows[0])
        while column < width:
            piece, end, top = self._piece(baseline, column)
            if piece.strip() and piece[-1] not in "+-*/(^ ":
                exponent_end = self._exponent_end(baseline, end, top)
                if exponent_end:
                    above = self.part(0, top, end, exponent_end).inside()
                    piece, end = f"{piece}**({above})", exponent_end
            text += piece
            column = end
        return text

    def _piece(self, baseline: int, column: int) -> tuple[str, int, int]:
        """What begins in a column: its text, the column behind it, the first line that it takes."""
        row = self.rows[baseline]
        character = row[column]
        if character == "─":
            right = column + len(row[column:]) - len(row[column:].lstrip("─"))
            above = self.part(0, baseline, column, right).inside()
            below = self.part(baseline + 1, len(self.rows), column, right).inside()
            top = next(k for k, line in enumerate(self.rows) if line[column:right].strip())
            return f"(({above})/({below}))", right, top
        in_column = [line[column] for line in self.rows]
        if "╲" in in_column:
            bottom = in_column.index("╲")
            height = self._root_height(bottom, column)
            left = column + height + 1
            right = self._overline(bottom - height, left)
            inner = self.part(bottom - height + 1, bottom + 1, left, right).inside()
            return f"sqrt({inner})", right, bottom - height
        if character in "⎛⎜⎝" or (character == "│"):
            top, bottom = self._tall(column, baseline)
            right = self._closing(column, top, bottom)
            inner = self.part(top, bottom, column + 1, right).inside()
            return ("abs" if character == "│" else "") + f"({inner})", right + 1, top
        if character == "|":
            right = _closing_bar(row, column)
            return f"abs({self.part(baseline, baseline + 1, column + 1, right).inside()})", right + 1, baseline
        found = self.names.at(row, column)
        if found is not None:
            return found[0], found[1], baseline
        number = re.compile(r"\d+(\.\d+)?(e-?\d+)?").match(row, column)
        if number:
            return number[0], number.end(), baseline
        raised = re.compile("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+").match(row, column)
        if raised:
            return "**(" + "".join(_RAISED[c] for c in raised[0]) + ")", raised.end(), baseline
        word = re.compile(r"π|[a-z]+|[CFKS](?=[(⎛⎜⎝])").match(row, column)
        if word and (word[0] in _FUNCTIONS or word[0] == "π"):
            return {"π": "pi"}.get(word[0], word[0]), word.end(), baseline
        plain = {"·": "*", "⋅": "*", "^": "**", "√": "sqrt"}.get(character, character)
        if plain not in ("*", "**", "sqrt", "/", "+", "-", "(", ")", ",", " "):
            raise Unreadable(f"what is {character!r} in {row!r}?")
        return plain, column + 1, baseline

    def _exponent_end(self, baseline: int, column: int, top: int) -> int:
        """Where an exponent ends that begins there above `top`; 0 without one."""
        if column >= len(self.rows[0]) or not any(row[column].strip() for row in self.rows[:top]):
            return 0
        end = column
        while end < len(self.rows[0]) and all(row[end] == " " for row in self.rows[top:]):
            end += 1
        if end < len(self.rows[0]) and self.rows[baseline][end] in "+-" and not self.rows[0][end].strip():
            end -= 1  # the space before an operator
        return end if end > column else 0

    def _tall(self, column: int, row: int) -> tuple[int, int]:
        """The first line of a tall bracket and the one behind its last."""
        signs = "│" if self.rows[row][column] == "│" else "⎛⎜⎝"
        top = bottom = row
        while top > 0 and self.rows[top - 1][column] in signs and self.rows[top][column] != "⎛":
            top -= 1
        while (
            bottom + 1 < len(self.rows) and self.rows[bottom + 1][column] in signs and self.rows[bottom][column] != "⎝"
        ):
            bottom += 1
        return top, bottom + 1

    def _closing(self, column: int, top: int, bottom: int) -> int:
        """The column of the bracket that closes another one of the same height."""
        if self.rows[top][column] == "│":
            full = [
                k for k in range(column + 1, len(self.rows[0])) if all(row[k] == "│" for row in self.rows[top:bottom])
            ]
            return full[0]
        depth = 0
        for k in range(column, len(self.rows[0])):
            depth += {"⎛": 1, "⎞": -1}.get(self.rows[top][k], 0)
            if depth == 0:
                return k
        raise Unreadable("a bracket stays open")

    def _root_height(self, bottom: int, column: int) -> int:
        height = 0
        while bottom - height >= 0 and self.rows[bottom - height][column + 1 + height : column + 2 + height] == "╱":
            height += 1
        return height

    def _overline(self, row: int, column: int) -> int:
        text = self.rows[row][column:]
        return column + len(text) - len(text.lstrip("_"))


# -- LaTeX ------------------------------------------------------------------------------------
def latex(text: str, known: Known) -> float:
    r"""Mathematics of LaTeX: \frac, \sqrt, braces, growing brackets, factors side by side."""
    names = _Names(known)
    return value_of(_Latex(text, names).all(), names.values)


class _Markup:
    """A reader of formulas in one line of markup: sums of products of powers."""

    times: tuple[str, ...] = ()
    minus: tuple[str, ...] = ("-",)

    def __init__(self, text: str, names: _Names) -> None:
        self.text, self.place, self.names = text, 0, names

    def all(self) -> str:
        found = self.sum()
        if self.space() < len(self.text):
            raise Unreadable(f"{self.text[self.place :]!r} is left of {self.text!r}")
        return found

    def space(self) -> int:
        while self.text[self.place : self.place + 1].isspace():
            self.place += 1
        return self.place

    def took(self, *signs: str) -> str:
        self.space()
        for sign in signs:
            if self.text.startswith(sign, self.place):
                self.place += len(sign)
                return sign
        return ""

    def must(self, sign: str) -> None:
        if not self.took(sign):
            raise Unreadable(f"{sign!r} is missing at {self.text[self.place :]!r} in {self.text!r}")

    def sum(self) -> str:
        found = "-" if self.took(*self.minus) else ""
        found += self.product()
        while sign := self.took("+", *self.minus):
            found += (" + " if sign == "+" else " - ") + self.product()
        return found

    def product(self) -> str:
        factors = [self.factor()]
        while True:
            before = self.space()
            if self.took(*self.times):
                factors.append(self.factor())
                continue
            follows = self.follows()
            if not follows:
                return "*".join(factors)
            if factors and self.text[before].isdigit() and factors[-1][-1].isdigit():
                raise Unreadable(f"two numbers side by side in {self.text!r}")
            factors.append(self.factor())

    def follows(self) -> bool:
        raise NotImplementedError

    def atom(self) -> str:
        raise NotImplementedError

    def factor(self) -> str:
        base = self.atom()
        if self.took("^"):
            base = f"({base})**({self.group()})"
        return base

    def group(self) -> str:
        raise NotImplementedError

    def number(self) -> str:
        found = re.compile(r"\d+(\.\d+)?").match(self.text, self.space())
        if found is None:
            return ""
        self.place = found.end()
        return found[0]

    def name(self) -> str:
        found = self.names.at(self.text, self.space())
        if found is None:
            return ""
        self.place = found[1]
        return found[0]

    def arguments(self) -> str:
        """One or two, up to the bracket that closes."""
        found = self.sum()
        return f"{found}, {self.sum()}" if self.took(",") else found

    def applied(self, function: str) -> str:
        """sin^2 x is (sin x)^2."""
        exponent = f"**({self.group()})" if self.took("^") else ""
        argument = self.atom()
        return f"({function}({argument}){exponent})"


class _Latex(_Markup):
    times = (r"\cdot",)

    def follows(self) -> bool:
        rest = self.text[self.space() :]
        return bool(rest) and not rest.startswith((r"\right", "+", "-", "}", ")", "&", ",", r"\\"))

    def group(self) -> str:
        self.must("{")
        found = self.sum()
        self.must("}")
        return found

    def atom(self) -> str:
        if found := self.name() or self.number():
            return found
        if self.took(r"\frac"):
            return f"(({self.group()})/({self.group()}))"
        if self.took(r"\sqrt"):
            return f"sqrt({self.group()})"
        if letter := self.took(*(rf"{name}\!\left(" for name in "CFKS")):
            found = self.arguments()
            self.must(r"\right)")
            return f"{letter[0]}({found})"
        if self.took(r"\left(", "("):
            found = self.sum()
            self.took(r"\right")
            self.must(")")
            return f"({found})"
        if bar := self.took(r"\left|", r"\left\vert"):
            found = self.sum()
            self.must(bar.replace("left", "right"))
            return f"abs({found})"
        if self.took(r"\pi"):
            return "pi"
        if self.took("e"):
            return "e"
        command = re.compile(r"\\(?:operatorname\{(\w+)\}|(\w+))").match(self.text, self.space())
        if command and (command[1] or command[2]) in _FUNCTIONS:
            self.place = command.end()
            return self.applied(command[1] or command[2])
        raise Unreadable(f"what is {self.text[self.place :]!r} in {self.text!r}?")


# -- Typst ------------------------------------------------------------------------------------
def typst(text: str, known: Known) -> float:
    """Mathematics of Typst: frac(a, b), sqrt(a), x^(2), factors side by side."""
    names = _Names(known)
    return value_of(_Typst(text, names).all(), names.values)


class _Typst(_Markup):
    times = ("⋅",)

    def follows(self) -> bool:
        rest = self.text[self.space() :]
        return bool(rest) and rest[0] not in "+-),"

    def group(self) -> str:
        self.must("(")
        found = self.sum()
        self.must(")")
        return found

    def atom(self) -> str:
        if found := self.name() or self.number():
            return found
        for word in ("frac", "sqrt", "abs"):
            if self.took(word + "("):
                found = self.sum()
                if word == "frac":
                    self.must(",")
                    found = f"({found})/({self.sum()})"
                self.must(")")
                return f"({found})" if word == "frac" else f"{word}({found})"
        if self.took("("):
            found = self.sum()
            self.must(")")
            return f"({found})"
        if self.took("π"):
            return "pi"
        if letter := self.took(*(f"{name}(" for name in "CFKS")):
            found = self.arguments()
            self.must(")")
            return f"{letter[0]}({found})"
        word = re.compile(r'op\("(\w+)"\)|(\w+)').match(self.text, self.space())
        if word and (word[1] or word[2]) in _FUNCTIONS:
            self.place = word.end()
            return self.applied(word[1] or word[2])
        if self.took("e"):
            return "e"
        raise Unreadable(f"what is {self.text[self.place :]!r} in {self.text!r}?")


# -- MathML -----------------------------------------------------------------------------------
_NAMESPACE = re.compile(r"\sxmlns=\"[^\"]*\"")


def mathml(text: str, known: Known) -> float:
    """Elements of presentation MathML. known: elements of names."""
    root = ElementTree.fromstring(f"<math>{text}</math>")
    flat = {_flat(ElementTree.fromstring(f"<math>{name}</math>")): value for name, value in known.items()}
    names = {f"v{k}": value for k, value in enumerate(flat.values())}
    return value_of(_elements(list(root), {text: f"v{k}" for k, text in enumerate(flat)}), names)


def _flat(root: ElementTree.Element) -> str:
    return "".join(ElementTree.tostring(child, encoding="unicode") for child in root)


def _elements(children: list[ElementTree.Element], names: Mapping[str, str]) -> str:
    """A row of elements: factors stand side by side, a function before its argument."""
    text, k, is_factor = "", 0, False
    while k < len(children):
        child = children[k]
        content = (child.text or "").strip()
        if child.tag == "mspace" or (child.tag == "mo" and content in ("\u2062", "\u2061")):
            k += 1
            continue
        if child.tag == "mo" and content in ("+", "−", "⋅", ","):
            text += {"+": " + ", "−": " - ", "⋅": "*", ",": ", "}[content]
            k, is_factor = k + 1, False
            continue
        function, exponent = _function(child, names)
        if function:
            following = next(j for j in range(k + 1, len(children)) if _is_operand(children[j]))
            piece, k = f"({function}({_element(children[following], names)}){exponent})", following + 1
        else:
            piece, k = _element(child, names), k + 1
        text += ("*" if is_factor else "") + piece
        is_factor = True
    return text


def _is_operand(child: ElementTree.Element) -> bool:
    return child.tag not in ("mspace", "mo")


def _function(child: ElementTree.Element, names: Mapping[str, str]) -> tuple[str, str]:
    """sin, or sin^2."""
    if child.tag == "mi" and child.text in _FUNCTIONS and ElementTree.tostring(child, encoding="unicode") not in names:
        return str(child.text), ""
    if child.tag == "msup" and child[0].tag == "mi" and child[0].text in _FUNCTIONS:
        return str(child[0].text), f"**({_element(child[1], names)})"
    return "", ""


def _element(child: ElementTree.Element, names: Mapping[str, str]) -> str:
    own = ElementTree.tostring(child, encoding="unicode")
    if own in names:
        return names[own]
    parts = list(child)
    match child.tag:
        case "mn":
            return str(child.text)
        case "mi":
            found = {"π": "pi", "e": "e"}.get(str(child.text))
            if found is None:
                raise Unreadable(f"what is {own}?")
            return found
        case "mfrac":
            return f"(({_element(parts[0], names)})/({_element(parts[1], names)}))"
        case "msqrt":
            return f"sqrt({_elements(parts, names)})"
        case "msup":
            return f"(({_element(parts[0], names)})**({_element(parts[1], names)}))"
        case "msubsup":
            letter, index = (ElementTree.tostring(p, encoding="unicode") for p in parts[:2])
            return f"({names[f'<msub>{letter}{index}</msub>']}**({_element(parts[2], names)}))"
        case "mrow":
            if parts and parts[0].tag == "mo" and parts[0].text in ("(", "|") and parts[-1].text in (")", "|"):
                return ("abs" if parts[0].text == "|" else "") + f"({_elements(parts[1:-1], names)})"
            return f"({_elements(parts, names)})"
        case _:
            raise Unreadable(f"what is {own}?")
