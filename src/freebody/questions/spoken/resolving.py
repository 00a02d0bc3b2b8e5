"""What rules leave to the model.

    @way(block)             the measure of how far a block has come since the start
    @joint(floor, block)    the connection between the two; a third word is a reaction that it is to have
    @friction               the coefficient of friction
    @moving, @body          what is measured, or the body that moves
    @all(ladder)            `it`, where the body is all that moves

Where a model has several, each is a way to mean the text.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import product
from typing import TYPE_CHECKING, Any, cast

from freebody.language.units import DIMENSIONLESS
from freebody.measures.geometry import GROUND
from freebody.questions.spoken.naming import CLOSE, OPEN, plain_names

if TYPE_CHECKING:
    from freebody.model.names import Names

_CALL = re.compile(r"@(?P<what>way|joint|friction|moving|body|all)(?:\((?P<args>[^()]*)\))?")


def resolved(names: Names, text: str) -> Iterator[str]:
    """The text with what the model has for each of these; nothing where it has none."""
    calls = list(_CALL.finditer(text))
    choices = [_choices(names, call["what"], plain_names(call["args"] or "")) for call in calls]
    for chosen in product(*choices):
        found = text
        for call, name in zip(reversed(calls), reversed(chosen), strict=True):
            found = found[: call.start()] + f"{OPEN}{name}{CLOSE}" + found[call.end() :]
        yield found


def _choices(names: Names, what: str, args: str) -> list[str]:
    if what == "way":
        return _ways(names, args)
    if what == "all":
        return ["it"] if _moving(names) == [args] else []
    if what in ("moving", "body"):
        return _moving(names) if what == "body" else list(names.measures) or _moving(names)
    if what == "joint":
        first, second, reaction = (part.strip() for part in f"{args},,".split(",")[:3])
        return _joints(names, first, second, reaction)
    return _coefficients(names)


def _moving(names: Names) -> list[str]:
    return [name for name, body in names.bodies.items() if name != GROUND and not body.fixed]


def _ways(names: Names, body: str) -> list[str]:
    """Measures of how far a body has come from where the motion starts, or all such measures where none is named."""
    if body in names.measures:
        return [body] if body in names.started_at_zero else []
    lengths = [n for n, m in names.measures.items() if m.dimension != DIMENSIONLESS and n in names.started_at_zero]
    return [n for n in lengths if not body or body in names.measures[n].bodies()]


def _joints(names: Names, first: str, second: str, reaction: str) -> list[str]:
    """Connections that are, or touch, each of two things (bodies, lines of the ground, connections), those that have
    the reaction where any has."""
    wanted = [thing for thing in (first, second) if thing]
    found = [name for name in names.connections if all(_is_of(names, name, thing) for thing in wanted)]
    having = {row.connection for row in names.constraint_rows if row.reaction == reaction}
    return [name for name in found if name in having] or found


def _is_of(names: Names, connection: str, thing: str) -> bool:
    if thing == connection:
        return True
    described = names.connections[connection]
    if thing in names.bodies and thing != GROUND:
        return thing in described.mentions(names)
    fields: dict[str, Any] = vars(described)
    return thing in names.bodies[GROUND].lines and any(thing in _texts(value) for value in fields.values())


def _texts(value: object) -> list[str]:
    """Names in a field of a description, those of the ground without its name."""
    items = cast("list[Any]", [*value] if isinstance(value, (list, tuple)) else [value])
    return [item.removeprefix(f"{GROUND}.") for item in items if isinstance(item, str)]


def _coefficients(names: Names) -> list[str]:
    """Parameters that are the friction of a connection."""
    written = {str(value) for c in names.connections.values() for key, value in vars(c).items() if "friction" in key}
    return [name for name in names.parameters if name in written]
