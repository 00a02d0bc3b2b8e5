"""Linkages that do a task: all candidates, the best of them certified, and what is wrong with the others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from freebody.errors import FreebodyError, InputError
from freebody.language.document import Document
from freebody.language.sentences import Message
from freebody.study.synthesis.candidates import candidates
from freebody.study.synthesis.certificate import Certificate, certified, seen_alike
from freebody.study.synthesis.linkage import Defect, Linkage
from freebody.study.synthesis.result import Candidate, Synthesis
from freebody.study.synthesis.tasks import Task, load_task, read_task
from freebody.study.worded import FAILED

MOST = 10  # candidates that are moved


def synthesise(
    task: str | Path | Mapping[str, Any] | Task, *, most: int = MOST, out: str | Path | None = None
) -> Synthesis:
    """The linkages of a task: a file, its data, or a `Task`.

    most: how many candidates become models that are followed all round, the best first; out: a folder for those of them
    that have no defect. Raises ModelError for a task that cannot be read, CannotAnswer where it determines none."""
    if most < 1:
        raise InputError(Message("at least one candidate is looked at, not {n}", n=most))
    if isinstance(task, Mapping):
        task = read_task(Document.from_plain(task))
    elif not isinstance(task, Task):
        task = load_task(task)
    found = candidates(task)
    made = [Candidate(linkage, tuple(_by_formula(task, linkage))) for linkage in found.linkages]
    made.sort(key=_rank)
    looked = [_looked_at(task, k, c) for k, c in enumerate(made[:most], 1)]
    looked.sort(key=_rank)
    result = Synthesis(task, found.dyads, (*looked, *made[most:]), found.about)
    return result if out is None else replace(result, files=tuple(result.write_models(Path(out))))


def _rank(c: Candidate) -> tuple[int, int, float, float]:
    """Good ones first, then by how near they come, then by how well the coupler drives the output; cognates that do so
    alike stay in their order, whatever rounding says."""
    return len(c.defects), 0 if c.certificate else 1, c.linkage.missed, -round(c.transmission, 6)


def _by_formula(task: Task, linkage: Linkage) -> Iterator[Defect]:
    yield from linkage.defects(full_turn=task.full_turn)
    if linkage.transmission < task.transmission:
        told = Message(
            "the transmission angle falls to {angle:.1f} deg; {least:.1f} deg are asked for",
            angle=linkage.transmission,
            least=task.transmission,
        )
        yield Defect(Message("transmission"), told)


def _looked_at(task: Task, k: int, candidate: Candidate) -> Candidate:
    """With its certificate: what the motion shows is added to the defects."""
    linkage = candidate.linkage
    try:
        certificate = certified(linkage, f"{task.title}, candidate {k}", full_turn=task.full_turn)
    except (FreebodyError, ValueError, *FAILED) as error:
        return replace(candidate, defects=(*candidate.defects, Defect(Message("not certified"), str(error))))
    return Candidate(linkage, tuple(_defects(linkage, candidate, certificate)), certificate)


def _defects(linkage: Linkage, candidate: Candidate, certificate: Certificate) -> list[Defect]:
    found = {d.name: d for d in (*certificate.defects, *candidate.defects)}
    if (other := seen_alike(linkage, certificate)) is not None:
        found[other.name] = other
    return list(found.values())
