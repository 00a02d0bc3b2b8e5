"""A document while it is read: its sections, and the descriptions in them, with problems noted at their places."""

from __future__ import annotations

import difflib
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from string import ascii_uppercase
from typing import Any, TypeVar, cast

from freebody.connections.base import Connection
from freebody.errors import InputError, ModelError
from freebody.language.document import Document
from freebody.language.document.writer import flow_text
from freebody.language.expression import name_problem
from freebody.language.folded import folded
from freebody.language.parser import in_ascii
from freebody.language.sentences import Message, as_found, in_turn, listed
from freebody.language.units import ANGULAR_VELOCITY, LENGTH, parse_quantity
from freebody.loads.base import Load
from freebody.measures.geometry import GROUND
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.model.shapes.base import Shape
from freebody.model.spec import ENDS, MEANT, Spec, WrongFields
from freebody.model.written_kinds import put_inside, takes, words_also, written_kind
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


def kind_meant(
    key: str, kinds: Mapping[str, type[Spec]], known: Iterable[str], *, space: bool, fields: Collection[str] = ()
) -> str:
    """' Did you mean x?' of kinds: what people call so (block: rectangle), of these those that have all fields that are
    given, else by how a name is spelt."""
    fits = {kind: spec for kind, spec in kinds.items() if space or not spec.space_only}
    if (joint := key.removesuffix("_joint")) in fits:
        return Message(" Did you mean {x}{example}?", x=joint, example=_example_of(fits[joint]))
    words = key.replace("_", " ")
    known = [name for name in known if name in fits or name not in kinds]
    begun = [kind for kind in fits if kind.startswith(f"{key}_")]
    called = begun or [kind for kind, spec in fits.items() if words in spec.called]
    able = [kind for kind in called if set(fields) <= set(fits[kind].model_fields)]
    called = able or called
    called = [kind for kind in difflib.get_close_matches(key, called, n=1, cutoff=0.7) if not begun] or called
    if not called:
        flat = [spec.in_plane_take for spec in kinds.values() if words in spec.called and spec.in_plane_take in fits]
        if flat:
            return Message(" Did you mean {x}?", x=flat[0])
        near = difflib.get_close_matches(key, [*known, *words_also(fits)], n=1, cutoff=0.6)
        return did_you_mean(key, near or known)
    if len(called) == 1:
        return Message(" Did you mean {x}{example}?", x=called[0], example=_example_of(fits[called[0]]))
    if able and isinstance(fields, dict) and fields:
        first, *others = sorted(called, key=lambda kind: (len(fits[kind].model_fields), kind))
        return Message(
            " Write {entry}, or one of {names}",
            entry=flow_text({first: fields})[1:-1],
            names=", ".join(others),
        )
    return Message(" Did you mean one of {names}?", names=", ".join(called))


def _example_of(kind: type[Spec]) -> str:
    """', e.g. kind: {...}' as its own example has it, if it has one."""
    fields = _fields_of_example(kind)
    return "" if fields is None else Message(", e.g. {example}", example=flow_text({kind.kind: fields})[1:-1])


def _fields_of_example(kind: type[Spec]) -> Any:
    for section in Document.read(kind.example).data.values() if kind.example else ():
        entries = cast("dict[str, Any]", section) if isinstance(section, dict) else {}
        if isinstance(own := entries.get("it"), dict):
            return cast("dict[str, Any]", own).get(kind.kind)
    return None


_SPEEDS = ("velocity", "angular_velocity")  # that stand beside a shape


def _is_of_turning(value: Any) -> bool:
    """Whether a value is how fast something turns."""
    try:
        return parse_quantity(value).dimension == ANGULAR_VELOCITY
    except (InputError, TypeError):
        return False


def _as_key(place: Sequence[Any]) -> tuple[str, ...]:
    return tuple(map(str, place))


def _in_order(coordinate: str) -> tuple[int, float, str]:
    """Numbers by their size, then formulas."""
    try:
        return 0, parse_quantity(coordinate).value, ""
    except (InputError, TypeError):
        return 1, 0.0, coordinate


class Source:
    """A document, what its names mean so far, and what it leaves open."""

    def __init__(self, document: Document, file: str | None, names: Names | None = None) -> None:
        self.document = document
        self.file = file
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
                        example=_example_of(kind),
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

    def _with_ground_points(self, kind: type[Spec], fields: dict[str, Any], *path: str | int) -> dict[str, Any]:
        """Fields in which coordinates stand where points are named: those are points of the ground, called by the next
        letters that a file does not use for names. Beside `on` of a body they might be those of the body."""
        read = dict(fields)
        for field, k, place in self._places_among(kind, fields):
            point = self._ground_point(place, *path, field, *(() if k is None else (k,)))
            if k is None:
                read[field] = point
            else:
                read[field] = [point if n == k else each for n, each in enumerate(read[field])]
        return read

    def _places_among(self, kind: type[Spec], fields: dict[str, Any]) -> Iterator[tuple[str, int | None, list[Any]]]:
        """Coordinates among the ends of something: the field, the place in the list there, and they themselves."""
        if GROUND not in self.names.bodies or str(fields.get("on", GROUND)).partition(".")[0] != GROUND:
            return
        types = kind.field_types()
        ends = {key: types[n] for n, f in kind.model_fields.items() if n in ENDS for key in (n, f.alias or n)}
        for field, given in fields.items():
            if ends.get(field) == "text" and self._is_a_place(given):
                yield field, None, given
            elif field in ends and isinstance(given, list):
                for k, each in enumerate(cast("list[Any]", given)):
                    if self._is_a_place(each):
                        yield field, k, each

    def _ground_point(self, place: list[Any], *path: str | int) -> str:
        points, name = self.names.bodies[GROUND].points, self._letters[_as_key(place)]
        points.setdefault(name, self.names.components(place, LENGTH, *path))
        self.names.by_coordinates.add(name)
        return f"{GROUND}.{name}"

    @cached_property
    def _letters(self) -> dict[tuple[str, ...], str]:
        """Names of the points that coordinates make, from left to right and from below upwards: whatever the order of
        the entries is."""
        places: dict[tuple[str, ...], list[Any]] = {}
        all_kinds = {"connections": Connection.kinds, "loads": Load.kinds}
        for section, kinds in cast("dict[str, Mapping[str, type[Spec]]]", all_kinds).items():
            entries = self.data.get(section)
            for entry in cast("dict[str, Any]", entries).values() if isinstance(entries, dict) else ():
                for word, value in cast("dict[str, Any]", entry).items() if isinstance(entry, dict) else ():
                    meant = written_kind(word, value, kinds, space=self.names.space)
                    if meant is not None:
                        found = self._places_among(kinds[meant], kinds[meant].from_plain(value))
                        places |= {_as_key(place): place for _field, _k, place in found}
        used = self._words | self.names.bodies[GROUND].points.keys() | self.names.parameters.keys()
        free = [letter for letter in ascii_uppercase if letter not in used]
        ordered = sorted(places, key=lambda key: [_in_order(each) for each in key])
        return {key: free[k] if k < len(free) else f"P{k}" for k, key in enumerate(ordered)}

    def _is_a_place(self, value: Any) -> bool:
        """Whether somebody wrote coordinates where names of points stand."""
        entries = cast("list[Any]", value) if isinstance(value, list) else []
        are_names = any(str(entry).partition(".")[0] in self.names.bodies for entry in entries)
        return len(entries) in (2, 3) and not are_names and all(isinstance(e, str | int | float) for e in entries)

    def _kind_wanted(self, name: str, value: Any, kinds: Mapping[str, type[Spec]]) -> Message:
        """Who writes `gravity: g` gives the name of a kind and what belongs into it."""
        if name in kinds:
            example = _fields_of_example(kinds[name]) if value is None else value
            return Message(
                "give it a name of its own beside its kind, e.g. my_{name}: {{{name}: {value}}}",
                name=name,
                value=flow_text(example),
            )
        first, _space, rest = value.partition(" ") if isinstance(value, str) else ("", "", "")
        if first in kinds and rest:
            return Message(
                "a colon belongs behind the kind: {name}: {{{first}: {rest}}}", name=name, first=first, rest=rest
            )
        able = [kind for kind in sorted(kinds) if self.names.space or not kinds[kind].space_only]
        fields = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
        if fit := sorted(
            (len(kinds[kind].model_fields), kind) for kind in able if fields and takes(kinds[kind], fields)
        ):
            return Message(
                "say of which kind it is: {name}: {{{kind}: {fields}}}{others}",
                name=name,
                kind=fit[0][1],
                fields=flow_text(fields),
                others=Message(" (or {names})", names=", ".join(kind for _n, kind in fit[1:])) if len(fit) > 1 else "",
            )
        return Message(
            "give one kind, e.g. {name}: {{{hint}: ...}}; kinds: {names}",
            name=name,
            hint=able[0],
            names=", ".join(able),
        )

    def _no_kind(self, section: str, kind: str, fields: Any, kinds: Mapping[str, type[Spec]]) -> Message:
        """What to say of a kind that there is not in a section, though perhaps in the other one."""
        if section == "connections":
            what, other, others = Message("connection"), "loads", cast("Mapping[str, type[Spec]]", Load.kinds)
        else:
            what, other, others = Message("load"), "connections", cast("Mapping[str, type[Spec]]", Connection.kinds)
        if written_kind(kind, fields, others, space=self.names.space):
            return Message(
                "{kind} is no kind of {what}: it belongs under {section}", kind=kind, what=what, section=other
            )
        everything = {**kinds, **others}
        words = {folded(word): told for each in everything.values() for word, told in each.instead.items()}
        if (told := words.get(folded(kind))) is not None:
            return Message("{kind} is no kind of {what}: {told}", kind=kind, what=what, told=told)
        taking = sorted(
            name
            for name, each in everything.items()
            if kind in each.model_fields and (self.names.space or not each.space_only)
        )
        if len(taking) == 1:
            return Message(
                "{kind} is no kind of {what}; it is a field of {other}: {other}: {{..., {kind}: ...}}",
                kind=kind,
                what=what,
                other=taking[0],
            )
        hint = kind_meant(kind, kinds, kinds, space=self.names.space)
        return Message("{kind} is no kind of {what}.{hint}", kind=kind, what=what, hint=hint)

    def _too_short(self, kind: type[Spec], n: int, absent: Sequence[str], *path: str | int) -> None:
        """Who writes `force: [3 N, 4 N]` gives the first two fields without a word of it."""
        told = Message(
            "the list of {kind} is read as {given}; {what} is missing{example}",
            kind=kind.kind,
            given=listed([f.alias or name for name, f in list(kind.model_fields.items())[:n]], "{first} and {second}"),
            what=listed(absent, "{first} and {second}"),
            example=_example_of(kind),
        )
        self.names.problem(told, *path)

    def _completed(self, kind: type[Spec], given: dict[str, Any], absent: Sequence[str]) -> str:
        """', e.g. kind: {...}' with what is given and, for what is left out, what the example of the kind has: of a
        point that meets another one, that point of the ground that has the name of the entry."""
        own = _fields_of_example(kind)
        example = {} if own is None else kind.from_plain(own)
        meeting = cast("tuple[str, str] | None", getattr(kind, "meeting", None))
        entry = self.names.here[1] if len(self.names.here) > 1 else ""
        if meeting is not None and len(left := [field for field in meeting if field in absent]) == 1:
            example[left[0]] = f"{GROUND}.{entry}"
        known = {f.alias or n for n, f in kind.model_fields.items()}
        if not given.keys() & known or not {*absent} <= example.keys():
            return _example_of(kind)
        whole = {key: each for key, each in given.items() if key in known} | {key: example[key] for key in absent}
        return Message(", e.g. {example}", example=flow_text({kind.kind: whole})[1:-1])

    def _misnamed(
        self, kind: type[Spec], absent: Sequence[str], strange: Sequence[str], given: dict[str, Any], *path: str | int
    ) -> None:
        """Fields that there are not and fields that are left out. Who writes `from` for `first` makes one mistake, and
        so does who means another kind and gives nothing of what this one needs."""
        known = [f.alias or n for n, f in kind.model_fields.items()]
        alike = {key: tuple(difflib.get_close_matches(key, known, n=1, cutoff=0.6)) for key in strange}
        meant = {key: kind.meant(key) or alike[key] for key in strange}
        for key in strange:
            if key in kind.elsewhere:
                instead = kind.elsewhere[key]
                if next(k for k in strange if kind.elsewhere.get(k) == instead) == key:
                    told = Message("{what} has no {key}: {instead}", what=kind.kind, key=key, instead=instead)
                    self.names.problem(told, *path, key)
                continue
            hint = did_you_mean(key, known)
            if meant[key]:
                hint = Message(" Did you mean {x}?", x=listed(meant[key], "{first} and {second}"))
            elif absent:
                continue  # told with what is left out
            elif beside := [o for o in MEANT.get(key, ()) if kind in Shape.kinds.values() and o in _SPEEDS]:
                value = given[key]
                option = _SPEEDS[_is_of_turning(value)] if len(beside) > 1 else beside[0]
                written = value if option != "velocity" else [value, 0]
                hint = Message(" Beside it write {entry}", entry=flow_text({option: written})[1:-1])
            self.names.problem(Message("{what} has no {key}.{hint}", what=kind.kind, key=key, hint=hint), *path, key)
        left = [field for field in absent if not any(field in fields for fields in meant.values())]
        needed = [f.alias or name for name, f in kind.model_fields.items() if f.is_required()]
        is_another = left == needed and any(key in kind.elsewhere for key in strange)
        if not left or is_another:
            return
        others = [key for key in strange if not meant[key] and key not in kind.elsewhere]
        has_no = Message("has no {keys}; it ", keys=in_turn(others)) if others else ""
        told = Message(
            "{kind} {has_no}needs {what}; it takes {names}{example}",
            kind=kind.kind,
            has_no=has_no,
            what=listed(left),
            names=", ".join(known),
            example=self._completed(kind, given, left),
        )
        self.names.problem(told, *path)

    def _inside_a_kind(self, kind: type[Spec], inside: Sequence[str], value: Any, *path: str | int) -> None:
        """Keys of the entry that are written among the fields of its kind."""
        fields = {key: field for key, field in cast("dict[str, Any]", value).items() if key not in inside}
        lifted = {str(path[-1]): fields or None, **{key: value[key] for key in inside}}
        told = Message(
            "write {keys} beside {kind}, not inside it: {entry}",
            keys=listed(inside, "{first} and {second}"),
            kind=str(path[-1]),
            entry=flow_text(lifted),
        )
        self.names.problem(told, *path, inside[0])

    def belongs_inside(
        self, kind: type[Spec], word: str, entry: Mapping[str, Any], beside: Collection[str]
    ) -> list[str]:
        """Notes the keys of an entry that stand next to its kind, which is called by a word there, and are fields of
        it. beside: what may stand there."""
        fields = [f.alias or n for n, f in kind.model_fields.items()]
        inside = [
            key
            for key in entry
            if key not in (word, *beside) and (key in fields or kind.meant(key) or key in kind.elsewhere)
        ]
        if inside:
            example = _example_of(kind)
            if not any(key in kind.elsewhere for key in inside):
                meant = {key: found[0] if len(found := kind.meant(key)) == 1 else key for key in inside}
                if len({*meant.values()}) == len(inside):
                    given = kind.from_plain({meant[key]: entry[key] for key in inside})
                    whole = put_inside(kind, entry[word], given)
                    example = Message(", so {entry}", entry=flow_text({word: whole})[1:-1])
            told = Message(
                "what belongs to {kind} stands inside of it, not beside it: {keys}{example}",
                kind=kind.kind,
                keys=listed(inside, "{first} and {second}"),
                example=example,
            )
            self.names.problem(told, inside[0])
        return inside

    def _beside_a_kind(
        self, name: str, kind: type[Spec], word: str, entry: Mapping[str, Any], beside: Collection[str]
    ) -> None:
        """Keys that stand next to a kind: its own fields, which belong inside of it, or such as nothing has."""
        fields = [f.alias or n for n, f in kind.model_fields.items()]
        inside = self.belongs_inside(kind, word, entry, beside)
        for key in entry:
            if key not in (word, *beside, *inside):
                told = Message(
                    "{what} has no {key}; {kind} takes {names}{example}",
                    what=name,
                    key=key,
                    kind=kind.kind,
                    names=", ".join(fields),
                    example=_example_of(kind),
                )
                if close := difflib.get_close_matches(key, beside, n=1, cutoff=0.6):
                    told = Message("{what} has no {key}.{hint}", what=name, key=key, hint=did_you_mean(key, close))
                self.names.problem(told, key)

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
                    if len(own := [key for key in value if key in kinds]) == 1 < len(value):
                        self._beside_a_kind(name, kinds[own[0]], own[0], entry, beside)
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
