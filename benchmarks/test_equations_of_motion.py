"""Equations of motion of n pendulums on a cart: freebody beside SymPy's KanesMethod, in one run.

    python -m pytest -n 0 benchmarks --benchmark-columns=median,min,max,rounds    # pip install ".[test,benchmark]"

Both derive mass matrix and forcing from scratch; freebody's are in the form that it prints. The number of operations
is recorded with each (`extra_info`). SymPy's result is not simplified (that takes 24 s at n = 6).
"""

from __future__ import annotations

from typing import Any

import pytest
from models import pendulums_on_a_cart

from freebody.language.expression import n_operations
from freebody.study.eom import Equations, equations_of_motion
from freebody.system.system import System

SIZES = range(1, 7)


def derive(n: int) -> Equations:
    return equations_of_motion(System.from_data(pendulums_on_a_cart(n)))


def count(equations: Equations) -> int:
    return sum(map(n_operations, (*(e for row in equations.mass_matrix for e in row), *equations.forcing)))


@pytest.mark.parametrize("n", SIZES)
def test_freebody(benchmark: Any, n: int) -> None:
    equations = benchmark.pedantic(derive, args=(n,), rounds=3, warmup_rounds=1)
    benchmark.extra_info["operations"] = count(equations)
    assert len(equations.coordinates) == n + 1
    if n == 6:
        assert count(equations) <= 1000


@pytest.mark.parametrize("n", SIZES)
def test_sympy_kane(benchmark: Any, n: int) -> None:
    sympy = pytest.importorskip("sympy")
    mechanics = pytest.importorskip("sympy.physics.mechanics")

    def kane() -> Any:
        q = mechanics.dynamicsymbols(f"q:{n + 1}")
        u = mechanics.dynamicsymbols(f"u:{n + 1}")
        m, length = sympy.symbols(f"m:{n + 1}"), sympy.symbols(f"l:{n}")
        g, t = sympy.symbols("g t")
        frame = mechanics.ReferenceFrame("I")
        origin = mechanics.Point("O")
        origin.set_vel(frame, 0)
        above = mechanics.Point("P0")
        above.set_pos(origin, q[0] * frame.x)
        above.set_vel(frame, u[0] * frame.x)
        particles = [mechanics.Particle("Pa0", above, m[0])]
        forces = [(above, -m[0] * g * frame.y)]
        rates = [q[0].diff(t) - u[0]]
        for k in range(n):
            turned = frame.orientnew(f"B{k}", "Axis", [q[k + 1], frame.z])
            turned.set_ang_vel(frame, u[k + 1] * frame.z)
            bob = above.locatenew(f"P{k + 1}", length[k] * turned.x)
            bob.v2pt_theory(above, frame, turned)
            particles.append(mechanics.Particle(f"Pa{k + 1}", bob, m[k + 1]))
            forces.append((bob, -m[k + 1] * g * frame.y))
            rates.append(q[k + 1].diff(t) - u[k + 1])
            above = bob
        method = mechanics.KanesMethod(frame, q_ind=q, u_ind=u, kd_eqs=rates)
        method.kanes_equations(particles, forces)
        return method

    method = benchmark.pedantic(kane, rounds=1)
    benchmark.extra_info["operations"] = int(sympy.count_ops(method.mass_matrix) + sympy.count_ops(method.forcing))
