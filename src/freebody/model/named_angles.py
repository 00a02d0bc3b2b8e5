"""The named angles of a chain of rotations, as measures of a body's orientation.

With constant rotations A, B between them and q_i the named angles, a chain is

    R = A Rot(a_1, q_1) [C Rot(a_2, q_2) [D Rot(a_3, q_3)]] B.

Each named angle is a measure. For one or two of them it is the turn of a direction that the others leave alone: a_2
seen from the frame, a_1 seen from the body. Three need axes along x, y or z next to each other, no two neighbours
alike: a_1 = a_3 gives Euler's angles (singular where sin q_2 = 0), three different ones Tait-Bryan angles (cos q_2 =
0). Source: Shuster, J. Astronautical Sciences 41 (1993) 439, sec. on Euler angles.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from freebody.language.expression import Call, Symbol
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.geometry import ZERO, Components, Direction
from freebody.measures.turn import Alignment, Turn
from freebody.model.elements import Rotation
from freebody.model.names import Names
from freebody.model.rotations import (
    UNIT,
    RotationPair,
    along_axis,
    applied,
    perpendiculars,
    pieces,
    reversed_,
    transposed,
    vector_product,
)


def offered_name(connection: str, key: str, measure: Measure) -> str:
    """What a measure of a connection is called that has no name of its own: phi_spindle for the angle of a joint,
    phi_cross_2 for one of several, rail_travel for a displacement."""
    if not measure.is_angle:
        return f"{connection}_{key}"
    return f"phi_{connection}" if key == "angle" else f"phi_{connection}_{key}"


_Fixed = Callable[[Components], Direction]  # components to a direction fixed in a body


def angles_of(names: Names, chain: Sequence[Rotation], body: str, frame: str) -> dict[str, Measure]:
    """The named angles of a chain as measures of the body's orientation. Notes a problem where they are none."""
    named, last = pieces(chain)
    if not named:
        return {}
    back = transposed(last)

    def on_frame(v: Components) -> Direction:
        return Direction(frame, applied(named[0].before, v))

    def on_body(v: Components) -> Direction:
        return Direction(body, applied(back, v))

    first = named[0].axis
    b, c = perpendiculars(first)
    if len(named) == 1:
        return {named[0].name: Turn(on_body(b), on_frame(b), on_frame(c))}
    second = applied(named[1].before, named[1].axis)  # seen in the frame of the first angle
    if len(named) == 2:
        side = vector_product(first, second)
        if all(c == ZERO for c in side):
            one, other = named[0].name, named[1].name
            names.problem(
                Message(
                    "{one} and {other} turn about the same axis, so only their sum has a meaning: name one angle, or "
                    "turn about another axis between them",
                    one=one,
                    other=other,
                )
            )
            return {}
        start = vector_product(side, first)
        back_first = applied(transposed(named[1].before), first)
        own_side = vector_product(named[1].axis, back_first)
        own_start = vector_product(own_side, named[1].axis)
        return {
            named[0].name: Turn(on_body(named[1].axis), on_frame(start), on_frame(side)),
            # seen from the body the first axis turns backwards
            named[1].name: Turn(on_frame(first), on_body(own_start), on_body(reversed_(own_side))),
        }
    return _three(names, named, on_frame, on_body)


def _three(names: Names, named: Sequence[RotationPair], on_frame: _Fixed, on_body: _Fixed) -> dict[str, Measure]:
    axes = [along_axis(piece.axis) for piece in named]
    plain = all(axis is not None for axis in axes) and all(piece.before == UNIT for piece in named[1:])
    if len(named) != 3 or not plain or any(a and b and a[0] == b[0] for a, b in pairwise(axes)):
        names.problem(
            Message(
                "three named angles turn about x, y or z, neighbours about different ones, with nothing between "
                "them, e.g. turned: [psi about z, theta about x, phi about z]"
            ),
        )
        return {}
    (q1, a1), (q2, a2), (q3, a3) = ((piece.name, piece.axis) for piece in named)
    if axes[0] is not None and axes[2] is not None and axes[0][0] == axes[2][0]:
        # R a1 = cos q2 a1 + sin q2 (a2 x a1), turned by q1 about a1; sin q2 > 0
        side = vector_product(a2, a1)
        flip = on_body(a1)
        back = vector_product(a1, a2)  # R^T a1 = cos q2 a1 + sin q2 (a1 x a2), turned back by q3 about a3
        third_side = reversed_(vector_product(a3, back))
        return {
            q1: Turn(flip, on_frame(side), on_frame(vector_product(a1, side))),
            q2: Composed(Call("acos", Symbol("c")), (("c", Alignment(flip, on_frame(a1))),), DIMENSIONLESS),
            q3: Turn(on_frame(a1), on_body(back), on_body(third_side)),
        }
    # a3 = s a1 x a2.  R a3 = cos q2 a3 + sin q2 (a2 x a3), a2 x a3 = s a1;  q1 turns it about a1; cos q2 > 0
    sine = Alignment(on_body(a3), on_frame(a1))
    s = 1 if vector_product(a1, a2) == a3 else -1
    tilt = Symbol("c") if s > 0 else -Symbol("c")
    # R^T a1 = cos q2 a1 + sin q2 (a1 x a2 = s a3), turned back by q3 about a3
    return {
        q1: Turn(on_body(a3), on_frame(a3), on_frame(vector_product(a1, a3))),
        q2: Composed(Call("asin", tilt), (("c", sine),), DIMENSIONLESS),
        q3: Turn(on_frame(a1), on_body(a1), on_body(reversed_(vector_product(a3, a1)))),
    }
