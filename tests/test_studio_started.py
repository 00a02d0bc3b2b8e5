"""While a slider moves: where the motion starts is told before the motion, and what is kept from one start to the next
changes no digit of either."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import pytest
from tests.example_files import FOLDER
from tests.test_studio_nudged import CHAIN, nudges

from freebody.errors import CannotAnswer
from freebody.language.document import Document
from freebody.studio import moving
from freebody.studio.moving import motion, started
from freebody.studio.reading import look_in
from freebody.studio.wire.motions import MotionAnswer, MotionRequest, StartRequest

SLID = CHAIN.replace("k: N/m, ", "")
SPRING = """
parameters: {m: 1 kg, k: 100 N/m, l: {value: 1 m, sign: any}}
bodies: {a: {body: {mass: m}}}
connections: {A: {slider: {body: a, along: right}}}
loads: {S: {spring: {between: [ground.O, a], stiffness: k, length: l}}}
measures: {x: {x of a}}
start: {x: 1.2 m}
"""
ROLLING = """
parameters: {R: 0.3 m, m: 1 kg}
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: m, radius: R}}}
connections: {it: {rolling: [wheel, floor]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {phi: {angle of wheel}}
start: {phi: 20 deg, rate(phi): -3 rad/s}
"""


@pytest.fixture(autouse=True)
def _nothing_is_kept() -> Iterator[None]:
    forgotten()
    yield
    forgotten()


def forgotten() -> None:
    look_in([str(FOLDER)])
    moving._latest.clear()
    moving._placed.clear()


def asked(text: str) -> MotionRequest:
    return MotionRequest(text=text, until=1, frames=21, is_passing=True)


def one_after_the_other(*texts: str) -> tuple[list[MotionAnswer], list[list[float] | None]]:
    """Motions and their starts, as a worker finds them for a slider that is moved."""
    motions, starts = [motion(asked(texts[0]))], list[list[float] | None]()
    for before, text in pairwise(texts):
        starts.append(started(StartRequest(text=text, like=before)).columns)
        motions.append(motion(asked(text)))
    return motions, starts


def example(name: str, old: str, new: str) -> tuple[str, str]:
    text = (FOLDER / f"{name}.yaml").read_text(encoding="utf-8")
    assert old in text
    return text, text.replace(old, new, 1)


def first_frame(found: MotionAnswer) -> list[float]:
    return [column[0] for column in found.player["columns"]]


CASES = {
    "an angle": (SLID, SLID.replace("-60 deg", "-59 deg"), SLID.replace("-60 deg", "-30 deg")),
    "a rate": (SLID, SLID.replace("2 rad/s", "3 rad/s"), SLID.replace("2 rad/s", "-3 rad/s")),
    "a length": (SLID, SLID.replace("L: 1 m", "L: 2 m")),
    "a mass that nothing drawn hangs on": (
        SLID,
        SLID.replace("m: 1 kg", "m: 3 kg"),
        SLID.replace("m: 1 kg", "m: 5 kg"),
    ),
    "an angle that becomes zero, and is another one again": (
        SLID,
        SLID.replace("-60 deg", "0 deg"),
        SLID.replace("-60 deg", "10 deg"),
    ),
    "a length that becomes zero, and is another one again": (
        SPRING,
        SPRING.replace("value: 1 m", "value: 0 m"),
        SPRING,
    ),
    "a spring that is let go": (SPRING, SPRING.replace("x: 1.2 m", "x: 0.7 m")),
    "what counts from the start": (ROLLING, ROLLING.replace("20 deg", "80 deg"), ROLLING.replace("-3 rad", "5 rad")),
    "from one branch to the other": example("four_bar", "60 deg", "100 deg"),
}


def slid(*texts: str) -> None:
    found, starts = one_after_the_other(*texts)
    for text, each in zip(texts, found, strict=True):
        forgotten()
        assert each == motion(asked(text))  # read, assembled and packed as a whole, to the last digit
    for each, start in zip(found[1:], starts, strict=True):
        assert start is None or start == first_frame(each)


@pytest.mark.parametrize("texts", CASES.values(), ids=CASES)
def test_what_is_kept_changes_no_digit(texts: tuple[str, ...]) -> None:
    slid(*texts)


@pytest.mark.parametrize(
    ("texts", "is_told"),
    [
        (CASES["an angle"], True),
        (CASES["a mass that nothing drawn hangs on"], True),
        (CASES["a length"], False),  # other lines are drawn
        (CASES["what counts from the start"], True),
    ],
)
def test_a_start_is_told_where_the_same_lines_are_drawn(texts: tuple[str, ...], is_told: bool) -> None:
    _motions, starts = one_after_the_other(*texts)
    assert all((start is not None) == is_told for start in starts)


def test_a_start_is_told_of_no_other_picture_than_is_shown() -> None:
    motion(asked(SLID))
    other = SLID.replace("-60 deg", "-59 deg")
    assert started(StartRequest(text=other, like=other)).columns is None


def test_bodies_that_are_drawn_aside_are_shown_with_their_motion() -> None:
    """Where their strings put them hangs on the whole way."""
    text, other = example("atwood_machine", "2 kg", "2.1 kg")
    _motions, (start,) = one_after_the_other(text, other)
    assert start is None


def test_a_start_that_cannot_be_is_refused() -> None:
    motion(asked(SLID))
    impossible = SLID.replace("measures: {", "measures: {gamma: {angle of a}, ").replace(
        "start: {", "start: {gamma: 10 deg, "
    )
    motion(asked(impossible.replace("alpha: -60 deg", "alpha: 10 deg")))
    like = impossible.replace("alpha: -60 deg", "alpha: 10 deg")
    with pytest.raises(CannotAnswer, match="cannot be assembled"):
        started(StartRequest(text=impossible, like=like))


@pytest.mark.parametrize("name", ["four_bar", "bead_on_upright_hoop", "slider_crank", "spinning_top"])
def test_examples_are_slid_along_their_start_as_they_are_found_anew(name: str) -> None:
    text = (FOLDER / f"{name}.yaml").read_text(encoding="utf-8")
    (larger,) = (changed for other, changed in nudges("start") if other == text)
    document = Document.read(text, folders=[FOLDER])
    for key, value in larger.items():
        document = document.with_value(("start", key), value)
    slid(text, document.dumps())
