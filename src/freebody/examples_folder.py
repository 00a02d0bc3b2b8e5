"""The bundled examples and templates: list, copy, and write a model to start from."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from freebody.errors import InputError
from freebody.present.files import write_whole

_TITLE = re.compile(r"^title:\s*(.+?)\s*$", re.MULTILINE)
_FIRST = "block"  # the template of a new file that is to be like nothing


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
        text = (folder() / f"{example}.yaml").read_text(encoding="utf-8")
        written += [_write(to / f"{example}.yaml", text), *write_beside(text, to)]
    return written


def beside(text: str) -> list[Path]:
    """The files in the folder of the examples that a model names, as tables of points and triangles."""
    others = sorted(path for path in folder().iterdir() if path.is_file() and path.suffix not in (".yaml", ".md"))
    return [path for path in others if re.search(rf"(?<![\w./-]){re.escape(path.name)}(?![\w/-])", text)]


def templates() -> dict[str, Path]:
    """The templates of new models by name: small models with comments, found in their folder."""
    return {path.stem: path for path in sorted((Path(__file__).parent / "templates").glob("*.yaml"))}


def listed_templates() -> Iterator[tuple[str, str]]:
    """(name, title) of every template."""
    for name, path in templates().items():
        found = _TITLE.search(path.read_text(encoding="utf-8"))
        yield name, found[1] if found else ""


def write_new(file: Path, like: str | None = None) -> list[Path]:
    """Writes a model to start from: a template, or a bundled example. The files that go with it. Raises InputError
    where there is no such one."""
    from freebody.model.noting import did_you_mean

    known = {name: folder() / f"{name}.yaml" for name, _title in listed_examples()} | templates()
    name = _FIRST if like is None else like.removesuffix(".yaml").strip().replace(" ", "_").replace("-", "_")
    if name not in known:
        nearest = did_you_mean(name, known)
        if "Did you mean" not in nearest:
            nearest = f" There is: {', '.join(templates())}, and every name of `freebody examples`."
        raise InputError(f"there is no template {like}.{nearest}")
    text = known[name].read_text(encoding="utf-8")
    _write(file, text)
    return write_beside(text, file.parent)


def write_beside(text: str, to: Path) -> list[Path]:
    """Writes what a model names and the examples have, unless it is there: whose it is there may be another one."""
    wanted = [(path, to / path.name) for path in beside(text) if not (to / path.name).exists()]
    return [_write(target, path.read_text(encoding="utf-8")) for path, target in wanted]


def _write(file: Path, text: str) -> Path:
    if file.exists():
        raise InputError(f"{file} exists already; choose another name or remove it first")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{file.parent} cannot be made: {error.strerror}") from error
    write_whole(file, text)
    return file
