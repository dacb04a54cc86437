"""What this edition says about the paper, and what its notebooks need to say it."""
