"""Motions that are not put together from phases, and why."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr
from freebody.language.expression.tree import children
from freebody.language.sentences import Message
from freebody.model.elements import RATE, DryFriction
from freebody.study.phases.at_start import closed_at_start
from freebody.symbolic.spatial.balls import balls
from freebody.system.system import System

MOST_PLACES = 64  # at which bodies can ever touch: each is looked at by what could end a phase
MOST_TOUCHING = 12  # at which they touch when the motion begins: each opens, slips or sticks


def why_no_phases(system: System) -> str:
    """What a case distinction has no room for; nothing where there is one."""
    in_planes = [rub.row for rub in system.dry_friction if rub.across is not None and not rub.is_tipping]
    if (flat := _standing_flat(system)) is not None:
        return Message(
            "{end} stands flat on {face}, with no single place of contact",
            end=flat.row.ends[0],
            face=flat.row.ends[1],
        )
    turns = {body.name for body in system.moving if body.turns} - balls(system) if in_planes else set[str]()
    if turning := [row.connection for row in in_planes if turns & set(row.measure.bodies())]:
        # phases are told apart by the signs of slips along lines
        return Message(
            "the friction of {names} acts in a plane, and its direction follows the slip",
            names=", ".join(dict.fromkeys(turning)),
        )
    if len(system.bounds) > MOST_PLACES or len(closed_at_start(system)) > MOST_TOUCHING:
        return Message(
            "{n} places can touch, and the formulas would be a case distinction over all of them that nobody could "
            "read",
            n=len(system.bounds),
        )
    if (
        jumping := next((push.load for push in system.applied_loads if _jumps_with_a_rate(push.law)), None)
    ) is not None:
        return Message("the law of {load} jumps where a motion turns back", load=jumping)
    return ""


def _jumps_with_a_rate(law: Expr) -> bool:
    """Whether the sign of a rate stands in a law: where that turns back is no border of the model."""
    if isinstance(law, Call) and law.function == "sign":
        return _has_a_rate(law)
    return any(map(_jumps_with_a_rate, children(law)))


def _has_a_rate(part: Expr) -> bool:
    is_rate = part == RATE or (isinstance(part, Call) and part.function == "rate")
    return is_rate or any(map(_has_a_rate, children(part)))


def insist_on_phases(system: System) -> None:
    """Raises CannotAnswer where there are none."""
    if why := why_no_phases(system):
        raise CannotAnswer(
            Message(
                "I cannot solve this in closed form, because {why}; freebody simulate follows the motion in numbers",
                why=why,
            )
        )


def _standing_flat(system: System) -> DryFriction | None:
    """A flat end that touches with all of it at the start."""
    tips = [rub for rub in system.dry_friction if rub.is_tipping]
    closed = closed_at_start(system) if tips else frozenset[str]()
    return next((rub for rub in tips if rub.of in closed), None)
