"""What is said about motions: what is seen and measured along one, what is drawn over it, what hangs on a number."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from freebody.studio.wire.said import LONGEST_TEXT, UNTIL, Said
from freebody.studio.wire.texts import Request

Overlay = Literal["velocity", "acceleration", "reaction", "load", "friction-cones", "mass-centres", "instant-centres"]


class MotionRequest(Request):
    """Follow the motion to the time `until` [s]. is_passing: for a picture that soon gives way to the next, as while
    a slider is moved, so that it needs no more accuracy than can be seen"""

    until: float = Field(gt=0, le=1e4)
    frames: int = Field(default=301, ge=2, le=3001)
    is_passing: bool = False


class StartRequest(Request):
    """Say where bodies start, for a picture that is there already. like: the text of the motion that it shows;
    is_passing: as of a motion"""

    like: str = Field(max_length=LONGEST_TEXT)
    is_passing: bool = True


class StartAnswer(Said):
    """columns: of the player at the start, one number each; nothing where the picture is another one"""

    columns: list[float] | None


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


class Happening(Said):
    """An event of a motion at a time [s]."""

    time: float
    name: str


class Line(Said):
    """One curve, over the times of a motion or the cases of a sweep. math: its symbol in MathML, where it has one"""

    name: str
    label: str
    math: str = ""
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
