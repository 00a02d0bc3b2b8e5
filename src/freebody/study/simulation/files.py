"""Files of a simulation: NetCDF, CSV and Parquet."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.present.files import check_writable, replaced

if TYPE_CHECKING:
    import xarray

SUFFIXES = (".nc", ".csv", ".parquet")


def check_path(path: Path, suffixes: tuple[str, ...]) -> None:
    """Raises InputError if a file cannot be written there, before anything is computed."""
    check_writable(path, suffixes)
    if path.suffix == ".parquet":
        from importlib.util import find_spec

        if find_spec("pyarrow") is None:
            raise InputError(Message('{path}: Parquet needs pyarrow; pip install "freebody[parquet]"', path=path))


def write(dataset: xarray.Dataset, path: Path) -> None:
    """Writes a dataset as NetCDF (.nc), or as a table with a column for each series (.csv, .parquet)."""
    check_path(path, SUFFIXES)
    writers = {".nc": _write_netcdf, ".csv": _write_csv, ".parquet": _write_parquet}
    with replaced(path) as file:
        writers[path.suffix](dataset, file)


def _write_netcdf(dataset: xarray.Dataset, file: Path) -> None:
    # in memory first: on a full disk the library leaves its file open, and complains about it until the program ends
    plain: Any = dataset.assign_attrs(measures=" ".join(dataset.attrs["measures"]))
    content = BytesIO()
    plain.to_netcdf(content, engine="h5netcdf")
    file.write_bytes(content.getbuffer())


def _write_csv(dataset: xarray.Dataset, file: Path) -> None:
    columns = table(dataset)
    header = ",".join(f'"{name}"' if "," in name else name for name in columns)
    np.savetxt(file, np.column_stack(list(columns.values())), delimiter=",", header=header, comments="", fmt="%.17g")


def _write_parquet(dataset: xarray.Dataset, file: Path) -> None:
    from importlib import import_module

    arrow: Any = import_module("pyarrow")
    parquet: Any = import_module("pyarrow.parquet")
    parquet.write_table(arrow.table(table(dataset)), file)


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
