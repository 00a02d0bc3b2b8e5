"""Parquet: a row for each case, a group of rows for each part."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.present.files import replaced

if TYPE_CHECKING:
    from freebody.study.sweeps.swept import Swept

SUFFIX = ".parquet"
EXTRA = "parquet"


def missing() -> str:
    return "" if find_spec("pyarrow") else "pyarrow"


def write(result: Swept, path: Path) -> None:
    arrow: Any = import_module("pyarrow")
    parquet: Any = import_module("pyarrow.parquet")
    with replaced(path) as file:
        writer: Any = None
        try:
            for table in result.tables():
                part = arrow.table(
                    {name: arrow.array(list(x) if x.dtype == object else x) for name, x in table.items()}
                )
                writer = writer or parquet.ParquetWriter(file, part.schema)
                writer.write_table(part)
        finally:
            if writer is not None:
                writer.close()
