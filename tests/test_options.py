import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import pytest

from freebody.assess.options import judge
from freebody.assess.solved import SolvedAnswer
from freebody.assess.verdict import Judgement
from freebody.language.expression import Expr
from freebody.language.parser import parse
from freebody.language.units import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_VELOCITY,
    DIMENSIONLESS,
    ENERGY,
    FORCE,
    LENGTH,
    TIME,
    VELOCITY,
    Dimension,
)
from freebody.questions.freedom import DegreesOfFreedom
from freebody.questions.reading import Question
from freebody.symbolic.functions import element
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.sample import Sample
from freebody.system.system import System

Within = Callable[[int, Callable[[], object]], None]

ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, M: 1 kg, R: 0.1 m, g: 9.81 m/s^2}
bodies:
  pulley: {disk: {mass: M, radius: R}}
  left:   {particle: {mass: m1}}
  right:  {particle: {mass: m2}}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right, grips: [pulley]}}
loads:
  weight: {gravity: g}
measures:
  x1: {drop of left below ground.axle}
  x2: {drop of right below ground.axle}
  w: angle of pulley
"""
DISK = """
parameters: {m: 1 kg, R: 0.1 m, I: 0.01 kg m^2, alpha: 30 deg, g: 9.81 m/s^2, v0: 1 m/s, h: 2 m}
ground: {lines: {incline: {angle: -alpha}}}
bodies:
  disk: {body: {mass: m, inertia: I, radius: R}}
connections:
  contact: {rolling: {body: disk, on: incline}}
loads: {weight: {gravity: g}}
measures: {drop: drop of disk}
"""
SPHERE = """
parameters: {m: 1 kg, r: 0.1 m, theta: 20 deg, mu: 0.3, v0: 1 m/s, g: 9.81 m/s^2}
bodies:
  ball: {body: {mass: m, inertia: 2/5*m*r^2, radius: r}}
"""
GEAR = """
parameters: {r_S: 0.1 m, r_P: 0.05 m, I_S: 0.02 kg m^2, I_P: 0.003 kg m^2, m_P: 1 kg, T_S: 2 N m}
bodies:
  sun: {body: {inertia: I_S, radius: r_S}}
connections:
  bearing: {pin: [ground.S, sun]}
loads: {drive: {torque: {on: sun, magnitude: T_S}}}
"""
PENDULUM = """
parameters: {m: 2 kg, L: 1 m, a: 3, b: 2, alpha: 30 deg, p: {value: 2, sign: any}, g: 9.81 m/s^2}
bodies:
  bob: {particle: {mass: m}}
connections:
  rod: {link: [ground.O, bob, L]}
loads: {weight: {gravity: g}}
measures:
  theta: angle of line from ground.O to bob from down
start: {theta: 0.3}
"""
CRANK = """
parameters: {r: 0.1 m, l: 0.3 m, m3: 3 kg, g0: 9.81 m/s^2}
ground: {points: {O: [0, 0]}, lines: {cylinder: {along: right}}}
bodies:
  crank:  {rod: {mass: 1, length: r}}
  rod:    {rod: {mass: 2, length: l}}
  piston: {particle: {mass: m3}}
connections:
  main: {pin: [ground.O, crank.start]}
  crankpin: {pin: [crank.end, rod.start]}
  wristpin: {pin: [rod.end, piston]}
  cylinder: {slider: {body: piston, along: cylinder}}
measures:
  theta: {angle of crank}
  phi: {angle of rod clockwise}
start: {theta: 40 deg}
"""


@dataclass
class Bench:
    """A model, and formulas read as elements of its field."""

    system: System
    model: SymbolicModel

    def element(self, text: str) -> Ratio:
        names = dict(self.model.parameters)
        for name, measure in self.system.measures.items():
            names[name] = measure.value(self.model.geometry)
            names[f"rate({name})"] = self.model.rate(names[name])
        expr: Expr = parse(text)
        return element(self.model.field, expr, names)

    def judge(
        self,
        options: dict[str, str],
        answer: str | tuple[str, str] | Fraction | None,
        dimension: Dimension,
        key: str | None = None,
        up_to_constant: bool = False,
    ) -> Judgement:
        found = (
            (self.element(answer[0]), self.element(answer[1]))
            if isinstance(answer, tuple)
            else self.element(answer)
            if isinstance(answer, str)
            else answer
        )
        question = Question("q", "what is asked", DegreesOfFreedom(), options=options, key=key)
        return judge(question, SolvedAnswer(found, dimension, self.model, self.system, up_to_constant))

    def reason(self, option: str, answer: str, dimension: Dimension) -> str:
        return self.judge({"a": option}, answer, dimension).options["a"].reason

    def is_right(self, option: str, answer: str, dimension: Dimension = DIMENSIONLESS) -> bool:
        return self.judge({"a": option}, answer, dimension).choice == "a"


def bench(text: str, *samples: Sample) -> Bench:
    system = System.from_text(text)
    return Bench(system, SymbolicModel(system, samples))


@pytest.fixture(scope="module")
def atwood() -> Bench:
    return bench(ATWOOD)


@pytest.fixture(scope="module")
def disk() -> Bench:
    return bench(DISK)


@pytest.fixture(scope="module")
def pendulum() -> Bench:
    return bench(PENDULUM)


def verdicts(judgement: Judgement) -> dict[str, str]:
    return {letter: v.verdict for letter, v in judgement.options.items()}


def only(right: str, letters: str = "abcde") -> dict[str, str]:
    return {letter: "right" if letter == right else "wrong" for letter in letters}


# -- the published exercises ------------------------------------------------------------------
DISK_OPTIONS = {
    "a": "(-v0/R + sqrt(v0^2/R^2 + 2*m*g*h/(I + m*R^2)))/(m*g*R*sin(alpha)/(I + m*R^2))",
    "b": "(-v0/R - sqrt(v0^2/R^2 + 2*m*g*h/(I + m*R^2)))/(I + m*R^2)",
    "c": "(-v0/R + sqrt(v0^2*R^2 + 2*m*g*h/I))/(m*g*R*sin(alpha)/I)",
    "d": "(-v0/R + (v0^2*R^2 + 2*m*g*h/(I + m*R^2)))/(m*g*R*sin(alpha)/I)",
    "e": "(-v0 + sqrt(v0^2 + 2*m*g*h/(I + m*R^2)))/(m*g*R*sin(alpha)/(I + m*R^2))",
}


def test_time_of_the_rolling_disk_is_option_a_and_the_others_fail_by_their_units(disk: Bench) -> None:
    judgement = disk.judge(DISK_OPTIONS, DISK_OPTIONS["a"], TIME, key="a")
    assert judgement.choice == "a"
    assert verdicts(judgement) == only("a")
    assert judgement.notes == ()
    reasons = {letter: v.reason for letter, v in judgement.options.items()}
    assert reasons == {
        "a": "identical to the result",
        "b": "has the unit 1/(kg m^2 s), the answer has s",
        "c": "adds v₀²·R² [m^4/s^2] and 2·m·g·h/I [1/s^2]",
        "d": "adds v₀/R [1/s] and v₀²·R² [m^4/s^2]",
        "e": "adds v₀² [m^2/s^2] and 2·m·g·h/(I + m·R²) [1/s^2]",
    }


def test_the_negative_root_fails_for_a_drop_of_nothing(disk: Bench) -> None:
    other_root = DISK_OPTIONS["a"].replace("+ sqrt", "- sqrt")
    assert disk.reason(other_root, DISK_OPTIONS["a"], TIME).startswith("for h = 0 the answer is 0, ")


SPHERE_OPTIONS = {
    "a": "5*mu*cos(theta)*v0/(7*mu*cos(theta) - 2*sin(theta))",
    "b": "7*mu*cos(theta)*v0/(2*mu*cos(theta) + 5*sin(theta))",
    "c": "(5*mu*cos(theta) + 7*sin(theta))*v0/(7*mu*cos(theta))",
    "d": "5*mu*sin(theta)*v0/(7*mu*sin(theta) - 2*cos(theta))",
    "e": "7*cos(theta)*v0/(5*cos(theta) - 2*sin(theta))",
}


def test_speed_of_the_launched_sphere_is_option_a_and_the_others_fail_in_special_cases() -> None:
    judgement = bench(SPHERE).judge(SPHERE_OPTIONS, SPHERE_OPTIONS["a"], VELOCITY, key="a")
    assert verdicts(judgement) == only("a")
    reasons = {letter: v.reason for letter, v in judgement.options.items()}
    assert reasons["b"] == "for θ = 0 the answer is 5·v₀/7, this option gives 7·v₀/2"
    assert reasons["c"] == "for μ = 0 the answer is 0, this option is infinite"
    assert reasons["d"] == "for θ = 0 the answer is 5·v₀/7, this option gives 0"
    assert reasons["e"].startswith("for μ = 0 the answer is 0, this option gives ")


GEAR_OPTIONS = {
    "a": "T_S*r_P^2/(I_S*r_P^2 + r_S^2*I_P + m_P*r_P^2*r_S^2)",
    "b": "T_S*r_P^2/(4*I_S*r_P^2 + 3*r_S^2*I_P)",
    "c": "4*T_S*r_P^2/(4*I_S*r_P^2 + 3*r_S^2*I_P + 3*m_P*r_P^2*r_S^2)",
    "d": "T_S/(3*I_S*r_P^2 + 4*r_S^2*I_P + 3*m_P*r_P^2*r_S^2)",
    "e": "4*T_S*r_P^2/(3*m_P*r_P^2*r_S^2)",
}


def test_acceleration_of_the_sun_gear_is_option_c() -> None:
    judgement = bench(GEAR).judge(GEAR_OPTIONS, GEAR_OPTIONS["c"], ANGULAR_ACCELERATION, key="c")
    assert verdicts(judgement) == only("c")
    reasons = {letter: v.reason for letter, v in judgement.options.items()}
    assert reasons["a"].startswith("for I_P = 0 the answer is 4·T_S/")
    assert reasons["b"].startswith("as m_P grows the answer tends to 0, this option tends to ")
    assert reasons["d"] == "has the unit 1/(m^2 s^2), the answer has 1/s^2"
    assert reasons["e"].startswith("for m_P = 0 the answer is ")
    assert reasons["e"].endswith("this option is infinite")


ATWOOD_ACCELERATION = {
    "a": "(m1 - m2)/(m1 + m2 + M/2)*g",
    "b": "(m1 - m2)/(m2 + M/2)*g",
    "c": "(m1 + m2)/(m1 + m2 + M/2)",
    "d": "(m1 - m2)/(m1 - M/2)*g",
    "e": "m1/(m1 + m2 + M/2)",
}
ATWOOD_TENSION = {
    "a": "(2*m1*m2*g + M/2)/(m1 + m2 + M/2)",
    "b": "m1*g*(2*m2 + M/2)/(m1 + m2)",
    "c": "(2*m2 + M/2)/(g*(m1 + m2 + M/2))",
    "d": "m1*g*M/(m2 + M/2)",
    "e": "m1*g*(2*m2 + M/2)/(m1 + m2 + M/2)",
}
ATWOOD_ENERGY = {
    "a": "m1*x1'^2/2 + m2*x2'^2/2 - m1*g*x1 - m2*g*x2",
    "b": "M*R^2*w'^2/4 - m1*g*x1 - m2*g*x2",
    "c": "m1*x1'^2/2 + m2*x2'^2/2 + M*R^2*w'^2/4 - m1*g*x1 - m2*g*x2",
    "d": "m1*x1^4/4 + m2*x2^4/4 + M*R^2*w'^2/6 - m2*g*x2",
    "e": "m1*x1'^2/2 + m2*x2'^2/2 + M*R^2*w'^2/4",
}


def test_acceleration_of_the_atwood_machine_is_option_a(atwood: Bench) -> None:
    judgement = atwood.judge(ATWOOD_ACCELERATION, ATWOOD_ACCELERATION["a"], ACCELERATION, key="a")
    assert judgement.choice == "a"
    assert {letter: v.reason for letter, v in judgement.options.items()} == {
        "a": "identical to the result",
        "b": "as m₁ grows the answer tends to g, this option grows without bound",
        "c": "has no unit, the answer has m/s^2",
        "d": "as m₂ grows the answer tends to -g, this option grows without bound",
        "e": "has no unit, the answer has m/s^2",
    }


def test_a_sum_in_place_of_the_difference_fails_for_equal_masses(atwood: Bench) -> None:
    reason = atwood.reason("(m1 + m2)/(m1 + m2 + M/2)*g", ATWOOD_ACCELERATION["a"], ACCELERATION)
    assert reason == "for m₁ = m₂ the answer is 0, this option gives 4·m₁·g/(4·m₁ + M)"


def test_tension_of_the_atwood_machine_is_option_e(atwood: Bench) -> None:
    judgement = atwood.judge(ATWOOD_TENSION, ATWOOD_TENSION["e"], FORCE, key="e")
    assert judgement.choice == "e"
    assert {letter: v.reason for letter, v in judgement.options.items()} == {
        "a": "adds 2·m₁·m₂·g [kg^2 m/s^2] and M/2 [kg]",
        "b": "as M grows the answer tends to m₁·g, this option grows without bound",
        "c": "has the unit s^2/m, the answer has N",
        "d": "for M = 0 the answer is 2·m₁·m₂·g/(m₁ + m₂), this option gives 0",
        "e": "identical to the result",
    }


def test_energy_of_the_atwood_machine_is_option_c(atwood: Bench) -> None:
    judgement = atwood.judge(ATWOOD_ENERGY, ATWOOD_ENERGY["c"], ENERGY, key="c", up_to_constant=True)
    assert judgement.choice == "c"
    assert {letter: v.reason for letter, v in judgement.options.items()} == {
        "a": "differs from the answer by -M·x₁'²/4, which changes during the motion",
        "b": "differs from the answer by -x₁'²·(m₁ + m₂)/2, which changes during the motion",
        "c": "identical to the result",
        "d": "adds m₁·x₁⁴/4 [kg m^4] and M·R²·w'²/6 [N m]",
        "e": "differs from the answer by g·x₁·(m₁ - m₂), which changes during the motion",
    }


def test_energy_is_known_up_to_a_constant_and_only_energy_is(atwood: Bench) -> None:
    other_level = {"a": ATWOOD_ENERGY["c"] + " + 5*m1*g*R"}
    judged = atwood.judge(other_level, ATWOOD_ENERGY["c"], ENERGY, up_to_constant=True)
    assert judged.options["a"].reason == "identical to the result up to the constant 5·m₁·R·g"
    assert atwood.judge(other_level, ATWOOD_ENERGY["c"], ENERGY).choice is None


def test_energy_up_to_a_constant_that_only_numbers_show(atwood: Bench) -> None:
    option = {"a": ATWOOD_ENERGY["c"] + " + m1*g*R*log(exp(x1/R)) - m1*g*x1 + m1*g*R"}
    judged = atwood.judge(option, ATWOOD_ENERGY["c"], ENERGY, up_to_constant=True)
    assert judged.options["a"].reason == "equal up to a constant to 40 digits at 12 random points"


def test_energy_in_the_speed_of_one_mass_is_the_same_energy(atwood: Bench) -> None:
    option = {"a": "(m1 + m2 + M/2)*x1_dot^2/2 - (m1 - m2)*g*x1"}
    judged = atwood.judge(option, ATWOOD_ENERGY["c"], ENERGY, up_to_constant=True)
    assert judged.choice == "a"


# -- notes to the author ----------------------------------------------------------------------
def test_two_right_options_leave_no_choice_and_are_noted(atwood: Bench) -> None:
    options = {"a": "(m1 - m2)*g/(m1 + m2)", "b": "g*(m1/m2 - 1)/(m1/m2 + 1)", "c": "g"}
    judgement = atwood.judge(options, options["a"], ACCELERATION)
    assert judgement.choice is None
    assert judgement.notes == ("two options are right: a and b",)


def test_no_right_option_is_noted(atwood: Bench) -> None:
    judgement = atwood.judge({"a": "g", "b": "g/2"}, "(m1 - m2)*g/(m1 + m2)", ACCELERATION)
    assert judgement.choice is None
    assert judgement.notes == ("no option is right",)


def test_a_key_that_names_a_wrong_option_is_noted(atwood: Bench) -> None:
    judgement = atwood.judge({"a": "g/2", "b": "g"}, "g/2", ACCELERATION, key="b")
    assert judgement.choice == "a"
    assert judgement.notes == ("the key says b, but a is right",)


def test_without_an_answer_only_impossible_options_are_judged(atwood: Bench) -> None:
    judgement = atwood.judge({"a": "g", "b": "m1", "c": "2*g"}, None, ACCELERATION)
    assert judgement.choice is None
    assert verdicts(judgement) == {"b": "wrong"}
    assert judgement.notes == ("there is no answer to compare a and c with",)


# -- reading ----------------------------------------------------------------------------------
def test_a_syntax_error_is_told_with_its_column(atwood: Bench) -> None:
    judgement = atwood.judge({"a": "g*(m1 - m2", "b": "[g, m1 +]"}, ("g", "g"), ACCELERATION)
    assert verdicts(judgement) == {"a": "unreadable", "b": "unreadable"}
    assert judgement.options["a"].reason == "cannot be read: this bracket is never closed (column 3)"
    assert judgement.options["b"].reason.endswith("(column 9)")
    assert judgement.notes[0].startswith("(a) cannot be read")


@pytest.mark.parametrize(
    ("option", "reason"),
    [
        ("omega_2*R", "names omega_2, which is not given"),
        ("a1 + b1", "names a1 and b1, which are not given"),
        ("x1''", "names x₁'', which is not given"),
        ("m1'*R", "names m₁', which is not given"),
        ("foo_dot", "names foo_dot, which is not given"),
        ("xxxxxx1y*g", "names xxxxxx1y, which is not given"),
    ],
)
def test_what_the_problem_does_not_give_is_named(atwood: Bench, option: str, reason: str) -> None:
    judged = atwood.judge({"a": option}, "g", ACCELERATION).options["a"]
    assert (judged.verdict, judged.reason) == ("wrong", reason)


@pytest.mark.parametrize(
    ("option", "reason"),
    [
        ("m1 + R", "adds m₁ [kg] and R [m]"),
        ("g*(R - m1/2)", "adds R [m] and m₁/2 [kg]"),
        ("g*sin(m1)", "takes sin of m1 [kg]: its argument must be without a unit"),
        ("w", "has no unit, the answer has m/s^2"),
        ("m1*g", "has the unit N, the answer has m/s^2"),
        ("g*m1/(m1 - m1)", "divides by zero"),
        ("0", "is 0, the answer is g"),
        ("-g", "has the opposite sign"),
        ("g + g/2", "is 3/2 times the answer"),
        ("infinity", "is infinite, the answer is g"),
        ("[g, 0]", "is a vector [x, y], the answer is a single number"),
    ],
)
def test_a_plain_reason_comes_first(atwood: Bench, option: str, reason: str) -> None:
    assert atwood.reason(option, "g", ACCELERATION) == reason


def test_a_number_with_a_unit_is_expected_where_the_answer_has_none(pendulum: Bench) -> None:
    assert pendulum.reason("m", "a", DIMENSIONLESS) == "has the unit kg, the answer has none"


def test_zero_fits_any_dimension(atwood: Bench) -> None:
    assert atwood.is_right("0", "x1 - x1", ACCELERATION)
    assert atwood.reason("g", "x1 - x1", ACCELERATION) == "is not 0, as the answer is"


# -- equality ---------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("option", "answer"),
    [
        ("sin(2*alpha)", "2*sin(alpha)*cos(alpha)"),
        ("1 + tan(theta)^2", "1/cos(theta)^2"),
        ("cos(theta)*cos(alpha) + sin(theta)*sin(alpha)", "cos(theta - alpha)"),
        ("sqrt(a^2*b)", "a*sqrt(b)"),
        ("sqrt(8)*sqrt(a)", "2*sqrt(2*a)"),
        ("(a^2 - b^2)/(a - b)", "a + b"),
        ("sin(30*pi/180)", "1/2"),
        ("1/(1 + sqrt(a))", "(1 - sqrt(a))/(1 - a)"),
        ("abs(-a)", "a"),
        ("abs(p)^2", "p^2"),
        ("sqrt(theta^4)", "theta^2"),
    ],
)
def test_the_same_written_differently_is_right(pendulum: Bench, option: str, answer: str) -> None:
    assert pendulum.is_right(option, answer)


@pytest.mark.parametrize(
    ("option", "answer"),
    [
        ("sqrt(a)*sqrt(b)", "sqrt(a*b)"),
        ("2*cos(theta/2)^2 - 1", "cos(theta)"),
        ("log(a*b)", "log(a) + log(b)"),
        ("a^(1/3)*a^(2/3)", "a"),
        ("asin(sin(alpha))", "alpha"),
        ("exp(a)*exp(theta)", "exp(a + theta)"),
        ("sin(1/3)^2", "1 - cos(1/3)^2"),
    ],
)
def test_what_the_field_does_not_decide_is_decided_by_numbers(pendulum: Bench, option: str, answer: str) -> None:
    judged = pendulum.judge({"a": option}, answer, DIMENSIONLESS).options["a"]
    assert judged.verdict == "right"
    assert judged.reason in ("identical to the result", "equal to 40 digits at 12 random points")


@pytest.mark.parametrize(
    ("option", "answer"),
    [
        ("sqrt(theta^2)", "theta"),
        ("abs(sin(theta))", "sin(theta)"),
        ("sqrt(theta - 3)", "theta"),
        ("log(a + b)", "log(a) + log(b)"),
        ("a^(1/3)", "a"),
        ("sqrt(a + b)", "sqrt(a) + sqrt(b)"),
        ("theta", "sin(theta)"),
        ("alpha", "sin(alpha)"),
        ("sqrt(-1 - a)", "a"),
    ],
)
def test_what_only_looks_alike_is_wrong(pendulum: Bench, option: str, answer: str) -> None:
    judged = pendulum.judge({"a": option}, answer, DIMENSIONLESS).options["a"]
    assert judged.verdict == "wrong"
    assert judged.reason


def test_the_size_of_a_coordinate_is_not_the_coordinate(pendulum: Bench) -> None:
    reason = pendulum.reason("abs(theta')*L", "theta'*L", VELOCITY)
    assert re.fullmatch(r"for L = \d m, θ' = -\d 1/s: option (\d+) m/s, answer -\1 m/s", reason)


def test_the_size_of_a_constant_is_taken_with_the_sign_that_the_model_gives_it(atwood: Bench) -> None:
    reason = atwood.reason("g*abs(m1 - m2)/(m1 + m2)", "g*(m1 - m2)/(m1 + m2)", ACCELERATION)
    assert reason == "identical to the result for m₁ - m₂ > 0"
    assert not atwood.is_right("g*abs(m2 - m1)/(m1 + m2)", "g*(m2 - m1)/(m1 + m2)", ACCELERATION)


def test_a_power_of_a_sum_too_long_to_multiply_out_is_decided_by_numbers(atwood: Bench, within: Within) -> None:
    factors = "((m1 + m2 + M)/M)^40*((m1 + M)/(m1 + m2 + M))^40*(M/(m1 + M))^40"
    assert atwood.reason(f"g*{factors}", "g", ACCELERATION) == "equal to 40 digits at 12 random points"
    within(1_000_000, lambda: atwood.reason(f"g*{factors}", "g", ACCELERATION))


def test_named_measures_and_their_rates_mean_what_the_constraints_make_of_them(atwood: Bench) -> None:
    assert atwood.is_right("-x2'", "x1'", VELOCITY)
    assert atwood.is_right("x1_dot", "x1'", VELOCITY)
    assert atwood.is_right("R*abs(w')*R*abs(w')", "x1'^2", VELOCITY**2)


# -- vectors and counts -----------------------------------------------------------------------
def test_a_vector_is_right_when_both_components_are(atwood: Bench) -> None:
    options = {
        "a": "[m1*g, -m2*g]",
        "b": "[m1*g, m2*g]",
        "c": "m1*g",
        "d": "[m1*g, m2]",
        "e": "[m1*g, m2*g, 0]",
    }
    judgement = atwood.judge(options, ("g*m1", "-g*m2"), FORCE, key="a")
    assert judgement.choice == "a"
    assert {letter: v.reason for letter, v in judgement.options.items()} == {
        "a": "identical to the result",
        "b": "y component: has the opposite sign",
        "c": "is a single number, the answer is a vector [x, y]",
        "d": "y component: has the unit kg, the answer has N",
        "e": "is a vector [x, y, z], the answer is a vector [x, y]",
    }


def test_a_count_is_compared_as_a_number(atwood: Bench) -> None:
    options = {"a": "0", "b": "1", "c": "2", "d": "3", "e": "infinity", "f": "inf", "g": "∞"}
    judgement = atwood.judge(options, Fraction(1), DIMENSIONLESS, key="b")
    assert judgement.choice == "b"
    assert judgement.options["c"].reason == "is 2, the answer is 1"
    assert {judgement.options[k].reason for k in "efg"} == {"is infinite, the answer is 1"}


# -- special cases and counterexamples --------------------------------------------------------
def test_small_numbers_decide_where_no_special_case_does(pendulum: Bench) -> None:
    reason = pendulum.reason("sqrt(g/L)*(1 + theta^2/8)", "sqrt(g/L)*(1 + theta^2/16)", ANGULAR_VELOCITY)
    assert reason == "for L = 1 m, g = 9.81 m/s^2, θ = 60°: option 3.561 1/s, answer 3.347 1/s"


def test_an_option_that_is_not_real_is_said_to_be_so(pendulum: Bench) -> None:
    assert pendulum.reason("sqrt(-1 - a)", "a", DIMENSIONLESS) == "for a = 1: option not a real number, answer 1"


def test_a_right_angle_is_a_special_case(disk: Bench) -> None:
    reason = disk.reason("g*sin(alpha)*cos(alpha)", "g*sin(alpha)^2", ACCELERATION)
    assert reason == "for α = 90° the answer is g, this option gives 0"


def test_no_special_case_is_told_where_a_root_changes_its_sign_on_the_way_to_it(pendulum: Bench) -> None:
    # sqrt((a - b)^2) is a - b with the numbers of the model, but b as a goes to 0
    reason = pendulum.reason("abs(a - b) + a", "2*b - a", DIMENSIONLESS)
    assert not reason.startswith("for a = 0")


# -- closed loops -----------------------------------------------------------------------------
def crank_at(theta: float) -> Sample:
    from math import asin, cos, pi, sin

    r, length = 0.1, 0.3
    phi = asin(r * sin(theta) / length)
    x, y = r * cos(theta), r * sin(theta)
    poses = {
        "crank": (x / 2, y / 2, theta),
        "rod": (x + length * cos(phi) / 2, y / 2, -phi % (2 * pi) - 2 * pi),
        "piston": (x + length * cos(phi), 0.0, 0.0),
    }
    return Sample({"r": r, "l": length, "m3": 3.0, "g0": 9.81}, poses, {})


def test_coordinates_that_a_loop_binds_are_compared_at_poses_of_the_mechanism() -> None:
    crank = bench(CRANK, *(crank_at(theta) for theta in (0.7, 1.1, 2.0)))
    assert crank.model.loops
    judgement = crank.judge({"a": "l*sin(phi)", "b": "l*cos(phi)"}, "r*sin(theta)", LENGTH)
    assert judgement.options["a"].reason == "equal to 8 digits at 3 poses of the mechanism"
    assert judgement.options["b"].reason.startswith("with the model's own numbers: option 0.29")
    assert crank.is_right("l*phi'*cos(phi)", "r*theta'*cos(theta)", VELOCITY)
    assert not crank.is_right("sqrt(r^2 - r^2*cos(theta)^2)", "r*sin(theta)", LENGTH)
    # where theta is the one that follows from the loop, a pose beyond the dead centre tells a root from the sine
    bound = bench(CRANK.replace("theta: 40 deg", "phi: 10 deg"), *(crank_at(theta) for theta in (0.7, 1.1, 4.0)))
    assert not bound.is_right("sqrt(r^2 - r^2*cos(theta)^2)", "r*sin(theta)", LENGTH)
    energy = crank.judge({"a": "m3*g0*l*sin(phi) + m3*g0*r"}, "m3*g0*r*sin(theta)", ENERGY, up_to_constant=True)
    assert energy.options["a"].reason == "equal up to a constant to 8 digits at 3 poses of the mechanism"


# -- the same, and quickly --------------------------------------------------------------------
def test_reasons_are_the_same_in_every_run() -> None:
    first, second = (bench(GEAR).judge(GEAR_OPTIONS, GEAR_OPTIONS["c"], ANGULAR_ACCELERATION) for _ in range(2))
    assert first == second


def test_a_textbook_option_takes_half_a_million_calls(atwood: Bench, within: Within) -> None:
    within(500_000, lambda: atwood.judge(ATWOOD_TENSION, ATWOOD_TENSION["e"], FORCE))
