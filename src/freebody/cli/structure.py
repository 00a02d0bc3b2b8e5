"""What a mechanism can do, and what stays as it is."""

from __future__ import annotations

from typing import Annotated

import typer

from freebody.cli.options import Effort, Json, ModelFile, ReportFile, load_engine
from freebody.cli.output import check_out, print_result


def mobility(
    file: ModelFile,
    as_json: Json = False,
    out: ReportFile = None,
    along: Annotated[
        str | None,
        typer.Option("--along", metavar="NAME", help="Follow the motion along a driver or measure to its limits."),
    ] = None,
    modes: Annotated[bool, typer.Option("--modes", help="List assembly modes, however many bodies.")] = False,
    effort: Effort = 1.0,
) -> None:
    """Count degrees of freedom, name redundant constraints, singular poses and limits."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("counting degrees of freedom"):
        from freebody.study.mobility.mobility import mobility as examine
        from freebody.system.system import System

        found = examine(System.load(file), along, modes=modes)
    print_result(found, as_json, out)


def conserved(
    file: ModelFile,
    as_json: Json = False,
    out: ReportFile = None,
    question: Annotated[
        str | None,
        typer.Option("--find", help="Judge this quantity, as 'angular momentum of body about roller'."),
    ] = None,
    effort: Effort = 1.0,
) -> None:
    """Tell what is conserved, and under which conditions; without a question in the file, search."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("searching for what is conserved" if question is None else "judging what is conserved"):
        from freebody.study.conservation.conserved import conserved as judge
        from freebody.system.system import System

        system = System.load(file)
        load_engine()
        found = judge(system, question)
    print_result(found, as_json, out)
    if not found.is_complete:
        raise typer.Exit(1)
