"""The page of the studio in a browser: the first picture, and frames of 20 bodies while they play (`python
benchmarks/studio.py`, Chromium on the path, `pip install playwright`).

A frame is told twice: by the times between calls of requestAnimationFrame, which a busy machine makes longer, and by
the processor time of the page's main thread, which it does not. A frame at 60 a second may take 16.7 ms.
"""

from __future__ import annotations

import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from itertools import pairwise
from pathlib import Path
from typing import Any

N_BODIES, N_FRAMES, N_LOADS = 20, 180, 8
FRAMES = """n => new Promise((done) => {
  const times = [];
  const next = (time) => { times.push(time); times.length > n ? done(times) : requestAnimationFrame(next); };
  requestAnimationFrame(next);
})"""
DRAWN = """() => {
  const canvas = document.querySelector('.view canvas');
  return canvas && canvas.width > 300 && canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data
    .some((value) => value) ? performance.now() : false;
}"""


def chain(n: int) -> str:
    """A chain of rods that hangs at a slant."""
    bodies = "".join(f"  r{k}: {{rod: {{mass: 1 kg, length: 0.1 m}}}}\n" for k in range(n))
    pins = "".join(f"  c{k}: {{pin: [{f'r{k - 1}.end' if k else 'ground.A'}, r{k}.start]}}\n" for k in range(n))
    angles = ", ".join(f"a{k}: {{angle of r{k}}}" for k in range(n))
    start = ", ".join(f"a{k}: {-60 + 3 * k} deg" for k in range(n))
    loads = "loads: {weight: {gravity: 9.81 m/s^2}}"
    return f"bodies:\n{bodies}connections:\n{pins}{loads}\nmeasures: {{{angles}}}\nstart: {{{start}}}\n"


class Frames:
    """Frames of a page. milliseconds between two of them; processor: of the main thread in each [ms]"""

    def __init__(self, page: Any, n: int) -> None:
        session = page.context.new_cdp_session(page)
        session.send("Performance.enable", {"timeDomain": "threadTicks"})

        def processor() -> float:
            found = session.send("Performance.getMetrics")["metrics"]
            return next(1000.0 * each["value"] for each in found if each["name"] == "TaskDuration")

        before = processor()
        times = page.evaluate(FRAMES, n)
        self.processor = (processor() - before) / n
        self.milliseconds = [b - a for a, b in pairwise(times)]
        session.detach()

    def __str__(self) -> str:
        return f"median {statistics.median(self.milliseconds):.1f} ms a frame, {self.processor:.1f} ms of the processor"


def playing(page: Any, n: int) -> Frames:
    page.get_by_role("button", name="Play", exact=True).click()
    found = Frames(page, n)
    page.get_by_role("button", name="Pause", exact=True).click()
    page.focus(".view canvas")
    page.keyboard.press("Home")
    return found


def main() -> None:
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "chain.yaml"
        file.write_text(chain(N_BODIES), encoding="utf-8")
        command = [sys.executable, "-m", "freebody", "studio", str(file), "--no-browser"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server, sync_playwright() as running:
            assert server.stdout is not None
            try:
                browser = running.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
                page, address = browser.new_page(viewport={"width": 1500, "height": 900}), server.stdout.readline()
                firsts: list[float] = []
                for _ in range(N_LOADS):
                    page.goto("about:blank")
                    page.goto(address.strip())
                    firsts.append(page.wait_for_function(DRAWN, timeout=60_000).json_value())
                print(f"load {os.getloadavg()[0]:.0f} on {os.cpu_count()} cores, {N_BODIES} bodies")
                print(f"first picture: {firsts[0]:.0f} ms, then median {statistics.median(firsts[1:]):.0f} ms,")
                print(f"least {min(firsts):.0f} ms, from the address being opened")
                page.wait_for_selector(".badge.dof:not(.stale)", timeout=60_000)
                print("playing:", playing(page, N_FRAMES))
                browser.close()
            finally:
                server.terminate()


if __name__ == "__main__":
    main()
