"""What the author of options should know, and options that mistakes lead to."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

import freebody as fb
from command import freebody
from freebody.narrative.marking.authoring import AuthorsCheck, authors_check

EXAMPLES = Path(__file__).parents[1] / "examples"
YO_YO = (EXAMPLES / "yo_yo.yaml").read_text("utf-8")
OPTIONS = "{a: g, b: 2*g/3, c: g/2, d: g/3}, key: b"


@cache
def checked(options: str) -> AuthorsCheck:
    assert OPTIONS in YO_YO
    system = fb.System.from_text(YO_YO.replace(OPTIONS, options))
    return authors_check(system, system.questions[0])


@pytest.mark.parametrize(
    ("options", "fault"),
    [
        ("{a: g, b: g/2, c: g/3}, key: b", "no option is right"),
        ("{a: 2*g/3, b: g/1.5, c: g/3}, key: a", "two options are right"),
        ("{a: g, b: 2*g/3}, key: a", "the key says a"),
        ("{a: g, b: 2*g/3}", "no key is given"),
        ("{a: g/2, b: 2*g/3, c: 3*g/6}, key: b", "(a) and (c) are the same"),
        ("{a: m, b: 2*g/3, c: g*R, d: g}, key: b", "a and c can be excluded"),
    ],
)
def test_faults_of_options_are_told(options: str, fault: str) -> None:
    assert any(fault in told for told in checked(options).faults)


def test_sound_options_have_no_faults() -> None:
    assert checked(OPTIONS).faults == ()


def test_proposed_options_are_wrong_different_and_have_the_mistake_that_leads_to_them() -> None:
    found = checked(OPTIONS)
    system = found.system
    assert len(found.proposed) >= 3
    assert len({option.text for option in found.proposed}) == len(found.proposed)
    for option in found.proposed:
        judged = system.check("acceleration", option.text)
        assert judged.verdict != "correct"
        assert isinstance(judged.mistake, str)  # type: ignore[union-attr]
    assert system.check("acceleration", found.right).verdict == "correct"


def test_proposals_on_the_command_line() -> None:
    done = freebody("sheet", str(EXAMPLES / "yo_yo.yaml"), "--propose-options")
    assert done.returncode == 0
    assert "forgotten" in done.stdout
    assert freebody("sheet", str(EXAMPLES / "yo_yo.yaml")).returncode == 2
