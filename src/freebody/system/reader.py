"""Reads a model document into a System. All problems are gathered and reported in one message."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any, TypeVar, cast

from pydantic import ValidationError

from freebody.connections.base import Connection
from freebody.connections.contact import Contact, OutlinePair
from freebody.connections.planar import Planar
from freebody.errors import InputError, ModelError, Problem
from freebody.language.document import Document
from freebody.language.expression import ZERO, Expr, free_symbols, name_problem, negate, replace_rates, substitute
from freebody.language.natural import natural
from freebody.language.plain_text import plain
from freebody.language.units import (
    ANGULAR_VELOCITY,
    DIMENSIONLESS,
    ENERGY,
    LENGTH,
    TIME,
    VELOCITY,
    parse_quantity,
    parse_unit,
)
from freebody.loads.base import Load
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, Components
from freebody.model.carriers import is_distance_kept
from freebody.model.chains import read_chain
from freebody.model.elements import (
    RATE,
    VALUE,
    AppliedLoad,
    Attitude,
    BodyPlane,
    ConstraintRow,
    DryFriction,
    Line,
    Parameter,
    RigidBody,
    Rotation,
    Sign,
    Start,
    UnilateralConstraint,
)
from freebody.model.named_angles import angles_of
from freebody.model.names import Names, did_you_mean, placeholder
from freebody.model.phrases import read_measure
from freebody.model.rotations import UNIT, columns_of, product
from freebody.model.shapes import Shape
from freebody.model.spec import Spec
from freebody.questions.reading import read_questions
from freebody.system.description import SystemDescription
from freebody.system.unspecified import Unspecified

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
    "start",
    "questions",
)
_POSE_KEYS = {False: ("at", "angle"), True: ("at", "turned")}  # what says where a body is: in the plane, in space
BODY_OPTIONS = ("at", "angle", "near", "velocity", "angular_velocity", "points", "lines", "fixed", "outline")
SPATIAL_OPTIONS = (
    "at",
    "turned",
    "frame",
    "near",
    "velocity",
    "angular_velocity",
    "points",
    "lines",
    "planes",
    "fixed",
)
MOST_ASKED = 40
_HALF_TURN = 1.5707963267948966

SpecT = TypeVar("SpecT", bound=Spec)


def register_kinds() -> None:
    """Imports every file of connections, loads, questions and shapes, each of which registers its kind."""
    import_module("freebody.connections")
    import_module("freebody.loads")
    import_module("freebody.questions")
    import_module("freebody.model.composite")


class Reader:
    """Reads a document into a System, noting problems in `names`."""

    def __init__(self, document: Document, file: str | None) -> None:
        register_kinds()
        self.document = document
        self.file = file
        self.data = document.data
        self.names = Names()
        self.open = Unspecified(self.names, self.data)

    def _title(self) -> str:
        """On one line; without one the name of the file."""
        stem = Path(self.file).stem if self.file else ""
        return plain(str(self.data.get("title") or stem)).strip() or "untitled"

    def system(self) -> SystemDescription:
        self._sections()
        self._space()
        self._parameters()
        self._bodies()
        connections = self._specs("connections", Connection.kinds)
        # by name: which of several leads, guides or carries something hangs on no order of the file
        self.names.connections = {name: connections[name] for name in sorted(connections, key=natural)}
        loads = self._specs("loads", Load.kinds)
        measures = self._measures()
        pushes = self.names.pushes = self._pushes(loads)
        held, offered = self._held(connections)
        contacts, limits, brakes = self._bounds(connections)
        start, rates = self._start(measures)
        mode = self._mode()
        self.names.held = [*held, *_rows_to_ask_for(contacts, limits, brakes)]
        self.names.loads = {p.load: ENERGY / p.measure.dimension for p in pushes}
        questions = read_questions(self.names, self.data.get("questions"))
        self._ground_points()
        if self.names.problems:
            located = [self.document.locate(p) for p in self.names.problems]
            located.sort(key=lambda p: (p.line or 0, p.column or 0))
            raise ModelError(located, self.file)
        return SystemDescription(
            title=self._title(),
            about=plain(str(self.data.get("about") or "")).strip(),
            parameters=self.names.parameters,
            bodies=self.names.bodies,
            held=tuple(held),
            pushes=tuple(pushes),
            measures=measures,
            offered=tuple(offered),
            start=start,
            start_rates=rates,
            questions=questions,
            connections=connections,
            loads=loads,
            assumptions=tuple(dict.fromkeys(self.names.assumptions)),
            document=self.document,
            file=self.file,
            unspecified=self.open.places,
            mode=mode,
            contacts=contacts,
            limits=limits,
            brakes=brakes,
            space=self.names.space,
            up=self.names.up,
            frames=self.names.frames,
            names=self.names,
            attitudes=self._attitudes(connections),
        )

    # -- sections -----------------------------------------------------------------------------
    def _sections(self) -> None:
        for key in self.data:
            if key not in SECTIONS:
                self.names.problem(f"there is no section {key}.{did_you_mean(key, SECTIONS)}", None, key)
        version = self.data.get("freebody", 1)
        if version != 1:
            self.names.problem(
                f"this is freebody's file format {version!r}; this version reads format 1", None, "freebody"
            )
        if not self.data.get("bodies"):
            self.names.problem("a model needs at least one body, under bodies", None, "bodies")

    def _space(self) -> None:
        """`space: true`: three dimensions, y up; `space: {up: z}` for another vertical."""
        entry = self.data.get("space")
        names = self.names
        if isinstance(entry, dict):
            up = cast("dict[str, Any]", entry).get("up", "y")
            for key in cast("dict[str, Any]", entry):
                if key != "up":
                    names.problem(f"space has no {key}.{did_you_mean(key, ('up',))}", None, "space", key)
            if up not in ("x", "y", "z"):
                names.problem("up is x, y or z", None, "space", "up")
                up = "y"
            names.space, names.up = True, UNIT["xyz".index(up)]
        elif entry is True:
            names.space, names.up = True, UNIT[1]
        elif entry not in (None, False):
            names.problem("space is true, or {up: z} for another vertical than y", None, "space")

    def _mapping(self, section: str) -> dict[str, Any]:
        value = self.data.get(section)
        if value is None:
            return {}
        if not isinstance(value, dict):
            self.names.problem(f"{section} must be a mapping of names, e.g. {section}: {{a: ...}}", None, section)
            return {}
        return cast("dict[str, Any]", value)

    def _named(self, section: str) -> dict[str, Any]:
        """The entries of a section whose names can be used."""
        good: dict[str, Any] = {}
        for name, value in self._mapping(section).items():
            fault = name_problem(name)
            if fault is not None or (name == "t" and section in ("parameters", "measures")):
                self.names.problem(fault or "t is the time; choose another name", None, section, name)
                continue
            good[name] = value
        return good

    def _parameters(self) -> None:
        functions: dict[str, dict[str, Any]] = {}
        for name, value in self._named("parameters").items():
            with self.names.at("parameters", name):
                if isinstance(value, dict) and "function" in value:
                    functions[name] = cast("dict[str, Any]", value)
                else:
                    self.names.parameters[name] = self._parameter(name, value)
        for name, entry in functions.items():
            with self.names.at("parameters", name):
                self.names.parameters[name] = self._function(name, entry)

    def _function(self, name: str, entry: dict[str, Any]) -> Parameter:
        """`x0: {function: v*t, unit: m}`: a function of time. Formulas keep it general; numbers need its form."""
        for key in entry:
            if key not in ("function", "unit", "about"):
                known = ("function", "unit", "about")
                self.names.problem(f"a function of time has no {key}.{did_you_mean(key, known)}", None, key)
        unit = str(entry.get("unit") or "")
        try:
            quantity = parse_unit(unit) if unit else None
        except InputError as error:
            self.names.problem(str(error), None, "unit")
            self.names.broken.add(name)
            quantity = None
        dimension = DIMENSIONLESS if quantity is None else quantity.dimension
        form = self.names.formula(entry["function"], dimension, "function", extra={"t": TIME})
        used = sorted(p for p in free_symbols(form) if p in self.names.parameters and self.names.parameters[p].form)
        if used:
            self.names.problem(f"{used[0]} is a function of time itself; write {name} in t and parameters")
        is_angle = quantity is not None and quantity.is_angle
        return Parameter(name, dimension, None, "any", unit=unit, is_angle=is_angle, form=form)

    def _parameter(self, name: str, value: Any) -> Parameter:
        sign: Sign = "positive"
        unit: str | None = None
        if isinstance(value, dict):
            entry = cast("dict[str, Any]", value)
            for key in entry:
                if key not in ("value", "unit", "sign", "about"):
                    known = ("value", "unit", "sign", "about")
                    self.names.problem(f"a parameter has no {key}.{did_you_mean(key, known)}", None, key)
            if entry.get("sign", "positive") not in ("positive", "nonnegative", "any"):
                self.names.problem(f"sign is positive, nonnegative or any, not {entry['sign']!r}", None, "sign")
            else:
                sign = entry.get("sign", "positive")
            unit, value = entry.get("unit"), entry.get("value")
        try:
            if value is None:
                dimension = parse_unit(unit).dimension if unit else DIMENSIONLESS
                return Parameter(name, dimension, None, sign, unit=unit or "")
            text = f"{value} {unit}" if unit else value
            quantity = parse_quantity(text)
        except (InputError, TypeError) as error:
            return self._parameter_without_number(name, value, sign, error)
        if sign == "positive" and quantity.value <= 0:
            self.names.problem(
                f"{name} = {value} is not positive; parameters are positive unless the model says "
                f"otherwise: {name}: {{value: {value}, sign: any}}"
            )
        if sign == "nonnegative" and quantity.value < 0:
            self.names.problem(f"{name} = {value} is negative, but its sign is given as nonnegative")
        acute = quantity.is_angle and sign == "positive" and 0 < quantity.value < _HALF_TURN
        shown = str(text).split(maxsplit=1)[1] if " " in str(text).strip() else ""
        return Parameter(name, quantity.dimension, quantity.value, sign, acute, shown, quantity.is_angle)

    def _parameter_without_number(self, name: str, value: Any, sign: Sign, error: Exception) -> Parameter:
        """`m: kg` declares a symbol with a unit and no value."""
        if isinstance(value, str):
            try:
                unit = parse_unit(value)
            except InputError:
                pass
            else:
                return Parameter(
                    name,
                    unit.dimension,
                    None,
                    sign,
                    unit.is_angle and sign == "positive",
                    value,
                    unit.is_angle,
                )
        self.names.problem(f"{error}. Write for example {name}: 3 kg, {name}: 0.5, or {name}: kg for a symbol")
        self.names.broken.add(name)
        return Parameter(name, DIMENSIONLESS, None, sign)

    # -- bodies -------------------------------------------------------------------------------
    def _bodies(self) -> None:
        names = self.names
        names.bodies[GROUND] = RigidBody(GROUND, ZERO, ZERO, {"origin": names.origin}, "origin", fixed=True)
        self._ground()
        self._frames(first=True)
        for name, value in self._named("bodies").items():
            if name == GROUND:
                names.problem("ground is always there; declare its points under ground", None, "bodies", name)
                continue
            with names.at("bodies", name):
                # a body that cannot be read still counts as known, so that its mistake is told once
                names.bodies[name] = self._body(name, value) or placeholder(name)
        self._frames(first=False)
        for name, body in list(names.bodies.items()):
            section = ("ground",) if name == GROUND else ("bodies", name)
            entry = self.data.get("ground") if name == GROUND else self._mapping("bodies").get(name)
            lines = cast("dict[str, Any]", entry).get("lines") if isinstance(entry, dict) else None
            if isinstance(lines, dict):
                with names.at(*section, "lines"):
                    for line_name, spec in cast("dict[str, Any]", lines).items():
                        with names.at(line_name):
                            body.lines[line_name] = self._line(body, line_name, spec)
            planes = cast("dict[str, Any]", entry).get("planes") if isinstance(entry, dict) else None
            if isinstance(planes, dict) and names.space:
                with names.at(*section, "planes"):
                    for plane_name, spec in cast("dict[str, Any]", planes).items():
                        with names.at(plane_name):
                            body.planes[plane_name] = self._plane(body, plane_name, spec)

    def _ground(self) -> None:
        entry = self._mapping("ground")
        ground = self.names.bodies[GROUND]
        for key in entry:
            known = ("points", "lines", "planes") if self.names.space else ("points", "lines")
            if key not in known:
                self.names.problem(f"ground has no {key}.{did_you_mean(key, known)}", None, "ground", key)
        with self.names.at("ground"):
            points = self.open.points(entry.get("points"), GROUND, ground.points.__contains__) or {}
            for name, value in points.items():
                ground.points[name] = self.names.components(value, LENGTH, "points", name)

    def _frames(self, *, first: bool) -> None:
        """`frames: {tilted: {on: shaft, turned: beta about z}}`: axes fixed in a body. Those on the ground are known
        before the bodies are, the others after."""
        names = self.names
        entries = self._named("frames")
        if entries and not names.space:
            if first:
                names.problem("frames are for models in space: write space: true", None, "frames")
            return
        for name, value in entries.items():
            entry = cast("dict[str, Any]", value) if isinstance(value, dict) else {"turned": value}
            on = str(entry.get("on", GROUND))
            is_early = on == GROUND or on in names.frames
            if is_early != first and not (not first and name not in names.frames):
                continue
            with names.at("frames", name):
                for key in entry:
                    if key not in ("on", "turned"):
                        names.problem(f"a frame has no {key}.{did_you_mean(key, ('on', 'turned'))}", None, key)
                if name in self._mapping("bodies") or name == GROUND:
                    names.problem(f"{name} is a body already; choose another name")
                chain = read_chain(names, entry.get("turned", []), "turned", named=False)
                body, axes = names.frames.get(on) or (names.body(on, "on").name, UNIT)
                names.frames[name] = body, product(axes, columns_of(chain))

    def _plane(self, body: RigidBody, name: str, spec: Any) -> BodyPlane:
        names = self.names
        entry = cast("dict[str, Any]", spec) if isinstance(spec, dict) else {"normal": spec}
        for key in entry:
            if key not in ("through", "normal"):
                names.problem(f"a plane has no {key}.{did_you_mean(key, ('through', 'normal'))}", None, key)
        label = name if body.name == GROUND else f"{body.name}.{name}"
        normal = names.direction(entry.get("normal", "up"), "normal", body=body.name)
        through = entry.get("through")
        if isinstance(through, str):
            point = names.point(through if "." in through else f"{body.name}.{through}", "through")
        elif through is None:
            point = body.point()
        else:
            point = replace(body.point(), offset=names.components(through, LENGTH, "through"))
        return BodyPlane(point, replace(normal, name=f"normal of {label}"), label)

    def _line(self, body: RigidBody, name: str, spec: Any) -> Line:
        entry = cast("dict[str, Any]", spec) if isinstance(spec, dict) else {"along": spec}
        for key in entry:
            if key not in ("through", "along", "angle"):
                known = ("through", "along", "angle")
                self.names.problem(f"a line has no {key}.{did_you_mean(key, known)}", None, key)
        if "along" not in entry and "angle" not in entry:
            self.names.problem("a line needs a direction, e.g. {along: right} or {angle: -alpha}")
        along = self.names.direction(entry.get("along", entry.get("angle", 0)), "along", body=body.name)
        label = name if body.name == GROUND else f"{body.name}.{name}"
        direction = replace(along, name=label)
        through = entry.get("through")
        if isinstance(through, str):
            point = self.names.point(through, "through")
        elif through is None:
            point = body.point()
        else:
            point = replace(body.point(), offset=self.names.components(through, LENGTH, "through"))
        return Line(point, direction, label)

    def _body(self, name: str, value: Any) -> RigidBody | None:
        names = self.names
        if isinstance(value, str) and value in Shape.kinds:
            value = {value: None}
        if not isinstance(value, dict):
            names.problem(f"say what {name} is, e.g. {name}: {{disk: {{mass: m, radius: R}}}}")
            return None
        entry = cast("dict[str, Any]", value)
        kinds = [k for k in entry if k in Shape.kinds]
        options = SPATIAL_OPTIONS if names.space else BODY_OPTIONS
        for key in entry:
            if key not in Shape.kinds and key not in options:
                known = [*Shape.kinds, *options]
                hint = did_you_mean(key, known)
                if key in SPATIAL_OPTIONS:
                    hint = " It is for models in space: write space: true."
                if key == "angle":
                    hint = " In space write how it is turned, e.g. turned: 30 deg about z."
                names.problem(f"a body has no {key}.{hint}", None, key)
        if len(kinds) != 1:
            what = "one of " + ", ".join(Shape.kinds)
            names.problem(f"{name} needs a shape: {what}" if not kinds else f"{name} has two shapes: {kinds}")
            return None
        shape = self._spec(Shape.kinds[kinds[0]], entry[kinds[0]], kinds[0])
        if shape is None:
            return None
        with names.at(kinds[0]):
            build = self.open.completed(shape, name).build(names)
        middle = self._full(build.center_of_mass)
        own = {build.default_point: names.origin} | {key: self._full(at) for key, at in build.points.items()}
        for point, pair in (self.open.points(entry.get("points"), name, own.__contains__) or {}).items():
            own[point] = names.components(pair, LENGTH, "points", point)
        offsets = {k: tuple(c + negate(m) for c, m in zip(at, middle, strict=True)) for k, at in own.items()}
        offsets["mass_center"] = names.origin
        offsets.setdefault("center", names.origin)
        fixed = bool(entry.get("fixed", False))
        if fixed:
            entry = self._held_in_place(entry)
        chain, frame = self._chain(name, entry, fixed=fixed) if names.space else ((), GROUND)
        start = self._start_of_body(entry, build.default_point, offsets)
        if fixed and start.moves:
            names.problem(
                f"{name} is fixed, so it has no velocity at the start: leave out one of the two", None, "fixed"
            )
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
            corners=self._outline(entry, offsets) or build.corners,
            is_ring=build.is_ring,
            tensor=build.tensor,
            round=build.round,
            axis=build.axis,
            chain=chain,
            frame=frame,
            solid=build.solid,
            sizes=build.sizes,
        )

    def _held_in_place(self, entry: dict[str, Any]) -> dict[str, Any]:
        """A fixed body is where it is said to be near: nothing is left to search for."""
        near = cast("dict[str, Any]", entry["near"]) if isinstance(entry.get("near"), dict) else {}
        if not near.keys() <= set(_POSE_KEYS[self.names.space]):  # told where the start is read
            return entry
        return {**near, **{key: value for key, value in entry.items() if key != "near"}}

    def _full(self, at: Components) -> Components:
        """Components as the model has them: a point of a flat shape lies in its plane."""
        return (*at, *self.names.origin[len(at) :])

    def _chain(self, name: str, entry: dict[str, Any], *, fixed: bool) -> tuple[tuple[Rotation, ...], str]:
        """`turned: [psi about y, theta about x]`, where some of the angles are new names."""
        names = self.names
        frame = str(entry.get("frame", GROUND))
        if frame not in self._mapping("bodies") and frame != GROUND:
            names.problem(f"there is no body {frame}.{did_you_mean(frame, self._mapping('bodies'))}", None, "frame")
            return (), GROUND
        chain = read_chain(names, entry.get("turned", []), "turned", named=not fixed)
        if not any(turn.name for turn in chain):
            if frame != GROUND:
                names.problem(
                    "a known rotation at the start counts from the ground; name the angles to count from frame, "
                    "e.g. turned: [psi about y], frame: shaft",
                    None,
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
            self.names.problem("outline is a list of points of the body, e.g. outline: [P, Q, R]", None, "outline")
            return ()
        corners = [str(name) for name in cast("list[Any]", given)]
        for k, name in enumerate(corners):
            if name not in points:
                self.names.problem(f"there is no point {name}.{did_you_mean(name, points)}", None, "outline", k)
        return tuple(corners) if all(name in points for name in corners) else ()

    def _start_of_body(self, entry: dict[str, Any], default: str, points: Mapping[str, Any]) -> Start:
        names = self.names
        at = entry.get("at")
        place: tuple[str, Components] | None = None
        if isinstance(at, dict) and len(cast("dict[str, Any]", at)) == 1:
            ((point, pair),) = cast("dict[str, Any]", at).items()
            if point not in points:
                names.problem(f"there is no point {point}.{did_you_mean(point, points)}", None, "at", point)
            else:
                place = point, names.components(pair, LENGTH, "at", point)
        elif isinstance(at, list):
            place = default, names.components(cast("list[Any]", at), LENGTH, "at")
        elif at is not None:
            names.problem("at is a position [x, y], or {point: [x, y]}", None, "at")
        angle = names.formula(entry["angle"], DIMENSIONLESS, "angle") if "angle" in entry else None
        near: Start | None = None
        if isinstance(entry.get("near"), dict):
            guess = cast("dict[str, Any]", entry["near"])
            known = _POSE_KEYS[names.space]
            for key in guess:
                if key not in known:
                    names.problem(f"near has no {key}.{did_you_mean(key, known)}", None, "near", key)
            with names.at("near"):
                near = self._start_of_body({k: guess[k] for k in known if k in guess}, default, points)
        elif "near" in entry:
            names.problem("near is a guess, e.g. near: {angle: 30 deg}", None, "near")
        velocity = entry.get("velocity")
        start = Start(
            place,
            angle,
            None if velocity is None else names.components(velocity, VELOCITY, "velocity"),
            None,
            near,
        )
        spin = entry.get("angular_velocity")
        if names.space:
            return self._start_in_space(start, entry, spin)
        if spin is None:
            return start
        return replace(start, angular_velocity=names.formula(spin, ANGULAR_VELOCITY, "angular_velocity"))

    def _start_in_space(self, start: Start, entry: dict[str, Any], spin: Any) -> Start:
        """The rotation, where all of it is known, and `angular_velocity: [wx, wy, wz]` along the axes of the ground, or
        `{body: [...]}` along the body's own."""
        names = self.names
        turned = entry.get("turned")
        if turned is not None:
            n_before = len(names.problems)
            chain = read_chain(names, turned, "turned", named=True)
            del names.problems[n_before:]  # they are told where the chain is read
            if not any(turn.name for turn in chain):
                start = replace(start, turned=chain)
        if spin is None:
            return start
        in_body = isinstance(spin, dict)
        if isinstance(spin, dict):
            given = cast("dict[str, Any]", spin)
            if set(given) - {"body", "ground"} or len(given) != 1:
                message = "angular_velocity is [wx, wy, wz] along the ground's axes, or {body: [...]} along the body's"
                names.problem(message, None, "angular_velocity")
            in_body = "body" in given
            spin = next(iter(given.values()), None)
        rates = names.components(spin, ANGULAR_VELOCITY, "angular_velocity")
        return replace(start, rates=rates, rates_in_body=in_body)

    # -- specs --------------------------------------------------------------------------------
    def _spec(self, kind: type[SpecT], value: Any, *path: str | int) -> SpecT | None:
        """One description, its problems noted with their places."""
        try:
            return kind.model_validate(kind.from_plain(value))
        except ValidationError as error:
            known = [f.alias or n for n, f in kind.model_fields.items()]
            for fault in error.errors():
                where = fault["loc"][:2]
                what = str(where[0]) if where else ""
                if fault["type"] == "extra_forbidden":
                    message = f"{kind.kind} has no {what}.{did_you_mean(what, known)}"
                elif fault["type"] == "missing":
                    message = f"{kind.kind} needs {what}; it takes {', '.join(known)}"
                    where = ()
                else:
                    message = f"{what}: {fault['msg'][0].lower()}{fault['msg'][1:]}, found {fault['input']!r}"
                self.names.problem(message, None, *path, *where)
            return None

    def _specs(self, section: str, kinds: Mapping[str, type[SpecT]]) -> dict[str, SpecT]:
        found: dict[str, SpecT] = {}
        for name, value in self._named(section).items():
            with self.names.at(section, name):
                if isinstance(value, str) and value in kinds:
                    value = {value: None}
                if not isinstance(value, dict) or len(cast("dict[str, Any]", value)) != 1:
                    hint = next(iter(kinds))
                    self.names.problem(
                        f"give one kind, e.g. {name}: {{{hint}: ...}}; kinds: {', '.join(sorted(kinds))}"
                    )
                    continue
                ((kind, fields),) = cast("dict[str, Any]", value).items()
                if kind not in kinds:
                    what = section.removesuffix("s")
                    self.names.problem(f"{kind} is no kind of {what}.{did_you_mean(kind, kinds)}", None, kind)
                    continue
                spec = self._spec(kinds[kind], fields, kind)
                if spec is not None:
                    found[name] = spec
        return found

    def _measures(self) -> dict[str, Measure]:
        names = self.names
        self._named_angles()
        for name, value in self._named("measures").items():
            if name in names.parameters:
                names.problem(f"{name} is a parameter already; choose another name", None, "measures", name)
                continue
            with names.at("measures", name):
                measure = read_measure(names, value)
            if measure is None:
                names.broken.add(name)
            else:
                names.measures[name] = measure
        return names.measures

    def _named_angles(self) -> None:
        """The angles that chains of rotations name are measures."""
        names = self.names
        for body in names.bodies.values():
            with names.at("bodies", body.name, "turned"):
                for name, measure in angles_of(names, body.chain, body.name, body.frame).items():
                    if name in names.measures or name in self._mapping("measures"):
                        names.problem(f"{name} is named twice; choose another name for the angle of {body.name}")
                    names.measures[name] = measure

    def _held(self, connections: Mapping[str, Connection]) -> tuple[list[ConstraintRow], list[tuple[str, Measure]]]:
        rows: list[ConstraintRow] = []
        offered: list[tuple[str, Measure]] = []
        for name, connection in connections.items():
            with self.names.at("connections", name, connection.kind):
                n_before = len(self.names.problems)
                if self.names.space and connection.is_in_plane(self.names):
                    self._check_plane(connection, connections)
                rows += [self._in_numbers(replace(row, connection=name)) for row in connection.rows(self.names)]
                if len(self.names.problems) == n_before:
                    offered += [(f"{name}_{key}", m) for key, m in connection.offers(self.names)]
        if self.names.problems:
            return rows, offered
        kept = [row for row in rows if not row.if_needed]
        always = tuple(kept)
        for row in sorted(rows, key=lambda row: row.name):
            if not row.if_needed or any(row.measure == other.measure for other in kept):
                continue
            if not is_distance_kept(self.names.bodies, always, row.measure):
                kept.append(row)
        order = {id(row): k for k, row in enumerate(rows)}
        return sorted(kept, key=lambda row: order[id(row)]), offered

    def _attitudes(self, connections: Mapping[str, Connection]) -> tuple[Attitude, ...]:
        """How the joints of space let bodies turn."""
        found = ((name, connection.attitude(self.names)) for name, connection in connections.items())
        return tuple(replace(a, connection=name) for name, a in found if a is not None)

    def _check_plane(self, connection: Connection, connections: Mapping[str, Connection]) -> None:
        """In space, connections of the plane join bodies that stay in it."""
        planes = [c for c in connections.values() if isinstance(c, Planar) and c.keeps_flat(self.names)]
        flat = {c.body.partition(".")[0] for c in planes}
        free = sorted(b for b in connection.mentions(self.names) - flat if not self.names.bodies[b].fixed)
        if free:
            self.names.problem(
                f"{connection.kind} is a connection of the plane; in space it joins bodies that stay in the plane of x "
                f"and y: hold {', '.join(free)} there by a planar joint, or use a joint of space (revolute, spherical, "
                "prismatic, cylindrical, universal ...)"
            )

    def _bounds(
        self, connections: Mapping[str, Connection]
    ) -> tuple[tuple[OutlinePair, ...], tuple[UnilateralConstraint, ...], tuple[DryFriction, ...]]:
        """What may touch, other limits, and dry friction."""
        contacts: list[OutlinePair] = []
        limits: list[UnilateralConstraint] = []
        brakes: list[DryFriction] = []
        forms = self._forms()
        for name, connection in connections.items():
            with self.names.at("connections", name, connection.kind):
                if isinstance(connection, Contact):
                    contacts += connection.pairs(self.names, name)
                    continue
                bounds, rubs = connection.bounds(self.names, name)
                limits += (replace(bound, row=self._in_numbers(bound.row)) for bound in bounds)
                for rub in rubs:
                    static, kinetic = (substitute(e, forms) for e in (rub.static, rub.kinetic))
                    brakes.append(replace(rub, static=static, kinetic=kinetic))
        return tuple(contacts), tuple(limits), tuple(brakes)

    def _in_numbers(self, row: ConstraintRow) -> ConstraintRow:
        """A row with the forms of functions of time in its target."""
        forms = self._forms()
        if row.target is None or not free_symbols(row.target) & forms.keys():
            return row
        return replace(row, target=substitute(row.target, forms), general=row.target)

    def _forms(self) -> dict[str, Expr]:
        return {p.name: p.form for p in self.names.parameters.values() if p.form is not None}

    def _pushes(self, loads: Mapping[str, Load]) -> list[AppliedLoad]:
        found: list[AppliedLoad] = []
        forms = self._forms()
        for name, load in loads.items():
            with self.names.at("loads", name, load.kind):
                for push in map(_in_own_measure, load.pushes(self.names)):
                    if free_symbols(push.law) & forms.keys():
                        push = replace(push, law=substitute(push.law, forms), general=push.law)
                    found.append(replace(push, load=name))
        return found

    def _is_mode(self, key: str) -> bool:
        return key == "mode" and "mode" not in self.names.measures

    def _mode(self) -> str | None:
        """`start: {mode: crossed}`: the assembly mode by name, where the connections leave several."""
        start = self._mapping("start")
        if "mode" not in start or not self._is_mode("mode"):
            return None
        if not isinstance(start["mode"], str):
            self.names.problem("mode is the name of an assembly mode, e.g. mode: crossed", None, "start", "mode")
        return str(start["mode"])

    def _start(self, measures: Mapping[str, Measure]) -> tuple[dict[str, Expr], dict[str, Expr]]:
        """`start: {theta: 30 deg, rate(theta): 0}`; theta' and theta_dot also mean the rate."""
        start: dict[str, Expr] = {}
        rates: dict[str, Expr] = {}
        for key, value in self._mapping("start").items():
            if self._is_mode(key):
                continue
            name, target, per_time = key, start, False
            for before, after in (
                ("rate(", ")"),
                ("", "'"),
                ("", "_dot"),
                ("rate of ", ""),
                ("velocity of ", ""),
            ):
                if key not in measures and key.startswith(before) and key.endswith(after) and before + after:
                    inner = key[len(before) : len(key) - len(after)]
                    if inner in measures:
                        name, target, per_time = inner, rates, True
            if name not in measures:
                known = [*measures, *(f"rate({m})" for m in measures)]
                self.names.problem(
                    f"{key} is no named measure or rate of one.{did_you_mean(key, known)}", None, "start", key
                )
                continue
            dimension = measures[name].dimension
            target[name] = self.names.formula(value, dimension / TIME if per_time else dimension, "start", key)
        return start, rates

    def _ground_points(self) -> None:
        """One undeclared ground point is the origin; of several nobody knows where they are."""
        free = self.names.free_ground_points
        declared = self.names.bodies[GROUND].points
        if len(free) == 1 and len(declared) == 1:
            (name,) = free
            declared[name] = self.names.origin
        elif free:
            listed = [p for p in declared if p != "origin"] + list(free)
            for name, path in free.items():
                close = difflib.get_close_matches(name, [p for p in declared if p != "origin"], n=1)
                hint = f" Did you mean ground.{close[0]}?" if close else ""
                self.names.problems.append(
                    Problem(
                        path,
                        f"ground.{name} has no position.{hint} Declare it: ground: {{points: {{{name}: [x, y]}}}}, "
                        f"or, with positions left open, list all of them: ground: {{points: [{', '.join(listed)}]}}",
                    )
                )


def _rows_to_ask_for(
    contacts: tuple[OutlinePair, ...], limits: tuple[UnilateralConstraint, ...], brakes: tuple[DryFriction, ...]
) -> list[ConstraintRow]:
    """Rows that questions can name; of a crowd of contacts nobody asks for one."""
    bounds, rubs = list(limits), list(brakes)
    for pair in contacts if len(contacts) <= MOST_ASKED else ():
        more_bounds, more_rubs = pair.elements()
        bounds += more_bounds
        rubs += more_rubs
    return [item.row for item in (*bounds, *rubs)]


def _in_own_measure(push: AppliedLoad) -> AppliedLoad:
    """A law in a named measure that is the one it pushes is a law of its own measure."""
    own = [name for name, measure in push.measures if measure == push.measure]
    if not own:
        return push
    law = push.law
    for name in own:
        law = substitute(replace_rates(law, {name: RATE}), {name: VALUE})
    return replace(push, law=law, measures=tuple(item for item in push.measures if item[0] not in own))
