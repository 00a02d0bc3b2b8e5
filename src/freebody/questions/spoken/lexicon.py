"""The rules of each language: what words and forms of speech become in the words of the grammar.

A file `xx.toml` has tables of rules that are applied in their order, each to the whole text: a pattern, and what stands
in its place; further replacements are other ways to mean it, tried in turn. In a pattern {N} is a name, {V} a value (a
number with its unit, or a parameter). A file other than the English one has its own words become English ones, and says
what things are called (`nouns`), and which words are written as one with them (`compounds`).
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import islice, product
from pathlib import Path
from typing import Any, cast

from freebody.questions.spoken.naming import MARKED, OPEN

ENGLISH = "en"
_LAST_OF_WHOLE = "turned"  # the table of the English file after which parts of a text are texts of their own
MOST = 24  # other ways to mean one text
_PARTS = {"{N}": rf"(?:{MARKED})", "{V}": rf"(?:(?=\S*[\d{OPEN}])[^\s,]+(?: [A-Za-zµ°%][\w/^*²³]*)?)"}
_FRAMES = tuple(
    re.compile(frame)
    for frame in (
        rf"^(?:value of|range of|least|largest) (?:{MARKED}|@mass\([^()]*\)) (?:for which|so that) (?!it )(.+?)"
        r" (?:[<>]?=|[<>]|≥|≤|is) .+$",
        r"^ratio of (.+) to (.+?)(?: when .+| at start)?$",
    )
)


@dataclass(frozen=True)
class Rule:
    pattern: re.Pattern[str]
    replacements: tuple[str, ...]


def languages() -> tuple[str, ...]:
    """The languages that are understood, English first."""
    found = {path.stem for path in Path(__file__).parent.glob("*.toml")}
    return (ENGLISH, *sorted(found - {ENGLISH}))


@cache
def _file(language: str) -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / f"{language}.toml").read_text("utf-8"))


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
    nouns, heads = ("|".join(sorted(words, key=len, reverse=True)) for words in (table["nouns"], table["compounds"]))
    return re.compile(rf"\b({nouns})(?:{table['endings']['nouns']})?({heads})\b", re.IGNORECASE)


@cache
def _nouns(language: str) -> re.Pattern[str]:
    """What things are called in a language, with its endings."""
    table = _file(language)
    nouns, verbs = (
        "|".join(sorted(words, key=len, reverse=True)) for words in (table["nouns"], table["endings"]["verbs"])
    )
    return re.compile(rf"\b(?!(?:{verbs})\b)({nouns})(?:{table['endings']['nouns']})?\b", re.IGNORECASE)


@cache
def rules_of(language: str) -> tuple[tuple[Rule, ...], tuple[Rule, ...]]:
    """The rules of a language in their order: up to those that show what a text is made of, and the others."""
    found: tuple[list[Rule], list[Rule]] = ([], [])
    k = 0
    for name, table in _file(language).items():
        rules = cast("list[list[str]]", table["rules"]) if "rules" in table else []
        found[k].extend(Rule(_pattern(rule[0]), tuple(rule[1:])) for rule in rules)
        k = 1 if name == _LAST_OF_WHOLE else k
    return tuple(found[0]), tuple(found[1])


def _pattern(text: str) -> re.Pattern[str]:
    for part, pattern in _PARTS.items():
        text = text.replace(part, pattern)
    return re.compile(text, re.IGNORECASE)


def said_in_grammar(text: str, language: str) -> Iterator[str]:
    """The text in the words of the grammar, in every way that the rules of a language leave, the first ones first."""
    of_whole, others = rules_of(ENGLISH)
    if language != ENGLISH:
        of_whole = (*rules_of(language)[0], *of_whole)
    wholes = _applied(text, of_whole, 0)
    yield from islice((said for whole in wholes for said in _with_parts(whole, of_whole, others)), MOST)


def _with_parts(text: str, of_whole: tuple[Rule, ...], others: tuple[Rule, ...]) -> Iterator[str]:
    """A text may be made of others (the ratio of two, what is so for a value), which rules reach too."""
    whole = next(filter(None, (frame.match(text) for frame in _FRAMES)), None)
    if whole is None:
        yield from _applied(text, others, 0)
        return
    ways = (list(islice(_applied(part, (*of_whole, *others), 0), MOST)) for part in whole.groups())
    for parts in product(*ways):
        yield from _applied(_put(whole, parts), others, 0)


def _put(whole: re.Match[str], parts: tuple[str, ...]) -> str:
    """The text with other words in the places of its parts."""
    text = whole[0]
    for k in range(len(parts), 0, -1):
        text = text[: whole.start(k)] + parts[k - 1] + text[whole.end(k) :]
    return text


def _applied(text: str, rules: tuple[Rule, ...], k: int) -> Iterator[str]:
    while k < len(rules):
        rule = rules[k]
        k += 1
        if rule.pattern.search(text) is None:
            continue
        first, *others = rule.replacements
        if others:
            for replacement in rule.replacements:
                yield from _applied(_tidy(rule.pattern.sub(replacement, text)), rules, k)
            return
        text = _tidy(rule.pattern.sub(first, text))
    yield text


def _tidy(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()
