"""Reads a model document into a System, section by section. All problems are gathered and reported in one message."""

from __future__ import annotations

from dataclasses import replace

from freebody.connections.base import Connection
from freebody.errors import ModelError
from freebody.language.document import Document
from freebody.language.expression import ZERO
from freebody.language.natural import natural
from freebody.language.plain_text import plain
from freebody.language.units import ENERGY, Dimension
from freebody.loads.base import Load
from freebody.questions.reading import read_questions
from freebody.system.blows import gathered
from freebody.system.description import KeptParameters, SystemDescription
from freebody.system.reading.as_written import as_read
from freebody.system.reading.bodies import BodySections
from freebody.system.reading.connections import (
    closing_at_start,
    closing_when,
    parted,
    read_attitudes,
    read_bounds,
    read_feet,
    read_rows,
    rows_to_ask_for,
)
from freebody.system.reading.copies import add_copies
from freebody.system.reading.drawing import read_drawing
from freebody.system.reading.ground import (
    joined_where_they_stand,
    place_ground_points,
    place_joined_ground_points,
)
from freebody.system.reading.hanging import hang_what_is_struck
from freebody.system.reading.head import check_sections, read_space, title
from freebody.system.reading.loads import brought_loads, read_impulses, read_loads, striking_when
from freebody.system.reading.lying import tell_what_lies_level
from freebody.system.reading.measures import (
    add_places,
    add_turned_at_start,
    driven_from_zero,
    read_measures,
)
from freebody.system.reading.misspelt import told_by_what_is_meant
from freebody.system.reading.nodes import with_pins_of_nodes
from freebody.system.reading.parameters import read_parameters
from freebody.system.reading.sections import CLOSES
from freebody.system.reading.source import Source
from freebody.system.reading.start import read_mode, read_start
from freebody.system.reading.states import read_states
from freebody.system.reading.style import read_style
from freebody.system.reading.validity import read_validities


def read_system(document: Document, file: str | None) -> SystemDescription:
    """What a document describes. Raises ModelError with all its problems, those that follow from a misspelt word by
    that word alone."""
    try:
        return _read_with_units(document, file)
    except ModelError as error:
        told = told_by_what_is_meant(document, error, lambda meant: _read_with_units(meant, file))
        if told is error:
            raise
    raise told


def _read_with_units(document: Document, file: str | None) -> SystemDescription:
    """A parameter with neither number nor unit has the unit with which it is used: read once more with the units that
    were missed, until none is found."""
    units: dict[str, Dimension] = {}
    document, assumed, refused = as_read(document, file)
    while True:
        source = Source(document, file)
        source.refused = refused
        source.names.units_of_use.update(units)
        source.names.assumptions += assumed
        try:
            return _read(source, document, file)
        except ModelError:
            found = source.names.units_of_use
            if found.keys() == units.keys():
                raise
            units = dict(found)
        except Exception as error:  # a stand-in for what could not be read need not fit: that it could not is told
            failed = error
            break
    source.refuse_problems()
    raise failed


def _read(source: Source, document: Document, file: str | None) -> SystemDescription:
    names = source.names
    names.folders = document.folders
    check_sections(source)
    read_space(source)
    read_parameters(source)
    BodySections(source).read()
    connections = with_pins_of_nodes(source, source.specs("connections", Connection.kinds, beside=(CLOSES,)))
    # by name: which of several leads, guides or carries something hangs on no order of the file
    connections, loads = add_copies(names, connections, source.specs("loads", Load.kinds))
    names.connections = {name: connections[name] for name in sorted(connections, key=natural)}
    connections |= {name: meant for name, each in connections.items() if (meant := each.as_meant(names)) is not each}
    names.connections |= {name: connections[name] for name in names.connections}
    connections |= (joined := joined_where_they_stand(names))
    names.connections |= joined
    place_joined_ground_points(names)
    loads |= brought_loads(names, connections)
    names.called |= {name: spec.words() for name, spec in {**connections, **loads}.items() if name not in names.bodies}
    named = (pair for spec in loads.values() for pair in spec.called_by_fields())
    names.of_fields = [(name, words) for name, words in named if name in names.parameters]
    measures = read_measures(source)
    read_states(source)
    start, rates = read_start(source, measures)
    names.placed_at_start = dict(start)
    names.started_at_zero = {name for name, value in start.items() if value == ZERO}
    names.starts_away = any(value != ZERO for value in (*start.values(), *rates.values()))
    names.start_rates = rates
    applied_loads = names.applied_loads = read_loads(names, loads)
    impulses = read_impulses(names, loads)
    striking, closing = striking_when(names, loads), closing_when(source)
    held, offered = read_rows(names, connections, closing_at_start(source), closing)
    held, later = parted(names, held, closing)
    feet = read_feet(names, connections)
    carried = [*names.states.values(), *feet.values()]
    held = [*held, *(row for it in carried for row in it.rows())]
    names.started_at_zero |= driven_from_zero(measures, held)
    blows = gathered(closing, striking, later, list(impulses))
    contacts, limits, brakes = read_bounds(names, connections, closing)
    validities = read_validities(names, connections, loads)
    mode = read_mode(source)
    names.constraint_rows = [*held, *later, *rows_to_ask_for(contacts, limits, brakes)]
    names.impulses, names.strikes = frozenset(push.load for push in impulses), impulses
    closed = {row.connection for row in held if row.closes}
    names.struck_when = {name: event.text for name, event in (*closing.items(), *striking.items())}
    names.struck_at_start = frozenset(closed | {name for name in names.impulses if name not in striking})
    hang_what_is_struck(names, held, start)
    tell_what_lies_level(names, held)
    names.loads = {p.load: ENERGY / p.measure.dimension for p in applied_loads}
    add_places(names, held, offered)
    add_turned_at_start(names)
    questions = read_questions(names, source.data.get("questions"))
    looks = read_drawing(source, {*measures, *connections, *loads})
    style = read_style(source)
    place_ground_points(names)
    source.refuse_problems()
    return SystemDescription(
        title=title(source),
        about=plain(str(source.data.get("about") or "")).strip(),
        parameters=KeptParameters(
            {
                name: replace(p, is_share=name in names.shares, is_count=name in names.counts)
                for name, p in names.parameters.items()
            }
        ),
        bodies=names.bodies | {it.carrier: it.body() for it in carried},
        constraint_rows=tuple(held),
        applied_loads=tuple(applied_loads),
        measures=measures,
        states=names.states,
        feet=feet,
        offered=tuple(offered),
        start=start,
        start_rates=rates,
        questions=questions,
        connections=connections,
        loads=loads,
        assumptions=tuple(dict.fromkeys(names.assumptions)),
        document=document,
        file=file,
        unspecified=source.open.places,
        mode=mode,
        contacts=contacts,
        limits=limits,
        brakes=brakes,
        space=names.space,
        up=names.up,
        frames=names.frames,
        names=names,
        impulses=tuple(push for push in impulses if push.load not in striking),
        blows=blows,
        validities=validities,
        attitudes=read_attitudes(names, connections),
        looks=looks,
        style=style,
    )
