"""The command line. Exit codes: 0 answered, 1 could not answer (and said why), 2 bad input."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

app = typer.Typer(
    name="freebody",
    help="Rigid-body mechanics that shows its work and proves it.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

ModelFile = Annotated[Path, typer.Argument(metavar="FILE", help="A model file (YAML).")]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON document.")]


def _print_json(document: Any) -> None:
    print(json.dumps(document, indent=2, ensure_ascii=False))


@app.command()
def solve(
    file: ModelFile,
    as_json: Json = False,
    question: Annotated[
        str | None, typer.Option("--find", help="Answer this question instead of those in the file.")
    ] = None,
) -> None:
    """Answer the questions of a model in closed form."""
    from freebody.study.solve import solve as solve_system
    from freebody.system.system import System

    solution = solve_system(System.load(file), question)
    if as_json:
        _print_json(solution.to_plain())
    else:
        from freebody.present.terminal import solution_lines

        print("\n".join(solution_lines(solution)))
    if not solution.is_complete:
        raise typer.Exit(1)


@app.command()
def eom(
    file: ModelFile,
    as_json: Json = False,
    latex: Annotated[bool, typer.Option("--latex", help="Print LaTeX.")] = False,
) -> None:
    """Derive the equations of motion, the mass matrix and the constraint equations."""
    from freebody.study.eom import equations_of_motion
    from freebody.system.system import System

    equations = equations_of_motion(System.load(file))
    if as_json:
        _print_json(equations.to_plain())
    elif latex:
        print(equations.to_latex())
    else:
        from freebody.present.terminal import equation_lines

        print("\n".join(equation_lines(equations)))


@app.command()
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
    for path in copy_examples(None if everything else name, to):
        print(f"wrote {path}")


@app.command()
def new(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The model file to write.")],
) -> None:
    """Write a small model to start from."""
    from freebody.examples_folder import write_new

    write_new(file)
    print(f"wrote {file}. Try: freebody solve {file}")


@app.command()
def schema() -> None:
    """Print the JSON Schema of model files, for editors."""
    from freebody.system.schema import json_schema

    _print_json(json_schema())


def _version(value: bool) -> None:
    if value:
        from importlib.metadata import version

        print(f"freebody {version('freebody')}")
        raise typer.Exit


@app.callback()
def _main(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    pass


def main() -> None:
    """Entry point: errors become messages and exit codes."""
    from freebody.errors import FreebodyError, InputError

    try:
        app()
    except InputError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
    except FreebodyError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
    except BrokenPipeError:
        sys.exit(0)
    except Exception as error:  # a defect: said in one line, since the user cannot mend it
        print(f"freebody failed: {type(error).__name__}: {error}. Please report the model", file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()
