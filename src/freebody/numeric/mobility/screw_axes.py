"""The screws about which the bodies of a mechanism with one freedom move at a pose."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.jets import Array
from freebody.numeric.mobility.twists import ScrewLine, twist_of
from freebody.numeric.reference import Reference

STILL = 1e-9  # of a rate, by the size of the system


@dataclass(frozen=True)
class ScrewAxis:
    """How one body moves in an instant: it turns about a line and travels along it by the pitch [m/rad]; without a
    pitch it only travels. rate: of the turn [rad], or of the travel [m], for a unit rate of the input."""

    body: str
    screw: ScrewLine
    rate: float

    def to_plain(self) -> dict[str, Any]:
        pitch = self.screw.pitch
        return {
            "body": self.body,
            "point": None if pitch is None else [float(c) for c in self.screw.point],
            "direction": [float(c) for c in self.screw.direction],
            "pitch": pitch,
            "rate": self.rate,
        }


def screw_axes(reference: Reference, q: Array, measure: Measure, name: str) -> tuple[ScrewAxis, ...]:
    """The screws of all bodies that move, for a growing input `measure`. Raises CannotAnswer unless the pose has one
    freedom, or where the input stands still."""
    null = reference.split_at(q, {}).null
    if null.shape[1] != 1:
        raise CannotAnswer(Message("screw axes need one freedom, and the pose has {n}", n=null.shape[1]))
    v, size = null[:, 0] / float(np.abs(null[:, 0] / reference.sizes.unit_moves).max()), reference.sizes.length
    g = reference.geometry(q, v, 0.0)
    rate = reference.jet(g, measure, name).rate
    if abs(rate) <= STILL * max(1.0, size):
        raise CannotAnswer(Message("{name} stands still in this pose while others move (a dead point)", name=name))
    found: list[ScrewAxis] = []
    for body, columns in reference.frame.columns.items():
        speeds = v[list(columns)] / rate
        if float((np.abs(speeds) / reference.sizes.unit_moves[list(columns)]).max()) <= STILL:
            continue
        if len(columns) == 3:
            speeds = np.concatenate([speeds, np.zeros(3)])
        twist = twist_of(reference, q, body, speeds)
        screw = ScrewLine.of(twist, size)
        along = twist[3:] if screw.pitch is None else twist[:3]
        found.append(ScrewAxis(body, screw, float(np.linalg.norm(along))))
    return tuple(found)
