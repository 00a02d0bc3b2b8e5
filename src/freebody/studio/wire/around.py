"""What is said around the work: calls and replies, and the files of the opened folder."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from freebody.studio.wire.said import LONGEST_TEXT, UNTIL, Language, Said


class Reply(Said):
    """What comes back. done: answer is there; refused: the model or the question is at fault; else the work was not
    finished: replaced by a later request, cancelled, out of time or memory, or the worker ended. later: it takes its
    time, and comes under the number in the message"""

    status: Literal["done", "refused", "replaced", "cancelled", "too long", "crashed", "later"]
    message: str = ""
    answer: Any = None


class Call(Said):
    """What the page posts. topic: a later request of the same topic takes the place of an earlier one; each window has
    its own; number: which of a window's requests it is, so that what is left before it is asked is not this one"""

    kind: str
    topic: str = Field(pattern=r"^[a-z-]{1,40}(\.[a-z0-9]{0,20})?$")
    request: dict[str, Any]
    number: int = 0


class Example(Said):
    """A bundled model. name: of its file"""

    name: str
    title: str
    text: str
    is_template: bool


class OpenedFile(Said):
    """A file of the opened folder. version: changes with its content, empty for one that is not there yet"""

    name: str
    text: str
    version: str


class Opening(Said):
    """What the page begins with. is_file: whether a file was named; until: to which time [s] a motion is followed
    unless somebody chooses; has_ffmpeg: whether videos can be coded here"""

    file: OpenedFile
    files: list[str]
    is_file: bool
    version: str
    until: float = UNTIL
    has_ffmpeg: bool = False


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
