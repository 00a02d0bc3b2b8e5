"""Answers that take their time hold no connection: of these a browser has six to one server, for all of its windows.

What is not answered at once is promised under a number, and each window has one request under way that brings what is
ready of all that it was promised. A window that asks for nothing any more is gone, and nobody waits for its answers.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import count

from freebody.studio.wire.around import Call, Reply

AT_ONCE = 0.5  # [s]
_ASKED_AGAIN = 20.0  # [s] after which a window is told that nothing is ready
_GONE = 10.0  # [s] without a request


@dataclass(eq=False)
class _Window:
    """promised: by number, the topic and what will be answered; n_asking: requests under way"""

    promised: dict[str, tuple[str, asyncio.Task[bytes]]] = field(
        default_factory=dict[str, tuple[str, asyncio.Task[bytes]]]
    )
    is_ready: asyncio.Event = field(default_factory=asyncio.Event)
    n_asking: int = 0
    end: asyncio.TimerHandle | None = None


class LateAnswers:
    """What windows were promised. leave: says that nobody waits any more for a topic"""

    def __init__(self, leave: Callable[[str], None]) -> None:
        self._leave = leave
        self._windows: dict[str, _Window] = {}
        self._numbers = count(1)

    async def now_or_later(self, call: Call, answer: asyncio.Task[bytes]) -> bytes:
        """The answer to a call in JSON, or a promise of it; where the topic names no window, the answer."""
        name = call.topic.partition(".")[2]
        await asyncio.wait({answer}, timeout=AT_ONCE if name else None)
        if answer.done():
            return answer.result()
        window, number = self._windows.setdefault(name, _Window()), str(next(self._numbers))
        window.promised[number] = call.topic, answer
        answer.add_done_callback(lambda _: window.is_ready.set())
        self._expect(name, window)
        return Reply(status="later", message=number).model_dump_json().encode()

    async def ready(self, name: str) -> bytes:
        """By number what is ready of what a window was promised, in JSON, once something is; else nothing, after a
        while."""
        window = self._windows.setdefault(name, _Window())
        window.n_asking += 1
        self._expect(name, window)
        try:
            if not any(answer.done() for _topic, answer in window.promised.values()):
                window.is_ready.clear()
                async with asyncio.timeout(_ASKED_AGAIN):
                    await window.is_ready.wait()
        except TimeoutError:
            pass
        finally:
            window.n_asking -= 1
            self._expect(name, window)
        done = [number for number, (_topic, answer) in window.promised.items() if answer.done()]
        told = (f'"{number}":'.encode() + window.promised.pop(number)[1].result() for number in done)
        return b"{" + b",".join(told) + b"}"

    def left(self, name: str) -> None:
        """A window is gone."""
        window = self._windows.pop(name, None)
        for topic, _answer in [] if window is None else window.promised.values():
            self._leave(topic)

    def _expect(self, name: str, window: _Window) -> None:
        """That a window which is not asking asks again."""
        if window.end is not None:
            window.end.cancel()
        is_due = window.n_asking == 0 and self._windows.get(name) is window
        window.end = asyncio.get_running_loop().call_later(_GONE, self.left, name) if is_due else None
