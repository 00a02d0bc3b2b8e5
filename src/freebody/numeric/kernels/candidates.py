"""The arrays of the places that may touch within the next steps of time stepping."""

from __future__ import annotations

from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, Ints2

N_TERMS = 3  # most measures in one slip
N_SPANS = 2  # most spans of one site
# columns of `Candidates.site`: places of measures and what is known of them
GAP, SIGN, SLIP, SLIP_SIGN, TURN, SPAN, EDGE, SIDE, FIRST_BODY, SECOND_BODY = 0, 1, 2, 5, 6, 7, 9, 10, 11, 12
N_SITE = 13
# columns of `Candidates.number`
TARGET, SLOPE, LOW, HIGH, STATIC, KINETIC, RESTITUTION, ARM = 0, 1, 4, 6, 8, 9, 10, 11
N_NUMBER = 12
# columns of `Candidates.memory`: impulses of the last step, by which the next one begins
NORMAL_IMPULSE, SLIP_IMPULSE, TURN_IMPULSE = range(3)
# columns of `Candidates.pair`
N_EDGES, CHOSEN = 0, 1


class Candidates(NamedTuple):
    """Places that may touch; those of one pair of outlines stand together."""

    kinds: Ints  # measures, as in a layout
    starts: Ints
    bodies: Ints2
    numbers: Floats2
    measures: Floats2
    gradient: Floats
    at: Ints  # where the gradient of a measure begins
    width: Ints  # its number of bodies
    site: Ints2  # (n_sites, N_SITE)
    number: Floats2  # (n_sites, N_NUMBER)
    memory: Floats2  # (n_sites, 3) [N s or N m s]
    pair_ptr: Ints
    pair: Ints2  # (n_pairs, 2): number of edges, the one that separates best (-1: not known)
