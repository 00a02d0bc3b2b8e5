"""Parts of disks and rings: sector, half disk, arc, half ring.

With beta = angle/2 on both sides of the axis of symmetry x, from the centre of the circle:

    sector     x_G = 2 R sin(beta)/(3 beta)    I = m R^2/2     I_x, I_y = m R^2/4 (1 -/+ sin(2 beta)/(2 beta))
    thin arc   x_G = R sin(beta)/beta          I = m R^2       I_x, I_y = m R^2/2 (1 -/+ sin(2 beta)/(2 beta))

about the centre; about the mass centre by parallel axes (Huygens-Steiner). Source: Beer, Johnston & Cornwell, Vector
Mechanics for Engineers: Statics, inside back cover.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import PI, Call, Expr, divide, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH, MASS
from freebody.measures.geometry import ONE, ZERO, Components
from freebody.model.elements import Edge
from freebody.model.shapes.base import N_SIDES, Build, Shape, half, square
from freebody.model.solids import PLATE
from freebody.model.spec import Formula
from freebody.model.tensors import moved

if TYPE_CHECKING:
    from freebody.model.names import Names

_N_SIDES = N_SIDES // 2  # of the drawn rim


class Sector(Shape, kind="sector"):
    """`sector: {mass: m, radius: R, angle: 60 deg}`: a uniform plate cut from a disk, alike on both sides of its own x
    axis. The reference point is the `center` of the circle, the mass centre 2 R sin(beta)/(3 beta) from it along x,
    beta = angle/2. Points: `start`, `middle` and `end` of the rim."""

    mass: Formula = 0
    radius: Formula
    angle: Formula

    example = "{mass: 1 kg, radius: 0.3 m, angle: 60 deg}"

    def build(self, names: Names) -> Build:
        angle = _opening(names, self)
        return _part_of_disk(names, self, angle, Call("sin", half(angle)), Call("cos", half(angle)))


class HalfDisk(Shape, kind="half_disk"):
    """`half_disk: {mass: m, radius: R}`: a uniform half disk (half cylinder, semicircular plate), its round side
    towards its own +x: the mass centre is 4 R/(3 pi) from the `center`, its reference point. It rolls with its rim.
    Points: `start`, `middle` and `end` of the rim."""

    called: ClassVar[tuple[str, ...]] = (
        "half cylinder",
        "half disk",
        "half disc",
        "semicircular disk",
        "semicircular plate",
    )

    mass: Formula = 0
    radius: Formula

    example = "{mass: 1 kg, radius: 0.3 m}"

    def build(self, names: Names) -> Build:
        return _part_of_disk(names, self, PI, ONE, ZERO)


class Arc(Shape, kind="arc"):
    """`arc: {mass: m, radius: R, angle: 90 deg}`: a thin wire bent to an arc, alike on both sides of its own x axis.
    The reference point is the `center` of the circle, the mass centre R sin(beta)/beta from it along x, beta = angle/2.
    Points: `start`, `middle` and `end` of the wire."""

    mass: Formula = 0
    radius: Formula
    angle: Formula

    example = "{mass: 1 kg, radius: 0.3 m, angle: 90 deg}"

    def build(self, names: Names) -> Build:
        angle = _opening(names, self)
        return _part_of_ring(names, self, angle, Call("sin", half(angle)), Call("cos", half(angle)))


class HalfRing(Shape, kind="half_ring"):
    """`half_ring: {mass: m, radius: R}`: a thin wire or hoop of half a circle, its middle on its own +x: the mass
    centre is 2 R/pi from the `center`, its reference point. Points: `start`, `middle` and `end` of the wire."""

    called: ClassVar[tuple[str, ...]] = (
        "half ring",
        "half hoop",
        "ring",
        "semicircular wire",
        "semicircular hoop",
        "semicircular ring",
    )

    mass: Formula = 0
    radius: Formula

    example = "{mass: 1 kg, radius: 0.3 m}"

    def build(self, names: Names) -> Build:
        return _part_of_ring(names, self, PI, ONE, ZERO)


def _opening(names: Names, spec: Sector | Arc) -> Expr:
    """The whole angle, which lies between nothing and a full turn."""
    angle = names.formula(spec.angle, DIMENSIONLESS, "angle")
    value = names.numeric(angle)
    if value is not None and not 0.0 < value <= 6.2832:
        names.problem(
            Message(
                "angle is {value:.4g} rad; it lies between 0 and 360 deg, and a full one is a {whole}",
                value=value,
                whole="disk" if isinstance(spec, Sector) else "ring",
            ),
            "angle",
        )
        return PI
    return angle


def _part_of_disk(names: Names, spec: Sector | HalfDisk, angle: Expr, sine: Expr, cosine: Expr) -> Build:
    m, R = names.positive(spec, "mass", MASS), names.positive(spec, "radius", LENGTH)
    middle = divide(4 * R * sine, 3 * angle)
    about_center = half(m * square(R))
    return _built(names, (m, R, about_center, middle), angle, (sine, cosine), is_wire=False)


def _part_of_ring(names: Names, spec: Arc | HalfRing, angle: Expr, sine: Expr, cosine: Expr) -> Build:
    m, R = names.positive(spec, "mass", MASS), names.positive(spec, "radius", LENGTH)
    middle = divide(2 * R * sine, angle)
    return _built(names, (m, R, m * square(R), middle), angle, (sine, cosine), is_wire=True)


def _built(
    names: Names, sizes: tuple[Expr, Expr, Expr, Expr], angle: Expr, ends: tuple[Expr, Expr], *, is_wire: bool
) -> Build:
    """sizes: mass, radius, moment of inertia about the centre, place of the mass centre on x. ends: sine and cosine of
    half the angle."""
    m, R, about_center, middle = sizes
    sine, cosine = ends
    tensor: Components = ()
    if names.space:
        uneven = divide(2 * sine * cosine, angle)  # sin(2 beta)/(2 beta)
        flat = tuple(half(about_center) * (ONE + sign * uneven) for sign in (-1, 1))
        about = (*flat, about_center, ZERO, ZERO, ZERO)
        tensor = moved(about, m, (middle, ZERO, ZERO), sign=-1)
    rim = tuple(
        (R * Call("cos", share * half(angle)), R * Call("sin", share * half(angle)))
        for share in (divide(number(k), number(_N_SIDES // 2)) for k in range(-_N_SIDES // 2, _N_SIDES // 2 + 1))
    )
    return Build(
        m,
        about_center - m * square(middle),
        (middle, ZERO),
        {
            "start": (R * cosine, -(R * sine)),
            "middle": (R, ZERO),
            "end": (R * cosine, R * sine),
        },
        radius=R,
        edges=(Edge(rim, "wire") if is_wire else Edge(((ZERO, ZERO), *rim)),),
        tensor=tensor,
        solid=PLATE,
    )
