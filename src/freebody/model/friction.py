"""What a user says of friction and restitution, read and checked."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

from freebody.language.expression import ZERO, Expr, Symbol
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.model.noting import did_you_mean

if TYPE_CHECKING:
    from freebody.model.names import Names

# What people call the two coefficients beside each other.
AT_REST = (
    "static_friction",
    "mu_s",
    "mu_static",
    "static",
    "Haftreibung",
    "Haftreibungszahl",
    "Haftzahl",
    "Haftbeiwert",
)
IN_MOTION = (
    *("kinetic_friction", "dynamic_friction", "sliding_friction", "mu_k", "mu_d", "mu_kinetic", "kinetic"),
    *("Gleitreibung", "Gleitreibungszahl", "Gleitbeiwert"),
)


def with_both_coefficients(given: dict[str, Any]) -> dict[str, Any]:
    """Fields with `friction: {static: ..., kinetic: ...}` in place of two words for these."""
    said = [[word for word in words if word in given] for words in (AT_REST, IN_MOTION)]
    if "friction" in given or [len(words) for words in said] != [1, 1]:
        return given
    (static,), (kinetic,) = said
    rest = {key: value for key, value in given.items() if key not in (static, kinetic)}
    return {**rest, "friction": {"static": given[static], "kinetic": given[kinetic]}}


@dataclass(frozen=True)
class Friction:
    """Coulomb friction: what holds at rest, and what resists a motion."""

    static: Expr = ZERO
    kinetic: Expr = ZERO

    @property
    def is_none(self) -> bool:
        return self.static == ZERO and self.kinetic == ZERO


def read_friction(names: Names, value: Any, dimension: Dimension, field: str = "friction", **more: Any) -> Friction:
    """One coefficient for both, or {static: ..., kinetic: ...}; a problem is noted where one is negative, or the static
    one smaller. more: what `Names.formula` takes."""
    if not isinstance(value, dict):
        one = _not_negative(names, value, dimension, (field,), **more)
        return Friction(one, one)
    entry = cast("dict[str, Any]", value)
    for key in entry:
        if key not in ("static", "kinetic"):
            names.problem(
                Message("friction has no {key}.{hint}", key=key, hint=did_you_mean(key, ("static", "kinetic"))),
                field,
                key,
            )
    if "static" not in entry or "kinetic" not in entry:
        names.problem(Message("friction is one coefficient, or both: {{static: 0.5, kinetic: 0.4}}"), field)
        return Friction()
    static, kinetic = (
        _not_negative(names, entry[key], dimension, (field, key), **more) for key in ("static", "kinetic")
    )
    s, k = names.numeric(static), names.numeric(kinetic)
    if s is not None and k is not None and s < k:
        names.problem(
            Message("static friction ({s:g}) is smaller than kinetic friction ({k:g}); it cannot be", s=s, k=k),
            field,
        )
    return Friction(static, kinetic)


def read_restitution(names: Names, value: Any, field: str = "restitution") -> Expr:
    """A number between 0 and 1; a problem is noted if it is not."""
    expr = names.formula(value, DIMENSIONLESS, field)
    number = names.numeric(expr)
    if number is not None and not 0.0 <= number <= 1.0:
        names.problem(
            Message("restitution is {number:g}; it lies between 0 (no rebound) and 1 (no loss)", number=number),
            field,
        )
    if isinstance(expr, Symbol):
        names.shares.add(expr.name)
    return expr


def _not_negative(names: Names, value: Any, dimension: Dimension, path: tuple[str, ...], **more: Any) -> Expr:
    expr = names.formula(value, dimension, *path, **more)
    number = names.below_zero(expr)
    if number is not None and dimension != DIMENSIONLESS:
        told = Message(
            "{field} is negative ({value:g} {dimension}); give a positive one",
            field=path[0],
            value=number,
            dimension=dimension,
        )
        names.problem(told, *path)
    elif number is not None:
        names.problem(
            Message("friction is negative ({number:g}); a coefficient of friction is 0 or more", number=number),
            *path,
        )
    return expr
