"""Whether a measure stays as it is at the start: its rate is zero there, its acceleration is to be, and nothing changes
that later on.

With every acceleration of the coordinates zero at the start, and none of them depending on what moves then, all goes on
with the velocities of the start: q = q_0 + u_0 t solves the equations of motion, and nothing else does.
Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed., sec. 3.3 (circular orbits) and 8.3 (cyclic
coordinates).
"""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.questions.motion import Staying
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


def check_stays(setup: Setup, q: Staying) -> str:
    """Raises CannotAnswer where a measure need not stay as it is although its acceleration at the start is zero; else
    says what moves on evenly."""
    model, f, start = setup.model, setup.model.field, setup.start
    rate = f.lowest_terms(setup.start_instant.rate(q.measure))
    if not rate.is_zero():
        shown = to_text(tidy(rate))
        raise CannotAnswer(
            Message("{name} changes from the start on: its rate is {rate} there", name=q.name, rate=shown)
        )
    moving = [c for c in (*model.coordinates, *model.dependent) if not start.of(c.speed).is_zero()]
    wanted = f.lowest_terms(setup.start_instant.acceleration(q.measure))
    for a in model.accelerations:
        x = model.dynamics.solved_accelerations[a]
        inside = f.ingredients(x)
        changes = [c.name for c in moving if c.index in inside]
        changes += ["t"] if any(f.generators[g].kind == "time" for g in inside) else []
        if changes:
            names = ", ".join(changes)
            raise CannotAnswer(Message("the accelerations depend on {names}, which changes", names=names))
        if not _vanishes_with(f.lowest_terms(setup.start_instant.here(x)), wanted):
            raise CannotAnswer(
                Message("where the acceleration of {name} is zero at the start it may change later", name=q.name)
            )
    if not moving:
        return Message("then nothing moves")
    names = ", ".join(c.name for c in moving)
    return Message(
        "then all rates stay as they are at the start: no acceleration of a coordinate depends on {names}", names=names
    )


def _vanishes_with(x: Ratio, wanted: Ratio) -> bool:
    """Whether an element is zero wherever another one is."""
    if x.is_zero():
        return True
    if wanted.is_zero():
        return False
    f = x.field
    ratio = f.lowest_terms(x / wanted)
    below = {base.key() for base, _e in f.factor(ratio.denominator().num)[1]}
    return not below & {base.key() for base, _e in f.factor(wanted.num)[1]}
