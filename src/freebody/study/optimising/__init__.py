"""The best values of parameters: goals, limits, and how sure the best one is."""
