"""The spin of a body about one of its axes, without moments about the mass centre.

With omega = (w_i, w_j, Omega) and a principal axis k, Euler's equations I omega' + omega x I omega = 0 linearised are

    I_ii w_i' + I_ij w_j' + Omega ((I_kk - I_jj) w_j - I_ij w_i) = 0
    I_ij w_i' + I_jj w_j' + Omega ((I_ii - I_kk) w_i + I_ij w_j) = 0

so that lambda^2 = -Omega^2 ((I_kk - I_ii)(I_kk - I_jj) - I_ij^2)/(I_ii I_jj - I_ij^2): stable about the axes of the
largest and of the smallest moment. Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 5.6.
"""

from __future__ import annotations

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.measures.geometry import Direction
from freebody.model.elements import NonholonomicForm
from freebody.model.spins import body_axes, spin
from freebody.numeric.jets import Array
from freebody.questions.reading import Question
from freebody.questions.steady import SpinStability
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import CrossCheck
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.steady.verdict import stable_if
from freebody.symbolic.linear import determinant
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

_TOLERANCE = 1e-7  # relative, of slopes by finite differences
_SPINS = (2.3, 7.1)  # rad/s
_NAMES = ("Omega", "omega", "Omega_spin", "omega_spin")
_AXES = "xyz"
# where the tensor (xx, yy, zz, xy, xz, yz) keeps the product of two axes
_PRODUCTS: dict[frozenset[int], int] = {frozenset((0, 1)): 3, frozenset((0, 2)): 4, frozenset((1, 2)): 5}


def spin_stability(setup: Setup, question: Question, q: SpinStability) -> Finding:
    """The square of the exponent of a small disturbance, negative where the spin is stable."""
    model = setup.model
    _check_moments(model, q.body)
    k = _AXES.index(q.axis)
    name = next(n for n in _NAMES if n not in model.parameters and n not in model.system.measures)
    rate = model.field.parameter(name)
    square = _exponent_squared(model, q.body, k, rate)
    evidence = _evidence(setup, question, q.body, k, model.field.index(rate), square)
    notes: list[str] = [
        Message(
            "the square of the exponent λ of a disturbance e^(λ t), the spin {rate} being about {axis}; negative where "
            "it is stable, then -λ² is the squared frequency of the wobble",
            rate=to_text(tidy(rate)),
            axis=f"{q.body}.{q.axis}",
        )
    ]
    return Finding(square, evidence, notes=notes, says=[stable_if([-square])])


def _check_moments(model: SymbolicModel, body: str) -> None:
    """Nothing may turn the body about its mass centre."""
    turning = model.bodies.slots[model.bodies.n_places :]
    if any(not x.is_zero() for x in model.loads.wrenches[body][model.bodies.n_places :]):
        raise CannotAnswer(
            Message(
                "loads have a moment about the mass centre of {body}; ask for stability of steady motion", body=body
            )
        )
    for row in model.system.constraint_rows:
        if any(owner == body and slot in turning for owner, slot in model.gradient(row.measure)):
            raise CannotAnswer(
                Message(
                    "{connection} turns {body} about its mass centre: its spin is not free. Hold it at the mass "
                    "centre by a spherical joint, or ask for stability of steady motion",
                    connection=row.connection,
                    body=body,
                )
            )


def _exponent_squared(model: SymbolicModel, body: str, k: int, rate: Ratio) -> Ratio:
    f, tensor = model.field, model.dynamics.inertias[body][3:]
    i, j = (k + 1) % 3, (k + 2) % 3
    if any(not tensor[_PRODUCTS[frozenset((k, other))]].is_zero() for other in (i, j)):
        raise CannotAnswer(
            Message(
                "{body}.{axes} is no principal axis: {body} does not spin about it steadily", body=body, axes=_AXES[k]
            )
        )
    a, b, c, product = tensor[i], tensor[j], tensor[k], tensor[_PRODUCTS[frozenset((i, j))]]
    inertia = [[a, product], [product, b]]
    turning = [[-product, c - b], [a - c, product]]
    whole = determinant(inertia)
    if whole.is_zero():
        raise CannotAnswer(Message("{body} has no inertia about axes across {axes}", body=body, axes=_AXES[k]))
    return f.lowest_terms(-rate * rate * determinant(turning) / whole)


def _evidence(setup: Setup, question: Question, body: str, k: int, rate: int, square: Ratio) -> Evidence:
    """The slopes of the angular accelerations of the full system, by finite differences."""
    witness = CrossCheck(
        question.text, Message("finite differences of the angular accelerations of the full system"), _TOLERANCE
    )
    for draw in setup.draws:
        for value in _SPINS:
            slopes = slopes_beside(draw, body, k, value)
            numbers = setup.model.samples.numbers(draw.sample()) | {rate: value}
            scale = value * value
            exact = setup.model.field.evaluate(square, numbers) / scale
            witness.compare(draw, (exact, 0.0), (-np.linalg.det(slopes) / scale, np.trace(slopes) / value))
    return witness.evidence()


def slopes_beside(draw: Draw, body: str, k: int, value: float) -> Array:
    """d(w_i', w_j')/d(w_i, w_j) about the spin; the equations are quadratic, so that central differences are exact."""
    axes: tuple[Direction, ...] = body_axes(body)
    spins: list[NonholonomicForm] = [spin(body, axis) for axis in axes]
    across = [(k + 1) % 3, (k + 2) % 3]
    step = 0.1 * value

    def accelerations(of: int, away: float) -> Array:
        rates = np.zeros(3)
        rates[k], rates[of] = value, away
        wanted = [(m, float(w)) for m, w in zip(spins, rates, strict=True)]
        seen = draw.seen(draw.reference.snapshot(draw.q, draw.reference.velocities(draw.q, wanted, with_start=False)))
        return np.array([seen.acceleration(spins[n]) for n in across])

    columns = [(accelerations(n, step) - accelerations(n, -step)) / (2 * step) for n in across]
    return np.array(columns).T
