"""Model files: examples, a new one, their schema."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.cli.output import print_json, print_written


def _templates() -> list[str]:
    from freebody.examples_folder import templates

    return list(templates())


def _examples() -> list[str]:
    from freebody.examples_folder import listed_examples

    return [name for name, _title in listed_examples()]


def examples(
    name: Annotated[str | None, typer.Argument(help="An example to copy.", autocompletion=_examples)] = None,
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
    file: Annotated[Path | None, typer.Argument(metavar="FILE", help="The model file to write.")] = None,
    like: Annotated[
        str | None,
        typer.Option("--like", help="A template, such as ladder; or an example.", autocompletion=_templates),
    ] = None,
) -> None:
    """Write a model to start from; without a file, list the templates."""
    from freebody.examples_folder import listed_templates, write_new

    if file is None:
        for name, title in listed_templates():
            print(f"{name:<20} {title}")
        print("\nWrite one with: freebody new model.yaml --like NAME")
        return
    print_written(write_new(file, like))
    print(f"wrote {file}. Try: freebody solve {file}")


def schema() -> None:
    """Print the JSON Schema of model files, for editors."""
    from freebody.system.schema import json_schema

    print_json(json_schema())
