"""The checks that every kind of question passes, to be run on your own.

    from freebody.testing.questions import QUESTION_CHECKS, check_question
    check_question("instant centre")                # all of them; raises AssertionError with what does not hold

A kind is named as in `Quantity.kinds`; its `example` is the model, with the question `it`. With pytest:
`@pytest.mark.parametrize("name", QUESTION_CHECKS)`.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any, cast

from freebody.api import System
from freebody.language.expression import Symbol
from freebody.language.notation import to_latex
from freebody.model.names import Names
from freebody.narrative.explain import Explanation
from freebody.narrative.sheets.asking import asking, headline
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.words import languages
from freebody.questions.base import Path, Quantity
from freebody.questions.forms import FORMS, Form, Found
from freebody.questions.reading import Question
from freebody.questions.reading_when import is_of_start
from freebody.study.answering.answer import Answer
from freebody.study.answering.crosscheck import element_at
from freebody.study.setup import Setup
from freebody.testing.conformance import equal

Check = Callable[[str], None]
QUESTION_CHECKS: dict[str, Check] = {}


def check_question(kind: str) -> None:
    """All checks of a kind of question. Raises AssertionError."""
    for check in QUESTION_CHECKS.values():
        check(kind)


def _of_questions(check: Check) -> Check:
    QUESTION_CHECKS[check.__name__] = check
    return check


@cache
def example_of(kind: str) -> System:
    """The smallest model in which it is asked for."""
    return System.from_text(Quantity.kinds[kind].example)


@cache
def _explained(kind: str) -> Explanation:
    return example_of(kind).explain("it")


def explained(kind: str, language: str) -> Explanation:
    """The derivation of the answer, as it is told in a language."""
    return replace(_explained(kind), language=language)


def asked_in(kind: str) -> Question:
    """The question `it` of the example."""
    (question,) = (q for q in example_of(kind).questions if q.id == "it")
    return question


def quantity_in(kind: str) -> Quantity:
    """What it asks for: a quantity of the kind, or one that is about such a quantity."""
    q = asked_in(kind).quantity
    return next((one for one in (q, *q.inner) if one.kind == kind), q)


def _answer(kind: str) -> Answer:
    return explained(kind, "en").solution["it"]


@_of_questions
def is_described_and_asked_for_in_its_example(kind: str) -> None:
    """It has a docstring; the words of the example are read as this kind."""
    assert (Quantity.kinds[kind].__doc__ or "").strip(), f"{kind} has no docstring"
    assert quantity_in(kind).kind == kind, f"the example of {kind} asks for {asked_in(kind).quantity.kind}"
    assert all(form.form for form in FORMS)
    silent = forms_without_example(tuple(FORMS))
    assert not silent, f"no example asks in the words {silent}"


@cache
def forms_without_example(forms: tuple[Form, ...]) -> tuple[str, ...]:
    """Those of the forms of the grammar in whose words no example asks: neither that of a kind nor their own."""
    read: set[str] = set()

    def heard(form: Form) -> Form:
        def reading(names: Names, found: Found, path: Path) -> Quantity | None:
            read.add(form.form)
            return form.read(names, found, path)

        return replace(form, read=reading)

    try:
        FORMS[:] = [heard(form) for form in forms]
        for model in (*(kind.example for kind in Quantity.kinds.values()), *(form.example for form in forms)):
            if model:
                System.from_text(model)
    finally:
        FORMS[:] = forms
    return tuple(form.form for form in forms if form.form not in read)


@_of_questions
def question_written_back_is_the_same(kind: str) -> None:
    """Reading, writing and reading again asks the same."""
    system = example_of(kind)
    again = System.from_text(system.to_yaml())
    assert again.questions == system.questions
    assert hash(again.questions[0].quantity) == hash(system.questions[0].quantity)


@_of_questions
def is_answered_or_refused_in_words(kind: str) -> None:
    """With evidence and the scope in which it holds, or with a reason."""
    answer = _answer(kind)
    if answer.expression is None:
        assert answer.reason, f"{kind} is neither answered nor refused"
        return
    assert answer.evidence is not None, f"the answer to {kind} was not compared with the numeric route"
    assert answer.value is not None or answer.why_no_value, f"nothing says why {kind} has no value"


@_of_questions
def has_a_dimension_and_a_unit(kind: str) -> None:
    """The quantity has a dimension and a unit, and the answer shows one."""
    q = quantity_in(kind)
    assert str(q.dimension)
    assert q.unit
    assert _answer(kind).unit or q.scope == "rest"  # of a reserve beside bare numbers no unit is known


@_of_questions
def value_over_a_state_is_the_same_by_both_routes(kind: str) -> None:
    """A property of an instant: its formula at random poses and speeds, and the dense numeric solution there."""
    q = quantity_in(kind)
    if q.scope != "instant" or q.is_of_coordinates or q.wanted is not None or q.has_finder:
        return
    setup = Setup(example_of(kind))
    starts = is_of_start(q)
    form: Any = q.value(setup.system, setup.start_instant if starts else setup.state)
    parts = cast("tuple[Any, ...]", form) if isinstance(form, tuple) else (form,)
    elements = tuple(setup.model.field.element(x) for x in parts)
    seen = [draw.start() for draw in setup.draws] if starts else setup.anywhere
    for draw, snapshot in zip(setup.draws, seen, strict=True):
        numbers: Any = q.value(setup.system, snapshot)
        listed = cast("tuple[Any, ...]", numbers) if isinstance(numbers, tuple) else (numbers,)
        for exact, number in zip(element_at(setup, elements, draw, snapshot), listed, strict=True):
            equal(float(number), exact, f"value of {kind}", relative=1e-8, absolute=1e-8)


@_of_questions
def is_said_in_every_language(kind: str) -> None:
    """As a sentence of an exercise and as a title: no place of a pattern is left open."""
    system, question = example_of(kind), asked_in(kind)
    for language in languages():
        catalogue = Catalogue(language)
        for said in (asking(system, question), headline(system, question)):
            text = catalogue.plain(said)
            assert text.strip()
            assert "{" not in text, f"{kind} in {language}: {text}"


@_of_questions
def has_a_symbol(kind: str) -> None:
    """LaTeX has a name for it."""
    assert to_latex(Symbol(quantity_in(kind).letter)).strip()


@_of_questions
def is_written_as_json(kind: str) -> None:
    """The answer for machines has the question, and what was found."""
    plain = json.loads(json.dumps(_answer(kind).to_plain()))
    assert plain["id"] == "it"
    assert plain["question"] == asked_in(kind).text


@_of_questions
def is_derived_or_refused_in_words_and_reported(kind: str) -> None:
    """In every language: stages that end in the answer, or the reason why there are none; a page says so."""
    for language in languages():
        found = explained(kind, language)
        (derivation,) = found.derivations
        assert derivation.stages or derivation.reason, f"{kind} is neither derived nor refused"
        assert "<html" in found.to_html()
        assert found.to_text().strip()
