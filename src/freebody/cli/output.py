"""What commands print."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any


def print_written(paths: Sequence[Path]) -> None:
    from freebody.language.plain_text import plain

    for path in paths:
        print(f"wrote {plain(str(path))}")


def print_json(document: Any) -> None:
    """One document of plain JSON: what is no finite number is null."""
    print(json.dumps(_finite(document), indent=2, ensure_ascii=False, allow_nan=False))


def _finite(document: Any) -> Any:
    if isinstance(document, dict):
        return {str(key): _finite(value) for key, value in document.items()}  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
    if isinstance(document, list | tuple):
        return [_finite(value) for value in document]  # pyright: ignore[reportUnknownVariableType]
    if hasattr(document, "tolist"):  # numbers and arrays of NumPy
        return _finite(document.tolist())
    if isinstance(document, float) and not math.isfinite(document):
        return None
    return document
