"""The rules of each language: what words and forms of speech become in the words of the grammar.

A file `xx.toml` has tables of rules that are applied in their order, each to the whole text: a pattern, and what stands
in its place; further replacements are other ways to mean it, tried in turn. In a pattern {N} is a name, {V} a value. A
file other than the English one has its own words become English ones, and says what things are called (`nouns`).
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Any, cast

from freebody.questions.spoken.naming import MARKED

ENGLISH = "en"
MOST = 24  # other ways to mean one text
_PARTS = {"{N}": rf"(?:{MARKED})", "{V}": r"(?:[^\s,]+(?: [A-Za-zµ°%][\w/^*²³]*)?)"}


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
    return text if table is None else _nouns(language).sub(lambda found: str(table[found[1].lower()]), text)


@cache
def _nouns(language: str) -> re.Pattern[str]:
    """What things are called in a language, with its endings."""
    table = _file(language)
    nouns, verbs = (
        "|".join(sorted(words, key=len, reverse=True)) for words in (table["nouns"], table["endings"]["verbs"])
    )
    return re.compile(rf"\b(?!(?:{verbs})\b)({nouns})(?:{table['endings']['nouns']})?\b", re.IGNORECASE)


@cache
def rules_of(language: str) -> tuple[Rule, ...]:
    """The rules of a language, in the order of its file."""
    found: list[Rule] = []
    for table in _file(language).values():
        rules = cast("list[list[str]]", table["rules"]) if "rules" in table else []
        found += [Rule(_pattern(rule[0]), tuple(rule[1:])) for rule in rules]
    return tuple(found)


def _pattern(text: str) -> re.Pattern[str]:
    for part, pattern in _PARTS.items():
        text = text.replace(part, pattern)
    return re.compile(text, re.IGNORECASE)


def said_in_grammar(text: str, language: str) -> Iterator[str]:
    """The text in the words of the grammar, in every way that the rules of a language leave, the first ones first."""
    rules = rules_of(language) if language == ENGLISH else (*rules_of(language), *rules_of(ENGLISH))
    yield from islice(_applied(text, rules, 0), MOST)


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
