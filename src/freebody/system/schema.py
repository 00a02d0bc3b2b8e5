"""The JSON Schema of model files, put together from the descriptions' own fields."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from freebody.connections.base import Connection
from freebody.loads.base import Load
from freebody.model.shapes.base import Shape
from freebody.model.spec import ENDS, Spec
from freebody.model.written_kinds import words_also

_FORMULA = {"type": ["string", "number"], "description": "an expression, or a quantity such as 3 kg"}
# components: two in the plane, three in space
_PAIR = {"type": "array", "items": _FORMULA, "minItems": 2, "maxItems": 3}
_OPEN_PAIR = {"type": ["array", "null"], "items": {"type": ["string", "number", "null"]}, "minItems": 2, "maxItems": 3}
_HEADING = {"anyOf": [_FORMULA, _PAIR]}
# a place of the reference point, or of one or two points by their names; a point of the ground is a place by its name
_PLACE = {"anyOf": [_PAIR, {"type": "string"}]}
_AT = {"anyOf": [_PLACE, {"type": "object", "additionalProperties": _PLACE, "minProperties": 1, "maxProperties": 2}]}
_CHAIN = {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}


def _fields(kind: type[Spec]) -> dict[str, Any]:
    """Schema of the value under a kind: a mapping, a list by position, or its first field alone."""
    schema = kind.model_json_schema(by_alias=True)
    schema.pop("title", None)
    for key in {info.alias or name for name, info in kind.model_fields.items() if name in ENDS}:
        own = schema["properties"][key]
        own = own.get("items", own)
        kept = dict(own)
        own.clear()
        own["anyOf"] = [_PAIR, kept]
    _with_second_words(kind, schema)
    described = {"description": (kind.__doc__ or "").strip()}
    return {**described, "anyOf": [schema, {"type": "array"}, {"type": ["string", "number", "null"]}]}


def _with_second_words(kind: type[Spec], schema: dict[str, Any]) -> None:
    """Also takes the fields under further words; a list under one word gives several of them."""
    own, more = schema["properties"], kind.second_words()
    for word in kind.more_words:
        own[word] = {"type": "string"}
    for word, fields in more.items():
        lists = {"type": "array", "minItems": len(fields), "maxItems": len(fields)}
        own[word] = own[fields[0]] if len(fields) == 1 else lists
    needed = schema.pop("required", [])
    words = {**kind.more_words, **more}
    ways = {field: [field, *(word for word, fields in words.items() if field in fields)] for field in needed}
    if any(len(words) > 1 for words in ways.values()):
        schema["allOf"] = [{"anyOf": [{"required": [word]} for word in words]} for words in ways.values()]
    elif needed:
        schema["required"] = needed


def _by_word(kinds: Mapping[str, type[Spec]]) -> dict[str, Any]:
    """Schema of the value under each kind, and under each word that may stand for kinds."""
    own = {name: _fields(kind) for name, kind in sorted(kinds.items())}
    also = {word: names for word, names in sorted(words_also(kinds).items()) if word not in kinds}
    return own | {word: {"anyOf": [_fields(kinds[name]) for name in names]} for word, names in also.items()}


def _one_of(kinds: Mapping[str, type[Spec]], beside: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """One of some kinds; beside: what may stand beside it."""
    more = dict(beside or {})
    return {
        "type": "object",
        "minProperties": 1,
        "maxProperties": 1 + len(more),
        "additionalProperties": False,
        "properties": _by_word(kinds) | more,
    }


def _named(value: Mapping[str, Any]) -> dict[str, Any]:
    return {"type": "object", "additionalProperties": value}


def json_schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of a model file."""
    line = {
        "type": "object",
        "additionalProperties": False,
        "properties": {
            "through": {"anyOf": [_PAIR, {"type": "string"}]},
            "along": _HEADING,
            "angle": _FORMULA,
            "solid": _HEADING,
        },
    }
    lines = _named({"anyOf": [line, _HEADING]})
    plane = {
        "type": "object",
        "additionalProperties": False,
        "properties": {"through": {"anyOf": [_PAIR, {"type": "string"}]}, "normal": _HEADING},
    }
    planes = _named({"anyOf": [plane, _HEADING]})
    frame = {
        "type": "object",
        "additionalProperties": False,
        "properties": {"on": {"type": "string"}, "turned": _CHAIN},
    }
    space = {
        "anyOf": [
            {"type": "boolean"},
            {"type": "object", "additionalProperties": False, "properties": {"up": {"enum": ["x", "y", "z"]}}},
        ]
    }
    # positions may be left open: all of them by a list of names, a component by null
    points = {"anyOf": [_named(_OPEN_PAIR), {"type": "array", "items": {"type": "string"}}]}
    body = {
        "type": "object",
        "additionalProperties": False,
        "properties": _by_word(Shape.kinds)
        | {
            "at": _AT,
            "angle": _FORMULA,
            "near": {
                "type": "object",
                "additionalProperties": False,
                "properties": {"at": _AT, "angle": _FORMULA, "turned": _CHAIN},
            },
            "velocity": _PAIR,
            "angular_velocity": {"anyOf": [_FORMULA, _PAIR, _named(_PAIR)]},
            "turned": _CHAIN,
            "frame": {"type": "string"},
            "points": points,
            "lines": lines,
            "planes": planes,
            "fixed": {"type": "boolean"},
            "outline": {"type": "array", "items": {"type": "string"}, "minItems": 2},
            "copies": {"type": "integer", "minimum": 2},
        },
    }
    parameter = {
        "anyOf": [
            _FORMULA,
            {
                "type": "object",
                "additionalProperties": False,
                "properties": {
                    "value": _FORMULA,
                    "function": _FORMULA,
                    "unit": {"type": "string"},
                    "sign": {"enum": ["positive", "nonnegative", "any"]},
                    "about": {"type": "string"},
                },
            },
        ]
    }
    phrase = {"anyOf": [{"type": "string"}, {"type": "object", "maxProperties": 1}]}
    options = {"anyOf": [_named({"type": ["string", "number", "array"]}), {"type": "array"}]}
    question = {
        "anyOf": [
            {"type": "string"},
            {
                "type": "object",
                "required": ["find"],
                "additionalProperties": False,
                "properties": {
                    "find": {"type": "string"},
                    "id": {"type": "string"},
                    "when": {"type": "string"},
                    "options": options,
                    "key": {"type": ["string", "number"]},
                    "text": {"type": "string"},
                    "points": {"type": "number", "minimum": 0},
                },
            },
        ]
    }
    texts = {"type": "array", "items": {"type": "string"}}
    drawing = {
        "type": "object",
        "additionalProperties": False,
        "properties": {
            "paths": _named(texts),
            "labels": _named({"type": "string"}),
            "scale": _named({"type": "number", "exclusiveMinimum": 0}),
            "wheels": _named(_FORMULA),
            "hide": texts,
        },
    }
    style = {
        "type": "object",
        "additionalProperties": False,
        "properties": {
            "names": _named({"type": "string"}),
            "axes": texts,
            "order": texts,
            "decimal": {"enum": ["point", "comma"]},
        },
    }
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "freebody model",
        "type": "object",
        "required": ["bodies"],
        "additionalProperties": False,
        "properties": {
            "freebody": {"const": 1},
            "title": {"type": "string"},
            "about": {"type": "string"},
            "source": {"type": "string"},
            "space": space,
            "parameters": _named(parameter),
            "ground": {
                "type": "object",
                "additionalProperties": False,
                "properties": {"points": points, "lines": lines, "planes": planes},
            },
            "frames": _named({"anyOf": [frame, _CHAIN]}),
            "bodies": _named({"anyOf": [body, {"type": "string"}]}),
            "connections": _named(
                _one_of(Connection.kinds, {"closes": {"type": "string", "pattern": "^(at start|when .+)$"}})
            ),
            "loads": _named(_one_of(Load.kinds)),
            "measures": _named(phrase),
            "states": _named(_FORMULA),
            "start": _named(_FORMULA),
            "questions": {"anyOf": [{"type": "array", "items": question}, _named(question)]},
            "drawing": drawing,
            "style": style,
        },
    }
