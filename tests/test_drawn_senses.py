"""What may act either way is drawn as it acts; the derivation beside the picture has the same sense."""

from __future__ import annotations

from pathlib import Path

import pytest

import freebody as fb
from freebody.narrative.lines.script import NumberedFormula
from freebody.narrative.telling.composing import plain_derivations
from freebody.study.pictures.instant import instant_of
from freebody.study.senses import drawn_symbols

EXAMPLES = Path(__file__).parents[1] / "examples"
NAMES = sorted(path.stem for path in EXAMPLES.glob("*.yaml"))

SLOPE = """
parameters: {{m: 2 kg, R: 0.2 m, alpha: 30 deg, g: 9.81 m/s^2, P: {{value: {push}, sign: any}}}}
ground: {{lines: {{incline: {{along: -alpha}}}}}}
bodies: {{disk: {{disk: {{mass: m, radius: R}}}}}}
connections: {{contact: {{rolling: {{body: disk, on: incline}}}}}}
loads: {{weight: {{gravity: g}}, push: {{torque: {{on: disk, magnitude: P}}}}}}
measures: {{s: travel of disk along incline}}
start: {{s: 0}}
"""


def load(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


def heading_of(system: fb.System, body: str, called: str) -> str:
    """How a diagram says where an arrow points."""
    told = system.free_body(body).description.split("; ")
    return next(text for text in told if f" {called}," in f"{text},").rpartition(", ")[2].rstrip(".")


@pytest.mark.parametrize("name", NAMES)
def test_what_may_act_either_way_is_positive_at_the_start(name: str) -> None:
    system = load(name)
    try:
        reactions = instant_of(system, None, in_motion=True).reactions
    except fb.FreebodyError:
        pytest.skip("no motion begins here")
    symbols, largest = drawn_symbols(system), max(map(abs, reactions.values()), default=0.0)
    for row in (row for row in system.rows if row.name in symbols):  # the foot on a curve is no body
        directed = row.unilateral or row.reaction == "tension" or len(row.component.split()[-1]) <= 1
        if directed or "moment" in row.reaction or "torque" in row.reaction:
            assert symbols[row.name].sign == row.sign
        elif row.name in reactions:
            assert reactions[row.name] * row.sign * symbols[row.name].sign >= -1e-7 * largest


def test_friction_on_a_disk_that_rolls_down_points_up_the_slope() -> None:
    assert heading_of(fb.System.from_text(SLOPE.format(push="0 N m")), "disk", "F") == "at 150 deg"


def test_friction_on_a_disk_that_is_driven_down_points_down_the_slope() -> None:
    # alpha'' I = R F - P, m a = m g sin(alpha) - F up the slope: F < 0 once P > m g R sin(alpha)/2
    assert heading_of(fb.System.from_text(SLOPE.format(push="-5 N m")), "disk", "F") == "at -30 deg"


def test_the_derivation_counts_a_force_as_the_picture_draws_it() -> None:
    told = fb.System.from_text(SLOPE.format(push="0 N m")).explain("friction force of contact")
    lines = "\n".join(line for d in plain_derivations(told)["derivations"] for s in d["stages"] for line in s["lines"])
    assert "m⋅g⋅sin(α) - F" in lines
    assert "= -F =" in lines  # how the answer is counted


def test_coulombs_law_has_no_sign_where_a_ball_slides_down() -> None:
    told = load("sphere_launched_down_incline").explain("speed")
    formulas = [
        item
        for stage in told.derivations[0].stages
        for item in stage.items
        if isinstance(item, NumberedFormula) and item.why is not None and item.why.key.startswith("friction.slides")
    ]
    assert {item.why.key for item in formulas if item.why is not None} == {"friction.slides_backward"}


def test_the_axle_of_a_pulley_has_no_sideways_force() -> None:
    atwood = load("atwood_machine")
    assert "axle F_axle,x" not in atwood.free_body("pulley").description
    # where a question asks for it, the equation 0 = F_axle_x stands beside a picture that has it
    assert "F_axle,x" in atwood.free_body("pulley", told=["axle.x"]).description


def test_names_of_forces_are_a_letter_and_a_short_index() -> None:
    told = load("block_tips_or_slides").free_body("block").description
    assert "normal force N_bl, up" in told
    assert "no,slip" not in load("disk_on_angled_shaft").free_body("disk").description
