"""Contact forces: closed forms, Painleve's rod, and every condition on random problems."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest

from freebody.numeric.contact.forces import contact_forces
from freebody.numeric.contact.problem import ContactProblem, FrictionProblemRow, OutcomeCount, RowState
from freebody.numeric.contact.ranges import Feasible, force_ranges

G = 9.81
OPEN, CLOSED, STICKING = RowState.OPEN, RowState.CLOSED, RowState.STICKING
FORWARD, BACKWARD, ABSENT = RowState.FORWARD, RowState.BACKWARD, RowState.ABSENT


def assembled(J, masses, force, normals=(), dry_friction=(), bias=None):
    J, force = np.atleast_2d(np.asarray(J, float)), np.asarray(force, float)
    inverse = 1.0 / np.asarray(masses, float)
    b = J @ (inverse * force) + (0.0 if bias is None else np.asarray(bias, float))
    return ContactProblem((J * inverse) @ J.T, b, tuple(normals), tuple(dry_friction))


def coulomb(row, normal, static, kinetic=None, sliding=0):
    kinetic = static if kinetic is None else kinetic
    return FrictionProblemRow(row, (static, static), (kinetic, kinetic), normals=(normal,), sliding=sliding)


def assert_holds(problem, outcome, tolerance=1e-9):
    """Every condition, from the matrices alone."""
    forces, a = outcome.forces, problem.A @ outcome.forces + problem.b
    size = tolerance * (np.abs(problem.A) @ np.abs(forces) + np.abs(problem.b)).max() + 1e-300
    force_size = tolerance * np.abs(forces).max() + size / max(problem.A.diagonal().max(), 1e-300)
    np.testing.assert_allclose(outcome.accelerations, a, atol=10 * size)
    for row in problem.held_rows:
        assert abs(a[row]) <= size
    for row in problem.normals:
        assert forces[row] >= -force_size
        assert a[row] >= -size
        assert (abs(a[row]) <= size) if outcome.mode[row] is CLOSED else forces[row] == 0.0
    for rub in problem.dry_friction:
        T, load, state = forces[rub.row], rub.load(forces), outcome.mode[rub.row]
        slack = force_size * (1.0 + max(rub.static))
        if state is ABSENT:
            assert T == 0.0
            assert load <= force_size
        elif state is STICKING:
            assert rub.sliding == 0
            assert abs(a[rub.row]) <= size
            assert -rub.static[0] * load - slack <= T <= rub.static[1] * load + slack
        else:
            sign = 1 if state is FORWARD else -1
            c = rub.kinetic[0] if sign > 0 else rub.kinetic[1]
            assert abs(T + sign * c * load) <= slack
            assert rub.sliding in (0, sign)
            assert rub.sliding or sign * a[rub.row] >= -size


# blocks


def block_on_slope(angle, static, kinetic=None, mass=3.0):
    return assembled(
        np.eye(2)[::-1],
        [mass, mass],
        [mass * G * math.sin(angle), -mass * G * math.cos(angle)],
        (0,),
        (coulomb(1, 0, static, kinetic),),
    )


@pytest.mark.parametrize("kinetic", [None, 0.4])
@pytest.mark.parametrize("mass", [1e-4, 1.0, 1e5])
def test_block_on_a_slope_sticks_or_slips_as_the_coefficient_passes_the_tangent_by_1e_9(kinetic, mass):
    angle = math.radians(30.0)
    below, above = (block_on_slope(angle, math.tan(angle) + d, kinetic, mass) for d in (-1e-9, 1e-9))
    slips, sticks = contact_forces(below), contact_forces(above)
    assert slips.status is sticks.status is OutcomeCount.UNIQUE
    assert slips.mode == (CLOSED, FORWARD)
    assert sticks.mode == (CLOSED, STICKING)
    c = math.tan(angle) - 1e-9 if kinetic is None else kinetic
    assert slips.accelerations[1] == pytest.approx(G * (math.sin(angle) - c * math.cos(angle)), rel=1e-5)
    assert sticks.forces[1] == pytest.approx(-mass * G * math.sin(angle), rel=1e-14)


def test_at_the_limit_itself_the_block_sticks_unless_the_caller_forbids_it():
    angle = math.radians(30.0)
    problem = block_on_slope(angle, math.tan(angle), 0.4)
    assert contact_forces(problem).mode == (CLOSED, STICKING)
    slips = contact_forces(problem, forbidden=[(1, STICKING)])
    assert slips.mode == (CLOSED, FORWARD)
    assert slips.accelerations[1] == pytest.approx(G * (math.sin(angle) - 0.4 * math.cos(angle)), rel=1e-12)


def test_a_slip_that_is_forced_at_an_event_is_taken_although_it_is_rounded_to_the_wrong_side():
    angle = math.radians(30.0)
    problem = block_on_slope(angle, math.tan(angle) + 1e-10)
    assert contact_forces(problem, forbidden=[(1, STICKING), (1, BACKWARD)]).mode == (CLOSED, FORWARD)


def test_a_contact_without_force_and_acceleration_is_closed_unless_forbidden():
    problem = assembled([[1.0]], [2.0], [0.0], (0,))
    assert contact_forces(problem).mode == (CLOSED,)
    assert contact_forces(problem, forbidden=[(0, CLOSED)]).mode == (OPEN,)


def test_upper_of_two_stacked_blocks_slips_on_the_lower_when_that_is_pushed_too_hard():
    m, M, mu = 1.0, 4.0, 0.5
    # x1, y1 (lower), x2, y2; normals: ground, between; rub: x1 - x2 has the sign of the lower one moving ahead
    J = [[0, 1, 0, 0], [0, -1, 0, 1], [1, 0, -1, 0]]
    for push, mode in ((0.99 * (m + M) * mu * G, STICKING), (1.01 * (m + M) * mu * G, FORWARD)):
        problem = assembled(J, [M, M, m, m], [push, -M * G, 0, -m * G], (0, 1), (coulomb(2, 1, mu),))
        outcome = contact_forces(problem)
        assert_holds(problem, outcome)
        assert outcome.mode == (CLOSED, CLOSED, mode)
        np.testing.assert_allclose(outcome.forces[:2], [(m + M) * G, m * G], rtol=1e-13)
        expected = -m * push / (m + M) if mode is STICKING else -mu * m * G
        assert outcome.forces[2] == pytest.approx(expected, rel=1e-12)


def test_block_slides_down_a_movable_wedge_as_in_the_textbook():
    m, M, angle = 2.0, 5.0, math.radians(35.0)
    s, c = math.sin(angle), math.cos(angle)
    # block (x, y), wedge X; gap along the normal (s, c)... seen from the wedge, slip along (c, -s)
    problem = assembled([[s, c, -s]], [m, m, M], [0, -m * G, 0], (0,))
    outcome = contact_forces(problem)
    # N = m M g cos/(M + m sin^2)
    assert outcome.forces[0] == pytest.approx(m * M * G * c / (M + m * s * s), rel=1e-13)


def ladder(angle, mu, length=3.0, mass=8.0):
    # G = (x, y), foot at -l/2 (cos, sin) from G, top at +l/2: floor (y up) and wall on the right (x < 0 allowed)
    h = length / 2.0
    foot, top = (-h * math.cos(angle), -h * math.sin(angle)), (h * math.cos(angle), h * math.sin(angle))
    J = [[0, 1, foot[0]], [-1, 0, top[1]], [1, 0, -foot[1]]]
    inertia = mass * length**2 / 12.0
    return assembled(J, [mass, mass, inertia], [0, -mass * G, 0], (0, 1), (coulomb(2, 0, mu),))


def test_ladder_against_a_smooth_wall_stands_where_the_foot_carries_half_its_weight_over_the_tangent():
    mu = 0.4
    limit = math.atan(1.0 / (2.0 * mu))
    stands, slides = ladder(limit + 1e-7, mu), ladder(limit - 1e-7, mu)
    outcome = contact_forces(stands)
    assert_holds(stands, outcome)
    assert outcome.mode == (CLOSED, CLOSED, STICKING)
    assert outcome.forces[1] == pytest.approx(8.0 * G / (2.0 * math.tan(limit + 1e-7)), rel=1e-10)
    moving = contact_forces(slides)
    assert_holds(slides, moving)
    assert moving.mode == (CLOSED, CLOSED, BACKWARD)


def box(push, height, mu, half_width=0.5, half_height=0.8, mass=2.0):
    """A box on two corners, pushed to the right at a height above its centre."""
    inertia = mass * (half_width**2 + half_height**2) / 3.0
    J = [[0, 1, -half_width], [0, 1, half_width], [1, 0, half_height], [1, 0, half_height]]
    force = [push, -mass * G, -push * height]
    return assembled(J, [mass, mass, inertia], force, (0, 1), (coulomb(2, 0, mu), coulomb(3, 1, mu)))


def test_pushed_box_tips_slides_or_stands_as_moments_and_friction_say():
    mass, w, h = 2.0, 0.5, 0.8
    for push, height, mu, mode in (
        (0.99 * mass * G * w / (h + 0.3), 0.3, 2.0, (CLOSED, CLOSED, STICKING, STICKING)),
        (1.01 * mass * G * w / (h + 0.3), 0.3, 2.0, (OPEN, CLOSED, ABSENT, STICKING)),
        (0.21 * mass * G, 0.0, 0.2, (CLOSED, CLOSED, FORWARD, FORWARD)),
    ):
        problem = box(push, height, mu)
        outcome = contact_forces(problem)
        assert_holds(problem, outcome)
        assert outcome.status is OutcomeCount.UNIQUE
        assert outcome.mode == mode


def test_friction_of_a_box_about_to_tip_is_carried_where_it_is_pressed():
    # equal shares would overload the corner that hardly presses; the forces are chosen within both cones
    problem = box(0.999 * 2.0 * G * 0.5 / 1.1, 0.3, 0.5)
    outcome = contact_forces(problem)
    assert_holds(problem, outcome)
    assert outcome.mode == (CLOSED, CLOSED, STICKING, STICKING)


# friction that is not of a contact


def test_brake_holds_up_to_its_static_torque_and_drags_with_the_kinetic_one():
    for torque, state, expected in ((9.9, STICKING, -9.9), (10.1, FORWARD, -7.0), (-10.1, BACKWARD, 7.0)):
        problem = assembled(
            [[1.0]], [0.2], [torque], (), (FrictionProblemRow(0, (10.0, 10.0), (7.0, 7.0), constant=1.0),)
        )
        outcome = contact_forces(problem)
        assert_holds(problem, outcome)
        assert outcome.mode == (state,)
        assert outcome.forces[0] == pytest.approx(expected)


@pytest.mark.parametrize("push", [3.0, -3.0])
def test_dry_slider_rubs_with_the_magnitude_of_its_guide_force(push):
    mu, mass = 0.3, 2.0
    rub = FrictionProblemRow(1, (mu, mu), (mu, mu), magnitudes=((0,),), sliding=1)
    problem = assembled([[0, 1], [1, 0]], [mass, mass], [10.0, push], (), (rub,))
    outcome = contact_forces(problem)
    assert_holds(problem, outcome)
    assert outcome.forces[1] == pytest.approx(-mu * abs(push))


def test_oblique_guide_is_solved_for_both_signs_of_its_force():
    # the slip row is not orthogonal to the held one, so friction changes the guide force it depends on
    mu = 0.4
    J = np.array([[0.0, 1.0], [1.0, 0.5]])
    rub = FrictionProblemRow(1, (mu, mu), (mu, mu), magnitudes=((0,),), sliding=1)
    problem = assembled(J, [1.0, 1.0], [1.0, -2.0], (), (rub,))
    outcome = contact_forces(problem)
    assert_holds(problem, outcome)
    assert outcome.status is OutcomeCount.UNIQUE


@pytest.mark.parametrize("angle", [0.3, 1.5, 4.0])
def test_pin_friction_follows_the_resultant_of_the_pin_force(angle):
    mu_r = 0.02
    rub = FrictionProblemRow(2, (mu_r, mu_r), (mu_r, mu_r), magnitudes=((0, 1),), sliding=-1)
    arm = 0.7
    # a body pinned at `arm` from its centre
    J = [[1, 0, arm * math.sin(angle)], [0, 1, -arm * math.cos(angle)], [0, 0, 1]]
    problem = assembled(J, [2.0, 2.0, 0.3], [1.0, -2.0 * G, 0.5], (), (rub,), bias=[3.0, -1.0, 0.0])
    outcome = contact_forces(problem)
    assert_holds(problem, outcome, 1e-12)
    assert outcome.forces[2] == pytest.approx(mu_r * math.hypot(*outcome.forces[:2]), rel=1e-12)


def test_belt_around_a_post_holds_between_the_two_ratios_of_euler():
    # rows: tension of the held side (positive), slip of the belt towards growing s; limits differ by direction
    grip = math.exp(0.3 * math.pi)
    for pull, state in ((grip * 5.0 * 0.999, STICKING), (grip * 5.0 * 1.001, FORWARD)):
        # slip forward: T = -(e - 1) 5; backward: T = (1 - 1/e) 5
        limits = (grip - 1.0, 1.0 - 1.0 / grip)
        rub = FrictionProblemRow(1, limits, limits, normals=(0,))
        problem = assembled([[-1, 0], [0, 1]], [1.0, 1.0], [5.0, pull - 5.0], (0,), (rub,))
        outcome = contact_forces(problem)
        assert_holds(problem, outcome)
        assert outcome.mode[1] is state


def test_load_of_a_held_row_presses_like_a_normal():
    rub = FrictionProblemRow(1, (0.5, 0.5), (0.5, 0.5), normals=(0,), sliding=1)
    problem = assembled(np.eye(2), [1.0, 1.0], [-4.0, 0.0], (), (rub,))
    outcome = contact_forces(problem)
    assert_holds(problem, outcome)
    np.testing.assert_allclose(outcome.forces, [4.0, -2.0])


# Painleve's rod


def painleve_rod(theta, mu, sliding):
    """A uniform rod of length 2 and mass 1, its lower end on the floor, leaning by theta towards +x.

    A_nn = 1 + 3 cos^2, A_tn = -3 sin cos, b_n = -g. If the end slides towards -x, T = mu N and
    a_n = (1 + 3 cos^2 - 3 mu sin cos) N - g, whose factor is negative where tan^2 - 3 mu tan + 4 < 0.
    Champneys & Varkonyi 2016, sec. 2: possible from mu = 4/3, at tan theta = 2.
    """
    x, y = -math.cos(theta), -math.sin(theta)
    return assembled([[0, 1, x], [1, 0, -y]], [1, 1, 1 / 3], [0, -G, 0], (0,), (coulomb(1, 0, mu, sliding=sliding),))


def test_rod_has_no_consistent_force_exactly_between_the_two_angles():
    # tan t of A_nn = mu A_tn: tan^2 - 3 mu tan + 4 = 0
    mu = 1.4
    roots = [math.atan((3 * mu + s * math.sqrt(9 * mu**2 - 16)) / 2) for s in (-1, 1)]
    assert np.degrees(roots) == pytest.approx([55.586, 69.951], abs=1e-3)
    for root, inside in ((roots[0], 1e-6), (roots[1], -1e-6)):
        within, beyond = (contact_forces(painleve_rod(root + d, mu, -1)) for d in (inside, -inside))
        assert within.status is OutcomeCount.NONE
        assert within.is_proven
        assert np.isnan(within.forces).all()
        assert beyond.status is OutcomeCount.UNIQUE
        assert beyond.mode == (CLOSED, BACKWARD)
    for theta in np.radians([1.0, 30.0, 55.5, 60.0, 70.0, 89.0]):
        assert contact_forces(painleve_rod(theta, mu, 1)).status is OutcomeCount.UNIQUE


def test_critical_friction_of_the_rod_is_four_thirds():
    theta = math.atan(2.0)
    assert contact_forces(painleve_rod(theta, 4 / 3 - 1e-6, -1)).status is OutcomeCount.UNIQUE
    assert contact_forces(painleve_rod(theta, 4 / 3 + 1e-6, -1)).status is OutcomeCount.NONE


def test_rod_that_would_lift_off_has_both_a_lifting_and_a_jammed_outcome():
    problem = painleve_rod(math.radians(60.0), 1.4, -1)
    lifting = ContactProblem(problem.A, problem.b + np.array([2.0 * G, 0.0]), problem.normals, problem.dry_friction)
    outcome = contact_forces(lifting)
    assert outcome.status is OutcomeCount.SEVERAL
    assert {outcome.mode, *outcome.alternatives} == {(CLOSED, BACKWARD), (OPEN, ABSENT)}
    assert outcome.mode == (CLOSED, BACKWARD)  # lasting contact without further word
    assert contact_forces(lifting, (OPEN, ABSENT)).mode == (OPEN, ABSENT)
    assert contact_forces(lifting, (OPEN, ABSENT)).status is OutcomeCount.SEVERAL
    only = contact_forces(lifting, forbidden=[(0, CLOSED)])
    assert only.status is OutcomeCount.UNIQUE
    assert only.mode == (OPEN, ABSENT)


# random problems


def random_problem(rng):
    nq, n_contacts = int(rng.integers(3, 8)), int(rng.integers(1, 4))
    n_held = int(rng.integers(0, 3))
    J = rng.normal(size=(n_held + 2 * n_contacts, nq))
    if n_held == 2 and rng.random() < 0.4:
        J[1] = 2.0 * J[0]
    dry_friction = []
    for k in range(n_contacts):
        static = float(rng.uniform(0.0, 1.2))
        kinetic = static * float(rng.choice([1.0, 0.6]))
        sliding = int(rng.integers(-1, 2))
        dry_friction.append(coulomb(n_held + n_contacts + k, n_held + k, static, kinetic, sliding))
    normals = range(n_held, n_held + n_contacts)
    return assembled(J, rng.uniform(0.1, 10.0, nq), 5.0 * rng.normal(size=nq), normals, dry_friction)


def consistent_modes(problem, forced_kinetic):
    """Independent enumeration: all forces that meet the conditions, with kinetic or with static slip at rest."""
    found = []
    n = problem.n
    held = list(problem.held_rows)
    for gaps in product((True, False), repeat=len(problem.normals)):
        choices = [
            [None] if not gaps[k] else [rub.sliding] if rub.sliding else [0, 1, -1]
            for k, rub in enumerate(problem.dry_friction)
        ]
        for states in product(*choices):
            E, r = np.eye(n), np.zeros(n)
            for row in held + [row for row, closed in zip(problem.normals, gaps, strict=True) if closed]:
                E[row], r[row] = problem.A[row], -problem.b[row]
            for rub, s in zip(problem.dry_friction, states, strict=True):
                if s == 0:
                    E[rub.row], r[rub.row] = problem.A[rub.row], -problem.b[rub.row]
                elif s is not None:
                    c = rub.kinetic[0] if rub.sliding or forced_kinetic else rub.static[0]
                    E[rub.row, rub.normals[0]] = s * c
            forces = np.linalg.lstsq(E, r, rcond=1e-12)[0]
            a = problem.A @ forces + problem.b
            ok = np.abs(E @ forces - r).max() < 1e-7
            ok &= all(forces[row] > -1e-8 and a[row] > -1e-8 for row in problem.normals)
            for rub, s in zip(problem.dry_friction, states, strict=True):
                if s == 0:
                    ok &= abs(forces[rub.row]) <= rub.static[0] * forces[rub.normals[0]] + 1e-8
                elif s is not None and not rub.sliding:
                    ok &= s * a[rub.row] > -1e-8
            if ok:
                found.append(a)
    return found


@pytest.mark.parametrize("seed", range(150))
def test_random_outcomes_meet_all_conditions_and_none_is_confirmed_by_enumeration(seed):
    print("seed", seed)
    problem = random_problem(np.random.default_rng(seed))
    outcome = contact_forces(problem)
    with_static, with_kinetic = consistent_modes(problem, False), consistent_modes(problem, True)
    if outcome.is_found:
        assert_holds(problem, outcome)
    n_held = len(problem.held_rows)
    free = np.linalg.matrix_rank(problem.A) - np.linalg.matrix_rank(problem.A[:n_held, :n_held])
    if free < problem.n - n_held:
        return  # redundant contacts: least-norm forces, as enumerated here, may miss what other forces can do
    if outcome.is_found:
        assert any(np.allclose(outcome.accelerations, a, rtol=1e-6, atol=1e-6) for a in with_kinetic)
    else:
        assert outcome.status is OutcomeCount.NONE
        assert not with_static or not with_kinetic
    if all(rub.sliding or rub.static == rub.kinetic for rub in problem.dry_friction):
        distinct = []
        for a in with_kinetic:
            if not any(np.allclose(a, other, rtol=1e-6, atol=1e-6) for other in distinct):
                distinct.append(a)
        assert len(distinct) == (1 + len(outcome.alternatives) if outcome.is_found else 0)


@pytest.mark.parametrize("seed", range(30))
def test_mirrored_problem_gives_the_mirrored_answer(seed):
    print("seed", seed)
    rng = np.random.default_rng(500 + seed)
    problem = random_problem(rng)
    flip = np.ones(problem.n)
    flip[[rub.row for rub in problem.dry_friction]] = -1.0
    turned = tuple(
        FrictionProblemRow(r.row, r.static[::-1], r.kinetic[::-1], normals=r.normals, sliding=-r.sliding)
        for r in problem.dry_friction
    )
    mirrored = ContactProblem(flip[:, None] * problem.A * flip, flip * problem.b, problem.normals, turned)
    one, other = contact_forces(problem), contact_forces(mirrored)
    assert one.status is other.status
    assert 1 + len(one.alternatives) == 1 + len(other.alternatives)
    if one.status is OutcomeCount.UNIQUE:
        np.testing.assert_allclose(flip * other.forces, one.forces, rtol=1e-9, atol=1e-9)
        swap = {FORWARD: BACKWARD, BACKWARD: FORWARD}
        assert tuple(swap.get(s, s) for s in other.mode) == one.mode


@pytest.mark.parametrize("seed", range(40))
def test_without_looking_for_others_the_outcome_is_one_of_all(seed):
    print("seed", seed)
    problem = random_problem(np.random.default_rng(900 + seed))
    all_of_them, quick = contact_forces(problem), contact_forces(problem, check_others=False)
    if all_of_them.status is OutcomeCount.UNIQUE:
        np.testing.assert_allclose(quick.accelerations, all_of_them.accelerations, rtol=1e-7, atol=1e-8)
    elif all_of_them.status is OutcomeCount.NONE:
        assert not quick.is_found


@pytest.mark.parametrize("seed", range(30))
def test_chains_of_rubbing_pins_are_solved_to_the_last_digits(seed):
    print("seed", seed)
    rng = np.random.default_rng(seed)
    n_pins = int(rng.integers(1, 4))
    radius = float(rng.choice([0.02, 0.1, 0.3]))
    dry_friction = [
        FrictionProblemRow(
            2 * n_pins + k,
            (radius, radius),
            (0.8 * radius, 0.8 * radius),
            magnitudes=((2 * k, 2 * k + 1),),
            sliding=int(rng.integers(-1, 2)),
        )
        for k in range(n_pins)
    ]
    nq = 3 * n_pins + 1
    problem = assembled(
        rng.normal(size=(3 * n_pins, nq)), rng.uniform(0.3, 3.0, nq), rng.normal(size=nq), (), dry_friction
    )
    outcome = contact_forces(problem)
    assert outcome.is_found
    assert_holds(problem, outcome, 1e-11)


@pytest.mark.parametrize("seed", range(20))
def test_many_contacts_are_solved_by_pivots_alone(seed):
    print("seed", seed)
    rng = np.random.default_rng(seed)
    n = 12
    # bodies on a floor, coupled weakly
    J = np.kron(np.eye(n), np.eye(2)) + 0.05 * rng.normal(size=(2 * n, 2 * n))
    order = [*range(1, 2 * n, 2), *range(0, 2 * n, 2)]
    dry_friction = [coulomb(n + k, k, 0.4, 0.3) for k in range(n)]
    problem = assembled(J[order], np.ones(2 * n), rng.normal(size=2 * n) * 4.0, range(n), dry_friction)
    outcome = contact_forces(problem)
    assert outcome.is_found
    assert_holds(problem, outcome)


def test_contradictory_held_rows_have_no_forces_and_redundant_ones_share_them():
    J = [[1.0, 0.0], [1.0, 0.0]]
    shared = contact_forces(assembled(J, [1.0, 1.0], [3.0, 0.0]))
    np.testing.assert_allclose(shared.forces, [-1.5, -1.5])
    assert contact_forces(assembled(J, [1.0, 1.0], [3.0, 0.0], bias=[0.0, 1.0])).status is OutcomeCount.NONE


# ranges of reactions


def table(legs, load_at, weight=10.0):
    J = [[1.0, x] for x in legs]
    return assembled(J, [1.0, 1.0], [-weight, -weight * load_at], range(len(legs)))


def test_each_leg_of_a_four_legged_table_carries_between_the_extremes_of_the_linear_programme():
    # legs at -1, -0.4, 0.5, 1; weight 10 at 0: extremes are supports on two legs
    problem = table((-1.0, -0.4, 0.5, 1.0), 0.0)
    outcome = contact_forces(problem)
    assert_holds(problem, outcome)
    ranges = force_ranges(problem, outcome.accelerations, outcome.mode)
    assert ranges.feasible is Feasible.YES
    np.testing.assert_allclose(ranges.low, 0.0, atol=1e-9)
    # leg -1 with leg 1: 5; leg -0.4 with leg 1: 10/1.4; leg 0.5 with leg -1: 10/1.5; leg 1 with leg -1: 5
    np.testing.assert_allclose(ranges.high, [5.0, 10 / 1.4, 10 / 1.5, 5.0], rtol=1e-9)
    assert not ranges.is_unique


def test_two_legs_have_one_answer_and_a_load_beyond_the_legs_has_none_at_rest():
    problem = table((-1.0, 1.0), 0.5)
    ranges = force_ranges(problem, np.zeros(2), (CLOSED, CLOSED))
    assert ranges.is_unique
    np.testing.assert_allclose(ranges.low, [2.5, 7.5], rtol=1e-12)
    beyond = force_ranges(table((-1.0, 1.0), 1.5), np.zeros(2), (CLOSED, CLOSED))
    assert beyond.feasible is Feasible.NO_ADMISSIBLE_FORCES
    assert np.isnan(beyond.low).all()


def wedged(mu, weight=10.0):
    J = [[1, 0, 0], [-1, 0, 0], [0, 1, -1], [0, 1, 1]]
    return assembled(J, [1, 1, 1], [0, -weight, 0], (0, 1), (coulomb(2, 0, mu), coulomb(3, 1, mu)))


def test_block_wedged_between_walls_may_be_pressed_by_anything_above_what_friction_needs():
    problem = wedged(0.5)
    ranges = force_ranges(problem, np.zeros(4), (CLOSED, CLOSED, STICKING, STICKING))
    np.testing.assert_allclose(ranges.low, [10.0, 10.0, 5.0, 5.0], rtol=1e-9)
    np.testing.assert_allclose(ranges.high, [np.inf, np.inf, 5.0, 5.0], rtol=1e-9)


def test_wedged_block_without_known_pressure_may_stay_or_fall():
    outcome = contact_forces(wedged(0.5))
    assert outcome.status is OutcomeCount.SEVERAL
    assert outcome.mode == (CLOSED, CLOSED, STICKING, STICKING)
    np.testing.assert_allclose(outcome.forces, [10.0, 10.0, 5.0, 5.0], rtol=1e-9)  # the least that hold it


def test_accelerations_that_no_force_gives_are_an_outcome():
    problem = wedged(0.5)
    found = force_ranges(problem, np.array([1.0, 1.0, 0.0, 0.0]), (CLOSED, CLOSED, STICKING, STICKING))
    assert found.feasible is Feasible.NO_FORCES


def test_load_of_a_redundant_guide_is_cut_into_both_signs():
    # two guides share 4 upwards in any way; friction sticks under |l_0| alone with c = 0.5, and needs 1
    rub = FrictionProblemRow(2, (0.5, 0.5), (0.5, 0.5), magnitudes=((0,),))
    problem = assembled([[0, 1], [0, 1], [1, 0]], [1.0, 1.0], [1.0, -4.0], (), (rub,))
    ranges = force_ranges(problem, np.zeros(3), (RowState.HELD, RowState.HELD, STICKING))
    assert ranges.is_exact
    assert ranges.low[0] == -np.inf
    assert ranges.high[0] == np.inf
    np.testing.assert_allclose([ranges.low[2], ranges.high[2]], -1.0)


def test_coefficients_out_of_order_are_refused():
    with pytest.raises(ValueError, match="kinetic <= static"):
        FrictionProblemRow(0, (0.2, 0.2), (0.3, 0.3))
