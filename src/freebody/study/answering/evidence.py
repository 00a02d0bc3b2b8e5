"""The second opinion: every closed form is evaluated at random admissible numbers and compared with the
numeric route, which shares only the statements of the measures. A disagreement is an error, never an answer."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial, singledispatch

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, Point
from freebody.numeric.linearised import frequencies
from freebody.numeric.reference import Snapshot
from freebody.numeric.small_motion import LinearisationPoint, SmallMotion
from freebody.questions.base import Quantity
from freebody.questions.loads import Power
from freebody.questions.reading import QuestionEvent
from freebody.questions.small_motion import SmallOscillations
from freebody.study.answering.answer import Evidence
from freebody.study.answering.draws import Draw
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.passage import NumericPassage
from freebody.study.answering.spread import disagreement
from freebody.study.mobility.centres import moving_for
from freebody.study.setup import Setup, rank_freedoms
from freebody.study.simulation.at_rest import is_unstable_rest
from freebody.study.simulation.simulator import Simulator
from freebody.study.small_motion.equilibrium import nearest_equilibrium
from freebody.symbolic.conditions import Condition, merged
from freebody.symbolic.equilibrium import find_equilibrium
from freebody.symbolic.field import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.tolerances import LEAST

INSTANT_TOLERANCE = 1e-8
MOTION_TOLERANCE = 1e-7
MIN_DRAWS = 5
N_PANELS = 16
SMALL = 1e-6  # a quantity that is smaller than this (SI) in every draw is compared absolutely
ZERO_FLOOR = 1e-2  # the same for an answer that is exactly zero, where only round-off can be compared
OF_PARTS = 1e-3  # of the parts of a sum, by the tolerance: differences below that are no differences


def _tuple(value: object) -> tuple[float, ...]:
    if isinstance(value, tuple):
        return tuple(float(v) for v in value)  # type: ignore[arg-type]
    return (float(value),)  # type: ignore[arg-type]


def _size(values: tuple[float, ...]) -> float:
    return max((abs(v) for v in values), default=0.0)


class CrossCheck:
    """Collects comparisons for one question. Differences count by the size of the quantity in the draw, or, where
    it happens to cancel there, by a thousandth of its largest size in all draws; a difference that round-off makes of
    the parts of which the quantity is the sum is none."""

    def __init__(self, question: str, route: str, tolerance: float) -> None:
        self.question = question
        self.route = route
        self.tolerance = tolerance
        self.pairs: list[tuple[Draw, tuple[float, ...], tuple[float, ...]]] = []
        self._parts: list[Callable[[], float]] = []

    def compare(self, draw: Draw, exact: object, numeric: object, parts: Callable[[], float] = float) -> None:
        """parts: the size of what was added up, asked for where the sum is small."""
        self.pairs.append((draw, _tuple(exact), _tuple(numeric)))
        self._parts.append(parts)

    def evidence(self) -> Evidence:
        """Raises RoutesDisagree on a difference beyond the tolerance, CannotAnswer if too little was compared."""
        largest = max((_size(b) for _draw, _a, b in self.pairs), default=0.0)
        is_zero = all(v == 0.0 for _draw, a, _b in self.pairs for v in a)
        floor = ZERO_FLOOR if is_zero else SMALL
        worst = 0.0
        for (draw, a, b), parts in zip(self.pairs, self._parts, strict=True):
            gap = max(abs(x - y) for x, y in zip(a, b, strict=True))
            share = gap / max(_size(a), _size(b), 1e-3 * largest, floor)
            if not share <= self.tolerance:
                share = min(share, gap / max(OF_PARTS * parts(), LEAST))
            if not share <= self.tolerance:
                values = ", ".join(f"{k} = {v:.6g}" for k, v in draw.values.items())
                gives = Message(
                    "'{question}': the closed form gives {a}, the numeric route {b} at {values}",
                    question=self.question,
                    a=_shown(a),
                    b=_shown(b),
                    values=values,
                )
                raise disagreement(gives, draw.reference)
            worst = max(worst, share)
        if len(self.pairs) < MIN_DRAWS:
            raise CannotAnswer(
                Message(
                    "only {k} of the {n} checks against the numeric route could be made, so the "
                    "closed form is not shown",
                    k=len(self.pairs),
                    n=MIN_DRAWS,
                )
            )
        return Evidence(len(self.pairs), worst, self.route)


def _shown(values: tuple[float, ...]) -> str:
    return ", ".join(f"{v:.10g}" for v in values)


def element_at(setup: Setup, x: Ratio | tuple[Ratio, ...], draw: Draw, snapshot: Snapshot) -> tuple[float, ...]:
    """A closed form in numbers at a snapshot."""
    numbers = setup.model.samples.numbers(draw.sample(snapshot), draw.sample())
    parts = x if isinstance(x, tuple) else (x,)
    try:
        return tuple(float(setup.model.field.evaluate(p, numbers)) for p in parts)
    except KeyError:
        raise NotReal(Message("a part of the closed form has no real value here")) from None
    except ZeroDivisionError:
        raise NotReal(Message("the closed form divides by zero")) from None


class NotReal(CannotAnswer):
    """A closed form has no real value at the given numbers."""


def at_instants(
    setup: Setup,
    question: str,
    quantity: Quantity,
    x: Ratio | tuple[Ratio, ...],
    *,
    at_start: bool,
) -> Evidence:
    """Compares at the start, or at a general pose and motion, of every draw."""
    route = (
        Message("floating-point solve of all bodies and constraints at the start")
        if at_start
        else Message("floating-point solve of all bodies and constraints at random poses and speeds")
    )
    witness = CrossCheck(question, route, INSTANT_TOLERANCE)
    for k, draw in enumerate(setup.draws):
        snapshot = moving_for(quantity, draw.start()) if at_start else setup.anywhere[k]
        numeric = quantity.value(setup.system, draw.seen(snapshot))
        exact = element_at(setup, x, draw, snapshot)
        witness.compare(draw, exact, numeric, partial(magnitude, quantity.dimension, draw.seen(snapshot)))
    return witness.evidence()


def along_motion(
    setup: Setup,
    question: str,
    quantity: Quantity,
    event: QuestionEvent,
    x: Ratio,
    time: Ratio | None,
    conditions: Sequence[Condition],
    signs: Sequence[Condition] = (),
) -> Evidence:
    """Integrates from the start to the event and compares the time, or the quantity there. conditions: without which
    the event does not come; signs: what the formula takes to be positive."""
    witness = CrossCheck(question, Message("numerical integration from the start to the event"), MOTION_TOLERANCE)
    for draw in setup.draw_stream():
        if len(witness.pairs) >= MIN_DRAWS:
            break
        start = draw.start()
        try:
            numbers = element_at(setup, (x,), draw, start)
            if not all(holds(setup, c, draw, start) for c in (*conditions, *signs)):
                continue
        except NotReal:
            continue
        until = 100.0
        if time is not None:
            (expected,) = element_at(setup, (time,), draw, start)
            if not expected > 0:
                continue
            until = 1.5 * expected
        numeric = _at_event(setup, quantity, draw, start, until, event)
        witness.compare(draw, numbers, numeric, partial(magnitude, quantity.dimension, draw.seen(start)))
    is_short = len(witness.pairs) < MIN_DRAWS and setup.has_values
    if is_short and (broken := _broken(setup, signs)):
        raise CannotAnswer(
            Message(
                "a formula is found only for motions that keep to {needs}, as at the start; this one does not do so "
                "until '{event}'",
                event=event.text,
                needs=", ".join(broken),
            )
        )
    if is_short and (broken := _broken(setup, conditions)):
        raise CannotAnswer(
            Message(
                "'{event}' does not come at the model's own values: that needs {needs}",
                event=event.text,
                needs=", ".join(broken),
            )
        )
    return witness.evidence()


def _broken(setup: Setup, conditions: Sequence[Condition]) -> list[str]:
    """The conditions that do not hold at the model's own values."""
    draw = setup.draws[0]
    found: list[Condition] = []
    for c in conditions:
        try:
            if not holds(setup, c, draw, draw.start()):
                found.append(c)
        except NotReal:
            continue
    return merged([Condition(c.element, c.relation) for c in found])


def _at_event(
    setup: Setup, quantity: Quantity, draw: Draw, start: Snapshot, until: float, event: QuestionEvent
) -> object:
    from freebody.study.answering.witness import motion_to

    found = motion_to(draw.reference, start, until, event)
    work = partial(work_until, setup, draw=draw, event=event, end=found.time)
    return quantity.counted(NumericPassage(setup, start, found.event, found.time, work))


def work_until(setup: Setup, load: str, draw: Draw, event: QuestionEvent, end: float) -> float:
    """The integral of the power over time from the start to an event, by Gauss-Legendre points in panels."""
    from freebody.study.answering.witness import motion_to

    start = draw.start()
    nodes, weights = np.polynomial.legendre.leggauss(8)
    half = 0.5 * (end - start.t) / N_PANELS
    centers = start.t + half * (2.0 * np.arange(N_PANELS) + 1.0)
    times = (centers[:, None] + half * nodes).ravel()
    found = motion_to(draw.reference, start, end + half, event, times)
    power = [float(Power(load).value(setup.system, s)) for s in found.links[: len(times)]]
    return half * float(np.tile(weights, N_PANELS) @ np.array(power))


def number(setup: Setup, quantity: Quantity, event: QuestionEvent | None) -> float | tuple[float, ...]:
    """The quantity from the numeric route alone, at the start or at the event; a plain number without a formula.
    Raises CannotAnswer if the event does not happen within a minute."""
    return _number(quantity, setup, event, setup.draws[0])


@singledispatch
def _number(quantity: Quantity, setup: Setup, event: QuestionEvent | None, draw: Draw) -> float | tuple[float, ...]:
    start = draw.start()
    if event is None:
        values = _tuple(quantity.value(setup.system, draw.seen(moving_for(quantity, start))))
    elif _rests(setup):
        raise CannotAnswer(Message("it starts at rest, and only round-off accelerates it: numbers would follow that"))
    else:
        values = _tuple(_at_event(setup, quantity, draw, start, 60.0, event))
    return values[0] if len(values) == 1 else values


@_number.register(SmallOscillations)
def _small_number(
    quantity: SmallOscillations, setup: Setup, event: QuestionEvent | None, draw: Draw
) -> float | tuple[float, ...]:
    """Natural frequencies, or the one period, about the equilibrium that formulas give, else the one nearest to the
    start. Raises CannotAnswer where there is none, where it is not stable, or where there are several periods."""
    try:
        equilibrium = find_equilibrium(setup.model, setup.start).values
        q = draw.reference.pose_near(draw.q, _wanted(setup, equilibrium, draw))
    except CannotAnswer:
        q = nearest_equilibrium(setup.system)[0].q
    small = SmallMotion(
        draw.reference, LinearisationPoint(q, np.zeros_like(q), 0.0, draw.start().branches, frozen=True)
    )
    found = [float(w) for w in frequencies(small.M, small.K)]
    if not found:
        raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
    if quantity.what == "frequencies":
        return tuple(found) if len(found) > 1 else found[0]
    if len(found) > 1:
        raise CannotAnswer(Message("there are {n} natural frequencies; ask for natural frequencies", n=len(found)))
    if not found[0] > 0.0:
        raise CannotAnswer(Message("it does not oscillate: nothing drives it back"))
    return 2.0 * math.pi / found[0] if quantity.what == "period" else found[0]


def _wanted(setup: Setup, equilibrium: dict[int, Ratio], draw: Draw) -> list[tuple[Measure, float]]:
    """The measures that the coordinates are, with their values at an equilibrium; and where a coordinate is none, as
    the angle of a link, the places of the bodies."""
    start = draw.start()
    measures = {c.index: setup.model.measure_of(c) for c in setup.model.coordinates}
    wanted = [(measure, equilibrium[index]) for index, measure in measures.items() if measure is not None]
    if len(wanted) < len(measures) and not setup.system.space:
        there = SymbolicState(setup.model, equilibrium)
        for body in setup.system.moving:
            of, ground = body.point(body.default_point), Point(GROUND)
            wanted += [(place, there.value(place)) for place in (Displacement(of, ground, d) for d in (RIGHT, UP))]
    return [(measure, element_at(setup, x, draw, start)[0]) for measure, x in wanted]


def _rests(setup: Setup) -> bool:
    """Whether the start is one of rest that only round-off would leave."""
    simulator = Simulator(setup.system)
    return is_unstable_rest(simulator, simulator.start, 0.0)


def holds(setup: Setup, condition: Condition, draw: Draw, snapshot: Snapshot, *, round_off: float = 0.0) -> bool:
    """True where an inequality is satisfied in numbers; `>=` may miss by the round-off. Raises NotReal."""
    (value,) = element_at(setup, (condition.element,), draw, snapshot)
    if condition.relation == ">=":
        return value >= -round_off
    return value > 0 if condition.relation == ">" else value != 0


def small_oscillations(
    setup: Setup, question: str, x: Ratio | tuple[Ratio, ...], equilibrium: dict[int, Ratio], *, period: bool
) -> Evidence:
    """Compares angular frequencies, or the period, with a numerical linearisation of the full system."""
    witness = CrossCheck(question, Message("numerical linearisation about the same equilibrium"), 1e-5)
    for draw in setup.draw_stream():
        if len(witness.pairs) >= MIN_DRAWS:
            break
        start = draw.start()
        try:
            exact = np.sort(element_at(setup, x, draw, start))
        except NotReal:
            continue
        wanted = _wanted(setup, equilibrium, draw)
        found = draw.reference.frequencies(draw.reference.pose_near(draw.q, wanted))
        numeric = 2 * np.pi / found if period else np.sort(found)
        witness.compare(draw, tuple(float(v) for v in exact), tuple(float(v) for v in numeric))
    return witness.evidence()


def at_rest(setup: Setup, question: str, equilibrium: dict[int, Ratio], x: Ratio) -> Evidence:
    """At the equilibrium the full system, at rest but for what is driven, must not accelerate."""
    witness = CrossCheck(question, Message("accelerations of the full system at rest there"), 1e-7)
    for draw in setup.draw_stream():
        if len(witness.pairs) >= MIN_DRAWS:
            break
        try:
            wanted = _wanted(setup, equilibrium, draw)
        except NotReal:
            continue
        q = draw.reference.pose_near(draw.q, wanted)
        v = draw.reference.velocities(q, [(measure, 0.0) for measure, _value in wanted], with_start=False)
        still = draw.seen(draw.reference.snapshot(q, v))
        gap = float(np.abs(still.accelerations).max(initial=0.0))
        if v.any():  # what is driven goes on; the rest is at rest relative to it
            gap = max((abs(still.acceleration(measure)) for measure, _value in wanted), default=0.0)
        witness.compare(draw, (1.0,), (1.0 + gap,))
    return witness.evidence()


def freedom(setup: Setup, question: str, dof: int) -> Evidence:
    """Coordinates minus the rank of the constraint Jacobian at random poses."""
    witness = CrossCheck(question, Message("rank of the constraint Jacobian at random poses"), 1e-12)
    for draw, snapshot in zip(setup.draws, _general(setup), strict=True):
        witness.compare(draw, (float(dof),), (float(rank_freedoms(snapshot)),))
    return witness.evidence()


def rank_freedom(setup: Setup) -> int:
    """Degrees of freedom by rank alone: the fewest of all draws."""
    return min(rank_freedoms(snapshot) for snapshot in _general(setup))


def _general(setup: Setup) -> list[Snapshot]:
    try:
        return setup.anywhere
    except CannotAnswer:  # without formulas there is no branch to be on
        return [draw.anywhere(k, 0.3, 0.1) for k, draw in enumerate(setup.draws)]
