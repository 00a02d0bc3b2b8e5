"""What people write for a kind: `block` for a particle or a rectangle, `hinge` for a pin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from freebody.model.spec import Spec


def written_kind(word: str, value: Any, kinds: Mapping[str, type[Spec]], *, space: bool) -> str | None:
    """The kind that a file means by a word with these fields: of the kinds for which the word may stand, those that
    take all the fields and need no others; of these the one with the fewest fields of its own (a block without sides
    is a particle). Where none takes them, the only one for which the word may stand: it tells which are wrong. None
    where there is none, or where two are as plain. A kind of that name goes first where it is one of this model (in
    the plane a cylinder is a disk), unless its fields are those of another one: a slider of a point is a slot."""
    own = kinds.get(word)
    is_own = own is not None and (space or not own.space_only)
    if is_own and takes(kinds[word], value):
        return word
    here = [name for name, kind in kinds.items() if not (kind.in_plane if space else kind.space_only)]
    called = [name for name in here if word in kinds[name].also]
    able = sorted((len(kinds[name].model_fields), name) for name in called if takes(kinds[name], value))
    if not able and own is not None:
        return word
    if not able:
        return called[0] if len(called) == 1 else None
    return None if len(able) > 1 and able[0][0] == able[1][0] else able[0][1]


def words_also(kinds: Mapping[str, type[Spec]]) -> dict[str, list[str]]:
    """By each word that may stand for kinds: which."""
    found: dict[str, list[str]] = {}
    for name, kind in kinds.items():
        for word in kind.also:
            found.setdefault(word, []).append(name)
    return found


def takes(kind: type[Spec], value: Any) -> bool:
    """Whether a kind has all fields that are given, and needs no others. A field may be called as people call it."""
    fields = {info.alias or name: info for name, info in kind.model_fields.items()}
    meant = {key: (key,) if key in fields else kind.meant(key) for key in kind.from_plain(value)}
    needed = {name for name, info in fields.items() if info.is_required()}
    return all(meant.values()) and needed <= {field for each in meant.values() for field in each}


def put_inside(kind: type[Spec], own: Any, beside: dict[str, Any]) -> dict[str, Any]:
    """The fields of a kind, some of which somebody wrote beside it. What stands behind the kind, `F` in
    `force: F`, is its first field if that does not stand beside, else the one that is left to give."""
    inside = kind.from_plain(own)
    if own is None or isinstance(own, list | dict) or not inside.keys() & beside.keys():
        return {**inside, **beside}
    left = [f.alias or name for name, f in kind.model_fields.items() if f.is_required() and name not in beside]
    return {**beside, left[0]: own} if len(left) == 1 else beside
