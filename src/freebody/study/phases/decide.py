"""Where which of several things happens: the space of parameters cut by inequalities, one after the other.

Every cut is an inequality and its opposite, so the cells exclude each other and cover the space whatever the numbers
are. Which inequalities cut, and what happens within a cell, is seen at the parameter sets (`Sets`): the cut that leaves
the least entropy of the labels comes first, as in a decision tree.
Source: Breiman, Friedman, Olshen & Stone, Classification and Regression Trees, 1984.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.jets import Array
from freebody.study.phases.numbers import Chosen, Mask
from freebody.symbolic.ratio import Ratio
from freebody.tolerances import ROUND_OFF

Inequality = tuple[Ratio, str, str]  # element, relation to 0, what for
NOTHING = -1  # a label: none of the things happens
_OPPOSITE = {">": ">=", ">=": ">"}


@dataclass(frozen=True)
class Test:
    """An inequality, `element relation 0`, at all sets; `known` where it has a real value. `purpose` says what it is
    for, `against` what its opposite is for."""

    element: Ratio
    relation: str
    holds: Mask
    known: Mask
    purpose: str = ""
    against: str = ""

    def side(self, holds: bool) -> Inequality:
        if holds:
            return self.element, self.relation, self.purpose
        return -self.element, _OPPOSITE[self.relation], self.against


@dataclass(frozen=True)
class Cell:
    """A part of the space of parameters: what happens in it, and the inequalities that cut it out. Without `is_exact`
    no inequality was found that tells it from another one."""

    label: int
    sets: Chosen
    cuts: tuple[Inequality, ...]
    is_exact: bool = True


def as_test(x: Ratio, relation: str, numbers: Array, purpose: str = "", against: str = "") -> Test:
    """The inequality in numbers as they are."""
    with np.errstate(invalid="ignore"):
        holds = numbers > 0 if relation == ">" else numbers >= 0
    return Test(x, relation, holds, np.isfinite(numbers), purpose, against)


def cells(labels: NDArray[np.intp], indices: Chosen, tests: Sequence[Test]) -> list[Cell]:
    """The cells, in the order of the first set in each."""
    found = [_pruned(cell, labels, indices) for cell in _cut(labels, indices, tests, ())]
    merged = [
        Cell(label, np.sort(sets), tuple(test.side(holds) for test, holds in path), exact)
        for label, sets, path, exact in found
    ]
    return sorted(merged, key=lambda cell: int(cell.sets[0]))


_Path = tuple[tuple[Test, bool], ...]
_Leaf = tuple[int, Chosen, _Path, bool]


def _cut(labels: NDArray[np.intp], sets: Chosen, tests: Sequence[Test], path: _Path) -> list[_Leaf]:
    own = np.unique(labels[sets])
    if len(own) < 2:
        return [(int(own[0]), sets, path, True)] if len(own) else []
    best: tuple[float, Test] | None = None
    for test in tests:
        holds = test.holds[sets]
        if not test.known[sets].all() or holds.all() or not holds.any():
            continue
        rest = _entropy(labels[sets[holds]]) + _entropy(labels[sets[~holds]])
        if best is None or rest < best[0] - ROUND_OFF:
            best = rest, test
    if best is None:
        return [(int(label), sets[labels[sets] == label], path, False) for label in own]
    test = best[1]
    found: list[_Leaf] = []
    for side in (True, False):
        found += _cut(labels, sets[test.holds[sets] == side], tests, (*path, (test, side)))
    return found


def _entropy(labels: NDArray[np.intp]) -> float:
    """n times the entropy of the labels of n sets."""
    _values, counts = np.unique(labels, return_counts=True)
    return float(len(labels) * np.log(len(labels)) - (counts * np.log(counts)).sum())


def _pruned(leaf: _Leaf, labels: NDArray[np.intp], indices: Chosen) -> _Leaf:
    """Without cuts that the others imply at every set."""
    label, sets, path, exact = leaf
    for cut in path:
        rest = tuple(other for other in path if other is not cut)
        if len(_within(rest, indices)) == len(sets) and exact:
            path = rest
    return label, sets, path, exact


def _within(path: _Path, indices: Chosen) -> Chosen:
    for test, holds in path:
        indices = indices[(test.holds[indices] == holds) & test.known[indices]]
    return indices
