"""Value, gradient and bias of measures in space. Written by tools/write_kernels.py; do not edit.

Measures of a kind stand together: those of kind i are kinds[i] <= k < kinds[i + 1]. The gradient of
measure k has six entries for each of its bodies (velocity of the mass centre along the ground's axes,
angular velocity along the axes of the body's frame) and begins at starts[i] + 6 n_bodies (k - kinds[i]).
Body b has the cells 2 b and 2 b + 1 of q and v; row b of `frames` is its rotation matrix, row by row.
"""

# pyright: basic

import math
from typing import Any

from freebody.numeric.kernels.declaring import kernel
from freebody.numeric.kernels.measures_planar import BEARING, BIAS, NEAR, TURN, VALUE, Kind
from freebody.numeric.kernels.rotating import carried, crossed, returned

MAX_BODIES = 4
MAX_NUMBERS = 19

KINDS = (
    Kind(
        "Displacement",
        ("along",),
        2,
        9,
        False,
        (0, 1, 2, 6, 7, 8),
        ((3, (1, 2)), (4, (0, 2)), (5, (0, 1)), (9, (4, 5)), (10, (3, 5)), (11, (3, 4))),
    ),
    Kind(
        "Displacement",
        (),
        3,
        9,
        False,
        (12, 13, 14),
        (
            (3, (1, 2)),
            (4, (0, 2)),
            (5, (0, 1)),
            (9, (4, 5)),
            (10, (3, 5)),
            (11, (3, 4)),
            (15, (7, 8)),
            (16, (6, 8)),
            (17, (6, 7)),
        ),
    ),
    Kind(
        "Distance",
        (),
        2,
        6,
        False,
        (),
        ((3, (1, 2)), (4, (0, 2)), (5, (0, 1)), (9, (4, 5)), (10, (3, 5)), (11, (3, 4))),
    ),
    Kind("Alignment", ("of",), 1, 6, False, (0, 1, 2), ((3, (4, 5)), (4, (3, 5)), (5, (3, 4)))),
    Kind("Alignment", ("along",), 1, 6, False, (0, 1, 2), ((3, (1, 2)), (4, (0, 2)), (5, (0, 1)))),
    Kind(
        "Alignment",
        (),
        2,
        6,
        False,
        (0, 1, 2, 6, 7, 8),
        ((3, (1, 2)), (4, (0, 2)), (5, (0, 1)), (9, (4, 5)), (10, (3, 5)), (11, (3, 4))),
    ),
    Kind(
        "Turn",
        (),
        3,
        10,
        True,
        (0, 1, 2, 6, 7, 8, 12, 13, 14),
        (
            (3, (1, 2)),
            (4, (0, 2)),
            (5, (0, 1)),
            (9, (4, 5)),
            (10, (3, 5)),
            (11, (3, 4)),
            (15, (7, 8)),
            (16, (6, 8)),
            (17, (6, 7)),
        ),
    ),
    Kind(
        "Angle",
        (),
        2,
        19,
        True,
        (0, 1, 2, 6, 7, 8),
        ((3, (1, 2)), (4, (0, 2)), (5, (0, 1)), (9, (10, 11, 13, 14)), (10, (9, 11, 12, 14)), (11, (9, 10, 12, 13))),
    ),
    Kind(
        "Bearing",
        (),
        3,
        16,
        True,
        (12, 13, 14),
        (
            (3, (1, 2)),
            (4, (0, 2)),
            (5, (0, 1)),
            (9, (4, 5)),
            (10, (3, 5)),
            (11, (3, 4)),
            (15, (7, 8, 10, 11)),
            (16, (6, 8, 9, 11)),
            (17, (6, 7, 9, 10)),
        ),
    ),
    Kind(
        "Lead", (), 2, 7, True, (2, 8), ((3, (1, 2)), (4, (0, 2)), (5, (0, 1)), (9, (4, 5)), (10, (3, 5)), (11, (3, 4)))
    ),
    Kind(
        "LeadInPlane",
        (),
        4,
        13,
        True,
        (12, 13, 14, 18, 19, 20),
        (
            (3, (1, 2)),
            (4, (0, 2)),
            (5, (0, 1)),
            (9, (4, 5)),
            (10, (3, 5)),
            (11, (3, 4)),
            (15, (8, 9)),
            (16, (7, 9)),
            (17, (7, 8)),
            (21, (11, 12)),
            (22, (10, 12)),
            (23, (10, 11)),
        ),
    ),
)


@kernel
def measure(kinds, starts, bodies, numbers, q, v, frames, out, gradient):
    # Displacement, along fixed: bodies of, origin
    for k in range(kinds[0], kinds[1]):
        b0 = bodies[k, 0]
        x0 = q[2 * b0, 0]
        y0 = q[2 * b0, 1]
        z0 = q[2 * b0, 2]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        x1 = q[2 * b1, 0]
        y1 = q[2 * b1, 1]
        z1 = q[2 * b1, 2]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        p6 = numbers[k, 6]
        p7 = numbers[k, 7]
        p8 = numbers[k, 8]
        t_r0x, t_r0y, t_r0z = crossed(wx0, wy0, wz0, p0, p1, p2)
        c_r0x, c_r0y, c_r0z = crossed(wx0, wy0, wz0, t_r0x, t_r0y, t_r0z)
        t_r1x, t_r1y, t_r1z = crossed(wx1, wy1, wz1, p3, p4, p5)
        c_r1x, c_r1y, c_r1z = crossed(wx1, wy1, wz1, t_r1x, t_r1y, t_r1z)
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b0, p6, p7, p8)
        pull_r1x, pull_r1y, pull_r1z = returned(frames, b1, -p6, -p7, -p8)
        m_r0x, m_r0y, m_r0z = crossed(p0, p1, p2, pull_r0x, pull_r0y, pull_r0z)
        m_r1x, m_r1y, m_r1z = crossed(p3, p4, p5, pull_r1x, pull_r1y, pull_r1z)
        out[k, VALUE] = (
            p0 * pull_r0x
            + p1 * pull_r0y
            + p2 * pull_r0z
            + p3 * pull_r1x
            + p4 * pull_r1y
            + p5 * pull_r1z
            + p6 * (x0 - x1)
            + p7 * (y0 - y1)
            + p8 * (z0 - z1)
        )
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r1x * pull_r1x
            + c_r1y * pull_r1y
            + c_r1z * pull_r1z
        )
        o = starts[0] + 12 * (k - kinds[0])
        gradient[o + 3] = m_r0x
        gradient[o + 4] = m_r0y
        gradient[o + 5] = m_r0z
        gradient[o + 9] = m_r1x
        gradient[o + 10] = m_r1y
        gradient[o + 11] = m_r1z
    # Displacement: bodies of, origin, along
    for k in range(kinds[1], kinds[2]):
        b0 = bodies[k, 0]
        x0 = q[2 * b0, 0]
        y0 = q[2 * b0, 1]
        z0 = q[2 * b0, 2]
        vx0 = v[2 * b0, 0]
        vy0 = v[2 * b0, 1]
        vz0 = v[2 * b0, 2]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        x1 = q[2 * b1, 0]
        y1 = q[2 * b1, 1]
        z1 = q[2 * b1, 2]
        vx1 = v[2 * b1, 0]
        vy1 = v[2 * b1, 1]
        vz1 = v[2 * b1, 2]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        b2 = bodies[k, 2]
        wx2 = v[2 * b2 + 1, 0]
        wy2 = v[2 * b2 + 1, 1]
        wz2 = v[2 * b2 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        p6 = numbers[k, 6]
        p7 = numbers[k, 7]
        p8 = numbers[k, 8]
        r0x, r0y, r0z = carried(frames, b0, p0, p1, p2)
        t_r0x, t_r0y, t_r0z = crossed(wx0, wy0, wz0, p0, p1, p2)
        dr0x, dr0y, dr0z = carried(frames, b0, t_r0x, t_r0y, t_r0z)
        c_r0x, c_r0y, c_r0z = crossed(wx0, wy0, wz0, t_r0x, t_r0y, t_r0z)
        r1x, r1y, r1z = carried(frames, b1, p3, p4, p5)
        t_r1x, t_r1y, t_r1z = crossed(wx1, wy1, wz1, p3, p4, p5)
        dr1x, dr1y, dr1z = carried(frames, b1, t_r1x, t_r1y, t_r1z)
        c_r1x, c_r1y, c_r1z = crossed(wx1, wy1, wz1, t_r1x, t_r1y, t_r1z)
        r2x, r2y, r2z = carried(frames, b2, p6, p7, p8)
        t_r2x, t_r2y, t_r2z = crossed(wx2, wy2, wz2, p6, p7, p8)
        dr2x, dr2y, dr2z = carried(frames, b2, t_r2x, t_r2y, t_r2z)
        c_r2x, c_r2y, c_r2z = crossed(wx2, wy2, wz2, t_r2x, t_r2y, t_r2z)
        u0 = -r2x
        u1 = -r2y
        u2 = -r2z
        u3 = r0x - r1x + x0 - x1
        u4 = r0y - r1y + y0 - y1
        u5 = r0z - r1z + z0 - z1
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b0, r2x, r2y, r2z)
        pull_r1x, pull_r1y, pull_r1z = returned(frames, b1, u0, u1, u2)
        pull_r2x, pull_r2y, pull_r2z = returned(frames, b2, u3, u4, u5)
        m_r0x, m_r0y, m_r0z = crossed(p0, p1, p2, pull_r0x, pull_r0y, pull_r0z)
        m_r1x, m_r1y, m_r1z = crossed(p3, p4, p5, pull_r1x, pull_r1y, pull_r1z)
        m_r2x, m_r2y, m_r2z = crossed(p6, p7, p8, pull_r2x, pull_r2y, pull_r2z)
        out[k, VALUE] = r2x * u3 + r2y * u4 + r2z * u5
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r1x * pull_r1x
            + c_r1y * pull_r1y
            + c_r1z * pull_r1z
            + c_r2x * pull_r2x
            + c_r2y * pull_r2y
            + c_r2z * pull_r2z
            + dr0x * dr2x
            + dr0y * dr2y
            + dr0z * dr2z
            - dr1x * dr2x
            - dr1y * dr2y
            - dr1z * dr2z
            + dr2x * vx0
            - dr2x * vx1
            + dr2x * (dr0x - dr1x + vx0 - vx1)
            + dr2y * vy0
            - dr2y * vy1
            + dr2y * (dr0y - dr1y + vy0 - vy1)
            + dr2z * vz0
            - dr2z * vz1
            + dr2z * (dr0z - dr1z + vz0 - vz1)
        )
        o = starts[1] + 18 * (k - kinds[1])
        gradient[o + 0] = r2x
        gradient[o + 1] = r2y
        gradient[o + 2] = r2z
        gradient[o + 3] = m_r0x
        gradient[o + 4] = m_r0y
        gradient[o + 5] = m_r0z
        gradient[o + 6] = u0
        gradient[o + 7] = u1
        gradient[o + 8] = u2
        gradient[o + 9] = m_r1x
        gradient[o + 10] = m_r1y
        gradient[o + 11] = m_r1z
        gradient[o + 15] = m_r2x
        gradient[o + 16] = m_r2y
        gradient[o + 17] = m_r2z
    # Distance: bodies start, end
    for k in range(kinds[2], kinds[3]):
        b0 = bodies[k, 0]
        x0 = q[2 * b0, 0]
        y0 = q[2 * b0, 1]
        z0 = q[2 * b0, 2]
        vx0 = v[2 * b0, 0]
        vy0 = v[2 * b0, 1]
        vz0 = v[2 * b0, 2]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        x1 = q[2 * b1, 0]
        y1 = q[2 * b1, 1]
        z1 = q[2 * b1, 2]
        vx1 = v[2 * b1, 0]
        vy1 = v[2 * b1, 1]
        vz1 = v[2 * b1, 2]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        r0x, r0y, r0z = carried(frames, b1, p3, p4, p5)
        t_r0x, t_r0y, t_r0z = crossed(wx1, wy1, wz1, p3, p4, p5)
        dr0x, dr0y, dr0z = carried(frames, b1, t_r0x, t_r0y, t_r0z)
        c_r0x, c_r0y, c_r0z = crossed(wx1, wy1, wz1, t_r0x, t_r0y, t_r0z)
        r1x, r1y, r1z = carried(frames, b0, p0, p1, p2)
        t_r1x, t_r1y, t_r1z = crossed(wx0, wy0, wz0, p0, p1, p2)
        dr1x, dr1y, dr1z = carried(frames, b0, t_r1x, t_r1y, t_r1z)
        c_r1x, c_r1y, c_r1z = crossed(wx0, wy0, wz0, t_r1x, t_r1y, t_r1z)
        root_0 = math.sqrt((r0x - r1x - x0 + x1) ** 2 + (r0y - r1y - y0 + y1) ** 2 + (r0z - r1z - z0 + z1) ** 2)
        u0 = 2 * r0x - 2 * r1x - 2 * x0 + 2 * x1
        u1 = 1 / root_0
        u2 = (1 / 2) * u1
        u3 = 2 * r0y - 2 * r1y - 2 * y0 + 2 * y1
        u4 = 2 * r0z - 2 * r1z - 2 * z0 + 2 * z1
        u5 = -u0
        u6 = -u3
        u7 = -u4
        u8 = 2 * dr0x - 2 * dr1x - 2 * vx0 + 2 * vx1
        u9 = u2 * u8
        u10 = 2 * dr0y - 2 * dr1y - 2 * vy0 + 2 * vy1
        u11 = u10 * u2
        u12 = 2 * dr0z - 2 * dr1z - 2 * vz0 + 2 * vz1
        u13 = u12 * u2
        u14 = -u2 * u8
        u15 = -u10 * u2
        u16 = -u12 * u2
        u17 = r0x - r1x - x0 + x1
        u18 = r0y - r1y - y0 + y1
        u19 = r0z - r1z - z0 + z1
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b1, u0 * u2, u2 * u3, u2 * u4)
        pull_r1x, pull_r1y, pull_r1z = returned(frames, b0, u2 * u5, u2 * u6, u2 * u7)
        m_r0x, m_r0y, m_r0z = crossed(p3, p4, p5, pull_r0x, pull_r0y, pull_r0z)
        m_r1x, m_r1y, m_r1z = crossed(p0, p1, p2, pull_r1x, pull_r1y, pull_r1z)
        out[k, VALUE] = root_0
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r1x * pull_r1x
            + c_r1y * pull_r1y
            + c_r1z * pull_r1z
            + dr0x * u9
            + dr0y * u11
            + dr0z * u13
            + dr1x * u14
            + dr1y * u15
            + dr1z * u16
            + u11 * vy1
            + u13 * vz1
            + u14 * vx0
            + u15 * vy0
            + u16 * vz0
            + u9 * vx1
            - 1
            / 4
            * (
                dr0x * u0
                + dr0y * u3
                + dr0z * u4
                + dr1x * u5
                + dr1y * u6
                + dr1z * u7
                + u0 * vx1
                + u3 * vy1
                + u4 * vz1
                + u5 * vx0
                + u6 * vy0
                + u7 * vz0
            )
            ** 2
            / root_0**3
        )
        o = starts[2] + 12 * (k - kinds[2])
        gradient[o + 0] = -u1 * u17
        gradient[o + 1] = -u1 * u18
        gradient[o + 2] = -u1 * u19
        gradient[o + 3] = m_r1x
        gradient[o + 4] = m_r1y
        gradient[o + 5] = m_r1z
        gradient[o + 6] = u1 * u17
        gradient[o + 7] = u1 * u18
        gradient[o + 8] = u1 * u19
        gradient[o + 9] = m_r0x
        gradient[o + 10] = m_r0y
        gradient[o + 11] = m_r0z
    # Alignment, of fixed: bodies along
    for k in range(kinds[3], kinds[4]):
        b0 = bodies[k, 0]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        t_r0x, t_r0y, t_r0z = crossed(wx0, wy0, wz0, p3, p4, p5)
        c_r0x, c_r0y, c_r0z = crossed(wx0, wy0, wz0, t_r0x, t_r0y, t_r0z)
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b0, p0, p1, p2)
        m_r0x, m_r0y, m_r0z = crossed(p3, p4, p5, pull_r0x, pull_r0y, pull_r0z)
        out[k, VALUE] = p3 * pull_r0x + p4 * pull_r0y + p5 * pull_r0z
        out[k, BIAS] = c_r0x * pull_r0x + c_r0y * pull_r0y + c_r0z * pull_r0z
        o = starts[3] + 6 * (k - kinds[3])
        gradient[o + 3] = m_r0x
        gradient[o + 4] = m_r0y
        gradient[o + 5] = m_r0z
    # Alignment, along fixed: bodies of
    for k in range(kinds[4], kinds[5]):
        b0 = bodies[k, 0]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        t_r0x, t_r0y, t_r0z = crossed(wx0, wy0, wz0, p0, p1, p2)
        c_r0x, c_r0y, c_r0z = crossed(wx0, wy0, wz0, t_r0x, t_r0y, t_r0z)
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b0, p3, p4, p5)
        m_r0x, m_r0y, m_r0z = crossed(p0, p1, p2, pull_r0x, pull_r0y, pull_r0z)
        out[k, VALUE] = p0 * pull_r0x + p1 * pull_r0y + p2 * pull_r0z
        out[k, BIAS] = c_r0x * pull_r0x + c_r0y * pull_r0y + c_r0z * pull_r0z
        o = starts[4] + 6 * (k - kinds[4])
        gradient[o + 3] = m_r0x
        gradient[o + 4] = m_r0y
        gradient[o + 5] = m_r0z
    # Alignment: bodies of, along
    for k in range(kinds[5], kinds[6]):
        b0 = bodies[k, 0]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        r0x, r0y, r0z = carried(frames, b0, p0, p1, p2)
        t_r0x, t_r0y, t_r0z = crossed(wx0, wy0, wz0, p0, p1, p2)
        dr0x, dr0y, dr0z = carried(frames, b0, t_r0x, t_r0y, t_r0z)
        c_r0x, c_r0y, c_r0z = crossed(wx0, wy0, wz0, t_r0x, t_r0y, t_r0z)
        r1x, r1y, r1z = carried(frames, b1, p3, p4, p5)
        t_r1x, t_r1y, t_r1z = crossed(wx1, wy1, wz1, p3, p4, p5)
        dr1x, dr1y, dr1z = carried(frames, b1, t_r1x, t_r1y, t_r1z)
        c_r1x, c_r1y, c_r1z = crossed(wx1, wy1, wz1, t_r1x, t_r1y, t_r1z)
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b0, r1x, r1y, r1z)
        pull_r1x, pull_r1y, pull_r1z = returned(frames, b1, r0x, r0y, r0z)
        m_r0x, m_r0y, m_r0z = crossed(p0, p1, p2, pull_r0x, pull_r0y, pull_r0z)
        m_r1x, m_r1y, m_r1z = crossed(p3, p4, p5, pull_r1x, pull_r1y, pull_r1z)
        out[k, VALUE] = r0x * r1x + r0y * r1y + r0z * r1z
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r1x * pull_r1x
            + c_r1y * pull_r1y
            + c_r1z * pull_r1z
            + 2 * dr0x * dr1x
            + 2 * dr0y * dr1y
            + 2 * dr0z * dr1z
        )
        o = starts[5] + 12 * (k - kinds[5])
        gradient[o + 3] = m_r0x
        gradient[o + 4] = m_r0y
        gradient[o + 5] = m_r0z
        gradient[o + 9] = m_r1x
        gradient[o + 10] = m_r1y
        gradient[o + 11] = m_r1z
    # Turn: bodies of, start, side
    for k in range(kinds[6], kinds[7]):
        b0 = bodies[k, 0]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        b2 = bodies[k, 2]
        wx2 = v[2 * b2 + 1, 0]
        wy2 = v[2 * b2 + 1, 1]
        wz2 = v[2 * b2 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        p6 = numbers[k, 6]
        p7 = numbers[k, 7]
        p8 = numbers[k, 8]
        p9 = numbers[k, 9]
        r0x, r0y, r0z = carried(frames, b0, p0, p1, p2)
        t_r0x, t_r0y, t_r0z = crossed(wx0, wy0, wz0, p0, p1, p2)
        dr0x, dr0y, dr0z = carried(frames, b0, t_r0x, t_r0y, t_r0z)
        c_r0x, c_r0y, c_r0z = crossed(wx0, wy0, wz0, t_r0x, t_r0y, t_r0z)
        r1x, r1y, r1z = carried(frames, b1, p3, p4, p5)
        t_r1x, t_r1y, t_r1z = crossed(wx1, wy1, wz1, p3, p4, p5)
        dr1x, dr1y, dr1z = carried(frames, b1, t_r1x, t_r1y, t_r1z)
        c_r1x, c_r1y, c_r1z = crossed(wx1, wy1, wz1, t_r1x, t_r1y, t_r1z)
        r2x, r2y, r2z = carried(frames, b2, p6, p7, p8)
        t_r2x, t_r2y, t_r2z = crossed(wx2, wy2, wz2, p6, p7, p8)
        dr2x, dr2y, dr2z = carried(frames, b2, t_r2x, t_r2y, t_r2z)
        c_r2x, c_r2y, c_r2z = crossed(wx2, wy2, wz2, t_r2x, t_r2y, t_r2z)
        dx, dy, rho = r0x * r1x + r0y * r1y + r0z * r1z, r0x * r2x + r0y * r2y + r0z * r2z, 0
        length_0 = math.sqrt(dx * dx + dy * dy - rho * rho)
        square = dx * dx + dy * dy
        ex_0, ey_0 = (length_0 * dx + rho * dy) / square, (length_0 * dy - rho * dx) / square
        bearing_0 = math.atan2(ey_0, ex_0)
        bearing_0 += TURN * math.floor((out[k, NEAR] - bearing_0) / TURN + 0.5)
        out[k, BEARING] = bearing_0
        u0 = 1 / length_0
        u1 = ey_0 * u0
        u2 = ex_0 * u0
        u3 = dr1x * ey_0
        u4 = dr0x * u0
        u5 = dr1y * ey_0
        u6 = dr0y * u0
        u7 = dr1z * ey_0
        u8 = dr0z * u0
        u9 = dr0x * r1x + dr0y * r1y + dr0z * r1z + dr1x * r0x + dr1y * r0y + dr1z * r0z
        u10 = dr0x * r2x + dr0y * r2y + dr0z * r2z + dr2x * r0x + dr2y * r0y + dr2z * r0z
        u11 = ey_0 * u10
        u12 = (ex_0 * u10 - ey_0 * u9) / length_0**2
        pull_r0x, pull_r0y, pull_r0z = returned(
            frames, b0, u0 * (ex_0 * r2x - ey_0 * r1x), u0 * (ex_0 * r2y - ey_0 * r1y), u0 * (ex_0 * r2z - ey_0 * r1z)
        )
        pull_r1x, pull_r1y, pull_r1z = returned(frames, b1, -r0x * u1, -r0y * u1, -r0z * u1)
        pull_r2x, pull_r2y, pull_r2z = returned(frames, b2, r0x * u2, r0y * u2, r0z * u2)
        m_r0x, m_r0y, m_r0z = crossed(p0, p1, p2, pull_r0x, pull_r0y, pull_r0z)
        m_r1x, m_r1y, m_r1z = crossed(p3, p4, p5, pull_r1x, pull_r1y, pull_r1z)
        m_r2x, m_r2y, m_r2z = crossed(p6, p7, p8, pull_r2x, pull_r2y, pull_r2z)
        out[k, VALUE] = bearing_0 - p9
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r1x * pull_r1x
            + c_r1y * pull_r1y
            + c_r1z * pull_r1z
            + c_r2x * pull_r2x
            + c_r2y * pull_r2y
            + c_r2z * pull_r2z
            + dr2x * ex_0 * u4
            + dr2y * ex_0 * u6
            + dr2z * ex_0 * u8
            - ex_0 * u12 * u9
            - u11 * u12
            - u12 * (ex_0 * u9 + u11)
            - u3 * u4
            + u4 * (dr2x * ex_0 - u3)
            - u5 * u6
            + u6 * (dr2y * ex_0 - u5)
            - u7 * u8
            + u8 * (dr2z * ex_0 - u7)
        )
        o = starts[6] + 18 * (k - kinds[6])
        gradient[o + 3] = m_r0x
        gradient[o + 4] = m_r0y
        gradient[o + 5] = m_r0z
        gradient[o + 9] = m_r1x
        gradient[o + 10] = m_r1y
        gradient[o + 11] = m_r1z
        gradient[o + 15] = m_r2x
        gradient[o + 16] = m_r2y
        gradient[o + 17] = m_r2z
    # Angle: bodies of, origin
    for k in range(kinds[7], kinds[8]):
        b0 = bodies[k, 0]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p9 = numbers[k, 9]
        p10 = numbers[k, 10]
        p11 = numbers[k, 11]
        p12 = numbers[k, 12]
        p13 = numbers[k, 13]
        p14 = numbers[k, 14]
        p18 = numbers[k, 18]
        r0x, r0y, r0z = carried(frames, b0, p0, p1, p2)
        t_r0x, t_r0y, t_r0z = crossed(wx0, wy0, wz0, p0, p1, p2)
        dr0x, dr0y, dr0z = carried(frames, b0, t_r0x, t_r0y, t_r0z)
        c_r0x, c_r0y, c_r0z = crossed(wx0, wy0, wz0, t_r0x, t_r0y, t_r0z)
        r3x, r3y, r3z = carried(frames, b1, p9, p10, p11)
        t_r3x, t_r3y, t_r3z = crossed(wx1, wy1, wz1, p9, p10, p11)
        dr3x, dr3y, dr3z = carried(frames, b1, t_r3x, t_r3y, t_r3z)
        c_r3x, c_r3y, c_r3z = crossed(wx1, wy1, wz1, t_r3x, t_r3y, t_r3z)
        r4x, r4y, r4z = carried(frames, b1, p12, p13, p14)
        t_r4x, t_r4y, t_r4z = crossed(wx1, wy1, wz1, p12, p13, p14)
        dr4x, dr4y, dr4z = carried(frames, b1, t_r4x, t_r4y, t_r4z)
        c_r4x, c_r4y, c_r4z = crossed(wx1, wy1, wz1, t_r4x, t_r4y, t_r4z)
        dx, dy, rho = r0x * r3x + r0y * r3y + r0z * r3z, r0x * r4x + r0y * r4y + r0z * r4z, 0
        length_0 = math.sqrt(dx * dx + dy * dy - rho * rho)
        square = dx * dx + dy * dy
        ex_0, ey_0 = (length_0 * dx + rho * dy) / square, (length_0 * dy - rho * dx) / square
        bearing_0 = math.atan2(ey_0, ex_0)
        bearing_0 += TURN * math.floor((out[k, NEAR] - bearing_0) / TURN + 0.5)
        out[k, BEARING] = bearing_0
        u0 = 1 / length_0
        u1 = ey_0 * u0
        u2 = ex_0 * u0
        u3 = dr3x * ey_0
        u4 = dr0x * u0
        u5 = dr3y * ey_0
        u6 = dr0y * u0
        u7 = dr3z * ey_0
        u8 = dr0z * u0
        u9 = dr0x * r3x + dr0y * r3y + dr0z * r3z + dr3x * r0x + dr3y * r0y + dr3z * r0z
        u10 = dr0x * r4x + dr0y * r4y + dr0z * r4z + dr4x * r0x + dr4y * r0y + dr4z * r0z
        u11 = ey_0 * u10
        u12 = (ex_0 * u10 - ey_0 * u9) / length_0**2
        pull_r0x, pull_r0y, pull_r0z = returned(
            frames, b0, u0 * (ex_0 * r4x - ey_0 * r3x), u0 * (ex_0 * r4y - ey_0 * r3y), u0 * (ex_0 * r4z - ey_0 * r3z)
        )
        pull_r3x, pull_r3y, pull_r3z = returned(frames, b1, -r0x * u1, -r0y * u1, -r0z * u1)
        pull_r4x, pull_r4y, pull_r4z = returned(frames, b1, r0x * u2, r0y * u2, r0z * u2)
        m_r0x, m_r0y, m_r0z = crossed(p0, p1, p2, pull_r0x, pull_r0y, pull_r0z)
        m_r3x, m_r3y, m_r3z = crossed(p9, p10, p11, pull_r3x, pull_r3y, pull_r3z)
        m_r4x, m_r4y, m_r4z = crossed(p12, p13, p14, pull_r4x, pull_r4y, pull_r4z)
        out[k, VALUE] = bearing_0 - p18
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r3x * pull_r3x
            + c_r3y * pull_r3y
            + c_r3z * pull_r3z
            + c_r4x * pull_r4x
            + c_r4y * pull_r4y
            + c_r4z * pull_r4z
            + dr4x * ex_0 * u4
            + dr4y * ex_0 * u6
            + dr4z * ex_0 * u8
            - ex_0 * u12 * u9
            - u11 * u12
            - u12 * (ex_0 * u9 + u11)
            - u3 * u4
            + u4 * (dr4x * ex_0 - u3)
            - u5 * u6
            + u6 * (dr4y * ex_0 - u5)
            - u7 * u8
            + u8 * (dr4z * ex_0 - u7)
        )
        o = starts[7] + 12 * (k - kinds[7])
        gradient[o + 3] = m_r0x
        gradient[o + 4] = m_r0y
        gradient[o + 5] = m_r0z
        gradient[o + 9] = m_r3x + m_r4x
        gradient[o + 10] = m_r3y + m_r4y
        gradient[o + 11] = m_r3z + m_r4z
    # Bearing: bodies start, end, origin
    for k in range(kinds[8], kinds[9]):
        b0 = bodies[k, 0]
        x0 = q[2 * b0, 0]
        y0 = q[2 * b0, 1]
        z0 = q[2 * b0, 2]
        vx0 = v[2 * b0, 0]
        vy0 = v[2 * b0, 1]
        vz0 = v[2 * b0, 2]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        x1 = q[2 * b1, 0]
        y1 = q[2 * b1, 1]
        z1 = q[2 * b1, 2]
        vx1 = v[2 * b1, 0]
        vy1 = v[2 * b1, 1]
        vz1 = v[2 * b1, 2]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        b2 = bodies[k, 2]
        wx2 = v[2 * b2 + 1, 0]
        wy2 = v[2 * b2 + 1, 1]
        wz2 = v[2 * b2 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        p6 = numbers[k, 6]
        p7 = numbers[k, 7]
        p8 = numbers[k, 8]
        p9 = numbers[k, 9]
        p10 = numbers[k, 10]
        p11 = numbers[k, 11]
        p15 = numbers[k, 15]
        r0x, r0y, r0z = carried(frames, b1, p3, p4, p5)
        t_r0x, t_r0y, t_r0z = crossed(wx1, wy1, wz1, p3, p4, p5)
        dr0x, dr0y, dr0z = carried(frames, b1, t_r0x, t_r0y, t_r0z)
        c_r0x, c_r0y, c_r0z = crossed(wx1, wy1, wz1, t_r0x, t_r0y, t_r0z)
        r1x, r1y, r1z = carried(frames, b0, p0, p1, p2)
        t_r1x, t_r1y, t_r1z = crossed(wx0, wy0, wz0, p0, p1, p2)
        dr1x, dr1y, dr1z = carried(frames, b0, t_r1x, t_r1y, t_r1z)
        c_r1x, c_r1y, c_r1z = crossed(wx0, wy0, wz0, t_r1x, t_r1y, t_r1z)
        r2x, r2y, r2z = carried(frames, b2, p6, p7, p8)
        t_r2x, t_r2y, t_r2z = crossed(wx2, wy2, wz2, p6, p7, p8)
        dr2x, dr2y, dr2z = carried(frames, b2, t_r2x, t_r2y, t_r2z)
        c_r2x, c_r2y, c_r2z = crossed(wx2, wy2, wz2, t_r2x, t_r2y, t_r2z)
        r3x, r3y, r3z = carried(frames, b2, p9, p10, p11)
        t_r3x, t_r3y, t_r3z = crossed(wx2, wy2, wz2, p9, p10, p11)
        dr3x, dr3y, dr3z = carried(frames, b2, t_r3x, t_r3y, t_r3z)
        c_r3x, c_r3y, c_r3z = crossed(wx2, wy2, wz2, t_r3x, t_r3y, t_r3z)
        dx, dy, rho = (
            r2x * (r0x - r1x - x0 + x1) + r2y * (r0y - r1y - y0 + y1) + r2z * (r0z - r1z - z0 + z1),
            r3x * (r0x - r1x - x0 + x1) + r3y * (r0y - r1y - y0 + y1) + r3z * (r0z - r1z - z0 + z1),
            0,
        )
        length_0 = math.sqrt(dx * dx + dy * dy - rho * rho)
        square = dx * dx + dy * dy
        ex_0, ey_0 = (length_0 * dx + rho * dy) / square, (length_0 * dy - rho * dx) / square
        bearing_0 = math.atan2(ey_0, ex_0)
        bearing_0 += TURN * math.floor((out[k, NEAR] - bearing_0) / TURN + 0.5)
        out[k, BEARING] = bearing_0
        u0 = 1 / length_0
        u1 = ex_0 * r3x - ey_0 * r2x
        u2 = u0 * u1
        u3 = ex_0 * r3y - ey_0 * r2y
        u4 = u0 * u3
        u5 = ex_0 * r3z - ey_0 * r2z
        u6 = u0 * u5
        u7 = -u0 * u1
        u8 = -u0 * u3
        u9 = -u0 * u5
        u10 = r0x - r1x - x0 + x1
        u11 = ey_0 * u0
        u12 = r0y - r1y - y0 + y1
        u13 = r0z - r1z - z0 + z1
        u14 = ex_0 * u0
        u15 = dr2x * ey_0
        u16 = -dr3x * ex_0 + u15
        u17 = -u0 * u16
        u18 = dr2y * ey_0
        u19 = -dr3y * ex_0 + u18
        u20 = -u0 * u19
        u21 = dr2z * ey_0
        u22 = -dr3z * ex_0 + u21
        u23 = -u0 * u22
        u24 = u0 * u16
        u25 = u0 * u19
        u26 = u0 * u22
        u27 = (
            dr0x * r2x
            + dr0y * r2y
            + dr0z * r2z
            - dr1x * r2x
            - dr1y * r2y
            - dr1z * r2z
            + dr2x * u10
            + dr2y * u12
            + dr2z * u13
            - r2x * vx0
            + r2x * vx1
            - r2y * vy0
            + r2y * vy1
            - r2z * vz0
            + r2z * vz1
        )
        u28 = (
            dr0x * r3x
            + dr0y * r3y
            + dr0z * r3z
            - dr1x * r3x
            - dr1y * r3y
            - dr1z * r3z
            + dr3x * u10
            + dr3y * u12
            + dr3z * u13
            - r3x * vx0
            + r3x * vx1
            - r3y * vy0
            + r3y * vy1
            - r3z * vz0
            + r3z * vz1
        )
        u29 = ey_0 * u28
        u30 = (ex_0 * u28 - ey_0 * u27) / length_0**2
        u31 = u0 * (dr0x - dr1x - vx0 + vx1)
        u32 = u0 * (dr0y - dr1y - vy0 + vy1)
        u33 = u0 * (dr0z - dr1z - vz0 + vz1)
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b1, u2, u4, u6)
        pull_r1x, pull_r1y, pull_r1z = returned(frames, b0, u7, u8, u9)
        pull_r2x, pull_r2y, pull_r2z = returned(frames, b2, -u10 * u11, -u11 * u12, -u11 * u13)
        pull_r3x, pull_r3y, pull_r3z = returned(frames, b2, u10 * u14, u12 * u14, u13 * u14)
        m_r0x, m_r0y, m_r0z = crossed(p3, p4, p5, pull_r0x, pull_r0y, pull_r0z)
        m_r1x, m_r1y, m_r1z = crossed(p0, p1, p2, pull_r1x, pull_r1y, pull_r1z)
        m_r2x, m_r2y, m_r2z = crossed(p6, p7, p8, pull_r2x, pull_r2y, pull_r2z)
        m_r3x, m_r3y, m_r3z = crossed(p9, p10, p11, pull_r3x, pull_r3y, pull_r3z)
        out[k, VALUE] = bearing_0 - p15
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r1x * pull_r1x
            + c_r1y * pull_r1y
            + c_r1z * pull_r1z
            + c_r2x * pull_r2x
            + c_r2y * pull_r2y
            + c_r2z * pull_r2z
            + c_r3x * pull_r3x
            + c_r3y * pull_r3y
            + c_r3z * pull_r3z
            + dr0x * u17
            + dr0y * u20
            + dr0z * u23
            + dr1x * u24
            + dr1y * u25
            + dr1z * u26
            + dr3x * ex_0 * u31
            + dr3y * ex_0 * u32
            + dr3z * ex_0 * u33
            - ex_0 * u27 * u30
            - u15 * u31
            + u17 * vx1
            - u18 * u32
            + u20 * vy1
            - u21 * u33
            + u23 * vz1
            + u24 * vx0
            + u25 * vy0
            + u26 * vz0
            - u29 * u30
            - u30 * (ex_0 * u27 + u29)
        )
        o = starts[8] + 18 * (k - kinds[8])
        gradient[o + 0] = u7
        gradient[o + 1] = u8
        gradient[o + 2] = u9
        gradient[o + 3] = m_r1x
        gradient[o + 4] = m_r1y
        gradient[o + 5] = m_r1z
        gradient[o + 6] = u2
        gradient[o + 7] = u4
        gradient[o + 8] = u6
        gradient[o + 9] = m_r0x
        gradient[o + 10] = m_r0y
        gradient[o + 11] = m_r0z
        gradient[o + 15] = m_r2x + m_r3x
        gradient[o + 16] = m_r2y + m_r3y
        gradient[o + 17] = m_r2z + m_r3z
    # Lead: bodies start, end
    for k in range(kinds[9], kinds[10]):
        b0 = bodies[k, 0]
        x0 = q[2 * b0, 0]
        y0 = q[2 * b0, 1]
        vx0 = v[2 * b0, 0]
        vy0 = v[2 * b0, 1]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        x1 = q[2 * b1, 0]
        y1 = q[2 * b1, 1]
        vx1 = v[2 * b1, 0]
        vy1 = v[2 * b1, 1]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        p6 = numbers[k, 6]
        r0x, r0y, r0z = carried(frames, b1, p3, p4, p5)
        t_r0x, t_r0y, t_r0z = crossed(wx1, wy1, wz1, p3, p4, p5)
        dr0x, dr0y, dr0z = carried(frames, b1, t_r0x, t_r0y, t_r0z)
        c_r0x, c_r0y, c_r0z = crossed(wx1, wy1, wz1, t_r0x, t_r0y, t_r0z)
        r1x, r1y, r1z = carried(frames, b0, p0, p1, p2)
        t_r1x, t_r1y, t_r1z = crossed(wx0, wy0, wz0, p0, p1, p2)
        dr1x, dr1y, dr1z = carried(frames, b0, t_r1x, t_r1y, t_r1z)
        c_r1x, c_r1y, c_r1z = crossed(wx0, wy0, wz0, t_r1x, t_r1y, t_r1z)
        dx, dy, rho = r0x - r1x - x0 + x1, r0y - r1y - y0 + y1, p6
        length_0 = math.sqrt(dx * dx + dy * dy - rho * rho)
        square = dx * dx + dy * dy
        ex_0, ey_0 = (length_0 * dx + rho * dy) / square, (length_0 * dy - rho * dx) / square
        bearing_0 = math.atan2(ey_0, ex_0)
        bearing_0 += TURN * math.floor((out[k, NEAR] - bearing_0) / TURN + 0.5)
        out[k, BEARING] = bearing_0
        u0 = -ex_0
        u1 = -ey_0
        u2 = ex_0 * (dr0y - dr1y - vy0 + vy1)
        u3 = ey_0 * (dr0x - dr1x - vx0 + vx1)
        u4 = (u2 - u3) / length_0
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b1, ex_0, ey_0, 0)
        pull_r1x, pull_r1y, pull_r1z = returned(frames, b0, u0, u1, 0)
        m_r0x, m_r0y, m_r0z = crossed(p3, p4, p5, pull_r0x, pull_r0y, pull_r0z)
        m_r1x, m_r1y, m_r1z = crossed(p0, p1, p2, pull_r1x, pull_r1y, pull_r1z)
        out[k, VALUE] = -bearing_0 * p6 + length_0
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r1x * pull_r1x
            + c_r1y * pull_r1y
            + c_r1z * pull_r1z
            + u2 * u4
            - u3 * u4
        )
        o = starts[9] + 12 * (k - kinds[9])
        gradient[o + 0] = u0
        gradient[o + 1] = u1
        gradient[o + 3] = m_r1x
        gradient[o + 4] = m_r1y
        gradient[o + 5] = m_r1z
        gradient[o + 6] = ex_0
        gradient[o + 7] = ey_0
        gradient[o + 9] = m_r0x
        gradient[o + 10] = m_r0y
        gradient[o + 11] = m_r0z
    # LeadInPlane: bodies start, end, along, side
    for k in range(kinds[10], kinds[11]):
        b0 = bodies[k, 0]
        x0 = q[2 * b0, 0]
        y0 = q[2 * b0, 1]
        z0 = q[2 * b0, 2]
        vx0 = v[2 * b0, 0]
        vy0 = v[2 * b0, 1]
        vz0 = v[2 * b0, 2]
        wx0 = v[2 * b0 + 1, 0]
        wy0 = v[2 * b0 + 1, 1]
        wz0 = v[2 * b0 + 1, 2]
        b1 = bodies[k, 1]
        x1 = q[2 * b1, 0]
        y1 = q[2 * b1, 1]
        z1 = q[2 * b1, 2]
        vx1 = v[2 * b1, 0]
        vy1 = v[2 * b1, 1]
        vz1 = v[2 * b1, 2]
        wx1 = v[2 * b1 + 1, 0]
        wy1 = v[2 * b1 + 1, 1]
        wz1 = v[2 * b1 + 1, 2]
        b2 = bodies[k, 2]
        wx2 = v[2 * b2 + 1, 0]
        wy2 = v[2 * b2 + 1, 1]
        wz2 = v[2 * b2 + 1, 2]
        b3 = bodies[k, 3]
        wx3 = v[2 * b3 + 1, 0]
        wy3 = v[2 * b3 + 1, 1]
        wz3 = v[2 * b3 + 1, 2]
        p0 = numbers[k, 0]
        p1 = numbers[k, 1]
        p2 = numbers[k, 2]
        p3 = numbers[k, 3]
        p4 = numbers[k, 4]
        p5 = numbers[k, 5]
        p6 = numbers[k, 6]
        p7 = numbers[k, 7]
        p8 = numbers[k, 8]
        p9 = numbers[k, 9]
        p10 = numbers[k, 10]
        p11 = numbers[k, 11]
        p12 = numbers[k, 12]
        r0x, r0y, r0z = carried(frames, b1, p3, p4, p5)
        t_r0x, t_r0y, t_r0z = crossed(wx1, wy1, wz1, p3, p4, p5)
        dr0x, dr0y, dr0z = carried(frames, b1, t_r0x, t_r0y, t_r0z)
        c_r0x, c_r0y, c_r0z = crossed(wx1, wy1, wz1, t_r0x, t_r0y, t_r0z)
        r1x, r1y, r1z = carried(frames, b0, p0, p1, p2)
        t_r1x, t_r1y, t_r1z = crossed(wx0, wy0, wz0, p0, p1, p2)
        dr1x, dr1y, dr1z = carried(frames, b0, t_r1x, t_r1y, t_r1z)
        c_r1x, c_r1y, c_r1z = crossed(wx0, wy0, wz0, t_r1x, t_r1y, t_r1z)
        r2x, r2y, r2z = carried(frames, b2, p7, p8, p9)
        t_r2x, t_r2y, t_r2z = crossed(wx2, wy2, wz2, p7, p8, p9)
        dr2x, dr2y, dr2z = carried(frames, b2, t_r2x, t_r2y, t_r2z)
        c_r2x, c_r2y, c_r2z = crossed(wx2, wy2, wz2, t_r2x, t_r2y, t_r2z)
        r3x, r3y, r3z = carried(frames, b3, p10, p11, p12)
        t_r3x, t_r3y, t_r3z = crossed(wx3, wy3, wz3, p10, p11, p12)
        dr3x, dr3y, dr3z = carried(frames, b3, t_r3x, t_r3y, t_r3z)
        c_r3x, c_r3y, c_r3z = crossed(wx3, wy3, wz3, t_r3x, t_r3y, t_r3z)
        dx, dy, rho = (
            r2x * (r0x - r1x - x0 + x1) + r2y * (r0y - r1y - y0 + y1) + r2z * (r0z - r1z - z0 + z1),
            r3x * (r0x - r1x - x0 + x1) + r3y * (r0y - r1y - y0 + y1) + r3z * (r0z - r1z - z0 + z1),
            p6,
        )
        length_0 = math.sqrt(dx * dx + dy * dy - rho * rho)
        square = dx * dx + dy * dy
        ex_0, ey_0 = (length_0 * dx + rho * dy) / square, (length_0 * dy - rho * dx) / square
        bearing_0 = math.atan2(ey_0, ex_0)
        bearing_0 += TURN * math.floor((out[k, NEAR] - bearing_0) / TURN + 0.5)
        out[k, BEARING] = bearing_0
        u0 = ex_0 * r2x + ey_0 * r3x
        u1 = ex_0 * r2y + ey_0 * r3y
        u2 = ex_0 * r2z + ey_0 * r3z
        u3 = r0x - r1x - x0 + x1
        u4 = r0y - r1y - y0 + y1
        u5 = r0z - r1z - z0 + z1
        u6 = dr2x * ex_0
        u7 = dr3x * ey_0
        u8 = u6 + u7
        u9 = dr2y * ex_0
        u10 = dr3y * ey_0
        u11 = u10 + u9
        u12 = dr2z * ex_0
        u13 = dr3z * ey_0
        u14 = u12 + u13
        u15 = -u8
        u16 = -u11
        u17 = -u14
        u18 = dr0x - dr1x - vx0 + vx1
        u19 = dr0y - dr1y - vy0 + vy1
        u20 = dr0z - dr1z - vz0 + vz1
        u21 = ex_0 * (
            dr0x * r3x
            + dr0y * r3y
            + dr0z * r3z
            - dr1x * r3x
            - dr1y * r3y
            - dr1z * r3z
            + dr3x * u3
            + dr3y * u4
            + dr3z * u5
            - r3x * vx0
            + r3x * vx1
            - r3y * vy0
            + r3y * vy1
            - r3z * vz0
            + r3z * vz1
        )
        u22 = ey_0 * (
            dr0x * r2x
            + dr0y * r2y
            + dr0z * r2z
            - dr1x * r2x
            - dr1y * r2y
            - dr1z * r2z
            + dr2x * u3
            + dr2y * u4
            + dr2z * u5
            - r2x * vx0
            + r2x * vx1
            - r2y * vy0
            + r2y * vy1
            - r2z * vz0
            + r2z * vz1
        )
        u23 = (u21 - u22) / length_0
        pull_r0x, pull_r0y, pull_r0z = returned(frames, b1, u0, u1, u2)
        pull_r1x, pull_r1y, pull_r1z = returned(frames, b0, -u0, -u1, -u2)
        pull_r2x, pull_r2y, pull_r2z = returned(frames, b2, ex_0 * u3, ex_0 * u4, ex_0 * u5)
        pull_r3x, pull_r3y, pull_r3z = returned(frames, b3, ey_0 * u3, ey_0 * u4, ey_0 * u5)
        m_r0x, m_r0y, m_r0z = crossed(p3, p4, p5, pull_r0x, pull_r0y, pull_r0z)
        m_r1x, m_r1y, m_r1z = crossed(p0, p1, p2, pull_r1x, pull_r1y, pull_r1z)
        m_r2x, m_r2y, m_r2z = crossed(p7, p8, p9, pull_r2x, pull_r2y, pull_r2z)
        m_r3x, m_r3y, m_r3z = crossed(p10, p11, p12, pull_r3x, pull_r3y, pull_r3z)
        out[k, VALUE] = -bearing_0 * p6 + length_0
        out[k, BIAS] = (
            c_r0x * pull_r0x
            + c_r0y * pull_r0y
            + c_r0z * pull_r0z
            + c_r1x * pull_r1x
            + c_r1y * pull_r1y
            + c_r1z * pull_r1z
            + c_r2x * pull_r2x
            + c_r2y * pull_r2y
            + c_r2z * pull_r2z
            + c_r3x * pull_r3x
            + c_r3y * pull_r3y
            + c_r3z * pull_r3z
            + dr0x * u8
            + dr0y * u11
            + dr0z * u14
            + dr1x * u15
            + dr1y * u16
            + dr1z * u17
            + u10 * u19
            + u11 * vy1
            + u12 * u20
            + u13 * u20
            + u14 * vz1
            + u15 * vx0
            + u16 * vy0
            + u17 * vz0
            + u18 * u6
            + u18 * u7
            + u19 * u9
            + u21 * u23
            - u22 * u23
            + u8 * vx1
        )
        o = starts[10] + 24 * (k - kinds[10])
        gradient[o + 0] = -u0
        gradient[o + 1] = -u1
        gradient[o + 2] = -u2
        gradient[o + 3] = m_r1x
        gradient[o + 4] = m_r1y
        gradient[o + 5] = m_r1z
        gradient[o + 6] = u0
        gradient[o + 7] = u1
        gradient[o + 8] = u2
        gradient[o + 9] = m_r0x
        gradient[o + 10] = m_r0y
        gradient[o + 11] = m_r0z
        gradient[o + 15] = m_r2x
        gradient[o + 16] = m_r2y
        gradient[o + 17] = m_r2z
        gradient[o + 21] = m_r3x
        gradient[o + 22] = m_r3y
        gradient[o + 23] = m_r3z


def fill(kinds: Any, starts: Any, numbers: Any, gradient: Any) -> None:
    # Displacement, along fixed: bodies of, origin
    for k in range(kinds[0], kinds[1]):
        p6 = numbers[k, 6]
        p7 = numbers[k, 7]
        p8 = numbers[k, 8]
        o = starts[0] + 12 * (k - kinds[0])
        gradient[o + 0] = p6
        gradient[o + 1] = p7
        gradient[o + 2] = p8
        gradient[o + 6] = -p6
        gradient[o + 7] = -p7
        gradient[o + 8] = -p8
