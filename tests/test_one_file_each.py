"""A shape and a kind of warning that the program does not know are one file each, and work everywhere from there.

The same is shown where they are tested for connections and loads (`test_glyphs`), questions (`test_questions`), formats
(`test_report_writers`), methods of integration (`test_simulate`), studies (`test_results`) and languages
(`test_narrative_phrases`).
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import freebody as fb
from freebody.cli import commands
from freebody.model import shapes
from freebody.model.shapes.base import Shape
from freebody.study import model_warnings
from freebody.study.model_warnings import WarningKind
from freebody.system.schema import json_schema

TUBE = '''"""Tube: a homogeneous round body with a round hole along its axis."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ONE, ZERO
from freebody.model.shapes.base import Build, Shape, half, square
from freebody.model.solids import RING
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Tube(Shape, kind="tube"):
    """`tube: {mass: m, radius: R, hole: r}`: I = m (R^2 + r^2)/2; in space it is short, about z."""

    called: ClassVar[tuple[str, ...]] = ("pipe",)

    mass: Formula = 0
    radius: Formula
    hole: Formula

    example = "{mass: 1 kg, radius: 0.2 m, hole: 0.1 m}"

    def build(self, names: Names) -> Build:
        m, R, r = (names.positive(self, f, d) for f, d in (("mass", MASS), ("radius", LENGTH), ("hole", LENGTH)))
        I = half(m * (square(R) + square(r)))
        tensor = (half(I), half(I), I, ZERO, ZERO, ZERO) if names.space else ()
        axis = (ZERO, ZERO, ONE) if names.space else ()
        return Build(m, I, radius=R, tensor=tensor, round="disk", axis=axis, solid=RING, sizes=(R,))
'''
HEAVY = '''"""A mass of more than a thousand tonnes, where grams were meant."""

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class VeryHeavy(WarningKind, name="very heavy"):
    """A body that weighs more than a ship."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        for name, value in model.system.document.data.get("parameters", {}).items():
            if str(value).endswith("kg") and float(str(value).split()[0]) > 1e6:
                yield self.warning(Message("{mass} is a ship. Are grams meant?", mass=name), "parameters", name)
'''
SLOPE = """
parameters: {m: 2 kg, R: 0.3 m, r: 0.2 m, alpha: 30 deg, g: 9.81 m/s^2}
ground: {lines: {incline: {along: -alpha}}}
bodies: {pipe: {tube: {mass: m, radius: R, hole: r}}}
connections: {contact: {rolling: {body: pipe, on: incline}}}
loads: {weight: {gravity: g}}
measures: {s: travel of pipe along incline}
questions: {a: acceleration of s}
"""


@pytest.fixture
def tube(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder with a shape that the program does not know, and nothing else."""
    (tmp_path / "tube.py").write_text(TUBE, encoding="utf-8")
    monkeypatch.setattr(shapes, "__path__", [*shapes.__path__, str(tmp_path)])
    import_module("freebody.model.shapes.tube")
    yield tmp_path
    sys.modules.pop("freebody.model.shapes.tube")
    Shape.kinds.forget("tube")


def test_a_new_shape_is_solved_derived_drawn_simulated_and_told_in_german(tube: Path) -> None:
    system = fb.System.from_text(SLOPE)
    # about the contact point: (I + m R^2) a = m g R^2 sin(alpha), I = m (R^2 + r^2)/2
    R, r, g = 0.3, 0.2, 9.81
    expected = g * math.sin(math.radians(30)) / (1 + (R**2 + r**2) / (2 * R**2))
    assert system.solve()["a"].value == pytest.approx(expected)
    assert system.solve("angular acceleration of pipe")["q1"].value == pytest.approx(-expected / R)
    motion = system.simulate(0.5)
    assert motion.is_complete
    assert np.hypot(*motion.course.poses[-1, 0, :2]) == pytest.approx(
        np.hypot(*(motion.course.poses[0, 0, :2] + np.array((math.cos(math.pi / 6), -0.5)) * expected * 0.125))
    )
    picture = system.picture()
    assert "<path" in picture.svg()
    assert "R" in {word.label.text for word in picture.words}
    german = system.explain(language="de")
    assert german.is_complete
    assert "Freikörperbild" in german.to_text()
    (page,) = german.write(tube / "page.html")
    assert "Kontrolle" in page.read_text(encoding="utf-8")


@pytest.mark.usefixtures("tube")
def test_a_new_shape_is_in_the_schema_in_space_and_in_what_is_meant() -> None:
    assert "tube" in json.dumps(json_schema())
    with pytest.raises(fb.ModelError, match="Did you mean tube"):
        fb.System.from_text(SLOPE.replace("tube:", "tbe:"))
    system = fb.System.from_text("""
space: true
bodies: {pipe: {tube: {mass: 1 kg, radius: 0.3 m, hole: 0.2 m}}}
connections: {axle: {revolute: {first: ground.O, second: pipe, about: z}}}
loads: {motor: {torque: {on: pipe, about: z, magnitude: 2 N m}}}
measures: {phi: angle of pipe about z}
""")
    assert system.solve("acceleration of phi")["q1"].value == pytest.approx(2.0 / (0.5 * (0.3**2 + 0.2**2)))
    assert "<path" in system.picture().svg()


def test_a_new_kind_of_warning_is_one_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "very_heavy.py").write_text(HEAVY, encoding="utf-8")
    monkeypatch.setattr(model_warnings, "__path__", [*model_warnings.__path__, str(tmp_path)])
    monkeypatch.setattr(WarningKind, "kinds", list(WarningKind.kinds))
    model = tmp_path / "ball.yaml"
    model.write_text("parameters: {m: 3000000 kg}\nbodies: {ball: {particle: {mass: m}}}\nquestions: [mobility]\n")
    try:
        import_module("freebody.study.model_warnings.very_heavy")
        (warning,) = fb.System.load(model).warnings
        assert warning.kind == "very heavy"
        told = CliRunner().invoke(commands(), ["solve", str(model), "--json"])
    finally:
        sys.modules.pop("freebody.study.model_warnings.very_heavy", None)
    assert f"warning: {model}:1:17: parameters.m: m is a ship. Are grams meant?" in told.stderr
    assert [found["kind"] for found in json.loads(told.stdout)["warnings"]] == ["very heavy"]
