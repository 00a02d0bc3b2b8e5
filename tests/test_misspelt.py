"""A misspelt word of a file is told once, by the word that is meant; nothing that follows from it is told beside it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import freebody as fb
from freebody.language.document import Document
from freebody.language.document.writer import flow_text
from thinned import thinned

ROOT = Path(__file__).parents[1]
FEW_LINES = re.findall(r"```yaml\n(.*?)```", (ROOT / "docs/howto/few_lines.md").read_text("utf-8"), re.DOTALL)
# further figures in a few lines
SHORT = (
    "nodes: {A: [0, 0], B: [4 m, 0], C: [2 m, 3 m]}\nmembers: {AB: [A, B], AC: [A, C], BC: [B, C]}\n"
    "supports: {A: pin, B: roller}\nloads: {P: {force: {at: C, along: down, magnitude: 10 kN}}}\n",
    "title: Pendulum\npendulum: {length: 1 m, mass: 2 kg, angle: 10 deg}\ngravity: 9.81 m/s^2\n",
    "beam: {length: 6 m}\nsupports: [{type: pin, at: 0}, {type: roller, at: 5 m}]\n"
    "loads: [{type: distributed, from: 0, to: 3 m, value: 2 kN/m}, {type: point, at: 6 m, value: 3 kN}]\n"
    "questions: [reaction at A]\n",
    "points: {A: [0, 0], B: [0, 1 m], C: [3 m, 2 m], D: [2 m, 0]}\n"
    "links: {crank: [A, B], coupler: [B, C], rocker: [C, D]}\nground: [A, D]\n",
    "planetary:\n  sun: {teeth: 24}\n  planet: {teeth: 24}\n  ring: {teeth: 72, fixed: true}\n"
    ""
    "  carrier: {mass: 1 kg}\n",
    "bevel_gears: {a: {teeth: 20, module: 3 mm}, b: {teeth: 40}}\n",
    "mass: 2 kg\nstiffness: 50 N/m\ndamping: 4 N s/m\nforce: 10 N*sin(3*t)\ninitial_displacement: 0.1 m\n",
)
FILES = {
    **{f"few lines {k}": text for k, text in enumerate(FEW_LINES)},
    **{f"short {k}": text for k, text in enumerate(SHORT)},
    **{path.stem: path.read_text("utf-8") for path in sorted((ROOT / "src/freebody/templates").glob("*.yaml"))},
}
KEPT = ("short 0", "short 1", "short 5")
# what holds names that somebody gives, or whose words are parts of formulas
NAMED = (
    *("bodies", "connections", "loads", "parameters", "measures", "start", "states", "nodes", "members", "links"),
    *("points", "lines", "planes", "options", "gears", "bevel_gears", "four_bar", "planetary", "supports"),
)
FEWEST = 4  # letters


def _keys(value: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], str]]:
    """The words of a file with their places."""
    if isinstance(value, dict):
        for key, each in value.items():
            is_name = bool(place) and (place[-1] in NAMED or place[0] in ("questions", "measures", "parameters"))
            if not is_name and len(key) >= FEWEST and not (place == ("ground",) and key not in NAMED):
                yield place, key
            yield from _keys(each, (*place, key))
    elif isinstance(value, list):
        for k, each in enumerate(value):
            yield from _keys(each, (*place, k))


def _misspelt(word: str) -> str | None:
    """The word with two letters in its middle the wrong way round."""
    for k in range(max(1, len(word) // 2 - 1), len(word) - 1):
        if word[k] != word[k + 1] and word[k].isalpha() and word[k + 1].isalpha():
            return word[:k] + word[k + 1] + word[k] + word[k + 2 :]
    return None


def _with(data: Any, place: tuple[Any, ...], word: str, written: str) -> Any:
    if not place:
        return {written if key == word else key: each for key, each in data.items()}
    changed = _with(data[place[0]], place[1:], word, written)
    if isinstance(data, list):
        return [changed if k == place[0] else each for k, each in enumerate(data)]
    return {**data, place[0]: changed}


@pytest.mark.parametrize("name", thinned(FILES, KEPT.__contains__))
def test_a_misspelt_word_is_one_message_that_names_the_right_one(name: str) -> None:
    data = Document.read(FILES[name]).data
    fb.System.from_text(FILES[name])
    wrong: list[str] = []
    for place, word in _keys(data):
        if (written := _misspelt(word)) is None:
            continue
        try:
            fb.System.from_text(flow_text(_with(data, place, word, written)))
            told = ["it is read"]
        except fb.ModelError as error:
            told = [problem.text(None) for problem in error.problems]
        if len(told) != 1 or f" {word}" not in told[0]:
            wrong.append(f"{written}: {told}")
    assert not wrong, "\n".join(wrong)


def test_what_else_is_wrong_is_told_beside_it() -> None:
    text = "title: Truss\nnodes: {A: [0, 0], B: [4 m, 0]}\nmemebrs: {AB: [A, B]}\nsupports: {A: pin, B: roller}\n"
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(text + "loads: {P: {force: {at: B, along: down, magnitude: 10 kg}}}\n")
    told = [problem.message for problem in refused.value.problems]
    assert [problem.line for problem in refused.value.problems] == [3, 5]
    assert told[0] == "there is no section memebrs. Did you mean members?"
    assert "kg" in told[1]


def test_a_figure_that_is_misspelt_is_no_body() -> None:
    with pytest.raises(fb.ModelError, match=r"no penudlum\. Did you mean pendulum\?") as refused:
        fb.System.from_text("penudlum: {length: 1 m, mass: 2 kg, angle: 10 deg}\ngravity: 9.81 m/s^2\n")
    assert len(refused.value.problems) == 1


def test_what_no_word_is_near_to_is_told_where_it_stands() -> None:
    with pytest.raises(fb.ModelError, match="there is no section colour") as refused:
        fb.System.from_text("bodies: {b: {mass: 2 kg}}\ncolour: red\n")
    assert len(refused.value.problems) == 1


TRUSS = "nodes: {A: [0, 0], B: [4 m, 0], C: [2 m, 3 m]}\n"
# figures in a few lines with mistakes, and what is told of each, at its place
MISTAKES = {
    "a node that there is not": (
        TRUSS + "members: [AB, BC, AD]\nsupports: {A: pin, B: roller}\n",
        ["AD is no member between two of the nodes A, B, C"],
    ),
    "two supports that there are not": (
        TRUSS + "members: [AB, BC, AC]\nsupports: {A: bolt, B: wheel}\n",
        ["a truss has no support bolt: supports are pin and roller", "a truss has no support wheel"],
    ),
    "a load in kilograms": (
        "beam: {length: 6 m}\nsupports: {A: {pin: 0 m}, B: {roller: 6 m}}\nloads: [{P: 10 kg, x: 2 m}]\n",
        ["10 kg is no force (N), no load per length (N/m) and no couple (N m)"],
    ),
    "a support that says no place": (
        "beam: {length: 6 m}\nsupports: {A: pin, B: {roller: 6 m}}\n",
        ["say how it holds and where: A: {pin: 0 m}"],
    ),
    "a word that no load of a beam has": (
        "beam: {length: 6 m}\nsupports: {A: 0, B: 6 m}\nloads: [{P: 10 N, x: 2 m, colour: red}]\n",
        ["a load of a beam has no colour; it has type, value, at, from, to, direction"],
    ),
    "a length that is missing": (
        "four_bar: {crank: 40 mm, coupler: 120 mm, rocker: 80 mm}\n",
        ["a four-bar has four lengths: crank, coupler, rocker and ground; ground is missing"],
    ),
    "teeth that are missing": (
        "bevel_gears: {a: {teeth: 20, module: 3 mm}, b: {module: 3 mm}}\n",
        ["bevel gears need the teeth of both: bevel_gears: {a: {teeth: 20}, b: {teeth: 40}}"],
    ),
    "bevel gears with what nobody reads": (
        "bevel_gears: {a: {teeth: 20, colour: red}, b: {teeth: 40}}\na_speed: 20 rpm\n",
        ["a.colour stands under bodies and connections"],
    ),
    "a pendulum without a length": ("pendulum: {mass: 2 kg}\n", ["a pendulum needs a length"]),
    "a shape that is not indented": (
        "bodies:\n  a:\n  particle: {mass: 2 kg}\n",
        ["particle is not indented, so that a is empty"],
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_figure_that_cannot_be_read_is_told_by_what_it_lacks(mistake: str) -> None:
    text, said = MISTAKES[mistake]
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(text)
    told = [problem.message for problem in refused.value.problems]
    assert len(told) == len(said)
    assert all(part in message for part, message in zip(said, told, strict=True))


def test_an_entry_behind_a_dash_is_read() -> None:
    text = "bodies:\n  - a: {particle: {mass: 2 kg}}\nconnections:\n  guide:\n    - slider: {body: a, along: right}\n"
    assert [*fb.System.from_text(text).connections] == ["guide"]


def test_beams_by_supports_that_say_their_places_alone() -> None:
    """10 N (6 - 2)/6."""
    text = "beam: {length: 6 m}\nsupports: {A: 0, B: 6 m}\nloads: [{force: 10 N, at: 2 m}]\n"
    (answer,) = fb.System.from_text(text).solve("y component of reaction of A").answers
    assert answer.value == pytest.approx(20 / 3)


@pytest.mark.parametrize(
    "words", ["z: 20, m: 4 mm", "N: 20, module: 4 mm", "teeth: 20, m: 4 mm", "Zähnezahl: 20, modul: 4 mm"]
)
def test_a_toothed_wheel_has_the_same_words_everywhere(words: str) -> None:
    plain = "teeth: 20, module: 4 mm"
    other = ", b: {teeth: 40, module: 4 mm}"
    train = "bodies: {{a: {{gear: {{{0}}}}}, b: {{gear: {{teeth: 40}}}}}}\nconnections: {{m: {{gear_mesh: [a, b]}}}}\n"
    bevels = "bevel_gears: {{a: {{{0}}}" + other.replace("{", "{{").replace("}", "}}") + "}}\n"
    for text in (train, bevels):
        read, meant = (fb.System.from_text(text.format(each)) for each in (words, plain))
        assert read.bodies["a"] == meant.bodies["a"]
