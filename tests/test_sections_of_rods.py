"""Axial force, shear force and bending moment in rods: at rest, in bars of trusses, and with inertia.

Sources: Gere & Goodno, Mechanics of Materials, ch. 4 (beams); Hibbeler, Statics, ch. 6 (trusses); the falling chimney,
which breaks where M is greatest, at a third of its height: Bundy, J. Appl. Phys. 11 (1940) 112; the rotating rod:
Meriam & Kraige, Dynamics, ch. 3.
"""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt
from random import Random

import numpy as np
import pytest

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.questions.section import SectionForce


def formula(system: fb.System, question: str) -> Expr:
    (answer,) = system.solve(question).answers
    assert answer.expression is not None, answer.reason
    assert not isinstance(answer.expression, tuple)
    assert answer.evidence is not None
    return answer.expression


def value(system: fb.System, question: str, **others: float) -> float:
    numbers = {name: p.value for name, p in system.parameters.items() if p.value is not None} | others
    return float(evaluate(formula(system, question), numbers, FLOAT_FUNCTIONS))


# -- beams at rest ----------------------------------------------------------------------------
BEAM = fb.System.from_text("""
parameters: {L: 2 m, F: 5 kN, m: 10 kg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {mass: m, length: L}, points: {C: [-L/4, 0], D: [L/4, 0]}}}
connections: {left: {pin: [ground.A, beam.start]}, right: {slot: {pin: beam.end, along: right, through: ground.B}}}
loads: {weight: {gravity: g}, load: {force: {at: beam.center, along: down, magnitude: F}}}
""")
L, F, W = 2.0, 5e3, 98.1


def test_a_beam_on_two_supports_bends_most_under_the_load_in_its_middle() -> None:
    assert value(BEAM, "bending moment of beam at beam.center") == pytest.approx(F * L / 4 + W * L / 8, rel=1e-12)


@pytest.mark.parametrize(("point", "x"), [("C", L / 4), ("D", 3 * L / 4)])
def test_shear_force_and_bending_moment_are_those_of_the_part_to_the_left(point: str, x: float) -> None:
    A = (F + W) / 2
    beyond = F if x > L / 2 else 0.0
    M = A * x - W / L * x * x / 2 - beyond * (x - L / 2)
    assert value(BEAM, f"shear force of beam at {point}") == pytest.approx(A - W * x / L - beyond, rel=1e-12)
    assert value(BEAM, f"bending moment of beam at {point}") == pytest.approx(M, rel=1e-12)


LOADED = """
parameters: {L: 4 m, q: 500 N/m, w: 300 N/m, P: 200 N}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L}, angle: 0, at: {start: [0, 0]}, points: {C: [-L/4, 0], D: [L/4, 0]}}}
connections: {left: {pin: [ground.A, beam.start]}, right: {slot: {pin: beam.end, along: right, through: ground.B}}}
"""


@pytest.mark.parametrize(
    ("load", "expected"),
    [
        # q x (L - x)/2 and its slope
        pytest.param(
            "between: [beam.start, beam.end], intensity: q",
            {"M C": "3*L**2*q/32", "M center": "L**2*q/8", "V C": "L*q/4", "V center": "0", "A": "L*q/2"},
            id="even",
        ),
        # rises to w at the end: B = w L/3, M = w L x/6 - w x^3/(6 L)
        pytest.param(
            "between: [beam.start, beam.end], intensity: [0, w]",
            {"M center": "L**2*w/16", "V center": "w*L/24", "M C": "5*w*L**2/128", "A": "w*L/6"},
            id="rises",
        ),
        # the same from the other end
        pytest.param(
            "between: [beam.end, beam.start], intensity: [w, 0]",
            {"M center": "L**2*w/16", "V center": "w*L/24", "M C": "5*w*L**2/128", "A": "w*L/6"},
            id="falls on the way back",
        ),
        # falls: that of the even one less that of the one that rises
        pytest.param(
            "between: [beam.start, beam.end], intensity: [w, 0]",
            {"M center": "L**2*w/16", "M C": "7*L**2*w/128", "A": "w*L/3", "V center": "-w*L/24"},
            id="falls",
        ),
        pytest.param(
            "between: [beam.start, beam.end], intensity: [q, w]",
            {"M center": "L**2*(q + w)/16", "M C": "L**2*(7*q + 5*w)/128", "A": "L*(2*q + w)/6"},
            id="trapezium",
        ),
        # on the right half: A = q L/8, 3/8 of it at B; before it M rises evenly
        pytest.param(
            "between: [beam.center, beam.end], intensity: q",
            {"M C": "q*L**2/32", "M center": "q*L**2/16", "M D": "q*L**2/16", "V C": "q*L/8", "V D": "-q*L/8"},
            id="half",
        ),
    ],
)
def test_a_load_along_a_beam_bends_it_as_in_the_tables(load: str, expected: dict[str, str]) -> None:
    # Source: Gere & Goodno, Mechanics of Materials, sec. 4.5 and app. H
    system = fb.System.from_text(LOADED + f"loads: {{it: {{distributed: {{{load}, along: down}}}}}}")
    asked = {"M": "bending moment of beam at", "V": "shear force of beam at", "A": "reaction of left along up"}
    numbers = {"L": 4.0, "q": 500.0, "w": 300.0}
    for what, by_hand in expected.items():
        part, _, point = what.partition(" ")
        found = value(system, f"{asked[part]} {point}".strip())
        assert found == pytest.approx(eval(by_hand, numbers.copy()), rel=1e-12, abs=1e-9), what


def test_a_load_along_a_slanting_rod_pulls_at_it_as_well() -> None:
    # by q l along the ground's vertical on the part l beyond the cut: N = -q l sin(alpha), V = q l cos(alpha)
    system = fb.System.from_text("""
parameters: {L: 3 m, q: 200 N/m, alpha: 30 deg}
bodies: {arm: {rod: {length: L}, angle: alpha, at: {start: [0, 0]}, points: {C: [L/6, 0]}}}
connections: {clamp: {weld: [ground.A, arm.start]}}
loads: {it: {distributed: {between: [arm.start, arm.end], along: down, intensity: q}}}
""")
    assert value(system, "axial force of arm at C") == pytest.approx(-200 * sin(radians(30)), rel=1e-12)
    assert value(system, "shear force of arm at C") == pytest.approx(200 * cos(radians(30)), rel=1e-12)
    assert value(system, "bending moment of arm at C") == pytest.approx(-200 * cos(radians(30)) / 2, rel=1e-12)
    (answer,) = system.solve("axial force of arm").answers
    assert "it acts between the ends of arm" in str(answer.reason)


def test_where_a_load_along_a_line_begins_behind_a_section_may_depend_on_lengths() -> None:
    system = fb.System.from_text("""
parameters: {L: 3 m, s: 1 m, q: 200 N/m}
bodies: {arm: {rod: {length: L}, angle: 0, at: {start: [0, 0]}, points: {S: [s - L/4, 0]}}}
connections: {clamp: {weld: [ground.A, arm.start]}}
loads: {it: {distributed: {between: [arm.S, arm.end], along: down, intensity: q}}}
""")
    assert value(system, "bending moment of arm at arm.start") == pytest.approx(-200 * 1.25 * 2.375, rel=1e-12)
    (answer,) = system.solve("bending moment of arm at center").answers  # the load begins behind it
    assert answer.value == pytest.approx(-200 * 1.25 * 0.875, rel=1e-12)
    assert any("4·s > L" in str(told) for told in answer.conditions)


def test_a_body_swings_under_a_load_along_it_that_turns_with_it() -> None:
    # p a on the lever's arm, always across it: J alpha = p a b, whatever the angle
    system = fb.System.from_text("""
parameters: {m: 3 kg, L: 2 m, p: 5 N/m}
bodies: {lever: {rod: {mass: m, length: L}}}
connections: {axle: {pin: [ground.A, lever.start]}}
measures: {phi: angle of lever}
loads: {it: {distributed: {between: [lever.center, lever.end], along: lever.y, intensity: p}}}
""")
    assert value(system, "acceleration of phi") == pytest.approx(5 * 1 * 1.5 / (3 * 4 / 3), rel=1e-12)


def test_the_shear_force_under_a_load_is_not_told() -> None:
    (answer,) = BEAM.solve("shear force of beam at center").answers
    assert answer.expression is None
    assert "load acts in that very section" in str(answer.reason)


def test_the_shear_force_jumps_by_the_load() -> None:
    before, behind = (value(BEAM, f"shear force of beam just {side} center") for side in ("before", "behind"))
    assert before == pytest.approx(F / 2, rel=1e-9)  # the reaction (F + W)/2 less half of the weight
    assert behind == pytest.approx(before - F, rel=1e-12)


CANTILEVER = fb.System.from_text("""
parameters: {L: 2 m, T: 30 N m, m: 10 kg, g: 9.81 m/s^2}
bodies: {beam: {rod: {mass: m, length: L}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.O, beam.start]}}
loads: {weight: {gravity: g}}
""")


def test_a_cantilever_is_bent_most_where_it_is_clamped_and_not_at_its_end() -> None:
    assert value(CANTILEVER, "bending moment of beam at beam.start") == pytest.approx(-W * L / 2, rel=1e-12)
    assert value(CANTILEVER, "shear force of beam at beam.start") == pytest.approx(W, rel=1e-12)
    assert value(CANTILEVER, "bending moment of beam at center") == pytest.approx(-W * L / 8, rel=1e-12)
    assert value(CANTILEVER, "bending moment of beam at end") == 0


def test_the_bending_moment_of_a_clamp_is_the_moment_that_it_exerts_the_other_way_round() -> None:
    clamp = value(CANTILEVER, "moment of clamp")
    assert value(CANTILEVER, "bending moment of beam at beam.start") == pytest.approx(-clamp, rel=1e-12)


# -- bars of trusses --------------------------------------------------------------------------
def truss(height: str) -> fb.System:
    """A load F hangs from, or rests on, two bars whose feet are 2 a apart."""
    return fb.System.from_text(f"""
parameters: {{a: 2 m, h: 1.5 m, F: 10 kN}}
ground: {{points: {{A: [0, 0], B: [2*a, 0]}}}}
bodies:
  AC: {{rod: {{length: sqrt(a^2 + h^2)}}, at: {{end: [a, {height}]}}}}
  BC: {{rod: {{length: sqrt(a^2 + h^2)}}}}
connections: {{pA: {{pin: [ground.A, AC.start]}}, pB: {{pin: [ground.B, BC.start]}}, pC: {{pin: [AC.end, BC.end]}}}}
loads: {{load: {{force: {{at: AC.end, along: down, magnitude: F}}}}}}
""")


@pytest.mark.parametrize(("height", "sign"), [("-h", 1), ("h", -1)])
@pytest.mark.parametrize("question", ["axial force of AC", "force in BC", "tension in AC", "bar force of BC"])
def test_two_bars_carry_a_load_by_tension_below_their_feet_and_by_compression_above(
    height: str, sign: int, question: str
) -> None:
    # 2 N sin(alpha) = F, sin(alpha) = h/sqrt(a^2 + h^2)
    expected = sign * 10e3 * 2.5 / (2 * 1.5)
    assert value(truss(height), question) == pytest.approx(expected, rel=1e-12)


def test_compression_is_counted_the_other_way_round() -> None:
    assert value(truss("h"), "compression in AC") == pytest.approx(10e3 * 2.5 / 3.0, rel=1e-12)


def test_a_truss_that_cannot_move_has_a_derivation() -> None:
    text = truss("-h").explain().to_text()
    assert "There is no derivation" not in text


def test_a_load_between_the_ends_of_a_bar_is_told() -> None:
    text = truss("h").to_yaml().replace("at: AC.end, along: down", "at: AC.center, along: down")
    (answer,) = fb.System.from_text(text).solve("axial force of AC").answers
    assert "load acts between the ends of AC" in str(answer.reason)


def test_the_force_in_a_rod_with_mass_is_asked_at_a_point() -> None:
    for what in ("axial force", "bending moment"):
        with pytest.raises(fb.ModelError, match=rf"{what} of beam at beam\.center"):
            BEAM.solve(f"{what} of beam")


# -- rods that move ---------------------------------------------------------------------------
CHIMNEY = fb.System.from_text("""
parameters: {m: 3 kg, L: 2 m, x: 0.6 m, g: 9.81 m/s^2}
bodies: {chimney: {rod: {mass: m, length: L}, points: {P: [x - L/2, 0], Q: [L/3 - L/2, 0]}}}
connections: {foot: {pin: [ground.O, chimney.start]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of chimney from up clockwise}
start: {theta: 10 deg, rate(theta): 0}
""")


def test_where_a_chimney_that_falls_is_bent_most_need_not_be_asked() -> None:
    # m g L sin(theta)/27 at L/3
    asked = ["greatest bending moment of chimney", "place of the greatest bending moment of chimney"]
    size, at = CHIMNEY.solve(asked).answers
    assert size.value == pytest.approx(3 * 9.81 * 2 * sin(radians(10)) / 27, rel=1e-12)
    assert at.value == pytest.approx(2 / 3, rel=1e-12)


def test_a_chimney_that_falls_as_a_rigid_body_is_bent_most_at_a_third_of_its_height() -> None:
    m, length, x, g, theta = 3.0, 2.0, 0.6, 9.81, radians(60)
    M = m * g * sin(theta) * x * (length - x) ** 2 / (4 * length**2)
    event = "when theta = 60 deg"
    assert value(CHIMNEY, f"bending moment of chimney at P {event}") == pytest.approx(M, rel=1e-12)
    greatest = value(CHIMNEY, f"bending moment of chimney at Q {event}")
    assert greatest == pytest.approx(m * g * length * sin(theta) / 27, rel=1e-12)
    assert greatest > value(CHIMNEY, f"bending moment of chimney at P {event}")
    # V = dM/dx vanishes there
    assert value(CHIMNEY, f"shear force of chimney at Q {event}") == 0


def test_what_the_section_at_the_foot_transmits_is_the_reaction_of_the_foot() -> None:
    angle = radians(60)
    event = "when theta = 60 deg"
    axial, shear = (value(CHIMNEY, f"{part} force of chimney at chimney.start {event}") for part in ("axial", "shear"))
    x, y = (value(CHIMNEY, f"{side} reaction of foot {event}") for side in ("horizontal", "vertical"))
    along, across = (sin(angle), cos(angle)), (-cos(angle), sin(angle))
    assert axial == pytest.approx(-(x * along[0] + y * along[1]), rel=1e-12)
    assert shear == pytest.approx(x * across[0] + y * across[1], rel=1e-12)


def test_a_chimney_is_told_to_have_its_section_within_it() -> None:
    (answer,) = CHIMNEY.solve("bending moment of chimney at P").answers
    assert any("between chimney.start and chimney.end" in str(note) for note in answer.notes)


@pytest.mark.parametrize("question", ["axial force of rod at P", "tension of rod at P"])
def test_a_rod_that_is_driven_round_is_pulled_by_what_lies_further_out(question: str) -> None:
    system = fb.System.from_text("""
parameters: {m: 3 kg, L: 2 m, x: 0.6 m, omega: 20 rad/s}
bodies: {rod: {rod: {mass: m, length: L}, points: {P: [x - L/2, 0]}}}
connections: {foot: {pin: [ground.O, rod.start]}, drive: {driver: {measure: phi, follows: omega*t}}}
measures: {phi: angle of rod from right}
""")
    assert value(system, question) == pytest.approx(3 * 400 * (4 - 0.36) / 4, rel=1e-12)
    assert value(system, "bending moment of rod at P") == pytest.approx(
        0.0, abs=1e-12
    )  # the driver has no couple to give


def test_where_on_a_rod_the_couple_of_a_driver_acts_is_not_known() -> None:
    system = fb.System.from_text("""
parameters: {m: 3 kg, L: 2 m, x: 0.6 m, alpha: 2 rad/s^2}
bodies: {rod: {rod: {mass: m, length: L}, points: {P: [x - L/2, 0]}}}
connections: {foot: {pin: [ground.O, rod.start]}, drive: {driver: {measure: phi, follows: alpha*t^2/2}}}
measures: {phi: angle of rod from right}
""")
    (answer,) = system.solve("bending moment of rod at P").answers
    assert "couple of drive" in str(answer.reason)


def test_in_space_a_rod_is_pulled_as_in_the_plane() -> None:
    system = fb.System.from_text("""
space: true
parameters: {m: 3 kg, L: 2 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {guide: {weld: [ground.O, rod.start]}}
loads: {weight: {gravity: {strength: g, along: x}}}
""")
    assert value(system, "axial force of rod at center") == pytest.approx(3 * 9.81 / 2, rel=1e-12)


def test_the_pendulum_of_a_massless_rod_is_pulled_as_one_on_a_string() -> None:
    rod, string = (
        fb.System.from_text(f"""
parameters: {{m: 2 kg, L: 1 m, g: 9.81 m/s^2}}
bodies: {{bob: {{particle: {{mass: m}}}}{body}}}
connections: {{{joints}}}
loads: {{weight: {{gravity: g}}}}
measures: {{theta: angle of line from ground.O to bob from down}}
start: {{theta: 40 deg, rate(theta): 0}}
""")
        for body, joints in (
            (", arm: {rod: {length: L}}", "hinge: {pin: [ground.O, arm.start]}, knot: {pin: [arm.end, bob]}"),
            ("", "arm: {link: [ground.O, bob, L]}"),
        )
    )
    question = "tension of arm when theta = 0"
    assert value(rod, question) == pytest.approx(value(string, question), rel=1e-12)
    assert value(rod, question) == pytest.approx(2 * 9.81 * (3 - 2 * cos(2 * pi / 9)), rel=1e-12)


def test_a_question_of_a_section_has_its_own_letter() -> None:
    quantity = BEAM.question("shear force of beam at C").quantity
    assert isinstance(quantity, SectionForce)
    assert quantity.letter == "V"


def test_a_load_that_is_spread_somehow_over_a_rod_is_refused() -> None:
    text = CHIMNEY.to_yaml()
    assert "weight: {gravity: g}" in text
    air = "weight: {gravity: g}, air: {drag: {body: chimney, linear: 2 kg/s}}"
    (answer,) = (
        fb.System.from_text(text.replace("weight: {gravity: g}", air)).solve("axial force of chimney at P").answers
    )
    assert "air acts on all of chimney" in str(answer.reason)


def test_a_point_that_one_rod_alone_has_tells_the_rod() -> None:
    text = """
parameters: {F: 5 kN, a: 2 m, L: 6 m}
bodies: {beam: {beam: {length: L}, points: {C: [a - L/2, 0]}}}
connections: {A: {pin: [ground.A, beam.start]}, B: {roller: {pin: beam.end, along: right}}}
loads: {F: {force: {at: beam.C, along: down, magnitude: F}}}
"""
    found = fb.System.from_text(text).solve(["bending moment at C", "shear force just before C"]).answers
    assert [answer.value for answer in found] == pytest.approx([5000 * 2 * 4 / 6, 5000 * 4 / 6])


# -- where it is loaded most ------------------------------------------------------------------
SIMPLE = """
parameters: {L: 4 m, a: 1 m, q: 500 N/m, w: 300 N/m, P: 200 N}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L}, angle: 0, at: {start: [0, 0]}, points: {C: [a - L/2, 0], D: [L/2 - a, 0]}}}
connections: {left: {pin: [ground.A, beam.start]}, right: {slot: {pin: beam.end, along: right, through: ground.B}}}
"""
CLAMPED = """
parameters: {L: 2 m, a: 0.5 m, q: 300 N/m, P: 200 N, m: 20 kg, g: 9.81 m/s^2}
bodies: {beam: {rod: {length: L, mass: m}, angle: 0, at: {start: [0, 0]}, points: {C: [a - L/2, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
"""


@pytest.mark.parametrize(
    ("model", "loads", "moment", "place", "valid"),
    [
        # Source: Gere & Goodno, Mechanics of Materials, app. H; sec. 4.5
        pytest.param(
            SIMPLE,
            "it: {distributed: {between: [beam.start, beam.end], along: down, intensity: [0, w]}}",
            "w*L**2/(9*sqrt(3))",
            "L/sqrt(3)",
            (),
            id="rises",
        ),
        pytest.param(
            SIMPLE,
            "it: {force: {at: beam.C, along: down, magnitude: P}}",
            "P*a*(L - a)/L",
            "a",
            ("L > a (it is greatest there)",),
            id="between the supports",
        ),
        pytest.param(
            SIMPLE,
            "it: {distributed: {between: [beam.start, beam.C], along: down, intensity: q}}",
            "q*a**2*(2*L - a)**2/(8*L**2)",
            "a*(2*L - a)/(2*L)",
            ("L > a (it is greatest there)",),
            id="over a part",
        ),
        pytest.param(
            SIMPLE,
            "q: {distributed: {between: [beam.start, beam.end], along: down, intensity: q}}, "
            "it: {force: {at: beam.C, along: down, magnitude: P}}",
            "(q*L/2 + P*a/L)**2/(2*q)",
            "L/2 - P*a/(q*L)",
            ("a < L²·q/(2·(L·q + P)) (it is greatest there)",),
            id="even load and a force beside the middle",
        ),
        pytest.param(
            CLAMPED,
            "w: {gravity: g}, it: {force: {at: beam.C, along: up, magnitude: P}}",
            "m*g*(L - a)**2/(2*L)",  # by the weight beyond it; m g L/2 - P a at the clamp is less
            "a",
            None,
            id="clamped, pulled up",
        ),
    ],
)
def test_the_greatest_bending_moment_is_that_of_the_tables(
    model: str, loads: str, moment: str, place: str, valid: tuple[str, ...] | None
) -> None:
    system = fb.System.from_text(f"{model}loads: {{{loads}}}")
    asked = ["greatest bending moment of beam", "place of the greatest bending moment of beam"]
    size, at = system.solve(asked).answers
    numbers = {name: p.value for name, p in system.parameters.items()} | {"sqrt": sqrt}
    assert size.value == pytest.approx(eval(moment, numbers.copy()), rel=1e-12)
    assert at.value == pytest.approx(eval(place, numbers.copy()), rel=1e-12, abs=1e-12)
    if valid is not None:
        assert tuple(map(str, size.conditions)) == (valid or ("for all positive parameters",))


@pytest.mark.parametrize("seed", range(4))
def test_the_greatest_of_many_sections_governs(seed: int) -> None:
    # loads of any kind at places drawn at random; the sections by hand, on a fine grid
    draw = Random(seed)
    L, W, q, P = 4.0, 50.0, draw.uniform(100, 400), draw.uniform(100, 800)
    a, b = sorted(draw.uniform(0.2, 3.8) for _ in range(2))
    way, up = draw.choice([("down", -1.0), ("up", 1.0)])
    system = fb.System.from_text(f"""
parameters: {{L: {L} m, a: {a} m, b: {b} m, q: {q} N/m, P: {P} N, W: {W} N, g: 10 m/s^2}}
ground: {{points: {{A: [0, 0], B: [L, 0]}}}}
bodies:
  beam: {{rod: {{mass: W/g, length: L}}, angle: 0, at: {{start: [0, 0]}}, points: {{C: [a - L/2, 0], D: [b - L/2, 0]}}}}
connections:
  left: {{pin: [ground.A, beam.start]}}
  right: {{slot: {{pin: beam.end, along: right, through: ground.B}}}}
loads:
  weight: {{gravity: g}}
  sand: {{distributed: {{between: [beam.C, beam.D], along: down, intensity: [q, 2*q]}}}}
  push: {{force: {{at: beam.C, along: {way}, magnitude: P}}}}
""")
    x = np.union1d(np.linspace(0.0, L, 200_001), [a, b])
    s = np.clip(x - a, 0.0, b - a)  # of the load that rises from q to 2 q
    sand, moment_of_sand = q * s + q * s**2 / (2 * (b - a)), q * s**2 / 2 + q * s**3 / (6 * (b - a))
    moment_of_sand += np.where(x > b, sand * (x - b), 0.0)
    push = up * P * (x >= a)
    A = (W * L / 2 + moment_of_sand[-1] - up * P * (L - a)) / L
    shear = A - W * x / L - sand + push
    moment = A * x - W * x**2 / (2 * L) - moment_of_sand + push * (x - a)
    asked = ["greatest bending moment", "greatest shear force", "place of the greatest bending moment of beam"]
    most, force, at = system.solve(asked).answers
    assert all(one.expression is not None for one in (most, force, at)), most.reason
    assert most.value == pytest.approx(np.abs(moment).max(), rel=1e-8)
    assert force.value == pytest.approx(np.abs(shear).max(), rel=1e-4)  # it jumps between two sections
    assert at.value == pytest.approx(x[np.abs(moment).argmax()], abs=1e-3)


def test_a_rod_that_turns_on_a_pin_is_pulled_most_at_it() -> None:
    # by what lies beyond: m w^2 (L - b)^2/(2 L)
    system = fb.System.from_text("""
parameters: {L: 2 m, m: 3 kg, n: 10 rad/s, b: 0.5 m}
bodies: {bar: {rod: {length: L, mass: m}, points: {O: [b - L/2, 0]}}}
connections: {hub: {pin: [ground.A, bar.O]}}
measures: {phi: angle of bar}
start: {phi: 0, rate(phi): n}
""")
    pull, at = system.solve(["greatest axial force", "place of the greatest axial force"]).answers
    assert pull.value == pytest.approx(3 * 100 * 1.5**2 / 4, rel=1e-12)
    assert at.value == pytest.approx(0.5)
    assert "L ≥ 2·b (it is greatest there)" in map(str, pull.conditions)


def test_how_large_a_load_may_be_follows_from_the_greatest_bending_moment() -> None:
    # w = 9 sqrt(3) M/L^2
    system = fb.System.from_text(
        SIMPLE + "loads: {it: {distributed: {between: [beam.start, beam.end], along: down, intensity: [0, w]}}}"
    )
    (answer,) = system.solve("value of w for which greatest bending moment of beam = 500 N m").answers
    assert answer.value == pytest.approx(9 * sqrt(3) * 500 / 16, rel=1e-12)


def test_where_the_numbers_are_missing_that_tell_which_section_governs_it_is_not_told() -> None:
    system = fb.System.from_text(
        SIMPLE.replace("P: 200 N", "P: {unit: N}")
        + "loads: {q: {distributed: {between: [beam.start, beam.end], along: down, intensity: q}}, "
        "it: {force: {at: beam.C, along: down, magnitude: P}}}"
    )
    (answer,) = system.solve("greatest bending moment").answers
    assert answer.expression is None
    assert "not all of them are given" in str(answer.reason)


def test_the_derivation_of_the_greatest_bending_moment_cuts_the_rod_there() -> None:
    text = (CHIMNEY.explain("greatest bending moment of chimney")).to_text()
    assert "There is no derivation" not in text
    assert "L/3 from chimney.start" in text


def test_a_couple_that_acts_at_a_point_of_a_beam_jumps_in_the_bending_moment_there_alone() -> None:
    """A couple M0 at the middle of a beam on two supports: V = M0/L, M = +-M0/2 beside the middle."""
    text = """
parameters: {L: 4 m, M0: 6 kN m}
ground: {points: {A: [0, 0]}}
bodies: {beam: {rod: {length: L}, at: {start: A}, angle: 0, points: {C: [0, 0], D: [L/4, 0]}}}
connections: {left: {pin: [A, beam.start]}, right: {roller: {at: beam.end, along: right}}}
loads: {couple: {torque: {on: beam.C, magnitude: M0}}}
"""
    system = fb.System.from_text(text)
    assert value(system, "bending moment of beam just before C") == pytest.approx(3e3)
    assert value(system, "bending moment of beam just behind C") == pytest.approx(-3e3)
    assert value(system, "bending moment of beam at D") == pytest.approx(-1.5e3)
    assert value(system, "shear force of beam at C") == pytest.approx(1.5e3)
    plain = fb.System.from_text(text.replace("beam.C", "beam"))
    (answer,) = plain.solve("bending moment of beam at D").answers
    assert "a torque may name its point, on: beam.C" in str(answer.reason)
