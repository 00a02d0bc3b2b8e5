"""Every snippet of the documentation is run, and shows what comes out."""

from __future__ import annotations

from pathlib import Path

import pytest

from snippets import PAGES, ROOT, run


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_a_page_shows_what_comes_out(page: Path, tmp_path: Path) -> None:
    """To put the true outputs in: python tests/snippets.py PAGE."""
    wrong = run(page, tmp_path).corrected
    assert not wrong, f"{page}\nshown:\n{wrong[0][0].text}\nreal:\n{wrong[0][1]}"
