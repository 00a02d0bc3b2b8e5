"""What is handed out, continued: what a sheet has to tell, what has been found already, and what is short enough."""

from __future__ import annotations

from functools import cache

import pytest

import freebody as fb
from freebody.narrative.lines.script import NumberedFormula
from freebody.narrative.sheets.statement import ExerciseStatement
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Report
from freebody.present.report.formats.terminal import terminal_text
from freebody.system.symbols import reaction_symbols
from freebody.system.system import System


def stated(text: str, language: str = "en") -> str:
    """The statement of an exercise without its picture."""
    statement = ExerciseStatement(System.from_text(text), Catalogue(language), 1, 1)
    return " ".join(terminal_text(Report("", language, "", statement.model(is_bare=False)[1:], {})).split())


@cache
def told(text: str, language: str = "en") -> str:
    return " ".join(fb.explain(System.from_text(text), language=language).to_text().split())


BELL = """
space: true
parameters: {m: 60 kg, R: 0.3 m, r: 0.18 m, h: 0.4 m, g: 9.81 m/s^2}
bodies: {bell: {frustum: {mass: m, radius: R, top_radius: r, height: h}}}
connections: {pivot: {revolute: {first: ground.O, second: bell.top, about: x}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of bell about x}
questions: [acceleration of phi]
"""
WEDGE = """
parameters: {M: 5 kg, alpha: 30 deg, L: 2 m, F: 3 N}
ground: {lines: {floor: {along: right}}}
bodies: {wedge: {wedge: {mass: M, angle: alpha, length: L}}}
connections: {slide: {slider: {body: wedge.base, along: floor}}}
loads: {push: {force: {at: wedge.base, along: right, magnitude: F}}}
measures: {x: x of wedge}
questions: [acceleration of x]
"""


def test_a_sheet_tells_every_size_that_the_file_gives() -> None:
    assert "radius R, top radius r, height h" in stated(BELL)
    assert "angle of slope α, length L" in stated(WEDGE)
    assert "Neigungswinkel α, Länge L" in stated(WEDGE, "de")


CRATES = """
parameters: {m1: 4 kg, m2: 6 kg, v0: 5 m/s, d: 2 m, mu: 0.2, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {A: {particle: {mass: m1}, at: [0, 0]}, B: {particle: {mass: m2}, at: [d, 0]}}
connections:
  floor_A: {contact: {between: [A, floor], friction: mu}}
  floor_B: {contact: {between: [B, floor], friction: mu}}
  bump: {stop: {measure: gap, min: 0}}
loads: {weight: {gravity: g}}
measures: {x1: x of A, x2: x of B, gap: {expression: x2 - x1}}
start: {x1: 0, rate(x1): v0, x2: d, rate(x2): 0}
questions: [x2 when rate(x2) = 0]
"""


def test_what_meets_on_the_way_and_does_not_rebound_is_said_so() -> None:
    """The floors are touched all the time: of them nothing has to be said."""
    assert "Impacts of bump are perfectly plastic" in stated(CRATES)
    assert "Stöße von bump sind vollkommen plastisch" in stated(CRATES, "de")
    assert "plastic" not in stated(CRATES.replace("min: 0", "min: 0, restitution: 0.4"))


def test_a_coefficient_says_what_it_is() -> None:
    assert "μ = 0.2 (coefficient of friction)" in stated(CRATES)
    two = CRATES.replace("friction: mu}}\n  floor_B", "friction: nu}}\n  floor_B").replace(
        "mu: 0.2", "mu: 0.2, nu: 0.1"
    )
    assert "μ = 0.2 (coefficient of friction of floor B)" in stated(two)


def test_the_result_is_written_for_what_was_asked() -> None:
    """Both crates lie at one place then: x2 = x1, and x1 alone is no answer."""
    assert "x₂ = x₁ = " in told(CRATES)


PLANETS = """
parameters: {r_S: 0.03 m, r_P: 0.02 m, J_S: 2 g m^2, J_C: 5 g m^2, m_P: 0.2 kg, J_P: 0.04 g m^2, T_S: 3 N m}
ground: {points: {S: [0, 0]}}
bodies:
  sun: {body: {inertia: J_S, radius: r_S}}
  planet: {body: {mass: m_P, inertia: J_P, radius: r_P}, copies: 2}
  carrier: {body: {inertia: J_C}, points: {P: [0, r_S + r_P]}}
  ring: {ring: {radius: r_S + 2*r_P}, at: [0, 0], fixed: true}
connections:
  sun_bearing: {pin: [ground.S, sun]}
  carrier_bearing: {pin: [ground.S, carrier]}
  axle: {pin: [carrier.P, planet]}
  inner: {gear_mesh: [sun, planet]}
  outer: {gear_mesh: {first: ring, second: planet, internal: true}}
loads: {drive: {torque: {on: sun, magnitude: T_S}}}
measures: {phi: angle of sun}
questions: [acceleration of phi]
"""


def test_copies_are_described_as_the_body_that_is_written() -> None:
    assert "planet, planet 2 (rigid body, mass m_P, radius r_P" in stated(PLANETS)


def test_the_couple_of_a_copy_is_named_by_the_copy() -> None:
    names = {
        symbol.name for symbol in reaction_symbols(System.from_text(PLANETS.replace("copies: 2", "copies: 3"))).values()
    }
    assert {"M_inner_planet_2", "M_inner_planet_3"} <= names
    assert not any("alike" in name for name in names)


def written_out(text: str) -> str:
    """With both planets written, each with its own axle on the carrier."""
    twice = {
        "planet: {body: {mass: m_P, inertia: J_P, radius: r_P}, copies: 2}": "P{k}: {body: {mass: m_P, inertia: J_P, "
        "radius: r_P}}",
        "axle: {pin: [carrier.P, planet]}": "axle{k}: {pin: [carrier.C{k}, P{k}]}",
        "inner: {gear_mesh: [sun, planet]}": "inner{k}: {gear_mesh: [sun, P{k}]}",
        "outer: {gear_mesh: {first: ring, second: planet, internal: true}}": "outer{k}: {gear_mesh: {first: ring, "
        "second: P{k}, internal: true}}",
    }
    for one, other in twice.items():
        text = text.replace(one, "\n  ".join(other.replace("{k}", k) for k in "12"))
    return text.replace("points: {P: [0, r_S + r_P]}", "points: {C1: [0, r_S + r_P], C2: [0, -r_S - r_P]}")


def test_pins_of_opposite_planets_do_not_push_the_same_way() -> None:
    """Their reactions are not unique, so no numbers say that they are alike: by symmetry they are opposite, and only
    what has no fixed direction may be taken for equal. Lagrange's equations do without them."""
    (derivation,) = fb.explain(System.from_text(written_out(PLANETS))).derivations
    assert not derivation.reason
    assert "stage.lagrange" in [stage.title.key for stage in derivation.stages]


SPOOL = """
parameters: {m: 2 kg, k: 0.08 m, R: 0.12 m, r: 0.06 m, F: 5 N, mu: 0.4, g: 9.81 m/s^2}
ground: {lines: {table: {along: right}}}
bodies: {spool: {body: {mass: m, inertia: m*k^2, radius: R}, at: [0, R]}}
connections: {contact: {contact: {between: [spool, table], friction: mu}}}
loads:
  weight: {gravity: g}
  pull: {force: {at: spool.center, along: right, magnitude: F}}
  moment: {torque: {on: spool, magnitude: F*r}}
measures: {x: x of spool, phi: angle of spool clockwise}
start: {x: 0, rate(x): 0, phi: 0, rate(phi): 0}
questions: [acceleration of x]
"""


def test_neither_a_condition_nor_a_result_is_derived_twice() -> None:
    """That it rolls is looked at by its friction, for which the acceleration is found: it is the answer then."""
    (derivation,) = fb.explain(System.from_text(SPOOL)).derivations
    assert not derivation.reason
    keys = [stage.title.key for stage in derivation.stages]
    assert "stage.conditions" not in keys
    assert keys.count("stage.principles") == 1
    *_, result = (i for s in derivation.stages for i in s.items if isinstance(i, NumberedFormula))
    assert result.why is not None
    assert result.why.key == "value.follows"
    assert "μ ≥" in told(SPOOL)


BAR = """
parameters: {m: 6 kg, L: 1.2 m, k: 800 N/m, c: 60 N s/m}
ground: {points: {A: [0, 0], S: [L, -0.5 m], D: [L/2, -0.5 m]}}
bodies: {bar: {rod: {mass: m, length: L}, angle: 0, at: {start: [0, 0]}}}
connections: {hinge: {pin: [ground.A, bar.start]}}
loads:
  spring: {spring: {between: [ground.S, bar.end], stiffness: k, length: 0.5 m}}
  damper: {damper: {between: [ground.D, bar.center], damping: c}}
measures: {phi: angle of bar}
questions: [natural frequencies, damping ratio]
"""


def test_of_a_long_equation_of_motion_small_motions_need_the_first_order_alone() -> None:
    """M = m L^2/3, C = c L^2/4 and K = k L^2: on paper nobody writes how the spring turns with the bar."""
    found = fb.explain(System.from_text(BAR))
    assert [d.reason for d in found.derivations] == ["", ""]
    assert max(map(len, found.to_text().splitlines())) < 110
    assert "sin(φ)" not in found.to_text()
    assert "ζ = " in found.to_text()


PUSHED = """
parameters: {F: 100 N, mu: 0.3, v0: 2 m/s}
ground: {lines: {floor: {along: right}}}
bodies: {A: {particle: {mass: 4 kg}, at: [0, 0]}}
connections: {floor: {contact: {between: [A, floor], friction: mu}}}
loads: {weight: {gravity: 9.81 m/s^2}, push: {force: {at: A, along: 20 deg, magnitude: F}}}
measures: {x: x of A}
start: {x: 0, rate(x): v0}
questions: [acceleration of x]
"""


@pytest.mark.parametrize(("language", "bound"), [("en", "F ≤ 114.7 N"), ("de", "F ≤ 114,7 N")])
def test_a_bound_in_numbers_has_its_unit(language: str, bound: str) -> None:
    """N = 4 kg g - F sin 20° vanishes at 39.24 N/0.34202."""
    assert bound in told(PUSHED, language)


BACK_SPIN = """
parameters: {m: 1 kg, r: 0.1 m, v0: 2 m/s, w0: 100 1/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}, at: [0, r]}}
connections: {floor: {contact: {between: [ball, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, turn: angle of ball clockwise}
start: {x: 0, rate(x): v0, turn: 0, rate(turn): -w0}
questions: [x when rate(x) = 0]
"""


def test_what_would_end_a_phase_before_is_said_in_full() -> None:
    assert "The slip of floor ends later than" in told(BACK_SPIN)
    assert "Dass das Gleiten von floor endet, darf erst nach" in told(BACK_SPIN, "de")


def test_a_reaction_is_one_at_a_joint() -> None:
    beam = """
parameters: {L: 3 m, P: 900 N}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L}, angle: 0, at: {start: [0, 0]}}}
connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.end, through: ground.B, along: right}}}
loads: {load: {force: {at: beam.center, along: down, magnitude: P}}}
questions: [reaction of A along up, bending moment of beam at center]
"""
    assert "components of the reaction at A" in told(beam)
    assert "Reaction at A upwards" in told(beam)
    assert "Reaktionskraft in A nach oben" in told(beam, "de")
    assert "The bending moment, positive where" in told(beam)


BRAKE = """
parameters: {R: 0.2 m, a: 0.3 m, c: 0.05 m, L: 0.9 m, mu: 0.4, T: 50 N m, F: 200 N}
ground: {points: {O: [a, 0], A: [0, R + c]}}
bodies:
  drum: {disk: {mass: 4 kg, radius: R}}
  lever:
    rod: {length: L}
    angle: 0
    at: {start: [0, R + c]}
    lines: {face: {along: left, through: [0, -c]}}
connections:
  axle: {pin: [ground.O, drum]}
  pivot: {pin: [ground.A, lever.start]}
  block: {contact: {between: [drum, lever.face], friction: mu}}
loads:
  hand: {force: {at: lever.end, along: down, magnitude: F}}
  drive: {torque: {on: drum, magnitude: T}}
questions: [range of T that keeps it at rest]
"""


def test_a_limit_that_is_negative_is_derived_as_well() -> None:
    """N = F L/(a -+ c mu) and T = mu N R either way: (a + c mu) T + R L mu F = 0 has one sign for positive T, and yet
    it is what vanishes at the lower limit."""
    (derivation,) = fb.explain(System.from_text(BRAKE)).derivations
    assert not derivation.reason
    assert "Beyond this limit equilibrium is lost only if: a > c⋅μ" in told(BRAKE)
