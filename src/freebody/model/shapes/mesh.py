"""A homogeneous body whose surface is given by triangles in a file (`model.meshes`)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, ClassVar

from freebody.errors import UnitError
from freebody.language.expression import Expr, number
from freebody.language.sentences import Message
from freebody.language.units import DENSITY, LENGTH, MASS, parse_quantity
from freebody.measures.geometry import ZERO, Components
from freebody.model.elements import Edge
from freebody.model.meshes import Triangulated, read_mesh, read_silhouette
from freebody.model.shapes.base import Build, Shape
from freebody.model.solids import HOLLOWED_MESH, MESH
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Mesh(Shape, kind="mesh"):
    """`mesh: {file: part.stl, unit: mm, mass: 2 kg}`: a homogeneous body whose surface is a file of triangles, in the
    folder of the model: STL, OBJ, PLY or OFF. Its mass, or its `density`, is given; its mass centre and its moments of
    inertia follow from the triangles, which must be closed and go counter-clockwise as seen from outside. Such files
    have no unit: `unit` says it. Needs the extra `mesh`.

    Its frame is that of the file, its reference point the `origin` there. In contacts its convex hull touches, where
    that has at most 40 corners: they are points of the body, `corner1`, `corner2` ... , in space its faces `face1`,
    `face2` ... A planar model sees it against the z axis of the file and takes its moment of inertia about that;
    `normal: x` or `normal: y` for another axis, then x is the file's y or z."""

    needs_file = True

    called: ClassVar[tuple[str, ...]] = ("part", "casting", "component")

    file: str
    unit: str = ""
    mass: Formula | None = None
    density: Formula | None = None
    normal: str = ""

    example = "{file: part.stl, unit: mm, mass: 2 kg}"

    def build(self, names: Names) -> Build:
        unit, given, normal = self._unit(names), self._given(names), self._normal(names)
        if unit is None or given is None or normal is None:
            return self._nothing(names, given)
        return self._in_space(names, unit, given) if names.space else self._in_plane(names, unit, given, normal)

    def _nothing(self, names: Names, given: Expr | None) -> Build:
        """In place of what cannot be read."""
        mass = ZERO if self.mass is None or given is None else given
        tensor = (ZERO,) * 6 if names.space else ()
        return Build(mass, ZERO, names.origin, {"origin": names.origin}, default_point="origin", tensor=tensor)

    def _in_space(self, names: Names, unit: Fraction, given: Expr) -> Build:
        found = read_mesh(names, self.file, unit)
        if found is None:
            return self._nothing(names, given)
        if found.is_drawn_coarsely:
            told = Message("pictures show {file} by a coarse hull: it has many triangles", file=self.file)
            names.assumptions.append(told)
        mass = given if self.mass is not None else given * number(found.volume)
        tensor = tuple(mass * number(part) for part in found.spread)
        return Build(
            mass,
            tensor[2],
            _components(found.center),
            {"origin": names.origin, **_corners(found.hull[0])},
            default_point="origin",
            tensor=tensor,
            solid=MESH if found.is_convex else HOLLOWED_MESH,
            edges=tuple(Edge(tuple(_components(at) for at in triangle)) for triangle in found.drawn),
            faces=_faces(found),
        )

    def _in_plane(self, names: Names, unit: Fraction, given: Expr, normal: int) -> Build:
        found = read_silhouette(names, self.file, unit, normal)
        if found is None:
            return self._nothing(names, given)
        if found.leans:
            told = Message(
                "{file} is not alike on both sides of the plane: what guides it in the plane also bears moments about "
                "axes in the plane, which are not looked at",
                file=self.file,
            )
            names.assumptions.append(told)
        mass = given if self.mass is not None else given * number(found.volume)
        corners = _corners(found.hull)
        return Build(
            mass,
            mass * number(found.spread),
            _components(found.center),
            {"origin": names.origin, **corners},
            default_point="origin",
            corners=tuple(corners),
            edges=tuple(
                Edge(tuple(_components(at) for at in places), "hole" if is_hole else "area")
                for places, is_hole in found.drawn
            ),
        )

    def _normal(self, names: Names) -> int | None:
        """The number of the axis against which a planar model sees it; None with a problem noted."""
        if self.normal and names.space:
            names.problem(Message("normal is for planar models: in space all axes of the file count"), "normal")
            return None
        if self.normal not in ("", "x", "y", "z"):
            told = Message("the normal of the plane is an axis of the file: x, y or z, not {x}", x=self.normal)
            names.problem(told, "normal")
            return None
        return "xyz".index(self.normal or "z")

    def _unit(self, names: Names) -> Fraction | None:
        """[m]; None with a problem noted."""
        if not self.unit:
            told = Message("{file} does not say in which unit it is: write e.g. unit: mm", file=self.file)
            names.problem(told)
            return None
        try:
            quantity = parse_quantity(f"1 {self.unit}")
        except UnitError as error:
            names.problem(error.args[0], "unit")
            return None
        if quantity.dimension != LENGTH:
            names.problem(Message("{unit} is no unit of length", unit=self.unit), "unit")
            return None
        return Fraction(repr(quantity.value)) if quantity.exact is None else Fraction(quantity.exact)

    def _given(self, names: Names) -> Expr | None:
        """The mass or the density; None with a problem noted."""
        if (self.mass is None) == (self.density is None):
            names.problem(Message("a mesh has either a mass or a density: give one of the two"))
            return None
        return names.optional(self, "mass", MASS) or names.optional(self, "density", DENSITY)


def _components(at: Sequence[Fraction]) -> Components:
    return tuple(number(c) for c in at)


def _corners(hull: Iterable[Sequence[Fraction]]) -> dict[str, Components]:
    return {f"corner{k}": _components(at) for k, at in enumerate(hull, 1)}


def _faces(found: Triangulated) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Those of the hull, by the names of their corners."""
    return tuple((f"face{n}", tuple(f"corner{k + 1}" for k in corners)) for n, corners in enumerate(found.hull[1], 1))
