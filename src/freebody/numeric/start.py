"""The start of a motion: a pose and velocities as the model describes them, and otherwise as small as possible.

A pose that is given outright is taken (`outright`); else it is searched from the description of each body, then from
disturbed ones. Velocities v solve one linear system, J v = wanted rates, by the least kinetic energy. In a large system
bodies are placed outward from the ground first, unless the description fits, and J is sparse (`sparse`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from freebody.budgets import allowed
from freebody.errors import BudgetExhausted, CannotAnswer
from freebody.language.expression import ZERO, negate, substitute
from freebody.language.sentences import Message, listed
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Point, SpatialPose
from freebody.model.elements import Attitude, NonholonomicForm, RigidBody, Start
from freebody.numeric import spatial
from freebody.numeric.closing import cannot_close
from freebody.numeric.described import axes_of, start_pose
from freebody.numeric.jet_geometry import Branch, JetGeometry
from freebody.numeric.jets import LARGE, Array, Jet
from freebody.numeric.outright import given_outright
from freebody.numeric.outward import placed_outward
from freebody.numeric.placing import ACCEPTED, N_STEPS, TOLERANCE, Fit, PoseEquation
from freebody.numeric.rotation import matrix, rotation_vector
from freebody.numeric.senses import turned_over, turned_to_face
from freebody.numeric.system import NumericSystem
from freebody.numeric.unfolding import unfolded
from freebody.tolerances import ROUND_OFF

N_STARTS = 16
N_QUICK = 5  # of a trial with other values
MOST_STEPS = 3200  # of all starts together
SINGULAR = 1e-6  # the volume that three unit axes span
Wanted = Sequence[tuple[Measure | NonholonomicForm, float]]  # values that measures, or their rates, must have


# -- the pose ---------------------------------------------------------------------------------


def assembled(reference: NumericSystem, extra: Wanted, guess: Array | None, n_starts: int = N_STARTS) -> Fit:
    """The pose at t = 0 nearest to the guess; see `Reference.assemble`. Parts that nothing joins are assembled each for
    itself, so that what else stands in a model moves nothing in them."""
    fit = _assembled(reference, extra, guess, n_starts)
    if guess is not None:
        return fit
    return unfolded(reference, fit, _equations(reference, extra), partial(_stands, reference))


def _assembled(reference: NumericSystem, extra: Wanted, guess: Array | None, n_starts: int) -> Fit:
    groups = reference.groups_joined_by(measure for measure, _value in extra)
    if len(groups) < 2:
        return _assembled_part(reference, extra, guess, n_starts)
    q = guessed(reference) if guess is None else guess.copy()
    near: dict[Branch, float] = {}
    for group in groups:
        part = reference.part(group)
        own = [k for body in part.system.all_moving for k in reference.columns(body.name)]
        asked = [(measure, x) for measure, x in extra if group.intersection(measure.bodies())]
        fit = _assembled_part(part, asked, None if guess is None else guess[own], n_starts)
        q[own] = fit.q
        near |= fit.branches
    fit = reference.placing.fit(q, _equations(reference, extra), 0.0, near, n_steps=0)
    if fit is None or fit.error > ACCEPTED:
        off = (
            Message("a measure has no value")
            if fit is None
            else Message("at best {worst}", worst=_worst(reference, fit))
        )
        raise CannotAnswer(
            Message("the start cannot be assembled: {why}. Change the start of the model or the lengths", why=off)
        )
    return fit


def _worst(reference: NumericSystem, fit: Fit) -> str:
    """What is off at best, and of a driver the value with which its law begins: the start has to have that."""
    name = fit.equations[fit.worst_one].name
    row = next((row for row in reference.system.constraint_rows if row.name == name), None)
    if row is None or row.component != "drive" or row.target is None:
        return fit.worst
    begin = reference.number(substitute(row.target, {"t": ZERO}))
    return Message(
        "{worst} (the law of {driver} begins at {value}, which the start has to have)",
        worst=fit.worst,
        driver=row.connection,
        value=_shown(begin, row.measure),
    )


def _assembled_part(reference: NumericSystem, extra: Wanted, guess: Array | None, n_starts: int) -> Fit:
    """The pose at t = 0 of one part. What is carried follows where it is carried to: it pulls at nothing."""
    carried = _carried(reference, extra)
    rest = frozenset(body.name for body in reference.system.all_moving) - carried
    if not carried or not rest:
        return _assembled_whole(reference, extra, guess, n_starts)
    own = [k for name, columns in reference.frame.columns.items() if name in rest for k in columns]
    q = turned_to_face(reference, guessed(reference)) if guess is None else guess.copy()
    q[own] = _assembled_whole(reference.part(rest), extra, None if guess is None else guess[own], n_starts).q
    loose = reference.sizes.small_moves.copy()
    loose[own] = 0.0
    placing = replace(reference.placing, sizes=replace(reference.sizes, small_moves=loose))
    equations = _equations(reference, extra)
    for guides in (_guided(reference, q), []):  # what a guide keeps stays as it is guessed, where the rest fits to it
        fit = placing.fit(q, [*equations, *guides], 0.0, {})
        if fit is not None and _stands(reference, fit):
            return fit
    return _assembled_whole(reference, extra, guess, n_starts)


def _carried(reference: NumericSystem, extra: Wanted) -> set[str]:
    """Massless bodies of which nothing is said and which are held to one other body at most, those that they carry
    themselves left out."""
    system = reference.system
    said = {name for measure, _value in extra for name in measure.bodies()}
    said |= {name for key in system.all_start for name in system.all_measures[key].bodies()}
    said |= {name for attitude in system.attitudes for name in (attitude.first, attitude.second)}
    light = {
        body.name
        for body in system.all_moving
        if body.start == Start() and not body.chain and reference.masses[reference.columns(body.name)[0]] == 0.0
    } - said
    if not light:
        return light
    rows = [reference.frame.columns.keys() & set(row.measure.bodies()) for row in system.constraint_rows]
    found: set[str] = set()
    while True:
        ends = {name: set[str]().union(*(row for row in rows if name in row)) - found for name in light - found}
        more = {name for name, bodies in ends.items() if len(bodies - {name}) <= 1}
        if not more:
            return found
        found |= more


def _equations(reference: NumericSystem, extra: Wanted) -> list[PoseEquation]:
    """What holds in the start pose."""
    equations = reference.held_by_targets()
    return [*equations, *_start_equations(reference, extra), *_body_equations(reference, lambda body: body.start)]


def _assembled_whole(reference: NumericSystem, extra: Wanted, guess: Array | None, n_starts: int) -> Fit:
    """The pose at t = 0 of one part nearest to the guess."""
    for body in reference.system.all_moving:
        _refuse_singular(reference, body)
    is_trial = n_starts < N_STARTS  # with other values, of which nobody is told why they do not fit
    if is_trial and (why := cannot_close(reference, start_values(reference, extra))) is not None:
        raise _does_not_close(why)
    equations = _equations(reference, extra)
    described = turned_to_face(reference, guessed(reference))
    if guess is None and len(described) <= LARGE:
        outright = given_outright(reference.placing, described, equations)
        fit = None if outright is None else reference.placing.fit(outright, equations, 0.0, {})
        if fit is not None and _stands(reference, fit):
            return fit
    if guess is not None:  # a pose that fits as it stands, another assembly mode, is not pulled to what the file wishes
        as_given = reference.placing.fit(guess, equations, 0.0, {}, n_steps=0)
        if as_given is not None and as_given.error <= TOLERANCE and _stands(reference, as_given):
            return as_given
    guess = described if guess is None else guess

    # a guess is kept where the rest fits to it, so that bodies of which nothing is said do not pull at it; what a guide
    # keeps also without that
    guides, near = _guided(reference, described), _body_equations(reference, _guessed)
    wishes = [wish for wish in ([*guides, *near] if near else [], guides) if wish]
    if len(guess) > LARGE:  # a body far away is not reached by small steps of all
        as_given = reference.placing.fit(guess, equations, 0.0, {}, n_steps=0)
        if as_given is not None and as_given.error <= TOLERANCE and not wishes and _stands(reference, as_given):
            return as_given
        if as_given is None or as_given.error > ACCEPTED:
            guess = placed_outward(reference, guess, equations)
    compromise: Fit | None = None
    for wish in wishes:
        fit = reference.placing.fit(guess, [*equations, *wish], 0.0, {})
        if fit is not None and _stands(reference, fit):
            return _nearest(reference, fit, guess)
        compromise = compromise or fit

    # else from the best compromise with what is guessed: bodies of which nothing is said do not pull to the other side
    if near and compromise is not None:
        fit = reference.placing.fit(compromise.q, equations, 0.0, compromise.branches)
        if fit is not None and _stands(reference, fit):
            return _nearest(reference, fit, guess)

    # else from the guess alone, and from disturbed ones
    try:
        best, q = _searched(reference, guess, equations, n_starts)
    except CannotAnswer as error:
        if not is_trial and (why := cannot_close(reference, start_values(reference, extra))) is not None:
            raise _does_not_close(why) from error
        if isinstance(error, BudgetExhausted) or is_trial or extra:
            raise
        told = _on_the_side_that_fits(reference, error.args[0])
        told = _with_places_that_fit(reference, told) if told is error.args[0] else told
        told = _with_values_that_fit(reference, told) if told is error.args[0] else told
        raise CannotAnswer(told) from error
    if q is not guess:
        best = _settled(reference, best, guess, wishes)
    return _nearest(reference, best, guess)


def _does_not_close(why: str) -> CannotAnswer:
    return CannotAnswer(Message("the start cannot be assembled: {why}", why=why))


def _searched(
    reference: NumericSystem, guess: Array, equations: Sequence[PoseEquation], n_starts: int
) -> tuple[Fit, Array]:
    """The first pose that fulfils the equations to round-off, else the best one that is good enough; and the guess that
    was looked at last. Raises CannotAnswer where there is none, BudgetExhausted where the search ended before."""
    best: Fit | None = None
    facing: Attitude | None = None  # a joint that was found turned over
    left, q = allowed(MOST_STEPS), guess
    for q in _starts(reference, guess, equations, n_starts):
        fit = reference.placing.fit(q, equations, 0.0, {}, min(N_STEPS, left))
        left -= 1 if fit is None else fit.n_steps
        if fit is not None and fit.error <= ACCEPTED and (over := next(turned_over(reference, fit.q), None)):
            facing, fit = over, None
        if fit is not None and (best is None or fit.error < best.error):
            best = fit
        if left <= 0 or (best is not None and best.error <= TOLERANCE):
            break
    if best is None or best.error > ACCEPTED:
        raise _not_found(reference, best, facing, is_exhausted=left <= 0)
    return best, q


def _not_found(
    reference: NumericSystem, best: Fit | None, facing: Attitude | None, *, is_exhausted: bool
) -> CannotAnswer:
    """Why no start pose was found: a joint was turned over in all of them, or a gap stays open."""
    if best is None and facing is not None:
        return CannotAnswer(
            Message(
                "the start cannot be assembled: in the poses that were found an axis of {a} points against "
                "that of {b} with which a joint makes it parallel. Say with turned how one is turned",
                a=facing.first,
                b=facing.second,
            )
        )
    if best is None:
        return CannotAnswer(
            Message("no start pose was found in which all measures have a value; give positions with at")
        )
    at_best = Message(
        "at best {worst}. Change the start of the model (at, {turned}, start) or the lengths; freebody mobility "
        "says which parts contradict each other",
        worst=_worst(reference, reference.placing.with_one_gap(best)),
        turned="turned" if reference.system.space else "angle",
    )
    if is_exhausted:
        return BudgetExhausted(
            Message(
                "a start that can be assembled was not found within {n} steps; raise the effort (--effort) to look "
                "further: {at_best}",
                n=allowed(MOST_STEPS),
                at_best=at_best,
            )
        )
    return CannotAnswer(Message("the start cannot be assembled: {why}", why=at_best))


def _on_the_side_that_fits(reference: NumericSystem, told: str) -> str:
    """The same, and which round body is put on the other side of its line than the one on which it is said to be."""
    rows = reference.system.constraint_rows
    for k, row in enumerate(rows):
        if row.reaction != "normal force" or row.target is None or not isinstance(row.measure, Displacement):
            continue
        other = replace(row, target=negate(row.target), sign=-row.sign)
        turned = replace(reference.system, constraint_rows=(*rows[:k], other, *rows[k + 1 :]))
        try:
            assembled(type(reference)(turned, reference.frame.values), (), None, N_QUICK)
        except CannotAnswer:
            continue
        return Message(
            "{told}. It is put on the other side of its line than {connection} has it: {connection} takes below: "
            "{below}, or the line the other direction",
            told=told,
            connection=row.connection,
            below="true" if row.sign > 0 else "false",
        )
    return told


def _with_places_that_fit(reference: NumericSystem, told: str) -> str:
    """The same, and where bodies could be that the model puts where they cannot be: by places that are guesses."""
    put = {body.name: body for body in reference.system.moving if body.start.at is not None}
    if not put:
        return told
    loose = {name: replace(b, start=replace(b.start, at=None, near=Start(at=b.start.at))) for name, b in put.items()}
    other = type(reference)(
        replace(reference.system, bodies={**reference.system.bodies, **loose}), reference.frame.values
    )
    try:
        q = assembled(other, (), None).q
    except CannotAnswer:
        return told
    for name, body in put.items():
        assert body.start.at is not None
        point, wanted = body.start.at
        g = other.geometry(q, np.zeros_like(q), 0.0)
        axes = zip(axes_of(other.system), wanted, strict=True)
        pairs = [
            (Displacement(body.point(point), Point(GROUND), axis).value(g).value, other.number(x)) for axis, x in axes
        ]
        if max(abs(a - b) for a, b in pairs) > ACCEPTED:
            place = ", ".join(f"{round(a, 9) + 0.0:.4g} m" for a, _b in pairs)
            return Message("{told}. It could be assembled with {body} at [{place}]", told=told, body=name, place=place)
    return told


def _with_values_that_fit(reference: NumericSystem, told: str) -> str:
    """The same, and which of the given start values may be left out, with the value that it has then."""
    system = reference.system
    fitting: list[str] = []
    best = reference.placing.fit(turned_to_face(reference, guessed(reference)), _equations(reference, ()), 0.0, {})
    for name in system.start:
        others = {other: expr for other, expr in system.start.items() if other != name}
        loose = type(reference)(replace(system, start=others), reference.frame.values)
        try:
            q = assembled(loose, (), None if best is None else best.q, N_QUICK).q
        except CannotAnswer:
            continue
        measure = system.all_measures[name]
        value = measure.value(loose.geometry(q, np.zeros_like(q), 0.0)).value
        fitting.append(Message("{name}, which then is {value}", name=name, value=_shown(float(value), measure)))
    if not fitting:
        return told
    return Message("{told}. Leave out {values}", told=told, values=listed(fitting, "{first}, or {second}"))


def _shown(value: float, measure: Measure | NonholonomicForm) -> str:
    """A value of a measure, of angles in degrees."""
    if measure.dimension == DIMENSIONLESS:
        return f"{round(math.degrees(value), 9) + 0.0:.4g} deg"
    return f"{round(value, 9) + 0.0:.4g} {measure.dimension}"


def _nearest(reference: NumericSystem, found: Fit, guess: Array) -> Fit:
    """The pose to which small moves that break nothing lead from one that was found, towards the guess. The bodies of a
    large system stay where they were put, one after the other from the ground."""
    if len(guess) > LARGE:
        return found
    nearer = reference.placing.nearest(found, guess, 0.0)
    return nearer if _stands(reference, nearer) else found


def _settled(reference: NumericSystem, found: Fit, guess: Array, wishes: Iterable[Sequence[PoseEquation]]) -> Fit:
    """A pose without the disturbance of its guess: what no equation touches is as it was guessed, and the first of some
    wishes that can be fulfilled is."""
    q = np.where(found.rows.any(axis=0), found.q, guess)
    for wish in (*wishes, ()):
        fit = reference.placing.fit(q, [*found.equations, *wish], 0.0, found.branches)
        if fit is not None and _stands(reference, fit):
            return fit
    return found


def _stands(reference: NumericSystem, fit: Fit) -> bool:
    """Whether a pose fulfils everything, and no joint in it is turned over."""
    return fit.error <= ACCEPTED and next(turned_over(reference, fit.q), None) is None


def _guided(reference: NumericSystem, described: Array) -> list[PoseEquation]:
    """What guides keep of an angle or of a place, at its value in a pose."""
    found: list[PoseEquation] = []
    g = reference.geometry(described, np.zeros_like(described), 0.0)
    for row in reference.system.constraint_rows:
        if row.target is not None or not isinstance(row.measure, Combination) or len(row.measure.terms) != 1:
            continue
        if isinstance(row.measure.terms[0][1], (Angle, Displacement)):
            here = reference.jet(g, row.measure, row.name).value
            found.append(PoseEquation.of(row.name, row.measure, Jet(here)))
    return found


def _refuse_singular(reference: NumericSystem, body: RigidBody) -> None:
    """Three named angles are not determined where their axes are in one plane: at a middle angle of 0 if the first and
    the last turn are about the same axis, of 90 deg otherwise. Raises CannotAnswer if the start is such a pose."""
    named = [turn.name for turn in body.chain if turn.name]
    given = {
        name: reference.number(reference.system.all_start[name]) for name in named if name in reference.system.all_start
    }
    if len(named) < 3 or named[1] not in given:
        return
    before, turned = spatial.UNIT, dict.fromkeys(named, 0.0) | given
    axes: list[Array] = []
    for turn in body.chain:
        if turn.name:
            axes.append(before @ np.array([reference.number(c) for c in turn.axis]))
        before = before @ spatial.turned_by((turn,), turned, reference.number)
    if abs(float(np.linalg.det(np.array(axes)))) > SINGULAR:
        return
    last = int(np.abs(axes[2] @ before).argmax())  # of the body's axes
    first = int(np.abs(before[:, last]).argmin())
    middle = next(k for k in range(3) if k not in (first, last))
    order = ", ".join(f"{name} about {'xyz'[k]}" for name, k in zip(named, (first, middle, last), strict=True))
    raise CannotAnswer(
        Message(
            "at the start {middle} = {degrees:.6g} deg, where {first} and {last} turn "
            "{body} about the same axis, so that they are not determined (a singular pose of these angles). Name "
            "angles in another order, e.g. turned: [{order}], or start beside that pose",
            middle=named[1],
            degrees=math.degrees(given[named[1]]),
            first=named[0],
            last=named[2],
            body=body.name,
            order=order,
        )
    )


def guessed(reference: NumericSystem) -> Array:
    """The pose (n,) in which every body is where the model says of it alone, or is said to be near."""
    q = np.zeros(len(reference.masses))
    for body in reference.system.all_moving:
        pose = start_pose(reference.system, body, reference.number)
        if reference.system.space:
            axes = matrix(np.array(pose[3:])) @ reference.frame.principal[body.name]
            pose = (*pose[:3], *map(float, rotation_vector(axes)))
        for k, value in zip(reference.columns(body.name), pose, strict=False):
            q[k] = value
    return q


def _starts(
    reference: NumericSystem, guess: Array, equations: Sequence[PoseEquation], n_starts: int
) -> Iterator[Array]:
    """The guess, then bodies placed outward from the ground, then disturbed guesses: first a little, later by the size
    of the system."""
    yield guess
    yield placed_outward(reference, guess, equations)
    for k in range(n_starts):
        disturbance = reference.noise(np.random.default_rng(k))
        yield reference.frame.moved(guess, min(1.0, 0.02 * 2.0**k) * reference.sizes.unit_moves * disturbance)


def _start_equations(reference: NumericSystem, extra: Wanted) -> list[PoseEquation]:
    system = reference.system
    said: dict[Measure | NonholonomicForm, str] = {system.all_measures[name]: name for name in system.all_start}
    return [PoseEquation.of(said.get(m) or reference.name_of(m), m, Jet(x)) for m, x in start_values(reference, extra)]


def start_values(reference: NumericSystem, extra: Wanted) -> Wanted:
    """The values that named measures have at the start, and what is wanted beside, or in place, of them."""
    begun = ((reference.system.all_measures[name], expr) for name, expr in reference.system.all_start.items())
    own = [(m, reference.number(expr)) for m, expr in begun if all(m != other for other, _x in extra)]
    return [*own, *extra]


def _guessed(body: RigidBody) -> Start:
    """What is guessed of a body at the start beside what is given."""
    return Start() if body.start.near is None else body.start.near


def _body_equations(reference: NumericSystem, start_of: Callable[[RigidBody], Start]) -> list[PoseEquation]:
    """A place or an angle that bodies have at the start."""
    equations: list[PoseEquation] = []
    for body in reference.system.all_moving:
        start = start_of(body)
        if start.at is not None:
            point, place = start.at
            for axis, expr in zip(axes_of(reference.system), place, strict=True):
                measure = Displacement(body.point(point), Point(GROUND), axis)
                equations.append(
                    PoseEquation.of(f"the given place of {body.name}", measure, Jet(reference.number(expr)))
                )
        if start.angle is not None and body.turns:
            angle = Jet(reference.number(start.angle))
            equations.append(PoseEquation.of(f"angle of {body.name}", Angle(body.name), angle))
        if start.turned is not None and body.turns:
            equations += _attitude(body.name, spatial.turned_by(start.turned, {}, reference.number))
    return equations


def _attitude(body: str, R: Array) -> list[PoseEquation]:
    """The axes A of a body are those of R. With R^T A a turn by phi about n, its axial vector sin(phi) n divided by
    1 + cos(phi), half of its trace and one, is tan(phi/2) n: twice that vanishes for phi = 0 alone, and not half a turn
    away as the axial vector itself does."""

    def along(g: JetGeometry, i: int, j: int) -> Jet:
        """Of R^T A the entry in row j and column i."""
        pose = g.pose(body)
        assert isinstance(pose, SpatialPose)
        axis, (x, y, z) = pose.axes[i], R[:, j]
        assert axis.z is not None
        return axis.x * x + axis.y * y + axis.z * z

    def gap(g: JetGeometry, i: int, j: int) -> Jet:
        cosine = along(g, 0, 0) + along(g, 1, 1) + along(g, 2, 2) + 1.0
        if cosine.value <= ROUND_OFF:
            raise CannotAnswer(Message("a measure has no value"))
        return 2.0 * (along(g, i, j) - along(g, j, i)) / cosine

    return [
        PoseEquation(f"turned of {body}", "rad", lambda g, i=i, j=j: gap(g, i, j), frozenset({body}))
        for i, j in ((0, 1), (1, 2), (2, 0))
    ]
