"""NetCDF 4: the axes of the sweep as dimensions, written in slabs along the first of them."""

from __future__ import annotations

import math
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.present.files import check_room, replaced

if TYPE_CHECKING:
    from freebody.study.sweeps.swept import Swept

SUFFIX = ".nc"
EXTRA = "data"
_OF_HEADS = 16_384  # bytes that a variable takes besides its numbers


def missing() -> str:
    return "" if find_spec("h5netcdf") else "h5netcdf"


def write(result: Swept, path: Path) -> None:
    library: Any = import_module("h5netcdf")
    # on a full disk the library brings the interpreter down when it closes its file
    check_room(path, _OF_HEADS + sum(8 * math.prod(of.shape) + _OF_HEADS for of in result.variables()))
    with replaced(path) as file, library.File(file, "w") as out:
        out.dimensions = dict(result.plan.dimensions)
        for name, value in result.attributes.items():
            out.attrs[name] = value
        for of in result.variables():
            variable = out.create_variable(of.name, of.dimensions, of.dtype)
            for name, value in of.attributes.items():
                variable.attrs[name] = value
            for part, values in of.parts():
                variable[part] = values
