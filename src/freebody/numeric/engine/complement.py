"""Where everything stands in J M^-1 J^T and in its factor."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from freebody.numeric.engine.ordering import symbolic_factor
from freebody.numeric.kernels.arrays import Floats, floats, ints, pointers


def held_entries(
    slots: Sequence[tuple[int, int]], unchanging: Mapping[int, float], inverse_mass: Floats
) -> list[tuple[int, int, float | None]]:
    """(coordinate, gradient entry, its value if it never changes) of a held row, without those that move nothing."""
    listed = [(3 * cell + i, o + i, unchanging.get(o + i)) for cell, o in slots for i in range(3)]
    return [(c, o, fixed) for c, o, fixed in listed if fixed != 0.0 and inverse_mass[c] > 0.0]


def schur_complement(held: Sequence[Sequence[tuple[int, int, float | None]]], inverse_mass: Floats) -> dict[str, Any]:
    """Which pairs of entries make up J M^-1 J^T, what of it never changes, and where its factor stands."""
    at: dict[int, list[tuple[int, int, int, float | None]]] = {}
    slot = 0
    for r, entries in enumerate(held):
        for coordinate, offset, fixed in entries:
            at.setdefault(coordinate, []).append((r, slot, offset, fixed))
            slot += 1
    pairs: dict[tuple[int, int], list[tuple[int, int]]] = {(r, r): [] for r in range(len(held))}
    base: dict[tuple[int, int], float] = {}
    for coordinate, touching in at.items():
        for r, slot_r, _offset, fixed_r in touching:
            for s, _slot, offset_s, fixed_s in touching:
                if s > r:
                    continue
                pairs.setdefault((r, s), [])
                if fixed_r is not None and fixed_s is not None:
                    base[r, s] = base.get((r, s), 0.0) + fixed_r * fixed_s * float(inverse_mass[coordinate])
                else:
                    pairs[r, s].append((slot_r, offset_s))
    factor = symbolic_factor(len(held), {(r, s) for r, s in pairs if r > s})
    listed = sorted(factor.place, key=lambda key: factor.place[key])
    added = [pairs.get(key, []) for key in listed]
    return {
        "schur_base": floats([base.get(key, 0.0) for key in listed]),
        "pair_ptr": pointers(added),
        "pair_a": ints([a for entry in added for a, _b in entry]),
        "pair_b": ints([b for entry in added for _a, b in entry]),
        "column_ptr": factor.column_ptr,
        "column_row": factor.column_row,
        "target": factor.target,
    }
