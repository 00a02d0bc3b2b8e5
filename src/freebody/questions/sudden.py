"""Instants just before and just after a blow or an impact, in words: velocity of x after the blow."""

from __future__ import annotations

import re

# what they are called: a blow by an impulse or by what closes, an impact of what collides
BLOW = r"(?:blow|impact|collision|strike|kick|jerk|catch|capture|hit)"
_NAME = r"(?: (?:of|by|with|at) (?:the )?(?P<of>[A-Za-z_]\w*))?"
_SOON = r"(?:just |immediately |(?<!along )(?<!to the )right )?"  # "along right after" is a direction first
_WORDS = re.compile(rf"(?<!when)(?<!just) {_SOON}(?P<side>before|after) the (?:first )?{BLOW}{_NAME}(?= |$|\))")
_CONDITION = re.compile(rf"^just (?P<side>before|after) the blow{_NAME}$")


def by_blows(phrase: str) -> str:
    """Words for what is so just before or just after a blow as conditions."""

    def put(found: re.Match[str]) -> str:
        of = "" if found["of"] is None else f" of {found['of']}"
        return f" when just {found['side']} the blow{of}"

    return _WORDS.sub(put, phrase)


def side_of_blow(condition: str) -> tuple[str, str | None] | None:
    """`before` or `after`, and the name of what closes, strikes or collides; None where a condition says neither."""
    found = _CONDITION.match(condition.strip())
    return None if found is None else (found["side"], found["of"])
