"""What a document says of itself: its sections, its title, the space of the model."""

from __future__ import annotations

from difflib import get_close_matches
from pathlib import Path
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.document.writer import flow_text
from freebody.language.folded import folded
from freebody.language.plain_text import plain
from freebody.language.sentences import Message, as_found
from freebody.loads.base import Load
from freebody.model.noting import did_you_mean
from freebody.model.rotations import UNIT
from freebody.model.shapes.base import Shape
from freebody.model.written_kinds import words_also
from freebody.system.reading.sections import MEANT_SECTIONS, OF_GROUND, SECTIONS
from freebody.system.reading.source import Source, known_keys
from freebody.system.reading.vocabulary import SHORT_FORMS

_OF_BODIES = ("mass", "m", "Masse")  # and of nothing else
_UNITS = ("units", "unit", "einheiten", "einheit")


def title(source: Source) -> str:
    """On one line; without one the name of the file."""
    stem = Path(source.file).stem if source.file else ""
    return plain(str(source.data.get("title") or stem)).strip() or "untitled"


def check_sections(source: Source) -> None:
    """Notes sections that there are not. One that is misspelt is read as the one that is meant."""
    empty = ""
    for key, value in list(source.data.items()):
        if key in SECTIONS:
            empty = key if value is None else ""
            continue
        told = source.refused.get(key) or _not_indented(source, key, value) or _no_section(key, value, empty)
        source.names.problem(told, key)
        meant = _meant(key)
        if meant and key not in MEANT_SECTIONS and meant not in source.data:
            source.data[meant] = value
        else:
            source.names.is_cut_short = True
    version = source.data.get("freebody", 1)
    if version != 1:
        source.names.problem(
            Message("this is freebody's file format {version}; this version reads format 1", version=as_found(version)),
            "freebody",
        )
    if not source.data.get("bodies") and not source.names.is_cut_short:
        source.names.problem(
            Message(
                "a model needs at least one body, under bodies, as bodies: {{block: {{particle: {{mass: 1 kg}}}}}}"
            ),
            "bodies",
        )
        source.names.is_cut_short = True  # what names bodies has no other mistake


def _not_indented(source: Source, key: str, value: Any) -> Message | None:
    """What is told of an entry of a section above it that is not indented: it says a kind of that section."""
    fields = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
    kinds = {"bodies": Shape.kinds, "connections": Connection.kinds, "loads": Load.kinds}
    above = [section for section in source.data if section in SECTIONS]
    found = [at for at in above if at in kinds and len(fields) == 1 and fields.keys() <= kinds[at].keys()]
    if not found or not isinstance(source.data[found[-1]], dict | None):
        return None
    return Message(
        "{key} is not indented, so that it is no part of {section}: begin its line with two spaces",
        key=key,
        section=found[-1],
    )


def _no_section(key: str, value: Any, empty: str = "") -> Message:
    """Who writes `gravity: g` as a section has a kind in mind, which stands in one. empty: the section above it, if
    nothing stands in that."""
    for section, kinds in (("loads", Load.kinds), ("connections", Connection.kinds)):
        if key in kinds:
            entry = flow_text({f"my_{key}": {key: value}})
            return Message(
                "{key} belongs under {section}, with a name of its own: {entry}", key=key, section=section, entry=entry
            )
    if folded(key) in _UNITS:
        return Message(
            "each number has its own unit, as 1500 mm or 10 kg; one without is in SI units: leave {key} out", key=key
        )
    if key in OF_GROUND:
        return Message(
            "{key} stand under ground or under a body: {entry}", key=key, entry=flow_text({"ground": {key: value}})
        )
    if key == "nodes":
        return Message(
            "{key} are points of the ground or of a body: {entry}",
            key=key,
            entry=flow_text({"ground": {"points": value}}),
        )
    if _meant(key) is None and _is_body(key, value) and empty != "bodies":
        entry = flow_text({"bodies": {key: value}})
        return Message("{key} is a body, which stands under bodies: {entry}", key=key, entry=entry)
    if empty in SECTIONS and _meant(key) is None:
        return Message(
            "{key} is not indented, so that {section} is empty: begin the line of {key} with two spaces",
            key=key,
            section=empty,
        )
    meant = _meant(key)
    if meant is None and isinstance(value, dict):
        return Message(
            "there is no section and no short form {key}: short forms are {forms}; anything else is written with "
            "bodies, connections and loads",
            key=key,
            forms=", ".join(SHORT_FORMS),
        )
    hint = Message(" Did you mean {x}?", x=meant) if meant else did_you_mean("", SECTIONS)
    return Message("there is no section {key}.{hint}", key=key, hint=hint)


def _is_body(key: str, value: Any) -> bool:
    """Whether a section says what bodies say: a shape with its fields, or a mass."""
    fields = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
    words = words_also(Shape.kinds)
    said = [word for word, each in fields.items() if isinstance(each, dict | None) or word in _OF_BODIES]
    said += [folded(key)] if fields else []
    return any(word in Shape.kinds or word in words or word in _OF_BODIES for word in said)


def _meant(key: str) -> str | None:
    """The section that is meant by another name."""
    known = (*SECTIONS, *MEANT_SECTIONS)
    if key in OF_GROUND:
        return None
    near = key if key in MEANT_SECTIONS else next(iter(get_close_matches(key, known, n=1, cutoff=0.7)), None)
    return None if near is None else MEANT_SECTIONS.get(near, near)


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
