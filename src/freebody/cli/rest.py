"""Rest, and small motions about it."""

from __future__ import annotations

from typing import Annotated

import typer

from freebody.cli.options import Effort, Json, ModelFile, ReportFile
from freebody.cli.output import check_out, print_result


def equilibrium(
    file: ModelFile,
    as_json: Json = False,
    out: ReportFile = None,
    guess: Annotated[
        list[str] | None,
        typer.Option("--guess", metavar="NAME=VALUE", help="Search from here; 'theta=20 deg, x=0.1 m'. Repeatable."),
    ] = None,
    effort: Effort = 1.0,
) -> None:
    """Find the equilibria of a model, their stability and the reactions."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("searching for equilibria"):
        from freebody.study.given import guess_of
        from freebody.study.small_motion.equilibrium import equilibria
        from freebody.system.system import System

        found = equilibria(System.load(file), [guess_of(text) for text in guess or ()])
    print_result(found, as_json, out)


def modes(
    file: ModelFile,
    as_json: Json = False,
    out: ReportFile = None,
    at: Annotated[str, typer.Option("--at", help="equilibrium (the nearest one), or start.")] = "equilibrium",
    guess: Annotated[
        str | None, typer.Option("--guess", metavar="NAME=VALUE", help="The equilibrium to which this leads.")
    ] = None,
) -> None:
    """Find natural frequencies, damping and mode shapes of small motions."""
    from freebody.errors import InputError
    from freebody.present.busy import busy

    if at not in ("equilibrium", "start"):
        raise InputError(f"--at is equilibrium or start, not {at}")
    check_out(out)
    with busy("finding natural frequencies"):
        from freebody.study.given import guess_of
        from freebody.study.small_motion.modes import modes as modes_of
        from freebody.system.system import System

        found = modes_of(System.load(file), at, None if guess is None else guess_of(guess))
    print_result(found, as_json, out)


def statics(file: ModelFile, as_json: Json = False, out: ReportFile = None, effort: Effort = 1.0) -> None:
    """Tell whether a model with contacts and dry friction stays at rest, its reactions, and what fails first."""
    from freebody.present.busy import busy

    check_out(out)
    with busy("finding what holds the system at rest"):
        from freebody.study.friction.report import statics as study
        from freebody.system.system import System

        found = study(System.load(file))
    print_result(found, as_json, out)
