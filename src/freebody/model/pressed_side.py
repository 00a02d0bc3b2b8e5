"""The side on which something is pressed: of teeth the flank that bears, of a chain the run that is tight. The force
along the centres, which parts gears and pulls the shafts of a chain, keeps its sense on either; so a row states one."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.sentences import Message
from freebody.measures.base import Measure


@dataclass(frozen=True)
class Flank:
    """sign: of the reaction with which a row pushes as it does; other: the measure that it holds on the other side."""

    sign: int
    other: Measure

    def is_kept(self, connection: str) -> Message:
        """That it is this side which is pressed, as the purpose of a condition."""
        return Message("the teeth of {mesh} bear on this flank; for the other one write other_flank", mesh=connection)

    def is_left(self, connection: str, time: float, *, is_followed: bool) -> Message:
        """That from a time [s] on it is the other one; is_followed: and that all forces are those of that side."""
        if is_followed:
            return Message("from {t:.4g} s {mesh} bears on its other flank", t=time, mesh=connection)
        return Message(
            "from {t:.4g} s {mesh} bears on its other flank: there its radial force is reversed",
            t=time,
            mesh=connection,
        )


@dataclass(frozen=True)
class TightRun(Flank):
    """The one of the two runs of a chain that is tight."""

    def is_kept(self, connection: str) -> Message:
        return Message(
            "the run of {chain} that is taken to be tight is so; for the other one write other_run", chain=connection
        )

    def is_left(self, connection: str, time: float, *, is_followed: bool) -> Message:
        if is_followed:
            return Message("from {t:.4g} s the other run of {mesh} is tight", t=time, mesh=connection)
        return Message(
            "from {t:.4g} s the other run of {mesh} is tight: there its pull at the bearings has the wrong sign",
            t=time,
            mesh=connection,
        )


def flank_of(sign: int, other: Measure) -> Flank | None:
    """None where the teeth press on both sides alike, without a force along the centres."""
    return Flank(sign, other) if sign else None
