"""Runs the cases of a sweep on a cluster: blocks go to workers of dask, and their results come back to the one store.

What is asked travels once to each worker; a worker hangs on nothing but the numbers of the first and the last case of a
block, so that a block whose worker is lost is given to another one, and the results are those of one process. Only some
blocks are under way at a time, and only this process writes: a lost worker leaves nothing half written, and no file
system need be shared. A scheduler reads the tasks that it hands on: they are made of what Python itself has, so that
freebody has to be where the workers are, and nowhere else.
"""

from __future__ import annotations

import operator
import pickle
from collections.abc import Iterator, Sequence
from concurrent.futures import CancelledError, ThreadPoolExecutor
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import version
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer, FreebodyError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.clusters import Cluster
from freebody.study.sweeps.evaluators import Codes, Evaluator
from freebody.study.sweeps.plan import Plan
from freebody.study.sweeps.running import Block, Progress, blocks
from freebody.study.sweeps.store import Store

MOST_BLOCKS = 256  # into which a small sweep is divided, so that all workers have some of it
LOOK = 5.0  # seconds after which it is seen whether there are workers still
LOST = 12  # looks without a worker, until it is said that there is none

_Part = tuple[NDArray[np.int64], Array, Codes]
_Piece = tuple[int, int, bytes]  # from which case to which, and for each whether it is done already


@dataclass(frozen=True)
class Asked:
    """What a worker has to know, called on it for the results of the cases of a block that are not done."""

    plan: Plan
    evaluators: tuple[Evaluator, ...]

    def __call__(self, start: int, stop: int, before: bytes) -> _Part:
        kept: list[_Part] = []

        def keep(cases: NDArray[np.int64], numbers: Array, codes: Codes) -> None:
            kept.append((cases, numbers, codes))

        done = np.frombuffer(before, dtype=bool)
        with ThreadPoolExecutor(1) as pool:
            Block(self.plan, self.evaluators, start, stop, done).run(pool, keep)
        cases, numbers, codes = (np.concatenate(parts) for parts in zip(*kept, strict=True))
        return cases, numbers, codes

    def __reduce__(self) -> Any:
        """With the version of the program before all else: another one may not be able to read the rest."""
        return _unpacked, (version("freebody"), pickle.dumps((self.plan, self.evaluators)))


def _unpacked(wanted: str, packed: bytes) -> Asked:
    """Raises CannotAnswer if the worker has another version of the program, whose numbers may be others."""
    if (own := version("freebody")) != wanted:
        raise _other_version("", own, wanted)
    return Asked(*pickle.loads(packed))


def run(
    cluster: Cluster,
    plan: Plan,
    evaluators: Sequence[Evaluator],
    store: Store,
    *,
    block: int,
    progress: Progress | None = None,
) -> bool:
    """Does all cases that are not done; False where Ctrl-C ended it, and what was done until then is kept. Raises
    CannotAnswer where the scheduler or all workers are lost, or a block cannot be looked at."""
    client = cluster.client
    _check_workers(client)
    packed = pickle.dumps(Asked(plan, tuple(evaluators)))
    todo = _open(plan.n, min(block, -(-plan.n // MOST_BLOCKS)), store)
    waiting: dict[Any, _Piece] = {}
    n_done = store.n_done
    try:
        asked = client.submit(pickle.loads, packed, pure=False)
        while True:
            room = 2 * cluster.n_threads + 2 - len(waiting)
            for piece in islice(todo, max(room, 0)):
                waiting[client.submit(operator.call, asked, *piece, pure=False)] = piece
            if not waiting:
                return True
            for future in _finished(cluster, waiting, store):
                part = _result(future, waiting.pop(future), store)
                store.put(*part)
                n_done += len(part[0])
                if progress is not None:
                    progress(n_done, plan.n)
    except KeyboardInterrupt:
        return False
    except (OSError, CancelledError) as error:  # what connections raise, and futures of a scheduler that is gone
        raise CannotAnswer(store.kept(Message("the scheduler of the cluster does not answer any more"))) from error
    finally:
        for future in waiting:
            future.release()
        store.flush()


def _check_workers(client: Any) -> None:
    """Raises CannotAnswer if one of the workers that are there has no freebody, or another version."""
    wanted = version("freebody")
    for address, found in client.run(version, "freebody", on_error="return").items():
        if isinstance(found, Exception):
            raise _without_freebody(address)
        if found != wanted:
            raise _other_version(address, found, wanted)


def _other_version(address: str, found: str, wanted: str) -> CannotAnswer:
    return CannotAnswer(
        Message(
            "a worker{where} has freebody {other}, not {version}: install the same version for all",
            where=f" ({address})" if address else "",
            other=found,
            version=wanted,
        )
    )


def _without_freebody(address: str) -> CannotAnswer:
    return CannotAnswer(
        Message(
            "a worker{where} has no freebody: install it where the workers run, in the same version",
            where=f" ({address})" if address else "",
        )
    )


def _open(n: int, block: int, store: Store) -> Iterator[_Piece]:
    """The blocks in which something is left to do."""
    for start, stop in blocks(n, block):
        before = np.array(store.done[start:stop], dtype=bool)
        if not before.all():
            yield start, stop, before.tobytes()


def _finished(cluster: Cluster, waiting: dict[Any, _Piece], store: Store) -> list[Any]:
    """Blocks that have come to an end, as soon as there is one. Raises CannotAnswer if nobody is there to do them."""
    dask: Any = import_module("distributed")
    client, n_looks = cluster.client, 0
    while n_looks < LOST:
        try:
            return list(dask.wait(list(waiting), timeout=LOOK, return_when="FIRST_COMPLETED").done)
        except TimeoutError:
            is_lost = client.status != "running"
            is_alone = is_lost or not (client.nthreads() or cluster.scheduler.are_coming())
            n_looks = n_looks + 1 if is_alone else 0
    raise CannotAnswer(store.kept(Message("no worker is left on the cluster")))


def _result(future: Any, piece: _Piece, store: Store) -> _Part:
    """What a block has come to. Raises CannotAnswer."""
    try:
        return future.result()
    except (FreebodyError, OSError, CancelledError):
        raise
    except Exception as error:
        if isinstance(error, ModuleNotFoundError) and (error.name or "").partition(".")[0] == "freebody":
            raise _without_freebody("") from error  # a worker that came later
        first, last = piece[0] + 1, piece[1]
        if type(error).__name__ == "KilledWorker":
            why = Message("every worker that looked at them died; in smaller blocks (--block) they take less memory")
        else:
            why = f"{type(error).__name__}: {error}"
        told = Message(
            "cases {first} to {last} cannot be looked at on the cluster: {why}", first=first, last=last, why=why
        )
        raise CannotAnswer(store.kept(told)) from error
