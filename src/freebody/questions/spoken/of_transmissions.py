"""Belts, chains, teeth and drives in the grammar: tensions, forces between teeth, power and work."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.notation import to_python
from freebody.measures.geometry import ZERO
from freebody.questions.spoken import joining, lookup, of_forces, strings, transmitting
from freebody.questions.spoken.composing import JOINT, SILENT, Groups, said_of
from freebody.questions.spoken.lexicon import things_alike
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_DRIVES = ("driving torque", "driving force")


_RUNS = 2  # of a string over a wheel


@said_of("power", "work")
def _work(names: Names, quantity: str, rest: Clause) -> Groups:
    of = [name for _, name in rest.names]
    loads = [name for name in of if name in names.loads]
    of = loads if len(loads) == 1 else of  # whose load it is
    bodies = [name for name in of if name in names.bodies]
    if len(of) == 1 == len(bodies):  # what drives the body that is named
        own = {p.load for p in names.applied_loads if bodies[0] in p.measure.bodies()}
        of = [name for name in lookup.driving(names) if name in own] or of
    drives = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction in _DRIVES)
    of = of or [*drives, *lookup.driving(names)]
    if rest.only("name", *SILENT) and (len(of) == 1 or not rest.names):
        yield [f"{quantity} of {one}" for one in of]


@said_of("driving power")
def _of_drive(names: Names, quantity: str, rest: Clause) -> Groups:
    """The power of what drives: a drive, or a load that is called one, or the only one that is no weight."""
    if rest.names:
        yield from _work(names, "power", rest)
        return
    drives = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction in _DRIVES)
    loads = lookup.driving(names)
    motors = frozenset[str]().union(*(kinds for kinds in things_alike() if "motor" in kinds))
    called = [load for load in loads if load in motors]
    of = [*drives] or called or loads
    if rest.only(*SILENT):
        yield [f"power of {one}" for one in of]


@said_of("tension ratio")
def _ratio(names: Names, quantity: str, rest: Clause) -> Groups:
    """The tension of the tight run over that of the slack one; of a string over a wheel which is which is not said."""
    yield [f"(tight tension of {belt})/(slack tension of {belt})" for belt in transmitting.tightened(names, rest)]
    of = [name for _, name in rest.names]
    pulling = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "tension")
    named = [name for name in pulling if of in ([], [name]) and rest.only("name", *SILENT)]
    spans = strings.spans(names, named[0]) if len(named) == 1 else []
    if len(spans) == _RUNS:
        head = f"tension of {named[0]}"
        yield [JOINT.join(f"ratio of {head} {one} to {head} {other}" for one, other in (spans, spans[::-1]))]


@said_of("belt force")
def _of_belt(names: Names, quantity: str, rest: Clause) -> Groups:
    """The difference of the tensions of both runs, of the belt that is named or the only one."""
    of = [name for _, name in rest.names if name in names.connections]
    belts = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "belt force")
    if belts and rest.only("name", *SILENT):
        yield [f"belt force of {name}" for name in of or belts]
    elif (
        quantity == "belt force"
    ):  # the force round a wheel is that of its teeth; where none are, it is the whole force
        toothed = any(row.reaction == "tooth force" for row in names.constraint_rows)
        if not toothed and (both := _differences(names, [name for _, name in rest.names])):
            yield both
            return
        yield from of_forces.transmitted(names, "tangential tooth force" if toothed else "force", rest)


def _differences(names: Names, of: list[str]) -> list[str]:
    """The difference of the tensions of the strings over a wheel, or of all, that have two ends."""
    strings = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "tension")
    strings = [name for name in strings if all(joining.touches(names, name, one) for one in of)]
    ends = [(name, transmitting.ends_of(names, name)) for name in strings]
    both = [(name, *own) for name, own in ends if len({*own} - {""}) == _RUNS]
    return [f"tension of {name}{one} - tension of {name}{other}" for name, one, other in both]


@said_of("links", "angle of wrap")
def _of_loop(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a chain or belt that is named, or of the only one."""
    of = [name for _, name in rest.names if name in names.connections]
    if rest.only("name", *SILENT) and len(rest.names) <= 1:
        yield [f"{quantity} of {name}" for name in of or transmitting.having(names, quantity)]


@said_of("tooth force components")
def _of_teeth(names: Names, quantity: str, rest: Clause) -> Groups:
    """All parts of the force between the teeth that are named, or of the only ones."""
    of = [name for _, name in rest.names if name in names.connections]
    kinds = [f"{kind} tooth force" for kind in ("tangential", "radial", "axial")]
    meshes = [
        (name, [kind for kind in kinds if kind in transmitting.transmits(names, name)])
        for name in of or names.connections
    ]
    if rest.only("name", *SILENT):
        yield [JOINT.join(f"{kind} of {name}" for kind in parts) for name, parts in meshes if parts]


@said_of("tight tension", "slack tension", "speed of greatest power")
def _of_runs(names: Names, quantity: str, rest: Clause) -> Groups:
    """A tension of a belt with pretension, which is named or the only one."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        yield _at_ends(names, quantity, of) or [
            f"{quantity} of {name}" for name in of or transmitting.having(names, quantity)
        ]


def _at_ends(names: Names, quantity: str, of: list[str]) -> list[str]:
    """The tension at an end of a string that is fastened to a point so called: the slack one, the tight one."""
    called = {"slack tension": ("slack", "loose"), "tight tension": ("tight", "taut")}.get(quantity, ())
    pulling = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "tension")
    return [
        f"tension of {string} at {body}.{point}"
        for string in pulling
        if string in (of or [string]) and quantity not in transmitting.transmits(names, string)
        for body in names.connections[string].mentions(names)
        for point in names.bodies[body].points
        if point in called
    ]


@said_of("transmitted power")
def _power_on(names: Names, quantity: str, rest: Clause) -> Groups:
    """What a belt, a chain or teeth hand on: their force times the speed of the rim of the first wheel."""
    passing = [row for row in names.constraint_rows if row.reaction in ("belt force", "chain force", "tooth force")]
    of = [name for _, name in rest.names]
    if not rest.only("name", *SILENT) or len(of) > 1:
        return
    for row in passing:
        wheels = [body for body in joining.joined_by(names, row.connection) if names.bodies[body].radius is not None]
        if wheels and row.connection in (of or [row.connection]):
            radius = to_python(names.bodies[wheels[0]].radius or ZERO).replace("**", "^")
            size = radius if radius.isidentifier() else f"({radius})"
            yield [f"|{row.reaction} of {row.connection} * {size} * angular velocity of {wheels[0]}|"]


@said_of("pressure angle")
def _pressure_angle(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a cam that is named, or of the only one."""
    of = [name for _, name in rest.names if name in names.connections]
    with names.quietly():
        cams = [name for name, spec in names.connections.items() if not isinstance(spec.aside_of_way(names), str)]
    if rest.only("name", *SILENT) and len(rest.names) <= 1:
        yield [f"pressure angle of {name}" for name in of or cams]
