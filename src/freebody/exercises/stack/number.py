"""The part of a question in which a number is typed, with its unit where it has one."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property

from freebody.exercises.asked import is_moving
from freebody.exercises.bank import Item
from freebody.exercises.markup import Markup
from freebody.exercises.stack.castext import VARIANT
from freebody.exercises.stack.part import Part, expected, place_of
from freebody.exercises.stack.question import Input, Node, QuestionTest, Tree

RIGHT = "right"
_DIGITS = 10


class NumberPart:
    """input_, tree: their names in the question."""

    def __init__(self, item: Item, markup: Markup, input_: str, tree: str) -> None:
        self.item, self.markup, self.input, self.tree = item, markup, input_, tree
        self.unit = stack_unit(item.unit)
        self.values = [v.value for v in item.variants if isinstance(v.value, float) and math.isfinite(v.value)]

    @property
    def is_asked(self) -> bool:
        """Whether each variant has a number that can be judged."""
        return self._is_number and not self.is_sometimes_zero

    @property
    def is_sometimes_zero(self) -> bool:
        """Whether the tolerance leaves no room in a variant."""
        return self._is_number and not self.is_count and not all(map(self.item.tolerance.room, self.values))

    @property
    def _is_number(self) -> bool:
        item = self.item
        is_one = item.answer in ("formula", "number") and not is_moving(item)
        return is_one and len(self.values) == len(item.variants)

    @property
    def is_count(self) -> bool:
        """A whole number, which is right or not."""
        return not self.unit and not self.item.tolerance.room(1.0) and all(v.is_integer() for v in self.values)

    def part(self) -> Part:
        tree = Tree(self.tree, tuple(self._nodes()))
        kind = "units" if self.unit else "algebraic" if self.is_count else "numerical"
        box = Input(self.input, kind, "fbnumber")
        asked = f"<p>{self.markup.text(self.item.number_prompt)}</p>{place_of(self.input)}"
        return Part(tuple(self._variables()), asked, box, tree, tuple(self._tests(tree)))

    @cached_property
    def wrong(self) -> list[tuple[int, list[float], str]]:
        """Those of the wrong answers whose numbers tell them from the right one and from each other in all variants:
        their place, their numbers, what is said."""
        found: list[tuple[int, list[float], str]] = []
        for k, answer in enumerate(self.item.wrong):
            values = [v.wrong_values[k] for v in self.item.variants]
            numbers = [x for x in values if isinstance(x, float) and math.isfinite(x)]
            if len(numbers) < len(values):
                continue
            others = [self.values, *(w for _, w, _ in found)]
            if all(self._are_apart(n, x, other[n]) for n, x in enumerate(numbers) for other in others):
                found.append((len(found) + 1, numbers, self.markup.text(answer.feedback).strip()))
        return found

    def _are_apart(self, n: int, a: float, b: float) -> bool:
        """Whether no number is taken for both in a variant."""
        value = self.values[n]
        return abs(a - b) > 2 * self.item.tolerance.room(value) + 1e-9 * abs(value)

    # -- Maxima -------------------------------------------------------------------------------
    def _variables(self) -> Iterator[str]:
        yield f"fbnumbers:[{','.join(map(self._written, self.values))}];"
        yield f"fbnumber:{self._with_unit(f'fbnumbers[{VARIANT}]')};"
        if not self.is_count:
            rooms = ",".join(f"{self.item.tolerance.room(x):.6g}" for x in self.values)
            yield f"fbrooms:[{rooms}];"
            yield f"fbroom:fbrooms[{VARIANT}];"
        for k, numbers, _ in self.wrong:
            yield f"fbslips{k}:[{','.join(map(self._written, numbers))}];"
            yield f"fbslip{k}:{self._with_unit(f'fbslips{k}[{VARIANT}]')};"

    def _written(self, x: float) -> str:
        return str(int(x)) if self.is_count else f"{x:.{_DIGITS}g}" if x % 1 else f"{x:.1f}"

    def _with_unit(self, text: str) -> str:
        return f"stackunits({text},{self.unit})" if self.unit else text

    def _nodes(self) -> Iterator[Node]:
        test = "AlgEquiv" if self.is_count else "UnitsAbsolute" if self.unit else "NumAbsolute"
        options = "" if self.is_count else "fbroom"
        yield Node(test, self.input, "fbnumber", RIGHT, "", options, is_right=True, is_quiet=not self.unit)
        for k, _, said in self.wrong:
            yield Node(test, self.input, f"fbslip{k}", f"wrong-{k}", said, options)

    def _tests(self, tree: Tree) -> Iterator[QuestionTest]:
        yield expected("key", self.input, self._typed("fbnumbers"), tree, 0)
        for k, _, _ in self.wrong:
            yield expected("distractor", self.input, self._typed(f"fbslips{k}"), tree, k)

    def _typed(self, numbers: str) -> str:
        return f"{numbers}[{VARIANT}]" + (f"*{self.unit}" if self.unit else "")


def stack_unit(unit: str) -> str:
    """A unit of ours as STACK has it: kg m^2/s is kg*m^2/s."""
    return "" if unit in ("", "1") else unit.replace(" ", "*")
