"""A solved question as others are compared with it."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.assess.setting import Answer, Setting
from freebody.language.units import Dimension
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System


@dataclass(frozen=True)
class SolvedAnswer:
    """What is right, and in which model: what options are judged against, and what people answer.

    `element` is one of the model's field in SI units, a tuple of them, or a count; without one (None) only options that
    no answer can equal are judged, the others are left out and noted. With `up_to_constant` an option may differ from
    the answer by what does not change in the motion (energies). Where the answer is one only while some elements are
    positive (`region`), no reason is looked for elsewhere."""

    element: Answer
    dimension: Dimension
    model: SymbolicModel
    system: System
    up_to_constant: bool = False
    region: tuple[Ratio, ...] = ()

    def setting(self, *, is_typed: bool = False) -> Setting:
        """Where others are compared with it."""
        return Setting(
            self.element,
            self.dimension,
            self.model,
            self.system,
            self.up_to_constant,
            self.region,
            is_typed=is_typed,
        )
