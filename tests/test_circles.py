"""Modules import each other in one direction, imports inside of functions and for types included."""

from __future__ import annotations

from graphlib import CycleError, TopologicalSorter

import grimp
import pytest

# an import that closes a circle; the part that it reaches back to is still to be cut in two
KNOWN = {
    ("symbolic.field", "symbolic.signs"),
}


@pytest.fixture(scope="module")
def imports() -> dict[str, set[str]]:
    """By module, below the package: the modules that it imports anywhere."""
    graph = grimp.build_graph("freebody", cache_dir=None)
    below = "freebody."
    return {
        module.removeprefix(below): {
            other.removeprefix(below) for other in graph.find_modules_directly_imported_by(module)
        }
        for module in graph.modules
    }


def test_no_circle_is_closed_but_by_the_imports_known(imports: dict[str, set[str]]) -> None:
    cut = {module: {other for other in found if (module, other) not in KNOWN} for module, found in imports.items()}
    try:
        TopologicalSorter(cut).prepare()
    except CycleError as error:
        pytest.fail(" <- ".join(error.args[1]))


def test_every_known_import_is_there_and_closes_a_circle(imports: dict[str, set[str]]) -> None:
    for module, other in KNOWN:
        assert other in imports[module], f"{module} imports {other} no more"
        open_again = {m: {o for o in found if (m, o) not in KNOWN - {(module, other)}} for m, found in imports.items()}
        with pytest.raises(CycleError):
            TopologicalSorter(open_again).prepare()
