"""The motion of a model for the page: what the player draws, with its events, and after that its curves, for which no
picture waits."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from freebody.language.expression import Call, Symbol
from freebody.language.notation import to_mathml
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.present.layout import Layout
from freebody.present.page import ANGLE_DIGITS, Pages
from freebody.present.plots import curves
from freebody.present.scene import Scene
from freebody.studio.reading import checked_system, passing_system
from freebody.studio.telling import told
from freebody.studio.wire.motions import (
    CurvesAnswer,
    Happening,
    Line,
    MotionAnswer,
    MotionRequest,
    StartAnswer,
    StartRequest,
)
from freebody.study.simulation.recorded import series_units
from freebody.study.simulation.simulate import Simulation, simulated_like
from freebody.study.simulation.simulator import Simulator, placed_at_start
from freebody.system.system import System

_DIGITS = 7  # of a curve
_PASSING = 1e-6  # tolerance of a motion that is soon replaced: of the size of the system, far below a pixel
_SECONDS = 20.0  # by the clock, after which a motion ends where it is
_ENERGY = ("kinetic_energy", "potential_energy", "work")


@dataclass(frozen=True)
class Followed:
    """A motion that was asked for, by its text, its end, its frames and whether it passes by."""

    asked: tuple[str, float, int, bool]
    found: Simulation

    @cached_property
    def pages(self) -> Pages:
        """What the player draws."""
        return drawn(self.found, self.asked[2])


_latest: list[Followed] = []  # what was followed last: its curves are asked for next
_placed: list[tuple[str, System, tuple[Reference, Array]]] = []  # the start that was asked for last, by its text


def motion(request: MotionRequest) -> MotionAnswer:
    """Raises CannotAnswer where the motion cannot begin."""
    last = _followed(request)
    return motion_of(last.found, request, last.pages)


def curved(request: MotionRequest) -> CurvesAnswer:
    """Raises CannotAnswer where the motion cannot begin."""
    return curves_of(followed_last(request), request.language)


def started(request: StartRequest) -> StartAnswer:
    """Where a motion starts, for the picture of one that was followed before: nothing where other lines would be drawn.
    Raises CannotAnswer where it cannot begin."""
    before = next((last for last in _latest if last.asked[0] == request.like), None)
    if before is None or not _is_plain(before):
        return StartAnswer(columns=None)
    _placed[:] = [_placed_in(request.text)]
    _text, system, (reference, q) = _placed[0]
    scene, shown = before.found.simulator.scene, before.pages
    if not (before.found.system.starts_otherwise(system) or Scene.of(system, reference.number).looks_like(scene)):
        return StartAnswer(columns=None)
    poses, _still = reference.by_body(q, np.zeros_like(q))
    if len(poses) != len(scene.names) or Layout.of(scene, poses[None], shown.own["symbol"]).moved:
        return StartAnswer(columns=None)
    digits = (shown.digits, shown.digits, ANGLE_DIGITS) * len(poses)
    return StartAnswer(columns=[round(x, n) + 0.0 for x, n in zip(poses.ravel().tolist(), digits, strict=True)])


def _is_plain(last: Followed) -> bool:
    """Whether its bodies are drawn where they are, and nothing beside them that changes on the way."""
    scene = last.found.simulator.scene
    return last.pages.is_planar and not (last.pages.note or scene.ropes or scene.belts)


def _placed_in(text: str) -> tuple[str, System, tuple[Reference, Array]]:
    """Raises CannotAnswer where the start cannot be assembled."""
    if _placed and _placed[0][0] == text:
        return _placed[0]
    system = passing_system(text)
    return text, system, placed_at_start(system)


def followed_last(request: MotionRequest) -> Simulation:
    """Raises CannotAnswer where the motion cannot begin."""
    return _followed(request).found


def _followed(request: MotionRequest) -> Followed:
    """Raises CannotAnswer where the motion cannot begin."""
    asked = (request.text, request.until, request.frames, request.is_passing)
    if not _latest or _latest[0].asked != asked:
        before = _latest[0].found.simulator if _latest and request.is_passing else None
        start = next((start for start in _placed if start[0] == request.text and request.is_passing), None)
        _latest.clear()  # two need not be kept at once
        _placed.clear()
        if start is not None:
            _text, system, placed = start
        else:
            system = passing_system(request.text) if request.is_passing else checked_system(request.text)
            placed = None
        _latest.append(Followed(asked, followed(system, request, before, placed)))
    return _latest[0]


def followed(
    system: System,
    request: MotionRequest,
    before: Simulator | None = None,
    placed: tuple[Reference, Array] | None = None,
) -> Simulation:
    """before: of the motion that this one follows; placed: as for `Simulator`. Raises CannotAnswer where the motion
    cannot begin."""
    every = request.until / (request.frames - 1)
    options = SimulationOptions(every=every, max_seconds=_SECONDS)
    if request.is_passing:
        options = replace(options, tolerance=_PASSING)
    return simulated_like(system, request.until, options, before, placed)


def drawn(found: Simulation, frames: int) -> Pages:
    """A motion as the player draws it, in so many frames."""
    return found.film().page(frames if len(found.course.times) > 1 else 1)


def motion_of(found: Simulation, request: MotionRequest, pages: Pages | None = None) -> MotionAnswer:
    """What is seen of a motion."""
    times = found.course.times
    return MotionAnswer(
        player=(pages or drawn(found, request.frames)).data(1.0),
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
