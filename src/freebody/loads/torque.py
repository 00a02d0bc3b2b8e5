"""A torque on a body, optionally reacting on another one (a motor)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.errors import InputError
from freebody.language.expression import Expr, negate
from freebody.language.sentences import Message
from freebody.language.units import TORQUE, parse_quantity
from freebody.loads.base import Load
from freebody.loads.law import law, limited
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad, NonholonomicForm
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading
from freebody.model.spins import spin

if TYPE_CHECKING:
    from freebody.model.names import Names

_WAY = r"(?:counter-?|anti-?)?clockwise"
_IN_WORDS = re.compile(
    rf"(?P<magnitude>\S.*?)(?:\s+(?P<way>{_WAY}))?\s+(?:on|at|an|auf)\s+(?P<on>[\w.]+)(?:\s+(?P<way_then>{_WAY}))?"
)


def turned_about(names: Names, on: str, reacts_on: str, about: Heading | None) -> Measure | NonholonomicForm | None:
    """What a torque on a body pushes, against another one; None where it has no axis."""
    body, other = names.body(on.partition(".")[0], "on"), names.body(reacts_on, "reacts_on")
    if not body.turns:
        names.problem(Message("{body} is a particle and cannot take a torque", body=body.name), "on")
    if not names.space:
        if about is not None:
            names.problem(Message("a torque in the plane has no axis; in space write space: true"), "about")
        return Angle(body.name, other.name)
    if about is None:
        names.problem(Message("in space a torque needs its axis, e.g. about: z, or about: rotor.x"), "about")
        return None
    return spin(body.name, names.direction(about, "about"), other.name)


class Couple(Load):
    """What turns a body one way or the other: counter-clockwise, or `clockwise: true`, for which a file may write
    `direction: clockwise`."""

    ways: ClassVar[tuple[str, ...]] = ("direction", "sense")
    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {**dict.fromkeys(ways, ("clockwise",)), "body": ("on",)}

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        given = super().from_plain(value)
        if "body" in given and "on" not in given:
            given["on"] = given.pop("body")
        for word in cls.ways:
            told = str(given.get(word, "")).replace("-", "").lower()
            if "clockwise" not in given and told in ("clockwise", "counterclockwise", "anticlockwise"):
                del given[word]
                given["clockwise"] = told == "clockwise"
        return given

    @staticmethod
    def signed(names: Names, magnitude: Expr, *, clockwise: bool) -> Expr:
        """The magnitude, positive counter-clockwise."""
        if clockwise and names.space:
            told = Message("in space the axis says which way round: about: -z turns the other way as about: z")
            names.problem(told, "clockwise")
        return negate(magnitude) if clockwise else magnitude


class Torque(Couple, kind="torque"):
    """`torque: {on: sun, magnitude: T}`, counter-clockwise positive; `direction: clockwise` (`clockwise: true`) is the
    other way round. `reacts_on: arm` where the motor sits on a body, which feels the opposite torque. A couple turns a
    rigid body alike wherever it acts, but the bending moment of a rod needs its place: `on: beam.C`. In space `about`
    says the axis: a direction fixed in the ground, or in a body (`about: rotor.x`). `at_most: T_max` where a motor can
    give no more either way."""

    also: ClassVar[tuple[str, ...]] = (
        "Moment",
        "Drehmoment",
        "moment",
    )

    called: ClassVar[tuple[str, ...]] = ("motor", "couple", "moment")

    on: str
    magnitude: Formula
    reacts_on: str = GROUND
    about: Heading | None = None
    at_most: Formula | None = None
    clockwise: bool = False

    is_chosen = True
    example = """
bodies: {wheel: {disk: {mass: 1 kg, radius: 1 m}}}
loads: {it: {torque: {on: wheel, magnitude: 2 N m}}}
"""

    @classmethod
    def in_words(cls, text: str) -> dict[str, Any] | None:
        """`5 N m on drum`, `5 N m clockwise on drum`: a number whose unit says that it is a torque."""
        said = _IN_WORDS.fullmatch(text.strip())
        try:
            is_torque = said is not None and parse_quantity(said["magnitude"]).dimension == TORQUE
        except InputError:
            return None
        if said is None or not is_torque:
            return None
        way = {"direction": said["way"] or said["way_then"]} if said["way"] or said["way_then"] else {}
        return {"on": said["on"], "magnitude": said["magnitude"], **way}

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        turned = turned_about(names, self.on, self.reacts_on, self.about)
        magnitude, used = law(names, self.magnitude, TORQUE, "magnitude")
        magnitude = self.signed(names, limited(names, self, magnitude, TORQUE), clockwise=self.clockwise)
        at = names.point(self.on, "on") if "." in self.on else None
        return [] if turned is None else [AppliedLoad("", turned, magnitude, used, couple_at=at)]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        axis = names.direction(self.about, "about") if names.space and self.about is not None else None
        yield glyphs.MomentArrow(names.point(self.on) if "." in self.on else names.body(self.on).mass_center, axis)
