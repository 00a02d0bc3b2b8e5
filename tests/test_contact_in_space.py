"""Contact in space with dry friction: motions beside closed forms, identities and published values.

A ball that slides on a plane: the velocity of its lowest point u changes by the friction F = -mu m g u/|u| as

    du/dt = (1/m + R^2/I) F = -7/2 mu g u/|u|      (I = 2/5 m R^2),

so that its direction e is constant and it stops after 2 |u|/(7 mu g): the centre goes on a parabola, then rolls on
along a straight line. Source: Coriolis, Theorie mathematique des effets du jeu de billard, 1835, ch. I; Alciatore,
The Illustrated Principles of Pool and Billiards, 2004, TP A.4.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import freebody as fb

G = 9.81
EXAMPLES = Path(__file__).parents[1] / "examples"
TABLE = "space: true\nground: {planes: {table: {normal: up}}}\nloads: {weight: {gravity: 9.81 m/s^2}}\n"


def ball(velocity: list[float], spin: list[float], *, mu: float = 0.2, height: float = 0.0, more: str = "") -> str:
    at = f"at: [0, {height}, 0], " if height else ""
    return TABLE + (
        f"bodies: {{ball: {{sphere: {{mass: 0.17 kg, radius: 0.028 m}}, {at}"
        f"velocity: {velocity}, angular_velocity: {spin}}}}}\n"
        f"connections: {{cloth: {{contact: {{between: [ball, ground.table], friction: {mu}{more}}}}}}}\n"
    )


def slip_of(velocity: list[float], spin: list[float], radius: float = 0.028) -> np.ndarray:
    """Of the lowest point, v + w x (-R e_y)."""
    return np.array(velocity) + np.cross(spin, (0.0, -radius, 0.0))


@pytest.mark.parametrize(
    ("velocity", "spin"),
    [
        ([2.0, 0.0, 0.0], [40.0, 15.0, 30.0]),  # side spin and back spin: masse
        ([1.0, 0.0, 0.5], [-60.0, 0.0, 80.0]),  # thrown with back spin that is oblique to its way
        ([0.0, 0.0, 0.0], [30.0, 5.0, -20.0]),
    ],
)
def test_ball_slides_on_a_parabola_and_then_rolls_straight(velocity: list[float], spin: list[float]) -> None:
    mu, m, R = 0.2, 0.17, 0.028
    found = fb.System.from_text(ball(velocity, spin)).simulate(2.0, every=0.05)
    u = slip_of(velocity, spin)
    e, stops = u / np.linalg.norm(u), 2 * np.linalg.norm(u) / (7 * mu * G)
    v = np.array(velocity)
    end = v - mu * G * stops * e
    assert [event.time for event in found.course.events] == [pytest.approx(stops, rel=1e-9)]
    for t, pose, velocity_now in zip(
        found.course.times, found.course.poses[:, 0], found.course.velocities[:, 0], strict=True
    ):
        s = min(t, stops)
        place = v * s - 0.5 * mu * G * s**2 * e + end * (t - s)
        assert pose[:3] == pytest.approx(place + np.array((0.0, R, 0.0)), abs=1e-9)
        assert velocity_now[:3] == pytest.approx(v - mu * G * s * e, abs=1e-8)
    names = [row.name for row in found.system.rows]
    # the friction is mu m g against the slip, then none
    slip = found.course.multipliers[:, [names.index("cloth.slip z"), names.index("cloth.slip x")]]
    sliding = found.course.times < stops
    assert slip[sliding] == pytest.approx(np.tile(-mu * m * G * e[[2, 0]], (sliding.sum(), 1)), abs=1e-6)
    assert slip[~sliding] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(("mu", "sticks"), [(0.1, False), (0.9, True)])
def test_bouncing_ball_gets_the_impulse_of_coulomb_friction(mu: float, sticks: bool) -> None:
    """N = (1 + e) m w along the normal. Friction takes the whole slip, 2/7 m |u|, or mu N against it, whichever is
    less: the slip of a ball keeps its direction in an impact, so that the laws of Newton, Poisson and Routh agree.
    Source: Stronge, Impact Mechanics, 2000, sec. 3.3 and 4.3; Keller, J. Appl. Mech. 53 (1986) 1-4."""
    m, R, e, h = 0.17, 0.028, 0.6, 0.5
    velocity, spin = [1.0, 0.0, -0.4], [20.0, 7.0, 45.0]
    found = fb.System.from_text(ball(velocity, spin, mu=mu, height=h, more=", restitution: 0.6")).simulate(0.5)
    hit = found.course.contact.collisions[0]
    w = math.sqrt(2 * G * (h - R))
    u = slip_of(velocity, spin)
    size = min(2 / 7 * m * np.linalg.norm(u), mu * (1 + e) * m * w)
    assert (size < mu * (1 + e) * m * w) == sticks
    assert hit.time == pytest.approx(w / G, rel=1e-9)
    assert hit.impulses["cloth.contact"] == pytest.approx((1 + e) * m * w, rel=1e-9)
    along = np.array([hit.friction["cloth.slip x"], 0.0, hit.friction["cloth.slip z"]])
    assert along == pytest.approx(-size * u / np.linalg.norm(u), abs=1e-12)
    after = found.course.velocities[-1, 0]
    assert after[[0, 2]] == pytest.approx((np.array(velocity) + along / m)[[0, 2]], abs=1e-9)


def test_particle_on_a_rough_incline_turns_into_the_line_of_fall() -> None:
    """With tan(alpha) = mu the speed v and the part of it down the slope, w, keep v + w: dv/dt = g sin(alpha) (w/v - 1)
    and dw/dt = g sin(alpha) (1 - w/v). Pushed across, it ends down the slope at half the speed that it had.
    Source: Whittaker, Analytical Dynamics, 1917, art. 87; Lim, Am. J. Phys. 39 (1971)."""
    model = """
space: true
parameters: {alpha: 30 deg, g: 9.81 m/s^2}
ground: {planes: {slope: {normal: [sin(alpha), cos(alpha), 0]}}}
bodies: {puck: {particle: {mass: 1 kg}, velocity: [0, 0, 2]}}
connections: {it: {contact: {between: [puck, ground.slope], friction: tan(alpha)}}}
loads: {weight: {gravity: g}}
"""
    found = fb.System.from_text(model).simulate(6.0, every=0.1)
    down = np.array((math.cos(math.pi / 6), -math.sin(math.pi / 6), 0.0))
    velocities = found.course.velocities[:, 0, :3]
    assert np.linalg.norm(velocities, axis=1) + velocities @ down == pytest.approx(2.0, abs=1e-8)
    assert velocities[-1] @ down == pytest.approx(1.0, abs=1e-3)
    assert not found.course.events


def test_contact_in_space_says_what_it_cannot_touch() -> None:
    sphere, rod = "sphere: {mass: 0.17 kg, radius: 0.028 m}", "rod: {mass: 1 kg, length: 1 m}"
    cone = ball([0, 0, 0], [0, 0, 0]).replace(sphere, rod)
    with pytest.raises(fb.FreebodyError, match="there is no contact of ball with the plane table: it takes a sphere"):
        fb.System.from_text(cone)
    slides = fb.System.load(EXAMPLES / "tippe_top.yaml")
    with pytest.raises(fb.FreebodyError, match="I cannot solve this in closed form, because the friction of"):
        slides.phases()
    [answer] = slides.solve("degrees of freedom").answers
    assert answer.value == 6


def test_a_misspelt_plane_is_told_as_such() -> None:
    text = ball([1, 0, 0], [0, 0, 0]).replace("[ball, ground.table]", "[ball, ground.tabel]")
    with pytest.raises(fb.ModelError) as told:
        fb.System.from_text(text)
    [problem] = told.value.problems  # nothing is said of connections of the plane
    assert problem.message == "there is no plane ground.tabel. Did you mean ground.table?"


def rest(load: float, mu: float) -> fb.Statics:
    """A puck on a slope of 30 deg, pushed across it."""
    model = f"""
space: true
ground: {{planes: {{slope: {{normal: [sin(30 deg), cos(30 deg), 0]}}}}}}
bodies: {{puck: {{particle: {{mass: 1 kg}}}}}}
connections: {{it: {{contact: {{between: [puck, ground.slope], friction: {mu}}}}}}}
loads: {{weight: {{gravity: 9.81 m/s^2}}, push: {{force: {{at: puck, along: [0, 0, 1], magnitude: {load} N}}}}}}
"""
    return fb.System.from_text(model).statics()


def test_puck_on_a_slope_holds_within_the_circle_of_friction() -> None:
    """The resultant of m g sin(alpha) and of the push is at most mu m g cos(alpha)."""
    pressed, down = G * math.cos(math.pi / 6), G * math.sin(math.pi / 6)
    needed = math.hypot(4.0, down) / pressed
    held, slips = rest(4.0, 0.8), rest(4.0, 0.7)
    assert (held.holds, slips.holds) == (True, False)
    assert held.reserve == pytest.approx(0.8 / needed, rel=1e-6)
    assert slips.reserve == pytest.approx(0.7 / needed, rel=1e-6)


@pytest.mark.slow
def test_crate_on_four_corners_slips_when_the_push_reaches_mu_m_g() -> None:
    """Pushed obliquely through its middle it slips before it tips; how its corners share the load does not matter."""
    push = "push: {force: {at: crate, along: [0.6, 0, 0.8], magnitude: 3 N}}"
    model = TABLE.replace("}}\nloads: {", "}}\nloads: {" + push + ", ") + (
        "bodies: {crate: {box: {mass: 1 kg, size: [1 m, 1 m, 1 m]}}}\n"
        "connections: {it: {contact: {between: [crate, ground.table], friction: 0.4}}}\n"
    )
    found = fb.System.from_text(model).statics()
    assert found.holds
    assert found.reserve == pytest.approx(0.4 * G / 3.0, rel=1e-6)


def test_rolling_and_spinning_resistance_take_energy_at_the_rates_of_their_arms() -> None:
    """A ball that rolls, with arms f and s of the normal force: (1 + 2/5) m dv/dt = -f m g/R, and the spin falls by
    5/2 s g/R^2."""
    f, s, R = 1e-4, 2e-4, 0.028
    more = f", rolling_resistance: {f}, spinning_resistance: {s}"
    found = fb.System.from_text(ball([1.0, 0.0, 0.0], [0.0, 3.0, -1.0 / R], more=more)).simulate(0.5, every=0.1)
    rotation = found.course.rotation
    assert rotation is not None
    t = found.course.times
    assert found.course.velocities[:, 0, 0] == pytest.approx(1.0 - 5 / 7 * f * G / R * t, abs=1e-7)
    assert rotation.velocities[:, 0, 1] == pytest.approx(np.maximum(3.0 - 2.5 * s * G / R**2 * t, 0.0), abs=1e-7)


@pytest.mark.slow
def test_cube_that_tumbles_comes_to_lie_on_a_face() -> None:
    """It hits with corner after corner, slides on four and stops; the work of loads, friction and impacts adds up."""
    model = TABLE + (
        "bodies: {cube: {box: {mass: 0.1 kg, size: [0.05 m, 0.05 m, 0.05 m]}, at: [0, 0.3 m, 0], "
        "velocity: [0.5, 0, 0.2], angular_velocity: [3, 5, 8], turned: 20 deg about x}}\n"
        "connections: {it: {contact: {between: [cube, ground.table], friction: 0.4, restitution: 0.2}}}\n"
    )
    found = fb.System.from_text(model).simulate(0.6)
    assert str(found.status) == "finished"
    assert found.course.poses[-1, 0, 1] == pytest.approx(0.025, abs=1e-9)
    assert found.course.velocities[-1, 0] == pytest.approx(0.0, abs=1e-9)
    record = found.course.contact
    assert record is not None
    assert record.states[-1].sum() == 4
    energies = [collision.energy_change for collision in record.collisions]
    assert max(energies) <= 1e-12


def test_questions_about_a_ball_with_side_spin_have_closed_forms() -> None:
    """A ball with side spin: its slip u = v + w x r keeps its direction and ends after 2|u|/(7 mu g) (Coriolis)."""
    m, R, mu, v, back, side, g = 0.17, 0.028, 0.2, 2.0, 40.0, 30.0, 9.81
    system = fb.System.load(EXAMPLES / "ball_with_side_spin.yaml")
    u = np.array([v + R * back, -R * side])
    duration = 2 * math.hypot(*u) / (7 * mu * g)
    end = np.array([v, 0.0]) - mu * g * duration * u / math.hypot(*u)
    for question, value in (
        ("velocity of x at t = 0.6 s", end[0]),
        ("velocity of z at t = 0.6 s", end[1]),
        ("normal force of contact at start", m * g),
    ):
        [answer] = system.solve(question).answers
        assert answer.value == pytest.approx(value, rel=1e-7)
        assert answer.expression is not None
