"""A typed free-body diagram, beside what acts on the bodies.

Entries are matched with forces: first those that stand for all forces of a joint (one force of unknown direction, or
one along a massless member with two pins) or for all its moments, then the others, as many as can be. The components of
a joint, of its force and in space of its moment, may have any directions: what is drawn must span what acts. Forces of
one contact at several points may be drawn as one, at the contact. Every entry that is left over is explained by the
force that it comes nearest to, and what is not drawn is missing. A force acts anywhere on its line of action.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from itertools import combinations, product

import numpy as np

from freebody.assess.typed import TypedJudgement
from freebody.errors import CannotAnswer, ExpressionError, FreebodyError
from freebody.language.expression import Symbol
from freebody.language.sentences import Message, further, listed
from freebody.language.typed import TypedNumber
from freebody.language.units import FORCE, TORQUE
from freebody.narrative.marking.acting import Acting, FreeBodies, free_bodies, is_independent, is_of_teeth, is_within
from freebody.narrative.marking.explaining import Explaining
from freebody.narrative.marking.typed_forces import (
    Entry,
    entries_of,
    is_magnitude,
    is_parallel,
    is_place,
    is_point_of,
    is_sense,
    twice,
)
from freebody.numeric.jets import Array
from freebody.study.pictures.free_body import checked_bodies
from freebody.system.system import System

_ASKED = re.compile(
    r"(?:free[- ]body(?: diagram)?|fbd|freikörperbild|freischnitt|freigeschnitten)\s*(?:of|von|:)?\s*(?P<bodies>.+)",
    re.IGNORECASE,
)
_BETWEEN = re.compile(r"\s*(?:,|\band\b|\bund\b|\+)\s*")
_MOST_PARTS = 8  # entries at one point that are tried as components
_ADDS_UP = 1e-6  # relative, of forces in numbers


def asked_bodies(question: str) -> tuple[str, ...] | None:
    """The bodies of a question for a free-body diagram; None for any other question."""
    found = _ASKED.fullmatch(question.strip())
    return None if found is None else tuple(filter(None, _BETWEEN.split(found["bodies"].strip())))


def judge_free_bodies(system: System, bodies: Sequence[str], text: str) -> TypedJudgement:
    """The verdict on a typed diagram. Raises InputError for bodies that there are not."""
    cut = checked_bodies(system, bodies)
    try:
        free = free_bodies(system, cut)
        entries = list(entries_of(free, text))
        # a force along a massless member is one component of its pin or all of it: whichever leaves fewer faults
        tries = (Matching(free, entries, along_links=along).found() for along in (False, True))
        faults, opened = min(tries, key=lambda found: len(found[0]))
    except ExpressionError as error:
        return TypedJudgement("unreadable", error.message)
    except CannotAnswer as error:
        return TypedJudgement("undecided", str(error))
    read = tuple(entry.text for entry in entries)
    how = Message("compared with the loads and the reactions of the connections")
    if faults and (parts := resolved(free, entries)):
        return TypedJudgement("undecided", parts, forces=read)
    if faults and (teeth := toothed(free, entries)):
        told = Message("of {connection} the model knows only the moment of its teeth: not judged", connection=teeth)
        return TypedJudgement("undecided", told, forces=read)
    if faults and free.summed:
        told = Message("of {connection} the model knows only the sum of its forces: not judged", connection=free.summed)
        return TypedJudgement("undecided", told, forces=read)
    if faults:
        return TypedJudgement("incorrect", further(*faults), decided_by=how, forces=read)
    if opened:
        told = Message("the magnitude of {forces} is not judged here: write a name", forces=opened)
        return TypedJudgement("undecided", told, forces=read)
    return TypedJudgement("correct", Message("every force that acts, and no other"), decided_by=how, forces=read)


class Matching:
    """Entries and the forces that they stand for. along_links: one force along a massless member with two pins is all
    that acts at either."""

    def __init__(self, free: FreeBodies, entries: Sequence[Entry], *, along_links: bool) -> None:
        self.free, self.entries, self.acting = free, entries, free.outside
        self.along_links = along_links
        self.pairs: dict[Entry, Acting] = {}
        self.covered: set[Acting] = set()
        self._components: dict[Acting, list[Acting]] = {}
        self._fitting: dict[tuple[Entry, Acting], bool] = {}

    def found(self) -> tuple[list[str], str]:
        """What is wrong, and the reactions whose magnitudes are given."""
        self._joints()
        self._match(is_strict=True)
        self._match(is_strict=False)
        faults = [*self._span(), *self._left_over()]
        opened = [a.words for entry, a in self.pairs.items() if entry.magnitude is not None and self._is_open(entry, a)]
        return faults, listed(list(dict.fromkeys(opened)))

    def joint(self, a: Acting) -> list[Acting]:
        """The forces of a connection at one point of a body."""
        return [
            b
            for b in self.acting
            if not b.is_couple
            and (b.source, b.body) == (a.source, a.body)
            and float(np.linalg.norm(b.at - a.at)) < self.free.small
        ]

    def components(self, a: Acting) -> list[Acting]:
        """The reactions that may be drawn with other directions together: of the force of a joint, of its moment, or of
        friction at one point."""
        if a not in self._components:
            self._components[a] = [a] if a.row is None or a.is_known else self._exchangeable(a)
        return self._components[a]

    def _exchangeable(self, a: Acting) -> list[Acting]:
        alike = self.couples(a) if a.is_couple else self.joint(a)
        own = [b for b in alike if b.row is not None and not b.is_known and b.is_friction == a.is_friction]
        return own if not a.is_couple or is_independent([b.way for b in own]) else [a]

    def couples(self, a: Acting) -> list[Acting]:
        """The moments of what exerts a force, which act anywhere."""
        return [b for b in self.acting if b.is_couple and (b.source, b.body) == (a.source, a.body)]

    def is_free_joint(self, a: Acting) -> bool:
        """Whether a force is one of several components that may have any direction."""
        return len(self.components(a)) > 1

    def fits(self, entry: Entry, a: Acting) -> bool:
        """Whether an entry may stand for a force."""
        if (entry, a) not in self._fitting:
            self._fitting[entry, a] = self._fits(entry, a)
        return self._fitting[entry, a]

    def _fits(self, entry: Entry, a: Acting) -> bool:
        if entry.typed.is_couple != a.is_couple or is_magnitude(self.free, entry, a) is False:
            return False
        if not is_place(self.free, entry, a):
            return False
        if entry.heading is None:
            return False
        if self.is_free_joint(a):
            return is_within(entry.heading.way, [b.way for b in self.components(a)])
        return is_parallel(entry.heading.way, a.way) and is_sense(self.free, entry, a)

    def _is_open(self, entry: Entry, a: Acting) -> bool:
        """Whether an entry says how large a force is whose size the model does not say. A parameter with another unit,
        as the radius R, is but a name."""
        if is_magnitude(self.free, entry, a) is not None:
            return False
        if isinstance(entry.magnitude, Symbol):
            own = self.free.system.parameters.get(entry.magnitude.name)
            return own is not None and own.dimension == (TORQUE if a.is_couple else FORCE)
        return True

    # -- matching -----------------------------------------------------------------------------
    def _joints(self) -> None:
        """One entry for all forces of a joint, or for all its moments."""
        for entry in sorted(self.entries, key=lambda entry: entry.place is None):
            is_couple = entry.typed.is_couple
            for a in self.acting:
                if a in self.covered or a.is_couple != is_couple or not is_place(self.free, entry, a):
                    continue
                if is_couple:
                    own = self.couples(a)
                else:
                    own = self.joint(a) if entry.place is None or not entry.place.source else self._of_contact(a)
                    own = self._beside_normal(entry, own)
                if self._stands_for_all(entry, a, own):
                    self.pairs[entry] = a if a in own else own[0]
                    self.covered |= set(own)
                    break
            if entry.heading is None and entry not in self.pairs and is_couple:
                self._without_axis(entry)
            elif entry.heading is None and entry not in self.pairs:
                raise ExpressionError(Message("'{line}': say in which direction it acts", line=entry.text))

    def _beside_normal(self, entry: Entry, own: list[Acting]) -> list[Acting]:
        """Of a contact whose normal force is drawn by itself, the friction, which in space may have any direction along
        it."""
        normal = [a for a in own if a.is_normal]
        friction = [a for a in own if a.is_friction]
        is_drawn = any(self.fits(other, a) for other in self.entries if other is not entry for a in normal)
        return friction if is_drawn and len(friction) > 1 else own

    def _without_axis(self, entry: Entry) -> None:
        """A moment about no axis is one too many where nothing transmits a moment; anywhere else it is not clear."""
        if any(a.is_couple and is_place(self.free, entry, a) for a in self.acting) or entry.place is None:
            raise ExpressionError(Message("'{line}': say about which axis it turns", line=entry.text))

    def _of_contact(self, a: Acting) -> list[Acting]:
        if not a.is_normal and not a.is_friction:
            return self.joint(a)
        return [b for b in self.acting if (b.source, b.body) == (a.source, a.body) and not b.is_couple]

    def _stands_for_all(self, entry: Entry, a: Acting, own: Sequence[Acting]) -> bool:
        if any(b in self.covered for b in own) or a.row is None:
            return False
        if entry.typed.is_couple:
            return entry.heading is None
        if len(own) < 2:
            return False
        if entry.heading is None:
            return True
        line = self.free.of_link(a) if self.along_links and self.is_free_joint(a) else None
        return line is not None and is_parallel(line, entry.heading.way)

    def _match(self, *, is_strict: bool) -> None:
        """As many pairs as there can be, by augmenting paths. is_strict: a magnitude that a load has is given to none
        but such a load."""
        owner: dict[Acting, Entry] = {a: entry for entry, a in self.pairs.items() if a not in self.covered}

        @cache
        def candidates(entry: Entry) -> list[Acting]:
            fitting = [a for a in self.acting if a not in self.covered and self.fits(entry, a)]
            same = [a for a in self.acting if is_magnitude(self.free, entry, a)]
            return [a for a in fitting if a in same] if same and is_strict else fitting

        def placed(entry: Entry, seen: set[Acting]) -> bool:
            for a in candidates(entry):
                if a in seen:
                    continue
                seen.add(a)
                if a not in owner or placed(owner[a], seen):
                    owner[a] = entry
                    return True
            return False

        left = [entry for entry in self.entries if entry not in self.pairs]
        # formulas of loads first, then names, then formulas that are those of no load
        for entry in sorted(left, key=self._rank):
            placed(entry, set())
        self.pairs |= {entry: a for a, entry in owner.items()}

    def _rank(self, entry: Entry) -> int:
        if entry.magnitude is None:
            return 1
        return 0 if any(is_magnitude(self.free, entry, a) for a in self.acting) else 2

    # -- what is wrong ------------------------------------------------------------------------
    def _span(self) -> Iterator[str]:
        """Components of a joint that follow from others, and those that are covered."""
        done: set[Acting] = set()
        for a in self.acting:
            if a in self.covered or a in done or not self.is_free_joint(a):
                continue
            own = self.components(a)
            done |= set(own)
            drawn = [entry for entry, b in self.pairs.items() if b in own]
            # an entry that was left over may take the part of one that says nothing new
            drawn += [entry for entry in self.entries if entry not in self.pairs and self.fits(entry, a)]
            kept: list[tuple[Entry, Array]] = []
            for entry in drawn:
                way = None if entry.heading is None else entry.heading.way
                if way is None or len(kept) == len(own):
                    continue
                if not is_within(way, [w for _e, w in kept]):
                    self.pairs[entry] = self.pairs.get(entry, a)
                    kept.append((entry, way))
                elif entry in self.pairs:
                    same = next((e for e, w in kept if is_parallel(w, way)), None)
                    yield self._dependent(entry, a) if same is None else twice(same, entry, a.body)
            self.covered |= {b for b in own if is_within(b.way, [w for _e, w in kept])}

    def _dependent(self, entry: Entry, a: Acting) -> str:
        return Message("'{entry}' is made up of the other components of {force}", entry=entry.text, force=a.words)

    def _missing(self) -> Iterator[Acting]:
        matched = {a for a in self.pairs.values() if a in self.covered or not self.is_free_joint(a)}
        for a in self.acting:
            if a.is_needed and a not in matched and a not in self.covered and not self._is_in_one(a):
                yield a

    def n_drawn(self, a: Acting) -> int:
        """How many independent components are drawn in place of those of a joint."""
        own = self.components(a)
        ways = [e.heading.way for e, b in self.pairs.items() if b in own and e.heading is not None]
        return int(np.linalg.matrix_rank(np.array(ways), tol=_ADDS_UP)) if ways else 0

    def _is_in_one(self, a: Acting) -> bool:
        """Whether a force at one point of a contact is drawn together with that at another."""
        return any(
            a.row is not None
            and b.row is not None
            and entry.place is not None
            and (entry.place.source, b.source, b.body, b.row.reaction) == (a.source, a.source, a.body, a.row.reaction)
            and (b.is_normal or b.is_friction)
            and is_parallel(a.way, b.way)
            and b not in self.components(a)
            for entry, b in self.pairs.items()
            if not a.is_couple and not b.is_couple
        )

    def _left_over(self) -> Iterator[str]:
        missing = list(self._missing())
        explaining = Explaining(self.free, self.pairs, missing)
        for entry in self.entries:
            if entry not in self.pairs:
                yield explaining.why(entry)
        yield from told_missing(self, explaining.missing)


def resolved(free: FreeBodies, entries: Sequence[Entry]) -> str:
    """What is said where entries add up, in numbers, to a load that is known: its components instead of itself. Those
    of a force of teeth (tangential, radial, axial) have names and no numbers."""
    for a in free.outside:
        at = [e for e in entries if e.heading is not None and not e.typed.is_couple and is_point_of(free, e, a)]
        ways = [e.heading.way for e in at if e.heading is not None]
        if (
            is_of_teeth(a)
            and not a.is_couple
            and is_within(a.way, ways)
            and not any(is_parallel(w, a.way) for w in ways)
        ):
            return _said_resolved(at, a)
        if a.law is None or a.is_couple or any(is_magnitude(free, entry, a) for entry in entries):
            continue
        own = [e for e in entries if e.heading is not None and is_point_of(free, e, a) and _size(free, e) is not None]
        for n in range(2, len(a.force) + 1):
            for parts in combinations(own[:_MOST_PARTS], n):
                if _adds_up(free, parts, a):
                    return _said_resolved(parts, a)
    return ""


def _said_resolved(parts: Sequence[Entry], a: Acting) -> str:
    told = listed([Message("'{entry}'", entry=entry.text) for entry in parts])
    return Message("{parts} seem to be components of {force}: draw it as one force", parts=told, force=a.words)


def toothed(free: FreeBodies, entries: Sequence[Entry]) -> str:
    """Wheels of which the model knows the moments alone, where a force of their teeth is drawn."""
    named = {e.place.source for e in entries if e.place is not None and not e.typed.is_couple}
    return next((a.source for a in free.outside if is_of_teeth(a) and a.is_couple and a.source in named), "")


def _size(free: FreeBodies, entry: Entry) -> float | None:
    """[N] of an entry, where the parameters say it."""
    own = entry.magnitude
    if own is None or isinstance(own, TypedNumber):
        return None if own is None else own.value
    try:
        return free.snapshot.scalar(own)
    except FreebodyError:
        return None


def _adds_up(free: FreeBodies, parts: Sequence[Entry], a: Acting) -> bool:
    assert a.law is not None
    try:
        whole = free.snapshot.scalar(a.law) * a.force
    except FreebodyError:
        return False
    told = [(entry, entry.heading) for entry in parts if entry.heading is not None]
    vectors = np.array([(_size(free, entry) or 0.0) * heading.way for entry, heading in told])
    signs = ((1, -1)[: 1 if heading.has_sense else 2] for _entry, heading in told)
    near = _ADDS_UP * float(np.linalg.norm(whole))
    return any(float(np.linalg.norm(np.array(chosen) @ vectors - whole)) < near for chosen in product(*signs))


def told_missing(matching: Matching, missing: Iterable[Acting]) -> Iterator[str]:
    told: set[str] = set()
    for a in missing:
        is_part = matching.is_free_joint(a)
        whole = [b for b in matching.components(a) if b.is_needed] if is_part else []
        n = len(whole) - matching.n_drawn(a)
        if is_part and 1 < n < len(whole):
            said = Message("{n} components of {force} are missing", n=n, force=a.words)
        elif is_part and n < len(whole):
            said = Message("one component of {force} is missing", force=a.words)
        else:
            said = Message("{force} is missing", force=a.words)
        if said not in told:
            told.add(said)
            yield said
