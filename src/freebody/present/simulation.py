"""A simulation's summary for the terminal, and its progress."""

from __future__ import annotations

from collections.abc import Generator, Iterator
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Any

from freebody.present.busy import busy

if TYPE_CHECKING:
    from freebody.study.simulation.measured import MeasuredMotion
    from freebody.study.simulation.simulator import Progress

N_FIRST, N_LAST = 12, 5  # events that are listed, if there are more
N_LISTED = 8  # contacts; more are counted
PATIENCE = 0.5  # seconds before a bar appears


def simulation_lines(result: MeasuredMotion) -> Iterator[str]:
    """Status, cost, violations, energy balance, events and final values."""
    course, summary = result.course, result.summary()
    yield result.system.title or "simulation"
    for text in result.simulator.assumptions:
        yield f"  assumed       {text}"
    yield f"  status        {result.status}" + (f": {result.message}" if result.message else "")
    yield (
        f"  time          {result.t_end:.6g} s in {course.n_steps} steps, {course.n_evaluations} evaluations, "
        f"{course.wall_time:.3g} s computing time ({course.method}, tolerance {result.tolerance:g})"
    )
    yield (
        f"  constraints   at most {summary['max_position_violation']:.1e} m and "
        f"{summary['max_velocity_violation']:.1e} m/s violated"
    )
    yield (
        f"  energy        energy balance error: {summary['energy_error']:.1e} J "
        f"(relative {summary['energy_error_relative']:.1e})"
    )
    non_unique = [r.name for k, r in enumerate(result.rows) if not course.unique[:, k].all()]
    if non_unique:
        yield f"  not unique    {', '.join(non_unique)}: connections hold the same thing more than once"
    if course.contact is not None:
        yield from _contact_lines(result, summary, non_unique)
    if result.trusted_until is not None:
        is_all = result.trusted_until >= result.t_end
        yield (
            "  trust         to the end"
            if is_all
            else f"  trust         two tolerances diverge at {result.trusted_until:.4g} s"
        )
    if result.events:
        yield "  events"
        n, events = len(result.events), result.events
        left_out = range(N_FIRST, n - N_LAST) if n > N_FIRST + N_LAST + 1 else range(0)
        for k, event in enumerate(events):
            if k not in left_out:
                yield f"    {event.time:<14.9g} s  {event.name} ({event.kind})"
            elif k == left_out[0]:
                yield f"    ... {len(left_out)} more"
    final = summary["final"]["measures"]
    if final:
        from freebody.language.units import unit_of

        yield f"  at {result.t_end:.6g} s"
        for name, value in final.items():
            yield f"    {name:<12} = {value:.9g} {unit_of(result.system.measures[name].dimension)}"


def _contact_lines(result: MeasuredMotion, summary: dict[str, Any], non_unique: list[str]) -> Iterator[str]:
    """States at the end, and between which bounds reactions lie that are not unique there."""
    states: dict[str, str] = {name: state for name, state in summary["contacts"].items() if state != "open"}
    n_open = len(summary["contacts"]) - len(states)
    listed = [f"{name} {state}" for name, state in list(states.items())[:N_LISTED]]
    if len(states) > N_LISTED:
        listed.append(f"{len(states) - N_LISTED} more")
    if n_open:
        listed.append(f"{n_open} open")
    if listed:
        n = summary["phases"]
        yield f"  contact       {n} phase{'' if n == 1 else 's'}; at the end {', '.join(listed)}"
    if non_unique and result.status.is_complete and len(non_unique) <= N_LISTED:
        ranges = result.reaction_ranges()
        for name in non_unique:
            if name in ranges:
                low, high = ranges[name]
                yield f"                {name} between {low:.6g} and {high:.6g} N"


@contextmanager
def progress_bar(until: float) -> Generator[Progress]:
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
