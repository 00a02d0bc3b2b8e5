"""Processes of this machine: motions spend much of their time in Python, of which a process does one thing at a
time."""

from __future__ import annotations

import logging
import signal
from collections.abc import Generator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.study.sweeps.clusters.base import Scheduler

FORM = "local:8"
PATIENCE = 120
MOST = 1024  # processes


def check(rest: str) -> None:
    if not rest.isdigit() or not 1 <= int(rest) <= MOST:
        raise InputError(
            Message("local:{text}: write how many processes, 1 to {most}, as {form}", text=rest, most=MOST, form=FORM)
        )


@contextmanager
def scheduler(rest: str) -> Generator[Scheduler]:
    with began(int(rest), "127.0.0.1") as address:
        yield Scheduler(address)


@contextmanager
def began(n: int, host: str) -> Generator[str]:
    """A scheduler in this process, with so many processes as workers; its page is for this machine alone."""
    dask: Any = import_module("distributed")
    try:
        cluster = dask.LocalCluster(
            n_workers=n,
            threads_per_worker=1,
            host=host,
            dashboard_address="127.0.0.1:0",
            silence_logs=logging.CRITICAL,
            preload=[__name__],
        )
    except RuntimeError as error:
        told = Message(
            "the processes do not start: {why}. Each reads the script again that asks for them: put what it does "
            'under if __name__ == "__main__":',
            why=str(error).rstrip("."),
        )
        raise InputError(told) from error
    with cluster:
        yield cluster.scheduler_address


def dask_setup(_worker: object) -> None:
    """Ctrl-C is a matter of the process that asks, and reaches all of a terminal."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
