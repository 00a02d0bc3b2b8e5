"""The classical method of order 4, with a fixed step. Source: Hairer, Norsett & Wanner, Solving Ordinary Differential
Equations I, 2nd ed. 1993, sec. II.1."""

from __future__ import annotations

from freebody.numeric.engine.integrators.base import Integrator
from freebody.numeric.engine.tableaus import tableau

INTEGRATOR = Integrator(tableau(4, [{0: 0.5}, {1: 0.5}, {2: 1.0}], {0: 1 / 6, 1: 1 / 3, 2: 1 / 3, 3: 1 / 6}))
