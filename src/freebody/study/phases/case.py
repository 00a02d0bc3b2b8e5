"""A case of a motion in phases as plain values: its phases, and where it is the one that happens."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

from freebody.language.expression import Expr
from freebody.language.notation import stated_plain, to_python
from freebody.symbolic.relations import SolvedRelation


@dataclass(frozen=True)
class PhaseResult:
    """One phase of a case. Times count from its beginning."""

    what: str
    states: dict[str, str]
    requires: tuple[str, ...]  # inequalities that make it the mode that begins here
    equations: tuple[tuple[Expr, Expr], ...]  # accelerations
    motion: tuple[tuple[Expr, Expr], ...]  # coordinates as functions of time, or the square of the speed
    forces: tuple[tuple[str, Expr], ...]
    event: str = ""  # what ends it; nothing where it lasts
    duration: Expr | None = None
    place: tuple[Expr, Expr] | None = None  # coordinate and its value at the event, where there is no time
    happens_if: tuple[str, ...] = ()  # inequalities that make this event the one that ends it
    reason: str = ""  # why there is no closed form, or why nothing follows
    impact: str = ""  # with which it begins
    impulses: tuple[tuple[str, Expr], ...] = ()
    is_proved: bool = True  # that nothing else ends it follows from formulas
    begins: Literal["", "impact", "blow"] = ""  # with a collision, or with a blow that leads to none

    def to_plain(self) -> dict[str, Any]:
        return {
            "what": self.what,
            "states": self.states,
            "requires": list(map(stated_plain, self.requires)),
            "equations": {to_python(a): to_python(b) for a, b in self.equations},
            "motion": {to_python(a): to_python(b) for a, b in self.motion},
            "forces": {name: to_python(e) for name, e in self.forces},
            "event": self.event or None,
            "duration": None if self.duration is None else to_python(self.duration),
            "place": None if self.place is None else {to_python(self.place[0]): to_python(self.place[1])},
            "happens_if": list(map(stated_plain, self.happens_if)),
            "reason": self.reason or None,
            "impact": self.impact or None,
            "impulses": {name: to_python(e) for name, e in self.impulses},
            "proved": self.is_proved,
        }


@dataclass(frozen=True)
class PhaseCase:
    """A sequence of phases, and where in the space of parameters it is the one that happens."""

    what: str
    conditions: tuple[str, ...]
    phases: tuple[PhaseResult, ...]
    is_own: bool  # the one of the model's own values
    n_sets: int  # parameter sets that were seen to take it
    is_exact: bool = True  # the conditions are sufficient, too
    relations: tuple[SolvedRelation, ...] = field(default=(), compare=False, repr=False)

    def to_plain(self) -> dict[str, Any]:
        return {
            "what": self.what,
            "conditions": list(map(stated_plain, self.conditions)),
            "is_own": self.is_own,
            "sets": self.n_sets,
            "exact": self.is_exact,
            "phases": [p.to_plain() for p in self.phases],
        }
