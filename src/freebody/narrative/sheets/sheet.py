"""Exercise sheets: several models as numbered exercises, with or without solutions, in variants with an answer key."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from freebody.errors import FreebodyError, InputError, ModelError
from freebody.language.sentences import Message, Sentence, lines
from freebody.model.noting import did_you_mean
from freebody.narrative.sheets.answer_key import key_table
from freebody.narrative.sheets.content import SOLUTIONS, SheetContent, Solutions
from freebody.narrative.sheets.sheet_report import SheetWriter
from freebody.narrative.sheets.variants import Variant, as_given, variant_of
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Block, Report, Section
from freebody.progress import busy_with
from freebody.system.system import System

MOST_VARIANTS = 1000
ROOM = 3.0  # [cm]


class Sheet(SheetContent):
    """An exercise sheet that writes itself."""

    def report(self, variant: int = 1) -> Report:
        """The sheet of a variant."""
        return SheetWriter(self, variant).report()

    def key_report(self) -> Report:
        """The answer keys of all variants."""
        catalogue = Catalogue(self.language)
        blocks: list[Block] = []
        for n in range(1, self.variants + 1):
            table = key_table(catalogue, self.key(n))
            title = catalogue.tell(Sentence("sheet.variant", {"n": n}))
            blocks.append(Section(title, (table,)) if self.variants > 1 else table)
        title = catalogue.word("sheet.key_title")
        return Report(
            title,
            catalogue.language,
            catalogue.word("sheet.sheet"),
            tuple(blocks),
            catalogue.report_words,
            decimal=catalogue.decimal,
        )

    def write(self, path: str | Path) -> list[Path]:
        """Writes the sheet as .html, .md, .tex, .pdf, .ipynb or .txt, by the suffix, and the answer key beside it as
        name-key; several variants as name-1, name-2 ... Returns all files written. Raises InputError for another suffix
        or a place that cannot be written, before anything is."""
        from freebody.present.report.write import check_report_path, write_report

        path = Path(path)
        places = [path] if self.variants == 1 else [_beside(path, str(n)) for n in range(1, self.variants + 1)]
        key = _beside(path, "key")
        for place in (*places, key):
            check_report_path(place)
        written: list[Path] = []
        for n, place in enumerate(places, 1):
            busy_with(f"writing {place}")
            written += write_report(self.report(n), place)
        return [*written, *write_report(self.key_report(), key)]


def sheet(
    systems: Iterable[System],
    *,
    solutions: str = "none",
    variants: int = 1,
    seed: int = 0,
    language: str = "en",
    room: float | None = None,
    numeric: bool = False,
) -> Sheet:
    """An exercise sheet of several systems. With one variant and no seed it is as the models have it; else every
    variant has its own numbers and its own order of options, the same for the same seed.

    room: [cm] to write in under a question on paper, by default 3 without solutions; numeric: options that are formulas
    are shown as the numbers that they give in the variant.

    Raises InputError for systems without questions and for unknown words, ModelError where a system cannot be
    assembled, all of them in one message."""
    chosen = _solutions(solutions)
    Catalogue(language)
    systems = tuple(systems)
    if not systems:
        raise InputError(Message("an exercise sheet needs at least one model"))
    if variants < 1:
        raise InputError(Message("there can be no {variants} variants; ask for at least 1", variants=variants))
    if variants > MOST_VARIANTS:
        raise InputError(
            Message(
                "{variants} variants are too many; ask for at most {most}, with another seed for more",
                variants=variants,
                most=MOST_VARIANTS,
            )
        )
    space = (ROOM if chosen == "none" else 0.0) if room is None else room
    if space < 0:
        raise InputError(Message("the room under a question cannot be {room} cm", room=f"{space:g}"))
    given = _solved(systems)
    if variants == 1 and not seed:
        return Sheet(systems, chosen, 1, seed, language, (given,), space, numeric)
    made: list[tuple[Variant, ...]] = []
    for n in range(1, variants + 1):
        busy_with(f"finding numbers for sheet {n} of {variants}")
        made.append(tuple(variant_of(v.system, v.solution, f"{seed}/{n}/{k}") for k, v in enumerate(given)))
    return Sheet(systems, chosen, variants, seed, language, tuple(made), space, numeric)


def load_systems(paths: Iterable[str | Path]) -> list[System]:
    """Reads several model files. Raises InputError with all problems of all files."""
    found: list[System] = []
    problems: list[str] = []
    for path in paths:
        try:
            found.append(System.load(path))
        except InputError as error:
            problems.append(str(error))
    problems += [p for p in (_unasked(s) for s in found) if p]
    if problems:
        raise InputError(lines(problems))
    return found


def _solved(systems: Sequence[System]) -> tuple[Variant, ...]:
    """All systems as their files have them."""
    found: list[Variant] = []
    problems = [p for p in (_unasked(s) for s in systems) if p]
    for system in systems:
        try:
            found.append(as_given(system))
        except ModelError as error:
            problems.append(str(error) if system.file else f"{system.title}: {error}")
        except FreebodyError as error:
            problems.append(f"{system.file or system.title}: {error}")
    if problems:
        raise InputError(lines(problems))
    return tuple(found)


def _unasked(system: System) -> str:
    """What is to be done about a system without questions."""
    if system.questions:
        return ""
    measure = next(iter(system.measures), "")
    what = f"acceleration of {measure}" if measure else "degrees of freedom"
    return f"{system.file or system.title}: an exercise needs a question; add questions: [{{find: {what}}}]"


def _solutions(word: str) -> Solutions:
    for known in SOLUTIONS:
        if word == known:
            return known
    raise InputError(
        Message(
            "solutions can be {solutions}, not {word}.{hint}",
            solutions=", ".join(SOLUTIONS),
            word=word,
            hint=did_you_mean(word, SOLUTIONS),
        )
    )


def _beside(path: Path, what: str) -> Path:
    return path.with_name(f"{path.stem}-{what}{path.suffix}")
