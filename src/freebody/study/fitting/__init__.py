"""Numbers of a model from measured motions."""
