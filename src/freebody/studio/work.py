"""The table of what a worker does: by the name of a request its schema, its function, and the lane that it is done in.
Some lanes answer at once, one takes its time; nobody waits for another lane, and what is drawn goes before what is
studied, from the start of the processes on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from pydantic import BaseModel, ValidationError

from freebody.errors import BrokenInstallation, FreebodyError
from freebody.studio import wire
from freebody.studio.telling import told


@dataclass(frozen=True)
class Lane:
    """Work that shares a process. seconds: that one piece of it may take. courtesy: how far it lets other processes go
    first, as `os.nice` counts"""

    name: str
    seconds: float
    courtesy: int = 0


READING, MOVING, COUNTING, MARKING, STUDYING = (
    Lane("reading", 60),
    Lane("moving", 90),
    Lane("counting", 90, courtesy=5),
    Lane("marking", 120, courtesy=15),
    Lane("studying", 600, courtesy=10),
)


@dataclass(frozen=True)
class Work:
    """One kind of request. home: of its function"""

    request: type[wire.Request]
    home: str
    function: str
    lane: Lane

    @property
    def answers(self) -> str:
        """The name of what it answers with."""
        function = getattr(import_module(f"freebody.studio.{self.home}"), self.function)
        return str(function.__annotations__["return"])

    def run(self, request: wire.Request) -> BaseModel:
        function: Callable[[Any], BaseModel] = getattr(import_module(f"freebody.studio.{self.home}"), self.function)
        return function(request)


WORK: dict[str, Work] = {
    "read": Work(wire.ReadRequest, "reading", "read", READING),
    "edit": Work(wire.EditRequest, "editing", "edit", READING),
    "rename": Work(wire.RenameRequest, "renaming", "rename", READING),
    "add": Work(wire.AddRequest, "editing", "add", READING),
    "drag": Work(wire.DragRequest, "dragging", "drag", READING),
    "spots": Work(wire.Request, "joining", "spots", READING),
    "join": Work(wire.JoinRequest, "joining", "join", READING),
    "suggest": Work(wire.SuggestRequest, "editing", "suggest", READING),
    "motion": Work(wire.MotionRequest, "moving", "motion", MOVING),
    "curves": Work(wire.MotionRequest, "moving", "curved", MOVING),
    "overlays": Work(wire.OverlaysRequest, "overlays", "overlaid", COUNTING),  # no motion waits for forces
    "learn": Work(wire.LearnRequest, "kinds", "learned", COUNTING),
    "marks": Work(wire.MarksRequest, "marking", "marks", MARKING),
    "changes": Work(wire.MarksRequest, "changing", "changes", MARKING),
    "picture": Work(wire.PictureRequest, "asking", "drawn", COUNTING),
    "judge": Work(wire.JudgeRequest, "quizzing", "judged", STUDYING),
    "posed": Work(wire.PosedRequest, "quizzing", "posed", COUNTING),
    "hints": Work(wire.HintsRequest, "quizzing", "hints", STUDYING),
    "count": Work(wire.StudyRequest, "asking", "studied", COUNTING),
    "study": Work(wire.StudyRequest, "asking", "studied", STUDYING),
    "sweep": Work(wire.SweepRequest, "sweeping", "swept", STUDYING),
    "export": Work(wire.ExportRequest, "asking", "exported", STUDYING),
    "page": Work(wire.PageRequest, "asking", "page_of", STUDYING),
    "share": Work(wire.ShareRequest, "sharing", "share", STUDYING),
}


def prepare(lane: str) -> None:
    """Imports what the work of a lane needs, before the first piece of it comes."""
    for work in WORK.values():
        if work.lane.name == lane:
            import_module(f"freebody.studio.{work.home}")


def done(kind: str, body: dict[str, Any]) -> wire.Reply:
    """The reply to a request: what the user can mend is refused in words; anything else is raised."""
    try:
        request = WORK[kind].request.model_validate(body)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        return wire.Reply(status="refused", message=f"{'.'.join(map(str, first['loc']))}: {first['msg']}")
    try:
        return wire.Reply(status="done", answer=WORK[kind].run(request))
    except (FreebodyError, BrokenInstallation) as error:
        return wire.Reply(status="refused", message=told(str(error), request.language))
    except MemoryError:
        return wire.Reply(status="crashed", message=told("there is not enough memory for this", request.language))
