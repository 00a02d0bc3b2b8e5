"""The studio: a model in the browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def studio(
    file: Annotated[
        Path | None, typer.Argument(metavar="[FILE]", help="A model file, which may be new; or a folder of them.")
    ] = None,
    port: Annotated[int, typer.Option("--port", help="On this port; 0 for any that is free.", min=0, max=65535)] = 0,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Only print the address.")] = False,
) -> None:
    """Build, ask and watch a model in the browser."""
    from freebody.studio.launch import launch

    launch(file, port, opens_browser=not no_browser)
