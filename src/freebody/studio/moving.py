"""The motion of a model for the page: what the player draws, with its events, and after that its curves, for which no
picture waits."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from freebody.language.expression import Call, Symbol
from freebody.language.notation import to_mathml
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.present.plots import curves
from freebody.studio.reading import checked_system, passing_system
from freebody.studio.telling import told
from freebody.studio.wire.motions import CurvesAnswer, Happening, Line, MotionAnswer, MotionRequest
from freebody.study.simulation.recorded import series_units
from freebody.study.simulation.simulate import Simulation, simulate
from freebody.system.system import System

_DIGITS = 7  # of a curve
_PASSING = 1e-6  # tolerance of a motion that is soon replaced: of the size of the system, far below a pixel
_SECONDS = 20.0  # by the clock, after which a motion ends where it is
_ENERGY = ("kinetic_energy", "potential_energy", "work")


_latest: list[
    tuple[tuple[str, float, int, bool], Simulation]
] = []  # what was followed last: its curves are asked for next


def motion(request: MotionRequest) -> MotionAnswer:
    """Raises CannotAnswer where the motion cannot begin."""
    return motion_of(followed_last(request), request)


def curved(request: MotionRequest) -> CurvesAnswer:
    """Raises CannotAnswer where the motion cannot begin."""
    return curves_of(followed_last(request), request.language)


def followed_last(request: MotionRequest) -> Simulation:
    """Raises CannotAnswer where the motion cannot begin."""
    asked = (request.text, request.until, request.frames, request.is_passing)
    if not _latest or _latest[0][0] != asked:
        _latest.clear()  # two need not be kept at once
        system = passing_system(request.text) if request.is_passing else checked_system(request.text)
        _latest.append((asked, followed(system, request)))
    return _latest[0][1]


def followed(system: System, request: MotionRequest) -> Simulation:
    """Raises CannotAnswer where the motion cannot begin."""
    every = request.until / (request.frames - 1)
    options = SimulationOptions(every=every, max_seconds=_SECONDS)
    return simulate(
        system, request.until, options=replace(options, tolerance=_PASSING) if request.is_passing else options
    )


def motion_of(found: Simulation, request: MotionRequest) -> MotionAnswer:
    """What is seen of a motion."""
    times = found.course.times
    return MotionAnswer(
        player=found.film().page(request.frames if len(times) > 1 else 1).data(1.0),
        start=float(times[0]),
        end=float(times[-1]),
        events=[Happening(time=event.time, name=told(event.name, request.language)) for event in found.events],
        is_complete=found.is_complete,
        message=told(str(found.course.message or ""), request.language),
    )


def curves_of(found: Simulation, language: str) -> CurvesAnswer:
    """What is measured along it."""
    recording = found.recording
    shown, symbols = curves(recording, _shown(found)), _symbols(found.system)
    return CurvesAnswer(
        times=rounded(recording.times),
        lines=[
            Line(
                name=c.name,
                label=told(c.label, language),
                math=symbols.get(c.name, ""),
                unit=c.unit,
                values=rounded(c.values),
            )
            for c in shown
        ],
        recordable=[name for name in series_units(found.system) if name in recording.over_time],
        energy_error=_finite(found.summary().get("energy_error_relative")),
    )


def _symbols(system: System) -> dict[str, str]:
    """Of named measures and their rates, in MathML, by the names of their curves."""
    found: dict[str, str] = {}
    for name in filter(str.isidentifier, system.measures):
        rate = Call("rate", Symbol(name))
        found[name], found[f"{name}_rate"] = to_mathml(Symbol(name)), to_mathml(rate)
        found[f"{name}_acceleration"] = to_mathml(Call("rate", rate))
    return found


def _shown(found: Simulation) -> list[str]:
    """The curves that are usual, all others over time, and energy."""
    recording = found.recording
    usual = [str(name) for name in recording.attributes.get("measures", ())]
    if not usual:
        usual = [name for name in ("body_angle", "body_position") if name in recording.series]
    others = [name for name in recording.over_time if name not in usual]
    return [*usual, *(n for n in others if n not in _ENERGY), *(n for n in _ENERGY if n in others)]


def rounded(values: Array) -> list[Any]:
    """To the digits that anybody sees; nothing where there is no value."""
    array = np.asarray(values, dtype=np.float64)
    is_finite = np.isfinite(array)
    sized = np.where(is_finite & (array != 0.0), array, 1.0)
    places = np.clip(_DIGITS - 1 - np.floor(np.log10(np.abs(sized))), -300, 300)
    # a power of ten is exact where it multiplies, so that what comes out is the shortest number of these digits
    up, down = 10.0 ** np.maximum(places, 0.0), 10.0 ** np.maximum(-places, 0.0)
    found: list[Any] = np.where(sized == array, np.round(sized * up / down) / up * down, 0.0).tolist()
    return found if is_finite.all() else [v if ok else None for v, ok in zip(found, is_finite.tolist(), strict=True)]


def _finite(value: Any) -> float | None:
    return float(value) if isinstance(value, int | float) and math.isfinite(value) else None
