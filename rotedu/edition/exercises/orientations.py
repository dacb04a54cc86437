"""Checks of the exercises of Chapter 5, Points and orientations."""
