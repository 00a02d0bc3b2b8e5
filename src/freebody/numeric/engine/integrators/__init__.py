"""Integrators: one file each, found by itself; its name is that of the method."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from freebody.numeric.engine.integrators.base import Integrator


def integrators() -> tuple[str, ...]:
    """The names of all methods; none is loaded."""
    return _in(tuple(__path__))


@cache  # asked for with every set of options
def _in(folders: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(module.name for module in iter_modules(folders) if module.name != "base")


def integrator(name: str) -> Integrator:
    """The method of that name."""
    return import_module(f"{__name__}.{name}").INTEGRATOR
