"""Zarr: a folder of arrays, each written region by region."""

from __future__ import annotations

import shutil
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.errors import InputError
from freebody.language.sentences import Message

if TYPE_CHECKING:
    from freebody.study.sweeps.swept import Swept

SUFFIX = ".zarr"
EXTRA = "sweep"


def missing() -> str:
    return "" if find_spec("zarr") else "zarr"


def write(result: Swept, path: Path) -> None:
    library: Any = import_module("zarr")
    beside = path.with_name(f".freebody-{path.name}")
    try:
        shutil.rmtree(beside, ignore_errors=True)
        # format 2: its metadata can be consolidated, so that one look opens the dataset
        group = library.open_group(str(beside), mode="w", zarr_format=2, attributes=_plain(result.attributes))
        for of in result.variables():
            about = {**_plain(of.attributes), "_ARRAY_DIMENSIONS": list(of.dimensions)}
            # no fill value: readers take it for a missing one, and the default, 0, is a result
            array = group.create_array(of.name, shape=of.shape, dtype=of.dtype, attributes=about, fill_value=None)
            for part, values in of.parts():
                array[part] = values
        library.consolidate_metadata(str(beside))
        if path.exists():
            shutil.rmtree(path)
        beside.rename(path)
    except OSError as error:
        shutil.rmtree(beside, ignore_errors=True)
        raise InputError(Message("{path} cannot be written: {why}", path=path, why=error.strerror or error)) from error


def _plain(attributes: dict[str, Any]) -> dict[str, Any]:
    return {name: value.tolist() if hasattr(value, "tolist") else value for name, value in attributes.items()}
