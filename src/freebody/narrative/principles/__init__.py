"""Principles: the table of momenta and moments, the planner, and the algebra of their solution."""
