"""Statics with dry friction: closed forms of the textbooks, the linear programs beside them, and how it fails."""

from __future__ import annotations

import itertools
import json
import math
import random
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from command import freebody
from freebody.numeric.circular_programs import CircularProgram
from freebody.numeric.contact import problem as contact
from freebody.numeric.contact.forces import contact_forces
from freebody.numeric.friction_branches import Sector, extreme, margin, spread
from freebody.numeric.friction_limits import at, ray
from freebody.numeric.reference import Reference
from freebody.numeric.rest_problem import RestProblem, rest_problem
from freebody.study.friction.answers import prepared
from freebody.study.friction.touching import touching

Agree = Callable[[fb.Solution, str, str | list[str]], None]

LADDER = """
parameters: {m: 10 kg, M: 60 kg, L: 4 m, d: 1.5 m, alpha: 60 deg, mu: 0.5, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up, through: [0, 0]}}}
bodies: {ladder: {rod: {mass: m, length: L}, angle: alpha, points: {rung: [d - L/2, 0]}}}
connections:
  floor: {contact: {between: [ladder, ground.floor], friction: mu}}
  wall: {contact: {between: [ladder, ground.wall], friction: WALL}}
loads: {weight: {gravity: g}PERSON}
"""
PERSON = ", person: {force: {at: ladder.rung, along: down, magnitude: M*g}}"
SMOOTH = LADDER.replace("WALL", "0").replace("PERSON", "")
ROUGH = LADDER.replace("WALL", "mu").replace("PERSON", "")
CLIMBED = LADDER.replace("WALL", "0").replace("PERSON", PERSON)

BLOCK = """
parameters: {m: 10 kg, b: 0.5 m, h: 1 m, d: 0.8 m, mu: 0.4, F: 10 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {rectangle: {mass: m, width: b, height: h}, points: {P: [0, d - h/2]}}}
connections: {floor: {contact: {between: [block, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: block.P, along: right, magnitude: F}}}
"""

INCLINE = """
parameters: {m: 10 kg, theta: 20 deg, mu: 0.5, F: 50 N, g: 9.81 m/s^2}
ground: {lines: {slope: {along: theta}}}
bodies: {block: {particle: {mass: m}}}
connections: {slope: {contact: {between: [block, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}PUSH}
"""
RESTING = INCLINE.replace("PUSH", "").replace("F: 50 N, ", "")
PUSHED = INCLINE.replace("PUSH", ", push: {force: {at: block, along: right, magnitude: F}}")
LEANING = INCLINE.replace("PUSH", ", push: {force: {at: block, along: theta, magnitude: F}}")

CYLINDERS = """
parameters: {m: 2 kg, R: 0.1 m, mu: 0.4, nu: 0.2, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  a: {disk: {mass: m, radius: R}, at: [-R, R]}
  b: {disk: {mass: m, radius: R}, at: [R, R]}
  c: {disk: {mass: m, radius: R}, at: [0, R*(1 + sqrt(3))]}
connections:
  fa: {contact: {between: [a, ground.floor], friction: nu, touching: true}}
  fb: {contact: {between: [b, ground.floor], friction: nu, touching: true}}
  ca: {contact: {between: [c, a], friction: mu, touching: true}}
  cb: {contact: {between: [c, b], friction: mu, touching: true}}
loads: {weight: {gravity: g}}
"""

WEDGED = """
parameters: {m: 10 kg, b: 0.5 m, h: 0.3 m, mu: 0.4, g: 9.81 m/s^2}
ground: {lines: {left: {along: down}, right: {along: up, through: [b, 0]}}}
bodies: {block: {rectangle: {mass: m, width: b, height: h}, at: [b/2, 0]}}
connections:
  l: {contact: {between: [block, ground.left], friction: mu, touching: true}}
  r: {contact: {between: [block, ground.right], friction: mu, touching: true}}
loads: {weight: {gravity: g}}
"""

BEAM = """
parameters: {m: 10 kg, L: 2 m, d: 0.3 m, F: 20 N, mu: 0.4, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {table: {rod: {mass: m, length: L}, angle: 0, points: {one: [-L/2, 0], two: [d, 0], three: [L/2, 0]}}}
connections:
  one: {contact: {between: [table.one, ground.floor], friction: mu}}
  two: {contact: {between: [table.two, ground.floor], friction: mu}}
  three: {contact: {between: [table.three, ground.floor], friction: mu}}
loads: {weight: {gravity: g}, pull: {force: {at: table, along: right, magnitude: F}}}
"""

PIN = """
parameters: {m: 2 kg, R: 0.1 m, r: 0.02 m, mu: 0.3, F: 1 N, g: 9.81 m/s^2}
bodies: {disk: {disk: {mass: m, radius: R}, points: {rim: [R, 0]}}}
connections: {p: {pin: {first: ground.A, second: disk, friction: mu, radius: r}}}
loads: {weight: {gravity: g}, push: {force: {at: disk.rim, along: up, magnitude: F}}}
"""

VISE = """
space: true
parameters: {Q: 10 kN, F: 100 N, L: 200 mm, p: 4 mm, mu: 0.15, r: 9 mm}
bodies:
  jaw: {box: {mass: 2 kg, size: [0.1 m, 0.1 m, 0.1 m]}}
  spindle: {cylinder: {mass: 1 kg, radius: 10 mm, length: 0.3 m, axis: x}}
connections:
  guide: {prismatic: {first: ground.O, second: jaw, along: x}}
  bearing: {revolute: {first: jaw, second: spindle, about: x}}
  thread: {screw: {first: ground.O, second: spindle, about: x, pitch: p, friction: mu, radius: r}}
loads:
  handle: {torque: {on: spindle, magnitude: F*L, about: x}}
  work: {force: {at: jaw, along: left, magnitude: Q}}
"""

BOX = """
parameters: {m: 5 kg, b: 0.2 m, h: 0.5 m, mu: 0.6, alpha: 15 deg, g: 9.81 m/s^2}
ground: {lines: {incline: {along: -alpha}}, points: {top: [-1 m, 1 m]}}
bodies:
  box: {rectangle: {mass: m, width: b, height: h}}
connections:
  touch: {contact: {between: [box, incline], friction: mu}}
loads: {weight: {gravity: g}}
"""

BRAKE = """
parameters: {m: 2 kg, R: 0.1 m, T: 5 N m, M: 3 kg, g: 9.81 m/s^2}
bodies: {drum: {disk: {mass: m, radius: R}}, load: {particle: {mass: M}}}
connections:
  p: {pin: [ground.A, drum]}
  s: {string: {path: [wound on drum at right, load]}}
  it: {brake: {between: [drum, ground], torque: T}}
loads: {weight: {gravity: g}}
"""

LIFTED = """
parameters: {W: 800 N, M: 2 kg, L: 0.4 m, alpha: 12 deg, mu: 0.2, F: 400 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up, through: [L/2, 0]}}}
bodies:
  wedge: {polygon: {mass: M, corners: [[0, 0], [L, 0], [0, L*tan(alpha)]]}, at: [0, 0], angle: 0}
  load: {particle: {mass: W/g}, at: [L/2, L*tan(alpha)/2]}
connections:
  floor: {contact: {between: [wedge, ground.floor], friction: mu, touching: true}}
  face: {contact: {between: [load, wedge], friction: mu, touching: true}}
  wall: {contact: {between: [load, ground.wall], friction: mu, touching: true}}
loads: {weight: {gravity: g}, drive: {force: {at: wedge.corner1, along: right, magnitude: F}}}
"""

# forces alone: a wedge is a particle that carries its face as a line
WEDGE = """
parameters: {W: 5 kN, alpha: 8 deg, mu: 0.2, P: 2 kN, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up}}}
bodies:
  wedge: {particle: {mass: 0}, lines: {face: {along: -alpha}}}
  block: {particle: {mass: W/g}}
connections:
  floor: {contact: {between: [wedge, floor], friction: mu}}
  face: {contact: {between: [block, wedge.face], friction: mu}}
  wall: {contact: {between: [block, wall], friction: mu}}
loads: {weight: {gravity: g}, drive: {force: {at: wedge, along: right, magnitude: P}}}
"""

WEDGE_PAIR = """
parameters: {W: 5 kN, alpha: 8 deg, mu: 0.2, P: 2 kN, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up}}}
bodies:
  lower: {particle: {mass: 0}, lines: {face: {along: -alpha}}}
  upper: {particle: {mass: 0}, lines: {top: {along: right}}}
  block: {particle: {mass: W/g}}
connections:
  floor: {contact: {between: [lower, floor], friction: mu}}
  face: {contact: {between: [upper, lower.face], friction: mu}}
  stop: {contact: {between: [upper, wall]}}
  top: {contact: {between: [block, upper.top], friction: mu}}
loads: {weight: {gravity: g}, drive: {force: {at: lower, along: right, magnitude: P}}}
"""

CURB = """
parameters: {m: 20 kg, R: 0.4 m, h: 0.1 m, mu: 0.8, F: 100 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}, points: {edge: [sqrt(R**2 - (R - h)**2), h]}}
bodies: {wheel: {disk: {mass: m, radius: R}, at: [0, R]}}
connections:
  floor: {contact: {between: [wheel, ground.floor], friction: mu, touching: true}}
  curb: {contact: {between: [wheel, ground.edge], friction: mu, touching: true}}
loads: {weight: {gravity: g}, pull: {force: {at: wheel, along: right, magnitude: F}}}
"""

CAR = """
parameters: {m: 1000 kg, a: 1.2 m, b: 1.4 m, h: 0.5 m, theta: 15 deg, mu: 0.6, g: 9.81 m/s^2}
ground: {lines: {road: {along: theta}}}
bodies: {car: {body: {mass: m, inertia: 1000 kg m^2}, angle: theta, points: {front: [a, -h], rear: [-b, -h]}}}
connections:
  front: {contact: {between: [car.front, ground.road]}}
  rear: {contact: {between: [car.rear, ground.road], friction: mu}}
loads: {weight: {gravity: g}}
"""

BRACKET = """
parameters: {m: 2 kg, mu: 0.3, F: 50 N, a: 0.3 m, b: 0.1 m}
bodies:
  arm: {body: {mass: m, inertia: 1 kg m^2}, at: [0, 0], angle: 0, points: {top: [0, b/2], low: [0, -b/2], tip: [a, 0]}}
connections:
  t: {slot: {pin: arm.top, along: up, through: ground.origin, friction: mu}}
  u: {slot: {pin: arm.low, along: up, through: ground.origin, friction: mu}}
loads: {push: {force: {at: arm.tip, along: down, magnitude: F}}}
"""

ROLLER = """
parameters: {m: 20 kg, R: 0.4 m, f: 0.01 m, mu: 0.8, theta: 1 deg, g: 9.81 m/s^2}
ground: {lines: {slope: {along: theta}}}
bodies: {wheel: {disk: {mass: m, radius: R}}}
connections: {slope: {contact: {between: [wheel, ground.slope], friction: mu, rolling_resistance: f}}}
loads: {weight: {gravity: g}}
"""

PILE = """
parameters: {m: 2 kg, M: 5 kg, b: 0.4 m, h: 0.2 m, mu: 0.3, nu: 0.4, F: 5 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  lower: {rectangle: {mass: M, width: 2*b, height: h}, at: [0, h/2], angle: 0}
  upper: {rectangle: {mass: m, width: b, height: h}, at: [0, 3*h/2], angle: 0}
connections:
  floor: {contact: {between: [lower, ground.floor], friction: nu, touching: true}}
  mid: {contact: {between: [upper, lower], friction: mu, touching: true}}
loads: {weight: {gravity: g}, pull: {force: {at: upper, along: right, magnitude: F}}}
"""
_FACE = "(W/((1 - mu**2)*cos(alpha) - 2*mu*sin(alpha)))"


def asked(model: str, question: str) -> fb.Solution:
    return fb.solve(fb.System.from_text(model), question)


# Formulas derived in the comments; BJ: Beer & Johnston, Vector Mechanics for Engineers: Statics, ch. 8
@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # moments about the foot: N_wall L sin = m g L/2 cos; at the floor N = m g, T = N_wall
        (SMOOTH, "least mu so that it stays at rest", "1/(2*tan(alpha))"),
        pytest.param(SMOOTH, "least alpha so that it stays at rest", "atan(1/(2*mu))", marks=pytest.mark.slow),
        # both contacts at their limits: the reactions meet above the mass centre, alpha = 90 deg - 2 phi, mu = tan(phi)
        (ROUGH, "least mu so that it stays at rest", "tan(pi/4 - alpha/2)"),
        pytest.param(ROUGH, "least alpha so that it stays at rest", "pi/2 - 2*atan(mu)", marks=pytest.mark.slow),
        # moments about the foot with the person at d
        (CLIMBED, "largest d so that it stays at rest", "L*(mu*(m + M)*tan(alpha) - m/2)/M"),
        pytest.param(
            CLIMBED, "least mu so that it stays at rest", "(m*L/2 + M*d)/((m + M)*L*tan(alpha))", marks=pytest.mark.slow
        ),
        # moments about the right corner; for mu < b/(2 d) it slides instead
        (BLOCK, "does it tip or slide as F grows", "m*g*b/(2*d)"),
        (BLOCK.replace("mu: 0.4", "mu: 0.2"), "does it tip or slide as F grows", "mu*m*g"),
        pytest.param(
            BLOCK, "range of F that keeps it at rest", ["-m*g*b/(2*d)", "m*g*b/(2*d)"], marks=pytest.mark.slow
        ),
        (BLOCK, "least mu so that it stays at rest", "F/(m*g)"),
        # BJ sec. 8.2: angle of repose
        pytest.param(RESTING, "least mu so that it stays at rest", "tan(theta)", marks=pytest.mark.slow),
        (RESTING, "largest theta so that it stays at rest", "atan(mu)"),
        # F = W tan(theta -+ phi)
        (PUSHED, "range of F that keeps it at rest", ["m*g*tan(theta - atan(mu))", "m*g*tan(theta + atan(mu))"]),
        (
            LEANING,
            "range of F that keeps it at rest",
            ["m*g*(sin(theta) - mu*cos(theta))", "m*g*(sin(theta) + mu*cos(theta))"],
        ),
        # of each lower cylinder: moments about its foot give mu = tan(15 deg); about its top contact nu = mu/3
        (CYLINDERS, "least mu so that it stays at rest", "2 - sqrt(3)"),
        pytest.param(CYLINDERS, "least nu so that it stays at rest", "(2 - sqrt(3))/3", marks=pytest.mark.slow),
        # |T| = mu r |R| with R the weight less the push; moment F R
        (PIN, "range of F that keeps it at rest", ["-mu*r*m*g/(R - mu*r)", "mu*r*m*g/(R + mu*r)"]),
        pytest.param(PIN, "least mu so that it stays at rest", "F*R/(r*(m*g - F))", marks=pytest.mark.slow),
        (BRAKE, "largest M so that it stays at rest", "T/(g*R)"),
        pytest.param(BRAKE, "least T so that it stays at rest", "M*g*R", marks=pytest.mark.slow),
        # load: N2 (sin + mu cos) = N_wall, N2 (cos - mu sin) = W + mu N_wall; wedge: floor carries M g and N2's part
        (
            LIFTED,
            "largest F so that it stays at rest",
            f"mu*(M*g + {_FACE}*(cos(alpha) - mu*sin(alpha))) + {_FACE}*(sin(alpha) + mu*cos(alpha))",
        ),
        # R2 (sin(alpha + phi), cos(alpha + phi)) on the block, N3 (-1, -tan(phi)) of the wall
        (WEDGE, "largest P so that it stays at rest", "W*tan(alpha + 2*atan(mu))"),
        # the block stands still, a smooth stop keeps the upper wedge: R (sin, cos)(alpha + phi), R cos = W
        (WEDGE_PAIR, "largest P so that it stays at rest", "W*(tan(alpha + atan(mu)) + mu)"),
        # moments about the edge of the curb: F (R - h) = m g sqrt(R^2 - (R - h)^2)
        (CURB, "largest F so that it stays at rest", "m*g*sqrt(R**2 - (R - h)**2)/(R - h)"),
        # moments about the front wheels: N_rear (a + b) = m g (a cos + h sin), mu N_rear = m g sin
        (CAR, "least mu so that it stays at rest", "(a + b)*sin(theta)/(a*cos(theta) + h*sin(theta))"),
        pytest.param(
            CAR, "largest theta so that it stays at rest", "atan(mu*a/(a + b - mu*h))", marks=pytest.mark.slow
        ),
        # two equal normal forces F a/b carry the load: 2 mu F a/b = F
        (BRACKET, "least mu so that it stays at rest", "b/(2*a)"),
        # the normal force acts f before the middle
        (ROLLER, "largest theta so that it stays at rest", "atan(f/R)"),
        (PILE, "largest F so that it stays at rest", "mu*m*g"),
        # the middle support takes from all to nothing
        (BEAM, "range of normal force of two", ["0", "m*g*L/(L + 2*d)"]),
        pytest.param(BEAM, "range of normal force of one", ["2*d*m*g/(L + 2*d)", "m*g/2"], marks=pytest.mark.slow),
        # floor and wall at the limit of the wall: N (sin -+ mu cos) = m g cos/2
        (
            ROUGH.replace("alpha: 60", "alpha: 70"),
            "range of normal force of wall",
            ["m*g*cos(alpha)/(2*(sin(alpha) + mu*cos(alpha)))", "m*g*cos(alpha)/(2*(sin(alpha) - mu*cos(alpha)))"],
        ),
    ],
)
def test_limit_is_the_formula_of_the_textbook(
    model: str, question: str, expected: str | list[str], agrees: Agree
) -> None:
    solution = asked(model, question)
    agrees(solution, "q1", expected)
    evidence = solution["q1"].evidence
    assert evidence is not None
    assert evidence.draws >= 5


def test_block_answer_names_both_failures_and_the_condition_that_decides() -> None:
    answer = asked(BLOCK, "does it tip or slide as F grows")["q1"]
    assert answer.conditions == ("2·d·μ ≥ b (block.bottom_right does not slip)",)
    assert answer.notes == ("first: block tips about block.bottom_right, at this F",)
    assert [(case.what, case.conditions) for case in answer.cases] == [
        ("block tips about block.bottom_right", ("2·d·μ ≥ b",)),
        ("block slips to the right on floor", ("b ≥ 2·d·μ",)),
    ]


@pytest.mark.parametrize(
    ("model", "reserve", "condition"),
    [
        (RESTING, "mu*cos(theta) - sin(theta)", "μ·cos(θ) ≥ sin(θ) (else block slips down to the left on slope)"),
        (SMOOTH, "2*mu*sin(alpha) - cos(alpha)", "2·μ·sin(α) ≥ cos(α) (else ladder.start slips to the left on floor)"),
    ],
)
def test_does_it_hold_is_answered_by_the_inequality(model: str, reserve: str, condition: str, agrees: Agree) -> None:
    solution = asked(model, "does it hold")
    agrees(solution, "q1", reserve)
    assert solution["q1"].conditions == (condition,)
    assert solution["q1"].verdict == "with the given numbers it holds"


def test_a_block_that_does_not_hold_is_said_to_slide_down() -> None:
    answer = asked(RESTING.replace("mu: 0.5", "mu: 0.3"), "does it hold")["q1"]
    assert answer.verdict == "with the given numbers it does not hold: block slips down to the left on slope"


def test_self_locking_force_has_no_upper_limit() -> None:
    # tan(theta + phi) is infinite at theta + phi = 90 deg
    answer = asked(PUSHED.replace("20 deg", "70 deg"), "largest F so that it stays at rest")["q1"]
    assert answer.expression is None
    assert answer.reason == "there is no upper limit"


@pytest.mark.slow
@pytest.mark.parametrize("own", [10e3, 8e3])
def test_least_load_that_a_self_locking_thread_needs_is_not_that_with_which_it_would_be_pulled(own: float) -> None:
    """It holds by Q >= F L/(r tan(lambda + phi)), and, pulled the other way, by some Q far below zero, too."""
    lead, friction = math.atan(4 / (2 * math.pi * 9)), math.atan(0.15)
    vise = VISE.replace("Q: 10 kN", f"Q: {own} N")
    least = asked(vise, "least Q so that it stays at rest").answers[0].value
    assert least == pytest.approx(100 * 0.2 / (0.009 * math.tan(lead + friction)))


def test_a_box_on_an_incline_lies_flat_where_nobody_says_how_it_is_turned() -> None:
    """It stood on one corner at rest, inside the incline with the other one; in a motion it lay flat."""
    found = asked(BOX, "largest alpha so that it stays at rest").answers[0]
    assert found.value == pytest.approx(math.atan(0.2 / 0.5))
    assert not fb.System.from_text(BOX).warnings
    rope = "connections: {rope: {string: {from: ground.top, to: box}},"
    tied = BOX.replace("connections:\n  touch", f"{rope} touch").replace("mu}}\nloads", "mu}}}\nloads")
    assert fb.System.from_text(tied).statics().holds


def test_a_rope_many_times_round_a_drum_is_compared_where_numbers_tell() -> None:
    """e^(mu 2 pi n) of the draws reaches 1e8: what holds the slack end is round-off of what pulls at the other one."""
    capstan = """
parameters: {W: 4 kN, mu: 0.25, n: 3, r: 0.2 m, P: 50 N}
bodies:
  drum: {disk: {radius: r}, fixed: true, at: [0, 0]}
  boat: {particle: {mass: 0}}
  sailor: {particle: {mass: 0}}
connections: {line: {rope: {from: sailor, over: [drum], to: boat, friction: mu, wrap: {drum: n*2*pi}}}}
loads:
  pull: {force: {at: boat, along: down, magnitude: W}}
  hold: {force: {at: sailor, along: down, magnitude: P}}
"""
    largest = asked(capstan, "largest W so that it stays at rest").answers[0].value
    assert largest == pytest.approx(50 * math.exp(0.25 * 6 * math.pi))


def test_block_wedged_between_walls_has_reactions_without_limit() -> None:
    found = fb.statics(fb.System.from_text(WEDGED))
    assert found.holds
    assert all(r.low == 0.0 and math.isinf(r.high) for r in found.reactions if r.reaction == "normal force")
    answer = asked(WEDGED, "range of normal force of l at top_left")["q1"]
    assert "there is no upper limit" in answer.notes
    least = asked(WEDGED, "least mu so that it stays at rest")["q1"]
    assert least.notes == ("there is no lower limit: μ need only be larger than 0",)


def test_a_disk_that_rolls_off_does_not_slip_at_rest() -> None:
    """Rest ends at F = 0, by rolling: no slip has to do with it, so words of slipping mean the motion, F <= 3 mu m g
    (F = 3/2 m a and a friction of m a/2, BJ Dynamics ch. 16)."""
    spool = """
parameters: {m: 3 kg, R: 0.2 m, F: 5 N, mu: 0.5, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {spool: {disk: {mass: m, radius: R}}}
connections: {floor: {contact: {between: [spool, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: spool, along: right, magnitude: F}}}
measures: {x: {x of spool}}
start: {x: 0, rate(x): 0}
"""
    rest = asked(spool, "largest F so that it stays at rest")["q1"]
    assert rest.value == 0.0
    assert not any("slips" in str(note) for note in rest.notes)
    slip = asked(spool, "largest F so that it does not slip")["q1"]
    assert slip.value == pytest.approx(3 * 0.5 * 3 * 9.81)


def test_no_coefficient_of_friction_helps_where_the_block_tips() -> None:
    answer = asked(BLOCK.replace("F: 10 N", "F: 40 N"), "least mu so that it stays at rest")["q1"]
    assert answer.reason == "no value of mu keeps the system at rest: block tips about block.bottom_right"


@pytest.mark.parametrize(
    ("question", "problem"),
    [
        ("range of G that keeps it at rest", "there is no parameter G. There is: L, M"),
        ("does it tip or slide", "say as what grows"),
        ("range of normal force of wal", "there is no connection wal. Did you mean wall"),
        ("range of tension of wall", "wall has no tension"),
    ],
)
def test_a_question_that_cannot_be_read_says_why(question: str, problem: str) -> None:
    with pytest.raises(fb.ModelError, match=problem.replace("?", "\\?")):
        asked(SMOOTH, question)


def test_a_system_that_moves_is_not_at_rest() -> None:
    model = RESTING.replace(
        "{particle: {mass: m}}", "{particle: {mass: m}, velocity: [v*cos(theta), v*sin(theta)]}"
    ).replace("theta: 20", "v: 1 m/s, theta: 20")
    with pytest.raises(fb.CannotAnswer, match="block moves at the start"):
        fb.statics(fb.System.from_text(model))


# -- the linear programs ----------------------------------------------------------------------
def rest(model: str, **values: float) -> RestProblem:
    system = fb.System.from_text(model)
    touched = touching(system)
    reference = Reference(touched.held, values)
    return rest_problem(reference, reference.assemble(), touched.dry_friction)


def test_ladder_holds_with_a_margin_and_fails_by_slipping() -> None:
    assert margin(rest(SMOOTH, mu=0.3)).value > 0.0  # type: ignore[union-attr]
    failing = margin(rest(SMOOTH, mu=0.28))
    assert failing is not None
    assert failing.value < 0.0
    assert failing.motion[2] < 0.0  # the ladder comes down


def test_largest_and_smallest_parameter_are_those_of_the_same_ray() -> None:
    path = ray(rest(BLOCK, F=10.0), rest(BLOCK, F=20.0), 10.0)
    top, bottom = extreme(path, 1), extreme(path, -1)
    assert top is not None
    assert bottom is not None
    assert top.value == pytest.approx(10 * 9.81 * 0.5 / 1.6, rel=1e-13)
    assert bottom.value == pytest.approx(-top.value, rel=1e-13)
    for share, holds in ((0.999999, True), (1.000001, False)):
        found = margin(at(path, share * top.value))
        assert found is not None
        assert (found.value >= 0.0) == holds


def test_pin_friction_is_bounded_by_the_size_of_the_force_in_any_direction() -> None:
    # one reaction of open direction: both ends of the torque by |R| mu r
    problem = rest(PIN, F=0.0)
    ends = spread(problem, problem.place("p.friction"))
    assert ends is not None
    assert [e.value for e in ends] == pytest.approx([0.0, 0.0], abs=1e-9)  # moments alone decide
    tilted = rest(PIN, F=1.0, mu=0.26)
    assert margin(tilted).value < 0.0  # type: ignore[union-attr]
    assert margin(rest(PIN, F=1.0, mu=0.28)).value > 0.0  # type: ignore[union-attr]


SEEDS = range(6)


@pytest.mark.parametrize("seed", SEEDS)
def test_random_row_of_blocks_leans_as_the_closed_form_says(seed: int) -> None:
    """Blocks of random sizes side by side, the first one pushed: the limit is the least of all ways to fail."""
    rng = random.Random(seed)
    b, h, m, mu, d = (rng.uniform(*r) for r in ((0.2, 1.0), (0.4, 1.2), (1, 20), (0.1, 0.9), (0.05, 0.4)))
    system = fb.System.from_text(BLOCK).with_parameters(b=b, h=h, m=m, mu=mu, d=d)
    answer = fb.solve(system, "largest F so that it stays at rest")["q1"]
    expected = min(mu * m * 9.81, m * 9.81 * b / (2 * d))
    assert answer.value == pytest.approx(expected, rel=1e-12), f"seed {seed}"


@pytest.mark.parametrize("name", ["SMOOTH", "ROUGH", "CLIMBED", "BLOCK", "PUSHED", "LIFTED", "BEAM"])
def test_just_inside_the_limit_contact_forces_keep_it_at_rest_and_just_outside_it_accelerates(name: str) -> None:
    """The complementarity problem of the motion, which knows nothing of linear programs, agrees on both sides."""
    model, parameter, sign = {
        "SMOOTH": (SMOOTH, "mu", -1),
        "ROUGH": (ROUGH, "mu", -1),
        "CLIMBED": (CLIMBED, "d", 1),
        "BLOCK": (BLOCK, "F", 1),
        "PUSHED": (PUSHED, "F", 1),
        "LIFTED": (LIFTED, "F", 1),
        "BEAM": (BEAM, "F", 1),
    }[name]
    rest = prepared(fb.System.from_text(model))
    touched, ends = rest.touching, rest.parameter(parameter)
    n_checked = 0
    for draw in ends.draws[:6]:
        edge = ends.edge(draw, sign, None)
        if edge is None or math.isinf(edge.value):
            continue
        for share, is_at_rest in ((1 - 1e-4 * sign, True), (1 + 1e-4 * sign, False)):
            problem = ends.parametric.problem(touched, draw, edge.value * share)
            assert problem is not None
            fastest = float(np.abs(accelerations(problem, draw.reference.masses)).max())
            assert (fastest < 1e-9) == is_at_rest, f"{draw.values}"
            n_checked += 1
    assert n_checked >= 6


def accelerations(problem: RestProblem, masses: np.ndarray) -> np.ndarray:
    """Of all coordinates, by the contact forces that the complementarity problem gives at rest."""
    weights = np.where(masses > 0.0, masses, 1e-2 * masses[masses > 0.0].min())
    signs = np.ones(len(problem.names))
    for row, sign in problem.normals:
        signs[row] = sign
    J = signs[:, None] * problem.J
    dry_friction = tuple(
        contact.FrictionProblemRow(
            c.row, (c.forward, c.backward), (c.forward, c.backward), normals=tuple(j for j, _s in c.load)
        )
        for c in problem.cones
    )
    normals = tuple(row for row, _sign in problem.normals)
    found = contact_forces(contact.ContactProblem(J / weights @ J.T, J / weights @ problem.Q, normals, dry_friction))
    assert found.is_found
    return (problem.Q + J.T @ found.forces) / weights


# -- the report -------------------------------------------------------------------------------
def test_report_of_the_stacked_cylinders_has_the_used_share_of_every_cone() -> None:
    found = fb.System.from_text(CYLINDERS).statics()  # type: ignore[attr-defined]
    share = 2 - math.sqrt(3)
    used = {r.connection: r.used for r in found.reactions if r.reaction == "friction force"}
    assert used == {
        "fa": pytest.approx(share / 3 / 0.2),
        "fb": pytest.approx(share / 3 / 0.2),
        "ca": pytest.approx(share / 0.4),
        "cb": pytest.approx(share / 0.4),
    }
    assert found.reserve == pytest.approx(min(0.4 / share, 0.6 / share))


def test_report_of_the_rough_ladder_shows_intervals() -> None:
    found = fb.statics(fb.System.from_text(ROUGH))
    wall = next(r for r in found.reactions if r.name == "wall.ladder.end on wall")
    assert not wall.is_unique
    low = 10 * 9.81 * 0.5 / (2 * (math.sin(math.pi / 3) + 0.25))
    assert wall.low == pytest.approx(low, rel=1e-9)


def test_report_without_friction_needed() -> None:
    found = fb.statics(fb.System.from_text(RESTING.replace("theta: 20 deg", "theta: {value: 0 deg, sign: any}")))
    assert found.holds
    assert math.isinf(found.reserve)


def test_command_prints_a_table_and_json(tmp_path: Path) -> None:
    file = tmp_path / "block.yaml"
    file.write_text(BLOCK)

    def run(*more: str) -> str:
        done = freebody("statics", str(file), *more)
        assert done.returncode == 0, done.stderr
        return done.stdout

    text = run()
    assert "It holds." in text
    assert "with less block slips to the right on floor" in text
    document = json.loads(run("--json"))
    assert document["holds"] is True
    assert document["friction_reserve"] == pytest.approx(0.4 * 98.1 / 10)
    assert {r["reaction"] for r in document["reactions"]} == {"normal force", "friction force"}


def test_mirrored_block_has_the_mirrored_range() -> None:
    ends = asked(BLOCK.replace("along: right, magnitude", "along: left, magnitude"), "range of F that keeps it at rest")
    low, high = ends["q1"].value  # type: ignore[misc]
    assert low == pytest.approx(-high)


def test_scaling_all_forces_scales_the_limits() -> None:
    problem = rest(ROUGH)
    heavy = replace(problem, Q=7.0 * problem.Q)
    one, seven = (spread(p, problem.place("wall.ladder.end on wall")) for p in (problem, heavy))
    assert one is not None
    assert seven is not None
    assert [e.value for e in seven] == pytest.approx([7.0 * e.value for e in one], rel=1e-12)


# -- nothing gives way: equilibrium alone decides -------------------------------------------------
WINCH = """
parameters: {I: 0.3 kg m^2, R: 0.1 m, m: 20 kg, T: 15 N m, g: 9.81 m/s^2}
bodies: {drum: {body: {inertia: I, radius: R}}, load: {particle: {mass: m}}}
connections:
  axle: {pin: [ground.O, drum]}
  rope: {string: {path: [wound on drum at left, load]}}
loads: {weight: {gravity: g}, motor: {torque: {on: drum, magnitude: T}}}
"""


@pytest.mark.parametrize("question", ["least T so that it stays at rest", "largest T so that it stays at rest"])
def test_a_single_value_that_holds_is_both_ends_without_conditions(question: str, agrees: Agree) -> None:
    # moments about the axle: T = -m g R holds it whichever way it would turn; no case is printed that cannot be
    solution = fb.solve(fb.System.from_text(WINCH), question)
    agrees(solution, "q1", "-m*g*R")
    assert solution["q1"].conditions == ("for all positive parameters",)
    assert not any(" < 0" in note for note in solution["q1"].notes)


def test_a_range_of_one_value_is_that_value(agrees: Agree) -> None:
    solution = fb.solve(fb.System.from_text(WINCH), "range of T that keeps it at rest")
    agrees(solution, "q1", "-m*g*R")
    assert list(solution["q1"].notes) == ["it stays at rest at this value alone"]


def test_a_sector_is_cut_where_its_bound_is_too_large() -> None:
    """e . r / cos d is |r| on the edges of a sector and |r| / cos d in the middle."""
    sector = Sector(0.4, 0.3)
    for angle, excess in ((0.1, 0.0), (0.7, 0.0), (0.4, 1 / math.cos(0.3) - 1)):
        assert sector.excess(5 * math.cos(angle), 5 * math.sin(angle)) == pytest.approx(excess, abs=1e-15)
    assert sector.excess(0.0, 0.0) == 0.0
    for angle in (0.1, 0.12, 0.3, 0.4, 0.55, 0.69, 0.7):
        low, high = sector.cut(math.cos(angle), math.sin(angle))
        assert low.middle - low.half == pytest.approx(0.1)
        assert low.middle + low.half == pytest.approx(high.middle - high.half)
        assert high.middle + high.half == pytest.approx(0.7)
        part = low if angle < low.middle + low.half else high
        d = min(angle - 0.1, 0.7 - angle)
        assert part.excess(math.cos(angle), math.sin(angle)) <= max(d, 2e-7) ** 2


def test_the_margin_of_a_pin_with_friction_takes_few_linear_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Eight sectors, and few cuts of the best one; halving it to its last width would take 50 programs."""
    solved, count = CircularProgram.optimum, itertools.count()

    def counted(program: CircularProgram) -> Any:
        next(count)
        return solved(program)

    monkeypatch.setattr(CircularProgram, "optimum", counted)
    assert margin(rest(PIN, F=1.0, mu=0.26)).value < 0.0  # type: ignore[union-attr]
    assert next(count) <= 24


def test_a_question_about_rest_is_refused_alone_as_it_is_among_others() -> None:
    text = """
parameters: {mu: 0.3}
bodies: {p: {rectangle: {mass: 1 kg, width: 0.2 m, height: 0.2 m}, at: [0, 0.1 m], velocity: [1 m/s, 0]}}
ground: {lines: {floor: {along: right}}}
connections: {c: {contact: {between: [p, ground.floor], friction: mu}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: [{find: does it tip or slide as mu grows, id: rest}%s]
"""
    reasons = {
        next(a.reason for a in fb.System.from_text(text % more).solve().answers if a.id == "rest")
        for more in ("", ", {find: velocity of p, id: v}")
    }
    assert len(reasons) == 1
    assert "p moves at the start" in str(reasons)


def test_a_motion_that_cannot_be_told_is_refused_for_its_own_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where a question about rest stands beside, which has a reason of its own."""
    from freebody.study.phases import tree

    def refused(_system: object) -> None:
        raise fb.CannotAnswer("too long")

    monkeypatch.setattr(tree, "tree_of", refused)
    text = """
ground: {lines: {floor: {along: right}}}
bodies: {p: {disk: {mass: 2 kg, radius: 0.5 m}, at: [0, 0.5 m], angular_velocity: 2 rad/s}}
connections: {c: {contact: {between: [p, floor], friction: 0.3}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: [{find: does it hold}, {find: acceleration of p}]
"""
    with pytest.raises(fb.ModelError, match="too long"):
        fb.System.from_text(text).solve()


def test_words_of_slipping_do_not_mean_rest_where_it_moves_without_slip() -> None:
    """A block on a block that is pulled over a smooth floor: any force moves both, and the upper one slips beyond
    mu (m1 + m2) g."""
    text = """
parameters: {m1: 2 kg, m2: 5 kg, mu: 0.4, F: 20 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {upper: {particle: {mass: m1}}, lower: {particle: {mass: m2}}}
connections:
  rail: {slider: [lower, ground.floor]}
  top: {slider: {body: upper, on: lower, along: right, friction: mu}}
loads: {weight: {gravity: g}, pull: {force: {at: lower, along: right, magnitude: F}}}
measures: {x: x of lower, y: x of upper}
"""
    system = fb.System.from_text(text)
    nothing, top, still = (
        fb.solve(system, f"largest F {so}").answers[0]
        for so in ("for which nothing slips", "for which top does not slip", "so that nothing moves")
    )
    assert nothing.value == pytest.approx(0.4 * 7 * 9.81)
    assert top.value == pytest.approx(0.4 * 7 * 9.81)
    assert still.value == pytest.approx(0.0)


NOTHING_HOLDS = """
parameters: {m: 5 kg, alpha: 30 deg, F: 10 N, g: 9.81 m/s^2}
ground: {lines: {slope: {along: alpha}}}
bodies: {block: {particle: {mass: m}}}
connections: {slope: {contact: {between: [block, ground.slope]}}}
loads:
  weight: {gravity: g}
  push: {force: {at: block, along: alpha - 90 deg, magnitude: F}}
"""
BRACKET = """
parameters: {W: 300 N, h: 0.12 m, d: 0.04 m, x: 0.25 m, mu: 0.3}
ground:
  lines:
    right_face: {along: up, through: [d/2, 0]}
    left_face: {along: down, through: [-d/2, 0]}
bodies:
  bracket: {body: {mass: 1 kg, inertia: 1 kg m^2}, at: [0, 0], angle: 0, points: {low: [d/2, -h/2],
    high: [-d/2, h/2], load: [x, 0]}}
connections:
  low: {contact: {between: [bracket.low, ground.right_face], friction: mu}}
  high: {contact: {between: [bracket.high, ground.left_face], friction: mu}}
loads: {load: {force: {at: bracket.load, along: down, magnitude: W}}}
"""


@pytest.mark.parametrize(
    ("model", "name"),
    [(NOTHING_HOLDS, "m"), (BRACKET, "x")],  # m g sin(alpha) = 0 needs m = 0; W x <= -(W h/(2 mu) - ..) needs x < 0
)
def test_values_that_mean_nothing_hold_nothing(model: str, name: str) -> None:
    system = fb.System.from_text(model)
    for question in (f"least {name} so that", f"largest {name} so that"):
        reason = system.solve(f"{question} it stays at rest").answers[0].reason
        assert reason.startswith(f"no value of {name} keeps the system at rest"), question
    reason = system.solve(f"range of {name} that keeps it at rest").answers[0].reason
    assert reason.startswith(f"no value of {name} keeps the system at rest")


def test_a_lower_limit_that_need_not_be_there_has_that_as_a_condition() -> None:
    # N = m g - mu P on the floor; moments about the foot: P L sin(alpha) + mu P L cos(alpha) = m g L/2 cos(alpha)
    system = fb.System.from_text("""
parameters: {m: 12 kg, L: 4 m, alpha: 65 deg, mu: 0.4, P: 30 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up, through: [0, 0]}}}
bodies: {ladder: {rod: {mass: m, length: L}, angle: alpha}}
connections:
  floor: {contact: {between: [ladder, ground.floor]}}
  wall: {contact: {between: [ladder, ground.wall], friction: mu}}
loads: {weight: {gravity: g}, push: {force: {at: ladder.start, along: right, magnitude: P}}}
""")
    answer = system.solve("least alpha so that it stays at rest").answers[0]
    assert answer.value == pytest.approx(math.atan((12 * 9.81 - 2 * 0.4 * 30) / 60))
    assert any("m·g ≥ 2·μ·P" in c for c in answer.conditions)


def test_a_wedge_holds_itself_up_to_twice_the_angle_of_friction(agrees: Agree) -> None:
    """Both faces at the angle of friction phi: the wedge is a body with two forces, so alpha = 2 phi whatever the load.
    Source: Meriam & Kraige, Statics, sec. 6/4."""
    solution = fb.System.from_text("""
parameters: {W: 800 N, L: 0.4 m, alpha: 12 deg, mu: 0.2, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up, through: [L/2, 0]}}}
bodies:
  wedge: {polygon: {corners: [[0, 0], [L, 0], [0, L*tan(alpha)]]}, at: [0, 0], angle: 0}
  load: {particle: {mass: W/g}, at: [L/2, L*tan(alpha)/2]}
connections:
  floor: {contact: {between: [wedge, ground.floor], friction: mu, touching: true}}
  face: {contact: {between: [load, wedge], friction: mu, touching: true}}
  wall: {contact: {between: [load, ground.wall], touching: true}}
loads: {weight: {gravity: g}}
questions: {friction: least mu so that it stays at rest, angle: largest alpha so that it stays at rest}
""").solve()
    agrees(solution, "friction", "tan(alpha/2)")
    agrees(solution, "angle", "2*atan(mu)")


@pytest.mark.parametrize("side", ["up", "down"])
def test_a_force_of_one_direction_touches_the_friction_circle_of_a_journal(side: str, agrees: Agree) -> None:
    """R |F - W| = mu r (F + W), whichever way both pull. Source: Meriam & Kraige, Statics, sec. 6/6."""
    solution = fb.System.from_text(f"""
parameters: {{W: 500 N, F: 500 N, R: 0.1 m, r: 10 mm, mu: 0.2}}
bodies: {{lever: {{rod: {{length: 2*R}}, angle: 0}}}}
connections: {{axle: {{pin: {{first: ground.axle, second: lever, friction: mu, radius: r}}}}}}
loads:
  one: {{force: {{at: lever.start, along: {side}, magnitude: W}}}}
  two: {{force: {{at: lever.end, along: {side}, magnitude: F}}}}
questions: {{range: range of F that keeps it at rest}}
""").explain()
    assert not solution.derivations[0].reason
    agrees(solution.solution, "range", ["W*(R - mu*r)/(R + mu*r)", "W*(R + mu*r)/(R - mu*r)"])


@pytest.mark.parametrize(
    ("rear", "front", "greatest"),
    [("mu", "0", "mu*g*a/(a + b - mu*h)"), ("0", "mu", "mu*g*b/(a + b + mu*h)"), ("mu", "mu", "mu*g")],
)
def test_the_greatest_acceleration_of_a_car_depends_on_which_wheels_drive(
    rear: str, front: str, greatest: str, agrees: Agree
) -> None:
    """m A = mu N of what drives, with N_r (a + b) = m (g a + A h). Source: Meriam & Kraige, Dynamics, sec. 6/2."""
    solution = fb.System.from_text(f"""
parameters: {{m: 1200 kg, a: 1.2 m, b: 1.4 m, h: 0.5 m, mu: 0.8, A: 1 m/s^2, g: 9.81 m/s^2}}
ground: {{lines: {{road: {{along: right}}}}}}
bodies:
  car: {{rectangle: {{mass: m, width: 3 m, height: 2*h}}, points: {{r: [-b, -h], f: [a, -h]}}, at: [0, h], angle: 0}}
connections:
  rear: {{contact: {{between: [car.r, ground.road], friction: {rear}, touching: true}}}}
  front: {{contact: {{between: [car.f, ground.road], friction: {front}, touching: true}}}}
loads: {{weight: {{gravity: g}}, inertia: {{force: {{at: car, along: left, magnitude: m*A}}}}}}
questions: {{it: which wheel slips or lifts first as A grows}}
""").solve()
    agrees(solution, "it", greatest)


def test_a_particle_that_leaves_a_wall_does_not_tip() -> None:
    found = asked(WEDGE, "least P so that it stays at rest")["q1"]
    told = " ".join(found.notes)
    assert "block leaves wall" in told
    assert "tips" not in told


# -- beside a drive that accelerates -----------------------------------------------------------
TRUCK = """
parameters: {m: 50 kg, M: 1000 kg, b: 0.6 m, h: 1 m, mu: 0.4, a0: 2 m/s^2, g: 9.81 m/s^2}
bodies:
  truck: {rectangle: {mass: M, width: 5 m, height: 0.5 m}, lines: {bed: {through: [0, 0.25], along: right}}}
  crate: {rectangle: {mass: m, width: b, height: h}, near: {at: [0, 0.75]}}
connections:
  track: {slider: {body: truck, along: right}}
  motor: {driver: {measure: x of truck, follows: a0*t^2/2}}
  bed: {contact: {between: [crate, truck.bed], friction: mu}}
loads: {weight: {gravity: g}}
"""
DRIVEN_WEDGE = """
parameters: {m: 2 kg, al: 30 deg, mu: 0.2, a0: 4 m/s^2, g: 9.81 m/s^2}
bodies: {wedge: {body: {mass: 10 kg}, lines: {slope: {angle: al}}}, block: {particle: {mass: m}, near: {at: [1, 1]}}}
connections:
  track: {slider: {body: wedge, along: right}}
  motor: {driver: {measure: x of wedge, follows: -a0*t^2/2}}
  face: {contact: {between: [block, wedge.slope], friction: mu}}
loads: {weight: {gravity: g}}
"""
# Meriam & Kraige, Dynamics, ch. 3 and 6; Beer & Johnston, Dynamics, ch. 12 and 16: crates on trucks, blocks on wedges
ALONG = {
    "slips": (TRUCK, "largest a0 so that it does not slip", "mu*g"),
    "tips": (TRUCK.replace("mu: 0.4", "mu: 0.9"), "does it tip or slide as a0 grows", "b*g/h"),
    "rough enough": (TRUCK, "least mu so that it does not slip", "a0/g"),
    "wedge": (
        DRIVEN_WEDGE,
        "range of a0 that keeps it at rest",
        [
            "g*(sin(al) - mu*cos(al))/(cos(al) + mu*sin(al))",
            "g*(sin(al) + mu*cos(al))/(cos(al) - mu*sin(al))",
        ],
    ),
    "wedge, rough enough": (
        DRIVEN_WEDGE,
        "least mu so that it does not slip",
        "(g*sin(al) - a0*cos(al))/(g*cos(al) + a0*sin(al))",
    ),
}


@pytest.mark.parametrize("name", ALONG)
def test_rest_beside_a_drive_that_accelerates(name: str, agrees: Agree) -> None:
    model, question, formula = ALONG[name]
    system = fb.System.from_text(model + f"questions: [{question}]\n")
    agrees(fb.solve(system), "q1", formula)
    (derivation,) = fb.explain(system).derivations
    assert not derivation.reason


def test_what_hangs_freely_beside_a_drive_that_accelerates_is_not_at_rest() -> None:
    hung = TRUCK.replace("bodies:", "bodies:\n  bob: {particle: {mass: 1 kg}}").replace(
        "connections:", "connections:\n  rope: {link: [truck, bob, 0.2 m]}"
    )
    found = fb.solve(fb.System.from_text(hung + "questions: [largest a0 so that it stays at rest]\n")).answers[0]
    assert found.expression is None
    assert "free to move" in found.reason


def test_block_on_a_belt_stays_on_it_only_with_a_spring_that_goes_along() -> None:
    """A spring to the ground is stretched by v t and pulls it off at k v t = mu m g; one to the belt is as it is."""
    model = """
bodies: {belt: {body: {mass: 1 kg}, lines: {top: {along: right}}}, block: {particle: {mass: 1 kg}}}
connections:
  guide: {slider: {body: belt, along: right}}
  motor: {driver: {measure: x of belt, follows: 0.2 m/s * t}}
  contact: {contact: {between: [block, belt.top], friction: 0.5}}
loads: {weight: {gravity: 9.81 m/s^2}, spring: {law: {measure: s, force: -40 N/m * s}}}
measures: {s: x of block}
start: {s: 0}
"""
    with pytest.raises(fb.CannotAnswer, match="matter of an instant"):
        fb.statics(fb.System.from_text(model))
    beside = model.replace("s: x of block", "s: x of block from belt")
    assert fb.statics(fb.System.from_text(beside)).holds


def test_a_drum_against_a_chock_may_spin_and_goes_along() -> None:
    """About the chock: m a0 (R - h) = m g sqrt(R^2 - (R - h)^2)."""
    drum = """
parameters: {m: 80 kg, R: 0.3 m, h: 0.05 m, a0: 1 m/s^2, g: 9.81 m/s^2}
bodies:
  truck:
    rectangle: {mass: 1000 kg, width: 4 m, height: 0.4 m}
    at: [0, 0]
    lines: {bed: {through: [0, 0.2], along: right}}
    points: {chock: [-sqrt(R^2 - (R - h)^2), 0.2 m + h]}
  drum: {disk: {mass: m, radius: R}, near: {at: [0, 0.5]}}
connections:
  track: {slider: {body: truck, along: right}}
  motor: {driver: {measure: x of truck, follows: a0*t^2/2}}
  bed: {contact: {between: [drum, truck.bed], touching: true}}
  chock: {contact: {between: [drum, truck.chock], touching: true}}
loads: {weight: {gravity: g}}
questions: [largest a0 so that it stays at rest]
"""
    (answer,) = fb.solve(fb.System.from_text(drum)).answers
    assert answer.value == pytest.approx(9.81 * math.sqrt(0.3**2 - 0.25**2) / 0.25, rel=1e-9)


def test_what_rolls_from_the_start_rolls() -> None:
    """m a = F, m R^2 al/2 = F R, a + R al = a0: F = m a0/3 <= mu m g."""
    drum = """
parameters: {m: 5 kg, R: 0.3 m, a0: 2 m/s^2, g: 9.81 m/s^2, mu: 0.3}
bodies:
  truck: {rectangle: {mass: 1 t, width: 5 m, height: 0.5 m}, lines: {top: {through: [0, 0.25], along: right}}}
  drum: {disk: {mass: m, radius: R}, near: {at: [0, 0.55]}}
connections:
  track: {slider: {body: truck, along: right}}
  motor: {driver: {measure: x of truck, follows: a0*t^2/2}}
  roll: {contact: {between: [drum, truck.top], friction: mu, touching: true}}
loads: {weight: {gravity: g}}
questions: [least mu so that drum rolls, largest a0 so that drum rolls]
"""
    least, largest = fb.solve(fb.System.from_text(drum)).answers
    assert least.value == pytest.approx(2 / (3 * 9.81), rel=1e-9)
    assert largest.value == pytest.approx(3 * 0.3 * 9.81, rel=1e-9)


def test_what_equilibrium_alone_decides_is_one_value_and_no_bound() -> None:
    """F b = m g a about the axle: with more force the barrow is lifted, with less it falls."""
    system = fb.System.from_text("""
parameters: {m: 60 kg, a: 0.5 m, b: 1.4 m, F: N, g: 9.81 m/s^2}
bodies: {barrow: {body: {mass: m, center_of_mass: [a, 0]}, angle: 0, points: {grip: [b, 0]}}}
connections: {axle: {pin: [ground.O, barrow.origin]}}
loads: {weight: {gravity: g}, hands: {force: {at: barrow.grip, along: up, magnitude: F}}}
questions: [least F so that nothing moves]
""")
    (answer,) = system.solve().answers
    assert "it stays at rest at this value alone" in answer.notes
    told = system.explain().to_text()
    assert "Equilibrium alone determines F." in told
    assert "F ≥" not in told


HALF_DISK = """
parameters: {m: 2 kg, R: 0.3 m, mu: 0.4, phi_0: 20 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: down}}}
bodies: {half: {half_disk: {mass: m, radius: R}, at: [R, R]}}
connections: {below: {contact: {between: [half, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of half from down}
start: {phi: phi_0, rate(phi): 0}
"""


def test_a_half_disk_rocks_without_slip_where_friction_is_enough() -> None:
    # I_P a = -m g e sin(phi), I_P = m (3 R^2/2 - 2 R e cos(phi)); F = m a (R - e cos(phi)), N = m (g - e sin(phi) a)
    R, g, phi, e = 0.3, 9.81, math.radians(20.0), 0.4 / math.pi
    a = g * e * math.sin(phi) / (1.5 * R * R - 2 * R * e * math.cos(phi))
    asked = ["acceleration of phi at start", "least mu so that it does not slip at start"]
    answers = fb.System.from_text(HALF_DISK).solve(asked).answers
    least = a * (R - e * math.cos(phi)) / (g - e * math.sin(phi) * a)
    assert [answer.value for answer in answers] == pytest.approx([-a, least])
    assert all(answer.expression is not None for answer in answers)


def test_a_half_disk_that_faces_a_wall_with_its_flat_side_does_not_touch_it() -> None:
    beside = HALF_DISK.replace(
        "connections: {", "connections: {beside: {contact: {between: [half, wall], friction: mu}}, "
    )
    (answer,) = fb.System.from_text(beside).solve("least mu so that it stays at rest").answers
    assert "half touches with its round side" in str(answer.reason)
    (answer,) = (
        fb.System.from_text(beside.replace("phi: phi_0", "phi: -phi_0"))
        .solve("least mu so that it stays at rest")
        .answers
    )
    # mu (1 + mu)/(1 + mu^2) = 4 sin(phi_0)/(3 pi)
    mu = answer.value
    assert mu * (1 + mu) / (1 + mu * mu) == pytest.approx(4 * math.sin(math.radians(20.0)) / (3 * math.pi))


def test_a_motion_says_where_the_round_side_ends() -> None:
    fast = HALF_DISK.replace("rate(phi): 0", "rate(phi): 14 rad/s").replace("mu: 0.4", "mu: 2")
    assert "limit of validity: half touches with its round side" in str(fb.System.from_text(fast).simulate(0.4))


def test_an_arc_touches_lines_only() -> None:
    model = HALF_DISK.replace("bodies: {", "bodies: {ball: {disk: {mass: m, radius: R}}, ").replace(
        "[half, floor]", "[half, ball]"
    )
    with pytest.raises(fb.ModelError, match="a contact of it is one with lines"):
        fb.System.from_text(model)


STEPLADDER = """
parameters: {L: 2 m, alpha: 20 deg, m: 6 kg, W: 700 N, a: 1.4 m, k: 400 N/m, l0: 0.5 m, b: 0.5 m, mu: 0.5, g: 10 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  left:
    rod: {mass: m, length: L}
    at: {start: [-L*sin(alpha), 0], end: [0, L*cos(alpha)]}
    points: {T: b from start, P: a from start}
  right: {rod: {mass: m, length: L}, at: {start: [L*sin(alpha), 0], end: [0, L*cos(alpha)]}, points: {T: b from start}}
connections:
  top: {pin: [left.end, right.end]}
  A: {contact: {between: [left.start, ground.floor], friction: mu}}
  B: {contact: {between: [right.start, ground.floor], friction: mu}}
loads:
  weight: {gravity: g}
  person: {force: {at: left.P, along: down, magnitude: W}}
  tie: {spring: {from: left.T, to: right.T, stiffness: k, free_length: l0}}
"""


def test_a_stepladder_tied_by_a_spring_is_answered_on_the_side_on_which_the_spring_leads(agrees: Agree) -> None:
    """Moments of the right leg about the top: N L sin(a) - m g L sin(a)/2 = F L cos(a) + T (L - b) cos(a) with
    N = m g + W a/(2 L) from both legs about the left foot and T = k (2 (L - b) sin(a) - l0). Beyond the top, b > L,
    the spring would be 2 (b - L) sin(a) long: other numbers, which were taken for a defect."""
    solution = asked(STEPLADDER, "least mu so that it stays at rest")
    N, T = "(m*g + W*a/(2*L))", "k*(2*(L - b)*sin(alpha) - l0)"
    agrees(solution, "q1", f"({T}*(L - b)/L - ({N} - m*g/2)*sin(alpha)/cos(alpha))/{N}")
    assert "L > b (as at the start)" in solution["q1"].conditions
