"""A start with other numbers: what was read before with these is what is read of the whole text."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import fields
from typing import Any

import pytest
from tests.example_files import FOLDER, plain

from freebody.errors import FreebodyError
from freebody.language.document import Document
from freebody.studio.nudged import nudged
from freebody.system.system import System

CHAIN = """
bodies: {a: {rod: {mass: 1 kg, length: 1 m}}, b: {rod: {mass: 1 kg, length: 1 m}}}
connections: {A: {pin: [ground.A, a.start]}, B: {pin: [a.end, b.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {alpha: {angle of a}, beta: {angle of b}}
start: {alpha: -60 deg, beta: 0.3, rate(beta): 2 rad/s}
questions: [{find: acceleration of alpha}]
"""
WORDS = ("names", "document", "questions", "assumptions")  # what is said and asked, and where it stands
NUMBER = re.compile(r"\d+(\.\d+)?")


def same(text: str, *changes: tuple[str, Any]) -> tuple[System | None, System]:
    """The system after some changes of the start: by nudging, and read anew."""
    document = Document.read(text)
    system = System.from_document(document)
    for name, value in changes:
        document = document.with_value(("start", name), value)
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


@pytest.mark.parametrize("words", [("mass: 1 kg", "mass: 2 kg"), ("9.81", "9.8"), ("of alpha}", "of beta}")])
def test_what_differs_beside_the_start_is_read_with_the_rest(words: tuple[str, str]) -> None:
    other = Document.read(CHAIN.replace(*words, 1))
    assert nudged(System.from_document(Document.read(CHAIN)), other) is None


def grown(found: re.Match[str]) -> str:
    return f"{1.01 * float(found[0]):.6g}"


def nudges() -> Iterator[tuple[str, dict[str, str]]]:
    """Of the bundled models all numbers of the start, a little larger."""
    for name, said in plain().items():
        start = said.get("start")
        given = {key: str(value) for key, value in start.items()} if isinstance(start, dict) else {}
        larger = {key: NUMBER.sub(grown, value, count=1) for key, value in given.items()}
        if changed := {key: value for key, value in larger.items() if value != given[key]}:
            yield (FOLDER / f"{name}.yaml").read_text(encoding="utf-8"), changed


def test_starts_of_all_examples_are_nudged_as_they_are_read() -> None:
    n_found = 0
    for text, changed in nudges():
        document = Document.read(text, folders=[FOLDER])
        system = System.from_document(document)
        for key, value in changed.items():
            document = document.with_value(("start", key), value)
        try:
            read = System.from_document(document)
        except FreebodyError:
            continue
        if (found := nudged(system, document)) is not None:
            assert_equal(found, read)
            n_found += 1
    assert n_found > 15
