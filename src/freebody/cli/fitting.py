"""Models fitted to measurements."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from freebody.cli.options import Json, Language, ModelFile, ReportFile, Set, model_of
from freebody.cli.output import check_out, print_result, print_written
from freebody.numeric.engine.integrators import integrators  # their names alone

if TYPE_CHECKING:
    from freebody.study.fitting.result import Fit


def fit(
    file: ModelFile,
    data: Annotated[
        list[Path], typer.Argument(metavar="DATA...", help="Measurements, a .csv for each run: t [s], x [mm], ...")
    ],
    free: Annotated[
        list[str],
        typer.Option("--free", help="Parameters, start values, offset(x), with commas; they begin as in the file."),
    ],
    out: ReportFile = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Draw what is left over: .svg, .png, .pdf, .tex.")] = None,
    show: Annotated[str, typer.Option("--show", help="The series that is drawn; else the first.")] = "",
    tolerance: Annotated[float, typer.Option("--tolerance", help="Error allowed in a step of the motions.")] = 1e-11,
    method: Annotated[str, typer.Option("--method", help=f"auto or {', '.join(integrators())}.")] = "auto",
    language: Language = "en",
    as_json: Json = False,
    set_: Set = None,
) -> None:
    """Fit parameters and start values to measured motions, with their errors."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("fitting"):
        from freebody.present.files import check_writable
        from freebody.present.picture.picture import checked_path
        from freebody.studies import STUDIES

        if plot is not None:
            check_writable(checked_path(plot))
        system = model_of(file, set_, language)
        names = [part for part in map(str.strip, ",".join(free).split(",")) if part]
        run: Callable[..., Fit] = STUDIES["fit"].function
        found = run(system, data, names, tolerance=tolerance, method=method, language=language)
    print_result(found, system, as_json=as_json, out=out)
    if plot is not None:
        found.chart(show).write(plot)
        if not as_json:
            print_written([plot])
    if not found.is_complete:
        raise typer.Exit(1)
