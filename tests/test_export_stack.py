"""Questions for STACK: what is written, and what our own reader and, where it is there, STACK itself say to answers."""

from __future__ import annotations

import json
import os
import random
import re
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest

from freebody.assess.names import named_in
from freebody.errors import InputError, SelfTestFailed
from freebody.exercises.bank import Bank
from freebody.exercises.export import examine, export, export_bank
from freebody.exercises.making import made_bank
from freebody.exercises.platforms import moodle_stack
from freebody.exercises.stack.castext import by_variant, string, words
from freebody.exercises.stack.comparing import COMPARING, Points, points_of
from freebody.exercises.stack.maxima import MaximaNames
from freebody.exercises.stack.seeds import drawn, seeds
from freebody.language.expression import Expr, evaluate
from freebody.language.parser import parse
from freebody.system.system import System
from test_export import CARDS, OTHERS

HOSTILE = 'Block ]]> {@1+1@} [[input:ans9]] \\(x\\) $y$ {#z#} <b>&amp;"'
BLOCK = f"""
freebody: 1
title: {json.dumps(HOSTILE)}
about: {json.dumps("A block is pushed. " + HOSTILE)}
parameters: {{m_1: 2 kg, e: 3 N, F_1x: 5 N, mu: 0.2}}
bodies: {{block: {{particle: {{mass: m_1}}}}}}
connections: {{rail: {{slider: {{body: block, along: right}}}}}}
loads:
  push: {{force: {{at: block, along: right, magnitude: e}}}}
  pull: {{force: {{at: block, along: right, magnitude: F_1x}}}}
measures: {{x: {{travel of block along right}}}}
questions:
  - id: a
    find: acceleration of x
    options: {{a: (e + F_1x)/m_1, b: e/m_1, c: (e - F_1x)/m_1}}
    key: a
"""


ROOT = Path(__file__).parent.parent
DRIVER = ROOT / "tests" / "consumers" / "stack_driver.php"
ENERGY = "Atwood machine with a massive pulley: the total energy of the system: ans1"
ACCELERATION = "Atwood machine with a massive pulley: the acceleration x₁'': ans1"


@pytest.fixture(scope="module")
def bank() -> Bank:
    return made_bank([System.load(ROOT / "examples" / "atwood_machine.yaml")], variants=3)


@pytest.fixture(scope="module")
def folder(bank: Bank, tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("stack") / "package"
    export_bank(bank, "moodle-stack", found)
    return found


@pytest.fixture(scope="module")
def hostile(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("stack") / "hostile"
    export(System.from_text(BLOCK), to="moodle-stack", out=found)
    return found


def questions_in(folder: Path) -> list[ElementTree.Element]:
    root = ElementTree.parse(folder / moodle_stack.FILE).getroot()
    return [q for q in root.iter("question") if q.get("type") == "stack"]


# -- formulas in Maxima -----------------------------------------------------------------------
FORMULAS = (
    "(m1 - m2)*g/(m1 + m2 + M/2)",
    "-x1^-2*F_1x + e^2/m_1",
    "rate(x1)^2/2 + rate(rate(x1))*x1",
    "0.0625*sqrt(1 + 2*g*x1)^3 - abs(x1 - g)",
    "asin(x1/9)*sign(m1) + tan(x1) - log(m2)*exp(-g)",
    "4*elliptic_K(x1/9)*sqrt(g) + elliptic_F(m1, x1/8) + pi/3",
    "-(x1 - m1)^2/-(m2*g)^(1/3)",
)


@pytest.mark.parametrize("text", FORMULAS)
def test_a_formula_in_maxima_has_the_values_of_the_formula(text: str) -> None:
    names = MaximaNames.of(dict.fromkeys(named_in(parse(text))))
    rng = random.Random(5)
    values = {name: rng.uniform(0.5, 2.0) for name in names.maxima}
    theirs = {names.maxima[name]: value for name, value in values.items()}
    read = names.read(names.written(parse(text)))
    assert evaluate(MaximaNames({}).read(names.written(parse(text))), theirs) == pytest.approx(
        evaluate(parse(text), values)
    )
    assert evaluate(read, values) == pytest.approx(evaluate(parse(text), values))


def test_names_are_such_that_stack_reads_them_as_one() -> None:
    """No letter behind a digit, no constant, M_1 as M1, all different."""
    keys = ["F_1x", "e", "i", "M_1", "M1", "theta_BC", "x1", "k_1_2", "rate(x1)", "rate(rate(x1))"]
    maxima = MaximaNames.of(keys).maxima
    found = [maxima[key] for key in ("F_1x", "e", "i", "rate(x1)", "rate(rate(x1))")]
    assert found == ["F_x1", "e0", "i0", "dot_x1", "ddot_x1"]
    assert len(set(maxima.values())) == len(keys)
    assert not any(re.search(r"[0-9]_?[A-Za-z]", name) for name in maxima.values())


def test_seeds_follow_the_published_mersenne_twister() -> None:
    """The first outputs of init_genrand(5489), as std::mt19937 has them, and of init_genrand(1)."""
    assert drawn(5489, 2**32) == 3499211612
    assert drawn(1, 2**32) == 1791095845
    assert [drawn(seed, 3) for seed in seeds(3)] == [0, 1, 2]
    assert seeds(1) == ()


# -- texts ------------------------------------------------------------------------------------
def test_words_are_no_markup_of_any_kind() -> None:
    written = words(HOSTILE)
    for sign in ("{@", "{#", "[[", "]]", "\\(", "$", "<b>", '"'):
        assert sign not in written
    assert "".join(ElementTree.fromstring(f"<p>{written}</p>").itertext()) == HOSTILE


def test_a_string_of_maxima_ends_where_it_should() -> None:
    assert string('a "b" \\frac') == '"a \\"b\\" \\\\frac"'


def test_what_is_the_same_in_all_variants_is_written_once() -> None:
    assert by_variant(["a", "a"]) == "a"
    assert by_variant(["a", "b"]) == '[[if test="is(fbn=1)"]]a[[elif test="is(fbn=2)"]]b[[/if]]'


def test_hostile_words_of_an_author_stay_words(hostile: Path) -> None:
    (question,) = questions_in(hostile)
    text = question.findtext("questiontext/text") or ""
    assert text.count("[[input:") == 2
    assert "ans9" in text
    assert not re.search(r"\{[@#]", text.replace("{@fbn@}", ""))
    assert examine(hostile) > 0


def test_letters_of_a_formula_are_no_units_where_a_number_is_asked_for_as_well(hostile: Path) -> None:
    """STACK looks for misspelt units in all inputs of such a question: k would be refused, as K is one."""
    (question,) = questions_in(hostile)
    options = {i.findtext("type"): i.findtext("options") for i in question.findall("input")}
    assert {key: value or "" for key, value in options.items()} == {
        "algebraic": "consolidatesubscripts, nounits",
        "units": "",
    }


def test_names_that_stack_would_misread_are_told_to_those_who_answer(hostile: Path) -> None:
    """e is a force here: STACK would take it for a constant."""
    (question,) = questions_in(hostile)
    text = question.findtext("questiontext/text") or ""
    assert "<code>e0</code>" in text
    assert "<code>F_x1</code>" in text
    variables = question.findtext("questionvariables/text") or ""
    assert "fbkey:(e0 + F_x1)/m1;" in variables or "fbkey:(F_x1 + e0)/m1;" in variables


# -- what our own reader says -----------------------------------------------------------------
def marked(folder: Path, name: str, typed: str) -> tuple[str, str]:
    found = moodle_stack.read(folder)[name].mark(typed)
    return found.verdict, found.feedback


@pytest.mark.parametrize(
    "typed",
    [
        "g*(m1-m2)/(m1+m2+M/2)",
        "2*g*(m1-m2)/(2*m1+2*m2+M)",
        "g - g*(2*m2+M/2)/(m1+m2+M/2)",  # m1 a = m1 g - T
    ],
)
def test_the_answer_is_right_in_any_form(folder: Path, typed: str) -> None:
    assert marked(folder, ACCELERATION, typed)[0] == "correct"


def test_an_energy_is_right_in_other_coordinates_and_up_to_a_constant(folder: Path) -> None:
    """x2 = const - x1 and w = x1'/R of the string, which computer algebra does not know."""
    whole = "m1*dot_x1^2/2 + m2*dot_x2^2/2 + M*R^2*dot_w^2/4 - m1*g*x1 - m2*g*x2"
    assert marked(folder, ENERGY, whole)[0] == "correct"
    assert marked(folder, ENERGY, f"{whole} + 7*m1*g*R")[0] == "correct"
    assert marked(folder, ENERGY, whole.replace("/4", "/2"))[0] == "incorrect"


def test_a_wrong_answer_is_told_its_mistake_its_sign_its_dimension_or_its_factor(folder: Path) -> None:
    said = {
        "g*(m1-m2)/(m1+m2)": "is forgotten",
        "g*(m2-m1)/(m1+m2+M/2)": "Only the sign is wrong.",
        "(m1-m2)*R*g/(m1+m2+M/2)": "does not have the unit",
        "3*g*(m1-m2)/(m1+m2+M/2)": "times a constant factor",
    }
    for typed, words_ in said.items():
        verdict, feedback = marked(folder, ACCELERATION, typed)
        assert verdict == "incorrect"
        assert words_ in feedback


def test_numbers_follow_the_variant_of_the_seed(folder: Path, bank: Bank) -> None:
    """m1 g (2 m2 + M/2)/(m1 + m2 + M/2) at the numbers of each, within 1 %, in other units too."""
    for seed, variant in zip(seeds(3), bank.items[1].variants, strict=True):
        at = {given.name: given.value for given in variant.given}
        value = at["m1"] * at["g"] * (2 * at["m2"] + at["M"] / 2) / (at["m1"] + at["m2"] + at["M"] / 2)
        part = f"{bank.items[1].name}: ans2 ({seed})"
        for factor, verdict in ((1.0, "correct"), (1.009, "correct"), (0.98, "incorrect"), (-1.0, "incorrect")):
            assert marked(folder, part, f"{factor * value:.10g}*N")[0] == verdict
        assert marked(folder, part, f"{value / 1000:.10g}*kN")[0] == "correct"
        assert marked(folder, part, f"{value:.10g}*m")[0] == "incorrect"


def test_a_question_has_a_figure_with_its_words_for_each_variant(folder: Path) -> None:
    for question in questions_in(folder):
        names = {f.get("name") for f in question.findall("questiontext/file")}
        text = question.findtext("questiontext/text") or ""
        assert names
        assert set(re.findall(r"@@PLUGINFILE@@/([a-z0-9_.]+)", text)) == names
        assert len(question.findall("deployedseed")) == 3


def test_a_package_is_the_same_when_it_is_written_again(bank: Bank) -> None:
    assert moodle_stack.write(bank) == moodle_stack.write(bank)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("fbkey:g*", "fbkey:2*g*"),
        ("<truescore>1", "<truescore>0"),
        ("fbn:rand(3)", "fbn:rand(2)"),
        ("fbsame(-", "fbsme(-"),
    ],
)
def test_a_package_that_was_tampered_with_is_found_out(folder: Path, tmp_path: Path, old: str, new: str) -> None:
    copy = tmp_path / "copy"
    shutil.copytree(folder, copy)
    file = copy / moodle_stack.FILE
    text = file.read_text("utf-8")
    assert old in text
    file.write_text(text.replace(old, new), "utf-8")
    with pytest.raises((SelfTestFailed, InputError)):
        examine(copy)


def test_statements_are_chosen_among_options(tmp_path: Path) -> None:
    export(ROOT / "examples" / "multi_bar_platform.yaml", to="moodle-stack", out=tmp_path / "p", language="de")
    (question,) = questions_in(tmp_path / "p")
    kinds = [i.findtext("type") for i in question.findall("input")]
    assert kinds == ["algebraic"]
    assert question.findtext("prt/node/sans") == "ans1"
    assert "ganze Zahl" in (question.findtext("questiontext/text") or "")


# -- Maxima and STACK themselves --------------------------------------------------------------
def in_maxima(statements: list[str]) -> list[str]:
    if shutil.which("maxima") is None:
        pytest.skip("NOT RUN: there is no Maxima on the path")
    text = "display2d:false$ " + "\n".join(statements)
    run = subprocess.run(["maxima", "--very-quiet"], input=text, capture_output=True, text=True, check=True, timeout=60)
    return [line.strip() for line in run.stdout.splitlines() if line.strip() in ("true", "false")]


def test_maxima_compares_as_our_own_reader_does(bank: Bank) -> None:
    """The functions of a question, run by Maxima: the same verdicts as those in Python."""
    for item in (bank.items[0], bank.items[2]):
        assert item.sampling is not None
        assert isinstance(item.expression, Expr)
        offered = [s.name for s in item.symbols] + [f"rate({s.name})" for s in item.symbols if s.is_moving]
        names = MaximaNames.of(dict.fromkeys(offered))
        points = points_of(item.sampling, names.maxima, (item.expression,), item.unit)
        given = [parse(text) for text in (*item.equivalent, *(w.text for w in item.wrong), "-m1*g", "7*x1*m2")]
        given += [item.expression, -item.expression, 3 * item.expression]
        key = (item.expression,)
        wanted = [
            x
            for e in given
            for x in (points.same((e,), key), points.is_multiple((e,), key), points.has_dimension((e,)))
        ]
        asked = [
            f"{test};"
            for e in map(names.written, given)
            for test in (f"fbsame({e},fbkey)", f"fbfactor({e},fbkey)", f"fbunits({e})")
        ]
        head = [*points.written(names), *COMPARING, f"fbkey:{names.written(item.expression)};"]
        told = in_maxima([*(line.rstrip(";") + "$" for line in head), *asked])
        assert told == [str(x).lower() for x in wanted]


@pytest.fixture(scope="session")
def image(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where STACK keeps its image of Maxima."""
    given = os.environ.get("FREEBODY_STACK_CACHE", "")
    folder = Path(given) if given else tmp_path_factory.mktemp("stack-cache")
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@pytest.mark.slow
@pytest.mark.parametrize("name", [*CARDS, *OTHERS])
def test_stack_itself_marks_as_expected(name: str, tmp_path: Path, image: Path) -> None:
    """The question tests of a package, run by STACK's own loader and Maxima (see tests/consumers/README.md)."""
    checkout = os.environ.get("FREEBODY_STACK", "")
    if not checkout:
        pytest.skip("NOT RUN: FREEBODY_STACK says where STACK is")
    if shutil.which("php") is None or shutil.which("maxima") is None:
        pytest.skip("NOT RUN: STACK needs php and maxima")
    export(ROOT / "examples" / f"{name}.yaml", to="moodle-stack", out=tmp_path / "p")
    file = str(tmp_path / "p" / moodle_stack.FILE)
    run = subprocess.run(["php", str(DRIVER), checkout, str(image), file], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    told = json.loads(run.stdout)
    assert len(told) == len(questions_in(tmp_path / "p"))
    for question in told:
        assert question["passes"] > 0
        assert not question["fails"], question
        assert not question["errors"], question
        assert not question["messages"], question


def test_a_factor_is_seen_in_a_vector_whose_first_component_vanishes() -> None:
    points = Points(({"a": 1.0}, {"a": 2.0}))
    key = (parse("0"), parse("a^2"))
    assert points.is_multiple((parse("0"), parse("-7*a^2")), key)
    assert not points.is_multiple((parse("0"), parse("a")), key)
    assert not points.is_multiple((parse("a^2"), parse("a^2")), key)
    assert not points.is_multiple((parse("0"), parse("0")), key)
