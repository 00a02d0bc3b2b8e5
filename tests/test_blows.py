"""Blows at the start: impulses, and connections that close. Every formula is derived here by hand from impulse and
momentum, or from the balance of angular momentum about a point through which the unknown impulse passes.

Problem families: Meriam & Kraige, Engineering Mechanics: Dynamics, ch. 3 and 6; Hibbeler, Dynamics, ch. 15 and 19;
Goldstein, Classical Mechanics, ch. 2 (exercises on impulses); Routh, Dynamics of a System of Rigid Bodies, ch. 4.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.api import System
from freebody.errors import ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.notation import to_text
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer
from posed import is_derived, is_formula, posed

BULLET = """
parameters: {m: 10 g, M: 1 kg, L: 1 m, b: 0.7 m, v: 300 m/s, g: 9.81 m/s^2}
bodies:
  bullet: {particle: {mass: m}, velocity: [v, 0]}
  rod: {rod: {mass: M, length: L}, angle: -90 deg, points: {target: [b - L/2, 0]}}
connections:
  A: {pin: [ground.A, rod.start]}
  hit: {pin: [bullet, rod.target], closes: at start}
loads: {weight: {gravity: g}}
"""
BALLISTIC = """
parameters: {m: 10 g, M: 2 kg, L: 1.5 m, v: 400 m/s, g: 9.81 m/s^2}
bodies: {bullet: {particle: {mass: m}, velocity: [v, 0]}, block: {particle: {mass: M}}}
connections:
  wire: {link: [ground.O, block, L]}
  hit: {weld: [bullet, block], closes: at start}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to block from down}}
start: {theta: 0}
"""
# nothing says where the block, or the rod, is: it hangs at rest, and the blow comes from the side
HUNG = BALLISTIC[: BALLISTIC.index("measures")]
HUNG_ROD = BULLET.replace(", angle: -90 deg", "").replace("rod.target", "rod.end")
HUNG_BOB = """
parameters: {m: 10 g, M: 2 kg, L: 1.5 m, v: 100 m/s, g: 9.81 m/s^2}
bodies: {rod: {rod: {length: L}}, bob: {particle: {mass: M}}, bullet: {particle: {mass: m}, velocity: [v, 0]}}
connections: {A: {pin: [ground.A, rod.start]}, at: {weld: [bob, rod.end]}, hit: {pin: [bullet, bob], closes: at start}}
loads: {weight: {gravity: g}}
"""
FREE_ROD = """
parameters: {m: 3 kg, L: 2 m, c: 0.4 m, J: 5 N s}
bodies: {rod: {rod: {mass: m, length: L}, points: {struck: [c, 0]}}}
loads: {blow: {impulse: {at: rod.struck, along: up, magnitude: J}}}
"""
PINNED_ROD = """
parameters: {m: 3 kg, L: 2 m, b: 1.5 m, J: 5 N s, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, angle: -90 deg, points: {struck: [b - L/2, 0]}}}
connections: {A: {pin: [ground.A, rod.start]}}
loads:
  weight: {gravity: g}
  blow: {impulse: {at: rod.struck, along: right, magnitude: J}}
"""
CUE = """
parameters: {m: 0.2 kg, R: 3 cm, h: 4 cm, J: 0.5 N s, mu: 0.2, g: 9.81 m/s^2}
ground: {lines: {table: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: R}, at: [0, R], points: {struck: [0, h - R]}}}
connections: {touch: {contact: {between: [ball, table], friction: mu}}}
loads:
  weight: {gravity: g}
  cue: {impulse: {at: ball.struck, along: right, magnitude: J}}
measures: {x: {travel of ball along table}}
"""
CLUTCH = """
parameters: {m1: 4 kg, m2: 2 kg, R: 0.2 m, w1: 30 1/s, w2: 6 1/s}
bodies:
  driving: {disk: {mass: m1, radius: R}, angular_velocity: w1}
  driven: {disk: {mass: m2, radius: R}, angular_velocity: w2}
connections:
  one: {pin: [ground.O, driving.center]}
  two: {pin: [ground.O, driven.center]}
  clutch: {weld: [driving.center, driven.center], closes: at start}
"""
CAUGHT_ROD = """
parameters: {m: 3 kg, L: 2 m, v: 4 m/s}
bodies: {rod: {rod: {mass: m, length: L}, velocity: [0, v], angular_velocity: 0}}
connections: {catch: {pin: [ground.A, rod.start], closes: at start}}
"""
STEP = """
parameters: {m: 5 kg, R: 0.5 m, h: 0.1 m, v: 2 m/s, g: 9.81 m/s^2}
ground: {points: {edge: [sqrt(h*(2*R - h)), h]}}
bodies:
  wheel: {disk: {mass: m, radius: R}, at: [0, R], angle: 0, velocity: [v, 0], angular_velocity: -v/R,
          points: {rim: [sqrt(h*(2*R - h)), h - R]}}
connections: {step: {pin: [ground.edge, wheel.rim], closes: at start}}
loads: {weight: {gravity: g}}
"""
JERK = """
parameters: {m1: 2 kg, m2: 3 kg, v: 5 m/s, g: 9.81 m/s^2, M: 2 kg, R: 0.1 m}
bodies:
  pulley: {disk: {mass: M, radius: R}, angular_velocity: 0}
  left: {particle: {mass: m1}, at: [-R, -1 m], velocity: [0, -v]}
  right: {particle: {mass: m2}, at: [R, -1 m], velocity: [0, 0]}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right, grips: [pulley]}, closes: at start}
loads: {weight: {gravity: g}}
"""
FALLING_ROD = """
parameters: {m: 3 kg, L: 2 m, v: 4 m/s, alpha: 50 deg}
ground: {lines: {floor: {along: right}}}
bodies: {rod: {rod: {mass: m, length: L}, angle: alpha, velocity: [0, -v], angular_velocity: 0}}
connections: {touch: {slot: [rod.start, ground.floor], closes: at start}}
"""
CHAIN = """
parameters: {m: 2 kg, L: 1 m, J: 3 N s}
bodies: {upper: {rod: {mass: m, length: L}, angle: -90 deg}, lower: {rod: {mass: m, length: L}, angle: -90 deg}}
connections: {A: {pin: [ground.A, upper.start]}, B: {pin: [upper.end, lower.start]}}
loads: {blow: {impulse: {at: lower.end, along: right, magnitude: J}}}
"""
GEARS = """
parameters: {m1: 4 kg, m2: 9 kg, r1: 0.2 m, r2: 0.3 m, w: 30 1/s}
ground: {points: {P: [r1 + r2, 0]}}
bodies:
  small: {disk: {mass: m1, radius: r1}, angular_velocity: w}
  large: {disk: {mass: m2, radius: r2}, angular_velocity: 0}
connections:
  one: {pin: [ground.origin, small.center]}
  two: {pin: [ground.P, large.center]}
  mesh: {gear_mesh: [small, large], closes: at start}
"""
FLYWHEEL = """
parameters: {m: 4 kg, R: 0.2 m, H: 3 N m s}
bodies: {wheel: {disk: {mass: m, radius: R}}, arm: {rod: {mass: 3 kg, length: 2 m}}}
connections: {hub: {pin: [arm.start, wheel.center]}, O: {pin: [ground.O, arm.start]}}
loads: {motor: {angular_impulse: {on: wheel, reacts_on: arm, magnitude: H}}}
"""
CART = """
parameters: {m: 2 kg, M: 5 kg, L: 1 m, J: 6 N s, g: 9.81 m/s^2}
ground: {lines: {rail: {along: right}}}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}}}
connections: {guide: {slider: [cart, ground.rail]}, rod: {link: [cart, bob, L]}}
loads: {weight: {gravity: g}, blow: {impulse: {at: cart, along: right, magnitude: J}}}
measures: {x: x of cart, phi: {angle of line from cart to bob from down}}
start: {x: 0, phi: alpha}
"""
PLATE = """
space: true
parameters: {m: 3 kg, a: 0.4 m, b: 0.6 m, J: 5 N s}
bodies: {plate: {box: {mass: m, size: [a, b, 0]}, points: {corner: [a/2, b/2, 0]}}}
loads: {blow: {impulse: {at: plate.corner, along: z, magnitude: J}}}
"""

# model, question, formula
PROBLEMS = {
    # angular momentum about the pivot: m v b = (m b^2 + M L^2/3) w
    "bullet in a rod": (BULLET, "angular velocity of rod at start", "m*v*b/(m*b^2 + M*L^2/3)"),
    # linear momentum: m v + A = (m b + M L/2) w
    "and its pivot": (BULLET, "horizontal impulse of A on rod", "(m*b + M*L/2)*m*v*b/(m*b^2 + M*L^2/3) - m*v"),
    "ballistic pendulum": (BALLISTIC, "speed of block at start", "m*v/(m + M)"),
    # T before less T after: m v^2/2 M/(m + M)
    "heat in the block": (BALLISTIC, "energy lost in the blow", "m*M*v^2/(2*(m + M))"),
    # the bullet is stopped from v to m v/(m + M)
    "on the block": (BALLISTIC, "horizontal impulse of hit on block", "m*M*v/(m + M)"),
    # m v^2/2 M/(m + M) is lost, the rest lifts both
    "block that hangs": (HUNG, "how high does the block rise", "m^2*v^2/(2*g*(m + M)^2)"),
    "rod that hangs": (HUNG_ROD, "angular velocity of rod at start", "m*v*L/(m*L^2 + M*L^2/3)"),
    # (m + M/3) L^2 w^2/2 = (m + M/2) g L (1 - cos theta) with w = m v/((m + M/3) L)
    "how far it swings": (
        HUNG_ROD.replace("300 m/s", "100 m/s") + "measures: {theta: angle of rod from down}\n",
        "through which angle does the rod swing",
        "acos(1 - m^2*v^2/(2*(m + M/3)*(m + M/2)*g*L))",
    ),
    # it hangs with its end up, at 90 deg: L w^2/2/3 = g/2 (1 - cos theta)
    "swing of a rod hung at its end": (
        "parameters: {m: 1 kg, L: 1 m, w: 3 rad/s, g: 9.81 m/s^2}\n"
        "bodies: {rod: {rod: {mass: m, length: L}, angular_velocity: w}}\n"
        "connections: {A: {pin: [ground.A, rod.end]}}\nloads: {weight: {gravity: g}}\n",
        "through which angle does the rod swing",
        "acos(1 - L*w^2/(3*g))",
    ),
    "bob on a rod": (HUNG_BOB, "how high does the bob rise", "m^2*v^2/(2*g*(m + M)^2)"),
    # the wire is vertical: it has no part in it
    "wire": (BALLISTIC, "size of impulse of wire", "0"),
    "free rod": (FREE_ROD, "angular velocity of rod at start", "12*J*c/(m*L^2)"),
    "free rod's end": (FREE_ROD, "velocity of rod.start along up at start", "J/m - 6*J*c/(m*L)"),
    # half J times the velocity of the point that is struck
    "work of the blow": (FREE_ROD, "kinetic energy at start", "J^2/(2*m) + 6*J^2*c^2/(m*L^2)"),
    "energy lost is negative": (FREE_ROD, "energy lost in the blow", "-(J^2/(2*m) + 6*J^2*c^2/(m*L^2))"),
    # J b = m L^2/3 w
    "pinned rod": (PINNED_ROD, "angular velocity of rod at start", "3*J*b/(m*L^2)"),
    "at its pivot": (PINNED_ROD, "horizontal impulse of A on rod", "3*J*b/(2*L) - J"),
    "centre of percussion": (PINNED_ROD, "value of b for which horizontal impulse of A is zero", "2*L/3"),
    "cue ball": (CUE, "velocity of ball along right at start", "J/m"),
    # J (h - R) = 2/5 m R^2 w, clockwise
    "its spin": (CUE, "angular velocity of ball at start", "-5*J*(h - R)/(2*m*R^2)"),
    # about the point of contact: J h = 7/5 m R v
    "it rolls": (CUE, "velocity of ball along right when rolling begins", "5*J*h/(7*m*R)"),
    # J/m - 2/7 (J/m - (-w) R) with friction mu g: t = (J/m + w R)/(7/2 mu g)
    "until it rolls": (CUE, "time when rolling begins", "2/7*(J/m - 5*J*(h - R)/(2*m*R))/(mu*g)"),
    # J/m = 5/2 J (h - R)/(m R^2) R
    "it rolls at once": (
        CUE,
        "value of h for which velocity of ball along right + R*angular velocity of ball is zero at start",
        "7*R/5",
    ),
    # I1 w1 + I2 w2 = (I1 + I2) w
    "clutch": (CLUTCH, "angular velocity of driven at start", "(m1*w1 + m2*w2)/(m1 + m2)"),
    # I1 I2/(2 (I1 + I2)) (w1 - w2)^2
    "heat in the clutch": (CLUTCH, "energy lost in the blow", "m1*m2*R^2*(w1 - w2)^2/(4*(m1 + m2))"),
    # about the caught end: m v L/2 = m L^2/3 w
    "caught rod": (CAUGHT_ROD, "angular velocity of rod at start", "3*v/(2*L)"),
    # m v L/2/L = m (v - v_c) with v_c = 3 v/4
    "catch": (CAUGHT_ROD, "vertical impulse of catch on rod", "-m*v/4"),
    # about the edge: m v (R - h) + m R^2/2 v/R = 3/2 m R^2 w, clockwise
    "wheel at a step": (STEP, "angular velocity of wheel at start", "-v*(3*R - 2*h)/(3*R^2)"),
    # (m1 + m2 + M/2) v' = m1 v
    "rope goes taut": (JERK, "velocity of right along up at start", "m1*v/(m1 + m2 + M/2)"),
    # end's vertical velocity 0, angular momentum about it: m v L/2 cos = (m L^2/12 + m L^2/4 cos^2) (-w) with
    # frictionless floor: v_c = -L/2 cos w', impulse N: m (v - L/2 cos w) = N, m L^2/12 w = N L/2 cos
    "falling rod": (FALLING_ROD, "angular velocity of rod at start", "-6*v*cos(alpha)/(L*(1 + 3*cos(alpha)^2))"),
    "floor": (FALLING_ROD, "vertical impulse of touch on rod", "m*v/(1 + 3*cos(alpha)^2)"),
    # M w = J L: 4/3 w1 + 1/2 w2 = J/(m L), 1/2 w1 + 1/3 w2 = J/(m L)
    "chain, upper": (CHAIN, "angular velocity of upper at start", "-6*J/(7*m*L)"),
    "chain, lower": (CHAIN, "angular velocity of lower at start", "30*J/(7*m*L)"),
    # I1 (w - w1) = r1 P, I2 w2 = -r2 P, r1 w1 = -r2 w2
    "gears mesh": (GEARS, "angular velocity of large at start", "-m1*r1*w/((m1 + m2)*r2)"),
    "flywheel": (FLYWHEEL, "angular velocity of wheel at start", "2*H/(m*R^2)"),
    "its arm": (FLYWHEEL, "angular velocity of arm at start", "-H/4"),
    # perpendicular to the plate J/m; I_x = m b^2/12, I_y = m a^2/12
    "plate": (PLATE, "velocity of plate.corner along z at start", "7*J/m"),
}


def answer(text: str, question: str) -> Answer:
    return fb.solve(System.from_text(f"{text}questions: [{question!r}]\n")).answers[0]


def agrees(found: object, formula: str, values: dict[str, float]) -> bool:
    assert isinstance(found, Expr)
    wanted = evaluate(parse(formula), values, FLOAT_FUNCTIONS)
    return evaluate(found, values, FLOAT_FUNCTIONS) == pytest.approx(wanted, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("name", PROBLEMS)
def test_textbook_blow(name: str) -> None:
    text, question, formula = PROBLEMS[name]
    found = answer(text, question)
    assert found.expression is not None, found.reason
    system = System.from_text(text)
    own = {p.name: p.value for p in system.parameters.values() if p.value is not None}
    for factor in (1.0, 1.1, 0.93):
        values = {k: v * (factor if k != "L" else 1.0) for k, v in own.items()}
        assert agrees(found.expression, formula, values), found.expression


def test_the_simulation_starts_after_the_blow() -> None:
    system = System.from_text(BALLISTIC)
    motion = fb.simulate(system, until=2.0)
    speed = 0.01 * 400 / (2.01 * 1.5)
    assert motion.series["theta"][1][0] == pytest.approx(speed, rel=1e-12)
    blow = motion.to_plain()["blow"]
    assert blow["energy_lost"] == pytest.approx(0.01 * 2 * 400**2 / (2 * 2.01), rel=1e-12)
    assert blow["impulses"]["wire.length"] == pytest.approx(0.0, abs=1e-9)
    assert "kinetic energy lost 796" in motion.to_text()
    assert motion.simulator.assumptions == ()
    assert max(abs(motion.series["theta"][0])) <= math.acos(1 - (1.5 * speed) ** 2 / (2 * 9.81 * 1.5)) * (1 + 1e-9)


REFUSED = {
    "a string that would have to push": (
        """
parameters: {m: 2 kg, L: 1 m, J: 3 N s}
bodies: {bob: {particle: {mass: m}, at: [0, -L]}}
connections: {s: {string: {from: ground.O, to: bob}}}
loads: {blow: {impulse: {at: bob, along: up, magnitude: J}}}
""",
        "s cannot hold in the blow",
    ),
    "friction in a pin": (
        PINNED_ROD.replace(
            "{pin: [ground.A, rod.start]}",
            "{pin: {first: ground.A, second: rod.start, friction: 0.2, radius: 2 cm}}",
        ),
        "the blow at the start loads A",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_blows_that_are_not_solved_are_refused(name: str) -> None:
    text, said = REFUSED[name]
    with pytest.raises(fb.FreebodyError, match=said):
        fb.simulate(System.from_text(text), until=0.1)


WRONG = {
    "another key": ("close: at start", "hit has no close. Did you mean closes?"),
    "another time": ("closes: soon", "say when it closes"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_closes_is_read_or_refused_in_words(name: str) -> None:
    written, said = WRONG[name]
    with pytest.raises(ModelError, match="closes") as error:
        System.from_text(BULLET.replace("closes: at start", written))
    assert said.partition("?")[0] in str(error.value)


def test_impulses_belong_to_the_start() -> None:
    system = System.from_text(BALLISTIC)
    with pytest.raises(ModelError, match="leave out 'when'"):
        system.question("impulse of hit on block when theta = 0")
    with pytest.raises(ModelError, match="N s"):
        System.from_text(FREE_ROD.replace("J: 5 N s", "J: 5 N"))


BRAKED = """
parameters: {k1: 2 kg m^2, k2: 0.2 m}
bodies: {p: {body: {mass: 0.5 kg, inertia: k1, center_of_mass: [k2, 0], radius: 0.125 m}}}
connections:
  rack: {rack_and_pinion: {pinion: p, rack: ground, along: down}}
  brake: {brake: {between: [p, ground], torque: 0.125 N m}}
loads: {blow: {impulse: {at: p, along: 30 deg, magnitude: 10 N s}}}
"""


def test_a_bounded_torque_has_no_impulse() -> None:
    """What a brake can transmit, times no time, is nothing: it is said, and the rack's impulse is told as ever."""
    system = System.from_text(BRAKED)
    [braked] = fb.solve(system, question="angular impulse of brake about p.mass_center").answers
    assert "bounded force or torque, which has no impulse" in str(braked.to_plain()["reason"])
    [held] = fb.solve(system, question="size of impulse of rack").answers
    assert held.value is not None


def test_redundant_impulses_are_named() -> None:
    """Two pins on one axis: only the sum of what they transmit is determined."""
    text = PINNED_ROD.replace("connections: {", "connections: {B: {pin: [ground.A, rod.start]}, ")
    found = answer(text, "horizontal impulse of A on rod")
    assert found.expression is None
    assert "A" in found.reason
    assert "B" in found.reason
    assert answer(text, "angular velocity of rod at start").expression is not None


def test_a_contact_answers_to_what_the_blow_leaves() -> None:
    """Struck at 30 degrees downwards, a ball bounces with e times the speed that the blow gives it into the table."""
    text = CUE.replace("along: right, magnitude", "along: -30 deg, magnitude").replace("mu}}", "mu, restitution: 0.5}}")
    found = fb.simulate(System.from_text(text + "questions: []\n"), until=0.05)
    assert found.events[0].time == 0.0
    # 0.5*J*sin(30 deg)/m upwards, J*5h/(7mR)*cos(30 deg) along the table while it rolls
    along = 5 * 0.5 * 0.04 / (7 * 0.2 * 0.03) * math.cos(math.pi / 6)
    assert found.series["x"][1][-1] == pytest.approx(along, rel=1e-9)


def test_the_derivation_balances_momenta() -> None:
    said = fb.explain(System.from_text(BULLET + "questions: [angular velocity of rod at start]\n")).to_text()
    assert "The blow" in said
    assert "hit closes" in said
    assert "m⋅b⋅v" in said
    german = fb.explain(System.from_text(BULLET + "questions: [impulse of A on rod]\n"), language="de").to_text()
    assert "Der Stoß" in german


def test_cases_that_differ_in_a_sign_exclude_each_other() -> None:
    """Squares of |sqrt(3) (7 R - 5 h)| > 7 mu R do not tell in which sense it slips: the sign stands beside them."""
    text = CUE.replace("along: right, magnitude", "along: -30 deg, magnitude")
    found = fb.solve(System.from_text(text + "questions: [time when rolling begins]\n")).answers[0]
    sets = [frozenset(case.conditions) for case in found.cases]
    assert len(sets) == 2
    assert len(set(sets)) == 2
    assert {"7·R > 5·h", "5·h > 7·R"} <= frozenset().union(*sets)


def test_a_struck_end_may_be_left_at_rest() -> None:
    # J (l - b)/(m1 l) of the end at the distance b from the blow: |l - b| is l - b up to b = l
    system = System.from_text("""
parameters: {m1: 1 kg, m2: 2 kg, l: 0.5 m, J: 4 N s, b: 0.2 m}
bodies:
  A: {particle: {mass: m1}, at: [0, 0]}
  B: {particle: {mass: m2}}
  bar: {rod: {length: l}, at: {start: [0, 0]}, angle: 90 deg, points: {P: [b - l/2, 0]}}
connections: {a: {weld: [bar.start, A]}, c: {weld: [bar.end, B]}}
loads: {blow: {impulse: {at: bar.P, along: right, magnitude: J}}}
""")
    found = fb.solve(system, "value of b for which speed of A after the blow = 0").answers[0]
    assert found.expression is not None, found.reason
    assert to_text(found.expression) == "l"


def test_a_blow_that_adds_energy_says_so() -> None:
    """I w = J b, I = m L^2/3: T = 3 (J b)^2/(2 m L^2) = 7.03125 J."""
    motion = fb.simulate(System.from_text(PINNED_ROD), until=0.1)
    assert motion.to_plain()["blow"]["energy_lost"] == pytest.approx(-7.03125, rel=1e-12)
    assert "kinetic energy gained 7.03125 J" in motion.to_text()


STRUCK_ROD = """
parameters: {M: 4 kg, m: 20 g, L: 0.9 m, b: 0.8 m, v: 300 m/s}
bodies:
  rod: {rod: {mass: M, length: L}, angle: -90 deg, points: {P: [b - L/2, 0]}}
  bullet: {particle: {mass: m}, at: [0, -b], velocity: [v, 0]}
connections: {hinge: {pin: [ground.O, rod.start]}, stick: {pin: [rod.P, bullet], closes: at start}}
"""


@pytest.mark.parametrize(
    "question",
    [
        "energy lost in the blow / kinetic energy of bullet before the blow",
        "impulse of stick on rod along right / (m*(velocity of bullet along right before the blow))",
    ],
)
def test_what_a_body_had_before_the_blow_of_the_start_stands_beside_what_the_blow_does(question: str) -> None:
    """With I = M L^2/3 the bullet keeps m b^2/(I + m b^2) of its energy, and of its momentum."""
    is_formula(STRUCK_ROD, question, "M*L^2/(M*L^2 + 3*m*b^2)")
    is_derived(STRUCK_ROD, question)


def test_before_a_blow_in_space_velocities_are_told_of_each_body() -> None:
    """Relative speed v - w b, effective mass 1/(1/m + 1/M + b^2/I), I = M a^2/6."""
    model = """
space: true
parameters: {M: 4 kg, a: 0.6 m, m: 20 g, v: 100 m/s, b: 0.2 m, w: 2 1/s}
bodies:
  plate: {box: {mass: M, size: [a, a, 1 cm]}, at: [0, 0, 0], angular_velocity: [0, 0, w], points: {P: [b, 0, 0]}}
  bullet: {particle: {mass: m}, at: [b, 0, 0], velocity: [0, v, 0]}
connections: {stick: {spherical: [plate.P, bullet], closes: at start}}
"""
    lost = "(v - w*b)^2/(2*(1/m + 1/M + 6*b^2/(M*a^2)))"
    is_formula(model, "energy lost in the blow - kinetic energy of plate before the blow", f"{lost} - M*a^2*w^2/12")


def test_no_forces_are_told_just_before_the_blow_of_the_start() -> None:
    found = posed(STRUCK_ROD, "impulse of hinge along right / (reaction of hinge along up before the blow)")
    assert "only places and velocities are told" in found.reason


def test_what_hangs_at_the_start_is_told() -> None:
    result = System.from_text(HUNG).solve("speed of block at start")
    assert "nothing says where block is at the start: it hangs below ground.O" in map(str, result.assumptions)


def test_an_angle_that_grows_with_every_turn_has_no_stroke_in_numbers() -> None:
    system = System.from_text(HUNG_ROD + "measures: {theta: angle of rod from down}")
    (answer,) = system.solve("stroke of theta").answers
    assert answer.expression is None
    assert answer.value is None
