"""The tree of a text that differs by a single number from one that has been read, without reading the rest again.

A plain scalar of the characters below ends only where something follows that is none of them, and nothing in it means
anything to YAML (1.2.2, section 7.3.3). So one in the place of another changes its own value, moves what stands behind
it, and leaves the rest as it was read. Anything else is read anew.
"""

from __future__ import annotations

import math
import re

from freebody.language.document.scalars import resolved
from freebody.language.document.tree import MAX_BYTES, MAX_LINE, DocumentNode, DocumentStep, Key

# a number with what may follow it in a model, a unit or a formula
_NUMBER = re.compile(r"[+-]?\.?[0-9][\w.+*/^()-]*(?: [\w.+*/^()-]+)*", re.ASCII)


def with_another_number(root: DocumentNode, before: str, after: str) -> DocumentNode | None:
    """The tree of the text `after`, where the tree of `before` is known; None where they differ by something else."""
    first, last = _difference(before, after)
    node = _value_at(root, first, last)
    if node is None or len(after) > MAX_BYTES:
        return None
    by = len(after) - len(before)
    text = after[node.start : node.end + by]
    if not (_NUMBER.fullmatch(before[node.start : node.end]) and _NUMBER.fullmatch(text)):
        return None
    line_start, line_end = after.rfind("\n", 0, node.start) + 1, after.find("\n", node.start)
    value = resolved(text)
    is_too_long = (len(after) if line_end < 0 else line_end) - line_start > MAX_LINE
    if is_too_long or (isinstance(value, float) and not math.isfinite(value)):
        return None
    return _Moved(node, by).node(root, DocumentNode(value, node.line, node.column, node.start, node.end + by))


def _difference(before: str, after: str) -> tuple[int, int]:
    """From where to where `before` differs."""
    most = min(len(before), len(after))
    first = next((k for k in range(most) if before[k] != after[k]), most)
    same = next((k for k in range(most - first) if before[-1 - k] != after[-1 - k]), most - first)
    return first, len(before) - same


def _value_at(root: DocumentNode, first: int, last: int) -> DocumentNode | None:
    """The value that is no list and no mapping and has all of a span of the text in it."""
    node = root
    while isinstance(node.content, dict | list):
        inner = [step.node for step in node.content.values()] if isinstance(node.content, dict) else node.content
        found = next((each for each in inner if each.start <= first and last <= each.end), None)
        if found is None:
            return None
        node = found
    return node


class _Moved:
    """A tree in which one value is another, and what stands behind it is moved by so many characters."""

    def __init__(self, old: DocumentNode, by: int) -> None:
        self.old, self.by = old, by

    def node(self, node: DocumentNode, new: DocumentNode) -> DocumentNode:
        """The tree of a value of the old one."""
        if node is self.old:
            return new
        content = node.content
        if isinstance(content, dict):
            content = {name: DocumentStep(self._key(s.key), self.node(s.node, new)) for name, s in content.items()}
        elif isinstance(content, list):
            content = [self.node(each, new) for each in content]
        column = self._column(node.line, node.column, node.start)
        return DocumentNode(content, node.line, column, self._index(node.start), self._index(node.end), node.is_block)

    def _key(self, key: Key | None) -> Key | None:
        return None if key is None else Key(key.line, self._column(key.line, key.column, key.end), self._index(key.end))

    def _index(self, index: int) -> int:
        return index + self.by if index >= self.old.end else index

    def _column(self, line: int, column: int, index: int) -> int:
        return column + self.by if line == self.old.line and index >= self.old.end else column
