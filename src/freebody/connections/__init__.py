"""Connections: one file each, imported when a model names its kind (`model.kinds`)."""
