"""What holds for all admissible values: against textbook inequalities, and against random numbers."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np
import pytest

from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.decide import Trials, decide, deciding, implied, possible, sign_given
from freebody.symbolic.functions import functions
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.signs import Sign
from freebody.symbolic.tidy import tidy

POSITIVE, REAL, ACUTE = ("a", "b", "c", "d"), ("x", "y", "theta"), ("beta",)


@pytest.fixture(scope="module")
def names() -> dict[str, Any]:
    f = SignedField()
    known: dict[str, Any] = {name: f.parameter(name, positive=True) for name in (*POSITIVE, *ACUTE)}
    known |= {name: f.parameter(name) for name in REAL}
    f.acute_angles.add(f.index(known["beta"]))
    return {**functions(f), **known, "field": f}


def element(names: dict[str, Any], text: str) -> Ratio:
    return names["field"].element(eval(text, {"__builtins__": {}}, names))  # texts of this file


def conditions(names: dict[str, Any], texts: tuple[str, ...]) -> list[Condition]:
    """`a - b` means a - b > 0, `a - b >= 0` and `a - b != 0` what they say."""
    found: list[Condition] = []
    for text in texts:
        parts = text.split()
        relation = parts[-2] if parts[-1] == "0" and parts[-2] in (">=", "!=") else ">"
        found.append(Condition(element(names, text if relation == ">" else " ".join(parts[:-2])), relation))
    return found


HOLDS: list[tuple[str, str, tuple[str, ...]]] = [
    ("7 - 2*sqrt(number(7))", ">", ()),
    ("9*pi - 16", "!=", ()),
    ("sqrt(number(2)) + sqrt(number(3)) - pi", ">", ()),  # by 0.005
    ("a**2 + b**2 - 2*a*b", ">=", ()),
    ("a**2 + b**2 - a*b", ">", ()),
    ("x**2 - 2*x*y + 2*y**2", ">=", ()),
    ("x**2 - 2*x*y + 2*y**2 + a", ">", ()),
    ("a**3 + b**3 + c**3 - 3*a*b*c", ">=", ()),  # arithmetic and geometric mean
    ("(a + b)*(b + c)*(c + a) - 8*a*b*c", ">=", ()),
    ("a**4 + b**4 - a**3*b - a*b**3", ">=", ()),
    ("a + b - c", ">", ("a - c",)),
    ("a**2 - b**2", ">", ("a - b",)),
    ("a*d - b*c", ">", ("a - b", "d - c")),
    ("d - a", ">", ("d - b", "b - c", "c - a")),
    ("a - b", "!=", ("a - 2*b",)),
    ("a - b", "!=", ("a**2 - b**2 != 0",)),
    ("a**2 - b**2*sin(theta)**2", ">", ("a - b",)),
    ("a**2 - b**2*sin(theta)**2", ">=", ("a - b >= 0",)),
    ("a**2 - (b*sin(theta) + c)**2", ">", ("a - b - c",)),
    ("a**2 + b**2 - 2*a*b*cos(theta)", ">=", ()),
    ("a**2 + b**2 - 2*a*b*cos(theta)", ">", ("a - b",)),
    ("(a + b)*c**2 - b*c**2*cos(theta)**2", ">", ()),
    ("cos(beta) + sin(beta) - 1", ">", ()),
    ("2 - sin(theta) - cos(theta)", ">", ()),
    ("7*a*cos(beta) - 2*sin(beta)", ">", ("a*cos(beta) - sin(beta)",)),
    ("sqrt(a**2 + b**2) - a", ">", ()),
    ("a + b - sqrt(a**2 + b**2)", ">", ()),
    ("sqrt(a**2 + b**2) + sqrt(c**2 + d**2) - sqrt((a + c)**2 + (b + d)**2)", ">=", ()),  # triangle inequality
]

# each holds somewhere and not everywhere (or only with equality), so that saying either would be false
OPEN: list[tuple[str, str, tuple[str, ...]]] = [
    ("a - b", ">", ()),
    ("a**2 + b**2 - 2*a*b", ">", ()),  # a = b
    ("a**2 + b**2 - 2*a*b", "!=", ()),
    ("x**2 - 2*x*y + 2*y**2", ">", ()),
    ("a**2 + b**2 - 2*a*b*cos(theta)", ">", ()),
    ("a**2 - b**2*sin(theta)**2", ">", ()),
    ("a**2 - b**2*sin(theta)**2", ">", ("a - b >= 0",)),
    ("a**2 - (b*sin(theta) + c)**2", ">", ("a - b",)),
    ("1 + cos(theta)", ">", ()),
    ("1 - sin(theta)", "!=", ()),
    ("cos(theta)", ">", ()),
    ("a*cos(beta) - sin(beta)", ">", ()),
    ("(b + c - a)*(a + c - b)*(a + b - c)", ">", ("a - b", "c - a")),
    ("sqrt(a**2 + b**2) - c", ">", ()),
    ("1001*a - 1000*b", ">", ("a - b + c",)),
]


@pytest.mark.parametrize(("text", "relation", "premises"), HOLDS)
def test_what_holds_everywhere_is_decided(names: Any, text: str, relation: str, premises: tuple[str, ...]) -> None:
    assert decide(element(names, text), relation, conditions(names, premises)) is True
    if relation != "!=":
        strict_opposite = decide(-element(names, text), ">", conditions(names, premises))
        assert strict_opposite is False


@pytest.mark.parametrize(("text", "relation", "premises"), OPEN)
def test_what_holds_only_somewhere_stays_open(names: Any, text: str, relation: str, premises: tuple[str, ...]) -> None:
    assert decide(element(names, text), relation, conditions(names, premises)) is None


def test_a_parameter_that_may_be_zero_makes_nothing_strict() -> None:
    f = SignedField()
    h, a = f.parameter("h"), f.parameter("a", positive=True)
    f.nonnegative.add(f.index(h))
    assert decide(h, ">=") is True
    assert decide(h, ">") is None
    assert decide(h + a, ">") is True
    assert decide(h * h + h * a + a * a, ">") is True
    assert decide(h * h + h * a, ">") is None


def test_conditions_that_exclude_each_other_are_impossible_together(names: Any) -> None:
    def together(*texts: str) -> bool | None:
        return possible(conditions(names, texts))

    assert together("a - b", "b - a - c") is False
    assert together("a - b", "b - c", "c - a") is False
    assert together("a - b", "a - b - c") is True
    assert together("a*cos(beta) - sin(beta)", "7*a*cos(beta) - 2*sin(beta)") is True
    assert together("-7*a*cos(beta) + 2*sin(beta)", "a*cos(beta) - sin(beta)") is False
    assert together("x**2 - a", "a - 2*x**2") is False
    assert implied(conditions(names, ("a + b - c",))[0], conditions(names, ("a - c",)))


def test_no_decision_is_contradicted_by_numbers(names: Any) -> None:
    """Random polynomials in positive, real and trigonometric symbols, over ten decades."""
    seed = 20261122
    print(f"seed {seed}")
    rng = random.Random(seed)
    symbols = ["a", "b", "c", "x", "cos(theta)", "sin(theta)", "cos(beta)"]
    n_decided = 0
    for _ in range(150):
        some = rng.sample(symbols, 3)
        terms = [
            f"{rng.choice([-2, -1, 1, 1, 2, 3])}*" + "*".join(rng.choices(some, k=rng.choice([1, 2, 2, 3])))
            for _ in range(rng.randint(2, 4))
        ]
        has_premise = rng.random() < 0.4
        premises = conditions(names, ("a - b",)) if has_premise else []
        verdicts = {r: decide(element(names, " + ".join(terms)), r, premises) for r in (">", ">=", "!=")}
        n_decided += any(v is not None for v in verdicts.values())
        compiled = [compile(term, "term", "eval") for term in terms]
        for _point in range(60):
            point: dict[str, Any] = {n: 10.0 ** rng.uniform(-5, 5) for n in POSITIVE}
            point |= {"x": rng.choice([-1, 1]) * 10.0 ** rng.uniform(-5, 5), "theta": rng.uniform(-4.0, 4.0)}
            point |= {"beta": rng.uniform(0.0, math.pi / 2), "cos": math.cos, "sin": math.sin}
            if has_premise and point["a"] <= point["b"]:
                continue
            numbers = [eval(term, {"__builtins__": {}}, point) for term in compiled]
            v = sum(numbers)
            if abs(v) < 1e-12 * sum(map(abs, numbers)):
                continue
            for relation, is_true in ((">", v > 0), (">=", v >= 0), ("!=", v != 0)):
                assert verdicts[relation] in (None, is_true), (terms, relation, point)
    assert n_decided > 20


@pytest.mark.parametrize("text", ["sin(x - y)**2", "sin(x - y)**4", "-3*cos(x + y)**2", "5*sin(x)**2"])
def test_a_power_of_a_sine_vanishes_where_the_sine_does(names: dict[str, Any], text: str) -> None:
    # cos 4u - 4 cos 2u + 3 = 8 sin^4 u: a condition on it is one on sin u
    base = element(names, text.split("**", maxsplit=1)[0].lstrip("-0123456789*"))
    condition, can_hold = require(element(names, text), "!=")
    assert can_hold
    assert condition is not None
    assert condition.element in (base, -base)


def test_what_is_no_power_of_a_sine_stays_as_it_is(names: dict[str, Any]) -> None:
    condition, _possible = require(x := element(names, "sin(x - y)**2 - 2*cos(x + y)"), "!=")
    assert condition is not None
    assert condition.element in (x, -x)


def test_a_condition_on_one_name_beside_roots_of_numbers_is_solved_for_it() -> None:
    f = SignedField()
    mu, a = f.parameter("mu", positive=True), f.parameter("a")

    def root(n: int) -> Ratio:
        return f.sqrt(f.element(n))

    told = {
        "μ ≤ √(2)": (2 * root(3) - mu * root(6), ">="),
        "μ > √(2)": (mu * root(6) - 2 * root(3), ">"),
        "a ≠ -√(2)/2": (a * root(2) + 1, "!="),
        "a·√(2) > μ": (a * root(2) - mu, ">"),  # two names: as it stands
        "2·μ > 1": (2 * mu - 1, ">"),
    }
    for text, (x, relation) in told.items():
        assert Condition(x, relation).text() == text


def test_a_difference_of_squares_with_the_sine_of_an_acute_angle_is_the_difference_of_what_is_squared() -> None:
    # a cylinder with an eccentric weight rests on a slope where m^2 r^2 > (M + m)^2 R^2 sin^2 a: m r > (M + m) R sin a
    f = SignedField()
    m, M, r, R = (f.parameter(name, positive=True) for name in ("m", "M", "r", "R"))
    a = f.parameter("alpha", positive=True)
    f.acute_angles.add(f.index(a))
    sine = functions(f)["sin"](a)
    condition, possible_ = require(m**2 * r**2 - (M + m) ** 2 * R**2 * sine**2, ">")
    assert possible_
    assert condition is not None
    assert (condition.element - (m * r - (M + m) * R * sine)).is_zero()
    turned, _ = require((M + m) ** 2 * R**2 * sine**2 - m**2 * r**2, ">")
    assert turned is not None
    assert (turned.element + condition.element).is_zero()


# -- counterexamples first -----------------------------------------------------------------------
class At:
    """Points of a field by the names of its parameters."""

    def __init__(self, field: Any, points: list[dict[str, float]]) -> None:
        self.field, self.points = field, points

    def numbers(self, k: int) -> dict[int, float]:
        f = self.field
        return {f.index(f.parameter(name)): value for name, value in self.points[k].items()}

    def evaluate(self, x: Ratio) -> Any:
        values = [self.field.complete(self.numbers(k)) for k in range(len(self.points))]
        return np.array([float(self.field.evaluate(x, v)) for v in values])


def with_trials(points: list[dict[str, float]]) -> tuple[Any, dict[str, Ratio]]:
    """A field of positive parameters a, b, c that has been looked at in some points."""
    f = SignedField()
    known = {name: f.parameter(name, positive=True) for name in "abc"}
    f.trials = Trials(At(f, points))
    return f, known


def test_two_points_of_unlike_signs_end_the_question_before_any_cells_are_made(monkeypatch: pytest.MonkeyPatch) -> None:
    """a b^2 - c^3 is positive at (2, 1, 1) and negative at (1, 1, 2): no premise that holds at both gives it a sign."""
    _f, known = with_trials([{"a": 2.0, "b": 1.0, "c": 1.0}, {"a": 1.0, "b": 1.0, "c": 2.0}])
    a, b, c = known.values()
    monkeypatch.setattr(deciding, "CellDecomposition", lambda *_any: pytest.fail("cells were made"))
    premise = Condition(a + 2 * b - c, ">")
    assert sign_given(a * b**2 - c**3, [premise]) is Sign.UNKNOWN
    assert not implied(Condition(a * b**2 - c**3, ">"), [premise])


def test_points_outside_of_the_premises_refute_nothing() -> None:
    """a^2 > b^2 where a > b, though it is not so at (1, 2)."""
    _f, known = with_trials([{"a": 2.0, "b": 1.0, "c": 1.0}, {"a": 1.0, "b": 2.0, "c": 1.0}])
    a, b, _c = known.values()
    assert implied(Condition(a**2 - b**2, ">"), [Condition(a - b, ">")])
    assert not implied(Condition(a**2 - b**2, ">"), [])


def test_what_only_round_off_refutes_is_not_refuted() -> None:
    """(a - b)^2 - c is 63.5 at a = b + 8, and written out in doubles -512, round-off of 4e18."""
    f, known = with_trials([{"a": 1901749045.0, "b": 1901749037.0, "c": 0.5}])
    a, b, c = known.values()
    x = a**2 - 2 * a * b + b**2 - c
    assert f.trials.points.evaluate(x)[0] < 0
    assert not f.trials.refute([x], 1, [])


def test_an_element_is_written_once_however_often_it_is_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    _f, known = with_trials([{"a": 2.0, "b": 1.0, "c": 1.0}])
    a, b, c = known.values()
    first = tidy(a * b + a * c)
    monkeypatch.setattr("freebody.symbolic.tidy._as_it_is", lambda _x: pytest.fail("written again"))
    assert tidy(a * (b + c)) is first
