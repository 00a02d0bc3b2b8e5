"""What the page and the server say to each other. `tools/write_studio_types.py` writes the same for the page.

Places in a text count as a browser does: UTF-16 units from 0.
"""
