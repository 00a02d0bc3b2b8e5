"""A question of a model as a sentence of an exercise."""

from __future__ import annotations

from functools import singledispatch

from freebody.errors import ExpressionError
from freebody.language.parser import parse
from freebody.language.sentences import NOTHING, Argument, Sentence
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.conservation import Conserved
from freebody.questions.event import OfQuantity
from freebody.questions.reading import Question
from freebody.system.system import System


def asking(system: System, question: Question) -> Sentence:
    """What is to be found, in a sentence. What has no words of its own is quoted from the model."""
    return _asking(question.quantity, system, question)


@singledispatch
def _asking(q: Quantity, system: System, question: Question) -> Sentence:
    of = q.sentence(system)
    if of is None:
        return Sentence("ask.any", {"text": question.text})
    return Sentence("ask.find", {"what": of, "when": _when(system, question)})


@_asking.register(Conserved)
def _asking_conserved(q: Conserved, system: System, question: Question) -> Sentence:
    return Sentence("ask.conserved", {"what": q.of.sentence(system) or q.name})


def headline(system: System, question: Question) -> Sentence:
    """What is asked for, as a title has it."""
    of = question.quantity.sentence(system)
    if of is None:
        return Sentence("ask.quoted", {"text": question.text})
    return Sentence("ask.headline", {"what": of, "when": _when(system, question)})


def _when(system: System, question: Question) -> Argument:
    """At which instant it is meant."""
    q = question.quantity
    word = "time" if q.is_of_event else "until" if q.scope == "course" else "when"
    if question.at_start and not question.quantity.is_of_start:  # an impact says itself when it is
        return Sentence("ask.at_start")
    if question.transition is not None:
        return Sentence(f"ask.{word}_transition", {"text": question.transition.text})
    if question.event is None:
        return NOTHING
    if isinstance(question.event, Clock):
        time = question.event.time
        return Sentence("ask.endless") if time is None else Sentence("ask.clock", {"time": time})
    if isinstance(question.event, OfQuantity):
        of = question.event.quantity.sentence(system)
        if of is not None:
            return Sentence(f"ask.{word}_quantity", {"what": of, "value": question.event.target})
    left, equals, _right = question.event.text.partition("=")
    try:
        if equals:
            reached = {"left": parse(left.strip()), "right": question.event.value}
            return Sentence(f"ask.{word}", reached)
    except ExpressionError:
        pass
    return Sentence("ask.when_transition", {"text": question.event.text})
