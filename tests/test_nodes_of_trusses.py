"""Nodes: pins that several bars share, and strings and racks as they are written first."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import freebody as fb

Agree = Callable[[fb.Solution, str, str | list[str]], None]

ROOF = """
parameters: {a: 3 m, h: 2 m, P: 6 kN}
ground: {points: {A: [0, 0], B: [2*a, 0]}, lines: {floor: {along: right}}}
bodies:
  u1: {rod: {length: a}, at: {start: [0, 0]}, angle: 0}
  u2: {rod: {length: a}, at: {start: [a, 0]}, angle: 0}
  d1: {rod: {length: sqrt(a^2 + h^2)}, at: {start: [0, 0]}}
  d2: {rod: {length: sqrt(a^2 + h^2)}, at: {start: [2*a, 0]}}
  v: {rod: {length: h}, at: {start: [a, 0]}, angle: 90 deg}
connections:
  A: {pin: [ground.A, u1.start, d1.start]}
  B: {pin: [u2.end, d2.start]}
  roller: {slot: {pin: u2.end, along: floor}}
  C: {pin: [u1.end, u2.start, v.start]}
  D: {pin: [d1.end, d2.end, v.end]}
loads: {p: {force: {at: v.end, along: down, magnitude: P}}}
"""


def test_the_bars_of_a_roof_truss_meet_in_nodes_of_several_bars(agrees: Agree) -> None:
    # joint D: 2 S_d h/sqrt(a^2 + h^2) = -P with S_v = 0 at joint C; joint A: S_u = -S_d a/sqrt(a^2 + h^2)
    solved = fb.System.from_text(ROOF).solve(["force in d1", "force in u1", "force in v", "normal force of roller"])
    agrees(solved, "q1", "-P*sqrt(a**2 + h**2)/(2*h)")
    agrees(solved, "q2", "P*a/(2*h)")
    agrees(solved, "q3", "0")
    agrees(solved, "q4", "P/2")


def test_a_pin_of_a_node_has_the_name_of_the_node_and_its_number() -> None:
    system = fb.System.from_text(ROOF)
    assert {"D", "D_2", "A_2", "C_2"} <= {row.connection for row in system.constraint_rows}
    assert "D joins several bodies: D_2 (d1.end, v.end)" in [str(told) for told in system.assumptions]


def test_a_node_that_closes_on_the_way_or_whose_names_are_taken_is_refused() -> None:
    with pytest.raises(fb.ModelError, match="written as one pin for each"):
        fb.System.from_text(ROOF.replace("[d1.end, d2.end, v.end]", "[d1.end, d2.end, v.end], closes: at start"))
    with pytest.raises(fb.ModelError, match="would be called D_2, which is taken"):
        fb.System.from_text(ROOF.replace("  v: {rod", "  D_2: {particle: {mass: 1 kg}}\n  v: {rod"))


def test_a_list_of_two_points_is_a_string_from_one_to_the_other(agrees: Agree) -> None:
    text = """
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}, at: [0, -L]}}
connections: {line: {WORD: [ground.O, bob]}}
loads: {weight: {gravity: g}}
"""
    for word in ("string", "rope", "cord"):
        agrees(fb.System.from_text(text.replace("WORD", word)).solve("tension of line"), "q1", "m*g")


def test_a_rack_is_on_the_side_of_its_pinion_on_which_it_is_put(agrees: Agree) -> None:
    # the pinion rolls on the ground with its middle at half the speed of the rack above it:
    # T = M v^2/2 + m (v/2)^2/2 + J (v/(2 r))^2/2, so the reduced mass is M + m/4 + J/(4 r^2)
    text = """
parameters: {m: 3 kg, J: 0.02 kg m^2, r: 0.1 m, M: 5 kg, F: 60 N}
bodies:
  gear: {body: {mass: m, inertia: J, radius: r}, at: [0, r]}
  rack: {particle: {mass: M}, at: [0, 2*r]}
connections:
  lower: {rack_and_pinion: {pinion: gear, rack: ground}}
  upper: {rack_and_pinion: {pinion: gear, rack: rack}}
  guide: {slider: {body: rack, along: right}}
loads: {pull: {force: {at: rack, along: right, magnitude: F}}}
measures: {x: x of rack}
"""
    agrees(fb.System.from_text(text).solve("acceleration of x"), "q1", "F/(M + m/4 + J/(4*r**2))")
    turned = text.replace("at: [0, 2*r]", "at: [0, 0]").replace("rack: ground}", "rack: ground, above: true}")
    agrees(fb.System.from_text(turned).solve("acceleration of x"), "q1", "F/(M + m/4 + J/(4*r**2))")


def test_a_string_of_the_plane_in_space_names_what_it_does_not_know() -> None:
    text = """
space: true
parameters: {l: 1 m, m: 1 kg}
bodies: {ball: {particle: {mass: m}}}
connections: {up: {string: [ground.O, ball, l]}}
"""
    with pytest.raises(fb.ModelError, match="there is no body l"):
        fb.System.from_text(text)


def test_one_coefficient_of_a_string_over_a_drum_that_turns_is_that_of_the_drum(agrees: Agree) -> None:
    # the drum turns counter-clockwise under the rope, from the fixed end F on the right over the top to the weight
    # on the left, and drags it towards the weight: S_F = G e^(mu pi); M R^2/2 alpha = -(S_F - G) R
    text = """
parameters: {M: 20 kg, R: 0.3 m, w0: 30 rad/s, G: 50 N, mu: 0.3}
ground: {points: {O: [0, 0], F: [R, -1 m]}}
bodies: {drum: {disk: {mass: M, radius: R}}, knot: {particle: {mass: 0}}}
connections:
  O: {pin: [ground.O, drum]}
  rope: {string: {path: [knot, over drum, ground.F], friction: mu, leads: [up, down]}}
loads: {pull: {force: {at: knot, along: down, magnitude: G}}}
measures: {phi: angle of drum}
start: {phi: 0, rate(phi): w0}
"""
    solved = fb.System.from_text(text).solve(["angular acceleration of drum", "time when rate(phi) = 0"])
    agrees(solved, "q1", "-2*G*(exp(mu*pi) - 1)/(M*R)")
    agrees(solved, "q2", "w0*M*R/(2*G*(exp(mu*pi) - 1))")
