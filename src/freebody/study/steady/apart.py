"""Conditions of steady motion that have one unknown place each, as those of the arms of a governor that is driven."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import zeros_of

MOST_ROOTS = 4  # of one condition


def places_apart(
    model: SymbolicModel, equations: Sequence[Ratio], places: Sequence[Coordinate], speeds: Sequence[int]
) -> dict[int, list[Ratio]] | None:
    """The values of each place by its generator, the first place among them; None where conditions are not so, or have
    no closed form. speeds: rates that are unknown too."""
    f, unknown = model.field, {*(c.index for c in places), *speeds}
    by_place: dict[int, Ratio] = {}
    for equation in equations:
        inside = set(f.ingredients(equation)) & unknown
        if len(inside) != 1 or inside & by_place.keys():
            return None
        by_place[inside.pop()] = equation
    if places[0].index not in by_place or by_place.keys() & set(speeds):
        return None
    with model.samples.apart():  # signs of roots do not matter, since both are among the zeros
        roots = {c.index: zeros_of(model, by_place[c.index], c) for c in places if c.index in by_place}
    return roots if all(0 < len(found) <= MOST_ROOTS for found in roots.values()) else None


def nearest(model: SymbolicModel, index: int, roots: Sequence[Ratio]) -> Ratio:
    """The root that the start is nearest to at the model's own values; the first where that cannot be told."""
    start = model.samples.start_numbers(index)

    def distance(x: Ratio) -> float:
        numbers = model.samples.at_starts(x)
        is_known = bool(start) and bool(numbers) and numbers[0] == numbers[0]
        return abs(numbers[0] - start[0]) if is_known else float("inf")

    return min(roots, key=distance)
