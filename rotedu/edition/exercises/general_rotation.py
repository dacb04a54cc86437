"""Checks of the exercises of Chapter 4."""
