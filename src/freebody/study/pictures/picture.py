"""Pictures of a system: as it stands at an instant, and bodies cut free with everything that acts on them."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from freebody.errors import CannotAnswer, InputError
from freebody.language.notation.parts import in_decimals_of, sign_of_decimals, with_sign
from freebody.language.sentences import Message
from freebody.model.glyphs import Coil, ForceArrow, MomentArrow
from freebody.model.noting import did_you_mean
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.picture import Picture, checked_path
from freebody.present.picture.whole import Whole, WholeInPlane, described
from freebody.present.places import Places
from freebody.study.pictures.diagrams import diagrams_along
from freebody.study.pictures.free_body import FreeBody, checked_bodies
from freebody.study.pictures.general_position import general_position
from freebody.study.pictures.instant import Instant, instant_of
from freebody.study.pictures.touching import closed_bounds
from freebody.study.worded import in_words
from freebody.system.system import System

SHOWN = ("velocity", "acceleration", "force", "instant-centres")
View = tuple[float, float] | None  # azimuth and elevation; nothing: from where most is seen


def _decimal_of(system: System) -> str:
    return system.style.decimal or sign_of_decimals()


@in_words
@in_decimals_of(_decimal_of)
def picture(
    system: System,
    *,
    at: float | None = None,
    show: Sequence[str] = (),
    view: View = None,
    perspective: bool = False,
    turning: Collection[str] = (),
) -> Picture:
    """The system with what joins and pushes it, coordinates, dimensions and axes.

    at: [s] in its motion, else at the start; show: of `SHOWN`, what to draw over it; view: in space, azimuth and
    elevation from which one looks [deg]; turning: in space, angles whose rates are drawn along their axes, instead of
    dimensions. Raises InputError for other words, CannotAnswer for what there is not."""
    show = _checked(system, show)
    _check_view(system, view, perspective=perspective)
    found = instant_of(system, at, in_motion=bool(set(show) & {"acceleration", "force"}), at_rest=not show)
    if at is None and not show:
        found = general_position(system) or found
    title = system.title if not at else f"{system.title}, t = {with_sign(f'{at:g}')} s"
    moving = [body.name for body in system.moving]
    acting: Sequence[ShownForce] = ()
    if moving:
        free = FreeBody(found.snapshot, moving, other_sides=found.other_sides)
        acting = free.loads() if at else (*free.loads(), *free.impulses())
    whole: Whole
    if system.space:
        from freebody.study.pictures.picture_in_space import whole_in_space

        whole = whole_in_space(found, acting, view, perspective=perspective, turning=turning)
    else:
        whole = _in_the_plane(found, acting)
    whole.is_start = not at
    if show:
        from freebody.study.pictures.shown import add_shown

        add_shown(whole, found, show)
    return whole.drawn(with_signs=not show).finished(title, described(system, whole.moved))


@in_words
@in_decimals_of(_decimal_of)
def free_body(
    system: System,
    *bodies: str,
    at: float | None = None,
    labels: Mapping[str, str] | None = None,
    show: Sequence[str] = (),
    told: Collection[str] = (),
    view: View = None,
    perspective: bool = False,
) -> Picture:
    """Bodies cut free together, with every load and reaction from outside as an arrow in the direction in which it is
    counted positive, labelled as by `reaction_symbols`.

    at: [s] the pose at that time, else at the start; labels: other symbols, by the name of a row, of its symbol or of a
    load; show: "force" for values in that instant; told: names of rows that are drawn even if they never act; view: in
    space, azimuth and elevation [deg]. Raises InputError for bodies that there are not."""
    bodies = checked_bodies(system, bodies)
    show = _checked(system, show)
    _check_view(system, view, perspective=perspective)
    if set(show) - {"force"}:
        raise InputError(
            Message("{show} is drawn of the whole system; of bodies cut free there is force", show=show[0])
        )
    found = instant_of(system, at, in_motion="force" in show, at_rest=True)
    if at is None and not show:
        found = general_position(system) or found
    closed, sides = closed_bounds(found.snapshot), found.other_sides
    forces = FreeBody(found.snapshot, bodies, closed=closed, labels=labels, told=told, other_sides=sides).forces()
    if "force" in show:
        forces = tuple(_valued(force, found) for force in forces)
    title = Message("{title}: {bodies} cut free", title=system.title, bodies=", ".join(bodies))
    if system.space:
        from freebody.study.pictures.picture_in_space import free_body as cut_free

        return cut_free(found, bodies, forces, title, view=view, perspective=perspective)
    from freebody.present.drawing import Drawing
    from freebody.present.picture.bodies_free import body_label, free_body_picture
    from freebody.present.picture.dimensions import Dimensions
    from freebody.present.picture.sketch import Sketch
    from freebody.present.scene import Scene

    number = found.snapshot.reference.number

    def dimensions(sketch: Sketch, drawing: Drawing) -> None:
        Dimensions(system, sketch, drawing, Places(system, number)).draw()

    scene = Scene.of(system, number)
    called = {body: body_label(system, body) for body in bodies}
    return free_body_picture(scene, poses_of(found.snapshot), bodies, forces, title, dimensions, called)


@in_words
def draw(
    system: System,
    path: str | Path | None = None,
    *,
    at: float | None = None,
    show: Sequence[str] = (),
    free: Sequence[str] = (),
    diagram: str = "",
    view: View = None,
    perspective: bool = False,
    dark: bool = False,
) -> Picture | Path:
    """Draws a system at its start, or at a time; with `free` these bodies alone, cut free; with `diagram` what is
    transmitted through the sections of this rod: axial force, shear force, bending moment. Without a path the picture
    is returned, which shows itself in a notebook; with one it is written there, as .svg, .png, .pdf, or .tex with a
    tikzpicture, and the path returned. For the others see `picture`. Raises InputError for another format, ModelError
    where the start cannot be assembled."""
    if path is not None:
        path = checked_path(path)
    if diagram:
        _check_alone(at=at, show=show, free=free, view=view, perspective=perspective)
        made = diagrams_along(system, diagram)
    elif free:
        made = free_body(system, *free, at=at, show=show, view=view, perspective=perspective)
    else:
        made = picture(system, at=at, show=show, view=view, perspective=perspective)
    return made if path is None else made.write(path, dark=dark)


def _check_alone(**others: object) -> None:
    """Raises InputError where something else is asked of a picture of diagrams, which show no bodies."""
    asked = [name for name, value in others.items() if value not in (None, False, (), [])]
    if asked:
        raise InputError(Message("a diagram shows no bodies: ask for it without {others}", others=", ".join(asked)))


def poses_of(snapshot: Snapshot) -> Array:
    """(n_moving, 3)"""
    reference = snapshot.reference
    return np.array([reference.pose(snapshot.q, body.name) for body in reference.system.moving]).reshape(-1, 3)


def _checked(system: System, show: Sequence[str]) -> tuple[str, ...]:
    for word in show:
        if word not in SHOWN:
            raise InputError(Message("there is no {word} to show.{hint}", word=word, hint=did_you_mean(word, SHOWN)))
    if system.space and "instant-centres" in show:
        raise CannotAnswer(
            Message("bodies have instant centres in the plane; in space they move about screws, see mobility")
        )
    return tuple(dict.fromkeys(show))


def _check_view(system: System, view: View, *, perspective: bool) -> None:
    if not system.space and (perspective or view is not None):
        raise InputError(Message("a view from the side is for models in space; this one is in the plane"))


def _valued(force: ShownForce, found: Instant) -> ShownForce:
    """A force with its value in an instant, where it is unique."""
    free = FreeBody(found.snapshot, [force.body], other_sides=found.other_sides)
    is_reaction = force.kind == "reaction"
    value = free.reaction_values(found.reactions).get(force.name) if is_reaction else free.load_value(force.name)
    return replace(force, value=value)


def _in_the_plane(found: Instant, acting: Sequence[ShownForce]) -> WholeInPlane:
    system, reference = found.snapshot.reference.system, found.snapshot.reference
    # dry friction that slides is a load of its own
    arrow = (ForceArrow, MomentArrow, Coil)
    shown = {s.owner for s in system.glyphs if s.is_load and isinstance(s.sign, arrow)}
    pushes = (*system.applied_loads, *system.impulses)
    arrows = {push.name for push in pushes if push.load in shown or push.load not in system.loads}
    loads = [force for force in acting if force.kind == "load" and force.name in arrows]
    return WholeInPlane(system, Places(system, reference.number), poses_of(found.snapshot), loads)
