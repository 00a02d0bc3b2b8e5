"""What an exercise sheet has in it: its exercises by variant, and what is right."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.narrative.sheets.answer_key import KeyEntry, key_of
from freebody.narrative.sheets.statement import label_of
from freebody.narrative.sheets.variants import Variant
from freebody.system.system import System

Solutions = Literal["none", "end", "inline"]
SOLUTIONS: tuple[Solutions, ...] = ("none", "end", "inline")


@dataclass(frozen=True)
class SheetContent:
    """An exercise sheet in one or more variants, counted from 1."""

    systems: tuple[System, ...]
    solutions: Solutions
    variants: int
    seed: int
    language: str
    _made: tuple[tuple[Variant, ...], ...]
    room: float = 0.0  # [cm] to write in under a question
    in_numbers: bool = False  # options are shown with the numbers of the variant

    @property
    def points(self) -> float:
        """Of all questions."""
        return sum(q.points or 0.0 for system in self.systems for q in system.questions)

    def variant(self, n: int) -> tuple[Variant, ...]:
        """The exercises of a variant. Raises InputError for one that there is not."""
        if not 1 <= n <= self.variants:
            raise InputError(Message("there is no variant {n}; there are 1 to {variants}", n=n, variants=self.variants))
        return self._made[n - 1]

    def key(self, variant: int = 1) -> tuple[KeyEntry, ...]:
        """What is right, question by question."""
        found: list[KeyEntry] = []
        for number, exercise in enumerate(self.variant(variant), 1):
            answers = exercise.solution.answers
            for k, answer in enumerate(answers, 1):
                found.append(key_of(answer, label_of(number, k, len(answers))))
        return tuple(found)
