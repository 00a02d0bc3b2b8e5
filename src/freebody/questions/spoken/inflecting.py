"""Verbs of the lexicon in all their forms: a file writes ~tug, and tugs, tugged, tugging are meant as well.

English verbs end in s, ing and ed by the rules of spelling; German ones are written as their infinitive, with a bar
behind a prefix that may stand apart (~ab|rutschen: es rutscht ab). The forms of strong verbs are in strong_verbs.py.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from freebody.questions.spoken.strong_verbs import ENGLISH, GERMAN

MARK = "~"
ENDS_CLAUSE = "$"  # behind a prefix that stands apart: no article, number or name follows
_MARKED_VERB = re.compile(rf"{MARK}([^\W\d_]+)(?:\|([^\W\d_]+))?")
_DOUBLED = re.compile(r"[^aeiou][aeiou][bdglmnprt]$")  # tug, slip; what is stressed elsewhere is written out


def inflected(written: str, language: str) -> Iterator[str]:
    """The phrases that a phrase with a marked verb stands for; the phrase itself where there is none."""
    found = _MARKED_VERB.search(written)
    if found is None:
        yield written
        return
    before, behind = written[: found.start()], written[found.end() :]
    if language == "en":
        yield f"{before}({'|'.join(_english(found[1]))}){behind}"
        return
    prefix, verb = (found[1], found[2]) if found[2] else ("", found[1])
    yield f"{before}({'|'.join(f'{prefix}{form}' for form in _german(verb, is_parted=bool(prefix)))}){behind}"
    if prefix:
        finite = "|".join(_finite(verb))
        apart = prefix if behind else f"{prefix}{ENDS_CLAUSE}"
        yield f"{before}({finite}) {apart}{behind}"
        yield f"{before}({finite}) _ {apart}{behind}"


def _english(verb: str) -> list[str]:
    """tug, tugs, tugged, tugging."""
    stem = verb
    third = f"{verb}es" if re.search(r"(?:s|x|z|ch|sh|o)$", verb) else f"{verb}s"
    past = f"{verb}ed"
    if re.search(r"[^aeiou]y$", verb):
        third, past = f"{verb[:-1]}ies", f"{verb[:-1]}ied"
    elif verb.endswith("e"):
        past, stem = f"{verb}d", verb[:-1] if not verb.endswith(("ee", "oe")) else verb
    elif _DOUBLED.search(verb) and len(re.findall(r"[aeiou]+", verb)) == 1:
        stem = f"{verb}{verb[-1]}"
        past = f"{stem}ed"
    return [verb, third, *([] if verb in ENGLISH else [past]), f"{stem}ing", *ENGLISH.get(verb, ())]


def _german(verb: str, *, is_parted: bool) -> list[str]:
    """rutschen, rutscht, rutschte, rutschten, gerutscht, rutschend; with a prefix also zu: abzurutschen."""
    stem = _stem(verb)
    te = f"{stem}e" if _E_BEFORE_T.search(stem) else stem
    keeps = re.match(r"(?:be|ver|zer|ent|er|miss)", verb) or verb.endswith("ieren")
    participle = GERMAN[verb][-1] if verb in GERMAN else f"{te}t" if keeps else f"ge{te}t"
    return [*_finite(verb), participle, f"{verb}d", *([f"zu{verb}"] if is_parted else [])]


def _finite(verb: str) -> list[str]:
    stem = _stem(verb)
    te = f"{stem}e" if _E_BEFORE_T.search(stem) else stem
    if verb in GERMAN:
        present, past, _ = GERMAN[verb]
        return list(dict.fromkeys([verb, present, past, f"{past}en", f"{stem}e"]))
    return list(dict.fromkeys([verb, f"{te}t", f"{te}te", f"{te}ten", f"{stem}e"]))


_E_BEFORE_T = re.compile(r"[td]$|[^aeiouäöülrhmn][mn]$")  # wartet, öffnet, but rollt, kommt


def _stem(verb: str) -> str:
    """rutsch of rutschen, feder of federn."""
    return verb.removesuffix("en") if verb.endswith("en") else verb.removesuffix("n")
