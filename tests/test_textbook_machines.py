"""Problems of textbook families of machines: brakes, controllers, columns, piles, linkages with slides. Beside each
stands the family, and from what its formula follows by hand."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.errors import ModelError
from freebody.language.expression import Expr
from freebody.language.notation import to_python


def expression(model: str, question: str) -> str:
    answer = fb.System.from_text(model).solve(question)["q1"]
    assert isinstance(answer.expression, Expr), answer
    return to_python(answer.expression)


def value(model: str, question: str) -> float:
    found = fb.System.from_text(model).solve(question)["q1"].value
    assert isinstance(found, float)
    return found


# Meriam & Kraige, Statics: a block brake whose lever has no mass; moments about its hinge give N (a - mu c) = P b
SHOE_BRAKE = """
parameters: {a: 0.3 m, b: 1 m, c: 50 mm, R: 0.25 m, mu: 0.35, P: 150 N, I: 2 kg m^2, w0: 40 rad/s}
ground: {points: {O: [0, 0], H: [-a, R + c]}}
bodies:
  drum: {body: {inertia: I, radius: R}, at: [0, 0]}
  lever: {body: {}, at: [-a, R + c], angle: 0, points: {S: [a, -c], E: [b, 0]}}
connections:
  O: {pin: [ground.O, drum]}
  H: {pin: [ground.H, lever]}
  shoe: {contact: {between: [lever.S, drum], friction: mu}}
loads: {hand: {force: {at: lever.E, along: down, magnitude: P}}}
measures: {phi: angle of drum}
start: {phi: 0, rate(phi): w0}
"""


def test_a_lever_without_mass_needs_no_speed_at_the_start() -> None:
    system = fb.System.from_text(SHOE_BRAKE)
    for question, expected in (
        ("normal force of shoe", "b*P/(a - mu*c)"),
        ("energy lost until slipping ends", "I*w0**2/2"),
    ):
        found = system.solve(question)["q1"].expression
        assert isinstance(found, Expr)
        assert_same_function(to_python(found), expected, {"a": 0.3, "c": 0.05, "mu": 0.35})


# Franklin et al., Feedback Control: m s^3 + k_d s^2 + k_p s + k_i; the integral settles at -d/k_i
PID = """
parameters: {m: 2 kg, k_p: 50 N/m, k_d: 10 N s/m, k_i: 20 N/(m s), d: 4 N, r: 1 m}
ground: {lines: {rail: {along: right}}}
bodies: {cart: {particle: {mass: m}, at: [0, 0]}}
connections: {rail: {slider: {body: cart, along: rail}}}
measures: {x: x of cart}
states: {z: x - r}
loads:
  control: {force: {at: cart, along: right, magnitude: -k_p*(x - r) - k_d*rate(x) - k_i*z}}
  wind: {force: {at: cart, along: left, magnitude: d}}
"""


def test_a_pid_controller_that_starts_elsewhere_settles_at_the_set_point() -> None:
    limit = "k_p*k_d/m"
    asked = {
        "largest k_i so that the steady motion is stable": limit,
        "largest k_i so that the equilibrium is stable": limit,
        "x in steady motion": "r",
    }
    solution = fb.System.from_text(PID).solve(list(asked))
    for answer, expected in zip(solution.answers, asked.values(), strict=True):
        assert isinstance(answer.expression, Expr)
        assert_same_function(to_python(answer.expression), expected, {})


def test_a_pid_controller_tends_to_the_set_point_as_long_as_routh_lets_it() -> None:
    """m s^3 + k_d s^2 + k_p s + k_i is Hurwitz for k_p k_d > m k_i; then x tends to r, and the integral to -d/k_i."""
    at_rest = PID + "start: {x: 0, rate(x): 0}\n"
    solution = fb.System.from_text(at_rest).solve(["x as t grows", "z as t grows", "velocity of x as t grows"])
    for answer, expected in zip(solution.answers, ("r", "-d/k_i", "0"), strict=True):
        assert isinstance(answer.expression, Expr)
        assert_same_function(to_python(answer.expression), expected, {})
        assert "k_p·k_d > m·k_i" in str(answer.conditions)
    unstable = fb.System.from_text(at_rest.replace("k_i: 20", "k_i: 2000")).solve("x as t grows")["q1"]
    assert unstable.value is None
    assert "k_p·k_d > m·k_i" in str(unstable.reason)


# two masses on dampers and springs, the last one pulled: at rest both springs carry F
CHAIN = """
parameters: {m1: 2 kg, m2: 3 kg, k: 50 N/m, c: 10 N s/m, F: 4 N, L: 1 m, K: 20 N/m, C: 3 N s/m}
bodies: {a: {particle: {mass: m1}}, b: {particle: {mass: m2}}}
connections: {ga: {slider: {body: a, along: right}}, gb: {slider: {body: b, along: right}}}
measures: {x1: x of a, x2: x of b}
loads:
  s1: {law: {measure: x1, force: -k*x1 - c*rate(x1)}}
  s2: {spring: {first: a, second: b, stiffness: K, length: L}}
  d2: {damper: {first: a, second: b, damping: C}}
  f: {force: {at: b, along: right, magnitude: F}}
start: {x1: 0, x2: L, rate(x1): 0, rate(x2): 0}
"""


def test_coupled_damped_masses_tend_to_their_equilibrium() -> None:
    assert_same_function(expression(CHAIN, "x2 as t grows"), "L + F/k + F/K", {})
    assert_same_function(expression(CHAIN, "force in s2 as t grows"), "F", {})


# a first-order lag between controller and plant: I T s^3 + (I + c T) s^2 + c s + K, Routh: (I + c T) c > I T K
LAG = """
parameters: {I: 0.4 kg m^2, c: 0.2 N m s, K: 3 N m, T: 0.1 s}
ground: {points: {O: [0, 0]}}
bodies: {rotor: {body: {inertia: I}}}
connections: {O: {pin: [ground.O, rotor]}}
measures: {phi: angle of rotor}
states: {u: (-K*phi - u)/T}
loads:
  motor: {torque: {on: rotor, magnitude: u}}
  drag: {torque: {on: rotor, magnitude: -c*rate(phi)}}
"""


def test_the_largest_lag_of_a_loop_follows_from_routh() -> None:
    expected = "I*c/(I*K - c**2)"
    assert_same_function(expression(LAG, "largest T so that the equilibrium is stable"), expected, {"K": 3.0, "c": 0.2})


# Ziegler 1952: a double pendulum with masses 2m and m under a follower force flutters from (7/2 - sqrt(2)) k/L on
ZIEGLER = """
parameters: {L: 1 m, k: 10 N m, P: 5 N, m: 1 kg}
ground: {points: {O: [0, 0]}}
bodies: {a: {rod: {length: L}}, b: {rod: {length: L}}, ma: {particle: {mass: 2*m}}, mb: {particle: {mass: m}}}
connections:
  O: {pin: [ground.O, a.start]}
  J: {pin: [a.end, b.start]}
  wa: {weld: [a.end, ma]}
  wb: {weld: [b.end, mb]}
loads:
  k1: {torsional_spring: {body: a, stiffness: k, angle: 90 deg}}
  k2: {torsional_spring: {body: b, on: a, stiffness: k}}
  follower: {force: {at: b.end, along: against b.x, magnitude: P}}
measures: {p: angle of a from up, q: angle of b from up}
start: {p: 0, q: 0}
"""


def test_zieglers_column_flutters_under_a_follower_force() -> None:
    found = expression(ZIEGLER, "largest P so that the equilibrium is stable")
    assert_same_function(found, "(7/2 - sqrt(2))*k/L", {})


# Hibbeler, Statics: a beam on the floor leans over the edge of a wall; moments about its foot give the push of the edge
OVER_AN_EDGE = """
parameters: {m: 12 kg, L: 3 m, h: 1 m, theta: 40 deg, mu: 0.6, g: 9.81 m/s^2}
ground: {points: {edge: [0, h]}, lines: {floor: {along: right}}}
bodies: {rod: {rod: {mass: m, length: L}, at: {start: [-h/tan(theta), 0]}, angle: theta}}
connections:
  foot: {contact: {between: [rod.start, ground.floor], friction: mu}}
  top: {contact: {between: [ground.edge, rod]}}
loads: {weight: {gravity: g}}
"""


def test_a_beam_over_an_edge_needs_friction_at_its_foot() -> None:
    found = value(OVER_AN_EDGE, "least mu so that it stays at rest")
    m, L, h, theta, g = 12, 3, 1, math.radians(40), 9.81
    edge = m * g * L / 2 * math.cos(theta) * math.sin(theta) / h
    assert found == pytest.approx(edge * math.sin(theta) / (m * g - edge * math.cos(theta)), rel=1e-9)


# Meriam & Kraige: three equal logs in a pile: friction/normal force is tan 15 deg between them, a third of it below
PILE = """
parameters: {m: 30 kg, r: 0.15 m, mu: 0.3, nu: 0.2, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  left: {disk: {mass: m, radius: r}, at: [-r, r]}
  right: {disk: {mass: m, radius: r}, at: [r, r]}
  top: {disk: {mass: m, radius: r}, at: [0, r + r*sqrt(3)]}
connections:
  fl: {contact: {between: [left, ground.floor], friction: nu}}
  fr: {contact: {between: [right, ground.floor], friction: nu}}
  tl: {contact: {between: [top, left], friction: mu}}
  tr: {contact: {between: [top, right], friction: mu}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize(("mu", "nu", "holds"), [(0.3, 0.2, True), (0.26, 0.2, False), (0.3, 0.085, False)])
def test_a_pile_of_logs_holds_where_both_frictions_suffice(mu: float, nu: float, holds: bool) -> None:
    model = PILE.replace("mu: 0.3", f"mu: {mu}").replace("nu: 0.2", f"nu: {nu}")
    assert (mu >= math.tan(math.radians(15)) and nu >= math.tan(math.radians(15)) / 3) == holds
    answer = fb.System.from_text(model).solve("does it hold")["q1"]
    assert answer.expression is not None
    assert ("does not hold" in str(answer.verdict)) != holds


def test_a_guide_through_a_point_that_it_guides_is_refused() -> None:
    model = """
bodies: {bar: {rod: {length: 1 m, mass: 1 kg}, at: {start: [0, 0]}, angle: 10 deg}}
ground: {points: {O: [0, 0]}}
connections:
  O: {pin: [ground.O, bar.start]}
  hold: {slot: {pin: bar.end, along: right, through: bar.end}}
"""
    with pytest.raises(ModelError, match=r"bar\.end moves with what is guided"):
        fb.System.from_text(model)


# a plank whose lower side lies on a cylinder: stable for h < 2 R (Sommerfeld, Mechanics)
def test_a_plank_on_a_drum_is_stable_below_its_diameter() -> None:
    model = """
parameters: {m: 3 kg, L: 1 m, h: 0.1 m, R: 0.2 m, g: 9.81 m/s^2}
bodies:
  drum: {disk: {radius: R}, fixed: true, at: [0, 0]}
  plank:
    {rectangle: {mass: m, width: L, height: h}, lines: {base: {along: right, through: bottom}}, at: [0, R + h/2]}
connections: {roll: {rolling: {body: drum, on: plank.base, below: true}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of plank}
start: {theta: 0}
"""
    assert_same_function(expression(model, "range of h for which the equilibrium is stable"), "2*R", {})


# m x'' + k x = F sin(W t): not damped, so both frequencies stay, and at W = sqrt(k/m) the amplitude grows with the time
FORCED = """
parameters: {m: 2 kg, k: 200 N/m, F: 10 N, W: 7 rad/s}
bodies: {block: {particle: {mass: m}, at: [0, 0]}}
connections: {g: {slider: {body: block, along: right}}}
loads: {s: {law: {measure: x, force: -k*x}}, f: {force: {at: block, along: right, magnitude: F*sin(W*t)}}}
measures: {x: x of block}
start: {x: 0, rate(x): 0}
"""


def test_the_first_turn_of_a_forced_motion_is_not_taken_for_its_farthest() -> None:
    answer = fb.System.from_text(FORCED).solve("greatest x")["q1"]
    # x = F/(m (w^2 - W^2)) (sin W t - W/w sin w t), w = 10: both sides alike over the common period 2 pi s
    assert answer.value is None
    assert "it gets farther later on: in a simulation of 60 s" in str(answer.reason)


def test_resonance_without_damping_has_no_steady_amplitude_in_numbers_either() -> None:
    model = FORCED.replace(", W: 7 rad/s", "").replace("W*t", "sqrt(k/m)*t")
    answer = fb.System.from_text(model).solve("steady amplitude of x")["q1"]
    assert answer.value is None
    assert "resonance without damping" in str(answer.reason)


def test_the_work_of_a_driver_is_what_the_energy_gains() -> None:
    model = """
parameters: {m: 2 kg, L: 1 m, w: 3 rad/s, a: 30 deg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {arm: {rod: {mass: m, length: L}}}
connections: {O: {pin: [ground.O, arm.start]}, motor: {driver: {measure: phi, follows: w*t}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of arm}
"""
    # at a constant rate T stays, and the centre rises by L/2 sin phi
    assert_same_function(expression(model, "work of motor until phi = a"), "m*g*L/2*sin(a)", {"a": 0.5})


# Meriam & Kraige, Statics: ice tongs on a block; moments about the pivot give N h = W b, the ring T cos = W/2
TONGS = """
parameters: {W: 800 N, b: 0.2 m, h: 0.3 m, k: 0.15 m, mu: 0.8, g: 9.81 m/s^2}
ground: {points: {hook: [0, h + k]}}
bodies:
  ring: {particle: {}, at: [0, h + k]}
  left: {body: {}, at: [0, h], angle: 0, points: {top: [b, 0], tip: [-b, -h]}}
  right: {body: {}, at: [0, h], angle: 0, points: {top: [-b, 0], tip: [b, -h]}}
  block: {rectangle: {mass: W/g, width: 2*b, height: 0.4 m}, at: [0, 0], angle: 0}
connections:
  pivot: {pin: [left, right]}
  h: {weld: [ground.hook, ring]}
  rl: {link: [ring, left.top]}
  rr: {link: [ring, right.top]}
  cl: {contact: {between: [left.tip, block], friction: mu}}
  cr: {contact: {between: [right.tip, block], friction: mu}}
loads: {weight: {gravity: g}}
"""


def test_forces_at_rest_need_no_formulas_of_the_motion() -> None:
    near = {"b": 0.2, "h": 0.3, "k": 0.15, "mu": 0.8}
    solution = fb.System.from_text(TONGS).solve(["normal force of cl", "tension of rl"])
    for name, expected in (("q1", "W*b/h"), ("q2", "W/2*sqrt(b**2 + k**2)/k")):
        found = solution[name].expression
        assert isinstance(found, Expr)
        assert_same_function(to_python(found), expected, near)


def test_in_exact_resonance_the_value_is_that_of_the_motion() -> None:
    answer = fb.System.from_text(FORCED.replace("W: 7", "W: 10")).solve("x at t = 1 s")["q1"]
    # x = F/(2 m w^2) (sin w t - w t cos w t), the limit of the forced law for W -> w
    expected = 10 / (2 * 2 * 100) * (math.sin(10) - 10 * math.cos(10))
    assert answer.value == pytest.approx(expected, rel=1e-9)
    assert "the value is that of the simulated motion" in [str(note) for note in answer.notes]


# Meriam & Kraige, Statics, 4/6: an A-frame on a roller; moments of one leg about the apex give F a/2 = T (h - e)
A_FRAME = """
parameters: {F: 600 N, a: 1.2 m, h: 2 m, e: 0.5 m}
ground: {points: {A: [-a, 0]}, lines: {floor: {along: right}}}
bodies:
  left: {body: {}, points: {foot: [-a, 0], tie: [-a*(1 - e/h), e], top: [0, h]}, at: [0, 0], angle: 0}
  right: {body: {}, points: {foot: [a, 0], tie: [a*(1 - e/h), e], top: [0, h]}, at: [0, 0], angle: 0}
connections:
  A: {pin: [ground.A, left.foot]}
  C: {pin: [left.top, right.top]}
  roller: {slot: {pin: right.foot, along: right}}
  rope: {link: [left.tie, right.tie]}
loads: {load: {force: {at: left.top, along: down, magnitude: F}}}
"""
# Meriam & Kraige, Statics, 6/5: a screw of two pitches moves its jaw by their difference in a turn: 2 pi T = F (p - q)
DIFFERENTIAL_SCREW = """
space: {up: z}
parameters: {p: 4 mm, q: 3 mm, T: 2 N m, F: 1 kN}
bodies: {screw: {body: {}}, jaw: {body: {}}}
connections:
  upper: {screw: {first: ground.O, second: screw, about: z, pitch: p}}
  lower: {screw: {first: screw, second: jaw, about: z, pitch: q}}
  guide: {prismatic: {first: ground.O, second: jaw, along: z}}
loads:
  hand: {torque: {on: screw, about: z, magnitude: T}}
  work: {force: {at: jaw, along: down, magnitude: F}}
measures: {phi: angle of screw about z, z1: z of jaw}
start: {phi: 0}
"""
# Norton, Design of Machinery, 9.9: a stepped planet between a sun r1 and a fixed ring r1 + r2 + r3 (Willis)
STEPPED_PLANET = """
parameters: {r1: 30 mm, r2: 50 mm, r3: 20 mm, T: 3 N m}
bodies:
  sun: {body: {inertia: 0.01 kg m^2, radius: r1}}
  ring: {ring: {radius: r1 + r2 + r3}, fixed: true}
  carrier: {body: {inertia: 0.1 kg m^2}, points: {P: [r1 + r2, 0]}, angle: 0}
  planet: {body: {mass: 1 kg, inertia: 0.001 kg m^2}, at: [r1 + r2, 0]}
connections:
  s: {pin: [ground.O, sun]}
  c: {pin: [ground.O, carrier]}
  p: {pin: [carrier.P, planet]}
  inner: {gear_mesh: {first: sun, second: planet, second_radius: r2}}
  outer: {gear_mesh: {first: ring, second: planet, internal: true, second_radius: r3}}
loads: {drive: {torque: {on: sun, magnitude: T}}}
measures: {theta: angle of sun, phi: angle of carrier}
start: {theta: 0}
"""
# Beer & Johnston, Statics, 6.4: a scissors lift; virtual work with y = L sin and x = L cos gives H = W cot(theta)
SCISSORS = """
parameters: {L: 2 m, theta: 35 deg, W: 3 kN, H: 3 kN}
ground: {points: {A: [0, 0]}, lines: {floor: {along: right}}}
bodies:
  p: {rod: {length: L}, at: {start: [0, 0]}, angle: theta}
  q: {rod: {length: L}, angle: 180 deg - theta}
  table: {body: {}, points: {end: [L*cos(theta), 0]}, angle: 0}
connections:
  A: {pin: [ground.A, p.start]}
  X: {pin: [p.center, q.center]}
  roller: {slot: {pin: q.start, along: right, through: ground.A}}
  T: {pin: [q.end, table]}
  R: {slot: {pin: p.end, along: x, on: table}}
loads:
  load: {force: {at: table.end, along: down, magnitude: W}}
  ram: {force: {at: q.start, along: left, magnitude: H}}
"""
# Meriam & Kraige, Statics, 7/4: two bars and a spring under a load: m g = 2 tan(theta) k (2 L cos(theta) - l0)
SPRUNG_BARS = """
parameters: {L: 0.5 m, k: 2 kN/m, l0: 0.3 m, m: 8 kg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}, lines: {floor: {along: right}}}
bodies: {p: {rod: {length: L}, at: {start: [0, 0]}}, q: {rod: {length: L}}, load: {particle: {mass: m}}}
connections:
  A: {pin: [ground.A, p.start]}
  B: {pin: [p.end, q.start]}
  C: {slot: {pin: q.end, along: right, through: ground.A}}
  D: {pin: [p.end, load]}
loads: {weight: {gravity: g}, s: {spring: {first: ground.A, second: q.end, stiffness: k, length: l0}}}
measures: {theta: angle of p}
start: {theta: 50 deg}
"""
# Shigley & Uicker, Theory of Machines, 3: the Geneva slot, tan(psi) = a sin/(a cos - c) for the crank a
GENEVA = """
parameters: {a: 0.1 m, w: 5 rad/s, c: 0.15 m}
ground: {points: {O: [0, 0], Q: [c, 0]}}
bodies: {driver: {rod: {length: a}}, cross: {body: {inertia: 0.01 kg m^2}, angle: 180 deg}}
connections:
  O: {pin: [ground.O, driver.start]}
  Q: {pin: [ground.Q, cross]}
  slot: {slot: {pin: driver.end, along: x, on: cross}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: angle of driver, psi: angle of cross}
"""


@pytest.mark.parametrize(
    ("model", "question", "expected", "near"),
    [
        (A_FRAME, "tension of rope", "F*a/(2*(h - e))", {"h": 2.0, "e": 0.5}),
        (A_FRAME, "value of e for which tension of rope = F", "h - a/2", {"h": 2.0, "a": 1.2}),
        (DIFFERENTIAL_SCREW, "value of F for which it is at rest", "2*pi*T/(p - q)", {"p": 4e-3, "q": 3e-3}),
        (STEPPED_PLANET, "ratio of rate of phi to rate of theta", "r1*r3/(r1*r3 + r2*(r1 + r2 + r3))", {}),
        (SCISSORS, "value of H for which it is at rest", "W/tan(theta)", {"theta": 0.6}),
        (SPRUNG_BARS, "value of m for which equilibrium of theta = 45 deg", "2*k*(sqrt(2)*L - l0)/g", {"l0": 0.3}),
        (
            GENEVA,
            "acceleration of psi when theta = 30 deg",
            "a*c*w**2*(c**2 - a**2)/2/(a**2 + c**2 - sqrt(3)*a*c)**2",
            {},
        ),
    ],
)
def test_machines_have_the_formulas_of_their_textbooks(
    model: str, question: str, expected: str, near: dict[str, float]
) -> None:
    assert_same_function(expression(model, question), expected, near)


def test_a_value_that_the_sign_of_a_parameter_forbids_is_told() -> None:
    """F - 2 P = m a is zero for P = F/2; with 2 P + F it is so for P = -F/2 alone."""
    model = """
parameters: {m: 2 kg, F: 5 N, P: 1 N}
bodies: {block: {particle: {mass: m}}}
connections: {g: {slider: {body: block, along: right}}}
loads: {f: {force: {at: block, along: right, magnitude: F + 2*P}}}
measures: {x: x of block}
"""
    reason = str(fb.System.from_text(model).solve("value of P for which acceleration of x = 0")["q1"].reason)
    assert reason.startswith("that is so for P = -F/2 alone, which is negative")


WESTON = """
parameters: {I: 0.05 kg m^2, R: 0.12 m, r: 0.1 m, m: 50 kg, F: 30 N, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {shaft: {body: {inertia: I, radius: R}}, block: {disk: {mass: m, radius: (R + r)/2}}, hand: {particle: {}}}
connections:
  axle: {pin: [ground.O, shaft]}
  chain: {string: {path: [wound on shaft radius R at right, under block, wound on shaft radius r at left]}}
  pull: {string: {path: [wound on shaft radius R at left, hand]}}
loads: {weight: {gravity: g}, hand: {force: {at: hand, along: down, magnitude: F}}}
measures: {y: height of block}
"""


def test_both_runs_of_a_differential_pulley_can_be_asked_for_and_obey_the_laws_of_block_and_shaft() -> None:
    """m (g + y'') = T_R + T_r and, with phi'' = 2 y''/(R - r), I phi'' = R F - R T_R + r T_r; the chain leads from the
    larger drum to the block."""
    asked = [
        "tension of chain between shaft and block",
        "tension of chain between block and shaft",
        "acceleration of y",
    ]
    solution = fb.System.from_text(WESTON).solve([*asked, "value of F for which acceleration of y = 0"])
    larger, smaller, up, least = (answer.value for answer in solution.answers)
    assert larger + smaller == pytest.approx(50.0 * (9.81 + up), rel=1e-12)
    assert 0.05 * 2.0 * up / 0.02 == pytest.approx(0.12 * 30.0 - 0.12 * larger + 0.1 * smaller, rel=1e-9)
    assert least == pytest.approx(50.0 * 9.81 * 0.02 / (2.0 * 0.12), rel=1e-12)
