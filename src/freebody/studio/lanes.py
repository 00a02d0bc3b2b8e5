"""Workers as the server sees them: one process a lane, one piece of work at a time.

Of a topic the latest request wins: one that waits is answered `replaced` when another comes; one that is being done for
longer than `_PATIENCE` is ended with its worker, since nobody waits for it any more. A worker that ends, is out of time
or of memory is a reply, and the next request has a new worker.
"""

from __future__ import annotations

import asyncio
import json
import os
import sys
from asyncio.subprocess import PIPE, Process
from contextlib import suppress
from dataclasses import dataclass, field

from freebody.studio.wire import Call, Reply
from freebody.studio.work import WORK, Lane

_PATIENCE = 0.5  # [s]
_LONGEST = 256 << 20  # [bytes] of an answer


@dataclass(eq=False)
class _Piece:
    """A call on its way. reply: in JSON"""

    call: Call
    reply: asyncio.Future[bytes]
    begun: float = 0.0


@dataclass(eq=False)
class Worker:
    """The process of a lane."""

    lane: Lane
    process: Process | None = None
    waiting: list[_Piece] = field(default_factory=list[_Piece])
    current: _Piece | None = None
    busy: str = ""
    _task: asyncio.Task[None] | None = None
    _ending: set[asyncio.Task[None]] = field(default_factory=set[asyncio.Task[None]])

    async def ask(self, call: Call) -> bytes:
        """The `Reply` to a call in JSON, as the worker says it, when it is its turn."""
        loop = asyncio.get_running_loop()
        piece = _Piece(call, loop.create_future())
        for other in [p for p in self.waiting if p.call.topic == call.topic]:
            self._end(other, Reply(status="replaced"))
        current = self.current
        if current is not None and current.call.topic == call.topic:
            loop.call_later(max(0.0, current.begun + _PATIENCE - loop.time()), self._overtake, current)
        self.waiting.append(piece)
        if self._task is None or self._task.done():
            self._task = asyncio.create_task(self._work())
        return await piece.reply

    def cancel(self, topic: str) -> None:
        """Ends what is asked under a topic."""
        for piece in [*self.waiting, *([self.current] if self.current else [])]:
            if piece.call.topic == topic:
                self._end(piece, Reply(status="cancelled"))

    def _overtake(self, piece: _Piece) -> None:
        if self.current is piece:
            self._end(piece, Reply(status="replaced"))

    def _end(self, piece: _Piece, reply: Reply) -> None:
        if piece in self.waiting:
            self.waiting.remove(piece)
        if not piece.reply.done():
            piece.reply.set_result(_said(reply))
        if piece is self.current:
            self._kill()

    def _kill(self) -> None:
        """Ends the process. The next request starts another one."""
        process, self.process = self.process, None
        if process is not None:
            with suppress(ProcessLookupError):
                process.kill()
            task = asyncio.get_running_loop().create_task(_ended(process))
            self._ending.add(task)
            task.add_done_callback(self._ending.discard)

    async def _work(self) -> None:
        while self.waiting:
            self.current = piece = self.waiting.pop(0)
            piece.begun = asyncio.get_running_loop().time()
            reply = await self._done(piece)
            self.current, self.busy = None, ""
            if not piece.reply.done():
                piece.reply.set_result(reply)

    async def _done(self, piece: _Piece) -> bytes:
        process = await self.begun()
        try:
            return await asyncio.wait_for(self._answer(process, piece.call), self.lane.seconds)
        except TimeoutError:
            self._kill()
            return _said(Reply(status="too long", message=f"{self.lane.seconds:g}"))
        except (OSError, ValueError, asyncio.IncompleteReadError):
            self._kill()
            return _said(Reply(status="crashed", message=str(await process.wait())))

    async def _answer(self, process: Process, call: Call) -> bytes:
        assert process.stdin is not None
        assert process.stdout is not None
        document = {"kind": call.kind, "request": call.request}
        process.stdin.write(json.dumps(document).encode() + b"\n")
        await process.stdin.drain()
        while True:
            line = await process.stdout.readuntil(b"\n")
            if not line.startswith(b'{"busy"'):
                return line
            self.busy = str(json.loads(line)["busy"])

    async def begun(self) -> Process:
        """The process, started if there is none."""
        if self.process is None or self.process.returncode is not None:
            alone = {f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL")}
            self.process = await asyncio.create_subprocess_exec(
                *(sys.executable, "-m", "freebody.studio.worker", self.lane.name, str(self.lane.courtesy)),
                stdin=PIPE,
                stdout=PIPE,
                limit=_LONGEST,
                env={**os.environ, **alone, "PYTHONIOENCODING": "utf-8"},
            )
        return self.process

    async def end(self) -> None:
        """Ends what is being done, and the process."""
        for piece in [*self.waiting, *([self.current] if self.current else [])]:
            self._end(piece, Reply(status="cancelled"))
        if self._task is not None:
            await self._task
        self._kill()
        await asyncio.gather(*self._ending)


def _said(reply: Reply) -> bytes:
    return reply.model_dump_json().encode()


async def _ended(process: Process) -> None:
    """When a process is gone. Whoever waits for its answer hears of that from the pipe."""
    if process.stdin is not None:
        process.stdin.close()
    await process.wait()


class Lanes:
    """All workers, by their lanes."""

    def __init__(self) -> None:
        lanes = {work.lane.name: work.lane for work in WORK.values()}
        self.workers = {name: Worker(lane) for name, lane in lanes.items()}

    async def begin(self) -> None:
        """Starts the workers, so that the first answers do not wait for them."""
        await asyncio.gather(*(worker.begun() for worker in self.workers.values()))

    async def ask(self, call: Call) -> bytes:
        """The `Reply` to a call, in JSON. Raises KeyError for a kind that there is not."""
        return await self.workers[WORK[call.kind].lane.name].ask(call)

    def cancel(self, topic: str) -> None:
        for worker in self.workers.values():
            worker.cancel(topic)

    def busy(self) -> dict[str, str]:
        """What each topic that is being worked on is busy with."""
        working = [worker for worker in self.workers.values() if worker.current is not None]
        return {worker.current.call.topic: worker.busy for worker in working if worker.current is not None}

    async def end(self) -> None:
        await asyncio.gather(*(worker.end() for worker in self.workers.values()))
