"""Forces as multiples of a weight: twice the weight of the rod, dreimal so groß wie sein Gewicht.

Patterns: `weight_...`, `..._gs` and `share_...` in the contexts of a language.
"""

from __future__ import annotations

import re
from functools import cache
from typing import TYPE_CHECKING

from freebody.language.expression import ONE, Expr, free_symbols
from freebody.language.notation import to_python
from freebody.language.sentences import Message
from freebody.language.units import ACCELERATION, DIMENSIONLESS
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.lexicon import contexts, languages
from freebody.questions.spoken.naming import linked, plain_names
from freebody.questions.spoken.wanted_unit import ACCELERATES

if TYPE_CHECKING:
    from freebody.model.names import Names

_SHARES = ("share_borne", "share_of")  # what part of the weight something carries, the share of it
_PRESSING = re.compile(r"normal force of (\w+)")
_DIGITS = 9  # to which a direction is upright, or level
_STANDARD = 9.80665  # m/s^2, of free fall


def in_weights(names: Names, elements: Elements, text: str) -> str:
    """A text in which multiples of the weight of a body, and accelerations told in g, are products of the file's
    parameters, or numbers."""
    for language in languages():
        if ACCELERATES.search(text) is not None:
            said = _pattern(language, "in_gs")
            text = said.sub(lambda found: f"{found['before']}{_accelerated(names, found['count'])}", text)
        multiple, factors = _pattern(language, "weight_multiple"), _factors(language)
        text = multiple.sub(lambda found, own=factors: _value(names, elements, found, own) or found[0], text)
    return text


def without_gs(names: Names, text: str) -> tuple[str, str] | None:
    """A question after an acceleration without what says that it is to be told in g, and what g is; None where nothing
    says so."""
    told = (_pattern(language, "told_in_gs").search(text) for language in languages())
    if ACCELERATES.search(text) is None or (found := next((one for one in told if one), None)) is None:
        return None
    return text[: found.start()] + text[found.end() :], _accelerated(names, "1").removeprefix("1*")


def share_of_weight(names: Names, text: str) -> tuple[str, str] | None:
    """A question after the share of the weight that something carries: the force there, and the weight of the only body
    that has one; None where nothing says so."""
    asked = text.strip().rstrip("?!. ")
    language, found = _share_said(asked)
    weights = [load.law for load in names.applied_loads if "gravity" in names.called.get(load.load, ())]
    if found is None or len(weights) != 1 or not _alone_is_borne(names):
        return None
    if _pattern(language, "share_of_load").search(asked[: found.start("on")]) and len(names.applied_loads) > 1:
        return None  # which load that is
    return contexts(language)["share_carried"].format(on=found["on"]), _product(names, "1", weights[0])


def share_among_others(names: Names, text: str) -> Message | None:
    """What is said of a text that asks for a share of the weight where other loads are borne as well."""
    asked = text.strip().rstrip("?!. ")
    language, found = _share_said(asked)
    if found is None or _pattern(language, "share_of_load").search(asked[: found.start("on")]):
        return None
    if not any("gravity" in names.called.get(load.load, ()) for load in names.applied_loads) or _alone_is_borne(names):
        return None
    return Message(
        "cannot read '{text}': other loads than the weight are borne there, too; ask for the ratio of two forces",
        text=text,
    )


def _share_said(asked: str) -> tuple[str, re.Match[str] | None]:
    """The language in which a share is asked for, and how; of none nothing."""
    shares = ((language, _pattern(language, key).match(asked)) for language in languages() for key in _SHARES)
    return next(((own, one) for own, one in shares if one is not None), ("", None))


def presses_upright(names: Names, words: str) -> bool:
    """Whether what is asked for are normal forces along which a weight acts: a wall bears none of it, a slope not with
    its normal force alone."""
    pressing = {row.connection: row.measure for row in names.constraint_rows if row.reaction == "normal force"}
    asked = _PRESSING.findall(words)
    return bool(asked) and all(_upright(names, pressing.get(joint)) == 1.0 for joint in asked)


def _alone_is_borne(names: Names) -> bool:
    """Whether nothing but the weight acts upwards or downwards: what bears it bears no more than shares of it."""
    forces = [p.measure for p in names.applied_loads if "gravity" not in names.called.get(p.load, ())]
    return all(measure.dimension == DIMENSIONLESS or _upright(names, measure) == 0.0 for measure in forces)


def _upright(names: Names, measure: object) -> float | None:
    """How much of a direction that keeps still is along the weight: 1 of an upright one, 0 of a level one."""
    weight = next(p.measure for p in names.applied_loads if "gravity" in names.called.get(p.load, ()))
    if isinstance(measure, Combination) and [factor for factor, _ in measure.terms] == [ONE]:
        measure = measure.terms[0][1]  # which is held where it is at the start
    if not isinstance(measure, Displacement) or not isinstance(weight, Displacement):
        return None
    if measure.along.body != GROUND or weight.along.body != GROUND:
        return None
    pairs = zip(measure.along.components, weight.along.components, strict=True)
    parts = [(names.numeric(one), names.numeric(other)) for one, other in pairs]
    if any(None in part for part in parts):
        return None
    return round(abs(sum(one * other for one, other in parts if one is not None and other is not None)), _DIGITS)


def _accelerated(names: Names, count: str) -> str:
    """So many times the acceleration of free fall, as the file names it, or the standard one."""
    factor = count.replace(",", ".")
    fields = {x for p in names.applied_loads if "gravity" in names.called.get(p.load, ()) for x in free_symbols(p.law)}
    named = [
        name for name in sorted(fields) if name in names.parameters and names.parameters[name].dimension == ACCELERATION
    ]
    return f"{factor}*{named[0]}" if len(named) == 1 else f"{float(factor) * _STANDARD:g} m/s^2"


def _value(names: Names, elements: Elements, found: re.Match[str], factors: dict[str, str]) -> str | None:
    weights = {load.component: load.law for load in names.applied_loads if "gravity" in names.called.get(load.load, ())}
    meant = [*weights]
    if found["of"]:
        said = {in_english_nouns(found["of"], language, elements.taken) for language in languages()}
        marked = {plain_names(way.text) for word in said for way in linked(elements, word)}
        meant = [body for body in weights if body in marked or found["of"] == body]
    if len(meant) != 1:
        return None
    count = (found["count"] or found["factor"] or "1").lower().replace(",", ".")
    return f"= {_product(names, factors.get(count, count), weights[meant[0]])}"


@cache
def _pattern(language: str, key: str) -> re.Pattern[str]:
    return re.compile(contexts(language)[key], re.IGNORECASE)


@cache
def _factors(language: str) -> dict[str, str]:
    """Words for numbers before a weight: twice is 2."""
    return dict(re.findall(r"(\S+)=(\S+)", contexts(language)["weight_factors"]))


def _product(names: Names, factor: str, weight: Expr) -> str:
    number = names.numeric(weight)
    if free_symbols(weight) or number is None:
        return f"{factor}*{to_python(weight).replace('**', '^')}".removeprefix("1*")
    over = 2.0 if factor == "1/2" else 1.0
    return f"{float(factor.removesuffix('/2')) / over * number:g} N"
