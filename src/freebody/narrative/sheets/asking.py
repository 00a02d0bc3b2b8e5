"""A question of a model as a sentence of an exercise."""

from __future__ import annotations

from dataclasses import replace
from functools import singledispatch

from freebody.errors import ExpressionError
from freebody.language.expression import Symbol, free_symbols
from freebody.language.parser import parse
from freebody.language.sentences import NOTHING, Argument, Sentence
from freebody.narrative.bounds import number_with_unit
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.conservation import Conserved
from freebody.questions.course import Transition
from freebody.questions.event import Anywhere, ChangeEvent, ExtremeEvent, OfQuantity
from freebody.questions.motion import rates_of
from freebody.questions.reading import Question
from freebody.questions.rest import FirstFailure, Holds, RestLimit
from freebody.questions.steady import SteadyStability
from freebody.system.system import System


def asking(system: System, question: Question) -> Sentence:
    """What is to be found, in a sentence. What has no words of its own is quoted from the model."""
    return _asking(question.quantity, system, question)


@singledispatch
def _asking(q: Quantity, system: System, question: Question) -> Sentence:
    of = q.sentence(system)
    if of is None:
        return Sentence("ask.any", {"text": question.text})
    return Sentence("ask.find", {"what": of, "when": _when(question, system)})


@_asking.register(Conserved)
def _asking_conserved(q: Conserved, system: System, question: Question) -> Sentence:
    return Sentence("ask.conserved", {"what": q.of.sentence(system) or q.name})


@_asking.register(RestLimit)
def _asking_rest(q: RestLimit, system: System, question: Question) -> Sentence:
    if q.without:
        return Sentence("ask.any", {"text": question.text})
    slips = "_slip" if q.is_of_slip else ""
    return Sentence(f"ask.rest_{q.which}{slips}", {"parameter": Symbol(q.parameter)})


@_asking.register(FirstFailure)
def _asking_failure(q: FirstFailure, system: System, question: Question) -> Sentence:
    return Sentence("ask.first_failure", {"parameter": Symbol(q.parameter)})


@_asking.register(SteadyStability)
def _asking_stability(q: SteadyStability, system: System, question: Question) -> Sentence:
    return Sentence("ask.steady_stability")


@_asking.register(Holds)
def _asking_holds(q: Holds, system: System, question: Question) -> Sentence:
    return Sentence("ask.any", {"text": question.text}) if q.without else Sentence("ask.rest_holds")


def headline(system: System, question: Question) -> Sentence:
    """What is asked for, as a title has it."""
    return _headline(question.quantity, system, question)


@singledispatch
def _headline(q: Quantity, system: System, question: Question) -> Sentence:
    of = q.sentence(system)
    if of is None:
        return Sentence("ask.quoted", {"text": question.text})
    return Sentence("ask.headline", {"what": of, "when": _when(question, system)})


@_headline.register(Conserved)
def _headline_conserved(q: Conserved, system: System, question: Question) -> Sentence:
    of = q.of.sentence(system)
    return Sentence("ask.quoted", {"text": question.text}) if of is None else Sentence("ask.conservation", {"what": of})


def _beside_blow(at: Transition, system: System) -> Sentence:
    """Just before or just after a blow, or an impact where nothing strikes but what collides."""
    key = f"ask.{at.kind}_{'blow' if system.blows or system.is_struck else 'impact'}"
    if not at.of:
        return Sentence(key)
    return Sentence(f"{key}_of" if at.count == 1 else f"ask.{at.kind}_nth_of", {"n": at.count, "names": at.of})


def _when(question: Question, system: System) -> Argument:
    """At which instant it is meant."""
    q = question.quantity
    word = "time" if q.is_of_event else "until" if q.scope == "course" else "when"
    if question.at_start and not question.quantity.is_of_start:  # an impact says itself when it is
        return Sentence("ask.after_blow" if system.is_struck else "ask.at_start")
    if question.transition is not None and question.event is not None:  # the first such event behind a blow
        behind = {"when": _when(replace(question, transition=None), system), "n": question.transition.count}
        return Sentence("ask.behind_blow", behind)
    if question.transition is not None and question.transition.count > 1 and question.transition.of == ():
        return Sentence(f"ask.{question.transition.kind}_nth", {"n": question.transition.count})
    if question.transition is not None and question.transition.kind in ("before", "after"):
        return _beside_blow(question.transition, system)
    if question.transition is not None:
        return Sentence(f"ask.{word}_transition", {"text": question.transition.text})
    if question.event is None:
        return NOTHING
    if isinstance(question.event, Anywhere):
        return Sentence("ask.function", {"of": Symbol(question.event.name)})
    if isinstance(question.event, Clock):
        time = question.event.time
        return Sentence("ask.endless") if time is None else Sentence("ask.clock", {"time": time})
    if isinstance(question.event, ExtremeEvent):
        of = None if question.event.quantity is None else question.event.quantity.sentence(system)
        what = parse(question.event.phrase) if question.event.phrase in system.measures else question.event.phrase
        return Sentence(f"ask.{word}_{question.event.end}", {"what": what if of is None else of})
    if isinstance(question.event, OfQuantity):
        of = question.event.quantity.sentence(system)
        if of is not None:
            return Sentence(f"ask.{word}_quantity", {"what": of, "value": question.event.target})
        return _worded(question.event.text, word)
    event = question.event
    if isinstance(event, ChangeEvent):
        what = parse(event.phrase) if event.phrase in system.measures else event.phrase
        by = event.change if free_symbols(event.change) else event.value_text  # a number with its unit
        return Sentence(f"ask.{word}_{'distance' if event.is_distance else 'change'}", {"what": what, "by": by})
    name = next((name for name, measure in system.measures.items() if measure == event.measure), None)
    if name is not None:
        again = "_again" if event.text.endswith(" again") else ""
        right = number_with_unit(event.value, event.measure.dimension, event.order)
        return Sentence(f"ask.{word}{again}", {"left": rates_of(name, event.order), "right": right})
    left, equals, _right = event.text.partition("=")
    try:
        if equals and " of " not in left:  # else words
            return Sentence(f"ask.{word}", {"left": parse(left.strip()), "right": event.value})
    except ExpressionError:
        pass
    return _worded(question.event.text, word)


def _worded(event: str, word: str) -> Sentence:
    """When something is, as it was asked: a quantity that has a value, or what happens."""
    what, equals, value = (part.strip() for part in event.partition("="))
    if equals:
        return Sentence(f"ask.{word}_quantity", {"what": what, "value": value})
    return Sentence("ask.when_transition", {"text": event})
