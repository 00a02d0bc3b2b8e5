"""Derivations of freedoms, conserved quantities, small motions, motion in space, and of what has no formula."""

from __future__ import annotations

from pathlib import Path

import pytest

from freebody import System
from freebody.errors import RoutesDisagree
from freebody.language.expression import Call, Expr, Symbol, VectorSymbol
from freebody.language.notation import to_text
from freebody.language.parser import parse
from freebody.language.sentences import Sentence
from freebody.narrative.context import Context
from freebody.narrative.derivation import Derivation
from freebody.narrative.explain import Explanation, explain
from freebody.narrative.lines.script import FormulaTable, Legend, Listing, NumberedFormula, names_in
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.narrative.telling.catalogue import Catalogue

EXAMPLES = Path(__file__).parent.parent / "examples"
UPRIGHT = """
space: true
parameters: {g: 9.81 m/s^2, m: 0.1 kg, R: 0.05 m, w: 10 rad/s}
ground: {planes: {table: {normal: up}}}
bodies:
  coin:
    disk: {mass: m, radius: R}
    turned: [psi about y, theta about x, phi about z]
connections: {rolling: {rolling: {body: coin, on: ground.table}}}
loads: {weight: {gravity: g}}
start: {psi: 0, theta: 0, phi: 0, rate(theta): 0, rate(psi): 0, rate(phi): w}
"""
FLAT_LOOP = """
space: true
ground: {points: {A: [0, 0, 0], D: [4 m, 0, 0]}}
bodies:
  crank: {body: {mass: 1 kg, inertia: [1, 1, 1]}, points: {A: [0, 0, 0], B: [1 m, 0, 0]}}
  coupler: {body: {mass: 1 kg, inertia: [1, 1, 1]}, points: {B: [0, 0, 0], C: [4 m, 0, 0]}}
  rocker: {body: {mass: 1 kg, inertia: [1, 1, 1]}, points: {C: [0, 2 m, 0], D: [0, 0, 0]}, near: {at: [4 m, 0, 0]}}
connections:
  a: {revolute: {first: ground.A, second: crank.A, about: z}}
  b: {revolute: {first: crank.B, second: coupler.B, about: z}}
  c: {revolute: {first: coupler.C, second: rocker.C, about: z}}
  d: {revolute: {first: ground.D, second: rocker.D, about: z}}
measures: {phi: angle of crank about z}
start: {phi: 60 deg}
"""
CONICAL = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 1 kg, l: 0.5 m}
bodies:
  bob:
    body: {mass: m, inertia: [0, 0, 0]}
    points: {top: [0, 0, l]}
    turned: [psi about z, theta about x]
connections: {top: {universal: {first: ground.O, second: bob.top, arm: z, second_arm: x}}}
loads: {weight: {gravity: g}}
start: {theta: 30 deg, rate(psi): 5 rad/s}
"""


def of(system: System, question: str) -> tuple[Explanation, Derivation]:
    """The derivation of one question, re-read: symbols are introduced before they are used, lines follow from earlier
    ones, and the last one is the answer."""
    found = explain(system, question)
    (derivation,) = found.derivations
    assert not derivation.reason
    known, earlier = {"t"}, set[int]()
    for stage in (*found.opening, *derivation.stages):
        for item in stage.items:
            if isinstance(item, Legend):
                known |= set().union(*(names_in(symbol) for symbol, _what, _unit in item.entries))
            if isinstance(item, NumberedFormula):
                used = set[str]().union(*(names_in(side) for side in item.sides))
                own = names_in(item.sides[0]) if stage.title.key == "stage.result" else set[str]()
                assert used - own <= known, f"({item.number}) uses {used - known}"
                assert set(item.uses) <= earlier
                earlier.add(item.number)
    if derivation.answer.expression is not None:
        ends = lines(derivation)[-1].sides
        assert (ends[-2] if derivation.answer.form else ends[-1]) == derivation.answer.expression
    assert "{" not in found.to_text()
    return found, derivation


def the(name: str, question: str) -> Derivation:
    return of(System.load(EXAMPLES / f"{name}.yaml"), question)[1]


def lines(derivation: Derivation) -> list[NumberedFormula]:
    return [item for stage in derivation.stages for item in stage.items if isinstance(item, NumberedFormula)]


def texts(derivation: Derivation) -> list[str]:
    """Every line as text."""
    return [" = ".join(map(_shown, line.sides)) for line in lines(derivation)]


def _shown(side: object) -> str:
    return ", ".join(map(to_text, side)) if isinstance(side, tuple) else to_text(side)  # type: ignore[arg-type]


def keys(derivation: Derivation) -> list[str]:
    """What is said, line by line and in between."""
    found: list[str] = []
    for stage in derivation.stages:
        for item in stage.items:
            if isinstance(item, Sentence):
                found.append(item.key)
            if isinstance(item, Listing):
                found += [s.key for s in item.items]
            if isinstance(item, NumberedFormula) and item.why is not None:
                found.append(item.why.key)
    return found


def principles(derivation: Derivation) -> list[tuple[str, tuple[str, ...]]]:
    """Kind and bodies of each principle in space."""
    said = [i for stage in derivation.stages for i in stage.items if isinstance(i, Sentence)]
    return [
        (s.key.removeprefix("space."), tuple(map(str, s.args["bodies"])))  # type: ignore[arg-type]
        for s in said
        if s.key in ("space.linear", "space.angular")
    ]


# -- freedoms ---------------------------------------------------------------------------------
def test_a_spring_is_a_force_and_does_not_count() -> None:
    derivation = the("multi_bar_platform", "q1")
    assert "mobility.springs" in keys(derivation)
    assert "mobility.independent" in keys(derivation)
    assert derivation.answer.choice == "b"


def test_equal_parallel_bars_make_one_constraint_superfluous() -> None:
    derivation = the("parallelogram_with_extra_bar", "freedom")
    listed = [i for stage in derivation.stages for i in stage.items if isinstance(i, Listing)]
    (dependent,) = listed[0].items
    assert dependent.key == "mobility.special_geometry"
    assert "equally long" in str(dependent.args["reason"])
    assert "mobility.given_back_one" in keys(derivation)


def test_freedoms_in_space_are_counted_by_sixes() -> None:
    derivation = the("bevel_differential", "freedom")
    assert texts(derivation)[0] == "6·4 - 4·5 - 2·1 = 2"


def test_rolling_reaches_more_poses_than_it_has_freedoms() -> None:
    assert "mobility.reachable" in keys(the("rolling_coin", "freedom"))


# -- conserved quantities ---------------------------------------------------------------------
def test_angular_momentum_about_a_driven_roller_needs_the_term_of_the_moving_point() -> None:
    derivation = the("body_on_driven_roller", "conserved")
    assert {"conserved.about_moving", "conserved.why_moving", "conserved.exactly_if"} <= set(keys(derivation))
    assert texts(derivation)[-1] == "H' = -m·d·g·sin(θ) - m·d·x₀'·θ'·sin(θ) = -m·d·sin(θ)·(x₀'·θ' + g)"
    (table,) = [
        i for s in derivation.stages if s.title.key != "stage.options" for i in s.items if isinstance(i, FormulaTable)
    ]
    assert [to_text(row[1]) for row in table.rows] == ["-m·d·x₀'", "-m·d·g"]  # type: ignore[arg-type]


def test_energy_of_a_bead_changes_by_the_power_of_the_motor() -> None:
    derivation = the("bead_on_turning_rod", "energy")
    assert "E' = ω·M" in texts(derivation)
    assert texts(derivation)[-1] == "E' = 2·m·ω²·r·r'"


def test_spin_of_a_top_is_conserved_although_its_axis_turns() -> None:
    derivation = the("spinning_top", "spin")
    assert "conserved.turning_direction" in keys(derivation)
    assert "conserved.always" in keys(derivation)


def test_conservation_has_no_other_method() -> None:
    found = explain(System.load(EXAMPLES / "body_on_driven_roller.yaml"), "conserved", method="lagrange")
    assert "not derived by the method lagrange" in found.derivations[0].reason


# -- small motions ----------------------------------------------------------------------------
def test_a_hanging_mass_rests_where_the_spring_carries_it() -> None:
    derivation = the("mass_on_spring", "rest")
    assert texts(derivation)[-3:-1] == ["m·g + k·L = k·y_e", "y_e = (m·g + k·L)/k"]


def test_two_masses_have_a_characteristic_equation_with_two_roots() -> None:
    derivation = the("two_masses_three_springs", "frequencies")
    assert "[K_11, K_12]"[1:-1] in " ".join(texts(derivation))
    assert "m²·ω_1⁴ + 3·k² = 4·m·k·ω_1²" in texts(derivation)
    assert texts(derivation)[-1] == "ω_1, ω_2 = √(k/m), √(3·k/m)"


@pytest.mark.parametrize("name", ["simple_pendulum", "ball_in_bowl"])
def test_a_period_follows_from_the_slope_of_the_acceleration(name: str) -> None:
    derivation = the(name, "period")
    assert [k for k in keys(derivation) if k.startswith("small.")][-3:] == [
        "small.slope_is",
        "small.harmonic",
        "small.period",
    ]


# -- velocities in space ----------------------------------------------------------------------
def test_angular_velocities_on_both_ways_to_a_cardan_joint_are_equal_vectors() -> None:
    derivation = the("cardan_joint", "omega_2")
    assert "ψ'·𝒆_1 + φ_yoke'·𝒆_3 + φ_other_yoke'·𝒆_4 = φ_support'·𝒆_2" in texts(derivation)
    told = ["space.vector_loop", "space.axes_known", "space.normal_of_cross", "space.scalar_product"]
    assert [k for k in keys(derivation) if k in told] == told
    # omega_1 cos(alpha) = omega_2 (cos^2 alpha + sin^2 alpha cos^2 psi) of the textbook
    assert "cos(α)·ψ' = (1 - sin(α)²·sin(ψ)²)·φ_support'" in texts(derivation)


def test_a_vector_sum_that_is_wrong_by_one_sign_is_never_printed() -> None:
    context = Context(System.load(EXAMPLES / "disk_on_angled_shaft.yaml"))
    script = context.script()
    kinematics = SpatialKinematics(context.setup, context.glossary, script)
    kinematics.angles.introduce(["phi_spindle"])
    kinematics.angles.vectors.added("disk", ["psi", "phi_spindle"])
    omega, first, second = VectorSymbol("omega_disk"), VectorSymbol("e_1"), VectorSymbol("e_2")
    rates = [Call("rate", Symbol(name)) for name in ("psi", "phi_spindle")]
    script.line(omega, rates[0] * first + rates[1] * second)
    with pytest.raises(RoutesDisagree):
        script.line(omega, rates[0] * first - rates[1] * second)


def test_the_vector_that_rids_a_loop_of_its_cross_is_perpendicular_to_both_arms() -> None:
    context = Context(System.load(EXAMPLES / "cardan_joint.yaml"))
    script = context.script()
    vectors = SpatialKinematics(context.setup, context.glossary, script).angles.vectors
    found = vectors.projection("phi_support")
    assert found is not None
    for world in context.glossary.worlds("always"):
        n = [float(vectors.field.evaluate(x, world.numbers)) for x in found.normal.n]
        for turning in found.loop.all:
            arm = vectors._reads(turning)(world)
            if turning.name in found.normal.across:
                assert sum(a * b for a, b in zip(n, arm, strict=True)) == pytest.approx(0, abs=1e-12)


def test_a_loop_of_parallel_axes_has_no_vector_that_leaves_one_of_them() -> None:
    context = Context(System.from_text(FLAT_LOOP))
    vectors = SpatialKinematics(context.setup, context.glossary, context.script()).angles.vectors
    assert vectors.loops.cut
    assert all(vectors.projection(name) is None for name in vectors.loops.measures)


def test_the_second_cardan_joint_undoes_the_first() -> None:
    derivation = the("cardan_shaft_with_two_joints", "ratio")
    assert [k for k in keys(derivation) if k == "space.tangent"] == ["space.tangent"] * 2
    assert "φ_driven_bearing' = ψ'" in texts(derivation)


def test_the_centre_of_a_disk_on_a_shaft_moves_as_the_shaft_turns() -> None:
    derivation = the("disk_on_angled_shaft", "omega")
    assert "𝝎_disk = ψ'·𝒆_1 + φ_spindle'·𝒆_2" in texts(derivation)
    (transfer,) = [line for line in lines(derivation) if line.why is not None and line.why.key == "space.transfer"]
    assert [to_text(x) for x in transfer.sides[-1]] == ["0", "0", "-L·ω_1·(cos(β) + 1)"]


def test_a_disk_on_an_angled_shaft_touches_the_floor_at_rest() -> None:
    derivation = the("disk_on_angled_shaft", "omega")
    (slip,) = [line for line in lines(derivation) if line.why is not None and line.why.key == "space.no_slip"]
    assert slip.sides[0] == (parse("0"),) * 3
    assert len(slip.uses) == 3  # the arm, the velocity of the centre, the angular velocity
    assert derivation.answer.choice == "a"


def test_axes_that_turn_bring_a_term_into_the_angular_acceleration() -> None:
    derivation = the("disk_on_angled_shaft", "alpha")
    assert "space.axes_turn" in keys(derivation)
    assert "ω_shaft_y·ω_disk_shaft_z" in " ".join(texts(derivation))


# -- momentum in space ------------------------------------------------------------------------
def test_a_tilted_disk_loads_its_bearings_by_moments_about_the_other_one() -> None:
    derivation = the("tilted_disk_on_shaft", "A")
    assert principles(derivation) == [
        ("linear", ("shaft", "disk")),
        ("angular", ("shaft", "disk")),
        ("angular", ("shaft", "disk")),
    ]
    assert "space.euler" in keys(derivation)  # dH/dt = omega x H


def test_a_top_nods_by_moments_about_its_tip() -> None:
    derivation = the("spinning_top", "nodding")
    assert principles(derivation) == [("angular", ("top",))]
    (said,) = [i for s in derivation.stages for i in s.items if isinstance(i, Sentence) and i.key == "space.angular"]
    assert isinstance(said.args["direction"], Sentence)
    assert said.args["direction"].args["name"] == Symbol("theta")


def test_a_coin_leans_by_moments_about_its_contact_point() -> None:
    derivation = the("rolling_coin", "leaning")
    (said,) = [i for s in derivation.stages for i in s.items if isinstance(i, Sentence) and i.key == "space.angular"]
    assert isinstance(said.args["point"], Sentence)
    assert said.args["point"].key == "point.only_contact"
    assert "space.any_point" in keys(derivation)


def test_a_gyroscope_is_taken_together_about_the_vertical() -> None:
    derivation = the("gyroscope_in_gimbals", "precession")
    assert ("angular", ("outer", "inner", "rotor")) in principles(derivation)
    assert len(principles(derivation)) == 2


def test_a_free_body_needs_no_angles() -> None:
    derivation = the("free_asymmetric_body", "alpha")
    assert "space.euler_free" in keys(derivation)
    assert not any("yaw" in text for text in texts(derivation))


# -- steady motion ----------------------------------------------------------------------------
def test_a_top_precesses_in_two_ways() -> None:
    derivation = the("spinning_top", "steady")
    assert "(m·l² + A - C)·ψ'²·cos(θ) + g·m·l = C·ψ'·φ'" in texts(derivation)
    (line,) = [line for line in lines(derivation) if line.why is not None and line.why.key == "steady.solved"]
    assert isinstance(line.sides[0], tuple)
    assert len(line.sides[0]) == 2


def test_extremes_stand_where_the_slope_vanishes() -> None:
    derivation = the("cardan_joint", "extremes")
    tables = [i for stage in derivation.stages for i in stage.items if isinstance(i, FormulaTable)]
    assert [row[0] for row in tables[0].rows] == ["ψ = 0, ψ = 180°", "ψ = 90°, ψ = -90°"]
    assert texts(derivation)[-1] == "y_min, y_max = cos(α), 1/cos(α)"


def test_a_spin_is_disturbed_by_eulers_equations() -> None:
    derivation = the("free_asymmetric_body", "stability")
    rates = [line for line in lines(derivation) if any(isinstance(s, Expr) and _has_rate(s) for s in line.sides)]
    assert len(rates) == 2


def _has_rate(e: object) -> bool:
    parts = getattr(e, "terms", None) or getattr(e, "factors", None) or ()
    return (isinstance(e, Call) and e.function == "rate") or any(map(_has_rate, parts))


def test_an_upright_coin_rolls_stably_if_it_is_fast() -> None:
    _found, derivation = of(System.from_text(UPRIGHT), "stability of steady motion")
    assert texts(derivation)[-1].endswith("4·(g - 3·R·w²)/(5·R)")


def test_a_conical_pendulum_opens_by_its_rate() -> None:
    _found, derivation = of(System.from_text(CONICAL), "theta in steady motion")
    assert "steady.cyclic" in keys(derivation)


# -- without a formula ------------------------------------------------------------------------
def test_without_a_closed_form_the_equations_of_motion_are_left() -> None:
    text = (EXAMPLES / "double_pendulum.yaml").read_text(encoding="utf-8")
    moving = text.replace("start: {theta1: 0, theta2: 0}", "start: {theta1: 0.4 rad, theta2: 0}")
    assert moving != text
    derivation = of(System.from_text(moving), "time when theta1 = 0.1")[1]
    assert derivation.answer.expression is None
    assert keys(derivation)[:3] == ["unclosed.kane", "unclosed.along", "unclosed.along"]
    assert "unclosed.why" in keys(derivation)


def test_what_starts_in_an_equilibrium_never_gets_there() -> None:
    derivation = the("double_pendulum", "time when theta1 = 0.1")
    assert derivation.answer.expression is None
    assert keys(derivation)[-1] == "unclosed.never"


def test_without_coordinates_it_is_said_what_numbers_solve() -> None:
    derivation = the("spherical_four_bar", "acceleration of psi")
    assert {"unclosed.no_coordinates", "unclosed.bodies", "unclosed.rows", "unclosed.number"} <= set(keys(derivation))


# -- motions in phases ------------------------------------------------------------------------
BRAKED = """
space: true
parameters: {m: 2 kg, r: 0.3 m, M: 0.4 N m, w0: 3 rad/s}
bodies: {d: {disk: {mass: m, radius: r, axis: z}}}
measures: {phi: turn of d about z}
connections:
  h: {revolute: {first: ground.origin, second: d.center, about: z}}
  c: {dry_friction: {measure: phi, force: M}}
start: {phi: 0, rate(phi): w0}
"""


def test_a_disk_on_a_hinge_is_braked_by_friction_until_it_stands() -> None:
    """With I = m r^2/2 about the hinge: I phi'' = -M, so it stands after I w0/M, and friction took I w0^2/2."""
    system = System.from_text(BRAKED)
    _found, when = of(system, "time when slipping ends")
    told = texts(when)
    assert "M_c = -M" in told
    assert "φ'' = -2·M/(m·r²)" in told
    assert when.answer.value == pytest.approx(0.09 * 3 / 0.4)
    _found, lost = of(system, "energy lost when slipping ends")
    assert lost.answer.value == pytest.approx(0.09 * 9 / 2)
    keys = [line.why.key for line in lines(lost) if line.why is not None]
    assert keys.index("space.kinetic_is") < keys.index("answer.energy_start") < keys.index("answer.lost")


def test_components_along_different_axes_have_different_symbols() -> None:
    """A coin's angular velocity is told along its own axes, for H = I omega, and along fixed ones, for rolling."""
    derivation = the("rolling_coin", "leaning")
    added = [line for line in lines(derivation) if line.why is not None and line.why.key == "space.added"]
    first, second = ({to_text(x) for x in line.sides[0]} for line in added if isinstance(line.sides[0], tuple))
    assert not first & second


def test_motion_is_told_before_bodies_are_cut_free() -> None:
    titles = [stage.title.key for stage in the("rolling_coin", "leaning").stages]
    assert titles.index("space.motion") < titles.index("stage.bodies") < titles.index("stage.principles")


def test_a_unit_vector_is_told_once_along_the_same_axes() -> None:
    derivation = the("disk_on_angled_shaft", "omega")
    assert keys(derivation).count("space.unit_vectors_are") == 1
    assert "space.turns_about_own" not in keys(derivation)


def test_a_deviation_is_not_called_as_its_coordinate() -> None:
    derivation = the("bead_on_a_parabola", "period")
    said = " ".join(Catalogue().plain(s) for stage in derivation.stages for s in stage.items if isinstance(s, Sentence))
    assert "by ξ" in said
    assert "by x" not in said
