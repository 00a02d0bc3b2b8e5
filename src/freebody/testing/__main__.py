"""`python -m freebody.testing FILE...`: the metamorphic relations of models. Exit codes: 0 all hold or do not apply, 1
one fails, 2 bad input."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from freebody.api import System
from freebody.errors import FreebodyError, InputError
from freebody.testing.facts import STUDIES
from freebody.testing.observing import observed
from freebody.testing.relations import RELATIONS, SHORT, check
from freebody.testing.studies import untyped


def _arguments(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        "python -m freebody.testing",
        description="Changes a model in ways that must not change what is true of it, and compares the answers.",
        epilog="relations: " + "; ".join(RELATIONS),
    )
    parser.add_argument("files", nargs="+", metavar="FILE", help="model files")
    parser.add_argument(
        "--relation", action="append", choices=sorted(RELATIONS), metavar="NAME", help="only this one (repeatable)"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the random choices: another seed, another order")
    parser.add_argument(
        "--study",
        action="append",
        choices=sorted(STUDIES),
        metavar="NAME",
        default=[],
        help="compare it too (repeatable)",
    )
    parser.add_argument("--motion", action="store_true", help="compare short simulations too")
    return parser.parse_args(arguments)


def main(arguments: Sequence[str] | None = None) -> int:
    """One line a relation: pass, FAIL or not applicable, and what differs."""
    given = _arguments(arguments)
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


if __name__ == "__main__":
    sys.exit(main())
