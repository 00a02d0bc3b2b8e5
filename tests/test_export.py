"""Exercises for learning platforms: packages that pass their self-tests, and what they say when read again."""

from __future__ import annotations

import functools
import io
import json
import math
import os
import re
import sys
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

import freebody as fb
from command import freebody
from examples_told import EXAMPLES, FOLDER
from freebody.errors import InputError, SelfTestFailed
from freebody.exercises import platforms, selftests
from freebody.exercises.bank import Bank
from freebody.exercises.export import examine, export_bank
from freebody.exercises.making import made_bank
from freebody.exercises.platforms import gift, moodle_xml, qti
from thinned import thinned

CARDS = (
    "atwood_machine",
    "disk_rolling_down_incline",
    "sphere_launched_down_incline",
    "planetary_gear",
    "disk_on_angled_shaft",
    "cardan_joint",
    "body_on_driven_roller",
    "multi_bar_platform",
)
OTHERS = (
    "ball_in_bowl",
    "bead_on_turning_hoop",
    "belt_drive",
    "block_on_rough_incline",
    "bob_on_sliding_cart",
    "bouncing_ball",
    "capstan",
    "cart_and_pendulum",
    "collar_pulled_over_a_pulley",
    "compound_atwood",
    "conical_pendulum",
    "double_pendulum",
    "four_bar",
    "hoist",
    "incline_with_pulley",
    "ladder_against_wall",
    "mass_on_spring",
    "planet_orbit",
    "simple_pendulum",
    "slider_crank",
    "two_masses_three_springs",
    "yo_yo",
)
DISK = "disk_rolling_down_incline"
QUICK = ("atwood_machine", "disk_rolling_down_incline", "disk_on_angled_shaft", "multi_bar_platform", "yo_yo")
READERS = (gift, moodle_xml, qti)
NAMES = tuple(reader.NAME for reader in READERS)


@functools.cache
def bank(name: str, variants: int = 1, language: str = "en") -> Bank:
    return made_bank([fb.System.load(FOLDER / f"{name}.yaml")], variants=variants, language=language)


def written(made: Bank, to: str, folder: Path) -> Mapping[str, Any]:
    """The questions of a package, as they are read from it, by their names."""
    export_bank(made, to, folder)
    reader = next(reader for reader in READERS if to == reader.NAME)
    return reader.read(folder)


def text_of(to: str, folder: Path) -> str:
    """All that stands in a package."""
    if to != "qti":
        return (folder / (gift.FILE if to == "gift" else moodle_xml.FILE)).read_text("utf-8")
    with zipfile.ZipFile(folder / qti.FILE) as package:
        return "\n".join(package.read(name).decode() for name in package.namelist())


# -- self-tests -------------------------------------------------------------------------------
@pytest.mark.parametrize("name", thinned((*CARDS, *OTHERS), lambda name: name in QUICK))
def test_packages_of_the_examples_pass_their_self_tests(name: str, tmp_path: Path) -> None:
    made = bank(name)
    for to in NAMES:
        done = export_bank(made, to, tmp_path / to)
        left_out = [told for told in done.told if "is left out" in told]
        assert len(done.names) + len(left_out) == len(made.items)
        assert done.n_tests == examine(tmp_path / to) >= 2 * len(done.names)


def test_every_self_test_has_its_key_and_every_wrong_option_its_feedback(tmp_path: Path) -> None:
    export_bank(bank("atwood_machine"), "gift", tmp_path / "p")
    _platform, tests = selftests.read((tmp_path / "p" / selftests.FILE).read_bytes())
    assert [test.what for test in tests].count("key") == 3
    wrong = [test for test in tests if test.what == "distractor"]
    assert len(wrong) == 12
    assert all(test.feedback and test.verdict == "incorrect" for test in wrong)
    assert sum("the energy of rotation of <em>pulley</em> is left out" in test.feedback for test in wrong) == 1


# what is done to a package, by platform: another key, a tolerance of nothing, another feedback
TAMPERED = {
    "gift": [
        (r"\n\t=\[html\]", "\n\t~[html]"),
        (r"(\t=%100%[\d.]+):[\d.]+", r"\1:0"),
        ("is forgotten", "is remembered"),
    ],
    "moodle-xml": [
        ('<answer fraction="100"', '<answer fraction="0"'),
        (r"<tolerance>[\d.]+</tolerance>", "<tolerance>0</tolerance>"),
        ("is forgotten", "is remembered"),
    ],
    "qti": [
        (r"<correctResponse><value>choice_\d", "<correctResponse><value>choice_9"),
        (r'tolerance="[\d. ]+"', 'tolerance="0"'),
        ("is forgotten", "is remembered"),
    ],
}


@pytest.mark.parametrize("to", NAMES)
@pytest.mark.parametrize("k", range(3))
def test_a_package_that_was_changed_fails_its_self_tests(to: str, k: int, tmp_path: Path) -> None:
    name = DISK if k == 1 else "atwood_machine"
    export_bank(bank(name), to, tmp_path)
    pattern, other = TAMPERED[to][k]
    assert _changed(to, tmp_path, pattern, other) > 0
    with pytest.raises(SelfTestFailed, match="self-tests fail, so the package is not to be used"):
        examine(tmp_path)


def _changed(to: str, folder: Path, pattern: str, other: str) -> int:
    """Changes the texts of a package, and says how often."""
    if to != "qti":
        file = folder / (gift.FILE if to == "gift" else moodle_xml.FILE)
        text, n = re.subn(pattern, other, file.read_text("utf-8"))
        file.write_text(text, "utf-8")
        return n
    with zipfile.ZipFile(folder / qti.FILE) as package:
        files = {name: package.read(name).decode() for name in package.namelist()}
    n, buffer = 0, io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as package:
        for name, text in files.items():
            new, k = re.subn(pattern, other, text)
            n += k
            package.writestr(name, new)
    (folder / qti.FILE).write_bytes(buffer.getvalue())
    return n


def test_a_question_that_is_missing_and_one_without_a_test_are_told(tmp_path: Path) -> None:
    export_bank(bank("atwood_machine"), "gift", tmp_path)
    file = tmp_path / selftests.FILE
    document = json.loads(file.read_text("utf-8"))
    for test in document["tests"][:5]:
        test["question"] = "another"
    file.write_text(json.dumps(document), "utf-8")
    with pytest.raises(SelfTestFailed, match="no such question") as caught:
        examine(tmp_path)
    assert "it has no self-test of its key" in str(caught.value)


def test_a_writer_whose_package_fails_leaves_nothing_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def unescaped(text: str) -> str:
        return " ".join(text.splitlines())

    monkeypatch.setattr(gift, "_escaped", unescaped)  # a brace ends the answers
    with pytest.raises((SelfTestFailed, InputError)):
        export_bank(bank("atwood_machine"), "gift", tmp_path / "p")
    assert list(tmp_path.iterdir()) == []


# -- what is right ----------------------------------------------------------------------------
@pytest.mark.parametrize("to", NAMES)
def test_a_disk_rolls_slower_than_it_slides_and_who_forgets_its_inertia_is_told(to: str, tmp_path: Path) -> None:
    """s'' = g sin(alpha)/(1 + I/(m R^2)), here 8/11 of g sin(alpha), which it is without the moment of inertia."""
    asked = written(bank(DISK), to, tmp_path / "p")
    question = next(q for name, q in asked.items() if "acceleration" in name)
    sliding = 9.81 * math.sin(math.radians(30))
    right = sliding * 0.08 / (0.08 + 0.03)
    for share, verdict in ((1.0, "correct"), (1.009, "correct"), (0.989, "incorrect"), (-1.0, "incorrect")):
        assert question.mark(f"{right * share:.8g}").verdict == verdict
    assert "moment of inertia" in question.mark(f"{sliding:.6g}").feedback


@pytest.mark.parametrize("to", NAMES)
def test_the_right_option_is_that_of_the_key(to: str, tmp_path: Path) -> None:
    """g (m1 - m2)/(m1 + m2 + M/2), which is option a of the file, in the order of the file."""
    asked = written(bank("atwood_machine"), to, tmp_path / "p")
    question = next(q for name, q in asked.items() if "acceleration" in name)
    options = list(question.choices) if to == "qti" else [answer.text for answer in question.answers]
    assert [question.mark(option).verdict for option in options] == ["correct", *["incorrect"] * 4]


PENDULUM = """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
questions: [{find: degrees of freedom}]
"""


def test_a_count_has_no_room_for_another_number(tmp_path: Path) -> None:
    asked = written(made_bank([fb.System.from_text(PENDULUM)]), "moodle-xml", tmp_path / "p")
    [question] = asked.values()
    assert [question.mark(x).verdict for x in ("1", "1.001", "0", "2")] == ["correct", *["incorrect"] * 3]
    assert "Give a whole number." in question.text


# -- variants ---------------------------------------------------------------------------------
def test_numbers_figures_and_answers_of_variants_follow_each_other(tmp_path: Path) -> None:
    """A disk rolls down with s'' = g sin(alpha)/(1 + I/(m R^2))."""
    made = bank(DISK, variants=3)
    item = next(item for item in made.items if item.id.endswith("acceleration"))
    angles: set[float] = set()
    for variant in item.variants:
        given = {one.name: one.value for one in variant.given}
        angles.add(given["alpha"])
        slope = given["g"] * math.sin(given["alpha"])
        assert variant.value == pytest.approx(slope / (1 + given["I"] / given["m"] / given["R"] ** 2), rel=1e-9)
        assert variant.figure is not None
    assert len(angles) > 1
    by_angle: dict[float, set[str]] = {}
    for variant in item.variants:
        assert variant.figure is not None
        angle = next(one.value for one in variant.given if one.name == "alpha")
        by_angle.setdefault(angle, set()).add(variant.figure.picture.svg())
    drawn = list(by_angle.values())
    assert not drawn[0] & drawn[1]  # another slope is another drawing
    for to in NAMES:
        asked = written(made, to, tmp_path / to)
        own = [q for name, q in asked.items() if name.startswith(item.name)]
        for question, variant in zip(own, item.variants, strict=True):
            assert question.mark(f"{variant.value:.6g}").verdict == "correct"
        text = text_of(to, tmp_path / to)
        assert all(f"[{n}]" in text for n in (1, 2, 3))


def test_options_of_variants_are_shuffled_and_keep_what_is_right() -> None:
    made = bank("atwood_machine", variants=3)
    orders = set[tuple[str, ...]]()
    for item in made.items:
        for variant in item.variants:
            [right] = [option.text for option in variant.options if option.is_right]
            assert right == next(o.text for o in item.variants[0].options if o.is_right)
            orders.add(tuple(option.text for option in variant.options))
    assert len(orders) > 3


# -- what a platform cannot do ----------------------------------------------------------------
def test_a_vector_is_several_fields_where_there_are_such_and_is_left_out_elsewhere(tmp_path: Path) -> None:
    made = bank("disk_on_angled_shaft")
    vectors = [item for item in made.items if not item.has_options]
    assert vectors
    assert all(item.answer == "vector" for item in vectors)
    told = export_bank(made, "gift", tmp_path / "gift").told
    assert [t for t in told if "several values at once cannot be marked there" in t] == list(told)
    asked = written(made, "moodle-xml", tmp_path / "xml")
    question = asked[vectors[0].name]
    value = vectors[0].variants[0].value
    assert isinstance(value, tuple)
    assert question.kind == "cloze"
    assert [x for x, _room in question.fields] == pytest.approx(list(value), rel=1e-9)


def test_a_formula_that_changes_in_the_motion_is_asked_with_options_that_mistakes_lead_to(tmp_path: Path) -> None:
    made = bank("body_on_driven_roller")
    told = export_bank(made, "gift", tmp_path / "p").told
    assert told
    assert all("options that mistakes lead to" in t for t in told)


# -- texts ------------------------------------------------------------------------------------
HOSTILE = r"""
title: "} ~ = # : :: {1:NUMERICAL:=1:0} \\n // $CATEGORY: x %50% <b>&amp;</b> ]]> -> \\( $$ &&058; \"q\" ''"
about: "::name:: {=right ~wrong} #### // \\[x\\] <script>alert(1)</script> &lt; @@PLUGINFILE@@ /x.svg 100% \\alpha"
parameters: {m: 2 kg, nu: 3 N, g: 9.81 m/s^2}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}}
loads: {push: {force: {at: block, along: right, magnitude: nu}}}
measures: {x: {x of block}}
questions:
  - {id: a, find: acceleration of x, text: "How {fast} ~ is = it? # : \\( x \\) </p>"}
  - {id: b, find: acceleration of x, options: {a: nu/m, b: m/nu, c: "2*nu/m", d: nu*m}, key: a}
"""


@pytest.mark.parametrize("to", NAMES)
def test_words_that_are_markup_elsewhere_are_words(to: str, tmp_path: Path) -> None:
    made = made_bank([fb.System.from_text(HOSTILE)])
    asked = written(made, to, tmp_path / "p")
    assert len(asked) == 2
    number, choice = asked.values()
    assert number.mark("1.5").verdict == "correct"
    assert len(choice.choices if to == "qti" else choice.answers) == 4
    assert "<script" not in text_of(to, tmp_path / "p")
    assert to == "qti" or not any("<b>" in question.text for question in (number, choice))


def test_reserved_signs_of_gift_are_escaped_as_its_importer_reads_them(tmp_path: Path) -> None:
    r"""Of \nu a backslash with n would be a line break; nothing but a name, a format and the answers is not escaped."""
    made = made_bank([fb.System.from_text(HOSTILE)])
    asked = written(made, "gift", tmp_path / "p")
    name = next(iter(asked))
    assert name.startswith("} ~ = # : :: {1:NUMERICAL:=1:0} \\n // $CATEGORY: x %50% <b>&amp;</b> ]]> -> \\( $$")
    assert r"\nu" in next(iter(asked.values())).general
    raw = (tmp_path / "p" / gift.FILE).read_text("utf-8")
    own = raw[raw.index("::") + 2 :]
    assert re.search(r"(?<!\\)(?:\\\\)*::", own) is not None


def test_markup_of_moodle_is_well_formed_and_has_no_mathematics_in_words(tmp_path: Path) -> None:
    from freebody.exercises.xml import parsed

    asked = written(made_bank([fb.System.from_text(HOSTILE)]), "moodle-xml", tmp_path / "p")
    for question in asked.values():
        markup = parsed(f"<div>{question.text}</div>".encode(), "text")
        words = re.sub(r"\\\(.*?\\\)", "", "".join(markup.itertext()))
        assert "How {fast}" in words or "Find" in words
    assert "\\<span></span>(" in next(iter(asked.values())).text


def test_the_same_models_make_the_same_bytes(tmp_path: Path) -> None:
    system = fb.System.load(FOLDER / "yo_yo.yaml")
    made = [made_bank([system], variants=2, seed=3) for _ in range(2)]
    for to in NAMES:
        for k in (1, 2):
            export_bank(made[k - 1], to, tmp_path / f"{to}{k}")
        first, second = (sorted((tmp_path / f"{to}{k}").rglob("*")) for k in (1, 2))
        assert [p.name for p in first] == [p.name for p in second]
        assert [p.read_bytes() for p in first] == [p.read_bytes() for p in second]


@pytest.mark.parametrize("to", NAMES)
def test_a_german_package_is_german(to: str, tmp_path: Path) -> None:
    written(bank(DISK, language="de"), to, tmp_path / "p")
    text = text_of(to, tmp_path / "p")
    assert "Geben Sie die Zahl in m/s² an; sie darf um 1 % abweichen." in text.replace("\\", "")
    assert "Gesucht" in text or "Bestimmen" in text or "Gegeben" in text
    for english in ("Find the", "Give the number", "is forgotten", "Figure"):
        assert english not in text


# -- reading ----------------------------------------------------------------------------------
def test_entities_and_files_of_elsewhere_are_not_read(tmp_path: Path) -> None:
    export_bank(bank("yo_yo"), "moodle-xml", tmp_path)
    file = tmp_path / moodle_xml.FILE
    text = file.read_text("utf-8").replace("<quiz>", '<!DOCTYPE quiz [<!ENTITY a "b">]><quiz>')
    file.write_text(text, "utf-8")
    with pytest.raises(InputError, match="declares a document type"):
        examine(tmp_path)


@pytest.mark.parametrize(
    ("to", "pattern", "other", "told"),
    [
        ("gift", "::", ";;", "without a name"),
        ("gift", "}", "", "between braces"),
        ("moodle-xml", "</quiz>", "", "not well-formed"),
        ("moodle-xml", 'name="figure_1.svg"', 'name="other.svg"', "figure_1.svg is missing"),
        ("qti", "<file href=", '<file href="x', "lacks|not well-formed"),
        ("qti", "<match>", "<other/><match>", "is not read|another"),
    ],
)
def test_what_is_no_package_is_told(to: str, pattern: str, other: str, told: str, tmp_path: Path) -> None:
    export_bank(bank("atwood_machine"), to, tmp_path)
    assert _changed(to, tmp_path, re.escape(pattern), other) > 0
    with pytest.raises((InputError, SelfTestFailed), match=told):
        examine(tmp_path)


def test_a_folder_without_a_package_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="so it is no package"):
        examine(tmp_path)


# -- the command ------------------------------------------------------------------------------
def test_the_command_writes_a_package_and_says_what_is_in_it(tmp_path: Path) -> None:
    done = freebody("export", str(FOLDER / f"{DISK}.yaml"), "--to", "moodle-xml", "-o", str(tmp_path / "p"))
    assert done.returncode == 0, done.stderr
    assert re.fullmatch(rf"wrote \d questions to {tmp_path}/p; \d+ self-tests passed\n", done.stdout)
    assert (
        "disk_rolling_down_incline_acceleration: moodle-xml takes no formulas, so the number is asked for"
        in done.stderr
    )
    assert sorted(p.name for p in (tmp_path / "p").iterdir()) == ["questions.xml", "selftests.json"]


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (("--to", "gifd", "-o", "p"), "there is no platform gifd: gift (Moodle's text format)"),
        (("--to", "gift", "-o", "full"), "the folder full is not empty; give a new one, or empty it first"),
        (("--to", "gift", "-o", "full/file"), "full/file is a file; give a folder"),
        (("--to", "gift", "-o", "no/p"), "there is no folder no"),
        (("--to", "gift", "-o", "p", "--variants", "0"), "there can be no 0 variants"),
        (("--to", "gift", "-o", "p", "--tolerance", "much"), "the tolerance 'much' cannot be read"),
        (("--to", "gift", "-o", "p", "--language", "xx"), "there are no words for the language xx"),
        (("--to", "gift", "-o", "p", "--set", "q=1 kg"), "no model of the sheet has a parameter q"),
    ],
)
def test_bad_input_is_told_before_anything_is_written(options: tuple[str, ...], told: str, tmp_path: Path) -> None:
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "file").write_text("x")
    done = freebody("export", str(FOLDER / "yo_yo.yaml"), *options, cwd=tmp_path)
    assert done.returncode == 2
    assert told in done.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == ["full"]


def test_a_model_without_questions_is_told(tmp_path: Path) -> None:
    (tmp_path / "m.yaml").write_text("freebody: 1\nbodies: {a: {particle: {mass: 1 kg}}}\n")
    done = freebody("export", "m.yaml", "--to", "gift", "-o", "p", cwd=tmp_path)
    assert done.returncode == 2
    assert "an exercise needs a question" in done.stderr


# -- a platform is one file -------------------------------------------------------------------
FLASH_CARDS = '''"""Flash cards: a line for each question, with its key behind a tab."""

from freebody.exercises.asked import NumberAsked, asked_of, digits
from freebody.exercises.package import Package
from freebody.exercises.selftests import Marked, SelfTest

NAME = "flash-cards"
WHAT = "lines with a tab"


class Card:
    def __init__(self, key):
        self.key = key

    def mark(self, response):
        return Marked("correct" if response == self.key else "incorrect")


def write(bank):
    asked, told = asked_of(bank, NAME)
    numbers = {a.name: digits(a.form.value) for a in asked if isinstance(a.form, NumberAsked)}
    lines = "".join(f"{name}\\t{key}\\n" for name, key in numbers.items())
    tests = tuple(SelfTest(name, "key", key, "correct") for name, key in numbers.items())
    return Package({"cards.tsv": lines.encode()}, tuple(numbers), tests, told)


def read(directory):
    lines = (directory / "cards.tsv").read_text("utf-8").splitlines()
    return {name: Card(key) for name, _tab, key in (line.partition("\\t") for line in lines)}
'''


def test_a_platform_that_the_program_does_not_know_is_one_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "more").mkdir()
    (tmp_path / "more" / "flash_cards.py").write_text(FLASH_CARDS)
    monkeypatch.setattr(platforms, "__path__", [*platforms.__path__, str(tmp_path / "more")])
    platforms.platforms.cache_clear()
    try:
        done = export_bank(bank(DISK), "flash-cards", tmp_path / "p")
        assert done.n_tests == len(done.names) > 0
    finally:
        platforms.platforms.cache_clear()
        sys.modules.pop("freebody.exercises.platforms.flash_cards", None)


# -- the schemas of QTI -----------------------------------------------------------------------
SCHEMAS = os.environ.get("FREEBODY_QTI_SCHEMAS", "")


@pytest.mark.parametrize("name", thinned((*CARDS, *OTHERS), lambda name: name in QUICK))
def test_qti_is_valid_by_its_schemas(name: str, tmp_path: Path) -> None:
    if not SCHEMAS:
        pytest.skip(
            "NOT RUN: FREEBODY_QTI_SCHEMAS names no folder with the schemas; see docs/howto/export_exercises.md"
        )
    etree = pytest.importorskip("lxml.etree", reason="NOT RUN: pip install lxml to validate packages of QTI")
    schemas = {
        "item": etree.XMLSchema(etree.parse(str(Path(SCHEMAS) / "qtiv2p1p1" / "imsqti_v2p1p1.xsd"))),
        "manifest": etree.XMLSchema(etree.parse(str(Path(SCHEMAS) / "imscp_v1p1.xsd"))),
    }
    export_bank(bank(name), "qti", tmp_path / "p")
    with zipfile.ZipFile(tmp_path / "p" / qti.FILE) as package:
        for path in package.namelist():
            if path.endswith(".xml"):
                schema = schemas["manifest" if path == "imsmanifest.xml" else "item"]
                assert schema.validate(etree.fromstring(package.read(path))), (path, schema.error_log)


def test_the_examples_named_here_are_there() -> None:
    assert {*CARDS, *OTHERS} <= {*EXAMPLES}
