"""Parameters and a start with other numbers: what was read before with these is what is read of the whole text."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import fields
from typing import Any

import pytest
from tests.example_files import FOLDER, plain

from freebody.language.document import Document
from freebody.language.expression import Expr
from freebody.numeric.jet_geometry import Frame, JetGeometry
from freebody.numeric.jets import Array
from freebody.numeric.system import NumericSystem
from freebody.studio.moving import motion
from freebody.studio.nudged import nudged
from freebody.studio.reading import look_in, passing_system
from freebody.studio.wire.motions import MotionRequest
from freebody.system.system import System

CHAIN = """
parameters: {L: 1 m, m: 1 kg, beta_0: {value: 20 deg, sign: any}, k: N/m, v: {function: V*t, unit: m/s}, V: 2 m/s^2}
bodies: {a: {rod: {mass: m, length: L}}, b: {rod: {mass: 1 kg, length: 1 m}}}
connections: {A: {pin: [ground.A, a.start]}, B: {pin: [a.end, b.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {alpha: {angle of a}, beta: {angle of b}}
start: {alpha: -60 deg, beta: 0.3, rate(beta): 2 rad/s}
questions: [{find: acceleration of alpha}]
"""
WORDS = ("names", "document", "questions", "assumptions")  # what is said and asked, and where it stands
NUMBER = re.compile(r"\d+(\.\d+)?")


def same(text: str, *changes: tuple[str, Any], section: str = "start") -> tuple[System | None, System]:
    """The system after some changes of a section: by nudging, and read anew."""
    document = Document.read(text)
    system = System.from_document(document)
    for name, value in changes:
        document = document.with_value((section, name), value)
    return nudged(system, document), System.from_document(document)


def assert_equal(found: System | None, read: System) -> None:
    assert found is not None
    for field in fields(System):
        if field.name not in WORDS:
            assert getattr(found, field.name) == getattr(read, field.name), field.name
    assert found.document.dumps() == read.document.dumps()


@pytest.mark.parametrize(
    "changes",
    [[("alpha", "-59 deg")], [("beta", 0.4)], [("rate(beta)", "3 rad/s")], [("alpha", 1), ("beta", "20 deg")]],
)
def test_another_number_of_the_start_is_read_alone(changes: list[tuple[str, Any]]) -> None:
    assert_equal(*same(CHAIN, *changes))


@pytest.mark.parametrize("change", [("alpha", 0), ("alpha", "0 deg"), ("alpha", "L"), ("alpha", "60 m"), ("gamma", 1)])
def test_what_is_no_other_number_is_read_with_the_rest(change: tuple[str, Any]) -> None:
    document = Document.read(CHAIN)
    assert nudged(System.from_document(document), document.with_value(("start", change[0]), change[1])) is None


@pytest.mark.parametrize("changes", [[("L", "2.5 m")], [("m", "2 kg"), ("L", "3 m")], [("V", "3 m/s^2")]])
def test_another_number_of_a_parameter_is_read_alone(changes: list[tuple[str, Any]]) -> None:
    assert_equal(*same(CHAIN, *changes, section="parameters"))


@pytest.mark.parametrize(
    "change", [("L", "kg"), ("L", "1 kg"), ("L", "-1 m"), ("m", "1 g + L"), ("k", "2 N/m"), ("v", 3), ("other", 1)]
)
def test_what_is_no_other_number_of_a_parameter_is_read_with_the_rest(change: tuple[str, Any]) -> None:
    document = Document.read(CHAIN)
    assert nudged(System.from_document(document), document.with_value(("parameters", change[0]), change[1])) is None


def test_an_angle_that_is_no_longer_acute_is_read_with_the_rest() -> None:
    document = Document.read(CHAIN.replace("{value: 20 deg, sign: any}", "20 deg"))
    system, changed = System.from_document(document), document.with_value(("parameters", "beta_0"), "21 deg")
    assert nudged(system, changed) is not None
    assert nudged(system, document.with_value(("parameters", "beta_0"), "100 deg")) is None


def test_what_the_reader_asks_the_number_of_is_read_with_the_rest() -> None:
    """Whether two wheels are as far apart as their radii say is told from numbers."""
    wheels = (
        "{parameters: {r: 1 m, R: 2 m, J: 1 kg m^2, m: 1 kg}, "
        "bodies: {a: {disk: {mass: m, radius: r}}, b: {disk: {mass: m, radius: R}}}, "
        "connections: {A: {pin: [ground.A, a.center]}, B: {pin: [ground.B, b.center]}, it: {gear_mesh: [a, b]}}, "
        "ground: {points: {A: [0, 0], B: [3 m, 0]}}}"
    )
    document = Document.read(wheels)
    system = System.from_document(document)
    assert nudged(system, document.with_value(("parameters", "m"), "2 kg")) is not None
    assert nudged(system, document.with_value(("parameters", "R"), "2.5 m")) is None


def test_what_hangs_on_no_number_is_found_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """And of what does, each number of the model once: by the work that is counted while a parameter is moved."""
    look_in([])
    numbers = CHAIN.replace("k: N/m, ", "")
    asked = [
        MotionRequest(text=numbers.replace("L: 1 m", f"L: {n} m"), until=1, frames=21, is_passing=True) for n in (1, 2)
    ]
    motion(asked[0])
    before = passing_system(asked[0].text)
    lasting = {name: vars(before)[name] for name in ("groups", "touched", "bounds", "glyphs", "all_moving")}
    trees, poses = Counter[int](), Counter[bytes]()
    number_of, geometry = NumericSystem._number, JetGeometry.__init__

    def counted(system: NumericSystem, expr: Expr, t: float) -> float:
        trees[id(expr)] += 1
        return number_of(system, expr, t)

    def seen(g: JetGeometry, frame: Frame, q: Array, v: Array, *rest: Any) -> None:
        poses[q.tobytes() + v.tobytes()] += 1
        geometry(g, frame, q, v, *rest)

    monkeypatch.setattr(NumericSystem, "_number", counted)
    monkeypatch.setattr(JetGeometry, "__init__", seen)
    passing = motion(asked[1])
    system = passing_system(asked[1].text)
    assert {name: vars(system)[name] for name in lasting} == lasting
    assert all(vars(system)[name] is found for name, found in lasting.items())
    assert set(trees.values()) == {1}
    assert max(poses.values()) <= 2  # the start: where it is assembled, and for the engine
    look_in([])
    assert motion(asked[1]) == passing  # of the text read as a whole, to the last digit


@pytest.mark.parametrize("words", [("mass: 1 kg", "mass: 2 kg"), ("9.81", "9.8"), ("of alpha}", "of beta}")])
def test_what_differs_beside_the_start_is_read_with_the_rest(words: tuple[str, str]) -> None:
    other = Document.read(CHAIN.replace(*words, 1))
    assert nudged(System.from_document(Document.read(CHAIN)), other) is None


def grown(found: re.Match[str]) -> str:
    return f"{1.01 * float(found[0]):.6g}"


def nudges(section: str) -> Iterator[tuple[str, dict[str, str]]]:
    """Of the bundled models all numbers of a section, a little larger."""
    for name, said in plain().items():
        entries = said.get(section)
        given = {key: str(value) for key, value in entries.items()} if isinstance(entries, dict) else {}
        larger = {key: NUMBER.sub(grown, value, count=1) for key, value in given.items()}
        if changed := {key: value for key, value in larger.items() if value != given[key]}:
            yield (FOLDER / f"{name}.yaml").read_text(encoding="utf-8"), changed


def test_starts_of_all_examples_are_nudged_as_they_are_read() -> None:
    assert n_nudged("start") > 15


def test_parameters_of_all_examples_are_nudged_as_they_are_read() -> None:
    """The last one of each: with all of them few texts would be left on whose numbers nothing hangs."""
    assert n_nudged("parameters") > 60


def n_nudged(section: str) -> int:
    n_found = 0
    for text, changed in nudges(section):
        before = Document.read(text, folders=[FOLDER])
        system = System.from_document(before)
        n_found += sum(is_nudged(system, before, section, each) for each in steps(section, changed))
    return n_found


def steps(section: str, changed: dict[str, str]) -> list[dict[str, str]]:
    return [changed] if section == "start" else [dict([changed.popitem()])]


def is_nudged(system: System, document: Document, section: str, changed: dict[str, str]) -> bool:
    for key, value in changed.items():
        document = document.with_value((section, key), value)
    if (found := nudged(system, document)) is None:
        return False
    assert_equal(found, System.from_document(document))
    return True
