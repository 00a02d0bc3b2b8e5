"""Balls that touch other bodies in space, beside closed forms and identities.

A ball that rolls from rest at the angle phi_0 off a fixed dome has 7/10 v^2 = g (R + r) (cos phi_0 - cos phi) and parts
where v^2/(R + r) = g cos phi: at cos phi = 10/17 cos phi_0, without friction at 2/3 cos phi_0. Source: Meriam & Kraige,
Dynamics, sec. 6/6; Goldstein, Classical Mechanics, ch. 2 (the particle on the hemisphere).

Two balls that collide get N = (1 + e) m w along the normal, m their reduced mass, and against the slip u the impulse
2/7 m |u|, which stops it, or mu N, whichever is less. Source: Stronge, Impact Mechanics, 2000, sec. 4.3.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import freebody as fb
from freebody.connections.places_on_bodies import F, Q
from freebody.numeric.engine.course import Collision
from freebody.numeric.reference import Reference
from freebody.study.setup import Setup
from freebody.system.modes import ContactMode, in_mode

G = 9.81
WEIGHT = "loads: {weight: {gravity: 9.81 m/s^2}}\n"
TARGETS = {  # a body at the origin, and what is nearest to a ball at [1.2, 0.7, 0.5], turned with it
    "sphere": "sphere: {mass: 2 kg, radius: 0.4 m}",
    "box": "box: {mass: 2 kg, size: [0.6 m, 0.8 m, 0.4 m]}",
    "slab": "box: {mass: 2 kg, size: [4 m, 0.2 m, 4 m]}",
    "cylinder": "cylinder: {mass: 2 kg, radius: 0.3 m, length: 3 m, axis: y}",
    "barrel": "cylinder: {mass: 2 kg, radius: 0.3 m, length: 0.4 m, axis: [0.6, 0, 0.8]}",
    "disk": "disk: {mass: 2 kg, radius: 0.5 m, axis: z}",
    "ring": "ring: {mass: 2 kg, radius: 0.5 m, axis: x}",
    "rod": "rod: {mass: 2 kg, length: 0.8 m}",
    "particle": "particle: {mass: 2 kg}",
}


def collisions(found: fb.Simulation) -> tuple[Collision, ...]:
    record = found.course.contact
    assert record is not None
    return tuple(record.collisions)


def dome(solid: str, friction: float, place: str) -> str:
    return (
        "space: true\nparameters: {r: 0.05 m, R: 0.5 m, phi0: 5 deg, turn: 25 deg}\n"
        f"bodies:\n  dome: {{{solid}, fixed: true}}\n"
        f"  ball: {{sphere: {{mass: 0.3 kg, radius: r}}, at: {place}}}\n"
        f"connections: {{contact: {{contact: {{between: [ball, dome], friction: {friction}}}}}}}\n{WEIGHT}"
    )


ROUND = "[(R + r)*sin(phi0)*cos(turn), (R + r)*cos(phi0), (R + r)*sin(phi0)*sin(turn)]"
SPHERE = "sphere: {mass: 1 kg, radius: R}"
LYING = "cylinder: {mass: 1 kg, radius: R, length: 4 m, axis: [-sin(turn), 0, cos(turn)]}"


@pytest.mark.parametrize("solid", [SPHERE, LYING])
@pytest.mark.parametrize(("friction", "share"), [(0, 2 / 3), (1e3, 10 / 17)])
def test_ball_leaves_a_dome_at_a_known_angle(solid: str, friction: float, share: float) -> None:
    """In a plane of motion that is oblique to x and z."""
    found = fb.System.from_text(dome(solid, friction, ROUND)).simulate(1.0)
    parts = [event for event in found.course.events if event.kind == "parts"]
    assert len(parts) == 1
    at = np.searchsorted(found.course.times, parts[0].time)
    pose = found.course.poses[at, 0]
    assert pose[1] / 0.55 == pytest.approx(share * math.cos(math.radians(5)), abs=2e-5)
    assert pose[2] / pose[0] == pytest.approx(math.tan(math.radians(25)), rel=1e-6)


def test_ball_rolls_over_the_edge_of_a_box_and_leaves_it() -> None:
    """It rolls on the face at v, then about the edge: with v'^2 = v^2 + 10/7 g r (1 - cos) it parts at
    cos = (10 + 7 v^2/(g r))/17. The face is one of a box that is turned about the vertical."""
    v, r = 0.2, 0.05
    heading = np.array((math.cos(0.4), 0.0, -math.sin(0.4)))
    start = -0.03 * heading + np.array((0.0, 0.5 + r, 0.0))
    spin = np.cross((0.0, 1.0, 0.0), heading) * v / r
    model = (
        "space: true\nbodies:\n"
        "  desk: {box: {mass: 1 kg, size: [0.2 m, 1 m, 2 m]}, fixed: true, turned: 0.4 rad about y}\n"
        f"  ball: {{sphere: {{mass: 0.3 kg, radius: {r} m}}, at: {start.tolist()}, velocity: {(v * heading).tolist()}, "
        f"angular_velocity: {spin.tolist()}}}\n"
        f"connections: {{contact: {{contact: {{between: [ball, desk], friction: 1e3}}}}}}\n{WEIGHT}"
    )
    found = fb.System.from_text(model).simulate(1.5)
    parts = [event for event in found.course.events if event.kind == "parts"]
    at = np.searchsorted(found.course.times, parts[0].time)
    pose = found.course.poses[at, 0]
    assert (pose[1] - 0.5) / r == pytest.approx((10 + 7 * v**2 / (G * r)) / 17, abs=1e-5)
    assert pose[:3] @ heading - 0.1 == pytest.approx(math.sqrt(r**2 - (pose[1] - 0.5) ** 2), abs=1e-8)


@pytest.mark.parametrize(("mu", "sticks"), [(0.1, False), (2.0, True)])
def test_two_balls_that_collide_get_the_impulses_of_coulomb_friction(mu: float, sticks: bool) -> None:
    m1, m2, r1, r2, e = 0.2, 0.5, 0.03, 0.05, 0.7
    v1, w1, w2 = np.array((3.0, -1.0, 0.5)), np.array((40.0, 10.0, -25.0)), np.array((0.0, -30.0, 20.0))
    n = np.array((-2.0, 1.0, 0.5)) / math.sqrt(5.25)  # from the second to the first when they meet
    start = (r1 + r2) * n - 0.1 * v1
    model = (
        f"space: true\nbodies:\n  one: {{sphere: {{mass: {m1}, radius: {r1}}}, at: {start.tolist()}, "
        f"velocity: {v1.tolist()}, angular_velocity: {w1.tolist()}}}\n"
        f"  two: {{sphere: {{mass: {m2}, radius: {r2}}}, at: [0, 0, 0], angular_velocity: {w2.tolist()}}}\n"
        f"connections: {{it: {{contact: {{between: [one, two], friction: {mu}, restitution: {e}}}}}}}\n"
    )
    found = fb.System.from_text(model).simulate(0.2)
    [hit] = collisions(found)
    m = m1 * m2 / (m1 + m2)
    N = -(1 + e) * m * (v1 @ n)
    u = v1 - (v1 @ n) * n + np.cross(w1, -r1 * n) - np.cross(w2, r2 * n)
    size = min(2 / 7 * m * np.linalg.norm(u), mu * N)
    assert (size < mu * N) == sticks
    impulse = N * n - size * u / np.linalg.norm(u)
    assert hit.time == pytest.approx(0.1, rel=1e-9)
    assert hit.impulses["it.contact"] == pytest.approx(N, rel=1e-9)
    assert math.hypot(hit.friction["it.slip 1"], hit.friction["it.slip 2"]) == pytest.approx(size, rel=1e-9)
    velocities, rotation = found.course.velocities[-1], found.course.rotation
    assert rotation is not None
    assert velocities[0, :3] == pytest.approx(v1 + impulse / m1, abs=1e-9)
    assert velocities[1, :3] == pytest.approx(-impulse / m2, abs=1e-9)
    assert rotation.velocities[-1, 0] == pytest.approx(w1 + np.cross(-r1 * n, impulse) / (0.4 * m1 * r1**2), abs=1e-7)
    assert rotation.velocities[-1, 1] == pytest.approx(w2 - np.cross(r2 * n, impulse) / (0.4 * m2 * r2**2), abs=1e-7)


def test_directions_across_the_normal_are_a_right_handed_frame() -> None:
    q, f, g = (np.array([float(c.value) for c in v]) for v in (Q, *F))  # type: ignore[attr-defined]
    assert np.cross(f, g) == pytest.approx(q, abs=1e-15)
    assert np.column_stack((f, g, q)).T @ np.column_stack((f, g, q)) == pytest.approx(np.eye(3), abs=1e-15)


def test_newtons_cradle_hands_the_velocity_on() -> None:
    """Equal smooth balls in a row that is oblique to all axes, a little apart: each takes over the velocity."""
    e = np.array((2.0, 3.0, -6.0)) / 7.0
    places = [s * e for s in (-0.3, 0.0, 0.11, 0.22)]
    speeds = [(2 * e).tolist(), *([0, 0, 0],) * 3]
    bodies = "".join(
        f"  b{k}: {{sphere: {{mass: 0.1, radius: 0.05}}, at: {p.tolist()}, velocity: {v}}}\n"
        for k, (p, v) in enumerate(zip(places, speeds, strict=True))
    )
    model = (
        f"space: true\nbodies:\n{bodies}connections: {{c: {{contact: {{among: [b0, b1, b2, b3], restitution: 1}}}}}}\n"
    )
    found = fb.System.from_text(model).simulate(0.5)
    assert [hit.time for hit in collisions(found)] == pytest.approx([0.1, 0.105, 0.11], rel=1e-9)
    assert found.course.velocities[-1, :3, :3] == pytest.approx(0.0, abs=1e-10)
    assert found.course.velocities[-1, 3, :3] == pytest.approx(2 * e, abs=1e-10)


def thrown(target: str, mu: float, e: float) -> str:
    turns = target != "particle"
    turned = "turned: [0.3 rad about x, 0.2 rad about y], angular_velocity: [2, -3, 1], " if turns else ""
    return (
        f"space: true\nbodies:\n  target: {{{TARGETS[target]}, {turned}at: [0, 0, 0], velocity: [0.1, 0, -0.2]}}\n"
        "  ball: {sphere: {mass: 0.5, radius: 0.3}, at: [1.2, 0.7, 0.5], velocity: [-2.3, -1.2, -0.8], "
        "angular_velocity: [9, -14, 5]}\n"
        f"connections: {{it: {{contact: {{between: [target, ball], friction: {mu}, restitution: {e}}}}}}}\n"
    )


def momenta(found: fb.Simulation, at: int) -> tuple[np.ndarray, np.ndarray]:
    """Momentum and angular momentum about the origin."""
    total, moment = np.zeros(3), np.zeros(3)
    rotation = found.course.rotation
    assert rotation is not None
    reference = Reference(found.system, {})
    for k, body in enumerate(found.system.moving):
        p = reference.number(body.mass) * found.course.velocities[at, k, :3]
        total += p
        moment += np.cross(found.course.poses[at, k, :3], p)
        if body.turns:
            xx, yy, zz, xy, xz, yz = (reference.number(c) for c in body.tensor)
            tensor = np.array(((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)))
            w, *vector = rotation.quaternions[at, k]
            R = Rotation.from_quat((*vector, w)).as_matrix()
            moment += R @ tensor @ R.T @ rotation.velocities[at, k]
    return total, moment


@pytest.mark.parametrize("target", TARGETS)
def test_impact_of_a_ball_keeps_the_momenta_of_both(target: str) -> None:
    found = fb.System.from_text(thrown(target, 0.4, 0.6)).simulate(1.0)
    hits = collisions(found)
    assert hits
    assert all(hit.energy_change < 0.0 for hit in hits)
    for before, after in zip(momenta(found, 0), momenta(found, -1), strict=True):
        assert after == pytest.approx(before, abs=1e-8)


@pytest.mark.parametrize("target", TARGETS)
def test_smooth_elastic_impact_keeps_the_energy(target: str) -> None:
    found = fb.System.from_text(thrown(target, 0.0, 1.0)).simulate(1.0)
    hits = collisions(found)
    assert hits
    assert [hit.energy_change for hit in hits] == pytest.approx([0.0] * len(hits), abs=1e-9)


@pytest.mark.parametrize("target", TARGETS)
def test_slip_is_the_velocity_of_one_material_point_against_the_other(target: str) -> None:
    """The place that touches is r n before the centre of the ball, n the gradient of the gap by that: there the
    velocities of both rigid bodies differ by the rate of the gap along n, and across it by what the two rows have."""
    place = np.array((1.2, 0.7, 0.5))
    for moved in (True, False):  # along n, until it touches
        system = fb.System.from_text(thrown(target, 0.4, 0.6).replace("[1.2, 0.7, 0.5]", str(place.tolist())))
        reference = Reference(system, {})
        q = reference.assemble()
        v = reference.velocities(q)
        g = reference.geometry(q, v, 0.0)
        [bound], [rub] = system.bounds, system.dry_friction
        assert bound.row.target is not None
        gap = reference.jet(g, bound.row.measure, "gap")
        n = gap.row(len(v))[list(reference.columns("ball"))[:3]]
        assert np.linalg.norm(n) == pytest.approx(1.0, abs=1e-12)
        place = place - (gap.value - reference.number(bound.row.target)) * n if moved else place
    turning = np.zeros(3) if target == "particle" else np.array((2.0, -3.0, 1.0))
    u = np.array((-2.4, -1.2, -0.6)) + np.cross((9.0, -14.0, 5.0), -0.3 * n) - np.cross(turning, place - 0.3 * n)
    assert gap.rate == pytest.approx(u @ n, abs=1e-12)
    slips = [reference.jet(g, row.measure, "slip").rate for row in rub.rows]
    assert math.hypot(*slips) == pytest.approx(np.linalg.norm(u - (u @ n) * n), abs=1e-10)


@pytest.mark.parametrize(("friction", "share"), [(0, 1.0), (100, 5 / 7)])
def test_ball_swings_in_a_bowl_with_the_frequency_of_its_pendulum(friction: float, share: float) -> None:
    """omega^2 = g/(R - r) without friction, 5 g/(7 (R - r)) rolling: the amplitude 0.002 rad adds 2.5e-7 of it."""
    model = (
        "space: true\nparameters: {R: 0.5 m, r: 0.1 m, phi: 0.002 rad}\nbodies:\n"
        "  bowl: {spherical_shell: {mass: 1 kg, radius: R}, fixed: true}\n  ball: {sphere: {mass: 0.3 kg, radius: r}, "
        "at: [0.6*(R - r)*sin(phi), -(R - r)*cos(phi), 0.8*(R - r)*sin(phi)]}\n"
        f"connections: {{it: {{contact: {{between: [ball, inside bowl], friction: {friction}}}}}}}\n{WEIGHT}"
    )
    omega = math.sqrt(share * G / 0.4)
    found = fb.System.from_text(model).simulate(1.0, every=0.05)
    swing = 0.4 * math.sin(0.002) * np.cos(omega * found.course.times)
    assert found.course.poses[:, 0, 0] == pytest.approx(0.6 * swing, abs=1e-8)
    assert found.course.poses[:, 0, 2] == pytest.approx(0.8 * swing, abs=1e-8)


@pytest.mark.parametrize("mu", [0.2, 0.35])
def test_ball_rests_on_three_others_by_friction_or_by_form(mu: float) -> None:
    """On three fixed balls: 3 (N cos(beta) + F sin(beta)) = m g has N = m g/(3 cos(beta)), F = 0 among its solutions,
    sin(beta) = a/(r + R), a the radius of their circle; so it rests however rough they are."""
    bodies = "".join(
        f"  b{k}: {{sphere: {{mass: 1, radius: 0.1}}, fixed: true, at: "
        f"[{0.12 * math.cos(2 * math.pi * k / 3)}, 0, {0.12 * math.sin(2 * math.pi * k / 3)}]}}\n"
        for k in range(3)
    )
    height = math.sqrt(0.2**2 - 0.12**2)
    contacts = ", ".join(f"c{k}: {{contact: {{between: [top, b{k}], friction: {mu}}}}}" for k in range(3))
    model = (
        f"space: true\nbodies:\n{bodies}  top: {{sphere: {{mass: 2, radius: 0.1}}, at: [0, {height}, 0]}}\n"
        f"connections: {{{contacts}}}\n{WEIGHT}"
    )
    system = fb.System.from_text(model)
    assert system.statics().holds
    found = system.simulate(0.1)
    assert not found.course.events
    assert found.course.poses[-1, 0, 1] == pytest.approx(height, abs=1e-9)


def test_pairs_without_a_contact_are_refused_with_what_there_is() -> None:
    model = (
        "space: true\nbodies:\n  a: {ellipsoid: {mass: 1, semi_axes: [1, 1, 1]}, at: [0, 3, 0]}\n"
        "  b: {box: {mass: 1, size: [1, 1, 1]}}\nconnections: {it: {contact: {between: [a, b]}}}\n"
    )
    with pytest.raises(fb.ModelError) as told:
        fb.System.from_text(model)
    [problem] = told.value.problems
    assert "there is no contact of a with b in space: a sphere touches a sphere" in problem.message
    assert "name a plane of one" in problem.message
    point = model.replace("[a, b]", "[a.center, b.center]")
    with pytest.raises(fb.ModelError, match=r"there is no contact of a\.center with b\.center in space"):
        fb.System.from_text(point)


def test_ball_stays_inside_the_hollow_of_a_sphere_and_out_of_the_bore_of_a_pipe() -> None:
    model = (
        "space: true\nbodies:\n  bowl: {BOWL, fixed: true}\n"
        "  ball: {sphere: {mass: 1 kg, radius: 0.1 m}, at: [0, 0, 0.1 m]}\n"
        f"connections: {{it: {{contact: {{between: [ball, inside bowl], restitution: 0}}}}}}\n{WEIGHT}"
    )
    hollow = model.replace("BOWL", "hollow_sphere: {mass: 1 kg, radius: 0.5 m, inner_radius: 0.4 m}")
    found = fb.System.from_text(hollow).simulate(0.5)
    assert found.course.events[0].time == pytest.approx(math.sqrt(2 * math.sqrt(0.08) / G), rel=1e-9)
    assert np.linalg.norm(found.course.poses[-1, 0, :3]) == pytest.approx(0.3, abs=1e-9)
    pipe = "hollow_cylinder: {mass: 1 kg, radius: 0.5 m, inner_radius: 0.4 m, length: 1 m}"
    for between in ("inside bowl", "bowl"):
        with pytest.raises(fb.ModelError, match="there is no contact of ball with"):
            fb.System.from_text(model.replace("BOWL", pipe).replace("inside bowl", between))


def test_ball_inside_another_at_the_start_is_told() -> None:
    model = (
        "space: true\nbodies:\n  a: {sphere: {mass: 1, radius: 1}, at: [0, 1, 0]}\n"
        "  b: {box: {mass: 1, size: [1, 1, 1]}, at: [0, 0, 0]}\nconnections: {it: {contact: {between: [a, b]}}}\n"
    )
    with pytest.raises(fb.FreebodyError, match=r"at the start a is 0\.5 m inside b \(it\)"):
        fb.System.from_text(model).simulate(0.1)


def test_formula_of_a_ball_on_a_free_box_is_given_up_after_a_bounded_number_of_terms() -> None:
    model = (
        "space: true\nbodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}, "
        "crate: {box: {mass: 2 kg, size: [0.3 m, 0.2 m, 0.4 m]}}}\n"
        "connections: {it: {contact: {between: [ball, crate]}}}\n"
    )
    system = fb.System.from_text(model)
    held = in_mode(system, ContactMode.of({bound.name for bound in system.bounds}, {}))[0]
    with pytest.raises(fb.FreebodyError, match="more than 60000 terms"):
        Setup(held).state  # noqa: B018


@pytest.mark.parametrize(("body", "reach"), [("particle: {mass: 1}", 0.4), ("disk: {mass: 1, radius: 0.1}", 0.3)])
def test_what_falls_inside_an_annulus_reaches_its_hole(body: str, reach: float) -> None:
    model = (
        "bodies:\n  pipe: {annulus: {mass: 1, radius: 0.5, inner_radius: 0.4}, fixed: true, at: [0, 0]}\n"
        f"  it: {{{body}, at: [0, 0.1]}}\nconnections: {{c: {{contact: {{between: [it, inside pipe]}}}}}}\n{WEIGHT}"
    )
    found = fb.System.from_text(model).simulate(0.5)
    assert found.course.events[0].time == pytest.approx(math.sqrt(2 * (reach + 0.1) / G), rel=1e-9)
    assert found.course.poses[-1, 0, 1] == pytest.approx(-reach, abs=1e-9)


def test_domino_that_is_hit_leaves_the_stop_on_which_it_rested() -> None:
    text = (Path(__file__).parents[1] / "examples" / "dominoes.yaml").read_text()
    told = [str(e.name) for e in fb.System.from_text(text).simulate(0.1).course.events]
    assert "stands2 leaves its min" in told
    assert not [name for name in told if "hits" in name]
