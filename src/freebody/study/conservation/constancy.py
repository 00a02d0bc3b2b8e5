"""The second opinion on conservation: the quantity along motions that the engine follows.

Motions start from general poses and speeds, at random admissible numbers. A conserved quantity may drift by 1e-9 of
its size; one that is not must change in at least one of them, which is then told as the counter-motion. Under
conditions both are done: with the condition it stays, without it it changes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial, singledispatch
from itertools import takewhile
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Expr, Symbol, number, substitute
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_MOMENTUM, ENERGY, MOMENTUM
from freebody.numeric.jets import Array
from freebody.numeric.potential import work_between
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.questions.energy import Energy
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.draws import SEED, Draw
from freebody.study.answering.magnitude import magnitude
from freebody.study.conservation.balance import RateBalance
from freebody.study.setup import Setup
from freebody.symbolic.vanishing import VanishingCase, is_given_function
from freebody.system.system import System

TOLERANCE = 1e-9  # of the size of a conserved quantity
VISIBLE = 1e-6  # of the size: more than this is a change
_DURATION = 1.5  # [s]; motions run at about one size, or radian, a second
_N_TIMES = 9
_FEWEST = 3  # instants of a motion that tells something
N_MOTIONS = 5
N_IN_SEARCH = 3
_STEP_TOLERANCE = 1e-12  # of the motions: a thousandth of the change that is looked for
_SLOW = 1e-3
_MOST_STEPS = 2000  # of one motion; what has been computed by then counts


@dataclass(frozen=True)
class Confirmation:
    """What simulations showed."""

    motions: int
    largest_drift: float | None  # of a conserved quantity, by its size
    smallest_change: float | None  # of one that is not, by its size
    route: str = Message("simulation from general poses and speeds at random admissible numbers")

    def to_plain(self) -> dict[str, Any]:
        return {
            "motions": self.motions,
            "largest_drift": self.largest_drift,
            "smallest_change": self.smallest_change,
            "route": self.route,
        }


@dataclass(frozen=True)
class CounterMotion:
    """A motion along which a quantity changes: from where, with which numbers, from what to what (SI)."""

    parameters: Mapping[str, float]
    start: Mapping[str, float]  # named measures and their rates at the start
    before: float
    after: float
    time: float

    def to_plain(self) -> dict[str, Any]:
        return {
            "parameters": dict(self.parameters),
            "start": dict(self.start),
            "before": self.before,
            "after": self.after,
            "time": self.time,
        }


def confirm(
    runs: SimulatedRuns, balance: RateBalance, cases: Sequence[VanishingCase], is_conserved: bool | None
) -> tuple[Confirmation | None, CounterMotion | None]:
    """Simulates; raises RoutesDisagree where a motion says otherwise."""
    drifts: list[float] = []
    changes: list[float] = []
    counter: CounterMotion | None = None
    name = balance.name
    for case in cases:
        if case.is_solved:
            for motion in runs.along(balance, case if case.equalities else None):
                if motion.drift > TOLERANCE:
                    motion = motion.on_branch()
                    if len(motion.values) < _FEWEST:
                        continue
                if motion.drift > TOLERANCE:
                    raise RoutesDisagree(
                        Message(
                            "{name} should stay constant, and changes by {drift:.2g} of its size in a "
                            "simulation. No answer is shown. This is a defect of freebody; please report the model",
                            name=name,
                            drift=motion.drift,
                        )
                    )
                drifts.append(motion.drift)
    if is_conserved is not True:
        for motion in runs.along(balance, None):
            if motion.drift > VISIBLE:
                changes.append(motion.drift)
                counter = counter or motion.told()
    if not drifts and not changes:
        return None, None
    return Confirmation(len(drifts) + len(changes), max(drifts, default=None), min(changes, default=None)), counter


@dataclass(frozen=True)
class SimulatedQuantity:
    """A quantity along a simulated motion."""

    times: Array
    values: Array
    size: float
    start: Snapshot
    system: System
    n_on_branch: Callable[[], int]  # the first instants, up to which all is positive that its formula takes to be so

    def on_branch(self) -> SimulatedQuantity:
        """As far as its formula holds."""
        n = self.n_on_branch()
        return replace(self, times=self.times[:n], values=self.values[:n])

    @property
    def drift(self) -> float:
        return float(np.abs(self.values - self.values[0]).max()) / self.size

    def told(self) -> CounterMotion:
        k = int(np.abs(self.values - self.values[0]).argmax())
        measured: dict[str, float] = {}
        for name, measure in self.system.measures.items():
            measured[name] = float(self.start.value(measure))
            measured[f"rate({name})"] = float(self.start.rate(measure))
        values = {p: v for p, v in self.start.reference.frame.values.items() if p in self.system.parameters}
        return CounterMotion(values, measured, float(self.values[0]), float(self.values[k]), float(self.times[k]))


class SimulatedRuns:
    """Simulated motions of one system, each kept for all quantities: from general poses and speeds, at random
    admissible numbers, or at numbers that obey the equalities of a case."""

    def __init__(self, setup: Setup, n_motions: int = N_MOTIONS) -> None:
        self.setup = setup
        self.n_motions = n_motions
        self._known: dict[tuple[str, ...], list[SimulatedRun]] = {}
        self._read: dict[tuple[Quantity, tuple[str, ...]], list[SimulatedQuantity]] = {}

    def along(self, balance: RateBalance, case: VanishingCase | None) -> list[SimulatedQuantity]:
        """The quantity along a few motions."""
        key = balance.quantity, () if case is None else case.texts()
        if key not in self._read:
            found: list[SimulatedQuantity] = []
            self._read[key] = found
            for run in self._runs(case):
                with suppress(CannotAnswer):
                    motion = _motion(self.setup, balance, run)
                    if motion is not None:
                        found.append(motion)
        return self._read[key]

    def _runs(self, case: VanishingCase | None) -> list[SimulatedRun]:
        key = () if case is None else case.texts()
        if key not in self._known:
            found: list[SimulatedRun] = []
            self._known[key] = found
            for k, draw in enumerate(self.setup.draws):
                if len(found) == self.n_motions:
                    break
                with suppress(CannotAnswer):
                    own = draw if case is None else _in_case(self.setup, draw, case)
                    found += [
                        replace(run, has_other_forms=own.reference.system is not draw.reference.system)
                        for run in _run(own, SEED + k)
                    ]
        return self._known[key]


@dataclass(frozen=True)
class SimulatedRun:
    """A simulated motion."""

    draw: Draw
    times: Array
    snapshots: tuple[Snapshot, ...]
    has_other_forms: bool = False  # of given functions of time than the file has


def _in_case(setup: Setup, draw: Draw, case: VanishingCase) -> Draw:
    """A draw whose numbers obey the equalities of a case."""
    model, system = setup.model, setup.system
    numbers = model.samples.numbers(draw.sample())
    values = dict(draw.values)
    forms: dict[str, Expr] = {}
    orders: dict[str, int] = {}
    for index, element in case.values.items():
        shown = model.field.generators[index].display
        if is_given_function(model.field, index):
            name, order = _function(shown)
            if name in orders and orders[name] <= order:
                continue
            orders[name] = order
            if all(_is_number(system, model.field.generators[k].display) for k in element.generators()):
                forms[name] = _polynomial(order, float(model.field.evaluate(element, numbers)))
                continue
            # equal to other functions: to their forms, which have no symbols of functions
            others = {p.name: p.form for p in system.parameters.values() if p.form is not None}
            related = substitute(model.field.expression(element), others)
            if order or "rate(" in str(related):
                raise CannotAnswer(Message("the case relates rates of given functions to each other"))
            forms[name] = related
        elif isinstance(shown, Symbol) and shown.name in values:
            values[shown.name] = float(model.field.evaluate(model.field.element(element), numbers))
    return draw.with_values(values, _with_forms(system, forms) if forms else system)


def _is_number(system: System, shown: Expr) -> bool:
    """Whether a symbol is a parameter with a number, not a function of time."""
    return isinstance(shown, Symbol) and shown.name in system.parameters and system.parameters[shown.name].form is None


def _function(shown: Expr) -> tuple[str, int]:
    """Name and order of x0, rate(x0), rate(rate(x0))."""
    order = 0
    while not isinstance(shown, Symbol):
        shown, order = shown.argument, order + 1  # pyrefly: ignore[missing-attribute]
    return shown.name, order


def _polynomial(order: int, value: float) -> Expr:
    """A function of time whose rate of that order has the value, otherwise general."""
    t = Symbol("t")
    total: Expr = number(0)
    power: Expr = number(1)
    for k in range(order):
        total = total + power * number(3 + 2 * k) / 10
        power = power * t
    return total + power * number(value / math.factorial(order))


def _with_forms(system: System, forms: Mapping[str, Expr]) -> System:
    """The system with other functions of time."""
    others = {p.name: p.form for p in system.parameters.values() if p.form is not None} | dict(forms)
    held = tuple(
        row if row.general is None else replace(row, target=substitute(row.general, others))
        for row in system.constraint_rows
    )
    applied_loads = tuple(
        push if push.general is None else replace(push, law=substitute(push.general, others))
        for push in system.applied_loads
    )
    return replace(system, constraint_rows=held, applied_loads=applied_loads)


def _run(draw: Draw, seed: int) -> list[SimulatedRun]:
    """A motion from a general pose and speed; none if it ends at once."""
    from freebody.study.answering.witness import run

    reference = draw.reference
    start = draw.anywhere(seed, 0.0, 0.3)
    outputs = np.linspace(start.t, start.t + _DURATION, _N_TIMES)
    try:
        engine, course = run(reference, start, outputs, tolerance=_STEP_TOLERANCE, most_steps=_MOST_STEPS)
    except (np.linalg.LinAlgError, ZeroDivisionError):  # gradients that are not finite, or nothing with inertia
        return []
    times = course.times[np.isin(course.times, outputs)]  # where the steps ran out is no time to compare at
    if len(times) < _FEWEST:
        return []
    snapshots = [start]
    for k, t in enumerate(times[1:], 1):
        q, v = map(reference.by_column, engine.coordinates(engine.state_at(course, k)))
        snapshots.append(reference.snapshot(q, v, float(t), snapshots[-1]))
    return [SimulatedRun(draw, times, tuple(snapshots))]


def _motion(setup: Setup, balance: RateBalance, run: SimulatedRun) -> SimulatedQuantity | None:
    """The quantity along a run."""
    read = _reader(setup, balance, run)
    values = np.array([read(s) for s in run.snapshots])

    def n_on_branch() -> int:
        if not balance.quantity.is_of_coordinates:
            return len(values)
        return sum(1 for _ in takewhile(partial(setup.is_on_branch, run.draw), run.snapshots))

    if not np.isfinite(values).all():
        return None
    size = max(float(np.abs(values).max()), max(_size(s, balance) for s in run.snapshots))
    return SimulatedQuantity(run.times, values, size or 1.0, run.snapshots[0], setup.system, n_on_branch)


def _size(snapshot: Snapshot, balance: RateBalance) -> float:
    """What the terms of a quantity come to, where these may cancel; at least as if all moved by a thousandth of the
    size, or of a radian, a second."""
    reference = snapshot.reference
    sizes = reference.sizes
    speeds = np.maximum(np.abs(snapshot.v), _SLOW * sizes.unit_moves)
    shares = reference.masses * speeds
    momentum, spin = (float(shares[which].sum()) for which in (~sizes.turning, sizes.turning))
    dimension = balance.quantity.dimension
    if dimension == MOMENTUM:
        return momentum
    if dimension == ANGULAR_MOMENTUM:
        return momentum * sizes.length + spin
    if dimension != ENERGY:
        return magnitude(dimension, snapshot)
    loads = sum(abs(snapshot.law(push)) for push in balance.storing)
    return float(shares @ speeds) / 2 + _SLOW * loads * sizes.length


def _reader(setup: Setup, balance: RateBalance, run: SimulatedRun) -> Callable[[Snapshot], float]:
    """The quantity at a snapshot: stated over the numbers; by its formula where it is one of coordinates."""
    return _reader_of(balance.quantity, setup, balance, run)


@singledispatch
def _reader_of(
    quantity: Quantity, setup: Setup, balance: RateBalance, run: SimulatedRun
) -> Callable[[Snapshot], float]:
    if quantity.is_of_coordinates:
        if run.has_other_forms:
            raise CannotAnswer(Message("its formula is in the functions of the file, not in those of the case"))
        return lambda s: element_at(setup, (balance.value,), run.draw, s)[0]
    return lambda s: float(quantity.value(setup.system, s))


@_reader_of.register(Energy)
def _reader_of_energy(
    quantity: Energy, setup: Setup, balance: RateBalance, run: SimulatedRun
) -> Callable[[Snapshot], float]:
    """With the work of loads whose potential is not written down."""
    if not quantity.is_up_to_constant:
        return lambda s: float(quantity.value(setup.system, s))

    def energy(s: Snapshot) -> float:
        total = 0.0 if quantity.what == "potential" else float(Energy("kinetic", quantity.body).value(setup.system, s))
        for push in balance.storing:
            if quantity.body is not None and quantity.body not in set(push.measure.bodies()):
                continue
            if push in balance.unwritten:
                first = run.snapshots[0].value(push.measure)  # pyrefly: ignore[bad-argument-type]
                total -= work_between(s.reference, push, first, s.value(push.measure))  # pyrefly: ignore[bad-argument-type]
            else:
                total += s.potential(push)
        return total

    return energy
