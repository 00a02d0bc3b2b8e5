"""An angle of many turns in radians, where degrees were meant: 60 rad for 60 deg."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from typing import Any

from freebody.language.sentences import Message
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_RADIANS = re.compile(r"\s*(?P<number>[-+]?(?:\d+(?:\.\d*)?|\.\d+))\s*rad\s*")
_SECTIONS = ("parameters", "ground", "frames", "bodies", "start", "connections", "loads")


class ManyTurns(WarningKind, name="many turns"):
    """An angle of more than a turn that is written in radians. Everything that is placed by it stands elsewhere."""

    explains = frozenset(("inside a wall", "out of reach", "locked rotation", "teeth apart"))

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        data = model.system.document.data
        for section in _SECTIONS:
            yield from self._in(data.get(section), (section,))

    def _in(self, value: Any, path: tuple[str | int, ...]) -> Iterator[ModelWarning]:
        if isinstance(value, Mapping):
            for key, inner in value.items():
                yield from self._in(inner, (*path, str(key)))
        elif isinstance(value, list):
            for k, inner in enumerate(value):
                yield from self._in(inner, (*path, k))
        elif isinstance(value, str) and (found := _RADIANS.fullmatch(value)) is not None:
            turns = abs(float(found["number"])) / math.tau
            if turns > 1.0:
                told = Message(
                    "{given} is {turns:.1f} turns. If degrees are meant, write {number} deg",
                    given=value.strip(),
                    turns=turns,
                    number=found["number"],
                )
                yield self.warning(told, *path)
