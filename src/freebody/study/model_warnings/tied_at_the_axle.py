"""A string tied to the middle of a drum that turns there in a bearing, or of a disk that hangs by it alone: however it
turns, it winds nothing up."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, cast

from freebody.language.sentences import Message
from freebody.loads.gravity import Gravity
from freebody.measures.displacement import Displacement
from freebody.model.elements import RigidBody
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.connections.string.way import GivenWay


class TiedAtTheAxle(WarningKind, name="tied at the axle"):
    """An end that names a round body, as `from: drum`, is at its centre. Where that rests in a bearing and nothing else
    runs round the body, its rim is meant."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        ways = [
            (section, name, cast("GivenWay", element))
            for section, elements in (("connections", system.connections), ("loads", system.loads))
            for name, element in elements.items()
            if all(hasattr(element, field) for field in ("start", "to", "over", "path"))
        ]
        if not ways:
            return
        from freebody.connections.heavy_rope import HeavyRope  # imported where a model has a string
        from freebody.connections.string.way import is_tied_to, runs_round

        used = {place for _section, _name, way in ways for place in runs_round(way)}
        used |= {way.wound_on for _section, _name, way in ways if isinstance(way, HeavyRope) and way.wound_on}
        wheels = [body for body in system.moving if body.is_wheel and body.name not in used]
        drums = {body.name for body in wheels if _is_borne(system, body)}
        hung = {body.name for body in wheels if not body.solid.is_ball and _hangs_by_one(system, body)}
        for section, name, way in ways:
            for end, field in is_tied_to(way):
                if end in drums:
                    written = "wound_on: {0}" if isinstance(way, HeavyRope) else "wound on {0}"
                    told = Message(
                        "{string} is tied to the centre of {body}, which stays where it is while {body} turns. If the "
                        "rim is meant, on which it is wound, write {wound} in place of {body}; else {body}.center",
                        string=name,
                        body=end,
                        wound=written.format(end),
                    )
                    yield self.warning(told, section, name, *field, about=frozenset((name, end)))
                elif end in hung and not isinstance(way, HeavyRope) and getattr(way, "falls", 1) == 1:
                    told = Message(
                        "{string} is tied to the centre of {body}, so that nothing turns it. If it is wound on the "
                        "rim, write {wound} in place of {body}; else {body}.center",
                        string=name,
                        body=end,
                        wound=f"wound on {end}",
                    )
                    yield self.warning(told, section, name, *field, about=frozenset((name, end)))


def _hangs_by_one(system: System, body: RigidBody) -> bool:
    """Whether one connection holds a body, and nothing but its weight acts on it."""
    joints = {row.connection for row in system.rows if body.name in set(row.measure.bodies())}
    acting = {push.load for push in system.applied_loads if body.name in set(push.measure.bodies())}
    is_heavy_alone = all(isinstance(system.loads.get(load), Gravity) for load in acting)
    return len(joints) == 1 and is_heavy_alone and not body.start.moves


def _is_borne(system: System, body: RigidBody, seen: frozenset[str] = frozenset()) -> bool:
    """Whether a bearing holds its centre and lets it turn, or that of a wheel on one shaft with it: one that is welded
    to it middle to middle. seen: wheels that are looked at already."""
    n_axes, seen = 3 if system.space else 2, seen | {body.name}
    for name in system.connections:
        measures = [row.measure for row in system.rows if row.connection == name]
        held = [m for m in measures if isinstance(m, Displacement) and body.center in (m.of, m.origin)]
        if len(held) >= n_axes and len(measures) < 3 * (n_axes - 1):
            return True
        middles = [{m.of, m.origin} for m in held if m.origin is not None]
        for other in system.moving if len(measures) == 3 * (n_axes - 1) else ():
            is_welded = other.is_wheel and middles.count({body.center, other.center}) >= n_axes
            if is_welded and other.name not in seen and _is_borne(system, other, seen):
                return True
    return False
