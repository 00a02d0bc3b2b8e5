"""Motions with contact, dry friction and impacts, against closed forms and published values."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.errors import CannotAnswer
from freebody.numeric.engine.course import Status

G = 9.81
FLOOR = "ground: {lines: {floor: {along: right}}}\n"
WEIGHT = "loads: {weight: {gravity: 9.81 m/s^2}}\n"


def model(text: str) -> fb.System:
    return fb.System.from_text(text)


def kinds(result: fb.Simulation) -> list[str]:
    return [e.kind for e in result.events]


# -- slipping, then rolling -------------------------------------------------------------------
LAUNCHED = (
    """
parameters: {theta: 20 deg, mu: 0.3, v0: 2 m/s}
ground: {lines: {incline: {along: -theta}}}
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}}
connections: {contact: {contact: {between: [ball, incline], friction: mu}}}
measures: {x: travel of ball along incline}
start: {x: 0, rate(x): v0}
"""
    + WEIGHT
)


@pytest.mark.parametrize("theta", [0.0, 5.0, 20.0, 45.0, 70.0])
@pytest.mark.parametrize("times", [1.0 + 1e-4, 1.05, 1.5, 4.0])
def test_a_launched_sphere_rolls_when_the_formula_says(theta: float, times: float) -> None:
    """T = 2 v0/(g (7 mu cos - 2 sin)), v = 5 mu cos v0/(7 mu cos - 2 sin), from x' and r w under constant friction."""
    th = math.radians(theta)
    mu = times * (2 / 7) * math.tan(th) if theta else 0.2 * times
    D = 7 * mu * math.cos(th) - 2 * math.sin(th)
    T, v = 4.0 / (G * D), 10.0 * mu * math.cos(th) / D
    system = model(LAUNCHED.replace("theta: 20 deg", f"theta: {{value: {theta}, unit: deg, sign: nonnegative}}"))
    result = system.simulate(1.5 * T, values={"mu": mu}, tolerance=1e-12)
    assert kinds(result) == ["stops slipping"]
    assert result.events[0].time == pytest.approx(T, rel=1e-10)
    k = int(np.argmin(np.abs(result.course.times - T)))
    assert result.series["x"][1][k] == pytest.approx(v, rel=1e-10)
    assert result.energy.relative_error < 1e-10


def test_below_the_critical_friction_a_sphere_never_rolls() -> None:
    mu = (2 / 7) * math.tan(math.radians(20)) * (1 - 1e-9)
    result = model(LAUNCHED).simulate(100.0, values={"mu": mu})
    assert result.events == ()
    assert (result.course.contact.slips == 1).all()


@pytest.mark.parametrize(
    ("shape", "T", "v"), [("sphere", 0.728119994, 3.571428571), ("disk", 0.849473327, 3.333333333)]
)
def test_on_the_flat_slipping_ends_at_the_published_time_and_speed(shape: str, T: float, v: float) -> None:
    system = model(
        f"{FLOOR}{WEIGHT}bodies: {{b: {{{shape}: {{mass: 1 kg, radius: 0.1 m}}}}}}\n"
        "connections: {c: {contact: {between: [b, floor], friction: 0.2}}}\n"
        "measures: {x: x of b}\nstart: {x: 0, rate(x): 5 m/s}\n"
    )
    result = system.simulate(2.0, tolerance=1e-11)
    assert result.events[0].time == pytest.approx(T, abs=1e-9)
    assert result.series["x"][1][-1] == pytest.approx(v, abs=1e-9)


def test_backspin_brings_a_ball_back() -> None:
    """H about the floor is kept: v = (5 v0 - 2 r w0)/7."""
    system = model(f"""{FLOOR}{WEIGHT}
bodies: {{b: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, angular_velocity: 100 rad/s}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.2}}}}}}
measures: {{x: x of b}}
start: {{x: 0, rate(x): 2 m/s}}
""")
    result = system.simulate(3.0, tolerance=1e-11, events=["rate(x) = 0"])
    assert result.series["x"][1][-1] == pytest.approx((5 * 2 - 2 * 10) / 7, rel=1e-10)
    assert result.events[0].time == pytest.approx(2.0 / (0.2 * G), rel=1e-10)  # it turns back while slipping
    assert result.events[1].time == pytest.approx((2 + 10) / (3.5 * 0.2 * G), rel=1e-10)


@pytest.mark.parametrize("h", [0.02, 0.1 * 7 / 5, 0.19])
def test_a_billiard_ball_struck_at_height_h_rolls_at_five_sevenths_h_over_r(h: float) -> None:
    """An impulse P at height h: v0 = P/m, w0 = -P (h - r)/I; H about the cloth gives v = 5 v0 h/(7 r)."""
    r, v0 = 0.1, 3.0
    spin = -v0 * (h - r) / (0.4 * r * r)
    system = model(f"""{FLOOR}{WEIGHT}
bodies: {{b: {{sphere: {{mass: 1 kg, radius: {r} m}}, angular_velocity: {spin} rad/s}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.2}}}}}}
measures: {{x: x of b}}
start: {{x: 0, rate(x): {v0} m/s}}
""")
    result = system.simulate(4.0, tolerance=1e-11)
    assert result.series["x"][1][-1] == pytest.approx(5 * v0 * h / (7 * r), rel=1e-10)
    if h == 0.1 * 7 / 5:
        assert result.energy.work[-1] == pytest.approx(0.0, abs=1e-12)  # it rolls at once
    else:
        assert kinds(result) == ["stops slipping"]


def test_rolling_slips_under_a_push_and_rolls_again_with_one_event_each() -> None:
    """A torque M on a disk: no slip while M <= 3 mu m g r/2 ... here on from 1 s to 2 s."""
    system = model(
        f"""{FLOOR}
parameters: {{M: 6 N m, t1: 1 s}}
bodies: {{b: {{disk: {{mass: 1 kg, radius: 0.5 m}}}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.3}}}}}}
measures: {{x: x of b}}
start: {{x: 0, rate(x): 1 m/s}}
loads:
  weight: {{gravity: 9.81 m/s^2}}
  motor: {{torque: {{on: b, torque: "-M*(sign(t - t1) - sign(t - 2*t1))/2"}}}}
""".replace("on: b, torque:", "on: b, magnitude:")
    )
    result = system.simulate(4.0, tolerance=1e-10)
    # until rolling: the ball starts with no spin, so it slips first
    assert kinds(result) == ["stops slipping", "starts to slip", "stops slipping"]
    times = [e.time for e in result.events]
    assert times[1] == pytest.approx(1.0, abs=1e-6)
    # slip s' = (M/I - mu g/ (r/2)...) r - mu g: it grows for 1 s, then friction alone ends it at rate 3 mu g
    growth = 6 * 0.5 / 0.125 - 0.3 * G / 0.25 * 0.5 - 0.3 * G
    assert times[2] == pytest.approx(2.0 + growth / (3 * 0.3 * G), abs=1e-6)


# -- holding and slipping ---------------------------------------------------------------------
SLOPE = (
    """
parameters: {mu: 0.6}
ground: {lines: {slope: {along: -30 deg}}}
bodies: {b: {rectangle: {mass: 1 kg, width: 1 m, height: 0.2 m}}}
connections: {c: {contact: {between: [b, slope], friction: mu}}}
measures: {s: travel of b along slope}
start: {s: 0}
"""
    + WEIGHT
)


def test_a_block_holds_above_the_critical_friction_without_creep() -> None:
    result = model(SLOPE).simulate(100.0, values={"mu": math.tan(math.radians(30)) + 1e-9})
    assert result.events == ()
    assert abs(result.series["s"][0][-1]) < 1e-12
    assert np.abs(result.series["s"][1]).max() < 1e-15


def test_a_block_slips_below_the_critical_friction() -> None:
    mu = math.tan(math.radians(30)) - 1e-9
    result = model(SLOPE).simulate(100.0, values={"mu": mu})
    a = G * (0.5 - mu * math.cos(math.radians(30)))
    assert result.series["s"][0][-1] == pytest.approx(a * 100.0**2 / 2, rel=1e-5)


def test_static_friction_holds_what_kinetic_friction_would_not() -> None:
    text = SLOPE.replace("friction: mu", "friction: {static: mu, kinetic: 0.3}")
    assert model(text).simulate(5.0).events == ()
    moving = model(text.replace("start: {s: 0}", "start: {s: 0, rate(s): 0.1 m/s}")).simulate(5.0)
    assert moving.series["s"][2][0] == pytest.approx(G * (0.5 - 0.3 * math.cos(math.radians(30))), rel=1e-12)


def test_a_block_thrown_up_a_slope_stops_and_holds_or_slides_back() -> None:
    thrown = SLOPE.replace("start: {s: 0}", "start: {s: 0, rate(s): -3 m/s}")
    up = 3.0 / (G * (0.5 + 0.6 * math.cos(math.radians(30))))
    held = model(thrown).simulate(5.0, tolerance=1e-11)
    assert set(kinds(held)) == {"stops slipping"}
    assert held.events[0].time == pytest.approx(up, rel=1e-10)
    assert held.series["s"][1][-1] == pytest.approx(0.0, abs=1e-15)
    back = model(thrown).simulate(5.0, values={"mu": 0.4})
    assert set(kinds(back)) == {"slips back"}


def test_a_block_on_a_belt_sticks_and_slips_in_a_limit_cycle() -> None:
    """Slip at k x = mu_s m g, the slip ends where the speed is that of the belt again: x + mu_k g/w^2 mirrored."""
    system = model("""
parameters: {v: 0.2 m/s, k: 40 N/m, m: 1 kg}
bodies: {belt: {body: {mass: 1 kg, inertia: 1 kg m^2}, lines: {top: {along: right}}}, b: {particle: {mass: m}}}
connections:
  guide: {slider: {body: belt, along: right}}
  drive: {driver: {measure: x of belt, follows: v*t}}
  c: {contact: {between: [b, belt.top], friction: {static: 0.5, kinetic: 0.3}}}
measures: {u: x of b}
loads: {weight: {gravity: 9.81 m/s^2}, s: {law: {measure: u, force: -k*u}}}
start: {u: 0}
""")
    result = system.simulate(20.0, tolerance=1e-11)
    slips = [e.time for e in result.events if e.kind == "starts to slip"]
    sticks = [e.time for e in result.events if e.kind == "stops slipping"]
    w, x_s, x_k = math.sqrt(40.0), 0.5 * G / 40, 0.3 * G / 40
    # x = x_k + A cos(w t - phi) from x_s at speed v, until the speed is v again
    phi = math.atan2(0.2 / w, x_s - x_k)
    slipping = (math.pi + 2 * phi) / w
    sticking = 2 * (x_s - x_k) / 0.2
    cycles = np.diff(slips)
    assert cycles == pytest.approx(slipping + sticking, rel=1e-8)
    assert sticks[2] - slips[1] == pytest.approx(slipping, rel=1e-8)


def test_a_rod_falls_over_on_a_rough_floor_and_slips_forward_or_backward() -> None:
    """Uniform rod released upright on its end: which way its foot slips depends on mu (Beer & Johnston; critical
    0.371); friction and normal force at angle t from the vertical while it holds:
    F = (3/4) m g sin (3 cos - 2), N = (m g/4) (1 - 3 cos)^2."""
    text = f"""{FLOOR}{WEIGHT}
bodies: {{rod: {{rod: {{mass: 1 kg, length: 1 m}}, angle: 91 deg}}}}
connections: {{c: {{contact: {{between: [rod.start, floor], friction: 0.5}}}}}}
measures: {{x: x of rod.start, a: angle of rod}}
start: {{x: 0}}
"""
    result = model(text).simulate(1.5, tolerance=1e-11, events=["stop when a = 179 deg"])
    first = next(e for e in result.events if e.kind == "starts to slip")
    k = int(np.argmin(np.abs(result.course.times - first.time)))
    t, t0 = result.series["a"][0][k] - math.pi / 2, math.radians(1)
    w2 = 3 * G * (math.cos(t0) - math.cos(t))  # from energy, m l^2/3
    ax = 0.5 * (1.5 * G * math.sin(t) * math.cos(t) - w2 * math.sin(t))
    ay = -0.5 * (1.5 * G * math.sin(t) ** 2 + w2 * math.cos(t))
    assert abs(ax) / (G + ay) == pytest.approx(0.5, rel=1e-8)


def test_a_wedge_recoils_under_a_sliding_block() -> None:
    """a of the wedge = m g sin cos/(M + m sin^2), smooth."""
    system = model(
        f"""{FLOOR}{WEIGHT}
parameters: {{al: 30 deg, h: 1.1547005383792515 m}}
bodies:
  wedge:
    polygon: {{mass: 3 kg, corners: [[0, 0], [2 m, 0], [0, h]]}}
    lines: {{face: {{through: [2 m, 0], along: [-cos(al), sin(al)]}}}}
  b: {{particle: {{mass: 1 kg}}}}
connections:
  under: {{contact: {{between: [wedge, floor]}}}}
  c: {{contact: {{between: [b, wedge.face], below: true}}}}
measures: {{X: x of wedge.origin, s: travel of b along wedge.face}}
start: {{X: 0, s: 1 m}}
"""
    )
    result = system.simulate(0.3, tolerance=1e-11)
    a = -1 * G * math.sin(math.pi / 6) * math.cos(math.pi / 6) / (3 + 0.25)
    assert result.series["X"][2][0] == pytest.approx(a, rel=1e-10)
    assert result.series["X"][0][-1] == pytest.approx(a * 0.3**2 / 2, rel=1e-9)


def test_a_stack_rests_with_the_weights_above_on_every_contact() -> None:
    system = model(
        FLOOR
        + WEIGHT
        + """
bodies:
  low: {rectangle: {mass: 3 kg, width: 0.4 m, height: 0.1 m}, at: [0, 0.05 m]}
  mid: {rectangle: {mass: 2 kg, width: 0.2 m, height: 0.1 m}, at: [0, 0.15 m]}
  top: {rectangle: {mass: 1 kg, width: 0.2 m, height: 0.1 m}, at: [0, 0.25 m]}
connections: {c: {contact: {among: all, friction: 0.4}}}
"""
    )
    result = system.simulate(10.0)
    assert result.events == ()
    assert np.abs(result.course.poses - result.course.poses[0]).max() < 1e-12
    forces = dict(zip((r.name for r in system.rows), result.course.multipliers[-1], strict=True))
    for pair, weight in (({"low", "floor"}, 6), ({"mid", "low"}, 3), ({"top", "mid"}, 1)):
        normals = [b for b in system.bounds if {t.partition(".")[0].partition(" ")[0] for t in b.row.ends[:2]} == pair]
        assert sum(forces[b.name] for b in normals) == pytest.approx(weight * G, rel=1e-9)


@pytest.mark.parametrize(("push", "kind"), [(0.45, "starts to slip"), (0.9, "parts")])
def test_a_pushed_block_slides_or_tips(push: float, kind: str) -> None:
    """Pushed at height y of a block b wide: slides at F = mu m g, tips at F = m g b/(2 y)."""
    system = model(
        f"""{FLOOR}
parameters: {{F: 0 N/s}}
bodies: {{b: {{rectangle: {{mass: 1 kg, width: 0.4 m, height: 1 m}}, points: {{P: [0, {push - 0.5} m]}}}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.3}}}}}}
loads: {{weight: {{gravity: 9.81 m/s^2}}, pull: {{force: {{at: b.P, along: right, magnitude: r*t}}}}}}
""".replace("F: 0 N/s", "r: 1 N/s")
    )
    result = system.simulate(5.0, tolerance=1e-11)
    assert result.events[0].kind == kind
    limit = 0.3 * G if kind == "starts to slip" else G * 0.4 / (2 * push)
    assert result.events[0].time == pytest.approx(limit, rel=1e-9)


# -- leaving ----------------------------------------------------------------------------------
def test_a_smooth_ladder_leaves_the_wall_at_two_thirds_of_its_height() -> None:
    system = model(
        """
parameters: {L: 2 m}
ground: {lines: {floor: {along: right}, wall: {along: down}}}
bodies: {ladder: {rod: {mass: 1 kg, length: L}, angle: 110 deg}}
connections: {foot: {contact: {between: [ladder.start, floor]}}, head: {contact: {between: [ladder.end, wall]}}}
measures: {h: height of ladder.end}
"""
        + WEIGHT
    )
    result = system.simulate(0.6, tolerance=1e-12)
    left = next(e for e in result.events if e.name == "ladder.end leaves wall")
    k = int(np.argmin(np.abs(result.course.times - left.time)))
    assert result.series["h"][0][k] == pytest.approx(2 / 3 * result.series["h"][0][0], rel=1e-9)


@pytest.mark.parametrize(
    ("ball", "connection", "cosine"),
    [
        ("particle: {mass: 1 kg}", "contact: {between: [ball, hill]}", 2 / 3),
        ("sphere: {mass: 1 kg, radius: 0.1 m}", "rolling: {body: ball, on: hill}", 10 / 17),
        ("disk: {mass: 1 kg, radius: 0.1 m}", "rolling: {body: ball, on: hill}", 4 / 7),
    ],
)
def test_what_starts_at_the_top_of_a_circle_leaves_it_where_the_energy_says(
    ball: str, connection: str, cosine: float
) -> None:
    system = model(f"""
bodies: {{hill: {{disk: {{radius: 1 m}}, fixed: true}}, ball: {{{ball}}}}}
connections: {{c: {{{connection}}}}}
measures: {{phi: angle of line from ground.origin to ball from up clockwise}}
start: {{phi: 0.0001, rate(phi): 0}}
{WEIGHT}""")
    result = system.simulate(8.0, tolerance=1e-12)
    left = next(e for e in result.events if e.kind == "parts")
    k = int(np.argmin(np.abs(result.course.times - left.time)))
    start = math.cos(0.0001)
    assert math.cos(result.series["phi"][0][k]) == pytest.approx(cosine * start, rel=1e-8)


def test_a_ball_in_a_half_pipe_rolls_slips_and_rolls() -> None:
    """Rolling in a bowl needs F/N = (2/7) sin/(...) of friction: with little friction it slips high up only."""
    system = model(f"""
bodies: {{bowl: {{ring: {{radius: 1 m}}, fixed: true}}, ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}}}}}
connections: {{c: {{contact: {{between: [ball, inside bowl], friction: 0.25}}}}}}
measures: {{phi: angle of line from ground.origin to ball from down}}
start: {{phi: 75 deg, rate(phi): 0}}
{WEIGHT}""")
    result = system.simulate(2.0, tolerance=1e-10)
    assert kinds(result)[:3] == ["stops slipping", "starts to slip", "slips back"] or kinds(result)[:2] == [
        "stops slipping",
        "starts to slip",
    ]
    assert (np.diff(result.energy.kinetic + result.energy.potential) < 1e-9).all()


# -- impacts ----------------------------------------------------------------------------------
def bouncing(e: float, **more: object) -> fb.System:
    return model(f"""{FLOOR}{WEIGHT}
bodies: {{ball: {{particle: {{mass: 1 kg}}, at: [0, 1 m]}}}}
connections: {{c: {{contact: {{between: [ball, floor], restitution: {e}}}}}}}
measures: {{y: y of ball}}
""")


def test_a_bouncing_ball_comes_to_rest_at_the_limit_of_the_series() -> None:
    result = bouncing(0.8).simulate(5.0, tolerance=1e-11)
    assert result.events[-1].kind == "comes to rest"
    assert result.events[-1].time == pytest.approx(4.063712768872, abs=1e-10)
    assert len(result.events) < 100
    assert result.dataset["c.normal_force"].values[-1] == pytest.approx(G, rel=1e-12)
    assert (np.diff([e.time for e in result.events]) > 0).all()
    assert result.energy.relative_error < 1e-9


def test_without_rebound_there_is_one_impact() -> None:
    result = bouncing(0).simulate(2.0, tolerance=1e-11)
    assert [(e.kind, pytest.approx(e.time)) for e in result.events] == [("touches", math.sqrt(2 / G))]
    assert result.course.contact.collisions[0].impulses["c.contact"] == pytest.approx(math.sqrt(2 * G), rel=1e-12)


def test_a_thousand_perfect_bounces_keep_the_energy() -> None:
    result = bouncing(1).simulate(1000 * 2 * math.sqrt(2 / G), tolerance=1e-13)
    assert len(result.events) == 1000
    total = result.energy.kinetic + result.energy.potential
    assert np.abs(total - total[0]).max() < 1e-10 * G
    assert result.events[-1].time == pytest.approx(1999 * math.sqrt(2 / G), rel=1e-10)


def test_a_bar_dropped_on_its_corner_takes_the_impulse_of_the_hand_formula() -> None:
    """Sticking, e = 0: the corner stops. With r = (x, y) from the corner to the centre and K = I + m r^2, the spin is
    w+ = m v x/K clockwise for x > 0, and the impulse is m (v+ - v)."""
    system = model(f"""{FLOOR}{WEIGHT}
bodies: {{bar: {{rectangle: {{mass: 2 kg, width: 1 m, height: 0.2 m}}, at: [0, 1 m], angle: 25 deg}}}}
connections: {{c: {{contact: {{between: [bar, floor], friction: 5}}}}}}
""")
    result = system.simulate(1.0, tolerance=1e-11)
    hit = result.course.contact.collisions[0]
    c, s = math.cos(math.radians(25)), math.sin(math.radians(25))
    x, y = 0.5 * c - 0.1 * s, 0.5 * s + 0.1 * c  # corner bottom_left to centre
    drop = 1.0 - y
    v, inertia = math.sqrt(2 * G * drop), 2 * (1 + 0.04) / 12
    w = -2 * v * x / (inertia + 2 * (x * x + y * y))
    normal, friction = 2 * (w * x + v), 2 * (-w * y)
    name = next(iter(hit.impulses))
    assert hit.impulses[name] == pytest.approx(normal, rel=1e-9)
    assert next(v for v in hit.friction.values() if v) == pytest.approx(friction, rel=1e-9)
    lost = 0.5 * 2 * v * v - 0.5 * (inertia + 2 * (x * x + y * y)) * w * w
    assert hit.energy_change == pytest.approx(-lost, rel=1e-9)


@pytest.mark.parametrize("mu", [0.0, 0.1, 2.0])
def test_two_spinning_disks_collide_with_coulomb_friction_and_keep_their_momenta(mu: float) -> None:
    """Tangential impulse: mu P while slip lasts, at most v_t m/6 (two equal disks: 1/(2/m + 2 R^2/I) = m/6)."""
    system = model(f"""
bodies:
  a: {{disk: {{mass: 1 kg, radius: 0.1 m}}, at: [-0.5 m, 0], velocity: [2 m/s, 0], angular_velocity: 30 rad/s}}
  b: {{disk: {{mass: 1 kg, radius: 0.1 m}}, at: [0.5 m, 0], velocity: [-1 m/s, 0]}}
connections: {{c: {{contact: {{between: [a, b], friction: {mu}, restitution: 0.6}}}}}}
""")
    result = system.simulate(1.0, tolerance=1e-11)
    v = result.course.velocities[-1]
    normal = 1.6 * 3.0 / 2
    tangential = min(mu * normal, 3.0 / 6)
    assert v[0, 0] == pytest.approx(2 - normal, rel=1e-10)
    assert v[1, 0] == pytest.approx(-1 + normal, rel=1e-10)
    assert abs(v[0, 1]) == pytest.approx(tangential, abs=1e-10)
    assert v[0, 1] == pytest.approx(-v[1, 1], abs=1e-12)
    m, inertia = 1.0, 0.005
    x, y = result.course.poses[-1, :2, 0], result.course.poses[-1, :2, 1]
    spin = sum(m * (x[k] * v[k, 1] - y[k] * v[k, 0]) + inertia * v[k, 2] for k in range(2))
    assert spin == pytest.approx(inertia * 30, rel=1e-10)


def test_a_domino_topples_the_next() -> None:
    system = model(
        FLOOR
        + WEIGHT
        + """
bodies:
  d1: {rectangle: {mass: 1 kg, width: 0.02 m, height: 0.1 m}, at: {bottom_right: [0, 0]}, angle: -15 deg}
  d2: {rectangle: {mass: 1 kg, width: 0.02 m, height: 0.1 m}, at: {bottom_left: [0.05 m, 0]}}
connections: {c: {contact: {among: all, friction: 0.5}}}
measures: {a: angle of d2}
"""
    )
    result = system.simulate(1.0, tolerance=1e-10)
    assert any("d1.top_right" in e.name and "d2" in e.name for e in result.events)
    assert result.series["a"][0][-1] < -1.0
    assert result.status is Status.FINISHED


# -- strings and stops ------------------------------------------------------------------------
def test_an_atwood_string_goes_slack_and_taut_again() -> None:
    """a lands after t1 = sqrt(2 h/a); b flies on, and the string is taut again after 2 v/g."""
    text = (
        """
ground: {lines: {floor: {along: right}}, points: {axle: [0, 3 m]}}
bodies:
  p: {disk: {radius: 0.2 m}, fixed: true, at: [0, 3 m]}
  a: {particle: {mass: 2 kg}, at: [-0.2 m, 1 m]}
  b: {particle: {mass: 1 kg}, at: [0.2 m, 1 m]}
connections: {rope: {string: {from: a, over: [p], to: b}}, c: {contact: {between: [a, floor]}}}
"""
        + WEIGHT
    )
    result = model(text).simulate(1.9, tolerance=1e-11)
    a = G / 3
    t1, v = math.sqrt(2 / a), math.sqrt(2 * a)
    times = {e.name: e.time for e in reversed(result.events)}
    assert times["rope goes slack"] == pytest.approx(t1, rel=1e-9)
    assert times["rope goes taut"] == pytest.approx(t1 + 2 * v / G, rel=1e-9)
    # the jerk: b falls with v, a rests: both move with m_b v/(m_a + m_b)
    jerk = next(c for c in result.course.contact.collisions if c.time > t1 + 0.1)
    assert jerk.impulses["rope.length"] == pytest.approx(2 * v / 3, rel=1e-9)
    assert kinds(result).count("parts") == 1


def test_a_stop_reflects_a_pendulum() -> None:
    system = model(f"""
bodies: {{rod: {{rod: {{mass: 1 kg, length: 1 m}}, angle: -60 deg}}}}
connections: {{p: {{pin: [ground.A, rod.start]}}, s: {{stop: {{measure: a, min: -90 deg, restitution: 0.5}}}}}}
measures: {{a: angle of rod}}
{WEIGHT}""")
    result = system.simulate(3.0, tolerance=1e-11)
    hit = result.course.contact.collisions[0]
    w = math.sqrt(3 * G * (1 - math.cos(math.radians(30))))
    assert hit.before["s.min"] == pytest.approx(-w, rel=1e-9)
    assert hit.after["s.min"] == pytest.approx(0.5 * w, rel=1e-9)
    assert (result.series["a"][0] >= -math.pi / 2 - 1e-9).all()


# -- dry joints -------------------------------------------------------------------------------
def test_a_brake_stops_a_drum_when_its_momentum_is_used_up() -> None:
    system = model("""
bodies: {drum: {disk: {mass: 2 kg, radius: 0.2 m}, angular_velocity: 10 rad/s}}
connections: {p: {pin: [ground.A, drum]}, b: {brake: {between: [drum, ground], torque: 0.1 N m}}}
""")
    result = system.simulate(10.0, tolerance=1e-11)
    assert [(e.kind, e.time) for e in result.events] == [("stops slipping", pytest.approx(0.04 * 10 / 0.1, rel=1e-10))]
    assert result.energy.work[-1] == pytest.approx(-0.5 * 0.04 * 100, rel=1e-10)


def test_a_clutch_brings_two_wheels_to_the_common_speed() -> None:
    system = model("""
parameters: {T0: 0.2 N m/s}
bodies:
  a: {disk: {mass: 2 kg, radius: 0.2 m}, angular_velocity: 30 rad/s}
  b: {disk: {mass: 1 kg, radius: 0.2 m}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.A, b]}, c: {brake: {between: [a, b], torque: T0*t}}}
""")
    result = system.simulate(10.0, tolerance=1e-11)
    # 1/I of the slip: 1/0.04 + 1/0.02; T0 t^2/2 (1/I) = 30
    assert result.events[0].time == pytest.approx(math.sqrt(2 * 30 / (0.2 * 75)), rel=1e-9)
    assert result.course.velocities[-1, :2, 2] == pytest.approx([20.0, 20.0], rel=1e-10)


def test_friction_in_a_slider_and_in_a_pin() -> None:
    slider = model(f"""
bodies: {{b: {{particle: {{mass: 1 kg}}}}}}
connections: {{s: {{slider: {{body: b, along: right, friction: 0.2}}}}}}
measures: {{x: x of b}}
start: {{x: 0, rate(x): 3 m/s}}
{WEIGHT}""").simulate(5.0, tolerance=1e-11)
    assert slider.events[0].time == pytest.approx(3.0 / (0.2 * G), rel=1e-10)
    pin = model(f"""
bodies: {{w: {{disk: {{mass: 3 kg, radius: 0.2 m}}, angular_velocity: 10 rad/s}}}}
connections: {{p: {{pin: {{first: ground.A, second: w, friction: 0.1, radius: 0.02 m}}}}}}
{WEIGHT}""").simulate(60.0, tolerance=1e-11)
    assert pin.events[0].time == pytest.approx(0.06 * 10 / (0.1 * 0.02 * 3 * G), rel=1e-10)


# -- named states -----------------------------------------------------------------------------
def painleve(mu: float, theta: float, **options: object) -> fb.Simulation:
    """A rod whose foot slides towards its leaning side."""
    return model(f"""{FLOOR}{WEIGHT}
parameters: {{th: {theta} deg}}
bodies: {{rod: {{rod: {{mass: 1 kg, length: 2 m}}, angle: pi - th, angular_velocity: 0}}}}
connections: {{c: {{contact: {{between: [rod.start, floor], friction: {mu}}}}}}}
measures: {{x: x of rod.start}}
start: {{x: 0, rate(x): 1 m/s}}
""").simulate(0.3, **options)  # type: ignore[arg-type]


@pytest.mark.parametrize(("mu", "theta"), [(1.3, 63.435), (1.4, 55.58), (1.4, 69.96), (1.0, 65.0)])
def test_outside_of_its_region_the_sliding_rod_has_one_consistent_force(mu: float, theta: float) -> None:
    assert painleve(mu, theta).status is Status.FINISHED


@pytest.mark.parametrize(("mu", "theta"), [(1.34, 63.435), (1.4, 55.60), (1.4, 65.0), (1.4, 69.94)])
def test_inside_of_it_there_is_none_and_the_message_offers_what_to_do(mu: float, theta: float) -> None:
    result = painleve(mu, theta)
    assert result.status is Status.INCONSISTENT
    assert "Painleve" in result.message
    assert "impulse" in result.message
    jammed = painleve(mu, theta, jams=True)
    assert jammed.status is Status.FINISHED
    assert jammed.events[0].kind == "jams"
    assert jammed.energy.work[-1] < 0.0


def test_a_table_on_three_legs_in_line_has_no_unique_reactions_and_says_so() -> None:
    system = model(
        FLOOR
        + WEIGHT
        + """
bodies:
  table:
    body: {mass: 3 kg, inertia: 1 kg m^2}
    points: {A: [-1 m, -1 m], B: [0, -1 m], C: [1 m, -1 m]}
    at: [0, 1 m]
connections:
  a: {contact: {between: [table.A, floor]}}
  b: {contact: {between: [table.B, floor]}}
  c: {contact: {between: [table.C, floor]}}
"""
    )
    result = system.simulate(1.0)
    assert result.events == ()
    assert not result.course.unique[-1].any()
    assert result.course.multipliers[-1].sum() == pytest.approx(3 * G, rel=1e-9)


def test_a_start_inside_another_body_is_named_with_its_depth() -> None:
    text = (
        FLOOR
        + WEIGHT
        + """
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}, at: [0, 0.07 m]}}
connections: {c: {contact: {between: [ball, floor]}}}
"""
    )
    with pytest.raises(CannotAnswer, match=r"ball is 0\.03 m inside floor"):
        model(text).simulate(1.0)
    freed = text.replace("between: [ball, floor]", "between: [ball, floor], touching: true").replace(
        "at:", "near: {at:"
    )
    freed = freed.replace("0.07 m]}", "0.07 m]}}")
    assert model(freed).simulate(0.1).course.poses[0, 0, 1] == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("contact", "message"),
    [
        ("between: [ball, floor], restitution: 1.2", "restitution is 1.2"),
        ("between: [ball, floor], friction: -0.1", "friction is negative"),
        ("between: [ball, floor], friction: {static: 0.2, kinetic: 0.3}", "smaller than kinetic"),
        ("between: [ball, ceiling]", "no body or line ceiling"),
        ("between: [floor, floor]", "both are fixed"),
        ("between: [ball]", "between takes two"),
        ("friction: 0.2", "say what touches"),
        ("between: [thing, floor]", "no outline"),
        ("between: [ball, floor], fricton: 0.2", "friction"),
    ],
)
def test_what_makes_no_sense_is_said(contact: str, message: str) -> None:
    with pytest.raises(fb.ModelError, match=message):
        model(
            FLOOR
            + f"""
bodies: {{ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}}}, thing: {{body: {{mass: 1 kg, inertia: 1 kg m^2}}}}}}
connections: {{c: {{contact: {{{contact}}}}}}}
"""
        )


# -- identities -------------------------------------------------------------------------------
def test_a_mirrored_model_has_mirrored_events() -> None:
    def thrown(side: int) -> fb.Simulation:
        return model(f"""{FLOOR}{WEIGHT}
bodies: {{b: {{rectangle: {{mass: 1 kg, width: 0.4 m, height: 0.2 m}}, at: [0, 1 m], angle: {side * 20} deg,
             velocity: [{side * 2} m/s, 0], angular_velocity: {side * 3} rad/s}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.3, restitution: 0.4}}}}}}
""").simulate(1.0, tolerance=1e-11)

    one, other = thrown(1), thrown(-1)
    assert [e.time for e in one.events] == pytest.approx([e.time for e in other.events], rel=1e-9)
    swapped = [e.name.replace("left", "@").replace("right", "left").replace("@", "right") for e in other.events]
    assert sorted(e.name for e in one.events) == sorted(swapped)


def test_friction_never_gives_energy_and_the_balance_holds_through_impacts() -> None:
    result = model(f"""{FLOOR}{WEIGHT}
bodies:
  b: {{rectangle: {{mass: 1 kg, width: 0.4 m, height: 0.2 m}}, at: [0, 1 m], angle: 20 deg, velocity: [3 m/s, 0]}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.3, restitution: 0.4}}}}}}
""").simulate(2.0, tolerance=1e-11)
    assert result.energy.relative_error < 1e-8
    assert (np.diff(result.energy.work) < 1e-12).all()
    assert result.course.poses[-1, 0, 1] == pytest.approx(0.1, abs=1e-9)
    assert all(c.energy_change <= 1e-15 for c in result.course.contact.collisions)


def test_reactions_that_are_not_unique_have_a_range() -> None:
    legs = model(
        FLOOR
        + WEIGHT
        + """
bodies:
  table:
    body: {mass: 3 kg, inertia: 1 kg m^2}
    points: {A: [-1 m, -1 m], B: [0, -1 m], C: [1 m, -1 m]}
    at: [0, 1 m]
connections:
  a: {contact: {between: [table.A, floor]}}
  b: {contact: {between: [table.B, floor]}}
  c: {contact: {between: [table.C, floor]}}
"""
    ).simulate(1.0)
    ranges = legs.reaction_ranges()
    assert ranges["a.contact"] == pytest.approx((0.0, 1.5 * G), abs=1e-9)
    assert ranges["b.contact"] == pytest.approx((0.0, 3 * G), abs=1e-9)
    wedged = model(
        WEIGHT
        + """
ground: {lines: {left: {through: [0, 0], along: down}, right: {through: [0.4 m, 0], along: up}}}
bodies: {b: {rectangle: {mass: 2 kg, width: 0.4 m, height: 0.4 m}, at: [0.2 m, 0], angle: 0}}
connections:
  l: {contact: {between: [b, left], friction: 0.5}}
  r: {contact: {between: [b, right], friction: 0.5}}
"""
    ).simulate(1.0)
    high = [high for name, (_low, high) in wedged.reaction_ranges().items() if "slip" not in name]
    assert high == [math.inf] * 4
    assert "b.contact between" in repr(legs)


def test_the_dataset_has_contact_states_and_the_used_part_of_friction() -> None:
    data = model(LAUNCHED).simulate(0.6, every=0.1).dataset
    states = data["contact.state"]
    meanings = states.attrs["flag_meanings"].split()
    assert [meanings[k] for k in states.values[[0, -1]]] == ["sliding_forward", "sticking"]
    needed = (2 / 7) * math.tan(math.radians(20)) / 0.3
    assert data["contact.used_friction"].values[[0, -1]] == pytest.approx([1.0, needed], rel=1e-9)
    assert data["contact.friction_force"].values[0] == pytest.approx(-0.3 * G * math.cos(math.radians(20)), rel=1e-12)


def test_a_block_held_by_nothing_but_the_walls_may_stay_or_fall_and_says_so() -> None:
    wedged = model(
        WEIGHT
        + """
ground: {lines: {left: {through: [0, 0], along: down}, right: {through: [0.4 m, 0], along: up}}}
bodies: {b: {rectangle: {mass: 2 kg, width: 0.4 m, height: 0.4 m}, at: [0.2 m, 0], angle: 0}}
connections:
  l: {contact: {between: [b, left], friction: 0.5}}
  r: {contact: {between: [b, right], friction: 0.5}}
"""
    ).simulate(0.2)
    assert "several outcomes" in wedged.message
    assert np.abs(wedged.course.velocities).max() < 1e-12


def test_kellers_law_gives_way_where_it_has_more_than_one_friction_to_follow_and_says_so() -> None:
    text = f"""{FLOOR}{WEIGHT}
bodies: {{b: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: [0, 1 m], velocity: [2 m/s, 0]}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.4, restitution: 0.5, rolling_resistance: 0.01 m}}}}}}
"""
    result = model(text).simulate(1.0, impact="keller")
    assert result.status is Status.FINISHED
    assert "Poisson's took over" in result.message
    alone = model(text.replace(", rolling_resistance: 0.01 m", "")).simulate(1.0, impact="keller")
    assert alone.message == ""


def test_friction_brings_a_crate_to_the_speed_of_a_belt_however_it_bounces() -> None:
    """The impulses of all normal forces from the release to the rest are m g t, so m v = mu m g t."""
    result = model(
        WEIGHT
        + """
parameters: {v: 1.5 m/s}
bodies:
  belt: {body: {mass: 1 kg, inertia: 1 kg m^2}, lines: {top: {along: right}}}
  crate: {rectangle: {mass: 5 kg, width: 0.4 m, height: 0.2 m}, at: [0, 0.3 m]}
connections:
  guide: {slider: {body: belt, along: right}}
  motor: {driver: {measure: x of belt, follows: v*t}}
  c: {contact: {between: [crate, belt.top], friction: 0.4, restitution: 0.2}}
"""
    ).simulate(1.0, tolerance=1e-11)
    times = [e.time for e in result.events if e.kind == "stops slipping"]
    assert times == pytest.approx([1.5 / (0.4 * G)] * 2, rel=1e-9)


def test_rolling_resistance_brings_a_ball_to_rest() -> None:
    """(m + I/r^2) x'' = -f m g/r: x'' = -5 f g/(7 r)."""
    result = model(
        f"""{FLOOR}{WEIGHT}
bodies: {{b: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, angular_velocity: -14 rad/s}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.5, rolling_resistance: 0.01 m}}}}}}
measures: {{x: x of b}}
start: {{x: 0, rate(x): 1.4 m/s}}
"""
    ).simulate(4.0, tolerance=1e-11)
    a = 5 * 0.01 * G / 0.7
    assert [(e.name, e.time) for e in result.events] == [("b stops rolling on floor", pytest.approx(1.4 / a, rel=1e-9))]
    assert result.series["x"][0][-1] == pytest.approx(1.4**2 / (2 * a), rel=1e-9)


def test_what_cannot_touch_is_named() -> None:
    with pytest.raises(CannotAnswer, match=r"rod and ground cannot touch at the start \((r|l)\)"):
        model(
            """
ground: {lines: {left: {along: down}, right: {through: [3 m, 0], along: up}}}
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {l: {contact: {between: [rod.start, left]}}, r: {contact: {between: [rod.end, right]}}}
"""
        ).simulate(1.0)


def test_where_nothing_touches_there_are_no_ranges() -> None:
    ball = """
bodies: {ball: {disk: {mass: 1 kg, radius: 0.1 m}, at: [0, 1 m], angle: 0}}
ground: {lines: {floor: {through: [0, 0], angle: 0 deg}}}
connections: {it: {contact: {between: [ball, ground.floor], friction: 0.3}}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
    assert fb.System.from_text(ball).simulate(0.1).reaction_ranges() == {}
