"""Rotations over expressions, and the named angles of a chain of them.

A chain turns a body from the axes of its frame to its own: each rotation is right-handed about an axis of what was
turned so far (intrinsic). With constant rotations A, B between them and q_i the named angles,

    R = A Rot(a_1, q_1) [C Rot(a_2, q_2) [D Rot(a_3, q_3)]] B.

Each named angle is a measure. For one or two of them it is the turn of a direction that the others leave alone: a_2
seen from the frame, a_1 seen from the body. Three need axes along x, y or z next to each other, no two neighbours
alike: a_1 = a_3 gives Euler's angles (singular where sin q_2 = 0), three different ones Tait-Bryan angles (cos q_2 =
0). Source: Shuster, J. Astronautical Sciences 41 (1993) 439, sec. on Euler angles.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from freebody.language.expression import Call, Expr, Number, Symbol
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.geometry import ONE, ZERO, Components, Direction
from freebody.measures.turn import Alignment, Turn
from freebody.model.elements import Rotation

if TYPE_CHECKING:
    from freebody.model.names import Names

Columns = tuple[Components, Components, Components]
UNIT: Columns = ((ONE, ZERO, ZERO), (ZERO, ONE, ZERO), (ZERO, ZERO, ONE))
_Fixed = Callable[[Components], Direction]  # components to a direction fixed in a body


# -- vectors and matrices of expressions --------------------------------------------------------
def dot(a: Components, b: Components) -> Expr:
    total: Expr = ZERO
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def vector_product(a: Components, b: Components) -> Components:
    return tuple(a[j] * b[k] - a[k] * b[j] for j, k in ((1, 2), (2, 0), (0, 1)))


def reversed_(v: Components) -> Components:
    return tuple(-c for c in v)


def applied(R: Columns, v: Components) -> Components:
    """R v."""
    return tuple(dot(tuple(column[k] for column in R), v) for k in range(3))


def product(R: Columns, Q: Columns) -> Columns:
    return applied(R, Q[0]), applied(R, Q[1]), applied(R, Q[2])


def transposed(R: Columns) -> Columns:
    return tuple(tuple(column[k] for column in R) for k in range(3))  # type: ignore[return-value]


def rotation(axis: Components, angle: Expr) -> Columns:
    """The columns of Rot(axis, angle) = cos + sin [axis]x + (1 - cos) axis axis^T (Rodrigues)."""
    c, s = Call("cos", angle), Call("sin", angle)
    k = along_axis(axis)
    if k is None:
        columns: list[Components] = []
        for j in range(3):
            e = UNIT[j]
            turned = vector_product(axis, e)
            columns.append(tuple(c * e[i] + s * turned[i] + (ONE - c) * axis[j] * axis[i] for i in range(3)))
        return columns[0], columns[1], columns[2]
    i, sign = k
    j, n = (i + 1) % 3, (i + 2) % 3
    s = s if sign > 0 else -s
    out = [[ZERO] * 3 for _ in range(3)]
    out[i][i] = ONE
    out[j][j], out[j][n] = c, s
    out[n][n], out[n][j] = c, -s
    return tuple(out[0]), tuple(out[1]), tuple(out[2])


def along_axis(axis: Components) -> tuple[int, int] | None:
    """(0, 1 or 2; +1 or -1) for an axis along x, y or z."""
    sizes = [float(c.value) if isinstance(c, Number) else math.nan for c in axis]
    big = [k for k, size in enumerate(sizes) if size != 0.0]
    return (big[0], int(sizes[big[0]])) if len(big) == 1 and abs(sizes[big[0]]) == 1.0 else None


def perpendiculars(axis: Components) -> tuple[Components, Components]:
    """Unit vectors b, c with b x c = axis: y, z for x and so on; for others b is perpendicular to the axis of the body
    that is farthest from it."""
    k = along_axis(axis)
    if k is not None:
        i, sign = k
        b, c = UNIT[(i + 1) % 3], UNIT[(i + 2) % 3]
        return (b, c) if sign > 0 else (c, b)
    zeros = [j for j in (2, 1, 0) if axis[j] == ZERO]
    if zeros:
        b = UNIT[zeros[0]]
        return b, vector_product(axis, b)
    x, y, _z = axis
    size = Call("sqrt", x * x + y * y)
    b = (-y / size, x / size, ZERO)
    return b, vector_product(axis, b)


# -- chains -----------------------------------------------------------------------------------
@dataclass(frozen=True)
class RotationPair:
    """A constant rotation, then a named one."""

    before: Columns
    axis: Components
    name: str


def pieces(chain: Sequence[Rotation]) -> tuple[list[RotationPair], Columns]:
    """The named rotations with what is constant before each, and what is constant at the end."""
    found: list[RotationPair] = []
    constant = UNIT
    for turn in chain:
        if turn.name:
            found.append(RotationPair(constant, turn.axis, turn.name))
            constant = UNIT
        else:
            constant = product(constant, rotation(turn.axis, turn.by))
    return found, constant


def columns_of(chain: Sequence[Rotation]) -> Columns:
    """The rotation of a chain, its named angles as symbols."""
    total = UNIT
    for turn in chain:
        total = product(total, rotation(turn.axis, Symbol(turn.name) if turn.name else turn.by))
    return total


def angles_of(names: Names, chain: Sequence[Rotation], body: str, frame: str) -> dict[str, Measure]:
    """The named angles of a chain as measures of the body's orientation. Notes a problem where they are none."""
    named, last = pieces(chain)
    if not named:
        return {}
    back = transposed(last)

    def on_frame(v: Components) -> Direction:
        return Direction(frame, applied(named[0].before, v))

    def on_body(v: Components) -> Direction:
        return Direction(body, applied(back, v))

    first = named[0].axis
    b, c = perpendiculars(first)
    if len(named) == 1:
        return {named[0].name: Turn(on_body(b), on_frame(b), on_frame(c))}
    second = applied(named[1].before, named[1].axis)  # seen in the frame of the first angle
    if len(named) == 2:
        side = vector_product(first, second)
        if all(c == ZERO for c in side):
            one, other = named[0].name, named[1].name
            names.problem(
                f"{one} and {other} turn about the same axis, so only their sum has a meaning: name one angle, or turn "
                "about another axis between them"
            )
            return {}
        start = vector_product(side, first)
        back_first = applied(transposed(named[1].before), first)
        own_side = vector_product(named[1].axis, back_first)
        own_start = vector_product(own_side, named[1].axis)
        return {
            named[0].name: Turn(on_body(named[1].axis), on_frame(start), on_frame(side)),
            # seen from the body the first axis turns backwards
            named[1].name: Turn(on_frame(first), on_body(own_start), on_body(reversed_(own_side))),
        }
    return _three(names, named, on_frame, on_body)


def _three(names: Names, named: Sequence[RotationPair], on_frame: _Fixed, on_body: _Fixed) -> dict[str, Measure]:
    axes = [along_axis(piece.axis) for piece in named]
    plain = all(axis is not None for axis in axes) and all(piece.before == UNIT for piece in named[1:])
    if len(named) != 3 or not plain or any(a and b and a[0] == b[0] for a, b in pairwise(axes)):
        names.problem(
            "three named angles turn about x, y or z, neighbours about different ones, with nothing between them, "
            "e.g. turned: [psi about z, theta about x, phi about z]",
        )
        return {}
    (q1, a1), (q2, a2), (q3, a3) = ((piece.name, piece.axis) for piece in named)
    if axes[0] is not None and axes[2] is not None and axes[0][0] == axes[2][0]:
        # R a1 = cos q2 a1 + sin q2 (a2 x a1), turned by q1 about a1; sin q2 > 0
        side = vector_product(a2, a1)
        flip = on_body(a1)
        back = vector_product(a1, a2)  # R^T a1 = cos q2 a1 + sin q2 (a1 x a2), turned back by q3 about a3
        third_side = reversed_(vector_product(a3, back))
        return {
            q1: Turn(flip, on_frame(side), on_frame(vector_product(a1, side))),
            q2: Composed(Call("acos", Symbol("c")), (("c", Alignment(flip, on_frame(a1))),), DIMENSIONLESS),
            q3: Turn(on_frame(a1), on_body(back), on_body(third_side)),
        }
    # a3 = s a1 x a2.  R a3 = cos q2 a3 + sin q2 (a2 x a3), a2 x a3 = s a1;  q1 turns it about a1; cos q2 > 0
    sine = Alignment(on_body(a3), on_frame(a1))
    s = 1 if vector_product(a1, a2) == a3 else -1
    tilt = Symbol("c") if s > 0 else -Symbol("c")
    # R^T a1 = cos q2 a1 + sin q2 (a1 x a2 = s a3), turned back by q3 about a3
    return {
        q1: Turn(on_body(a3), on_frame(a3), on_frame(vector_product(a1, a3))),
        q2: Composed(Call("asin", tilt), (("c", sine),), DIMENSIONLESS),
        q3: Turn(on_frame(a1), on_body(a1), on_body(reversed_(vector_product(a3, a1)))),
    }


def singular_pose(chain: Sequence[Rotation]) -> str:
    """Where the named angles of a chain are not determined; '' for fewer than three."""
    named, _last = pieces(chain)
    if len(named) < 3:
        return ""
    axes = [along_axis(piece.axis) for piece in named]
    same = axes[0] is not None and axes[2] is not None and axes[0][0] == axes[2][0]
    return f"sin({named[1].name}) = 0" if same else f"cos({named[1].name}) = 0"
