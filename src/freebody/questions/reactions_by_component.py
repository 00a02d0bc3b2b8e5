"""Components of reactions by the names that connections give them: tension, normal force, friction, torque."""

from __future__ import annotations

import difflib
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.errors import CannotAnswer
from freebody.language.sentences import NOTHING, Argument, Message, Sentence, listed
from freebody.language.units import FORCE, LENGTH, TORQUE, Dimension
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import ZERO
from freebody.model.elements import ConstraintRow, NonholonomicForm, StringStretch
from freebody.model.noting import did_you_mean
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import FORMS, NAME, PLACE, Found, asked
from freebody.questions.reactions import has_connection, is_told, said_of_reaction, whole_only

if TYPE_CHECKING:
    from freebody.model.names import Names


TOOTH_FORCE = "tooth force"
_WITH_SENSE = ("tension", "normal force")  # pull and push, whatever is counted as positive


def component_of(quantity: Quantity) -> ReactionComponent | None:
    """The quantity, if it is what one row of a connection transmits; else None."""
    return quantity if isinstance(quantity, ReactionComponent) else None


@dataclass(frozen=True)
class ReactionComponent(Quantity, kind="reaction component"):
    """What one row of a connection transmits: tension, normal force, tooth force ..."""

    connection: str
    reaction: str
    row: str
    at: tuple[str, ...] = ()
    less: tuple[str, ...] = ()  # rows whose reactions are subtracted: the tension before a drum with friction
    further: tuple[str, ...] = ()  # rows whose reactions are added: the other places at which two outlines touch
    transmits: Dimension = FORCE
    free_wheels: tuple[str, ...] = ()  # over which a string runs with the same tension on both sides
    pushes_either_way: bool = False  # a guide: which side is positive says nothing
    is_size: bool = False

    example = """
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
questions: {it: tension of rod}
"""

    @property
    def dimension(self) -> Dimension:
        return self.transmits

    @property
    def remarks(self) -> tuple[Message, ...]:
        if self.is_size:
            return (Message("of its size: {connection} pushes to either side", connection=self.connection),)
        if not self.free_wheels:
            return ()
        return (
            Message(
                "the tension is the same throughout: {wheels} turns freely and has no inertia, so both parts have the "
                "same moment about its axle",
                wheels=listed(self.free_wheels),
            ),
        )

    @property
    def letter(self) -> str:
        return {"tension": "S", "normal force": "N"}.get(self.reaction, super().letter)

    is_reaction = True
    # the keys of its words, of a force and of a moment
    said_as: ClassVar[tuple[str, str]] = ("force", "moment")

    @property
    def is_tangential(self) -> bool:
        return self.reaction in (TOOTH_FORCE, "chain force")

    @property
    def sign_is_conventional(self) -> bool:
        return self.reaction not in _WITH_SENSE

    @property
    def may_jump(self) -> bool:
        return True

    @property
    def with_sign(self) -> Quantity:
        return replace(self, is_size=False)

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        return replace(self, is_size=True) if most and self.pushes_either_way else self

    def added_to(self, other: Quantity) -> Quantity | None:
        its = component_of(other)
        if its is None or self.less or its.less or self.reaction != its.reaction or self.transmits != its.transmits:
            return None
        rows = (self.row, *self.further, its.row, *its.further)
        return replace(self, at=(), further=rows[1:], free_wheels=()) if len({*rows}) == len(rows) else None

    def value(self, system: Described, state: State[Any]) -> Any:
        """What the row transmits, less the dry friction on the way to the place that is asked for. Raises CannotAnswer
        where it is open; of several places those that are open transmit nothing."""
        rows = {row.name: row for row in system.rows}
        whole_only(system.constraint_rows, (self.row, *self.further))
        touching = [rows[name] for name in (self.row, *self.further) if name in rows]
        if not touching:
            raise CannotAnswer(Message("{connection} is open there", connection=self.connection))
        first, *others = touching
        total = first.sign * state.multiplier(first)
        for name in self.less:
            total = total - rows[name].sign * state.multiplier(rows[name])
        for row in others:
            total = total + row.sign * state.multiplier(row)
        return state.absolute(total) if self.is_size else total

    def sentence(self, system: Described) -> Sentence:
        at = Sentence("what.at", {"places": self.at}) if self.at else NOTHING
        of = said_of_reaction(self.reaction)
        args: dict[str, Argument] = {"reaction": f"@{of}.{self.reaction}", "connection": self.connection, "at": at}
        return Sentence(f"what.{of}", args)


@asked(
    "tension | normal force | friction force | tooth force | ... of CONNECTION [at BODY | between BODY and BODY]",
    rf"(?P<what>[a-z][a-z ]*?(?: [12])?) (?:of|in) (?P<of>{NAME})"
    rf"(?: (?:at|on) (?P<at>{PLACE})| between (?P<a>{PLACE}) and (?P<b>{PLACE}))?",
    rank=0,  # any word of any name: after all others
)
def read_component(names: Names, found: Found, path: Path) -> Quantity | None:
    """What one row of a connection transmits, or a stretch of it: `what`, `of`, and the places `at` or `a` and `b`."""
    of, what = str(found["of"]), str(found["what"])
    if of in names.broken or _is_misnamed(names, what, of, path) or not has_connection(names, of, path):
        return None
    joined = [names.bodies[body] for body in names.connections[of].mentions(names) if body in names.bodies]
    if any(body.is_placeholder for body in joined):  # nobody is told twice
        names.broken.add(of)
        return None
    if not is_told(names, of, path):
        return None

    # the rows of the connection that have this name
    rows = [row for row in names.constraint_rows if row.connection == of]
    kinds = sorted({row.reaction for row in rows})
    if what not in kinds:
        hint = did_you_mean(what, kinds)
        told = Message("{of} has no {what}.{hint} Or ask for: reaction of {of}", of=of, what=what, hint=hint)
        names.problem(told, *path)
        return None

    # of several the one at the places that are named, or all where they are one force
    at = tuple(place_named(names, str(found[k]), path) for k in ("at", "a", "b") if found[k] is not None)
    places = [place for row in rows if row.reaction == what for place in _places(row)]
    matching = [place for place in places if set(at) <= set(place[1].places)]
    if len(matching) > 1 and len(at) == 2:  # there and back between the same two: the order is that of its way
        matching = [place for place in matching if _comes_before(*at, place[1].places)] or matching
    is_whole = not at and names.connections[of].is_one_force
    free_wheels = () if at or is_whole or len(matching) < 2 else _free_wheels(names, of, [s for _row, s in matching])
    matching = matching[:1] if free_wheels else matching
    if len(matching) != 1 and not (matching and is_whole):
        ends = "; ".join(" - ".join(_listed(stretch.places)) for _row, stretch in places)
        names.problem(
            Message(
                "{of} has several values of {what}{at}; say which: at BODY, or between BODY and BODY ({ends})"
                if matching
                else "{of} has no value of {what}{at}; say which: at BODY, or between BODY and BODY ({ends})",
                of=of,
                what=what,
                at=Message(" at {places}", places=listed(at)) if at else "",
                ends=ends,
            ),
            *path,
        )
        return None
    row, stretch = matching[0]
    dimension = FORCE if row.measure.dimension == LENGTH else TORQUE / row.measure.dimension
    less = tuple(f"{of}.{component}" for component in stretch.less)
    further = tuple(other.name for other, _stretch in matching[1:])
    guides = what == "normal force" and not row.unilateral
    return ReactionComponent(of, what, row.name, at, less, further, dimension, free_wheels, guides)


def _comes_before(one: str, other: str, places: Sequence[str]) -> bool:
    return places.index(one) < places.index(other)


def _free_wheels(names: Names, of: str, stretches: Sequence[StringStretch]) -> tuple[str, ...]:
    """The bodies between the stretches of a string, if none of them can take a moment; else nothing."""
    bodies = [{place for place in s.places if place in names.bodies} for s in stretches]
    between = tuple(dict.fromkeys(b for one, other in pairwise(bodies) for b in sorted(one & other)))
    if len(between) != len(stretches) - 1 or any(s.less for s in stretches):
        return ()
    return between if all(_turns_freely(names, body, of) for body in between) else ()


def _turns_freely(names: Names, body: str, of: str) -> bool:
    """Whether nothing but the string has a moment about the centre of a body that has no inertia: there R T1 = R T2."""
    own = names.bodies[body]
    if names.space or own.fixed or not own.turns or own.inertia != ZERO:
        return False
    held = [row for row in names.constraint_rows if body in set(row.measure.bodies())]
    joined = {name for name, spec in names.connections.items() if re.search(rf"\b{re.escape(body)}\b", repr(spec))}
    if joined - {row.connection for row in held}:
        return False  # by what touches or rubs
    acting = [row.measure for row in held if row.connection != of]
    acting += [load.measure for load in names.applied_loads if body in set(load.measure.bodies())]
    return all(_is_of_centre(measure, body) for measure in acting)


def _is_of_centre(measure: Measure | NonholonomicForm, body: str) -> bool:
    """Whether a force along a measure acts at the mass centre, in whatever direction."""
    if not isinstance(measure, Displacement) or measure.along.body == body:
        return False
    ends = [point for point in (measure.of, measure.origin) if point.body == body]
    return all(c == ZERO for point in ends for c in point.offset)


def _is_misnamed(names: Names, what: str, of: str, path: Path) -> bool:
    """Whether something else was meant than a component of a reaction: another question, or something of a body."""
    if of in names.connections:
        return False
    close = difflib.get_close_matches(what, [word for form in FORMS for word in form.openings], n=1, cutoff=0.7)
    if close and close[0] != what:
        told = Message(
            "there is nothing called {what}. Did you mean: {close} of {of}", what=what, close=close[0], of=of
        )
    elif of in names.bodies:
        known = listed([*dict.fromkeys(word for form in FORMS if form.is_of_body for word in form.openings)])
        told = Message(
            "'{what}' is nothing that is found of a body; one can ask for its {known}", what=what, known=known
        )
    else:
        return False
    names.problem(told, *path)
    return True


def _listed(places: tuple[str, ...]) -> list[str]:
    """The places of a stretch, a body that is there by a point of its own as that point."""
    return [p for p in places if not any(other.startswith(f"{p}.") for other in places)]


def place_named(names: Names, text: str, path: Path) -> str:
    """A body, or a point as `rod.end`, by the name that rows have for it."""
    return str(names.point(text, *path)) if "." in text else names.body(text, *path).name


def _places(row: ConstraintRow) -> list[tuple[ConstraintRow, StringStretch]]:
    """The row with each of its stretches; one that is no string is one of its own."""
    bodies = row.ends or tuple(dict.fromkeys(row.measure.bodies()))
    return [(row, stretch) for stretch in row.stretches or (StringStretch(bodies),)]
