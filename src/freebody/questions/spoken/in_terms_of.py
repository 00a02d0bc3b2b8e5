"""In terms of what an answer is wanted: a measure, as a function of which it is asked, or what is given anyway.

What is given (a function of m and L, of the angle) says nothing of its own and is passed over by the rules of each
language; a name that the model has not would be passed over with it, and the answer be another one than was meant.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.model.noting import did_you_mean
from freebody.questions.clock import TIME_SINCE
from freebody.questions.spoken.lexicon import contexts, languages
from freebody.questions.spoken.naming import elements_of
from freebody.questions.spoken.suggesting import not_understood

if TYPE_CHECKING:
    from freebody.model.names import Names

_LONGEST_SYMBOL = 6  # letters of a name that is no word: thetta


def as_function(names: Names, text: str) -> tuple[str, str] | None:
    """What is asked as a function of something in the words of a language, and of what; the time is t."""
    if (over := _said_by(text, "over_measure")) is not None and over["of"] in names.measures:
        return over["what"], over["of"]
    if (found := _in_terms_of(text)) is None:
        what = _over_time(text)
        return None if what is None else (what, TIME_SINCE)
    is_time = found["of"] not in names.measures and any(
        re.fullmatch(contexts(language)["time"], found["of"], re.IGNORECASE) for language in languages()
    )
    return found["what"], TIME_SINCE if is_time else found["of"]


def joined(what: str) -> list[str]:
    """Several quantities that are asked as functions of one thing."""
    each = (re.split(contexts(language)["joined"], what) for language in languages())
    return next((parts for parts in each if len(parts) > 1), [])


def greatest_of(what: str) -> Iterator[str]:
    """The same quantity at its greatest, in the words of each language."""
    return (contexts(language)["greatest_of"].replace("{what}", what) for language in languages())


def misspelt(names: Names, text: str) -> Message | None:
    """What is said of a text that asks for a function of one thing that neither the model nor a language has."""
    found = _in_terms_of(text)
    if found is None or not not_understood(names.parameters, elements_of(names), of := found["of"]):
        return None
    known = {*names.measures, *names.states, *names.parameters}
    if len(of) > _LONGEST_SYMBOL and not difflib.get_close_matches(of, known):
        return None  # a word that nothing is known of: the usual readings tell it
    hint = did_you_mean(of, known)
    return Message("{name} is not a measure: nothing can be told as a function of it.{hint}", name=of, hint=hint)


def _over_time(text: str) -> str | None:
    """What is asked at the time t, or as it changes with the time: y(t)."""
    each = (re.fullmatch(contexts(language)["over_time"], text, re.IGNORECASE) for language in languages())
    found = next((found for found in each if found is not None), None)
    return None if found is None else next(what for what in found.groups() if what is not None)


def _in_terms_of(text: str) -> re.Match[str] | None:
    return _said_by(text, "as_function")


def _said_by(text: str, pattern: str) -> re.Match[str] | None:
    each = (re.fullmatch(contexts(language)[pattern], text, re.IGNORECASE) for language in languages())
    return next((found for found in each if found is not None), None)
