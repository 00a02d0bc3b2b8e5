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


def names_a_file(part: Any) -> bool:
    """Whether something stands in a file beside the model: data alone has no folder in which to look for it."""
    if isinstance(part, dict | list):
        return any(map(names_a_file, part.values() if isinstance(part, dict) else part))
    return isinstance(part, str) and "." in part and " " not in part and (FOLDER / part).is_file()
