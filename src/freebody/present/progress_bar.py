"""How far a simulation is, on a terminal."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import ExitStack, contextmanager
from typing import Any

from freebody.present.busy import busy

PATIENCE = 0.5  # seconds before a bar appears


@contextmanager
def progress_bar(until: float) -> Generator[Callable[[float, int], None]]:
    """Shows simulated time and rate on a terminal's error stream if a run takes longer than `PATIENCE`."""
    import time

    from rich.console import Console
    from rich.progress import BarColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    began = time.perf_counter()
    console = Console(stderr=True)
    bar: Any = Bar(
        TextColumn("{task.completed:8.4g} of {task.total:g} s"),
        BarColumn(),
        TextColumn("{task.fields[rate]:.3g} s/s"),
        TimeRemainingColumn(),
        console=console,
        transient=True,
    )
    task = bar.add_task("", total=until, rate=0.0)
    shown = False

    def update(now: float, _steps: int) -> None:
        nonlocal shown
        spent = time.perf_counter() - began
        if not shown and spent > PATIENCE and console.is_terminal:
            before.close()  # one line at a time
            bar.start()
            shown = True
        if shown:
            bar.update(task, completed=now, rate=now / spent)

    with ExitStack() as before:
        before.enter_context(busy("simulating"))
        try:
            yield update
        finally:
            if shown:
                bar.stop()
