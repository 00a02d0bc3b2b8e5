"""A STACK question as its file has it: what both the writer and our own reader know of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

InputKind = Literal["algebraic", "units", "numerical", "radio"]


@dataclass(frozen=True)
class Input:
    """Where something is typed. answer: the right one, in Maxima; words: names of several letters that are allowed."""

    name: str
    kind: InputKind
    answer: str
    words: tuple[str, ...] = ()
    options: str = ""
    is_shown: bool = True  # what was read is shown before it counts


@dataclass(frozen=True)
class Node:
    """One test of a tree: of `given` against `wanted`. note: of the branch that is taken where they agree; feedback:
    CASText; is_right: full marks; is_quiet: STACK says nothing itself."""

    test: str
    given: str
    wanted: str
    note: str
    feedback: str = ""
    options: str = ""
    is_right: bool = False
    is_quiet: bool = True


@dataclass(frozen=True)
class Tree:
    """A tree of potential responses: node after node until one agrees. weight: its share of the marks; variables: of
    the feedback."""

    name: str
    nodes: tuple[Node, ...]
    variables: str = ""
    weight: float = 1.0

    def missed(self) -> str:
        """The note of an answer that agrees with no node."""
        return f"{self.name}-other"


@dataclass(frozen=True)
class Expected:
    """What a tree must give."""

    score: float
    note: str


@dataclass(frozen=True)
class QuestionTest:
    """A test that STACK runs itself. what: is typed, in words; typed: by input; expected: by tree."""

    what: str
    typed: Mapping[str, str]
    expected: Mapping[str, Expected]

    def and_also(self, other: QuestionTest | None) -> QuestionTest:
        """Both in one, of different inputs: STACK needs some seconds for each."""
        if other is None:
            return self
        what = self.what if self.what == other.what else f"{self.what}, {other.what}"
        return QuestionTest(what, {**self.typed, **other.typed}, {**self.expected, **other.expected})


@dataclass(frozen=True)
class StackQuestion:
    """name: unique; text, general, note: CASText; variables: in Maxima, a statement on each line; files,
    solution_files: of the text and of the general feedback, by name."""

    name: str
    text: str
    general: str
    variables: str
    note: str
    inputs: tuple[Input, ...]
    trees: tuple[Tree, ...]
    seeds: tuple[int, ...] = ()
    tests: tuple[QuestionTest, ...] = ()
    files: Mapping[str, bytes] | None = None
    solution_files: Mapping[str, bytes] | None = None
    grade: float = 1.0
    id: str = ""
