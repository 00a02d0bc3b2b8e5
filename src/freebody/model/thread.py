"""A thread that slides: how steep it is, and how rough."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.expression import Expr


@dataclass(frozen=True)
class Thread:
    """slope: tan(lambda) at the mean radius; static and kinetic: friction, of slanted flanks mu/cos(alpha)."""

    slope: Expr
    static: Expr
    kinetic: Expr
