"""What a blow or an impact does to a quantity: its values just after and just before, and whether they are the same."""

from __future__ import annotations

from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.questions.course import Transition
from freebody.questions.reading import Question
from freebody.questions.vectors import place as place_of
from freebody.study.answering.answer import Answer, Value, made, of_all
from freebody.study.setup import Setup
from freebody.symbolic.on_the_way import MOVING
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.system import System


def before_start(system: System) -> System:
    """The system just before the blow of its start. A blow takes no time and changes no place: bodies whose places the
    file leaves to what closes are where that joins them."""
    rows = tuple(row for row in system.constraint_rows if not row.closes)
    unstruck = replace(system, constraint_rows=rows, impulses=())
    held = {name for row in rows for name in (*row.ends, *row.measure.bodies())}
    loose = [b for b in system.moving if b.start.at is None and b.name not in held]
    closing = {name for row in system.constraint_rows if row.closes for name in (*row.ends, *row.measure.bodies())}
    loose = [b for b in loose if b.name in closing]
    if not loose:
        return unstruck
    struck = Setup(system, 1)
    state, f = struck.start_instant, struck.model.field
    bodies = dict(system.bodies)
    for b in loose:
        point = b.point(b.default_point)
        place = [f.lowest_terms(x) for x in place_of(system, state, point)]
        turns = b.turns and b.start.angle is None and not system.space
        if turns:
            place.append(f.lowest_terms(state.value(Angle(b.name))))
        if any(f.generators[g].kind in MOVING for x in place for g in f.ingredients(x)):
            raise CannotAnswer(Message("where {body} is before the blow is not told: give it at", body=b.name))
        *at, angle = [f.expression(x) for x in place] if turns else [*map(f.expression, place), b.start.angle]
        start = replace(b.start, at=(b.default_point, tuple(e for e in at if e is not None)), angle=angle)
        bodies[b.name] = replace(b, start=start)
    return replace(unstruck, bodies=bodies)


def sides_of(question: Question) -> tuple[Question, Question]:
    """The quantity asked for just before the blow, and just after it."""
    jump = question.quantity.jump
    assert jump is not None
    of, struck = jump
    before, after = (
        replace(
            question,
            id=f"{question.id} {side}",
            quantity=of,
            options={},
            key=None,
            transition=Transition(side, struck, f"just {side} the blow"),
        )
        for side in ("before", "after")
    )
    return before, after


def jump_of(system: System, question: Question, before: Answer, after: Answer) -> Answer:
    """The change, and the verdict whether there is none. Raises CannotAnswer where one of the sides has no formula, or
    several."""
    for side in (before, after):
        if side.expression is None:
            raise CannotAnswer(side.reason or Message("there is no closed form"))
        if side.cases:
            raise CannotAnswer(Message("it depends on the case: ask for it before the impact and after it"))
    model = Setup(system, 1).model
    changes = tuple(
        model.field.lowest_terms(model.geometry.scalar(b) - model.geometry.scalar(a))
        for a, b in zip(_parts(before), _parts(after), strict=True)
    )
    is_kept = all(change.is_zero() for change in changes)
    verdict = Message("conserved in the blow") if is_kept else Message("not conserved in the blow")
    shown: tuple[Ratio, ...] = changes
    conditions = dict.fromkeys(c for side in (before, after) for c in side.conditions)
    return made(
        question,
        tidy(shown[0]) if len(shown) == 1 else tuple(map(tidy, shown)),
        _change(before.value, after.value, is_kept=is_kept),
        conditions=(verdict, *conditions),
        notes=(Message("this is its change: its value just after the blow less that just before"),),
        evidence=of_all((before.evidence, after.evidence)),
    )


def _parts(answer: Answer) -> tuple[Expr, ...]:
    e = answer.expression
    assert e is not None
    return e if isinstance(e, tuple) else (e,)


def _change(before: Value, after: Value, *, is_kept: bool) -> Value:
    if before is None or after is None:
        return None
    if isinstance(before, tuple) and isinstance(after, tuple):
        return tuple(0.0 if is_kept else b - a for a, b in zip(before, after, strict=True))
    assert not isinstance(before, tuple)
    assert not isinstance(after, tuple)
    return 0.0 if is_kept else after - before
