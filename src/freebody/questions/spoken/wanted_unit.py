"""The unit in which a question wants its answer: how fast is it after 5 s, in km/h? The force in the rod (kN)."""

from __future__ import annotations

import re
from collections.abc import Container
from dataclasses import replace
from typing import TYPE_CHECKING

from freebody.errors import UnitError
from freebody.language.sentences import Message
from freebody.language.units import parse_unit
from freebody.questions.spoken.lexicon import languages, unit_words

if TYPE_CHECKING:
    from freebody.model.names import Names
    from freebody.questions.reading_when import Meant

_TOKENS = r"[^\s,;?!()\[\]]+"
_IN_BRACKETS = re.compile(r"\s*[(\[]\s*(?:in\s+)?(?P<unit>[^()\[\]]+?)\s*[)\]]")
_BEHIND_IN = re.compile(
    rf"(?:,|\s(?:measured|expressed|given|gemessen|angegeben))?\s+in\s+(?P<unit>{_TOKENS}(?:\s+{_TOKENS}){{0,3}})"
)
_HOW_MANY = re.compile(
    r"(?:(?:by|in|for|after|um|nach) )?(?:how many|wie ?viele?n?) (?P<unit>[^\W\d_]+(?: per (?:second|minute|hour))?)",
    re.IGNORECASE,
)
_EACH_MINUTE = re.compile(
    r"(?:^|\b)(?P<often>(?:(?:how|wie) (?:often|many|oft|viele)\b|^(?:the )?(?:number of )?)"
    r"(?=.*\b(?:swing|oscillat|vibrat|bob|rock|sway|schwing|pendel)).*?"
    r"\b(?:(?P<english>per|a|each|every)|pro|je|in der)) minute\b",
    re.IGNORECASE,
)
_EACH = r"(?:per|an?|each|every|in (?:an?|one|each|der|einer)|pro|je) (?P<time>minute|second|sekunde|hour|stunde)"
_OFTEN = r"(?:how (?:often|many times)|wie (?:oft|häufig|viel ?mal))"
_TURNS = (
    r"(?:(?:does|do|will) (?P<of>.+?) (?:turn|rotate|spin|revolve)(?: round| around)?|"
    r"(?:dreht|rotiert)(?: sich)? (?P<von>.+?))"
)
_TURNS_EACH = (
    re.compile(rf"{_OFTEN} {_EACH} {_TURNS}[ ?.!]*", re.IGNORECASE),
    re.compile(rf"{_OFTEN} {_TURNS} {_EACH}[ ?.!]*", re.IGNORECASE),
)
_TURNS_IN = {"minute": "rpm", "second": "turn/s", "sekunde": "turn/s", "hour": "turn/h", "stunde": "turn/h"}
ACCELERATES = re.compile(r"(?:ac|de)celerat|brak(?:e|ing)|beschleunig|verzöger|brems", re.IGNORECASE)  # told in g


_RPM = re.compile(r"^(?:(?:what is|find) )?(?:the )?rpm (?=of )", re.IGNORECASE)  # a quantity by its unit
_STOP = ".:"  # behind a unit, and no part of it
_WORD = re.compile(r"[^\W\d_]+")
_POWER = re.compile(r"(?<=[a-z])(?P<power>[23])(?!\w)")  # m/s2
_SUPERSCRIPTS = str.maketrans({"²": "^2", "³": "^3"})
_TURN = "turn"
_NO_SYMBOLS = ("in", "a", "d", "as", "at", "I")  # of units that are words as well


def without_units(text: str, named: Container[str]) -> tuple[str, tuple[str, ...]]:
    """A question without the units in which its answers are wanted, and these, as they are written in a file. named:
    what is a name of the model, and no unit."""
    units: list[str] = []

    def bracketed(found: re.Match[str]) -> str:
        unit = _unit(found["unit"], named)
        units.extend([unit] if unit else [])
        return "" if unit else found[0]

    def of_a_minute(found: re.Match[str]) -> str:
        units.append("1/min")
        return f"{found['often']} {'second' if found['english'] else 'Sekunde'}"

    if "rpm" not in named and (found := _RPM.match(text)):
        text = f"angular velocity {text[found.end() :]}"
        units.append("rpm")
    if turns := next((one for pattern in _TURNS_EACH if (one := pattern.fullmatch(text))), None):
        text = f"angular velocity of {turns['of']}" if turns["of"] else f"Drehzahl von {turns['von']}"
        units.append(_TURNS_IN[turns["time"].lower()])
    text, at = _EACH_MINUTE.sub(of_a_minute, _IN_BRACKETS.sub(bracketed, text)), 0
    while found := _BEHIND_IN.search(text, at):
        at = found.start("unit")
        words = found["unit"].split()
        for n in range(len(words), 0, -1):
            said = " ".join(words[:n]).rstrip(_STOP)
            is_numbered = words[n:][:1] == words[-1:] and words[-1].isdigit()  # the force in bar 1
            is_gravity = said.lower() == "g" and ACCELERATES.search(text) is not None
            is_last = found[0].startswith(",") and not text[at + len(said) :].strip(" .?!")  # ", in m" is of no mass m
            if not (is_numbered or is_gravity) and (unit := _unit(said, () if is_last else named)):
                text, at = f"{text[: found.start()]}{text[at + len(said) :]}", found.start()
                units.append(unit)
                break
    return text, tuple(units)


def _unit(said: str, named: Container[str]) -> str:
    """A unit as it is written in a file; nothing where a text is none."""
    if said in named or said in _NO_SYMBOLS or said.lower().startswith(("/", "a ")):
        return ""
    for language in languages():
        put = _POWER.sub(r"^\g<power>", _as_written(said.translate(_SUPERSCRIPTS), language))
        try:
            parse_unit(put, with_rare=False)
        except UnitError:
            continue
        return " ".join(put.split()).replace(" / ", "/").replace(" ^", "^")
    return ""


def _as_written(said: str, language: str) -> str:
    """A unit that is said in words as it is written: metres per second."""
    words = unit_words(language)
    return words.get(said) or _WORD.sub(lambda word: words.get(word[0], words.get(word[0].lower(), word[0])), said)


def counted_in(text: str) -> str:
    """The unit of which a text asks how many: how many joules are lost."""
    found = _HOW_MANY.match(text)
    return "" if found is None else _unit(found["unit"], ())


def told_in(names: Names, text: str, meant: Meant, words: str, unit: str) -> Meant | None:
    """What is meant, told in a unit; None after noting that it is not measured in it. words: what is meant, in those
    of the grammar."""
    own = meant.quantity.unit
    if not own:  # a list of unlike quantities
        return None
    if own == "1" and unit == _TURN:  # what is asked counts them
        return meant
    if parse_unit(own).dimension == parse_unit(unit).dimension:
        return replace(meant, in_unit=unit)
    told = Message(
        "'{text}' is understood as '{words}', whose unit is {own}, and {unit} is no such unit",
        text=text,
        words=words,
        own=Message("1, a plain number") if own == "1" else own,
        unit=unit,
    )
    names.problem(told, "find")
    return None
