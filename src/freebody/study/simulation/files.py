"""Files of a simulation: NetCDF, CSV and Parquet."""

from __future__ import annotations

from importlib.util import find_spec
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.present.files import check_writable, replaced
from freebody.present.recording import Recording

SUFFIXES = (".nc", ".csv", ".parquet")


def check_path(path: Path, suffixes: tuple[str, ...]) -> None:
    """Raises InputError if a file cannot be written there, before anything is computed."""
    check_writable(path, suffixes)
    if path.suffix == ".parquet" and find_spec("pyarrow") is None:
        raise InputError(Message('{path}: Parquet needs pyarrow; pip install "freebody[parquet]"', path=path))
    if path.suffix == ".nc" and (find_spec("xarray") is None or find_spec("h5netcdf") is None):
        raise InputError(Message('{path}: NetCDF needs xarray and h5netcdf; pip install "freebody[data]"', path=path))


def write(recording: Recording, path: Path) -> None:
    """Writes a motion as NetCDF (.nc), or as a table with a column for each series (.csv, .parquet)."""
    check_path(path, SUFFIXES)
    writers = {".nc": _write_netcdf, ".csv": _write_csv, ".parquet": _write_parquet}
    with replaced(path) as file:
        writers[path.suffix](recording, file)


def _write_netcdf(recording: Recording, file: Path) -> None:
    # in memory first: on a full disk the library leaves its file open, and complains about it until the program ends
    plain: Any = recording.dataset().assign_attrs(measures=" ".join(recording.attributes["measures"]))
    content = BytesIO()
    plain.to_netcdf(content, engine="h5netcdf")
    file.write_bytes(content.getbuffer())


def _write_csv(recording: Recording, file: Path) -> None:
    columns = table(recording)
    header = ",".join(f'"{name}"' if "," in name else name for name in columns)
    np.savetxt(file, np.column_stack(list(columns.values())), delimiter=",", header=header, comments="", fmt="%.17g")


def _write_parquet(recording: Recording, file: Path) -> None:
    from importlib import import_module

    arrow: Any = import_module("pyarrow")
    parquet: Any = import_module("pyarrow.parquet")
    parquet.write_table(arrow.table(table(recording)), file)


def table(recording: Recording) -> dict[str, Array]:
    """One column for each series, with its unit in the name: `theta [rad]`, `crank.position.x [m]`."""
    columns: dict[str, Array] = {"time [s]": recording.times}
    for name, series in recording.series.items():
        if series.dimensions == ("time",):
            columns[f"{name} [{series.unit}]"] = series.values
        for body in recording.labels["body"] if "body" in series.dimensions else ():
            what = name.removeprefix("body_")
            if "axis" in series.dimensions:
                for axis in ("x", "y"):
                    columns[f"{body}.{what}.{axis} [{series.unit}]"] = recording.of(name, body=body, axis=axis)
            else:
                columns[f"{body}.{what} [{series.unit}]"] = recording.of(name, body=body)
    return columns
