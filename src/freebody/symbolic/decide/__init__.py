"""What holds for all admissible values of the parameters, and of everything else that may vary.

decide     whether an element is positive, not negative or not zero wherever some premises are true
possible   whether conditions can hold together at all
Trials     points at which counterexamples are looked for first
"""

from __future__ import annotations

from freebody.symbolic.decide.deciding import Premise, decide, implied, possible, sign_given
from freebody.symbolic.decide.trials import Trials

__all__ = ["Premise", "Trials", "decide", "implied", "possible", "sign_given"]
