"""Linkages to given positions, paths and functions: Burmester's theory, and what becomes of each candidate."""
