"""The greatest and the least value of a force, a torque or a speed: over a turn that is driven, and over a motion.

A rotor with its mass centre at the distance e from its axle, turned evenly: R = m (e w^2 radial, g up), so its size is
between |m e w^2 - m g| and m e w^2 + m g, and the torque is m g e cos psi. A pendulum let go at a: v^2 = 2 g L (cos
theta - cos a), S = m g (3 cos theta - 2 cos a). Turned over with the rate w below: S = m (L w^2 - 2 g + 3 g cos theta).
Problem families: Meriam & Kraige, Dynamics, 6/4 and 3/6; Hibbeler, Dynamics, 13.5, 14.5 and 17.4; Beer & Johnston,
Dynamics, 13.6 and 16.2; Goldstein, Classical Mechanics, ch. 3; Norton, Design of Machinery, 11.2 (shaking force).
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.api import System
from posed import is_derived, is_formula, posed

ROTOR = """
parameters: {m: 4 kg, e: 0.05 m, I: 0.2 kg m^2, w: 20 rad/s, g: 9.81 m/s^2}
bodies: {rotor: {body: {mass: m, inertia: I}, points: {O: [-e, 0]}}}
connections: {axle: {pin: [ground.O, rotor.O]}, motor: {driver: {measure: psi, follows: w*t}}}
loads: {weight: {gravity: g}}
measures: {psi: angle of rotor}
"""
ARM = """
parameters: {m: 3 kg, M: 2 kg, L: 0.8 m, w: 5 rad/s, g: 9.81 m/s^2, p: 30 deg}
bodies: {arm: {rod: {mass: M, length: L}}, tip: {particle: {mass: m}}}
connections:
  O: {pin: [ground.O, arm.start]}
  weld: {pin: [arm.end, tip]}
  motor: {driver: {measure: psi, follows: p + w*t}}
loads: {weight: {gravity: g}}
measures: {psi: {angle of arm from down}}
"""
YOKE = """
parameters: {r: 0.06 m, w: 25 rad/s, m: 2.5 kg}
bodies: {crank: {rod: {length: r}}, yoke: {body: {mass: m}}}
connections:
  O: {pin: [ground.O, crank.start]}
  guide: {slider: {body: yoke, along: right}}
  slot: {slot: {pin: crank.end, along: yoke.y, on: yoke}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: {angle of crank}, x: x of yoke}
"""
PENDULUM = """
parameters: {m: 1.5 kg, L: 0.9 m, a: 60 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rope: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: a}
"""
STRING = PENDULUM.replace("rope: {link: [ground.O, bob, L]}", "rope: {string: {from: ground.O, to: bob, swings: true}}")
STRING = STRING.replace("measures: {", "measures: {r: distance from ground.O to bob, ").replace(
    "start: {", "start: {r: L, "
)
OVER = PENDULUM.replace("a: 60 deg", "w: 9 rad/s").replace("start: {theta: a}", "start: {theta: 0, rate(theta): w}")
SPRING = """
parameters: {m: 2 kg, k: 200 N/m, L: 0.5 m, g: 9.81 m/s^2}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: down}}}
loads: {weight: {gravity: g}, spring: {spring: {first: ground.O, second: block, stiffness: k, length: L}}}
measures: {y: {drop of block below ground.O}}
start: {y: L, rate(y): 0}
"""
ORBIT = """
parameters: {m: 1 kg, K: 3 m^3/s^2, r0: 1 m, v0: 2 m/s}
bodies: {sat: {particle: {mass: m}}}
loads: {pull: {law: {measure: r, force: -m*K/r^2}}}
measures: {r: distance from ground.O to sat, phi: {angle of line from ground.O to sat}}
start: {r: r0, rate(r): 0, phi: 0, rate(phi): v0/r0}
"""
ROD = """
parameters: {m: 3 kg, L: 1.6 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, points: {O: [-L/4, 0]}}}
connections: {hinge: {pin: [ground.O, rod.O]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod from right clockwise}}
start: {theta: 0}
"""

CASES = {
    "torque of an unbalanced rotor": (ROTOR, "greatest driving torque of motor over a turn", "m*g*e"),
    "the other way": (ROTOR, "least driving torque of motor over a turn of psi", "-m*g*e"),
    "both ways": (ROTOR, "stroke of driving torque of motor over a turn of rotor", "2*m*g*e"),
    "reaction of its axle": (ROTOR, "greatest reaction of axle over a turn", "m*e*w^2 + m*g"),
    "least reaction": (ROTOR, "least reaction of axle over a turn", "abs(m*e*w^2 - m*g)"),
    "upward": (ROTOR, "greatest vertical reaction of axle over a turn of rotor", "m*g + m*e*w^2"),
    "over the motion it is the same": (ROTOR, "greatest reaction of axle over the motion", "m*e*w^2 + m*g"),
    "an arm with a load at its tip": (ARM, "greatest driving torque of motor over a turn", "(m + M/2)*g*L"),
    "the pin of its load": (ARM, "greatest reaction of weld on tip over a turn", "m*L*w^2 + m*g"),
    "speed of a Scotch yoke": (YOKE, "greatest velocity of yoke over a turn", "r*w"),
    "its torque": (YOKE, "greatest driving torque of motor over a turn", "m*r^2*w^2/2"),
    "a speed that does not change": (ARM, "greatest velocity of tip over a turn of psi", "w*L"),
    "tension of a pendulum": (PENDULUM, "greatest tension of rope", "m*g*(3 - 2*cos(a))"),
    "least tension": (PENDULUM, "least tension of rope over the motion", "m*g*cos(a)"),
    "speed of its bob": (PENDULUM, "greatest speed of bob", "sqrt(2*g*L*(1 - cos(a)))"),
    "rate, to either side": (PENDULUM, "least velocity of theta", "-sqrt(2*g/L*(1 - cos(a)))"),
    "angular acceleration": (PENDULUM, "greatest acceleration of theta", "g*sin(a)/L"),
    "a string that stays taut": (STRING, "greatest tension of rope", "m*g*(3 - 2*cos(a))"),
    "over the top": (OVER, "least tension of rope over a turn", "m*(L*w^2 - 5*g)"),
    "slowest at the top": (OVER, "least velocity of theta over the motion", "sqrt(w^2 - 4*g/L)"),
    "power of its weight": (SPRING, "greatest power of weight", "m*g^2*sqrt(m/k)"),
    "mass let go on a spring": (SPRING, "greatest velocity of y", "g*sqrt(m/k)"),
    "force in the spring": (SPRING, "greatest force in spring", "2*m*g"),
    "its energy": (SPRING, "greatest kinetic energy", "m^2*g^2/(2*k)"),
    # H = r0 v0 and energy: r_a = r0^2 v0^2/(2 K - r0 v0^2), v_a = r0 v0/r_a
    "apoapsis": (ORBIT, "greatest r", "r0^2*v0^2/(2*K - r0*v0^2)"),
    "speed there": (ORBIT, "least speed of sat", "(2*K - r0*v0^2)/(r0*v0)"),
    "rate there": (ORBIT, "least velocity of phi", "(v0/r0)*((2*K - r0*v0^2)/(r0*v0^2))^2"),
    # I_O = 7 m L^2/48, w^2 = 24 g/(7 L) below: m g + m w^2 L/4
    "rod let go level": (ROD, "greatest reaction of hinge over the motion", "13*m*g/7"),
    "its rate below": (ROD, "greatest angular velocity of rod", "sqrt(24*g/(7*L))"),
}


@pytest.mark.parametrize("name", CASES)
def test_the_extreme_is_that_of_a_textbook(name: str) -> None:
    model, question, formula = CASES[name]
    found = is_formula(model, question, formula, factors=(1.0, 1.02, 0.98))
    assert found.value is not None


def test_torque_of_a_slider_crank_has_a_number() -> None:
    # T = (F + m x'') x_psi by virtual power, x = r cos psi + sqrt(b^2 - r^2 sin^2 psi)
    r, b, m, F, w = 0.05, 0.2, 0.8, 200.0, 30.0
    text = """
parameters: {r: 0.05 m, l: 0.2 m, m: 0.8 kg, F: 200 N, w: 30 1/s}
ground: {lines: {rail: {along: right}}}
bodies: {crank: {rod: {mass: 0, length: r}}, rod: {rod: {mass: 0, length: l}}, piston: {particle: {mass: m}}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  guide: {slider: [piston, ground.rail]}
  motor: {driver: {measure: psi, follows: w*t}}
loads: {gas: {force: {at: piston, along: left, magnitude: F}}}
measures: {psi: angle of crank, x: x of piston}
"""

    def torque(psi: float) -> float:
        s, c = math.sin(psi), math.cos(psi)
        root = math.sqrt(b * b - r * r * s * s)
        slope = -r * s - r * r * s * c / root
        bend = -r * c - r * r * (c * c - s * s) / root - r**4 * s * s * c * c / root**3
        return (F + m * bend * w * w) * slope

    found = posed(text, "greatest driving torque of motor over a turn")
    assert found.value == pytest.approx(max(torque(k * math.tau / 20_000) for k in range(20_000)), rel=1e-6)


@pytest.mark.slow
def test_forces_of_a_four_bar_have_numbers() -> None:
    text = """
parameters: {a: 0.1 m, b: 0.3 m, c: 0.25 m, d: 0.3 m, w: 20 rad/s}
ground: {points: {O: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: a}}
  coupler: {rod: {mass: 1 kg, length: b}}
  rocker: {rod: {mass: 1 kg, length: c}, near: {angle: 100 deg}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, coupler.start]}
  B: {pin: [coupler.end, rocker.end]}
  C: {pin: [ground.D, rocker.start]}
  motor: {driver: {measure: psi, follows: w*t}}
measures: {psi: angle of crank}
"""
    turn = fb.over_a_turn(System.from_text(text), n=720)
    found = posed(text, "greatest driving torque of motor over a turn")
    assert found.value == pytest.approx(float(turn.torque.max()), rel=1e-4)
    pin = max(math.hypot(x, y) for x, y in zip(*(turn.columns[f"O.{axis}"][1] for axis in "xy"), strict=True))
    assert posed(text, "greatest reaction of O over a turn").value == pytest.approx(pin, rel=1e-4)


def test_without_a_drive_there_is_no_number_of_a_rate_that_nobody_gave() -> None:
    text = """
parameters: {a: 0.1 m, b: 0.3 m, c: 0.25 m, d: 0.3 m}
ground: {points: {O: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: a}}
  coupler: {rod: {mass: 1 kg, length: b}}
  rocker: {rod: {mass: 1 kg, length: c}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, coupler.start]}
  B: {pin: [coupler.end, rocker.end]}
  C: {pin: [ground.D, rocker.start]}
measures: {psi: angle of crank, phi: angle of rocker}
start: {psi: 60 deg}
"""
    for question in ("greatest velocity of phi over a turn of psi", "extremes of acceleration of phi over a turn"):
        assert posed(text, question).value is None


def test_what_else_is_free_has_a_motion_of_its_own() -> None:
    text = ROTOR.replace("bodies: {", "bodies: {bob: {particle: {mass: m}}, ")
    text = text.replace("connections: {", "connections: {rope: {link: [rotor.O, bob, e]}, ")
    assert "free to move" in posed(text, "greatest driving torque of motor over a turn").reason


def test_a_load_in_the_time_makes_no_turn_as_the_one_before() -> None:
    text = ROTOR.replace("loads: {", "loads: {push: {torque: {on: rotor, magnitude: m*g*e*cos(w*t)}}, ")
    assert "depends on the time" in posed(text, "greatest driving torque of motor over a turn").reason


def test_a_pendulum_that_swings_makes_no_turn() -> None:
    text = PENDULUM.replace("start: {theta: a}", "start: {theta: a, rate(theta): 0}")
    assert "turns back" in posed(text, "greatest tension of rope over a turn").reason


def test_a_fall_has_no_extremes() -> None:
    text = (
        "bodies: {ball: {particle: {mass: 1 kg}}}\nloads: {weight: {gravity: 9.81 m/s^2}}\nmeasures: {y: y of ball}\n"
    )
    found = posed(text + "start: {y: 0, rate(y): 3 m/s}\n", "greatest speed of ball")
    assert found.expression is None
    assert found.value is None


@pytest.mark.parametrize(
    ("text", "question"),
    [
        (PENDULUM, "greatest tension of rope"),
        (PENDULUM, "greatest speed of bob"),
        (SPRING, "least velocity of y"),
        (ROTOR, "greatest vertical reaction of axle over a turn"),
        (ROTOR, "least driving torque of motor over a turn"),
        (ROTOR, "greatest driving torque of motor over the motion"),
    ],
)
def test_it_is_derived(text: str, question: str) -> None:
    is_derived(text, question)


# the crank of a quick return is a tangent of the lever where sin(psi) = -r/d; for d = r both such poses are one, in
# which the block is at the pivot of the lever, which turns right round for d < r
SHAPER = """
parameters: {r: 0.1 m, d: 0.25 m}
ground: {points: {O: [0, 0], A: [0, -d]}}
bodies: {crank: {rod: {mass: 1 kg, length: r}}, lever: {rod: {mass: 1 kg, length: 0.5 m}, near: {angle: 70 deg}}}
connections:
  main: {pin: [ground.O, crank.start]}
  pivot: {pin: [ground.A, lever.start]}
  block: {slot: {pin: crank.end, along: right, on: lever}}
measures: {psi: angle of crank, phi: angle of lever}
start: {psi: 30 deg}
"""
# x = a cos(psi) + b cos(2 psi): for a = 4 b the two poses in which cos(psi) = -a/(4 b) meet the one at 180 deg
TWICE = """
parameters: {a: 0.1 m, b: 0.2 m}
bodies: {first: {rod: {mass: 1 kg, length: a}}, second: {rod: {mass: 1 kg, length: b}}}
connections:
  O: {pin: [ground.O, first.start]}
  A: {pin: [first.end, second.start]}
  twice: {constraint: beta - 2*psi}
measures: {psi: angle of first, beta: angle of second, x: x of second.end}
start: {psi: 30 deg}
"""


@pytest.mark.parametrize(
    ("text", "question", "needed"),
    [
        (SHAPER, "time ratio of phi over a turn of psi", "d > r"),
        (SHAPER, "stroke of phi over a turn of psi", "d > r"),
        (SHAPER, "dead points of phi", "d > r"),
        (TWICE, "least x over a turn of psi", "4·b ≥ a"),
    ],
)
def test_the_border_belongs_to_the_range_where_an_extreme_is_left_there(text: str, question: str, needed: str) -> None:
    answer = System.from_text(text).solve(question).answers[0]
    assert answer.expression is not None, answer.reason
    assert [c.partition(" (")[0] for c in answer.conditions] == [needed]


PAIR = """
parameters: {m: 2 kg, M: 3 kg, k: 300 N/m, l: 1 m, d: 0.2 m}
ground: {lines: {rail: {along: right}}}
bodies: {a: {particle: {mass: m}}, b: {particle: {mass: M}}}
connections: {r: {slider: {body: a, along: rail}}, s: {slider: {body: b, along: rail}}}
loads: {spring: {law: {measure: stretch, force: -k*stretch}}}
measures: {x1: x of a, x2: x of b, stretch: {expression: x2 - x1 - l}}
start: {x1: 0, x2: l + d, rate(x1): 0, rate(x2): 0}
"""


def test_two_bodies_on_a_spring_come_as_near_as_the_stretch_at_the_start_leaves() -> None:
    """u = x2 - x1 - l swings between d and -d."""
    assert posed(PAIR, "least (x2 - x1)").value == pytest.approx(0.8)
    assert posed(PAIR, "greatest (x2 - x1)").value == pytest.approx(1.2)


def test_whether_the_least_is_of_the_first_or_of_the_difference_has_to_be_said() -> None:
    with pytest.raises(fb.errors.ModelError, match="what does '-' belong to"):
        System.from_text(PAIR).question("least x2 - x1")


def test_what_follows_from_the_parameters_has_no_extreme_in_a_motion() -> None:
    with pytest.raises(fb.ModelError, match="follows from the parameters alone and is the same throughout the motion"):
        System.from_text(ROTOR).solve("greatest mass of rotor")


PUSHED = """
parameters: {m: 2 kg, v0: 1 m/s, F0: 20 N, k: 10 N/m, b: 3 m, c: 1 m}
bodies: {ball: {particle: {mass: m}, at: [0, 0], velocity: [v0, 0]}}
connections: {rail: {guide: {body: ball, along: right}}}
loads: {f: {force: {on: ball, along: right, value: F0 - k*x}}}
measures: {x: x of ball}
"""
SPEED_AT_C = "sqrt(v0^2 + (2*F0*c - k*c^2)/m)"


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # v^2 = v0^2 + (2 F0 x - k x^2)/m, which grows up to x = F0/k
        (PUSHED, "greatest speed of ball until x = b", "sqrt(v0^2 + F0^2/(m*k))"),
        (PUSHED, "greatest speed of ball until x = c", SPEED_AT_C),
        (PUSHED, "greatest acceleration of ball until x = b", "F0/m"),
        (PUSHED, "greatest change of x until x = b", "b"),
        (
            PUSHED,
            "(greatest speed of ball until x = c) - (speed of ball at start)",
            "sqrt(v0^2 + (2*F0*c - k*c^2)/m) - v0",
        ),
        # S = m g (3 cos theta - 2 cos a)
        (PENDULUM, "greatest tension of rope until theta = a/2", "m*g*(3*cos(a/2) - 2*cos(a))"),
        (PENDULUM, "greatest change of theta until theta = 0", "a"),
        (PENDULUM, "greatest speed of bob until theta = a/2", "sqrt(2*g*L*(cos(a/2) - cos(a)))"),
    ],
)
def test_an_extreme_up_to_an_event_is_at_an_end_or_where_the_slope_vanishes(
    model: str, question: str, formula: str
) -> None:
    is_formula(model, question, formula)


def test_an_extreme_up_to_an_event_is_derived_and_has_a_number_where_nothing_repeats_itself() -> None:
    told = is_derived(PENDULUM, "greatest tension of rope until theta = 0")
    assert "3⋅m⋅g" in told["en"] or "3·m·g" in told["en"]
    found = posed(PENDULUM, "greatest tension of rope until t = 0.1 s")
    assert found.expression is None
    assert isinstance(found.value, float)
    assert found.value < 1.5 * 9.81 * (3 - 2 * math.cos(math.pi / 3))


FALLING_ROD = """
parameters: {m: 2 kg, L: 1 m, a: 1 deg, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {th: {angle of rod from up clockwise}}
start: {th: a}
"""


def test_what_nearly_vanishes_at_its_least_is_compared_by_the_size_that_it_has_beside() -> None:
    """V = m g ((1 - 3 cos th)^2 + 6 cos th (1 - cos a))/4, which is least at cos th = cos(a)/3."""
    is_formula(FALLING_ROD, "least vertical reaction of hinge until th = 90 deg", "m*g*sin(a)^2/4", (1.0,))


ONTO_A_SPRING = """
parameters: {m: 5 kg, b: 30 deg, mu: 0.2, d: 4 m, l: 0.5 m, k: 800 N/m, g: 9.81 m/s^2}
ground: {points: {end: [(d + l)*cos(b), -(d + l)*sin(b)]}, lines: {slope: {along: -b}}}
bodies: {block: {particle: {mass: m}, at: [0, 0]}}
connections: {plane: {contact: {body: block, on: slope, friction: mu}}}
loads:
  weight: {gravity: g}
  spring: {spring: {first: ground.end, second: block, stiffness: k, length: l, only: compressed}}
measures: {s: {travel of block along slope}}
start: {s: 0}
"""


def test_down_a_rough_slope_onto_a_spring_the_speed_is_greatest_where_the_spring_holds_the_block() -> None:
    """With a = g (sin b - mu cos b): v^2 = 2 a s - k (s - d)^2/m, which grows up to k (s - d) = m a."""
    a = "(g*(sin(b) - mu*cos(b)))"
    is_formula(ONTO_A_SPRING, "greatest speed of block", f"sqrt(2*{a}*d + m*{a}^2/k)", (1.0, 1.02))


def test_what_a_place_beside_the_way_takes_is_no_condition_of_the_extreme() -> None:
    """A cart at rest whose pendulum is struck has its greatest speed, 2 m v/(M + m), where the pendulum hangs again."""
    cart = """
parameters: {M: 3 kg, m: 1 kg, L: 0.5 m, v: 2 m/s, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: M}, at: [0, 0]}, bob: {particle: {mass: m}}}
connections: {rail: {guide: {body: cart, along: right}}, rod: {link: [cart, bob, L]}}
loads: {w: {gravity: g}}
measures: {x: x of cart, theta: {angle of line from cart to bob from down}}
start: {theta: 0, rate(theta): v/L, x: 0, rate(x): 0}
"""
    is_formula(cart, "greatest speed of cart", "2*m*v/(M + m)")


SHAPER_RAM = """
parameters: {r: 120 mm, d: 250 mm, L: 520 mm, l: 160 mm, h: 500 mm, w: 4 rad/s}
ground: {points: {O: [0, 0], P: [0, -d]}, lines: {way: {along: right, through: [0, h - d]}}}
bodies:
  crank: {rod: {length: r}}
  lever: {rod: {length: L}, near: {angle: 90 deg}}
  link: {rod: {length: l}, near: {angle: 180 deg}}
  ram: {particle: {}, near: {at: [-0.2 m, h - d]}}
connections:
  O: {pin: [ground.O, crank.start]}
  P: {pin: [ground.P, lever.start]}
  block: {slot: {pin: crank.end, along: lever}}
  B: {pin: [lever.end, link.start]}
  C: {pin: [link.end, ram]}
  way: {slider: {body: ram, along: way}}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of crank, s: x of ram}
"""
ANTIPARALLEL = """
parameters: {a: 80 mm, d: 240 mm, w: 5 rad/s}
ground: {points: {A: [0, 0], D: [d, 0]}}
bodies:
  first: {rod: {length: a}}
  coupler: {rod: {length: d}, near: {angle: -30 deg}}
  second: {rod: {length: a}, near: {angle: -60 deg}}
connections:
  A: {pin: [ground.A, first.start]}
  B: {pin: [first.end, coupler.start]}
  C: {pin: [coupler.end, second.end]}
  D: {pin: [ground.D, second.start]}
  motor: {driver: {measure: phi, follows: 90 deg + w*t}}
measures: {phi: angle of first}
"""


def test_the_time_ratio_of_a_ram_is_that_of_its_lever() -> None:
    """The ram turns back where the lever does, sin of half its swing being r/d: (pi + 2 a)/(pi - 2 a)."""
    is_formula(SHAPER_RAM, "time ratio of s", "(pi + 2*asin(r/d))/(pi - 2*asin(r/d))", (1.0,))


def test_at_a_change_point_nothing_is_said_to_grow_without_bound_alone() -> None:
    """The second crank turns at -w (d - a)/(d + a) there, which is 0/0 in the formula of the branch."""
    found = posed(ANTIPARALLEL, "greatest angular velocity of second")
    assert found.reason.startswith("it grows without bound, or a change point is passed"), found.reason


SLED = """
parameters: {m: 80 kg, v0: 6 m/s, h: 4 m, L: 20 m, g: 9.81 m/s^2}
bodies: {sled: {particle: {mass: m}}}
connections: {hill: {curved_rail: {point: sled, y: h*cos(pi*x/L)}}}
loads: {weight: {gravity: g}}
measures: {x: x of sled}
start: {x: 0, rate(x): v0}
"""


def test_over_hills_a_sled_is_fastest_in_each_valley_and_presses_hardest_there() -> None:
    """v^2 = v0^2 + 2 g (h - y) = v0^2 + 4 g h in the valley, where y'' = h (pi/L)^2: N = m (g + v^2 y''). All is as
    before after 2 L, which is no turn of an angle."""
    speed = is_formula(SLED, "greatest speed of sled", "sqrt(v0^2 + 4*g*h)")
    assert "largest at x = L" in speed.notes
    is_formula(SLED, "greatest normal force of hill", "m*(g + (v0^2 + 4*g*h)*h*(pi/L)^2)")
    grows = posed(SLED, "greatest (x + 30*L*speed of sled/v0)")
    assert grows.expression is None
    assert grows.value is None


VAN = """
parameters: {m: 0.5 kg, L: 0.7 m, a: 3 m/s^2, g: 9.81 m/s^2}
bodies: {van: {particle: {mass: 1000 kg}}, rod: {rod: {length: L, mass: 0}}, bob: {particle: {mass: m}}}
connections:
  road: {slider: {body: van, along: right}}
  engine: {driver: {measure: x, follows: a*t^2/2}}
  hinge: {pin: [van, rod.start]}
  knob: {weld: [rod.end, bob]}
loads: {weight: {gravity: g}}
measures: {x: x of van, theta: angle of rod from down clockwise}
start: {theta: 0, rate(theta): 0}
"""


def test_the_square_of_a_force_is_stationary_where_a_product_of_waves_vanishes() -> None:
    """S = m (3 (g cos + a sin) - 2 g): S S' = 0, a polynomial of the fourth degree in tan(theta/2) with two factors."""
    is_formula(VAN, "greatest size of reaction of hinge on rod", "m*(3*sqrt(a^2 + g^2) - 2*g)")


SCOTCH_YOKE = """
parameters: {r: 60 mm, m: 4 kg, w: 30 rad/s}
bodies: {crank: {rod: {length: r}}, yoke: {body: {mass: m, lines: {slot: {along: up}}}}}
connections:
  main: {pin: [ground.O, crank.start]}
  guide: {slider: {body: yoke, along: right, through: ground.O}}
  slot: {slot: {pin: crank.end, along: yoke.slot}}
  motor: {driver: {measure: th, speed: w}}
measures: {th: angle of crank, x: x of yoke}
"""


def test_where_a_size_is_greatest_is_on_both_sides() -> None:
    """x = r cos(w t): the yoke is fastest upwards and downwards of the crank, and not slowest at one of them; the power
    m x' x'' of the drive has its ends at odd eighths of the turn."""
    speed = is_formula(SCOTCH_YOKE, "greatest speed of yoke", "r*w")
    assert [str(n) for n in speed.notes] == ["largest at th = 90° and th = -90°"]
    torque = is_formula(SCOTCH_YOKE, "greatest driving torque of motor over a turn", "m*r^2*w^2/2")
    assert [str(n) for n in torque.notes] == ["least at th = 135° and th = -45°", "largest at th = -135° and th = 45°"]


def test_an_inequality_until_an_event_is_so_all_the_way() -> None:
    """V = m g at the start, and less behind it (a small): V <= S until 60 deg where m <= S/g; V(60 deg) is less."""
    text = FALLING_ROD.replace("a: 1 deg", "a: 1 deg, S: 20 N")
    all_the_way = is_formula(
        text, "largest m so that vertical reaction of hinge <= S until th = 60 deg", "4*S/(g*(1 + 3*cos(a)^2))", (1.0,)
    )
    assert all_the_way.value == pytest.approx(20 / 9.81, rel=1e-3)
    there = posed(text, "largest m so that vertical reaction of hinge <= S when th = 60 deg")
    assert there.value == pytest.approx(16 * 20 / 9.81, rel=1e-2)


def test_what_dies_away_is_fastest_back_after_its_second_turn() -> None:
    """phi' = -phi0 w0^2/w exp(-d t) sin(w t) turns at tan(w t) = w/d, and half a period later exp(-pi d/w) times as
    far on the other side."""
    door = fb.System.from_text("""
parameters: {m: 30 kg, b: 0.9 m, k: 25 N m, c: 10 N m s}
bodies: {door: {rod: {mass: m, length: b}}}
connections: {hinge: {pin: [ground.H, door.start]}}
measures: {phi: angle of door}
loads:
  spring: {torsional_spring: {between: [ground, door], stiffness: k}}
  damper: {torsional_damper: {between: [ground, door], damping: c}}
start: {phi: 80 deg, rate(phi): 0}
""")
    (answer,) = door.solve("greatest angular velocity of door").answers
    inertia = 30 * 0.9**2 / 3
    d, w0 = 10 / (2 * inertia), math.sqrt(25 / inertia)
    w = math.sqrt(w0**2 - d**2)
    first = math.radians(80) * w0 * math.exp(-d / w * math.atan(w / d))
    assert answer.expression is not None, answer.reason
    assert answer.value == pytest.approx(first * math.exp(-math.pi * d / w), rel=1e-12)
    assert [note for note in answer.notes if "its size is more" in note and f"{first:.4f}" in note]


def test_driven_motion_knows_nothing_of_the_sides_of_a_spring() -> None:
    """x = r cos(w t), whatever the spring from O does, which x passes: at pi/(2 w) it has pulled on one side and pushes
    on the other from then on."""
    text = SCOTCH_YOKE.replace("r: 60 mm", "r: 60 mm, k: 900 N/m, L: 20 mm")
    text += "loads: {spring: {spring: {first: ground.O, second: yoke, stiffness: k, length: L}}}\n"
    asked = {"time when x = 0": "pi/(2*w)", "greatest acceleration of yoke": "r*w^2", "greatest x": "r"}
    for question, formula in asked.items():
        assert list(map(str, is_formula(text, question, formula).conditions)) == ["for all positive parameters"]
