"""Derivations of motions in phases and of rest under dry friction: re-read, and with the steps that one expects."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

from freebody import System
from freebody.language.notation import to_text
from freebody.language.sentences import Sentence
from freebody.narrative.derivation import Derivation
from freebody.narrative.explain import Explanation, explain
from freebody.narrative.lines.script import DerivationStage, NumberedFormula
from test_kept_modes import BOWL, MAY_LEAVE, SLOPE
from test_narrative import reread

EXAMPLES = Path(__file__).parent.parent / "examples"


def load(name: str) -> System:
    return System.load(EXAMPLES / f"{name}.yaml")


def lines_of(stages: tuple[DerivationStage, ...]) -> list[NumberedFormula]:
    return [item for stage in stages for item in stage.items if isinstance(item, NumberedFormula)]


def shown(line: NumberedFormula) -> str:
    parts = [to_text(side) for side in line.sides if not isinstance(side, tuple)]  # type: ignore[arg-type]
    return " ".join(x for pair in zip(parts, (*line.relations, ""), strict=True) for x in pair).strip()


def of(name: str, question: str) -> tuple[Explanation, Derivation]:
    found = explain(load(name), question)
    (derivation,) = found.derivations
    assert not derivation.reason, derivation.reason
    return found, derivation


# -- phases -----------------------------------------------------------------------------------
def test_sphere_slides_by_the_law_of_friction_until_its_slip_velocity_vanishes() -> None:
    _found, derivation = of("sphere_launched_down_incline", "speed")
    told = [shown(line) for line in lines_of(derivation.stages)]
    assert "v_s = v₀ > 0" in told
    assert "F = μ·N" in told
    assert "x'' = g·(sin(θ) - μ·cos(θ))" in told
    assert "t_1 = 2·v₀/(g·(7·μ·cos(θ) - 2·sin(θ)))" in told


def test_that_it_goes_on_rolling_is_shown_by_the_friction_it_needs() -> None:
    _found, derivation = of("sphere_launched_down_incline", "speed")
    told = [shown(line) for line in lines_of(derivation.stages)]
    assert "|F| ≤ μ·N" in told
    assert "|F| = 2·m·g·sin(θ)/7 ≤ m·μ·g·cos(θ)" in told
    assert "μ > 2·tan(θ)/7" in told


def test_a_block_that_turns_round_has_a_second_phase_with_friction_the_other_way() -> None:
    _found, derivation = of("block_on_rough_incline", "back")
    told = [shown(line) for line in lines_of(derivation.stages)]
    assert told.index("F = μ·N") < told.index("F = -μ·N")
    assert "μ < tan(θ)" in told


def test_a_particle_leaves_the_dome_where_energy_makes_the_normal_force_vanish() -> None:
    _found, derivation = of("particle_leaving_dome", "angle")
    told = [shown(line) for line in lines_of(derivation.stages)]
    assert "N = m·(g·cos(φ) - R·φ'²)" in told
    assert "3·R·g·cos(φ) = 2·R·g + v₀²" in told


def test_energy_lost_is_the_difference_of_two_energies() -> None:
    _found, derivation = of("billiard_ball", "lost")
    keys = [line.why.key for line in lines_of(derivation.stages) if line.why is not None]
    assert keys.index("answer.energy_start") < keys.index("answer.energy_event") < keys.index("answer.lost")


def test_a_motion_in_phases_has_no_derivation_by_lagrange() -> None:
    (derivation,) = explain(load("billiard_ball"), "speed", method="lagrange").derivations
    assert "not derived by the method lagrange" in derivation.reason


def test_without_a_closed_form_the_reason_is_that_of_the_solver() -> None:
    (derivation,) = explain(load("particle_leaving_dome"), "time when contact opens").derivations
    assert derivation.answer.expression is None
    assert derivation.reason


# -- rest -------------------------------------------------------------------------------------
def test_a_ladder_needs_no_wall_force_to_find_its_friction() -> None:
    _found, derivation = of("ladder_against_wall", "friction")
    told = [shown(line) for line in lines_of(derivation.stages)]
    assert "F_floor_start = μ·N_floor_start" in told
    assert told[-1].startswith("μ ≥ ")


def test_a_block_tips_where_a_corner_has_no_force_and_slides_where_friction_is_used_up() -> None:
    _found, derivation = of("block_tips_or_slides", "first")
    told = [shown(line) for line in lines_of(derivation.stages)]
    assert "N_bl = 0" in told
    assert "F = m·b·g/(2·d)" in told
    assert "m·μ·g ≤ m·b·g/(2·d)" in told
    assert told[-1] == "F = m·μ·g"


def test_a_rope_round_a_drum_obeys_euler_and_eytelwein() -> None:
    _found, derivation = of("capstan", "range")
    told = [shown(line) for line in lines_of(derivation.stages)]
    assert "T - F_rope = exp(μ·π)·T" in told
    assert told[-1] == "M·g/exp(μ·π) ≤ F ≤ M·g·exp(μ·π)"


def test_reactions_that_equilibrium_leaves_open_are_said_to_be_open() -> None:
    _found, derivation = of("ladder_rough_wall", "friction")
    said = [item.key for stage in derivation.stages for item in stage.items if isinstance(item, Sentence)]
    assert "rest.not_unique" in said


# -- one law of motion ------------------------------------------------------------------------
def test_what_one_law_says_is_derived_in_the_mode_with_which_the_motion_begins() -> None:
    """A ball that may leave its bowl swings in it, 7/5 m (R - r) phi'' = -m g sin(phi), and keeps its energy."""
    system = System.from_text(BOWL.replace("TOUCH", MAY_LEAVE))
    found = explain(system)
    for derivation in found.derivations:
        assert not derivation.reason, derivation.reason
        reread(found)
    told = {d.question.id: [shown(line) for line in lines_of(d.stages)] for d in found.derivations}
    assert "c_0 = 5·g/(7·(R - r))" in told["q1"]
    assert "sin(φ_e) = 0" in told["q1"]  # to which q2 refers


def test_the_energy_that_friction_takes_is_told_by_the_power_of_the_slip() -> None:
    """-mu N times the slip x' + r theta': conserved without friction, or where nothing presses."""
    found = explain(System.from_text(SLOPE), "q1")
    (derivation,) = found.derivations
    assert not derivation.reason, derivation.reason
    reread(found)
    assert "E' = -m·μ·g·cos(θ)·(x' + r·θ_ball')" in [shown(line) for line in lines_of(derivation.stages)]


def test_the_tensions_on_both_sides_of_a_drum_differ_by_the_friction_as_it_is_drawn() -> None:
    """The drum of a differential band brake stands still: R (T_before - T_after) = M, so that with F_band = M/R, drawn
    against M, the tight side has T + F_band, and Euler and Eytelwein's ratio is that of these two."""
    _found, derivation = of("differential_band_brake", "force")
    told = [shown(line) for line in lines_of(derivation.stages)]
    assert "0 = R·F_band - M" in told
    assert "T + F_band = exp(μ·π)·T" in told
    _found, derivation = of("capstan", "range")  # F_rope is drawn the other way there
    assert "T - F_rope = T/exp(μ·π)" in [shown(line) for line in lines_of(derivation.stages)]


def test_stages_of_one_kind_are_one_stage() -> None:
    for name, question in (("differential_band_brake", "force"), ("ladder_rough_wall", "wall")):
        for derivation in of(name, question)[0].derivations:
            titles = [stage.title for stage in derivation.stages]
            assert all(one != other for one, other in pairwise(titles))


def test_a_rate_that_rolling_binds_is_bound_by_no_closed_loop() -> None:
    _found, derivation = of("wheel_over_a_hump", "speed")
    assert "stage.loops" not in [stage.title.key for stage in derivation.stages]
    # the centre of a wheel on whatever curve moves with r times its rate of turning
    assert "v_wheel_t + r·θ_wheel' = 0" in [shown(line) for line in lines_of(derivation.stages)]
    assert not any("(-(" in shown(line) for line in lines_of(derivation.stages))


def test_moments_are_told_about_the_corner_where_what_drops_out_acts() -> None:
    _found, derivation = of("block_tips_or_slides", "first")
    (moments,) = [line for line in lines_of(derivation.stages) if line.label is not None and "b·N_bl" in shown(line)]
    assert "N_br" not in shown(moments)  # whose line of action goes through the bottom right corner
    assert "bottom_right" in str(moments.label)


def test_what_contacts_say_at_the_limit_is_put_in_at_once() -> None:
    _found, derivation = of("ladder_against_wall", "friction")
    put_in = [line for line in lines_of(derivation.stages) if line.why and line.why.key == "solve.put_in"]
    assert len(put_in) == 1
    assert len(put_in[0].uses) == 3  # friction at its limit and the normal force into the moments


def test_that_sums_vanish_at_rest_is_said_once() -> None:
    _found, derivation = of("block_tips_or_slides", "first")
    keys = [item.key for stage in derivation.stages for item in stage.items if isinstance(item, Sentence)]
    assert keys.count("rest.no_acceleration") == 1
