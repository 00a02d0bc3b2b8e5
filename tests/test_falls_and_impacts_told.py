"""What is said of falls, bounces and strings that come taut: how far, and what an impact takes."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, Symbol, evaluate
from freebody.language.notation import to_text
from freebody.narrative.sharing import lines_of
from freebody.study.setup import Setup
from freebody.symbolic.functions import functions
from freebody.symbolic.tidy import tidy

DROP = """
parameters: {m: 1 kg, h: 2 m, g: 9.81 m/s^2, e: 0.8, r: 0.1 m}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {touch: {contact: {between: [ball, floor], restitution: e, touching: false}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball, x: x of ball}
start: {y: h, rate(y): 0}
"""
FALL = """
parameters: {{m: 1 kg, h: 2 m, g: 9.81 m/s^2}}
bodies: {{ball: {{particle: {{mass: m}}}}}}
connections: {{s: {{slider: {{body: ball, along: up}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{y: y of ball}}
start: {{y: h, rate(y): {rate} m/s}}
"""
BOB_IN_X_AND_Y = """
parameters: {m: 1 kg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {cord: {string: {from: ground.O, to: bob, swings: true}}}
loads: {weight: {gravity: g}}
measures: {x: x of bob, y: y of bob}
start: {x: 0, y: -1 m, rate(x): 5.5 m/s, rate(y): 0}
"""


def asked(text: str, question: str) -> fb.Answer:
    return fb.System.from_text(text).solve(question).answers[0]


def test_what_is_dropped_has_been_highest_at_the_start() -> None:
    answer = asked(DROP, "greatest y")
    assert answer.value == 2.0
    assert any("at the start" in note for note in answer.notes)
    assert asked(FALL.format(rate=0), "greatest y").value == 2.0
    assert asked(FALL.format(rate=-1), "greatest y").value == 2.0
    assert asked(FALL.format(rate=1), "greatest y").value == pytest.approx(2 + 1 / (2 * 9.81))


def test_the_start_is_no_greatest_value_of_what_comes_later() -> None:
    # behind the impact the ball rises to r + e^2 (h - r): it begins at the floor
    assert asked(DROP, "greatest y after the impact").value != pytest.approx(0.1)


@pytest.mark.parametrize("rate", [-1, 0, 1])
def test_what_falls_has_no_least_height(rate: int) -> None:
    answer = asked(FALL.format(rate=rate), "least y")
    assert answer.value is None
    assert "y falls without end" in answer.reason


def test_energy_in_the_blow_is_the_mechanical_energy() -> None:
    # (1 - e^2) m g (h - r) goes
    answer = asked(DROP, "is energy conserved in the blow")
    assert answer.conditions[0] == "not conserved in the blow"
    assert answer.value == pytest.approx(-(1 - 0.64) * 9.81 * 1.9)


def test_an_impact_in_the_course_of_the_motion_is_none_at_the_start() -> None:
    told = fb.System.from_text(DROP + "questions: [energy lost in the impact]").explain().to_text()
    assert "Energy lost in the blow\n" in told
    assert "blow at the start" not in told
    assert "e → ∞" not in told  # a coefficient of restitution is at most 1


def test_a_cord_that_comes_taut_again_takes_the_velocity_along_it() -> None:
    """It goes slack at the angle a above the level with 3 g L sin a = v0^2 - 2 g L and v^2 = g L sin a, and is taut
    again after 4 v cos(a)/g."""
    g, v0 = 9.81, 5.5
    up = (v0**2 - 2 * g) / (3 * g)
    beside = math.sqrt(1 - up**2)
    v = math.sqrt(g * up)
    t = 4 * v * beside / g
    place = (beside - up * v * t, up + beside * v * t - g * t * t / 2)
    along = place[0] * (-up * v) + place[1] * (beside * v - g * t)
    assert math.hypot(*place) == pytest.approx(1.0, rel=1e-12)
    assert asked(BOB_IN_X_AND_Y, "energy lost in the impact").value == pytest.approx(along**2 / 2, rel=1e-9)


def test_arcs_of_one_sine_or_cosine_add_up() -> None:
    f = (model := Setup(fb.System.from_text(FALL.format(rate=0))).model).field
    asin, acos = (functions(f)[name] for name in ("asin", "acos"))
    u = model.geometry.scalar(Symbol("h")) / (1 + model.geometry.scalar(Symbol("h")))
    assert (asin(u) + acos(u) - f.pi / 2).is_zero()
    assert (acos(u) + acos(-u) - f.pi).is_zero()
    assert (asin(u) + asin(-u)).is_zero()
    assert [to_text(tidy(x)) for x in (f.pi / 2 - asin(u), acos(u) - f.pi / 2)] == [
        "acos(h/(h + 1))",
        "-asin(h/(h + 1))",
    ]


def test_a_ball_leaves_a_drum_at_an_angle_from_the_horizontal() -> None:
    # rolling from rest: N = m g cos(phi) - m v^2/(R + r) with 7 v^2 = 10 g (R + r)(cos(phi0) - cos(phi))
    text = """
parameters: {m: 0.3 kg, r: 0.05 m, R: 0.5 m, phi0: 10 deg, g: 9.81 m/s^2}
bodies:
  drum: {disk: {mass: 1 kg, radius: R}, fixed: true}
  ball: {sphere: {mass: m, radius: r}, at: [(R + r)*sin(phi0), (R + r)*cos(phi0)]}
connections: {contact: {rolling: {body: ball, on: drum}}}
loads: {weight: {gravity: g}}
measures:
  phi: {angle of line from ground.origin to ball from up clockwise}
  chi: angle of line from ground.origin to ball from right
start: {phi: phi0}
"""
    answer = asked(text, "chi when ball leaves the drum")
    assert answer.expression is not None
    assert not isinstance(answer.expression, tuple)
    assert to_text(answer.expression) == "asin(10·cos(φ₀)/17)"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            DROP.replace("sphere: {mass: m, radius: r}}", "sphere: {mass: m, radius: r}, at: [0, 0.06 m]}").split(
                "start:"
            )[0],
            "at the start ball is 0.04 m inside floor (touch). Move them apart",
        ),
        (
            DROP.replace(", touching: false", "").replace("y: h,", "y: 0.06 m,"),
            "as it is given, ball is 0.04 m inside floor (touch). Give a start in which they touch or are apart",
        ),
        (
            FALL.format(rate=0).replace("along: up}}}", "along: up}}, catch: {stop: {measure: y, max: 1.5 m}}}"),
            "at the start y is beyond its max by 0.5 m (catch). Start within the limits, or change them",
        ),
        (
            """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {p: {pin: [ground.O, rod.start]}, catch: {stop: {measure: th, max: 30 deg}}}
measures: {th: angle of rod}
start: {th: 50 deg}
""",
            "th is beyond its max by 20° (catch)",
        ),
    ],
)
def test_an_impossible_start_is_named_with_the_bodies_the_depth_and_the_cure(text: str, told: str) -> None:
    with pytest.raises(fb.FreebodyError) as refused:
        fb.System.from_text(text).simulate(0.1)
    assert told in str(refused.value)


# -- what numbers and reasons say ----------------------------------------------------------------
def test_the_work_on_a_way_out_and_back_is_that_of_a_constant_force() -> None:
    """Nothing from x = 0 to x = 0, F d from there to -d; the turn between is an instant among those that are summed."""
    cart = """
parameters: {m: 1 kg, F: 4 N, v: 3 m/s}
bodies: {c: {particle: {mass: m}}}
connections: {t: {slider: {body: c, along: right}}}
loads: {pull: {force: {at: c, along: left, magnitude: F}}}
measures: {x: x of c}
start: {x: 0, rate(x): v}
"""
    assert asked(cart, "work of pull until x = 0").value == 0.0
    assert asked(cart, "work of pull until x = -1 m").value == pytest.approx(4)


def test_a_string_at_the_top_is_taut_by_conditions_on_parameters() -> None:
    # T = m v0^2/L - 5 m g at the top is the least of the way up, also where no sample gets there
    text = """
parameters: {m: 0.5 kg, L: 1 m, v0: 6.5 m/s, g: 9.81 m/s^2}
bodies: {b: {particle: {mass: m}}}
connections: {s: {string: {from: ground.O, to: b, swings: true}}}
loads: {weight: {gravity: g}}
measures: {th: angle of line from ground.O to b from down, r: distance from ground.O to b}
start: {r: L, th: 0, rate(th): v0/L}
"""
    answer = asked(text, "tension of s when th = 180 deg")
    assert answer.conditions == ("v₀² ≥ 5·L·g (s stays taut)",)
    assert answer.value is None
    assert asked(text, "range of v0 for which tension of s > 0 when th = 180 deg").conditions == (
        "for all positive parameters",
    )


def test_masses_in_balance_are_told_what_an_event_needs() -> None:
    text = """
parameters: {m1: 3 kg, m2: 3 kg, g: 9.81 m/s^2}
ground: {points: {C: [0, 1 m]}}
bodies: {a: {particle: {mass: m1}}, b: {particle: {mass: m2}}, pulley: {disk: {mass: 1 kg, radius: 0.1 m}}}
connections: {p: {pin: [ground.C, pulley]}, rope: {string: {from: a, over: [pulley], to: b}}}
loads: {weight: {gravity: g}}
measures: {x: drop of a}
"""
    assert asked(text, "velocity of x when x = 1 m").reason.endswith("that needs m₁ > m₂")


def test_a_number_is_never_that_of_another_equilibrium() -> None:
    text = """
parameters: {m: 1 kg, l: 0.5 m, g: 9.81 m/s^2}
bodies: {a: {rod: {mass: m, length: l}}, b: {rod: {mass: m, length: l}}}
connections: {r1: {pin: [ground.O, a.start]}, r2: {pin: [a.end, b.start]}}
loads: {weight: {gravity: g}}
measures: {p: angle of a from down, q: angle of b from down}
start: {p: 10 deg, q: 0}
"""
    with pytest.raises(fb.ModelError, match="cannot read 'stability of the equilibrium p = 180 deg'"):
        asked(text, "stability of the equilibrium p = 180 deg")  # upside down it is unstable, near the start it is not


TWO_BALLS = """
parameters: {m1: 1 kg, m2: 2 kg, d: 1 m, v0: 3 m/s, e: {value: 0, sign: any}}
bodies: {A: {particle: {mass: m1}}, B: {particle: {mass: m2}, at: [d, 0]}}
connections:
  rail_A: {slider: {body: A, along: right}}
  rail_B: {slider: {body: B, along: right}}
  hit: {contact: {between: [A, B], restitution: e}}
measures: {x_A: x of A, x_B: x of B}
start: {x_A: 0, x_B: d, rate(x_A): v0, rate(x_B): 0}
"""


def test_what_an_impact_takes_is_told_by_the_energies_before_and_after() -> None:
    told = fb.explain(fb.System.from_text(TWO_BALLS), "energy lost in the impact")
    text = " ".join(told.to_text().split())
    assert "Energy lost in the impact" in text
    assert "hit stays closed after the impact only if the coefficient of restitution is zero" in text
    assert "tried before" not in text
    assert "(n)" not in text
    last = lines_of(told.derivations[0].stages)[-1]
    numbers = {"m1": 1.0, "m2": 2.0, "v0": 3.0, "e": 0.0}
    assert len(last.sides) == 3  # Q, the difference, what it comes to
    # 1 kg (3 m/s)^2/2 before, 3 kg (1 m/s)^2/2 after
    assert [evaluate(side, numbers, FLOAT_FUNCTIONS) for side in last.sides[1:]] == pytest.approx([3.0, 3.0])


def test_a_velocity_after_a_blow_is_not_told_by_a_connection() -> None:
    text = """
parameters: {m: 3 kg, R: 0.2 m, h: {value: 60 mm, sign: any}, J: 9 N s, mu: 0.25, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {disk: {disk: {mass: m, radius: R}, points: {mark: [0, h]}}}
connections: {contact: {contact: {between: [disk, floor], friction: mu}}}
loads: {weight: {gravity: g}, hammer: {impulse: {at: disk.mark, along: right, magnitude: J}}}
measures: {x: {x of disk}, turn: {angle of disk clockwise}}
start: {x: 0, rate(x): 0, turn: 0, rate(turn): 0}
"""
    told = fb.explain(fb.System.from_text(text), "velocity of x at start").to_text()
    assert "law of the connection" not in told
    assert "Just after the blow, with" in told
