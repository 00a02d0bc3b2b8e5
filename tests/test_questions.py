"""Kinds of questions: what all of them pass, and that nobody else keeps a list of them."""

from __future__ import annotations

import ast
import json
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest

import freebody as fb
import freebody.questions
from freebody.questions.base import Quantity
from freebody.questions.forms import FORMS
from freebody.testing.questions import QUESTION_CHECKS, check_question
from test_docs import CONTRIBUTING, blocks


@pytest.mark.parametrize("kind", sorted(Quantity.kinds))
@pytest.mark.parametrize("check", QUESTION_CHECKS)
def test_question(check: str, kind: str) -> None:
    QUESTION_CHECKS[check](kind)


# -- a kind of one's own ----------------------------------------------------------------------
@pytest.fixture
def closing_speed(tmp_path: Path) -> Iterator[str]:
    """The kind of question that CONTRIBUTING.md adds, from a folder that stands beside the package's own."""
    _connection, code = blocks(CONTRIBUTING, "python")
    (tmp_path / "closing_speed.py").write_text(code, encoding="utf-8")
    forms = list(FORMS)
    freebody.questions.__path__.append(str(tmp_path))
    try:
        import_module("freebody.questions.closing_speed")
        yield "closing speed"
    finally:
        freebody.questions.__path__.remove(str(tmp_path))
        sys.modules.pop("freebody.questions.closing_speed", None)
        Quantity.kinds.pop("closing speed", None)
        FORMS[:] = forms


def test_the_question_of_contributing_works_everywhere_as_written(closing_speed: str, tmp_path: Path) -> None:
    check_question(closing_speed)
    # r = (3, 4) m and v = (1, 0) m/s: the distance grows with r.v/|r| = 3/5 m/s
    system = fb.System.from_text(Quantity.kinds[closing_speed].example)
    answer = system.solve()["it"]
    assert answer.value == pytest.approx(-0.6)
    assert answer.unit == "m/s"
    assert json.loads(json.dumps(answer.to_plain()))["value"] == pytest.approx(-0.6)
    german = system.explain(language="de")
    assert german.is_complete
    assert "closing speed of ground.origin and ball" in german.to_text().lower()
    (page,) = german.write(tmp_path / "page.html")
    assert page.is_file()
    # a ratio, and an event: what is made of quantities takes it as any other
    assert system.solve("ratio of closing speed of ground.origin and ball to speed of ball at start")["q1"].value == (
        pytest.approx(-0.6)
    )
    with pytest.raises(fb.ModelError, match="Did you mean: closing speed of POINT and POINT"):
        system.solve("closing sped of ball and ball")


# -- no list of kinds -------------------------------------------------------------------------
QUANTITIES = {"q", "quantity"}  # what quantities are called
# Assertions that tell the type checker what a scope or a flag of the quantity means: the one kind that has it
ASSERTED = {
    "narrative/questions/along_rods.py": 1,
    "narrative/questions/conserving.py": 1,
    "narrative/questions/extent.py": 1,
    "narrative/questions/greatest_section.py": 1,
    "narrative/questions/jump.py": 1,
    "narrative/questions/section.py": 1,
    "narrative/questions/whether.py": 1,
    "study/answering/about_rest.py": 2,
    "study/answering/extremes_until.py": 1,
    "study/answering/frequency_in_names.py": 2,
    "study/answering/functions_along_rods.py": 1,
    "study/conservation/judge.py": 1,
    "study/friction/answers.py": 1,
    "study/phases/turned_round.py": 1,
    "study/phases/whether.py": 1,
    "study/small_motion/numbers.py": 1,
    "study/small_motion/shapes.py": 1,
    "study/steady/of_sizes.py": 1,
}


def names_in(node: ast.AST) -> set[str]:
    return {
        n.id if isinstance(n, ast.Name) else n.attr for n in ast.walk(node) if isinstance(n, (ast.Name, ast.Attribute))
    }


def n_tests_on_kinds(tree: ast.Module) -> int:
    """How often a module asks what kind a question is: by isinstance, by a class pattern, by the type, by a table of
    classes, or by the name of the kind."""
    kinds = {cls.__name__ for cls in Quantity.kinds.values()}
    known = {
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and str(node.module).startswith("freebody.questions.")
        for alias in node.names
        if alias.name in kinds
    }
    for node in ast.walk(tree):  # a tuple of kinds under a name
        if (
            isinstance(node, ast.Assign)
            and isinstance(node.value, (ast.Tuple, ast.BinOp))
            and names_in(node.value) & known
        ):
            known |= {t.id for t in node.targets if isinstance(t, ast.Name)}

    def asks(node: ast.AST) -> bool:
        if (
            isinstance(node, ast.Call)
            and isinstance(node.func, ast.Name)
            and node.func.id in ("isinstance", "issubclass")
        ):
            return bool(names_in(node.args[1]) & known)
        if isinstance(node, ast.MatchClass):
            return bool(names_in(node.cls) & known)
        if isinstance(node, ast.Dict):
            return any(names_in(key) & known for key in node.keys if key is not None and not isinstance(key, ast.Call))
        if isinstance(node, ast.Compare):
            sides = (node.left, *node.comparators)
            if any(isinstance(s, ast.Attribute) and s.attr == "kind" and names_in(s) & QUANTITIES for s in sides):
                return True
            return any(isinstance(s, ast.Name) and s.id in known for s in sides)
        return False

    return sum(map(asks, ast.walk(tree)))


def test_only_the_room_of_questions_knows_their_kinds() -> None:
    root = Path(fb.__file__).parent
    found: dict[str, int] = {}
    for path in sorted(root.rglob("*.py")):
        place = path.relative_to(root).as_posix()
        n = 0 if place.startswith("questions/") else n_tests_on_kinds(ast.parse(path.read_text(encoding="utf-8")))
        if n:
            found[place] = n
    assert found == ASSERTED


def test_the_count_sees_every_way_to_test_on_a_kind() -> None:
    source = """
from freebody.questions.energy import Energy as E
from freebody.questions.course import When
BOTH = (E, When)
def f(q):
    if isinstance(q, E) or isinstance(q, BOTH) or type(q) is When or q.kind == "energy":
        return {E: 1}[type(q)]
    match q:
        case When():
            return 2
"""
    assert n_tests_on_kinds(ast.parse(source)) == 6


def test_what_can_be_asked_is_listed_once_and_a_rate_is_a_velocity() -> None:
    text = """
bodies: {p: {particle: {mass: 1 kg}}}
measures: {x: x of p}
questions: [how nice is it, what is up]
"""
    with pytest.raises(fb.ModelError) as told:
        fb.System.from_text(text)
    first, second = (problem.message for problem in told.value.problems)
    assert "One can ask for\n" in first
    assert second == "cannot read 'what is up'"
    system = fb.System.from_text(text.partition("questions")[0])
    rate, velocity = system.asked("rate(x)", "velocity of x")
    assert rate.quantity == velocity.quantity


@pytest.mark.parametrize(
    ("question", "told"),
    [
        ("normal force of pull", "pull is a load; ask for: force in pull"),
        ("force in pul", "there is no load pul. Did you mean pull?"),
    ],
)
def test_who_asks_a_load_for_a_reaction_or_a_connection_for_its_force_is_told_how(question: str, told: str) -> None:
    text = f"""
bodies: {{rod: {{rod: {{mass: 1 kg, length: 1 m}}}}}}
connections:
  axle: {{pin: [ground.O, rod.start]}}
  motor: {{driver: {{measure: angle of rod, follows: 2 rad/s*t}}}}
loads: {{pull: {{spring: {{first: ground.O, second: rod.end, stiffness: 1 N/m}}}}}}
questions: ['{question}']
"""
    with pytest.raises(fb.ModelError) as error:
        fb.System.from_text(text)
    assert told in str(error.value)


@pytest.mark.parametrize(
    ("question", "value"),
    [
        ("force of weight on block along ramp", -9.81),  # 2 kg, sin 30 deg, down a line that leads up
        ("horizontal force of weight", 0.0),
        ("vertical force of weight", -19.62),
        ("size of force of weight", 19.62),
        ("force of weight on block", (0.0, -19.62)),
        ("force of push along right", 3 * 0.75**0.5),
        ("y component of force of push", 1.5),
    ],
)
def test_the_force_of_a_load_has_the_direction_that_is_asked_for(question: str, value: float) -> None:
    system = fb.System.from_text("""
parameters: {m: 2 kg, F: 3 N, g: 9.81 m/s^2}
ground: {lines: {ramp: {along: 30 deg}}}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: ramp}}}
loads: {weight: {gravity: g}, push: {force: {at: block, along: 30 deg, magnitude: F}}}
""")
    assert system.solve(question).answers[0].value == pytest.approx(value)


def test_a_component_is_told_where_only_the_other_is_not_unique() -> None:
    # a beam on two pins: along it the reactions are open, across it each carries half of the weight
    system = fb.System.from_text("""
parameters: {m: 10 kg, L: 2 m, g: 9.81 m/s^2}
ground: {points: {P: [0, 0], Q: [L, 0]}}
bodies: {beam: {rod: {mass: m, length: L}, at: {start: [0, 0]}}}
connections: {A: {pin: [ground.P, beam.start]}, B: {pin: [ground.Q, beam.end]}}
loads: {weight: {gravity: g}}
""")
    assert system.solve("vertical reaction of A").answers[0].value == pytest.approx(49.05)
    assert system.solve("reaction of B along up").answers[0].value == pytest.approx(49.05)
    assert "A.x is not unique" in system.solve("horizontal reaction of A").answers[0].reason


def test_a_body_that_only_turns_is_said_to_have_no_speed() -> None:
    system = fb.System.from_text("""
bodies: {sun: {disk: {mass: 1 kg, radius: 0.1 m}}}
connections: {axle: {pin: [ground.O, sun]}}
loads: {drive: {torque: {on: sun, magnitude: 3 N m}}}
""")
    answer = system.solve("speed of sun").answers[0]
    assert answer.value == 0.0
    assert answer.notes == ("its mass centre stands still: ask for the angular velocity of sun",)
