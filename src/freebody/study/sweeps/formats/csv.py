"""Comma-separated values: a line for each case."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import TYPE_CHECKING

from freebody.present.files import replaced

if TYPE_CHECKING:
    from freebody.study.sweeps.swept import Swept

SUFFIX = ".csv"


def missing() -> str:
    return ""


def write(result: Swept, path: Path) -> None:
    with replaced(path) as file, file.open("w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out)
        for k, table in enumerate(result.tables()):
            if k == 0:
                writer.writerow(table)
            columns = [[repr(x) if isinstance(x, float) else x for x in values.tolist()] for values in table.values()]
            writer.writerows(zip(*columns, strict=True))
