"""What a document says of itself: its sections, its title, the space of the model."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

from freebody.language.plain_text import plain
from freebody.language.sentences import Message
from freebody.model.noting import did_you_mean
from freebody.model.rotations import UNIT
from freebody.system.reading.source import Source, known_keys

SECTIONS = (
    "freebody",
    "title",
    "about",
    "source",
    "space",
    "parameters",
    "ground",
    "frames",
    "bodies",
    "connections",
    "loads",
    "measures",
    "states",
    "start",
    "questions",
    "drawing",
    "style",
)


def title(source: Source) -> str:
    """On one line; without one the name of the file."""
    stem = Path(source.file).stem if source.file else ""
    return plain(str(source.data.get("title") or stem)).strip() or "untitled"


def check_sections(source: Source) -> None:
    for key in source.data:
        if key not in SECTIONS:
            source.names.problem(
                Message("there is no section {key}.{hint}", key=key, hint=did_you_mean(key, SECTIONS)), key
            )
    version = source.data.get("freebody", 1)
    if version != 1:
        source.names.problem(
            Message("this is freebody's file format {version}; this version reads format 1", version=repr(version)),
            "freebody",
        )
    if not source.data.get("bodies"):
        source.names.problem(Message("a model needs at least one body, under bodies"), "bodies")


def read_space(source: Source) -> None:
    """`space: true`: three dimensions, y up; `space: {up: z}` for another vertical."""
    entry = source.data.get("space")
    names = source.names
    if isinstance(entry, dict):
        up = cast("dict[str, Any]", entry).get("up", "y")
        known_keys(names, cast("dict[str, Any]", entry), ("up",), "space", "space")
        if up not in ("x", "y", "z"):
            names.problem(Message("up is x, y or z"), "space", "up")
            up = "y"
        names.space, names.up = True, UNIT["xyz".index(up)]
    elif entry is True:
        names.space, names.up = True, UNIT[1]
    elif entry not in (None, False):
        names.problem(Message("space is true, or {{up: z}} for another vertical than y"), "space")
