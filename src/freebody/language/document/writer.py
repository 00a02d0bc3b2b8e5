"""From plain data to YAML text that is read back as the same data.

One entry a line; what is flat and short stands in brackets; a text is quoted only where YAML would read the
bare words as something else. Source: YAML 1.2.2, sections 7.3 and 7.4.
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.language.document.scalars import resolved
from freebody.language.document.tree import MAX_LINE, Scalar

WIDTH = 100


def block_lines(value: dict[str, Any] | list[Any], indent: int) -> list[str]:
    """The lines of a collection, one entry a line; what is flat and short stands in brackets."""
    pad = " " * indent
    if isinstance(value, dict):
        entries = [(f"{pad}{scalar_text(k, flow=True)}:", v) for k, v in value.items()]
    else:
        entries = [(f"{pad}-", v) for v in value]
    lines: list[str] = []
    for head, item in entries:
        if item is None:
            lines.append(head)
        elif _is_literal(item):
            text_lines = item.removesuffix("\n").split("\n")
            lines.append(f"{head} |" if item.endswith("\n") else f"{head} |-")
            lines += [f"{pad}  {line}" if line else "" for line in text_lines]
        elif not _is_collection(item):
            lines.append(f"{head} {scalar_text(item, flow=False)}")
        elif _is_flat(item) and len(flow := flow_text(item)) + len(head) < WIDTH:
            lines.append(f"{head} {flow}")
        else:
            inner = block_lines(item, indent + 2)
            if isinstance(value, dict):
                lines.append(head)
            else:
                inner[0] = f"{head} {inner[0].lstrip()}"
            lines += inner
    return lines


def _is_collection(value: Any) -> bool:
    return isinstance(value, (dict, list))


def _is_flat(value: dict[str, Any] | list[Any]) -> bool:
    """Whether it holds scalars, or a mapping's lists of scalars."""
    if isinstance(value, list):
        return not any(_is_collection(v) for v in value)
    return all(not _is_collection(v) or (_is_list(v) and _is_flat(v)) for v in value.values())


def _is_list(value: Any) -> bool:
    return isinstance(value, list)


def _is_literal(text: Any) -> bool:
    """Whether `|` gives the text back: printable, the first line not indented, at most one newline last."""
    if not isinstance(text, str):
        return False
    lines = text.removesuffix("\n").split("\n")
    return (
        "\n" in text
        and all(line.isprintable() and len(line) < MAX_LINE // 2 for line in lines)
        and bool(lines[0].strip() and lines[-1].strip())
        and not lines[0].startswith(" ")
        and all(line.strip() or not line for line in lines)
    )


def flow_text(value: Any) -> str:
    """A value in one line: `[a, b]`, `{a: 1, b}`, or a scalar that may stand in brackets."""
    if isinstance(value, dict):
        entries = cast("dict[str, Any]", value).items()
        pairs = [(scalar_text(k, flow=True), v) for k, v in entries]
        return "{" + ", ".join(k if v is None else f"{k}: {flow_text(v)}" for k, v in pairs) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(flow_text(v) for v in cast("list[Any]", value)) + "]"
    return scalar_text(value, flow=True)


def scalar_text(value: Scalar, flow: bool) -> str:
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    return _quoted(value) if _needs_quotes(value, flow) else value


def _needs_quotes(text: str, flow: bool) -> bool:
    """Whether YAML would read the bare text as something else. Source: YAML 1.2.2, section 7.3.3."""
    return (
        not isinstance(resolved(text), str)
        or text != text.strip()
        or not text.isprintable()
        or text[0] in "?:,[]{}#&*!|>'\"%@`"
        or text.startswith(("---", "..."))
        or text == "-"
        or text.startswith("- ")
        or ": " in text
        or text.endswith(":")
        or " #" in text
        or (flow and re.search(r"[,\[\]{}?:]", text) is not None)
    )


def _quoted(text: str) -> str:
    named = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t"}

    def escaped(char: str) -> str:
        if char in named:
            return named[char]
        if char.isprintable():
            return char
        return f"\\u{ord(char):04x}" if ord(char) < 0x10000 else f"\\U{ord(char):08x}"

    return '"' + "".join(escaped(char) for char in text) + '"'
