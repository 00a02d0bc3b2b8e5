"""The motion of a mechanism with one freedom: its linkages by name, centres and ratios at the pose, how far its input
reaches, where it is singular, and the ways in which it can be assembled."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

from freebody.errors import CannotAnswer, InputError, ModelError, RoutesDisagree
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.model.elements import NonholonomicForm
from freebody.model.noting import did_you_mean
from freebody.numeric.jets import Array
from freebody.numeric.mobility.coordinates import own_measures
from freebody.numeric.mobility.modes import AssemblyMode, AssemblyModes, assembly_modes
from freebody.numeric.mobility.path import MotionPath, singular_at, trace
from freebody.numeric.mobility.rank import rank_at
from freebody.numeric.mobility.screw_axes import ScrewAxis, screw_axes
from freebody.numeric.reference import Reference
from freebody.study.mobility.centres import CentreOfPair, VelocityRatio, instant_centres, velocity_ratios
from freebody.study.mobility.exact_centres import ExactPose
from freebody.study.mobility.grashof import FourBarNumbers, SliderCrankNumbers, dimensions
from freebody.study.mobility.gruebler import Gruebler
from freebody.study.mobility.linkages import Linkage, linkages
from freebody.system.system import System

MOST_BODIES = 8  # up to which the motion is followed without being asked for
_MOST_LISTED = 24  # bodies, up to which linkages, centres and ratios are listed
_MOST_EXACT = 5  # bodies, up to which centres and ratios are looked for in closed form
_MOST_MODES = 4  # bodies, up to which assembly modes are looked for without being asked for


@dataclass(frozen=True)
class WantedFigures:
    """What is asked for beyond what is quickly told."""

    along: str | None = None  # a driver or measure along which the motion is followed
    modes: bool = False  # assembly modes, whatever the size


@dataclass(frozen=True)
class Input:
    """The measure by which a motion is followed, and the drivers that are left out for it."""

    name: str
    measure: Measure
    released: tuple[str, ...]
    value: float  # at the pose

    @property
    def is_angle(self) -> bool:
        return self.measure.dimension == DIMENSIONLESS


@dataclass(frozen=True)
class Motions:
    """What can be told of a motion with one freedom; parts that do not apply are empty."""

    system: System
    input: Input | None
    linkages: tuple[tuple[Linkage, FourBarNumbers | SliderCrankNumbers], ...] = ()
    centres: tuple[CentreOfPair, ...] = ()
    screws: tuple[ScrewAxis, ...] = ()  # in space, in place of centres
    ratios: tuple[VelocityRatio, ...] = ()
    singular: tuple[str, ...] = ()  # what the pose is for the input: dead point, change point
    path: MotionPath | None = None
    modes: AssemblyModes | None = None
    notes: tuple[str, ...] = ()

    def mode(self, name: str) -> AssemblyMode:
        """The assembly mode with a name. Raises InputError, listing those that there are."""
        known = {} if self.modes is None else {mode.name: mode for mode in self.modes}
        if name not in known:
            raise InputError(
                Message("there is no assembly mode {name}.{hint}", name=name, hint=did_you_mean(name, known))
            )
        return known[name]

    def to_plain(self) -> dict[str, Any]:
        found: dict[str, Any] = {
            "linkages": [loop.to_plain() | numbers.to_plain() for loop, numbers in self.linkages],
            "instant_centres": [c.to_plain() for c in self.centres],
            "screw_axes": [s.to_plain() for s in self.screws],
            "velocity_ratios": [r.to_plain() for r in self.ratios],
        }
        if self.input is not None:
            found["input"] = {"name": self.input.name, "value": self.input.value, "released": list(self.input.released)}
            found["singular_for_input"] = list(self.singular)
        if self.path is not None:
            found["along"] = _path_to_plain(self.path)
        if self.modes is not None:
            found["assembly_modes"] = [
                {"name": m.name, "signs": dict(m.signs), "poses": self._poses(m.q)} for m in self.modes
            ]
        found["motion_notes"] = list(self.notes)
        return found

    def _poses(self, q: Array) -> dict[str, list[float]]:
        poses: dict[str, list[float]] = {}
        at = 0
        for body in self.system.moving:
            n = 3 if body.turns else 2
            poses[body.name] = [float(x) for x in q[at : at + n]]
            at += n
        return poses


def _path_to_plain(path: MotionPath) -> dict[str, Any]:
    return {
        "reach": None if path.reach is None else [x if math.isfinite(x) else None for x in path.reach],
        "full_turn": path.full_turn,
        "period": path.period,
        "is_closed": path.is_closed,
        "is_unbounded": path.is_unbounded,
        "points": [{"kind": p.kind, "input": p.input, "what": p.what, "value": p.value} for p in path.points],
        "note": path.note or None,
    }


def motions_of(
    system: System,
    reference: Reference,
    q: Array,
    count: Gruebler,
    n_freedoms: int,
    independent: Sequence[tuple[str, Measure]],
    wanted: WantedFigures,
) -> Motions:
    """What a motion with one freedom shows at the pose q. independent: coordinates, of which the first is the input
    where nothing is driven; n_freedoms: at nearby poses. Raises InputError and CannotAnswer where what is wanted
    cannot be told."""
    drivers, along = count.drivers, wanted.along
    free = n_freedoms if not drivers else len(q) - rank_at(reference, q, without=drivers).rank
    notes: list[str] = []
    if along is not None:
        given = _input_along(system, reference, q, along, drivers)
    else:
        given = _own_input(system, reference, q, independent, drivers)
    found = Motions(system, given)
    if along is not None or wanted.modes or (free > 0 and len(system.moving) <= _MOST_LISTED):
        found = replace(found, linkages=_in_numbers(system, reference, q))
    if free == 1 and len(system.moving) <= _MOST_LISTED:
        found = replace(found, **_at_pose(system, reference, q, drivers, given))
    if given is None or any(isinstance(row.measure, NonholonomicForm) for row in system.constraint_rows):
        if along is not None:
            raise CannotAnswer(
                Message(
                    "{along} cannot be followed: connections that hold velocities have no curve of poses", along=along
                )
            )
        return found
    if system.space and free == 1:
        notes.append(
            Message(
                "instant centres, Grashof's cases, transmission angles and assembly modes are told in the plane only"
            )
        )
    is_loop = has_loops(system)
    if along is not None or (is_loop and free == 1 and len(system.moving) <= MOST_BODIES):
        try:
            found = replace(
                found,
                singular=tuple(singular_at(reference, q, given.measure, given.released)),
                path=trace(reference, q, given.measure, given.released, outputs=_outputs(system, given)),
            )
        except CannotAnswer as error:
            if along is not None:
                raise
            notes.append(Message("not followed along {name}: {why}", name=given.name, why=error))
    has_few = is_loop and free == 1 and not _counts_turns(system) and len(system.moving) <= _MOST_MODES
    if wanted.modes or (has_few and not system.space):
        try:
            found = replace(found, modes=_modes(reference, q, independent, given))
        except CannotAnswer as error:
            if wanted.modes:
                raise
            notes.append(Message("assembly modes not told: {why}", why=error))
    return replace(found, notes=tuple(notes))


def _at_pose(
    system: System, reference: Reference, q: Array, drivers: Sequence[str], given: Input | None
) -> dict[str, Any]:
    """Centres, in space screws, and ratios; with the drivers left out."""
    loose = system
    if drivers:
        loose = replace(
            system, constraint_rows=tuple(row for row in system.constraint_rows if row.connection not in drivers)
        )
        reference = Reference(loose, reference.frame.values)
        reference.assemble(guess=q)
    snapshot = reference.snapshot(q, 0.0 * q)
    found: dict[str, Any] = {}
    with suppress(CannotAnswer):
        if system.space and given is not None:
            found["screws"] = screw_axes(reference, q, given.measure, given.name)
        else:
            centres = instant_centres(loose, snapshot)
            found["centres"] = tuple(c for c in centres.values() if not c.is_undetermined)
    if given is not None:
        with suppress(CannotAnswer):
            ratios = velocity_ratios(loose, snapshot, given.measure)
            found["ratios"] = tuple(r for r in ratios.values() if r.name != given.name)
    if len(system.moving) <= _MOST_EXACT and not drivers and not system.space:
        with suppress(CannotAnswer, ModelError, RoutesDisagree):
            _add_formulas(ExactPose(loose), found, given)
    return found


def _add_formulas(pose: ExactPose, found: dict[str, Any], given: Input | None) -> None:
    """Formulas beside the numbers, where the pose has them."""
    centres: tuple[CentreOfPair, ...] = found.get("centres", ())
    formulas = pose.centres({c.pair: c for c in centres})
    found["centres"] = tuple(replace(c, formula=formulas.get(c.pair)) for c in centres)
    if given is not None:
        ratios: tuple[VelocityRatio, ...] = found.get("ratios", ())
        system = pose.system
        measures = {b.name: Angle(b.name) for b in system.moving if b.turns} | dict(system.measures)
        found["ratios"] = tuple(
            replace(r, formula=pose.ratio(measures[r.name], given.measure, r.value)) for r in ratios
        )


def _in_numbers(
    system: System, reference: Reference, q: Array
) -> tuple[tuple[Linkage, FourBarNumbers | SliderCrankNumbers], ...]:
    return tuple((loop, dimensions(loop, reference, q)) for loop in linkages(system))


# -- the input --------------------------------------------------------------------------------
def _input_along(system: System, reference: Reference, q: Array, along: str, drivers: Sequence[str]) -> Input:
    """A driver, or a named measure; with it all drivers are left out that would hold the motion."""
    known: dict[str, Measure] = {}
    for row in system.constraint_rows:
        if row.is_driven and not isinstance(row.measure, NonholonomicForm):
            known[row.connection] = row.measure
    if along in known:
        return _input(reference, q, along, known[along], (along,))
    measures = {**dict(system.offered), **system.measures}
    measures |= dict(own_measures(system))
    if along not in measures:
        raise InputError(
            Message(
                "--along {along}: no driver and no measure.{hint} Name a driver, a measure of the model, or "
                "'{example}'",
                along=along,
                hint=did_you_mean(along, [*known, *measures]),
                example=_own_example(system),
            )
        )
    own = [name for name, measure in known.items() if measure == measures[along]]
    return _input(reference, q, along, measures[along], own or tuple(drivers))


def _own_example(system: System) -> str:
    return "angle of BODY.x about z" if system.space else "angle of BODY"


def _own_input(
    system: System,
    reference: Reference,
    q: Array,
    independent: Sequence[tuple[str, Measure]],
    drivers: Sequence[str],
) -> Input | None:
    """The only driver, else the first independent coordinate."""
    if len(drivers) == 1 and not any(
        isinstance(r.measure, NonholonomicForm) for r in system.constraint_rows if r.is_driven
    ):
        return _input_along(system, reference, q, drivers[0], drivers)
    if drivers or not independent:
        return None
    return _input(reference, q, *independent[0], ())


def _counts_turns(system: System) -> bool:
    """Whether turns of bodies are counted, by gears or strings: then a pose is not told by its angles alone."""
    return any(isinstance(row.measure, Combination) and len(row.measure.terms) > 1 for row in system.constraint_rows)


def _input(reference: Reference, q: Array, name: str, measure: Measure, released: Sequence[str]) -> Input:
    value = reference.snapshot(q, 0.0 * q).value(measure)
    return Input(name, measure, tuple(released), value)


def _outputs(system: System, given: Input) -> Mapping[str, Measure]:
    return {name: m for name, m in system.measures.items() if m != given.measure}


def has_loops(system: System) -> bool:
    """Whether the connections close a loop of bodies; all fixed bodies are one."""
    parent: dict[str, str] = {}

    def root(body: str) -> str:
        body = "ground" if system.bodies[body].fixed else body
        while parent.get(body, body) != body:
            body = parent[body]
        return body

    for name in system.connections:
        rows = [row for row in system.constraint_rows if row.connection == name and not row.is_driven]
        bodies = list(dict.fromkeys(b for row in rows for b in row.measure.bodies()))
        moving = [b for b in bodies if not system.bodies[b].fixed]
        ends = moving if len(moving) > 1 else [*moving, "ground"]
        for other in ends[1:]:
            a, b = root(ends[0]), root(other)
            if a == b and moving:
                return True
            parent[b] = a
    return False


def _modes(reference: Reference, q: Array, independent: Sequence[tuple[str, Measure]], given: Input) -> AssemblyModes:
    """All poses with the same values of the independent coordinates, or of the driven input."""
    snapshot = reference.snapshot(q, 0.0 * q)
    fixed = [(m, snapshot.value(m)) for _name, m in independent] or [(given.measure, given.value)]
    return assembly_modes(reference, q, fixed)
