"""Writing a report into a file: its name says the format."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from pathlib import Path

from freebody.errors import InputError
from freebody.present.files import check_writable, write_whole
from freebody.present.report.blocks import Report

FORMATS = {
    ".html": "a web page",
    ".md": "Markdown, with the drawings in a folder beside it",
    ".tex": "LaTeX",
    ".pdf": "PDF",
    ".ipynb": "a Jupyter notebook",
    ".txt": "text",
}


def check_report_path(path: Path | str) -> None:
    """Raises InputError if no report can be written there: before anything is computed."""
    path = Path(path)
    if path.suffix.lower() not in FORMATS:
        known = ", ".join(f"{suffix} ({what})" for suffix, what in FORMATS.items())
        close = difflib.get_close_matches(path.suffix.lower(), FORMATS, n=1, cutoff=0.5)
        meant = f"; did you mean {path.with_suffix(close[0]).name}?" if close and path.suffix else ""
        raise InputError(f"{path}: the name of a report must end in one of {known}{meant}")
    check_writable(path)
    if path.suffix.lower() == ".md":
        folder = _figures_folder(path)
        if folder.exists() and not folder.is_dir():
            raise InputError(f"{folder}: the drawings go into a folder of this name, but there is a file. Rename one")
    if path.suffix.lower() == ".pdf":
        from freebody.present.report.typst import check_typst

        check_typst()


def write_report(report: Report, path: Path | str, *, code: str = "") -> list[Path]:
    """Writes a report in the format that the name of the file says (FORMATS), and returns the files written. code: for
    a notebook, what its first cell runs. Raises InputError if it cannot be written."""
    path = Path(path)
    check_report_path(path)
    written: list[Path] = []
    for place, content in _contents(report, path, code):
        try:
            place.parent.mkdir(exist_ok=True)
        except OSError as error:
            raise InputError(f"{place.parent} cannot be made: {error.strerror}") from error
        write_whole(place, content)
        written.append(place)
    return written


def _contents(report: Report, path: Path, code: str) -> Sequence[tuple[Path, bytes]]:
    """The files and what is in them."""
    match path.suffix.lower():
        case ".html":
            from freebody.present.report.html import html_page

            text = html_page(report)
        case ".md":
            from freebody.present.report.markdown import markdown_files

            text, drawings = markdown_files(report, path.stem)
            return [(path, text.encode()), *((path.parent / name, svg.encode()) for name, svg in drawings.items())]
        case ".tex":
            from freebody.present.report.latex import latex_document

            text = latex_document(report)
        case ".pdf":
            from freebody.present.report.typst import pdf_bytes

            return [(path, pdf_bytes(report))]
        case ".ipynb":
            from freebody.present.report.notebook import notebook_text

            text = notebook_text(report, code=code)
        case _:
            from freebody.present.report.terminal import terminal_text

            text = terminal_text(report)
    return [(path, text.encode())]


def _figures_folder(path: Path) -> Path:
    return path.with_name(f"{path.stem}-figures")
