"""Checks of the exercises of Chapter 5, Control points."""
