"""Questions about the ratio of two quantities, which of two is greater, and of two loads that balance each other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.errors import ExpressionError
from freebody.language.expression import Symbol, add, divide, free_symbols, negate
from freebody.language.parser import parse
from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.model.noting import did_you_mean
from freebody.model.state import State
from freebody.questions.arithmetic import (
    OF_MOTIONS,
    CalculatedOfMotion,
    Functions,
    Joined,
    is_vector,
    quotient,
    read_calculated,
)
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.grammar import read_calculation, read_quantity
from freebody.questions.loads import LoadForce, Power
from freebody.questions.operands import number_with_unit

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class RatioOf(Joined, kind="ratio"):
    """One quantity over another."""

    top: Quantity
    bottom: Quantity

    example = """
ground: {points: {B: [3 m, 0]}}
bodies: {big: {disk: {mass: 1 kg, radius: 2 m}}, small: {disk: {mass: 1 kg, radius: 1 m}, at: [3 m, 0]}}
connections: {a: {pin: [ground.origin, big]}, b: {pin: [ground.B, small]}, belt: {gear_mesh: [big, small]}}
questions: {it: ratio of angular velocity of small to angular velocity of big}
"""

    @property
    def letter(self) -> str:
        return "i"

    @property
    def dimension(self) -> Dimension:
        return self.top.dimension / self.bottom.dimension

    @property
    def unit(self) -> str:
        return "1" if self.dimension == DIMENSIONLESS else str(self.dimension)

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return self.top, self.bottom

    @property
    def is_of_pose_in_motion(self) -> bool:
        return self.top.kinematic_order == self.bottom.kinematic_order == 1

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        return quotient(*values)

    def sentence(self, system: Described) -> Sentence | None:
        top, bottom = self.top.sentence(system), self.bottom.sentence(system)
        return None if top is None or bottom is None else Sentence("what.ratio", {"top": top, "bottom": bottom})


@dataclass(frozen=True)
class Comparison(Joined, kind="comparison"):
    """Which of two quantities is greater: by the sign of their difference; of vectors that of their sizes."""

    first: Quantity
    second: Quantity

    example = """
parameters: {m: 2 kg, M: 3 kg, F: 12 N, R: 5 N}
bodies: {a: {particle: {mass: m}}, b: {particle: {mass: M}}}
loads: {push: {force: {at: a, along: right, magnitude: F}}, pull: {force: {at: b, along: right, magnitude: R}}}
measures: {x: x of a, y: x of b}
questions: {it: "which is greater, acceleration of x or acceleration of y"}
"""
    compares = True

    @property
    def dimension(self) -> Dimension:
        return self.first.dimension

    @property
    def unit(self) -> str:
        return self.first.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return self.first, self.second

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        first, second = (of.sqrt(sum(x * x for x in v)) if isinstance(v, tuple) else v for v in values)
        return first - second

    def sentence(self, system: Described) -> Sentence | None:
        first, second = self.first.sentence(system), self.second.sentence(system)
        return None if first is None or second is None else Sentence("what.greater", {"one": first, "other": second})


@dataclass(frozen=True)
class MechanicalAdvantage(Quantity, kind="mechanical advantage"):
    """The force or torque of a load over that of another one which it balances, at rest, in a mechanism of one freedom
    without weight and friction. By virtual power F_1 v_1 + F_2 v_2 = 0, with v_i the rate at which a load of one does
    work; it is negative where both, in the directions of the model, drive the same way. Source: Norton, Design of
    Machinery, 5th ed. 2012, sec. 6.5."""

    of: str
    to: str
    forces: tuple[Dimension, Dimension]

    example = """
parameters: {a: 2 m, b: 0.5 m, F: 30 N, R: 10 N}
bodies: {lever: {rod: {mass: 0, length: a + b}, points: {O: [(a - b)/2, 0]}}}
connections: {fulcrum: {pin: [ground.O, lever.O]}}
loads:
  hand: {force: {at: lever.start, along: down, magnitude: F}}
  crate: {force: {at: lever.end, along: down, magnitude: R}}
measures: {phi: angle of lever}
questions: {it: mechanical advantage of crate to hand at start}
"""

    @property
    def dimension(self) -> Dimension:
        return self.forces[0] / self.forces[1]

    @property
    def is_of_pose_in_motion(self) -> bool:
        return True

    @property
    def kinematic_order(self) -> int:
        return 1

    def value(self, system: Described, state: State[Any]) -> Any:
        first, second = (
            quotient(Power(name).value(system, state), LoadForce(name, force).value(system, state))
            for name, force in zip((self.of, self.to), self.forces, strict=True)
        )
        return -quotient(second, first)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.advantage", {"of": self.of, "to": self.to})

    @property
    def remarks(self) -> tuple[Message, ...]:
        return (Message("this is {of} divided by {to}, where the two balance each other", of=self.of, to=self.to),)


@asked(
    "mechanical advantage of LOAD to LOAD",
    rf"mechanical advantage of (?:the )?(?P<of>{NAME}) (?:to|over|against) (?:the )?(?P<to>{NAME})",
    rank=66,
)
def _advantage(names: Names, found: Found, path: Path) -> Quantity | None:
    loads = [str(found["of"]), str(found["to"])]
    for name in loads:
        if name not in names.loads:
            hint = did_you_mean(name, names.loads)
            names.unknown(name, Message("there is no load {name}.{hint}", name=name, hint=hint), *path)
            return None
    return MechanicalAdvantage(loads[0], loads[1], (names.loads[loads[0]], names.loads[loads[1]]))


def _side(names: Names, text: str, path: Path) -> Quantity | None:
    """A quantity, what is calculated from several, a value, or an expression in the parameters."""
    if number_with_unit(text) is not None:
        return read_calculated(names, text, {}, path, [text])
    try:
        is_of_parameters = free_symbols(parse(text)) <= names.parameters.keys() | {"pi"}
    except ExpressionError:
        is_of_parameters = False
    return read_calculated(names, text, {}, path, [text]) if is_of_parameters else read_calculation(names, text, path)


@asked(
    "which is greater, QUANTITY or QUANTITY",
    r"which (?:one |of them )?is (?:the )?greater,? (?:the )?(?P<first>.+?) or (?:the )?(?P<second>.+)",
    rank=98,
)
def _compared(names: Names, found: Found, path: Path) -> Quantity | None:
    first, second = (_side(names, str(found[k]), path) for k in ("first", "second"))
    if first is None or second is None:
        return None
    if first.dimension != second.dimension:
        told = Message(
            "{first} and {second} are of unlike units and cannot be compared",
            first=str(found["first"]),
            second=str(found["second"]),
        )
        names.problem(told, *path)
        return None
    if {first.scope, second.scope}.isdisjoint(OF_MOTIONS):
        return Comparison(first, second)
    operands = (("first", first), ("second", second))
    text = f"({found['first']}) - ({found['second']})"
    form = add(Symbol("first"), negate(Symbol("second")))
    return CalculatedOfMotion(form, operands, first.dimension, text)


@asked("ratio of QUANTITY to QUANTITY", r"ratio of (?P<top>.+) to (?P<bottom>.+)", rank=65)
def _ratio(names: Names, found: Found, path: Path) -> Quantity | None:
    with names.one_number():
        top, bottom = (read_quantity(names, str(found[k]), path) for k in ("top", "bottom"))
    if top is None or bottom is None:
        return None
    space = names.space  # of vectors the sizes: how many times as large one is
    top, bottom = (one.sized(space=space) if is_vector(one, space=space) else one for one in (top, bottom))
    if {top.scope, bottom.scope}.isdisjoint(OF_MOTIONS):
        return RatioOf(top, bottom)
    operands = (("top", top), ("bottom", bottom))
    text = f"({found['top']})/({found['bottom']})"
    return CalculatedOfMotion(divide(Symbol("top"), Symbol("bottom")), operands, top.dimension / bottom.dimension, text)
