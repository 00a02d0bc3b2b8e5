"""The checks that every connection, load and integrator passes, to be run on your own.

    from freebody.testing.conformance import CONNECTION_CHECKS, check_connection
    check_connection("midpoint")                    # all of them; raises AssertionError with what does not hold

A connection or load is named by its kind; its `example` is the model, or of `kind: name` one of its `more_examples`.
The checks are identities: a gradient is the finite difference of its measure, reactions do no work on admissible
velocities, action equals reaction, both routes agree. With pytest:
`@pytest.mark.parametrize("name", CONNECTION_CHECKS)`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from importlib.util import find_spec
from typing import Any

import numpy as np

from freebody.api import System
from freebody.connections.base import Connection
from freebody.loads.base import Load
from freebody.measures.geometry import GROUND
from freebody.model.glyphs import Face, Touch
from freebody.numeric.engine.integrators import integrators
from freebody.numeric.jets import Array
from freebody.numeric.options import has_step
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot, snapshot_of
from freebody.numeric.trajectory import integrate
from freebody.study.answering.crosscheck import element_at
from freebody.study.pictures.picture import picture
from freebody.study.setup import Setup
from freebody.study.simulation.simulator import Simulator
from freebody.system.modes import ContactMode, in_mode
from freebody.system.reading.loads import BroughtLoad
from freebody.system.schema import json_schema
from freebody.system.system import System as Description

Check = Callable[[str], None]
CONNECTION_CHECKS: dict[str, Check] = {}
LOAD_CHECKS: dict[str, Check] = {}
SEED = 11
STEP = 1e-5
_GRAVITY = "loads: {weight: {gravity: 9.81 m/s^2}}\n"


def check_connection(kind: str) -> None:
    """All checks of a connection. Raises AssertionError."""
    for check in CONNECTION_CHECKS.values():
        check(kind)


def check_load(kind: str) -> None:
    """All checks of a load. Raises AssertionError."""
    for check in LOAD_CHECKS.values():
        check(kind)


def _of_connections(check: Check) -> Check:
    CONNECTION_CHECKS[check.__name__] = check
    return check


def _of_loads(check: Check) -> Check:
    LOAD_CHECKS[check.__name__] = check
    return check


# -- models and states ------------------------------------------------------------------------
def names_of(kind: str) -> list[str]:
    """A kind, and its further examples."""
    return [kind, *(f"{kind}: {name}" for name in Connection.kinds[kind].more_examples)]


def _model(kind: str) -> str:
    kind, _, name = kind.partition(": ")
    return Connection.kinds[kind].more_examples[name] if name else Connection.kinds[kind].example


@cache
def described(kind: str) -> System:
    """The smallest model with a connection, with weights, so that there is something to transmit."""
    return System.from_text(_model(kind) + _GRAVITY)


@cache
def closed(kind: str) -> Description:
    """The same; what may open is closed, and what may slip sticks. An end touches with its rim: flat, it would be held
    twice."""
    system = described(kind)
    if not system.bounds and not system.dry_friction:
        return system
    flat = {bound.name for bound in system.bounds if bound.pivot is not None}
    held = {bound.name for bound in system.bounds} - flat
    return in_mode(system, ContactMode.of(held, {r.name: 0 for r in system.dry_friction if not flat & {*r.load}}))[0]


@cache
def loaded(kind: str) -> System:
    """The example of a load."""
    return System.from_text(Load.kinds[kind].example)


@cache
def somewhere(system: Description) -> Snapshot:
    """A random admissible pose and motion."""
    reference = Reference(system)
    q, v = reference.wander(reference.assemble(), np.random.default_rng(SEED), 0.2, 0.3)
    return reference.snapshot(q, v, 0.3)


@cache
def _setup(system: Description) -> Setup:
    return Setup(system)


def own_rows(system: Description) -> list[Any]:
    """The rows of the connection `it`."""
    return [row for row in system.constraint_rows if row.connection == "it"]


def _row_of(s: Snapshot, measure: object) -> Array:
    """The gradient of a measure along all coordinates."""
    return s.reference.jet(s.geometry, measure).row(len(s.q))  # pyrefly: ignore[bad-argument-type]


def _moved(s: Snapshot, h: float) -> Snapshot:
    """The state a time h later, to second order."""
    q = s.reference.frame.moved(s.q, h * s.v + h * h / 2 * s.accelerations)
    return snapshot_of(s.reference, q, s.v + h * s.accelerations, s.t + h, near=s)


def equal(found: float, expected: float, what: str, *, relative: float, absolute: float) -> None:
    gap = abs(found - expected)
    assert gap <= max(relative * abs(expected), absolute), f"seed {SEED}: {what} is {found!r}, expected {expected!r}"


# -- connections ------------------------------------------------------------------------------
@_of_connections
def is_described_and_in_the_schema(kind: str) -> None:
    """Its docstring begins with how it is written, and the JSON Schema knows it."""
    kind = kind.partition(": ")[0]
    about = Connection.kinds[kind].__doc__ or ""
    assert about.lstrip().startswith("`"), f"the docstring of {kind} begins with how it is written, in backquotes"
    assert f"{kind}:" in about
    entry = json_schema()["properties"]["connections"]["additionalProperties"]["properties"][kind]
    assert entry["description"]


@_of_connections
def example_is_a_valid_model_that_holds_something(kind: str) -> None:
    """Its example can be read, agrees with the schema, and holds, bounds, resists or pulls something."""
    system = closed(kind)
    assert isinstance(system.connections["it"], Connection.kinds[kind.partition(": ")[0]])  # pyrefly: ignore[bad-argument-type]
    pulls = [load for load in system.loads.values() if isinstance(load, BroughtLoad) and load.brought_by == "it"]
    assert own_rows(system) or pulls, f"{kind} holds nothing in its example"
    _validate(system)


def _validate(system: Description) -> None:
    if find_spec("jsonschema") is None:
        return
    _validator((*Connection.kinds, *Load.kinds)).validate(system.document.data)


@cache
def _validator(_kinds: tuple[str, ...]) -> Any:
    """What checks documents by the schema of the kinds that there are; looking over the schema takes half a second."""
    import jsonschema

    schema = json_schema()
    kind: Any = jsonschema.Draft202012Validator
    kind.check_schema(schema)
    return kind(schema)


@_of_connections
def model_written_back_is_the_same_system(kind: str) -> None:
    """Reading, writing and reading again gives the same system."""
    assert System.from_text(described(kind).to_yaml()) == described(kind)


@_of_connections
def gradient_is_the_finite_difference_of_the_measure(kind: str) -> None:
    """Coordinate by coordinate; of what only has a rate, the rate at a unit speed."""
    s = somewhere(closed(kind))
    for row in own_rows(s.reference.system):
        check_gradient(s, row)


def check_gradient(s: Snapshot, row: Any) -> None:
    """Of one row, in a pose."""
    exact = _row_of(s, row.measure)
    for k in range(len(s.q)):
        unit = np.eye(len(s.q))[k]
        if hasattr(row.measure, "terms") and not hasattr(row.measure, "value"):
            difference = snapshot_of(s.reference, s.q, unit, s.t, near=s).rate(row.measure)
        else:
            ahead, behind = (
                snapshot_of(s.reference, s.reference.frame.moved(s.q, h * unit), s.v, s.t, near=s).value(row.measure)
                for h in (STEP, -STEP)
            )
            difference = (ahead - behind) / (2 * STEP)
        equal(exact[k], difference, f"slope of {row.name} along {k}", relative=1e-7, absolute=1e-8)


@_of_connections
def acceleration_is_the_finite_difference_of_the_rate_along_the_motion(kind: str) -> None:
    """d/dt of the rate of every held measure, along the motion."""
    s = somewhere(closed(kind))
    for row in own_rows(s.reference.system):
        ahead, behind = (_moved(s, h).rate(row.measure) for h in (STEP, -STEP))
        difference = (ahead - behind) / (2 * STEP)
        equal(s.acceleration(row.measure), difference, f"acceleration of {row.name}", relative=1e-6, absolute=1e-5)


@_of_connections
def reactions_do_no_work_on_admissible_velocities(kind: str) -> None:
    """d'Alembert: the power of ideal reactions is zero, row by row, where nothing is driven."""
    s = somewhere(closed(kind))
    for row in s.reference.system.constraint_rows:
        if row.target is not None and "t" in str(row.target):
            continue
        terms = _row_of(s, row.measure) * s.multiplier(row) * s.v
        assert abs(terms.sum()) <= 1e-9 * (1 + np.abs(terms).sum()), f"seed {SEED}: {row.name} has the power {terms}"


@_of_connections
def action_equals_reaction(kind: str) -> None:
    """To move and turn everything together, the ground included, changes no measure that joins bodies."""
    if set(type(described(kind).connections["it"]).model_fields) & {"measure", "expression"}:
        return  # what these hold is written in the user's own measures
    s = somewhere(closed(kind))
    for row in own_rows(s.reference.system):
        check_reaction(s, row)


def check_reaction(s: Snapshot, row: Any) -> None:
    """Of one row, in a pose."""
    n = 3 if s.reference.system.space else 2
    places = {b.name: s.reference.pose(s.q, b.name)[:n] for b in s.reference.system.moving} | {"ground": (0.0,) * n}
    total = np.zeros(6 if n == 3 else 3)
    for body, place in places.items():
        push = np.array(s.gradient(row.measure, body))
        arm, force = (np.pad(np.array(v), (0, 3 - n)) for v in (place, push[:n]))
        moment = np.cross(arm, force)[-(len(push) - n) :]
        total += np.concatenate((push[:n], moment + push[n:]))
    assert float(np.abs(total).max()) <= 1e-9, f"{row.name}: forces and moments on all bodies add up to {total}"


@_of_connections
def both_routes_give_the_same_reactions(kind: str) -> None:
    """The closed form of every reaction, at random poses, against the dense numeric solution."""
    setup = _setup(closed(kind))
    for row in own_rows(setup.system):
        form = setup.state.multiplier(row)
        for draw, snapshot in zip(setup.draws, setup.anywhere, strict=True):
            (value,) = element_at(setup, form, draw, snapshot)
            equal(value, snapshot.multiplier(row), f"reaction of {row.name}", relative=1e-8, absolute=1e-8)


@_of_connections
def is_drawn_with_glyphs_of_its_own(kind: str) -> None:
    """It says what it looks like, and a picture without that is another one."""
    own = Connection.kinds[kind.partition(": ")[0]].glyphs
    assert own is not Connection.glyphs, f"{kind} does not say what is drawn of it: glyphs"
    _check_drawn(System.from_text(_model(kind)))


def _check_drawn(system: Description) -> None:
    own = [shown.sign for shown in system.glyphs if shown.owner == "it"]
    if own and all(isinstance(sign, Face) and sign.normal.body == GROUND for sign in own):
        return  # a plane of the ground is drawn, whatever is on it
    if own and all(isinstance(sign, Touch) for sign in own) and system.space:
        return  # where solids touch is seen of their own outlines; no line of the ground is there to be drawn
    bare = replace(system)
    vars(bare)["glyphs"] = tuple(shown for shown in system.glyphs if shown.owner != "it")
    assert picture(system).svg() != picture(bare).svg(), "what it declares to look like is not seen in a picture"


# -- loads ------------------------------------------------------------------------------------
@_of_loads
def load_is_described_and_in_the_schema(kind: str) -> None:
    """As for connections."""
    assert f"`{kind}:" in (Load.kinds[kind].__doc__ or "")
    entry = json_schema()["properties"]["loads"]["additionalProperties"]["properties"][kind]
    assert entry["description"]


@_of_loads
def load_example_is_a_valid_model(kind: str) -> None:
    """It pushes something, agrees with the schema, and is the same when written back."""
    system = loaded(kind)
    assert isinstance(system.loads["it"], Load.kinds[kind])  # pyrefly: ignore[bad-argument-type]
    pushes = (*system.applied_loads, *system.impulses)
    assert [push for push in pushes if push.load == "it"], f"{kind} pushes nothing in its example"
    assert System.from_text(system.to_yaml()) == system
    _validate(system)


@_of_loads
def load_is_drawn_with_glyphs_of_its_own(kind: str) -> None:
    """As for connections."""
    _check_drawn(loaded(kind))


@_of_loads
def load_pushes_along_the_gradient_of_its_measure(kind: str) -> None:
    """Virtual power: the rate of the measure is its gradient times the velocities."""
    s = somewhere(loaded(kind))
    for push in s.reference.system.applied_loads:
        row = _gradient(s, push.measure)
        for k in range(len(s.q)):
            moved = (s.q + h * np.eye(len(s.q))[k] for h in (STEP, -STEP))
            ahead, behind = (snapshot_of(s.reference, q, s.v, s.t, near=s).value(push.measure) for q in moved)  # pyrefly: ignore[bad-argument-type]
            equal(row[k], (ahead - behind) / (2 * STEP), f"slope of {push.name}", relative=1e-7, absolute=1e-8)
        equal(s.rate(push.measure), float(row @ s.v), f"rate of {push.name}", relative=1e-12, absolute=1e-12)


def _gradient(s: Snapshot, measure: Any) -> Array:
    bodies = s.reference.system.moving
    return np.concatenate([s.gradient(measure, b.name)[: 3 if b.turns else 2] for b in bodies])


@_of_loads
def free_bodies_accelerate_by_the_load_over_their_mass(kind: str) -> None:
    """Newton and Euler: M a = gradient * law, where nothing is held."""
    s = somewhere(loaded(kind))
    if s.reference.system.constraint_rows:
        return
    forces = np.zeros(len(s.q))
    for push in s.reference.system.applied_loads:
        forces += _gradient(s, push.measure) * s.law(push)
    gap = np.abs(s.reference.masses * s.accelerations - forces).max()
    assert gap <= 1e-12 * (1 + np.abs(forces).max()), f"mass times acceleration misses the forces by {gap}"


@_of_loads
def both_routes_give_the_same_force(kind: str) -> None:
    """The closed form of the law, at random poses and speeds."""
    setup = _setup(loaded(kind))
    for push in setup.system.applied_loads:
        form = setup.state.law(push)
        for draw, snapshot in zip(setup.draws, setup.anywhere, strict=True):
            (value,) = element_at(setup, form, draw, snapshot)
            equal(value, snapshot.law(push), f"force of {push.name}", relative=1e-10, absolute=1e-10)


@_of_loads
def power_is_minus_the_rate_of_the_stored_energy(kind: str) -> None:
    """Of loads that store energy."""
    if not Load.kinds[kind].stores_energy:
        return
    s = somewhere(loaded(kind))
    behind, ahead = (snapshot_of(s.reference, s.q + h * s.v, s.v, s.t + h, near=s) for h in (-STEP, STEP))
    for push in s.reference.system.applied_loads:
        fall = (behind.potential(push) - ahead.potential(push)) / (2 * STEP)
        equal(s.law(push) * s.rate(push.measure), fall, f"power of {push.name}", relative=1e-6, absolute=1e-7)


@_of_loads
def total_energy_is_constant_along_the_motion(kind: str) -> None:
    """Of loads that store energy, for a second."""
    if not Load.kinds[kind].stores_energy:
        return
    s = somewhere(loaded(kind))

    def energy(now: Snapshot) -> float:
        return now.kinetic_energy + sum(now.potential(push) for push in now.reference.system.applied_loads)

    end = integrate(s.reference, s, s.t + 1.0).snapshots[-1]
    equal(energy(end), energy(s), "total energy after a second", relative=1e-9, absolute=0.0)


# -- integrators ------------------------------------------------------------------------------
def order_of(
    method: str, system: System, steps: tuple[float, float], until: float = 1.0, *, by_tolerance: bool = False
) -> float:
    """The order at which a method converges on a smooth motion: the slope of the logarithm of the error of the poses at
    the end over that of the number of steps, between two lengths of step [s], or two tolerances where a method chooses
    its steps `by_tolerance`."""
    assert method in integrators(), f"there is no method {method}; there are {', '.join(integrators())}"
    simulator = Simulator(system)
    exact = simulator.run(until, tolerance=1e-13).poses[-1]
    found: list[tuple[float, int]] = []
    for size in steps:
        if by_tolerance:
            course = simulator.run(until, tolerance=size, method=method)
        else:
            own: dict[str, Any] = {"step": size} if has_step(method) else {"first_step": size}
            course = simulator.run(until, tolerance=1e-2, method=method, max_step=size, **own)
        found.append((float(np.abs(course.poses[-1] - exact).max()), course.n_steps))
    (first, n_first), (second, n_second) = found
    return math.log(first / second) / math.log(n_second / n_first)
