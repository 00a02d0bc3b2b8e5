"""Room for the evaluations of a packed system."""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody.numeric.engine.cells import PLANE, SPACE
from freebody.numeric.kernels.arrays import ModelArrays, Workspace


def room_for(layout: ModelArrays, *, space: bool = False) -> Workspace:
    """Empty room for a layout, its constant gradients filled in."""
    n, known = len(layout.inverse_mass) // 3, SPACE if space else PLANE
    n_bodies, widest = n // known.width, 3 * known.width * known.max_bodies
    n_measures, n_rows, n_held = len(layout.measure_numbers), len(layout.row_constant), len(layout.held)
    n_entries = int(
        max(
            [
                0,
                *(layout.slots[:, 1] + 3).tolist(),
                *(
                    int(layout.starts[k] + widest * (layout.kinds[k + 1] - layout.kinds[k]))
                    for k in range(len(layout.starts))
                ),
            ]
        )
    )

    def empty(*shape: int) -> Any:
        return np.zeros(shape)

    room = Workspace(
        turn=empty(0 if space else n_bodies, 2),
        frames=np.tile(np.eye(3).ravel(), (n_bodies, 1)) if space else None,
        gyroscopic=empty(len(layout.gyration), 3),
        measures=empty(n_measures, 4),
        gradient=empty(n_entries),
        rows=empty(n_rows, 5),
        registers=empty(max(1, len(layout.tape)), 4),
        product_weight=empty(len(layout.product)),
        held=empty(n_held, 6),
        force=empty(3 * n),
        weighted=empty(len(layout.held_slots)),
        schur=empty(int(layout.column_ptr[-1])),
        diagonal=empty(n_held),
        step=empty(n_held),
        multiplier=empty(n_held),
        acceleration=empty(3 * n),
        residual=empty(3 * n),
        descent=empty(3 * n),
        search=empty(3 * n),
        slide_force=empty(len(layout.slide)),
        slide_response=empty(len(layout.slide) + 1, n_held),
        unit_force=empty(3 * n),
        slide_matrix=empty(len(layout.slide), len(layout.slide) + 1),
        info=empty(8),
    )
    known.fill(layout.kinds, layout.starts, layout.measure_numbers, room.gradient)
    return room
