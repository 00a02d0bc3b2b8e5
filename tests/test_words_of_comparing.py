"""What a question says of changed parameters is looked for in each language, so each has all of these patterns."""

from __future__ import annotations

from freebody.questions.spoken.lexicon import compared_in, languages


def test_each_language_has_the_patterns_of_changes() -> None:
    tables = [table for language in languages() if (table := compared_in(language, "changes"))]
    assert len(tables) > 1
    assert all(set(tables[0]) == set(other) for other in tables)
