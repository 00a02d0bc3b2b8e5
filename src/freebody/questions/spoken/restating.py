"""What is said otherwise than it is asked for elsewhere, by rules of a file of its own (xx.restating.toml): while the
bob circles steadily is in steady motion; to two decimal places says nothing of what is asked.

They come before names are looked for: a part of the rope is no part of the model.
"""

from __future__ import annotations

from freebody.questions.spoken.lexicon import languages, restatements


def restated(text: str) -> str:
    """The text in words that are asked for elsewhere."""
    for language in languages():
        for pattern, written in restatements(language):
            text = pattern.sub(written, text)
    return text
