"""Questions about what the two parts of a cut rod exert on each other: axial force, shear force, bending moment.

The part from the cut to `end` is a body by itself, with its share of the mass, rho = m/L, of the length l. With e along
the rod from `start` to `end`, n = e turned by +90 degrees and s from the cut to the middle of the part,

    N = e . (sum F + W - rho l a),    V = -n . (sum F + W - rho l a),
    M = sum (M_i + r_i x F_i) + s x (W - rho l a) - rho l^3/12 alpha,

where F_i and M_i are the forces and couples of connections and loads that act beyond the cut, W its weight, a the
acceleration of its middle. N > 0 is tension; V > 0 turns an element clockwise and M > 0 bends a rod that lies to the
right so that it sags: dM/dx = V. Where a force acts V jumps by it, and has a value just
before and just behind it. Source: Gere & Goodno, Mechanics of Materials, sec. 4.3; for moving bodies Beer &
Johnston, Vector Mechanics for Engineers: Dynamics, sec. 16.1 (d'Alembert).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.expression import (
    FLOAT_FUNCTIONS,
    ZERO,
    Expr,
    add,
    divide,
    evaluate,
    free_symbols,
    multiply,
    negate,
    number,
)
from freebody.language.sentences import NOTHING, Argument, Message, Sentence
from freebody.language.units import FORCE, LENGTH, TORQUE, Dimension
from freebody.measures.angle import Angle
from freebody.measures.geometry import ONE, Direction, Point
from freebody.model.elements import RigidBody, Spread
from freebody.model.solids import ROD
from freebody.model.state import State
from freebody.questions.along_a_rod import Pull, between, couple_not_placed, is_zero, on_axis, pulls_on, sign_of_length
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, PLACE, Found, asked
from freebody.questions.vectors import Vector, added, axes_of, components_of, cross, dot, place
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

Part = Literal["axial", "shear", "bending"]
Side = Literal["", "before", "behind"]
Order = tuple[tuple[Expr, ...], ...]  # places along a rod, in turn; those in one are the same
Field = tuple[Direction, Expr]  # of gravity: where it pulls to, and its strength

_LETTERS = 3  # of the name of a point that is said without its rod


@dataclass(frozen=True)
class SectionForce(Quantity, kind="section force"):
    """What is transmitted through a section of a rod at `offset` from its middle. named: the point, nothing where it is
    the same in every section."""

    body: str
    part: Part
    offset: Expr
    named: str
    fields: tuple[Field, ...]
    is_reversed: bool = False  # counted the other way: a thrust
    may_lie_beside: bool = False  # whether it depends on lengths that the section is one of the rod
    side: Side = ""  # just before the point, towards `start`, or just behind it
    order: Order = ()  # of the places at which something acts, where the lengths alone do not tell it
    along: Expr | None = None  # how far the section is from the start of the rod, where it has no name
    is_governing: bool = False  # whether the rod is loaded most there

    is_reaction = True
    example = """
bodies: {beam: {rod: {mass: 3 kg, length: 2 m}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: bending moment of beam at beam.center}
"""

    @property
    def dimension(self) -> Dimension:
        return TORQUE if self.part == "bending" else FORCE

    @property
    def letter(self) -> str:
        return {"axial": "N", "shear": "V", "bending": "M"}[self.part]

    @property
    def may_jump(self) -> bool:
        return True

    @property
    def reason(self) -> Sentence:
        part = "thrust" if self.is_reversed and self.part == "axial" else self.part
        kind = f"greatest_section.{self.part}" if self.is_governing else f"section.{part}"
        return Sentence(f"value.{kind}", {"body": self.body, "at": self._at})

    @property
    def _at(self) -> Argument:
        if self.along is not None:
            x = self.along if free_symbols(self.along) else f"{evaluate(self.along, {}, FLOAT_FUNCTIONS):g} m"
            return Sentence("what.section.along", {"x": x, "body": self.body})
        own = self.named.removeprefix(f"{self.body}.")
        point = own if len(own) <= _LETTERS else self.named  # C of the beam that is cut, but the center of beam
        return Sentence(f"what.section.{self.side or 'at'}", {"point": point}) if self.named else NOTHING

    @property
    def derived_by(self) -> str:  # pyrefly: ignore[bad-override]
        """As it lies among the loads, where that is still to be told."""
        return "section" if self.named and not self.order else ""

    @property
    def remarks(self) -> tuple[Message, ...]:
        if not self.may_lie_beside:
            return ()
        return (self._on_the_rod,)

    @property
    def _on_the_rod(self) -> Message:
        return Message("the section lies between {body}.start and {body}.end", body=self.body)

    def meant_within(self, system: Described) -> tuple[tuple[Expr, Message], ...]:
        if not self.may_lie_beside:
            return ()
        rod = system.bodies[self.body]
        ends = (rod.points["start"][0], self.offset), (self.offset, rod.points["end"][0])
        return tuple((add(behind, negate(before)), self._on_the_rod) for before, behind in ends)

    def placed(self, system: Described, state: State[Any]) -> SectionForce:
        """With the order of this section and of all places at which something acts on the rod; the state tells it in
        numbers. Raises CannotAnswer where one of them does not stay the same."""
        rod = system.bodies[self.body]
        return replace(self, order=in_order(rod, state, [*places_on(system, state, rod, self.part), self.offset]))

    def value(self, system: Described, state: State[Any]) -> Any:
        rod, axes = system.bodies[self.body], axes_of(system)
        self.refuse_beside(system, state)
        along = components_of(Direction(self.body, (ONE, *(ZERO,) * (len(axes) - 1))), state, len(axes))
        force, moment = self._own(system, state, rod)
        pulls = [pull for pull in pulls_on(system, state, rod) if self._is_beyond(state, rod, pull)]
        for pull in (*pulls, *self._spread_beyond(system, state, rod)):
            if pull.at is not None:
                arm = between(system, state, self._cut(rod), pull.at)
                force = added(force, pull.force)
                moment = added(moment, added(pull.couple, cross(arm, pull.force)))
        side = -1 if self.is_reversed else 1
        if self.part == "bending":
            return side * moment[0]
        if self.part == "shear":
            return side * (along[1] * force[0] - along[0] * force[1])
        return side * dot(along, force)

    def refuse_beside(self, system: Described, state: State[Any]) -> None:
        """Raises SaysNothing where numbers put the section beside the rod."""
        if self.along is None:
            return
        rod = system.bodies[self.body]
        along, length = state.scalar(self.along), state.scalar(rod.sizes[0])
        near = ROUNDED * length
        if isinstance(along, float) and not -near <= along <= length + near:
            told = Message("{x} lies beyond the ends of {body}", x=self.named, body=rod.name)
            raise SaysNothing(told)

    def _cut(self, rod: RigidBody) -> Point:
        return on_axis(rod, self.offset)

    def _own(self, system: Described, state: State[Any], rod: RigidBody) -> tuple[Vector, Vector]:
        """Weight and inertia of the part beyond the cut, and their moment about the cut."""
        n = len(axes_of(system))
        if rod.mass == ZERO:
            return (0,) * n, (0,) * (3 if system.space else 1)
        length = rod.sizes[0]
        part = add(divide(length, number(2)), negate(self.offset))
        share = divide(multiply(rod.mass, part), length)
        middle = on_axis(rod, divide(add(divide(length, number(2)), self.offset), number(2)))
        mass = state.scalar(share)
        force = tuple(-mass * a for a in place(system, state, middle, order=2))
        for along, strength in self.fields:
            weight = mass * state.scalar(strength)
            force = added(force, tuple(weight * c for c in components_of(along, state, n)))
        moment = cross(between(system, state, self._cut(rod), middle), force)
        if self.part == "bending":
            inertia = state.scalar(divide(multiply(share, multiply(part, part)), number(12)))
            moment = (moment[0] - inertia * state.acceleration(Angle(rod.name)),)
        return force, moment

    def _is_beyond(self, state: State[Any], rod: RigidBody, pull: Pull) -> bool:
        """Whether a pull acts between the cut and the end; a section at the start, or the end, is just inside of it."""
        if all(map(is_zero, (*pull.force, *pull.couple))):
            return False
        if self.part != "bending" and all(is_zero(f) for f in pull.force):
            return False  # a couple alone
        if pull.at is None:
            if pull.has_couple:
                raise couple_not_placed(rod, pull)
            told = Message("at which point of {body} {name} acts does not stay the same", body=rod.name, name=pull.name)
            raise CannotAnswer(told)
        is_at_an_end = pull.at.offset[0] in (rod.points["start"][0], rod.points["end"][0])
        if not (self.named or is_at_an_end):
            raise self._changes(rod, pull.name)
        if is_at_an_end:
            return pull.at.offset[0] == rod.points["end"][0]
        ahead = self._ahead(state, rod, pull.at.offset[0])
        if ahead == 0:
            if self.part == "bending" and not pull.has_couple:
                return True  # without an arm it has no moment
            if self.side:
                return self.side == "before"
            told = Message(
                "{name} acts in that very section, where it jumps: ask for it just before, or just behind {point}",
                name=pull.name,
                point=self.named,
            )
            raise CannotAnswer(told)
        if ahead is None:
            told = Message("whether {name} acts before or behind the section depends on lengths", name=pull.name)
            raise CannotAnswer(told)
        return ahead > 0

    def _changes(self, rod: RigidBody, name: str) -> CannotAnswer:
        told = Message(
            "{name} acts between the ends of {body}, so the axial force changes there; say where: axial force of "
            "{body} at POINT",
            name=name,
            body=rod.name,
        )
        return CannotAnswer(told)

    def _spread_beyond(self, system: Described, state: State[Any], rod: RigidBody) -> Iterator[Pull]:
        """What of the loads along lines of the rod acts beyond the cut, each where its sum acts."""
        for push in system.applied_loads:
            if push.spread is None or push.spread.first.body != rod.name:
                continue
            if any(c != ZERO for point in (push.spread.first, push.spread.second) for c in point.offset[1:]):
                told = Message("{name} does not act along the axis of {body}", name=push.load, body=rod.name)
                raise CannotAnswer(told)
            n = len(axes_of(system))
            slope = state.gradient(push.measure, rod.name)[:n]
            if not self.named:
                along = components_of(Direction(rod.name, (ONE, *(ZERO,) * (n - 1))), state, n)
                if not is_zero(dot(along, slope)):
                    raise self._changes(rod, push.load)
                continue
            found = self._part_beyond(state, rod, push.load, push.spread)
            if found is not None:
                share, at = found
                size = state.law(push) * state.scalar(share)
                force = tuple(size * c for c in slope)
                yield Pull(push.load, force, (0,) * (3 if system.space else 1), on_axis(rod, at), has_couple=False)

    def _part_beyond(self, state: State[Any], rod: RigidBody, name: str, spread: Spread) -> tuple[Expr, Expr] | None:
        """The share of a load along a line that acts beyond the cut, and where on the axis; None where nothing does.

        Between w_1 and w_2 on a length l it is (w_1 + w_2) l/2, at l/3 (w_1 + 2 w_2)/(w_1 + w_2)."""
        ends = [(spread.first.offset[0], ZERO if spread.rises else ONE), (spread.second.offset[0], ONE)]
        ahead = [self._ahead(state, rod, x) for x, _w in ends]
        if ahead in ([1, 1], [0, 1], [1, 0]):
            return ONE, spread.middle.offset[0]
        if None not in ahead and 1 not in ahead:
            return None
        if None in ahead:
            told = Message("whether {name} acts before or behind the section depends on lengths", name=name)
            raise CannotAnswer(told)
        if ahead[0] == 1:
            ends = ends[::-1]
        (low, w_1), (high, w_2) = ends
        whole, left = add(high, negate(low)), add(high, negate(self.offset))
        w_cut = add(w_2, multiply(add(w_1, negate(w_2)), divide(left, whole)))
        share = divide(multiply(left, add(w_cut, w_2)), multiply(whole, add(w_1, w_2)))
        arm = divide(multiply(left, add(w_cut, multiply(number(2), w_2))), multiply(number(3), add(w_cut, w_2)))
        return share, add(self.offset, arm)

    def _ahead(self, state: State[Any], rod: RigidBody, x: Expr) -> int | None:
        """1 for a place on the axis between the cut and the end, -1 before it; None where it depends on lengths."""
        if self.offset == x:
            return 0
        if self.order:
            here, there = (next(k for k, same in enumerate(self.order) if at in same) for at in (self.offset, x))
            return (there > here) - (there < here)
        if self.offset in (rod.points["start"][0], rod.points["end"][0]):
            return 1 if self.offset == rod.points["start"][0] else -1
        return sign_of_length(state, add(x, negate(self.offset)))

    def sentence(self, system: Described) -> Sentence:
        part = "thrust" if self.is_reversed and self.part == "axial" else self.part
        return Sentence(f"what.section.{part}", {"body": self.body, "at": self._at})


def places_on(system: Described, state: State[Any], rod: RigidBody, part: Part) -> list[Expr]:
    """The places along a rod at which something acts, and both ends."""
    places = [rod.points["start"][0], rod.points["end"][0]]
    for pull in pulls_on(system, state, rod):
        if pull.at is not None:
            places.append(pull.at.offset[0])
        elif pull.has_couple and (part == "bending" or not all(map(is_zero, pull.force))):
            raise couple_not_placed(rod, pull)
    for push in system.applied_loads:
        if push.spread is not None and push.spread.first.body == rod.name:
            places += [push.spread.first.offset[0], push.spread.second.offset[0]]
    return places


def in_order(rod: RigidBody, state: State[Any], places: Sequence[Expr]) -> Order:
    """Places along a rod in turn, those in one being the same; the state tells it in numbers."""
    along = {x: state.scalar(x) for x in dict.fromkeys(places)}
    if not all(isinstance(at, (int, float)) for at in along.values()):
        raise CannotAnswer(Message("in which order things act along {body} is told by numbers", body=rod.name))
    near = ROUNDED * state.scalar(rod.sizes[0])
    found = list[tuple[Expr, ...]]()
    for x in sorted(along, key=along.__getitem__):
        if found and along[x] - along[found[-1][0]] <= near:
            found[-1] = (*found[-1], x)
        else:
            found.append((x,))
    return tuple(found)


# -- how it is asked ------------------------------------------------------------------------------
_SIDES: dict[str, Side] = {"before": "before", "behind": "behind", "after": "behind"}
PARTS: dict[str, Part] = {"shear": "shear", "shearing": "shear", "bending": "bending"}


def _is_of_a_body(names: Names, found: Found) -> bool:
    """Not of a rope, a spring or a load, whose force or tension others read."""
    return str(found["of"]) in {*names.bodies, *names.broken} or " " in str(found["part"])


@asked(
    "axial force | shear force | bending moment | tension | compression of ROD at | just before | just behind POINT",
    r"(?P<part>(?:axial|shear|shearing) force|bending moment|tension|compression) (?:of|in) (?:the )?"
    rf"(?P<of>{NAME}) (?:at|just (?P<side>before|behind|after)) (?:the )?(?P<at>{PLACE})",
    rank=61,
    fits=_is_of_a_body,
)
def _at_a_point(names: Names, found: Found, path: Path) -> Quantity | None:
    asked_for, of = str(found["part"]), str(found["of"])
    part = PARTS.get(asked_for.partition(" ")[0], "axial")
    rod = rod_named(names, of, path)
    if rod is None or rod.is_placeholder:  # one that could not be read is told where it stands
        return None if rod is None else SectionForce(rod.name, part, ZERO, "", ())
    text, side = str(found["at"]), _SIDES.get(str(found["side"]), "")
    point = names.point(text if "." in text or text not in rod.points else f"{rod.name}.{text}", *path)
    if point.body != rod.name or any(c != ZERO for c in point.offset[1:]):
        names.problem(Message("{point} is no point on the axis of {body}", point=text, body=rod.name), *path)
        return None
    if names.space and part != "axial":
        names.problem(Message("shear forces and bending moments are told in models of the plane"), *path)
        return None
    return _section(names, rod, part, point.offset[0], str(point), is_reversed=asked_for == "compression", side=side)


@asked(
    "axial force | shear force | bending moment [of ROD] at LENGTH from START | END",
    rf"(?P<part>(?:axial|shear|shearing) force|bending moment)(?: (?:of|in) (?:the )?(?P<of>{NAME}))? "
    rf"(?:at|just (?P<side>before|behind|after)) (?P<along>[^|]+?) from (?:the )?(?:{NAME}\.)?(?P<end>start|end)",
    rank=62,
    example="""
parameters: {a: 0.5 m}
bodies: {beam: {rod: {mass: 3 kg, length: 2 m}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: bending moment of beam at 2*a from beam.start}
""",
    fits=lambda names, found: found["of"] in names.bodies or len(rods_of(names)) == 1,
)
def _at_a_distance(names: Names, found: Found, path: Path) -> Quantity | None:
    part = PARTS.get(str(found["part"]).partition(" ")[0], "axial")
    rod = rod_named(names, str(found["of"] or rods_of(names)[0]), path)
    if rod is None or rod.is_placeholder:
        return None if rod is None else SectionForce(rod.name, part, ZERO, "", ())
    along = names.formula(str(found["along"]), LENGTH, *path)
    if names.space and part != "axial":
        names.problem(Message("shear forces and bending moments are told in models of the plane"), *path)
        return None
    first, last = rod.points["start"][0], rod.points["end"][0]
    along = along if found["end"] == "start" else add(rod.sizes[0], negate(along))
    share = divide(along, rod.sizes[0])
    if (fixed := _fixed(share)) is not None and not 0.0 <= fixed <= 1.0:
        names.problem(Message("the section lies between {body}.start and {body}.end", body=rod.name), *path)
        return None
    offset = {ZERO: first, rod.sizes[0]: last}.get(along, add(along, first))
    one = _section(names, rod, part, offset, str(found["along"]), side=_SIDES.get(str(found["side"]), ""))
    return replace(one, along=along)


def rods_of(names: Names) -> list[str]:
    return [name for name, body in names.bodies.items() if body.solid is ROD]


def _is_of_one_rod(names: Names, found: Found) -> bool:
    return rod_with(names, str(found["at"])) is not None


def rod_with(names: Names, point: str) -> str | None:
    """The one rod that has a point: `C` or `beam.C`."""
    owner, _, name = point.rpartition(".")
    rods = [body for body in names.bodies.values() if body.solid is ROD and name in body.points]
    rods = [rod for rod in rods if owner in ("", rod.name)]
    return rods[0].name if len(rods) == 1 else None


@asked(
    "axial force | shear force | bending moment at | just before | just behind POINT of a rod",
    r"(?P<part>(?:axial|shear|shearing) force|bending moment) "
    rf"(?:at|just (?P<side>before|behind|after)) (?:the )?(?:point )?(?P<at>{PLACE})",
    rank=61,
    example="""
bodies: {beam: {rod: {mass: 3 kg, length: 2 m}, angle: 0, at: {start: [0, 0]}, points: {C: [0.5 m, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: bending moment at C}
""",
    fits=_is_of_one_rod,
)
def _at_a_point_alone(names: Names, found: Found, path: Path) -> Quantity | None:
    return _at_a_point(names, {**found, "of": rod_with(names, str(found["at"]))}, path)


@asked(
    "axial force of ROD; tension, compression, force in ROD",
    r"(?P<part>(?:axial|shear|shearing|bar|member) force|bending moment|tension|compression|force) (?:of|in) "
    rf"(?:the )?(?P<of>{NAME})",
    rank=61,
    example="""
bodies: {bar: {rod: {length: 2 m}}, load: {particle: {mass: 3 kg}}}
connections: {a: {pin: [ground.A, bar.start]}, b: {pin: [bar.end, load]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: axial force of bar}
""",
    fits=_is_of_a_body,
)
def _of_a_bar(names: Names, found: Found, path: Path) -> Quantity | None:
    part, of = str(found["part"]), str(found["of"])
    rod = rod_named(names, of, path)
    if rod is None or rod.is_placeholder:
        return None if rod is None else SectionForce(rod.name, "axial", ZERO, "", ())
    if part.startswith(("shear", "bending")):
        told = Message("{what} changes along {body}; say where: {what} of {body} at {body}.center", what=part, body=of)
        names.problem(told, *path)
        return None
    if rod.mass != ZERO:
        told = Message(
            "{body} has mass, so its axial force changes along it; say where: axial force of {body} at {body}.center",
            body=rod.name,
        )
        names.problem(told, *path)
        return None
    return _section(names, rod, "axial", ZERO, "", is_reversed=part == "compression")


def rod_named(names: Names, name: str, path: Path) -> RigidBody | None:
    """A rod by its name; what is none is told."""
    rod = names.body(name, *path)
    if not rod.is_placeholder and rod.solid is not ROD:
        told = Message("sections are cut through rods; {body} is none", body=rod.name)
        names.problem(told, *path)
        return None
    return rod


def _section(
    names: Names,
    rod: RigidBody,
    part: Part,
    offset: Expr,
    named: str,
    *,
    is_reversed: bool = False,
    side: Side = "",
) -> SectionForce:
    share = divide(offset, rod.sizes[0])
    return SectionForce(rod.name, part, offset, named, fields_of(names), is_reversed, _fixed(share) is None, side)


def fields_of(names: Names) -> tuple[Field, ...]:
    """The fields of gravity of a model, in an order of their own."""
    return tuple(sorted(names.fields, key=repr))


def _fixed(share: Expr) -> float | None:
    """A share of the length that does not depend on any parameter: the same number for two sets of them. Else None."""
    used = sorted(free_symbols(share))
    sets = ({name: first + step * k for k, name in enumerate(used)} for first, step in ((1.0, 0.37), (1.3, 0.71)))
    one, other = (float(evaluate(share, values, FLOAT_FUNCTIONS)) for values in sets)
    return one if abs(one - other) < ROUNDED else None
