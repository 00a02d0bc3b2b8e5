"""Lists in place of names: each item gets the name that it gives, else the word for its kind.

connections: [{pin: [A, B]}]               connections: {pin: {pin: [A, B]}}
bodies: [{name: rod, type: rod, ...}]      bodies: {rod: {type: rod, ...}}
"""

from __future__ import annotations

from typing import Any, cast

from freebody.language.document.tree import Place
from freebody.language.expression import name_problem
from freebody.model.shapes.base import Shape
from freebody.system.reading.sections import SAYS_KIND
from freebody.system.reading.written.form import JOINED, SAYS_NAME, Entry, Written, section_of, takes_as
from freebody.system.reading.written.spelling import spell_entry


def name_items(w: Written, section: str) -> None:
    """A list of a section as the same with names, where all its entries can have some."""
    given = cast("list[Any]", w.data[section])
    spelt = [spell_entry(w, section, (section, k), each) for k, each in enumerate(given)]
    w.data[section] = with_names(w, section, (section,), spelt) or spelt


def with_names(w: Written, section: str, place: Place, entries: list[Any]) -> Entry | None:
    """Entries by names: those that they give, else the words for their kinds; None where one has neither."""
    items: list[tuple[str, Any]] = []
    for item in entries:
        if not isinstance(item, dict):
            return None
        named = _named_item(w, section, cast("Entry", item))
        if named is None and section not in JOINED:
            return None
        items.append(named or (section.removesuffix("s"), item))  # what it is is asked where it stands
    words = [name for name, _entry in items]
    names = [f"{name}_{words[: k + 1].count(name)}" if words.count(name) > 1 else name for k, name in enumerate(words)]
    if len({*names}) < len(names) or any(name_problem(name) for name in names if section != "start"):
        return None
    stood = [w.stood((*place, k)) for k in range(len(names))]
    for name, at, item, (word, entry) in zip(names, stood, entries, items, strict=True):
        w.moved[section, name] = (*at, word) if word in item and item[word] is entry else at
    return {name: entry for name, (_word, entry) in zip(names, items, strict=True)}


def _named_item(w: Written, section: str, item: Entry) -> tuple[str, Any] | None:
    """The name of an item of a list, and what it says of it."""
    said = next((key for key in SAYS_NAME if isinstance(item.get(key), str)), None)
    if said is not None:
        return item[said], {key: value for key, value in item.items() if key != said}
    if section in JOINED:
        kind = next((item[key] for key in SAYS_KIND if isinstance(item.get(key), str)), None)
        kind = kind or next((key for key, value in item.items() if section_of(w, section, key, value)), None)
        if kind is not None:
            return kind, item
    elif section == "bodies":
        word = next((k for k, v in item.items() if takes_as(k, v, Shape.kinds, space=w.space)), None)
        if word is not None and (len(item) > 1 or not _has_shape(w, item[word])):
            return word, item
    if len(item) != 1:
        return None
    ((name, value),) = item.items()
    return name, value


def _has_shape(w: Written, entry: Any) -> bool:
    fields = cast("Entry", entry) if isinstance(entry, dict) else {}
    return any(isinstance(v, dict) and takes_as(k, v, Shape.kinds, space=w.space) for k, v in fields.items())
