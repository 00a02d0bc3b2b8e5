"""The table of principles: every equation that may be written for a body or for several together.

Newton-Euler gives one equation for every slot of a body (two forces and a moment about its mass centre; in space six).
A principle is a combination of these with weights:

    linear momentum along e           weights e on the forces of each body
    angular momentum about O along k  weights k x r_OG on the forces, k on the moment of each body

so that   sum w . (rate of momentum) = sum w . (loads) + sum over reactions of R * (w . direction).
A reaction drops out where its w . direction vanishes: internal to the bodies, perpendicular to e, or with a line of
action through O. Which directions and points these are is asked of the places of the plane or of space.
Source: Hibbeler, Engineering Mechanics: Dynamics, 14th ed. 2016, sec. 17.2-17.5.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

from freebody.narrative.principles.acting import Acting, Slot
from freebody.narrative.principles.places import Aim, MomentAxis, MomentCentre, PlanarPlaces, PrinciplePlaces
from freebody.narrative.principles.spatial_places import SpatialPlaces
from freebody.symbolic.ratio import Ratio

Kind = Literal["linear", "angular"]


@dataclass(frozen=True)
class WritablePrinciple:
    """One equation that may be written: momentum along `aim`, or moments about `centre` (in space along `aim`)."""

    bodies: tuple[str, ...]
    kind: Kind
    weights: Mapping[Slot, Ratio]
    aim: Aim | None = None
    centre: MomentCentre | None = None
    is_clockwise: bool = False


class PrincipleTable:
    """All principles of a system, for what acts there."""

    def __init__(self, acting: Acting) -> None:
        self.acting = acting
        self.model, self.system = acting.model, acting.system
        self.places: PrinciplePlaces = SpatialPlaces(acting) if self.system.space else PlanarPlaces(acting)

    def groups(self) -> Iterator[tuple[str, ...]]:
        """Each body, then those that connections join, up to the whole system."""
        names = [body.name for body in self.system.moving]
        if self.acting.stands_still and not self.acting.is_at_rest:  # nodes in the order of the file
            written = [*(self.system.document.data.get("bodies") or ())]
            names.sort(key=lambda name: written.index(name) if name in written else len(written))
        yield from ((name,) for name in names)
        joined = [{b for b, _slot in slopes if b in names} for slopes in self.acting.directions.values()]
        for size in self.places.sizes(len(names)):
            for group in combinations(names, size):
                if _is_connected(set(group), joined):
                    yield group

    def of(self, bodies: tuple[str, ...]) -> Iterator[WritablePrinciple]:
        """All principles for some bodies together."""
        places = self.places
        for aim in places.aims(bodies):
            weights = {slot: w for body in bodies for slot, w in self._on(body, aim.vector)}
            yield WritablePrinciple(bodies, "linear", _without_zeros(weights), aim=aim)
        axes = places.axes(bodies)
        for centre in places.centres(bodies) if axes else ():
            for axis in axes:
                yield self._angular(bodies, centre, axis)

    def _angular(self, bodies: tuple[str, ...], centre: MomentCentre, axis: MomentAxis) -> WritablePrinciple:
        weights: dict[Slot, Ratio] = {}
        for body in bodies:
            arm = tuple(x - o for x, o in zip(self.places.position(body), centre.place, strict=True))
            parts = [*self.places.across(axis, arm)]
            if self.system.bodies[body].turns:
                parts += self.places.turning(axis, body)
            weights.update(self._on(body, parts))
        return WritablePrinciple(bodies, "angular", _without_zeros(weights), aim=axis.aim, centre=centre)

    def _on(self, body: str, parts: Sequence[Ratio]) -> list[tuple[Slot, Ratio]]:
        """Weights on a body, along its slots."""
        return [((body, slot), self.acting.here(w)) for slot, w in zip(self.model.bodies.slots, parts, strict=False)]


def _without_zeros(weights: Mapping[Slot, Ratio]) -> dict[Slot, Ratio]:
    return {slot: w for slot, w in weights.items() if not w.is_zero()}


def _is_connected(group: set[str], joined: Sequence[set[str]]) -> bool:
    reached, grows = {min(group)}, True
    while grows:
        before = len(reached)
        for pair in joined:
            inside = pair & group
            if inside & reached:
                reached |= inside
        grows = len(reached) > before
    return reached == group
