"""How much inertia a body without any is lent for the factor of J M^-1 J^T.

What is lent is taken back (`solving.solve`), so that no answer depends on it but by round-off: the less is lent, the
larger its inverse beside those of the neighbours, and the more digits J G^-1 J^T loses (with 1e-6 of the heaviest mass
a crank in space had twice the rejected steps of 1e-4). So it is of a size that goes with its neighbours: a part of the
lightest mass of the part that the body belongs to, at an arm of the body's own.
"""

from __future__ import annotations

import numpy as np

from freebody.numeric.engine.cells import Cells
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.numbers import Numbers
from freebody.numeric.sizes import neighbours

OF_LIGHTEST = 1e-2  # of the mass of the lightest body of the part
OF_HEAVIEST = 1e-4  # at least so much of the heaviest, for the sake of the pivots


def lent_sizes(numbers: Numbers, cells: Cells, masses: Floats) -> Floats:
    """What each body would be lent at each coordinate [kg, kg m^2]; masses: (n_bodies + 1, coordinates) as they are."""
    n_places = 2 if masses.shape[1] == 3 else 3
    own = masses[:-1].tolist()
    near = neighbours(numbers.system, numbers.number, [m[0] for m in own], [m[n_places:] for m in own])
    sizes = np.zeros_like(masses)
    for k, n in enumerate(near):
        sizes[k] = cells.sizes(max(OF_LIGHTEST * n.lightest, OF_HEAVIEST * n.heaviest), n.arm)
    return sizes
