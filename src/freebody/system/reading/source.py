"""A document while it is read: its sections, and the descriptions in them, with problems noted at their places."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any, TypeVar, cast

from pydantic import ValidationError

from freebody.errors import ModelError
from freebody.language.document import Document
from freebody.language.expression import name_problem
from freebody.language.sentences import Message, listed
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.model.spec import Spec
from freebody.system.unspecified import Unspecified

SpecT = TypeVar("SpecT", bound=Spec)
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


def kind_meant(key: str, kinds: Mapping[str, type[Spec]], known: Iterable[str]) -> str:
    """' Did you mean x?' of kinds: by how a name is spelt, else what people call so (block: rectangle)."""
    known = list(known)
    is_alike = difflib.get_close_matches(key, known, n=1, cutoff=0.7) or any(k.startswith(f"{key}_") for k in kinds)
    called = [] if is_alike else [kind for kind, spec in kinds.items() if key in spec.called]
    if len(called) == 1:
        return Message(" Did you mean {x}?", x=called[0])
    if called:
        return Message(" Did you mean one of {names}?", names=", ".join(called))
    return did_you_mean(key, known)


class Source:
    """A document, what its names mean so far, and what it leaves open."""

    def __init__(self, document: Document, file: str | None, names: Names | None = None) -> None:
        self.document = document
        self.file = file
        self.data = document.data
        self.names = Names() if names is None else names
        self.open = Unspecified(self.names, self.data)

    def refuse_problems(self) -> None:
        """Raises ModelError with all problems, in the order of their places."""
        if self.names.problems:
            located = [self.document.locate(p) for p in self.names.problems]
            located.sort(key=lambda p: (p.line or 0, p.column or 0))
            raise ModelError(located, self.file)

    def mapping(self, section: str) -> dict[str, Any]:
        value = self.data.get(section)
        if value is None:
            return {}
        if not isinstance(value, dict):
            self.names.problem(
                Message("{section} must be a mapping of names, e.g. {section}: {{a: ...}}", section=section),
                section,
            )
            self.names.is_cut_short = True
            return {}
        return cast("dict[str, Any]", value)

    def named(self, section: str) -> dict[str, Any]:
        """The entries of a section whose names can be used."""
        good: dict[str, Any] = {}
        entries = self.mapping(section)
        for before, name in pairwise(entries):
            if section == "parameters" and str(name).isdigit() and isinstance(entries[before], int):
                told = Message("a comma separates entries; write a point: {n}.{rest}", n=entries[before], rest=name)
                self.names.problem(told, section, before)
                self.names.broken.update((before, name))
        for name, value in entries.items():
            if section == "parameters" and name in self.names.broken:
                continue
            fault = name_problem(name)
            if fault is not None or (name == "t" and section in ("parameters", "measures")):
                self.names.problem(fault or Message("t is the time; choose another name"), section, name)
                self.names.broken.add(name)
                continue
            good[name] = value
        return good

    def spec(self, kind: type[SpecT], value: Any, *path: str | int) -> SpecT | None:
        """One description, its problems noted with their places."""
        try:
            return kind.model_validate(kind.from_plain(value))
        except ValidationError as error:
            known = [f.alias or n for n, f in kind.model_fields.items()]
            faults = {place_of(fault): fault for fault in reversed(error.errors())}  # of a field the first
            for where, fault in reversed(faults.items()):
                what = str(where[0]) if where else ""
                if fault["type"] == "extra_forbidden":
                    message = Message(
                        "{what} has no {key}.{hint}", what=kind.kind, key=what, hint=did_you_mean(what, known)
                    )
                elif fault["type"] == "missing":
                    message = Message(
                        "{kind} needs {what}; it takes {names}", kind=kind.kind, what=what, names=", ".join(known)
                    )
                    where = ()
                else:
                    wanted = [wanted_by(other) for other in error.errors() if place_of(other) == where]
                    message = Message(
                        "{what}: expected {wanted}, found {value}",
                        what=what,
                        wanted=listed(list(dict.fromkeys(wanted)), "{first} or {second}"),
                        value=repr(fault["input"]),
                    )
                self.names.problem(message, *path, *where)
            return None

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
                    if len(more := [key for key in value if key not in kinds]) == len(value) - 1 > 0 and beside:
                        for key in more:
                            hint = did_you_mean(key, beside)
                            self.names.problem(
                                Message("{what} has no {key}.{hint}", what=name, key=key, hint=hint), key
                            )
                        continue
                if not isinstance(value, dict) or len(cast("dict[str, Any]", value)) != 1:
                    hint = next(iter(kinds))
                    self.names.problem(
                        Message(
                            "give one kind, e.g. {name}: {{{hint}: ...}}; kinds: {names}",
                            name=name,
                            hint=hint,
                            names=", ".join(sorted(kinds)),
                        )
                    )
                    continue
                ((kind, fields),) = cast("dict[str, Any]", value).items()
                if kind not in kinds:
                    what = Message("connection" if section == "connections" else "load")
                    self.names.problem(
                        Message(
                            "{kind} is no kind of {what}.{hint}",
                            kind=kind,
                            what=what,
                            hint=kind_meant(kind, kinds, kinds),
                        ),
                        kind,
                    )
                    continue
                spec = self.spec(kinds[kind], fields, kind)
                if spec is not None:
                    found[name] = spec
        return found
