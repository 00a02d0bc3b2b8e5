"""Options and arguments that several commands have, and how they are read."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, cast

import typer

from freebody.messages import Message
from freebody.narrative.words import languages
from freebody.studies import SECONDS, Option

if TYPE_CHECKING:
    from freebody.system.system import System

ModelFile = Annotated[Path, typer.Argument(metavar="FILE", help="A model file (YAML).")]
ReportFile = Annotated[
    Path | None, typer.Option("-o", "--out", help="Write a report: .html, .md, .tex, .pdf, .ipynb or .txt.")
]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON document.")]
Language = Annotated[str, typer.Option("--language", help=f"{' or '.join(reversed(languages()))}.")]


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


def assignment(text: str) -> tuple[str, str]:
    from freebody.errors import InputError

    name, equals, value = text.partition("=")
    if not equals or not name.strip() or not value.strip():
        raise InputError(f"--set {text}: write name=value, as 'm1=2 kg'")
    return name.strip(), value.strip()


Set = Annotated[
    list[str] | None, typer.Option("--set", help="Another value of a parameter, as 'm1=2 kg' (repeatable).")
]
Watch = Annotated[bool, typer.Option("--watch", help="Run again whenever the file is saved, until Ctrl-C.")]


def model_of(file: Path, assignments: list[str] | None, language: object = None, asked: tuple[str, ...] = ()) -> System:
    """The system of a file for what answers no questions of the file; see `model_and_unread`."""
    return model_and_unread(file, assignments, language, asked, answers_file=False)[0]


def model_and_unread(
    file: Path,
    assignments: list[str] | None,
    language: object = None,
    asked: tuple[str, ...] = (),
    *,
    answers_file: bool,
) -> tuple[System, bool]:
    """The system of a file, with other values of parameters, and whether the file has questions that cannot be read.
    These and what is unlikely in it are told on stderr; the others are answered. asked: what is said of it on the
    command line; answers_file: whether the questions of the file are to be answered."""
    system, is_unread = _loaded(file, language, answers_file=answers_file)
    if assignments:
        system = system.with_parameters(**dict(assignment(text) for text in assignments))
    tell_warnings(system, language, asked)
    return system, is_unread


def _loaded(file: Path, language: object, *, answers_file: bool) -> tuple[System, bool]:
    """Raises ModelError where more than questions cannot be read, or where none is left of those to be answered."""
    from freebody.cli.running import in_language, say
    from freebody.errors import ModelError
    from freebody.language.document import Document
    from freebody.system.system import System

    document = Document.load(file)
    try:
        return System.from_document(document), False
    except ModelError as error:
        if not all(problem.path[:1] == ("questions",) for problem in error.problems):
            raise
        bad = {problem.path[1] for problem in error.problems if len(problem.path) > 1}
        asked = document.data["questions"]
        left: Any = []
        if isinstance(asked, dict):
            left = {name: one for name, one in cast("dict[str, Any]", asked).items() if name not in bad}
        elif isinstance(asked, list):
            left = [one for k, one in enumerate(cast("list[Any]", asked)) if k not in bad]
        if answers_file and not left:
            raise
        system = System.from_document(document.with_value(("questions",), left))
        told: str = error.args[0] if answers_file else Message("warning: {text}", text=error.args[0])
        say(in_language(told, language))
        return system, True


def tell_warnings(system: System, language: object = None, asked: tuple[str, ...] = ()) -> None:
    from freebody.cli.running import in_language, say
    from freebody.study.model_warnings import warnings_of

    for warning in warnings_of(system, asked):
        told = Message("warning: {text}", text=warning.text(system.file))
        say(in_language(told, language))


def said(*words: Any) -> tuple[str, ...]:
    """The texts among what stands behind the options of a command, once or several times."""
    lists: list[list[Any]] = [word if isinstance(word, list) else [word] for word in words]
    return tuple(one for words in lists for one in words if isinstance(one, str))


def seconds_of(text: str, option: str) -> float:
    """A time: a number of seconds, or a number with a unit."""
    return Option("", (option,), "", read=SECONDS).given(text)
