"""The accelerations and multipliers of one instant.

With J the gradients of the held rows, M the masses and Q the generalized forces of the loads,

    M a = Q + J^T lambda,    J a = target'' - bias        =>        (J M^-1 J^T) lambda = target'' - bias - J M^-1 Q.

In space Q has the gyroscopic torques as well. The Schur complement J M^-1 J^T is positive semidefinite and as sparse as
the mechanism; it is factored into L D L^T in an order found once. A row whose pivot vanishes says what rows before it
said (a redundant connection): it is left out, its multiplier is zero. A pivot that nearly vanishes belongs to a pose
near a singular one: there 1e-10 of the diagonal is added and the solution refined (proximal point iteration). A body
without mass is lent a little, which conjugate gradients take back (`solve`).
Source: Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, ch. 8; Rockafellar, SIAM J. Control Optim.
14 (1976) 877; Davis, Direct Methods for Sparse Linear Systems, 2006, ch. 4.
"""

# pyright: basic

import math

from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.measures_planar import measure
from freebody.numeric.kernels.measures_spatial import measure as measure_in_space
from freebody.numeric.kernels.rotating import gyroscopic
from freebody.numeric.kernels.tape import play, sweep
from freebody.numeric.kernels.turning import turned

VANISHED = 1e-13  # a pivot below this part of its diagonal is none
# nor is one below this by the smallest pivot before it, which enlarges rounding so much, up to a part of the diagonal
ROUNDING, MOST_ROUNDING = 1e-15, 1e-3
# beside rows that are left out: below this part of the best pivot of the motion, others of these rows should have been
# kept; the pivot is then given as this part of the best one at most, so that stages are looked after (`stepping`)
SHAKY_PIVOT, PSEUDO_PIVOT = 1e-2, 1e-3
SMALL_PIVOT = 1e-2  # see `pseudo_pivot`
PIVOT_CUT = 1e-8  # a smaller pivot, relative to its diagonal, calls for regularisation
REGULARISATION = 1e-10
N_REFINED = 3
N_SHARED = 30  # passes where multipliers that are not unique are shared by compliance
LENDS, SHARES = 1, 2  # bits of `Layout.has_gap`: massless bodies are lent some; multipliers are shared as above
N_LENT = 60  # steps of conjugate gradients that take back what massless bodies were lent
LENT_LEFT = 1e-31  # they end at this part of a^T G a
NO_INERTIA = 1e-15  # a direction with less than this part of its inertia, lent ones included, has none

# columns of `Room.rows`: value, rate, second derivative without acceleration, partial time derivative, weight in a tape
VALUE, RATE, BIAS, DRIFT, WEIGHT = range(5)
# columns of `Room.held`: the target and its derivatives, gaps of place and of motion, the right side
GOAL, GOAL_RATE, GOAL_BIAS, PLACE, MOTION, RIGHT = range(6)
# what presses a sliding friction (`Layout.slide`): a law, a held row, the resultant of two
PRESSED_BY_LAW, PRESSED_BY_ONE, PRESSED_BY_SIZE = range(3)
# what is guarded (`Layout.guard`): a value, a rate, a multiplier, what friction can carry beyond what it does; a share
# adds what it can carry to the reserve before it
GUARD_VALUE, GUARD_RATE, GUARD_MULTIPLIER, GUARD_RESERVE, GUARD_SHARE = range(5)
N_SLIDE = 30  # steps of Newton's method for the friction; one is enough where a single row presses
# what `Room.info` holds; of a motion also how many rows depend on others all the time, and the best smallest pivot
SMALLEST_PIVOT, IS_REGULARISED, POWER_OF_LOADS, RESIDUAL, N_LEFT_OUT, N_REDUNDANT, BEST_OF_MOTION = range(7)


@kernel
def measured(kinds, starts, bodies, numbers, q, v, turn, frames, out, gradient):
    """Values, gradients and biases of all measures. The plane has no frames, and for it the kernels of space are not
    compiled; in space they are those of the state (`rotating.framed`)."""
    if frames is None:
        turned(q, turn)
        measure(kinds, starts, bodies, numbers, q, v, turn, out, gradient)
    else:
        measure_in_space(kinds, starts, bodies, numbers, q, v, frames, out, gradient)


@kernel
def kinematics(L, S, q, v, t):
    """Values, gradients and biases of all rows, and the targets of those that are held."""
    G = S.gradient
    measured(L.kinds, L.starts, L.measure_bodies, L.measure_numbers, q, v, S.turn, S.frames, S.measures, G)
    gyroscopic(S.frames, L.gyration, v, S.gyroscopic)
    for r in range(len(L.term_ptr) - 1):
        x, b = L.row_constant[r], 0.0
        for k in range(L.term_ptr[r], L.term_ptr[r + 1]):
            x += L.term_coefficient[k] * S.measures[L.term_measure[k], 0]
            b += L.term_coefficient[k] * S.measures[L.term_measure[k], 1]
        S.rows[r, VALUE], S.rows[r, BIAS] = x, b
    for k in range(len(L.cleared)):
        o = L.cleared[k]
        G[o] = G[o + 1] = G[o + 2] = 0.0
    for k in range(len(L.mix)):
        o, i, c = L.mix[k, 0], L.mix[k, 1], L.mix_coefficient[k]
        G[o] += c * G[i]
        G[o + 1] += c * G[i + 1]
        G[o + 2] += c * G[i + 2]
    for k in range(len(L.rated)):
        S.rows[L.rated[k], RATE] = along(L, S, L.rated[k], v)
    composed(L, S, t)
    products(L, S, v)  # their coefficients may be expressions
    for k in range(len(L.held)):
        tape = L.held[k, 1]
        if tape >= 0:
            begin, end = L.tape_ptr[tape], L.tape_ptr[tape + 1]
            play(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
            S.held[k, GOAL] = S.registers[end - 1, 0]
            S.held[k, GOAL_RATE] = S.registers[end - 1, 1]
            S.held[k, GOAL_BIAS] = S.registers[end - 1, 2]


@part
def along(L, S, r, v):
    """gradient . v of a row."""
    total = 0.0
    for k in range(L.slot_ptr[r], L.slot_ptr[r + 1]):
        b, o = L.slots[k, 0], L.slots[k, 1]
        total += S.gradient[o] * v[b, 0] + S.gradient[o + 1] * v[b, 1] + S.gradient[o + 2] * v[b, 2]
    return total


@part
def products(L, S, v):
    """Rows  sum of c(pose) dm/dt:  gradient c grad m, bias c bias m + c' m'."""
    for k in range(len(L.product)):
        S.rows[L.product[k, 0], BIAS] = S.rows[L.product[k, 0], DRIFT] = 0.0
    for k in range(len(L.product)):
        r, c, m = L.product[k, 0], L.product[k, 1], L.product[k, 2]
        S.rows[r, BIAS] += S.rows[c, VALUE] * S.rows[m, BIAS] + S.rows[c, RATE] * S.rows[m, RATE]
        S.rows[r, DRIFT] += S.rows[c, VALUE] * S.rows[m, DRIFT]
        S.product_weight[k] = S.rows[c, VALUE]
    for k in range(len(L.product_mix)):
        o, w, i = L.product_mix[k, 0], S.product_weight[L.product_mix[k, 1]], L.product_mix[k, 2]
        for j in range(3):
            S.gradient[o + j] += w * S.gradient[i + j]
    for k in range(len(L.product)):
        r = L.product[k, 0]
        S.rows[r, RATE] = along(L, S, r, v) + S.rows[r, DRIFT]


@part
def composed(L, S, t):
    """Rows that are expressions in other rows and time."""
    at = 0
    for k in range(len(L.composed)):
        r, tape = L.composed[k, 0], L.composed[k, 1]
        begin, end = L.tape_ptr[tape], L.tape_ptr[tape + 1]
        play(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
        S.rows[r, VALUE] = S.registers[end - 1, 0]
        S.rows[r, BIAS] = S.registers[end - 1, 2]
        S.rows[r, DRIFT] = S.registers[end - 1, 1]
        first = at
        while at < len(L.composed_mix) and L.composed_mix[at, 1] == k:
            S.rows[L.composed_mix[at, 3], WEIGHT] = 0.0
            at += 1
        sweep(begin, end, L.tape, L.tape_number, S.registers, S.rows)
        last = -1
        for i in range(first, at):
            o, source, row = L.composed_mix[i, 0], L.composed_mix[i, 2], L.composed_mix[i, 3]
            w = S.rows[row, WEIGHT]
            if row != last:
                S.rows[r, DRIFT] -= w * S.rows[row, RATE]
                last = row
            if source >= 0:
                for j in range(3):
                    S.gradient[o + j] += w * S.gradient[source + j]
        S.rows[r, RATE] = S.registers[end - 1, 1]


@part
def law_of(L, S, p, t):
    """The generalized force of a load."""
    tape, r = L.load[p, 1], L.load[p, 0]
    if tape < 0:
        return L.load_law[p, 0] + L.load_law[p, 1] * S.rows[r, VALUE] + L.load_law[p, 2] * S.rows[r, RATE]
    begin, end = L.tape_ptr[tape], L.tape_ptr[tape + 1]
    play(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
    return S.registers[end - 1, 0]


@part
def loads(L, S, t):
    """Generalized forces of all loads; the power of those without a potential."""
    F = S.force
    for i in range(len(F)):
        F[i] = L.constant_force[i]
    for b in range(len(L.gyration)):
        for i in range(3):
            F[6 * b + 3 + i] += S.gyroscopic[b, i]
    power = 0.0
    for p in range(len(L.load)):
        law, r = law_of(L, S, p, t), L.load[p, 0]
        if L.load[p, 2]:
            power += law * (S.rows[r, RATE] - S.rows[r, DRIFT])
        for k in range(L.slot_ptr[r], L.slot_ptr[r + 1]):
            b, o = L.slots[k, 0], L.slots[k, 1]
            for i in range(3):
                F[3 * b + i] += law * S.gradient[o + i]
    S.info[POWER_OF_LOADS] = power


# -- the linear system ------------------------------------------------------------------------
@kernel
def assemble(slots, inverse_mass, base, ptr, left, right, G, W, A):
    """J M^-1 J^T, where its factor will stand. What never changes is in `base`."""
    for k in range(len(slots)):
        W[k] = G[slots[k, 1]] * inverse_mass[slots[k, 0]]
    for e in range(len(A)):
        total = base[e]
        for k in range(ptr[e], ptr[e + 1]):
            total += W[left[k]] * G[right[k]]
        A[e] = total


@kernel
def factor(ptr, target, regularisation, vanished, rounding, A, diagonal):
    """A becomes its L D L^T, a part of the diagonal added, column by column; 1/D stands on the diagonal. Returns the
    smallest pivot by its diagonal, and how many rows are left out, whose pivots are below `vanished`, or below the
    `rounding` of one operation by the smallest pivot before."""
    smallest, n_left_out = 1.0, 0
    n = len(ptr) - 1
    for j in range(n):
        diagonal[j] = A[ptr[j]]
        A[ptr[j]] *= 1.0 + regularisation
    p = 0
    for j in range(n):
        begin, end = ptr[j], ptr[j + 1]
        pivot, size = A[begin], diagonal[j]
        ratio = pivot / size if size > 0.0 else 0.0
        if ratio < max(vanished, min(MOST_ROUNDING, rounding / smallest)):
            n_left_out += 1
            inverse = 0.0
        else:
            inverse = 1.0 / pivot
            if not ratio >= smallest:
                smallest = ratio
        A[begin] = inverse
        for i in range(begin + 1, end):
            scaled = A[i] * inverse
            for k in range(begin + 1, i + 1):
                A[target[p]] -= scaled * A[k]
                p += 1
        for i in range(begin + 1, end):
            A[i] *= inverse
    return smallest, n_left_out


@kernel
def back_solve(ptr, rows, A, x):
    """x becomes (L D L^T)^-1 x."""
    n = len(ptr) - 1
    for j in range(n):
        xj = x[j]
        for i in range(ptr[j] + 1, ptr[j + 1]):
            x[rows[i]] -= A[i] * xj
    for j in range(n - 1, -1, -1):
        xj = x[j] * A[ptr[j]]
        for i in range(ptr[j] + 1, ptr[j + 1]):
            xj -= A[i] * x[rows[i]]
        x[j] = xj


@part
def assembled(L, S):
    assemble(
        L.held_slots, L.inverse_mass, L.schur_base, L.pair_ptr, L.pair_a, L.pair_b, S.gradient, S.weighted, S.schur
    )


@kernel
def pseudo_pivot(ptr, A, diagonal, n_left_out):
    """How small the smallest pivot would be in a better order of rows, of which n_left_out depend on others: with
    regularisation mu the determinant tends to mu^n_left_out times the product of what is not zero, so it is the product
    of the small pivots by mu^n_left_out."""
    found = 1.0
    n_small = 0
    for j in range(len(ptr) - 1):
        ratio = 1.0 / (A[ptr[j]] * diagonal[j]) if A[ptr[j]] != 0.0 else 0.0
        if ratio < SMALL_PIVOT:
            n_small += 1
            found *= ratio / REGULARISATION if n_small <= n_left_out else ratio
    return found


@kernel
def is_spatial(frames):
    """Whether there are rotations in space; decided where kernels are compiled."""
    return frames is not None


@part
def factored(L, S):
    """Factors; regularised where rows depend on each other. Returns the number of passes that a solution needs.

    Rows are left out in a fixed order. A row that was kept may lose its meaning to one that is left out later: its
    pivot passes through zero at a pose that is not singular. There, too, all rows are kept with regularisation, which
    does not ask for the order. In a stage what is held is a little off, and so is that rows depend on each other."""
    assemble(
        L.held_slots, L.inverse_mass, L.schur_base, L.pair_ptr, L.pair_a, L.pair_b, S.gradient, S.weighted, S.schur
    )
    in_space = is_spatial(S.frames)  # in the plane what rows say passes from one to another at singular poses alone
    vanished = PIVOT_CUT if in_space and S.info[N_REDUNDANT] > 0.0 else VANISHED
    rounding = ROUNDING if in_space else 0.0
    smallest, n_left_out = factor(L.column_ptr, L.target, 0.0, vanished, rounding, S.schur, S.diagonal)
    S.info[SMALLEST_PIVOT], S.info[N_LEFT_OUT] = smallest, n_left_out
    S.info[IS_REGULARISED] = 0.0
    is_shaky = in_space and n_left_out > 0 and smallest < SHAKY_PIVOT * S.info[BEST_OF_MOTION]
    if not (smallest < PIVOT_CUT or is_shaky):
        return 1
    assemble(
        L.held_slots, L.inverse_mass, L.schur_base, L.pair_ptr, L.pair_a, L.pair_b, S.gradient, S.weighted, S.schur
    )
    factor(L.column_ptr, L.target, REGULARISATION, VANISHED, 0.0, S.schur, S.diagonal)
    if is_shaky:
        most = PSEUDO_PIVOT * S.info[BEST_OF_MOTION]
        S.info[SMALLEST_PIVOT] = min(most, pseudo_pivot(L.column_ptr, S.schur, S.diagonal, n_left_out))
    if S.info[SMALLEST_PIVOT] < PIVOT_CUT:
        S.info[IS_REGULARISED] = 1.0
    return N_REFINED


@kernel
def apply_multipliers(ptr, slots, W, x, out):
    """out += M^-1 J^T x."""
    for r in range(len(ptr) - 1):
        xr = x[r]
        for k in range(ptr[r], ptr[r + 1]):
            out[slots[k, 0]] += W[k] * xr


@part
def held_along(L, S, r, v):
    """gradient . v of a held row."""
    G, total = S.gradient, 0.0
    for k in range(L.held_ptr[r], L.held_ptr[r + 1]):
        total += G[L.held_slots[k, 1]] * v[L.held_slots[k, 0]]
    return total


@kernel
def projected(L, S, F, goal, n_passes, x):
    """x = G^-1 (F + J^T mu) with J x = goal times the right side, G the masses used; mu is added to the multipliers.
    Returns how far the last pass was from the one before."""
    for i in range(len(x)):
        x[i] = L.inverse_mass[i] * F[i]
    last, shares = math.inf, L.has_gap[0] & SHARES > 0
    for n in range(N_SHARED if shares else n_passes):
        for r in range(len(L.held)):
            S.step[r] = goal * S.held[r, RIGHT] - held_along(L, S, r, x)
        back_solve(L.column_ptr, L.column_row, S.schur, S.step)
        apply_multipliers(L.held_ptr, L.held_slots, S.weighted, S.step, x)
        size = 0.0
        for r in range(len(L.held)):
            S.multiplier[r] += S.step[r]
            size = max(size, abs(S.step[r]))
        if shares and n >= n_passes and (size >= 0.5 * last or size == 0.0):
            break
        last = size
    return last


@kernel
def weighed(L, x, with_lent):
    """x^T M x, or x^T G x with what is lent."""
    total = 0.0
    for i in range(len(x)):
        if L.inverse_mass[i] > 0.0 and (with_lent or L.mass_gap[i] == 0.0):
            total += x[i] * x[i] / L.inverse_mass[i]
    return total


@kernel
def solve(L, S, F, is_still, n_passes):
    """Accelerations and multipliers from a factor and the forces F; is_still: those of F alone, without what the motion
    and the targets ask for.

    The factor belongs to G = M + what is lent. What was lent is taken back by conjugate gradients on J a = b with that
    factor as the preconditioner: M and G differ along the lent coordinates alone, so that they end after as many steps
    as there are such coordinates at most, whatever was lent, in exact arithmetic with M itself.
    Source: Gould, Hribar and Nocedal, SIAM J. Sci. Comput. 23 (2001) 1376, with the update of the residual."""
    a, residual, z, p = S.acceleration, S.residual, S.descent, S.search
    for r in range(len(L.held)):
        S.multiplier[r] = 0.0
        S.held[r, RIGHT] = 0.0
        if not is_still:
            order = 2 if L.held[r, 2] else 1
            goal = S.held[r, GOAL + order] if L.held[r, 1] >= 0 else 0.0
            S.held[r, RIGHT] = goal - S.rows[L.held[r, 0], BIAS]
    is_lent = L.has_gap[0] & LENDS > 0
    passes = max(2, n_passes) if is_lent else n_passes
    S.info[RESIDUAL] = projected(L, S, F, 1.0, passes, a)
    if not is_lent:
        return
    for i in range(len(a)):
        residual[i] = L.mass_gap[i] * a[i]  # F + J^T lambda - M a
        p[i] = 0.0
    before = 1.0
    for n in range(N_LENT):
        projected(L, S, residual, 0.0, passes, z)
        size = weighed(L, z, True)
        for i in range(len(a)):
            p[i] = z[i] + (size / before if n > 0 else 0.0) * p[i]
        inertia = weighed(L, p, False)
        S.info[RESIDUAL] = math.sqrt(size)
        # done; or what is left would move without inertia, which is refused where a motion begins
        if size <= LENT_LEFT * weighed(L, a, True) or inertia <= NO_INERTIA * weighed(L, p, True):
            break
        for i in range(len(a)):
            if L.inverse_mass[i] > 0.0:
                a[i] += size / inertia * p[i]
                mass = 0.0 if L.mass_gap[i] > 0.0 else 1.0 / L.inverse_mass[i]
                residual[i] = z[i] / L.inverse_mass[i] - size / inertia * mass * p[i]
        before = size


# -- sliding friction -------------------------------------------------------------------------
@kernel
def load_of(L, S, kind, a, b, tape, sign, t):
    """What presses a friction: a law, a multiplier (its size where sign is 0), or the size of two."""
    if kind == PRESSED_BY_LAW:
        begin, end = L.tape_ptr[tape], L.tape_ptr[tape + 1]
        play(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
        return S.registers[end - 1, 0]
    if a < 0:
        return 0.0
    if kind == PRESSED_BY_ONE:
        return sign * S.multiplier[a] if sign != 0.0 else abs(S.multiplier[a])
    return math.hypot(S.multiplier[a], S.multiplier[b])


@kernel
def pushed_along(L, S, k, force, F):
    """F += force along the slip of a sliding friction."""
    r = L.slide[k, 0]
    for j in range(L.slot_ptr[r], L.slot_ptr[r + 1]):
        b, o = L.slots[j, 0], L.slots[j, 1]
        for i in range(3):
            F[3 * b + i] += force * S.gradient[o + i]


@kernel
def slid(L, S, n_passes, t):
    """Friction forces phi_k = -s_k c_k N_k(lambda), where lambda = lambda_0 + sum of phi_j Lambda_j, Lambda_j the
    multipliers by a unit force along slip j alone; then the accelerations with them. Newton's method, which is done
    after one step where all loads are linear in lambda."""
    n, n_held, phi, A, F = len(L.slide), len(L.held), S.slide_force, S.slide_matrix, S.unit_force
    for r in range(n_held):
        S.slide_response[n, r] = S.multiplier[r]
    for k in range(n):
        for i in range(len(F)):
            F[i] = 0.0
        pushed_along(L, S, k, 1.0, F)
        solve(L, S, F, True, n_passes)
        for r in range(n_held):
            S.slide_response[k, r] = S.multiplier[r]
        phi[k] = 0.0
    for _ in range(N_SLIDE):
        for r in range(n_held):
            S.multiplier[r] = S.slide_response[n, r]
            for j in range(n):
                S.multiplier[r] += phi[j] * S.slide_response[j, r]
        for k in range(n):
            kind, a, b, factor, sign = (
                L.slide[k, 1],
                L.slide[k, 2],
                L.slide[k, 3],
                L.slide_factor[k, 0],
                L.slide_factor[k, 1],
            )
            size = load_of(L, S, kind, a, b, L.slide[k, 4], sign, t)
            A[k, n] = factor * size - phi[k]
            for j in range(n):
                slope = 0.0
                if kind == PRESSED_BY_ONE and a >= 0:
                    up = sign if sign != 0.0 else (1.0 if S.multiplier[a] >= 0.0 else -1.0)
                    slope = up * S.slide_response[j, a]
                elif kind == PRESSED_BY_SIZE and a >= 0 and size > 0.0:
                    slope = (S.multiplier[a] * S.slide_response[j, a] + S.multiplier[b] * S.slide_response[j, b]) / size
                A[k, j] = (1.0 if j == k else 0.0) - factor * slope
        largest, change = 0.0, 0.0
        eliminated(A, n)
        for k in range(n):
            phi[k] += A[k, n]
            largest, change = max(largest, abs(phi[k])), max(change, abs(A[k, n]))
        if not change > 1e-15 * largest:
            break
    for k in range(n):
        pushed_along(L, S, k, phi[k], S.force)
        row = L.slide[k, 0]
        S.info[POWER_OF_LOADS] += phi[k] * (S.rows[row, RATE] - S.rows[row, DRIFT])
    solve(L, S, S.force, False, n_passes)


@kernel
def eliminated(A, n):
    """The last column of A (n, n + 1) becomes the solution of the equations, by elimination with pivots."""
    for c in range(n):
        p = c
        for i in range(c + 1, n):
            if abs(A[i, c]) > abs(A[p, c]):
                p = i
        for j in range(c, n + 1):
            A[c, j], A[p, j] = A[p, j], A[c, j]
        for i in range(n):
            if i != c:
                factor = A[i, c] / A[c, c]
                for j in range(c, n + 1):
                    A[i, j] -= factor * A[c, j]
    for c in range(n):
        A[c, n] /= A[c, c]


@kernel
def respond(L, S, t):
    """Forces, accelerations and multipliers, where the kinematics are known."""
    loads(L, S, t)
    n_passes = factored(L, S)
    solve(L, S, S.force, False, n_passes)
    if len(L.slide) > 0:
        slid(L, S, n_passes, t)


@kernel
def guarded(L, S, t, values, rates, sizes):
    """What is guarded at the instant looked at: values, rates (of values only) and what counts as large beside them."""
    for g in range(len(L.guard)):
        kind, r = L.guard[g, 0], L.guard[g, 1]
        sign = L.guard_factor[g, 0]
        rates[g], sizes[g] = 0.0, 0.0
        if kind == GUARD_VALUE:
            values[g] = sign * (S.rows[r, VALUE] - L.guard_factor[g, 1])
            rates[g] = sign * S.rows[r, RATE]
        elif kind == GUARD_RATE:
            values[g] = sign * S.rows[r, RATE]
        elif kind == GUARD_MULTIPLIER:
            values[g] = sign * S.multiplier[r]
        elif kind == GUARD_SHARE:
            values[g] = 1.0
        else:
            carried, limit = S.multiplier[r], 0.0
            for k in range(g, g + 1 + L.guard[g, 5]):
                kind_of_load, up = int(L.guard_factor[k, 3]), L.guard_factor[k, 0]
                size = load_of(L, S, kind_of_load, L.guard[k, 2], L.guard[k, 3], L.guard[k, 4], up, t)
                limit += (L.guard_factor[k, 1] if carried > 0.0 else L.guard_factor[k, 2]) * size
            values[g], sizes[g] = limit - abs(carried), max(limit, abs(carried))


@part
def accelerations(L, S, q, v, t):
    """Everything at one instant: rows, forces, accelerations, multipliers."""
    kinematics(L, S, q, v, t)
    respond(L, S, t)


@part
def power(L, S):
    """Power of the loads without a potential and of the held rows that move."""
    total = S.info[POWER_OF_LOADS]
    for r in range(len(L.held)):
        if L.held[r, 3]:
            row = L.held[r, 0]
            if L.held[r, 2]:
                rate = (S.held[r, GOAL_RATE] if L.held[r, 1] >= 0 else 0.0) - S.rows[row, DRIFT]
            else:
                rate = (S.held[r, GOAL] if L.held[r, 1] >= 0 else 0.0) - S.rows[row, DRIFT]
            total += S.multiplier[r] * rate
    return total


# -- what is held -----------------------------------------------------------------------------
@part
def gaps(L, S, v):
    """Fills `gaps` with what is missing to the targets, of positions and of velocities; returns the largest ones in
    parts of their size."""
    place, motion = 0.0, 0.0
    for r in range(len(L.held)):
        row, has_target = L.held[r, 0], L.held[r, 1] >= 0
        if L.held[r, 2]:
            S.held[r, PLACE] = (S.held[r, GOAL] if has_target else 0.0) - S.rows[row, VALUE]
            S.held[r, MOTION] = (
                (S.held[r, GOAL_RATE] if has_target else 0.0) - S.rows[row, DRIFT] - held_along(L, S, r, v)
            )
        else:
            S.held[r, PLACE] = 0.0
            S.held[r, MOTION] = (S.held[r, GOAL] if has_target else 0.0) - S.rows[row, DRIFT] - held_along(L, S, r, v)
        x, y = abs(S.held[r, PLACE]) * L.held_scale[r], abs(S.held[r, MOTION]) * L.held_scale[r]
        if not x <= place:
            place = x
        if not y <= motion:
            motion = y
    return place, motion


@part
def closed(L, S, q, v):
    """Moves q and v by the least, in the metric of the masses, that closes the gaps to first order. Beside redundant
    rows, those that hold velocities alone have no say in q: they would keep it from where the others want it."""
    for r in range(len(L.held)):
        S.step[r] = S.held[r, MOTION]
    back_solve(L.column_ptr, L.column_row, S.schur, S.step)
    apply_multipliers(L.held_ptr, L.held_slots, S.weighted, S.step, v)
    if is_spatial(S.frames) and S.info[N_LEFT_OUT] > 0.0:
        factored_for_places(L, S)
    for r in range(len(L.held)):
        S.step[r] = S.held[r, PLACE]
    back_solve(L.column_ptr, L.column_row, S.schur, S.step)
    apply_multipliers(L.held_ptr, L.held_slots, S.weighted, S.step, q)


@part
def factored_for_places(L, S):
    """Factors for the rows that hold positions; nothing to do where there are no others."""
    n_others = 0
    for r in range(len(L.held)):
        if not L.held[r, 2]:
            n_others += 1
    if n_others == 0:
        return
    assemble(
        L.held_slots, L.inverse_mass, L.schur_base, L.pair_ptr, L.pair_a, L.pair_b, S.gradient, S.weighted, S.schur
    )
    for j in range(len(L.held)):
        for i in range(L.column_ptr[j], L.column_ptr[j + 1]):
            if not (L.held[j, 2] and L.held[L.column_row[i], 2]):
                S.schur[i] = 0.0
    factor(L.column_ptr, L.target, REGULARISATION, VANISHED, 0.0, S.schur, S.diagonal)
