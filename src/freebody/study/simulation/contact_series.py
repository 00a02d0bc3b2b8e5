"""Contact states and the used part of friction along a simulation, for its dataset."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.language.expression import free_symbols
from freebody.language.sentences import Message
from freebody.model.elements import DryFriction
from freebody.numeric.jets import Array
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.study.simulation.motion import SimulatedMotion

OPEN, CLOSED, STICKING, FORWARD, BACKWARD = range(5)
_WORDS = {0: "sticking", 1: "sliding forward", -1: "sliding backward"}
MEANINGS = "open closed sticking sliding_forward sliding_backward"


def contact_series(result: SimulatedMotion, names: Mapping[str, str]) -> dict[str, Any]:
    """`<bound>.state` of every bound, `<friction>.used_friction` of all dry friction. names: of reactions, by row."""
    record, system = result.course.contact, result.system
    assert record is not None
    dry_friction = {rub.of: rub for rub in system.dry_friction if rub.of}
    data: dict[str, Any] = {}
    for k, name in enumerate(record.bounds):
        state = record.states[:, k].astype(np.int8)
        rub = dry_friction.get(name)
        if rub is not None:
            slip = record.slips[:, record.dry_friction.index(rub.name)]
            rubbing = np.select([slip == 0, slip == 1, slip == -1], [STICKING, FORWARD, BACKWARD], CLOSED)
            state = np.where(state > 0, rubbing, OPEN).astype(np.int8)
        data[f"{_stem(names[name])}.state"] = (
            "time",
            state,
            {
                "flag_values": list(range(5)),
                "flag_meanings": MEANINGS,
                "long_name": Message("contact state of {name}", name=name),
            },
        )
    column = {row.name: k for k, row in enumerate(system.rows)}
    for name, rub in zip(friction_names(system, names), system.dry_friction, strict=True):
        data[name] = (
            "time",
            used_friction(result, rub, column),
            {"units": "1", "long_name": Message("friction of {name} by the largest that holds at rest", name=rub.name)},
        )
    return data


def friction_names(system: System, names: Mapping[str, str]) -> list[str]:
    """`<friction>.used_friction` of all dry friction. names: of reactions, by row."""
    return [f"{_stem(names[rub.name])}.used_friction" for rub in system.dry_friction]


def final_states(result: SimulatedMotion) -> dict[str, str]:
    """The state of every bound, and of dry friction in joints, at the end, by name."""
    record, system = result.course.contact, result.system
    assert record is not None
    dry_friction = {rub.of: rub.name for rub in system.dry_friction if rub.of}
    slips = dict(zip(record.dry_friction, record.slips[-1], strict=True))
    states: dict[str, str] = {}
    for name, is_closed in zip(record.bounds, record.states[-1], strict=True):
        slip = slips.get(dry_friction.get(name, ""))
        states[name] = "open" if not is_closed else _WORDS.get(int(slip), "closed") if slip is not None else "closed"
    states |= {rub.name: _WORDS.get(int(slips[rub.name]), "no force") for rub in system.dry_friction if not rub.of}
    return states


def _stem(name: str) -> str:
    """`contact.normal_force` and `contact.friction_force` belong to `contact`."""
    for ending in (".normal_force", ".tension", ".friction_force", ".friction_torque", ".stop_force", ".stop_torque"):
        if name.endswith(ending):
            return name.removesuffix(ending)
    return name


def used_friction(result: SimulatedMotion, rub: DryFriction, column: Mapping[str, int]) -> Array:
    """(n_times,) |T| / (static coefficient times load); NaN where nothing presses, or the
    limit is a law of time or of measures."""
    multipliers, number = result.course.multipliers, result.simulator.numbers.number
    force = multipliers[:, column[rub.row.name]]
    if rub.load:
        pressed = np.linalg.norm(multipliers[:, [column[name] for name in rub.load]], axis=1)
    else:
        pressed = np.ones(len(force))
    if not rub.load and (rub.measures or "t" in free_symbols(rub.static)):
        return np.full(len(force), np.nan)  # the limit changes along the motion
    down, up = (number(rub.coefficient(direction, at_rest=True)) for direction in (-1, 1))
    limit = np.where(force > 0.0, down, up) * pressed
    return np.divide(np.abs(force), limit, out=np.full(len(force), np.nan), where=limit > 0.0)
