"""Questions and their derivations."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.cli.options import Effort, Json, Language, ModelFile, ReportFile, load_engine
from freebody.cli.output import check_out, print_result, print_written


def solve(
    file: ModelFile,
    as_json: Json = False,
    out: ReportFile = None,
    question: Annotated[
        str | None, typer.Option("--find", help="Answer this question instead of those in the file.")
    ] = None,
    effort: Effort = 1.0,
    is_full: Annotated[bool, typer.Option("--full", help="Show formulas in full, however long they are.")] = False,
) -> None:
    """Answer the questions of a model in closed form."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("reading the model"):
        from freebody.study.answering.solve import solve as solve_system
        from freebody.system.system import System

        system = System.load(file)
        load_engine()
        solution = solve_system(system, question)
    print_result(solution, as_json, out, is_short=not is_full)
    if not solution.is_complete:
        raise typer.Exit(1)


def explain(
    file: ModelFile,
    out: ReportFile = None,
    question: Annotated[
        str | None, typer.Option("--find", help="Only this question: its id in the file, or one in words.")
    ] = None,
    method: Annotated[str, typer.Option("--method", help="auto, newton, lagrange or energy.")] = "auto",
    compare: Annotated[
        str | None, typer.Option("--compare", metavar="METHOD", help="A second method beside the first.")
    ] = None,
    language: Language = "en",
    effort: Effort = 1.0,
) -> None:
    """Derive the answers step by step, with pictures."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("reading the model"):
        from freebody.narrative.explain import explain as explain_system
        from freebody.system.system import System

        system = System.load(file)
        load_engine()
        found = explain_system(system, question, method=method, compare=compare, language=language)
        text = found.to_text() if out is None else ""
        written = [] if out is None else found.write(out)
    if out is None:
        print(text)
    print_written(written)
    if not found.is_complete:
        raise typer.Exit(1)


def sheet(
    files: Annotated[list[Path], typer.Argument(metavar="FILE...", help="Model files with questions.")],
    out: Annotated[Path, typer.Option("-o", "--out", help="Write it: .html, .md, .tex, .pdf, .ipynb or .txt.")],
    solutions: Annotated[str, typer.Option("--solutions", help="none, end or inline.")] = "none",
    variants: Annotated[int, typer.Option("--variants", help="How many sheets, each with numbers of its own.")] = 1,
    seed: Annotated[int, typer.Option("--seed", help="The same seed gives the same sheets.")] = 0,
    language: Language = "en",
    effort: Effort = 1.0,
) -> None:
    """Write an exercise sheet of several models, with an answer key."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("reading the models"):
        from freebody.narrative.sheets.sheet import load_systems
        from freebody.narrative.sheets.sheet import sheet as make

        made = make(load_systems(files), solutions=solutions, variants=variants, seed=seed, language=language)
        written = made.write(out)
    print_written(written)


def eom(
    file: ModelFile,
    as_json: Json = False,
    out: ReportFile = None,
    latex: Annotated[bool, typer.Option("--latex", help="Print LaTeX.")] = False,
) -> None:
    """Derive the equations of motion, the mass matrix and the constraint equations."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("deriving the equations of motion"):
        from freebody.study.eom import equations_of_motion
        from freebody.system.system import System

        equations = equations_of_motion(System.load(file))
        formulas = equations.to_latex() if latex else ""
    if latex and not as_json:
        print(formulas)
    else:
        print_result(equations, as_json, out)
