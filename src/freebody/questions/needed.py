"""Words without which a pattern cannot match: most of the ways to ask are ruled out by them, and their patterns, which
take long to compile, are never compiled."""

from __future__ import annotations

import re

_TOKEN = re.compile(
    r"(?P<open>\((?!\?)|\(\?(?:P<\w+>|:))|(?P<look>\(\?)|(?P<close>\))|(?P<bar>\|)|(?P<again>[*+?]|\{[\d,]*\})\??"
    r"|(?P<letters>[A-Za-z0-9 ]+(?![*+?{])|[A-Za-z0-9 ])|\\.|\[\^?\]?(?:\\.|[^]\\])*\]|.",
    re.DOTALL,
)
Words = frozenset[str]  # one of which stands in every text that matches; none: nothing is known


def needed(pattern: str) -> Words:
    """Of a pattern that tells capitals from small letters. What it does not understand it knows nothing of."""
    return _Scan(pattern).alternatives()


class _Scan:
    """The pattern from left to right, once."""

    def __init__(self, pattern: str) -> None:
        self.tokens = [(found.lastgroup, found[0]) for found in _TOKEN.finditer(pattern)]
        self.at = 0

    def alternatives(self) -> Words:
        """Up to the end of a group: what one of them needs or another does, unless one needs nothing."""
        each = [self._sequence()]
        while self._is("bar"):
            self.at += 1
            each.append(self._sequence())
        return frozenset[str]().union(*each) if all(each) else frozenset()

    def _sequence(self) -> Words:
        """The most telling of what its parts need: letters in a row, or a group."""
        best, row = frozenset[str](), ""
        while self.at < len(self.tokens) and not self._is("bar") and not self._is("close"):
            kind, text = self.tokens[self.at]
            self.at += 1
            found, letters = frozenset[str](), ""
            if kind == "open":
                found = self.alternatives()
                self.at += 1
            elif kind == "look":  # ahead, behind, or on a condition: it stands for no text of its own
                self.alternatives()
                self.at += 1
            elif kind == "letters":
                letters = text
            is_repeated = self._is("again")
            if is_repeated:
                may_lack = self.tokens[self.at][1][0] in "*?{"
                self.at += 1
                found, letters = (frozenset(), "") if may_lack else (found, letters)
            row += letters
            if not letters or is_repeated:  # something else may stand between
                best, row = max(best, _of(row), found, key=_telling), ""
        return max(best, _of(row), key=_telling)

    def _is(self, kind: str) -> bool:
        return self.at < len(self.tokens) and self.tokens[self.at][0] == kind


def _of(row: str) -> Words:
    return frozenset([row]) if row else frozenset()


def _telling(words: Words) -> int:
    """The length of the shortest of them."""
    return min(map(len, words), default=0)
