"""What commands print."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from freebody.present.report.result import Result
    from freebody.system.system import System


def print_written(paths: Sequence[Path]) -> None:
    from freebody.language.plain_text import plain

    for path in paths:
        print(f"wrote {plain(str(path))}")


def check_out(out: Path | None) -> None:
    """Raises InputError if no report can be written there: before anything is computed."""
    if out is not None:
        from freebody.present.report.write import check_report_path

        check_report_path(out)


def print_result(
    found: Result,
    system: System | None,
    *,
    as_json: bool,
    as_latex: bool = False,
    out: Path | None = None,
    is_short: bool = False,
    asked: tuple[str, ...] = (),
) -> None:
    """A result as a report in a file, and as one JSON document, as LaTeX, or, where no file is written, as text; if it
    `is_short`, formulas that nobody would read by their size. asked: what was said of the model on the command line."""
    from freebody.present.busy import busy

    with busy("writing"):
        written = [] if out is None else found.write(out)
        text = found.to_latex() if as_latex else found.to_text(is_short=is_short) if not (written or as_json) else ""
    if as_json:
        print_json(_with_warnings(found.to_plain(), system, asked))
    elif text:
        print(text.rstrip("\n"), flush=True)
    else:
        print_written(written)


def _with_warnings(document: dict[str, Any], system: System | None, asked: tuple[str, ...]) -> dict[str, Any]:
    """A document with the warnings about its model, if there are any."""
    if system is None:
        return document
    from freebody.study.model_warnings import warnings_of

    told = [warning.to_plain() for warning in warnings_of(system, asked)]
    return {**document, "warnings": told} if told else document


def print_json(document: Any) -> None:
    """One document of plain JSON: what is no finite number is null."""
    from freebody.present.report.results import finite

    print(json.dumps(finite(document), indent=2, ensure_ascii=False, allow_nan=False))
