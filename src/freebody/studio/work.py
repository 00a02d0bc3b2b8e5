"""The table of what a worker does: by the name of a request its schema, its function, and the lane that it is done in.
Some lanes answer at once, one takes its time; nobody waits for another lane, and what is drawn goes before what is
studied, from the start of the processes on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any

from pydantic import BaseModel, ValidationError

from freebody.errors import BrokenInstallation, FreebodyError
from freebody.studio.telling import told
from freebody.studio.wire.around import Reply

if TYPE_CHECKING:
    from freebody.studio.wire.texts import Request


@dataclass(frozen=True)
class Lane:
    """Work that shares a process. seconds: that one piece of it may take. courtesy: how far it lets other processes go
    first, as `os.nice` counts; is_ready: its process is there before the first request for it"""

    name: str
    seconds: float
    courtesy: int = 0
    is_ready: bool = True


READING, MOVING, PASSING, COUNTING, MARKING, STUDYING, EXPORTING = (
    Lane("reading", 60),
    Lane("moving", 90),
    Lane("passing", 90),  # motions while a hand moves something: they wait for no accurate one
    Lane("counting", 90, courtesy=5),
    Lane("marking", 120, courtesy=15),
    Lane("studying", 600, courtesy=10),
    Lane("exporting", 600, courtesy=10, is_ready=False),  # no answer waits for a file that takes its time
)


@dataclass(frozen=True)
class Work:
    """One kind of request. schema: what it says, in a room of `wire`, which the server need not know; home: of its
    function"""

    schema: str
    home: str
    function: str
    lane: Lane

    @property
    def request(self) -> type[Request]:
        room, name = self.schema.split(".")
        request: type[Request] = getattr(import_module(f"freebody.studio.wire.{room}"), name)
        return request

    @property
    def answers(self) -> str:
        """The name of what it answers with."""
        function = getattr(import_module(f"freebody.studio.{self.home}"), self.function)
        return str(function.__annotations__["return"])

    def run(self, request: Request) -> BaseModel:
        function: Callable[[Any], BaseModel] = getattr(import_module(f"freebody.studio.{self.home}"), self.function)
        return function(request)


WORK: dict[str, Work] = {
    "read": Work("texts.ReadRequest", "reading", "read", READING),
    "edit": Work("texts.EditRequest", "editing", "edit", READING),
    "rename": Work("texts.RenameRequest", "renaming", "rename", READING),
    "add": Work("texts.AddRequest", "editing", "add", READING),
    "drag": Work("texts.DragRequest", "dragging", "drag", READING),
    "spots": Work("texts.Request", "joining", "spots", READING),
    "join": Work("texts.JoinRequest", "joining", "join", READING),
    "suggest": Work("texts.SuggestRequest", "editing", "suggest", READING),
    "motion": Work("motions.MotionRequest", "moving", "motion", MOVING),
    "start": Work("motions.StartRequest", "moving", "started", MOVING),
    "curves": Work("motions.MotionRequest", "moving", "curved", MOVING),
    "overlays": Work("motions.OverlaysRequest", "overlays", "overlaid", COUNTING),  # no motion waits for forces
    "learn": Work("texts.LearnRequest", "kinds", "learned", COUNTING),
    "marks": Work("motions.MarksRequest", "marking", "marks", MARKING),
    "changes": Work("motions.MarksRequest", "changing", "changes", MARKING),
    "picture": Work("studies.PictureRequest", "asking", "drawn", COUNTING),
    "judge": Work("studies.JudgeRequest", "quizzing", "judged", STUDYING),
    "posed": Work("studies.PosedRequest", "quizzing", "posed", COUNTING),
    "hints": Work("studies.HintsRequest", "quizzing", "hints", STUDYING),
    "count": Work("studies.StudyRequest", "asking", "studied", COUNTING),
    "study": Work("studies.StudyRequest", "asking", "studied", STUDYING),
    "sweep": Work("motions.SweepRequest", "sweeping", "swept", STUDYING),
    "export": Work("studies.ExportRequest", "asking", "exported", EXPORTING),
    "page": Work("studies.PageRequest", "asking", "motion_file", EXPORTING),
    "share": Work("studies.ShareRequest", "sharing", "share", EXPORTING),
}


def prepare(lane: str) -> None:
    """Imports what the work of a lane needs, before the first piece of it comes."""
    for work in WORK.values():
        if work.lane.name == lane:
            import_module(f"freebody.studio.{work.home}")


def done(kind: str, body: dict[str, Any]) -> Reply:
    """The reply to a request: what the user can mend is refused in words; anything else is raised."""
    try:
        request = WORK[kind].request.model_validate(body)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        return Reply(status="refused", message=f"{'.'.join(map(str, first['loc']))}: {first['msg']}")
    try:
        return Reply(status="done", answer=WORK[kind].run(request))
    except (FreebodyError, BrokenInstallation) as error:
        return Reply(status="refused", message=told(str(error), request.language))
    except MemoryError:
        return Reply(status="crashed", message=told("there is not enough memory for this", request.language))
