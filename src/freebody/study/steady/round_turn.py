"""The second opinion on extremes: the numeric route in the extremal poses, and in others round the turn."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.expression import ZERO, substitute
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.brent import least_between
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, CrossCheck, element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.setup import Setup
from freebody.study.steady.drive import FreeToTurn
from freebody.study.steady.turning import Extremum
from freebody.symbolic.conditions import Condition
from freebody.symbolic.unknowns import Coordinate

N_POSES = 24
STEP = math.tau / N_POSES
_NEARLY_HALF = math.pi - 1e-6  # angles count from the start, by less than half a turn to either side
_STEP = 0.07  # [rad] from pose to pose
_PLACE = 1e-9  # [rad] of the place of an extreme, the value far better
_SAME = 1e-6  # of the largest value: less apart are two extremes that are one by symmetry
_RATE = 0.83  # of the angle, where the quantity depends on it

REACHED_OFTEN = Message("an extreme is reached more than once a turn: there is no one way between the two")


def over_a_turn(
    setup: Setup,
    question: str,
    quantity: Quantity,
    c: Coordinate,
    least: Extremum,
    largest: Extremum,
    conditions: list[Condition],
) -> Evidence:
    """At the extremal poses the full system has these values, in the others values between them. What is the same in
    every pose has no extremal ones."""
    route = Message("the full system at the extremal poses and at {n} others round the turn", n=N_POSES)
    reached = CrossCheck(question, route, INSTANT_TOLERANCE)
    between = CrossCheck(question, route, INSTANT_TOLERANCE)

    def compare(draw: Draw) -> None:
        turn = DrawnTurn(setup, draw, c, quantity)
        if not all(holds(setup, k, draw, turn.start) for k in conditions):
            return
        if draw is not setup.draws[0]:
            turn.must_go_round()
        low, high = element_at(setup, (least.value, largest.value), draw, turn.start)
        poses = [turn.angle_of(e) if e.places else 0.0 for e in (least, largest)]
        reached.compare(draw, (low, high), tuple(map(turn.at, poses)))
        outside = max(max(low - value, value - high, 0.0) for value in turn.values())
        between.compare(draw, 1.0, 1.0 + outside / max(abs(low), abs(high)))

    reached.gather(setup.draw_stream(), compare)
    between.evidence()
    return reached.evidence()


class DrawnTurn:
    """A full turn of one draw, the other coordinates as at its start."""

    def __init__(self, setup: Setup, draw: Draw, c: Coordinate, quantity: Quantity) -> None:
        self.setup, self.draw, self.quantity, self.c = setup, draw, quantity, c
        model = setup.model
        measure = model.measure_of(c)
        if measure is None:
            raise CannotAnswer(Message("{x} is no measure of the model, so its turn cannot be checked", x=c.name))
        self.measure = measure
        still = draw.reference.snapshot(draw.q, np.zeros_like(draw.q))
        measures = [(k, model.measure_of(k)) for k in model.coordinates if k is not c]
        self.kept: list[tuple[Measure, float]] = [(m, still.value(m)) for _k, m in measures if m is not None]
        self.here = still.value(measure)
        self.start = self._snapshot(draw.q)

    def _snapshot(self, q: Array) -> Snapshot:
        rates = [(self.measure, _RATE), *((m, 0.3) for m, _at in self.kept)]
        return self.draw.reference.snapshot(q, self.draw.reference.velocities(q, rates, with_start=False))

    def angle_of(self, e: Extremum) -> float:
        """How far an extremal pose is from the start."""
        cos, sin = element_at(self.setup, (e.places[0].cos, e.places[0].sin), self.draw, self.start)
        away = math.remainder(math.atan2(sin, cos) - self.here, math.tau)
        return max(-_NEARLY_HALF, min(_NEARLY_HALF, away))

    def at(self, away: float) -> float:
        """The quantity at an angle from the start, by way of the nearest of the poses all round the turn."""
        _near, q = min(self.poses(), key=lambda pose: abs(pose[0] - away))
        return self.value(self.pose(q, away))

    def values(self) -> list[float]:
        """At poses all round the turn."""
        return [self.value(q) for _away, q in self.poses()]

    def must_go_round(self) -> None:
        """Raises SaysNothing where another loop, on which the quantity does not depend, stops it on the way."""
        try:
            self.poses()
        except CannotAnswer as error:
            raise SaysNothing(str(error)) from error

    def poses(self) -> list[tuple[float, Array]]:
        """(angle from the start, pose) all round the turn, found once for each draw."""
        if self.measure not in self.draw.turns:
            found: list[tuple[float, Array]] = []
            for way in (1.0, -1.0):
                q = self.draw.q
                for k in range(N_POSES // 2):
                    away = way * STEP * (k + 0.5)
                    q = self.pose(q, away)
                    found.append((away, q))
            self.draw.turns[self.measure] = found
        return self.draw.turns[self.measure]

    def pose(self, q: Array, away: float) -> Array:
        """At an angle from the start, from another pose in small steps: where a lever turns fast, its other assembly is
        near."""
        still = self.draw.reference.snapshot(q, np.zeros_like(q))
        way = math.remainder(self.here + away - still.value(self.measure), math.tau)
        n = max(1, math.ceil(abs(way) / _STEP))
        for k in range(n - 1, -1, -1):
            q = self.draw.reference.pose_near(q, [*self.kept, (self.measure, self.here + away - way * k / n)])
        return q

    def value(self, q: Array) -> float:
        return float(self.quantity_at(q))

    def quantity_at(self, q: Array) -> Any:
        """The quantity in a pose, whatever it is: of a vector a tuple."""
        if isinstance(self.setup, FreeToTurn) and self.quantity.kinematic_order != 0:
            return self.quantity.value(self.setup.driven, self._driven(self.setup, q))
        return self.quantity.value(self.setup.system, self.draw.seen(self._snapshot(q)))

    def _driven(self, setup: FreeToTurn, q: Array) -> Snapshot:
        """The system with its drive, at the time at which that comes through a pose."""
        reference = Reference(setup.driven, self.draw.values)
        rate, target = reference.number(setup.rate), setup.drive.target
        assert target is not None
        begin = reference.number(substitute(target, {"t": ZERO}))
        still = self.draw.reference.snapshot(q, np.zeros_like(q))
        t = (still.value(self.measure) - begin) / rate
        return reference.snapshot(q, reference.velocities(q, (), t, with_start=False), t)


def extremes_in_numbers(turn: DrawnTurn) -> tuple[float, float]:
    """The least and the largest value round a turn by the numeric route alone: beside every pose on the way that beats
    its neighbours, by Brent's method."""
    return _extreme_places(turn, 1.0)[0][1], _extreme_places(turn, -1.0)[0][1]


def time_ratio_in_numbers(turn: DrawnTurn) -> float:
    """The longer of the two ways between the places of the extremes over the shorter one, by the numeric route alone.
    Raises CannotAnswer where one of them is reached more than once a turn."""
    largest = max(abs(value) for _away, _q, value in _values_on_the_way(turn))
    places: list[float] = []
    for sign in (1.0, -1.0):
        found = _extreme_places(turn, sign)
        if len(found) > 1 and abs(found[1][1] - found[0][1]) <= _SAME * largest:
            raise CannotAnswer(REACHED_OFTEN)
        places.append(found[0][0])
    between = abs(math.remainder(places[1] - places[0], math.tau))
    return (math.tau - between) / between


def _extreme_places(turn: DrawnTurn, sign: float) -> list[tuple[float, float]]:
    """(angle from the start, value) wherever sign times the quantity has a least value, the least of all first."""
    poses = _values_on_the_way(turn)
    beside = zip(poses[-1:] + poses[:-1], poses, poses[1:] + poses[:1], strict=True)
    lowest = [b for a, b, c in beside if sign * b[2] <= min(sign * a[2], sign * c[2])]
    return sorted((_closer(turn, pose, sign) for pose in lowest), key=lambda place: sign * place[1])


def _values_on_the_way(turn: DrawnTurn) -> list[tuple[float, Array, float]]:
    """(angle from the start, pose, value) all round the turn, one after the other. Raises CannotAnswer where the
    quantity is another one after it."""
    poses = [(away, q, turn.value(q)) for away, q in sorted(turn.poses(), key=lambda pose: pose[0])]
    (begin, first, _value), (_away, last, _last) = poses[0], poses[-1]
    same = turn.value(turn.pose(first, begin)), turn.value(turn.pose(last, begin + math.tau))
    if abs(same[0] - same[1]) > _SAME * max(map(abs, same)):
        raise CannotAnswer(Message("it grows with every turn of {x}", x=turn.c.name))
    return poses


def _closer(turn: DrawnTurn, pose: tuple[float, Array, float], sign: float) -> tuple[float, float]:
    """Where the least of sign times the quantity is beside a pose, and the quantity there."""
    away, q, best = pose

    def value(x: float) -> float:
        nonlocal q
        q = turn.pose(q, x)  # from the pose before, which is nearer with every step
        return sign * turn.value(q)

    place, found = least_between(value, away - STEP, away + STEP, xtol=_PLACE)
    return (place, sign * found) if found <= sign * best else (away, best)
