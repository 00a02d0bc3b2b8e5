"""Tables beside a model: a CSV file in its folder, whose head names the columns and their units.

    phi [deg], lift [mm]
    0,         0
    30,        0.8

Every mistake is told with the number of its line.
"""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from freebody.errors import UnitError
from freebody.language.sentences import Message
from freebody.language.units import Dimension, parse_quantity

if TYPE_CHECKING:
    from freebody.model.names import Names

Row = tuple[int, list[float]]  # the number of the line, and the values [SI]
MOST_BYTES = 1_000_000
_HEAD = re.compile(r"(?P<name>[^\[\]]*?)\s*(?:\[(?P<unit>[^\]]*)\])?\s*")


def read_table(names: Names, file: str, columns: Sequence[tuple[str, Dimension]], field: str) -> list[Row] | None:
    """The rows of a table with columns of these dimensions, in their order; None with a problem noted at the field that
    names it. A column without a unit is in SI."""
    text = _text_of(names, file, field)
    if text is None:
        return None
    try:
        return _rows(file, text, columns)
    except ValueError as error:
        names.problem(error.args[0], field)
        return None


def _text_of(names: Names, file: str, field: str) -> str | None:
    data = bytes_beside(names, file, field, MOST_BYTES, Message(": write the points here"))
    try:
        return None if data is None else data.decode("utf-8-sig")
    except ValueError as error:
        names.problem(Message("the file {file} cannot be read: {why}", file=file, why=error), field)
        return None


def bytes_beside(names: Names, file: str, field: str, most: int, instead: str = "") -> bytes | None:
    """What stands in a file of the folder of the model, or below it, of at most so many bytes; None with a problem
    noted at the field that names it. instead: what to write where the model is in no file."""
    if not names.folders:
        told = Message(
            "{file} is looked for beside the model, which is in no file{instead}", file=file, instead=instead
        )
        names.problem(told, field)
        return None
    try:
        found = [(folder.resolve(), (folder / file).resolve()) for folder in names.folders]
        within = [path for folder, path in found if path.is_relative_to(folder)]
        path = next((path for path in within if path.is_file()), None)
        if not within:
            told = Message("{file} is not in the folder of the model: put it beside the model", file=file)
        elif path is None:
            told = Message("there is no file {file} in the folder of the model", file=file)
        elif path.stat().st_size > most:
            told = Message("the file {file} is larger than {most} MB", file=file, most=most // 1_000_000)
        else:
            return path.read_bytes()
    except (OSError, ValueError) as error:
        told = Message("the file {file} cannot be read: {why}", file=file, why=error)
    names.problem(told, field)
    return None


def _rows(file: str, text: str, columns: Sequence[tuple[str, Dimension]]) -> list[Row]:
    """Raises ValueError with a Message for what cannot be read."""
    found: list[Row] = []
    factors: list[float] | None = None
    reader = csv.reader(text.splitlines())
    for cells in reader:
        line, row = reader.line_num, [cell.strip() for cell in cells]
        if not any(row):
            continue
        if len(row) != len(columns):
            told = Message(
                "{file}, line {line}: {found} columns instead of {wanted}",
                file=file,
                line=line,
                found=len(row),
                wanted=len(columns),
            )
            raise ValueError(told)
        if factors is None:
            factors = [_factor(file, line, cell, *column) for cell, column in zip(row, columns, strict=True)]
        else:
            found.append((line, [_number(file, line, cell) * f for cell, f in zip(row, factors, strict=True)]))
    return found


def _factor(file: str, line: int, cell: str, name: str, dimension: Dimension) -> float:
    """How many units of SI the unit of a column is."""
    head = _HEAD.fullmatch(cell)
    if head is None or _is_number(cell):
        told = Message(
            "{file}, line {line}: the first line names the columns, with their units: {name} [{unit}], ...",
            file=file,
            line=line,
            name=name,
            unit=str(dimension) or "deg",
        )
        raise ValueError(told)
    unit = (head["unit"] or "").strip()
    if not unit:
        return 1.0
    try:
        quantity = parse_quantity(f"1 {unit}")
    except UnitError as error:
        raise ValueError(Message("{file}, line {line}: {why}", file=file, line=line, why=error)) from error
    if quantity.dimension != dimension:
        told = Message("{file}, line {line}: {unit} is no unit of {name}", file=file, line=line, unit=unit, name=name)
        raise ValueError(told)
    return quantity.value


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True


def _number(file: str, line: int, cell: str) -> float:
    if not _is_number(cell) or not math.isfinite(float(cell)):
        raise ValueError(Message("{file}, line {line}: '{cell}' is no number", file=file, line=line, cell=cell[:40]))
    return float(cell)
