"""What the page and the server say to each other. `tools/write_studio_types.py` writes the same for the page.

Places in a text count as a browser does: UTF-16 units from 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field

LONGEST_TEXT = 1_000_000
UNTIL = 3.0  # [s]
Language = Literal["en", "de"]
Overlay = Literal["velocity", "acceleration", "reaction", "load", "friction-cones", "mass-centres", "instant-centres"]


class Said(BaseModel):
    """A message. Nothing in it is guessed: unknown fields are refused."""

    model_config = ConfigDict(extra="forbid", defer_build=True)  # many are never said


# -- from the page ----------------------------------------------------------------------------
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


class MotionRequest(Request):
    """Follow the motion to the time `until` [s]. is_passing: for a picture that soon gives way to the next, as while
    a slider is moved, so that it needs no more accuracy than can be seen"""

    until: float = Field(gt=0, le=1e4)
    frames: int = Field(default=301, ge=2, le=3001)
    is_passing: bool = False


class OverlaysRequest(MotionRequest):
    """Say what is drawn over that motion."""

    show: list[Overlay] = Field(min_length=1, max_length=8)


class Range(Said):
    """Between which numbers, in which unit, a slider moves a parameter."""

    name: str = Field(max_length=200)
    low: float
    high: float
    unit: str = Field(max_length=60)


class MarksRequest(Request):
    """Say where something changes along sliders. until: the time [s] within which motions are looked at"""

    ranges: list[Range] = Field(max_length=200)
    until: float = Field(default=UNTIL, gt=0, le=1e4)


class SweepRequest(Request):
    """Vary one name from `low` to `high`, quantities as in a file, in n cases. find: a question, by its id or in words;
    record: of the motion to the time `until` [s], as "maximum of theta"; one of both"""

    name: str = Field(max_length=200)
    low: str = Field(min_length=1, max_length=60)
    high: str = Field(min_length=1, max_length=60)
    n: int = Field(ge=2, le=1001)
    find: str = Field(default="", max_length=400)
    record: str = Field(default="", max_length=400)
    until: float = Field(default=UNTIL, gt=0, le=1e4)


class PictureRequest(Request):
    """Draw the model, or bodies of it cut free."""

    free: list[str] = Field(default=[], max_length=200)
    at: float | None = None
    show: list[str] = Field(default=[], max_length=8)
    dark: bool | None = None
    format: Literal["svg", "png", "pdf", "tex"] = "svg"


class StudyRequest(Request):
    """Do one of the table of studies. options: as words of the command line, by the name of the parameter; prefix: of
    the names in the HTML."""

    name: str = Field(max_length=40)
    options: dict[str, str | bool | int | list[str]] = {}
    prefix: str = Field(default="", pattern="^[a-z-]{0,20}$")


class JudgeRequest(Request):
    """Judge what somebody answers to a question, or the forces that are said to act on bodies cut free. prefix: of the
    names in the HTML"""

    question: str = Field(default="", max_length=400)
    free: list[str] = Field(default=[], max_length=200)
    answer: str = Field(max_length=4000)
    prefix: str = Field(default="", pattern="^[a-z-]{0,20}$")


class HintsRequest(Request):
    """Hints to a question of the file. question: its id"""

    question: str = Field(max_length=400)


class PosedRequest(HintsRequest):
    """How a question of the file is asked. prefix: of the names in the HTML"""

    prefix: str = Field(default="", pattern="^[a-z-]{0,20}$")


class ExportRequest(StudyRequest):
    """The same as files."""

    format: Literal["html", "md", "tex", "pdf", "ipynb", "txt", "json"] = "html"


class PageRequest(MotionRequest):
    """The motion as one HTML file that plays without a server."""


class ShareRequest(MotionRequest):
    """The page of the studio with all its answers in it, as one file. name: of the model file; vary: what sliders move,
    as "L=0.5..2 m:9\""""

    name: str = Field(default="model.yaml", max_length=200)
    vary: list[str] = Field(default=[], max_length=4)


# -- to the page ------------------------------------------------------------------------------
class Reply(Said):
    """What comes back. done: answer is there; refused: the model or the question is at fault; else the work was not
    finished: replaced by a later request, cancelled, out of time or memory, or the worker ended"""

    status: Literal["done", "refused", "replaced", "cancelled", "too long", "crashed"]
    message: str = ""
    answer: Any = None


class Span(Said):
    """Where something stands in the text."""

    start: int
    end: int


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
    """A number that can be moved: a parameter, or a value of the start. text: as it stands in the file, with its
    unit"""

    name: str
    section: Literal["parameters", "start"]
    text: str
    span: Span
    is_positive: bool


class Asked(Said):
    """A question of the file."""

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


class SuggestAnswer(Said):
    """understood: the question in the words of the grammar, empty if it cannot be read; then why: message"""

    understood: str
    message: str
    suggestions: list[str]


class Happening(Said):
    """An event of a motion at a time [s]."""

    time: float
    name: str


class Line(Said):
    """One curve, over the times of a motion or the cases of a sweep."""

    name: str
    label: str
    unit: str
    values: list[float | None]


class MotionAnswer(Said):
    """player: what `player.js` draws; start, end: of what could be followed [s]; is_complete: whether that is all of
    the time, else message says why"""

    player: dict[str, Any]
    start: float
    end: float
    events: list[Happening]
    is_complete: bool
    message: str


class CurvesAnswer(Said):
    """What is measured along a motion. recordable: the names of those lines of which a sweep records a value;
    energy_error: relative"""

    times: list[float]
    lines: list[Line]
    recordable: list[str]
    energy_error: float | None


class Drawn(Said):
    """Something that moves over the scene. body: along whose axes its place is given, from its mass centre; empty for
    the ground; times: [s]; at: for each of three axes one number a time, or one for all; nothing where it is not"""

    kind: str
    label: str
    body: str
    times: list[float]
    at: list[list[float | None]]


class Arrow(Drawn):
    """vector: along the axes of the ground; of a couple its moment. owner: the connection or load; of: the row or push,
    as pictures mark it"""

    vector: list[list[float | None]]
    is_couple: bool
    owner: str
    of: str


class Cone(Drawn):
    """Within which dry friction holds. axis: of the normal force; half: angle to its sides [rad]; used: to the
    resultant"""

    axis: list[list[float | None]]
    half: float
    used: list[float | None]


class Scale(Said):
    """How long arrows of a kind are drawn. largest: along the motion; by_root: whether as the root of the size"""

    largest: float
    by_root: bool


class OverlaysAnswer(Said):
    """scales: by kind; messages: why something is not there"""

    arrows: list[Arrow]
    spots: list[Drawn]
    cones: list[Cone]
    scales: dict[str, Scale]
    messages: list[str]


class Mark(Said):
    """A number, in the unit of the slider of a parameter, at which some conditions change their truth. words: theirs"""

    name: str
    at: float
    words: list[str]


class MarksAnswer(Said):
    marks: list[Mark]


class Missing(Said):
    """Cases of a sweep without a number: how many of a status, at which value the first of them is, and why."""

    status: str
    count: int
    first: float
    why: str


class SweepAnswer(Said):
    """What comes of a name at each of its values, in its unit. about: what was looked at; statuses: of each case in
    words"""

    name: str
    unit: str
    values: list[float]
    about: str
    lines: list[Line]
    statuses: list[str]
    missing: list[Missing]


class Slider(Said):
    """A name whose motions were found beforehand. values: as they are written; own: the place of the file's value among
    them"""

    name: str
    values: list[str]
    own: int


class Valued(Said):
    """A question of the file in all places of the sliders. values: numbers with units, or why there is none"""

    id: str
    text: str
    values: list[str]


class Moved(Said):
    """The motions of all values of some sliders, the last of which runs fastest. replies: of `player` what differs
    from that of the file's values; curves: of each; answers: to the questions of the file"""

    sliders: list[Slider]
    replies: list[Reply]
    curves: list[Reply]
    answers: list[Valued]


class Meaning(Said):
    """What a symbol speaks of. symbol: as it is shown, without its subscripts' places; owner: a connection or load, or
    nothing; forces: what acts, as pictures mark it"""

    symbol: str
    bodies: list[str]
    owner: str
    forces: list[str]


class PictureAnswer(Said):
    """content: of the picture, bytes in base64; meanings: of symbols in it, where bodies are cut free"""

    content: str
    meanings: list[Meaning]


class StudyAnswer(Said):
    """html: the report; plain: the same as data; is_complete: whether all that was asked is found; meanings: of symbols
    in it"""

    html: str
    plain: dict[str, Any]
    is_complete: bool
    meanings: list[Meaning]


class JudgeAnswer(Said):
    """html: the verdict; plain: the same as data; is_attempt: whether it counts, as what cannot be read does not"""

    html: str
    plain: dict[str, Any]
    is_right: bool
    is_attempt: bool


class HintsAnswer(Said):
    hints: list[str]


class PosedAnswer(Said):
    """html: a question as an exercise asks it, with its options; options: their letters"""

    html: str
    options: list[str]


class File(Said):
    """A file to be kept. content: in base64"""

    name: str
    content: str


class FilesAnswer(Said):
    files: list[File]


# -- around them ------------------------------------------------------------------------------
class Call(Said):
    """What the page posts. topic: a later request of the same topic takes the place of an earlier one; each window has
    its own"""

    kind: str
    topic: str = Field(pattern=r"^[a-z-]{1,40}(\.[a-z0-9]{0,20})?$")
    request: dict[str, Any]


class Example(Said):
    """A bundled model. name: of its file"""

    name: str
    title: str
    text: str
    is_template: bool


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


class OpenedFile(Said):
    """A file of the opened folder. version: changes with its content, empty for one that is not there yet"""

    name: str
    text: str
    version: str


class Opening(Said):
    """What the page begins with. is_file: whether a file was named; until: to which time [s] a motion is followed
    unless somebody chooses"""

    file: OpenedFile
    files: list[str]
    is_file: bool
    version: str
    until: float = UNTIL


class SaveRequest(Said):
    """Write a file of the folder. version: of what it was opened from; what another program has changed since
    is kept unless this says otherwise"""

    name: str = Field(max_length=200)
    text: str = Field(max_length=LONGEST_TEXT)
    version: str
    overwrite: bool = False
    language: Language = "en"


class SaveAnswer(Said):
    """version: the new one; is_changed: the file has been changed by somebody else, and nothing was written; message:
    why nothing was written, empty if it was"""

    version: str
    is_changed: bool
    message: str
