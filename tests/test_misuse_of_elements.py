"""What a beginner gets wrong in each connection, load and shape: one cause, one message, which says where it is."""

from __future__ import annotations

import copy
import io
import re
from collections.abc import Iterator
from typing import Any

import pytest
from ruamel.yaml import YAML

import freebody as fb
from freebody.connections.base import Connection
from freebody.errors import ModelError, Problem
from freebody.loads.base import Load
from freebody.model.shapes.base import Shape

_QUANTITY = re.compile(r"[-+]?[\d.]+(?:e-?\d+)?(?: [A-Za-z][\w/^ ]*)?")
_INTERNAL = re.compile(r"<|None|Error\b|placeholder|pydantic|__|'NoneType'")
_SECTIONS = {"connections": Connection, "loads": Load}

Path = tuple[str | int, ...]


def _examples() -> dict[str, tuple[Any, Path]]:
    """By kind: the data of its example, and where it stands in them."""
    yaml, found = YAML(typ="safe"), dict[str, tuple[Any, Path]]()
    for section, base in _SECTIONS.items():
        for kind, spec in base.kinds.items():
            data = yaml.load(spec.example)
            places = [(section, name, kind) for name, entry in data[section].items() if kind in entry]
            found[f"{section} {kind}"] = data, places[0]
    for kind, shape in Shape.kinds.items():
        data = {"space": True, "bodies": {"it": {kind: yaml.load(shape.example)}}}
        found[f"bodies {kind}"] = data, ("bodies", "it", kind)
    return found


EXAMPLES = _examples()


def _at(data: Any, path: Path) -> Any:
    for key in path:
        data = data[key]
    return data


def _with(data: Any, path: Path, value: Any) -> Any:
    changed = copy.deepcopy(data)
    _at(changed, path[:-1])[path[-1]] = value
    return changed


def _leaves(value: Any, path: Path) -> Iterator[tuple[Path, Any]]:
    pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in pairs:
        yield from _leaves(inner, (*path, key))
    if not isinstance(value, (dict, list)):
        yield path, value


def mistakes(data: Any, place: Path) -> Iterator[tuple[str, Any]]:
    """The data with one mistake in the element, and what it is."""
    own, bodies = _at(data, place), {"ground", *data["bodies"]}
    if isinstance(own, dict):
        for key in own:
            yield f"without {key}", _with(data, place, {k: v for k, v in own.items() if k != key})
            yield f"{key} misspelt", _with(data, place, {(f"{k}q" if k == key else k): v for k, v in own.items()})
    for path, value in _leaves(own, place):
        where = ".".join(map(str, path[2:]))
        text = str(value)
        if isinstance(value, bool):
            continue
        if _QUANTITY.fullmatch(text):
            yield f"{where} in another unit", _with(data, path, "3 s" if "kg" in text else "3 kg")
            yield f"{where} as a word", _with(data, path, "large")
            yield f"{where} negative", _with(data, path, f"-{text.lstrip('-')}")
            yield f"{where} zero", _with(data, path, re.sub(r"^[-+]?[\d.]+", "0", text))
        elif text.partition(".")[0] in bodies:
            yield f"{where} names no body", _with(data, path, f"no{text}")
            yield f"{where} is the ground", _with(data, path, "ground")


def _problems(data: Any) -> tuple[Problem, ...]:
    """What is wrong with a model."""
    text = io.StringIO()
    YAML().dump(data, text)
    try:
        fb.System.from_text(text.getvalue())
    except ModelError as error:
        return tuple(error.problems)
    return ()


@pytest.mark.parametrize("kind", EXAMPLES)
def test_a_mistake_in_an_element_is_one_message_at_its_place(kind: str) -> None:
    data, place = EXAMPLES[kind]
    for what, changed in mistakes(data, place):
        # the example of a mesh stands in no file beside which its own could be
        problems = [one for one in _problems(changed) if "is looked for beside the model" not in one.text(None)]
        told = [problem.text(None) for problem in problems]
        if not told:
            assert not what.endswith((" misspelt", " another unit", " a word", " names no body")), what
            continue
        assert len(told) == 1, (what, told)
        assert problems[0].path[:2] == place[:2], (what, told)
        assert problems[0].line is not None, (what, told)
        assert not _INTERNAL.search(told[0]), (what, told)


@pytest.mark.parametrize(
    ("kind", "field", "value", "says"),
    [
        ("connections bevel_gears", ("teeth", 0), -20, "-20 teeth: a number of teeth is whole"),
        ("connections helical_gears", ("teeth", 1), 0, "0 teeth: a number of teeth is whole"),
        ("connections chain", ("pitch",), "0 mm", "pitch is 0; give a positive one"),
        ("connections clothoid", ("scale",), "0 m", "scale is 0; give a positive one"),
        ("connections brake", ("torque",), "-1 N m", "torque is negative (-1 N m); give a positive one"),
        ("connections brake", ("between", 1), "drum", "joins drum to itself; name two bodies"),
        ("connections stop", ("min",), None, "a stop needs min or max"),
        ("loads elastic_string", ("from",), None, "a string needs two ends: from and to"),
        ("bodies box", ("size", 1), "-1 m", "size is negative (-1 m); give a positive one"),
    ],
)
def test_what_is_no_gear_no_box_and_no_brake_is_told_with_its_cure(
    kind: str, field: Path, value: Any, says: str
) -> None:
    data, place = EXAMPLES[kind]
    (problem,) = _problems(_with(data, (*place, *field), value))
    assert says in problem.message


def test_a_spring_from_a_body_to_itself_is_told_to_want_two_bodies() -> None:
    data, place = EXAMPLES["loads spring"]
    text = io.StringIO()
    YAML().dump(_with(data, (*place, "first"), "ball"), text)
    (warning,) = fb.System.from_text(text.getvalue()).warnings
    assert "it acts between ball and itself, and has no direction: name points of two bodies" in warning.text()


def test_a_question_of_a_kind_of_thing_that_could_not_be_read_is_no_second_mistake() -> None:
    with pytest.raises(ModelError) as raised:
        fb.System.from_text("""
space: true
parameters: {F: 20 kN, p: 8 mm}
bodies: {spindle: {cylinder: {radius: 25 mm, length: 300 mm}}}
connections: {thread: {screw: {between: [ground, spindle], along: z, pitch: p, mean_diameter: 50 mm}}}
loads: {load: {force: {at: spindle, along: [0, 0, -1], magnitude: F}}}
questions: [is the screw self-locking, efficiency]
""")
    assert [str(p.message).partition(".")[0] for p in raised.value.problems] == ["screw has no mean_diameter"]
