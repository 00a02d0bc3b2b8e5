"""Questions asked in the terminal."""

from __future__ import annotations

import io
import json
from pathlib import Path
from unittest.mock import patch

import pytest

import freebody as fb
from command import Done, freebody
from freebody.narrative.marking.quiz import quiz

EXAMPLES = Path(__file__).parents[1] / "examples"
YO_YO = str(EXAMPLES / "yo_yo.yaml")


def played(typed: str, *options: str) -> Done:
    with patch("sys.stdin", io.StringIO(typed)):
        return freebody("quiz", YO_YO, "--question", "acceleration", *options)


def test_a_right_answer_ends_the_question_and_all_right_ends_with_0() -> None:
    done = played("2g/3\n")
    assert done.returncode == 0
    assert "Correct." in done.stdout
    assert "1 of 1 solved." in done.stdout


def test_wrong_answers_cost_attempts_and_name_the_mistake_without_giving_the_answer_away() -> None:
    done = played("g\ng/2\n", "--attempts", "2")
    assert done.returncode == 1
    before, _words, after = done.stdout.partition("The answer:")
    assert "moment of inertia of yoyo is forgotten" in before
    assert "6.54" not in before
    assert "3/2 times" not in before
    assert "Attempts left: 1" in before
    assert "6.54" in after


def test_what_cannot_be_read_costs_no_attempt_and_everything_is_logged(tmp_path: Path) -> None:
    log = tmp_path / "log.jsonl"
    done = played("2g/3 +\n?\n2g/3\n", "--attempts", "1", "--log", str(log))
    assert done.returncode == 0
    entries = [json.loads(line) for line in log.read_text("utf-8").splitlines()]
    assert [entry["verdict"] for entry in entries] == ["unreadable", "correct"]
    assert [entry["hints"] for entry in entries] == [0, 1]


def test_options_are_shown_and_chosen_by_their_letter() -> None:
    done = played("c\n(b)\n")
    assert "(a) g\n(b) 2·g/3\n(c) g/2\n(d) g/3\n" in done.stdout
    wrong, _left, right = done.stdout.partition("Attempts left: 2")
    assert "is 3/4 times the answer" in wrong
    assert "This results if" in wrong
    assert "Correct." in right
    assert done.returncode == 0


def test_the_right_option_is_told_when_the_attempts_are_used_up() -> None:
    done = played("a\n", "--attempts", "1", "--language", "de")
    _before, _words, after = done.stdout.partition("Die Antwort:")
    assert "(b) 2·g/3" in after
    assert "gültig      für alle positiven Parameter" in after


def test_a_letter_that_is_a_quantity_too_chooses_the_option_in_brackets_or_where_it_is_no_answer() -> None:
    """The roller's body has its mass centre at the distance d, and option d is right."""
    roller = fb.System.load(EXAMPLES / "body_on_driven_roller.yaml")
    for text in ("(d)", "d", "D"):
        assert roller.check("conserved", text).verdict == "correct"
    assert roller.check("equation", "d").verdict == "incorrect"  # a length: this question has no options
    assert roller.check("conserved", "(b)", language="de").reason.startswith("weder hinreichend noch notwendig")
    assert roller.check("conserved", "f").verdict == "unreadable"


def test_a_wrong_number_of_freedoms_by_its_letter_names_the_miscount() -> None:
    platform = fb.System.load(EXAMPLES / "multi_bar_platform.yaml")
    found = platform.check("q1", "a")
    assert found.verdict == "incorrect"
    assert "spring" in found.mistake
    assert platform.check("q1", "b)").verdict == "correct"


def test_a_wrong_unit_is_told_in_the_quiz_since_it_gives_nothing_away() -> None:
    assert "has the unit m^2/s^4, the answer has m/s^2" in " ".join(played("g^2\n").stdout.split())


def test_the_end_of_the_input_ends_the_quiz() -> None:
    assert played("").returncode == 1


def test_german_quiz() -> None:
    done = played("weiter\n", "--language", "de")
    assert "0 von 1 gelöst." in done.stdout
    assert "Die Antwort:" in done.stdout


def test_a_quiz_without_questions_or_attempts_is_refused() -> None:
    with pytest.raises(fb.InputError, match="no question"):
        quiz([fb.System.load(YO_YO)], ["nothing"])
    with pytest.raises(fb.InputError, match="one attempt"):
        quiz([fb.System.load(YO_YO)], attempts=0)
    assert freebody("quiz", YO_YO, "--attempts", "0").returncode == 2
