"""Reference pages, written from what the kinds say of themselves: python tools/reference FOLDER.

A file of this folder that has `pages` makes pages; it is found by itself. The site makes them anew each time it is
built (`docs/conf.py`). What has no text, or an example that does not run, is an error: nothing is passed over.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules

from reference.page import Page


def pages() -> list[Page]:
    """All pages in the order in which a reader meets them. Raises NothingSaid for what has no text."""
    files = sorted(module.name for module in iter_modules(__path__) if not module.name.startswith("_"))
    makers = [made for made in (import_module(f"{__name__}.{name}") for name in files) if hasattr(made, "pages")]
    return sorted((page for maker in makers for page in maker.pages()), key=lambda page: page.place)


def write(folder: Path) -> list[Path]:
    """Writes every page, its pictures and an index into a folder; what is not written any more is removed."""
    made = pages()
    contents: dict[str, str] = {f"{page.name}.md": page.text for page in made}
    for page in made:
        contents |= page.pictures
    contents["index.md"] = _index(made)
    folder.mkdir(parents=True, exist_ok=True)
    for old in set(_files(folder)) - {folder / name for name in contents}:
        old.unlink()
    for name, text in contents.items():
        _keep_or_write(folder / name, text)
    return [folder / name for name in contents]


def _files(folder: Path) -> Iterator[Path]:
    return (path for path in folder.rglob("*") if path.is_file())


def _keep_or_write(path: Path, text: str) -> None:
    """What is the same keeps its time, so that the site is not built anew."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def _index(made: list[Page]) -> str:
    listed = "\n".join(page.name for page in made)
    said = "\n".join(f"- [{page.title}]({page.name}.md): {page.about}" for page in made)
    return f"""# Reference

These pages are written by the program: every kind of thing says itself what it takes and what it means, and every
example on them was run when they were written.

{said}

```{{toctree}}
:hidden:

{listed}
```
"""
