"""What is recorded of a motion, a file each, found by itself: `FORM` is how it is written, `read` makes a `Record` of
it, or None."""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.model.noting import did_you_mean
from freebody.study.simulation.recorded import series_units
from freebody.study.sweeps.records.base import Record
from freebody.system.system import System


def read_record(system: System, text: str) -> Record:
    """What a text asks of a motion. Raises InputError saying what one can ask for."""
    kinds: list[Any] = [import_module(f"{__name__}.{m.name}") for m in iter_modules(__path__) if m.name != "base"]
    units = series_units(system)
    for kind in kinds:
        found = kind.read(" ".join(text.split()), units)
        if found is not None:
            return found
    last = text.rsplit(maxsplit=1)[-1] if text.split() else ""
    raise InputError(
        Message(
            "'{text}' cannot be recorded. One writes {forms}, where X is a series of the motion.{hint}",
            text=text,
            forms=", ".join(kind.FORM for kind in kinds),
            hint=did_you_mean(last, units),
        )
    )
