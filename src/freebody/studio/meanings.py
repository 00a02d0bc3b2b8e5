"""Which bodies, and which connection or load, a symbol speaks of, so that the page can show them together."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from freebody.language.expression import Expr, Symbol, free_symbols
from freebody.language.notation import to_mathml
from freebody.measures.geometry import GROUND
from freebody.studio.wire.studies import Meaning
from freebody.study.senses import drawn_symbols
from freebody.system.system import System

_TAG = re.compile(r"<[^>]*>|\s")


# what coordinates of a body and their rates are called where the model has no name for them
_COORDINATES = ("x", "y", "theta", "v", "omega", "a", "alpha")


def meanings(system: System) -> list[Meaning]:
    """Of reactions, named measures, coordinates, and the parameters of bodies, connections and loads. What belongs to a
    body, or to more than one connection or load, speaks of bodies alone."""
    own_names = {name for body in system.moving for name in _names(body.mass, body.inertia)}
    found: dict[str, _Said] = {}
    for symbol, bodies, owner, force in _all(system):
        said = found.setdefault(symbol, _Said())
        said.bodies.update(dict.fromkeys(body for body in bodies if body != GROUND))
        if owner and symbol not in own_names:
            said.owners.add(owner)
            said.forces.update({force: None} if force else {})
    return [
        Meaning(
            symbol=shown(symbol),
            bodies=list(said.bodies),
            owner=next(iter(said.owners)) if len(said.owners) == 1 else "",
            forces=list(said.forces),
        )
        for symbol, said in found.items()
        if said.bodies or said.owners
    ]


@dataclass
class _Said:
    """bodies, forces: in their order"""

    bodies: dict[str, None] = field(default_factory=dict[str, None])
    owners: set[str] = field(default_factory=set[str])
    forces: dict[str, None] = field(default_factory=dict[str, None])


def typeset(symbol: str) -> str:
    """A symbol in MathML."""
    return to_mathml(Symbol(symbol))


def letters(math: str) -> str:
    """What the letters of a symbol in MathML are on a page."""
    return _TAG.sub("", math)


def shown(symbol: str) -> str:
    """What the letters of a symbol are on a page."""
    return letters(typeset(symbol))


def _all(system: System) -> Iterator[tuple[str, Iterable[str], str, str]]:
    """Symbols with the bodies, the connection or load, and the force that they belong to."""
    reactions = drawn_symbols(system)
    for row in system.rows:
        if row.name in reactions:
            yield reactions[row.name].name, row.measure.bodies(), row.connection, row.name
    for name, measure in system.measures.items():
        yield name, measure.bodies(), "", ""
    for body in system.moving:
        offsets = [component for point in body.points.values() for component in point]
        for name in _names(body.mass, body.inertia, body.radius, *body.tensor, *offsets):
            yield name, (body.name,), "", ""
        yield from ((f"{letter}_{body.name}", (body.name,), "", "") for letter in _COORDINATES)
    for row in system.constraint_rows:
        for name in _names(row.target):
            yield name, row.measure.bodies(), row.connection, ""
    for push in system.applied_loads:
        for name in _names(push.law):
            yield name, push.measure.bodies(), push.load, push.name


def _names(*expressions: Expr | None) -> Iterator[str]:
    for expression in expressions:
        if expression is not None:
            yield from sorted(free_symbols(expression))
