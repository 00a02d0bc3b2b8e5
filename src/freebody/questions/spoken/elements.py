"""All that words can stand for in a model: its elements, what each is called, and how far that is from its name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

_OTHERWISE = {"center": "centre", "centre": "center"}  # words with two spellings

# how far what is meant is from what is written
WRITTEN, ALIKE, INFERRED = 0, 1, 3


@dataclass(frozen=True)
class Element:
    """Something that a question can name, and the words for its kind."""

    name: str
    words: frozenset[str] = frozenset()


@dataclass
class Elements:
    """All that words can stand for in a model."""

    exact: dict[str, Element] = field(default_factory=dict[str, Element])
    # by words in lower case: an element, how it is written, and how far that is from its name
    spoken: dict[tuple[str, ...], list[tuple[Element, str, int]]] = field(
        default_factory=dict[tuple[str, ...], list[tuple[Element, str, int]]]
    )

    space: bool = False
    bodies: set[str] = field(default_factory=set[str])  # that move
    touching: dict[str, frozenset[str]] = field(default_factory=dict[str, frozenset[str]])  # bodies, by connection
    sides: set[tuple[str, str]] = field(default_factory=set[tuple[str, str]])  # at which of several things one lies
    hanging: frozenset[str] = frozenset()  # bodies that strings alone hold, straight below them
    turning: set[str] = field(default_factory=set[str])  # bodies that move and turn
    pinned: set[str] = field(default_factory=set[str])  # bodies that turn about an axle of the ground
    fields: set[str] = field(default_factory=set[str])  # loads that act on all there is, as gravity does
    # of bodies, so far as they are numbers
    masses: dict[str, float] = field(default_factory=dict[str, float])
    radii: dict[str, float] = field(default_factory=dict[str, float])

    @cached_property
    def taken(self) -> frozenset[str]:
        """Words in lower case that are names, or words of names."""
        own = (key for key, meant in self.spoken.items() if any(one.name not in self.fields for one, _, _ in meant))
        return frozenset(word for key in own for word in key if word.isalpha())

    def add(self, name: str, words: Sequence[str] = (), said: str = "", distance: int = WRITTEN) -> None:
        """said: how it may be called, where that is not its name."""
        if not said:  # a line of the ground may be called as what touches it
            before = self.exact[name].words if name in self.exact else frozenset[str]()
            self.exact[name] = Element(name, before | frozenset(words))
        element = self.exact[name]
        written = said or name
        apart = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", written)
        keys = {(written.lower(),), tuple(re.split(r"[\s_.]+", apart.lower()))}
        keys |= {(written.lower().replace("_", ""),)} if "." not in written else set()  # v0 for v_0
        keys |= {tuple(_OTHERWISE.get(word, word) for word in key) for key in keys}
        for key in keys:
            self.spoken.setdefault(key, []).append((element, written, distance))
