"""XML of packages: written without surprises, read without entities of its own and without anything from elsewhere."""

from __future__ import annotations

from html import escape
from xml.etree import ElementTree
from xml.etree.ElementTree import Element
from xml.parsers import expat

from freebody.errors import InputError
from freebody.language.plain_text import plain
from freebody.language.sentences import Message

HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'


class _Declared(Exception):
    """A document type, which could define entities."""


def words(text: str) -> str:
    """A text as it stands in an element or an attribute."""
    return escape(plain(text), quote=True)


def content(markup: str) -> str:
    """Markup as the text of an element, kept sign by sign."""
    return escape(markup, quote=False)


def parsed(document: bytes, file: str) -> Element:
    """The root of a document. Raises InputError for one that is not well-formed or declares a type: none of the formats
    has one, and entities are declared there."""

    def refused(*_parts: object) -> None:
        raise _Declared

    check = expat.ParserCreate()
    check.StartDoctypeDeclHandler = refused
    try:
        check.Parse(document, True)
        return ElementTree.fromstring(document)
    except _Declared:
        raise InputError(Message("{file} declares a document type, which is not read", file=file)) from None
    except (expat.ExpatError, ElementTree.ParseError, ValueError) as error:
        raise InputError(Message("{file} is not well-formed XML: {why}", file=file, why=str(error))) from error


def text_at(element: Element, path: str) -> str:
    """The text of the first element on a path; nothing where there is none."""
    return (element.findtext(path) or "").strip()
