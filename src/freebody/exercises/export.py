"""From systems to a package for a platform, which has passed its self-tests."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from freebody.errors import InputError, SelfTestFailed
from freebody.exercises import selftests
from freebody.exercises.bank import Bank
from freebody.exercises.making import made_bank
from freebody.exercises.package import check_folder, written
from freebody.exercises.platforms import platform_of
from freebody.language.sentences import Message, lines
from freebody.narrative.sheets.sheet import load_systems
from freebody.progress import busy_with
from freebody.system.system import System

_MOST_TOLD = 10


@dataclass(frozen=True)
class Exported:
    """What was written. files: with their folder; names: of the questions; n_tests: self-tests that were passed; told:
    what the platform cannot express."""

    platform: str
    files: tuple[Path, ...]
    names: tuple[str, ...]
    n_tests: int
    told: tuple[str, ...]


def export(
    models: System | str | Path | Iterable[System | str | Path],
    *,
    to: str,
    out: str | Path,
    variants: int = 1,
    seed: int = 0,
    language: str = "en",
    tolerance: str = "1 %",
    numeric: bool = False,
) -> Exported:
    """Writes the questions of systems or model files as a package for a learning platform, and examines it.

    to: the platform, as "gift"; out: a new or empty folder; the others as in `made_bank`. Raises InputError for a
    platform that there is not and a folder that cannot be written, SelfTestFailed where the package does not mark the
    answers of its self-tests as it must."""
    platform_of(to)
    check_folder(Path(out))
    given = [models] if isinstance(models, System | str | Path) else list(models)
    files = iter(load_systems([model for model in given if not isinstance(model, System)]))
    systems = [model if isinstance(model, System) else next(files) for model in given]
    bank = made_bank(systems, variants=variants, seed=seed, language=language, tolerance=tolerance, numeric=numeric)
    return export_bank(bank, to, Path(out))


def export_bank(bank: Bank, to: str, folder: Path) -> Exported:
    """Writes a bank for a platform. Raises InputError where nothing of it can be expressed there, SelfTestFailed."""
    platform = platform_of(to)
    busy_with(f"writing {folder}")
    package = platform.write(bank)
    if not package.names:
        raise InputError(lines([Message("no question can be expressed for {platform}", platform=to), *package.told]))
    files = {**package.files, selftests.FILE: selftests.written(to, package.tests)}
    with written(files, folder) as place:
        found = examine(place)
    return Exported(to, tuple(folder / name for name in files), package.names, found, package.told)


def examine(folder: str | Path) -> int:
    """Runs the self-tests of a written package by freebody's own reader of its format, and returns how many there are.
    Raises InputError for a folder without a package, SelfTestFailed with the tests that fail."""
    place = Path(folder)
    try:
        content = (place / selftests.FILE).read_bytes()
    except OSError as error:
        told = Message("{folder} has no {file}, so it is no package", folder=place, file=selftests.FILE)
        raise InputError(told) from error
    name, tests = selftests.read(content)
    platform = platform_of(name)
    try:
        questions = platform.read(place)
    except OSError as error:
        raise InputError(Message("{folder} cannot be read: {why}", folder=place, why=error.strerror)) from error
    failed = selftests.failures(questions, tests)
    if failed:
        raise SelfTestFailed(_told(failed, len(tests)))
    return len(tests)


def _told(failed: Sequence[selftests.Failure], n: int) -> str:
    more = len(failed) - _MOST_TOLD
    head = Message("{n} of {all} self-tests fail, so the package is not to be used:", n=len(failed), all=n)
    rest = [Message("and {n} others", n=more)] if more > 0 else []
    return lines([head, *(selftests.told(failure) for failure in failed[:_MOST_TOLD]), *rest])
