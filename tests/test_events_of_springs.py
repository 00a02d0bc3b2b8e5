"""A spring at a given extension or force is at a given length, whatever else moves; sizes that swing with a mode.

Two carts m1 and m2 on a rail with a spring k between them move about their mass centre as one oscillator of the mass
mu = m1 m2/(m1 + m2): their distance swings with w^2 = k/mu, and the mass centre keeps its velocity. Source: Landau &
Lifshitz, Mechanics, sec. 13 (reduced mass).
"""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.language.notation import to_text
from freebody.study.answering.answer import Answer

VALUES = {"m1": 2.0, "m2": 3.0, "k": 500.0, "d": 0.1, "l0": 0.5, "u": 3.0, "v": 4.0}
M1, M2, K, D, L0, U, V = VALUES.values()
MU = M1 * M2 / (M1 + M2)
W = (K / MU) ** 0.5


def carts(start: str, at: str = "l0") -> fb.System:
    return fb.System.from_text(f"""
parameters: {{m1: 2 kg, m2: 3 kg, k: 500 N/m, d: 0.1 m, l0: 0.5 m, u: 3 m/s, v: 4 m/s}}
bodies:
  A: {{particle: {{mass: m1}}, at: [0, 0]}}
  B: {{particle: {{mass: m2}}, at: [{at}, 0]}}
connections:
  rail_A: {{slider: {{body: A, along: right}}}}
  rail_B: {{slider: {{body: B, along: right}}}}
loads: {{spring: {{spring: {{between: [A, B], stiffness: k, length: l0}}}}}}
measures: {{x1: x of A, x2: x of B}}
start: {{{start}}}
""")


RELEASED = carts("x1: 0, x2: l0 - d", "l0 - d")  # pushed together by d, from rest
STRUCK = carts("x1: 0, rate(x1): u, x2: l0, rate(x2): 0")
TOGETHER = carts("x1: 0, rate(x1): u, x2: l0, rate(x2): v")


def told(system: fb.System, question: str) -> Answer:
    (answer,) = system.solve(question).answers
    assert answer.expression is not None, answer.reason
    assert answer.evidence is not None
    return answer


def number(system: fb.System, question: str) -> float:
    expression = told(system, question).expression
    assert not isinstance(expression, tuple)
    return float(evaluate(expression, VALUES, FLOAT_FUNCTIONS))


def test_carts_that_a_spring_drives_apart_share_its_energy_as_the_masses_of_the_other() -> None:
    # m1 v1 = m2 v2 and m1 v1^2/2 + m2 v2^2/2 = k d^2/2
    energy = K * D**2 / 2
    event = "when extension of spring = 0"
    assert number(RELEASED, f"kinetic energy of A {event}") == pytest.approx(energy * M2 / (M1 + M2), rel=1e-12)
    assert number(RELEASED, f"kinetic energy of B {event}") == pytest.approx(energy * M1 / (M1 + M2), rel=1e-12)
    assert number(RELEASED, f"ratio of speed of A to speed of B {event}") == pytest.approx(M2 / M1, rel=1e-12)
    assert number(RELEASED, "time until extension of spring = 0") == pytest.approx(
        3.141592653589793 / (2 * W), rel=1e-12
    )


@pytest.mark.parametrize(
    "event", ["force in spring = -k*d/2", "compression of spring = d/2", "extension of spring = -d/2"]
)
def test_a_spring_with_half_of_its_force_has_given_off_three_quarters_of_its_energy(event: str) -> None:
    energy = K * D**2 / 2 * 3 / 4
    v1 = (2 * energy * M2 / (M1 * (M1 + M2))) ** 0.5
    assert number(RELEASED, f"speed of A when {event}") == pytest.approx(v1, rel=1e-12)
    assert number(RELEASED, f"time when {event}") == pytest.approx(3.141592653589793 / (3 * W), rel=1e-12)  # cos = 1/2


def test_carts_that_have_sprung_apart_again_have_the_velocities_after_an_elastic_impact() -> None:
    event = "when extension of spring = 0"
    assert number(STRUCK, f"velocity of x1 {event}") == pytest.approx((M1 - M2) / (M1 + M2) * U, rel=1e-12)
    assert number(STRUCK, f"velocity of x2 {event}") == pytest.approx(2 * M1 / (M1 + M2) * U, rel=1e-12)


def test_the_greatest_speed_of_a_cart_is_that_of_the_mass_centre_and_the_amplitude() -> None:
    centre, against = M1 * U / (M1 + M2), M1 * U / (M1 + M2)  # of B: the mass centre, and of the swing beside it
    assert number(STRUCK, "greatest speed of B") == pytest.approx(centre + against, rel=1e-12)
    assert number(RELEASED, "greatest speed of B") == pytest.approx(D * W * MU / M2, rel=1e-12)


def test_the_least_speed_is_zero_only_where_the_cart_turns_back() -> None:
    turns = told(STRUCK, "least speed of A")
    assert number(STRUCK, "least speed of A") == 0
    assert any("m₂ ≥ m₁" in str(c) for c in turns.conditions)
    centre, swing = (M1 * U + M2 * V) / (M1 + M2), M2 * (V - U) / (M1 + M2)
    assert number(TOGETHER, "least speed of A") == pytest.approx(centre - swing, rel=1e-12)
    assert number(TOGETHER, "greatest speed of A") == pytest.approx(centre + swing, rel=1e-12)


def test_a_wave_is_shown_with_its_angular_frequency_under_one_root() -> None:
    expression = told(STRUCK, "x1 at t = 2*l0/u").expression
    assert "√(k·(m₁ + m₂)/(m₁·m₂))" in to_text(expression)
