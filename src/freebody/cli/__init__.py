"""The command line. Exit codes: 0 answered, 1 could not answer (and said why), 2 bad input or a file that cannot be
written, 70 a defect of freebody, 130 and 143 interrupted (Ctrl-C, SIGTERM)."""

from __future__ import annotations

import gc
import signal
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from freebody.cli.doctor import doctor
from freebody.cli.export import export
from freebody.cli.files import examples, new, schema
from freebody.cli.fitting import fit
from freebody.cli.motion import simulate
from freebody.cli.optimising import optimise
from freebody.cli.quiz import quiz
from freebody.cli.running import Terminated, command, quiet, say
from freebody.cli.sheets import sheet
from freebody.cli.studies import command_of
from freebody.cli.studio import studio
from freebody.cli.sweeps import sweep
from freebody.cli.synthesis import synthesise
from freebody.studies import STUDIES

# commands with outputs of their own, and those that are no study of a system
_OWN: dict[str, Callable[..., None]] = {"simulate": simulate, "sweep": sweep, "fit": fit, "optimise": optimise}
_BESIDE: tuple[Callable[..., None], ...] = (synthesise, sheet, export, quiz, studio, examples, new, schema, doctor)


class _Commands(TyperGroup):
    """The commands; a model file in the place of one is solved."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        if args[0] not in self.commands and (Path(args[0]).suffix or Path(args[0]).is_file()):
            args = ["solve", *args]
        return super().resolve_command(ctx, args)


def commands() -> typer.Typer:
    """The program: every study that the table has a command for, in its order, and what belongs to model files."""
    app = typer.Typer(
        name="freebody",
        cls=_Commands,
        help="Rigid-body mechanics that shows its work and proves it. freebody FILE answers the questions of FILE.",
        no_args_is_help=True,
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
    )
    app.callback()(_main)
    offered = [_OWN.get(study.name) or command_of(study) for study in STUDIES.values() if study.command]
    for function in (*offered, *_BESIDE):
        app.command()(command(function))
    return app


def _version(value: bool) -> None:
    if value:
        from importlib.metadata import version

        print(f"freebody {version('freebody')}")
        raise typer.Exit


def _main(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    pass


def main() -> None:
    """Entry point."""
    gc.set_threshold(50_000, 20, 100)  # a command makes millions of small objects, few of them in circles
    for name in ("SIGTERM", "SIGHUP"):
        sign = getattr(signal, name, None)
        if sign is not None and signal.getsignal(sign) == signal.SIG_DFL:
            signal.signal(sign, _terminate)
    from freebody.errors import FreebodyError, InputError

    try:
        commands()()
    except FreebodyError as error:  # of an option, before its command begins
        say(str(error))
        sys.exit(2 if isinstance(error, InputError) else 1)
    finally:
        # help and version are printed by the library
        try:
            if sys.stdout is not None:
                sys.stdout.flush()
        except OSError:
            quiet()


def _terminate(_signal: int, _frame: object) -> None:
    raise Terminated
