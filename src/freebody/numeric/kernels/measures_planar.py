"""Value, gradient and bias of every kind of measure. Written by tools/write_kernels.py; do not edit.

Measures of a kind stand together: those of kind i are kinds[i] <= k < kinds[i + 1]. The gradient of
measure k has three entries (x, y, angle) for each of its bodies and begins at
starts[i] + 3 n_bodies (k - kinds[i]).
"""

# pyright: basic

import math
from typing import Any, NamedTuple

from freebody.numeric.kernels.declaring import kernel

TURN = 2.0 * math.pi
VALUE, BIAS, BEARING, NEAR = range(4)  # what stands in `out` of every measure


class Kind(NamedTuple):
    """A kind of measure: the fields whose body is fixed, how many bodies and numbers it has."""

    name: str
    fixed: tuple[str, ...]
    n_bodies: int
    n_numbers: int
    has_bearing: bool
    unchanging: tuple[int, ...]  # entries of the gradient that are the same in every pose
    vanishing: tuple[tuple[int, tuple[int, ...]], ...] = ()  # entries that are zero where these numbers are


MAX_BODIES = 3
MAX_NUMBERS = 6

KINDS = (
    Kind("Displacement", ("along",), 2, 6, False, (0, 1, 3, 4), ((2, (0, 1)), (5, (2, 3)))),
    Kind("Displacement", (), 3, 6, False, (6, 7), ((2, (0, 1)), (5, (2, 3)))),
    Kind("Angle", (), 2, 1, False, (0, 1, 2, 3, 4, 5)),
    Kind("Distance", (), 2, 4, True, (), ((2, (0, 1)), (5, (2, 3)))),
    Kind("Bearing", (), 3, 5, True, (6, 7, 8), ((2, (0, 1)), (5, (2, 3)))),
    Kind("Lead", (), 2, 5, True, (), ((2, (0, 1)), (5, (2, 3)))),
)


@kernel
def measure(kinds, starts, bodies, numbers, q, v, turn, out, gradient):
    # Displacement, along fixed: bodies of, origin
    for k in range(kinds[0], kinds[1]):
        b0 = bodies[k, 0]
        x0 = q[b0, 0]
        y0 = q[b0, 1]
        cos0 = turn[b0, 0]
        sin0 = turn[b0, 1]
        w0 = v[b0, 2]
        b1 = bodies[k, 1]
        x1 = q[b1, 0]
        y1 = q[b1, 1]
        cos1 = turn[b1, 0]
        sin1 = turn[b1, 1]
        w1 = v[b1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        u0 = p0 * p4 + p1 * p5
        u1 = p0 * p5 - p1 * p4
        u2 = p2 * p4 + p3 * p5
        u3 = -p2 * p5 + p3 * p4
        out[k, VALUE] = p4 * (cos0 * p0 - cos1 * p2 - p1 * sin0 + p3 * sin1 + x0 - x1) + p5 * (
            cos0 * p1 - cos1 * p3 + p0 * sin0 - p2 * sin1 + y0 - y1
        )
        out[k, BIAS] = w0 * (-cos0 * u0 * w0 - sin0 * u1 * w0) + w1 * (cos1 * u2 * w1 - sin1 * u3 * w1)
        o = starts[0] + 6 * (k - kinds[0])
        gradient[o + 2] = cos0 * u1 - sin0 * u0
        gradient[o + 5] = cos1 * u3 + sin1 * u2
    # Displacement: bodies of, origin, along
    for k in range(kinds[1], kinds[2]):
        b0 = bodies[k, 0]
        x0 = q[b0, 0]
        y0 = q[b0, 1]
        cos0 = turn[b0, 0]
        sin0 = turn[b0, 1]
        vx0 = v[b0, 0]
        vy0 = v[b0, 1]
        w0 = v[b0, 2]
        b1 = bodies[k, 1]
        x1 = q[b1, 0]
        y1 = q[b1, 1]
        cos1 = turn[b1, 0]
        sin1 = turn[b1, 1]
        vx1 = v[b1, 0]
        vy1 = v[b1, 1]
        w1 = v[b1, 2]
        b2 = bodies[k, 2]
        cos2 = turn[b2, 0]
        sin2 = turn[b2, 1]
        w2 = v[b2, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        u0 = cos2 * p4
        u1 = p5 * sin2
        u2 = u0 - u1
        u3 = cos0 * p0 - cos1 * p2 - p1 * sin0 + p3 * sin1 + x0 - x1
        u4 = cos2 * p5
        u5 = p4 * sin2
        u6 = u4 + u5
        u7 = cos0 * p1 - cos1 * p3 + p0 * sin0 - p2 * sin1 + y0 - y1
        u8 = u4 * w2 + u5 * w2
        u9 = u0 * w2 - u1 * w2
        u10 = p0 * u2 + p1 * u6
        u11 = cos0 * w0
        u12 = p0 * p4 + p1 * p5
        u13 = p0 * p5 - p1 * p4
        u14 = -u13
        u15 = cos2 * w2
        u16 = p0 * u6 - p1 * u2
        u17 = sin0 * w0
        u18 = sin2 * w2
        u19 = p2 * u2 + p3 * u6
        u20 = cos1 * w1
        u21 = p2 * p4 + p3 * p5
        u22 = -u21
        u23 = p2 * p5 - p3 * p4
        u24 = -u23
        u25 = -p2 * u6 + p3 * u2
        u26 = sin1 * w1
        u27 = -u2
        u28 = p4 * u3 + p5 * u7
        u29 = p4 * u7 - p5 * u3
        out[k, VALUE] = u2 * u3 + u6 * u7
        out[k, BIAS] = (
            -u8 * vx0
            + u8 * vx1
            + u9 * vy0
            - u9 * vy1
            + w0 * (-u10 * u11 + u15 * (cos0 * u12 - sin0 * u14) - u16 * u17 - u18 * (cos0 * u13 - sin0 * u12))
            + w1 * (u15 * (cos1 * u22 + sin1 * u24) - u18 * (cos1 * u24 + sin1 * u21) + u19 * u20 - u25 * u26)
            + w2
            * (
                u11 * (cos2 * u12 - sin2 * u13)
                - u15 * u28
                - u17 * (cos2 * u14 - sin2 * u12)
                - u18 * u29
                + u2 * vy0
                + u20 * (cos2 * u22 - sin2 * u24)
                - u26 * (cos2 * u23 - sin2 * u22)
                + u27 * vy1
                - u6 * vx0
                + u6 * vx1
            )
        )
        o = starts[1] + 9 * (k - kinds[1])
        gradient[o + 0] = u2
        gradient[o + 1] = u6
        gradient[o + 2] = cos0 * u16 - sin0 * u10
        gradient[o + 3] = u27
        gradient[o + 4] = -u6
        gradient[o + 5] = cos1 * u25 + sin1 * u19
        gradient[o + 8] = cos2 * u29 - sin2 * u28
    # Angle: bodies of, origin
    for k in range(kinds[2], kinds[3]):
        b0 = bodies[k, 0]
        angle0 = q[b0, 2]
        b1 = bodies[k, 1]
        angle1 = q[b1, 2]
        p0 = numbers[k, 0]
        out[k, VALUE] = angle0 - angle1 - p0
        out[k, BIAS] = 0
    # Distance: bodies start, end
    for k in range(kinds[3], kinds[4]):
        b0 = bodies[k, 0]
        x0 = q[b0, 0]
        y0 = q[b0, 1]
        cos0 = turn[b0, 0]
        sin0 = turn[b0, 1]
        vx0 = v[b0, 0]
        vy0 = v[b0, 1]
        w0 = v[b0, 2]
        b1 = bodies[k, 1]
        x1 = q[b1, 0]
        y1 = q[b1, 1]
        cos1 = turn[b1, 0]
        sin1 = turn[b1, 1]
        vx1 = v[b1, 0]
        vy1 = v[b1, 1]
        w1 = v[b1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        dx, dy, rho = (
            -cos0 * p0 + cos1 * p2 + p1 * sin0 - p3 * sin1 - x0 + x1,
            -cos0 * p1 + cos1 * p3 - p0 * sin0 + p2 * sin1 - y0 + y1,
            0,
        )
        length_0 = math.sqrt(dx * dx + dy * dy - rho * rho)
        square = dx * dx + dy * dy
        ex_0, ey_0 = (length_0 * dx + rho * dy) / square, (length_0 * dy - rho * dx) / square
        bearing_0 = math.atan2(ey_0, ex_0)
        bearing_0 += TURN * math.floor((out[k, NEAR] - bearing_0) / TURN + 0.5)
        out[k, BEARING] = bearing_0
        u0 = cos0 * p0
        u1 = p1 * sin0 - u0
        u2 = p3 * sin1
        u3 = cos0 * p1
        u4 = p0 * sin0
        u5 = cos1 * p3
        u6 = p2 * sin1
        u7 = (
            ex_0 * (cos1 * p2 * w1 + p1 * sin0 * w0 - u0 * w0 - u2 * w1 - vy0 + vy1)
            - ey_0 * (u3 * w0 + u4 * w0 - u5 * w1 - u6 * w1 - vx0 + vx1)
        ) / length_0
        u8 = ex_0 * u7
        u9 = u3 + u4
        u10 = ey_0 * u7
        u11 = cos1 * p2 - u2
        u12 = u5 + u6
        out[k, VALUE] = length_0
        out[k, BIAS] = (
            u10 * vx0
            - u10 * vx1
            - u8 * vy0
            + u8 * vy1
            + w0 * (cos0 * w0 * (ex_0 * p0 + ey_0 * p1) - sin0 * w0 * (ex_0 * p1 - ey_0 * p0) + u1 * u8 - u10 * u9)
            + w1 * (cos1 * w1 * (-ex_0 * p2 - ey_0 * p3) - sin1 * w1 * (-ex_0 * p3 + ey_0 * p2) + u10 * u12 + u11 * u8)
        )
        o = starts[3] + 6 * (k - kinds[3])
        gradient[o + 0] = -ex_0
        gradient[o + 1] = -ey_0
        gradient[o + 2] = ex_0 * u9 + ey_0 * u1
        gradient[o + 3] = ex_0
        gradient[o + 4] = ey_0
        gradient[o + 5] = -ex_0 * u12 + ey_0 * u11
    # Bearing: bodies start, end, origin
    for k in range(kinds[4], kinds[5]):
        b0 = bodies[k, 0]
        x0 = q[b0, 0]
        y0 = q[b0, 1]
        cos0 = turn[b0, 0]
        sin0 = turn[b0, 1]
        vx0 = v[b0, 0]
        vy0 = v[b0, 1]
        w0 = v[b0, 2]
        b1 = bodies[k, 1]
        x1 = q[b1, 0]
        y1 = q[b1, 1]
        cos1 = turn[b1, 0]
        sin1 = turn[b1, 1]
        vx1 = v[b1, 0]
        vy1 = v[b1, 1]
        w1 = v[b1, 2]
        b2 = bodies[k, 2]
        angle2 = q[b2, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        dx, dy, rho = (
            -cos0 * p0 + cos1 * p2 + p1 * sin0 - p3 * sin1 - x0 + x1,
            -cos0 * p1 + cos1 * p3 - p0 * sin0 + p2 * sin1 - y0 + y1,
            0,
        )
        length_0 = math.sqrt(dx * dx + dy * dy - rho * rho)
        square = dx * dx + dy * dy
        ex_0, ey_0 = (length_0 * dx + rho * dy) / square, (length_0 * dy - rho * dx) / square
        bearing_0 = math.atan2(ey_0, ex_0)
        bearing_0 += TURN * math.floor((out[k, NEAR] - bearing_0) / TURN + 0.5)
        out[k, BEARING] = bearing_0
        u0 = cos0 * p0
        u1 = p3 * sin1
        u2 = cos1 * p2 * w1 + p1 * sin0 * w0 - u0 * w0 - u1 * w1 - vy0 + vy1
        u3 = cos0 * p1
        u4 = p0 * sin0
        u5 = cos1 * p3
        u6 = p2 * sin1
        u7 = u3 * w0 + u4 * w0 - u5 * w1 - u6 * w1 - vx0 + vx1
        u8 = ex_0 * u2 - ey_0 * u7
        u9 = length_0 ** (-2)
        u10 = ex_0 * u9
        u11 = ex_0 * u7 + ey_0 * u2
        u12 = ey_0 * u9
        u13 = u10 * u8 - u11 * u12
        u14 = u12 * u8
        u15 = u10 * u11 + u14
        u16 = p1 * sin0 - u0
        u17 = u3 + u4
        u18 = ex_0 * u16 - ey_0 * u17
        u19 = u11 * u9
        u20 = 1 / length_0
        u21 = cos1 * p2 - u1
        u22 = u5 + u6
        u23 = ex_0 * u21 + ey_0 * u22
        u24 = ey_0 * u20
        u25 = ex_0 * u20
        out[k, VALUE] = -angle2 + bearing_0 - p4
        out[k, BIAS] = (
            u13 * vx0
            - u13 * vx1
            + u15 * vy0
            - u15 * vy1
            + w0
            * (
                cos0 * u20 * w0 * (ex_0 * p1 - ey_0 * p0)
                - ex_0 * u17 * u8 * u9
                - sin0 * u20 * w0 * (-ex_0 * p0 - ey_0 * p1)
                - u14 * u16
                - u18 * u19
            )
            + w1
            * (
                cos1 * u20 * w1 * (-ex_0 * p3 + ey_0 * p2)
                + ex_0 * u22 * u8 * u9
                - sin1 * u20 * w1 * (ex_0 * p2 + ey_0 * p3)
                - u14 * u21
                - u19 * u23
            )
        )
        o = starts[4] + 9 * (k - kinds[4])
        gradient[o + 0] = u24
        gradient[o + 1] = -u25
        gradient[o + 2] = u18 * u20
        gradient[o + 3] = -u24
        gradient[o + 4] = u25
        gradient[o + 5] = u20 * u23
    # Lead: bodies start, end
    for k in range(kinds[5], kinds[6]):
        b0 = bodies[k, 0]
        x0 = q[b0, 0]
        y0 = q[b0, 1]
        cos0 = turn[b0, 0]
        sin0 = turn[b0, 1]
        vx0 = v[b0, 0]
        vy0 = v[b0, 1]
        w0 = v[b0, 2]
        b1 = bodies[k, 1]
        x1 = q[b1, 0]
        y1 = q[b1, 1]
        cos1 = turn[b1, 0]
        sin1 = turn[b1, 1]
        vx1 = v[b1, 0]
        vy1 = v[b1, 1]
        w1 = v[b1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        dx, dy, rho = (
            -cos0 * p0 + cos1 * p2 + p1 * sin0 - p3 * sin1 - x0 + x1,
            -cos0 * p1 + cos1 * p3 - p0 * sin0 + p2 * sin1 - y0 + y1,
            p4,
        )
        length_0 = math.sqrt(dx * dx + dy * dy - rho * rho)
        square = dx * dx + dy * dy
        ex_0, ey_0 = (length_0 * dx + rho * dy) / square, (length_0 * dy - rho * dx) / square
        bearing_0 = math.atan2(ey_0, ex_0)
        bearing_0 += TURN * math.floor((out[k, NEAR] - bearing_0) / TURN + 0.5)
        out[k, BEARING] = bearing_0
        u0 = cos0 * p0
        u1 = p1 * sin0 - u0
        u2 = p3 * sin1
        u3 = cos0 * p1
        u4 = p0 * sin0
        u5 = cos1 * p3
        u6 = p2 * sin1
        u7 = (
            ex_0 * (cos1 * p2 * w1 + p1 * sin0 * w0 - u0 * w0 - u2 * w1 - vy0 + vy1)
            - ey_0 * (u3 * w0 + u4 * w0 - u5 * w1 - u6 * w1 - vx0 + vx1)
        ) / length_0
        u8 = ex_0 * u7
        u9 = u3 + u4
        u10 = ey_0 * u7
        u11 = cos1 * p2 - u2
        u12 = u5 + u6
        out[k, VALUE] = -bearing_0 * p4 + length_0
        out[k, BIAS] = (
            u10 * vx0
            - u10 * vx1
            - u8 * vy0
            + u8 * vy1
            + w0 * (cos0 * w0 * (ex_0 * p0 + ey_0 * p1) - sin0 * w0 * (ex_0 * p1 - ey_0 * p0) + u1 * u8 - u10 * u9)
            + w1 * (cos1 * w1 * (-ex_0 * p2 - ey_0 * p3) - sin1 * w1 * (-ex_0 * p3 + ey_0 * p2) + u10 * u12 + u11 * u8)
        )
        o = starts[5] + 6 * (k - kinds[5])
        gradient[o + 0] = -ex_0
        gradient[o + 1] = -ey_0
        gradient[o + 2] = ex_0 * u9 + ey_0 * u1
        gradient[o + 3] = ex_0
        gradient[o + 4] = ey_0
        gradient[o + 5] = -ex_0 * u12 + ey_0 * u11


def fill(kinds: Any, starts: Any, numbers: Any, gradient: Any) -> None:
    # Displacement, along fixed: bodies of, origin
    for k in range(kinds[0], kinds[1]):
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        o = starts[0] + 6 * (k - kinds[0])
        gradient[o + 0] = p4
        gradient[o + 1] = p5
        gradient[o + 3] = -p4
        gradient[o + 4] = -p5
    # Angle: bodies of, origin
    for k in range(kinds[2], kinds[3]):
        o = starts[2] + 6 * (k - kinds[2])
        gradient[o + 2] = 1
        gradient[o + 5] = -1
    # Bearing: bodies start, end, origin
    for k in range(kinds[4], kinds[5]):
        o = starts[4] + 9 * (k - kinds[4])
        gradient[o + 8] = -1
