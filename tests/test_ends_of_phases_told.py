"""Derivations of what remains as the time grows, and of values that hold while a contact does what it does."""

from __future__ import annotations

import freebody as fb

BALLS = """
parameters: {m: 0.2 kg, r: 0.03 m, v0: 2 m/s, mu: 0.2, b: 0.5 m, g: 9.81 m/s^2}
ground: {lines: {table: {along: right}}}
bodies:
  A: {sphere: {mass: m, radius: r}, at: [0, r], velocity: [v0, 0], angular_velocity: -v0/r}
  B: {sphere: {mass: m, radius: r}, at: [b, r]}
connections:
  cA: {contact: {between: [A, table], friction: mu}}
  cB: {contact: {between: [B, table], friction: mu}}
  hit: {contact: {between: [A, B], restitution: 1}}
loads: {weight: {gravity: g}}
measures: {xA: x of A, xB: x of B}
"""
SPOOL = """
parameters: {m: 8 kg, J: 0.2 kg m^2, R: 0.25 m, r: 0.1 m, P: 25 N, beta: 35 deg, mu: 0.4, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {spool: {body: {mass: m, inertia: J, radius: R}}}
connections: {floor: {contact: {between: [spool, floor], friction: mu}}}
loads:
  weight: {gravity: g}
  pull: {force: {at: spool, along: beta, magnitude: P}}
  moment: {torque: {on: spool, magnitude: P*r}}
measures: {x: x of spool}
"""


def told(model: str, question: str) -> str:
    explanation = fb.System.from_text(model).explain(question)
    (derivation,) = explanation.derivations
    assert not derivation.reason
    return explanation.to_text()


def test_a_velocity_that_remains() -> None:
    """Equal balls exchange their velocities, not their spins: B starts to slide with v0, and rolls with 5 v0/7."""
    page = told(BALLS, "final velocity of B")
    assert "Nothing ends this phase" in page
    assert "5⋅v₀" in page.rpartition("Answer")[2]


def test_a_value_that_holds_while_nothing_slips() -> None:
    """A spool rests at cos beta = r/R, where its cord points to the contact, while friction is enough."""
    page = told(SPOOL, "value of beta for which acceleration of x = 0")
    assert "β_req" in page
    assert "cos" in page


BALL_ON_A_CORD = """
parameters: {m: 1 kg, L: 1 m, v0: 6 m/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {ball: {particle: {mass: m}}}
connections: {cord: {string: {from: ground.O, to: ball, length: L}}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of cord from down}}
start: {theta: 0, rate(theta): v0/L}
"""


def test_a_string_of_given_length_is_drawn_cut_and_goes_slack_as_it_cannot_push() -> None:
    system = fb.System.from_text(BALL_ON_A_CORD)
    assert "tension T, up" in system.free_body("ball").description
    told = " ".join(fb.explain(system, "theta when cord goes slack").to_text().split())
    assert "the system moves until cord goes slack" in told
    assert "cord cannot push: the phase ends when its tension falls to zero" in told
    assert "contacts are counted" not in told


SLIDER_CRANK = """
parameters: {m1: 1 kg, m2: 2 kg, m3: 3 kg, r: 0.1 m, l: 0.3 m, T: 5 N m}
ground: {points: {O: [0, 0]}, lines: {cylinder: {along: right}}}
bodies:
  crank: {rod: {mass: m1, length: r}}
  rod: {rod: {mass: m2, length: l}, near: {angle: 0}}
  piston: {particle: {mass: m3}}
connections:
  main: {pin: [ground.O, crank.start]}
  crankpin: {pin: [crank.end, rod.start]}
  wristpin: {pin: [rod.end, piston]}
  cylinder: {slider: {body: piston, along: cylinder}}
loads: {drive: {torque: {on: crank, magnitude: T}}}
measures: {theta: {angle of crank}, phi: {angle of rod clockwise}}
start: {theta: 60 deg}
"""


def test_a_torque_that_must_vanish_is_told_to() -> None:
    told = fb.explain(fb.System.from_text(SLIDER_CRANK), "torque to hold")
    assert told.is_complete  # 0 = T cos(phi) holds for T = 0, not for cos(phi) = 0
    text = told.to_text()
    assert "T = 0" in text
    assert "every contact force must satisfy its law" not in text  # nothing touches


HOIST = """
parameters: {I: 0.3 kg m^2, R: 0.1 m, m: 20 kg, r: 0.15 m, T: 15 N m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], ceiling: [2*r - R, R]}}
bodies: {drum: {body: {inertia: I, radius: R}}, block: {disk: {radius: r}}, load: {particle: {mass: m}}}
connections:
  axle: {pin: [ground.O, drum]}
  rope: {string: {path: [wound on drum at left, under block, ground.ceiling]}}
  hook: {string: {from: block, to: load}}
loads: {weight: {gravity: g}, motor: {torque: {on: drum, magnitude: T}}}
measures: {y: {height of load}}
"""


def test_a_force_that_names_a_point_by_its_line_of_action_is_introduced() -> None:
    text = fb.explain(fb.System.from_text(HOIST), "tension of rope at drum").to_text()
    assert "lines of action of T_block and H_rope" in " ".join(text.split())
    assert "H_rope — " in text
