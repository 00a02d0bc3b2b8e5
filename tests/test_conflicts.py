"""Models that contradict themselves: which parts do, by name."""

from __future__ import annotations

import dataclasses

import pytest

import freebody as fb
from freebody.numeric.reference import Reference
from freebody.study.mobility.conflicts import Conflict, conflict

FOUR_BAR = """
ground: {{points: {{A: [0, 0], D: [{d} m, 0]}}}}
bodies: {{crank: {{rod: {{length: 1 m}}}}, coupler: {{rod: {{length: 3 m}}}},
  rocker: {{rod: {{length: 2.5 m}}, near: {{angle: 80 deg}}}}}}
connections:
  A: {{pin: [ground.A, crank.start]}}
  B: {{pin: [crank.end, coupler.start]}}
  C: {{pin: [coupler.end, rocker.end]}}
  D: {{pin: [ground.D, rocker.start]}}
measures: {{theta: angle of crank}}
"""
TRIANGLE = """
ground: {points: {P: [10 m, 0], Q: [12 m, 0]}}
bodies:
  a: {rod: {length: 1 m}}
  b: {rod: {length: 1.5 m}}
  c: {rod: {length: 3 m}}
  hand: {rod: {length: 1 m}}
  pendulum: {rod: {length: 1 m}, angle: 20 deg}
  weight: {rod: {length: 1 m}}
connections:
  foot: {pin: [ground.P, pendulum.start]}
  AB: {pin: [a.end, b.start]}
  BC: {pin: [b.end, c.start]}
  CA: {pin: [c.end, a.start]}
  wrist: {pin: [c.center, hand.start]}
  knee: {pin: [pendulum.end, weight.start]}
"""


def named(text: str) -> Conflict:
    found = conflict(fb.System.from_text(text))
    assert found is not None
    return found


def without(system: fb.System, name: str) -> fb.System:
    """The system without one of its conditions."""
    if name in system.connections:
        return dataclasses.replace(
            system, constraint_rows=tuple(row for row in system.constraint_rows if row.connection != name)
        )
    if name in system.start:
        return dataclasses.replace(system, start={k: v for k, v in system.start.items() if k != name})
    what, _, body = name.partition(" of ")
    old = system.bodies[body]
    start = dataclasses.replace(old.start, **{what: None})
    return dataclasses.replace(system, bodies={**system.bodies, body: dataclasses.replace(old, start=start)})


def assert_irreducible(text: str) -> None:
    """Without any one of the named conditions the rest of the model can be assembled."""
    system = fb.System.from_text(text)
    found = conflict(system)
    assert found is not None
    assert found.is_minimal
    with pytest.raises(fb.CannotAnswer):
        Reference(system).assemble()
    for name in found.names:
        Reference(without(system, name)).assemble()


def test_a_model_that_can_be_assembled_has_no_conflict() -> None:
    assert conflict(fb.System.from_text(FOUR_BAR.format(d=3) + "start: {theta: 60 deg}\n")) is None
    assert conflict(fb.System.from_text("bodies: {p: particle}")) is None


def test_a_triangle_of_bars_that_cannot_close_is_named_alone() -> None:
    found = named(TRIANGLE)
    assert found.names == ("AB", "BC", "CA")
    assert found.is_geometric
    assert found.is_minimal
    assert found.message.startswith("AB, BC and CA contradict each other: no pose closes the loop: c is 3 m long")
    assert found.message.endswith("It closes only where 3 m <= 1 m + 1.5 m")
    assert found.gap.endswith(" m")
    assert_irreducible(TRIANGLE)


def test_links_that_violate_the_triangle_inequality_are_named() -> None:
    text = "ground: {points: {A: [0, 0], B: [3 m, 0]}}\nbodies: {p: particle, q: particle}\nconnections: {l1: {link: "
    text += "[ground.A, p, 1 m]}, l2: {link: [p, ground.B, 1 m]}, l3: {link: [p, q, 1 m]}}\n"
    found = named(text)
    assert found.names == ("l1", "l2")
    assert found.is_geometric
    # 3 m - 2 m are missing where the other link keeps its length
    assert found.gap == "l1.length is off by 1 m"
    assert_irreducible(text)


def test_an_impossible_crank_angle_is_named_with_the_loop() -> None:
    text = FOUR_BAR.format(d=5.4) + "start: {theta: 170 deg}\n"
    found = named(text)
    assert found.names == ("A", "B", "C", "D", "theta")
    assert not found.is_geometric
    # the crank's end at 170 deg from D: sqrt(1 + 5.4^2 + 2*5.4*cos(10 deg)) = 6.387, with 3 + 2.5 to reach it
    assert "with the start that is given no pose closes the loop" in found.message
    assert "6.387 m <= 3 m + 2.5 m" in found.message
    assert_irreducible(text)


def test_a_loop_that_never_closes_is_geometric_whatever_the_start() -> None:
    found = named(FOUR_BAR.format(d=7) + "start: {theta: 60 deg}\n")
    assert found.names == ("A", "B", "C", "D")
    assert found.is_geometric


def test_an_angle_of_a_body_against_the_start_of_its_measure() -> None:
    text = FOUR_BAR.format(d=3).replace("crank: {rod: {length: 1 m}}", "crank: {rod: {length: 1 m}, angle: 30 deg}")
    found = named(text + "start: {theta: 60 deg}\n")
    assert found.names == ("theta", "angle of crank")
    assert not found.is_geometric
    assert found.gap.endswith("rad")
    assert_irreducible(text + "start: {theta: 60 deg}\n")


def test_a_place_of_a_body_that_its_pin_does_not_allow() -> None:
    text = "bodies: {r: {rod: {length: 1 m}, at: {start: [1 m, 2 m]}}}\nconnections: {A: {pin: [ground.A, r.start]}}\n"
    found = named("ground: {points: {A: [0, 0]}}\n" + text)
    assert found.names == ("A", "the given place of r")
    assert not found.is_geometric


def test_a_body_welded_at_two_places() -> None:
    text = "ground: {points: {A: [0, 0], B: [2 m, 0]}}\nbodies: {r: {rod: {length: 1 m}}, s: {rod: {length: 1 m}}}\n"
    text += "connections: {w1: {weld: [ground.A, r.start]}, w2: {weld: [ground.B, r.end]}, "
    text += "p: {pin: [r.center, s.start]}}\n"
    found = named(text)
    assert found.names == ("w1", "w2")
    assert found.is_geometric
    assert found.to_plain()["names"] == ["w1", "w2"]


def test_a_connection_that_cannot_hold_by_itself() -> None:
    text = "ground: {points: {A: [0, 0]}}\nbodies: {r: {rod: {length: 1 m}, fixed: true, at: [3 m, 0]}, p: particle}\n"
    found = named(text + "connections: {w: {pin: [ground.A, r.start]}, x: {pin: [p, ground.A]}}\n")
    assert found.names == ("w",)
    assert found.message.startswith("w cannot hold: at best w.x is off by 2.5 m")


def test_a_search_that_is_cut_short_says_so() -> None:
    found = conflict(fb.System.from_text(TRIANGLE), most_evaluations=0)
    assert found is not None
    assert not found.is_minimal
    assert {"AB", "BC", "CA"} <= set(found.names)
    assert "the search was cut short" in found.message


def test_values_are_needed() -> None:
    with pytest.raises(fb.CannotAnswer, match="numbers need a value for length_r"):
        conflict(fb.System.from_text("bodies: {r: rod}"))
