"""The least and the largest value of a quantity over a turn of an angle it depends on.

The derivative along the angle is a quotient in the field. Where its numerator vanishes can be an extremum, where the
denominator of the quantity does it grows without bound; what is under a root must not become negative on the way. All
three are questions for the zeros of factors, which `turning.py` finds, or proves not to exist.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import n_operations
from freebody.language.notation import joined, reworded, to_text
from freebody.language.sentences import Message, in_turn
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes
from freebody.study.answering.finding import Cases, Elements, Finding
from freebody.study.answering.in_size import more_in_size
from freebody.study.answering.motion_extremes import along
from freebody.study.answering.motion_extremes import find as over_motion
from freebody.study.answering.sizes import is_size
from freebody.study.setup import Setup
from freebody.study.steady.drive import FreeToTurn, followed
from freebody.study.steady.of_sizes import further, greatest_of, signed
from freebody.study.steady.phase import Phase, is_timed, over_a_period, phase_of
from freebody.study.steady.round_turn import REACHED_OFTEN, DrawnTurn, over_a_turn
from freebody.study.steady.superposed import Superposed, superposed, superposed_of
from freebody.study.steady.turning import Extremum, TurningAngle, TurnPose
from freebody.symbolic.closure import explicit
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.decide import decide
from freebody.symbolic.functions import functions
from freebody.symbolic.linearised import Swing
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reduced import odd_part
from freebody.symbolic.signs import Sign, sign_of, times
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def extremes(setup: Setup, question: Question, q: Extremes, *, is_of_size: bool = False) -> Finding:
    """(least, largest). is_of_size: both are looked at for the greatest size alone, and it is told where that is.
    Raises CannotAnswer where they have no closed form, or there is none."""
    model = setup.model
    if q.what == "greatest" and (one := signed(setup, q.of)) is not None:
        with suppress(CannotAnswer):
            both = extremes(setup, question, replace(q, of=one, what="extremes"), is_of_size=True)
            return greatest_of(setup, both)
    value = followed(setup, q.of)
    if isinstance(value, tuple):
        raise CannotAnswer(Message("a vector has no extremes; ask for its size or for a component along a direction"))
    x = explicit(model, model.field.lowest_terms(model.field.element(value)))
    if is_of_motion(setup, question, x):
        return _over_motion(setup, question, q)
    if q.what in ("least", "greatest") and not _moving(model, x) and not is_timed(model, x):
        return _constant(setup, question, q, x)
    waves = waves_of(setup, question, q, x)
    if waves is not None:
        return superposed(setup, question, q, waves)
    turning, x = turning_with(setup, question, q, x)
    turning.check(x)
    search = ExtremaSearch(turning)
    every, least, largest = search.extremes(setup, x)
    kept = _kept(setup, turning)
    conditions = search.conditions + kept
    if isinstance(turning, Phase):
        evidence = over_a_period(setup, question.text, q.of, turning, (least.value, largest.value), conditions)
    else:
        evidence = over_a_turn(setup, question.text, q.of, turning.angle, least, largest, conditions)
    ends = [(Message("least"), least), (Message("largest"), largest)]
    if is_of_size:
        side = further(setup, least.value, largest.value, [*conditions])
        in_size = {-1: least.places, 0: (*least.places, *largest.places), 1: largest.places}[side]
        ends = [(Message("largest"), replace(largest, places=in_size))]
    notes = [where(end, e, turning) for end, e in ends] + turning.notes
    notes += search.by_sign(setup, q, least, largest)
    element = told(search, q, least, largest)
    way = {"least": 1, "greatest": -1}.get(q.what)
    each = [] if way is None else [(e.value, search.beside(e, every, way)) for e in every]
    needed = search.needed([e for e in (least, largest) if way is None or e is (least if way > 0 else largest)]) + kept
    return Finding(element, evidence, needed, notes, cases=Cases(search.settled + kept, each) if each else None)


def waves_of(setup: Setup, question: Question, q: Extremes, x: Ratio) -> Superposed | None:
    """Of what drives lead with several frequencies, or in powers of the time."""
    model = setup.model
    if q.over is not None or question.at_start or _moving(model, x) or not is_timed(model, x):
        return None
    return superposed_of(setup, q.of) if phase_of(model, x) is None else None


def turning_with(setup: Setup, question: Question, q: Extremes, x: Ratio) -> tuple[TurningAngle, Ratio]:
    """What makes the turn, the angle of a coordinate or the phase of a drive, and the quantity as it depends on it."""
    if q.over is None and not _moving(setup.model, x) and not question.at_start:
        phase = phase_of(setup.model, x)
        if phase is not None and phase.is_alone_in(x):
            return phase, x
    c = angle_of(setup.model, q, x)
    return TurningAngle(setup.model, c, elsewhere(setup, c, q.of)), at_start_but_for(setup, question, x, c)


def _moving(model: SymbolicModel, x: Ratio) -> list[Coordinate]:
    """The coordinates on which it depends, by place or by speed."""
    inside = model.field.ingredients(x)
    return [c for c in model.coordinates if inside & {c.index, c.speed}]


def is_of_motion(setup: Setup, question: Question, x: Ratio) -> bool:
    """Whether it depends on how fast something turns that no drive keeps going: then the motion itself tells that."""
    speeds = {c.speed for c in setup.model.coordinates}
    is_free = not isinstance(setup, FreeToTurn) and bool(setup.system.start_rates)
    return is_free and not question.at_start and bool(speeds & setup.model.field.ingredients(x))


def _over_motion(setup: Setup, question: Question, q: Extremes) -> Finding:
    """Over a turn of what turns by itself, as fast as energy lets it."""
    if q.what == "time ratio":
        raise CannotAnswer(Message("it is meant of an angle that turns evenly"))
    if along(setup, q.of).span.ends is not None:
        raise CannotAnswer(Message("it turns back, and makes no full turn: ask for the greatest value over the motion"))
    sides = {"least": (-1,), "greatest": (1,)}.get(q.what, (-1, 1))
    found = over_motion(setup, question.text, q.of, sides)
    if q.what == "stroke" and isinstance(found.element, tuple):
        least, largest = found.element
        found.element = setup.model.field.lowest_terms(largest - least)
    return found


def _constant(setup: Setup, question: Question, q: Extremes, x: Ratio) -> Finding:
    """What is the same in every pose."""
    angles = [c for c in setup.model.coordinates if setup.model.field.pair_of(c.index) is not None]
    named = setup.model.system.measures.get(q.over or "")
    found = [c for c in angles if named is None or setup.model.measure_of(c) == named]
    if len(found) != 1:
        raise CannotAnswer(Message("the quantity is the same in every pose"))
    same = Extremum(x, ())
    conditions = setup.holding(setup.state)
    evidence = over_a_turn(setup, question.text, q.of, found[0], same, same, conditions)
    return Finding(x, evidence, conditions, [Message("it is the same in every pose")])


def elsewhere(setup: Setup, c: Coordinate, quantity: Quantity) -> list[dict[int, Any]]:
    """The numbers of the draws that are no samples of the formulas, where they go all the way round."""
    known = sum(sample.is_start for sample in setup.model.samples.points)
    found: list[dict[int, Any]] = []
    for draw in setup.draws[known:]:
        with suppress(CannotAnswer):
            DrawnTurn(setup, draw, c, quantity).poses()
            found.append(setup.model.samples.numbers(draw.sample()))
    return found


def told(search: ExtremaSearch, q: Extremes, least: Extremum, largest: Extremum) -> Elements:
    """What is asked of the two: both, one of them, how far they are apart, or the ratio of the angles between their
    places. What that takes to be as at the first sample becomes a condition."""
    if q.what == "extremes":
        return least.value, largest.value
    if q.what in ("least", "greatest"):
        return least.value if q.what == "least" else largest.value
    f = search.field
    if q.what == "stroke":
        return f.lowest_terms(largest.value - least.value)
    if len(least.places) != 1 or len(largest.places) != 1:
        raise CannotAnswer(REACHED_OFTEN)
    between = search.between(least.places[0], largest.places[0])
    return f.lowest_terms((2 * f.pi - between) / between)


def _kept(setup: Setup, turning: TurningAngle) -> list[Condition]:
    """Conditions of the model that are not settled for the whole turn."""
    holding = setup.holding(setup.state)
    kept = [k for k in holding if k.purpose != "as at the start" or not turning.occurs_in(k.element)]
    return [_at_every_phase(turning, k) for k in kept] if isinstance(turning, Phase) else kept


def _at_every_phase(phase: Phase, c: Condition) -> Condition:
    """What an inequality takes all round, where it is linear in the waves: a + b cos + c sin is nowhere less than
    a - sqrt(b^2 + c^2)."""
    f = phase.field
    parts = Swing(phase.cos, phase.sin, phase.rate).parts(c.element)
    if parts is None or c.relation not in (">", ">="):
        return c
    mean, cos, sin = parts
    size = f.sqrt(f.lowest_terms(cos * cos + sin * sin), phase.model.samples.is_negative)
    return replace(c, element=f.lowest_terms(mean - size))


def angle_of(model: SymbolicModel, q: Extremes, x: Ratio) -> Coordinate:
    """The coordinate that makes the turn."""
    inside = model.field.ingredients(x)
    moving = [c for c in model.coordinates if c.index in inside]
    if not moving:
        if is_timed(model, x):
            raise CannotAnswer(
                Message(
                    "it varies with time, as it is driven, and not with a coordinate that is free. Leave the driver "
                    "out to ask for the extremes over a turn of its angle"
                )
            )
        raise CannotAnswer(Message("the quantity is the same in every pose"))
    if q.over is None:
        if len(moving) > 1:
            names = ", ".join(c.name for c in moving)
            raise CannotAnswer(
                Message(
                    "it depends on {names}; say over a turn of which: extremes of ... over a turn of {x}",
                    names=names,
                    x=moving[0].name,
                )
            )
        return moving[0]
    measure = model.system.measures[q.over]
    for c in moving:
        if model.measure_of(c) == measure:
            return c
    raise CannotAnswer(
        Message("it does not depend on {x}, but on {names}", x=q.over, names=", ".join(c.name for c in moving))
    )


def at_start_but_for(setup: Setup, question: Question, x: Ratio, c: Coordinate) -> Ratio:
    """With everything but the angle as it is at the start, if so asked."""
    if not question.at_start:
        return x
    return setup.model.field.follow(x, {k: v for k, v in setup.start.values.items() if k != c.index})


def where(which: str, e: Extremum, turning: TurningAngle) -> str:
    """At which places one of the extremes is."""
    places = list(dict.fromkeys(p.text(turning.shown) for p in e.places))
    return reworded(
        Message("{which} at {places}", which=which, places=in_turn(places, "{first} and {second}")),
        joined(places, " or "),
    )


_MOST_SHOWN = 60  # operations of a formula that is told
_MOST_TERMS = 300  # of what is looked through for stationary places


class ExtremaSearch:
    """Stationary values over the turn, and what must be positive for them."""

    def __init__(self, turning: TurningAngle) -> None:
        self.turning = turning
        self.field = turning.model.field
        self.conditions: list[Condition] = []
        self.settled: list[Condition] = []  # without which there is no such turn, whichever extreme is which
        self._of_places: list[tuple[TurnPose, list[Condition]]] = []  # what makes each of them real

    def extremes(self, setup: Setup, x: Ratio) -> tuple[list[Extremum], Extremum, Extremum]:
        """All stationary values, the least and the largest of them; of a size by its square, which has a slope where it
        vanishes as well."""
        f, model = self.field, self.turning.model
        if len(x.num) + len(x.denominator().num) > _MOST_TERMS:
            raise CannotAnswer(Message("its slope is a formula that is too long to look for its zeros"))
        root = is_size(model, x, self.turning.angle)
        x = f.lowest_terms(x * x) if root else x
        self.must_exist(x)
        self.must_go_round(setup)
        found = self.stationary(x)
        self.settled = [*self.conditions]
        least, largest = self.ordered(found)
        if not root:
            return found, least, largest
        own = {e: replace(e, value=f.sqrt(e.value, model.samples.is_negative)) for e in found}
        return list(own.values()), own[least], own[largest]

    def stationary(self, x: Ratio) -> list[Extremum]:
        """All stationary values, each once."""
        candidates = self.turning.zeros(self._slope(x).numerator())
        places: list[TurnPose] = []
        for place in candidates:
            known = len(self.conditions)
            if self._exists(place, candidates):
                places.append(place)
                self._of_places.append((place, self.conditions[known:]))
        values: list[Extremum] = []
        for place in places:
            value = self.turning.at(x, place)
            same = next((k for k, e in enumerate(values) if e.value == value), None)
            if same is None:
                values.append(Extremum(value, (place,)))
            else:
                values[same] = Extremum(value, (*values[same].places, place))
        if not values:
            raise CannotAnswer(Message("no pose is stationary: the quantity has no extremes over a turn"))
        return values

    def by_sign(self, setup: Setup, q: Extremes, least: Extremum, largest: Extremum) -> list[str]:
        """That the greatest value is not that of the greatest size, where that is so."""
        beyond = self.field.lowest_terms(-least.value - largest.value)
        if q.what != "greatest" or beyond.is_zero():
            return []
        is_more = decide(beyond, ">", self.conditions)
        if is_more is None and setup.has_values:
            is_more = self._at_first(beyond) > 0
        return [more_in_size(to_text(tidy(-least.value)))] if is_more else []

    def needed(self, meant: Sequence[Extremum]) -> list[Condition]:
        """Without the conditions that make other extremes real: where these are not, there is only less to compare
        with."""
        own = [c for place, each in self._of_places for c in each if any(place in e.places for e in meant)]
        others = [c for _place, each in self._of_places for c in each if c not in own]
        return [c for c in self.conditions if c not in others]

    def _exists(self, place: TurnPose, candidates: Sequence[TurnPose]) -> bool:
        """Whether a place is real: for all admissible values, or as at the first sample, which is a condition then.

        Where `x` vanishes the two places of a root fall together, and the slope does not change its sign there: the
        quantity has no extremum but that of a third place, if there is one.
        """
        for x in place.must_be_positive:
            odd = odd_part(x)
            relation = ">=" if self._meet(odd, place, candidates) else ">"
            condition, possible = require(odd, relation, Message("there is such a pose"))
            if not possible:
                return False
            if condition is None:
                continue
            if self._at_first(x) < 0:
                self._add(-x, "", ">=")
                return False
            self.conditions.append(condition)
        return True

    def _meet(self, x: Ratio, place: TurnPose, candidates: Sequence[TurnPose]) -> bool:
        """Whether a place that does not end with it is reached where `x` vanishes: then x is a factor of 1 - (cosine of
        the angle between the two), or of 1 - cosine^2 where the opposite place is one of them as well."""
        f = self.field
        own = [base for base, _e in f.factor(x.num)[1]]
        for other in (p for p in candidates if all(odd_part(k) != x for k in p.must_be_positive)):
            cosine = f.lowest_terms(place.cos * other.cos + place.sin * other.sin)
            opposite = any(p.cos == -other.cos and p.sin == -other.sin for p in candidates)
            apart = f.lowest_terms(1 - cosine * cosine if opposite else 1 - cosine)
            shared = [] if apart.is_zero() else [base for base, _e in f.factor(apart.num)[1]]
            if all(base in shared for base in own):
                return True
        return False

    def _at_first(self, x: Ratio) -> float:
        """At the first sample, the model's own numbers where it has them: what is taken from it becomes a condition."""
        values = self.turning.model.samples.at_starts(x)
        if not values or math.isnan(values[0]):
            raise CannotAnswer(Message("{x} is not real at the model's own values", x=to_text(tidy(x))))
        return values[0]

    def must_exist(self, x: Ratio) -> None:
        """Denominators must not vanish on the way, and what is under roots must not become negative."""
        made_of = sorted(self.field.ingredients(x))
        for index in (i for i in made_of if self.field.generators[i].kind == "root" and self.turning.moves(i)):
            for base, exponent in self.field.factor(self.field.radicand(index).num)[1]:
                if exponent % 2 and self.turning.occurs_in(base):
                    self._keep_sign(
                        base, Message("there is no full turn"), Message("a full turn is possible"), may_touch=True
                    )
        for base, _exponent in self.field.factor(x.denominator().num)[1]:
            if self.turning.occurs_in(base):
                norm = self.turning.norm(base)
                if self.turning.occurs_in(norm):
                    self._keep_sign(
                        norm,
                        Message("it grows without bound, or a change point is passed"),
                        Message("it stays finite"),
                        may_touch=False,
                    )

    def must_go_round(self, setup: Setup) -> None:
        """What the formulas take to be positive, as it is at the start, must be so all round."""
        model = setup.model
        for assumed in model.samples.assumed:
            x = explicit(model, setup.state.here(model.express(assumed)))
            if self.turning.occurs_in(x):
                why = Message("the formula is that of one branch only, which a turn leaves")
                self._keep_sign(self.turning.norm(x), why, Message("as at the start"), may_touch=False)

    def _keep_sign(self, base: Ratio, otherwise: str, purpose: str, *, may_touch: bool) -> None:
        """All stationary values have the sign that the element has at the start."""
        inner = ExtremaSearch(self.turning)
        sign = 1 if self._at_first(base) > 0 else -1
        places = self.turning.zeros(self._slope(base).numerator())
        for place in places:
            value = sign * self.turning.at(base, place)
            if (may_touch and value.is_zero()) or decide(value, ">") is True:
                continue
            if not inner._exists(place, places):  # where it is, a condition
                continue
            if self._at_first(value) <= 0:
                if (n := n_operations(tidy(base))) > _MOST_SHOWN:  # near zero its round-off decides
                    told = Message("whether it goes all round was not decided: by a formula of {n} operations", n=n)
                    raise CannotAnswer(told)
                raise CannotAnswer(Message("{why}: {x} vanishes on the way", why=otherwise, x=to_text(tidy(base))))
            self._add(value, purpose)
        self.conditions += inner.conditions

    def _slope(self, x: Ratio) -> Ratio:
        """The derivative along the angle. Raises CannotAnswer where it is zero all round."""
        slope = self.field.lowest_terms(self.field.derivative(x, self.turning.angle.index))
        if slope.is_zero():
            raise CannotAnswer(Message("the quantity is the same all round the turn"))
        return slope

    def between(self, a: TurnPose, b: TurnPose) -> Ratio:
        """The angle between two places, less than half a turn."""
        f, fn = self.field, functions(self.field, self.turning.model.samples.is_negative)
        product = f.lowest_terms(a.cos * b.cos + a.sin * b.sin)
        if not any(_has_roots(p.cos) for p in (a, b)) and _has_roots(product):
            sides = [self._at_first(p.sin) > 0 for p in (a, b)]
            if sides[0] != sides[1]:  # both from the same axis, to either side; together less than half a turn, or more
                whole, room = fn["acos"](a.cos) + fn["acos"](b.cos), f.lowest_terms(a.cos + b.cos)
                is_less = self._at_first(room) > 0
                self._add(room if is_less else -room, Message("which way takes longer"))
                return whole if is_less else 2 * f.pi - whole
        return fn["acos"](product)

    def _add(self, x: Ratio, purpose: str, relation: str = ">") -> None:
        condition, possible = require(odd_part(x), relation, purpose)
        if not possible:
            raise CannotAnswer(
                Message("for no admissible values {purpose}: {x} is not positive", purpose=purpose, x=to_text(tidy(x)))
            )
        if condition is not None and all(condition.element != known.element for known in self.conditions):
            self.conditions.append(condition)

    def ordered(self, found: list[Extremum]) -> tuple[Extremum, Extremum]:
        """Least and largest: by sign, else as at the first sample, which is a condition then."""
        values = [self._at_first(e.value) for e in found]
        return self._first(found, values, 1), self._first(found, values, -1)

    def beside(self, one: Extremum, every: Sequence[Extremum], way: int) -> list[Condition]:
        """What it takes for one stationary value to be the least of all (way = 1), or the largest (-1)."""
        gaps = [way * (e.value - one.value) for e in every if e is not one]
        return [Condition(odd_part(gap), ">=", Message("which extreme is which")) for gap in gaps]

    def _first(self, found: list[Extremum], values: list[float], way: int) -> Extremum:
        chosen = found[min(range(len(values)), key=lambda k: way * values[k])]
        for e in found:
            gap = way * (e.value - chosen.value)
            if e is not chosen and _sign(gap) not in (Sign.POSITIVE, Sign.NONNEGATIVE):
                self._add(gap, Message("which extreme is which"))
        return chosen


def _has_roots(x: Ratio) -> bool:
    return any(x.field.generators[g].kind == "root" for g in x.generators())


def _sign(x: Ratio) -> Sign:
    """The sign; that of a multiple of an arc is the sign of what it is the arc of."""
    f = x.field
    arcs = [i for i in x.generators() if f.arguments.get(i, ("",))[0] in ("asin", "atan")]
    if len(arcs) == 1 and x.den is None:
        slope = f.partial(x, arcs[0])
        if slope * f.variable(arcs[0]) == x:
            return times(sign_of(slope), sign_of(f.arguments[arcs[0]][1]))
    return sign_of(x)
