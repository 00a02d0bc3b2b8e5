"""Sentences that the lower layers hand over ready-made, in the words of another language."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator
from functools import cache
from itertools import count, islice
from pathlib import Path

import pytest

import freebody as fb
from command import freebody
from examples_told import EXAMPLES, FOLDER, solved
from freebody.language.sentences import Message, Sentence
from freebody.narrative import words
from freebody.narrative.sheets.asking import headline
from freebody.narrative.sheets.statement import ExerciseStatement
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.phrases import PLACE, TextPattern, phrases_of
from freebody.present.report.blocks import Block, Report
from freebody.present.report.formats.terminal import terminal_text

SOURCES = Path(fb.__file__).parent
ENGLISH = set(
    re.findall(
        r"\w+",
        "the is of with and for are has does by below along that it this these where which from how answer option "
        "keeps not holds grows gives equal means touching taut",
    )
)
PHRASES = [p for own in phrases_of("de").kinds.values() for p in own]
german = Catalogue("de")


# -- the table --------------------------------------------------------------------------------
@cache
def written() -> str:
    """All that the sources say between places of their strings."""
    found: list[str] = []
    for path in SOURCES.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                found.append(" ".join(node.value.split(" ")))
    return "\n".join(found)


def test_a_phrase_has_the_same_places_on_both_sides() -> None:
    for phrase in PHRASES:
        english = [name for name, _kind in PLACE.findall(phrase.english)]
        assert sorted(set(english)) == sorted(english), phrase
        assert sorted(set(re.findall(r"\{(.*?)\}", phrase.text))) == sorted(english), phrase


def test_what_a_phrase_is_for_is_said_somewhere_in_the_sources() -> None:
    """Word by word: sentences are put together from parts."""
    words = {w: p.english for p in PHRASES for w in re.findall(r"[A-Za-z]{3,}", PLACE.sub(" ", p.english))}
    known = set(re.findall(r"[A-Za-z]{3,}", written()))
    known |= {word + ending for word in known for ending in ("s", "es")}  # the grammar of questions: opens?, reaches?
    assert {w: english for w, english in words.items() if w not in known} == {}


def test_a_phrase_is_the_one_that_fits_its_own_pattern() -> None:
    of = phrases_of("de")

    def sample(kind: str) -> TextPattern:
        return of.kinds[kind][0] if kind in of.kinds and kind else TextPattern("q1", "q1")

    for phrase in PHRASES:
        kinds = dict(PLACE.findall(phrase.english))
        english = {name: PLACE.sub("q1", sample(kind).english) for name, kind in kinds.items()}
        text = PLACE.sub(lambda place, inside=english: inside[place[1]], phrase.english)
        expected = {name: PLACE.sub("q1", sample(kind).text) for name, kind in kinds.items()}
        said = phrase.text.format_map(expected)
        assert (of.said(text, phrase.kind) or text) == (said if phrase.kind else of.with_articles(said)), phrase


@pytest.mark.parametrize(
    ("understood", "in_german"),
    [
        (
            "kinetic energy at start - kinetic energy when rolling begins",
            "kinetische Energie am Anfang - kinetische Energie beim Beginn des Rollens",
        ),
        ("time when it stops", "Zeitpunkt: Stillstand"),
        ("change of x until rate(x) = 0", "Änderung von x bis x' = 0"),
        ("energy lost in the impact", "Energieverlust beim Stoß"),
        ("speed of ball after the second impact", "Betrag der Geschwindigkeit von ball nach dem zweiten Stoß"),
        ("|acceleration of x| at start", "|Beschleunigung von x| am Anfang"),
        ("s when speed of crate is greatest", "s, wenn Betrag der Geschwindigkeit von crate am größten ist"),
        (
            "least h so that tension of track >= 0 when theta = 180 deg",
            "kleinstes h mit Zugkraft von track ≥ 0 bei theta = 180 deg",
        ),
        (
            "(work of motor until theta has moved 2*pi) / (2*pi)",
            "(Arbeit von motor, bis sich theta um 2*pi bewegt hat) / (2*pi)",
        ),
        (
            "1 - (kinetic energy when block stops)/(kinetic energy at start)",
            "1 - (kinetische Energie beim Stillstand von block)/(kinetische Energie am Anfang)",
        ),
        ("(force in spring)^2 / (2*k) when y = 0.6 m", "(Kraft in spring)^2 / (2*k) bei y = 0.6 m"),
        ("average power of motor until z = 5 m", "mittlere Leistung von motor bis z = 5 m"),
        ("time when velocity of phi = 1/2 of its final value", "Zeitpunkt: Geschwindigkeit von phi = 1/2 des Endwerts"),
        ("whether ball leaves dome", "ob sich ball von dome löst"),
        ("whether x never turns back", "ob x nie umkehrt"),
        ("range of v for which theta reaches 30 deg", "Bereich von v, in dem theta den Wert 30 deg erreicht"),
        ("least F so that rope stays taut", "kleinstes F, bei dem rope straff bleibt"),
        ("speed of ball after the 10th impact", "Betrag der Geschwindigkeit von ball nach dem 10. Stoß"),
    ],
)
def test_how_a_question_is_understood_is_told_in_german(understood: str, in_german: str) -> None:
    assert phrases_of("de").said(understood) == in_german


def test_what_is_said_of_a_point_begins_with_its_article() -> None:
    told = german.plain(Sentence("balance.angular", {"bodies": ("ladder",), "point": "@ladder"}))
    at_end = german.plain(Sentence("point.named", {"point": "ladder.end"}))
    assert told.startswith("Momente an ladder um ")
    assert at_end == "das Ende von ladder"
    assert german.plain(Sentence("point.named", {"point": "left.center"})) == "den Mittelpunkt von left"
    assert german.plain(Sentence("phases.until_is_reached", {"connection": "@x turns back"})) == "x umkehrt"


def test_kinds_of_places_have_phrases() -> None:
    known = {*phrases_of("de").kinds, "", "name", "connection", "words", "list", "most"}
    assert {kind for p in PHRASES for _name, kind in PLACE.findall(p.english)} <= known


# -- what is said -----------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("english", "text"),
    [
        (
            "angle of line from A to B from down clockwise",
            "Winkel der Geraden von A nach B gegen die Richtung nach unten, im Uhrzeigersinn",
        ),
        ("velocity of s when s = h/sin(alpha)", "Geschwindigkeit von s bei s = h/sin(alpha)"),
        ("turns of ball until rolling begins", "Zahl der Umdrehungen von ball bis zum Beginn des Rollens"),
    ],
)
def test_sentences_are_put_together_from_phrases(english: str, text: str) -> None:
    assert german.said(english) == text


def test_what_no_phrase_fits_stays_as_it_is() -> None:
    for text in ("a b c", "m·(g + a) ≥ 0", "3·2 - 5 = 1", "f(a, b)", "Zug nach rechts", "the moon is a ball of cheese"):
        assert german.said(text) == text


def test_a_single_word_is_a_name() -> None:
    for name in ("string", "pin", "right", "rolls", "always", "contact", "divisor"):
        assert german.said(name, "point") == name


def test_events_stand_behind_a_preposition_where_one_asks_for_them() -> None:
    assert german.said("block stops", "text") == "Stillstand von block"
    assert german.said("drop of A", "phrase") == "Tiefe von A"


def test_options_that_are_conditions_are_german() -> None:
    assert german.option("always") == "immer"
    assert german.option("only if |v| is constant") == "nur wenn |v| konstant ist"
    assert german.option("if A.center coincides with B") == "wenn A.center mit B zusammenfällt"
    assert german.option("2*m*g/3") == "2*m*g/3"


def test_english_says_what_it_is_given() -> None:
    english = Catalogue("en")
    assert phrases_of("en").messages == {}
    assert english.said("acceleration of left along down") == "acceleration of left along down"


def test_points_are_said_without_dots() -> None:
    said = Catalogue("en").said
    assert said("drop of left below ground.axle") == "drop of left below axle"
    assert said("angle of line from ground.S to P1.center") == "angle of the line from S to the centre of P1"
    assert german.said("drop of left below ground.axle") == "Tiefe von left unter axle"


def test_a_thousand_sentences_take_at_most_a_million_calls(
    within: Callable[[int, Callable[[], object]], None],
) -> None:
    numbers = count()

    def say() -> None:
        for k in islice(numbers, 1000):
            german.said(f"velocity of s when s = {k}·m·g/(m + {k}·M)")

    within(1_000_000, say)


# -- examples ---------------------------------------------------------------------------------
def said_of(name: str) -> Iterator[tuple[str, str]]:
    """Every ready-made sentence of an example's answers, with its German."""
    for answer in solved(name).answers:
        texts = [*answer.conditions, *answer.notes, *answer.author_notes, answer.reason]
        texts += [verdict.reason for verdict in answer.options.values()]
        if answer.evidence is not None:
            texts.append(answer.evidence.route)
        for text in texts:
            yield text, german.said(text)


@pytest.mark.parametrize("name", EXAMPLES)
def test_reasons_conditions_and_evidence_of_an_example_are_german(name: str) -> None:
    system = solved(name).system
    names = {*system.bodies, *system.connections, *system.loads, *system.measures}
    for english, text in said_of(name):
        left = {w for w in re.findall(r"[A-Za-z]+", text) if w in ENGLISH and w not in names}
        assert left == set(), f"{english} -> {text}"


@pytest.mark.parametrize("name", EXAMPLES)
def test_names_and_formulas_of_an_example_are_unaltered(name: str) -> None:
    system = solved(name).system
    names = {*system.bodies, *system.connections, *system.loads, *system.measures}
    for given in (*names, *(f"{b.name}.{p}" for b in system.bodies.values() for p in b.points)):
        assert german.said(given) == given
    assert german.said(system.title, "title") == system.title

    def kept(text: str) -> set[str]:
        return {part.strip(",;:.()") for part in re.findall(r"[A-Za-z]\w*\.\w+|\S*[=+*·/²≥≠]\S*", text)}

    for english, text in said_of(name):
        assert kept(english) == kept(text), english


@pytest.mark.parametrize("name", EXAMPLES)
def test_questions_and_measures_of_an_example_are_german(name: str) -> None:
    system = fb.System.load(FOLDER / f"{name}.yaml")
    for question in system.questions:
        title = german.plain(headline(system, question))
        assert not {"of", "when", "at", "that", "conserved"} & set(title.split()), title


def test_an_exercise_is_set_in_german() -> None:
    system = fb.System.load(FOLDER / "atwood_machine.yaml")
    blocks: tuple[Block, ...] = ExerciseStatement(system, german, 1, 1).blocks()
    text = terminal_text(Report("Aufgabe", "de", "", blocks, {}))
    assert "Tiefe von left unter axle" in text
    assert "drop of" not in text


# -- a language of one's own ------------------------------------------------------------------
FRENCH = """
[list]
and = " et "

[report]
babel = "french"
worked_solution = "Solution détaillée"

[stage]
checks = "Vérifications"

[message]
"the system has no contact, no stop and no dry friction: its motion has one phase" = "une seule phase"

[phrase]
"acceleration of {p:name} along {d:along}" = "accélération de {p} {d}"

[phrase.along]
"down" = "vers le bas"
"""


def test_a_new_language_is_one_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "fr.toml").write_text(FRENCH, encoding="utf-8")
    system = fb.System.load(FOLDER / "atwood_machine.yaml")
    with pytest.raises(fb.InputError, match="there are no words for the language fr"):
        system.explain("acceleration", language="fr")
    monkeypatch.setattr(words, "__path__", [*words.__path__, str(tmp_path)])
    assert words.languages() == ("de", "en", "fr")
    explained = system.explain("acceleration", language="fr")
    assert explained.is_complete
    text, page = explained.to_text(), explained.to_html()
    assert "Solution détaillée" in text
    assert "Vérifications" in text
    assert "Degrees of freedom" in text  # what it lacks is said in English
    assert 'lang="fr"' in page
    (latex, *_pictures) = explained.write(tmp_path / "a.tex")
    assert "french" in latex.read_text(encoding="utf-8").partition(r"\begin{document}")[0]
    french = Catalogue("fr")
    assert french.said("acceleration of left along down") == "accélération de left vers le bas"
    with pytest.raises(fb.CannotAnswer) as refused:
        fb.System.from_text("bodies: {p: {particle: {mass: 1 kg}}}").phases()
    assert french.said(refused.value.args[0]) == "une seule phase"
    done = freebody("sheet", "examples/atwood_machine.yaml", "-o", str(tmp_path / "s.html"), "--language", "fr")
    assert done.returncode == 0, done.stderr
    assert 'lang="fr"' in (tmp_path / "s.html").read_text(encoding="utf-8")
    # what users are told comes from the list of files
    done = freebody("explain", "examples/atwood_machine.yaml", "--language", "fra")
    assert "Did you mean fr?" in done.stderr


@pytest.mark.parametrize(
    ("name", "question", "english", "german"),
    [
        ("spinning_top", "spin", "Conservation of", "Erhaltung: "),
        ("cardan_joint", "extremes", "Extremes of the ratio", "Extremwerte über eine Umdrehung"),
        ("farthest_throw", "farthest", "Largest x for all θ when y = 0", "Größter Wert für alle θ: x bei y = 0"),
    ],
)
def test_headings_have_no_words_of_the_file(name: str, question: str, english: str, german: str) -> None:
    system = fb.System.load(Path(__file__).parents[1] / f"examples/{name}.yaml")
    asked = next(q for q in system.questions if q.id == question)
    for language, expected in (("en", english), ("de", german)):
        catalogue = Catalogue(language)
        title = catalogue.plain(headline(system, asked))
        assert expected.lower() in title.lower()


@pytest.mark.parametrize(
    ("asked", "in_german"),
    [
        (
            "angle of line from ladder.start to ladder.end from up",
            "Winkel der Geraden vom Anfang von ladder zum Ende von ladder gegen die Richtung nach oben",
        ),
        ("height of ladder.end", "Höhe des Endes von ladder"),
        ("y until y turns back", "y bis zum Umkehren von y"),
        ("time when kinetic energy = 1/2*(total energy)", "Zeitpunkt: kinetische Energie = 1/2*(Gesamtenergie)"),
        (
            "value of P for which time when flywheel stops = 5 s",
            "Wert von P, bei dem die Zeit bis zum Stillstand von flywheel gleich 5 s ist",
        ),
    ],
)
def test_points_have_articles_and_nothing_stays_english(asked: str, in_german: str) -> None:
    assert phrases_of("de").said(asked) == in_german


def test_the_name_of_something_is_spelt_as_in_the_file_where_a_sentence_begins() -> None:
    from freebody.language.sentences import Sentence
    from freebody.narrative.telling.catalogue import Catalogue

    told = Catalogue("de").plain(Sentence("contact.touches", {"connection": "foot"}))
    assert "foot" in told
    assert "Foot" not in told


def test_rows_of_connections_and_kinds_are_named_in_german() -> None:
    of = phrases_of("de")
    rows = "wall.slip of ladder.end on wall, floor.ladder.start on floor"
    assert of.put(rows, "name") == "wall (Reibung, Ende von ladder auf wall), floor (Anfang von ladder auf floor)"
    assert of.said("tension of rope between hand and upper") == "Zugkraft von rope zwischen hand und upper"
    assert of.put("rope (slip on upper)", "name") == "rope (auf upper)"
    assert of.parts(Message("{kind}", kind="gear_mesh")) == ["Zahneingriff"]
    assert of.parts(Message("{names}", names="y, x of ball")) == ["y, x-Koordinate von ball"]
    assert of.parts(Message("{mode} (this one)", mode="mode 2")) == ["mode 2", " (diese)"]  # as the file has to say it
    ends = Message("{body} {what} on {other}", body="pipe", what=Message("stops slipping"), other="floor")
    assert of.said(ends) == "pipe hört auf, auf floor zu gleiten"
    assert of.said(Message("{contact} {state}", contact="ground.contact", state="sticking")) == "ground haftet"
    ratio = of.said("ratio of acceleration of a to acceleration of b")
    assert ratio == "Verhältnis von Beschleunigung von a zu Beschleunigung von b"
    twice = "value of P for which size of reaction of B = 2*size of reaction of A"
    assert of.said(twice) == "Wert von P mit Betrag der Kraft von B = 2*Betrag der Kraft von A"
