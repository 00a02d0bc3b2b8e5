"""Rod: a slender uniform bar.

Moment of inertia: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import divide, multiply, negate, number, power
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape, half
from freebody.model.solids import ROD
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Rod(Shape, kind="rod"):
    """A slender uniform rod from `start` to `end`, along its own x axis; I = m L^2/12."""

    called: ClassVar[tuple[str, ...]] = ("bar", "beam", "ladder", "link", "crank", "stick", "pole", "arm")
    also: ClassVar[tuple[str, ...]] = (
        *("bar", "beam", "ladder", "crank", "stick", "pole", "arm", "lever", "boom", "girder", "coupler", "rocker"),
        *("connecting_rod", "conrod", "jib", "mast", "Hebel", "Ausleger", "Träger", "Koppel", "Schwinge"),
        *("Stab", "Balken", "Leiter", "Kurbel", "Stange", "Pleuel"),
    )

    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("from", "to"), Message("its ends are put beside the shape: {{rod: , at: {{start: A, end: B}}}}")
        ),
        "inertia": Message(
            "that of a rod follows from its mass and its length (m*L^2/12); one with another is a body: {{body: "
            "{{mass: m, inertia: J}}, points: {{start: [0, 0], end: [L, 0]}}}}"
        ),
    }
    ends: ClassVar[tuple[str, ...]] = ("start", "end")

    mass: Formula = 0
    length: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"length": ()}

    example = "{mass: 1 kg, length: 1 m}"

    def build(self, names: Names) -> Build:
        m, length = names.positive(self, "mass", MASS), names.positive(self, "length", LENGTH)
        end, inertia = half(length), divide(multiply(m, power(length, number(2))), number(12))
        return Build(
            m,
            inertia,
            points={"start": (negate(end), ZERO), "end": (end, ZERO)},
            corners=("start", "end"),
            tensor=(ZERO, inertia, inertia, ZERO, ZERO, ZERO) if names.space else (),
            solid=ROD,
            sizes=(length,),
        )
