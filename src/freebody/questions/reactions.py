"""Questions about what connections transmit: forces and moments on a body, tensions, normal forces, tooth forces."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.errors import CannotAnswer
from freebody.language.sentences import NOTHING, Argument, Message, Sentence, listed
from freebody.language.units import FORCE, TORQUE, Dimension
from freebody.measures.geometry import GROUND, RIGHT, UP, Direction, Point
from freebody.model.elements import ConstraintRow
from freebody.model.noting import did_you_mean
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, POINT, Found, asked
from freebody.questions.loads import load_force
from freebody.questions.vectors import (
    IN_BASIS,
    Basis,
    Vector,
    added,
    axes_of,
    component,
    cross,
    has_name,
    place,
    read_basis,
    said_along,
)
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class Wrench(Quantity, kind="reaction"):
    """Force or moment of a connection on a body: a vector, a component, the size, or the moment about a point; without
    a point that of a joint by which it holds a turn, else about the mass centre."""

    connection: str
    on: str | None
    along: Direction | None = None
    size: bool = False
    moment: bool = False
    about: Point | None = None
    basis: Basis | None = None

    example = """
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
questions: {it: reaction of rod on bob}
"""

    @property
    def dimension(self) -> Dimension:
        return TORQUE if self.moment else FORCE

    is_reaction = True
    # the keys of its words, of a force and of a moment
    said_as: ClassVar[tuple[str, str]] = ("force", "moment")

    @property
    def sign_is_conventional(self) -> bool:
        return not self.size

    @property
    def may_jump(self) -> bool:
        return True

    @property
    def is_moment(self) -> bool:
        return self.moment

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        is_vector = self.along is None and self.basis is None and (space or not self.moment)
        return replace(self, size=True) if is_vector else self

    def remark(self, system: Described) -> str:
        connection, body = self.connection, self.body(system)
        if self.moment and self.about is None and not self._couples(system):
            return Message(
                "the moment that {connection} exerts on {body}, about its mass centre", connection=connection, body=body
            )
        if self.moment:
            return Message("the moment that {connection} exerts on {body}", connection=connection, body=body)
        if connection == body:  # a support of a truss is called as its node
            return Message("the force that the support {connection} exerts", connection=connection)
        return Message("the force that {connection} exerts on {body}", connection=connection, body=body)

    def body(self, system: Described) -> str:
        """The body on which the force is asked: the one named, else the one that is not fixed, else the second that the
        connection names."""
        rows = [row for row in system.constraint_rows if row.connection == self.connection]
        bodies = list(dict.fromkeys(b for row in rows for b in row.measure.bodies()))
        if self.on is not None:
            if self.on not in bodies:
                raise _acts_elsewhere(self.connection, self.on, bodies)
            return self.on
        moving = [b for b in bodies if not system.bodies[b].fixed]
        if not moving:
            raise CannotAnswer(Message("{connection} joins fixed bodies only", connection=self.connection))
        return moving[0]

    def _couples(self, system: Described) -> list[ConstraintRow]:
        """The rows by which the connection holds a turn: the moment of a joint is theirs."""
        rows = (row for row in system.constraint_rows if row.connection == self.connection and self.counts(row))
        return [row for row in rows if row.reaction == "moment"]

    def counts(self, row: ConstraintRow) -> bool:
        """Whether what a row of the connection transmits is part of it."""
        return True

    def transmitted(self, state: State[Any], row: ConstraintRow) -> Any:
        """What a row pushes with in the direction in which its measure grows."""
        return state.multiplier(row)

    def value(self, system: Described, state: State[Any]) -> Any:
        """The sum of what is transmitted times the gradient over the rows of the connection."""
        body = self.body(system)
        rows = [row for row in system.constraint_rows if row.connection == self.connection and self.counts(row)]
        n = len(axes_of(system))
        if self.moment and self.about is None:
            rows = self._couples(system) or rows
        force: Vector = (0,) * n
        moment: Vector = (0,) * (3 if system.space else 1)
        self.must_have_whole(system.constraint_rows, body, n, state)
        for row in rows:
            push = state.gradient(row.measure, body)
            if not self.moment and self._is_across(push[:n], state):
                continue  # it adds nothing, also where it is not unique
            multiplier = self.transmitted(state, row)
            force = tuple(f + g * multiplier for f, g in zip(force, push[:n], strict=True))
            moment = tuple(m + g * multiplier for m, g in zip(moment, push[n:], strict=True))
        if not self.moment:
            return component(force, self.along, self.size, state, self.basis)
        if self.about is not None:
            center, about = place(system, state, system.bodies[body].mass_center), place(system, state, self.about)
            arm = tuple(c - p for c, p in zip(center, about, strict=True))
            moment = added(moment, cross(arm, force))
        if not system.space:
            return moment[0]
        return component(moment, self.along, self.size, state, self.basis)

    def must_have_whole(self, rows: Iterable[ConstraintRow], body: str, n: int, state: State[Any]) -> None:
        """Raises CannotAnswer where a row of the connection has a part in it that is determined only together with a
        row of another connection. n: the components of a force."""
        for row in rows:
            own = [name for name in row.together if name.partition(".")[0] == self.connection]
            if own and len(own) < len(row.together):
                push = state.gradient(row.measure, body)[:n]
                if self.moment or not self._is_across(push, state):
                    raise _not_alone(row)

    def _is_across(self, push: Vector, state: State[Any]) -> bool:
        """Whether a row pushes across the direction that is asked for."""
        if self.along is None or self.size:
            return False
        part: Any = component(push, self.along, False, state, self.basis)
        return bool(abs(part) < ROUNDED) if isinstance(part, float) else bool(part == 0)

    def sentence(self, system: Described) -> Sentence | None:
        if not has_name(self.along, self.basis):
            return None
        what, size = self.said_as[self.moment], "size_" if self.size else ""
        on = NOTHING if self.on is None else Sentence("what.on", {"body": self.on})
        about = NOTHING if self.about is None else Sentence("what.about", {"point": str(self.about)})
        along = said_along(self.along, self.basis)
        args: dict[str, Argument] = {"connection": self.connection, "on": on, "along": along, "about": about}
        return Sentence(f"what.{size}{what}", args)


def said_of_reaction(kind: str) -> str:
    """The group of words for a kind of reaction. A joint is a place: its force is the reaction at A."""
    return "joint" if kind in ("force", "moment") else "reaction"


def whole_only(rows: Iterable[ConstraintRow], wanted: Collection[str]) -> None:
    """Raises CannotAnswer where of rows of which only the sum is determined some are wanted, and not all."""
    for row in rows:
        if not set(row.together) <= set(wanted) and not set(row.together).isdisjoint(wanted):
            raise _not_alone(row)


def _not_alone(row: ConstraintRow) -> CannotAnswer:
    names = listed(list(dict.fromkeys(name.partition(".")[0] for name in row.together)))
    return CannotAnswer(Message("only the sum of the friction forces of {contact} is determined", contact=names))


def _acts_elsewhere(connection: str, body: str, bodies: Sequence[str]) -> CannotAnswer:
    """That a connection or load does not act on a body, but on others, where these are known."""
    if not bodies:
        return CannotAnswer(Message("{connection} does not act on {body}", connection=connection, body=body))
    return CannotAnswer(
        Message(
            "{connection} does not act on {body}, but on {bodies}",
            connection=connection,
            body=body,
            bodies=", ".join(bodies),
        )
    )


@dataclass(frozen=True)
class LoadOnBody(Wrench, kind="load on a body"):
    """Force of a load on a body: a vector, a component, or the size."""

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: force of weight on ball along up}
"""
    is_reaction = False

    def body(self, system: Described) -> str:
        """The body on which the force is asked: the one named, else the only one that moves."""
        pushes = [push for push in system.applied_loads if push.load == self.connection]
        bodies = list(dict.fromkeys(b for push in pushes for b in push.measure.bodies()))
        moving = [b for b in bodies if not system.bodies[b].fixed]
        if self.on in bodies:
            return self.on
        if self.on is None and len(moving) == 1:
            return moving[0]
        if self.on is None:
            told = Message("{load} acts on {bodies}: say on which", load=self.connection, bodies=", ".join(bodies))
            raise CannotAnswer(told)
        raise _acts_elsewhere(self.connection, str(self.on), bodies)

    def value(self, system: Described, state: State[Any]) -> Any:
        body, n = self.body(system), len(axes_of(system))
        force: Vector = (0,) * n
        for push in system.applied_loads:
            if push.load == self.connection:
                slopes, law = state.gradient(push.measure, body), state.law(push)
                force = tuple(f + g * law for f, g in zip(force, slopes[:n], strict=True))
        return component(force, self.along, self.size, state, self.basis)


@asked(
    "reaction of CONNECTION [on BODY] [along DIRECTION]; x, y component of, size of",
    rf"(?:(?P<part>horizontal|vertical|size of|magnitude of|x component of|y component of) )?(?:the )?"
    rf"(?:reaction|force) of (?P<of>{NAME})"
    rf"(?: on (?P<on>{NAME}))?(?: along (?P<along>.+?))?{IN_BASIS}",
)
def _reaction(names: Names, found: Found, path: Path) -> Quantity | None:
    of = str(found["of"])
    if of not in names.loads:
        return read_wrench(names, found, path)
    if not any(found[word] for word in ("part", "on", "along", "basis")):
        return load_force(names, of)
    if names.loads[of] != FORCE:
        told = Message("{load} is a torque: ask for torque of {load} alone", load=of)
        names.problem(told, *path)
        return None
    return _wrench(names, found, path, LoadOnBody)


def read_wrench(names: Names, found: Found, path: Path, kind: type[Wrench] = Wrench) -> Wrench | None:
    """The force of a connection, or a component of it: `of`, `part`, `on`, `along` and `basis` of what was found."""
    of = str(found["of"])
    is_known = has_connection(names, of, path) and acts_on(names, of, found["on"], path) and is_told(names, of, path)
    return _wrench(names, found, path, kind) if is_known else None


def _wrench(names: Names, found: Found, path: Path, kind: type[Wrench]) -> Wrench:
    of = str(found["of"])
    on = None if found["on"] is None else names.body(str(found["on"]), *path).name
    part = str(found["part"] or "")
    along = None if found["along"] is None else names.direction(found["along"], *path)
    if part == "horizontal" and names.space:
        told = Message(
            "in space a horizontal force has two components: ask for each, as in reaction of {connection} along x",
            connection=of,
        )
        names.problem(told, *path)
    if part in ("horizontal", "x component of"):
        along = RIGHT
    if part == "y component of":
        along = UP
    if part == "vertical":
        along = names.compass["up"]
    is_size = part in ("size of", "magnitude of")
    return kind(of, on, along, size=is_size, basis=read_basis(names, found["basis"], path))


@asked(
    "moment of CONNECTION [on BODY] [about POINT] [along DIRECTION] [in BASIS]",
    rf"(?P<size>size of |magnitude of )?(?:the )?moment of (?P<of>{NAME})(?: on (?P<on>{NAME}))?"
    rf"(?: about (?P<about>{POINT}))?(?: along (?P<along>.+?))?{IN_BASIS}",
    example="""
bodies: {beam: {rod: {mass: 3 kg, length: 2 m}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: moment of clamp}
""",
)
def _moment(names: Names, found: Found, path: Path) -> Quantity | None:
    return read_moment(names, found, path)


def read_moment(names: Names, found: Found, path: Path, kind: type[Wrench] = Wrench) -> Wrench | None:
    """The moment of a connection, or a component of it: `of`, `size`, `on`, `about`, `along` and `basis` of what was
    found."""
    of = str(found["of"])
    if not (has_connection(names, of, path) and acts_on(names, of, found["on"], path)):
        return None
    on = None if found["on"] is None else names.body(str(found["on"]), *path).name
    about = None if found["about"] is None else names.point(found["about"], *path)
    along = None if found["along"] is None else names.direction(found["along"], *path)
    if not names.space and (along or found["size"]):
        names.problem(Message("in the plane a moment has no direction; leave it out"), *path)
    basis = read_basis(names, found["basis"], path)
    return kind(of, on, along, found["size"] is not None, moment=True, about=about, basis=basis)


def acts_on(names: Names, name: str, on: str | None, path: Path) -> bool:
    """Whether a connection acts on a body, where one is named: what it joins, or what is led over it."""
    if on is None or on == GROUND or on not in names.bodies or on in names.broken:
        return True  # what there is not is told elsewhere
    rows = [row for row in names.constraint_rows if row.connection == name]
    named = {*names.connections[name].mentions(names)}
    named |= {body for row in rows for body in (*row.measure.bodies(), *row.ends)}
    touched = (named & names.bodies.keys()) - {GROUND}
    if on in touched or not touched:
        return True
    joined = ", ".join(body for body in names.bodies if body in touched)
    told = Message("{connection} does not act on {body}; it acts on {bodies}", connection=name, body=on, bodies=joined)
    names.problem(told, *path)
    return False


def is_told(names: Names, name: str, path: Path) -> bool:
    """Whether the force of a connection is known: no other one loads this bearing with what no row of it has."""
    own = names.connections[name]
    for other in names.connections.values():
        with names.quietly():
            loaded = other.loads_bearings(names) if other is not own else {}
            kept = [
                b for b in sorted(loaded) if own.keeps_at(names, names.known(b).center, RIGHT, frozenset()) is not None
            ]
        if kept:
            told = Message("the force in {connection} is not known: {why}", connection=name, why=loaded[kept[0]])
            names.problem(told, *path)
            return False
    return True


def has_connection(names: Names, name: str, path: Path) -> bool:
    """Whether a connection of that name could be read."""
    if name in names.connections and name not in names.broken:
        return True
    if name in names.loads:
        names.problem(Message("{name} is a load; ask for: force in {name}", name=name), *path)
        return False
    told = Message("there is no connection {name}.{hint}", name=name, hint=did_you_mean(name, names.connections))
    names.unknown(name, told, *path)
    return False
