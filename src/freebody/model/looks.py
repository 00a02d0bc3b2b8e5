"""What the author of a model wants otherwise in its pictures: the section `drawing`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Looks:
    """paths: points of a body through which it is drawn as a bent bar; labels: what stands beside a body, a measure or
    a load instead of its name; scale: how many times as large a point mass is drawn; hide: bodies, measures,
    parameters and loads whose names and signs are left out."""

    paths: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    labels: Mapping[str, str] = field(default_factory=dict[str, str])
    scale: Mapping[str, float] = field(default_factory=dict[str, float])
    hide: frozenset[str] = frozenset()
