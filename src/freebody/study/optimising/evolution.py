"""Several goals, and goals without slopes: evolution by pymoo.

Limits are kept before goals count (Deb's rules); a case without a number misses them all.
Sources: Deb, Pratap, Agarwal & Meyarivan, IEEE Trans. Evol. Comput. 6, 2002, 182-197 (NSGA-II); Storn & Price, J.
Global Optim. 11, 1997, 341-359 (differential evolution); Blank & Deb, IEEE Access 8, 2020, 89497-89509 (pymoo).
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.optimising.problem import Problem

_FAR = 1e12
POPULATION = {True: 100, False: 20}  # of several goals, of one


def check_installed(why: str) -> None:
    """Raises InputError where pymoo is missing."""
    if find_spec("pymoo") is None:
        raise InputError(Message('{why}, which needs pymoo; pip install "freebody[{extra}]"', why=why, extra="design"))


def evolve(problem: Problem, generations: int, seed: int) -> tuple[Array, Array, float]:
    """(m, n) cases that no other case of the last generation beats in all goals, and (m, n_goals) their values in SI.
    The last one is by how much limits are missed: 0, or by the best case where none keeps them."""
    is_front = len(problem.goals) > 1
    base: Any = import_module("pymoo.core.problem").Problem
    minimize: Any = import_module("pymoo.optimize").minimize
    made: Any = base(
        n_var=problem.n,
        n_obj=len(problem.goals),
        n_ieq_constr=len(problem.limits) + 1,
        xl=np.zeros(problem.n),
        xu=np.ones(problem.n),
    )
    sizes = _sizes(problem, seed)

    def evaluate(x: Array, out: dict[str, Any], *_args: Any, **_given: Any) -> None:
        out["F"], out["G"] = _goals_and_limits(problem, x, sizes)

    made._evaluate = evaluate
    if is_front:
        algorithm = import_module("pymoo.algorithms.moo.nsga2").NSGA2(pop_size=POPULATION[True])
    else:
        algorithm = import_module("pymoo.algorithms.soo.nonconvex.de").DE(pop_size=POPULATION[False])
    found = minimize(made, algorithm, ("n_gen", generations), seed=seed, verbose=False)
    if found.X is None:
        every = found.pop
        nearest = int(np.argmin(every.get("CV")))
        u = np.atleast_2d(every.get("X")[nearest])
        return u, goal_values(problem, u), float(every.get("CV")[nearest].max())
    u = np.unique(np.atleast_2d(np.asarray(found.X, dtype=np.float64)), axis=0)
    values = goal_values(problem, u)
    order = np.argsort(values[:, 0], kind="stable")
    return u[order], values[order], 0.0


def goal_values(problem: Problem, u: Array) -> Array:
    """(m, n_goals) in SI."""
    return np.column_stack([g.quantity.chosen(problem.places(g.quantity, u)) for g in problem.goals])


def _sizes(problem: Problem, seed: int) -> list[float]:
    u = np.random.default_rng(seed).random((16, problem.n))
    found: list[float] = []
    for limit in problem.limits:
        rooms = np.abs(problem.room(limit, u))
        known = rooms[np.isfinite(rooms)]
        found.append(float(np.median(known)) if known.size and np.median(known) > 0.0 else 1.0)
    return found


def _goals_and_limits(problem: Problem, u: Array, sizes: list[float]) -> tuple[Array, Array]:
    """(m, n_goals) to be small and (m, n_limits + 1) not to be positive, of which the last counts what failed."""
    signs = np.array([g.sign for g in problem.goals])
    goals = signs * goal_values(problem, u)
    kept: list[Array] = []
    for limit, size in zip(problem.limits, sizes, strict=True):
        rooms = problem.room(limit, u) / size
        if limit.relation == "=":
            kept.append(np.abs(rooms).max(axis=1) - 1e-6)
            continue
        counted = np.min(rooms, axis=1) if limit.sign == limit.quantity.side else np.max(rooms, axis=1)
        kept.append(-counted)
    limits = np.column_stack([*kept, np.zeros(len(u))])
    is_wrong = ~(np.isfinite(goals).all(axis=1) & np.isfinite(limits).all(axis=1))
    limits = np.where(np.isfinite(limits), limits, _FAR)
    limits[is_wrong, -1] = 1.0
    return np.where(np.isfinite(goals), goals, _FAR), limits
