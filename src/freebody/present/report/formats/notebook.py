"""A report as a Jupyter notebook: a cell for each part, mathematics in LaTeX, drawings attached to their cells.

Source: The Jupyter Notebook Format, nbformat 4.5.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from freebody.language.plain_text import plain
from freebody.present.report.blocks import Block, Figure, Report, Section
from freebody.present.report.formats.markdown import MarkdownWriter
from freebody.present.report.writer import ReportFormat, in_its_decimals


@in_its_decimals
def notebook_text(report: Report, *, code: str = "") -> str:
    """The text of an .ipynb. code: what the first cell runs, as the loading of the system; without, no such cell."""
    cells: list[dict[str, Any]] = []
    attached: dict[str, Any] = {}

    def place(figure: Figure) -> str:
        # PNG: notebooks show no attached SVG.
        name = f"figure-{figure.number}.png"
        attached[name] = {"image/png": base64.b64encode(figure.picture.png()).decode()}
        return f"attachment:{name}"

    writer = MarkdownWriter(report, place, has_alerts=False)

    def add(text: str) -> None:
        cell: dict[str, Any] = {"cell_type": "markdown", "metadata": {}, "source": _lines(text)}
        if attached:
            cell["attachments"] = dict(attached)
            attached.clear()
        cells.append(cell)

    add(writer.heading())
    if code.strip():
        empty = {"execution_count": None, "outputs": list[Any]()}
        cells.append({"cell_type": "code", "metadata": {}, "source": _lines(code.strip("\n")), **empty})
    for group in _groups(report.blocks):
        add(writer.blocks(group))
    numbered = [{"id": f"cell-{k}", **cell} for k, cell in enumerate(cells)]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    metadata = {"kernelspec": kernel, "language_info": {"name": "python"}, "title": plain(report.title)}
    notebook = {"cells": numbered, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(notebook, ensure_ascii=False, indent=1) + "\n"


def _groups(blocks: Sequence[Block]) -> Iterator[Sequence[Block]]:
    """Blocks for one cell each: a section by itself, what stands between sections together."""
    between: list[Block] = []
    for block in blocks:
        if isinstance(block, Section):
            if between:
                yield between
            between = []
            yield (block,)
        else:
            between.append(block)
    if between:
        yield between


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


def _files(report: Report, path: Path, code: str) -> Sequence[tuple[Path, bytes]]:
    return [(path, notebook_text(report, code=code).encode())]


ReportFormat(".ipynb", "a Jupyter notebook", _files, place=4)
