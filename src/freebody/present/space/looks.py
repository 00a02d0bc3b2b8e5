"""How pieces look, one table for every canvas."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Look:
    """A colour is a name of the theme, or `body` for that of the body.

    cover: how much of what is behind an area hides; tint: the share of the colour in it; shade: what is added to the
    share on sides that turn away from the light; width: of its edges [points]; hidden: how strong its hidden edges
    are; fine: the width of marks and of lines on it; is_seamed: areas are painted slightly too large, so that parts
    join."""

    color: str
    cover: float = 1.0
    tint: float = 1.0
    shade: float = 0.0
    width: float = 1.0
    hidden: float = 0.0
    fine: float = 0.8
    is_seamed: bool = False


LOOKS: dict[str, Look] = {
    "body": Look("body", 0.86, 0.2, 0.3, 1.3, 0.3, 0.9),
    "fixed body": Look("muted", 0.86, 0.15, 0.2, 1.2, 0.3),
    "skin": Look("body", 1.0, 0.2, 0.3, 1.3, is_seamed=True),  # of many parts
    "fixed skin": Look("muted", 1.0, 0.15, 0.2, 1.2, is_seamed=True),
    "hoop": Look("body", 1.0, 0.28, 0.35, 1.0, is_seamed=True),
    "fixed hoop": Look("muted", 1.0, 0.2, 0.25, 1.0, is_seamed=True),
    "web": Look("body", 0.35, 0.3, 0.0, 0.0),
    "dot": Look("body", 1.0, 0.85, 0.0, 0.8),
    "joint": Look("ink", 1.0, 0.06, 0.22, 1.0),
    "rail": Look("muted", 1.0, 0.18, 0.3, 0.8, is_seamed=True),
    "stand": Look("muted", 0.9, 0.14, 0.25, 0.9),
    "hatched": Look("muted", 0.75, 0.08, 0.0, 0.9),
    "plane": Look("muted", 0.6, 0.07, 0.0, 0.9, fine=0.5),
    "link": Look("ink", 1.0, 0.3, 0.3, 0.9),
    "string": Look("ink", 1.0, 0.9, 0.0, 0.6),
    "net": Look("muted", 1.0, 0.5, 0.0, 0.4),
    "spring": Look("ink", 1.0, 0.9, 0.0, 0.5, fine=1.3, is_seamed=True),
    "damper": Look("ink", 0.95, 0.08, 0.25, 1.0),
    "force": Look("force", 1.0, 0.9, 0.1, 0.5, is_seamed=True),
}

OF_BODIES = frozenset(
    ("body", "fixed body", "skin", "fixed skin", "hoop", "fixed hoop", "web", "dot")
)  # bodies, not what joins them
