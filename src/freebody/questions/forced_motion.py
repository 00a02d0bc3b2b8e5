"""Questions about oscillations that a harmonic load or drive forces, when free ones have died away.

steady amplitude of QUANTITY      phase lag of QUANTITY [behind QUANTITY]      resonance frequency of QUANTITY
transmissibility [from QUANTITY] to QUANTITY      magnification factor of QUANTITY
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, Dimension
from freebody.questions.base import Path, Quantity, angular_unit
from freebody.questions.forms import Found, asked
from freebody.questions.grammar import read_calculation
from freebody.questions.small_motion import OfSmallMotion

if TYPE_CHECKING:
    from freebody.model.names import Names


class Forced(OfSmallMotion):
    """What is asked of the steady motion under harmonic loads or drives, cos(Omega t) or sin(Omega t)."""


@dataclass(frozen=True)
class SteadyAmplitude(Forced, kind="steady amplitude"):
    """How far a quantity swings about its mean in forced oscillation, when free motions have died away."""

    of: Quantity
    name: str

    example = """
parameters: {m: 2 kg, k: 200 N/m, c: 4 N s/m, F0: 10 N, Omega: 5 rad/s}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads:
  spring: {law: {measure: x, force: -k*x}}
  damper: {law: {measure: x, force: -c*rate(x)}}
  shaker: {force: {at: block, along: right, magnitude: F0*cos(Omega*t)}}
start: {x: 0}
questions: {it: steady amplitude of x}
"""

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.of.unit

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)


@dataclass(frozen=True)
class PhaseLag(Forced, kind="phase lag"):
    """By which angle a quantity lags behind another one, or behind what excites the system, in forced oscillation:
    between -pi and pi."""

    of: Quantity
    behind: Quantity | None = None

    example = SteadyAmplitude.example.replace("steady amplitude of x", "phase lag of x")

    @property
    def unit(self) -> str:
        return angular_unit(DIMENSIONLESS)

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,) if self.behind is None else (self.of, self.behind)


@dataclass(frozen=True)
class Transmissibility(Forced, kind="transmissibility"):
    """The ratio of two amplitudes in forced oscillation: of a quantity, and of another one or of the excitation."""

    of: Quantity
    source: Quantity | None = None

    example = SteadyAmplitude.example.replace("steady amplitude of x", "transmissibility to acceleration of x")

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,) if self.source is None else (self.of, self.source)


@dataclass(frozen=True)
class MagnificationFactor(Forced, kind="magnification factor"):
    """The steady amplitude of a quantity over that under the same excitation of a frequency that tends to zero: how
    much further it swings than it would be deflected at rest. Source: Rao, Mechanical Vibrations, 5th ed. 2011,
    sec. 3.3."""

    of: Quantity

    example = SteadyAmplitude.example.replace("steady amplitude of x", "magnification factor of x")

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)


@dataclass(frozen=True)
class ResonanceFrequency(Forced, kind="resonance frequency"):
    """The angular frequency of the excitation at which the steady amplitude of a quantity is largest."""

    of: Quantity

    measured_in = ANGULAR_VELOCITY
    example = SteadyAmplitude.example.replace("steady amplitude of x", "resonance frequency of x")

    @property
    def unit(self) -> str:
        return angular_unit(self.dimension)

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)


# -- words ------------------------------------------------------------------------------------
def _swinging(names: Names, text: str | None, path: Path) -> Quantity | None:
    """A quantity that swings: a property of an instant."""
    with names.one_number():
        of = None if text is None else read_calculation(names, text, path)
    if of is None or of.scope == "instant":
        return of
    names.problem(
        Message("'{text}' is no property of one instant; ask for a measure, a velocity or a force", text=text or ""),
        *path,
    )
    return None


@asked(
    "steady amplitude of QUANTITY",
    r"(?:steady(?:[- ]state)? amplitude|amplitude of (?:the )?(?:forced|steady)(?:[- ]state)? oscillations?)"
    r" of (?:the )?(?P<of>.+)",
    rank=90,
)
def _amplitude(names: Names, found: Found, path: Path) -> Quantity | None:
    of = _swinging(names, found["of"], path)
    return None if of is None else SteadyAmplitude(of, str(found["of"]))


@asked(
    "phase lag of QUANTITY [behind QUANTITY]",
    r"phase(?: lag| angle)? of (?:the )?(?P<of>.+?)(?: behind (?:the )?(?P<behind>.+))?",
    rank=90,
)
def _lag(names: Names, found: Found, path: Path) -> Quantity | None:
    of, behind = (_swinging(names, found[key], path) for key in ("of", "behind"))
    return None if of is None or (found["behind"] and behind is None) else PhaseLag(of, behind)


@asked(
    "transmissibility [from QUANTITY] to QUANTITY",
    r"transmissibility(?: from (?:the )?(?P<source>.+?))?(?: to| of) (?:the )?(?P<of>.+)",
    rank=90,
)
def _transmitted(names: Names, found: Found, path: Path) -> Quantity | None:
    of, source = (_swinging(names, found[key], path) for key in ("of", "source"))
    return None if of is None or (found["source"] and source is None) else Transmissibility(of, source)


@asked("resonance frequency of QUANTITY", r"reson(?:ance|ant) frequency of (?:the )?(?P<of>.+)", rank=90)
def _resonance(names: Names, found: Found, path: Path) -> Quantity | None:
    of = _swinging(names, found["of"], path)
    return None if of is None else ResonanceFrequency(of)


@asked(
    "magnification factor of QUANTITY",
    r"(?:dynamic )?(?:magnification|amplification) factor of (?:the )?(?P<of>.+)",
    rank=90,
)
def _magnified(names: Names, found: Found, path: Path) -> Quantity | None:
    of = _swinging(names, found["of"], path)
    return None if of is None else MagnificationFactor(of)
