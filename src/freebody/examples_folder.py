"""The bundled examples: list, copy, and a small model to start from."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from freebody.errors import InputError
from freebody.present.files import write_whole

_TITLE = re.compile(r"^title:\s*(.+?)\s*$", re.MULTILINE)

_NEW = """\
# A model of freebody. See `freebody examples` for more.
freebody: 1
title: Block pulled along a table

parameters:            # symbols are positive unless `sign` says otherwise
  m: 2 kg
  F: 10 N
  d: 3 m

bodies:
  block: {particle: {mass: m}}

connections:
  table: {slider: {body: block, along: right}}

loads:
  pull: {force: {at: block, along: right, magnitude: F}}

measures:
  x: x of block

start: {x: 0, rate(x): 0}

questions:
  - {find: acceleration of x}
  - {find: time when x = d}
"""


def folder() -> Path:
    """Where the examples are: beside the installed package, or in the source tree."""
    here = Path(__file__).parent
    installed = here / "examples"
    return installed if installed.is_dir() else here.parents[1] / "examples"


def listed_examples() -> Iterator[tuple[str, str]]:
    """(name, title) of every example."""
    for path in sorted(folder().glob("*.yaml")):
        found = _TITLE.search(path.read_text(encoding="utf-8"))
        yield path.stem, found[1] if found else ""


def copy_examples(name: str | None, to: Path) -> list[Path]:
    """Copies one example, or all, into a folder. Existing files are not overwritten."""
    from freebody.model.noting import did_you_mean

    known = [n for n, _title in listed_examples()]
    if name is not None and name.removesuffix(".yaml") not in known:
        raise InputError(f"there is no example {name}.{did_you_mean(name, known)}")
    written: list[Path] = []
    for example in known if name is None else [name.removesuffix(".yaml")]:
        target = to / f"{example}.yaml"
        _write(target, (folder() / f"{example}.yaml").read_text(encoding="utf-8"))
        written.append(target)
    return written


def write_new(file: Path) -> None:
    """Writes a small model to start from."""
    _write(file, _NEW)


def _write(file: Path, text: str) -> None:
    if file.exists():
        raise InputError(f"{file} exists already; choose another name or remove it first")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{file.parent} cannot be made: {error.strerror}") from error
    write_whole(file, text)
