"""Many cases of one system: parameters and start values vary, answers and motions are looked at in every case."""

from __future__ import annotations

import hashlib
import math
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path
from typing import Any

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.ensemble.devices import GPU
from freebody.numeric.options import SimulationOptions
from freebody.questions.reading import Question
from freebody.study.given import each
from freebody.study.sweeps import remote, running
from freebody.study.sweeps.answers import AnswerEvaluator
from freebody.study.sweeps.clusters import check_cluster, connected
from freebody.study.sweeps.ensembles.beside import check_beside
from freebody.study.sweeps.ensembles.evaluator import EnsembleEvaluator
from freebody.study.sweeps.evaluators import Evaluator, not_admissible, refused_by_reader
from freebody.study.sweeps.formats import check_data_path, formats
from freebody.study.sweeps.motions import MotionEvaluator
from freebody.study.sweeps.plan import Given, Plan, plan
from freebody.study.sweeps.result import Sweep
from freebody.study.sweeps.running import BLOCK, Progress
from freebody.study.sweeps.store import Store, folder_for, in_memory, on_disk
from freebody.study.worded import in_words
from freebody.system.system import System

MOST_IN_MEMORY = 2_000_000_000  # bytes
ENGINE = "engine"  # the device that follows every motion, one case by itself
BLOCK_OF_CARD = 1 << 20  # cases that a graphics card gets at once


@in_words
def sweep(
    system: System,
    vary: Mapping[str, Given] | None = None,
    *,
    over: Mapping[str, Given] | None = None,
    sample: str | None = None,
    seed: int = 0,
    find: str | Sequence[str] = (),
    record: str | Sequence[str] = (),
    until: float | None = None,
    events: str | Sequence[str] = (),
    options: SimulationOptions | None = None,
    threads: int | None = None,
    cluster: str | None = None,
    device: str = ENGINE,
    block: int | None = None,
    out: str | Path | Sequence[str | Path] = (),
    resume: bool = False,
    progress: Progress | None = None,
    **given: Any,
) -> Sweep:
    """Answers and motions of a system in many cases.

    vary: how parameters, and start values of named measures and of their rates, vary: a text as "1..3 kg:50", or
    numbers in SI; over: the same for what every case is gone over. sample: which cases; a grid if nothing is said.
    seed: of what is drawn. find: questions, by id or in words; without `find` and `record` those of the model. record:
    what is recorded of the motion up to `until` [s]; events: as of `simulate`; options, given: how it is followed.
    threads: for what is computed case by case, as many as there are processors if nothing is said; cluster: where cases
    are looked at instead, as "local:8", "tcp://scheduler:8786" or "slurm:job.sh" (extra `sweep`). device: "engine", or
    "cpu" or "gpu" for smooth motions by compiled equations of the model's own (extras `ensemble`, `gpu`); some cases
    are followed by the engine as well. block: cases that are in memory at once, 4096 if nothing is said, a million on a
    graphics card. out: files to write; the first data file has a folder beside it until all is done, from which
    `resume` goes on.

    Raises InputError for what cannot be read, for files that cannot be written and for a cluster that is not there,
    CannotAnswer where it loses all its workers and for what a device does not follow, RoutesDisagree where the engine
    comes to other numbers than it. A case that fails is a status of the result. After Ctrl-C the result has what was
    done."""
    began = time.perf_counter()
    find, record, events = each(find), each(record), each(events)
    threads = running.n_threads(threads)
    block = (BLOCK_OF_CARD if device == GPU else BLOCK) if block is None else block
    running.check(threads, block)
    if cluster is not None:
        if device != ENGINE:
            raise InputError(Message("choose --cluster or --device, not both"))
        check_cluster(cluster)
    cases = plan(system, vary or {}, over or {}, sample, seed)
    followed = replace(options or SimulationOptions(), **given)
    evaluators = _evaluators(system, cases, find, record, until, events, followed, device, threads)
    names = [v.name for v in cases.names] + [c.name for e in evaluators for c in e.columns]
    for name in names:
        if names.count(name) > 1:
            raise InputError(Message("{name} would stand twice among the results; ask for it once", name=name))
    paths = [Path(path) for path in ([out] if isinstance(out, str | Path) else out)]
    for path in paths:
        _check(path)
    for evaluator in evaluators:
        if isinstance(evaluator, EnsembleEvaluator):
            check_beside(evaluator, cases)
    settings = (seed, until, events, followed, *([] if device == ENGINE else [device]))
    store = _store(system, cases, evaluators, settings, paths, resume=resume)
    if cluster is None:
        is_over = running.run(cases, evaluators, store, threads=threads, block=block, progress=progress)
    else:
        is_over = False
        with suppress(KeyboardInterrupt), connected(cluster) as there:  # the first worker may take long to come
            is_over = remote.run(there, cases, evaluators, store, block=block, progress=progress)
            threads = there.n_threads
    found = Sweep(system, cases, evaluators, store, time.perf_counter() - began, threads, cluster, device)
    if not is_over:
        return found
    try:
        written = tuple(file for path in paths for file in found.write(path))
    except InputError as error:
        raise InputError(store.kept(str(error))) from error
    _ = found.digest, found.counts, found.statistics, found.failures
    store.remove()
    return replace(found, files=written)


def _evaluators(
    given: System,
    cases: Plan,
    find: Sequence[str],
    record: Sequence[str],
    until: float | None,
    events: Sequence[str],
    options: SimulationOptions,
    device: str,
    threads: int,
) -> tuple[Evaluator, ...]:
    """What is asked of every case."""
    system = cases.system
    questions = [] if not find and (record or until is not None) else questions_asked(system, find)
    read = given if _may_be_refused(given, cases) else None
    found: list[Evaluator] = [AnswerEvaluator(system, q, read) for q in questions]
    if record and until is None:
        raise InputError(Message("how long is the motion? Say until when it is followed, as --until '5 s'"))
    if device != ENGINE:
        if until is None:
            raise InputError(Message("--device is for motions: say what to record, and until when"))
        if events:
            raise InputError(Message("only the engine looks for events: leave out --device"))
        varied = [v.parameter for v in cases.names]
        found.append(EnsembleEvaluator(system, record, until, options, read, varied, device, threads))
    elif until is not None:
        found.append(MotionEvaluator(system, record, until, options, events, read))
    if not found:
        raise InputError(Message("nothing is asked: the model has no questions; say what to find or to record"))
    return tuple(found)


def _may_be_refused(system: System, cases: Plan) -> bool:
    """Whether the reader of the model finds a value at an end of a range wrong for another reason than its sign."""
    for name, ends in cases.extents.items():
        for x in ends:
            is_number = name in system.parameters and math.isfinite(x)
            if is_number and not not_admissible(system, {name: x}) and refused_by_reader(system, {name: x}):
                return True
    return False


def questions_asked(system: System, find: Sequence[str]) -> list[Question]:
    """Questions by id or in words, all of the model if there are none. Raises InputError."""
    by_id = {q.id: q for q in system.questions}
    found: list[Question] = []
    for text in find:
        asked = (by_id[text],) if text in by_id else system.asked(text)
        found += asked if text in by_id else [replace(q, id=text if len(asked) == 1 else q.text) for q in asked]
    return found or list(system.questions)


def _check(path: Path) -> None:
    """Raises InputError if a file cannot be written, before anything is computed."""
    if path.suffix in formats():
        check_data_path(path)
        return
    from freebody.present.report.write import check_report_path

    try:
        check_report_path(path)
    except InputError as error:
        known = ", ".join(formats())
        raise InputError(Message("{error}; or, for data, {known}", error=error, known=known)) from error


def _store(
    system: System, cases: Plan, evaluators: Sequence[Evaluator], settings: Any, paths: Sequence[Path], *, resume: bool
) -> Store:
    """In a folder beside the first file of data, else in memory."""
    columns = [f"{c.name} [{c.unit}]" for e in evaluators for c in e.columns]
    data = [path for path in paths if path.suffix in formats()]
    if not data:
        if resume:
            raise InputError(Message("only a sweep with a file of data can go on: give the same -o again"))
        if cases.n * (len(columns) + 1) * 8 > MOST_IN_MEMORY:
            raise InputError(Message("{n:,} cases do not fit into memory: write them to a file with -o", n=cases.n))
        return in_memory(cases.n, len(columns), len(evaluators))
    about = {
        "model": _digest(system.to_yaml()),
        "values": _digest(repr((cases.sampled, cases.over))),
        "results": columns,
        "settings": _digest(repr(settings)),
        "cases": cases.n,
        "version of the program": version("freebody"),
    }
    return on_disk(folder_for(data[0]), about, cases.n, len(columns), len(evaluators), resume=resume)


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()
