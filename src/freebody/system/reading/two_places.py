"""A body that two of its points put: `at: {start: [0, 0], end: [a, h]}`.

The first point is where it is said to be, and the line from it to the second one says how the body is turned: by the
angle of that line in the plane less the angle that it has in the body. A rod whose length is left open has the distance
of its ends for it; of every other body the distance of the two points must be that of the two places, for all values of
the parameters. In space the two ends put a rod, which no turn about itself changes; for any other body they say too
little.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from typing import Any, cast

from freebody.language.expression import PI, ZERO, Call, Expr, add, divide, evaluate, free_symbols, negate, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.geometry import GROUND, Components
from freebody.model.elements import Rotation
from freebody.model.names import Names
from freebody.model.polynomials import dot, polynomial, root
from freebody.model.rotations import UNIT

_DRAWS = 5  # at which two distances are compared
_EQUAL = 1e-9


def two_points(names: Names, at: Any) -> tuple[str, str] | None:
    """The names under which a place gives two points of a body of the plane, or in space the ends of a rod."""
    given = cast("dict[str, Any]", at) if isinstance(at, dict) else {}
    if names.space and set(given) != {"start", "end"}:
        return None
    return cast("tuple[str, str]", tuple(given)) if len(given) == 2 else None


def turn_by_two(names: Names, at: Mapping[str, Any], points: Mapping[str, Components]) -> tuple[Rotation, ...] | None:
    """How the ends of a rod turn it in space: by the angle between its x axis and the line between them, about what
    both are across. None, and a problem, where they cannot be there."""
    first, second = (points[each] for each in ("start", "end"))
    there = [place_of_point(names, at[point], "at", point) for point in ("start", "end")]
    way, own = _way(*there), _way(first, second)
    if not _can_be_there(names, at, way, own):
        return None
    x, y, z = way
    if y == ZERO and z == ZERO:
        return () if _is_positive(names, x) else (Rotation(UNIT[2], PI),)
    across = polynomial(y) * polynomial(y) + polynomial(z) * polynomial(z)
    size = root(across).expression()
    return (Rotation((ZERO, negate(divide(z, size)), divide(y, size)), Call("acos", divide(x, _distance(way)))),)


def place_of_point(names: Names, value: Any, *path: str | int) -> Components:
    """Coordinates, or those of a point of the ground that is given by its name."""
    name = value.removeprefix(f"{GROUND}.") if isinstance(value, str) else ""
    if name in names.bodies[GROUND].points:
        return names.bodies[GROUND].points[name]
    if name.isidentifier() and name not in names.parameters:
        told = Message(
            "there is no point {name} of the ground: ground: {{points: {{{name}: {example}}}}}",
            name=name,
            example="[x, y]",
        )
        if not names.is_cut_short:
            names.problem(told, *path)
        return names.origin
    return names.components(value, LENGTH, *path)


def distance_of_ends(names: Names, at: Any) -> Expr | None:
    """The length of a rod of which only the places of its ends are given."""
    if two_points(names, at) is None or set(at) != {"start", "end"}:
        return None
    with names.quietly():  # told where the start is read
        first, second = (place_of_point(names, at[end]) for end in ("start", "end"))
    return _distance(_way(first, second))


def angle_by_two(names: Names, at: Mapping[str, Any], points: Mapping[str, Components]) -> Expr | None:
    """The angle of a body, two of whose points are given; None, and a problem, where these cannot be there."""
    first, second = at
    n_before = len(names.problems)
    there = [place_of_point(names, at[point], "at", point) for point in at]
    if names.is_cut_short or len(names.problems) > n_before:
        return None
    outside, inside = _way(*there), _way(points[first], points[second])
    if not _can_be_there(names, at, outside, inside):
        return None
    return add(_bearing(names, outside), negate(_bearing(names, inside)))


def _can_be_there(names: Names, at: Mapping[str, Any], outside: Components, inside: Components) -> bool:
    """Whether two points are as far apart in the body as they are put; else a problem is noted."""
    first, second = at
    told = None
    if all(part == ZERO for part in outside) or all(part == ZERO for part in inside):
        told = Message(
            "{first} and {second} are at one place, which turns the body by no angle", first=first, second=second
        )
    elif not _are_equal(_distance(outside), _distance(inside)):
        apart, own = (names.numeric(_distance(way)) for way in (outside, inside))
        told = Message(
            "{first} and {second} are put {apart} apart, but lie {own} apart in the body. Leave out the length of a "
            "rod that its ends give, or give one point and the angle",
            first=first,
            second=second,
            apart=_shown(apart),
            own=_shown(own),
        )
        if apart is not None and own is not None and abs(apart - own) <= 1e-6 * own:
            told = Message(
                "the places of {first} and {second} are as far apart as the two points for these numbers only, not as "
                "a formula. Leave out the length of a rod that its ends give, or give one point and the angle",
                first=first,
                second=second,
            )
    if told is not None:
        names.problem(told, "at")
    return told is None


def _shown(length: float | None) -> str:
    return "?" if length is None else f"{length:.6g} m"


def _way(first: Components, second: Components) -> Components:
    return tuple(polynomial(add(b, negate(a))).expression() for a, b in zip(first, second, strict=True))


def _distance(way: Components) -> Expr:
    parts = [polynomial(part) for part in way]
    return root(dot(parts, parts)).expression()


def _bearing(names: Names, way: Components) -> Expr:
    """The angle of a way from the x axis."""
    x, y = way
    back = polynomial(negate(x)).expression()
    if y == ZERO and _is_positive(names, x):
        return ZERO
    if y == ZERO and _is_positive(names, back):
        return PI
    if x == ZERO and _is_positive(names, y):
        return divide(PI, number(2))
    if x == ZERO and _is_positive(names, polynomial(negate(y)).expression()):
        return negate(divide(PI, number(2)))
    if names.is_never_negative(x):
        return Call("atan", divide(y, x))
    if names.is_never_negative(back):
        return add(PI, negate(Call("atan", divide(y, back))))
    return 2 * Call("atan", divide(y, add(_distance(way), x)))  # atan2 by the half angle


def _is_positive(names: Names, expr: Expr) -> bool:
    value = names.numeric(expr)
    return names.is_never_negative(expr) or (value is not None and value > 0.0)


def _are_equal(first: Expr, second: Expr) -> bool:
    """Whether two lengths are equal for all values of the parameters, by some values of these."""
    draws = random.Random(1)
    symbols = sorted((free_symbols(first) | free_symbols(second)) - {"pi"})
    for _ in range(_DRAWS):
        values = {name: draws.uniform(0.3, 1.2) for name in symbols}
        try:
            one, other = (float(evaluate(expr, values)) for expr in (first, second))
        except (ValueError, ZeroDivisionError, OverflowError):
            continue
        if abs(one - other) > _EQUAL * max(abs(one), abs(other)):
            return False
    return True


__all__ = ["angle_by_two", "distance_of_ends", "place_of_point", "turn_by_two", "two_points"]
