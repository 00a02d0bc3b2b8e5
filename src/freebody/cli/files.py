"""Model files: examples, a new one, their schema."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.cli.output import print_json, print_written


def examples(
    name: Annotated[str | None, typer.Argument(help="An example to copy.")] = None,
    to: Annotated[Path, typer.Option("--to", help="Where to copy it.")] = Path(),
    everything: Annotated[bool, typer.Option("--all", help="Copy all of them.")] = False,
) -> None:
    """List the bundled examples, or copy one (or all) of them."""
    from freebody.examples_folder import copy_examples, listed_examples

    if name is None and not everything:
        for example, title in listed_examples():
            print(f"{example:<34} {title}")
        print("\nCopy one with: freebody examples NAME")
        return
    print_written(copy_examples(None if everything else name, to))


def new(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The model file to write.")],
) -> None:
    """Write a small model to start from."""
    from freebody.examples_folder import write_new

    write_new(file)
    print(f"wrote {file}. Try: freebody solve {file}")


def schema() -> None:
    """Print the JSON Schema of model files, for editors."""
    from freebody.system.schema import json_schema

    print_json(json_schema())
