"""What a question assumes: that nothing slips, that there is no friction, no drag of the air, that wheels are locked,
that something is held fast, or is cut.

What holds in the model is no condition that changes the answer. What does not hold is refused by name: it would be
another model.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.model.noting import near
from freebody.questions.spoken import joining, lookup, rubbing
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.lexicon import assumptions, contexts, languages
from freebody.questions.spoken.naming import elements_of, linked, plain_names

if TYPE_CHECKING:
    from freebody.model.names import Names

_HELD = "held fast"
_CUT = "cut"
_AT_REST = re.compile(r" (?:when|until) (?:rate\(\w+\) = 0|\w+ stops)\b")


def without_what_holds(names: Names, text: str) -> str:
    """The text without clauses that assume what holds in the model."""
    for clause, what, _ in _assumed(text):
        if what not in (_HELD, _CUT) and not _against(names, what):
            text = " ".join(text.replace(clause, " ").split()).strip(" ,").removeprefix(". ")
    return text


def what_does_not_hold(names: Names, text: str, *, is_of_train: bool = False) -> Message | None:
    """What is said of a text that assumes what does not hold in the model. is_of_train: of the members of a gear train
    any may be held."""
    for clause, what, who in _assumed(text):
        if is_of_train and what == _HELD:
            continue
        own = [who] if what == _HELD else _still_there(names, who) if what == _CUT else None
        if against := _against(names, what) if own is None else own:
            return Message(
                "'{clause}' does not hold in this model ({against}); ask without it, or change the model",
                clause=clause.strip(" ,.?!"),
                against=", ".join(against),
            )
        if what == _CUT and not own and " " not in who and (hint := near(who, [*names.connections, *names.loads])):
            return Message("there is no {who} that could be cut.{hint}", who=who, hint=hint)
    return None


def takes_held_for_stopped(text: str, words: str) -> bool:
    """Whether what someone holds fast, in another model, is taken for what stands still at an instant of this one."""
    return _AT_REST.search(words) is not None and any(what == _HELD for _, what, _ in _assumed(text))


def takes_cut_for_whole(names: Names, text: str) -> bool:
    """Whether a text is about what comes when something is cut, or breaks, that this model still has."""
    return any(what == _CUT and _still_there(names, who) for _, what, who in _assumed(text))


def cut_in(names: Names, text: str) -> tuple[list[str], str] | None:
    """What a text says is cut that the model has, and the rest of the text; None where it says so of nothing, or of
    more than one thing. In the instant in which it is cut is at the start."""
    for language in languages():
        for found in re.finditer(assumptions(language)[_CUT], text, re.IGNORECASE):
            said = found.groupdict()
            rest = " ".join(text.replace(found[0], " ").split()).strip(" ,?.!")
            there = _cut_one(names, said.get("who") or said.get("which") or "", rest)
            if len(there) != 1 or "gravity" in names.called.get(there[0], ()):  # nobody cuts a field
                continue
            is_then = said.get("then") is not None
            return there, f"{rest} {contexts(language)['as_it_starts']}" if is_then else rest
    return None


def _cut_one(names: Names, who: str, rest: str) -> list[str]:
    """Connections and loads that words mean: the right one, of what the rest of the text calls by its noun."""
    if not who.endswith(" one"):
        return _still_there(names, who)
    told = (_still_there(names, f"{who.removesuffix('one')}{noun}") for noun in re.findall(r"[^\W\d]+", rest))
    return next((there for there in told if len(there) == 1), [])


def _still_there(names: Names, who: str) -> list[str]:
    """Connections, and loads that pull, that are meant by words."""
    elements = elements_of(names)
    told = {in_english_nouns(who, language, elements.taken) for language in languages()}
    marked = {plain_names(way.text) for words in told for way in linked(elements, words)}
    there = [*names.connections, *names.loads]
    return [name for name in there if name in marked]


def _assumed(text: str) -> Iterator[tuple[str, str, str]]:
    """Clauses of a text that assume something, what that is, and of what it is said."""
    for language in languages():
        for what, pattern in assumptions(language).items():
            for found in re.finditer(pattern, text, re.IGNORECASE):
                said = found.groupdict()
                yield found[0], what, said.get("who") or said.get("which") or ""


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
