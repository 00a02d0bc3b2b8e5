"""The equilibria of a system, as a result that says itself in blocks."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, ENERGY
from freebody.measures.base import Measure
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.rest import CountedPose
from freebody.present.lines import number_text, symbol_text, system_line, value_text
from freebody.present.report.blocks import Block, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, line, summary
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_SHOWN = 1e-14  # [m, rad] a coordinate below this is shown as zero


@dataclass(frozen=True)
class FoundEquilibrium:
    """One equilibrium.

    measures: values of the named measures, by name [m or rad]; poses: x, y of the mass centre [m] and angle [rad] by
    body; reactions: by row (`hinge.x`) [N or N m], None where they are not unique; `non_unique` names these;
    eigenvalue: the one that decides on stability, of the stiffness by the masses [1/s^2] or of the state
    matrix [1/s]; direction: the measure or body that its motion moves most; neutral: those along which the rest is one
    of a family; residual: what is left of the loads, as a part of what they come to; notes: what else to know."""

    measures: Mapping[str, float]
    poses: Mapping[str, tuple[float, ...]]
    stability: str
    eigenvalue: complex | None
    eigenvalue_of: str
    direction: str
    neutral: tuple[str, ...]
    reactions: Mapping[str, float | None]
    non_unique: tuple[str, ...]
    residual: float
    notes: tuple[str, ...]
    pose: CountedPose

    @property
    def q(self) -> Array:
        """Absolute coordinates, for `Reference`."""
        return self.pose.q


@dataclass(frozen=True)
class Equilibria(Result):
    """All equilibria that were found; `notes` say what holds for all of them."""

    system: System
    degrees_of_freedom: int
    rests: tuple[FoundEquilibrium, ...]
    notes: tuple[str, ...]
    reference: Reference = field(repr=False)
    searched: str = ""  # among the notes: how the rests were found, and that there may be more

    def __iter__(self) -> Iterator[FoundEquilibrium]:
        return iter(self.rests)

    def __len__(self) -> int:
        return len(self.rests)

    def __getitem__(self, k: int) -> FoundEquilibrium:
        return self.rests[k]

    def unit(self, measure: str) -> str:
        """The SI unit of a named measure; rad for angles and other pure numbers."""
        state = self.system.states.get(measure)
        return unit_of(self.system.measures[measure]) if state is None else str(state.dimension)

    def to_plain(self) -> dict[str, Any]:
        """The JSON document of `freebody equilibrium`: title, degrees_of_freedom, notes, and `equilibria`, each with
        measures {name: {value, unit}}, poses {body: [x, y, angle]}, stability, eigenvalue (a number, or [re, im]),
        eigenvalue_of, direction, neutral, reactions {row: number or null}, non_unique [row], residual, notes."""
        return {
            "title": self.system.title,
            "degrees_of_freedom": self.degrees_of_freedom,
            "notes": list(self.notes),
            "equilibria": [
                {
                    "measures": {n: {"value": x, "unit": self.unit(n)} for n, x in rest.measures.items()},
                    "poses": {body: list(pose) for body, pose in rest.poses.items()},
                    "stability": rest.stability,
                    "eigenvalue": None if rest.eigenvalue is None else plain_number(rest.eigenvalue),
                    "eigenvalue_of": rest.eigenvalue_of,
                    "direction": rest.direction,
                    "neutral": list(rest.neutral),
                    "reactions": dict(rest.reactions),
                    "non_unique": list(rest.non_unique),
                    "residual": rest.residual,
                    "notes": list(rest.notes),
                }
                for rest in self.rests
            ],
        }

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        yield line(system_line(self.system, self.degrees_of_freedom))
        yield from (line(Message("note: {note}", note=note)) for note in self.notes)
        for k, rest in enumerate(self, 1):
            one, several = Message("Equilibrium"), Message("Equilibrium {k} of {n}", k=k, n=len(self))
            title = Message("{what}: {verdict}", what=one if len(self) == 1 else several, verdict=_verdict(rest))
            at = [value_text(n, x, self.unit(n)) for n, x in rest.measures.items()]
            said = entries(
                entry(Message("at"), *(at or (_pose(body, pose) for body, pose in rest.poses.items()))),
                entry(Message("reactions"), *self._reactions(rest)),
                entry(Message("note"), *rest.notes),
            )
            yield Section((title,), tuple(said))

    def _reactions(self, rest: FoundEquilibrium) -> Iterator[str]:
        largest = max((abs(x) for x in rest.reactions.values() if x is not None), default=0.0)
        for row in self.system.constraint_rows:
            if row.name not in rest.reactions:
                continue
            value, names = rest.reactions[row.name], {"row": row.name, "what": row.reaction}
            if value is None:
                yield Message("{row}: {what} is not unique", **names)
            else:
                unit = ENERGY / row.measure.dimension
                is_nothing = abs(value) <= ROUND_OFF * largest
                x = number_text(0.0 if is_nothing else value)
                yield Message("{row}: {what} {x} {unit}", x=x, unit=unit, **names)


def _verdict(rest: FoundEquilibrium) -> str:
    if rest.eigenvalue is None:
        return Message("nothing can move") if rest.stability == "stable" and not rest.direction else rest.stability
    x = rest.eigenvalue
    value = number_text(x.real) if not x.imag else f"{number_text(x.real)} ± {number_text(abs(x.imag))} i"
    along = symbol_text(rest.direction)
    return Message(
        "{stability} (lowest stiffness {value} 1/s^2, along {name})"
        if rest.eigenvalue_of == "stiffness"
        else "{stability} (eigenvalue {value} 1/s, along {name})",
        stability=rest.stability,
        value=value,
        name=along,
    )


def _pose(body: str, pose: tuple[float, ...]) -> str:
    """Of a body in space its place alone: how it is turned is told by measures."""
    is_in_space = len(pose) > 3
    place, angle = pose[: 3 if is_in_space else 2], 0.0 if abs(pose[-1]) < _SHOWN else pose[-1]
    at = ", ".join(number_text(c, _SHOWN) for c in place)
    return f"{body}: ({at}) m" + ("" if is_in_space else f", {number_text(math.degrees(angle))}°")


def unit_of(measure: Measure) -> str:
    """The SI unit of a measure."""
    return "rad" if measure.dimension == DIMENSIONLESS else str(measure.dimension)


def plain_number(x: complex) -> float | list[float]:
    """A real number as such, a complex one as [re, im]."""
    return x.real if x.imag == 0.0 else [x.real, x.imag]
