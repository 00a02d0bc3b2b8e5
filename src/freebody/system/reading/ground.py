"""Points of the ground that are named but not declared."""

from __future__ import annotations

import difflib

from freebody.errors import Problem
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.names import Names


def place_ground_points(names: Names) -> None:
    """One undeclared ground point is the origin; of several nobody knows where they are."""
    free = names.free_ground_points
    declared = names.bodies[GROUND].points
    if len(free) == 1 and len(declared) == 1:
        (name,) = free
        declared[name] = names.origin
    elif free:
        listed = [p for p in declared if p != "origin"] + list(free)
        for name, path in free.items():
            close = difflib.get_close_matches(name, [p for p in declared if p != "origin"], n=1)
            hint = Message(" Did you mean ground.{close}?", close=close[0]) if close else ""
            told = Message(
                "ground.{name} has no position.{hint} Declare it: {one}, or, with positions left open, list all of "
                "them: {all}",
                name=name,
                hint=hint,
                one=f"ground: {{points: {{{name}: [x, y]}}}}",
                all=f"ground: {{points: [{', '.join(listed)}]}}",
            )
            names.problems.append(Problem(path, told))
