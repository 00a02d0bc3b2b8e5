"""Many copies of one small system, stepped together.

A model is written as straight-line code of its own (`copies`, `source`), compiled by numba for processors or for
graphics cards (`devices`), and each copy is followed by itself, with steps of its own.
"""
