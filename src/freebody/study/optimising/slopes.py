"""One goal by gradients: sequential quadratic programming from the points of a Sobol' sequence.

The least of a greatest value, min max_k F_k(u), is not smooth; with one more unknown z it is

    min z   so that   z - F_k(u) >= 0   for all places k.

Where a case has no number, the search is sent back by a great value; after some such cases it ends at the best case
that it has seen: the optimum is then at the edge of what has a number.
Sources: Nocedal & Wright, Numerical Optimization, 2nd ed. 2006, ch. 18 (SQP), eq. 17.36 (the greatest value);
Kraft, DFVLR-FB 88-28, 1988 (the method used).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.optimising.problem import Limit, Problem

FAR = 1e6  # in sizes of the goal: where there is no number
KEPT = 1e-8  # of the size of a limit, by which it may be missed
_MOST = 300  # steps of one start
_MOST_FAILED = 25  # cases without a number that end one start


@dataclass(frozen=True)
class Run:
    """Where one start led: u (n,), value of the goal, by how much limits are missed in their sizes."""

    start: Array
    u: Array
    value: float
    missed: float

    @property
    def is_good(self) -> bool:
        return np.isfinite(self.value) and self.missed <= KEPT


class _AtAnEdge(Exception):
    """A search goes on into cases without a number."""


class Search:
    """The functions of one goal and all limits, by sizes."""

    def __init__(self, problem: Problem, starts: Array) -> None:
        self.problem = problem
        self.goal = problem.goals[0]
        self._best: Array | None = None
        self._most_failed = 0
        self.is_minimax = self.goal.quantity.n_places > 1 and self.goal.quantity.side == self.goal.sign
        self.size = _size(problem.places(self.goal.quantity, starts))
        self.sizes = [
            _size(problem.places(each.bound, starts), problem.places(each.quantity, starts)) for each in problem.limits
        ]

    # -- the goal -------------------------------------------------------------------------------
    def value(self, u: Array) -> float:
        """In SI, as it was asked for."""
        return float(self.goal.quantity.chosen(self.problem.places(self.goal.quantity, u))[0])

    def goals(self, u: Array) -> Array:
        """(n_places,) of which the greatest is to be small."""
        return self.goal.sign * self.problem.places(self.goal.quantity, u)[0] / self.size

    def goal_slopes(self, u: Array) -> Array:
        return self.goal.sign * self.problem.slopes(self.goal.quantity, u) / self.size

    def objective(self, u: Array) -> float:
        x = self.goal.sign * self.value(u) / self.size
        return x if np.isfinite(x) else FAR

    def objective_slope(self, u: Array) -> Array:
        """(n,) of the place that counts."""
        values = self.goals(u)
        if not np.isfinite(values).all():
            return np.zeros(self.problem.n)
        side = self.goal.quantity.side * self.goal.sign
        return _known(self.goal_slopes(u)[int(np.argmax(side * values))])

    # -- limits -----------------------------------------------------------------------------------
    def rooms(self, k: int, u: Array) -> Array:
        """(n_places,) by how much limit k is kept: all places where all have to keep it, else the one that counts."""
        limit = self.problem.limits[k]
        found = self.problem.room(limit, u)[0] / self.sizes[k]
        found = found if _is_of_all(limit) else found[[self._counts(limit, found)]]
        return np.where(np.isfinite(found), found, -FAR)

    def room_slopes(self, k: int, u: Array) -> Array:
        limit = self.problem.limits[k]
        found = self.problem.room_slopes(limit, u) / self.sizes[k]
        if not _is_of_all(limit):
            found = found[[self._counts(limit, self.problem.room(limit, u)[0])]]
        return _known(found)

    def _counts(self, limit: Limit, rooms: Array) -> int:
        """The place whose value is the greatest, or the least."""
        return int(np.argmax(np.where(np.isfinite(rooms), -limit.sign * limit.quantity.side * rooms, -np.inf)))

    def missed(self, u: Array) -> float:
        worst = 0.0
        for k, limit in enumerate(self.problem.limits):
            rooms = self.rooms(k, u)
            worst = max(worst, float(np.abs(rooms).max() if limit.relation == "=" else -rooms.min()))
        return worst

    # -- one start --------------------------------------------------------------------------------
    def _looked_at(self, u: Array) -> None:
        """Keeps the best case of a start. Raises _AtAnEdge after too many cases without a number."""
        if sum(self.problem.failed.values()) > self._most_failed:
            raise _AtAnEdge
        value = self.value(u)
        if (
            np.isfinite(value)
            and self.missed(u) <= KEPT
            and (self._best is None or self.goal.sign * value < self.goal.sign * self.value(self._best))
        ):
            self._best = u.copy()

    def run(self, start: Array) -> Run:
        optimize: Any = import_module("scipy.optimize")
        n = self.problem.n
        self._best, self._most_failed = None, sum(self.problem.failed.values()) + _MOST_FAILED
        x0, bounds = start, [(0.0, 1.0)] * n
        function, slope = self.objective, self.objective_slope
        constraints = [
            self._constraint(
                "eq" if limit.relation == "=" else "ineq",
                lambda x, k=k: self.rooms(k, x[:n]),
                lambda x, k=k: self.room_slopes(k, x[:n]),
            )
            for k, limit in enumerate(self.problem.limits)
        ]
        if self.is_minimax:
            x0, bounds = np.append(start, self.objective(start)), [*bounds, (None, None)]
            function, slope = _last, _last_slope
            constraints.append(self._constraint("ineq", self._below, self._below_slopes))

        def watched(x: Array) -> float:
            self._looked_at(x[:n])
            return function(x)

        try:
            found = optimize.minimize(
                watched,
                x0,
                jac=slope,
                bounds=bounds,
                constraints=constraints,
                method="SLSQP",
                options={"ftol": 1e-14, "maxiter": _MOST},
            )
            u = np.clip(np.asarray(found.x[:n], dtype=np.float64), 0.0, 1.0)
        except _AtAnEdge:
            u = start if self._best is None else self._best
        return Run(start, u, self.value(u), self.missed(u))

    def _constraint(
        self, kind: str, function: Callable[[Array], Array], slopes: Callable[[Array], Array]
    ) -> dict[str, Any]:
        n = self.problem.n

        def padded(x: Array) -> Array:
            found = slopes(x)
            return found if found.shape[1] == len(x) else np.hstack((found, np.zeros((len(found), len(x) - n))))

        return {"type": kind, "fun": function, "jac": padded}

    def _below(self, x: Array) -> Array:
        values = x[-1] - self.goals(x[:-1])
        return np.where(np.isfinite(values), values, -FAR)

    def _below_slopes(self, x: Array) -> Array:
        found = _known(self.goal_slopes(x[:-1]))
        return np.hstack((-found, np.ones((len(found), 1))))


def _last(x: Array) -> float:
    return float(x[-1])


def _last_slope(x: Array) -> Array:
    return np.append(np.zeros(len(x) - 1), 1.0)


def _is_of_all(limit: Limit) -> bool:
    """Whether every place has to keep it: the greatest value below, the least one above a bound."""
    return limit.quantity.n_places == 1 or limit.sign == limit.quantity.side


def _size(*of: Array) -> float:
    """Of the numbers that it takes at the starts."""
    known = np.concatenate([np.abs(x[np.isfinite(x)]) for x in of])
    return float(np.median(known)) if known.size and np.median(known) > 0.0 else float(known.max(initial=0.0)) or 1.0


def _known(slopes: Array) -> Array:
    return np.where(np.isfinite(slopes), slopes, 0.0)
