"""Symbols for the forces of a system: what a free-body diagram and a derivation call a reaction.

A row of a connection has one multiplier; its symbol is a letter for the kind of reaction, with the connection (and
the end of a string, or the initials of a corner) as index where several need to be told apart: T, N, F_contact, A_x,
T_left, N_bl at the corner bottom_left, N_floor_start at an end that may touch a wall as well.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from freebody.connections.shared_by_copies import copy_of_row
from freebody.language.parser import GREEK
from freebody.model.elements import ConstraintRow
from freebody.system.system import System

# The letter of a kind of reaction; others are a force F or a moment M.
LETTERS = {
    "tension": "T",
    "normal force": "N",
    "friction force": "F",
    "tooth force": "F_t",
    "radial force": "F_r",
    "belt force": "F_b",
    "chain force": "F_c",
    "sideways force": "H",
    "driving torque": "M",
    "moment": "M",
    "friction moment": "M",
    "friction torque": "M",
}


@dataclass(frozen=True)
class ReactionSymbol:
    """What the reaction of a row is called. The reaction is sign times the multiplier: a tension is positive when it
    pulls, whatever the measure's direction."""

    row: str
    name: str
    sign: int


def reaction_symbols(system: System) -> Mapping[str, ReactionSymbol]:
    """By the name of the row, for all rows of a system."""
    rows = [row for row in system.rows if row.transmits]
    taken = _taken(system)
    found: dict[str, ReactionSymbol] = {}
    beside: dict[str, list[ConstraintRow]] = {}  # all rows, by connection
    for row in system.rows:
        beside.setdefault(row.connection, []).append(row)
    places = {connection: {_place(row.component) for row in of} for connection, of in beside.items()}
    wishes = {row.name: list(_wishes(row, system, beside[row.connection], places)) for row in rows}
    wanted = _wanted(wishes)
    for row in rows:
        names = [n for k, n in enumerate(wishes[row.name]) if not _is_wanted(n, k, row.name, wanted)]
        name = next((n for n in names if n not in taken), None)
        number = 1
        while name is None:
            candidate = f"{wishes[row.name][-1]}_{number}"
            name, number = (candidate if candidate not in taken else None), number + 1
        own = system.style.names.get(name, name)  # as the author calls it
        name = name if own in taken else own
        taken.add(name)
        found[row.name] = ReactionSymbol(row.name, name, row.sign)
    return found


def _taken(system: System) -> set[str]:
    """Names that mean something already; the letters that stand for time, pi and mechanical quantities too."""
    names = {*system.parameters, *system.measures, *system.states, "t", "pi", "e", "T_kin", "V", "L"}
    return names | set(GREEK.values())


def _wishes(
    row: ConstraintRow, system: System, of_connection: list[ConstraintRow], places: Mapping[str, set[str]]
) -> Iterator[str]:
    """Names from the shortest to the most particular one. places: of the rows of every connection"""
    letter = _letter(row)
    connection = row.connection
    component = _place(row.component)
    axis = row.axis
    if axis:  # a component: A_x, M_A_x
        if letter == "F" and len(connection) == 1:
            yield f"{connection}_{axis}"
        elsewhere = {_place(other.component) for other in of_connection if other.axis == axis}
        if " on " in row.component and len(elsewhere) > 1:  # at one of several corners: F_A_x
            short = f"{letter}_{_initials(component)}"
            yield from (f"{name}_{axis}" for name in (short, *_on_faces(short, row.component)))
        yield f"{letter}_{connection}_{axis}"
        return
    beside = [other for other in of_connection if other is not row]
    if component != connection or not any(_letter(other) == letter and not other.axis for other in beside):
        yield letter
    alike = [other for other in of_connection if other.reaction == row.reaction]
    if len(alike) > 1 and row.reaction in ("tension", "sideways force"):
        yield from (f"{letter}_{end}" for end in _telling_ends(row, system))
    elif len({_place(other.component) for other in alike}) > 1 and row.reaction in ("normal force", "friction force"):
        is_elsewhere = any(component in own for other, own in places.items() if other != connection)
        place = component if is_elsewhere and "_" not in component else _initials(component)
        short = f"{letter}_{f'{connection}_' if is_elsewhere else ''}{place}"
        yield short
        yield from _on_faces(short, row.component)
    if row.component.startswith("no slip "):  # one of two directions
        yield f"{letter}_{component}"
    else:
        yield f"{letter}_{connection}"
    if len(alike) == 1 or any(_place(other.component) != component for other in alike):
        yield f"{letter}_{connection}_{component}"


@cache
def _place(component: str) -> str:
    """What touches in a row of a contact: its corner, without the body it belongs to; for others the component."""
    short = (
        (copy_of_row(component) or component)
        .removeprefix("slip of ")
        .removeprefix("tipping of ")
        .removeprefix("no slip ")
    )
    flat = "flat_" if short.startswith("flat ") else ""  # beside the rim of the same end
    return flat + re.sub(r"\W", "_", short.split(" on ")[0].split(".")[-1])


def _on_faces(short: str, component: str) -> Iterator[str]:
    """Names of what acts at a corner that may touch several faces of another body, such as `crate.top`; with its own
    body where both bodies have corners of that name."""
    what, on, other = component.partition(" on ")
    if on and "." in other:
        names = other.split()[0].split(".")[-1], what.split()[-1].split(".")[0]  # without the axis behind it
        face, body = (re.sub(r"\W", "_", name) for name in names)
        yield f"{short}_{face}"
        yield f"{short}_{body}_{face}"


def _initials(name: str) -> str:
    """bl for bottom_left: a short index. A name with a digit keeps it, B2 for B2."""
    return "".join(re.findall(r"(?:^|(?<=_))[^\W_]|\d+", name))


def _letter(row: ConstraintRow) -> str:
    return LETTERS.get(row.reaction, "M" if "moment" in row.reaction or "torque" in row.reaction else "F")


def _wanted(wishes: Mapping[str, list[str]]) -> Mapping[str, list[tuple[int, str]]]:
    """Of every name, the two rows that would like it most: how far down it stands among their wishes."""
    found: dict[str, list[tuple[int, str]]] = {}
    for row, names in wishes.items():
        for name in dict.fromkeys(names):
            found[name] = sorted([*found.get(name, []), (names.index(name), row)])[:2]
    return found


def _is_wanted(name: str, place: int, by: str, wanted: Mapping[str, list[tuple[int, str]]]) -> bool:
    """Whether another row would like to have a name at least as much."""
    return any(other <= place for other, row in wanted[name] if row != by)


def _telling_ends(row: ConstraintRow, system: System) -> list[str]:
    """The ends of a row's section by which people would call it: what hangs there before what it runs over."""
    bodies = [system.bodies[end] for end in row.ends if end in system.bodies]
    moving = [body for body in bodies if not body.fixed]
    return [body.name for body in sorted(moving, key=lambda body: body.radius is not None)]
