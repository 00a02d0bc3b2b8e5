"""Cylinders that tip from standing flat, fall back on their flat end, rock and come to rest, beside closed forms.

A cylinder of radius R and height h has I = m (R^2/4 + h^2/12) about its middle and I_0 = I + m (R^2 + h^2/4) about a
point of its rim. Where it falls back on its flat end without rebound the angular momentum about the other edge stays:
I_0 w' = (I + m (h^2/4 - R^2)) w, and it stands where that is not positive. Source: Housner, Bull. Seismol. Soc. Am. 53
(1963) 403-417, for blocks.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.engine.course import Status

G, M, R, H = 9.81, 2.0, 0.1, 0.3
FLOOR = """
space: true
ground: {planes: {floor: {normal: up}}}
bodies:
  can:
    {cylinder: {mass: 2, radius: 0.1, length: LENGTH, axis: y}, at: [0, HEIGHT, 0], points: {top: [0, TOP m, 0]}MORE}
connections: {contact: {contact: {between: [can, ground.floor], friction: MU}}}
loads: {weight: {gravity: 9.81 m/s^2}PUSH}
"""


def moments(h: float) -> tuple[float, float]:
    inside = M * (R * R / 4 + h * h / 12)
    return inside, inside + M * (R * R + h * h / 4)


def moved(
    mu: float, until: float, more: str = "", *, length: float = H, height: float = 0.0, push: str = ""
) -> fb.Simulation:
    text = FLOOR.replace("LENGTH", str(length)).replace("HEIGHT", repr(height or length / 2))
    text = text.replace("TOP", str(length / 2)).replace("MORE", more).replace("MU", str(mu)).replace("PUSH", push)
    found = fb.System.from_text(text).simulate(until)
    assert found.course.status is Status.FINISHED, found.course.message
    return found


def tilted(degrees: float, h: float, about: str = "z") -> tuple[float, str]:
    """The height at which the rim of a tilted cylinder touches, and the words for how it is turned."""
    a = math.radians(degrees)
    return h / 2 * math.cos(a) + R * math.sin(a), f", turned: {degrees} deg about {about}"


def spin(found: fb.Simulation, at: int) -> np.ndarray:
    assert found.course.rotation is not None
    return found.course.rotation.velocities[at, 0]


def energy(found: fb.Simulation, at: int, h: float = H) -> float:
    """Kinetic and potential, of a body that turns across its axis alone or also about it."""
    w = found.course.rotation.velocities_in_body[at, 0]  # type: ignore[union-attr]
    inside, _about_edge = moments(h)
    turning = inside * (w[0] ** 2 + w[2] ** 2) / 2 + M * R * R / 4 * w[1] ** 2
    v = found.course.velocities[at, 0, :3]
    return float(M * (v @ v) / 2 + turning + M * G * found.course.poses[at, 0, 1])


def swing(degrees: float, h: float) -> float:
    """The angular velocity about a point of the rim with which it comes down from a tilt."""
    height, _words = tilted(degrees, h)
    return math.sqrt(2 * M * G * (height - h / 2) / moments(h)[1])


@pytest.mark.parametrize("about", ["z", "x"])
def test_tall_can_that_falls_back_rocks_on_by_its_angular_momentum_about_the_other_edge(about: str) -> None:
    height, turned = tilted(5, H, about)
    found = moved(5.0, 0.2, turned, height=height)
    (inside, about_edge), w = moments(H), swing(5, H)
    share = (inside + M * (H * H / 4 - R * R)) / about_edge
    first, second = found.course.contact.collisions[:2]  # type: ignore[union-attr]
    assert first.energy_change == pytest.approx(-about_edge * w * w / 2 * (1 - share**2), rel=1e-8)
    assert second.energy_change == pytest.approx(first.energy_change * share**2, rel=1e-7)
    [impulse] = first.impulses.values()
    assert impulse == pytest.approx(M * R * w * (1 + share), rel=1e-8)
    assert [*first.before.values()] == [pytest.approx(-2 * R * w, rel=1e-8)]
    kinds = [event.kind for event in found.course.events]
    assert kinds == ["rebounds", "tips"] * 2
    # between two hits it swings up and down alike: the same time after the second as after the first, shorter
    assert energy(found, -1) == pytest.approx(M * G * height + first.energy_change + second.energy_change, rel=1e-9)


def test_flat_disk_that_falls_back_stands_at_once() -> None:
    """I + m (h^2/4 - R^2) < 0: all energy of the swing is lost, and the pressure stays within the circle."""
    height, turned = tilted(5, 0.02)
    found = moved(5.0, 0.2, turned, length=0.02, height=height)
    [hit] = found.course.contact.collisions  # type: ignore[union-attr]
    assert hit.energy_change == pytest.approx(-moments(0.02)[1] * swing(5, 0.02) ** 2 / 2, rel=1e-8)
    assert [str(event.name) for event in found.course.events] == ["can.start touches floor"]
    assert found.course.poses[-1, 0, 1] == pytest.approx(0.01, abs=1e-12)
    assert np.abs(spin(found, -1)).max() < 1e-12


def test_ramp_of_force_tips_it_where_its_moment_passes_that_of_the_weight() -> None:
    """P h = m g R at the edge on which it then stands; from there on the work of P is all that its energy grows by."""
    push = ", push: {force: {at: can.top, along: [0.6, 0, 0.8], magnitude: 20 N/s * t}}"
    when = M * G * R / H / 20
    found = moved(5.0, when + 0.2, push=push)
    assert [(e.kind, e.time) for e in found.course.events] == [("tips", pytest.approx(when, rel=1e-7))]
    w = spin(found, -1)
    assert w / np.linalg.norm(w) == pytest.approx((0.8, 0, -0.6), abs=1e-9)
    done = found.course.work[-1].sum() - found.course.work[0].sum()
    assert energy(found, -1) == pytest.approx(M * G * H / 2 + done, rel=1e-8)


def test_can_that_slides_into_tipping_stands_on_its_front() -> None:
    """N - m g = m R a, I a = mu N h/2 - N R."""
    found = moved(0.8, 0.05, ", velocity: [1, 0, 0]")
    inside, _about_edge = moments(H)
    lever = 0.8 * H / 2 - R
    pressed = M * G / (1 - M * R * lever / inside)
    assert found.course.velocities[0, 0, 0] == pytest.approx(1)
    assert found.course.accelerations[0, 0, :3] == pytest.approx(
        (-0.8 * pressed / M, pressed / M - G, 0), rel=1e-9, abs=1e-9
    )
    assert found.course.rotation.accelerations[0, 0] == pytest.approx((0, 0, -pressed * lever / inside), abs=1e-8)  # type: ignore[union-attr]


@pytest.mark.parametrize("share", [0.97, 1.03])
def test_least_impulse_that_tips_it_over(share: float) -> None:
    """J h = I_0 w at the edge, and I_0 w^2/2 = m g (d - h/2) with d from the edge to the middle."""
    _inside, about_edge = moments(H)
    w = math.sqrt(2 * M * G * (math.hypot(R, H / 2) - H / 2) / about_edge)
    J = share * about_edge * w / H
    blow = f", blow: {{impulse: {{at: can.top, along: [1, 0, 0], magnitude: {J} N s, when: t = 0.1 s}}}}"
    found = moved(9.0, 0.8, push=blow)
    lean = found.course.rotation.quaternions[:, 0]  # type: ignore[union-attr]
    upright = 1 - 2 * (lean[:, 1] ** 2 + lean[:, 3] ** 2)  # cosine of the tilt
    edge = H / 2 / math.hypot(R, H / 2)  # of the tilt at which it is in balance
    assert (upright.min() < edge) == (share > 1)


def test_tilted_can_that_also_spins_rolls_on_its_rim_past_lying_flat_and_keeps_its_energy() -> None:
    """Its rim touches at one point, which runs round it the faster the flatter it is: no blow, no loss."""
    height, turned = tilted(10, H)
    found = moved(0.0, 0.3, f"{turned}, angular_velocity: [0, 0.4, 0]", height=height)
    first = energy(found, 0)
    for at in (len(found.course.times) // 2, -1):
        lost = sum(hit.energy_change for hit in found.course.contact.collisions)  # type: ignore[union-attr]
        assert energy(found, at) <= first + 1e-8
        if not lost:
            assert energy(found, at) == pytest.approx(first, rel=1e-8)


def test_motion_that_begins_hardly_tilted_goes_on_about_the_point_of_the_rim_on_which_it_stands() -> None:
    """As one that is cut in two where it has just begun to tip: 1e-5 rad does not tell where a rim is lowest."""
    height, turned = tilted(math.degrees(1e-5), H)
    away = np.array(
        (R * math.cos(1e-5) - H / 2 * math.sin(1e-5), height, 0.0)
    )  # from the point of the rim to the middle
    v = np.cross((0, 0, 1.0), away)
    found = moved(5.0, 0.03, f"{turned}, velocity: {v.tolist()}, angular_velocity: [0, 0, 1]", height=height)
    assert energy(found, -1) == pytest.approx(energy(found, 0), rel=1e-9)
    assert not found.course.events
    assert spin(found, -1)[2] == pytest.approx(
        math.sqrt(1 + 2 * M * G * (height - found.course.poses[-1, 0, 1]) / moments(H)[1]), rel=1e-6
    )


def test_can_on_a_truck_that_speeds_up_ever_more_tips_at_g_times_width_over_height() -> None:
    """m a h/2 about the rear edge is m g r at most; a = 2 j t."""
    text = """
space: true
parameters: {j: 2 m/s^3}
bodies:
  truck: {box: {mass: 10, size: [2, 0.2, 1]}, at: [0, 0, 0], planes: {bed: {through: [0, 0.1, 0], normal: y}}}
  can: {cylinder: {mass: 2, radius: 0.1, length: 0.3, axis: y}, at: [0, 0.25, 0]}
connections:
  guide: {prismatic: {first: ground, second: truck, along: x}}
  engine: {driver: {measure: x, follows: j*t^3/3}}
  contact: {contact: {between: [can, truck.bed], friction: 0.9}}
measures: {x: x of truck}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
    found = fb.System.from_text(text).simulate(1.7)
    assert found.course.status is Status.FINISHED, found.course.message
    assert [(e.kind, e.time) for e in found.course.events] == [("tips", pytest.approx(G * 2 * R / H / 4, rel=1e-8))]


@pytest.mark.slow
def test_on_a_box_it_tips_and_rocks_as_on_a_plane() -> None:
    height, turned = tilted(5, H)
    plane = moved(5.0, 0.2, turned, height=height)
    text = FLOOR.replace("LENGTH", str(H)).replace("HEIGHT", repr(height)).replace("MORE", turned).replace("PUSH", "")
    text = text.replace("TOP", str(H / 2))
    text = (
        text.replace("MU", "5")
        .replace("ground: {planes: {floor: {normal: up}}}\n", "")
        .replace("ground.floor", "table")
    )
    text = text.replace(
        "bodies:", "bodies:\n  table: {box: {mass: 1, size: [1, 0.4, 0.8]}, fixed: true, at: [0, -0.2, 0]}"
    )
    box = fb.System.from_text(text).simulate(0.2)
    assert box.course.status is Status.FINISHED, box.course.message
    assert [e.time for e in box.course.events] == pytest.approx([e.time for e in plane.course.events], rel=1e-8)
    assert spin(box, -1) == pytest.approx(spin(plane, -1), abs=1e-7)
