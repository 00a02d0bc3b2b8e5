"""Reading questions: what is asked, when it is meant, and the options to choose from.

    QUANTITY [at start | when MEASURE = VALUE]        time when MEASURE = VALUE

The grammar of quantities is the table `FORMS`; error messages and the documentation list it.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, cast

from freebody.language.expression import Expr
from freebody.language.plain_text import plain
from freebody.language.sentences import Message
from freebody.language.units import TIME
from freebody.measures.base import Measure
from freebody.model.names import Names, did_you_mean
from freebody.model.phrases import PHRASES, measure_of, phrase_text, read_measure
from freebody.questions.base import FORMS, Path, Quantity
from freebody.questions.course import Counted, Transition, When, as_condition, read_transition
from freebody.questions.motion import OfMeasure


@dataclass(frozen=True)
class QuestionEvent:
    """A measure (or its rate) reaches a value."""

    measure: Measure
    order: Literal[0, 1]
    value: Expr
    text: str


@dataclass(frozen=True)
class Question:
    """A quantity that is asked for, when it is meant, and the options to choose from."""

    id: str
    text: str
    quantity: Quantity
    event: QuestionEvent | None = None
    at_start: bool = False
    options: Mapping[str, str] = field(default_factory=dict[str, str])
    key: str | None = None
    transition: Transition | None = None  # instead of an event: a contact changes its state


# -- reading ----------------------------------------------------------------------------------
def read_quantity(names: Names, text: str, path: Path) -> Quantity | None:
    if text in names.measures:
        return OfMeasure(names.measures[text], 0, text)
    rate = re.fullmatch(r"rate\((\w+)\)", text)
    if (text if rate is None else rate[1]) in names.broken:
        return None
    if any(phrase.pattern.match(text) for phrase in PHRASES) and not text.startswith("angle of"):
        measure = read_measure(names, text, *path)
        return None if measure is None else OfMeasure(measure, 0, text)
    for form in FORMS:
        found = form.pattern.match(text)
        if found:
            return form.read(names, found.groupdict(), path)
    words = text.split(" of ", maxsplit=1)[0]
    openings = {w: f.form for f in FORMS for w in re.split(r"[|,;]", f.form.split(" of ")[0])}
    close = difflib.get_close_matches(words, [w.strip() for w in openings], n=1, cutoff=0.6)
    if rate is not None and rate[1] in names.measures:
        names.problem(
            Message("cannot read '{text}'. Did you mean: velocity of {measure}", text=text, measure=rate[1]), *path
        )
    elif close:
        form = next(f for w, f in openings.items() if w.strip() == close[0])
        names.problem(Message("cannot read '{text}'. Did you mean: {form}", text=text, form=form), *path)
    elif any(isinstance(p.message, Message) and "askable" in p.message.arguments for p in names.problems):
        names.problem(Message("cannot read '{text}'", text=text), *path)
    else:
        askable = "\n    ".join(f.form for f in FORMS)
        names.unknown(
            text, Message("cannot read '{text}'. One can ask for\n    {askable}", text=text, askable=askable), *path
        )
    return None


def _event(names: Names, text: str, path: Path) -> QuestionEvent | None:
    found = re.match(r"^(?P<what>.+?)\s*(?:=| reaches | is | equals )\s*(?P<value>.+)$", text)
    if found is None:
        names.problem(Message("cannot read the condition '{text}'; write for example x = h", text=text), *path)
        return None
    what = found["what"].strip()
    order: Literal[0, 1] = 0
    for pattern in (r"rate\((.+)\)", r"(?:rate|velocity|speed) of (.+)", r"(.+)'", r"(.+)_dot"):
        inner = re.fullmatch(pattern, what)
        if inner and what not in names.measures:
            order, what = 1, inner[1].strip()
            break
    measure = measure_of(names, what, *path)
    if measure is None:
        return None
    dimension = measure.dimension / TIME**order
    return QuestionEvent(measure, order, names.formula(found["value"].strip(), dimension, *path), text)


def read_questions(names: Names, given: Any) -> tuple[Question, ...]:
    """The questions of a model; a question is a text, or a mapping with find, id, when, options, key."""
    if given is None:
        return ()
    if isinstance(given, dict):
        pairs = list(cast("dict[str, Any]", given).items())
    elif isinstance(given, list):
        pairs = [(f"q{k}", v) for k, v in enumerate(cast("list[Any]", given), 1)]
    else:
        names.problem(Message("questions is a list, e.g. questions: [{{find: acceleration of x}}]"), "questions")
        return ()
    found: list[Question] = []
    for k, (name, value) in enumerate(pairs):
        place = name if isinstance(given, dict) else k
        with names.at("questions", place):
            question = _question(names, name, value)
        if question is not None:
            if any(other.id == question.id for other in found):
                names.problem(Message("two questions have the id {id}", id=question.id), "questions", place, "id")
            found.append(question)
    return tuple(found)


def _question(names: Names, name: str, value: Any) -> Question | None:
    known = ("find", "id", "when", "options", "key")
    phrased = phrase_text(value)
    entry: dict[str, Any] = {}
    if phrased is not None:
        entry = {"find": phrased}
    elif isinstance(value, dict):
        entry = cast("dict[str, Any]", value)
    if not isinstance(entry.get("find"), str):
        names.problem(Message("a question needs find, e.g. {{find: acceleration of x}}"))
        return None
    for key in entry:
        if key not in known:
            names.problem(Message("a question has no {key}.{hint}", key=key, hint=did_you_mean(key, known)), key)
    text = " ".join(str(entry["find"]).split())
    phrase, at_start, event, transition = as_condition(names, text), False, None, None
    if phrase.endswith((" at start", " at the start")):
        phrase, at_start = re.sub(r" at (the )?start$", "", phrase), True
    condition = entry.get("when")
    if condition is None:
        for word in (" when ", " until ", " to reach "):
            if word in phrase:
                phrase, _, condition = phrase.partition(word)
                break
    elif str(condition) in ("start", "at start"):
        at_start, condition = True, None
    if condition is not None:
        where: Path = ("find",) if "when" not in entry else ("when",)
        transition = read_transition(names, str(condition), where)
        event = None if transition is not None else _event(names, str(condition), where)
        if event is None and transition is None:
            return None
    quantity: Quantity | None
    if phrase in ("time", "the time"):
        if event is None and transition is None:
            names.problem(Message("say of what: time when x = h"), "find")
            return None
        quantity = When()
    else:
        quantity = read_quantity(names, phrase, ("find",))
    if quantity is None:
        return None
    if quantity.scope == "every motion" and (condition is not None or at_start):
        names.problem(Message("what is conserved is so at every instant; leave out 'at start' and 'when'"), "find")
        return None
    if isinstance(quantity, Counted) and condition is None:
        names.problem(Message("say until when: {phrase} until {until}", phrase=phrase, until=quantity.until), "find")
    options: Any = entry.get("options") or {}
    if isinstance(options, list):
        letters = "abcdefghijklmnopqrstuvwxyz"
        options = dict(zip(letters, cast("list[Any]", options), strict=False))
    if not isinstance(options, dict):
        names.problem(Message("options is a mapping, e.g. options: {{a: g/2, b: g}}"), "options")
        options = {}
    shown = {plain(str(k)): plain(_option_text(v)) for k, v in cast("dict[Any, Any]", options).items()}
    key = entry.get("key")
    if key is not None and str(key) not in shown:
        names.problem(Message("key {key} is not among the options {shown}", key=key, shown=", ".join(shown)), "key")
    return Question(
        plain(str(entry.get("id", name))),
        plain(text),
        quantity,
        event,
        at_start,
        shown,
        None if key is None else str(key),
        transition,
    )


def _option_text(value: Any) -> str:
    """An option as text; a vector may be written as a list."""
    if isinstance(value, list):
        return "[" + ", ".join(map(str, cast("list[Any]", value))) + "]"
    return str(value)
