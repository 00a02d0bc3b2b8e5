"""Connections and loads say what is drawn of them: new ones are drawn right without a change anywhere else."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody import connections, loads
from freebody.connections.base import Connection
from freebody.language.expression import number
from freebody.loads.base import Load
from freebody.measures.distance import Distance
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Groove
from freebody.model.names import Names
from freebody.present.animation import write_animation
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Heading, Place
from freebody.present.scene import Scene
from freebody.present.space.drawing import SpatialDrawing
from freebody.study.pictures.instant import start_of
from freebody.study.pictures.picture import picture, poses_of
from freebody.study.pictures.picture_in_space import poses_of as poses_in_space
from freebody.testing.conformance import check_connection, check_load

GROOVE = '''"""A pin in a circular groove."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.language.units import LENGTH
from freebody.measures.distance import Distance
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
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

    def rows(self, names: Names) -> list[ConstraintRow]:
        distance = Distance(names.point(self.center, "center"), names.point(self.pin, "pin"))
        return [ConstraintRow("normal", "normal force", distance, names.positive(self, "radius", LENGTH))]

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
from freebody.model.elements import RATE, AppliedLoad
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

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        travel = Displacement(names.point(self.at, "at"), names.ground_origin, names.direction(self.along, "along"))
        return [AppliedLoad("", travel, negate(names.positive(self, "drag", DAMPING) * RATE))]

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
    Connection.kinds.forget("circular_groove")
    Load.kinds.forget("wind")


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


def test_a_new_connection_and_a_new_load_are_solved_derived_simulated_and_told_in_german(added: Path) -> None:
    check_connection("circular_groove")
    check_load("wind")
    system = fb.System.from_text("""
parameters: {m: 2 kg, R: 1 m, v: 2 m/s, c: 0.5 N s/m}
bodies: {bead: {particle: {mass: m}, at: [R, 0], velocity: [0, v]}}
connections: {it: {circular_groove: {pin: bead, center: ground.O, radius: R}}}
loads: {gust: {wind: {at: bead, along: up, drag: c}}}
questions: {force: normal force of it at start, slower: acceleration of bead along up at start}
""")
    # at (R, 0) the bead goes up with v: along the distance from the centre the groove
    # pushes with -m v^2/R, and the gust slows the bead down by c v
    solution = system.solve()
    assert solution["force"].to_plain()["expression"] == "-m*v**2/R"
    assert solution["slower"].to_plain()["expression"] == "-v*c/m"
    german = system.explain(language="de")
    assert german.is_complete
    assert "Freikörperbild" in german.to_text()
    (page,) = german.write(added / "page.html")
    assert "Kontrolle" in page.read_text(encoding="utf-8")
    motion = system.simulate(0.5)
    assert motion.is_complete
    assert np.hypot(*motion.course.poses[:, 0, :2].T) == pytest.approx(1.0, abs=1e-12)
    assert motion.summary()["energy_error_relative"] < 1e-8
    assert system.conserved().to_text()


@pytest.mark.usefixtures("added")
def test_a_new_connection_is_drawn_in_space_too() -> None:
    system = fb.System.from_text("""
space: true
bodies: {bead: {particle: {mass: 1 kg}, at: [1 m, 0, 0]}}
connections: {flat: {planar: {body: bead}}, it: {circular_groove: {pin: bead, center: ground.O, radius: 1 m}}}
""")
    found = start_of(system, at_rest=True)
    drawing = SpatialDrawing.of(Scene.of(system, found.snapshot.reference.number), *poses_in_space(found))
    rails = [piece for piece in drawing.pieces if piece.look == "rail"]
    middles = np.array([piece.placed(drawing.poses, 0)[0].mean(axis=0) for piece in rails])
    assert np.hypot(*middles[:, :2].T) == pytest.approx(np.ones(len(rails)), abs=0.01)
    assert middles[:, 2] == pytest.approx(np.zeros(len(rails)), abs=1e-9)
    assert "link" not in {piece.look for piece in drawing.pieces}


def test_a_connection_that_does_not_say_what_is_drawn_is_a_thin_line() -> None:
    class Tether(Connection, kind="tether"):
        """`tether: [ground.A, bob]`."""

        first: str
        second: str

        def rows(self, names: Names) -> list[ConstraintRow]:
            distance = Distance(names.point(self.first), names.point(self.second))
            return [ConstraintRow("length", "force", distance, number(1))]

    try:
        system = fb.System.from_text("""
bodies: {bob: {particle: {mass: 1 kg}, at: [0, -1 m]}}
connections: {it: {tether: [ground.A, bob]}}
""")
        drawing = drawn(system)
    finally:
        Connection.kinds.forget("tether")
    (line,) = (stroke for stroke in drawing.strokes if stroke.style == "pull")
    assert drawing.points(line, 0) == pytest.approx(np.array([(0.0, 0.0), (0.0, -1.0)]))


@pytest.mark.parametrize(
    ("kind", "text", "in_figure"),
    [
        ("driver", "angle of rod = w\u2009t", "w\u2009t"),  # at the arc of the angle, whose name it takes
        ("constraint", "x \u2212 2\u2009y = 0", "x \u2212 2\u2009y = 0"),
        ("dry_friction", "friction force \u2264 2 N", "friction force \u2264 2 N"),
    ],
)
def test_what_has_no_sign_is_said_by_an_equation(kind: str, text: str, in_figure: str) -> None:
    system = fb.System.from_text(Connection.kinds[kind].example)
    assert in_figure in {word.label.text for word in picture(system).words}
    assert text in {label.text for label in drawn(system).words}


def test_a_brake_is_a_block_on_the_rim_and_a_spring_of_a_turn_a_spiral() -> None:
    drawing = drawn(fb.System.from_text(Connection.kinds["brake"].example))
    (block,) = (drawing.points(stroke, 0) for stroke in drawing.strokes if stroke.style == "shoe")
    assert block[:, 1].min() == pytest.approx(0.1)  # the radius of the drum
    drawing = drawn(fb.System.from_text(Load.kinds["torsional_spring"].example))
    (spiral,) = (drawing.points(stroke, 0) for stroke in drawing.strokes if stroke.style == "spring")
    assert (np.diff(np.hypot(*spiral.T)) > 0).all()


def test_a_belt_is_told_from_gears_by_what_it_says() -> None:
    # not by how far its wheels are apart
    wheels = "bodies: {a: {disk: {mass: 1 kg, radius: 1 m}}, b: {disk: {mass: 1 kg, radius: 1 m}, at: [%s m, 0]}}\n"
    ground = "ground: {points: {A: [0, 0], B: [%s m, 0]}}\n"
    pins = "connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, it: {%s: [a, b]}}\n"
    for kind, apart, n_belts in (("belt", 2, 1), ("belt", 5, 1), ("gear_mesh", 2, 0)):
        system = fb.System.from_text(wheels % apart + ground % apart + pins % kind)
        strings = [stroke for stroke in drawn(system).strokes if stroke.style == "string"]
        assert len(strings) == n_belts, (kind, apart)


def test_a_roller_is_drawn_in_its_own_size_and_touches_its_cam() -> None:
    drawing = drawn(fb.System.load(Path(__file__).parents[1] / "examples" / "cam_with_roller.yaml"))
    (roller,) = (stroke for stroke in drawing.strokes if stroke.style == "roller")
    rim = drawing.points(roller, 0)
    assert np.hypot(*(rim - np.array((0.0, 0.05))).T) == pytest.approx(0.01)  # its middle r + r_R above the axis
    assert rim[:, 1].min() == pytest.approx(0.04)  # on the base circle


A, B = Place(GROUND, 0.0, 0.0), Place(GROUND, 1.0, 0.0)
UP, RIGHT = Heading(GROUND, 0.0, 1.0), Heading(GROUND, 1.0, 0.0)
SIGNS = (
    glyphs.Pin(A, B),
    glyphs.Weld(A, B),
    glyphs.Ball(A, B),
    glyphs.Cross(A, B, (UP, RIGHT)),
    glyphs.Rail(A, B, RIGHT),
    glyphs.Face(A, B, UP),
    glyphs.Groove(A, B, 1.0),
    glyphs.Roller(B, 0.5),
    glyphs.Track(B, RIGHT, 0.5),
    glyphs.Rod(A, B),
    glyphs.Rope((glyphs.Node(A, 0.0), glyphs.Node(B, 0.0)), (glyphs.Lead(None),)),
    glyphs.Surface(A, RIGHT, (glyphs.Tip(B, 0.0, "ball"),), "ground"),
    glyphs.Halt(B, A, RIGHT, 0.9, 1),
    glyphs.Shoe(B, A),
    glyphs.Relation((A, B)),
    glyphs.Spring(A, B),
    glyphs.Coil(B, A),
)


@pytest.mark.parametrize("space", [False, True])
@pytest.mark.parametrize("sign", SIGNS, ids=lambda sign: type(sign).__name__)
def test_every_sign_is_drawn_in_the_plane_and_in_space(sign: Any, space: bool) -> None:
    system = fb.System.from_text(
        "space: true\nbodies: {ball: {disk: {mass: 1 kg, radius: 0.2 m}, at: [1 m, 0, 0]}}"
        if space
        else "bodies: {ball: {particle: {mass: 1 kg}, at: [1 m, 0]}}"
    )
    found = start_of(system, at_rest=True)
    bare = Scene.of(system, found.snapshot.reference.number)
    shown = replace(bare, shown=(glyphs.ShownGlyph("it", _with(sign, bare.ground if space else GROUND)),))
    if space:
        n = [len(SpatialDrawing.of(scene, *poses_in_space(found)).pieces) for scene in (bare, shown)]
    else:
        n = [len(Drawing.of(scene, poses_of(found.snapshot)[None]).strokes) for scene in (bare, shown)]
    assert n[1] > n[0]


def _with(value: Any, ground: int) -> Any:
    """The same glyph with A on the ground and B on the body."""
    if isinstance(value, Heading):
        return value._replace(body=ground)
    if isinstance(value, Place):
        return Place(ground, 0.0, 0.0) if value is A else Place(0, 0.0, 0.0)
    if isinstance(value, tuple):
        return tuple(_with(item, ground) for item in value)
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{f.name: _with(getattr(value, f.name), ground) for f in fields(value)})
    return value
