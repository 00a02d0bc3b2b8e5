"""What is said about answers: pictures, studies, exercises, and files made of them."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from freebody.studio.wire.around import Reply
from freebody.studio.wire.motions import MotionRequest
from freebody.studio.wire.said import Said
from freebody.studio.wire.texts import Request


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
    options: dict[str, str | bool | int | list[str]] = Field(default={})
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
    """The motion as a file: a page that plays without a server, moving pictures, or all that is measured along it."""

    format: Literal["html", "gif", "mp4", "csv", "nc", "parquet"] = "html"


class ShareRequest(MotionRequest):
    """The page of the studio with all its answers in it, as one file. name: of the model file; vary: what sliders move,
    as "L=0.5..2 m:9\""""

    name: str = Field(default="model.yaml", max_length=200)
    vary: list[str] = Field(default=[], max_length=4)


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
