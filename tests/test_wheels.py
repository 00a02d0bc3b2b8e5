"""The package as it is installed: wheels for four platforms, a source distribution, editable installations.

Slow tests: what they build with comes from the package index, and so does what an installation needs.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tarfile
import venv
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tools"))

import build_kernels  # noqa: E402

INSTALLED = """
import importlib.util, json, sys
import freebody
from freebody.numeric.kernels import library
system = freebody.System.load(sys.argv[1])
motion = system.simulate(0.5)
told = {"place": freebody.__file__, "library": str(library.path()), "status": str(motion.status)}
told["compilers"] = [name for name in ("numba", "llvmlite", "ziglang") if importlib.util.find_spec(name)]
print(json.dumps(told))
"""


def without_paths() -> dict[str, str]:
    """The environment, in which no other freebody is found."""
    return {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "FREEBODY"))}


def pip(python: Path | str, *words: str) -> None:
    done = subprocess.run([str(python), "-m", "pip", *words], env=without_paths(), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-3000:]


def python_of(folder: Path) -> Path:
    return folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


@pytest.fixture
def empty(tmp_path: Path) -> Path:
    """The interpreter of a virtual environment in which nothing is installed."""
    venv.create(tmp_path / "venv", with_pip=True)
    return python_of(tmp_path / "venv")


def installed(python: Path, folder: Path) -> dict[str, object]:
    """What a simulation by the installed package says of itself."""
    words = [str(python), "-c", INSTALLED, str(ROOT / "examples" / "four_bar.yaml")]
    done = subprocess.run(words, env=without_paths(), cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-3000:]
    return json.loads(done.stdout)


# -- names ------------------------------------------------------------------------------------
def test_every_platform_has_a_tag_and_a_library() -> None:
    text = (ROOT / "hatch_build.py").read_text(encoding="utf-8")
    tags = dict(re.findall(r'"([\w-]+)": "([\w.]+)",', text))
    assert tags.keys() == build_kernels.TARGETS.keys()
    assert len(build_kernels.TARGETS) == 4


def test_a_library_is_kept_by_what_it_is_made_of(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Sources, the builder and the versions of the compilers; the same for equal ones, another for others."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(build_kernels.importlib.metadata, "version", lambda _name: "1")
    first = build_kernels.cache_folder()
    assert first.parent == tmp_path / "freebody-kernels"
    assert build_kernels.cache_folder() == first
    monkeypatch.setattr(build_kernels, "sources_digest", lambda: "others")
    assert build_kernels.cache_folder() != first


def test_what_is_kept_is_not_compiled_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(build_kernels, "cache_folder", lambda: tmp_path)
    for name, targets in build_kernels.TARGETS.items():
        (tmp_path / name).mkdir()
        for target in targets:
            (tmp_path / name / target.file).write_bytes(b"compiled before")

    def compiles(*_words: object) -> None:
        raise AssertionError("this would compile")

    monkeypatch.setattr(build_kernels, "_translated", compiles)
    for name in build_kernels.TARGETS:
        assert all(path.read_bytes() == b"compiled before" for path in build_kernels.built(name))


# -- whole ------------------------------------------------------------------------------------
@pytest.mark.slow
def test_the_native_wheel_runs_where_no_compiler_is(tmp_path: Path, empty: Path) -> None:
    pip(sys.executable, "wheel", "--quiet", "--no-deps", "-w", str(tmp_path), str(ROOT))
    (wheel,) = tmp_path.glob("freebody-*.whl")
    assert "-py3-none-" in wheel.name
    names = set(zipfile.ZipFile(wheel).namelist())
    expected = {f"freebody/numeric/kernels/{t.file}" for t in build_kernels.TARGETS[build_kernels.native()]}
    assert {name for name in names if Path(name).suffix in (".so", ".dylib", ".dll")} == expected
    pip(empty, "install", "--quiet", str(wheel))
    told = installed(empty, tmp_path)
    assert told["compilers"] == []
    assert told["status"] == "finished"
    assert str(tmp_path) in str(told["library"])
    assert str(tmp_path) in str(told["place"])


@pytest.mark.slow
def test_a_source_distribution_can_be_installed(tmp_path: Path, empty: Path) -> None:
    """It has what compiling takes, so that a wheel can be built of it, and no library of the machine it was made on."""
    pip(empty, "install", "--quiet", "build")
    words = [str(empty), "-m", "build", "--sdist", "-o", str(tmp_path), str(ROOT)]
    subprocess.run(words, env=without_paths(), check=True, capture_output=True)
    (made,) = tmp_path.glob("freebody-*.tar.gz")
    with tarfile.open(made) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert {"hatch_build.py", "tools/build_kernels.py", "tools/kernels_runtime.zig", "README.md", "LICENSE"} <= names
    assert not [name for name in names if Path(name).suffix in (".so", ".dylib", ".dll")]
    pip(empty, "install", "--quiet", str(made))
    assert installed(empty, tmp_path)["status"] == "finished"


@pytest.mark.slow
def test_an_editable_installation_has_its_library_beside_the_sources(tmp_path: Path, empty: Path) -> None:
    pip(empty, "install", "--quiet", "-e", str(ROOT))
    told = installed(empty, tmp_path)
    assert told["status"] == "finished"
    assert Path(str(told["place"])).is_relative_to(ROOT)
    assert Path(str(told["library"])).parent == build_kernels.KERNELS
