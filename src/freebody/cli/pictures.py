"""Pictures."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.cli.options import ModelFile, listed, seconds_of
from freebody.cli.output import print_written


def draw(
    file: ModelFile,
    out: Annotated[
        Path, typer.Option("-o", "--out", help="The picture to write: .svg, .png, .pdf, or .tex with a tikzpicture.")
    ],
    free_body: Annotated[
        list[str] | None,
        typer.Option(
            "--free-body",
            metavar="BODY",
            help="Cut this body free, with all that acts on it; several for a part of the system.",
        ),
    ] = None,
    at: Annotated[str | None, typer.Option("--at", help="In motion at this time, as 2.5 or 200 ms.")] = None,
    show: Annotated[
        list[str] | None,
        typer.Option("--show", help="velocity, acceleration, force, instant-centres (repeatable, or with commas)."),
    ] = None,
    view: Annotated[
        str, typer.Option("--view", help="In space: azimuth and elevation from which one looks, in degrees.")
    ] = "30,20",
    perspective: Annotated[bool, typer.Option("--perspective", help="In space: far things are smaller.")] = False,
    dark: Annotated[bool, typer.Option("--dark", help="For a dark page.")] = False,
) -> None:
    """Draw a model at its start or in motion, or bodies of it cut free."""
    from freebody.errors import InputError
    from freebody.present.busy import busy

    try:
        azimuth, elevation = map(float, view.split(","))
    except ValueError:
        raise InputError(f"--view {view}: give azimuth and elevation in degrees, e.g. --view 30,20") from None
    with busy("drawing"):
        from freebody.study.pictures.picture import draw as draw_system
        from freebody.system.system import System

        written = draw_system(
            System.load(file),
            out,
            at=None if at is None else seconds_of(at, "--at"),
            show=listed(show),
            free=listed(free_body),
            view=(azimuth, elevation),
            perspective=perspective,
            dark=dark,
        )
    print_written([written])
