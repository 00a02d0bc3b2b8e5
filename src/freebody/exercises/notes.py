"""What those who answer are told about typing formulas."""

from __future__ import annotations

from freebody.exercises.typed import Typing
from freebody.language.parser import parse
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Block, Emphasis, Formula, Paragraph, Text


def typing_note(typing: Typing, language: str) -> tuple[Block, ...]:
    """How formulas are typed, and each symbol."""
    pairs: list[Text] = [
        (Formula((parse(ours),)), " ", Emphasis(theirs, "code")) for ours, theirs in typing.theirs.items()
    ]
    between = [piece for k, pair in enumerate(pairs) for piece in ((", ", *pair) if k else pair)]
    catalogue = Catalogue(language)
    exact = (catalogue.word("exercise.exact"), " ") if typing.language.is_exact else ()
    return (
        Paragraph((catalogue.word("exercise.typed"), " ", *exact, catalogue.word("exercise.symbols"), " ", *between)),
    )
