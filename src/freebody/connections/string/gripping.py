"""On which wheels a string does not slip: those that can turn, or those that a model names."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from freebody.connections.string.laying import StringRun
from freebody.language.expression import free_symbols
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.geometry import GROUND, ZERO

if TYPE_CHECKING:
    from freebody.model.names import Names


def wheels_that_turn(names: Names, run: StringRun) -> set[str]:
    """The wheels between its ends that nothing fixes."""
    wheels = {node.body for node in run.way[1:-1] if node.radius != ZERO}
    wheels = {p for p in wheels if names.known(p).turns and not names.known(p).fixed}
    return wheels & {node.body for node in run.way if node.turned}


def named_grips(names: Names, run: StringRun, given: Sequence[str]) -> set[str]:
    """The wheels that the model names; problems are noted where the string cannot grip them."""
    wheels = wheels_that_turn(names, run)
    for k, name in enumerate(given):
        if name not in wheels:
            body = names.body(name, "grips", k)
            if body.fixed:
                told = Message("{name} is fixed and cannot turn, so the string cannot grip it", name=name)
                names.problem(told, "grips", k)
            elif body.name == name and body.radius != ZERO:  # else its radius is what is wrong
                told = Message("the string does not run over {name}, so it cannot grip it", name=name)
                names.problem(told, "grips", k)
    return set(given) & wheels


def gripped_when_stretched(names: Names, run: StringRun, given: Sequence[str] | None) -> set[str]:
    """The wheels on which a string that stretches does not slip. One without inertia, which nothing else turns, would
    be turned by nothing that has a law: a problem is noted."""
    if given is not None:
        return named_grips(names, run, given)
    free = {p for p in wheels_that_turn(names, run) if not is_kept_from_turning(names, p)}
    for name in sorted(p for p in free if names.known(p).inertia == ZERO):
        others = [c for c in names.connections.values() if name in c.mentions(names)]
        if all(c.lets_turn or c.keeps_flat(names) for c in others):
            told = Message(
                "{wheel} has no inertia, so nothing says how it turns under a string that stretches: give it a mass, "
                "or hold it to what carries it, weld: [ground.A, {wheel}], and the string slides round it",
                wheel=name,
            )
            names.problem(told, "over")
    return free


def is_kept_from_turning(names: Names, body: str) -> bool:
    """Whether a connection holds the angle of a body to what does not turn: over such a peg a string slides."""
    with names.quietly():
        for other in names.connections.values():
            if other.lets_hang or body not in other.mentions(names):
                continue
            for row in other.rows(names):
                angle, is_still = row.measure, row.target is None or not free_symbols(row.target)
                if isinstance(angle, Combination) and len(angle.terms) == 1:
                    angle = angle.terms[0][1]
                if not is_still or row.closes or not isinstance(angle, Angle):
                    continue
                turning = set(angle.bodies())
                if body in turning and all(names.known(name).fixed for name in turning - {body, GROUND}):
                    return True
    return False
