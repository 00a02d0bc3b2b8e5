"""Why an entry of a free-body diagram stands for no force that acts: the force that it comes nearest to."""

from __future__ import annotations

from collections.abc import Mapping

from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.narrative.marking.acting import Acting, FreeBodies, is_within
from freebody.narrative.marking.typed_forces import (
    Entry,
    is_magnitude,
    is_parallel,
    is_place,
    is_point_of,
    is_sense,
    twice,
)


class Explaining:
    """pairs: entries with the forces that they stand for; missing: forces that are not drawn yet; one that an entry was
    meant for is taken out."""

    def __init__(self, free: FreeBodies, pairs: Mapping[Entry, Acting], missing: list[Acting]) -> None:
        self.free, self.pairs, self.missing = free, pairs, missing

    def why(self, entry: Entry) -> str:
        """In the order of what is most certain."""
        for explain in (
            self._by_magnitude,
            self._sense,
            self._pair,
            self._internal,
            self._elsewhere,
            self._smooth,
            self._no_moment,
            self._direction,
            self._place,
            self._no_force,
        ):
            if said := explain(entry):
                return said
        return Message("'{entry}' is extra: nothing exerts it", entry=entry.text)

    def _meant(self, a: Acting) -> None:
        self.missing = [b for b in self.missing if b is not a]

    def _is_on(self, entry: Entry, a: Acting, *, with_place: bool = True) -> bool:
        """Whether an entry lies on the line of a force, whatever its sense."""
        if entry.typed.is_couple != a.is_couple:
            return False
        if entry.heading is None or not is_parallel(entry.heading.way, a.way):
            return False
        return not with_place or is_place(self.free, entry, a)

    def _pair(self, entry: Entry) -> str:
        """It acts against a reaction that is drawn at the same place, or repeats it."""
        if entry.magnitude is not None or not entry.typed.place:
            return ""
        for other, a in self.pairs.items():
            if other.typed.place != entry.typed.place or other.typed.is_couple != entry.typed.is_couple:
                continue
            if other.heading is None or entry.heading is None or a.row is None:
                continue
            if is_place(self.free, entry, a) and is_parallel(entry.heading.way, other.heading.way):
                return twice(other, entry, a.body)
        return ""

    def _by_magnitude(self, entry: Entry) -> str:
        """It has the formula of a load: of one that is not drawn, or of one on another body."""
        own = [a for a in self.free.outside if is_magnitude(self.free, entry, a)]
        for a in own:
            if a not in self.missing or entry.typed.is_couple != a.is_couple:
                continue
            self._meant(a)
            if not self._is_on(entry, a, with_place=False):
                return self._said_direction(entry, a)
            if not is_sense(self.free, entry, a):
                return self._said_sense(entry, a)
            return self._said_place(entry, a)
        others = [a for a in self.free.elsewhere if is_magnitude(self.free, entry, a)]
        if others and not own:
            return self._said_elsewhere(entry, others[0])
        return ""

    def _sense(self, entry: Entry) -> str:
        for a in self.missing:
            if self._is_on(entry, a):
                self._meant(a)
                if not is_sense(self.free, entry, a):
                    return self._said_sense(entry, a)
                if is_magnitude(self.free, entry, a) is False and a.law is not None:
                    its = to_text(a.law)
                    return Message(
                        "'{entry}' has the wrong magnitude: {force} is {its}", entry=entry.text, force=a.words, its=its
                    )
        return ""

    def _said_sense(self, entry: Entry, a: Acting) -> str:
        if a.row is not None and a.row.reaction == "tension":
            return Message("'{entry}' has the wrong sense: a string only pulls", entry=entry.text)
        if a.is_normal:
            return Message("'{entry}' has the wrong sense: a contact only pushes", entry=entry.text)
        return Message("'{entry}' has the wrong sense for {force}", entry=entry.text, force=a.words)

    def _internal(self, entry: Entry) -> str:
        if any(self._is_on(entry, a) or is_point_of(self.free, entry, a) for a in self.free.inside):
            return Message("'{entry}' is internal: it acts between bodies that are cut free together", entry=entry.text)
        return ""

    def _elsewhere(self, entry: Entry) -> str:
        """It acts at a point of another body, or is its weight."""
        if entry.place is None or not entry.place.is_elsewhere:
            return ""
        named = [a for a in self.free.elsewhere if is_point_of(self.free, entry, a)]
        if named:
            return self._said_elsewhere(entry, named[0])
        return Message("'{entry}' does not act on {body}", entry=entry.text, body=", ".join(self.free.bodies))

    def _said_elsewhere(self, entry: Entry, a: Acting) -> str:
        own = ", ".join(self.free.bodies)
        return Message("'{entry}' acts on {other}, not on {body}", entry=entry.text, other=a.body, body=own)

    def _smooth(self, entry: Entry) -> str:
        """Friction where there is none."""
        if entry.typed.is_couple:
            return ""
        for a in self.free.outside:
            if not a.is_normal or entry.heading is None or not is_point_of(self.free, entry, a):
                continue
            is_tangent = abs(float(entry.heading.way @ a.way)) < 1e-6
            rough = any(b.is_friction and b.source == a.source for b in self.free.outside)
            if not rough and is_tangent:
                return Message(
                    "'{entry}' is extra: {connection} is smooth and has only a normal force",
                    entry=entry.text,
                    connection=a.source,
                )
        return ""

    def _no_moment(self, entry: Entry) -> str:
        """A joint transmits no moment about an axis that its bodies turn about."""
        source = self._barred(entry) if entry.typed.is_couple else ""
        if not source:
            return ""
        if any(a.is_couple and a.source == source for a in self.free.outside):
            return Message(
                "'{entry}' is extra: {connection} transmits no moment about this axis",
                entry=entry.text,
                connection=source,
            )
        return Message("'{entry}' is extra: {connection} transmits no moment", entry=entry.text, connection=source)

    def _no_force(self, entry: Entry) -> str:
        """Nor a force along one that they slide along."""
        source = "" if entry.typed.is_couple else self._barred(entry)
        if not source:
            return ""
        return Message(
            "'{entry}' is extra: {connection} transmits no force in this direction",
            entry=entry.text,
            connection=source,
        )

    def _barred(self, entry: Entry) -> str:
        """A connection at the place of an entry, of which none transmits such a force or moment."""
        own = [a for a in self.free.outside if a.row is not None and is_point_of(self.free, entry, a)]
        sources = dict.fromkeys(a.source for a in own)
        alike = [a.way for a in self.free.outside if a.source in sources and a.is_couple == entry.typed.is_couple]
        if alike and (entry.heading is None or is_within(entry.heading.way, alike)):
            return ""
        return next(iter(sources), "")

    def _direction(self, entry: Entry) -> str:
        """It acts where a force is missing."""
        for a in self.missing:
            if entry.typed.is_couple == a.is_couple and is_point_of(self.free, entry, a):
                self._meant(a)
                return self._said_direction(entry, a)
        return ""

    def _said_direction(self, entry: Entry, a: Acting) -> str:
        return Message("'{entry}' has the wrong direction for {force}", entry=entry.text, force=a.words)

    def _place(self, entry: Entry) -> str:
        """It is parallel to a force that is missing, of a magnitude that may be meant."""
        for a in self.missing:
            is_meant = is_magnitude(self.free, entry, a) is not False
            if is_meant and self._is_on(entry, a, with_place=False) and is_sense(self.free, entry, a):
                self._meant(a)
                return self._said_place(entry, a)
        return ""

    def _said_place(self, entry: Entry, a: Acting) -> str:
        return Message("'{entry}' is not on the line of action of {force}", entry=entry.text, force=a.words)
