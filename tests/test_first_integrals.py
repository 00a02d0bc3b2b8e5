"""First integrals: energy, momenta and Jacobi's integral, and the time that they give as an elliptic integral.

Every formula is worked out by hand: u^2 = W(q) from what is conserved, and dt = dq/u. Problem families: Landau &
Lifshitz, Mechanics, sec. 11; Goldstein, Poole & Safko, Classical Mechanics, ch. 2, 3 and 8; Taylor, Classical
Mechanics, ch. 4, 7 and 13; Meriam & Kraige, Dynamics, ch. 3 and 6; Beer & Johnston, Dynamics, ch. 13, 17 and 19;
Kleppner & Kolenkow, An Introduction to Mechanics, ch. 4 to 6; Byrd & Friedman, Handbook of Elliptic Integrals.
"""

from __future__ import annotations

import math
import random

import pytest
from scipy.special import ellipk, ellipkinc

import freebody as fb
from freebody.api import System
from freebody.errors import ExpressionError
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.language.notation import to_latex, to_python, to_text
from freebody.language.parser import parse
from posed import is_formula, posed

PENDULUM = """
parameters: {{m: 1.2 kg, L: 0.8 m, g: 9.81 m/s^2, theta_0: 50 deg, theta_1: 20 deg, w: {w}}}
bodies: {{bob: {{{body}}}}}
connections: {{joint: {{{joint}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{theta: {{{angle}}}}}
start: {{theta: {at}, rate(theta): {rate}}}
"""
SIMPLE = PENDULUM.format(
    w="2 rad/s",
    body="particle: {mass: m}",
    joint="link: [ground.O, bob, L]",
    angle="angle of line from ground.O to bob from down",
    at="theta_0",
    rate="0",
)
ROD = {"body": "rod: {mass: m, length: L}", "joint": "pin: [ground.O, bob.start]", "angle": "angle of bob from down"}
HELD = PENDULUM.format(**ROD, w="2 rad/s", at="theta_0", rate="0")
STRUCK = PENDULUM.format(**ROD, w="4 rad/s", at="0", rate="w")
WHIRLED = PENDULUM.format(**ROD, w="14 rad/s", at="0", rate="w")
SPRING = """
parameters: {{m: 2 kg, k: 50 N/m, b: 300 N/m^3, c: {c} kg/s, a: 0.3 m, v0: 2 m/s}}
ground: {{lines: {{rail: {{along: right}}}}}}
bodies: {{slide: {{particle: {{mass: m}}}}}}
connections: {{guide: {{slider: [slide, ground.rail]}}}}
loads: {{spring: {{force: {{at: slide, along: right, magnitude: {law}}}}}}}
measures: {{x: x of slide}}
start: {{x: {at}, rate(x): {rate}}}
"""
HARD = SPRING.format(c=1, law="-k*x - b*x^3", at="a", rate="0")
HARD_STRUCK = SPRING.format(c=1, law="-k*x - b*x^3", at="0", rate="v0")
SOFT = SPRING.format(c=1, law="-k*x + b*x^3", at="a", rate="0")
TWO_WELLS = SPRING.format(c=1, law="k*x - b*x^3", at="0.5 m", rate="0")
LINEAR = SPRING.format(c=1, law="-k*x", at="a", rate="v0")
DAMPED = SPRING.format(c=4, law="-k*x - c*rate(x)", at="a", rate="0")

SPRUNG = """
parameters: {m: 1.2 kg, R: 0.8 m, g: 9.81 m/s^2, theta_0: 40 deg, s: 8 N/m}
bodies: {bead: {particle: {mass: m}}}
connections: {wire: {link: [ground.O, bead, R]}}
loads: {weight: {gravity: g}, spring: {force: {at: bead, along: right, magnitude: -s*x}}}
measures: {theta: {angle of line from ground.O to bead from down}, x: x of bead}
start: {theta: theta_0, rate(theta): 0}
"""
K_0 = "elliptic_K(sin(theta_0/2))"
K_W = "elliptic_K(w/2*sqrt(2*L/(3*g)))"
D = "sqrt(k^2 + 2*m*b*v0^2)"

ELLIPTIC = {
    # u^2 = 2 g/L (cos(theta) - cos(theta_0)); sin(theta/2) = sin(theta_0/2) sin(phi)
    "period": (SIMPLE, "period of theta", f"4*sqrt(L/g)*{K_0}"),
    "period of the motion": (SIMPLE, "exact period", f"4*sqrt(L/g)*{K_0}"),
    "to the middle": (SIMPLE, "time when theta = 0", f"sqrt(L/g)*{K_0}"),
    "to the turn": (SIMPLE, "time when rate(theta) = 0", f"2*sqrt(L/g)*{K_0}"),
    "on the way": (
        SIMPLE,
        "time when theta = theta_1",
        f"sqrt(L/g)*({K_0} - elliptic_F(asin(sin(theta_1/2)/sin(theta_0/2)), sin(theta_0/2)))",
    ),
    "beyond the middle": (
        SIMPLE,
        "time when theta = -theta_1",
        f"sqrt(L/g)*({K_0} + elliptic_F(asin(sin(theta_1/2)/sin(theta_0/2)), sin(theta_0/2)))",
    ),
    # a rod about its end has the reduced length 2 L/3
    "physical": (HELD, "period of theta", f"4*sqrt(2*L/(3*g))*{K_0}"),
    # from below with w: k = w/2 sqrt(l/g) of the reduced length l
    "struck": (STRUCK, "period of theta", f"4*sqrt(2*L/(3*g))*{K_W}"),
    "struck, to the turn": (STRUCK, "time when rate(theta) = 0", f"sqrt(2*L/(3*g))*{K_W}"),
    "struck, on the way": (
        STRUCK,
        "time when theta = theta_1",
        "sqrt(2*L/(3*g))*elliptic_F(asin(2/w*sqrt(3*g/(2*L))*sin(theta_1/2)), w/2*sqrt(2*L/(3*g)))",
    ),
    "struck, after the turn": (
        STRUCK,
        "time when theta = -theta_1",
        f"sqrt(2*L/(3*g))*(2*{K_W} + elliptic_F(asin(2/w*sqrt(3*g/(2*L))*sin(theta_1/2)), w/2*sqrt(2*L/(3*g))))",
    ),
    # it turns over: theta/2 is the amplitude, k = 2/w sqrt(g/l)
    "whirled": (WHIRLED, "period of theta", "4/w*elliptic_K(2/w*sqrt(3*g/(2*L)))"),
    "whirled, on the way": (
        WHIRLED,
        "time when theta = theta_1",
        "2/w*elliptic_F(theta_1/2, 2/w*sqrt(3*g/(2*L)))",
    ),
    "whirled, at the top": (WHIRLED, "time when theta = pi", "2/w*elliptic_K(2/w*sqrt(3*g/(2*L)))"),
    # m u^2 = (a^2 - x^2) (k + b (a^2 + x^2)/2): x = a cos(phi)
    "hard": (HARD, "period of x", "4*sqrt(m/(k + b*a^2))*elliptic_K(a*sqrt(b/(2*k + 2*b*a^2)))"),
    "hard, half way": (
        HARD,
        "time when x = a/2",
        "sqrt(m/(k + b*a^2))*elliptic_F(pi/3, a*sqrt(b/(2*k + 2*b*a^2)))",
    ),
    "hard, struck": (HARD_STRUCK, "period of x", f"4*sqrt(m/{D})*elliptic_K(sqrt(({D} - k)/(2*{D})))"),
    # m u^2 = (a^2 - x^2) (k - b (a^2 + x^2)/2): x = a sin(phi)
    "soft": (SOFT, "period of x", "4*sqrt(2*m/(2*k - b*a^2))*elliptic_K(a*sqrt(b/(2*k - b*a^2)))"),
    # R u^2/2 = (cos q - C)(g + k R/(2 m) (cos q + C)): a bead between a spring and its weight. Goldstein, ch. 2, hoop
    "sprung bead": (
        SPRUNG,
        "period of theta",
        "4*sqrt(2)/sqrt(2*g/R + 2*s/m*cos(theta_0))"
        "*elliptic_K(sqrt((1 - cos(theta_0))*(2*g/R + s/m*cos(theta_0) - s/m)/(4*g/R + 4*s/m*cos(theta_0))))",
    ),
    "stiff bead": (
        SPRUNG.replace("s: 8", "s: 400"),
        "time when theta = 0",
        "2/sqrt((1 + cos(theta_0))*(2*g/R + s/m*cos(theta_0) + s/m))"
        "*elliptic_K(sqrt((1 - cos(theta_0))*(s/m - 2*g/R - s/m*cos(theta_0))"
        "/((1 + cos(theta_0))*(2*g/R + s/m*cos(theta_0) + s/m))))",
    ),
    # harmonic and damped
    "harmonic": (LINEAR, "period of x", "2*pi*sqrt(m/k)"),
    "damped": (DAMPED, "period of the motion", "2*pi/sqrt(k/m - c^2/(4*m^2))"),
}


@pytest.mark.parametrize("name", ELLIPTIC)
def test_the_time_of_a_way_by_energy(name: str) -> None:
    is_formula(*ELLIPTIC[name])


def test_elliptic_integrals_are_those_of_scipy_whose_parameter_is_the_square_of_the_modulus() -> None:
    draw = random.Random(7)
    complete, incomplete = FLOAT_FUNCTIONS["elliptic_K"], FLOAT_FUNCTIONS["elliptic_F"]
    for _ in range(500):
        k, phi = draw.uniform(0, 0.999), draw.uniform(-8, 8)
        assert complete(k) == pytest.approx(ellipk(k * k), rel=1e-13)
        assert incomplete(phi, k) == pytest.approx(ellipkinc(phi, k * k), rel=1e-13, abs=1e-14)
    assert incomplete(0.7, 0.0) == pytest.approx(0.7)
    for k in (1.0, -1.0, 1.5, math.nan):
        with pytest.raises(ValueError, match="modulus"):
            complete(k)


@pytest.mark.parametrize("degrees", [61.5, 75.5])
def test_the_period_of_a_rod_from_an_angle_of_which_a_sine_is_no_root(degrees: float) -> None:
    """4 sqrt(2 L/(3 g)) K(sin(theta_0/2)), whose modulus is a number that no root of a rational number is."""
    [answer] = fb.solve(
        System.from_text(
            f"""
parameters: {{m: 2 kg, L: 1.25 m, g: 9.81 m/s^2}}
bodies: {{rod: {{rod: {{mass: m, length: L}}}}}}
connections: {{hinge: {{pin: [ground.O, rod.start]}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{theta: {{angle of rod from down}}}}
start: {{theta: -{degrees} deg, rate(theta): 0}}
questions: [period of theta]
"""
        )
    ).answers
    modulus = math.sin(math.radians(degrees) / 2.0)
    assert answer.value == pytest.approx(4.0 * math.sqrt(2.0 * 1.25 / (3.0 * 9.81)) * ellipk(modulus**2), rel=1e-12)


def test_the_period_of_a_pendulum_is_the_tabulated_multiple_of_that_of_small_oscillations() -> None:
    # 2 K(sin 45 deg)/pi = 1.18034 for an amplitude of 90 degrees: Nelson & Olsson, Am. J. Phys. 54, 1986, 112
    half_turn = SIMPLE.replace("theta_0: 50 deg", "theta_0: 90 deg")
    exact, small = (posed(half_turn, q).value for q in ("period of theta", "period of small oscillations"))
    assert isinstance(exact, float)
    assert isinstance(small, float)
    assert exact / small == pytest.approx(1.1803406, rel=1e-7)


def test_an_elliptic_integral_is_written_with_its_modulus_and_read_again() -> None:
    e = parse("4*sqrt(L/g)*elliptic_F(phi/2, k) - elliptic_K(sin(a))^2")
    assert parse(to_python(e)) == e
    assert to_text(parse("elliptic_F(phi, k)")) == "F(φ, k)"
    assert to_latex(parse("2*elliptic_K(k)")) == r"2 K\!\left(k\right)"
    assert evaluate(parse("elliptic_F(pi/2, 0.5) - elliptic_K(0.5)"), {}) == pytest.approx(0)
    for wrong in ("elliptic_F(phi)", "elliptic_K(a, b)", "sin(a, b)", "(a, b)", "a, b", "elliptic_F(a, b, c)"):
        with pytest.raises(ExpressionError, match=r"take one argument|with the modulus k"):
            parse(wrong)


def test_an_answer_says_by_which_convention_its_elliptic_integrals_are_written() -> None:
    assert any("modulus k" in note and "parameter m want k²" in note for note in posed(SIMPLE, "period of theta").notes)


def test_options_with_elliptic_integrals_are_judged() -> None:
    right, wrong = "4*sqrt(L/g)*elliptic_K(sin(theta_0/2))", "4*sqrt(L/g)*elliptic_K(sin(theta_0/2)^2)"
    asked = f"questions: [{{find: period of theta, options: {{a: '{right}', b: '{wrong}'}}, key: a}}]\n"
    found = fb.solve(System.from_text(SIMPLE + asked)).answers[0]
    assert found.choice == "a"


def test_a_motion_that_does_not_come_back_has_no_period() -> None:
    falling = "bodies: {ball: {particle: {mass: 1 kg}}}\nloads: {w: {gravity: 9.81 m/s^2}}\nmeasures: {y: y of ball}\n"
    found = posed(falling, "period of y")
    assert found.expression is None
    assert "does not repeat itself" in found.reason


def test_two_wells_have_the_period_of_the_well_in_which_it_moves() -> None:
    found = posed(TWO_WELLS, "period of x")
    assert found.evidence is not None
    # u^2 = b/(2 m) (o^2 - x^2)(x^2 - i^2) with o = 0.5 m and i^2 = 2 k/b - o^2
    m, k, b, o = 2, 50, 300, 0.5
    inner = 2 * k / b - o * o
    assert found.value == pytest.approx(2 / o * math.sqrt(2 * m / b) * ellipk(1 - inner / o**2), rel=1e-9)


@pytest.mark.parametrize("text", [SIMPLE, STRUCK, WHIRLED, LINEAR, DAMPED, HARD], ids=range(6))
def test_periods_are_derived(text: str) -> None:
    system = System.from_text(text + "questions: [period of the motion]\n")
    told = fb.explain(system).to_text()
    assert "period" in told.lower()


# -- Jacobi's integral ------------------------------------------------------------------------
TUBE = """
parameters: {{m: 0.2 kg, w: 3 rad/s, a: 0.2 m, b: 0.7 m, k: {k} N/m, v0: 1.5 m/s, g: 9.81 m/s^2}}
bodies:
  rod:  {{rod: {{length: 2 m}}}}
  bead: {{particle: {{mass: m}}, near: {{at: [0.2 m, 0]}}}}
connections:
  axle:  {{pin: [ground.O, rod.center]}}
  slot:  {{slot: {{pin: bead, along: rod.x, on: rod}}}}
  motor: {{driver: {{measure: angle of rod, follows: w*t}}}}
loads: {{{load}}}
measures: {{r: {{travel of bead along rod.x from rod.center}}}}
start: {{r: {at}, rate(r): {rate}}}
"""
FLUNG = TUBE.format(k=5, load="", at="a", rate="0")
SHOT_IN = TUBE.format(k=5, load="", at="b", rate="-v0")
CUBIC = TUBE.format(k=4, load="spring: {law: {measure: r, force: -k*r^3/a^2}}", at="a", rate="v0")
HOOP = """
parameters: {m: 0.2 kg, M: 1 kg, R: 0.5 m, W: 3 rad/s, u0: 8 rad/s, q: 60 deg}
bodies:
  hoop: {ring: {mass: M, radius: R}, points: {A: [-R, 0]}}
  bead: {particle: {mass: m}}
connections:
  axle:  {pin: [ground.O, hoop.A]}
  motor: {driver: {measure: angle of hoop, follows: W*t}}
  wire:  {link: [hoop.center, bead, R]}
measures: {beta: {angle of line from hoop.center to bead from hoop.x}}
start: {beta: 0, rate(beta): u0}
"""
CAR = """
parameters: {m: 3 kg, M: 10 kg, L: 1 m, a0: 2 m/s^2, g: 9.81 m/s^2, q: 10 deg, at: 60 deg}
bodies:
  car: {particle: {mass: M}}
  rod: {rod: {mass: m, length: L}, near: {angle: -90 deg}}
connections:
  track: {slider: {body: car, along: right}}
  motor: {driver: {measure: x of car, follows: a0*t^2/2}}
  hinge: {pin: [car, rod.start]}
loads: {weight: {gravity: g}}
measures: {th: angle of line from rod.end to rod.start from up}
start: {th: 0}
"""
LIFT = CAR.replace("along: right", "along: up").replace("x of car", "y of car").replace("th: 0", "th: at")
DOUBLE = """
parameters: {W: 3 rad/s, a: 0.3 m, l: 0.2 m, m: 0.5 kg, M: 1 kg, R: 0.1 m, u: 8 rad/s, w: 5 rad/s, q: 60 deg}
bodies: {arm: {rod: {length: a}}, rod: {rod: {mass: m, length: l}}, disk: {disk: {mass: M, radius: R}}}
connections:
  O: {pin: [ground.O, arm.start]}
  motor: {driver: {measure: angle of arm, follows: W*t}}
  B: {pin: [arm.end, rod.start]}
  C: {pin: [rod.end, disk.center]}
measures: {beta: angle of rod relative to arm, gamma: angle of disk relative to rod}
start: {beta: 0, gamma: 0, rate(beta): u, rate(gamma): w}
"""
CENTRED = HOOP.replace("{A: [-R, 0]}", "{A: [0, 0]}")

BESIDE_DRIVERS = {
    # r'' = w^2 r: r'^2 - w^2 r^2 is kept; Coriolis 2 m w r' on the wall. Taylor, ex. 7.5 family; Meriam, ch. 2
    "flung out": (FLUNG, "velocity of r when r = b", "w*sqrt(b^2 - a^2)"),
    "wall": (FLUNG, "normal force of slot when r = b", "2*m*w^2*sqrt(b^2 - a^2)"),
    "shot in": (SHOT_IN, "r when rate(r) = 0", "sqrt(b^2 - v0^2/w^2)"),
    # with a spring that hardens: r'^2/2 - w^2 r^2/2 + k r^4/(4 m a^2)
    "spring": (
        CUBIC,
        "velocity of r when r = 1.2*a",
        "sqrt(v0^2 + w^2*(1.44 - 1)*a^2 - k*a^2/(2*m)*(1.2^4 - 1))",
    ),
    # beta'' = -W^2 sin(beta): beta'^2 = u0^2 - 2 W^2 (1 - cos(beta)), as a pendulum. Goldstein, ch. 1, hoop family
    "hoop": (HOOP, "velocity of beta when beta = q", "sqrt(u0^2 - 2*W^2*(1 - cos(q)))"),
    "hoop turns": (HOOP, "period of beta", "4/u0*elliptic_K(2*W/u0)"),
    "hoop, time": (HOOP, "time when beta = q", "2/u0*elliptic_F(q/2, 2*W/u0)"),
    # in the frame of the car L^2 th'^2/6 = g L (cos(th) - 1)/2 - a0 L sin(th)/2. Meriam & Kraige, ch. 6; BJ, ch. 17
    "car": (CAR, "velocity of th when th = -q", "-sqrt(3/L*(g*cos(q) + a0*sin(q) - g))"),
    "car, how far": (CAR, "least th", "-2*atan(a0/g)"),
    # in a lift that starts the weight is m (g + a0)
    "lift": (LIFT, "velocity of th when th = 0", "-sqrt(3*(g + a0)*(1 - cos(at))/L)"),
    "lift, force": (LIFT, "size of reaction of hinge when th = 0", "m*(g + a0)*(5 - 3*cos(at))/2"),
    # a disk free at the end of a rod keeps its spin, gamma' + beta' = u + w; the rod is a pendulum in the field W^2 a
    "a momentum beside": (
        DOUBLE,
        "velocity of beta when beta = q",
        "sqrt(u^2 - 2*W^2*a*(m/2 + M)/(l*(m/3 + M))*(1 - cos(q)))",
    ),
    "the other speed": (
        DOUBLE,
        "velocity of gamma when beta = q",
        "u + w - sqrt(u^2 - 2*W^2*a*(m/2 + M)/(l*(m/3 + M))*(1 - cos(q)))",
    ),
    # towards the centre of the hoop: centripetal and Coriolis (beta' + W)^2 R, and W^2 R cos(beta) of the centre
    "hoop, force": (
        HOOP,
        "tension of wire when beta = q",
        "m*R*((sqrt(u0^2 - 2*W^2*(1 - cos(q))) + W)^2 + W^2*cos(q))",
    ),
}


@pytest.mark.parametrize("name", BESIDE_DRIVERS)
def test_jacobis_integral_gives_speeds_and_forces(name: str) -> None:
    is_formula(*BESIDE_DRIVERS[name], factors=(1.0, 1.02, 0.99))


def test_jacobis_integral_is_told_where_energy_is_not_conserved() -> None:
    told = fb.explain(System.from_text(HOOP + "questions: [velocity of beta when beta = q]\n")).to_text()
    assert "Jacobi's integral" in " ".join(told.split())
    assert "T + V stays what it was" not in told


def test_momenta_beside_jacobis_integral_are_told() -> None:
    told = fb.explain(System.from_text(DOUBLE + "questions: [velocity of beta when beta = q]\n")).to_text()
    said = " ".join(told.split())
    assert "its generalized momentum is conserved" in said
    assert "T₂ is the part of T that is quadratic in β' and γ', T₀ the part without β' and γ'" in said


def test_the_inertia_force_beside_a_drive_that_accelerates_is_told() -> None:
    told = " ".join(fb.explain(System.from_text(CAR + "questions: [velocity of th when th = -q]\n")).to_text().split())
    assert "whose potential is U = m·L·a₀·sin(th)/2" in told


def test_a_drive_that_does_not_accelerate_evenly_leaves_no_first_integral() -> None:
    found = posed(CAR.replace("a0*t^2/2", "a0*t^3/(2 s)"), "velocity of th when th = -q")
    assert found.expression is None


def test_a_driver_in_a_gravity_field_leaves_no_first_integral() -> None:
    found = posed(FLUNG.replace("loads: {}", "loads: {weight: {gravity: g}}"), "velocity of r when r = b")
    assert "sqrt(" not in str(found.expression)


# -- loads with a potential along the motion --------------------------------------------------
FOLLOWED = """
parameters: {m: 1 kg, L: 1 m, F: 8 N, g: 9.81 m/s^2, q: 60 deg, c: 3 N m, G: 4 N m^2, r0: 2 m, r1: 0.5 m, v0: 1 m/s}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}, push: {force: {at: rod.end, along: rod.y, magnitude: F}}}
measures: {th: {angle of rod from down}}
start: {th: 0, rate(th): 0}
"""
WOUND = FOLLOWED.replace("along: rod.y, magnitude: F", "along: rod.y, magnitude: F*cos(th)")
CENTRE = """
parameters: {m: 2 kg, G: 4 N m^2, r0: 2 m, r1: 0.5 m, v0: 1 m/s}
ground: {lines: {ray: {along: right}}}
bodies: {star: {particle: {mass: m}}}
connections: {guide: {slider: [star, ground.ray]}}
loads: {pull: {law: {measure: r, force: -G/r^2}}}
measures: {r: x of star}
start: {r: r0, rate(r): RATE}
"""
FALLING, THROWN = CENTRE.replace("RATE", "0"), CENTRE.replace("RATE", "v0")
HYPERBOLIC = FALLING.replace("-G/r^2", "-G/(r*r0)")

ALONG_THE_WAY = {
    # m L^2/6 u^2 = F L q - m g L/2 (1 - cos(q)): a jet at the tip of a rod. Meriam, ch. 6, family of the thruster
    "follower": (FOLLOWED, "velocity of th when th = q", "sqrt(6/(m*L)*(F*q - m*g/2*(1 - cos(q))))"),
    "follower, law": (WOUND, "velocity of th when th = q", "sqrt(6/(m*L)*(F*sin(q) - m*g/2*(1 - cos(q))))"),
    # m v^2/2 - G/r. Kleppner & Kolenkow, ch. 5: fall towards a centre, speed of escape
    "fall": (FALLING, "velocity of r when r = r1", "-sqrt(2*G/m*(1/r1 - 1/r0))"),
    "thrown": (THROWN, "r when rate(r) = 0", "1/(1/r0 - m*v0^2/(2*G))"),
    # a force like that of a charged wire: a potential with a logarithm
    "wire": (HYPERBOLIC, "velocity of r when r = r1", "-sqrt(2*G/(m*r0)*log(r0/r1))"),
}


@pytest.mark.parametrize("name", ALONG_THE_WAY)
def test_a_load_has_a_potential_along_the_motion(name: str) -> None:
    is_formula(*ALONG_THE_WAY[name])


def test_the_work_of_a_follower_load_is_told() -> None:
    told = fb.explain(System.from_text(FOLLOWED + "questions: [velocity of th when th = q]\n")).to_text()
    assert "as from a potential energy" in " ".join(told.split())


# -- several coordinates together in time -----------------------------------------------------
TRACK = """
parameters: {{m1: 1 kg, m2: {m2} kg, k: 100 N/m, c: 30 N/m, a: 0.1 m, v0: 2 m/s, l: 0.4 m, T: 0.5 s, F1: 5 N, F2: 4 N}}
ground: {{lines: {{rail: {{along: right}}}}}}
bodies: {{A: {{particle: {{mass: m1}}}}, B: {{particle: {{mass: {mass}}}}}}}
connections: {{gA: {{slider: [A, ground.rail]}}, gB: {{slider: [B, ground.rail]}}}}
measures: {{x1: x of A, x2: x of B, d: {{expression: x2 - x1}}}}
loads: {loads}
start: {{{start}}}
"""
BETWEEN_WALLS = TRACK.format(
    m2=2,
    mass="m1",
    loads="""
  f1: {force: {at: A, along: right, magnitude: -k*x1 + c*(x2 - x1)}}
  f2: {force: {at: B, along: right, magnitude: -k*x2 - c*(x2 - x1)}}
""",
    start="x1: a, rate(x1): 0, x2: 0, rate(x2): 0",
)
FREE = TRACK.format(
    m2=3,
    mass="m2",
    loads="{s: {spring: {first: A, second: B, stiffness: k, length: l}}}",
    start="x1: 0, rate(x1): v0, x2: l, rate(x2): 0",
)
RACE = TRACK.format(
    m2=2,
    mass="m2",
    loads="""
  f1: {force: {at: A, along: right, magnitude: F1}}
  f2: {force: {at: B, along: right, magnitude: F2}}
""",
    start="x1: 0, rate(x1): 0, x2: l, rate(x2): 0",
)
SLOW, QUICK = "sqrt(k/m1)", "sqrt((k + 2*c)/m1)"
REDUCED = "sqrt(k*(m1 + m2)/(m1*m2))"

TOGETHER = {
    # symmetric and antisymmetric mode. Taylor, sec. 11.2 and 11.3; Landau & Lifshitz, sec. 23
    "first": (BETWEEN_WALLS, "x1 at t = T", f"a/2*(cos({SLOW}*T) + cos({QUICK}*T))"),
    "second": (BETWEEN_WALLS, "x2 at t = T", f"a/2*(cos({SLOW}*T) - cos({QUICK}*T))"),
    "rate": (BETWEEN_WALLS, "velocity of x2 after T", f"a/2*({QUICK}*sin({QUICK}*T) - {SLOW}*sin({SLOW}*T))"),
    "side by side": (BETWEEN_WALLS, "time when d = 0", f"pi/(2*{QUICK})"),
    "place then": (BETWEEN_WALLS, "x1 when d = 0", f"a/2*cos(pi/2*{SLOW}/({QUICK}))"),
    # the mass centre goes on, and the distance oscillates with the reduced mass. Kleppner & Kolenkow, ch. 3
    "free": (FREE, "x1 at t = T", f"m1*v0/(m1 + m2)*T + m2*v0/(m1 + m2)*sin({REDUCED}*T)/({REDUCED})"),
    "closest": (FREE, "d when rate(d) = 0", f"l - v0/({REDUCED})"),
    "as long again": (FREE, "time when d = l", f"pi/({REDUCED})"),
    "handed on": (FREE, "velocity of x2 when d = l", "2*m1*v0/(m1 + m2)"),
    # two constant accelerations
    "overtakes": (RACE, "time when d = 0", "sqrt(2*l/(F1/m1 - F2/m2))"),
    "energy then": (RACE, "kinetic energy when d = 0", "l*(F1^2/m1 + F2^2/m2)/(F1/m1 - F2/m2)"),
}


@pytest.mark.parametrize("name", TOGETHER)
def test_linear_systems_are_integrated_together(name: str) -> None:
    is_formula(*TOGETHER[name], factors=(1.0, 1.02, 0.99))


def test_modes_are_told_where_coordinates_are_coupled() -> None:
    told = fb.explain(System.from_text(BETWEEN_WALLS + "questions: [x1 at t = T]\n")).to_text()
    assert "are coupled" in " ".join(told.split())


# -- laws of one freedom that are separable in the velocity -----------------------------------
ROAD = """
parameters:
  {{m: 300 kg, c: 40 kg/s, k: 12 kg/m, P: 4 kW, R: 200 N, u: 1 m/s, v0: {v0} m/s, v1: {v1} m/s, d: {d} m, T: 4 s}}
ground: {{lines: {{road: {{along: right}}}}}}
bodies: {{car: {{particle: {{mass: m}}}}}}
connections: {{guide: {{slider: [car, ground.road]}}}}
measures: {{x: x of car}}
loads: {{push: {{force: {{at: car, along: right, magnitude: "{law}"}}}}}}
start: {{x: 0, rate(x): v0}}
"""
POWER = ROAD.format(law="P/rate(x)", v0=5, v1=9, d=12)
BRAKED_POWER = ROAD.format(law="P/rate(x) - R", v0=5, v1=9, d=12)
SAIL = ROAD.format(law="-c*rate(x)*sqrt(rate(x)/u)", v0=6, v1=2, d=12)
CUBE = ROAD.format(law="-c*rate(x)^3/u^2", v0=6, v1=2, d=2)
BOTH = ROAD.format(law="-R - c*rate(x)", v0=6, v1=2, d=2)
ALL_THREE = ROAD.format(law="-R - c*rate(x) - k*rate(x)^2", v0=6, v1=2, d=2)
TWO = ROAD.format(law="-c*rate(x) - k*rate(x)^2", v0=6, v1=2, d=2)
BY_PLACE = ROAD.format(law="-k*x*rate(x)/s", v0=6, v1=2, d=2).replace("T: 4 s", "T: 4 s, s: 1 s")
D_3 = "sqrt(4*k*R - c^2)"
S_V = "sqrt(k*v0/(2*m*s))"

SEPARABLE = {
    # m u u' = P: u^2 grows with the time, u^3 with the way. Beer & Johnston, sec. 13.5; Meriam, sec. 3/6
    "power, rate": (POWER, "velocity of x at t = T", "sqrt(v0^2 + 2*P*T/m)"),
    "power, place": (POWER, "x at t = T", "m/(3*P)*((v0^2 + 2*P*T/m)^(3/2) - v0^3)"),
    "power, time to a rate": (POWER, "time when rate(x) = v1", "m*(v1^2 - v0^2)/(2*P)"),
    "power, way to a rate": (POWER, "x when rate(x) = v1", "m*(v1^3 - v0^3)/(3*P)"),
    "power, at a place": (POWER, "velocity of x when x = d", "(v0^3 + 3*P*d/m)^(1/3)"),
    # u' = (P/u - R)/m
    "power and resistance": (
        BRAKED_POWER,
        "time when rate(x) = v1",
        "-m/R*(v1 - v0) - m*P/R^2*log((P - R*v1)/(P - R*v0))",
    ),
    "power and resistance, way": (
        BRAKED_POWER,
        "x when rate(x) = v1",
        "-m/R*((v1^2 - v0^2)/2 + P/R*(v1 - v0) + P^2/R^2*log((P - R*v1)/(P - R*v0)))",
    ),
    # powers 3/2 and 3 of the rate. Meriam, problems of sec. 2/2
    "3/2, rate": (SAIL, "velocity of x at t = T", "1/(1/sqrt(v0) + c*T/(2*m*sqrt(u)))^2"),
    "3/2, at a place": (SAIL, "velocity of x when x = d", "(sqrt(v0) - c*d/(2*m*sqrt(u)))^2"),
    "3/2, way in the end": (SAIL, "x as t grows", "2*m/c*sqrt(u*v0)"),
    "3, rate": (CUBE, "velocity of x at t = T", "1/sqrt(1/v0^2 + 2*c*T/(m*u^2))"),
    "3, at a place": (CUBE, "velocity of x when x = d", "1/(1/v0 + c*d/(m*u^2))"),
    "3, time to a place": (CUBE, "time when x = d", "m*u^2/(2*c)*((1/v0 + c*d/(m*u^2))^2 - 1/v0^2)"),
    # dry and viscous, and both with a square. Timoshenko & Young, Advanced Dynamics, sec. 6
    "dry and viscous": (BOTH, "time when rate(x) = 0", "m/c*log(1 + c*v0/R)"),
    "two": (TWO, "time when rate(x) = v1", "m/c*log(v0*(c + k*v1)/(v1*(c + k*v0)))"),
    "two, way": (TWO, "x when rate(x) = v1", "m/k*log((c + k*v0)/(c + k*v1))"),
    "three": (ALL_THREE, "time when rate(x) = 0", f"2*m/{D_3}*(atan((2*k*v0 + c)/{D_3}) - atan(c/{D_3}))"),
    "three, way": (
        ALL_THREE,
        "x when rate(x) = 0",
        f"m/(2*k)*log(1 + (c*v0 + k*v0^2)/R) - c*m/(k*{D_3})*(atan((2*k*v0 + c)/{D_3}) - atan(c/{D_3}))",
    ),
    # a resistance with the way: m u' = -(k/s) x u
    "by place": (BY_PLACE, "velocity of x when x = d", "v0 - k*d^2/(2*m*s)"),
    "by place, in time": (BY_PLACE, "x at t = T", f"v0/({S_V})*tanh({S_V}*T)"),
    "by place, time": (BY_PLACE, "time when x = d", f"log((v0 + {S_V}*d)/(v0 - {S_V}*d))/(2*{S_V})"),
    "by place, in the end": (BY_PLACE, "x as t grows", "sqrt(2*m*s*v0/k)"),
}


@pytest.mark.parametrize("name", SEPARABLE)
def test_what_is_separable_in_the_velocity_is_integrated(name: str) -> None:
    is_formula(*SEPARABLE[name], factors=(1.0, 1.02, 0.99))


@pytest.mark.parametrize("text", [POWER, BRAKED_POWER, TWO, BY_PLACE], ids=range(4))
def test_separation_is_derived(text: str) -> None:
    question = "x when rate(x) = v1"
    told = " ".join(fb.explain(System.from_text(f"{text}questions: [{question}]\n")).to_text().split())
    assert "eparat" in told  # "separated", "separating the variables"


def test_a_limit_of_powers_is_written_as_a_root() -> None:
    found = posed(POWER, "velocity of x when x = d")
    assert "log" not in str(found.expression)


# -- how far it gets --------------------------------------------------------------------------
HUNG = """
parameters: {m: 1 kg, v0: 3 m/s, g: 9.81 m/s^2, k: 50 N/m, a: 0.1 m, c: 2 kg/s}
bodies: {load: {particle: {mass: m}}}
measures: {y: y of load, s: drop of load below ground.O}
loads: {weight: {gravity: g}, spring: {force: {at: load, along: up, magnitude: -k*y}}}
start: {y: a, rate(y): v0}
"""
LET_GO = HUNG.replace("rate(y): v0", "rate(y): 0")
BALL = HUNG.replace(", spring: {force: {at: load, along: up, magnitude: -k*y}}", "")
AIR = HUNG.replace("magnitude: -k*y", "magnitude: -c*rate(y)")
AMPLITUDE = "sqrt((a + m*g/k)^2 + m*v0^2/k)"

EXTENTS = {
    # m u^2/2 + k y^2/2 + m g y is kept. Meriam, sec. 3/7; Beer & Johnston, sec. 13.8
    "highest": (HUNG, "greatest y", f"{AMPLITUDE} - m*g/k"),
    "lowest": (HUNG, "least y", f"-{AMPLITUDE} - m*g/k"),
    "lowest by its drop": (HUNG, "maximum of s over the motion", f"{AMPLITUDE} + m*g/k"),
    "from rest": (LET_GO, "greatest y", "a"),
    "from rest, down": (LET_GO, "minimum of y", "-a - 2*m*g/k"),
    "thrown": (BALL, "highest y", "a + v0^2/(2*g)"),
    "turns": (BALL, "time when y turns back", "v0/g"),
    "pendulum": (STRUCK, "greatest theta", "acos(1 - L*w^2/(3*g))"),
    "pendulum, back": (STRUCK, "least theta", "-acos(1 - L*w^2/(3*g))"),
    "shot in": (SHOT_IN, "least r", "sqrt(b^2 - v0^2/w^2)"),
}


@pytest.mark.parametrize("name", EXTENTS)
def test_how_far_a_motion_gets(name: str) -> None:
    is_formula(*EXTENTS[name], factors=(1.0, 1.02, 0.99))


def test_a_turn_is_derived_and_never_claimed_where_none_comes() -> None:
    assert "the speed is zero" in fb.explain(System.from_text(STRUCK + "questions: [least theta]\n")).to_text()
    assert posed(BALL, "least y").expression is None
    assert posed(WHIRLED, "greatest theta").value is None


def test_a_cubic_spring_swings_with_a_period_by_its_amplitude() -> None:
    # u^2 = k (A^4 - x^4)/(2 m): T = 4 sqrt(m/k) K(1/sqrt(2))/A
    system = fb.System.from_text("""
parameters: {m: 0.5 kg, k: 40 N/m^3, A: 0.2 m}
bodies: {block: {particle: {mass: m}}}
connections: {rail: {slider: {body: block, along: right}}}
loads: {spring: {law: {measure: x, force: -k*x^3}}}
measures: {x: x of block}
start: {x: A, rate(x): 0}
""")
    expected = 4 * math.sqrt(0.5 / 40) * 1.8540746773013719 / 0.2
    assert system.solve("period of x").answers[0].value == pytest.approx(expected, rel=1e-9)
    turned = system.solve("value of A for which period of x = 2 s").answers[0].value
    assert turned == pytest.approx(0.2 * expected / 2, rel=1e-9)


def test_a_rough_rod_that_turns_flings_a_bead_by_a_linear_law() -> None:
    """N = 2 m w r', so r'' + 2 mu w r' = w^2 r: r = a e^(-mu w t) (cosh(k t) + mu w/k sinh(k t)), k^2 = w^2 (1 + mu^2).
    Meriam & Kraige, Dynamics, ch. 2 and 3."""
    rough = FLUNG.replace("on: rod}}", "on: rod, friction: 0.3}}")
    (answer,) = fb.solve(fb.System.from_text(rough + "questions: ['r at t = 0.4 s']\n")).answers
    w, mu, t = 3.0, 0.3, 0.4
    k = w * math.hypot(1.0, mu)
    wanted = 0.2 * math.exp(-mu * w * t) * (math.cosh(k * t) + mu * w / k * math.sinh(k * t))
    assert answer.expression is not None
    assert answer.value == pytest.approx(wanted, rel=1e-9)


# -- which turning place comes first ----------------------------------------------------------
BETWEEN = """
parameters: {m: 1 kg, c: 100 N/m^2, a: 0.5 m, b: 0.52 m}
bodies: {p: {particle: {mass: m}}}
connections: {s: {slider: {body: p, along: right}}}
loads: {f: {law: {measure: x, force: c*(3*x^2 - 2*(a + b)*x + a*b)}}}
measures: {x: x of p}
start: {x: 0, rate(x): 0}
"""
UPRIGHT_HOOP = """
space: {up: z}
parameters: {m: 0.3 kg, R: 0.4 m, W: 7 rad/s, g: 9.81 m/s^2, a: 70 deg}
bodies:
  frame: {body: {}, turned: [psi about z]}
  bead: {body: {mass: m}, points: {c: [0, 0, R]}, turned: [theta about y], frame: frame}
connections:
  shaft: {revolute: {first: ground.O, second: frame, about: z}}
  ring: {revolute: {first: frame, second: bead.c, about: y}}
  motor: {driver: {measure: psi, follows: W*t}}
loads: {weight: {gravity: g}}
start: {theta: a, rate(theta): 0}
"""
FUNNEL = """
space: {up: z}
parameters: {m: 0.1 kg, c: 1.5, r: 0.3 m, u: 3 m/s, g: 9.81 m/s^2}
bodies: {p: {particle: {mass: m}, near: {at: [r, 0, c*r]}}}
connections: {wall: {point_on_surface: {point: p, z: c*rho}}}
loads: {weight: {gravity: g}}
measures: {rho: distance of p from the z axis, phi: angle of line from ground.O to p}
start: {rho: r, phi: 0, rate(rho): 0, rate(phi): u/r}
"""


def test_another_turning_place_must_not_come_first() -> None:
    # m u^2/2 = c x (a - x) (b - x): it turns at the smaller of a and b
    found = posed(BETWEEN, "greatest x")
    assert found.expression == parse("a")
    assert "b > a" in fb.solve(System.from_text(BETWEEN + "questions: [greatest x]\n")).to_text()


def test_a_bead_on_a_fast_hoop_turns_back_before_the_bottom() -> None:
    # R u^2 = (cos(q) - cos(a)) (2 g - R W^2 (cos(q) + cos(a))); slower, it swings through to -a
    is_formula(UPRIGHT_HOOP, "least theta", "acos(2*g/(R*W^2) - cos(a))", factors=(1.0, 1.01))


def test_a_distance_from_an_axis_is_not_negative() -> None:
    # u^2 (r + q)/(2 q^2) = c g at the other end of the way in a funnel
    is_formula(FUNNEL, "greatest rho", "u*(u + sqrt(u^2 + 8*c*g*r))/(4*c*g)")
