"""A document while it is read: its sections, and the descriptions in them, with problems noted at their places."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any, TypeVar, cast

from freebody.errors import ModelError
from freebody.language.document import Document
from freebody.language.document.writer import flow_text
from freebody.language.expression import name_problem
from freebody.language.parser import in_ascii
from freebody.language.sentences import Message, as_found, listed
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.model.shapes.base import Shape
from freebody.model.spec import Spec, WrongFields
from freebody.model.written_kinds import written_kind
from freebody.system.reading.examples import example_of
from freebody.system.reading.faults import Faults
from freebody.system.reading.ground_points import GroundPoints
from freebody.system.unspecified import Unspecified

SpecT = TypeVar("SpecT", bound=Spec)
_DIGITS_FIRST = re.compile(r"\d+(?: .*)?")  # what a comma in a number leaves behind it
_WANTED = {  # by the type of a fault; a text may be an expression
    "string_type": Message("a text"),
    "int_type": Message("a number"),
    "float_type": Message("a number"),
    "list_type": Message("a list"),
    "tuple_type": Message("a list"),
    "dict_type": Message("a mapping"),
    "bool_type": Message("true or false"),
    "bool_parsing": Message("true or false"),
}


def place_of(fault: Any) -> tuple[str | int, ...]:
    """The field in which a value does not fit, and its place in a list there; not which of several types was tried."""
    field, *rest = fault["loc"] or ("",)
    return (field, rest[0]) if rest and isinstance(rest[0], int) else (field,) if field else ()


def wanted_by(fault: Any) -> str:
    """What should stand there, where one type was tried."""
    return _WANTED.get(fault["type"]) or fault["msg"][0].lower() + fault["msg"][1:]


def known_keys(names: Names, entry: Mapping[str, Any], known: Sequence[str], what: str, *path: str | int) -> None:
    """Notes a problem for every key of an entry that means nothing there."""
    for key in entry:
        if key not in known:
            names.problem(
                Message("{what} has no {key}.{hint}", what=what, key=key, hint=did_you_mean(key, known)),
                *path,
                key,
            )


_TAKEN = {"t": Message("t is the time; choose another name"), "pi": Message("pi is a number; choose another name")}


def _named_otherwise(name: str) -> Message | None:
    """What to write for a key that cannot be a name, where that is plain."""
    before, colon, after = name.partition(":")
    if colon and not name_problem(before):
        return Message("a space belongs behind the colon: {name}: {value}", name=before, value=after.strip())
    meant = re.sub(r"\s+", "_", in_ascii(name).strip())
    if meant != name and not name_problem(meant):
        return Message("names have Latin letters, digits and underscores: write {meant}", meant=meant)
    return None


class Source(Faults, GroundPoints):
    """A document, what its names mean so far, and what it leaves open."""

    def __init__(self, document: Document, file: str | None, names: Names | None = None) -> None:
        self.document = document
        self.file = file
        self.refused: Mapping[str, Message] = {}  # sections that were left as they are, and why
        self.names = Names() if names is None else names
        self.data: dict[str, Any] = self._with_points(document.data)
        self.open = Unspecified(self.names, self.data)
        self._words = set(re.findall(r"\w+", str(self.data)))

    def _with_points(self, value: Any, *path: str | int) -> Any:
        """What stands in a document, with points for the commas of `{gravity: 9,81 m/s^2}`, which are problems: so
        nothing else follows from them."""
        if isinstance(value, list):
            return [self._with_points(each, *path, k) for k, each in enumerate(cast("list[Any]", value))]
        if not isinstance(value, dict):
            return value
        entries = cast("dict[str, Any]", value)
        read: dict[str, Any] = {}
        before, n = "", None
        for name, given in entries.items():
            if given is None and isinstance(n, int) and _DIGITS_FIRST.fullmatch(str(name)):
                told = Message("a comma separates entries; write a point: {n}.{rest}", n=n, rest=name)
                self.names.problem(told, *path, before)
                read[before] = f"{n}.{name}"
            else:
                read[name] = self._with_points(given, *path, name)
            before, n = name, given
        return read

    def refuse_problems(self) -> None:
        """Raises ModelError with all problems, in the order of their places."""
        if self.names.problems:
            located = [self.document.locate(p) for p in self.names.causes]
            located.sort(key=lambda p: (p.line or 0, p.column or 0))
            seen: set[str] = set()
            raise ModelError([p for p in located if self._is_new(p.message, seen)], self.file)

    def _is_new(self, message: str, seen: set[str]) -> bool:
        """Whether a problem is not told yet, of those that are told once."""
        if message not in self.names.told_once:
            return True
        is_new = message not in seen
        seen.add(message)
        return is_new

    def mapping(self, section: str) -> dict[str, Any]:
        value = self.data.get(section)
        if value is None:
            return {}
        if not isinstance(value, dict):
            told = Message("{section} must be a mapping of names, e.g. {section}: {{a: ...}}", section=section)
            if isinstance(value, list):
                told = Message(
                    "{section} must be a mapping of names, not a list: each entry has its name before a colon, without "
                    "a dash, {section}: {{a: ..., b: ...}}",
                    section=section,
                )
            self.names.problem(told, section)
            self.names.is_cut_short = True
            return {}
        return cast("dict[str, Any]", value)

    def named(self, section: str) -> dict[str, Any]:
        """The entries of a section whose names can be used."""
        good: dict[str, Any] = {}
        entries = self.mapping(section)
        for name, value in entries.items():
            fault = name_problem(name)
            taken = _TAKEN.get(name) if section in ("parameters", "measures") else None
            if fault is not None or taken is not None:
                told = _named_otherwise(name) or fault or taken or ""
                self.names.problem(told, section, name)
                self.names.broken.update((name, in_ascii(name), *re.findall(r"\w+", name)))
                continue
            good[name] = value
        return good

    def spec(self, kind: type[SpecT], value: Any, *path: str | int, beside: Collection[str] = ()) -> SpecT | None:
        """One description, its problems noted with their places; beside: the keys that stand next to a kind."""
        if kind.space_only and not self.names.space:
            other = kind.in_plane_take
            told = Message("; in the plane take {other}", other=other) if other else ""
            what = Message("{kind} is for models in space: write space: true{told}", kind=kind.kind, told=told)
            self.names.problem(what, *path)
            return None
        try:
            return kind.model_validate(self._with_ground_points(kind, kind.from_plain(value), *path))
        except WrongFields as wrong:
            error = wrong.found
            faults = {place_of(fault): fault for fault in reversed(error.errors())}  # of a field the first
            absent = [str(place_of(fault)[0]) for fault in error.errors() if fault["type"] == "missing"]
            strange = [str(where[0]) for where, fault in faults.items() if fault["type"] == "extra_forbidden"]
            if isinstance(value, list) and absent and not strange:
                self._too_short(kind, len(cast("list[Any]", value)), absent, *path)
            else:
                inside = [key for key in reversed(strange) if key in beside]
                misnamed = [key for key in reversed(strange) if key not in inside]
                self._misnamed(kind, absent, misnamed, kind.from_plain(value), *path)
                if inside:
                    self._inside_a_kind(kind, inside, value, *path)
            for where, fault in reversed(faults.items()):
                if fault["type"] in ("extra_forbidden", "missing"):
                    continue
                wanted = [wanted_by(other) for other in error.errors() if place_of(other) == where]
                what = str(where[0]) if where else ""
                message = Message(
                    "{what}: expected {wanted}, found {value}",
                    what=what,
                    wanted=listed(list(dict.fromkeys(wanted)), "{first} or {second}"),
                    value=as_found(fault["input"]),
                )
                if isinstance(fault["input"], bool):
                    message = Message(
                        "{what} takes a value, not {value}{example}",
                        what=what,
                        value=str(fault["input"]).lower(),
                        example=example_of(kind, self.data),
                    )
                is_of_points = not issubclass(kind, Shape) and kind.field_types().get(what) == "text"
                if fault["type"] == "string_type" and is_of_points and self._is_a_place(fault["input"]):
                    message = Message(
                        "{what} takes a point by its name: give the ground or a body points: {{P: {place}}}, then "
                        "{what}: ground.P, or that of the body",
                        what=what,
                        place=flow_text(list(cast("list[Any]", fault["input"]))),
                    )
                self.names.problem(message, *path, *where)
            return None

    def _word_of(self, key: str, fields: Any, kinds: Mapping[str, type[Spec]]) -> str | None:
        """The kind that a key of an entry stands for; of several for which it may, none."""
        return key if key in kinds else written_kind(key, fields, kinds, space=self.names.space)

    def specs(self, section: str, kinds: Mapping[str, type[SpecT]], beside: Collection[str] = ()) -> dict[str, SpecT]:
        """The descriptions of a section by name. beside: keys that an entry may have beside its kind."""
        found: dict[str, SpecT] = {}
        for name, value in self.named(section).items():
            with self.names.reading(section, name):
                if isinstance(value, str) and value in kinds:
                    value = {value: None}
                if isinstance(value, dict):
                    entry = cast("dict[str, Any]", value)
                    value = {key: fields for key, fields in entry.items() if key not in beside}
                    own = [key for key in value if key in kinds] or [
                        key for key, fields in value.items() if self._word_of(key, fields, kinds) is not None
                    ]
                    if len(own) == 1 < len(value) and (word := self._word_of(own[0], value[own[0]], kinds)):
                        self._beside_a_kind(name, kinds[word], own[0], entry, beside)
                        continue
                if not isinstance(value, dict) or len(cast("dict[str, Any]", value)) != 1:
                    self.names.problem(self._kind_wanted(name, value, kinds))
                    continue
                ((kind, fields),) = cast("dict[str, Any]", value).items()
                meant = written_kind(kind, fields, kinds, space=self.names.space)
                if meant is None and name in kinds:
                    self.names.problem(self._kind_wanted(name, value, kinds))
                    continue
                if meant is None:
                    self.names.problem(self._no_kind(section, kind, fields, kinds), kind)
                    continue
                spec = self.spec(kinds[meant], fields, kind, beside=beside)
                if spec is not None:
                    found[name] = spec
        return found
