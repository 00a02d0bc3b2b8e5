"""Events of contacts and friction as messages: what the change from one mode to the next is called."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.numeric.contact.after import After, ImpactRecord
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.rows import FrictionRow, ModeOf, UnilateralRow
from freebody.numeric.engine.course import Event
from freebody.tolerances import ROUND_OFF


def events_between(bounded: Bounded, before: ModeOf | None, after: After, t: float) -> Iterator[Event]:
    """What happened at an instant: how the mode changed, and collisions that did not change it."""
    mode = after.mode
    if mode is None:
        return
    if after.jammed is not None:
        first, second = bounded.barriers[after.jammed].words
        yield Event(t, Message("{a} jams on {b}" if second else "{a} jams", a=first, b=second), "jams")
    was = frozenset[int]() if before is None else before.closed
    hit = {k for impact in after.impacts for k in _hit(impact)}
    for k, barrier in enumerate(bounded.barriers):
        if k in after.handed or k in bounded.ends.by_edge or (k in after.tipping and k not in hit):
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
    for k in sorted(after.tipping):
        yield Event(t, *_tips(bounded.barriers[k]))
    for k, drag in enumerate(bounded.drags):
        old, new = before.drags[k], mode.drags[k]
        if old == new or old is None or new is None:
            continue
        yield Event(t, *_slips(drag, old, new))


def _hit(impact: ImpactRecord) -> Iterator[int]:
    """The barriers that were approached by more than round-off: what rests is no more than left."""
    least = ROUND_OFF * max((abs(rate) for rate in impact.before.values()), default=0.0)
    return (k for k, rate in impact.before.items() if rate < -least)


def event_names(bounded: Bounded) -> list[str]:
    """What the events of contacts and friction may be called."""
    found: list[str] = []
    for barrier in bounded.barriers:
        a, b = barrier.words
        found += [_opens(barrier)[0], _closes(barrier)[0], _rebounds(barrier)[0], _rest(barrier)[0]]
        found.append(Message("{a} jams on {b}" if b else "{a} jams", a=a, b=b))
    found += [_tips(bounded.barriers[k])[0] for k in bounded.ends.by_flat]
    for drag in bounded.drags:
        found += [_slips(drag, old, new)[0] for old, new in ((0, 1), (1, 0), (1, -1))]
    return list(dict.fromkeys(found))


def _tips(row: UnilateralRow) -> tuple[str, str]:
    a, b = row.words
    return Message("{body} tips about its rim on {other}", body=a, other=b), "tips"


def _closes(row: UnilateralRow) -> tuple[str, str]:
    a, b = row.words
    if row.kind == "string":
        return Message("{contact} goes taut", contact=a), "goes taut"
    if row.kind == "stop":
        return Message("{stop} reaches its {end}", stop=a, end=b), "touches"
    return Message("{a} touches {b}" if b else "{a} touches", a=a, b=b), "touches"


def _opens(row: UnilateralRow) -> tuple[str, str]:
    a, b = row.words
    if row.kind == "string":
        return Message("{contact} goes slack", contact=a), "goes slack"
    if row.kind == "stop":
        return Message("{stop} leaves its {end}", stop=a, end=b), "parts"
    return Message("{a} leaves {b}" if b else "{a} leaves", a=a, b=b), "parts"


def _rebounds(row: UnilateralRow) -> tuple[str, str]:
    a, b = row.words
    if row.kind == "string":
        return Message("{string} jerks", string=a), "rebounds"
    if row.kind == "stop":
        return Message("{stop} hits its {end}", stop=a, end=b), "rebounds"
    return Message("{a} hits {b}" if b else "{a} hits", a=a, b=b), "rebounds"


def _rest(row: UnilateralRow) -> tuple[str, str]:
    a, b = row.words
    on = b if row.kind == "contact" else ""
    return Message("{a} comes to rest on {b}" if on else "{a} comes to rest", a=a, b=on), "comes to rest"


def _slips(d: FrictionRow, old: int, new: int) -> tuple[str, str]:
    turns = d.rub.resists_rolling
    if d.rub.is_tipping:
        what = Message("stands again" if new == 0 else "starts to tip")
    elif d.rub.resists_spinning:
        what = Message("stops spinning" if new == 0 else "starts to spin" if old == 0 else "spins back")
    elif new == 0:
        what = Message("stops rolling" if turns else "stops slipping")
    elif old == 0:
        what = Message("starts to roll" if turns else "starts to slip")
    else:
        what = Message("rolls back" if turns else "slips back")
    a, b = d.words
    return Message("{body} {what} on {other}" if b else "{body} {what}", body=a, what=what, other=b), what
