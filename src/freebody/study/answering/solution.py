"""What `solve` found out about a system."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.language.sentences import Message
from freebody.model.states import state_name
from freebody.present.lines import system_line
from freebody.present.report.blocks import Block, Remark, Report
from freebody.present.report.result import Result
from freebody.present.report.results import line, summary
from freebody.study.answering.answer import Answer
from freebody.study.answering.told import answer_section
from freebody.symbolic.model import SymbolicModel
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.study.phases.result import Phases


@dataclass(frozen=True)
class Solution(Result):
    """What `solve` found out about one system."""

    system: System
    degrees_of_freedom: int
    coordinates: tuple[str, ...]
    dependent: tuple[str, ...]
    redundant: tuple[str, ...]
    answers: tuple[Answer, ...]
    phases: Phases | None = None  # of a system with contacts or dry friction
    assumed: tuple[str, ...] = ()  # about the start, where the model leaves it open

    @classmethod
    def of(
        cls,
        system: System,
        model: SymbolicModel,
        answers: tuple[Answer, ...],
        phases: Phases | None = None,
        assumed: tuple[str, ...] = (),
    ) -> Solution:
        """With the freedoms and coordinates of a model in formulas."""
        coordinates, dependent = (
            tuple(c.name for c in found if not state_name(c.name)) for found in (model.coordinates, model.dependent)
        )
        dof, redundant = model.degrees_of_freedom - len(system.states), tuple(model.redundant)
        return cls(system, dof, coordinates, dependent, redundant, answers, phases, assumed)

    def __getitem__(self, id: str | int) -> Answer:
        """The answer with an id, or in a place."""
        if isinstance(id, int):
            return self.answers[id]
        for answer in self.answers:
            if answer.id == id:
                return answer
        raise KeyError(f"no question has the id {id}; there are {', '.join(a.id for a in self.answers)}")

    def keys(self) -> tuple[str, ...]:
        """The ids of the answers."""
        return tuple(answer.id for answer in self.answers)

    def values(self) -> tuple[Answer, ...]:
        return self.answers

    def items(self) -> tuple[tuple[str, Answer], ...]:
        """Ids and answers."""
        return tuple((answer.id, answer) for answer in self.answers)

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self.answers)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """What the answers take for granted and the model does not say."""
        return (*self.system.assumptions, *self.assumed)

    @property
    def is_complete(self) -> bool:
        return all(a.expression is not None for a in self.answers)

    def to_plain(self) -> dict[str, Any]:
        """The solution as plain data: the JSON document of the command line."""
        return {
            "title": self.system.title,
            "degrees_of_freedom": self.degrees_of_freedom,
            "coordinates": list(self.coordinates),
            "dependent_coordinates": list(self.dependent),
            "redundant": list(self.redundant),
            "assumptions": list(self.assumptions),
            "answers": [a.to_plain() for a in self.answers],
            **({"states": list(self.system.states)} if self.system.states else {}),
            **({} if self.phases is None else {"phases": self.phases.to_plain()}),
        }

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        yield line(system_line(self.system, self.degrees_of_freedom, self.coordinates, self.dependent))
        yield from (line(Message("assumed: {text}", text=text)) for text in self.assumptions)
        if self.redundant:
            yield line(Message("redundant constraints: {names}", names=", ".join(self.redundant)))
        if self.phases is not None:
            yield self.phases.section
        yield from map(answer_section, self.answers)
        if not self.answers:
            asked = Message("The file asks nothing. Add questions, or see its equations with: freebody eom FILE")
            yield Remark((asked,), "warning")
