"""Shapes of bodies, imported when a model names one of their kinds (`model.kinds`)."""
