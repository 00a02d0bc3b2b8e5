"""The command line. Exit codes: 0 answered, 1 could not answer (and said why), 2 bad input or a file that cannot be
written, 70 a defect of freebody, 130 and 143 interrupted (Ctrl-C, SIGTERM)."""

from __future__ import annotations

import functools
import json
import math
import os
import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn, ParamSpec

import typer

if TYPE_CHECKING:
    from freebody.study.simulate import Simulation
    from freebody.system.system import System

app = typer.Typer(
    name="freebody",
    help="Rigid-body mechanics that shows its work and proves it.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

ModelFile = Annotated[Path, typer.Argument(metavar="FILE", help="A model file (YAML).")]


def _raise_effort(factor: float) -> float:
    from freebody.budgets import raise_effort

    raise_effort(factor)
    return factor


Effort = Annotated[
    float,
    typer.Option(
        "--effort", callback=_raise_effort, help="Searches may do so many times the ordinary work before giving up."
    ),
]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON document.")]


P = ParamSpec("P")
DEBUG = "FREEBODY_DEBUG"  # set it to see the traceback of a defect


class _Terminated(KeyboardInterrupt):
    """SIGTERM or SIGHUP: what Ctrl-C keeps is kept as well."""


def _command(function: Callable[P, None]) -> Callable[P, None]:
    """A command whose errors become a message and an exit code."""

    @functools.wraps(function)
    def command(*arguments: P.args, **options: P.kwargs) -> None:
        from freebody.errors import FreebodyError, InputError

        try:
            function(*arguments, **options)
            _flush()
        except InputError as error:
            _end(str(error), 2)
        except FreebodyError as error:
            _end(str(error), 1)
        except BrokenPipeError:
            _quiet()
            raise typer.Exit(0) from None
        except _Terminated:
            _end("terminated", 143)
        except KeyboardInterrupt:
            _end("interrupted", 130)
        except MemoryError:
            _end("there is not enough memory for this", 1)
        except (typer.Exit, typer.Abort):
            raise
        except Exception as error:
            _defect(error)

    app.command()(command)
    return command


def _flush() -> None:
    """Writes out what was printed: a full disk is told here, not when the interpreter ends."""
    from freebody.errors import InputError

    if sys.stdout is None:  # pyright: ignore[reportUnnecessaryComparison] - closed by whoever started the program
        return
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        _quiet()
        raise InputError(f"the output cannot be written: {error.strerror}") from error


def _quiet() -> None:
    """Nobody reads the output any more, so the interpreter need not try to write it when it ends."""
    with open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)


def _end(message: str, code: int) -> NoReturn:
    _say(message)
    raise typer.Exit(code) from None


def _say(message: str) -> None:
    if sys.stderr is not None:  # pyright: ignore[reportUnnecessaryComparison]
        from freebody.language.plain_text import plain_lines

        print(plain_lines(message), file=sys.stderr)


def _defect(error: Exception) -> NoReturn:
    """What no user can mend is said in one line, with the place in the program."""
    import traceback

    if isinstance(error, OSError) and sys.exc_info()[2] is not None and _is_of_output(error):
        _quiet()
        _end(f"the output cannot be written: {error.strerror}", 2)
    if os.environ.get(DEBUG):
        _say(traceback.format_exc())
    place = traceback.extract_tb(error.__traceback__)[-1]
    what = " ".join(f"{type(error).__name__}: {error}".split())
    _end(
        f"freebody failed at {Path(place.filename).name}:{place.lineno} ({what[:200]}). This is a defect of freebody: "
        f"please report it with the model file; {DEBUG}=1 shows more",
        70,
    )


def _is_of_output(error: OSError) -> bool:
    """Did printing fail? Files that are written are told of by name elsewhere."""
    import errno

    return error.filename is None and error.errno in (errno.ENOSPC, errno.EFBIG, errno.EIO, errno.EBADF, errno.EDQUOT)


def _print_written(paths: Sequence[Path]) -> None:
    from freebody.language.plain_text import plain

    for path in paths:
        print(f"wrote {plain(str(path))}")


def _print_json(document: Any) -> None:
    """One document of plain JSON: what is no finite number is null."""
    print(json.dumps(_finite(document), indent=2, ensure_ascii=False, allow_nan=False))


def _finite(document: Any) -> Any:
    if isinstance(document, dict):
        return {str(key): _finite(value) for key, value in document.items()}  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
    if isinstance(document, list | tuple):
        return [_finite(value) for value in document]  # pyright: ignore[reportUnknownVariableType]
    if hasattr(document, "tolist"):  # numbers and arrays of NumPy
        return _finite(document.tolist())
    if isinstance(document, float) and not math.isfinite(document):
        return None
    return document


@_command
def solve(
    file: ModelFile,
    as_json: Json = False,
    question: Annotated[
        str | None, typer.Option("--find", help="Answer this question instead of those in the file.")
    ] = None,
    effort: Effort = 1.0,
    is_full: Annotated[bool, typer.Option("--full", help="Show formulas in full, however long they are.")] = False,
) -> None:
    """Answer the questions of a model in closed form."""
    from freebody.present.busy import busy

    with busy("reading the model"):
        from freebody.study.solve import solve as solve_system
        from freebody.system.system import System

        system = System.load(file)
        _load_engine()
        solution = solve_system(system, question)
    if as_json:
        _print_json(solution.to_plain())
    else:
        from freebody.present.terminal import solution_lines

        print("\n".join(solution_lines(solution, is_full=is_full)))
    if not solution.is_complete:
        raise typer.Exit(1)


def _load_engine() -> None:
    """What checks every answer, before any of the time that a check may take is counted."""
    from importlib import import_module

    import_module("freebody.study.witness")


@_command
def explain(
    file: ModelFile,
    out: Annotated[
        Path | None,
        typer.Option("-o", "--out", help="Write a report: .html, .md, .tex, .pdf, .ipynb or .txt."),
    ] = None,
    question: Annotated[
        str | None, typer.Option("--find", help="Only this question: its id in the file, or one in words.")
    ] = None,
    method: Annotated[str, typer.Option("--method", help="auto, newton, lagrange or energy.")] = "auto",
    compare: Annotated[
        str | None, typer.Option("--compare", metavar="METHOD", help="A second method beside the first.")
    ] = None,
    language: Annotated[str, typer.Option("--language", help="en or de.")] = "en",
    effort: Effort = 1.0,
) -> None:
    """Derive the answers step by step, with pictures."""
    from freebody.present.busy import busy
    from freebody.present.report.write import check_report_path

    if out is not None:
        check_report_path(out)
    with busy("reading the model"):
        from freebody.narrative.explain import explain as explain_system
        from freebody.system.system import System

        system = System.load(file)
        _load_engine()
        found = explain_system(system, question, method=method, compare=compare, language=language)
        text = found.to_text() if out is None else ""
        written = [] if out is None else found.write(out)
    if out is None:
        print(text)
    _print_written(written)
    if not found.is_complete:
        raise typer.Exit(1)


@_command
def sheet(
    files: Annotated[list[Path], typer.Argument(metavar="FILE...", help="Model files with questions.")],
    out: Annotated[Path, typer.Option("-o", "--out", help="Write it: .html, .md, .tex, .pdf, .ipynb or .txt.")],
    solutions: Annotated[str, typer.Option("--solutions", help="none, end or inline.")] = "none",
    variants: Annotated[int, typer.Option("--variants", help="How many sheets, each with numbers of its own.")] = 1,
    seed: Annotated[int, typer.Option("--seed", help="The same seed gives the same sheets.")] = 0,
    language: Annotated[str, typer.Option("--language", help="en or de.")] = "en",
    effort: Effort = 1.0,
) -> None:
    """Write an exercise sheet of several models, with an answer key."""
    from freebody.present.busy import busy
    from freebody.present.report.write import check_report_path

    check_report_path(out)
    with busy("reading the models"):
        from freebody.narrative.sheets.sheet import load_systems
        from freebody.narrative.sheets.sheet import sheet as make

        made = make(load_systems(files), solutions=solutions, variants=variants, seed=seed, language=language)
        written = made.write(out)
    _print_written(written)


@_command
def eom(
    file: ModelFile,
    as_json: Json = False,
    latex: Annotated[bool, typer.Option("--latex", help="Print LaTeX.")] = False,
) -> None:
    """Derive the equations of motion, the mass matrix and the constraint equations."""
    from freebody.present.busy import busy

    with busy("deriving the equations of motion"):
        from freebody.study.eom import equations_of_motion
        from freebody.system.system import System

        equations = equations_of_motion(System.load(file))
        formulas = equations.to_latex() if latex else ""
    if as_json:
        _print_json(equations.to_plain())
    elif latex:
        print(formulas)
    else:
        from freebody.present.terminal import equation_lines

        print("\n".join(equation_lines(equations)))


@_command
def simulate(
    file: ModelFile,
    until: Annotated[str, typer.Option("--until", help="How long, as 10 or 200 ms.")],
    out: Annotated[Path | None, typer.Option("--out", help="Write the motion: .nc, .csv or .parquet.")] = None,
    plot: Annotated[Path | None, typer.Option("--plot", help="Draw measures: .png, .svg or .pdf.")] = None,
    show: Annotated[
        list[str] | None, typer.Option("--show", help="What to draw: a measure, crank.x, rope.tension (repeatable).")
    ] = None,
    animate: Annotated[Path | None, typer.Option("--animate", help="Write an animation: .html, .gif or .mp4.")] = None,
    event: Annotated[
        list[str] | None,
        typer.Option("--event", help="Look for 'theta = 90 deg', or 'stop when y of ball = 0' (repeatable)."),
    ] = None,
    set_: Annotated[
        list[str] | None, typer.Option("--set", help="Another value of a parameter, as 'm1=2 kg' (repeatable).")
    ] = None,
    tolerance: Annotated[
        float, typer.Option("--tolerance", help="Error allowed in a step, by the system's size.")
    ] = 1e-9,
    method: Annotated[str, typer.Option("--method", help="auto, dop853, dopri5, radau5 or rk4.")] = "auto",
    step: Annotated[str | None, typer.Option("--step", help="The step of a fixed-step method, as 1 ms.")] = None,
    every: Annotated[str | None, typer.Option("--every", help="Distance of output times, as 10 ms.")] = None,
    max_step: Annotated[str | None, typer.Option("--max-step", help="No step is longer, as 0.01 or 10 ms.")] = None,
    max_steps: Annotated[
        int, typer.Option("--max-steps", help="Stop after so many steps: at the same place on every computer.")
    ] = 10_000_000,
    max_seconds: Annotated[
        float, typer.Option("--max-seconds", help="Stop after so long by the clock, compiling not counted.")
    ] = 3600.0,
    verify: Annotated[bool, typer.Option("--verify", help="Run again, more exactly, and compare.")] = False,
    impact: Annotated[str, typer.Option("--impact", help="Law of impact: newton, poisson or keller.")] = "newton",
    jams: Annotated[
        bool, typer.Option("--jams", help="Where no contact force is consistent, go on with an impulse.")
    ] = False,
    as_json: Json = False,
) -> None:
    """Simulate the motion of a model."""
    from freebody.present.busy import busy
    from freebody.present.simulation import progress_bar, simulation_lines

    with busy("reading the model"):
        from freebody.study.simulate import simulate as run
        from freebody.system.system import System

        system = System.load(file)
        if set_:
            system = system.with_parameters(**dict(_assignment(text) for text in set_))
        _check_outputs(out, plot, animate)
        if show:
            _check_shown(system, show)
        seconds = _seconds(until, "--until")
    with progress_bar(seconds) as progress:
        result = run(
            system,
            seconds,
            tolerance=tolerance,
            method=method,
            step=None if step is None else _seconds(step, "--step"),
            events=event or (),
            every=None if every is None else _seconds(every, "--every"),
            max_step=None if max_step is None else _seconds(max_step, "--max-step"),
            max_steps=max_steps,
            max_seconds=max_seconds,
            progress=progress,
            verify=verify,
            impact=impact,
            jams=jams,
        )
    with busy("evaluating the motion"):
        summary = result.summary()
        lines = [] if as_json else list(simulation_lines(result))
    if as_json:
        _print_json(summary)
    else:
        print("\n".join(lines), flush=True)
    with busy("writing"):
        written = _written(result, out, plot, show or [], animate)
    if not as_json:
        _print_written(written)
    if not result.status.is_complete:
        raise typer.Exit(1)


def _written(
    result: Simulation, out: Path | None, plot: Path | None, show: list[str], animate: Path | None
) -> list[Path]:
    """The files of a simulation."""
    from freebody.progress import busy_with

    written: list[Path] = []
    if out is not None:
        from freebody.study.files import write

        busy_with(f"writing {out}")
        write(result.dataset, out)
        written.append(out)
    if plot is not None:
        busy_with(f"drawing {plot}")
        result.plot(*show, path=plot)
        written.append(plot)
    if animate is not None:
        busy_with(f"drawing {animate}")
        written.append(result.animate(animate))
    return written


def _check_outputs(out: Path | None, plot: Path | None, animate: Path | None) -> None:
    """Paths that cannot be written are told before the run, not after."""
    if out is not None:
        from freebody.study.files import SUFFIXES, check_path

        check_path(out, SUFFIXES)
    if plot is not None:
        from freebody.study.files import check_path

        check_path(plot, (".png", ".svg", ".pdf"))
    if animate is not None:
        from freebody.study.files import check_path

        check_path(animate, (".html", ".gif", ".mp4"))


def _check_shown(system: System, show: list[str]) -> None:
    """Curves that there will not be are told before the run."""
    from freebody.errors import InputError
    from freebody.model.names import did_you_mean
    from freebody.study.dataset import series_names

    known = series_names(system)
    bodies = [body.name for body in system.moving]
    for name in show:
        if name not in known and name.partition(".")[0] not in bodies and not name.startswith("body_"):
            nearest = did_you_mean(name, known)
            if "Did you mean" not in nearest:
                nearest = f" There is: {', '.join(known)}, and crank.x for a body crank."
            raise InputError(f"--show {name}: there is no such curve.{nearest}")


def _assignment(text: str) -> tuple[str, str]:
    from freebody.errors import InputError

    name, equals, value = text.partition("=")
    if not equals or not name.strip() or not value.strip():
        raise InputError(f"--set {text}: write name=value, as 'm1=2 kg'")
    return name.strip(), value.strip()


def _seconds(text: str, option: str) -> float:
    """A time: a number of seconds, or a number with a unit."""
    from freebody.errors import InputError
    from freebody.language.units import TIME, parse_quantity

    try:
        return float(text)
    except ValueError:
        pass
    try:
        quantity = parse_quantity(text)
    except InputError as error:
        raise InputError(f"{option} {text}: {error}") from error
    if quantity.dimension != TIME:
        raise InputError(f"{option} {text} is no time; write 10 or 200 ms")
    return float(quantity.value)


@_command
def draw(
    file: ModelFile,
    out: Annotated[
        Path, typer.Option("-o", "--out", help="The picture to write: .svg, .png, .pdf, or .tex with a tikzpicture.")
    ],
    free_body: Annotated[
        list[str] | None,
        typer.Option(
            "--free-body",
            metavar="BODY",
            help="Cut this body free, with all that acts on it; several for a part of the system.",
        ),
    ] = None,
    at: Annotated[str | None, typer.Option("--at", help="In motion at this time, as 2.5 or 200 ms.")] = None,
    show: Annotated[
        list[str] | None,
        typer.Option("--show", help="velocity, acceleration, force, instant-centres (repeatable, or with commas)."),
    ] = None,
    view: Annotated[
        str, typer.Option("--view", help="In space: azimuth and elevation from which one looks, in degrees.")
    ] = "30,20",
    perspective: Annotated[bool, typer.Option("--perspective", help="In space: far things are smaller.")] = False,
    dark: Annotated[bool, typer.Option("--dark", help="For a dark page.")] = False,
) -> None:
    """Draw a model at its start or in motion, or bodies of it cut free."""
    from freebody.errors import InputError
    from freebody.present.busy import busy

    try:
        azimuth, elevation = map(float, view.split(","))
    except ValueError:
        raise InputError(f"--view {view}: give azimuth and elevation in degrees, e.g. --view 30,20") from None
    with busy("drawing"):
        from freebody.study.picture import draw as draw_system
        from freebody.system.system import System

        written = draw_system(
            System.load(file),
            out,
            at=None if at is None else _seconds(at, "--at"),
            show=_listed(show),
            free=_listed(free_body),
            view=(azimuth, elevation),
            perspective=perspective,
            dark=dark,
        )
    _print_written([written])


def _listed(texts: list[str] | None) -> list[str]:
    """Words that were given one by one, or with commas between them."""
    return [word.strip() for text in texts or () for word in text.split(",") if word.strip()]


@_command
def equilibrium(
    file: ModelFile,
    as_json: Json = False,
    guess: Annotated[
        list[str] | None,
        typer.Option("--guess", metavar="NAME=VALUE", help="Search from here; 'theta=20 deg, x=0.1 m'. Repeatable."),
    ] = None,
    effort: Effort = 1.0,
) -> None:
    """Find the equilibria of a model, their stability and the reactions."""
    from freebody.present.busy import busy

    with busy("searching for equilibria"):
        from freebody.study.equilibrium import equilibria
        from freebody.study.given import guess_of
        from freebody.system.system import System

        found = equilibria(System.load(file), [guess_of(text) for text in guess or ()])
    if as_json:
        _print_json(found.to_plain())
    else:
        from freebody.present.statics import equilibrium_lines

        print("\n".join(equilibrium_lines(found)))


@_command
def modes(
    file: ModelFile,
    as_json: Json = False,
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
    with busy("finding natural frequencies"):
        from freebody.study.given import guess_of
        from freebody.study.modes import modes as modes_of
        from freebody.system.system import System

        found = modes_of(System.load(file), at, None if guess is None else guess_of(guess))
    if as_json:
        _print_json(found.to_plain())
    else:
        from freebody.present.statics import mode_lines

        print("\n".join(mode_lines(found)))


@_command
def statics(file: ModelFile, as_json: Json = False, effort: Effort = 1.0) -> None:
    """Tell whether a model with contacts and dry friction stays at rest, its reactions, and what fails first."""
    from freebody.present.busy import busy

    with busy("finding what holds the system at rest"):
        from freebody.study.friction.report import statics as study
        from freebody.system.system import System

        found = study(System.load(file))
    if as_json:
        _print_json(found.to_plain())
    else:
        from freebody.present.friction_statics import statics_lines

        print("\n".join(statics_lines(found)))


@_command
def mobility(
    file: ModelFile,
    as_json: Json = False,
    along: Annotated[
        str | None,
        typer.Option("--along", metavar="NAME", help="Follow the motion along a driver or measure to its limits."),
    ] = None,
    modes: Annotated[bool, typer.Option("--modes", help="List assembly modes, however many bodies.")] = False,
    effort: Effort = 1.0,
) -> None:
    """Count degrees of freedom, name redundant constraints, singular poses and limits."""
    from freebody.present.busy import busy

    with busy("counting degrees of freedom"):
        from freebody.study.mobility import mobility as examine
        from freebody.system.system import System

        found = examine(System.load(file), along, modes=modes)
    if as_json:
        _print_json(found.to_plain())
    else:
        from freebody.present.mobility import mobility_lines

        print("\n".join(mobility_lines(found)))


@_command
def conserved(
    file: ModelFile,
    as_json: Json = False,
    question: Annotated[
        str | None,
        typer.Option("--find", help="Judge this quantity, as 'angular momentum of body about roller'."),
    ] = None,
    effort: Effort = 1.0,
) -> None:
    """Tell what is conserved, and under which conditions; without a question in the file, search."""
    from freebody.present.busy import busy

    with busy("searching for what is conserved" if question is None else "judging what is conserved"):
        from freebody.study.conserved import conserved as judge
        from freebody.system.system import System

        system = System.load(file)
        _load_engine()
        found = judge(system, question)
    if as_json:
        _print_json(found.to_plain())
    else:
        from freebody.present.conservation import conservation_lines

        print("\n".join(conservation_lines(found)))
    if not found.is_complete:
        raise typer.Exit(1)


@_command
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
    _print_written(copy_examples(None if everything else name, to))


@_command
def new(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The model file to write.")],
) -> None:
    """Write a small model to start from."""
    from freebody.examples_folder import write_new

    write_new(file)
    print(f"wrote {file}. Try: freebody solve {file}")


@_command
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
    """Entry point."""
    for name in ("SIGTERM", "SIGHUP"):
        sign = getattr(signal, name, None)
        if sign is not None and signal.getsignal(sign) == signal.SIG_DFL:
            signal.signal(sign, _terminate)
    from freebody.errors import FreebodyError, InputError

    try:
        app()
    except FreebodyError as error:  # of an option, before its command begins
        _say(str(error))
        sys.exit(2 if isinstance(error, InputError) else 1)
    finally:
        # help and version are printed by the library
        try:
            if sys.stdout is not None:  # pyright: ignore[reportUnnecessaryComparison]
                sys.stdout.flush()
        except OSError:
            _quiet()


def _terminate(_signal: int, _frame: object) -> None:
    raise _Terminated


if __name__ == "__main__":
    main()
