"""Identities of motions with contact: momentum, mirrors, turned and moved frames, units, continued runs; and cases that
lie on an edge: grazing, touches at the first and last instant, several at once, gaps that are zero throughout."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.engine.course import Status

G = 9.81
FLOOR = "ground: {lines: {floor: {along: right}}}\n"
WEIGHT = "loads: {weight: {gravity: 9.81 m/s^2}}\n"


def model(text: str) -> fb.System:
    return fb.System.from_text(text)


def kinds(result: fb.Simulation) -> list[str]:
    return [e.kind for e in result.events]


# -- momentum ---------------------------------------------------------------------------------
TUMBLING = f"""{FLOOR}{WEIGHT}
bodies:
  b: {{rectangle: {{mass: 2 kg, width: 0.4 m, height: 0.2 m}}, at: [0, 0.6 m], angle: 20 deg, velocity: [2 m/s, 0]}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.3, restitution: 0.3}}}}}}
"""


def test_impulses_and_forces_of_contacts_make_up_the_change_of_momentum() -> None:
    """int N dt + sum P = m (v1 - v0) + m g T, and the same along the floor."""
    result = model(TUMBLING).simulate(1.5, tolerance=1e-11, every=1.5 / 30_000)
    course, m = result.course, 2.0
    names = [row.name for row in result.system.rows]
    normals = [k for k, n in enumerate(names) if n in course.contact.bounds]
    slips = [k for k, n in enumerate(names) if n in course.contact.dry_friction]
    # forces jump at events only, where the course has the state after it: left sums
    widths = np.diff(course.times)
    up, along = (float((course.multipliers[:-1, places].sum(axis=1) * widths).sum()) for places in (normals, slips))
    hit_up = sum(sum(c.impulses.values()) for c in course.contact.collisions)
    hit_along = sum(sum(c.friction.values()) for c in course.contact.collisions)
    v0, v1 = course.velocities[0, 0], course.velocities[-1, 0]
    assert up + hit_up == pytest.approx(m * (v1[1] - v0[1]) + m * G * 1.5, abs=2e-3)
    assert along + hit_along == pytest.approx(m * (v1[0] - v0[0]), abs=2e-3)
    assert abs(hit_along) > 0.1


def test_two_tolerances_give_the_same_events() -> None:
    one, other = (model(TUMBLING).simulate(1.5, tolerance=tolerance) for tolerance in (1e-8, 1e-12))
    assert [e.name for e in one.events] == [e.name for e in other.events]
    assert [e.time for e in one.events] == pytest.approx([e.time for e in other.events], abs=1e-6)


def test_a_continued_run_is_the_run_at_once() -> None:
    whole = model(TUMBLING).simulate(1.5, tolerance=1e-11)
    parts = model(TUMBLING).simulate(0.31, tolerance=1e-11)
    names = [e.name for e in parts.events]
    for until in (0.47, 0.83, 1.5):
        parts = parts.continued(until)
        names += [e.name for e in parts.events]
    assert names == [e.name for e in whole.events]
    assert parts.course.poses[-1] == pytest.approx(whole.course.poses[-1], abs=1e-8)


# -- frames and units -------------------------------------------------------------------------
def turned(angle: float) -> fb.Simulation:
    """A box thrown on an incline, the whole scene turned, with the weight as a force."""
    c, s = math.cos(angle), math.sin(angle)
    x, y, vx, vy = -0.3 * s, 0.3 * c, 1.5 * c, 1.5 * s
    return model(f"""
ground: {{lines: {{floor: {{along: {angle!r} rad}}}}}}
bodies:
  b: {{rectangle: {{mass: 1 kg, width: 0.4 m, height: 0.2 m}}, at: [{x!r}, {y!r}], angle: {angle + 0.4!r} rad,
      velocity: [{vx!r} m/s, {vy!r} m/s]}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.4, restitution: 0.4}}}}}}
loads: {{w: {{force: {{at: b, along: {angle - math.pi / 2!r} rad, magnitude: 9.81 N}}}}}}
""").simulate(1.0, tolerance=1e-11)


def test_a_scene_that_is_turned_moves_alike() -> None:
    level, tilted = turned(0.0), turned(0.7)
    assert [e.name for e in tilted.events] == [e.name for e in level.events]
    assert [e.time for e in tilted.events] == pytest.approx([e.time for e in level.events], abs=1e-7)
    c, s = math.cos(0.7), math.sin(0.7)
    x, y, a = level.course.poses[-1, 0]
    assert tilted.course.poses[-1, 0] == pytest.approx([c * x - s * y, s * x + c * y, a + 0.7], abs=1e-6)


def test_a_scene_on_a_cart_that_moves_steadily_moves_alike() -> None:
    def on_cart(v: float) -> fb.Simulation:
        return model(f"""
bodies:
  cart: {{body: {{mass: 5 kg, inertia: 1 kg m^2}}, lines: {{deck: {{along: right}}}}, at: [0, 0]}}
  b: {{rectangle: {{mass: 1 kg, width: 0.4 m, height: 0.2 m}}, at: [0, 0.5 m], angle: 10 deg,
      velocity: [{1 + v} m/s, 0]}}
connections:
  guide: {{slider: {{body: cart, along: right}}}}
  drive: {{driver: {{measure: x of cart, follows: v*t}}}}
  c: {{contact: {{between: [b, cart.deck], friction: 0.4, restitution: 0.4}}}}
parameters: {{v: {{value: {v}, unit: m/s, sign: any}}}}
{WEIGHT}""").simulate(1.0, tolerance=1e-11)

    still, moving = on_cart(0.0), on_cart(3.0)
    assert [e.name for e in moving.events] == [e.name for e in still.events]
    assert [e.time for e in moving.events] == pytest.approx([e.time for e in still.events], abs=1e-7)
    k = [b.name for b in still.system.moving].index("b")
    assert moving.course.poses[-1, k, 0] - 3.0 == pytest.approx(still.course.poses[-1, k, 0], abs=1e-7)


@pytest.mark.parametrize(("length", "mass"), [(1.0, 1e-9), (1.0, 1e9), (1e-6, 1.0), (1e-3, 1e3), (1e6, 1.0)])
def test_units_of_mass_and_length_do_not_matter(length: float, mass: float) -> None:
    """Lengths times l and times times sqrt(l): the same motion with the same g."""

    def scaled(k: float, m: float) -> fb.Simulation:
        t = math.sqrt(k)
        return model(f"""{FLOOR}{WEIGHT}
bodies:
  b: {{rectangle: {{mass: {m!r} kg, width: {0.4 * k!r} m, height: {0.2 * k!r} m}}, at: [0, {0.6 * k!r} m],
      angle: 20 deg, velocity: [{2 * t!r} m/s, 0]}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.3, restitution: 0.3}}}}}}
""").simulate(1.5 * t, tolerance=1e-11)

    unit, other = scaled(1.0, 1.0), scaled(length, mass)
    assert other.status is Status.FINISHED
    assert [e.name for e in other.events] == [e.name for e in unit.events]
    scale = math.sqrt(length)
    assert [e.time / scale for e in other.events] == pytest.approx([e.time for e in unit.events], abs=1e-6)


# -- on the edge ------------------------------------------------------------------------------
@pytest.mark.parametrize("beside", [-1e-9, 1e-9])
def test_a_ball_that_just_touches_a_corner_is_seen_and_one_that_just_passes_is_not(beside: float) -> None:
    """A ball falls past the corner of a fixed block, by a nanometre too near or too far."""
    result = model(f"""
bodies:
  block: {{rectangle: {{width: 0.4 m, height: 0.2 m}}, at: [0, 0], angle: 0, fixed: true}}
  ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: [{0.3 + beside!r}, 0.5 m]}}
connections: {{c: {{contact: {{between: [ball, block], restitution: 1}}}}}}
{WEIGHT}""").simulate(0.5, tolerance=1e-12)
    assert (kinds(result) == ["rebounds"]) is (beside < 0.0)
    assert result.status is Status.FINISHED


@pytest.mark.parametrize("above", [-2e-9, 2e-9])
def test_a_stop_is_met_or_just_missed_at_the_turning_point(above: float) -> None:
    """Thrown up with v it turns at v^2/(2 g): a stop two nanometres below or above. One nanometre is what the search
    takes for a touch, so there round-off would decide."""
    top = 2.0**2 / (2 * G) + above
    result = model(f"""
bodies: {{p: {{particle: {{mass: 1 kg}}, at: [0, 0], velocity: [0, 2 m/s]}}}}
measures: {{y: y of p}}
connections: {{rail: {{slider: {{body: p, along: up}}}}, s: {{stop: {{measure: y, max: {top!r} m, restitution: 0.5}}}}}}
{WEIGHT}""").simulate(0.4, tolerance=1e-13)
    # a rebound too small to be seen rests for the instant
    assert bool(result.course.contact.collisions) is (above < 0.0)
    assert result.status is Status.FINISHED
    assert result.series["y"][0][-1] == pytest.approx(2.0 * 0.4 - 0.5 * G * 0.16, abs=2e-4)


def test_a_touch_at_the_start_is_an_impact_there() -> None:
    result = model(f"""{FLOOR}{WEIGHT}
bodies: {{ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: [0, 0.1 m], velocity: [0, -1 m/s]}}}}
connections: {{c: {{contact: {{between: [ball, floor], restitution: 0.5}}}}}}
""").simulate(0.05)
    assert [(e.kind, e.time) for e in result.events] == [("rebounds", 0.0)]
    assert result.course.velocities[0, 0, 1] == pytest.approx(0.5, rel=1e-12)


@pytest.mark.parametrize("shift", [0.0, -1e-12, 1e-12])
def test_a_touch_at_the_end_time_ends_the_motion_well(shift: float) -> None:
    end = math.sqrt(2.0 / G) + shift
    result = model(f"""{FLOOR}{WEIGHT}
bodies: {{p: {{particle: {{mass: 1 kg}}, at: [0, 1 m]}}}}
connections: {{c: {{contact: {{between: [p, floor], restitution: 0.5}}}}}}
""").simulate(end, tolerance=1e-12)
    assert result.status is Status.FINISHED
    assert result.t_end == end
    assert len(result.events) <= 1
    assert (np.diff(result.course.times) > 0.0).all()


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_a_box_that_lands_flat_touches_with_both_corners_at_once(e: float) -> None:
    """Symmetric: it does not turn. Newton's law for each corner is that for the box."""
    result = model(f"""{FLOOR}{WEIGHT}
bodies: {{b: {{rectangle: {{mass: 1 kg, width: 0.4 m, height: 0.2 m}}, at: [0, 0.6 m], angle: 0}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.4, restitution: {e}}}}}}}
""").simulate(0.5, tolerance=1e-12)
    hit = result.course.contact.collisions[0]
    assert len(hit.impulses) == 2
    assert sum(hit.impulses.values()) == pytest.approx((1 + e) * math.sqrt(2 * G * 0.5), rel=1e-9)
    assert np.abs(result.course.poses[:, 0, 2]).max() < 1e-9
    times = {e.time for e in result.events}
    assert len(result.events) == 2 * len(times)


def test_a_gap_that_is_zero_throughout_without_load_is_no_event() -> None:
    """A puck slides along a wall that it touches and does not press; nothing happens."""
    result = model("""
ground: {lines: {wall: {along: right}}}
bodies: {puck: {disk: {mass: 1 kg, radius: 0.1 m}, at: [0, 0.1 m], velocity: [1 m/s, 0]}}
connections: {c: {contact: {between: [puck, wall], friction: 0.3}}}
""").simulate(5.0)
    assert result.status is Status.FINISHED
    assert result.events == ()
    assert result.course.poses[-1, 0, :2] == pytest.approx([5.0, 0.1], abs=1e-12)


def test_a_thousand_bounces_between_two_stops_keep_the_energy() -> None:
    result = model("""
bodies: {p: {particle: {mass: 1 kg}, at: [0, 0], velocity: [1 m/s, 0]}}
measures: {x: x of p}
connections: {rail: {slider: {body: p, along: right}},
              s: {stop: {measure: x, min: -0.5 m, max: 0.5 m, restitution: 1}}}
""").simulate(1000.0)
    assert len(result.events) == 1000
    assert abs(result.course.velocities[-1, 0, 0]) == pytest.approx(1.0, rel=1e-12)


# -- from one place to the next ---------------------------------------------------------------
def test_a_ball_rolls_over_the_edge_of_a_table() -> None:
    """It rolls about the edge and leaves where g cos a = v^2/R, all with the energy of rolling."""
    result = model(f"""
bodies:
  table: {{rectangle: {{width: 2 m, height: 1 m}}, at: [-1 m, -0.5 m], angle: 0, fixed: true}}
  ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: [-0.5 m, 0.1 m], velocity: [0.3 m/s, 0],
         angular_velocity: -3 rad/s}}
connections: {{c: {{contact: {{between: [ball, table], friction: 2}}}}}}
measures: {{a: angle of line from table.top_right to ball from up clockwise}}
{WEIGHT}""").simulate(2.3, tolerance=1e-12)
    first = result.events[0]
    assert first.kind in ("parts", "starts to slip")
    k = int(np.argmin(np.abs(result.course.times - first.time)))
    assert result.series["a"][0][k] > 0.2  # it went some way about the edge, and nobody saw another place
    x, y = result.course.poses[k, 0, :2]
    assert math.hypot(x, y) == pytest.approx(0.1, abs=1e-9)


def test_a_ball_rolls_from_a_slope_into_the_floor_and_stops_in_a_corner() -> None:
    result = model(f"""
ground:
  lines: {{slope: {{through: [0, 0], along: -30 deg}}, floor: {{through: [1 m, -0.3 m], along: right}},
          wall: {{through: [2 m, 0], along: up}}}}
bodies: {{ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: [-0.5 m, 1 m]}}}}
connections: {{c: {{contact: {{among: all, friction: 0.5, restitution: 0}}}}}}
{WEIGHT}""").simulate(6.0, tolerance=1e-10)
    assert result.status is Status.FINISHED
    assert result.energy.relative_error < 1e-8
    assert any(e.name == "ball touches wall" for e in result.events)
    heights = result.course.poses[:, 0, 1]
    assert heights.min() > -0.2 - 1e-9


def test_a_wheel_climbs_a_step() -> None:
    """H about the edge: omega+ = omega (1 - 2 h/(3 R)) of a disk that holds; it climbs if that lifts it by h."""
    text = f"""{FLOOR}
bodies:
  step: {{rectangle: {{width: 1 m, height: 0.1 m}}, at: [1 m, 0.05 m], angle: 0, fixed: true}}
  wheel: {{disk: {{mass: 1 kg, radius: 0.5 m}}, at: [-0.5 m, 0.5 m], velocity: [V m/s, 0], angular_velocity: -W rad/s}}
connections:
  c: {{contact: {{between: [wheel, floor], friction: 3}}}}
  d: {{contact: {{between: [wheel, step], friction: 3}}}}
{WEIGHT}"""
    # 3/4 m v^2 (1 - 2 h/(3 R))^2 = m g h
    critical = math.sqrt(G * 0.1 / 0.75) / (1 - 2 * 0.1 / 1.5)
    for v, climbs in ((critical * 1.01, True), (critical * 0.99, False)):
        result = model(text.replace("V m", f"{v!r} m").replace("W rad", f"{v / 0.5!r} rad")).simulate(
            3.0, tolerance=1e-11
        )
        hit = result.course.contact.collisions[0]
        k = int(np.argmin(np.abs(result.course.times - hit.time)))
        place = [b.name for b in result.system.moving].index("wheel")
        assert result.course.velocities[k, place, 2] == pytest.approx(-v / 0.5 * (1 - 2 * 0.1 / 1.5), rel=1e-9)
        assert bool(result.course.poses[:, place, 0].max() > 0.6) is climbs


def test_a_ball_rolls_from_a_line_onto_a_circle() -> None:
    """A line that is tangent at the top of a fixed cylinder, from the left: the ball goes on rolling on the circle."""
    result = model(f"""
bodies:
  bench: {{rectangle: {{width: 1 m, height: 0.2 m}}, at: [-0.5 m, -0.1 m], angle: 0, fixed: true}}
  drum: {{disk: {{radius: 1 m}}, at: [0, -1 m], fixed: true}}
  ball: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: [-0.4 m, 0.1 m], velocity: [0.4 m/s, 0],
         angular_velocity: -4 rad/s}}
connections: {{c: {{contact: {{among: all, friction: 1}}}}}}
measures: {{a: angle of line from drum to ball from up clockwise}}
{WEIGHT}""").simulate(2.5, tolerance=1e-11)
    assert result.status is Status.FINISHED
    assert result.energy.relative_error < 1e-8
    assert result.series["a"][0].max() > 0.3


def test_a_box_slides_over_the_edge_of_a_table_and_tips() -> None:
    result = model(f"""
bodies:
  table: {{rectangle: {{width: 2 m, height: 1 m}}, at: [-1 m, -0.5 m], angle: 0, fixed: true}}
  b: {{rectangle: {{mass: 1 kg, width: 0.4 m, height: 0.2 m}}, at: [-0.3 m, 0.1 m], angle: 0, velocity: [1.6 m/s, 0]}}
connections: {{c: {{contact: {{between: [b, table], friction: 0.3}}}}}}
measures: {{x: x of b, a: angle of b}}
{WEIGHT}""").simulate(1.2, tolerance=1e-11)
    assert result.status is Status.FINISHED
    tips = next(e for e in result.events if e.kind == "parts")
    k = int(np.argmin(np.abs(result.course.times - tips.time)))
    # friction mu m g below the middle shifts the normal force ahead by mu h/2
    assert result.series["x"][0][k] == pytest.approx(-0.3 * 0.1, abs=1e-8)
    assert result.series["a"][0][-1] < -0.5
    assert result.energy.relative_error < 1e-8


def test_a_rod_slides_off_the_edge_of_a_table() -> None:
    result = model(f"""
bodies:
  table: {{rectangle: {{width: 2 m, height: 1 m}}, at: [-1 m, -0.5 m], angle: 0, fixed: true}}
  rod: {{rod: {{mass: 1 kg, length: 1 m}}, at: [-0.2 m, 0], angle: 0, velocity: [1 m/s, 0]}}
connections: {{c: {{contact: {{between: [rod, table], friction: 0.1}}}}}}
measures: {{x: x of rod, a: angle of rod}}
{WEIGHT}""").simulate(0.8, tolerance=1e-11)
    assert result.status is Status.FINISHED
    tips = next(e for e in result.events if e.kind == "parts")
    k = int(np.argmin(np.abs(result.course.times - tips.time)))
    assert result.series["x"][0][k] == pytest.approx(0.0, abs=1e-8)
    assert result.series["a"][0][-1] < -0.5
    assert result.energy.relative_error < 1e-8


# -- strings, rolling, brakes -----------------------------------------------------------------
def test_a_string_goes_slack_where_its_tension_ends_and_jerks_when_it_is_taut_again() -> None:
    """A mass swung up from below: T = 0 at the height h = (v0^2 - 2 g L)/(3 g) over the anchor."""
    result = model(f"""
bodies: {{p: {{particle: {{mass: 1 kg}}, at: [0, -1 m], velocity: [6 m/s, 0]}}}}
connections: {{s: {{string: {{from: ground.A, to: p}}}}}}
ground: {{points: {{A: [0, 0]}}}}
{WEIGHT}""").simulate(3.0, tolerance=1e-11)
    assert result.status is Status.FINISHED
    assert kinds(result)[:2] == ["goes slack", "goes taut"]
    k = int(np.argmin(np.abs(result.course.times - result.events[0].time)))
    assert result.course.poses[k, 0, 1] == pytest.approx((36.0 - 2 * G) / (3 * G), rel=1e-9)
    assert np.hypot(*result.course.poses[:, 0, :2].T).max() <= 1.0 + 1e-9
    assert result.energy.relative_error < 1e-8


def test_a_rolling_wheel_lifts_off_lands_and_rolls() -> None:
    """An ideal contact: no slip wherever it is closed. Pulled up by a pulse, it flies and comes back."""
    result = model(f"""{FLOOR}
bodies: {{w: {{disk: {{mass: 1 kg, radius: 0.2 m}}}}}}
connections: {{c: {{rolling: {{body: w, on: floor}}}}}}
measures: {{x: x of w, y: y of w}}
start: {{x: 0, rate(x): 1 m/s}}
parameters: {{F: 20 N, T: 0.5 s}}
loads:
  weight: {{gravity: 9.81 m/s^2}}
  pull: {{force: {{at: w, along: up, magnitude: "F*(sign(t - T) - sign(t - 1.2*T))/2"}}}}
""").simulate(2.0, tolerance=1e-10)
    assert result.status is Status.FINISHED
    assert kinds(result)[:2] == ["parts", "touches"]
    assert result.series["y"][0].min() > 0.2 - 1e-9
    v = result.course.velocities[-1, 0]
    assert v[0] + 0.2 * v[2] == pytest.approx(0.0, abs=1e-9)


def test_a_brake_that_is_released_lets_go_when_its_torque_is_that_of_the_load() -> None:
    result = model(f"""
parameters: {{T0: 3 N m, k: 1 N m/s}}
bodies: {{arm: {{rod: {{mass: 1 kg, length: 0.4 m}}, angle: 0}}}}
connections: {{p: {{pin: [ground.A, arm.start]}}, b: {{brake: {{between: [arm, ground], torque: T0 - k*t}}}}}}
{WEIGHT}""").simulate(1.6, tolerance=1e-11)
    assert result.events[0].kind == "starts to slip"
    assert result.events[0].time == pytest.approx(3.0 - G * 0.2, rel=1e-9)


def test_a_driven_platform_throws_a_block_at_the_acceleration_of_gravity() -> None:
    """y = A sin(w t): the block leaves when A w^2 sin = g."""
    result = model(f"""
parameters: {{A: 0.05 m, w: 20 rad/s}}
bodies:
  deck: {{body: {{mass: 1 kg, inertia: 1 kg m^2}}, lines: {{top: {{along: right}}}}}}
  b: {{particle: {{mass: 1 kg}}}}
connections:
  guide: {{slider: {{body: deck, along: up}}}}
  drive: {{driver: {{measure: y of deck, follows: A*sin(w*t)}}}}
  c: {{contact: {{between: [b, deck.top]}}}}
  rail: {{slider: {{body: b, along: up}}}}
{WEIGHT}""").simulate(0.6, tolerance=1e-11)
    assert result.status is Status.FINISHED
    assert result.events[0].kind == "parts"
    assert result.events[0].time == pytest.approx(math.asin(G / (0.05 * 400)) / 20.0, rel=1e-9)
    assert result.energy.relative_error < 1e-7


# -- rest -------------------------------------------------------------------------------------
def test_a_long_rest_is_one_phase() -> None:
    result = model(TUMBLING).simulate(1000.0, tolerance=1e-9)
    assert result.status is Status.FINISHED
    assert result.course.contact.n_phases < 60
    assert result.course.n_steps < 5000  # the rest itself takes few
    assert np.abs(result.course.velocities[-1]).max() < 1e-12


@pytest.mark.slow
def test_ten_boxes_dropped_into_a_box_come_to_rest() -> None:
    boxes = "\n".join(
        f"  b{k}: {{rectangle: {{mass: 1 kg, width: 0.2 m, height: 0.2 m}}, "
        f"at: [{0.26 * (k % 3) - 0.27 + 0.003 * k:.3f} m, {0.2 + 0.3 * (k // 3):.3f} m], angle: {2 * k} deg}}"
        for k in range(10)
    )
    result = model(f"""
ground:
  lines:
    floor: {{along: right}}
    left: {{through: [-0.5 m, 0], along: down}}
    right: {{through: [0.5 m, 0], along: up}}
bodies:
{boxes}
connections: {{c: {{contact: {{among: all, friction: 0.4}}}}}}
{WEIGHT}""").simulate(1.0, every=0.01, max_steps=200_000)
    assert result.status is Status.FINISHED
