"""What a text asks for, in the words of the grammar: the way to mean it that is nearest to its words."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

from freebody.errors import Problem
from freebody.language.sentences import Message
from freebody.questions.spoken.lexicon import in_english_nouns, languages, said_in_grammar
from freebody.questions.spoken.naming import MARKED, elements_of, linked, plain_names
from freebody.questions.spoken.resolving import resolved
from freebody.questions.spoken.suggesting import suggestions

if TYPE_CHECKING:
    from freebody.model.names import Names

AskedT = TypeVar("AskedT")

_APOSTROPHE = re.compile(r"(?<=\w)['’](?=(?:s|t|d|re|ll|m|ve)\b)|(?<=s)['’](?=\s)")
_WORD = re.compile(rf"{MARKED}|(?<![\d.] )\b[A-ZÄÖÜ][a-zäöüß]+\b")
LONGEST = 300  # characters of a question: what is longer is none
_GENERAL = {"askable", "form", "forms"}  # what messages list where nothing of a text could be read


@dataclass(frozen=True)
class Meaning:
    """One way in which the names of a text can be meant.

    texts: in the words of the grammar, as they are tried in turn, each with all elements that the model has for what is
    not named; distance: how far the names are from those written."""

    texts: Iterator[list[str]]
    distance: int


@dataclass(frozen=True)
class Unread:
    """Why the grammar does not read a text."""

    problems: list[Problem]


def understood(names: Names, text: str, read: Callable[[str], AskedT | None]) -> tuple[AskedT, str] | None:
    """What a text asks for, and the words of the grammar in which it does.

    read: what words of the grammar ask for, None after noting a problem. What it does not read is taken as people
    speak; what can be meant in several ways is refused with all of them."""
    n_before = len(names.problems)
    found = read(text)
    if found is not None and len(names.problems) == n_before:
        return found, text
    if names.is_broken_in(text) or len(text) > LONGEST:
        return None
    told = names.problems[n_before:]
    del names.problems[n_before:]
    nearest, instead = _nearest(names, text, read)
    if len(nearest) == 1:
        return next((asked, words) for words, asked in nearest.items())
    if nearest:
        ways = "\n    ".join(nearest)
        several = Message("'{text}' can be meant in several ways. Ask for\n    {ways}", text=text, ways=ways)
        names.problem(several, "find")
    elif _is_specific(told) or instead or _has_form(told):
        names.problems += (
            told if _is_specific(told) and not (_is_of_words(names, told) and instead) else instead or told
        )
    else:
        said = " ".join((text, *_in_english(names, text)))
        fits = suggestions(names, said, lambda question: not isinstance(_read_quietly(names, question, read), Unread))
        askable = "\n    ".join(fits)
        none = Message("cannot read '{text}'. One can ask for\n    {askable}", text=text, askable=askable)
        names.unknown(text, none, "find")
    return None


def _nearest(names: Names, text: str, read: Callable[[str], AskedT | None]) -> tuple[dict[str, AskedT], list[Problem]]:
    """What can be meant by the names that are nearest to those written, by its words; and, where nothing can, what is
    wrong with the first text that has words of the grammar."""
    nearest: dict[str, AskedT] = {}
    distance: int | None = None
    instead: list[Problem] = []
    for meaning in _meanings(names, text):
        if distance is not None and meaning.distance > distance:
            break
        for wordings in meaning.texts:
            tried = {words: _read_quietly(names, words, read) for words in wordings}
            here = {words: asked for words, asked in tried.items() if not isinstance(asked, Unread)}
            if here:
                distance = meaning.distance
                nearest |= {words: asked for words, asked in here.items() if asked not in nearest.values()}
                break
            for asked in tried.values():
                if not instead and isinstance(asked, Unread) and _is_specific(asked.problems):
                    instead = asked.problems
    return nearest, instead


def _read_quietly(names: Names, text: str, read: Callable[[str], AskedT | None]) -> AskedT | Unread:
    """What words of the grammar ask for, or why they ask for nothing."""
    with names.quietly():
        n_before = len(names.problems)
        found = read(text)
        return Unread(names.problems[n_before:]) if found is None or len(names.problems) > n_before else found


def _is_specific(problems: list[Problem]) -> bool:
    """Whether they say more than that nothing of a text can be read."""
    return any(not (isinstance(p.message, Message) and _GENERAL & p.message.arguments.keys()) for p in problems)


def _is_of_words(names: Names, problems: list[Problem]) -> bool:
    """Whether they take words for names, as in `the string`, or for a condition: the way to mean them says more."""
    kinds = set[str]().union(*(element.words for element in elements_of(names).exact.values()))
    messages = [p.message for p in problems if isinstance(p.message, Message)]
    return any(
        m.startswith("cannot read the condition")
        or ("hint" in m.arguments and not kinds.isdisjoint(str(x) for x in m.arguments.values()))
        for m in messages
    )


def _has_form(problems: list[Problem]) -> bool:
    """Whether they say which form of the grammar a text is like."""
    return any(isinstance(p.message, Message) and "form" in p.message.arguments for p in problems)


def _meanings(names: Names, text: str) -> list[Meaning]:
    """Ways to mean a text, the nearest to its words first."""
    text = _APOSTROPHE.sub("’", " ".join(text.split())).strip('"“”„ ')
    elements = elements_of(names)
    found: list[Meaning] = []
    for language in languages():
        ways = linked(elements, in_english_nouns(text, language))
        found += [Meaning(_texts(names, _WORD.sub(_lowered, way.text), language), way.distance) for way in ways]
    return sorted(found, key=lambda meaning: meaning.distance)


def _in_english(names: Names, text: str) -> Iterator[str]:
    """What the rules of other languages make of a text, as far as they know its words."""
    for language in languages()[1:]:
        way = linked(elements_of(names), in_english_nouns(text, language))[0]
        yield plain_names(next(said_in_grammar(_WORD.sub(_lowered, way.text), language)))


def _texts(names: Names, text: str, language: str) -> Iterator[list[str]]:
    for said in said_in_grammar(text, language):
        yield list(map(plain_names, resolved(names, said)))


def _lowered(found: re.Match[str]) -> str:
    return found[0] if found[0].startswith("«") else found[0].lower()
