"""Linkages to a task, told in a language."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.reports import ReportTeller
from freebody.study.synthesis.result import Synthesis
from freebody.study.synthesis.synthesise import MOST
from freebody.study.synthesis.synthesise import synthesise as found_by
from freebody.study.synthesis.tasks import Task


def synthesise(
    task: str | Path | Mapping[str, Any] | Task,
    *,
    most: int = MOST,
    out: str | Path | None = None,
    language: str = "en",
) -> Synthesis:
    """The linkages of a task: a file, its data, or a `Task`.

    most: how many candidates become models that are followed all round, the best first; out: a folder for those of them
    that have no defect; language: in which the result is told. Raises ModelError for a task that cannot be read,
    CannotAnswer where it determines none."""
    Catalogue(language)  # that there are no words of it is told before anything is computed
    found = found_by(task, most=most, out=out)
    return found if language == "en" else found.told_by(ReportTeller(language))
