"""What may be so of a whole motion: an event comes, comes before another or at once, never comes; a state lasts.

    rope stays taut        ball never leaves the dome        wheel rolls without slipping until x = d
    contact opens before x = d        x reaches d before rolling begins        rolling begins at once

Questions turned round ask for the values of a parameter for which it is so.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.measures.base import Measure
from freebody.measures.distance import Distance
from freebody.questions.base import Path, Quantity
from freebody.questions.course import Transition, can_change, connections_of, names_line, read_transition
from freebody.questions.event import AskedEvent, TurnsBack, read_event
from freebody.questions.event_base import QuestionEvent
from freebody.questions.forms import NAME
from freebody.questions.operands import TURNS_BACK
from freebody.questions.turned_round import reached_in

if TYPE_CHECKING:
    from freebody.model.names import Names

NOTHING_SLIDES = Message(
    "nothing slides at the start, so that nothing can lock there: ask what keeps it at rest, as in range of mu that "
    "keeps it at rest"
)
LastingKind = Literal["touches", "rolls", "stands", "locks"]


@dataclass(frozen=True)
class Lasting:
    """A state of connections that is so in every phase: they touch (strings are taut), nothing slips in them, or no
    body tips: of its places that touch at the start none opens while another, or a hinge, stays; or what slides at the
    start locks itself. `of` are the connections that are meant; none means all."""

    kind: LastingKind
    of: tuple[str, ...]
    text: str


@dataclass(frozen=True)
class Happening(Quantity):
    """Whether something happens in a motion, or lasts. before: what must not come first; at_once: whether the start
    alone is meant; is_so: False where it is not to happen; away: a distance that is to grow, as of what escapes."""

    what: Transition | Lasting | AskedEvent | None
    text: str
    before: Transition | AskedEvent | None = None
    at_once: bool = False
    is_so: bool = True
    away: Measure | None = None

    scope = "course"
    measured_in = DIMENSIONLESS

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS

    @property
    def is_of_whole(self) -> bool:
        return True


@dataclass(frozen=True)
class FailsFirst(Happening):
    """Whether a system at rest tips before it slides, or the other way round, as a parameter grows."""

    fails: Literal["tips", "slides"] = "tips"
    grows: str = ""

    scope = "rest"


@dataclass(frozen=True)
class StableEquilibrium(Happening):
    """Whether an equilibrium is stable."""

    scope = "small motion"


@dataclass(frozen=True)
class ExistingEquilibrium(Happening):
    """Whether there is an equilibrium."""

    scope = "small motion"


@dataclass(frozen=True)
class StableSteadyMotion(Happening):
    """Whether the steady motion of the start is stable."""

    scope = "steady motion"


@dataclass(frozen=True)
class ExistingSteadyMotion(Happening):
    """Whether there is a steady motion in a place."""

    scope = "steady motion"


# -- words ------------------------------------------------------------------------------------
_SUBJECT = rf"(?:it|the motion|the system|(?:the )?(?P<of>{NAME}))"
_STAYS = r"(?:always )?(?:stays?|remains?|keeps?|is always)(?: always)?"
_ON = rf"(?: (?:the )?(?P<on>{NAME}))?"
_STATES: tuple[tuple[str, LastingKind], ...] = (
    (rf"{_STAYS} (?:taut|tight|stretched|closed|pressed)", "touches"),
    (rf"{_STAYS} (?:on|upon|in contact(?: with)?|in touch with|touching|contact(?: with)?){_ON}", "touches"),
    (rf"(?:does not|never) (?:leaves?|(?:loses?|breaks?) contact(?: with)?|(?:lift|take|jump)s? off){_ON}", "touches"),
    (r"(?:(?:does not|never) (?:goes|go|becomes?|gets?)|is never) slack", "touches"),
    (r"(?:(?:does not|never) (?:opens?|parts?))", "touches"),
    (r"rolls (?:on )?without (?:slip|slipping|sliding)", "rolls"),
    (r"(?:does not|never) (?:slips?|slides?)(?: (?:as|while) it rolls)?", "rolls"),
    (rf"{_STAYS} rolling(?: without (?:slip|slipping|sliding))?", "rolls"),
    (r"(?:does not|never) tips?(?: over)?", "stands"),
    (r"(?:locks (?:itself|by itself)|is self-?locking|jams|seizes)", "locks"),
)
_ROLLS = re.compile(rf"^{_SUBJECT} rolls$")  # where it is let go; what is thrown comes to roll
_TIPS = re.compile(rf"^{_SUBJECT} tips(?: over)?$")
_LASTING: list[tuple[re.Pattern[str], LastingKind]] = [
    (re.compile(rf"^{_SUBJECT} {pattern}$"), kind) for pattern, kind in _STATES
]
# what goes away and never turns back
_ESCAPES = re.compile(
    rf"^(?:the )?(?P<of>{NAME}) (?:escapes|(?:never|does not|will not) (?:ever )?(?:(?:comes?|gets?) back|returns?))$"
)
_NO_SLIP = re.compile(r"^(?:there is no slip(?:ping)?|no slip(?:ping)?|without slip(?:ping)?)$")
_NEVER = re.compile(
    rf"^(?P<who>it|the motion|(?:the )?{NAME}) (?:does not|do not|never|will not) (?P<verb>\w+)(?P<rest>.*)$"
)
_BEFORE = re.compile(r"^(?P<what>.+?) (?P<word>before|until|up to(?: where)?|as long as not) (?P<before>.+)$")
_AT_ONCE = re.compile(
    r"^(?P<what>.+?),? (?:at once|immediately|straight away|at the (?:very )?(?:start|beginning)|at start|"
    r"from the (?:very )?(?:start|beginning)(?: on)?|from start|just after the start)$"
)
_REACHES = re.compile(r"^(?P<what>.+?) (?:reaches|gets to|comes to|gets as far as|passes) (?P<value>.+)$")


_WHO = rf"(?:it|the system|(?:the )?{NAME})"
_FAILS = re.compile(
    rf"^{_WHO} (?P<first>tips|slides|slips)(?: over)? (?:before|rather than|earlier than|first,? before) (?:{_WHO} )?"
    rf"(?P<second>tips|slides|slips|tipping|sliding|slipping)"
    rf"(?: (?:as|when|while) (?:the )?(?:force |torque |angle )?(?P<grows>{NAME}) (?:grows|increases|is increased))?$"
)
_STABLE = re.compile(
    r"^(?:(?:the |this )?(?:[a-z]+ )?(?:equilibrium|position|pose)(?: at (?:the )?start)?|it|the system) "
    r"(?:is|is in) (?P<not>un|not )?stable(?: equilibrium)?$"
)


_BALANCES = re.compile(
    rf"^(?:(?:an?|the|any) equilibrium(?: position)?(?: of (?:the )?{NAME})? (?:exists|is (?:there|possible))"
    r"|there is (?P<none>no |an? )?equilibrium(?: position)?)$"
)
_STEADY = re.compile(r"^(?:the |this |its )?steady (?:motion|rotation|precession|state) is (?P<not>un|not )?stable$")
_EXISTS = re.compile(
    r"^(?:(?:the |this |a |such a )?steady (?:motion|rotation|precession|turning) (?:exists|is (?:there|possible))"
    r"|there is (?P<none>no |a |such a )?steady (?:motion|rotation|precession|turning))$"
)


def read_happening(names: Names, text: str, path: Path) -> Happening | None:
    """What a text states of a motion, or of a state of rest; None if it is nothing of the kind."""
    whole = text.strip()
    if (stable := _STABLE.match(whole)) is not None:
        return StableEquilibrium(None, whole, is_so=stable["not"] is None)
    if (steady := _STEADY.match(whole)) is not None:
        return StableSteadyMotion(None, whole, is_so=steady["not"] is None)
    if (fails := _FAILS.match(whole)) is not None:
        return _fails_first(names, whole, fails, path)
    if not _is_rough(names) and (balances := _BALANCES.match(whole)) is not None:
        return ExistingEquilibrium(None, whole, is_so=balances["none"] != "no ")
    if (exists := _EXISTS.match(whole)) is not None:
        return ExistingSteadyMotion(None, whole, is_so=exists["none"] != "no ")
    parts = _BEFORE.match(whole)
    head, limit = (parts["what"], parts["before"]) if parts is not None else (whole, None)
    at_once = _AT_ONCE.match(head)
    head = head if at_once is None else at_once["what"]
    found = _stated(names, head, path, timed=limit is not None)
    if found is None:
        return None
    what, is_so = found
    if parts is not None and parts["word"] != "before" and isinstance(what, Transition) and what.kind == "slips":
        what, is_so = replace(what, kind="rolls"), not is_so  # what slides until then has not come to hold before
    before: Transition | AskedEvent | None = None
    if limit is not None:
        before = read_transition(names, limit, path)
        before = read_event(names, _as_equation(limit), path) if before is None else before
        if before is None:
            return None
    is_of_start = at_once is not None or (isinstance(what, Lasting) and what.kind in ("stands", "locks"))
    gone = _ESCAPES.match(head)
    away = None if gone is None else names.measures.get(_outward(names, gone["of"]) or "")
    return Happening(what, whole, before, is_of_start, is_so, away if isinstance(away, Distance) else None)


def _is_rough(names: Names) -> bool:
    """Whether dry friction holds something: then there is rest in many poses, and is asked for as such."""
    return any(row.reaction.startswith("friction force") for row in names.constraint_rows)


def _fails_first(names: Names, text: str, found: re.Match[str], path: Path) -> Happening | None:
    """Which failure is meant to come first."""
    tips = [word.startswith("tip") for word in (found["first"], found["second"])]
    if tips[0] == tips[1]:
        names.problem(Message("cannot read the condition '{text}'; write for example x = h", text=text), *path)
        return None
    if found["grows"] is None:
        names.problem(Message("say as what grows: {text} as F grows", text=text), *path)
        return None
    grows = names.parameters.get(found["grows"])
    if grows is None or grows.form is not None:
        names.unknown(found["grows"], names.no_parameter(found["grows"]), *path)
        return None
    return FailsFirst(None, text, fails="tips" if tips[0] else "slides", grows=grows.name)


def _stated(
    names: Names, text: str, path: Path, *, timed: bool
) -> tuple[Transition | Lasting | AskedEvent, bool] | None:
    """A state that lasts, an event that comes, or (False) does not. timed: whether it is to come before something."""
    if _NO_SLIP.match(text):
        return Lasting("rolls", (), text), True
    for pattern, kind in _LASTING:
        found = pattern.match(text)
        if found is not None and kind == "locks" and names.lets_go_from_rest:
            return None  # what rests locks itself where it stays at rest, however large the load is
        if found is not None and found["of"] not in names.measures:
            of = _of(names, found.groupdict(), path)
            if kind == "touches":
                _check_that_it_may_open(names, of, path)
            return Lasting(kind, of, text), True
    if not timed and names.lets_go_from_rest and (rolls := _ROLLS.match(text)) is not None:
        return Lasting("rolls", _of(names, rolls.groupdict(), path), text), True
    if (tips := _TIPS.match(text)) is not None:
        if not any(row.unilateral and row.reaction == "normal force" for row in names.constraint_rows):
            told = Message(
                "nothing stands on a contact from which it could tip: say how far it has to turn, e.g. least {p} so "
                "that {angle} reaches 90 deg",
                p=next(iter(names.parameters), "w0"),
                angle=next((name for name, m in names.measures.items() if m.dimension == DIMENSIONLESS), "phi"),
            )
            names.problem(told, *path)
        return Lasting("stands", _of(names, tips.groupdict(), path), text), False
    if (escapes := _ESCAPES.match(text)) is not None and (away := _outward(names, escapes["of"])) is not None:
        event = read_event(names, f"{away} turns back", path)
        return None if event is None else (event, False)
    never = _NEVER.match(text)
    if never is not None:
        stated = f"{never['who']} {third_person(never['verb'])}{never['rest']}"
        goes_back = TURNS_BACK.match(stated) is not None and can_change(names)
        inner = _stated(names, stated, path, timed=not goes_back)
        return None if inner is None else (inner[0], not inner[1])
    if not timed and can_change(names) and (turns := TURNS_BACK.match(text)) is not None:
        event = read_event(names, text, path)
        is_one = isinstance(event, QuestionEvent) and turns["what"] in names.measures
        return (TurnsBack(event.measure, event.order, event.value, event.text), True) if is_one else None
    transition = read_transition(names, text, path)
    if transition is not None:
        return transition, True
    reached = reached_in(text) if (passed := _as_equation(text)) == text else passed
    if timed and reached is not None:
        event = read_event(names, reached, path)
        return None if event is None else (event, True)
    return None


def _outward(names: Names, who: str) -> str | None:
    """The measure that tells how far away something is: itself, or of what a centre attracts, or nothing holds, the one
    distance."""
    if who in names.measures:
        return who
    is_attracted = any("attraction" in names.called.get(load, ()) for load in names.loads) or not names.connections
    far = [name for name, measure in names.measures.items() if isinstance(measure, Distance)]
    return far[0] if is_attracted and len(far) == 1 and (who == "it" or who in names.bodies) else None


def _of(names: Names, found: dict[str, str | None], path: Path) -> tuple[str, ...]:
    """The connections that are meant: those of a name, or between two."""
    if found["of"] is None:
        return ()
    of, on = connections_of(names, found["of"], path), found.get("on")
    if on is None:
        return of
    if any(
        on in body.lines or on in body.planes for body in names.bodies.values()
    ):  # of a body, its string is not meant
        return tuple(connection for connection in of if names_line(names, connection, on)) or of
    other = connections_of(names, on, path)
    both = tuple(connection for connection in of if connection in other)
    if of and other and not both:
        told = Message("{name} and {other} have no contact with each other", name=found["of"], other=on)
        names.problem(told, *path)
    return both


def _check_that_it_may_open(names: Names, of: tuple[str, ...], path: Path) -> None:
    """What holds both ways never lets go, so that nobody asks for it."""
    one_sided = {row.connection for row in names.constraint_rows if row.unilateral}
    one_sided |= {load.load for load in names.applied_loads if load.one_sided is not None}
    if of and one_sided.isdisjoint(of):
        told = Message(
            "{connections} cannot open: it holds both ways. What may be left is a contact, a string, or a rail with "
            "`leaves: true`",
            connections=", ".join(of),
        )
        names.problem(told, *path)


def third_person(verb: str) -> str:
    """leave: leaves; go: goes; touch: touches."""
    if verb.endswith("s") and not verb.endswith("ss"):
        return verb
    return f"{verb}es" if verb.endswith(("o", "s", "ch", "sh", "x")) else f"{verb}s"


def _as_equation(text: str) -> str:
    found = _REACHES.match(text)
    return text if found is None else f"{found['what']} = {found['value']}"
