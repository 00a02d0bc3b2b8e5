"""Formats of the results of a sweep, a file each, found by itself.

`SUFFIX`, by which a name asks for it; `missing()`, what has to be installed for it, with the extra `EXTRA`; and
`write(result, path)`, which writes part by part."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import TYPE_CHECKING, Any

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.present.files import check_writable

if TYPE_CHECKING:
    from freebody.study.sweeps.swept import Swept


@cache
def formats() -> dict[str, Any]:
    """The modules by suffix."""
    found = [import_module(f"{__name__}.{module.name}") for module in iter_modules(__path__)]
    return {kind.SUFFIX: kind for kind in found}


def check_data_path(path: Path) -> None:
    """Raises InputError if results cannot be written there: before anything is computed."""
    kind = formats()[path.suffix]
    if missing := kind.missing():
        raise InputError(
            Message('{path}: needs {what}; pip install "freebody[{extra}]"', path=path, what=missing, extra=kind.EXTRA)
        )
    if path.suffix != ".zarr":
        check_writable(path)


def write_data(result: Swept, path: Path) -> None:
    """Writes the results in the format of the suffix."""
    check_data_path(path)
    formats()[path.suffix].write(result, path)
