"""Questions about what comes together from the start to an event, and events of contacts and dry friction.

time when ...        energy lost until ...        turns of BODY until ...        change of MEASURE until ...
... when rolling begins | slipping ends | slipping begins | NAME slips | NAME leaves the surface | rope goes slack |
NAME hits the stop
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, ClassVar, Literal, cast

from freebody.language.expression import Symbol
from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS, ENERGY, LENGTH, TIME, Dimension
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, RIGHT, UP, Point
from freebody.model.elements import RigidBody
from freebody.model.noting import did_you_mean
from freebody.model.phrases import read_measure
from freebody.model.solids import ROPE
from freebody.questions.base import Described, Passage, Path, Quantity, angular_unit
from freebody.questions.energy import goes_by_rates
from freebody.questions.event import leads_to
from freebody.questions.forms import POINT, Found, asked
from freebody.questions.sudden import IMPACT, NTH, ORDINALS, side_of_blow, which_blow

if TYPE_CHECKING:
    from freebody.model.names import Names

TransitionKind = Literal["rolls", "slip ends", "slips", "opens", "touches", "bounces end", "before", "after"]
RANK = 90
_RANK_OF_ONE = 55  # below that of what is lost in a blow


@dataclass(frozen=True)
class Transition:
    """A change of the state of a contact: it begins to roll (or to stick), stops slipping, begins to slip, opens, is
    touched, has bounced for the last time; or the instant just before or just after a blow or an impact. `of` are the
    connections (of a blow also the impulses) that are meant; none means any. count: which of such changes, counted from
    the start. rests: that nothing moves any more is said as well; stays: nor later on."""

    kind: TransitionKind
    of: tuple[str, ...]
    text: str
    count: int = 1
    rests: bool = False
    stays: bool = False


class Counted(Quantity):
    """What a motion has gathered since its start; it is asked for up to an event."""

    scope = "course"
    until: ClassVar[str] = "rolling begins"  # an event, for messages
    ends_at_last: ClassVar[bool] = False  # whether to come to rest is to stay there: each half swing ends at rest


@dataclass(frozen=True)
class When(Counted, kind="time"):
    """The time of the event."""

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {y: y of ball}
questions: {it: time when y = -5 m}
"""
    measured_in = TIME
    is_of_event = True

    @property
    def letter(self) -> str:
        return "t_f"

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.time()

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.time")


@dataclass(frozen=True)
class EnergyLost(Counted, kind="energy lost"):
    """What dry friction, drag and dampers have turned into heat since the start; of: in one connection, or what one
    load has taken."""

    of: str = ""
    is_load: bool = False

    example = """
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}}
connections: {touch: {contact: {between: [ball, floor], friction: 0.3}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {x: {travel of ball along floor}}
start: {x: 0, rate(x): 2 m/s}
questions: {it: energy lost until rolling begins}
"""
    measured_in = ENERGY

    @property
    def letter(self) -> str:
        return "Q"

    @property
    def unit(self) -> str:
        return "J"

    @property
    def is_of_whole(self) -> bool:
        return True

    def counted(self, passage: Passage[Any]) -> Any:
        return -passage.work(self.of) if self.is_load else passage.heat(self.of)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.lost_in", {"of": self.of}) if self.of else Sentence("what.lost")

    def remark_on_zero(self, system: Described) -> str:
        """That a motor, whose torque falls with its speed, is no loss."""
        drives = [] if self.of else [load for load in system.loads if goes_by_rates(system, load)]
        if not drives:
            return ""
        return Message(
            "{load} gives energy and takes it: what it takes is asked for by energy lost in {load}", load=drives[0]
        )


@dataclass(frozen=True)
class Revolutions(Counted, kind="turns"):
    """How often a body has turned since the start, counted without sign."""

    body: str

    example = """
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}}
connections: {touch: {contact: {between: [ball, floor], friction: 0.3}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {x: {travel of ball along floor}}
start: {x: 0, rate(x): 2 m/s}
questions: {it: turns of ball until rolling begins}
"""

    @property
    def letter(self) -> str:
        return "n"

    @property
    def unit(self) -> str:
        return "1"

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.revolutions(self.body)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.turns", {"body": self.body})


@dataclass(frozen=True)
class Change(Counted, kind="change"):
    """How much a measure has changed since the start."""

    measure: Measure
    name: str

    example = """
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}}
connections: {touch: {contact: {between: [ball, floor], friction: 0.3}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {x: {travel of ball along floor}}
start: {x: 0, rate(x): 2 m/s}
questions: {it: change of x until rolling begins}
"""

    @property
    def dimension(self) -> Dimension:
        return self.measure.dimension

    @property
    def unit(self) -> str:
        is_angle = self.dimension == DIMENSIONLESS
        return angular_unit(self.dimension) if is_angle else str(self.dimension)

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.change(self.measure)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.change", {"of": Symbol(self.name) if self.name in system.measures else self.name})


@dataclass(frozen=True)
class Travelled(Change, kind="distance travelled"):
    """How far a measure has gone since the start, to and fro, counted without sign."""

    adds_up_ways = True

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {y: y of ball}
questions: {it: distance travelled along y until y = -5 m}
"""

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.travelled(self.measure)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.travelled", {"of": Symbol(self.name) if self.name in system.measures else self.name})


@dataclass(frozen=True)
class PathLength(Counted, kind="path length"):
    """How long the path of a point is that it has gone since the start, to and fro."""

    point: Point
    name: str

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {y: y of ball}
questions: {it: length of the path of ball until y = -5 m}
"""
    measured_in = LENGTH

    @property
    def letter(self) -> str:
        return "s"

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.length(self.point)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.path_length", {"of": self.name})


# -- events -----------------------------------------------------------------------------------
_NAME = r"(?P<of>[A-Za-z_]\w*)"
_SUBJECT = rf"(?:it|the motion|(?:the )?{_NAME})"
_ON = r"(?: (?:on |against )?(?:the )?(?P<on>[A-Za-z_]\w*))?"
_BEGINS = r"(?:begins?|starts?|sets? in|is established)"
_ENDS = r"(?:ends?|stops?|ceases?)"
_SLIDING = r"(?:slip|slipping|sliding|to slip|to slide)"
_WORDS: tuple[tuple[str, TransitionKind], ...] = (
    (rf"(?:pure )?rolling(?: without (?:slip|slipping|sliding))? (?:of {_NAME} )?{_BEGINS}", "rolls"),
    (
        rf"{_SUBJECT} (?:rolls|(?:begins|starts) (?:to roll|rolling))(?: without (?:slip|slipping|sliding))?",
        "rolls",
    ),
    (rf"(?:slip|slipping|sliding)(?: of {_NAME})? {_ENDS}", "slip ends"),
    (rf"slip of {_NAME} ?= ?0", "slip ends"),
    (rf"{_SUBJECT} (?:stops (?:slipping|sliding)|sticks)", "slip ends"),
    (rf"(?:the )?(?:bouncing|rebounds?)(?: of {_NAME})? {_ENDS}", "bounces end"),
    (rf"{_SUBJECT} (?:stops?|ceases?|has (?:stopped|ceased)) (?:bouncing|to bounce|rebounding)", "bounces end"),
    (rf"{_SUBJECT} (?P<last>(?:finally|eventually) )?(?P<rests>stops|comes to rest)(?P<stays> for good)?", "slip ends"),
    (rf"(?:slip|slipping|sliding)(?: of {_NAME})? (?:begins|starts)", "slips"),
    (rf"{_SUBJECT} (?:slips?|slides?|(?:begins?|starts?) {_SLIDING})", "slips"),
    (rf"{_SUBJECT} (?:opens?|parts?|lifts? off|takes? off|loses? contact)", "opens"),
    (rf"{_SUBJECT} leaves?(?: (?:the )?(?:surface|(?P<on>[A-Za-z_]\w*)))?", "opens"),
    (rf"{_SUBJECT} (?:goes?|becomes?|is) slack", "opens"),
    (rf"{_SUBJECT} is (?:relaxed|free|released)(?: again)?", "opens"),
    (rf"contact(?: of {_NAME})? is lost", "opens"),
    (rf"{_SUBJECT} (?:touch(?:es)?|hits?|strikes?|lands?){_ON}", "touches"),
    (rf"{_SUBJECT} (?:closes?|(?:goes?|becomes?|is) taut|is (?:reached|touched|met))", "touches"),
)
_NTH_IMPACT = re.compile(
    rf"^(?:(?:the |there is an? )?(?P<nth>{NTH})|the|there is an) {IMPACT}(?: (?:of|with|by|at) (?:the )?{_NAME})?"
    r"(?: (?:comes|happens|occurs|takes place))?$"
)
_NTH_TIME = re.compile(rf"^(?P<what>.+?) (?:for )?(?:a|the) (?P<nth>{NTH}) time$")
_TRANSITIONS: list[tuple[re.Pattern[str], TransitionKind]] = [
    (re.compile(rf"^{pattern}$"), kind) for pattern, kind in _WORDS
]


def read_transition(names: Names, text: str, path: Path) -> Transition | None:
    """The change of a contact's state that a text states, or the side of a blow; None if it is none of these."""
    sided = side_of_blow(text)
    if sided is not None:
        side, name = sided
        of = () if name is None else (name,) if name in names.impulses else connections_of(names, name, path)
        return Transition("before" if side == "before" else "after", of, text, which_blow(text))
    if (nth := _NTH_IMPACT.match(text.strip())) is not None:
        of = () if nth["of"] is None else connections_of(names, nth["of"], path)
        return Transition("touches", of, text, ORDINALS.get(nth["nth"] or "", 1))
    if (again := _NTH_TIME.match(text.strip())) is not None:
        once = read_transition(names, again["what"], path)
        counts = once is not None and (once.kind == "touches" or (once.rests and not once.stays))
        return replace(once, text=text, count=ORDINALS[again["nth"]]) if once is not None and counts else None
    one_sided = {p.load for p in names.applied_loads if p.one_sided is not None}
    for pattern, kind in _TRANSITIONS:
        found = pattern.match(text.strip())
        if found is None:
            continue
        name = found.groupdict().get("of")
        if found.groupdict().get("on") == "again":
            told = Message(
                "'{text}' may mean the first or the second time, by where it starts: ask for the first impact or the "
                "second impact",
                text=text,
            )
            names.problem(told, *path)
            return Transition(kind, (), text)
        rests, *lasts = (found.groupdict().get(word) is not None for word in ("rests", "stays", "last"))
        stays = any(lasts)
        if rests and not can_change(names):
            return None  # nothing sticks where it stops: an event of a measure, whose rate is zero
        flies = not names.constraint_rows and (name is None or name in names.bodies)
        flies |= found.groupdict().get("on") in names.bodies[GROUND].lines and not can_change(names)
        if kind == "touches" and flies and found.groupdict().get("on") not in {*names.bodies} - {GROUND}:
            return None  # what flies, or touches nothing, lands where it is told to, at no contact
        if name is None:
            if rests:
                _refuse_rolling(names, (), path)
            return Transition(kind, (), text, rests=rests, stays=stays)
        if (
            name in names.measures
            or name in names.loads.keys() - one_sided
            or (kind == "opens" and _runs_off(names, name))
        ):
            return None
        of, on = connections_of(names, name, path), found.groupdict().get("on")
        if on is not None:
            both = tuple(connection for connection in of if connection in _touching(names, on, path))
            leading = leads_to(names, name, on) if kind == "touches" else []
            if leading and set(both) <= {*leading}:
                return None  # nothing can be struck there: an event of the measure between them
            if (of and not both) or on == name:
                told = Message("{name} and {other} have no contact with each other", name=name, other=on)
                names.problem(told, *path)
            of = both
        if rests and on is None and name in names.bodies and not (of := sticking(names, name, of)):
            return None  # nothing sticks it to the ground where it stops
        if rests:
            _refuse_rolling(names, of, path)
        return Transition(kind, of, text, rests=rests, stays=stays)
    return None


def can_change(names: Names) -> bool:
    """Whether a contact, a string or dry friction can change its state."""
    return any(row.unilateral or row.reaction.startswith("friction") for row in names.constraint_rows)


def sticking(names: Names, body: str, of: Iterable[str]) -> tuple[str, ...]:
    """The connections that stick a body to the ground where it stops, and to nothing else that may move on."""
    rows = [row for row in names.constraint_rows if row.unilateral or row.reaction.startswith("friction")]
    still = {body, GROUND} | _shoes_of(names, body)
    grounded = {row.connection for row in rows if {*row.measure.bodies()} <= still}
    return tuple(connection for connection in of if connection in grounded)


def _shoes_of(names: Names, body: str) -> set[str]:
    """What is pressed on a wheel whose axle stays where it is, and is itself hinged to the ground: a lever with a shoe.
    While they touch it cannot move, however the wheel turns."""
    wheel = names.bodies[body]
    if wheel.radius is None or not wheel.turns or not _is_on_a_fixed_axle(names, wheel):
        return set()
    pressed = {
        other
        for row in names.constraint_rows
        if row.reaction == "normal force" and row.unilateral and body in row.measure.bodies()
        for other in row.measure.bodies()
    }
    others = (names.bodies[other] for other in pressed - {body})
    return {other.name for other in others if any(_is_kept(names, point) for point in map(other.point, other.points))}


def _runs_off(names: Names, name: str) -> bool:
    """Whether something is a rope with mass: it leaves an edge where all of it hangs, an event of its measure."""
    return name in names.bodies and names.bodies[name].solid is ROPE


def _refuse_rolling(names: Names, of: tuple[str, ...], path: Path) -> None:
    """A round body that no longer slips has not come to rest: it rolls on. One alone on an axle that stays where it is
    cannot: what rubs on it does not turn."""
    touching = [row for row in names.constraint_rows if not of or row.connection in of]
    rough = {row.connection for row in touching if row.reaction == "friction force"}
    pressed = [row for row in touching if row.reaction == "normal force" and row.connection in rough]
    ends = {end.partition(".")[0] for row in pressed for end in (*row.ends, *row.measure.bodies())}
    touching_bodies = (names.bodies[end] for end in sorted(ends & names.bodies.keys()))
    round_ones = [b for b in touching_bodies if b.turns and not b.fixed and (b.radius is not None or b.round)]
    for body in round_ones:
        if len(round_ones) > 1 or not _is_on_a_fixed_axle(names, body):
            told = Message(
                "{body} may roll on when it no longer slips; say 'slipping ends', or which rate is zero: rate(x) = 0",
                body=body.name,
            )
            names.problem(told, *path)
            return


def _is_on_a_fixed_axle(names: Names, body: RigidBody) -> bool:
    return _is_kept(names, body.center)


def _is_kept(names: Names, point: Point) -> bool:
    """Whether a point is kept in its place on the ground."""
    return all(
        any(c.keeps_at(names, point, along, frozenset()) is not None for c in names.connections.values())
        for along in (RIGHT, UP)
    )


def connections_of(names: Names, name: str, path: Path) -> tuple[str, ...]:
    """The connection of a name, or those that touch the body of that name."""
    one_sided = {p.load for p in names.applied_loads if p.one_sided is not None}
    if name in names.connections or name in one_sided:
        return (name,)
    if name in names.bodies:
        return tuple(
            dict.fromkeys(row.connection for row in names.constraint_rows if name in (*row.ends, *row.measure.bodies()))
        )
    known = [*names.connections, *sorted(one_sided), *names.bodies]
    told = Message("there is no connection or body {name}.{hint}", name=name, hint=did_you_mean(name, known))
    names.unknown(name, told, *path)
    return ()


def _touching(names: Names, name: str, path: Path) -> tuple[str, ...]:
    """The connections of a name, or those that touch the body, or the line or plane of the ground, of that name."""
    ground = names.bodies[GROUND]
    if name not in names.connections and (name in ground.lines or name in ground.planes):
        return tuple(connection for connection in names.connections if names_line(names, connection, name))
    return connections_of(names, name, path)


def names_line(names: Names, connection: str, line: str) -> bool:
    """Whether a connection is told to be with a line, or a plane, of the ground."""
    fields: dict[str, Any] = vars(names.connections[connection])
    lists = (cast("list[Any]", [*value] if isinstance(value, (list, tuple)) else [value]) for value in fields.values())
    return any(isinstance(value, str) and value.removeprefix(f"{GROUND}.") == line for one in lists for value in one)


_DOES = re.compile(
    r"(?P<who>[\w.]+) "
    r"(?P<does>begin|start|stop|slip|slide|roll|leave|hit|reach|open|close|come|go|turn|lift|touch|tip)\b"
)


def as_condition(names: Names, text: str) -> str:
    """'when does the block slip' and 'where does it leave the surface' in the words of the grammar."""
    found = re.match(r"^(?:[Ww]hen|at what time) (?:does|do|will) (?P<event>.+?)\??$", text)
    if found is not None and not re.match(r"the (?:loop|linkage|mechanism) (?:assemble|close)", found["event"]):
        return f"time when {_told(found['event'])}"
    found = re.match(r"^[Ww]here (?:does|do|will) (?P<event>.+?)\??$", text)
    if found is not None and (place := _place(names)) is not None:
        return f"{place} when {found['event']}"
    return text


def _told(event: str) -> str:
    """What something does, as it is told of it: the block slip is block slips."""
    event = event.removeprefix("the ")
    found = _DOES.match(event)
    if found is None:
        return event
    ending = "es" if found["does"].endswith(("ch", "o")) else "s"
    return f"{found[0]}{ending}{event[found.end() :]}"


def _place(names: Names) -> str | None:
    """The only measure that says where something is, if it is the only one."""
    lengths = [name for name, measure in names.measures.items() if measure.dimension != DIMENSIONLESS]
    places = lengths or list(names.measures)
    return places[0] if len(places) == 1 else None


# -- quantities -------------------------------------------------------------------------------
@asked(
    "energy lost until EVENT",
    r"(?:energy (?:lost|dissipated)|loss of (?:mechanical )?energy|heat)(?: by friction)?",
    rank=RANK,
)
def _lost(names: Names, found: Found, path: Path) -> Quantity | None:
    return EnergyLost()


@asked(
    "energy lost in CONNECTION | LOAD until EVENT",
    r"(?:energy (?:lost|dissipated)|loss of (?:mechanical )?energy|heat)"
    rf" (?:in|by|at|through|to) (?:the )?{_NAME}",
    rank=_RANK_OF_ONE,
    example="""
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}}
connections: {touch: {contact: {between: [ball, floor], friction: 0.3}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {x: {travel of ball along floor}}
start: {x: 0, rate(x): 2 m/s}
questions: {it: energy lost in touch until rolling begins}
""",
)
def _lost_in(names: Names, found: Found, path: Path) -> Quantity | None:
    of = str(found["of"])
    if of in names.loads:
        return EnergyLost(of, is_load=True)
    if of in names.connections:
        return EnergyLost(of)
    known = [*names.connections, *names.loads]
    told = Message("there is no connection or load {name}.{hint}", name=of, hint=did_you_mean(of, known))
    names.unknown(of, told, *path)
    return None


@asked("turns of BODY until EVENT", rf"(?:number of )?(?:turns|revolutions|rotations) of (?:the )?{_NAME}", rank=RANK)
def _turns(names: Names, found: Found, path: Path) -> Quantity | None:
    body = names.body(str(found["of"]), *path)
    if not body.turns:
        names.problem(Message("{body} is a particle and does not turn", body=body.name), *path)
    return Revolutions(body.name)


@asked("change of MEASURE until EVENT", r"change of (?P<of>.+)", rank=RANK)
def _change(names: Names, found: Found, path: Path) -> Quantity | None:
    text = str(found["of"])
    measure = read_measure(names, text, *path)
    return None if measure is None else Change(measure, text)


def _point_meant(names: Names, text: str, path: Path) -> Point | None:
    """The point that a name is, where no measure is called so."""
    body = text.partition(".")[0]
    is_one = re.fullmatch(POINT, text) is not None and text not in names.measures and body in names.bodies
    return names.point(text, *path) if is_one else None


@asked(
    "distance travelled along MEASURE | length of the path of POINT until EVENT",
    r"(?:distance|way|path) (?:travell?ed|covered) (?:along|by|in) (?P<of>.+)|length of (?:the )?path of (?P<path>.+)",
    rank=RANK,
)
def _travelled(names: Names, found: Found, path: Path) -> Quantity | None:
    text = str(found["of"] or found["path"])
    if found["path"] and (point := _point_meant(names, text, path)) is not None:
        return PathLength(point, text)
    measure = read_measure(names, text, *path)
    return None if measure is None else Travelled(measure, text)
