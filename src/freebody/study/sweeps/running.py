"""Runs the cases of a sweep, block by block.

What formulas tell is told for a whole block at once; the cases that are left go to a pool of threads, a few at a time.
A case hangs on its own values alone, and blocks begin at multiples of `TILE`, so that no array operation sees a case at
another place of a vector register: results are the same, bit for bit, for any number of threads and any block.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.evaluators import Codes, Evaluator, Found
from freebody.study.sweeps.plan import Plan
from freebody.study.sweeps.statuses import CODES, NOT_DONE
from freebody.study.sweeps.store import Store

TILE = 64
BLOCK = 4096
MOST_THREADS = 256
_GROUP = 4  # cases that a thread takes at a time

Progress = Callable[[int, int], None]  # cases done, cases in all
Keep = Callable[[NDArray[np.int64], Array, Codes], None]  # results of some cases, by their numbers
_Job = list[tuple[int, list[int]]]  # cases of a block, each with the evaluators that have to look at it


def n_threads(threads: int | None) -> int:
    """As many as are asked for, else as there are processors."""
    return min(os.cpu_count() or 1, MOST_THREADS) if threads is None else threads


def check(threads: int, block: int) -> None:
    """Raises InputError for numbers without sense."""
    if not 1 <= threads <= MOST_THREADS:
        raise InputError(Message("there are between 1 and {most} threads, not {n}", most=MOST_THREADS, n=threads))
    if block < 1:
        raise InputError(Message("a block has at least one case, not {n}", n=block))


def blocks(n: int, block: int) -> Iterator[tuple[int, int]]:
    """From which case to which, whole tiles in each."""
    size = -(-block // TILE) * TILE
    for start in range(0, n, size):
        yield start, min(start + size, n)


def run(
    plan: Plan,
    evaluators: Sequence[Evaluator],
    store: Store,
    *,
    threads: int,
    block: int,
    progress: Progress | None = None,
) -> bool:
    """Does all cases that are not done; False where Ctrl-C ended it, and what was done until then is kept."""
    pool = ThreadPoolExecutor(threads, thread_name_prefix="freebody-sweep")
    try:
        for start, stop in blocks(plan.n, block):
            before = np.array(store.done[start:stop], dtype=bool)
            if not before.all():
                Block(plan, evaluators, start, stop, before).run(pool, store.put, progress)
            elif progress is not None:
                progress(stop, plan.n)
    except KeyboardInterrupt:
        return False
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
        store.flush()
    return True


class Block:
    """The cases from one to another. before: (n,) those of them that are done already."""

    def __init__(
        self, plan: Plan, evaluators: Sequence[Evaluator], start: int, stop: int, before: NDArray[np.bool_]
    ) -> None:
        self.evaluators, self.start, self.n, self.before = evaluators, start, stop - start, before
        self.n_all = plan.n
        values = plan.cases(start, stop)
        self.values = {v.parameter: np.ascontiguousarray(values[:, k]) for k, v in enumerate(plan.names)}
        ends = np.cumsum([0, *(len(e.columns) for e in evaluators)])
        self.columns = [slice(int(a), int(b)) for a, b in pairwise(ends)]
        self.numbers: Array = np.full((self.n, int(ends[-1])), np.nan)
        self.codes: Codes = np.zeros((self.n, len(evaluators)), dtype=np.int8)

    def run(self, pool: ThreadPoolExecutor, keep: Keep, progress: Progress | None = None) -> None:
        """Looks at the cases that are not done, and hands on what they have come to as soon as it is known."""
        for k, evaluator in enumerate(self.evaluators):
            self.numbers[:, self.columns[k]], self.codes[:, k] = evaluator.together(self.values, self.n)
        jobs = self._jobs()
        self._keep(keep, np.flatnonzero((self.codes != CODES[NOT_DONE]).all(axis=1) & ~self.before))
        waiting: dict[Future[list[list[Found]]], _Job] = {}
        n_done = self.n - sum(map(len, jobs))
        try:
            for job in jobs:
                waiting[pool.submit(self._look, job)] = job
            for future in as_completed(waiting):
                self._take(keep, waiting[future], future.result())
                n_done += len(waiting[future])
                if progress is not None:
                    progress(self.start + n_done, self.n_all)
        finally:
            for future in waiting:
                future.cancel()
        if progress is not None:
            progress(self.start + self.n, self.n_all)

    def _jobs(self) -> list[_Job]:
        """The cases that have to be looked at one by one, a few together."""
        open_ = (self.codes == CODES[NOT_DONE]) & ~self.before[:, None]
        cases = [(int(i), [int(k) for k in np.flatnonzero(open_[i])]) for i in np.flatnonzero(open_.any(axis=1))]
        return [cases[i : i + _GROUP] for i in range(0, len(cases), _GROUP)]

    def _look(self, job: _Job) -> list[list[Found]]:
        found: list[list[Found]] = []
        for i, which in job:
            values = {name: float(x[i]) for name, x in self.values.items()}
            found.append([self.evaluators[k].alone(values) for k in which])
        return found

    def _take(self, keep: Keep, job: _Job, found: Sequence[Sequence[Found]]) -> None:
        for (i, which), of_case in zip(job, found, strict=True):
            for k, one in zip(which, of_case, strict=True):
                self.numbers[i, self.columns[k]] = one.numbers
                self.codes[i, k] = CODES[one.status]
        self._keep(keep, np.array([i for i, _which in job]))

    def _keep(self, keep: Keep, here: NDArray[np.int64]) -> None:
        keep(here + self.start, self.numbers[here], self.codes[here])
