"""The command line from day to day: templates, other values, runs on saving, completion, what is installed."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import freebody as fb
from command import freebody
from freebody.examples_folder import templates

BLOCK = """
parameters: {m: 2 kg, F: 10 N}
bodies: {block: {particle: {mass: m}}}
connections: {table: {slider: {body: block, along: right}}}
loads: {pull: {force: {at: block, along: right, magnitude: F}}}
measures: {x: x of block}
start: {x: 0, rate(x): 0}
questions: [acceleration of x]
"""


@pytest.mark.parametrize("name", sorted(templates()))
def test_every_question_of_a_template_has_an_answer(name: str) -> None:
    text = templates()[name].read_text("utf-8")
    assert "# " in text  # they say what stands where
    for answer in fb.System.from_text(text).solve().answers:
        assert answer.value is not None or answer.expression is not None, answer.reason


def test_there_are_templates_for_a_course() -> None:
    assert len(templates()) >= 20


def test_a_new_model_is_like_a_template_or_an_example(tmp_path: Path) -> None:
    assert freebody("new", "a.yaml", "--like", "ladder", cwd=tmp_path).returncode == 0
    assert (tmp_path / "a.yaml").read_text("utf-8") == templates()["ladder"].read_text("utf-8")
    assert freebody("new", "b.yaml", "--like", "capstan", cwd=tmp_path).returncode == 0
    lost = freebody("new", "c.yaml", "--like", "lader", cwd=tmp_path)
    assert lost.returncode == 2
    assert "Did you mean ladder?" in lost.stderr
    assert "ladder" in freebody("new").stdout


@pytest.mark.parametrize(
    "command",
    [
        ("solve",),
        ("explain",),
        ("eom",),
        ("equilibrium",),
        ("mobility",),
        ("conserved",),
        ("phases",),
        ("draw", "-o", "x.svg"),
        ("sheet", "-o", "x.html"),
        ("simulate", "--until", "0.1"),
    ],
    ids=lambda command: command[0],
)
def test_every_command_takes_other_values(command: tuple[str, ...], tmp_path: Path) -> None:
    (tmp_path / "block.yaml").write_text(BLOCK, "utf-8")
    name, *rest = command
    done = freebody(name, "block.yaml", "--set", "m=5kg", *rest, cwd=tmp_path)
    assert done.returncode in (0, 1), done.stderr
    assert "no parameter" not in done.stderr
    wrong = freebody(name, "block.yaml", "--set", "q=5kg", *rest, cwd=tmp_path)
    assert wrong.returncode == 2
    assert "parameter q" in wrong.stderr


def test_another_value_is_the_one_that_is_shown(tmp_path: Path) -> None:
    (tmp_path / "block.yaml").write_text(BLOCK, "utf-8")
    done = freebody("solve", "block.yaml", "--set", "F=30 N", "--set", "m=3 kg", cwd=tmp_path)
    assert "value       10 m/s^2" in done.stdout


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_a_watched_file_is_read_again_when_it_is_saved(tmp_path: Path) -> None:
    file = tmp_path / "block.yaml"
    file.write_text(BLOCK, "utf-8")
    command = [sys.executable, "-u", "-m", "freebody", "solve", str(file), "--watch"]
    listening = {
        "preexec_fn": lambda: signal.signal(signal.SIGINT, signal.default_int_handler)
    }  # background jobs do not
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **listening) as running:
        assert running.stdout is not None
        seen: list[str] = []

        def until(words: str) -> None:
            end = time.monotonic() + 60.0
            for line in running.stdout or ():
                seen.append(line)
                if words in line:
                    return
                assert time.monotonic() < end
            raise AssertionError("".join(seen))

        until("5 m/s^2")
        until("watching")
        file.write_text(BLOCK.replace("10 N", "10 kg"), "utf-8")
        until("F must be a force")
        until("watching")
        file.write_text(BLOCK.replace("10 N", "14 N"), "utf-8")
        until("7 m/s^2")
        running.send_signal(signal.SIGINT)
        running.wait(timeout=30)
    assert running.returncode == 130


@pytest.mark.parametrize(
    ("shell", "begins"),
    [("bash", "complete -o default -F"), ("zsh", "#compdef freebody"), ("fish", "complete --command freebody")],
)
def test_there_is_completion_for_shells(shell: str, begins: str) -> None:
    """What `--install-completion` puts there, whichever shell the tests are started from."""
    command = [sys.executable, "-c", "import sys; sys.argv = ['freebody']; from freebody.cli import main; main()"]
    asked = {**os.environ, "_FREEBODY_COMPLETE": f"source_{shell}"}
    done = subprocess.run(command, env=asked, capture_output=True, text=True, timeout=60, check=False)
    assert begins in done.stdout, done.stderr


def test_the_doctor_says_what_is_there_and_checks_an_answer() -> None:
    done = freebody("doctor")
    assert done.returncode == 0, done.stdout
    lines = dict(line.split(None, 1) for line in done.stdout.splitlines())
    assert lines["freebody"].startswith("0.")
    assert "kernels" in lines
    assert lines["check"] == "acceleration F/m = 5 m/s^2, right"


def test_a_question_that_cannot_be_read_stops_neither_the_others_nor_what_asks_nothing(tmp_path: Path) -> None:
    model = tmp_path / "model.yaml"
    model.write_text(BLOCK.replace("[acceleration of x]", "[acceleration of x, colour of block]"), encoding="utf-8")
    done = freebody("solve", str(model))
    assert done.returncode == 2
    assert "questions.1.find: 'colour' is" in done.stderr
    assert "warning" not in done.stderr
    assert "5 m/s^2" in done.stdout
    done = freebody("mobility", str(model))
    assert done.returncode == 0
    assert "warning: " in done.stderr
    model.write_text(BLOCK.replace("acceleration of x]", "colour of block]"), encoding="utf-8")
    done = freebody("solve", str(model))
    assert (done.returncode, done.stdout) == (2, "")
