"""What follows on an instant, as data: impacts, and the contact mode in which the motion goes on."""

from __future__ import annotations

from dataclasses import dataclass, field

from freebody.language.sentences import Message
from freebody.numeric.contact.problem import OutcomeCount
from freebody.numeric.contact.rows import ModeOf
from freebody.numeric.kernels.arrays import Floats

Choice = tuple[str, int, int | None]  # ("closed", barrier, None), ("open", barrier, None), ("drag", drag, state)


@dataclass(frozen=True)
class ImpactRecord:
    """Collisions at one instant: impulses [N s], rates before and after by barrier, and the energy that they take."""

    time: float
    impulses: dict[int, float]
    friction: dict[int, float]  # by place
    before: dict[int, float]
    after: dict[int, float]
    energy_change: float
    energy_grew: bool
    joints: dict[int, float] = field(default_factory=dict[int, float])  # by place: of what holds, where they are unique
    not_unique: tuple[int, ...] = ()  # places of rows whose impulses are not


@dataclass
class After:
    """The outcome of an instant."""

    y: Floats
    mode: ModeOf | None  # None: no consistent one
    impacts: list[ImpactRecord] = field(default_factory=list[ImpactRecord])
    resting: dict[int, float] = field(default_factory=dict[int, float])  # barrier: time at which its rebounds end
    status: OutcomeCount = OutcomeCount.UNIQUE
    why: str = ""
    jammed: int | None = None  # the barrier that took an impulse without a collision
    behind: set[int] = field(default_factory=set[int])  # far sides of what touches: passed through, not met
    handed: set[int] = field(default_factory=set[int])  # a place that ends and those of the same outlines that go on
    tipping: set[int] = field(default_factory=set[int])  # flat ends that begin to tip
    settled: float = 0.0  # work of the friction of rebounds that are too small to be followed


HELD_ALONE = Message(
    "what is held without any contact: constraints that say the same thing contradict each other by round-off"
)
