"""What users wait for: whole processes of the installed program.

    python benchmarks/commands.py [--rounds N]

Seconds of wall clock and of the processor, the least of N rounds (5 unless said); all commands in turn in every round,
so that what else the machine does falls on all alike. The first two lines are what the others are measured by. At the
end the size of the environment that the program is installed in.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

EXAMPLES = Path(__file__).parents[1] / "examples"
# the eight systems of the exercise sheet, and those that take longest
EXPLAINED = (
    "atwood_machine",
    "body_on_driven_roller",
    "cardan_joint",
    "disk_on_angled_shaft",
    "disk_rolling_down_incline",
    "multi_bar_platform",
    "planetary_gear",
    "slider_crank",
    "sphere_launched_down_incline",
)
PROGRAM = (sys.executable, "-m", "freebody")


def commands(folder: Path) -> dict[str, tuple[str, ...]]:
    """Command lines by what stands in the table."""

    def on(name: str, command: str, *rest: str) -> tuple[str, ...]:
        return (*PROGRAM, command, str(EXAMPLES / f"{name}.yaml"), *rest)

    solved = ("atwood_machine", "four_bar", "planetary_gear", "cardan_joint", "ladder_rough_wall")
    return {
        "Python alone": (sys.executable, "-c", "pass"),
        "`import numpy`": (sys.executable, "-c", "import numpy"),
        "`--help`": (*PROGRAM, "--help"),
        **{f"`solve` {name}": on(name, "solve") for name in solved},
        "`simulate` four_bar, 10 s": on("four_bar", "simulate", "--until", "10s"),
        "`draw` four_bar": on("four_bar", "draw", "-o", str(folder / "picture.svg")),
        "`mobility` four_bar": on("four_bar", "mobility"),
        **{f"`explain` {name}, HTML": on(name, "explain", "-o", str(folder / "report.html")) for name in EXPLAINED},
    }


def once(command: tuple[str, ...], **environment: str) -> tuple[float, float]:
    """Seconds of wall clock and of the processor that a process takes. Raises CalledProcessError where it fails."""
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    nothing = subprocess.DEVNULL
    subprocess.run(command, check=True, stdout=nothing, stderr=nothing, env=os.environ | environment)
    wall, after = time.perf_counter() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5, metavar="N")
    rounds = parser.parse_args().rounds
    with tempfile.TemporaryDirectory() as folder:
        table = commands(Path(folder))
        times: dict[str, list[tuple[float, float]]] = {name: [] for name in table}
        for _round in range(rounds):
            for name, command in table.items():
                times[name].append(once(command))
    least = {name: (min(w for w, _c in found), min(c for _w, c in found)) for name, found in times.items()}
    unit = least["`import numpy`"][1]
    print("| | wall | processor | by `import numpy` |\n|---|---|---|---|")
    for name, (wall, cpu) in least.items():
        print(f"| {name} | {wall:.2f} s | {cpu:.2f} s | {cpu / unit:.1f} |")
    size = sum(path.stat().st_size for path in Path(sys.prefix).rglob("*") if path.is_file() and not path.is_symlink())
    print(f"\nEnvironment: {size / 1e6:.0f} MB")


if __name__ == "__main__":
    main()
