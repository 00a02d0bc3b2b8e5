"""Exercise sheets."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from freebody.cli.options import Effort, Language, Set, assignment, tell_warnings
from freebody.cli.output import check_out, print_written

if TYPE_CHECKING:
    from freebody.system.system import System


def sheet(
    files: Annotated[list[Path], typer.Argument(metavar="FILE...", help="Model files with questions.")],
    out: Annotated[
        Path | None, typer.Option("-o", "--out", help="Write it: .html, .md, .tex, .pdf, .ipynb or .txt.")
    ] = None,
    solutions: Annotated[str, typer.Option("--solutions", help="none, end or inline.")] = "none",
    variants: Annotated[int, typer.Option("--variants", help="How many sheets, each with numbers of its own.")] = 1,
    seed: Annotated[int, typer.Option("--seed", help="The same seed gives the same sheets.")] = 0,
    room: Annotated[
        float | None,
        typer.Option("--room", help="Centimetres to write in under a question on paper; 3 without solutions."),
    ] = None,
    numeric: Annotated[
        bool, typer.Option("--numeric", help="Show options as the numbers that their formulas give.")
    ] = False,
    propose_options: Annotated[
        bool, typer.Option("--propose-options", help="Check the options, and propose some that mistakes lead to.")
    ] = False,
    language: Language = "en",
    effort: Effort = 1.0,
    set_: Set = None,
) -> None:
    """Write an exercise sheet of several models, with an answer key."""
    from freebody.errors import InputError
    from freebody.language.sentences import Message
    from freebody.present.busy import busy

    if propose_options and out is not None:
        raise InputError(
            Message("--propose-options prints options for the model files and writes no sheet: give it or -o")
        )
    if propose_options:
        _propose(files, set_, language)
        return
    if out is None:
        raise InputError(Message("where is the sheet to be written? Give -o sheet.html, or --propose-options"))
    check_out(out)
    with busy("reading the models"):
        from freebody.narrative.sheets.sheet import load_systems
        from freebody.narrative.sheets.sheet import sheet as make

        systems = with_assignments(load_systems(files), set_)
        for system in systems:
            tell_warnings(system, language)
        made = make(
            systems, solutions=solutions, variants=variants, seed=seed, language=language, room=room, numeric=numeric
        )
        written = made.write(out)
    print_written(written)


def _propose(files: list[Path], set_: list[str] | None, language: str) -> None:
    """Prints for every question what is wrong with its options, and options as a model file has them."""
    from freebody.language.plain_text import plain
    from freebody.narrative.marking.authoring import authors_check
    from freebody.narrative.sheets.sheet import load_systems
    from freebody.narrative.telling.catalogue import Catalogue

    catalogue = Catalogue(language)
    for system in with_assignments(load_systems(files), set_):
        print(plain(system.title))
        for question in system.questions:
            found = authors_check(system, question)
            print(f"  {plain(question.id)}: {plain(question.text)}")
            for fault in found.faults:
                print(f"    ! {catalogue.said(fault)}")
            if found.right and not question.options:
                print(f"    a: {found.right}   # {catalogue.word('quiz.right')}")
            for k, option in enumerate(found.proposed):
                print(f"    {chr(ord('b') + k)}: {option.text}   # {catalogue.plain(option.said)}")


def with_assignments(systems: list[System], texts: list[str] | None) -> list[System]:
    """Systems with other values of those parameters that they have. Raises InputError for one that none of them has."""
    from freebody.errors import InputError
    from freebody.language.sentences import Message
    from freebody.model.noting import did_you_mean

    values = dict(assignment(text) for text in texts or ())
    known = {name for system in systems for name in system.parameters}
    for name in values:
        if name not in known:
            told = Message(
                "no model of the sheet has a parameter {name}.{hint}", name=name, hint=did_you_mean(name, known)
            )
            raise InputError(told)
    return [
        system.with_parameters(**{name: x for name, x in values.items() if name in system.parameters})
        for system in systems
    ]
