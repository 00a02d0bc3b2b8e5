"""The problem: goals, limits, and what varies between which values, each in parts of its range.

With u in [0, 1] for every name that varies, a goal is to be as small as possible (sign +1) or as great (-1); a limit is
told as a number that must not be negative, or, for an equation, must be zero:

    Q <= c:   c - Q >= 0        Q >= c:   Q - c >= 0        Q = c:   c - Q = 0
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message, lines
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.study.given import formula_of
from freebody.study.optimising.quantities import STEP, Asked, Failed, Formula, Over, Quantity, Through, read_formula
from freebody.study.sweeps.answers import AnswerEvaluator
from freebody.study.sweeps.motions import MotionEvaluator
from freebody.study.sweeps.plan import Given, Plan, plan
from freebody.study.sweeps.ranges.span import Span
from freebody.study.sweeps.sweep import questions_asked
from freebody.study.sweeps.varied import Varied
from freebody.system.system import System

_RELATION = re.compile(r"\s*(<=|>=|==|≤|≥|<|>|=)\s*")
_WORDS = {"<": "<=", ">": ">=", "==": "=", "≤": "<=", "≥": ">="}
TURN = "0..360 deg"


@dataclass(frozen=True)
class Goal:
    """sign: 1 if it is to be small, -1 if great."""

    quantity: Quantity
    sign: int

    @property
    def words(self) -> str:
        return f"{'minimise' if self.sign > 0 else 'maximise'} {self.quantity.text}"


@dataclass(frozen=True)
class Limit:
    """quantity relation bound; relation: <=, >= or =."""

    text: str
    quantity: Quantity
    relation: str
    bound: Formula

    @property
    def sign(self) -> int:
        """By which bound - quantity is multiplied."""
        return -1 if self.relation == ">=" else 1


@dataclass
class Problem:
    """low, high: (n,) of what varies, in SI; failed: what had no number, by its words, and how often."""

    given: System
    plan: Plan
    names: tuple[Varied, ...]
    goals: tuple[Goal, ...]
    limits: tuple[Limit, ...]
    low: Array
    high: Array
    failed: dict[Failed, int] = field(default_factory=dict[Failed, int])
    n_cases: int = 0
    _seen: dict[tuple[int, bytes], Array] = field(default_factory=dict[tuple[int, bytes], Array])

    @property
    def n(self) -> int:
        return len(self.names)

    @property
    def quantities(self) -> list[Quantity]:
        return [*(g.quantity for g in self.goals), *(q for each in self.limits for q in (each.quantity, each.bound))]

    @property
    def is_smooth(self) -> bool:
        return all(q.is_smooth for q in self.quantities)

    @property
    def is_exact(self) -> bool:
        return all(q.is_exact for q in self.quantities)

    @property
    def is_linear(self) -> bool:
        """Whether goals and limits are proved to be linear in what varies."""
        names = [v.parameter for v in self.names]
        return all(q.is_linear_in(names) for q in self.quantities)

    def values(self, u: Array) -> Array:
        """(..., n) in SI."""
        return self.low + u * (self.high - self.low)

    def cases(self, u: Array) -> dict[str, Array]:
        """(m, n) cases by parameter."""
        x = self.values(np.atleast_2d(u))
        return {v.parameter: np.ascontiguousarray(x[:, k]) for k, v in enumerate(self.names)}

    def places(self, quantity: Quantity, u: Array) -> Array:
        """(m, n_places) numbers of a quantity in cases (m, n); what fails is counted."""
        u = np.atleast_2d(u)
        keys = [(id(quantity), row.tobytes()) for row in u]  # goals, limits and slopes look at the same cases
        new = [k for k, key in enumerate(keys) if key not in self._seen]
        if new:
            self.n_cases += len(new)
            found, failed = quantity.places(self.cases(u[new]), len(new))
            for k, numbers, one in zip(new, found, failed, strict=True):
                self._seen[keys[k]] = numbers
                if one is not None:
                    self.failed[one] = self.failed.get(one, 0) + 1
        every: Array = np.array([self._seen[key] for key in keys], dtype=np.float64)
        return every

    def slopes(self, quantity: Quantity, u: Array) -> Array:
        """(n_places, n) by the parts of ranges in one case: exact where a formula holds, else central differences,
        one-sided at the end of a range."""
        found = quantity.slopes(self.cases(u), 1, [v.parameter for v in self.names])[0]
        if np.isfinite(found).all():
            return found * (self.high - self.low)
        if not np.isfinite(self.places(quantity, u)).all():
            nothing: Array = np.full((quantity.n_places, self.n), np.nan)
            return nothing
        columns: list[Array] = []
        for k in range(self.n):
            pair = np.array([u, u])
            pair[0, k], pair[1, k] = min(u[k] + STEP, 1.0), max(u[k] - STEP, 0.0)
            ahead, behind = self.places(quantity, pair)
            columns.append((ahead - behind) / (pair[0, k] - pair[1, k]))
        return np.column_stack(columns)

    def room(self, limit: Limit, u: Array) -> Array:
        """(m, n_places) by how much a limit is kept; that of an equation is its error."""
        return limit.sign * (self.places(limit.bound, u) - self.places(limit.quantity, u))

    def room_slopes(self, limit: Limit, u: Array) -> Array:
        """(n_places, n)."""
        return limit.sign * (self.slopes(limit.bound, u) - self.slopes(limit.quantity, u))


# -- reading ----------------------------------------------------------------------------------
def read_problem(
    system: System,
    minimise: Sequence[str],
    maximise: Sequence[str],
    limits: Sequence[str],
    over: Mapping[str, Given],
    *,
    until: float | None,
    options: SimulationOptions,
    starts: int,
    seed: int,
) -> Problem:
    """Raises InputError for what cannot be read."""
    if not minimise and not maximise:
        raise InputError(Message("there is no goal: say what to minimise or to maximise"))
    if not over:
        raise InputError(Message("nothing varies: say over what, as --over b=0.1..0.5m"))
    sides = [_sides(text) for text in limits]
    texts = [*minimise, *maximise, *(left for left, _relation, _right in sides)]
    turned = _turned(texts)
    for name in turned.keys() & over.keys():
        raise InputError(Message("{name} varies and is gone over in a maximum; it can be one of the two", name=name))
    cases = plan(system, over, turned, f"sobol:{starts}", seed)
    names = cases.names[: len(over)]
    low, high = _bounds(cases, names)
    read = _Reader(system, cases, until, options)
    goals = [Goal(read(text), sign) for group, sign in ((minimise, 1), (maximise, -1)) for text in group]
    found = [read.limit(text, *parts) for text, parts in zip(limits, sides, strict=True)]
    problem = Problem(system, cases, names, tuple(goals), tuple(found), low, high)
    _check_dependence(problem)
    return problem


def _sides(text: str) -> tuple[str, str, str]:
    parts = _RELATION.split(text.strip())
    over = re.search(r" over \S+\s*=", text)  # the equals sign of a range
    if over is not None and len(parts) == 5:
        cut = _RELATION.split(text[over.end() :])
        parts = [text[: over.end()] + cut[0], *cut[1:]]
    if len(parts) != 3 or not parts[0] or not parts[2]:
        raise InputError(Message("'{text}' is no limit: write for example tension < 30 N, with <, > or =", text=text))
    left, relation, right = parts
    return left, _WORDS.get(relation, relation), right


def _turned(texts: Sequence[str]) -> dict[str, str]:
    """What maxima go over, with its range. Raises InputError for two ranges of one name."""
    found: dict[str, str] = {}
    for text in texts:
        over = Over.read(text)
        if over is None:
            continue
        given = over.range or TURN
        if found.setdefault(over.name, given) != given:
            raise InputError(
                Message("{name} is gone over in two ranges, {a} and {b}", name=over.name, a=found[over.name], b=given)
            )
    return found


def _bounds(cases: Plan, names: Sequence[Varied]) -> tuple[Array, Array]:
    low, high = (np.array([cases.extents[v.name][side] for v in names]) for side in (0, 1))
    for k, v in enumerate(names):
        of = cases.sampled.ranges[v.name]
        if not isinstance(of, Span) or of.n is not None:
            told = Message("{name}: the best value is looked for between two bounds, as {name}=1..3", name=v.name)
            raise InputError(told)
        if not np.isfinite(low[k]) or low[k] >= high[k] or of.low > of.high:
            raise InputError(
                Message("{name}: the range is empty; the first bound must be the smaller one", name=v.name)
            )
    return low, high


class _Reader:
    """Makes a quantity of a text."""

    def __init__(self, given: System, cases: Plan, until: float | None, options: SimulationOptions) -> None:
        self.given, self.cases, self.until, self.options = given, cases, until, options
        self._known: dict[str, Quantity] = {}

    def __call__(self, text: str) -> Quantity:
        if text not in self._known:
            self._known[text] = self._read(text)
        return self._known[text]

    def _read(self, text: str) -> Quantity:
        over = Over.read(text)
        if over is not None:
            name = next(v.parameter for v in self.cases.names if v.name == over.name)
            grid = self.cases.over.ranges[over.name].grid
            assert grid is not None
            return Through(text, self._plain(over.what), name, grid, over.side)
        if self.until is None:
            return self._plain(text)
        try:
            return Asked(text, MotionEvaluator(self.cases.system, [text], self.until, self.options))
        except InputError as error:
            told = error
        try:
            return self._plain(text)
        except InputError as other:
            raise InputError(lines([str(told), str(other)])) from other

    def _plain(self, text: str) -> Quantity:
        """A formula in parameters, or a question."""
        is_id = text in [q.id for q in self.cases.system.questions]
        formula = None if is_id else read_formula(self.cases.system, text)
        return Asked(text, self._answer(text)) if formula is None else formula

    def _answer(self, text: str) -> AnswerEvaluator:
        (question,) = questions_asked(self.cases.system, [text])
        return AnswerEvaluator(self.cases.system, question)

    def limit(self, text: str, left: str, relation: str, right: str) -> Limit:
        quantity = self(left)
        system = self.cases.system
        bound = Formula(system, right, formula_of(system, quantity.dimension, left, right), quantity.dimension)
        return Limit(" ".join(text.split()), quantity, relation, bound)


def _check_dependence(problem: Problem) -> None:
    """Raises InputError for a goal that does not depend on what varies, and for what varies in vain."""
    for goal in problem.goals:
        if all(goal.quantity.depends_on(v.parameter) is False for v in problem.names):
            raise InputError(
                Message(
                    "{text} does not depend on {names}: vary something that it depends on",
                    text=goal.quantity.text,
                    names=", ".join(v.name for v in problem.names),
                )
            )
    for v in problem.names:
        if all(q.depends_on(v.parameter) is False for q in problem.quantities):
            raise InputError(Message("neither a goal nor a limit depends on {name}: leave it out", name=v.name))
