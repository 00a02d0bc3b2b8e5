"""Whether something happens in a motion: the verdict, what it depends on, and that simulated motions agree.

A crate on a truck that is braked by B slips where B/(M + m) > mu g; a particle on a dome of radius R leaves it at
cos(phi) = 2/3, from rest at the top; a load on an elastic cord of length L that is let go at its upper end stretches it
by d with m g (L + d) = k d^2/2.
"""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.errors import ModelError
from posed import is_derived, posed

TRUCK = """
parameters: {M: 3000 kg, m: 20 kg, mu: 0.4, B: 9 kN, v0: 10 m/s, g: 9.81 m/s^2}
ground: {lines: {road: {along: right}}}
bodies:
  truck: {particle: {mass: M}, at: [0, 0], velocity: [v0, 0], lines: {deck: {along: right}}}
  crate: {particle: {mass: m}, at: [0, 0], velocity: [v0, 0]}
connections:
  road: {slider: {body: truck, along: right}}
  bed: {contact: {between: [crate, truck.deck], friction: mu}}
loads: {weight: {gravity: g}, brakes: {force: {at: truck, along: left, magnitude: B}}}
measures: {x: {x of truck}, s: {x of crate}}
"""
DOME = """
parameters: {m: 1 kg, R: 2 m, b: 1 deg, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: m}}}
connections: {dome: {link: {between: [ground.O, bead], length: R, pushes: true}}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of line from ground.O to bead from up clockwise}}
start: {phi: b, rate(phi): 0}
"""
SPOOL = """
parameters: {m: 3 kg, J: 0.02 kg m^2, R: 0.2 m, r: 0.1 m, F: 10 N, b: 40 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {spool: {body: {mass: m, inertia: J}, at: [0, R]}}
connections: {roll: {rolling: {body: spool, on: floor, radius: R}}}
loads: {weight: {gravity: g}, pull: {force: {at: spool, along: b, magnitude: F}}}
"""
CORD = """
parameters: {m: 70 kg, L: 20 m, k: 100 N/m, h: 60 m, g: 9.81 m/s^2}
bodies: {jumper: {particle: {mass: m}}}
connections: {line: {slider: {body: jumper, along: down, through: ground.O}}}
loads: {weight: {gravity: g}, cord: {elastic_string: {from: ground.O, to: jumper, stiffness: k, length: L}}}
measures: {y: {drop of jumper below ground.O}}
start: {y: 0, rate(y): 0}
"""
YES, NO = "yes, with the given numbers", "no, not with the given numbers"


@pytest.mark.parametrize(
    ("text", "question", "verdict"),
    [
        (TRUCK, "whether crate slips", NO),
        (TRUCK.replace("B: 9 kN", "B: 15 kN"), "whether crate slips", YES),
        (TRUCK.replace("B: 9 kN", "B: 15 kN"), "does the crate slip on its own?", YES),
        (TRUCK, "Does the crate never slip?", YES),
        (SPOOL, "does the spool stay on the floor", YES),
        (SPOOL.replace("F: 10 N", "F: 60 N"), "does the spool stay on the floor", NO),
        (SPOOL, "whether the spool rolls without slipping", YES),
        (CORD, "whether cord goes slack", YES),
        (CORD, "whether y reaches 30 m", YES),
    ],
)
def test_the_verdict_is_that_of_the_given_numbers(text: str, question: str, verdict: str) -> None:
    found = posed(text, question)
    assert found.verdict == verdict, found.reason
    assert found.evidence is not None


def test_where_it_is_so_is_told_and_where_it_is_not() -> None:
    found = posed(TRUCK, "whether crate slips")
    yes = [str(line) for line in found.conditions if line.startswith("yes if")]
    no = [str(line) for line in found.conditions if line.startswith("no if")]
    assert len(yes) == len(no) == 1
    # B/(M + m) against mu g: what is shown is positive where the crate slips
    assert found.value is not None
    assert found.value < 0
    told = is_derived(TRUCK.replace("B: 9 kN", "B: 15 kN"), "whether crate slips")
    assert "Yes, with the given numbers" in told["en"]
    assert "Ja, mit den gegebenen Zahlen" in told["de"]


def test_what_is_so_in_both_of_two_parts_is_so_whatever_the_parameters_are() -> None:
    assert posed(TRUCK, "whether crate leaves bed").conditions == ("no, whatever the parameters are",)


def test_what_cannot_slip_is_said_to_be_declared_so() -> None:
    found = posed(SPOOL, "whether the spool rolls without slipping")
    assert any("never slips" in note for note in found.notes)


SLOPE = """
parameters: {m: 2 kg, g: 9.81 m/s^2, mu: 0.2, alpha: 30 deg, v0: 1 m/s}
ground: {lines: {slope: {angle: alpha}}}
bodies: {block: {particle: {mass: m}}}
connections: {touch: {contact: {between: [block, slope], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: travel of block along slope}
start: {x: 0, rate(x): -v0}
"""


@pytest.mark.parametrize("said", ["does the block stay there", "bleibt der Block liegen", "bleibt der Klotz stehen"])
def test_what_slides_down_a_slope_stays_where_it_stops_and_not_where_it_does_not_turn_back(said: str) -> None:
    """Down a slope it comes to rest where mu > tan(alpha) alone: tan(30 deg) = 0.577 is more than 0.2."""
    assert [one.understood for one in fb.System.from_text(SLOPE).asked(said)] == ["whether block stops"]
    assert [one.understood for one in fb.System.from_text(SLOPE.replace("-v0", "v0")).asked(said)] == [
        "whether x never turns back"
    ]
    found = posed(SLOPE, "whether block stops")
    assert found.value is not None
    assert found.value < 0


SUPPORTED = """
parameters: {L: 6 m, m: 60 kg, P: 1 kN, b: 4 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}}
bodies: {beam: {rod: {mass: m, length: L}, angle: 0, at: {start: A}, points: {C: [b - L/2, 0]}}}
connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.C, along: right}}}
loads: {weight: {gravity: g}, push: {force: {at: beam.end, along: WAY, magnitude: P}}}
"""


def test_a_support_bears_a_share_of_the_weight_where_nothing_else_weighs_on_it() -> None:
    """B b = m g L/2: with b = 4 m three quarters; a force along the beam bears nothing of it."""
    level = fb.System.from_text(SUPPORTED.replace("WAY", "right"))
    [found] = level.solve("what share of the weight does B carry").answers
    assert found.value == pytest.approx(6 / 2 / 4, rel=1e-9)
    for model, said in (
        (level, "what share of the load does B carry"),
        (fb.System.from_text(SUPPORTED.replace("WAY", "down")), "what share of the weight does B carry"),
    ):
        with pytest.raises(ModelError, match="cannot read"):
            model.asked(said)
