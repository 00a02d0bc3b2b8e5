"""Reports: what a derivation says, as blocks that every format can write.

blocks     paragraphs, numbered equations, figures, steps that can be revealed
"""
