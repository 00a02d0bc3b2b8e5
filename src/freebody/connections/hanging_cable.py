"""Hanging cable: a flexible cable between two supports that stand still, in equilibrium.

With H the horizontal part of its tension, the same all along it, l how far the supports are apart along the level and h
how much the second is higher than the first, x counted from the lowest place of its line and a = H/w

    even along the level (load q: a deck)    y = q x^2/(2 H)         sag q l^2/(8 H)
    by its own weight (weight w: a chain)    y = a cosh(x/a)         T = w y, level supports: sag a (cosh(l/(2 a)) - 1)

x_m is the x of the middle of the supports: H h/(q l), or sinh(x_m/a) = h/(2 a sinh(l/(2 a))). At x the upright part of
the tension is V = q x, or w a sinh(x/a). The sag is the greatest depth below the straight line between the supports.
Source: Beer & Johnston, Vector Mechanics for Engineers: Statics, sec. 7.4 and 7.5; Meriam & Kraige, Statics, sec. 5/8.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.standing import arm_on_ground, number_of, stands_at, vanishes
from freebody.connections.standing_in_space import axes_at_start
from freebody.language.expression import Call, Expr, add, divide, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import FORCE, LENGTH, STIFFNESS
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import DOWN, GROUND, LEFT, ONE, RIGHT, UP, ZERO, Components, Point
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad, RigidBody
from freebody.model.glyphs import Glyph
from freebody.model.rotations import applied
from freebody.model.spec import Formula
from freebody.model.transmitted import CutTension, Transmitted

if TYPE_CHECKING:
    from freebody.model.names import Names

_N_DRAWN = 24  # straight parts of a drawn cable
_FORCE_PER_LENGTH = STIFFNESS


class HangingCable(Connection, kind="hanging_cable"):
    """`hanging_cable: {between: [ground.A, ground.B], weight: w, pull: H}`: a flexible cable, or a chain, that hangs
    between two points that stand still. `weight` is its own weight per length (a catenary), `load` in its place what
    hangs on it per length of the level, as the deck of a suspension bridge (a parabola). `pull` is the horizontal part
    of its tension; of a parabola the `sag` says it as well. Its supports are pulled by it. Ask for the `tension of
    cable at ground.A`, its `sag`, its `length`, its `horizontal pull` or its `greatest tension`, and for the pull that
    a length or a sag asks for: `value of H for which length of cable = s`."""

    called: ClassVar[tuple[str, ...]] = ("catenary", "suspension_cable", "hanging_chain")

    between: tuple[str, str]
    weight: Formula | None = None
    load: Formula | None = None
    pull: Formula | None = None
    sag: Formula | None = None

    in_plane = True
    example = """
ground: {points: {A: [0, 0], B: [10 m, 1 m], G: [-1 m, 0]}}
bodies: {mast: {rod: {mass: 1 kg, length: 1 m}, angle: 90 deg}}
connections:
  foot: {pin: [ground.A, mast.start]}
  guy: {link: [ground.G, mast.end]}
  it: {hanging_cable: {between: [mast.end, ground.B], weight: 2 N/m, pull: 30 N}}
"""

    def brings(self, names: Names) -> dict[str, AppliedLoad]:
        """What it pulls its supports with, to each other and down."""
        cable = self._cable(names)
        if cable is None:
            return {}
        me, found = self.own_name(names), dict[str, AppliedLoad]()
        for end, (inwards, point) in enumerate(zip((RIGHT, LEFT), cable.ends, strict=True)):
            body = names.known(point.body)
            if body.fixed or point.body == GROUND:
                continue
            if not any(c.is_rigid and body.name in c.mentions(names) for c in names.connections.values()):
                told = Message("{cable} pulls {body} as it does where this starts", cable=me, body=body.name)
                names.assumptions.append(told)
            for called, along, force in (("inwards", inwards, cable.pull), ("downwards", DOWN, cable.upright(end))):
                push = AppliedLoad("", Displacement(point, names.ground_origin, along), force)
                found[f"{me}_{called}_at_{point.body}"] = push
        return found

    def transmitted(self, names: Names) -> Mapping[str, Transmitted]:
        cable = self._cable(names)
        if cable is None:
            return {}
        return {
            "sag": Transmitted(cable.sag, LENGTH),
            "length": Transmitted(cable.length, LENGTH),
            "horizontal pull": Transmitted(cable.pull, FORCE),
            "greatest tension": Transmitted(cable.tension(1 if number_of(names, cable.rise) >= 0.0 else 0), FORCE),
        }

    def tensions(self, names: Names) -> Mapping[str, CutTension]:
        """At its supports."""
        cable = self._cable(names)
        if cable is None:
            return {}
        still = Displacement(*cable.ends, RIGHT)
        found = dict[str, CutTension]()
        for end, point in enumerate(cable.ends):
            cut = CutTension((), still, cable.tension(end), ZERO, ZERO, ZERO)
            found |= {f"at {name}": cut for name in dict.fromkeys((str(point), point.name, point.body))}
        return found

    def _cable(self, names: Names) -> _Cable | None:
        """Its shape; None with a problem noted."""
        n_before = len(names.problems)
        if names.space and tuple(names.up[:2]) != (ZERO, ONE):
            names.problem(Message("a cable hangs in the plane of x and y: let up be y"))
            return None
        points = [names.point(text, "between", k) for k, text in enumerate(self.between)]
        if (self.weight is None) == (self.load is None):
            told = Message("give either weight, its own per length, or load, what hangs on it per length of the level")
            names.problem(told)
        elif (self.pull is None) == (self.sag is None):
            names.problem(Message("give its pull, the horizontal part of its tension, or of a parabola its sag"))
        elif self.weight is not None and self.sag is not None:
            told = Message(
                "the pull of a cable with its own weight follows from its sag by no formula: give pull: H, and ask for "
                "'value of H for which sag of {me} = f'",
                me=self.own_name(names),
            )
            names.problem(told, "sag")
        if len(names.problems) > n_before:
            return None
        first, second = (_place(names, point) for point in points)
        for key, point, place in zip((0, 1), points, (first, second), strict=True):
            if place is None:
                told = Message(
                    "where {point} stands is not told, and a cable hangs between supports that stand still: put its "
                    "body there (at), or join it to the ground",
                    point=point,
                )
                names.problem(told, "between", key)
        if first is None or second is None:
            return None
        span, rise = (add(q, negate(p)) for p, q in zip(first, second, strict=True))
        rise = ZERO if vanishes(names, rise) else rise
        if number_of(names, span) < 0.0:
            points, span, rise = points[::-1], negate(span), negate(rise)
        if number_of(names, span) == 0.0:
            names.problem(Message("its supports stand above each other, where a cable hangs straight"), "between")
            return None
        given = "weight" if self.load is None else "load"
        q = names.positive(self, given, _FORCE_PER_LENGTH)
        if self.sag is None:
            pull = names.positive(self, "pull", FORCE)
        else:
            pull = divide(multiply(q, span, span), multiply(number(8), names.positive(self, "sag", LENGTH)))
        kind = _Parabola if self.load is not None else _Catenary
        return kind((points[0], points[1]), span, rise, q, pull)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        cable = self._cable(names)
        if cable is None:
            return
        (x, y), span = _in_numbers(names, *(_place(names, cable.ends[0]) or ())), number_of(names, cable.span)
        slopes = _in_numbers(names, cable.slope(0), cable.slope(1))
        heights = [cable.height_drawn(slopes, span, k / _N_DRAWN) for k in range(_N_DRAWN + 1)]
        places = [(number(x + span * k / _N_DRAWN), number(y + up)) for k, up in enumerate(heights)]
        yield glyphs.Relation(tuple(Point(GROUND, place) for place in places))


@dataclass(frozen=True)
class _Cable:
    """How a cable hangs between its ends, the left one first: how far these are apart along the level, how much the
    second one is higher, its load per length and its pull."""

    ends: tuple[Point, Point]
    span: Expr
    rise: Expr
    q: Expr
    pull: Expr

    @property
    def reach(self) -> Expr:
        """q l/(2 H)."""
        return divide(multiply(self.q, self.span), multiply(number(2), self.pull))

    def slope(self, end: int) -> Expr:
        """dy/dx at an end."""
        raise NotImplementedError

    @property
    def sag(self) -> Expr:
        raise NotImplementedError

    @property
    def length(self) -> Expr:
        raise NotImplementedError

    def tension(self, end: int) -> Expr:
        slope = self.slope(end)
        return multiply(self.pull, Call("sqrt", add(ONE, multiply(slope, slope))))

    def upright(self, end: int) -> Expr:
        """The upright part of the tension, with which the cable pulls an end down."""
        return multiply(number(2 * end - 1), self.pull, self.slope(end))

    def height_drawn(self, slopes: Sequence[float], span: float, share: float) -> float:
        """How much higher than its first end it is, from its slopes, a share of its span away."""
        raise NotImplementedError


class _Parabola(_Cable):
    """y' = h/l -+ q l/(2 H) at its ends."""

    def slope(self, end: int) -> Expr:
        return add(divide(self.rise, self.span), multiply(number(2 * end - 1), self.reach))

    @property
    def sag(self) -> Expr:
        return divide(multiply(self.reach, self.span), number(4))

    @property
    def length(self) -> Expr:
        """H/(2 q) [u sqrt(1 + u^2) + arsinh u] from one slope to the other."""
        each = divide(self.pull, multiply(number(2), self.q))
        if self.rise == ZERO:
            return multiply(number(2), each, _arc(self.reach))
        return multiply(each, add(_arc(self.slope(1)), negate(_arc(self.slope(0)))))

    def height_drawn(self, slopes: Sequence[float], span: float, share: float) -> float:
        first, last = slopes
        return span * (first * share + (last - first) * share * share / 2)


class _Catenary(_Cable):
    """y' = sinh(x/a), a = H/w."""

    def _at(self, end: int) -> Expr:
        """x/a at an end."""
        own = multiply(number(2 * end - 1), self.reach)
        if self.rise == ZERO:
            return own
        a = divide(self.pull, self.q)
        return add(_arsinh(divide(self.rise, multiply(number(2), a, Call("sinh", self.reach)))), own)

    def slope(self, end: int) -> Expr:
        return multiply(number(2 * end - 1), Call("sinh", self._outwards(end)))

    def _outwards(self, end: int) -> Expr:
        """x/a at an end, counted positive away from the other one, so that no sinh(-x) is left."""
        return self._at(end) if end else negate(self._at(end))

    def tension(self, end: int) -> Expr:
        return multiply(self.pull, Call("cosh", self._at(end)))

    @property
    def sag(self) -> Expr:
        """Where y' = h/l."""
        a, k, first = divide(self.pull, self.q), divide(self.rise, self.span), self._at(0)
        if self.rise == ZERO:
            return multiply(a, add(Call("cosh", self.reach), negate(ONE)))
        lowest = Call("sqrt", add(ONE, multiply(k, k)))
        along = multiply(k, add(_arsinh(k), negate(first)))
        return multiply(a, add(Call("cosh", first), along, negate(lowest)))

    @property
    def length(self) -> Expr:
        level = multiply(number(2), divide(self.pull, self.q), Call("sinh", self.reach))
        if self.rise == ZERO:
            return level
        return Call("sqrt", add(multiply(level, level), multiply(self.rise, self.rise)))

    def height_drawn(self, slopes: Sequence[float], span: float, share: float) -> float:
        first, last = (math.asinh(slope) for slope in slopes)
        a = span / (last - first)
        return a * (math.cosh(first + (last - first) * share) - math.cosh(first))


def _arsinh(x: Expr) -> Expr:
    return Call("log", add(x, Call("sqrt", add(ONE, multiply(x, x)))))


def _arc(u: Expr) -> Expr:
    """u sqrt(1 + u^2) + arsinh u."""
    return add(multiply(u, Call("sqrt", add(ONE, multiply(u, u)))), _arsinh(u))


def _place(names: Names, point: Point) -> Components | None:
    """Where a support stands at the start: where it is held, or as its body is put or joined to what stands still, at
    the angle with which it starts."""
    if (held := _held(names, point)) is not None:
        return held
    body = names.known(point.body)
    known = [] if body.start.at is None else [(body.points[body.start.at[0]], body.start.at[1])]
    for own, other in _joined(names, body):
        if (place := _held(names, other)) is not None:
            known.append((own.offset, place))
    if not known:
        return None
    own, place = known[0]
    arm = _arm(names, body, own, point.offset)
    return None if arm is None else tuple(add(p, q) for p, q in zip(place, arm, strict=False))


def _arm(names: Names, body: RigidBody, start: Components, end: Components) -> Components | None:
    """From one point of a body to another one as it starts; None where the axes about which it is turned have angles
    of their own."""
    if not names.space:
        return arm_on_ground(body, start, end)
    if any(turn.name for turn in body.start.turned or ()):
        return None
    return applied(axes_at_start(body), tuple(add(q, negate(p)) for p, q in zip(start, end, strict=True)))


def _held(names: Names, point: Point) -> Components | None:
    x, y = (stands_at(names, point, along) for along in (RIGHT, UP))
    return None if x is None or y is None else (x, y)


def _joined(names: Names, body: RigidBody) -> Iterator[tuple[Point, Point]]:
    """The points of a body at which others meet it, and those of the others."""
    for connection in names.connections.values():
        if connection.meeting is None or body.name not in connection.mentions(names):
            continue
        with names.quietly():
            first, second = (names.point(getattr(connection, key), key) for key in connection.meeting)
        for own, other in ((first, second), (second, first)):
            if own.body == body.name:
                yield own, other


def _in_numbers(names: Names, *values: Expr) -> tuple[float, ...]:
    return tuple(number_of(names, value) for value in values)
