"""What is told of kinds and fields that there are not, or that stand elsewhere."""

from __future__ import annotations

import difflib
import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.errors import InputError
from freebody.language.document.writer import flow_text
from freebody.language.folded import folded
from freebody.language.sentences import Message, in_turn, listed
from freebody.language.units import ANGULAR_VELOCITY, parse_quantity
from freebody.loads.base import Load
from freebody.measures.geometry import GROUND
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.model.shapes.base import Shape
from freebody.model.spec import MEANT, Spec
from freebody.model.written_kinds import put_inside, takes, words_also, written_kind
from freebody.system.reading.examples import example_of, fields_of_example
from freebody.system.reading.vocabulary import slips


def kind_meant(
    key: str,
    kinds: Mapping[str, type[Spec]],
    known: Iterable[str],
    *,
    space: bool,
    fields: Collection[str] = (),
    data: Mapping[str, Any] | None = None,
) -> str:
    """' Did you mean x?' of kinds: what people call so (block: rectangle), of these those that have all fields that are
    given, else by how a name is spelt."""
    fits = {kind: spec for kind, spec in kinds.items() if space or not spec.space_only}
    if (joint := key.removesuffix("_joint")) in fits:
        return Message(" Did you mean {x}{example}?", x=joint, example=example_of(fits[joint], data))
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
        near = difflib.get_close_matches(key, known, n=1, cutoff=0.67)
        near = near or difflib.get_close_matches(key, words_also(fits), n=1, cutoff=0.8)
        return did_you_mean(key, near) if near else did_you_mean("", known)
    if len(called) == 1:
        return Message(" Did you mean {x}{example}?", x=called[0], example=example_of(fits[called[0]], data))
    if able and isinstance(fields, dict) and fields:
        first, *others = sorted(called, key=lambda kind: (len(fits[kind].model_fields), kind))
        return Message(
            " Write {entry}, or one of {names}",
            entry=flow_text({first: fields})[1:-1],
            names=", ".join(others),
        )
    return Message(" Did you mean one of {names}?", names=", ".join(called))


_SPEEDS = ("velocity", "angular_velocity")  # that stand beside a shape


def _is_of_turning(value: Any) -> bool:
    """Whether a value is how fast something turns."""
    try:
        return parse_quantity(value).dimension == ANGULAR_VELOCITY
    except (InputError, TypeError):
        return False


def _instead_of(kind: type[Spec], key: str) -> str | None:
    """What to write for a key that is another kind's, also by a word for it."""
    return next((kind.elsewhere[word] for word in (key, *MEANT.get(key, ())) if word in kind.elsewhere), None)


def _known(kind: type[Spec], fields: Mapping[str, Any]) -> list[str]:
    """Which of some fields a kind has."""
    return [key for key in fields if key in kind.model_fields or kind.meant(key) or key in kind.more_words]


class Faults:
    """What is told of a description that cannot be read."""

    names: Names
    data: dict[str, Any]

    def _kind_wanted(self, name: str, value: Any, kinds: Mapping[str, type[Spec]]) -> Message:
        """Who writes `gravity: g` gives the name of a kind and what belongs into it."""
        beside = [*cast("dict[str, Any]", self.data.get(str(self.names.here[0])) or {})] if self.names.here else []
        following = beside[beside.index(name) + 1] if name in beside[:-1] else ""
        if value is None and name not in kinds and following in kinds:
            return Message(
                "{name} is empty, and {kind}, which belongs to it, stands beside it: begin the line of {kind} with two "
                "more spaces",
                name=name,
                kind=following,
            )
        if name in kinds:
            is_sentence = (
                isinstance(value, str) and value[:1].isalpha() and " " in value and len(kinds[name].model_fields) > 1
            )
            example = fields_of_example(kinds[name], self.data) if value is None or is_sentence else value
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
        if isinstance(said := fields.get("type"), str):
            rest = {key: each for key, each in fields.items() if key != "type"}
            return self._no_kind("loads" if kinds is Load.kinds else "connections", said, rest, kinds)
        words = {word for key in (name, *fields) for word in folded(str(key)).split("_")}
        if near := [kind for kind in able if kind in words]:
            example = flow_text({near[0]: fields_of_example(kinds[near[0]], self.data)})
            return Message("say of which kind it is, e.g. {name}: {example}", name=name, example=example)
        if isinstance(value, str | int | float) and kinds is Load.kinds:
            return Message("say where it acts and which way, e.g. {name}: {value} down at BODY", name=name, value=value)
        known = sorted(able, key=lambda kind: -len(_known(kinds[kind], fields)))
        return Message(
            "give one kind, e.g. {name}: {{{hint}: ...}}; kinds: {names}",
            name=name,
            hint=known[0],
            names=", ".join(known if _known(kinds[known[0]], fields) else able),
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
        spoken = (folded(kind), *re.split(r"[\W_]+", folded(kind)))
        if (told := next((words[word] for word in spoken if word in words), None)) is not None:
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
        hint = kind_meant(kind, kinds, kinds, space=self.names.space, data=self.data)
        return Message("{kind} is no kind of {what}.{hint}", kind=kind, what=what, hint=hint)

    def _too_short(self, kind: type[Spec], n: int, absent: Sequence[str], *path: str | int) -> None:
        """Who writes `force: [3 N, 4 N]` gives the first two fields without a word of it."""
        told = Message(
            "the list of {kind} is read as {given}; {what} is missing{example}",
            kind=kind.kind,
            given=listed([f.alias or name for name, f in list(kind.model_fields.items())[:n]], "{first} and {second}"),
            what=listed(absent, "{first} and {second}"),
            example=example_of(kind, self.data),
        )
        self.names.problem(told, *path)

    def _completed(self, kind: type[Spec], given: dict[str, Any], absent: Sequence[str]) -> str:
        """', e.g. kind: {...}' with what is given and, for what is left out, what the example of the kind has: of a
        point that meets another one, that point of the ground that has the name of the entry."""
        known = {f.alias or n for n, f in kind.model_fields.items()}
        own = fields_of_example(kind, self.data, {key: each for key, each in given.items() if key in known})
        example = {} if own is None else kind.from_plain(own)
        meeting = cast("tuple[str, str] | None", getattr(kind, "meeting", None))
        entry = self.names.here[1] if len(self.names.here) > 1 else ""
        if meeting is not None and len(left := [field for field in meeting if field in absent]) == 1:
            other = meeting[0] if left[0] == meeting[1] else meeting[1]
            held = str(given.get(other))
            if kind.model_fields[other].is_required() and held.partition(".")[0] != GROUND:
                example[left[0]] = f"{GROUND}.{entry}"
        if not given.keys() & known or not {*absent} <= example.keys():
            return example_of(kind, self.data)
        whole = {key: each for key, each in given.items() if key in known} | {key: example[key] for key in absent}
        return Message(", e.g. {example}", example=flow_text({kind.kind: whole})[1:-1])

    def _misnamed(
        self, kind: type[Spec], absent: Sequence[str], strange: Sequence[str], given: dict[str, Any], *path: str | int
    ) -> None:
        """Fields that there are not and fields that are left out. Who writes `from` for `first` makes one mistake, and
        so does who means another kind and gives nothing of what this one needs."""
        known = [f.alias or n for n, f in kind.model_fields.items()]
        meant = {key: kind.meant(key) or self._alike(kind, key, known, given) for key in strange}
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
        given_by = [{*fields} | {each for word in fields for each in kind.meant(word)} for fields in meant.values()]
        left = [field for field in absent if not any(field in fields for fields in given_by)]
        if not left or any(key in kind.elsewhere for key in strange):
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

    def _alike(self, kind: type[Spec], key: str, known: Sequence[str], given: Mapping[str, Any]) -> tuple[str, ...]:
        """The field that is spelt most alike, by its own word or by a second one that means it: `form` is from."""
        second = {word: fields for word, fields in kind.second_words().items() if not {*fields} & given.keys()}
        able = [word for word in (*known, *second) if slips(folded(key), folded(word)) == 1]
        if len(able) == 1 and able[0] in second and len(key) > len("mu"):
            return (able[0],)
        return tuple(difflib.get_close_matches(key, known, n=1, cutoff=0.6))

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
        if inside and (said := kind.elsewhere.get(inside[0])) and len(inside) == 1:
            self.names.problem(
                Message("{what} has no {key}: {instead}", what=kind.kind, key=inside[0], instead=said), inside[0]
            )
        elif inside:
            example = example_of(kind, self.data)
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
                if (instead := _instead_of(kind, key)) is not None:
                    told = Message("{what} has no {key}: {instead}", what=kind.kind, key=key, instead=instead)
                    self.names.problem(told, key)
                    continue
                told = Message(
                    "{what} has no {key}; {kind} takes {names}{example}",
                    what=name,
                    key=key,
                    kind=kind.kind,
                    names=", ".join(fields),
                    example=example_of(kind, self.data),
                )
                if close := difflib.get_close_matches(key, beside, n=1, cutoff=0.6):
                    told = Message("{what} has no {key}.{hint}", what=name, key=key, hint=did_you_mean(key, close))
                self.names.problem(told, key)
