"""Mode shapes in closed form."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.expression import Symbol
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.jets import Array
from freebody.numeric.linearised import basis_of_shapes, generalized_modes
from freebody.numeric.small_motion import SmallMotion
from freebody.questions.amplitude_ratio import AmplitudeRatio
from freebody.questions.reading import Question
from freebody.questions.small_motion import ModeShapes
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.small_motion.resting import TOLERANCE, AtRest, beside, compared, oscillates
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import FreeOscillations, Mode, free_oscillations

NOT_UNIQUE = Message(
    "several modes have one frequency: any combination of them is a mode too; those shown share no inertia (v·M w = 0)"
)


def mode_shapes(setup: Setup, question: Question, q: ModeShapes, at_rest: AtRest) -> Finding:
    free = free_oscillations(setup.model, setup.start, setup.rest_of_small_motion)
    modes = free.modes
    if q.number is not None and q.number > len(modes):
        raise CannotAnswer(Message("there are {n} modes only", n=len(modes)))
    wanted = range(len(modes)) if q.number is None else [q.number - 1]
    swinging = [mode for mode in modes if not mode.square.is_zero()]
    conditions = [*at_rest(free.rest, ">"), *oscillates(free, swinging)]
    coordinates = setup.model.coordinates
    parts: list[Ratio] = []
    notes = list(free.notes)
    if q.is_ratio:
        assert isinstance(q, AmplitudeRatio)
        x = _ratio(setup, q, free)
        own = RatioReader(setup, wanted, free, q)
        return Finding(x, compared(setup, question, [x], free.equilibrium, conditions, beside(own)), conditions, notes)
    for k in wanted:
        shape = free.parts(k)
        parts += shape
        notes.append(_mode_told(k, free, modes[k], len(parts) - len(shape)))
    if any(modes[k].factor.times > 1 for k in wanted):
        notes.append(NOT_UNIQUE)
    evidence = compared(setup, question, parts, free.equilibrium, conditions, beside(ModeReader(setup, wanted, free)))
    if len({str(m.dimension) for c in coordinates if (m := setup.model.measure_of(c)) is not None}) > 1:
        notes.append(Message("components of unlike coordinates are in SI units, angles in rad"))
    return Finding(tuple(parts), evidence, conditions, notes, may_be_complex=free.are_real_by_symmetry)


def _ratio(setup: Setup, q: AmplitudeRatio, free: FreeOscillations) -> Ratio:
    """That of the amplitudes of two measures. Raises CannotAnswer where the second does not move."""
    measures = [(name, setup.system.measures[name]) for name in (q.top, q.bottom)]
    top, bottom = amplitudes(setup, free, free.modes[q.number - 1], measures)
    if bottom.is_zero():
        raise CannotAnswer(Message("{name} does not swing in mode {k}", name=q.bottom, k=q.number))
    return setup.model.field.lowest_terms(top / bottom)


def amplitudes(
    setup: Setup, free: FreeOscillations, mode: Mode, measures: Sequence[tuple[str, Measure]]
) -> list[Ratio]:
    """dm.v at the equilibrium, of measures and the parts v of a mode. measures: with what they are called. Raises
    CannotAnswer where one depends on more than the coordinates."""
    model, f = setup.model, setup.model.field
    shape = [mode.residues.at(x, mode.square) for x in free.shape(mode)]
    found: list[Ratio] = []
    for name, measure in measures:
        value, total = model.value_of(measure), f.zero
        if f.ingredients(value) & {c.index for c in model.dependent}:
            raise CannotAnswer(Message("{name} follows from a loop; ask for the mode shape", name=name))
        for c, part in zip(model.coordinates, shape, strict=True):
            total = total + f.follow(f.derivative(value, c.index), free.equilibrium) * part
        found.append(f.lowest_terms(total))
    return found


def _mode_told(k: int, free: FreeOscillations, mode: Mode, before: int) -> str:
    """Which components are those of a mode."""
    names = ", ".join(to_text(Symbol(c.name)) for c in free.model.coordinates)
    n = len(free.model.coordinates)
    places = f"[{before + 1}]" if n == 1 else f"[{before + 1}]-[{before + n}]"
    told = Message("mode {k}: {places} are the parts of {names}", k=k + 1, places=places, names=names)
    if mode.square.is_zero():
        told = Message(
            "mode {k}: {places} are the parts of {names}; nothing drives it back", k=k + 1, places=places, names=names
        )
    return told


class ModeReader:
    """Components of modes from the numeric linearisation, the first that moves being 1."""

    def __init__(self, setup: Setup, wanted: Sequence[int], free: FreeOscillations | None = None) -> None:
        """free: the formulas, which say of which modes the frequencies are equal; without it none are."""
        self.setup, self.wanted, self.free = setup, wanted, free

    def __call__(self, small: SmallMotion) -> Sequence[float]:
        measures = [self.setup.model.measure_of(c) for c in self.setup.model.coordinates]
        if any(m is None for m in measures):
            raise CannotAnswer(Message("a coordinate is no measure of the model, so the mode cannot be checked"))
        g = small.at.geometry(small.reference, small.at.q, small.at.v)
        squares, shapes = undamped_modes(small)
        rows = np.array([small.reference.jet(g, m).row(len(small.at.q)) for m in measures if m is not None])
        found: list[float] = []
        for k in self.wanted:
            alike = self._alike(k)
            if any(abs(squares[k] - x) <= TOLERANCE * max(squares) for j, x in enumerate(squares) if j not in alike):
                raise SaysNothing(Message("two modes have nearly one frequency"))
            moves = np.array([shapes[j] for j in alike])
            parts = basis_of_shapes(rows @ moves.T, moves @ (small.reference.masses[:, None] * moves.T))
            found += parts[:, alike.index(k)].tolist()
        return found

    def _alike(self, k: int) -> list[int]:
        """The modes with the frequency of the k-th one."""
        squares = self.free.squares if self.free else ()
        return [j for j, x in enumerate(squares) if x == squares[k]] if k < len(squares) else [k]


class RatioReader(ModeReader):
    """The ratio of the amplitudes of two measures in a mode."""

    def __init__(self, setup: Setup, wanted: Sequence[int], free: FreeOscillations | None, q: AmplitudeRatio) -> None:
        super().__init__(setup, wanted, free)
        self.sides = [setup.system.measures[name] for name in (q.top, q.bottom)]

    def __call__(self, small: SmallMotion) -> Sequence[float]:
        super().__call__(small)  # whether the mode stands alone
        g = small.at.geometry(small.reference, small.at.q, small.at.v)
        shape = undamped_modes(small)[1][self.wanted[0]]
        top, bottom = (float(small.reference.jet(g, m).row(len(small.at.q)) @ shape) for m in self.sides)
        return [top / bottom]


def undamped_modes(small: SmallMotion) -> tuple[list[float], list[Array]]:
    """Squared frequencies, ascending, and motions of the absolute coordinates; what has no mass follows the springs."""
    squares, vectors = generalized_modes(small.M, small.K)
    return squares.tolist(), [small.unit_speeds @ v for v in vectors.T]
