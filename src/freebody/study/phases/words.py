"""Modes and events in words."""

from __future__ import annotations

import re

from freebody.language.notation import as_equation
from freebody.language.sentences import Message, in_turn
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.model.elements import ConstraintRow, DryFriction, NonholonomicForm
from freebody.model.one_sided import GAP_OF_BUFFER
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.symbolic.first_integrals import is_driven

_AT_STOP = Message("at the stop"), Message("free")
_HELD = {
    "tension": (Message("taut"), Message("slack")),
    "buffer force": (Message("compressed"), Message("free")),
    "stop force": _AT_STOP,
    "stop torque": _AT_STOP,
}
_CONTACT = Message("touches"), Message("open")
_OCCURS = {
    "opens": Message("opens"),
    "touches": Message("touches"),
    "slips": Message("slips"),
    "slip ends": Message("slip ends"),
    "edge ends": Message("edge ends"),
    "is reached": Message("is reached"),
    "strikes": Message("is reached"),
    "changes sign": Message("is reached"),
    "is left": Message("comes"),
}


def states(phase: Phase) -> dict[str, str]:
    """The state of every contact, stop, ideal string and dry friction, by the name that a user knows."""
    found: dict[str, str] = {}
    rows = [row for row in phase.base.constraint_rows if row.unilateral] + [b.row for b in phase.base.bounds]
    acting = {name for name, acts in phase.mode.acting if acts}
    for row in [*rows, *phase.base.borders.values()]:
        closed, opened = _HELD.get(row.reaction, _CONTACT)
        found[label(row.name)] = closed if row.name in phase.mode.closed | acting else opened
    for row in phase.base.constraint_rows:
        if row.needs and f"{row.connection}.{row.needs}" in phase.mode.closed:
            found[row.connection] = Message("rolls")
    slipping = {rub.of for rub in phase.base.dry_friction if not rub.resists_turning}
    for rub in phase.base.dry_friction:
        name = label(rub.of or rub.name)
        state = phase.mode.states.get(rub.name)
        if rub.resists_turning and rub.of in slipping:
            continue  # whether the contact rolls or slides is told by its slip
        if state is not None:
            found[name] = verb(phase, rub, state)
    return found


def at_border(row: ConstraintRow, *, acts: bool) -> Message:
    """On which side of its border a load is."""
    name = row.connection
    if row.component == GAP_OF_BUFFER:
        told = Message("{buffer} is compressed", buffer=name), Message("{buffer} is not touched", buffer=name)
    else:
        told = Message("{string} is taut", string=name), Message("{string} is slack", string=name)
    return told[0] if acts else told[1]


def at_start(row: ConstraintRow, *, acts: bool) -> Message:
    """The same of the start."""
    name = row.connection
    if row.component == GAP_OF_BUFFER:
        told = (
            Message("{buffer} is compressed at the start", buffer=name),
            Message("{buffer} is not touched at the start", buffer=name),
        )
    else:
        told = (
            Message("{string} is taut at the start", string=name),
            Message("{string} is slack at the start", string=name),
        )
    return told[0] if acts else told[1]


def verb(phase: Phase, rub: DryFriction, state: int) -> str:
    if state:
        return Message("slides")
    if rolls(rub) and phase.model.coordinates:
        return Message("rolls") if rub.load or rub.of else Message("runs without slip")
    is_still = not phase.model.coordinates and not is_driven(phase.model)
    return Message("holds") if is_still else Message("sticks")


def rolls(rub: DryFriction) -> bool:
    """Whether no slip means rolling: a body turns along with it."""
    measure = rub.row.measure
    if isinstance(measure, NonholonomicForm):
        return True
    return isinstance(measure, Combination) and any(not isinstance(m, Displacement) for _c, m in measure.terms)


_EDGE = re.compile(r"(?P<what>.+) on (?P<body>\w+) (?P<start>\w+)-(?P<end>\w+)")  # of a box, by its corners


def label(name: str) -> str:
    """contact.contact is the contact; contact.foot on floor is said in full, the edge of a box as its side."""
    connection, _, component = name.partition(".")
    edge = _EDGE.fullmatch(component)
    if edge is not None and (side := [word for word in edge["start"].split("_") if word in edge["end"].split("_")]):
        component = f"{edge['what']} on {edge['body']}.{side[0]}"
    plain = ("contact", "slip", "length", "gap", "n", "normal", "friction", "min", "max", "torque")
    return connection if component in plain else f"{connection} ({component})"


def action(phase: Phase) -> str:
    """What the system does, in a few words."""
    closed = [name for blow in phase.base.blows if blow.name in phase.mode.past for name in blow.closing]
    found = states(phase)
    spoken = _by_connection(found)
    if closed and not spoken:
        if not phase.model.coordinates:
            return Message("holds")
        return Message("moves with {names} closed", names=in_turn(closed))
    if not spoken:
        if "taut" in found.values() and phase.base.borders:
            return Message("moves with a taut string")
        if not any(w == "touches" for w in found.values()):
            return Message("moves")
        return Message("moves in contact") if phase.model.coordinates else Message("stays in contact")
    if len(spoken) == 1:
        (word,) = spoken.values()
        alone = all(w == "open" for w in found.values())
        return {
            "open": Message("flies") if alone else Message("moves with an open contact"),
            "slack": Message("moves with a slack string"),
            "compressed": Message("moves against a buffer"),
        }.get(word, word)
    return in_turn([_place_does(n, w) for n, w in spoken.items()])


def in_phase(phase: Phase) -> str:
    """While what it does, for a note."""
    what = action(phase)
    return Message("while the system {what}", what=what) if is_of_all(phase) else Message("while {what}", what=what)


def is_of_all(phase: Phase) -> bool:
    """Whether what a phase does is said of the system, not of one of its connections."""
    return len(_by_connection(states(phase))) < 2


def _place_does(place: str, does: str) -> str:
    contact, _, where = place.partition(" (")
    if where:
        return Message("{contact} ({where}) {does}", contact=contact, where=where.removesuffix(")"), does=does)
    return Message("{contact} {does}", contact=contact, does=does)


def occurs(watch: PhaseWatch) -> str:
    """What a connection does at an event, behind its name."""
    return _OCCURS.get(watch.kind, watch.kind)


def _by_connection(found: dict[str, str]) -> dict[str, str]:
    """Places of one contact that do the same are told once; what is open beside one that touches is left out."""
    groups: dict[str, dict[str, str]] = {}
    for name, word in found.items():
        if word not in ("touches", "taut", "free"):
            groups.setdefault(name.partition(" (")[0], {})[name] = word
    touched = {name.partition(" (")[0] for name, word in found.items() if word == "touches"}
    spoken: dict[str, str] = {}
    for connection, words in groups.items():
        if connection in touched and all(word == "open" for word in words.values()):
            continue
        closed = {n: w for n, w in words.items() if w != "open"}
        if not closed:
            spoken[connection] = Message("open")
        elif len(set(closed.values())) > 1:
            spoken |= closed
        else:
            (name, word), *more = closed.items()
            corner = _corner(name)
            corners = {_corner(place) for place in words}  # of one point on the edges of a body there is one
            tips = bool(corner) and not more and len(words) > 2 and len(corners) > 1 and word in ("sticks", "slides")
            about = {
                "sticks": Message("tips about {corner}", corner=corner),
                "slides": Message("tips and slides on {corner}", corner=corner),
            }
            spoken[connection] = about[word] if tips else word
    return spoken


def _corner(place: str) -> str:
    """The point that touches in one of several places of a contact."""
    return place.partition(" (")[2].partition(" on ")[0].rpartition(".")[2]


def happening(watch: PhaseWatch, after: Phase | None) -> str:
    """An event in words."""
    name = label(watch.name)
    rows = () if after is None else after.base.constraint_rows
    pulls = watch.name.endswith(".length") or any(r.name == watch.name and r.reaction == "tension" for r in rows)
    match watch.kind:
        case "opens":
            if pulls:
                return Message("{contact} goes slack", contact=name)
            if watch.name.endswith(f".{GAP_OF_BUFFER}"):
                return Message("{contact} is relaxed again", contact=name)
            return Message("{contact} opens", contact=name)
        case "touches" if pulls:
            return Message("{contact} goes taut", contact=name)
        case "touches" if watch.name.endswith(f".{GAP_OF_BUFFER}"):
            return Message("{contact} is reached", contact=name)
        case "touches":
            return Message("{contact} touches", contact=name)
        case "bounces end":
            return Message("{contact} has bounced for the last time", contact=name)
        case "edge ends":
            return Message("{contact} reaches the end of its edge", contact=name)
        case "slips":
            return Message("{contact} begins to slip", contact=name)
        case "slip ends":
            state = None if after is None else after.mode.states.get(watch.name)
            if after is not None and state == 0:
                return {
                    "rolls": Message("rolling begins"),
                    "holds": Message("{contact} comes to rest", contact=name),
                }.get(verb(after, after.dry_friction[watch.name], 0), Message("slip of {contact} ends", contact=name))
            if state:
                return Message("slip of {contact} reverses", contact=name)
            return Message("slip of {contact} ends", contact=name)
        case "strikes":
            blow = None if after is None else next((b for b in after.base.blows if b.name == watch.name), None)
            if blow is None:
                return Message("{event} is reached", event=as_equation(watch.name))
            return Message("{blow} ({event})", blow=blow.words, event=watch.name)
        case "is left":
            return watch.name
        case "is reached" | "changes sign":
            return Message("{event} is reached", event=as_equation(watch.name))
        case _:
            return watch.kind
