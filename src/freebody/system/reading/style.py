"""The section `style`: `{names: {T_left: S_1}, axes: [e_x, e_y], order: [m1, m2, g], decimal: comma}`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, Literal, cast

from freebody.language.sentences import Message
from freebody.model.style import HouseStyle
from freebody.system.reading.sections import OF_STYLES
from freebody.system.reading.source import Source, known_keys

_NAME = re.compile(r"[A-Za-z]\w*")
_DECIMALS: dict[str, Literal[".", ","]] = {"point": ".", "comma": ","}


def read_style(source: Source) -> HouseStyle:
    """Notes a problem for every name that cannot be one."""
    entry, names = source.data.get("style"), source.names
    if entry is None:
        return HouseStyle()
    if not isinstance(entry, dict):
        names.problem(Message("style is a mapping: {keys}", keys=", ".join(OF_STYLES)), "style")
        return HouseStyle()
    entry = cast("dict[str, Any]", entry)
    known_keys(names, entry, OF_STYLES, "style", "style")
    decimal = entry.get("decimal")
    if decimal is not None and decimal not in _DECIMALS:
        names.problem(Message("decimal is point or comma"), "style", "decimal")
    renamed: object = entry.get("names") or {}
    if not isinstance(renamed, dict):
        names.problem(Message("names is a mapping, e.g. names: {{T_left: S_1}}"), "style", "names")
        renamed = {}
    given = {str(k): str(v) for k, v in cast("dict[Any, Any]", renamed).items()}
    for name, wanted in given.items():
        if not _NAME.fullmatch(wanted) or wanted in names.parameters or wanted in names.measures:
            names.problem(
                Message("{wanted} cannot be the symbol for {name}: it is no name, or taken", wanted=wanted, name=name),
                *("style", "names", name),
            )
    axes, order = (tuple(_listed(source, entry, key)) for key in ("axes", "order"))
    n = 3 if names.space else 2
    if axes and len(axes) not in (n, 3):
        names.problem(Message("axes are the names of {n} unit vectors", n=n), "style", "axes")
    return HouseStyle(given, axes, order, _DECIMALS.get(str(decimal), ""))


def _listed(source: Source, entry: dict[str, Any], key: str) -> Iterator[str]:
    value: object = entry.get(key) or []
    if not isinstance(value, list):
        source.names.problem(Message("{key} is a list of names", key=key), "style", key)
        return
    for k, name in enumerate(cast("list[Any]", value)):
        if _NAME.fullmatch(str(name)):
            yield str(name)
        else:
            source.names.problem(Message("{name} is no name", name=str(name)), "style", key, k)
