"""The force between the teeth of gears, by its parts: tangential, radial, axial.

Involute teeth press along their common normal, which is at the pressure angle alpha from the tangent of the pitch
circles. Of the normal force F_n, F_t = F_n cos(alpha) is tangential and passes the moment on, and F_r = F_t tan(alpha)
parts the gears, whichever flank bears. A mesh holds

    u - s tan(alpha) e = 0,      u the way that its pitch circles roll against each other, e that by which they part,

so that the multiplier of u stays the tangential force, and s is the sign that it has on the flank which bears. As the
centres keep their distance, e does not change: the motion is that of alpha = 0, and the bearings carry F_r as well.
Source: Norton, Design of Machinery, 5th ed. 2012, sec. 9.2; Shigley, Mechanical Engineering Design, sec. 13-14.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from freebody.language.expression import ONE, ZERO, Call, Expr, free_symbols
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.model.noting import reads
from freebody.model.spec import Formula, Spec
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

_STEEPEST = math.pi / 4  # no involute gear is made beyond


def read_pressure_angle(names: Names, spec: Spec, field: str = "pressure_angle") -> Expr | None:
    """The angle between the tooth force and the tangent of the pitch circles; None where the model states none."""
    given = getattr(spec, field)
    if given is None:
        return None
    alpha = names.angle(given, field)
    value = names.numeric(alpha)
    if value is not None and not 0.0 <= value < _STEEPEST:
        names.problem(
            Message(
                "the pressure angle is {degrees:.4g} deg; it is between 0 and 45 deg, as a rule 20 deg",
                degrees=math.degrees(value),
            ),
            field,
        )
        return None
    return alpha


@reads
def read_teeth(names: Names, teeth: Sequence[Formula], least: int = 1) -> tuple[Expr, Expr]:
    """Two numbers of teeth, each whole and at least so many; 1 in place of what is none."""
    if len(teeth) != 2:
        names.problem(Message("teeth are two numbers, [z1, z2]"), "teeth")
        return ONE, ONE
    read = [names.formula(z, DIMENSIONLESS, "teeth", k) for k, z in enumerate(teeth)]
    names.counts.update(*map(free_symbols, read))
    for k, z in enumerate(map(names.numeric, read)):
        if z is None or (z >= least and abs(z - round(z)) <= ROUNDED):
            continue
        if not names.is_told("teeth", k):
            near = max(least, round(z))
            names.problem(Message("{z:g} teeth: a number of teeth is whole, e.g. {near}", z=z, near=near), "teeth", k)
        read[k] = ONE
    return read[0], read[1]


def parts_of_tooth_force(alpha: Expr | None) -> dict[str, Expr]:
    """What the tangential force is multiplied by for each part of the tooth force; of the others their size."""
    if alpha is None:
        return {"tangential": ONE}
    slope = Call("tan", alpha)
    return {"tangential": ONE, "radial": slope, "normal": ONE / Call("cos", alpha)}


def parting_slope(alpha: Expr | None) -> Expr:
    """The radial over the tangential force."""
    return ZERO if alpha is None else Call("tan", alpha)
