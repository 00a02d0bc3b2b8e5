"""Strings and bands that slide round drums: the tensions differ by e^(mu beta)."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest

import freebody as fb
from freebody.study.friction.answers import prepared

Agree = Callable[[fb.Solution, str, str | list[str]], None]

CAPSTAN = """
parameters: {M: 50 kg, R: 0.1 m, mu: 0.3, F: 250 N, alpha: 30 deg, g: 9.81 m/s^2}
bodies:
  drum: {disk: {radius: R}, at: [0, 0], fixed: true}
  hand: {particle: {}}
  load: {particle: {mass: M}}
connections:
  rope: {string: {from: hand, over: [drum], to: load, friction: {drum: mu}, MORE}}
loads: {weight: {gravity: g}, pull: {force: {at: hand, along: DOWN, magnitude: F}}}
"""
HALF_TURN = CAPSTAN.replace(", MORE", "").replace("DOWN", "down")
SLANTED = CAPSTAN.replace("MORE", "leads: [alpha, down]").replace("DOWN", "against alpha")
THREE_TURNS = CAPSTAN.replace("MORE", "wrap: {drum: 6*pi}").replace("DOWN", "down")

# a drum that turns on an axle with a brake; the belt slides on it where the brake holds
BRAKED = """
parameters: {M: 20 kg, I: 0.5 kg m^2, R: 0.2 m, mu: 0.3, F: 150 N, B: 100 N m, g: 9.81 m/s^2}
bodies:
  drum: {disk: {radius: R, inertia: I}}
  hand: {particle: {}}
  load: {particle: {mass: M}}
connections:
  axle: {pin: [ground.O, drum]}
  brake: {brake: {between: [drum, ground], torque: B}}
  rope: {string: {from: hand, over: [drum], to: load, friction: {drum: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: hand, along: down, magnitude: F}}}
"""

BAND = """
parameters: {m: 5 kg, R: 0.2 m, mu: 0.3, T: 40 N m, F: 120 N, a: 0.1 m, L: 0.6 m}
ground: {points: {axle: [0, 0], anchor: [-R, -2*R], hinge: [R - a, -2*R]}}
bodies:
  drum: {disk: {mass: m, radius: R}}
  lever: {rod: {length: L}, at: {start: [R - a, -2*R]}, angle: 0, points: {band: [a - L/2, 0]}}
connections:
  axle: {pin: [ground.axle, drum]}
  hinge: {pin: [ground.hinge, lever.start]}
  band: {string: {from: ground.anchor, over: [drum], to: lever.band, friction: {drum: mu}, leads: [up, down]}}
loads: {push: {force: {at: lever.end, along: down, magnitude: F}}, drive: {torque: {on: drum, magnitude: T}}}
"""


def asked(model: str, question: str) -> fb.Solution:
    return fb.solve(fb.System.from_text(model), question)


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # Euler and Eytelwein: W e^(-mu beta) <= F <= W e^(mu beta)
        (HALF_TURN, "range of F that keeps it at rest", ["M*g*exp(-mu*pi)", "M*g*exp(mu*pi)"]),
        (HALF_TURN, "largest M so that it stays at rest", "F*exp(mu*pi)/g"),
        (HALF_TURN, "least mu so that it stays at rest", "log(M*g/F)/pi"),
        (THREE_TURNS, "range of F that keeps it at rest", ["M*g*exp(-6*pi*mu)", "M*g*exp(6*pi*mu)"]),
        # up a slope at alpha, over the drum, down: the string turns by alpha + 90 deg
        (
            SLANTED,
            "range of F that keeps it at rest",
            ["M*g*exp(-mu*(alpha + pi/2))", "M*g*exp(mu*(alpha + pi/2))"],
        ),
        # the brake is strong: the rope slips first; the drum takes the difference of the tensions
        (BRAKED, "range of F that keeps it at rest", ["M*g*exp(-mu*pi)", "M*g*exp(mu*pi)"]),
        # the brake is weak: the drum turns with the rope, (F - M g) R = B
        (
            BRAKED.replace("B: 100 N m", "B: 10 N m"),
            "range of F that keeps it at rest",
            ["M*g - B/R", "M*g + B/R"],
        ),
        # moments about the hinge: band force F L/a at the lever; the other side is e^(mu pi) times smaller, or larger
        (
            BAND,
            "range of T that keeps it at rest",
            ["-R*F*L/a*(exp(mu*pi) - 1)", "R*F*L/a*(1 - exp(-mu*pi))"],
        ),
        (BAND, "least F so that it stays at rest", "T*a/(R*L*(1 - exp(-mu*pi)))"),
    ],
)
def test_limit_is_that_of_belt_friction(model: str, question: str, expected: str | list[str], agrees: Agree) -> None:
    agrees(asked(model, question), "q1", expected)


def test_the_two_tensions_differ_by_the_friction_on_the_drum() -> None:
    found = fb.statics(fb.System.from_text(HALF_TURN))
    after = next(r for r in found.reactions if r.reaction == "tension")
    friction = next(r for r in found.reactions if r.reaction == "friction force")
    assert after.low == pytest.approx(50 * 9.81)
    assert after.low - friction.low == pytest.approx(250.0)
    assert friction.used == pytest.approx((50 * 9.81 - 250) / (50 * 9.81 * (1 - math.exp(-0.3 * math.pi))))


def test_the_string_pulls_at_the_drum_by_both_tensions() -> None:
    # the axle carries F + M g, the brake (M g - F) R
    found = fb.statics(fb.System.from_text(BRAKED))
    by_name = {r.name: r.low for r in found.reactions}
    assert by_name["axle.y"] == pytest.approx(20 * 9.81 + 150.0)
    assert abs(by_name["brake.torque"]) == pytest.approx((20 * 9.81 - 150) * 0.2)


def test_a_band_lies_over_the_drum_from_the_side_where_its_ends_are() -> None:
    """A lever that the file puts by its start: its other point is at start + (2 R, 0), so that the band comes from the
    left. The drum turns to the left and drags the band away from the lever, whose run is the tight one: with
    S = F L/(2 R) there, R S (1 - e^(-mu pi)) brakes."""
    text = """
parameters: {J: 0.4 kg m^2, R: 0.15 m, mu: 0.35, F: 80 N, L: 0.9 m, w: 30 rad/s}
ground: {points: {axle: [0, 0], hinge: [-R, -2*R]}}
bodies:
  drum: {body: {inertia: J, radius: R}}
  lever: {rod: {length: L}, at: {start: [-R, -2*R]}, angle: 0, points: {band: [2*R - L/2, 0]}}
connections:
  axle: {pin: [ground.axle, drum]}
  hinge: {pin: [ground.hinge, lever.start]}
  band: {string: {from: ground.hinge, over: [drum], to: lever.band, friction: {drum: mu}, leads: [up, down]}}
loads: {push: {force: {at: lever.end, along: down, magnitude: F}}}
measures: {phi: {angle of drum}}
start: {phi: 0, rate(phi): w}
"""
    expected = -80 * 0.9 / 2 * (1 - math.exp(-0.35 * math.pi)) / 0.4
    assert asked(text, "acceleration of phi").answers[0].value == pytest.approx(expected)


def test_both_ways_round_are_mirror_images() -> None:
    other = HALF_TURN.replace("from: hand, over: [drum], to: load", "from: load, over: [drum], to: hand")
    one, two = (asked(model, "range of F that keeps it at rest")["q1"].value for model in (HALF_TURN, other))
    assert one == pytest.approx(two, rel=1e-12)


@pytest.mark.parametrize("sign", [-1, 1])
def test_slip_begins_where_the_ratio_of_tensions_is_reached(sign: int) -> None:
    ends = prepared(fb.System.from_text(HALF_TURN)).parameter("F")
    for draw in ends.draws[:5]:
        edge = ends.edge(draw, sign, None)
        assert edge is not None
        v = draw.values
        assert edge.value == pytest.approx(v["M"] * v["g"] * math.exp(sign * v["mu"] * math.pi), rel=1e-12)


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        (("friction: {drum: mu}", "friction: {dru: mu}"), "does not slide over dru. Did you mean drum"),
        (("friction: {drum: mu}", "friction: {drum: -0.1}"), "friction is negative"),
        (("from: hand", "swings: true, from: hand"), "the angle of wrap on drum changes"),
    ],
)
def test_friction_that_cannot_be_is_told(change: tuple[str, str], problem: str) -> None:
    with pytest.raises(fb.ModelError, match=problem):
        fb.System.from_text(HALF_TURN.replace(*change))


def test_a_string_without_friction_is_as_it_was() -> None:
    plain = fb.System.from_text(HALF_TURN.replace(", friction: {drum: mu}", ""))
    assert plain.dry_friction == ()
    assert [row.name for row in plain.constraint_rows] == [
        row.name for row in fb.System.from_text(HALF_TURN).constraint_rows
    ]


# over a pulley that the rope grips, then over a rough peg: three stretches
PULLEY_AND_PEG = """
parameters: {M: 50 kg, J: 0.2 kg m^2, R: 0.1 m, mu: 0.3, F: 400 N, g: 9.81 m/s^2}
ground: {points: {axle: [0, 0], peg: [1 m, 0.1 m]}}
bodies:
  wheel: {disk: {radius: R, inertia: J}}
  load: {particle: {mass: M}}
  hand: {particle: {}}
connections:
  axle: {pin: [ground.axle, wheel]}
  rope:
    string: {path: [load, over wheel, ground.peg, hand], friction: {ground.peg: mu}, leads: [up, right, down]}
loads: {weight: {gravity: g}, pull: {force: {at: hand, along: down, magnitude: F}}}
"""


@pytest.mark.parametrize(
    ("model", "place", "expected"),
    [
        (HALF_TURN, "at hand", "F"),
        (HALF_TURN, "between hand and drum", "F"),
        (HALF_TURN, "at load", "M*g"),
        (HALF_TURN.replace("from: hand, over: [drum], to: load", "from: load, over: [drum], to: hand"), "at hand", "F"),
        (
            HALF_TURN.replace("from: hand, over: [drum], to: load", "from: load, over: [drum], to: hand"),
            "at load",
            "M*g",
        ),
        # what is anchored has the band force of the lever less the torque by the radius
        (BAND, "at ground", "F*L/a - T/R"),
        (BAND, "at ground.anchor", "F*L/a - T/R"),
        (BAND, "at lever", "F*L/a"),
        (PULLEY_AND_PEG, "at load", "M*g"),
        (PULLEY_AND_PEG, "between wheel and ground.peg", "M*g"),
        (PULLEY_AND_PEG, "at hand", "F"),
    ],
)
def test_the_tension_at_a_place_is_that_of_the_stretch_that_ends_there(
    model: str, place: str, expected: str, agrees: Agree
) -> None:
    name = "band" if model == BAND else "rope"
    agrees(asked(model, f"tension of {name} {place}"), "q1", expected)


def test_a_rope_that_slides_is_tighter_by_the_factor_of_euler() -> None:
    # the load is so heavy that the rope slides: F at the hand, F e^(mu pi) at the load
    solution = fb.solve(fb.System.from_text(HALF_TURN.replace("F: 250 N", "F: 100 N")), "tension of rope at load")
    assert solution["q1"].value == pytest.approx(100 * math.exp(0.3 * math.pi))
    assert solution.phases is not None
    forces = {name for case in solution.phases.cases for phase in case.phases for name, _force in phase.forces}
    assert {"tension of rope between hand and drum", "tension of rope between drum and load"} <= forces


def test_a_tension_that_is_not_one_is_asked_for_by_its_place() -> None:
    with pytest.raises(fb.ModelError, match=r"several values of tension.*hand - drum; drum - load"):
        asked(HALF_TURN, "tension of rope at drum")


def test_without_a_place_each_tension_of_a_rope_is_asked_for() -> None:
    found = [question.understood for question in fb.System.from_text(HALF_TURN).asked("tension of rope")]
    assert found == ["tension of rope at hand", "tension of rope at load"]


MASSLESS = BAND.replace("disk: {mass: m, radius: R}", "disk: {radius: R}")


@pytest.mark.parametrize(
    ("question", "expected"),
    [
        ("range of T that keeps it at rest", ["-R*F*L/a*(exp(mu*pi) - 1)", "R*F*L/a*(1 - exp(-mu*pi))"]),
        ("least F so that it stays at rest", "T*a/(R*L*(1 - exp(-mu*pi)))"),
    ],
)
def test_the_mass_of_the_drum_does_not_matter_at_rest(question: str, expected: str | list[str], agrees: Agree) -> None:
    agrees(asked(MASSLESS, question), "q1", expected)


def test_a_massless_drum_without_friction_resists_no_torque() -> None:
    smooth = MASSLESS.replace(", friction: {drum: mu}", ", grips: []")
    found = fb.statics(fb.System.from_text(smooth))
    assert not found.holds
    assert "drum" in found.fails


def test_a_massless_drum_passes_on_no_more_than_its_brake_holds() -> None:
    # a drum without a brake turns: both tensions are the same, F = M g
    free = BRAKED.replace("disk: {radius: R, inertia: I}", "disk: {radius: R}").replace(
        "  brake: {brake: {between: [drum, ground], torque: B}}\n", ""
    )
    assert not fb.statics(fb.System.from_text(free)).holds
    assert fb.statics(fb.System.from_text(free.replace("F: 150 N", "F: 196.2 N"))).holds


def test_the_tension_at_the_hand_has_a_derivation_with_both_limits_of_friction() -> None:
    # friction carries -(e^(mu pi) - 1) T <= phi <= (1 - e^(-mu pi)) T, so that T = M g need not be above F
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "capstan.yaml")
    (derivation,) = system.explain("tension of rope at hand").derivations
    assert derivation.reason == ""
    assert derivation.answer.to_plain()["expression"] == "F"


def test_a_block_pulled_over_a_rough_drum_accelerates() -> None:
    # T2 = T1 exp(mu2 pi/2) on the weight's side: M g - T2 = M a, T1 - mu1 m g = m a
    system = fb.System.from_text("""
parameters: {m: 10 kg, M: 6 kg, R: 0.08 m, mu1: 0.4, mu2: 0.25, g: 9.81 m/s^2}
ground: {lines: {table: {along: right}}}
bodies:
  block: {particle: {mass: m}, at: [-1 m, 0]}
  drum: {disk: {radius: R}, at: [0, -R], fixed: true}
  weight: {particle: {mass: M}}
connections:
  table: {contact: {between: [block, ground.table], friction: mu1}}
  rope: {string: {from: block, over: [drum], to: weight, friction: {drum: mu2}, leads: [right, down]}}
loads: {gravity: {gravity: g}}
measures: {x: x of block}
""")
    answer = system.solve("acceleration of x").answers[0]
    e = math.exp(0.25 * math.pi / 2)
    assert answer.value == pytest.approx(9.81 * (6 - 0.4 * 10 * e) / (6 + 10 * e))


TACKLE = """
parameters: {m: 100 kg, r: 0.1 m, F: 300 N, eta: 0.9, g: 9.81 m/s^2}
bodies: {upper: {disk: {radius: r}}, load: {particle: {mass: m}}, hand: {particle: {mass: 0}}}
connections:
  axle: {pin: [ground.top, upper]}
  rope: {string: {from: hand, over: [upper], to: load, falls: 3, efficiency: eta}}
loads: {gravity: {gravity: g}, pull: {force: {at: hand, along: down, magnitude: F}}}
"""


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("falls: 3", "falls: 2.5", "falls is how many times"),
        ("falls: 3", "falls: eta", "falls is how many times"),
        ("efficiency: eta", "efficiency: 1.2", "lies above 0 and is 1 at most"),
        ("over: [upper], ", "", "it runs over none"),
        ("disk: {radius: r}", "disk: {mass: 2 kg, radius: r}", "leave the mass of upper out"),
        ("efficiency: eta", "efficiency: eta, friction: 0.2", "not both"),
        ("from: hand, over: [upper], to: load", "path: [hand, wound on upper]", "falls run to a block"),
    ],
)
def test_what_no_tackle_can_have_is_refused(old: str, new: str, says: str) -> None:
    with pytest.raises(fb.ModelError, match=says):
        fb.System.from_text(TACKLE.replace(old, new))


def test_a_tackle_of_one_fall_is_a_sheave_with_its_efficiency(agrees: Agree) -> None:
    one = TACKLE.replace("falls: 3, ", "")
    agrees(asked(one, "range of F that keeps it at rest"), "q1", ["m*g*eta", "m*g/eta"])


def test_the_solution_of_a_tackle_speaks_of_its_sheaves() -> None:
    text = str(fb.System.from_text(TACKLE).explain("range of F that keeps it at rest"))
    assert "lets the tension fall by its efficiency" in text
    assert "Eytelwein" not in text
