"""The ratio of the amplitudes of two measures in a natural mode."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol
from freebody.language.sentences import Argument, Message, Sentence
from freebody.model.noting import did_you_mean
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.small_motion import ORDINALS, ModeShapes

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class AmplitudeRatio(ModeShapes, kind="amplitude ratio"):
    """The amplitude of one measure over that of another in a natural mode; negative where they swing against each
    other."""

    is_ratio = True

    number: int = 1
    top: str = ""
    bottom: str = ""

    example = """
parameters: {m: 1 kg, k: 100 N/m}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: m}}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
measures: {x1: x of A, x2: x of B}
loads: {l: {law: {measure: x1, force: -k*x1}}, m: {law: {measure: {expression: x2 - x1}, force: -k*(x2 - x1)}}}
start: {x1: 0, x2: 0}
questions: {it: amplitude ratio of x1 to x2 in mode 2}
"""

    def sentence(self, system: Described) -> Sentence:
        args: dict[str, Argument] = {"k": self.number, "top": Symbol(self.top), "bottom": Symbol(self.bottom)}
        return Sentence("what.amplitude_ratio", args)


# -- words ------------------------------------------------------------------------------------
@asked(
    "amplitude ratio of MEASURE to MEASURE in mode K",
    rf"(?:amplitude ratio|ratio of (?:the )?amplitudes?|ratio) of (?P<of>{NAME}) (?:to|and|over) (?P<other>{NAME}) "
    rf"in (?:the )?(?:mode (?P<k>[1-9]\d?)|(?P<th>{'|'.join(ORDINALS)}) (?:natural |normal )?mode)",
    rank=76,
)
def _amplitude_ratio(names: Names, found: Found, path: Path) -> Quantity | None:
    sides = [str(found[key]) for key in ("of", "other")]
    for name in sides:
        if name not in names.measures:
            hint = did_you_mean(name, names.measures)
            names.unknown(name, Message("{name} is no measure.{hint}", name=name, hint=hint), *path)
            return None
    return AmplitudeRatio(int(found["k"]) if found["k"] else ORDINALS.index(found["th"]) + 1, sides[0], sides[1])
