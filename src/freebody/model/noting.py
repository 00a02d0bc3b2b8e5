"""Problems of a model, each with its place.

A reader never stops at the first mistake: it notes the problem and goes on with something harmless, so that one message
can list them all. What follows from a mistake elsewhere nobody is told twice.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Generator, Iterable
from contextlib import contextmanager
from functools import wraps
from typing import Concatenate, ParamSpec, TypeVar

from freebody.errors import Problem
from freebody.language.sentences import Message


def near(name: str, known: Iterable[str]) -> str:
    """' Did you mean x?' of what is written nearly alike; nothing where nothing is."""
    close = difflib.get_close_matches(name, sorted(set(known)), n=1, cutoff=0.6)
    return Message(" Did you mean {x}?", x=close[0]) if close else ""


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """' Did you mean x?', or the list of what there is. Of several that a name begins (gear_mesh, gear_pair for gear)
    none is preferred."""
    options = sorted(set(known))
    if len(begun := [option for option in options if option.startswith(f"{name}_")]) > 1:
        return Message(" Did you mean one of {names}?", names=", ".join(begun))
    if told := near(name, options):
        return told
    if not options:
        return ""
    shown = ", ".join(options[:12]) + (" ..." if len(options) > 12 else "")
    return Message(" There is: {names}.", names=shown)


P = ParamSpec("P")
R = TypeVar("R")
N = TypeVar("N", bound="Noting")


def reads(method: Callable[Concatenate[N, P], R]) -> Callable[Concatenate[N, P], R]:
    """A reader of one value, a name or a direction: what is noted in it is a mistake of that value, and no judgement of
    what it goes into."""

    @wraps(method)
    def read(self: N, /, *args: P.args, **kwargs: P.kwargs) -> R:
        self.n_reading += 1
        try:
            return method(self, *args, **kwargs)
        finally:
            self.n_reading -= 1

    return read


_ELEMENTS = {"connections": 2, "loads": 2, "bodies": 3}  # sections, and how long the path to one of their elements is


def _element(problem: Problem) -> tuple[str | int, ...]:
    return problem.path[: _ELEMENTS.get(str(problem.path[0]), 0)] if problem.path else ()


class Noting:
    """Notes problems."""

    def __init__(self) -> None:
        self.problems: list[Problem] = []
        self.assumptions: list[str] = []
        self.broken: set[str] = set()  # what could not be read: told where it stands, and nowhere else
        self.undeclared: dict[
            str, str
        ] = {}  # parameters that formulas use and nobody gives, and what was noted of them
        self.told_once: set[str] = set()  # what is one mistake, however often the model has it
        self.is_cut_short = False  # a whole section of names could not be read
        self.n_reading = 0  # readers of values that are at work
        self._misread: set[Problem] = set()  # problems of values
        self._path: tuple[str | int, ...] = ()

    @contextmanager
    def at(self, *path: str | int) -> Generator[None]:
        """Problems noted inside stand at this place of the model."""
        before = self._path
        self._path = before + path
        try:
            yield
        finally:
            self._path = before

    @property
    def here(self) -> tuple[str | int, ...]:
        """The place of the model that is being read."""
        return self._path

    @contextmanager
    def reading(self, section: str, name: str, *path: str | int) -> Generator[None]:
        """As `at`; a name of which a problem is noted inside is broken. Where a length of 0 stands under a fraction,
        reading it ends there: it is told, unless it only stands for what is told to be missing."""
        n_before = len(self.problems)
        with self.at(section, name, *path):
            try:
                yield
            except ZeroDivisionError:
                if not self.problems:
                    self.problem(Message("a length, a distance or a mass that {name} needs is 0", name=name))
        if len(self.problems) > n_before:
            self.broken.add(name)

    @property
    def causes(self) -> list[Problem]:
        """The problems, less those of a connection, a load or a shape in which a value could not be read: what is said
        of the whole follows from the stand-in for that."""
        misread = [p for p in self.problems if p in self._misread and p.path[:1] and p.path[0] in _ELEMENTS]
        elements = {_element(p) for p in misread}
        return [p for p in self.problems if _element(p) not in elements or p in misread]

    @property
    def lacks_elements(self) -> bool:
        """Whether something of the model could not be read, so that what seems not to be there may be."""
        return any(p.path[:1] and p.path[0] in _ELEMENTS for p in self.problems)

    def is_of_broken_kind(self, text: str) -> bool:
        """Whether a text speaks of a kind of thing one of which could not be read."""
        kinds = {str(p.path[2]) for p in self.problems if len(p.path) > 2 and p.path[0] in _ELEMENTS}
        return any(re.search(rf"\b{kind.replace('_', ' ')}\b", text.lower()) for kind in kinds)

    def is_told(self, *path: str | int) -> bool:
        """Whether a problem is noted at a place, or inside it."""
        here = self._path + path
        return any(p.path[: len(here)] == here for p in self.problems)

    @contextmanager
    def quietly(self) -> Generator[None]:
        """Problems noted inside are told elsewhere."""
        n_before = len(self.problems)
        try:
            yield
        finally:
            del self.problems[n_before:]

    def is_broken_in(self, text: str) -> bool:
        """Whether a text names what could not be read: it is told where that stands."""
        if self.is_cut_short or any(name in self.broken for name in re.findall(r"\w+", text)):
            return True
        return any(name in text for name in self.broken if not re.fullmatch(r"\w+", name))

    def is_undeclared_in(self, text: str) -> bool:
        """Whether a text names a parameter that is told to be missing already, where a formula uses it."""
        noted = {problem.message for problem in self.problems}
        return any(self.undeclared.get(name) in noted for name in re.findall(r"\w+", text))

    def unknown(self, name: str, message: str, *path: str | int) -> None:
        """Notes a problem of a name that stands for nothing, but not where that follows from another problem: then the
        entry that names it is broken, too."""
        if name not in self.broken and not self.is_cut_short:
            self.problem_once(message, *path)
        elif len(self._path) > 1 and self._path[0] != "questions":
            self.broken.add(str(self._path[1]))

    def problem_once(self, message: str, *path: str | int) -> None:
        """Notes a problem that is one mistake wherever it shows: it is told where it shows first."""
        self.problem(message, *path)
        self.told_once.add(message)

    def problem(self, message: str, *path: str | int) -> None:
        noted = Problem(self._path + path, message)
        if self.n_reading:
            self._misread.add(noted)
        if noted not in self.problems:
            self.problems.append(noted)
