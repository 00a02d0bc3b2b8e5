"""A page of the reference, and the Markdown that it is made of."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

_CODE = re.compile(r"(`[^`]*`)")


class NothingSaid(Exception):
    """A kind without a text, or without an example that runs."""


@dataclass(frozen=True)
class Page:
    """place: a number by which pages are put in order; pictures: by their path below the page."""

    name: str
    title: str
    about: str
    place: int
    text: str
    pictures: Mapping[str, str] = field(default_factory=dict[str, str])


def words_of(of: object, what: str) -> str:
    """The docstring as Markdown. Raises NothingSaid where there is none."""
    text = inspect.cleandoc(getattr(of, "__doc__", None) or "")
    if not text:
        raise NothingSaid(f"{what} has no docstring, so there is nothing to say of it")
    return prose(text)


def first_paragraph(text: str) -> str:
    return text.partition("\n\n")[0]


def prose(text: str) -> str:
    """Plain text with code between backticks as Markdown: what Markdown would read otherwise is escaped."""
    parts = _CODE.split(text)
    return "".join(part if k % 2 else re.sub(r"([*<>$\[\]_{}])", r"\\\1", part) for k, part in enumerate(parts))


def code(text: str) -> str:
    """Code within a line."""
    return f"`{text}`"


def block(language: str, text: str) -> str:
    return f"```{language}\n{text.strip()}\n```"


def table(header: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """No table without rows."""
    cells = [[cell.replace("|", r"\|").replace("\n", " ") for cell in row] for row in rows]
    if not cells:
        return ""
    head = list(header)
    lines = [head, ["---"] * len(head), *cells]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def picture(path: str, said: str) -> str:
    """A drawing that stands in two colours: NAME-light.svg and NAME-dark.svg."""
    return "\n\n".join(
        f"```{{image}} {path}-{paper}.svg\n:alt: {said}\n:class: only-{paper}\n```" for paper in ("light", "dark")
    )


def joined(parts: Iterable[str]) -> str:
    """Blocks, one below the other."""
    return "\n\n".join(part.strip() for part in parts if part.strip()) + "\n"
