"""Many cases beyond one process: the same bits, also when workers are lost, and each trouble by its name."""

from __future__ import annotations

import os
import re
import signal
import stat
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import freebody as fb
from freebody.errors import CannotAnswer, InputError
from freebody.study.sweeps import clusters, remote
from freebody.study.sweeps.clusters import slurm as slurm_cluster

dask: Any = pytest.importorskip("distributed")
# processes that are killed leave sockets behind
pytestmark = pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning")

EXAMPLES = Path(__file__).parents[1] / "examples"
ASKED: dict[str, Any] = {
    "vary": {"theta_0": "5..85 deg", "L": "normal(1 m, 5 %)"},
    "sample": "lhs:200",
    "find": ["tension", "lowest_speed"],
    "record": ["final theta"],
    "until": 0.2,
}


def pendulum() -> fb.System:
    return fb.System.load(EXAMPLES / "simple_pendulum.yaml")


@pytest.fixture(scope="module")
def whole() -> Any:
    """The same cases in this process."""
    return pendulum().sweep(**ASKED, threads=1)


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    made = dask.LocalCluster(n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address="127.0.0.1:0")
    with made:
        yield made


# -- the same bits ----------------------------------------------------------------------------
@pytest.mark.parametrize("block", [64, 4096])
def test_a_cluster_gives_the_bits_of_one_process(cluster: Any, whole: Any, block: int) -> None:
    found = pendulum().sweep(**ASKED, cluster=cluster.scheduler_address, block=block)
    assert found.digest == whole.digest
    assert found.counts == whole.counts
    assert found.threads == 2
    assert found.to_plain()["cluster"] == cluster.scheduler_address


def test_processes_of_this_machine_give_the_bits_of_one(whole: Any, tmp_path: Path) -> None:
    xarray = pytest.importorskip("xarray")
    out = tmp_path / "a.zarr"
    found = pendulum().sweep(**ASKED, cluster="local:1", block=64, out=out)
    assert (found.digest, found.threads) == (whole.digest, 1)
    with xarray.open_zarr(out) as data:
        assert data.attrs["digest"] == whole.digest
    assert not list(tmp_path.glob("*.part"))


def test_a_case_without_a_number_has_its_reason_from_a_cluster(cluster: Any) -> None:
    system = fb.System.load(EXAMPLES / "slider_crank.yaml")
    asked: dict[str, Any] = {"vary": {"l": "0.05, 0.2, 0.4 m"}, "find": ["rod"]}
    found = system.sweep(**asked, cluster=cluster.scheduler_address)
    assert found.digest == system.sweep(**asked).digest
    assert [f.status for f in found.failures] == ["cannot be assembled"]


# -- losses -----------------------------------------------------------------------------------
def test_a_killed_worker_costs_its_block_only(whole: Any) -> None:
    """One of two workers is killed as soon as a first block is done; its blocks go to the other one."""
    killed: list[int] = []
    with dask.LocalCluster(
        n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address="127.0.0.1:0", silence_logs=50
    ) as made:
        with dask.Client(made, set_as_default=False) as client:
            processes = client.run(os.getpid)

        def kill(n_done: int, _n: int) -> None:
            if not killed:
                killed.append(min(processes.values()))
                os.kill(killed[0], signal.SIGKILL)

        found = pendulum().sweep(**ASKED, cluster=made.scheduler_address, block=64, progress=kill)
    assert killed
    assert found.is_complete
    assert found.digest == whole.digest


def test_what_is_done_is_kept_and_gone_on_with(cluster: Any, whole: Any, tmp_path: Path) -> None:
    """Ctrl-C after the first block; the rest is done in this process, and the digest is that of all."""

    def interrupted(_done: int, _n: int) -> None:
        raise KeyboardInterrupt

    out = tmp_path / "a.csv"
    part = pendulum().sweep(**ASKED, cluster=cluster.scheduler_address, block=64, out=out, progress=interrupted)
    assert 0 < part.n_done < 200
    rest = pendulum().sweep(**ASKED, out=out, resume=True)
    assert rest.digest == whole.digest
    assert out.exists()


def test_a_cluster_goes_on_where_a_process_was_interrupted(
    cluster: Any, whole: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(done: int, _n: int) -> None:
        if done > 30:  # in the midst of a block
            raise KeyboardInterrupt

    out = tmp_path / "a.csv"
    part = pendulum().sweep(**ASKED, threads=1, block=64, out=out, progress=interrupted)
    n_before = part.n_done
    assert 0 < n_before < 64
    put, n_put = remote.Store.put, 0

    def counted(self: Any, cases: Any, *rest: Any) -> None:
        nonlocal n_put
        n_put += len(cases)
        put(self, cases, *rest)

    monkeypatch.setattr(remote.Store, "put", counted)
    found = pendulum().sweep(**ASKED, cluster=cluster.scheduler_address, out=out, resume=True)
    assert found.digest == whole.digest
    assert n_put == 200 - n_before


def test_a_cluster_without_workers_is_told_and_what_is_done_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(remote, "LOOK", 0.2)
    monkeypatch.setattr(remote, "LOST", 3)
    out = tmp_path / "a.csv"
    with dask.LocalCluster(
        n_workers=1, threads_per_worker=1, host="127.0.0.1", dashboard_address="127.0.0.1:0", silence_logs=50
    ) as made:

        def none_left(_done: int, _n: int) -> None:
            made.scale(0)

        with pytest.raises(CannotAnswer, match=r"no worker is left on the cluster; what is done is kept in .*a\.csv"):
            pendulum().sweep(**ASKED, cluster=made.scheduler_address, block=64, out=out, progress=none_left)
    assert (tmp_path / "a.csv.part" / "done.bin").read_bytes().count(1)


def test_a_scheduler_that_is_gone_is_told(cluster: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The client gives up after half a minute: here at once."""

    def lost(*_of: Any) -> Any:
        raise OSError("Timed out trying to connect to tcp://127.0.0.1:1 after 30 s")

    monkeypatch.setattr(remote, "_finished", lost)
    with pytest.raises(CannotAnswer, match=r"the scheduler .* does not answer any more; what is done is kept in"):
        pendulum().sweep(**ASKED, cluster=cluster.scheduler_address, out=tmp_path / "a.csv")


@pytest.mark.parametrize(
    ("kind", "said"),
    [("KilledWorker", "every worker that looked at them died"), ("MemoryError", "MemoryError: no room")],
)
def test_a_block_that_no_worker_can_do_is_named(
    kind: str, said: str, cluster: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What dask hands on when four workers in a row died of a task, and what a task itself has raised."""

    class Failed:
        def result(self) -> Any:
            raise type(kind, (Exception,), {})("no room")

        def release(self) -> None:
            pass

    def failed(_client: Any, waiting: dict[Any, Any], _store: Any) -> list[Any]:
        future = Failed()
        waiting[future] = (64, 128, None)
        return [future]

    monkeypatch.setattr(remote, "_finished", failed)
    with pytest.raises(CannotAnswer, match=rf"cases 65 to 128 cannot be looked at on the cluster: {said}.*--resume"):
        pendulum().sweep(**ASKED, cluster=cluster.scheduler_address, out=tmp_path / "a.csv")


def test_only_some_blocks_are_under_way(cluster: Any, whole: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two for each thread and two more, however many cases there are: the memory is that of these blocks."""
    most, finished = 0, remote._finished

    def counted(client: Any, waiting: Any, store: Any) -> Any:
        nonlocal most
        most = max(most, len(waiting))
        return finished(client, waiting, store)

    monkeypatch.setattr(remote, "_finished", counted)
    asked = {**ASKED, "record": [], "until": None, "sample": "lhs:3000"}
    assert pendulum().sweep(**asked, cluster=cluster.scheduler_address, block=64).is_complete
    assert most == 6


def test_another_version_of_the_program_is_refused(cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(remote, "version", lambda _name: "0.0.1")
    with pytest.raises(CannotAnswer, match=r"a worker has freebody .*, not 0\.0\.1"):
        pendulum().sweep(**ASKED, cluster=cluster.scheduler_address)


# -- what is not there ------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("ray:8", "no such cluster. One writes local:8, slurm:job.sh, tcp://scheduler:8786"),
        ("local:many", "how many processes"),
        ("local:0", "how many processes"),
        ("tcp://", "no address of a scheduler"),
        ("slurm:/nowhere/job.sh", "cannot be read"),
        ("tcp://127.0.0.1:1", "no scheduler answers there"),
    ],
)
def test_a_cluster_that_is_not_there_is_told(text: str, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    client = dask.Client

    def impatient(address: str, *, timeout: str, **more: Any) -> Any:
        return client(address, timeout="1 s", **more)

    monkeypatch.setattr(dask, "Client", impatient)
    with pytest.raises(InputError) as caught:
        pendulum().sweep(**ASKED, cluster=text)
    assert said in str(caught.value)


def test_the_extra_is_named_where_dask_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clusters, "find_spec", lambda _name: None)
    with pytest.raises(InputError, match=r'needs dask\.distributed; pip install "freebody\[sweep\]"'):
        pendulum().sweep(**ASKED, cluster="local:2")


def test_a_scheduler_without_workers_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    from freebody.study.sweeps.clusters import tcp

    monkeypatch.setattr(tcp, "PATIENCE", 0.5)
    with (
        dask.LocalCluster(n_workers=0, host="127.0.0.1", dashboard_address="127.0.0.1:0") as made,
        pytest.raises(InputError, match="has no workers"),
    ):
        pendulum().sweep(**ASKED, cluster=made.scheduler_address)


def test_a_script_that_its_processes_would_run_again_is_told(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        f"import freebody as fb\nsystem = fb.System.load({str(EXAMPLES / 'simple_pendulum.yaml')!r})\n"
        "try:\n    system.sweep({'L': '1, 2 m'}, find=['tension'], cluster='local:1')\n"
        "except fb.errors.InputError as error:\n    print(error)\n",
        encoding="utf-8",
    )
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True)
    assert 'put what it does under if __name__ == "__main__":' in done.stdout


# -- Slurm ------------------------------------------------------------------------------------
JOB = """#!/bin/bash
#SBATCH --array=1-2 --cpus-per-task=1
exec $FREEBODY_WORKER --nworkers $SLURM_CPUS_PER_TASK --no-nanny
"""
SBATCH = """#!/bin/bash
# runs a job where it stands, and notes how it was called
echo "sbatch $@" >> {folder}/called
SLURM_CPUS_PER_TASK=1 bash "${{@: -1}}" > {folder}/log 2>&1 &
echo $! > {folder}/pid
echo "4711;cluster"
"""
SCANCEL = """#!/bin/bash
echo "scancel $@" >> {folder}/called
kill $(cat {folder}/pid)
"""


def slurm(folder: Path, monkeypatch: pytest.MonkeyPatch, **commands: str) -> Path:
    """A job script, and commands in the place of those of Slurm."""
    for name, text in commands.items():
        path = folder / name
        path.write_text(text.format(folder=folder), encoding="utf-8")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
    script = folder / "job.sh"
    script.write_text(JOB, encoding="utf-8")
    return script


@pytest.mark.skipif(sys.platform == "win32", reason="Slurm is not there")
def test_jobs_of_slurm_give_the_bits_of_one_process(
    whole: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = slurm(tmp_path, monkeypatch, sbatch=SBATCH, scancel=SCANCEL)
    found = pendulum().sweep(**ASKED, cluster=f"slurm:{script}@127.0.0.1")
    assert found.digest == whole.digest
    called = (tmp_path / "called").read_text(encoding="utf-8").splitlines()
    assert called == [f"sbatch --parsable --export=ALL {script}", "scancel 4711"]


# a queue that is asked twice until the job begins
SQUEUE = """#!/bin/bash
echo asked >> {folder}/asked
if [ $(wc -l < {folder}/asked) -eq 2 ]; then
    . {folder}/environment
    SLURM_CPUS_PER_TASK=1 bash {folder}/job.sh > {folder}/log 2>&1 &
    echo $! > {folder}/pid
fi
echo PENDING
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Slurm is not there")
def test_jobs_are_waited_for_as_long_as_they_are_in_the_queue(
    whole: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(slurm_cluster, "PATIENCE", 0.5)
    sbatch = "#!/bin/bash\nexport -p > {folder}/environment\necho 4711\n"
    script = slurm(tmp_path, monkeypatch, sbatch=sbatch, squeue=SQUEUE, scancel=SCANCEL)
    found = pendulum().sweep(**ASKED, cluster=f"slurm:{script}@127.0.0.1")
    assert found.digest == whole.digest
    assert (tmp_path / "asked").read_text(encoding="utf-8").count("asked") >= 2
    assert (tmp_path / "called").read_text(encoding="utf-8") == "scancel 4711\n"


@pytest.mark.skipif(sys.platform == "win32", reason="Slurm is not there")
@pytest.mark.parametrize("squeue", ["", "echo slurm_load_jobs error: Invalid job id specified >&2; exit 1"])
def test_jobs_that_end_before_a_worker_came_are_told(
    squeue: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A job that is over is listed for some minutes, then it is unknown."""
    monkeypatch.setattr(slurm_cluster, "PATIENCE", 0.5)
    commands = {"sbatch": "echo 4711", "squeue": squeue, "scancel": ""}
    script = slurm(tmp_path, monkeypatch, **{name: f"#!/bin/bash\n{text}\n" for name, text in commands.items()})
    with pytest.raises(InputError, match=r"job\.sh@127\.0\.0\.1: the jobs ended before .* slurm-4711_1\.out, says why"):
        pendulum().sweep(**ASKED, cluster=f"slurm:{script}@127.0.0.1")


@pytest.mark.skipif(sys.platform == "win32", reason="Slurm is not there")
def test_ctrl_c_in_the_queue_takes_the_jobs_out_of_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(slurm_cluster, "PATIENCE", 0.5)
    squeue = f"#!/bin/bash\nkill -INT {os.getpid()}\necho PENDING\n"
    scancel = '#!/bin/bash\necho "scancel $@" >> {folder}/called\n'
    script = slurm(tmp_path, monkeypatch, sbatch="#!/bin/bash\necho 4711\n", squeue=squeue, scancel=scancel)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # what was started in the background ignores it
    try:
        found = pendulum().sweep(**ASKED, cluster=f"slurm:{script}@127.0.0.1", out=tmp_path / "a.csv")
    finally:
        signal.signal(signal.SIGINT, before)
    assert (found.is_complete, found.n_done) == (False, 0)
    assert (tmp_path / "called").read_text(encoding="utf-8") == "scancel 4711\n"
    assert (tmp_path / "a.csv.part").is_dir()


def test_what_slurm_refuses_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    script = slurm(tmp_path, monkeypatch, sbatch="#!/bin/bash\necho invalid partition >&2\nexit 1\n")
    with pytest.raises(InputError, match="sbatch refuses the job: invalid partition"):
        pendulum().sweep(**ASKED, cluster=f"slurm:{script}@127.0.0.1")
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(InputError, match="there is no sbatch here"):
        pendulum().sweep(**ASKED, cluster=f"slurm:{script}@127.0.0.1")
    script.write_text("#!/bin/bash\n", encoding="utf-8")
    with pytest.raises(InputError, match=re.escape("starts no worker: end it with a line exec $FREEBODY_WORKER")):
        pendulum().sweep(**ASKED, cluster=f"slurm:{script}")


def test_the_threads_of_this_process_are_no_more_than_before(cluster: Any) -> None:
    """A client leaves none behind that would keep the program from ending."""
    before = {t for t in threading.enumerate() if not t.daemon}
    pendulum().sweep(**ASKED, cluster=cluster.scheduler_address)
    assert not {t for t in threading.enumerate() if not t.daemon} - before
