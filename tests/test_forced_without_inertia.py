"""Forced oscillations of what has parts without inertia: a damper that an elastic link holds, gears between shafts.

The node y of link and damper follows from k1 (x - y) = c y', so that link and damper are the one complex stiffness
k1 i c w/(k1 + i c w) (Rao, Mechanical Vibrations, 5th ed. 2011, problem 9.41; Zener).
"""

from __future__ import annotations

from posed import is_formula, posed

MOUNT = """
parameters: {m: 100 kg, k: 40 kN/m, k1: 80 kN/m, c: 3 kN s/m, F0: 200 N, w: 25 rad/s}
bodies: {machine: {particle: {mass: m}}, node: {particle: {}}}
connections:
  g1: {slider: {body: machine, along: up}}
  g2: {slider: {body: node, along: up}}
measures: {x: y of machine, y: y of node}
loads:
  spring: {law: {measure: x, force: -k*x}}
  link: {law: {measure: {expression: x - y}, force: -k1*(x - y)}}
  damper: {law: {measure: y, force: -c*rate(y)}}
  push: {force: {at: machine, along: up, magnitude: F0*cos(w*t)}}
"""
SHAKEN = MOUNT.replace("F0: 200 N", "Y: 5 mm").replace(
    "  push: {force: {at: machine, along: up, magnitude: F0*cos(w*t)}}\n", ""
)
SHAKEN = SHAKEN.replace("node: {particle: {}}", "node: {particle: {}}, foot: {particle: {}}")
SHAKEN = SHAKEN.replace(
    "measures: {x: y of machine, y: y of node}",
    "  g3: {slider: {body: foot, along: up}}\n  shaker: {driver: {measure: u, follows: Y*sin(w*t)}}\n"
    "measures: {x: y of machine, y: y of node, u: y of foot}",
)
SHAKEN = SHAKEN.replace("measure: x, force: -k*x", "measure: {expression: x - u}, force: -k*(x - u)")
SHAKEN = SHAKEN.replace("measure: y, force: -c*rate(y)", "measure: {expression: y - u}, force: -c*(rate(y) - rate(u))")
TRAIN = """
parameters: {J1: 2 kg m^2, J2: 0.5 kg m^2, k1: 4000 N m, k2: 1500 N m, n1: 0.2 m, n2: 0.1 m, M0: 20 N m, w: 30 rad/s}
ground: {points: {A: [-0.5 m, 1 m], C: [0, 0], D: [0.3 m, 0], B: [1 m, 1 m]}}
bodies:
  motor: {body: {inertia: J1}}
  large: {disk: {radius: n1}, at: [0, 0]}
  small: {disk: {radius: n2}, at: [0.3 m, 0]}
  fan: {body: {inertia: J2}}
connections:
  a: {pin: [ground.A, motor]}
  c: {pin: [ground.C, large]}
  d: {pin: [ground.D, small]}
  b: {pin: [ground.B, fan]}
  mesh: {gear_mesh: {first: large, second: small}}
measures: {p: angle of motor, q: angle of fan}
loads:
  shaft1: {torsional_spring: {between: [motor, large], stiffness: k1}}
  shaft2: {torsional_spring: {between: [small, fan], stiffness: k2}}
  drive: {torque: {on: motor, magnitude: M0*cos(w*t)}}
"""
_BELOW = "sqrt(k1^2*(k - m*w^2)^2 + c^2*w^2*(k + k1 - m*w^2)^2)"


def test_a_damper_behind_an_elastic_link() -> None:
    is_formula(MOUNT, "steady amplitude of x", f"F0*sqrt(k1^2 + c^2*w^2)/{_BELOW}")
    force = f"F0*sqrt(k^2*k1^2 + c^2*w^2*(k + k1)^2)/{_BELOW}"
    is_formula(MOUNT, "steady amplitude of (force in spring + force in damper)", force)


def test_what_its_foot_passes_on() -> None:
    passed = f"sqrt(k^2*k1^2 + c^2*w^2*(k + k1)^2)/{_BELOW}"
    is_formula(SHAKEN, "transmissibility to x", passed)


def test_gears_without_inertia_between_two_shafts() -> None:
    """With n = n1/n2 and k = k1 n^2 k2/(k1 + n^2 k2) the shafts carry k (J2 n^2)/(J1 J2 n^2 w^2 - k (J1 + J2 n^2))."""
    k = "(k1*(n1/n2)^2*k2/(k1 + (n1/n2)^2*k2))"
    torque = f"M0*{k}/J1/({k}*(1/J1 + 1/(J2*(n1/n2)^2)) - w^2)"
    is_formula(TRAIN, "steady amplitude of torque in shaft1", torque)


def test_what_takes_an_acceleration_is_refused_with_its_cause() -> None:
    found = posed(MOUNT, "steady amplitude of reaction of g2")
    assert found.expression is None
    assert found.reason
