r"""Moodle XML: multiple choice, numbers with units, several numbers as cloze; figures are files within the questions.

Variants are questions of one category, from which a quiz draws at random. Source: docs.moodle.org, "Moodle XML format",
and Moodle's import `question/format/xml/format.php`; numbers are marked as by `question/type/numerical/question.php`:
the first answer within its tolerance counts.
"""

from __future__ import annotations

import re
from base64 import b64decode, b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

from freebody.errors import InputError
from freebody.exercises.asked import (
    Asked,
    ChoiceAsked,
    NumberAsked,
    NumbersAsked,
    asked_of,
    digits,
    number_tests,
    numbers_tests,
)
from freebody.exercises.bank import Bank
from freebody.exercises.markup import Markup, described
from freebody.exercises.moodle import DIALECT
from freebody.exercises.package import Package
from freebody.exercises.selftests import Judged, Marked, SelfTest
from freebody.exercises.xml import HEAD, content, parsed, text_at, words
from freebody.language.plain_text import plain
from freebody.language.raising import raised
from freebody.language.sentences import Message
from freebody.present.report.blocks import Block, Figure, Text

NAME = "moodle-xml"
WHAT = "Moodle's own format"
FILE = "questions.xml"

_PENALTY = "0.3333333"
_FIELD = re.compile(r"\{1:NUMERICAL:=(?P<value>[^:{}]+):(?P<room>[^:{}]+)\}")
_ALIKE = 1e-12  # relative: the room for round-off that Moodle adds
_UNIT_TYPED = ("0", "0.1", "0", "0")  # a unit may be typed behind the number, and need not be


# -- writing ----------------------------------------------------------------------------------
def write(bank: Bank) -> Package:
    asked, told = asked_of(bank, NAME, takes_several=True)
    writer = _Writer(bank)
    parts, category, tests = list[str](), "", list[SelfTest]()
    for one in asked:
        own = _category(one, bank.n_variants)
        if own != category:
            category = own
            parts.append(f'<question type="category"><category><text>{words(own)}</text></category></question>')
        text, more = writer.question(one)
        parts.append(text)
        tests += more
    document = f"{HEAD}<quiz>\n{chr(10).join(parts)}\n</quiz>\n"
    return Package({FILE: document.encode()}, tuple(a.name for a in asked), tuple(tests), told)


def _category(one: Asked, n_variants: int) -> str:
    """Variants of a question have a category of their own, a slash in a name is written twice."""
    names = [one.item.title, *([one.item.name] if n_variants > 1 else [])]
    return "/".join(["$course$", "top", *(plain(name).replace("/", "//") for name in names)])


class _Writer:
    def __init__(self, bank: Bank) -> None:
        self.bank = bank
        self.files: dict[str, bytes] = {}  # of the text that is being written
        self.markup = Markup(bank.language, bank.words, DIALECT, self._image)

    def question(self, one: Asked) -> tuple[str, list[SelfTest]]:
        """Its element, and its self-tests."""
        match one.form:
            case ChoiceAsked():
                kind, (inside, tests) = "multichoice", self._choice(one.name, one.form)
                asked = ""
            case NumberAsked():
                kind, (inside, tests) = "numerical", self._number(one.name, one.form)
                asked = f"<p>{self.markup.text(one.form.prompt)}</p>"
            case NumbersAsked():
                kind, inside, tests = "cloze", "", list(numbers_tests(one.name, one.form))
                asked = f"<p>{self.markup.text(one.form.prompt)}</p>{_fields(one.form)}"
        variant, item = one.variant, one.item
        self.files = {}
        told = self.markup.blocks(variant.statement)
        told += f"<p><strong>{self.markup.text(item.prompt)}</strong></p>{asked}"
        if kind == "cloze":
            told = _without_fields(told, asked)
        text = self._kept("questiontext", told)
        general = self._blocks("generalfeedback", variant.solution)
        hints = "".join(self._text("hint", hint) for hint in variant.hints)
        head = f"<name><text>{words(one.name)}</text></name>{text}{general}"
        grade = "" if kind == "cloze" else f"<defaultgrade>{item.points:g}</defaultgrade>"
        number = f"<idnumber>{words(item.id)}_{variant.n}</idnumber>"
        head += f"{grade}<penalty>{_PENALTY}</penalty><hidden>0</hidden>{number}"
        return f'<question type="{kind}">{head}{inside}{hints}</question>', tests

    def _choice(self, name: str, form: ChoiceAsked) -> tuple[str, list[SelfTest]]:
        inside = "<single>true</single><shuffleanswers>true</shuffleanswers><answernumbering>abc</answernumbering>"
        inside += "<showstandardinstruction>0</showstandardinstruction>"
        tests: list[SelfTest] = []
        for option in form.options:
            shown, said = self.markup.text(option.shown), self.markup.text(option.feedback)
            fraction = 100 if option.is_right else 0
            feedback = f'<feedback format="html"><text>{content(said)}</text></feedback>'
            inside += f'<answer fraction="{fraction}" format="html"><text>{content(shown)}</text>{feedback}</answer>'
            what, verdict = ("key", "correct") if option.is_right else ("distractor", "incorrect")
            tests.append(SelfTest(name, what, shown.strip(), verdict, said.strip()))
        return inside, tests

    def _number(self, name: str, form: NumberAsked) -> tuple[str, list[SelfTest]]:
        said = [self.markup.text(wrong.feedback).strip() for wrong in form.wrong]
        answers = [(form.value, form.room, 100, "")]
        answers += [(wrong.value, wrong.room, 0, text) for wrong, text in zip(form.wrong, said, strict=True)]
        inside = ""
        for value, room, fraction, feedback in answers:
            inside += f'<answer fraction="{fraction}" format="moodle_auto_format"><text>{digits(value)}</text>'
            inside += f'<feedback format="html"><text>{content(feedback)}</text></feedback>'
            inside += f"<tolerance>{digits(room)}</tolerance></answer>"
        tests = list(number_tests(name, form, said))
        if form.unit:
            names = dict.fromkeys((form.unit, raised(form.unit)))
            units = "".join(f"<unit><multiplier>1</multiplier><unit_name>{words(u)}</unit_name></unit>" for u in names)
            inside += f"<units>{units}</units>"
            tags = ("unitgradingtype", "unitpenalty", "showunits", "unitsleft")
            inside += "".join(f"<{tag}>{x}</{tag}>" for tag, x in zip(tags, _UNIT_TYPED, strict=True))
            tests += [SelfTest(name, "equivalent", f"{digits(form.value)} {unit}", "correct") for unit in names]
        return inside, tests

    # -- texts --------------------------------------------------------------------------------
    def _blocks(self, element: str, blocks: Sequence[Block]) -> str:
        self.files = {}
        return self._kept(element, self.markup.blocks(blocks))

    def _text(self, element: str, text: Text) -> str:
        self.files = {}
        return self._kept(element, self.markup.text(text))

    def _kept(self, element: str, markup: str) -> str:
        """A text with the files that it shows."""
        files = "".join(
            f'<file name="{name}" path="/" encoding="base64">{b64encode(drawing).decode()}</file>'
            for name, drawing in self.files.items()
        )
        return f'<{element} format="html"><text>{content(markup)}</text>{files}</{element}>'

    def _image(self, figure: Figure) -> str:
        name = f"figure_{figure.number}.svg"
        self.files[name] = figure.picture.svg(dark=False).encode()
        return f'<img src="@@PLUGINFILE@@/{name}" alt="{described(figure)}" />'


def _fields(form: NumbersAsked) -> str:
    """A field for each number."""
    rows = zip(form.labels, form.values, strict=True)
    fields = (f"{label}: {{1:NUMERICAL:={digits(value)}:{digits(form.room)}}}" for label, value in rows)
    return "".join(f"<p>{field}</p>" for field in fields)


def _without_fields(told: str, asked: str) -> str:
    """A statement in which no {1: begins a field but those at its end."""
    before = told.removesuffix(asked)
    return re.sub(r"\{(?=\d)", "{<span></span>", before) + asked


# -- reading ----------------------------------------------------------------------------------
@dataclass(frozen=True)
class _Answer:
    text: str
    room: float
    fraction: float
    feedback: str


@dataclass(frozen=True)
class MoodleQuestion:
    """A question as Moodle reads it. kind: the type of its element; fields: value and room of each, of a cloze; files:
    the drawings by name."""

    name: str
    kind: str
    text: str
    answers: tuple[_Answer, ...]
    units: tuple[tuple[str, float], ...]
    fields: tuple[tuple[float, float], ...]
    files: Mapping[str, bytes]

    def mark(self, response: str) -> Marked:
        match self.kind:
            case "multichoice":
                return self._chosen(response)
            case "numerical":
                return self._numerical(response)
            case _:
                return self._filled(response)

    def _chosen(self, response: str) -> Marked:
        found = next((answer for answer in self.answers if answer.text == response), None)
        if found is None:
            raise InputError(Message("the question has no such option"))
        return Marked(_verdict(found), found.feedback)

    def _numerical(self, response: str) -> Marked:
        number, _space, unit = response.partition(" ")
        factor = dict(self.units).get(unit, None if unit else 1.0)
        if factor is None:
            raise InputError(Message("the question knows no unit {unit}", unit=unit))
        value = _float(number, self.name) / factor
        for answer in self.answers:
            if answer.text == "*" or _is_within(value, _float(answer.text, self.name), answer.room):
                return Marked(_verdict(answer), answer.feedback)
        return Marked("incorrect")

    def _filled(self, response: str) -> Marked:
        given = [_float(part.strip(), self.name) for part in response.split(";")]
        if len(given) != len(self.fields):
            raise InputError(Message("the question has {n} fields", n=len(self.fields)))
        right = all(_is_within(x, *field) for x, field in zip(given, self.fields, strict=True))
        return Marked("correct" if right else "incorrect")


def _is_within(x: float, value: float, room: float) -> bool:
    return abs(x - value) <= room + _ALIKE * max(1.0, abs(value))


def _verdict(answer: _Answer) -> Judged:
    return "correct" if answer.fraction == 100.0 else "incorrect"


def read(directory: Path) -> Mapping[str, MoodleQuestion]:
    """The questions of a file by their names. Raises InputError for what is no such file."""
    root = parsed((directory / FILE).read_bytes(), FILE)
    if root.tag != "quiz":
        raise InputError(Message("{file} has no questions of Moodle", file=FILE))
    found: dict[str, MoodleQuestion] = {}
    for element in root.findall("question"):
        if element.get("type") != "category":
            question = _question(element)
            if question.name in found:
                raise InputError(Message("{file} has two questions named {name}", file=FILE, name=question.name))
            found[question.name] = question
    return found


def _question(element: Element) -> MoodleQuestion:
    name, kind = text_at(element, "name/text"), element.get("type", "")
    if kind not in ("multichoice", "numerical", "cloze"):
        raise InputError(Message("{name}: a question of the type {kind} is not read", name=name, kind=kind))
    text = text_at(element, "questiontext/text")
    answers = [
        _Answer(
            text_at(answer, "text"),
            _float(text_at(answer, "tolerance") or "0", name),
            _float(answer.get("fraction", "0"), name),
            text_at(answer, "feedback/text"),
        )
        for answer in element.findall("answer")
    ]
    units = [(text_at(u, "unit_name"), _float(text_at(u, "multiplier"), name)) for u in element.findall("units/unit")]
    fields = [(_float(f["value"], name), _float(f["room"], name)) for f in _FIELD.finditer(text)]
    return MoodleQuestion(
        name, kind, text, tuple(answers), tuple(units), tuple(fields) if kind == "cloze" else (), _files(element, name)
    )


def _files(element: Element, name: str) -> Mapping[str, bytes]:
    """The drawings of the statement. Raises InputError for one that the text names and that is not there."""
    inside = element.find("questiontext")
    files = {} if inside is None else {f.get("name", ""): b64decode(f.text or "") for f in inside.findall("file")}
    for wanted in re.findall(r"@@PLUGINFILE@@/([\w.]+)", text_at(element, "questiontext/text")):
        if wanted not in files:
            raise InputError(Message("{name}: the figure {file} is missing", name=name, file=wanted))
    return files


def _float(text: str, name: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InputError(Message("{name}: '{text}' is no number", name=name, text=text)) from None
