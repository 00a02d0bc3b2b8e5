"""The best parameters of a system."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from freebody.cli.options import Effort, Json, Language, ModelFile, Set, model_of, said, seconds_of
from freebody.cli.output import print_result, print_written

if TYPE_CHECKING:
    from freebody.study.optimising.result import Optimum

_List = list[str] | None


def optimise(
    file: ModelFile,
    minimise: Annotated[
        _List,
        typer.Option(
            "--minimise",
            help="A question, 'b + c', 'maximum of Q over theta', or with --until 'final x' (repeatable).",
        ),
    ] = None,
    maximise: Annotated[_List, typer.Option("--maximise", help="The same, as great as possible (repeatable).")] = None,
    subject_to: Annotated[
        _List, typer.Option("--subject-to", metavar="LIMIT", help="A limit, as 'tension < 30 N' (repeatable).")
    ] = None,
    over: Annotated[
        _List, typer.Option("--over", metavar="NAME=RANGE", help="What varies, as 'b=0.1..0.5 m' (repeatable).")
    ] = None,
    until: Annotated[
        str | None, typer.Option("--until", help="How long motions are followed, as 10 or 200 ms.")
    ] = None,
    starts: Annotated[int, typer.Option("--starts", help="Searches by gradients, a power of two.")] = 16,
    generations: Annotated[int, typer.Option("--generations", help="Of an evolution.")] = 150,
    seed: Annotated[int, typer.Option("--seed", help="The same seed draws the same starts.")] = 0,
    method: Annotated[str, typer.Option("--method", help="auto, gradients or evolution.")] = "auto",
    tolerance: Annotated[float, typer.Option("--tolerance", help="Error allowed in a step of a motion.")] = 1e-9,
    out: Annotated[
        list[Path] | None,
        typer.Option("-o", "--out", help="Write .csv, or a report: .html, .md, .tex, .pdf ... (repeatable)."),
    ] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Draw the Pareto front: .svg, .png, .pdf, .tex.")] = None,
    language: Language = "en",
    as_json: Json = False,
    effort: Effort = 1.0,
    set_: Set = None,
) -> None:
    """Find the parameters at which a goal is best, under limits; of several goals the Pareto front."""
    from freebody.present.busy import busy

    asked = said(minimise, maximise, subject_to)
    with busy("optimising"):
        from freebody.numeric.options import SimulationOptions
        from freebody.present.files import check_writable
        from freebody.present.picture.picture import checked_path
        from freebody.studies import STUDIES
        from freebody.study.given import ranges_of

        run: Callable[..., Optimum] = STUDIES["optimise"].function
        system = model_of(file, set_, language, asked)
        if plot is not None:
            check_writable(checked_path(plot))
        found = run(
            system,
            minimise or (),
            maximise=maximise or (),
            subject_to=subject_to or (),
            over=ranges_of(over or ()),
            until=None if until is None else seconds_of(until, "--until"),
            starts=starts,
            generations=generations,
            seed=seed,
            method=method,
            options=SimulationOptions(tolerance=tolerance),
            out=out or (),
            language=language,
        )
    print_result(found, system, as_json=as_json, asked=asked)
    drawn = [] if plot is None else [found.chart().write(plot)]
    if not as_json:
        print_written([*found.files, *drawn])
    if not found.is_complete:
        raise typer.Exit(1)
