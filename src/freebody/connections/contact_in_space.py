"""Contact in space: the bounds and the dry friction of the places at which bodies can touch planes.

Dry friction has the circular cone: at rest its two components stay within a coefficient times the normal force, and
while it slides it points against the slip. What resists rolling is a moment of the normal force times an arm in the
plane, against the angular velocity there; what resists spinning one about the normal. Source: Leine & Nijmeijer,
Dynamics and Bifurcations of Non-Smooth Mechanical Systems, 2004, sec. 5.3; Johnson, Contact Mechanics, 1985, ch. 8.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.joints import across_names
from freebody.connections.places_on_planes import PlaceOnPlane, along_plane, places_on_plane
from freebody.language.expression import ZERO, Expr
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import BodyPlane, ConstraintRow, DryFriction, NonholonomicForm, UnilateralConstraint
from freebody.model.friction import Friction
from freebody.model.spins import spin

if TYPE_CHECKING:
    from freebody.model.names import Names

FORMS = Message("a sphere, an ellipsoid, a disk, a ring, a cylinder, a box, or a point")


@dataclass(frozen=True)
class SurfaceInSpace:
    """What a contact in space is made of."""

    friction: Friction
    restitution: Expr
    rolling_resistance: Expr
    spinning_resistance: Expr


@dataclass(frozen=True)
class OnPlane:
    """A body, or a point of one, that may touch a plane."""

    connection: str
    solid: str
    plane: BodyPlane
    plane_label: str
    surface: SurfaceInSpace
    starts_closed: bool
    is_alone: bool  # the only pair of its connection

    def elements(self, names: Names) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        """The bound and the dry friction of every place; a problem is noted where there is none."""
        places = places_on_plane(names, self.solid, self.plane)
        if not places:
            told = Message(
                "there is no contact of {a} with the plane {b}: it takes {kinds}",
                a=self.solid,
                b=self.plane_label,
                kinds=FORMS,
            )
            names.problem(told, "between")
        bounds: list[UnilateralConstraint] = []
        rubs: list[DryFriction] = []
        for place in places:
            component = "contact" if self.is_alone and len(places) == 1 else f"{place.label} on {self.plane_label}"
            row = self._row(place, component, "normal force", place.gap, unilateral=True, target=place.target)
            family = f"{self.connection}: {self.solid}, {self.plane_label}"
            bounds.append(
                UnilateralConstraint(row, self.surface.restitution, starts_closed=self.starts_closed, family=family)
            )
            rubs += self._rubs(place, component, row)
        return bounds, rubs

    def _rubs(self, place: PlaceOnPlane, component: str, normal: ConstraintRow) -> list[DryFriction]:
        """Friction along the plane, and what resists rolling and spinning."""
        s, body, found = self.surface, place.center.body, list[DryFriction]()
        p, q = along_plane(self.plane)
        owner, n = self.plane.normal.body, self.plane.normal
        one, other = across_names(n)
        if not s.friction.is_none:
            slips = place.slip(p, self.plane), place.slip(q, self.plane)
            found.append(
                self._pair("slip", "friction force", place, component, slips, (one, other), s.friction, normal)
            )
        if s.rolling_resistance != ZERO:
            turns = spin(body, p, owner), spin(body, q, owner)
            resisted = Friction(s.rolling_resistance, s.rolling_resistance)
            found.append(
                self._pair("rolling", "rolling resistance", place, component, turns, (one, other), resisted, normal)
            )
        if s.spinning_resistance != ZERO:
            row = self._row(place, _of("spinning", component), "spinning resistance", spin(body, n, owner))
            arm = s.spinning_resistance
            found.append(DryFriction(row, arm, arm, (normal.name,), normal.name))
        return found

    def _pair(
        self,
        what: str,
        reaction: str,
        place: PlaceOnPlane,
        component: str,
        rates: tuple[Measure | NonholonomicForm, Measure | NonholonomicForm],
        across: tuple[str, str],
        friction: Friction,
        normal: ConstraintRow,
    ) -> DryFriction:
        rows = [
            self._row(place, f"{_of(what, component)} {name}", f"{reaction} {name}", rate)
            for name, rate in zip(across, rates, strict=True)
        ]
        return DryFriction(rows[0], friction.static, friction.kinetic, (normal.name,), normal.name, across=rows[1])

    def _row(
        self,
        place: PlaceOnPlane,
        component: str,
        reaction: str,
        measure: Measure | NonholonomicForm,
        *,
        unilateral: bool = False,
        target: Expr | None = None,
    ) -> ConstraintRow:
        return ConstraintRow(
            component,
            reaction,
            measure,
            target,
            ends=(place.label, self.plane_label),
            unilateral=unilateral,
            connection=self.connection,
        )


def _of(what: str, component: str) -> str:
    return what if component == "contact" else f"{what} of {component}"
