"""For which value of a parameter a quantity is largest or least: where its slope changes sign.

All places at which the slope can change sign are found in closed form (`ranges.py`). Where it is positive up to a value
and negative behind it, over all values for which the formula is true, the quantity rises to that value and falls behind
it: it is the largest one, and no comparison of values is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message
from freebody.questions.base import Quantity, Wanted
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, as_parts, element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.answering.formula import Formula
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.numbers import number_at
from freebody.study.answering.parameter_domain import domain_of
from freebody.study.answering.ranges import RangeSearch
from freebody.study.answering.turned_round import PutBack, quantity_with
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.functions import functions
from freebody.symbolic.limits import derivative_by
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy

_WAVES = {"acos": "cos", "asin": "sin", "atan": "tan"}
_TWELFTHS = (2, 3, 4, 1, 5, 0)  # of pi: angles of the first quadrant
_OF_INSTANTS = ("coordinate", "speed", "acceleration", "time")  # kinds of symbols
_LINEARISED = 1e-5  # relative: what is found by a numerical linearisation
_BESIDE = 0.02  # of the value: beside it the quantity is less
_STEEP = 1.5  # times as large a quarter as far from a pole; 4 times at a simple one


@dataclass(frozen=True)
class _Monotone:
    """Where the slope has either sign. sign: of what is asked for, 1 the largest."""

    rises: RangeSearch
    falls: RangeSearch
    sign: int

    def summit(self, draw: Draw) -> Ratio | None:
        """The one value up to which it rises and behind which it falls, over all of the range; None where there is no
        such value."""
        first, then = (self.rises, self.falls) if self.sign > 0 else (self.falls, self.rises)
        up, down = first.intervals(draw), then.intervals(draw)
        if len(up) != 1 or len(down) != 1:
            return None
        end, begin = up[0][1].value, down[0][0].value
        return end if end is not None and begin is not None and end == begin else None

    def poles(self, draw: Draw, formula: Formula, index: int) -> list[Ratio]:
        """The values towards which it grows without bound from either side: there its divisor vanishes."""
        up, down = self.rises.intervals(draw), self.falls.intervals(draw)
        found = [end.value for _begin, end in up for begin, _end in down if end.value is not None and end == begin]
        assert isinstance(formula.element, Ratio)
        below = formula.element.denominator()
        return [x for x in found if below.field.follow(below, {index: x}).is_zero()] if self.sign > 0 else []


def find_extremal(setup: Setup, question: Question, formulas: Sequence[Formula]) -> Finding:
    """The value of the parameter, or the quantity there. Raises CannotAnswer where there is none inside of its range,
    or several places compete."""
    wanted = question.quantity.wanted
    assert wanted is not None
    field, model = setup.model.field, setup.model
    index = field.index(model.parameters[wanted.parameter])
    slopes: list[Ratio] = []
    for one in formulas:
        depends = index in field.ingredients(one.number)
        slopes.append(derivative_by(model, one.number, index) if depends else field.zero)
    if all(slope.is_zero() for slope in slopes):
        raise CannotAnswer(Message("that does not depend on {name}", name=wanted.parameter))
    meant = [*_masses(setup, index), *_places(setup, wanted, index)]
    cases = [
        replace(one, element=slope, needed=[*one.needed, *meant]) for one, slope in zip(formulas, slopes, strict=True)
    ]
    monotone = _Monotone(
        *(
            RangeSearch(setup, question, wanted.asking(relation=relation), cases, within_a_turn=True)
            for relation in (">", "<")
        ),
        sign=1 if wanted.end == "largest" else -1,
    )
    own = setup.draws[0]
    if len(formulas) == 1 and (poles := monotone.poles(own, formulas[0], index)):
        return _without_bound(setup, question, formulas[0], monotone, poles, index)
    place = monotone.summit(own)
    if place is None:
        raise CannotAnswer(_no_summit(monotone, own, wanted.parameter))
    place = _plain(place)
    formula = _true_there(setup, monotone, formulas, place)
    assert isinstance(formula.element, Ratio)
    there = field.lowest_terms(field.follow(formula.element, {index: place}))
    conditions = _conditions(setup, wanted, formula, place, index)
    evidence = _evidence(setup, question, formula, monotone, place, conditions)
    shown = compared(Symbol(wanted.parameter), "=", tidy(place))
    told = (
        Message("it rises up to {place} and falls behind it", place=shown)
        if monotone.sign > 0
        else Message("it falls up to {place} and rises behind it", place=shown)
    )
    notes = [reworded(told, shown)]
    if setup.system.parameters[wanted.parameter].value is not None:
        notes.append(Message("the number given for {name} is not used", name=wanted.parameter))
    element = place if wanted.asks_place else there
    return Finding(
        element, evidence, [*conditions, *real(element)], notes, has_value=setup.has_values, is_complete=True
    )


def _without_bound(
    setup: Setup, question: Question, formula: Formula, monotone: _Monotone, poles: Sequence[Ratio], index: int
) -> Finding:
    """Where the quantity grows without bound, as an amplitude does in resonance without damping."""
    wanted = question.quantity.wanted
    assert wanted is not None
    if not wanted.asks_place:
        shown = [compared(Symbol(wanted.parameter), "=", tidy(place)) for place in poles]
        raise CannotAnswer(Message("it grows without bound towards {places}", places=", ".join(shown)))
    conditions = list[Condition]()
    for place in poles:
        away = [c for c in formula.needed if not (c.relation == "!=" and _vanishes(c, place, index))]
        own = _conditions(setup, wanted, replace(formula, needed=away), place, index, may_bend=False)
        conditions += [c for c in (*own, *real(place)) if c not in conditions]
    evidence = _evidence_beside(setup, question, formula, monotone, poles, conditions)
    notes: list[str] = [Message("it grows without bound there")]
    if setup.system.parameters[wanted.parameter].value is not None:
        notes.append(Message("the number given for {name} is not used", name=wanted.parameter))
    element = poles[0] if len(poles) == 1 else tuple(poles)
    return Finding(element, evidence, conditions, notes, has_value=setup.has_values, is_complete=True)


def _vanishes(c: Condition, place: Ratio, index: int) -> bool:
    return c.element.field.follow(c.element, {index: place}).is_zero()


def _masses(setup: Setup, index: int) -> list[Condition]:
    """Where the bodies that a parameter makes have a mass: of a rod of the length L - c only c < L is meant."""
    found: list[Condition] = []
    for body in setup.system.moving:
        mass = setup.state.scalar(body.mass)
        if index in setup.model.field.ingredients(mass) and sign_of(mass) is Sign.UNKNOWN:
            found.append(Condition(mass, ">", Message("{body} has a mass", body=body.name)))
    return found


def _places(setup: Setup, wanted: Wanted, index: int) -> list[Condition]:
    """Where the quantity is meant: in the sections of its rod."""
    inside = wanted.of.meant_within(setup.system) if isinstance(wanted.of, Quantity) else ()
    elements = ((setup.state.scalar(expr), told) for expr, told in inside)
    return [Condition(x, ">=", told) for x, told in elements if index in setup.model.field.ingredients(x)]


def _plain(place: Ratio) -> Ratio:
    """acos(sqrt(2)/2) as pi/4: an arc of a number that is the sine, cosine or tangent of a part of pi."""
    field = place.field
    for g in place.generators():
        name, inside = field.arguments.get(g, ("", place))
        if name not in _WAVES or place != field.variable(g):
            continue
        fn = functions(field)
        for k in _TWELFTHS:
            angle = k * field.pi / 12
            if fn[_WAVES[name]](angle) == inside:
                return angle
    return place


def _true_there(setup: Setup, monotone: _Monotone, formulas: Sequence[Formula], place: Ratio) -> Formula:
    """The formula of the case in which the summit lies, at the model's own numbers; in no other case the quantity may
    be more (or less): across a border of cases it may jump."""
    own = setup.draws[0]
    (value,) = element_at(setup, place, own, own.start())
    if len(formulas) == 1:
        return formulas[0]
    true = monotone.rises.true_at(own, value)
    if not true:
        raise CannotAnswer(Message("it is largest or least on the border of two cases"))
    values = monotone.rises.values_between(own, formulas)
    (top,) = monotone.rises.values_at(own, value, [formulas[true[0]]])
    if any(monotone.sign * (other - top) > 0 for other in values):
        raise CannotAnswer(Message("it jumps between cases, and which is largest is not decided over them"))
    return formulas[true[0]]


def _no_summit(monotone: _Monotone, own: Draw, name: str) -> Message:
    up, down = monotone.rises.intervals(own), monotone.falls.intervals(own)
    if up and not down:
        return Message("it only rises as {name} grows: no value inside of the range is the one", name=name)
    if down and not up:
        return Message("it only falls as {name} grows: no value inside of the range is the one", name=name)
    return Message("it rises and falls in several parts of the range of {name}: which counts is not decided", name=name)


def _conditions(
    setup: Setup, wanted: Wanted, formula: Formula, place: Ratio, index: int, *, may_bend: bool = True
) -> list[Condition]:
    field = setup.model.field
    needed = [replace(c, element=field.lowest_terms(field.follow(c.element, {index: place}))) for c in formula.needed]
    untrue = CannotAnswer(Message("the formula is not true where it would be largest or least"))
    bends = _bends(setup, wanted, formula, place, index) if may_bend else []
    return insisted(
        [*domain_of(setup.system.parameters[wanted.parameter], place), *real(place), *needed, *bends], untrue
    )


def _bends(setup: Setup, wanted: Wanted, formula: Formula, place: Ratio, index: int) -> list[Condition]:
    """Where what depends on the instant has its largest value there, and not its least: by its second derivative."""
    field, model = setup.model.field, setup.model
    assert isinstance(formula.element, Ratio)
    if not any(field.generators[g].kind in _OF_INSTANTS for g in field.ingredients(formula.element)):
        return []
    second = derivative_by(model, derivative_by(model, formula.element, index), index)
    second = field.lowest_terms(field.follow(second, {index: place}))
    size = -second if wanted.end == "largest" else second
    which = Message("largest there") if wanted.end == "largest" else Message("least there")
    return [Condition(size, ">", which)] if sign_of(size) is Sign.UNKNOWN else []


def _evidence(
    setup: Setup,
    question: Question,
    formula: Formula,
    monotone: _Monotone,
    place: Ratio,
    conditions: Sequence[Condition],
) -> Evidence:
    """At every draw the same place comes out; the quantity by the numeric route is as the formula there, and less (or
    more) on either side."""
    wanted = question.quantity.wanted
    assert wanted is not None
    if not formula.is_put_back:  # the formula is checked where it is one; where it is largest follows from it alone
        return formula.evidence()
    route = Message("the value put in for the parameter, and values beside it, each by the numeric route")
    check = CrossCheck(question.text, route, MOTION_TOLERANCE if wanted.of.is_of_state else _LINEARISED)

    def numeric(draw: Draw, k: int, value: float) -> tuple[PutBack, float]:
        values = draw.values | {wanted.parameter: value}
        made = PutBack(k, draw.with_values(values, setup.system), 1.0)
        if wanted.of.is_of_state:
            return made, float(quantity_with(setup, at_start, wanted.of, formula, made))
        return made, as_parts(number_at(setup, wanted.of, question.event, made.draw))[0]

    dimension, at_start = (
        wanted.of.dimension,
        question if question.event is not None else replace(question, at_start=True),
    )

    def compare(item: tuple[int, Draw]) -> None:
        k, draw = item
        start = draw.start()
        if not all(holds(setup, c, draw, start) for c in conditions):
            return
        found = monotone.summit(draw)
        if found is None and len(monotone.rises.truths) > 1:
            return  # other cases come with these numbers
        if found is None or _plain(found) != place:
            raise CannotAnswer(Message("which ends count depends on more than could be told in formulas"))
        (at,) = element_at(setup, place, draw, start)
        made, top = numeric(draw, k, at)
        assert isinstance(formula.element, Ratio)
        exact = element_at(setup, formula.element, made.draw, made.draw.start())
        beside = [numeric(draw, k, at * (1 + way * _BESIDE))[1] for way in (1, -1)]
        if not all(monotone.sign * (top - other) > 0 for other in beside):
            raise CannotAnswer(Message("the numeric route does not confirm that it is largest or least there"))
        check.compare(draw, exact, top, lambda: magnitude(dimension, made.draw.seen(made.draw.start())))

    return check.gather(enumerate(setup.draw_stream()), compare).evidence()


def _evidence_beside(
    setup: Setup,
    question: Question,
    formula: Formula,
    monotone: _Monotone,
    poles: Sequence[Ratio],
    conditions: Sequence[Condition],
) -> Evidence:
    """At every draw the same poles come out; beside each the quantity by the numeric route is as the formula, and grows
    towards it from either side."""
    wanted = question.quantity.wanted
    assert wanted is not None
    of, name = wanted.of, wanted.parameter
    index = setup.model.field.index(setup.model.parameters[name])
    route = Message("values beside it put in for the parameter, each by the numeric route")
    check = CrossCheck(question.text, route, MOTION_TOLERANCE if wanted.of.is_of_state else _LINEARISED)

    def compare(draw: Draw) -> None:
        start = draw.start()
        if not all(holds(setup, c, draw, start) for c in conditions):
            return
        if monotone.poles(draw, formula, index) != list(poles):
            raise CannotAnswer(Message("which ends count depends on more than could be told in formulas"))
        for at in element_at(setup, tuple(poles), draw, start):
            for way in (_BESIDE, -_BESIDE):
                values = [draw.values | {name: at * (1 + part * way)} for part in (0.25, 1.0)]
                near, far = (draw.with_values(v, setup.system) for v in values)
                found = [as_parts(number_at(setup, of, question.event, one))[0] for one in (near, far)]
                if not found[0] > _STEEP * found[1]:
                    raise CannotAnswer(Message("the numeric route does not confirm that it is largest or least there"))
                assert isinstance(formula.element, Ratio)
                check.compare(draw, element_at(setup, formula.element, near, near.start()), found[0])

    return check.gather(setup.draw_stream(), compare).evidence()
