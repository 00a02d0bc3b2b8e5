"""Several questions of one model share one derivation: what was found once is referred to."""

from __future__ import annotations

from pathlib import Path

import pytest

from examples_told import explained
from freebody import System
from freebody.language.expression import Expr, Symbol, free_symbols
from freebody.language.sentences import Sentence
from freebody.narrative.explain import Explanation, explain
from freebody.narrative.lines.script import Legend, NumberedFormula
from freebody.narrative.sharing import lines_of, referred, sentences_of

EXAMPLES = Path(__file__).parent.parent / "examples"
SHARING = ("atwood_machine", "disk_rolling_down_incline", "planetary_gear", "compound_atwood", "hoist", "yo_yo")

shared = pytest.mark.parametrize("name", SHARING)


def all_lines(found: Explanation) -> list[NumberedFormula]:
    return lines_of([*found.opening, *(stage for d in found.derivations for stage in d.stages)])


def legends(found: Explanation) -> list[tuple[Expr, Sentence, str]]:
    stages = [*found.opening, *(stage for d in found.derivations for stage in d.stages)]
    return [e for stage in stages for item in stage.items if isinstance(item, Legend) for e in item.entries]


@shared
def test_no_line_is_written_twice(name: str) -> None:
    lines = [line for line in all_lines(explained(name)) if line.why is not None]
    assert len({(line.sides, line.symbols) for line in lines}) == len(lines)


@pytest.mark.parametrize("name", ["ladder_rough_wall", "block_tips_or_slides"])
def test_two_limits_of_one_question_share_their_equations(name: str) -> None:
    """Equilibrium is written once for a block that tips and for one that slides, and so is a law of friction."""
    found = explained(name)
    for derivation in found.derivations:
        lines = lines_of(derivation.stages)
        led = {n for line in lines for n in (*line.uses, *referred(line.why))}
        twice = [line for line in lines if line.number in led]
        assert len({(line.sides, line.symbols, line.when) for line in twice}) == len(twice)


@shared
def test_numbers_run_through_and_stand_where_something_refers_to_them(name: str) -> None:
    found = explained(name)
    numbers = [line.number for line in all_lines(found) if line.number > 0]
    assert numbers == list(range(1, len(numbers) + 1))
    stages = [stage for d in found.derivations for stage in d.stages]
    named = {n for s in sentences_of(stages) for n in referred(s)}
    named |= {n for line in lines_of(stages) for n in referred(line.why)}
    assert named == set(numbers)


@shared
def test_a_question_has_the_same_result_alone_and_among_others(name: str) -> None:
    together = explained(name)
    for derivation in together.derivations:
        (alone,) = explain(together.system, derivation.question.id).derivations
        assert alone.answer.expression == derivation.answer.expression
        assert not alone.reason


def test_the_tension_of_an_atwood_machine_takes_one_line_once_the_acceleration_is_known() -> None:
    """T = m1 (g - x1''), with x1'' from the first question."""
    first, second, _energy = explained("atwood_machine").derivations
    (line,) = lines_of([stage for stage in second.stages if stage.title.key != "stage.checks"])
    assert line.why is not None
    assert line.why.key == "solve.put_back"
    told = {n.number for n in lines_of(first.stages)}
    assert set(referred(line.why)) <= told
    assert len(all_lines(explained("atwood_machine"))) <= 22


def test_what_was_asked_before_is_named_and_not_derived_again() -> None:
    derivations = {d.question.id: d for d in explained("disk_rolling_down_incline").derivations}
    (said,) = [s for s in sentences_of(derivations["acceleration"].stages) if s.key == "result.found"]
    (number,) = referred(said)
    told = next(line for line in lines_of(derivations["time"].stages) if line.number == number)
    assert told.sides[-1] == derivations["acceleration"].answer.expression


def test_another_reaction_needs_one_more_principle_only() -> None:
    derivations = {d.question.id: d for d in explained("disk_rolling_down_incline").derivations}
    said = [s.key for s in sentences_of(derivations["friction"].stages)]
    assert said.count("principle.linear") == 1
    assert "principle.angular" not in said


def test_a_common_factor_is_cancelled_where_it_appears() -> None:
    """M R^2 w''/2 = R T1 - R T2 becomes M x1'' = 2 T1 - 2 T2: the radius has gone."""
    lines = all_lines(explained("atwood_machine"))
    forces = [line for line in lines if {"T_left", "T_right"} <= set().union(*map(free_symbols, line.sides[-1:]))]
    assert "R" in set().union(*map(free_symbols, forces[0].sides))
    assert all("R" not in set().union(*map(free_symbols, line.sides)) for line in forces[1:])


def test_constraints_come_before_the_diagrams_and_these_before_the_principles() -> None:
    keys = [stage.title.key for stage in explained("atwood_machine").derivations[0].stages]
    order = ["stage.kinematics", "stage.bodies", "stage.principles", "stage.solution", "stage.checks"]
    assert [key for key in keys if key in order] == order


def test_a_tension_is_taken_from_its_equation_without_a_line_that_turns_it_round() -> None:
    lines = all_lines(explained("atwood_machine"))
    assert not any(line.why is not None and line.why.key == "solve.from" for line in lines)
    (put_in,) = [line for line in lines if line.why is not None and line.why.key == "solve.put_in"]
    assert put_in.why is not None
    parts = put_in.why.args["parts"]
    assert isinstance(parts, tuple)
    assert [part.args["unknown"] for part in parts if isinstance(part, Sentence)] == [
        Symbol("T_left"),
        Symbol("T_right"),
    ]


def test_a_second_method_stands_alone() -> None:
    system = System.load(EXAMPLES / "atwood_machine.yaml")
    (derivation,) = explain(system, "acceleration", compare="lagrange").derivations
    assert lines_of(derivation.compared)[-1].sides[-1] == derivation.answer.expression
    own = {line.number for line in lines_of(derivation.compared)}
    assert all(n in own for line in lines_of(derivation.compared) for n in referred(line.why))


def test_limiting_cases_are_told_where_they_can_be() -> None:
    """No body without mass that has a moment of inertia, no lengths that happen to be equal, no vertical incline."""
    text = explained("disk_rolling_down_incline").to_text()
    assert "I → ∞: 0" in text
    assert "m = 0" not in text
    assert "R = h" not in text
    assert "α = 90°" not in text


def test_reasons_keep_their_formulas_and_units() -> None:
    from freebody.narrative.telling.catalogue import Catalogue
    from freebody.present.report.blocks import Formula

    answer = explained("disk_rolling_down_incline").solution["time"]
    pieces = Catalogue().pieces(answer.options["d"].reason)
    assert pieces[0] == "adds "
    assert sum(isinstance(piece, Formula) for piece in pieces) == 2
    assert any("m⁴/s²" in piece for piece in pieces if isinstance(piece, str))


def test_the_energies_of_all_bodies_are_called_alike() -> None:
    """T_left is a tension, so no body has a T of its own."""
    told = {str(e[0].name) for e in legends(explained("atwood_machine")) if isinstance(e[0], Symbol)}
    assert {"E_kin_left", "E_kin_right", "E_kin_pulley"} <= told
    assert "T_pulley" not in told


def test_a_coordinate_that_a_joint_offers_is_called_by_it() -> None:
    found = explained("disk_on_angled_shaft")
    (what,) = (e[1] for e in legends(found) if isinstance(e[0], Symbol) and e[0].name == "phi_spindle")
    assert what == Sentence("symbol.angle_in", {"connection": "spindle"})
    assert "along the axes of shaft" in found.to_text()


def test_what_is_asked_of_a_body_is_not_called_as_the_body() -> None:
    text = explained("slider_crank").to_text()
    assert "v_piston = " in text
    assert " piston = " not in text
