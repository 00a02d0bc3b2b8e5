"""Workers as the server sees them: one process a lane, one piece of work at a time.

Of a topic the latest request wins: one that waits is answered `replaced` when another comes; one that is being done
for longer than `_PATIENCE` is ended with its worker, since nobody waits for it any more; the same where its part of the
page is left. A worker that ends, is out of time or of memory is a reply, and the next request has a new worker.
"""

from __future__ import annotations

import asyncio
import json
import socket
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing.process import BaseProcess
from pathlib import Path

from freebody.studio import nursery
from freebody.studio.wire.around import Call, Reply
from freebody.studio.work import MOVING, PASSING, READING, WORK, Lane
from freebody.studio.worker import stand_aside, work

_PATIENCE = 0.5  # [s]
_LONGEST = 256 << 20  # [bytes] of an answer


@dataclass(eq=False)
class _Piece:
    """A call on its way. reply: in JSON"""

    call: Call
    reply: asyncio.Future[bytes]
    begun: float = 0.0


@dataclass(frozen=True, eq=False)
class Running:
    """A process, and the ends at which it is told and answers."""

    process: BaseProcess
    answers: asyncio.StreamReader
    calls: asyncio.StreamWriter

    async def ended(self) -> int | None:
        """When the process is gone: its exit code. Whoever waits for its answer hears of that from its end."""
        self.calls.close()
        await asyncio.to_thread(self.process.join)
        return self.process.exitcode


@dataclass(eq=False)
class Worker:
    """The process of a lane. folders: where the files are that models name"""

    lane: Lane
    folders: tuple[str, ...] = ()
    running: Running | None = None
    waiting: list[_Piece] = field(default_factory=list[_Piece])
    current: _Piece | None = None
    busy: str = ""
    _task: asyncio.Task[None] | None = None
    _start: asyncio.Task[None] | None = None
    _ending: dict[Running, asyncio.Task[int | None]] = field(default_factory=dict[Running, asyncio.Task[int | None]])

    async def ask(self, call: Call) -> bytes:
        """The `Reply` to a call in JSON, as the worker says it, when it is its turn."""
        loop = asyncio.get_running_loop()
        piece = _Piece(call, loop.create_future())
        self.leave(call.topic)
        self.waiting.append(piece)
        if self._task is None or self._task.done():
            self._task = asyncio.create_task(self._work())
        return await piece.reply

    def leave(self, topic: str, last: int | None = None) -> None:
        """Nobody waits any more for what is asked under a topic: what is nearly done may end by itself. last: the
        number of the last request that is meant, of all if nothing is said."""

        def is_left(piece: _Piece) -> bool:
            return piece.call.topic == topic and (last is None or piece.call.number <= last)

        for piece in [p for p in self.waiting if is_left(p)]:
            self._end(piece, Reply(status="replaced"))
        current, loop = self.current, asyncio.get_running_loop()
        if current is not None and is_left(current):
            loop.call_later(max(0.0, current.begun + _PATIENCE - loop.time()), self._overtake, current)

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
        if piece is self.current and self.running is not None:
            self._kill(self.running)

    def _kill(self, running: Running) -> asyncio.Task[int | None]:
        """Ends a process, which gives its exit code; the next request has another one, if it is not there already."""
        if self.running is running:
            self.running = None
        if running not in self._ending:
            running.process.kill()
            task = self._ending[running] = asyncio.get_running_loop().create_task(running.ended())
            task.add_done_callback(lambda _: self._ending.pop(running))
        return self._ending[running]

    async def _work(self) -> None:
        while self.waiting:
            self.current = piece = self.waiting.pop(0)
            piece.begun = asyncio.get_running_loop().time()
            try:
                reply = await self._done(piece)
            except Exception as error:  # whatever it is, whoever waits is told, and the next one has a new process
                if self.running is not None:
                    self._kill(self.running)
                reply = _said(Reply(status="crashed", message=f"{type(error).__name__}: {error}"))
            self.current, self.busy = None, ""
            if not piece.reply.done():
                piece.reply.set_result(reply)

    async def _done(self, piece: _Piece) -> bytes:
        try:
            running = await self.begun()
        except (EOFError, OSError) as error:  # it could not be started
            return _said(Reply(status="crashed", message=str(error)))
        if piece.reply.done():  # cancelled while the process started
            return b""
        try:
            return await asyncio.wait_for(self._answer(running, piece.call), self.lane.seconds)
        except TimeoutError:
            self._kill(running)
            return _said(Reply(status="too long", message=f"{self.lane.seconds:g}"))
        except (OSError, ValueError, asyncio.IncompleteReadError):
            return _said(Reply(status="crashed", message=str(await self._kill(running))))

    async def _answer(self, running: Running, call: Call) -> bytes:
        document = {"kind": call.kind, "request": call.request}
        running.calls.write(json.dumps(document).encode() + b"\n")
        await running.calls.drain()
        while True:
            line = await running.answers.readuntil(b"\n")
            if not line.startswith(b'{"busy"'):
                return line
            self.busy = str(json.loads(line)["busy"])

    async def begun(self) -> Running:
        """The process, started if there is none."""
        if self.running is not None and not self.running.process.is_alive():
            self._kill(self.running)
        while self.running is None:
            self.begin()
            assert self._start is not None
            await self._start
        return self.running

    def begin(self) -> None:
        """Lets the process start, if there is none."""
        if self.running is None and (self._start is None or self._start.done()):
            self._start = asyncio.create_task(self._started())

    async def _started(self) -> None:
        own, its = socket.socketpair()
        given = its, self.lane.name, self.lane.courtesy, self.folders
        process = await asyncio.to_thread(nursery.started, work, *given)
        its.close()
        self.running = Running(process, *await asyncio.open_connection(sock=own, limit=_LONGEST))

    def stand_aside(self) -> None:
        """Pauses what is done with courtesy, for a moment."""
        if self.lane.courtesy and self.current is not None and self.running is not None:
            assert self.running.process.pid is not None
            stand_aside(self.running.process.pid)

    async def end(self) -> None:
        """Ends what is being done, and the process."""
        for piece in [*self.waiting, *([self.current] if self.current else [])]:
            self._end(piece, Reply(status="cancelled"))
        for task in (self._task, self._start):
            if task is not None:
                with suppress(EOFError, OSError):  # of a start that was interrupted
                    await task
        if self.running is not None:
            self._kill(self.running)
        await asyncio.gather(*self._ending.values())


def _said(reply: Reply) -> bytes:
    return reply.model_dump_json().encode()


_DONE = b'{"status":"done"'  # how a reply begins that has an answer


class Lanes:
    """All workers, by their lanes. folders: where the files are that models name"""

    def __init__(self, *folders: Path) -> None:
        lanes = {lane.name: lane for lane in (*(work.lane for work in WORK.values()), PASSING)}
        self.workers = {name: Worker(lane, tuple(map(str, folders))) for name, lane in lanes.items()}
        self._foreseen: list[tuple[Call, asyncio.Task[bytes]]] = []

    def begin(self, foreseen: Iterable[Call] = ()) -> None:
        """Starts the workers of the first picture, which does not wait for them; the others come after it. foreseen:
        calls that will come, which are begun before they do; an answer hangs on nothing but its call."""
        nursery.begin()
        for lane in (READING, MOVING):
            self.workers[lane.name].begin()
        self._foreseen = [(call, asyncio.create_task(self._worker(call).ask(call))) for call in foreseen]

    def _worker(self, call: Call) -> Worker:
        lane = WORK[call.kind].lane
        return self.workers[(PASSING if lane is MOVING and call.request.get("is_passing") else lane).name]

    async def ask(self, call: Call) -> bytes:
        """The `Reply` to a call, in JSON. Raises KeyError for a kind that there is not."""
        for known, task in self._foreseen:
            if (known.kind, known.request) == (call.kind, call.request):
                reply = await asyncio.shield(task)
                if reply.startswith(_DONE):
                    return reply
        worker = self._worker(call)
        if call.kind == "drag" or call.request.get("is_passing"):  # a hand that moves something waits for its picture
            for other in self.workers.values():
                other.stand_aside()
            self.workers[MOVING.name].leave(call.topic)  # the motion of the text before
        if worker.lane not in (READING, MOVING, PASSING):  # the page goes on to what comes after its first picture
            for other in self.workers.values():
                if other.lane.is_ready:
                    other.begin()
        return await worker.ask(call)

    def cancel(self, topic: str) -> None:
        for worker in self.workers.values():
            worker.cancel(topic)

    def leave(self, topic: str, last: int | None = None) -> None:
        for worker in self.workers.values():
            worker.leave(topic, last)

    def busy(self) -> dict[str, str]:
        """What each topic that is being worked on is busy with."""
        working = [worker for worker in self.workers.values() if worker.current is not None]
        return {worker.current.call.topic: worker.busy for worker in working if worker.current is not None}

    async def end(self) -> None:
        await asyncio.gather(*(worker.end() for worker in self.workers.values()))
