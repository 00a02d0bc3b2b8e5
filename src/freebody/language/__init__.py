"""The language of model files: expressions, their notation, units, and the YAML border."""
