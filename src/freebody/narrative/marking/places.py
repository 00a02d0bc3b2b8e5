"""The points, lines and directions that a typed force names, in the pose of the bodies that are cut free."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import numpy as np

from freebody.errors import ExpressionError
from freebody.language.expression import free_symbols
from freebody.language.sentences import Message
from freebody.language.typed import Vocabulary
from freebody.language.typed.forces import TypedForce
from freebody.language.typed.grammar import readings
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.noting import did_you_mean
from freebody.narrative.marking.acting import Acting, FreeBodies
from freebody.numeric.jets import Array
from freebody.study.pictures.action import Action

_MASS_CENTERS = ("g", "s", "cg", "com", "mass center", "mass centre", "mass_center", "schwerpunkt", "massenmittelpunkt")
_CENTERS = ("center", "centre", "middle", "mittelpunkt", "mitte")
_CONTACTS = ("contact", "contact point", "point of contact", "kontakt", "kontaktpunkt", "berührpunkt", "auflage")
_RIMS = {
    **dict.fromkeys(("left", "links"), (-1.0, 0.0)),
    **dict.fromkeys(("right", "rechts"), (1.0, 0.0)),
    **dict.fromkeys(("top", "oben"), (0.0, 1.0)),
    **dict.fromkeys(("bottom", "unten"), (0.0, -1.0)),
}
_AXIS_OF = re.compile(r"(?:axis of|achse von)\s+", re.IGNORECASE)
_AXIS = re.compile(r"([+-]?)([xyz])(?:[- ]?(?:axis|achse))?", re.IGNORECASE)


@dataclass(frozen=True, eq=False)
class Place:
    """Where a force is said to act. source: the connection or load that is named instead of a point; is_elsewhere:
    whether it is a point of another body alone."""

    points: tuple[Array, ...]
    source: str = ""
    is_elsewhere: bool = False


@dataclass(frozen=True, eq=False)
class Heading:
    """(2 or 3,) a direction, of a moment (1 or 3,) that of its axis; has_sense: whether it is said which way."""

    way: Array
    has_sense: bool


class Places:
    """Of bodies cut free. Raises ExpressionError for what there is not."""

    def __init__(self, free: FreeBodies, vocabulary: Vocabulary) -> None:
        self.free, self.system, self.vocabulary = free, free.system, vocabulary
        self.action = Action(free.snapshot)

    # -- places -------------------------------------------------------------------------------
    def place(self, text: str, *, is_couple: bool = False) -> Place:
        """What stands behind `at`. A couple acts anywhere: of a point and a joint of one name the joint is meant."""
        word = text.lower()
        own = [self.system.bodies[name] for name in self.free.bodies]
        named = [self._point(body.point(text)) for body in own if text in body.points]
        if named and not (is_couple and any(a.source == text for a in self.free.outside)):
            return Place(tuple(named))
        for source in dict.fromkeys(a.source for a in (*self.free.outside, *self.free.inside)):
            if source.lower() == word:
                return self._of_source(source)
        if (found := self._of_words(word)) is not None:
            return found
        if (point := self._named(text)) is not None:
            body, at = point
            return Place((at,), is_elsewhere=body not in (*self.free.bodies, GROUND))
        others = [a for a in self.free.elsewhere if a.source.lower() == word]
        if others:
            return Place(tuple(a.at for a in others), others[0].source, is_elsewhere=True)
        known = [*(n for body in own for n in body.points), *(a.source for a in self.free.outside), "G"]
        raise ExpressionError(
            Message("there is no point {name} here.{hint}", name=text, hint=did_you_mean(text, known))
        )

    def _of_source(self, source: str) -> Place:
        acting = (*self.free.outside, *self.free.inside)
        return Place(tuple(a.at for a in acting if a.source == source), source)

    def _of_words(self, word: str) -> Place | None:
        """Words that every body has a point for."""
        own = [self.system.bodies[name] for name in self.free.bodies]
        if word in _MASS_CENTERS:
            return Place(tuple(self._point(body.mass_center) for body in own))
        if word in _CENTERS:
            return Place(tuple(self._point(body.center) for body in own))
        if word in _CONTACTS:
            touching = dict.fromkeys(a.source for a in self.free.outside if a.is_normal)
            if len(touching) == 1:
                return self._of_source(next(iter(touching)))
            if touching:
                raise ExpressionError(Message("say which contact: {names}", names=", ".join(touching)))
        if word in _RIMS and not self.system.space:
            round_ones = [(body, self.free.snapshot.scalar(body.radius)) for body in own if body.radius is not None]
            if round_ones:
                way = np.array(_RIMS[word])
                return Place(tuple(self._point(body.center) + r * way for body, r in round_ones))
        return None

    def _named(self, text: str) -> tuple[str, Array] | None:
        """A point of the ground or of any body, or a body, by its middle."""
        body, _, point = text.rpartition(".")
        if not body and text in self.system.bodies and text != GROUND:
            return text, self._point(self.system.bodies[text].center)
        of = self.system.bodies.get(body or GROUND)
        if of is None or point not in of.points:
            return None
        return of.name, self._point(of.point(point))

    def _point(self, point: Point) -> Array:
        return self.action.place(point)

    # -- directions ---------------------------------------------------------------------------
    def heading(self, force: TypedForce, place: Place | None) -> Heading | None:
        """The direction of an entry, of a moment that of its axis; None where none is told."""
        if force.is_couple and not self.system.space:
            return self._turning(force)
        match force.way:
            case "" | "any":
                return self._untold(force)
            case "compass":
                return Heading(self._compass(force), force.has_sense)
            case "along":
                return self._turned(self._line(force.of[0]), force)
            case "normal":
                return self._turned(self._normal(force.of[0]), force)
            case "about":
                way, turn = self._line(force.of[0]), force.turn or 1
                return Heading(way * turn, bool(force.turn) or force.of[0].strip().startswith(("+", "-")))
            case "towards" | "away":
                return self._towards(force, place)
            case "angle":
                return Heading(self._at_angle(self._angle(force.of[0]), force.text), True)
            case "components":
                return Heading(self._of_components(force), True)

    def _turning(self, force: TypedForce) -> Heading:
        """(1,) of a moment in the plane."""
        axis = _AXIS.fullmatch(force.of[0]) if force.way == "about" else None
        if axis is not None and axis[2].lower() == "z":
            return Heading(
                np.array((-1.0 if axis[1] == "-" else 1.0,)) * (force.turn or 1), bool(force.turn or axis[1])
            )
        if force.way not in ("", "any"):
            raise ExpressionError(
                Message("'{line}' is a moment: it turns about an axis and has no direction", line=force.text)
            )
        return Heading(np.array((float(force.turn or 1),)), force.turn != 0)

    def _untold(self, force: TypedForce) -> None:
        if force.turn:
            raise ExpressionError(Message("'{line}': say about which axis it turns", line=force.text))

    def _of_components(self, force: TypedForce) -> Array:
        if len(force.of) != len(self.system.up):
            raise ExpressionError(
                Message("'{line}' has {n} components, not {own}", line=force.text, n=len(force.of), own=self._n)
            )
        way = np.array([self._number(part) for part in force.of])
        if not way.any():
            raise ExpressionError(Message("'{line}' has no direction", line=force.text))
        return way * (force.turn or 1) / float(np.linalg.norm(way))

    @property
    def _n(self) -> int:
        return 3 if self.system.space else 2

    def _compass(self, force: TypedForce) -> Array:
        """In space right is along x, as in a model file, and what is level has no one direction."""
        word = "right" if force.compass == "level" and not self.system.space else force.compass
        return self._named_direction(word, force.text)

    def _named_direction(self, word: str, line: str) -> Array:
        found = self.system.names.named_direction(word.removeprefix("+"))
        if found is None:
            raise ExpressionError(Message("'{line}': say in which direction it acts", line=line))
        return self._along(found)

    def _turned(self, way: Array, force: TypedForce) -> Heading:
        """A line with the sense that a word of the compass gives it."""
        if not force.has_sense:
            return Heading(way, False)
        along = float(way @ self._compass(force))
        return Heading(way if along > 0 else -way, abs(along) > 1e-9)

    def _at_angle(self, angle: float, line: str) -> Array:
        if self.system.space:
            raise ExpressionError(Message("'{line}': in space an angle gives no direction", line=line))
        return np.array((math.cos(angle), math.sin(angle)))

    def _normal(self, text: str) -> Array:
        """Across a line of the plane; in space along the normal of a plane or a contact."""
        if not self.system.space:
            way = self._line(text)
            return np.array((-way[1], way[0]))
        touching = next((a for a in self.free.outside if a.is_normal and a.source == text), None)
        if touching is not None:
            return touching.way
        plane = self.system.names.plane(text)
        if plane is None:
            raise ExpressionError(Message("there is no plane {name} here", name=text))
        return self._along(plane.normal)

    def _towards(self, force: TypedForce, place: Place | None) -> Heading:
        start = self._of_place(force) if place is None or not place.points else place.points[0]
        away = self._aim(force.of[0]) - start
        size = float(np.linalg.norm(away))
        if size < self.free.small:
            raise ExpressionError(Message("'{line}' has no direction", line=force.text))
        return Heading((-1.0 if force.way == "away" else 1.0) * away / size, True)

    def _of_place(self, force: TypedForce) -> Array:
        body, *others = self.free.bodies
        if others or not self.free.is_point(body):
            raise ExpressionError(Message("'{line}': say at which point it acts", line=force.text))
        return self.action.center(body)

    def _aim(self, text: str) -> Array:
        """What a force points to: a point, or the middle of a body."""
        found = self._named(text)
        return self.place(text).points[0] if found is None else found[1]

    def _line(self, text: str) -> Array:
        """(2 or 3,) along a line of the ground or of a body, a connection, a body from its start to its end, another
        direction with a name, or at an angle in the parameters."""
        text = _AXIS_OF.sub("", text)
        if not text:
            raise ExpressionError(Message("say along which line"))
        if (axis := _AXIS.fullmatch(text)) is not None and (axis[2].lower() != "z" or self.system.space):
            way = np.eye(self._n)["xyz".index(axis[2].lower())]
            return -way if axis[1] == "-" else way
        body, _, line = text.rpartition(".")
        of = self.system.bodies.get(body or GROUND)
        if of is not None and line in of.lines:
            return self._along(of.lines[line].direction)
        acting = (*self.free.outside, *self.free.inside, *self.free.elsewhere)
        if found := [a for a in acting if a.source == text and not a.is_couple]:
            return self._of_connection(found, text)
        if (own := self.system.bodies.get(text)) is not None and {"start", "end"} <= own.points.keys():
            away = self._point(own.point("end")) - self._point(own.point("start"))
            return away / float(np.linalg.norm(away))
        if (named := self.system.names.named_direction(text)) is not None:
            return self._along(named)
        try:
            angle = self._angle(text)
        except ExpressionError:
            known = [*self.system.bodies[GROUND].lines, *(a.source for a in acting)]
            told = Message("there is no line {name} here.{hint}", name=text, hint=did_you_mean(text, known))
            raise ExpressionError(told) from None
        return self._at_angle(angle, text)

    def _of_connection(self, found: list[Acting], text: str) -> Array:
        """Along a contact is along its tangent; along a string or a link is along its force; along a joint in space is
        along its axis."""
        if self.system.space and sum(a.body == found[0].body for a in found) > 1:
            return self._axis(found[0], text)
        normal = next((a for a in found if a.is_normal), None)
        if normal is not None:
            return np.array((normal.way[1], -normal.way[0]))
        return found[0].way

    def _axis(self, a: Acting, text: str) -> Array:
        """(3,) the one direction about which a joint transmits no moment, or along which it transmits no force."""
        own = [b for b in (*self.free.outside, *self.free.inside, *self.free.elsewhere) if b.source == a.source]
        own = [b for b in own if b.body == a.body]
        for is_couple in (True, False):
            ways = np.array([b.way for b in own if b.is_couple == is_couple])
            if len(ways) == 2:
                way = np.cross(*ways)
                return np.asarray(way / float(np.linalg.norm(way)), dtype=np.float64)
        raise ExpressionError(Message("{name} has no axis", name=text))

    def _along(self, direction: Direction) -> Array:
        zero = tuple(0 * c for c in direction.components)
        away = self._point(Point(direction.body, direction.components)) - self._point(Point(direction.body, zero))
        return away / float(np.linalg.norm(away))

    # -- numbers ------------------------------------------------------------------------------
    def _angle(self, text: str) -> float:
        """[rad]"""
        degrees = re.fullmatch(r"([-+]?[0-9]+(?:\.[0-9]*)?) deg", text)
        return math.radians(float(degrees[1])) if degrees is not None else self._number(text)

    def _number(self, text: str) -> float:
        expr = readings(text, self.vocabulary)[0]
        if strange := sorted(free_symbols(expr) - self.system.parameters.keys()):
            raise ExpressionError(
                Message("{names} is not a quantity of this problem.{hint}", names=strange[0], hint="")
            )
        return self.free.snapshot.scalar(expr)
