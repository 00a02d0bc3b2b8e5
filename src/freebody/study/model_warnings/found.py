"""All warnings about a model: one for each cause."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache

import numpy as np

from freebody.errors import FreebodyError
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind
from freebody.system.system import System

_MOST_BODIES = 200  # whose places are looked at
_UNTOLD = (FreebodyError, ArithmeticError, ValueError, np.linalg.LinAlgError)


@lru_cache(maxsize=8)
def warnings_of(system: System, asked: tuple[str, ...] = ()) -> tuple[ModelWarning, ...]:
    """In the order of the file, without those that follow from others. asked: what is said of the model beside its
    file, as a question on the command line."""
    if len(system.bodies) > _MOST_BODIES:
        return ()
    model, found = Opened(system, asked), list[ModelWarning]()
    for kind in sorted(WarningKind.kinds, key=lambda kind: kind.name):
        with suppress(*_UNTOLD):  # a model that cannot be opened has its own message
            found.extend(kind().look(model))
    placed = [replace(w, problem=system.document.locate(w.problem)) for w in _without_echoes(found)]
    return tuple(sorted(placed, key=lambda w: (w.problem.line or 0, w.problem.column or 0, w.kind)))


def _without_echoes(found: Sequence[ModelWarning]) -> list[ModelWarning]:
    explains = {kind.name: kind.explains for kind in WarningKind.kinds}

    def is_echo(warning: ModelWarning) -> bool:
        return any(
            warning.kind in explains[other.kind] and (not other.about or bool(other.about & warning.about))
            for other in found
        )

    return [warning for warning in found if not is_echo(warning)]
