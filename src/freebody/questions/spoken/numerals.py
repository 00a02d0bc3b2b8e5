"""Numbers that are said in words before a unit: half a second, two and a half metres, a quarter of a second."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from freebody.questions.spoken.lexicon import numerals, unit_words

_RATES = r"(?! (?:per|a|an|each)\b)"  # metres per second keep their words


def in_digits(text: str, language: str) -> str:
    """A text in which such numbers are digits before the unit; those that count other things stay words."""
    if not numerals(language, "counts"):
        return text
    return _pattern(language).sub(lambda found: _written(found, language), text)


def _written(found: re.Match[str], language: str) -> str:
    """A number and its unit: a whole one with a part, a part alone, or one where neither is said."""
    counts, parts = numerals(language, "counts"), numerals(language, "parts")
    said = {key: (found[key] or "").lower() for key in ("whole", "added", "part")}
    whole = float(said["whole"]) if said["whole"].isdigit() else counts.get(said["whole"], 0.0)
    value = whole + parts.get(said["added"], 0.0) + parts.get(said["part"], 0.0)
    return f"{value or 1.0:g} {unit_words(language)[found['unit'].lower()]}"


@cache
def _pattern(language: str) -> re.Pattern[str]:
    counts, parts = (_one_of(numerals(language, key)) for key in ("counts", "parts"))
    units = _one_of(word for word, unit in unit_words(language).items() if unit.isalpha() and word.islower())
    one = r"(?:an? )"
    number = (
        rf"(?:(?P<whole>{counts}|\d+(?= and ))(?: and {one}?(?P<added>{parts}))?"
        rf"|{one}?(?P<part>{parts})(?: of)?(?: an?| one)?"
        rf"|(?<=after )an?|(?<=within )an?|(?<=moved )an?|(?<=fallen )an?|(?<=risen )an?|(?<=travelled )an?)"
    )
    return re.compile(rf"\b{number} (?:(?:full|complete|whole) )?(?P<unit>{units})\b{_RATES}", re.IGNORECASE)


def _one_of(words: Iterable[str]) -> str:
    return "|".join(sorted(words, key=len, reverse=True))
