"""Writing a report into a file: its name says the format."""

from __future__ import annotations

import difflib
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules

from freebody.errors import InputError
from freebody.present.files import check_writable, write_whole
from freebody.present.report import formats
from freebody.present.report.blocks import Report
from freebody.present.report.writer import ReportFormat


def report_formats() -> dict[str, ReportFormat]:
    """All that there are, by the suffix of a file."""
    for module in iter_modules(formats.__path__):
        import_module(f"{formats.__name__}.{module.name}")
    return dict(sorted(ReportFormat.known.items(), key=lambda found: found[1].place))


def check_report_path(path: Path | str) -> ReportFormat:
    """The format of a file. Raises InputError if no report can be written there: before anything is computed."""
    path, known = Path(path), report_formats()
    found = known.get(path.suffix.lower())
    if found is None:
        listed = ", ".join(f"{suffix} ({each.what})" for suffix, each in known.items())
        close = difflib.get_close_matches(path.suffix.lower(), known, n=1, cutoff=0.5)
        meant = f"; did you mean {path.with_suffix(close[0]).name}?" if close and path.suffix else ""
        raise InputError(f"{path}: the name of a report must end in one of {listed}{meant}")
    check_writable(path)
    found.check(path)
    return found


def write_report(report: Report, path: Path | str, *, code: str = "") -> list[Path]:
    """Writes a report in the format that the name of the file says (`report_formats`), and returns the files written.
    code: for a notebook, what its first cell runs. Raises InputError if it cannot be written."""
    path = Path(path)
    written: list[Path] = []
    for place, content in check_report_path(path).files(report, path, code):
        try:
            place.parent.mkdir(exist_ok=True)
        except OSError as error:
            raise InputError(f"{place.parent} cannot be made: {error.strerror}") from error
        write_whole(place, content)
        written.append(place)
    return written
