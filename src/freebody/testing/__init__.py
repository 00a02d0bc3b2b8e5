"""Testing models, and testing freebody with models.

    python -m freebody.testing FILE...      does a model keep its answers when it is renamed, turned, rescaled ...?
    python -m freebody.testing --random N   does every study of random models end in an answer or in words?

`random_model` draws valid models of all kinds, `mutated` spoils model files, `RELATIONS` are changes that must not
change what is true, `conformance` has the checks that every connection, load and integrator passes: run them on your
own. Everything is imported on first use, and nothing here needs pytest.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from freebody.testing.models import Taste, random_model
    from freebody.testing.mutations import MUTATIONS, mutated
    from freebody.testing.outcomes import End, Outcome, run, studies
    from freebody.testing.relations import RELATIONS, Relation, RelationVerdict, check

_HOMES = {
    **dict.fromkeys(("Taste", "random_model"), "models"),
    **dict.fromkeys(("MUTATIONS", "mutated"), "mutations"),
    **dict.fromkeys(("RELATIONS", "Relation", "RelationVerdict", "check"), "relations"),
    **dict.fromkeys(("End", "Outcome", "run", "studies"), "outcomes"),
}

__all__ = [
    "MUTATIONS",
    "RELATIONS",
    "End",
    "Outcome",
    "Relation",
    "RelationVerdict",
    "Taste",
    "check",
    "mutated",
    "random_model",
    "run",
    "studies",
]


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(f"freebody.testing.{_HOMES[name]}"), name)
    raise AttributeError(f"module 'freebody.testing' has no attribute {name!r}")
