"""Questions asked in the terminal."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from freebody.cli.options import Language, Set

if TYPE_CHECKING:
    from freebody.narrative.marking.quiz import QuizQuestion
    from freebody.narrative.telling.catalogue import Catalogue


def quiz(
    files: Annotated[list[Path], typer.Argument(metavar="FILE...", help="Model files with questions.")],
    question: Annotated[list[str] | None, typer.Option("--question", help="Only these ids (repeatable).")] = None,
    attempts: Annotated[int, typer.Option("--attempts", help="How often one may try.")] = 3,
    log: Annotated[Path | None, typer.Option("--log", help="Append every attempt as a line of JSON.")] = None,
    language: Language = "en",
    set_: Set = None,
) -> None:
    """Ask the questions of models in the terminal, with hints and attempts."""
    from freebody.cli.sheets import with_assignments
    from freebody.narrative.marking.quiz import quiz as made
    from freebody.narrative.sheets.sheet import load_systems
    from freebody.narrative.telling.catalogue import Catalogue

    systems = with_assignments(load_systems(files), set_)
    asked = made(systems, question or (), attempts=attempts, language=language)
    catalogue = Catalogue(language)
    print(catalogue.word("quiz.how"))
    n_asked = 0
    for one in asked:
        n_asked += 1
        goes_on = _ask(one, catalogue)
        _write(log, one)
        if not goes_on:
            break
    n_right = sum(one.is_solved for one in asked)
    print(catalogue.word("quiz.score").format(right=n_right, asked=n_asked))
    if n_right < len(asked):
        raise typer.Exit(1)


def _ask(one: QuizQuestion, catalogue: Catalogue) -> bool:
    """Asks one question until it is solved, given up or out of attempts. False at the end of the input."""
    from freebody.present.report.formats.terminal import terminal_text

    print(f"\n{terminal_text(one.report).rstrip()}")
    while not one.is_over:
        try:
            text = input("> ").strip()
        except EOFError:
            print()
            return False
        if text.lower() in ("skip", "weiter"):
            break
        if text in ("?", "hint", "Hinweis"):
            print(one.hint() or catalogue.word("quiz.no_hint"))
        elif text:
            print("\n".join(replace(one.answer(text), is_brief=True).to_text().splitlines()[3:]))
            if not one.is_over:
                print(catalogue.word("quiz.left").format(n=one.n_left))
    if not one.is_solved:
        print(f"\n{terminal_text(one.solution()).rstrip()}")
    return True


def _write(log: Path | None, one: QuizQuestion) -> None:
    """Appends the attempts to the log. Raises InputError where it cannot be written."""
    from freebody.errors import InputError

    if log is None:
        return
    try:
        with log.open("a", encoding="utf-8") as file:
            file.writelines(f"{json.dumps(entry, ensure_ascii=False)}\n" for entry in one.log)
    except OSError as error:
        raise InputError(f"{log} cannot be written: {error.strerror}") from error
