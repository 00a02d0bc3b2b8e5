"""How the program ends: files whole or not at all, one worded message, an exit code that says whose fault it is."""

from __future__ import annotations

import errno
import io
import json
import math
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody import cli, progress
from freebody.cli.output import print_json
from freebody.cli.running import Terminated
from freebody.errors import CannotAnswer, InputError
from freebody.present import busy as busy_line
from freebody.present.files import check_writable, replaced, write_whole
from freebody.present.report.blocks import Paragraph, Report, text
from freebody.present.report.write import report_formats, write_report

MODEL = """
title: A block
parameters: {m: 2 kg, F: 3 N}
bodies: {b: {particle: {mass: m}}}
connections: {g: {slider: {body: b, along: right}}}
loads: {p: {force: {at: b, along: right, magnitude: F}}}
measures: {x: x of b}
questions: [acceleration of x]
"""
FULL = Path("/dev/full")
needs_full = pytest.mark.skipif(not FULL.exists(), reason="there is no /dev/full")
posix = pytest.mark.skipif(os.name != "posix", reason="of POSIX")


@pytest.fixture
def model(tmp_path: Path) -> Path:
    path = tmp_path / "block.yaml"
    path.write_text(MODEL)
    return path


def ended(*arguments: object, monkeypatch: pytest.MonkeyPatch) -> int:
    """The exit code of the program, run here."""
    monkeypatch.setattr(sys, "argv", ["freebody", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        cli.main()
    return 0 if end.value.code is None else int(end.value.code)


def program(*arguments: object, **options: Any) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "freebody.cli", *map(str, arguments)]
    return subprocess.Popen(command, stderr=subprocess.PIPE, text=True, **{"stdout": subprocess.PIPE, **options})


# -- files ------------------------------------------------------------------------------------
def test_a_file_takes_the_place_of_another_when_it_is_whole(tmp_path: Path) -> None:
    path = tmp_path / "out.svg"
    path.write_text("old")
    path.chmod(0o640)
    with replaced(path) as file:
        assert file.suffix == ".svg"
        file.write_text("new")
        assert path.read_text() == "old"
    assert path.read_text() == "new"
    assert path.stat().st_mode & 0o777 == 0o640
    assert os.listdir(tmp_path) == ["out.svg"]


@pytest.mark.parametrize("error", [OSError(errno.ENOSPC, "No space left on device"), KeyboardInterrupt()])
def test_half_a_file_is_not_left_behind(error: BaseException, tmp_path: Path) -> None:
    path = tmp_path / "out.svg"
    path.write_text("old")

    def write() -> None:
        with replaced(path) as file:
            file.write_text("ha")
            raise error

    with pytest.raises((InputError, KeyboardInterrupt)) as told:
        write()
    if isinstance(error, OSError):
        assert str(told.value) == f"{path} cannot be written: No space left on device"
    assert path.read_text() == "old"
    assert os.listdir(tmp_path) == ["out.svg"]


def test_a_program_that_fails_is_told_without_its_command_line(tmp_path: Path) -> None:
    def write() -> None:
        with replaced(tmp_path / "film.mp4"):
            raise subprocess.CalledProcessError(1, ["ffmpeg", "-f", "rawvideo"])

    with pytest.raises(InputError, match="ended with code 1") as told:
        write()
    assert "rawvideo" not in str(told.value)
    assert os.listdir(tmp_path) == []


@posix
def test_a_link_stays_and_what_it_leads_to_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "real").write_text("old")
    (tmp_path / "link").symlink_to(tmp_path / "real")
    write_whole(tmp_path / "link", "new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_text() == "new"


@posix
@pytest.mark.parametrize("kind", ["folder", "pipe", "full", "nowhere", "zero"])
def test_what_is_no_file_is_refused_before_anything_is_computed(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    if kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "full":
        path.symlink_to(FULL)
    elif kind == "nowhere":
        path = tmp_path / "no" / "x.csv"
    else:
        path = tmp_path / "a\0b.csv"
    for refuse in (lambda: check_writable(path, (".csv",)), lambda: write_whole(path, "x")):
        with pytest.raises(InputError, match=r"cannot be written|no folder"):
            refuse()
    assert list(tmp_path.glob(".freebody*")) == []


def _full(*_arguments: object, **_options: object) -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


@pytest.mark.parametrize("suffix", [s for s in report_formats() if s != ".pdf"])
def test_a_report_on_a_full_disk(suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    report = Report("t", "en", "s", (Paragraph(text("words")),), {})
    path = tmp_path / f"r{suffix}"
    monkeypatch.setattr(Path, "write_bytes", _full)
    with pytest.raises(InputError, match="cannot be written: No space left on device"):
        write_report(report, path)
    assert not path.exists()
    assert list(tmp_path.glob(".freebody*")) == []


@pytest.mark.parametrize("suffix", [".svg", ".tex", ".png"])
def test_a_picture_on_a_full_disk(suffix: str, model: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = model.with_name(f"p{suffix}")
    monkeypatch.setattr(Path, "write_bytes", _full)
    assert ended("draw", model, "-o", path, monkeypatch=monkeypatch) == 2
    assert os.listdir(model.parent) == [model.name]


@pytest.mark.parametrize("suffix", [".nc", ".csv"])
def test_a_motion_on_a_full_disk(suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from freebody.present.recording import Recording, Series
    from freebody.study.simulation import files

    times = np.linspace(0.0, 1.0, 5)
    data = Recording(times, {"x": Series(("time",), times, {"units": "m"})}, {"body": ["b"]}, {"measures": ["x"]})
    files.write(data, tmp_path / f"good{suffix}")
    assert (tmp_path / f"good{suffix}").stat().st_size > 0
    monkeypatch.setattr(Path, "write_bytes", _full)
    monkeypatch.setattr(files.np, "savetxt", _full)
    with pytest.raises(InputError, match="cannot be written: No space left on device"):
        files.write(data, tmp_path / f"bad{suffix}")
    assert os.listdir(tmp_path) == [f"good{suffix}"]


# -- what is read -----------------------------------------------------------------------------
@posix
@pytest.mark.parametrize("kind", ["pipe", "/dev/zero", "folder", "long", "nothing", "not text"])
def test_what_is_no_model_file_is_refused_at_once(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "m.yaml"
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "not text":
        path.write_bytes(b"title: \xff\xfe")
    elif kind == "long":
        path = tmp_path / ("m" * 4000)
    elif kind.startswith("/"):
        path = Path(kind)
    assert ended("eom", path, monkeypatch=monkeypatch) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert "Traceback" not in said.err
    assert said.err.count("\n") == 1


# -- the output -------------------------------------------------------------------------------
@posix
@needs_full
def test_output_that_cannot_be_written_is_said() -> None:
    with FULL.open("w") as full:
        done = program("schema", stdout=full)
        _out, said = done.communicate(timeout=600)
    assert done.returncode == 2
    assert said == "the output cannot be written: No space left on device\n"


@posix
def test_a_reader_that_goes_away_is_no_error() -> None:
    reading, writing = os.pipe()
    os.close(reading)
    done = program("schema", stdout=writing)
    os.close(writing)
    _out, said = done.communicate(timeout=600)
    assert done.returncode == 0
    assert said == ""


def test_a_closed_output_is_no_error(model: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdout", None)
    assert ended("schema", monkeypatch=monkeypatch) == 0


# -- defects ----------------------------------------------------------------------------------
@pytest.mark.parametrize(
    "error", [KeyError("x"), EOFError("Ran out\nof input"), AssertionError(), RecursionError("deep")]
)
def test_a_defect_is_one_line_with_its_place(
    error: Exception, model: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def broken(_system: object) -> None:
        raise error

    monkeypatch.setattr("freebody.study.eom.equations_of_motion", broken)
    assert ended("eom", model, monkeypatch=monkeypatch) == 70
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert type(error).__name__ in said
    assert "test_ends.py" in said
    assert "report it" in said
    monkeypatch.setenv("FREEBODY_DEBUG", "1")
    assert ended("eom", model, monkeypatch=monkeypatch) == 70
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (CannotAnswer("no"), 1),
        (InputError("no"), 2),
        (KeyboardInterrupt(), 130),
        (Terminated(), 143),
        (MemoryError(), 1),
    ],
)
def test_every_end_has_its_exit_code(
    error: BaseException,
    code: int,
    model: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def broken(_system: object) -> None:
        raise error

    monkeypatch.setattr("freebody.study.eom.equations_of_motion", broken)
    assert ended("eom", model, monkeypatch=monkeypatch) == code
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1


def test_documents_are_plain_json(capsys: pytest.CaptureFixture[str]) -> None:
    print_json({"a": math.nan, "b": [math.inf, 1.0], "c": np.float64(2.0), "d": np.array([1, 2]), 3: (True, None)})
    found = json.loads(capsys.readouterr().out, parse_constant=lambda name: pytest.fail(name))
    assert found == {"a": None, "b": [None, 1.0], "c": 2.0, "d": [1, 2], "3": [True, None]}


# -- signals ----------------------------------------------------------------------------------
@posix
@pytest.mark.parametrize("sign", [signal.SIGTERM, signal.SIGINT])
def test_an_interrupted_simulation_is_printed_and_written(
    sign: signal.Signals, model: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    @contextmanager
    def bar(_until: float) -> Generator[Callable[[float, int], None]]:
        yield lambda _now, _steps: os.kill(os.getpid(), sign)

    monkeypatch.setattr("freebody.present.progress_bar.progress_bar", bar)
    before, ignored = signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)
    signal.signal(signal.SIGINT, signal.default_int_handler)  # processes that share the tests ignore it
    out = model.with_name("run.csv")
    steps = ("--method", "rk4", "--step", "1e-3", "--every", "1e5")
    try:
        code = ended("simulate", model, "--until", "1e6", *steps, "--out", out, monkeypatch=monkeypatch)
    finally:
        signal.signal(signal.SIGTERM, before)
        signal.signal(signal.SIGINT, ignored)
    printed = capsys.readouterr().out
    assert "interrupted at t = " in printed
    assert f"wrote {out}" in printed
    assert code == 1
    assert len(out.read_text().splitlines()) >= 2


@posix
def test_a_terminated_command_leaves_nothing_behind(model: Path) -> None:
    running = program("eom", model)
    running.send_signal(signal.SIGTERM)
    running.communicate(timeout=600)
    assert running.returncode in (143, -signal.SIGTERM, 0)
    assert os.listdir(model.parent) == [model.name]


# -- progress ---------------------------------------------------------------------------------
class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_long_work_shows_a_line_on_a_terminal_and_wipes_it_out(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = Terminal()
    monkeypatch.setattr(sys, "stderr", stream)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(busy_line, "_EVERY", 0.001)
    with busy_line.busy("counting sheep"):
        progress.announced("counting wolves")
        while "wolves" not in stream.getvalue():
            time.sleep(0.001)
    assert stream.getvalue().endswith("\r\x1b[2K")
    assert "\n" not in stream.getvalue()


def test_short_work_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = Terminal()
    monkeypatch.setattr(sys, "stderr", stream)
    monkeypatch.setattr(busy_line, "PATIENCE", math.inf)
    with busy_line.busy("blinking"):
        pass
    assert stream.getvalue() == ""


def test_elsewhere_only_what_is_announced_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = io.StringIO()
    monkeypatch.setattr(sys, "stderr", stream)
    with busy_line.busy("counting sheep"):
        progress.busy_with("counting more sheep")
        progress.announced("compiling")
    progress.announced("nobody hears this")
    assert stream.getvalue() == "freebody: compiling\n"


def test_without_an_error_stream_work_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", None)
    with busy_line.busy("counting sheep"):
        progress.announced("compiling")


# -- limits -----------------------------------------------------------------------------------
def test_a_million_sheets_are_refused(model: Path) -> None:
    from freebody.narrative.sheets.sheet import sheet

    with pytest.raises(InputError, match="at most"):
        sheet([fb.System.load(model)], variants=1_000_000)


def test_a_simulation_shows_no_bar_where_there_is_no_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    from freebody.present import progress_bar

    stream = io.StringIO()
    monkeypatch.setattr(sys, "stderr", stream)
    monkeypatch.setattr(progress_bar, "PATIENCE", -1.0)
    with progress_bar.progress_bar(1.0) as update:
        update(0.5, 10)
    assert stream.getvalue() == ""
