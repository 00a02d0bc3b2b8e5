"""Two outlines that may touch: the bound and the dry friction of every place where they can."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.connections.outlines import Outline
from freebody.connections.sites import ContactSite, sites
from freebody.language.expression import ZERO, Expr
from freebody.measures.angle import Angle
from freebody.model.elements import ROLLING, ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import Friction


@dataclass(frozen=True)
class ContactSurface:
    """What a contact is made of."""

    friction: Friction
    restitution: Expr
    rolling_resistance: Expr


@dataclass(frozen=True)
class OutlinePair:
    """Two outlines that may touch."""

    connection: str
    first: Outline
    second: Outline
    surface: ContactSurface
    starts_closed: bool
    is_alone: bool  # the only pair of its connection

    def elements(self) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        """Bounds and rubs of every place where the two can touch."""
        places = sites(self.first, self.second)
        bounds: list[UnilateralConstraint] = []
        dry_friction: list[DryFriction] = []
        for site in places:
            bound, own = self._site(site, "contact" if self.is_alone and len(places) == 1 else site.label)
            bounds.append(bound)
            dry_friction += own
        return bounds, dry_friction

    def _site(self, site: ContactSite, component: str) -> tuple[UnilateralConstraint, list[DryFriction]]:
        row = ConstraintRow(
            component,
            "normal force",
            site.measure,
            site.target,
            site.sign,
            ends=tuple(dict.fromkeys((*site.label.split(" on "), *site.ends))),
            unilateral=True,
            connection=self.connection,
        )
        family = f"{self.connection}: {self.first.label}, {self.second.label}"
        bound = UnilateralConstraint(
            row, self.surface.restitution, site.within, self.starts_closed, family, site.obstacle
        )
        dry_friction: list[DryFriction] = []
        f = self.surface.friction
        if not f.is_none:
            slip = ConstraintRow(
                "slip" if component == "contact" else f"slip of {component}",
                "friction force",
                site.slip,
                sign=site.slip_sign,
                ends=row.ends,
                connection=self.connection,
            )
            dry_friction.append(DryFriction(slip, f.static, f.kinetic, (row.name,), row.name))
        if self.surface.rolling_resistance != ZERO:
            turn = ConstraintRow(
                "rolling" if component == "contact" else f"rolling of {component}",
                ROLLING,
                Angle(site.ends[0], site.ends[1]),
                ends=row.ends,
                connection=self.connection,
            )
            dry_friction.append(
                DryFriction(
                    turn, self.surface.rolling_resistance, self.surface.rolling_resistance, (row.name,), row.name
                )
            )
        return bound, dry_friction
