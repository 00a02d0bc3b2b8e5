"""Shares of what something starts with: until the block has lost half of its speed, when the door is half closed.

What is said so is an equation for the rate, or for the place, of what moves, with what the file lets it start with. It
is one where only one measure can be meant. Patterns: `shares` in a file of its own (xx.comparing.toml).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.language.expression import Number, multiply
from freebody.language.notation import to_python
from freebody.language.units import DIMENSIONLESS
from freebody.measures.geometry import ZERO
from freebody.questions.spoken import lookup
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.lexicon import CLOSE, OPEN, compared_in, comparing, languages
from freebody.questions.spoken.naming import elements_of, linked

if TYPE_CHECKING:
    from freebody.model.names import Names

_AT_END = re.compile(r"(?P<what>.+) when (?P<measure>\w+) = (?P<value>[^;]+)")
_PLAIN = re.compile(r"[\w*/^()]+")
_WAYS = (("lost", True), ("kept", False))


def with_shares(names: Names, text: str) -> str:
    """The text with an equation for what says that so much is lost, or left, of what is there at the start."""
    for language in languages():
        told = compared_in(language, "shares")
        for key, is_lost in _WAYS:
            for k in range(len(told.get(key, ()))):
                found = comparing(language, "shares", key, k).search(text)
                equations = [] if found is None else [*_equations(names, found, language, is_lost=is_lost)]
                if found is not None and len(equations) == 1:
                    mark = found.groupdict().get("mark") or told["asks"]
                    return f"{text[: found.start()]}{mark} {equations[0]}{text[found.end() :]}"
    return text


def halfway(names: Names, text: str, said: Callable[[str], str]) -> str:
    """The grammar for a text that asks of the middle of a way: half of what the measure is at its end, where it counts
    from zero; nothing where it does not. said: the words of the grammar for a text."""
    for language in languages():
        told = compared_in(language, "shares")
        found = comparing(language, "shares", "halfway").search(text) if "halfway" in told else None
        if found is None:
            continue
        for end in told["ends"]:
            read = said(f"{text[: found.start()]}{told['there'].format(end=end)}{text[found.end() :]}")
            at = _AT_END.fullmatch(read)
            if at is not None and at["measure"] in names.measures and at["measure"] not in names.placed_at_start:
                return ""
            if at is not None and names.placed_at_start.get(at["measure"]) == ZERO and at["value"] != "0":
                value = at["value"] if _PLAIN.fullmatch(at["value"]) else f"({at['value']})"
                return f"{at['what']} when {at['measure']} = {value}/2"
    return ""


def _equations(names: Names, found: re.Match[str], language: str, *, is_lost: bool) -> Iterator[str]:
    """What can be meant: for each measure that starts with something."""
    share = _share(found["share"], compared_in(language, "shares")["shares"])
    factor = Number(1 - share if is_lost else share)
    said = in_english_nouns(found["who"], language, elements_of(names).taken)
    who = [name for name in lookup.moving(names) if _is_named(names, said, name)]
    told = names.placed_at_start.keys() | names.start_rates.keys()
    own = [name for name in names.measures if name in told and (not who or {*who} & {*names.measures[name].bodies()})]
    is_rate = found.groupdict().get("speed") is not None
    if is_rate and len(own) > 1:  # the speed of what moves in several ways is the rate of none
        return
    turns = comparing(language, "shares", "turns").search(found.groupdict().get("place") or "") is not None
    for name in own:
        start = (names.start_rates if is_rate else names.placed_at_start).get(name, ZERO)
        if start != ZERO and (is_rate or turns == (names.measures[name].dimension == DIMENSIONLESS)):
            value = to_python(multiply(start, factor)).replace("**", "^")
            yield f"rate({name}) = {value}" if is_rate else f"{name} = {value}"


def _is_named(names: Names, text: str, name: str) -> bool:
    return any(f"{OPEN}{name}{CLOSE}" in way.text for way in linked(elements_of(names), text)[:1])


def _share(said: str, words: dict[str, str]) -> Fraction:
    number = re.match(r"[\d.]+", said)
    return Fraction(words[said.lower()]) if number is None else Fraction(number[0]) / 100
