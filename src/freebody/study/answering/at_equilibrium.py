"""Equilibria and small motion about them: the evidence of closed forms, and numbers from the numeric route alone."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, Point
from freebody.numeric.balanced import Balanced
from freebody.numeric.instant import WithoutInertia
from freebody.numeric.jets import Array
from freebody.numeric.linearised import frequencies
from freebody.numeric.small_motion import LinearisationPoint, SmallMotion
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.questions.small_motion import SmallOscillations
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import MIN_DRAWS, CrossCheck, as_parts, broken, element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.mobility.centres import moving_for
from freebody.study.setup import Setup
from freebody.study.small_motion.equilibrium import nearest_equilibrium, refuse_out_of_bounds
from freebody.study.where_true import left_at
from freebody.symbolic.conditions import Condition
from freebody.symbolic.equilibrium import GYROSCOPIC, WITH_STATES
from freebody.symbolic.linearised import swing_of
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import place_of_mode
from freebody.symbolic.state import SymbolicState
from freebody.tolerances import ROUND_OFF

AT_REST = 1e-7  # [SI] that an acceleration may differ from zero at an equilibrium
NOTHING_DRIVES_BACK = Message("there is no period of small oscillations: to first order nothing drives it back")


def small_oscillations(
    setup: Setup,
    question: str,
    quantity: SmallOscillations,
    x: Ratio | tuple[Ratio, ...],
    equilibrium: dict[int, Ratio],
    rest: Sequence[Condition],
    swings: Sequence[Condition],
) -> Evidence:
    """Compares angular frequencies, or the period, with a numerical linearisation of the full system. rest, swings:
    conditions for the equilibrium, and for oscillations about it."""
    check = CrossCheck(question, Message("numerical linearisation about the same equilibrium"), 1e-5)

    def compare(draw: Draw) -> None:
        if not all(holds(setup, c, draw, draw.start()) for c in (*rest, *swings)):
            return
        exact = np.sort(element_at(setup, x, draw, draw.start()))
        found = frequencies_at(setup, draw, places_at(setup, equilibrium, draw))
        if quantity.number is not None:
            found = np.sort(found)[[place_of_mode(len(found), quantity.number)]]
        elif quantity.what != "frequencies":
            found = found[found > 0.0]  # beside what nothing drives back
        if quantity.measure is not None and len(found):  # one of those, in which it moves
            own = 2 * np.pi / exact if quantity.what == "period" else exact
            found = found[[int(np.argmin(abs(found - w))) for w in own]]
        numeric = 2 * np.pi / found if quantity.what == "period" else np.sort(found)
        if len(exact) == 1:
            exact = np.repeat(exact, len(numeric))  # one period of several motions
        check.compare(draw, tuple(map(float, exact)), tuple(map(float, numeric)))

    check.gather(setup.draw_stream(), compare)
    insist_on_rest(setup, check, rest)
    if len(check.pairs) < MIN_DRAWS and setup.has_values and (missed := broken(setup, swings)):
        raise CannotAnswer(
            Message("it does not oscillate at the model's own values: that needs {needs}", needs=", ".join(missed))
        )
    return check.evidence()


def insist_on_rest(setup: Setup, check: CrossCheck, rest: Sequence[Condition]) -> None:
    """Raises CannotAnswer where too little was compared because the equilibrium is none at the model's own values."""
    if len(check.pairs) < MIN_DRAWS and setup.has_values and (missed := broken(setup, rest)):
        raise CannotAnswer(
            Message(
                "the equilibrium that formulas give is none at the model's own values: that needs {needs}",
                needs=", ".join(missed),
            )
        )


def at_rest(
    setup: Setup, question: str, equilibrium: dict[int, Ratio], x: Ratio, conditions: Sequence[Condition]
) -> Evidence:
    """At the equilibrium the full system, at rest but for what is driven, must not accelerate. conditions: of the
    equilibrium."""
    check = CrossCheck(question, Message("accelerations of the full system at rest there"), AT_REST)

    def compare(draw: Draw) -> None:
        if not all(holds(setup, c, draw, draw.start()) for c in conditions):
            return
        check.compare(draw, (1.0,), (1.0 + unrest(setup, draw, pose_at(setup, equilibrium, draw)),))

    insist_on_rest(setup, check.gather(setup.draw_stream(), compare), conditions)
    return check.evidence()


def value_at_rest(
    setup: Setup,
    question: str,
    of: Quantity,
    equilibrium: dict[int, Ratio],
    x: Ratio | tuple[Ratio, ...],
    conditions: Sequence[Condition],
) -> Evidence:
    """Compares a quantity with that of the full system at rest there, which must not accelerate."""
    check = CrossCheck(question, Message("floating-point solve of all bodies and constraints at rest there"), AT_REST)

    def compare(draw: Draw) -> None:
        if not all(holds(setup, c, draw, draw.start()) for c in conditions):
            return
        places = pose_at(setup, equilibrium, draw)
        seen = moving_for(of, seen_at_rest(draw, *resting(draw, places)))
        exact, numeric = element_at(setup, x, draw, draw.start()), as_parts(of.value(setup.system, seen))
        moves = unrest(setup, draw, places)
        check.compare(draw, (*map(float, exact), 1.0), (*map(float, numeric), 1.0 + moves))

    insist_on_rest(setup, check.gather(setup.draw_stream(), compare), conditions)
    return check.evidence()


def small_number(quantity: SmallOscillations, setup: Setup, draw: Draw) -> float | tuple[float, ...]:
    """Natural frequencies, or the one period, about the equilibrium that formulas give, else the one nearest to the
    start. Raises CannotAnswer where there is none, where it is not stable, or where there are several periods."""
    if setup.system.states:
        raise CannotAnswer(WITH_STATES)
    found = [float(w) for w in _numbers_about(setup, draw)]
    if not found:
        raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
    is_the_one = len(found) == 1 and setup.has_model and _first_measure(setup) == quantity.measure
    if quantity.measure is not None and not is_the_one:
        raise CannotAnswer(
            Message("a number is told of the whole motion only: ask for the period of small oscillations")
        )
    if quantity.what == "frequencies":
        return tuple(found) if len(found) > 1 else found[0]
    if quantity.number is not None:
        found = [sorted(found)[place_of_mode(len(found), quantity.number)]]
    swinging = [w for w in found if w > 0.0]
    if len(swinging) > 1 and max(swinging) - min(swinging) > ROUND_OFF * max(swinging):
        raise CannotAnswer(Message("there are {n} natural frequencies; ask for natural frequencies", n=len(swinging)))
    if not swinging:
        raise CannotAnswer(NOTHING_DRIVES_BACK)
    return 2.0 * math.pi / swinging[0] if quantity.what == "period" else swinging[0]


def _first_measure(setup: Setup) -> Measure | None:
    return setup.model.measure_of(setup.model.coordinates[0])


def _numbers_about(setup: Setup, draw: Draw) -> Array:
    """Natural frequencies about the equilibrium that formulas give, else the one nearest to the start."""
    if not setup.has_model:
        q = nearest_equilibrium(setup.system)[0].q
        refuse_out_of_bounds(setup.system, draw.reference, q)
        return draw.reference.frequencies(q)
    try:
        places = places_at(setup, setup.place_of_small_motion().values, draw)
        if (
            not setup.moves_off_evenly and unrest(setup, draw, places) > AT_REST
        ):  # the formula takes something to be positive that is not so there
            raise CannotAnswer(Message("this is no equilibrium"))
        q, v = resting(draw, places)
        found = frequencies_at(setup, draw, places)
    except CannotAnswer:
        if swing_of(setup.model) is not None:
            raise
        q = nearest_equilibrium(setup.system)[0].q
        v = np.zeros_like(q)
        found = draw.reference.frequencies(q)
    there = draw.reference.snapshot(q, v, 0.0)
    if (left := left_at(setup.system, draw.reference, there)) is not None:
        raise CannotAnswer(Message("at the equilibrium it is not so that {purpose}", purpose=left.purpose))
    if not all(holds(setup, c, draw, draw.reference.snapshot(q, v)) for c in setup.clearances(setup.state, ">")):
        raise CannotAnswer(Message("there is no room to move about the equilibrium"))
    return found


def resting(draw: Draw, places: Sequence[tuple[Measure, float]], t: float = 0.0) -> tuple[Array, Array]:
    """The pose in which measures have values, and the velocities of what is driven, all else at rest beside it."""
    q = draw.reference.pose_near(draw.q, places, t)
    return q, draw.reference.velocities(q, [(measure, 0.0) for measure, _value in places], t, with_start=False)


def is_driven(setup: Setup, v: Array) -> bool:
    """Whether something is led along in time, be it only from rest; v: the velocities of what is driven."""
    return bool(v.any()) or any(row.is_driven for row in setup.system.constraint_rows)


def instants(setup: Setup, draw: Draw) -> tuple[float, ...]:
    """At which forces have their mean: half a period apart where loads or drives swing."""
    swing = swing_of(setup.model)
    if swing is None:
        return (0.0,)
    (frequency,) = element_at(setup, (swing.frequency,), draw, draw.start())
    return 0.0, math.pi / frequency


def unrest(setup: Setup, draw: Draw, places: Sequence[tuple[Measure, float]]) -> float:
    """The largest acceleration of the full system at rest; beside what is driven, that of the measures alone."""
    times = instants(setup, draw)
    if len(times) == 1:
        q, v = resting(draw, places)
        still = seen_at_rest(draw, q, v)
        if not is_driven(setup, v):
            return float(np.abs(still.accelerations).max(initial=0.0))
        return max((abs(still.acceleration(measure)) for measure, _value in places), default=0.0)
    seen = [seen_at_rest(draw, *resting(draw, places, t), t) for t in times]
    means = [sum(s.acceleration(measure) for s in seen) / len(seen) for measure, _value in places]
    return max(map(abs, means), default=0.0)


def seen_at_rest(draw: Draw, q: Array, v: Array, t: float = 0.0) -> Snapshot:
    """An instant at rest; where what has no mass could move, as the balance of its forces."""
    there = draw.reference.snapshot(q, v, t)
    try:
        seen = draw.seen(there)
        _ = seen.accelerations
        return seen
    except WithoutInertia:
        if v.any():
            raise
        return Balanced(draw.reference, there.geometry, q, v, t)


def small_motions_at(setup: Setup, draw: Draw, places: Sequence[tuple[Measure, float]]) -> SmallMotion:
    """The numeric linearisation about an equilibrium, of the mean of what swings. Raises CannotAnswer where forces that
    are linear in the speeds, and do no work, mix the motions."""
    found: list[SmallMotion] = []
    for t in instants(setup, draw):
        q, v = resting(draw, places, t)
        at = LinearisationPoint(
            q, v, t, draw.start().branches, frozen=not (is_driven(setup, v) or setup.moves_off_evenly)
        )
        found.append(SmallMotion(draw.reference, at))
    small = found[0]
    if len(found) > 1:
        small.K, small.C = ((getattr(small, A) + getattr(found[1], A)) / 2.0 for A in "KC")
    if float(np.abs(small.C - small.C.T).max(initial=0.0)) > ROUND_OFF * float(np.abs(small.C).max(initial=1.0)):
        raise CannotAnswer(GYROSCOPIC)
    return small


def frequencies_at(setup: Setup, draw: Draw, places: Sequence[tuple[Measure, float]]) -> Array:
    """Natural angular frequencies [rad/s] of the undamped system about an equilibrium, or beside what is driven."""
    q, v = resting(draw, places)
    if not (is_driven(setup, v) or setup.moves_off_evenly) and len(instants(setup, draw)) == 1:
        return draw.reference.frequencies(q)
    small = small_motions_at(setup, draw, places)
    mass, K = small.orthonormal.T @ small.M @ small.orthonormal, small.stiffness
    return frequencies(mass, K)


def places_at(setup: Setup, equilibrium: dict[int, Ratio], draw: Draw) -> list[tuple[Measure, float]]:
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


def pose_at(setup: Setup, equilibrium: dict[int, Ratio], draw: Draw) -> list[tuple[Measure, float]]:
    """The same with what closed loops bind, where that is a measure. A loop may close in several ways there: where the
    one that is nearest to the start does not rest, with the poses of all bodies by the formulas."""
    model, start = setup.model, draw.start()
    bound = [(model.measure_of(d), equilibrium[d.index]) for d in model.dependent if d.index in equilibrium]
    more = [(m, element_at(setup, x, draw, start)[0]) for m, x in bound if m is not None]
    places = [*places_at(setup, equilibrium, draw), *more]
    if setup.system.space or unrest(setup, draw, places) <= AT_REST:
        return places
    there = SymbolicState(model, equilibrium)
    with suppress(CannotAnswer):
        whole = [(m, element_at(setup, there.value(m), draw, start)[0]) for m in _poses(setup)]
        return [*places, *whole]
    return places


def _poses(setup: Setup) -> Iterator[Measure]:
    """Places and angles of all bodies."""
    for body in setup.system.moving:
        of, ground = body.point(body.default_point), Point(GROUND)
        yield from (Displacement(of, ground, along) for along in (RIGHT, UP))
        if body.turns:
            yield Angle(body.name)
