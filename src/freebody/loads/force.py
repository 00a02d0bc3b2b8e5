"""A force at a point, in a direction fixed in the ground or in a body."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import multiply, number
from freebody.language.sentences import Message
from freebody.language.units import FORCE, LENGTH
from freebody.loads.base import Load
from freebody.loads.law import law, limited
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, ONE, Point
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad, Component, NonholonomicForm
from freebody.model.glyphs import Glyph
from freebody.model.names import ALSO_WAYS
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


WAYS = ("right", "left", "up", "down")
_WOUND = "wound on "  # a place of a cord, which does not turn with the drum
_WAY = "|".join(sorted((*WAYS, *ALSO_WAYS), key=len, reverse=True))
_IN_WORDS = re.compile(
    rf"(?P<magnitude>\S.*?)\s+(?:(?P<way>{_WAY})\s+(?:at|on|bei|an)\s+(?P<at>[\w.]+)"
    rf"|(?:at|on|bei|an)\s+(?P<at_first>[\w.]+)\s+(?P<way_then>{_WAY}))"
)


def with_way(given: dict[str, Any], size: str) -> dict[str, Any]:
    """`down: F` as `along: down` and the size."""
    ways = [way for way in WAYS if way in given]
    if len(ways) == 1 and not {"along", size} & given.keys():
        return {key: each for key, each in given.items() if key not in ways} | {"along": ways[0], size: given[ways[0]]}
    return given


def pushed_along(names: Names, point: Point, heading: Heading) -> Measure | NonholonomicForm:
    """What a force at a point pushes along a direction."""
    along = names.direction(heading, "along")
    origin = names.ground_origin
    if along.body == GROUND:
        return Displacement(point, origin, along)
    # a direction that turns with a body: virtual power only, there is no displacement that it pushes
    x, y, z = (Displacement(point, origin, axis) for axis in AXES)
    parts = [(Component(along, "x"), x), (Component(along, "y"), y)]
    return NonholonomicForm((*parts, *([(Component(along, "z"), z)] if names.space else [])), LENGTH)


def unwound_along(names: Names, text: str, heading: Heading) -> Measure | None:
    """How far the outer end of a cord goes that is wound on a drum and pulled in a direction that stays: the way of the
    middle of the drum along it, and what comes off, s R per turn [rad], as the drum turns the way it is pulled."""
    from freebody.connections.string.laying import sense_of_drum  # what strings have is loaded where one is meant
    from freebody.connections.string.way import unwinds_from

    drum, along = unwinds_from(names, text, "at"), names.direction(heading, "along")
    if drum is None:
        return None
    if names.space or along.body != GROUND:
        told = Message("what is wound on a drum is pulled in a direction of the ground, in the plane; or by a string")
        names.problem(told, "at")
        return None
    arm = multiply(number(sense_of_drum(names, drum, along)), drum.radius)
    way = Displacement(drum.point, names.ground_origin, along)
    return Combination(((ONE, way), (arm, Angle(drum.body))), LENGTH)


class Force(Load, kind="force"):
    """`force: {at: rod.end, along: right, magnitude: F}`. The magnitude may depend on time `t` and on named
    measures and their rates; `along: rod.y` turns with the rod. A cord that is wound on a body and pulled at its outer
    end acts where it leaves the body, which does not turn with it: `at: wound on spool.hub at bottom`, or
    `wound on spool radius r at top`."""

    also: ClassVar[tuple[str, ...]] = ("Kraft",)

    at: str
    along: Heading
    magnitude: Formula
    at_most: Formula | None = None

    is_chosen = True
    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {
        **dict.fromkeys(WAYS, ("along", "magnitude")),
    }
    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("x", "y", "z", "components", "vector"),
            Message("it has a direction and a magnitude: {{along: [3, 4], magnitude: 5 N}}"),
        ),
        **dict.fromkeys(
            ("between", "from", "to", "pulls", "pushes"),
            Message(
                "what two bodies A and B exert on each other is a law of their distance: law: {{measure: gap, force: "
                "-F}} pulls with F, with measures: {{gap: distance from A to B}}"
            ),
        ),
        **dict.fromkeys(
            ("towards", "toward", "away_from"),
            Message(
                "a force that keeps pointing to a place is that of a string, tensioned_string: {{from: ground.P, to: "
                "block, tension: F}}; along takes a direction that stays: right, 30 deg, [3, 4]"
            ),
        ),
    }
    example = """
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {it: {force: {at: ball, along: right, magnitude: 2 N}}}
"""

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`down: F` is `along: down, magnitude: F`."""
        given = super().from_plain(value)
        if isinstance(given.get("at"), list) and isinstance(given.get("on"), str):
            del given["on"]  # one mistake: a point of a body has a name
        return with_way(given, "magnitude")

    @classmethod
    def in_words(cls, text: str) -> dict[str, Any] | None:
        """`5 N down at bar.end`, `5 N at bar.end down`."""
        if (said := _IN_WORDS.fullmatch(text.strip())) is None:
            return None
        way = said["way"] or said["way_then"]
        along = ALSO_WAYS.get(way, way)
        return {"at": said["at"] or said["at_first"], "along": along, "magnitude": said["magnitude"]}

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        if self.at.startswith(_WOUND):
            pushed = unwound_along(names, self.at, self.along)
        elif self._is_circle(names):
            return []
        else:
            pushed = pushed_along(names, names.point(self.at, "at"), self.along)
        magnitude, used = law(names, self.magnitude, FORCE, "magnitude")
        return [] if pushed is None else [AppliedLoad("", pushed, limited(names, self, magnitude, FORCE), used)]

    def _is_circle(self, names: Names) -> bool:
        """Whether it names a circle of a body in place of a point, which is told."""
        whole, _, part = self.at.partition(".")
        body = names.bodies.get(whole)
        if body is None or part not in body.middle_circles:
            return False
        told = Message(
            "{circle} is a circle: a cord that is wound on it and pulled acts at: wound on {circle} at bottom (or top, "
            "left, right), and a force in its middle at: {body}.center",
            circle=self.at,
            body=whole,
        )
        names.problem(told, "at")
        return True

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        along = names.direction(self.along, "along")
        if not self.at.startswith(_WOUND):
            yield glyphs.ForceArrow(names.point(self.at), along)
            return
        from freebody.connections.string.way import unwinds_from

        if (drum := unwinds_from(names, self.at, "at")) is not None:
            yield glyphs.ForceArrow(drum.point, along)
