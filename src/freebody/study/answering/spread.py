"""Whether both routes can be told apart at all in numbers of sixteen digits.

They agree where eight digits do (`evidence`). Of a sum of lengths that are eight decades apart, or of the square of a
mass matrix with such masses in it, these eight are not left: then a difference says nothing about a formula, and no
answer is shown for that reason.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from freebody.errors import CannotAnswer, RoutesDisagree, RoutesUntold
from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.model.elements import NonholonomicForm
from freebody.numeric.mobility.rank import gradients
from freebody.numeric.reference import Reference
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

APART = 1e8
FLAT = 1e-4  # a slope below this part of the usual one: where poses are off by 1e-12 the place is by 1e-8
FAR = 1e9  # a parameter of more than this, or less than its inverse, in SI units

_Named = tuple[str, float]


NO_ANSWER = Message("No answer is shown")
NO_DERIVATION = Message("No derivation is shown")


def disagreement(message: str, reference: Reference, what: str = NO_ANSWER) -> RoutesDisagree:
    """The error of a difference between both routes. message: without the full stop; what: the sentence on
    what is not shown."""
    far = far_apart(reference.system, reference.number) or held_at_extreme(reference)
    if far:
        return RoutesUntold(
            Message(
                "{difference}; {sizes}: numbers of 16 digits do not tell which is right. {what}",
                difference=message,
                sizes=far,
                what=what,
            )
        )
    return RoutesDisagree(
        Message(
            "{difference}. {what}. This is a defect of freebody; please report the model",
            difference=message,
            what=what,
        )
    )


def far_apart(system: System, number: Callable[[Expr], float]) -> str:
    """Two sizes of one kind, or a parameter, that are further from each other, or from one, than half of sixteen digits
    hold; "" where none are."""
    for is_length, sizes in ((True, _lengths(system, number)), (False, _masses(system, number))):
        known = [(name, abs(x)) for name, x in sizes if x and math.isfinite(x)]
        if known:
            (small, least), (large, most) = (f(known, key=lambda named: named[1]) for f in (min, max))
            if most > APART * least:
                if is_length:
                    return Message(
                        "the lengths go from {a:.3g} m ({b}) to {c:.3g} m ({d})", a=least, b=small, c=most, d=large
                    )
                return Message(
                    "the masses go from {a:.3g} kg ({b}) to {c:.3g} kg ({d})", a=least, b=small, c=most, d=large
                )
    for p in system.parameters.values():
        x = abs(number(Symbol(p.name))) if p.form is None else 0.0
        if x and not 1.0 / FAR < x < FAR:
            return Message("{parameter} is {x:.3g} in SI units", parameter=p.name, x=x)
    return ""


def held_at_extreme(reference: Reference) -> str:
    """A row whose measure is at an extreme value at the start, as a mesh of wheels between shafts that can only just
    be as oblique as it demands; "" where there is none. The gap of such a row grows with the square of what the pose
    is off, so poses are known to half the digits."""
    try:
        q, unit = reference.assemble(), reference.sizes.length
        rows = [row for row in reference.system.constraint_rows if not isinstance(row.measure, NonholonomicForm)]
        slopes = gradients(reference, q, rows) * reference.sizes.unit_moves
    except CannotAnswer:
        return ""
    for row, slope in zip(rows, slopes, strict=True):
        size = float(np.linalg.norm(slope)) / unit ** float(row.measure.dimension.length)
        if ROUND_OFF < size < FLAT:
            return Message(
                "at the start {row} is held at an extreme value of its measure, and the pose is known to half of the "
                "digits",
                row=row.name,
            )
    return ""


def _lengths(system: System, number: Callable[[Expr], float]) -> Iterator[_Named]:
    for body in system.bodies.values():
        for point, place in body.points.items():
            for c in place:
                yield f"{body.name}.{point}", number(c)
        start = body.start.with_guess()
        for c in start.at[1] if start.at is not None else ():
            yield f"place of {body.name}", number(c)
        if body.radius is not None:
            yield f"radius of {body.name}", number(body.radius)
        mass, inertia = number(body.mass), number(body.inertia)
        if mass > 0.0 and inertia > 0.0:
            yield f"radius of gyration of {body.name}", math.sqrt(inertia / mass)
    for row in system.constraint_rows:
        if row.target is not None and row.measure.dimension == LENGTH and not row.is_driven:
            yield row.name, number(row.target)
    for p in system.parameters.values():
        if p.dimension == LENGTH and p.form is None:
            yield p.name, number(Symbol(p.name))


def _masses(system: System, number: Callable[[Expr], float]) -> Iterator[_Named]:
    for body in system.moving:
        yield f"mass of {body.name}", number(body.mass)
    for p in system.parameters.values():
        if p.dimension == MASS and p.form is None:
            yield p.name, number(Symbol(p.name))
