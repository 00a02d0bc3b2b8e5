"""What is legal in a model but unlikely to be meant: a file for each kind of warning, found by itself."""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules

from freebody.study.model_warnings.base import ModelWarning, WarningKind
from freebody.study.model_warnings.found import warnings_of

__all__ = ["ModelWarning", "WarningKind", "warnings_of"]

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")
