"""Forces that turn the line between two centres: a belt whose runs are not parallel pulls across it.

Of a measure c beta, where beta is the angle of the line of the length d, the force at each end is c/d times the
multiplier, perpendicular to the line: the sine of the angle of the runs, (r_2 - r_1)/d, for an open belt.
"""

from __future__ import annotations

from collections.abc import Callable

from freebody.language.expression import Call, Expr, Number, add, divide, free_symbols, multiply, negate
from freebody.language.units import LENGTH
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing
from freebody.measures.geometry import GROUND, Point
from freebody.model.elements import AppliedLoad, ConstraintRow
from freebody.present.picture.label import Label, Run, formula
from freebody.study.pictures.points import own_measures
from freebody.system.system import System

_ALIKE = 1e-9


def across_the_line(
    system: System, of: ConstraintRow | AppliedLoad, body: str, amount: float, value: Callable[[Expr], float]
) -> tuple[Expr, Label] | None:
    """The arm c and the length d of the line, both positive, where a force on a body is c/d times its symbol."""
    for arm, part in own_measures(of.measure):
        if not isinstance(part, Bearing) or body not in part.bodies() or not free_symbols(arm):
            continue
        apart = _distance(system, part, value)
        if apart is not None and abs(abs(value(divide(arm, apart))) - amount) < _ALIKE * max(1.0, amount):
            return arm if value(arm) > 0.0 else negate(arm), _length(apart)
    return None


def _distance(system: System, line: Bearing, value: Callable[[Expr], float]) -> Expr | None:
    """How far the ends of a line are apart that stay where they are on the ground; None where they do not."""
    places = [_place(system, point) for point in (line.start, line.end)]
    if places[0] is None or places[1] is None:
        return None
    parts = [add(b, negate(a)) for a, b in zip(*places, strict=True)]
    parts = [part if value(part) > 0.0 else negate(part) for part in parts if value(part) != 0.0]
    if len(parts) == 1:
        return parts[0]
    return Call("sqrt", add(*(multiply(part, part) for part in parts))) if parts else None


def _place(system: System, point: Point) -> tuple[Expr, ...] | None:
    held = [row.measure for row in system.constraint_rows if isinstance(row.measure, Displacement)]
    own = [m for m in held if (m.of.body, m.of.offset, m.origin.body) == (point.body, point.offset, GROUND)]
    both = {m.along.components for m in own}
    return own[0].origin.offset if len(both) > 1 else None


def _length(apart: Expr) -> Label:
    """A length in symbols, or in metres where the model has none."""
    if free_symbols(apart) or not isinstance(apart, Number):
        return formula(apart)
    told = f"{float(apart.value):.3g}"
    return Label((Run(f"{told}\u2009{LENGTH}"),), rf"{told}\,\mathrm{{{LENGTH}}}")
