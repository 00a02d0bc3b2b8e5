"""Forces that nobody chooses: what follows from the motion, such as friction, is no value that a question can state.

Which they are the kinds say themselves: a quantity that is asked for is none that is chosen, unless a parameter can be
called so (given.py), and what a spring, a string or gravity exerts follows from the motion (`Spec.is_chosen`).
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.model.kinds import every_kind
from freebody.model.spec import Spec
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.given import KIND_OF
from freebody.questions.spoken.lexicon import Word, languages, measured_in, phrases_at, values_stated

if TYPE_CHECKING:
    from freebody.model.names import Names

_WORD = re.compile(r"[^\W\d_]+")


def is_unchosen(names: Names, said: str, language: str) -> bool:
    """Whether a force is said that nobody chooses: a friction of 5 N, a spring force; but a pull."""
    if re.search(values_stated(language)["apparent"], said, re.IGNORECASE) is not None:
        return True
    if re.search(values_stated(language)["resisting"], said, re.IGNORECASE) is not None:
        return not any(_resists(name) for name in (*names.loads, *names.parameters))
    line = in_english_nouns(said, language).lower().replace("ß", "ss")
    for word in _WORD.finditer(line):
        meant = _longest(line, word.start(), language)
        follows = bool(meant) and not any(_is_chosen(names, one) for one in meant)
        if follows or (word[0] in unchosen_things() and word[0] not in names.bodies):
            return True
    return False


def _resists(name: str) -> bool:
    """Whether a name says in some language that what has it acts against the motion: rear_brakes, Bremskraft."""
    return any(re.search(values_stated(own)["resists"], name, re.IGNORECASE) is not None for own in languages())


def meant_by(noun: str, language: str) -> set[str]:
    """The quantities that a noun alone can mean."""
    line = noun.lower().replace("ß", "ss")
    return {word.what for word, _ in phrases_at(line, 0, language) if word.kind == "quantity"}


def unchosen_things() -> frozenset[str]:
    """Words for kinds of things none of which exerts what somebody chooses."""
    kinds = [kind for kind in every_kind() if isinstance(kind, type) and issubclass(kind, Spec)]
    chosen = {word for kind in kinds if kind.is_chosen for word in kind.words()}
    return frozenset(word for kind in kinds if kind.is_chosen is False for word in kind.words()) - chosen


def _longest(line: str, start: int, language: str) -> list[Word]:
    """What the longest phrases at a place mean, where one of them means a force."""
    found = phrases_at(line, start, language)
    longest = [word for word, places in found if len(places) == len(found[0][1])]
    meant = [word for word in longest if word.kind == "verb" or _is_force(word)]
    return meant if any(word.kind == "quantity" for word in meant) else []


def _is_force(word: Word) -> bool:
    """Whether a quantity is none that is measured otherwise."""
    dimensions = measured_in(word)
    return word.kind == "quantity" and (not dimensions or not {"force", "torque", "mass"}.isdisjoint(dimensions))


def _is_chosen(names: Names, word: Word) -> bool:
    """Whether what a word means can be chosen: pushing, mass, a force; a tension where there is no string."""
    if word.kind != "quantity":
        return word.kind == "verb"
    if word.what == "tension":
        return all(row.reaction != "tension" for row in names.constraint_rows)
    kind = KIND_OF.get(word.what)
    return kind is not None and (kind.written == "mass" or (kind.is_push and kind.ends_rest))
