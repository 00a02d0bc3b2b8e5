"""One natural motion, and how it is told."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from freebody.language.sentences import Message, in_turn
from freebody.present.lines import number_text, symbol_text, value_text
from freebody.study.small_motion.found import plain_number
from freebody.tolerances import ROUND_OFF


@dataclass(frozen=True)
class NaturalMode:
    """One natural motion, z = shape e^(s t).

    kind: "oscillation", "rigid" (no frequency: it stays or drifts), "creeping" (one real rate of decay; an
    overdamped pair has two of these) or "growing"; rate: s [1/s]; shape: parts of the named measures, the largest of
    them 1 [SI, for rates of measures alike]; bodies: motion of every body, (x, y, angle) in the plane and (x, y, z,
    turns about x, y, z) in space [m, rad], the largest part 1. Parts are complex where they do not move in phase."""

    kind: str
    rate: complex
    shape: Mapping[str, complex]
    bodies: Mapping[str, tuple[complex, ...]]

    @property
    def frequency(self) -> float | None:
        """Natural (undamped) angular frequency |s| [rad/s]; 0 for a rigid mode, None where nothing oscillates."""
        if self.kind == "rigid":
            return 0.0
        return abs(self.rate) if self.rate.imag else None

    @property
    def frequency_hz(self) -> float | None:
        """The same in Hz."""
        return None if self.frequency is None else self.frequency / math.tau

    @property
    def damped_frequency(self) -> float | None:
        """|Im s| [rad/s], at which a damped mode swings."""
        return None if self.frequency is None else abs(self.rate.imag)

    @property
    def damping_ratio(self) -> float | None:
        """zeta = -Re s/|s|; None where nothing oscillates."""
        return -self.rate.real / abs(self.rate) + 0.0 if self.rate.imag else None

    @property
    def growth_rate(self) -> float:
        """Re s [1/s]: negative where the mode dies away."""
        return self.rate.real

    def to_plain(self) -> dict[str, Any]:
        return {
            "kind": self.kind,
            "frequency": self.frequency,
            "frequency_hz": self.frequency_hz,
            "damped_frequency": self.damped_frequency,
            "damping_ratio": self.damping_ratio,
            "growth_rate": self.growth_rate,
            "shape": {name: plain_number(x) for name, x in self.shape.items()},
            "bodies": {name: [plain_number(x) for x in motion] for name, motion in self.bodies.items()},
        }

    @property
    def told(self) -> str:
        """Its kind and its frequency or rate, in words."""
        rate = self.rate
        if self.kind == "rigid":
            return Message("rigid, no frequency: it stays or drifts")
        if self.kind == "creeping":
            return Message("creeping back, rate {rate} 1/s", rate=number_text(rate.real))
        growing = [Message("growing, rate {rate} 1/s", rate=number_text(rate.real))] if self.kind == "growing" else []
        if self.frequency is None:
            return in_turn(growing)
        assert self.frequency_hz is not None
        swings: list[str] = [
            value_text("omega", self.frequency, "rad/s"),
            value_text("f", self.frequency_hz, "Hz"),
        ]
        if self.damping_ratio:
            swings.append(Message("damping ratio {ratio}", ratio=number_text(self.damping_ratio)))
            swings.append(Message("damped {frequency} rad/s", frequency=number_text(abs(rate.imag))))
        return in_turn([*growing, *swings])

    @property
    def told_shape(self) -> list[str]:
        """The parts of the named measures, or the motions of the bodies where no measure moves."""
        if any(abs(x) for x in self.shape.values()):
            return [Message("{name} {part}", name=symbol_text(name), part=_part(x)) for name, x in self.shape.items()]
        return [
            Message("{body}: ({parts})", body=body, parts=in_turn(list(map(_part, motion))))
            for body, motion in self.bodies.items()
        ]


def _part(x: complex) -> str:
    if abs(x.imag) < ROUND_OFF:
        return number_text(x.real if abs(x.real) > ROUND_OFF else 0.0)
    phase = number_text(math.degrees(math.atan2(x.imag, x.real)))
    return Message("{size} at {phase}°", size=number_text(abs(x)), phase=phase)
