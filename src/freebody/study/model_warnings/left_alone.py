"""A body that falls beside the rest: nothing holds it, nothing but weight pulls it, and nobody asks for it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from freebody.language.sentences import Message
from freebody.loads.gravity import Gravity
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_ASKED = ("measures", "questions", "start", "states")


class LeftAlone(WarningKind, name="left alone"):
    """A body that no connection and no load but weight is at, and that no measure, question or start names, does
    nothing in a model of several: a bob that was to be welded to its rod, a wheel without its axle. A body with a
    velocity of its own is thrown."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        rows = [*system.rows, *(rub_row for rub in system.brakes for rub_row in rub.rows)]
        held = {body for row in rows for body in row.measure.bodies()}
        pushed = {
            body
            for push in system.applied_loads
            if not isinstance(system.loads.get(push.load), Gravity)
            for body in push.measure.bodies()
        }
        data = system.document.data
        weights = {name for name, load in system.loads.items() if isinstance(load, Gravity)}
        named = {*_words({key: data.get(key) for key in ("connections", *_ASKED)}), *_words(list(model.asked))}
        loads: Any = data.get("loads")
        if isinstance(loads, dict):
            named |= {*_words({name: each for name, each in loads.items() if name not in weights})}
        able = [body for body in system.moving if body.name not in held | pushed | named and not body.start.moves]
        if len(system.moving) == 1:
            return
        for body in able:
            if body.name not in (data.get("bodies") or {}):
                continue  # a copy, whose name the reader made
            told = Message(
                "no connection holds {body} and no load but weight acts on it, so it falls by itself: join it to what "
                "it belongs to, e.g. by a pin, a weld or a string, or leave it out",
                body=body.name,
            )
            yield self.warning(told, "bodies", body.name, about=frozenset((body.name,)))


def _words(value: Any) -> list[str]:
    return re.findall(r"\w+", str(value))
