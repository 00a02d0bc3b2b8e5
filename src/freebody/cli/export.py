"""Exercises for learning platforms."""

from __future__ import annotations

from pathlib import Path
from pkgutil import iter_modules
from typing import Annotated

import typer

from freebody.cli.options import Effort, Language, Set, tell_warnings


def _platforms() -> list[str]:
    """Their names alone: those of their files."""
    folder = Path(__file__).parents[1] / "exercises" / "platforms"
    return sorted(module.name.replace("_", "-") for module in iter_modules([str(folder)]))


def export(
    files: Annotated[list[Path], typer.Argument(metavar="FILE...", help="Model files with questions.")],
    to: Annotated[str, typer.Option("--to", help=f"The platform: {', '.join(_platforms())}.")],
    out: Annotated[Path, typer.Option("-o", "--out", help="A new folder for the package.")],
    variants: Annotated[
        int, typer.Option("--variants", help="How many of each question, each with numbers and a figure of its own.")
    ] = 1,
    seed: Annotated[int, typer.Option("--seed", help="The same seed gives the same package.")] = 0,
    tolerance: Annotated[
        str, typer.Option("--tolerance", help="How far numbers may be off: '1 %', '0.05 N' or '3 digits'.")
    ] = "1 %",
    numeric: Annotated[
        bool, typer.Option("--numeric", help="Show options as the numbers that their formulas give.")
    ] = False,
    language: Language = "en",
    effort: Effort = 1.0,
    set_: Set = None,
) -> None:
    """Write the questions of models as a package for a learning platform, which examines itself."""
    from freebody.cli.running import in_language, say
    from freebody.cli.sheets import with_assignments
    from freebody.exercises.export import export as write
    from freebody.exercises.package import check_folder
    from freebody.exercises.platforms import platform_of
    from freebody.narrative.sheets.sheet import load_systems
    from freebody.present.busy import busy

    platform_of(to)
    check_folder(out)
    with busy("reading the models"):
        systems = with_assignments(load_systems(files), set_)
        for system in systems:
            tell_warnings(system, language)
        found = write(
            systems,
            to=to,
            out=out,
            variants=variants,
            seed=seed,
            language=language,
            tolerance=tolerance,
            numeric=numeric,
        )
    for told in found.told:
        say(in_language(told, language))
    print(in_language(_summary(found.names, found.n_tests, out), language))


def _summary(names: tuple[str, ...], n_tests: int, out: Path) -> str:
    from freebody.language.sentences import Message

    return Message(
        "wrote {n} questions to {folder}; {tests} self-tests passed", n=len(names), folder=out, tests=n_tests
    )
