"""Blows in mid-motion: what closes and what strikes, all at once, the first time that something happens.

Before its event a connection that closes does not hold, and an impulse does nothing; from the event on the connection
holds, and the impulse has acted. The velocities change at the event as at a start that is a blow, and no place does.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from freebody.language.sentences import Message, in_turn
from freebody.model.elements import AppliedLoad, ConstraintRow
from freebody.questions.event import AskedEvent


@dataclass(frozen=True)
class BlowEvent:
    """What happens at one event: rows that are held from then on, and measures that are pushed by an impulse."""

    event: AskedEvent
    rows: tuple[ConstraintRow, ...] = ()
    impulses: tuple[AppliedLoad, ...] = ()

    @property
    def name(self) -> str:
        """The words of its event."""
        return self.event.text

    @property
    def closing(self) -> tuple[str, ...]:
        """The connections that close."""
        return tuple(dict.fromkeys(row.connection for row in self.rows))

    @property
    def striking(self) -> tuple[str, ...]:
        """The impulses that act."""
        return tuple(dict.fromkeys(push.load for push in self.impulses))

    @property
    def words(self) -> str:
        """What happens, in words."""
        closes, strikes = self.closing, self.striking
        if not strikes:
            return Message("{names} closes", names=in_turn(list(closes)))
        if not closes:
            return Message("{names} strikes", names=in_turn(list(strikes)))
        return Message(
            "{first} strikes and {second} closes", first=in_turn(list(strikes)), second=in_turn(list(closes))
        )


def gathered(
    closing: Mapping[str, AskedEvent],
    striking: Mapping[str, AskedEvent],
    rows: list[ConstraintRow],
    impulses: list[AppliedLoad],
) -> tuple[BlowEvent, ...]:
    """What happens at the same event as one blow. closing, striking: the events of connections and of loads."""
    events = {event.text: event for event in (*closing.values(), *striking.values())}
    return tuple(
        BlowEvent(
            events[text],
            tuple(row for row in rows if row.connection in closing and closing[row.connection].text == text),
            tuple(push for push in impulses if push.load in striking and striking[push.load].text == text),
        )
        for text in sorted(events)
    )
