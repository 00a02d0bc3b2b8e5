"""Runs the cases of a sweep on a cluster: blocks go to workers of dask, and their results come back to the one store.

What is asked travels once to each worker; a worker hangs on nothing but the numbers of the first and the last case of a
block, so that a block whose worker is lost is given to another one, and the results are those of one process. Only some
blocks are under way at a time, and only this process writes: a lost worker leaves nothing half written, and no file
system need be shared.
"""

from __future__ import annotations

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
from freebody.study.sweeps.evaluators import Codes, Evaluator
from freebody.study.sweeps.plan import Plan
from freebody.study.sweeps.running import Block, Progress, blocks
from freebody.study.sweeps.store import Store

MOST_BLOCKS = 256  # into which a small sweep is divided, so that all workers have some of it
LOOK = 5.0  # seconds after which it is seen whether there are workers still
LOST = 12  # looks without a worker, until it is said that there is none

_Part = tuple[NDArray[np.int64], Array, Codes]
_Piece = tuple[int, int, NDArray[np.bool_]]  # from which case to which, and those that are done already


@dataclass(frozen=True)
class Asked:
    """What a worker has to know. version: of the program that asks."""

    version: str
    plan: Plan
    evaluators: tuple[Evaluator, ...]


def run(
    client: Any,
    plan: Plan,
    evaluators: Sequence[Evaluator],
    store: Store,
    *,
    block: int,
    progress: Progress | None = None,
) -> bool:
    """Does all cases that are not done; False where Ctrl-C ended it, and what was done until then is kept. Raises
    CannotAnswer where the scheduler or all workers are lost, or a block cannot be looked at."""
    packed = pickle.dumps(Asked(version("freebody"), plan, tuple(evaluators)))
    todo = _open(plan.n, min(block, -(-plan.n // MOST_BLOCKS)), store)
    waiting: dict[Any, _Piece] = {}
    n_done = store.n_done
    try:
        asked = client.submit(_unpacked, packed, pure=False)
        while True:
            room = 2 * sum(client.nthreads().values()) + 2 - len(waiting)
            for piece in islice(todo, max(room, 0)):
                waiting[client.submit(_found, asked, *piece, pure=False)] = piece
            if not waiting:
                return True
            for future in _finished(client, waiting, store):
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


def _open(n: int, block: int, store: Store) -> Iterator[_Piece]:
    """The blocks in which something is left to do."""
    for start, stop in blocks(n, block):
        before = np.array(store.done[start:stop], dtype=bool)
        if not before.all():
            yield start, stop, before


def _finished(client: Any, waiting: dict[Any, _Piece], store: Store) -> list[Any]:
    """Blocks that have come to an end, as soon as there is one. Raises CannotAnswer if nobody is there to do them."""
    dask: Any = import_module("distributed")
    n_looks = 0
    while n_looks < LOST:
        try:
            return list(dask.wait(list(waiting), timeout=LOOK, return_when="FIRST_COMPLETED").done)
        except TimeoutError:
            is_alone = client.status != "running" or not client.nthreads()
            n_looks = n_looks + 1 if is_alone else 0
    raise CannotAnswer(store.kept(Message("no worker is left on the cluster")))


def _result(future: Any, piece: _Piece, store: Store) -> _Part:
    """What a block has come to. Raises CannotAnswer."""
    try:
        return future.result()
    except (FreebodyError, OSError, CancelledError):
        raise
    except Exception as error:
        first, last = piece[0] + 1, piece[1]
        if type(error).__name__ == "KilledWorker":
            why = Message("every worker that looked at them died; in smaller blocks (--block) they take less memory")
        else:
            why = f"{type(error).__name__}: {error}"
        told = Message(
            "cases {first} to {last} cannot be looked at on the cluster: {why}", first=first, last=last, why=why
        )
        raise CannotAnswer(store.kept(told)) from error


# -- on a worker ------------------------------------------------------------------------------
def _unpacked(packed: bytes) -> Asked:
    """Raises CannotAnswer if the worker has another version of the program, whose numbers may be others."""
    asked: Asked = pickle.loads(packed)
    own = version("freebody")
    if asked.version != own:
        raise CannotAnswer(Message("a worker has freebody {other}, not {version}", other=own, version=asked.version))
    return asked


def _found(asked: Asked, start: int, stop: int, before: NDArray[np.bool_]) -> _Part:
    """The results of the cases of a block that are not done."""
    kept: list[_Part] = []

    def keep(cases: NDArray[np.int64], numbers: Array, codes: Codes) -> None:
        kept.append((cases, numbers, codes))

    with ThreadPoolExecutor(1) as pool:
        Block(asked.plan, asked.evaluators, start, stop, before).run(pool, keep)
    cases, numbers, codes = (np.concatenate(parts) for parts in zip(*kept, strict=True))
    return cases, numbers, codes
