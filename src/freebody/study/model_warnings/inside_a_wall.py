"""A body that starts partly inside a wall which it does not know of, since no contact joins the two."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.model.elements import Line, RigidBody
from freebody.model.glyphs import Pin, Surface, Track
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class InsideAWall(WarningKind, name="inside a wall"):
    """A body that lies across a line of the ground on which others roll or with which they have a contact. Bodies that
    turn about a point of the ground are left out: the pulley at the top of an incline is drawn across its line."""

    explains = frozenset(("out of reach",))

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        if system.space:
            return
        for called, line in system.bodies[GROUND].lines.items():
            touching, rolling = _touching(model, line), _rolling(model, line)
            if not touching | rolling:
                continue
            near = _joined(model, touching | rolling)
            for body in system.moving:
                if _is_hinged(model, body):
                    continue
                low, high = self._sides(model, body, line)
                about = frozenset((body.name, called))
                if body.name in touching and low < -model.close:
                    told = Message(
                        "{body} starts inside {line}, which is solid on the right of its direction: move {body}, or "
                        "turn the line round ({round})",
                        body=body.name,
                        line=called,
                        round=_turned_round(model, line),
                    )
                    yield self.warning(told, "bodies", body.name, about=about)
                elif body.name not in near and low < -model.close and high > model.close:
                    told = Message(
                        "{body} starts partly inside {line}, and nothing keeps it out: move it, or add a contact: "
                        "{{contact: {{between: [{body}, {line}]}}}}",
                        body=body.name,
                        line=called,
                    )
                    yield self.warning(told, "bodies", body.name, about=about)

    def _sides(self, model: Opened, body: RigidBody, line: Line) -> tuple[float, float]:
        """[m] from where to where a body is on the left of a line; (0, 0) for one without extent."""
        normal, number = line.direction.normal(), model.reference.number

        def side(point_name: str | None) -> float:
            return model.start.value(Displacement(body.point(point_name), line.through, normal))

        if body.radius is not None:
            own = [number(r) for r in (body.radius, *body.middle_circles.values())]
            return side(None) - min(own), side(None) + max(own)  # a hub may run on a rail beside which its rim hangs
        # points of a body without a shape are places at which something acts, as those of a bracket round a post
        ends = ("start", "end") if body.edges else ()
        sides = [side(name) for name in body.points if name in (*body.corners, *ends)]
        return min(sides, default=0.0), max(sides, default=0.0)


def _turned_round(model: Opened, line: Line) -> str:
    """What to write so that the other side of a line is solid: the side by name, where it is one of four."""
    x, y = (round(model.reference.number(c), 9) for c in line.direction.normal().components)
    side = {(1.0, 0.0): "right", (-1.0, 0.0): "left", (0.0, 1.0): "up", (0.0, -1.0): "down"}.get((x, y))
    return Message("the other way along") if side is None else f"solid: {side}"


def _touching(model: Opened, line: Line) -> set[str]:
    """The bodies of which something may touch a line."""
    found: set[str] = set()
    for shown in model.system.glyphs:
        sign = shown.sign
        if isinstance(sign, Surface) and (sign.along, sign.through) == (line.direction, line.through):
            found |= {tip.body for tip in sign.tips}
    return found


def _rolling(model: Opened, line: Line) -> set[str]:
    """The bodies that roll on a line."""
    tracks = [shown.sign for shown in model.system.glyphs if isinstance(shown.sign, Track)]
    return {track.center.body for track in tracks if track.along == line.direction and not track.is_toothed}


def _joined(model: Opened, users: set[str]) -> set[str]:
    """These, and bodies that touch them or are joined to them: the wall is meant to end there."""
    ties = [set(row.measure.bodies()) - {GROUND} for row in model.system.rows]
    return users | {body for tie in ties if tie & users for body in tie}


def _is_hinged(model: Opened, body: RigidBody) -> bool:
    pins = [shown.sign for shown in model.system.glyphs if isinstance(shown.sign, Pin)]
    return any({pin.first.body, pin.second.body} == {GROUND, body.name} for pin in pins)
