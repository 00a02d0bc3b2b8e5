"""Constructions that say at length what others say shortly, by rules of a file of its own (xx.recasting.toml).

The speed with which the crate returns is with what speed it returns, the time required for it to stop is how long it
takes until it stops.

They are tried where a text is not understood as it stands, one after the other, each on what those before it have made
of the text: a rule says the same in other words, whatever it is about, and drops nothing that tells when or of what.
"""

from __future__ import annotations

from collections.abc import Iterator

from freebody.questions.spoken.lexicon import languages, recastings


def recast(text: str) -> Iterator[str]:
    """What a text says in other constructions, the nearest to it first."""
    for language in languages():
        said = " ".join(text.split())
        for pattern, written in recastings(language):
            put = " ".join(pattern.sub(written, said).split())
            if put != said:
                said = put
                yield put
