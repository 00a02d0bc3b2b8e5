"""Reports: what a derivation says, as blocks that every format can write.

blocks     paragraphs, numbered equations, figures, steps that can be revealed
words      what the writers say themselves
formulas   mathematics in each format
html       a page that needs nothing else (report.css, report.js), and a fragment for notebooks
markdown, notebook, latex, typst, terminal   the other formats (report.typ: the look of the PDF)
latex_text words in LaTeX
write      into a file, by its suffix
"""
