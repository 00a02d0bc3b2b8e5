"""Writes tests/long_tests.txt: what takes so long that only the slow part of the tests has it.

    python tools/list_long_tests.py [--times FILE]

Times are those of the processor, so that a busy machine lists the same. A case is long from LONG on, but for the
shortest of each test, as long as that takes less than LONG_ALONE; an example is long, with all its cases, from
LONG_EXAMPLE on, but for those of the exercise sheet, which are in every run. `--times` takes the times of an earlier
run instead of running the tests.
"""

from __future__ import annotations

import argparse
import time
from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
LIST = ROOT / "tests" / "long_tests.txt"
SHEET = {
    *("multi_bar_platform", "body_on_driven_roller", "disk_rolling_down_incline", "sphere_launched_down_incline"),
    *("planetary_gear", "atwood_machine", "disk_on_angled_shaft", "cardan_joint"),
}
LONG, LONG_ALONE, LONG_EXAMPLE = 0.15, 1.0, 5.0  # [s]
HEAD = "# Left to the slow part of the tests; written by tools/list_long_tests.py from times of the processor.\n"


class Times:
    """What each test costs, with what is made for it: a line for each in a file."""

    def __init__(self, path: Path) -> None:
        self._file = path.open("w", encoding="utf-8")
        self._last = time.process_time()

    @pytest.hookimpl(trylast=True)
    def pytest_runtest_logfinish(self, nodeid: str) -> None:
        now = time.process_time()
        self._file.write(f"{now - self._last:.3f}\t{nodeid}\n")
        self._file.flush()
        self._last = now


def read(path: Path) -> dict[str, float]:
    """Seconds by test."""
    lines = (line.split("\t") for line in path.read_text(encoding="utf-8").splitlines())
    return {test: float(seconds) for seconds, test in lines}


def long_ones(times: dict[str, float], examples: set[str]) -> list[str]:
    """What is listed: examples first, then tests."""
    by_example: dict[str, float] = defaultdict(float)
    cases: dict[str, list[tuple[float, str]]] = defaultdict(list)
    for test, seconds in times.items():
        function, _, case = test.partition("[")
        if (name := case.rstrip("]").partition("-")[0]) in examples:
            by_example[name] += seconds
        else:
            cases[function].append((seconds, test))
    found = [
        f"example {name}"
        for name, seconds in sorted(by_example.items())
        if seconds > LONG_EXAMPLE and name not in SHEET
    ]
    for own in cases.values():
        (shortest, alone), *more = sorted(own)
        found += [alone] if shortest > LONG_ALONE else []
        found += [test for seconds, test in more if seconds > LONG]
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=Path)
    path = parser.parse_args().times
    if path is None:
        path = ROOT / "build" / "test_times.tsv"
        path.parent.mkdir(exist_ok=True)
        LIST.write_text(HEAD, encoding="utf-8")  # all of them are timed
        pytest.main(["-q", "-o", "addopts=", "-m", "not slow", str(ROOT / "tests")], plugins=[Times(path)])
    examples = {example.stem for example in (ROOT / "examples").glob("*.yaml")}
    listed = sorted(long_ones(read(path), examples))
    LIST.write_text(HEAD + "".join(f"{line}\n" for line in listed), encoding="utf-8")
    print(f"{len(listed)} entries in {LIST.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
