"""Questions about the tension where a heavy rope is cut: at an edge, before and behind a wheel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.language.expression import ZERO
from freebody.language.sentences import Message, Sentence, listed
from freebody.language.units import FORCE
from freebody.model.state import State
from freebody.model.transmitted import CutTension
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, PLACE, Found, asked
from freebody.questions.reactions import has_connection
from freebody.questions.reactions_by_component import read_component

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class RopeTension(Quantity, kind="tension in a rope"):
    """The tension in a rope with mass at a place on its way: what holds and accelerates the part from there to its last
    end. Source: Beer & Johnston, Vector Mechanics for Engineers: Dynamics, sec. 14.11."""

    connection: str
    at: str
    cut: CutTension

    measured_in = FORCE
    is_reaction = True
    example = """
bodies: {chain: {rope: {mass: 1 kg, length: 2 m}}}
connections: {way: {heavy_rope: {rope: chain, over: [ground.edge], leads: [right, down]}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {x: drop of chain}
start: {x: 0.5 m, rate(x): 0}
questions: {it: tension in way at ground.edge}
"""

    @property
    def may_jump(self) -> bool:
        return True

    def value(self, system: Described, state: State[Any]) -> Any:
        """F + weight + weight_by_way x - (mass + mass_by_way x) x''."""
        cut, rows = self.cut, {row.name: row for row in system.rows}
        x, a = state.value(cut.way), state.acceleration(cut.way)

        def linear(constant: Any, by_way: Any) -> Any:
            total = 0 if constant == ZERO else state.scalar(constant)
            return total if by_way == ZERO else total + state.scalar(by_way) * x

        total = linear(cut.weight, cut.weight_by_way) - linear(cut.mass, cut.mass_by_way) * a
        for name in cut.rows:
            total = total + rows[name].sign * state.multiplier(rows[name])
        return total

    def sentence(self, system: Described) -> Sentence:
        side, _, place = self.at.partition(" ")
        return Sentence(f"what.rope_tension.{side}", {"connection": self.connection, "place": place})


@asked(
    "tension in ROPE at POINT | before WHEEL | behind WHEEL",
    rf"tension (?:of|in) (?:the )?(?P<of>{NAME}) (?P<side>at|before|behind) (?P<at>{PLACE})",
    rank=60,
)
def _rope_tension(names: Names, found: Found, path: Path) -> Quantity | None:
    of, at = str(found["of"]), f"{found['side']} {found['at']}"
    connection = names.connections.get(of)
    with names.quietly():
        cuts = dict[str, CutTension]() if connection is None else connection.tensions(names)
    if at in cuts:
        return RopeTension(of, at, cuts[at])
    if found["side"] == "at":  # of a string, or of what is tied to an end
        return read_component(names, {"what": "tension", "of": of, "at": found["at"], "a": None, "b": None}, path)
    if of in names.broken or not has_connection(names, of, path):
        return None
    known = listed([f"tension in {of} {words}" for words in cuts])
    told = (
        Message("'{at}' is no place on the way of {of}; ask for: {known}", of=of, at=at, known=known)
        if cuts
        else Message("{of} is no rope with mass that runs over wheels", of=of)
    )
    names.problem(told, *path)
    return None
