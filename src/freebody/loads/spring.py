"""Linear springs and dampers between two points, torsional ones between two bodies."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, ClassVar, Literal

from freebody.connections.standing import stands_at
from freebody.language.expression import ZERO, Call, Expr, Symbol, add, divide, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import (
    DAMPING,
    DIMENSIONLESS,
    FORCE,
    LENGTH,
    ROTARY_DAMPING,
    ROTARY_STIFFNESS,
    STIFFNESS,
)
from freebody.loads.base import Load
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import AXES, GROUND, ONE, Direction, Point
from freebody.measures.turn import Turn
from freebody.model import glyphs
from freebody.model.elements import RATE, VALUE, AppliedLoad
from freebody.model.glyphs import Glyph
from freebody.model.one_sided import OneSided
from freebody.model.rotations import perpendiculars
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


_ONLY = {
    **dict.fromkeys(("compression", "in compression", "push", "pushes", "pressure", "Druck"), "compressed"),
    **dict.fromkeys(("tension", "in tension", "extension", "pull", "pulls", "Zug"), "stretched"),
}


_TWO_POINTS = Message(
    "it acts between two points, of which one on the ground has a place: {{from: [0.6 m, -0.3 m], to: bar.end}}"
)


class Spring(Load, kind="spring"):
    """`spring: {first: ground.A, second: block, stiffness: k, length: l0}`: pulls with k (l - l0); without a
    natural length it is relaxed at the start. One of length 0 pulls with k r, also through the point itself.
    `preload: F0` in place of a length: it pulls with F0 at the start, or pushes where that is negative.
    `only: compressed` is a buffer on `first`: it pushes with k (l0 - l) where the points are closer than its length,
    and is not touched where they are farther apart; with a preload it pushes with that at once. `only: stretched` pulls
    alone."""

    also: ClassVar[tuple[str, ...]] = ("Feder",)

    elsewhere: ClassVar[Mapping[str, str]] = {"at": _TWO_POINTS}

    first: str
    second: str
    stiffness: Formula
    length: Formula | None = None
    preload: Formula | None = None
    only: Literal["compressed", "stretched"] | None = None

    pulling_sign = -1
    stores_energy = True
    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 0]}}
loads: {it: {spring: {first: ground.A, second: ball, stiffness: 5 N/m, length: 1 m}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        k = names.positive(self, "stiffness", STIFFNESS)
        natural = names.length_or(self, "length")
        if natural is not None and self.preload is not None and self.only is None:
            names.problem(Message("a spring with a preload at the start has no length of its own to give"), "preload")
        if natural == ZERO and self.only is None:
            # -k (r_B - r_A) along each axis: where the points meet a distance has no direction, this force is zero
            axes = zip("xyz" if names.space else "xy", AXES, strict=False)
            return [AppliedLoad(x, Displacement(second, first, e), negate(multiply(k, VALUE))) for x, e in axes]
        distance = Distance(first, second)
        if self.only is not None:
            return self._one_sided(names, k, natural, distance)
        if natural is None:
            stretch = Combination(((ONE, distance),), LENGTH)
            pull = ZERO if self.preload is None else names.formula(self.preload, FORCE, "preload")
            if self.preload is None:
                self._assume_relaxed(names, {first.body, second.body} - {GROUND})
            return [AppliedLoad("", stretch, negate(multiply(k, VALUE) + pull))]
        stretch = Composed(Symbol("@length") - natural, (("@length", distance),), LENGTH)
        return [AppliedLoad("", stretch, negate(multiply(k, VALUE)))]

    def _assume_relaxed(self, names: Names, bodies: set[str]) -> None:
        """Without a length it is relaxed at the start; where the start only moves its ends away nobody knows what is
        meant: relaxed there, nothing would begin to move."""
        moved = [
            name
            for name, value in names.placed_at_start.items()
            if value != ZERO
            and names.start_rates.get(name, ZERO) == ZERO
            and names.measures[name].dimension == LENGTH
            and bodies & set(names.measures[name].bodies())
        ]
        if moved:
            told = Message(
                "the spring has no length, and may be stretched where {measure} starts: give its length, e.g. length: "
                "0.5 m, or preload: 0 where it is relaxed at the start",
                measure=moved[0],
            )
            names.problem(told)
            return
        told = Message(
            "the spring from {first} to {second} is relaxed at the start", first=self.first, second=self.second
        )
        if told not in names.assumptions:
            names.assumptions.append(told)

    def _one_sided(self, names: Names, k: Expr, natural: Expr | None, distance: Distance) -> list[AppliedLoad]:
        """With e = l - l0: (e - |e|)/2 is e where it is negative and 0 elsewhere, (1 - sign e)/2 is 1 there; beside it
        the same with +. The preload F0 >= 0 adds to k |e|."""
        if natural is None or natural == ZERO:
            names.problem(Message("a spring that is only {only} needs its length", only=self.only), "only")
            return []
        pulls = self.only == "stretched"
        stretch = Composed(Symbol("@length") - natural, (("@length", distance),), LENGTH)
        one, two = number(1 if pulls else -1), number(2)
        acting, force = multiply(k, VALUE), divide(multiply(k, VALUE + one * Call("abs", VALUE)), two)
        if self.preload is not None:
            preload = multiply(one, names.positive(self, "preload", FORCE))
            acting += preload
            force += divide(multiply(preload, 1 + one * Call("sign", VALUE)), two)
        border = OneSided(distance, natural, stretch, negate(acting), pulls)
        return [AppliedLoad("", stretch, negate(force), one_sided=border)]

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`only: compression` as `only: compressed`."""
        given = super().from_plain(value)
        return given | ({"only": _ONLY[said]} if (said := str(given.get("only"))) in _ONLY else {})

    @property
    def drawn_sign(self) -> int:
        """A buffer pushes."""
        return -self.pulling_sign if self.only == "compressed" else self.pulling_sign

    def pulls_with(self, laws: Sequence[Any], sqrt: Callable[[Any], Any]) -> Any:
        return _pulls_with(super().pulls_with, laws, sqrt)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        longest = names.length_or(self, "length") if self.only == "compressed" else None
        yield glyphs.Spring(names.point(self.first), names.point(self.second), longest=longest)


def _pulls_with(one: Callable[..., Any], laws: Sequence[Any], sqrt: Callable[[Any], Any]) -> Any:
    """By its size where it acts along several axes."""
    return one(laws, sqrt) if len(laws) == 1 else sqrt(sum(x * x for x in laws))


def _is_level(names: Names, first: Point, second: Point, across: Direction) -> bool:
    """Whether nothing moves two points across a line, and both are on it."""
    at = [stands_at(names, point, across) for point in (first, second)]
    return at[0] is not None and at[1] is not None and names.numeric(add(at[1], negate(at[0]))) == 0.0


class Damper(Load, kind="damper"):
    """`damper: {first: ground.A, second: block, damping: c}`: pulls with c dl/dt. `only: compressed` resists while it
    is pressed together and gives way freely while it is pulled apart, as a door closer does; `only: stretched` resists
    while it is pulled apart. With a `length` it acts where the points are closer than that (`compressed`), or farther
    apart (`stretched`), and resists both ways there, as the damper beside a buffer of the same length."""

    called: ClassVar[tuple[str, ...]] = ("dashpot", "shock absorber")
    also: ClassVar[tuple[str, ...]] = ("dashpot", "Dämpfer")

    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("damping_ratio", "zeta"),
            Message(
                "it has a damping c, which is 2*zeta*sqrt(k*m) for a mass on a spring: {{damping: 2*zeta*sqrt(k*m)}}"
            ),
        ),
        "at": _TWO_POINTS,
    }

    first: str
    second: str
    damping: Formula
    length: Formula | None = None
    only: Literal["compressed", "stretched"] | None = None

    resists = True
    pulling_sign = -1
    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 0]}}
loads: {it: {damper: {first: ground.A, second: ball, damping: 5 N s/m}}}
"""

    def among(self, names: Names, push: AppliedLoad, others: Sequence[AppliedLoad]) -> list[AppliedLoad]:
        """Beside a spring of length 0 between the same points, which may meet: on a straight guide through both it acts
        by -c (v_B - v_A) along each axis, as that spring does, since the distance of points that meet has no
        direction."""
        first, second = names.point(self.first), names.point(self.second)
        drawn = [o.measure for o in others if isinstance(o.measure, Displacement)]
        if self.only is not None or not any({m.of, m.origin} == {first, second} for m in drawn) or names.space:
            return [push]
        lines = (line.direction for line in names.bodies[GROUND].lines.values())
        if not any(_is_level(names, first, second, across.normal()) for across in (*lines, *AXES[:2])):
            return [push]
        ways = zip("xy", AXES, strict=False)
        return [replace(push, component=x, measure=Displacement(second, first, along)) for x, along in ways]

    def pulls_with(self, laws: Sequence[Any], sqrt: Callable[[Any], Any]) -> Any:
        return _pulls_with(super().pulls_with, laws, sqrt)

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        distance = Distance(names.point(self.first, "first"), names.point(self.second, "second"))
        c, natural = names.positive(self, "damping", DAMPING), names.length_or(self, "length")
        side, two = number(1 if self.only == "stretched" else -1), number(2)
        if self.only is None:
            if natural is not None:
                told = Message("a damper with a length acts on one side of it: only: compressed")
                names.problem(told, "length")
            return [AppliedLoad("", distance, negate(multiply(c, RATE)))]
        if natural is None:  # (v + |v|)/2 is v where the ends part and 0 where they approach; (v - |v|)/2 the reverse
            return [AppliedLoad("", distance, negate(divide(multiply(c, RATE + side * Call("abs", RATE)), two)))]
        # (1 + sign e)/2 is 1 where it is longer than its length, and 0 elsewhere; (1 - sign e)/2 the reverse
        stretch = Composed(Symbol("@length") - natural, (("@length", distance),), LENGTH)
        force = divide(multiply(multiply(c, RATE), 1 + side * Call("sign", VALUE)), two)
        border = OneSided(distance, natural, stretch, negate(multiply(c, RATE)), self.only == "stretched")
        return [AppliedLoad("", stretch, negate(force), one_sided=border)]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        longest = names.length_or(self, "length") if self.only == "compressed" else None
        first, second = names.point(self.first), names.point(self.second)
        yield glyphs.Spring(first, second, is_spring=False, is_damper=True, longest=longest)


def turn_about(names: Names, body: str, on: str, about: Heading | None) -> Measure:
    """How far a body has turned against another one; in space about an axis of that one."""
    of, base = names.body(body, "body"), names.body(on, "on")
    if not names.space:
        if about is not None:
            names.problem(Message("in the plane there is no axis to choose; in space write space: true"), "about")
        return Angle(of.name, base.name)
    if about is None:
        names.problem(Message("in space it needs an axis, e.g. about: z"), "about")
        return Angle(of.name, base.name)
    axis = names.direction(about, "about", body=base.name)
    b, c = perpendiculars(axis.components)
    return Turn(Direction(of.name, b), Direction(base.name, b), Direction(base.name, c))


class _OnBody(Load):
    """What turns a body against another one. Where one alone is named, as `on: wheel`, it is that body."""

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        fields = super().from_plain(value)
        is_alone = "on" in fields and "body" not in fields
        return {"body" if is_alone and key == "on" else key: each for key, each in fields.items()}


class TorsionalSpring(_OnBody, kind="torsional_spring"):
    """`torsional_spring: {body: rod, stiffness: k, on: ground, angle: 0}`: turns the body back with
    k (theta - angle). In space theta is the turn `about` an axis of the body that it is on."""

    also: ClassVar[tuple[str, ...]] = ("Drehfeder",)

    called: ClassVar[tuple[str, ...]] = ("spring",)

    body: str
    stiffness: Formula
    on: str = "ground"
    angle: Formula = 0
    about: Heading | None = None

    stores_energy = True
    example = """
bodies: {wheel: {disk: {mass: 1 kg, radius: 1 m}}}
loads: {it: {torsional_spring: {body: wheel, stiffness: 5 N m}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        theta = turn_about(names, self.body, self.on, self.about)
        k = names.positive(self, "stiffness", ROTARY_STIFFNESS)
        relaxed = names.formula(self.angle, DIMENSIONLESS, "angle")
        turned = theta if relaxed == ZERO else Composed(Symbol("@angle") - relaxed, (("@angle", theta),), DIMENSIONLESS)
        return [AppliedLoad("", turned, negate(multiply(k, VALUE)))]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        axis = names.direction(self.about, "about", body=self.on) if names.space else None
        yield glyphs.Coil(names.body(self.body).mass_center, names.body(self.on).mass_center, axis, is_spring=True)


class TorsionalDamper(_OnBody, kind="torsional_damper"):
    """`torsional_damper: {body: rod, damping: c, on: ground}`: resists with c dtheta/dt. In space
    theta is the turn `about` an axis of the body that it is on."""

    called: ClassVar[tuple[str, ...]] = ("damper",)

    body: str
    damping: Formula
    on: str = "ground"
    about: Heading | None = None

    resists = True
    example = """
bodies: {wheel: {disk: {mass: 1 kg, radius: 1 m}}}
loads: {it: {torsional_damper: {body: wheel, damping: 5 N m s}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        theta = turn_about(names, self.body, self.on, self.about)
        c = names.positive(self, "damping", ROTARY_DAMPING)
        return [AppliedLoad("", theta, negate(multiply(c, RATE)))]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        axis = names.direction(self.about, "about", body=self.on) if names.space else None
        yield glyphs.Coil(names.body(self.body).mass_center, names.body(self.on).mass_center, axis, is_spring=False)
