"""What a worked solution says when it is handed out: nothing twice, nothing that is not so, and no name of the file."""

from __future__ import annotations

from functools import cache

import pytest

import freebody as fb
from examples_told import FOLDER
from freebody.language.expression import Symbol
from freebody.language.notation import to_latex, to_mathml, to_text
from freebody.language.notation.stacked import stacked
from freebody.language.parser import parse
from freebody.model.shapes.base import Shape
from freebody.narrative.sharing import sentences_of
from freebody.narrative.sheets.statement import ExerciseStatement
from freebody.narrative.telling.catalogue import Catalogue
from freebody.numeric.reference import Reference
from freebody.present.picture.label import formula
from freebody.present.report.blocks import Report
from freebody.present.report.formats.terminal import terminal_text
from freebody.present.scene import Scene
from freebody.study.phases.words import label

WHEEL = """
parameters: {m: 6 kg, R: 0.25 m, k: 400 N/m, c: 20 N s/m, g: 9.81 m/s^2}
ground: {points: {A: [-1 m, R]}}
bodies: {wheel: {disk: {mass: m, radius: R}, at: [0, R]}}
connections: {floor: {rolling: {body: wheel, on: floor}}}
loads:
  weight: {gravity: g}
  spring: {spring: {between: [ground.A, wheel], stiffness: k, rest_length: 1 m}}
  damper: {damper: {between: [ground.A, wheel], damping: c}}
measures: {x: x of wheel}
questions: [natural frequency]
"""
LADDER = """
parameters: {m: 15 kg, L: 5 m, h: 0.6 m, alpha: 60 deg, g: 9.81 m/s^2}
ground: {points: {W: [0, h]}, lines: {floor: {along: right}, wall: {along: down, through: [0, 0]}}}
bodies:
  ladder:
    rod: {mass: m, length: L}
    at: {start: [L*cos(alpha), 0]}
    angle: 180 deg - alpha
    points: {Q: [h/sin(alpha) - L/2, 0]}
connections:
  floor: {contact: {between: [ladder, ground.floor]}}
  wall: {contact: {between: [ladder, ground.wall]}}
  rope: {link: [ground.W, ladder.Q]}
loads: {weight: {gravity: g}}
questions: [tension of rope, normal force of floor]
"""
BEAM = """
parameters: {a: 2 m, b: 3 m, q: 4 kN/m, F: 10 kN}
bodies:
  beam: {rod: {length: a + b}, angle: 0, at: {start: [0, 0]}, points: {C: [(a - b)/2, 0]}}
ground: {points: {A: [0, 0], B: [a + b, 0]}}
connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.end, through: ground.B, along: right}}}
loads:
  sand: {distributed: {between: [beam.C, beam.end], along: down, intensity: q}}
  force: {force: {at: beam.C, along: -60 deg, magnitude: F}}
questions: [{id: A, find: reaction of A}]
"""
GEARS = """
parameters: {z_1: 15, z_2: 60, m: 4 mm, J: 0.004 kg m^2, M: 15 N m}
ground: {points: {A: [0, 0], B: [m*(z_1 + z_2)/2, 0]}}
bodies: {pinion: {gear: {inertia: J}}, wheel: {gear: {inertia: 9*J}}}
connections:
  A: {pin: [ground.A, pinion]}
  B: {pin: [ground.B, wheel]}
  mesh: {gear_mesh: {first: pinion, second: wheel, module: m, teeth: [z_1, z_2], pressure_angle: 20 deg}}
loads: {motor: {torque: {on: pinion, magnitude: M}}}
questions: [angular acceleration of pinion]
"""


@cache
def told(text: str, language: str = "en") -> str:
    """A worked solution as plain text on one line."""
    report = fb.System.from_text(text).explain(language=language).report
    return " ".join(terminal_text(report).split())


# -- small oscillations -----------------------------------------------------------------------
def test_a_natural_frequency_with_a_damper_is_said_to_be_that_without() -> None:
    """Without it the equation is not that of the model; and c is the damper's, not the square of a frequency."""
    assert "those without damping" in told(WHEEL)
    assert "-c·ξ" not in told(WHEEL)
    assert "= c," not in told(WHEEL)
    assert "damping" not in told(WHEEL.replace("\n  damper: {damper: {between: [ground.A, wheel], damping: c}}", ""))


def test_notes_on_damping_are_in_german_in_a_german_report() -> None:
    assert "damped" not in told(WHEEL, "de")
    assert "ohne Dämpfung" in told(WHEEL, "de")


# -- contacts at rest -------------------------------------------------------------------------
def test_what_cannot_move_is_not_said_to_move() -> None:
    assert "moves in contact" not in told(LADDER)
    assert "course of the motion" not in told(LADDER)
    assert "The sums of forces and of moments vanish." in told(LADDER)


def test_a_force_that_was_found_is_not_written_again_by_another_name() -> None:
    assert "S =" not in told(LADDER)
    assert told(LADDER).count("T = ") == 1
    assert "This was found" not in told(LADDER)


# -- names ------------------------------------------------------------------------------------
def test_components_of_a_reaction_have_the_names_of_the_diagram() -> None:
    assert "A_asked" not in told(BEAM)
    assert "A_y" in told(BEAM)


def test_a_support_that_is_called_as_its_node_does_not_push_itself() -> None:
    truss = """
nodes: {A: [0, 0], B: [4 m, 0], C: [2 m, 3 m]}
members: [AB, AC, BC]
supports: {A: pin, B: roller}
loads: {C: 10 kN down}
"""
    answer = fb.System.from_text(truss).solve("reaction of A").answers[0]
    assert str(answer.notes[0]) == "the force that the support A exerts"


# -- frames and trusses -----------------------------------------------------------------------
BRIDGE = """
parameters: {a: 2 m, h: 1.5 m, F: 6 kN, G: 9 kN}
nodes: {A: [0, 0], B: [a, 0], C: [2*a, 0], D: [a/2, h], E: [3*a/2, h]}
members: [AB, BC, AD, BD, BE, CE, DE]
supports: {A: pin, C: roller}
loads: {D: {force: F, along: right}, B: {force: G, along: down}}
questions: [reaction of A, reaction of C, force in DE]
"""


def principles(text: str, *questions: str) -> list[tuple[str, int, str]]:
    """Of each for the last question: what is balanced, of how many bodies, and about which point."""
    derivation = fb.System.from_text(text).explain(questions).derivations[-1]
    said = [s for s in sentences_of(derivation.stages) if s.key.startswith("balance.")]
    point = [s.args.get("point") for s in said]
    return [
        (s.key.removeprefix("balance."), len(s.args["bodies"]), p.args.get("point", p.key) if p else "")
        for s, p in zip(said, point, strict=True)
    ]


def test_reactions_of_a_truss_follow_from_the_whole_of_it() -> None:
    """By hand: moments about C give A_y = (a G - h F)/(2 a), forces to the right A_x = -F; nine nodes are not cut."""
    assert sorted(principles(BRIDGE, "q1")) == [("angular_whole", 5, "C"), ("linear_whole", 5, "")]
    assert "Forces on the whole system to the right." in told(BRIDGE)
    assert "Momente am ganzen System um C." in told(BRIDGE, "de")


def test_a_bar_is_found_by_a_section() -> None:
    """Ritter's: what is cut beside it meets in one point, about which moments are taken."""
    assert all(kind.startswith("angular") for kind, _n, _at in principles(BRIDGE, "q1", "q3"))


def test_bodies_are_named_in_the_order_of_the_file() -> None:
    assert "Moments on A and D about B." in told(BRIDGE)


def test_moments_on_a_beam_are_taken_about_its_supports() -> None:
    assert principles(BEAM, "A")[-1] == ("angular", 1, "B")
    assert "mass centre" not in told(BEAM).replace("moment of inertia about the mass centre", "")


def test_a_section_is_at_a_point_of_the_rod_that_is_cut() -> None:
    text = told(BEAM.replace("find: reaction of A}", "find: bending moment of beam at C}"))
    assert "Cut beam at C." in text
    assert "C of beam" not in text


# -- loads ------------------------------------------------------------------------------------
@pytest.mark.parametrize("intensity", ["q", "[q, q]", "3 kN/m"])
def test_an_even_load_is_one_force(intensity: str) -> None:
    system = fb.System.from_text(BEAM.replace("intensity: q", f"intensity: {intensity}"))
    assert len([load for load in system.applied_loads if load.load == "sand"]) == 1


# -- limiting cases and numbers ---------------------------------------------------------------
def test_a_gear_has_neither_no_teeth_nor_ever_more() -> None:
    assert "z_1 = 0" not in told(GEARS)
    assert "z_2 →" not in told(GEARS).replace("₂", "_2")
    assert "z_1 = z_2" not in told(GEARS)
    assert "J → ∞: 0" in told(GEARS)


def test_the_inertia_of_parts_is_summed_up() -> None:
    """Of a disk with a hole half as large, half way out: M R^2/2 - M/4 (R^2/8 + R^2/4) about O, 37 M R^2/96 about S."""
    system = fb.System.load(FOLDER / "disk_with_a_hole.yaml")
    text = " ".join(terminal_text(system.explain(system.questions[0].id).report).split())
    assert "3·M/4 37·M·R²/96" in text


def test_that_something_grows_with_a_coefficient_is_no_limiting_case() -> None:
    block = """
parameters: {m: 2 kg, mu: 0.3, v: 3 m/s, g: 9.81 m/s^2}
bodies: {block: {particle: {mass: m}}}
connections: {floor: {slider: {body: block, along: right, friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
start: {x: 0, rate(x): v}
questions: [acceleration of x]
"""
    assert "unbounded" not in told(block)


def test_a_moment_of_inertia_of_given_lengths_has_its_unit() -> None:
    crate = """
parameters: {m: 8 kg, a: 0.3 m, M: 2 kg}
bodies:
  crate: {rectangle: {mass: m, width: 0.4 m, height: 0.3 m}}
  half: {rectangle: {mass: m, width: 0.4 m, height: a}}
  cube: {rectangle: {mass: M, width: a, height: a}}
"""
    text = told(crate)
    assert "0.02083 m² · m" in text
    assert "m/48" not in text
    assert "(numbers in SI units)" in text
    assert "M·a²/6" in text


@pytest.mark.parametrize(("angle", "shown"), [("pi/9", "20°"), ("5*pi/36", "25°"), ("pi/8", "22.5°")])
def test_angles_of_functions_are_in_degrees(angle: str, shown: str) -> None:
    expr = parse(f"m*cos({angle})^2 + sin({angle})")
    assert f"sin({shown})" in "".join(stacked(expr)[0].lines)
    assert f"<mn>{shown}</mn>" in to_mathml(expr)
    assert rf"\sin {shown[:-1]}^{{\circ}}" in to_latex(expr)
    assert shown not in to_text(expr)  # which is read again
    assert formula(expr).text.count(shown) == 2


@pytest.mark.parametrize("angle", ["pi/7", "phi - pi/9", "pi*a/9"])
def test_other_angles_are_as_they_are(angle: str) -> None:
    assert "°" not in to_latex(parse(f"sin({angle})"))
    assert "circ" not in to_latex(parse(f"sin({angle})"))


@pytest.mark.parametrize(
    ("name", "latex"),
    [
        ("mR", "m_{R}"),
        ("omegaS", r"\omega_{S}"),
        ("rAB", r"r_{\mathrm{AB}}"),
        ("zS2", r"z_{\mathrm{S2}}"),
        ("v_A", "v_{A}"),
    ],
)
def test_capitals_behind_a_small_letter_are_its_index(name: str, latex: str) -> None:
    assert to_latex(Symbol(name)) == latex
    assert formula(Symbol(name)).runs[-1].level == -1
    assert "<msub>" in to_mathml(Symbol(name))
    assert parse(to_text(Symbol(name))) == Symbol(name)


@pytest.mark.parametrize("name", ["EI", "module", "alphaMax", "FN", "Fx"])
def test_other_names_are_as_they_are_written(name: str) -> None:
    assert "_" not in to_latex(Symbol(name))


# -- contacts and figures ---------------------------------------------------------------------
def test_the_side_of_a_box_is_not_named_by_its_corners() -> None:
    assert label("impact.ball on block top_left-bottom_left") == "impact (ball on block.left)"
    assert label("impact.ball on block.top_left") == "impact (ball on block.top_left)"


def test_the_offset_of_a_slider_crank_has_a_dimension() -> None:
    crank = """
parameters: {r: 50 mm, l: 180 mm, e: 20 mm}
ground: {points: {O: [0, 0]}, lines: {cylinder: {along: up, through: [e, 0]}}}
bodies:
  crank: {rod: {length: r}, angle: 30 deg}
  rod: {rod: {mass: 1 kg, length: l}, near: {angle: 80 deg}}
  piston: {particle: {mass: 2 kg}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  cylinder: {slider: {body: piston, along: cylinder}}
"""
    assert "$e$" in fb.System.from_text(crank).picture().tikz()


def test_a_slot_under_a_beam_is_a_support_on_rollers() -> None:
    """Where something can move, or is driven, it stays a slot."""

    def supports(text: str) -> list[bool]:
        system = fb.System.from_text(text)
        return [rail.is_support for rail in Scene.of(system, Reference(system).number).rails]

    beam = BEAM.partition("questions")[0]
    assert supports(beam) == [True]
    pin, slot = "A: {pin: [ground.A, beam.start]}", "C: {slot: {pin: beam.start, along: right}}"
    assert supports(beam.replace(pin, slot)) == [False, False]
    driven = beam.replace(pin, f"{slot}, motor: {{driver: {{measure: x, follows: a*t/(1 s)}}}}")
    assert supports(f"{driven}measures: {{x: x of beam}}\n") == [False, False]


def test_the_span_between_two_supports_has_its_dimension() -> None:
    span = BEAM.replace("B: [a + b, 0]", "B: [L, 0]").replace("a: 2 m", "L: 5 m, a: 2 m")
    assert "$L$" in fb.System.from_text(span.replace("length: a + b", "length: L")).picture().tikz()


def test_a_node_of_a_truss_is_named_once() -> None:
    svg = fb.System.from_text(BRIDGE).picture().svg()
    assert len({svg.count(f">{node}<") for node in "ABCDE"}) == 1


# -- exercise sheets --------------------------------------------------------------------------
def stated(text: str, language: str = "en") -> str:
    """The statement of an exercise as plain text on one line."""
    statement = ExerciseStatement(fb.System.from_text(text), Catalogue(language), 1, 1)
    return " ".join(terminal_text(Report("", language, "", statement.blocks(), {})).split())


def test_a_statement_gives_the_numbers_that_no_figure_shows() -> None:
    """Without the unstretched length of its spring the wheel cannot be calculated."""
    assert "unstretched length of spring 1 m" in stated(WHEEL)
    assert "ungespannte Länge von spring 1 m" in stated(WHEEL, "de")
    assert "pressure angle of mesh 20°" in stated(GEARS)
    assert "unstretched" not in stated(WHEEL.replace("rest_length: 1 m", "rest_length: R"))


@pytest.mark.parametrize("shape", sorted(Shape.kinds))
@pytest.mark.parametrize("language", ["en", "de"])
def test_every_shape_has_words(shape: str, language: str) -> None:
    assert Catalogue(language).has(f"shape.{shape.replace('_', ' ')}")


def test_a_gear_and_a_half_disk_are_said_in_words() -> None:
    assert "pinion (gear," in stated(GEARS)
    bowl = "bodies: {bowl: {half_disk: {mass: 2 kg, radius: 0.1 m}}}\nquestions: [angular acceleration of bowl]\n"
    assert "bowl (uniform half disk," in stated(bowl)


COMPOSITE = """
parameters: {M: 3 kg, g: 9.81 m/s^2}
bodies:
  wheel:
    composite:
      parts: {full: {disk: {mass: M, radius: 0.2 m}}, bar: {rod: {mass: 2 kg, length: 0.4 m}, at: [0.1 m, 0]}}
connections: {axle: {pin: [ground.A, wheel.full]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of wheel}
start: {theta: 0}
questions: {it: acceleration of theta}
"""


def test_a_moment_of_inertia_is_a_share_of_a_mass_only_where_it_grows_with_it() -> None:
    """Beside a part with a mass in numbers it does not: M r^2/2 + m l^2/12 and both shifts, 0.0987 kg m^2."""
    assert "m² · M" not in told(COMPOSITE)


TWO_NUMBERS = """
parameters: {m: 1 kg, v: 2 m/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {b: {particle: {mass: m}}}
connections: {c: {contact: {between: [b, floor], friction: {static: 0.5, kinetic: 0.3}, restitution: 0}}}
loads: {weight: {gravity: g}}
measures: {x: travel of b along floor}
start: {x: 0, rate(x): v}
questions: {n: change of x until b stops}
"""


def test_both_coefficients_of_friction_are_told_and_that_nothing_bounces() -> None:
    text = stated(TWO_NUMBERS)
    assert "coefficient of static friction of c 0.5" in text
    assert "coefficient of kinetic friction of c 0.3" in text
    assert "coefficient of restitution of c 0" in text
