"""Mistakes behind wrong options, and exercise sheets."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path
from typing import Any, cast

import pytest

from freebody import System
from freebody.errors import InputError
from freebody.language.sentences import Sentence
from freebody.narrative.context import Context
from freebody.narrative.mistakes.mistakes import found_mistakes
from freebody.narrative.sheets.in_numbers import rounded
from freebody.narrative.sheets.sheet import load_systems, sheet
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Block, Figure, Figures, Section, Step, Unbroken, equation_numbers
from freebody.present.report.formats.terminal import terminal_text
from freebody.study.answering.solve import solve

EXAMPLES = Path(__file__).parent.parent / "examples"

ATWOOD = """
freebody: 1
title: Atwood machine
parameters: {m1: 3 kg, m2: 2 kg, M: 1 kg, R: 0.1 m, g: 9.81 m/s^2}
bodies:
  pulley: {disk: {mass: M, radius: R}}
  left:   {particle: {mass: m1}}
  right:  {particle: {mass: m2}}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right, grips: [pulley]}}
loads:
  weight: {gravity: g}
measures:
  x: {drop of left below ground.axle}
start: {rate(x): 0}
"""
PENDULUM = """
freebody: 1
title: Physical pendulum
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
bodies:
  rod: {rod: {mass: m, length: L}}
connections:
  hinge: {pin: [ground.O, rod.start]}
loads:
  weight: {gravity: g}
measures:
  theta: {angle of rod from down}
start: {theta: 0, rate(theta): 0}
"""
INCLINE = """
freebody: 1
title: Block on a smooth incline
parameters: {m: 2 kg, alpha: 30 deg, v0: 1 m/s, h: 1 m, g: 9.81 m/s^2}
ground:
  lines: {incline: {along: -alpha}}
bodies:
  block: {particle: {mass: m}}
connections:
  guide: {slider: {body: block, along: incline}}
loads:
  weight: {gravity: g}
measures:
  s: {travel of block along incline}
start: {s: 0, rate(s): v0}
"""


def asked(model: str, find: str, *options: str) -> System:
    """A model with one question and options a, b, c ..."""
    lines = "".join(f'      {letter}: "{text}"\n' for letter, text in zip("abcdefgh", options, strict=False))
    return System.from_text(f"{model}questions:\n  - find: {find}\n    options:\n{lines}")


def told(system: System) -> dict[str, str]:
    """The mistakes found for the first question, in English."""
    answer = solve(system).answers[0]
    found = found_mistakes(Context(system), system.questions[0], answer)
    return {letter: Catalogue().plain(said) for letter, said in found.items()}


# -- mistakes ---------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("option", "mistake"),
    [
        ("(m1 - m2)/(m1 + m2)*g", "the moment of inertia of pulley is forgotten, as if the tension were the same"),
        ("(m1 - m2)/(m1 + m2 + M)*g", "the moment of inertia of pulley is taken to be that of a ring"),
        ("(m1 + m2)/(m1 + m2 + M/2)*g", "the weight of right has the wrong sign"),
        ("(m1 - m2)/(m2 + M/2)*g", "the inertia term of left is forgotten"),
        ("(m1 - m2)/(m1 + m2 + M/2)", "the factor g is forgotten"),
        (
            "(m1 + m2)/(m1 - m2 - M/2)*g",
            "the tension of rope at left and pulley has the wrong sign in the equations for",
        ),
        ("(m1 - m2)/(m1 - M/2)*g", "and the inertia term of right is forgotten"),
    ],
)
def test_mistakes_of_an_atwood_machine_are_named(option: str, mistake: str) -> None:
    right = "(m1 - m2)/(m1 + m2 + M/2)*g"
    assert mistake in told(asked(ATWOOD, "acceleration of x", option, right))["a"]


def test_an_option_that_no_mistake_gives_exactly_has_none() -> None:
    right = "(m1 - m2)/(m1 + m2 + M/2)*g"
    assert told(asked(ATWOOD, "acceleration of x", "(m1 - m2)/(m1 + m2 + 13*M/27)*g", right)) == {}


def test_the_right_option_has_no_mistake() -> None:
    right = "(m1 - m2)/(m1 + m2 + M/2)*g"
    assert told(asked(ATWOOD, "acceleration of x", right, "0*g")).keys() <= {"b"}


@pytest.mark.parametrize(
    ("option", "mistake"),
    [
        ("-6*g/L*sin(theta)", "about its mass centre instead of the axis of rotation"),
        ("-2*g/L*sin(theta)", "the moment of inertia of rod is forgotten"),
        ("-6*g/(7*L)*sin(theta)", "about its end instead of its middle"),
        ("3*g/(2*L)*sin(theta)", "weight has the wrong sign"),
        ("-3*g/(2*L)*cos(theta)", "sine and cosine of θ are exchanged"),
        ("-3*g/(4*L)*sin(theta)", "2 L is put in for L"),
    ],
)
def test_mistakes_of_a_physical_pendulum_are_named(option: str, mistake: str) -> None:
    assert mistake in told(asked(PENDULUM, "acceleration of theta", option, "-3*g/(2*L)*sin(theta)"))["a"]


def test_forgotten_turns_of_a_period_are_named() -> None:
    system = asked(PENDULUM, "period of small oscillations", "sqrt(2*L/(3*g))", "2*pi*sqrt(L/(2*g))")
    found = told(system)
    assert "the factor 2 π is forgotten" in found["a"]
    assert "moment of inertia of rod is forgotten" in found["b"]


@pytest.mark.parametrize(
    ("option", "mistake"),
    [
        ("sqrt(v0^2 + g*h)", "v² = a·s is used in place of v² = 2·a·s"),
        ("sqrt(v0^2 + 2*g*h*sin(alpha))", "the way is taken to be h"),
        ("sqrt(2*g*h)", "the initial velocity is forgotten"),
        ("v0^2 + 2*g*h", "the square root is forgotten"),
    ],
)
def test_mistakes_of_a_speed_on_an_incline_are_named(option: str, mistake: str) -> None:
    assert mistake in told(asked(INCLINE, "velocity of s when s = h/sin(alpha)", option, "sqrt(v0^2 + 2*g*h)"))["a"]


def test_the_other_root_of_a_time_is_named() -> None:
    option = "(-v0 - sqrt(v0^2 + 2*g*h))/(g*sin(alpha))"
    assert "the root is taken with the other sign" in told(asked(INCLINE, "time when s = h/sin(alpha)", option))["a"]


def test_a_reaction_question_never_speaks_of_an_axis() -> None:
    """There the factor of a mass stands in the equations of forces as well."""
    system = System.load(EXAMPLES / "falling_hinged_rod.yaml")
    solution = solve(system)
    question = next(q for q in system.questions if q.options)
    found = found_mistakes(Context(system), question, solution[question.id])
    assert "the inertia term of the mass centre of rod" in Catalogue().plain(found["a"])


def test_kinetic_energy_is_called_by_its_name() -> None:
    options = ("m1*rate(x)^2/2 + m2*rate(x)^2/2 - m1*g*x + m2*g*x", "(m1 + m2 + M/2)*rate(x)^2/2 + 3*m2*g*R")
    found = told(asked(ATWOOD, "total energy", *options))
    assert "the energy of rotation of pulley is left out" in found["a"]
    assert "the potential energy of gravity is left out" in found["b"]  # up to a constant


def test_planets_counted_once_are_named() -> None:
    system = System.load(EXAMPLES / "planetary_gear.yaml")
    question = system.questions[0]
    found = found_mistakes(Context(system), question, solve(system)[question.id])
    assert "only one of P₁, P₂ and P₃ is counted" in Catalogue().plain(found["a"])


def test_a_spring_counted_as_a_constraint_is_named() -> None:
    system = System.load(EXAMPLES / "multi_bar_platform.yaml")
    found = found_mistakes(Context(system), system.questions[0], solve(system).answers[0])
    assert "spring is counted as a constraint" in Catalogue().plain(found["a"])


def test_options_without_an_expression_are_left_alone() -> None:
    system = System.load(EXAMPLES / "body_on_driven_roller.yaml")
    answer = solve(system)["conserved"]
    assert found_mistakes(Context(system), system.questions[0], answer) == {}


# -- sheets -----------------------------------------------------------------------------------
def test_a_sheet_numbers_its_exercises_and_questions() -> None:
    made = sheet([asked(ATWOOD, "acceleration of x", "g"), System.load(EXAMPLES / "simple_pendulum.yaml")])
    titles = [block.title for block in made.report().blocks if isinstance(block, Section)]
    assert ["".join(map(str, title)) for title in titles] == ["1. Atwood machine", "2. Simple pendulum"]
    labels = [key.label for key in made.key()]
    assert labels == ["1", "2.1", "2.2", "2.3", "2.4", "2.5"]


def test_a_sheet_as_it_is_has_the_numbers_of_the_file() -> None:
    text = terminal_text(sheet([asked(ATWOOD, "acceleration of x", "g")]).report()).replace("\N{NO-BREAK SPACE}", " ")
    assert "m₁ = 3 kg" in text
    assert "Find the acceleration x''." in text
    assert "(a) g" in text


def test_a_question_without_options_has_a_formula_and_a_value_in_the_key() -> None:
    system = System.from_text(f"{ATWOOD}questions: [{{find: acceleration of x}}]")
    (key,) = sheet([system]).key()
    assert key.letter == ""
    assert key.value == pytest.approx(9.81 / 5.5)
    assert key.expression is not None


def test_variants_have_other_numbers_that_the_key_follows() -> None:
    options = ("(m1 - m2)/(m1 + m2)*g", "(m1 - m2)/(m1 + m2 + M/2)*g", "g", "m1*g/M", "m2*g/M")
    made = sheet([asked(ATWOOD, "acceleration of x", *options)], variants=3, seed=1)
    seen: set[tuple[float | None, ...]] = set()
    for n in range(1, 4):
        (exercise,), (key,) = made.variant(n), made.key(n)
        p = {name: parameter.value or 0.0 for name, parameter in exercise.system.parameters.items()}
        seen.add(tuple(p.values()))
        assert p["g"] == 9.81
        assert key.value == pytest.approx((p["m1"] - p["m2"]) / (p["m1"] + p["m2"] + p["M"] / 2) * p["g"])
        right = exercise.system.questions[0].options[key.letter]
        assert right == "(m1 - m2)/(m1 + m2 + M/2)*g"
        assert list(exercise.system.questions[0].options) == list("abcde")
    assert len(seen) == 3


@pytest.mark.parametrize(
    "questions",
    [
        "{a: acceleration of x, b: {find: acceleration of x, options: {p: F/m, q: F}, key: p}}",
        "[acceleration of x, {find: acceleration of x, options: [F/m, F], key: a}]",
    ],
)
def test_variants_of_questions_however_they_are_written(questions: str) -> None:
    text = f"""
parameters: {{F: 6 N, m: 2 kg}}
bodies: {{cart: {{particle: {{mass: m}}}}}}
connections: {{rail: {{slider: {{body: cart, along: right}}}}}}
loads: {{push: {{force: {{at: cart, along: right, magnitude: F}}}}}}
measures: {{x: x of cart}}
questions: {questions}
"""
    made = sheet([System.from_text(text)], variants=2, seed=3)
    for n in (1, 2):
        (exercise,) = made.variant(n)
        asked = exercise.system.questions[1]
        assert asked.options[str(asked.key)] == "F/m"
        assert sorted(asked.options.values()) == ["F", "F/m"]


def test_the_same_seed_gives_the_same_sheet_and_another_another() -> None:
    system = asked(ATWOOD, "acceleration of x", "g", "m1*g/M", "(m1 - m2)/(m1 + m2 + M/2)*g", "m2*g/M")
    texts = [terminal_text(sheet([system], variants=2, seed=seed).report(2)) for seed in (1, 1, 2)]
    assert texts[0] == texts[1] != texts[2]


def test_numbers_are_those_that_a_person_would_write() -> None:
    assert rounded(0.123456, 2) == "0.12"
    assert rounded(123.456, 2) == "120"
    assert rounded(1999.6, 3) == "2000"
    system = System.load(EXAMPLES / "disk_rolling_down_incline.yaml")
    ((exercise,),) = (sheet([system], variants=2, seed=3).variant(2),)
    data = exercise.system.document.data["parameters"]
    assert int(str(data["alpha"]).split()[0]) % 5 == 0
    assert all(len(str(data[name]).split()[0].replace(".", "").lstrip("0")) <= 2 for name in ("m", "R", "I", "v0", "h"))


def test_solutions_in_the_sheet_have_equation_numbers_of_their_own() -> None:
    systems = [System.from_text(f"{model}questions: [{{find: acceleration of {x}}}]") for model, x in _TWO]
    for where in ("inline", "end"):
        report = sheet(systems, solutions=where).report()
        numbers = equation_numbers(report.blocks)
        assert len(numbers) > 6
        assert len(set(numbers)) == len(numbers)
        figures = _figures(report.blocks)
        assert figures == list(range(1, len(figures) + 1))  # as they stand on the paper
    assert equation_numbers(sheet(systems).report().blocks) == []


_TWO = ((ATWOOD, "x"), (PENDULUM, "theta"))


def _figures(blocks: Sequence[Block]) -> list[int]:
    found: list[int] = []
    for block in blocks:
        match block:
            case Figure():
                found.append(block.number)
            case Figures(figures):
                found += [figure.number for figure in figures]
            case Section() | Step() | Unbroken():
                found += _figures(block.blocks)
            case _:
                pass
    return found


def test_a_sheet_is_written_with_its_key_beside_it(tmp_path: Path) -> None:
    system = asked(ATWOOD, "acceleration of x", "g", "(m1 - m2)/(m1 + m2 + M/2)*g")
    one = sheet([system]).write(tmp_path / "week.txt")
    assert [p.name for p in one] == ["week.txt", "week-key.txt"]
    assert "(b)" in (tmp_path / "week-key.txt").read_text("utf-8")
    several = sheet([system], variants=2, seed=4).write(tmp_path / "week.html")
    assert [p.name for p in several] == ["week-1.html", "week-2.html", "week-key.html"]
    assert "Variant 2" in (tmp_path / "week-2.html").read_text("utf-8")


def test_no_file_is_written_where_one_cannot_be(tmp_path: Path) -> None:
    made = sheet([asked(ATWOOD, "acceleration of x", "g")])
    with pytest.raises(InputError, match="must end in"):
        made.write(tmp_path / "week.docx")
    assert list(tmp_path.iterdir()) == []


def test_a_model_without_questions_is_refused_with_what_to_add() -> None:
    with pytest.raises(InputError, match=r"Atwood machine: an exercise needs a question; add questions: .*of x"):
        sheet([System.from_text(ATWOOD)])


def test_all_problems_of_all_files_come_in_one_message(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text(ATWOOD.replace("m1}", "m3}"), "utf-8")
    (tmp_path / "b.yaml").write_text(PENDULUM, "utf-8")
    with pytest.raises(InputError) as caught:
        load_systems([tmp_path / "a.yaml", tmp_path / "b.yaml", tmp_path / "c.yaml"])
    message = str(caught.value)
    assert all(name in message for name in ("a.yaml", "m3", "b.yaml", "needs a question", "c.yaml"))


def test_unknown_words_are_refused() -> None:
    system = asked(ATWOOD, "acceleration of x", "g")
    with pytest.raises(InputError, match=r"solutions can be none, end, inline, not ends.*Did you mean end"):
        sheet([system], solutions="ends")
    with pytest.raises(InputError, match="at least 1"):
        sheet([system], variants=0)
    with pytest.raises(InputError, match="at least one model"):
        sheet([])
    with pytest.raises(InputError, match="there are 1 to 1"):
        sheet([system]).report(2)


def test_two_exercises_may_have_the_same_title() -> None:
    system = asked(ATWOOD, "acceleration of x", "g")
    first, second = sheet([system, system], variants=2, seed=1).variant(1)
    assert first.system.parameters["m1"].value != second.system.parameters["m1"].value


def test_every_example_with_questions_can_be_set_as_an_exercise() -> None:
    from freebody.narrative.sheets.asking import asking

    catalogue = Catalogue()
    for path in sorted(EXAMPLES.glob("*.yaml")):
        system = System.load(path)
        for question in system.questions:
            said = catalogue.plain(asking(system, question))
            assert said.endswith((".", "?"))
            assert "{" not in said


def test_german_has_the_same_sentences() -> None:
    def keys(table: dict[str, Any], before: str = "") -> set[str]:
        found: set[str] = set()
        for key, value in table.items():
            found |= (
                keys(cast("dict[str, Any]", value), f"{before}{key}.") if isinstance(value, dict) else {before + key}
            )
        return found

    words = files("freebody.narrative.words")
    english, german = (keys(tomllib.loads((words / f"{x}.sheet.toml").read_text("utf-8"))) for x in ("en", "de"))
    assert english <= german
    assert Catalogue("de").plain(Sentence("sheet.variant", {"n": 2})) == "Variante 2"


def test_questions_of_rest_are_asked_in_sentences() -> None:
    told = terminal_text(sheet([System.load(EXAMPLES / "ladder_rough_wall.yaml")]).report())
    assert "Find the least μ for which the system stays at rest." in told
    assert "Does the system stay at rest?" in told
    told = terminal_text(sheet([System.load(EXAMPLES / "capstan.yaml")], language="de").report())
    assert "Für welche Werte von F bleibt das System in Ruhe?" in told
