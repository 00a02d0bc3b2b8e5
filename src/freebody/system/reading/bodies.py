"""The sections `ground`, `frames` and `bodies`: what there is, and the points, lines and planes on it."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.document.writer import flow_text
from freebody.language.expression import ZERO, negate
from freebody.language.folded import folded
from freebody.language.sentences import Message, listed
from freebody.language.units import LENGTH
from freebody.measures.geometry import GROUND, Components
from freebody.model.chains import read_chain
from freebody.model.elements import BodyPart, BodyPlane, Edge, Line, RigidBody, Rotation
from freebody.model.names import placeholder
from freebody.model.noting import did_you_mean
from freebody.model.shapes.base import Build, Shape
from freebody.model.spec import MEANT, SAME
from freebody.model.written_kinds import written_kind
from freebody.system.reading.body_start import POSE_KEYS, start_of_body
from freebody.system.reading.copies import copied_names
from freebody.system.reading.faults import kind_meant
from freebody.system.reading.frames import read_frames
from freebody.system.reading.lines import read_line, read_plane
from freebody.system.reading.sections import CALLED_LINES, OF_LINES, PLANAR_OPTIONS, SAYS_KIND, SPATIAL_OPTIONS
from freebody.system.reading.source import Source, known_keys
from freebody.system.reading.two_places import distance_of_ends

_LIES = ("on", "lies_on", "rests_on")
_ROLLS = ("rolls_on", "rolling_on", "rolls")
_FLAT = ("floor", "table", "road", "street", "Boden", "Tisch", "Fahrbahn")
_ENDS_IN_WORDS = {"von": "from", "nach": "to", "start": "from", "end": "to"}
_SHOWN = 4  # of shapes that fit


class BodySections:
    """Reads the bodies, the ground among them, into the names of a model."""

    def __init__(self, source: Source) -> None:
        self.source, self.names = source, source.names

    def read(self) -> None:
        names = self.names
        names.bodies[GROUND] = RigidBody(GROUND, ZERO, ZERO, {"origin": names.origin}, "origin", fixed=True)
        self.ground()
        read_frames(self.source, first=True)
        for name, value in self.source.named("bodies").items():
            if name == GROUND:
                names.problem(Message("ground is always there; declare its points under ground"), "bodies", name)
                names.broken.add(name)
                continue
            with names.at("bodies", name):
                # a body that cannot be read still counts as known, so that its mistake is told once
                names.bodies[name] = self.body(name, value) or placeholder(name)
        read_frames(self.source, first=False)
        for name, body in list(names.bodies.items()):
            section = ("ground",) if name == GROUND else ("bodies", name)
            entry = self.source.data.get("ground") if name == GROUND else self.source.mapping("bodies").get(name)
            given = cast("dict[str, Any]", entry) if isinstance(entry, dict) else {}
            with names.at(*section):
                for line_name, spec in self._each(given, "lines"):
                    body.lines[line_name] = self.line(body, line_name, spec)
                for plane_name, spec in self._each(given, "planes") if names.space else ():
                    body.planes[plane_name] = self.plane(body, plane_name, spec)

    def _each(self, entry: dict[str, Any], key: str) -> Iterator[tuple[str, Any]]:
        """The entries of a mapping in an entry, with problems noted at their places."""
        found = entry.get(key)
        for name, spec in cast("dict[str, Any]", found).items() if isinstance(found, dict) else ():
            with self.names.at(key, name):
                yield name, spec

    def line(self, body: RigidBody, name: str, spec: Any) -> Line:
        return read_line(self.names, body, name, spec)

    def plane(self, body: RigidBody, name: str, spec: Any) -> BodyPlane:
        return read_plane(self.names, body, name, spec)

    def ground(self) -> None:
        entry = self.source.mapping("ground")
        ground = self.names.bodies[GROUND]
        known = ("points", "lines", "planes") if self.names.space else ("points", "lines")
        for key, value in entry.items():
            if key not in known and self._is_line(key, value):
                fields = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
                line = {"along": fields.get("along", fields.get("angle", "right"))}
                if isinstance(value, int | float) and not isinstance(value, bool):
                    line = {"angle": f"{value} deg"}
                others = {name: each for name, each in fields.items() if name not in OF_LINES}
                hint: Message | str = ""
                if others:
                    contact = {"contact": {"between": ["BODY", key], **others}}
                    hint = Message("; what else stands there is that of {contact}", contact=flow_text(contact)[1:-1])
                told = Message(
                    "a line of the ground stands under lines: ground: {{lines: {{{name}: {line}}}}}{hint}",
                    name=key,
                    line=flow_text(line),
                    hint=hint,
                )
                self.names.problem(told, "ground", key)
                self.names.broken.add(key)
        entry = self._with_points({key: value for key, value in entry.items() if key not in self.names.broken}, known)
        known_keys(self.names, entry, known, "ground", "ground")
        for name in self._floors(ground):
            told = Message("{name} is not declared: it is the horizontal line through the origin", name=name)
            if self.names.space:
                ground.planes[name] = read_plane(self.names, ground, name, {"normal": "up"})
                told = Message("{name} is not declared: it is the horizontal plane through the origin", name=name)
            else:
                ground.lines[name] = read_line(self.names, ground, name, {"along": "right"})
            self.names.assumptions.append(told)
        with self.names.at("ground"):
            points = self.source.open.points(entry.get("points"), GROUND, ground.points.__contains__) or {}
            for name, value in points.items():
                ground.points[name] = self.names.components(value, LENGTH, "points", name)

    def _floors(self, ground: RigidBody) -> list[str]:
        """Floors that connections name and nobody declares."""
        given = self.source.mapping("ground")
        owned = [value for key in ("points", "lines", "planes") if isinstance(value := given.get(key), dict | list)]
        taken = {name for value in owned for name in value if isinstance(name, str)} | self.names.bodies.keys()
        taken |= (
            given.keys() | self.source.mapping("bodies").keys() | ground.lines.keys() | self.names.parameters.keys()
        )
        named = {text.removeprefix(f"{GROUND}.") for text in _texts(self.source.data.get("connections"))}
        return [name for name in _FLAT if name in named and name not in taken]

    def _with_points(self, entry: dict[str, Any], known: Collection[str]) -> dict[str, Any]:
        """`ground: {A: [0, 0]}` with its places among the points of the ground."""
        n = len(self.names.origin)
        own = {
            key: value
            for key, value in entry.items()
            if key not in known and isinstance(value, list) and len(cast("list[Any]", value)) in (2, n)
        }
        points = entry.get("points") or {}
        if not own or not isinstance(points, dict) or own.keys() & cast("dict[str, Any]", points).keys():
            return entry
        rest = {key: value for key, value in entry.items() if key not in own}
        return rest | {"points": {**cast("dict[str, Any]", points), **own}}

    def _is_line(self, key: str, value: Any) -> bool:
        """Whether an entry of the ground is one of its lines, without the section in which these stand."""
        fields = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
        return not self.names.space and (
            (key in CALLED_LINES and not isinstance(value, list)) or (bool(fields) and fields.keys() <= {*OF_LINES})
        )

    def body(self, name: str, value: Any) -> RigidBody | None:
        names = self.names
        if isinstance(value, str) and self._kind(value, None):
            value = {value: None}
        if value == GROUND:
            names.problem(
                Message(
                    "the ground is a body already, and {name} may be a line of it: ground: {{lines: {{{name}: {{along: "
                    "right}}}}}}, then ground.{name}",
                    name=name,
                )
            )
            return None
        if value is None and (shape := self._shape_below(name)) is not None:
            told = Message(
                "{key} is not indented, so that {section} is empty: begin the line of {key} with two spaces more",
                key=shape,
                section=name,
            )
            names.problem(told)
            return None
        if not isinstance(value, dict):
            names.problem(Message("say what {name} is, e.g. {name}: {{disk: {{mass: m, radius: R}}}}", name=name))
            return None
        entry = self._with_ends(self._as_options(cast("dict[str, Any]", value)))
        shape, word = self._shape(name, entry)
        if shape is None:
            with names.quietly():  # the angles that it would name
                chain = read_chain(names, entry.get("turned", []), named=True)
            names.broken |= {turn.name for turn in chain if turn.name}
            return None
        names.called[name] = shape.words()
        if "length" in shape.lengths_left_open() and getattr(shape, "length", None) is None:
            length = distance_of_ends(names, entry.get("at"))
            shape = shape if length is None else shape.model_copy(update={"length": length})
        with names.at(word):
            build = self.source.open.completed(shape, name, word).build(names)
        offsets = self._offsets(name, entry, build)
        fixed = bool(entry.get("fixed", False))
        if fixed:
            entry = self._held_in_place(entry)
        chain, frame = self._chain(name, entry, fixed=fixed) if names.space else ((), GROUND)
        start = start_of_body(names, entry, build.default_point, offsets)
        if fixed and start.moves:
            names.problem(
                Message("{name} is fixed, so it has no velocity at the start: leave out one of the two", name=name),
                "fixed",
            )
        outline, own = self._outline(entry, offsets), entry.get("points")
        sides = build.sides if not own else {side: d for side, d in build.sides.items() if side not in own}
        return RigidBody(
            name,
            build.mass,
            build.inertia,
            offsets,
            build.default_point,
            radius=build.radius,
            turns=build.turns,
            fixed=fixed,
            start=start,
            corners=outline or build.corners,
            sides={} if outline else sides,
            copies=copied_names(names, name, entry.get("copies"), self.source.mapping("bodies")),
            is_ring=build.is_ring,
            teeth=build.teeth,
            has_inner_teeth=build.has_inner_teeth,
            edges=tuple(self._edge_from_mass_center(edge, build) for edge in build.edges),
            circles=build.circles,
            parts=tuple(self._part_from_mass_center(part, build) for part in build.parts),
            solid_parts=tuple(
                replace(part, center=tuple(a - b for a, b in zip(part.center, build.center_of_mass, strict=True)))
                for part in build.solid_parts
            ),
            tensor=build.tensor,
            round=build.round,
            axis=build.axis,
            chain=chain,
            frame=frame,
            solid=build.solid,
            sizes=build.sizes,
            inner=build.inner,
            faces=build.faces,
        )

    def _as_options(self, entry: dict[str, Any]) -> dict[str, Any]:
        """What stands beside the shape, by the names of it where the file has other words: `position` is `at`."""
        options = SPATIAL_OPTIONS if self.names.space else PLANAR_OPTIONS
        read: dict[str, Any] = {}
        for key, value in entry.items():
            same = key in SAME and key not in options and key != "on"  # it is on something: that is a contact
            meant = [field for field in MEANT.get(key, ()) if field in options and same]
            read[meant[0] if len(meant) == 1 and meant[0] not in (*entry, *read) else key] = value
        return read

    def _with_ends(self, entry: dict[str, Any]) -> dict[str, Any]:
        """`{bar: {from: A, to: B}}` as the same with the places of its ends beside the shape."""
        for word, value in entry.items():
            fields = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
            fields = {_ENDS_IN_WORDS.get(key, key): each for key, each in fields.items()}
            given = [key for key in ("from", "to") if key in fields]
            if "at" in entry or not given or (kind := self._kind(word, fields)) is None:
                continue
            if ends := Shape.kinds[kind].ends:
                own = {key: each for key, each in fields.items() if key not in given}
                places = {end: fields[key] for end, key in zip(ends, ("from", "to"), strict=True) if key in given}
                return {**entry, word: own or None, "at": places}
        return entry

    def _shape_below(self, name: str) -> str | None:
        """The shape that stands in the next line as a body of its own."""
        called = [*self.source.mapping("bodies")]
        below = called[called.index(name) + 1 :][:1]
        return below[0] if below and below[0] in Shape.kinds else None

    def _kind(self, word: str, value: Any) -> str | None:
        return written_kind(word, value, Shape.kinds, space=self.names.space)

    def _shape(self, name: str, entry: dict[str, Any]) -> tuple[Shape | None, str]:
        """The one shape that a body has, and the word for it; problems are noted where there is none, and for keys that
        mean nothing."""
        names = self.names
        options = SPATIAL_OPTIONS if names.space else PLANAR_OPTIONS
        kinds = {k: kind for k, value in entry.items() if k not in options and (kind := self._kind(k, value))}
        fields = {key: value for key, value in entry.items() if key not in options and key not in kinds}
        said = next((key for key in SAYS_KIND if not kinds and isinstance(fields.get(key), str)), None)
        if said is not None:
            word = fields.pop(said)
            own = {key: value for key, value in fields.items() if self._is_of_shapes(key)}
            hint = kind_meant(word, Shape.kinds, Shape.kinds, space=names.space, fields=own, data=self.source.data)
            names.problem(Message("there is no shape {word}.{hint}", word=word, hint=hint), said)
            return None, ""
        own = {key: value for key, value in fields.items() if self._is_of_shapes(key)}
        if not kinds and own and (able := self._able(name, own)):
            names.problem(
                Message(
                    "{name} needs a shape with these fields: {name}: {{{shape}: {fields}}}{others}",
                    name=name,
                    shape=able[0],
                    fields=flow_text(own),
                    others=Message(" (or {names})", names=", ".join(able[1:_SHOWN])) if len(able) > 1 else "",
                )
            )
            return None, ""
        inside: list[str] = []
        if len(kinds) == 1:
            ((word, kind),) = kinds.items()
            inside = self.source.belongs_inside(Shape.kinds[kind], word, entry, (*options, *MEANT.get("at", ())))
        for key, value in entry.items():
            if key not in kinds and key not in options and key not in inside:
                known = [*Shape.kinds, *options]
                fields = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
                hint = kind_meant(key, Shape.kinds, known, space=names.space, fields=fields, data=self.source.data)
                if key in SPATIAL_OPTIONS:
                    hint = Message(" It is for models in space: write space: true.")
                if key in ("acceleration", "Beschleunigung"):
                    law = {"driver": {"measure": f"x of {name}", "follows": f"({value})*t^2/2"}}
                    entries: dict[str, Any] = {f"drive_of_{name}": law}
                    if re.search(rf"\b{re.escape(name)}\b", str(self.source.mapping("connections"))) is None:
                        entries = {f"guide_of_{name}": {"slider": {"body": name, "along": "right"}}, **entries}
                    hint = Message(
                        " A motion that is prescribed is a driver: connections: {{{entry}}}",
                        entry=flow_text(entries)[1:-1],
                    )
                if key == "massless":
                    hint = Message(" A body is massless where no mass is given, as in {{disk: {{radius: 0.1 m}}}}.")
                if key == "angle":
                    hint = Message(" In space write how it is turned, e.g. turned: 30 deg about z.")
                if folded(key) in _ROLLS:
                    hint = Message(
                        " How it rolls is a connection: connections: {{{entry}}}",
                        entry=flow_text({f"{name}_on_{value}": {"rolling": {"body": name, "on": value}}})[1:-1],
                    )
                elif key in _LIES:
                    where = {"between": [name, value]}
                    hint = Message(
                        " Where it lies is a connection: connections: {{{entry}}}",
                        entry=flow_text({f"{name}_on_{value}": {"contact": where}})[1:-1],
                    )
                elif written_kind(key, None, Connection.kinds, space=names.space):
                    ends = [value if isinstance(value, list) else f"{GROUND}.{name}_{key}", f"{name}.POINT"]
                    hint = Message(
                        " How it is held is a connection, with the point that is held: connections: {{{entry}}}",
                        entry=flow_text({f"{name}_{key}": {key: ends}})[1:-1],
                    )
                elif meant := [field for field in MEANT.get(key, ()) if field in options]:
                    hint = Message(" Did you mean {x}?", x=meant[0])
                names.problem(Message("{what} has no {key}.{hint}", what=Message("a body"), key=key, hint=hint), key)
        if len(kinds) > 1:
            told = Message(
                "{name} has more than one shape: {kinds}. Keep one; a body of several parts is a composite",
                name=name,
                kinds=listed([*kinds]),
            )
            names.problem(told)
        elif not kinds and entry.keys() <= {*options}:  # else a shape may be among the keys that mean nothing
            what = Message("one of {names}", names=", ".join(Shape.kinds))
            names.problem(Message("{name} needs a shape: {what}", name=name, what=what))
        if len(kinds) != 1:
            return None, ""
        ((word, kind),) = kinds.items()
        return self.source.spec(Shape.kinds[kind], entry[word], word, beside=options), word

    def _is_of_shapes(self, key: str) -> bool:
        """Whether a key is a field of some shape."""
        return any(key in kind.model_fields or kind.meant(key) for kind in Shape.kinds.values())

    def _able(self, name: str, fields: Collection[str]) -> list[str]:
        """Shapes that take all these fields: what the body is called (pulley: a disk), then those for which people have
        a word, each the plainest first; others where there are none of these."""
        kinds = {kind: spec for kind, spec in Shape.kinds.items() if self.names.space or not spec.space_only}
        able = [kind for kind, spec in kinds.items() if set(fields) <= set(spec.model_fields)]
        called = name.rstrip("_0123456789")

        def rank(kind: str) -> tuple[object, ...]:
            spec = kinds[kind]
            is_meant = called in (kind, *spec.called)
            return not is_meant, not spec.also, len(spec.model_fields), kind

        plain = [kind for kind in able if kinds[kind].also or not rank(kind)[0]]
        return sorted(plain or able, key=rank)

    def _offsets(self, name: str, entry: dict[str, Any], build: Build) -> dict[str, Components]:
        """The points of a body, from its mass centre."""
        names = self.names
        middle = self._full(build.center_of_mass)
        own = {build.default_point: names.origin} | {key: self._full(at) for key, at in build.points.items()}
        for point, pair in (self.source.open.points(entry.get("points"), name, own.__contains__) or {}).items():
            own[point] = names.components(pair, LENGTH, "points", point)
        offsets = {k: self._from_mass_center(at, middle) for k, at in own.items()}
        offsets["mass_center"] = names.origin
        offsets.setdefault("center", names.origin)
        return offsets

    def _from_mass_center(self, at: Components, middle: Components) -> Components:
        return tuple(c + negate(m) for c, m in zip(self._full(at), middle, strict=True))

    def _part_from_mass_center(self, part: BodyPart, build: Build) -> BodyPart:
        return replace(part, center=tuple(c - m for c, m in zip(part.center, build.center_of_mass, strict=True)))

    def _edge_from_mass_center(self, edge: Edge[Components], build: Build) -> Edge[Components]:
        middle = self._full(build.center_of_mass)
        return replace(edge, places=tuple(self._from_mass_center(at, middle) for at in edge.places))

    def _held_in_place(self, entry: dict[str, Any]) -> dict[str, Any]:
        """A fixed body is where it is said to be near: nothing is left to search for."""
        near = cast("dict[str, Any]", entry["near"]) if isinstance(entry.get("near"), dict) else {}
        if not near.keys() <= set(POSE_KEYS[self.names.space]):  # told where the start is read
            return entry
        return {**near, **{key: value for key, value in entry.items() if key != "near"}}

    def _full(self, at: Components) -> Components:
        """Components as the model has them: a point of a flat shape lies in its plane."""
        return (*at, *self.names.origin[len(at) :])

    def _chain(self, name: str, entry: dict[str, Any], *, fixed: bool) -> tuple[tuple[Rotation, ...], str]:
        """`turned: [psi about y, theta about x]`, where some of the angles are new names."""
        names = self.names
        frame = str(entry.get("frame", GROUND))
        if frame not in self.source.mapping("bodies") and frame != GROUND:
            names.problem(
                Message(
                    "there is no body {name}.{hint}",
                    name=frame,
                    hint=did_you_mean(frame, self.source.mapping("bodies")),
                ),
                "frame",
            )
            return (), GROUND
        chain = read_chain(names, entry.get("turned", []), "turned", named=not fixed)
        if not any(turn.name for turn in chain):
            if frame != GROUND:
                names.problem(
                    Message(
                        "a known rotation at the start counts from the ground; name the angles to count from "
                        "frame, e.g. turned: [psi about y], frame: shaft"
                    ),
                    "frame",
                )
            return (), GROUND
        return chain, frame

    def _outline(self, entry: dict[str, Any], points: Mapping[str, Any]) -> tuple[str, ...]:
        """`outline: [P, Q, R]`: points of the body that are the corners of what touches others."""
        given = entry.get("outline")
        if given is None:
            return ()
        if not isinstance(given, list) or len(cast("list[Any]", given)) < 2:
            told = Message(
                "outline is a list of points of the body, e.g. outline: [P, Q, R]; what is round is a disk, which may "
                "be given its moment of inertia: {{disk: {{mass: m, radius: R, inertia: J}}}}"
            )
            self.names.problem(told, "outline")
            return ()
        corners = [str(name) for name in cast("list[Any]", given)]
        for k, name in enumerate(corners):
            if name not in points:
                self.names.problem(
                    Message("there is no point {name}.{hint}", name=name, hint=did_you_mean(name, points)),
                    "outline",
                    k,
                )
        return tuple(corners) if all(name in points for name in corners) else ()


def _texts(value: Any) -> Iterator[str]:
    """All texts of an entry."""
    if isinstance(value, dict):
        for each in cast("dict[str, Any]", value).values():
            yield from _texts(each)
    elif isinstance(value, list):
        for each in cast("list[Any]", value):
            yield from _texts(each)
    elif isinstance(value, str):
        yield value
