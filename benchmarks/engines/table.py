"""Results as Markdown tables."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

Result = dict[str, Any]
UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "us"))


def seconds(value: float) -> str:
    """Three digits with a unit that suits them."""
    scale, unit = next(((s, u) for s, u in UNITS if value >= s), UNITS[-1])
    return f"{value / scale:.3g} {unit}"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    return ["| " + " | ".join(cells) + " |" for cells in (head, ["---"] * len(head), *rows)]


def _grid(results: list[Result], problem: str, cell: Callable[[Result], str], label: str) -> list[str]:
    """Engine and method down, sizes across."""
    chosen = [r for r in results if r["problem"] == problem]
    sizes = sorted({r["size"] for r in chosen})
    cells = {(r["engine"], _method(r), r["size"]): r for r in chosen}
    names = dict.fromkeys((engine, method) for engine, method, _ in cells if method or problem == "acceleration")
    rows: list[list[str]] = []
    for engine, method in names:
        found = [cells.get((engine, method, n)) or cells.get((engine, "", n)) for n in sizes]
        rows.append([f"{engine} {method}".strip(), *("" if r is None else cell(r) for r in found)])
    return _table(["", *(f"{label} = {n}" for n in sizes)], rows)


def _method(r: Result) -> str:
    asked = f" to {r['asked_m']:g} m" if r["problem"] == "N-four-bar" and "asked_m" in r else ""
    return r.get("method", "") + asked


def _acceleration(r: Result) -> str:
    return "not possible" if "note" in r else seconds(r["median_s"])


def _chain(r: Result) -> str:
    return "not met" if "note" in r else f"{seconds(r['median_s'])} ({r['setting']:.3g})"


def _four_bar(r: Result) -> str:
    return f"{seconds(r['median_s'])}, {r['error_m']:.1e} m ({r['setting']:.3g})" if "note" not in r else "not met"


def _fresh(results: list[Result]) -> list[str]:
    rows = [
        [r["engine"], r["note"], ""] if "note" in r else [r["engine"], seconds(r["median_s"]), f"{r['error_m']:.1e} m"]
        for r in results
        if r["problem"] == "fresh process"
    ]
    return _table(["", "time", "error"], rows)


def markdown(report: dict[str, Any]) -> str:
    """The whole report."""
    results, machine = report["results"], report["machine"]
    versions = ", ".join(f"{name} {version}" for name, version in report["versions"].items())
    lines = [
        f"Machine: {machine['processor']}, {machine['cores']} cores, {machine['system']}; one thread each.",
        f"Versions: {versions}. Medians of repeats, in brackets the number of steps or the tolerance.",
        "",
        "### One evaluation of the accelerations of a chain of n links",
        "",
        *_grid(results, "acceleration", _acceleration, "n"),
        "",
        "### One second of a chain of n links, every joint within 1e-6 m",
        "",
        *_grid(results, "chain second", _chain, "n"),
        "",
        "### Ten seconds of the N-four-bar: time and error of B0",
        "",
        *_grid(results, "N-four-bar", _four_bar, "N"),
        "",
        "### One-window four-bar, 10 s, from the start of a fresh process",
        "",
        *_fresh(results),
    ]
    notes = [f"- {r['problem']} {r['size']}, {r['engine']}: {r['note']}" for r in results if "note" in r]
    notes += [f"- {name} is not installed" for name in report["not_installed"]]
    return "\n".join([*lines, *(["", "Notes", "", *notes] if notes else []), ""])
