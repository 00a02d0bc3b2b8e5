"""Linkages to a task."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.cli.options import Json, Language
from freebody.cli.output import print_result, print_written


def synthesise(
    file: Annotated[Path, typer.Argument(metavar="TASKFILE", help="A task: motion, path or function (YAML).")],
    out: Annotated[
        Path | None, typer.Option("-o", "--out", metavar="DIR", help="Write each certified candidate as a model file.")
    ] = None,
    report: Annotated[Path | None, typer.Option("--report", help="Write a report: .html, .md, .tex, .pdf ...")] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Draw a candidate: .svg, .png, .pdf or .tex.")] = None,
    curves: Annotated[
        Path | None,
        typer.Option("--curves", help="Draw Burmester's curves of four positions: .svg, .png ..."),
    ] = None,
    show: Annotated[int, typer.Option("--show", help="Which candidate is drawn.")] = 1,
    most: Annotated[int, typer.Option("--most", help="How many candidates are followed all round.")] = 10,
    as_json: Json = False,
    language: Language = "en",
) -> None:
    """Find linkages for given positions, points of a path or pairs of a function, and say what is wrong with them."""
    from freebody.present.busy import busy

    with busy("searching for linkages"):
        from freebody.narrative.synthesised import synthesise as run
        from freebody.present.files import check_writable
        from freebody.present.picture.picture import checked_path
        from freebody.present.report.write import check_report_path

        for path in (plot, curves):
            if path is not None:
                check_writable(checked_path(path))
        if report is not None:
            check_report_path(report)
        found = run(file, most=most, out=out, language=language)
    print_result(found, None, as_json=as_json, out=report)
    drawn = [] if plot is None else [found.picture(show).write(plot)]
    drawn += [] if curves is None else [found.curves(show).write(curves)]
    if not as_json:
        print_written([*found.files, *drawn])
    if not found.is_complete:
        raise typer.Exit(1)
