"""What is left to the slow part of the tests is there, and is no more than a part."""

from __future__ import annotations

from pathlib import Path

from conftest import long_tests

TESTS = Path(__file__).parent


def test_what_is_left_to_the_slow_part_exists() -> None:
    examples, tests = long_tests()
    known = {path.stem for path in (TESTS.parent / "examples").glob("*.yaml")}
    assert examples <= known
    for test in tests:
        path, _, function = test.partition("[")[0].partition("::")
        assert f"def {function}(" in (TESTS.parent / path).read_text(encoding="utf-8"), test


def test_the_exercise_sheet_is_in_every_run() -> None:
    examples, _ = long_tests()
    assert 4 * len(examples) <= 3 * len(list((TESTS.parent / "examples").glob("*.yaml")))
    sheet = ("multi_bar_platform", "body_on_driven_roller", "planetary_gear", "atwood_machine", "cardan_joint")
    others = ("disk_rolling_down_incline", "sphere_launched_down_incline", "disk_on_angled_shaft")
    assert not examples & {*sheet, *others}
