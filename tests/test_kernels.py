"""The library of kernels: the same as what it was made of, the same on every processor, refused where it is not."""

from __future__ import annotations

import ast
import json
import os
import platform
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
import kernel_runs
from command import freebody
from freebody.errors import BrokenInstallation
from freebody.numeric.kernels import declaring, library, near, stepping, zeros
from goldens import FOLDER, WRITE

ROOT = Path(__file__).parents[1]
KERNELS = ROOT / "src/freebody/numeric/kernels"
HASHES = FOLDER / "trajectories.json"


def run(backend: str, *names: str, **more: str) -> dict[str, str]:
    """The hashes of motions in a process of its own."""
    done = subprocess.run(
        [sys.executable, str(Path(kernel_runs.__file__)), *names],
        env=os.environ | {"FREEBODY_KERNELS": backend} | more,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


@pytest.fixture
def copied(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder in whose library and sources may be spoilt."""
    for path in library.FOLDER.iterdir():  # as installed: in the sources there may be no library
        if path.is_file():
            shutil.copy(path, tmp_path)
    monkeypatch.setattr(library, "FOLDER", tmp_path)
    library.forget()
    yield tmp_path
    library.forget()


# -- the same everywhere ----------------------------------------------------------------------
@pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="other processors fuse and round otherwise")
def test_ten_motions_are_the_same_bits_on_every_machine() -> None:
    found = {name: kernel_runs.hashed(name) for name in kernel_runs.NAMES}
    if os.environ.get(WRITE):
        HASHES.write_text(json.dumps(found, indent=1) + "\n")
    assert found == json.loads(HASHES.read_text())


def test_vectors_of_four_numbers_change_no_bit(copied: Path) -> None:
    names = [name for name in library.file_names() if (copied / name).exists()]
    if len(names) < 2 or library.path().name != names[0]:
        pytest.skip("there is one library for this machine")
    wide = kernel_runs.motion("four_bar"), kernel_runs.motion("spinning_top")
    (copied / names[0]).unlink()
    library.forget()
    assert library.path().name == names[1]
    narrow = kernel_runs.motion("four_bar"), kernel_runs.motion("spinning_top")
    assert [x.tobytes() for x in wide] == [x.tobytes() for x in narrow]


# an example, and how it is followed: the plane, space, contact with events, time stepping
CONFORMING = (
    ("falling_hinged_rod", "0.1, every=0.05"),
    ("spinning_top", "0.1, every=0.05"),
    ("bouncing_ball", "0.7, every=0.1"),
    ("bouncing_ball", "0.7, every=0.1, method='moreau', step=2e-3"),
)


@pytest.mark.parametrize("backend", ["python", pytest.param("numba", marks=pytest.mark.slow)])
def test_the_library_does_what_its_sources_say(backend: str) -> None:
    """Uncompiled, or by another compiler, only the elementary functions are others, right to the last digit but one."""
    lines = [
        f"r = fb.System.load(r'{ROOT / 'examples' / name}.yaml').simulate({how})\n"
        "print(repr(np.ravel(r.course.poses).tolist()), r.status)"
        for name, how in CONFORMING
    ]
    code = "\n".join(["import freebody as fb, numpy as np", *lines])
    told = [
        subprocess.run(
            [sys.executable, "-c", code],
            env=os.environ | {"FREEBODY_KERNELS": run_by},
            capture_output=True,
            text=True,
            check=True,
        ).stdout.splitlines()
        for run_by in ("library", backend)
    ]
    for compiled, other in zip(*told, strict=True):
        assert compiled.rsplit(" ", 1)[1] == other.rsplit(" ", 1)[1] == "finished"
        a, b = (np.array(eval(text.rsplit(" ", 1)[0])) for text in (compiled, other))
        assert np.abs(a - b).max() < 1e-12


@pytest.mark.slow
def test_numba_compiles_the_same() -> None:
    assert run("numba", "falling_hinged_rod", "four_bar") == run("library", "falling_hinged_rod", "four_bar")


# -- refused ----------------------------------------------------------------------------------
def test_a_stale_library_says_so_and_computes_nothing(copied: Path) -> None:
    with (copied / "stepping.py").open("a") as file:
        file.write("# changed\n")
    with pytest.raises(library.KernelsMissing, match=r"made of other sources.*build_kernels"):
        library.loaded()


def test_a_change_that_is_of_line_ends_alone_is_none(copied: Path) -> None:
    path = copied / "stepping.py"
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    assert library.loaded()


def test_without_a_library_it_is_said_what_to_do(copied: Path) -> None:
    for name in library.file_names():
        (copied / name).unlink(missing_ok=True)
    with pytest.raises(library.KernelsMissing, match=r"FREEBODY_KERNELS=python"):
        library.loaded()


def test_a_broken_library_is_no_crash(copied: Path) -> None:
    for name in library.file_names():
        (copied / name).write_bytes(b"no library")
    with pytest.raises(library.KernelsMissing, match="cannot be loaded"):
        library.loaded()


def test_the_program_says_what_is_missing(copied: Path) -> None:
    for name in library.file_names():
        (copied / name).unlink(missing_ok=True)
    model = str(ROOT / "examples" / "falling_hinged_rod.yaml")
    done = freebody("simulate", model, "--until", "0.1")
    assert done.returncode == 1
    assert "the compiled kernels of freebody are not there" in done.stderr


def test_an_unknown_way_to_run_kernels_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FREEBODY_KERNELS", "fortran")
    with pytest.raises(ValueError, match="library, numba, python"):
        declaring.chosen_backend()


@pytest.mark.parametrize(
    "spoilt",
    [
        {"radii": np.zeros(3, np.float32)},
        {"radii": np.zeros(6)[::2]},
        {"centers": np.zeros(3)},
        {"order": np.zeros(3, np.int64)},
    ],
)
def test_arrays_that_kernels_would_misread_are_refused(spoilt: dict[str, Any]) -> None:
    whole = {
        "centers": np.zeros((3, 2)),
        "radii": np.zeros(3),
        "order": np.arange(3, dtype=np.int32),
        "margin": 0.1,
        "pair_of": np.full((3, 3), -1, np.int32),
        "found": np.zeros((1, 1), np.int32),
    }
    assert near.close_circles(*whole.values()) == 0
    with pytest.raises(TypeError, match="contiguous"):
        near.close_circles(*(whole | spoilt).values())


# -- calls ------------------------------------------------------------------------------------
def test_more_bundles_than_are_kept_do_no_harm() -> None:
    """The tables of some are let go while others are in use."""
    system = fb.System.load(ROOT / "examples" / "double_pendulum.yaml").with_parameters()
    simulator = system.simulate(0.1).simulator
    engine, state = simulator.engine, simulator.start
    out = np.zeros(engine.n_y)
    first: bytes | None = None
    for _ in range(3 * library._MOST_TABLES):
        layout, room = engine.layout._replace(), engine.room._replace()
        assert stepping.visit(layout, room, engine.idle, -1.0, state.copy(), 0.0, out, 1) is True
        first = first or out.tobytes()
        assert out.tobytes() == first


def test_kernels_import_nothing_but_each_other() -> None:
    """They are compiled where nothing else is installed."""
    for path in KERNELS.glob("*.py"):
        if path.name == "library.py":
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [str(node.module)] if isinstance(node, ast.ImportFrom) else []
            for name in names:
                root = name.split(".")[0]
                known = {"numpy", "numba"} | set(sys.stdlib_module_names)
                assert root in known or name.startswith("freebody.numeric.kernels"), f"{path.name} imports {name}"


def test_no_kernel_is_declared_elsewhere() -> None:
    """What is outside of the folder is in no digest, and would not be compiled."""
    marks = ("@kernel", "@part", "@leaf", "@entry", "@of_either")
    for path in (ROOT / "src/freebody").rglob("*.py"):
        if path.parent != KERNELS:
            lines = path.read_text(encoding="utf-8").splitlines()
            assert not any(line in marks for line in lines), path


def test_neither_numba_nor_its_compiler_is_imported() -> None:
    code = (
        "import freebody as fb, sys\n"
        f"fb.System.load(r'{ROOT / 'examples' / 'bouncing_ball.yaml'}').simulate(0.7)\n"
        "print(sorted({'numba', 'llvmlite', 'ziglang'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_entry_is_in_the_library() -> None:
    assert zeros.search
    for name in declaring.ENTRIES:
        assert hasattr(library.loaded(), name)


def test_a_sweep_without_a_library_ends_and_has_no_cases_without_value(copied: Path) -> None:
    system = fb.System.load(ROOT / "examples/simple_pendulum.yaml")
    for name in library.file_names():
        (copied / name).unlink(missing_ok=True)
    with pytest.raises(BrokenInstallation, match="FREEBODY_KERNELS=python"):
        system.sweep({"L": [1.0, 2.0]}, record=["final theta"], until=0.5)
