"""The velocities at the start: those that are given, what is held kept, and the least energy for the rest."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

import numpy as np

from freebody.errors import CannotAnswer, Problem
from freebody.language.sentences import Message, listed
from freebody.model.elements import RigidBody
from freebody.model.state import rate_not_given
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jet_poses import entries_of
from freebody.numeric.jets import LARGE, Array, Gradient, Jet
from freebody.numeric.rotation import matrix
from freebody.numeric.sparse import SparseRows
from freebody.numeric.split import NO_GRADIENT, Split, stack
from freebody.numeric.start import Wanted
from freebody.numeric.system import NumericSystem
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, ROUNDED

_HAS_PART = 1e-6  # of the largest gap: less is round-off
_MOST_NAMED = 8  # rates that contradict each other; of more only the worst is named
NO_ENERGY = 1e-7  # of a motion of unit size: it moves massless bodies only
_Rate = tuple[str, Jet, float]  # whose rate, the jet that has it, and what it must be


def start_velocities(reference: NumericSystem, g: JetGeometry, extra: Wanted, *, with_start: bool) -> Array:
    """The velocities of least kinetic energy with all wanted rates; see `Reference.velocities`."""
    n = len(g.q)
    wanted = list(wanted_rates(reference, g, extra, with_start))
    b = np.array([rate - jet.rate for _name, jet, rate in wanted])
    if not b.any():
        return np.zeros(n)
    v = _given(reference, g.q) if with_start else None
    J: Array | SparseRows = _rates_matrix([jet for _name, jet, _rate in wanted], n)
    if v is None or np.abs(J @ v - b).max() > ROUNDED * np.abs(b).max():
        v = _least_velocities(reference, J, b)
    gaps = np.abs(J @ v - b)
    if gaps.size and gaps.max() > ROUND_OFF * max(1.0, float(np.abs(b).max())):
        raise CannotAnswer(_contradiction(reference.system, [name for name, _jet, _rate in wanted], gaps))
    return v


def _contradiction(system: System, names: Sequence[str], gaps: Array) -> str:
    """What contradicts: the gaps r of least squares fulfil J' r = 0, so that the rates in which r is not zero cannot
    all have their values, as r . b is not zero."""
    k = int(gaps.argmax())
    parts = list(dict.fromkeys(name for name, gap in zip(names, gaps, strict=True) if gap > _HAS_PART * gaps[k]))
    if not 1 < len(parts) <= _MOST_NAMED:
        return Message(
            "the velocities contradict each other: at best {name} is off by {gap:.3g} (in SI units). Change or remove "
            "one of them",
            name=names[k],
            gap=gaps[k],
        )
    told = Message(
        "the velocities of {names} contradict each other: at best {name} is off by {gap:.3g} (in SI units). Change or "
        "remove one of them",
        names=listed([*dict.fromkeys(_as_written(system, part) for part in parts)]),
        name=names[k],
        gap=gaps[k],
    )
    return Problem((), told).text(system.document.file)


def _as_written(system: System, part: str) -> str:
    """What contradicts by the name that it has in the file, with its line where the file gives a value."""
    paths: dict[str, tuple[str, ...]] = {
        f"{field} of {body.name}": ("bodies", body.name, field)
        for body in system.all_moving
        for field in ("velocity", "angular_velocity")
    }
    paths |= {f"rate({name})": ("start", f"rate({name})") for name in system.all_start_rates}
    paths |= {row.name: ("connections", row.connection) for row in system.constraint_rows if row.connection}
    if (path := paths.get(part)) is None:
        return part
    name = path[1] if path[0] == "connections" else part
    line = system.document.locate(Problem(path, part)).line
    return name if line is None else Message("{name} (line {line})", name=name, line=line)


def _rates_matrix(jets: Sequence[Jet], n: int) -> Array | SparseRows:
    """The coefficients of velocities in some rates. Raises CannotAnswer for infinite ones."""
    if n <= LARGE:
        return stack([jet.row(n) for jet in jets], n)
    J = SparseRows([jet.gradient for jet in jets], n)
    if not J.are_finite:
        raise CannotAnswer(NO_GRADIENT)
    return J


def _least_velocities(reference: NumericSystem, J: Array | SparseRows, b: Array) -> Array:
    """The velocities of least kinetic energy with J v = b, or the nearest to that."""
    D = reference.sizes.small_moves
    if isinstance(J, SparseRows) and reference.masses.all():
        return J.least(D, b)
    split = Split(J.whole if isinstance(J, SparseRows) else J, D)
    return _of_least_energy(reference.masses, split.null, split.least(b))


def _of_least_energy(masses: Array, free: Array, v: Array) -> Array:
    """The velocities of least kinetic energy, masses (n,) as they are, from v (n,): those of the smallest move, where
    massless bodies count as light ones. free: (n, k) the velocities that may be added. Of several the smallest move."""
    if masses.all() or not free.size:
        return v
    roots = np.sqrt(masses)
    U, sizes, Vt = np.linalg.svd(roots[:, None] * free, full_matrices=False)  # sizes: 1 where only masses move
    has_energy = sizes > NO_ENERGY
    along = (U[:, has_energy].T @ (roots * v)) / sizes[has_energy]
    return v - free @ (Vt[has_energy].T @ along)


def _given(reference: NumericSystem, q: Array) -> Array | None:
    """The velocities, if the model gives those of every body."""
    v = np.zeros(len(reference.masses))
    for body in reference.system.all_moving:
        rates, columns = list(_body_rates(reference, body, q)), reference.columns(body.name)
        if len(rates) < len(columns):
            return None
        if reference.system.space:
            rows = np.array([jet.row(len(v))[list(columns)] for _name, jet, _rate in rates])
            v[list(columns)] = rows.T @ np.array([rate for _name, _jet, rate in rates])  # the rows are orthonormal
            continue
        v[list(columns)] = [rate for _name, _jet, rate in rates]
    return v


def wanted_rates(reference: NumericSystem, g: JetGeometry, extra: Wanted, with_start: bool) -> Iterator[_Rate]:
    """Held measures keep up with their targets; then the rates of the model's start, unless an extra one
    replaces them, and the extra ones. What closes at the start does not hold before."""
    system = reference.system
    for row in system.constraint_rows:
        if row.closes and with_start:
            continue
        yield row.name, reference.gap(row, g), 0.0
    given = {name: reference.number(expr) for name, expr in system.all_start_rates.items()}
    for name, rate in given.items() if with_start else ():
        measure = system.all_measures[name]
        if all(measure != other for other, _ in extra):
            yield f"rate({name})", reference.jet(g, measure, name), rate
    for measure, rate in extra:
        name = reference.name_of(measure)
        yield f"the rate of {name}", reference.jet(g, measure, name), rate
    for body in system.all_moving if with_start else ():
        yield from _body_rates(reference, body, g.q)


def _body_rates(reference: NumericSystem, body: RigidBody, q: Array) -> Iterator[_Rate]:
    """A velocity or an angular velocity that the model gives to a body at the start."""
    start, columns = body.start, reference.columns(body.name)
    if start.rates is not None and body.turns:
        own = list(columns[3:])
        P = reference.frame.principal[body.name]
        axes = P if start.rates_in_body else matrix(q[own])  # of the components, along the principal axes
        for along, expr in zip(axes, start.rates, strict=True):
            row = entries_of(own, along, len(reference.masses))
            yield f"angular_velocity of {body.name}", Jet(0.0, row), reference.number(expr)

    def unit_row(k: int) -> Gradient:
        return entries_of((columns[k],), np.ones(1), len(reference.masses))

    for k, expr in enumerate(start.velocity or ()):
        yield f"velocity of {body.name}", Jet(0.0, unit_row(k)), reference.number(expr)
    if start.angular_velocity is not None and body.turns:
        spin = reference.number(start.angular_velocity)
        yield f"angular_velocity of {body.name}", Jet(0.0, unit_row(2)), spin


def rates_not_given(reference: NumericSystem, q: Array, v: Array) -> tuple[str, ...]:
    """What is assumed of a start: named measures that run, though neither connections nor the start decide how fast."""
    if not reference.system.measures:
        return ()
    n = len(q)
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    rows = [jet.row(n) for _name, jet, _rate in wanted_rates(reference, g, (), True)]
    free = Split(stack(rows, n), reference.sizes.small_moves).null
    found: list[str] = []
    for name, measure in reference.system.measures.items():
        with suppress(CannotAnswer):
            row = reference.jet(g, measure, name).row(n)
            is_open = np.abs(row @ free).max(initial=0.0) > ROUND_OFF * np.abs(row).max(initial=0.0)
            if is_open and abs(float(row @ v)) > ROUND_OFF and name not in reference.system.start_rates:
                found.append(rate_not_given(name))
    return tuple(found)
