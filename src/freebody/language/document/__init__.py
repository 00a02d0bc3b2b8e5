"""The YAML border: text in, plain data with places out, and the text again.

A text is read from YAML's event stream alone: no object is built from a tag, no alias is followed, and
every refusal is noted with its place. Each value keeps the span of text it came from, so a change replaces
that span only, and every other character, comments included, stays as it was.

tree            values with their places, and the limits
scalars         what a bare word means
composer        from text to the tree
syntax_errors   YAML's complaints in plain language
plain           plain data, checked
writer          from plain data to text
file            a file's text
document        the document itself

Source: YAML 1.2.2, sections 7 and 10.3.
"""

from __future__ import annotations

from freebody.language.document.document import Document
from freebody.language.document.tree import MAX_BYTES, MAX_DEPTH, MAX_KEY, MAX_LINE, MAX_VALUES, Place, Scalar
from freebody.language.document.writer import WIDTH

__all__ = [
    "MAX_BYTES",
    "MAX_DEPTH",
    "MAX_KEY",
    "MAX_LINE",
    "MAX_VALUES",
    "WIDTH",
    "Document",
    "Place",
    "Scalar",
]
