"""How much an answer hangs on what goes into it: exact derivatives, and shares of its variance."""
