"""Writes the types of what the studio's page and server say to each other: `studio/src/wire.ts`, from
`freebody.studio.wire`. A test fails while they are not current."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Any

from pydantic import BaseModel

from freebody.studio.wire import around, motions, said, studies, texts
from freebody.studio.work import WORK

ROOMS = (said, texts, motions, studies, around)
TARGET = Path(__file__).parents[1] / "studio" / "src" / "wire.ts"
_PLAIN = {"string": "string", "integer": "number", "number": "number", "boolean": "boolean", "null": "null"}


def written() -> str:
    """The text of the file."""
    parts = ["// Written by tools/write_studio_types.py from freebody/studio/wire: do not edit.\n"]
    found = {name: each for room in ROOMS for name, each in inspect.getmembers(room, inspect.isclass)}
    for name, model in sorted(found.items()):
        if issubclass(model, BaseModel) and model not in (said.Said, BaseModel):
            parts.append(_interface(name, model))
    kinds = "".join(f"  {kind}: {work.request.__name__};\n" for kind, work in WORK.items())
    parts.append(f"export interface Requests {{\n{kinds}}}\n")
    answers = "".join(f"  {kind}: {work.answers};\n" for kind, work in WORK.items())
    parts.append(f"export interface Answers {{\n{answers}}}\n")
    return "\n".join(parts)


def _interface(name: str, model: type[BaseModel]) -> str:
    schema = model.model_json_schema()
    required = set(schema.get("required", ()))
    is_answer = not issubclass(model, texts.Request | around.SaveRequest | around.Call)
    lines = "".join(
        f"  {key}{'' if key in required or is_answer else '?'}: {_type(value)};\n"
        for key, value in schema["properties"].items()
    )
    told = " ".join((model.__doc__ or "").split())
    return f"/** {told} */\nexport interface {name} {{\n{lines}}}\n"


def _type(schema: dict[str, Any]) -> str:
    if "$ref" in schema:
        return str(schema["$ref"]).rpartition("/")[2]
    if "enum" in schema:
        return " | ".join(f'"{value}"' for value in schema["enum"])
    if "const" in schema:
        return f'"{schema["const"]}"'
    if "anyOf" in schema:
        return " | ".join(_type(each) for each in schema["anyOf"])
    match schema.get("type"):
        case "array" if "prefixItems" in schema:
            return f"[{', '.join(_type(each) for each in schema['prefixItems'])}]"
        case "array":
            inner = _type(schema["items"])
            return f"({inner})[]" if "|" in inner else f"{inner}[]"
        case "object":
            values = schema.get("additionalProperties")
            return f"Record<string, {_type(values)}>" if isinstance(values, dict) else "Record<string, unknown>"
        case str() as kind:
            return _PLAIN[kind]
        case _:
            return "unknown"


if __name__ == "__main__":
    TARGET.parent.mkdir(parents=True, exist_ok=True)
    TARGET.write_text(written(), encoding="utf-8")
    print(f"wrote {TARGET}")
