"""Words: the catalogue of a language, and derivations told as reports."""
