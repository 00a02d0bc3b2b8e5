"""A rigid body made of simple ones: masses add up, moments of inertia by parallel axes (Huygens-Steiner). A hole is a
part whose mass counts negative."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

from pydantic import Field

from freebody.language.expression import Call, Expr, negate
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.geometry import ZERO, Components
from freebody.model.chains import read_chain
from freebody.model.elements import BodyPart, Edge, SolidPart
from freebody.model.noting import did_you_mean
from freebody.model.rotations import UNIT, Columns, applied, columns_of
from freebody.model.shapes.base import Build, Shape, circle
from freebody.model.spec import WrongFields
from freebody.model.tensors import moved, turned
from freebody.model.written_kinds import written_kind

if TYPE_CHECKING:
    from freebody.model.names import Names

OPTIONS = ("at", "angle", "turned")
Placed = tuple[Build, Components, Columns]  # a part, its mass centre, its axes


class Composite(Shape, kind="composite"):
    """`composite: {parts: {hub: {disk: {mass: M, radius: R}}, arm: {rod: {mass: m, length: L}, at: [R, 0]}}}`: every
    part is a shape whose reference point stands at `at` in the body's own frame, turned by `angle`, or, in space, by
    `turned`. Points: `origin`, and the reference point of every part by its name. Parts in a list, `parts: [{disk:
    ...}, {rod: ..., at: [R, 0]}]`, are called part1, part2 and so on.

    What is round about the origin can roll and touch, carry a string and gear as a disk can; where several parts are,
    `radius` says which is meant. A round part by its name, `wheel.hub`, is its circle in a contact.

    `holes` are written as parts and taken away, each with the mass of what was there: a plate of mass M with a hole
    where m has been cut out weighs M - m."""

    parts: dict[str, Any] | list[Any]
    holes: dict[str, Any] | list[Any] = Field(default_factory=dict[str, Any])

    example = "{parts: {hub: {disk: {mass: 2 kg, radius: 0.2 m}}, tip: {particle: {mass: 1 kg}, at: [0.5 m, 0]}}}"

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """A list is one of parts, and so is what has none of the fields: `composite: {arm: {rod: ...}, bob: ...}`."""
        is_named = (
            isinstance(value, dict) and bool(value) and not {*cast("dict[str, Any]", value)} & {*cls.model_fields}
        )
        if is_named and all(isinstance(part, dict) for part in cast("dict[str, Any]", value).values()):
            return {"parts": value}
        return super().from_plain(value)

    def build(self, names: Names) -> Build:
        mass: Expr = ZERO
        moment: Components = names.origin
        placed: list[Placed] = []
        composed: list[BodyPart] = []
        solids: list[SolidPart] = []
        points: dict[str, Components] = {"origin": names.origin}
        edges: list[Edge[Components]] = []
        circles: dict[str, Expr] = {}
        for field, key, name, value in (*_listed("parts", self.parts), *_listed("holes", self.holes)):
            with names.at(field, key):
                found = _part(names, value)
                if name in points:
                    names.problem(Message("{name} is there already; call it otherwise", name=name))
            if found is None:
                continue
            build, at, axes = found
            if field == "holes":
                if build.mass == ZERO:
                    told = Message(
                        "a hole needs the mass of what was there, and {name} has none: e.g. mass: M*pi*r^2/(b*h) for a "
                        "round hole in a rectangle of the mass M",
                        name=name,
                    )
                    names.problem(told)
                build = _taken_away(build)
            elif names.space:
                solids.append(SolidPart(build.solid, build.sizes, build.axis, at, axes, is_particle=not build.turns))
            center = tuple(a + c for a, c in zip(at, _turned(axes, build.center_of_mass, len(at)), strict=True))
            points[name] = at
            if field == "parts" and build.radius is not None and not build.edges and not names.space:
                circles[name] = build.radius
            edges += _edges(build, at, axes, is_hole=field == "holes")
            mass = mass + build.mass
            moment = tuple(m + build.mass * c for m, c in zip(moment, center, strict=True))
            placed.append((build, center, axes))
            composed.append(BodyPart(name, build.mass, build.inertia, center))
        if not placed:
            names.problem(
                Message("a composite needs parts, e.g. parts: {{hub: {{disk: {{mass: m, radius: R}}}}}}"), "parts"
            )
        if (left := names.below_zero(mass)) is not None:
            names.problem(Message("the holes weigh {more:.4g} kg more than the parts", more=-left), "holes")
        if mass == ZERO:
            return Build(ZERO, ZERO, points=points, default_point="origin", edges=tuple(edges), circles=circles)
        middle = tuple(m / mass for m in moment)
        tensor = _tensor(placed, middle) if names.space else ()
        inertia = tensor[2] if tensor else _polar(placed, middle)
        parts = () if names.space else tuple(composed)
        return Build(
            mass,
            inertia,
            middle,
            points,
            default_point="origin",
            tensor=tensor,
            edges=tuple(edges),
            circles=circles,
            parts=parts,
            solid_parts=tuple(solids),
        )


def _listed(field: str, given: dict[str, Any] | list[Any]) -> Iterator[tuple[str, str | int, str, Any]]:
    """(field, key in it, name, what is written) of each part: by its name, or by its number in a list."""
    if isinstance(given, dict):
        yield from ((field, name, name, value) for name, value in given.items())
        return
    yield from ((field, k, f"{field[:-1]}{k + 1}", value) for k, value in enumerate(given))


def _edges(build: Build, at: Components, axes: Columns, *, is_hole: bool) -> Iterator[Edge[Components]]:
    """What is drawn of a part."""
    own = build.edges
    if not own and build.radius is not None:
        own = (Edge(circle(build.radius), "wire" if build.is_ring else "area"),)
    elif not own:
        corners = tuple(build.points[corner] for corner in build.corners) or ((ZERO, ZERO),)
        own = (Edge(corners, "wire" if len(corners) == 2 else "area"),)
    for edge in own:
        places = tuple(
            tuple(a + c for a, c in zip(at, _turned(axes, place, len(at)), strict=True)) for place in edge.places
        )
        yield Edge(places, "hole" if is_hole else edge.look)


def _taken_away(build: Build) -> Build:
    """A part that is not there: its mass and moments of inertia count negative."""
    return replace(
        build, mass=negate(build.mass), inertia=negate(build.inertia), tensor=tuple(negate(c) for c in build.tensor)
    )


def _polar(placed: list[Placed], middle: Components) -> Expr:
    """In the plane: I = sum of I_k + m_k d_k^2."""
    total: Expr = ZERO
    for build, center, _axes in placed:
        total = total + build.inertia + build.mass * _square(tuple(c - m for c, m in zip(center, middle, strict=True)))
    return total


def _tensor(placed: list[Placed], middle: Components) -> Components:
    """In space: the tensors of the parts, turned, each moved to the common mass centre."""
    total: Components = (ZERO,) * 6
    for build, center, axes in placed:
        arm = tuple(c - m for c, m in zip(center, middle, strict=True))
        own = moved(turned(build.tensor or (ZERO,) * 6, axes), build.mass, arm)
        total = tuple(a + b for a, b in zip(total, own, strict=True))
    return total


def _square(arm: Components) -> Expr:
    total: Expr = ZERO
    for c in arm:
        total = total + c * c
    return total


def _turned(axes: Columns, v: Components, n: int) -> Components:
    return applied(axes, (*v, *(ZERO,) * (3 - len(v))))[:n]


def _part(names: Names, value: Any) -> tuple[Build, Components, Columns] | None:
    """A part, the place of its reference point, and its axes."""
    entry = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
    written = {k: written_kind(k, value, Shape.kinds, space=names.space) for k, value in entry.items()}
    kinds = [key for key, kind in written.items() if kind is not None]
    for key in entry:
        if key not in kinds and key not in OPTIONS:
            names.problem(
                Message("a part has no {key}.{hint}", key=key, hint=did_you_mean(key, [*Shape.kinds, *OPTIONS])),
                key,
            )
    if len(kinds) != 1:
        example = "{disk: {mass: m, radius: R}, at: [0, 0]}"
        names.problem(
            Message(
                "a part is one shape with its place, e.g. {example}, found {value}", example=example, value=f"{value!r}"
            )
        )
        return None
    kind = Shape.kinds[written[kinds[0]] or ""]
    try:
        shape = kind.model_validate(kind.from_plain(entry[kinds[0]]))
    except WrongFields as wrong:
        error = wrong.found
        fault = error.errors()[0]
        names.problem(
            Message("{kind}: {fault}", kind=kind.kind, fault=fault["msg"]),
            kinds[0],
            *(str(p) for p in fault["loc"][:1]),
        )
        return None
    with names.at(kinds[0]):
        build = shape.build(names)
    at = names.components(entry["at"], LENGTH, "at") if "at" in entry else names.origin
    axes = UNIT
    if names.space:
        axes = columns_of(read_chain(names, entry.get("turned", []), "turned", named=False))
    elif "angle" in entry:
        angle = names.angle(entry["angle"], "angle")
        c, s = Call("cos", angle), Call("sin", angle)
        axes = ((c, s, ZERO), (-s, c, ZERO), UNIT[2])
    return build, at, axes
