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


def model_of(
    file: Path,
    assignments: list[str] | None,
    language: object = None,
    asked: tuple[str, ...] = (),
    *,
    is_asked_here: bool = False,
) -> System:
    """The system of a file, with other values of parameters; what is unlikely in it is told on stderr. asked: what is
    said of it on the command line; is_asked_here: whether its questions are among that."""
    system = loaded(file, is_asked_here=is_asked_here)
    if assignments:
        system = system.with_parameters(**dict(assignment(text) for text in assignments))
    tell_warnings(system, language, asked)
    return system


def loaded(file: Path, *, is_asked_here: bool) -> System:
    """The system of a file. Where the questions stand on the command line, those of the file that cannot be read are no
    hindrance: they are told on stderr, and left out."""
    from freebody.cli.running import say
    from freebody.errors import ModelError
    from freebody.language.document import Document
    from freebody.system.system import System

    document = Document.load(file)
    try:
        return System.from_document(document)
    except ModelError as error:
        if not is_asked_here or not all(problem.path[:1] == ("questions",) for problem in error.problems):
            raise
        bad = {problem.path[1] for problem in error.problems if len(problem.path) > 1}
        asked = document.data["questions"]
        if isinstance(asked, dict):
            by_name = cast("dict[str, Any]", asked)
            left: Any = {name: one for name, one in by_name.items() if name not in bad}
        else:
            left = [one for k, one in enumerate(cast("list[Any]", asked)) if k not in bad]
        system = System.from_document(document.with_value(("questions",), left))
        for line in str(error).splitlines():
            say(f"warning: {line}")
        return system


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
