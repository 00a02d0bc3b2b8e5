"""Belt drive between two pulleys, open or crossed: without slip, or with friction on the smaller pulley.

A belt of the mass q per length that runs with v needs the tension q v^2 to go round; what is more presses it on the
pulley. With the coefficient mu and the angle of wrap phi it slips where

    (T_1 - q v^2)/(T_2 - q v^2) = e^(mu phi)         (Euler and Eytelwein with centrifugal tension).

Put on with the tension T_0, both runs together keep 2 T_0; the belt force is F = T_1 - T_2, hence

    F <= 2 (T_0 - q v^2) (e^(mu phi) - 1)/(e^(mu phi) + 1)          with a pretension T_0,
    F <= (T_max - q v^2) (1 - e^(-mu phi))                          where the tight run has its largest tension,

and the power F v is greatest at q v^2 = T_0/3, and T_max/3. In a groove of the angle beta mu is mu/sin(beta/2). Source:
Shigley, Mechanical Engineering Design, sec. 17-2; Meriam & Kraige, Statics, sec. 6/8.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.belt_in_space import BeltInSpace, belt_in_space, lies_flat, own_plane
from freebody.connections.belt_loop import BeltLoop, distance_of_centers
from freebody.connections.circles import own_radius, touching
from freebody.language.expression import ONE, ZERO, Call, Expr, Symbol, divide, free_symbols, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, FORCE, LENGTH, MASS, POWER, VELOCITY
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.distance import Distance
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad, ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import Friction, read_friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula
from freebody.model.transmitted import Transmitted

if TYPE_CHECKING:
    from freebody.model.names import Names

_WAY = "@belt"  # the way of the belt in the law of its friction; no user can type it


class Belt(Connection, kind="belt"):
    """`belt: [motor, drum]`, `belt: {first: motor, second: drum, crossed: true}`. An open belt turns both pulleys
    the same way, a crossed one opposite ways; bearings or a carrier keep the centres apart. The belt force is the
    difference of the tensions of its two runs, positive when it resists a counter-clockwise turn of the first pulley
    (1 row). With `friction` (in a groove of the `groove_angle`) it slips on the smaller pulley where the force is too
    large for its `pretension`, the tension of both runs at rest, or for its `largest_tension`, which a tightener
    keeps in the tight run. The pretension pulls at the bearings, too. `mass_per_length` takes from both at speed.
    `wrap` is the angle of wrap, without which it follows from the places of the bearings, as the `length` does,
    which is compared if it is given. In space it runs round pulleys with parallel axes whose bearings are on one
    body. A tightener that moves, as on a lever with a weight, needs the way of both runs: write a `string` that is
    wound on one pulley at both ends."""

    called: ClassVar[tuple[str, ...]] = ("band",)

    first: str
    second: str
    crossed: bool = False
    first_radius: Formula | None = None
    second_radius: Formula | None = None
    friction: Formula = 0
    pretension: Formula | None = None
    largest_tension: Formula | None = None
    mass_per_length: Formula = 0
    groove_angle: Formula | None = None
    wrap: Formula | None = None
    length: Formula | None = None

    in_plane = True
    follows_joints: ClassVar[bool] = True
    more_examples: ClassVar[dict[str, str]] = {
        "in a plane of its own": """
space: true
ground: {points: {A: [0, 0, 0], B: [0, 3 m, 4 m]}}
bodies: {a: {disk: {mass: 1 kg, radius: 1 m, axis: x}}, b: {disk: {mass: 1 kg, radius: 2 m, axis: x}}}
connections:
  p: {revolute: {first: ground.A, second: a, about: x}}
  q: {revolute: {first: ground.B, second: b, about: x}}
  it: {belt: [a, b]}
"""
    }
    example = """
bodies: {a: {disk: {mass: 1 kg, radius: 1 m}}, b: {disk: {mass: 1 kg, radius: 2 m}, at: [5 m, 0]}}
ground: {points: {A: [0, 0], B: [5 m, 0]}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, it: {belt: [a, b]}}
"""

    def is_in_plane(self, names: Names) -> bool:
        return lies_flat(names, (self.first, self.second))

    def rows(self, names: Names) -> list[ConstraintRow]:
        row = self._row(names)
        if row is None:
            return []
        self._loop(names).look(names, names.optional(self, "length", LENGTH))
        limit = self._limit(names)
        if limit is not None:
            self._note_speed(names, limit[0])
        return [row] if limit is None else []

    def _note_speed(self, names: Names, tension: Expr) -> None:
        """Beyond sqrt(T_0/q) a belt lifts off its pulleys."""
        mass = self._mass(names)
        speed = None if mass == ZERO else names.numeric(Call("sqrt", divide(tension, mass)))
        if speed is not None:
            told = Message(
                "{belt} runs slower than {speed:.4g} m/s, where its mass takes up the whole tension and it lifts off",
                belt=self.own_name(names),
                speed=speed,
            )
            names.assumptions.append(told)

    def _row(self, names: Names) -> ConstraintRow | None:
        first, second = names.body(self.first, "first"), names.body(self.second, "second")
        if first.name == second.name:
            names.problem(Message("a belt needs two pulleys, not {first} twice", first=first.name))
            return None
        radii = self._radii(names)
        if not self.is_in_plane(names):
            spatial = belt_in_space(names, (first, second), radii, crossed=self.crossed)
            return None if spatial is None else ConstraintRow("belt", "belt force", spatial.rolled, sign=-1)
        # on a carrier of constant length an open belt couples angles as an internal mesh does
        _distance, _total, rolled = touching(first.center, radii[0], second.center, radii[1], internal=not self.crossed)
        return ConstraintRow("belt", "belt force", rolled, sign=-1)

    def _radii(self, names: Names) -> tuple[Expr, Expr]:
        return own_radius(names, self, "first"), own_radius(names, self, "second")

    def _in_space(self, names: Names) -> BeltInSpace | None:
        with names.quietly():
            return own_plane(names, (self.first, self.second), self._radii(names), crossed=self.crossed)

    def _way(self, names: Names) -> Combination:
        """How far it has run over the first pulley."""
        spatial = self._in_space(names)
        return Combination(((self._radii(names)[0], Angle(self.first)),), LENGTH) if spatial is None else spatial.way

    def _loop(self, names: Names) -> BeltLoop:
        first, second = names.known(self.first), names.known(self.second)
        if (spatial := self._in_space(names)) is not None:
            return BeltLoop(self._radii(names), spatial.distance, self.crossed)
        return BeltLoop(self._radii(names), distance_of_centers(names, first, second), self.crossed)

    # -- what it can carry --------------------------------------------------------------------
    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        with names.quietly():
            row, limit = self._row(names), self._limit(names)
        if row is None or limit is None:
            return [], []
        way = self._way(names)
        row = ConstraintRow(row.component, row.reaction, row.measure, sign=row.sign, connection=connection)
        at_rest, share = limit
        speed = Symbol(f"rate({_WAY})")
        pressing = at_rest - self._mass(names) * speed * speed
        held = slipping = multiply(share, pressing)  # a limit below zero holds nothing
        if speed.name in free_symbols(pressing):  # faster than that the belt lifts off
            slipping = multiply(share, divide(pressing + Call("abs", pressing), number(2)))
        return [], [DryFriction(row, held, slipping, measures=((_WAY, way),))]

    def _mass(self, names: Names) -> Expr:
        return names.formula(self.mass_per_length, MASS / LENGTH, "mass_per_length")

    def _limit(self, names: Names) -> tuple[Expr, Expr] | None:
        """The tension that presses the belt at rest, and the part of it that can be carried; None without slip."""
        friction = self._friction(names)
        if friction.is_none:
            return None
        if (self.pretension is None) == (self.largest_tension is None):
            told = Message("friction of a belt needs its pretension, or its largest_tension, one of both")
            names.problem(told, "friction")
            return None
        wrap = self._wrap(names)
        if wrap is None:
            told = Message("the model does not say how far the pulleys are apart: give wrap, e.g. wrap: 160 deg")
            names.problem(told, "friction")
            return None
        mu = friction.static
        if self.groove_angle is not None:
            mu = divide(mu, Call("sin", divide(names.angle(self.groove_angle, "groove_angle"), number(2))))
        gain = Call("exp", multiply(mu, wrap))
        if self.pretension is None:
            return names.positive(self, "largest_tension", FORCE), ONE - divide(ONE, gain)
        return names.positive(self, "pretension", FORCE), divide(2 * (gain - ONE), gain + ONE)

    def _friction(self, names: Names) -> Friction:
        return read_friction(names, self.friction, DIMENSIONLESS)

    def _wrap(self, names: Names) -> Expr | None:
        if self.wrap is not None:
            return names.angle(self.wrap, "wrap")
        return self._loop(names).wrap(names)

    def brings(self, names: Names) -> dict[str, AppliedLoad]:
        """Both runs pull the pulleys together by 2 T_0 sin(phi/2), phi the angle of wrap, beside the belt force."""
        if self.pretension is None or self.first == self.second:
            return {}
        with names.quietly():
            wrap = self._wrap(names)
        if wrap is None:
            told = Message("the model does not say how far the pulleys are apart: give wrap, e.g. wrap: 160 deg")
            names.problem(told, "pretension")
            return {}
        pull = multiply(number(-2), names.positive(self, "pretension", FORCE), Call("sin", divide(wrap, number(2))))
        apart = Distance(names.body(self.first).center, names.body(self.second).center)
        return {f"pretension_of_{self.own_name(names)}": AppliedLoad("", apart, pull)}

    def loads_bearings(self, names: Names) -> Mapping[str, str]:
        """Without a pretension nobody knows how much both runs pull together."""
        if self.pretension is not None:
            return {}
        told = Message(
            "both runs of {belt} pull at it; give the belt its pretension, e.g. pretension: 300 N",
            belt=self.own_name(names),
        )
        return {self.first: told, self.second: told}

    # -- what is asked of it ------------------------------------------------------------------
    def transmitted(self, names: Names) -> Mapping[str, Transmitted]:
        way = self._way(names)
        found: dict[str, Transmitted] = {}
        if (length := self._loop(names).length) is not None:
            found["length"] = Transmitted(length, LENGTH)
        if (wrap := self._wrap(names)) is not None:
            found["angle of wrap"] = Transmitted(wrap, DIMENSIONLESS)
        if self.pretension is not None:
            pretension, half = names.positive(self, "pretension", FORCE), divide(ONE, number(2))
            found["tight tension"] = Transmitted(pretension, FORCE, "belt", half)
            found["slack tension"] = Transmitted(pretension, FORCE, "belt", -half)
        if self.largest_tension is not None:
            tight = names.positive(self, "largest_tension", FORCE)
            found["tight tension"] = Transmitted(tight, FORCE)
            found["slack tension"] = Transmitted(tight, FORCE, "belt", negate(ONE))
        limit = self._limit(names)
        if limit is None:
            return found
        at_rest, share = limit
        q = self._mass(names)
        found["greatest belt force"] = Transmitted(share * at_rest, FORCE, way=way, of_square=-share * q)
        if q != ZERO:
            speed = Call("sqrt", divide(at_rest, 3 * q))
            found["speed of greatest power"] = Transmitted(speed, VELOCITY)
            found["greatest power"] = Transmitted(share * divide(2 * at_rest, number(3)) * speed, POWER)
        return found

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        spatial = self._in_space(names)
        if spatial is not None:
            yield from spatial.glyphs()
            return
        centers = names.body(self.first).center, names.body(self.second).center
        yield glyphs.Belt(*centers, self._radii(names), is_crossed=self.crossed)
