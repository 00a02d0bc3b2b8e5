"""The command line. Exit codes: 0 answered, 1 could not answer (and said why), 2 bad input or a file that cannot be
written, 70 a defect of freebody, 130 and 143 interrupted (Ctrl-C, SIGTERM)."""

from __future__ import annotations

import difflib
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
_HELP = "help"
_MEANT = {  # what people call the commands
    **dict.fromkeys(("run", "integrate", "move"), "simulate"),
    **dict.fromkeys(("plot", "graph", "chart"), "simulate FILE --plot"),
    **dict.fromkeys(("animate", "animation", "video", "movie"), "simulate FILE --animate"),
    **dict.fromkeys(("show", "view", "picture", "figure"), "draw"),
    **dict.fromkeys(("init", "create", "template", "templates", "start"), "new"),
    **dict.fromkeys(("list", "demo", "demos", "gallery"), "examples"),
    **dict.fromkeys(("equations", "equation", "derive_equations", "motion"), "eom"),
    **dict.fromkeys(("answer", "ask", "find", "calculate", "compute"), "solve"),
    **dict.fromkeys(("derive", "why", "show_work", "steps"), "explain"),
    **dict.fromkeys(("frequencies", "eigenfrequencies", "vibration", "linearise", "linearize"), "modes"),
    **dict.fromkeys(("dof", "constraints"), "mobility"),
    **dict.fromkeys(("balance", "rest"), "equilibrium"),
    **dict.fromkeys(("gui", "edit", "editor", "app"), "studio"),
    "version": "--version",
}


class _Commands(TyperGroup):
    """The commands; a model file in the place of one is solved, and `help COMMAND` is `COMMAND --help`."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        if args[0] == _HELP and not Path(_HELP).is_file():
            if len(args) == 1:
                print(ctx.get_help())
                raise typer.Exit
            args = [args[1], "--help"]
        if args[0] not in self.commands and (Path(args[0]).suffix or Path(args[0]).is_file()):
            args = ["solve", *args]
        if args[0] not in self.commands and not args[0].startswith("-"):
            ctx.fail(self._no_command(args[0]))
        return super().resolve_command(ctx, args)

    def _no_command(self, word: str) -> str:
        """What to write for a command that there is not."""
        from freebody.examples_folder import listed_examples

        begun = [name for name in self.commands if len(word) > 1 and name.startswith(word)]
        near = difflib.get_close_matches(word, self.commands, n=1, cutoff=0.7)
        if (meant := next(iter((*begun, *near)), _MEANT.get(word.lower()))) is not None:
            return f"No such command '{word}'. Did you mean '{meant}'?"
        if word in [name for name, _title in listed_examples()]:
            return f"No such command '{word}'. It is an example: 'freebody examples {word}' writes it here."
        return f"No such command '{word}'. 'freebody help' lists the commands."


def commands() -> typer.Typer:
    """The program: every study that the table has a command for, in its order, and what belongs to model files."""
    app = typer.Typer(
        name="freebody",
        cls=_Commands,
        help="Rigid-body mechanics that shows its work and proves it. freebody FILE answers the questions of FILE.",
        no_args_is_help=True,
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
        context_settings={"help_option_names": ["--help", "-h"]},
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
