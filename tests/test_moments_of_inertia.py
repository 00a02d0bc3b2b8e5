"""Moments of inertia as a question: by Huygens-Steiner, by integration over slices, and by what they do to motions."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

import freebody as fb

G = 9.81
M, B, H, R = 3.0, 0.6, 0.4, 0.1
PLATE = """
parameters: {M: 3 kg, b: 0.6 m, h: 0.4 m, r: 0.1 m}
bodies:
  plate:
    composite:
      parts: {sheet: {rectangle: {mass: M, width: b, height: h}}}
      holes: {bore: {disk: {mass: M*pi*r^2/(b*h), radius: r}, at: [b/4, 0]}}
    points: {P: [0, h/2]}
connections: {A: {pin: [ground.O, plate.P]}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
TOOL = """
space: {up: z}
parameters: {m: 2 kg, R: 0.2 m, r: 0.1 m, h: 0.3 m, M: 1 kg, L: 0.5 m}
bodies:
  tool:
    composite:
      parts:
        handle: {rod: {mass: M, length: L}, turned: -90 deg about y}
        head: {frustum: {mass: m, radius: R, top_radius: r, height: h, axis: x}, at: [0, 0, L/2]}
connections: {A: {revolute: {first: ground.O, second: tool.origin, about: y}}}
"""


def asked(model: str, *questions: str) -> list[float]:
    answers = fb.System.from_text(model).solve([*questions])
    return [float(answers[f"q{k}"].value or 0.0) for k in range(1, len(questions) + 1)]


def plate_with_hole() -> tuple[float, float, float]:
    """Its mass, its mass centre right of the middle of the sheet, and its moment of inertia about that middle."""
    hole = M * pi * R**2 / (B * H)
    return M - hole, -hole * B / 4 / (M - hole), M * (B**2 + H**2) / 12 - hole * (R**2 / 2 + (B / 4) ** 2)


def test_a_plate_with_a_hole_has_the_moments_of_inertia_of_its_parts() -> None:
    mass, x, about_origin = plate_with_hole()
    about_center = about_origin - mass * x**2
    found = asked(
        PLATE,
        "mass of plate",
        "moment of inertia of plate",
        "moment of inertia of plate about its mass center",
        "moment of inertia of plate about plate.origin",
        "moment of inertia of plate about A",
        "radius of gyration of plate about an axis through A",
        "moment of inertia of the system about ground.O",
    )
    about_pin = about_center + mass * (x**2 + (H / 2) ** 2)
    wanted = [mass, about_center, about_center, about_origin, about_pin, sqrt(about_pin / mass), about_pin]
    assert found == pytest.approx(wanted, rel=1e-9)


def test_the_period_of_a_physical_pendulum_has_its_moment_of_inertia_about_the_pin() -> None:
    # 2 pi sqrt(I_A/(m g d)), for d ask where its mass centre is
    mass, x, _about = plate_with_hole()
    inertia, period = asked(PLATE, "moment of inertia of plate about A", "period of small oscillations")
    assert period == pytest.approx(2 * pi * sqrt(inertia / (mass * G * sqrt(x**2 + (H / 2) ** 2))), rel=1e-9)


def test_the_kinetic_energy_about_a_fixed_axis_is_half_the_moment_of_inertia_times_the_square_of_the_speed() -> None:
    model = TOOL + "measures: {phi: angle of tool about y}\nstart: {phi: 0, rate(phi): 3 rad/s}\n"
    inertia, energy = asked(model, "moment of inertia of tool about A", "kinetic energy at start")
    assert energy == pytest.approx(inertia * 9 / 2, rel=1e-9)


def test_a_rod_with_a_frustum_has_the_moments_that_its_slices_add_up_to() -> None:
    m, base, top, h, rod, length = 2.0, 0.2, 0.1, 0.3, 1.0, 0.5
    z = (np.arange(20000) + 0.5) * h / 20000
    rho = base + (top - base) * z / h
    slices = m * rho**2 / (rho**2).sum()
    middle = float((slices * z).sum()) / m
    along, across = float((slices * rho**2 / 2).sum()), float((slices * (rho**2 / 4 + z**2)).sum())
    center = m * middle / (m + rod)
    found = asked(
        TOOL,
        "moment of inertia of tool about A",
        "moment of inertia of tool about tool.z through tool.mass_center",
        "moment of inertia of tool about tool.z",
        "moment of inertia of tool about tool.x through tool.head",
        "moment of inertia of the system about y through ground.O",
    )
    about_hinge = rod * length**2 / 12 + across + m * (length / 2) ** 2
    about_center = across - m * middle**2 + m * (middle - center) ** 2 + rod * center**2
    about_head = along + rod * (length**2 / 12 + (length / 2) ** 2)
    assert found == pytest.approx([about_hinge, about_center, about_center, about_head, about_hinge], rel=1e-6)


def test_the_derivation_is_that_of_huygens_and_steiner_part_by_part() -> None:
    system = fb.System.from_text(PLATE)
    english = system.explain(["moment of inertia of plate about A", "moment of inertia of plate"])
    assert english.is_complete
    text = english.to_text()
    assert "Huygens-Steiner" in text
    assert "I_sheet_P" in text
    assert "I_bore_S" in text
    german = system.explain("moment of inertia of plate about A", language="de")
    assert german.is_complete
    assert "Satz von Steiner" in german.to_text()


@pytest.mark.parametrize(
    "words",
    [
        "What is the plate's moment of inertia about P?",
        "moment of inertia about the hinge",
        "Wie gross ist das Trägheitsmoment der Platte um P?",
        "Massenträgheitsmoment der Platte um den Punkt P",
    ],
)
def test_it_is_asked_in_ones_own_words(words: str) -> None:
    assert asked(PLATE, words) == asked(PLATE, "moment of inertia of plate about plate.P")


def test_what_has_no_axis_is_told_so() -> None:
    with pytest.raises(fb.ModelError, match="in space a moment of inertia is about an axis"):
        fb.System.from_text(TOOL).solve("moment of inertia of tool")


def test_a_hole_without_a_mass_is_refused() -> None:
    with pytest.raises(fb.ModelError, match="bore has none"):
        fb.System.from_text(PLATE.replace("mass: M*pi*r^2/(b*h), ", ""))


def test_parts_in_a_list_are_the_same_body_as_parts_by_name() -> None:
    listed = PLATE.replace(
        "{sheet: {rectangle: {mass: M, width: b, height: h}}}", "[{rectangle: {mass: M, width: b, height: h}}]"
    )
    listed = listed.replace(
        "{bore: {disk: {mass: M*pi*r^2/(b*h), radius: r}, at: [b/4, 0]}}",
        "[{disk: {mass: M*pi*r^2/(b*h), radius: r}, at: [b/4, 0]}]",
    )
    questions = ("mass of plate", "moment of inertia of plate about A")
    assert asked(listed, *questions) == asked(PLATE, *questions)
    assert "part1" in fb.System.from_text(listed).bodies["plate"].points


def test_a_mistake_in_a_listed_part_is_told_where_it_stands() -> None:
    with pytest.raises(fb.ModelError, match=r"composite\.parts\.0\.dsk: a part has no dsk"):
        fb.System.from_text(PLATE.replace("{sheet: {rectangle: {mass: M, width: b, height: h}}}", "[{dsk: {mass: M}}]"))


def test_a_moment_of_inertia_holds_whether_the_wheel_touches_or_not() -> None:
    """Nothing that a contact needs stands beside what follows from the body alone."""
    text = """
parameters: {m: 2 kg, R: 0.1 m, a: 20 deg, g: 9.81 m/s^2}
ground: {lines: {slope: {along: -a}}}
bodies: {wheel: {disk: {mass: m, radius: R}}}
connections: {track: {rolling: {body: wheel, on: slope}}}
loads: {weight: {gravity: g}}
"""
    answer = fb.System.from_text(text).solve("moment of inertia of wheel").answers[0]
    assert answer.value == pytest.approx(0.01)
    assert answer.conditions == ("for all positive parameters",)


ON_A_SHAFT = """
space: true
parameters: {m: 2 kg, L: 0.3 m, beta: 60 deg, a: 0.1 m}
bodies:
  shaft: {body: {}, points: {P: [a, 0, 0]}}
  bar: {rod: {mass: m, length: L}}
connections:
  axle: {revolute: {first: ground.O, second: shaft, about: x}}
  hub: {weld: {first: shaft.P, second: bar.start, turned: beta about z}}
"""


def test_about_the_axis_of_the_shaft_on_which_it_sits() -> None:
    system = fb.System.from_text(ON_A_SHAFT)
    about_shaft, about_x = system.solve(
        ["moment of inertia of bar about shaft.x", "moment of inertia of bar about x"]
    ).answers
    assert about_shaft.value == pytest.approx(2 * 0.3**2 * 0.75 / 3, rel=1e-9)  # m (L sin beta)^2/3
    assert about_x.value == pytest.approx(2 * 0.3**2 * 0.75 / 12, rel=1e-9)
    assert "through the mass centre of bar" in str(about_x.notes[0])
    assert not about_shaft.notes
