"""What the studies say about the bundled examples is what they said before; see `goldens`.

Solutions, derivations, mobility and conserved quantities are held where they are worked out anyway, in the tests named
in `ELSEWHERE`; motions, pictures, small motions and statics here.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from goldens import ABSOLUTE, RELATIVE, WRITE, assert_golden, digest

EXAMPLES = Path(__file__).parents[1] / "examples"
NAMES = sorted(path.stem for path in EXAMPLES.glob("*.yaml"))
ELSEWHERE = ("test_examples.py", "test_narrative.py", "test_mobility.py", "test_conserved.py")

UNTIL, N_SEEN = 0.5, 5  # seconds of each motion, and at how many instants it is looked at
# the search for an equilibrium takes seconds in these
SLOW_MODES = ("bennett_linkage", "bevel_differential", "bouncing_ball", "gyroscope_in_gimbals", "spatial_slider_crank")

example = pytest.mark.parametrize("name", NAMES)


def load(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


def said(study: Callable[[], Any]) -> dict[str, Any]:
    """What a study prints and what it gives to machines, or why it cannot answer."""
    try:
        found = study()
    except fb.FreebodyError as error:
        return {"error": str(error).splitlines()}
    return {"text": found.to_text().splitlines(), "json": found.to_plain()}


def motion(system: fb.System) -> dict[str, Any]:
    """Measures and places at a few instants, and the events: nothing that round-off may change, as a count of steps."""
    try:
        found = system.simulate(UNTIL, every=UNTIL / N_SEEN)
    except fb.FreebodyError as error:
        return {"error": str(error).splitlines()}
    course = found.course
    at = [int(np.abs(course.times - UNTIL * k / N_SEEN).argmin()) for k in range(N_SEEN + 1)]

    def seen(values: Any) -> list[str]:
        rows = np.atleast_2d(np.asarray(values, float)[at].T).T
        return [" ".join(f"{x:.9e}" for x in row) for row in rows]

    record = course.contact
    return {
        "status": str(found.status),
        "message": found.message,
        "assumptions": list(found.simulator.assumptions),
        "events": [[e.name, e.kind, e.time] for e in found.events],
        "phases": None if record is None else record.n_phases,
        "measures": {name: seen(values) for name, (values, _rates, _second) in found.series.items()},
        "poses": {body.name: seen(course.poses[:, k]) for k, body in enumerate(system.moving)},
    }


@example
def test_the_motion_of_an_example_is_the_golden_one(name: str) -> None:
    assert_golden("simulate", name, motion(load(name)))


@example
def test_the_picture_of_an_example_is_the_golden_one(name: str) -> None:
    assert_golden("draw", name, digest(load(name).picture().svg()))


@example
def test_small_motions_of_an_example_are_the_golden_ones(name: str) -> None:
    if name in SLOW_MODES:
        pytest.skip("its search for an equilibrium takes seconds")
    assert_golden("modes", name, said(load(name).modes))


@example
def test_the_statics_of_an_example_are_the_golden_ones(name: str) -> None:
    system = load(name)
    if system.dry_friction and not system.space:
        assert_golden("statics", name, said(system.statics))


def test_goldens_tell_a_change_from_round_off(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("goldens.FOLDER", tmp_path)
    monkeypatch.setenv(WRITE, "1")
    assert_golden("solve", "one", {"answer": "2/3 m*g", "value": 6.54, "zero": 0.0})
    monkeypatch.delenv(WRITE)
    for changed in ({"value": 6.54 * (1 + RELATIVE / 2)}, {"zero": ABSOLUTE / 2}):
        assert_golden("solve", "one", {"answer": "2/3 m*g", "value": 6.54, "zero": 0.0} | changed)
    for changed in ({"answer": "3/3 m*g"}, {"answer": "2/3 m*h"}, {"value": 6.541}, {"more": 1}):
        with pytest.raises(AssertionError, match=r"(?s)not what it was.*\n[+-] "):
            assert_golden("solve", "one", {"answer": "2/3 m*g", "value": 6.54, "zero": 0.0} | changed)
    with pytest.raises(AssertionError, match="never written"):
        assert_golden("solve", "two", {})


if __name__ == "__main__":
    if sys.argv[1:2] != ["--write"]:
        sys.exit(__doc__)
    os.environ[WRITE] = "1"
    files = [str(Path(__file__).parent / name) for name in (Path(__file__).name, *ELSEWHERE)]
    chosen = "golden_one" if not sys.argv[2:] else f"golden_one and ({' or '.join(sys.argv[2:])})"
    sys.exit(pytest.main(["-n", "0", "-m", "slow or not slow", "-k", chosen, *files]))
