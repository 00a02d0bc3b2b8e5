"""Exercise sheets."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from freebody.cli.options import Effort, Language
from freebody.cli.output import check_out, print_written


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
