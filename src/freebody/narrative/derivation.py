"""Worked solutions: what is derived for each question of a system."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.narrative.context import Method
from freebody.narrative.lines.script import DerivationStage
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.solution import Solution
from freebody.system.system import System


@dataclass(frozen=True)
class Derivation:
    """The worked solution of one question; `reason` where there is none. compared: by a second method, which ends in
    the same result."""

    question: Question
    answer: Answer
    stages: tuple[DerivationStage, ...]
    method: Method = "auto"
    reason: str = ""
    compared: tuple[DerivationStage, ...] = ()
    compared_method: Method = "auto"


@dataclass(frozen=True)
class WorkedSolutions:
    """All worked solutions of a system."""

    system: System
    solution: Solution
    opening: tuple[DerivationStage, ...]
    derivations: tuple[Derivation, ...]
    language: str = "en"
