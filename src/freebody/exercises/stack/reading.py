"""Our own reader: what STACK would say to an answer, from the variables and trees of a file alone.

Only what our writer uses is understood. Names stay those of Maxima, which are names of ours as well.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from freebody.assess.names import named_in
from freebody.errors import ExpressionError, FreebodyError, InputError
from freebody.exercises.selftests import Marked
from freebody.exercises.stack.castext import VARIANT
from freebody.exercises.stack.comparing import Points, close
from freebody.exercises.stack.maxima import MaximaNames
from freebody.exercises.stack.question import Input, Node, StackQuestion, Tree
from freebody.exercises.stack.seeds import drawn
from freebody.language.expression import Expr, evaluate
from freebody.language.sentences import Message
from freebody.language.units import Quantity, parse_quantity

_STATEMENT = re.compile(r"(\w+):(?!=)(.*);")
_RANDOM = re.compile(r"rand\((\d+)\)\+1")
_ELEMENT = re.compile(rf"(\w+)\[{VARIANT}\](.*)", re.DOTALL)
_WITH_UNIT = re.compile(r"stackunits\((.*),(.*)\)", re.DOTALL)
_SAME = re.compile(r"fbsame\((-?)fbans,(\w+)\)")
_NAMES = MaximaNames({})

Parts = tuple[Expr, ...]


@dataclass(frozen=True)
class ReadPart:
    """One input of a question under one seed, with the tree that judges it."""

    question: StackQuestion
    input: Input
    tree: Tree
    seed: int | None

    def mark(self, response: str) -> Marked:
        """The first node that agrees counts. response: what is typed, in Maxima."""
        for node in self.tree.nodes:
            if self._agrees(node, response):
                return Marked("correct" if node.is_right else "incorrect", node.feedback)
        return Marked("incorrect")

    # -- variables ----------------------------------------------------------------------------
    @cached_property
    def _texts(self) -> Mapping[str, str]:
        text = f"{self.question.variables}\n{self.tree.variables}"
        lines = (_STATEMENT.fullmatch(line) for line in text.splitlines())
        return {found[1]: found[2] for found in lines if found is not None}

    @cached_property
    def _n(self) -> int:
        """The variant that the seed gives."""
        chosen = _RANDOM.fullmatch(self._texts.get(VARIANT, ""))
        return 1 if chosen is None or self.seed is None else drawn(self.seed, int(chosen[1])) + 1

    @cached_property
    def variables(self) -> Mapping[str, str]:
        """The texts behind names, those of the variant chosen."""
        return {name: self._chosen(text, self._n, self._texts) for name, text in self._texts.items()}

    def _chosen(self, text: str, n: int, known: Mapping[str, str]) -> str:
        unit = _WITH_UNIT.fullmatch(text)
        if unit is not None:
            return f"{self._chosen(unit[1], n, known)}*{unit[2]}"
        element = _ELEMENT.fullmatch(text)
        if element is None:
            return text
        listed = _list(known.get(element[1], ""))
        if not 1 <= n <= len(listed):
            raise InputError(Message("{name}: '{text}' has no element {n}", name=self.question.name, text=text, n=n))
        return listed[n - 1] + element[2]

    def typed(self, text: str) -> str:
        """What a test types: a variable, or the element of one, spelled out."""
        return self.value(self._chosen(text, self._n, self._texts))

    def value(self, text: str) -> str:
        """The text behind a name, or itself."""
        return self.variables.get(text, text)

    @cached_property
    def points(self) -> Points:
        states, later, scaled, scaled_later = (
            tuple(map(_state, _list(self.variables.get(name, "[]"))))
            for name in ("fbpoints", "fblater", "fbscaled", "fbscaledlater")
        )
        larger = Fraction(self.variables.get("fblarger", "1"))
        return Points(states, later, scaled[0] if scaled else None, scaled_later[0] if scaled_later else None, larger)

    # -- nodes --------------------------------------------------------------------------------
    def _agrees(self, node: Node, response: str) -> bool:
        if node.test in ("UnitsAbsolute", "NumAbsolute"):
            return self._is_near(response, self.value(node.wanted), float(self.value(node.options)))
        if node.test != "AlgEquiv":
            raise InputError(Message("{name}: the test {test} is not known", name=self.question.name, test=node.test))
        if node.given == self.input.name:  # a whole number, or that of an option
            return _number(response) == _number(self.value(node.wanted))
        mine = self._parts(response)
        if (same := _SAME.fullmatch(node.given)) is not None:
            return self.points.same(mine, self._parts(same[2]), -1.0 if same[1] else 1.0)
        if node.given == "fbunits(fbans)":
            return not self.points.has_dimension(mine)
        if node.given == "fbfactor(fbans,fbkey)":
            return self.points.is_multiple(mine, self._parts("fbkey"))
        if node.given == "fbvalued(fbans)":
            return None not in self.points.series(mine)
        if node.given == "fbans":
            return _is_formula(mine, self._parts(node.wanted))
        raise InputError(Message("{name}: '{text}' is not known", name=self.question.name, text=node.given))

    def _parts(self, text: str) -> Parts:
        """Raises InputError for what is no formula."""
        written = self.value(text)
        try:
            return tuple(map(_NAMES.read, _list(written) if written.startswith("[") else [written]))
        except ExpressionError as error:
            name = self.question.name
            raise InputError(
                Message("{name}: '{text}' is no formula: {why}", name=name, text=text, why=str(error))
            ) from None

    def _is_near(self, response: str, wanted: str, room: float) -> bool:
        mine, its = _quantity(response), _quantity(wanted)
        return mine.dimension == its.dimension and abs(float(mine.value) - float(its.value)) < room


def read_parts(question: StackQuestion) -> Iterator[tuple[str, ReadPart]]:
    """The inputs of a question under its seeds, by names: where nothing depends on the variant, under the first one."""
    for box, tree in zip(question.inputs, question.trees, strict=True):
        seeds: Sequence[int | None] = question.seeds or (None,)
        if box.answer == "fbkey":
            yield part_name(question.name, box.name, None), ReadPart(question, box, tree, seeds[0])
            continue
        for seed in seeds:
            yield part_name(question.name, box.name, seed), ReadPart(question, box, tree, seed)


def part_name(question: str, input_: str, seed: int | None) -> str:
    return f"{question}: {input_}" + ("" if seed is None else f" ({seed})")


# -- texts ------------------------------------------------------------------------------------
def _list(text: str) -> list[str]:
    """The elements of a list of Maxima; strings are kept whole."""
    inside = text.strip()
    if not (inside.startswith("[") and inside.endswith("]")):
        raise InputError(Message("'{text}' is no list", text=text[:60]))
    found, depth, start, is_string, place = list[str](), 0, 1, False, 1
    while place < len(inside) - 1:
        sign = inside[place]
        if sign == "\\" and is_string:
            place += 1
        elif sign == '"':
            is_string = not is_string
        elif not is_string:
            depth += (sign in "[(") - (sign in "])")
            if sign == "," and depth == 0:
                found.append(inside[start:place])
                start = place + 1
        place += 1
    rest = inside[start:-1]
    return [*found, rest] if rest.strip() or found else []


def _state(text: str) -> dict[str, float]:
    pairs = (pair.partition("=") for pair in _list(text))
    return {name.strip(): float(value) for name, _, value in pairs}


def _number(text: str) -> float:
    try:
        return float(Fraction(text.strip()))
    except ValueError:
        raise InputError(Message("'{text}' is no number", text=text)) from None


def _quantity(text: str) -> Quantity:
    number, _, unit = text.partition("*")
    try:
        return parse_quantity(f"{number} {unit.replace('*', ' ')}".strip())
    except FreebodyError as error:
        raise InputError(str(error)) from None


def _is_formula(a: Parts, b: Parts) -> bool:
    """Whether formulas agree for any values of their names."""
    names = dict.fromkeys(key for part in (*a, *b) for key in named_in(part))
    for k in range(3):
        values = {name: 0.7 + 0.13 * n + 0.31 * k for n, name in enumerate(names)}
        try:
            mine, its = ([float(evaluate(part, values)) for part in parts] for parts in (a, b))
        except (FreebodyError, ValueError, ArithmeticError, TypeError):
            continue
        if not close(mine, its):
            return False
    return True
