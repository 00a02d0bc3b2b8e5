"""QTI 2.1, the format of IMS that many platforms import: items with choices or numbers, one test of them all, zipped.

Every item is a file with formulas in MathML and its figures beside it. The feedback to a wrong answer, and the worked
solution, are shown by outcomes that the response sets. Source: IMS Question and Test Interoperability, Assessment Test,
Section, and Item Information Model, version 2.1 (2012); its Integration Guide for the manifest.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from freebody.errors import InputError
from freebody.exercises.asked import (
    Asked,
    ChoiceAsked,
    Form,
    NumberAsked,
    NumbersAsked,
    asked_of,
    digits,
    number_tests,
    numbers_tests,
)
from freebody.exercises.bank import Bank
from freebody.exercises.markup import MATHML, Markup, described
from freebody.exercises.package import Package
from freebody.exercises.qti import SPACE, QtiItem, canonical, item_of, tagged
from freebody.exercises.selftests import SelfTest
from freebody.exercises.xml import HEAD, parsed, words
from freebody.language.raising import raised
from freebody.language.sentences import Message
from freebody.present.report.blocks import Figure

NAME = "qti"
WHAT = "QTI 2.1"
FILE = "package.zip"

_PLACES = f"{SPACE} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1p1.xsd"
_PACKAGE = "http://www.imsglobal.org/xsd/imscp_v1p1"
_XSI = "http://www.w3.org/2001/XMLSchema-instance"
_DECLARED = f'xmlns="{SPACE}" xmlns:xsi="{_XSI}" xsi:schemaLocation="{_PLACES}"'
_LONG_AGO = (1980, 1, 1, 0, 0, 0)  # the same bytes each time
_LARGEST = 200_000_000  # [bytes] that a package may unpack to


# -- writing ----------------------------------------------------------------------------------
def write(bank: Bank) -> Package:
    asked, told = asked_of(bank, NAME, takes_several=True)
    files: dict[str, bytes] = {}
    items: list[_WrittenItem] = []
    for one in asked:
        items.append(_ItemWriter(bank, one).item())
        files |= items[-1].files
    files["test.xml"] = _test(bank, items).encode()
    files["imsmanifest.xml"] = _manifest(items).encode()
    tests = tuple(test for item in items for test in item.tests)
    return Package({FILE: _zipped(files)} if items else {}, tuple(a.name for a in asked), tests, told)


@dataclass(frozen=True)
class _WrittenItem:
    """files: its own and those of its figures, by their paths in the package."""

    id: str
    path: str
    files: Mapping[str, bytes]
    tests: tuple[SelfTest, ...]


class _ItemWriter:
    """Writes one item."""

    def __init__(self, bank: Bank, asked: Asked) -> None:
        self.asked, self.language = asked, bank.language
        self.id = f"{asked.item.id}_{asked.variant.n}"
        self.files: dict[str, bytes] = {}
        self.markup = Markup(bank.language, bank.words, MATHML, self._image)
        self.solution = bank.words["solution"]

    def item(self) -> _WrittenItem:
        asked, markup = self.asked, self.markup
        body = f"<div>{markup.blocks(asked.variant.statement)}</div>"
        body += f"<p><strong>{markup.text(asked.item.prompt)}</strong></p>"
        form = _FORMS[type(asked.form)](self, asked.form)
        solution = markup.blocks(asked.variant.solution)
        where = f'outcomeIdentifier="SOLUTION" identifier="worked" showHide="show" title="{words(self.solution)}"'
        shown = f"<modalFeedback {where}>{solution}</modalFeedback>" if solution else ""
        document = (
            f'{HEAD}<assessmentItem {_DECLARED} identifier="{self.id}" title="{words(asked.name)}" '
            f'xml:lang="{words(self.language)}" adaptive="false" timeDependent="false" toolName="freebody">\n'
            f"{form.declared}{_outcomes(asked.item.points)}\n<itemBody>{body}{form.body}</itemBody>\n"
            f"<responseProcessing>{form.processed}{_SOLVED}</responseProcessing>\n"
            f"{form.feedback}{shown}\n</assessmentItem>\n"
        )
        path = f"items/{self.id}.xml"
        return _WrittenItem(self.id, path, {path: document.encode(), **self.files}, form.tests)

    def choice(self, form: Form) -> _WrittenForm:
        assert isinstance(form, ChoiceAsked)
        choices, feedback, tests = "", "", list[SelfTest]()
        name, right = self.asked.name, ""
        for k, option in enumerate(form.options):
            own = f"choice_{k + 1}"
            right = own if option.is_right else right
            shown, said = self.markup.text(option.shown), self.markup.text(option.feedback)
            choices += f'<simpleChoice identifier="{own}">{shown}</simpleChoice>'
            feedback += _feedback(own, said)
            what, verdict = ("key", "correct") if option.is_right else ("distractor", "incorrect")
            tests.append(SelfTest(name, what, canonical(shown), verdict, canonical(_paragraph(said))))
        body = f'<choiceInteraction responseIdentifier="RESPONSE" shuffle="true" maxChoices="1">{choices}'
        processed = (
            f'<responseCondition><responseIf><match><variable identifier="RESPONSE"/><correct identifier="RESPONSE"/>'
            f"</match>{self._scored}</responseIf></responseCondition>"
            '<setOutcomeValue identifier="FEEDBACK"><variable identifier="RESPONSE"/></setOutcomeValue>'
        )
        return _WrittenForm(
            _declared("RESPONSE", "identifier", right), f"{body}</choiceInteraction>", processed, feedback, tuple(tests)
        )

    def number(self, form: Form) -> _WrittenForm:
        assert isinstance(form, NumberAsked)
        said = [self.markup.text(wrong.feedback) for wrong in form.wrong]
        equal = _equal("RESPONSE", '<correct identifier="RESPONSE"/>', form.room)
        branches = f"<responseIf>{equal}{self._scored}</responseIf>"
        feedback = ""
        for k, (wrong, text) in enumerate(zip(form.wrong, said, strict=True), 1):
            value = f'<baseValue baseType="float">{digits(wrong.value)}</baseValue>'
            branches += f"<responseElseIf>{_equal('RESPONSE', value, wrong.room)}"
            branches += _set("FEEDBACK", "identifier", f"mistake_{k}") + "</responseElseIf>"
            feedback += _feedback(f"mistake_{k}", text)
        prompt = self.markup.text(form.prompt)
        unit = f" {words(raised(form.unit))}" if form.unit else ""
        body = f'<p>{prompt}</p><p><textEntryInteraction responseIdentifier="RESPONSE" expectedLength="15"/>{unit}</p>'
        processed = f"<responseCondition>{branches}</responseCondition>"
        tests = tuple(number_tests(self.asked.name, form, [canonical(_paragraph(text)) for text in said]))
        return _WrittenForm(_declared("RESPONSE", "float", digits(form.value)), body, processed, feedback, tests)

    def numbers(self, form: Form) -> _WrittenForm:
        assert isinstance(form, NumbersAsked)
        declared, body, equals = "", f"<p>{self.markup.text(form.prompt)}</p>", ""
        for k, (label, value) in enumerate(zip(form.labels, form.values, strict=True), 1):
            own = f"RESPONSE_{k}"
            declared += _declared(own, "float", digits(value))
            body += f'<p>{words(label)}: <textEntryInteraction responseIdentifier="{own}" expectedLength="15"/></p>'
            equals += _equal(own, f'<correct identifier="{own}"/>', form.room)
        processed = f"<responseCondition><responseIf><and>{equals}</and>{self._scored}</responseIf></responseCondition>"
        return _WrittenForm(declared, body, processed, "", tuple(numbers_tests(self.asked.name, form)))

    @property
    def _scored(self) -> str:
        return _set("SCORE", "float", f"{self.asked.item.points:g}")

    def _image(self, figure: Figure) -> str:
        name = f"{self.id}_{figure.number}.svg"
        self.files[f"figures/{name}"] = figure.picture.svg(dark=False).encode()
        return f'<img src="../figures/{name}" alt="{described(figure)}" />'


@dataclass(frozen=True)
class _WrittenForm:
    """The parts of an item that say what is to be answered, and how it is marked."""

    declared: str
    body: str
    processed: str
    feedback: str
    tests: tuple[SelfTest, ...]


_FORMS = {ChoiceAsked: _ItemWriter.choice, NumberAsked: _ItemWriter.number, NumbersAsked: _ItemWriter.numbers}


def _declared(name: str, kind: str, value: str) -> str:
    return (
        f'<responseDeclaration identifier="{name}" cardinality="single" baseType="{kind}">'
        f"<correctResponse><value>{value}</value></correctResponse></responseDeclaration>"
    )


def _outcomes(points: float) -> str:
    numbers = (("SCORE", "0"), ("MAXSCORE", f"{points:g}"))
    found = "".join(
        f'<outcomeDeclaration identifier="{name}" cardinality="single" baseType="float">'
        f"<defaultValue><value>{value}</value></defaultValue></outcomeDeclaration>"
        for name, value in numbers
    )
    names = ("FEEDBACK", "SOLUTION")
    return found + "".join(
        f'<outcomeDeclaration identifier="{name}" cardinality="single" baseType="identifier"/>' for name in names
    )


def _equal(response: str, value: str, room: float) -> str:
    off = digits(room)
    mode = f'toleranceMode="absolute" tolerance="{off} {off}"' if room else 'toleranceMode="exact"'
    return f'<equal {mode}><variable identifier="{response}"/>{value}</equal>'


def _set(name: str, kind: str, value: str) -> str:
    return f'<setOutcomeValue identifier="{name}"><baseValue baseType="{kind}">{value}</baseValue></setOutcomeValue>'


_SOLVED = _set("SOLUTION", "identifier", "worked")


def _feedback(name: str, said: str) -> str:
    if not said:
        return ""
    where = f'outcomeIdentifier="FEEDBACK" identifier="{name}" showHide="show"'
    return f"<modalFeedback {where}>{_paragraph(said)}</modalFeedback>"


def _paragraph(said: str) -> str:
    return f"<p>{said}</p>" if said else ""


# -- the package ------------------------------------------------------------------------------
def _test(bank: Bank, items: Sequence[_WrittenItem]) -> str:
    references = "".join(f'<assessmentItemRef identifier="{item.id}" href="{item.path}"/>' for item in items)
    title = words(bank.title)
    return (
        f'{HEAD}<assessmentTest {_DECLARED} identifier="test" title="{title}" toolName="freebody">\n'
        '<testPart identifier="part" navigationMode="nonlinear" submissionMode="individual">'
        f'<assessmentSection identifier="section" title="{title}" visible="true">{references}</assessmentSection>'
        "</testPart>\n</assessmentTest>\n"
    )


def _manifest(items: Sequence[_WrittenItem]) -> str:
    def resource(name: str, kind: str, path: str, others: Sequence[str], inside: str = "") -> str:
        files = "".join(f'<file href="{file}"/>' for file in (path, *others))
        return f'<resource identifier="{name}" type="{kind}" href="{path}">{files}{inside}</resource>'

    needed = "".join(f'<dependency identifierref="{item.id}"/>' for item in items)
    found = [resource("test", "imsqti_test_xmlv2p1", "test.xml", (), needed)]
    for item in items:
        others = [path for path in item.files if path != item.path]
        found.append(resource(item.id, "imsqti_item_xmlv2p1", item.path, others))
    return (
        f'{HEAD}<manifest xmlns="{_PACKAGE}" xmlns:xsi="{_XSI}" identifier="freebody">\n'
        "<metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion></metadata>\n"
        f"<organizations/>\n<resources>\n{chr(10).join(found)}\n</resources>\n</manifest>\n"
    )


def _zipped(files: Mapping[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as out:
        for name in sorted(files, key=lambda name: (name != "imsmanifest.xml", name)):
            entry = zipfile.ZipInfo(name, _LONG_AGO)
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            out.writestr(entry, files[name])
    return buffer.getvalue()


# -- reading --------------------------------------------------------------------------------------
def read(directory: Path) -> Mapping[str, QtiItem]:
    """The items of a package by their titles: those that its test names. Raises InputError for what is no such
    package, and for files that the manifest or an item names and that are not there."""
    files = _unzipped(directory / FILE)
    manifest = parsed(_of(files, "imsmanifest.xml"), "imsmanifest.xml")
    for file in manifest.iter(f"{{{_PACKAGE}}}file"):
        _of(files, file.get("href", ""))
    found: dict[str, QtiItem] = {}
    for reference in parsed(_of(files, "test.xml"), "test.xml").iter(tagged("assessmentItemRef")):
        path = reference.get("href", "")
        item = item_of(parsed(_of(files, path), path))
        for image in item.root.iter(tagged("img")):
            _of(files, _beside(path, image.get("src", "")))
        if item.name in found:
            raise InputError(Message("{file} has two questions named {name}", file=FILE, name=item.name))
        found[item.name] = item
    return found


def _unzipped(path: Path) -> Mapping[str, bytes]:
    """The files of a package, as far as it is one of a decent size."""
    try:
        with zipfile.ZipFile(path) as package:
            if sum(entry.file_size for entry in package.infolist()) > _LARGEST:
                raise InputError(Message("{file} is too large", file=path.name))
            return {entry.filename: package.read(entry) for entry in package.infolist()}
    except zipfile.BadZipFile as error:
        raise InputError(Message("{file} is no zip archive", file=path.name)) from error


def _of(files: Mapping[str, bytes], path: str) -> bytes:
    if path not in files:
        raise InputError(Message("{file} lacks {path}", file=FILE, path=path))
    return files[path]


def _beside(path: str, relative: str) -> str:
    """A path that is written relative to a file."""
    parts = list(PurePosixPath(path).parent.parts)
    for part in PurePosixPath(relative).parts:
        parts = parts[:-1] if part == ".." else [*parts, part]
    return "/".join(parts)
