"""A scheduler that runs already, with the workers that it has."""

from __future__ import annotations

import re
from collections.abc import Generator
from contextlib import contextmanager

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.study.sweeps.clusters.base import Scheduler

FORM = "tcp://scheduler:8786"
PATIENCE = 30
_REST = re.compile(r"//[^\s/:]+:\d{1,5}|//\[[0-9a-fA-F:]+\]:\d{1,5}")


def check(rest: str) -> None:
    if not _REST.fullmatch(rest):
        raise InputError(Message("tcp:{text} is no address of a scheduler; write {form}", text=rest, form=FORM))


@contextmanager
def scheduler(rest: str) -> Generator[Scheduler]:
    yield Scheduler(f"tcp:{rest}")
