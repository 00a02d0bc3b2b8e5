"""Models without dimensions: a mechanism by its topology alone, and its dimensions given later."""

from __future__ import annotations

import jsonschema
import pytest
import yaml

import freebody as fb
from freebody.language.units import LENGTH
from freebody.system.schema import json_schema

FOUR_BAR = """
ground: {points: [A, D]}
bodies: {L1: rod, L2: rod, L3: {rod: {mass: 1 kg}}}
connections:
  A: {pin: [ground.A, L1.start]}
  B: {pin: [L1.end, L2.start]}
  C: {pin: [L2.end, L3.start]}
  D: {pin: [L3.end, ground.D]}
"""
WATT = """
ground: {points: [A, D]}
bodies: {b1: rod, b2: {rod: {}, points: [P]}, b3: {rod: , points: [E]}, b4: rod, b5: rod}
connections:
  A: {pin: [ground.A, b1.start]}
  B: {pin: [b1.end, b2.start]}
  C: {pin: [b2.end, b3.start]}
  D: {pin: [b3.end, ground.D]}
  E: {pin: [b3.E, b4.start]}
  F: {pin: [b4.end, b5.start]}
  G: {pin: [b5.end, b1.center]}
"""


def test_dimensions_that_are_not_given_are_parameters_without_a_value() -> None:
    system = fb.System.from_text(FOUR_BAR)
    assert list(system.parameters) == ["A_x", "A_y", "D_x", "D_y", "length_L1", "length_L2", "length_L3"]
    assert set(system.unspecified) == set(system.parameters)
    for name, parameter in system.parameters.items():
        assert parameter.value is None
        assert parameter.dimension == LENGTH
        assert parameter.sign == ("positive" if name.startswith("length") else "any")
    assert not system.has_values


@pytest.mark.parametrize(("text", "dof"), [(FOUR_BAR, 1), (WATT, 1)])
def test_degrees_of_freedom_need_no_dimensions(text: str, dof: int) -> None:
    answer = fb.solve(fb.System.from_text(text), "degrees of freedom")["q1"]
    assert answer.value == dof, answer.reason


def test_a_formula_contains_the_open_dimension() -> None:
    text = "bodies: {r: {rod: {mass: m}}}\nparameters: {m: kg, g: m/s^2}\nmeasures: {q: angle of r from down}\n"
    text += "connections: {A: {pin: [ground.A, r.start]}}\nloads: {w: {gravity: g}}\n"
    answer = fb.solve(fb.System.from_text(text), "acceleration of q")["q1"]
    assert answer.to_plain()["expression"] == "-3*g*sin(q)/(2*length_r)"


def test_numbers_name_what_is_open() -> None:
    with pytest.raises(fb.CannotAnswer, match="numbers need a value for A_x, A_y, D_x, D_y, length_L1"):
        fb.simulate(fb.System.from_text(FOUR_BAR), until=1)


def test_an_open_dimension_is_given_at_its_place() -> None:
    system = fb.System.from_text(FOUR_BAR)
    given = system.with_parameters(
        A_x=0, A_y=0, D_x="3 m", D_y=0.0, length_L1="1 m", length_L2="3 m", length_L3="2.5 m"
    )
    assert given.has_values
    assert given.unspecified == {}
    assert given.bodies["L1"].points["end"] != system.bodies["L1"].points["end"]
    assert "D: [3 m, 0.0 m]" in given.to_yaml()
    assert "L3: {rod: {mass: 1 kg, length: 2.5 m}}" in given.to_yaml()
    assert fb.System.from_text(given.to_yaml()) == given


def test_one_component_may_stay_open() -> None:
    system = fb.System.from_text("ground: {points: {A: [1 m, null], B: }}\nbodies: {r: rod}\n")
    assert list(system.parameters) == ["A_y", "B_x", "B_y", "length_r"]
    assert list(system.with_parameters(B_x="2 m").parameters) == ["A_y", "B_y", "length_r"]


@pytest.mark.parametrize(
    ("section", "expected"),
    [
        ("parameters: {length_r: 3 kg}", "length_r_2"),
        ("measures: {length_r: angle of r}", "length_r_2"),
        ("connections: {length_r: {pin: [ground.A, r.start]}, length_r_2: {link: [r.end, ground.A]}}", "length_r_3"),
        ("", "length_r"),
    ],
)
def test_the_names_of_open_dimensions_are_never_the_users_own(section: str, expected: str) -> None:
    system = fb.System.from_text(f"bodies: {{r: rod}}\n{section}\n")
    assert list(system.unspecified) == [expected]


def test_names_are_unique_among_themselves_and_can_stand_in_formulas() -> None:
    text = "ground: {points: [B_E, x]}\nbodies: {B: {rod: , points: [E, start]}, x: rod, y__: rod}\n"
    with pytest.raises(fb.ModelError, match="double underscore"):
        fb.System.from_text(text)
    system = fb.System.from_text(text.replace("y__", "y"))
    # x_x and x_y could be the coordinates of bodies; a rod's own start keeps its place
    expected = ["B_E_x", "B_E_y", "x_x_2", "x_y_2", "length_B", "B_E_x_2", "B_E_y_2", "length_x", "length_y"]
    assert list(system.parameters) == expected
    assert [p.name for p in system.parameters.values()] == expected


@pytest.mark.parametrize(
    ("shape", "expected"),
    [
        ("disk", ["radius_b"]),
        ("ring", ["radius_b"]),
        ("sphere", ["radius_b"]),
        ("{disk: {mass: 2 kg}}", ["radius_b"]),
        ("{rod: 2 kg}", ["length_b"]),
        ("{rod: {mass: 2 kg, length: 1 m}}", []),
        ("particle", []),
        ("rectangle", []),  # none of its corners is used, and a block that slides has no dimensions
        ("body", []),
    ],
)
def test_shapes_may_leave_their_lengths_open(shape: str, expected: list[str]) -> None:
    assert list(fb.System.from_text(f"bodies: {{b: {shape}}}").unspecified) == expected


@pytest.mark.parametrize(
    ("point", "expected"), [("left", ["width_b"]), ("top", ["height_b"]), ("top_left", ["width_b", "height_b"])]
)
def test_sides_of_a_rectangle_are_open_where_a_point_needs_them(point: str, expected: list[str]) -> None:
    system = fb.System.from_text(f"bodies: {{b: rectangle}}\nconnections: {{A: {{pin: [ground.A, b.{point}]}}}}")
    assert list(system.unspecified) == expected


def test_descriptions_in_python_may_leave_lengths_open() -> None:
    system = fb.System.from_data({"bodies": {"a": fb.Rod(), "b": fb.Disk("1 kg")}})
    assert list(system.parameters) == ["length_a", "radius_b"]


@pytest.mark.parametrize("declared", ["{A: [0, 0], B: [1 m, 0]}", "[A, B]"])
def test_a_misspelt_ground_point_is_still_told(declared: str) -> None:
    text = f"ground: {{points: {declared}}}\nbodies: {{r: rod}}\nconnections: {{p: {{pin: [ground.AA, r.start]}}}}\n"
    with pytest.raises(
        fb.ModelError, match=r"ground\.AA has no position. Did you mean ground\.A\?.*points: \[A, B, AA\]"
    ):
        fb.System.from_text(text)


@pytest.mark.parametrize("points", ["[[0, 0]]", "[1, 2]", "A", "3"])
def test_points_that_are_neither_mapping_nor_names_are_told(points: str) -> None:
    for text in (f"bodies: {{r: {{rod: , points: {points}}}}}", f"ground: {{points: {points}}}\nbodies: {{r: rod}}"):
        with pytest.raises(fb.ModelError, match=r"points is a mapping, .* or a list of names"):
            fb.System.from_text(text)


@pytest.mark.parametrize("text", [FOUR_BAR, WATT, "ground: {points: {A: [1 m, null], B: }}\nbodies: {b: disk}"])
def test_the_json_schema_knows_open_dimensions(text: str) -> None:
    jsonschema.validate(fb.System.from_text(text).document.data, json_schema())


def test_the_json_schema_knows_the_second_words_of_fields() -> None:
    known = jsonschema.Draft202012Validator(json_schema())

    def written(spring: str, pin: str) -> bool:
        bodies, loads = "{rod: {rod: {mass: m}}}", f"{{s: {{spring: {spring}}}}}"
        text = f"bodies: {bodies}\nconnections: {{hinge: {{pin: {pin}}}}}\nloads: {loads}"
        return known.is_valid(yaml.safe_load(text))

    pin, spring = "[ground.O, rod.start]", "{from: ground.B, to: rod.end, k: k, free_length: l}"
    assert written(spring, pin)
    assert written(spring, "{between: [ground.O, rod.start], mu: mu}")
    assert written("{first: ground.B, to: rod.end, stiffness: k}", "{first: ground.O, to: rod.start}")
    assert not written("{from: ground.B, k: k}", pin)  # one end is missing
    assert not written("{from: ground.B, to: rod.end, kk: k}", pin)
    assert not written(spring, "{between: [ground.O, rod.start, rod.end]}")


def test_the_json_schema_knows_places_by_two_points_and_words_of_a_kind_of_its_own() -> None:
    known = jsonschema.Draft202012Validator(json_schema())

    def is_known(text: str) -> bool:
        return known.is_valid(yaml.safe_load("bodies: {b: rod}\n" * ("bodies" not in text) + text))

    assert is_known("bodies: {bar: {rod: , at: {start: A, end: [a, h]}}, other: {rod: , at: ground.A}}")
    assert not is_known("bodies: {bar: {rod: , at: {start: A, end: [a, h], center: B}}}")
    assert is_known('loads: {q: {distributed: {"on": beam, from: start, to: B, magnitude: q}}}')
    assert is_known('connections: {c: {contact: {body: crate, "on": floor, friction: 0.3}}}')
    assert is_known("connections: {c: {roller: {at: beam.end, along: up}}}")
    assert not is_known("loads: {q: {distributed: {magnitude: q}}}")
