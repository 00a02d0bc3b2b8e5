"""The bundled examples as plain data: enough to choose among them while tests are collected, in a hundredth of the time
that reading them as models takes."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import yaml

from freebody.language.document import Document

FOLDER = Path(__file__).parents[1] / "examples"


@cache
def plain() -> dict[str, dict[str, Any]]:
    """What stands in the files, by name: numbers and texts as YAML has them, without the places where they stand."""
    return {path.stem: yaml.load(path.read_text(), yaml.CSafeLoader) for path in sorted(FOLDER.glob("*.yaml"))}


@cache
def document(name: str) -> dict[str, Any]:
    """What stands in one file, as the reader of models takes it; not to be changed."""
    return Document.load(FOLDER / f"{name}.yaml").data
