"""What the grammar says of words that it does not read, and what that is worth to who reads them in own words."""

from __future__ import annotations

import difflib
import keyword
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol, TypeVar

from freebody.errors import Problem
from freebody.language.sentences import Message
from freebody.questions.spoken import strings
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.lexicon import stands_for_all
from freebody.questions.spoken.naming import elements_of

if TYPE_CHECKING:
    from freebody.model.names import Names
    from freebody.questions.base import Quantity


class Asked(Protocol):
    """What is asked for, as far as it is looked at here."""

    @property
    def quantity(self) -> Quantity: ...
    @property
    def event(self) -> object | None: ...
    @property
    def transition(self) -> object | None: ...
    @property
    def at_start(self) -> bool: ...


AskedT = TypeVar("AskedT", bound=Asked)

_LEAST_LIKE = 0.9  # of the beginning of a text to a form of the grammar
_SHORTEST_WORD = 4  # letters of a word that may not be a symbol
_GENERAL = {"askable", "form", "forms"}  # what messages list where nothing of a text could be read


@dataclass(frozen=True)
class Unread:
    """Why the grammar does not read a text."""

    problems: list[Problem]


def read_quietly(names: Names, text: str, read: Callable[[str], AskedT | None]) -> tuple[AskedT, ...] | Unread:
    """What words of the grammar ask for, of one thing or of several, or why they ask for nothing."""
    with names.quietly():
        n_before = len(names.problems)
        found = [read(one) for one in text.split(JOINT)]
        asked = tuple(one for one in found if one is not None)
        is_read = len(asked) == len(found) and len(names.problems) == n_before
        return asked if is_read else Unread(names.problems[n_before:])


def is_of_an_instant(found: tuple[AskedT, ...] | Unread) -> bool:
    """Whether the value of a parameter is asked for with which a quantity has a value at one instant."""
    if isinstance(found, Unread) or len(found) != 1 or (wanted := found[0].quantity.wanted) is None:
        return False
    return wanted.of.scope == "instant"


def is_specific(problems: list[Problem]) -> bool:
    """Whether they say more than that nothing of a text can be read."""
    return any(not _is_general(p.message) for p in problems)


def _is_general(message: str) -> bool:
    """Whether a message says only that nothing can be read, or takes a word of a sentence for a name."""
    is_word = isinstance(message, Message) and message.arguments.get("name") in keyword.kwlist
    return is_word or (isinstance(message, Message) and bool(_GENERAL & message.arguments.keys()))


def unknown_parameters(problems: list[Problem]) -> set[str]:
    """Words that they take for parameters, which the file lacks: after lunch. What is too short for a word is none."""
    told = [p.message for p in problems if isinstance(p.message, Message) and " is not a parameter" in p.message]
    named = {str(message.arguments.get("name", "")) for message in told}
    return {name for name in named if name.isalpha() and name.islower() and len(name) >= _SHORTEST_WORD}


def leave_open(problems: list[Problem]) -> bool:
    """Whether they say that what is asked has several values."""
    return len(problems) == 1 and " has several values of " in problems[0].message


def each_value(names: Names, words: str, problems: list[Problem]) -> list[str]:
    """A question about a string, whose parts have tensions of their own, for each of them."""
    if not leave_open(problems) or not isinstance(told := problems[0].message, Message) or told.arguments["at"]:
        return []
    head = f"{told.arguments['what']} of {told.arguments['of']}"
    each = [f"{head} {span}" for span in strings.spans(names, str(told.arguments["of"]))]
    return [words.replace(head, one) for one in each] if words.count(head) == 1 else []


def is_of_words(names: Names, problems: list[Problem]) -> bool:
    """Whether they take words for names, as in `the string`, or for a condition: the way to mean them says more."""
    messages = [p.message for p in problems if isinstance(p.message, Message)]
    return any(m.startswith("cannot read the condition") for m in messages) or is_of_kinds(names, problems)


def condition_in_words(problems: list[Problem]) -> str:
    """The condition that is not read, where it is one in words: the drum turns. Of an equation it is told as it is."""
    messages = [p.message for p in problems if isinstance(p.message, Message)]
    read = [str(m.arguments["text"]) for m in messages if m.startswith("cannot read the condition")]
    return next((text for text in read if not re.search("[=<>]", text)), "")


def is_of_kinds(names: Names, problems: list[Problem]) -> bool:
    """Whether they take words for kinds of things, or for all there is, for names: the wheel, the gears."""
    kinds = set[str]().union(*(element.words for element in elements_of(names).exact.values()))
    kinds -= {*names.bodies, *names.connections, *names.loads}
    named = [m.arguments for p in problems if isinstance(m := p.message, Message) and "hint" in m.arguments]
    return any(str(x) in kinds or stands_for_all(str(x)) for arguments in named for x in arguments.values())


def is_misspelt(problems: list[Problem], text: str) -> bool:
    """Whether they say which form of the grammar a text is like, and it is one word, or begins but for a slip as it."""
    forms = [str(p.message.arguments["form"]) for p in problems if isinstance(p.message, Message) and _has_form(p)]
    openings = [re.split(r" (?=[A-Z]{2})", form)[0].removesuffix(" of") for form in forms]
    begun = [difflib.SequenceMatcher(None, opening, text[: len(opening)]).ratio() for opening in openings]
    return bool(forms) and (" " not in text or _LEAST_LIKE < max(begun) < 1.0)


def _has_form(problem: Problem) -> bool:
    return isinstance(problem.message, Message) and "form" in problem.message.arguments
