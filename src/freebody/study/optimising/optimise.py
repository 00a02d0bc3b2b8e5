"""The best case of a system: goals under limits, over what varies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from freebody.errors import CannotAnswer, InputError
from freebody.language.sentences import Message, further
from freebody.numeric.options import SimulationOptions
from freebody.study.given import each
from freebody.study.optimising.conditions import Conditions, conditions, sharpened
from freebody.study.optimising.evolution import check_installed, evolve
from freebody.study.optimising.problem import Problem, read_problem
from freebody.study.optimising.result import Optimum, check_path
from freebody.study.optimising.slopes import KEPT, Run, Search
from freebody.study.sweeps.plan import Given
from freebody.study.worded import in_words
from freebody.system.system import System

STARTS, GENERATIONS = 16, 150
_SAME = 1e-6  # of its size: two starts came to the same value
METHODS = ("auto", "gradients", "evolution")

Method = Literal["auto", "gradients", "evolution"]


@in_words
def optimise(
    system: System,
    minimise: str | Sequence[str] = (),
    *,
    maximise: str | Sequence[str] = (),
    subject_to: str | Sequence[str] = (),
    over: Mapping[str, Given] | None = None,
    until: float | None = None,
    starts: int = STARTS,
    generations: int = GENERATIONS,
    seed: int = 0,
    method: str = "auto",
    options: SimulationOptions | None = None,
    out: str | Path | Sequence[str | Path] = (),
    **given: Any,
) -> Optimum:
    """The values of parameters and start values at which a goal is best.

    minimise, maximise: quantities as of `sweep` and `solve`, formulas in parameters, or `maximum of Q over theta`;
    several for a Pareto front. subject_to: limits, as "tension < 30 N"; over: bounds by name, as "0.1..0.5 m". until:
    of motions [s]; starts: of searches by gradients, a power of two; generations: of an evolution; method: auto,
    gradients or evolution; out: files to write, reports or .csv.

    Raises InputError for what cannot be read, CannotAnswer where no start has a number."""
    if method not in METHODS:
        raise InputError(Message("there is no method {name}; take {names}", name=method, names=", ".join(METHODS)))
    if generations < 1:
        raise InputError(Message("an evolution has at least one generation, not {n}", n=generations))
    paths = [Path(path) for path in ([out] if isinstance(out, str | Path) else out)]
    for path in paths:
        check_path(path)
    problem = read_problem(
        system,
        each(minimise),
        each(maximise),
        each(subject_to),
        over or {},
        until=until,
        options=replace(options or SimulationOptions(), **given),
        starts=starts,
        seed=seed,
    )
    found = _found(problem, method, starts, generations, seed)
    return replace(found, files=tuple(file for path in paths for file in found.write(path)))


def _found(problem: Problem, method: str, starts: int, generations: int, seed: int) -> Optimum:
    if len(problem.goals) > 1:
        if method == "gradients":
            raise InputError(Message("several goals are weighed by evolution only; leave --method out"))
        check_installed(Message("several goals are weighed by evolution"))
        _check_starts(problem, starts)
        u, values, missed = evolve(problem, generations, seed)
        return Optimum(problem, "evolution", u, values, missed, generations=generations)
    if method == "evolution" or (method == "auto" and not problem.is_smooth):
        check_installed(Message("what is read off motions is optimised by evolution"))
        return _by_evolution(problem, starts, generations, seed)
    search = Search(problem, _check_starts(problem, starts))
    return _by_gradients(search, starts)


def _check_starts(problem: Problem, starts: int) -> Any:
    """(n_starts, n) those with a number of the goals. Raises CannotAnswer if there is none, and InputError for a goal
    that is the same in all."""
    x = problem.plan.sampled.cases(0, starts)
    u = (x - problem.low) / (problem.high - problem.low)
    good = np.ones(len(u), dtype=bool)
    for goal in problem.goals:
        values = goal.quantity.chosen(problem.places(goal.quantity, u))
        good &= np.isfinite(values)
        known = values[np.isfinite(values)]
        if len(known) > 1 and not np.ptp(known) > 1e-12 * np.abs(known).max():
            raise InputError(
                Message(
                    "{text} is {value:.6g} in all cases that were looked at: it does not depend on {names} there",
                    text=goal.quantity.text,
                    value=float(known[0]),
                    names=", ".join(v.name for v in problem.names),
                )
            )
    if not good.any():
        why = further(*(f"{f.of}: {f.status}{f': {f.why}' if f.why else ''}" for f in problem.failed))
        raise CannotAnswer(Message("none of {n} starts has a number of the goal: {why}", n=starts, why=why))
    return u[good]


def _by_gradients(search: Search, starts: int) -> Optimum:
    """From every start; the best of those that keep all limits."""
    problem = search.problem
    x = problem.plan.sampled.cases(0, starts)
    every = (x - problem.low) / (problem.high - problem.low)
    runs = [search.run(u) for u in every if np.isfinite(search.value(u))]
    best = _best(search, runs)
    n_same = sum(run.is_good and abs(run.value - best.value) <= _SAME * search.size for run in runs)
    known = None
    if best.is_good:
        u = sharpened(search, best.u)
        best, known = replace(best, u=u, value=search.value(u), missed=search.missed(u)), conditions(search, u)
    return Optimum(
        problem,
        "gradients",
        best.u[None, :],
        np.array([[best.value]]),
        0.0 if best.is_good else best.missed,
        known,
        tuple(runs),
        n_starts=starts,
        n_same=n_same,
    )


def _best(search: Search, runs: Sequence[Run]) -> Run:
    good = [run for run in runs if run.is_good]
    if good:
        return min(good, key=lambda run: search.goal.sign * run.value)
    return min(runs, key=lambda run: run.missed)


def _by_evolution(problem: Problem, starts: int, generations: int, seed: int) -> Optimum:
    """Differential evolution; then gradients by differences from where it led, if that is better."""
    search = Search(problem, _check_starts(problem, starts))
    u, values, missed = evolve(problem, generations, seed)
    k = int(np.argmin(search.goal.sign * values[:, 0]))
    best = Run(u[k], u[k], float(values[k, 0]), missed)
    refined = search.run(u[k])
    known: Conditions | None = None
    if refined.is_good and (missed > KEPT or search.goal.sign * (refined.value - best.value) <= 0.0):
        best, missed = refined, 0.0
        known = conditions(search, best.u)
    return Optimum(
        problem, "evolution", best.u[None, :], np.array([[best.value]]), missed, known, generations=generations
    )
