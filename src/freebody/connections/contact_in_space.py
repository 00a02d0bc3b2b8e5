"""Contact in space: the bounds and the dry friction of the places at which bodies can touch planes
and each other.

Dry friction has the circular cone: at rest its two components stay within a coefficient times the normal force, and
while it slides it points against the slip. What resists rolling is a moment of the normal force times an arm in the
plane, against the angular velocity there; what resists spinning one about the normal. A flat end of radius R that lies
on a face presses on it somewhere within its circle, so that its moment about the middle is R times the normal force at
most: that is the same law, until it tips about its rim. Source: Leine & Nijmeijer, Dynamics and Bifurcations of
Non-Smooth Mechanical Systems, 2004, sec. 5.3; Johnson, Contact Mechanics, 1985, ch. 8.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.contact_places import ContactPlace
from freebody.connections.places_of_cylinders import places_of_cylinders
from freebody.connections.places_of_polyhedra import places_of_polyhedra
from freebody.connections.places_of_rims import places_of_rims
from freebody.connections.places_on_bodies import places_on_body
from freebody.connections.places_on_planes import places_on_plane
from freebody.language.expression import ZERO, Expr
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import (
    ROLLING,
    SPINNING,
    TIPPING,
    BodyPlane,
    ConstraintRow,
    DryFriction,
    NonholonomicForm,
    RigidBody,
    RimPivot,
    UnilateralConstraint,
)
from freebody.model.friction import Friction
from freebody.model.hulls import MOST_POINTS
from freebody.model.solids import CYLINDER, DISK

if TYPE_CHECKING:
    from freebody.model.names import Names

ON_PLANE = Message("a sphere, an ellipsoid, a disk, a ring, a cylinder, a box, a convex body, or a point")
ON_BODY = Message(
    "a sphere touches a sphere, a box, a convex body, a cylinder, a disk, a ring, a rod or a point, a point a sphere, "
    "a box or a convex body, a cylinder or a disk a box or a convex body, a cylinder a cylinder, and boxes and convex "
    "bodies touch each other; in a hollow sphere, as in [ball, inside bowl], lie spheres, points, disks, rings, "
    "cylinders, boxes and convex bodies"
)


@dataclass(frozen=True)
class SurfaceInSpace:
    """What a contact in space is made of."""

    friction: Friction
    restitution: Expr
    rolling_resistance: Expr
    spinning_resistance: Expr


@dataclass(frozen=True)
class PairInSpace:
    """A body, or a point of one, that may touch a plane, or another body."""

    connection: str
    first: str
    second: str
    plane: BodyPlane | None  # that the second one is
    surface: SurfaceInSpace
    starts_closed: bool
    is_alone: bool  # the only pair of its connection

    @property
    def second_label(self) -> str:
        return self.second if self.plane is None else self.plane.name or self.second

    def places(self, names: Names) -> list[ContactPlace]:
        """Where the two can touch."""
        if self.plane is not None:
            return [place.on(self.plane, self.second_label) for place in places_on_plane(names, self.first, self.plane)]
        both = (self.first, self.second), (self.second, self.first)
        for places_of in (places_on_body, places_of_rims):
            for pair in both:
                if found := places_of(names, *pair):
                    return found
        return places_of_cylinders(names, *both[0]) or places_of_polyhedra(names, *both[0])

    def elements(self, names: Names) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        """The bound and the dry friction of every place; a problem is noted where there is none."""
        places = self.places(names)
        if not places:
            self._refuse(names)
        self._tell_hulls(names)
        # a flat end is a second place of its rim
        is_one = self.is_alone and sum(place.reach is None for place in places) == 1
        bounds: list[UnilateralConstraint] = []
        rubs: list[DryFriction] = []
        for place in places:
            component = "contact" if is_one and place.reach is None else place.name
            row = self._row(place, component, "normal force", place.measure, is_bound=True)
            family = f"{self.connection}: {self.first}, {self.second_label}"
            bounds.append(
                UnilateralConstraint(
                    row,
                    self.surface.restitution,
                    place.within,
                    self.starts_closed,
                    family,
                    place.obstacle,
                    place.pitfall,
                    place.is_crossing,
                    place.is_separating,
                    place.lost,
                    place.spinning() if self._is_spread(place) else None,
                    self._pivot(place, component, family, "contact" if is_one else place.rim),
                )
            )
            rubs += self._rubs(place, component, row)
        return bounds, rubs

    def _pivot(self, flat: ContactPlace, component: str, family: str, rim: str) -> RimPivot | None:
        """What a flat end tips about, with the friction there; rim: the component of that."""
        if flat.pivot is None or flat.reach is None:
            return None
        pivot, own = flat.pivot, f"pivot of {component}"
        row = self._row(pivot.place, own, "normal force", pivot.place.measure, is_bound=True)
        return RimPivot(
            f"{self.connection}.{rim}",
            UnilateralConstraint(row, self.surface.restitution, family=family),
            tuple(self._rubs(pivot.place, own, row)),
            pivot.settings,
            pivot.lowest,
            pivot.along,
            pivot.sign,
            flat.reach,
        )

    def _is_spread(self, place: ContactPlace) -> bool:
        """Whether friction under a flat end resists its spinning by pressure that is spread in a way not known."""
        s = self.surface
        return place.reach is not None and not s.friction.is_none and s.spinning_resistance == ZERO

    def _tell_hulls(self, names: Names) -> None:
        for name in (self.first, self.second):
            body = names.bodies.get(name)
            is_bored = body is not None and body.inner is not None and body.solid in (CYLINDER, DISK)
            if body is not None and ((body.faces and body.solid.has_hollows) or (is_bored and self.plane is None)):
                told = Message("{body} is not convex: in contacts its convex hull touches", body=name)
                if told not in names.assumptions:
                    names.assumptions.append(told)

    def _refuse(self, names: Names) -> None:
        a, b = self.first, self.second_label
        fine = [name for name in (self.first, self.second) if _is_fine_mesh(names.bodies.get(name))]
        if fine:
            told = Message(
                "{body} touches nothing: its convex hull has more than {most} corners. Weld a simpler body to it "
                "and let that touch: a convex one with fewer points, a box or a sphere",
                body=fine[0],
                most=MOST_POINTS,
            )
        elif self.plane is not None:
            told = Message("there is no contact of {a} with the plane {b}: it takes {kinds}", a=a, b=b, kinds=ON_PLANE)
        else:
            told = Message(
                "there is no contact of {a} with {b} in space: {kinds}. Others touch planes of bodies: name a "
                "plane of one, or weld spheres together",
                a=a,
                b=b,
                kinds=ON_BODY,
            )
        names.problem(told, "between")

    def _rubs(self, place: ContactPlace, component: str, normal: ConstraintRow) -> list[DryFriction]:
        """Friction across the normal, and what resists rolling and spinning."""
        s, found = self.surface, list[DryFriction]()
        if not s.friction.is_none:
            found.append(self._pair("slip", "friction force", place, component, place.slip, s.friction, normal))
        if place.reach is not None:
            tipping = Friction(place.reach, place.reach)
            found.append(self._pair("tipping", TIPPING, place, component, place.rolling(), tipping, normal))
        elif s.rolling_resistance != ZERO:
            resisted = Friction(s.rolling_resistance, s.rolling_resistance)
            turns = place.rolling()
            found.append(self._pair("rolling", ROLLING, place, component, turns, resisted, normal))
        if s.spinning_resistance != ZERO:
            row = self._row(place, _of("spinning", component), SPINNING, place.spinning())
            arm = s.spinning_resistance
            found.append(DryFriction(row, arm, arm, (normal.name,), normal.name))
        return found

    def _pair(
        self,
        what: str,
        reaction: str,
        place: ContactPlace,
        component: str,
        rates: tuple[Measure | NonholonomicForm, Measure | NonholonomicForm],
        friction: Friction,
        normal: ConstraintRow,
    ) -> DryFriction:
        rows = [
            self._row(place, f"{_of(what, component)} {name}", f"{reaction} {name}", rate)
            for name, rate in zip(place.across, rates, strict=True)
        ]
        return DryFriction(rows[0], friction.static, friction.kinetic, (normal.name,), normal.name, across=rows[1])

    def _row(
        self,
        place: ContactPlace,
        component: str,
        reaction: str,
        measure: Measure | NonholonomicForm,
        *,
        is_bound: bool = False,
    ) -> ConstraintRow:
        return ConstraintRow(
            component,
            reaction,
            measure,
            place.target if is_bound else None,
            place.sign if is_bound else 1,
            ends=(place.label, place.facing, *place.bodies),
            unilateral=is_bound,
            connection=self.connection,
        )


def _is_fine_mesh(body: RigidBody | None) -> bool:
    return body is not None and body.solid.is_mesh and not body.faces


def _of(what: str, component: str) -> str:
    return what if component == "contact" else f"{what} of {component}"
