"""Inertia tensors: read, moved to another point, put together, and checked for what no body can have."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

from freebody.language.expression import ONE, ZERO, Expr
from freebody.language.sentences import Message
from freebody.language.units import INERTIA, LENGTH
from freebody.measures.geometry import Components
from freebody.tolerances import LEAST

if TYPE_CHECKING:
    from freebody.model.names import Names

UNIT: tuple[Components, ...] = ((ONE, ZERO, ZERO), (ZERO, ONE, ZERO), (ZERO, ZERO, ONE))
PLACES = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))  # of xx, yy, zz, xy, xz, yz
SLACK = 1e-9  # relative: what rounding of given numbers may break


def entries(tensor: Components) -> list[list[Expr]]:
    """The tensor as three rows."""
    rows: list[list[Expr]] = [[ZERO] * 3 for _ in range(3)]
    for (i, j), value in zip(PLACES, tensor, strict=True):
        rows[i][j] = rows[j][i] = value
    return rows


def moved(tensor: Components, mass: Expr, r: Components, sign: int = 1) -> Components:
    """The tensor about a point at r from the mass centre (Huygens-Steiner): I + sign m (|r|^2 1 - r r^T)."""
    square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2]
    return tuple(
        value + sign * mass * ((square if i == j else ZERO) - r[i] * r[j])
        for (i, j), value in zip(PLACES, tensor, strict=True)
    )


def turned(tensor: Components, axes: tuple[Components, Components, Components]) -> Components:
    """R I R^T, with the columns of R."""
    if all(axes[k] == UNIT[k] for k in range(3)):
        return tensor
    rows = entries(tensor)
    found: list[Expr] = []
    for i, j in PLACES:
        total: Expr = ZERO
        for a in range(3):
            for b in range(3):
                total = total + axes[a][i] * rows[a][b] * axes[b][j]
        found.append(total)
    return tuple(found)


def read_tensor(names: Names, given: Any, mass: Expr, middle: Components, about: Any) -> Components:
    """The tensor about the mass centre in body axes, from moments or rows about a place."""
    tensor = _entries_of(names, given)
    if about not in ("mass_center", "origin") and not isinstance(about, list):
        names.problem(Message("about is mass_center, origin, or a place [x, y, z] in the body's own frame"), "about")
    elif about != "mass_center":
        place = names.origin if about == "origin" else names.components(about, LENGTH, "about")
        r = tuple(p - m for p, m in zip(place, middle, strict=True))
        tensor = moved(tensor, mass, r, sign=-1)
    check(names, tensor, "" if about == "mass_center" else Message(", moved to the mass centre,"), "inertia")
    return tensor


def _entries_of(names: Names, given: Any) -> Components:
    if not isinstance(given, list):
        moment = names.formula(given, INERTIA, "inertia")
        return moment, moment, moment, ZERO, ZERO, ZERO
    rows = cast("list[Any]", given)
    if len(rows) == 3 and not any(isinstance(row, list) for row in rows):
        return (*(names.formula(v, INERTIA, "inertia", k) for k, v in enumerate(rows)), ZERO, ZERO, ZERO)
    if len(rows) != 3 or any(not isinstance(row, list) or len(cast("list[Any]", row)) != 3 for row in rows):
        names.problem(Message("inertia is [Ixx, Iyy, Izz], or three rows of three entries"), "inertia")
        return (ZERO,) * 6
    full = [[names.formula(v, INERTIA, "inertia", i, j) for j, v in enumerate(row)] for i, row in enumerate(rows)]
    for i, j in PLACES[3:]:
        above, below = names.numeric(full[i][j]), names.numeric(full[j][i])
        same = full[i][j] == full[j][i] if above is None or below is None else abs(above - below) <= SLACK * abs(above)
        if not same:
            names.problem(
                Message(
                    "an inertia tensor is symmetric, but the entries in row {i}, column {j} and row {j}, column "
                    "{i} differ; products of inertia enter with a minus: I_xy = -integral of x y dm",
                    i=i + 1,
                    j=j + 1,
                ),
                "inertia",
            )
    return tuple(full[i][j] for i, j in PLACES)


def check(names: Names, tensor: Components, where: str, *path: str | int) -> None:
    """Notes a problem where no body has this tensor: principal moments are not negative, and none is larger than the
    sum of the other two, since I_1 + I_2 - I_3 = 2 integral of z^2 dm."""
    numbers = [names.numeric(entry) for entry in tensor]
    if any(n is None for n in numbers):
        return
    entries = [float(n or 0.0) for n in numbers]
    if _is_of_a_body(entries):
        return
    moments = principal_moments(entries)
    listed = ", ".join(f"{m:.6g}" for m in moments)
    size = max(map(abs, moments))
    if moments[0] < -SLACK * size:
        names.problem(
            Message(
                "no body has this inertia tensor{where}: its principal moments are {listed} kg m^2, and none can "
                "be negative. Check the products of inertia, and about which point the tensor is given (about:)",
                where=where,
                listed=listed,
            ),
            *path,
        )
    else:
        names.problem(
            Message(
                "no body has this inertia tensor{where}: its principal moments are {listed} kg m^2, and the "
                "largest cannot be more than the sum of the other two. Check the entries, and about which point "
                "the tensor is given (about:)",
                where=where,
                listed=listed,
            ),
            *path,
        )


def _is_of_a_body(tensor: Sequence[float]) -> bool:
    """Whether tr(I)/2 - I, the integral of r r^T dm, has no negative principal minor. For a thin rod, whose two moments
    are equal, minors are exact where the moments lose half of their digits."""
    xx, yy, zz, xy, xz, yz = tensor
    half = (xx + yy + zz) / 2.0
    a, b, c = half - xx, half - yy, half - zz
    pairs = (a * b - xy * xy, a * c - xz * xz, b * c - yz * yz)
    whole = a * pairs[2] - xy * (xy * c + xz * yz) - xz * (xy * yz + b * xz)
    size = max(map(abs, tensor))
    return all(min(minors) >= -SLACK * size**n for n, minors in ((1, (a, b, c)), (2, pairs), (3, (whole,))))


def principal_moments(tensor: Sequence[float]) -> tuple[float, float, float]:
    """The eigenvalues of (xx, yy, zz, xy, xz, yz), ascending: with B = (A - q)/p, tr B = 0 and tr B^2 = 6 they are
    q + 2 p cos(phi + 2 pi k/3), cos(3 phi) = det(B)/2. Source: Smith, Comm. ACM 4 (1961) 168."""
    xx, yy, zz, xy, xz, yz = tensor
    q = (xx + yy + zz) / 3.0
    off = xy * xy + xz * xz + yz * yz
    p = math.sqrt(((xx - q) ** 2 + (yy - q) ** 2 + (zz - q) ** 2 + 2.0 * off) / 6.0)
    if p <= LEAST:
        return q, q, q
    if not off:
        low, middle, high = sorted((xx, yy, zz))
        return low, middle, high
    a, b, c, d, e, f = (v / p for v in (xx - q, yy - q, zz - q, xy, xz, yz))
    half = (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e)) / 2.0
    phi = math.acos(min(1.0, max(-1.0, half))) / 3.0
    first, last = q + 2.0 * p * math.cos(phi), q + 2.0 * p * math.cos(phi + 2.0 * math.pi / 3.0)
    low, middle, high = sorted((last, 3.0 * q - first - last, first))
    return low, middle, high
