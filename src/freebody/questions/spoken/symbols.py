"""Quantities by their symbols: N_A is the normal force at A, v_B the velocity of B, omega_2 that of gear2; `find T`.

What a symbol stands for is in the lexicon (`symbols`), its index is a name of the model, a word for its kind, the
number at the end of one or, of what turns, the capital letter that it alone begins with; or it says how large (v_max),
or when (v_top), as the lexicon has it (`indices`), behind a comma as well (T_1,max). Some symbols mean something as a
whole (`signs`: F_N, f_0). `N_A(t=0)` is that at the start, `N(r)` the function of r, `v_A/v_B` the ratio of both. A
name of the model that looks like such a symbol is that name.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from functools import cache
from typing import TYPE_CHECKING

from freebody.questions.spoken.lexicon import contexts, indices, languages, mass_center, ratios, signs, symbols

if TYPE_CHECKING:
    from freebody.questions.spoken.elements import Elements

_OF_JOINTS = ("T", "S", "N", "F", "R", "M")  # symbols of what connections exert
_CENTERS = ("G", "CG", "CM")  # indices that stand for the mass centre of what is named behind them
_FREQUENCIES = ("frequency", "frequenz")
_OF_TURNING = ("omega", "ω", "alpha", "α")
_SHORTEST_BEGIN = 2
_SHORTEST_WORD = 3  # letters of an index that is written without a bar: vmax
_AT_TIME = re.compile(r"\((?:t ?= ?)?(?P<time>\d[\d.]*(?: ?m?s)?)\)")
_EXTREME = re.compile(r"(?<![\w.])(?P<name>[^\W\d_]\w*)_(?P<end>min|max)(?![\w(])")
_ZERO = ("0", "0 s", "0s")


def spelt_out(elements: Elements, text: str, language: str) -> str:
    """The text with words for the symbols of quantities that have an index."""
    meant = symbols(language)

    def said(found: re.Match[str]) -> str:
        return _in_words(elements, found, language) or found[0]

    text = _EXTREME.sub(lambda found: _extreme(elements, found, language), text)
    alone = _alone(language).fullmatch(text)  # a symbol without an index is all that is asked for
    if alone and alone["symbol"] not in elements.exact and (alone["symbol"].lower(),) not in elements.spoken:
        return f"{alone['lead']}{meant[alone['symbol']][0].rsplit(' ', 1)[0]}"
    if (both := _ratio(language).fullmatch(text.strip(" ?"))) is not None:
        sides = [_tokens(language).sub(said, side) for side in (both["one"], both["other"])]
        text = ratios(language).format(*sides) if sides != [both["one"], both["other"]] else text
    told = _tokens(language).sub(said, text)
    for symbol in meant:  # the normal force N_A
        for before in meant[symbol]:
            head = meant[symbol][0]
            told = re.sub(rf"\b{before.rsplit(' ', 1)[0]} (?={head} )", "", told, flags=re.IGNORECASE)
    return told


def _extreme(elements: Elements, found: re.Match[str], language: str) -> str:
    """The least mu, for mu_min, where the model has a mu, and no mu_min."""
    is_known = found["name"] in elements.exact and found[0] not in elements.exact
    return f"{indices(language, 'before')[found['end']]} {found['name']}" if is_known else found[0]


def _in_words(elements: Elements, found: re.Match[str], language: str) -> str:
    """What a symbol with its index says; nothing where that is not known."""
    symbol, index, argument = found["symbol"] or "", found["index"] or "", found["argument"] or ""
    at = _AT_TIME.fullmatch(argument)
    behind = "" if at is None else " " + indices(language, "behind")["0" if at["time"] in _ZERO else "at"]
    behind = behind if at is None else behind.format(at["time"])
    if argument and not behind and argument.strip("() ") not in (*elements.exact, "t"):
        return ""
    written = found[0].removesuffix(argument)
    if written in elements.exact or (written.lower(),) in elements.spoken:
        return ""
    if found["sign"]:
        if elements.space and found["sign"].startswith("L_"):  # of which the sign tells one component
            return ""
        before = found.string[: found.start()].split()[-1:]
        if before and before[0].lower().endswith(_FREQUENCIES):  # the circular frequency ω0 has its words
            return ""
        is_counted = found["sign"][-1:].isdigit()  # omega_2 of the second one
        is_of_body = bool(elements.turning) and found["sign"].startswith(_OF_TURNING) and is_counted
        return "" if is_of_body else f"{signs(language)[found['sign']]}{behind}"
    head = symbols(language)[symbol][0]
    if not index:  # N(r)
        return f"{head.rsplit(' ', 1)[0]}{behind}" if argument and symbol not in elements.exact else ""
    of, _, more = index.partition(",")
    if index in _CENTERS and index not in elements.exact:
        return f"{head} {mass_center(language)}{behind}"
    if said := _of(elements, symbol, of) if found["bar"] or not of.islower() else "":  # at is no a_t
        head = f"{head} {said}"
    elif not more and symbol not in elements.exact and (found["bar"] or len(of) >= _SHORTEST_WORD):
        head, more = head.rsplit(" ", 1)[0], of
    else:
        return ""
    before, behind = indices(language, "before").get(more, ""), f" {indices(language, 'behind').get(more, '')}{behind}"
    return f"{before} {head}{behind}".strip() if before or behind.strip() or not more else ""


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
def _ratio(language: str) -> re.Pattern[str]:
    side = rf"(?:{_one(language)})"
    unnamed = re.sub(r"\?P<\w+>", "?:", side)
    return re.compile(rf"(?P<one>{unnamed}) ?/ ?(?P<other>{unnamed})")


@cache
def _tokens(language: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w.«]){_one(language)}(?![\w.»(]|\s*[=<>+*/^])")


def _one(language: str) -> str:
    """A pattern for a symbol with its index, or for one that means something as a whole."""
    symbol = "|".join(sorted((*symbols(language),), key=len, reverse=True))
    whole = "|".join(sorted(map(re.escape, signs(language)), key=len, reverse=True))
    more = "|".join((*indices(language, "before"), *indices(language, "behind")))
    index = rf"(?P<bar>_?)(?P<index>[^\W_]\w*(?:,(?:{more}))?)"
    return rf"(?:(?P<sign>{whole})(?!\w)|(?P<symbol>{symbol})(?:{index})?)(?P<argument>\([\w =.]+\))?"


def _of(elements: Elements, symbol: str, index: str) -> str:
    """What an index says: a name, or the only thing of the kind whose name ends with it."""
    own = [name for name in elements.turning if name.startswith(index.lower())]
    if symbol in _OF_TURNING and index.isupper() and index not in elements.exact and len(own) == len(index):
        return own[0]
    if index in elements.exact or (index.lower(),) in elements.spoken:
        return index
    own = elements.touching.keys() if symbol in _OF_JOINTS else elements.bodies
    found = [name for name in own if re.search(rf"(?<!\d){re.escape(index)}$", name)] if index.isdigit() else []
    if index.isalpha() and len(index) >= _SHORTEST_BEGIN:  # v_block
        is_word = len(index) >= _SHORTEST_WORD
        found = [index] if is_word and any(index.lower() in e.words for e in elements.exact.values()) else []
        begun = [name for name in own if name.lower().startswith(index.lower())] if not found else []
        found = begun if len(begun) == 1 else found  # omega_in of the input
    return found[0] if len(found) == 1 else ""
