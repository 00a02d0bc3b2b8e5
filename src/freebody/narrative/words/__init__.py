"""What derivations say, in every language: `fr.toml`, or several files `fr.*.toml` besides, make a language."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any


def languages() -> tuple[str, ...]:
    """The languages for which there is a file."""
    return tuple(sorted({path.name.partition(".")[0] for path in _files()}))


def tables_of(language: str) -> Iterator[dict[str, Any]]:
    """What the files of a language have, in the order of their names."""
    import tomllib

    for path in sorted(_files(), key=lambda path: path.name):
        if path.name.partition(".")[0] == language:
            yield tomllib.loads(path.read_text("utf-8"))


def _files() -> Iterator[Path]:
    for folder in __path__:
        yield from Path(folder).glob("*.toml")
