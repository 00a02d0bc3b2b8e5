"""Which case holds where in the plane of two parameters."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freebody.errors import InputError
from freebody.language.expression import Symbol
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.model.noting import did_you_mean
from freebody.numeric.jets import Array
from freebody.study.phases.numbers import coefficients_of_friction, holds
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.relations import SolvedRelation
from freebody.system.system import System

_MOST_FRICTION = 1.0


@dataclass(frozen=True)
class Regions:
    """The cases over a grid of two parameters in SI units: `index[j, k]` is the case at y[j], x[k], -1 where none is
    known. Labels name the parameters with their units; angles are in degrees there and in `x`, `y`."""

    names: tuple[str, str]
    labels: tuple[str, str]
    x: Array
    y: Array
    index: Array
    cases: tuple[str, ...]
    conditions: tuple[str, ...]


@dataclass(frozen=True)
class RegionCase:
    """A case of the motion: what happens, and where."""

    what: str
    conditions: tuple[str, ...]
    relations: tuple[SolvedRelation, ...]


def regions(tree: PhaseTree, found: Sequence[RegionCase], x: str, y: str, n: int) -> Regions:
    """The case at each of n times n values of two parameters; the others have the model's values. Raises InputError for
    a name that is no parameter, or a parameter without a value that would be needed."""
    system = tree.system
    for name in (x, y):
        if name not in system.parameters:
            raise InputError(
                Message("there is no parameter {name}.{hint}", name=name, hint=did_you_mean(name, system.parameters))
            )
    missing = [
        p.name for p in system.parameters.values() if p.value is None and p.form is None and p.name not in (x, y)
    ]
    if missing:
        raise InputError(Message("a picture needs a value for {missing}", missing=", ".join(missing)))
    axes = [_axis(system, name, n) for name in (x, y)]
    grid = np.meshgrid(*axes)
    values = {p.name: np.full(n * n, p.value or 0.0) for p in system.parameters.values() if p.form is None}
    values[x], values[y] = grid[0].ravel(), grid[1].ravel()
    sets = tree.sets.at(values)
    index = np.full(n * n, -1)
    for k, case in enumerate(found):
        inside = np.ones(n * n, dtype=bool)
        for relation in case.relations:
            inside &= holds(relation, sets.evaluate(tree.home.model, relation.element))
        index = np.where(inside & (index < 0), k, index)
    labels, shown = zip(*(_labelled(system, name, axis) for name, axis in zip((x, y), axes, strict=True)), strict=True)
    cases = tuple(c.what for c in found)
    conditions = tuple(", ".join(c.conditions) or "always" for c in found)
    return Regions((x, y), labels, shown[0], shown[1], index.reshape(n, n), cases, conditions)


def _axis(system: System, name: str, n: int) -> Array:
    p = system.parameters[name]
    if p.acute:
        return np.linspace(0.0, math.pi / 2, n + 2)[1:-1]
    if name in coefficients_of_friction(system):
        return np.linspace(0.0, max(_MOST_FRICTION, 1.5 * (p.value or 0.0)), n + 1)[1:]
    center = 1.0 if p.value is None else p.value
    low = -2.0 * abs(center) if p.sign == "any" else 0.0
    return np.linspace(low, 2.0 * abs(center) or 1.0, n + 1)[1:]


def _labelled(system: System, name: str, axis: Array) -> tuple[str, Array]:
    p = system.parameters[name]
    shown = to_text(Symbol(name))
    if p.is_angle:
        return f"{shown} [deg]", np.degrees(axis)
    unit = str(p.dimension)
    return (f"{shown} [{unit}]" if unit != "1" else shown), axis
