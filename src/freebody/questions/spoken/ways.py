"""Ways to mean a text: which of its words are names, and what the others say, in each language."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING

from freebody.questions.spoken.assumed import without_what_holds
from freebody.questions.spoken.by_side import before_its_kind
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.lexicon import (
    MARKED,
    Word,
    contexts,
    is_in_language,
    languages,
    phrases_at,
    several,
    translated,
)
from freebody.questions.spoken.meaning import meanings
from freebody.questions.spoken.naming import elements_of, linked
from freebody.questions.spoken.numerals import in_digits
from freebody.questions.spoken.own_axles import about_own_axles
from freebody.questions.spoken.several import paired
from freebody.questions.spoken.strings import running_over
from freebody.questions.spoken.suggesting import MOST
from freebody.questions.spoken.symbols import spelt_out
from freebody.questions.spoken.throughout import without_course
from freebody.questions.spoken.wanted_unit import without_units
from freebody.questions.spoken.weights import in_weights
from freebody.questions.spoken.words import Unknown, in_own_letters, respelt, words_of

if TYPE_CHECKING:
    from freebody.model.names import Names

_ENDS = 2  # words of a text that may be read with what stands beside it
_APOSTROPHE = re.compile(r"(?<=\w)['’](?=(?:s|t|d|re|ll|m|ve)\b)|(?<=s)['’](?=\s)")


@dataclass(frozen=True)
class Meaning:
    """One way in which the names of a text can be meant.

    texts: in the words of the grammar, as they are tried in turn, each with all elements that the model has for what is
    not named; distance: how far the names are from those written; words: what its words mean, one after the other, and
    before them the bodies whose names are taken for what only describes another thing: the ball on the beam."""

    texts: Iterator[list[str]]
    distance: int
    words: tuple[Word, ...]


def ways_to_mean(names: Names, text: str, *, guess: bool = False) -> list[Meaning]:
    """Ways to mean a text, the nearest to its words first. guess: a word that nothing knows is taken for a name."""
    text = _APOSTROPHE.sub("’", " ".join(text.split())).strip('"“”„ ')
    for language in languages():
        text = re.sub(contexts(language)["at_once"], "", text)
        text = re.sub(contexts(language)["on_crest"], contexts(language)["at_top"], text)
        if "elliptic" in contexts(language):  # the upper block on the lower, which is a block, too
            text = re.sub(contexts(language)["elliptic"], r"\g<all> \g<noun>", text)
    elements = elements_of(names)
    text = about_own_axles(names, elements, without_units(without_what_holds(names, text), elements.exact)[0])
    text = before_its_kind(elements, in_weights(names, elements, text))
    text = re.sub(r"\w+(?:-\w+)+", lambda said: _joined(said[0], elements), text)
    found: list[Meaning] = []
    for language in languages():
        told = in_digits(spelt_out(elements, text, language), language)
        told = paired(elements, in_english_nouns(told, language, elements.taken), language)
        for way in linked(elements, told):
            try:
                words = words_of(way.text, language, guess=guess, parameters=names.parameters.keys())
            except Unknown:
                continue
            words = running_over(names, without_course(names, words))
            if not _hangs_on_another(text, words, language):
                told_by = (*_passed_over(names, way.text, words, language), *words)
                found.append(Meaning(meanings(names, words), way.distance, told_by))
    return sorted(found, key=lambda meaning: meaning.distance)


def _passed_over(names: Names, text: str, words: list[Word], language: str) -> list[Word]:
    """Bodies that a text names without a mark, by a word that is read as nothing else: the small piston."""
    plain = set(re.findall(r"[\w.]+", re.sub(MARKED, " ", text)))
    return [
        Word("name", body)
        for body in names.bodies
        if body in plain and not any(meant in words for meant, _ in phrases_at(body, 0, language))
    ]


def _hangs_on_another(text: str, words: list[Word], language: str) -> bool:
    """Whether a text is meant of an instant that another question has, or asks whether something is needed: how fast is
    it then, is friction needed there."""
    plain = text.rstrip(".?! ")
    if several(language, "needless").search(plain) is not None:  # whether something is needed at all
        return True
    is_lone = several(language, "lone").search(plain) is not None
    return is_lone and not any(word.kind in ("mark", "instant") for word in words)


def _joined(word: str, elements: Elements) -> str:
    """A word with hyphens, or the name that it is without them: the yo-yo."""
    plain = word.replace("-", "").lower()
    if plain in ("lefthand", "righthand"):
        return plain.removesuffix("hand")
    if any({plain, plain.removesuffix("s")} & translated(language).keys() for language in languages()):  # des Jo-Jos
        return plain
    return next((name for name in elements.exact if name.lower() == plain), word)


def _known(names: Names, text: str) -> Iterator[tuple[int, list[Word]]]:
    """The words of a text that a language has, and how many it has not; those of few unknown words first."""
    elements = elements_of(names)
    found: list[tuple[int, list[Word]]] = []
    for language in languages():
        for way in islice(linked(elements, in_english_nouns(text, language, elements.taken)), MOST):
            try:
                found.append((0, words_of(way.text, language, parameters=names.parameters.keys())))
            except Unknown as error:
                found.append((len(error.words), list(error.known)))
    yield from sorted(found, key=lambda one: one[0])


def is_strange(names: Names, text: str) -> bool:
    """Whether a text has words that stand in no phrase and no rule of any language, apart from those at its ends: what
    is put before or behind it makes no question of it."""
    elements, text = elements_of(names), _APOSTROPHE.sub("’", text)
    ends = {word.lower() for part in (text.split()[:_ENDS], text.split()[-_ENDS:]) for word in part}
    for language in languages():
        told = in_digits(spelt_out(elements, text, language), language)
        for way in islice(linked(elements, in_english_nouns(told, language, elements.taken)), MOST):
            try:
                words_of(way.text, language, parameters=names.parameters.keys())
            except Unknown as error:
                if not {word for word in error.words if not is_in_language(word)} - ends:
                    return False
            else:
                return False
    return True


def what_is_near(names: Names, text: str) -> Iterator[str]:
    """What a text may be about: what it would mean without what nothing is known of, or only its quantity and names."""
    for _, words in islice(_known(names, text), MOST):
        for group in meanings(names, words):
            yield from islice(group, 2)
        kept = [word for word in words if word.kind in ("name", "preposition")]
        for quantity in (word for word in words if word.kind == "quantity"):
            for group in meanings(names, [quantity, *kept]):
                yield from islice(group, 2)


def concepts(names: Names, text: str) -> Iterator[str]:
    """What the words of a text mean, in words of the grammar."""
    _, words = next(_known(names, text), (0, list[Word]()))
    yield from (word.what for word in words if word.kind in ("quantity", "name", "verb"))


def spelt_as_known(names: Names, text: str, language: str) -> str:
    return respelt(text, language, _taken(names))


def with_own_letters(names: Names, text: str) -> str:
    taken = _taken(names)
    for language in languages():
        text = in_own_letters(text, language, taken)
    return text


def _taken(names: Names) -> set[str]:
    """Words for what the model has."""
    return {word for key in elements_of(names).spoken for word in key}
