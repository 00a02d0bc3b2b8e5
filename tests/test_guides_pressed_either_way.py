"""A rough guide that holds both ways is pressed on one side or the other: at the limit of rest these are two cases."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

import freebody as fb

# a wedge below a block that an upright guide holds, the same friction on all faces
WEDGES = """
parameters: {{alpha: {alpha}, mu: 0.15, Q: 5 kN, F: 200 N}}
bodies: {{wedge: {{particle: {{}}, lines: {{top: {{along: alpha}}}}}}, block: {{particle: {{}}}}}}
connections:
  base: {{slider: {{body: wedge, along: right, friction: mu}}}}
  guide: {{slider: {{body: block, along: up, friction: mu}}}}
  face: {{slider: {{body: block, along: wedge.top, friction: mu}}}}
loads:
  load: {{force: {{at: block, along: down, magnitude: Q}}}}
  push: {{force: {{at: wedge, along: right, magnitude: F}}}}
"""


def test_wedges_are_drawn_out_at_the_force_of_the_textbook(agrees: Callable[..., None]) -> None:
    """F = Q tan(2 rho - alpha), rho = atan(mu), where rho > alpha."""
    found = fb.System.from_text(WEDGES.format(alpha="8 deg")).solve("largest F so that it stays at rest")
    agrees(found, "q1", "Q*tan(2*atan(mu) - alpha)")


def test_a_steeper_wedge_presses_its_block_against_the_other_side_of_the_guide() -> None:
    """Nb = Q + mu |Ng| with |Ng| = Nb tan(alpha - rho), and F = mu Nb - Nb tan(alpha - rho)."""
    found = fb.System.from_text(WEDGES.format(alpha="12 deg")).solve("largest F so that it stays at rest")
    lean = math.tan(math.radians(12) - math.atan(0.15))
    below = 5000 / (1 - 0.15 * lean)
    assert found.answers[0].value == pytest.approx(below * (0.15 - lean), rel=1e-9)
