"""Events of measures, of other quantities and of the clock, in words: x = h, tension of rope = m*g, t = T."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from freebody.errors import ExpressionError
from freebody.language.expression import (
    ZERO,
    Call,
    Expr,
    Symbol,
    add,
    differentiate,
    free_symbols,
    replace_rates,
    substitute,
)
from freebody.language.notation import to_python
from freebody.language.parser import parse
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, TIME, Dimension
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT
from freebody.model.phrases import PHRASES, composed, measure_of
from freebody.questions.base import Path, Quantity
from freebody.questions.clock import ENDLESS, TIME_SINCE, Clock, time_asked
from freebody.questions.compared import compared
from freebody.questions.ends import GREATEST, LEAST
from freebody.questions.event_base import QuestionEvent
from freebody.questions.event_quantities import quantity_of_instant, sides_of_equation
from freebody.questions.final_values import read_share
from freebody.questions.forms import NAME, POINT
from freebody.questions.operands import TURNS_BACK

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class TurnsBack(QuestionEvent):
    """A measure comes to rest and goes back, where it could stay at rest as well."""


@dataclass(frozen=True)
class Meeting(QuestionEvent):
    """A body gets to the place to which a connection leads it: what is between them vanishes."""

    body: str
    place: str

    @property
    def comes(self) -> Message:
        return Message("{body} reaches {place}", body=self.body, place=self.place)

    @property
    def never(self) -> Message:
        return Message("{body} never reaches {place} after the start", body=self.body, place=self.place)


@dataclass(frozen=True)
class OfQuantity(QuestionEvent):
    """A quantity of the state reaches a value: a force, a speed, an energy. `measure` and `value` are the place at
    which it does."""

    quantity: Quantity
    target: Expr


@dataclass(frozen=True)
class QuantityEvent(OfQuantity):
    """The same as it is asked, before a place is found (`study/answering/places_of_quantities.py`): `measure` and
    `value` mean nothing yet. phrase, value_text: the quantity and the value in the words of the question."""

    phrase: str
    value_text: str


@dataclass(frozen=True)
class ChangeEvent(QuestionEvent):
    """A measure has changed by `change` since the start, as it is asked, before its value there is found
    (`study/answering/places_of_quantities.py`): `value` means nothing yet. phrase, value_text: the measure and the
    change in the words of the question. is_distance: whichever way the motion begins."""

    change: Expr
    phrase: str
    value_text: str
    is_distance: bool


class Anywhere:
    """Any place or instant of the motion: what is asked is a function of it (`study/answering/functions.py`)."""

    name: str

    @staticmethod
    def on(names: Names, name: str) -> AnyPlace | AnyInstant | None:
        """Any value of a measure, or of the time `t`; None of anything else."""
        if name in names.measures:
            return AnyPlace(names.measures[name], 0, Symbol(name), f"{name} = {name}", name)
        return AnyInstant(Symbol(name), f"{name} = {name}", name) if name == TIME_SINCE else None

    @property
    def dimension(self) -> Dimension:
        """Of what it is a function of."""
        raise NotImplementedError

    def at(self, p: str) -> AskedEvent:
        """The event that it is p."""
        raise NotImplementedError


@dataclass(frozen=True)
class AnyPlace(Anywhere, QuestionEvent):
    """A measure is anywhere. `value` is the measure itself."""

    name: str  # pyrefly: ignore[bad-override]

    @property
    def dimension(self) -> Dimension:
        return self.measure.dimension

    def at(self, p: str) -> AskedEvent:
        return QuestionEvent(self.measure, 0, Symbol(p), f"{self.name} = {p}")


@dataclass(frozen=True)
class AnyInstant(Anywhere, Clock):
    """The clock shows any time since the start, which is `time` itself."""

    name: str  # pyrefly: ignore[bad-override]

    @property
    def dimension(self) -> Dimension:
        return TIME

    def at(self, p: str) -> AskedEvent:
        return Clock(Symbol(p), f"{self.name} = {p}")


@dataclass(frozen=True)
class ExtremeEvent(QuestionEvent):
    """A measure, or a quantity of the state, is at its greatest or least of all of the motion, as it is asked, before
    it is found where that is (`study/answering/places_of_extremes.py`): `measure` and `value` mean nothing yet.
    quantity: None where a measure is meant; phrase: what is meant in the words of the question."""

    end: Literal["greatest", "least"]
    phrase: str
    quantity: Quantity | None


@dataclass(frozen=True)
class FarthestPlace(QuestionEvent):
    """A measure is at the place of its extreme: `value` is what it is there, or, of order 1, it is where it first
    turns. side: +1 where that is the greatest."""

    side: int

    @property
    def comes(self) -> Message:
        return Message("it turns there")


@dataclass(frozen=True)
class Peak(QuestionEvent):
    """A quantity of the state stops growing, or falling: its slope along the motion vanishes. `measure` and `value`
    mean nothing."""

    quantity: Quantity

    @classmethod
    def of(cls, quantity: Quantity, text: str) -> Peak:
        return cls(Composed(ZERO, (), DIMENSIONLESS), 1, ZERO, text, quantity)


AskedEvent = QuestionEvent | Clock


_RATE_OF = re.compile(r"(?:rate|velocity) of (\w+)")


def read_event(names: Names, text: str, path: Path) -> AskedEvent | None:
    """The event that a text states; None, with a problem noted, where it states none."""
    time = None if "t" in names.measures else time_asked(text)
    if time == "":
        return Clock(None, ENDLESS)
    if time is not None:
        return Clock(names.formula(time, TIME, *path), text)
    n_before = len(names.problems)
    if (share := read_share(names, text, path)) is not None or len(names.problems) > n_before:
        return share
    turning = TURNS_BACK.match(text)
    if turning is not None:
        turned = _measured(names, turning["what"], path)
        return None if turned is None else QuestionEvent(turned, 1, ZERO, text)
    changed = _CHANGED.match(text)
    if changed is not None and (not changed["moves"] or is_measure(names, changed["what"])):
        moved = _measured(names, changed["what"], path)
        by = None if moved is None else names.formula(changed["by"], moved.dimension, *path)
        if moved is None or by is None:
            return None
        return ChangeEvent(moved, 0, Symbol(""), text, by, changed["what"], changed["by"], bool(changed["moves"]))
    if (extreme := _EXTREME.match(text)) is not None:
        return _extreme(names, text, extreme, path)
    if (met := _meeting(names, text, path)) is not None:
        return met if isinstance(met, Meeting) else None
    found = re.match(r"^(?P<what>.+?)\s*(?:=| reaches | is | equals )\s*(?P<value>.+)$", text)
    if found is None:
        names.problem(Message("cannot read the condition '{text}'; write for example x = h", text=text), *path)
        return None
    both = found["what"].strip(), found["value"].strip()
    rates = [_RATE_OF.fullmatch(side) for side in both]
    if all(side is not None and side[1] in names.measures for side in rates):  # of two measures
        what, stated = (f"rate({side[1]})" for side in rates if side is not None)
    else:
        what, stated = sides_of_equation(names, *both)
    if (sides := _with_measures(names, what, stated)) is not None:
        return QuestionEvent(sides[0], sides[1], -sides[2], text)
    if (several := _of_several(names, what)) is not None:
        measure, order, constant = several
        value = compared(names, stated, measure.dimension / TIME**order, *path)
        return QuestionEvent(measure, order, value - constant, text)
    phrase = what
    order: Literal[0, 1] = 0
    for pattern in (r"rate\((.+)\)", r"(?:rate|velocity|speed) of (.+)", r"(.+)'", r"(.+)_dot"):
        inner = re.fullmatch(pattern, what)
        if inner and what not in names.measures:
            order, what = 1, inner[1].strip()
            break
    if order == 0 and what in names.states:  # the rate of its integral
        state = names.states[what]
        return QuestionEvent(state.integral, 1, compared(names, stated, state.dimension, *path), text)
    if (of := quantity_of_instant(names, what, phrase, path)) is not None:
        measure = _any_measure(names)
        value = compared(names, stated, of.dimension, *path)
        if (place := of.place_of(names, value)) is not None:
            return QuestionEvent(place[0], 0, place[1], text)
        return QuantityEvent(measure, 0, Symbol(""), text, of, value, phrase, stated)
    measure = measure_of(names, what, *path)
    if measure is None:
        return None
    if (other := _other_side(names, stated, order)) is not None:
        between = _between(names, measure, *other, path)
        return None if between is None else QuestionEvent(between, order, ZERO, text)
    dimension = measure.dimension / TIME**order
    return QuestionEvent(measure, order, compared(names, stated, dimension, *path), text)


_CHANGED = re.compile(r"^(?P<what>.+?) (?:(?P<moves>has moved|moves)(?: by)?|(?:has changed|changes) by) (?P<by>.+)$")
_EXTREME = re.compile(
    rf"^(?:the )?(?P<what>.+?) (?:is|becomes|has|takes|reaches|is at)(?: at)?(?: (?:its|the|a))? "
    rf"(?:(?P<greatest>{GREATEST})|{LEAST})(?: value)?$"
)
_SPEED = re.compile(r"^(?P<kind>(?:angular )?speed)$")


def _extreme(names: Names, text: str, found: re.Match[str], path: Path) -> ExtremeEvent | None:
    """The event that something is at its greatest or least."""
    what = found["what"].strip()
    end: Literal["greatest", "least"] = "greatest" if found["greatest"] else "least"
    if _SPEED.match(what):  # of the only thing that moves
        moving = [b.name for b in names.bodies.values() if b.name != GROUND and not b.fixed]
        what = f"{what} of {moving[0]}" if len(moving) == 1 else what
    if (several := _of_several(names, what)) is not None and several[1] == 0:
        what = what if re.fullmatch(r"\([^()]*\)", what) else f"({what})"
        return ExtremeEvent(several[0], 0, Symbol(""), text, end, what, None)
    if is_measure(names, what):
        measure = measure_of(names, what, *path)
        return None if measure is None else ExtremeEvent(measure, 0, Symbol(""), text, end, what, None)
    of = quantity_of_instant(names, what, what, path)
    if of is None:
        names.problem(Message("cannot read the condition '{text}'; write for example x = h", text=text), *path)
        return None
    return ExtremeEvent(_any_measure(names), 0, Symbol(""), text, end, what, of)


def _any_measure(names: Names) -> Measure:
    """What stands for the place of a motion until that is found: a measure, or where a body is."""
    body = next((b for b in names.bodies.values() if b.name != GROUND and not b.fixed), names.bodies[GROUND])
    return next(iter(names.measures.values()), Displacement(body.center, names.ground_origin, RIGHT))


def is_measure(names: Names, text: str) -> bool:
    """Whether a text names a measure, or states one."""
    return text in names.measures or any(phrase.pattern.match(text) for phrase in PHRASES)


def _measured(names: Names, text: str, path: Path) -> Measure | None:
    """A measure, or an expression in measures: x1 - x2."""
    several = _of_several(names, text)
    return several[0] if several is not None and several[1] == 0 else measure_of(names, text, *path)


def _of_several(names: Names, text: str) -> tuple[Measure, Literal[0, 1], Expr] | None:
    """An expression in measures and parameters, as cos(theta), or what is linear in rates, as rate(x2) - rate(x1): the
    rate of the same in the measures, and a constant. None where a text is none of them."""
    try:
        expr = parse(text)
    except ExpressionError:
        return None
    used = free_symbols(expr) & names.measures.keys()
    is_plain = isinstance(expr, Symbol) or (
        isinstance(expr, Call) and isinstance(expr.argument, Symbol) and expr.function == "rate"
    )
    if is_plain or not used or not free_symbols(expr) <= {*names.measures, *names.parameters}:
        return None
    rates = {name: Symbol(f"@rate_{name}") for name in sorted(used)}
    in_rates = replace_rates(expr, rates)
    if in_rates == expr:
        with names.quietly():
            measure = composed(names, text)
        return None if measure is None else (measure, 0, ZERO)
    moving = {rate.name for rate in rates.values()}
    slopes = {name: differentiate(in_rates, rate.name) for name, rate in rates.items()}
    constant = substitute(in_rates, dict.fromkeys(moving, ZERO))
    changing = moving | names.measures.keys()
    if any(free_symbols(x) & changing for x in (constant, *slopes.values())):
        return None
    with names.quietly():
        measure = composed(names, to_python(add(*(slope * Symbol(name) for name, slope in slopes.items()))))
    return None if measure is None else (measure, 1, constant)


def _with_measures(names: Names, what: str, value: str) -> tuple[Measure, Literal[0, 1], Expr] | None:
    """What vanishes where a measure is as great as an expression in others, as y = x*tan(b); None where no measure
    stands in the value, or nothing but a multiple of one."""
    try:
        used = free_symbols(parse(value)) & names.measures.keys()
    except ExpressionError:
        return None
    is_plain = what in names.measures and used and _other_side(names, value, 0) is None
    return _of_several(names, f"({what}) - ({value})") if is_plain and "rate" not in value else None


_FACTOR = r"(?:(?P<factor>[^()=]+?)\s*\*\s*)?"
_OTHER_PLACE = re.compile(rf"^{_FACTOR}(?P<of>.+)$")
_OTHER_RATE = re.compile(
    rf"^{_FACTOR}(?:rate\((?P<of>.+)\)|(?:rate|velocity|speed) of (?P<of_words>.+)|(?P<of_name>{NAME})(?:'|_dot))$"
)


def _other_side(names: Names, text: str, order: int) -> tuple[str, str] | None:
    """What stands on the right is another measure, or its rate: its factor and its name or phrase; None where it is a
    formula in parameters."""
    found = (_OTHER_RATE if order else _OTHER_PLACE).match(text)
    if found is None or text in names.parameters:
        return None
    of = next(x for key, x in found.groupdict().items() if key != "factor" and x).strip()
    return (found["factor"] or "1", of) if is_measure(names, of) else None


def _between(names: Names, measure: Measure, factor: str, of: str, path: Path) -> Measure | None:
    """A measure less a multiple of another one: it vanishes where both are alike."""
    other = measure_of(names, of, *path)
    if other is None:
        return None
    times = names.formula(factor, measure.dimension / other.dimension, *path)
    one, two = (next(n for n in (k, f"{k}_") if n not in names.parameters) for k in ("one_side", "other_side"))
    parts = ((one, measure), (two, other))
    return Composed(Symbol(one) - times * Symbol(two), parts, measure.dimension)


_MEETS = re.compile(
    rf"^(?:the )?(?P<who>{NAME}) (?:reaches|arrives at|gets to|hits|strikes|touches|meets) (?:the )?(?P<place>{POINT})$"
)


def leads_to(names: Names, body: str, place: str) -> list[str]:
    """The connections that lead a body to a place, as the rope by which it is drawn to a pulley."""
    return [name for name, c in names.connections.items() if c.room_between(names, body, place) is not None]


def _meeting(names: Names, text: str, path: Path) -> Meeting | Message | None:
    """The event that a body gets to where a connection leads it; a reason, noted, where it never does."""
    found = _MEETS.match(text.strip())
    leading = [] if found is None else leads_to(names, found["who"], found["place"])
    if found is None or not leading:
        return None
    room = names.connections[leading[0]].room_between(names, found["who"], found["place"])
    if isinstance(room, Message):
        names.problem(room, *path)
        return room
    return None if room is None else Meeting(room, 0, ZERO, text, found["who"], found["place"])
