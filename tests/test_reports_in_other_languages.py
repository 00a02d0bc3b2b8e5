"""Reports of studies in another language: no sentence of ours stays English, and nothing else changes."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import cast

import pytest

import freebody as fb
from command import freebody
from freebody.language.notation import Stated
from freebody.language.sentences import Message
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.phrases import phrases_of
from freebody.narrative.telling.reports import ReportTeller
from freebody.present.report import blocks
from freebody.present.report.result import Result
from freebody.studies import STUDIES

EXAMPLES = Path(__file__).parents[1] / "examples"
LANGUAGE = "de"
WORD = re.compile(r"[A-Za-z]{3,}")
KNOWN = {template for table in phrases_of(LANGUAGE).messages.values() for template in table}
UNITS_AND_FUNCTIONS = {"rad", "deg", "sin", "cos", "tan"}
NAMES = {"Grashof", "open", "crossed"}  # of a condition, and of assembly modes as a file names them

CASES: list[tuple[str, Callable[[fb.System], Result]]] = [
    ("atwood_machine", lambda s: s.solve()),
    ("cardan_joint", lambda s: s.solve()),
    ("block_on_rough_incline", lambda s: s.solve()),
    ("four_bar", lambda s: s.equations_of_motion()),
    ("four_bar", lambda s: s.mobility()),
    ("planetary_gear", lambda s: s.mobility()),
    ("cardan_joint", lambda s: s.mobility()),
    ("double_pendulum", lambda s: s.conserved()),
    ("body_on_driven_roller", lambda s: s.conserved()),
    ("ladder_against_wall", lambda s: s.statics()),
    ("atwood_machine", lambda s: s.statics()),
    ("double_pendulum", lambda s: s.equilibria()),
    ("double_pendulum", lambda s: s.modes()),
    ("mass_on_spring", lambda s: s.modes("start")),
    ("block_on_rough_incline", lambda s: s.phases()),
    ("bouncing_ball", lambda s: s.phases()),
    ("block_on_rough_incline", lambda s: s.simulate(1.0)),
    ("loop_the_loop", lambda s: s.simulate(0.3)),
    ("driven_slider_crank", lambda s: s.over_a_turn(n=24)),
    ("planetary_gear_by_teeth", lambda s: s.speed_table(efficiency=0.98)),
    ("atwood_machine", lambda s: s.sensitivity()),
]


def pieces(report: object) -> Iterator[str]:
    """Every text of a report, wherever it stands: no part of it is known here, so none can be forgotten."""
    match report:
        case blocks.Formula() | blocks.Emphasis(look="code" | "name"):
            return
        case str():
            yield report
        case tuple():
            for part in cast("tuple[object, ...]", report):
                yield from pieces(part)
        case _ if is_dataclass(report):
            for field in fields(report):
                if field.name not in ("look", "kind", "marks"):
                    yield from pieces(getattr(report, field.name))
        case _:
            return


def untold(text: str, names: set[str]) -> Iterator[str]:
    """The parts of a text that no catalogue has and no author wrote."""
    text = text.words if isinstance(text, Stated) else text
    if isinstance(text, Message):
        if text.template not in KNOWN:
            yield text.template
        for part in text.arguments.values():
            if isinstance(part, Message | Stated):
                yield from untold(part, names)
    elif not set(WORD.findall(text)) <= names and Catalogue(LANGUAGE).said(text) == text:
        yield text


def names_of(system: fb.System, file: Path) -> set[str]:
    """The words of the author, and the names of rows that are made of them."""
    rows = " ".join(row.name for row in system.rows)
    return {*WORD.findall(file.read_text("utf-8")), *WORD.findall(rows), *UNITS_AND_FUNCTIONS, *NAMES}


@pytest.mark.parametrize(("name", "study"), CASES, ids=[f"{name}-{k}" for k, (name, _study) in enumerate(CASES)])
def test_no_english_sentence_is_left(name: str, study: Callable[[fb.System], Result]) -> None:
    file = EXAMPLES / f"{name}.yaml"
    system = fb.System.load(file)
    found = study(system)
    names = names_of(system, file)
    assert [part for text in pieces(found.report.blocks) for part in untold(text, names)] == []
    told = found.told_by(ReportTeller(LANGUAGE))
    assert told.to_text() != found.to_text()
    assert told.to_plain() == found.to_plain()


def test_a_sentence_that_is_left_english_is_found() -> None:
    text = Message("{what}: {why}", what="x", why=Message("nobody translates this"))
    assert list(untold(text, set()))[-1] == "nobody translates this"
    assert list(untold("it cannot be so", {"crank"})) == ["it cannot be so"]
    assert list(untold("crank - rod", {"crank", "rod"})) == []
    report = blocks.Section(("a",), (blocks.Table((("b",),), ((("c",),),)), blocks.Entries((blocks.Entry("d", ()),))))
    assert list(pieces(report)) == ["a", "b", "c", "d"]


def test_formulas_names_and_numbers_stay() -> None:
    """In both languages a report has the same formulas in the same order."""

    def formulas(part: object) -> Iterator[blocks.Formula]:
        if isinstance(part, blocks.Formula):
            yield part
        elif isinstance(part, tuple):
            for each in cast("tuple[object, ...]", part):
                yield from formulas(each)
        elif is_dataclass(part):
            for field in fields(part):
                yield from formulas(getattr(part, field.name))

    system = fb.System.load(EXAMPLES / "atwood_machine.yaml")
    english, german = system.solve(), system.solve(language=LANGUAGE)
    assert list(formulas(german.told)) == list(formulas(english.told))
    assert "3 bewegte Körper, 2 Verbindungen, 1 Freiheitsgrad; Koordinate: x₁" in german.to_text()
    assert "gültig      für alle positiven Parameter" in german.to_text()
    assert german.told.language == LANGUAGE
    assert 'lang="de"' in german.to_html()
    assert german == english


def test_every_study_that_reports_knows_the_language() -> None:
    pictures = {"draw", "picture", "free_body"}
    for name, study in STUDIES.items():
        assert study.is_told == (name not in pictures)
        assert ("language" in inspect.signature(getattr(fb, name)).parameters) == (name not in pictures)


def test_an_unknown_language_is_told_before_anything_is_computed() -> None:
    system = fb.System.load(EXAMPLES / "atwood_machine.yaml")
    with pytest.raises(fb.InputError, match="there are no words for the language dee"):
        system.mobility(language="dee")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("mobility", "examples/four_bar.yaml"), "Abzählung nach Grübler und Kutzbach"),
        (("statics", "examples/ladder_against_wall.yaml"), "Das System bleibt in Ruhe."),
        (("simulate", "examples/double_pendulum.yaml", "--until", "0.1"), "Fehler der Energiebilanz"),
    ],
)
def test_a_command_takes_the_language(arguments: tuple[str, ...], said: str) -> None:
    done = freebody(*arguments, "--language", "de")
    assert done.returncode == 0, done.stderr
    assert said in done.stdout


def test_charts_are_told_in_the_language_of_their_study() -> None:
    system = fb.System.load(EXAMPLES / "atwood_machine.yaml")
    found = system.sweep({"m1": "1..5 kg:9", "M": "0.5..2 kg:9"}, find="tension", language="de")
    assert found.chart().title == "tension über M [kg] und m1 [kg]"
    assert "tension over" not in found.to_text()
    figure = system.simulate(0.2, language="de").plot()
    assert figure.axes[-1].get_xlabel() == "Zeit [s]"
    assert system.simulate(0.2).plot().axes[-1].get_xlabel() == "time [s]"


def test_a_synthesis_is_told_in_german() -> None:
    """A task that one linkage alone does: two pairs of a function, followed for one candidate."""
    rows = [{"at": ["0 m", "0 m"], "angle": "0 deg"}, {"at": ["0.5 m", "0.2 m"], "angle": "30 deg"}]
    task = {"task": "motion", "positions": rows, "full_turn": False}
    found = fb.synthesise(task, most=1, language="de")
    text = found.to_text()
    assert "Führung durch 2 Lagen, Viergelenk" in text
    assert "Kandidaten" in text
    assert found.to_plain() == fb.synthesise(task, most=1).to_plain()


def test_what_pictures_show_is_told_in_german(tmp_path: Path) -> None:
    told = tmp_path / "told.md"
    fb.System.load(EXAMPLES / "disk_rolling_down_incline.yaml").explain(language="de").write(told)
    alternative = " ".join(re.findall(r"!\[([^\]]*)\]", told.read_text("utf-8")))
    assert "Körper: disk." in alternative
    assert (
        "Freikörperbild von disk. Gewichtskraft m g, nach unten; Normalkraft N, unter 60 Grad"
        in alternative.replace("\u2009", " ")
    )


SHORT_ROD = """parameters: {L: 1.25 m, m: 2.5 kg, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {A: {pin: [ground.A, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod}}
start: {theta: -60 deg}
questions: [{id: first, find: acceleration of theta}]
"""


@pytest.mark.parametrize("study", ["solve", "explain"])
def test_german_has_a_decimal_comma_and_plain_data_keep_the_point(study: str) -> None:
    """theta'' = -3/2 g/L cos(theta) = -5.886 rad/s^2 at -60 degrees."""
    system = fb.System.from_text(SHORT_ROD)
    english, german = (getattr(system, study)(language=language) for language in ("en", "de"))
    assert "-5.886 rad/s" in english.to_text()
    assert "-5,886 rad/s" in german.to_text()
    assert re.search(r"\d\.\d", german.to_text()) is None
    assert german.to_plain()["answers"] == english.to_plain()["answers"]
    assert "5.886" in str(german.to_plain())


def test_a_german_message_has_a_decimal_comma_also_for_a_power_of_ten() -> None:
    gap = Message("{x} to {y:.3g} m", x=Message("{gap:.2g} m", gap=0.031), y=1.25e-9)
    assert Catalogue("de").said(gap) == "0,031 m to 1,25e-09 m"
    assert Catalogue("en").said(gap) == "0.031 m to 1.25e-09 m"


def test_a_german_house_can_keep_the_decimal_point() -> None:
    system = fb.System.from_text(SHORT_ROD + "style: {decimal: point}\n")
    assert "-5.886 rad/s" in system.explain(language="de").to_text()


@pytest.mark.parametrize("name", ["double_pendulum", "spinning_top"])
def test_the_page_on_which_a_motion_plays_is_told_in_german(name: str, tmp_path: Path) -> None:
    system = fb.System.load(EXAMPLES / f"{name}.yaml")
    german, english = (system.simulate(0.1, language=lang).animate(tmp_path / f"{lang}.html") for lang in ("de", "en"))
    told, other = german.read_text("utf-8"), english.read_text("utf-8")
    data = re.compile(r'<script type="application/json" id="data">.*?</script>', re.DOTALL)
    assert data.findall(told) == data.findall(other)
    assert '<html lang="de">' in told
    for words in ("Abspielen", "Bewegung von", "über 0,1 s", "Körper:", "Achsen [length] m lang", "Die Leertaste"):
        assert words in told
    for words in (">Play<", "Animation of", "; bodies: ", "Space plays", "One frame", "Points to trace"):
        assert words in other
        assert words not in told
