"""The section `measures`: named measures, and the angles that chains of rotations name."""

from __future__ import annotations

from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.named_angles import angles_of
from freebody.model.phrases import read_measure
from freebody.system.reading.source import Source


def read_measures(source: Source) -> dict[str, Measure]:
    names = source.names
    _named_angles(source)
    for name, value in source.named("measures").items():
        if name in names.parameters:
            names.problem(Message("{name} is a parameter already; choose another name", name=name), "measures", name)
            continue
        with names.reading("measures", name):
            measure = read_measure(names, value)
        if measure is None:
            names.broken.add(name)
        else:
            names.measures[name] = measure
    return names.measures


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
