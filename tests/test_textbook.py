"""Systems as textbooks ask for them, against answers derived by hand in the line beside them."""

from __future__ import annotations

import pytest

import freebody as fb
from conftest import Agree, assert_same_function
from freebody.language.expression import Expr
from freebody.language.notation import Stated, to_python

CART = """
parameters: {M: 2 kg, m: 1 kg, L: 1 m, th0: 60 deg, g: 9.81 m/s^2}
ground: {lines: {rail: {along: right}}}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}}}
connections: {guide: {slider: {body: cart, along: rail}}, rod: {link: [cart, bob, L]}}
loads: {weight: {gravity: g}}
measures: {x: x of cart, th: angle of line from cart to bob from down}
start: {x: 0, th: th0, rate(x): 0, rate(th): 0}
"""
FALLING_ROD = """
parameters: {m: 1 kg, L: 1 m, th0: 70 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {foot: {slot: {pin: rod.start, along: floor}}}
loads: {weight: {gravity: g}}
measures: {th: angle of rod, x: x of rod}
start: {th: th0, x: L/3, rate(th): 0, rate(x): 0}
"""
COLLISION = """
parameters: {m1: 2 kg, m2: 3 kg, v0: 5 m/s, e: 0.6, r: 0.1 m, d: 1 m}
ground: {lines: {l: {along: right}}}
bodies: {a: {disk: {mass: m1, radius: r}, at: [0, 0]}, b: {disk: {mass: m2, radius: r}, at: [d, 0]}}
connections:
  ga: {slider: {body: a, along: l}}
  gb: {slider: {body: b, along: l}}
  hit: {contact: {between: [a, b], restitution: e}}
measures: {x1: x of a, x2: x of b}
start: {x1: 0, x2: d, rate(x1): v0, rate(x2): 0}
"""
STRUCK_ROD = """
parameters: {M: 2 kg, L: 1 m, m: 0.02 kg, v0: 300 m/s, h: 0.8 m}
bodies:
  rod: {rod: {mass: M, length: L}, angle: -90 deg}
  bullet: {particle: {mass: m}, at: [-0.1 m, -h], velocity: [v0, 0]}
connections: {hinge: {pin: [ground.O, rod.start]}}
measures: {th: angle of rod from down}
"""


def expression(model: str, question: str) -> str:
    (answer,) = fb.solve(fb.System.from_text(model), question).answers
    assert isinstance(answer.expression, Expr), answer.reason
    return to_python(answer.expression)


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # M x + m (x + L sin th) stays: the mass centre does not move aside
        (CART, "x when th = 0", "m*L*sin(th0)/(M + m)"),
        (CART, "x of bob when th = 0", "m*L*sin(th0)/(M + m)"),
        # no force acts aside, so x stays; the foot is half a length from it
        (FALLING_ROD, "x of rod.start when th = 0", "L/3 - L/2"),
        # after the impact a goes on with v0 (m1 - e m2)/(m1 + m2) over the last 2 r
        (COLLISION, "time when x1 = d", "(d - 2*r)/v0 + 2*r*(m1 + m2)/(v0*(m1 - m2*e))"),
    ],
)
def test_what_textbooks_ask_for(model: str, question: str, expected: str) -> None:
    assert_same_function(expression(model, question), expected, {})


PENDULUM_ON_A_TORSION_SPRING = """
parameters: {m: 1 kg, L: 0.5 m, kt: 8 N m, g: 9.81 m/s^2}
bodies: {b: {body: {mass: m, center_of_mass: [0, L]}}}
connections: {h: {pin: [ground.O, b.origin]}}
loads: {w: {gravity: g}, s: {torsional_spring: {body: b, stiffness: kt}}}
measures: {th: angle of b}
start: {th: 0}
"""
RING_ON_A_NAIL = """
parameters: {m: 1 kg, R: 0.3 m, g: 9.81 m/s^2}
bodies: {ring: {ring: {mass: m, radius: R}, points: {N: [0, R]}}}
connections: {nail: {pin: [ground.O, ring.N]}}
loads: {w: {gravity: g}}
measures: {th: angle of ring}
start: {th: 0}
"""
HALF_CYLINDER = """
parameters: {m: 4 kg, R: 0.2 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  half: {body: {mass: m, inertia: m*R^2/2 - m*(4*R/(3*pi))^2, center_of_mass: [0, -4*R/(3*pi)], radius: R}}
connections: {roll: {rolling: {body: half, on: floor}}}
loads: {w: {gravity: g}}
measures: {phi: angle of half}
start: {phi: 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        (RING_ON_A_NAIL, "natural frequencies", "sqrt(g/(2*R))"),
        # kt > m g L under the root, so it may be divided by
        (PENDULUM_ON_A_TORSION_SPRING, "period of small oscillations", "2*L*pi*sqrt(m/(kt - m*L*g))"),
        # 9 pi > 16
        (HALF_CYLINDER, "natural frequencies", "2*sqrt(2*g/(R*(9*pi - 16)))"),
        # what is divided by is positive, and stays so
        (HALF_CYLINDER, "acceleration of phi", "-8*sin(phi)*(R*rate(phi)**2 + g)/(R*(9*pi - 16*cos(phi)))"),
    ],
)
def test_formulas_have_the_form_of_tables(model: str, question: str, expected: str) -> None:
    assert expression(model, question) == expected


def test_a_velocity_that_is_given_is_no_assumption_where_another_is_left_open() -> None:
    assumptions = fb.solve(fb.System.from_text(STRUCK_ROD), "acceleration of th at start").assumptions
    assert not any("bullet" in text for text in assumptions)


def test_links_of_a_tripod_have_their_lengths_at_the_start() -> None:
    """W = 3 T h/l with l^2 = a^2 + h^2: places that are given in space give the lengths of links."""
    solution = fb.System.from_text(
        """
space: true
parameters: {a: 1 m, h: 2 m, W: 300 N}
ground: {points: {A: [a, 0, 0], B: [-a/2, 0, a*sqrt(3)/2], C: [-a/2, 0, -a*sqrt(3)/2]}}
bodies: {p: {particle: {}, at: [0, h, 0]}}
connections: {A: {link: [ground.A, p]}, B: {link: [ground.B, p]}, C: {link: [ground.C, p]}}
loads: {W: {force: {at: p, along: down, magnitude: W}}}
questions: [tension of A]
"""
    ).solve()
    assert solution.assumptions == ()
    assert to_python(solution["q1"].expression) == "-W*sqrt(a**2 + h**2)/(3*h)"


def test_what_depends_on_each_other_is_named_whole_and_a_roller_is_told_from_a_slider() -> None:
    beam = """
parameters: {L: 2 m, P: 100 N}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L}, angle: 0}}
connections: {A: {pin: [ground.A, beam.start]}, SUPPORTS}
loads: {P: {force: {at: beam, along: down, magnitude: P}}}
"""
    three = "B: {slot: {pin: beam.end, along: right}}, C: {slot: {pin: beam.center, along: right}}"
    slider = "B: {slider: {body: beam, along: right, through: ground.B}}"
    reasons: list[str] = []
    for supports in (three, slider):
        system = fb.System.from_text(beam.replace("SUPPORTS", supports))
        (answer,) = fb.solve(system, "vertical reaction of A on beam").answers
        reasons.append(answer.reason or "")
    assert "A.y, B.normal, C.normal" in reasons[0]
    assert "roller" not in reasons[0]
    assert "A.y, B.angle, B.normal" in reasons[1]
    assert "a roller is a slot" in reasons[1]


LADDER = """
parameters: {m: 10 kg, M: 80 kg, L: 5 m, s: 3 m, alpha: 60 deg, mu: 0.4, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up, through: [0, 0]}}}
bodies:
  ladder: {rod: {mass: m, length: L}, angle: alpha, points: {S: [s - L/2, 0]}}
  man: {particle: {mass: M}}
connections:
  floor: {contact: {between: [ladder.start, floor], friction: mu}}
  wall: {contact: {between: [ladder.end, wall]}}
  on: {pin: [ladder.S, man]}
loads: {weight: {gravity: g}}
"""


def test_a_largest_value_is_one_that_exists() -> None:
    """Moments about the foot: L tan(alpha) N_w = m g L/2 + M g s, with N_w <= mu (m + M) g; with less friction than an
    empty ladder needs no s is small enough."""
    (answer,) = fb.solve(fb.System.from_text(LADDER), "largest s so that it stays at rest").answers
    limit = "L*(2*mu*(m + M)*tan(alpha) - m)/(2*M)"
    assert isinstance(answer.expression, Expr)
    assert_same_function(to_python(answer.expression), limit, {})
    (condition,) = answer.conditions
    assert isinstance(condition, Stated)
    left, right = condition.expression.split(" >= ")
    assert_same_function(f"({left}) - ({right})", "2*mu*(m + M)*sin(alpha) - m*cos(alpha)", {})


def test_a_contact_that_would_have_to_pull_is_compared_as_it_is_written() -> None:
    """Far below the friction that holds, poses of sliding are compared in which the floor would have to pull."""
    (answer,) = fb.solve(fb.System.from_text(LADDER), "normal force of wall").answers
    assert isinstance(answer.expression, Expr), answer.reason
    assert_same_function(to_python(answer.expression), "g*(m*L/2 + M*s)/(L*tan(alpha))", {})


def test_a_block_that_is_put_upon_another_slides_on_it_there(agrees: Agree) -> None:
    """Both are put at places: the guide between them is where these say, and turns neither of them."""
    solution = fb.System.from_text("""
parameters: {m1: 2 kg, m2: 5 kg, F: 40 N, mu: 0.4, g: 9.81 m/s^2}
bodies:
  upper: {rectangle: {mass: m1, width: 0.4 m, height: 0.2 m}, at: [0, 0.5 m]}
  lower: {rectangle: {mass: m2, width: 1 m, height: 0.4 m}, at: [0, 0.2 m]}
connections:
  floor: {slider: {body: lower, along: right}}
  between: {slider: {body: upper, on: lower, along: right, friction: mu}}
loads:
  weight: {gravity: g}
  pull: {force: {at: lower, along: right, magnitude: F}}
questions: [acceleration of upper, acceleration of lower, normal force of between]
""").solve()
    agrees(solution, "q1", ["mu*g", "0"])
    agrees(solution, "q2", ["(F - mu*m1*g)/m2", "0"])
    agrees(solution, "q3", "m1*g")
    start = solution.system.simulate(0.01).dataset.isel(time=0)
    assert start.body_angle.values == pytest.approx([0.0, 0.0], abs=1e-15)
    assert start.body_position.sel(axis="y").values == pytest.approx([0.5, 0.2])


MOLECULE = """
parameters: {m1: 1 kg, m2: 2 kg, k: 300 N/m, l: 1 m}
bodies: {a: {particle: {mass: m1}, at: [0, 0]}, b: {particle: {mass: m2}, at: [l, 0]}}
connections: {ra: {slider: {body: a, along: right}}, rb: {slider: {body: b, along: right}}}
loads: {s: {spring: {first: a, second: b, stiffness: k, length: l}}}
"""
ROD_WITH_WHEEL = """
parameters: {M: 3 kg, m: 2 kg, L: 1.2 m, R: 0.2 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: M, length: L}}, disk: {disk: {mass: m, radius: R}}}
connections: {hinge: {pin: [ground.O, rod.start]}, axle: {pin: [rod.end, disk.center]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod from right clockwise}}
start: {phi: 0}
"""


@pytest.mark.parametrize(
    ("model", "frequency"),
    [
        (MOLECULE, "sqrt(k*(m1 + m2)/(m1*m2))"),
        # the wheel does not turn: I = M L^2/3 + m L^2 about the hinge, and M g L/2 + m g L drives back
        (ROD_WITH_WHEEL, "sqrt((M/2 + m)*g/((M/3 + m)*L))"),
    ],
)
def test_what_swings_has_its_period_beside_what_nothing_drives_back(model: str, frequency: str, agrees: Agree) -> None:
    questions = "questions: [period of small oscillations, natural frequency, natural frequencies]"
    solution = fb.System.from_text(model + questions).solve()
    agrees(solution, "q1", f"2*pi/{frequency}")
    agrees(solution, "q2", frequency)
    agrees(solution, "q3", ["0", frequency])
    assert solution.system.explain().is_complete


def test_a_spring_without_stiffness_at_rest_has_no_small_oscillations_but_is_not_said_to_rest() -> None:
    """-k u^3 drives back, though not to first order: it does oscillate, with a period that its size decides."""
    cubic = """
parameters: {m: 1 kg, M: 2 kg, k: 3 N/m^3, c: 5 N/m}
bodies: {p: {particle: {mass: m}, at: [0, 0]}, q: {particle: {mass: M}, at: [0, 1 m]}}
connections: {r: {slider: {body: p, along: right}}, s: {slider: {body: q, along: right}}}
measures: {u: x of p, w: x of q}
start: {u: 0, w: 0}
loads: {f: {law: {measure: u, force: -k*u^3}}, h: {law: {measure: w, force: WEAK}}}
questions: [period of small oscillations]
"""
    (beside,) = fb.System.from_text(cubic.replace("WEAK", "-c*w")).solve().answers
    assert any("to first order" in note for note in beside.notes)
    (alone,) = fb.System.from_text(cubic.replace("WEAK", "-k*w^3")).solve().answers
    assert "to first order nothing drives it back" in (alone.reason or "")
    assert "not oscillate" not in (alone.reason or "")


def test_what_nothing_drives_back_has_no_period() -> None:
    free = MOLECULE.replace("loads: {s: {spring: {first: a, second: b, stiffness: k, length: l}}}", "")
    (answer,) = fb.solve(fb.System.from_text(free), "period of small oscillations").answers
    assert answer.expression is None
    assert "nothing drives it back" in (answer.reason or "")


LONE_LAW = """
parameters: {m: 2 kg, k: 50 N/m, c: 3 N s/m, F0: 4 N, Om: 5 rad/s}
bodies: {b: {particle: {mass: m}}}
connections: {g: {slider: {body: b, along: right}}}
loads: {l: {law: {measure: x, force: LAW}}}
measures: {x: x of b}
start: {x: 0.1 m}
"""


@pytest.mark.parametrize(
    ("law", "condition"),
    [
        ("-k*x - c*rate(x)", "if and only if c = 0"),
        ("-(k*x + c*rate(x))", "if and only if c = 0"),
        ("F0*sin(Om*t) - k*x", "if and only if F₀ = 0"),
    ],
)
def test_a_law_that_is_spring_and_damper_in_one_keeps_the_energy_of_the_spring(law: str, condition: str) -> None:
    """E = m x'^2/2 + k x^2/2 whatever else acts, and E' is the power of the rest: -c x'^2, or F0 sin(Om t) x'."""
    system = fb.System.from_text(LONE_LAW.replace("LAW", law))
    energy, kept, force = (
        fb.solve(system, question).answers[0]
        for question in ("total energy", "is total energy conserved", "force of l")
    )
    assert isinstance(energy.expression, Expr)
    assert_same_function(to_python(energy.expression).replace("rate(x)", "v"), "m*v**2/2 + k*x**2/2", {})
    assert condition in str(kept.conditions)
    assert isinstance(force.expression, Expr)
    shown, written = (text.replace("rate(x)", "v") for text in (to_python(force.expression), law))
    assert_same_function(shown, written, {})


TWO_CARTS_STRUCK = """
parameters: {m1: 2 kg, m2: 3 kg, k: 600 N/m, J: 10 N s, l0: 0.5 m}
bodies: {a: {particle: {mass: m1}}, b: {particle: {mass: m2}}}
connections: {ga: {slider: {body: a, along: right}}, gb: {slider: {body: b, along: right}}}
loads:
  s: {spring: {first: a, second: b, stiffness: k, length: l0}}
  hit: {impulse: {at: b, along: right, magnitude: J}}
measures: {x1: x of a, x2: x of b}
start: {x1: 0, x2: l0, rate(x1): 0, rate(x2): 0}
"""
THREE_SPRINGS = """
parameters: {m: 2 kg, k: 50 N/m, c: 30 N/m, a: 0.1 m, b: 0.3 m}
bodies: {p: {particle: {mass: m}}, q: {particle: {mass: m}}}
connections: {g1: {slider: {body: p, along: right}}, g2: {slider: {body: q, along: right}}}
loads:
  l1: {law: {measure: x, force: -k*x}}
  l2: {law: {measure: y, force: -k*y}}
  l3: {law: {measure: u, force: -c*u}}
measures: {x: x of p, y: x of q, u: {expression: y - x}}
start: {x: a, y: b, rate(x): 0, rate(y): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # common motion J/(m1 + m2), and the swing of the spring with the reduced mass on top of it
        (TWO_CARTS_STRUCK, "greatest velocity of x1", "2*J/(m1 + m2)"),
        (TWO_CARTS_STRUCK, "least velocity of x2", "J*(m2 - m1)/(m2*(m1 + m2))"),
        # k s^2/2 = m1 m2/(m1 + m2) (J/m2)^2/2
        (TWO_CARTS_STRUCK, "greatest force in s", "J*sqrt(k*m1/(m2*(m1 + m2)))"),
        # one of the modes alone
        (THREE_SPRINGS, "greatest velocity of u", "sqrt((b - a)**2*(k + 2*c)/m)"),
        (THREE_SPRINGS.replace("y: b,", "y: a,"), "greatest velocity of x", "a*sqrt(k/m)"),
        (THREE_SPRINGS.replace("y: b,", "y: -a,"), "greatest x", "a"),
    ],
)
def test_extremes_of_what_one_mode_swings(model: str, question: str, expected: str) -> None:
    assert_same_function(expression(model, question), expected, {"b": 2.0})


def test_two_modes_need_not_meet_and_the_first_turns_are_not_taken_for_the_farthest() -> None:
    """x = 0.2 cos(5 t) - 0.1 cos(7.4 t) comes near 0.3 and has first turned at 0.102."""
    (answer,) = fb.solve(fb.System.from_text(THREE_SPRINGS), "greatest x").answers
    assert answer.expression is None
    assert answer.value is None
    assert "2 modes" in str(answer.reason)


BOB_IN_X_AND_Y = """
parameters: {m: 0.5 kg, L: 1.2 m, v0: V0 m/s, h: 0.5 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {w: {gravity: g}}
measures: {x: x of bob, y: y of bob}
start: {x: 0, y: -L, rate(x): v0}
"""


@pytest.mark.parametrize(
    ("v0", "question", "expected"),
    [
        (5, "tension of rod at start", "m*g + m*v0**2/L"),
        # m (v^2/L + g cos) with v^2 = v0^2 - 2 g (L - h), cos = h/L
        (5, "tension of rod when y = -h", "m*(v0**2 - 2*g*L + 3*g*h)/L"),
        (4, "greatest y", "v0**2/(2*g) - L"),
        # it turns below the pivot where cos = 1 - v0^2/(2 g L), or passes beside it
        (4, "greatest x", "v0*sqrt(4*g*L - v0**2)/(2*g)"),
        (5, "greatest x", "L"),
    ],
)
def test_a_bob_that_is_given_by_its_place(v0: int, question: str, expected: str) -> None:
    near = {"L": 1.2, "v0": float(v0), "g": 9.81, "h": 0.5}
    assert_same_function(expression(BOB_IN_X_AND_Y.replace("V0", str(v0)), question), expected, near)
