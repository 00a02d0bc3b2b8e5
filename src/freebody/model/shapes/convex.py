"""A homogeneous body with plane faces: the convex hull of given points.

Cut into the tetrahedra between a corner O and the triangles a, b, c of the faces that do not meet in it, with
D = a . (b x c), from O,

    V = sum D/6,     V r_G = sum D (a + b + c)/24,
    integral of x_i x_j dV = sum D/120 ((a + b + c)_i (a + b + c)_j + a_i a_j + b_i b_j + c_i c_j)

Source: Tonon, Journal of Mathematics and Statistics 1 (2005) 8-11.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, ClassVar

from pydantic import Field

from freebody.language.expression import Expr, divide, free_symbols, name_problem
from freebody.language.sentences import Message, listed
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO, Components
from freebody.model.hulls import MOST_POINTS, faces_of_hull
from freebody.model.noting import did_you_mean
from freebody.model.polynomials import Polynomial, constant, cross, dot, polynomial
from freebody.model.shapes.base import Build, Shape
from freebody.model.solids import CONVEX
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names

Vertex = tuple[Polynomial, ...]
ENTRIES = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


class Convex(Shape, kind="convex"):
    """`convex: {mass: m, points: [[0, 0, 0], [a, 0, 0], [0, b, 0], [0, 0, c]]}`: a homogeneous body with plane faces,
    the convex hull of its points: a wedge, a prism, a pyramid, a tetrahedron. For models in space.

    The points count from its reference point, `origin`, and are points of the body: `corner1`, `corner2` ... in the
    order in which they stand, or by names of their own, `points: {A: [0, 0, 0], B: [a, 0, 0], ...}`. Its faces are
    `face1`, `face2` ... : each begins with its earliest corner and goes on counter-clockwise as seen from outside, and
    they are ordered as these lists are. `faces: {slope: [A, B, C]}` gives the face with these corners a name."""

    space_only = True
    in_plane_take = "polygon"

    called: ClassVar[tuple[str, ...]] = ("wedge", "prism", "pyramid", "tetrahedron", "block")

    mass: Formula = 0
    points: list[list[Formula]] | dict[str, list[Formula]]
    faces: dict[str, list[str]] = Field(default_factory=dict[str, list[str]])

    example = "{mass: 1 kg, points: [[0, 0, 0], [0.3 m, 0, 0], [0, 0.4 m, 0], [0, 0, 0.5 m]]}"

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        n_before = len(names.problems)
        places = self._places(names)
        nothing = Build(m, ZERO, points={"origin": names.origin}, default_point="origin", tensor=(ZERO,) * 6)
        if len(names.problems) > n_before or (hull := _hull(names, places)) is None:
            return nothing
        exact = {name: tuple(polynomial(c) for c in place) for name, place in places.items()}
        if not _are_flat(names, exact, hull):
            return nothing
        middle, tensor = mass_properties(m, exact, hull)
        faces = dict(zip(self._called(names, hull), hull, strict=True))
        points = places | {"origin": names.origin}
        return Build(
            m, tensor[2], middle, points, default_point="origin", tensor=tensor, solid=CONVEX, faces=(*faces.items(),)
        )

    def _places(self, names: Names) -> dict[str, Components]:
        """The points by name; problems are noted."""
        is_named = isinstance(self.points, dict)
        given = self.points.items() if isinstance(self.points, dict) else enumerate(self.points, 1)
        found: dict[str, Components] = {}
        for key, value in given:
            name = str(key) if is_named else f"corner{key}"
            path = "points", key if is_named else int(key) - 1
            if name in ("origin", "center", "mass_center"):
                names.problem(Message("{name} is there already; call it otherwise", name=name), *path)
            elif problem := name_problem(name):
                names.problem(problem, *path)
            found[name] = names.components(value, LENGTH, *path)
        return found

    def _called(self, names: Names, hull: list[tuple[str, ...]]) -> list[str]:
        """The names of the faces."""
        own: dict[frozenset[str], str] = {}
        known = {corner for face in hull for corner in face}
        for name, corners in self.faces.items():
            if unknown := [corner for corner in corners if corner not in known]:
                hint = did_you_mean(unknown[0], known)
                told = Message("there is no corner {name}.{hint}", name=unknown[0], hint=hint)
                names.problem(told, "faces", name)
            elif not any(set(corners) == set(face) for face in hull):
                there = listed(["-".join(face) for face in hull])
                told = Message("no face has the corners {names}; there is {there}", names=listed(corners), there=there)
                names.problem(told, "faces", name)
            own[frozenset(corners)] = name
        return [own.get(frozenset(face), f"face{k}") for k, face in enumerate(hull, 1)]


def _hull(names: Names, places: dict[str, Components]) -> list[tuple[str, ...]] | None:
    """The faces, by the names of their corners; None, with a problem noted, where there are none."""
    numbers: list[tuple[float, float, float]] = []
    for name, place in places.items():
        x, y, z = (names.numeric(c) for c in place)
        if x is None or y is None or z is None:
            unknown = sorted({s for c in place for s in free_symbols(c) if names.numeric(c) is None})
            told = Message(
                "which faces a convex body has is seen from numbers; give {names} a value, for {corner}",
                names=listed(unknown),
                corner=name,
            )
            names.problem(told, "points")
            return None
        numbers.append((x, y, z))
    if len(numbers) > MOST_POINTS:
        told = Message("a convex body has at most {most} points, found {n}", most=MOST_POINTS, n=len(numbers))
        names.problem(told, "points")
        return None
    faces = faces_of_hull(numbers) if len(numbers) > 3 else []
    if not faces:
        told = Message("a convex body needs four points that are not in one plane; a plate is a polygon")
        names.problem(told, "points")
        return None
    order = list(places)
    return [tuple(order[k] for k in face) for face in faces]


def _are_flat(names: Names, exact: dict[str, Vertex], hull: list[tuple[str, ...]]) -> bool:
    """Whether the faces are flat whatever the parameters are, and not by their values alone; a problem is noted."""
    for face in hull:
        first = exact[face[0]]
        normal = cross(_minus(exact[face[1]], first), _minus(exact[face[2]], first))
        for corner in face[3:]:
            height = dot(normal, _minus(exact[corner], first))
            if not height.is_zero and free_symbols(height.expression()):
                told = Message(
                    "the corners {names} lie in one plane for the given values alone; write their places so that they "
                    "always do, or as numbers",
                    names=listed(face),
                )
                names.problem(told, "points")
                return False
    return True


def _minus(a: Vertex, b: Vertex) -> Vertex:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def mass_properties(mass: Expr, exact: dict[str, Vertex], hull: list[tuple[str, ...]]) -> tuple[Components, Components]:
    """The mass centre, and the tensor about it, of a homogeneous polyhedron."""
    apex = hull[0][0]
    volume, first = constant(0), [constant(0)] * 3
    second = [constant(0)] * 6
    for triangle in _triangles(hull, apex):
        a, b, c = (_minus(exact[corner], exact[apex]) for corner in triangle)
        size = dot(a, cross(b, c))
        total = [x + y + z for x, y, z in zip(a, b, c, strict=True)]
        volume = volume + size.scaled(Fraction(1, 6))
        first = [old + (size * t).scaled(Fraction(1, 24)) for old, t in zip(first, total, strict=True)]
        for n, (i, j) in enumerate(ENTRIES):
            moment = total[i] * total[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]
            second[n] = second[n] + (size * moment).scaled(Fraction(1, 120))
    arm = [_ratio(f, volume) for f in first]
    middle = tuple(
        polynomial(x + y).expression() for x, y in zip((o.expression() for o in exact[apex]), arm, strict=True)
    )
    # about the mass centre: (S_ij V - F_i F_j)/V^2
    spread = [
        _ratio(s * volume - first[i] * first[j], volume * volume) for s, (i, j) in zip(second, ENTRIES, strict=True)
    ]
    x, y, z, xy, xz, yz = (polynomial(mass * part).expression() for part in spread)
    return middle, (_sum(y, z), _sum(x, z), _sum(x, y), -xy, -xz, -yz)


def _triangles(hull: list[tuple[str, ...]], apex: str) -> Iterator[tuple[str, str, str]]:
    for face in hull:
        if apex not in face:
            yield from ((face[0], b, c) for b, c in pairwise(face[1:]))


def _ratio(a: Polynomial, b: Polynomial) -> Expr:
    quotient = a.over(b)
    return divide(a.expression(), b.expression()) if quotient is None else quotient.expression()


def _sum(a: Expr, b: Expr) -> Expr:
    return polynomial(a + b).expression()
