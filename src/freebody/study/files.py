"""Files of a simulation: NetCDF, CSV and Parquet."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import InputError
from freebody.numeric.jets import Array

if TYPE_CHECKING:
    import xarray

SUFFIXES = (".nc", ".csv", ".parquet")


def check_path(path: Path, suffixes: tuple[str, ...]) -> None:
    """Raises InputError if a file cannot be written there, before anything is computed."""
    if path.suffix not in suffixes:
        raise InputError(f"{path}: the name must end in {', '.join(suffixes)}")
    folder = path.parent
    if not folder.is_dir():
        raise InputError(f"{path}: there is no folder {folder}")
    try:
        existed = path.exists()
        with path.open("ab"):
            pass
        if not existed:
            path.unlink()
    except OSError as error:
        raise InputError(f"{path}: cannot be written ({error.strerror})") from error
    if path.suffix == ".parquet":
        from importlib.util import find_spec

        if find_spec("pyarrow") is None:
            raise InputError(f'{path}: Parquet needs pyarrow; pip install "freebody[parquet]"')


def write(dataset: xarray.Dataset, path: Path) -> None:
    """Writes a dataset as NetCDF (.nc), or as a table with a column for each series (.csv, .parquet)."""
    check_path(path, SUFFIXES)
    if path.suffix == ".nc":
        plain: Any = dataset.assign_attrs(measures=" ".join(dataset.attrs["measures"]))
        plain.to_netcdf(path, engine="h5netcdf")
        return
    columns = table(dataset)
    if path.suffix == ".csv":
        header = ",".join(f'"{name}"' if "," in name else name for name in columns)
        np.savetxt(
            path, np.column_stack(list(columns.values())), delimiter=",", header=header, comments="", fmt="%.17g"
        )
        return
    from importlib import import_module

    arrow: Any = import_module("pyarrow")
    parquet: Any = import_module("pyarrow.parquet")
    parquet.write_table(arrow.table(columns), path)


def table(dataset: xarray.Dataset) -> dict[str, Array]:
    """One column for each series, with its unit in the name: `theta [rad]`, `crank.position.x [m]`."""
    columns: dict[str, Array] = {"time [s]": np.asarray(dataset["time"])}
    variables: Any = dataset.data_vars
    for name, variable in variables.items():
        unit = variable.attrs.get("units", "")
        if variable.dims == ("time",):
            columns[f"{name} [{unit}]"] = np.asarray(variable)
        for body in dataset["body"].values if "body" in variable.dims else ():
            what = str(name).removeprefix("body_")
            if "axis" in variable.dims:
                for axis in ("x", "y"):
                    columns[f"{body}.{what}.{axis} [{unit}]"] = np.asarray(variable.sel(body=body, axis=axis))
            else:
                columns[f"{body}.{what} [{unit}]"] = np.asarray(variable.sel(body=body))
    return columns
