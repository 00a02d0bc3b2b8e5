"""YAML's complaints in plain language: what is wrong, at which place, and what to write instead.

A parser names what its grammar expected; a reader of the message wants to know which bracket, quote, colon or
indentation is meant. The last event before the fault tells where a run-on text began.
"""

from __future__ import annotations

import re
from typing import Any

from ruamel.yaml.error import YAMLError
from ruamel.yaml.events import ScalarEvent
from ruamel.yaml.reader import ReaderError

from freebody.errors import Problem
from freebody.messages import Message

_BARE_NAME = re.compile(r"\s*(?:- )?(\w+)\s+([{\[].*?)\s*(?:#.*)?$")  # an entry of a mapping without its colon
_EQUALS = re.compile(r"(\w+)\s*=\s*([^\s#].*?)\s*(?:#.*)?$")
_BRACKET_IN_KEY = re.compile(r"\w+\s+[{\[].*")
_SQUEEZED_KEY = re.compile(r"(\w+):([^\s:].*)")
_WIDE_SPACE = "\u00a0"
_BARE_TEXT = re.compile(r"(\w+)\s+(?:=\s*)?([^\s#].*?)\s*(?:#.*)?$")  # of such an entry, its value a text


def syntax_problem(error: YAMLError, text: str, last: Any) -> Problem:
    """YAML's own complaint, said for someone who does not know the words of its grammar."""
    if isinstance(error, ReaderError):
        found: Any = error
        before = text[: found.position]
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        code = ord(text[found.position]) if found.position < len(text) else 0
        return Problem(
            (), Message("the character U+{code:04X} is not allowed here; delete it", code=code), line, column
        )
    fault: Any = error
    mark = fault.problem_mark or fault.context_mark
    opened = fault.context_mark or mark
    says = str(fault.problem or "")
    context = str(fault.context or "")
    here = text[mark.index : mark.index + 1]

    def problem(message: Message, at: Any = mark) -> Problem:
        return Problem((), message, at.line + 1, at.column + 1)

    if "cannot start any token" in says:
        if here == "\t":
            return problem(Message("tab found; YAML allows spaces only"))
        return problem(Message("a text must not begin with {here}; put it in quotes", here=here))
    if "quoted scalar" in context and says.startswith("found unexpected"):
        return problem(Message("the quote that opens here is not closed"), opened)
    if "unknown escape" in says or "escape sequence" in says:
        return problem(Message("a backslash in double quotes; double it, or use single quotes"))
    if "flow sequence" in context or "flow mapping" in context:
        bracket = text[opened.index : opened.index + 1]
        return problem(
            Message(
                "the bracket {bracket} that opens here is not closed, or a comma is missing before line {line}, "
                "column {column}",
                bracket=bracket,
                line=mark.line + 1,
                column=mark.column + 1,
            ),
            opened,
        )
    if "expected the node content" in says:
        if here in ("]", "}"):
            return problem(
                Message("{here} closes a bracket that is not open, or a value is missing before it", here=here)
            )
        if not here:
            return problem(Message("the file ends where a value should stand; is a bracket not closed?"))
        return problem(Message("a value is missing before {here}", here=here))
    if "could not find expected ':'" in says:
        return _line_without_colon(text, opened)
    if "mapping values are not allowed" in says:
        return _colon_out_of_place(text, mark, last)
    if "mapping keys are not allowed" in says or "sequence entries are not allowed" in says:
        return problem(
            Message("'{here}' cannot stand here; begin a list on its own line, or put a text in quotes", here=here)
        )
    if "<block end>" in says:
        if bare := _BARE_NAME.match(text.split("\n")[int(mark.line)]):
            return problem(Message("a colon is missing after {name}: {name}: {rest}", name=bare[1], rest=bare[2]))
        if "<scalar>" in says or here in ",]}[{":
            return problem(Message("text after a closed quote or bracket; put the whole value in quotes"))
        return problem(Message("this line is indented like none of the lines above; align it with its neighbours"))
    if "tag" in says or "tag" in context:
        return problem(Message("tags ('!...') are not allowed; delete it, or put the text in quotes"), opened)
    if "anchor" in context or "alias" in context:
        return problem(Message("a text must not begin with & or *; put it in quotes"), opened)
    if "block scalar" in context:
        return problem(Message("after | or > the text begins on the next line, indented"))
    return problem(Message("cannot be read as YAML: {says}", says=says))


def _line_without_colon(text: str, mark: Any) -> Problem:
    line = text[mark.index :].split("\n", 1)[0].strip()
    squeezed = squeezed_colon(line)
    message = Message("a space is missing after the colon in '{squeezed}'", squeezed=squeezed)
    if equal := _EQUALS.match(line):
        message = Message("a colon is missing after {name}: {name}: {rest}", name=equal[1], rest=equal[2])
    elif not squeezed:
        message = Message(
            "'{line}' has no colon; write 'name: value', or indent it to continue the line above", line=line[:40]
        )
    return Problem((), message, mark.line + 1, mark.column + 1)


def _colon_out_of_place(text: str, mark: Any, last: Any) -> Problem:
    """`a: b: c`; or a text that ran on over line ends until a colon stopped it."""
    start = last.start_mark
    first_line = text[start.index :].split("\n", 1)[0]
    if not isinstance(last, ScalarEvent) or start.line == mark.line:
        message = Message("a second colon in one line; put the value in quotes, or begin a new line")
        return Problem((), message, mark.line + 1, mark.column + 1)
    squeezed = squeezed_colon(first_line)
    if squeezed:
        message = Message("a space is missing after the colon in '{squeezed}'", squeezed=squeezed)
        return Problem((), message, start.line + 1, start.column + 1)
    begun = _BARE_TEXT.match(first_line)
    if begun and start.column == len(stopped := text.split("\n")[int(mark.line)]) - len(stopped.lstrip()):
        message = Message("a colon is missing after {name}: {name}: {rest}", name=begun[1], rest=begun[2])
        return Problem((), message, start.line + 1, start.column + 1)
    message = Message(
        "this line is indented as if it continued line {line}; align it with its neighbours", line=start.line + 1
    )
    return Problem((), message, mark.line + 1, 1)


def squeezed_colon(text: str) -> str:
    found = re.match(r"[^\s:#'\"\[\]{},]+:[^\s:]+", text)
    return found[0] if found else ""


def key_problem(key: str, is_empty: bool, line: str) -> Message | None:
    """What is wrong with a key that has swallowed what stands beside it: its value, its colon, or the space before.
    line: the text from the key to the end of its line."""
    if key[0] == _WIDE_SPACE:
        return Message("a non-breaking space begins this line; YAML allows plain spaces only")
    if is_empty and (squeezed := _SQUEEZED_KEY.fullmatch(key)):
        return Message("a space belongs behind the colon: {name}: {value}", name=squeezed[1], value=squeezed[2])
    bare = _BARE_NAME.match(line) if _BRACKET_IN_KEY.fullmatch(key) else _EQUALS.fullmatch(key) if is_empty else None
    if bare is None:
        return None
    return Message("a colon is missing after {name}: {name}: {rest}", name=bare[1], rest=bare[2])
