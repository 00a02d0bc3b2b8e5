"""Tops, stones and coins on a plane, beside integrals, steady motions and equations of their own.

Tippe top. With r from the mass centre to the contact, L about the mass centre and any force there, L.r is constant for
a ball of offset mass centre (Jellett): so a top that has turned from standing on its foot, r = R - a below, to standing
on its head, R + a, has the spin n (R - a)/(R + a). Sources: Jellett, A Treatise on the Theory of Friction, 1872, ch.
VIII; Cohen, Am. J. Phys. 45 (1977) 12-17.

Rattleback. Rolling without slip is the three equations of Garcia & Hubbard, Proc. R. Soc. A 418 (1988) 165-197,

    I w' + w x I w = r x m (a + g n),   a = d/dt (r x w),   n' = -w x n      in axes of the stone,

which are integrated here on their own, with the values of Kane & Levinson, Int. J. Non-Linear Mech. 17 (1982) 175-186.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import freebody as fb

G = 9.81
TABLE = "space: true\nground: {planes: {table: {normal: up}}}\nloads: {weight: {gravity: 9.81 m/s^2}}\n"


def tippe_top(tilt: float, spin: float, mu: float) -> str:
    return TABLE + (
        "bodies: {top: {ellipsoid: {mass: 0.02 kg, semi_axes: [0.02, 0.02, 0.02], center_of_mass: [0, -0.006 m, 0], "
        f"inertia: [2.62e-6, 3.2e-6, 2.62e-6]}}, turned: {tilt} rad about z, angular_velocity: [0, {spin}, 0]}}}}\n"
        f"connections: {{contact: {{contact: {{between: [top, ground.table], friction: {mu}}}}}}}\n"
    )


def jellett(found: fb.Simulation, tilt: float, spin: float) -> np.ndarray:
    """L.r/R by time, from the height of the mass centre and the angular velocity."""
    A, C, R, a = 2.62e-6, 3.2e-6, 0.02, 0.006
    rotation = found.course.rotation
    assert rotation is not None
    in_body, in_space = rotation.velocities_in_body[:, 0], rotation.velocities[:, 0]
    axis = int(np.abs(np.abs(in_body[0]) - spin * math.cos(tilt)).argmin())
    along = in_body[:, axis] * np.sign(in_body[0, axis])  # w.e, e the axis of the top
    up = (R - found.course.poses[:, 0, 1]) / a  # e.n, since the centre of the ball stays at the height R
    return (A * (a * along - R * in_space[:, 1]) + (C - A) * along * (a - R * up)) / R


def test_tippe_top_turns_over_and_keeps_the_integral_of_jellett() -> None:
    tilt, spin = 0.5, 155.0
    found = fb.System.from_text(tippe_top(tilt, spin, 0.3)).simulate(2.5, every=0.05)
    record = found.course.contact
    assert record is not None
    on_table = record.states[:, 0] == 1  # it jumps now and then
    integral = jellett(found, tilt, spin)[on_table]
    assert np.abs(integral / integral[0] - 1.0).max() < 1e-6
    heights = found.course.poses[:, 0, 1]
    assert heights[0] == pytest.approx(0.02 - 0.006 * math.cos(tilt))
    assert heights[-1] > 0.0255
    # on its head: L.r = -C n (R + a)
    rotation = found.course.rotation
    assert rotation is not None
    assert rotation.velocities[-1, 0, 1] == pytest.approx(-integral[0] * 0.02 / (3.2e-6 * 0.026), rel=0.02)


def test_top_that_rolls_without_slip_does_not_turn_over() -> None:
    """Thrown about its own axis it soon rolls, and friction does no work any more."""
    model = tippe_top(0.1, 155.0, 0.3).replace("[0, 155.0, 0]", "[-15.474, 154.226, 0]")
    found = fb.System.from_text(model).simulate(1.0, every=0.1)
    assert [event.kind for event in found.course.events] == ["stops slipping"]
    assert found.course.poses[:, 0, 1].max() < 0.0141


def stone(how: str, spin: float) -> str:
    return TABLE + (
        "bodies: {stone: {ellipsoid: {mass: 1 kg, semi_axes: [0.2, 0.02, 0.03], center_of_mass: [0, -0.01 m, 0], "
        "inertia: [[2e-4, 0, -2e-5], [0, 17e-4, 0], [-2e-5, 0, 16e-4]]}, turned: 0.5 deg about x, "
        f"angular_velocity: [0, {spin}, 0]}}}}\nconnections: {{it: {how}}}\n"
    )


ROLLING = "{rolling: {body: stone, on: ground.table}}"


def spin_of_stone(spin: float, times: np.ndarray) -> np.ndarray:
    """w.n by the equations of Garcia and Hubbard, solved for themselves."""
    D = np.diag([0.2**2, 0.02**2, 0.03**2])
    inertia = np.array([[2e-4, 0, -2e-5], [0, 17e-4, 0], [-2e-5, 0, 16e-4]])

    def slope(_t: float, state: np.ndarray) -> np.ndarray:
        n, w = state[:3], state[3:]
        turning, size = -np.cross(w, n), math.sqrt(n @ D @ n)
        r = np.array((0.0, 0.01, 0.0)) - D @ n / size
        moves = -(D @ turning / size - D @ n * (n @ D @ turning) / size**3)
        cross = np.array([[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]])
        known = np.cross(r, -np.cross(w, moves + np.cross(w, r)) + G * n) - np.cross(w, inertia @ w)
        return np.r_[turning, np.linalg.solve(inertia - cross @ cross, known)]

    tilt = math.radians(0.5)
    up = np.array((0.0, math.cos(tilt), -math.sin(tilt)))
    found = solve_ivp(slope, (0.0, times[-1]), np.r_[up, spin * up], "DOP853", times, rtol=1e-11, atol=1e-12)
    return np.einsum("it,it->t", found.y[:3], found.y[3:])


@pytest.mark.parametrize("spin", [5.0, -5.0])
def test_rattleback_spins_back_as_its_own_equations_say(spin: float) -> None:
    found = fb.System.from_text(stone(ROLLING, spin)).simulate(7.0, every=0.5)
    rotation = found.course.rotation
    assert rotation is not None
    own = spin_of_stone(spin, found.course.times)
    assert rotation.velocities[:, 0, 1] == pytest.approx(own, abs=5e-4)
    if spin > 0.0:
        assert own[-1] < -1.5  # it spins the other way
    else:
        assert own[-1] == pytest.approx(spin, rel=0.01)  # its own way it goes on


def test_rough_contact_of_a_rattleback_is_its_rolling_while_it_sticks() -> None:
    contact = "{contact: {between: [stone, ground.table], friction: 5}}"
    one, other = (
        fb.System.from_text(stone(how, 5.0).replace("turned: 0.5 deg about x, ", "")).simulate(0.5, every=0.1)
        for how in (ROLLING, contact)
    )
    assert one.course.poses == pytest.approx(other.course.poses, abs=1e-8)


def coin(alpha: float, more: str = "") -> str:
    """A coin in the steady motion in which its centre stays: it turns about the radius to the contact."""
    R = 0.012
    rate = math.sqrt(4 * G / (R * math.sin(alpha))) * math.sin(alpha)
    spin = [rate * math.cos(alpha), rate * math.sin(alpha), 0.0]
    return TABLE + (
        f"bodies: {{coin: {{disk: {{mass: 0.01 kg, radius: {R}, axis: y}}, turned: {alpha} rad about z, "
        f"velocity: [0, 0, 0], angular_velocity: {spin}}}}}\n"
        f"connections: {{it: {{contact: {{between: [coin, ground.table], friction: 2{more}}}}}}}\n"
    )


def test_coin_rolls_round_by_the_steady_relation() -> None:
    """Omega^2 sin(alpha) = 4 g/R, and w = Omega sin(alpha). Source: Moffatt, Nature 404 (2000) 833-834."""
    alpha = 0.3
    found = fb.System.from_text(coin(alpha)).simulate(0.5, every=0.01)
    rotation = found.course.rotation
    assert rotation is not None
    assert found.course.poses[:, 0, 1] == pytest.approx(0.012 * math.sin(alpha), abs=1e-9)
    assert np.linalg.norm(rotation.velocities[:, 0], axis=1) == pytest.approx(
        math.sqrt(4 * G * math.sin(alpha) / 0.012), rel=1e-7
    )
    azimuth = np.unwrap(np.arctan2(rotation.velocities[:, 0, 2], rotation.velocities[:, 0, 0]))
    assert np.abs(np.diff(azimuth)) / 0.01 == pytest.approx(math.sqrt(4 * G / (0.012 * math.sin(alpha))), rel=1e-6)


def test_coin_with_rolling_resistance_settles_by_the_square_root() -> None:
    """Near the steady motions E = 3/2 m g R sin(alpha), and the resistance arm f takes f m g w cos(alpha): for small
    alpha d sqrt(alpha)/dt = -(2 f/(3 R)) sqrt(g/R), slower by the part that is not small."""
    f, alpha = 1e-5, 0.1
    found = fb.System.from_text(coin(alpha, f", rolling_resistance: {f}")).simulate(0.4, every=0.1)
    tilt = np.arcsin(found.course.poses[:, 0, 1] / 0.012)
    rate = -(2 * f / (3 * 0.012)) * math.sqrt(G / 0.012)
    assert (math.sqrt(tilt[-1]) - math.sqrt(tilt[0])) / 0.4 == pytest.approx(rate, rel=0.05)
