"""Curves as rails and for rolling: what is known of lines, circles, cycloids and rough wires comes out."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

import freebody as fb

G = 9.81
EXAMPLES = Path(__file__).parents[1] / "examples"


def simulated(text: str, until: float, **words: object) -> fb.Simulation:
    return fb.System.from_text(text).simulate(until, **words)


def answers(text: str, *questions: str) -> list[float]:
    solution = fb.System.from_text(f"{text}\nquestions: [{', '.join(questions)}]").solve()
    return [float(answer.value or 0.0) for answer in solution.answers]


# -- friction --------------------------------------------------------------------------------------
ROUGH = """
parameters: {{m: 0.1 kg, a: 0.8 1/m, mu: {mu}, g: 9.81 m/s^2, x_0: {x_0} m}}
bodies: {{bead: {{particle: {{mass: m}}, near: {{at: [x_0, a*x_0^2]}}}}}}
connections: {{wire: {{curved_rail: {{point: bead, y: a*x^2, friction: mu}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: x of bead}}
start: {{x: x_0, rate(x): 0}}
"""


def test_a_bead_on_a_rough_parabola_stops_where_an_equation_of_its_own_says() -> None:
    # with w = v^2 and N = m (g cos(psi) + w/rho), dw = -2 (g sin(psi) - mu N/m) ds along the arc, which falls to the
    # left. rho = (1 + 4 a^2 x^2)^(3/2)/(2 a)
    a, mu, x_0 = 0.8, 0.3, 0.6

    def slope(x: float, w: np.ndarray) -> list[float]:
        steep = math.sqrt(1 + (2 * a * x) ** 2)
        normal = G / steep + w[0] * 2 * a / steep**3
        return [(-2 * G * (2 * a * x) / steep + 2 * mu * normal) * steep]

    stops = lambda x, w: w[0] - (0.0 if x < x_0 - 1e-3 else -1.0)  # noqa: E731
    stops.terminal = True  # type: ignore[attr-defined]
    found = solve_ivp(slope, (x_0, -1.0), [0.0], events=stops, rtol=1e-10, atol=1e-12)
    motion = simulated(ROUGH.format(mu=mu, x_0=x_0), 5.0)
    assert motion.series["x"][0][-1] == pytest.approx(found.t_events[0][0], rel=1e-6)
    assert abs(2 * a * motion.series["x"][0][-1]) < mu  # and there it can stay


def test_a_bead_on_a_rough_parabola_stays_where_the_slope_is_less_than_the_coefficient() -> None:
    assert simulated(ROUGH.format(mu=0.3, x_0=0.18), 1.0).series["x"][0][-1] == pytest.approx(0.18, abs=1e-9)
    assert simulated(ROUGH.format(mu=0.3, x_0=0.19), 1.0).series["x"][0][-1] < 0.189


def test_a_rough_rail_that_lets_go_rubs_only_while_it_touches() -> None:
    text = """
parameters: {m: 2 kg, a: 0.1 1/m, v: 12 m/s, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: m}, near: {at: [0, 0]}}}
measures: {x: x of cart, y: y of cart}
connections: {it: {curved_rail: {point: cart, y: -a*x^2, leaves: true, friction: 0.3}}}
loads: {weight: {gravity: g}}
start: {x: 0, rate(x): v}
"""
    motion = simulated(text, 1.0)  # 2 a v^2 > g: it flies at once
    assert motion.series["x"][0][-1] == pytest.approx(12.0)
    assert motion.series["y"][0][-1] == pytest.approx(-G / 2)


# -- curves in a parameter -------------------------------------------------------------------------
CYCLOID = """
parameters: {{m: 0.1 kg, R: 0.25 m, g: 9.81 m/s^2, s_0: {s_0} deg}}
bodies: {{bead: {{particle: {{mass: m}}}}}}
connections: {{wire: {{curved_rail: {{point: bead, x: R*(2*s + sin(2*s)), y: R*(1 - cos(2*s))}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{s: parameter of wire}}
start: {{s: s_0, rate(s): 0}}
"""


@pytest.mark.parametrize("s_0", [5, 40, 75])
def test_a_cycloid_is_a_tautochrone(s_0: float) -> None:
    # Huygens: a quarter of the period is pi sqrt(R/g) from everywhere
    motion = simulated(CYCLOID.format(s_0=s_0), math.pi * math.sqrt(0.25 / G))
    assert motion.series["s"][0][-1] == pytest.approx(0.0, abs=1e-7)


def test_a_circle_as_a_curve_is_a_rod() -> None:
    by_curve, by_rod = (
        f"""
parameters: {{m: 2 kg, R: 0.7 m, g: 9.81 m/s^2}}
bodies: {{bead: {{particle: {{mass: m}}, near: {{at: [0.5 m, -0.5 m]}}}}}}
connections: {{it: {it}}}
loads: {{weight: {{gravity: g}}}}
measures: {{phi: angle of line from ground.O to bead from down}}
start: {{phi: 50 deg, rate(phi): 1 rad/s}}
"""
        for it in ("{curved_rail: {point: bead, x: R*sin(s), y: -R*cos(s)}}", "{link: [ground.O, bead, R]}")
    )
    one, other = (simulated(text, 2.0, every=0.1) for text in (by_curve, by_rod))
    assert one.series["phi"][0] == pytest.approx(other.series["phi"][0], abs=1e-7)
    # counter-clockwise, the left of the curve is its inside: what the wire pushes is what the rod pulls
    forces = [
        motion.recording.series[name].values for motion, name in ((one, "it.normal_force"), (other, "it.tension"))
    ]
    assert forces[0] == pytest.approx(forces[1], rel=1e-6, abs=1e-6)


def test_parameters_may_have_the_names_of_what_a_curve_is_stated_in() -> None:
    (named,), (plain,) = (
        answers(
            f"""
parameters: {{m: 1 kg, {h}: 0.1 m, {k}: 1.5 1/m, r: 0.3 m, g: 9.81 m/s^2}}
bodies: {{wheel: {{disk: {{mass: m, radius: r}}, near: {{at: [0.2 m, 0.4 m]}}}}}}
connections: {{road: {{rolling_on_curve: {{body: wheel, y: {h}*cos({k}*x)}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{p: parameter of road}}
start: {{p: 0.2 m, rate(p): 1 m/s}}
""",
            "normal force of road at start",
        )
        for h, k in (("h", "s"), ("height", "wave"))
    )
    assert named == pytest.approx(plain, rel=1e-12)


# -- rolling ---------------------------------------------------------------------------------------
def test_a_disk_on_a_straight_curve_rolls_as_down_an_incline() -> None:
    text = """
parameters: {m: 2 kg, r: 0.1 m, beta: 20 deg, g: 9.81 m/s^2}
bodies: {disk: {disk: {mass: m, radius: r}}}
connections: {slope: {rolling_on_curve: {body: disk, y: -x*tan(beta)}}}
loads: {weight: {gravity: g}}
"""
    beta = math.radians(20)
    along, normal, grip = answers(
        text, "acceleration of disk along right", "normal force of slope", "friction force of slope"
    )
    assert along == pytest.approx(2 / 3 * G * math.sin(beta) * math.cos(beta))
    assert normal == pytest.approx(2 * G * math.cos(beta))
    assert abs(grip) == pytest.approx(2 * G * math.sin(beta) / 3)


def test_a_disk_in_a_circle_as_a_curve_rolls_as_inside_a_ring() -> None:
    one, other = (
        simulated(
            f"""
parameters: {{m: 2 kg, r: 0.1 m, R: 0.5 m, g: 9.81 m/s^2}}
bodies:
  disk: {{disk: {{mass: m, radius: r}}, near: {{at: [0.2 m, -0.3 m]}}}}
{ring}
connections: {{it: {it}}}
loads: {{weight: {{gravity: g}}}}
measures: {{phi: angle of line from ground.O to disk from down}}
start: {{phi: 40 deg, rate(phi): 0}}
""",
            2.0,
            every=0.1,
        )
        for ring, it in (
            ("", "{rolling_on_curve: {body: disk, x: R*sin(s), y: -R*cos(s)}}"),
            ("  bowl: {ring: {radius: R}, fixed: true}", "{rolling: {body: disk, inside: bowl}}"),
        )
    )
    assert one.series["phi"][0] == pytest.approx(other.series["phi"][0], abs=1e-7)
    for force in ("normal_force", "friction_force"):
        pushes = [motion.recording.series[f"it.{force}"].values for motion in (one, other)]
        assert np.abs(pushes[0]) == pytest.approx(np.abs(pushes[1]), rel=1e-6, abs=1e-6)


def test_a_disk_rolls_off_a_cylinder_as_a_curve_where_the_textbook_says() -> None:
    # let go at the top with hardly any speed a disk leaves at cos(phi) = 4/7 (Meriam & Kraige, Dynamics, ch. 6)
    text = """
parameters: {m: 2 kg, r: 0.05 m, R: 0.5 m, g: 9.81 m/s^2}
bodies: {disk: {disk: {mass: m, radius: r}, near: {at: [0, 0.55 m]}}}
connections: {hill: {rolling_on_curve: {body: disk, x: R*sin(s), y: R*cos(s)}}}
loads: {weight: {gravity: g}}
measures: {s: parameter of hill}
start: {s: 0.001, rate(s): 0}
"""
    motion = simulated(text, 8.0)
    (parted,) = (event for event in motion.events if "parts" in str(event) or "leaves" in str(event))
    at = float(np.interp(parted.time, motion.recording.times, motion.series["s"][0]))
    assert math.cos(at) == pytest.approx(4 / 7 * math.cos(0.001), abs=2e-3)


def test_a_disk_that_does_not_fit_into_a_bowl_is_refused_with_the_radius_that_would_do() -> None:
    text = """
parameters: {a: 2 1/m}
bodies: {disk: {disk: {mass: 1 kg, radius: 0.3 m}, near: {at: [0.4 m, 0.6 m]}}}
connections: {bowl: {rolling_on_curve: {body: disk, y: a*x^2}}}
"""
    with pytest.raises(fb.ModelError, match=r"does not fit: .* 0.3 m, .* 0.25 m"):
        fb.System.from_text(text)


# -- curves with a divisor ---------------------------------------------------------------------------
def test_a_rail_over_a_quotient_has_a_closed_form() -> None:
    # y = h/(1 + k^2 x^2) at the top: y'' = -2 h k^2, N = m (g - 2 h k^2 v^2)
    text = """
parameters: {m: 2 kg, h: 0.2 m, k: 2 1/m, v: 1 m/s, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: m}, near: {at: [0, h]}}}
connections: {hill: {curved_rail: {point: cart, y: h/(1 + k^2*x^2)}}}
loads: {weight: {gravity: g}}
measures: {x: x of cart}
start: {x: 0, rate(x): v}
"""
    answer = fb.System.from_text(text).solve("normal force of hill at start").answers[0]
    assert answer.expression is not None
    assert answer.value == pytest.approx(2 * (G - 2 * 0.2 * 4))


def test_a_wheel_on_a_hump_can_be_asked_how_fast_it_stays_on_the_road() -> None:
    """Its centre runs round the radius 1/(h k^2) and its own more: v^2/(1/(h k^2) + r) = g at the top, where it starts
    and where it is pressed least. The foot on the curve has a place of its own where a phase begins."""
    system = fb.System.load(EXAMPLES / "wheel_over_a_hump.yaml")
    answer = system.solve("largest v so that wheel never leaves road").answers[0]
    assert answer.value == pytest.approx(math.sqrt(9.81 * (1 / (0.1 * 1.5**2) + 0.3)), rel=1e-9), answer.reason
    assert answer.evidence is not None
    # on a steeper hump it leaves the flank before the top: the formula is not said to be that of all parameters
    assert answer.conditions == ("near the given numbers: at others other ends may count",)


# -- points of a table beside the model ---------------------------------------------------------------
def test_a_car_runs_on_a_surveyed_track_as_on_the_natural_spline_of_scipy() -> None:
    """v^2 = v_0^2 + 2 g (y_0 - y) along the track; N = m (g + y'' x'^2)/sqrt(1 + y'^2), x'^2 = v^2/(1 + y'^2)."""
    system = fb.System.load(EXAMPLES / "car_on_a_surveyed_track.yaml")
    x, y = np.loadtxt(EXAMPLES / "surveyed_track.csv", delimiter=",", skiprows=1).T
    track = CubicSpline(x, y, bc_type="natural")
    g, m = 9.81, 500.0

    def square(at: float) -> float:
        return 2.0**2 * (1 + track(0.0, 1) ** 2) + 2 * g * (track(0.0) - track(at))

    def normal(at: float) -> float:
        slope = track(at, 1)
        return m * (g + track(at, 2) * square(at) / (1 + slope**2)) / math.sqrt(1 + slope**2)

    solution = system.solve()
    assert solution["speed"].value == pytest.approx(math.sqrt(square(20.0)), rel=1e-10)
    assert solution["dip"].value == pytest.approx(normal(20.0), rel=1e-10)
    assert solution["crest"].value == pytest.approx(normal(35.0), rel=1e-10)
