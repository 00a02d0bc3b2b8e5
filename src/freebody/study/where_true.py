"""Where the model is true, in numbers: what loads and connections take for granted of where the bodies are."""

from __future__ import annotations

from collections.abc import Iterable

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.model.elements import Validity
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.system.system import System
from freebody.tolerances import TOUCHES


def end_and_size(validity: Validity, reference: Reference) -> tuple[float, float]:
    """The value [SI] beyond which it is left, since what touches the limit has not left it, and the size of what is
    measured."""
    limit = reference.number(validity.limit)
    size = max(abs(limit), reference.sizes.length if validity.measure.dimension == LENGTH else 1.0)
    return limit - validity.sign * TOUCHES * size, size


def is_left(validity: Validity, reference: Reference, value: float) -> bool:
    """Whether it is left at a value [SI] of what is measured."""
    end, _size = end_and_size(validity, reference)
    return validity.sign * (value - end) < 0.0


def left_at(system: System, reference: Reference, here: Snapshot) -> Validity | None:
    """What the model takes for granted that is not so at an instant; None where it is true."""
    return next((v for v in system.validities if is_left(v, reference, float(here.value(v.measure)))), None)


def insist_on_truth(system: System, reference: Reference, way: Iterable[Snapshot]) -> None:
    """Raises CannotAnswer where the model is not true on the way to what is asked about."""
    for here in way if system.validities else ():
        if (left := left_at(system, reference, here)) is not None:
            raise is_no_longer(left.purpose)


def is_no_longer(purpose: str) -> CannotAnswer:
    """That a motion has gone on to where the model is not true."""
    return CannotAnswer(
        Message("before that it is no longer so that {purpose}, and the model is not true beyond", purpose=purpose)
    )
