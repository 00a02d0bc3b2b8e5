"""PrairieLearn: a folder for each question, with its data, its figures, and the few lines that mark by them.

Source: docs.prairielearn.com, "Question structure", "Elements"; the elements' own code (`apps/prairielearn/elements`).
"""

from __future__ import annotations

import json
import math
import uuid
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from html import escape
from pathlib import Path
from typing import Any, cast

from freebody.errors import ExpressionError, InputError
from freebody.exercises.asked import ChoiceAsked, NumberAsked, number_tests
from freebody.exercises.bank import Bank, ItemVariant
from freebody.exercises.formulas import FormulaAsked, are_same, formula_tests, parts_given, values_at
from freebody.exercises.markup import Markup, described, latex_dialect
from freebody.exercises.notes import typing_note
from freebody.exercises.package import Package
from freebody.exercises.prairielearn import PAGES, SERVER
from freebody.exercises.questions import ItemQuestion, questions_of
from freebody.exercises.selftests import Marked, SelfTest
from freebody.exercises.typed import Language, Typing
from freebody.language.plain_text import plain
from freebody.language.sentences import Message
from freebody.present.report.blocks import Figure

NAME = "prairielearn"
WHAT = "a folder of questions for PrairieLearn"

_TAKEN = (
    "e pi infty i j exp log ln sqrt factorial abs sgn max min sign Abs Max Min sec cot csc arccos arcsin arctan "
    "arctan2 atan2 atanh acosh asinh sin cos tan asin acos atan sinh cosh tanh Number Symbol Integer Float "
    "Function False None True and as assert async await break class continue def del elif else except finally for "
    "from global if import in is lambda nonlocal not or pass raise return try while with yield"
)
LANGUAGE = Language(frozenset(_TAKEN.split()), {}, is_exact=True)
_UUIDS = uuid.uuid5(uuid.NAMESPACE_URL, "https://github.com/freebody/prairielearn")


# -- writing ----------------------------------------------------------------------------------
def write(bank: Bank) -> Package:
    questions, told = questions_of(bank, "PrairieLearn", LANGUAGE)
    files: dict[str, bytes] = {}
    tests: list[SelfTest] = []
    for question in questions:
        writer = _Writer(bank, question)
        data, own = writer.data()
        tests += own
        written = {"info.json": _json(writer.info()), "exercise.json": _json(data), "server.py": SERVER.encode()}
        written |= {"question.html": PAGES[question.kind].encode(), **writer.figures}
        files |= {f"questions/{writer.name}/{name}": content for name, content in written.items()}
    return Package(files, tuple(_name(question) for question in questions), tuple(tests), told)


def _name(question: ItemQuestion) -> str:
    return f"{question.item.id}/{question.kind}"


def _json(data: object) -> bytes:
    return (json.dumps(data, ensure_ascii=False, indent=1) + "\n").encode()


class _Writer:
    """Writes one question. figures: what has been drawn for it, by their places in its folder."""

    def __init__(self, bank: Bank, question: ItemQuestion) -> None:
        self.bank, self.question, self.name = bank, question, _name(question)
        self.figures: dict[str, bytes] = {}
        dialect = latex_dialect(("$", "$"), ("$$", "$$"), _words)
        self.markup = Markup(bank.language, bank.words, dialect, self._image)

    def info(self) -> dict[str, object]:
        item = self.question.item
        return {
            "uuid": str(uuid.uuid5(_UUIDS, f"{self.bank.title}/{self.bank.seed}/{self.name}")),
            "title": f"{plain(item.name)} ({self.question.kind})",
            "topic": plain(item.title),
            "tags": ["freebody", self.question.kind],
            "type": "v3",
            "singleVariant": len(item.variants) == 1,
        }

    def data(self) -> tuple[dict[str, Any], list[SelfTest]]:
        """What its server.py reads, and its self-tests."""
        tests: list[SelfTest] = []
        variants: list[dict[str, Any]] = []
        rest: dict[str, Any] = {}
        for k, (variant, form) in enumerate(self.question.forms):
            name = self.name if len(self.question.forms) == 1 else f"{self.name}#{variant.n}"
            params, right = self._texts(variant), {}
            match form:
                case FormulaAsked():
                    own, rest = self._formula(form)
                    said = [wrong["feedback"] for wrong in rest["wrong"]]
                    tests += formula_tests(self.name, form, said) if k == 0 else ()
                case ChoiceAsked():
                    own = {"options": self._options(form)}
                    tests += _choice_tests(name, own["options"])
                case NumberAsked():
                    own, right = self._number(form), {"answer": form.value}
                    tests += number_tests(name, form, [wrong["feedback"] for wrong in own["wrong"]])
            variants.append({"params": {**params, **own}, "correct_answers": right})
        return {"kind": self.question.kind, "variants": variants, **rest}, tests

    def _texts(self, variant: ItemVariant) -> dict[str, Any]:
        item, markup = self.question.item, self.markup
        return {
            "statement": markup.blocks(variant.statement),
            "prompt": markup.text(item.prompt),
            "note": "",
            "solution": markup.blocks(variant.solution),
        }

    def _formula(self, form: FormulaAsked) -> tuple[dict[str, Any], dict[str, Any]]:
        """What the page needs, and what formulas are compared by."""
        names = [f"answer_{k}" for k in range(1, len(form.right) + 1)] if len(form.right) > 1 else ["answer"]
        variables = ", ".join(form.typing.theirs.values())
        labels = self.question.item.labels if len(names) > 1 else ("",)
        parts = [{"name": n, "label": s, "variables": variables} for n, s in zip(names, labels, strict=True)]
        wrong = [{"values": w.values, "feedback": self.markup.text(w.feedback).strip()} for w in form.wrong]
        compared = {"points": form.points, "later": form.later, "values": form.values, "wrong": wrong}
        note = self.markup.blocks(typing_note(form.typing, self.bank.language))
        return {"parts": parts, "note": note}, compared

    def _options(self, form: ChoiceAsked) -> list[dict[str, str]]:
        return [
            {
                "html": self.markup.text(option.shown).strip(),
                "correct": "true" if option.is_right else "false",
                "feedback": self.markup.text(option.feedback).strip(),
            }
            for option in form.options
        ]

    def _number(self, form: NumberAsked) -> dict[str, Any]:
        tolerance = self.question.item.tolerance
        return {
            "note": f"<p>{self.markup.text(form.prompt)}</p>",
            "unit": form.unit,
            "comparison": "sigfig" if tolerance.digits else "relabs",
            "digits": tolerance.digits or 1,
            "rtol": f"{tolerance.relative:g}",
            "atol": f"{tolerance.absolute:g}",
            "wrong": [
                {"value": w.value, "room": w.room, "feedback": self.markup.text(w.feedback).strip()} for w in form.wrong
            ],
        }

    def _image(self, figure: Figure) -> str:
        """A file of the question, by what is drawn in it, so that equal drawings are one."""
        drawing = figure.picture.svg(dark=False).encode()
        name = f"figure-{sha256(drawing).hexdigest()[:12]}.svg"
        self.figures[f"clientFilesQuestion/{name}"] = drawing
        return f'<pl-figure file-name="{name}" alt="{described(figure)}"></pl-figure>'


def _words(text: str) -> str:
    """Plain words, in which no dollar begins a formula."""
    return escape(plain(text)).replace("$", "<span>$</span>")


def _choice_tests(name: str, options: list[dict[str, str]]) -> Iterator[SelfTest]:
    for option in options:
        if option["correct"] == "true":
            yield SelfTest(name, "key", option["html"], "correct", option["feedback"])
        else:
            yield SelfTest(name, "distractor", option["html"], "incorrect", option["feedback"])


# -- reading ----------------------------------------------------------------------------------
@dataclass(frozen=True)
class PrairieLearnQuestion:
    """A variant of a question, as its elements and its server.py mark it."""

    data: Mapping[str, Any]
    params: Mapping[str, Any]
    right: Mapping[str, Any]

    def mark(self, response: str) -> Marked:
        match self.data["kind"]:
            case "formula":
                return self._formula(parts_given(response))
            case "options":
                return self._option(response)
            case _:
                return self._number(response)

    def _formula(self, given: tuple[str, ...]) -> Marked:
        names = {name.strip() for part in self.params["parts"] for name in part["variables"].split(",")}
        typing = Typing(LANGUAGE, {name: name for name in names})
        try:
            exprs = [typing.read(text) for text in given]
            for expr in exprs:
                typing.written(expr)
            values = [values_at(expr, self.data["points"], self.data["later"]) for expr in exprs]
        except ExpressionError as error:
            raise InputError(error.message) from error
        if are_same(values, self.data["values"]):
            return Marked("correct")
        known = [wrong["feedback"] for wrong in self.data["wrong"] if are_same(values, wrong["values"])]
        return Marked("incorrect", known[0] if known else "")

    def _option(self, response: str) -> Marked:
        for option in self.params["options"]:
            if option["html"] == response:
                return Marked("correct" if option["correct"] == "true" else "incorrect", option["feedback"])
        raise InputError(Message("the question has no such option"))

    def _number(self, response: str) -> Marked:
        given, value = float(response), float(self.right["answer"])
        if self.params["comparison"] == "sigfig":
            places = int(self.params["digits"]) - 1 - (math.floor(math.log10(abs(value))) if value else 0)
            room = 0.51 * 10.0**-places
        else:
            room = float(self.params["atol"]) + float(self.params["rtol"]) * abs(value)
        if abs(given - value) <= room * (1 + 1e-9):
            return Marked("correct")
        known = [w["feedback"] for w in self.params["wrong"] if abs(given - w["value"]) <= w["room"] * (1 + 1e-9)]
        return Marked("incorrect", known[0] if known else "")


def read(directory: Path) -> Mapping[str, PrairieLearnQuestion]:
    """All variants of all questions. Raises InputError for a question that is not as freebody writes them."""
    found: dict[str, PrairieLearnQuestion] = {}
    for place in sorted((directory / "questions").glob("*/*/info.json")):
        folder = place.parent
        name = f"{folder.parent.name}/{folder.name}"
        data = _loaded(folder / "exercise.json")
        _loaded(place)
        if (folder / "server.py").read_text("utf-8") != SERVER:
            raise InputError(Message("{file} is not as it was written", file=f"{name}/server.py"))
        if (folder / "question.html").read_text("utf-8") != PAGES.get(str(data.get("kind"))):
            raise InputError(Message("{file} is not as it was written", file=f"{name}/question.html"))
        found |= dict(_variants(name, data))
    return found


def _variants(name: str, data: Mapping[str, Any]) -> Iterator[tuple[str, PrairieLearnQuestion]]:
    variants = data["variants"]
    several = len(variants) > 1 and data["kind"] != "formula"
    for k, variant in enumerate(variants if several else variants[:1], 1):
        question = PrairieLearnQuestion(data, variant["params"], variant["correct_answers"])
        yield f"{name}#{k}" if several else name, question


def _loaded(place: Path) -> dict[str, Any]:
    try:
        return cast("dict[str, Any]", json.loads(place.read_text("utf-8")))
    except ValueError as error:
        raise InputError(Message("{file} cannot be read: {why}", file=place.name, why=type(error).__name__)) from error
