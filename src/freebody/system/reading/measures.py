"""The section `measures`: named measures, and the angles that chains of rotations name."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, cast

from freebody.language.expression import ZERO, add, negate, substitute
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.distance import Bearing
from freebody.measures.geometry import GROUND
from freebody.model.elements import ConstraintRow
from freebody.model.named_angles import angles_of
from freebody.model.names import Names
from freebody.model.phrases import read_measure
from freebody.system.reading.source import Source

_PHRASE = re.compile(r"\b(?:of|from|between|along)\b")  # words of a measure that is no expression in others


def read_measures(source: Source) -> dict[str, Measure]:
    names = source.names
    _named_angles(source)
    given = source.named("measures")
    for name, value in _in_turn(given):
        if name in names.parameters:
            names.problem(Message("{name} is a parameter already; choose another name", name=name), "measures", name)
            names.broken.add(name)
            continue
        measure = None
        with names.reading("measures", name):
            measure = read_measure(names, value)
        if measure is None:
            names.broken.add(name)
        else:
            names.measures[name] = measure
    for name in given:  # in the order of the file, whatever was read first
        if name in names.measures:
            names.measures[name] = names.measures.pop(name)
    return names.measures


def _in_turn(given: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Expressions after the measures that they name."""
    left = dict(given)
    while left:
        ready = [name for name, value in left.items() if not _named_in(value) & (left.keys() - {name})]
        for name in ready or [*left]:  # what names itself in a circle is refused where it is read
            yield name, left.pop(name)


def _named_in(value: Any) -> set[str]:
    expression = cast("dict[str, Any]", value).get("expression", "") if isinstance(value, dict) else value
    if _PHRASE.search(str(expression)):
        return set()
    return set(re.findall(r"[A-Za-z_]\w*", str(expression)))


def _named_angles(source: Source) -> None:
    """The angles that chains of rotations name are measures."""
    names = source.names
    for body in names.bodies.values():
        with names.at("bodies", body.name, "turned"):
            for name, measure in angles_of(names, body.chain, body.name, body.frame).items():
                if name in names.measures or name in source.mapping("measures"):
                    names.problem(
                        Message(
                            "{name} is named twice; choose another name for the angle of {body}",
                            name=name,
                            body=body.name,
                        )
                    )
                names.measures[name] = measure


def add_places(names: Names, rows: Iterable[ConstraintRow], offered: Sequence[tuple[str, Measure]]) -> None:
    """Where a file names no measure, in the plane: the angles of what swings on a link or a string, and where a single
    body moves in one way what tells where that is, under the name that it has as a coordinate. Questions and events may
    speak of it."""
    if names.measures or names.space:
        return
    swung = {name: measure for name, measure in offered if isinstance(measure, Bearing)}
    found = swung or _place_of_the_only_body(names, rows, dict(offered))
    if not found.keys() & names.parameters.keys():
        names.measures = {**names.measures, **found}
        names.counted_from_right = {name for name, measure in found.items() if isinstance(measure, Angle)}


def _place_of_the_only_body(
    names: Names, rows: Iterable[ConstraintRow], offered: dict[str, Measure]
) -> dict[str, Measure]:
    moving = [body for body in names.bodies.values() if body.name != GROUND and not body.fixed]
    if len(moving) != 1:
        return {}
    (body,) = moving
    rolling = {name for name, words in names.called.items() if "rolling" in words}  # which is taken not to lift off
    own = [row for row in rows if body.name in row.measure.bodies()]
    held = sum(not row.unilateral or row.connection in rolling for row in own)
    if held != (2 if body.turns else 1):
        return {}
    angle: dict[str, Measure] = {f"theta_{body.name}": Angle(body.name)}
    found = angle if not offered and body.turns else offered
    return found if len(found) == 1 else {}


def driven_from_zero(measures: Mapping[str, Measure], rows: Iterable[ConstraintRow]) -> set[str]:
    """Names of lengths that a driver leads from zero on: how far something has come."""
    begun = {
        row.measure: substitute(row.target, {"t": ZERO}) for row in rows if row.is_driven and row.target is not None
    }
    return {name for name, measure in measures.items() if measure.dimension == LENGTH and begun.get(measure) == ZERO}


def add_turned_at_start(names: Names) -> None:
    """The value and the rate with which an angle starts whose body says how it is turned and turns."""
    for name, measure in names.measures.items():
        if not isinstance(measure, Angle) or measure.origin != GROUND or names.space:
            continue
        start = names.bodies[measure.of].start
        if start.angle is not None and name not in names.placed_at_start:
            value = add(start.angle, negate(measure.reference))
            names.placed_at_start[name] = value
            names.started_at_zero |= {name} if value == ZERO else set()
            names.starts_away |= value != ZERO
        if start.angular_velocity is not None:
            names.start_rates = {name: start.angular_velocity, **names.start_rates}
