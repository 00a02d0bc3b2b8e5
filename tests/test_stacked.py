"""Blocks on blocks: bodies that could touch at many places, of which few do; the forces of a contact taken together.

Textbook families: stacked blocks of which the lower is pulled (Meriam & Kraige, Engineering Mechanics: Dynamics, ch. 3;
Irodov, Problems in General Physics, 1.2), a crate pushed above its middle (Beer & Johnston, ch. 8 and 16).
"""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.language.expression import evaluate
from freebody.study.answering.answer import Answer
from freebody.study.phases.consistent import candidates
from freebody.study.phases.nodes import PhaseStart
from freebody.study.phases.placed import Placed
from freebody.study.phases.together import slipping_together
from freebody.study.phases.tree import PhaseTree

STACKED = """
parameters: {m: 2 kg, M: 5 kg, mu: 0.4, F: 20 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  lower: {rectangle: {mass: M, width: 1 m, height: 0.2 m}, at: [0, 0.1 m]}
  upper: {rectangle: {mass: m, width: 0.4 m, height: 0.2 m}, at: [0, 0.3 m]}
connections:
  base: {contact: {between: [lower, floor]}}
  top: {contact: {between: [upper, lower], friction: mu}}
loads: {weight: {gravity: g}, pull: {force: {at: lower, along: right, magnitude: F}}}
measures: {x: x of lower, u: x of upper}
"""
CRATE = """
parameters: {m: 20 kg, w: 0.6 m, h: 1 m, mu: 0.35, F: 100 N, b: 0.4 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {box: {rectangle: {mass: m, width: w, height: h}, points: {P: [0, b - h/2]}}}
connections: {base: {contact: {between: [box, floor], friction: mu}}}
loads: {weight: {gravity: g}, push: {force: {at: box.P, along: right, magnitude: F}}}
measures: {x: x of box}
"""


def solved(text: str, *questions: str) -> dict[str, Answer]:
    asked = "\n".join(f"  - {question}" for question in questions)
    found = {
        answer.question: answer for answer in fb.solve(fb.System.from_text(f"{text}questions:\n{asked}\n")).answers
    }
    for answer in found.values():
        assert answer.expression is not None, answer.reason
        assert answer.evidence is not None
    return found


def case_of(answer: Answer, what: str, **values: float) -> float:
    [case] = [case for case in answer.cases if case.what == what]
    assert not isinstance(case.expression, tuple)
    return float(evaluate(case.expression, values))


@pytest.mark.slow
def test_a_block_on_a_pulled_block_sticks_up_to_the_force_of_friction() -> None:
    # together: a = F/(m + M), friction m a, as long as m a <= mu m g; beyond: lower (F - mu m g)/M, upper mu g
    known = {"m": 2.0, "M": 5.0, "mu": 0.4, "g": 9.81}
    m, M, mu, g = known.values()
    found = solved(STACKED, "acceleration of x", "friction force of top", "normal force of top", "normal force of base")
    x, friction = found["acceleration of x"], found["friction force of top"]
    assert x.value == pytest.approx(20.0 / (m + M), rel=1e-12)
    assert case_of(x, "sticks", F=20.0, **known) == pytest.approx(20.0 / (m + M), rel=1e-12)
    assert case_of(x, "slides", F=60.0, **known) == pytest.approx((60.0 - mu * m * g) / M, rel=1e-12)
    assert abs(case_of(friction, "sticks", F=20.0, **known)) == pytest.approx(m * 20.0 / (m + M), rel=1e-12)
    assert abs(case_of(friction, "slides", F=60.0, **known)) == pytest.approx(mu * m * g, rel=1e-12)
    assert found["normal force of top"].value == pytest.approx(m * g, rel=1e-12)
    assert found["normal force of base"].value == pytest.approx((m + M) * g, rel=1e-12)


def test_the_force_of_a_contact_is_that_of_all_its_places_together() -> None:
    m, w, h, mu, F, b, g = 20.0, 0.6, 1.0, 0.35, 100.0, 0.4, 9.81
    at_corner = "normal force of base at box.bottom_right"
    found = solved(CRATE, "normal force of base", "friction force of base", at_corner)
    assert found["normal force of base"].value == pytest.approx(m * g, rel=1e-12)
    assert found["friction force of base"].value == pytest.approx(-mu * m * g, rel=1e-12)
    # moments about the mass centre: N_right - N_left = (2/w) (F (b - h/2) + mu m g h/2)
    apart = 2.0 / w * (F * (b - h / 2.0) + mu * m * g * h / 2.0)
    assert found[at_corner].value == pytest.approx((m * g + apart) / 2.0, rel=1e-12)


@pytest.mark.slow
def test_a_block_slides_on_a_block_that_slides() -> None:
    """Both rough (Meriam & Kraige, ch. 3; Irodov 1.2): the upper one with mu1 g, the lower one with
    (F - mu1 m1 g - mu2 (m1 + m2) g)/m2, where together they would need more than mu1 g."""
    text = """
parameters: {m1: 5 kg, m2: 10 kg, mu1: 0.3, mu2: 0.1, F: 60 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  top: {rectangle: {mass: m1, width: 0.2 m, height: 0.2 m}, at: [0, 0.5 m]}
  bottom: {rectangle: {mass: m2, width: 1 m, height: 0.4 m}, at: [0, 0.2 m]}
connections:
  upper: {contact: {between: [top, bottom], friction: mu1}}
  lower: {contact: {between: [bottom, floor], friction: mu2}}
loads: {weight: {gravity: g}, pull: {force: {at: bottom, along: right, magnitude: F}}}
measures: {x: x of top, u: x of bottom}
"""
    found = solved(text, "acceleration of x at start", "acceleration of u at start")
    x, u = found["acceleration of x at start"], found["acceleration of u at start"]
    m1, m2, mu1, mu2, F, g = 5.0, 10.0, 0.3, 0.1, 60.0, 9.81
    assert x.value == pytest.approx(mu1 * g)
    assert u.value == pytest.approx((F - mu1 * m1 * g - mu2 * (m1 + m2) * g) / m2)
    less = {"m1": m1, "m2": m2, "mu1": mu1, "mu2": mu2, "F": 40.0, "g": g}
    assert case_of(x, "upper sticks, lower slides", **less) == pytest.approx((40 - mu2 * (m1 + m2) * g) / (m1 + m2))


def test_the_corners_of_a_block_on_a_plane_slide_alike() -> None:
    """Nine states of two frictions, of which three can be: at rest, to the right, to the left."""
    tree = PhaseTree(fb.System.from_text(CRATE))
    start = tree.roots[0]
    rubs = [rub.name for rub in tree.rubbing(tree.closed)]
    assert len(rubs) == 2
    assert slipping_together(rubs, tree.slip_rates) == [[(rubs[0], 1), (rubs[1], 1)]]
    instant = PhaseStart(Placed(), tree.closed, tree.slips, given=(), began=tree.home.model.field.zero)
    closed = [m.states for m in candidates(tree, instant, start.sets) if m.closed == start.phase.mode.closed]
    assert [set(states.values()) for states in closed] == [{0}, {1}, {-1}]
