"""What is said otherwise than it is asked for elsewhere, by rules of a file of its own (xx.restating.toml).

Some rules come before names are looked for: while the bob circles steadily is in steady motion; to two decimal places
says nothing of what is asked; a part of the rope is no part of the model. Others put constructions that say at length
what others say shortly, and are tried where a text is not understood as it stands, one after the other, each on what
those before it have made of the text: the speed with which the crate returns is with what speed it returns. They say
the same whatever it is about, and drop nothing that tells when or of what.
"""

from __future__ import annotations

from collections.abc import Iterator

from freebody.questions.spoken.lexicon import languages, recastings, restatements


def restated(text: str) -> str:
    """The text in words that are asked for elsewhere."""
    for language in languages():
        for pattern, written in restatements(language):
            text = pattern.sub(written, text)
    return text


def recast(text: str) -> Iterator[str]:
    """What a text says in other constructions, the nearest to it first."""
    for language in languages():
        said = " ".join(text.split())
        for pattern, written in recastings(language):
            put = " ".join(pattern.sub(written, said).split())
            if put != said:
                said = put
                yield put
