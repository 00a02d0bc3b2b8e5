"""Problems of the families of textbooks of dynamics, in words and numbers of their own, and formulas derived by hand:
in the line beside each stands its family, and from what the formula follows."""

from __future__ import annotations

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.language.expression import Expr
from freebody.language.notation import to_python

ROLLER_ON_A_ROPE = """
parameters: {M: 8 kg, m: 5 kg, R: 0.2 m, r: 0.05 m, D: 3 m, al: 20 deg, g: 9.81 m/s^2}
ground: {points: {K: [D*cos(al) - (2*R - r)*sin(al), D*sin(al) + (2*R - r)*cos(al)]}, lines: {slope: {along: al}}}
bodies:
  roller: {disk: {mass: M, radius: R}, near: {at: [-R*sin(al), R*cos(al)]}}
  wheel: {disk: {radius: r}}
  load: {particle: {mass: m}}
connections:
  roll: {rolling: {body: roller, on: slope}}
  axle: {pin: [ground.K, wheel]}
  rope: {string: {path: [wound on roller at top, over wheel, load]}}
loads: {weight: {gravity: g}}
measures: {s: travel of roller along al}
start: {s: 0, rate(s): 0}
"""
BARS_FOLD = """
parameters: {m: 4 kg, L: 0.6 m, th0: 50 deg, th1: 20 deg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}, lines: {rail: {along: right}}}
bodies:
  one: {rod: {mass: m, length: L}, near: {angle: th0}}
  two: {rod: {mass: m, length: L}, near: {at: [0.6 m, 0.2 m], angle: -th0}}
connections:
  O: {pin: [ground.O, one.start]}
  K: {pin: [one.end, two.start]}
  B: {slot: {pin: two.end, along: rail}}
loads: {weight: {gravity: g}}
measures: {th: angle of one}
start: {th: th0, rate(th): 0}
"""
PLATE_IN_GUIDES = """
parameters: {m: 7 kg, a: 0.5 m, th0: 60 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up}}}
bodies: {plate: {rectangle: {mass: m, width: a, height: a}, near: {at: [a/2, a/2], angle: -th0}}}
connections:
  A: {slot: {pin: plate.bottom_left, along: wall}}
  B: {slot: {pin: plate.bottom_right, along: floor}}
loads: {weight: {gravity: g}}
measures: {th: angle of plate clockwise}
start: {th: th0, rate(th): 0}
"""
BARS_STRUCK = """
parameters: {m: 2 kg, L: 0.5 m, b: 0.4 m, J: 6 N s}
bodies:
  up: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: -90 deg}
  low: {rod: {mass: m, length: L}, at: {start: [0, -L]}, angle: -90 deg, points: {S: [b - L/2, 0]}}
connections: {O: {pin: [ground.O, up.start]}, P: {pin: [up.end, low.start]}}
loads: {blow: {impulse: {at: low.S, along: right, magnitude: J}}}
"""
BAR_STRUCK_BY_PUCK = """
parameters: {m: 0.4 kg, M: 2 kg, L: 1 m, b: 0.3 m, v: 5 m/s, e: 0.8, r: 3 cm}
bodies:
  bar: {rod: {mass: M, length: L}, at: [0, 0], angle: 90 deg, velocity: [0, 0], angular_velocity: 0}
  puck: {disk: {mass: m, radius: r}, at: [-0.5 m, b], velocity: [v, 0], angular_velocity: 0}
connections: {hit: {contact: {between: [puck, bar], restitution: e}}}
"""
BOBS_STICK = """
parameters: {m1: 2 kg, m2: 3 kg, l: 1.5 m, ph0: 60 deg, g: 9.81 m/s^2}
bodies: {a: {particle: {mass: m1}}, b: {particle: {mass: m2}, at: [0, -l], velocity: [0, 0]}}
connections:
  ra: {link: [ground.O, a, l]}
  rb: {link: [ground.O, b, l]}
  clay: {weld: [a, b], closes: when phi = 0}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.O to a from down}
start: {phi: -ph0, rate(phi): 0}
"""
BALL_STRUCK_LOW = """
parameters: {m: 0.2 kg, R: 3 cm, h: 0.6 cm, J: 0.4 N s, mu: 0.2, g: 9.81 m/s^2}
ground: {lines: {cloth: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: R}, at: [0, R], velocity: [0, 0], angular_velocity: 0, points: {Q: [0, h]}}}
connections: {cloth: {contact: {between: [ball, cloth], friction: mu}}}
loads: {weight: {gravity: g}, cue: {impulse: {at: ball.Q, along: right, magnitude: J}}}
measures: {x: x of ball}
"""
PARCEL_ON_A_BELT = """
parameters: {m: 8 kg, al: 15 deg, mu: 0.6, v: 1.5 m/s, g: 9.81 m/s^2}
bodies:
  belt: {body: {mass: 50 kg, inertia: 1 kg m^2}, at: [0, 0], angle: al, lines: {face: {along: right}}}
  parcel: {particle: {mass: m}, at: [0, 0], velocity: [0, 0]}
connections:
  run: {slider: {body: belt, along: al}}
  drive: {driver: {measure: u, follows: v*t}}
  c: {contact: {between: [parcel, belt.face], friction: mu}}
loads: {weight: {gravity: g}}
measures: {u: travel of belt along al, s: travel of parcel along al}
"""
ROLLER_HELD_BY_A_ROPE = """
parameters: {m: 20 kg, R: 0.3 m, al: 25 deg, mu: 0.4, D: 2 m, g: 9.81 m/s^2}
ground: {points: {W: [D*cos(al) - 2*R*sin(al), D*sin(al) + 2*R*cos(al)]}, lines: {slope: {along: al}}}
bodies: {roller: {disk: {mass: m, radius: R}, at: [-R*sin(al), R*cos(al)], points: {T: [-R*sin(al), R*cos(al)]}}}
connections:
  c: {contact: {between: [roller, slope], friction: mu}}
  rope: {string: {from: ground.W, to: roller.T}}
loads: {weight: {gravity: g}}
"""
BEAD_ON_A_HOOP = """
parameters: {m: 0.5 kg, R: 0.4 m, k: 40 N/m, l0: 0.5 m, g: 9.81 m/s^2}
ground: {points: {C: [0, 0], T: [0, R]}}
bodies: {bead: {particle: {mass: m}}}
connections: {hoop: {link: [ground.C, bead, R]}}
loads: {weight: {gravity: g}, s: {spring: {first: ground.T, second: bead, stiffness: k, length: l0}}}
measures: {th: angle of line from ground.C to bead from down}
start: {th: 80 deg, rate(th): 0}
"""
BALL_IN_A_TUBE = """
parameters: {m: 0.6 kg, I: 0.2 kg m^2, r0: 0.1 m, L: 0.8 m, w0: 8 rad/s}
bodies:
  tube: {body: {inertia: I}}
  ball: {particle: {mass: m}}
connections: {O: {pin: [ground.O, tube]}, bore: {slot: {pin: ball, along: tube.x, on: tube}}}
measures: {th: angle of tube, r: travel of ball along tube.x}
start: {th: 0, rate(th): w0, r: r0, rate(r): 0}
"""
PUCK_ON_A_CORD = """
parameters: {m: 0.5 kg, k: 30 N/m, r0: 0.4 m, v0: 3 m/s, r1: 0.5 m}
bodies: {puck: {particle: {mass: m}}}
loads: {s: {spring: {first: ground.O, second: puck, stiffness: k, length: r0}}}
measures: {r: distance from ground.O to puck, th: angle of line from ground.O to puck}
start: {r: r0, th: 0, rate(r): 0, rate(th): v0/r0}
"""
WAGONS = """
parameters: {m: 20000 kg, v: 3 m/s, d: 5 m}
bodies:
  a: {particle: {mass: m}, at: [0, 0], velocity: [v, 0]}
  b: {particle: {mass: m}, at: [d, 0], velocity: [0, 0]}
  c: {particle: {mass: m}, at: [2*d, 0], velocity: [0, 0]}
connections:
  ra: {slider: {body: a, along: right}}
  rb: {slider: {body: b, along: right}}
  rc: {slider: {body: c, along: right}}
  k1: {weld: [a, b], closes: when xa = d}
  k2: {weld: [b, c], closes: when xb = 2*d}
measures: {xa: x of a, xb: x of b}
"""
CHAIN_ON_A_SLOPE = """
parameters: {m: 6 kg, L: 2 m, a: 1.2 m, al: 25 deg, g: 9.81 m/s^2}
ground: {points: {edge: [0, 0]}}
bodies: {chain: {rope: {mass: m, length: L}}}
connections: {run: {heavy_rope: {rope: chain, over: [ground.edge], leads: [al, down]}}}
loads: {weight: {gravity: g}}
measures: {s: drop of chain}
start: {s: a, rate(s): 0}
"""

PROBLEMS: dict[str, tuple[str, dict[str, str]]] = {
    # Beer & Johnston, ch. 16: the rope at the top goes twice as fast as the centre; T = m (g - 2 a)
    "roller on a rope": (
        ROLLER_ON_A_ROPE,
        {
            "acceleration of s at start": "g*(2*m - M*sin(al))/(3*M/2 + 4*m)",
            "tension of rope at load": "m*g - 2*m*g*(2*m - M*sin(al))/(3*M/2 + 4*m)",
            "friction force of roll": "g*(M + 2*m)*(2*m - M*sin(al))/(3*M/2 + 4*m) + M*g*sin(al) - m*g",
            "least m so that acceleration of s >= 0": "M*sin(al)/2",
        },
    ),
    # Meriam & Kraige, ch. 6: T = m L^2 w^2 (1/3 + sin^2 th), V = m g L sin th; N by the moment about K
    "bars fold": (
        BARS_FOLD,
        {
            "acceleration of th at start": "-g*cos(th0)/(2*L*(1/3 + sin(th0)**2))",
            "velocity of th when th = th1": "-sqrt(g*(sin(th0) - sin(th1))/(L*(1/3 + sin(th1)**2)))",
            "normal force of B at start": "m*g*(12*sin(th0)**2 + 1)/(4*(3*sin(th0)**2 + 1))",
        },
    ),
    # Hibbeler, ch. 17: G = a (sin th + cos th)/2 in x and in y, so that the plate may be driven up the wall
    "plate in guides": (
        PLATE_IN_GUIDES,
        {
            "acceleration of th at start": "3*g*(sin(th0) - cos(th0))/(a*(4 - 3*sin(2*th0)))",
            "velocity of th when th = 90 deg": "sqrt(3*g/(2*a)*(sin(th0) + cos(th0) - 1))",
        },
    ),
    # Beer & Johnston, ch. 17: 4/3 w1 + w2/2 = j, w1/2 + w2/3 = j b/L with j = J/(m L)
    "bars struck": (
        BARS_STRUCK,
        {
            "angular velocity of low after the blow": "J/(m*L)*(4*b/(3*L) - 1/2)*36/7",
            "horizontal impulse of P on low": "J*(36/7*(1/3 - b/(2*L) + 2*b/(3*L) - 1/4) - 1)",
            "value of b for which impulse of O along right = 0": "2*L/3",
        },
    ),
    # Gross, Hauger et al., Technische Mechanik 3, ch. 3: J = (1 + e) v/(1/m + 1/M + 12 b^2/(M L^2))
    "bar struck by puck": (
        BAR_STRUCK_BY_PUCK,
        {
            "angular velocity of bar after the impact": "-(1 + e)*v*12*b/(M*L**2)/(1/m + 1/M + 12*b**2/(M*L**2))",
            "velocity of puck along right after the impact": "v - (1 + e)*v/m/(1/m + 1/M + 12*b**2/(M*L**2))",
            "energy lost in the impact": "(1 - e**2)*v**2/2/(1/m + 1/M + 12*b**2/(M*L**2))",
            "value of b for which velocity of puck along right after the impact = 0": "L*sqrt((e*M - m)/(12*m))",
        },
    ),
    # Hibbeler, ch. 15: momentum in the impact, energy before and after it
    "bobs stick": (
        BOBS_STICK,
        {
            "energy lost in the blow": "m1*m2/(m1 + m2)*g*l*(1 - cos(ph0))",
            "greatest phi": "acos(1 - (m1/(m1 + m2))**2*(1 - cos(ph0)))",
        },
    ),
    # Gross, Hauger et al., Technische Mechanik 3, ch. 3: v = J/m, R w = 5 J h/(2 m R); 2/7 of the slip is lost to v
    "ball struck low": (
        BALL_STRUCK_LOW,
        {
            "velocity of x when rolling begins": "5*J/(7*m)*(1 + h/R)",
            "time when rolling begins": "2*J/(7*m*mu*g)*(1 - 5*h/(2*R))",
            "value of h for which rolling begins at once": "2*R/5",
            "value of h for which ball rolls without slipping": "2*R/5",
            "energy lost until rolling begins": "m/7*(J/m)**2*(1 - 5*h/(2*R))**2",
        },
    ),
    # Meriam & Kraige, ch. 3: v = g (mu cos al - sin al) t
    "parcel on a belt": (
        PARCEL_ON_A_BELT,
        {
            "time when slipping ends": "v/(g*(mu*cos(al) - sin(al)))",
            "s when slipping ends": "v**2/(2*g*(mu*cos(al) - sin(al)))",
            "energy lost until slipping ends": "mu*m*cos(al)*v**2/(2*(mu*cos(al) - sin(al)))",
            "range of mu for which slipping ends": "tan(al)",
        },
    ),
    # Beer & Johnston, Statics, ch. 8: moments about the middle, T = F, and along the slope T + F = m g sin al
    "roller held by a rope": (
        ROLLER_HELD_BY_A_ROPE,
        {
            "least mu so that it stays at rest": "tan(al)/2",
            "largest al so that it stays at rest": "atan(2*mu)",
            "tension of rope": "m*g*sin(al)/2",
        },
    ),
    # Goldstein, ch. 1 and 6: m g cos(th/2) = k (R cos(th/2) - l0/2), or th = 0
    "bead on a hoop": (
        BEAD_ON_A_HOOP,
        {
            "equilibrium of th": "2*acos(k*l0/(2*(k*R - m*g)))",
        },
    ),
    # Beer & Johnston, ch. 17: (I + m r^2) w stays, and the energy
    "ball in a tube": (
        BALL_IN_A_TUBE,
        {
            "velocity of th when r = L": "w0*(I + m*r0**2)/(I + m*L**2)",
            "velocity of r when r = L": "w0*sqrt((I + m*r0**2)*(L**2 - r0**2)/(I + m*L**2))",
            "normal force of bore when r = L": "2*m*I*w0**2*sqrt((I + m*r0**2)**3*(L**2 - r0**2)/(I + m*L**2)**5)",
        },
    ),
    # Meriam & Kraige, ch. 3: r v stays; at the turn m v0^2 (1 - r0^2/r^2) = k (r - r0)^2
    "puck on a cord": (
        PUCK_ON_A_CORD,
        {
            "velocity of r when r = r1": "sqrt(v0**2*(1 - r0**2/r1**2) - k/m*(r1 - r0)**2)",
            "value of v0 for which greatest r = 2*r0": "2*r0*sqrt(k/(3*m))",
            "value of k for which greatest r = 2*r0": "3*m*v0**2/(4*r0**2)",
        },
    ),
    # Hibbeler, ch. 15: v, v/2, v/3
    "wagons": (
        WAGONS,
        {
            "velocity of xa after the blow of k2": "v/3",
            "energy lost in the blow of k2": "m*v**2/12",
            "energy lost in the blow of k1": "m*v**2/4",
            "impulse of k1 on b along right": "m*v/2",
        },
    ),
    # Meriam & Kraige, ch. 4: of s hang, of L - s lie on the slope: s'' = g/L (s - (L - s) sin al)
    "chain on a slope": (
        CHAIN_ON_A_SLOPE,
        {
            "velocity of s when s = L": "sqrt(g/L*(L**2 - a**2 - sin(al)*(L - a)**2))",
            "equilibrium of s": "L*sin(al)/(1 + sin(al))",
            "tension of run at edge at start": "m/L*a*(g - g/L*(a - (L - a)*sin(al)))",
        },
    ),
}


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [(model, question, f) for model, asked in PROBLEMS.values() for question, f in asked.items()],
    ids=[f"{name}: {question}" for name, (_model, asked) in PROBLEMS.items() for question in asked],
)
def test_problems_of_textbooks_come_out_in_closed_form(model: str, question: str, expected: str) -> None:
    system = fb.System.from_text(model)
    (answer,) = fb.solve(system, question).answers
    assert isinstance(answer.expression, Expr), answer.reason
    near = {p.name: p.value for p in system.parameters.values() if p.value}
    assert_same_function(to_python(answer.expression), expected, near)


def test_a_wound_string_runs_to_where_its_other_end_is_said_to_be_or_asks_for_its_sense() -> None:
    """At the top it comes off to the left or the right: as long as no place tells, nothing is taken for granted. Held
    by a wall at its top the spool has 2 R T = R F."""
    spool = """
parameters: {m: 2 kg, R: 0.2 m, F: 5 N}
ground: {points: {W: PLACE}, lines: {floor: {along: right}}}
bodies: {spool: {disk: {mass: m, radius: R}}}
connections:
  roll: {rolling: {body: spool, on: floor}}
  cord: {string: {path: [wound on spool at top, ground.W]}}
loads: {pull: {force: {at: spool, along: SENSE, magnitude: F}}}
"""
    with pytest.raises(fb.ModelError, match="either hand"):
        fb.System.from_text(spool.replace("PLACE", "[0, 3 m]").replace("SENSE", "left"))
    for x, sense in (("3 m", "left"), ("-3 m", "right")):
        system = fb.System.from_text(spool.replace("PLACE", f"[{x}, 2*R]").replace("SENSE", sense))
        (tension,) = fb.solve(system, "tension of cord").answers
        assert isinstance(tension.expression, Expr), tension.reason
        assert_same_function(to_python(tension.expression), "F/2", {})


def test_where_a_motion_turns_without_a_formula_it_is_not_said_to_go_on_without_end() -> None:
    """Where m v0^2 (r + r0) = k r^2 (r - r0) is a cubic."""
    (answer,) = fb.solve(fb.System.from_text(PUCK_ON_A_CORD), "greatest r").answers
    assert "no closed form" in (answer.reason or "")
    r = answer.value
    assert isinstance(r, float)
    assert 0.5 * 9 * (r + 0.4) == pytest.approx(30 * r**2 * (r - 0.4))


def test_all_equilibria_of_a_bead_held_by_a_spring_are_told() -> None:
    (answer,) = fb.solve(fb.System.from_text(BEAD_ON_A_HOOP), "equilibrium of th").answers
    assert any(str(note) == "it may rest at 0, too" for note in answer.notes)
    lowest = fb.System.from_text(BEAD_ON_A_HOOP.replace("th: 80 deg", "th: 0"))
    (stable,) = fb.solve(lowest, "range of k for which the equilibrium is stable").answers
    assert isinstance(stable.expression, Expr)
    assert_same_function(to_python(stable.expression), "2*m*g/(2*R - l0)", {"R": 0.4, "l0": 0.5})


HINGED_ROD = """
space: {up: z}
parameters: {m: 2 kg, L: 0.9 m, a: 0.2 m, Om: 5 rad/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0, 0]}}
bodies:
  shaft: {body: {inertia: [1 kg m^2, 1 kg m^2, 1 kg m^2]}, points: {H: [a, 0, 0]}}
  rod: {box: {mass: m, size: [0, 0, L]}, points: {H: [0, 0, L/2], E: [0, 0, -L/2]}}
connections:
  axle: {revolute: {first: ground.O, second: shaft, about: z}}
  turn: {driver: {measure: psi, follows: Om*t}}
  hinge: {revolute: {first: shaft.H, second: rod.H, about: y}}
loads: {weight: {gravity: g}}
measures: {psi: angle of shaft about z, th: angle of line from shaft.H to rod.E from down}
"""


def test_a_place_in_steady_motion_may_be_given_by_an_angle_between_lines() -> None:
    """Om^2 (a + 2 L sin(th)/3) cos(th) = g sin(th) outwards, and with -a where the rod hangs to the other side."""
    (answer,) = fb.solve(fb.System.from_text(HINGED_ROD), "value of Om for which th = 30 deg in steady motion").answers
    m, n = 0.9 / 3, 9.81 / 3**0.5
    assert sorted(answer.value) == pytest.approx([(n / (m + 0.2)) ** 0.5, (n / (m - 0.2)) ** 0.5])  # type: ignore[arg-type]


def test_two_blows_are_not_taken_for_one() -> None:
    asked = "ratio of energy lost in the blow of k2 to energy lost in the blow of k1"
    (answer,) = fb.solve(fb.System.from_text(WAGONS), asked).answers
    assert answer.expression is None
    assert "different blows" in (answer.reason or "")


CRATE_ON_A_TRUCK = """
parameters: {m: 60 kg, w: 0.6 m, h: 1.5 m, mu: 0.5, a: 3 m/s^2, g: 9.81 m/s^2}
bodies:
  truck: {body: {mass: 1000 kg, inertia: 1000 kg m^2}, at: [0, 0], lines: {bed: {along: right}}}
  crate: {rectangle: {mass: m, width: w, height: h}, at: [0, h/2], angle: 0}
connections:
  road: {slider: {body: truck, along: right}}
  pull: {driver: {measure: x, follows: a*t^2/2}}
  bed: {contact: {between: [crate, truck.bed], friction: mu}}
loads: {weight: {gravity: g}}
measures: {x: x of truck}
"""


def test_what_is_driven_rests_beside_the_drive() -> None:
    """It tips where m a h/2 > m g w/2, though it does not move at the start, and slips where a > mu g."""
    system = fb.System.from_text(CRATE_ON_A_TRUCK)
    for asked, formula in (("least mu so that it stays at rest", "a/g"), ("does it tip or slide as a grows", "w*g/h")):
        (answer,) = fb.solve(system, asked).answers
        assert isinstance(answer.expression, Expr), answer.reason
        assert_same_function(to_python(answer.expression), formula, {})
    (holds,) = fb.solve(system, "does it hold").answers
    assert "it holds" in holds.verdict
    (tips,) = fb.solve(system, "range of a for which crate tips").answers
    assert isinstance(tips.expression, Expr), tips.reason
    assert_same_function(to_python(tips.expression), "w*g/h", {})
