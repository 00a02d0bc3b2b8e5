"""Shapes: mass centres and moments of inertia, by putting parts together and by adding up thin slices."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

import numpy as np
import pytest

import freebody as fb
from freebody.language.expression import evaluate
from freebody.model.shapes.base import Shape

Tensor = np.ndarray[tuple[int, int], np.dtype[np.float64]]
KINDS = sorted(k for k, c in Shape.kinds.items() if c.__module__.startswith("freebody."))


def body(shape: str, *, space: bool = True) -> tuple[float, Tensor, Tensor]:
    """Mass, mass centre from the reference point and the tensor about the mass centre of a shape in numbers."""
    system = fb.System.from_text(f"{'space: true' if space else ''}\nbodies: {{b: {{{shape}}}}}\n")
    it = system.bodies["b"]

    def numbers(values: tuple[object, ...]) -> list[float]:
        return [float(evaluate(value, {})) for value in values]  # type: ignore[arg-type]

    middle = -np.array(numbers(it.center.offset))
    if not space:
        return numbers((it.mass,))[0], middle, np.array([[numbers((it.inertia,))[0]]])
    xx, yy, zz, xy, xz, yz = numbers(it.tensor) or [0.0] * 6  # a particle
    return numbers((it.mass,))[0], middle, np.array([(xx, xy, xz), (xy, yy, yz), (xz, yz, zz)])


def same(first: str, second: str) -> None:
    for a, b in zip(body(first), body(second), strict=True):
        assert np.asarray(a) == pytest.approx(np.asarray(b), abs=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_a_shape_is_the_same_in_the_plane_and_in_space(kind: str) -> None:
    it = Shape.kinds[kind]
    if it.space_only or it.needs_file:
        return
    flat, solid = (body(f"{kind}: {it.example}", space=space) for space in (False, True))
    assert flat[0] == solid[0]
    assert flat[1] == pytest.approx(solid[1][:2])
    assert flat[2][0, 0] == pytest.approx(solid[2][2, 2])


# -- parts put together -----------------------------------------------------------------------
def test_two_half_disks_are_a_disk_and_two_half_rings_a_ring() -> None:
    for half, whole in (("half_disk", "disk"), ("half_ring", "ring")):
        part = f"{half}: {{mass: 1 kg, radius: 0.3 m}}"
        same(
            f"composite: {{parts: {{a: {{{part}}}, b: {{{part}, turned: 180 deg about z}}}}}}",
            f"{whole}: {{mass: 2 kg, radius: 0.3 m}}",
        )


@pytest.mark.parametrize(("kind", "whole"), [("sector", "disk"), ("arc", "ring")])
@pytest.mark.parametrize("n", [3, 4])
def test_n_equal_parts_of_a_circle_are_the_circle(kind: str, whole: str, n: int) -> None:
    part = f"{kind}: {{mass: 1 kg, radius: 0.3 m, angle: {360 // n} deg}}"
    parts = ", ".join(f"p{k}: {{{part}, turned: {k * 360 // n} deg about z}}" for k in range(n))
    same(f"composite: {{parts: {{{parts}}}}}", f"{whole}: {{mass: {n} kg, radius: 0.3 m}}")


@pytest.mark.parametrize(("way", "x"), [("right", 1), ("left", -1)])
def test_a_wedge_is_the_triangle_of_its_corners(way: str, x: int) -> None:
    h = 0.4 * math.tan(math.radians(30))
    wedge = f"wedge: {{mass: 2 kg, angle: 30 deg, length: 0.4 m, rises: {way}}}"
    place = f"[{-x * 0.8 / 3!r}, {-h / 3!r}, 0]"
    triangle = f"polygon: {{mass: 2 kg, corners: [[0, 0], [{0.4 * x}, 0], [{0.4 * x}, {h!r}]]}}"
    # the polygon counts from its toe
    same(f"composite: {{parts: {{it: {{{wedge}}}}}}}", f"composite: {{parts: {{it: {{{triangle}, at: {place}}}}}}}")
    same(wedge, wedge.replace("length: 0.4 m", f"height: {h!r}"))


def test_a_length_that_another_field_says_is_not_left_open() -> None:
    system = fb.System.from_text("""
bodies: {slope: {wedge: {mass: 1 kg, angle: 30 deg, height: 0.3 m}}, wheel: {gear: {teeth: 20, module: 3 mm}}}
measures: {y: height of slope.top above slope.heel}
""")
    assert not system.unspecified


@pytest.mark.parametrize(
    ("wedge", "told"),
    [
        ("mass: 2 kg, angle: 95 deg", "between 0 and 90 deg"),
        ("mass: 2 kg, angle: 30 deg, length: 1 m, height: 1 m", "leave out one of the three"),
    ],
)
def test_what_is_no_wedge_is_told(wedge: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(f"bodies: {{it: {{wedge: {{{wedge}}}}}}}")


def test_a_cylinder_rolls_on_a_wedge_that_moves_aside_either_way() -> None:
    """(m + M) x'' = m s'' cos, 3/2 s'' = x'' cos + g sin."""
    m, M, g, a = 2.0, 5.0, 9.81, math.radians(30)
    expected = m * g * math.sin(2 * a) / (3 * (m + M) - 2 * m * math.cos(a) ** 2)
    for way, sign in (("right", 1), ("left", -1)):
        system = fb.System.from_text(f"""
bodies:
  wedge: {{wedge: {{mass: {M} kg, angle: 30 deg, rises: {way}}}}}
  roller: {{disk: {{mass: {m} kg, radius: 0.1 m}}}}
connections:
  floor: {{slider: {{body: wedge, along: right}}}}
  slope: {{rolling: {{body: roller, on: wedge.face}}}}
loads: {{weight: {{gravity: {g} m/s^2}}}}
questions: {{it: acceleration of wedge along right}}
""")
        assert system.solve()["it"].value == pytest.approx(sign * expected, rel=1e-12)


def test_a_half_disk_is_a_sector_of_180_degrees() -> None:
    same("half_disk: {mass: 2 kg, radius: 0.3 m}", "sector: {mass: 2 kg, radius: 0.3 m, angle: 180 deg}")
    same("half_ring: {mass: 2 kg, radius: 0.3 m}", "arc: {mass: 2 kg, radius: 0.3 m, angle: 180 deg}")


def test_two_hemispheres_are_a_ball() -> None:
    for half, whole in (("hemisphere", "sphere"), ("hemispherical_shell", "spherical_shell")):
        part = f"{half}: {{mass: 1 kg, radius: 0.3 m}}"
        same(
            f"composite: {{parts: {{a: {{{part}}}, b: {{{part}, turned: 180 deg about z}}}}}}",
            f"{whole}: {{mass: 2 kg, radius: 0.3 m}}",
        )


def test_hollow_shapes_are_full_ones_with_a_hole() -> None:
    # of equal density: m/M = (r/R)^2, (r/R)^3; here r = R/2
    same(
        "annulus: {mass: 3 kg, radius: 0.2 m, inner_radius: 0.1 m}",
        "composite: {parts: {a: {disk: {mass: 4 kg, radius: 0.2 m}}}, holes: {b: {disk: {mass: 1 kg, radius: 0.1 m}}}}",
    )
    same(
        "hollow_sphere: {mass: 7 kg, radius: 0.2 m, inner_radius: 0.1 m}",
        "composite: {parts: {a: {sphere: {mass: 8 kg, radius: 0.2 m}}}, "
        "holes: {b: {sphere: {mass: 1 kg, radius: 0.1 m}}}}",
    )
    same(
        "hollow_cylinder: {mass: 3 kg, radius: 0.2 m, inner_radius: 0.1 m, length: 0.5 m}",
        "composite: {parts: {a: {cylinder: {mass: 4 kg, radius: 0.2 m, length: 0.5 m}}}, "
        "holes: {b: {cylinder: {mass: 1 kg, radius: 0.1 m, length: 0.5 m}}}}",
    )


def test_a_frustum_is_a_cone_without_its_tip() -> None:
    # a cone of height 2 h and radius R loses its upper half: masses 8 to 1; the cone grows from its apex, 2 h above the
    # base, downwards
    same(
        "frustum: {mass: 7 kg, radius: 0.2 m, top_radius: 0.1 m, height: 0.3 m}",
        "composite: {parts: {a: {cone: {mass: 8 kg, radius: 0.2 m, height: 0.6 m, axis: -z}, at: [0, 0, 0.6 m]}}, "
        "holes: {b: {cone: {mass: 1 kg, radius: 0.1 m, height: 0.3 m, axis: -z}, at: [0, 0, 0.6 m]}}}",
    )


def test_thin_walls_are_the_limits_of_thick_ones() -> None:
    same("annulus: {mass: 2 kg, radius: 0.3 m, inner_radius: 0.3 m}", "ring: {mass: 2 kg, radius: 0.3 m}")
    same(
        "hollow_sphere: {mass: 2 kg, radius: 0.3 m, inner_radius: 0.3 m}",
        "spherical_shell: {mass: 2 kg, radius: 0.3 m}",
    )
    same(
        "frustum: {mass: 2 kg, radius: 0.3 m, top_radius: 0.3 m, height: 0.4 m}",
        "composite: {parts: {a: {cylinder: {mass: 2 kg, radius: 0.3 m, length: 0.4 m}, at: [0, 0, 0.2 m]}}}",
    )


# -- thin slices ------------------------------------------------------------------------------
def test_a_hemisphere_is_the_sum_of_its_slices() -> None:
    # slices of radius sqrt(1 - x^2) across x: dm ~ (1 - x^2) dx, each a disk
    x, weights = np.polynomial.legendre.leggauss(20)
    x, weights = (x + 1) / 2, weights / 2
    dm = weights * (1 - x**2) / float(weights @ (1 - x**2))
    middle = float(dm @ x)
    mass, center, tensor = body("hemisphere: {mass: 1 kg, radius: 1 m}")
    assert mass == 1.0
    assert center[0] == pytest.approx(middle)
    assert tensor[0, 0] == pytest.approx(float(dm @ (1 - x**2)) / 2)
    assert tensor[1, 1] == pytest.approx(float(dm @ ((1 - x**2) / 4 + (x - middle) ** 2)))


# -- textbook motions -------------------------------------------------------------------------
ROCKING = """
parameters: {{m: 2 kg, R: 0.3 m, g: 9.81 m/s^2}}
ground: {{lines: {{floor: {{along: right}}}}}}
bodies: {{b: {{{shape}: {{mass: m, radius: R}}}}}}
connections: {{contact: {{rolling: {{body: b, on: floor}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{phi: angle of b from down}}
start: {{phi: 0}}
questions: {{period: period of small oscillations}}
"""


@pytest.mark.parametrize(
    ("shape", "period"),
    [
        # (I_G + m (R - c)^2) phi'' = -m g c phi; 3/2 - 8/(3 pi) over 4/(3 pi); Meriam & Kraige, Dynamics, ch. 8
        ("half_disk", "2*pi*sqrt(R*(9*pi - 16)/(8*g))"),
        ("half_ring", "2*pi*sqrt(R*(pi - 2)/g)"),
        # 83/320 + 25/64 = 13/20 over 3/8
        ("hemisphere", "2*pi*sqrt(26*R/(15*g))"),
        # 5/12 + 1/4 = 2/3 over 1/2
        ("hemispherical_shell", "2*pi*sqrt(4*R/(3*g))"),
    ],
)
def test_half_a_circle_rocks_with_the_period_of_the_textbook(
    shape: str, period: str, agrees: Callable[[fb.Solution, str, str], None]
) -> None:
    agrees(fb.System.from_text(ROCKING.format(shape=shape)).solve(), "period", period)


def test_what_rolls_with_its_round_side_says_so() -> None:
    system = fb.System.from_text(ROCKING.format(shape="half_disk"))
    assert [str(text) for text in system.assumptions] == ["contact: b touches with its round side"]


@pytest.mark.parametrize(
    ("shape", "told"),
    [
        ("annulus: {mass: 1 kg, radius: 0.1 m, inner_radius: 0.2 m}", "it is at most 0.1 m"),
        ("sector: {mass: 1 kg, radius: 0.1 m, angle: 400 deg}", "between 0 and 360 deg"),
        (
            "composite: {parts: {a: {particle: {mass: 1 kg}}}, holes: {b: {particle: {mass: 3 kg}}}}",
            "the holes weigh 2 kg more than the parts",
        ),
        ("composite: {parts: {a: {particle: {mass: 1 kg}}}, holes: {a: {particle: {mass: 1 kg}}}}", "there already"),
    ],
)
def test_impossible_shapes_are_refused_with_what_would_do(shape: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        body(shape, space=False)


def test_a_contact_of_half_a_circle_with_another_circle_is_refused() -> None:
    with pytest.raises(fb.ModelError, match="let it roll with its rim"):
        fb.System.from_text(
            "bodies: {a: {disk: {mass: 1 kg, radius: 1 m}}, b: {half_disk: {mass: 1 kg, radius: 1 m}}}\n"
            "connections: {c: {contact: {between: [b, a]}}}"
        )


@pytest.mark.parametrize("space", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_every_shape_is_drawn(kind: str, space: bool) -> None:
    it = Shape.kinds[kind]
    if (it.space_only and not space) or it.needs_file:  # of triangles: test_meshes
        return
    system = fb.System.from_text(f"{'space: true' if space else ''}\nbodies: {{b: {{{kind}: {it.example}}}}}\n")
    assert "nan" not in (svg := system.picture().svg())
    assert "<path" in svg or "<circle" in svg


def test_a_hole_is_drawn_on_what_it_is_cut_from() -> None:
    plain = "composite: {parts: {a: {disk: {mass: 4 kg, radius: 0.2 m}}}"
    pictures = [
        fb.System.from_text(f"bodies: {{b: {{{shape}}}}}").picture()
        for shape in (plain + "}", plain + ", holes: {b: {disk: {mass: 1 kg, radius: 0.1 m}}}}")
    ]
    widths = [
        sorted(round(float(np.ptp(s.points[:, 0])), 6) for s in picture.shapes if s.is_closed and len(s.points) > 40)
        for picture in pictures
    ]
    assert len(widths[1]) == len(widths[0]) + 1
    assert widths[1][0] == pytest.approx(widths[1][-1] / 2)
    assert math.isfinite(widths[1][0])


def test_signs_and_letters_are_as_large_beside_a_disk_with_a_hole_as_beside_a_full_one() -> None:
    full = "disk: {mass: 1 kg, radius: 0.3 m}"
    hole = "hole: {disk: {mass: 0.1 kg, radius: 0.1 m}, at: [0.1 m, 0]}"

    def widest(body: str) -> float:
        text = fb.System.from_text(f"bodies: {{it: {{{body}}}}}").draw().svg()
        found = re.search(r"viewBox=\"0 0 ([0-9.]+)", text)
        assert found is not None
        return float(found[1])

    cut = f"composite: {{parts: {{full: {{{full}}}}}, holes: {{{hole}}}}}"
    assert widest(cut) == pytest.approx(widest(full), rel=0.3)
