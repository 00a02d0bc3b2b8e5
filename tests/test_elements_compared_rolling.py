"""A ball whose rolling and spinning are resisted beside its own equations, integrated by SciPy.

With n the normal, N = m g cos(beta), the slip u = v + omega x (-R n), and e(x) = x/|x|

    slips    m v' = m g + N n - mu N e(u),   I omega' = -R n x (-mu N e(u)) - N (f e(omega_t) + s e(omega_n))
    rolls    7/5 m R^2 omega_t' = R n x m g - f N e(omega_t),   I omega_n' = -s N e(omega_n)

so that spinning ends after I omega_n/(s N), and rolling on the level after 7 R v/(5 f g). At rest a slope needs f = R
tan(beta), and a torque about the normal of the level may be s m g. Source: Johnson, Contact Mechanics, sec. 8 and 9;
Hibbeler, Statics, sec. 8.8.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from posed import is_formula

M, R, MU, F, S, G = 2.0, 0.1, 0.3, 2e-3, 1.5e-3, 9.81


def model(v: tuple[float, ...], w: tuple[float, ...], beta: float = 0.0) -> fb.System:
    return fb.System.from_text(f"""
space: {{up: z}}
parameters:
  {{m: {M} kg, R: {R} m, mu: {MU}, f: {F} m, s: {S} m, g: {G} m/s^2, beta: {{value: {beta} rad, sign: any}}}}
ground: {{planes: {{floor: {{normal: [-sin(beta), 0, cos(beta)]}}}}}}
bodies:
  ball:
    sphere: {{mass: m, radius: R}}
    at: [-R*sin(beta), 0, R*cos(beta)]
    velocity: {[f"{x} m/s" for x in v]}
    angular_velocity: {[f"{x} rad/s" for x in w]}
connections:
  c: {{contact: {{between: [ball, floor], friction: mu, rolling_resistance: f, spinning_resistance: s}}}}
loads: {{weight: {{gravity: g}}}}
""")


def along(x: np.ndarray) -> np.ndarray:
    size = float(np.linalg.norm(x))
    return x / size if size > 1e-12 else 0.0 * x


def integrated(v: tuple[float, ...], w: tuple[float, ...], beta: float, until: float) -> np.ndarray:
    integrate = pytest.importorskip("scipy.integrate")
    n, weight = np.array([-math.sin(beta), 0.0, math.cos(beta)]), np.array([0.0, 0.0, -M * G])
    N, inertia = M * G * math.cos(beta), 0.4 * M * R * R

    def slip(y: np.ndarray) -> np.ndarray:
        return y[:3] + np.cross(y[3:], -R * n)

    def slips(_t: float, y: np.ndarray) -> np.ndarray:
        rub, spin = -MU * N * along(slip(y)), (y[3:] @ n) * n
        moment = np.cross(-R * n, rub) - N * (F * along(y[3:] - spin) + S * along(spin))
        return np.concatenate([(weight + N * n + rub) / M, moment / inertia])

    def rolls(_t: float, y: np.ndarray) -> np.ndarray:
        spin = (y[3:] @ n) * n
        turned = (np.cross(R * n, weight) - F * N * along(y[3:] - spin)) / (1.4 * M * R * R)
        return np.concatenate([np.cross(turned, R * n), turned - S * N * along(spin) / inertia])

    def gripped(_t: float, y: np.ndarray) -> float:
        return float(np.linalg.norm(slip(y))) - 1e-9

    def spun_out(_t: float, y: np.ndarray) -> float:
        return float(y[3:] @ n)

    y, t = np.array([*v, *w], dtype=float), 0.0
    for law, end in ((slips, gripped), (rolls, spun_out), (rolls, None)):
        if law is slips and float(np.linalg.norm(slip(y))) < 1e-8:
            continue
        if end is not None:
            end.terminal = True
        part = integrate.solve_ivp(law, (t, until), y, events=end, rtol=1e-11, atol=1e-12)
        y, t = part.y[:, -1], float(part.t[-1])
        if t >= until:
            break
        if end is spun_out:
            y[3:] -= (y[3:] @ n) * n
    return y


@pytest.mark.parametrize(
    ("v", "w", "beta"),
    [
        ((1, 0, 0), (0, 10, 3), 0.0),  # rolls, and its spin ends
        ((3, 0, 0), (-20, 0, 15), 0.0),  # slips aside
        ((0, 1, 0), (-10 * math.cos(0.17), 0, -10 * math.sin(0.17)), 0.17),  # rolls across a slope
    ],
    ids=["spins", "slips", "across"],
)
def test_a_ball_that_is_resisted_moves_by_its_equations(
    v: tuple[float, ...], w: tuple[float, ...], beta: float
) -> None:
    data = model(v, w, beta).simulate(until=1, tolerance=1e-10).dataset
    found = np.concatenate([np.asarray(data[f"body_{x}"])[-1, 0] for x in ("velocity", "angular_velocity")])
    assert found == pytest.approx(integrated(v, w, beta, 1.0), abs=3e-8)


def test_what_ends_is_told_by_what_was_resisted() -> None:
    [rolled] = model((1, 0, 0), (0, 10, 0)).simulate(until=8, tolerance=1e-10).events
    assert (rolled.name, rolled.kind) == ("ball stops rolling on floor", "stops rolling")
    assert rolled.time == pytest.approx(7 * R / (5 * F * G), rel=1e-8)
    spun, gripped = model((3, 0, 0), (0, 0, 1)).simulate(until=1, tolerance=1e-10).events
    assert [spun.kind, gripped.kind] == ["stops spinning", "stops slipping"]
    assert spun.time == pytest.approx(0.4 * R * R / (S * G), rel=1e-8)


def test_rolling_begins_where_slipping_ends_and_not_where_spinning_does() -> None:
    """u' = -mu g - 5/2 (mu g - f g/R): rolling resistance works against the spin that friction gives."""
    time = 3.0 / (3.5 * MU * G - 2.5 * F * G / R)
    found = model((3, 0, 0), (0, 0, 1)).solve(["time when rolling begins", "velocity of ball when rolling begins"])
    assert found["q1"].value == pytest.approx(time, rel=1e-8)
    assert found["q2"].value == pytest.approx([3.0 - MU * G * time, 0.0, 0.0], rel=1e-8, abs=1e-9)


SLOPE = """
space: {up: z}
parameters: {m: 2 kg, R: 10 cm, mu: 0.6, f: 2 mm, s: 1 mm, T: 1 N mm, beta: 5 deg, g: 9.81 m/s^2}
ground: {planes: {floor: {normal: [-sin(beta), 0, cos(beta)]}}}
bodies: {ball: {sphere: {mass: m, radius: R}, at: [-R*sin(beta), 0, R*cos(beta)]}}
connections: {c: {contact: {between: [ball, floor], friction: mu, rolling_resistance: f, spinning_resistance: s}}}
loads: {w: {gravity: g}, t: {torque: {on: ball, about: [-sin(beta), 0, cos(beta)], magnitude: T}}}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("least f so that it stays at rest", "R*tan(beta)"),
        ("largest beta so that it stays at rest", "atan(f/R)"),  # which is less than the slope that is given
    ],
)
def test_a_ball_stays_on_a_slope_that_its_resistance_holds(question: str, formula: str) -> None:
    is_formula(SLOPE, question, formula, factors=(1.0, 1.02))


def test_a_torque_about_the_normal_is_held_up_to_the_resistance_to_spinning() -> None:
    is_formula(SLOPE.replace("beta: 5 deg", "beta: 0.5 deg"), "largest T so that it stays at rest", "s*m*g*cos(beta)")


BOWL = """
space: {up: z}
parameters: {m: 2 kg, r: 5 cm, k: 2 /m, g: 9.81 m/s^2}
bodies: {ball: {SHAPE, at: [0, 0, r]}}
connections: {c: {rolling_on_surface: {body: ball, z: "k/2*rho^2"}}}
loads: {w: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("shape", "share"),
    [("sphere: {mass: m, radius: r}", "7/5"), ("spherical_shell: {mass: m, radius: r}", "5/3")],
)
def test_a_ball_swings_about_the_bottom_of_a_bowl_by_its_curvature(shape: str, share: str) -> None:
    """Its middle is 1/k - r from that of curvature, and it turns as it rolls: (1 + I/(m r^2)) (1/k - r) s'' = -g s."""
    text = BOWL.replace("SHAPE", shape)
    is_formula(text, "period of small oscillations", f"2*pi*sqrt({share}*(1/k - r)/g)", factors=(1.0, 1.02))
