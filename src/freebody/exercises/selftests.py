"""Self-tests of a package: answers whose verdict is known, put to what a reader of its format finds in it.

They lie beside the package as `selftests.json`, so that it can be examined again by anybody: the right answer, other
ways to write it, and every wrong answer with what is said about it.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Literal, Protocol, cast

from freebody.errors import InputError
from freebody.language.plain_text import plain, shortened
from freebody.language.sentences import Message

FILE = "selftests.json"
What = Literal["key", "equivalent", "distractor"]
Judged = Literal["correct", "incorrect"]


@dataclass(frozen=True)
class SelfTest:
    """question: its name in the package; response: as the platform takes it; feedback: what must be said about it, in
    the markup of the platform, empty where nothing need be."""

    question: str
    what: What
    response: str
    verdict: Judged
    feedback: str = ""


@dataclass(frozen=True)
class Marked:
    """What a platform says to a response, as far as its package tells."""

    verdict: Judged
    feedback: str = ""


class ReadQuestion(Protocol):
    """A question as it was read from a package."""

    def mark(self, response: str) -> Marked:
        """Raises InputError for a response that the question does not take."""
        ...


@dataclass(frozen=True)
class Failure:
    """A self-test with another outcome than it should have. why: in words."""

    test: SelfTest
    why: str


def failures(questions: Mapping[str, ReadQuestion], tests: Sequence[SelfTest]) -> list[Failure]:
    """The tests that fail, and questions without a test of their key."""
    found = [Failure(test, why) for test in tests if (why := _failing(questions, test))]
    tested = {test.question for test in tests if test.what == "key"}
    for name in questions:
        if name not in tested:
            found.append(Failure(SelfTest(name, "key", "", "correct"), Message("it has no self-test of its key")))
    return found


def _failing(questions: Mapping[str, ReadQuestion], test: SelfTest) -> str:
    """Why a test fails; nothing where it does not."""
    question = questions.get(test.question)
    if question is None:
        return Message("the package has no such question")
    try:
        marked = question.mark(test.response)
    except InputError as error:
        return str(error)
    if marked.verdict != test.verdict:
        return Message("it is marked {its} and should be {wanted}", its=marked.verdict, wanted=test.verdict)
    if test.feedback and marked.feedback != test.feedback:
        return Message("another feedback is given to it")
    return ""


def told(failure: Failure) -> str:
    return Message(
        "{question}, {what} '{response}': {why}",
        question=failure.test.question,
        what=failure.test.what,
        response=shortened(plain(failure.test.response), 80),
        why=failure.why,
    )


# -- the file ---------------------------------------------------------------------------------
def written(platform: str, tests: Sequence[SelfTest]) -> bytes:
    document = {"format": "freebody self-tests 1", "platform": platform, "tests": [asdict(test) for test in tests]}
    return (json.dumps(document, ensure_ascii=False, indent=1) + "\n").encode()


def read(content: bytes) -> tuple[str, tuple[SelfTest, ...]]:
    """The platform and the tests. Raises InputError for a file that has none."""
    try:
        document = cast("dict[str, Any]", json.loads(content))
        tests = tuple(SelfTest(**test) for test in document["tests"])
        return str(document["platform"]), tests
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(Message("{file} cannot be read: {why}", file=FILE, why=type(error).__name__)) from error
