"""What is conserved, and when: against the principles as textbooks state them."""

from __future__ import annotations

import functools
import json
import math
from pathlib import Path

import pytest
from typer.testing import CliRunner

import freebody as fb
from freebody.cli import commands
from freebody.errors import ModelError
from freebody.language.expression import evaluate
from freebody.language.parser import parse
from freebody.study.conservation.conservation import Conservation
from freebody.study.conservation.conserved import conserved
from freebody.study.conservation.judge import _along
from freebody.study.conservation.verdicts import Verdicts
from freebody.study.settled import start_mode
from goldens import assert_golden

FOLDER = Path(__file__).parents[1] / "examples"
G = "g: 9.81 m/s^2"


def found(text: str, question: str | None = None) -> Conservation:
    return conserved(fb.System.from_text(text), question)


def judged(text: str, question: str) -> Verdicts:
    return found(text, question).quantities[0]


def kept(text: str) -> set[str]:
    """What a search finds to be conserved for every motion."""
    return {v.question for v in found(text).quantities if v.is_conserved is True}


def is_rate(verdict: Verdicts, formula: str, **values: float) -> None:
    """The rate is a formula, at the given numbers; names such as rate(theta) are written d_theta."""
    names = {key.replace("d_", "rate(", 1) + ")" if key.startswith("d_") else key: v for key, v in values.items()}
    assert verdict.rate is not None
    plain = {k: v for k, v in names.items() if "(" not in k}
    expected = evaluate(parse(formula), {**plain, **names})
    assert float(evaluate(verdict.rate, names)) == pytest.approx(float(expected), rel=1e-12, abs=1e-12)


# -- the body on a driven roller --------------------------------------------------------------
ROLLER = """
parameters: {{m: 2 kg, I: 0.1 kg m^2, d: {d}, a: 1 m/s^2, x0: {{function: a*t^2/2, unit: m}}, g: 9.81 m/s^2}}
bodies: {{roller: {{particle: {{}}}}, body: {{body: {{mass: m, inertia: I, center_of_mass: [d, 0]}}}}}}
connections:
  guide: {{slider: {{body: roller, along: right}}}}
  hinge: {{pin: [roller, body.origin]}}
  motor: {{driver: {{measure: x, follows: {follows}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: x of roller, theta: angle of body from down}}
"""
ABOUT = "angular momentum of body about roller"


def test_the_moment_of_momentum_about_the_driven_roller_is_kept_if_and_only_if_the_mass_centre_is_there() -> None:
    verdict = judged(ROLLER.format(d="0.3 m", follows="x0"), ABOUT)
    assert verdict.is_conserved is None
    assert verdict.conditions == ("d = 0",)
    assert verdict.when == "if and only if d = 0 (for m, g ≠ 0)"
    # dH_O/dt = M_O - v_O x P
    is_rate(
        verdict, "-m*d*sin(theta)*(g + rate(x0)*rate(theta))", m=2, d=0.3, theta=0.7, g=9.81, d_x0=1.3, d_theta=-0.4
    )
    assert any("mass centre of body coincides with roller" in note for note in verdict.notes)
    assert verdict.confirmation is not None
    assert verdict.confirmation.largest_drift is not None
    assert verdict.confirmation.largest_drift < 1e-9
    assert verdict.confirmation.smallest_change is not None
    assert verdict.confirmation.smallest_change > 1e-3
    assert verdict.counter is not None
    assert verdict.counter.before != pytest.approx(verdict.counter.after, rel=1e-3)


def test_the_principle_names_its_parts() -> None:
    verdict = judged(ROLLER.format(d="0.3 m", follows="x0"), ABOUT)
    assert "moving point" in verdict.principle
    assert {name for name, _part in verdict.parts} == {"moment of weight", "-v × P"}


def test_a_roller_that_stands_still_leaves_gravity_as_the_only_moment() -> None:
    text = ROLLER.format(d="0.3 m", follows="0 m")
    assert judged(text, ABOUT).conditions == ("d = 0",)
    without = text.replace("loads: {weight: {gravity: g}}", "")
    assert judged(without, ABOUT).is_conserved is True


def test_options_on_the_roller_are_judged_by_logic_and_not_by_their_words() -> None:
    asked = {
        "always": "wrong",
        "only if |rate(x0)| is constant": "wrong",
        "only if |rate(x0)| = 0": "wrong",
        "if body.mass_center coincides with roller": "right",
        "d = 0": "right",
        "2*d = 0": "right",
        "if d = 0 and g = 0": "wrong",
        "m*d = 0": "right",  # the same, since there is a mass
        "never": "wrong",
        "if the moon is full": "unreadable",
        "0.5": "unreadable",
        "if dd = 0": "unreadable",
        "if d = 1 kg": "unreadable",
    }
    options = ", ".join(f"o{k}: '{text}'" for k, text in enumerate(asked))
    text = ROLLER.format(d="{value: 0.3 m, sign: any}", follows="x0")
    text += f"\nquestions: [{{id: q, find: is {ABOUT} conserved, options: {{{options}}}}}]"
    verdict = found(text)["q"]
    got = {text: verdict.options[f"o{k}"].verdict for k, text in enumerate(asked)}
    assert got == asked
    reasons = {text: verdict.options[f"o{k}"].reason for k, text in enumerate(asked)}
    assert "neither" in reasons["only if |rate(x0)| is constant"]
    assert "sufficient only" in reasons["if d = 0 and g = 0"]
    assert "did you mean" in reasons["if dd = 0"].lower()
    assert len(verdict.author_notes) > 0  # two are right, four cannot be read


def test_a_condition_that_is_necessary_only_is_called_so() -> None:
    text = """
parameters: {m: 1 kg, F: {value: 2 N, sign: any}, H: {value: 1 N, sign: any}}
bodies: {ball: {particle: {mass: m}}}
loads: {a: {force: {at: ball, along: right, magnitude: F}}, b: {force: {at: ball, along: right, magnitude: H*t/(1 s)}}}
questions:
  - {id: q, find: is linear momentum along right conserved,
     options: {a: F = 0, b: F = 0 and H = 0, c: F = H, d: only if H = 0}}
""".replace("H*t/(1 s)", "H*t/T").replace("H: {value", "T: 1 s, H: {value")
    verdict = found(text)["q"]
    assert verdict.conditions in (("F = 0 and H = 0",), ("H = 0 and F = 0",))
    assert verdict.choice == "b"
    assert "necessary only" in verdict.options["a"].reason
    assert "necessary only" in verdict.options["d"].reason
    assert "necessary only" in verdict.options["c"].reason


def test_a_condition_on_the_driver_alone_is_found() -> None:
    text = """
parameters: {m: 1 kg, s0: {function: b*t^3, unit: m}, b: 0.4 m/s^3}
bodies: {block: {particle: {mass: m}}}
connections: {rail: {slider: {body: block, along: right}}, motor: {driver: {measure: x, follows: s0}}}
measures: {x: x of block, y: y of block}
questions:
  - {id: q, find: is linear momentum along right conserved,
     options: {a: rate(s0) is constant, b: s0 is constant, c: always}}
"""
    verdict = found(text.replace("along: right}}, motor", "along: right, through: ground.origin}}, motor"))["q"]
    assert verdict.is_conserved is None
    assert "is constant" in verdict.conditions[0]
    assert verdict.choice == "a"
    assert "sufficient only" in verdict.options["b"].reason


# -- searches ---------------------------------------------------------------------------------
def test_a_free_rod_keeps_all_momenta_and_its_energy() -> None:
    text = "bodies: {rod: {rod: {mass: 2 kg, length: 1 m}, velocity: [1 m/s, 0], angular_velocity: 3 rad/s}}"
    names = kept(text)
    assert {
        "total energy",
        "linear momentum along right",
        "linear momentum along up",
        "angular momentum about its mass center",
    } <= names
    assert all(v.is_conserved for v in found(text).quantities)


def test_a_pendulum_on_a_cart_keeps_the_horizontal_momentum_and_the_energy_only() -> None:
    text = f"""
parameters: {{M: 2 kg, m: 1 kg, L: 1 m, {G}}}
bodies: {{cart: {{body: {{mass: M, inertia: 1 kg m^2}}}}, rod: {{rod: {{mass: m, length: L}}}}}}
connections: {{rail: {{slider: {{body: cart, along: right}}}}, hinge: {{pin: [cart, rod.start]}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: x of cart, theta: angle of rod from down}}
"""
    assert kept(text) == {"total energy", "linear momentum along right", "generalized momentum of x"}


def test_a_bead_on_a_rod_that_turns_steadily_keeps_the_jacobi_integral_and_not_the_energy() -> None:
    """Goldstein, Classical Mechanics, sec. 2.7: h = m r'^2/2 - m w^2 r^2/2, while dE/dt = 2 m w^2 r r'."""
    text = """
parameters: {m: 1 kg, w: 2 rad/s}
bodies: {rod: {rod: {length: 4 m}}, bead: {particle: {mass: m}, near: {at: [1 m, 0]}}}
connections:
  axle: {pin: [ground.O, rod.center]}
  slot: {slot: {pin: bead, along: rod.x, on: rod}}
  motor: {driver: {measure: angle of rod, follows: w*t}}
measures: {r: travel of bead along rod.x from rod.center}
start: {r: 1 m}
"""
    result = {v.question: v for v in found(text).quantities}
    assert result["Jacobi integral"].is_conserved is True
    energy = result["total energy"]
    assert energy.is_conserved is not True
    is_rate(energy, "2*m*w^2*r*rate(r)", m=1.3, w=2.1, r=0.8, d_r=0.6)
    assert energy.conditions == ("w = 0",)


def test_a_disk_rolling_down_an_incline_keeps_its_energy_only() -> None:
    result = conserved(fb.System.load(FOLDER / "disk_rolling_down_incline.yaml"))
    assert [v.question for v in result.quantities if v.is_conserved] == ["total energy"]
    # on the level everything is kept
    assert all("α = 0" in v.conditions for v in result.quantities if not v.is_conserved)


def test_two_bodies_joined_by_a_spring_keep_the_momenta_of_both_together() -> None:
    text = """
parameters: {m1: 1 kg, m2: 3 kg, k: 50 N/m}
bodies: {a: {particle: {mass: m1}, at: [0, 0]}, b: {particle: {mass: m2}, at: [1 m, 0.2 m]}}
loads: {s: {spring: {first: a, second: b, stiffness: k, length: 0.9 m}}}
"""
    names = kept(text)
    assert {
        "total energy",
        "linear momentum along right",
        "linear momentum along up",
        "angular momentum about its mass center",
    } <= names
    single = judged(text, "linear momentum of a along right")
    assert single.conditions == ("k = 0",)


def test_a_body_hinged_at_its_mass_centre_keeps_its_moment_of_momentum() -> None:
    text = f"""
parameters: {{m: 1 kg, I: 0.2 kg m^2, {G}}}
bodies: {{wheel: {{body: {{mass: m, inertia: I}}}}}}
connections: {{axle: {{pin: [ground.O, wheel]}}}}
loads: {{weight: {{gravity: g}}}}
"""
    assert {"angular momentum about ground.O", "total energy"} <= kept(text)


def test_a_damper_takes_energy_unless_it_is_none() -> None:
    text = """
parameters: {m: 1 kg, c: {value: 2 N s/m, sign: nonnegative}}
bodies: {ball: {particle: {mass: m}, at: [1 m, 0]}}
loads: {d: {damper: {first: ground.O, second: ball, damping: c}}}
"""
    verdict = judged(text, "total energy")
    assert verdict.conditions == ("c = 0",)
    assert judged(text, "angular momentum about ground.O").is_conserved is True


def test_a_spring_between_two_measures_stores_energy_however_its_law_is_written() -> None:
    assert judged((FOLDER / "two_masses_three_springs.yaml").read_text(), "total energy").is_conserved is True


def test_a_force_that_depends_on_another_place_has_no_potential() -> None:
    text = """
parameters: {m: 1 kg, k: 5 N/m}
bodies: {ball: {particle: {mass: m}}}
measures: {x: x of ball, y: y of ball}
loads: {swirl: {law: {measure: x, force: -k*y}}}
"""
    verdict = judged(text, "total energy")
    assert verdict.conditions == ("k = 0",)
    is_rate(verdict, "-k*y*rate(x)", k=2, y=0.3, d_x=0.7)


def test_equal_masses_are_a_condition() -> None:
    atwood = (FOLDER / "atwood_machine.yaml").read_text()
    verdict = judged(atwood, "linear momentum along up")
    assert verdict.conditions in (("m₁ = m₂",), ("m₂ = m₁",))


def test_a_closed_loop_is_judged_by_its_power_and_by_simulation() -> None:
    result = conserved(fb.System.load(FOLDER / "four_bar.yaml"))
    by_name = {v.question: v for v in result.quantities}
    assert by_name["total energy"].conditions == ("T = 0",)
    assert by_name["linear momentum along right"].is_conserved is False
    assert by_name["linear momentum along right"].counter is not None


def test_angular_momentum_of_a_double_pendulum_without_gravity_is_kept_about_its_hinge() -> None:
    text = """
parameters: {m: 1 kg, L: 1 m}
bodies: {upper: {rod: {mass: m, length: L}}, lower: {rod: {mass: m, length: L}}}
connections: {O: {pin: [ground.O, upper.start]}, P: {pin: [upper.end, lower.start]}}
"""
    names = kept(text)
    assert "angular momentum about ground.O" in names
    assert judged(text, "angular momentum of upper about ground.O").is_conserved is False


# -- bad input --------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("question", "hint"),
    [
        ("angular momentum of body about roler", "roler"),
        ("angular momentum of body about body.G", "G"),
        ("linear momentum of unicycle along right", "unicycle"),
        ("is the colour of body conserved", "colour"),
        ("reaction of hinge", "nothing that a motion keeps"),
    ],
)
def test_a_quantity_of_things_that_do_not_exist_is_refused_by_name(question: str, hint: str) -> None:
    with pytest.raises(ModelError, match=hint):
        judged(ROLLER.format(d="0.3 m", follows="x0"), question)


def test_a_vector_is_kept_if_both_components_are() -> None:
    text = f"""
parameters: {{m: 1 kg, F: {{value: 2 N, sign: any}}, {G}}}
bodies: {{ball: {{particle: {{mass: m}}}}}}
loads: {{push: {{force: {{at: ball, along: right, magnitude: F}}}}}}
questions: [{{id: q, find: is linear momentum of ball conserved, options: {{a: always, b: F = 0, c: never}}}}]
"""
    verdict = found(text)["q"]
    assert verdict.conditions == ("F = 0",)
    assert verdict.choice == "b"
    falling = text.replace("loads: {", "loads: {weight: {gravity: g}, ")
    assert found(falling)["q"].is_conserved is False
    assert found(falling)["q"].choice == "c"


@pytest.mark.parametrize(
    ("place", "message"),
    [
        ("bodies: {a: {particle: {mass: s}}}", "function of time"),
        (
            "bodies: {a: {particle: {mass: 1 kg}}}\nstart: {}\nmeasures: {x: x of a}\nloads: {f: {gravity: s}}",
            "function",
        ),
    ],
)
def test_a_function_of_time_stands_in_drivers_and_laws_only(place: str, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        fb.System.from_text("parameters: {s: {function: 2*t, unit: s}}\n" + place)


@pytest.mark.parametrize(
    ("parameter", "message"),
    [
        ("{function: v*t, unit: m}", "v"),
        ("{function: t, unit: m}", "must be a length"),
        ("{function: t, unit: s, value: 3}", "value"),
        ("{function: 2*r, unit: s}", "function of time itself"),
    ],
)
def test_a_faulty_function_of_time_is_told(parameter: str, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        fb.System.from_text(
            f"parameters: {{r: {{function: t, unit: s}}, s: {parameter}}}\nbodies: {{a: {{particle: {{mass: 1 kg}}}}}}"
        )


def test_another_form_of_a_function_changes_numbers_and_no_formula() -> None:
    system = fb.System.load(FOLDER / "body_on_driven_roller.yaml")
    other = system.with_parameters(x0="3*a*t^2/2")
    one, two = (fb.solve(s, "acceleration of theta")["q1"] for s in (system, other))
    assert one.expression == two.expression
    assert one.value is not None
    assert two.value == pytest.approx(3 * float(one.value))  # type: ignore[arg-type]


# -- the command ------------------------------------------------------------------------------
def test_the_command_prints_the_documented_json() -> None:
    result = CliRunner().invoke(commands(), ["conserved", str(FOLDER / "body_on_driven_roller.yaml"), "--json"])
    assert result.exit_code == 0
    (entry,) = json.loads(result.stdout)["quantities"]
    assert entry["question"] == ABOUT
    assert entry["conserved"] is None
    assert entry["conditions"] == [{"text": "d = 0", "expression": "d == 0"}]
    assert entry["choice"] == "d"
    assert {k: v["verdict"] for k, v in entry["options"].items()} == dict.fromkeys("abce", "wrong") | {"d": "right"}
    assert all(v["reason"] for v in entry["options"].values())
    assert entry["evidence"]["largest_drift"] < 1e-9
    assert math.isfinite(entry["counter_motion"]["after"])


def slides(system: fb.System) -> bool:
    return bool(system.dry_friction) and any(state for _name, state in start_mode(system).dry_friction)


EXAMPLES = sorted(path.stem for path in FOLDER.glob("*.yaml"))


@functools.cache
def of_example(name: str) -> Conservation | None:
    """What a search finds, where it takes no longer than a second or two: the search in space takes up to ten, and with
    contacts it is that of a system in one mode."""
    system = fb.System.load(FOLDER / f"{name}.yaml")
    is_slow = system.space and name not in ("spinning_top", "rolling_coin")
    if is_slow or system.rows != system.constraint_rows or name == "body_on_driven_roller" or slides(system):
        return None
    return conserved(system)


@pytest.mark.parametrize("name", EXAMPLES)
def test_conserved_quantities_of_an_example_are_the_golden_ones(name: str) -> None:
    found = of_example(name)
    if found is not None:
        assert_golden("conserved", name, {"text": found.to_text().splitlines(), "json": found.to_plain()})


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_example_is_searched(name: str) -> None:
    system = fb.System.load(FOLDER / f"{name}.yaml")
    if slides(system):
        with pytest.raises(fb.CannotAnswer, match="slides at the start"):
            conserved(system)
        return
    if name in ("spherical_four_bar", "ball_off_a_dome"):  # a loop, and a nearest place, whose formulas are too long
        with pytest.raises(fb.CannotAnswer, match="would have more than"):
            conserved(system)
        return
    searched = of_example(name) or conserved(system, "total energy")
    stands = fb.mobility(system).degrees_of_freedom == 0  # of what cannot move nothing is conserved
    assert stands or searched.quantities
    json.dumps(searched.to_plain())


# -- conditions that are easily missed --------------------------------------------------------
PUSHED = """
parameters: {{m: 1 kg, A: {{value: 2 N, sign: any}}, B: {{value: 1 N, sign: any}}, w: {{value: 3 rad/s, sign: any}},
              v: {{value: 2 rad/s, sign: any}}, F: {{function: A + B*t*w, unit: N}}, H: {{function: B*t*w, unit: N}}}}
bodies: {{ball: {{particle: {{mass: m}}}}}}
loads: {{push: {{force: {{at: ball, along: right, magnitude: {law}}}}}}}
"""


@pytest.mark.parametrize(
    ("law", "conditions"),
    [
        ("A*sin(w*t)", {"A = 0", "w = 0"}),
        ("A*sin(w*t) - A*sin(v*t)", {"A = 0", "v = w"}),
        ("F", {"F = 0"}),
        ("F + H", {"H + F = 0"}),
    ],
)
def test_conditions_inside_functions_and_between_functions_are_found(law: str, conditions: set[str]) -> None:
    assert set(judged(PUSHED.format(law=law), "linear momentum along right").conditions) == conditions


def test_gravitation_keeps_energy_and_moment_of_momentum() -> None:
    """Kepler: the potential of k/r^2 is not a polynomial, yet the law is one of its own measure alone."""
    text = """
parameters: {m: 1 kg, k: 3 N m^2}
bodies: {planet: {particle: {mass: m}, at: [1 m, 0], velocity: [0, 1 m/s]}}
measures: {r: distance from ground.O to planet}
loads: {attraction: {law: {measure: r, force: -k/r^2}}}
"""
    assert {"total energy", "angular momentum about ground.O"} <= kept(text)


def test_a_direction_of_two_offsets_vanishes_with_both() -> None:
    """A force at a point (d, e) of a hinged body, whatever its direction: no work if and only if d = e = 0."""
    text = """
parameters: {F: {value: 2 N, sign: any}, d: {value: 1 m, sign: any}, e: {value: 2 m, sign: any},
             beta: {value: 20 deg, sign: any}}
bodies: {b: {body: {mass: 1 kg, inertia: 1 kg m^2}, points: {P: [d, e]}}}
connections: {hinge: {pin: [ground.O, b]}}
loads: {push: {force: {at: b.P, along: beta, magnitude: F}}}
"""
    assert set(judged(text, "angular momentum about ground.O").conditions) == {"F = 0", "e = 0 and d = 0"}


def test_a_skate_keeps_its_energy_and_not_its_momentum() -> None:
    text = """
bodies: {sk: {rod: {mass: 1 kg, length: 1 m}, angular_velocity: 1 rad/s, velocity: [1 m/s, 0]}}
measures: {x: x of sk, y: y of sk, theta: angle of sk}
connections: {blade: {velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)}}
"""
    names = kept(text)
    assert {"total energy", "angular momentum about its mass center"} <= names
    assert not any("linear momentum" in name for name in names)


def test_only_what_is_proved_is_called_the_only_condition() -> None:
    """A steadily turned slotted lever: enough is that it stands still, whether only then is not proved."""
    text = """
parameters: {r: 0.1 m, h: 0.25 m, w: 2 rad/s}
ground: {points: {O: [0, 0], B: [0, -h]}}
bodies: {crank: {rod: {mass: 1 kg, length: r}}, lever: {rod: {mass: 1 kg, length: 0.5 m}, near: {angle: 70 deg}}}
connections: {O: {pin: [ground.O, crank.start]}, B: {pin: [ground.B, lever.start]},
              block: {slot: {pin: crank.end, along: lever.x, on: lever, through: lever.start}},
              motor: {driver: {measure: theta, follows: w*t}}}
measures: {theta: angle of crank}
"""
    verdict = judged(text, "total energy")
    assert verdict.conditions == ("w = 0",)
    assert verdict.when.startswith("if w = 0")
    assert not verdict.is_exact


def test_the_moment_on_a_linkage_is_a_condition_there_too() -> None:
    verdict = judged((FOLDER / "parallelogram_with_extra_bar.yaml").read_text(), "kinetic energy")
    assert verdict.conditions == ("T = 0",)


def test_alternatives_and_inequalities_are_read() -> None:
    text = PUSHED.format(law="A*sin(w*t)")
    options = {
        "a": "if A = 0 or w = 0",
        "b": "A > 0",
        "c": "x = 0",
        "d": "when A = 0",
        "e": "A == 0 and w == 0",
    }
    text += f"\nquestions: [{{id: q, find: is linear momentum along right conserved, options: {json.dumps(options)}}}]"
    verdict = found(text)["q"]
    assert verdict.choice == "a"
    assert "inequality" in verdict.options["b"].reason
    assert verdict.options["c"].verdict == "unreadable"
    assert "sufficient only" in verdict.options["d"].reason
    assert "sufficient only" in verdict.options["e"].reason


def test_without_inertia_nothing_is_said_about_a_momentum_that_needs_the_motion() -> None:
    """dp/dt = Q holds along motions; where p is zero in every state, it is 0 = Q, which no given state need obey."""
    text = """
parameters: {k: 0.2 N/m}
bodies: {b: {particle: {}}}
connections: {rail: {slider: {body: b, along: right, through: ground.O}}}
loads: {s: {spring: {first: ground.O, second: b, stiffness: k, length: 3 m}}}
ground: {points: {O: [0, 0]}}
measures: {u: x of b}
start: {u: 4 m}
"""
    massive = "\n  other: {particle: {mass: 1 kg}, at: [0, 1 m]}"
    text = text.replace("bodies: {b: {particle: {}}}", "bodies:\n  b: {particle: {}}" + massive)
    verdict = judged(text, "generalized momentum of u")
    assert verdict.is_conserved is None
    assert "nothing with mass moves with u" in verdict.reason


@pytest.mark.parametrize("pair", ["left and left", "right and floor"])
def test_an_angle_between_directions_that_never_turn_has_no_slope(pair: str) -> None:
    """acos(1) is constant; its slope is none, and not 0 * infinity."""
    text = f"""
ground: {{lines: {{floor: {{along: right}}}}}}
bodies: {{p: {{particle: {{mass: 2 kg}}}}}}
measures: {{u: angle between {pair}}}
connections: {{c: {{velocity_constraint: {{expression: rate(u)*cos(u)}}}}}}
"""
    assert "linear momentum along right" in kept(text)


def test_a_vector_on_a_closed_loop_is_refused_by_its_own_reason() -> None:
    judged_ = found(FOUR_BAR_WITH_VECTOR, "is acceleration of coupler.mass_center conserved")
    (verdict,) = judged_.quantities
    assert "name one" in verdict.reason


FOUR_BAR_WITH_VECTOR = """
ground: {points: {A: [0, 0], D: [2 m, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: 0.5 m}, near: {angle: 60 deg}}
  coupler: {rod: {mass: 1 kg, length: 2 m}}
  rocker: {rod: {mass: 1 kg, length: 1.5 m}, near: {angle: 100 deg}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.end]}
  D: {pin: [ground.D, rocker.start]}
loads: {w: {gravity: 9.81 m/s^2}}
"""


def test_moments_are_taken_about_points_that_are_called_so() -> None:
    """A weight hangs beside a drum, on a guide R beside the origin that nobody named: the origin is the origin."""
    searched = of_example("incline_with_pulley")
    assert searched is not None
    named = [v.question for v in searched.quantities]
    assert len(named) == len(set(named))


# -- what simulations show is no proof -----------------------------------------------------------
ROTOR_ON_A_LINKAGE = """
parameters: {m: 1 kg, J: 0.02 kg m^2, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], D: [0.5 m, 0]}}
bodies:
  crank: {rod: {mass: m, length: 0.2 m}, near: {angle: 60 deg}}
  coupler: {rod: {mass: m, length: 0.5 m}}
  rocker: {rod: {mass: m, length: 0.4 m}}
  rotor: {body: {mass: m, inertia: J}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.end]}
  D: {pin: [ground.D, rocker.start]}
  E: {pin: [coupler.center, rotor]}
loads: {weight: {gravity: g}}
measures: {e: distance from ground.A to crank.end, chi: angle of rotor}
"""


def test_what_only_simulations_show_is_not_said_of_every_motion() -> None:
    """A rotor pinned at its mass centre keeps its spin; the loop that carries it leaves that without a formula."""
    question = "angular momentum of rotor about its mass center"
    verdict = judged(ROTOR_ON_A_LINKAGE, question)
    assert (verdict.is_conserved, verdict.is_proved, verdict.rate) == (True, False, None)
    assert verdict.when == verdict.verdict == "constant in every simulated motion"
    answer = fb.System.from_text(ROTOR_ON_A_LINKAGE).solve(f"is {question} conserved").answers[0]
    assert answer.conditions == ("constant in every simulated motion",)
    assert answer.expression is None
    assert "every motion" not in found(ROTOR_ON_A_LINKAGE, question).to_text()
    assert _along("x", verdict) == "along x: constant in every simulated motion"


def test_options_are_not_told_more_than_simulations_show() -> None:
    text = ROTOR_ON_A_LINKAGE + (
        "questions: [{find: is angular momentum of rotor about its mass center conserved, options: {a: always}}]"
    )
    option = found(text).quantities[0].options["a"]
    assert (option.verdict, option.reason) == ("right", "it is constant in every simulated motion")


def test_what_geometry_keeps_in_a_closed_loop_is_proved() -> None:
    # the crank's end stays 0.2 m from its bearing
    verdict = judged(ROTOR_ON_A_LINKAGE, "e")
    assert (verdict.is_conserved, verdict.is_proved) == (True, True)


def test_a_floating_loop_keeps_its_momentum_by_the_principle() -> None:
    # nothing acts from outside: dP/dt = 0 and dH/dt = 0 about the mass centre
    text = """
bodies:
  one: {rod: {mass: 1 kg, length: 0.2 m}, near: {angle: 60 deg}}
  two: {rod: {mass: 1 kg, length: 0.5 m}, near: {angle: 20 deg}}
  three: {rod: {mass: 1 kg, length: 0.4 m}, near: {angle: 100 deg}}
  four: {rod: {mass: 1 kg, length: 0.3 m}, near: {angle: 0 deg}}
connections:
  A: {pin: [four.start, one.start]}
  B: {pin: [one.end, two.start]}
  C: {pin: [two.end, three.end]}
  D: {pin: [four.end, three.start]}
loads: {spring: {spring: {first: one.start, second: two.end, stiffness: 20 N/m, length: 0.2 m}}}
"""
    for question in ("linear momentum", "angular momentum about its mass center"):
        verdict = judged(text, question)
        assert (verdict.is_conserved, verdict.is_proved) == (True, True), question


def test_an_angle_that_stays_zero_is_compared_with_a_radian() -> None:
    """The coupler of a parallelogram linkage stays parallel to the ground: 0, and in numbers round-off."""
    text = """
parameters: {r: 0.2 m, d: 0.5 m}
ground: {points: {A: [0, 0], B: [d, 0]}}
bodies:
  left: {rod: {mass: 1 kg, length: r}, near: {angle: 60 deg}}
  right: {rod: {mass: 1 kg, length: r}, near: {angle: 60 deg}}
  coupler: {rod: {mass: 1 kg, length: d}, near: {angle: 0 deg}}
connections:
  a: {pin: [ground.A, left.start]}
  b: {pin: [ground.B, right.start]}
  c: {pin: [left.end, coupler.start]}
  e: {pin: [right.end, coupler.end]}
measures: {psi: angle of left, phi: angle of coupler}
start: {psi: 60 deg}
"""
    verdict = judged(text, "phi")
    assert (verdict.is_conserved, verdict.reason) == (True, "")
