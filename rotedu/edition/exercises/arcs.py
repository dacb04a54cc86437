"""Checks of the exercises of Chapter 5, Arcs."""
