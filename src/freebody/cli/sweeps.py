"""Many cases of one system."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from freebody.cli.options import Effort, Json, Language, ModelFile, Set, model_and_unread, said, seconds_of
from freebody.cli.output import print_result, print_written
from freebody.numeric.engine.integrators import integrators  # their names alone

if TYPE_CHECKING:
    from freebody.study.sweeps.result import Sweep

_List = list[str] | None


def sweep(
    file: ModelFile,
    vary: Annotated[
        _List,
        typer.Option(
            "--vary",
            metavar="NAME=RANGE",
            help="A parameter or start value: 'm1=1..3 kg:50', 'mu=0.1, 0.2', 'm=normal(2 kg, 5 %)' (repeatable).",
        ),
    ] = None,
    over: Annotated[
        _List,
        typer.Option(
            "--over", metavar="NAME=RANGE", help="Gone over in every case, as 'theta=0..360 deg' (repeatable)."
        ),
    ] = None,
    sample: Annotated[
        str | None,
        typer.Option("--sample", help="Which cases: grid, sobol:4096, lhs:500, random:1000, or a table, cases.csv."),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", help="The same seed draws the same cases.")] = 0,
    find: Annotated[
        _List,
        typer.Option(
            "--find", help="A question, by its id in the file or in words (repeatable); else all of the file."
        ),
    ] = None,
    record: Annotated[
        _List,
        typer.Option(
            "--record",
            help="Of the motion: 'final x', 'maximum of rope.tension', 'x at 2 s', 'time when x = 0' (repeatable).",
        ),
    ] = None,
    until: Annotated[
        str | None, typer.Option("--until", help="How long the motion is followed, as 10 or 200 ms.")
    ] = None,
    event: Annotated[
        _List, typer.Option("--event", help="Look for this as well, as 'stop when y of ball = 0' (repeatable).")
    ] = None,
    tolerance: Annotated[float, typer.Option("--tolerance", help="Error allowed in a step of a motion.")] = 1e-9,
    method: Annotated[str, typer.Option("--method", help=f"auto, {', '.join(integrators())} or moreau.")] = "auto",
    step: Annotated[str | None, typer.Option("--step", help="The step of a fixed-step method, as 1 ms.")] = None,
    every: Annotated[str | None, typer.Option("--every", help="Distance of output times, as 10 ms.")] = None,
    max_steps: Annotated[int, typer.Option("--max-steps", help="A motion stops after so many steps.")] = 10_000_000,
    threads: Annotated[
        int | None, typer.Option("--threads", help="For motions, and what has no formula; else as many as processors.")
    ] = None,
    cluster: Annotated[
        str | None,
        typer.Option(
            "--cluster", help="Look at cases by local:8 (processes), tcp://scheduler:8786 (dask) or slurm:job.sh."
        ),
    ] = None,
    device: Annotated[
        str,
        typer.Option(
            "--device",
            help="engine, or cpu or gpu: smooth motions by equations of the model's own, compiled, all together.",
        ),
    ] = "engine",
    block: Annotated[int | None, typer.Option("--block", help="Cases that are in memory at once.")] = None,
    out: Annotated[
        list[Path] | None,
        typer.Option(
            "-o", "--out", help="Write .nc, .zarr, .csv or .parquet, or a report: .html, .md, ... (repeatable)."
        ),
    ] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Draw a result: .svg, .png, .pdf or .tex.")] = None,
    show: Annotated[str, typer.Option("--show", help="Which one is drawn; else the first.")] = "",
    chart: Annotated[str, typer.Option("--chart", help="line, heat, parallel or regions; else what fits.")] = "",
    resume: Annotated[
        bool, typer.Option("--resume", help="Go on with an interrupted sweep into the same file.")
    ] = False,
    language: Language = "en",
    as_json: Json = False,
    effort: Effort = 1.0,
    set_: Set = None,
) -> None:
    """Look at many cases: parameters and start values vary, answers and motions are found in each."""
    from freebody.present.busy import busy
    from freebody.present.progress_bar import count_bar

    asked = said(find, record, event)
    with busy("reading the model"):
        from freebody.numeric.options import SimulationOptions
        from freebody.present.files import check_writable
        from freebody.present.picture.picture import checked_path
        from freebody.studies import STUDIES
        from freebody.study.given import ranges_of

        run: Callable[..., Sweep] = STUDIES["sweep"].function
        system, is_unread = model_and_unread(file, set_, language, asked, answers_file=not find)
        if plot is not None:
            check_writable(checked_path(plot))
        options = SimulationOptions(
            tolerance=tolerance,
            method=method,
            step=None if step is None else seconds_of(step, "--step"),
            every=None if every is None else seconds_of(every, "--every"),
            max_steps=max_steps,
        )
    with count_bar("finding formulas") as progress:
        found = run(
            system,
            ranges_of(vary or ()),
            over=ranges_of(over or ()),
            sample=sample,
            seed=seed,
            find=find or (),
            record=record or (),
            until=None if until is None else seconds_of(until, "--until"),
            events=event or (),
            options=options,
            threads=threads,
            cluster=cluster,
            device=device,
            block=block,
            out=out or (),
            resume=resume,
            progress=progress,
            language=language,
        )
    print_result(found, system, as_json=as_json, asked=asked)
    if not found.is_complete:
        from freebody.cli.running import say

        kept = f" and kept in {found.store.folder}; --resume goes on" if found.store.folder else ""
        say(f"interrupted: {found.n_done:,} of {found.n:,} cases are done{kept}")
        raise typer.Exit(130)
    drawn = [] if plot is None else [found.chart(show, chart).write(plot)]
    if not as_json:
        print_written([*found.files, *drawn])
    if is_unread and not find:
        raise typer.Exit(2)
