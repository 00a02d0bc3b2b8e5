"""Things that stand for their text: what models in Python are written with, beside plain texts and numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

from freebody.language.expression import Call, Number, PowerOf, ProductOf, Sum, Symbol
from freebody.language.notation import to_python

_TREES = (Call, Number, PowerOf, ProductOf, Sum, Symbol)


@dataclass(frozen=True)
class Written:
    """A text that means something in a model: a point, a line, a phrase. text: as a file has it."""

    text: str

    def __str__(self) -> str:
        return self.text


def as_text(value: Any) -> Any:
    """A value as a file has it: expressions and written things become texts, also within lists and mappings."""
    if isinstance(value, Written):
        return value.text
    if isinstance(value, _TREES):
        return to_python(value)
    if isinstance(value, Mapping):
        return {as_text(k): as_text(v) for k, v in cast("Mapping[Any, Any]", value).items()}
    if isinstance(value, (list, tuple)):
        return [as_text(v) for v in cast("Sequence[Any]", value)]
    return value
