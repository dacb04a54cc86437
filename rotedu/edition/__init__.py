"""What this edition says about the paper, and helpers for its notebooks."""
