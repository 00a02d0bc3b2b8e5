"""Vectors of space in a derivation: the axes along which they are told, their components, and symbols for these."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Argument, Sentence
from freebody.measures.geometry import GROUND
from freebody.model.spins import body_axes
from freebody.narrative.lines.glossary import Glossary, Meaning, World
from freebody.narrative.lines.naming import component_names
from freebody.narrative.lines.script import Legend, Script
from freebody.questions.vectors import AXES, Basis, components_of, dot
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.spatial.bodies import SpatialBodies
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.system.system import System

Vector = tuple[Ratio, ...]
Reads = Callable[[World], Sequence[float]]  # of a vector, by ground components
_GROUND: Basis = AXES


@dataclass(frozen=True)
class Axes:
    """The axes along which vectors are told: those of the ground, or of a body."""

    basis: Basis
    body: str

    @property
    def words(self) -> Sentence:
        if self.body == GROUND:
            return Sentence("space.axes_ground")
        return Sentence("space.axes_body", {"body": self.body})


def axes_of_body(system: System, body: str) -> Axes:
    """The axes of a body; those of the ground for one that is fixed, and for a ball whose orientation is left open."""
    if system.bodies[body].fixed or body in system.unfollowed:
        return Axes(_GROUND, GROUND)
    return Axes(body_axes(body), body)


def axes_of(basis: Basis | None) -> Axes:
    """The axes in which a question wants its vector."""
    return Axes(_GROUND, GROUND) if basis is None else Axes(basis, basis[0].body)


class Frames:
    """Components of vectors, and lines that state them."""

    def __init__(self, setup: Setup, glossary: Glossary, script: Script) -> None:
        self.setup, self.glossary, self.script = setup, glossary, script
        self.system = setup.system
        self.model = model = setup.model
        assert isinstance(model.bodies, SpatialBodies)
        self.bodies: SpatialBodies = model.bodies
        self.field = model.field
        self.state: SymbolicState = setup.state

    def express(self, x: Ratio) -> Ratio:
        """In the coordinates that are left."""
        return self.field.lowest_terms(self.model.express(x))

    def along(self, vector: Sequence[Ratio], axes: Axes) -> Vector:
        """Ground components as components along axes."""
        if axes.body == GROUND:
            return tuple(map(self.field.lowest_terms, vector))
        return tuple(
            self.field.lowest_terms(self.field.element(dot(tuple(vector), components_of(a, self.state, 3))))
            for a in axes.basis
        )

    def introduce(
        self, name: str, what: str, body: str, axes: Axes, reads: Reads, unit: str, **more: Argument
    ) -> tuple[Symbol, ...]:
        """Symbols for the components of a vector. more: what else its meaning names."""
        symbols = component_names(name)
        taken = {*self.system.parameters, *self.glossary.measures}
        if any(s.name in taken for s in symbols):
            symbols = component_names(f"{name}_c")

        known: dict[int, tuple[World, tuple[float, ...]]] = {}

        def vector(world: World) -> tuple[float, ...]:
            if id(world) not in known:
                ground = tuple(reads(world))
                parts = (float(dot(ground, components_of(a, world.snapshot, 3))) for a in axes.basis)
                known[id(world)] = world, tuple(parts)
            return known[id(world)][1]

        def read(k: int) -> Callable[[World], float]:
            return lambda world: vector(world)[k]

        entries: list[tuple[Expr, Sentence, str]] = []
        for k, symbol in enumerate(symbols):
            said = Sentence(f"space.{what}", {"body": body, "axis": f"@{'xyz'[k]}", "axes": axes.words, **more})
            self.glossary.redefine(Meaning(symbol, said, read(k), unit))
            entries.append((symbol, said, unit))
        self.script.add(Legend(tuple(entries)))
        return symbols

    def shown(self, vector: Sequence[Ratio]) -> tuple[Expr, ...]:
        return tuple(tidy(self.field.lowest_terms(x)) for x in vector)
