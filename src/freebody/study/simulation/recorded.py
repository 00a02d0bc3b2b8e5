"""Everything along a simulated motion, with units and long names.

    time                                       [s]
    body_position (time, body, axis)           of mass centres, ground components [m]; body_velocity, body_acceleration
    body_angle (time, body)                    [rad]; body_angular_velocity, body_angular_acceleration
    <measure>, <measure>_rate, <measure>_acceleration      every named measure
    <connection>.<reaction>                    every reaction, positive as it is named (a tension pulls): `rope.tension`
    <contact>.state                            0 open, 1 closed without friction, 2 sticking, 3 and 4 sliding one way or
                                               the other; <contact>.used_friction: what friction carries by what it can
    <load>.force                               every load that acts along one measure (springs and dampers: pulling)
    kinetic_energy, potential_energy, work     [J]

Where something is struck, closes or collides, these blows in their order:

    blow_time (blow)                           [s]
    blow_energy_lost (blow)                    the kinetic energy that each takes; negative where an impulse gives some
    <connection>.<reaction>.impulse (blow)     of every reaction, zero where it has no part in a blow and NaN where it
                                               is not unique [N s, N m s]

In space `axis` is x, y, z, and a body is turned by

    body_quaternion (time, body, quaternion)            w, x, y, z, continuous in time
    body_rotation_matrix (time, body, axis, body_axis)  its columns are the axes of the body
    body_rotation_vector (time, body, axis)             axis times angle, which is at most half a turn [rad]
    body_angular_velocity (time, body, axis)            along the axes of the ground; ..._in_body: along those of the
    body

A reaction that is not unique, because connections hold the same thing more than once, is NaN, and its attribute
`non_unique` says so.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.language.expression import evaluate
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, ENERGY, LENGTH, TIME, unit_of
from freebody.model.elements import RATE, VALUE, AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.model.states import state_name
from freebody.numeric.engine.course import RotationHistory, Trajectory
from freebody.numeric.jets import Array
from freebody.numeric.potential import ARRAY_FUNCTIONS
from freebody.numeric.rotation import matrices, rotation_vectors
from freebody.present.recording import Recording, Series
from freebody.study.simulation.contact_series import friction_names
from freebody.study.simulation.observed import observed
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.study.simulation.measured import MeasuredMotion

_SPACE = "right-handed axes; SI units, angles in rad; quaternions (w, x, y, z) turn body axes to ground axes"
_FIXED_NAMES = ("position", "angle", "velocity", "angular_velocity", "acceleration", "angular_acceleration")


@cache
def _made_by() -> str:
    """With the version, for which the files of the installation are searched."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return f"freebody {version('freebody')}"
    except PackageNotFoundError:
        return "freebody"


def recorded(result: MeasuredMotion) -> Recording:
    """All series of a simulation."""
    course, system = result.course, result.system
    bodies = [b.name for b in system.moving]
    own = [k for k, b in enumerate(system.all_moving) if b.name in system.material]
    data = _bodies(course, own) if course.rotation is None else _bodies_in_space(course, course.rotation, own)
    for name, (value, rate, acceleration) in result.series.items():
        if name in system.states:
            unit = unit_of(system.states[name].dimension)
            data[name] = ("time", value, _named(unit, name))
            data[f"{name}_rate"] = ("time", rate, _named(f"{unit}/s", Message("rate of {name}", name=name)))
            continue
        unit = unit_of(system.measures[name].dimension)
        data[name] = ("time", value, _named(unit, name))
        data[f"{name}_rate"] = ("time", rate, _named(f"{unit}/s", Message("rate of {name}", name=name)))
        data[f"{name}_acceleration"] = (
            "time",
            acceleration,
            _named(f"{unit}/s^2", Message("second derivative of {name}", name=name)),
        )
    data |= _reactions(result)
    data |= _loads(result)
    if result.course.contact is not None:
        from freebody.study.simulation.contact_series import contact_series

        names = reaction_names(system.rows)
        data |= contact_series(result, dict(zip((r.name for r in system.rows), names, strict=True)))
    energy = result.energy
    for name, values, what in (
        ("kinetic_energy", energy.kinetic, Message("kinetic energy")),
        ("potential_energy", energy.potential, Message("potential energy of constant loads and linear springs")),
        ("work", energy.work, Message("work of all other loads and of drivers since the start")),
    ):
        data[name] = ("time", values, _named("J", what))
    data |= _blows(result)
    summary = result.summary()
    attributes = {key: summary[key] for key in ("title", "status", "message", "method", "tolerance", "energy_error")}
    attributes |= {
        "measures": list(system.measures),
        "events": json.dumps(summary["events"]),
        "source": _made_by(),
        "convention": _SPACE if system.space else "x right, y up, angles counter-clockwise; SI units, angles in rad",
    }
    labels = {"body": bodies, "axis": ["x", "y", "z"] if system.space else ["x", "y"]}
    if system.space:
        labels |= {"quaternion": ["w", "x", "y", "z"], "body_axis": ["x", "y", "z"]}
    series = {
        name: Series((of,) if isinstance(of, str) else of, values, about) for name, (of, values, about) in data.items()
    }
    return Recording(course.times, series, labels, attributes)


def _bodies(course: Trajectory, own: list[int]) -> dict[str, Any]:
    """Poses of the bodies, which stand in these places, and their rates."""
    data: dict[str, Any] = {}
    for order, array in enumerate((course.poses, course.velocities, course.accelerations)):
        per = ("", "/s", "/s^2")[order]
        place, turn = _FIXED_NAMES[2 * order], _FIXED_NAMES[2 * order + 1]
        data[f"body_{place}"] = (
            ("time", "body", "axis"),
            array[:, own, :2],
            _named("m" + per, f"{place} of the mass centre"),
        )
        data[f"body_{turn}"] = (("time", "body"), array[:, own, 2], _named("rad" + per, turn.replace("_", " ")))
    return data


def _bodies_in_space(course: Trajectory, rotation: RotationHistory, own: list[int]) -> dict[str, Any]:
    data: dict[str, Any] = {}
    axes = ("time", "body", "axis")
    for order, array in enumerate((course.poses, course.velocities, course.accelerations)):
        place, per = _FIXED_NAMES[2 * order], ("", "/s", "/s^2")[order]
        data[f"body_{place}"] = (axes, array[:, own], _named("m" + per, f"{place} of the mass centre"))
    turned = rotation.quaternions[:, own]
    data["body_quaternion"] = (("time", "body", "quaternion"), turned, _named("1", "quaternion of the body's axes"))
    data["body_rotation_matrix"] = ((*axes, "body_axis"), matrices(turned), _named("1", "axes of the body"))
    data["body_rotation_vector"] = (axes, rotation_vectors(turned), _named("rad", "rotation vector of the body's axes"))
    for name, array, per, what in (
        ("angular_velocity", rotation.velocities, "/s", "angular velocity"),
        ("angular_velocity_in_body", rotation.velocities_in_body, "/s", "angular velocity along the body's axes"),
        ("angular_acceleration", rotation.accelerations, "/s^2", "angular acceleration"),
    ):
        data[f"body_{name}"] = (axes, array[:, own], _named("rad" + per, what))
    return data


def _named(unit: str, long_name: str) -> dict[str, str]:
    return {"units": unit, "long_name": long_name}


def reaction_names(rows: Sequence[ConstraintRow]) -> list[str]:
    """What the reaction of each held row is called: `rope.tension`, `contact.normal_force` by its name, or `A.x` by its
    component where a connection has several of the same name."""
    called = [(row.connection, row.reaction) for row in rows]
    return [
        f"{row.connection}.{row.reaction}".replace(" ", "_") if called.count(pair) == 1 else row.name.replace(" ", "_")
        for row, pair in zip(rows, called, strict=True)
    ]


def series_names(system: System) -> list[str]:
    """What a dataset of the system has over time alone: measures, reactions, loads and energies."""
    return [name for name in series_units(system) if not name.endswith(".used_friction")]


def series_units(system: System) -> dict[str, str]:
    """The same with their units, and the used parts of friction."""
    units: dict[str, str] = {}
    for name, state in system.states.items():
        unit = unit_of(state.dimension)
        units |= {name: unit, f"{name}_rate": f"{unit}/s"}
    for name, measure in system.measures.items():
        unit = unit_of(measure.dimension)
        units |= {name: unit, f"{name}_rate": f"{unit}/s", f"{name}_acceleration": f"{unit}/s^2"}
    names = dict(zip((row.name for row in system.rows), reaction_names(system.rows), strict=True))
    units |= {names[row.name]: _unit_of_reaction(row) for row in system.rows if not state_name(row.connection)}
    units |= {f"{load}.force": _unit_of_force(own) for load, own in _with_force(system).items()}
    used = friction_names(system, names) if system.dry_friction else ()
    return units | dict.fromkeys(("kinetic_energy", "potential_energy", "work"), "J") | dict.fromkeys(used, "1")


def _with_force(system: System) -> dict[str, list[AppliedLoad]]:
    """Loads that have one force, whatever it acts along, and what they push; a weight on several bodies has none."""
    own: dict[str, list[AppliedLoad]] = {}
    for push in system.applied_loads:
        own.setdefault(push.load, []).append(push)
    return {load: p for load, p in own.items() if system.loads[load].pulls_with([0.0] * len(p), float) is not None}


def _unit_of_reaction(row: ConstraintRow) -> str:
    return "N" if row.measure.dimension == LENGTH else "N m" if row.measure.dimension == DIMENSIONLESS else "SI"


def _unit_of_force(own: Sequence[AppliedLoad]) -> str:
    return "N m" if own[0].measure.dimension == DIMENSIONLESS else "N"


def _reactions(result: MeasuredMotion) -> dict[str, Any]:
    data: dict[str, Any] = {}
    names = reaction_names(result.rows)
    for k, row in enumerate(result.rows):
        if state_name(row.connection) or not row.transmits:
            continue
        unique = result.course.unique[:, k]
        values = np.where(unique, row.sign * result.course.multipliers[:, k], np.nan)
        attributes = _named(
            _unit_of_reaction(row), Message("{reaction} of {name}", reaction=row.reaction, name=row.connection)
        )
        if not unique.all():
            attributes["non_unique"] = (
                "connections hold the same thing more than once: this reaction has no unique value"
            )
        data[names[k]] = ("time", values, attributes)
    return data


def _blows(result: MeasuredMotion) -> dict[str, Any]:
    """Impulses, and the energy that they take, blow by blow."""
    blows = result.struck
    if not blows:
        return {}
    data: dict[str, Any] = {
        "blow_time": ("blow", np.array([b.time for b in blows]), _named("s", "time of the blow")),
        "blow_energy_lost": (
            "blow",
            np.array([-b.energy_change for b in blows]),
            _named("J", "kinetic energy that the blow takes"),
        ),
    }
    acting = set[str]().union(*(b.impulses.keys() | set(b.not_unique) for b in blows))
    for name, row in zip(reaction_names(result.rows), result.rows, strict=True):
        if row.name not in acting or state_name(row.connection):
            continue
        values = np.array([np.nan if row.name in b.not_unique else b.impulses.get(row.name, 0.0) for b in blows])
        unit = unit_of(ENERGY * TIME / row.measure.dimension)
        data[f"{name}.impulse"] = ("blow", values, _named(unit, f"impulse of {row.reaction} of {row.connection}"))
    return data


def _loads(result: MeasuredMotion) -> dict[str, Any]:
    """Loads that have one force, by their laws."""
    system = result.system
    with_force = _with_force(system)
    applied_loads = [p for own in with_force.values() for p in own]
    measures = {f"{p.name}@": p.measure for p in applied_loads}
    measures |= {name: m for p in applied_loads for name, m in p.measures}
    found = observed(result, measures)
    data: dict[str, Any] = {}
    for load, own in with_force.items():
        force = system.loads[load].pulls_with([_law(result, p, found) for p in own], np.sqrt)
        data[f"{load}.force"] = ("time", force, _named(_unit_of_force(own), Message("force of {name}", name=load)))
    return data


def _law(result: MeasuredMotion, push: AppliedLoad, found: dict[str, tuple[Array, Array, Array]]) -> Array:
    value, rate, _ = found[f"{push.name}@"]
    names: dict[str, Any] = {**result.simulator.numbers.values, "t": result.course.times, RATE.name: rate}
    if not isinstance(push.measure, NonholonomicForm):
        names[VALUE.name] = value - result.simulator.reference.start_value(push.measure)
    for name, _measure in push.measures:
        names[name], names[f"rate({name})"] = found[name][0], found[name][1]
    return np.broadcast_to(evaluate(push.law, names, ARRAY_FUNCTIONS), value.shape).copy()
