"""Numbas: what is written, how freebody reads it, and what Numbas' own compiler and runtime make of it."""

from __future__ import annotations

import json
import math
import os
import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from freebody.errors import CannotAnswer, InputError, SelfTestFailed
from freebody.exercises.bank import Bank
from freebody.exercises.export import examine, export_bank
from freebody.exercises.formulas import formula_of
from freebody.exercises.making import made_bank
from freebody.exercises.platforms import numbas
from freebody.exercises.typed import Typing
from freebody.language.parser import parse
from freebody.system.system import System
from test_export import CARDS, OTHERS

ROOT = Path(__file__).parent.parent
DRIVER = ROOT / "tests" / "consumers" / "numbas_driver.mjs"


@pytest.fixture(scope="module")
def bank() -> Bank:
    return made_bank([System.load(ROOT / "examples" / "atwood_machine.yaml")], variants=2, seed=7)


@pytest.fixture(scope="module")
def written(bank: Bank, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("numbas") / "package"
    export_bank(bank, "numbas", folder)
    return folder


def exam_of(folder: Path) -> dict[str, Any]:
    header, _, text = (folder / numbas.FILE).read_text("utf-8").partition("\n")
    assert header.startswith("// Numbas version: ")
    return json.loads(text)


def question_of(exam: dict[str, Any], kind: str, k: int = 0) -> dict[str, Any]:
    (group,) = exam["question_groups"]
    return [q for q in group["questions"] if q["name"].endswith(f"[{kind}]")][k]


# -- what is written --------------------------------------------------------------------------
def test_an_item_is_asked_for_its_formula_its_options_and_its_number(written: Path) -> None:
    exam = exam_of(written)
    kinds = [question_of(exam, kind)["parts"][0]["type"] for kind in ("formula", "options", "number")]
    assert kinds == ["jme", "1_n_2", "numberentry"]


def test_a_package_is_the_same_when_it_is_written_again(bank: Bank) -> None:
    assert numbas.write(bank).files == numbas.write(bank).files


def test_letters_of_constants_are_names(written: Path) -> None:
    """e is a coefficient of restitution, i and j are anything; pi stays."""
    constants = question_of(exam_of(written), "formula")["builtin_constants"]
    assert constants == {"e": False, "pi,π": True, "i": False, "j": False}


def test_each_variant_shows_its_own_statement_and_has_bounds_about_its_own_value(bank: Bank, written: Path) -> None:
    """(m1 - m2) g/(m1 + m2 + M/2) within 1 %."""
    question = question_of(exam_of(written), "number")
    defined = {name: variable["definition"] for name, variable in question["variables"].items()}
    assert defined["fb_variant"] == "random(0..1)"
    for k, variant in enumerate(bank.items[0].variants):
        at = {given.name: given.value for given in variant.given}
        value = (at["m1"] - at["m2"]) * at["g"] / (at["m1"] + at["m2"] + at["M"] / 2)
        low, high = (json.loads(defined[name])[k] for name in ("fb_low", "fb_high"))
        assert (low, high) == pytest.approx((0.99 * value, 1.01 * value))
        assert f'<div data-jme-visible="fb_variant={k}">' in question["statement"]


def test_points_obey_the_rope_and_the_signs(written: Path) -> None:
    """x1 and x2 change together, and the pulley with them: rate(x1) + rate(x2) = 0, R |w_dot| = |rate(x1)|."""
    question = question_of(exam_of(written), "formula", 2)
    for point in numbas._points(question["variables"]["fb_points"]["definition"]):  # type: ignore[attr-defined]
        assert min(point[name] for name in ("m1", "m2", "M", "R", "g")) > 0
        assert point["x1_dot"] == pytest.approx(-point["x2_dot"])
        assert abs(point["R"] * point["w_dot"]) == pytest.approx(abs(point["x1_dot"]))


def test_where_only_changes_count_a_second_point_belongs_to_the_same_motion(written: Path) -> None:
    definitions = question_of(exam_of(written), "formula", 2)["variables"]
    points, later = (numbas._points(definitions[name]["definition"]) for name in ("fb_points", "fb_later"))  # type: ignore[attr-defined]
    for before, after in zip(points, later, strict=True):
        assert all(before[name] == after[name] for name in ("m1", "m2", "M", "R", "g"))
        assert before["x1"] != after["x1"]
        assert before["x1"] + before["x2"] == pytest.approx(after["x1"] + after["x2"])


def test_functions_have_their_names_there_and_come_back() -> None:
    typing = Typing.of(numbas.LANGUAGE, ["x", "e", "rate(x)"])
    ours = "log(x) + asin(e)*atan(x) - rate(x)^2/sqrt(x)"
    theirs = typing.written(parse(ours))
    assert theirs == "ln(x) + arcsin(e)*arctan(x) - x_dot^2/sqrt(x)"
    assert typing.written(typing.read(theirs.replace("x_dot", "x"))) == theirs.replace("x_dot", "x")


def test_braces_and_dollars_in_words_begin_nothing() -> None:
    assert numbas._words("{a} $b$ \\(c") == (  # type: ignore[attr-defined]
        "{<span></span>a}<span></span> $<span></span>b$<span></span> \\<span></span>(c"
    )


def test_nothing_is_computed_from_the_name_of_a_question(bank: Bank) -> None:
    """Numbas puts values into names, too."""
    item = replace(bank.items[0], name="{1/0} of $x$ \\\\(y")
    (made,) = numbas.write(replace(bank, items=(item,))).names[:1]
    assert made == f"(1/0) of x (y ({item.id}) [formula]"


def test_numbers_are_written_without_an_exponent() -> None:
    for x in (1e-7, 123456789.25, -2.5e-3, 1e22):
        text = numbas._decimal(x)  # type: ignore[attr-defined]
        assert re.fullmatch(r"-?[0-9]+(\.[0-9]+)?", text)
        assert float(text) == x


def test_an_answer_that_it_has_no_word_for_is_not_asked_as_a_formula(bank: Bank) -> None:
    """The period of a large swing, 4 sqrt(L/g) K(sin(theta/2)), has an elliptic integral."""
    item = replace(bank.items[0], expression=parse("4*sqrt(R/g)*elliptic_K(m1/(m1 + m2))"))
    with pytest.raises(CannotAnswer, match=r"^it has an elliptic integral$"):
        formula_of(item, numbas.LANGUAGE)


# -- marking ----------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("typed", "verdict"),
    [
        ("2*g*(m1 - m2)/(2*m1 + 2*m2 + M)", "correct"),  # by hand: both masses, and I/R^2 = M/2
        ("g - (2*m2 + M/2)*g/(m1 + m2 + M/2)", "correct"),  # g - T1/m1
        ("g*(m1 - m2)/(m1 + m2)", "incorrect"),
        ("g*(m1 - m2)/(m1 + m2 + M)", "incorrect"),
    ],
)
def test_the_reader_takes_the_answer_in_any_form_and_no_other(written: Path, typed: str, verdict: str) -> None:
    question = next(q for name, q in numbas.read(written).items() if name.endswith("[formula]"))
    assert question.mark(typed).verdict == verdict


def test_a_mistake_is_named(written: Path) -> None:
    question = next(q for name, q in numbas.read(written).items() if name.endswith("[formula]"))
    assert "pulley" in question.mark("g*(m1 - m2)/(m1 + m2)").feedback


def test_a_name_that_the_exercise_does_not_have_is_no_answer(written: Path) -> None:
    question = next(q for name, q in numbas.read(written).items() if name.endswith("[formula]"))
    with pytest.raises(InputError):
        question.mark("g*(m1 - m2)/(m1 + m2 + mu)")


# -- tampering --------------------------------------------------------------------------------
def changed(written: Path, tmp_path: Path, change: Callable[[dict[str, Any]], None]) -> Path:
    folder = tmp_path / "changed"
    shutil.copytree(written, folder)
    exam = exam_of(folder)
    change(exam)
    (folder / numbas.FILE).write_text("// Numbas version: x\n" + json.dumps(exam), "utf-8")
    return folder


def test_another_answer_fails(written: Path, tmp_path: Path) -> None:
    def change(exam: dict[str, Any]) -> None:
        question_of(exam, "formula")["parts"][0]["answer"] += " + m1"

    with pytest.raises(SelfTestFailed, match="is marked incorrect and should be correct"):
        examine(changed(written, tmp_path, change))


def test_another_right_option_fails(written: Path, tmp_path: Path) -> None:
    def change(exam: dict[str, Any]) -> None:
        question_of(exam, "options")["parts"][0]["matrix"].reverse()

    with pytest.raises(SelfTestFailed):
        examine(changed(written, tmp_path, change))


def test_other_bounds_fail(written: Path, tmp_path: Path) -> None:
    def change(exam: dict[str, Any]) -> None:
        question_of(exam, "number")["variables"]["fb_high"]["definition"] = "[100, 100]"

    with pytest.raises(SelfTestFailed):
        examine(changed(written, tmp_path, change))


def test_another_way_of_marking_fails(written: Path, tmp_path: Path) -> None:
    def change(exam: dict[str, Any]) -> None:
        question_of(exam, "formula")["parts"][0]["customMarkingAlgorithm"] = "mark: correct()"

    with pytest.raises(SelfTestFailed):
        examine(changed(written, tmp_path, change))


def test_a_file_that_is_no_exam_is_refused(written: Path, tmp_path: Path) -> None:
    folder = tmp_path / "changed"
    shutil.copytree(written, folder)
    (folder / numbas.FILE).write_text("{}", "utf-8")
    with pytest.raises(InputError):
        examine(folder)


def test_a_number_on_the_edge_of_the_tolerance_counts(written: Path) -> None:
    question = next(q for name, q in numbas.read(written).items() if "[number]" in name)
    low, high = (question.bounds[name][question.variant] for name in ("fb_low", "fb_high"))
    assert [question.mark(repr(x)).verdict for x in (low, high, math.nextafter(low, 0) * 0.999)] == [
        "correct", "correct", "incorrect",
    ]  # fmt: skip


# -- the real consumer ------------------------------------------------------------------------
def put_to_numbas(*packages: Path) -> list[dict[str, Any]]:
    """What Numbas makes of self-tests: those that fail."""
    checkout, python = os.environ.get("FREEBODY_NUMBAS", ""), os.environ.get("FREEBODY_NUMBAS_PYTHON", "python3")
    if not checkout:
        pytest.skip("NOT RUN: FREEBODY_NUMBAS says where Numbas is, with jsdom in it")
    words = ["node", str(DRIVER), checkout, python, *map(str, packages)]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-3000:]
    tests = [test for package in json.loads(done.stdout) for test in package["tests"]]
    assert tests
    return [test for test in tests if not test["passed"]]


def test_numbas_marks_the_self_tests_as_they_say(written: Path) -> None:
    assert put_to_numbas(written) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", [*CARDS, *OTHERS])
def test_numbas_marks_an_example_as_its_self_tests_say(name: str, tmp_path: Path) -> None:
    if not os.environ.get("FREEBODY_NUMBAS"):
        pytest.skip("NOT RUN: FREEBODY_NUMBAS says where Numbas is")
    export_bank(made_bank([System.load(ROOT / "examples" / f"{name}.yaml")]), "numbas", tmp_path / name)
    assert put_to_numbas(tmp_path / name) == []
