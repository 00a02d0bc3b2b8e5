"""The command line as its users meet it: what it prints, its exit codes, its messages."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import jsonschema
import pytest
from ruamel.yaml import YAML
from typer.testing import CliRunner

import freebody as fb
from command import Done, freebody
from freebody.cli import commands

Within = Callable[[int, Callable[[], object]], None]

ROOT = Path(__file__).parents[1]
EXAMPLES = sorted((ROOT / "examples").glob("*.yaml"))


def program(*arguments: str, cwd: Path = ROOT) -> subprocess.CompletedProcess[str]:
    """In a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "freebody.cli", *arguments], cwd=cwd, capture_output=True, text=True, check=False
    )


def solved(tmp_path: Path, text: str) -> Done:
    (tmp_path / "model.yaml").write_text(text, encoding="utf-8")
    return freebody("solve", "model.yaml", cwd=tmp_path)


def test_a_process_of_its_own_says_the_same() -> None:
    for arguments in (["solve", "examples/four_bar.yaml"], ["solve", "examples/four_baa.yaml"]):
        there, here = program(*arguments), freebody(*arguments)
        assert (there.returncode, there.stdout, there.stderr) == (here.returncode, here.stdout, here.stderr)


def test_json_document_has_the_documented_content() -> None:
    done = program("solve", "examples/atwood_machine.yaml", "--json")
    assert done.returncode == 0
    document = json.loads(done.stdout)
    assert document["title"] == "Atwood machine with a massive pulley"
    assert document["degrees_of_freedom"] == 1
    assert document["coordinates"] == ["x1"]
    answers = {a["id"]: a for a in document["answers"]}
    m1, m2, M, g = 3.0, 2.0, 1.0, 9.81
    # Newton for both masses and the pulley: (m1 + m2 + M/2) a = (m1 - m2) g
    assert answers["acceleration"]["value"] == pytest.approx((m1 - m2) * g / (m1 + m2 + M / 2))
    assert [answers[k]["choice"] for k in ("acceleration", "tension", "energy")] == ["a", "e", "c"]
    wrong = [v for a in answers.values() for k, v in a["options"].items() if k != a["choice"]]
    assert len(wrong) == 12
    assert all(v["verdict"] == "wrong" and v["reason"] for v in wrong)
    assert answers["tension"]["unit"] == "N"
    assert [c["text"] for c in answers["tension"]["conditions"]] == ["for all positive parameters"]
    assert answers["tension"]["evidence"]["draws"] >= 5
    assert answers["tension"]["evidence"]["worst_relative_difference"] < 1e-9


def test_a_question_without_closed_form_exits_with_one_and_says_why(tmp_path: Path) -> None:
    model = (ROOT / "examples" / "four_bar.yaml").read_text(encoding="utf-8")
    (tmp_path / "p.yaml").write_text(model, encoding="utf-8")
    done = freebody("solve", "p.yaml", "--find", "time when theta = 90 deg", cwd=tmp_path)
    assert done.returncode == 1
    assert "no closed form" in done.stdout
    assert "by numbers" in done.stdout


def test_all_mistakes_of_a_file_come_in_one_message(tmp_path: Path) -> None:
    done = solved(
        tmp_path,
        """\
titl: typo
parameters: {m1: 3 kgg, m2: -2 kg, R: 0.1 m, g: 9.81 m/s^2}
bodies:
  pulley: {dsk: {radius: R}}
  left: {particle: {mas: m1}}
  right: {particle: {mass: R}}
connections:
  axle: {pin: [ground.axle, puley.center]}
  rope: {strng: {from: left, over: [pulley], to: right}}
loads: {weight: {gravity: m2}}
measures: {x1: dropp of left}
questions: [{find: aceleration of left}, {find: tension of rop}]
""",
    )
    assert done.returncode == 2
    assert done.stdout == ""
    for expected in (
        "model.yaml:1:7: titl: there is no section titl. Did you mean title?",
        "kgg",
        "a mass is never negative, m2 = -2 kg is",
        "Did you mean disk?",
        "Did you mean mass?",
        "R must be a mass (kg), but is given in m",
        "there is no body puley. Did you mean pulley?",
        "Did you mean string?",
        "must be an acceleration (m/s^2)",
        "Did you mean: drop of left",
        "there is no connection rop",
    ):
        assert expected in done.stderr, expected
    assert all(line.startswith("model.yaml:") for line in done.stderr.strip().splitlines())


@pytest.mark.parametrize(
    ("model", "message"),
    [
        (
            "ground: {points: {A: [0, 0], B: [3 m, 0]}}\nbodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}\n"
            "connections: {a: {pin: [ground.A, rod.start]}, b: {pin: [ground.B, rod.end]}}\n",
            "all that goes from one end of it to the other is rod (1 m). It closes only where 3 m <= 1 m",
        ),
        (
            "bodies: {a: {particle: {mass: 1 kg}}, b: {particle: {mass: 1 kg}}, w: {disk: {radius: 1 m}, fixed: true}}"
            "\n"
            "connections: {rope: {string: {from: a, over: [w], to: b, grips: [w]}}}\n",
            "w is fixed and cannot turn",
        ),
        ("bodies: {a: {particle: {mass: m + L}}}\nparameters: {m: 1 kg, L: 1 m}\n", "unlike units cannot be added"),
        ("bodies: {a: {particle: {mass: M + 2 N}}}\nparameters: {M: 1 kg}\n", "'2 N' in 'M + 2 N': a value with"),
        ("bodies: {a: {particle: {mass: 0.5 m*sqrt(2)}}}\n", "a value with its unit does not fit here"),
        ("bodies: {a: {particle: {mass: 0.5 kg/zz}}}\n", "the unit 'zz' is not known"),
        ("parameters: {a: &x 1 m, b: *x}\nbodies: {p: {particle: {}}}\n", "write it out twice"),
        ("parameters: {a: .nan}\nbodies: {p: {particle: {}}}\n", "not a finite number"),
        ("parameters: {a: 1 m, a: 2 m}\nbodies: {p: {particle: {}}}\n", "a"),
        ("bodies: {p: {particle: {mass: \"__import__('os')\"}}}\n", "column"),
        ("bodies: {p: {particle: {mass: 9**9**9}}}\n", "exponent"),
        ("bodies: {p: {particle: {mass: " + "(" * 100_000 + "1}}}\n", "at most 10000"),
        ("", "empty"),
        ("bodies: [1, 2\n", "not closed"),
    ],
)
def test_a_bad_file_is_refused_with_the_reason(tmp_path: Path, model: str, message: str) -> None:
    done = solved(tmp_path, model)
    assert done.returncode == 2
    assert message in done.stderr
    assert "Traceback" not in done.stderr


def test_a_missing_file_is_named_with_the_nearest_one(tmp_path: Path) -> None:
    (tmp_path / "model.yaml").write_text("", encoding="utf-8")
    done = freebody("solve", "modle.yaml", cwd=tmp_path)
    assert done.returncode == 2
    assert "Did you mean model.yaml?" in done.stderr


def test_a_file_in_the_place_of_a_command_is_solved(tmp_path: Path) -> None:
    asked = ["examples/atwood_machine.yaml", "--find", "acceleration of x1", "--json"]
    alone, named = freebody(*asked), freebody("solve", *asked)
    assert alone.returncode == named.returncode == 0, alone.stderr
    assert json.loads(alone.stdout)["answers"] == json.loads(named.stdout)["answers"]
    missing = freebody("nothing.yaml", cwd=tmp_path)
    assert missing.returncode == 2
    assert "there is no such file" in missing.stderr
    assert "Did you mean 'solve'" in freebody("slove", "nothing.yaml", cwd=tmp_path).stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["help"], "Commands:"),
        (["help", "solve"], "Answer the questions of a model in closed form."),
        (["-h"], "Commands:"),
        (["solve", "-h"], "Answer the questions of a model in closed form."),
        (["help", "slove"], "No such command 'slove'. Did you mean 'solve'?"),
        (["sim", "a.yaml"], "Did you mean 'simulate'?"),
        (["run", "a.yaml"], "Did you mean 'simulate'?"),
        (["optimize"], "Did you mean 'optimise'?"),
        (["atwood_machine"], "It is an example: 'freebody examples atwood_machine' writes it here."),
        (["xyzzy"], "'freebody help' lists the commands."),
    ],
)
def test_help_is_given_in_every_way_that_it_is_asked_for(words: list[str], said: str) -> None:
    done = CliRunner().invoke(commands(), words)
    assert said in done.output
    assert done.exit_code == (2 if "'" in said else 0)


def test_new_writes_a_model_that_solves_and_never_overwrites(tmp_path: Path) -> None:
    assert freebody("new", "first.yaml", cwd=tmp_path).returncode == 0
    done = freebody("solve", "first.yaml", cwd=tmp_path)
    assert done.returncode == 0
    assert "F" in done.stdout
    again = freebody("new", "first.yaml", cwd=tmp_path)
    assert again.returncode == 2
    assert "exists already" in again.stderr


def test_examples_are_listed_and_copied(tmp_path: Path) -> None:
    listed = freebody("examples").stdout
    assert all(path.stem in listed for path in EXAMPLES)
    assert len(EXAMPLES) >= 16
    assert freebody("examples", "yo_yo", cwd=tmp_path).returncode == 0
    assert (tmp_path / "yo_yo.yaml").read_text(encoding="utf-8") == (ROOT / "examples/yo_yo.yaml").read_text(
        encoding="utf-8"
    )
    assert "Did you mean yo_yo?" in freebody("examples", "yoyo", cwd=tmp_path).stderr


def test_what_an_example_names_goes_with_it(tmp_path: Path) -> None:
    """Tables of points and files of triangles: copied, and to begin with; what is there already stays."""
    table, model = "surveyed_track.csv", "car_on_a_surveyed_track.yaml"
    said = freebody("examples", "car_on_a_surveyed_track", cwd=tmp_path).stdout
    assert said.split() == ["wrote", model, "wrote", table]
    assert (tmp_path / table).read_bytes() == (ROOT / "examples" / table).read_bytes()
    (tmp_path / table).write_text("x [m], y [m]\n0, 1\n1, 0\n", encoding="utf-8")
    own = (tmp_path / table).read_bytes()
    said = freebody("new", "own.yaml", "--like", "car-on-a-surveyed-track", cwd=tmp_path).stdout
    assert table not in said
    assert (tmp_path / table).read_bytes() == own
    (tmp_path / "all").mkdir()
    said = freebody("examples", "--all", "--to", "all", cwd=tmp_path).stdout
    assert {path.name for path in (tmp_path / "all").iterdir()} == {
        path.name for path in (ROOT / "examples").iterdir() if path.suffix != ".md"
    }


def test_schema_accepts_every_example_and_refuses_a_typo() -> None:
    schema = json.loads(freebody("schema").stdout)
    validator = jsonschema.Draft202012Validator(schema)
    for path in EXAMPLES:
        data = json.loads(json.dumps(YAML(typ="safe").load(path.read_text(encoding="utf-8"))))
        assert list(validator.iter_errors(data)) == [], path.name
    assert list(validator.iter_errors({"bodies": {}, "conections": {}}))


@pytest.mark.parametrize("form", [[], ["--latex"], ["--json"]])
def test_equations_of_motion_come_as_text_latex_and_json(form: list[str]) -> None:
    done = freebody("eom", "examples/cart_and_pendulum.yaml", *form)
    assert done.returncode == 0
    if form == ["--json"]:
        document = json.loads(done.stdout)
        # textbook: (M + m) x'' + m L/2 cos(theta) theta'' - m L/2 theta'^2 sin(theta) = F
        assert document["mass_matrix"][0][0] == "M + m"
        assert document["coordinates"] == ["x", "theta"]
    else:
        assert "theta" in done.stdout or "θ" in done.stdout


def test_help_loads_nothing_heavy() -> None:
    code = "import sys; from freebody.cli import commands; commands()(['--help'], standalone_mode=False)\n"
    code += "print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "solve" in run.stdout
    loaded = {name.partition(".")[0] for name in run.stdout.splitlines()[-1].split()}
    assert not loaded & {"numpy", "scipy", "numba", "pydantic", "pint", "matplotlib", "xarray", "flint"}


def test_a_file_and_python_make_the_same_system() -> None:
    text = """
parameters: {m: 1 kg, R: 0.2 m, g: 9.81 m/s^2}
bodies: {yoyo: {disk: {mass: m, radius: R}}}
connections: {cord: {string: {from: ground.hand, to: wound on yoyo at right}}}
loads: {weight: {gravity: g}}
questions: [tension of cord]
"""
    data = {
        "parameters": {"m": "1 kg", "R": "0.2 m", "g": "9.81 m/s^2"},
        "bodies": {"yoyo": fb.Disk("m", "R")},
        "connections": {"cord": fb.String(**{"from": "ground.hand", "to": "wound on yoyo at right"})},
        "loads": {"weight": fb.Gravity("g")},
        "questions": ["tension of cord"],
    }
    written, built = fb.System.from_text(text), fb.System.from_data(data)
    assert written == built
    assert fb.solve(built)["q1"].to_plain()["expression"] == "m*g/3"


def test_new_values_keep_the_comments_of_the_file() -> None:
    text = "# my model\nparameters: {m: 1 kg}  # the mass\nbodies: {p: {particle: {mass: m}}}\n"
    system = fb.System.from_text(text)
    assert system.to_yaml() == text
    heavier = system.with_parameters(m="2 kg")
    assert heavier.to_yaml() == text.replace("1 kg", "2 kg")
    assert system.parameters["m"].value == 1.0
    with pytest.raises(fb.InputError, match="Did you mean"):
        system.with_parameters(mm=3)


# -- simulate, equilibrium, modes -------------------------------------------------------------
def test_simulate_prints_one_json_document_and_writes_what_is_asked(tmp_path: Path) -> None:
    paths = [tmp_path / name for name in ("run.nc", "run.png", "run.html")]
    options = ["--out", str(paths[0]), "--plot", str(paths[1]), "--show", "theta", "--animate", str(paths[2])]
    done = program("simulate", str(ROOT / "examples" / "simple_pendulum.yaml"), "--until", "500 ms", "--json", *options)
    assert done.returncode == 0, done.stderr
    document = json.loads(done.stdout)
    assert document["status"] == "finished"
    assert document["t_end"] == 0.5
    assert all(path.stat().st_size > 1000 for path in paths)
    assert not re.search(r"(?:src|href|import|fetch)\W{1,3}https?:", paths[2].read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--until", "0"], "positive time"),
        (["--until", "3 kg"], "no time"),
        (["--until", "1", "--out", "/nowhere/run.nc"], "no folder"),
        (["--until", "1", "--set", "q=3"], "no parameter q"),
        (["--until", "1", "--event", "thta = 0"], "Did you mean theta"),
        (["--until", "1", "--plot", "run.png", "--show", "rod.tensoin"], "Did you mean rod.tension"),
    ],
)
def test_simulate_refuses_arguments_without_sense(options: list[str], message: str) -> None:
    done = freebody("simulate", str(ROOT / "examples" / "simple_pendulum.yaml"), *options)
    assert done.returncode == 2
    assert message in done.stderr
    assert "Traceback" not in done.stderr


def test_a_motion_that_cannot_go_on_exits_with_1_and_says_why(tmp_path: Path) -> None:
    path = tmp_path / "law.yaml"
    path.write_text(
        "parameters: {k: 50 N/m, L: 1 m}\n"
        "bodies: {block: {particle: {mass: 2 kg}, at: [0.3 m, 0]}}\n"
        "loads: {s: {law: {measure: x, force: -k*L*sqrt(x/L)}}}\nmeasures: {x: x of block}\n",
        encoding="utf-8",
    )
    done = freebody("simulate", str(path), "--until", "2")
    assert done.returncode == 1
    assert "s has no finite value" in done.stdout


def test_what_is_wrong_is_told_in_the_language_of_the_command(tmp_path: Path) -> None:
    path = tmp_path / "wrong.yaml"
    path.write_text("bodies: {a: {particle: {mass: 1 kg}}}\nquestions: [tension of c]\n")
    done = freebody("explain", str(path), "--language", "de")
    assert done.returncode == 2
    assert "es gibt keine Verbindung c" in done.stderr
    assert "there is no connection c" in freebody("explain", str(path)).stderr
    assert "there are no words for the language xx" in freebody("explain", str(EXAMPLES[0]), "--language", "xx").stderr


def test_of_several_kinds_that_a_name_begins_none_is_preferred() -> None:
    """gear in space is gear_mesh or gear_pair: naming one of them only would mislead. In the plane there is one."""
    text = "bodies: {a: {disk: {mass: 1, radius: 1}}}\nconnections: {g: {gear: [a, ground]}}"
    with pytest.raises(fb.ModelError, match="Did you mean one of gear_mesh, gear_pair"):
        fb.System.from_text(f"space: true\n{text}")
    two = "bodies: {a: {disk: {radius: 1 m}}, b: {disk: {radius: 1 m}}}\nconnections: {g: {gear: [a, b]}}"
    assert fb.System.from_text(two).connections["g"].kind == "gear_mesh"


PUSHED = """
freebody: 1
parameters: {m: 2 kg, mu: 0.25, F: 10 N}
bodies: {block: {particle: {mass: m}}}
loads: {push: {force: {at: block, along: right, magnitude: F}}}
measures: {x: x of block}
start: {x: 0, rate(x): 0}
"""


def test_all_questions_of_a_command_line_are_answered_in_their_order(tmp_path: Path) -> None:
    (tmp_path / "pushed.yaml").write_text(PUSHED)
    asked = ["acceleration of x", "time until x = 10 m"]
    found = freebody("solve", "pushed.yaml", "--find", asked[0], "--find", asked[1], "--json", cwd=tmp_path)
    answers = json.loads(found.stdout)["answers"]
    assert [a["question"] for a in answers] == asked
    assert [a["value"] for a in answers] == pytest.approx([5.0, 2.0])  # F/m, and sqrt(2 x/(F/m))
    derived = freebody("explain", "pushed.yaml", "--find", asked[0], "--find", asked[1], "--json", cwd=tmp_path)
    assert [d["reason"] for d in json.loads(derived.stdout)["derivations"]] == [None, None]


def test_a_mistake_in_one_of_several_questions_is_told_of_that_one(tmp_path: Path) -> None:
    (tmp_path / "pushed.yaml").write_text(PUSHED)
    done = freebody("solve", "pushed.yaml", "--find", "acceleration of x", "--find", "acceleration of z", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stderr.endswith("z is no measure, body or point. There is: block, ground, x.\n")


def test_a_parameter_in_a_question_of_the_command_line_is_used(tmp_path: Path) -> None:
    (tmp_path / "pushed.yaml").write_text(PUSHED)
    asked = ["solve", "pushed.yaml", "--json", "--find", "acceleration of x"]
    other = freebody(*asked, cwd=tmp_path)
    assert [w["kind"] for w in json.loads(other.stdout)["warnings"]] == ["unused"]
    assert "mu is used nowhere" in other.stderr
    done = freebody(*asked, "--find", "mu*m*(acceleration of x)", cwd=tmp_path)
    assert "warnings" not in json.loads(done.stdout)
    assert not done.stderr
    assert json.loads(done.stdout)["answers"][1]["value"] == pytest.approx(2.5)  # mu F


def test_a_question_of_the_file_that_cannot_be_read_does_not_block_one_on_the_command_line(tmp_path: Path) -> None:
    model = """
parameters: {m: 1 kg, F: 2 N}
bodies: {a: {particle: {mass: m}}}
connections: {g: {slider: {body: a, along: right}}}
loads: {f: {force: {at: a, along: right, magnitude: F}}}
measures: {x: x of a}
questions: [colour of a, {id: fast, find: velocity of x when x = 1 m}]
"""
    assert solved(tmp_path, model).returncode == 2
    asked = freebody("solve", "model.yaml", "--find", "acceleration of x", cwd=tmp_path)
    assert asked.returncode == 0
    assert "2 m/s^2" in asked.stdout
    assert asked.stderr.startswith("warning: model.yaml:7:13: questions.0.find: 'colour' is nothing")
