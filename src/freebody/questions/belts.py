"""Questions about belts, chains and cables that hang: tensions, what is carried before it slips, how long it is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import ZERO
from freebody.language.sentences import Message, Sentence, listed
from freebody.language.units import DIMENSIONLESS, LENGTH, MASS, Dimension
from freebody.model.transmitted import Transmitted
from freebody.questions.arithmetic import Functions, Joined, OfParameters
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.extent import extreme
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.motion import OfMeasure
from freebody.questions.reactions import has_connection
from freebody.questions.reactions_by_component import ReactionComponent

if TYPE_CHECKING:
    from freebody.model.names import Names

_WRAP = "angle of wrap"
_OF_BELTS = (
    f"tight tension|slack tension|greatest belt force|greatest power|speed of greatest power|length|links|{_WRAP}"
)
_WORDS = f"{_OF_BELTS}|sag|horizontal pull|greatest tension"
_KEYS = {word: word.replace(" ", "_") for word in _WORDS.split("|")}


@dataclass(frozen=True)
class OfBelt(Joined, kind="of a belt"):
    """A tension of a belt, the greatest force or power that it carries without slip, its length, the angle of wrap on
    the pulley on which it slips first; of a cable that hangs its sag, its length, its pull and its greatest tension."""

    is_by_law: ClassVar[bool] = True

    connection: str
    what: str
    means: Transmitted

    example = """
bodies: {a: {disk: {mass: 1 kg, radius: 0.1 m}}, b: {disk: {mass: 1 kg, radius: 0.2 m}}}
ground: {points: {A: [0, 0], B: [0.5 m, 0]}}
connections:
  p: {pin: [ground.A, a]}
  q: {pin: [ground.B, b]}
  drive: {belt: {first: a, second: b, pretension: 300 N}}
loads: {motor: {torque: {on: a, magnitude: 5 N m}}}
questions: {it: tight tension of drive}
"""

    @property
    def dimension(self) -> Dimension:
        return self.means.dimension

    @property
    def unit(self) -> str:
        return "rad" if self.what == _WRAP else super().unit

    @property
    def is_of_parameters(self) -> bool:
        """The length, the greatest power and its speed: they do not depend on what the belt does."""
        return self.means.of_force == ZERO and (self.means.way is None or self.means.of_square == ZERO)

    @property
    def inner(self) -> tuple[Quantity, ...]:
        """The constant, and what is multiplied by the size of the force and by the square of the speed."""
        means, found = self.means, [OfParameters(self.means.constant, self.dimension)]
        if means.of_force != ZERO:
            name = f"{self.connection}.{means.row}"
            force = ReactionComponent(self.connection, f"{means.row} force", name)
            found += [OfParameters(means.of_force, DIMENSIONLESS), force]
        if means.way is not None and means.of_square != ZERO:
            found += [
                OfParameters(means.of_square, MASS / LENGTH),
                OfMeasure(means.way, 1, f"way of {self.connection}"),
            ]
        return tuple(found)

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        total, *rest = values
        if self.means.of_force != ZERO:
            total = total + rest[0] * of.absolute(rest[1])
            rest = rest[2:]
        if rest:  # faster than where this vanishes the belt lifts off and carries nothing
            total = total + rest[0] * rest[1] * rest[1]
            return (total + of.absolute(total)) / 2
        return total

    def sentence(self, system: Described) -> Sentence:
        return Sentence(f"what.belt.{_KEYS[self.what]}", {"connection": self.connection})


@asked(
    "tight tension | slack tension | greatest belt force | greatest power | speed of greatest power | length | "
    "angle of wrap | sag | horizontal pull | greatest tension of CONNECTION",
    rf"(?P<what>{_WORDS}) (?:of|in) (?:the )?(?P<of>{NAME})",
    rank=60,
)
def _of_belt(names: Names, found: Found, path: Path) -> Quantity | None:
    of, what = str(found["of"]), str(found["what"])
    if what == "greatest power" and of in names.loads:  # over the motion
        return extreme(names, {"end": "greatest", "of": f"power of {of}"}, path)
    if of in names.broken:
        return None
    connection = names.connections.get(of)
    with names.quietly():
        known = {} if connection is None else connection.transmitted(names)
    if what in ("greatest tension", "greatest power") and what not in known:  # over the motion, as that of a drive
        return extreme(names, {"end": "greatest", "of": f"{what.removeprefix('greatest ')} of {of}"}, path)
    if not has_connection(names, of, path):
        return None
    if what not in known:
        able = [f"{word} of {of}" for word in known]
        told = (
            Message("{of} has no {what}; ask for: {known}", of=of, what=what, known=listed(able))
            if known
            else Message("{of} is no belt, no chain and no cable that hangs", of=of)
        )
        names.problem(told, *path)
        return None
    return OfBelt(of, what, known[what])
