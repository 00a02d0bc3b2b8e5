"""Gears whose connections hold their centres where the pitch circles do not touch."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from freebody.language.expression import add, free_symbols
from freebody.language.sentences import Message
from freebody.measures.distance import Distance
from freebody.model.glyphs import Wheels
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_SAME = 1e-6  # of the distance that is needed


class GearsApart(WarningKind, name="gears apart"):
    """A mesh at whose start the centres are not as far apart as the radii say. What the file itself puts there is told
    when it is read."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        known = {name for name, p in system.parameters.items() if p.value is not None}
        for shown in system.glyphs:
            sign = shown.sign
            if not isinstance(sign, Wheels) or not sign.is_toothed or system.space:
                continue
            gears = sign.first.body, sign.second.body
            if all(name not in system.bodies or system.bodies[name].start.at is not None for name in gears):
                continue
            if not free_symbols(add(*sign.radii)) <= known:
                continue  # nothing says how large they are
            radii = [float(model.reference.number(radius)) for radius in sign.radii]
            needed = abs(sum(radii))
            apart = float(model.start.value(Distance(sign.first, sign.second)))
            if abs(apart - needed) <= _SAME * needed:
                continue
            told = _as_in_a_ring_gear(gears, radii, apart) or Message(
                "the centres of {first} and {second} are {apart:.4g} m apart, and their pitch circles touch at "
                "{needed:.4g} m: the ratio is that of the radii, but such gears do not mesh",
                first=gears[0],
                second=gears[1],
                apart=apart,
                needed=needed,
            )
            yield self.warning(told, "connections", shown.owner, about=frozenset((shown.owner, *gears)))


def _as_in_a_ring_gear(gears: tuple[str, str], radii: Sequence[float], apart: float) -> Message | None:
    """That one pitch circle touches the other from within, where the gears are said to be outside of each other."""
    needed = abs(radii[0] - radii[1])
    if min(radii) < 0.0 or abs(apart - needed) > _SAME * sum(radii):
        return None
    ring, planet = gears if radii[0] > radii[1] else gears[::-1]
    return Message(
        "the pitch circle of {planet} lies inside that of {ring} and touches it, as in a ring gear, but the teeth are "
        "taken to be outside: write gear_mesh: {{first: {ring}, second: {planet}, internal: true}}",
        planet=planet,
        ring=ring,
    )
