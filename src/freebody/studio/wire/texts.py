"""What is said about a text: what it means, what is wrong in it, and how it is changed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

from pydantic import Field

from freebody.studio.wire.said import LONGEST_TEXT, Language, Said, Span


class Request(Said):
    """What every request has: the text of the model, and the language of messages."""

    text: str = Field(max_length=LONGEST_TEXT)
    language: Language = "en"


class ReadRequest(Request):
    """Read a model."""


class LearnRequest(Request):
    """Say what can be added and written, whatever the model."""

    text: str = Field(default="", max_length=0)


class EditRequest(Request):
    """Set the value at a path, as the YAML of a scalar; None takes it out."""

    path: list[str | int] = Field(min_length=1, max_length=12)
    value: str | None = Field(max_length=2000)


class RenameRequest(Request):
    """Give what is at a path another name, wherever the text has it."""

    path: list[str | int] = Field(min_length=2, max_length=12)
    name: str = Field(min_length=1, max_length=100)


class AddRequest(Request):
    """Add an element at the end of a section, under its name or the next that is free. value: its YAML in one line"""

    section: str = Field(pattern="^(parameters|bodies|connections|loads|measures|start|questions)$")
    name: str = Field(max_length=100)
    value: str = Field(max_length=2000)


class DragRequest(Request):
    """Bring a point of a body, at the place `grabbed` [m] at the start, as near `to` another place as it goes in a
    picture. across, up: what runs right and up in it, along the axes of the ground; how deep a point lies is free"""

    body: str = Field(max_length=200)
    grabbed: Sequence[float] = Field(min_length=2, max_length=3)
    to: Sequence[float] = Field(min_length=2, max_length=3)
    across: tuple[float, float, float] = (1.0, 0.0, 0.0)
    up: tuple[float, float, float] = (0.0, 1.0, 0.0)


class End(Said):
    """What was pointed at: a spot by its name; without one, a place [m] on the ground."""

    name: str = Field(default="", max_length=200)
    at: tuple[float, float] = (0.0, 0.0)


class JoinRequest(Request):
    """Add an element of a kind between what was pointed at, as many as the kind has ends."""

    section: str = Field(pattern="^(connections|loads)$")
    kind: str = Field(max_length=100)
    ends: list[End] = Field(min_length=1, max_length=4)


class SuggestRequest(Request):
    """What a question that is being typed means, and others that are near."""

    question: str = Field(max_length=400)


class Fix(Said):
    """A change that mends a problem: the text in a span is replaced."""

    label: str
    span: Span
    text: str


class Remark(Said):
    """What is wrong with a text, or unlikely in it. where: the path in words; line: from 1, 0 where it is unknown"""

    severity: Literal["error", "warning"]
    message: str
    where: str
    line: int
    span: Span
    fixes: list[Fix]


class Leaf(Said):
    """A value in the text that can be changed. path: to it; label: the last parts of it; text: as it stands there"""

    path: list[str | int]
    label: str
    text: str
    span: Span


class Element(Said):
    """A named part of the model. kind: what it is, as the file says; name_span: of its name; span: of name and value"""

    section: str
    name: str
    kind: str
    path: list[str | int]
    name_span: Span
    span: Span
    leaves: list[Leaf]


class Parameter(Said):
    """A number that can be moved: a parameter, or a value of the start. symbol: as pictures have it; math: in MathML,
    empty where the name is no symbol; text: as it stands in the file, with its unit"""

    name: str
    symbol: str
    math: str
    section: Literal["parameters", "start"]
    text: str
    span: Span
    is_positive: bool


class Asked(Said):
    """A question of the file. text: in the language of the page where its words are those of the grammar"""

    id: str
    text: str


class ReadAnswer(Said):
    """A text that has been read. is_model: whether it is one; then everything else is known"""

    is_model: bool
    title: str
    about: str
    is_spatial: bool
    remarks: list[Remark]
    elements: list[Element]
    parameters: list[Parameter]
    questions: list[Asked]
    moving: list[str]


class TextAnswer(Said):
    """The changed text."""

    text: str


class JoinAnswer(Said):
    """The changed text, and the path to the new element in it, with its value in one line."""

    text: str
    path: list[str]
    value: str


class Spot(Said):
    """A point, a body or a line that can be pointed at, where it is [m] at the start."""

    name: str
    body: str
    at: tuple[float, float]


class SpotsAnswer(Said):
    spots: list[Spot]


class Suggestion(Said):
    """question: in the words of the grammar, to be asked; said: the same in the language of the page"""

    question: str
    said: str


class SuggestAnswer(Said):
    """understood: how the grammar puts the question, in the language of the page, empty if it cannot be read; then why:
    message"""

    understood: str
    message: str
    suggestions: list[Suggestion]


class Kind(Said):
    """What a section may have. value: of the smallest example, as YAML in one line; about: what it is; ends: the paths
    in its value of what it joins"""

    section: str
    kind: str
    value: str
    about: str
    ends: list[list[str | int]]


class LearnAnswer(Said):
    """What can be added to a model, and the JSON Schema of its text."""

    kinds: list[Kind]
    written: dict[str, Any]
