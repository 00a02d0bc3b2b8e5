"""Contact side by side: freebody, pymunk, MuJoCo.

    python benchmarks/contact/run.py [--quick] [--json results.json]

Peers that are not installed are left out with a note; they come with `pip install pymunk mujoco`. Times are of the
processor, without reading the model; of each the best of three.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.metadata
import importlib.util
import json
import math
import platform
from pathlib import Path
from typing import Any

import numpy as np
import scenes

ENGINES = {  # name: (module here, package to import)
    "freebody": ("freebody_contact", "freebody"),
    "pymunk": ("pymunk_peer", "pymunk"),
    "MuJoCo": ("mujoco_peer", "mujoco"),
}
SETTLING_STEPS = (1.0 / 200.0, 1.0 / 1000.0)
CREEP_STEP = 1.0 / 500.0
SPHERE_STEPS = tuple(1e-2 / 2**k for k in range(9))
NO_SLIP = 1e-4  # by the speed of the launch
WANTED = 2e-4  # relative error of time and speed at which the sphere begins to roll

Result = dict[str, Any]


def rolling_errors(found: Result) -> tuple[float, float]:
    """Relative errors of the time and the speed at the end of the first step without slip; infinite without one."""
    time, speed = scenes.rolling_begins()
    rolling = np.flatnonzero(np.abs(found["slip"]) < NO_SLIP * scenes.SPHERE_SPEED)
    if not len(rolling):
        return math.inf, math.inf
    k = rolling[0]
    return abs(found["times"][k] - time) / time, abs(found["speed"][k] - speed) / speed


def sphere(module: Any) -> list[Result]:
    """Errors and times of the sphere for 2 s, with ever shorter steps until both errors are small enough."""
    rows: list[Result] = []
    for step in SPHERE_STEPS:
        found = module.sphere(step)
        time_error, speed_error = rolling_errors(found)
        rows.append({"step": step, "seconds": found["seconds"], "time_error": time_error, "speed_error": speed_error})
        if max(time_error, speed_error) <= WANTED:
            break
    return rows


def compare(quick: bool) -> Result:
    results: list[Result] = []
    missing: list[str] = []
    for name, (module_name, package) in ENGINES.items():
        if importlib.util.find_spec(package) is None:
            missing.append(name)
            continue
        module = importlib.import_module(module_name)
        for step in SETTLING_STEPS[: 1 if quick else None]:
            results.append({"problem": "settling", "engine": name, "step": step} | module.settling(step))
        results.append({"problem": "creep", "engine": name, "step": CREEP_STEP, "creep_m": module.creep(CREEP_STEP)})
        results += [{"problem": "sphere", "engine": name} | row for row in sphere(module)]
        if hasattr(module, "sphere_by_events") and (row := module.sphere_by_events()) is not None:
            results.append({"problem": "sphere", "engine": f"{name}, events"} | row)
    versions = {"python": platform.python_version()}
    versions |= {p: importlib.metadata.version(p) for name, (_m, p) in ENGINES.items() if name not in missing}
    return {"versions": versions, "not_installed": missing, "results": results}


def markdown(report: Result) -> str:
    """The report as tables."""
    rows = report["results"]
    base = {r["step"]: r["seconds"] for r in rows if r["problem"] == "settling" and r["engine"] == "pymunk"}
    lines = [
        ", ".join(f"{name} {version}" for name, version in report["versions"].items()),
        "",
        f"### {scenes.N_CIRCLES} circles settle in a box, {scenes.SETTLING_TIME:g} s",
        "",
        "| | step | time | by pymunk's | penetration | speed at the end | |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]
    for r in rows:
        if r["problem"] == "settling":
            ratio = f"{r['seconds'] / base[r['step']]:.2f}" if r["step"] in base else ""
            figures = f"{r['step']:.4g} s | {r['seconds']:.3f} s | {ratio} | {r['penetration_m']:.1e} m"
            lines.append(f"| {r['engine']} | {figures} | {r['speed']:.1e} m/s | {r['note']} |")
    lines += ["", f"### A block that must hold, after {scenes.SLOPE_TIME:g} s", "", "| | step | creep |"]
    lines.append("| --- | --- | --- |")
    lines += [f"| {r['engine']} | {r['step']:g} s | {r['creep_m']:.1e} m |" for r in rows if r["problem"] == "creep"]
    lines += ["", f"### The sphere for {scenes.SPHERE_TIME:g} s", "", "| | step | time | error of T | error of v |"]
    lines.append("| --- | --- | --- | --- | --- |")
    for r in rows:
        if r["problem"] == "sphere":
            step = f"{r['step']:.3g} s" if "step" in r else ""
            errors = f"{r['time_error']:.1e} | {r['speed_error']:.1e}"
            lines.append(f"| {r['engine']} | {step} | {1e3 * r['seconds']:.2f} ms | {errors} |")
    lines += [f"- {name} is not installed" for name in report["not_installed"]]
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description="Contact side by side")
    parser.add_argument("--quick", action="store_true", help="one step of the settling circles only")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write all figures here")
    options = parser.parse_args()
    report = compare(options.quick)
    if options.json:
        options.json.write_text(json.dumps(report, indent=1))
    print(markdown(report))


if __name__ == "__main__":
    main()
