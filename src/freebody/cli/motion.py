"""Motions in time."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from freebody.cli.options import Json, Language, ModelFile, Set, Watch, model_of, said, seconds_of
from freebody.cli.output import print_result, print_written
from freebody.numeric.engine.integrators import integrators  # their names alone

if TYPE_CHECKING:
    from freebody.study.simulation.simulate import Simulation
    from freebody.system.system import System


def simulate(
    file: ModelFile,
    until: Annotated[str, typer.Option("--until", help="How long, as 10 or 200 ms.")],
    out: Annotated[Path | None, typer.Option("--out", help="Write the motion: .nc, .csv or .parquet.")] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Draw measures: .png, .svg or .pdf.")] = None,
    show: Annotated[
        list[str] | None, typer.Option("--show", help="What to draw: a measure, crank.x, rope.tension (repeatable).")
    ] = None,
    animate: Annotated[Path | None, typer.Option("--animate", help="Write an animation: .html, .gif or .mp4.")] = None,
    event: Annotated[
        list[str] | None,
        typer.Option("--event", help="Look for 'theta = 90 deg', or 'stop when y of ball = 0' (repeatable)."),
    ] = None,
    set_: Set = None,
    tolerance: Annotated[
        float, typer.Option("--tolerance", help="Error allowed in a step, by the system's size.")
    ] = 1e-9,
    method: Annotated[str, typer.Option("--method", help=f"auto, {', '.join(integrators())} or moreau.")] = "auto",
    step: Annotated[str | None, typer.Option("--step", help="The step of a fixed-step method, as 1 ms.")] = None,
    every: Annotated[str | None, typer.Option("--every", help="Distance of output times, as 10 ms.")] = None,
    max_step: Annotated[str | None, typer.Option("--max-step", help="No step is longer, as 0.01 or 10 ms.")] = None,
    max_steps: Annotated[
        int, typer.Option("--max-steps", help="Stop after so many steps: at the same place on every computer.")
    ] = 10_000_000,
    max_seconds: Annotated[
        float, typer.Option("--max-seconds", help="Stop after so long by the clock, compiling not counted.")
    ] = 3600.0,
    verify: Annotated[bool, typer.Option("--verify", help="Run again, more exactly, and compare.")] = False,
    impact: Annotated[str, typer.Option("--impact", help="Law of impact: newton, poisson or keller.")] = "newton",
    jams: Annotated[
        bool, typer.Option("--jams", help="Where no contact force is consistent, go on with an impulse.")
    ] = False,
    language: Language = "en",
    as_json: Json = False,
    watch: Watch = False,
) -> None:
    """Simulate the motion of a model."""
    from freebody.present.busy import busy
    from freebody.present.progress_bar import progress_bar

    asked = said(show, event)
    with busy("reading the model"):
        from freebody.numeric.options import SimulationOptions
        from freebody.studies import STUDIES

        run: Callable[..., Simulation] = STUDIES["simulate"].function
        system = model_of(file, set_, language, asked)
        _check_outputs(out, plot, animate)
        if show:
            _check_shown(system, show)
        seconds = seconds_of(until, "--until")
        options = SimulationOptions(
            tolerance=tolerance,
            method=method,
            step=None if step is None else seconds_of(step, "--step"),
            every=None if every is None else seconds_of(every, "--every"),
            max_step=None if max_step is None else seconds_of(max_step, "--max-step"),
            max_steps=max_steps,
            max_seconds=max_seconds,
            verify=verify,
            impact=impact,
            jams=jams,
        )
    with progress_bar(seconds) as progress:
        result = run(system, seconds, options=options, events=event or (), progress=progress, language=language)
    with busy("evaluating the motion"):
        result.summary()  # what it takes is computed here, not while it is printed
    print_result(result, system, as_json=as_json, asked=asked)
    with busy("writing"):
        written = _written(result, out, plot, show or [], animate)
    if not as_json:
        print_written(written)
    if not result.is_complete:
        raise typer.Exit(1)


def _written(
    result: Simulation, out: Path | None, plot: Path | None, show: list[str], animate: Path | None
) -> list[Path]:
    """The files of a simulation."""
    from freebody.progress import busy_with

    written: list[Path] = []
    if out is not None:
        from freebody.study.simulation.files import write

        busy_with(f"writing {out}")
        write(result.recording, out)
        written.append(out)
    if plot is not None:
        busy_with(f"drawing {plot}")
        result.plot(*show, path=plot)
        written.append(plot)
    if animate is not None:
        busy_with(f"drawing {animate}")
        written.append(result.animate(animate))
    return written


def _check_outputs(out: Path | None, plot: Path | None, animate: Path | None) -> None:
    """Paths that cannot be written are told before the run, not after."""
    if out is not None:
        from freebody.study.simulation.files import SUFFIXES, check_path

        check_path(out, SUFFIXES)
    if plot is not None:
        from freebody.study.simulation.files import check_path

        check_path(plot, (".png", ".svg", ".pdf"))
    if animate is not None:
        from freebody.study.simulation.files import check_path

        check_path(animate, (".html", ".gif", ".mp4"))


def _check_shown(system: System, show: list[str]) -> None:
    """Curves that there will not be are told before the run."""
    from freebody.errors import InputError
    from freebody.model.noting import did_you_mean
    from freebody.study.simulation.recorded import series_names

    known = series_names(system)
    bodies = [body.name for body in system.moving]
    for name in show:
        if name not in known and name.partition(".")[0] not in bodies and not name.startswith("body_"):
            nearest = did_you_mean(name, known)
            if "Did you mean" not in nearest:
                nearest = f" There is: {', '.join(known)}, and crank.x for a body crank."
            raise InputError(f"--show {name}: there is no such curve.{nearest}")
