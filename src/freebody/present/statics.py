"""Equilibria and natural motions as text for a terminal."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol
from freebody.language.notation import to_text
from freebody.present.lines import number_text, plural
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.study.small_motion.equilibrium import Equilibria, FoundEquilibrium
    from freebody.study.small_motion.modes import NaturalMode, NaturalModes

_RULE = "─"
_NOTHING = 1e-9  # of the largest number of its kind


def equilibrium_lines(equilibria: Equilibria) -> Iterator[str]:
    """All equilibria, nearest to the start first."""
    system = equilibria.system
    yield from _heading(system, equilibria.degrees_of_freedom)
    for note in equilibria.notes:
        yield f"note: {note}"
    for k, rest in enumerate(equilibria, 1):
        yield ""
        title = "Equilibrium" if len(equilibria) == 1 else f"Equilibrium {k} of {len(equilibria)}"
        yield f"{title}: {_verdict(rest)}"
        yield from _listed("at", [f"{_shown(n)} = {_amount(x, equilibria.unit(n))}" for n, x in rest.measures.items()])
        if not rest.measures:
            yield from _listed("at", [_pose(body, pose) for body, pose in rest.poses.items()])
        yield from _listed("reactions", _reactions(system, rest))
        yield from _listed("note", list(rest.notes))


def _heading(system: System, dof: int) -> Iterator[str]:
    yield system.title
    yield _RULE * min(len(system.title), 78)
    yield (
        f"{plural(len(system.moving), 'moving body', 'moving bodies')}, "
        f"{plural(len(system.connections), 'connection')}, {plural(dof, 'degree')} of freedom"
    )


def _verdict(rest: FoundEquilibrium) -> str:
    if rest.eigenvalue is None:
        return rest.stability if rest.direction else "nothing can move"
    x = rest.eigenvalue
    value = number_text(x.real) if not x.imag else f"{number_text(x.real)} ± {number_text(abs(x.imag))} i"
    what, unit = ("lowest stiffness", "1/s^2") if rest.eigenvalue_of == "stiffness" else ("eigenvalue", "1/s")
    return f"{rest.stability} ({what} {value} {unit}, along {_shown(rest.direction)})"


def _shown(name: str) -> str:
    return to_text(Symbol(name)) if name.isidentifier() else name


def _amount(x: float, unit: str) -> str:
    """A number with its unit; an angle in degrees as well."""
    x = 0.0 if abs(x) < 1e-14 else x
    return f"{number_text(x)} rad ({number_text(math.degrees(x))}°)" if unit == "rad" else f"{number_text(x)} {unit}"


def _pose(body: str, pose: tuple[float, ...]) -> str:
    if len(pose) > 3:  # in space a place; how it is turned is told by measures
        return f"{body}: ({', '.join(number_text(0.0 if abs(c) < 1e-14 else c) for c in pose[:3])}) m"
    x, y, angle = (0.0 if abs(c) < 1e-14 else c for c in pose)
    return f"{body}: ({number_text(x)}, {number_text(y)}) m, {number_text(math.degrees(angle))}°"


def _reactions(system: System, rest: FoundEquilibrium) -> list[str]:
    texts: list[str] = []
    largest = max((abs(x) for x in rest.reactions.values() if x is not None), default=0.0)
    for row in system.held:
        value = rest.reactions[row.name]
        what = f"{row.name}: {row.reaction}"
        if value is None:
            texts.append(f"{what} is not unique")
        else:
            unit = {"1": "N m", "m": "N"}.get(str(row.measure.dimension), "(SI)")
            texts.append(f"{what} {number_text(0.0 if abs(value) <= _NOTHING * largest else value)} {unit}")
    return texts


def mode_lines(modes: NaturalModes) -> Iterator[str]:
    """All natural motions, slowest first."""
    yield from _heading(modes.system, len(modes.small.speeds))
    units = {name: "rad" if str(m.dimension) == "1" else str(m.dimension) for name, m in modes.system.measures.items()}
    at = ", ".join(f"{_shown(n)} = {_amount(x, units[n])}" for n, x in modes.measures.items())
    stability = f" ({modes.stability})" if modes.stability else ""
    yield f"small motions about the {modes.about}{stability}" + (f": {at}" if at else "")
    for note in modes.notes:
        yield f"note: {note}"
    if not modes.modes:
        yield ""
        yield "Nothing can move, so there are no modes."
    for k, mode in enumerate(modes, 1):
        yield ""
        yield f"Mode {k}: {_motion(mode)}"
        if any(abs(x) for x in mode.shape.values()):
            yield from _listed("shape", _shape(mode.shape))
        else:
            yield from _listed("shape", [f"{body}: ({', '.join(map(_part, m))})" for body, m in mode.bodies.items()])


def _motion(mode: NaturalMode) -> str:
    rate = mode.rate
    if mode.kind == "rigid":
        return "rigid, no frequency: it stays or drifts"
    if mode.kind == "creeping":
        return f"creeping back, rate {number_text(rate.real)} 1/s"
    if mode.frequency is None:
        return f"growing, rate {number_text(rate.real)} 1/s"
    assert mode.frequency_hz is not None
    text = f"omega = {number_text(mode.frequency)} rad/s, f = {number_text(mode.frequency_hz)} Hz"
    if mode.damping_ratio:
        text += f", damping ratio {number_text(mode.damping_ratio)}, damped {number_text(abs(rate.imag))} rad/s"
    return f"growing, rate {number_text(rate.real)} 1/s, {text}" if mode.kind == "growing" else text


def _shape(shape: Mapping[str, complex]) -> list[str]:
    return [f"{_shown(name)} {_part(x)}" for name, x in shape.items()]


def _part(x: complex) -> str:
    if abs(x.imag) < 1e-9:
        return number_text(x.real if abs(x.real) > _NOTHING else 0.0)
    return f"{number_text(abs(x))} at {number_text(math.degrees(math.atan2(x.imag, x.real)))}°"


def _listed(label: str, texts: list[str]) -> Iterator[str]:
    for k, text in enumerate(texts):
        yield f"    {label if k == 0 else '':<12}{text}"
