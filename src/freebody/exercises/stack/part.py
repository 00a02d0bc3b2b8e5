"""A part of a question: what is typed in one place and how it is judged."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.exercises.stack.question import Expected, Input, QuestionTest, Tree


@dataclass(frozen=True)
class Part:
    """variables: statements of Maxima; asked: CASText with the input; tests: those that STACK runs itself."""

    variables: tuple[str, ...]
    asked: str
    input: Input
    tree: Tree
    tests: tuple[QuestionTest, ...]


def place_of(name: str) -> str:
    """Where an input and what STACK read are shown."""
    return f"<p>[[input:{name}]]</p>[[validation:{name}]]"


def expected(what: str, input_: str, typed: str, tree: Tree, k: int) -> QuestionTest:
    """The test of an answer that agrees with the node k."""
    node = tree.nodes[k]
    return QuestionTest(what, {input_: typed}, {tree.name: Expected(1.0 if node.is_right else 0.0, node.note)})
