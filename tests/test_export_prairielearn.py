"""PrairieLearn: what is written, what its server.py marks, and what PrairieLearn's own code makes of it."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import types
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from freebody.errors import InputError, SelfTestFailed
from freebody.exercises.bank import Bank
from freebody.exercises.export import examine, export_bank
from freebody.exercises.making import made_bank
from freebody.exercises.platforms import prairielearn
from freebody.exercises.prairielearn import SERVER
from freebody.exercises.typed import Typing
from freebody.language.parser import parse
from freebody.system.system import System
from test_export import CARDS, OTHERS

ROOT = Path(__file__).parent.parent
ATWOOD = "atwood_machine_acceleration"
DRIVER = ROOT / "tests" / "consumers" / "prairielearn_driver.py"


@pytest.fixture(scope="module")
def bank() -> Bank:
    return made_bank([System.load(ROOT / "examples" / "atwood_machine.yaml")], variants=2, seed=7)


@pytest.fixture(scope="module")
def written(bank: Bank, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("prairielearn") / "package"
    export_bank(bank, "prairielearn", folder)
    return folder


def exercise(folder: Path, name: str) -> dict[str, Any]:
    return json.loads((folder / "questions" / name / "exercise.json").read_text("utf-8"))


# -- what is written --------------------------------------------------------------------------
def test_an_item_is_asked_for_its_formula_its_options_and_its_number(written: Path) -> None:
    kinds = sorted(place.name for place in (written / "questions" / ATWOOD).iterdir())
    assert kinds == ["formula", "number", "options"]
    info = json.loads((written / "questions" / ATWOOD / "formula" / "info.json").read_text("utf-8"))
    assert (info["type"], info["singleVariant"]) == ("v3", False)


def test_a_package_is_the_same_when_it_is_written_again(bank: Bank) -> None:
    first, second = prairielearn.write(bank), prairielearn.write(bank)
    assert first.files == second.files
    uuids = [json.loads(text)["uuid"] for name, text in first.files.items() if name.endswith("info.json")]
    assert len(set(uuids)) == len(uuids) == len(first.names)


def test_figures_are_files_beside_the_question_that_its_texts_name(written: Path) -> None:
    folder = written / "questions" / ATWOOD / "options"
    texts = json.dumps(exercise(written, f"{ATWOOD}/options"))
    drawings = list((folder / "clientFilesQuestion").iterdir())
    assert drawings
    for drawing in drawings:
        assert drawing.name in texts
        assert drawing.read_text("utf-8").lstrip().startswith(("<svg", "<?xml"))


def test_every_variant_has_the_value_of_its_own_numbers(bank: Bank, written: Path) -> None:
    """(m1 - m2) g/(m1 + m2 + M/2), Atwood's machine with a uniform pulley, and no variant is another one."""
    variants = exercise(written, f"{ATWOOD}/number")["variants"]
    for variant, own in zip(variants, bank.items[0].variants, strict=True):
        at = {given.name: given.value for given in own.given}
        value = (at["m1"] - at["m2"]) * at["g"] / (at["m1"] + at["m2"] + at["M"] / 2)
        assert variant["correct_answers"]["answer"] == pytest.approx(value)
    assert len({variant["correct_answers"]["answer"] for variant in variants}) == 2


# -- names and signs --------------------------------------------------------------------------
def test_names_that_mean_something_else_there_get_another_one() -> None:
    typing = Typing.of(prairielearn.LANGUAGE, ["e", "m", "lambda", "rate(x)", "rate(rate(x))", "x_dot"])
    assert list(typing.theirs.values()) == ["e_1", "m", "lambda_1", "x_dot", "x_ddot", "x_dot_1"]
    assert typing.written(parse("e*m*rate(x)^2 + rate(rate(x))")) == "e_1*m*x_dot^2 + x_ddot"


def test_decimals_are_fractions_as_formulas_take_no_others() -> None:
    typing = Typing.of(prairielearn.LANGUAGE, ["m"])
    assert typing.written(parse("0.01*m")) == "(1/100)*m"


def test_a_dollar_in_words_begins_no_formula() -> None:
    assert prairielearn._words("5 $ < 6 $") == "5 <span>$</span> &lt; 6 <span>$</span>"  # type: ignore[attr-defined]


# -- marking ----------------------------------------------------------------------------------
@pytest.fixture
def graded(written: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str, str], dict[str, Any]]:
    """Runs server.py on what a student types; formulas are read by SymPy, as PrairieLearn does it."""
    sympy = pytest.importorskip("sympy")
    utils = types.ModuleType("prairielearn.sympy_utils")

    def json_to_sympy(formula: Mapping[str, Any]) -> Any:
        return sympy.sympify(formula["_value"], {name: sympy.Symbol(name) for name in formula["_variables"]})

    utils.json_to_sympy = json_to_sympy  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "prairielearn", types.ModuleType("prairielearn"))
    monkeypatch.setitem(sys.modules, "prairielearn.sympy_utils", utils)

    def run(name: str, typed: str) -> dict[str, Any]:
        server: dict[str, Any] = {"__file__": str(written / "questions" / name / "server.py")}
        exec(compile(SERVER, "server.py", "exec"), server)
        data: dict[str, Any] = {"params": {}, "correct_answers": {}, "variant_seed": 0}
        server["generate"](data)
        names = [x.strip() for x in data["params"]["parts"][0]["variables"].split(",")]
        given = {"_value": typed.replace("^", "**"), "_variables": names}
        data |= {"submitted_answers": {"answer": given}, "partial_scores": {}, "feedback": {}, "score": 0}
        server["grade"](data)
        return data

    return run


@pytest.mark.parametrize(
    "typed",
    [
        "2*g*(m1 - m2)/(2*m1 + 2*m2 + M)",  # by hand: both masses, and I/R^2 = M/2
        "g*m1/(m1 + m2 + M/2) - g*m2/(m1 + m2 + M/2)",
        "sqrt((m1 - m2)^2)*g/(m1 + m2 + M/2)*sign(m1 - m2)",
        "g - (2*m2 + M/2)*g/(m1 + m2 + M/2)",  # g - T1/m1
    ],
)
def test_server_py_takes_the_answer_in_any_form(graded: Callable[..., dict[str, Any]], typed: str) -> None:
    assert graded(f"{ATWOOD}/formula", typed)["score"] == 1


@pytest.mark.parametrize("typed", ["g*(m1 - m2)/(m1 + m2)", "g*(m2 - m1)/(m1 + m2 + M/2)", "g*(m1 - m2)/(m1 + m2 + M)"])
def test_server_py_takes_no_other(graded: Callable[..., dict[str, Any]], typed: str) -> None:
    assert graded(f"{ATWOOD}/formula", typed)["score"] == 0


def test_server_py_names_the_mistake(graded: Callable[..., dict[str, Any]]) -> None:
    """Without the inertia of the pulley the denominator is m1 + m2."""
    assert "<p>" not in (said := graded(f"{ATWOOD}/formula", "g*(m1 - m2)/(m1 + m2)")["feedback"]["answer"])
    assert "pulley" in said


def test_an_energy_counts_from_wherever_one_likes(graded: Callable[..., dict[str, Any]]) -> None:
    """E = (m1 + m2 + M/2) v^2/2 - m1 g x1 - m2 g x2, in any of the rates that the rope binds, up to a constant."""
    energy = "m1*x1_dot^2/2 + m2*x2_dot^2/2 + M*x1_dot^2/4 - m1*g*x1 - m2*g*x2"
    name = "atwood_machine_energy/formula"
    assert graded(name, energy)["score"] == 1
    assert graded(name, f"{energy} + 5*m1*g*R")["score"] == 1
    assert graded(name, f"{energy} + m1*g*x1")["score"] == 0


# -- tampering --------------------------------------------------------------------------------
def changed(written: Path, tmp_path: Path, name: str, change: Callable[[dict[str, Any]], None]) -> Path:
    folder = tmp_path / "changed"
    shutil.copytree(written, folder)
    data = exercise(folder, name)
    change(data)
    (folder / "questions" / name / "exercise.json").write_text(json.dumps(data), "utf-8")
    return folder


def test_another_value_at_a_point_fails(written: Path, tmp_path: Path) -> None:
    def change(data: dict[str, Any]) -> None:
        data["values"][0][1] *= 1.001

    with pytest.raises(SelfTestFailed, match="is marked incorrect and should be correct"):
        examine(changed(written, tmp_path, f"{ATWOOD}/formula", change))


def test_another_right_option_fails(written: Path, tmp_path: Path) -> None:
    def change(data: dict[str, Any]) -> None:
        for option in data["variants"][1]["params"]["options"]:
            option["correct"] = "false" if option["correct"] == "true" else "true"

    with pytest.raises(SelfTestFailed):
        examine(changed(written, tmp_path, f"{ATWOOD}/options", change))


def test_another_tolerance_fails(written: Path, tmp_path: Path) -> None:
    def change(data: dict[str, Any]) -> None:
        data["variants"][0]["params"]["rtol"] = "0.5"

    with pytest.raises(SelfTestFailed):
        examine(changed(written, tmp_path, f"{ATWOOD}/number", change))


def test_other_code_is_refused(written: Path, tmp_path: Path) -> None:
    folder = changed(written, tmp_path, f"{ATWOOD}/number", lambda data: None)
    place = folder / "questions" / ATWOOD / "number" / "server.py"
    place.write_text(SERVER + "\n# more\n", "utf-8")
    with pytest.raises(InputError, match="is not as it was written"):
        examine(folder)


# -- the real consumer ------------------------------------------------------------------------
def put_to_prairielearn(*packages: Path) -> list[dict[str, Any]]:
    """What PrairieLearn's element code makes of self-tests: those that fail."""
    checkout, python = (os.environ.get(f"FREEBODY_PRAIRIELEARN{name}", "") for name in ("", "_PYTHON"))
    if not checkout or not python:
        pytest.skip("NOT RUN: FREEBODY_PRAIRIELEARN and FREEBODY_PRAIRIELEARN_PYTHON say where PrairieLearn is")
    env = {"PATH": os.environ["PATH"], "PYTHONPATH": str(Path(checkout) / "apps" / "prairielearn" / "python")}
    done = subprocess.run([python, str(DRIVER), *map(str, packages)], capture_output=True, text=True, env=env)
    assert done.returncode == 0, done.stderr[-3000:]
    tests = [test for package in json.loads(done.stdout) for test in package["tests"]]
    assert tests
    return [test for test in tests if not test["passed"]]


def test_prairielearn_marks_the_self_tests_as_they_say(written: Path) -> None:
    assert put_to_prairielearn(written) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", [*CARDS, *OTHERS])
def test_prairielearn_marks_an_example_as_its_self_tests_say(name: str, tmp_path: Path) -> None:
    if not os.environ.get("FREEBODY_PRAIRIELEARN"):
        pytest.skip("NOT RUN: FREEBODY_PRAIRIELEARN says where PrairieLearn is")
    export_bank(made_bank([System.load(ROOT / "examples" / f"{name}.yaml")]), "prairielearn", tmp_path / name)
    assert put_to_prairielearn(tmp_path / name) == []
