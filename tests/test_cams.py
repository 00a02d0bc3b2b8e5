"""Cams: what an eccentric circle does is known, and edges that cannot be cut are refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.narrative.questions import happening
from freebody.numeric.reference import Reference
from freebody.study.answering.solve import solve

EXAMPLES = Path(__file__).parents[1] / "examples"
# an eccentric circle of radius a, its middle e from the axle; it points at the follower where phi = 0
MECHANISM = """
parameters: {{a: 30 mm, e: 8 mm, b: 10 mm, m: 0.5 kg, w: 20 rad/s, g: 9.81 m/s^2}}
bodies:
  disk: {{body: {{inertia: 0.01 kg m^2}}, points: {{E: [e, 0]}}}}
  tappet: {{particle: {{mass: m}}, near: {{at: [0, 0.05 m]}}}}
connections:
  axle: {{pin: [ground.O, disk]}}
  motor: {{driver: {{measure: phi, follows: 0.4 + w*t}}}}
  guide: {{slider: {{body: tappet, along: up}}}}
  it: {cam}
loads: {{weight: {{gravity: g}}}}
measures: {{phi: angle of disk from up, y: height of tappet}}
questions: {{y: y, a: acceleration of y at start, side: normal force of guide at start,
  torque: driving torque of motor at start}}
"""
ROLLER = (
    "{cam: {cam: disk, follower: tappet, base_radius: a, form: roller, roller_radius: b, "
    "lift: e*cos(phi) + sqrt((a + b)^2 - e^2*sin(phi)^2) - a - b}}"
)


def values(cam: str, names: tuple[str, ...] = ("a", "side", "torque")) -> list[float]:
    solution = fb.System.from_text(MECHANISM.format(cam=cam)).solve()
    return [float(solution[name].value or 0.0) for name in names]


@pytest.mark.parametrize(
    ("form", "arm"), [("form: roller, roller_radius: b", "a + b"), ("form: edge", "a")], ids=["roller", "edge"]
)
def test_a_follower_of_an_eccentric_circle_moves_and_is_pushed_as_by_a_rod_from_its_middle(form: str, arm: str) -> None:
    # the middle of the roller is a + b from that of the circle, which is so in polar coordinates of the cam
    lift = f"e*cos(phi) + sqrt(({arm})^2 - e^2*sin(phi)^2) - ({arm})"
    cam = f"{{cam: {{cam: disk, follower: tappet, base_radius: a, {form}, lift: {lift}}}}}"
    found, expected = (
        fb.System.from_text(MECHANISM.format(cam=it)) for it in (cam, f"{{link: [disk.E, tappet, {arm}]}}")
    )
    heights = [system.simulate(0.3, every=0.05).series["y"][0] for system in (found, expected)]
    assert heights[0] == pytest.approx(heights[1], rel=1e-8)
    # a unit of the contact force acts on both bodies as a unit of the force in the rod
    pushes = []
    for system in (found, expected):
        s = Reference(system).snapshot(Reference(expected).assemble(), np.zeros(5))
        (row,) = (row for row in system.constraint_rows if row.connection == "it")
        pushes.append([part for body in ("disk", "tappet") for part in s.gradient(row.measure, body)])
    assert pushes[0] == pytest.approx(pushes[1], abs=1e-9)


def test_a_flat_face_on_an_eccentric_circle_moves_harmonically_and_is_not_pushed_aside() -> None:
    # y = a + e cos(phi), N = m (g + y''), torque N e sin(phi) against the motor
    flat = "{cam: {cam: disk, follower: tappet, base_radius: a, lift: e*cos(phi), along: up}}"
    a, side, torque = values(flat)
    acceleration = -0.008 * 400 * np.cos(0.4)
    assert a == pytest.approx(acceleration)
    assert side == pytest.approx(0.0, abs=1e-12)
    assert torque == pytest.approx(-0.5 * (9.81 + acceleration) * 0.008 * np.sin(0.4))


def test_the_drawn_edge_of_an_eccentric_circle_is_a_circle() -> None:
    for form in (
        "{cam: {cam: disk, follower: tappet, base_radius: a, lift: e*cos(phi), along: up}}",
        ROLLER,
    ):
        system = fb.System.from_text(MECHANISM.format(cam=form))
        closed = [shape.points for shape in system.picture().shapes if len(shape.points) > 100]
        sizes = [np.ptp(points, axis=0) for points in closed]
        assert any(size[0] == pytest.approx(size[1], rel=1e-2) for size in sizes)


@pytest.mark.parametrize(
    ("cam", "told"),
    [
        # r + r'' = 10 mm + 8 mm (1 - cos 2 phi)/1 + 32 mm cos 2 phi is least where cos = -1: 10 + 16 - 32
        (
            "{cam: {cam: disk, follower: tappet, base_radius: 10 mm, lift: e*(1 - cos(2*phi)), along: up}}",
            "undercut: .* -0.006 m. Take a base radius of at least 0.016 m",
        ),
        (
            "{cam: {cam: disk, follower: tappet, base_radius: a, lift: e*(1 - cos(4*phi)), form: roller, "
            "roller_radius: 30 mm}}",
            "undercut: the path",
        ),
        ("{cam: {cam: disk, follower: tappet, base_radius: a, lift: e}}", "a flat face needs its normal"),
        ("{cam: {cam: disk, follower: tappet, base_radius: a, lift: e, form: roller}}", "goes with form: roller"),
        ("{cam: {cam: disk, follower: tappet, base_radius: a, lift: e, form: round}}", "form is one of flat, edge"),
    ],
)
def test_cams_that_cannot_be_are_refused_with_what_would_do(cam: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(MECHANISM.format(cam=cam))


def test_the_pressure_angle_is_that_of_the_line_to_the_middle_of_an_eccentric_circle() -> None:
    # the normal goes through the middle of the circle: sin(alpha) = -e sin(phi)/(a + b), negative where it falls
    guided = MECHANISM.replace("body: tappet, along: up", "body: tappet, along: up, through: ground.O")
    for text, cam in ((MECHANISM, ROLLER), (guided, ROLLER.replace("lift:", "along: up, lift:"))):
        system = fb.System.from_text(text.format(cam=cam))
        reference = Reference(system)
        q = reference.assemble()
        snapshot = reference.snapshot(q, reference.velocities(q))
        found = system.question("pressure angle of it").quantity.value(system, snapshot)
        assert found == pytest.approx(-np.arcsin(0.008 * np.sin(0.4) / 0.04), rel=1e-9)


def test_a_follower_on_a_line_through_the_centre_is_pushed_as_by_the_general_statement() -> None:
    guided = MECHANISM.replace("body: tappet, along: up", "body: tappet, along: up, through: ground.O")
    series = [
        fb.System.from_text(guided.format(cam=cam)).simulate(0.3, every=0.05).recording.series
        for cam in (ROLLER, ROLLER.replace("lift:", "along: up, lift:"))
    ]
    for name in ("y", "y_acceleration", "guide.normal_force", "motor.driving_torque", "it.contact_force"):
        assert series[0][name].values == pytest.approx(series[1][name].values, rel=1e-7, abs=1e-9), name


def test_the_greatest_pressure_angle_of_harmonic_motion_has_a_closed_form() -> None:
    # R + h/2 (1 - cos(phi)) from the centre: tan(alpha) is greatest where cos(phi) = h/2/(R + h/2)
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "cam_with_roller.yaml")
    (answer,) = system.solve("greatest pressure angle of cam over a turn").answers
    h, R = 0.020, 0.050
    assert answer.expression is not None
    assert answer.value == pytest.approx(np.arctan(h / 2 / np.sqrt(R * (R + h))), rel=1e-9)


@pytest.mark.parametrize(
    ("question", "told"),
    [
        ("pressure angle of guide", "is one of cams"),
        ("pressure angle of it", "a flat face"),
        ("pressure angle of x", "no"),
    ],
)
def test_what_has_no_pressure_angle_is_told_so(question: str, told: str) -> None:
    flat = "{cam: {cam: disk, follower: tappet, base_radius: a, lift: e*cos(phi), along: up}}"
    with pytest.raises(fb.FreebodyError, match=told):
        fb.System.from_text(MECHANISM.format(cam=flat)).question(question)


# -- through points ---------------------------------------------------------------------------------
def through(n: int, more: str = "") -> str:
    """A flat-faced cam through n points of the eccentric circle of `MECHANISM`."""
    points = ", ".join(f"[{360 * k / n} deg, {8 * np.cos(2 * np.pi * k / n)} mm]" for k in range(n))
    return f"{{cam: {{cam: disk, follower: tappet, base_radius: a, along: up, points: [{points}]{more}}}}}"


def test_a_cam_through_points_moves_its_follower_along_scipys_spline_turn_after_turn() -> None:
    from scipy.interpolate import CubicSpline

    n = 10
    phi = np.linspace(0.0, 2 * np.pi, n + 1)
    spline = CubicSpline(phi, 0.008 * np.cos(phi), bc_type="periodic")
    motion = fb.System.from_text(MECHANISM.format(cam=through(n))).simulate(0.9, every=0.05)  # nearly three turns
    at = 0.4 + 20 * motion.recording.times
    for order, name in ((0, "y"), (1, "y_rate"), (2, "y_acceleration")):
        expected = spline(at % (2 * np.pi), order) * 20.0**order + (0.03 if order == 0 else 0.0)
        assert motion.recording.series[name].values == pytest.approx(expected, rel=1e-7, abs=1e-7), name
    pushed = 0.5 * (9.81 + spline(at % (2 * np.pi), 2) * 400)
    assert motion.recording.series["it.contact_force"].values == pytest.approx(pushed, rel=1e-7, abs=1e-7)


def test_a_cam_through_many_points_of_a_known_one_is_nearly_that_one() -> None:
    a, side, torque = values(through(72))
    acceleration = -0.008 * 400 * np.cos(0.4)
    assert a == pytest.approx(acceleration, rel=1e-3)
    assert side == pytest.approx(0.0, abs=1e-9)
    assert torque == pytest.approx(-0.5 * (9.81 + acceleration) * 0.008 * np.sin(0.4), rel=1e-3)


def test_a_monotone_curve_does_not_overshoot_beside_a_dwell() -> None:
    dwell = "[[0 deg, 0 mm], [60 deg, 0 mm], [120 deg, 8 mm], [180 deg, 8 mm], [240 deg, 8 mm], [300 deg, 0 mm]]"
    lowest = []
    for curve in ("cubic", "pchip"):
        curved = f"points: {dwell}, through: {curve}"
        cam = f"{{cam: {{cam: disk, follower: tappet, base_radius: 60 mm, along: up, {curved}}}}}"
        heights = fb.System.from_text(MECHANISM.format(cam=cam)).simulate(0.4, every=0.002).series["y"][0]
        lowest.append(float(np.min(heights)))
    assert lowest[0] < 0.0599  # a spline swings through
    assert lowest[1] == pytest.approx(0.06, abs=1e-9)


@pytest.mark.parametrize(
    ("points", "told"),
    [
        ("[[0 deg, 0 mm], [90 deg, 1 mm], [80 deg, 2 mm], [270 deg, 1 mm]]", "the angles of the points grow"),
        ("[[0 deg, 0 mm], [90 deg, 1 mm], [180 deg, 2 mm]]", "at least 4 points, found 3"),
        ("[[0 deg, 0 mm], [90 deg, 1 mm], [180 deg, 2 mm], [360 deg, 1 mm]]", "0 m, not 0.001 m"),
        ("[[0 deg, 0 mm], [90 deg, 1 mm], [180 deg, 2 mm], [400 deg, 1 mm]]", "more than one turn"),
        ("[[0 deg, 0 mm], [90 deg], [180 deg, 2 mm], [270 deg, 1 mm]]", "an angle and a lift"),
        (
            "[[0 deg, 0 mm], [90 deg, 40 mm], [180 deg, 0 mm], [270 deg, 40 mm]]",
            "undercut: .* Take a base radius",
        ),
    ],
)
def test_points_that_make_no_cam_are_refused_with_what_would_do(points: str, told: str) -> None:
    cam = f"{{cam: {{cam: disk, follower: tappet, base_radius: a, along: up, points: {points}}}}}"
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(MECHANISM.format(cam=cam))


def test_the_example_through_points_is_told_in_its_lift() -> None:
    solution = fb.System.load(Path(__file__).parents[1] / "examples" / "cam_through_points.yaml").solve()
    shown = {answer.id: answer.to_plain()["expression"] for answer in solution.answers}
    assert shown["acceleration"] == "Omega**2*lift_dd(Omega*t)"
    assert shown["force"] == "m*Omega**2*lift_dd(Omega*t) + m*g + F"
    assert shown["torque"] == "lift_d(Omega*t)*(m*Omega**2*lift_dd(Omega*t) + m*g + F)"
    assert shown["jump"] == "sqrt(-(m*g + F)/(m*lift_dd(pi)))"
    assert shown["edge"] == "lift_dd(Omega*t) + lift(Omega*t) + r"


def test_the_edge_of_an_eccentric_circle_has_its_radius_of_curvature_everywhere() -> None:
    flat = "{cam: {cam: disk, follower: tappet, base_radius: a, lift: e*cos(phi), along: up}}"
    for cam in (flat, ROLLER):
        system = fb.System.from_text(MECHANISM.format(cam=cam))
        reference = Reference(system)
        q = reference.assemble()
        snapshot = reference.snapshot(q, reference.velocities(q))
        assert system.question("radius of curvature of it").quantity.value(system, snapshot) == pytest.approx(0.03)


def test_a_force_is_asked_for_that_just_keeps_a_cam_closed_over_a_turn() -> None:
    # N = m g + F + m h/2 Omega^2 cos(phi) is least at the top
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "cam_with_flat_follower.yaml")
    (answer,) = system.solve("value of F for which least contact force of cam over a turn = 0").answers
    assert answer.value == pytest.approx(0.4 * (0.012 / 2 * 1e4 - 9.81), rel=1e-9)


SPRING = """
parameters: {m: 0.4 kg, k: 4 kN/m, F_0: 60 N, h: 12 mm, r: 30 mm, Omega: 200 rad/s}

bodies:
  disk: {body: {inertia: 0.01 kg m^2}}
  tappet: {rectangle: {mass: m, width: 40 mm, height: 20 mm}}

connections:
  axle: {pin: [ground.O, disk]}
  motor: {driver: {measure: phi, follows: Omega*t}}
  guide: {slider: {body: tappet, along: up}}
  cam: {cam: {cam: disk, follower: tappet.bottom, base_radius: r, lift: h/2*(1 - cos(phi)), along: up}}

loads:
  spring: {law: {measure: y, force: -F_0 - k*(y - r)}}

measures:
  phi: {angle of disk from up}
  y: {height of tappet.bottom above ground.O}

start: {phi: 0}

"""


def test_the_least_spring_rate_that_keeps_a_cam_closed_is_that_of_the_textbook() -> None:
    # N = F_0 + k (y - r) + m y'' is least at the top, where y'' = -h Omega^2/2 (Norton, Design of Machinery, ch. 15)
    (answer,) = fb.System.from_text(SPRING).solve("least k so that the cam keeps touching").answers
    assert answer.value == pytest.approx(0.4 * 200**2 / 2 - 60 / 0.012, rel=1e-9)


@pytest.mark.slow  # it answers the question of the opening four times
def test_a_reason_of_the_formulas_is_not_looked_for_at_ever_other_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def counted(system: fb.System) -> fb.Solution:
        asked.append(system.questions[0].text)
        return solve(system)

    monkeypatch.setattr(happening, "solve", counted)
    text = SPRING + "questions: [least k so that the cam keeps touching]\n"
    assert not fb.System.from_text(text).explain().is_complete
    assert len(asked) <= 4  # of ten other numbers for each of three ways to ask


def test_the_base_radius_for_a_pressure_angle_is_that_of_the_textbook(agrees: Callable[..., None]) -> None:
    """tan(alpha) = r'/r is greatest where r = R - (h/2) cos(phi), R = r_b + r_R + h/2, has sin(alpha) = h/(2 R): from
    the tangent from the axle to the eccentric circle that the middle of the roller runs on."""
    system = fb.System.load(EXAMPLES / "cam_with_roller.yaml")
    found = system.solve("value of r for which greatest pressure angle of cam over a turn of phi = pi/12")
    agrees(found, "q1", "h/2*(1/sin(pi/12) - 1) - r_R")


@pytest.mark.parametrize(
    "asked",
    [
        "least r so that pressure angle of cam stays below pi/12 over a turn of phi",
        "least r so that the pressure angle of cam over a turn of phi stays at most pi/12",
        "range of r for which greatest pressure angle of cam over a turn of phi < pi/12",
    ],
)
def test_from_that_base_radius_on_the_pressure_angle_stays_below(asked: str, agrees: Callable[..., None]) -> None:
    """sin(alpha) = h/(2 R) falls as R grows, so the radius of the textbook is the least one."""
    found = fb.System.load(EXAMPLES / "cam_with_roller.yaml").solve(asked)
    agrees(found, "q1", "h/2*(1/sin(pi/12) - 1) - r_R")
    assert any(note.startswith(("this holds for r > ", "this holds for r ≥ ")) for note in found.answers[0].notes)


def test_the_base_radius_at_which_a_cam_is_just_not_undercut(agrees: Callable[..., None]) -> None:
    """rho = r + L + L'' = r + h/2 + b + 3 b cos(2 phi) under a flat face (Norton, sec. 8.7), least r + h/2 - 2 b."""
    lift, twice = "lift: h/2*(1 - cos(phi))", "lift: h/2*(1 - cos(phi)) + b*(1 - cos(2*phi))"
    text = (EXAMPLES / "cam_with_flat_follower.yaml").read_text("utf-8").replace(lift, twice)
    system = fb.System.from_text(text.replace("r: 30 mm,", "r: 30 mm, b: 6 mm,"))
    found = system.solve("value of r for which least radius of curvature of cam over a turn of phi = 0")
    agrees(found, "q1", "2*b - h/2")
    found = system.solve("range of r for which least radius of curvature of cam over a turn of phi > 0")
    agrees(found, "q1", "2*b - h/2")


def test_a_follower_whose_line_misses_the_cam_is_told_so_with_what_would_do() -> None:
    """The middle of the roller is 40 + 10 + 20 mm from the axle at most, and its line 75 mm."""
    text = (EXAMPLES / "cam_with_roller.yaml").read_text("utf-8")
    aside = text.replace("through: ground.O", "through: ground.G").replace(
        "bodies:", "ground: {points: {O: [0, 0], G: [75 mm, 0]}}\nbodies:"
    )
    told = r"follower.bottom runs on a line at 0.075 m from the centre of disk.*0.07 m.*base radius of at least 0.045 m"
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(aside)
    open_ = aside.replace("G: [75 mm, 0]", "G: [s, 0]").replace("h: 20 mm,", "h: 20 mm, s: m,")
    fb.System.from_text(open_)  # of what is not given nothing is said


def test_where_the_extreme_of_a_turn_is_may_change_with_the_parameter() -> None:
    """rho = r + h/2 + b + 3 b cos(2 phi) is least at phi = 90 deg for b > 0 only, so no range of b is made of that."""
    lift, twice = "lift: h/2*(1 - cos(phi))", "lift: h/2*(1 - cos(phi)) + b*(1 - cos(2*phi))"
    text = (EXAMPLES / "cam_with_flat_follower.yaml").read_text("utf-8").replace(lift, twice)
    system = fb.System.from_text(text.replace("r: 30 mm,", "r: 30 mm, b: 6 mm,"))
    found = system.solve("range of b for which least radius of curvature of cam over a turn of phi > 0")
    assert "where the extreme of a turn is changes with b" in found.answers[0].reason


PRELOADED = """
parameters: {m: 0.1 kg, k: 3 N/mm, F_0: 40 N, h: 8 mm, r: 20 mm, s: 60 mm, r_R: 5 mm, Omega: 60 rad/s}
ground: {points: {O: [0, 0], seat: [0, s]}}
bodies:
  disk: {body: {inertia: 2 g m^2}}
  valve: {particle: {mass: m}, near: {at: [0, r]}}
connections:
  axle: {pin: [ground.O, disk]}
  guide: {slider: {body: valve, along: up, through: ground.O}}
  cam: {cam: {cam: disk, follower: valve, base_radius: r, lift: h/2*(1 - cos(phi)), along: up, FORM}}
  drive: {driver: {measure: phi, follows: Omega*t}}
loads: {spring: {spring: {first: ground.seat, second: valve, stiffness: k, preload: -F_0}}}
measures: {phi: angle of disk from up}
"""


@pytest.mark.parametrize("form", ["form: flat", "form: roller, roller_radius: r_R"])
def test_over_a_turn_a_spring_is_preloaded_as_at_the_start_of_the_drive(form: str, agrees: Callable[..., None]) -> None:
    """N = F_0 + k L + m L'' Omega^2 with L = h/2 (1 - cos phi): as k > m Omega^2 it is least where the lift is none."""
    system = fb.System.from_text(PRELOADED.replace("FORM", form))
    agrees(system.solve("least contact force of cam over a turn of phi"), "q1", "F_0 + m*h*Omega**2/2")


# the same eccentric circle pushes a lever about B; its normal goes through the middle E of the circle
SWINGING = """
parameters: {{a: 30 mm, b: 10 mm, e: 8 mm, f: 5 mm, L: 80 mm, c: 90 mm, w: 20 rad/s}}
ground: {{points: {{O: [0, 0], B: [c, 0]}}}}
bodies:
  disk: {{body: {{mass: 1 kg, inertia: 0.01 kg m^2}}}}
  lever: {{rod: {{mass: 0.2 kg, length: L}}, near: {{angle: 155 deg}}, points: {{face: [0, f]}}}}
connections:
  axle: {{pin: [ground.O, disk]}}
  pivot: {{pin: [ground.B, lever.start]}}
  it: {cam}
  motor: {{driver: {{measure: phi, follows: {start} + w*t}}}}
measures: {{phi: angle of disk from right}}
"""


def pressure_angle_of_swing(cam: str, start: float) -> float:
    system = fb.System.from_text(SWINGING.format(cam=cam, start=start))
    reference = Reference(system)
    q = reference.assemble()
    snapshot = reference.snapshot(q, reference.velocities(q))
    return float(system.question("pressure angle of it").quantity.value(system, snapshot))


@pytest.mark.parametrize("start", [0.0, 1.0, 2.5, 4.0])
def test_a_swinging_roller_is_pushed_aside_by_the_angle_in_the_triangle_of_pivot_roller_and_eccentric(
    start: float,
) -> None:
    # the way of the roller is across the lever, so that sin(alpha) is the cosine of the angle between lever and normal
    cam = ROLLER.replace("tappet", "lever.end")
    a_b, e, lever, c = 0.040, 0.008, 0.080, 0.090
    square = e**2 + c**2 - 2 * e * c * np.cos(start)  # from the middle of the circle to the pivot
    expected = np.arcsin((a_b**2 + lever**2 - square) / (2 * a_b * lever))
    assert pressure_angle_of_swing(cam, start) == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("start", [0.0, 1.0, 2.5, 4.0])
def test_a_swinging_face_is_pushed_aside_by_its_distance_from_the_pivot(start: float) -> None:
    # the face is touched a beside the middle of the circle, and at f across from the pivot: sin(alpha) = f over what is
    # between pivot and the place of contact
    cam = "{cam: {cam: disk, follower: lever.face, base_radius: a, lift: e*cos(phi), along: against lever.y}}"
    a, e, f, c = 0.030, 0.008, 0.005, 0.090
    square = e**2 + c**2 - 2 * e * c * np.cos(start)
    expected = -np.arctan(f / np.sqrt(square - (a + f) ** 2))
    assert pressure_angle_of_swing(cam, start) == pytest.approx(expected, rel=1e-8)


def test_a_face_in_line_with_its_pivot_has_no_pressure_angle_left() -> None:
    cam = "{cam: {cam: disk, follower: lever.end, base_radius: a, lift: e*cos(phi), along: against lever.y}}"
    assert pressure_angle_of_swing(cam, 1.0) == pytest.approx(0.0, abs=1e-12)


VALVE = """
parameters: {rb: 20 mm, h: 8 mm, m: 0.1 kg, k: 4000 N/m, F0: 60 N, w: 200 rad/s}
ground: {points: {O: [0, 0], S: [0, 0.15 m]}}
bodies: {disk: {body: {inertia: 0.001 kg m^2}}, valve: {particle: {mass: m}}}
connections:
  axle: {pin: [ground.O, disk]}
  guide: {slider: {body: valve, along: up}}
  cam: {cam: {cam: disk, follower: valve, base_radius: rb, lift: h/2*(1 - cos(2*phi)), along: up}}
  motor: {driver: {measure: phi, follows: w*t}}
loads: {spring: {spring: {first: ground.S, second: valve, stiffness: k, preload: -F0}}}
measures: {phi: angle of disk from up}
"""


@pytest.mark.parametrize(
    "asked",
    [
        "largest w so that contact force of cam stays above 0 over a turn",
        "largest w so that contact force of cam > 0 over a turn",
        "largest w so that contact force of cam is greater than 0 over a turn",
    ],
)
def test_the_speed_at_which_a_valve_floats_is_that_of_the_textbook(asked: str, agrees: Callable[..., None]) -> None:
    """m y'' = 2 m h w^2 cos(2 phi) is least at full lift, where the spring pushes with F0 + k h; at no lift, where it
    is greatest, the cam is pressed at any speed."""
    agrees(fb.System.from_text(VALVE).solve(asked), "q1", "sqrt((F0 + k*h)/(2*m*h))")


def test_greatest_pressure_angle_of_a_swinging_roller_is_where_the_eccentric_lies_along_the_line_of_the_pivots() -> (
    None
):
    cam = ROLLER.replace("tappet", "lever.end")
    system = fb.System.from_text(SWINGING.format(cam=cam, start=0.0))
    # the same triangle: sin(alpha) = (a_b^2 + L^2 - e^2 - c^2 + 2 e c cos(phi))/(2 a_b L) grows with cos(phi)
    a_b, e, lever, c = 0.040, 0.008, 0.080, 0.090
    for which, sense in (("greatest", 1), ("least", -1)):
        square = e**2 + c**2 - 2 * sense * e * c
        expected = np.arcsin((a_b**2 + lever**2 - square) / (2 * a_b * lever))
        answer = system.solve(f"{which} pressure angle of it over a turn")["q1"]
        assert answer.value == pytest.approx(expected, rel=1e-8)


# the same valve from half lift, where the spring pushes with F0: with k h/2 less at no lift
HALF_LIFT = """
parameters: {h: 10 mm, m: 0.3 kg, k: 5 N/mm, F0: PRELOAD, w: 100 rad/s, r: 25 mm}
ground: {points: {O: [0, 0], S: [0, 100 mm]}}
bodies: {disk: {body: {inertia: 0.001 kg m^2}}, valve: {particle: {mass: m}, near: {at: [0, 30 mm]}}}
connections:
  axle: {pin: [ground.O, disk]}
  guide: {slider: {body: valve, along: up}}
  cam: {cam: {cam: disk, follower: valve, base_radius: r, lift: h/2*(1 - cos(phi)), along: up}}
  motor: {driver: {measure: phi, follows: -w*t}}
loads: {spring: {spring: {first: ground.S, second: valve, stiffness: k, preload: -F0}}}
measures: {phi: angle of disk}
"""


def pressed(preload: float, w: float) -> bool:
    """Whether F0 + (k - m w^2) y with y = h/2 sin(angle) is positive all round."""
    y = 0.005 * np.sin(np.linspace(0.0, 2 * np.pi, 721))
    return bool(np.all(preload + (5000.0 - 0.3 * w**2) * y > 0.0))


@pytest.mark.parametrize("preload", [60.0, 10.0], ids=["pressed at any low speed", "lifted at low speeds as well"])
def test_the_largest_speed_of_a_valve_counts_whether_or_not_there_is_a_least_one(
    preload: float, agrees: Callable[..., None]
) -> None:
    """At full lift k h/2 + F0 = m h/2 w^2; at no lift the spring lets go at low speeds where F0 < k h/2."""
    system = fb.System.from_text(HALF_LIFT.replace("PRELOAD", f"{preload} N"))
    answers = system.solve("largest w so that valve stays on cam")
    agrees(answers, "q1", "sqrt((h*k + 2*F0)/(h*m))")
    largest = answers["q1"].value
    assert isinstance(largest, float)
    assert pressed(preload, 0.999 * largest)
    assert not pressed(preload, 1.001 * largest)
    has_least = not pressed(preload, 1.0)
    assert has_least == (preload < 25.0)
    assert any("other ends beside" in note for note in answers["q1"].notes) != has_least


def test_all_speeds_of_a_valve_are_told_with_what_keeps_a_least_one_away() -> None:
    system = fb.System.from_text(HALF_LIFT.replace("PRELOAD", "60 N"))
    answer = system.solve("w for which valve stays on cam")["q1"]
    assert answer.value == pytest.approx(np.sqrt((0.01 * 5000 + 120) / (0.01 * 0.3)))
    assert any("2*F0 > h*k" in str(c) or "2·F0 > h·k" in str(c) or "2·F₀ > h·k" in str(c) for c in answer.conditions)
