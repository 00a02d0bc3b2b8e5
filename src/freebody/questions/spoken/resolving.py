"""What rules leave to the model.

    @way(block)             the measure of how far a block has come since the start
    @fallen(block, 2 m)     the condition that it is so far below where it started; @risen: above
    @turning(block)         the condition that it turns back; @top: that it has risen as far as it does at first
    @height(block), @depth(block), @angle(block), @place(block)     measures of these; @rise: a height that starts at 0
    @joint(floor, block)    the connection between the two; a third word is a reaction that it is to have
    @friction               the coefficient of friction
    @mass(block)            the parameter that is its mass
    @moving, @body          what is measured, or the body that moves
    @all(ladder)            `it`, where the body is all that moves
    @struck(A|B)            A, where something strikes when the motion begins and then alone, else B
    @either(A|B)            what stands in the parentheses

Where a model has several, each is a way to mean the text.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import product
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol
from freebody.language.units import DIMENSIONLESS
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO
from freebody.questions.course import names_line
from freebody.questions.spoken.naming import CLOSE, OPEN, plain_names

if TYPE_CHECKING:
    from freebody.model.names import Names

_CALL = re.compile(r"@(?P<what>[a-z]+)(?:\((?P<args>[^()]*)\))?")


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
    first, second, third = (part.strip() for part in f"{args},,".split(",")[:3])
    match what:
        case "way":
            return _ways(names, first)
        case "fallen" | "risen":
            return _climbed(names, first, second, 1 if what == "risen" else -1)
        case "turning":
            return [f"rate({name}) = 0" for name in _places(names, first) or _angles(names, first)]
        case "top":
            return [f"rate({name}) = 0" for name, sense in _heights(names, first) if _rises(names, name, sense)]
        case "height" | "rise" | "depth":
            found = [name for name, sense in _heights(names, first) if (sense < 0) == (what == "depth")]
            return [name for name in found if what != "rise" or name in names.started_at_zero]
        case "angle":
            return _angles(names, first)
        case "place":
            return _places(names, first)
        case "moving" | "body":
            return _moving(names) if what == "body" else list(names.measures) or _moving(names)
        case "all":
            return ["it"] if _moving(names) == [first] else []
        case "joint":
            return _joints(names, first, second, third)
        case "friction":
            return _coefficients(names)
        case "mass":
            masses = [body.mass for name, body in names.bodies.items() if name == first]
            return [mass.name for mass in masses if isinstance(mass, Symbol)]
        case "struck":
            first, _, other = args.partition("|")
            return [first] if _is_struck_at_start_alone(names) else [other] if other else []
        case "either":
            return args.split("|")
        case _:
            return []


def _moving(names: Names) -> list[str]:
    return [name for name, body in names.bodies.items() if name != GROUND and not body.fixed]


def _is_struck_at_start_alone(names: Names) -> bool:
    """Whether the blow that is meant can only be that at the start."""
    closing = {row.connection for row in names.constraint_rows if row.closes}
    return bool(names.struck_at_start) and (closing | names.impulses) <= names.struck_at_start


def _ways(names: Names, body: str) -> list[str]:
    """Measures of how far a body has come from where the motion starts, or all such measures where none is named."""
    if body in names.measures:
        return [body] if body in names.started_at_zero else []
    lengths = [n for n, m in names.measures.items() if m.dimension != DIMENSIONLESS and n in names.started_at_zero]
    return [n for n in lengths if not body or body in names.measures[n].bodies()]


def _places(names: Names, body: str) -> list[str]:
    """Measures of where a body is along a line, or all such measures where none is named."""
    if body in names.measures:
        return [body]
    lengths = [name for name, measure in names.measures.items() if measure.dimension != DIMENSIONLESS]
    return [name for name in lengths if not body or body in names.measures[name].bodies()]


def _angles(names: Names, body: str) -> list[str]:
    """Measures of how a body is turned against the ground, or all angles where none is named."""
    if body in names.measures:
        return [body]
    angles = [(name, measure) for name, measure in names.measures.items() if measure.dimension == DIMENSIONLESS]
    return [name for name, measure in angles if not body or {*measure.bodies()} - {GROUND} == {body}]


def _heights(names: Names, body: str) -> list[tuple[str, int]]:
    """Measures of how high a body is, or of any body where none is named: 1 where they count upwards, -1 downwards."""
    senses = {names.compass["up"].components: 1, names.compass["down"].components: -1}
    found: list[tuple[str, int]] = []
    for name, measure in names.measures.items():
        if not isinstance(measure, Displacement) or body not in ("", name, measure.of.body):
            continue
        sense = senses.get(measure.along.components)
        if sense is not None and {measure.along.body, measure.origin.body} == {GROUND}:
            found.append((name, sense))
    return found


def _climbed(names: Names, body: str, by: str, sense: int) -> list[str]:
    """The condition that a body is higher (sense 1) or lower (-1) than at the start by a length."""
    started = [(name, own) for name, own in _heights(names, body) if name in names.started_at_zero]
    return [f"{name} = {'' if own == sense else '-'}{by}" for name, own in started]


def _rises(names: Names, measure: str, sense: int) -> bool:
    """Whether a height grows as the motion begins, at the numbers of the model."""
    rate = names.numeric(names.start_rates.get(measure, ZERO))
    return rate is not None and sense * rate > 0.0


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
    return thing in names.bodies[GROUND].lines and names_line(names, connection, thing)


def _coefficients(names: Names) -> list[str]:
    """Parameters that are the friction of a connection."""
    written = {str(value) for c in names.connections.values() for key, value in vars(c).items() if "friction" in key}
    return [name for name in names.parameters if name in written]
