"""Problems in the style of textbooks, each with the formula that follows by hand; its derivation stands beside it."""

from __future__ import annotations

import pytest

from freebody.errors import ModelError
from freebody.language.expression import Expr
from freebody.language.notation import to_text
from posed import is_formula, posed

MAN_ON_A_BOAT = """
parameters: {m: 70 kg, M: 130 kg, L: 4 m, u: 1.5 m/s}
ground: {points: {O: [0, 0]}}
bodies: {man: {particle: {mass: m}, at: [0, 0]}, boat: {particle: {mass: M}, at: [0, 0]}}
connections:
  ga: {slider: {body: man, along: right}}
  gb: {slider: {body: boat, along: right}}
  walk: {driver: {measure: s, follows: u*t}}
measures: {s: x of man from boat, x: x of boat}
"""
TRUSS = """
parameters: {W: 10 kN, H: 4 kN, a: 2 m, h: 1.5 m}
ground: {points: {A: [0, 0], B: [2*a, 0]}}
bodies: {C: {particle: {mass: 0}, at: [a, h]}, B: {particle: {mass: 0}, at: [2*a, 0]}}
connections:
  AC: {bar: [ground.A, C]}
  CB: {bar: [C, B]}
  AB: {bar: [ground.A, B]}
  roller: {slot: {pin: B, along: right, through: ground.B}}
loads:
  weight: {force: {at: C, along: down, magnitude: W}}
  wind: {force: {at: C, along: right, magnitude: H}}
"""
BOX_MEETS_A_LEDGE = """
parameters: {m: 20 kg, b: 0.8 m, v: 3 m/s, g: 9.81 m/s^2}
ground: {points: {K: [0, 0]}}
bodies: {box: {rectangle: {mass: m, width: b, height: b}, at: [-b/2, b/2], velocity: [v, 0]}}
connections: {trip: {pin: [ground.K, box.bottom_right], closes: at start}}
loads: {w: {gravity: g}}
measures: {phi: angle of box clockwise}
"""
CABLE_WITH_TWO_LOADS = """
parameters: {a: 3 m, h: 1 m, W: 400 N, T0: 2 kN}
ground: {points: {A: [0, 0], D: [3*a, 0]}}
bodies: {B: {particle: {mass: 0}, at: [a, -h]}, C: {particle: {mass: 0}, at: [2*a, -h]}}
connections:
  AB: {string: {from: ground.A, to: B}}
  BC: {string: {from: B, to: C}}
  CD: {string: {from: C, to: ground.D}}
loads:
  one: {force: {at: B, along: down, magnitude: W}}
  other: {force: {at: C, along: down, magnitude: W}}
"""
BOLT_CUTTER = """
parameters: {F: 100 N, a: 40 mm, b: 30 mm, c: 20 mm, e: 400 mm, f: 60 mm, s: 5 mm}
bodies:
  upper_jaw: {body: {}, points: {tip: [-c, s], O: [0, b], E: [a, b]}}
  lower_jaw: {body: {}, points: {tip: [-c, -s], O: [0, -b], E: [a, -b]}}
  upper: {body: {}, points: {E: [0, b], H: [f, 0], grip: [e, b]}}
  lower: {body: {}, points: {E: [0, -b], H: [f, 0], grip: [e, -b]}}
  plate: {body: {}, points: {U: [0, b], L: [0, -b]}}
connections:
  plate_held: {weld: [ground.O, plate.origin]}
  U: {pin: [plate.U, upper_jaw.O]}
  L: {pin: [plate.L, lower_jaw.O]}
  E1: {pin: [upper_jaw.E, upper.E]}
  E2: {pin: [lower_jaw.E, lower.E]}
  H: {pin: [upper.H, lower.H]}
  bolt: {link: [upper_jaw.tip, lower_jaw.tip, 2*s]}
loads:
  over: {force: {at: upper.grip, along: down, magnitude: F}}
  under: {force: {at: lower.grip, along: up, magnitude: F}}
"""
ROD_IN_A_BOWL = """
parameters: {m: 0.5 kg, R: 0.4 m, a: 0.2 m, g: 9.81 m/s^2, phi0: 20 deg}
ground: {points: {M: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: 2*a}}}
connections:
  left: {link: [ground.M, rod.start, R]}
  right: {link: [ground.M, rod.end, R]}
loads: {weight: {gravity: g}}
measures: {phi: angle of rod}
start: {phi: phi0}
"""
ROOT_OF_THE_SPEED = """
parameters: {J: 40 kg m^2, c: 3 N m s^0.5, w0: 60 rad/s}
bodies: {wheel: {body: {inertia: J}}}
connections: {axle: {pin: [ground.O, wheel]}}
loads: {bearing: {torque: {on: wheel, magnitude: -c*sqrt(rate(phi))}}}
measures: {phi: angle of wheel}
start: {phi: 0, rate(phi): w0}
"""
PUSHED_BACK = """
parameters: {m: 2 kg, c: 0.4 kg/s, v0: 9 m/s}
bodies: {boat: {particle: {mass: m}}}
connections: {road: {slider: {body: boat, along: right}}}
loads: {r: {force: {at: boat, along: left, magnitude: c*(v0 + rate(x))}}}
measures: {x: x of boat}
start: {x: 0, rate(x): v0}
"""
ROTOR_RIDE = """
space: {up: z}
parameters: {m: 70 kg, R: 5 m, mu: 0.6, Omega: 3 rad/s, g: 9.81 m/s^2}
bodies:
  drum: {body: {}, turned: [psi about z], planes: {wall: {normal: [-1, 0, 0], through: [R, 0, 0]}}}
  rider: {particle: {mass: m}, at: [R, 0, 0], velocity: [0, Omega*R, 0]}
connections:
  bearing: {revolute: {first: ground.O, second: drum, about: z}}
  motor: {driver: {measure: psi, follows: Omega*t}}
  wall: {contact: {between: [rider, drum.wall], friction: mu}}
loads: {weight: {gravity: g}}
"""
BELL_CRANK_GOVERNOR = """
parameters: {m: 1 kg, a: 120 mm, b: 80 mm, r: 100 mm, k: 20 kN/m, S: 500 N, Omega: 40 rad/s}
ground: {points: {P: [r, 0]}}
bodies: {crank: {body: {}, points: {ball: [0, a], roller: [-b, 0]}}, ball: {particle: {mass: m}}}
connections: {hinge: {pin: [ground.P, crank.origin]}, end: {pin: [crank.ball, ball]}}
loads:
  spring: {law: {measure: h, force: -S - k*h}}
  outwards: {law: {measure: x, force: m*Omega^2*x}}
measures: {theta: angle of crank clockwise, x: x of ball, h: height of crank.roller}
start: {theta: 0}
"""
BLOCK_FALLS_BACK = """
parameters: {m: 50 kg, b: 0.4 m, h: 1.2 m, phi0: 10 deg, e: 0.3, g: 9.81 m/s^2}
ground: {points: {H: [0, 0]}}
bodies: {block: {rectangle: {mass: m, width: b, height: h}, at: {bottom_right: [0, 0]}, angle: -phi0}}
connections:
  H: {pin: [ground.H, block.bottom_right]}
  c: {stop: {measure: phi, min: 0, restitution: e}}
loads: {weight: {gravity: g}}
measures: {phi: angle of block clockwise}
"""
WEIGHT_BRAKED_BY_A_LEVER = """
parameters: {m: 200 kg, I: 30 kg m^2, R: 0.4 m, a: 0.3 m, b: 1.2 m, mu: 0.4, P: 3 kN, v0: 2 m/s, d: 2 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], H: [-a, R]}}
bodies:
  drum: {body: {inertia: I, radius: R}, at: [0, 0]}
  weight: {particle: {mass: m}}
  lever: {body: {}, at: [-a, R], angle: 0, points: {S: [a, 0], E: [b, 0]}}
connections:
  O: {pin: [ground.O, drum]}
  H: {pin: [ground.H, lever]}
  rope: {string: {from: wound on drum, to: weight}}
  shoe: {contact: {between: [lever.S, drum], friction: mu}}
loads:
  w: {gravity: g}
  hand: {force: {at: lever.E, along: down, magnitude: P}}
measures: {y: drop of weight}
start: {y: 0, rate(y): v0}
"""
CAR_COASTS = """
parameters: {m: 900 kg, c: 0.6 kg/m, mu: 0.02, v0: 30 m/s, g: 9.81 m/s^2}
bodies: {car: {particle: {mass: m}}}
connections: {road: {slider: {body: car, along: right, friction: mu}}}
loads: {air: {drag: {body: car, quadratic: c}}, weight: {gravity: g}}
measures: {x: x of car}
start: {x: 0, rate(x): v0}
"""
BLOCKS_ON_A_SLOPE = """
parameters: {m1: 5 kg, m2: 8 kg, mu1: 0.3, mu2: 0.15, theta: 25 deg, g: 9.81 m/s^2}
ground: {lines: {slope: {along: -theta}}}
bodies: {A: {block: {mass: m1}}, B: {block: {mass: m2}}}
connections:
  sA: {slider: {body: A, along: slope, friction: mu1}}
  sB: {slider: {body: B, along: slope, friction: mu2}}
  rod: {link: {between: [A, B], length: 1 m}}
loads: {weight: {gravity: g}}
"""
THROW = """
parameters: {m: 1 kg, v0: 20 m/s, alpha: 60 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(alpha), v0*sin(alpha)]}}
loads: {weight: {gravity: g}}
measures: {y: height of ball, x: x of ball}
"""
BALL_OVER_A_FLOOR = """
parameters: {m: 0.1 kg, h: 0.5 m, e: 0.7, v: 2 m/s, d: 1.2 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h], velocity: [v, 0]}}
connections: {hit: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: height of ball, x: x of ball}
"""
SPHERE_ROLLS_AGAINST_A_WALL = """
parameters: {m: 3 kg, r: 0.1 m, v0: 4 m/s, d: 1 m, e: 0.8, mu: 0.2, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {through: [0, 0], along: up}}}
bodies: {ball: {sphere: {mass: m, radius: r}, at: [-d - r, r], velocity: [v0, 0], angular_velocity: -v0/r}}
connections:
  floor: {contact: {between: [ball, ground.floor], friction: mu, restitution: 0}}
  wall: {contact: {between: [ball, ground.wall], restitution: e}}
loads: {weight: {gravity: g}}
measures: {x: x of ball}
"""
SLANTED_ROD = """
parameters: {m: 2 kg, L: 1 m, beta: 60 deg, h: 1 m, e: 0.6, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {rod: {rod: {mass: m, length: L}, at: {start: [0, h]}, angle: beta}}
connections: {c: {contact: {between: [rod, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: height of rod}
"""


PROBLEMS = (
    # the momentum stays zero: m (s + x) + M x = 0
    (MAN_ON_A_BOAT, "displacement of the boat when s = L", "-m*L/(m + M)"),
    # moments about A give the roller, 2 a N = W a + H h; then joint B
    (TRUSS, "force in AB", "W*a/(2*h) + H/2"),
    (TRUSS, "value of H for which force in AC = 0", "W*a/h"),
    # angular momentum about the ledge, m v b/2 = 2/3 m b^2 w, and the energy for the centre to pass over it
    (BOX_MEETS_A_LEDGE, "energy lost in the blow", "5*m*v^2/16"),
    (BOX_MEETS_A_LEDGE, "least v so that phi reaches 45 deg", "sqrt(8*g*b*(sqrt(2) - 1)/3)"),
    # joint B: T h/sqrt(a^2 + h^2) = W, and level T_BC = T a/sqrt(a^2 + h^2)
    (CABLE_WITH_TWO_LOADS, "tension of AB", "W*sqrt(a^2 + h^2)/h"),
    (CABLE_WITH_TWO_LOADS, "tension of BC at start", "W*a/h"),
    (CABLE_WITH_TWO_LOADS, "least h so that tension of AB <= T0", "W*a/sqrt(T0^2 - W^2)"),
    # by symmetry H is upright, H f = F e about E; then a (H - F) = c B about the pin of the jaw
    (BOLT_CUTTER, "force in bolt", "-F*a*(e - f)/(c*f)"),
    (BOLT_CUTTER, "size of reaction of H", "F*e/f"),
    # w^2 (h^2 + a^2/3) = 2 g h (1 - cos(phi0)) with h^2 = R^2 - a^2
    (
        ROD_IN_A_BOWL,
        "angular velocity of rod when phi = 0",
        "-sqrt(6*g*sqrt(R^2 - a^2)*(1 - cos(phi0))/(3*R^2 - 2*a^2))",
    ),
    # J dw/dt = -c sqrt(w) and J w dw/dphi = -c sqrt(w); behind the rest the law has no value
    # m Omega^2 r a = S b about the hinge
    (BELL_CRANK_GOVERNOR, "value of Omega for which theta = 0 in equilibrium", "sqrt(S*b/(m*a*r))"),
    # who does not slip goes round with the drum
    (ROTOR_RIDE, "normal force of wall at start", "m*R*Omega^2"),
    (ROOT_OF_THE_SPEED, "time when wheel comes to rest", "2*J*sqrt(w0)/c"),
    (ROOT_OF_THE_SPEED, "number of revolutions until it comes to rest", "J*w0*sqrt(w0)/(3*pi*c)"),
    # the lever gives N = P b/a; (mu N - m g) d = (m + I/R^2) v0^2/2
    (
        WEIGHT_BRAKED_BY_A_LEVER,
        "value of P for which y when rate(y) = 0 is d",
        "a/(mu*b)*(m*g + (m + I/R^2)*v0^2/(2*d))",
    ),
    # m dv/dt = -mu m g - c v^2
    (
        CAR_COASTS,
        "speed of car after 10 s",
        "sqrt(m*mu*g/c)*tan(atan(v0*sqrt(c/(m*mu*g))) - 10*sqrt(c*mu*g/m))",
    ),
    # on the smoother one, which is below at all numbers: S = m2 g (sin(theta) - mu2 cos(theta)) - m2 a
    (BLOCKS_ON_A_SLOPE, "force in the rod", "m1*m2*g*(mu1 - mu2)*cos(theta)/(m1 + m2)"),
    # v^2 sin(alpha)^2/(2 g) = 2 v^2 sin(alpha) cos(alpha)/g
    (THROW, "value of alpha for which greatest y = x when y = 0", "atan(4)"),
    # it turns about the edge with m (b^2 + h^2)/3, and falls back where b > h tan(phi0)
    # it falls for sqrt(2 h/g) and then flies e times as long as it would rise and fall from h
    (BALL_OVER_A_FLOOR, "range of v for which the second impact comes before x = d", "d*sqrt(g/(2*h))/(1 + 2*e)"),
    (
        BALL_OVER_A_FLOOR,
        "value of v for which x at the second impact - x at the first impact = d",
        "d*sqrt(g/(2*h))/(2*e)",
    ),
    # the wall takes nothing of the spin: it rolls in the end with (2 - 5 e) v0/7 towards the wall
    (SPHERE_ROLLS_AGAINST_A_WALL, "range of e for which there is a second impact", "2/5"),
    (SPHERE_ROLLS_AGAINST_A_WALL, "speed of ball when slipping ends", "(5*e - 2)*v0/7"),
    (SPHERE_ROLLS_AGAINST_A_WALL, "time between the impact and rolling begins", "2*(1 + e)*v0/(7*mu*g)"),
    (BLOCK_FALLS_BACK, "energy lost in the impact", "(1 - e^2)/2*m*g*(b*sin(phi0) + h*cos(phi0) - h)"),
)


@pytest.mark.parametrize(("model", "question", "expected"), PROBLEMS, ids=[question for _m, question, _f in PROBLEMS])
def test_a_problem_has_the_formula_that_follows_by_hand(model: str, question: str, expected: str) -> None:
    is_formula(model, question, expected)


def test_what_starts_at_rest_by_a_loop_sets_out_as_its_energy_says() -> None:
    found = posed(ROD_IN_A_BOWL, "angular velocity of rod when phi = 0")
    assert found.value is not None
    assert [str(c) for c in found.conditions] == ["R > a (φ = 0 is reached)"]


def test_loads_that_do_not_balance_on_what_has_no_mass_are_no_rest() -> None:
    leaning = CABLE_WITH_TWO_LOADS.replace("at: C, along: down, magnitude: W", "at: C, along: down, magnitude: 2*W")
    found = posed(leaning, "tension of AB")
    assert found.expression is None
    assert found.value is None


def test_logarithms_are_of_numbers_above_one() -> None:
    found = posed(PUSHED_BACK, "distance until the boat comes to rest").expression
    assert isinstance(found, Expr)
    assert to_text(found) == "m·v₀·(1 - log(2))/c"


@pytest.mark.parametrize("changed", [("mu: 0.6", "mu: 0.1"), ("velocity: [0, Omega*R, 0]", "velocity: [0, 0, 0]")])
def test_who_slips_in_a_drum_is_not_led_by_it(changed: tuple[str, str]) -> None:
    assert posed(ROTOR_RIDE.replace(*changed), "normal force of wall at start").expression is None


def test_a_coefficient_of_restitution_that_is_asked_for_is_at_most_1() -> None:
    """Of the impulse J = m (1 + e) v/(1 + 3 cos(beta)^2) the centre comes to rest where e = 3 cos(beta)^2."""
    found = is_formula(SLANTED_ROD, "value of e for which velocity of y after the impact = 0", "3*cos(beta)^2")
    assert "3·cos(β)² ≤ 1 (e is at most 1)" in [str(c) for c in found.conditions]
    flat = SLANTED_ROD.replace("60 deg", "40 deg")
    assert is_formula(flat, "value of e for which velocity of y after the impact = 0", "3*cos(beta)^2").value is None


def test_a_speed_behind_an_impact_says_in_which_sense_it_goes_on() -> None:
    text = """
parameters: {mA: 4 kg, mB: 3 kg, e: 0.5, v: 3 m/s, d: 1 m}
bodies: {A: {particle: {mass: mA}}, B: {particle: {mass: mB}}}
connections:
  gA: {slider: {body: A, along: right}}
  gB: {slider: {body: B, along: right}}
  hit: {stop: {measure: gap, min: 0, restitution: e}}
measures: {x: x of A, y: x of B, gap: {expression: y - x}}
start: {x: 0, y: d, rate(x): v, rate(y): 0}
"""
    on = is_formula(text, "speed of A after the impact", "v*(mA - mB*e)/(mA + mB)")
    back = is_formula(text.replace("mB: 3 kg", "mB: 30 kg"), "speed of A after the impact", "v*(mB*e - mA)/(mA + mB)")
    assert [str(c) for c in on.conditions] == ["mA ≥ mB·e"]
    assert [str(c) for c in back.conditions] == ["mB·e ≥ mA"]


def test_a_string_that_swings_has_the_length_that_its_start_gives() -> None:
    """A nail at the depth a catches the string of a pendulum of length L: v^2 = v0^2 - 2 g (L - a) at its height."""
    text = """
parameters: {m: 0.4 kg, L: 1 m, a: 0.7 m, v0: 4 m/s, g: 9.81 m/s^2}
ground: {points: {N: [0, -a]}}
bodies: {bob: {particle: {mass: m}}}
connections: {string: {string: {from: ground.N, to: bob, swings: true}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.N to bob from down, r: distance from ground.N to bob}
start: {theta: 0, r: L - a, rate(theta): v0/(L - a)}
"""
    found = is_formula(text, "tension of string when theta = 90 deg", "m*(v0^2/(L - a) - 2*g)")
    assert "length" not in " ".join(str(c) for c in found.conditions)


def test_a_stop_of_an_angle_has_an_angular_impulse_and_none_of_a_force() -> None:
    """A gate that turns with w0 is thrown back with e w0: m b^2/3 (1 + e) w0 about its hinge."""
    text = """
parameters: {m: 40 kg, b: 1.5 m, w0: 2 rad/s, e: 0.4}
bodies: {gate: {rod: {mass: m, length: b}, angle: 0}}
connections:
  hinge: {pin: [ground.O, gate.start]}
  stopper: {stop: {measure: phi, max: 60 deg, restitution: e}}
measures: {phi: angle of gate}
start: {phi: 0, rate(phi): w0}
"""
    with pytest.raises(ModelError, match="ask for the angular impulse of stopper"):
        posed(text, "impulse of stopper")
    is_formula(text, "angular impulse of stopper", "-m*b^2*w0*(1 + e)/3")


def test_again_is_no_body_and_asks_which_impact_is_meant() -> None:
    with pytest.raises(ModelError, match="ask for the first impact or the second impact"):
        posed(BALL_OVER_A_FLOOR, "time when hit touches again")
