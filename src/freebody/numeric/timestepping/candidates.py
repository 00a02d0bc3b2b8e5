"""The arrays of the places that may touch within the next steps, made anew whenever something has moved far enough."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.kernels.arrays import Floats, ints
from freebody.numeric.kernels.candidates import (
    CHOSEN,
    EDGE,
    FIRST_BODY,
    GAP,
    HIGH,
    LOW,
    N_NUMBER,
    N_SITE,
    N_SPANS,
    N_TERMS,
    SECOND_BODY,
    SIDE,
    SIGN,
    SLIP,
    SLIP_SIGN,
    SLOPE,
    SPAN,
    STATIC,
    TARGET,
    TURN,
    Candidates,
)
from freebody.numeric.kernels.measures_planar import KINDS, MAX_BODIES, MAX_NUMBERS, fill
from freebody.numeric.timestepping.shapes import Outlines
from freebody.numeric.timestepping.templates import Template

_WIDTH = np.array([kind.n_bodies for kind in KINDS], np.intp)


@dataclass(frozen=True)
class Built:
    """Candidates, and the identity of their sites and pairs."""

    arrays: Candidates
    pairs: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, np.intp))  # of every pair here
    site_pair: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, np.intp))  # of every site: its pair
    site_place: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, np.intp))  # among the sites of the pair


@dataclass
class _Group:
    """Near pairs with one template."""

    template: Template
    pairs: NDArray[np.intp]
    first: NDArray[np.intp]  # outlines
    second: NDArray[np.intp]

    def __post_init__(self) -> None:
        self.counts = np.bincount(self.template.kinds, minlength=len(KINDS))
        kinds = np.array(self.template.kinds, np.intp)
        self.rank = np.array([(kinds[:k] == kind).sum() for k, kind in enumerate(kinds)], np.intp)
        self.kinds = kinds

    def places(self, begin: NDArray[np.intp]) -> NDArray[np.intp]:
        """(n_pairs, n_measures): where the measures of every pair stand, those of this group beginning at `begin`."""
        pair = np.arange(len(self.pairs))[:, None]
        return begin[self.kinds] + self.rank + pair * self.counts[self.kinds]


def built(
    outlines: Outlines,
    templates: dict[tuple[int, int], Template],
    near: NDArray[np.intp],
    ends: tuple[NDArray[np.intp], NDArray[np.intp]],
    surfaces: Floats,
    n_bodies: int,
) -> Built:
    """The candidates of near pairs. ends: first and second outline of all pairs; surfaces: (n_all_pairs, 4), see
    `templates.SURFACE`."""
    groups = _groups(outlines, templates, near, ends)
    counts = sum((len(g.pairs) * g.counts for g in groups), np.zeros(len(KINDS), np.intp))
    kinds = np.concatenate(([0], np.cumsum(counts)))
    starts = np.concatenate(([0], np.cumsum(3 * _WIDTH * counts)))
    n_measures = int(kinds[-1])
    bodies = np.full((n_measures, MAX_BODIES), n_bodies, np.int32)
    numbers = np.zeros((n_measures, MAX_NUMBERS))
    begin = kinds[:-1].copy()
    sites: list[NDArray[np.intp]] = []
    values: list[Floats] = []
    n_edges: list[NDArray[np.intp]] = []
    site_pair: list[NDArray[np.intp]] = []
    site_place: list[NDArray[np.intp]] = []
    for g in groups:
        places = g.places(begin)
        begin += len(g.pairs) * g.counts
        of = np.column_stack([outlines.body[g.first], outlines.body[g.second], np.full(len(g.pairs), n_bodies)])
        bodies[places] = of[:, g.template.measure_bodies]
        given = [outlines.values[outlines.shape[o[0]]][outlines.place[o]] for o in (g.first, g.second)]
        filled = g.template.fill(given[0], given[1])
        numbers[places] = filled[0]
        sites.append(_sites(g, places, of))
        values.append(_values(g, filled[1:], surfaces))
        n_edges.append(np.full(len(g.pairs), g.template.n_edges))
        n = len(g.template.sites)
        site_pair.append(np.repeat(g.pairs, n))
        site_place.append(np.tile(np.arange(n), len(g.pairs)))
    lengths = np.concatenate([np.full(len(g.pairs), len(g.template.sites)) for g in groups] or [np.zeros(0)])
    kind_of = np.repeat(np.arange(len(KINDS)), counts)
    edges = np.concatenate(n_edges or [np.zeros(0)])
    gradient = np.zeros(int(starts[-1]))
    small_kinds, small_starts = ints(kinds), ints(starts[:-1])
    _fill(counts, starts, kinds, numbers, gradient)
    arrays = Candidates(
        kinds=small_kinds,
        starts=small_starts,
        bodies=bodies,
        numbers=numbers,
        measures=np.zeros((n_measures, 4)),
        gradient=gradient,
        at=ints(starts[kind_of] + 3 * _WIDTH[kind_of] * (np.arange(n_measures) - kinds[kind_of])),
        width=ints(_WIDTH[kind_of]),
        site=ints(np.concatenate(sites) if sites else [], 2, N_SITE),
        number=np.concatenate(values) if values else np.zeros((0, N_NUMBER)),
        memory=np.zeros((int(lengths.sum()), 3)),
        pair_ptr=ints(np.concatenate(([0], np.cumsum(lengths)))),
        pair=ints(np.column_stack([edges, np.full(len(edges), -1)]), 2, 2),
    )
    joined = [
        np.concatenate(x) if x else np.zeros(0, np.intp) for x in ([g.pairs for g in groups], site_pair, site_place)
    ]
    return Built(arrays, *joined)


def keep_memory(new: Built, old: Built) -> None:
    """Impulses and separating edges of pairs that were candidates before."""
    if len(old.pairs) and len(new.pairs):
        here, there = _shared(new.pairs, old.pairs)
        new.arrays.pair[here, CHOSEN] = old.arrays.pair[there, CHOSEN]
    if len(old.site_pair) and len(new.site_pair):
        size = 1 + max(int(new.site_place.max()), int(old.site_place.max()))
        here, there = _shared(new.site_pair * size + new.site_place, old.site_pair * size + old.site_place)
        new.arrays.memory[here] = old.arrays.memory[there]


def _shared(new: NDArray[np.intp], old: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Places of what is in both."""
    order = np.argsort(old)
    place = np.minimum(np.searchsorted(old, new, sorter=order), len(old) - 1)
    there = order[place]
    here = np.flatnonzero(old[there] == new)
    return here, there[here]


def _groups(
    outlines: Outlines,
    templates: dict[tuple[int, int], Template],
    near: NDArray[np.intp],
    ends: tuple[NDArray[np.intp], NDArray[np.intp]],
) -> list[_Group]:
    first, second = ends[0][near], ends[1][near]
    n_shapes = len(outlines.shapes)
    code = outlines.shape[first] * n_shapes + outlines.shape[second]
    found: list[_Group] = []
    for value in np.unique(code):
        key = (int(value) // n_shapes, int(value) % n_shapes)
        if key not in templates:
            templates[key] = Template(outlines.shapes[key[0]], outlines.shapes[key[1]])
        chosen = np.flatnonzero(code == value)
        found.append(_Group(templates[key], near[chosen], first[chosen], second[chosen]))
    return found


def _sites(g: _Group, places: NDArray[np.intp], of: NDArray[np.intp]) -> NDArray[np.intp]:
    """The rows of `Candidates.site` of one group."""
    c, m = g.template.columns, len(g.pairs)

    def global_(local: NDArray[np.intp]) -> NDArray[np.intp]:
        return np.where(local >= 0, places[:, local], -1)

    rows = np.empty((m, len(c.gap), N_SITE), np.intp)
    rows[:, :, GAP], rows[:, :, SIGN] = global_(c.gap), c.sign
    rows[:, :, SLIP : SLIP + N_TERMS], rows[:, :, SLIP_SIGN] = global_(c.slip), c.slip_sign
    rows[:, :, TURN] = global_(c.turn)
    rows[:, :, SPAN : SPAN + N_SPANS] = global_(c.spans)
    rows[:, :, EDGE], rows[:, :, SIDE] = c.edge, c.side
    rows[:, :, FIRST_BODY], rows[:, :, SECOND_BODY] = of[:, :1], of[:, 1:2]
    return rows.reshape(-1, N_SITE)


def _values(g: _Group, filled: tuple[Floats, ...], surfaces: Floats) -> Floats:
    """The rows of `Candidates.number` of one group."""
    slips, targets, lows, highs = filled
    rows = np.empty((*targets.shape, N_NUMBER))
    rows[:, :, TARGET], rows[:, :, SLOPE : SLOPE + N_TERMS] = targets, slips
    rows[:, :, LOW : LOW + N_SPANS], rows[:, :, HIGH : HIGH + N_SPANS] = lows, highs
    rows[:, :, STATIC:] = surfaces[g.pairs][:, None, :]
    return rows.reshape(-1, N_NUMBER)


def _fill(
    counts: NDArray[np.intp], starts: NDArray[np.intp], kinds: NDArray[np.intp], numbers: Floats, gradient: Floats
) -> None:
    """The entries of gradients that never change. `fill` writes with whatever has numbers: here, whole columns."""
    for k, kind in enumerate(KINDS):
        if not kind.unchanging or not counts[k]:
            continue
        size = 3 * kind.n_bodies
        # one measure whose numbers are columns, and whose gradient is a list of columns
        alone = np.zeros(len(KINDS) + 1, np.intp)
        alone[k + 1 :] = 1
        columns = _Columns(numbers[kinds[k] : kinds[k + 1]])
        table = gradient[starts[k] : starts[k + 1]].reshape(-1, size)
        fill(alone, np.zeros(len(KINDS), np.intp), columns, _Table(table))


class _Columns:
    """numbers[0, j] is the column j."""

    def __init__(self, numbers: Floats) -> None:
        self.numbers = numbers

    def __getitem__(self, key: tuple[int, int]) -> Floats:
        return self.numbers[:, key[1]]


class _Table:
    """gradient[j] = x sets the column j."""

    def __init__(self, table: Floats) -> None:
        self.table = table

    def __setitem__(self, key: int, value: Floats | float) -> None:
        self.table[:, key] = value
