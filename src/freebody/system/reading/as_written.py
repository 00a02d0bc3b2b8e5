"""A file as people write it first, put into the form in which it is read.

    as it comes                                as it is read
    loads: {gravity: g}                        loads: {gravity: {gravity: g}}
    F: {force: 5 N, at: P, along: down}        F: {force: {magnitude: 5 N, at: P, along: down}}
    {disk: {radius: R, at: [0, 0]}}            {disk: {radius: R}, at: [0, 0]}
    crank: {type: rod, length: L}              crank: {rod: {length: L}}
    connections: [{pin: [A, B]}]               connections: {pin: {pin: [A, B]}}
    connections: {s: {spring: ...}}            loads: {s: {spring: ...}}
    joints: ..., points: ..., gravity: g       connections: ..., ground: {points: ...}, loads: {gravity: ...}
    F: 5 N down at P                           F: {force: {magnitude: 5 N, along: down, at: P}}

Only what can mean one thing is put elsewhere; anything else stays as it is, and is told where it is read. Which words
stand for a kind, which fields it has and what it reads in words, the kinds say themselves.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.document import Document
from freebody.language.document.tree import Place
from freebody.language.expression import name_problem
from freebody.language.sentences import Message
from freebody.loads.base import Load
from freebody.model.shapes.base import Shape
from freebody.model.spec import MEANT, SAME, Spec
from freebody.model.written_kinds import put_inside, takes, written_kind
from freebody.system.reading.sections import (
    CLOSES,
    MEANT_SECTIONS,
    OF_GROUND,
    OF_LINES,
    PLANAR_OPTIONS,
    SECTIONS,
    SPATIAL_OPTIONS,
)
from freebody.system.reading.trusses import with_truss

Kinds = Mapping[str, type[Spec]]
Entry = dict[str, Any]

_SAYS_KIND = ("type", "kind", "shape")
_SAYS_NAME = ("name", "id")
_JOINED = ("connections", "loads")
_NAMED = (*_JOINED, "bodies", "parameters", "measures", "start")
_AT_REST = ("rest", "at rest", "from rest", "in ruhe", "ruhe")
_IN_SPACE = ("3d", "3", "yes", "spatial")
_PLACES = ("points", "nodes", "joints")  # sections that may hold places


def as_read(document: Document) -> tuple[Document, list[Message]]:
    """The document in the form in which it is read, itself where it is written so, and what that takes for granted."""
    written = _Written(document.data)
    written.put_in_order()
    is_other = written.data != document.data
    return document.rewritten(written.data, written.moved) if is_other else document, written.assumed


class _Written:
    """Data of a document while it is put in order. moved: where what has another place now stands in the file."""

    def __init__(self, data: Entry) -> None:
        self.data = data
        self.space = data.get("space") not in (None, False)
        self.moved: dict[Place, Place] = {}
        self.assumed: list[Message] = []

    def put_in_order(self) -> None:
        if str(self.data.get("space")).lower() in _IN_SPACE:
            self.data["space"], self.space = True, True
            self.moved[("space",)] = ("space",)
        if (truss := with_truss(self.data, space=self.space)) is not None:
            self.data, self.moved, told = truss[0], self.moved | truss[1], truss[2]
            self.assumed.append(told)
        if str(self.data.get("start")).lower() in _AT_REST:
            del self.data["start"]
        self._rename_sections()
        for section in _NAMED:
            if isinstance(self.data.get(section), list):
                self._name_items(section)
        self._take_in_sections()
        self._lines_of_ground()
        for section in ("bodies", *_JOINED):
            entries = self.data.get(section)
            for name, entry in list(cast("Entry", entries).items()) if isinstance(entries, dict) else ():
                self._entry(section, name, entry)

    def _stood(self, place: Place) -> Place:
        """Where something stands in the file."""
        for n in range(len(place), 0, -1):
            if place[:n] in self.moved:
                return (*self.moved[place[:n]], *place[n:])
        return place

    def _lines_of_ground(self) -> None:
        """`ground: {slope: {angle: 30 deg}}` among the lines of the ground."""
        ground = self.data.get("ground")
        if not isinstance(ground, dict) or self.space:
            return
        entries = cast("Entry", ground)
        own = {
            name: value
            for name, value in entries.items()
            if name not in OF_GROUND
            and isinstance(value, dict)
            and value
            and cast("Entry", value).keys() <= {*OF_LINES}
        }
        lines = entries.get("lines") or {}
        if own and isinstance(lines, dict) and not own.keys() & cast("Entry", lines).keys():
            rest = {name: value for name, value in entries.items() if name not in own}
            self.data["ground"] = {**rest, "lines": {**cast("Entry", lines), **own}}
            self.moved |= {("ground", "lines", name): ("ground", name) for name in own}

    # -- sections -----------------------------------------------------------------------------
    def _take_in_sections(self) -> None:
        """Points beside the sections, and connections and loads that are sections of their own."""
        for key, value in list(self.data.items()):
            if key in SECTIONS:
                continue
            if key in OF_GROUND or (key in _PLACES and _are_places(value)):
                self._take_in("ground", {key if key in OF_GROUND else "points": value}, key, (key,))
            elif (joined := self._joined_as(key, value)) is not None:
                self._take_in(joined, {key: {key: value}}, key, (key,))

    def _rename_sections(self) -> None:
        """Sections under other words."""
        for key, value in list(self.data.items()):
            if key in (*SECTIONS, *OF_GROUND) or (key in _PLACES and _are_places(value)):
                continue
            if self._joined_as(key, value) is not None:
                continue
            if (plural := self._plural(key)) is not None:
                self._rename(key, plural[0], self._of_kind(plural[1], value))
            elif (section := MEANT_SECTIONS.get(key)) is not None:
                self._rename(key, section, value)
        if isinstance(self.data.get("questions"), str):
            self.data["questions"] = [self.data["questions"]]
            self.moved["questions", 0] = ("questions",)

    def _plural(self, key: str) -> tuple[str, str] | None:
        """The section of things that are all of one kind, and the word for that: `springs`."""
        word = key.removesuffix("s")
        for section in _JOINED if word != key else ():
            if written_kind(word, None, _kinds(section), space=self.space) is not None:
                return section, word
        return None

    def _of_kind(self, word: str, value: Any) -> Any:
        """Entries of a section of one kind, each with the word for that where it says no other."""
        if isinstance(value, list):
            return [self._as_kind(word, each) for each in cast("list[Any]", value)]
        if not isinstance(value, dict):
            return value
        return {name: self._as_kind(word, each) for name, each in cast("Entry", value).items()}

    def _as_kind(self, word: str, entry: Any) -> Any:
        able = any(takes_as(word, entry, _kinds(section), space=self.space) for section in _JOINED)
        return {word: entry} if able else entry

    def _joined_as(self, key: str, value: Any) -> str | None:
        """The section in which a connection or a load belongs that stands as a section of its own."""
        for section in _JOINED:
            if takes_as(key, value, _kinds(section), space=self.space):
                return section
        return None

    def _take_in(self, section: str, own: Entry, key: str, place: Place) -> None:
        """Entries that stand elsewhere, into a section where there is nothing of their names."""
        there = self.data.get(section) or {}
        if not isinstance(there, dict) or own.keys() & cast("Entry", there).keys():
            return
        self.data[section] = {**cast("Entry", there), **own}
        del self.data[key]
        for name, entry in own.items():
            self.moved[section, name] = place
            if isinstance(entry, dict) and [*cast("Entry", entry)] == [key]:
                self.moved[section, name, key] = place

    def _rename(self, key: str, section: str, value: Any) -> None:
        if section == "questions" and not isinstance(value, list | dict):
            value = [value]
        there = self.data.get(section)
        if isinstance(there, dict) and isinstance(value, dict):
            entries = cast("Entry", value)
            if not there.keys() & entries.keys():
                self.data[section] = {**cast("Entry", there), **entries}
                self.moved |= {(section, name): (key, name) for name in entries}
                del self.data[key]
        elif there is None and section not in self.data:
            self.data = {section if k == key else k: value if k == key else v for k, v in self.data.items()}
            self.moved[(section,)] = (key,)

    # -- lists in place of names --------------------------------------------------------------
    def _name_items(self, section: str) -> None:
        """A list of entries as the same with names: those that they give, else the words for their kinds."""
        items: list[tuple[str, Any]] = []
        for item in cast("list[Any]", self.data[section]):
            if not isinstance(item, dict) or (named := self._named_item(section, cast("Entry", item))) is None:
                return
            items.append(named)
        words = [name for name, _entry in items]
        names = [
            f"{name}_{words[: k + 1].count(name)}" if words.count(name) > 1 else name for k, name in enumerate(words)
        ]
        if len({*names}) < len(names) or any(name_problem(name) for name in names if section != "start"):
            return
        self.moved |= {(section, name): self._stood((section, k)) for k, name in enumerate(names)}
        for k, (name, (word, entry)) in enumerate(zip(names, items, strict=True)):
            item = cast("list[Entry]", self.data[section])[k]
            if word in item and item[word] is entry:
                self.moved[section, name] = (*self.moved[section, name], word)
        self.data[section] = {name: entry for name, (_word, entry) in zip(names, items, strict=True)}

    def _named_item(self, section: str, item: Entry) -> tuple[str, Any] | None:
        """The name of an item of a list, and what it says of it."""
        said = next((key for key in _SAYS_NAME if isinstance(item.get(key), str)), None)
        if said is not None:
            return item[said], {key: value for key, value in item.items() if key != said}
        if section in _JOINED:
            kind = next((item[key] for key in _SAYS_KIND if isinstance(item.get(key), str)), None)
            kind = kind or next((key for key, value in item.items() if self._section_of(section, key, value)), None)
            if kind is not None:
                return kind, item
        elif section == "bodies":
            word = next((k for k, v in item.items() if takes_as(k, v, Shape.kinds, space=self.space)), None)
            if word is not None and (len(item) > 1 or not self._has_shape(item[word])):
                return word, item
        if len(item) != 1:
            return None
        ((name, value),) = item.items()
        return name, value

    def _has_shape(self, entry: Any) -> bool:
        fields = cast("Entry", entry) if isinstance(entry, dict) else {}
        return any(isinstance(v, dict) and takes_as(k, v, Shape.kinds, space=self.space) for k, v in fields.items())

    # -- entries ------------------------------------------------------------------------------
    def _entry(self, section: str, name: str, entry: Any) -> None:
        """One entry of bodies, connections or loads."""
        place: Place = (section, name)
        beside = self._beside(section)
        if not isinstance(entry, dict):
            if section in _JOINED:
                self._without_kind(section, name, entry)
            return
        given = cast("Entry", entry)
        is_said = any(isinstance(given.get(key), str) for key in _SAYS_KIND)
        found = None if is_said else next(self._kinds_in(section, given, beside), None)
        if found is None and (said := self._said_kind(section, given)) is not None:
            key, word = said
            fields = {k: v for k, v in given.items() if k != key and k not in beside}
            given = {word: fields or None, **{k: v for k, v in given.items() if k in beside}}
            self.moved[*place, word] = self._stood(place)
            self.data[section][name] = given
            found = next(self._kinds_in(section, given, beside), None)
        if found is None:
            self._without_kind(section, name, given)
            return
        word, at, kind = found
        if section == "connections":
            given = self._closing(place, given, word)
        given = self._with_own_inside(place, given, word, kind, beside)
        if section == "bodies":
            given = self._with_options_beside(place, given, word, kind, beside)
            given = {key: _by_axes(value) if key != word else value for key, value in given.items()}
        self.data[section][name] = given
        if at != section:
            self._move(section, name, at)

    def _closing(self, place: Place, given: Entry, word: str) -> Entry:
        """`when: at start` beside a connection says when it closes."""
        if "when" not in given or word == "when" or CLOSES in given or not isinstance(given["when"], str):
            return given
        said: str = given["when"]
        self.moved[*place, CLOSES] = (*self._stood(place), "when")
        closes = said if said.startswith(("at ", "when ")) or said == "start" else f"when {said}"
        return {CLOSES if key == "when" else key: closes if key == "when" else value for key, value in given.items()}

    def _beside(self, section: str) -> tuple[str, ...]:
        if section == "bodies":
            return SPATIAL_OPTIONS if self.space else PLANAR_OPTIONS
        return (CLOSES,) if section == "connections" else ()

    def _kinds_in(self, section: str, given: Entry, beside: tuple[str, ...]) -> Iterator[tuple[str, str, type[Spec]]]:
        """The one kind that an entry names: its word, the section where it belongs, and the kind."""
        keys = [key for key in given if key not in beside]
        own = [key for key in keys if key in _kinds(section)] or keys
        found = [(key, at, kind) for key in own for at, kind in [self._kind_of(section, key, given[key])] if kind]
        if len(found) == 1:
            ((word, at, kind),) = found
            yield word, at, kind

    def _kind_of(self, section: str, word: str, value: Any) -> tuple[str, type[Spec] | None]:
        """What a word with its fields means: in its section, else in the other one of connections and loads."""
        sections = (section, *(other for other in _JOINED if other != section)) if section in _JOINED else (section,)
        for at in sections:
            kinds = _kinds(at)
            value = self._without_options(section, value)
            meant = written_kind(word, value, kinds, space=self.space)
            if meant is not None and (word in kinds or takes(kinds[meant], value) or at == section):
                if at == section and word not in kinds and not takes(kinds[meant], value):
                    other = next((o for o in sections[1:] if word in _kinds(o)), None)
                    if other is not None:
                        return other, _kinds(other)[word]
                return at, kinds[meant]
        return section, None

    def _without_options(self, section: str, value: Any) -> Any:
        """The fields of a shape among which stands what every body may have."""
        if section != "bodies" or not isinstance(value, dict):
            return value
        options = self._beside(section)
        return {key: each for key, each in cast("Entry", value).items() if not _as_option(key, options)} or None

    def _section_of(self, section: str, word: str, value: Any) -> bool:
        return self._kind_of(section, word, value)[1] is not None

    def _said_kind(self, section: str, given: Entry) -> tuple[str, str] | None:
        """`type: rod`: the key, and the word that it says."""
        for key in _SAYS_KIND:
            word = given.get(key)
            fields = {k: v for k, v in given.items() if k != key and k not in self._beside(section)}
            if isinstance(word, str) and self._kind_of(section, word, fields)[1] is not None:
                return key, word
        return None

    def _without_kind(self, section: str, name: str, entry: Any) -> None:
        """An entry that its name says the kind of, or that is written in words."""
        beside = self._beside(section)
        given = cast("Entry", entry) if isinstance(entry, dict) else {}
        inner = {k: v for k, v in given.items() if k not in beside} if isinstance(entry, dict) else entry
        word = name.rstrip("_0123456789") or name
        for at in (section, *(other for other in _JOINED if other != section)) if section in _JOINED else (section,):
            if inner not in (None, {}) and takes_as(word, inner, _kinds(at), space=self.space):
                self.data[section][name] = {word: inner, **{k: v for k, v in given.items() if k in beside}}
                self.moved[section, name, word] = self._stood((section, name))
                if at != section:
                    self._move(section, name, at)
                elif section == "bodies":
                    self._entry(section, name, self.data[section][name])
                return
            fields = ((kind, spec.in_words(entry)) for kind, spec in _kinds(at).items() if isinstance(entry, str))
            for kind, said in fields:
                if said is not None:
                    self.data[section][name] = {kind: said}
                    self.moved[section, name, kind] = self._stood((section, name))
                    return

    def _with_own_inside(
        self, place: Place, given: Entry, word: str, kind: type[Spec], beside: tuple[str, ...]
    ) -> Entry:
        """`{force: 5 N, at: P}`: what stands beside a kind and is a field of it, inside."""
        fields = {f.alias or n for n, f in kind.model_fields.items()}
        options = {key for key in given if _as_option(key, beside)}
        known = {*fields, *kind.more_words}
        own = [key for key in given if key != word and key not in options and (key in known or kind.meant(key))]
        meant = {key: found[0] if len(found := kind.meant(key)) == 1 and key not in known else key for key in own}
        inside = {*kind.from_plain(given[word])}
        if not own or any(key in kind.elsewhere for key in own) or len({*meant.values()}) < len(own):
            return given
        whole = put_inside(kind, given[word], kind.from_plain({meant[key]: given[key] for key in own}))
        if inside & {*meant.values()} and isinstance(given[word], dict | list):
            return given  # said twice
        self.moved |= {(*place, word, meant[key]): (*self._stood(place), key) for key in own}
        return {key: whole if key == word else value for key, value in given.items() if key not in own}

    def _with_options_beside(
        self, place: Place, given: Entry, word: str, kind: type[Spec], beside: tuple[str, ...]
    ) -> Entry:
        """`{disk: {radius: R, at: [0, 0]}}`: what every body may have, beside its shape."""
        if not isinstance(given[word], dict):
            return given
        inner = cast("Entry", given[word])
        fields = {f.alias or n for n, f in kind.model_fields.items()}
        out = [
            key
            for key in inner
            if key not in fields and not kind.meant(key) and key not in kind.elsewhere and _as_option(key, beside)
        ]
        if not out or any(key in given for key in out):
            return given
        self.moved |= {(*place, key): (*self._stood((*place, word)), key) for key in out}
        left = {key: value for key, value in inner.items() if key not in out}
        return {**given, word: left or None, **{key: inner[key] for key in out}}

    def _move(self, section: str, name: str, to: str) -> None:
        """An entry that belongs in another section."""
        there = self.data.get(to) or {}
        if not isinstance(there, dict) or name in there:
            return
        inside = {place: stood for place, stood in self.moved.items() if place[:2] == (section, name)}
        self.moved |= {(to, *place[1:]): stood for place, stood in inside.items()}
        self.moved.setdefault((to, name), self._stood((section, name)))
        self.data[to] = {**cast("Entry", there), name: self.data[section].pop(name)}


def takes_as(word: str, value: Any, kinds: Kinds, *, space: bool) -> bool:
    """Whether a word stands for a kind that takes what is given."""
    meant = written_kind(word, value, kinds, space=space)
    return meant is not None and takes(kinds[meant], value)


def _kinds(section: str) -> Kinds:
    found: Mapping[str, Kinds] = {"bodies": Shape.kinds, "connections": Connection.kinds, "loads": Load.kinds}
    return found[section]


def _as_option(key: str, options: tuple[str, ...]) -> bool:
    """Whether a key is one of what every body may have, also by a word that means the same."""
    return key in options or (key in SAME and key != "on" and any(field in options for field in MEANT.get(key, ())))


def _by_axes(value: Any) -> Any:
    """`{x: 60 m/s, y: 0}` as components."""
    if not isinstance(value, dict) or not {"x", "y"} <= {*cast("Entry", value)} <= {"x", "y", "z"}:
        return value
    return [value[axis] for axis in "xyz" if axis in value]


def _are_places(value: Any) -> bool:
    """Whether a section holds the places of points by their names."""
    places = [*cast("Entry", value).values()] if isinstance(value, dict) else []
    return bool(places) and all(
        isinstance(place, list) and len(cast("list[Any]", place)) in (2, 3) and all(map(_is_coordinate, place))
        for place in places
    )


def _is_coordinate(value: Any) -> bool:
    return isinstance(value, int | float) or (isinstance(value, str) and any(sign.isdigit() for sign in value))
