"""The mathematics of a report in each format: derivatives, differences, columns, relations and units.

statement  what all formats share: how a formula is put together
rows       long formulas over several rows
mathml, latex, typst, stacked, line   the formats
"""
