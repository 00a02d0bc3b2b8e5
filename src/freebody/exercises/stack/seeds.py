"""Seeds under which STACK takes one variant after the other.

`rand(n)` is Maxima's random(n): the first number of a Mersenne twister that starts from the seed, modulo n. NumPy's
RandomState is the same generator. Source: Matsumoto and Nishimura, ACM Trans. Model. Comput. Simul. 8, 1998, 3-30;
Maxima, src/rand-mt19937.lisp.
"""

from __future__ import annotations

from itertools import count

import numpy as np


def drawn(seed: int, n: int) -> int:
    """What rand(n) gives first."""
    return int(np.random.RandomState(seed).randint(0, 2**32, dtype=np.uint32)) % n


def seeds(n: int) -> tuple[int, ...]:
    """The smallest seed of each of n variants, in their order; none for one variant, as nothing is random there."""
    if n < 2:
        return ()
    return tuple(next(seed for seed in count(1) if drawn(seed, n) == k) for k in range(n))
