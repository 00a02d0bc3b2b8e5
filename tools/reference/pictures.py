"""Pictures of the models that pages show: each model with a name is drawn below its text when the site is built."""

from __future__ import annotations

import re
from pathlib import Path

import freebody as fb
from freebody.errors import FreebodyError
from reference.page import picture

_MODEL = re.compile(r"^```yaml\n# (?P<name>\w+)\.yaml\n(?P<text>.*?)^```$", re.DOTALL | re.MULTILINE)
_PAPERS = ("light", "dark")


def with_pictures(page: str, text: str, folder: Path) -> str:
    """The text of a page with its models drawn. folder: where the drawings are written, seen from all pages as
    /pictures. A model that cannot be drawn stands alone."""

    def shown(found: re.Match[str]) -> str:
        name = f"{page.replace('/', '-')}-{found['name']}"
        try:
            draw(fb.System.from_text(found["text"]), name, folder)
        except FreebodyError:
            return found.group()
        said = f"The model {found['name']} as freebody draws it"
        return f"{found.group()}\n\n{picture(f'/pictures/{name}', said)}"

    return _MODEL.sub(shown, text)


def draw(system: fb.System, name: str, folder: Path) -> None:
    """Writes NAME-light.svg and NAME-dark.svg."""
    folder.mkdir(parents=True, exist_ok=True)
    drawn = system.picture()
    for paper in _PAPERS:
        (folder / f"{name}-{paper}.svg").write_text(drawn.svg(dark=paper == "dark"), encoding="utf-8")
