"""Which bodies, and which connection or load, a symbol speaks of, so that the page can show them together."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from freebody.language.expression import Expr, Symbol, free_symbols
from freebody.language.notation import to_mathml
from freebody.measures.geometry import GROUND
from freebody.studio.wire import Meaning
from freebody.study.senses import drawn_symbols
from freebody.system.system import System

_TAG = re.compile(r"<[^>]*>|\s")


def meanings(system: System) -> list[Meaning]:
    """Of reactions, named measures, and the parameters of bodies, connections and loads. What belongs to a body, or to
    more than one connection or load, speaks of bodies alone."""
    own_names = {name for body in system.moving for name in _names(body.mass, body.inertia)}
    found: dict[str, tuple[list[str], list[str]]] = {}
    for symbol, bodies, owner in _all(system):
        own, owners = found.setdefault(symbol, ([], []))
        own.extend(body for body in bodies if body != GROUND and body not in own)
        owners.extend([owner] if owner and owner not in owners and symbol not in own_names else [])
    return [
        Meaning(symbol=shown(symbol), bodies=bodies, owner=owners[0] if len(owners) == 1 else "")
        for symbol, (bodies, owners) in found.items()
        if bodies or owners
    ]


def shown(symbol: str) -> str:
    """What the letters of a symbol are on a page."""
    return _TAG.sub("", to_mathml(Symbol(symbol)))


def _all(system: System) -> Iterator[tuple[str, Iterable[str], str]]:
    """Symbols with the bodies and the connection or load that they belong to."""
    reactions = drawn_symbols(system)
    for row in system.rows:
        if row.name in reactions:
            yield reactions[row.name].name, row.measure.bodies(), row.connection
    for name, measure in system.measures.items():
        yield name, measure.bodies(), ""
    for body in system.moving:
        offsets = [component for point in body.points.values() for component in point]
        for name in _names(body.mass, body.inertia, body.radius, *body.tensor, *offsets):
            yield name, (body.name,), ""
    for row in system.constraint_rows:
        for name in _names(row.target):
            yield name, row.measure.bodies(), row.connection
    for push in system.applied_loads:
        for name in _names(push.law):
            yield name, push.measure.bodies(), push.load


def _names(*expressions: Expr | None) -> Iterator[str]:
    for expression in expressions:
        if expression is not None:
            yield from sorted(free_symbols(expression))
