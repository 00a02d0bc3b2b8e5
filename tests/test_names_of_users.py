"""A parameter may have any name: the statements of connections and loads have names that no user can type."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator

import pytest

import freebody as fb
import freebody.connections  # registers the kinds
import freebody.loads  # registers the kinds
from freebody.connections.base import Connection
from freebody.loads.base import Load
from freebody.measures.combination import Composed
from freebody.testing.conformance import described, loaded, names_of

KINDS = [
    name
    for kind, c in sorted(Connection.kinds.items())
    if c.__module__.startswith("freebody.")
    for name in names_of(kind)
]
LOADS = sorted(kind for kind, load in Load.kinds.items() if load.__module__.startswith("freebody."))
LANGUAGE = {"phi", "x", "y", "s"}  # in which a user writes a formula
ALONE = {"c", "p", "q"}  # beside numbers only


def composed(part: object) -> Iterator[Composed]:
    if isinstance(part, Composed):
        yield part
    if isinstance(part, tuple):
        yield from (c for one in part for c in composed(one))
    elif dataclasses.is_dataclass(part):
        yield from (c for f in dataclasses.fields(part) for c in composed(getattr(part, f.name)))


@pytest.mark.parametrize("kind", [*KINDS, *LOADS])
def test_no_name_in_a_statement_can_be_that_of_a_parameter(kind: str) -> None:
    system = loaded(kind) if kind in LOADS else described(kind)
    rows = [*system.rows, *(r for rub in system.dry_friction for r in rub.rows), *system.applied_loads]
    used = {name for row in rows for c in composed(row) for name, _measure in c.measures}
    assert {n for n in used if not n.startswith("@")} <= LANGUAGE | ALONE | set(system.measures)


SPRINGS = {
    "spring": "{first: ground.A, second: b, stiffness: k, length: NAME}",
    "elastic_string": "{from: ground.A, to: b, stiffness: k, length: NAME}",
}


@pytest.mark.parametrize("kind", SPRINGS)
@pytest.mark.parametrize("name", ["length", "l1", "d"])
def test_natural_length_may_have_any_name(kind: str, name: str) -> None:
    [answer] = (
        fb.System.from_text(f"""
parameters: {{k: 100 N/m, {name}: 0.5 m}}
ground: {{points: {{A: [0, 0]}}}}
bodies: {{b: {{particle: {{mass: 1 kg}}, at: [2 m, 0]}}}}
loads: {{it: {{{kind}: {SPRINGS[kind].replace("NAME", name)}}}}}
""")
        .solve("force in it at start")
        .answers
    )
    assert answer.value == pytest.approx(150.0, rel=1e-12)


@pytest.mark.parametrize("name", ["angle", "beta"])
def test_angle_of_a_relaxed_torsional_spring_may_have_any_name(name: str) -> None:
    [answer] = (
        fb.System.from_text(f"""
parameters: {{k: 3 N m, J: 2 kg m^2, {name}: 20 deg}}
ground: {{points: {{A: [0, 0]}}}}
bodies: {{w: {{body: {{mass: 1 kg, inertia: J}}}}}}
connections: {{p: {{pin: [ground.A, w]}}}}
loads: {{s: {{torsional_spring: {{body: w, stiffness: k, angle: {name}}}}}}}
measures: {{turn: angle of w}}
start: {{turn: 0}}
""")
        .solve("acceleration of turn at start")
        .answers
    )
    assert answer.value == pytest.approx(1.5 * math.radians(20), rel=1e-12)


@pytest.mark.parametrize("name", ["h", "n1", "r"])
def test_radius_of_a_cylinder_on_a_plane_may_have_any_name(name: str) -> None:
    system = fb.System.from_text(f"""
space: true
parameters: {{{name}: 0.1 m}}
ground: {{planes: {{floor: {{normal: up}}}}}}
bodies: {{b: {{cylinder: {{mass: 1 kg, radius: {name}, length: 0.3 m, axis: z}}, at: [0, 0.1 m, 0]}}}}
connections: {{c: {{contact: {{between: [b, ground.floor]}}}}}}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
measures: {{y: height of b}}
""")
    assert float(system.simulate(0.5).dataset["y"][-1]) == pytest.approx(0.1, rel=1e-9)


def test_no_name_of_two_boxes_that_touch_can_be_that_of_a_parameter() -> None:
    system = fb.System.from_text("""
space: true
bodies:
  slab: {box: {mass: 1 kg, size: [1 m, 0.2 m, 1 m]}, fixed: true}
  crate: {box: {mass: 2 kg, size: [0.3 m, 0.2 m, 0.3 m]}, at: [0, 0.2 m, 0]}
connections: {c: {contact: {between: [crate, slab], friction: 0.3}}}
""")
    rows = [*(b.row for b in system.bounds), *(r for rub in system.dry_friction for r in rub.rows)]
    used = {name for row in rows for c in composed(row) for name, _measure in c.measures}
    assert {"@ap", "@dq"} <= used
    assert {n for n in used if not n.startswith("@")} <= ALONE
