"""What is measured along a motion: energies, series of the named measures, the summary."""

from __future__ import annotations

from dataclasses import asdict
from functools import cached_property
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow
from freebody.numeric.contact.admissible import admissible_reactions
from freebody.numeric.contact.sudden import recorded
from freebody.numeric.engine.course import BlowRecord, Collision
from freebody.numeric.jets import Array
from freebody.study.simulation.contact_series import final_states
from freebody.study.simulation.energy import EnergyBalance, energy_balance
from freebody.study.simulation.motion import SimulatedMotion
from freebody.study.simulation.observed import observed
from freebody.study.simulation.pressed_sides import left_sides


class MeasuredMotion(SimulatedMotion):
    """A motion, and what is measured along it."""

    @cached_property
    def energy(self) -> EnergyBalance:
        """Kinetic and potential energy, and the work of all other loads, at the output times."""
        return energy_balance(self)

    @cached_property
    def series(self) -> dict[str, tuple[Array, Array, Array]]:
        """Value, rate and second derivative of every named measure at the output times; of a state of a controller its
        value and its rate."""
        states = self.system.states
        found = observed(self, self.system.measures)
        for name, (_integral, value, rate) in observed(self, {n: s.integral for n, s in states.items()}).items():
            found[name] = value, rate, np.full_like(rate, np.nan)
        return found

    def reaction_ranges(self, time: float | None = None) -> dict[str, tuple[float, float]]:
        """Of a system with contacts or dry friction: the least and the largest value [N or N m] that every reaction may
        have at the output time nearest to the given one [s] (the end if nothing is said), by the name of its row. Both
        are the same where it is unique; infinite where nothing bounds it. Raises InputError for other systems."""
        if self.simulator.bounded is None:
            raise InputError(
                Message("there are no contacts or dry friction; reactions that are not unique are unbounded")
            )
        k = -1 if time is None else int(np.abs(self.course.times - time).argmin())
        return admissible_reactions(self.simulator.bounded, self.course, k % len(self.course.times))

    def summary(self) -> dict[str, Any]:
        """The document that `freebody simulate --json` prints."""
        course, energy = self.course, self.energy
        final: dict[str, Any] = {
            "measures": {name: float(values[-1]) for name, (values, _r, _a) in self.series.items()},
            "poses": {b.name: [float(x) for x in course.poses[-1, k]] for k, b in enumerate(self.system.moving)},
        }
        if course.rotation is not None:
            turned = course.rotation.quaternions[-1]
            final["quaternions"] = {b.name: [float(x) for x in turned[k]] for k, b in enumerate(self.system.moving)}
        return {
            "title": self.system.title,
            "assumptions": list(self.simulator.assumptions),
            "status": str(self.status),
            "message": self.message,
            "t_end": self.t_end,
            "steps": course.n_steps,
            "evaluations": course.n_evaluations,
            "wall_time": course.wall_time,
            "max_position_violation": course.place_gap * self.simulator.numbers.length,
            "max_velocity_violation": course.motion_gap * self.simulator.numbers.length,
            "energy_error": energy.error,
            "energy_error_relative": energy.relative_error,
            "method": course.method,
            "tolerance": self.tolerance,
            "trusted_until": self.trusted_until,
            "events": [{"time": e.time, "name": e.name, "kind": e.kind} for e in self.events],
            "final": final,
            **self._contact_summary(),
            **self._blow_summary(),
        }

    @property
    def other_flanks(self) -> tuple[tuple[ConstraintRow, float], ...]:
        """The meshes whose teeth come to bear on another flank than the one that the model says, and when first [s]."""
        return tuple((row, float(self.course.times[away[0]])) for _k, row, away in left_sides(self))

    @cached_property
    def struck(self) -> tuple[BlowRecord, ...]:
        """All blows of the motion: that of its start, what closes and strikes on the way, and collisions."""
        record = self.course.contact
        later = () if record is None else (*record.blows, *map(_as_blow, record.collisions))
        first = () if self._start_blow is None else (self._start_blow,)
        return (*first, *sorted(later, key=lambda blow: blow.time))

    @cached_property
    def _start_blow(self) -> BlowRecord | None:
        """The blow at the start; a motion that goes on has it behind it."""
        reference, struck = self.simulator.reference, self.simulator.blow
        if struck is None or self.course.times[0] > 0.0:
            return None
        return recorded(reference, struck, "start", 0.0)

    def _blow_summary(self) -> dict[str, Any]:
        """The blow at the start, and those on the way: the kinetic energy that is lost [J], and the impulses [N s,
        N m s] that are unique, by row, with the sign of its reaction."""
        found: dict[str, Any] = {}
        if self._start_blow is not None:
            found["blow"] = _told(self._start_blow)
        record = self.course.contact
        if record is not None and self.system.blows:
            found["blows"] = [{"time": b.time, "when": b.name, **_told(b)} for b in record.blows]
        return found

    def _contact_summary(self) -> dict[str, Any]:
        """Contact states at the end, and all collisions."""
        record = self.course.contact
        if record is None:
            return {}
        return {
            "phases": record.n_phases,
            "contacts": final_states(self),
            "collisions": [asdict(collision) for collision in record.collisions],
        }


def _told(blow: BlowRecord) -> dict[str, Any]:
    found: dict[str, Any] = {"energy_lost": -blow.energy_change, "impulses": dict(blow.impulses)}
    if blow.not_unique:
        found["not_unique"] = list(blow.not_unique)
    return found


def _as_blow(collision: Collision) -> BlowRecord:
    """A collision as a blow: its impulses at contacts, of friction, and in joints."""
    impulses = {**collision.joints, **collision.impulses, **collision.friction}
    known = {name: x for name, x in impulses.items() if name not in collision.not_unique}
    return BlowRecord(collision.time, "impact", known, collision.not_unique, collision.energy_change)
