"""Bodies from files of triangles: mass properties, contact by the hull, and files that are refused."""

import math
import struct
import sys
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import freebody as fb
from freebody.language.expression import evaluate
from freebody.model.meshes import MOST_DRAWN
from freebody.model.silhouettes import is_hole, silhouette
from freebody.numeric.engine.course import Status
from freebody.present.space.meshes import is_on_hull, mesh_hull, surface

pytest.importorskip("trimesh")

Corners = list[tuple[float, float, float]]
Triangles = list[tuple[int, int, int]]


def ascii_stl(corners: Corners, triangles: Triangles) -> str:
    facets = "".join(
        "facet normal 0 0 0\n outer loop\n"
        + "".join("  vertex {!r} {!r} {!r}\n".format(*corners[k]) for k in each)
        + " endloop\nendfacet\n"
        for each in triangles
    )
    return f"solid it\n{facets}endsolid it\n"


def binary_stl(corners: Corners, triangles: Triangles) -> bytes:
    head = b"\0" * 80 + struct.pack("<I", len(triangles))
    return head + b"".join(
        struct.pack("<12fH", 0.0, 0.0, 0.0, *(c for k in each for c in corners[k]), 0) for each in triangles
    )


def box(a: float, b: float, c: float, at: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> tuple[Corners, Triangles]:
    """With a corner at `at`."""
    corners = [(at[0] + a * i, at[1] + b * j, at[2] + c * k) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return corners, [t for p, q, r, s in quads for t in ((p, q, r), (p, r, s))]


TETRAHEDRON: tuple[Corners, Triangles] = (
    [(0.0, 0.0, 0.0), (30.0, 0.0, 0.0), (0.0, 40.0, 0.0), (0.0, 0.0, 50.0)],
    [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)],
)


def icosphere(radius: float, n_halvings: int) -> tuple[Corners, Triangles]:
    """The octahedron, each of its triangles in four again and again, its corners put on the sphere."""
    corners = [np.array(c, float) for c in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))]
    triangles = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(n_halvings):
        middles: dict[tuple[int, int], int] = {}

        def middle(i: int, j: int, middles: dict[tuple[int, int], int] = middles) -> int:
            key = min(i, j), max(i, j)
            if key not in middles:
                half = corners[i] + corners[j]
                corners.append(half / np.linalg.norm(half))
                middles[key] = len(corners) - 1
            return middles[key]

        halved: Triangles = []
        for a, b, c in triangles:
            d, e, f = middle(a, b), middle(b, c), middle(c, a)
            halved += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        triangles = halved
    return [(float(x), float(y), float(z)) for x, y, z in (radius * c for c in corners)], triangles


# an L from the side, 60 mm by 60 mm with arms of 20 mm, 30 mm thick
_L = [(0.0, 0.0), (60.0, 0.0), (60.0, 20.0), (20.0, 20.0), (20.0, 60.0), (0.0, 60.0)]
BRACKET: tuple[Corners, Triangles] = (
    [(x, y, z) for z in (0.0, 30.0) for x, y in _L],
    [t for a, b, c in ((0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)) for t in ((a, c, b), (a + 6, b + 6, c + 6))]
    + [t for k in range(6) for j in [(k + 1) % 6] for t in ((k, j, j + 6), (k, j + 6, k + 6))],
)


def model(folder: Path, fields: str, rest: str = "", more: str = "") -> fb.System:
    path = folder / "model.yaml"
    path.write_text(f"space: true\nbodies:\n  part:\n    mesh: {{{fields}}}\n{more}{rest}", "utf-8")
    return fb.System.load(path)


def properties(system: fb.System) -> tuple[float, np.ndarray, np.ndarray]:
    """[kg], [m] of the mass centre from the origin of the file, [kg m^2] xx, yy, zz, xy, xz, yz."""
    part = system.bodies["part"]

    def numbers(exprs: tuple[object, ...]) -> np.ndarray:
        return np.array([evaluate(expr, {}) for expr in exprs])  # type: ignore[arg-type]

    return float(evaluate(part.mass, {})), -numbers(part.points["origin"]), numbers(part.tensor)


# -- mass properties --------------------------------------------------------------------------


def test_a_box_has_the_mass_centre_and_moments_of_a_box(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*box(200.0, 100.0, 50.0)))
    mass, middle, tensor = properties(model(tmp_path, "file: part.stl, unit: mm, mass: 3 kg"))
    a, b, c = 0.2, 0.1, 0.05
    exact = [3 / 12 * (b * b + c * c), 3 / 12 * (a * a + c * c), 3 / 12 * (a * a + b * b), 0.0, 0.0, 0.0]
    assert mass == 3.0
    assert middle == pytest.approx([0.1, 0.05, 0.025], rel=1e-12)
    assert tensor == pytest.approx(exact, rel=1e-12, abs=0.0)


def test_a_tetrahedron_is_the_convex_body_of_its_corners(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*TETRAHEDRON))
    mass, middle, tensor = properties(model(tmp_path, "file: part.stl, unit: mm, mass: 3 kg"))
    same = fb.System.from_text(
        "space: true\nbodies: {part: {convex: {mass: 3 kg, points: "
        "[[0, 0, 0], [30 mm, 0, 0], [0, 40 mm, 0], [0, 0, 50 mm]]}}}\n"
    )
    mass_, middle_, tensor_ = properties(same)
    assert (mass, middle, tensor) == (mass_, pytest.approx(middle_, rel=1e-12), pytest.approx(tensor_, rel=1e-12))
    # by hand: r_G = (a, b, c)/4, I_xy = -(-m a b/80) with the minus of products: m a b/80 = +a b/16 - a b/20
    assert tensor[3] == pytest.approx(3 * 0.03 * 0.04 / 80, rel=1e-12)


def test_a_sphere_of_ever_finer_triangles_tends_to_two_fifths_of_m_r_squared(tmp_path: Path) -> None:
    """Its corners are on the sphere, so that what is missing falls by four as the triangles are halved."""
    missing: list[float] = []
    for n in (2, 3, 4):
        (tmp_path / "part.stl").write_bytes(binary_stl(*icosphere(100.0, n)))
        mass, middle, tensor = properties(model(tmp_path, "file: part.stl, unit: mm, density: 1000 kg/m^3"))
        assert middle == pytest.approx([0.0] * 3, abs=1e-9)
        assert tensor[:3] == pytest.approx([tensor[0]] * 3, rel=1e-6)
        missing.append(1.0 - tensor[0] / (0.4 * mass * 0.01))
        assert mass < 1000 * 4 / 3 * math.pi * 1e-3
    assert missing[0] < 0.08
    assert [a / b for a, b in pairwise(missing)] == pytest.approx([4.0, 4.0], rel=0.08)


def test_where_the_file_has_its_origin_does_not_matter(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*box(2.0, 1.0, 0.5, at=(4000.0, -8000.0, 16000.0))))
    _mass, middle, tensor = properties(model(tmp_path, "file: part.stl, unit: cm, mass: 12 kg"))
    assert middle == pytest.approx([40.01, -79.995, 160.0025], rel=1e-12)
    assert tensor == pytest.approx([1.25e-4, 4.25e-4, 5e-4, 0, 0, 0], rel=1e-10, abs=0.0)


@pytest.mark.parametrize(("unit", "size"), [("mm", 1e-3), ("cm", 1e-2), ("m", 1.0), ("in", 0.0254), ("um", 1e-6)])
def test_the_unit_scales_volume_and_moments(unit: str, size: float, tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*box(3.0, 2.0, 1.0)))
    mass, _middle, tensor = properties(model(tmp_path, f"file: part.stl, unit: {unit}, density: 7850 kg/m^3"))
    assert mass == pytest.approx(7850 * 6 * size**3, rel=1e-12)
    assert tensor[2] == pytest.approx(mass * 13 / 12 * size**2, rel=1e-12)


def test_an_l_is_two_boxes(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*BRACKET))
    system = model(tmp_path, "file: part.stl, unit: mm, density: 1000 kg/m^3")
    same = fb.System.from_text(
        "space: true\nbodies: {part: {composite: {parts: {"
        "foot: {box: {mass: 0.036 kg, size: [60 mm, 20 mm, 30 mm]}, at: [30 mm, 10 mm, 15 mm]}, "
        "arm: {box: {mass: 0.024 kg, size: [20 mm, 40 mm, 30 mm]}, at: [10 mm, 40 mm, 15 mm]}}}}}\n"
    )
    for mine, other in zip(properties(system), properties(same), strict=True):
        assert mine == pytest.approx(other, rel=1e-12)


def test_mass_and_density_may_be_symbols(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*box(200.0, 100.0, 50.0)))
    rest = "parameters: {rho: 2 g/cm^3, w: 3 rad/s}\nquestions: {T: kinetic energy at start}\n"
    system = model(tmp_path, "file: part.stl, unit: mm, density: rho", rest, "    angular_velocity: [0, 0, w]\n")
    # T = I_zz w^2/2 = rho V (a^2 + b^2) w^2/24
    assert system.solve().answers[0].value == pytest.approx(2000 * 1e-3 * 0.05 * 9 / 24, rel=1e-12)


# -- motion and contact -----------------------------------------------------------------------


def test_free_rotation_keeps_energy_and_angular_momentum(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*BRACKET))
    more = "    at: [0, 0, 0]\n    angular_velocity: [1, 5, 2]\n"
    system = model(tmp_path, "file: part.stl, unit: mm, mass: 2 kg", "", more)
    course = system.simulate(5.0).course
    assert course.status is Status.FINISHED
    assert course.rotation is not None
    xx, yy, zz, xy, xz, yz = properties(system)[2]
    tensor = np.array([(xx, xy, xz), (xy, yy, yz), (xz, yz, zz)])
    rates = course.rotation.velocities[:, 0]
    axes = Rotation.from_quat(np.roll(course.rotation.quaternions[:, 0], -1, axis=1)).as_matrix()
    momenta = np.einsum("tij,jk,tlk,tl->ti", axes, tensor, axes, rates)  # R I R^T w
    energies = 0.5 * np.einsum("ti,ti->t", momenta, rates)
    assert momenta == pytest.approx(np.tile(tensor @ [1, 5, 2], (len(momenta), 1)), rel=1e-7)
    assert energies == pytest.approx(np.full(len(energies), 0.5 * np.array([1, 5, 2]) @ tensor @ [1, 5, 2]), rel=1e-7)
    assert float(np.ptp(rates[:, 0])) > 0.5  # it tumbles


SLOPE = """
parameters: {alpha: 15 deg, mu: 0.5, g: 9.81 m/s^2}
ground: {planes: {slope: {normal: [-sin(alpha), cos(alpha), 0]}}}
connections: {contact: {contact: {between: [part, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}}
questions: [least mu so that it stays at rest]
"""
ON_SLOPE = "    at: {origin: [0, 0, 0]}\n    turned: alpha about z\n"


def test_a_cube_that_hangs_by_an_edge_has_simple_fractions_in_its_formula(tmp_path: Path) -> None:
    # I = m (1 + 1)/12 + m/2 = 2 m/3 about the edge, at the arm 1/2: phi'' = -(g/2)/(2/3) = -3 g/4
    corners, triangles = box(1.0, 1.0, 1.0)
    (tmp_path / "part.stl").write_text(ascii_stl(corners, triangles))
    text = """
space: {up: z}
parameters: {rho: 1000 kg/m^3, g: 9.81 m/s^2}
bodies: {cube: {mesh: {file: part.stl, unit: m, density: rho}}}
connections: {a: {revolute: {first: ground.O, second: cube, about: x}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of cube about x}
start: {phi: 0}
questions: [acceleration of phi at start]
"""
    (tmp_path / "cube.yaml").write_text(text)
    answer = fb.System.load(tmp_path / "cube.yaml").solve()["q1"]
    assert answer.expression is not None
    assert evaluate(answer.expression, {"g": Fraction(1)}) == Fraction(-3, 4)


def test_a_cube_of_triangles_holds_on_a_slope_as_a_box_does(tmp_path: Path) -> None:
    """mu = tan(alpha)."""
    (tmp_path / "part.stl").write_text(ascii_stl(*box(100.0, 100.0, 100.0)))
    told = model(tmp_path, "file: part.stl, unit: mm, mass: 2 kg", SLOPE, ON_SLOPE)
    same = fb.System.from_text(
        "space: true\nbodies:\n  part:\n    box: {mass: 2 kg, size: [a, a, a]}\n"
        "    at: [a/2*cos(alpha) - a/2*sin(alpha), a/2*sin(alpha) + a/2*cos(alpha), 0]\n    turned: alpha about z\n"
        + SLOPE.replace("parameters: {", "parameters: {a: 10 cm, ")
    )
    first, second = (system.solve().answers for system in (told, same))
    assert first[0].value == pytest.approx(math.tan(math.radians(15)), rel=1e-12)
    assert first[0].value == pytest.approx(second[0].value, rel=1e-12)
    assert not [line for line in told.assumptions if "hull" in line]


PLANE = """
ground: {planes: {floor: {normal: [0, 1, 0]}}}
connections: {contact: {contact: {between: [part, ground.floor], friction: 0.5}}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""


def test_of_a_body_with_hollows_the_hull_touches_and_this_is_told(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*BRACKET))
    system = model(tmp_path, "file: part.stl, unit: mm, mass: 2 kg", PLANE, "    at: {origin: [0, 0, 0]}\n")
    assert [line for line in system.assumptions if "part is not convex: in contacts its convex hull touches" in line]
    assert len({row.row.name for row in system.bounds}) == 10  # the inner corner of each side is not on the hull


def test_a_hull_with_many_corners_touches_nothing(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_bytes(binary_stl(*icosphere(100.0, 2)))
    with pytest.raises(fb.ModelError, match=r"its convex hull has more than 40 corners\. Weld a simpler body"):
        model(tmp_path, "file: part.stl, unit: mm, mass: 2 kg", PLANE, "    at: [0, 0.1 m, 0]\n")


# -- files that are refused -------------------------------------------------------------------


def cube_without(n: int) -> str:
    corners, triangles = box(1.0, 1.0, 1.0)
    return ascii_stl(corners, triangles[n:])


def turned(which: slice) -> str:
    corners, triangles = box(1.0, 1.0, 1.0)
    triangles[which] = [(a, c, b) for a, b, c in triangles[which]]
    return ascii_stl(corners, triangles)


FLAT: Triangles = [(0, 1, 2), (0, 2, 1)]
BROKEN = {
    "no file": ("part.stl", None, r"there is no file part\.stl in the folder of the model"),
    "no format": ("part.step", "solid", r"part\.step: a mesh is one of \.stl, \.obj, \.ply, \.off"),
    "no mesh": ("part.stl", "this is no mesh", r"part\.stl"),
    "nothing": ("part.stl", "", r"part\.stl"),
    "cut off": ("part.stl", ascii_stl(*box(1.0, 1.0, 1.0))[:-300], r"part\.stl"),
    "no number": ("part.stl", ascii_stl(*box(1.0, 1.0, 1.0)).replace("1.0 1.0 1.0", "1.0 nan 1.0"), r"part\.stl"),
    "no triangles": ("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", r"part\.obj"),
    "open": ("part.stl", cube_without(1), r"not closed: 3 edges belong to one triangle alone, .* from \(0, .* to \("),
    "one turned": (
        "part.stl",
        turned(slice(4, 5)),
        r"go round in different senses, 3 times; .* along the edge from \(",
    ),
    "all turned": (
        "part.stl",
        turned(slice(None)),
        r"so its volume is negative: turn the order of their corners round",
    ),
    "flat": ("part.stl", ascii_stl([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)], FLAT), r"it has no volume"),
    "a point": ("part.stl", ascii_stl([(1.0, 1.0, 1.0)] * 3, FLAT), r"all its triangles are at one point"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_file_that_is_no_closed_surface_is_refused_with_the_reason(name: str, tmp_path: Path) -> None:
    file, text, told = BROKEN[name]
    if text is not None:
        (tmp_path / file).write_text(text, "utf-8")
    with pytest.raises(fb.ModelError, match=told) as refused:
        model(tmp_path, f"file: {file}, unit: mm, mass: 1 kg")
    assert "model.yaml" in str(refused.value)


@pytest.mark.parametrize(
    ("fields", "told"),
    [
        ("file: part.stl, mass: 1 kg", r"part\.stl does not say in which unit it is: write e\.g\. unit: mm"),
        ("file: part.stl, unit: kg, mass: 1 kg", r"kg is no unit of length"),
        ("file: part.stl, unit: parrots, mass: 1 kg", r"parrots"),
        ("file: part.stl, unit: mm", r"either a mass or a density"),
        ("file: part.stl, unit: mm, mass: 1 kg, density: 1 kg/m^3", r"either a mass or a density"),
        ("file: part.stl, unit: mm, mass: -1 kg", r"mass is negative"),
        ("file: ../part.stl, unit: mm, mass: 1 kg", r"not in the folder of the model"),
        ("unit: mm, mass: 1 kg", r"file"),
    ],
)
def test_fields_that_are_missing_or_wrong_are_refused(fields: str, told: str, tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*box(1.0, 1.0, 1.0)))
    with pytest.raises(fb.ModelError, match=told):
        model(tmp_path, fields)


# -- in the plane -----------------------------------------------------------------------------
ROD = Path(__file__).parents[1] / "examples" / "connecting_rod.obj"
Polygon = list[tuple[float, float]]


def in_the_plane(folder: Path, fields: str) -> fb.System:
    path = folder / "model.yaml"
    path.write_text(f"bodies:\n  part:\n    mesh: {{{fields}}}\n", "utf-8")
    return fb.System.load(path)


def moments(loop: Polygon) -> np.ndarray:
    """Area, its moments of the first order, and the polar one, of a polygon about the origin (Green)."""
    total = np.zeros(4)
    for (x, y), (u, v) in pairwise([*loop, loop[0]]):
        cross = x * v - u * y
        total += cross * np.array(
            [1 / 2, (x + u) / 6, (y + v) / 6, (x * x + x * u + u * u + y * y + y * v + v * v) / 12]
        )
    return total


@pytest.mark.parametrize(("normal", "k"), [("", 2), (", normal: x", 0), (", normal: y", 1), (", normal: z", 2)])
def test_in_the_plane_its_moment_is_that_about_the_normal(normal: str, k: int, tmp_path: Path) -> None:
    """A box: m (a^2 + b^2)/12 of the two sides in the plane, and its outline is a rectangle of them."""
    sides = (200.0, 100.0, 50.0)
    (tmp_path / "part.stl").write_text(ascii_stl(*box(*sides)))
    part = in_the_plane(tmp_path, f"file: part.stl, unit: mm, mass: 3 kg{normal}").bodies["part"]
    a, b = sides[(k + 1) % 3] / 1000, sides[(k + 2) % 3] / 1000
    assert evaluate(part.inertia, {}) == pytest.approx(3 / 12 * (a * a + b * b), rel=1e-12)
    assert [-evaluate(c, {}) for c in part.points["origin"]] == pytest.approx([a / 2, b / 2], rel=1e-12)
    assert len(part.corners) == 4
    (edge,) = part.edges
    assert edge.look == "area"
    assert len(edge.places) == 4


def test_a_connecting_rod_swings_with_the_moment_of_its_polygons() -> None:
    """Area, centre and polar moment of the outline less those of its bores, by Green; T = 2 pi sqrt(I_A/(m g l))."""
    vertices = [line.split()[1:] for line in ROD.read_text().splitlines() if line.startswith("v ")]
    flat = [(float(x) / 1000, float(y) / 1000) for x, y, z in vertices if float(z) < 0]
    found = moments(flat[:34]) + moments(flat[34:54]) + moments(flat[54:])  # bores go round clockwise
    centre = found[1:3] / found[0]
    about_centre = found[3] / found[0] - centre @ centre
    system = fb.System.load(ROD.with_name("swinging_connecting_rod.yaml"))
    rod, rho = system.bodies["rod"], {"rho": 7850.0}
    assert evaluate(rod.mass, rho) == pytest.approx(7850.0 * 0.016 * found[0], rel=1e-9)
    assert evaluate(rod.inertia, rho) / evaluate(rod.mass, rho) == pytest.approx(about_centre, rel=1e-9)
    assert [edge.look for edge in rod.edges].count("hole") == 2
    solution, arm = system.solve(), 0.161 - centre[0]
    square = about_centre + arm**2
    assert solution["period"].value == pytest.approx(2 * math.pi * math.sqrt(square / (9.81 * arm)), rel=1e-8)
    swing = -9.81 * arm / square * math.cos(math.radians(100 - 180))
    assert solution["swing"].value == pytest.approx(swing, rel=1e-8)


def test_a_pocket_is_no_hole_and_a_bore_is_one() -> None:
    """A plate of 8 by 8 with a bore of 2 by 2; and one with a pocket, whose floor is covered."""
    ring = [(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0), (3.0, 3.0), (5.0, 3.0), (5.0, 5.0), (3.0, 5.0)]
    frame = [(k, (k + 1) % 4, 4 + (k + 1) % 4) for k in range(4)] + [(k, 4 + (k + 1) % 4, 4 + k) for k in range(4)]
    top = [(x, y, 1.0) for x, y in ring]
    bored = silhouette(top, frame)
    assert [is_hole([ring[k] for k in loop]) for loop in bored] == [False, True]
    floor = [(x, y, 0.5) for x, y in ring[4:]]
    pocket = silhouette([*top, *floor], [*frame, (8, 9, 10), (8, 10, 11)])
    assert [sorted(loop) for loop in pocket] == [[0, 1, 2, 3]]


def test_what_leans_out_of_the_plane_says_so(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*TETRAHEDRON))
    system = in_the_plane(tmp_path, "file: part.stl, unit: mm, mass: 1 kg")
    assert any("not alike on both sides of the plane" in str(told) for told in system.assumptions)
    (tmp_path / "part.stl").write_text(ascii_stl(*BRACKET))
    assert not in_the_plane(tmp_path, "file: part.stl, unit: mm, mass: 1 kg").assumptions


def test_a_normal_is_an_axis_and_for_the_plane(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*TETRAHEDRON))
    with pytest.raises(fb.ModelError, match="x, y or z, not up"):
        in_the_plane(tmp_path, "file: part.stl, unit: mm, mass: 1 kg, normal: up")
    with pytest.raises(fb.ModelError, match="for planar models"):
        model(tmp_path, "file: part.stl, unit: mm, mass: 1 kg, normal: y")


def test_a_box_of_triangles_holds_on_a_slope_in_the_plane(tmp_path: Path) -> None:
    """Its outline touches as a rectangle does: least mu = tan(alpha)."""
    (tmp_path / "part.stl").write_text(ascii_stl(*box(200.0, 100.0, 50.0)))
    part = "mesh: {file: part.stl, unit: mm, mass: 3 kg}"
    found = []
    for body in (part, "rectangle: {mass: 3 kg, width: 0.2 m, height: 0.1 m}"):
        (tmp_path / "model.yaml").write_text(SLOPE_IN_THE_PLANE.format(body=body), "utf-8")
        found.append(
            fb.System.load(tmp_path / "model.yaml").solve("least mu so that it stays at rest").answers[0].value
        )
    assert found == pytest.approx([math.tan(math.radians(15))] * 2)


SLOPE_IN_THE_PLANE = """
parameters: {{mu: 0.5}}
ground: {{lines: {{slope: {{through: [0, 0], angle: 15 deg}}}}}}
bodies: {{part: {{{body}, near: {{at: [0, 0.05 m], angle: 15 deg}}}}}}
connections: {{it: {{contact: {{between: [part, slope], friction: mu}}}}}}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
"""


def test_without_trimesh_it_is_said_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "trimesh", None)
    (tmp_path / "part.stl").write_text(ascii_stl(*box(1.5, 1.0, 1.0)))
    with pytest.raises(fb.ModelError, match=r'read by trimesh; pip install "freebody\[mesh\]"'):
        model(tmp_path, "file: part.stl, unit: mm, mass: 1 kg")


@pytest.mark.parametrize("form", ["obj", "ply", "off"])
def test_other_formats_say_the_same(form: str, tmp_path: Path) -> None:
    corners, triangles = BRACKET
    places = "".join("{!r} {!r} {!r}\n".format(*c) for c in corners)
    faces = "".join("3 {} {} {}\n".format(*t) for t in triangles)
    texts = {
        "off": f"OFF\n{len(corners)} {len(triangles)} 0\n{places}{faces}",
        "obj": "".join("v {!r} {!r} {!r}\n".format(*c) for c in corners)
        + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles),
        "ply": f"ply\nformat ascii 1.0\nelement vertex {len(corners)}\nproperty float x\nproperty float y\n"
        f"property float z\nelement face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
        f"{places}{faces}",
    }
    (tmp_path / "part.stl").write_text(ascii_stl(corners, triangles))
    (tmp_path / f"part.{form}").write_text(texts[form])
    first, second = (
        properties(model(tmp_path, f"file: part.{suffix}, unit: mm, mass: 2 kg")) for suffix in ("stl", form)
    )
    for mine, other in zip(first, second, strict=True):
        assert mine == pytest.approx(other, rel=1e-12)


# -- pictures ---------------------------------------------------------------------------------


@pytest.mark.parametrize("of", [box(20.0, 10.0, 5.0), BRACKET, icosphere(10.0, 2), icosphere(10.0, 4)])
def test_it_is_drawn(of: tuple[Corners, Triangles], tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_text(ascii_stl(*of))
    system = model(tmp_path, "file: part.stl, unit: mm, mass: 2 kg")
    assert "nan" not in (svg := system.picture().svg())
    assert "<path" in svg
    assert bool([line for line in system.assumptions if "coarse hull" in line]) == (len(of[1]) > MOST_DRAWN)


def test_edges_between_triangles_of_one_plane_are_not_drawn() -> None:
    def triangles(of: tuple[Corners, Triangles]) -> np.ndarray:
        return np.array([[of[0][k] for k in each] for each in of[1]])

    whole = mesh_hull(triangles(box(2.0, 1.0, 1.0)))
    assert sum(edge.kind == "crease" for edge in whole.edges) == 12
    assert is_on_hull(triangles(icosphere(1.0, 2)))
    assert not is_on_hull(triangles(BRACKET))
    parts = list(surface(triangles(BRACKET)))
    assert sum(len(part.edges) for part in parts) == 2 * 18  # of each of the two triangles at an edge
