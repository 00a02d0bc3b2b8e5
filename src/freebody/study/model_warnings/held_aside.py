"""A body that hangs on a string, kept straight below by a force that no string gives.

What hangs is taken to go straight up and down. The row that holds it there stands for nothing in the model, so its
force must vanish: where a load, a spring or a contact pushes the body sideways the string hangs askew, and all that is
said of it and of what it moves is that of a guide.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.numeric.instant import forces
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_NOTHING = 1e-7  # of the largest load in the model


class HeldAside(WarningKind, name="held aside"):
    """The sideways force on what hangs is not zero at the start."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        aside = [row for row in model.system.rows if row.if_needed and row.reaction == "sideways force"]
        still = [row for row in aside if isinstance(row.measure, Displacement) and row.measure.origin.body == GROUND]
        if not still:
            return
        largest = float(np.abs(forces(model.reference, model.start.geometry)).max(initial=0.0))
        for row in still:
            if abs(force := model.start.multiplier(row)) > _NOTHING * largest:
                told = Message(
                    "{body} is taken to go straight up and down, and at the start {force:.4g} N sideways would have to "
                    "keep it there, which no string does: write swings: true in {string}, or give it a guide",
                    body=row.ends[0],
                    force=abs(force),
                    string=row.connection,
                )
                yield self.warning(told, "connections", row.connection, about=frozenset((row.ends[0],)))
