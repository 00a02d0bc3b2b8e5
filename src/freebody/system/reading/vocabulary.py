"""The words in which a file is written, and which of them is nearest to one that nobody knows."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from functools import cache

from freebody.language.folded import folded
from freebody.model.friction import AT_REST, IN_MOTION
from freebody.model.spec import MEANT
from freebody.model.written_kinds import words_also
from freebody.questions.reading import KEYS_OF_QUESTIONS
from freebody.system.reading.sections import (
    ATTACHED,
    CLOSES,
    HINGED,
    LIES_ON,
    MEANT_SECTIONS,
    OF_DRAWINGS,
    OF_GROUND,
    OF_LINES,
    OF_PARAMETERS,
    OF_STYLES,
    PLANAR_OPTIONS,
    ROUGH,
    SAYS_KIND,
    SECTIONS,
    SPATIAL_OPTIONS,
)
from freebody.system.reading.written import (
    beams,
    bevels,
    cams,
    hoists,
    hoops,
    joints,
    linkages,
    planetary,
    single,
    slider_cranks,
    toothed,
    trusses,
)
from freebody.system.reading.written.form import JOINED, SAYS_NAME, kinds_of

_FIGURES = (beams, bevels, cams, hoists, hoops, joints, linkages, planetary, single, slider_cranks, trusses)
SHORT_FORMS = (
    *("pendulum", "beam", "nodes", "links", "four_bar", "slider_crank", "gears", "planetary", "bevel_gears", "cam"),
    *("hoop", "hoist"),
)
_NEAR, _WORDS_COMPARED = 0.65, 9
FEWEST = 3  # letters of a word


def nearest(key: str, known: Mapping[str, str]) -> list[str]:
    """The known words from which one differs by the fewest slips, in the order in which they are known; of a word with
    several parts, `crank_nagle`, also one part of it."""
    found = _close(folded(key), known)
    parts = key.split("_")
    for k, part in enumerate(parts) if len(parts) > 1 else ():
        if len(part) >= FEWEST and folded(part) not in words_inside():
            near = _close(folded(part), words_inside())
            found += [(n, "_".join([*parts[:k], word, *parts[k + 1 :]])) for n, word in near]
    fewest = min((n for n, _word in found), default=0)
    return list(dict.fromkeys(word for n, word in found if n == fewest))


def _close(form: str, known: Mapping[str, str]) -> list[tuple[int, str]]:
    """Known words near to one, each behind the number of slips."""
    order = [*known]
    near = sorted(difflib.get_close_matches(form, known, n=_WORDS_COMPARED, cutoff=_NEAR), key=order.index)
    found = [(slips(form, each), known[each]) for each in near]
    return [(n, word) for n, word in found if n <= max(1, (len(form) + 1) // 3)]


def figure_meant(key: str) -> str | None:
    """The section of a figure in a few lines that a word is, but for one slip."""
    form = folded(key)
    known = words_of_sections()
    if form in known or form in words_inside() or len(form) <= FEWEST + 1:
        return None
    near = [word for each in _FIGURES for word in each.VOCABULARY.sections if slips(form, folded(word)) == 1]
    return near[0] if near else None


def slips(one: str, other: str) -> int:
    """How many letters are wrong, left out, too many or the wrong way round (Damerau, Comm. ACM 7, 1964, 171-176)."""
    rows = [[*range(len(other) + 1)]]
    for i, letter in enumerate(one, 1):
        row = [i]
        for j, each in enumerate(other, 1):
            least = min(rows[-1][j] + 1, row[-1] + 1, rows[-1][j - 1] + (letter != each))
            if i > 1 and j > 1 and letter == other[j - 2] and one[i - 2] == each:
                least = min(least, rows[-2][j - 2] + 1)
            row.append(least)
        rows.append(row)
    return rows[-1][-1]


@cache
def words_of_sections() -> dict[str, str]:
    """What sections are called, by their common form."""
    kinds = [word for at in (*JOINED, "bodies") for word in (*kinds_of(at), *words_also(kinds_of(at)))]
    figures = [word for each in _FIGURES for word in each.VOCABULARY.sections]
    return _by_form([*SECTIONS, *OF_GROUND, *figures, *MEANT_SECTIONS, *kinds])


@cache
def words_inside() -> dict[str, str]:
    """What else the keys of a file are called."""
    fields = [
        word
        for at in (*JOINED, "bodies")
        for kind in kinds_of(at).values()
        for word in (kind.kind, *kind.also, *(f.alias or n for n, f in kind.model_fields.items()), *kind.more_words)
    ]
    beside = (*PLANAR_OPTIONS, *SPATIAL_OPTIONS, *SAYS_KIND, *SAYS_NAME, CLOSES, *LIES_ON, *ATTACHED, *HINGED)
    figures = [word for each in _FIGURES for word in (*each.VOCABULARY.inside, *each.VOCABULARY.sections)]
    own = (
        *OF_LINES,
        *OF_GROUND,
        *OF_PARAMETERS,
        *KEYS_OF_QUESTIONS,
        *OF_DRAWINGS,
        *OF_STYLES,
        "normal",
        "turned",
        "up",
    )
    return _by_form([*fields, *beside, *own, *figures, *MEANT, *ROUGH, *AT_REST, *IN_MOTION, *toothed.WORDS])


def _by_form(words: list[str]) -> dict[str, str]:
    """By their common form: the words, of several the first."""
    found: dict[str, str] = {}
    for word in words:
        found.setdefault(folded(word), word)
    return found
