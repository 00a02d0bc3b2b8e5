"""A scheduler of dask that cases are given to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from freebody.language.sentences import Message


def _nobody() -> bool:
    return False


@dataclass(frozen=True)
class Scheduler:
    """address: where it is; are_coming: whether workers will come yet though there is none, as of jobs in a queue;
    without: what is told where none has come."""

    address: str
    are_coming: Callable[[], bool] = _nobody
    without: str = Message("the scheduler there has no workers")
