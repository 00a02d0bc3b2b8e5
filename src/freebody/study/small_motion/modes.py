"""Small motions of a system: natural frequencies, damping, mode shapes, and its linear state-space model.

About an equilibrium the equations of motion are M z'' + C z' + K z = 0 in independent coordinates z, the disturbances
of named measures (see `numeric.small_motion` for how they are found, `numeric.vibration` for what follows). About the
start state they hold for its instant: a state that is steady in the named measures, as on a rotor at constant rate,
has constant coefficients, and its modes are those about this relative equilibrium. SI units, angles in rad.
Source: Meirovitch, Methods of Analytical Dynamics, 1970, ch. 5 and 6.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import free_symbols
from freebody.language.sentences import Message, in_turn
from freebody.model.noting import did_you_mean
from freebody.model.states import state_name
from freebody.numeric.directional import derivative
from freebody.numeric.instant import forces
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.small_motion import LinearisationPoint, SmallCoordinate, SmallMotion, gradient_of
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.system import NumericSystem
from freebody.numeric.vibration import NaturalMotion, natural_motions
from freebody.present.lines import system_line, value_text
from freebody.present.report.blocks import Block, Remark, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, line, summary
from freebody.study.given import named_measure
from freebody.study.settled import without_friction
from freebody.study.small_motion.equilibrium import Guess, about_rest, nearest_equilibrium
from freebody.study.small_motion.found import unit_of
from freebody.study.small_motion.mode import NaturalMode
from freebody.study.worded import in_words
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, ROUNDED

At = Literal["equilibrium", "start"]


@dataclass(frozen=True)
class NaturalModes(Result):
    """The natural motions about one state, slowest first.

    about: "equilibrium" or "start"; measures: values of the named measures there; coordinates: names of z; mass,
    damping, stiffness: M, C, K (n x n) of M z'' + C z' + K z = 0."""

    system: System
    about: At
    measures: Mapping[str, float]
    stability: str
    modes: tuple[NaturalMode, ...]
    notes: tuple[str, ...]
    small: SmallMotion

    def __iter__(self) -> Iterator[NaturalMode]:
        return iter(self.modes)

    def __len__(self) -> int:
        return len(self.modes)

    def __getitem__(self, k: int) -> NaturalMode:
        return self.modes[k]

    @property
    def frequencies(self) -> tuple[float | None, ...]:
        """Natural angular frequencies [rad/s], slowest first; see `NaturalMode.frequency`."""
        return tuple(mode.frequency for mode in self.modes)

    @property
    def coordinates(self) -> tuple[str, ...]:
        return tuple(c.name for c in self.small.positions)

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the states x of the state-space model. Of controllers these are their own states, not the integrals
        of them, which are among the coordinates."""
        names = (*self.coordinates, *(state_name(c.name) or f"rate({c.name})" for c in self.small.speeds))
        return tuple(names[k] for k in self._kept)

    @property
    def _kept(self) -> list[int]:
        """Where the states stand among the coordinates and their rates."""
        return [k for k in range(self.small.order) if k not in self.small.of_states]

    @property
    def state_matrix(self) -> Array:
        """A of x' = A x."""
        return self.small.A[np.ix_(self._kept, self._kept)]

    @property
    def mass(self) -> Array:
        return self.small.M

    @property
    def damping(self) -> Array:
        return self.small.C

    @property
    def stiffness(self) -> Array:
        return self.small.K

    def state_space(self, inputs: Sequence[str] = (), outputs: Sequence[str] = ()) -> tuple[Array, Array, Array, Array]:
        """(A, B, C, D) of x' = A x + B u, y = C x + D u, x the disturbances of `states`, ready for `control.ss`.

        inputs: names of loads or of parameters. The input of a load with a magnitude (force, torque) is what is added
        to its magnitude [N, N m]; that of another load what is added to a factor 1 before its law; that of a
        parameter what is added to its value. outputs: named measures, `rate(x)` or `rate(rate(x))`; without any,
        all named measures. Raises InputError for an unknown name, CannotAnswer for a parameter that does more than
        change loads."""
        small, k = self.small, len(self.small.positions)
        columns = [small.input(_push_of(small, name)) for name in inputs]
        B = np.array(columns, dtype=np.float64).reshape(len(columns), small.order).T
        rows: list[Array] = []
        through: list[Array] = []
        for text in outputs or (*self.system.measures, *self.system.states):
            name, order = _output(text)
            if name in self.system.states:
                name, order = self.system.states[name].carrier, order + 1
            measure = self.system.all_measures.get(name) or named_measure(self.system, name)
            row, gain = small.output(measure, order)
            rows.append(row)
            through.append(gain @ B[k:])
        C = np.array(rows, dtype=np.float64).reshape(len(rows), small.order)
        kept, D = self._kept, np.array(through, dtype=np.float64).reshape(len(rows), len(columns))
        return self.state_matrix, B[kept], C[:, kept], D

    def to_plain(self) -> dict[str, Any]:
        """The JSON document of `freebody modes`: title, about, measures {name: {value, unit}}, stability,
        coordinates, states, mass_matrix, damping_matrix, stiffness_matrix, state_matrix, notes, and `modes`, each
        with kind, frequency [rad/s], frequency_hz, damped_frequency, damping_ratio, growth_rate [1/s],
        shape {measure: number or [re, im]} and bodies {body: [x, y, angle]}; null where a mode has no such number."""
        return {
            "title": self.system.title,
            "about": self.about,
            "measures": {n: {"value": x, "unit": self._units[n]} for n, x in self.measures.items()},
            "stability": self.stability,
            "coordinates": list(self.coordinates),
            "states": list(self.states),
            "mass_matrix": self.mass.tolist(),
            "damping_matrix": self.damping.tolist(),
            "stiffness_matrix": self.stiffness.tolist(),
            "state_matrix": self.state_matrix.tolist(),
            "notes": list(self.notes),
            "modes": [mode.to_plain() for mode in self.modes],
        }

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    @property
    def _units(self) -> dict[str, str]:
        """Of measures and states."""
        states = {name: str(state.dimension) for name, state in self.system.states.items()}
        return {name: unit_of(measure) for name, measure in self.system.measures.items()} | states

    def _blocks(self) -> Iterator[Block]:
        yield line(system_line(self.system, len(self.small.speeds) - len(self.system.states)))
        units = self._units
        at = in_turn([value_text(n, x, units[n]) for n, x in self.measures.items()])
        about = (
            Message("small motions about the equilibrium")
            if self.about == "equilibrium"
            else Message("small motions about the start")
        )
        if self.stability:
            about = Message("{what} ({stability})", what=about, stability=self.stability)
        yield line(Message("{what}: {values}", what=about, values=at) if at else about)
        yield from (line(Message("note: {note}", note=note)) for note in self.notes)
        if not self.modes:
            yield Remark((Message("Nothing can move, so there are no modes."),))
        for k, mode in enumerate(self, 1):
            yield Section(
                (Message("Mode {k}: {what}", k=k, what=mode.told),),
                tuple(entries(entry(Message("shape"), *mode.told_shape))),
            )


@in_words
def modes(system: System, at: At = "equilibrium", guess: Guess | None = None) -> NaturalModes:
    """The small motions of a system about an equilibrium: the one nearest to the model's start, or the one to which
    a guess (values of named measures) leads; or, with at="start", about the start state.

    Parameters need values. Raises CannotAnswer where there is no equilibrium, where loads are not smooth, or where a
    body moves without inertia."""
    if at not in ("equilibrium", "start"):
        raise InputError(Message("small motions are about the equilibrium or the start, not about {at}", at=at))
    system = without_friction(system)
    if at == "start":
        if guess:
            raise InputError(Message("a guess leads to an equilibrium; about the start there is nothing to guess"))
        return _about_start(system)
    found = nearest_equilibrium(system, guess)
    rest = found[0]
    small = about_rest(system, found.reference, rest.pose)
    notes = [*(note for note in found.notes if note != found.searched), *rest.notes]
    return NaturalModes(system, at, rest.measures, rest.stability, _modes(small), tuple(notes), small)


def _about_start(system: System) -> NaturalModes:
    reference = Reference(system)
    q = reference.assemble()
    s = reference.snapshot(q, reference.velocities(q))
    small = SmallMotion(reference, LinearisationPoint(q, s.v, 0.0, s.branches, frozen=False))
    notes: list[str] = []
    measures: dict[str, float] = {}
    for name, measure in system.all_measures.items():
        state = state_name(name)
        try:
            measures[state or name] = s.rate(measure) if state else s.value(measure)
        except CannotAnswer:
            continue
    unsteady = [c for c in small.positions if c.measure is not None and not _is_steady(small, s, c)]
    if unsteady:
        notes.append(
            Message(
                "the start is no steady state of {names}: the equations hold for its first instant only, and its modes "
                "are those of coefficients that stay as they are then",
                names=in_turn([state_name(c.name) or c.name for c in unsteady]),
            )
        )
    return NaturalModes(system, "start", measures, "", _modes(small), tuple(notes), small)


def _is_steady(small: SmallMotion, s: Snapshot, c: SmallCoordinate) -> bool:
    """Whether a measure neither moves nor accelerates; of a state its rate counts, not that of its integral."""
    measure = c.measure
    assert measure is not None
    size = small.reference.sizes.length if str(measure.dimension) == "m" else 1.0
    pace = 1.0 + float(small.reference.sizes.relative(s.v).max(initial=0.0))
    is_slow = bool(state_name(c.name)) or abs(s.rate(measure)) <= ROUND_OFF * size * pace
    return is_slow and abs(s.acceleration(measure)) <= ROUND_OFF * size * pace**2


# -- shapes ----------------------------------------------------------------------------------------
def _modes(small: SmallMotion) -> tuple[NaturalMode, ...]:
    return tuple(_mode(small, motion) for motion in natural_motions(small))


def _mode(small: SmallMotion, found: NaturalMotion) -> NaturalMode:
    reference = small.reference
    g = small.at.geometry(reference, small.at.q, small.at.v)
    shape: dict[str, complex] = {}
    for name, measure in reference.system.all_measures.items():
        row = gradient_of(reference, g, name, measure)
        if row is not None:
            state, moved = state_name(name), complex(row @ found.motion)
            shape[state or name] = found.rate * moved if state else moved
    measured = _normalised(np.array(list(shape.values()), dtype=np.complex128))
    moved = _normalised(found.motion)
    n_parts = 6 if reference.system.space else 3
    bodies: dict[str, tuple[complex, ...]] = {}
    for body in reference.system.moving:
        parts = [moved[k] for k in reference.columns(body.name)]
        bodies[body.name] = (*parts, *[0j] * (n_parts - len(parts)))  # a particle does not turn
    return NaturalMode(found.kind, found.rate, dict(zip(shape, measured, strict=True)), bodies)


def _normalised(parts: NDArray[np.complex128]) -> list[complex]:
    """Parts by the largest one (the first of those), rounding taken off."""
    sizes = np.abs(parts)
    largest = float(sizes.max(initial=0.0))
    if largest == 0.0:
        return [0j] * len(parts)
    by = complex(parts[int(np.argmax(sizes >= (1.0 - ROUND_OFF) * largest))])
    found: list[complex] = []
    for part in parts.tolist():
        x = part / by
        re, im = (0.0 if abs(c) <= ROUNDED else c for c in (x.real, x.imag))
        found.append(complex(re, im))
    return found


# -- inputs and outputs ----------------------------------------------------------------------------
def _output(text: str) -> tuple[str, int]:
    """The measure in `x`, `rate(x)` or `rate(rate(x))`, and how many rates."""
    name, order = text.strip(), 0
    while name.startswith("rate(") and name.endswith(")"):
        name, order = name[5:-1].strip(), order + 1
    if order > 2:
        raise InputError(Message("{text}: outputs are measures, their rates and accelerations", text=text))
    return name, order


def _push_of(small: SmallMotion, name: str) -> Array:
    """The generalized force on the absolute coordinates of a unit of an input."""
    system = small.reference.system
    if name in system.loads:
        return _push_of_load(small, name)
    if name in system.parameters:
        return _push_of_parameter(small, name)
    known = [*system.loads, *system.parameters]
    raise InputError(
        Message("there is no load or parameter {name} to be an input.{hint}", name=name, hint=did_you_mean(name, known))
    )


def _push_of_load(small: SmallMotion, name: str) -> Array:
    from freebody.numeric.instant import law

    reference, n = small.reference, len(small.at.q)
    g = small.at.geometry(reference, small.at.q, small.at.v)
    has_magnitude = "magnitude" in type(reference.system.loads[name]).model_fields
    total = np.zeros(n)
    for push in reference.system.applied_loads:
        if push.load == name:
            size = 1.0 if has_magnitude else law(reference, g, push)
            total = total + size * reference.jet(g, push.measure, push.name).row(n)
    return total


def _push_of_parameter(small: SmallMotion, name: str) -> Array:
    """d Q/d parameter, everything that moves kept. Raises CannotAnswer if the parameter is in the connections or, about
    a moving state, in the masses."""
    reference, at, n = small.reference, small.at, len(small.at.q)
    value = reference.frame.values[name]
    unit = abs(value) or 1.0

    def with_value(x: float) -> NumericSystem:
        other = copy(reference)
        other.frame = replace(reference.frame, values={**reference.frame.values, name: x}, _constants={})
        return other

    def held(s: float) -> Array:
        other = with_value(value + s * unit)
        g = at.geometry(other, at.q, at.v)
        gaps = [other.gap(row, g) for row in other.system.constraint_rows]
        return np.concatenate([[gap.value, gap.rate, *gap.row(n)] for gap in gaps]) if gaps else np.zeros(1)

    if np.abs(held(1e-3) - held(0.0)).max() > ROUNDED:
        raise CannotAnswer(
            Message("{name} changes the connections and not only loads, so it is no input; name a load", name=name)
        )
    masses = [x for body in reference.system.moving for x in (body.mass, body.inertia)]
    if not at.frozen and any(name in free_symbols(x) for x in masses):
        raise CannotAnswer(
            Message("{name} changes masses, which about a moving state is more than a load; name a load", name=name)
        )

    def pushed(s: float) -> Array:
        other = with_value(value + s * unit)
        return forces(other, at.geometry(other, at.q, at.v))

    scale = np.full(n, float(np.abs(forces(reference, at.geometry(reference, at.q, at.v))).max(initial=0.0)))
    found = derivative(pushed, scale) / unit
    if not np.abs(found).max(initial=0.0) > 0.0:
        raise CannotAnswer(Message("{name} is in no load here, so it is no input", name=name))
    return found
