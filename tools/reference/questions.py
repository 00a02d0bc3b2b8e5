"""Questions: a section for each file of `freebody.questions`, with its words and a solved example of every kind."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from importlib import import_module
from types import ModuleType

import freebody as fb
import freebody.questions.reading  # every file of questions is imported for it
from freebody.questions.base import Quantity
from freebody.questions.forms import FORMS, Form
from reference.page import NothingSaid, Page, block, code, first_paragraph, joined, prose, words_of

_HEAD = """Each section has the words of the grammar for a family of questions: capitals stand for names and
phrases of the model, brackets for what may be left out, `|` for alternatives. People's own words are put into
these (see [Questions](../guide/questions.md)). Below the words every kind of question is asked in the smallest
model in which it makes sense, with the answer that freebody prints."""
_WIDTH = 88


def pages() -> Iterator[Page]:
    files = {kind.__module__ for kind in Quantity.kinds.values() if kind.__module__.startswith("freebody.")}
    modules = sorted((import_module(name) for name in files), key=_title)
    text = joined(["# Questions", _HEAD, *map(_section, modules)])
    yield Page("questions", "Questions", "the words that ask, units, solved examples", 50, text)


def _title(module: ModuleType) -> str:
    """What the questions of a file are about."""
    said = first_paragraph(inspect.cleandoc(module.__doc__ or ""))
    if not said:
        raise NothingSaid(f"{module.__name__} has no docstring")
    said = said.partition(": ")[0].removesuffix(".").removeprefix("Questions about ").removeprefix("Questions ")
    said = said.removeprefix("The question ")
    return said[0].upper() + said[1:]


def _section(module: ModuleType) -> str:
    own = [form for form in FORMS if form.read.__module__ == module.__name__]
    forms = [form.form for form in own]
    kinds = [kind for _name, kind in sorted(Quantity.kinds.items()) if kind.__module__ == module.__name__]
    asked = [_form(form) for form in own if form.example]
    return joined([f"## {prose(_title(module))}", block("text", "\n".join(forms)), *map(_kind, kinds), *asked])


def _form(form: Form) -> str:
    """Words that the example of no kind has, in a model of their own."""
    solution = fb.System.from_text(form.example).solve()
    words = f"So one asks in the words `{form.form}`:"
    return joined([words, block("yaml", form.example), block("text", printed(solution))])


def _kind(kind: type[Quantity]) -> str:
    """What is asked, a model, and the answer as it is printed."""
    if not kind.example.strip():
        raise NothingSaid(f"the question {kind.kind} has no example")
    solution = fb.System.from_text(kind.example).solve()
    answer = solution["it"]
    return joined(
        [
            f"### {kind.kind.capitalize()}",
            first_paragraph(words_of(kind, f"the question {kind.kind}")),
            block("yaml", kind.example),
            f"{code(answer.question)} is answered, in {answer.unit}:"
            if answer.unit != "1"
            else f"{code(answer.question)}:",
            block("text", printed(solution)),
        ]
    )


def printed(solution: fb.Solution) -> str:
    """The answers as the terminal shows them, without the title and without what depends on round-off."""
    text = solution.to_text(_WIDTH)
    _title, _, rest = text.partition("\n\n")
    lines = rest.splitlines()
    end = next((k for k, line in enumerate(lines) if line.strip().startswith("evidence")), len(lines))
    return "\n".join(lines[:end]).rstrip()
