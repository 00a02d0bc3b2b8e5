"""What a synthesis has found: dyads, candidates with their dimensions, defects by name, pictures and model files."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.present.files import replaced
from freebody.present.lines import number_text
from freebody.present.picture.picture import Picture
from freebody.present.report.blocks import Block, Figure, Report, Section, Text
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, summary, table
from freebody.study.synthesis.certificate import Certificate, model_text
from freebody.study.synthesis.curve_picture import curve_picture
from freebody.study.synthesis.linkage import Defect, Linkage
from freebody.study.synthesis.picture import linkage_picture
from freebody.study.synthesis.positions import Dyad
from freebody.study.synthesis.tasks import Task

_MOST_SHOWN = 12
_LINKAGES = {
    "four-bar": Message("four-bar"),
    "slider-crank": Message("slider-crank"),
    "inverted-slider-crank": Message("inverted slider-crank"),
}


@dataclass(frozen=True)
class Candidate:
    """A linkage with what is wrong with it; certificate: of the followed motion, where it was followed."""

    linkage: Linkage
    defects: tuple[Defect, ...]
    certificate: Certificate | None = None

    @property
    def is_good(self) -> bool:
        """Whether it is certified to do the task."""
        return not self.defects and self.certificate is not None

    @property
    def transmission(self) -> float:
        """The least angle [deg] at which the coupler drives the output."""
        return self.linkage.transmission

    @property
    def verdict(self) -> str:
        return "".join(map(str, self.told))

    @property
    def told(self) -> Text:
        """The verdict in pieces, each of which has its words in a language."""
        if self.defects:
            return tuple(piece for k, d in enumerate(self.defects) for piece in ((", ", d.name) if k else (d.name,)))
        return (Message("certified") if self.certificate is not None else Message("not followed"),)


@dataclass(frozen=True, repr=False)
class Synthesis(Result):
    """dyads: of which candidates are made; candidates: the best first; about: how complete they are."""

    task: Task
    dyads: tuple[Dyad, ...]
    candidates: tuple[Candidate, ...]
    about: str
    files: tuple[Path, ...] = ()

    @property
    def certified(self) -> tuple[Candidate, ...]:
        return tuple(c for c in self.candidates if c.is_good)

    @property
    def is_complete(self) -> bool:
        """Whether a candidate does the task."""
        return bool(self.certified)

    @property
    def is_searched(self) -> bool:
        """Whether the linkages of a path were not put together from dyads."""
        return self.task.kind == "path" and not self.dyads

    def write_models(self, folder: Path) -> list[Path]:
        """Each certified candidate as a model file, candidate_1.yaml first. Raises InputError where that cannot be."""
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(Message("{folder} cannot be written: {why}", folder=folder, why=error)) from error
        written: list[Path] = []
        for k, c in enumerate(self.certified, 1):
            path = folder / f"candidate_{k}.yaml"
            with replaced(path) as file:
                file.write_text(model_text(c.linkage, f"{self.task.title}, candidate {k}"), encoding="utf-8")
            written.append(path)
        return written

    # -- plain data ---------------------------------------------------------------------------
    def to_plain(self) -> dict[str, Any]:
        """Plain data: dyads, and candidates with their dimensions [m], pivots and defects."""
        return {
            "title": self.task.title,
            "task": self.task.kind,
            "linkage": self.task.linkage,
            "complete": str(self.about),
            "dyads": [
                {
                    "line" if d.is_line else "moving": _list(d.moving),
                    "direction" if d.is_slide else "fixed": _list(d.fixed),
                    "residual": d.residual,
                }
                for d in self.dyads
            ],
            "candidates": [self._plain(c) for c in self.candidates],
            "certified": len(self.certified),
        }

    def _plain(self, c: Candidate) -> dict[str, Any]:
        linkage = c.linkage
        points = {
            "A": linkage.A,
            "B": linkage.B[0],
            "C": linkage.C[0],
            "D": linkage.D,
            "P": None if linkage.P is None else linkage.P[0],
        }
        return {
            "lengths": linkage.lengths,
            "points": {name: _list(at) for name, at in points.items() if at is not None},
            "verdict": c.verdict,
            "case": c.certificate.case if c.certificate else None,
            "transmission_angle": c.transmission,
            "residual": linkage.residual,
            "missed": linkage.missed,
            "defects": [{"name": d.name, "reason": str(d.why)} for d in c.defects],
        }

    # -- report -------------------------------------------------------------------------------
    @property
    def report(self) -> Report:
        return summary(self.task.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        task = self.task
        yield from entries(
            entry(Message("task"), (self._asked(), ", ", _LINKAGES[task.linkage])),
            entry(Message("search") if self.is_searched else Message("dyads"), self.about),
            entry(
                Message("candidates"),
                Message("{n}, of which {k} certified", n=len(self.candidates), k=len(self.certified)),
            ),
        )
        yield from self._table(self.candidates[:_MOST_SHOWN])
        drawn = self.certified[:3]
        for k, c in enumerate(drawn, 1):
            told = Message("candidate {k}: {case}", k=k, case=c.certificate.case if c.certificate else "")
            yield Figure(self.picture(k), (told,), k)
        if self.has_curves:
            yield Figure(self.curves(), (Message("Burmester's curves of the four positions"),), len(drawn) + 1)

    def _asked(self) -> Message:
        n = self.task.n
        match self.task.kind:
            case "motion":
                return Message("motion generation, {n} positions", n=n)
            case "function":
                return Message("function generation, {n} pairs", n=n)
            case _:
                return Message("path generation, {n} points", n=n)

    def _table(self, shown: tuple[Candidate, ...]) -> Iterator[Block]:
        """Dimensions and verdicts, and what is wrong."""
        if not shown:
            return
        names = list(shown[0].linkage.lengths)

        def missed(c: Candidate) -> list[str]:
            return [f"{c.linkage.missed:.2g}"] if self.is_searched else []

        rows = [
            [
                str(k),
                *(number_text(x) for x in c.linkage.lengths.values()),
                f"{c.transmission:.1f}",
                *missed(c),
                c.told,
            ]
            for k, c in enumerate(shown, 1)
        ]
        yield Section(
            (Message("Candidates"),),
            tuple(
                table(
                    rows,
                    [
                        "",
                        *(f"{n} [m]" for n in names),
                        Message("transmission [deg]"),
                        *([Message("missed [m]")] if self.is_searched else []),
                        "",
                    ],
                )
            ),
        )
        said = [entry(str(k), *((d.name, ": ", d.why) for d in c.defects)) for k, c in enumerate(shown, 1) if c.defects]
        if said:
            yield Section((Message("Defects"),), tuple(entries(*said)))

    def picture(self, k: int = 1) -> Picture:
        """Candidate k, from 1, in all positions with its coupler curve. Raises InputError if there is none."""
        return linkage_picture(self.task.title, self._candidate(k).linkage)

    @property
    def has_curves(self) -> bool:
        """Whether the coupler has four positions, whose dyads lie on two curves."""
        return len(self.task.positions) == 4 and not self.is_searched

    def curves(self, k: int = 1) -> Picture:
        """Centre-point and circle-point curve of four positions, of a motion with the dyads of candidate k, from 1.
        Raises InputError if there are none."""
        task = self.task
        if not self.has_curves:
            raise InputError(Message("Burmester's curves belong to four positions of a coupler"))
        is_made_of_dyads = task.kind == "motion" and (k > 1 or self.candidates)
        linkage = self._candidate(k).linkage if is_made_of_dyads else None
        return curve_picture(task.title, task.positions, self.dyads, linkage)

    def _candidate(self, k: int) -> Candidate:
        if not 1 <= k <= len(self.candidates):
            raise InputError(Message("there is no candidate {k}; there are {n}", k=k, n=len(self.candidates)))
        return self.candidates[k - 1]


def _list(x: Array) -> list[float]:
    return [float(v) for v in np.asarray(x)]
