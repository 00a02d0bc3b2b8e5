"""What is conserved, by which principle, and for which motions."""
