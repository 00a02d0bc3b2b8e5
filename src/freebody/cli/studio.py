"""The studio: a model in the browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.cli.options import Language, seconds_of


def studio(
    file: Annotated[
        Path | None, typer.Argument(metavar="[FILE]", help="A model file, which may be new; or a folder of them.")
    ] = None,
    port: Annotated[int, typer.Option("--port", help="On this port; 0 for any that is free.", min=0, max=65535)] = 0,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Only print the address.")] = False,
    export: Annotated[
        Path | None,
        typer.Option("--export", help="Write the page with all its answers as one file (.html), and serve nothing."),
    ] = None,
    until: Annotated[str, typer.Option("--until", help="How long the motion of an exported page lasts.")] = "3 s",
    vary: Annotated[
        list[str] | None,
        typer.Option(
            "--vary",
            metavar="NAME=RANGE",
            help="A slider of an exported page, for a parameter or start value: 'L=0.5..2 m:9' (repeatable).",
        ),
    ] = None,
    language: Language = "en",
) -> None:
    """Build, ask and watch a model in the browser."""
    from freebody.errors import InputError
    from freebody.messages import Message
    from freebody.studio.launch import export as exported
    from freebody.studio.launch import launch

    if export is None:
        launch(file, port, opens_browser=not no_browser)
        return
    if file is None or export.suffix.lower() != ".html":
        raise InputError(Message("write: freebody studio model.yaml --export page.html"))
    from freebody.cli.output import print_written
    from freebody.present.busy import busy

    with busy("answering everything"):
        written = exported(file, export, seconds_of(until, "--until"), language, vary or [])
    print_written([written])
