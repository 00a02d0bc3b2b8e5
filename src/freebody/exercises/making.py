"""A bank from systems: statements, variants and keys as sheets have them, mistakes and their words as marking has."""

from __future__ import annotations

import math
import re
import unicodedata
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import Any, cast

from freebody.assess.numbers import Tolerance
from freebody.errors import FreebodyError
from freebody.exercises.bank import Bank, Given, Item, ItemVariant, Kind, ShownOption, SymbolUsed, Value, WrongAnswer
from freebody.exercises.sampling import sampling_of
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate, free_symbols
from freebody.language.notation import to_python
from freebody.language.parser import parse
from freebody.language.plain_text import plain, shortened
from freebody.language.raising import raised
from freebody.language.sentences import Argument, Sentence
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.narrative.context import Context
from freebody.narrative.lines.script import ready
from freebody.narrative.marking.authoring import proposed_options
from freebody.narrative.marking.check import marked_by
from freebody.narrative.mistakes.mistakes import found_mistakes
from freebody.narrative.sheets.answer_key import key_of
from freebody.narrative.sheets.asking import headline
from freebody.narrative.sheets.in_numbers import options_in_numbers
from freebody.narrative.sheets.sheet import Sheet, sheet
from freebody.narrative.sheets.statement import ExerciseStatement, title_of
from freebody.narrative.sheets.variants import Variant
from freebody.narrative.sheets.worked import as_solution
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.house import in_style
from freebody.present.report.blocks import Block, Figure, Text
from freebody.progress import busy_with
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.solution import Solution
from freebody.study.answering.solve import solve
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System

_LONGEST_ID = 60
_LONGEST_NAME = 200  # characters; platforms keep some 255
_NO_ID = re.compile(r"[^a-z0-9]+")


def made_bank(
    systems: Sequence[System],
    *,
    variants: int = 1,
    seed: int = 0,
    language: str = "en",
    tolerance: str = "1 %",
    numeric: bool = False,
) -> Bank:
    """The questions of some systems. variants, seed: as in `sheet`; tolerance: for numbers, as '1 %', '0.05 N' or
    '3 digits'; numeric: options are shown as the numbers that they give. Raises InputError and ModelError as `sheet`
    does."""
    allowed = Tolerance.read(tolerance)
    made = sheet(systems, variants=variants, seed=seed, language=language, numeric=numeric)
    catalogue = Catalogue(language)
    items: list[Item] = []
    for k in range(len(made.systems)):
        items += _SystemItems(made, k, catalogue, allowed, {item.id for item in items}).items()
    title = items[0].title if len(made.systems) == 1 else catalogue.word("sheet.title")
    told = {name: catalogue.word(f"exercise.{name}") for name in ("hint", "solution")}
    return Bank(title, language, _with_own_names(items), catalogue.report_words | told, made.variants, made.seed)


class _SystemItems:
    """Those of one system. taken: ids that others have."""

    def __init__(self, made: Sheet, k: int, catalogue: Catalogue, tolerance: Tolerance, taken: set[str]) -> None:
        self.system = made.systems[k]
        self.variants: list[Variant] = [made.variant(n)[k] for n in range(1, made.variants + 1)]
        self.sheet, self.catalogue, self.tolerance, self.taken = made, catalogue, tolerance, taken
        self.context = Context(self.system)

    def items(self) -> Iterator[Item]:
        for k, question in enumerate(self.system.questions):
            busy_with(f"making an exercise of {question.id}: {question.text}")
            yield self._item(k, question)

    def _item(self, k: int, question: Question) -> Item:
        system, answer = self.system, self.variants[0].solution.answers[k]
        statement = ExerciseStatement(system, self.catalogue, 1, 1)
        title = title_of(system, self.catalogue)
        kind = kind_of(question, answer)
        wrong = tuple(self._wrong(k, question, kind))
        variants = tuple(self._variant(n, k, wrong) for n in range(1, len(self.variants) + 1))
        is_count = question.quantity.scope == "structure"
        tolerance = Tolerance() if is_count else self.tolerance
        labels = _labels(system, question, answer)
        return Item(
            self._id(question),
            shortened(plain(f"{title}: {self.catalogue.plain(headline(system, question))}"), _LONGEST_NAME),
            title,
            self.catalogue.language,
            in_style(statement.model(is_bare=True), system.style),
            in_style(statement.prompt(question), system.style),
            kind,
            answer.expression,
            _unit(answer),
            tuple(self._equivalent(self.variants[0].system.questions[k], answer, kind)),
            wrong,
            tuple(_symbols(system)),
            tuple(self.catalogue.tell(Sentence("exercise.condition", {"text": ready(c)})) for c in answer.conditions),
            "" if answer.is_answered or answer.conditions else answer.reason,
            tolerance,
            self._number_prompt(answer, tolerance, labels, is_count),
            1.0 if question.points is None else question.points,
            sampling_of(answer),
            variants,
            labels,
        )

    def _id(self, question: Question) -> str:
        stem = Path(self.system.file).stem if self.system.file else self.system.title
        letters = unicodedata.normalize("NFKD", f"{stem}_{question.id}".lower())
        own = _NO_ID.sub("_", "".join(c for c in letters if not unicodedata.combining(c))).strip("_")[:_LONGEST_ID]
        own = own if own[:1].isalpha() else f"exercise_{own}".strip("_")
        found = next(name for n in range(1, 10**6) if (name := own if n == 1 else f"{own}_{n}") not in self.taken)
        self.taken.add(found)
        return found

    # -- one variant --------------------------------------------------------------------------
    def _variant(self, n: int, k: int, wrong: Sequence[WrongAnswer]) -> ItemVariant:
        system, solution = self.variants[n - 1].system, self.variants[n - 1].solution
        question, answer = system.questions[k], solution.answers[k]
        numbers = options_in_numbers(system, question, answer) if self.sheet.in_numbers else None
        statement = ExerciseStatement(system, self.catalogue, 1, 1, numbers=numbers)
        model = in_style(statement.model(), system.style)
        options: list[ShownOption] = []
        for letter, text in question.options.items():
            verdict = answer.options.get(letter)
            if verdict is not None and verdict.verdict != "unreadable":
                is_right = verdict.verdict == "right"
                said = (self.catalogue.word("marking.correct"),)
                if not is_right:
                    said = self._feedback(verdict.reason, self.mistakes[question.id].get(text))
                shown = in_style(statement.option(text), system.style)
                options.append(ShownOption(letter, text, shown, is_right, said))
        solved, hints = self._worked(self.variants[n - 1], k)
        return ItemVariant(
            n,
            tuple(_given(system)),
            model,
            next((block for block in model if isinstance(block, Figure)), None),
            tuple(options),
            answer.value,
            tuple(_value_of(w.text, system) for w in wrong),
            key_of(answer, ""),
            solved,
            hints,
        )

    def _worked(self, variant: Variant, k: int) -> tuple[tuple[Block, ...], tuple[Text, ...]]:
        """The worked solution, and what one should try oneself at each of its steps."""
        from freebody.narrative.explain import explain_solved

        found = explain_solved(variant.system, variant.solution, k, language=self.catalogue.language)
        hints = [self.catalogue.tell(s.hint) for d in found.derivations for s in d.stages if s.hint is not None]
        return as_solution(found.report.blocks, (1,), equations=0, figures=1), tuple(dict.fromkeys(hints))

    # -- answers ------------------------------------------------------------------------------
    def _feedback(self, reason: str, mistake: Sentence | None) -> Text:
        """Why an answer is what it is, and the mistake that leads to it."""
        said = self.catalogue.tell(Sentence("exercise.reason", {"reason": ready(reason)})) if reason else ()
        leads = () if mistake is None else self.catalogue.tell(mistake)
        return in_style((*said, *((" ",) if said and leads else ()), *leads), self.system.style)

    def _wrong(self, k: int, question: Question, kind: Kind) -> Iterator[WrongAnswer]:
        """The wrong options, and the results of mistakes that are no options."""
        answer = self.variants[0].solution.answers[k]
        shown = self.variants[0].system.questions[k].options
        mistakes = self.mistakes[question.id]
        known: set[str] = set()
        for letter, verdict in answer.options.items():
            if verdict.verdict == "wrong":
                text = shown[letter]
                known.add(text)
                mistake = mistakes.get(text)
                yield WrongAnswer(text, _key_of(mistake), self._feedback(verdict.reason, mistake), is_option=True)
        if kind != "formula":
            return
        for option in proposed_options(marked_by(self.system, question, self.solved.answers[k])):
            if option.text not in known:
                yield WrongAnswer(option.text, _key_of(option.said), self._feedback("", option.said))

    @cached_property
    def solved(self) -> Solution:
        """As the file has it."""
        first = self.variants[0]
        return first.solution if first.system is self.system else solve(self.system)

    @cached_property
    def mistakes(self) -> Mapping[str, Mapping[str, Sentence]]:
        """By question and by the text of an option: the mistake that leads to it."""
        found: dict[str, Mapping[str, Sentence]] = {}
        for question, answer in zip(self.system.questions, self.solved.answers, strict=True):
            by_letter = found_mistakes(self.context, question, answer)
            found[question.id] = {question.options[letter]: said for letter, said in by_letter.items()}
        return found

    def _equivalent(self, question: Question, answer: Answer, kind: Kind) -> Iterator[str]:
        """Other ways to write the answer: that of the right option, and a quotient of sums."""
        if answer.expression is None or kind == "words":
            return
        own = as_text(answer.expression)
        found = [question.options[k] for k, v in answer.options.items() if v.verdict == "right" and v.is_proved]
        found += [as_text(answer.form)] if answer.form else []
        element = None if answer.solved is None else answer.solved.element
        if kind == "formula" and isinstance(element, Ratio):
            found.append(as_text(element.field.expression(element)))
        yield from (text for text in dict.fromkeys(found) if text != own)

    def _number_prompt(self, answer: Answer, tolerance: Tolerance, labels: Sequence[str], is_count: bool) -> Text:
        if is_count:
            return (self.catalogue.word("exercise.whole_number"),)
        in_turn = f" {self.catalogue.word('exercise.smallest_first')}" if "1" in labels else ""
        unit = raised(_unit(answer))
        args: dict[str, Argument] = {"unit": f"@{unit}", "off": f"@{_told(tolerance, unit)}", "n": tolerance.digits}
        key = "exercise.number_to" if tolerance.digits else "exercise.number"
        told = self.catalogue.tell(Sentence(key if unit else f"{key}_plain", args))
        return in_style((*told, *([in_turn] if in_turn else [])), self.system.style)


def kind_of(question: Question, answer: Answer) -> Kind:
    """What is to be found, whether or not there are options. A range is told by its ends where both are asked for, and
    else by an inequality."""
    if answer.verdict or question.quantity.is_verdict or (answer.expression is None and answer.value is None):
        return "words"
    is_range = (question.understood or question.text).startswith("range ")
    if is_range and not (question.quantity.scope == "rest" and isinstance(answer.value, tuple)):
        return "words"
    if isinstance(answer.expression, tuple) or isinstance(answer.value, tuple):
        return "vector"
    return "formula" if answer.expression is not None and free_symbols(answer.expression) else "number"


def _labels(system: System, question: Question, answer: Answer) -> tuple[str, ...]:
    """Of the components of a vector, or of several values by their size. Nothing where they are neither, as the
    amplitudes of a mode shape are."""
    values, q = answer.value, question.quantity
    if not isinstance(values, tuple):
        return ()
    if q.scope in ("instant", "course") and q.wanted is None and not q.is_any_of_several:
        axes = tuple(axis for axis, _component in q.components(system))
        return axes if len(axes) == len(values) else ("x", "y", "z")[: len(values)]
    if len(set(values)) < len(values) or (q.scope == "small motion" and q.dimension == DIMENSIONLESS):
        return ()
    return tuple(str(k) for k in range(1, len(values) + 1))


def as_text(expression: Expr | Sequence[Expr]) -> str:
    """A formula, or the parts of a vector, in the notation of models."""
    parts = (expression,) if isinstance(expression, Expr) else expression
    texts = [to_python(part).replace("**", "^") for part in parts]
    return texts[0] if isinstance(expression, Expr) else f"[{', '.join(texts)}]"


def _key_of(mistake: Sentence | None) -> str:
    """The key of the mistake behind a wrong answer; of the first of two."""
    first = None if mistake is None else mistake.args.get("first")
    return first.key if isinstance(first, Sentence) else ""


def _unit(answer: Answer) -> str:
    return "" if answer.unit in ("", "1") else answer.unit


def _told(tolerance: Tolerance, unit: str) -> str:
    if tolerance.relative:
        return f"{100 * tolerance.relative:g} %"
    return f"{tolerance.absolute:g} {unit}".strip()


def _symbols(system: System) -> Iterator[SymbolUsed]:
    for p in system.parameters.values():
        yield SymbolUsed(p.name, _as_unit(p.dimension), p.sign, p.is_angle)
    for name, measure in system.measures.items():
        yield SymbolUsed(name, _as_unit(measure.dimension), "any", measure.dimension == DIMENSIONLESS, is_moving=True)


def _as_unit(dimension: Dimension) -> str:
    return "" if dimension == DIMENSIONLESS else str(dimension)


def _given(system: System) -> Iterator[Given]:
    """The parameters that have values, as the file has them."""
    data = cast("dict[str, Any]", system.document.data.get("parameters") or {})
    for p in system.parameters.values():
        if p.value is not None and p.form is None:
            entry = data.get(p.name)
            text = cast("dict[str, Any]", entry).get("value") if isinstance(entry, dict) else entry
            yield Given(p.name, str(text), p.value)


def _value_of(text: str, system: System) -> Value:
    """What a formula gives at the numbers of a system; None where it gives nothing."""
    values = {p.name: p.value for p in system.parameters.values() if p.value is not None}
    inside = text.strip()
    parts = inside[1:-1].split(",") if inside.startswith("[") and inside.endswith("]") else [inside]
    try:
        found = tuple(float(evaluate(parse(part.strip()), values, FLOAT_FUNCTIONS)) for part in parts)
    except (FreebodyError, KeyError, ValueError, ArithmeticError, TypeError):
        return None
    if not all(map(math.isfinite, found)):
        return None
    return found[0] if len(found) == 1 else found


def _with_own_names(items: Sequence[Item]) -> tuple[Item, ...]:
    """Items whose names are different: those that are not have their ids behind them."""
    counted = Counter(item.name for item in items)
    return tuple(item if counted[item.name] == 1 else replace(item, name=f"{item.name} ({item.id})") for item in items)
