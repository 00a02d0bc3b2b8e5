"""Screws and worms: their efficiency in both directions, and whether they lock themselves.

A thread of the slope tan(lambda) and the friction mu' = tan(phi') drives with tan(lambda)/tan(lambda + phi'), and is
driven back by its load with tan(lambda - phi')/tan(lambda). It locks itself where mu' of rest is at least tan(lambda):
then the second is not positive. Source: Meriam & Kraige, Statics, sec. 6/5; Shigley, Mechanical Engineering Design,
sec. 8-2 and 13-17.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import ONE, Expr, divide
from freebody.language.sentences import Message, Sentence
from freebody.model.noting import did_you_mean
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.turned_round import has_thread
from freebody.questions.whether import read_whether

if TYPE_CHECKING:
    from freebody.model.names import Names
    from freebody.model.thread import Thread

SCREW = """
space: {up: z}
parameters: {p: 8 mm, r: 15 mm, mu: 0.15}
bodies: {spindle: {cylinder: {mass: 1 kg, radius: r, length: 150 mm}}}
connections: {jack: {screw: {first: ground.nut, second: spindle, about: z, pitch: p, friction: mu, radius: r}}}
"""
RANK = 77


@dataclass(frozen=True)
class OfThread(Quantity):
    """A number that the thread of a connection alone gives."""

    is_by_law: ClassVar[bool] = True

    connection: str
    formula: Expr

    @property
    def unit(self) -> str:
        return "1"

    @property
    def kinematic_order(self) -> int:
        return 0

    @property
    def is_of_parameters(self) -> bool:
        return True

    def value(self, system: Described, state: State[Any]) -> Any:
        return state.scalar(self.formula)

    def sentence(self, system: Described) -> Sentence:
        return Sentence(f"what.{self.kind.replace(' ', '_')}", {"connection": self.connection})


@dataclass(frozen=True)
class ThreadEfficiency(OfThread, kind="efficiency of a thread"):
    """Of a screw or a worm that drives: the power at its nut or wheel over its own, while it slides."""

    example = f"{SCREW}questions: {{it: efficiency of jack}}\n"


@dataclass(frozen=True)
class BackDrivingEfficiency(OfThread, kind="back-driving efficiency"):
    """Of a screw or a worm that its load drives back, while it slides."""

    example = f"{SCREW}questions: {{it: back-driving efficiency of jack}}\n"

    @property
    def remarks(self) -> tuple[Message, ...]:
        return (Message("where it is not positive, the load cannot drive it back"),)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.back_driving_efficiency", {"connection": self.connection})


@dataclass(frozen=True)
class LockingReserve(OfThread, kind="self-locking"):
    """By how much the friction of a thread at rest is more than its slope."""

    example = f"{SCREW}questions: {{it: is jack self-locking}}\n"

    @property
    def remarks(self) -> tuple[Message, ...]:
        return (Message("its friction less its slope: it locks itself where this is not negative"),)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.self_locking", {"connection": self.connection})


# -- words ------------------------------------------------------------------------------------
@asked(
    "[back-driving] efficiency of SCREW | WORM_GEAR",
    rf"(?P<back>back-?driving )?efficiency of (?:the )?(?P<of>{NAME})(?P<load> driven (?:back )?by (?:its|the) load)?",
    rank=RANK,
)
def _efficiency(names: Names, found: Found, path: Path) -> Quantity | None:
    of, is_back = found["of"], found["back"] is not None or found["load"] is not None
    if _are_teeth(names, of):
        ideal = Message(
            "the teeth of {mesh} are taken as ideal: they lose no power, and the efficiency is 1. In an epicyclic gear "
            "train a loss is counted by: efficiency from BODY to BODY with BODY held and basic efficiency NUMBER",
            mesh=of,
        )
        names.problem(ideal, *path)
        return None
    thread = _thread(names, of, path)
    if thread is None:
        return None
    slope, mu = thread.slope, thread.kinetic
    if is_back:
        return BackDrivingEfficiency(of, divide(slope - mu, slope * (ONE + mu * slope)))
    return ThreadEfficiency(of, divide(slope * (ONE - mu * slope), slope + mu))


_LOCKS = "self-?locking"


@asked(
    "is SCREW | WORM_GEAR self-locking",
    rf"(?:[Ii]s|[Dd]oes) (?:the )?(?P<of>{NAME}) (?:{_LOCKS}|locks? itself)\??|{_LOCKS} of (?:the )?(?P<its>{NAME})",
    rank=RANK,
)
def _locks(names: Names, found: Found, path: Path) -> Quantity | None:
    of = found["of"] or found["its"]
    if found["of"] and not has_thread(names, of):
        with names.quietly():
            n_before = len(names.problems)
            locks = read_whether(names, f"{of} locks itself", path)
            is_known = len(names.problems) == n_before
            del names.problems[n_before:]
        if locks is not None and is_known:
            return locks
    thread = _thread(names, of, path)
    return None if thread is None else LockingReserve(of, thread.static - thread.slope)


def _thread(names: Names, name: str, path: Path) -> Thread | None:
    connection = names.connections.get(name)
    if connection is None:
        hint = did_you_mean(name, names.connections)
        names.unknown(name, Message("there is no connection {name}.{hint}", name=name, hint=hint), *path)
        return None
    thread = connection.thread(names)
    if isinstance(thread, str):
        names.problem(thread, *path)
        return None
    return thread


def _are_teeth(names: Names, name: str) -> bool:
    """Whether a connection is a mesh of teeth that lose nothing: all but that of a worm."""
    connection = names.connections.get(name)
    has_teeth = any(row.connection == name and row.reaction == "tooth force" for row in names.constraint_rows)
    return connection is not None and has_teeth and isinstance(connection.thread(names), str)
