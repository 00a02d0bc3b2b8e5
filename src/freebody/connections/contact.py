"""Contact: outlines that may touch, slide or roll on each other, bounce and part."""

from __future__ import annotations

import difflib
import itertools
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from freebody.connections.base import Connection
from freebody.connections.outlines import KINDS, Outline, read_outline
from freebody.connections.pairs import ContactSurface, OutlinePair
from freebody.connections.sites import sites
from freebody.language.natural import natural
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.geometry import GROUND
from freebody.model import glyphs
from freebody.model.friction import read_friction, read_restitution
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Contact(Connection, kind="contact"):
    """`contact: {between: [ball, ground.floor], friction: mu, restitution: e}`; `among: [a, b, floor]` for every pair
    of several, `among: all` for all bodies and lines of the ground.

    What touches is named by a body (its circle, or its straight edges and corners), a point, a line (solid on the
    right of its direction, so below one that points to the right; `below: true` for the other side), or `inside bowl`
    for the inside of a ring. friction: one coefficient, or {static: 0.5, kinetic: 0.4}; restitution between 0 (default)
    and 1; rolling_resistance: the arm of the normal force [m]. A contact whose bodies have no place (`at`) starts
    touching, and `touching: true` moves the bodies there, or out of each other, by the least; `touching: false` leaves
    them where they are."""

    between: list[str] | None = None
    among: list[str] | str | None = None
    friction: Formula | dict[str, Any] = 0
    restitution: Formula = 0
    rolling_resistance: Formula = 0
    touching: bool | None = None
    below: bool = False

    @property
    def is_one_force(self) -> bool:
        return self.between is not None

    spread = ("between",)
    in_plane = True
    has_contact_point = True
    example = """
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}}
connections: {it: {contact: {between: [ball, floor], friction: 0.3, restitution: 0.5}}}
"""

    def pairs(self, names: Names, connection: str) -> list[OutlinePair]:
        """The pairs of outlines that may touch."""
        surface = ContactSurface(
            read_friction(names, self.friction, DIMENSIONLESS),
            read_restitution(names, self.restitution),
            names.positive(self, "rolling_resistance", LENGTH),
        )
        outlines = self._outlines(names)
        joined = [(a, b) for a, b in itertools.combinations(outlines, 2) if _may_touch(names, a, b)]
        if self.between is not None and len(outlines) == 2 and not joined:
            names.problem(Message("both are fixed and never move apart; one of them must be a moving body"), "between")
        found: list[OutlinePair] = []
        for a, b in joined:
            if a.body == b.body:
                if self.between is not None:
                    names.problem(
                        Message("{a} and {b} are parts of the same body", a=a.label, b=b.label),
                        "between",
                    )
                continue
            if not sites(a, b):
                if self.between is not None and not _is_misspelt(names, a, b):
                    names.problem(
                        Message(
                            "there is no contact of {a} with {b}: both are points, or straight lines, or hollow, "
                            "or one a line and one hollow. A contact takes two of {kinds}; one must be a circle, "
                            "a point or a polygon",
                            a=a.label,
                            b=b.label,
                            kinds=KINDS,
                        ),
                        "between",
                    )
                continue
            found.append(OutlinePair(connection, a, b, surface, self._starts_closed(names, a, b), len(joined) == 1))
        return found

    def _outlines(self, names: Names) -> list[Outline]:
        if (self.between is None) == (self.among is None):
            names.problem(Message("say what touches: between: [ball, ground.floor], or among: [a, b, c] for all pairs"))
            return []
        field = "between" if self.among is None else "among"
        texts = self.between if self.among is None else self.among
        if texts == "all":
            moving = sorted(
                (b.name for b in names.bodies.values() if b.name != GROUND and _has_outline(b)), key=natural
            )
            lines = sorted(names.bodies[GROUND].lines, key=natural)
            texts = [*moving, *(f"{GROUND}.{line}" for line in lines)]
        elif isinstance(texts, str):
            names.problem(Message("among is a list of bodies, points and lines, or all"), "among")
            return []
        assert isinstance(texts, list)
        if self.between is not None and len(texts) != 2:
            names.problem(Message("between takes two, found {n}; write among for more", n=len(texts)), "between")
            return []
        found = [read_outline(names, text, field, k, below=self.below) for k, text in enumerate(texts)]
        return [outline for outline in found if outline is not None]

    def _starts_closed(self, names: Names, a: Outline, b: Outline) -> bool:
        if self.touching is not None:
            return self.touching
        moving = [body for body in (names.known(a.body), names.known(b.body)) if not body.fixed]
        return self.between is not None and all(body.start.at is None for body in moving)

    def mentions(self, names: Names) -> set[str]:
        texts = self.between or (self.among if isinstance(self.among, list) else list(names.bodies))
        return {t.removeprefix("inside of ").removeprefix("inside ").partition(".")[0] for t in texts} & set(
            names.bodies
        )

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        pairs = self.pairs(names, "")
        is_rough = self.friction not in (0, "0")
        ordered = [*((p.first, p.second) for p in pairs), *((p.second, p.first) for p in pairs)]
        for solid, other in ordered:
            yield glyphs.Touch(solid.body, other.body, within=bool(solid.hollows))
            tips = tuple(glyphs.Tip(r.center, r.radius, r.body) for r in other.rounds)
            for straight in solid.straights:
                if straight.length is None:
                    yield glyphs.Surface(straight.line.through, straight.line.direction, tips, straight.body, is_rough)


def _has_outline(body: Any) -> bool:
    return (body.radius is not None and not body.edges) or bool(body.corners) or not body.turns


def _is_misspelt(names: Names, *outlines: Outline) -> bool:
    """Whether a point of the ground that is declared nowhere is called almost as a line of it; says so."""
    lines = names.bodies[GROUND].lines
    for outline in outlines:
        body, _, point = outline.label.partition(".")
        close = difflib.get_close_matches(point, lines, n=1) if body == GROUND else []
        if close and point in names.free_ground_points:
            told = Message(
                "there is no line {name} on the ground. Did you mean {x}?", name=point, x=f"{GROUND}.{close[0]}"
            )
            names.problem(told, "between")
            return True
    return False


def _may_touch(names: Names, a: Outline, b: Outline) -> bool:
    return not (names.known(a.body).fixed and names.known(b.body).fixed)
