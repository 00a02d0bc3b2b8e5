"""Where the cases of a sweep are looked at beyond this process, a file each, found by itself: the name of the file is
the word before the colon, `FORM` how it is written, `PATIENCE` how many seconds the first worker may take where none is
known to be coming, `check` what is wrong with what stands behind the colon, and `scheduler` a context with a
`Scheduler` of dask."""

from __future__ import annotations

import logging
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pkgutil import iter_modules
from typing import Any

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.study.sweeps.clusters.base import Scheduler


@dataclass(frozen=True)
class Cluster:
    """A scheduler, and the client of dask that is connected to it."""

    client: Any
    scheduler: Scheduler

    @property
    def n_threads(self) -> int:
        """Of all workers that are there."""
        return sum(self.client.nthreads().values())


def clusters() -> tuple[str, ...]:
    """The names of all; none is loaded."""
    return tuple(module.name for module in iter_modules(__path__) if module.name != "base")


def _kind(text: str) -> Any:
    word = text.partition(":")[0]
    if word not in clusters():
        forms = ", ".join(import_module(f"{__name__}.{name}").FORM for name in clusters())
        raise InputError(Message("{text}: there is no such cluster. One writes {forms}", text=text, forms=forms))
    return import_module(f"{__name__}.{word}")


def check_cluster(text: str) -> None:
    """Raises InputError for what cannot be read and for what is not installed, before anything is computed."""
    kind = _kind(text)
    if not find_spec("distributed"):
        raise InputError(Message('{text}: needs dask.distributed; pip install "freebody[sweep]"', text=text))
    kind.check(text.partition(":")[2])


@contextmanager
def connected(text: str) -> Generator[Cluster]:
    """The cluster that a text names, with at least one worker. Raises InputError."""
    kind, dask = _kind(text), import_module("distributed")
    silent = import_module("distributed.utils").silence_logging_cmgr(logging.CRITICAL)  # what is lost is told in words
    with silent, kind.scheduler(text.partition(":")[2]) as scheduler:
        try:
            client = dask.Client(scheduler.address, timeout="30 s", set_as_default=False)
        except (OSError, ValueError) as error:  # a time that is over is an OSError
            raise InputError(Message("{text}: no scheduler answers there", text=text)) from error
        with client, client.as_current():
            while not client.nthreads():
                try:
                    client.wait_for_workers(1, timeout=kind.PATIENCE)
                except TimeoutError as error:
                    if not scheduler.are_coming():
                        raise InputError(Message("{text}: {why}", text=text, why=scheduler.without)) from error
            yield Cluster(client, scheduler)
