"""What was found about one quantity."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from freebody.assess.verdict import Verdict
from freebody.language.expression import Expr
from freebody.language.notation import joined, reworded, stated_plain, to_python
from freebody.language.sentences import Message, in_turn
from freebody.study.conservation.constancy import Confirmation, CounterMotion

EVERY_MOTION, NOT_CONSERVED = Message("conserved for every motion"), Message("not conserved")
EVERY_SIMULATED = Message("constant in every simulated motion")


@dataclass(frozen=True)
class Verdicts:
    """What was found about one quantity.

    `is_conserved`: True for every motion, False for no admissible parameters, None under `conditions` (any one of them;
    each is a set of equalities that hold together). Without `is_proved` that was seen in simulated motions alone; what
    changes in one of them is refuted for good. `rate` is the quantity's rate, reduced."""

    id: str
    question: str
    is_conserved: bool | None
    value: Expr | None
    rate: Expr | None
    conditions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    principle: str = ""
    parts: tuple[tuple[str, Expr], ...] = ()
    confirmation: Confirmation | None = None
    counter: CounterMotion | None = None
    reason: str = ""
    choice: str | None = None
    options: dict[str, Verdict] = field(default_factory=dict[str, Verdict])
    author_notes: tuple[str, ...] = ()
    is_exact: bool = True  # the conditions are all there are; otherwise they are enough
    provided: tuple[str, ...] = ()  # parameters that are taken not to vanish
    same_as: str = ""  # an earlier quantity that is the same formula
    is_proved: bool = True

    @property
    def when(self) -> str:
        """For which motions, or under which conditions, it is conserved, in words: whether only then is said where
        it is known."""
        if self.is_conserved is not None:
            proved = Message("for every motion") if self.is_proved else EVERY_SIMULATED
            return proved if self.is_conserved else Message("no")
        case = joined(self.conditions, " or ")
        told = Message("if and only if {case}" if self.is_exact else "if {case}", case=case)
        if self.provided:
            told = Message("{case} (for {names} ≠ 0)", case=told, names=", ".join(self.provided))
        return reworded(told if self.is_proved else Message("{what} {case}", what=EVERY_SIMULATED, case=told), case)

    @property
    def verdict(self) -> str:
        """The same as a sentence."""
        if self.is_conserved is not None:
            return (EVERY_MOTION if self.is_proved else EVERY_SIMULATED) if self.is_conserved else NOT_CONSERVED
        case, p = joined(self.conditions, " or "), in_turn(self.provided)
        if not self.is_proved:
            told = Message("constant in every simulated motion if {case}", case=case)
        elif self.is_exact and p:
            told = Message("conserved if and only if {case} (for {p} ≠ 0)", case=case, p=p)
        elif self.is_exact:
            told = Message("conserved if and only if {case}", case=case)
        elif p:
            told = Message("conserved if {case} (for {p} ≠ 0)", case=case, p=p)
        else:
            told = Message("conserved if {case}", case=case)
        return reworded(told, case)

    @property
    def is_answered(self) -> bool:
        return not self.reason

    def to_plain(self) -> dict[str, Any]:
        """Plain data: an entry of `quantities` in the JSON document."""
        return {
            "id": self.id,
            "question": self.question,
            "same_as": self.same_as or None,
            "conserved": self.is_conserved,
            "proved": self.is_proved,
            "value": None if self.value is None else to_python(self.value),
            "rate": None if self.rate is None else to_python(self.rate),
            "conditions": list(map(stated_plain, self.conditions)),
            "conditions_are_all": self.is_exact,
            "provided": list(self.provided),
            "notes": list(map(stated_plain, self.notes)),
            "principle": self.principle or None,
            "parts": {name: to_python(part) for name, part in self.parts},
            "reason": self.reason or None,
            "choice": self.choice,
            "options": {k: {"verdict": v.verdict, "reason": v.reason} for k, v in self.options.items()},
            "author_notes": list(self.author_notes),
            "counter_motion": None if self.counter is None else self.counter.to_plain(),
            "evidence": None if self.confirmation is None else self.confirmation.to_plain(),
        }
