"""A warning about a model, and what kinds of warnings look at."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from freebody.errors import Problem
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.system.system import System
from freebody.tolerances import ON_LINE

_SEED, _N_POSES, _FAR = 20, 4, 0.3
_SINGULAR = 1e-9  # of the largest singular value


@dataclass(frozen=True)
class ModelWarning:
    """kind: its name; problem: where it stands in the file and what to do; about: the names in the model that it is
    about, none where it is about all of it."""

    kind: str
    problem: Problem
    about: frozenset[str] = frozenset()

    def text(self, file: str | None = None) -> str:
        """With its place in the file, if that is known."""
        return self.problem.text(file)

    def to_plain(self) -> dict[str, Any]:
        """For JSON."""
        own = self.problem
        where = ".".join(map(str, own.path))
        return {"kind": self.kind, "where": where, "line": own.line, "column": own.column, "text": str(own.message)}


class Opened:
    """A model at its start and in a few poses that it can move to, each worked out when a kind first asks. Raises
    FreebodyError where there is no such pose: then another message tells why.

    asked: what is said of it beside the file, as a question on the command line."""

    def __init__(self, system: System, asked: tuple[str, ...] = ()) -> None:
        self.system, self.asked = system, asked

    @cached_property
    def start(self) -> Snapshot:
        """At rest."""
        from freebody.study.pictures.instant import start_of

        return start_of(self.system, at_rest=True).snapshot

    @property
    def reference(self) -> Reference:
        found = self.start.reference
        assert isinstance(found, Reference)
        return found

    @property
    def close(self) -> float:
        """[m] less is no distance."""
        return ON_LINE * self.reference.sizes.length

    @cached_property
    def elsewhere(self) -> list[Snapshot]:
        """In motion: free directions and drivers all run."""
        random, found = np.random.default_rng(_SEED), list[Snapshot]()
        for k in range(_N_POSES):
            q, v = self.reference.wander(self.start.q, random, _FAR, 0.1 * k)
            found.append(self.reference.snapshot(q, v, 0.1 * k))
        return found

    def slope(self, measure: Measure | NonholonomicForm, at: Snapshot) -> Array:
        """(n,) its gradient in all coordinates, scaled to moves of about the size of the system."""
        row = self.reference.jet(at.geometry, measure).row(len(at.q))
        return np.asarray(row * self.reference.sizes.unit_moves, dtype=np.float64)

    def free(self, at: Snapshot, without: Collection[ConstraintRow] = ()) -> Array:
        """(n, n_free) directions that the constraints leave, some of them left out."""
        kept = [row for row in self.system.constraint_rows if all(row is not other for other in without)]
        rows = [self.slope(row.measure, at) for row in kept]
        if not rows:
            return np.eye(len(at.q))
        _u, sizes, directions = np.linalg.svd(np.array(rows))
        rank = int((sizes > _SINGULAR * max(float(sizes.max(initial=0.0)), 1e-300)).sum())
        return directions[rank:].T


class WarningKind:
    """One kind of warning: `look` yields what it finds. explains: kinds that say the same of the same names again, once
    this one has been said (all kinds of the whole model where it is about no name)."""

    kinds: ClassVar[list[type[WarningKind]]] = []
    name: ClassVar[str]
    explains: ClassVar[frozenset[str]] = frozenset()

    def __init_subclass__(cls, *, name: str, **options: Any) -> None:
        super().__init_subclass__(**options)
        cls.name = name
        WarningKind.kinds.append(cls)

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        """Raises FreebodyError where it cannot be told."""
        raise NotImplementedError

    def warning(self, message: str, *path: str | int, about: frozenset[str] = frozenset()) -> ModelWarning:
        return ModelWarning(self.name, Problem(path, message), about)
