"""Small motions: frequencies, mode shapes, stability, damping and forced oscillations, against the textbooks.

RAO: Rao, Mechanical Vibrations, 5th ed. 2011. THO: Thomson & Dahleh, Theory of Vibration with Applications, 5th ed.
1998. MEI: Meirovitch, Elements of Vibration Analysis, 2nd ed. 1986. LL: Landau & Lifshitz, Mechanics, 3rd ed. 1976. DH:
Den Hartog, Mechanical Vibrations, 4th ed. 1956. The families are theirs, the words and numbers are not. What has no
source is derived in its line.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

import freebody as fb
from freebody.language.expression import evaluate
from freebody.symbolic.field import Field
from freebody.symbolic.residues import ResidueField

Agree = Callable[[fb.Solution, str, str | list[str]], None]


def ask(model: str, question: str) -> fb.Solution:
    return fb.System.from_text(model).solve(question)


def the(solution: fb.Solution) -> fb.Answer:
    return solution.answers[0]


def row(n: int, *, walls: bool) -> str:
    """n equal masses on a line with equal springs between them, and to the walls."""
    springs = [
        f"  s{i}: {{law: {{measure: {{expression: x{i + 1} - x{i}}}, force: -k*(x{i + 1} - x{i})}}}}"
        for i in range(1, n)
    ]
    if walls:
        springs += [f"  w{i}: {{law: {{measure: x{i}, force: -k*x{i}}}}}" for i in dict.fromkeys((1, n))]
    indices = range(1, n + 1)
    return "\n".join(
        [
            "parameters: {m: 1 kg, k: 100 N/m}",
            "bodies:",
            *(f"  P{i}: {{particle: {{mass: m}}}}" for i in indices),
            "connections:",
            *(f"  g{i}: {{slider: {{body: P{i}, along: right}}}}" for i in indices),
            "measures:",
            *(f"  x{i}: x of P{i}" for i in indices),
            "loads:",
            *springs,
            "start: {" + ", ".join(f"x{i}: 0" for i in indices) + "}",
        ]
    )


def pendulums(n: int) -> str:
    """n equal point masses on equal massless rods."""
    points = ["ground.O", *(f"P{i}" for i in range(1, n + 1))]
    indices = range(1, n + 1)
    return "\n".join(
        [
            "parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}",
            "bodies:",
            *(f"  P{i}: {{particle: {{mass: m}}}}" for i in indices),
            "connections:",
            *(f"  r{i}: {{link: [{points[i - 1]}, P{i}, L]}}" for i in indices),
            "loads: {weight: {gravity: g}}",
            "measures:",
            *(f"  a{i}: {{angle of line from {points[i - 1]} to P{i} from down}}" for i in indices),
            "start: {" + ", ".join(f"a{i}: 0" for i in indices) + "}",
        ]
    )


TORSION = """
parameters: {J1: 2 kg m^2, J2: 3 kg m^2, J3: 1.5 kg m^2, k1: 100 N m, k2: 60 N m}
ground: {points: {A: [0, 0], B: [1 m, 0], C: [2 m, 0]}}
bodies:
  a: {body: {mass: 1 kg, inertia: J1}}
  b: {body: {mass: 1 kg, inertia: J2}}
  c: {body: {mass: 1 kg, inertia: J3}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, r: {pin: [ground.C, c]}}
measures: {th1: angle of a, th2: angle of b, th3: angle of c}
loads:
  s1: {torsional_spring: {body: b, on: a, stiffness: k1, angle: 0}}
  s2: {torsional_spring: {body: c, on: b, stiffness: k2, angle: 0}}
start: {th1: 0, th2: 0, th3: 0}
"""
GEARED = """
parameters: {J1: 2 kg m^2, J2: 3 kg m^2, k1: 100 N m, k2: 50 N m, r1: 0.1 m, r2: 0.2 m}
ground: {points: {A: [0, 0], B: [0.3 m, 0]}}
bodies:
  a: {body: {mass: 1 kg, inertia: J1}}
  pinion: {disk: {radius: r1}}
  wheel: {disk: {radius: r2}}
  b: {body: {mass: 1 kg, inertia: J2}}
connections:
  p: {pin: [ground.A, a]}
  q: {pin: [ground.A, pinion]}
  r: {pin: [ground.B, wheel]}
  s: {pin: [ground.B, b]}
  mesh: {gear_mesh: [pinion, wheel]}
measures: {th1: angle of a, th2: angle of b, phi: angle of pinion}
loads:
  s1: {torsional_spring: {body: pinion, on: a, stiffness: k1, angle: 0}}
  s2: {torsional_spring: {body: b, on: wheel, stiffness: k2, angle: 0}}
start: {th1: 0, th2: 0, phi: 0}
"""
CART = """
parameters: {M: 2 kg, m: 1 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}}}
connections: {rail: {slider: {body: cart, along: right}}, rod: {link: [cart, bob, L]}}
loads: {weight: {gravity: g}}
measures: {x: x of cart, theta: {angle of line from cart to bob from down}}
start: {x: 0, theta: 0}
"""
INVERTED = """
parameters: {m: 2 kg, L: 1 m, k: 30 N m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}, rod: {rod: {length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}, tip: {pin: [rod.end, bob]}}
loads: {weight: {gravity: g}, spring: {torsional_spring: {body: rod, stiffness: k, angle: 90 deg}}}
measures: {theta: angle of rod from up}
start: {theta: 0}
"""
TRAPEZOID = """
parameters: {m: 2 kg, L: 0.5 m, d: 1 m, b: 0.6 m, g: 9.81 m/s^2}
ground: {points: {A: [-d/2, 0], B: [d/2, 0]}}
bodies:
  l: {rod: {length: L}, near: {at: [-0.45 m, -0.3 m], angle: -60 deg}}
  r: {rod: {length: L}, near: {at: [0.45 m, -0.3 m], angle: -120 deg}}
  c: {rod: {mass: m, length: b}}
connections:
  A: {pin: [ground.A, l.start]}
  B: {pin: [ground.B, r.start]}
  C: {pin: [l.end, c.start]}
  D: {pin: [r.end, c.end]}
loads: {weight: {gravity: g}}
measures: {phi: angle of c}
start: {phi: 0}
"""
FORCED = """
parameters: {m: 2 kg, k: 200 N/m, c: 4 N s/m, F0: 10 N, Omega: 5 rad/s}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads:
  spring: {law: {measure: x, force: -k*x}}
  damper: {law: {measure: x, force: -c*rate(x)}}
  shaker: {force: {at: block, along: right, magnitude: F0*cos(Omega*t)}}
start: {x: 0}
"""
BASE = """
parameters: {m: 2 kg, k: 200 N/m, c: 4 N s/m, Y: 0.01 m, Omega: 5 rad/s}
bodies: {block: {particle: {mass: m}}, base: {particle: {mass: 1 kg}}}
connections:
  a: {slider: {body: block, along: right}}
  b: {slider: {body: base, along: right}}
  shaker: {driver: {measure: y, follows: Y*sin(Omega*t)}}
measures: {x: x of block, y: x of base}
loads:
  spring: {law: {measure: {expression: x - y}, force: -k*(x - y)}}
  damper: {law: {measure: {expression: x - y}, force: -c*(rate(x) - rate(y))}}
start: {x: 0}
"""
UNBALANCE = """
parameters: {M: 20 kg, m: 1 kg, e: 0.02 m, k: 20000 N/m, c: 100 N s/m, Omega: 25 rad/s}
bodies: {frame: {particle: {mass: M}}, rotor: {rod: {length: e}}, lump: {particle: {mass: m}}}
connections:
  guide: {slider: {body: frame, along: up}}
  axle: {pin: [frame, rotor.start]}
  hold: {weld: [rotor.end, lump]}
  motor: {driver: {measure: angle of rotor, follows: Omega*t}}
measures: {x: y of frame}
loads: {spring: {law: {measure: x, force: -k*x}}, damper: {law: {measure: x, force: -c*rate(x)}}}
start: {x: 0}
"""
ABSORBER = """
parameters: {m1: 10 kg, m2: 1 kg, k1: 4000 N/m, k2: 400 N/m, F0: 20 N, Omega: 15 rad/s}
bodies: {A: {particle: {mass: m1}}, B: {particle: {mass: m2}}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
measures: {x1: x of A, x2: x of B}
loads:
  s1: {law: {measure: x1, force: -k1*x1}}
  s2: {law: {measure: {expression: x2 - x1}, force: -k2*(x2 - x1)}}
  f: {force: {at: A, along: right, magnitude: F0*sin(Omega*t)}}
start: {x1: 0, x2: 0}
"""


# -- frequencies ------------------------------------------------------------------------------
@pytest.mark.parametrize("n", [3, 6])
def test_equal_masses_between_walls_have_the_frequencies_of_the_chain(n: int) -> None:
    # RAO ch. 5: x_j = sin(j q), q = pi p/(n + 1): m w^2 x_j = k (2 x_j - x_(j-1) - x_(j+1)), w = 2 sqrt(k/m) sin(q/2)
    answer = the(ask(row(n, walls=True), "natural frequencies"))
    assert answer.expression is not None
    assert answer.conditions == ("for all positive parameters",)
    assert answer.value == pytest.approx(
        [20 * math.sin(math.pi * p / (2 * (n + 1))) for p in range(1, n + 1)], rel=1e-12
    )


def test_a_free_row_has_one_mode_without_frequency(agrees: Agree) -> None:
    # LL sec. 24 (linear molecule of equal atoms): w^2 = k/m and 3 k/m
    agrees(ask(row(3, walls=False), "natural frequencies"), "q1", ["0", "sqrt(k/m)", "sqrt(3*k/m)"])


def test_three_equal_pendulums_have_the_roots_of_a_laguerre_polynomial() -> None:
    # a hanging chain of n equal beads: L_n(w^2 L/g) = 0; n = 3: s^3 - 9 s^2 + 18 s - 6 = 0
    answer = the(ask(pendulums(3), "natural frequencies"))
    assert answer.expression is not None
    roots = np.sort(np.roots([1, -9, 18, -6]).real)
    assert answer.value == pytest.approx(np.sqrt(9.81 * roots), rel=1e-10)


def test_three_disks_on_a_shaft(agrees: Agree) -> None:
    # DH sec. 5.2: J1 J2 J3 s^2 - (k1 J3 (J1 + J2) + k2 J1 (J2 + J3)) s + k1 k2 (J1 + J2 + J3) = 0, and s = 0
    a, b, c = "(J1*J2*J3)", "(k1*J3*(J1 + J2) + k2*J1*(J2 + J3))", "(k1*k2*(J1 + J2 + J3))"
    roots = [f"sqrt(({b} {sign} sqrt({b}**2 - 4*{a}*{c}))/(2*{a}))" for sign in "-+"]
    agrees(ask(TORSION, "natural frequencies"), "q1", ["0", *roots])


def test_geared_shafts_with_wheels_without_inertia(agrees: Agree) -> None:
    # RAO sec. 5.3 (geared systems): seen from shaft 1, J2 n^2 and k2 n^2 with n = r1/r2; the shafts in series
    k, J = "(k1*k2*(r1/r2)**2/(k1 + k2*(r1/r2)**2))", "(J2*(r1/r2)**2)"
    agrees(ask(GEARED, "natural frequencies"), "q1", ["0", f"sqrt({k}*(J1 + {J})/(J1*{J}))"])


def test_a_bar_on_two_oblique_links_swings_through_a_closed_loop() -> None:
    # family of LL sec. 5 (constrained motion): kinetic and potential energy along the exact closure, by differences
    answer = the(ask(TRAPEZOID, "natural frequency"))
    assert answer.expression is not None
    assert answer.evidence is not None
    assert answer.value == pytest.approx(_swing_of_a_trapezoid(2.0, 0.5, 1.0, 0.6, 9.81), rel=1e-6)


def _swing_of_a_trapezoid(m: float, L: float, d: float, b: float, g: float) -> float:
    """From the exact closure: the left link at the angle u, the right one solved for by Newton's method."""

    def middle(u: float) -> tuple[float, float, float]:
        left = np.array([-d / 2 + L * math.cos(u), L * math.sin(u)])
        w = math.pi - u
        for _ in range(50):
            right = np.array([d / 2 + L * math.cos(w), L * math.sin(w)])
            gap = float((right - left) @ (right - left)) - b * b
            slope = 2 * float((right - left) @ np.array([-L * math.sin(w), L * math.cos(w)]))
            w -= gap / slope
        right = np.array([d / 2 + L * math.cos(w), L * math.sin(w)])
        x, y = (left + right) / 2
        return float(x), float(y), math.atan2(*(right - left)[::-1])

    u0, h = -math.acos((d - b) / (2 * L)), 1e-4
    (xa, ya, pa), (_x, y, _p), (xb, yb, pb) = (middle(u0 + e * h) for e in (-1, 0, 1))
    mass = m * ((xb - xa) ** 2 + (yb - ya) ** 2) / (4 * h * h) + m * b * b / 12 * (pb - pa) ** 2 / (4 * h * h)
    return math.sqrt(m * g * (ya - 2 * y + yb) / (h * h) / mass)


# -- mode shapes ------------------------------------------------------------------------------
def test_mode_shapes_of_three_equal_masses(agrees: Agree) -> None:
    shapes = ["1", "sqrt(2)", "1", "1", "0", "-1", "1", "-sqrt(2)", "1"]  # THO sec. 5.2: sin(j q)/sin(q), q = p pi/4
    agrees(ask(row(3, walls=True), "mode shapes"), "q1", shapes)


def test_modes_of_a_double_pendulum(agrees: Agree) -> None:
    # LL sec. 23, problem 2, equal masses and lengths: theta_2/theta_1 = sqrt(2), -sqrt(2)
    agrees(ask(pendulums(2), "mode 1"), "q1", ["1", "sqrt(2)"])
    agrees(ask(pendulums(2), "second mode"), "q1", ["1", "-sqrt(2)"])


def test_the_cart_moves_against_the_pendulum(agrees: Agree) -> None:
    # the mass centre rests in the mode that swings: M x + m (x + L theta) = 0
    agrees(ask(CART, "mode 2"), "q1", ["1", "-(M + m)/(m*L)"])
    assert the(ask(CART, "mode 3")).reason == "there are 2 modes only"


def test_of_equal_frequencies_a_basis_is_given_and_said_not_to_be_the_only_one(agrees: Agree) -> None:
    model = row(2, walls=False).replace("s1: {law: {measure: {expression: x2 - x1}, force: -k*(x2 - x1)}}", "")
    model += "\n"
    model = model.replace(
        "loads:\n", "loads:\n  a: {law: {measure: x1, force: -k*x1}}\n  b: {law: {measure: x2, force: -k*x2}}\n"
    )
    found = ask(model, "mode shapes")
    agrees(found, "q1", ["1", "0", "0", "1"])
    assert "any combination of them is a mode too" in " ".join(map(str, the(found).notes))


def ring(n: int, mass: str = "m") -> str:
    """n masses on a ring with equal springs between neighbours; the first has another mass."""
    model = row(n, walls=False).replace("P1: {particle: {mass: m}}", f"P1: {{particle: {{mass: {mass}}}}}")
    return model.replace(
        "loads:\n", f"loads:\n  last: {{law: {{measure: {{expression: x1 - x{n}}}, force: -k*(x1 - x{n})}}}}\n"
    )


def test_three_equal_masses_on_a_ring_have_two_modes_of_one_frequency(agrees: Agree) -> None:
    # K = k (3 I - 1 1^T): s = 0 for (1, 1, 1), s = 3 k/m for all v with x1 + x2 + x3 = 0, of which two are orthogonal
    found = ask(ring(3), "mode shapes")
    agrees(found, "q1", ["1", "1", "1", "1", "0", "-1", "1", "-2", "1"])
    assert "checked numerically" in str(found)


def test_the_shapes_of_equal_frequencies_are_eigenvectors_without_common_inertia() -> None:
    # four on a ring: s = 0, 2 k/m twice, 4 k/m (Rao, Mechanical Vibrations, ch. 6); K v = s M v is tried out
    answer = the(ask(ring(4), "mode shapes"))
    v = np.array(answer.value).reshape(4, 4)
    K = 2 * np.eye(4) - np.roll(np.eye(4), 1, axis=0) - np.roll(np.eye(4), -1, axis=0)
    for shape, s in zip(v, (0, 2, 2, 4), strict=True):
        assert np.allclose(K @ shape, s * shape)
    assert abs(v[1] @ v[2]) < 1e-12


def test_a_frequency_that_is_twice_the_root_of_a_quadratic_has_a_basis_too() -> None:
    # two equal chains of two masses on a wall each, nothing between them: the shapes of Landau, Mechanics, ch. 5
    # s = (3 -+ sqrt(5)) k/(2 m), x2/x1 = (1 +- sqrt(5))/2
    between = "  s2: {law: {measure: {expression: x3 - x2}, force: -k*(x3 - x2)}}"
    model = row(4, walls=False).replace(between, "")
    model = model.replace(
        "loads:\n", "loads:\n  a: {law: {measure: x1, force: -k*x1}}\n  b: {law: {measure: x3, force: -k*x3}}\n"
    )
    v = np.array(the(ask(model, "mode shapes")).value).reshape(4, 4)
    golden = (1 + 5**0.5) / 2
    assert np.allclose(v, [[1, golden, 0, 0], [0, 0, 1, golden], [1, 1 - golden, 0, 0], [0, 0, 1, 1 - golden]])


def test_residues_have_inverses_and_vanish_at_roots_only() -> None:
    f = Field()
    p = [f.element(c) for c in (-6, 18, -9, 1)]
    ring = ResidueField(tuple(p))
    a = [f.element(c) for c in (2, -1, 3)]
    assert ring.multiply(a, ring.inverse(a)) == [f.one]
    with pytest.raises(ZeroDivisionError):
        ring.inverse(p[:0])


# -- stability --------------------------------------------------------------------------------
def test_an_inverted_pendulum_needs_a_stiff_spring(agrees: Agree) -> None:
    solution = ask(INVERTED, "stability of equilibrium")
    agrees(solution, "q1", "(m*g*L - k)/(m*L**2)")
    assert the(solution).conditions == ("stable if k > m·L·g",)
    assert the(solution).verdict == "stable with the given numbers"


def test_neutral_motion_is_no_instability(agrees: Agree) -> None:
    solution = ask(CART, "is the equilibrium stable?")
    agrees(solution, "q1", "-g*(M + m)/(M*L)")
    assert the(solution).conditions == ("stable for all admissible values",)
    assert any("neutral along x" in note for note in the(solution).notes)
    standing = CART.replace("theta: 0}", "theta: 180 deg}")
    assert the(ask(standing, "stability of equilibrium")).conditions == ("unstable for all admissible values",)


# -- damping ----------------------------------------------------------------------------------
def test_damping_of_one_mass(agrees: Agree) -> None:
    # RAO sec. 2.6: zeta = c/(2 sqrt(k m)), w_d^2 = k/m - (c/2m)^2, delta = 2 pi zeta/sqrt(1 - zeta^2)
    zeta = "(c/(2*sqrt(k*m)))"
    agrees(ask(FORCED, "damping ratio"), "q1", zeta)
    agrees(ask(FORCED, "damped natural frequency"), "q1", "sqrt(k/m - (c/(2*m))**2)")
    agrees(ask(FORCED, "logarithmic decrement"), "q1", f"2*pi*{zeta}/sqrt(1 - {zeta}**2)")
    agrees(ask(FORCED, "critical damping of c"), "q1", "2*sqrt(k*m)")
    assert the(ask(FORCED, "damped period")).conditions == ("4·m·k > c² (underdamped)",)


def test_proportional_damping_has_its_ratio_in_every_mode(agrees: Agree) -> None:
    # MEI sec. 4.10: dampers beside all springs, C = (c/k) K, zeta_p = (c/2k) w_p
    model = row(2, walls=True).replace("k: 100 N/m", "k: 100 N/m, c: 1 N s/m")
    model = model.replace("-k*(x2 - x1)", "-k*(x2 - x1) - c*(rate(x2) - rate(x1))")
    for x in ("x1", "x2"):
        model = model.replace(f"force: -k*{x}}}", f"force: -k*{x} - c*rate({x})}}")
    agrees(ask(model, "damping ratios"), "q1", ["c/(2*k)*sqrt(k/m)", "c/(2*k)*sqrt(3*k/m)"])


def test_damping_that_couples_modes_is_told_in_numbers() -> None:
    model = (
        row(2, walls=True)
        .replace("k: 100 N/m", "k: 100 N/m, c: 1 N s/m")
        .replace("force: -k*x1}", "force: -k*x1 - c*rate(x1)}")
    )
    answer = the(ask(model, "damping ratios"))
    assert answer.expression is None
    assert "couples the modes" in answer.reason
    s = np.roots(np.polysub(np.polymul([1, 1, 200], [1, 0, 200]), [100**2]))  # (m s^2 + c s + 2 k)(m s^2 + 2 k) = k^2
    upper = sorted((x for x in s if x.imag > 0), key=abs)
    assert answer.value == pytest.approx([-x.real / abs(x) for x in upper], rel=1e-6)


# -- forced oscillations ----------------------------------------------------------------------
BELOW = "sqrt((k - m*Omega**2)**2 + (c*Omega)**2)"


def test_steady_amplitude_and_phase_under_a_harmonic_force(agrees: Agree) -> None:
    # RAO sec. 3.4: X = F0/sqrt((k - m W^2)^2 + (c W)^2), tan(phi) = c W/(k - m W^2)
    agrees(ask(FORCED, "steady amplitude of x"), "q1", f"F0/{BELOW}")
    agrees(ask(FORCED, "phase lag of x"), "q1", f"acos((k - m*Omega**2)/{BELOW})")
    agrees(ask(FORCED, "resonance frequency of x"), "q1", "sqrt(k/m - c**2/(2*m**2))")
    agrees(ask(FORCED, "steady amplitude of velocity of x"), "q1", f"F0*Omega/{BELOW}")
    agrees(ask(FORCED, "resonance frequency of velocity of x"), "q1", "sqrt(k/m)")


def test_a_harmonic_force_moves_no_equilibrium(agrees: Agree) -> None:
    agrees(ask(FORCED, "equilibrium of x"), "q1", "0")


def test_transmitted_motion_of_a_shaken_base(agrees: Agree) -> None:
    # RAO sec. 3.6: X/Y = sqrt((k^2 + (c W)^2)/((k - m W^2)^2 + (c W)^2))
    agrees(ask(BASE, "transmissibility from y to x"), "q1", f"sqrt(k**2 + (c*Omega)**2)/{BELOW}")
    agrees(ask(BASE, "steady amplitude of x"), "q1", f"Y*sqrt(k**2 + (c*Omega)**2)/{BELOW}")


def test_a_spring_between_points_of_one_guide_is_as_long_as_they_are_apart(agrees: Agree) -> None:
    """The same, where the spring and the damper join the points: sqrt((y - Y sin(W t))^2) is no square of a polynomial
    in cosines."""
    joined = """
parameters: {m: 2 kg, k: 200 N/m, c: 4 N s/m, Y: 0.01 m, Omega: 5 rad/s, l0: 0.3 m, g: 9.81 m/s^2}
bodies: {block: {particle: {mass: m}}, base: {particle: {mass: 1 kg}}}
connections:
  a: {slider: {body: block, along: up}}
  b: {slider: {body: base, along: up}}
  shaker: {driver: {measure: y, follows: Y*sin(Omega*t)}}
measures: {x: y of block, y: y of base}
loads:
  weight: {gravity: g}
  spring: {spring: {first: base, second: block, stiffness: k, length: l0}}
  damper: {damper: {first: base, second: block, damping: c}}
start: {x: l0}
"""
    agrees(ask(joined, "equilibrium of x"), "q1", "l0 - m*g/k")
    agrees(ask(joined, "steady amplitude of x"), "q1", f"Y*sqrt(k**2 + (c*Omega)**2)/{BELOW}")


def test_rotor_out_of_balance(agrees: Agree) -> None:
    # RAO sec. 3.7, with M the frame alone: X = m e W^2/sqrt((k - (M + m) W^2)^2 + (c W)^2)
    below = "sqrt((k - (M + m)*Omega**2)**2 + (c*Omega)**2)"
    agrees(ask(UNBALANCE, "steady amplitude of x"), "q1", f"m*e*Omega**2/{below}")
    agrees(ask(UNBALANCE, "resonance frequency of x"), "q1", "sqrt(2*k**2/(2*k*(M + m) - c**2))")


def test_an_absorber_takes_the_motion(agrees: Agree) -> None:
    # DH sec. 3.2: x1 rests if k2/m2 = W^2, x2 then is F0/k2
    solution = ask(ABSORBER, "value of k2 for which steady amplitude of x1 = 0")
    agrees(solution, "q1", "m2*Omega**2")
    determinant = "((k1 + k2 - m1*Omega**2)*(k2 - m2*Omega**2) - k2**2)"
    agrees(ask(ABSORBER, "steady amplitude of x1"), "q1", f"sqrt((F0*(k2 - m2*Omega**2)/{determinant})**2)")


def test_what_is_not_harmonic_has_no_steady_amplitude() -> None:
    model = FORCED.replace("F0*cos(Omega*t)", "F0*Omega*t")
    assert "swing harmonically" in the(ask(model, "steady amplitude of x")).reason


def test_a_negative_damper_is_refused() -> None:
    model = FORCED.replace("-c*rate(x)", "c*rate(x)")
    assert "feeds energy" in the(ask(model, "steady amplitude of x")).reason


TURNING_ARM = """
space: true
parameters: {m: 1 kg, L: 0.5 m, W: 6 rad/s, g: 9.81 m/s^2}
bodies:
  shaft: {body: {inertia: 0.1 kg m^2}}
  arm: {body: {mass: 0}, points: {tip: [0, -L, 0]}}
  bob: {particle: {mass: m}}
connections:
  bearing: {revolute: {first: ground.O, second: shaft, about: y}}
  hinge: {revolute: {first: shaft, second: arm, about: z}}
  fix: {spherical: [arm.tip, bob]}
  motor: {driver: {measure: psi, follows: W*t}}
loads: {weight: {gravity: g}}
measures: {psi: angle of shaft about y, theta: angle of arm about z relative to shaft}
start: {theta: 10 deg, rate(theta): 0}
"""


def test_all_places_of_rest_are_named_and_what_is_driven_has_none() -> None:
    system = fb.System.from_text(TURNING_ARM)
    answer = system.solve("equilibrium of theta").answers[0]
    assert answer.value == pytest.approx(math.acos(9.81 / (0.5 * 36)))
    others = [note for note in answer.notes if note.startswith("it may rest at")]
    assert len(others) == 3
    assert others[:2] == ["it may rest at 0, too", "it may rest at π, too"]
    assert "driven" in system.solve("equilibrium of psi").answers[0].reason


def test_a_period_says_what_is_left_out_of_it() -> None:
    system = fb.System.from_text("""
parameters: {m: 2 kg, k: 800 N/m, c: 16 N s/m}
ground: {points: {wall: [-0.4 m, 0]}}
bodies: {cart: {particle: {mass: m}}}
connections: {track: {slider: {body: cart, along: right}}}
loads:
  spring: {spring: {first: ground.wall, second: cart, stiffness: k, length: 0.4 m}}
  damper: {damper: {first: ground.wall, second: cart, damping: c}}
""")
    notes = " ".join(system.solve("period").answers[0].notes)
    assert "without damping" in notes
    assert "small oscillations" in notes


def test_a_root_has_the_size_of_what_the_parameters_give_either_sign() -> None:
    """A bar on a spring from below its pin, of length |a - L| where the bar hangs: J omega^2 = m g L/2 +
    k a L (1 - l0/|a - L|), whether the spring's end is above or below the tip."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, L: 0.5 m, k: 200 N/m, a: 0.3 m, l0: 0.15 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], B: [0, -a]}}
bodies: {bar: {rod: {length: L, mass: m}}}
connections: {O: {pin: [ground.O, bar.start]}}
loads:
  weight: {gravity: g}
  s: {spring: {first: ground.B, second: bar.end, stiffness: k, length: l0}}
measures: {theta: {angle of bar from down}}
questions: [natural frequencies, period of small oscillations]
""")
    frequency, period = (answer.expression for answer in system.solve().answers)
    m, L, k, l0, g = 2.0, 0.5, 200.0, 0.15, 9.81
    for a in (0.3, 0.8):
        values = {"m": m, "L": L, "k": k, "a": a, "l0": l0, "g": g}
        omega = math.sqrt((m * g * L / 2 + k * a * L * (1 - l0 / abs(a - L))) / (m * L**2 / 3))
        assert evaluate(frequency, values) == pytest.approx(omega)
        assert evaluate(period, values) == pytest.approx(2 * math.pi / omega)


def test_the_critical_value_of_what_damps_nothing_is_not_that_of_damping(agrees: Agree) -> None:
    agrees(ask(FORCED, "critical value of c"), "q1", "2*sqrt(k*m)")
    with pytest.raises(fb.ModelError, match="k damps nothing, so say for what its value is critical"):
        ask(FORCED, "critical value of k")


def test_loads_that_are_out_of_balance_everywhere_say_what_balance_takes() -> None:
    gears = """
parameters: {T: 2 N m, M: 5 N m, z1: 20, z2: 40, J: 1 g m^2, module: 2 mm}
bodies: {a: {gear: {inertia: J}}, b: {gear: {inertia: J}}}
connections: {mesh: {gear_mesh: {first: a, second: b, module: module, teeth: [z1, z2]}}}
loads: {drive: {torque: {on: a, magnitude: T}}, brake: {torque: {on: b, magnitude: M}}}
measures: {phi: angle of a}
"""
    reason = the(ask(gears, "equilibrium of phi")).reason
    assert "in every pose or in none" in reason, reason


def test_what_measures_are_made_of_are_the_coordinates_before_an_expression_in_them() -> None:
    """Two floors of one mass and one stiffness: w^2 = (3 -+ sqrt 5)/2 k/m, and the upper one goes (1 + sqrt 5)/2 as
    far as the lower in the first mode."""
    system = fb.System.from_text("""
parameters: {m: 2000 kg, k: 800 kN/m}
bodies: {f1: {block: {mass: m}}, f2: {block: {mass: m}}}
connections: {s1: {slider: {body: f1, along: right}}, s2: {slider: {body: f2, along: right}}}
measures: {d: u2 - u1, u1: x of f1, u2: x of f2}
loads: {c1: {law: {measure: u1, force: -k*u1}}, c2: {law: {measure: d, force: -k*d}}}
""")
    frequencies, shapes = system.solve(["natural frequencies", "mode shapes"]).answers
    assert frequencies.value == pytest.approx(
        [20 * math.sqrt((3 - math.sqrt(5)) / 2), 20 * math.sqrt((3 + math.sqrt(5)) / 2)]
    )
    assert shapes.value == pytest.approx([1, (1 + math.sqrt(5)) / 2, 1, (1 - math.sqrt(5)) / 2])
