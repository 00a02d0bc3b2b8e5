"""Derivations by what is asked: instants, states, events, freedoms, conservation, small motions."""
