"""The sections of a document, a file for each."""
