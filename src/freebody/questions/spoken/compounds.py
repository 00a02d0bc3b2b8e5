"""Words of another language put into English: what things are called, and words that are written as one.

`Kolbengeschwindigkeit` is the velocity of the piston, `Anfangsgeschwindigkeit` that at the start, `Kurbelzapfen` the
pin of the crank, and a `Stahlkugel` is a ball. A word is taken apart only where both of its parts are known.
"""

from __future__ import annotations

import re
from collections.abc import Container
from functools import cache

from freebody.questions.spoken.lexicon import (
    contexts,
    endings,
    is_verb_of,
    no_nouns,
    owned,
    phrases_at,
    quantity_words,
    said_of_quantity,
    silent_of_thing,
    tells_apart,
    translated,
    umlauts,
)

_WORD = re.compile(r"(?<![\w.«])[^\W\d_]+(?![\w/(»])")
_LINKS = ("", "s", "n", "en", "es", "e", "er")  # letters between the parts of a word
_FIXED = re.compile(r"(\w{3,})fest(?:e|en|em|er|es)")
_PLURAL = re.compile(r"\b(?:die|der|den|beiden?|zwei|drei|vier|aller?|allen)\s+$", re.IGNORECASE)  # before a noun
_SHORTEST = 3  # letters of a part


def in_english_nouns(text: str, language: str, taken: Container[str] = ()) -> str:
    """The text with what things are called in a language in English, and words that are written as one apart.

    taken: words in lower case for what the model has, which stay as they are."""
    if not translated(language):
        return text

    def told(found: re.Match[str]) -> str:
        word = found[0]
        if word.lower() in taken:
            return word
        if word[0].islower() and is_verb_of(word.lower().replace("ß", "ss"), language):
            return word  # to swing, which is no rocker
        if (stem := _bare(word, language)) in taken:
            return stem
        if stem in owned(language) and _is_owned(text[: found.start()], text[found.end() :], language):
            return owned(language)[stem]  # the Gewicht of the load, which is none itself
        is_plural = word[0].isupper() and _PLURAL.search(text[: found.start()]) is not None
        if is_plural and word.lower() in no_nouns(language) and (noun := word.lower().removesuffix("n")):
            return _fitting(noun, language, taken) if noun in translated(language) else word  # the two Rollen
        return _noun(word, language, taken) or _apart(word, language, taken) or word

    return _WORD.sub(told, text)


def _is_owned(before: str, after: str, language: str) -> bool:
    """Whether what stands between is said to be that of something, or stands alone: das Gewicht der Kiste, ihr
    Gewicht."""
    own, is_alone = contexts(language), not f"{before}{after}".strip(" ?.!")
    return (
        is_alone
        or re.search(own["owner_before"], before) is not None
        or re.match(own["owner_behind"], after) is not None
    )


def _bare(word: str, language: str) -> str:
    """A noun in lower case without an ending."""
    return re.sub(rf"(?<=\w{{3}})(?:{endings(language)})$", "", word.lower())


def _noun(word: str, language: str, taken: Container[str]) -> str:
    """What something is called in English, if it can be by a name that is taken; nothing where a word is no noun for a
    thing."""
    word = word.replace("ß", "ss")
    singular = word.lower()
    is_noun = word[0].isupper() or not phrases_at(singular, 0, language)  # räder, but not fällt
    for letter, plain in umlauts(language).items() if is_noun else ():  # of a plural: Räder
        singular = singular.replace(letter, plain)
    found = _nouns(language).fullmatch(word) or _nouns(language).fullmatch(singular)
    return _fitting(found[1].lower(), language, taken) if found else ""


def _fitting(noun: str, language: str, taken: Container[str]) -> str:
    """The first of the English words for a thing that the model has, or the commonest."""
    words = translated(language)[noun].split("|")
    return next((word for word in words if word in taken), words[0])


@cache
def _nouns(language: str) -> re.Pattern[str]:
    """What things are called in a language, with its endings."""
    nouns = "|".join(sorted(translated(language), key=len, reverse=True))
    others = "|".join(no_nouns(language))
    return re.compile(rf"(?!(?:{others})$)({nouns})(?:{endings(language)})?", re.IGNORECASE)


def _apart(word: str, language: str, taken: Container[str]) -> str:
    """A word that is written as one in its two parts, the longest last part first; nothing where it is none."""
    said = word.lower()
    is_participle = word[0].islower() and re.search(r"end(?:e[nrsm]?)?$", said)  # rollend
    if len(said) < 2 * _SHORTEST or is_participle or phrases_at(said.replace("ß", "ss"), 0, language):
        return ""
    fixed = _FIXED.fullmatch(said)  # the wellenfeste system is that of the shaft
    if fixed is not None and (thing := _first(fixed[1], language, taken, is_quantity=True)):
        return thing
    for k in range(_SHORTEST, len(said) - _SHORTEST + 1):
        last = said[k:]
        if word[0].islower() and said[:k] in silent_of_thing(language) and tells_apart(_plain(last), language):
            return _noun(last, language, taken) or last  # the kurveninnere wheel is the inner one
        is_quantity = last in quantity_words(language) or _bare(last, language) in quantity_words(language)
        head = last if is_quantity else _noun(last, language, taken)
        first = _first(said[:k], language, taken, is_quantity=is_quantity) if head else None
        if first is not None:
            return f"{first} {head}".strip()
    return ""


def _plain(word: str) -> str:
    return word.replace("ß", "ss")


def _first(part: str, language: str, taken: Container[str], *, is_quantity: bool) -> str | None:
    """What the first part of a word says of the last: a thing, an adjective, nothing (""); None where it is unknown."""
    stems = [part.removesuffix(link) for link in _LINKS if part.endswith(link)]
    for stem in (*stems, *(f"{stem}e" for stem in stems)):  # of a Bremse is the Bremsleistung
        if stem in taken:
            return stem
        if is_quantity and stem in said_of_quantity(language):
            return said_of_quantity(language)[stem]
        if not is_quantity and stem in silent_of_thing(language):
            return ""
        if stem in translated(language):
            return _fitting(stem, language, taken)
    return None
