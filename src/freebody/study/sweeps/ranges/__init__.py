"""Ways to vary, a file each, found by itself: `FORM` is how it is written, `read` makes a `Range` of it, or None."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.study.sweeps.ranges.base import Range, Read


def _kinds() -> Iterator[Any]:
    for module in iter_modules(__path__):
        if module.name != "base":
            yield import_module(f"{__name__}.{module.name}")


def read_range(name: str, text: str, read: Read) -> Range:
    """How a name varies. read: makes a number in SI of a text. Raises InputError saying what can be written."""
    for kind in _kinds():
        found = kind.read(text.strip(), read)
        if found is not None:
            return found
    forms = ", ".join(kind.FORM for kind in _kinds())
    raise InputError(
        Message("{name}={text}: cannot read how it varies. One writes {forms}", name=name, text=text, forms=forms)
    )
