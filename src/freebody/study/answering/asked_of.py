"""What texts ask for, and the system of which they do: with other values of parameters, or with something cut.

What is cut transmits no impulse in the instant in which it is: the motion goes on from the pose and with the velocities
of the start of the whole system. So what is asked of the other system counts from there, if its file says without what
is cut where everything stands.
"""

from __future__ import annotations

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message, listed
from freebody.numeric.reference import Reference
from freebody.questions.reading import Question
from freebody.study.answering.draws import draws
from freebody.system.system import System
from freebody.tolerances import TOUCHES


def asked_of(system: System, *texts: str) -> tuple[System, tuple[Question, ...]]:
    """Raises ModelError if a text cannot be read, InputError where only what is cut tells how the system starts."""
    own, asked = system.asked_with(*texts)
    gone = [name for name in (*system.connections, *system.loads) if name not in {*own.connections, *own.loads}]
    if gone:
        _check_start(system, own, gone)
    return own, asked


def _check_start(system: System, own: System, gone: list[str]) -> None:
    values = draws(system, 1)[0].values
    whole, cut = (Reference(of, {name: values[name] for name in of.parameters}) for of in (system, own))
    before, after = whole.assemble(), cut.assemble()
    rates = whole.velocities(before), cut.velocities(after)
    size = whole.sizes.length
    moved = [
        body.name
        for body in own.moving
        if any(
            float(np.abs(one[[*whole.columns(body.name)]] - other[[*cut.columns(body.name)]]).max()) > TOUCHES * size
            for one, other in ((before, after), rates)
        )
    ]
    if moved:
        raise InputError(
            Message(
                "without {gone} the file does not say how {bodies} starts: give its place (at, angle), or start values",
                gone=listed(gone),
                bodies=listed(moved),
            )
        )
