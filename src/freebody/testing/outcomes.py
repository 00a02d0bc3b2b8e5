"""Every study of a model, run with a limit of work, and what came of it.

A study ends in an answer or in a refusal that says why. Anything else is a defect: an exception that is no
`FreebodyError`, two routes that disagree, an answer with neither value nor reason, or no end within the limit.
"""

from __future__ import annotations

import gc
import signal
import threading
import traceback
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from types import FrameType

from freebody.api import System
from freebody.errors import FreebodyError, RoutesDisagree, RoutesUntold
from freebody.present.report.result import Result
from freebody.study.answering.answer import Answer

DISAGREE = ("routes disagree", "defect of freebody", "another formula than the solver")
OF_THE_INSIDE = ("has no value; known are", "the arithmetic of this study", "run tools/")  # nothing a user could mend
UNTIL = 0.05  # s, of a short simulation
REPEATED, UNHEARD = 0.05, 0.002  # s, when the limit of work is raised again; where it was not heard


class End(Enum):
    """How a study ended."""

    ANSWERED = "answered"
    REFUSED = "refused"
    UNTYPED = "untyped"
    DISAGREE = "disagree"
    EMPTY = "neither value nor reason"
    TOO_LONG = "too long"
    CRASHED = "crashed"

    @property
    def is_defect(self) -> bool:
        return self not in (End.ANSWERED, End.REFUSED, End.TOO_LONG)


@dataclass(frozen=True)
class Outcome:
    """How one study of one model ended, with the message, and for an exception the place that raised it."""

    study: str
    end: End
    message: str = ""
    place: str = ""


class OutOfWork(BaseException):
    """The limit of processor time is used up. No `Exception`, so that nothing on the way takes it for its own."""


class _Collecting:
    """Whether the garbage collector is at work: what is raised in one of its callbacks is lost and only reported.

    Its callbacks run in their order, so the one that notes the beginning stands first and the one that notes the end
    stands last.
    """

    def __init__(self) -> None:
        self.is_so = False

    def begins(self, phase: str, _info: dict[str, int]) -> None:
        self.is_so = self.is_so or phase == "start"

    def ends(self, phase: str, _info: dict[str, int]) -> None:
        self.is_so = self.is_so and phase != "stop"


def _swallows(frame: FrameType | None) -> bool:
    """Whether an exception raised here would be lost: inside a destructor, or in the notes of the collector."""
    while frame is not None:
        code = frame.f_code
        if code.co_name == "__del__" or code in (_Collecting.begins.__code__, _Collecting.ends.__code__):
            return True
        frame = frame.f_back
    return False


@contextmanager
def limited(seconds: float | None) -> Generator[None]:
    """At most so much processor time [s] inside; without a limit where the system has no such alarm. Compiled code that
    is interrupted while it calls back into Python may drop the alarm and raise an error of its own: what comes out
    after the alarm is the alarm."""
    if seconds is None or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return
    collecting = _Collecting()
    has_rung = False

    def stop(_number: int, frame: FrameType | None) -> None:
        nonlocal has_rung
        if not collecting.is_so and not _swallows(frame):
            has_rung = True
            raise OutOfWork
        signal.setitimer(signal.ITIMER_PROF, UNHEARD, REPEATED)

    gc.callbacks.insert(0, collecting.begins)
    gc.callbacks.append(collecting.ends)
    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds, REPEATED)
    try:
        yield
    except Exception as error:
        if has_rung:
            raise OutOfWork from error
        raise
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
        gc.callbacks.remove(collecting.begins)
        gc.callbacks.remove(collecting.ends)


# -- the studies ------------------------------------------------------------------------------
Study = Callable[[System], "list[Outcome]"]


def _of_answers(study: str, answers: tuple[Answer, ...]) -> list[Outcome]:
    return [outcome_of_answer(f"{study}: {a.question}", a) for a in answers]


def outcome_of_answer(study: str, answer: Answer) -> Outcome:
    """What became of one question."""
    if answer.reason:
        return _refused(study, answer.reason)
    if answer.is_answered or answer.conditions or answer.cases:
        return Outcome(study, End.ANSWERED)
    return Outcome(study, End.EMPTY, f"no expression, no value and no reason for '{answer.question}'")


def _refused(study: str, reason: str) -> Outcome:
    """A refusal, or what stands in the words of one and is none."""
    if any(word in reason for word in DISAGREE):
        return Outcome(study, End.DISAGREE, reason)
    return Outcome(study, End.UNTYPED if any(word in reason for word in OF_THE_INSIDE) else End.REFUSED, reason)


def _solve(system: System) -> list[Outcome]:
    solution = system.solve()
    solution.to_text()
    solution.to_plain()
    return _of_answers("solve", solution.answers)


def _told(study: Callable[[System], Result]) -> Study:
    """A study whose result is written in words and as data."""

    def run(system: System) -> list[Outcome]:
        found = study(system)
        found.to_text()
        found.to_plain()
        return [Outcome("", End.ANSWERED)]

    return run


def _eom(system: System) -> list[Outcome]:
    system.equations_of_motion().to_latex()
    return _told(System.equations_of_motion)(system)


def _simulate(system: System) -> list[Outcome]:
    found = system.simulate(UNTIL, max_seconds=20.0)
    found.to_text()
    found.summary()
    return [Outcome("", End.ANSWERED if found.status.is_complete else End.REFUSED, found.message)]


def _draw(system: System) -> list[Outcome]:
    picture = system.picture()
    picture.svg()
    picture.tikz()
    for body in system.moving[:1]:
        system.free_body(body.name).svg()
    return [Outcome("", End.ANSWERED)]


def _explain(system: System) -> list[Outcome]:
    found = system.explain()
    found.to_text()
    return [Outcome("", End.ANSWERED)]


def _write(system: System) -> list[Outcome]:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "model.yaml"
        path.write_text(system.to_yaml(), encoding="utf-8")
        is_same = System.load(path) == System.from_text(system.to_yaml(), str(path))
    return [
        Outcome(
            "",
            End.ANSWERED if is_same else End.DISAGREE,
            "" if is_same else "written back it is another model",
        )
    ]


@cache
def studies() -> dict[str, Study]:
    """All studies by name, the cheap ones first."""
    return {
        "write": _write,
        "solve": _solve,
        "draw": _draw,
        "mobility": _told(System.mobility),
        "equilibrium": _told(System.equilibria),
        "modes": _told(System.modes),
        "statics": _told(System.statics),
        "eom": _eom,
        "conserved": _told(System.conserved),
        "simulate": _simulate,
        "explain": _explain,
    }


def run(name: str, system: System, seconds: float | None = None) -> list[Outcome]:
    """One study of a model, with a limit of processor time [s]: an outcome, or one a question."""
    try:
        with limited(seconds):
            found = studies()[name](system)
    except OutOfWork as stopped:
        return [Outcome(name, End.TOO_LONG, f"no end after {seconds:g} s of processor time", _place(stopped))]
    except RoutesDisagree as error:
        end = End.REFUSED if isinstance(error, RoutesUntold) else End.DISAGREE
        return [Outcome(name, end, str(error))]
    except FreebodyError as error:
        return [_refused(name, str(error))]
    except Exception as error:
        return [untyped(name, error)]
    return [o if o.study else Outcome(name, o.end, o.message, o.place) for o in found]


def untyped(study: str, error: Exception) -> Outcome:
    """An exception that no one expected, with the deepest place in the package."""
    return Outcome(study, End.UNTYPED, f"{type(error).__name__}: {error}", _place(error))


def _place(error: BaseException) -> str:
    """The deepest places in the package that an exception came through."""
    frames = [f for f in traceback.extract_tb(error.__traceback__) if "freebody" in f.filename]
    return " < ".join(f"{Path(f.filename).name}:{f.lineno} {f.name}" for f in reversed(frames[-3:]))
