"""Events of contacts and friction in words."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.numeric.contact.bounded import Bounded, FrictionRow, ModeOf, UnilateralRow
from freebody.numeric.contact.transition import After
from freebody.numeric.engine.course import Event


def events_between(bounded: Bounded, before: ModeOf | None, after: After, t: float) -> Iterator[Event]:
    """What happened at an instant: how the mode changed, and collisions that did not change it."""
    mode = after.mode
    if mode is None:
        return
    if after.jammed is not None:
        yield Event(t, _pair(bounded.barriers[after.jammed].words, "jams on"), "jams")
    was = frozenset[int]() if before is None else before.closed
    hit = {k for impact in after.impacts for k, rate in impact.before.items() if rate < 0.0}
    for k, barrier in enumerate(bounded.barriers):
        if k in after.handed:
            continue
        is_now = k in mode.closed
        if before is None and k not in hit:
            if barrier.is_ideal and not is_now:
                yield Event(t, *_opens(barrier))
            continue  # how it begins is no event, but for what is taken to be closed
        if is_now and k not in was:
            if k in after.resting and k in hit and barrier.restitution > 0.0:
                yield Event(max(t, after.resting[k]), *_rest(barrier))
            else:
                yield Event(t, *_closes(barrier))
        elif k in was and not is_now and k not in hit:
            yield Event(t, *_opens(barrier))
        elif k in hit and not is_now:
            yield Event(t, *_rebounds(barrier))
    if before is None:
        return
    for k, drag in enumerate(bounded.drags):
        old, new = before.drags[k], mode.drags[k]
        if old == new or old is None or new is None:
            continue
        yield Event(t, *_slips(drag, old, new))


def _pair(words: tuple[str, str], verb: str) -> str:
    return f"{words[0]} {verb} {words[1]}".strip()


def _closes(b: UnilateralRow) -> tuple[str, str]:
    if b.kind == "string":
        return f"{b.words[0]} goes taut", "goes taut"
    if b.kind == "stop":
        return f"{b.words[0]} reaches its {b.words[1]}", "touches"
    return _pair(b.words, "touches"), "touches"


def _opens(b: UnilateralRow) -> tuple[str, str]:
    if b.kind == "string":
        return Message("{contact} goes slack", contact=b.words[0]), "goes slack"
    if b.kind == "stop":
        return f"{b.words[0]} leaves its {b.words[1]}", "parts"
    return _pair(b.words, "leaves"), "parts"


def _rebounds(b: UnilateralRow) -> tuple[str, str]:
    if b.kind == "string":
        return f"{b.words[0]} jerks", "rebounds"
    if b.kind == "stop":
        return f"{b.words[0]} hits its {b.words[1]}", "rebounds"
    return _pair(b.words, "hits"), "rebounds"


def _rest(b: UnilateralRow) -> tuple[str, str]:
    if b.kind == "contact":
        return _pair(b.words, "comes to rest on"), "comes to rest"
    return f"{b.words[0]} comes to rest", "comes to rest"


def _slips(d: FrictionRow, old: int, new: int) -> tuple[str, str]:
    on = f" on {d.words[1]}" if d.words[1] else ""
    turns = d.rub.row.reaction == "rolling resistance"
    if new == 0:
        what = "stops rolling" if turns else "stops slipping"
    elif old == 0:
        what = "starts to roll" if turns else "starts to slip"
    else:
        what = "rolls back" if turns else "slips back"
    return f"{d.words[0]} {what}{on}", what
