"""Mistakes in counting freedoms: a load taken for a constraint, the ground for a body, a connection forgotten,
dependent constraints counted as if they were independent."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from freebody.language.sentences import Sentence
from freebody.study.mobility.gruebler import Gruebler, gruebler
from freebody.system.system import System


def miscounted(system: System, wrong: Mapping[str, str]) -> dict[str, Sentence]:
    """By letter: the mistake that gives the number of an option."""
    counts = list(_counts(system, gruebler(system)))
    found: dict[str, Sentence] = {}
    for letter, text in wrong.items():
        try:
            wanted = Fraction(text.strip())
        except (ValueError, ZeroDivisionError):
            continue
        said = next((s for s, n in counts if n == wanted), None)
        if said is not None:
            found[letter] = Sentence("mistake.leads", {"first": said})
    return found


def _counts(system: System, count: Gruebler) -> Iterator[tuple[Sentence, int]]:
    """Wrong counts, the most common first."""
    own = count.count
    yield Sentence("mistake.count_dependent"), own
    joining = [p for p in system.loads if system.loads[p].stores_energy and _joins(system, p)]
    for load in joining:
        yield Sentence("mistake.count_load", {"load": load}), own - 1
    yield Sentence("mistake.count_ground"), own + count.n
    for c in count.connections:
        if c.n:
            yield Sentence("mistake.count_without", {"connection": c.connection}), own + c.n
    kinds = dict.fromkeys(c.kind for c in count.connections)
    for kind in kinds:
        of_kind = [c for c in count.connections if c.kind == kind]
        if len(of_kind) > 1:
            names = tuple(c.connection for c in of_kind)
            yield Sentence("mistake.count_without_all", {"connections": names}), own + sum(c.n for c in of_kind)
    points = [c for c in count.connections if c.n == count.n - 1]
    for c in points:
        yield Sentence("mistake.count_one", {"connection": c.connection}), own + c.n - 1


def _joins(system: System, load: str) -> bool:
    """Whether a load acts between two places, as a spring does."""
    return system.loads[load].kind not in ("gravity", "force", "torque")
