"""How far a motion gets: the greatest and the least value of a measure, or of another quantity, over all of it."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, cast

from freebody.language.expression import ZERO, Symbol
from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.measures.base import Measure
from freebody.model.phrases import PHRASES, composed, measure_of
from freebody.questions.arithmetic import AtStart, Functions, Joined
from freebody.questions.base import Described, Path, Quantity, angular_unit
from freebody.questions.ends import GREATEST, LEAST
from freebody.questions.event import Peak
from freebody.questions.event_base import QuestionEvent
from freebody.questions.forms import Found, asked
from freebody.questions.grammar import read_calculation
from freebody.questions.motion import OfMeasure

if TYPE_CHECKING:
    from freebody.model.names import Names


_SIZE = re.compile(r"\|([^|]*)\|")  # greatest |acceleration of x|
_SUM = re.compile(r"\(([^()]*)\)")  # least (x2 - x1)


@dataclass(frozen=True)
class Extent(Quantity, kind="extent"):
    """The value of a measure at the turn that lies farthest up, or down; that of the start is one of them."""

    measure: Measure
    name: str
    end: Literal["greatest", "least"]

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {y: y of ball}
start: {y: 0, rate(y): 3 m/s}
questions: {it: greatest y}
"""
    scope = "whole motion"

    @property
    def dimension(self) -> Dimension:
        return self.measure.dimension

    @property
    def unit(self) -> str:
        is_angle = self.dimension == DIMENSIONLESS
        return angular_unit(self.dimension) if is_angle else str(self.dimension)

    @property
    def side(self) -> int:
        return 1 if self.end == "greatest" else -1

    @property
    def of_motion(self) -> ExtremeOfMotion:
        """The same of what need not turn there."""
        return ExtremeOfMotion(OfMeasure(self.measure, 0, self.name), self.end)

    @property
    def turn(self) -> tuple[Quantity, QuestionEvent, int]:
        event = QuestionEvent(self.measure, 1, ZERO, f"{self.name} turns back")
        return OfMeasure(self.measure, 0, self.name), event, self.side

    def sentence(self, system: Described) -> Sentence:
        of = Symbol(self.name) if self.name in system.measures else self.name
        return Sentence(f"what.{self.end}", {"of": of})


@dataclass(frozen=True)
class ExtremeOfMotion(Quantity, kind="extreme of a motion"):
    """The greatest or the least value of a quantity over a motion that repeats itself."""

    of: Quantity
    end: Literal["greatest", "least"]

    example = """
bodies: {bob: {particle: {mass: 2 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 40 deg, rate(theta): 0}
questions: {it: greatest tension of rod}
"""
    scope = "whole motion"

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.of.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)

    @property
    def of_what_stays(self) -> Quantity:
        return self.of

    @property
    def side(self) -> int:
        return 1 if self.end == "greatest" else -1

    @property
    def turn(self) -> tuple[Quantity, QuestionEvent, int] | None:
        if not self.of.is_of_state or not self.of.dimension:
            return None
        return self.of, Peak.of(self.of, f"{self.of!r} turns back"), self.side

    def sentence(self, system: Described) -> Sentence | None:
        of = self.of.sentence(system)
        return None if of is None else Sentence(f"what.{self.end}_of", {"of": of})


@dataclass(frozen=True)
class GreatestChange(Joined, kind="greatest change"):
    """How far a quantity gets from its value at the start, up or down: the greater of top - x_0 and x_0 - bottom, which
    is (top - bottom + |top + bottom - 2 x_0|)/2."""

    top: Quantity
    bottom: Quantity
    of: Quantity

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {y: y of ball}
start: {y: 0, rate(y): 3 m/s}
questions: {it: greatest change of y until rate(y) = 0}
"""
    scope = "whole motion"

    @classmethod
    def from_start(cls, top: Extent | ExtremeOfMotion) -> GreatestChange:
        """From the greatest value."""
        of = top.of if isinstance(top, ExtremeOfMotion) else top.of_motion.of
        return cls(top, replace(top, end="least"), of)

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.top.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return self.top, self.bottom, AtStart(self.of)

    @property
    def is_of_answers(self) -> bool:
        return True

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        top, bottom, first = values
        return (top - bottom + of.absolute(top + bottom - 2 * first)) / 2


@asked(
    "greatest change of QUANTITY",
    rf"(?:{GREATEST}) change (?:of|in) (?:the )?(?P<of>.+?)(?: (?:over|during|in) the (?:whole )?motion)?",
    rank=16,
)
def greatest_change(names: Names, found: Found, path: Path) -> Quantity | None:
    top = extreme(names, {"of": found["of"], "end": "greatest"}, path)
    return None if top is None else GreatestChange.from_start(cast("Extent | ExtremeOfMotion", top))


@asked(
    "greatest | least QUANTITY [over the motion]",
    rf"(?P<end>{GREATEST}|{LEAST}) (?:value )?(?:of )?(?:the )?(?P<of>.+?)"
    r"(?: (?:over|during|of|in) the (?:whole )?motion)?",
    rank=15,
)
def extreme(names: Names, found: Found, path: Path) -> Quantity | None:
    of, end = _SIZE.sub(r"size of \1", str(found["of"])), "greatest" if found["end"] in GREATEST else "least"
    if (summed := _SUM.fullmatch(of)) and _is_of_measures(names, summed[1]):
        measure = composed(names, summed[1], *path)
        return None if measure is None else Extent(measure, of, end)
    if of not in names.measures and not any(phrase.pattern.match(of) for phrase in PHRASES):
        quantity = read_calculation(names, of, path)
        if quantity is not None and quantity.is_of_parameters:
            told = Message("{of} follows from the parameters alone and is the same throughout the motion", of=of)
            names.problem(told, *path)
            return None
        if quantity is None or quantity.scope == "instant":
            return (
                None
                if quantity is None
                else ExtremeOfMotion(quantity.sized(space=names.space, most=end == "greatest"), end)
            )
        names.problem(Message("'{text}' is no property of one instant", text=of), *path)
        return None
    measure = measure_of(names, of, *path)
    return None if measure is None else Extent(measure, of, end)


def _is_of_measures(names: Names, text: str) -> bool:
    """Whether nothing but measures and parameters are in an expression."""
    return all(name in names.measures or name in names.parameters for name in re.findall(r"[^\W\d]\w*", text))
