"""`python -m freebody.testing FILE...`: the metamorphic relations of models; `--random N`: all studies of random
models. Exit codes: 0 all hold or do not apply, and no study ends in a defect; 1 otherwise; 2 bad input."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from contextlib import ExitStack

from freebody.api import System
from freebody.errors import FreebodyError, InputError
from freebody.testing.campaign import campaign, report
from freebody.testing.facts import STUDIES
from freebody.testing.observing import observed
from freebody.testing.outcomes import studies, untyped
from freebody.testing.relations import RELATIONS, SHORT, check


def _arguments(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        "python -m freebody.testing",
        description="Changes a model in ways that must not change what is true of it, and compares the answers; "
        "or draws random models and runs every study on each.",
        epilog="relations: " + "; ".join(RELATIONS),
    )
    parser.add_argument("files", nargs="*", metavar="FILE", help="model files")
    parser.add_argument(
        "--relation", action="append", choices=sorted(RELATIONS), metavar="NAME", help="only this one (repeatable)"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the random choices, or of the first random model")
    parser.add_argument(
        "--study",
        action="append",
        choices=list(studies()),
        metavar="NAME",
        default=[],
        help=f"compare it too ({', '.join(sorted(STUDIES))}), or run only this one on random models (repeatable)",
    )
    parser.add_argument("--motion", action="store_true", help="compare short simulations too")
    parser.add_argument("--random", type=int, metavar="N", help="run all studies on N random models instead")
    parser.add_argument("--limit", type=float, default=10.0, metavar="SECONDS", help="processor time of one study")
    parser.add_argument("-o", dest="out", metavar="FILE.jsonl", help="file for every outcome, one a line")
    given = parser.parse_args(arguments)
    if (given.random is None) == (not given.files):
        parser.error("model files, or --random N")
    if given.files and not {*given.study} <= {*STUDIES}:
        parser.error(f"what can be compared is {', '.join(sorted(STUDIES))}")
    return given


def main(arguments: Sequence[str] | None = None) -> int:
    """One line a relation: pass, FAIL or not applicable, and what differs."""
    given = _arguments(arguments)
    if given.random is not None:
        return _random(given)
    code = 0
    for file in given.files:
        print(file)
        try:
            system = System.load(file)
            before = observed(system, until=SHORT if given.motion else None, studies=given.study)
        except FreebodyError as error:
            print(error, file=sys.stderr)
            code = max(code, 2 if isinstance(error, InputError) else 1)
            continue
        for name in given.relation or RELATIONS:
            try:
                verdict = check(RELATIONS[name], system, seed=given.seed, before=before)
                word, told = verdict.word, verdict.differences
            except Exception as error:  # a changed model that ends in an exception is a failure of the relation
                fault = untyped(name, error)
                word, told = "FAIL", (f"{fault.message} ({fault.place})",)
            print(f"    {name:<20}{word:<16}{told[0] if told else ''}".rstrip())
            for text in told[1:]:
                print(f"    {'':<36}{text}")
            if word == "FAIL":
                code = max(code, 1)
    return code


def _random(given: argparse.Namespace) -> int:
    """Every study of random models: the defects as they come, and a table."""
    seeds = range(given.seed, given.seed + given.random)
    code = 0
    with ExitStack() as stack:
        file = stack.enter_context(open(given.out, "w", encoding="utf-8")) if given.out else None
        told = campaign(seeds, given.study or list(studies()), given.limit)
        for line in report(told, file):
            code = code or int(line.startswith("seed "))
            print(line, flush=True)
    return code


if __name__ == "__main__":
    sys.exit(main())
