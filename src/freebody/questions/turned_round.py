"""Questions turned round: for which value, or for which values, of a parameter something is so.

value of v0 for which velocity of x = 0 when x = d        value of d for which horizontal reaction of hinge is zero
range of v0 for which tension of rope >= 0 when theta = 180 deg        least v0 so that x reaches d
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

from freebody.language.expression import ZERO, Expr, Symbol
from freebody.language.sentences import Argument, Sentence
from freebody.language.units import Dimension
from freebody.questions.base import Described, Quantity, Wanted
from freebody.questions.forms import NAME

if TYPE_CHECKING:
    from freebody.model.names import Names

FORM = """value of PARAMETER for which QUANTITY = EXPRESSION [at start | when EVENT]
    range of PARAMETER for which QUANTITY > | < | >= | <= EXPRESSION [at start | when EVENT]
    least | largest PARAMETER so that QUANTITY > | < | >= | <= EXPRESSION [at start | when EVENT]
    range of PARAMETER for which MEASURE reaches VALUE | for which BODY turns fully
    range of PARAMETER for which NAME stays taut | stays on NAME | rolls without slipping | tips
    value of PARAMETER for which MEASURE stays constant
    range of PARAMETER for which QUANTITY stays below | stays above EXPRESSION, or MEASURE [never] turns back | escapes
    range of PARAMETER for which EVENT [before EVENT | at once], or the equilibrium is stable
    range of PARAMETER for which the steady motion exists | is stable [when MEASURE = VALUE]
    QUANTITY as PARAMETER -> EXPRESSION | grows
    value of PARAMETER for which QUANTITY is largest | least      largest | least QUANTITY over PARAMETER
    range of PARAMETER for which it tips before it slides as PARAMETER grows
    value of PARAMETER for which MEASURE just reaches VALUE"""
_SO_THAT = "(?:for which|so that|such that|with which|at which)"
VALUE_FOR = re.compile(rf"^(?:the )?(?:values?|range) of (?P<parameter>{NAME}) {_SO_THAT} (?P<relation>.+)$")
PARAMETER_FOR = re.compile(rf"^(?P<parameter>{NAME}) {_SO_THAT} (?P<relation>.+)$")
_LEAST = r"(?P<least>least|smallest|minimum|minimal|lowest|shortest)"
_LARGEST = r"(?P<largest>largest|greatest|maximum|maximal|highest|longest)"
EXTREME_FOR = re.compile(
    rf"^(?:the )?(?:{_LEAST}|{_LARGEST}) (?:value of )?(?P<parameter>{NAME}) {_SO_THAT} (?P<relation>.+)$"
)
_TO = r"(?:->|→|tends? to|goes? to|approach(?:es)?)"
_BEYOND = r"(?:without (?:bound|limit|end)|very large|large|infinite|beyond all bounds)"
_LARGE = rf"(?:(?:grows?|increases?)(?: {_BEYOND})?|(?:becomes?|gets?|is) {_BEYOND})"
PARAMETER_IS = re.compile(
    rf"^(?P<of>.+?) (?:when|for|if|at|with) (?:the )?(?P<parameter>{NAME}) ?(?:=|is|equals) ?(?P<value>[^=<>]+)$"
)
LIMIT = re.compile(
    rf"^(?:the )?(?:limit(?:ing value)? of (?:the )?)?(?P<of>.+?) (?:as|for|when|where|in the limit) (?:the )?"
    rf"(?P<parameter>{NAME}) ?(?:{_TO} ?(?P<value>.+?)|(?P<large>{_LARGE})|(?P<small>vanishes|becomes (?:very )?small))"
    rf"(?P<timed> at (?:the )?start| when .+| at t ?= ?.+| after .+)?$"
)
_WHICH = (
    r"(?:(?P<largest>largest|greatest|maximum|maximal|highest|longest)|(?P<least>least|smallest|minimum|minimal|lowest"
    r"|shortest))"
)
IS_EXTREMAL = re.compile(
    rf"^(?P<of>.+?) (?:is|becomes) (?:the |a |at (?:its|a) )?{_WHICH}(?P<timed> at (?:the )?start| when .+)?$"
)
OVER_PARAMETER = re.compile(
    rf"^(?:the )?{_WHICH}(?: value)?(?: of)? (?:the )?(?P<of>.+?) over (?:all )?(?:the )?(?P<parameter>{NAME})"
    r"(?P<timed> at (?:the )?start| when .+)?$"
)
INFINITE = ("oo", "∞", "infinity", "inf", "+oo", "+∞")
_WORDS = {
    "is positive": "> 0",
    "is negative": "< 0",
    "is not negative": ">= 0",
    "is not positive": "<= 0",
    "is at least": ">=",
    "is at most": "<=",
    "is not less than": ">=",
    "is not more than": "<=",
    "is (?:greater|more|larger) than": ">",
    "is (?:less|smaller) than": "<",
    "exceeds": ">",
    "does not exceed": "<=",
    "≥": ">=",
    "≤": "<=",
}
_INEQUALITY = re.compile(r"^(?P<left>.+?)\s*(?P<sign>>=|<=|>|<)\s*(?P<right>.+)$")
REACHES_PLACE = re.compile(
    rf"^(?:it|(?:the )?(?P<who>{NAME})) (?:reaches|gets to|comes to|gets as far as|passes) "
    rf"(?P<what>{NAME}) ?= ?(?P<value>.+)$"
)
_REACHES = re.compile(r"^(?P<what>.+?) (?:reaches|gets to|comes to|gets as far as) (?P<value>.+)$")
# an equation, or what is zero; the sign stands before an event, which has one of its own
RELATION = re.compile(
    r"^(?P<left>.+?)(?:\s*=\s*|\s+(?:is equal to|equals|is)\s+)(?P<right>.+)$|^(?P<zero>.+?)\s+(?:vanishes|is zero)$"
)
# the same behind an event, of a quantity that stands before it alone: time when y = 0 is 3 s
AFTER_EVENT = re.compile(r"^(?P<event>.+\S)\s*(?:=|\b(?:is equal to|equals|is)\b)\s*(?P<right>\S.*)$")


@dataclass(frozen=True)
class ValueFor(Quantity, kind="value for"):
    """The value of a parameter for which a quantity has a value; the number that the file gives for the parameter is
    left out."""

    parameter: str
    of: Quantity
    target: Expr
    measured: Dimension
    shown_unit: str
    text: str = ""  # the quantity in words, with its event
    relation: str = "="
    end: Literal["", "least", "largest", "grows"] = ""
    asks_place: bool = True  # whether it is the parameter that is asked for, and not the quantity there

    example = """
parameters: {m: 2 kg, F: 5 N, a: 3 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {push: {force: {at: ball, along: right, magnitude: F}}}
measures: {x: x of ball}
questions: {it: value of F for which acceleration of x = a}
"""

    @property
    def dimension(self) -> Dimension:
        return self.measured

    @property
    def unit(self) -> str:
        return self.shown_unit

    @property
    def wanted(self) -> Wanted:
        return self

    def asking(self, *, relation: str | None = None, asks_place: bool = True) -> ValueFor:
        """The same quantity asked about in another way: with a relation to zero, or for the place."""
        if relation is None:
            return replace(self, asks_place=asks_place)
        return replace(self, target=ZERO, relation=relation, end="")

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)

    @property
    def of_what_stays(self) -> Quantity | None:
        plain = self.of.of_what_stays
        return None if plain is None else replace(self, of=plain)

    @property
    def is_of_state(self) -> bool:
        return self.of.is_of_state

    @property
    def is_of_parameters(self) -> bool:
        return self.of.is_of_parameters

    @property
    def may_jump(self) -> bool:
        return self.of.may_jump

    @property
    def kinematic_order(self) -> int | None:
        return self.of.kinematic_order

    def sentence(self, system: Described) -> Sentence | None:
        what = self.of.sentence(system)
        if what is None:
            return None
        return Sentence("what.value_for", {"parameter": Symbol(self.parameter), "what": what, "target": self.target})


def relation_of(head: str, event: str | None) -> tuple[str, str, str | None] | None:
    """The two sides of an equation, and its event; None where there is no equation."""
    found = RELATION.match(head)
    if found is not None:
        return (found["zero"], "0", event) if found["zero"] else (found["left"], found["right"].strip(), event)
    behind = None if event is None else AFTER_EVENT.match(event)
    return None if behind is None else (head, behind["right"].strip(), behind["event"])


_STEADILY = re.compile(
    r"^(?P<left>.+?)(?P<sign>\s*(?:>=|<=|[=<>≥≤])\s*|\s+(?:is|equals)\s+)(?P<right>.+?)"
    r"(?P<steadily> in (?:the )?steady (?:motion|precession|turning)| (?:in|at) (?:the )?equilibrium| at rest)"
    r"(?P<timed> when .+)?$"
)


_STABLE_AT = re.compile(
    rf"^(?:the )?(?:(?:steady )?(?:motion|position|place|equilibrium|state) )?(?P<at>{NAME} ?= ?\S.*?)"
    r"(?: in (?:the )?steady (?:motion|precession|turning))? is (?P<un>un|not )?stable$"
)


def steadily(relation: str) -> str:
    """theta = 30 deg in steady motion, as theta in steady motion = 30 deg; so in equilibrium. theta = 0 is stable, as
    the steady motion is stable when theta = 0: rest is such a motion, too."""
    if (stable := _STABLE_AT.match(relation)) is not None:
        return f"the steady motion is {stable['un'] or ''}stable when {stable['at']}"
    return _STEADILY.sub(lambda m: f"{m['left']}{m['steadily']}{m['sign']}{m['right']}{m['timed'] or ''}", relation)


def _with_signs(relation: str) -> str:
    """With signs in place of the words of an inequality."""
    for words, sign in _WORDS.items():
        relation = re.sub(rf"(?:\b|(?<=\s)){words}(?=\s|$)", sign, relation)
    return relation


def inequality_of(relation: str) -> tuple[str, str, str] | None:
    """The left side, the sign and the right side of an inequality; None where there is none."""
    found = _INEQUALITY.match(_with_signs(relation))
    return None if found is None else (found["left"].strip(), found["sign"], found["right"].strip())


_LOCKS = re.compile(rf"^(?:the )?(?P<of>{NAME}) (?:is self-?locking|locks itself)$")


def locking(names: Names, relation: str) -> str:
    """That a screw is self-locking, as an inequality of its friction and its slope; of a contact it is a state."""
    found = _LOCKS.match(relation)
    return relation if found is None or not has_thread(names, found["of"]) else f"self-locking of {found['of']} >= 0"


def has_thread(names: Names, name: str) -> bool:
    """Whether a name is that of a screw or a worm."""
    if (connection := names.connections.get(name)) is None:
        return False
    with names.quietly():
        return not isinstance(connection.thread(names), str)


_ALWAYS = r"(?:always |all the time )?(?:stays?|remains?|keeps?|is always)(?: always)?"
_STAYS: tuple[tuple[str, str, str], ...] = (
    (rf"{_ALWAYS} (?:below|under|less than|smaller than)", "greatest", "<"),
    (
        rf"{_ALWAYS} at most|never (?:exceeds|is above|gets above|goes above|is more than)|does not exceed",
        "greatest",
        "<=",
    ),
    (rf"{_ALWAYS} (?:above|over|more than|greater than|larger than)", "least", ">"),
    (rf"{_ALWAYS} at least|never (?:is below|gets below|goes below|falls below|is less than)", "least", ">="),
)
_STAYING = [(re.compile(rf"^(?P<of>.+?) (?:{words}) (?P<value>.+)$"), end, sign) for words, end, sign in _STAYS]
_OF_A_TURN = re.compile(r"^(?P<of>.+?)\s*(?P<sign>>=|<=|[<>≥≤])\s*(?P<value>.+?)(?P<turn> over a turn.*)$")
_STAYS_CONSTANT = re.compile(
    rf"^(?:the )?(?P<of>{NAME}) (?:does not change|is constant|(?:{_ALWAYS}) (?:constant|unchanged|the same|as it is))$"
)
_BACK = re.compile(rf"^(?:the )?(?P<of>{NAME}) (?:turns (?:back|round|around)|reverses)(?: again)?$")


def over_the_motion(relation: str) -> str:
    """What is to be so all the time, as something of the extremes: x stays below d, as greatest x < d."""
    for pattern, end, sign in _STAYING:
        found = pattern.match(relation)
        if found is not None:
            value, over, turn = found["value"].partition(" over a turn")
            return f"{end} {found['of']}{over}{turn} {sign} {value}"
    if (found := _OF_A_TURN.match(_with_signs(relation))) is not None and not found["of"].startswith(
        ("least ", "greatest ")
    ):
        end = "least" if found["sign"] in (">", ">=", "≥") else "greatest"  # x > a over a turn: at each of its places
        return f"{end} {found['of']}{found['turn']} {found['sign']} {found['value']}"
    return relation


def staying(relation: str) -> str | None:
    """The measure that is to stay constant; None where nothing of the kind is said."""
    found = _STAYS_CONSTANT.match(relation)
    return None if found is None else found["of"]


def without_just(relation: str) -> tuple[str, bool]:
    """Words without `just`, and whether it was among them: x just reaches d, it is about to slip."""
    plain = re.sub(r"\bis (?:just )?about to (?P<verb>\w+)", lambda m: f"just {m['verb']}s", relation)
    plain, n = re.subn(r"\b(?:only |but )?just (?:barely )?(?!before\b|after\b)", "", plain)
    return " ".join(plain.split()), n > 0


def reached_in(relation: str) -> str | None:
    """That a measure reaches a value, or turns back, as an event; None where nothing of the kind is said."""
    if (back := _BACK.match(relation)) is not None:
        return f"{back['of']} turns back"
    found = _REACHES.match(relation)
    return None if found is None or " when " in relation else f"{found['what']} = {found['value']}"


@dataclass(frozen=True)
class ValueForOnTheWay(ValueFor):
    """The same of what is counted from the start to an event."""

    scope = "course"


@dataclass(frozen=True)
class RangeFor(ValueFor, kind="range for"):
    """All values of a parameter for which an inequality holds, or an event comes; or the least or largest of them."""

    example = """
parameters: {m: 2 kg, F: 5 N, a: 3 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {push: {force: {at: ball, along: right, magnitude: F}}}
measures: {x: x of ball}
questions: {it: range of F for which acceleration of x > a}
"""

    def sentence(self, system: Described) -> Sentence | None:
        what = self.of.sentence(system)
        if what is None or self.relation in (REACHED, SO):
            return None
        args: dict[str, Argument] = {"parameter": Symbol(self.parameter), "what": what, "target": self.target}
        return Sentence(f"what.range_{self.end or 'all'}_{_KEYS[self.relation]}", args)


REACHED = "is reached"  # instead of a relation: the event of the question comes
TENDS = "tends"  # the same: the quantity is asked for as the parameter tends to the target
EXTREMAL = "is extremal"  # the same: the quantity is largest, or least, at the value that is asked for
SO = "is so"  # the same: what is said of the motion, or of a state, is so
_KEYS = {">": "above", ">=": "from", "<": "below", "<=": "up_to"}


@dataclass(frozen=True)
class RangeForOnTheWay(RangeFor):
    """The same of what is counted from the start to an event."""

    scope = "course"


@dataclass(frozen=True)
class ExtremalFor(ValueFor, kind="extremal for"):
    """The value of a parameter for which a quantity is largest or least, or the quantity there.

    asks_place: the parameter is asked for."""

    relation: str = EXTREMAL

    example = """
parameters: {v: 12 m/s, alpha: 40 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v*cos(alpha), rate(y): v*sin(alpha)}
questions: {it: value of alpha for which x when y = 0 is largest}
"""

    def sentence(self, system: Described) -> Sentence | None:
        what = self.of.sentence(system)
        if what is None or self.end not in ("largest", "least"):
            return None
        key = f"what.extremal_{'place' if self.asks_place else 'value'}_{self.end}"
        return Sentence(key, {"parameter": Symbol(self.parameter), "what": what})


@dataclass(frozen=True)
class ExtremalForOnTheWay(ExtremalFor):
    """The same of what is counted from the start to an event."""

    scope = "course"


@dataclass(frozen=True)
class LimitOf(ValueFor, kind="limit of"):
    """To what a quantity tends as a parameter tends to a value, or grows without bound.

    target: the value; end: grows, where there is none."""

    relation: str = TENDS

    example = """
parameters: {m: 2 kg, M: 3 kg, F: 5 N}
bodies: {ball: {particle: {mass: m + M}}}
loads: {push: {force: {at: ball, along: right, magnitude: F}}}
measures: {x: x of ball}
questions: {it: acceleration of x as M -> 0}
"""

    def sentence(self, system: Described) -> Sentence | None:
        what = self.of.sentence(system)
        if what is None:
            return None
        key = "what.limit_grows" if self.end == "grows" else "what.limit"
        return Sentence(key, {"parameter": Symbol(self.parameter), "what": what, "target": self.target})


@dataclass(frozen=True)
class LimitOfOnTheWay(LimitOf):
    """The same of what is counted from the start to an event."""

    scope = "course"


@dataclass(frozen=True)
class RangeForAtRest(RangeFor):
    """The same of a state of rest."""

    scope = "rest"


@dataclass(frozen=True)
class RangeForSmallMotion(RangeFor):
    """The same of an equilibrium."""

    scope = "small motion"
