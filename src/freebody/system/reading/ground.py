"""Points of the ground that are named but not declared."""

from __future__ import annotations

import difflib
from collections.abc import Mapping

from freebody.errors import Problem
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.names import Names

_ALIKE = 0.65  # of a name to that of a line: a slip of the pen


def place_ground_points(names: Names) -> None:
    """One undeclared ground point is the origin; of several nobody knows where they are."""
    free = _without_misspelt_lines(names)
    declared = names.bodies[GROUND].points
    if len(free) == 1 and len(declared) == 1:
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
