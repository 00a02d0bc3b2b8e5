"""Rotations over expressions, and chains of them.

A chain turns a body from the axes of its frame to its own: each rotation is right-handed about an axis of what was
turned so far (intrinsic). With constant rotations A, B between them and q_i the named angles,

    R = A Rot(a_1, q_1) [C Rot(a_2, q_2) [D Rot(a_3, q_3)]] B.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from freebody.language.expression import MINUS_ONE, Call, Expr, Number, ProductOf, Symbol, free_symbols, number
from freebody.measures.geometry import ONE, ZERO, Components
from freebody.model.elements import Rotation
from freebody.model.polynomials import constant, polynomial

Columns = tuple[Components, Components, Components]
UNIT: Columns = ((ONE, ZERO, ZERO), (ZERO, ONE, ZERO), (ZERO, ZERO, ONE))


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
    return tuple(tuple(column[k] for column in R) for k in range(3))  # pyrefly: ignore[bad-return]


def rotation(axis: Components, angle: Expr) -> Columns:
    """The columns of Rot(axis, angle) = cos + sin [axis]x + (1 - cos) axis axis^T (Rodrigues)."""
    c, s = cosine_and_sine(angle)
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


def cosine_and_sine(angle: Expr) -> tuple[Expr, Expr]:
    """Of multiples of 30 and 45 degrees they are numbers and roots: what vanishes has no place in a formula."""
    part = _half_turns(angle)
    twelfths = None if part is None else 12 * part % 24
    if twelfths is None or twelfths.denominator != 1 or int(twelfths) not in _COSINES:
        return Call("cos", angle), Call("sin", angle)
    return _COSINES[int(twelfths)], _COSINES[(int(twelfths) - 6) % 24]


def _half_turns(angle: Expr) -> Fraction | None:
    """angle/pi, where that is a number."""
    match angle:
        case Number(value) if not value:
            return value
        case Symbol("pi"):
            return Fraction(1)
        case ProductOf((Number(value), Symbol("pi"))):
            return value
        case _:
            return None


def _cosines() -> dict[int, Expr]:
    """By twelfths of a half turn."""
    half = number(Fraction(1, 2))
    acute = {0: ONE, 2: half * Call("sqrt", number(3)), 3: half * Call("sqrt", number(2)), 4: half, 6: ZERO}
    upper = acute | {12 - k: -c for k, c in acute.items()}
    return upper | {(24 - k) % 24: c for k, c in upper.items()}


_COSINES = _cosines()


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


def is_one(v: Components) -> bool:
    """Is this a unit vector as it is written: by numbers and their roots, or by cosine and sine of one angle?"""
    match [_without_minus(c) for c in v if c != ZERO]:
        case [Call("cos", one), Call("sin", other)] | [Call("sin", one), Call("cos", other)]:
            return one == other
        case parts:
            return not any(map(free_symbols, parts)) and polynomial(dot(tuple(parts), tuple(parts))) == constant(1)


def _without_minus(c: Expr) -> Expr:
    return c.factors[1] if isinstance(c, ProductOf) and len(c.factors) == 2 and c.factors[0] == MINUS_ONE else c


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


def singular_pose(chain: Sequence[Rotation]) -> str:
    """Where the named angles of a chain are not determined; '' for fewer than three."""
    named, _last = pieces(chain)
    if len(named) < 3:
        return ""
    axes = [along_axis(piece.axis) for piece in named]
    same = axes[0] is not None and axes[2] is not None and axes[0][0] == axes[2][0]
    return f"sin({named[1].name}) = 0" if same else f"cos({named[1].name}) = 0"
