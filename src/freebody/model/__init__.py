"""What a description means: names, bodies, held and pushed measures, questions."""
