"""The commands of the table of studies: each reads a model, runs its study, and prints or writes what was found."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from inspect import Parameter, Signature
from typing import TYPE_CHECKING, Annotated, Any

import typer

from freebody.cli.options import Effort, Json, ModelFile, ReportFile, Set, Watch, model_and_unread, said
from freebody.cli.output import check_out, print_result, print_written
from freebody.studies import Option, Study

if TYPE_CHECKING:
    from freebody.system.system import System


class FormulaLength(StrEnum):
    """How much of a formula is shown that nobody reads at a glance."""

    SHORT = "short"
    LONG = "long"


Full = Annotated[bool, typer.Option("--full", help="Show formulas in full, however long they are.")]
Formulas = Annotated[
    FormulaLength,
    typer.Option("--formula", help="short: very long formulas by their size, the number first; long: as with --full."),
]
Latex = Annotated[bool, typer.Option("--latex", help="Print LaTeX.")]


def command_of(study: Study) -> Callable[..., None]:
    """The command of a study; one that writes its own file reports nothing besides."""
    is_file = any(option.parameter == "path" for option in study.options)
    own = [_parameter(option) for option in study.options]
    report = [_of("as_json", Json, False), _of("out", ReportFile, None), _of("latex", Latex, False)]
    full = [_of("is_full", Full, False), _of("formula", Formulas, FormulaLength.SHORT)] if study.is_short else []
    common = [_of("set_", Set, None), _of("watch", Watch, False)]
    parameters = [*own, *common] if is_file else [*report, *own, *full, _of("effort", Effort, 1.0), *common]

    def run(file: Any, **words: Any) -> None:
        if is_file:
            written, _system, _is_unread = _found(study, file, words)
            print_written([written])
        else:
            _report(study, file, words)

    run.__name__, run.__doc__ = study.command, study.help
    signature = Signature([_of("file", ModelFile, Parameter.empty), *parameters])
    run.__annotations__ = {name: each.annotation for name, each in signature.parameters.items()}
    setattr(run, "__signature__", signature)  # noqa: B010 - what typer reads
    return run


def _of(name: str, annotation: Any, default: Any) -> Parameter:
    return Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


def _parameter(option: Option) -> Parameter:
    given: Any = typer.Option(*option.flags, help=option.help, metavar=option.metavar)
    if option.default is ...:
        return _of(option.parameter, Annotated[option.kind, given], Parameter.empty)
    kind = option.kind | None if option.default is None else option.kind
    return _of(option.parameter, Annotated[kind, given], option.default)


def _found(study: Study, file: Any, words: dict[str, Any]) -> tuple[Any, System, bool]:
    """What a study finds in the model of a file, of the words on the command line that are its own; the model; and
    whether a question of the file that it should answer cannot be read."""
    from freebody.present.busy import busy

    with busy(study.busy):
        given = {option.parameter: option.given(words[option.parameter]) for option in study.options}
        finds = [option.parameter for option in study.options if "--find" in option.flags]
        answers_file = bool(finds) and not any(words[name] for name in finds)
        system, is_unread = model_and_unread(
            file, words["set_"], words.get("language"), _said(study, words), answers_file=answers_file
        )
        found = study.function(system, **{name: x for name, x in given.items() if x is not None})
        return found, system, is_unread and answers_file


def _said(study: Study, words: dict[str, Any]) -> tuple[str, ...]:
    """What is said of the model behind the options of its own that a study has."""
    return said(*(words[option.parameter] for option in study.options))


def _report(study: Study, file: Any, words: dict[str, Any]) -> None:
    check_out(words["out"])
    found, system, is_unread = _found(study, file, words)
    print_result(
        found,
        system,
        as_json=words["as_json"],
        as_latex=words["latex"],
        out=words["out"],
        is_short=study.is_short and not words["is_full"] and words["formula"] is not FormulaLength.LONG,
        asked=_said(study, words),
    )
    if is_unread:
        raise typer.Exit(2)
    if not found.is_complete:
        raise typer.Exit(1)
