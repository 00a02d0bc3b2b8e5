"""Reports: what a derivation or a result says, as blocks that every format can write.

blocks     paragraphs, numbered equations, tables, figures, steps that can be revealed
words      what the writers say themselves
formulas   mathematics in each format
writer     what all writers share, and by what a format is found
formats    a file each: HTML (report.css, report.js), Markdown, notebook, LaTeX, typst for PDF (report.typ), terminal
latex_text words in LaTeX
write      into a file, by its suffix
"""
