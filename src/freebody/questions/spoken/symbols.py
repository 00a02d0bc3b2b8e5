"""Quantities by their symbols: N_A is the normal force at A, v_B the velocity of B, omega_2 that of gear2; `find T`.

What a symbol stands for is in the lexicon (`symbols`), its index is a name of the model or the number at the end of
one. A name of the model that looks like such a symbol is that name.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from functools import cache
from typing import TYPE_CHECKING

from freebody.questions.spoken.lexicon import contexts, languages, mass_center, symbols

if TYPE_CHECKING:
    from freebody.questions.spoken.elements import Elements

_OF_JOINTS = ("T", "S", "N", "F", "R", "M")  # symbols of what connections exert
_CENTERS = ("G", "CG", "CM")  # indices that stand for the mass centre of what is named behind them


def spelt_out(elements: Elements, text: str, language: str) -> str:
    """The text with words for the symbols of quantities that have an index."""
    meant = symbols(language)

    def said(found: re.Match[str]) -> str:
        symbol, index = found["symbol"], found["index"]
        if found[0] in elements.exact or (found[0].lower(),) in elements.spoken:
            return found[0]
        if not found["bar"] and index.islower():  # at is no a_t
            return found[0]
        head = meant[symbol][0]
        if index in _CENTERS and index not in elements.exact:
            return f"{head} {mass_center(language)}"
        of = _of(elements, symbol, index)
        return f"{head} {of}" if of else found[0]

    alone = _alone(language).fullmatch(text)  # a symbol without an index is all that is asked for
    if alone and alone["symbol"] not in elements.exact and (alone["symbol"].lower(),) not in elements.spoken:
        return f"{alone['lead']}{meant[alone['symbol']][0].rsplit(' ', 1)[0]}"
    told = _tokens(language).sub(said, text)
    for symbol in meant:  # the normal force N_A
        for before in meant[symbol]:
            head = meant[symbol][0]
            told = re.sub(rf"\b{before.rsplit(' ', 1)[0]} (?={head} )", "", told, flags=re.IGNORECASE)
    return told


def parameter_asked(parameters: Collection[str], text: str) -> str:
    """The parameter that is all a text asks for, if one is."""
    leads = "|".join(contexts(language)["of_symbol"] for language in languages())
    found = re.fullmatch(rf"(?i:{leads})(?P<name>\w+)[ ?.!]*", text)
    return found["name"] if found and found["name"] in parameters else ""


@cache
def _alone(language: str) -> re.Pattern[str]:
    symbol = "|".join(sorted((*symbols(language),), key=len, reverse=True))
    return re.compile(rf"(?P<lead>(?i:{contexts(language)['of_symbol']}))(?P<symbol>{symbol})[ ?.!]*")


@cache
def _tokens(language: str) -> re.Pattern[str]:
    symbol = "|".join(sorted((*symbols(language),), key=len, reverse=True))
    return re.compile(rf"(?<![\w.«])(?P<symbol>{symbol})(?P<bar>_?)(?P<index>[^\W_]\w*)(?![\w.»(]|\s*[=<>+*/^])")


def _of(elements: Elements, symbol: str, index: str) -> str:
    """What an index says: a name, or the only thing of the kind whose name ends with it."""
    if index in elements.exact or (index.lower(),) in elements.spoken:
        return index
    own = elements.touching.keys() if symbol in _OF_JOINTS else elements.bodies
    found = [name for name in own if re.search(rf"(?<!\d){re.escape(index)}$", name)] if index.isdigit() else []
    return found[0] if len(found) == 1 else ""
