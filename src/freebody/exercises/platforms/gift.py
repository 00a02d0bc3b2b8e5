r"""GIFT, the text format of Moodle: multiple choice and numbers, figures within the text.

Source: docs.moodle.org, "GIFT format", and Moodle's import `question/format/gift/format.php`, whose order of steps the
reader below follows: backslashes are taken in pairs, then escaped signs become places, and only then are `::`, braces,
`####`, `~`, `=`, `#` and `:` looked for. A blank line ends a question, so each is written without one.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from freebody.errors import InputError
from freebody.exercises.asked import Asked, ChoiceAsked, NumberAsked, asked_of, digits, number_tests
from freebody.exercises.bank import Bank
from freebody.exercises.markup import Markup, described
from freebody.exercises.moodle import DIALECT
from freebody.exercises.package import Package
from freebody.exercises.selftests import Judged, Marked, SelfTest
from freebody.language.plain_text import plain
from freebody.language.sentences import Message
from freebody.present.report.blocks import Figure

NAME = "gift"
WHAT = "Moodle's text format"
FILE = "questions.gift"

_RESERVED = re.compile(r"[\\#={}~:]")
_NUMBER = re.compile(r"(?P<value>[^:]+):(?P<room>.+)")
_WEIGHT = re.compile(r"%(?P<weight>-?\d{1,3}(?:\.\d+)?)%")


# -- writing ----------------------------------------------------------------------------------
def write(bank: Bank) -> Package:
    asked, told = asked_of(bank, NAME)
    writer = _Writer(bank)
    parts, title, tests = [writer.head()], "", list[SelfTest]()
    for one in asked:
        if one.item.title != title:
            title = one.item.title
            parts.append(f"$CATEGORY: $course$/top/{_category(title)}")
        text, own = writer.question(one)
        parts.append(text)
        tests += own
    return Package({FILE: ("\n\n".join(parts) + "\n").encode()}, tuple(a.name for a in asked), tuple(tests), told)


class _Writer:
    def __init__(self, bank: Bank) -> None:
        self.bank = bank
        self.markup = Markup(bank.language, bank.words, DIALECT, _image)

    def head(self) -> str:
        return f"// {plain(self.bank.title)}: freebody, GIFT"

    def question(self, one: Asked) -> tuple[str, list[SelfTest]]:
        """Its text, and its self-tests."""
        markup, variant = self.markup, one.variant
        name = _name(one.name)
        prompt = f"<p><strong>{markup.text(one.item.prompt)}</strong></p>"
        told = markup.blocks(variant.statement) + prompt
        if isinstance(one.form, ChoiceAsked):
            answers, tests = self._choice(name, one.form)
        else:
            assert isinstance(one.form, NumberAsked)  # several at once are not asked for
            told += f"<p>{markup.text(one.form.prompt)}</p>"
            answers, tests = self._number(name, one.form)
        solution = markup.blocks(variant.solution)
        general = f"\t####[html]{_escaped(solution)}\n" if solution else ""
        return f"::{_escaped(name)}::[html]{_escaped(told)}{{{answers}{general}}}", tests

    def _choice(self, name: str, form: ChoiceAsked) -> tuple[str, list[SelfTest]]:
        lines, tests = "\n", list[SelfTest]()
        for option in form.options:
            shown, said = self.markup.text(option.shown), self.markup.text(option.feedback)
            lines += f"\t{'=' if option.is_right else '~'}[html]{_escaped(shown)}#[html]{_escaped(said)}\n"
            what, verdict = ("key", "correct") if option.is_right else ("distractor", "incorrect")
            tests.append(SelfTest(name, what, shown.strip(), verdict, said.strip()))
        return lines, tests

    def _number(self, name: str, form: NumberAsked) -> tuple[str, list[SelfTest]]:
        said = [self.markup.text(wrong.feedback).strip() for wrong in form.wrong]
        lines = f"#\n\t=%100%{digits(form.value)}:{digits(form.room)}#\n"
        for wrong, words in zip(form.wrong, said, strict=True):
            lines += f"\t=%0%{digits(wrong.value)}:{digits(wrong.room)}#[html]{_escaped(words)}\n"
        return lines, list(number_tests(name, form, said))


def _image(figure: Figure) -> str:
    """The drawing in the address of the image: GIFT has no files."""
    drawing = b64encode(figure.picture.svg(dark=False).encode()).decode()
    return f'<img src="data:image/svg+xml;base64,{drawing}" alt="{described(figure)}" />'


def _escaped(text: str) -> str:
    """One line, in which no sign is one of the format."""
    return _RESERVED.sub(lambda found: "\\" + found[0], " ".join(text.splitlines()))


def _name(name: str) -> str:
    """The name of a question: && begins a place of the importer."""
    return re.sub("&(?=&)", "& ", plain(name)).strip()


def _category(title: str) -> str:
    """A category is read as it stands, but for backslashes."""
    return _name(title).replace("/", "//").replace("\\", "")


# -- reading ----------------------------------------------------------------------------------
@dataclass(frozen=True)
class _Answer:
    """text: an option, or a number; room: of a number, None for an option; weight: in percent."""

    text: str
    room: float | None
    weight: float
    feedback: str


@dataclass(frozen=True)
class GiftQuestion:
    """A question as Moodle reads it."""

    name: str
    text: str
    answers: tuple[_Answer, ...]
    general: str

    @property
    def is_number(self) -> bool:
        return any(answer.room is not None for answer in self.answers)

    def mark(self, response: str) -> Marked:
        """The first answer that fits counts."""
        for answer in self.answers:
            if _fits(answer, response, self.name):
                verdict: Judged = "correct" if answer.weight == 100.0 else "incorrect"
                return Marked(verdict, answer.feedback)
        if not self.is_number:
            raise InputError(Message("the question has no such option"))
        return Marked("incorrect")


def _fits(answer: _Answer, response: str, name: str) -> bool:
    if answer.room is None:
        return answer.text == response
    return abs(_float(response, name) - _float(answer.text, name)) <= answer.room * (1 + 1e-9)


def read(directory: Path) -> Mapping[str, GiftQuestion]:
    """The questions of a file by their names. Raises InputError for what Moodle would refuse."""
    try:
        text = (directory / FILE).read_text("utf-8")
    except ValueError as error:
        raise InputError(Message("{file} is not text in UTF-8", file=FILE)) from error
    found: dict[str, GiftQuestion] = {}
    for part in re.split(r"\n[ \t]*\n", text):
        lines = [line for line in part.splitlines() if not line.strip().startswith("//")]
        own = _unescaped("\n".join(lines).strip())
        if own and not own.startswith("$CATEGORY:"):
            question = _question(own)
            if question.name in found:
                raise InputError(Message("{file} has two questions named {name}", file=FILE, name=question.name))
            found[question.name] = question
    return found


_SIGNS = {sign: f"&&{ord(sign):03d};" for sign in ":#={}~"}


def _unescaped(text: str) -> str:
    text = text.replace("\\\\", "&&092;")
    for sign, place in _SIGNS.items():
        text = text.replace(f"\\{sign}", place)
    return text.replace("\\n", "&&010;").replace("&&092;", "\\")


def _signs(text: str) -> str:
    for sign, place in _SIGNS.items():
        text = text.replace(place, sign)
    return text.replace("&&010;", "\n").strip()


def _question(text: str) -> GiftQuestion:
    opened = re.match(r"::(.*?)::", text, re.DOTALL)
    if opened is None:
        raise InputError(Message("{file} has a question without a name", file=FILE))
    name, text = _signs(opened[1]), text[opened.end() :].strip()
    start, end = text.find("{"), text.find("}")
    if start < 0 or end < start or text[end + 1 :].strip():
        raise InputError(Message("{file}: the answers of {name} are not between braces", file=FILE, name=name))
    answers, _mark, general = text[start + 1 : end].strip().partition("####")
    is_number = answers.startswith("#")
    found = _numbers(answers[1:], name) if is_number else _options(answers)
    return GiftQuestion(name, _formatted(text[:start]), tuple(found), _formatted(general))


def _options(text: str) -> Iterator[_Answer]:
    for part in filter(None, map(str.strip, text.replace("=", "~=").split("~"))):
        weight, rest = (100.0, part[1:]) if part.startswith("=") else _weighted(part, 0.0)
        shown, _mark, said = rest.partition("#")
        yield _Answer(_formatted(shown), None, weight, _formatted(said))


def _numbers(text: str, name: str) -> Iterator[_Answer]:
    for part in filter(None, map(str.strip, text.split("="))):
        weight, rest = _weighted(part, 100.0)
        number, _mark, said = rest.partition("#")
        given = _NUMBER.fullmatch(number.strip())
        value, room = (number.strip(), "0") if given is None else (given["value"], given["room"])
        yield _Answer(value, _float(room, name), weight, _formatted(said))


def _weighted(text: str, otherwise: float) -> tuple[float, str]:
    found = _WEIGHT.match(text)
    return (otherwise, text) if found is None else (float(found["weight"]), text[found.end() :])


def _formatted(text: str) -> str:
    """Without the name of its format."""
    return _signs(re.sub(r"^\[(?:html|moodle|plain|markdown)\]", "", text.strip()))


def _float(text: str, name: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InputError(Message("{name}: '{text}' is no number", name=name, text=text)) from None
