"""Exact derivatives of motions by parameters and start values: tangents of the equations of motion."""
