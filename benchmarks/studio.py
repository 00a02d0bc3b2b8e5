"""The studio, in its processes and in a browser: the first picture, frames of 20 bodies as they play and are dragged,
and how soon a motion of ten follows a slider (`python benchmarks/studio.py`, Chromium on the path, `pip install
playwright`; `python benchmarks/studio.py processor` tells the parts that need no browser).

All is told twice where it can be: by the clock, which a busy machine makes longer, and by the processor, which it does
less. A frame at 60 a second may take 16.7 ms. Modules are compiled once, as they are where the package is installed.
"""

from __future__ import annotations

import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path
from typing import Any

N_BODIES, N_FRAMES, N_STARTS, N_SLIDES = 20, 180, 5, 20
MODELS = ("atwood_machine", "four_bar", "slider_crank", "spinning_top")
EXAMPLES = Path(__file__).parents[1] / "examples"
WAIT = 120_000  # [ms]
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
# the colourful pixel of the scene that is farthest to the right, above the axes in the corner
RIGHTMOST = """() => {
  const canvas = document.querySelector('.view canvas'), box = canvas.getBoundingClientRect(), ratio = devicePixelRatio;
  const { data, width, height } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  for (let x = width - 1; x > 0; x--) for (let y = 0; y < height - 90 * ratio; y++) {
    const k = 4 * (y * width + x), of = [data[k], data[k + 1], data[k + 2]];
    if (data[k + 3] > 200 && Math.max(...of) - Math.min(...of) > 90) return [box.x + x / ratio - 3, box.y + y / ratio];
  }
}"""
# from the event of a slider to the picture of where the motion starts then, or of that motion
SLID = """(k) => new Promise((done) => {
  const slider = document.querySelector('.sliders input[type=range]'), ask = window.fetch;
  const clear = CanvasRenderingContext2D.prototype.clearRect, before = performance.now();
  let isThere = false;
  window.fetch = async (address, options) => {
    const reply = await ask(address, options);
    const kind = JSON.parse(options.body).kind;
    isThere ||= kind === 'motion' || (kind === 'start' && (await reply.clone().json()).answer?.columns);
    return reply;
  };
  CanvasRenderingContext2D.prototype.clearRect = function (...box) {
    clear.apply(this, box);
    if (!isThere || !this.canvas.closest('.view')) return;
    [CanvasRenderingContext2D.prototype.clearRect, window.fetch] = [clear, ask];
    queueMicrotask(() => done(performance.now() - before));
  };
  slider.value = Number(slider.value) + Number(slider.step) * (k % 2 ? 3 : -2);
  slider.dispatchEvent(new Event('input', { bubbles: true }));
})"""


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

    def __init__(self, page: Any, n: int, meanwhile: Callable[[], None] = lambda: None) -> None:
        session = page.context.new_cdp_session(page)
        session.send("Performance.enable", {"timeDomain": "threadTicks"})

        def processor() -> float:
            found = session.send("Performance.getMetrics")["metrics"]
            return next(1000.0 * each["value"] for each in found if each["name"] == "TaskDuration")

        before = processor()
        page.evaluate(f"n => void (window.frames_seen = ({FRAMES})(n))", n)
        meanwhile()
        times = page.evaluate("window.frames_seen")
        self.processor = (processor() - before) / n
        self.milliseconds = [b - a for a, b in pairwise(times)]
        session.detach()

    def __str__(self) -> str:
        told = (
            f"median {statistics.median(self.milliseconds):.1f} ms, p95 {part(self.milliseconds, 0.95):.1f} ms a frame"
        )
        return f"{told}, {self.processor:.1f} ms of the processor"


def part(values: list[float], share: float) -> float:
    """The value below which a share of them lies."""
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def playing(page: Any, n: int) -> Frames:
    page.get_by_role("button", name="Play", exact=True).click()
    found = Frames(page, n)
    page.get_by_role("button", name="Pause", exact=True).click()
    page.focus(".view canvas")
    page.keyboard.press("Home")
    return found


def dragged(page: Any, n: int) -> Frames:
    """The last of the bodies, round and round."""
    x, y = page.evaluate(RIGHTMOST)

    def round_and_round() -> None:
        page.mouse.move(x, y)
        page.mouse.down()
        for k in range(n // 2):
            page.mouse.move(x + 30 * math.sin(k / 8), y + 30 - 30 * math.cos(k / 8))
            page.wait_for_timeout(16)
        page.mouse.up()

    found = Frames(page, n, round_and_round)
    assert page.is_enabled("[aria-label=Undo]"), "nothing was dragged"
    return found


@contextmanager
def served(file: Path) -> Generator[tuple[str, float]]:
    """A studio: its address, and when it was printed."""
    command = [sys.executable, "-m", "freebody", "studio", str(file), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=compiled_once()) as server:
        assert server.stdout is not None
        try:
            yield server.stdout.readline().strip(), time.perf_counter()
        finally:
            server.terminate()


def compiled_once() -> dict[str, str]:
    """The environment in which what is imported is compiled once, and kept beside the sources or where that says."""
    return {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}


def processor_of(code: str) -> float:
    """The least processor time of a fresh Python that does something [ms]."""
    told = "import time; before = time.process_time(); {}; print(1000 * (time.process_time() - before))"
    command = [sys.executable, "-c", told.format(code)]
    runs = [subprocess.run(command, capture_output=True, text=True, check=True, env=compiled_once()) for _ in range(4)]
    return min(float(run.stdout) for run in runs)


def processor() -> None:
    """What a picture costs before it is in the browser."""
    print(f"imports of the server: {processor_of('import uvicorn, freebody.studio.server'):.0f} ms")
    print(f"imports of all workers, with one motion: {processor_of('import freebody.studio.grown'):.0f} ms")
    from freebody.studio import grown  # noqa: F401
    from freebody.studio.work import done

    of = {name: (EXAMPLES / f"{name}.yaml").read_text(encoding="utf-8") for name in MODELS}
    texts = {name: [text + k * "\n" for k in range(6)] for name, text in of.items()}
    texts["chain of ten"] = [chain(10).replace("a0: -60", f"a0: {-60 + k}") for k in range(12)]
    for name, variants in texts.items():
        asked = {"until": 3, "frames": 61 if "chain" in name else 301}
        kinds: list[tuple[str, dict[str, Any]]] = [("read", {}), ("motion", asked), ("curves", asked)]
        spent: dict[str, list[float]] = {kind: [] for kind, _more in kinds}
        sizes: dict[str, int] = {}
        for text in variants:
            for kind, more in kinds:
                before = time.process_time()
                sizes[kind] = len(done(kind, {"text": text, **more}).model_dump_json())
                spent[kind].append(1000.0 * (time.process_time() - before))
        for kind, times in spent.items():
            print(f"{name}, {kind}: first {times[0]:.0f} ms, least {min(times):.0f} ms, {sizes[kind] / 1000:.0f} kB")


def followed(page: Any) -> None:
    """Prints how soon, and at which cost to the page's main thread, the first slider is followed."""
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def main_thread() -> float:
        found = session.send("Performance.getMetrics")["metrics"]
        return next(1000.0 * each["value"] for each in found if each["name"] == "TaskDuration")

    slid: list[float] = []
    costs: list[float] = []
    for k in range(N_SLIDES):
        before = main_thread()
        slid.append(page.evaluate(SLID, k))
        costs.append(main_thread() - before)
        page.wait_for_timeout(700)
    told = f"median {statistics.median(slid):.0f} ms, least {min(slid):.0f} ms, p95 {part(slid, 0.95):.0f} ms"
    print(f"{N_BODIES // 2} bodies follow a slider: {told}; page {min(costs):.0f} ms of the processor")


def first_pictures(browser: Any, file: Path) -> str:
    """From the printed address to the first picture, of servers that have just started and of pages opened again."""
    cold: list[float] = []
    warm: list[float] = []
    for _ in range(N_STARTS):
        page = browser.new_context(viewport={"width": 1500, "height": 900}, locale="en-GB").new_page()
        with served(file) as (address, printed):
            for times in (cold, warm, warm):
                begun = printed if times is cold else time.perf_counter()
                page.goto(address)
                page.wait_for_function(DRAWN, timeout=WAIT, polling=10)
                times.append(time.perf_counter() - begun)
                page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
                page.goto("about:blank")
        page.context.close()
    told = [f"{statistics.median(times):.2f} s ({min(times):.2f} to {max(times):.2f})" for times in (cold, warm)]
    return f"{file.stem}: first {told[0]}, opened again {told[1]}"


def opened(browser: Any, address: str) -> Any:
    page = browser.new_page(viewport={"width": 1500, "height": 900}, locale="en-GB")
    page.goto(address)
    page.wait_for_selector(".badge.dof:not(.stale)", timeout=WAIT)
    page.wait_for_timeout(1000)
    return page


def main() -> None:
    print(f"load {os.getloadavg()[0]:.0f} on {os.cpu_count()} cores")
    processor()
    if sys.argv[1:] == ["processor"]:
        return
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as running:
        browser = running.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        for name in MODELS:
            print(first_pictures(browser, EXAMPLES / f"{name}.yaml"))
        file = Path(folder) / "chain.yaml"
        file.write_text(chain(N_BODIES), encoding="utf-8")
        with served(file) as (address, _):
            page = opened(browser, address)
            print(f"{N_BODIES} bodies, playing:", playing(page, N_FRAMES))
            print(f"{N_BODIES} bodies, dragged:", dragged(page, N_FRAMES))
        file.write_text(chain(N_BODIES // 2), encoding="utf-8")
        with served(file) as (address, _):
            followed(opened(browser, address))
        browser.close()


if __name__ == "__main__":
    main()
