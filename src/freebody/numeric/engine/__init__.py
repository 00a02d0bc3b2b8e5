"""The compiled engine: a model is data, kernels are compiled once, constraints hold to round-off."""
