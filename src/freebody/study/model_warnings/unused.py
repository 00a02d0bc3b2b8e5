"""A parameter that nothing uses: a friction coefficient that no contact has, a misspelt name."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from freebody.language.sentences import Message
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_NAME = re.compile(r"[^\W\d]\w*")
_PROSE = ("title", "about", "source")


class Unused(WarningKind, name="unused"):
    """A parameter whose name stands nowhere else in the file, questions and options included, and in no question beside
    it."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        data = model.system.document.data
        given: Any = data.get("parameters")
        if not isinstance(given, Mapping):
            return
        used = set(_names({key: value for key, value in data.items() if key not in (*_PROSE, "parameters")}))
        used |= {name for value in given.values() for name in _names(value)}
        used |= {*_names(list(model.asked))}
        for name in map(str, given):
            if name not in used:
                told = Message("{name} is used nowhere in the model: leave it out, or use it", name=name)
                yield self.warning(told, "parameters", name, about=frozenset((name,)))


def _names(value: Any) -> Iterator[str]:
    """All names in the texts and keys of a part of a file."""
    if isinstance(value, Mapping):
        for key, inner in value.items():
            yield str(key)
            yield from _names(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _names(inner)
    elif isinstance(value, str):
        yield from _NAME.findall(value)
