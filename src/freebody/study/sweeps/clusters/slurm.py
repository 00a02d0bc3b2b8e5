"""Jobs of Slurm: a job script of one's own, in which `$FREEBODY_WORKER` starts a worker.

A scheduler runs in this process; `sbatch` gets the script, whose `#SBATCH --array` says how many jobs there are, and
`scancel` ends them when the sweep is over. Behind an @ stands the address by which the jobs reach this machine, where
it has several.

    #!/bin/bash
    #SBATCH --array=1-32 --cpus-per-task=8 --time=2:00:00
    exec $FREEBODY_WORKER --nworkers $SLURM_CPUS_PER_TASK
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Generator, Sequence
from contextlib import contextmanager, suppress
from importlib import import_module
from pathlib import Path

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.study.sweeps.clusters.base import Scheduler
from freebody.study.sweeps.clusters.local import began

FORM = "slurm:job.sh"
PATIENCE = 5  # a queue may take a day: as long as the jobs are in it
WORKER = "FREEBODY_WORKER"


def check(rest: str) -> None:
    path = Path(rest.rpartition("@")[0] or rest)
    try:
        script = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(Message("the job script {path} cannot be read: {why}", path=path, why=error)) from error
    if f"${WORKER}" not in script and f"${{{WORKER}}}" not in script:
        raise InputError(
            Message("{path} starts no worker: end it with a line exec ${worker}", path=path, worker=WORKER)
        )


@contextmanager
def scheduler(rest: str) -> Generator[Scheduler]:
    path, _, host = rest.rpartition("@") if "@" in rest else (rest, "", "")
    with began(0, host or import_module("distributed.utils").get_ip()) as address:
        job = _submitted(path, address)
        without = Message(
            "the jobs ended before a worker came; what they wrote, as slurm-{job}_1.out, says why", job=job
        )
        try:
            yield Scheduler(address, lambda: _are_queued(job), without)
        finally:
            with suppress(InputError):  # jobs without a scheduler end by themselves
                _said(["scancel", job])


def _submitted(path: str, address: str) -> str:
    """The number of the job. `--death-timeout`: a worker ends when there has been no scheduler for so long."""
    worker = f"{sys.executable} -m distributed.cli.dask_worker {address} --nthreads 1 --no-dashboard --death-timeout 60"
    # the logs of jobs have what is wrong, and not that connections end when the sweep is over
    more = {WORKER: worker, "DASK_LOGGING__DISTRIBUTED": "warning"}
    found = _said(["sbatch", "--parsable", "--export=ALL", path], **more)
    return found.strip().partition(";")[0]  # behind it stands the name of the cluster, where there are several


def _are_queued(job: str) -> bool:
    """Whether jobs wait or run; also where Slurm does not answer at the moment."""
    asked = ["squeue", "--noheader", "--format=%T", f"--jobs={job}"]
    try:
        done = subprocess.run(asked, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return True
    return bool(done.stdout.strip()) if done.returncode == 0 else "Invalid job id" not in done.stderr


def _said(command: Sequence[str], **more: str) -> str:
    """What a command of Slurm prints. Raises InputError."""
    try:
        done = subprocess.run(command, env={**os.environ, **more}, capture_output=True, text=True, check=True)
    except FileNotFoundError as error:
        raise InputError(
            Message("there is no {command} here: run the sweep on a machine of the cluster", command=command[0])
        ) from error
    except subprocess.CalledProcessError as error:
        told = Message("{command} refuses the job: {why}", command=command[0], why=error.stderr.strip())
        raise InputError(told) from error
    return done.stdout
