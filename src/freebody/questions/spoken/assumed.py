"""What a question assumes: that nothing slips, that there is no friction, no drag of the air, that wheels are locked,
that something is held fast.

What holds in the model is no condition that changes the answer. What does not hold is refused by name: it would be
another model.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.questions.spoken import joining, lookup, rubbing
from freebody.questions.spoken.lexicon import assumptions, languages

if TYPE_CHECKING:
    from freebody.model.names import Names

_HELD = "held fast"
_AT_REST = re.compile(r" (?:when|until) (?:rate\(\w+\) = 0|\w+ stops)\b")


def without_what_holds(names: Names, text: str) -> str:
    """The text without clauses that assume what holds in the model."""
    for clause, what, _ in _assumed(text):
        if what != _HELD and not _against(names, what):
            text = " ".join(text.replace(clause, " ").split()).strip(" ,")
    return text


def what_does_not_hold(names: Names, text: str, *, is_of_train: bool = False) -> Message | None:
    """What is said of a text that assumes what does not hold in the model. is_of_train: of the members of a gear train
    any may be held."""
    for clause, what, who in _assumed(text):
        if is_of_train and what == _HELD:
            continue
        if against := [who] if what == _HELD else _against(names, what):
            return Message(
                "'{clause}' does not hold in this model ({against}); ask without it, or change the model",
                clause=clause.strip(" ,.?!"),
                against=", ".join(against),
            )
    return None


def takes_held_for_stopped(text: str, words: str) -> bool:
    """Whether what someone holds fast, in another model, is taken for what stands still at an instant of this one."""
    return _AT_REST.search(words) is not None and any(what == _HELD for _, what, _ in _assumed(text))


def _assumed(text: str) -> Iterator[tuple[str, str, str]]:
    """Clauses of a text that assume something, what that is, and of what it is said."""
    for language in languages():
        for what, pattern in assumptions(language).items():
            for found in re.finditer(pattern, text, re.IGNORECASE):
                yield found[0], what, found.groupdict().get("who") or ""


def _against(names: Names, what: str) -> list[str]:
    """What a model has where something is assumed not to be: contacts that are rough, or may slip, and drag."""
    if what == "locked wheels":  # what has no wheels slides
        return [] if rubbing.rough(names, "") and not rubbing.rolls(names) and not lookup.rests(names) else ["rest"]
    if what == "no drag":
        return [name for name in names.loads if "air" in names.called.get(name, ())]
    rough = rubbing.rough(names, "")
    if what == "no slip":  # what has no coefficient of friction does not slip
        return [name for name in rough if joining.given_of(names.connections[name]).get("friction") is not None]
    return rough
