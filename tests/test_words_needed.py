"""Words without which a pattern cannot match: they rule out no text that it matches."""

from __future__ import annotations

import re
import subprocess
import sys

import pytest
from tests.example_files import FOLDER

from freebody.questions.base import Quantity
from freebody.questions.forms import FORMS
from freebody.questions.needed import needed


@pytest.mark.parametrize(
    ("pattern", "words"),
    [
        ("speed of x", {"speed of x"}),
        ("speeds? of", {" of", "speed"}),
        ("(?:speed|velocity) of", {"speed", "velocity"}),
        ("(?:speed|velocity)? of", {" of"}),
        ("(?P<what>speed|x?)", set[str]()),
        ("a|b|c+d", {"a", "b", "c", "d"}),
        ("at rest(?: now)?", {"at rest"}),
        (r"turn\w+ (?!until )by", {" by", "turn"}),
        ("[Ii]s (?:ab|cd[ef]gh) it", {"s ", " it", "ab", "cd", "gh"}),
        ("ab{0,2}c", {"a", "c"}),
        ("(?:abc){2}", {"abc"}),
        (r"\(sum\) of", {"sum", " of"}),
        ("(?<!no )way", {"way"}),
        (r"(?P<a>x)?(?(a)long|other)", set[str]()),
    ],
)
def test_they_are_among_what_is_written(pattern: str, words: set[str]) -> None:
    assert needed(pattern) <= words
    assert not words or needed(pattern) or pattern in ("(?:abc){2}", "ab{0,2}c")


def asked_in_examples() -> list[str]:
    """The words of all questions of the examples and of the kinds, and parts of them."""
    models = [path.read_text(encoding="utf-8") for path in sorted(FOLDER.glob("*.yaml"))]
    models += [kind.example for kind in Quantity.kinds.values()] + [form.example for form in FORMS]
    found = {part for model in models for part in re.findall(r"(?:find|it|[\w]+): *[\"']?([^\"'{},\n#]+)", model)}
    whole = {part.strip() for part in found}
    return sorted(whole | {part for text in whole for part in re.split(r" (?:until|when|at|while) ", text)})


def test_no_form_is_ruled_out_that_reads_a_question() -> None:
    texts = asked_in_examples()
    n_read = 0
    for form in FORMS:
        read = [text for text in texts if form.pattern.match(text)]
        assert all(not form.needed or any(word in text for word in form.needed) for text in read), form.form
        n_read += bool(read)
    assert n_read > 0.9 * len(FORMS)


def test_a_question_compiles_few_patterns() -> None:
    """All of them take longer than the first picture needs for anything else but imports."""
    code = (
        "import sys, freebody as fb\n"
        "from freebody.questions.base import FORMS\n"
        "fb.System.load(sys.argv[1])\n"
        "print(len(FORMS) > 80, sum('pattern' in vars(form) for form in FORMS))\n"
    )
    command = [sys.executable, "-c", code, str(FOLDER / "atwood_machine.yaml")]
    is_table, n = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    assert is_table == "True"
    assert int(n) < 30
