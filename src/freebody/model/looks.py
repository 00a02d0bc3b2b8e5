"""What the author of a model wants otherwise in its pictures: the section `drawing`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from freebody.language.expression import Expr
from freebody.measures.geometry import Point


@dataclass(frozen=True)
class Looks:
    """paths: points of a body through which it is drawn as a bent bar; labels: what stands beside a body, a measure or
    a load instead of its name; scale: how many times as large a point mass is drawn; wheels: points of bodies at which
    a wheel stands on its road, with its radius: its centre lies that far above the point, along the body's own y axis;
    hide: bodies, measures, parameters and loads whose names and signs are left out."""

    paths: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    labels: Mapping[str, str] = field(default_factory=dict[str, str])
    scale: Mapping[str, float] = field(default_factory=dict[str, float])
    wheels: Mapping[Point, Expr] = field(default_factory=dict[Point, Expr])
    hide: frozenset[str] = frozenset()
