"""A file as people write it first, put into the form in which it is read: a file for each thing that is put so."""
