"""Where measures and rows stand in the arrays: the entries of their gradients, and what is added up to fill them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from freebody.numeric.engine.packing import Packing


class MeasurePlaces:
    """The measures of a packing in the order of the arrays, those of one kind after each other.

    new: place in the arrays by place in the packing; kinds, starts: (n_kinds + 1,) where each kind and its gradients
    begin; bodies, numbers: (n_measures, most of a measure); unchanging: entries of gradients that are the same in every
    pose."""

    def __init__(self, packing: Packing) -> None:
        self._packing = packing
        pieces, known = packing.pieces, packing.measures
        order = sorted(range(len(pieces)), key=lambda k: pieces[k][0])
        self.new = {old: new for new, old in enumerate(order)}
        counts = [sum(1 for index, _ in pieces if index == i) for i in range(len(known.kinds))]
        self.kinds = np.concatenate(([0], np.cumsum(counts)))
        # a gradient has three entries for each cell of each body
        sizes = [3 * known.width * kind.n_bodies for kind in known.kinds]
        self.starts = np.concatenate(([0], np.cumsum([n * c for n, c in zip(sizes, counts, strict=True)])))
        self._begins = [
            int(self.starts[index]) + sizes[index] * (self.new[old] - int(self.kinds[index]))
            for old, (index, _key) in enumerate(pieces)
        ]
        self.bodies = np.zeros((len(order), known.max_bodies))
        self.numbers = np.zeros((len(order), known.max_numbers))
        for new, old in enumerate(order):
            _index, (bodies, numbers) = pieces[old]
            self.bodies[new, : len(bodies)] = bodies
            self.numbers[new, : len(numbers)] = numbers
        self.unchanging: dict[int, float] = {}
        for begin, (index, key) in zip(self._begins, pieces, strict=True):
            gradient = packing.constant_gradient(index, key)
            self.unchanging |= {begin + int(j): float(gradient[j]) for j in np.flatnonzero(~np.isnan(gradient))}

    @property
    def n_entries(self) -> int:
        return int(self.starts[-1])

    def slots(self, old: int) -> list[tuple[int, int]]:
        """Cells that a measure depends on, and where their gradient begins."""
        width, fixed = self._packing.measures.width, self._packing.n_bodies
        _index, (bodies, _numbers) = self._packing.pieces[old]
        listed = [
            (width * b + c, self._begins[old] + 3 * (width * j + c))
            for j, b in enumerate(bodies)
            for c in range(width)
            if b != fixed
        ]
        return [(cell, o) for cell, o in listed if any(self.unchanging.get(o + i) != 0.0 for i in range(3))]


class RowSlots:
    """The slots of rows, and what must be added up to fill them."""

    def __init__(self, n_entries: int) -> None:
        self.n_entries = n_entries
        self.slots: list[list[tuple[int, int]]] = []
        self.cleared: list[int] = []
        self.mix: list[tuple[int, int, float]] = []
        self.product_mix: list[tuple[int, int, int]] = []
        self.composed_mix: list[tuple[int, int, int, int]] = []

    def _own(self, cells: Iterable[int]) -> dict[int, int]:
        """Entries of its own for a row, three for each cell."""
        own: dict[int, int] = {}
        for cell in cells:
            if cell not in own:
                own[cell] = self.n_entries
                self.cleared.append(self.n_entries)
                self.n_entries += 3
        self.slots.append(list(own.items()))
        return own

    def add_base(self, pieces: Sequence[tuple[int, int, float]]) -> None:
        """A row of measures: (cell, entries, coefficient). A single measure lends it its own entries."""
        cells = [b for b, _o, _c in pieces]
        if len(set(cells)) == len(cells) and all(c == 1.0 for _b, _o, c in pieces):
            self.slots.append([(b, o) for b, o, _c in pieces])
            return
        own = self._own(cells)
        self.mix += [(own[b], o, c) for b, o, c in pieces]

    def add_product(self, terms: Sequence[tuple[int, int]]) -> None:
        """A row of products: (product, measure row)."""
        own = self._own(b for _p, m in terms for b, _o in self.slots[m])
        self.product_mix += [(own[b], p, o) for p, m in terms for b, o in self.slots[m]]

    def add_composed(self, k: int, used: Sequence[int]) -> None:
        """A row that is an expression in the rows `used`."""
        own = self._own(b for m in used for b, _o in self.slots[m])
        for m in used:
            pieces = [(own[b], k, o, m) for b, o in self.slots[m]]
            self.composed_mix += pieces or [(0, k, -1, m)]
