"""Answers that take their time hold no connection, and what nobody waits for any more is ended."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable, Coroutine
from typing import Any

import pytest

pytest.importorskip("starlette")

from freebody.studio import late
from freebody.studio.lanes import Worker
from freebody.studio.late import LateAnswers
from freebody.studio.wire.around import Call, Reply
from freebody.studio.work import Lane

DONE = b'{"status":"done","message":"","answer":1}'


def call_of(topic: str, number: int = 0) -> Call:
    return Call(kind="read", topic=topic, request={"text": "title: a"}, number=number)


async def answered(when: asyncio.Event) -> bytes:
    await when.wait()
    return DONE


def run(work: Callable[[], Coroutine[Any, Any, None]]) -> None:
    asyncio.run(work())


@pytest.fixture
def in_no_time(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, seconds in (("AT_ONCE", 0.02), ("_ASKED_AGAIN", 0.3), ("_GONE", 30.0)):
        monkeypatch.setattr(late, name, seconds)


def test_what_is_found_at_once_is_answered_at_once() -> None:
    async def work() -> None:
        when = asyncio.Event()
        when.set()
        answers = LateAnswers(lambda _topic: None)
        assert await answers.now_or_later(call_of("read.one"), asyncio.create_task(answered(when))) == DONE

    run(work)


@pytest.mark.usefixtures("in_no_time")
def test_one_request_brings_all_that_a_window_was_promised_and_nothing_else() -> None:
    async def work() -> None:
        first, second = asyncio.Event(), asyncio.Event()
        answers = LateAnswers(lambda _topic: None)
        promised = [
            Reply.model_validate_json(await answers.now_or_later(call_of(topic), asyncio.create_task(answered(when))))
            for topic, when in (("study.one", first), ("marks.one", second), ("study.two", second))
        ]
        assert [reply.status for reply in promised] == ["later"] * 3
        assert json.loads(await answers.ready("one")) == {}  # after a while
        asking = asyncio.create_task(answers.ready("one"))
        await asyncio.sleep(0)
        first.set()
        assert json.loads(await asking) == {promised[0].message: json.loads(DONE)}
        second.set()
        await asyncio.sleep(0.001)
        assert json.loads(await answers.ready("one")) == {promised[1].message: json.loads(DONE)}
        assert json.loads(await answers.ready("two")) == {promised[2].message: json.loads(DONE)}

    run(work)


@pytest.mark.usefixtures("in_no_time")
def test_a_window_that_asks_no_more_is_gone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(late, "_GONE", 0.3)

    async def work() -> None:
        left, when = list[str](), asyncio.Event()
        answers = LateAnswers(left.append)
        await answers.now_or_later(call_of("study.one"), asyncio.create_task(answered(when)))
        assert left == []
        await asyncio.sleep(0.6)
        assert left == ["study.one"]
        when.set()

    run(work)


def test_whoever_names_no_window_gets_the_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(late, "AT_ONCE", 0.001)

    async def work() -> None:
        when = asyncio.Event()
        asyncio.get_running_loop().call_later(0.02, when.set)
        assert (
            await LateAnswers(lambda _topic: None).now_or_later(call_of("read"), asyncio.create_task(answered(when)))
            == DONE
        )

    run(work)


def test_what_is_left_before_something_is_asked_is_not_that() -> None:
    """Two requests of a page may arrive in the other order."""

    async def work() -> None:
        worker = Worker(Lane("test", 30))
        asked = [
            asyncio.create_task(worker.ask(call_of(topic, n)))
            for topic, n in (("a.one", 1), ("b.one", 2), ("b.one", 4))
        ]
        await asyncio.sleep(0)
        worker.leave("b.one", 3)
        statuses = [Reply.model_validate_json(reply).status for reply in await asyncio.gather(*asked)]
        assert statuses == ["done", "replaced", "done"]
        await worker.end()

    run(work)
