"""How far a simulation, or a sweep of many cases, is, on a terminal."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import ExitStack, contextmanager
from typing import Any

from freebody.present.busy import busy

PATIENCE = 0.5  # seconds before a bar appears


@contextmanager
def progress_bar(until: float) -> Generator[Callable[[float, int], None]]:
    """Shows simulated time and rate on a terminal's error stream if a run takes longer than `PATIENCE`."""
    with _bar("simulating", "{task.completed:8.4g} of {task.total:g} s", "{task.fields[rate]:.3g} s/s") as update:
        yield lambda now, _steps: update(now, until)


@contextmanager
def count_bar(what: str) -> Generator[Callable[[int, int], None]]:
    """The same for cases that are done, of those that there are; what: is done before the first of them."""
    with _bar(what, "{task.completed:,.0f} of {task.total:,.0f} cases", "{task.fields[rate]:.3g} /s") as update:
        yield lambda done, n: update(done, n)


@contextmanager
def _bar(what: str, count: str, rate: str) -> Generator[Callable[[float, float], None]]:
    import time

    from rich.console import Console
    from rich.progress import BarColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    began = time.perf_counter()
    console = Console(stderr=True)
    columns = (TextColumn(count), BarColumn(), TextColumn(rate), TimeRemainingColumn())
    bar: Any = Bar(*columns, console=console, transient=True)
    task = bar.add_task("", total=1.0, rate=0.0)
    shown = False

    def update(now: float, total: float) -> None:
        nonlocal shown
        spent = time.perf_counter() - began
        if not shown and spent > PATIENCE and console.is_terminal:
            before.close()  # one line at a time
            bar.start()
            shown = True
        if shown:
            bar.update(task, completed=now, total=total, rate=now / spent)

    with ExitStack() as before:
        before.enter_context(busy(what))
        try:
            yield update
        finally:
            if shown:
                bar.stop()
