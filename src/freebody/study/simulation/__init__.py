"""Motions in time: assembled, followed by the engine, and what is measured along them."""
