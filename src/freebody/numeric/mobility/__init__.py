"""Mobility: what the connections hold more than once, and what moves."""
