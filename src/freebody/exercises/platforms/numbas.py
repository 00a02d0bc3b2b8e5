"""Numbas: one exam of all questions, with the points of each formula, and figures within the text.

Source: docs.numbas.org.uk, "Question parts", "Marking algorithms"; the runtime (`marking_scripts`, `runtime/scripts`).
"""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from html import escape
from pathlib import Path
from typing import Any, cast

from freebody.errors import ExpressionError, InputError
from freebody.exercises import numbas as shape
from freebody.exercises.asked import ChoiceAsked, NumberAsked, number_tests
from freebody.exercises.bank import Bank, Item, ItemVariant
from freebody.exercises.formulas import FormulaAsked, formula_tests, is_same, parts_given, values_at
from freebody.exercises.markup import Markup, described, latex_dialect
from freebody.exercises.notes import typing_note
from freebody.exercises.package import Package
from freebody.exercises.questions import ItemQuestion, questions_of
from freebody.exercises.selftests import Marked, SelfTest
from freebody.exercises.typed import Language, Typing
from freebody.language.expression import Expr
from freebody.language.plain_text import plain
from freebody.language.sentences import Message
from freebody.present.report.blocks import Figure

NAME = "numbas"
WHAT = "an exam for Numbas"
FILE = "questions.exam"

_TAKEN = "pi infinity infty nan true false and or not xor in isa as implies divides for of where is except let"
_FUNCTIONS = {"log": "ln", "asin": "arcsin", "acos": "arccos", "atan": "arctan", "sign": "sgn"}
LANGUAGE = Language(frozenset(_TAKEN.split()), _FUNCTIONS)
_MARK = re.compile(r"[{}$]|\\(?=[()\[\]])")
_NO_SIGNS = str.maketrans({"{": "(", "}": ")", "$": None, "\\": None})
_STATED = re.compile(r"\[([^\]]*)\]")


# -- writing ----------------------------------------------------------------------------------
def write(bank: Bank) -> Package:
    questions, told = questions_of(bank, "Numbas", LANGUAGE)
    written: list[dict[str, Any]] = []
    tests: list[SelfTest] = []
    for question in questions:
        made, own = _Writer(bank, question).question()
        written.append(made)
        tests += own
    files = {FILE: shape.exam(plain(bank.title).translate(_NO_SIGNS), written)} if written else {}
    return Package(files, tuple(q["name"] for q in written), tuple(tests), told)


class _Writer:
    """Writes one question."""

    def __init__(self, bank: Bank, question: ItemQuestion) -> None:
        self.bank, self.asked = bank, question
        self.name = f"{_name(question.item)} [{question.kind}]"
        self.marks = question.item.points or 1.0
        self.markup = Markup(bank.language, bank.words, latex_dialect((r"\(", r"\)"), (r"\[", r"\]"), _words), _image)

    def question(self) -> tuple[dict[str, Any], list[SelfTest]]:
        """Its object in the exam, and its self-tests."""
        forms = self.asked.forms
        statement = self._by_variant([self.markup.blocks(variant.statement) for variant, _form in forms], "div")
        advice = self._by_variant([self.markup.blocks(variant.solution) for variant, _form in forms], "div")
        parts, variables, tests = self._parts()
        if len(forms) > 1:
            variables = {shape.VARIANT: f"random(0..{len(forms) - 1})", **variables}
        return shape.question(self.name, statement, advice, variables, parts), tests

    def _parts(self) -> tuple[list[dict[str, Any]], dict[str, str], list[SelfTest]]:
        match self.asked.forms[0][1]:
            case FormulaAsked() as form:
                return self._formula(form)
            case ChoiceAsked():
                return self._choice([cast("ChoiceAsked", form) for _variant, form in self.asked.forms])
            case NumberAsked():
                return self._number([(v, cast("NumberAsked", form)) for v, form in self.asked.forms])

    def _prompt(self, note: str) -> str:
        return f"<p><strong>{self.markup.text(self.asked.item.prompt)}</strong></p>{note}"

    def _by_variant(self, texts: Sequence[str], element: str) -> str:
        """All of them, each shown in its variant; once what is the same in all."""
        if len(set(texts)) == 1:
            return texts[0]
        return "".join(
            f'<{element} data-jme-visible="{shape.VARIANT}={k}">{text}</{element}>' for k, text in enumerate(texts)
        )

    # -- the kinds of questions ---------------------------------------------------------------
    def _formula(self, form: FormulaAsked) -> tuple[list[dict[str, Any]], dict[str, str], list[SelfTest]]:
        said = [self.markup.text(wrong.feedback).strip() for wrong in form.wrong]
        prompt = self._prompt(self.markup.blocks(typing_note(form.typing, self.bank.language)))
        n, changes = len(form.right), bool(form.later)
        parts: list[dict[str, Any]] = []
        for k, right in enumerate(form.right):
            own = (prompt if k == 0 else "") + (f"<p>{escape(self.asked.item.labels[k])}:</p>" if n > 1 else "")
            part = shape.formula_part(right, self.marks / n, own, only_changes=changes)
            for wrong, words in zip(form.wrong, said, strict=True):
                if not all(map(is_same, wrong.values[k], form.values[k])):
                    other = shape.formula_part(wrong.parts[k], 0, only_changes=changes)
                    part["alternatives"].append(shape.alternative(other, words))
            parts.append(part)
        variables = {shape.POINTS: _dictionaries(form.points)}
        variables |= {shape.LATER: _dictionaries(form.later)} if changes else {}
        # of several parts each says what it finds, so nothing is said about them together
        return parts, variables, list(formula_tests(self.name, form, said if n == 1 else [""] * len(said)))

    def _choice(self, forms: Sequence[ChoiceAsked]) -> tuple[list[dict[str, Any]], dict[str, str], list[SelfTest]]:
        """Options in the order of the first variant: Numbas shuffles them itself."""
        choices: list[tuple[str, bool, str]] = []
        for first in forms[0].options:
            same = [next(o for o in form.options if o.text == first.text) for form in forms]
            shown = self._by_variant([self.markup.text(o.shown).strip() for o in same], "span")
            said = self._by_variant([self.markup.text(o.feedback).strip() for o in same], "span")
            choices.append((shown, first.is_right, said))
        tests = [
            SelfTest(self.name, "key" if right else "distractor", shown, "correct" if right else "incorrect", said)
            for shown, right, said in choices
        ]
        return [shape.choice_part(choices, self.marks, self._prompt(""))], {}, tests

    def _number(
        self, forms: Sequence[tuple[ItemVariant, NumberAsked]]
    ) -> tuple[list[dict[str, Any]], dict[str, str], list[SelfTest]]:
        """Bounds by variant; the wrong numbers of all variants, each only in its own."""
        several, comma = len(forms) > 1, self.bank.language == "de"
        tests: list[SelfTest] = []
        others: list[dict[str, Any]] = []
        for k, (variant, form) in enumerate(forms):
            said = [self.markup.text(wrong.feedback).strip() for wrong in form.wrong]
            tests += number_tests(f"{self.name} #{variant.n}" if several else self.name, form, said)
            for wrong, words in zip(form.wrong, said, strict=True):
                bounds = [_decimal(x) for x in (wrong.value - wrong.room, wrong.value + wrong.room)]
                low, high = [f"if({shape.VARIANT}={k},{x},infinity)" if several else x for x in bounds]
                others.append(shape.alternative(shape.number_part(low, high, 0, comma=comma), words))
        lows = [_decimal(form.value - form.room) for _variant, form in forms]
        highs = [_decimal(form.value + form.room) for _variant, form in forms]
        variables = {shape.LOW: _list(lows), shape.HIGH: _list(highs)} if several else {}
        low, high = [f"{name}[{shape.VARIANT}]" for name in variables] if several else [lows[0], highs[0]]
        prompt = self._prompt(f"<p>{self.markup.text(forms[0][1].prompt)}</p>")
        part = shape.number_part(low, high, self.marks, prompt, comma=comma)
        return [{**part, "alternatives": others}], variables, tests


def _name(item: Item) -> str:
    """A name in which nothing is a variable or a formula, with its id where signs had to go."""
    name = plain(item.name)
    kept = name.translate(_NO_SIGNS)
    return name if kept == name else f"{kept} ({item.id})"


def _words(text: str) -> str:
    """Plain words, in which nothing begins a formula or a variable."""
    return _MARK.sub(lambda found: f"{found[0]}<span></span>", escape(plain(text)))


def _image(figure: Figure) -> str:
    """The drawing in the address of the image, so that the exam is one file."""
    drawing = b64encode(figure.picture.svg(dark=False).encode()).decode()
    return f'<img src="data:image/svg+xml;base64,{drawing}" alt="{described(figure)}" />'


def _decimal(x: float) -> str:
    """All digits, without an exponent: its letter is a name."""
    return f"{Decimal(repr(x)):f}"


def _list(numbers: Sequence[str]) -> str:
    return f"[{', '.join(numbers)}]"


def _dictionaries(points: Sequence[Mapping[str, float]]) -> str:
    return _list([_list([f'"{name}": {_decimal(x)}' for name, x in point.items()]) for point in points])


# -- reading ----------------------------------------------------------------------------------
@dataclass(frozen=True)
class NumbasQuestion:
    """A question in one of its variants, as the parts of the exam mark it."""

    parts: Sequence[Mapping[str, Any]]
    points: Sequence[Mapping[str, float]]
    later: Sequence[Mapping[str, float]]
    variant: int
    bounds: Mapping[str, Sequence[float]]

    def mark(self, response: str) -> Marked:
        kind = self.parts[0]["type"]
        if kind == "1_n_2":
            return self._choice(self.parts[0], response)
        marked = self._formulas(response) if kind == "jme" else [self._number(self.parts[0], float(response))]
        said = next((words for is_right, words in marked if words and not is_right), "")
        return Marked("correct" if all(is_right for is_right, _words in marked) else "incorrect", said)

    def _formulas(self, response: str) -> list[tuple[bool, str]]:
        given = parts_given(response)
        if len(given) != len(self.parts):
            raise InputError(Message("the question has {n} parts", n=len(self.parts)))
        return [self._formula(part, text) for part, text in zip(self.parts, given, strict=True)]

    def _formula(self, part: Mapping[str, Any], text: str) -> tuple[bool, str]:
        if (
            part["customMarkingAlgorithm"]
            != shape.formula_part("", 0, only_changes=bool(self.later))["customMarkingAlgorithm"]
        ):
            raise InputError(Message("{file} is not as it was written", file="customMarkingAlgorithm"))
        values = self._values(text)
        if self._agree(values, part):
            return True, ""
        for other in part["alternatives"]:
            if self._agree(values, other):
                return False, other["alternativeFeedbackMessage"]
        return False, ""

    def _agree(self, values: Sequence[float], part: Mapping[str, Any]) -> bool:
        return all(map(is_same, values, self._values(part["answer"])))

    def _values(self, text: str) -> tuple[float, ...]:
        names = {name: name for name in self.points[0]}
        typing = Typing(LANGUAGE, names)
        try:
            expr: Expr = typing.read(text)
            return values_at(expr, self.points, self.later)
        except ExpressionError as error:
            raise InputError(error.message) from error

    def _choice(self, part: Mapping[str, Any], response: str) -> Marked:
        if response not in part["choices"]:
            raise InputError(Message("the question has no such option"))
        k = part["choices"].index(response)
        return Marked("correct" if float(part["matrix"][k]) > 0 else "incorrect", part["distractors"][k])

    def _number(self, part: Mapping[str, Any], given: float) -> tuple[bool, str]:
        if self._is_between(part, given):
            return True, ""
        for other in part["alternatives"]:
            if self._is_between(other, given):
                return False, other["alternativeFeedbackMessage"]
        return False, ""

    def _is_between(self, part: Mapping[str, Any], given: float) -> bool:
        low, high = (self._bound(part[key]) for key in ("minValue", "maxValue"))
        room = 1e-9 * max(abs(low), abs(high))
        return low - room <= given <= high + room

    def _bound(self, text: str) -> float:
        """A number, an element of a list, or a number of another variant only."""
        if (found := re.fullmatch(rf"if\({shape.VARIANT}=(\d+),(.+),infinity\)", text)) is not None:
            return float(found[2]) if int(found[1]) == self.variant else float("inf")
        name = text.partition("[")[0]
        return self.bounds[name][self.variant] if name in self.bounds else float(text)


def read(directory: Path) -> Mapping[str, NumbasQuestion]:
    """The questions of the exam, those for numbers in all variants. Raises InputError for what Numbas would refuse."""
    try:
        text = (directory / FILE).read_text("utf-8")
        if not text.startswith("// Numbas version: "):
            raise InputError(Message("{file} is not as it was written", file=FILE))
        exam = json.loads(text.partition("\n")[2])
    except ValueError as error:
        raise InputError(Message("{file} cannot be read: {why}", file=FILE, why=type(error).__name__)) from error
    found: dict[str, NumbasQuestion] = {}
    for group in exam["question_groups"]:
        for question in group["questions"]:
            for name, own in _variants(question):
                if name in found:
                    raise InputError(Message("{file} has two questions named {name}", file=FILE, name=name))
                found[name] = own
    return found


def _variants(question: Mapping[str, Any]) -> Iterator[tuple[str, NumbasQuestion]]:
    defined = {name: variable["definition"] for name, variable in question["variables"].items()}
    points, later = (_points(defined.get(name, "")) for name in (shape.POINTS, shape.LATER))
    bounds = {name: json.loads(defined[name]) for name in (shape.LOW, shape.HIGH) if name in defined}
    name = question["name"]
    n = len(bounds.get(shape.LOW, ())) or 1
    for k in range(n):
        own = NumbasQuestion(question["parts"], points, later, k, bounds)
        yield (f"{name} #{k + 1}" if n > 1 else name), own


def _points(definition: str) -> list[dict[str, float]]:
    """Dictionaries are written as lists of pairs with a colon."""
    return [json.loads(f"{{{inside}}}") for inside in _STATED.findall(definition[1:-1])]
