"""Data of a document while it is put in order, and what words of it stand for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple, NoReturn, cast

from freebody.connections.base import Connection
from freebody.errors import ModelError, Problem
from freebody.language.document.tree import Place
from freebody.language.sentences import Message
from freebody.loads.base import Load
from freebody.model.shapes.base import Shape
from freebody.model.spec import MEANT, SAME, Spec
from freebody.model.written_kinds import takes, written_kind
from freebody.system.reading.sections import CLOSES, PLANAR_OPTIONS, SPATIAL_OPTIONS

Kinds = Mapping[str, type[Spec]]
Entry = dict[str, Any]

SAYS_NAME = ("name", "id")
JOINED = ("connections", "loads")


class Vocabulary(NamedTuple):
    """The words that a figure in a few lines is written in: those of its sections, and those that stand in them."""

    sections: tuple[str, ...]
    inside: tuple[str, ...]


class Written:
    """Data of a document while it is put in order. moved: where what has another place now stands in the file;
    refused: what is wrong with sections that say nothing here."""

    def __init__(self, data: Entry) -> None:
        self.data = data
        self.space = data.get("space") not in (None, False)
        self.moved: dict[Place, Place] = {}
        self.assumed: list[Message] = []
        self.refused: dict[str, Message] = {}

    def refuse(self, message: Message, *place: str | int) -> NoReturn:
        """A figure in a few lines that cannot be read safely: what else the file says belongs to it, and is judged when
        it can be. Raises ModelError."""
        raise ModelError([Problem(self.stood(place), message)])

    def stood(self, place: Place) -> Place:
        """Where something stands in the file."""
        for n in range(len(place), 0, -1):
            if place[:n] in self.moved:
                return (*self.moved[place[:n]], *place[n:])
        return place

    def move(self, section: str, name: str, to: str) -> None:
        """An entry that belongs in another section."""
        there = self.data.get(to) or {}
        if not isinstance(there, dict) or name in there:
            return
        inside = {place: stood for place, stood in self.moved.items() if place[:2] == (section, name)}
        self.moved |= {(to, *place[1:]): stood for place, stood in inside.items()}
        self.moved.setdefault((to, name), self.stood((section, name)))
        self.data[to] = {**cast("Entry", there), name: self.data[section].pop(name)}


def are_mappings(w: Written, *sections: str) -> bool:
    """Whether sections are there as mappings, or not at all: anything else is told where it is read."""
    return all(isinstance(w.data.get(section) or {}, dict) for section in sections)


def keys_beside(section: str, *, space: bool) -> tuple[str, ...]:
    """What an entry of a section may have beside its kind."""
    if section == "bodies":
        return SPATIAL_OPTIONS if space else PLANAR_OPTIONS
    return (CLOSES,) if section == "connections" else ()


def kind_of(w: Written, section: str, word: str, value: Any) -> tuple[str, type[Spec] | None]:
    """What a word with its fields means: in its section, else in the other one of connections and loads."""
    sections = (section, *(other for other in JOINED if other != section)) if section in JOINED else (section,)
    for at in sections:
        kinds = kinds_of(at)
        value = without_options(w, section, value)
        meant = written_kind(word, value, kinds, space=w.space)
        if meant is not None and (word in kinds or takes(kinds[meant], value) or at == section):
            if at == section and word not in kinds and not takes(kinds[meant], value):
                other = next((o for o in sections[1:] if word in kinds_of(o)), None)
                if other is not None:
                    return other, kinds_of(other)[word]
            return at, kinds[meant]
    return section, None


def without_options(w: Written, section: str, value: Any) -> Any:
    """The fields of a shape among which stands what every body may have."""
    if section != "bodies" or not isinstance(value, dict):
        return value
    options = keys_beside(section, space=w.space)
    return {key: each for key, each in cast("Entry", value).items() if not as_option(key, options)} or None


def shape_of(entry: Any) -> type[Spec] | None:
    """The one shape of a body of the plane."""
    fields = cast("Entry", entry) if isinstance(entry, dict) else {}
    found = [written_kind(word, value, Shape.kinds, space=False) for word, value in fields.items()]
    kinds = [kind for kind in found if kind is not None]
    return Shape.kinds[kinds[0]] if len(kinds) == 1 else None


def section_of(w: Written, section: str, word: str, value: Any) -> bool:
    return kind_of(w, section, word, value)[1] is not None


def takes_as(word: str, value: Any, kinds: Kinds, *, space: bool) -> bool:
    """Whether a word stands for a kind that takes what is given."""
    meant = written_kind(word, value, kinds, space=space)
    return meant is not None and takes(kinds[meant], value)


def kinds_of(section: str) -> Kinds:
    found: Mapping[str, Kinds] = {"bodies": Shape.kinds, "connections": Connection.kinds, "loads": Load.kinds}
    return found[section]


def as_option(key: str, options: tuple[str, ...]) -> bool:
    """Whether a key is one of what every body may have, also by a word that means the same."""
    return key in options or (key in SAME and key != "on" and any(field in options for field in MEANT.get(key, ())))
