"""A body that the start turns although nothing says how it lies.

What a file leaves open is chosen so that everything fits, with as little change as possible; a body that is only
touched may then come to lie aslant. Where it fits with its axes along those of the ground as well, nothing in the file
says which of the two is meant.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, degrees

from freebody.errors import FreebodyError
from freebody.language.sentences import Message
from freebody.measures.geometry import AXES, Direction, unit
from freebody.model.elements import RigidBody, UnilateralConstraint
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_TURNED = 1e-3  # [rad] less is round-off of a pose that is closed


class TurnedOpen(WarningKind, name="turned open"):
    """The start turns a body, and fits without turning it too."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        if not model.system.bounds:
            return
        from freebody.numeric.contact.start import lying_flat  # imported where a model has contacts

        flat = lying_flat(model.reference)
        for body in model.system.moving:
            start, near = body.start, body.start.near
            is_said = start.angle is not None or start.turned is not None or near is not None
            is_open = body.turns and not is_said and body.name not in flat and _is_only_touched(model, body.name)
            is_open = is_open and not _lies_on_a_side(model, body.name)
            angle = _angle(model, body) if is_open else 0.0
            if angle > _TURNED and _fits_unturned(model, body.name):
                told = Message(
                    "nothing says how {body} is turned: it is taken to be turned by {angle} deg from the axes of the "
                    "ground, and could as well not be turned. Say it with {key} in {body}",
                    body=body.name,
                    angle=f"{degrees(angle):.3g}",
                    key="turned: 0 deg about z" if model.system.space else "angle: 0",
                )
                yield self.warning(told, "bodies", body.name, about=frozenset({body.name}))


def _is_only_touched(model: Opened, body: str) -> bool:
    """Whether all that holds a body are sides that it touches."""
    rows = [row for row in model.system.constraint_rows if body in row.measure.bodies()]
    return all(row.unilateral or row.reaction.startswith("friction") for row in rows)


def _lies_on_a_side(model: Opened, body: str) -> bool:
    """Whether a contact names a side of a body, and both ends of that side touch: the file says how it lies."""
    from freebody.numeric.contact.overlaps import PENETRATION, gap_of

    places: dict[str, list[UnilateralConstraint]] = {}
    for bound in model.system.bounds:
        if bound.row.ends[0].partition(".")[0] == body:
            places.setdefault(bound.family, []).append(bound)
    g, size = model.start.geometry, PENETRATION * model.reference.sizes.length
    return any(
        len(ends) == 2 and all(abs(gap_of(model.reference, g, end)) <= size for end in ends) for ends in places.values()
    )


def _angle(model: Opened, body: RigidBody) -> float:
    """[rad] by which a body is turned from the axes of the ground."""
    x, y, z = (unit(model.start.geometry, Direction(body.name, axis.components)) for axis in AXES)
    cosine = (x.x + y.y + z.z - 1.0) / 2.0 if model.system.space and z.z is not None else x.x
    return acos(min(1.0, max(-1.0, float(cosine.value))))


def _fits_unturned(model: Opened, body: str) -> bool:
    """Whether the start closes with the axes of the body along those of the ground."""
    from freebody.study.pictures.instant import start_of  # which brings all that contacts need
    from freebody.system.system import System

    key, value = ("turned", "0 deg about z") if model.system.space else ("angle", 0)
    try:
        start_of(System.from_document(model.system.document.with_value(("bodies", body, key), value)), at_rest=True)
    except FreebodyError:
        return False
    return True
