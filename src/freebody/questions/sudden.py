"""Instants just before and just after a blow or an impact, in words: velocity of x after the blow."""

from __future__ import annotations

import re

ORDINALS = {
    word: n
    for n, words in enumerate(("first|1st", "second|2nd", "third|3rd", "fourth|4th", "fifth|5th"), 1)
    for word in words.split("|")
}
NTH = rf"(?:{'|'.join(ORDINALS)})"
# what they are called: a blow by an impulse or by what closes, an impact of what collides
BLOW = r"(?:blow|impact|collision|strike|kick|jerk|catch|capture|hit)"
IMPACT = r"(?:impact|collision|bounce|hit)"
_NAME = r"(?: (?:of|by|with|at) (?:the )?(?P<of>[A-Za-z_]\w*))?"
_SOON = r"(?:just |immediately |(?<!along )(?<!to the )right )?"  # "along right after" is a direction first
# impact 3, impact number 3
_NUMBERED = re.compile(
    rf"\b(?P<when>before|after|at|of|in|when) (?:the )?(?P<what>{BLOW}|bounce) (?:(?:number|no\.?) )?(?P<n>[1-9])"
    r"(?=$|\)| [-=+*/<>]| is\b| and\b)"
)
_WORDS = re.compile(
    rf"(?<!when)(?<!just) {_SOON}(?P<side>before|after) the (?:(?P<nth>{NTH}) )?(?:{BLOW}|bounce){_NAME}(?= |$|\))"
)
_CONDITION = re.compile(rf"^just (?P<side>before|after) the (?:(?P<nth>{NTH}) )?blow{_NAME}$")
_AT_NTH = re.compile(rf"(?<!when) (?:at|of) (?:the )?(?P<nth>{NTH}) {IMPACT}{_NAME}(?= |$|\))")
_LOST = re.compile(
    rf"^(?:the )?(?:energy (?:lost|dissipated)|loss of (?:mechanical |kinetic )?energy) (?:in|at|by) the "
    rf"(?P<nth>{NTH}) {IMPACT}{_NAME}$"
)


def by_blows(phrase: str) -> str:
    """Words for what is so just before or just after a blow as conditions."""

    def of(found: re.Match[str]) -> str:
        return "" if found["of"] is None else f" of {found['of']}"

    def nth(found: re.Match[str]) -> str:
        return "" if ORDINALS.get(found["nth"] or "", 1) == 1 else f"{found['nth']} "

    def beside(found: re.Match[str]) -> str:
        return f" when just {found['side']} the {nth(found)}blow{of(found)}"

    phrase = _NUMBERED.sub(_by_ordinal, phrase)
    lost = _LOST.match(phrase)
    if lost is not None and nth(lost):
        sides = (f"total energy when just {side} the {nth(lost)}blow{of(lost)}" for side in ("before", "after"))
        return " - ".join(f"({side})" for side in sides)
    return _AT_NTH.sub(lambda found: f" when the {found['nth']} impact{of(found)}", _WORDS.sub(beside, phrase))


def _by_ordinal(found: re.Match[str]) -> str:
    """Impact 3 as the third impact, as far as ordinals go."""
    ordinal = next((word for word, n in ORDINALS.items() if n == int(found["n"])), None)
    return found[0] if ordinal is None else f"{found['when']} the {ordinal} {found['what']}"


def side_of_blow(condition: str) -> tuple[str, str | None] | None:
    """`before` or `after`, and the name of what closes, strikes or collides; None where a condition says neither."""
    found = _CONDITION.match(condition.strip())
    return None if found is None else (found["side"], found["of"])


def which_blow(condition: str) -> int:
    """Which of the blows of its kind a condition names, counted from the start."""
    found = _CONDITION.match(condition.strip())
    return 1 if found is None else ORDINALS.get(found["nth"] or "", 1)
