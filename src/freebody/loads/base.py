"""The base of all loads.

A load is one file in this folder: a `Spec` with a `kind`; `applied_loads`, which says which measures it pushes and by
what law; and `glyphs`, which says what is drawn of it. Extension and pulling are positive. A blow says with
`impulses` what it pushes by which impulse, and pushes nothing otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.model.elements import AppliedLoad, Validity
from freebody.model.glyphs import Glyph
from freebody.model.kinds import Kinds
from freebody.model.spec import Spec

if TYPE_CHECKING:
    from freebody.model.names import Names


class Load(Spec):
    """Base of the loads; a subclass is found by its `kind`."""

    kinds: ClassVar[Kinds[type[Load]]] = Kinds("freebody.loads")
    example: ClassVar[str] = ""
    # -1 for loads between two points, whose force is positive when it pulls them together
    pulling_sign: ClassVar[int] = 1
    # True if its work is kept as potential energy
    stores_energy: ClassVar[bool] = False
    # whether it acts on all parts of a body: evenly on its "mass", or somehow on the "whole"; else at a point
    spread_over: ClassVar[str] = ""
    # True if it resists motion and only takes energy
    resists: ClassVar[bool] = False
    is_chosen = False

    @property
    def strikes_when(self) -> str:
        """Of an impulse in mid-motion: the words of the event at which it acts; nothing at the start."""
        return ""

    def __init_subclass__(cls, kind: str = "", **rest: Any) -> None:
        super().__init_subclass__(**rest)
        if kind:
            cls.kind = kind
            Load.kinds.register(kind, cls)

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        """The measures it pushes."""
        return []

    def among(self, names: Names, push: AppliedLoad, others: Sequence[AppliedLoad]) -> list[AppliedLoad]:
        """One of the measures it pushes, as it is meant beside all that is pushed."""
        return [push]

    def impulses(self, names: Names) -> list[AppliedLoad]:
        """The measures it pushes at once, at the start or when an event happens: by an impulse in the parameters."""
        return []

    def valid_where(self, names: Names) -> list[Validity]:
        """What it takes for granted of where the bodies are."""
        return []

    @property
    def drawn_sign(self) -> int:
        """The sign with which it is drawn where the numbers of a model do not say how it acts."""
        return self.pulling_sign

    def pulls_with(self, laws: Sequence[Any], sqrt: Callable[[Any], Any]) -> Any:
        """The force or torque that people ask for, from the values of the laws of what it pushes; None where there is
        no single one, as of a weight on several bodies."""
        return self.pulling_sign * laws[0] if len(laws) == 1 else None

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        """What is drawn of it (see `model.glyphs`); nothing if it does not say."""
        return ()
