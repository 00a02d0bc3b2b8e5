"""Why a motion with contacts cannot go on, in the user's names."""

from __future__ import annotations

from freebody.language.sentences import Message, further, in_turn
from freebody.model.elements import UnilateralConstraint
from freebody.numeric.contact.after import HELD_ALONE, After
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.problem import OutcomeCount
from freebody.numeric.contact.rows import ModeOf

ADVICE = Message("use time stepping (method moreau, with a step), which does not follow single events")


def advised(bounded: Bounded, trouble: Message) -> str:
    """A trouble with single events, and another method where there is one."""
    return trouble if bounded.numbers.system.space else further(trouble, ADVICE)


def contradiction(bounded: Bounded, result: After, t: float) -> str:
    """No mode is consistent with an instant."""
    if result.status is OutcomeCount.NOT_FOUND:
        return advised(
            bounded,
            Message("at t = {t:.9g} s no force was found that is consistent with {what}", t=t, what=result.why),
        )
    if result.why == HELD_ALONE:
        return Message("at t = {t:.9g} s no force is consistent with {what}", t=t, what=result.why)
    return Message(
        "at t = {t:.9g} s no force is consistent with {what}: with so much friction the contact can neither "
        "slide nor hold (Painleve's paradox). A rigid model ends here. Go on with an impulse (option jams), make "
        "the contact compliant with a spring, or lower the friction",
        t=t,
        what=result.why,
    )


def jammed(bounded: Bounded, mode: ModeOf, t: float) -> str:
    """Sliding friction whose forces grow without bound; nothing where none slides that a reaction presses."""
    sliding = [d for d, state in zip(bounded.drags, mode.drags, strict=True) if state and d.loads]
    if not sliding:
        return ""
    return Message(
        "at t = {t:.9g} s the forces of {names} grow without bound: sliding friction jams there (Painleve). A "
        "rigid model ends here. Go on with an impulse (option jams), make the contact compliant with a spring, or "
        "lower the friction",
        t=t,
        names=in_turn([d.name for d in sliding]),
    )


def unresisted_spin(end: UnilateralConstraint, t: float) -> Message:
    """A rough flat end spins, or begins to, and nothing is said of how its pressure is spread."""
    return Message(
        "{end} spins on {face} at t = {t:.9g} s. Friction resists that by how the pressure is spread over the flat "
        "end, which is not known: give the contact a spinning_resistance. Where the pressure is even and the end only "
        "spins it is 2/3 of the coefficient of friction times the radius",
        end=end.row.ends[0],
        face=end.row.ends[1],
        t=t,
    )


def turned_by_friction(end: UnilateralConstraint, t: float) -> Message:
    """A rough flat end slides, and what presses on it is not on the line along which it does."""
    return Message(
        "{end} slides on {face} at t = {t:.9g} s with its pressure beside the line through its middle along which it "
        "slides. There friction turns it about the normal, and how the pressure is spread, on which that depends once "
        "it turns, is not known",
        end=end.row.ends[0],
        face=end.row.ends[1],
        t=t,
    )
