"""Renaming in the text of a model: everywhere it is meant, nowhere else, and back again."""

from __future__ import annotations

import pytest

from freebody.errors import InputError
from freebody.examples_folder import folder, listed_examples
from freebody.numeric.reference import Reference
from freebody.studio import reading
from freebody.studio.renaming import rename
from freebody.studio.wire.texts import RenameRequest
from freebody.system.system import System

PENDULUM = """# m and rod are kept here
parameters: {L: 1 m, m: 2 kg, g: 9.81 m/s^2}  # m in kg
bodies:
  rod: {rod: {mass: m, length: L}}  # thin
connections:
  A: {pin: [ground.A, rod.start]}
loads: {weight: {gravity: g}, push: {force: {at: rod.end, along: right, magnitude: 2*m*g + 3 N + 5 N*m/m}}}
measures: {theta: {angle of rod}}
start: {theta: -60 deg}
questions:
  - {id: first, find: acceleration of theta}
"""


def renamed(text: str, path: str, name: str) -> str:
    return rename(RenameRequest(text=text, path=path.split("."), name=name)).text


def test_a_body_is_renamed_where_it_is_meant_and_its_kind_is_not() -> None:
    text = renamed(PENDULUM, "bodies.rod", "bar")
    expected = PENDULUM.replace("  rod: {rod:", "  bar: {rod:").replace("rod.start", "bar.start")
    assert text == expected.replace("rod.end", "bar.end").replace("angle of rod", "angle of bar")


def test_a_parameter_is_renamed_and_the_unit_of_its_name_is_not() -> None:
    text = PENDULUM.replace(" + 5 N*m/m", "")
    found = renamed(text, "parameters.m", "mass_of_rod")
    expected = text.replace(" m: 2 kg", " mass_of_rod: 2 kg").replace("mass: m,", "mass: mass_of_rod,")
    assert found == expected.replace("2*m*g", "2*mass_of_rod*g")
    assert System.from_text(found).parameters.keys() == {"L", "mass_of_rod", "g"}


def test_a_measure_is_renamed_with_its_start_and_its_questions() -> None:
    assert renamed(PENDULUM.replace(" + 5 N*m/m", ""), "measures.theta", "phi") == PENDULUM.replace(
        " + 5 N*m/m", ""
    ).replace("theta", "phi")


def test_a_word_of_the_grammar_that_is_also_a_name_stays() -> None:
    text = "bodies: {ball: {particle: {mass: 1 kg}}}\nmeasures: {x: x of ball}\nstart: {x: 2 m}\n"
    assert renamed(text, "measures.x", "s") == text.replace("{x:", "{s:")


def test_a_parameter_with_the_name_of_a_field_is_renamed_in_its_value() -> None:
    text = (folder() / "planetary_gear_with_three_planets.yaml").read_text(encoding="utf-8")
    found = renamed(text, "parameters.module", "pitch")
    assert "teeth: [z_S, z_P]" in found
    assert found.count("module: pitch") == text.count("module: module") == 2
    assert found.replace("pitch", "module") == text


@pytest.mark.parametrize("name", ["up", "L", "2a", "a b", "ground", "weight"])
def test_a_name_that_could_be_taken_for_something_else_is_refused(name: str) -> None:
    with pytest.raises(InputError):
        renamed(PENDULUM.replace(" + 5 N*m/m", ""), "bodies.rod", name)


@pytest.mark.parametrize("name", [name for name, _title in listed_examples()][::9])
def test_every_name_of_an_example_goes_there_and_back(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """To another name and back is the text as it was; between, the system starts in the same pose."""
    monkeypatch.setattr(reading, "_folders", [folder()])  # what a model names is looked for there
    monkeypatch.setattr(reading, "_latest", [])
    file = folder() / f"{name}.yaml"
    text = file.read_text(encoding="utf-8")
    system = System.from_text(text, str(file))
    sections = ("parameters", "bodies", "connections", "loads", "measures")
    paths = [(section, key) for section in sections for key in system.document.data.get(section) or {}]
    for section, key in paths:
        there = renamed(text, f"{section}.{key}", "qqx")
        assert "qqx" in there
        other = System.from_text(there, str(file))
        assert sorted(Reference(other).assemble()) == pytest.approx(sorted(Reference(system).assemble()), abs=1e-7)
        back = there.replace("qqx", key)
        assert back == text, (section, key)
