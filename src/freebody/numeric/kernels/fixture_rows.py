"""Rows of the layout: stops and strings that may close in a step, and dry friction."""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.declaring import kernel
from freebody.numeric.kernels.kinematics import BIAS as ROW_BIAS
from freebody.numeric.kernels.kinematics import DRIFT, VALUE
from freebody.numeric.kernels.rows import (
    BACK,
    BEFORE,
    FORWARD,
    FRICTION,
    LOAD_A,
    LOAD_B,
    NORMAL,
    OF_BOUND,
    OF_FRICTION,
    add_entry,
    approach,
    begin_row,
    drop_row,
    set_normal,
    set_rates,
)
from freebody.numeric.kernels.tape import play


@kernel
def add_layout_row(L, S, X, r, row, sign):
    """The gradient of a row of the layout, as entries of row r."""
    for k in range(L.slot_ptr[row], L.slot_ptr[row + 1]):
        b, o = L.slots[k, 0], L.slots[k, 1]
        for i in range(3):
            add_entry(L, X, r, 3 * b + i, sign * S.gradient[o + i])


@kernel
def add_bounds(L, S, F, X, v, free, t, h, tolerance):
    """Rows of stops and strings that may close in the step."""
    for k in range(len(F.bound)):
        # the gap, with what a target moves
        row, sign = F.bound[k, 0], F.bound[k, 1]
        target, moving, bending = F.bound_number[k, 0], 0.0, 0.0
        if F.bound[k, 2] >= 0:
            begin, end = F.tape_ptr[F.bound[k, 2]], F.tape_ptr[F.bound[k, 2] + 1]
            play(begin, end, F.tape, F.tape_number, t, S.rows, F.registers)
            target, moving, bending = F.registers[end - 1, 0], F.registers[end - 1, 1], F.registers[end - 1, 2]
        gap = sign * (S.rows[row, VALUE] - target)
        # whether the contact exists here
        is_closed = True
        for j in range(2):
            span = F.bound[k, 3 + j]
            if span >= 0:
                x = S.rows[span, VALUE]
                if x < F.bound_number[k, 2 + j] - tolerance or x > F.bound_number[k, 4 + j] + tolerance:
                    is_closed = False
        F.row_of_bound[k] = -1
        if is_closed:
            # its row, taken back if it does not close in this step
            n = begin_row(X, NORMAL, OF_BOUND, k, 0, F.bound_memory[k])
            add_layout_row(L, S, X, n, row, sign)
            drift = sign * (S.rows[row, DRIFT] - moving)
            bias = sign * (S.rows[row, ROW_BIAS] - bending)
            set_rates(X, n, drift, bias, v, h)
            speed, gained = abs(drift), 0.0
            for p in range(X.ptr[n], X.ptr[n + 1]):
                i = X.coordinate[p]
                speed += abs(X.entry[p] * v[i])
                gained += abs(X.entry[p] * (free[i] - v[i]))
            restitution = F.bound_number[k, 1]
            what, gap = approach(X.number[n, BEFORE], speed, gained, gap, bias, restitution, h)
            if what > 0:
                set_normal(X, n, what, gap, restitution, h)
                F.row_of_bound[k] = n
            else:
                drop_row(X, n)


@kernel
def limit_of(S, F, tape, t):
    """A law of the time and the rows."""
    begin, end = F.tape_ptr[tape], F.tape_ptr[tape + 1]
    play(begin, end, F.tape, F.tape_number, t, S.rows, F.registers)
    return F.registers[end - 1, 0]


@kernel
def add_dry_friction(L, S, F, X, v, t, h, still_speed):
    """Friction of the layout. Its limits by laws are impulses of the step, those by loads are coefficients."""
    for k in range(len(F.friction)):
        r = begin_row(X, FRICTION, OF_FRICTION, k, 0, F.friction_memory[k])
        add_layout_row(L, S, X, r, F.friction[k, 0], 1.0)
        set_rates(X, r, S.rows[F.friction[k, 0], DRIFT], S.rows[F.friction[k, 0], ROW_BIAS], v, h)
        # static as long as it is still, then kinetic
        moves = 0 if abs(X.number[r, BEFORE]) <= still_speed else 1
        if F.friction[k, 3] >= 0:
            X.what[r, LOAD_A] = X.what[r, LOAD_B] = -1
            limit = h * max(0.0, limit_of(S, F, F.friction[k, 3 + moves], t))
            X.number[r, FORWARD] = X.number[r, BACK] = limit
            continue
        X.number[r, FORWARD], X.number[r, BACK] = F.friction_number[k, moves], F.friction_number[k, 2 + moves]
        # what presses: held rows, or bounds that are closed in this step
        is_pressed = False
        for j in range(2):
            load = F.friction[k, 1 + j]
            if load >= 0:
                load = F.row_of_bound[load]
            X.what[r, LOAD_A + j] = load
            is_pressed = is_pressed or load != -1
        if not is_pressed:  # nothing touches
            X.number[r, FORWARD] = X.number[r, BACK] = 0.0
