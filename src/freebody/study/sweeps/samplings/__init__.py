"""Ways to choose cases, a file each, found by itself: the name of the file is the word before the colon, `FORM` how it
is written, and `make` makes a `Sampling` of what stands behind the colon."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.study.sweeps.ranges.base import Range
from freebody.study.sweeps.samplings.base import Sampling


def samplings() -> tuple[str, ...]:
    """The names of all; none is loaded."""
    return tuple(module.name for module in iter_modules(__path__) if module.name != "base")


def forms() -> str:
    """How each is written."""
    return ", ".join(import_module(f"{__name__}.{name}").FORM for name in samplings())


def sampling(text: str, ranges: Mapping[str, Range], seed: int) -> Sampling:
    """The cases that a text asks for: `sobol:4096`. seed: of what is drawn. Raises InputError."""
    word, _, rest = text.strip().partition(":")
    if word not in samplings():
        raise InputError(
            Message("{text}: there is no such choice of cases. One writes {forms}", text=text, forms=forms())
        )
    kind: Any = import_module(f"{__name__}.{word}")
    return kind.make(rest.strip(), ranges, seed)
