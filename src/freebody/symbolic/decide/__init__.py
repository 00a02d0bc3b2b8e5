"""What holds for all admissible values of the parameters, and of everything else that may vary.

decide     whether an element is positive, not negative or not zero wherever some premises are true
possible   whether conditions can hold together at all
"""

from __future__ import annotations

from freebody.symbolic.decide.deciding import Premise, decide, implied, possible, sign_given

__all__ = ["Premise", "decide", "implied", "possible", "sign_given"]
