"""The words of each language, a file `xx.toml` each: kinds of words, what each means, and the phrases for it.

A phrase is words, with choices (a|b), parts that may be left out (a)?, an open end (turn*) and a gap, for what stands
between its words (comes _ back). The table `spelling` is of rules for the whole text, before its words are looked up.
A file other than the English one says what things are called in English (`nouns`), with their endings, and which words
are written as one with them (`compounds`).
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, cast

ENGLISH = "en"
OPEN, CLOSE = "«", "»"  # marks of names in a text
MARKED = rf"{OPEN}[^{OPEN}{CLOSE}]+{CLOSE}"
GAP = "_"
_NO_WORDS = (
    "spelling",
    "nouns",
    "endings",
    "compounds",
    "before",
    "behind",
    "things",
)  # tables that are not kinds of words
_CHOICE = re.compile(r"\(([^()]*)\)(\?)?")


@dataclass(frozen=True)
class Word:
    """What a phrase means. kind: the table it stands in."""

    kind: str
    what: str


@dataclass(frozen=True)
class Phrase:
    """The words of a phrase, in lower case; the end of one may be open."""

    words: tuple[str, ...]
    means: Word

    def found_in(self, tokens: list[str], start: int, end: int) -> tuple[int, ...] | None:
        """The places of its words among tokens that begin with it; None where they do not."""
        places: list[int] = []
        at, is_open = start, False
        for word in self.words:
            if word == GAP:
                is_open = True
                continue
            reach = range(at, end) if is_open else range(at, min(at + 1, end))
            place = next((k for k in reach if _is_word(word, tokens[k])), None)
            if place is None:
                return None
            places.append(place)
            at, is_open = place + 1, False
        return tuple(places)


def _is_word(word: str, token: str) -> bool:
    return token.startswith(word[:-1]) if word.endswith("*") else token == word


def languages() -> tuple[str, ...]:
    """The languages that are understood, English first."""
    found = {path.stem for path in Path(__file__).parent.glob("*.toml")}
    return (ENGLISH, *sorted(found - {ENGLISH}))


@cache
def _file(language: str) -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / f"{language}.toml").read_text("utf-8"))


@cache
def _phrases(language: str) -> dict[str, tuple[Phrase, ...]]:
    """The phrases of a language by the first two letters of their first word, the longest first."""
    found: dict[str, list[Phrase]] = {}
    for kind, table in _file(language).items():
        if kind in _NO_WORDS:
            continue
        for what, written in cast("dict[str, list[str]]", table).items():
            for text in written:
                for words in dict.fromkeys(tuple(said.split()) for said in _spelt_out(text)):
                    found.setdefault(words[0][:2].rstrip("*"), []).append(Phrase(words, Word(kind, what)))
    return {key: tuple(sorted(own, key=lambda phrase: -len(phrase.words))) for key, own in found.items()}


def _spelt_out(text: str) -> Iterator[str]:
    """A phrase with every choice made."""
    choice = _CHOICE.search(text)
    if choice is None:
        yield " ".join(text.split())
        return
    for option in (*choice[1].split("|"), *([""] if choice[2] else [])):
        yield from _spelt_out(text[: choice.start()] + option + text[choice.end() :])


def phrases_at(tokens: list[str], start: int, end: int, language: str) -> Iterator[tuple[Word, tuple[int, ...]]]:
    """What the tokens from a place on can mean, the longest phrases first, and the places of their words."""
    table = _phrases(language)
    for key in dict.fromkeys((tokens[start][:2], tokens[start][:1])):
        for phrase in table.get(key, ()):
            places = phrase.found_in(tokens, start, end)
            if places is not None:
                yield phrase.means, places


@cache
def vocabulary(language: str) -> frozenset[str]:
    """All words of a language that are written in full."""
    return frozenset(
        word for own in _phrases(language).values() for phrase in own for word in phrase.words if word[-1] not in "*_"
    )


def goes_beside(token: str, where: str, language: str) -> bool:
    """Whether a word may stand `before` or `behind` a name, and says no more than the name does."""
    return any(_is_word(word, token) for word in _file(language)[where]["name"])


@cache
def kinds_apart() -> tuple[frozenset[str], ...]:
    """Words for kinds of things that are not the same: what is a block is no cart."""
    return tuple(frozenset(cast("list[str]", words)) for words in _file(ENGLISH)["things"]["apart"])


# -- before words are looked up ---------------------------------------------------------------
@cache
def _spelling(language: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    rules = cast("list[list[str]]", _file(language)["spelling"]["rules"])
    return tuple((re.compile(rule[0].replace("{N}", f"(?:{MARKED})"), re.IGNORECASE), rule[1]) for rule in rules)


def spelt(text: str, language: str) -> str:
    """A text in which names are marked, spelt as the phrases are."""
    for pattern, replacement in _spelling(language):
        text = pattern.sub(replacement, text)
    return " ".join(text.split())


def in_english_nouns(text: str, language: str) -> str:
    """The text with what things are called in a language in English."""
    table = _file(language).get("nouns")
    if table is None:
        return text
    text = _compounds(language).sub(r"\1 \2", text)
    return _nouns(language).sub(lambda found: str(table[found[1].lower()]), text)


@cache
def _compounds(language: str) -> re.Pattern[str]:
    """What is one word with the thing it belongs to: Kolbengeschwindigkeit."""
    table = _file(language)
    nouns, heads = (
        "|".join(sorted(words, key=len, reverse=True)) for words in (table["nouns"], table["compounds"]["heads"])
    )
    return re.compile(rf"\b({nouns})(?:{table['endings']['nouns']})?({heads})\b", re.IGNORECASE)


@cache
def _nouns(language: str) -> re.Pattern[str]:
    """What things are called in a language, with its endings."""
    table = _file(language)
    nouns, verbs = (
        "|".join(sorted(words, key=len, reverse=True)) for words in (table["nouns"], table["endings"]["verbs"])
    )
    return re.compile(rf"\b(?!(?:{verbs})\b)({nouns})(?:{table['endings']['nouns']})?\b(?!/)", re.IGNORECASE)
