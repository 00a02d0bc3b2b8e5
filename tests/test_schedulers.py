"""Sweeps over a scheduler and workers of dask that are programs of their own, as on other machines: each in a folder of
its own, nothing shared but addresses."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import freebody as fb
from freebody.errors import CannotAnswer, FreebodyError
from freebody.study.sweeps import remote

pytest.importorskip("distributed")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning"),
]
EXAMPLES = Path(__file__).parents[1] / "examples"
ASKED: dict[str, Any] = {
    "vary": {"theta_0": "5..85 deg", "L": "normal(1 m, 5 %)"},
    "sample": "lhs:200",
    "find": ["tension"],
    "record": ["final theta"],
    "until": 0.2,
    "block": 64,
}
# a Python that has everything but freebody
WITHOUT = """
import importlib.metadata as metadata, sys
version = metadata.version
class Hidden:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "freebody":
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
def known(name):
    if name == "freebody":
        raise metadata.PackageNotFoundError(name)
    return version(name)
sys.meta_path.insert(0, Hidden())
metadata.version = known
"""
OLD = "Metadata-Version: 2.1\nName: freebody\nVersion: 0.0.1\n"


def pendulum() -> fb.System:
    return fb.System.load(EXAMPLES / "simple_pendulum.yaml")


class Machines:
    """The programs, by the names of their folders."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.running = folder, dict[str, subprocess.Popen[bytes]]()
        without, old = folder / "without", folder / "old" / "freebody-0.0.1.dist-info"
        without.mkdir()
        old.mkdir(parents=True)
        (without / "sitecustomize.py").write_text(WITHOUT, encoding="utf-8")
        (old / "METADATA").write_text(OLD, encoding="utf-8")
        self.paths = {"": "", "without": str(without), "old": str(old.parent)}

    def begin(self, name: str, *command: str, freebody: str = "") -> None:
        """freebody: what a machine has of it, "without" or "old", else what this one has."""
        here = self.folder / name
        here.mkdir()
        own = [self.paths[freebody], os.environ.get("PYTHONPATH", "")]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, own))}
        with (here / "log").open("wb") as log:
            started = [sys.executable, "-m", *command, "--no-dashboard"]
            self.running[name] = subprocess.Popen(
                started, cwd=here, env=environment, stdout=log, stderr=subprocess.STDOUT
            )

    def scheduler(self, name: str, freebody: str = "") -> str:
        """Its address."""
        at = ["--host", "127.0.0.1", "--port", "0", "--scheduler-file", "address.json"]
        self.begin(name, "distributed.cli.dask_scheduler", *at, freebody=freebody)
        while self.running[name].poll() is None:
            time.sleep(0.1)
            if (self.folder / name / "address.json").exists():
                try:
                    return json.loads((self.folder / name / "address.json").read_text())["address"]
                except ValueError:  # it is being written
                    continue
        raise RuntimeError((self.folder / name / "log").read_text())

    def worker(self, name: str, address: str, freebody: str = "") -> None:
        options = ["--nthreads", "1", "--no-nanny", "--death-timeout", "120"]
        self.begin(name, "distributed.cli.dask_worker", address, *options, freebody=freebody)

    def kill(self, *names: str) -> None:
        for name in names:
            self.running[name].kill()
            self.running.pop(name).wait()


@pytest.fixture
def machines(tmp_path: Path) -> Iterator[Machines]:
    made = Machines(tmp_path)
    yield made
    made.kill(*made.running)


@pytest.fixture(scope="module")
def whole() -> Any:
    return pendulum().sweep(**ASKED, threads=1)


def wait_for(address: str, n: int) -> None:
    import distributed

    with distributed.Client(address, set_as_default=False) as client:
        client.wait_for_workers(n)


def test_a_worker_dies_then_the_scheduler_and_another_one_goes_on(machines: Machines, whole: Any) -> None:
    """Nothing of freebody has to be where the scheduler is."""
    out = machines.folder / "ends.zarr"
    one = machines.scheduler("one", freebody="without")
    machines.worker("a", one)
    machines.worker("b", one)
    wait_for(one, 2)
    n_done = list[int]()

    def lose(n: int, _all: int) -> None:
        n_done.append(n)
        if len(n_done) == 1:
            machines.kill("a")
        if len(n_done) == 2:
            machines.kill("one")

    with pytest.raises(CannotAnswer, match=r"the scheduler .* does not answer any more; what is done is kept in"):
        pendulum().sweep(**ASKED, cluster=one, out=out, progress=lose)
    assert 0 < n_done[-1] < 200
    assert not out.exists()

    two = machines.scheduler("two")
    machines.worker("c", two)
    put, n_put = remote.Store.put, list[int]()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(remote.Store, "put", lambda self, cases, *of: (n_put.append(len(cases)), put(self, cases, *of)))
        found = pendulum().sweep(**ASKED, cluster=two, out=out, resume=True)
    assert found.digest == whole.digest
    assert sum(n_put) == 200 - n_done[-1]
    assert sorted(path.name for path in machines.folder.glob("ends*")) == ["ends.zarr"]


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("without", r"a worker \(tcp://.*\) has no freebody: install it where the workers run"),
        ("old", r"a worker \(tcp://.*\) has freebody 0\.0\.1, not .*: install the same version for all"),
    ],
)
def test_a_worker_with_another_freebody_is_told_before_anything_is_computed(
    kind: str, said: str, machines: Machines
) -> None:
    address = machines.scheduler("one")
    machines.worker("good", address)
    machines.worker("other", address, freebody=kind)
    wait_for(address, 2)
    with pytest.raises(CannotAnswer, match=said):
        pendulum().sweep(**ASKED, cluster=address)


@pytest.mark.parametrize(("kind", "said"), [("without", "has no freebody"), ("old", r"has freebody 0\.0\.1, not")])
def test_such_a_worker_that_comes_later_is_told(kind: str, said: str, machines: Machines) -> None:
    """It comes when the first block is done, and the one before it goes."""
    address = machines.scheduler("one")
    machines.worker("good", address)

    def replaced(_n: int, _all: int) -> None:
        if "other" not in machines.running:
            machines.worker("other", address, freebody=kind)
            wait_for(address, 2)
            machines.kill("good")

    with pytest.raises(FreebodyError, match=f"a worker {said}"):
        pendulum().sweep(**ASKED, cluster=address, out=machines.folder / "a.csv", progress=replaced)
