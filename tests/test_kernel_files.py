"""Compiled kernels on disk: found wherever the sources lie, healed where they are damaged."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
import pytest

from freebody.numeric.engine import following, jit
from freebody.numeric.engine.kernel_files import KernelFiles
from freebody.numeric.timestepping import compiled as compiled_for_stepping


def twice(x: float) -> float:
    return 2.0 * x


def compiled(folder: Path) -> Any:
    """A kernel that is taken from a folder, or compiled into it."""
    dispatcher: Any = numba.njit(_nrt=False)(twice)
    dispatcher._cache = KernelFiles(twice, folder)
    dispatcher.compile((numba.float64,))
    assert dispatcher(1.5) == 3.0
    return dispatcher


def is_taken(dispatcher: Any) -> bool:
    return sum(dispatcher.stats.cache_hits.values()) == 1


def the_file(folder: Path) -> Path:
    (path,) = folder.iterdir()
    return path


def test_a_kernel_is_compiled_once(tmp_path: Path) -> None:
    assert not is_taken(compiled(tmp_path))
    assert is_taken(compiled(tmp_path))


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda content: b"",
    "cut short": lambda content: content[: len(content) // 2],
    "one byte of the machine code changed": lambda content: content[:-99] + bytes([content[-99] ^ 1]) + content[-98:],
    "of another making": lambda content: b"\x80\x05K\x01." * 40,
    "longer": lambda content: content + b"\0",
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_file_is_compiled_anew_and_then_whole(damage: str, tmp_path: Path) -> None:
    compiled(tmp_path)
    whole = the_file(tmp_path).read_bytes()
    the_file(tmp_path).write_bytes(DAMAGES[damage](whole))
    assert not is_taken(compiled(tmp_path))
    assert is_taken(compiled(tmp_path))


def test_a_file_that_cannot_be_read_back_is_compiled_anew(tmp_path: Path) -> None:
    import hashlib

    compiled(tmp_path)
    body = b"no pickle"
    the_file(tmp_path).write_bytes(hashlib.sha256(body).digest() + body)
    assert not is_taken(compiled(tmp_path))
    assert is_taken(compiled(tmp_path))


def test_a_folder_that_cannot_be_written_costs_the_compiling_alone(tmp_path: Path, monkeypatch: Any) -> None:
    def refused(*_arguments: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", refused)
    assert not is_taken(compiled(tmp_path))
    assert list(tmp_path.iterdir()) == []
    assert not is_taken(compiled(tmp_path / "not there"))


def test_a_file_is_not_executable_and_its_name_says_what_it_is(tmp_path: Path) -> None:
    compiled(tmp_path)
    path = the_file(tmp_path)
    assert path.name.startswith(f"{twice.__module__}.twice-")
    assert not path.stat().st_mode & stat.S_IXUSR


def test_the_digest_covers_every_file_with_kernels() -> None:
    """A source that is left out would leave old kernels in use."""
    folder = Path(jit.__file__).parent
    named = {
        (folder / f"{name}.py").resolve()
        for name in (*jit._SOURCES, *jit.OF_SPACE, *following.SOURCES, *compiled_for_stepping.SOURCES)
    }
    marks = ("@kernel", "@part", "@leaf", "@entry", "@of_either")
    for path in folder.parent.rglob("*.py"):
        lines = path.read_text(encoding="utf-8").splitlines()
        if any(line.startswith(marks) for line in lines):
            assert path.resolve() in named, f"{path.name} is compiled, and not in the digest"


def test_a_file_that_others_can_write_is_not_run(tmp_path: Path) -> None:
    compiled(tmp_path)
    assert is_taken(compiled(tmp_path))
    the_file(tmp_path).chmod(0o666)
    assert not is_taken(compiled(tmp_path))


def test_compiling_is_announced_once(tmp_path: Path) -> None:
    from freebody import progress
    from freebody.numeric.engine import kernel_files

    heard: list[str] = []
    kernel_files._announce.cache_clear()
    progress.listen(heard.append)
    try:
        compiled(tmp_path)
        compiled(tmp_path)
        compiled(tmp_path / "none")
    finally:
        progress.listen(None)
    assert len(heard) == 1
    assert "compiling the kernels" in heard[0]


def test_each_set_of_kernels_is_announced_and_what_was_done_before_goes_on(tmp_path: Path) -> None:
    """Kernels of events may be compiled long after those of motions: the user is told then as well."""
    from freebody import progress
    from freebody.numeric.engine import kernel_files

    heard: list[str] = []
    kernel_files._announce.cache_clear()
    progress.busy_with("counting sheep")
    progress.listen(heard.append)
    try:
        for what in ("motions", "events", "events"):
            with KernelFiles(twice, tmp_path / what, what).alone():
                pass
            assert progress.now() == "counting sheep"
    finally:
        progress.listen(None)
    assert ["motions" in heard[0], "events" in heard[1], len(heard)] == [True, True, 2]


@pytest.mark.skipif(os.name != "posix", reason="locks of POSIX")
def test_one_process_compiles_and_others_wait_for_its_file(tmp_path: Path) -> None:
    import fcntl

    def is_free() -> bool:
        with (tmp_path / f"{twice.__module__}.twice.lock").open("w") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                return False
        return True

    with KernelFiles(twice, tmp_path).alone():
        assert not is_free()
        compiled(tmp_path)
    assert is_free()
    with KernelFiles(twice, tmp_path).alone():
        assert is_free()  # the file is there, and any number may read it


def test_without_any_folder_that_can_be_written_kernels_are_compiled(monkeypatch: Any) -> None:
    def full(*_arguments: object, **_options: object) -> None:
        raise OSError("read-only")

    monkeypatch.setattr(Path, "mkdir", full)
    jit._folder.cache_clear()
    folder = jit._folder()
    jit._folder.cache_clear()
    assert not folder.exists()
    compiled(folder)
