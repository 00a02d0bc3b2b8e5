"""Solids: what shapes look like in space, by a closed vocabulary as that of signs is (`glyphs`).

A shape names one and its sizes. What is true of it is said here; who draws asks for that, and has for each solid how it
is built (`present.space.bodies`). A solid is added to the vocabulary together with how it is drawn; a shape is not.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SolidKind:
    """What follows for pictures."""

    name: str = ""
    is_round: bool = False  # it looks alike all round an axis
    is_ball: bool = False  # it looks alike from everywhere
    is_hoop: bool = False  # a thin rim with room inside
    is_sheet: bool = False  # nothing is inside it
    is_shaft: bool = False  # a joint at its end is as thick as it is
    is_tapered: bool = False  # its reference point is its tip: arms begin at its mass centre
    has_flat_end: bool = False  # on which its radius is drawn
    has_lengths: bool = True  # lengths between its points are drawn along it
    is_end: bool = False  # its place is that of an end of it: the rest of it is drawn by a sign
    is_mesh: bool = False  # its edges are triangles, counter-clockwise as seen from outside
    has_hollows: bool = False  # it is not convex: what touches of it is its hull
    is_thick: bool = False  # what turns about its middle keeps outside its radius

    @property
    def has_radius_from_center(self) -> bool:
        """Whether it is built of its radius about its reference point, and has no flat faces."""
        return self.is_ball or self.is_hoop


NO_SOLID = SolidKind()
DISK = SolidKind("disk", is_round=True, has_flat_end=True, has_lengths=False)  # sizes [m]: radius
RING = SolidKind("ring", is_round=True, is_hoop=True, has_lengths=False)  # radius
SPHERE = SolidKind("sphere", is_ball=True, is_thick=True, has_lengths=False)  # radius
ELLIPSOID = SolidKind("ellipsoid", is_thick=True, has_lengths=False)  # semi-axes along x, y, z; about its middle
CYLINDER = SolidKind("cylinder", is_round=True, is_shaft=True, has_flat_end=True, is_thick=True)  # radius, length
CONE = SolidKind("cone", is_round=True, is_tapered=True)  # radius, height
FRUSTUM = SolidKind("frustum", is_round=True)  # radius of the base, of the top, height; from its reference point
DOME = SolidKind("dome")  # radius; half a ball about its own x from its reference point
ROD = SolidKind("rod")  # length
BOX = SolidKind("box")  # along x, y, z
CONVEX = SolidKind("convex", has_lengths=False)  # none: it has corners and faces
MESH = SolidKind("mesh", is_mesh=True, has_lengths=False)  # none
HOLLOWED_MESH = SolidKind("mesh with hollows", is_mesh=True, has_hollows=True, has_lengths=False)  # none
PLATE = SolidKind("plate", is_sheet=True)  # none: it has corners or a curved edge
ROPE = SolidKind("rope", is_end=True)  # length
