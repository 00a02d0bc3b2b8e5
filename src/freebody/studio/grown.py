"""What is imported once for all workers (`nursery`): all that the first picture needs, found by making one."""

from __future__ import annotations

import gc
import os
import signal

gc.disable()  # what is imported stays: looking through it for what may go takes a tenth of the time
os.environ.setdefault(
    "PYDANTIC_DISABLE_PLUGINS", "__all__"
)  # of other packages, for which all that is installed is read

from freebody.studio.worker import deaf_to_standing_aside, keep_to_one_core  # noqa: E402

signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server is told by the terminal, and this ends with it
deaf_to_standing_aside()
keep_to_one_core()

from freebody.studio.work import MOVING, READING, done, prepare  # noqa: E402  (what it imports reads the environment)

_ROD = """
parameters: {g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {A: {pin: [ground.A, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod}}
start: {theta: -60 deg}
questions: {it: acceleration of theta}
"""

prepare(READING.name)
prepare(MOVING.name)
done("read", {"text": _ROD})
for kind in ("motion", "curves"):
    done(kind, {"text": _ROD, "until": 0.1, "frames": 3})
gc.freeze()  # what is shared stays shared
gc.enable()
