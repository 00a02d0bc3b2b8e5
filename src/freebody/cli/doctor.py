"""What is installed, which kernels run, where things are kept, and whether an answer comes out right."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Iterator
from importlib import import_module, metadata
from importlib.util import find_spec
from pathlib import Path

import typer

# what each extra brings, by the module that must be there
_EXTRAS = {
    "studio": ("starlette", "a model in the browser"),
    "report": ("typst", "reports as .pdf"),
    "data": ("xarray", "motions as .nc and as datasets"),
    "parquet": ("pyarrow", "motions as .parquet"),
    "ensemble": ("numba", "sweeps by compiled equations"),
    "gpu": ("numba_cuda", "the same on graphics cards"),
    "mesh": ("trimesh", "bodies from files of triangles"),
    "jit": ("numba", "kernels translated anew"),
}
_CHECK = """
parameters: {m: 2 kg, F: 10 N}
bodies: {block: {particle: {mass: m}}}
connections: {table: {slider: {body: block, along: right}}}
loads: {pull: {force: {at: block, along: right, magnitude: F}}}
measures: {x: x of block}
"""


def doctor() -> None:
    """Tell what is installed, which kernels run and where they are, and check one answer."""
    from freebody.language.plain_text import plain

    is_well = True
    for name, text, is_right in (*_installed(), *_kernels(), *_extras(), _answer()):
        is_well = is_well and is_right
        print(f"{name:<12} {plain(text)}")
    if not is_well:
        raise typer.Exit(1)


def _installed() -> Iterator[tuple[str, str, bool]]:
    yield "freebody", f"{metadata.version('freebody')}, from {Path(__file__).parents[1]}", True
    yield "python", f"{platform.python_version()}, {sys.executable}", True
    yield "system", f"{platform.system()} {platform.machine()}, {os.cpu_count()} processors", True
    for package in ("numpy", "scipy", "python-flint"):
        yield package, metadata.version(package), True


def _kernels() -> Iterator[tuple[str, str, bool]]:
    """The library that the engine runs, or why there is none."""
    from freebody.errors import BrokenInstallation
    from freebody.numeric.kernels import library

    if os.environ.get("FREEBODY_KERNELS"):
        yield "kernels", f"{os.environ['FREEBODY_KERNELS']}, by FREEBODY_KERNELS", True
        return
    try:
        library.loaded()
    except BrokenInstallation as error:
        yield "kernels", str(error), False
        return
    path = library.path()
    yield "kernels", f"{path}, {path.stat().st_size / 1e6:.1f} MB, compiled from these sources", True


def _extras() -> Iterator[tuple[str, str, bool]]:
    for extra, (module, use) in _EXTRAS.items():
        there = find_spec(module) is not None
        yield extra, f"{use}: {'there' if there else f'pip install freebody[{extra}]'}", True


def _answer() -> tuple[str, str, bool]:
    """F/m, by both routes."""
    from freebody.errors import BrokenInstallation, FreebodyError

    try:
        solve = import_module("freebody.study.answering.solve").solve
        system = import_module("freebody.system.system").System.from_text(_CHECK)
        [answer] = solve(system, question="acceleration of x").answers
        is_right = answer.value is not None and abs(answer.value - 5.0) < 1e-12 and answer.evidence is not None
    except (FreebodyError, BrokenInstallation) as error:
        return "check", str(error), False
    return "check", f"acceleration F/m = {answer.value:g} m/s^2, {'right' if is_right else 'WRONG'}", is_right
