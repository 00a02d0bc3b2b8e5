"""Operations (`operations`) at many instants at once, with numbers: some instants by each operation, so that what is
done with an operation is decided once for all of them.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, Ints2
from freebody.numeric.kernels.declaring import entry, kernel
from freebody.numeric.kernels.elementary import over
from freebody.numeric.kernels.fresnel import fresnel
from freebody.numeric.kernels.operations import (
    ABS,
    ADD,
    ARGUMENT,
    COS,
    COSH,
    DIVIDE,
    FRESNEL_C,
    FRESNEL_S,
    INPUT,
    MULTIPLY,
    POWER,
    SIGN,
    SIN,
    SQRT,
    SUBTRACT,
    TIME,
)

TURN = 2.0 * math.pi
OPERATION, TARGET, LEFT, RIGHT = range(4)  # of a line of `code`: registers, or which input, which angle


@kernel
def played_function(registers, op, k, i, n):
    """Register k becomes an elementary function of register i."""
    for m in range(n):
        x = registers[i, m]
        if op == SIN:
            registers[k, m] = math.sin(x)
        elif op == COS:
            registers[k, m] = math.cos(x)
        elif op == COSH:
            registers[k, m] = math.cosh(max(-700.0, min(x, 700.0)))
        elif op == ABS:
            registers[k, m] = abs(x)
        elif op == SIGN:
            registers[k, m] = 1.0 if x > 0.0 else (-1.0 if x < 0.0 else 0.0)
        elif op in (FRESNEL_C, FRESNEL_S):
            registers[k, m] = fresnel(x, op == FRESNEL_S)
        else:
            registers[k, m] = over(op, x)


@kernel
def played_angle(registers, k, i, j, n, turns, place, first):
    """Register k becomes the angle of the vector (register i, register j), counted on from the instant before: in
    column `first` of `turns` stands what it was before the instant `first`, NaN if that is not known."""
    before = turns[place, first]
    for m in range(n):
        angle = math.atan2(registers[j, m], registers[i, m])
        if before == before:
            angle += TURN * math.floor((before - angle) / TURN + 0.5)
        registers[k, m] = before = turns[place, first + m + 1] = angle


@kernel
def play(code, numbers, begin, end, inputs, times, turns, registers, first, n):
    """Fills registers for n instants from `first` on by the operations from `begin` to `end`. inputs: (n_inputs,
    n_times); constants stand in their registers."""
    for o in range(begin, end):
        op, k, i, j = code[o, OPERATION], code[o, TARGET], code[o, LEFT], code[o, RIGHT]
        if op == INPUT:
            for m in range(n):
                registers[k, m] = inputs[i, first + m]
        elif op == TIME:
            for m in range(n):
                registers[k, m] = times[first + m]
        elif op == ADD:
            for m in range(n):
                registers[k, m] = registers[i, m] + registers[j, m]
        elif op == SUBTRACT:
            for m in range(n):
                registers[k, m] = registers[i, m] - registers[j, m]
        elif op == MULTIPLY:
            for m in range(n):
                registers[k, m] = registers[i, m] * registers[j, m]
        elif op == DIVIDE:
            for m in range(n):
                registers[k, m] = registers[i, m] / registers[j, m]
        elif op == POWER:
            for m in range(n):
                registers[k, m] = registers[i, m] ** numbers[o]
        elif op == SQRT:
            for m in range(n):
                registers[k, m] = over(SQRT, registers[i, m])
        elif op == ARGUMENT:
            played_angle(registers, k, i, j, n, turns, int(numbers[o]), first)
        else:
            played_function(registers, op, k, i, n)


@entry
def played(
    code: Ints2,
    numbers: Floats,
    inputs: Floats2,
    times: Floats,
    turns: Floats2,
    registers: Floats2,
    results: Ints,
    found: Floats2,
) -> None:
    """found (n_times, n_results): the registers `results` at all instants."""
    width = registers.shape[1]
    for first in range(0, len(times), width):
        n = min(width, len(times) - first)
        play(code, numbers, 0, len(code), inputs, times, turns, registers, first, n)
        for r in range(len(results)):
            for m in range(n):
                found[first + m, r] = registers[results[r], m]
