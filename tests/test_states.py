"""States of controllers: integrators, lags and saturation, against hand-derived polynomials and motions."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.errors import ModelError
from freebody.language.expression import Call, Symbol
from freebody.narrative.sheets.sheet import sheet
from freebody.numeric.reference import Reference
from freebody.present.report.formats.terminal import terminal_text

Agree = Callable[[fb.Solution, str, str | list[str]], None]
EXAMPLES = Path(__file__).parents[1] / "examples"


def example(name: str, **values: str | float) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml").with_parameters(**values)


def poles(system: fb.System) -> list[complex]:
    """Of the whole system, by its state-space model."""
    A, _B, _C, _D = system.modes().state_space()
    return sorted(np.linalg.eigvals(A), key=lambda s: (round(s.real, 6), s.imag))


def roots(*coefficients: float) -> list[complex]:
    return sorted(np.roots(coefficients), key=lambda s: (round(s.real, 6), s.imag))


LAG = """
parameters: {T: 0.5 s, u: 2 N, m: 3 kg}
bodies: {ball: {particle: {mass: m}}}
connections: {rail: {slider: {body: ball, along: right}}}
measures: {x: x of ball}
states: {F: (u - F)/T}
loads: {push: {force: {at: ball, along: right, magnitude: F}}}
start: {x: 0, rate(x): 0}
questions: {a: acceleration of x, F: F}
"""


def test_a_first_order_lag_comes_near_exponentially_on_both_routes() -> None:
    # F = u (1 - e^(-t/T)), m x' = u (t - T (1 - e^(-t/T)))
    system = fb.System.from_text(LAG)
    until, T, u, m = 1.3, 0.5, 2.0, 3.0
    force = u * (1 - math.exp(-until / T))
    speed = u / m * (until - T * (1 - math.exp(-until / T)))
    series = system.simulate(until).series
    assert series["F"][0][-1] == pytest.approx(force, rel=1e-8)
    assert series["x"][1][-1] == pytest.approx(speed, rel=1e-8)
    reference = Reference(system)
    q = reference.assemble()
    end = reference.integrate((q, reference.velocities(q)), until).snapshots[-1]
    assert end.rate(system.states["F"].integral) == pytest.approx(force, rel=1e-7)
    assert end.rate(system.measures["x"]) == pytest.approx(speed, rel=1e-7)
    assert system.solve()["a"].expression == Symbol("F") / Symbol("m")


def test_states_have_no_mass_no_place_no_energy_and_no_degree_of_freedom() -> None:
    system = fb.System.from_text(LAG)
    result = system.simulate(1.0)
    speed = result.series["x"][1]
    assert result.energy.kinetic == pytest.approx(1.5 * speed**2, rel=1e-9)
    assert result.energy.relative_error < 1e-8
    assert system.mobility().rank.n_freedoms == 1
    assert [body.name for body in system.moving] == ["ball"]
    assert "1 degree of freedom" in system.solve().to_text()
    assert set(result.dataset.body.values) == {"ball"}


def test_a_state_is_in_the_unit_that_its_rate_says() -> None:
    assert str(fb.System.from_text(LAG).states["F"].dimension) == "N"
    assert str(example("servo_with_pid").states["z"].dimension) == "s"


def test_pid_leaves_no_error_and_has_the_poles_of_its_polynomial() -> None:
    # J s^3 + k_d s^2 + k_p s + k_i
    system = example("servo_with_pid")
    assert poles(system) == pytest.approx(roots(0.2, 1.0, 6.0, 5.0), rel=1e-6)
    loaded = fb.System.from_text((EXAMPLES / "servo_with_pid.yaml").read_text().replace("z: T/k_i", "z: 0"))
    series = loaded.simulate(25.0).series
    assert series["phi"][0][-1] == pytest.approx(math.radians(30), abs=1e-7)
    assert series["z"][0][-1] == pytest.approx(1.0 / 5.0, rel=1e-6)
    (rest,) = loaded.equilibria()
    assert rest.measures["z"] == pytest.approx(0.2, rel=1e-8)
    assert rest.stability == "stable"


@pytest.mark.parametrize(("gain", "is_stable"), [("29 N m/s", True), ("31 N m/s", False)])
def test_pid_is_stable_up_to_the_gain_of_routh(gain: str, is_stable: bool) -> None:
    # k_i < k_p k_d/J = 30 N m/s
    (rest,) = example("servo_with_pid", k_i=gain).equilibria()
    assert (rest.stability == "stable") == is_stable


def test_a_chain_of_two_lags_has_the_poles_of_its_polynomial_and_an_undamped_pair_at_the_limit() -> None:
    # (J s^2 + c s) (tau s/2 + 1)^2 + k, tau = 1 s
    def polynomial(k: float) -> list[float]:
        return [*np.polymul([400.0, 300.0, 0.0], np.polymul([0.5, 1.0], [0.5, 1.0]))[:-1], k]

    assert poles(example("heading_with_delay")) == pytest.approx(roots(*polynomial(100.0)), rel=1e-6)
    J, c, tau = 400.0, 300.0, 1.0
    limit = 4 * c * (2 * J + c * tau) ** 2 / (tau * (4 * J + c * tau) ** 2)
    assert max(s.real for s in roots(*polynomial(limit))) == pytest.approx(0.0, abs=1e-9)
    assert example("heading_with_delay").solve()["gain"].value == pytest.approx(limit, rel=1e-9)


def test_a_saturated_motor_gives_its_full_torque_first() -> None:
    # phi = phi_0 - T_m t^2/(2 J) while k phi + c phi' > T_m
    phi = example("saturated_servo").simulate(0.4, every=0.1).series["phi"][0]
    times = np.arange(5) * 0.1
    assert phi == pytest.approx(math.pi / 2 - 3.0 / (2 * 0.5) * times**2, rel=1e-8)
    assert 20 * phi[-1] - 4 * 6.0 * 0.4 > 3.0  # which is so all the time


@pytest.mark.parametrize("most", [3.0, 0.01])
def test_a_saturated_motor_rests_where_its_law_says_however_far_that_is(most: float) -> None:
    """k phi = 0; about it J phi'' + c phi' + k phi = 0, so that omega^2 = k/J. T_m/k may be less than a step."""
    system = example("saturated_servo").with_parameters(T_m=most)
    (rest,) = system.equilibria().rests
    assert rest.measures["phi"] == pytest.approx(0.0, abs=1e-9)
    (mode,) = system.modes().modes
    assert mode.frequency == pytest.approx(math.sqrt(20 / 0.5))


def test_inputs_and_outputs_reach_the_state_space_model() -> None:
    # from the wanted place X to the trolley: at rest x = r = p = X, so the gain at s = 0 is one; and p is 1/(tau s + 1)
    system = example("crane_with_feedforward")
    A, B, C, D = system.modes().state_space(inputs=["weight"], outputs=["x", "theta", "p", "rate(r)"])
    assert [x.shape for x in (A, B, C, D)] == [(6, 6), (6, 1), (4, 6), (4, 1)]
    assert system.modes().states == ("x", "theta", "rate(x)", "rate(theta)", "p", "r")
    assert A[4] == pytest.approx([0, 0, 0, 0, -1 / 3, 0], abs=1e-8)
    assert C[3] == pytest.approx(A[5], abs=1e-8)


def test_a_state_may_not_be_called_as_something_else_and_its_law_may_not_contain_rates_of_states() -> None:
    with pytest.raises(ModelError, match="is a parameter or a measure already"):
        fb.System.from_text(LAG.replace("states: {F", "states: {x"))
    with pytest.raises(ModelError, match="not in their rates"):
        fb.System.from_text(LAG.replace("states: {F: (u - F)/T}", "states: {F: (u - F)/T, G: rate(F)}"))


def test_states_may_stand_in_any_order() -> None:
    text = (EXAMPLES / "heading_with_delay.yaml").read_text()
    u, v = "  u: (psi - u)/(tau/2)\n", "  v: (u - v)/(tau/2)\n"
    turned = fb.System.from_text(text.replace(u + v, v + u))
    assert str(turned.states["v"].dimension) == "1"
    assert turned.solve("acceleration of psi").answers[0].expression == -(
        Symbol("k") * Symbol("v") + Symbol("c") * Call("rate", Symbol("psi"))
    ) / Symbol("J")


def test_a_model_in_python_has_states() -> None:
    written = fb.System.from_text(LAG)
    assert fb.System.from_data(written.document.data) == written


def test_a_state_does_not_disturb_what_moves_beside_it() -> None:
    text = (EXAMPLES / "servo_with_pid.yaml").read_text(encoding="utf-8")
    beside = text.replace("bodies:\n", "bodies:\n  stone: {particle: {mass: 1 kg}, at: [3 m, 0]}\n", 1)
    question = "acceleration of phi at start"
    [alone] = fb.solve(fb.System.from_text(text), question=question).answers
    [found] = fb.solve(fb.System.from_text(beside), question=question).answers
    assert found.expression == alone.expression is not None


DRIVEN = """
parameters: {J: 2 kg m^2, T: 1 N m, tau: 0.5 s}
bodies: {w: {body: {inertia: J}}}
connections: {p: {pin: [ground.O, w]}}
states: {u: (T - u)/tau}
loads: {drive: {torque: {on: w, magnitude: u}}}
measures: {phi: angle of w}
start: {phi: 0, rate(phi): 0, u: 0}
"""


def test_a_state_makes_an_event_in_both_routes(agrees: Agree) -> None:
    """u = T (1 - e^(-t/tau)) is at half of T after tau ln(2)."""
    system = fb.System.from_text(DRIVEN + "questions: {it: time when u = T/2}\n")
    agrees(system.solve(), "it", "tau*log(2)")
    motion = system.simulate(1.0, events=["u = 0.5 N m"])
    assert [event.time for event in motion.events] == [pytest.approx(0.5 * math.log(2), rel=1e-7)]


def test_the_start_of_a_state_can_be_varied() -> None:
    """u = T + (u_0 - T) e^(-t/tau) reaches 0.6 T after tau ln((T - u_0)/(0.4 T))."""
    found = fb.System.from_text(DRIVEN).sweep({"u": "0, 0.25, 0.5 N m"}, record=["time when u = 0.6 N m"], until=1.0)
    expected = 0.5 * np.log((1 - np.array([0, 0.25, 0.5])) / 0.4)
    np.testing.assert_allclose(found.values("time when u = 0.6 N m"), expected, rtol=1e-7)


def test_an_exercise_gives_the_states_with_their_start() -> None:
    system = fb.System.from_text("title: Lag\n" + DRIVEN + "questions: {it: time when u = T/2}\n")
    text = terminal_text(sheet([system]).report())
    assert "u' = (T - u)/τ" in text
    assert "u = 0" in text


def test_an_integral_in_a_formula_is_told_to_be_a_state() -> None:
    text = """
parameters: {k: 5 N/m}
bodies: {block: {particle: {mass: 1 kg}}}
connections: {rail: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads: {hold: {force: {at: block, along: right, magnitude: -k*integral(x)}}}
"""
    with pytest.raises(ModelError, match=r"an integral is a state of its own, .* states: \{z: x - x_d\}"):
        fb.System.from_text(text)


PI = """
parameters: {m: 2 kg, kp: 80 N/m, kd: 12 N s/m, ki: 60 N/(m s), F: 5 N}
bodies: {table: {particle: {mass: m}}}
connections: {rail: {slider: {body: table, along: right}}}
measures: {x: x of table}
states: {z: x}
loads:
  servo: {force: {at: table, along: right, magnitude: -kp*x - kd*rate(x) - ki*z}}
  cut: {force: {at: table, along: left, magnitude: F}}
"""


def test_what_a_pi_servo_settles_at_is_derived_with_its_integral() -> None:
    """m s^3 + kd s^2 + kp s + ki is Hurwitz for kp kd > m ki; at rest ki z = -F, and nothing is left of x."""
    system = fb.System.from_text(PI)
    answer = system.solve("x as t grows")["q1"]
    assert answer.value == pytest.approx(0.0, abs=1e-12)
    text = terminal_text(system.explain("x as t grows").report, width=100)
    assert "There is no derivation" not in text
    assert "Where kp·kd > m·ki, all λ have negative real parts" in text
    rows = ("3 1", "2 kd/m", "1 kp/m", "0 ki/m")
    assert all(row in [" ".join(line.split()) for line in text.splitlines()] for row in rows)
    assert "-F" in text.split("As t → ∞")[1].split("State at that instant")[0]


@pytest.mark.parametrize(
    "asked", ["stability of equilibrium", "largest ki so that the equilibrium is stable"], ids=["now", "up to a gain"]
)
def test_whether_an_equilibrium_with_an_integral_is_stable_is_derived_by_routh(asked: str) -> None:
    system = fb.System.from_text(PI)
    text = terminal_text(system.explain(asked).report, width=100)
    assert "There is no derivation" not in text
    assert "Routh's array" in text
    assert "kp⋅kd - m⋅ki" in text  # over m kd: the second number of the first column
    assert poles(system.with_parameters(ki=479.0))[-1].real < 0.0 < poles(system.with_parameters(ki=481.0))[-1].real


CARS = """
parameters: {m: 2 kg, M: 3 kg, k: 80 N/m, c: 12 N s/m, F: 5 N}
bodies: {a: {particle: {mass: m}}, b: {particle: {mass: M}, near: {at: [1 m, 0]}}}
connections: {rail: {slider: {body: a, along: right}}, other: {slider: {body: b, along: right}}}
measures: {x: x of a, y: x of b}
loads:
  first: {force: {at: a, along: right, magnitude: -k*x - c*rate(x) + k*(y - x)}}
  second: {force: {at: b, along: right, magnitude: F - k*(y - x)}}
"""


def test_what_damped_cars_settle_at_is_derived_though_their_motion_has_no_formula(agrees: Agree) -> None:
    """Two equal springs in a row: F = k x = k (y - x)."""
    system = fb.System.from_text(CARS)
    agrees(system.solve("y as t grows"), "q1", "2*F/k")
    text = terminal_text(system.explain("y as t grows").report, width=100)
    assert "There is no derivation" not in text
    assert "All λ have negative real parts" in text


def test_a_controlled_system_has_no_natural_frequency_of_its_masses_and_springs() -> None:
    """J s^3 + k_d s^2 + k_p s + k_i: sqrt(k_p/J), that of the motion without the integral, was told in numbers."""
    text = """
parameters: {J: 0.1 kg m^2, k_p: 2 N m, k_d: 0.3 N m s, k_i: 1 N m/s, w: 0.5}
bodies: {rotor: {body: {inertia: J}}}
connections: {axle: {pin: [ground.O, rotor]}}
measures: {phi: angle of rotor}
states: {z: phi - w}
loads: {motor: {torque: {on: rotor, magnitude: -k_p*(phi - w) - k_d*rate(phi) - k_i*z}}}
start: {phi: 0, rate(phi): 0}
"""
    for question in ("natural frequencies", "period of small oscillations"):
        answer = fb.System.from_text(text).solve(question).answers[0]
        assert answer.value is None
        assert "states of a controller" in answer.reason
