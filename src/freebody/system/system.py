"""A mechanical system: the immutable value that every study starts from.

`System` holds what the user described (plain data, so that it can be written back) and what it means
(`SystemDescription`). It can be built from a file, from text, or from Python objects; all three go through the same
reader and give the same value.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from pathlib import Path
from typing import Any, Self, cast

from freebody.errors import InputError, ModelError, Problem
from freebody.language.document import Document
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.language.written import as_text
from freebody.model.spec import Spec
from freebody.questions.reading import Question, read_questions
from freebody.system.description import SystemDescription
from freebody.system.reader import read_system
from freebody.system.reading.ground import place_ground_points
from freebody.system.unspecified import with_dimension

LONGEST = 4000  # characters of a question


class System(SystemDescription):
    """A system that is read, and read again with other values: `with_parameters` makes another one."""

    __hash__ = SystemDescription.__hash__

    def __new__(cls, *data: object, **_fields: object) -> Self:
        """Made by `load`, `from_text` or `from_data`. Raises TypeError where it is called with what these take."""
        if data:
            raise TypeError(f"write {cls.__name__}.from_data(...), or load(...) for a file")
        return super().__new__(cls)

    def __init__(self, **fields: Any) -> None:
        """Of its parts; who makes a model calls `load`, `from_text` or `from_data`. Raises TypeError without them."""
        if not fields:
            raise TypeError(f"write {type(self).__name__}.from_data({{...}}), or load(...) for a file")
        super().__init__(**fields)

    # -- making -------------------------------------------------------------------------------
    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Reads a model file. Raises ModelError with all problems of the file."""
        return cls._read(Document.load(path), str(path))

    @classmethod
    def from_text(cls, text: str, file: str | None = None) -> Self:
        """Reads a model from YAML text."""
        return cls._read(Document.read(text, file), file)

    @classmethod
    def from_document(cls, document: Document) -> Self:
        """Reads a model from a document that has been read."""
        return cls._read(document, document.file)

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Self:
        """Builds a model from plain data and description objects (`Pin("ground.A", "rod.start")`)."""
        return cls._read(Document.from_plain(_plain(data)), None)

    def with_parameters(self, **values: str | float) -> Self:
        """The same system with other parameter values; comments of its file are kept."""
        document = self.document
        for name, value in values.items():
            if name not in self.parameters:
                raise InputError(self.names.no_parameter(name))
            given = document.data["parameters"][name] if name not in self.unspecified else None
            if self.parameters[name].form is not None:
                document = document.with_value(("parameters", name, "function"), str(value))
                continue
            if not isinstance(value, str):  # a bare number is in SI units
                dimension, is_angle = self.parameters[name].dimension, self.parameters[name].is_angle
                unit = "rad" if is_angle else "" if dimension == DIMENSIONLESS else str(dimension)
                value = f"{value!r} {unit}" if unit else value
            elif self.parameters[name].dimension != DIMENSIONLESS and _is_bare(value) and not _has_unit(given):
                unit = self.parameters[name].unit or str(self.parameters[name].dimension)
                raise InputError(
                    Message("{name} = {value} has no unit: write {value} {unit}", name=name, value=value, unit=unit)
                )
            if name in self.unspecified:
                document = with_dimension(document, self.unspecified[name], value)
                continue
            path = ("parameters", name, "value") if isinstance(given, dict) else ("parameters", name)
            document = document.with_value(path, value)
        return self._read_given(document, "parameters")

    def _read_given(self, document: Document, *under: str | int | None) -> Self:
        """What was read with a value that no file has: of a mistake in it no place in the file is told. under: where
        the value stands in the document, None for any; what follows there, such as the name of a parameter, is its
        place."""
        try:
            return self._read(document, self.file)
        except ModelError as error:
            n = len(under)

            def is_under(path: tuple[str | int, ...]) -> bool:
                return len(path) >= n and all(own in (None, part) for own, part in zip(under, path, strict=False))

            told = [Problem(p.path[n:], p.message) if is_under(p.path) else p for p in error.problems]
            if all(p.line is None for p in told):
                raise ModelError(told) from error
            raise ModelError(told, self.file) from error

    def with_mode(self, name: str) -> Self:
        """The same system started in another assembly mode; `mobility` lists their names."""
        return self._read(self.document.with_value(("start", "mode"), name), self.file)

    @classmethod
    def _read(cls, document: Document, file: str | None) -> Self:
        read = read_system(document, file)
        return cls(**{f.name: getattr(read, f.name) for f in fields(read)})

    # -- asking -------------------------------------------------------------------------------
    def question(self, text: str) -> Question:
        """A question given in words. Raises InputError if it cannot be read, or asks for several things."""
        found = self.asked(text)
        if len(found) > 1:
            several = "\n    ".join(question.text for question in found)
            told = Message(
                "'{text}' asks for several things; ask for one of\n    {several}", text=text, several=several
            )
            raise InputError(told)
        return next(iter(found))

    def asked(self, *texts: str) -> tuple[Question, ...]:
        """What texts ask for: one question each, or several. Raises InputError if one cannot be read."""
        for text in texts:
            if len(text) > LONGEST:
                raise InputError(
                    Message("a question has at most {most} characters, this one {n}", most=LONGEST, n=len(text))
                )
        names = self.names.for_questions()
        names.usual_questions = tuple(question.understood or question.text for question in self.questions)
        found = read_questions(names, [{"find": text} for text in texts])
        place_ground_points(names)
        if names.problems:  # of a mistake in what no file has no place is told
            once = dict.fromkeys((p.path[3:], p.message) for p in names.problems)
            raise ModelError([Problem(path, message) for path, message in once])
        return found

    def asked_with(self, *texts: str) -> tuple[Self, tuple[Question, ...]]:
        """What texts ask for, as `asked` tells, and the system of which they do: a text that cannot be read states
        values of parameters, as in `tension of rope with m2 = 3 kg`, and is asked of the system that has them; or it
        says that something is cut, as in `acceleration of bar just after rope is cut`."""
        try:
            return self, self.asked(*texts)
        except ModelError:
            others = [self._with_stated(text) or self._with_cut(text) for text in texts]
            if len(texts) == 1 and others[0] is not None:
                return others[0]
            for text, other in zip(texts, others, strict=True):
                if other is not None:
                    told = Message("'{text}' is asked of another model than the others: ask it by itself", text=text)
                    raise InputError(told) from None
            raise

    def _with_stated(self, text: str) -> tuple[Self, tuple[Question, ...]] | None:
        """The system with the values of parameters that a text states, and what is asked of it; None without them."""
        from freebody.questions.spoken.other_values import stated_values

        values, rest = stated_values(self.names, text)
        if not values:
            return None
        system = self.with_parameters(**values)
        try:
            found = system.asked(rest)
        except ModelError:
            return None
        *before, last = (f"{name} = {value}" for name, value in values.items())
        told = f"{', '.join(before)} and {last}" if before else last
        asked = tuple(replace(q, understood=f"{q.understood or q.text} with {told}") for q in found)
        return system, asked if len(asked) > 1 else (replace(asked[0], text=text),)

    def _with_cut(self, text: str) -> tuple[Self, tuple[Question, ...]] | None:
        """The system without the connection or load that a text says is cut, and what is asked of it; None where it
        says so of none, or where nothing else can be asked."""
        from freebody.questions.spoken.assumed import cut_in

        if (cut := cut_in(self.names, text)) is None:
            return None
        gone, rest = cut
        document = self.document.without(("questions",)) if "questions" in self.document.data else self.document
        for name in gone:
            document = document.without(("connections" if name in self.connections else "loads", name))
        try:
            whole = " ".join(q.understood or q.text for q in self.asked(rest))
        except ModelError:
            return None
        if any(re.search(rf"(?<!along )\b{re.escape(name)}\b", whole) for name in gone):  # it transmits nothing more
            return None
        try:
            system = self._read(document, self.file)
            found = system.asked(rest)
        except ModelError as error:  # what names it, as a measure of its angle
            why = " | ".join(problem.message for problem in error.problems)
            told = Message("without {names} the model cannot be read: {why}", names=", ".join(gone), why=why)
            raise InputError(told) from error
        told = Message("{names} is cut as the motion begins: the model is taken without it", names=", ".join(gone))
        system = replace(system, assumptions=(*system.assumptions, told))
        asked = tuple(replace(q, understood=f"{q.understood or q.text}, {', '.join(gone)} cut") for q in found)
        return system, asked if len(asked) > 1 else (replace(asked[0], text=text),)

    def to_yaml(self) -> str:
        """The model file, with its comments."""
        return self.document.dumps()


def _plain(value: Any) -> Any:
    """Description objects become `{kind: fields}`, formulas and what is written their text; everything else stays."""
    if isinstance(value, Spec):
        return {value.kind: value.model_dump(exclude_defaults=True, by_alias=True)}
    if isinstance(value, Mapping):
        return {str(as_text(k)): _plain(v) for k, v in cast("Mapping[Any, Any]", value).items()}
    if isinstance(value, (list, tuple)):
        return [_plain(v) for v in cast("Sequence[Any]", value)]
    return as_text(value)


def _has_unit(given: Any) -> bool:
    """Whether the model says the unit beside the value: {value: 2, unit: m}."""
    return isinstance(given, dict) and "unit" in given


def _is_bare(value: str) -> bool:
    """Whether a text is a number without a unit, which stands for nothing but a number."""
    try:
        return float(value) != 0.0
    except ValueError:
        return False
