"""Points of the ground that are named but not declared."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import cast

from freebody.connections.base import Connection
from freebody.errors import Problem
from freebody.language.expression import add, negate
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND, Components
from freebody.model.elements import RigidBody
from freebody.model.names import Names
from freebody.model.polynomials import polynomial
from freebody.model.rotations import applied, columns_of, cosine_and_sine

_ALIKE = 0.65  # of a name to that of a line: a slip of the pen


def joined_where_they_stand(names: Names) -> dict[str, Connection]:
    """The joints that hold a body to the `ground` that is put elsewhere than at its origin: it is held where it stands,
    at a point of the ground with the name of the joint."""
    points, found = names.bodies[GROUND].points, dict[str, Connection]()
    for name, connection in names.connections.items():
        fields = connection.meeting
        texts = () if fields is None else tuple(getattr(connection, field) for field in fields)
        if (
            len(texts) != 2
            or texts.count(GROUND) != 1
            or name in points
            or not isinstance(texts[1 - texts.index(GROUND)], str)
        ):
            continue
        k = texts.index(GROUND)
        place = _place_at_start(names, texts[1 - k].strip())
        if fields is None or place is None or place == names.origin:
            continue
        points[name] = place
        found[name] = cast("Connection", connection).model_copy(update={fields[k]: f"{GROUND}.{name}"})
    return found


def place_joined_ground_points(names: Names) -> None:
    """A ground point that is not declared is where the point of a placed body is that a joint holds there."""
    declared = names.bodies[GROUND].points
    for connection in names.connections.values():
        fields = connection.meeting
        texts = () if fields is None else tuple(getattr(connection, field) for field in fields)
        for text, other in (texts, texts[::-1]) if texts else ():
            if not isinstance(text, str) or not isinstance(other, str):
                continue
            owner, _, name = text.strip().partition(".")
            if owner != GROUND or not name.isidentifier() or name in declared or names.edge(text) is not None:
                continue
            place = _place_at_start(names, other.strip())
            if place is not None:
                declared[name] = place


def _place_at_start(names: Names, text: str) -> Components | None:
    """Where on the ground a point of a body is put: by its own place, or by that of another one and its turn."""
    owner, _, name = text.partition(".")
    body = names.bodies.get(owner)
    if body is None or body.name == GROUND or body.is_placeholder or body.start.at is None:
        return None
    own, (known, place) = body.points.get(name or body.default_point), body.start.at
    if own is None:
        return None
    arm = tuple(add(a, negate(b)) for a, b in zip(own, body.points[known], strict=True))
    if all(polynomial(part).is_zero for part in arm):
        return place
    turned = _turned(names, body, arm)
    return None if turned is None else tuple(polynomial(p + a).expression() for p, a in zip(place, turned, strict=True))


def _turned(names: Names, body: RigidBody, arm: Components) -> Components | None:
    """A vector of a body in the axes of the ground, where the model says how the body is turned at the start."""
    chain = body.start.turned
    if names.space:
        return None if chain is None or any(turn.name for turn in chain) else applied(columns_of(chain), arm)
    if body.start.angle is None:
        return None
    (x, y), (cos, sin) = arm, cosine_and_sine(body.start.angle)
    return x * cos - y * sin, x * sin + y * cos


def place_ground_points(names: Names) -> None:
    """One undeclared ground point is the origin; of several nobody knows where they are."""
    free = _without_misspelt_lines(names)
    declared = names.bodies[GROUND].points
    if len(free) == 1 and len(declared.keys() - names.by_coordinates) == 1:
        (name,) = free
        declared[name] = names.origin
    elif free:
        known = [p for p in declared if p != "origin"]
        listed = f"ground: {{points: [{', '.join([*known, *free])}]}}"
        close = {name: difflib.get_close_matches(name, known, n=1) for name in free}
        others = [name for name in free if not close[name]]
        if len(others) > 1:
            names.problems.append(Problem(free[others[0]], _without_position(others, listed)))
            others = []
        for name, path in free.items():
            if name not in others and not close[name]:
                continue
            hint = Message(" Did you mean ground.{close}?", close=close[name][0]) if close[name] else ""
            told = Message(
                "ground.{name} has no position.{hint} Declare it: {one}, or, with positions left open, list all of "
                "them: {all}",
                name=name,
                hint=hint,
                one=f"ground: {{points: {{{name}: [x, y]}}}}",
                all=listed,
            )
            names.problems.append(Problem(path, told))


def _without_position(points: list[str], listed: str) -> Message:
    """What is said of several points: one of them may be another one misspelt."""
    pairs = ((p, other) for p in points for other in difflib.get_close_matches(p, points, n=2)[1:])
    pair = next(pairs, None)
    hint = "" if pair is None else Message(" Are {a} and {b} the same point?", a=pair[0], b=pair[1])
    return Message(
        "the points {names} of the ground have no position.{hint} Declare them: {each}, or, with positions left open, "
        "list all of them: {all}",
        names=", ".join(points),
        hint=hint,
        each=f"ground: {{points: {{{', '.join(f'{name}: [x, y]' for name in points)}}}}}",
        all=listed,
    )


def _without_misspelt_lines(names: Names) -> Mapping[str, tuple[str | int, ...]]:
    """The points that are named and not declared, but for what is said of those that are almost called as a line."""
    ground = names.bodies[GROUND]
    lines = [*ground.lines, *ground.planes]
    alike = {name: difflib.get_close_matches(name, lines, n=1, cutoff=_ALIKE) for name in names.free_ground_points}
    told_of = {
        value for p in names.problems if isinstance(p.message, Message) for value in p.message.arguments.values()
    }
    for name, close in alike.items():
        if close and f"{GROUND}.{name}" not in told_of:
            told = Message(
                "ground has no point {name}. Did you mean the line ground.{close}? Else declare it: {one}",
                name=name,
                close=close[0],
                one=f"ground: {{points: {{{name}: [x, y]}}}}",
            )
            names.problems.append(Problem(names.free_ground_points[name], told))
    return {name: path for name, path in names.free_ground_points.items() if not alike[name]}
