"""Impact laws: hand formulas, conservation of momentum, and what each law does to energy."""

from __future__ import annotations

import math

import numpy as np
import pytest

from freebody.numeric.contact.impacts import impact
from freebody.numeric.contact.keller import impact_without_collision
from freebody.numeric.contact.problem import ContactProblem, FrictionProblemRow, OutcomeCount, RowState
from freebody.numeric.options import ImpactLaw

LAWS = list(ImpactLaw)


def coulomb(row, normal, mu):
    return FrictionProblemRow(row, (mu, mu), (mu, mu), normals=(normal,))


def touching(J, masses, velocities, normals=(), dry_friction=()):
    J, inverse = np.asarray(J, float), 1.0 / np.asarray(masses, float)
    return ContactProblem((J * inverse) @ J.T, J @ np.asarray(velocities, float), tuple(normals), tuple(dry_friction))


def after(J, masses, velocities, outcome):
    return np.asarray(velocities, float) + np.asarray(J, float).T @ outcome.impulses / np.asarray(masses, float)


def energy(masses, velocities):
    return 0.5 * float(np.asarray(masses) @ np.asarray(velocities) ** 2)


# one contact

DISK_J = [[0, 1, 0], [1, 0, 1]]  # x, y, angle of a disk of radius 1: gap of its lowest point, and slip
DISK = [1.0, 1.0, 0.5]


@pytest.mark.parametrize("law", LAWS)
def test_ball_with_backspin_rebounds_with_e_and_slips_or_rolls_off(law):
    before, e = [1.0, -2.0, 3.0], 0.5
    p = (1 + e) * 2.0
    # slipping: T = -mu p; rolling: the slip 4 is stopped by T = -4/A_tt = -4/3
    for mu, T in ((0.1, -0.1 * p), (4.0 / 3.0 / p * 0.999, -4.0 / 3.0 * 0.999), (1.0, -4.0 / 3.0)):
        outcome = impact(touching(DISK_J, DISK, before, (0,), (coulomb(1, 0, mu),)), {0: e}, law)
        assert outcome.status is OutcomeCount.UNIQUE
        np.testing.assert_allclose(outcome.impulses, [p, T], rtol=1e-12)
        velocities = after(DISK_J, DISK, before, outcome)
        np.testing.assert_allclose(velocities, [1.0 + T, e * 2.0, 3.0 + 2.0 * T], rtol=1e-12)
        assert outcome.energy_change == pytest.approx(energy(DISK, velocities) - energy(DISK, before), rel=1e-12)
        assert not outcome.energy_grew


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("e", [0.0, 0.3, 1.0])
def test_bar_dropped_on_its_corner_turns_as_by_hand(law, e):
    # smooth floor: P = (1 + e) v m/(1 + 3 cos^2), omega = -P cos l/I
    m, half, angle, v = 2.0, 0.6, math.radians(35.0), 3.0
    inertia = m * half**2 / 3.0
    J = [[0, 1, -half * math.cos(angle)]]
    before = [0.0, -v, 0.0]
    outcome = impact(touching(J, [m, m, inertia], before, (0,)), {0: e}, law)
    P = (1 + e) * v * m / (1 + 3 * math.cos(angle) ** 2)
    assert outcome.impulses[0] == pytest.approx(P, rel=1e-12)
    expected = [0.0, -v + P / m, -P * half * math.cos(angle) / inertia]
    np.testing.assert_allclose(after(J, [m, m, inertia], before, outcome), expected, rtol=1e-12, atol=1e-14)
    assert outcome.velocities[0] == pytest.approx(e * v, rel=1e-12, abs=1e-14)


@pytest.mark.parametrize("law", LAWS)
def test_sticking_corner_of_a_bar_stops_its_slip_if_friction_suffices(law):
    # e = 0 and a rough floor: the corner stops, so the bar turns about it, I_corner omega = moment of momentum
    m, half, angle, v = 2.0, 0.6, math.radians(35.0), 3.0
    inertia = m * half**2 / 3.0
    x, y = -half * math.cos(angle), -half * math.sin(angle)
    J, masses, before = [[0, 1, x], [1, 0, -y]], [m, m, inertia], [0.0, -v, 0.0]
    outcome = impact(touching(J, masses, before, (0,), (coulomb(1, 0, 2.0),)), {0: 0.0}, law)
    np.testing.assert_allclose(outcome.velocities, 0.0, atol=1e-14)
    # about the corner, at (x, y) from G: L = m (-x) (-v)
    omega = m * x * v / (inertia + m * half**2)
    assert after(J, masses, before, outcome)[2] == pytest.approx(omega, rel=1e-12)


# several bodies


def two_disks(mu):
    """Disks of radius 1 touching on the x axis: x1, y1, angle1, x2, y2, angle2; gap x2 - x1, slip y2 - y1 - w2 - w1."""
    J = [[-1, 0, 0, 1, 0, 0], [0, -1, -1, 0, 1, -1]]
    return J, [1.0, 1.0, 0.5, 3.0, 3.0, 1.5], ((coulomb(1, 0, mu),) if mu else ())


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("mu", [0.05, 0.8])
def test_two_spinning_disks_keep_momentum_and_moment_of_momentum(law, mu):
    J, masses, dry_friction = two_disks(mu)
    before = np.array([2.0, 0.3, 4.0, -1.0, 0.0, -1.0])
    outcome = impact(touching(J, masses, before, (0,), dry_friction), {0: 0.6}, law)
    velocities = after(J, masses, before, outcome)
    m = np.array(masses)
    for row in ([1, 0, 0, 1, 0, 0], [0, 1, 0, 0, 1, 0]):
        assert np.dot(row, m * velocities) == pytest.approx(np.dot(row, m * before), rel=1e-12)
    about_first = np.array([0, 0, 1, 0, 2, 1])  # disk 2 is at x = 2
    assert np.dot(about_first, m * velocities) == pytest.approx(np.dot(about_first, m * before), rel=1e-12)
    # central: friction does not act back on the normal impulse, p = (1 + e) m1 m2/(m1 + m2) v
    assert outcome.impulses[0] == pytest.approx(1.6 * 0.75 * 3.0, rel=1e-12)
    assert outcome.energy_change == pytest.approx(energy(m, velocities) - energy(m, before), rel=1e-10)
    assert outcome.energy_change < 0.0


def test_row_of_three_balls_is_struck_at_once():
    # Newton at both contacts, ball 1 hits 2 and 3 at rest touching: simultaneous, not one after the other
    J = [[-1, 1, 0], [0, -1, 1]]
    before = [1.0, 0.0, 0.0]
    problem = touching(J, [1.0, 1.0, 1.0], before, (0, 1))
    newton, poisson = impact(problem, {0: 1.0, 1: 1.0}), impact(problem, {0: 1.0, 1: 1.0}, ImpactLaw.POISSON)
    np.testing.assert_allclose(newton.velocities, [1.0, 0.0], atol=1e-14)
    np.testing.assert_allclose(after(J, [1, 1, 1], before, newton), [-1 / 3, 2 / 3, 2 / 3], rtol=1e-12)
    # compression to the common velocity 1/3 by 2/3 and 1/3, and again: Glocker & Pfeiffer 1995 on Poisson's law
    np.testing.assert_allclose(poisson.impulses, [4 / 3, 2 / 3], rtol=1e-12)
    np.testing.assert_allclose(after(J, [1, 1, 1], before, poisson), [-1 / 3, 2 / 3, 2 / 3], rtol=1e-12)


def test_held_rows_stay_held_and_pass_impulses_on():
    # two masses joined by a rigid link hit the floor with the first: the whole mass is stopped
    J = [[-1, 1], [1, 0]]
    for law in LAWS:
        outcome = impact(touching(J, [2.0, 3.0], [-1.0, -1.0], (1,)), {1: 0.5}, law)
        np.testing.assert_allclose(after(J, [2.0, 3.0], [-1.0, -1.0], outcome), [0.5, 0.5], rtol=1e-12)
        assert outcome.impulses[1] == pytest.approx(5.0 * 1.5, rel=1e-12)


def test_held_rows_that_were_violated_are_restored():
    outcome = impact(touching([[-1, 1]], [2.0, 3.0], [1.0, 0.0]), {})
    np.testing.assert_allclose(after([[-1, 1]], [2.0, 3.0], [1.0, 0.0], outcome), [0.4, 0.4], rtol=1e-12)
    assert outcome.energy_change == pytest.approx(-0.5 * (2 * 3 / 5) * 1.0, rel=1e-12)


def test_brake_has_no_impulse_and_a_dry_slider_has():
    brake = FrictionProblemRow(1, (50.0, 50.0), (50.0, 50.0), constant=1.0)
    for law in LAWS:
        outcome = impact(touching(np.eye(2), [1.0, 1.0], [-1.0, 2.0], (0,), (brake,)), {0: 0.5}, law)
        assert outcome.impulses[1] == 0.0
        assert outcome.velocities[1] == 2.0
        assert outcome.mode[1] is RowState.ABSENT
    # a mass in a horizontal guide (row 0) strikes an oblique wall (row 1); guide friction mu |P0| (row 2)
    mu = 0.1
    slider = FrictionProblemRow(2, (mu, mu), (mu, mu), magnitudes=((0,),))
    J = [[0, 1], [-0.8, -0.6], [1, 0]]
    outcome = impact(touching(J, [1.0, 1.0], [1.0, 0.0], (1,), (slider,)), {1: 0.5})
    assert outcome.status is OutcomeCount.UNIQUE
    # P0 = 0.6 p; leftwards afterwards, so friction +mu 0.6 p: -0.8 p + 0.06 p = -1.5
    p = 1.5 / 0.74
    np.testing.assert_allclose(outcome.impulses, [0.6 * p, p, 0.06 * p], rtol=1e-12)
    assert after(J, [1.0, 1.0], [1.0, 0.0], outcome)[0] == pytest.approx(-0.5, rel=1e-12)


# energy


@pytest.mark.parametrize("law", [ImpactLaw.NEWTON, ImpactLaw.POISSON])
@pytest.mark.parametrize("seed", range(25))
def test_impacts_without_friction_never_gain_energy_with_one_coefficient(law, seed):
    print("seed", seed)
    rng = np.random.default_rng(seed)
    nq, n = int(rng.integers(2, 7)), int(rng.integers(1, 5))
    J, before = rng.normal(size=(n, nq)), rng.normal(size=nq)
    if law is ImpactLaw.NEWTON:
        J *= -np.sign(J @ before)[:, None]  # all contacts approach; where some part, Newton's law may gain or have none
    problem = touching(J, rng.uniform(0.1, 5.0, nq), before, range(n))
    e = float(rng.uniform(0.0, 1.0))
    outcome = impact(problem, dict.fromkeys(range(n), e), law)
    assert outcome.status is OutcomeCount.UNIQUE
    size = float(np.abs(outcome.impulses) @ np.abs(problem.b))
    assert outcome.energy_change <= 1e-12 * size
    assert not outcome.energy_grew
    u = problem.A @ outcome.impulses + problem.b
    assert (u >= -1e-10).all()
    assert (outcome.impulses >= 0.0).all()


def test_elastic_impacts_without_friction_keep_energy():
    rng = np.random.default_rng(1)
    problem = touching(rng.normal(size=(1, 5)), np.ones(5), rng.normal(size=5), (0,))
    problem = problem if problem.b[0] < 0 else ContactProblem(problem.A, -problem.b, (0,))
    for law in LAWS:
        outcome = impact(problem, {0: 1.0}, law)
        assert outcome.impulses[0] > 0.0
        assert outcome.energy_change == pytest.approx(0.0, abs=1e-14)


def double_pendulum(q1, q2, u1, u2, mu):
    """Two uniform rods of length and mass 1 hanging from a pin; the end strikes a floor. Kane & Levinson's puzzle."""
    s1, c1, s2, c2 = math.sin(q1), math.cos(q1), math.sin(q2), math.cos(q2)
    M = np.array([[4 / 3, math.cos(q1 - q2) / 2], [math.cos(q1 - q2) / 2, 1 / 3]])
    J = np.array([[s1, s2], [c1, c2]])
    return ContactProblem(J @ np.linalg.solve(M, J.T), J @ np.array([u1, u2]), (0,), (coulomb(1, 0, mu),))


def test_newtons_law_makes_energy_of_kanes_double_pendulum_and_says_so_while_the_others_do_not():
    problem = double_pendulum(math.radians(20.0), math.radians(30.0), -0.1, -0.2, 0.5)
    newton = impact(problem, {0: 0.7})
    assert newton.energy_grew
    assert newton.energy_change > 0.0
    assert newton.velocities[0] == pytest.approx(-0.7 * problem.b[0], rel=1e-12)
    for law in (ImpactLaw.POISSON, ImpactLaw.KELLER):
        other = impact(problem, {0: 0.7}, law)
        assert not other.energy_grew
        assert other.energy_change < 0.0


@pytest.mark.parametrize("law", [ImpactLaw.POISSON, ImpactLaw.KELLER])
def test_poisson_and_keller_lose_energy_on_random_double_pendulums(law):
    rng = np.random.default_rng(7)
    print("seed", 7)
    struck = 0
    for _ in range(150):
        problem = double_pendulum(*rng.uniform(-1.2, 1.2, 2), *rng.normal(size=2), rng.uniform(0.0, 1.5))
        if problem.b[0] < 0.0:
            outcome = impact(problem, {0: float(rng.uniform())}, law)
            assert outcome.is_found
            assert not outcome.energy_grew
            struck += 1
    assert struck > 30


# Keller's process


def leaning_rod(theta, mu, velocities):
    """A uniform rod of length 2 and mass 1 on its lower end."""
    J = [[0, 1, -math.cos(theta)], [1, 0, math.sin(theta)]]
    return J, touching(J, [1, 1, 1 / 3], velocities, (0,), (coulomb(1, 0, mu),))


def test_jammed_rod_stops_its_slip_in_an_impact_without_collision():
    theta, mu = math.radians(60.0), 1.6
    _, problem = leaning_rod(theta, mu, [-1.0, 0.0, 0.0])
    A = problem.A
    assert A[0, 0] + mu * A[0, 1] < 0.0 or A[0, 0] - mu * A[0, 1] < 0.0  # Painleve's condition for this slip
    outcome = impact_without_collision(problem, 0.0)
    assert outcome.status is OutcomeCount.UNIQUE
    assert outcome.mode == (RowState.CLOSED, RowState.STICKING)
    np.testing.assert_allclose(outcome.velocities, 0.0, atol=1e-14)
    # both velocities of the end vanish: P = -A^-1 u
    np.testing.assert_allclose(outcome.impulses, -np.linalg.solve(A, problem.b), rtol=1e-12)
    assert outcome.energy_change < 0.0
    bouncing = impact_without_collision(problem, 0.5)
    assert bouncing.impulses[0] == pytest.approx(1.5 * outcome.impulses[0], rel=1e-12)
    assert bouncing.velocities[0] > 0.0


def followed(A, u, mu, e, n_steps=200_000):
    """Keller's process by small steps of the normal impulse."""
    w, v, T, p = u[0], u[1], 0.0, 0.0
    scale = abs(u).max() / A.diagonal().min()
    dp = 20.0 * scale / n_steps
    compressed = None
    for _ in range(n_steps):
        rate = -mu * math.copysign(1.0, v)
        stick = -A[0, 1] / A[1, 1]
        if abs(v) <= abs(A[0, 1] + rate * A[1, 1]) * dp and abs(stick) <= mu:
            rate, v = stick, 0.0
        w += (A[0, 0] + rate * A[0, 1]) * dp
        v += (A[0, 1] + rate * A[1, 1]) * dp
        T, p = T + rate * dp, p + dp
        if compressed is None and w >= 0.0:
            compressed = p
        if compressed is not None and p >= (1 + e) * compressed:
            return np.array([p, T])
    raise AssertionError("the process did not end")


@pytest.mark.parametrize("seed", range(6))
def test_process_agrees_with_small_steps_of_the_impulse(seed):
    print("seed", seed)
    rng = np.random.default_rng(seed)
    theta, mu, e = rng.uniform(0.3, 1.3), float(rng.uniform(0.0, 1.2)), float(rng.uniform(0.1, 0.9))
    _, problem = leaning_rod(theta, mu, [rng.normal(), -abs(rng.normal()) - 1.0, 0.0])
    outcome = impact_without_collision(problem, e)
    expected = followed(problem.A, problem.b, mu, e)
    np.testing.assert_allclose(outcome.impulses, expected, rtol=2e-3, atol=2e-3 * expected[0])


def test_poisson_and_keller_agree_where_slip_keeps_its_direction():
    _, problem = leaning_rod(1.0, 0.1, [5.0, -1.0, 0.0])
    poisson, keller = impact(problem, {0: 0.6}, ImpactLaw.POISSON), impact(problem, {0: 0.6}, ImpactLaw.KELLER)
    np.testing.assert_allclose(poisson.impulses, keller.impulses, rtol=1e-12)
    assert keller.mode == (RowState.CLOSED, RowState.FORWARD)


def test_parting_contact_has_no_impulse():
    _, problem = leaning_rod(1.0, 0.3, [1.0, 0.5, 0.0])
    for law in LAWS:
        outcome = impact(problem, {0: 0.5}, law)
        np.testing.assert_allclose(outcome.impulses, 0.0)
        np.testing.assert_allclose(outcome.velocities, problem.b)


@pytest.mark.parametrize("law", LAWS)
def test_mirrored_impact_has_the_mirrored_impulses(law):
    _, problem = leaning_rod(0.8, 0.3, [0.4, -1.0, 0.2])
    flip = np.array([1.0, -1.0])
    mirrored = ContactProblem(flip[:, None] * problem.A * flip, flip * problem.b, problem.normals, problem.dry_friction)
    one, other = impact(problem, {0: 0.5}, law), impact(mirrored, {0: 0.5}, law)
    np.testing.assert_allclose(flip * other.impulses, one.impulses, rtol=1e-12)


def test_two_contacts_cannot_be_followed_and_restitution_above_one_is_refused():
    with pytest.raises(ValueError, match="one normal"):
        impact(touching(np.eye(2), [1, 1], [-1, -1], (0, 1)), {}, ImpactLaw.KELLER)
    with pytest.raises(ValueError, match="restitution"):
        impact(touching(np.eye(1), [1], [-1], (0,)), {0: 1.1})
