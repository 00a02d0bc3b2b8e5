"""What the two parts of a cut rod exert on each other across the cut, in the grammar: at a point of its axis."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from freebody.measures.displacement import Displacement
from freebody.model.elements import RigidBody
from freebody.model.solids import ROD
from freebody.questions.spoken import joining, lookup
from freebody.questions.spoken.composing import JOINT, SILENT, Groups, composed, said_of
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_SIDES = ("just before", "just behind", "left of", "right of")
_UPRIGHT = 1e-6  # cosine of the angle of a rod that has no left end
_GREATEST = {"bending moment": "bending moment", "shear force": "shear force", "transverse force": "shear force"}


@said_of("bending moment", "shear force", "transverse force")
def _across_the_cut(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of the rod that is named, or of the one that has the point; a transverse force elsewhere is that of a guide."""
    of = [_cut_at(names, name) for _, name in rest.names]
    rods = [name for name, body in names.bodies.items() if body.solid is ROD]
    points = [name for name in of if name.partition(".")[0] in rods and "." in name]
    named = [name for name in of if name in rods]
    if quantity == "transverse force" and not points and of == named and rods and lookup.rests(names):
        return  # it changes along a beam: where is to be said
    if quantity == "transverse force" and not points:
        yield from composed(names, "normal force", rest)
        return
    if any(not before and name in names.loads for before, name in rest.names):
        return  # a shear force is none of the loads, and nothing says at which of them
    if not rest.only("name", *SILENT) or len(points) != 1 or of not in (points, [*named, *points], [*points, *named]):
        return
    rod = points[0].partition(".")[0]
    if named in ([], [rod]) and (side := _side(names, rod, rest)):
        yield [f"{quantity.replace('transverse', 'shear')} of {rod} {side} {points[0]}"]


def _side(names: Names, rod: str, rest: Clause) -> str:
    """On which side of a point: towards the start of the rod it is just before it; left and right are those of the
    rod as it lies. Nothing where it stands upright."""
    said = [before for before, _ in rest.names if before in _SIDES]
    if not said or said[0].startswith("just "):
        return said[0] if said else "at"
    way = to_the_right(names, names.bodies[rod])
    return "" if not way else "just before" if (way > 0) == (said[0] == "left of") else "just behind"


def to_the_right(names: Names, rod: RigidBody) -> int:
    """1 for a rod that goes to the right from its start, -1 for one to the left, 0 where neither is known."""
    angle = rod.start.angle
    way = None if angle is None else names.numeric(angle)
    along = 0.0 if way is None else math.cos(way)
    return 0 if abs(along) < _UPRIGHT else 1 if along > 0.0 else -1


def without_load(names: Names, clause: Clause) -> list[str]:
    """Where the shear force, or the bending moment, of a rod is zero."""
    rods = [name for name, body in names.bodies.items() if body.solid is ROD]
    of = [name for _, name in clause.names]
    is_asked = clause.has("ask", "where") or clause.all("quantity")[:1] in (["position"], ["distance"])
    what = _GREATEST.get((clause.all("quantity") or [""])[-1], "")
    if not (is_asked and what and clause.has("verb", "vanish")) or len(of) > 1 or not {*of} <= {*rods}:
        return []
    return [f"place of zero {what} of {rod}" for rod in of or rods]


def greatest(names: Names, clause: Clause) -> list[str]:
    """Where a rod is bent, sheared or pulled most, and how much; nothing where a point is named."""
    of = [name for _, name in clause.names]
    rods = [name for name, body in names.bodies.items() if body.solid is ROD]
    (kind, *more) = [*clause.all("quantity"), ""]
    if kind == "moment" and {*of} <= {*rods} and of and not names.measures and lookup.rests(names):
        kind = "bending moment"  # of a beam that bears a load
    is_place = more[:-1] in (["position"], ["distance"])
    if kind in ("position", "distance") and len(more) > 1:
        (kind, *more), is_place = more, True
    if kind not in _GREATEST or not (is_place or more in ([], [""])) or "greatest" not in clause.all("degree"):
        return []
    if not clause.only("quantity", "degree", "name", "ask", "verb", *SILENT) or clause.has("degree", "least"):
        return []
    if len(of) > 1 or not {*of} <= {*rods}:
        return []
    found = [f"greatest {_GREATEST[kind]} of {rod}" for rod in of or rods]
    if not is_place and not clause.has("ask", "where"):
        return found
    places = [f"place of the {one}" for one in found]
    if clause.has("preposition", "and"):  # how great it is, and where
        return [JOINT.join(both) for both in zip(found, places, strict=True)]
    return places


def _cut_at(names: Names, name: str) -> str:
    """For a connection that holds one point of a rod that point: at the wall; for a force the one at which it acts:
    under the load. Else the name."""
    if name in names.loads and name not in names.bodies:
        acting = [push.measure for push in names.applied_loads if push.load == name]
        at = {measure.of.name for measure in acting if isinstance(measure, Displacement)}
        return at.pop() if len(at) == 1 == len(acting) else name
    if name not in names.connections or name in names.bodies:
        return name
    ends = [end for end in joining.ends_of(names, name) if "." in end and end.partition(".")[0] in lookup.moving(names)]
    return ends[0] if len(ends) == 1 else name
