"""A rack that moves across its teeth: the distance from the pinion to the teeth changes, and nothing holds it."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.model.glyphs import Track
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_NOTHING = 1e-7  # of the size of the system, a second


class TeethApart(WarningKind, name="teeth apart"):
    """A toothed straight line that the constraints let come nearer to the middle of its pinion, or go away from it."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        for shown in system.glyphs:
            sign = shown.sign
            if not isinstance(sign, Track) or not sign.is_toothed or system.space:
                continue
            rack, pinion = sign.along.body, sign.center.body
            apart = Displacement(sign.center, system.bodies[rack].center, sign.along.normal())
            small = _NOTHING * model.reference.sizes.length
            if any(abs(pose.rate(apart)) > small for pose in model.elsewhere):
                told = Message(
                    "the teeth of {rack} and {pinion} come apart or are pressed into each other as they move: guide "
                    "{guided} along the teeth (slot: {{pin: {guided}, along: ...}}), or turn the teeth with along",
                    rack=rack,
                    pinion=pinion,
                    guided=pinion if system.bodies[rack].fixed else rack,
                )
                yield self.warning(told, "connections", shown.owner, about=frozenset((shown.owner, rack, pinion)))
