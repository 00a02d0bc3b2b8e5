"""The document: what it says, where each value stands, and the text with one value changed.

Each value keeps the span of text it came from, so a change replaces that span only, and every other
character, comments included, stays as it was. The changed text is read again and must say what was meant.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from freebody.errors import InputError, ModelError, Problem
from freebody.language.document.file import text_of
from freebody.language.document.numbers import with_another_number
from freebody.language.document.plain import checked, copied, is_ordinary, with_value, without_value
from freebody.language.document.tree import MAX_BYTES, DocumentNode, DocumentStep, Place, kind_of
from freebody.language.document.writer import block_lines, flow_text, scalar_text
from freebody.messages import Message


def _composed(text: str, file: str | None) -> DocumentNode:
    from freebody.language.document.composer import compose  # who has no text to read needs no reader of YAML

    return compose(text, file)


class Document:
    """One model file: its plain data, the place of every value, and its text. Immutable.

    Made by `read`, `load` or `from_plain`; each raises ModelError with every problem found.
    """

    __slots__ = ("_composed", "_has_places", "_plain", "_stood", "_text", "file", "folders")

    def __init__(
        self,
        text: str,
        file: str | None,
        root: DocumentNode | None,
        has_places: bool,
        plain: Any = None,
        folders: Sequence[Path] | None = None,
        stood: tuple[Document, Mapping[Place, Place]] | None = None,
    ) -> None:
        """Without a root it is known what the text says (`plain`), and it is read when places in it are needed.
        folders: where the files are that it names, that of the document unless it is said. stood: the document that
        somebody wrote, and where in it stands what has another place in this one."""
        self._text = text
        self._composed = root
        self._plain = plain
        self._has_places = has_places
        self._stood = stood
        self.file = file
        own = () if file is None else (Path(file).parent,)
        self.folders = own if folders is None else tuple(folders)

    # -- making -------------------------------------------------------------------------------
    @classmethod
    def read(cls, text: str, file: str | None = None, folders: Sequence[Path] | None = None) -> Document:
        """Reads YAML text; `file` is the name used in messages, and files beside it are looked for in `folders`."""
        return cls(text, file, _composed(text, file), True, folders=folders)

    def reread(self, text: str) -> Document:
        """The document of another text, as `read` makes it."""
        return Document(text, self.file, self._root_of(text), True, folders=self.folders)

    def _root_of(self, text: str) -> DocumentNode:
        """The tree of another text. Where that differs by one number, as it does while a value is being moved, the rest
        is not read again. Raises ModelError."""
        return with_another_number(self._root, self._text, text) or _composed(text, self.file)

    @classmethod
    def load(cls, path: str | Path) -> Document:
        """Reads a YAML file in UTF-8 of at most 1 MB."""
        return cls.read(text_of(Path(path)), str(path))

    @classmethod
    def from_plain(cls, data: Mapping[Any, Any]) -> Document:
        """A new document of plain data (mappings, lists, texts, finite numbers, true, false, None)."""
        plain = checked(data, ())
        text = "\n".join(block_lines(plain, 0)) + "\n" if plain else "{}\n"
        if len(text) <= MAX_BYTES and is_ordinary(plain):  # read back, it says the same
            return cls(text, None, None, False, plain)
        try:
            return cls(text, None, _composed(text, None), False)
        except ModelError as error:
            raise ModelError([Problem(p.path, p.message) for p in error.problems]) from None

    def rewritten(self, data: Mapping[Any, Any], moved: Mapping[Place, Place]) -> Document:
        """The document of the same model in another form. moved: where in this one stands what has another place there;
        so problems are told where somebody wrote what they are about."""
        new = Document.from_plain(data)
        return Document(new._text, self.file, new._composed, False, new._plain, self.folders, (self, moved))

    @property
    def _root(self) -> DocumentNode:
        if self._composed is None:
            self._composed = _composed(self._text, None)
        return self._composed

    # -- asking -------------------------------------------------------------------------------
    @property
    def data(self) -> dict[str, Any]:
        """Plain Python data, made anew on each call; an empty value is None."""
        return self._root.plain() if self._plain is None else copied(self._plain)

    def place(self, path: Place) -> tuple[int, int] | None:
        """Line and column, from 1, of the value at `path`, or of its deepest parent that exists.

        The key stands for a value that is empty or starts on a later line. None for a document made from
        plain data, whose text nobody has seen.
        """
        if self._stood is not None:
            return self._stood[0].place(self._where_it_stood(path))
        if not self._has_places:
            return None
        steps = self._walk(path)
        last = steps[-1]
        if last.key is not None and (last.node.is_empty or last.node.line != last.key.line):
            return last.key.line, last.key.column
        return last.node.line, last.node.column

    def _where_it_stood(self, path: Place) -> Place:
        """The place in the document that somebody wrote of what has a place in this one."""
        moved = {} if self._stood is None else self._stood[1]
        n = next((n for n in range(len(path), 0, -1) if path[:n] in moved), 0)
        return (*moved[path[:n]], *path[n:]) if n else path

    def span(self, path: Place) -> tuple[int, int] | None:
        """The indices in the text between which the value at `path` stands; None where there is no such value."""
        if self._stood is not None:
            return self._stood[0].span(self._where_it_stood(path))
        steps = self._walk(path)
        return (steps[-1].node.start, steps[-1].node.end) if len(steps) == len(path) + 1 else None

    def key_span(self, path: Place) -> tuple[int, int] | None:
        """The same for its key, which items of a list do not have."""
        if self._stood is not None:
            return self._stood[0].key_span(self._where_it_stood(path))
        steps = self._walk(path)
        key = steps[-1].key
        if key is None or len(steps) != len(path) + 1:
            return None
        return self._text.rfind("\n", 0, key.end) + key.column, key.end

    def locate(self, problem: Problem) -> Problem:
        """The problem with its line and column, where they are known."""
        place = self.place(problem.path)
        if place is None or problem.line is not None:
            return problem
        return replace(problem, line=place[0], column=place[1])

    def dumps(self) -> str:
        """The text, exactly as read but for the values replaced since."""
        return self._text

    # -- changing -----------------------------------------------------------------------------
    def with_value(self, path: Place, value: Any) -> Document:
        """A new document with the value at `path` replaced, or added as a new key; missing parents are made.

        Comments inside a replaced list or mapping go with it; all others stay. Raises InputError where `path`
        leads through something that is not a mapping, or the text cannot be changed in place.
        """
        if not path:
            raise InputError(Message("name the value to change, e.g. ('parameters', 'm')"))
        value = checked(value, path)
        new: Any = value
        steps = self._walk(path)
        missing = path[len(steps) - 1 :]
        last = steps[-1]
        for part in reversed(missing[1:]):
            parent: dict[str, Any] = {str(part): new}
            new = parent
        if not missing:
            text = self._replaced(last, new)
        elif isinstance(last.node.content, dict) and last.node.content:
            text = self._added(last.node, last.node.content, str(missing[0]), new)
        elif last.node.content is None or last.node.content == {}:
            text = self._replaced(last, {str(missing[0]): new})
        else:
            raise InputError(
                Message(
                    "{path} cannot be set: {part} is {kind} without {missing}",
                    path=_dotted(path),
                    part=_dotted(path[: len(steps) - 1]),
                    kind=kind_of(last.node.plain()),
                    missing=missing[0],
                )
            )
        return self._verified(text, path, with_value(self.data, path, value))

    def with_item(self, path: Place, value: Any) -> Document:
        """A new document with one more value at the end of the list at `path`, which is made where there is none.
        Raises InputError where something else stands there, or the text cannot be changed in place."""
        value = checked(value, path)
        steps = self._walk(path)
        node = steps[-1].node
        if len(steps) != len(path) + 1 or not node.content:
            return self.with_value(path, [value])
        if not isinstance(node.content, list):
            raise InputError(Message("{path} is no list", path=_dotted(path)))
        last = node.content[-1]
        if node.is_block:
            text = self._line_after(last.end, " " * (node.column - 1) + f"- {flow_text(value)}")
        else:
            text = self._spliced(last.end, last.end, f", {flow_text(value)}")
        return self._verified(text, path, with_value(self.data, path, [*node.plain(), value]))

    def without(self, path: Place) -> Document:
        """A new document without the key at `path`, and the comment at the end of its line; a mapping that would be
        left without a key goes too. Raises InputError where there is no such key, or the text cannot be changed in
        place."""
        steps = self._walk(path)
        key, node = steps[-1].key, steps[-1].node
        if key is None or len(steps) != len(path) + 1:
            raise InputError(Message("there is no {path} to take out", path=_dotted(path)))
        parent = steps[-2].node
        if isinstance(parent.content, dict) and len(parent.content) == 1 and len(path) > 1:
            return self.without(path[:-1])
        start = self._text.rfind("\n", 0, key.end) + key.column
        end = max(node.end, key.end)
        if parent.is_block or self._text[parent.start : parent.start + 1] != "{":
            # whole lines: of the key, of all its value, and what stands beside its end
            start = self._text.rfind("\n", 0, start) + 1
            line_end = self._text.find("\n", end)
            end = len(self._text) if line_end < 0 else line_end + 1
        else:
            after = re.compile(r"\s*:?\s*,\s*").match(self._text, end)
            before = re.compile(r",\s*$").search(self._text[:start])
            if after is not None:
                end = after.end()
            elif before is not None:
                start = before.start()
        return self._verified(self._spliced(start, end, ""), path, without_value(self.data, path))

    def _verified(self, text: str, path: Place, expected: Any) -> Document:
        """The changed text read again; it must say what is expected: the old data with the one value changed."""
        try:
            changed = Document(text, self.file, self._root_of(text), self._has_places, folders=self.folders)
        except ModelError:
            changed = None
        if changed is None or repr(changed.data) != repr(expected):
            raise InputError(
                Message(
                    "{path} cannot be changed in place; write it as 'name: value' on its own line first",
                    path=_dotted(path),
                )
            )
        return changed

    def _walk(self, path: Place) -> list[DocumentStep]:
        """The steps from the top along `path`, as far as it exists."""
        steps = [DocumentStep(None, self._root)]
        for part in path:
            content = steps[-1].node.content
            if isinstance(content, dict) and str(part) in content:
                steps.append(content[str(part)])
            elif isinstance(content, list) and isinstance(part, int) and 0 <= part < len(content):
                steps.append(DocumentStep(None, content[part]))
            else:
                break
        return steps

    def _replaced(self, step: DocumentStep, value: Any) -> str:
        key, node = step.key, step.node
        new = flow_text(value)
        if node.is_empty:
            has_colon = key is None or node.start > key.end
            return self._spliced(node.start, node.start, f" {new}" if has_colon else f": {new}")
        start = node.start
        if node.is_block and key is not None:
            # A block collection moves up to its key's line, unless a comment stands between the two.
            if re.fullmatch(r":[ ]*\r?\n\s*", self._text[key.end : start]):
                start, new = key.end, f": {new}"
            elif node.column <= key.column:
                new = f"  {new}"
        elif self._text[start - 1 : start] == ":":
            new = f" {new}"
        return self._spliced(start, node.end, new)

    def _added(self, node: DocumentNode, entries: dict[str, DocumentStep], name: str, value: Any) -> str:
        entry = f"{scalar_text(name, flow=True)}: {flow_text(value)}"
        last = next(reversed(entries.values()))
        end = last.node.end
        if not node.is_block and self._text[node.start] != "{":
            # `[a: b]` is a list of one mapping without braces, which can take no second key.
            return self._spliced(node.start, node.end, flow_text({**node.plain(), name: value}))
        if not node.is_block:
            return self._spliced(end, end, f", {entry}")
        return self._line_after(end, " " * (node.column - 1) + entry)

    def _line_after(self, end: int, line: str) -> str:
        """With a line after the one in which something ends, so that a comment beside it stays with it."""
        line_end = re.compile(r"\r?\n|\Z").search(self._text, end)
        at = len(self._text) if line_end is None else line_end.start()
        newline = "\r\n" if "\r\n" in self._text else "\n"
        return self._spliced(at, at, newline + line)

    def _spliced(self, start: int, end: int, new: str) -> str:
        return self._text[:start] + new + self._text[end:]


def _dotted(path: Place) -> str:
    return ".".join(str(part) for part in path) or "the top level"
