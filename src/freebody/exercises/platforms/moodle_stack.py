"""STACK in Moodle: formulas that a computer algebra system compares, numbers with units, feedback for each mistake.

Source: docs.stack-assessment.org, "Authoring"; github.com/maths/moodle-qtype_stack.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from freebody.exercises.bank import Bank
from freebody.exercises.package import Package
from freebody.exercises.selftests import SelfTest, What
from freebody.exercises.stack.question import StackQuestion
from freebody.exercises.stack.reading import ReadPart, read_parts
from freebody.exercises.stack.writing import PLATFORM, ItemWriter
from freebody.exercises.stack.xml_file import questions_of, quiz
from freebody.language.sentences import Message
from freebody.narrative.telling.catalogue import Catalogue

NAME = "moodle-stack"
WHAT = "Moodle with STACK, which reads formulas"
FILE = "stack.xml"


def write(bank: Bank) -> Package:
    catalogue = Catalogue(bank.language)
    questions: list[StackQuestion] = []
    told: list[str] = []
    for item in bank.items:
        writer = ItemWriter(bank, item, catalogue)
        question = writer.question()
        told += writer.told
        if question is not None:
            questions.append(question)
    n = sum(bool(item.conditions) and item.name in {q.name for q in questions} for item in bank.items)
    if n:
        limit = Message(
            "{platform} does not ask for the conditions under which an answer holds; {n} answers have some",
            platform=PLATFORM,
            n=n,
        )
        told.append(limit)
    tests = tuple(test for question in questions for test in _self_tests(question))
    files = {FILE: quiz(bank.title, tuple(questions))}
    return Package(files, tuple(q.name for q in questions), tests, tuple(told))


def _self_tests(question: StackQuestion) -> Iterator[SelfTest]:
    """The tests that STACK runs itself, of each input under each seed, with what is typed spelled out."""
    nodes = {(tree.name, node.note): node for tree in question.trees for node in tree.nodes}
    for name, part in read_parts(question):
        for test in question.tests:
            if part.input.name in test.typed:
                node = nodes[part.tree.name, test.expected[part.tree.name].note]
                typed = part.typed(test.typed[part.input.name])
                what: What = (
                    "distractor" if not node.is_right else "key" if test.what.startswith("key") else "equivalent"
                )
                yield SelfTest(name, what, typed, "correct" if node.is_right else "incorrect", node.feedback)


def read(directory: Path) -> Mapping[str, ReadPart]:
    """The inputs of the questions of a file, under their seeds. Raises InputError for what STACK would refuse."""
    questions = questions_of((directory / FILE).read_bytes(), FILE)
    return {name: part for question in questions for name, part in read_parts(question)}


__all__ = ["FILE", "NAME", "WHAT", "read", "write"]
