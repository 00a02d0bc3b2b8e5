"""The tree of a model file: every value with its key, its place, and the span of text it was read from.

The limits bound the work a text can cause; a model is far below all of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeAlias

from freebody.messages import Message

MAX_BYTES = 1_000_000
MAX_LINE = 10_000
MAX_VALUES = 50_000
MAX_DEPTH = 30
MAX_KEY = 1000

Place: TypeAlias = "tuple[str | int, ...]"
Scalar: TypeAlias = "str | int | float | bool | None"


@dataclass(frozen=True, slots=True)
class Key:
    """Where a key stands: line and column from 1, and the index after its last character."""

    line: int
    column: int
    end: int


@dataclass(frozen=True, slots=True)
class DocumentNode:
    """One value and the span of text, start to end, it was read from."""

    content: Scalar | list[DocumentNode] | dict[str, DocumentStep]
    line: int
    column: int
    start: int
    end: int
    is_block: bool = False

    @property
    def is_empty(self) -> bool:
        return self.start == self.end

    def plain(self) -> Any:
        if isinstance(self.content, dict):
            return {name: step.node.plain() for name, step in self.content.items()}
        if isinstance(self.content, list):
            return [node.plain() for node in self.content]
        return self.content


@dataclass(frozen=True, slots=True)
class DocumentStep:
    """A value together with its key; list items and the top have none."""

    key: Key | None
    node: DocumentNode


def kind_of(value: Any) -> Message:
    if isinstance(value, dict):
        return Message("a mapping")
    if isinstance(value, list):
        return Message("a list")
    if isinstance(value, str):
        return Message("a single text")
    return Message("the single value {value}", value=value)
