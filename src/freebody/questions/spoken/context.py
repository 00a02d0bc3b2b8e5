"""What stands before a question and only describes the system: for the system shown, it is released from rest, a disk
rolls down an incline.

What the file says as well is left out: values that are those of the file, a start from rest where it starts so. A
sentence before the question is left out where all of its words are known, and none of them is a number, a condition, or
says more than how things hang together; else it may be another model, and is read as a part of the question.
"""

from __future__ import annotations

import re
from contextlib import suppress
from typing import TYPE_CHECKING

from freebody.errors import UnitError
from freebody.language.units.quantity import parse_quantity
from freebody.questions.spoken import lookup, poses, rubbing
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.lexicon import changes_value, contexts, languages
from freebody.questions.spoken.naming import linked
from freebody.questions.spoken.words import Unknown, words_of

if TYPE_CHECKING:
    from freebody.model.names import Names

_KNOWN = ("name", "verb", "filler", "preposition", "pronoun", "updown", "quantity", "part")
_DESCRIBES = {"move", "hang", "exert", "act", "fall", "rise", "turn", "roll", "slide", "fly", "carry"}
_SLIPS = {"roll", "slide"}
# with what leads it: a block of 2 kg, a mass m = 2 kg
_VALUE = re.compile(
    r"(?: (?:of|with|from|at|von|mit|aus|bei)(?: an?| the| einer?| einem)?)?(?: [^\W\d]\w* ?=)? "
    r"(?P<value>\d[\d.,]*(?: ?(?:1/)?[A-Za-z°][\w/^*°]*(?: m\b(?:/s)?)?))"
)
_EQUAL = re.compile(r"(?P<name>[^\W\d]\w*) ?= ?(?P<value>-?\d[\d.]*(?: ?(?:1/)?[A-Za-z°][\w/^*°]*)?)")


def without_context(names: Names, elements: Elements, text: str) -> str:
    """The question in a text, without what describes a system that is as the model has it."""
    for language in languages():
        patterns = contexts(language)
        text = re.sub(patterns["lead"], "", text, count=1, flags=re.IGNORECASE)
        text = _without_values(names, text, patterns["values"])
        released = re.match(patterns["released"], text, re.IGNORECASE)
        if released is not None and lookup.rests(names) and _starts_so(names, released["pose"]):
            rest = text[released.end() :].rstrip(" .?!")
            is_timed = re.search(patterns["timed"], rest, re.IGNORECASE) is not None
            text = rest if is_timed else f"{rest} {patterns['at_start']}"
        behind = re.search(patterns.get("released_behind", r"(?!)"), text, re.IGNORECASE)
        if behind is not None and lookup.rests(names):
            head = text[: behind.start()]
            if re.search(patterns["timed"], head, re.IGNORECASE) is not None:
                text = head
        from_rest = patterns.get("from_rest")
        if from_rest is not None and lookup.rests(names) and re.search(patterns["timed"], text, re.IGNORECASE):
            text = re.sub(from_rest, "", text, flags=re.IGNORECASE)
        text = _without_statements(names, elements, text, language)
    return text


def _without_statements(names: Names, elements: Elements, text: str, language: str) -> str:
    """The text without the sentences before its last one that only describe the system."""
    sentences = re.split(r"(?<=[.;]) ", text)
    begins = False
    while len(sentences) > 1:
        parted = re.match(contexts(language)["statement"], f"{sentences[0]} {sentences[-1]}", re.IGNORECASE)
        if parted is None or not _only_describes(names, elements, parted["said"], language):
            break
        begins |= any(_is_start(names, one["name"], one["value"]) for one in _EQUAL.finditer(sentences[0]))
        sentences = sentences[1:]
    asked = " ".join(sentences)
    is_timed = not begins or re.search(contexts(language)["timed"], asked, re.IGNORECASE) is not None
    return asked if is_timed else f"{asked.rstrip(' .?!')} {contexts(language)['at_start']}"


def _starts_so(names: Names, pose: str | None) -> bool:
    """Whether the file lets something start in the pose that a text says, if it says one."""
    level = ("horizontal", "waag")
    return pose is None or (
        poses.begins_lying(names) if pose.lower().startswith(level) else poses.begins_standing(names)
    )


def _without_values(names: Names, text: str, pattern: str) -> str:
    """The text without values of parameters before the question, where all of them are those of the file."""
    given = re.match(pattern, text, re.IGNORECASE)
    told = [*_EQUAL.finditer(given["all"])] if given is not None else []
    if given is None or not told or _EQUAL.sub("", given["all"]).replace("and", "").replace("und", "").strip(" ,"):
        return text
    return text[given.end() :] if all(_is_given(names, one["name"], one["value"]) for one in told) else text


def _is_given(names: Names, name: str, value: str) -> bool:
    parameter = names.parameters.get(name)
    if parameter is None or parameter.value is None:
        return False
    with suppress(UnitError, ValueError):
        return parse_quantity(value.replace("°", "deg")).value == names.number_of(name)
    return False


def _is_start(names: Names, name: str, value: str) -> bool:
    """Whether the file lets a measure start at a value."""
    start = names.placed_at_start.get(name)
    with suppress(UnitError, ValueError):
        return start is not None and parse_quantity(value.replace("°", "deg")).value == names.numeric(start)
    return False


def _is_of_file(names: Names, value: str) -> bool:
    """Whether some parameter has a value in the file."""
    with suppress(UnitError, ValueError):
        said = parse_quantity(re.sub(r"(?<=N)(?=m)", " ", value.replace(",", ".").replace("°", "deg")))
        alike = [p.name for p in names.parameters.values() if p.dimension == said.dimension]
        return any(names.number_of(name) == said.value != 0.0 for name in alike)
    return False


def _only_describes(names: Names, elements: Elements, said: str, language: str) -> bool:
    """Whether a sentence has nothing but known words, and says no more than how things hang together, or move."""
    if lookup.rests(names):
        said = re.sub(contexts(language)["let_go"], "", said)
    known_values = (_is_given, _is_start)
    said = _EQUAL.sub(lambda one: "" if any(is_so(names, one[1], one[2]) for is_so in known_values) else one[0], said)
    said = _VALUE.sub(lambda value: "" if _is_of_file(names, value["value"]) else value[0], said)
    plain = re.findall(r"[^\W\d_]+", said.lower())
    if re.search(r"[\d=<>]", said) or any(changes_value(word, language) for word in plain):
        return False
    if any(word in ("only", "nur", "not", "nicht", "no", "kein", "keine", "without", "ohne") for word in plain):
        return False
    for way in linked(elements, in_english_nouns(said, language, elements.taken)):
        with suppress(Unknown):
            words = words_of(way.text, language)
            verbs = {word.what for word in words if word.kind == "verb"}
            slips = verbs & _SLIPS and any(
                "contact" in names.called.get(joint, ()) for joint in rubbing.rough(names, "")
            )
            known = (*_KNOWN, "instant") if lookup.rests(names) else _KNOWN  # it rolls from rest
            verbs -= {"become", *(("from_rest",) if lookup.rests(names) else ())}
            starts = {word.what for word in words if word.kind == "instant"} <= {"at start"}
            return all(word.kind in known for word in words) and starts and verbs <= _DESCRIBES and not slips
    return False
