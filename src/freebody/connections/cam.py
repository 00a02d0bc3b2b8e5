"""Cam: a plate whose edge drives a follower with a flat face, with an edge, or with a roller.

With phi the angle by which the cam has turned, counter-clockwise, from where its x axis points at the follower, and
r(phi) = base radius + lift(phi):

    flat face     it is r(phi) from the centre, along its normal (r is the support function of the cam); the edge of
                  the cam has the radius of curvature rho = r + r''
    edge, roller  its point, the middle of the roller, is r(phi) (roller: and the roller's radius more) from the centre;
                  the pressure angle is tan(alpha) = r'/r, and the path of the middle has the radius of curvature
                  rho = (r^2 + r'^2)^(3/2)/(r^2 + 2 r'^2 - r r'')

Divided by the size of their gradients, both are distances from the edge, so that the multiplier is the contact force.
An edge with rho < 0 (flat face), or with 0 < rho < the radius of the roller, cannot be cut: it is undercut. Source:
Norton, Design of Machinery, ch. 8; Shigley & Uicker, Theory of Machines and Mechanisms, ch. 5.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection
from freebody.connections.cam_points import lift_through
from freebody.connections.standing import ground_guide_of, ground_pivot_of, number_of, stands_at, vanishes
from freebody.errors import FreebodyError
from freebody.language.expression import (
    PI,
    ZERO,
    Call,
    Expr,
    Symbol,
    differentiate,
    divide,
    evaluate,
    number,
    substitute,
)
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import RIGHT, UP, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, RigidBody
from freebody.model.glyphs import Glyph
from freebody.model.phrases import direction_angle
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names

_FORMS = ("flat", "edge", "roller")
_N_DRAWN = 120  # stretches of a drawn edge
_N_LOOKED_AT = 720  # angles at which the edge is looked at for undercutting
_PHI = "phi"
_Parts = tuple[tuple[str, Measure], ...]


class Cam(Connection, kind="cam"):
    """`cam: {cam: disk, follower: valve.face, base_radius: r, lift: h/2*(1 - cos(phi)), along: up}`: the edge of a cam
    pushes a follower with a flat face, whose normal is `along` (a direction of the ground, or of the follower:
    `along: lever.y`). `form: edge`: the point of the follower itself runs on the edge; `form: roller` with a
    `roller_radius`: it is the middle of a roller; of these `along` says on which side of the cam they are; guided
    through its centre, they have plain formulas. The lift is a formula in phi, the angle of the cam from where its x
    axis points at the follower, or goes through `points: [[0 deg, 0 mm], [30 deg, 2 mm], ...]` of a turn, which a table
    in the folder of the model may hold (`points: lift.csv`, with the head `phi [deg], lift [mm]`):
    `through: cubic` (a periodic spline, smooth to the acceleration) or `pchip` (no overshoot beside dwells, but the
    acceleration jumps at the points). The contact force is positive where the cam pushes (1 row)."""

    cam: str
    follower: str
    base_radius: Formula
    lift: Formula | None = None
    points: list[list[Formula]] | str | None = None
    through: str = "cubic"
    along: Heading | None = None
    form: str = "flat"
    roller_radius: Formula | None = None

    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("eccentricity", "ecc", "e"),
            Message(
                "a round disk of the radius R that turns about a point at the distance e from its middle has "
                "base_radius: R - e, lift: e*(1 + cos(phi)), along: up; alone it may be a section of the file, cam: "
                "{{radius: 40 mm, eccentricity: 10 mm}} with follower: {{mass: 1 kg}}"
            ),
        ),
        **dict.fromkeys(("flat", "roller"), Message("write form: flat, edge or roller, a roller with a roller_radius")),
    }
    in_plane = True
    has_contact_point = True
    example = """
bodies:
  disk: {body: {mass: 1 kg, inertia: 0.01 kg m^2}}
  valve: {particle: {mass: 1 kg}, near: {at: [0, 0.05 m]}}
connections:
  axle: {pin: [ground.O, disk]}
  guide: {slider: {body: valve, along: up}}
  it: {cam: {cam: disk, follower: valve, base_radius: 40 mm, lift: 5 mm * (1 - cos(phi)), along: up}}
"""

    def _radius(self, names: Names) -> Expr:
        """r(phi): for a roller that of the path of its middle."""
        return names.positive(self, "base_radius", LENGTH) + self._lift(names) + self._roller(names)

    def _lift(self, names: Names) -> Expr:
        if self.points is not None:
            return lift_through(names, self.points, self.through, _PHI) or ZERO
        return names.formula(self.lift, LENGTH, "lift", extra={_PHI: DIMENSIONLESS})

    def _roller(self, names: Names) -> Expr:
        return names.optional(self, "roller_radius", LENGTH) or ZERO

    def _parts(self, names: Names) -> tuple[RigidBody, Point, Direction | None] | None:
        """The cam, the point of the follower and the normal of its face; None with problems noted."""
        cam, point = names.body(self.cam, "cam"), names.point(self.follower, "follower")
        if self.form not in _FORMS:
            names.problem(Message("form is one of {names}", names=", ".join(_FORMS)), "form")
            return None
        if cam.name == point.body or not cam.turns:
            names.problem(Message("a cam is a body that turns, and its follower another body"), "cam")
            return None
        if (self.lift is None) == (self.points is None):
            names.problem(Message("say how far the cam lifts: lift: a formula in phi, or points: [[0 deg, 0], ...]"))
            return None
        if (self.form == "roller") != (self.roller_radius is not None):
            names.problem(Message("roller_radius goes with form: roller"), "roller_radius")
            return None
        if self.form == "flat" and self.along is None:
            names.problem(
                Message("a flat face needs its normal, e.g. along: up; a roller its form and radius, form: roller")
            )
            return None
        return cam, point, None if self.along is None else names.direction(self.along, "along")

    def rows(self, names: Names) -> list[ConstraintRow]:
        parts = self._parts(names)
        if parts is None:
            return []
        cam, point, normal = parts
        r = self._radius(names)
        if (found := self._round(names, r)) is not None:
            self._look_for_undercut(names, found)
            self._look_for_miss(names, cam, point, found)
        used: tuple[tuple[str, Measure], ...]
        if normal is not None and self.form != "flat" and self._is_radial(names, cam, point, normal):
            return [self._radial(cam, point, normal, r)]
        if normal is not None and self.form == "flat":
            away = Symbol("@away") - r
            turned: Measure = Angle(cam.name, normal.body, direction_angle(normal))
            used = (("@away", Displacement(point, cam.center, normal)), (_PHI, turned))
        else:
            steep = divide(differentiate(r, _PHI), r)  # tan of the pressure angle
            away = (Symbol("@away") - r) / Call("sqrt", number(1) + steep * steep)
            away = substitute(away, {_PHI: Symbol("@turned") - Symbol("@seen")})
            used = (
                ("@away", Distance(cam.center, point)),
                ("@turned", Angle(cam.name)),
                ("@seen", Bearing(cam.center, point)),
            )
        return [ConstraintRow("contact", "contact force", Composed(away, used, LENGTH), unilateral=True)]

    def _is_radial(self, names: Names, cam: RigidBody, point: Point, side: Direction) -> bool:
        """Whether a guide keeps the follower on a line through the centre of the cam."""
        across = side.normal()
        places = [stands_at(names, at, across) for at in (point, cam.center)]
        if any(place is None for place in places):
            return False
        first, second = (place for place in places if place is not None)
        return vanishes(names, first - second)

    def _radial(self, cam: RigidBody, point: Point, side: Direction, r: Expr) -> ConstraintRow:
        """Of a follower that stays on a line through the centre: there it is seen at the angle across/along, which is
        zero, so that the edge is r - r' across/along to the first order; that is enough, and along is r."""
        steep = divide(differentiate(r, _PHI), r)
        away = Symbol("@along") - r + steep * Symbol("@across")
        used: _Parts = (
            ("@along", Displacement(point, cam.center, side)),
            ("@across", Displacement(point, cam.center, side.normal())),
            (_PHI, Angle(cam.name, side.body, direction_angle(side))),
        )
        away = away / Call("sqrt", number(1) + steep * steep)
        return ConstraintRow("contact", "contact force", Composed(away, used, LENGTH), unilateral=True)

    def aside_of_way(self, names: Names) -> Measure | Message:
        """From the way of the follower, along its guide or round its pivot, to the normal of the edge, e_r + r'/r e_t
        at the follower."""
        with names.quietly():
            parts = self._parts(names)
            guide = None if parts is None else ground_guide_of(names, parts[1].body, turning=True)
            pivot = None if parts is None or guide is not None else ground_pivot_of(names, parts[1].body)
        if parts is not None and pivot is not None:
            return self._aside_of_swing(names, parts, pivot)
        if self.form == "flat":
            return Message("a flat face is pushed along its normal, whatever the cam: it has no pressure angle")
        if parts is None or guide is None:
            return Message("the follower of {cam} is guided along no line", cam=self.own_name(names))
        cam, point, side = parts
        r = self._radius(names)
        steep = divide(differentiate(r, _PHI), r)
        used: _Parts
        if side is not None and self._is_radial(names, cam, point, side):
            used = ((_PHI, Angle(cam.name, side.body, direction_angle(side))),)
            return Composed(Call("atan", steep), used, DIMENSIONLESS)
        steep = substitute(steep, {_PHI: Symbol("@turned") - Symbol("@seen")})
        along, across = Symbol("@along"), Symbol("@across")
        used = (
            ("@along", Displacement(point, cam.center, guide)),
            ("@across", Displacement(point, cam.center, guide.normal())),
            ("@turned", Angle(cam.name)),
            ("@seen", Bearing(cam.center, point)),
        )
        return Composed(Call("atan", divide(across + steep * along, along - steep * across)), used, DIMENSIONLESS)

    def _aside_of_swing(
        self, names: Names, parts: tuple[RigidBody, Point, Direction | None], pivot: Point
    ) -> Measure | Message:
        """Of a follower that swings about a pivot B, whose point of contact P moves along k x (P - B): with the normal
        n of the edge, tan(alpha) = (P - B).n/((P - B).(k x n)). A flat face is touched at P = O + r n - r' k x n."""
        cam, point, normal = parts
        r = self._radius(names)
        slope = differentiate(r, _PHI)
        used: _Parts
        if self.form == "flat":
            assert normal is not None
            used = (
                ("@off", Displacement(point, pivot, normal)),
                ("@away", Displacement(cam.center, pivot, normal.normal())),
                (_PHI, Angle(cam.name, normal.body, direction_angle(normal))),
            )
            return Composed(Call("atan", divide(Symbol("@off"), Symbol("@away") - slope)), used, DIMENSIONLESS)
        steep = substitute(divide(slope, r), {_PHI: Symbol("@turned") - Symbol("@seen")})
        x, y, b_x, b_y = (Symbol(name) for name in ("@x", "@y", "@arm x", "@arm y"))
        n_x, n_y = x - steep * y, y + steep * x
        used = (
            ("@x", Displacement(point, cam.center, RIGHT)),
            ("@y", Displacement(point, cam.center, UP)),
            ("@arm x", Displacement(point, pivot, RIGHT)),
            ("@arm y", Displacement(point, pivot, UP)),
            ("@turned", Angle(cam.name)),
            ("@seen", Bearing(cam.center, point)),
        )
        aside = divide(b_x * n_x + b_y * n_y, b_y * n_x - b_x * n_y)
        return Composed(Call("atan", aside), used, DIMENSIONLESS)

    def step_of_edge(self, names: Names) -> tuple[float, float, float] | None:
        """r(2 pi) - r(0), and the same of r'."""
        with names.quietly():
            r = self._radius(names)
            ends = [self._looked_at(names, r, phi) for phi in (0.0, math.tau)]
        if ends[0] is None or ends[1] is None:
            return None
        (a, slope, _b), (c, last, _d) = ends[0], ends[1]
        return c - a, last - slope, max(abs(a), abs(c))

    def edge_radius(self, names: Names) -> Measure | Message:
        """Of the edge that is cut: r + r'' under a flat face, else that of the path of the middle less the roller."""
        with names.quietly():
            parts = self._parts(names)
        if parts is None:
            return Message("{connection} has no edge, which is one of cams", connection=self.own_name(names))
        cam, point, side = parts
        r = self._radius(names)
        first = differentiate(r, _PHI)
        second = differentiate(first, _PHI)
        used: _Parts
        if side is not None and (self.form == "flat" or self._is_radial(names, cam, point, side)):
            used = ((_PHI, Angle(cam.name, side.body, direction_angle(side))),)
        else:
            used = ("@turned", Angle(cam.name)), ("@seen", Bearing(cam.center, point))
        if self.form == "flat":
            return Composed(r + second, used, LENGTH)
        path = (r * r + first * first) ** divide(number(3), number(2)) / (r * r + 2 * first * first - r * second)
        if len(used) == 2:
            path = substitute(path, {_PHI: Symbol("@turned") - Symbol("@seen")})
        return Composed(path - self._roller(names), used, LENGTH)

    # -- its edge -----------------------------------------------------------------------------
    def _round(self, names: Names, r: Expr) -> list[tuple[float, float, float]] | None:
        """r, r' and r'' in numbers at angles of a turn; None where parameters have no values."""
        found = [self._looked_at(names, r, math.tau * k / _N_LOOKED_AT) for k in range(_N_LOOKED_AT)]
        known = [at for at in found if at is not None]
        return known if len(known) == len(found) else None

    def _looked_at(self, names: Names, r: Expr, phi: float) -> tuple[float, float, float] | None:
        """The same at one angle."""
        first = differentiate(r, _PHI)
        values = {**names.numbers_in(r), _PHI: phi}
        try:
            a, b, c = (float(evaluate(e, values)) for e in (r, first, differentiate(first, _PHI)))
        except (ArithmeticError, ValueError, FreebodyError):  # parameters without values
            return None
        return a, b, c

    def _look_for_miss(
        self, names: Names, cam: RigidBody, point: Point, found: list[tuple[float, float, float]]
    ) -> None:
        """Notes a problem where the line on which an edge or a roller runs misses the cam, however that is turned."""
        guide = None if self.form == "flat" else ground_guide_of(names, point.body, turning=True)
        if guide is None or any(p.value is None and p.form is None for p in names.parameters.values()):
            return
        places = [stands_at(names, at, guide.normal()) for at in (point, cam.center)]
        if any(place is None for place in places):
            return
        first, second = (number_of(names, place) for place in places if place is not None)
        off, far = abs(first - second), max(a for a, _b, _c in found)
        if off > far:
            told = Message(
                "{follower} runs on a line at {off:.4g} m from the centre of {cam}, but can touch it at no more than "
                "{far:.4g} m from there. Move the guide nearer, or take a base radius of at least {wanted:.4g} m",
                follower=self.follower,
                cam=self.cam,
                off=off,
                far=far,
                wanted=(names.numeric(names.formula(self.base_radius, LENGTH)) or 0.0) + off - far,
            )
            names.problem(told, "follower")

    def _look_for_undercut(self, names: Names, found: list[tuple[float, float, float]]) -> None:
        """Notes a problem where the edge cannot be cut, with the size that would do."""
        if self.form == "flat":
            least = min(a + c for a, _b, c in found)
            if least < 0.0:
                wanted = names.numeric(names.formula(self.base_radius, LENGTH)) or 0.0
                told = Message(
                    "the cam is undercut: its edge would have the radius of curvature {least:.4g} m. Take a base "
                    "radius of at least {wanted:.4g} m",
                    least=least,
                    wanted=wanted - least,
                )
                names.problem(told, "base_radius")
        elif self.form == "roller":
            curvatures = [(a * a + 2 * b * b - a * c) / (a * a + b * b) ** 1.5 for a, b, c in found]
            sharpest, roller = max(curvatures), names.numeric(self._roller(names)) or 0.0
            if sharpest * roller > 1.0:
                told = Message(
                    "the cam is undercut: the path of the middle of the roller has the radius of curvature {least:.4g} "
                    "m, less than that of the roller. Take a smaller roller, or a larger base radius",
                    least=1.0 / sharpest,
                )
                names.problem(told, "roller_radius")

    def _edge(self, names: Names) -> list[tuple[Expr, Expr]]:
        """Places on the edge in the cam's own frame: seen from the cam, the follower is at the angle -phi."""
        r = substitute(self._radius(names), {_PHI: -Symbol("@psi")})
        slope, roller = differentiate(r, "@psi"), self._roller(names)
        cos, sin = Call("cos", Symbol("@psi")), Call("sin", Symbol("@psi"))
        if self.form == "flat":
            x, y = r * cos - slope * sin, r * sin + slope * cos
        else:
            size = Call("sqrt", r * r + slope * slope)
            x = r * cos - roller * (r * cos + slope * sin) / size
            y = r * sin - roller * (r * sin - slope * cos) / size
        angles = [divide(2 * k * PI, number(_N_DRAWN)) for k in range(_N_DRAWN)]
        at: Callable[[Any, Any], Expr] = lambda e, psi: substitute(e, {"@psi": psi})  # noqa: E731
        return [(at(x, psi), at(y, psi)) for psi in angles]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        cam, point = names.body(self.cam), names.point(self.follower)
        center = cam.center.offset
        places = (tuple(a + b for a, b in zip(center, at, strict=False)) for at in self._edge(names))
        yield glyphs.Relation(tuple(Point(cam.name, (*at, *center[2:])) for at in places), is_edge=True)
        if self.form == "roller":
            yield glyphs.Roller(point, self._roller(names))
