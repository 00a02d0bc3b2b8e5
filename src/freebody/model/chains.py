"""Reads chains of rotations: `turned: [psi about y, -beta about z]`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, cast

from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.measures.geometry import ONE, ZERO, Components
from freebody.model.elements import Rotation

if TYPE_CHECKING:
    from freebody.model.names import Names

_ITEM = re.compile(r"^(?P<by>.+?) about (?P<axis>.+)$")
_NAME = re.compile(r"[A-Za-z_]\w*")


def read_chain(names: Names, value: Any, *path: str | int, named: bool) -> tuple[Rotation, ...]:
    """The rotations of a chain, each about an axis of what was turned so far: x, y, z, -x ... or components. An angle
    is an expression in parameters, or, where `named`, a new name, which becomes a measure."""
    items = cast("list[Any]", value) if isinstance(value, list) else [value]
    chain: list[Rotation] = []
    for k, item in enumerate(items):
        where = (*path, k) if isinstance(value, list) else path
        turn = _read(names, item, where, named=named)
        if turn is not None:
            chain.append(turn)
    again = {turn.name for turn in chain if turn.name and sum(turn.name == other.name for other in chain) > 1}
    for name in sorted(again):
        names.problem(Message("{name} is named twice in one chain of rotations", name=name), *path)
    return tuple(chain)


def _read(names: Names, item: Any, path: tuple[str | int, ...], *, named: bool) -> Rotation | None:
    found = _ITEM.match(item.strip()) if isinstance(item, str) else None
    if found is None:
        names.problem(
            Message("a rotation is an angle about an axis, e.g. 30 deg about z, found {item}", item=repr(item)),
            *path,
        )
        return None
    axis = _axis(names, found["axis"].strip(), path)
    text = found["by"].strip()
    if named and _NAME.fullmatch(text) and text != "pi" and text not in names.parameters and text not in names.broken:
        return Rotation(axis, Symbol(text), text)
    return Rotation(axis, names.angle(text, *path))


def _axis(names: Names, text: str, path: tuple[str | int, ...]) -> Components:
    if text.startswith("[") and text.endswith("]"):
        parts: list[Any] = [part.strip() for part in text[1:-1].split(",")]
        return names.direction(parts, *path).components
    compass = names.compass
    if text not in compass:
        names.problem(
            Message("{text} is no axis to turn about; write x, y, z, -x, -y, -z or [a, b, c]", text=text), *path
        )
        return (ZERO, ZERO, ONE)
    return compass[text].components
