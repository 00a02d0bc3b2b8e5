"""A file as people write it first, put into the form in which it is read.

    as it comes                                as it is read
    loads: {gravity: g}                        loads: {gravity: {gravity: g}}
    F: {force: 5 N, at: P, along: down}        F: {force: {magnitude: 5 N, at: P, along: down}}
    {disk: {radius: R, at: [0, 0]}}            {disk: {radius: R}, at: [0, 0]}
    crank: {type: rod, length: L}              crank: {rod: {length: L}}
    connections: [{pin: [A, B]}]               connections: {pin: {pin: [A, B]}}
    connections: {s: {spring: ...}}            loads: {s: {spring: ...}}
    joints: ..., points: ..., gravity: g       connections: ..., ground: {points: ...}, loads: {gravity: ...}
    F: 5 N down at P                           F: {force: {magnitude: 5 N, along: down, at: P}}

Only what can mean one thing is put elsewhere; anything else stays as it is, and is told where it is read. Which words
stand for a kind, which fields it has and what it reads in words, the kinds say themselves.
"""

from __future__ import annotations

from typing import cast

from freebody.errors import ModelError
from freebody.language.document import Document
from freebody.language.sentences import Message
from freebody.system.reading.written.beams import with_beam
from freebody.system.reading.written.bevels import complete_bevels, with_bevels
from freebody.system.reading.written.cams import with_cam
from freebody.system.reading.written.carriers import lengthen_carriers
from freebody.system.reading.written.collisions import guide_what_collides
from freebody.system.reading.written.dimensions import with_units_of_words
from freebody.system.reading.written.distances import points_along_rods, with_distances
from freebody.system.reading.written.entries import put_entry_in_order
from freebody.system.reading.written.form import JOINED, Entry, Written
from freebody.system.reading.written.gears import bear_gears, place_axles, with_modules
from freebody.system.reading.written.held import (
    ground_as_line,
    hold_bodies,
    lead_what_is_on,
    raise_walls,
    roughen_lines,
)
from freebody.system.reading.written.hoists import with_hoist
from freebody.system.reading.written.hoops import with_hoop
from freebody.system.reading.written.joined_places import leave_to_joints
from freebody.system.reading.written.joints import join_rods, tell_middles
from freebody.system.reading.written.linkages import with_linkage
from freebody.system.reading.written.lists import name_items
from freebody.system.reading.written.oscillators import stretch_springs
from freebody.system.reading.written.planetary import with_planetary
from freebody.system.reading.written.pulleys import hold_pulleys
from freebody.system.reading.written.scalars import spread_scalars
from freebody.system.reading.written.sections import lines_of_ground, rename_sections, take_in_sections
from freebody.system.reading.written.single import with_single
from freebody.system.reading.written.slider_cranks import with_slider_crank
from freebody.system.reading.written.spelling import ground_for_world, sides_as_called, spell_entry, spell_sections
from freebody.system.reading.written.stacks import lay_in_stacks
from freebody.system.reading.written.starts import start_of_bodies
from freebody.system.reading.written.trusses import with_truss
from freebody.system.reading.written.vectors import without_brackets

_NAMED = (*JOINED, "bodies", "parameters", "measures", "start")
# sections of what is no formula
_IN_WORDS = (
    "title",
    "name",
    "about",
    "description",
    "source",
    "questions",
    "find",
    "ask",
    "wanted",
    "drawing",
    "style",
)
_AT_REST = ("rest", "at rest", "from rest", "in ruhe", "ruhe")
_IN_SPACE = ("3d", "3", "yes", "spatial")


def as_read(document: Document, file: str | None) -> tuple[Document, list[Message], dict[str, Message]]:
    """The document in the form in which it is read, itself where it is written so, what that takes for granted,
    and why sections are left as they are. Raises ModelError of a figure in a few lines that cannot be read."""
    written = Written(document.data)
    try:
        _put_in_order(written)
    except ModelError as error:
        raise ModelError([document.locate(problem) for problem in error.problems], file) from None
    is_other = written.data != document.data
    read = document.rewritten(written.data, written.moved) if is_other else document
    return read, written.assumed, written.refused


def _put_in_order(w: Written) -> None:
    spell_sections(w)
    w.data = {key: without_brackets(value) if key not in _IN_WORDS else value for key, value in w.data.items()}
    w.data = cast("Entry", with_units_of_words(w.data))
    if str(w.data.get("space")).lower() in _IN_SPACE:
        w.data["space"], w.space = True, True
        w.moved[("space",)] = ("space",)
    if (truss := with_truss(w)) is not None:
        w.data, w.moved, told = truss[0], w.moved | truss[1], truss[2]
        w.assumed.append(told)
    with_beam(w)
    with_linkage(w)
    with_planetary(w)
    with_single(w)
    with_cam(w)
    with_hoop(w)
    with_slider_crank(w)
    with_hoist(w)
    with_bevels(w)
    if str(w.data.get("start")).lower() in _AT_REST:
        del w.data["start"]
    rename_sections(w)
    for section in _NAMED:
        if isinstance(w.data.get(section), list):
            name_items(w, section)
    start_of_bodies(w)
    take_in_sections(w)
    lines_of_ground(w)
    ground_for_world(w)
    sides_as_called(w)
    for section in ("bodies", *JOINED):
        entries = w.data.get(section)
        for name, entry in list(cast("Entry", entries).items()) if isinstance(entries, dict) else ():
            w.data[section][name] = spelt = spell_entry(w, section, (section, name), entry)
            put_entry_in_order(w, section, name, spelt)
        if section == "bodies":
            hold_bodies(w)
            join_rods(w)
    lead_what_is_on(w)
    leave_to_joints(w)
    tell_middles(w)
    points_along_rods(w)
    with_distances(w)
    roughen_lines(w)
    ground_as_line(w)
    raise_walls(w)
    guide_what_collides(w)
    spread_scalars(w)
    hold_pulleys(w)
    stretch_springs(w)
    lay_in_stacks(w)
    complete_bevels(w)
    with_modules(w)
    bear_gears(w)
    lengthen_carriers(w)
    place_axles(w)
