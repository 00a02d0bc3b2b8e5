"""A finished picture, which every writer draws alike."""

from __future__ import annotations

from pathlib import Path

from freebody.errors import InputError
from freebody.present.files import write_whole
from freebody.present.picture.content import PictureContent

FORMATS = (".svg", ".png", ".pdf", ".tex")


class Picture(PictureContent):
    """A picture that writes itself."""

    def svg(self, *, dark: bool | None = None, is_marked: bool = False) -> str:
        """An SVG element of its own, whose colours follow a dark page unless `dark` says which to take. is_marked: with
        what its lines belong to, a body or a force, for pages that light them up"""
        from freebody.present.picture.svg import svg

        return svg(self, dark=dark, is_marked=is_marked)

    def tikz(self) -> str:
        """A tikzpicture, for which plain tikz is enough."""
        from freebody.present.picture.tikz import tikz

        return tikz(self)

    def png(self, *, dark: bool = False) -> bytes:
        from freebody.present.picture.pixels import rendered

        return rendered(self, "png", dark=dark)

    def pdf(self, *, dark: bool = False) -> bytes:
        from freebody.present.picture.pixels import rendered

        return rendered(self, "pdf", dark=dark)

    def __repr__(self) -> str:
        wide, tall = (self.corners[1] - self.corners[0]).tolist()
        return f"<Picture {self.title!r}: {wide:.0f} by {tall:.0f} pt>"

    def _repr_svg_(self) -> str:
        return self.svg()

    def text(self) -> str:
        """There is none for a terminal."""
        return ""

    def write(self, path: str | Path, *, dark: bool = False) -> Path:
        """Writes it by the suffix of the path: .svg, .png, .pdf, or .tex with a tikzpicture. Raises InputError for
        another suffix, or where it cannot be written."""
        path = checked_path(path)
        content: str | bytes
        match path.suffix.lower():
            case ".svg":
                content = '<?xml version="1.0" encoding="UTF-8"?>\n' + self.svg(dark=True if dark else None)
            case ".tex":
                content = self.tikz()
            case ".png":
                content = self.png(dark=dark)
            case _:
                content = self.pdf(dark=dark)
        write_whole(path, content)
        return path


def checked_path(path: str | Path) -> Path:
    """Raises InputError for a suffix that no picture has."""
    path = Path(path)
    if path.suffix.lower() not in FORMATS:
        raise InputError(f"{path.name}: a picture is written as {', '.join(FORMATS)}")
    return path
