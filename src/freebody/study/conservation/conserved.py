"""What is conserved: for every motion, for none, or under which conditions.

The rate of a quantity is reduced to independent coordinates and speeds. It vanishes for every motion if and only if
all its coefficients do (`symbolic/vanishing.py`); these contain parameters and given functions of time, which gives the
conditions. Masses, inertias, sizes of bodies and gravity are taken to be there; offsets, angles of lines, strengths of
other loads and whatever the file allows to be zero may vanish.

Every verdict is confirmed by simulation: a conserved quantity stays within 1e-9, another one visibly changes.
"""

from __future__ import annotations

from dataclasses import replace

from freebody.errors import ModelError, Problem
from freebody.language.expression import free_symbols
from freebody.language.notation import to_python
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.study.conservation.conservation import Conservation
from freebody.study.conservation.constancy import (
    N_IN_SEARCH,
    N_MOTIONS,
)
from freebody.study.conservation.judge import Judge
from freebody.study.conservation.natural import candidates
from freebody.study.conservation.verdicts import Verdicts
from freebody.study.setup import Setup
from freebody.study.worded import in_words
from freebody.system.system import System


@in_words
def conserved(system: System, question: str | None = None) -> Conservation:
    """Judges the quantities asked for in words, or by the questions of the model; without any, searches.

    Raises ModelError if the system cannot be assembled or the question cannot be read."""
    if system.blows:
        return _between_blows(system, question)
    if system.bounds or system.dry_friction:
        from freebody.study.settled import settled

        found = conserved(settled(system), question)
        note = Message(
            "as long as no contact opens, closes, or begins or ends to slip; what follows is judged by solve"
        )
        told = tuple(replace(v, notes=(*v.notes, note)) if v.is_answered else v for v in found.quantities)
        return replace(found, quantities=told)
    given = system.questions if question is None else (_question(system, question),)
    asked = tuple(filter(_is_of_motions, given))
    setup = Setup(system, N_MOTIONS if asked else N_IN_SEARCH)
    if asked:
        judge = Judge(setup)
        return Conservation(system, tuple(judge.answer(q) for q in asked), is_search=False)
    return Conservation(system, tuple(_searched(setup)), is_search=True)


def _between_blows(system: System, question: str | None) -> Conservation:
    """What holds as long as no blow comes: of what happens in it nothing is said."""
    found = conserved(replace(system, blows=()), question)
    events = ", ".join(blow.name for blow in system.blows)
    note = Message("as long as no blow comes ({events}); what stays the same in it is not judged", events=events)
    told = tuple(replace(v, notes=(*v.notes, note)) if v.is_answered else v for v in found.quantities)
    return replace(found, system=system, quantities=told)


def _question(system: System, text: str) -> Question:
    words = text.strip()
    if "conserved" not in words and not words.startswith("conservation"):
        words = f"is {words} conserved"
    found = system.question(words)
    if not _is_of_motions(found):
        told = Message(
            "{question} is no question of what stays the same along a motion; ask it with solve", question=text
        )
        raise ModelError([Problem((), told)], system.file)
    return found


def _is_of_motions(question: Question) -> bool:
    """Whether it asks what stays the same along every motion, and not only in a blow."""
    return question.quantity.scope == "every motion" and question.quantity.jump is None


# -- the search -------------------------------------------------------------------------------
def _searched(setup: Setup) -> list[Verdicts]:
    judge = Judge(setup, N_IN_SEARCH)
    found: list[Verdicts] = []
    places: dict[str, int] = {}
    for k, (quantity, name) in enumerate(candidates(setup), 1):
        if judge.is_nothing(quantity):
            continue
        verdict = judge.look(f"c{k}", quantity, name)
        if verdict.value is not None and not _can_change(setup, verdict):
            continue  # constant because it is bound
        key = f"no formula {k}" if verdict.value is None else to_python(verdict.value)
        if key in places:
            verdict = replace(verdict, same_as=found[places[key]].question)
        else:
            places[key] = len(found)
        found.append(verdict)
    return found


def _can_change(setup: Setup, verdict: Verdicts) -> bool:
    """Whether anything in the quantity can change at all."""
    assert verdict.value is not None
    moving = {str(c.name) for c in setup.model.coordinates} | {str(c.name) for c in setup.model.dependent}
    functions = {p.name for p in setup.system.parameters.values() if p.form is not None}
    return bool(free_symbols(verdict.value) & (moving | functions | {"t"}))
