"""What a line of the table of studies says, and how it is entered there: by a decorator of a method without a body."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import wraps
from importlib import import_module
from inspect import Parameter, Signature, signature
from pathlib import Path
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

from freebody.narrative.words import languages

P = ParamSpec("P")
R = TypeVar("R")


@dataclass(frozen=True)
class Option:
    """How a parameter of a study is given on the command line: by a word after a flag, by several, or by the flag
    alone if it is a switch. read: the function that makes of a word what the study takes, by its place. is_list:
    several words may stand between commas; is_joined: all words are read together."""

    parameter: str
    flags: tuple[str, ...]
    help: str
    kind: Any = str
    default: Any = None
    metavar: str | None = None
    read: str = ""
    is_list: bool = False
    is_joined: bool = False

    def given(self, word: Any) -> Any:
        """What the study is given for what stands on the command line. Raises InputError if it cannot be read."""
        from freebody.errors import InputError

        if self.is_list:
            given: list[str] = word or []
            return [part for part in map(str.strip, ",".join(given).split(",")) if part]
        if self.is_joined or word == []:
            word = word or None
        if word is None or not self.read:
            return word
        home, _, name = self.read.rpartition(".")
        reading = getattr(import_module(home), name)

        def read(text: Any) -> Any:
            try:
                return reading(text)
            except InputError as error:
                is_told = self.is_joined or str(error).startswith(text)
                where = self.flags[-1] if is_told else f"{self.flags[-1]} {text}:"
                raise InputError(f"{where} {error}") from error

        return read(word) if self.kind is str or self.is_joined else [read(each) for each in word]


@dataclass(frozen=True)
class Study:
    """A line of the table. command: its name on the command line, empty where it has none; busy: what users are told
    meanwhile; is_short: the terminal shows very long formulas by their size unless they are wanted in full."""

    name: str
    home: str
    help: str
    command: str
    busy: str
    options: tuple[Option, ...]
    is_short: bool
    is_told: bool = False  # its line has a language

    @property
    def function(self) -> Callable[..., Any]:
        """The study itself, as a function of a system; where its line has a language, what it finds is told in it."""
        own = getattr(import_module(self.home), self.name)
        return _in_language(own) if self.is_told and "language" not in signature(own).parameters else own


def _in_language(own: Callable[..., Any]) -> Callable[..., Any]:
    """A study that is told in a language besides English: one that knows of none itself."""

    @wraps(own)
    def told(system: Any, /, *args: Any, language: str = "en", **kwargs: Any) -> Any:
        if isinstance(system, str | Path):
            read = f"freebody.System.load({str(system)!r})"
            raise TypeError(f"{own.__name__} takes a system: freebody.{own.__name__}({read}, ...)")
        if language == "en":
            return own(system, *args, **kwargs)
        from freebody.narrative.telling.catalogue import Catalogue
        from freebody.narrative.telling.reports import ReportTeller

        Catalogue(language)  # that there are no words of it is told before anything is computed
        return own(system, *args, **kwargs).told_by(ReportTeller(language))

    known = signature(own)
    *before, last = known.parameters.values()
    word = Parameter("language", Parameter.KEYWORD_ONLY, default="en", annotation="str")
    parts = [*before, word, last] if last.kind is Parameter.VAR_KEYWORD else [*before, last, word]
    told.__signature__ = Signature(parts, return_annotation=known.return_annotation)  # pyrefly: ignore[missing-attribute]
    return told


LANGUAGE = Option("language", ("--language",), f"{' or '.join(reversed(languages()))}.", default="en")
STUDIES: dict[str, Study] = {}  # by name, in the order in which the command line lists them


def study(
    home: str, command: str = "", *, busy: str = "", options: Sequence[Option] = (), is_short: bool = False
) -> Callable[[Callable[Concatenate[Any, P], R]], Callable[Concatenate[Any, P], R]]:
    """Enters a method into the table: it is the function of the same name in the module `home`."""

    def entered(line: Callable[Concatenate[Any, P], R]) -> Callable[Concatenate[Any, P], R]:
        sentence = (line.__doc__ or "").split("\n\n")[0]
        is_told = "language" in signature(line).parameters
        known = [*options, LANGUAGE] if is_told else options
        entry = Study(line.__name__, home, sentence, command, busy, tuple(known), is_short, is_told)
        STUDIES[entry.name] = entry

        @wraps(line)
        def method(system: Any, /, *args: P.args, **kwargs: P.kwargs) -> R:
            return cast("R", entry.function(system, *args, **kwargs))

        return method

    return entered
