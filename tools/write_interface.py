"""Writes `src/freebody/__init__.pyi`, by which editors and type checkers know what the package has: they run no
program, and kinds are found when it runs.

python tools/write_interface.py     after a new kind, or another field of one; a test holds the file to the kinds
"""

from __future__ import annotations

from inspect import cleandoc, isclass
from pathlib import Path
from typing import Any

import freebody as fb
from freebody.model.spec import Formula, Heading, Spec

TARGET = Path(__file__).resolve().parents[1] / "src" / "freebody" / "__init__.pyi"
_HEAD = '''"""What the package has, for editors and type checkers. Written by tools/write_interface.py."""

from collections.abc import Mapping, Sequence
from typing import Any

from freebody.language.expression import Expr
from freebody.language.written import Written
from freebody.model.spec import Formula, Heading
'''
_TYPES = """
_Text = str | Written
_Formula = Formula | Expr
_Along = Heading | Expr | Written | Sequence[_Formula]
_List = Sequence[Any]
_Mapping = Mapping[str, Any]
"""
_NAMED = {str: "_Text", bool: "bool", Formula: "_Formula", Heading: "_Along"}


def interface() -> str:
    """The text of the file."""
    imports: list[str] = []
    described: list[str] = []
    for name in sorted(set(dir(fb)) - {"__doc__", "__version__"}):
        one = getattr(fb, name)
        if isclass(one) and issubclass(one, Spec):
            imports.append(f"from {one.__module__} import {one.__name__} as _{name}")
            described.append(_described(name, one))
        else:
            imports.append(f"from {one.__module__} import {name} as {name}")
    return f"{_HEAD}{chr(10).join(sorted(imports))}\n{_TYPES}\n__version__: str\n\n" + "\n".join(described)


def _described(name: str, spec: type[Spec]) -> str:
    """A description, with its fields in the order in which they may be given by position. A field that is needed behind
    one that is not counts as one that is not: Python knows no such order."""
    fields, has_default = "", False
    for field, info in spec.model_fields.items():
        has_default = has_default or not info.is_required()
        fields += f"        {field}: {_type(info)}{' = ...' if has_default else ''},\n"
    doc = cleandoc(spec.__doc__ or "").replace("\n", "\n    ").replace("\n    \n", "\n\n")
    return f'class {name}(_{name}):\n    """{doc}"""\n\n    def __init__(\n        self,\n{fields}    ) -> None: ...\n'


def _type(info: Any) -> str:
    """The type of a field."""
    annotation, is_optional = info.annotation, False
    for known in (str, bool, Formula, Heading):
        if annotation == known | None:
            annotation, is_optional = known, True
    text = _NAMED.get(annotation)
    if text is None:
        written = str(annotation)
        parts = ["_Formula"] if "int" in written and "[" not in written.split("|", maxsplit=1)[0] else []
        parts += ["_Text"] if not parts and ("<class 'str'>" in written or "| str" in written) else []
        parts += ["_List"] if "list[" in written else []
        parts += ["_Mapping"] if "dict[" in written else []
        text, is_optional = " | ".join(parts) or "Any", "None" in written
    return f"{text}{' | None' if is_optional else ''}"


if __name__ == "__main__":
    TARGET.write_text(interface(), encoding="utf-8")
    print(f"wrote {TARGET}")
