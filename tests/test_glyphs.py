"""Connections and loads say what is drawn of them: new ones are drawn right without a change anywhere else."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody import connections, loads
from freebody.connections.base import Connection
from freebody.loads.base import Load
from freebody.model.glyphs import Groove
from freebody.present.animation import write_animation
from freebody.present.drawing import Drawing
from freebody.present.scene import Scene
from freebody.study.instant import start_of
from freebody.study.picture import picture, poses_of
from freebody.system.reader import register_kinds

register_kinds()
GROOVE = '''"""A pin in a circular groove."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.language.units import LENGTH
from freebody.measures.distance import Distance
from freebody.model import glyphs
from freebody.model.elements import Held
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class CircularGroove(Connection, kind="circular_groove"):
    """`circular_groove: {pin: bead, center: ground.O, radius: R}`: a point stays on a circle of another body."""

    pin: str
    center: str
    radius: Formula

    in_plane = True
    example = """
bodies: {bead: {particle: {mass: 1 kg}, at: [1 m, 0]}}
connections: {it: {circular_groove: {pin: bead, center: ground.O, radius: 1 m}}}
"""

    def rows(self, names: Names) -> list[Held]:
        distance = Distance(names.point(self.center, "center"), names.point(self.pin, "pin"))
        return [Held("normal", "normal force", distance, names.positive(self, "radius", LENGTH))]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        radius = names.positive(self, "radius", LENGTH)
        yield glyphs.Groove(names.point(self.center), names.point(self.pin), radius)
'''
WIND = '''"""Wind: a force along a direction, in proportion to how fast it blows past."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.language.expression import negate
from freebody.language.units import DAMPING
from freebody.loads.base import Load
from freebody.measures.displacement import Displacement
from freebody.model import glyphs
from freebody.model.elements import RATE, Push
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Wind(Load, kind="wind"):
    """`wind: {at: sail, along: right, drag: c}`."""

    at: str
    along: Heading
    drag: Formula

    example = """
bodies: {sail: {particle: {mass: 1 kg}}}
loads: {it: {wind: {at: sail, along: right, drag: 2 N s/m}}}
"""

    def pushes(self, names: Names) -> list[Push]:
        travel = Displacement(names.point(self.at, "at"), names.ground_origin, names.direction(self.along, "along"))
        return [Push("", travel, negate(names.positive(self, "drag", DAMPING) * RATE))]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.ForceArrow(names.point(self.at), names.direction(self.along))
'''


@pytest.fixture
def added(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder with a connection and a load that the program does not know, and nothing else."""
    for package, name, text in ((connections, "circular_groove", GROOVE), (loads, "wind", WIND)):
        (tmp_path / f"{name}.py").write_text(text, encoding="utf-8")
        monkeypatch.setattr(package, "__path__", [*package.__path__, str(tmp_path)])
        import_module(f"{package.__name__}.{name}")
    yield tmp_path
    for package, name in ((connections, "circular_groove"), (loads, "wind")):
        sys.modules.pop(f"{package.__name__}.{name}")
    Connection.kinds.pop("circular_groove")
    Load.kinds.pop("wind")


def drawn(system: fb.System) -> Drawing:
    found = start_of(system, at_rest=True)
    scene = Scene.of(system, found.snapshot.reference.number)
    return Drawing.of(scene, poses_of(found.snapshot)[None])


@pytest.mark.usefixtures("added")
def test_a_new_connection_is_drawn_as_what_it_is() -> None:
    # it holds a distance, as a rod between two points does
    drawing = drawn(fb.System.from_text(Connection.kinds["circular_groove"].example))
    styles = {stroke.style for stroke in drawing.strokes}
    assert "slot" in styles
    assert not styles & {"link", "support"}
    rims = [drawing.points(stroke, 0) for stroke in drawing.strokes if stroke.style == "slot"]
    radii = sorted(float(np.hypot(*rim.T).mean()) for rim in rims)
    assert radii[0] < 1.0 < radii[1]
    assert 0.5 * sum(radii) == pytest.approx(1.0)
    assert all(np.ptp(np.hypot(*rim.T)) < 1e-9 for rim in rims)


def test_a_new_connection_and_a_new_load_are_in_every_kind_of_file(added: Path) -> None:
    model = Connection.kinds["circular_groove"].example + "loads: {gust: {wind: {at: bead, along: up, drag: c}}}\n"
    system = fb.System.from_text(f"{model}parameters: {{c: 2 N s/m}}\n")
    assert isinstance(system.glyphs[0].sign, Groove)
    plain = fb.System.from_text("bodies: {bead: {particle: {mass: 1 kg}, at: [1 m, 0]}}")
    made = picture(system)
    assert "circular groove" in made.description
    assert "F_gust" in {word.label.text for word in made.words}
    assert made.svg().count("<path") > picture(plain).svg().count("<path")
    assert made.tikz().count(r"\path") > picture(plain).tikz().count(r"\path")
    found = start_of(system, at_rest=True)
    scene = Scene.of(system, found.snapshot.reference.number)
    path = write_animation(scene, np.zeros(1), poses_of(found.snapshot)[None], added / "a.html", title="bead")
    (data,) = re.findall(r'<script type="application/json" id="data">([^<>]*)</script>', path.read_text("utf-8"))
    assert "slot" in {stroke["style"] for stroke in json.loads(data)["strokes"]}
