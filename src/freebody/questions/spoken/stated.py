"""Questions that state an instant by an equation, and describe it besides: in the lowest position, theta = 0.

Where a measure and its value are given, what else is said of the same instant (it lands, it is at the bottom again)
only describes it; the equation is what holds.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.questions.spoken import dimensions, given, lookup
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import Groups
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_DESCRIBES = {  # verbs that only say what the instant is like
    *("hit", "return", "reach", "stop", "turn_back", "top", "bottom", "move", "fall", "rise", "fly", "turn", "start"),
    "slide",
    "roll",
    "exert",  # at what angle does one throw
}
_PLACES = (
    "at the top",
    "at the bottom",
    "at the impact",
    "in the impact",
    "at the dead points",
    "at the outer dead point",
    "at the inner dead point",
)
_SPEEDS = ("speed", "velocity")


@dataclass(frozen=True)
class Equation:
    """A measure and its value."""

    measure: str
    value: str

    def __str__(self) -> str:
        return f"{self.measure} = {self.value}"


def stated(names: Names, words: list[Word]) -> Groups:
    """What words ask for that give the values of measures at an instant."""
    equations, rest = _equations(names, words)
    values = [word for word in rest if word.kind == "value"]
    if len(equations) == 1 and len(values) == 1 and dimensions.is_length(values[0].what):  # 60 m far, y = 0
        ways = [way for way in lookup.ways(names, "") if way != equations[0].measure]
        if len(ways) == 1 and any(word.kind == "name" and word.what in names.parameters for word in rest):
            equations = [Equation(ways[0], values[0].what), *equations]
            rest = [word for word in rest if word not in values]
    lands = Word("verb", "hit") in rest and any(w.kind == "name" and w.what in names.parameters for w in rest)
    if len(equations) == 1 and lands and equations[0].measure in lookup.level(names, ""):  # it lands at x = 12 m
        low = lookup.falling(names, "")
        equations += [Equation(low[0], "0")] if len(low) == 1 else []
    if not equations or any(word.kind in ("relation", "not", "value", "turns") for word in rest):
        return
    if any(word.kind == "degree" for word in rest):
        yield from _farthest(names, equations, Clause(rest)) if len(equations) == 1 else ()
        return
    if any(word.kind == "name" and word.what in names.parameters for word in rest) or len(equations) == 2:
        yield from _parameter(names, equations, Clause(rest))
    elif len(equations) == 1:
        yield from _at(names, equations[0], Clause(rest))


def _equations(names: Names, words: list[Word]) -> tuple[list[Equation], list[Word]]:
    """Equations of measures within words, and the other words."""
    found: list[Equation] = []
    taken = set[int]()
    for sign in [k for k, word in enumerate(words) if word == Word("relation", "=")]:
        before, after = words[sign - 1 : sign], words[sign + 1 : sign + 2]
        if before and after and before[0].what in names.measures and after[0].kind in ("value", "name"):
            found.append(Equation(before[0].what, after[0].what))
            taken |= {sign - 1, sign, sign + 1}
    return found, [word for k, word in enumerate(words) if k not in taken]


def _at(names: Names, equation: Equation, rest: Clause) -> Groups:
    """A quantity at the instant; the time of it; how far something has come by then."""
    verbs = set(rest.all("verb")) - ({"leave"} if rest.has("quantity") else set())
    if not verbs <= _DESCRIBES or set(rest.all("instant")) - {*_PLACES, "at start"}:
        return
    if rest.has("verb", "leave") and rest.has("ask", "with", "for", "from"):
        return  # at which speed it leaves there: not how fast it is there
    names_ = [name for _, name in rest.names]
    ways = (*lookup.inclined(names, ""), *lookup.heights(names, ""))
    passed = any(way == equation.measure and lookup.rises(names, way, sense) for way, sense in ways)
    if passed and rest.has("mark", "while") and "fall" in verbs:  # it is there first on its way up
        return
    if rest.has("ask", "when", "soon", "long") or rest.all("quantity") == ["time"]:
        if len(names_) <= 1:
            yield [f"time when {equation}"]
        return
    if rest.has("instant", "at start"):
        return
    if rest.has("ask", "far") and set(rest.all("quantity")) <= {"height"}:
        ways = [way for way in lookup.ways(names, next(iter(names_), "")) if way != equation.measure]
        yield [f"change of {way} until {equation}" for way in ways]
        return
    if rest.has("verb", "reach"):
        rest = rest.without("part", "vertical", "horizontal")  # it passes the vertical
    if len(rest.all("quantity")) > 1:  # in equilibrium, theta = 0
        rest = rest.without("quantity", "equilibrium")
    kept = [w for w in rest.words if w.kind not in ("verb", "instant", "mark") and w != Word("preposition", ",")]
    if rest.has("ask", "fast"):
        kept = [w for w in rest.words if w.kind not in ("instant", "mark")]
    places = {"ground", *(name for name in names_ if name in names.bodies["ground"].lines)}
    kept = [w for w in kept if not (w.kind == "name" and w.what in places and len(names_) > 1)]
    for group in quantities(names, Clause(kept)):
        yield [f"{text} when {equation}" for text in group if text != equation.measure]


def _farthest(names: Names, equations: list[Equation], rest: Clause) -> Groups:
    """The value of a parameter with which something comes farthest: at which angle does it fly farthest, y = 0?"""
    named = [name for _, name in rest.names if name in names.parameters]
    others = [name for _, name in rest.names if name not in names.parameters]
    asked = [quantity for quantity in rest.all("quantity") if quantity not in ("horizontal range", "distance")]
    flies = rest.has("verb", "fly", "move", "hit") or rest.has("quantity", "horizontal range", "distance")
    found = named or (given.of_kind(names, asked[0]) if len(asked) == 1 else [])
    ways = [way for way in lookup.ways(names, "") if way != equations[0].measure and way in (others or [way])]
    ways = ways or [way for body in others for way in lookup.ways(names, body) if way != equations[0].measure]
    if rest.all("degree") == ["greatest"] and flies and len(found) == 1 and len(asked) <= 1:
        yield [f"value of {found[0]} for which {way} when {equations[0]} is largest" for way in ways]


def _parameter(names: Names, equations: list[Equation], rest: Clause) -> Groups:
    """The value of a parameter with which two measures have their values together."""
    named = [name for _, name in rest.names if name in names.parameters]
    others = [name for _, name in rest.names if name not in names.parameters]
    asked = rest.all("quantity")
    if len(equations) != 2 or len(named) > 1 or len(others) > 1 or not set(rest.all("verb")) <= _DESCRIBES:
        return
    if set(asked) - {*_SPEEDS, "angle", "height"} or len(asked) > 1 or set(rest.all("part")) - {"initial"}:
        return
    rest = rest.without("pronoun")
    if rest.has("ask", "when", "long", "soon", "where") or set(rest.all("instant")) - {*_PLACES}:
        return
    found = named or (given.of_kind(names, asked[0]) if asked else [])
    if len(found) == 1:
        first, second = equations
        is_high = second.measure in [name for name, _ in lookup.heights(names, "")] and second.value != "0"
        if is_high and first.measure in lookup.level(names, ""):  # a height is passed twice
            first, second = second, first
        yield [f"value of {found[0]} for which {first} when {second}"]
