"""Shares of the kinetic energy: of the mass centres, and of the turning about them (König's theorem).

    T = sum of m v_G^2/2 + sum of omega . I_G omega / 2

Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed., sec. 1.2 and 5.3.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, cast

from freebody.language.units import ENERGY
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.energy import kinetic_energy, translational_energy
from freebody.questions.forms import NAME, Found, asked

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class KineticEnergyShare(Quantity, kind="share of kinetic energy"):
    """The kinetic energy of the motion with the mass centre, or of the turning about it, of the system or one body."""

    what: Literal["rotational", "translational"]
    body: str | None = None

    example = """
bodies: {disk: {disk: {mass: 2 kg, radius: 0.1 m}, velocity: [3 m/s, 0], angular_velocity: 5 rad/s}}
questions: {it: rotational kinetic energy of disk at start}
"""
    measured_in = ENERGY

    @property
    def unit(self) -> str:
        return "J"

    @property
    def is_of_whole(self) -> bool:
        return self.body is None

    def value(self, system: Described, state: State[Any]) -> Any:
        total: Any = 0
        for b in system.moving:
            if self.body in (None, b.name):
                of_center = translational_energy(system, state, b)
                own = of_center if self.what == "translational" else kinetic_energy(system, state, b) - of_center
                total = total + own
        return total


@asked(
    "rotational | translational kinetic energy [of BODY]",
    rf"(?P<what>rotational|translational) kinetic energy(?: of (?:the )?(?P<of>{NAME}))?",
    rank=40,
    example="""
bodies: {disk: {disk: {mass: 2 kg, radius: 0.1 m}, velocity: [3 m/s, 0], angular_velocity: 5 rad/s}}
questions: {it: translational kinetic energy at start}
""",
)
def _share(names: Names, found: Found, path: Path) -> Quantity:
    of = found["of"]
    body = None if of is None or of == "system" else names.body(of, *path).name
    return KineticEnergyShare(cast("Any", found["what"]), body)
